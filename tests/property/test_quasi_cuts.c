/* test_quasi_cuts.c -- cutting c- and h- curves: against the quasi de Casteljau algorithm as it is
 * published, where its formulas have their limits, and what kinds of pieces come out. */
#include "check.h"

#include "core/constants.h"
#include "taut/operations.h"

#include <string.h>

static void random_points(int count, double *points)
{
    for (int i = 0; i < 3 * count; i++) {
        points[i] = random_in(-1, 1);
    }
}

static double distance(const double *a, const double *b)
{
    return fmax(fabs(a[0] - b[0]), fmax(fabs(a[1] - b[1]), fabs(a[2] - b[2])));
}

/* `part` is `curve` over its own range, with points of size 1. Parameters are rounded to u of the
 * upper end, and functions turn over a piece's length, or over 1 where they are exponentials. */
static void same_curve(const taut_curve *curve, const taut_curve *part, size_t n)
{
    const taut_basis *t = taut_curve_t(part);
    const double lo = taut_basis_lo(t), hi = taut_basis_hi(t);
    const double tolerance = TAUT_UNIT_ROUNDOFF * (64 + 8 * hi / fmin(hi - lo, 1));
    for (int i = 0; i <= 20; i++) {
        const double x = i == 20 ? hi : lo + (hi - lo) * i / 20;
        double p[3], q[3];
        CHECK(taut_curve_eval(curve, x, 0, p) == TAUT_OK, "case %zu", n);
        CHECK(taut_curve_eval(part, x, 0, q) == TAUT_OK, "case %zu", n);
        CHECK(distance(p, q) <= tolerance, "case %zu at %.17g: off by %g > %g", n, x,
              distance(p, q), tolerance);
    }
}

static void same_pieces(const taut_curve *curve, const taut_model *model, size_t n)
{
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        same_curve(curve, taut_model_curve(model, i), n);
    }
}

static void blend(const double *a, const double *b, double x, double *out)
{
    for (int c = 0; c < 3; c++) {
        out[c] = a[c] + (b[c] - a[c]) * x;
    }
}

static double k_of(double a, int hyperbolic)
{
    const double h = a / 2;
    return hyperbolic ? 1 / tanh(h) - h / (sinh(h) * sinh(h)) : h / (sin(h) * sin(h)) - 1 / tan(h);
}

/* The quasi de Casteljau algorithm ([XuWang2006] section 6) as it is written, with formulas in h/2
 * that are good for lengths of order 1: all six inner points of a cut. */
static void quasi_de_casteljau(const double *p, double a, double cut, int hyperbolic,
                               double low[4][3], double high[4][3])
{
    const double k = k_of(a, hyperbolic), k0 = k_of(cut, hyperbolic),
                 k1 = k_of(a - cut, hyperbolic);
    const double h = a / 2, g = hyperbolic ? cosh(a) - 1 : 1 - cos(a);
    const double m = hyperbolic ? pow(sinh(h), 3) / (h * cosh(h) - sinh(h))
                                : pow(sin(h), 3) / (sin(h) - h * cos(h));
    const double cot = hyperbolic ? 1 / tanh(cut / 2) - 1 / tanh(h) : 1 / tan(cut / 2) - 1 / tan(h);
    const double gamma = m * (k - k0) / (g * cot);
    const double x = k + gamma * (a - 2 * k);
    double middle[3];
    memcpy(low[0], p, sizeof low[0]);
    memcpy(high[3], p + 9, sizeof high[3]);
    blend(p, p + 3, k0 / k, low[1]);
    blend(p + 3, p + 6, gamma, middle);
    blend(p + 9, p + 6, k1 / k, high[2]);
    blend(low[1], middle, (cut - 2 * k0) / (x - k0), low[2]);
    blend(high[2], middle, (a - cut - 2 * k1) / (a - x - k1), high[1]);
    blend(low[2], high[1], k0 / (k0 + k1), low[3]);
    memcpy(high[0], low[3], sizeof high[0]);
}

