/* test_trace.c -- nets against closed forms: the curves of minimal surfaces that are straight in
 * their window, rulings, cusps where K = 0, envelopes, geodesics by Clairaut; seeds, cells, refusals.
 * The numbers are those of closed forms at 30 digits, but where a comment says so. */
#include "certificates.h"
#include "check.h"
#include "core/constants.h"
#include "nets.h"

#include <string.h>

#define CATENOID_LONG                                                                              \
    "{ \"taut\": 1, \"construct\": \"bonnet\", \"lambda\": 0, \"sign\": \"+\", \"alpha\": 2, "     \
    "\"beta\": 3, \"mesh\": \"bspline\", \"segments\": [2, 1], \"start\": [0, -1] }"
#define ENNEPER(start, side)                                                                       \
    "{ \"taut\": 1, \"construct\": \"bonnet\", \"lambda\": 1, \"normalize\": true, \"sign\": "     \
    "\"-\", \"alpha\": " side ", \"start\": [" start ", " start "] }"
/* z = 0.4 x^2 + 0.25 y^3 on [-1, 1]^2 */
#define CUSPED                                                                                     \
    "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 2, \"range\": "    \
    "[-1, 1] }, \"v\": { \"type\": \"bezier\", \"degree\": 3, \"range\": [-1, 1] }, \"points\": "  \
    "[[[-1, -1, 0.15], [-1, -0.3333333333333333, 0.65], [-1, 0.3333333333333333, 0.15], [-1, 1, "  \
    "0.65]], [[0, -1, -0.65], [0, -0.3333333333333333, -0.15], [0, 0.3333333333333333, -0.65], "   \
    "[0, 1, -0.15]], [[1, -1, 0.15], [1, -0.3333333333333333, 0.65], [1, 0.3333333333333333, "     \
    "0.15], [1, 1, 0.65]]] }] }"

typedef struct row {
    const char *net, *surface, *seed, *lath;
    double length, twist; /* NaN: not told */
    double from[2], to[2];
} row;

/* A plane arch, which the straight line between its feet leaves. */
#define ARCH                                                                                       \
    "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 2 }, \"v\": { "    \
    "\"type\": \"bezier\", \"degree\": 1 }, \"points\": [[[1, 0, 0], [2, 0, 0]], [[0, 2, 0], [0, " \
    "4, "                                                                                          \
    "0]], [[-1, 0, 0], [-2, 0, 0]]] }] }"

static void test_curves(void)
{
    const row rows[] = {{"asymptotic",
                         BONNET("0"),
                         "[0.5, 0.35]",
                         "A1",
                         1.20921653200168,
                         1.38403685462695,
                         {0.15, 0},
                         {1.05, 0.9}},
                        {"asymptotic",
                         BONNET("0"),
                         "[0.5, 0.35]",
                         "B1",
                         1.09091590165359,
                         1.33729215519161,
                         {0, 0.85},
                         {0.85, 0}},
                        {"asymptotic",
                         BONNET("1.1"),
                         "[0.5, 0.35]",
                         "A1",
                         0.860675089159401,
                         1.01743666961295,
                         {0.416054343985953, 0},
                         {0.631914602307789, 0.9}},
                        {"asymptotic",
                         BONNET("1.1"),
                         "[0.5, 0.35]",
                         "B1",
                         1.07283455567388,
                         1.42139709357812,
                         {0, 0.469922365734354},
                         {1.2, 0.182108687971905}},
                        {"asymptotic",
                         BONNET("1.5707963267948966"),
                         "[0.5, 0.35]",
                         "A1",
                         0.833276357445519,
                         0.991120021329853,
                         {0.5, 0},
                         {0.5, 0.9}},
                        {"asymptotic",
                         BONNET("1.5707963267948966"),
                         "[0.5, 0.35]",
                         "B1",
                         1.04904294241476,
                         1.37867888994497,
                         {0, 0.35},
                         {1.2, 0.35}},
                        {"asymptotic",
                         CATENOID,
                         "[0, 0]",
                         "A1",
                         3.32397093313623,
                         2.44876589017254,
                         {-1, -1},
                         {1, 1}},
                        {"asymptotic",
                         HELICOID,
                         "[0.3, 0.2]",
                         "A1",
                         3.30448064873862,
                         1.99749782849017,
                         {0.3, -1.5},
                         {0.3, 1}},
                        {"asymptotic",
                         HELICOID,
                         "[0.3, 0.2]",
                         "B1",
                         3.06020026685723,
                         2.94098399293418,
                         {-1, 0.2},
                         {2, 0.2}},
                        {"asymptotic",
                         ENNEPER("0", "1.25, \"beta\": 1"),
                         "[0.5, 0.3]",
                         "A1",
                         2.6964338589247,
                         1.69482699771251,
                         {0.2, 0},
                         {1.2, 1}},
                        {"asymptotic",
                         ENNEPER("0", "1.25, \"beta\": 1"),
                         "[0.5, 0.3]",
                         "B1",
                         1.61408907918849,
                         1.59288627758039,
                         {0, 0.8},
                         {0.8, 0}},
                        {"asymptotic",
                         BILINEAR,
                         "[0.4, -0.7]",
                         "A1",
                         2.52420284446397,
                         1.43375931042023,
                         {-1, -0.7},
                         {1, -0.7}},
                        {"asymptotic",
                         BILINEAR,
                         "[0.4, -0.7]",
                         "B1",
                         2.18504004539963,
                         1.57761947842250,
                         {0.4, -1},
                         {0.4, 1}},
                        {"asymptotic",
                         CUSPED,
                         "[0.2, -0.5]",
                         "A1",
                         1.37851856663452,
                         NAN,
                         {-0.122748612183951, 0},
                         {0.790122316991325, -1}},
                        {"asymptotic",
                         CUSPED,
                         "[0.2, -0.5]",
                         "B1",
                         1.41050729838230,
                         NAN,
                         {-0.390122316991325, -1},
                         {0.522748612183951, 0}},
                        {"principal",
                         BILINEAR,
                         "[0.3, 0.2]",
                         "A1",
                         3.37424383734586,
                         0,
                         {-0.862070697356428, -1},
                         {1, 0.862070697356428}},
                        {"principal",
                         BILINEAR,
                         "[0.3, 0.2]",
                         "B1",
                         2.24879656954454,
                         0,
                         {-0.381086187806727, 1},
                         {1, -0.381086187806727}}};

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        char seeds[80];
        snprintf(seeds, sizeof seeds, "\"seeds\": [{ \"at\": %s }]", rows[k].seed);
        made_net made = net_make(rows[k].net, rows[k].surface, seeds);
        const char *lath = rows[k].lath;
        CHECK(made.status == TAUT_OK, "row %zu: %s", k, made.error.message);
        CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "row %zu", k);
        /* 6e-13 and 3e-12 were seen */
        CHECK_NEAR(net_number(&made, lath, "length"), rows[k].length, 1e-12 * rows[k].length,
                   "row %zu", k);
        if (!isnan(rows[k].twist)) {
            CHECK_NEAR(net_number(&made, lath, "twist"), rows[k].twist, 5e-12, "row %zu", k);
        }
        for (int d = 0; d < 2; d++) {
            CHECK_NEAR(net_end(&made, lath, "from", d), rows[k].from[d], 2e-12, "row %zu", k);
            CHECK_NEAR(net_end(&made, lath, "to", d), rows[k].to[d], 2e-12, "row %zu", k);
        }
        net_free(&made);
    }
}

