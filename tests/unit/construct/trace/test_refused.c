/* test_refused.c -- nets that there are not, and what is said: reasons, numbers and places, and that what the
 * message says works does work. Words and values that are wrong are in tests/cli/test_trace.sh, slots and strips in test_laths.c.
 */
#include "check.h"
#include "nets.h"

#include <string.h>

/* Graphs of degree 2 x 2 over [-1, 1]^2, by the three heights of each row. */
#define GRAPH(a, b, c, d, e, f, g, h, i)                                                           \
    "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 2, \"range\": "    \
    "[-1, 1] }, \"v\": { \"type\": \"bezier\", \"degree\": 2, \"range\": [-1, 1] }, \"points\": "  \
    "[[[-1, -1, " #a "], [-1, 0, " #b "], [-1, 1, " #c "]], [[0, -1, " #d "], [0, 0, " #e          \
    "], [0, 1, " #f "]], [[1, -1, " #g "], [1, 0, " #h "], [1, 1, " #i "]]] }] }"
#define PLANE GRAPH(0, 0, 0, 0, 0, 0, 0, 0, 0)
#define CYLINDER GRAPH(1, 1, 1, -1, -1, -1, 1, 1, 1) /* z = x^2 */
#define BOWL GRAPH(2, 0, 2, 0, -2, 0, 2, 0, 2)       /* z = x^2 + y^2 */
/* An eighth of a sphere; u0 is its pole. */
#define SPHERE                                                                                     \
    "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 2 }, \"v\": { "    \
    "\"type\": \"bezier\", \"degree\": 2 }, \"points\": [[[0, 0, 1], [0, 0, 1], [0, 0, 1]], [[1, " \
    "0, 1], [1, 1, 1], [0, 1, 1]], [[1, 0, 0], [1, 1, 0], [0, 1, 0]]], \"weights\": [[1, "         \
    "0.7071067811865476, 1], [0.7071067811865476, 0.5, 0.7071067811865476], [1, "                  \
    "0.7071067811865476, 1]] }] }"
/* y = (v - 0.5)^2, z = u y: there is no normal along the fold v = 0.5. */
#define FOLD                                                                                       \
    "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 1 }, \"v\": { "    \
    "\"type\": \"bezier\", \"degree\": 2 }, \"points\": [[[0, 0.25, 0], [0, -0.25, 0], [0, 0.25, " \
    "0]], [[1, 0.25, 0.25], [1, -0.25, -0.25], [1, 0.25, 0.25]]] }] }"
#define BIG                                                                                        \
    "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 1 }, \"v\": { "    \
    "\"type\": \"bezier\", \"degree\": 1 }, \"points\": [[[0, 0, 0], [0, 1e70, 0]], [[1e70, 0, "   \
    "0], [1e70, 1e70, 1e70]]] }] }"

typedef struct row {
    const char *net, *surface, *members, *reason, *where, *says;
} row;

static void test_reasons(void)
{
    static const row rows[] = {
        {"asymptotic", BOWL, "\"seeds\": [{ \"at\": [0.5, 0.5] }]", "elliptic", "/seeds/0",
         "nowhere negative"},
        {"asymptotic", BOWL, "\"seeds\": [{ \"edge\": \"v0\", \"count\": 3 }]", "elliptic",
         "/seeds", "nowhere negative"},
        {"asymptotic", SPHERE, "\"seeds\": [{ \"at\": [0.5, 0.5] }]", "elliptic", "/seeds/0", ""},
        {"asymptotic", CYLINDER, "\"seeds\": [{ \"at\": [0.5, 0.5] }]", "parabolic", "/seeds/0",
         ""},
        {"asymptotic", CYLINDER, "", "parabolic", "/seeds", ""},
        {"asymptotic", PLANE, "\"seeds\": [{ \"at\": [0.5, 0.5] }]", "flat", "/seeds/0",
         "(0.5, 0.5)"},
        {"principal", PLANE, "", "flat", "/seeds", ""},
        {"principal", SPHERE, "\"seeds\": [{ \"at\": [0.5, 0.5] }]", "umbilic", "/seeds/0", ""},
        {"principal", BOWL, "\"seeds\": [{ \"at\": [0, 0] }]", "umbilic", "/seeds/0", "(0, 0)"},
        {"isoparametric", SPHERE, "\"seeds\": [{ \"at\": [0, 0.5] }]", "singular", "/seeds/0",
         "(0, 0.5)"},
        {"geodesic", SPHERE, "\"seeds\": [{ \"at\": [0, 0.5], \"direction\": [1, 0] }]", "singular",
         "/seeds/0", ""},
        {"isoparametric", FOLD, "\"families\": [\"u\"], \"seeds\": [{ \"at\": [0.5, 0.1] }]",
         "singular", "/seeds", "near (0.5, 0.499999)"},
        {"asymptotic", BIG, "", "extreme-size", "/of", "1e+70"},
        {"asymptotic", BILINEAR, "\"seeds\": [{ \"cell\": 1e-4 }]", "too-many-laths", "/seeds",
         "2000"},
        {"isoparametric", BILINEAR,
         "\"seeds\": [{ \"edge\": \"v0\", \"count\": 1000 }, { \"edge\": \"u0\", \"count\": 1000 "
         "}, "
         "{ \"line\": [[-0.99, 0.9], [0.99, 0.9]], \"count\": 9 }]",
         "too-many-laths", "/seeds", "2000"}};

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        made_net made = net_make(rows[k].net, rows[k].surface, rows[k].members);
        CHECK(made.status == TAUT_NO_SOLUTION, "row %zu: %d %s", k, made.status,
              made.error.message);
        CHECK(strcmp(made.error.reason, rows[k].reason) == 0, "row %zu: %s", k, made.error.reason);
        CHECK(strcmp(made.error.where, rows[k].where) == 0, "row %zu: %s", k, made.error.where);
        CHECK(strstr(made.error.message, rows[k].says) != NULL, "row %zu: %s", k,
              made.error.message);
        CHECK(made.model == NULL, "row %zu", k);
        net_free(&made);
    }
}

