/* test_worked.c -- worked examples of nets against closed forms at 30 digits, those that test_trace.c and
 * test_laths.c do not hold: stations of the catenoid, Enneper's lattice, Scherk's surface, cusps, envelopes of a
 * torus, a monkey saddle, Clairaut's constant, and a spline with knots (by an integrator of order 16 at 80 bits).
 */
#include "check.h"
#include "core/constants.h"
#include "nets.h"

#include <stdlib.h>
#include <string.h>

#define CATENOID_PIECE(start, side)                                                                \
    "{ \"taut\": 1, \"construct\": \"bonnet\", \"lambda\": 0, \"sign\": \"+\", \"alpha\": " side   \
    ", \"beta\": " side ", \"start\": [" start ", " start "] }"
#define CATENOID_LONG                                                                              \
    "{ \"taut\": 1, \"construct\": \"bonnet\", \"lambda\": 0, \"sign\": \"+\", \"alpha\": 2, "     \
    "\"beta\": 3, \"mesh\": \"bspline\", \"segments\": [2, 1], \"start\": [0, -1] }"
#define ENNEPER                                                                                    \
    "{ \"taut\": 1, \"construct\": \"bonnet\", \"lambda\": 1, \"normalize\": true, \"sign\": "     \
    "\"-\", \"alpha\": 1.4, \"beta\": 1.4, \"start\": [-0.7, -0.7] }"

static double seed_value(const made_net *made, const char *lath, const char *key)
{
    return taut_record_number(taut_record_get(taut_record_get(net_lath(made, lath), key), "seed"));
}

/* A number of a list in a node. */
static double node_number(const made_net *made, int node, const char *key, size_t i)
{
    const taut_record *nodes = taut_record_get(taut_model_details(made->model), "nodes");
    const taut_record *one = taut_record_at(nodes, (size_t)node), *at = taut_record_get(one, key);
    return taut_record_number(taut_record_count(at) > 0 ? taut_record_at(at, i) : at);
}

static const taut_curve *space_of(const taut_model *model, const char *name)
{
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        if (strcmp(taut_curve_name(taut_model_curve(model, i)), name) == 0) {
            return taut_model_curve(model, i);
        }
    }
    return NULL;
}

/* k_g, tau_g and what follows from them on the line u = v of the catenoid. */
static void test_stations(void)
{
    const struct {
        const char *seed, *piece, *strips;
        double k_g, tau_g, eta, widest, standing, developable;
    } rows[] = {{"[0.4, 0.4]", CATENOID_PIECE("0.4", "0.6"), "[0.7, 0.7]", 0.248516653199244,
                 0.855638786081178, 3.44298369974903, 0.337434946304845, 0.988872612842805,
                 3.19446704654978},
                {"[1, 1]", CATENOID_PIECE("1", "0.2"), "[1.1, 1.1]", 0.348995626047012,
                 0.419974341614026, 1.20337995742518, 2.76219569108363, 0.629281205820694,
                 0.854384331378165}};

    for (size_t k = 0; k < 2; k++) {
        char seeds[120], members[300];
        snprintf(seeds, sizeof seeds, "\"seeds\": [{ \"at\": %s, \"family\": \"+\" }]",
                 rows[k].seed);
        made_net made = net_make("asymptotic", CATENOID_PIECE("0.4", "0.6"), seeds);
        CHECK_NEAR(fabs(seed_value(&made, "A1", "k_g")), rows[k].k_g, 1e-12, "row %zu", k);
        CHECK_NEAR(fabs(seed_value(&made, "A1", "tau_g")), rows[k].tau_g, 1e-13, "row %zu", k);
        CHECK_NEAR(fabs(seed_value(&made, "A1", "tau_g") / seed_value(&made, "A1", "k_g")),
                   rows[k].eta, 1e-11, "row %zu", k);
        net_free(&made);
        /* both bend most where v is least: at the beginning of the piece */
        snprintf(members, sizeof members,
                 "\"seeds\": [{ \"at\": %s, \"family\": \"+\" }], \"laths\": { \"strip\": "
                 "\"standing\", \"width\": 0.12 }",
                 rows[k].strips);
        made = net_make("asymptotic", rows[k].piece, members);
        CHECK_NEAR(1 / net_number(&made, "A1", "least_radius"), rows[k].standing, 1e-12, "row %zu",
                   k);
        if (k == 0) {
            CHECK_NEAR(net_number(&made, "A1", "length"), 1.08109395664148, 1e-12, "axis");
            CHECK_NEAR(net_number(&made, "A1", "edge_length"), 1.08188037136012, 1e-12, "fibre");
        }
        net_free(&made);
        snprintf(members, sizeof members,
                 "\"seeds\": [{ \"at\": %s, \"family\": \"+\" }], \"laths\": { \"strip\": "
                 "\"developable\", \"width\": 0.001 }",
                 rows[k].strips);
        made = net_make("asymptotic", rows[k].piece, members);
        CHECK_NEAR(1 / net_number(&made, "A1", "least_radius") * (1 - 0.001 / rows[k].widest),
                   rows[k].developable, 1e-7, "row %zu", k);
        net_free(&made);
        snprintf(members, sizeof members,
                 "\"seeds\": [{ \"at\": %s, \"family\": \"+\" }], \"laths\": { \"strip\": "
                 "\"developable\", \"width\": 20 }",
                 rows[k].strips);
        made = net_make("asymptotic", rows[k].piece, members);
        CHECK(strcmp(made.error.reason, "developable") == 0, "row %zu: %s", k, made.error.reason);
        CHECK_NEAR(made.error.limit, rows[k].widest, 1e-8, "row %zu", k);
        net_free(&made);
    }
}