/* k_g at the seed, run by growing t; sqrt(-K) there. */
static void test_bending(void)
{
    const struct {
        const char *surface;
        double k_g[2];
    } rows[] = {{BONNET("0"), {-0.226475940566633, -0.515147118832761}},
                {BONNET("1.1"), {0.0761845270447632, -0.557551633067469}},
                {BONNET("1.5707963267948966"), {0.20412134768509, -0.524406694385625}}};
    for (size_t k = 0; k < 3; k++) {
        made_net made =
            net_make("asymptotic", rows[k].surface, "\"seeds\": [{ \"at\": [0.5, 0.35] }]");
        for (int f = 0; f < 2; f++) {
            const taut_record *lath = net_lath(&made, f == 0 ? "A1" : "B1");
            const taut_record *k_g = taut_record_get(lath, "k_g"),
                              *tau = taut_record_get(lath, "tau_g");
            CHECK_NEAR(taut_record_number(taut_record_get(k_g, "seed")), rows[k].k_g[f], 1e-12,
                       "theta %zu family %d", k, f);
            CHECK_NEAR(taut_record_number(taut_record_get(tau, "seed")),
                       (f == 0 ? 1 : -1) * 1.40505489993319, 2e-14, "theta %zu family %d", k, f);
        }
        const taut_record *node =
            taut_record_at(taut_record_get(taut_model_details(made.model), "nodes"), 0);
        CHECK_NEAR(taut_record_number(taut_record_get(node, "angle")), TAUT_PI / 2, 1e-14, "%zu",
                   k);
        net_free(&made);
    }
}

/* Clairaut: r sin(angle to the meridian) stays c. */
static void test_geodesics(void)
{
    const struct {
        double c, length, end;
        const char *direction;
    } rows[] = {
        {0.6, 2.75076817600103, 1.73026648282955, "[0.38883256419833123, -0.9213084375055678]"},
        {1.3, 5.43507233524617, 2.91880055165009, "[0.8424705557630511, -0.5387423898973385]"}};
    for (size_t k = 0; k < 2; k++) {
        char seeds[160];
        snprintf(seeds, sizeof seeds, "\"seeds\": [{ \"at\": [0.5, 1], \"direction\": %s }]",
                 rows[k].direction);
        made_net made = net_make("geodesic", CATENOID_LONG, seeds);
        CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "c %g: %s", rows[k].c,
              made.error.message);
        CHECK_NEAR(net_number(&made, "G1", "length"), rows[k].length, 1e-12, "c %g", rows[k].c);
        CHECK_NEAR(net_end(&made, "G1", "to", 0), rows[k].end, 2e-12, "c %g", rows[k].c);
        net_free(&made);
    }
}