/* A bend of a millionth of the size: no step is short enough for a geodesic that comes to it. */
static void test_stalled(void)
{
    static const char surface[] =
        "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 2 }, \"v\": { "
        "\"type\": \"bezier\", \"degree\": 1 }, \"points\": [[[0, 0, 0], [0, 1, 0.3]], [[1, 0, 0], "
        "[1, "
        "1, 0.1]], [[1, 0, 1], [1, 1, 1.2]]], \"weights\": [[1, 1], [1e-8, 1e-8], [1, 1]] }] }";
    for (int threads = 1; threads <= 2; threads++) {
        made_net made =
            net_make_by("geodesic", surface,
                        "\"seeds\": [{ \"at\": [0.3, 0.5], \"direction\": [1, 0.2] }]", threads);
        double at[2] = {0, 0};
        const char *beyond = strstr(made.error.message, "beyond (");
        CHECK(made.status == TAUT_NOT_CONVERGED, "%d %s", made.status, made.error.message);
        CHECK(strcmp(made.error.reason, "stalled") == 0, "%s", made.error.reason);
        CHECK(beyond != NULL && sscanf(beyond, "beyond (%lf, %lf)", &at[0], &at[1]) == 2 &&
                  at[0] > 0.99 && at[0] <= 1 && at[1] > 0.5 && at[1] < 1,
              "%s", made.error.message);
        CHECK(made.model == NULL, "no net");
        net_free(&made);
    }
}

/* K > 0 at the seed: the place that the message names is one where there are curves. */
static void test_elliptic(void)
{
    /* z = x^2 + y^2 (1 - y): K > 0 where y < 1/3 */
    static const char surface[] =
        "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 2, \"range\": "
        "[-1, 1] }, \"v\": { \"type\": \"bezier\", \"degree\": 3 }, \"points\": [[[-1, 0, 1], [-1, "
        "0.3333333333333333, 1], [-1, 0.6666666666666666, 1.3333333333333333], [-1, 1, 1]], [[0, "
        "0, -1], [0, 0.3333333333333333, -1], [0, 0.6666666666666666, -0.6666666666666666], [0, 1, "
        "-1]], [[1, 0, 1], [1, 0.3333333333333333, 1], [1, 0.6666666666666666, "
        "1.3333333333333333], [1, 1, 1]]] }] }";
    made_net made = net_make("asymptotic", surface, "\"seeds\": [{ \"at\": [0, 0.1] }]");
    const char *named = strstr(made.error.message, "that has it is (");
    double at[2] = {0, 0};
    char members[120];

    CHECK(strcmp(made.error.reason, "elliptic") == 0, "%s", made.error.message);
    const double slope = 2 * 0.1 - 3 * 0.1 * 0.1;
    CHECK_NEAR(made.error.found, 2 * (2 - 6 * 0.1) / pow(1 + slope * slope, 2), 1e-13, "K");
    CHECK(named != NULL && sscanf(named, "that has it is (%lf, %lf)", &at[0], &at[1]) == 2, "%s",
          made.error.message);
    CHECK(at[1] > 1.0 / 3 && at[1] < 0.36, "v = %g", at[1]);
    net_free(&made);
    snprintf(members, sizeof members, "\"seeds\": [{ \"at\": [%.17g, %.17g] }]", at[0], at[1]);
    made = net_make("asymptotic", surface, members);
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    net_free(&made);
    /* a single seed of several is left out */
    made = net_make(
        "asymptotic", surface,
        "\"seeds\": [{ \"line\": [[0, 0], [0, 1]], \"count\": 3, \"by\": \"parameter\" }]");
    CHECK(net_count(&made, "left_out") == 2, "%d left out", net_count(&made, "left_out"));
    CHECK(net_count(&made, "warnings") == 1, "%d warnings", net_count(&made, "warnings"));
    net_free(&made);
}

/* A piece without crossings is not split: the sheet that the message names is large enough. */
static void test_sheet(void)
{
    char members[300];
    double size = 1;

    for (int round = 0; round < 2; round++) {
        snprintf(members, sizeof members,
                 "\"seeds\": [{ \"at\": [0.5, 0.35], \"family\": \"+\" }], \"laths\": { \"strip\": "
                 "\"standing\", \"width\": 0.1 }, \"sheet\": { \"size\": [%.17g, 0.5] }",
                 size);
        made_net made = net_make("asymptotic", BONNET("0"), members);
        CHECK(made.status == (round == 0 ? TAUT_NO_SOLUTION : TAUT_OK), "%s", made.error.message);
        CHECK(round == 1 || strcmp(made.error.reason, "sheet") == 0, "%s", made.error.reason);
        CHECK(round == 1 || made.error.limit > 1, "%g", made.error.limit);
        size = made.error.limit;
        net_free(&made);
    }
}

int main(void)
{
    test_reasons();
    test_stalled();
    test_elliptic();
    test_sheet();
    return check_failures != 0;
}
