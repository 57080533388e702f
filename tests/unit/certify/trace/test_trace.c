/* test_trace.c -- nets that are none: each claim fails on a model that was changed where it looks. */
#include "certificates.h"
#include "certify/trace/compose.h"
#include "certify/trace/everywhere.h"
#include "check.h"
#include "nets.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define SURFACE                                                                                    \
    "{ \"taut\": 1, \"surfaces\": [{ \"name\": \"s\", \"u\": { \"type\": \"bezier\", \"degree\": " \
    "1, "                                                                                          \
    "\"range\": [-1, 1] }, \"v\": { \"type\": \"bezier\", \"degree\": 1, \"range\": [-1, 1] }, "   \
    "\"points\": [[[-1, -1, 1.1], [-1, 1, -1.1]], [[1, -1, -1.1], [1, 1, 1.1]]] }] }"

/* The model with the points of one curve moved, and other details. */
static taut_model *changed(const taut_model *model, int which, double sideways, double stretch,
                           const taut_record *details)
{
    taut_model *copy = NULL;
    taut_model_new(&copy);
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        taut_surface *surface = NULL;
        taut_surface_copy(taut_model_surface(model, i), &surface);
        taut_model_add_surface(copy, surface);
    }
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        const taut_curve *from = taut_model_curve(model, i);
        const size_t count = (size_t)taut_basis_count(taut_curve_t(from));
        double *points = malloc(3 * count * sizeof(double));
        taut_curve *curve = NULL;
        for (size_t k = 0; k < 3 * count; k++) {
            points[k] = taut_curve_points(from)[k];
        }
        for (size_t k = 1; i == which && k + 1 < count; k++) {
            const double bump = sin(3.14159 * (double)k / (double)(count - 1));
            points[3 * k + 2] += sideways * bump;
            points[3 * k] += stretch * bump * (double)(k % 2);
        }
        taut_curve_new(taut_curve_name(from), taut_curve_t(from), points, NULL, &curve, NULL);
        taut_model_add_curve(copy, curve);
        free(points);
    }
    taut_model_set_details(copy,
                           taut_record_copy(details != NULL ? details : taut_model_details(model)));
    taut_model_set_certificate(copy, NULL);
    return copy;
}

static taut_verdict judge(const made_net *made, taut_model *model, const char *claim)
{
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};
    const taut_status status = taut_certify(model, made->problem, NULL, &proof, &error);
    const taut_verdict verdict = claim_of(proof, claim)->holds;
    CHECK(status == TAUT_OK, "%s: %s", claim, error.message);
    taut_certificate_free(proof);
    taut_model_free(model);
    return verdict;
}

static void test_moved(void)
{
    made_net made = net_make("principal", SURFACE, "\"seeds\": [{ \"at\": [0.3, 0.2] }]");
    CHECK(judge(&made, changed(made.model, -1, 0, 0, NULL), "on-surface") == TAUT_TRUE, "as made");
    CHECK(judge(&made, changed(made.model, 0, 3e-5, 0, NULL), "on-surface") == TAUT_FALSE, "moved");
    CHECK(judge(&made, changed(made.model, 0, 1e-7, 0, NULL), "on-surface") == TAUT_TRUE, "hardly");
    CHECK(judge(&made, changed(made.model, 0, 0, 1e-5, NULL), "principal") == TAUT_FALSE, "wavy");
    CHECK(judge(&made, changed(made.model, 0, 0, 1e-3, NULL), "length") == TAUT_FALSE, "longer");
    net_free(&made);
}

/* The names of two families exchanged, a node less, a node elsewhere: details are no witnesses of
 * those. */
static void test_told(void)
{
    made_net made = net_make("asymptotic", SURFACE,
                             "\"seeds\": [{ \"edge\": \"u0\", \"count\": 2 }, "
                             "{ \"edge\": \"v0\", \"count\": 2 }]");
    taut_record *details = taut_record_new();
    taut_record *nodes = NULL;
    const taut_record *old = taut_model_details(made.model);

    CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "%s", made.error.message);
    for (size_t k = 0; k < taut_record_count(old); k++) {
        if (strcmp(taut_record_key(old, k), "nodes") != 0) {
            taut_record_add_record(details, taut_record_key(old, k), taut_record_at(old, k));
        }
    }
    nodes = taut_record_add_list(details, "nodes");
    CHECK(judge(&made, changed(made.model, -1, 0, 0, details), "complete") == TAUT_FALSE,
          "no nodes");
    CHECK(judge(&made, changed(made.model, -1, 0, 0, details), "nodes") == TAUT_FALSE, "missing");
    taut_record *node = taut_record_add_object(nodes, NULL);
    taut_record_add_text(node, "node", "A1B1");
    const double s[2] = {0.1, 0.1};
    taut_record_add_numbers(node, "s", 2, s);
    CHECK(judge(&made, changed(made.model, -1, 0, 0, details), "nodes") == TAUT_FALSE, "elsewhere");
    taut_record_free(details);
    net_free(&made);
}

/* Geodesics that cross where details have no node, and the same where they have it. */
static void test_missing(void)
{
    made_net made = net_make("geodesic", CATENOID,
                             "\"seeds\": [{ \"at\": [0.5, 0.5], \"direction\": [1, 0.3], "
                             "\"both\": true }, { \"at\": [0, 0.2], \"direction\": [-0.4, 1], "
                             "\"both\": true }]");
    const taut_record *old = taut_model_details(made.model);
    taut_record *details = taut_record_new();

    CHECK(claim_of(made.proof, "nodes")->holds == TAUT_TRUE, "%s", made.error.message);
    CHECK(taut_record_count(taut_record_get(old, "nodes")) > 0, "they cross");
    for (size_t k = 0; k < taut_record_count(old); k++) {
        if (strcmp(taut_record_key(old, k), "nodes") != 0) {
            taut_record_add_record(details, taut_record_key(old, k), taut_record_at(old, k));
        }
    }
    taut_record_add_list(details, "nodes");
    CHECK(judge(&made, changed(made.model, -1, 0, 0, details), "nodes") == TAUT_FALSE, "missing");
    taut_record_free(details);
    net_free(&made);
}

