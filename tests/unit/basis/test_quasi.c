/* test_quasi.c -- the c-, h- and ce- bases against ball arithmetic and their own end conditions.
 *
 * links: flint-arb flint mpfr gmp
 *
 * The reference is the matrix of [XuWang2006] sections 3 and 4 (corrected), which taut never uses:
 * it is badly conditioned, so it is taken at 2400 bits.
 */
#include "bases.h"
#include "check.h"
#include "shapes.h"

#include "core/constants.h"
#include "taut/basis.h"

#include <arb.h>
#include <arb_mat.h>
#include <stddef.h>

enum { BITS = 2400 };
static const double bound = 1e-14; /* the accuracy that taut/basis.h states */

/* s, c, 1-c, k, m of a segment; sinh and cosh when hyperbolic. */
typedef struct constants {
    arb_t a, s, c, g, k, m, f;
} constants;

static void constants_init(constants *x, double length, int hyperbolic)
{
    arb_init(x->a), arb_init(x->s), arb_init(x->c), arb_init(x->g);
    arb_init(x->k), arb_init(x->m), arb_init(x->f);
    arb_set_d(x->a, length);
    if (hyperbolic) {
        arb_sinh_cosh(x->s, x->c, x->a, BITS);
    } else {
        arb_sin_cos(x->s, x->c, x->a, BITS);
    }
    arb_sub_si(x->g, x->c, 1, BITS);
    arb_neg(x->g, x->g);
    arb_sub(x->f, x->a, x->s, BITS);
    arb_div(x->k, x->f, x->g, BITS);
    arb_mul_si(x->m, x->k, -2, BITS);
    arb_add(x->m, x->m, x->a, BITS);
    arb_div(x->m, x->s, x->m, BITS);
}

static void constants_clear(constants *x)
{
    arb_clear(x->a), arb_clear(x->s), arb_clear(x->c), arb_clear(x->g);
    arb_clear(x->k), arb_clear(x->m), arb_clear(x->f);
}

/* The quasi-Bezier matrix, 1/(a - s) included. */
static void bezier_matrix(arb_mat_t m, const constants *x)
{
    arb_t ak;
    arb_init(ak);
    arb_sub(ak, x->a, x->k, BITS);
    arb_mul(ak, ak, x->m, BITS); /* (a - k) m */
    arb_zero(arb_mat_entry(m, 3, 0));
    arb_one(arb_mat_entry(m, 3, 1));
    arb_set_si(arb_mat_entry(m, 3, 2), -1);
    arb_zero(arb_mat_entry(m, 3, 3));
    arb_mul(arb_mat_entry(m, 2, 0), x->k, x->m, BITS);
    arb_neg(arb_mat_entry(m, 2, 1), x->m);
    arb_set(arb_mat_entry(m, 2, 2), x->m);
    arb_neg(arb_mat_entry(m, 2, 3), arb_mat_entry(m, 2, 0));
    arb_neg(arb_mat_entry(m, 1, 0), ak);
    arb_set(arb_mat_entry(m, 1, 1), x->m);
    arb_sub(arb_mat_entry(m, 1, 2), x->g, x->m, BITS);
    arb_set(arb_mat_entry(m, 1, 3), ak);
    arb_set(arb_mat_entry(m, 0, 0), x->a);
    arb_set_si(arb_mat_entry(m, 0, 1), -1);
    arb_set(arb_mat_entry(m, 0, 2), x->c);
    arb_neg(arb_mat_entry(m, 0, 3), x->s);
    arb_mat_scalar_div_arb(m, m, x->f, BITS);
    arb_clear(ak);
}

