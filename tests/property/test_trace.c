/* test_trace.c -- nets of random surfaces: what does not depend on how the surface is told.
 *
 * Asymptotic families stay when u and v change places or run backwards; degrees may be raised and cells halved;
 * the turning of a cell of the net is the curvature within it (Gauss-Bonnet); geodesics of surfaces of revolution
 * keep Clairaut's constant; seeds may come in another order; no two curves of a lattice are one but for a little. Laths
 * are cut alike, and strips bent back from their flat pieces meet at the nodes.
 */
#include "certificates.h"
#include "check.h"
#include "core/constants.h"
#include "core/vec3.h"
#include "nets.h"
#include "numeric/quadrature.h"

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
        ("{ \"type\": \"bspline\", \"degree\": 3, \"knots\": [0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, "
         "1] }")};
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

/* ---- curves of a made net ---- */

/* The window's curve of a name, points (u, v, 0), the caller's; of one stretch. */
static taut_curve *window_of(const made_net *made, const char *name)
{
    const taut_record *domain = taut_record_get(taut_model_details(made->model), "domain");
    taut_curve *curve = NULL;
    for (size_t i = 0; curve == NULL && i < taut_record_count(domain); i++) {
        const taut_record *one = taut_record_at(domain, i);
        const taut_record *list = taut_record_get(taut_record_get(one, "t"), "knots");
        const taut_record *rows = taut_record_get(one, "points");
        const size_t knot_count = taut_record_count(list), count = taut_record_count(rows);
        double *knots = malloc(knot_count * sizeof *knots),
               *points = malloc(3 * count * sizeof *points);
        taut_basis *basis = NULL;
        for (size_t k = 0; k < knot_count; k++) {
            knots[k] = taut_record_number(taut_record_at(list, k));
        }
        for (size_t k = 0; k < 3 * count; k++) {
            points[k] =
                k % 3 == 2 ? 0
                           : taut_record_number(taut_record_at(taut_record_at(rows, k / 3), k % 3));
        }
        const taut_basis_spec spec = {
            .type = "bspline", .degree = 5, .knot_count = (int)knot_count, .knots = knots};
        if (strcmp(taut_record_text(taut_record_get(one, "name")), name) == 0 &&
            taut_basis_new(&spec, (int)count, &basis, NULL) == TAUT_OK) {
            taut_curve_new(name, basis, points, NULL, &curve, NULL);
        }
        taut_basis_free(basis);
        free(knots);
        free(points);
    }
    return curve;
}

static const taut_curve *space_of(const made_net *made, const char *name)
{
    for (int i = 0; i < taut_model_curve_count(made->model); i++) {
        if (strcmp(taut_curve_name(taut_model_curve(made->model, i)), name) == 0) {
            return taut_model_curve(made->model, i);
        }
    }
    return NULL;
}

/* The lengths of a node on its two laths; 0 where there is none. */
static int node_at(const made_net *made, const char *name, double s[2])
{
    const taut_record *nodes = taut_record_get(taut_model_details(made->model), "nodes");
    for (size_t k = 0; k < taut_record_count(nodes); k++) {
        const taut_record *node = taut_record_at(nodes, k);
        if (strcmp(taut_record_text(taut_record_get(node, "node")), name) == 0) {
            for (size_t i = 0; i < 2; i++) {
                s[i] = taut_record_number(taut_record_at(taut_record_get(node, "s"), i));
            }
            return 1;
        }
    }
    return 0;
}

/* ---- Gauss-Bonnet ---- */

/* A side of a cell: a stretch of a curve, from s[0] to s[1]. */
typedef struct side {
    taut_curve *window;
    const taut_curve *space;
    double s[2];
} side;

static void side_at(const side *e, double t, double at[2])
{
    double point[3];
    taut_curve_eval(e->window, e->s[0] + t * (e->s[1] - e->s[0]), 0, point);
    at[0] = point[0];
    at[1] = point[1];
}