/* A number of an outline's point. */
static double of_outline(const taut_record *piece, size_t point, size_t d)
{
    return taut_record_number(
        taut_record_at(taut_record_at(taut_record_get(piece, "outline"), point), d));
}

/* The least coordinate of an outline. */
static double least_of(const taut_record *piece, size_t d)
{
    double least = INFINITY;
    for (size_t k = 0; k < taut_record_count(taut_record_get(piece, "outline")); k++) {
        least = fmin(least, of_outline(piece, k, d));
    }
    return least;
}

/* A piece as it is, laid where another one begins. */
static void add_moved(taut_record *list, const taut_record *piece, const taut_record *other)
{
    taut_record *moved = taut_record_add_object(list, NULL);
    for (size_t k = 0; k < taut_record_count(piece); k++) {
        const taut_record *member = taut_record_at(piece, k);
        if (strcmp(taut_record_key(piece, k), "outline") != 0) {
            taut_record_add_record(moved, taut_record_key(piece, k), member);
            continue;
        }
        taut_record *outline = taut_record_add_list(moved, "outline");
        for (size_t i = 0; i < taut_record_count(member); i++) {
            double at[2];
            for (size_t d = 0; d < 2; d++) {
                at[d] = of_outline(piece, i, d) + (least_of(other, d) - least_of(piece, d));
            }
            taut_record_add_numbers(outline, NULL, 2, at);
        }
    }
}

/* The details without the last piece, with the first piece twice, or with the last one laid on the first one. */
static void test_pieces(void)
{
    made_net made =
        net_make("asymptotic", SURFACE,
                 "\"seeds\": [{ \"edge\": \"u0\", \"count\": 2 }], \"laths\": { \"strip\": "
                 "\"standing\", \"width\": 0.1 }");
    const taut_record *old = taut_model_details(made.model);

    CHECK(claim_of(made.proof, "pattern")->holds == TAUT_TRUE, "%s", made.error.message);
    CHECK(claim_of(made.proof, "pattern")->kind == TAUT_EXACT, "kind");
    for (int way = 0; way < 3; way++) {
        const taut_record *pieces = taut_record_get(old, "pieces");
        taut_record *details = taut_record_new();
        for (size_t k = 0; k < taut_record_count(old); k++) {
            if (strcmp(taut_record_key(old, k), "pieces") != 0) {
                taut_record_add_record(details, taut_record_key(old, k), taut_record_at(old, k));
            }
        }
        taut_record *list = taut_record_add_list(details, "pieces");
        const size_t last = taut_record_count(pieces) - 1;
        for (size_t k = 0; k + (way != 1) < taut_record_count(pieces); k++) {
            taut_record_add_record(list, NULL, taut_record_at(pieces, k));
        }
        if (way == 1) {
            taut_record_add_record(list, NULL, taut_record_at(pieces, 0));
        } else if (way == 2) {
            add_moved(list, taut_record_at(pieces, last), taut_record_at(pieces, 0));
        }
        CHECK(judge(&made, changed(made.model, -1, 0, 0, details), "pattern") == TAUT_FALSE,
              "way %d", way);
        taut_record_free(details);
    }
    net_free(&made);
}

/* Parts of an edge that are equal in one measure are not in another one. */
static void test_spacing(void)
{
    const char *parts = "\"seeds\": [{ \"edge\": \"v0\", \"count\": 3, \"by\": \"%s\" }]";
    char length[120], conformal[120];
    snprintf(length, sizeof length, parts, "length");
    snprintf(conformal, sizeof conformal, parts, "conformal");
    made_net made = net_make("principal", SURFACE, length);
    made_net other = net_make("principal", SURFACE, conformal);
    CHECK(claim_of(made.proof, "spacing")->holds == TAUT_TRUE, "length");
    CHECK(claim_of(other.proof, "spacing")->holds == TAUT_TRUE, "conformal");
    CHECK(judge(&made, changed(other.model, -1, 0, 0, NULL), "spacing") == TAUT_FALSE, "other");
    net_free(&made);
    net_free(&other);
}

/* The same on curves that others are seeded on, and on the two through the node of a lattice. */
static void test_spacing_of_laths(void)
{
    static const char *const seeds[] = {"{ \"at\": [0.3, 0.2], \"family\": \"%s\" }, { \"lath\": "
                                        "\"A1\", \"count\": 3, \"by\": \"%s\" }",
                                        "{ \"cells\": 5, \"at\": [0.3, 0.2], \"by\": \"%.0s%s\" }"};
    for (int k = 0; k < 4; k++) {
        const int is_asymptotic = k % 2;
        char members[2][200], list[160];
        made_net made[2];
        for (int by = 0; by < 2; by++) {
            snprintf(list, sizeof list, seeds[k / 2], is_asymptotic ? "+" : "max",
                     by ? "length" : "conformal");
            snprintf(members[by], sizeof members[by], "\"seeds\": [%s]", list);
            made[by] = net_make(is_asymptotic ? "asymptotic" : "principal", SURFACE, members[by]);
            CHECK(claim_of(made[by].proof, "spacing")->holds == TAUT_TRUE, "%d, %d: %g %s", k, by,
                  claim_of(made[by].proof, "spacing")->residual, made[by].error.message);
        }
        CHECK(judge(&made[0], changed(made[1].model, -1, 0, 0, NULL), "spacing") == TAUT_FALSE,
              "%d", k);
        net_free(&made[0]);
        net_free(&made[1]);
    }
}