/* Seeds by length on edges of `bonnet`, and all lengths of both nets. */
static void test_edges(void)
{
    static const double u[3] = {0.325036837827267, 0.637446477333018, 0.929699104287758};
    static const double v[3] = {0.265156530726539, 0.507934995439987, 0.719078857704928};
    static const char *const words[2] = {"conformal", "length"};
    static const double sums[2] = {5.93469552803198, 6.03947047189708};

    for (int k = 0; k < 2; k++) {
        char members[300];
        double sum = 0;
        snprintf(members, sizeof members,
                 "\"seeds\": [{ \"edge\": \"v0\", \"count\": 3, \"family\": \"+\", \"by\": \"%s\" "
                 "}, { \"edge\": \"u0\", \"count\": 3, \"family\": \"-\", \"by\": \"%s\" }]",
                 words[k], words[k]);
        made_net made = net_make("asymptotic", BONNET("1.5707963267948966"), members);
        for (int i = 0; i < 6; i++) {
            const char name[3] = {i < 3 ? 'A' : 'B', (char)('1' + i % 3), '\0'};
            sum += net_number(&made, name, "length");
            if (k == 1) {
                CHECK_NEAR(net_end(&made, name, "seed", i / 3), i < 3 ? u[i] : v[i - 3], 2e-13,
                           "%s", name);
            }
        }
        CHECK_NEAR(sum, sums[k], 1e-11, "%s", words[k]);
        net_free(&made);
    }
}

/* Enneper's surface: the lattice of five curves of each family from the diagonals. */
static void test_enneper(void)
{
    static const double lengths[5] = {0.971372663656661, 1.65529332619097, 2.62666598984763,
                                      1.65529332619097, 0.971372663656661};
    made_net made = net_make(
        "asymptotic", ENNEPER,
        "\"seeds\": [{ \"line\": [[-0.7, 0.7], [0.7, -0.7]], \"count\": 5, \"family\": "
        "\"+\" }, { \"line\": [[-0.7, -0.7], [0.7, 0.7]], \"count\": 5, \"family\": \"-\" }]");
    int border = 0;
    for (int i = 0; i < 10; i++) {
        const char name[3] = {i < 5 ? 'A' : 'B', (char)('1' + i % 5), '\0'};
        CHECK_NEAR(net_number(&made, name, "length"), lengths[i % 5], 1e-12, "%s", name);
    }
    const taut_record *nodes = taut_record_get(taut_model_details(made.model), "nodes");
    for (size_t k = 0; k < taut_record_count(nodes); k++) {
        border += taut_record_bool(taut_record_get(taut_record_at(nodes, k), "border"));
    }
    CHECK(border == 8 && taut_record_count(nodes) == 21, "%d of %zu on the border", border,
          taut_record_count(nodes));
    net_free(&made);
}

