/* test_trace.c -- nets of random surfaces: what does not depend on how the surface is told.
 *
 * Asymptotic families stay when u and v change places or run backwards; degrees may be raised; the
 * turning of a cell of the net is the curvature within it (Gauss-Bonnet). Laths are cut alike.
 */
#include "check.h"
#include "core/constants.h"
#include "nets.h"

#include <stdlib.h>
#include <string.h>

enum { TRIALS = 12, SIDE = 4 };

/* A net of SIDE x SIDE points over [-1, 1]^2 with K < 0: z = x y and something small. */
static void random_points(double points[SIDE][SIDE][3])
{
    const double height = random_in(0.8, 1.5);
    for (int i = 0; i < SIDE; i++) {
        for (int j = 0; j < SIDE; j++) {
            const double x = -1 + 2.0 * i / (SIDE - 1), y = -1 + 2.0 * j / (SIDE - 1);
            points[i][j][0] = x + random_in(-0.05, 0.05);
            points[i][j][1] = y + random_in(-0.05, 0.05);
            points[i][j][2] = height * x * y + random_in(-0.05, 0.05);
        }
    }
}

/* The surface as JSON; `way`: 0 as it is, 1 with u and v exchanged, 2 with u backwards, 3 mirrored in
 * z. */
static void write_surface(const double points[SIDE][SIDE][3], int way, char *text, size_t room)
{
    size_t length = (size_t)snprintf(
        text, room,
        "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 3 }, "
        "\"v\": { \"type\": \"bezier\", \"degree\": 3 }, \"points\": [");
    for (int i = 0; i < SIDE; i++) {
        length += (size_t)snprintf(text + length, room - length, "%s[", i > 0 ? ", " : "");
        for (int j = 0; j < SIDE; j++) {
            const double *p = way == 1   ? points[j][i]
                              : way == 2 ? points[SIDE - 1 - i][j]
                                         : points[i][j];
            length += (size_t)snprintf(text + length, room - length, "%s[%.17g, %.17g, %.17g]",
                                       j > 0 ? ", " : "", p[0], p[1], way == 3 ? -p[2] : p[2]);
        }
        length += (size_t)snprintf(text + length, room - length, "]");
    }
    snprintf(text + length, room - length, "] }] }");
}

static made_net laths_at(const double points[SIDE][SIDE][3], int way, const char *kind, double u,
                         double v, const char *laths)
{
    char surface[4096], members[400];
    write_surface(points, way, surface, sizeof surface);
    snprintf(members, sizeof members, "\"seeds\": [{ \"at\": [%.17g, %.17g] }]%s", u, v, laths);
    return net_make(kind, surface, members);
}

static made_net net_at(const double points[SIDE][SIDE][3], int way, const char *kind, double u,
                       double v)
{
    return laths_at(points, way, kind, u, v, "");
}

static void test_told_otherwise(void)
{
    for (int trial = 0; trial < random_trials(TRIALS); trial++) {
        double points[SIDE][SIDE][3];
        random_points(points);
        /* a dyadic place: 1 - u is exact */
        const double u = random_int(13, 51) / 64.0, v = random_int(13, 51) / 64.0;
        made_net plain = net_at((const double(*)[SIDE][3])points, 0, "asymptotic", u, v);
        made_net turned = net_at((const double(*)[SIDE][3])points, 1, "asymptotic", v, u);
        made_net backwards = net_at((const double(*)[SIDE][3])points, 2, "asymptotic", 1 - u, v);
        made_net mirrored = net_at((const double(*)[SIDE][3])points, 3, "asymptotic", u, v);
        CHECK(plain.status == TAUT_OK, "trial %d: %s", trial, plain.error.message);
        CHECK(taut_certificate_holds(plain.proof) == TAUT_TRUE, "trial %d", trial);
        for (int f = 0; f < 2 && plain.status == TAUT_OK; f++) {
            const char *name = f == 0 ? "A1" : "B1", *other = f == 0 ? "B1" : "A1";
            const double length = net_number(&plain, name, "length");
            /* 2e-12 was seen */
            CHECK_NEAR(net_number(&turned, name, "length"), length, 5e-12, "trial %d turned",
                       trial);
            CHECK_NEAR(net_number(&backwards, name, "length"), length, 5e-12, "trial %d", trial);
            CHECK_NEAR(net_number(&mirrored, other, "length"), length, 5e-12, "trial %d", trial);
            CHECK_NEAR(net_number(&turned, name, "twist"), net_number(&plain, name, "twist"), 2e-11,
                       "trial %d", trial);
        }
        net_free(&plain);
        net_free(&turned);
        net_free(&backwards);
        net_free(&mirrored);
    }
}