/* The geodesic between two places is the one of this c, and ends there. */
static void test_between(void)
{
    made_net made = net_make("geodesic", CATENOID_LONG,
                             "\"seeds\": [{ \"at\": [0.2, -0.7], \"to\": [1.6, 0.9] }]");
    const double end[2] = {1.6, 0.9};
    CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "%s", made.error.message);
    CHECK_NEAR(net_number(&made, "G1", "length"), 2.36404915637517, 1e-12, "length");
    for (int d = 0; d < 2; d++) {
        CHECK(net_end(&made, "G1", "to", d) == end[d], "end %d", d);
    }
    net_free(&made);
}

/* Equal conformal parts on one curve of each family are squares: on the window of `bonnet`, equal
 * parts; on Enneper's surface the lattice of the diagonals. */
static void test_seeds(void)
{
    const double lengths[6] = {0.812071331330519, 0.847525128080639, 0.903085121136757,
                               1.00332841374740,  1.1005679647505,   1.26811756898617};
    made_net made = net_make("asymptotic", BONNET("1.5707963267948966"),
                             "\"seeds\": [{ \"edge\": \"v0\", \"count\": 3, \"family\": \"+\" }, "
                             "{ \"edge\": \"u0\", \"count\": 3, \"family\": \"-\" }]");
    for (int k = 0; k < 6; k++) {
        const char name[3] = {k < 3 ? 'A' : 'B', (char)('1' + k % 3), '\0'};
        CHECK_NEAR(net_number(&made, name, "length"), lengths[k], 1e-12, "%s", name);
        CHECK_NEAR(net_end(&made, name, "seed", k < 3 ? 0 : 1),
                   k < 3 ? 0.3 * (k + 1) : 0.225 * (k - 2), 2e-13, "%s", name);
    }
    CHECK(net_count(&made, "nodes") == 9, "%d nodes", net_count(&made, "nodes"));
    net_free(&made);

    made = net_make("asymptotic", ENNEPER("-0.7", "1.4, \"beta\": 1.4"),
                    "\"seeds\": [{ \"line\": [[-0.7, 0.7], [0.7, -0.7]], \"count\": 5, \"family\": "
                    "\"+\" }, { \"line\": [[-0.7, -0.7], [0.7, 0.7]], \"count\": 5, \"family\": "
                    "\"-\" }]");
    double sum = 0;
    for (int k = 0; k < 10; k++) {
        const char name[3] = {k < 5 ? 'A' : 'B', (char)('1' + k % 5), '\0'};
        sum += net_number(&made, name, "length");
    }
    CHECK_NEAR(sum, 15.7599959390858, 2e-12, "Enneper");
    CHECK(net_count(&made, "nodes") == 21, "%d nodes", net_count(&made, "nodes"));
    net_free(&made);
}

/* A net over the whole window: the lattice that the middle curves begin reaches all corners. */
static void test_cells(void)
{
    const char *surfaces[] = {
        BONNET("1.1"),
        "{ \"taut\": 1, \"construct\": \"bonnet\", \"lambda\": 0.5, \"sign\": \"-\", "
        "\"alpha\": 1.2, \"beta\": 0.9, \"theta\": 0.3 }"};
    for (int k = 0; k < 2; k++) {
        made_net made = net_make("asymptotic", surfaces[k], "\"seeds\": [{ \"cells\": 6 }]");
        CHECK(net_count(&made, "laths") == 12, "%d: %d curves", k, net_count(&made, "laths"));
        CHECK(net_lath(&made, "A7") != NULL && net_lath(&made, "B5") != NULL, "%d", k);
        CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "%d", k);
        net_free(&made);
    }

    /* u - v = 0.15 and u + v = 0.85 through the place, 0.3 apart: those in two corners are met on the border alone */
    made_net made =
        net_make("asymptotic",
                 "{ \"taut\": 1, \"construct\": \"bonnet\", \"lambda\": 0.29, \"sign\": \"-\", "
                 "\"alpha\": 1.2, \"beta\": 0.9 }",
                 "\"seeds\": [{ \"at\": [0.5, 0.35] }, { \"cells\": 6, \"at\": [0.5, 0.35] }]");
    CHECK(net_count(&made, "laths") == 14, "lattice: %d curves", net_count(&made, "laths"));
    CHECK_NEAR(net_end(&made, "A7", "from", 0) - net_end(&made, "A7", "from", 1), 1.05, 1e-12,
               "A7");
    CHECK_NEAR(net_end(&made, "B7", "from", 0) + net_end(&made, "B7", "from", 1), 2.05, 1e-12,
               "B7");
    net_free(&made);

    /* u - v = 1.2 - 1e-7 cuts off the corner (1.2, 0), which u + v = 1.2 ends in: no lath, but it was looked for */
    made = net_make("asymptotic",
                    "{ \"taut\": 1, \"construct\": \"bonnet\", \"lambda\": 0.29, \"sign\": \"-\", "
                    "\"alpha\": 1.2, \"beta\": 0.9 }",
                    "\"seeds\": [{ \"cells\": 6, \"at\": [0.74999995, 0.45000005] }]");
    CHECK(net_count(&made, "left_out") == 1, "corner: %d left out", net_count(&made, "left_out"));
    CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "corner");
    net_free(&made);
}