/* The acute angle of the rulings of z = 1.1 xy. */
static void test_angle(void)
{
    made_net made = net_make("asymptotic", BILINEAR, "\"seeds\": [{ \"at\": [0.4, -0.7] }]");
    CHECK_NEAR(node_number(&made, 0, "angle", 0), 1.32254605195895, 1e-14, "angle");
    net_free(&made);
}

/* ---- Scherk's surface ---- */

enum { PARTS = 6, DEGREE = 24, ROWS = PARTS * DEGREE + 1 };
static const double breaks[PARTS + 1] = {-1.2, -0.9, -0.5, 0, 0.5, 0.9, 1.2};

/* The Bernstein coefficients of ln cos on a part: of its Taylor polynomial about the middle, by
 * t = tan, t' = 1 + t^2. The rest is below 4e-15. */
static void log_cosine(double from, double to, double coefficients[DEGREE + 1])
{
    const double middle = (from + to) / 2, half = (to - from) / 2;
    double tangent[DEGREE + 1] = {tan(middle)}, series[DEGREE + 1] = {log(cos(middle))};
    double power[DEGREE + 1];

    for (int k = 0; k < DEGREE; k++) {
        double square = k == 0;
        for (int i = 0; i <= k; i++) {
            square += tangent[i] * tangent[k - i];
        }
        tangent[k + 1] = square / (k + 1);
        series[k + 1] = -tangent[k] / (k + 1);
    }
    /* in s = (x - from) / (to - from): x - middle = half (2 s - 1) */
    for (int k = 0; k <= DEGREE; k++) {
        power[k] = series[k] * pow(half, k);
    }
    for (int i = 0; i <= DEGREE;
         i++) {                       /* (2s - 1)^k in Bernstein form, by products of the blossom */
        double sum[DEGREE + 1] = {1}; /* elementary: of i ones and DEGREE - i minus ones */
        for (int j = 0; j < DEGREE; j++) {
            for (int k = j + 1; k > 0; k--) {
                sum[k] += (j < i ? 1 : -1) * sum[k - 1];
            }
        }
        double choose = 1;
        coefficients[i] = 0;
        for (int k = 0; k <= DEGREE; k++) {
            coefficients[i] += power[k] * sum[k] / choose;
            choose = choose * (DEGREE - k) / (k + 1);
        }
    }
}

static taut_model *scherk(void)
{
    double heights[ROWS], places[ROWS], knots[ROWS + DEGREE + 1];
    double *points = malloc(sizeof(double) * 3 * ROWS * ROWS);
    taut_basis *basis = NULL;
    taut_surface *surface = NULL;
    taut_model *model = NULL;
    int count = 0;

    for (int part = 0; part < PARTS; part++) {
        log_cosine(breaks[part], breaks[part + 1], heights + part * DEGREE);
        for (int i = 0; i <= DEGREE; i++) {
            places[part * DEGREE + i] =
                breaks[part] + (breaks[part + 1] - breaks[part]) * i / DEGREE;
        }
    }
    for (int k = 0; k <= PARTS; k++) {
        for (int i = 0; i < DEGREE + (k == 0 || k == PARTS); i++) {
            knots[count++] = breaks[k];
        }
    }
    for (int i = 0; points != NULL && i < ROWS; i++) {
        for (int j = 0; j < ROWS; j++) {
            double *p = points + 3 * (i * ROWS + j);
            p[0] = places[i];
            p[1] = places[j];
            p[2] = heights[j] - heights[i];
        }
    }
    const taut_basis_spec spec = {
        .type = "bspline", .degree = DEGREE, .knot_count = count, .knots = knots};
    taut_basis_new(&spec, ROWS, &basis, NULL);
    taut_surface_new("scherk", basis, basis, points, NULL, &surface, NULL);
    taut_model_new(&model);
    taut_model_add_surface(model, surface);
    taut_basis_free(basis);
    free(points);
    return model;
}