/* The place (a, b) of the cell between four sides, by Coons: 0 and 2 run along a, 1 and 3 along b. */
static void cell_at(const side sides[4], double a, double b, double at[2])
{
    double p[4][2], corner[4][2];
    side_at(&sides[0], a, p[0]);
    side_at(&sides[1], b, p[1]);
    side_at(&sides[2], 1 - a, p[2]);
    side_at(&sides[3], 1 - b, p[3]);
    for (int k = 0; k < 4; k++) {
        side_at(&sides[k], 0, corner[k]);
    }
    for (int d = 0; d < 2; d++) {
        at[d] = (1 - b) * p[0][d] + b * p[2][d] + (1 - a) * p[3][d] + a * p[1][d] -
                (1 - a) * (1 - b) * corner[0][d] - a * (1 - b) * corner[1][d] -
                a * b * corner[2][d] - (1 - a) * b * corner[3][d];
    }
}

/* The integral of K dA, negative where the sides run clockwise. */
static double curvature_within(const taut_surface *surface, const side sides[4])
{
    enum { NODES = 40 };
    const double d = 1e-4;
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < NODES * NODES; k++) {
        const double a = (1 + nodes[k / NODES]) / 2, b = (1 + nodes[k % NODES]) / 2;
        double at[2], low[2][2], high[2][2];
        taut_forms f;
        cell_at(sides, a, b, at);
        cell_at(sides, a - d, b, low[0]);
        cell_at(sides, a + d, b, high[0]);
        cell_at(sides, a, b - d, low[1]);
        cell_at(sides, a, b + d, high[1]);
        const double jacobian = ((high[0][0] - low[0][0]) * (high[1][1] - low[1][1]) -
                                 (high[0][1] - low[0][1]) * (high[1][0] - low[1][0])) /
                                (4 * d * d);
        taut_surface_forms_points(surface, 1, &at[0], &at[1], 1, &f);
        sum += weights[k / NODES] * weights[k % NODES] / 4 * f.gaussian * f.w * jacobian;
    }
    return sum;
}

/* Tangent, normal and k_g of a side at t, as it runs. */
static double side_frame(const taut_surface *surface, const side *e, double t, double tangent[3],
                         double normal[3])
{
    const double way = e->s[1] > e->s[0] ? 1 : -1;
    double at[2], c[3][3], sideways[3];
    taut_forms f;
    side_at(e, t, at);
    taut_surface_forms_points(surface, 1, &at[0], &at[1], 1, &f);
    taut_curve_eval(e->space, e->s[0] + t * (e->s[1] - e->s[0]), 2, c[0]);
    for (int i = 0; i < 3; i++) {
        tangent[i] = way * c[1][i];
        normal[i] = f.normal[i];
    }
    taut_cross(normal, tangent, sideways);
    return taut_dot(c[2], sideways);
}

/* int K dA + sum int k_g ds + sum of exterior angles, over 2 pi. */
static double turns_of(const taut_surface *surface, const side sides[4])
{
    enum { NODES = 60 };
    double nodes[NODES], weights[NODES], sum = curvature_within(surface, sides);
    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < 4; k++) {
        double in[3], out[3], normal[3], across[3];
        for (int n = 0; n < NODES; n++) {
            sum += weights[n] / 2 * fabs(sides[k].s[1] - sides[k].s[0]) *
                   side_frame(surface, &sides[k], (1 + nodes[n]) / 2, in, normal);
        }
        side_frame(surface, &sides[k], 1, in, normal);
        side_frame(surface, &sides[(k + 1) % 4], 0, out, normal);
        taut_cross(in, out, across);
        sum += taut_atan2(taut_dot(across, normal), taut_dot(in, out));
    }
    return fabs(sum) / (2 * TAUT_PI); /* clockwise: all of it is negative */
}