/* Curves of a minimal surface cross at right angles, those of x y do not. */
static void test_right_angled(void)
{
    const char *seeds = "\"seeds\": [{ \"at\": [0.3, 0.2] }]";
    made_net made = net_make("asymptotic", BONNET("1.1"), seeds);
    made_net other = net_make("asymptotic", SURFACE, seeds);
    CHECK(claim_of(made.proof, "right-angled")->holds == TAUT_TRUE, "minimal");
    CHECK(judge(&made, changed(other.model, -1, 0, 0, NULL), "right-angled") == TAUT_FALSE, "x y");
    for (int k = 0; k < taut_certificate_claim_count(other.proof); k++) {
        CHECK(strcmp(taut_certificate_claim(other.proof, k)->claim, "right-angled") != 0,
              "claimed");
    }
    net_free(&made);
    net_free(&other);
}

/* A net of another surface, or of the other family, is not this one. */
static void test_other(void)
{
    made_net made = net_make("asymptotic", SURFACE, "\"seeds\": [{ \"at\": [0.3, 0.2] }]");
    made_net other = net_make("principal", SURFACE, "\"seeds\": [{ \"at\": [0.3, 0.2] }]");
    made_net steeper =
        net_make("asymptotic",
                 "{ \"taut\": 1, \"surfaces\": [{ \"name\": \"s\", \"u\": { \"type\": "
                 "\"bezier\", \"degree\": 1, \"range\": [-1, 1] }, \"v\": { \"type\": "
                 "\"bezier\", \"degree\": 1, \"range\": [-1, 1] }, \"points\": [[[-1, "
                 "-1, 1.2], [-1, 1, -1.1]], [[1, -1, -1.1], [1, 1, 1.1]]] }] }",
                 "\"seeds\": [{ \"at\": [0.3, 0.2] }]");
    CHECK(judge(&made, changed(other.model, -1, 0, 0, NULL), "asymptotic") == TAUT_FALSE,
          "principal");
    CHECK(judge(&made, changed(steeper.model, -1, 0, 0, NULL), "surface") == TAUT_FALSE, "steeper");
    net_free(&made);
    net_free(&other);
    net_free(&steeper);
}

/* On minimal surfaces in conformal parameters curves are straight in the window: that is exact, the distance a
 * bound above what is found at places. A window's line that is bent, or another one's, proves nothing. */
static void test_straight(void)
{
    static const char *const nets[] = {"asymptotic", "principal"};
    static const char *const surfaces[] = {
        BONNET("1.1"), CATENOID,
        "{ \"taut\": 1, \"construct\": \"bonnet\", \"lambda\": 1, \"sign\": \"-\", \"normalize\": "
        "true, "
        "\"alpha\": 1.2, \"beta\": 0.9, \"start\": [-0.2, 0.1] }"};
    for (int k = 0; k < 6; k++) {
        made_net made = net_make(nets[k % 2], surfaces[k / 2],
                                 "\"seeds\": [{ \"at\": [0.3, 0.4] }, { \"at\": [0.1, 0.7] }]");
        const taut_claim *own = claim_of(made.proof, nets[k % 2]);
        const taut_claim *distance = claim_of(made.proof, "on-surface");
        CHECK(own->kind == TAUT_EXACT && own->holds == TAUT_TRUE, "%d", k);
        CHECK(distance->kind == TAUT_BOUND && distance->holds == TAUT_TRUE, "%d", k);
        CHECK(distance->residual > 1e-12 && distance->residual < 1e-7, "%d: %g", k,
              distance->residual);
        CHECK(claim_of(made.proof, "complete")->kind == TAUT_EXACT, "%d", k);
        CHECK(judge(&made, changed(made.model, 0, 1e-4, 0, NULL), "on-surface") == TAUT_FALSE,
              "%d moved", k);
        net_free(&made);
    }
    made_net other = net_make("asymptotic", SURFACE, "\"seeds\": [{ \"at\": [0.3, 0.2] }]");
    CHECK(claim_of(other.proof, "asymptotic")->kind == TAUT_CHECK, "not minimal");
    net_free(&other);
    other = net_make("geodesic", CATENOID,
                     "\"seeds\": [{ \"at\": [0.3, 0.2], \"direction\": [1, 1] }]");
    CHECK(claim_of(other.proof, "on-surface")->kind == TAUT_CHECK, "not a polynomial");
    net_free(&other);
}

/* About (1, 2, 2)/3 by the angle whose cosine is 3/5: then all coordinates are of one kind. */
static void turn_about(double x[3])
{
    static const double axis[3] = {1.0 / 3, 2.0 / 3, 2.0 / 3};
    const double along = axis[0] * x[0] + axis[1] * x[1] + axis[2] * x[2];
    double turned[3];
    for (int c = 0; c < 3; c++) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        turned[c] = 0.6 * x[c] + 0.8 * (axis[a] * x[b] - axis[b] * x[a]) + 0.4 * along * axis[c];
    }
    memcpy(x, turned, sizeof turned);
}

