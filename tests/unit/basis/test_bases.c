/* test_bases.c -- what every basis must do: sum to 1, agree with its own difference quotients. */
#include "bases.h"
#include "check.h"

#include "core/constants.h"
#include "taut/basis.h"

#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

static taut_basis *random_basis(void)
{
    double knots[256];
    taut_basis_spec spec = {.type = "bspline", .degree = random_int(1, 8)};
    taut_basis *basis = NULL;
    taut_error error;
    int functions = 0;
    if (random_int(0, 3) == 0) {
        spec.type = "bezier";
        spec.has_range = 1;
        spec.range[0] = random_in(-3, 3);
        spec.range[1] = spec.range[0] + random_log(1e-3, 10);
    } else {
        spec.knot_count = random_knots(spec.degree, 8, random_in(-2, 2), knots);
        functions = spec.knot_count - spec.degree - 1;
        spec.knots = knots;
    }
    CHECK(taut_basis_new(&spec, functions, &basis, &error) == TAUT_OK, "%s", error.message);
    return basis;
}

/* Sum of values 1, of derivatives 0: bound 4 (p+1) u for values, scaled by the size of the
 * derivatives for the others. */
static void test_partition_of_unity(void)
{
    for (int trial = 0; trial < 2000; trial++) {
        taut_basis *basis = random_basis();
        const int local = taut_basis_local(basis);
        const int span = random_int(0, taut_basis_span_count(basis) - 1);
        const double *breaks = taut_basis_breaks(basis);
        const double t = random_in(breaks[span], breaks[span + 1]);
        double values[4 * 16];
        CHECK(taut_basis_eval(basis, span, t, 3, values) == TAUT_OK, "t=%a", t);
        for (int k = 0; k <= 3; k++) {
            double sum = 0, size = 0;
            for (int a = 0; a < local; a++) {
                sum += values[k * local + a];
                size += fabs(values[k * local + a]);
            }
            CHECK_NEAR(sum, k == 0, 8 * local * TAUT_UNIT_ROUNDOFF * size, "k=%d local=%d t=%a", k,
                       local, t);
        }
        taut_basis_free(basis);
    }
}

/* The span of a place, of knots as uneven as they come: at its beginning, inside, and next to its end. */
static void test_spans(void)
{
    for (int trial = 0; trial < 400; trial++) {
        taut_basis *basis = random_basis();
        const double *breaks = taut_basis_breaks(basis);
        const int count = taut_basis_span_count(basis);
        for (int span = 0; span < count; span++) {
            const double places[] = {breaks[span], random_in(breaks[span], breaks[span + 1]),
                                     nextafter(breaks[span + 1], breaks[span])};
            for (int k = 0; k < 3; k++) {
                CHECK(taut_basis_span(basis, places[k]) == span, "%a is in span %d, found %d",
                      places[k], span, taut_basis_span(basis, places[k]));
            }
        }
        CHECK(taut_basis_span(basis, breaks[count]) == count - 1, "the end is in the last span");
        taut_basis_free(basis);
    }
}

/* The derivative of order k against the central difference of order k-1. */
static void test_derivatives(void)
{
    for (int trial = 0; trial < 500; trial++) {
        taut_basis *basis = random_basis();
        const int local = taut_basis_local(basis);
        const int span = random_int(0, taut_basis_span_count(basis) - 1);
        const double *breaks = taut_basis_breaks(basis);
        const double width = breaks[span + 1] - breaks[span];
        const double t = breaks[span] + width * random_in(0.3, 0.7);
        const double h = 1e-5 * width;
        double at[64], up[64], down[64];
        taut_basis_eval(basis, span, t, 3, at);
        taut_basis_eval(basis, span, t + h, 3, up);
        taut_basis_eval(basis, span, t - h, 3, down);
        for (int k = 1; k <= 3; k++) {
            double size = 0;
            for (int a = 0; a < local; a++) {
                size = fmax(size, fabs(up[(k - 1) * local + a]));
                size = fmax(size, width * fabs(at[k * local + a]));
            }
            for (int a = 0; a < local; a++) {
                const int i = (k - 1) * local + a;
                /* truncation h^2 p^3 and rounding u/h, both relative */
                CHECK_NEAR(at[k * local + a], (up[i] - down[i]) / (2 * h), 1e-6 * size / width,
                           "k=%d a=%d local=%d", k, a, local);
            }
        }
        taut_basis_free(basis);
    }
}