/* Four curves through two places bound a cell. 1.5e-9 was seen in 8 seeds, by the quintics' second derivatives. */
static void test_gauss_bonnet(void)
{
    static const char *const nets[] = {"asymptotic", "principal"};
    static const char *const corners[] = {"A1B1", "A1B2", "A2B2", "A2B1"};
    static const char *const names[] = {"A1", "B2", "A2", "B1"};
    int seen = 0;
    for (int trial = 0; trial < random_trials(2 * TRIALS); trial++) {
        double points[SIDE][SIDE][3], s[4][2];
        char surface[4096], members[160];
        int found = 1;
        random_points(points);
        write_surface((const double(*)[SIDE][3])points, 0, surface, sizeof surface);
        snprintf(members, sizeof members,
                 "\"seeds\": [{ \"at\": [%.17g, %.17g] }, { \"at\": [%.17g, %.17g] }]",
                 random_in(0.3, 0.45), random_in(0.3, 0.45), random_in(0.55, 0.7),
                 random_in(0.55, 0.7));
        made_net made = net_make(nets[trial % 2], surface, members);
        for (int k = 0; k < 4; k++) {
            found &= node_at(&made, corners[k], s[k]);
        }
        if (found) {
            side sides[4];
            for (int k = 0; k < 4; k++) { /* A's length comes first in a node */
                const int which = k % 2;
                sides[k] = (side){window_of(&made, names[k]),
                                  space_of(&made, names[k]),
                                  {s[k][which], s[(k + 1) % 4][which]}};
            }
            seen++;
            CHECK_NEAR(turns_of(taut_model_surface(made.model, 0), sides), 1, 1e-8, "trial %d %s",
                       trial, nets[trial % 2]);
            for (int k = 0; k < 4; k++) {
                taut_curve_free(sides[k].window);
            }
        }
        net_free(&made);
    }
    CHECK(seen > 0, "no cell");
}

/* ---- Clairaut ---- */

/* On surfaces of revolution r^2 phi' is constant along geodesics of unit speed. 1.2e-9 was seen. */
static void test_clairaut(void)
{
    for (int trial = 0; trial < random_trials(TRIALS); trial++) {
        char surface[2048], members[160];
        size_t length = (size_t)snprintf(
            surface, sizeof surface,
            "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 2 }, "
            "\"v\": { \"type\": \"bezier\", \"degree\": 3 }, \"points\": [");
        double r[SIDE], z[SIDE];
        for (int j = 0; j < SIDE; j++) {
            r[j] = random_in(0.5, 1.5);
            z[j] = j + random_in(-0.2, 0.2);
        }
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < SIDE; j++) {
                length += (size_t)snprintf(surface + length, sizeof surface - length,
                                           "%s[%.17g, %.17g, %.17g]%s", j > 0 ? ", " : "[",
                                           i < 2 ? r[j] : 0, i > 0 ? r[j] : 0, z[j],
                                           j + 1 < SIDE ? ""
                                           : i < 2      ? "], "
                                                        : "]");
            }
        }
        snprintf(surface + length, sizeof surface - length,
                 "], \"weights\": [[1, 1, 1, 1], [0.7071067811865476, 0.7071067811865476, "
                 "0.7071067811865476, 0.7071067811865476], [1, 1, 1, 1]] }] }");
        snprintf(members, sizeof members,
                 "\"seeds\": [{ \"at\": [%.17g, %.17g], \"direction\": [%.17g, %.17g], \"both\": "
                 "true }]",
                 random_in(0.3, 0.7), random_in(0.3, 0.7), random_in(0.2, 1), random_in(-1, 1));
        made_net made = net_make("geodesic", surface, members);
        CHECK(made.status == TAUT_OK, "trial %d: %s", trial, made.error.message);
        const taut_curve *curve = space_of(&made, "G1");
        double first = 0;
        for (int k = 0; curve != NULL && k <= 100; k++) {
            const taut_basis *t = taut_curve_t(curve);
            const double lo = taut_basis_lo(t), hi = taut_basis_hi(t);
            double c[2][3];
            taut_curve_eval(curve, fmin(lo + (hi - lo) * k / 100, hi), 1, c[0]);
            const double constant = c[0][0] * c[1][1] - c[0][1] * c[1][0];
            first = k == 0 ? constant : first;
            CHECK_NEAR(constant, first, 1e-8, "trial %d at %d", trial, k);
        }
        net_free(&made);
    }
}

/* ---- order ---- */