/* z = Re (x + iy - 0.2 - 0.1i)^3: a monkey saddle. */
#define MONKEY                                                                                     \
    "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 3, \"rang"         \
    "e\": [-1, 1] }, \"v\": { \"type\": \"bezier\", \"degree\": 3, \"range\": [-1, 1] }, "         \
    "\"points\": [[[-1.0, -1.0, 2.628], [-1.0, -0.33333333333333337, -2.652], [-1.0, 0.33"         \
    "333333333333326, -3.132], [-1.0, 1.0, 1.188]], [[-0.33333333333333337, -1.0, 3.088],"         \
    " [-0.33333333333333337, -0.33333333333333337, 0.741333333333333], [-0.33333333333333"         \
    "337, 0.33333333333333326, 0.528], [-0.33333333333333337, 1.0, 2.448]], [[0.333333333"         \
    "33333326, -1.0, -1.252], [0.33333333333333326, -0.33333333333333337, -0.665333333333"         \
    "333], [0.33333333333333326, 0.33333333333333326, -0.612], [0.33333333333333326, 1.0,"         \
    " -1.092]], [[1.0, -1.0, -2.392], [1.0, -0.33333333333333337, 1.128], [1.0, 0.3333333"         \
    "3333333326, 1.448], [1.0, 1.0, -1.432]]] }] }"

static void test_singular(void)
{
    static const char *const nets[2] = {"asymptotic", "principal"};
    for (int k = 0; k < 2; k++) {
        made_net made = net_make(nets[k], MONKEY, "\"seeds\": [{ \"at\": [0.7, -0.1] }]");
        const taut_record *list =
            taut_record_get(taut_model_details(made.model), "singular_points");
        const taut_record *one = taut_record_at(list, 0), *at = taut_record_get(one, "at");
        CHECK(taut_record_count(list) == 1, "%zu points", taut_record_count(list));
        CHECK_NEAR(taut_record_number(taut_record_at(at, 0)), 0.2, 1e-9, "u");
        CHECK_NEAR(taut_record_number(taut_record_at(at, 1)), 0.1, 1e-9, "v");
        CHECK(taut_record_number(taut_record_get(one, "index")) == -0.5, "index");
        net_free(&made);
    }
    made_net made = net_make("principal", BONNET("1.1"), "\"seeds\": [{ \"cells\": 2 }]");
    CHECK(net_count(&made, "singular_points") == 0, "none");
    net_free(&made);
    /* two of these places were off by a part in forty */
    made = net_make("principal", MONKEY, "\"seeds\": [{ \"edge\": \"v0\", \"count\": 7 }]");
    CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "%s", made.error.message);
    net_free(&made);
}

/* On z = 1.1 x y principal curves are asinh 1.1x -+ asinh 1.1y constant: quads at equal steps of them are exactly
 * plane, at others as far as their corners tell. */
/* Corners go round counter-clockwise seen from where the normal points, z here, and neighbours lie on one lath. */
static void check_panels(const taut_record *details)
{
    const taut_record *list = taut_record_get(details, "panels");
    double most = 0;
    CHECK((double)taut_record_count(list) ==
              taut_record_number(taut_record_get(details, "panel_count")),
          "%zu panels", taut_record_count(list));
    for (size_t i = 0; i < taut_record_count(list); i++) {
        const taut_record *panel = taut_record_at(list, i);
        const taut_record *points = taut_record_get(panel, "points");
        const taut_record *nodes = taut_record_get(panel, "nodes");
        double area = 0;
        for (size_t k = 0; k < 4; k++) {
            const taut_record *a = taut_record_at(points, k),
                              *b = taut_record_at(points, (k + 1) % 4);
            const char *from = taut_record_text(taut_record_at(nodes, k));
            const char *to = taut_record_text(taut_record_at(nodes, (k + 1) % 4));
            area +=
                taut_record_number(taut_record_at(a, 0)) *
                    taut_record_number(taut_record_at(b, 1)) -
                taut_record_number(taut_record_at(a, 1)) * taut_record_number(taut_record_at(b, 0));
            CHECK(strncmp(from, to, 2) == 0 || strcmp(from + 2, to + 2) == 0, "%s to %s", from, to);
        }
        CHECK(area > 0, "panel %zu", i);
        most = fmax(most, taut_record_number(taut_record_get(panel, "planarity")));
    }
    CHECK(most == taut_record_number(taut_record_get(details, "max_planarity")), "the largest");
}