/* z = a x^2 + b xy + c y^2 + d x^3 over [-1, 1]^2, as it is and turned: K < 0, R > 0, or not everywhere. */
static void test_everywhere(void)
{
    const struct {
        double a, b, c, d; /* x^2 + c y^2 has umbilics at y^2 = (c - 1)/(4 c^2) */
        int saddle, round; /* are they everywhere? */
    } rows[] = {{0, 1, 0, 0, 1, 1},     {1, 0, -1, 0, 1, 1},    {1, 0, 1, 0, 0, 0},
                {1, 0, 8, 0, 0, 0},     {0, 0, 0, 0, 0, 0},     {1, 0, 0, 0, 0, 1},
                {1, 0, -1, 0.3, 1, 1},  {1, 0, -1, 0.34, 0, 1}, {1, 0, -1, 0.32, 1, 1},
                {-1, 0, -0.5, -1, 0, 0}};

    for (size_t i = 0; i < 2 * sizeof rows / sizeof *rows; i++) {
        const size_t k = i / 2;
        const double heights[3][4] = {{-1, -1.0 / 3, 1.0 / 3, 1},
                                      {1, -1.0 / 3, -1.0 / 3, 1},
                                      {-1, 1, -1, 1}}; /* Bernstein: of x, x^2, x^3 */
        double points[4][3][3];
        taut_basis *bases[2] = {NULL, NULL};
        taut_surface *surface = NULL;
        for (int m = 0; m < 4; m++) {
            for (int j = 0; j < 3; j++) {
                const double y = j - 1, y2 = j == 1 ? -1 : 1;
                points[m][j][0] = heights[0][m];
                points[m][j][1] = y;
                points[m][j][2] = rows[k].a * heights[1][m] + rows[k].b * heights[0][m] * y +
                                  rows[k].c * y2 + rows[k].d * heights[2][m];
                if (i % 2 != 0) {
                    turn_about(points[m][j]);
                }
            }
        }
        for (int d = 0; d < 2; d++) {
            const taut_basis_spec spec = {.type = "bezier", .degree = 3 - d};
            taut_basis_new(&spec, 4 - d, &bases[d], NULL);
        }
        taut_surface_new("s", bases[0], bases[1], points[0][0], NULL, &surface, NULL);
        const taut_surface *surfaces[1] = {surface};
        taut_arena *arena = taut_arena_new();
        taut_net_cells *cells = NULL;
        taut_net_cells_new(arena, 1, surfaces, &cells);
        for (int net = 0; net < 2; net++) {
            int is_proved = -1;
            CHECK(taut_net_everywhere(cells,
                                      net == 0 ? TAUT_TRACE_ASYMPTOTIC : TAUT_TRACE_PRINCIPAL,
                                      &is_proved) == TAUT_OK,
                  "row %zu", k);
            CHECK(is_proved == (net == 0 ? rows[k].saddle : rows[k].round), "row %zu net %d: %d", k,
                  net, is_proved);
        }
        taut_arena_free(arena);
        taut_surface_free(surface);
        taut_basis_free(bases[0]);
        taut_basis_free(bases[1]);
    }
}

/* The same bits by the loops of every processor. */
static void compare_kernels(const taut_surface *const surfaces[1])
{
    static const char *const kernels[3] = {"baseline", "avx2", "avx512"};
    double told[3][12][9] = {{{0}}}, away[3] = {0};
    for (int k = 0; k < 3; k++) {
        taut_arena *arena = taut_arena_new();
        taut_net_cells *cells = NULL;
        taut_net_composer *composer = NULL;
        taut_net_span span = {.to = 1};
        setenv("TAUT_KERNEL", kernels[k], 1); /* one that is not there is passed over */
        taut_net_cells_new(arena, 1, surfaces, &cells);
        taut_net_composer_new(arena, cells, &composer);
        unsetenv("TAUT_KERNEL");
        for (int i = 0; i < 12; i++) {
            const double at[2] = {0.01 + 0.02 * i, 0.02 + 0.01 * i};
            double s[3][3];
            taut_forms f;
            taut_net_cells_look(cells, 0, at, s, &f);
            const double all[9] = {s[0][0], s[0][1], s[0][2], s[1][0], s[2][2],
                                   f.mean,  f.l,     f.m,     f.n};
            memcpy(told[k][i], all, sizeof all);
        }
        for (int i = 0; i <= TAUT_NET_QUINTIC; i++) {
            span.window[i][0] = span.window[i][1] = 0.02 + 0.03 * i;
        }
        away[k] = taut_net_compose_distance(composer, &span);
        CHECK(isfinite(away[k]), "%s: %g", kernels[k], away[k]);
        taut_arena_free(arena);
    }
    for (int k = 1; k < 3; k++) {
        CHECK(memcmp(told[0], told[k], sizeof told[0]) == 0, "%s", kernels[k]);
        CHECK(away[0] == away[k], "%s: %.17g %.17g", kernels[k], away[0], away[k]);
    }
}