static int by_number(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The sorted lengths of all laths; how many. */
static int lengths_of(const made_net *made, double lengths[12])
{
    const taut_record *laths = taut_record_get(taut_model_details(made->model), "laths");
    const int count = (int)taut_record_count(laths);
    for (int k = 0; k < count && k < 12; k++) {
        lengths[k] =
            taut_record_number(taut_record_get(taut_record_at(laths, (size_t)k), "length"));
    }
    qsort(lengths, (size_t)count, sizeof *lengths, by_number);
    return count;
}

/* Seeds in another order give the same laths, by other names. */
static void test_order(void)
{
    for (int trial = 0; trial < random_trials(TRIALS); trial++) {
        double points[SIDE][SIDE][3], lengths[2][12];
        char surface[4096], seeds[3][80], members[2][300];
        random_points(points);
        write_surface((const double(*)[SIDE][3])points, 0, surface, sizeof surface);
        for (int k = 0; k < 3; k++) {
            snprintf(seeds[k], sizeof seeds[k], "{ \"at\": [%.17g, %.17g] }", random_in(0.1, 0.9),
                     random_in(0.1, 0.9));
        }
        snprintf(members[0], sizeof members[0], "\"seeds\": [%s, %s, %s]", seeds[0], seeds[1],
                 seeds[2]);
        snprintf(members[1], sizeof members[1], "\"seeds\": [%s, %s, %s]", seeds[2], seeds[0],
                 seeds[1]);
        int counts[2];
        for (int k = 0; k < 2; k++) {
            made_net made = net_make("asymptotic", surface, members[k]);
            CHECK(made.status == TAUT_OK, "trial %d: %s", trial, made.error.message);
            counts[k] = lengths_of(&made, lengths[k]);
            net_free(&made);
        }
        CHECK(counts[0] == 6 && counts[1] == 6, "trial %d: %d, %d", trial, counts[0], counts[1]);
        for (int k = 0; k < counts[0] && counts[0] == counts[1]; k++) {
            CHECK_NEAR(lengths[0][k], lengths[1][k], 4e-15, "trial %d: %d", trial, k);
        }
    }
}

/* ---- a model of paper ---- */

/* How long the strip is up to s, in the mean over its width: what lies between two places of the flat piece. */
static double mean_length(const taut_surface *strip, double s)
{
    enum { NODES = 12 };
    const taut_basis *t = taut_surface_u(strip);
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < taut_basis_span_count(t); k++) {
        const double a = taut_basis_breaks(t)[k], b = fmin(taut_basis_breaks(t)[k + 1], s);
        for (int n = 0; a < s && n < NODES * NODES; n++) {
            double x[3][3];
            taut_surface_eval(strip, (a + b) / 2 + (b - a) / 2 * nodes[n / NODES],
                              (1 + nodes[n % NODES]) / 2, 1, x[0]);
            sum += weights[n / NODES] * weights[n % NODES] * (b - a) / 4 * taut_length(x[1]);
        }
    }
    return sum;
}

/* s of the strip where the flat piece is `at` long. */
static double fold_back(const taut_surface *strip, double at)
{
    double low = taut_basis_lo(taut_surface_u(strip)), high = taut_basis_hi(taut_surface_u(strip));
    for (int round = 0; round < 50; round++) {
        const double middle = (low + high) / 2;
        *(mean_length(strip, middle) < at ? &low : &high) = middle;
    }
    return high;
}

static const taut_record *slot_of(const made_net *made, const char *lath)
{
    return taut_record_at(taut_record_get(net_lath(made, lath), "slots"), 0);
}

/* Strips bent back into space meet where the flat pieces have their slots: all along the slots' common line.
 * 4e-11 was seen. */
static void test_folded(void)
{
    for (int trial = 0; trial < random_trials(TRIALS / 2); trial++) {
        double points[SIDE][SIDE][3];
        char laths[160];
        taut_model *strips = NULL;
        taut_error error = {.status = TAUT_OK};
        random_points(points);
        snprintf(laths, sizeof laths,
                 ", \"laths\": { \"strip\": \"standing\", \"width\": %.17g, \"thickness\": 0.001 }",
                 random_in(0.02, 0.2));
        made_net made = laths_at((const double(*)[SIDE][3])points, 0, "asymptotic",
                                 random_in(0.2, 0.8), random_in(0.2, 0.8), laths);
        CHECK(made.status == TAUT_OK &&
                  taut_trace_strips(made.model, 0, &strips, &error) == TAUT_OK,
              "trial %d: %s %s", trial, made.error.message, error.message);
        double s[2] = {0, 0};
        for (int k = 0; k < 2 && strips != NULL; k++) {
            s[k] = fold_back(
                taut_model_surface(strips, k),
                taut_record_number(taut_record_get(slot_of(&made, k == 0 ? "A1" : "B1"), "at")));
        }
        for (int h = 0; h <= 8 && strips != NULL; h++) {
            double x[2][3];
            for (int k = 0; k < 2; k++) {
                taut_surface_eval(taut_model_surface(strips, k), s[k], h / 8.0, 0, x[k]);
            }
            CHECK(taut_length_between(x[0], x[1]) < 1e-9, "trial %d at %d: %g apart", trial, h,
                  taut_length_between(x[0], x[1]));
        }
        taut_model_free(strips);
        net_free(&made);
    }
}