static void test_quasi_de_casteljau(void)
{
    for (int trial = 0; trial < 400; trial++) {
        const int hyperbolic = random_int(0, 1);
        const double a = random_in(0.5, 3), cut = a * random_in(0.1, 0.9);
        const taut_basis_spec spec = {.type = hyperbolic ? "h-bezier" : "c-bezier",
                                      .alpha = hyperbolic ? 0 : a,
                                      .beta = hyperbolic ? a : 0};
        double points[12], low[4][3], high[4][3];
        taut_basis *basis = NULL;
        taut_curve *curve = NULL;
        taut_model *model = NULL;
        random_points(4, points);
        CHECK(taut_basis_new(&spec, 4, &basis, NULL) == TAUT_OK, "basis");
        CHECK(taut_curve_new("", basis, points, NULL, &curve, NULL) == TAUT_OK, "curve");
        CHECK(taut_curve_split(curve, cut, &model, NULL) == TAUT_OK, "split");
        quasi_de_casteljau(points, a, cut, hyperbolic, low, high);
        for (int i = 0; i < 4; i++) {
            const double *found = taut_curve_points(taut_model_curve(model, 0)) + 3 * i;
            const double *other = taut_curve_points(taut_model_curve(model, 1)) + 3 * i;
            /* the reference divides by k - k0 and the like, down to a/30, and by a^3 in m */
            CHECK(distance(found, low[i]) <= 1e-11, "a=%g cut=%g i=%d: %g", a, cut, i,
                  distance(found, low[i]));
            CHECK(distance(other, high[i]) <= 1e-11, "a=%g cut=%g i=%d: %g", a, cut, i,
                  distance(other, high[i]));
        }
        taut_basis_free(basis);
        taut_curve_free(curve);
        taut_model_free(model);
    }
}

/* Cuts and halves where formulas have their limits: pi, tiny and huge lengths, cuts at the ends. */
static void test_hard_cuts(void)
{
    const struct {
        const char *type;
        double length, cut;
    } cases[] = {{"c-bezier", 3.14159265358979311600, 1e-9},
                 {"c-bezier", 3.14159265358979311600, 3.14159265258979311},
                 {"c-bezier", 1e-8, 3e-9},
                 {"h-bezier", 300, 150},
                 {"h-bezier", 300, 1e-9},
                 {"h-bezier", 300, 299.9999},
                 {"h-bezier", 1e-8, 5e-9}};
    for (size_t n = 0; n < sizeof cases / sizeof cases[0]; n++) {
        taut_basis_spec spec = {.type = cases[n].type};
        double points[12];
        taut_basis *basis = NULL;
        taut_curve *curve = NULL, *halved = NULL;
        taut_model *model = NULL;
        taut_error error = {.message = ""};
        *(cases[n].type[0] == 'c' ? &spec.alpha : &spec.beta) = cases[n].length;
        random_points(4, points);
        CHECK(taut_basis_new(&spec, 4, &basis, NULL) == TAUT_OK, "%zu", n);
        CHECK(taut_curve_new("", basis, points, NULL, &curve, NULL) == TAUT_OK, "%zu", n);
        CHECK(taut_curve_split(curve, cases[n].cut, &model, &error) == TAUT_OK, "%zu: %s", n,
              error.message);
        same_pieces(curve, model, n);
        CHECK(taut_curve_refine(curve, &halved, &error) == TAUT_OK, "%zu: %s", n, error.message);
        same_curve(curve, halved, n);
        taut_basis_free(basis);
        taut_curve_free(curve);
        taut_curve_free(halved);
        taut_model_free(model);
    }
}

/* A c-bspline cut on a knot is two of its type, elsewhere all its segments. */
static void test_cut_kinds(void)
{
    const taut_basis_spec spec = {.type = "c-bspline", .alpha = 0.7, .segments = 4};
    double points[21];
    taut_basis *basis = NULL;
    taut_curve *curve = NULL;
    taut_model *model = NULL;
    random_points(7, points);
    CHECK(taut_basis_new(&spec, 7, &basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_curve_new("k", basis, points, NULL, &curve, NULL) == TAUT_OK, "curve");
    CHECK(taut_curve_split(curve, 2.1, &model, NULL) == TAUT_OK, "3 * 0.7 but for rounding");
    CHECK(taut_model_curve_count(model) == 2, "two");
    CHECK(taut_basis_span_count(taut_curve_t(taut_model_curve(model, 0))) == 3, "three segments");
    CHECK(strcmp(taut_curve_name(taut_model_curve(model, 1)), "k-1") == 0, "name");
    taut_model_free(model);
    CHECK(taut_curve_split(curve, 1, &model, NULL) == TAUT_OK, "off the knots");
    CHECK(taut_model_curve_count(model) == 5, "five");
    for (int i = 0; i < 5; i++) {
        const taut_basis *t = taut_curve_t(taut_model_curve(model, i));
        CHECK(strcmp(taut_basis_type(t), "c-bezier") == 0, "type %s", taut_basis_type(t));
    }
    taut_model_free(model);
    taut_basis_free(basis);
    taut_curve_free(curve);
}

int main(void)
{
    random_seed(20260107);
    test_quasi_de_casteljau();
    test_hard_cuts();
    test_cut_kinds();
    return check_failures != 0;
}