/* What the cells tell of a place is what the surface tells by other formulas, polynomial or not, clear or not. */
static void test_cells(void)
{
    static const char *const kinds[] = {"bspline", "bezier"};
    for (int trial = 0; trial < 40; trial++) {
        const int p = 1 + trial % 5, q = 1 + trial / 5 % 5, is_spline = trial % 2 == 0;
        const int nu = p + 1 + (is_spline ? 2 : 0), nv = q + 1 + (is_spline ? 1 : 0);
        const int has_weights = trial % 7 == 6, is_pole = trial % 7 == 5;
        double points[10 * 10][3], weights[10 * 10];
        taut_basis *bases[2] = {NULL, NULL};
        taut_surface *surface = NULL;
        for (int k = 0; k < nu * nv; k++) {
            const int i = k / nv, j = k % nv;
            points[k][0] = is_pole && j == 0 ? 0 : i + random_in(-0.1, 0.1);
            points[k][1] = is_pole && j == 0 ? 0 : j + random_in(-0.1, 0.1);
            points[k][2] = is_pole && j == 0 ? 0 : random_in(-0.5, 0.5);
            weights[k] = random_in(0.5, 2);
        }
        for (int d = 0; d < 2; d++) {
            const taut_basis_spec spec = {.type = kinds[!is_spline],
                                          .degree = d == 0 ? p : q,
                                          .count = is_spline ? (d == 0 ? nu : nv) : 0};
            taut_basis_new(&spec, d == 0 ? nu : nv, &bases[d], NULL);
        }
        taut_surface_new("s", bases[0], bases[1], points[0], has_weights ? weights : NULL, &surface,
                         NULL);
        const taut_surface *surfaces[1] = {surface};
        taut_arena *arena = taut_arena_new();
        taut_net_cells *cells = NULL;
        taut_net_cells_new(arena, 1, surfaces, &cells);
        for (int k = 0; k < 20; k++) {
            const double at[2] = {
                random_in(taut_basis_lo(bases[0]), taut_basis_hi(bases[0])),
                is_pole && k == 0 ? taut_basis_lo(bases[1])
                                  : random_in(taut_basis_lo(bases[1]), taut_basis_hi(bases[1]))};
            double s[3][3], other[3][3];
            taut_forms f, g;
            CHECK(taut_net_cells_look(cells, 0, at, s, &f), "trial %d", trial);
            taut_surface_eval(surface, at[0], at[1], 1, other[0]);
            taut_surface_forms_points(surface, 1, &at[0], &at[1], 1, &g);
            for (int c = 0; c < 9; c++) { /* 2e-14 was seen */
                CHECK_NEAR(s[c / 3][c % 3], other[c / 3][c % 3], 2e-13, "trial %d", trial);
            }
            CHECK(f.regular == g.regular, "trial %d", trial);
            if (g.regular) { /* 2e-14 was seen */
                CHECK_NEAR(f.w, g.w, 2e-13 * (1 + g.w), "trial %d", trial);
                CHECK_NEAR(f.mean, g.mean, 2e-13 * (1 + fabs(g.mean)), "trial %d", trial);
                CHECK_NEAR(f.gaussian, g.gaussian, 2e-13 * (1 + fabs(g.gaussian)), "trial %d",
                           trial);
                CHECK_NEAR(f.l, g.l, 2e-13 * (1 + fabs(g.l)), "trial %d", trial);
                CHECK_NEAR(f.m, g.m, 2e-13 * (1 + fabs(g.m)), "trial %d", trial);
                CHECK_NEAR(f.n, g.n, 2e-13 * (1 + fabs(g.n)), "trial %d", trial);
            }
        }
        if (!has_weights && !is_pole) {
            compare_kernels(surfaces);
        }
        taut_arena_free(arena);
        taut_surface_free(surface);
        taut_basis_free(bases[0]);
        taut_basis_free(bases[1]);
    }
}

/* Lines of curvature of z = c (x^2 + y^2) + a cubic that pass an umbilic at 1e-7 of the size: there the net turns by as much
 * as in all the rest, within that distance. */
static void test_beside_umbilics(void)
{
    static const struct {
        const char *family;
        double seed[2], c, cubic[4]; /* of x^3, x^2 y, x y^2, y^3 */
    } rows[] = {
        {"min",
         {-0.18432396112571592, -0.30927430223809815},
         1.5963279085774371,
         {-0.16272199986939884, -0.10431468597634519, -0.2530628573574798, 0.06750863273093699}},
        {"min",
         {0.31, 0.17},
         1.6148406433408944,
         {0.2748980921186417, 0.19459674945089445, 0.1640184449726233, 0.2596387364394894}}};
    const double power[4][4] = {{1, 1, 1, 1},
                                {-1, -1.0 / 3, 1.0 / 3, 1},
                                {1, -1.0 / 3, -1.0 / 3, 1},
                                {-1, 1, -1, 1}}; /* of x, by Bernstein's polynomials */
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        char surface[4096], seeds[256];
        int at = snprintf(surface, sizeof surface,
                          "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", "
                          "\"degree\": 3, \"range\": [-1, 1] }, \"v\": { \"type\": \"bezier\", "
                          "\"degree\": 3, \"range\": [-1, 1] }, \"points\": [");
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 4; j++) {
                double z = rows[k].c * (power[2][i] + power[2][j]);
                for (int m = 0; m < 4; m++) {
                    z += rows[k].cubic[m] * power[3 - m][i] * power[m][j];
                }
                at +=
                    snprintf(surface + at, sizeof surface - (size_t)at, "%s[%.17g, %.17g, %.17g]%s",
                             j == 0 ? "[" : "", power[1][i], power[1][j], z,
                             j < 3   ? ", "
                             : i < 3 ? "], "
                                     : "]] }] }");
            }
        }
        snprintf(seeds, sizeof seeds, "\"seeds\": [{ \"at\": [%.17g, %.17g], \"family\": \"%s\" }]",
                 rows[k].seed[0], rows[k].seed[1], rows[k].family);
        made_net made = net_make("principal", surface, seeds);
        CHECK(made.status == TAUT_OK, "row %zu: %s", k, made.error.message);
        const taut_record *bend = taut_record_get(net_lath(&made, "B1"), "k_g");
        CHECK(taut_record_number(taut_record_get(bend, "max")) > 1e5, "row %zu passes by", k);
        CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "row %zu: principal %g, figures %g",
              k, claim_of(made.proof, "principal")->residual,
              claim_of(made.proof, "figures")->residual);
        net_free(&made);
    }
}