/* The largest distance of a curve from its surface at PLACES places of each span. */
static double sampled_distance(const made_net *made, const char *name)
{
    enum { PLACES = 25 };
    const taut_surface *surface = taut_model_surface(made->model, 0);
    const taut_curve *space = space_of(made, name);
    taut_curve *window = window_of(made, name);
    const taut_basis *t = taut_curve_t(space);
    double most = 0;
    for (int i = 0; i < taut_basis_span_count(t); i++) {
        const double *b = taut_basis_breaks(t) + i;
        for (int k = 0; k <= PLACES; k++) {
            const double at = k == PLACES ? b[1] : b[0] + (b[1] - b[0]) * k / PLACES;
            double c[3], x[3], w[3];
            taut_curve_eval(space, at, 0, c);
            taut_curve_eval(window, at, 0, w);
            taut_surface_eval(surface, fmin(fmax(w[0], 0), 1), fmin(fmax(w[1], 0), 1), 0, x);
            most = fmax(most, taut_length_between(c, x));
        }
    }
    taut_curve_free(window);
    return most;
}

/* What the certificate says of all places is true of many, and hardly more than what is there. */
static void test_bound(void)
{
    for (int trial = 0; trial < random_trials(TRIALS); trial++) {
        double points[SIDE][SIDE][3];
        random_points(points);
        made_net made = net_at((const double(*)[SIDE][3])points, 0,
                               trial % 2 == 0 ? "asymptotic" : "principal", 0.4, 0.6);
        const taut_claim *claim = claim_of(made.proof, "on-surface");
        const taut_claim *complete = claim_of(made.proof, "complete");
        const double *p = taut_surface_points(taut_model_surface(made.model, 0));
        double size = 0;
        for (size_t k = 0; k < (size_t)3 * SIDE * SIDE; k++) {
            size = fmax(size, fabs(p[k] - p[k % 3]));
        }
        const double seen =
            fmax(sampled_distance(&made, "A1"), sampled_distance(&made, "B1")) / size;
        CHECK(claim->kind == TAUT_BOUND && claim->holds == TAUT_TRUE, "trial %d", trial);
        /* 3.2e-11 of it was the rounding that the bound counts */
        CHECK(seen <= claim->residual && claim->residual <= 2 * seen + 4e-11, "%g of %g", seen,
              claim->residual);
        CHECK(complete->kind == TAUT_EXACT && complete->holds == TAUT_TRUE, "trial %d", trial);
        net_free(&made);
    }
}

/* Nets of random surfaces, with umbilics, flat points, lines of K = 0 and knots where curvatures jump: what is made is
 * proved, every claim of it. */
static void test_random_nets(void)
{
    enum { NETS = 40, MOST = 7 };
    for (int trial = 0; trial < random_trials(NETS); trial++) {
        const int spline = random_int(0, 1);
        const int degree[2] = {random_int(2, 3), random_int(2, 4)};
        const int count[2] = {degree[0] + 1 + spline * random_int(0, 6 - degree[0]),
                              degree[1] + 1 + spline * random_int(0, 5 - degree[1])};
        const double height = random_log(0.01, 0.5), twist = random_int(-1, 2) / 2.0;
        double heights[MOST * MOST];
        char surface[8192], seeds[400];
        for (int k = 0; k < count[0] * count[1]; k++) {
            const double x = (double)(k / count[1]) / (count[0] - 1) - 0.5;
            const double y = (double)(k % count[1]) / (count[1] - 1) - 0.5;
            heights[k] = 4 * twist * x * y + random_in(-height, height);
        }
        net_heights(degree, count, heights, surface, sizeof surface);
        if (random_int(0, 1)) {
            snprintf(seeds, sizeof seeds, "\"seeds\": [{ \"cells\": %d }]", random_int(2, 7));
        } else {
            snprintf(seeds, sizeof seeds,
                     "\"seeds\": [{ \"at\": [%.17g, %.17g] }, { \"edge\": \"%s\", \"count\": %d, "
                     "\"by\": \"%s\" }]",
                     random_in(0, 1), random_in(0, 1), random_int(0, 1) ? "u0" : "v1",
                     random_int(2, 6), random_int(0, 1) ? "length" : "parameter");
        }
        const char *net = random_int(0, 1) ? "asymptotic" : "principal";
        made_net made = net_make(net, surface, seeds);
        CHECK(made.status == TAUT_OK || made.status == TAUT_NO_SOLUTION, "trial %d: %s", trial,
              made.error.message);
        for (int k = 0; made.status == TAUT_OK && k < taut_certificate_claim_count(made.proof);
             k++) {
            const taut_claim *claim = taut_certificate_claim(made.proof, k);
            CHECK(claim->holds == TAUT_TRUE, "trial %d, %s of\n%s\n%s: %s %g at %s", trial, net,
                  surface, seeds, claim->claim, claim->residual, claim->where);
        }
        net_free(&made);
    }
}