/* One direction of a net told otherwise. */
typedef struct telling {
    const char *basis;
    int count;
    double rows[2 * SIDE - 1][SIDE]; /* the new points by the old ones */
} telling;

/* The rows of degree SIDE - 1 + times. */
static void raise_rows(telling *t, int times)
{
    t->count = SIDE;
    memset(t->rows, 0, sizeof t->rows);
    for (int i = 0; i < SIDE; i++) {
        t->rows[i][i] = 1;
    }
    for (; t->count < SIDE + times; t->count++) {
        const int n = t->count;
        for (int a = 0; a < SIDE; a++) {
            for (int i = n; i >= 0; i--) {
                const double share = (double)i / n;
                t->rows[i][a] = (i > 0 ? share * t->rows[i - 1][a] : 0) +
                                (i < n ? (1 - share) * t->rows[i][a] : 0);
            }
        }
    }
}

/* The rows of both halves, the middle point once. */
static void halve_rows(telling *t)
{
    double work[SIDE][SIDE] = {{0}};
    t->count = 2 * SIDE - 1;
    for (int i = 0; i < SIDE; i++) {
        work[i][i] = 1;
    }
    for (int level = 0; level < SIDE; level++) {
        memcpy(t->rows[level], work[0], sizeof work[0]);
        memcpy(t->rows[2 * SIDE - 2 - level], work[SIDE - 1 - level], sizeof work[0]);
        for (int i = 0; i < SIDE - 1 - level; i++) {
            for (int a = 0; a < SIDE; a++) {
                work[i][a] = (work[i][a] + work[i + 1][a]) / 2;
            }
        }
    }
}

static void write_told(const double points[SIDE][SIDE][3], const telling *u, const telling *v,
                       char *text, size_t room)
{
    size_t length = (size_t)snprintf(
        text, room, "{ \"taut\": 1, \"surfaces\": [{ \"u\": %s, \"v\": %s, \"points\": [", u->basis,
        v->basis);
    for (int i = 0; i < u->count; i++) {
        for (int j = 0; j < v->count; j++) {
            double p[3] = {0, 0, 0};
            for (int a = 0; a < SIDE; a++) {
                for (int b = 0; b < SIDE; b++) {
                    for (int c = 0; c < 3; c++) {
                        p[c] += u->rows[i][a] * v->rows[j][b] * points[a][b][c];
                    }
                }
            }
            length += (size_t)snprintf(text + length, room - length, "%s[%.17g, %.17g, %.17g]%s",
                                       j > 0   ? ", "
                                       : i > 0 ? ", ["
                                               : "[",
                                       p[0], p[1], p[2], j + 1 < v->count ? "" : "]");
        }
    }
    snprintf(text + length, room - length, "] }] }");
}

/* Degrees may be raised, and cells halved, by knots that are three times there: nothing changes. 6.3e-13 was
 * seen in 12 seeds. */
static void test_raised_and_halved(void)
{
    static const char *const bases[] = {
        "{ \"type\": \"bezier\", \"degree\": 3 }", "{ \"type\": \"bezier\", \"degree\": 4 }",
        "{ \"type\": \"bezier\", \"degree\": 5 }", "{ \"type\": \"bezier\", \"degree\": 6 }",
        "{ \"type\": \"bspline\", \"degree\": 3, \"knots\": [0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, "
        "1] }"};
    enum { TELLINGS = sizeof bases / sizeof bases[0] };
    static const char *const nets[] = {"asymptotic", "principal"};
    telling tellings[TELLINGS];

    for (int k = 0; k < TELLINGS; k++) {
        tellings[k].basis = bases[k];
        if (k < TELLINGS - 1) {
            raise_rows(&tellings[k], k);
        } else {
            halve_rows(&tellings[k]);
        }
    }
    for (int trial = 0; trial < random_trials(TRIALS); trial++) {
        double points[SIDE][SIDE][3];
        char surface[8192], members[100];
        random_points(points);
        snprintf(members, sizeof members, "\"seeds\": [{ \"at\": [%.17g, %.17g] }]",
                 random_int(13, 51) / 64.0, random_int(13, 51) / 64.0);
        for (int net = 0; net < 2; net++) {
            made_net plain = {0};
            for (int k = 0; k <= TELLINGS; k++) { /* the first one as it is */
                const int u = k == 0 ? 0 : random_int(0, TELLINGS - 1), v = k == 0 ? 0 : k - 1;
                write_told((const double(*)[SIDE][3])points, &tellings[u], &tellings[v], surface,
                           sizeof surface);
                made_net made = net_make(nets[net], surface, members);
                CHECK(made.status == TAUT_OK, "trial %d: %s", trial, made.error.message);
                CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "trial %d", trial);
                if (k == 0) {
                    plain = made;
                    continue;
                }
                for (int f = 0; f < 2; f++) {
                    const char *name = f == 0 ? "A1" : "B1";
                    CHECK_NEAR(net_number(&made, name, "length"),
                               net_number(&plain, name, "length"), 5e-12, "trial %d %s: %s, %s",
                               trial, nets[net], bases[u], bases[v]);
                }
                net_free(&made);
            }
            net_free(&plain);
        }
    }
}