/* In space each panel is a patch through its nodes, as they go round. */
static void check_patches(const taut_model *model, const taut_record *panels)
{
    static const double ways[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    taut_model *patches = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_trace_strips(model, 0, &patches, &error) == TAUT_OK, "%s", error.message);
    CHECK((size_t)taut_model_surface_count(patches) == taut_record_count(panels), "%d",
          taut_model_surface_count(patches));
    CHECK(taut_model_curve_count(patches) == taut_model_curve_count(model), "%d",
          taut_model_curve_count(patches));
    for (size_t i = 0; i < taut_record_count(panels); i++) {
        const taut_record *points = taut_record_get(taut_record_at(panels, i), "points");
        const taut_surface *patch = taut_model_surface(patches, (int)i);
        for (size_t k = 0; k < 4; k++) {
            double x[3];
            taut_surface_eval(patch, ways[k][0], ways[k][1], 0, x);
            for (size_t c = 0; c < 3; c++) {
                CHECK(x[c] == taut_record_number(taut_record_at(taut_record_at(points, k), c)),
                      "panel %zu corner %zu", i, k);
            }
        }
    }
    taut_model_free(patches);
}

static void test_panels(void)
{
    const struct {
        int count;
        double steps[5], planarity;
        int panels;
    } rows[] = {{5, {-0.6, -0.3, 0, 0.3, 0.6}, 0, 16},
                {4, {-0.6, -0.2, 0.15, 0.6}, 8.817291104644271e-06, 9}};
    for (size_t k = 0; k < 2; k++) {
        char seeds[400] = "\"panels\": true, \"seeds\": [";
        for (int i = 0; i < rows[k].count; i++) {
            const size_t length = strlen(seeds);
            snprintf(seeds + length, sizeof seeds - length, "%s{ \"at\": [%.17g, 0] }",
                     i > 0 ? ", " : "", sinh(rows[k].steps[i]) / 1.1);
        }
        strcat(seeds, "]");
        made_net made = net_make("principal", BILINEAR, seeds);
        const taut_record *details = taut_model_details(made.model);
        CHECK(taut_record_number(taut_record_get(details, "panel_count")) == rows[k].panels,
              "row %zu", k);
        CHECK_NEAR(taut_record_number(taut_record_get(details, "max_planarity")), rows[k].planarity,
                   1e-12, "row %zu", k);
        check_panels(details);
        check_patches(made.model, taut_record_get(details, "panels"));
        net_free(&made);
    }
}

/* Of principal curves of `bonnet`, which are parameter lines, 4 cells along v are 5 lines of constant u, the edges among
 * them, whole. */
static void test_edges(void)
{
    made_net made = net_make("principal", BONNET("0"), "\"seeds\": [{ \"cells\": 4 }]");
    CHECK(net_count(&made, "laths") == 8, "%d laths", net_count(&made, "laths"));
    for (int k = 0; k < 5; k++) {
        char name[8];
        snprintf(name, sizeof name, "A%d", k + 1);
        CHECK_NEAR(net_end(&made, name, "from", 0), 0.3 * k, 1e-12, "%s", name);
        CHECK(net_end(&made, name, "from", 1) == 0 && net_end(&made, name, "to", 1) == 0.9, "%s",
              name);
    }
    net_free(&made);
}

/* Two pieces of z = x y / 2 over a ridge, u = 1. */
#define ROOF                                                                                       \
    "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bspline\", \"degree\": 1, \"knots\": "   \
    "[0, 0, 1, 2, 2] }, \"v\": { \"type\": \"bezier\", \"degree\": 1 }, \"points\": [[[-1, 0, "    \
    "-1], [-1, 1, -1.5]], [[0, 0, 0], [0, 1, 0]], [[1, 0, -1], [1, 1, -0.5]]] }] }"

/* A curve that meets the ridge of a roof ends there. */
static void test_crease(void)
{
    made_net made = net_make("asymptotic", ROOF, "\"seeds\": [{ \"at\": [0.5, 0.5] }]");
    const taut_record *ended = taut_record_get(net_lath(&made, "A1"), "ended");
    CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "%s", made.error.message);
    CHECK(strcmp(taut_record_text(taut_record_at(ended, 1)), "crease") == 0, "ended %s",
          taut_record_text(taut_record_at(ended, 1)));
    CHECK_NEAR(net_end(&made, "A1", "to", 0), 1, 0, "on the ridge");
    net_free(&made);
}

/* An eighth of the unit sphere; u0 is its pole. */
#define EIGHTH                                                                                     \
    "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 2 }, \"v\": { "    \
    "\"type\": \"bezier\", \"degree\": 2 }, \"points\": [[[0, 0, 1], [0, 0, 1], [0, 0, 1]], [[1, " \
    "0, 1], [1, 1, 1], [0, 1, 1]], [[1, 0, 0], [1, 1, 0], [0, 1, 0]]], \"weights\": [[1, "         \
    "0.7071067811865476, 1], [0.7071067811865476, 0.5, 0.7071067811865476], [1, "                  \
    "0.7071067811865476, 1]] }] }"

/* Meridians end at the pole, where the normal vanishes, after a quarter of a circle: not beyond it, and without what rounding
 * makes of bends there. */