/* The quasi-B-spline matrix, 1/(2 a (1 - c)) included. */
static void bspline_matrix(arb_mat_t m, const constants *x)
{
    arb_t one2c, twoc, scale;
    arb_init(one2c), arb_init(twoc), arb_init(scale);
    arb_mul_si(one2c, x->c, 2, BITS);
    arb_add_si(one2c, one2c, 1, BITS);
    arb_add_si(twoc, x->c, 2, BITS);
    arb_mat_zero(m);
    arb_set(arb_mat_entry(m, 0, 0), x->a);
    arb_set_si(arb_mat_entry(m, 0, 1), -1);
    arb_set(arb_mat_entry(m, 0, 2), x->c);
    arb_neg(arb_mat_entry(m, 0, 3), x->s);
    arb_mul(arb_mat_entry(m, 1, 0), x->a, x->c, BITS);
    arb_mul_si(arb_mat_entry(m, 1, 0), arb_mat_entry(m, 1, 0), -2, BITS);
    arb_set(arb_mat_entry(m, 1, 1), one2c);
    arb_neg(arb_mat_entry(m, 1, 2), one2c);
    arb_mul_si(arb_mat_entry(m, 1, 3), x->s, 2, BITS);
    arb_set(arb_mat_entry(m, 2, 0), x->a);
    arb_neg(arb_mat_entry(m, 2, 1), one2c);
    arb_set(arb_mat_entry(m, 2, 2), twoc);
    arb_neg(arb_mat_entry(m, 2, 3), x->s);
    arb_one(arb_mat_entry(m, 3, 1));
    arb_set_si(arb_mat_entry(m, 3, 2), -1);
    arb_mul(scale, x->a, x->g, BITS);
    arb_mul_si(scale, scale, 2, BITS);
    arb_mat_scalar_div_arb(m, m, scale, BITS);
    arb_clear(one2c), arb_clear(twoc), arb_clear(scale);
}

/* Column d: derivative d of (1, t, sin t, cos t) or (1, t, sinh t, cosh t). */
static void generators(arb_mat_t m, double t, int hyperbolic)
{
    arb_t s, c, x;
    arb_init(s), arb_init(c), arb_init(x);
    arb_set_d(x, t);
    if (hyperbolic) {
        arb_sinh_cosh(s, c, x, BITS);
    } else {
        arb_sin_cos(s, c, x, BITS);
    }
    arb_mat_zero(m);
    arb_one(arb_mat_entry(m, 0, 0));
    arb_set(arb_mat_entry(m, 1, 0), x);
    arb_one(arb_mat_entry(m, 1, 1));
    for (int d = 0; d < 4; d++) {
        const int odd = d % 2;
        const int minus_s = !hyperbolic && (d == 2 || d == 3); /* sin, cos, -sin, -cos */
        const int minus_c = !hyperbolic && (d == 1 || d == 2); /* cos, -sin, -cos, sin */
        arb_set(arb_mat_entry(m, 2, d), odd ? c : s);
        arb_set(arb_mat_entry(m, 3, d), odd ? s : c);
        if (minus_s) {
            arb_neg(arb_mat_entry(m, 2, d), arb_mat_entry(m, 2, d));
        }
        if (minus_c) {
            arb_neg(arb_mat_entry(m, 3, d), arb_mat_entry(m, 3, d));
        }
    }
    arb_clear(s), arb_clear(c), arb_clear(x);
}

/* expected[d][i] to double, from the matrix. */
static void reference(double length, double t, int hyperbolic, int bspline, double expected[4][4])
{
    arb_mat_t matrix, columns, product;
    constants x;
    arb_mat_init(matrix, 4, 4);
    arb_mat_init(columns, 4, 4);
    arb_mat_init(product, 4, 4);
    constants_init(&x, length, hyperbolic);
    if (bspline) {
        bspline_matrix(matrix, &x);
    } else {
        bezier_matrix(matrix, &x);
    }
    generators(columns, t, hyperbolic);
    arb_mat_mul(product, matrix, columns, BITS);
    for (int d = 0; d < 4; d++) {
        for (int i = 0; i < 4; i++) {
            const arb_struct *entry = arb_mat_entry(product, i, d);
            CHECK(arb_rel_accuracy_bits(entry) > 120 ||
                      mag_cmp_2exp_si(arb_radref(entry), -400) < 0,
                  "the reference has lost its digits");
            expected[d][i] = arf_get_d(arb_midref(entry), ARF_RND_NEAR);
        }
    }
    constants_clear(&x);
    arb_mat_clear(matrix);
    arb_mat_clear(columns);
    arb_mat_clear(product);
}

