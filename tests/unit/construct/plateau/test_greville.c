/* test_greville.c -- the parameters of control points are the coefficients of the function t.
 *
 * links: flint-arb flint mpfr gmp
 */
#include "bases.h"
#include "check.h"
#include "shapes.h"

#include "construct/plateau/directions.h"
#include "core/constants.h"

#include <arb.h>
#include <string.h>

enum { BITS = 2400, COUNT_MAX = 40 };

static taut_basis *random_basis(double *length)
{
    static double knots[64];
    static const char *const types[] = {"c-bezier", "c-bspline", "h-bezier", "h-bspline"};
    const double lo = random_in(-3, 3);
    const int type = random_int(0, 5);
    *length = random_log(1e-3, type < 2 ? 3 : 300);
    const int segments = type % 2 == 1 ? random_int(1, 8) : 0;
    taut_basis_spec spec = {.type = "bspline"};
    if (type < 4) {
        spec = spec_of_spans(types[type], *length, segments, lo);
        spec.has_range = 1;
    } else if (type == 4) {
        return shape_bezier(random_int(1, 9), lo, lo + *length);
    } else {
        spec.degree = random_int(1, 5);
        spec.knots = knots;
        for (int i = 0; i <= spec.degree; i++) {
            knots[spec.knot_count++] = -2;
        }
        for (int i = random_int(0, 8); i > 0; i--) {
            const double last = knots[spec.knot_count - 1];
            knots[spec.knot_count++] = last + random_in(0.01, 1);
        }
        for (int i = 0; i <= spec.degree; i++) {
            knots[spec.knot_count++] = 10;
        }
    }
    return shape_basis(&spec);
}

/* sum t_i N_i(t) = t, the outermost points of c- and h-bsplines taken a segment further out. */
static void test_reproduce(void)
{
    for (int trial = 0; trial < 2000; trial++) {
        double length = 0, found[COUNT_MAX], values[COUNT_MAX];
        taut_basis *basis = random_basis(&length);
        const int count = taut_basis_count(basis), local = taut_basis_local(basis);
        const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
        taut_plateau_greville(basis, found);
        CHECK(found[0] == lo && found[count - 1] == hi, "the ends are met");
        for (int i = 1; i < count; i++) {
            CHECK(found[i - 1] <= found[i], "%s: they increase", taut_basis_type(basis));
        }
        if (strstr(taut_basis_type(basis), "-bspline") != NULL) {
            found[0] -= length;
            found[count - 1] += length;
        }
        const double t = random_in(lo, hi), size = fmax(fabs(lo), fabs(hi)) + length;
        const int span = taut_basis_span(basis, t), first = taut_basis_first(basis, span);
        double sum = 0;
        CHECK(taut_basis_eval(basis, span, t, 0, values) == TAUT_OK, "t=%g", t);
        for (int a = 0; a < local; a++) {
            sum += values[a] * found[first + a];
        }
        /* each value is good to 1e-14 of the largest (taut/basis.h) */
        CHECK_NEAR(sum, t, local * 1e-14 * size, "%s t=%.17g", taut_basis_type(basis), t);
        taut_basis_free(basis);
    }
}

/* k = (a - sin a)/(1 - cos a) or (sinh a - a)/(cosh a - 1), to 50 digits and more. */
static double exact_k(double length, int hyperbolic)
{
    arb_t a, s, c;
    arb_init(a), arb_init(s), arb_init(c);
    arb_set_d(a, length);
    if (hyperbolic) {
        arb_sinh_cosh(s, c, a, BITS);
    } else {
        arb_sin_cos(s, c, a, BITS);
    }
    arb_sub(s, a, s, BITS);
    arb_sub_si(c, c, 1, BITS);
    arb_neg(c, c);
    arb_div(s, s, c, BITS);
    CHECK(arb_rel_accuracy_bits(s) > 170, "the reference has lost its digits");
    const double k = arf_get_d(arb_midref(s), ARF_RND_NEAR);
    arb_clear(a), arb_clear(s), arb_clear(c);
    return k;
}

static void test_against_balls(void)
{
    for (int trial = 0; trial < 2000; trial++) {
        const int hyperbolic = trial % 2;
        const double length = random_log(1e-8, hyperbolic ? 700 : TAUT_PI);
        const taut_basis_spec spec = {.type = hyperbolic ? "h-bezier" : "c-bezier",
                                      .alpha = hyperbolic ? 0 : length,
                                      .beta = hyperbolic ? length : 0};
        const double k = exact_k(length, hyperbolic);
        taut_basis *basis = shape_basis(&spec);
        double found[4];
        taut_plateau_greville(basis, found);
        CHECK_NEAR(found[1], k, 8 * 0x1p-53 * k, "%s of %.17g", spec.type, length);
        CHECK_NEAR(found[2], length - k, 8 * 0x1p-53 * length, "%s of %.17g", spec.type, length);
        taut_basis_free(basis);
    }
}

static void test_ce(void)
{
    const taut_basis_spec spec = {.type = "ce-bezier", .alpha = 1, .beta = -2};
    taut_basis *basis = shape_basis(&spec);
    double found[4];
    taut_plateau_greville(basis, found);
    for (int i = 0; i < 4; i++) {
        CHECK_NEAR(found[i], i / 3.0, 0x1p-52, "i=%d", i);
    }
    taut_basis_free(basis);
}

int main(void)
{
    random_seed(20260714);
    test_reproduce();
    test_against_balls();
    test_ce();
    flint_cleanup();
    return check_failures != 0;
}