static double from_segment(const double x[3], const double a[3], const double b[3])
{
    double way[3], off[3];
    for (int c = 0; c < 3; c++) {
        way[c] = b[c] - a[c];
        off[c] = x[c] - a[c];
    }
    const double t = fmin(fmax(taut_dot(off, way) / taut_dot(way, way), 0), 1);
    for (int c = 0; c < 3; c++) {
        off[c] -= t * way[c];
    }
    return taut_norm(off);
}

/* How far a place of one curve is from the other, the farthest, at 33 places and from as many. */
static double farthest(const taut_curve *from, const taut_curve *to)
{
    enum { PLACES = 33 };
    double x[2][PLACES][3], most = 0;
    for (int i = 0; i < 2; i++) {
        const taut_basis *t = taut_curve_t(i == 0 ? from : to);
        for (int k = 0; k < PLACES; k++) {
            const double share = k / (PLACES - 1.0);
            taut_curve_eval(i == 0 ? from : to,
                            (1 - share) * taut_basis_lo(t) + share * taut_basis_hi(t), 0, x[i][k]);
        }
    }
    for (int k = 0; k < PLACES; k++) {
        double nearest = INFINITY;
        for (int j = 0; j + 1 < PLACES; j++) {
            nearest = fmin(nearest, from_segment(x[0][k], x[1][j], x[1][j + 1]));
        }
        most = fmax(most, nearest);
    }
    return most;
}

/* The walk round the border makes no curve that a curve of the lattice is but for a little: one of two neighbours has a
 * place that is farther than a third of a part from the other. */
static void test_twins(void)
{
    enum { NETS = 24 };
    for (int trial = 0; trial < random_trials(NETS); trial++) {
        double points[SIDE][SIDE][3];
        char surface[4096], seeds[100];
        random_points(points);
        write_surface((const double(*)[SIDE][3])points, 0, surface, sizeof surface);
        const double part = random_in(0.15, 0.5);
        snprintf(seeds, sizeof seeds, "\"seeds\": [{ \"cell\": %.17g, \"by\": \"%s\" }]", part,
                 random_int(0, 1) ? "length" : "conformal");
        made_net made = net_make("asymptotic", surface, seeds);
        CHECK(made.status == TAUT_OK, "trial %d: %s", trial, made.error.message);
        const int count = made.status == TAUT_OK ? taut_model_curve_count(made.model) : 0;
        double worst = INFINITY;
        for (int i = 0; i < count; i++) {
            const taut_curve *one = taut_model_curve(made.model, i);
            for (int j = i + 1; j < count; j++) {
                const taut_curve *other = taut_model_curve(made.model, j);
                if (taut_curve_name(one)[0] == taut_curve_name(other)[0]) {
                    worst = fmin(worst, fmax(farthest(one, other), farthest(other, one)));
                }
            }
        }
        CHECK(worst >= part / 3, "trial %d: curves %g of a part apart", trial, worst / part);
        CHECK(count == 0 || taut_certificate_holds(made.proof) == TAUT_TRUE, "trial %d", trial);
        net_free(&made);
    }
}

int main(void)
{
    random_seed(1);
    test_laths();
    test_told_otherwise();
    test_principal();
    test_raised_and_halved();
    test_gauss_bonnet();
    test_clairaut();
    test_order();
    test_bound();
    test_folded();
    test_random_nets();
    test_twins();
    return check_failures != 0;
}