static const char *const types[2][2] = {{"c-bezier", "c-bspline"}, {"h-bezier", "h-bspline"}};

static double worst[2][2][4]; /* seen: by space, kind, order */

static void compare(double length, double t, int hyperbolic, int bspline)
{
    const taut_basis_spec spec = spec_of_spans(types[hyperbolic][bspline], length, 1, 0);
    taut_basis *basis = shape_basis(&spec);
    double found[4][4], expected[4][4], middle[4][4], end[4][4];

    if (basis == NULL) {
        return;
    }
    CHECK(taut_basis_eval(basis, 0, t, 3, &found[0][0]) == TAUT_OK, "t=%a", t);
    reference(length, t, hyperbolic, bspline, expected);
    reference(length, length / 2, hyperbolic, bspline, middle);
    reference(length, 0, hyperbolic, bspline, end);
    for (int d = 0; d < 4; d++) {
        double largest = 0;
        for (int i = 0; i < 4; i++) {
            /* near alpha = pi all second derivatives of a c-bspline vanish at the knots, all third
             * ones half way: the size there is that on the span. Elsewhere it is the size at t
             * itself, which asks more. */
            const double span = fmax(fabs(middle[d][i]), fabs(end[d][i]));
            largest = fmax(largest, fabs(expected[d][i]));
            largest = fmax(largest, !hyperbolic && bspline ? span : 0);
        }
        for (int i = 0; i < 4; i++) {
            const double error = fabs(found[d][i] - expected[d][i]) / largest;
            worst[hyperbolic][bspline][d] = fmax(worst[hyperbolic][bspline][d], error);
            CHECK(error <= bound,
                  "%s a=%.17g t=%.17g d=%d i=%d: found %.17g, expected %.17g (%.3g)",
                  taut_basis_type(basis), length, t, d, i, found[d][i], expected[d][i], error);
        }
    }
    taut_basis_free(basis);
}

/* Near an end, in the middle, or anywhere: where forms change is where they fail. */
static double random_parameter(double length)
{
    const double s = random_int(0, 1) ? random_in(0, 1) : random_log(1e-12, 1);
    const double t = fmin(length * s, length);
    return random_int(0, 1) ? t : length - t;
}

static void test_against_balls(void)
{
    for (int trial = 0; trial < 1500; trial++) {
        const double alpha = random_log(1e-8, TAUT_PI);
        const double below = random_int(0, 1) ? random_log(1e-8, 3) : TAUT_PI - random_log(1e-6, 3);
        const double beta = random_log(1e-8, 300);
        compare(alpha, random_parameter(alpha), 0, 0);
        compare(below, random_parameter(below), 0, 1);
        compare(beta, random_parameter(beta), 1, 0);
        compare(beta, random_parameter(beta), 1, 1);
    }
    compare(TAUT_PI, TAUT_PI, 0, 0);
    compare(TAUT_PI, TAUT_PI / 2, 0, 0);
    compare(700, 350, 1, 0);
    compare(700, 699, 1, 1);
    compare(0x1p-27, 0x1p-28, 0, 0);
    compare(0x1.fp-28, 0x1p-28, 1, 0);
    compare(1e-60, 3e-61, 1, 1);
    if (check_failures != 0) {
        for (int i = 0; i < 16; i++) {
            check_say("worst of space %d kind %d order %d: %.3g", i / 8, i / 4 % 2, i % 4,
                      (&worst[0][0][0])[i]);
        }
    }
}