/* The form without the outermost knots means the same basis. */
static void test_short_knots(void)
{
    const double knots[] = {0, 0, 0, 0, 0.5, 1, 1, 1, 1};
    taut_basis_spec full = {.type = "bspline", .degree = 3, .knot_count = 9, .knots = knots};
    taut_basis_spec cut = {.type = "bspline", .degree = 3, .knot_count = 7, .knots = knots + 1};
    taut_basis_spec even = {.type = "bspline", .degree = 3, .count = 5};
    taut_basis *a = NULL, *b = NULL, *c = NULL;
    CHECK(taut_basis_new(&full, 5, &a, NULL) == TAUT_OK, "full");
    CHECK(taut_basis_new(&cut, 5, &b, NULL) == TAUT_OK, "cut");
    CHECK(taut_basis_new(&even, 5, &c, NULL) == TAUT_OK, "uniform");
    CHECK(taut_basis_equal(a, b) && taut_basis_equal(a, c), "the three are one basis");
    taut_basis_free(a);
    taut_basis_free(b);
    taut_basis_free(c);
}

static void refuse(taut_basis_spec spec, int functions, const char *where)
{
    taut_basis *basis = NULL;
    taut_error error = {.where = ""};
    CHECK(taut_basis_new(&spec, functions, &basis, &error) == TAUT_BAD_INPUT, "expected %s", where);
    CHECK(basis == NULL, "outputs are untouched on failure");
    for (int i = 0; where[i] != '\0' || error.where[i] != '\0'; i++) {
        if (where[i] != error.where[i]) {
            CHECK(0, "where is %s, expected %s", error.where, where);
            break;
        }
    }
}

static void test_refusals(void)
{
    const double tear[] = {0, 0, 0, 1, 1, 1, 2, 2, 2};
    const double back[] = {0, 0, 0, 1, 0.5, 2, 2, 2};
    const double loose[] = {0, 0, 1, 2, 3, 3, 3};
    const double nothing[] = {1, 1, 1, 1, 1, 1};
    const double narrow[] = {0, 0, 0, 3e-323, 1, 1, 1};
    const double far[] = {0, 0, 0, 1e300, 1e300, 1e300};
    const double broken[] = {0, 0, 0, NAN, 1, 1, 1};
    const double begun[] = {0, 0, 0, 0, 1, 1, 1}, ended[] = {0, 0, 0, 1, 1, 1, 1};
    taut_basis *basis = NULL;
    CHECK(taut_basis_new(NULL, 0, &basis, NULL) == TAUT_BAD_ARGUMENT && basis == NULL, "no spec");
    CHECK(taut_basis_new(&(taut_basis_spec){.type = "bezier", .degree = 1}, 0, NULL, NULL) ==
              TAUT_BAD_ARGUMENT,
          "no place");
    refuse((taut_basis_spec){.type = "bspline", .degree = 2, .knots = broken, .knot_count = 7}, 4,
           "/knots/3");
    refuse((taut_basis_spec){.type = "bspline", .degree = 2, .knots = begun, .knot_count = 7}, 4,
           "/knots");
    refuse((taut_basis_spec){.type = "bspline", .degree = 2, .knots = ended, .knot_count = 7}, 4,
           "/knots");
    refuse((taut_basis_spec){.type = "bspline", .degree = 2, .knots = far, .knot_count = -6}, 3,
           "/knots");
    refuse((taut_basis_spec){.type = "bspline",
                             .degree = 2,
                             .knots = far, /* not read */
                             .knot_count = TAUT_COUNT_MAX + 2 * TAUT_DEGREE_MAX + 1},
           0, "/knots");
    refuse((taut_basis_spec){.type = "bspline", .degree = 2, .knots = far, .knot_count = 6},
           INT_MAX, "");
    refuse((taut_basis_spec){.type = "bspline", .degree = 2, .knots = narrow, .knot_count = 7}, 4,
           "/knots");
    refuse((taut_basis_spec){.type = "bspline", .degree = 2, .knots = far, .knot_count = 6}, 3,
           "/knots");
    refuse((taut_basis_spec){.type = "bezier"}, 0, "/degree");
    refuse((taut_basis_spec){.type = "bezier", .degree = TAUT_DEGREE_MAX + 1}, 0, "/degree");
    refuse((taut_basis_spec){.type = "nonsense"}, 0, "/type");
    refuse((taut_basis_spec){.type = "bezier", .degree = 2, .has_range = 1, .range = {1, 1}}, 0,
           "/range");
    refuse((taut_basis_spec){.type = "bspline", .degree = 2, .knots = tear, .knot_count = 9}, 6,
           "/knots/5");
    refuse((taut_basis_spec){.type = "bspline", .degree = 2, .knots = back, .knot_count = 8}, 5,
           "/knots/4");
    refuse((taut_basis_spec){.type = "bspline", .degree = 2, .knots = loose, .knot_count = 7}, 4,
           "/knots");
    refuse((taut_basis_spec){.type = "bspline", .degree = 2, .knots = nothing, .knot_count = 6}, 3,
           "/knots");
    refuse((taut_basis_spec){.type = "bspline", .degree = 2, .knots = loose, .knot_count = 7}, 9,
           "/knots");
    refuse((taut_basis_spec){.type = "bspline", .degree = 3, .count = 3}, 0, "/count");
}