static void test_pole(void)
{
    static const char *const nets[2] = {"isoparametric", "geodesic"};
    static const char *const seeds[2] = {
        "\"families\": [\"v\"], \"seeds\": [{ \"edge\": \"u1\", \"count\": 3 }]",
        "\"seeds\": [{ \"at\": [1, 0.3], \"direction\": [-1, 0] }]"};
    for (int k = 0; k < 2; k++) {
        made_net made = net_make(nets[k], EIGHTH, seeds[k]);
        const char *name = k == 0 ? "B2" : "G1";
        const taut_record *lath = net_lath(&made, name), *ended = taut_record_get(lath, "ended");
        const int end = k == 0 ? 0 : 1;
        CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "%s: %s", nets[k],
              made.error.message);
        CHECK(strcmp(taut_record_text(taut_record_at(ended, (size_t)end)), "singular") == 0,
              "%s: ended %s", nets[k], taut_record_text(taut_record_at(ended, (size_t)end)));
        CHECK_NEAR(net_number(&made, name, "length"), 1.5707963267948966, 1e-9, "%s", nets[k]);
        CHECK_NEAR(net_end(&made, name, end == 0 ? "from" : "to", 0), 0, 1e-9, "%s", nets[k]);
        CHECK_NEAR(taut_record_number(taut_record_get(taut_record_get(lath, "tau_g"), "max")), 0,
                   1e-4, "%s twists by rounding", nets[k]);
        CHECK_NEAR(taut_record_number(taut_record_get(taut_record_get(lath, "k_n"), "max")), 1,
                   1e-4, "%s bends by rounding", nets[k]);
        net_free(&made);
    }
}

/* A plane, y = v - (u - 0.5)^2, with knots at 0.5 both ways. */
#define BENT_KNOT                                                                                  \
    "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bspline\", \"degree\": 2, \"knots\": "   \
    "[0, 0, 0, 0.5, 1, 1, 1] }, \"v\": { \"type\": \"bspline\", \"degree\": 2, \"knots\": [0, 0, " \
    "0, 0.5, 1, 1, 1] }, \"points\": [[[0, -0.25, 0], [0, 0, 0], [0, 0.5, 0], [0, 0.75, 0]], "     \
    "[[0.25, 0, 0], [0.25, 0.25, 0], [0.25, 0.75, 0], [0.25, 1, 0]], [[0.75, 0, 0], [0.75, "       \
    "0.25, 0], [0.75, 0.75, 0], [0.75, 1, 0]], [[1, -0.25, 0], [1, 0, 0], [1, 0.5, 0], [1, "       \
    "0.75, 0]]] }] }"

/* y = 0.4999 dips below the knot line v = 0.5 near the other one and comes back within a step: each piece is in its own
 * cell, so that its distance from the surface is proved. */
static void test_dip(void)
{
    made_net made = net_make("geodesic", BENT_KNOT,
                             "\"seeds\": [{ \"at\": [0.2, 0.5899], \"direction\": [1, -0.6], "
                             "\"both\": true }]");
    const taut_claim *claim = claim_of(made.proof, "on-surface");
    CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "%s", made.error.message);
    CHECK(claim->kind == TAUT_BOUND, "a piece lies in two cells");
    CHECK_NEAR(net_number(&made, "G1", "length"), 1, 1e-14, "length");
    CHECK_NEAR(net_end(&made, "G1", "to", 1), 0.7499, 1e-14, "end");
    net_free(&made);
}

/* Straight in the window: control points of the window's curves lie on the line to rounding. */
static void test_straight(void)
{
    static const char *const surfaces[] = {BONNET("0"), BONNET("1.1"), BILINEAR};
    for (int k = 0; k < 3; k++) {
        made_net made = net_make("asymptotic", surfaces[k], "\"seeds\": [{ \"at\": [0.4, 0.7] }]");
        const taut_record *domain = taut_record_get(taut_model_details(made.model), "domain");
        for (size_t i = 0; i < taut_record_count(domain); i++) {
            const taut_record *rows = taut_record_get(taut_record_at(domain, i), "points");
            const size_t last = taut_record_count(rows) - 1;
            double p[3][2];
            for (size_t j = 0; j <= last; j++) {
                const size_t which[3] = {0, last, j};
                for (int n = 0; n < 3; n++) {
                    for (size_t d = 0; d < 2; d++) {
                        p[n][d] =
                            taut_record_number(taut_record_at(taut_record_at(rows, which[n]), d));
                    }
                }
                CHECK_NEAR((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]),
                           (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]), 2e-15, "%d: %zu", k, j);
            }
        }
        CHECK(net_number(&made, "A1", "length") > 0, "%s", made.error.message);
        net_free(&made);
    }
}

/* How far curves may be off: nothing where they are straight in the window, and no more than lengths are. */
/* A translation surface f(u) - f(v) has straight asymptotic curves along its diagonals, through all crossings of its
 * knot lines, where curvatures change their slope: its cells beside the diagonal bend others. Curves that pass close by
 * are as straight as that. */