/* A random basis of the five, and the shape numbers' size. */
static taut_basis *random_basis(double *size)
{
    const double x = random_in(-5, 5);
    const int has_range = random_int(0, 1);
    const double length = random_log(1e-3, 3);
    const int type = random_int(0, 4);
    taut_basis_spec spec = {.type = "ce-bezier"};
    *size = 1;
    if (type < 4) {
        const double h_length = type >= 2 ? random_log(1e-3, 300) : length;
        spec = spec_of_spans(types[type / 2][type % 2], h_length,
                             type % 2 == 1 ? random_int(1, 9) : 0, x);
        spec.has_range = has_range;
    } else {
        spec.alpha = random_in(-3, random_int(0, 1) ? 1 : 900), spec.beta = random_in(-3, 3);
        spec.gamma = random_in(-3, 1);
        *size = 1 + fmax(3, spec.alpha);
    }
    return shape_basis(&spec);
}

/* Sum of values 1 and of derivatives 0, within the stated accuracy of four functions. */
static void test_partition_of_unity(void)
{
    for (int trial = 0; trial < 3000; trial++) {
        double size = 1, values[4][4];
        taut_basis *basis = random_basis(&size);
        const int span = random_int(0, taut_basis_span_count(basis) - 1);
        const double *breaks = taut_basis_breaks(basis);
        const double t = random_in(breaks[span], breaks[span + 1]);
        CHECK(taut_basis_eval(basis, span, t, 3, &values[0][0]) == TAUT_OK, "t=%a", t);
        for (int d = 0; d < 4; d++) {
            double sum = 0, largest = 0;
            for (int i = 0; i < 4; i++) {
                sum += values[d][i];
                largest = fmax(largest, fabs(values[d][i]));
            }
            CHECK_NEAR(sum, d == 0, 4 * bound * largest, "%s d=%d t=%a", taut_basis_type(basis), d,
                       t);
        }
        taut_basis_free(basis);
    }
}

/* N_i(lo + t) = N_{n-1-i}(hi - t) for c-, h-, and non-negative: local functions reversed. */
static void test_symmetry_and_sign(void)
{
    for (int trial = 0; trial < 2000; trial++) {
        const double a = random_log(1e-8, 3), s = random_in(0, 1);
        const int bspline = random_int(0, 1), hyperbolic = random_int(0, 1);
        double up[4][4], down[4][4];
        const taut_basis_spec spec = spec_of_spans(types[hyperbolic][bspline], a, 1, 0);
        taut_basis *basis = shape_basis(&spec);
        CHECK(taut_basis_eval(basis, 0, a * s, 3, &up[0][0]) == TAUT_OK, "a=%a", a);
        CHECK(taut_basis_eval(basis, 0, a - a * s, 3, &down[0][0]) == TAUT_OK, "a=%a", a);
        for (int d = 0; d < 4; d++) {
            double largest = 0;
            for (int i = 0; i < 4; i++) {
                largest = fmax(largest, fabs(up[d][i]));
            }
            for (int i = 0; i < 4; i++) {
                CHECK_NEAR(up[d][i], d % 2 == 0 ? down[d][3 - i] : -down[d][3 - i],
                           2 * bound * largest, "a=%.17g s=%g d=%d i=%d", a, s, d, i);
                CHECK(d > 0 || up[0][i] >= -0x1p-50, "a=%a s=%a i=%d: %g", a, s, i, up[0][i]);
            }
        }
        taut_basis_free(basis);
    }
}

/* U_0(lo) = U_3(hi) = 1 exactly and U_0'(lo) = -1/k; at knots a spline's functions are
 * rho, 1 - 2 rho, rho and agree from both sides to the second derivative. */