static void test_scherk(void)
{
    const taut_trace_seed seed = {.at = {0.3, -0.5}};
    taut_model *of = scherk();
    const taut_trace_problem problem = {.model = of, .seed_count = 1, .seeds = &seed};
    made_net made = {.status = TAUT_OK};
    made.status = taut_trace_make(&problem, NULL, &made.model, &made.error);
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    CHECK_NEAR(net_number(&made, "A1", "length"), 3.30260407844331, 1e-11, "+");
    CHECK_NEAR(net_number(&made, "B1", "length"), 3.16275823085168, 1e-11, "-");
    CHECK_NEAR(net_end(&made, "A1", "from", 0), -1.2, 1e-15, "from");
    CHECK_NEAR(net_end(&made, "A1", "from", 1), 1.11267661098984, 1e-11, "from");
    CHECK_NEAR(net_end(&made, "A1", "to", 0), 1.11267661098984, 1e-11, "to");
    CHECK_NEAR(net_end(&made, "A1", "to", 1), -1.2, 1e-15, "to");
    CHECK_NEAR(net_end(&made, "B1", "from", 0), -0.760693586466161, 1e-11, "from");
    CHECK_NEAR(net_end(&made, "B1", "to", 1), 0.760693586466161, 1e-11, "to");
    net_free(&made);
    taut_model_free(of);
}

/* ---- K = 0 ---- */

/* z = 0.4 x^2 + 0.25 y^3: how far the cusps are from the seed. */
static void test_cusps(void)
{
    made_net made = net_make(
        "asymptotic",
        "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 2, \"range\": "
        "[-1, 1] }, \"v\": { \"type\": \"bezier\", \"degree\": 3, \"range\": [-1, 1] }, "
        "\"points\": [[[-1, -1, 0.15], [-1, -0.3333333333333333, 0.65], [-1, 0.3333333333333333, "
        "0.15], [-1, 1, 0.65]], [[0, -1, -0.65], [0, -0.3333333333333333, -0.15], [0, "
        "0.3333333333333333, -0.65], [0, 1, -0.15]], [[1, -1, 0.15], [1, -0.3333333333333333, "
        "0.65], [1, 0.3333333333333333, 0.15], [1, 1, 0.65]]] }] }",
        "\"seeds\": [{ \"at\": [0.2, -0.5] }]");
    CHECK_NEAR(node_number(&made, 0, "s", 0), 0.603728927249486, 1e-12, "+");
    CHECK_NEAR(net_number(&made, "B1", "length") - node_number(&made, 0, "s", 1), 0.616755053283637,
               1e-12, "-");
    net_free(&made);
}

/* A torus, R = 2, r = 0.6, of rational quadratics: from the inner equator to both envelopes. */
static void test_torus(void)
{
    enum { SIDE = 9 };
    static const double square[SIDE][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                           {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    const double knots[SIDE + 3] = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
    double points[SIDE][SIDE][3], weights[SIDE][SIDE];
    taut_basis *basis = NULL;
    taut_surface *surface = NULL;
    taut_model *of = NULL;

    for (int i = 0; i < SIDE; i++) {
        for (int j = 0; j < SIDE; j++) {
            const double r = 2 - 0.6 * square[j][0];
            points[i][j][0] = r * square[i][0];
            points[i][j][1] = r * square[i][1];
            points[i][j][2] = 0.6 * square[j][1];
            weights[i][j] = (i % 2 ? sqrt(0.5) : 1) * (j % 2 ? sqrt(0.5) : 1);
        }
    }
    const taut_basis_spec spec = {
        .type = "bspline", .degree = 2, .knot_count = SIDE + 3, .knots = knots};
    taut_basis_new(&spec, SIDE, &basis, NULL);
    taut_surface_new("torus", basis, basis, points[0][0], weights[0], &surface, NULL);
    taut_model_new(&of);
    taut_model_add_surface(of, surface);
    taut_basis_free(basis);

    const taut_trace_seed seed = {.at = {0.3, 0}};
    const taut_trace_problem problem = {.model = of, .seed_count = 1, .seeds = &seed};
    made_net made = {.status = TAUT_OK};
    made.status = taut_trace_make(&problem, NULL, &made.model, &made.error);
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    for (int k = 0; k < 2; k++) {
        const char *name = k == 0 ? "A1" : "B1";
        const taut_curve *curve = space_of(made.model, name);
        const taut_basis *t = taut_curve_t(curve);
        double a[3], b[3];
        /* 5e-12 of it was seen */
        CHECK_NEAR(net_number(&made, name, "length"), 5.74464027825048, 6e-11, "%s", name);
        taut_curve_eval(curve, taut_basis_lo(t), 0, a);
        taut_curve_eval(curve, taut_basis_hi(t), 0, b);
        const double turned = fabs(atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]));
        CHECK_NEAR(fmin(turned, 2 * TAUT_PI - turned), fmin(3.11015806518812, TAUT_PI), 3e-10, "%s",
                   name);
        CHECK_NEAR(fabs(a[2]), 0.6, 1e-11, "%s", name);
        CHECK_NEAR(fabs(b[2]), 0.6, 1e-11, "%s", name);
    }
    net_free(&made);

    /* circles both ways, which close at the seed: they cross there, once */
    const taut_trace_seed inside = {.at = {0.3, 0.2}};
    const taut_trace_problem circles = {
        .model = of, .net = TAUT_TRACE_ISOPARAMETRIC, .seed_count = 1, .seeds = &inside};
    made = (made_net){.status = TAUT_OK};
    made.status = taut_trace_make(&circles, NULL, &made.model, &made.error);
    CHECK(net_count(&made, "laths") == 2 && net_count(&made, "nodes") == 1, "%d circles, %d nodes",
          net_count(&made, "laths"), net_count(&made, "nodes"));
    net_free(&made);
    taut_model_free(of);
}