/* The same net, and the same certificate, by any number of threads. */
static void test_threads(void)
{
    static const char *const seeds[] = {
        "\"seeds\": [{ \"edge\": \"v0\", \"count\": 5 }]",
        "\"seeds\": [{ \"at\": [0.3, 0.2] }, { \"at\": [-0.2, 0.4] }]",
        "\"seeds\": [{ \"cells\": 4 }]",
        "\"seeds\": [{ \"at\": [0.1, 0.1] }, { \"lath\": \"A1\", \"count\": 6 }]"};
    for (size_t k = 0; k < sizeof seeds / sizeof *seeds; k++) {
        made_net made[3];
        char *texts[3] = {NULL, NULL, NULL};
        for (int i = 0; i < 3; i++) {
            const int threads = 1 + 3 * i;
            size_t length = 0;
            made[i] = net_make_by("asymptotic", SURFACE, seeds[k], threads);
            CHECK(made[i].status == TAUT_OK, "seeds %zu: %s", k, made[i].error.message);
            taut_model_write_text(made[i].model, "json", NULL, &texts[i], &length, NULL);
            CHECK(texts[i] != NULL && strcmp(texts[0], texts[i]) == 0, "seeds %zu, %d threads", k,
                  threads);
            for (int c = 0; c < taut_certificate_claim_count(made[0].proof); c++) {
                const taut_claim *a = taut_certificate_claim(made[0].proof, c);
                const taut_claim *b = taut_certificate_claim(made[i].proof, c);
                CHECK(b != NULL && a->residual == b->residual && strcmp(a->where, b->where) == 0,
                      "seeds %zu, %d threads: %s", k, threads, a->claim);
            }
        }
        for (int i = 0; i < 3; i++) {
            taut_text_free(texts[i]);
            net_free(&made[i]);
        }
    }
}

/* A strip that only bends as long as its edge is told to be, and not in another width. */
static void test_isometric(void)
{
    static const char *const strips[] = {"developable", "envelope"};
    for (int k = 0; k < 2; k++) {
        char members[2][160];
        for (int wide = 0; wide < 2; wide++) {
            snprintf(
                members[wide], sizeof members[wide],
                "\"seeds\": [{ \"at\": [0.6, 0.55], \"family\": \"%s\" }], \"max_length\": 0.2, "
                "\"laths\": { \"strip\": \"%s\", \"width\": %g }",
                k == 0 ? "+" : "min", strips[k], wide ? 0.02001 : 0.02);
        }
        made_net made = net_make(k == 0 ? "asymptotic" : "principal", CATENOID, members[0]);
        made_net wide = net_make(k == 0 ? "asymptotic" : "principal", CATENOID, members[1]);
        CHECK(made.status == TAUT_OK, "%s: %s", strips[k], made.error.message);
        CHECK(claim_of(made.proof, "isometric")->holds == TAUT_TRUE, "%s: %g", strips[k],
              claim_of(made.proof, "isometric")->residual);
        CHECK(judge(&made, changed(wide.model, -1, 0, 0, NULL), "isometric") == TAUT_FALSE, "%s",
              strips[k]);
        net_free(&made);
        net_free(&wide);
    }
}

/* z = 1.1 x y in two halves; the second one may rise otherwise. */
#define HALVES(height)                                                                             \
    "{ \"taut\": 1, \"surfaces\": [{ \"name\": \"a\", \"u\": { \"type\": \"bezier\", \"degree\": " \
    "1 }, \"v\": { \"type\": \"bezier\", \"degree\": 1 }, \"points\": [[[-1, -1, 1.1], [-1, 1, "   \
    "-1.1]], [[0, -1, 0], [0, 1, 0]]] }, { \"name\": \"b\", \"u\": { \"type\": \"bezier\", "       \
    "\"degree\": 1 }, \"v\": { \"type\": \"bezier\", \"degree\": 1 }, \"points\": [[[0, -1, 0], "  \
    "[0, 1, 0]], [[1, -1, -" height "], [1, 1, " height "]]] }] }"

/* The details with another surface for a stretch: `which` of them, or all. */
static taut_record *on_surface(const taut_record *old, size_t which, const char *name)
{
    taut_record *details = taut_record_new();
    for (size_t k = 0; k < taut_record_count(old); k++) {
        const char *key = taut_record_key(old, k);
        const taut_record *list = taut_record_at(old, k);
        if (strcmp(key, "domain") != 0) {
            taut_record_add_record(details, key, list);
            continue;
        }
        taut_record *domain = taut_record_add_list(details, key);
        for (size_t i = 0; i < taut_record_count(list); i++) {
            const taut_record *item = taut_record_at(list, i);
            taut_record *at = taut_record_add_object(domain, NULL);
            taut_record_add_text(at, "surface",
                                 i == which || which > taut_record_count(list)
                                     ? name
                                     : taut_record_text(taut_record_get(item, "surface")));
            for (size_t m = 0; m < taut_record_count(item); m++) {
                if (strcmp(taut_record_key(item, m), "surface") != 0) {
                    taut_record_add_record(at, taut_record_key(item, m), taut_record_at(item, m));
                }
            }
        }
    }
    return details;
}

/* Equal parts of an edge, a line, a lath and a lattice of the second surface, whose curves go on to the first; and
 * those of another measure, which are none. */
static void test_spacing_across(void)
{
    static const char *const seeds[] = {
        "{ \"edge\": \"v0\", \"count\": 3, \"surface\": \"b\", \"by\": \"%s\" }",
        "{ \"cells\": 5, \"surface\": \"b\", \"by\": \"%s\" }",
        "{ \"at\": [0.3, 0.6] }, { \"lath\": \"A1\", \"count\": 4, \"by\": \"%s\" }"};
    for (size_t k = 0; k < sizeof seeds / sizeof *seeds; k++) {
        char list[160], members[200];
        made_net made[2];
        for (int by = 0; by < 2; by++) {
            snprintf(list, sizeof list, seeds[k], by ? "length" : "conformal");
            snprintf(members, sizeof members, "\"carry\": true, \"seeds\": [%s]", list);
            made[by] = net_make("principal", HALVES("1.1"), members);
            CHECK(made[by].status == TAUT_OK, "%zu, %d: %s", k, by, made[by].error.message);
            CHECK(claim_of(made[by].proof, "spacing")->holds == TAUT_TRUE, "%zu, %d: %g", k, by,
                  claim_of(made[by].proof, "spacing")->residual);
        }
        CHECK(judge(&made[0], changed(made[1].model, -1, 0, 0, NULL), "spacing") == TAUT_FALSE,
              "%zu", k);
        net_free(&made[0]);
        net_free(&made[1]);
    }
}