static void test_ends_and_knots(void)
{
    for (int trial = 0; trial < 1000; trial++) {
        const int hyperbolic = random_int(0, 1);
        const double a = random_log(1e-6, hyperbolic ? 300 : 3.1);
        const taut_basis_spec one = spec_of_spans(types[hyperbolic][0], a, 0, 0);
        const taut_basis_spec many = spec_of_spans(types[hyperbolic][1], a, 4, 0);
        double left[4][4], right[4][4];
        taut_basis *bezier = shape_basis(&one), *bspline = shape_basis(&many);
        taut_basis_eval(bezier, 0, 0, 1, &left[0][0]);
        taut_basis_eval(bezier, 0, a, 1, &right[0][0]);
        CHECK(left[0][0] == 1 && left[0][1] == 0 && left[0][2] == 0 && left[0][3] == 0, "a=%a", a);
        CHECK(right[0][3] == 1 && right[0][2] == 0 && right[0][1] == 0 && right[0][0] == 0, "a=%a",
              a);
        /* k = (a - s)/(1 - c): h cot h form, good where a is not small */
        if (a > 0.1) {
            const double h = a / 2;
            const double k = hyperbolic ? 1 / tanh(h) - h / (sinh(h) * sinh(h))
                                        : h / (sin(h) * sin(h)) - 1 / tan(h);
            CHECK_NEAR(left[1][1], 1 / k, 1e-12 / k, "a=%a", a); /* the check cancels as a^-2 */
        }
        for (int i = 1; i < 4; i++) {
            const double t = taut_basis_breaks(bspline)[i];
            taut_basis_eval(bspline, i - 1, t, 3, &left[0][0]);
            taut_basis_eval(bspline, i, t, 3, &right[0][0]);
            for (int d = 0; d <= 2; d++) {
                double largest = fmax(fabs(left[d][1]), fmax(fabs(left[d][2]), fabs(left[d][3])));
                for (int f = 0; f < 3; f++) {
                    CHECK_NEAR(left[d][f + 1], right[d][f], 2 * bound * largest,
                               "a=%.17g knot %d d=%d f=%d", a, i, d, f);
                }
                CHECK(fabs(left[d][0]) <= bound * largest, "a=%a d=%d", a, d);
                CHECK(fabs(right[d][3]) <= bound * largest, "a=%a d=%d", a, d);
            }
        }
        taut_basis_free(bezier);
        taut_basis_free(bspline);
    }
}

/* The closed forms of [WangBai2018] section 2.1, and the cubic at (0, 0, 0). */
static void test_shape_numbers(void)
{
    for (int trial = 0; trial < 1000; trial++) {
        const double a = random_in(-3, 3), b = random_in(-3, 3), c = random_in(-3, 3);
        const double t = random_in(0, 1), u = 1 - t;
        const double expected[4] = {(1 - a * t) * u * u * u, (3 + a * u + b * t) * t * u * u,
                                    (3 - b * u + c * t) * t * t * u, (1 - c * u) * t * t * t};
        const double slopes[3] = {-(3 + a) * u * u * u - 3 * (1 - a) * u * u * t, 0,
                                  (3 + c) * t * t * t + 3 * (1 - c) * t * t * u};
        double found[2][4];
        taut_basis *basis =
            shape_basis(&(taut_basis_spec){.type = "ce-bezier", .alpha = a, .beta = b, .gamma = c});
        CHECK(taut_basis_degree(basis) == 4, "quartic");
        taut_basis_eval(basis, 0, t, 1, &found[0][0]);
        for (int i = 0; i < 4; i++) {
            CHECK_NEAR(found[0][i], expected[i], 4 * bound, "i=%d a=%g b=%g c=%g t=%g", i, a, b, c,
                       t);
        }
        CHECK_NEAR(found[1][0], slopes[0], 16 * bound, "a=%g t=%g", a, t);
        CHECK_NEAR(found[1][3], slopes[2], 16 * bound, "c=%g t=%g", c, t);
        taut_basis_free(basis);
    }
}