/* The word says what is wrong; a status can have several. */
static void test_reasons(void)
{
    static const double falling[] = {0, 0, 1, 0.5, 2, 2}, open_ends[] = {0, 1, 2, 3, 4, 5},
                        torn[] = {0, 0, 1, 1, 2, 2}, tiny[] = {0, 0, 1e-300, 1, 1};
    const struct {
        taut_basis_spec spec;
        taut_status status;
        const char *reason;
    } cases[] = {
        {{.type = "spline"}, TAUT_BAD_INPUT, "name"},
        {{.type = "bezier", .degree = 3, .alpha = 1}, TAUT_BAD_INPUT, "unknown-member"},
        {{.type = "bezier", .degree = 3, .has_range = 1, .range = {1, 0}}, TAUT_BAD_INPUT, "value"},
        {{.type = "bspline", .degree = 1}, TAUT_BAD_INPUT, "conflict"},
        {{.type = "bspline", .degree = 3, .count = 2}, TAUT_BAD_INPUT, "size"},
        {{.type = "bspline", .degree = 1, .knots = falling, .knot_count = 6},
         TAUT_BAD_INPUT,
         "knots"},
        {{.type = "bspline", .degree = 2, .knots = open_ends, .knot_count = 6},
         TAUT_BAD_INPUT,
         "knots"},
        {{.type = "bspline", .degree = 1, .knots = torn, .knot_count = 6}, TAUT_BAD_INPUT, "knots"},
        {{.type = "bspline", .degree = 1, .knots = tiny, .knot_count = 5},
         TAUT_BAD_INPUT,
         "short-span"},
        {{.type = "c-bspline", .alpha = 4, .segments = 2}, TAUT_NO_SOLUTION, "dependent"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        taut_basis *basis = NULL;
        taut_error error = {.reason = ""};
        const taut_status status = taut_basis_new(&cases[i].spec, 0, &basis, &error);
        CHECK(status == cases[i].status && strcmp(error.reason, cases[i].reason) == 0,
              "case %d: %s, expected %s; %s", (int)i, error.reason, cases[i].reason, error.message);
        CHECK(basis == NULL, "outputs are untouched on failure");
    }
}

int main(void)
{
    random_seed(20260101);
    test_partition_of_unity();
    test_spans();
    test_derivatives();
    test_short_knots();
    test_refusals();
    test_reasons();
    return check_failures != 0;
}