static void test_beside_knots(void)
{
    enum { N = 8 };
    static const double moved[] = {0, 1e-11, 1e-9, 3e-9, 1e-8, 3e-8, 1e-6};
    const int degree[2] = {3, 3}, counts[2] = {N, N};
    double heights[N * N];
    char surface[6000], seeds[100];

    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            const double a = 0.13 * i * i + 0.02 * (i == 3) - 0.03 * (i == 5);
            const double b = 0.13 * j * j + 0.02 * (j == 3) - 0.03 * (j == 5);
            heights[i * N + j] = a - b;
        }
    }
    net_heights(degree, counts, heights, surface, sizeof surface);
    for (size_t k = 0; k < sizeof moved / sizeof *moved; k++) {
        snprintf(seeds, sizeof seeds,
                 "\"families\": [\"-\"], \"seeds\": [{ \"at\": [%.17g, 0.45] }]", 0.45 + moved[k]);
        made_net made = net_make("asymptotic", surface, seeds);
        CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "moved by %g", moved[k]);
        CHECK_NEAR(net_number(&made, "B1", "length"), sqrt(8), 1e-9 + 10 * moved[k], "moved by %g",
                   moved[k]);
        CHECK_NEAR(net_number(&made, "B1", "turn"), 0, 1e-6 + 300 * moved[k], "moved by %g",
                   moved[k]);
        net_free(&made);
    }
}

/* The middle curves of pipes run on a knot line, or to and fro over it by rounding. Where a piece beside a knot is too short
 * to be one the next one is longer: what it counts from is where it began before (3e-7 of a part was lost). */
static void test_on_knots(void)
{
    static const char *const pipes[] = {
        "\"shape\": { \"alpha\": 1, \"beta\": 1, \"gamma\": 1 } }",
        "\"shape\": { \"alpha\": 3, \"beta\": 2, \"gamma\": 1 }, \"domain\": \"extended\" }"};
    for (int k = 0; k < 2; k++) {
        char of[320];
        snprintf(of, sizeof of,
                 "{ \"taut\": 1, \"construct\": \"pipe\", \"radius\": 1, \"polygon\": [[5, 0, 0], "
                 "[5, 2, 0], [0, 6, 0], [0, 6, 3]], %s",
                 pipes[k]);
        made_net made =
            net_make("principal", of, "\"surface\": \"blend\", \"seeds\": [{ \"cells\": 6 }]");
        CHECK(taut_certificate_holds(made.proof) != TAUT_FALSE, "row %d: %s", k,
              made.error.message);
        CHECK(claim_of(made.proof, "spacing")->residual <= 1e-9, "row %d: spacing", k);
        net_free(&made);
    }
}

static void test_drift(void)
{
    static const char *const surfaces[] = {BONNET("1.1"), BILINEAR, CUSPED};
    static const char *const places[] = {"0.5, 0.35", "0.3, 0.2", "0.2, -0.5"};
    static const double most[] = {0, 1e-11, 1e-11};
    for (int k = 0; k < 3; k++) {
        char seeds[80];
        snprintf(seeds, sizeof seeds, "\"seeds\": [{ \"at\": [%s] }]", places[k]);
        made_net made = net_make(k == 1 ? "principal" : "asymptotic", surfaces[k], seeds);
        const double drift =
            taut_record_number(taut_record_get(taut_model_details(made.model), "drift"));
        CHECK(made.status == TAUT_OK, "%d: %s", k, made.error.message);
        CHECK(drift <= most[k] && (k == 0 || drift > 0), "%d: %g", k, drift);
        net_free(&made);
    }
}

static void test_refusals(void)
{
    const struct {
        const char *net, *surface, *members, *reason;
        taut_status status;
    } rows[] = {
        {"asymptotic", BONNET("0"), "\"seeds\": [{ \"at\": [3, 0] }]", "outside", TAUT_BAD_INPUT},
        {"asymptotic", BONNET("0"), "\"families\": [\"max\"]", "family", TAUT_BAD_INPUT},
        {"asymptotic", BONNET("0"), "\"seeds\": [{ \"at\": [0, 0], \"direction\": [1, 0] }]", "net",
         TAUT_BAD_INPUT},
        {"asymptotic", BONNET("1.5707963267948966"),
         "\"seeds\": [{ \"edge\": \"v0\", \"count\": 3, \"family\": \"-\" }]", "along",
         TAUT_NO_SOLUTION},
        {"asymptotic", CUSPED, "\"seeds\": [{ \"at\": [0, 0.5] }]", "elliptic", TAUT_NO_SOLUTION},
        {"geodesic", BILINEAR, "", "net", TAUT_BAD_INPUT},
        {"geodesic", BILINEAR, "\"seeds\": [{ \"at\": [0, 0], \"direction\": [0, 0] }]",
         "direction", TAUT_BAD_INPUT},
        {"geodesic", ARCH, "\"seeds\": [{ \"at\": [0, 0], \"to\": [1, 0] }]", "no-geodesic",
         TAUT_NO_SOLUTION},
        {"geodesic", BILINEAR, "\"seeds\": [{ \"at\": [0, 0], \"to\": [0, 2] }]", "outside",
         TAUT_BAD_INPUT},
        {"geodesic", BILINEAR, "\"seeds\": [{ \"at\": [0, 0], \"to\": [0, 0] }]", "value",
         TAUT_BAD_INPUT},
        {"principal", BILINEAR, "\"seeds\": [{ \"lath\": \"A9\", \"count\": 2 }]", "name",
         TAUT_BAD_INPUT},
        {"asymptotic", BILINEAR, "\"surface\": \"other\"", "no-such-object", TAUT_BAD_INPUT},
        {"asymptotic", BILINEAR, "\"panels\": true", "net", TAUT_BAD_INPUT},
        {"asymptotic", ROOF, "\"seeds\": [{ \"at\": [1, 0.5] }]", "crease", TAUT_NO_SOLUTION},
        {"asymptotic", ROOF, "\"seeds\": [{ \"cells\": 4 }]", "crease", TAUT_NO_SOLUTION}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        made_net made = net_make(rows[k].net, rows[k].surface, rows[k].members);
        CHECK(made.status == rows[k].status, "row %zu: %d %s", k, made.status, made.error.message);
        CHECK(strcmp(made.error.reason, rows[k].reason) == 0, "row %zu: %s", k, made.error.reason);
        CHECK(made.model == NULL, "row %zu", k);
        net_free(&made);
    }
}