/* A curve that is told to be on another surface, and one that ends where the next surface begins. */
static void test_seams(void)
{
    made_net made = net_make("principal", HALVES("1.1"),
                             "\"carry\": true, \"seeds\": [{ \"at\": [0.3, 0.6], \"family\": "
                             "\"max\" }]");
    made_net alone = net_make("principal", HALVES("1.1"),
                              "\"surface\": \"a\", \"seeds\": [{ \"at\": [0.3, 0.6], \"family\": "
                              "\"max\" }]");
    const taut_claim *seams = claim_of(made.proof, "seams");

    CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "%s", made.error.message);
    CHECK(seams->kind == TAUT_BOUND && seams->residual < 1e-14, "%g", seams->residual);
    CHECK(taut_certificate_holds(alone.proof) == TAUT_TRUE, "%s", alone.error.message);
    taut_record *other = on_surface(taut_model_details(made.model), 1, "a");
    CHECK(judge(&made, changed(made.model, -1, 0, 0, other), "on-surface") == TAUT_FALSE, "on a");
    taut_record_free(other);
    other = on_surface(taut_model_details(made.model), 1, "c");
    CHECK(judge(&made, changed(made.model, -1, 0, 0, other), "on-surface") == TAUT_FALSE, "on c");
    taut_record_free(other);
    /* the curve of the half alone, in a model of both */
    taut_record *both = on_surface(taut_model_details(alone.model), SIZE_MAX, "a");
    taut_model *model = changed(alone.model, -1, 0, 0, both);
    taut_surface *second = NULL;
    taut_surface_copy(taut_model_surface(made.model, 1), &second);
    taut_model_add_surface(model, second);
    CHECK(judge(&made, model, "ends") == TAUT_FALSE, "at the seam");
    taut_record_free(both);
    /* the second half in another slope than the first one: its normal jumps where the curve passes */
    made_net bent = net_make("asymptotic", HALVES("1.3"),
                             "\"carry\": true, \"seeds\": [{ \"at\": [0.3, 0.6] }]");
    CHECK(taut_certificate_holds(bent.proof) == TAUT_TRUE, "%s", bent.error.message);
    CHECK(net_count(&bent, "joins") == 0, "%d joins", net_count(&bent, "joins"));
    taut_model_new(&model);
    for (int k = 0; k < 2; k++) {
        taut_surface *half = NULL;
        taut_surface_copy(taut_model_surface(k == 0 ? made.model : bent.model, k), &half);
        taut_model_add_surface(model, half);
    }
    taut_curve *curve = NULL;
    taut_curve_copy(taut_model_curve(made.model, 0), &curve);
    taut_model_add_curve(model, curve);
    taut_model_set_details(model, taut_record_copy(taut_model_details(made.model)));
    CHECK(judge(&made, model, "seams") == TAUT_FALSE, "a crease");
    net_free(&bent);
    net_free(&alone);
    net_free(&made);
}

/* The claim holds, or is left out where nothing can be said. */
static void check_net(const char *what, const char *net, const char *surface, const char *members,
                      int says_complete)
{
    made_net made = net_make(net, surface, members);
    CHECK(made.status == TAUT_OK, "%s: %s", what, made.error.message);
    for (int k = 0; made.status == TAUT_OK && k < taut_certificate_claim_count(made.proof); k++) {
        const taut_claim *claim = taut_certificate_claim(made.proof, k);
        CHECK(claim->holds == TAUT_TRUE, "%s: %s %g at %s", what, claim->claim, claim->residual,
              claim->where);
    }
    CHECK(has_claim(made.proof, "complete") == says_complete, "%s", what);
    net_free(&made);
}

/* Two curves that go round an umbilic may cross twice where its index is 1/2, and not where it is -1/2; beside it they
 * turn within a thousandth of the surface. */
static void test_umbilics(void)
{
    static const int degrees[3][2] = {{4, 2}, {4, 3}, {3, 2}};
    static const int counts[3][2] = {{5, 3}, {5, 4}, {4, 3}};
    static const double backwards[12] = {0.25,   -0.4, 0.15,   0.217, 0,   0.183,
                                         -0.217, 0,    -0.183, -0.25, 0.4, -0.15};
    static const double forwards[15] = {-0.4139, 0.1359,  0.03209, -0.1293, 0.5612,
                                        0.101,   -0.4638, 0.2085,  0.3257,  0.00431,
                                        -0.0385, -0.2128, 0.608,   -0.2177, 0.06686};
    static const double near[20] = {
        0.08552317974586032,  0.054982056375433144,  0.011835773487165012,  0.010721892288090944,
        -0.23122850632366784, 0.004453725527875647,  0.10980170519611043,   0.04651422217375282,
        -0.14642193738435627, -0.037973870105847865, 0.03689469657747254,   0.16665731827674643,
        0.2225292584764385,   -0.03473371838492926,  -0.07105915692889431,  -0.04854634848435031,
        -0.13934108267962939, -0.11532143904188752,  -0.017733465815233967, 0.10830777516822138};
    char surface[2048];

    net_heights(degrees[0], counts[0], forwards, surface, sizeof surface);
    check_net("forwards", "principal", surface,
              "\"seeds\": [{ \"at\": [0.2, 0.42] }, { \"edge\": \"v1\", \"count\": 5 }]", 0);
    net_heights(degrees[1], counts[1], near, surface, sizeof surface);
    check_net("near", "principal", surface,
              "\"seeds\": [{ \"edge\": \"u0\", \"count\": 6, \"by\": \"parameter\" }]", 0);
    /* a monkey saddle and x y / 20: index -1/2, a third of a turn backwards, off the middle */
    net_heights(degrees[2], counts[2], backwards, surface, sizeof surface);
    check_net("backwards", "principal", surface,
              "\"seeds\": [{ \"at\": [0.85, 0.45] }, { \"at\": [0.2, 0.65] }, { \"at\": [0.55, "
              "0.915] }]",
              1);
}