/* Principal families change with the normal, and no other way. */
static void test_principal(void)
{
    for (int trial = 0; trial < random_trials(TRIALS / 2); trial++) {
        double points[SIDE][SIDE][3];
        random_points(points);
        const double u = random_int(13, 51) / 64.0, v = random_int(13, 51) / 64.0;
        made_net plain = net_at((const double(*)[SIDE][3])points, 0, "principal", u, v);
        made_net turned = net_at((const double(*)[SIDE][3])points, 1, "principal", v, u);
        CHECK_NEAR(net_number(&turned, "B1", "length"), net_number(&plain, "A1", "length"), 5e-12,
                   "trial %d: %s", trial, plain.error.message);
        CHECK_NEAR(net_number(&turned, "A1", "length"), net_number(&plain, "B1", "length"), 5e-12,
                   "trial %d", trial);
        CHECK(taut_certificate_holds(plain.proof) == TAUT_TRUE, "trial %d", trial);
        net_free(&plain);
        net_free(&turned);
    }
}

static double node_number(const made_net *made, const char *key)
{
    const taut_record *nodes = taut_record_get(taut_model_details(made->model), "nodes");
    return taut_record_number(taut_record_get(taut_record_at(nodes, 0), key));
}

/* The same pieces are cut whatever way the surface is told; the mean lies between axis and edge, and the
 * twist makes slots wider. */
static void test_laths(void)
{
    static const char *const numbers[] = {"cut_length", "edge_length", "least_radius"};
    for (int trial = 0; trial < random_trials(TRIALS); trial++) {
        double points[SIDE][SIDE][3];
        char laths[160];
        random_points(points);
        const double u = random_int(13, 51) / 64.0, v = random_int(13, 51) / 64.0;
        snprintf(laths, sizeof laths,
                 ", \"laths\": { \"strip\": \"standing\", \"width\": %.17g, \"thickness\": 0.001 }",
                 random_in(0.01, 0.2));
        made_net plain = laths_at((const double(*)[SIDE][3])points, 0, "asymptotic", u, v, laths);
        CHECK(plain.status == TAUT_OK, "trial %d: %s", trial, plain.error.message);
        CHECK(node_number(&plain, "slot_twisted") > node_number(&plain, "slot"), "trial %d", trial);
        for (int way = 1; way <= 3; way++) {
            made_net other = laths_at((const double(*)[SIDE][3])points, way, "asymptotic",
                                      way == 1   ? v
                                      : way == 2 ? 1 - u
                                                 : u,
                                      way == 1 ? u : v, laths);
            CHECK_NEAR(node_number(&other, "slot_twisted"), node_number(&plain, "slot_twisted"),
                       1e-12, "trial %d way %d", trial, way);
            for (int f = 0; f < 2; f++) {
                const char *name = f == 0 ? "A1" : "B1";
                const char *same = (way == 3) != (f == 0) ? "A1" : "B1";
                const double cut = net_number(&plain, name, "cut_length");
                CHECK(cut > net_number(&plain, name, "length") &&
                          cut < net_number(&plain, name, "edge_length"),
                      "trial %d", trial);
                for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
                    /* 40 seeds: 5e-13 was not reached, of radii 1.3e-10 was seen, the quintics' curvature */
                    CHECK_NEAR(net_number(&other, same, numbers[k]),
                               net_number(&plain, name, numbers[k]), k < 2 ? 5e-13 : 1e-9,
                               "trial %d way %d %s", trial, way, numbers[k]);
                }
            }
            net_free(&other);
        }
        net_free(&plain);
    }
}

int main(void)
{
    random_seed(1);
    test_laths();
    test_told_otherwise();
    test_principal();
    test_raised_and_halved();
    return check_failures != 0;
}