/* z = (x y - 0.857 x^3 y^3) / 2: umbilics on both diagonals, at 0.6039. */
#define ROUNDED                                                                                    \
    "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 3, \"range\": "    \
    "[-1, "                                                                                        \
    "1] }, \"v\": { \"type\": \"bezier\", \"degree\": 3, \"range\": [-1, 1] }, \"points\": "       \
    "[[[-1, -1, 0.071499999999999994], [-1, -0.3333333333333333, "                                 \
    "0.59516666666666695], [-1, 0.3333333333333333, -0.59516666666666695], [-1, 1, "               \
    "-0.071499999999999994]], [[-0.3333333333333333, -1, 0.59516666666666695], "                   \
    "[-0.3333333333333333, -0.3333333333333333, -0.37294444444444402], "                           \
    "[-0.3333333333333333, 0.3333333333333333, 0.37294444444444402], "                             \
    "[-0.3333333333333333, 1, -0.59516666666666695]], [[0.3333333333333333, -1, "                  \
    "-0.59516666666666695], [0.3333333333333333, -0.3333333333333333, "                            \
    "0.37294444444444402], [0.3333333333333333, 0.3333333333333333, "                              \
    "-0.37294444444444402], [0.3333333333333333, 1, 0.59516666666666695]], [[1, -1, "              \
    "-0.071499999999999994], [1, -0.3333333333333333, -0.59516666666666695], [1, "                 \
    "0.3333333333333333, 0.59516666666666695], [1, 1, 0.071499999999999994]]] }] }"

/* The middle curves end at umbilics, which are whole parts of them away: no curve is seeded there, by a lattice or by a
 * lath. One that passes an umbilic too near turns within less than doubles resolve. */
static void test_umbilic_ends(void)
{
    static const char *const seeds[2] = {"\"seeds\": [{ \"cells\": 4 }]",
                                         "\"seeds\": [{ \"at\": [0, 0], \"family\": \"min\" }, "
                                         "{ \"lath\": \"B1\", \"count\": 3, \"ends\": true }]"};
    for (int k = 0; k < 2; k++) {
        made_net made = net_make("principal", ROUNDED, seeds[k]);
        const taut_record *left = taut_record_get(taut_model_details(made.model), "left_out");
        CHECK(net_count(&made, "left_out") == (k == 0 ? 4 : 2), "%d: %d left out", k,
              net_count(&made, "left_out"));
        for (size_t i = 0; i < taut_record_count(left);
             i++) { /* of max on min's curve, then of min */
            const taut_record *at = taut_record_get(taut_record_at(left, i), "at");
            const char *name = k == 1 ? "B1" : i < 2 ? "B2" : "A2";
            for (int d = 0; d < 2; d++) {
                const double end = net_end(&made, name, i % 2 == 0 ? "from" : "to", d);
                CHECK_NEAR(taut_record_number(taut_record_at(at, (size_t)d)), end, 1e-15, "%d: %s",
                           k, name);
                CHECK_NEAR(fabs(end), 0.603918842142038, 1e-8, "%d: %s", k, name);
            }
        }
        CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "%d: %s", k, made.error.message);
        net_free(&made);
    }
    /* 5e-9 and 1e-8 from an umbilic, and four times as far, which is followed */
    static const double beside[3] = {0.60391883702, 0.603918831, 0.6039188};
    for (int k = 0; k < 3; k++) {
        char seed[100];
        snprintf(seed, sizeof seed, "\"seeds\": [{ \"at\": [-%.11f, %.11f], \"family\": \"max\" }]",
                 beside[k], beside[k]);
        made_net made = net_make("principal", ROUNDED, seed);
        if (k < 2) {
            CHECK(made.status == TAUT_NOT_CONVERGED && strcmp(made.error.reason, "stalled") == 0,
                  "%d: %d %s", k, made.status, made.error.message);
        } else {
            CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "%d: %s", k, made.error.message);
        }
        net_free(&made);
    }
}

int main(void)
{
    test_curves();
    test_bending();
    test_geodesics();
    test_between();
    test_seeds();
    test_cells();
    test_edges();
    test_singular();
    test_panels();
    test_crease();
    test_pole();
    test_dip();
    test_straight();
    test_beside_knots();
    test_on_knots();
    test_drift();
    test_umbilic_ends();
    test_refusals();
    return check_failures != 0;
}