static void refuse(taut_basis_spec spec, taut_status expected, const char *where)
{
    taut_basis *basis = NULL;
    taut_error error = {.where = "", .message = ""};
    const taut_status status = taut_basis_new(&spec, 0, &basis, &error);
    int same = 1;
    for (int i = 0; where[i] != '\0' || error.where[i] != '\0'; i++) {
        if (where[i] != error.where[i]) {
            same = 0;
            break;
        }
    }
    CHECK(status == expected && same, "%s: status %d at %s, expected %d at %s; %s", spec.type,
          (int)status, error.where, (int)expected, where, error.message);
    CHECK(basis == NULL, "outputs are untouched on failure");
}

static void test_refusals(void)
{
    refuse((taut_basis_spec){.type = "c-bezier"}, TAUT_BAD_INPUT, "/alpha");
    refuse((taut_basis_spec){.type = "c-bezier", .alpha = -1}, TAUT_BAD_INPUT, "/alpha");
    refuse((taut_basis_spec){.type = "c-bezier", .alpha = 3.15}, TAUT_BAD_INPUT, "/alpha");
    refuse((taut_basis_spec){.type = "c-bezier", .alpha = nan("")}, TAUT_BAD_INPUT, "/alpha");
    refuse((taut_basis_spec){.type = "c-bezier", .alpha = 1e-300}, TAUT_BAD_INPUT, "/alpha");
    refuse((taut_basis_spec){.type = "c-bezier", .alpha = 1, .beta = 1}, TAUT_BAD_INPUT, "");
    refuse((taut_basis_spec){.type = "c-bezier", .alpha = 1, .has_range = 1, .range = {0, 1.1}},
           TAUT_BAD_INPUT, "/range");
    refuse(
        (taut_basis_spec){
            .type = "c-bezier", .alpha = 1, .has_range = 1, .range = {1e15, 1e15 + 1}},
        TAUT_BAD_INPUT, "/range");
    refuse((taut_basis_spec){.type = "c-bspline", .alpha = TAUT_PI, .segments = 2},
           TAUT_NO_SOLUTION, "/alpha");
    refuse((taut_basis_spec){.type = "c-bspline", .alpha = 4, .segments = 2}, TAUT_NO_SOLUTION,
           "/alpha");
    refuse((taut_basis_spec){.type = "c-bspline", .alpha = -4, .segments = 2}, TAUT_BAD_INPUT,
           "/alpha");
    refuse((taut_basis_spec){.type = "c-bspline", .alpha = 1}, TAUT_BAD_INPUT, "/segments");
    refuse((taut_basis_spec){.type = "c-bspline", .alpha = 1, .segments = TAUT_COUNT_MAX},
           TAUT_BAD_INPUT, "/segments");
    refuse((taut_basis_spec){.type = "h-bezier", .beta = 0}, TAUT_BAD_INPUT, "/beta");
    refuse((taut_basis_spec){.type = "h-bezier", .beta = 701}, TAUT_BAD_INPUT, "/beta");
    refuse((taut_basis_spec){.type = "h-bspline", .beta = 1, .segments = -1}, TAUT_BAD_INPUT,
           "/segments");
    refuse(
        (taut_basis_spec){
            .type = "h-bspline", .beta = 1, .segments = 3, .has_range = 1, .range = {0, 2}},
        TAUT_BAD_INPUT, "/range");
    refuse((taut_basis_spec){.type = "ce-bezier", .gamma = 1001}, TAUT_BAD_INPUT, "/gamma");
    refuse((taut_basis_spec){.type = "ce-bezier", .beta = HUGE_VAL}, TAUT_BAD_INPUT, "/beta");
}

int main(void)
{
    random_seed(20260103);
    test_against_balls();
    test_partition_of_unity();
    test_symmetry_and_sign();
    test_ends_and_knots();
    test_shape_numbers();
    test_refusals();
    flint_cleanup();
    return check_failures != 0;
}