/* z = (x^2 + y^2)/2 + 0.3 x^3 + 0.6 x y^2 over [-1, 1]^2 with knots at -1/2, 0 and 1/2: near an umbilic H^2 and K have as
 * many digits in common as there are, and R of the end is half of them. */
static void test_umbilic_ends(void)
{
    enum { POINTS = 7, ROOM = 8192 };
    static const double knots[POINTS + 4] = {-1, -1, -1, -1, -0.5, 0, 0.5, 1, 1, 1, 1};
    static const char basis[] =
        "{\"type\": \"bspline\", \"degree\": 3, \"knots\": [-1, -1, -1, -1, "
        "-0.5, 0, 0.5, 1, 1, 1, 1]}";
    double blossoms[4][POINTS]; /* of 1, x, x^2, x^3 */
    char surface[ROOM];
    int length =
        snprintf(surface, ROOM, "{\"taut\": 1, \"surfaces\": [{\"u\": %s, \"v\": %s, \"points\": [",
                 basis, basis);

    for (int i = 0; i < POINTS; i++) {
        const double *t = knots + i + 1;
        blossoms[0][i] = 1;
        blossoms[1][i] = (t[0] + t[1] + t[2]) / 3;
        blossoms[2][i] = (t[0] * t[1] + t[0] * t[2] + t[1] * t[2]) / 3;
        blossoms[3][i] = t[0] * t[1] * t[2];
    }
    for (int k = 0; k < POINTS * POINTS; k++) {
        const int i = k / POINTS, j = k % POINTS;
        const double z = (blossoms[2][i] + blossoms[2][j]) / 2 + 0.3 * blossoms[3][i] +
                         0.6 * blossoms[1][i] * blossoms[2][j];
        length += snprintf(surface + length, (size_t)(ROOM - length), "%s[%.17g, %.17g, %.17g]%s",
                           j == 0 ? (i == 0 ? "[" : ", [") : ", ", blossoms[1][i], blossoms[1][j],
                           z, j == POINTS - 1 ? "]" : "");
    }
    snprintf(surface + length, (size_t)(ROOM - length), "]}]}");
    made_net made =
        net_make("principal", surface, "\"seeds\": [{ \"at\": [0.17897260477727528, -1] }]");
    const taut_claim *ends = claim_of(made.proof, "ends");
    CHECK(ends->holds == TAUT_TRUE, "ends: %g at %s", ends->residual, ends->where);
    const taut_record *ended = taut_record_get(net_lath(&made, "B1"), "ended");
    CHECK(strcmp(taut_record_text(taut_record_at(ended, 1)), "umbilic") == 0, "B1 ends elsewhere");
    net_free(&made);
}

/* Of degree 2 curvatures jump at knots: curves have corners there, of more than a right angle where the way on would lead
 * back, end where K > 0 begins, and touch the border from outside. */
static void test_jumps(void)
{
    static const int degrees[3][2] = {{2, 2}, {3, 2}, {2, 3}},
                     counts[3][2] = {{5, 3}, {4, 5}, {5, 4}};
    static const double ends[15] = {
        -0.007346182921770608, -0.023933469816509893,  -0.004167499291536188, 0.00891367215829528,
        -0.00732178869257391,  0.005827715328395331,   0.028223533559716324,  -0.003472787075499837,
        -0.004086551156644627, -0.0030775005064489964, -0.09612028378350701,  -0.057219902395252535,
        -0.005205963544963284, -0.03890828888582744,   0.0019671091181379954};
    static const double touches[20] = {0.497,   0.2119, 0.01366, -0.2349, -0.4529, 0.1673,  0.03881,
                                       -0.0028, -0.123, -0.1705, -0.2205, -0.0934, 0.00028, 0.08692,
                                       0.1632,  -0.501, -0.2607, 0.00793, 0.2622,  0.5521};
    static const double back[20] = {
        1.285017325443835,    0.3377390441413563,  -0.31602299880657064, -0.9928525428276865,
        0.8686470912785909,   0.6038059408183798,  -0.17797855467314558, -0.5048169736873076,
        -0.12457679034591623, 0.01098930140754898, 0.025844930139289853, -0.012140309844467796,
        -0.5117504458981416,  0.11458753748959283, 0.023818666694895296, 0.5234920229840944,
        -0.9264405327238133,  -0.3310350200696756, 0.29795940745228666,  0.9741008910229206};
    char surface[2048];

    net_heights(degrees[0], counts[0], ends, surface, sizeof surface);
    check_net("ends", "asymptotic", surface, "\"seeds\": [{ \"cells\": 5 }]", 0);
    net_heights(degrees[1], counts[1], touches, surface, sizeof surface);
    check_net("touches", "asymptotic", surface,
              "\"seeds\": [{ \"edge\": \"u0\", \"count\": 2, \"by\": \"parameter\" }]", 1);
    net_heights(degrees[2], counts[2], back, surface, sizeof surface);
    check_net("back", "asymptotic", surface, "\"seeds\": [{ \"cells\": 4 }]", 0);
}

int main(void)
{
    test_umbilics();
    test_umbilic_ends();
    test_jumps();
    test_straight();
    test_isometric();
    test_everywhere();
    test_cells();
    test_beside_umbilics();
    test_threads();
    test_spacing_across();
    test_seams();
    test_moved();
    test_told();
    test_missing();
    test_pieces();
    test_right_angled();
    test_spacing();
    test_spacing_of_laths();
    test_other();
    return check_failures != 0;
}