/* z = Re (x + iy - 0.2 - 0.1i)^3. */
static void test_monkey(void)
{
    made_net made = net_make(
        "asymptotic",
        "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 3, \"range\": "
        "[-1, 1] }, \"v\": { \"type\": \"bezier\", \"degree\": 3, \"range\": [-1, 1] }, "
        "\"points\": [[[-1, -1, 2.628], [-1, -0.33333333333333337, -2.652], [-1, "
        "0.33333333333333326, -3.132], [-1, 1, 1.188]], [[-0.33333333333333337, -1, 3.088], "
        "[-0.33333333333333337, -0.33333333333333337, 0.741333333333333], [-0.33333333333333337, "
        "0.33333333333333326, 0.528], [-0.33333333333333337, 1, 2.448]], [[0.33333333333333326, "
        "-1, -1.252], [0.33333333333333326, -0.33333333333333337, -0.665333333333333], "
        "[0.33333333333333326, 0.33333333333333326, -0.612], [0.33333333333333326, 1, -1.092]], "
        "[[1, -1, -2.392], [1, -0.33333333333333337, 1.128], [1, 0.33333333333333326, 1.448], [1, "
        "1, -1.432]]] }] }",
        "\"seeds\": [{ \"at\": [0.7, -0.1] }]");
    const struct {
        const char *lath;
        double length, ends[2][2];
    } rows[] = {{"A1", 1.64925485930873, {{1, -0.293187323746606}, {0.259139271335271, 1}}},
                {"B1", 1.93848433225599, {{0.444929530286729, -1}, {1, 0.221601414553004}}}};
    for (size_t k = 0; k < 2; k++) {
        const char *name = rows[k].lath;
        CHECK_NEAR(net_number(&made, name, "length"), rows[k].length, 1e-12, "%s", name);
        /* which way it runs does not matter here */
        const int turned = fabs(net_end(&made, name, "from", 0) - rows[k].ends[0][0]) > 0.1;
        for (int d = 0; d < 2; d++) {
            CHECK_NEAR(net_end(&made, name, "from", d), rows[k].ends[turned][d], 4e-12, "%s", name);
            CHECK_NEAR(net_end(&made, name, "to", d), rows[k].ends[1 - turned][d], 4e-12, "%s",
                       name);
        }
    }
    net_free(&made);
}

/* ---- geodesics of the catenoid ---- */

/* int k_n ds is the angle of a standing strip's pattern; r sin(angle to the meridian) is x_u . T. */
static void test_clairaut(void)
{
    made_net made = net_make(
        "geodesic", CATENOID_LONG,
        "\"seeds\": [{ \"at\": [0.5, 1], \"direction\": [0.38883256419833123, "
        "-0.9213084375055678] }], \"laths\": { \"strip\": \"standing\", \"width\": 0.01 }");
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    CHECK_NEAR(fabs(net_end(&made, "G1", "pattern_end", 2)), 0.879798887929786, 1e-12,
               "int k_n ds");
    net_free(&made);
    made = net_make("geodesic", CATENOID_LONG,
                    "\"seeds\": [{ \"at\": [0.2, -0.7], \"to\": [1.6, 0.9] }]");
    const taut_curve *curve = space_of(made.model, "G1");
    double c[2][3], x[3][3];
    CHECK(curve != NULL, "%s", made.error.message);
    taut_curve_eval(curve, taut_basis_lo(taut_curve_t(curve)), 1, c[0]);
    taut_surface_eval(taut_model_surface(made.model, 0), 0.2, -0.7, 1, x[0]);
    const double constant = c[1][0] * x[1][0] + c[1][1] * x[1][1] + c[1][2] * x[1][2];
    CHECK_NEAR(constant, 0.721481292187128, 1e-11, "c");
    net_free(&made);
}

/* ---- a spline ---- */

static double rounded(double value)
{
    return floor(value * 1e6 + 0.5) / 1e6;
}

/* Bicubic, with knots at 1, 2, 3 both ways. */
static void test_spline(void)
{
    enum { SIDE = 7 };
    static const double knots[SIDE + 4] = {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4};
    static const struct {
        const char *lath;
        double length, ends[2][2];
    } rows[] = {{"A1", 4.01099169810369, {{0, 2.353560165426}, {4, 2.262385720032}}},
                {"B1", 4.01714387456765, {{1.596462635634, 4}, {1.91078577486, 0}}},
                {"A1", 4.85035651950164, {{0, 0.5942257035006}, {3.169333389788, 4}}}};
    double points[SIDE][SIDE][3];
    taut_basis *basis = NULL;
    taut_surface *surface = NULL;
    taut_model *of = NULL;

    for (int i = 0; i < SIDE; i++) {
        for (int j = 0; j < SIDE; j++) {
            const double x = (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3;
            const double y = (knots[j + 1] + knots[j + 2] + knots[j + 3]) / 3;
            points[i][j][0] = rounded(x);
            points[i][j][1] = rounded(y);
            points[i][j][2] =
                rounded(0.2 * (x - 2) * (y - 2) + 0.04 * cos(1.1 * x) * sin(0.8 * y + 0.3) +
                        0.015 * (y - 2) * (y - 2));
        }
    }
    const taut_basis_spec spec = {
        .type = "bspline", .degree = 3, .knot_count = SIDE + 4, .knots = knots};
    taut_basis_new(&spec, SIDE, &basis, NULL);
    taut_surface_new("spline", basis, basis, points[0][0], NULL, &surface, NULL);
    taut_model_new(&of);
    taut_model_add_surface(of, surface);
    taut_basis_free(basis);
    for (size_t k = 0; k < 3; k++) {
        const taut_trace_seed seed = {.at = {1.7, 2.4}};
        const taut_trace_problem problem = {.model = of,
                                            .net = k < 2 ? TAUT_TRACE_ASYMPTOTIC
                                                         : TAUT_TRACE_PRINCIPAL,
                                            .seed_count = 1,
                                            .seeds = &seed};
        made_net made = {.status = TAUT_OK};
        const char *name = rows[k].lath;
        made.status = taut_trace_make(&problem, NULL, &made.model, &made.error);
        CHECK(made.status == TAUT_OK, "%s", made.error.message);
        CHECK_NEAR(net_number(&made, name, "length"), rows[k].length, 2e-12, "row %zu", k);
        const int turned = fabs(net_end(&made, name, "from", 0) - rows[k].ends[0][0]) +
                               fabs(net_end(&made, name, "from", 1) - rows[k].ends[0][1]) >
                           0.1;
        for (int d = 0; d < 2; d++) {
            CHECK_NEAR(net_end(&made, name, "from", d), rows[k].ends[turned][d], 2e-12, "row %zu",
                       k);
            CHECK_NEAR(net_end(&made, name, "to", d), rows[k].ends[1 - turned][d], 2e-12, "row %zu",
                       k);
        }
        net_free(&made);
    }
    taut_model_free(of);
}

int main(void)
{
    test_stations();
    test_edges();
    test_enneper();
    test_angle();
    test_scherk();
    test_cusps();
    test_torus();
    test_monkey();
    test_clairaut();
    test_spline();
    return check_failures != 0;
}
