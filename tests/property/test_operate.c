/* test_operate.c -- exact operations leave every point where it was, on random legal input of all
 * types; refusals. */
#include "bases.h"
#include "check.h"

#include "core/constants.h"
#include "taut/operations.h"

#include <stdlib.h>
#include <string.h>

enum { BEZIER, BSPLINE, C_BEZIER, C_BSPLINE, H_BEZIER, H_BSPLINE, CE_BEZIER, TYPES };
static const char *const type_names[TYPES] = {"bezier",   "bspline",   "c-bezier", "c-bspline",
                                              "h-bezier", "h-bspline", "ce-bezier"};

static taut_basis *random_basis(int type)
{
    const int quasi = type >= C_BEZIER && type <= H_BSPLINE;
    const double lo = random_int(0, 1) ? 0 : random_in(-3, 3);
    double knots[128];
    taut_basis_spec spec = {.type = type_names[type]};
    taut_basis *basis = NULL;
    taut_error error = {.message = ""};
    if (type == BEZIER || type == BSPLINE) {
        spec.degree = random_int(1, 7);
        spec.has_range = type == BEZIER;
        spec.range[0] = lo;
        spec.range[1] = lo + random_log(1e-2, 10);
    }
    if (type == BSPLINE) {
        spec.knots = knots;
        spec.knot_count = random_knots(spec.degree, 6, lo, knots);
    }
    if (quasi) {
        const double length = random_log(1e-3, type == C_BEZIER    ? TAUT_PI
                                               : type == C_BSPLINE ? 3
                                                                   : 20);
        const int segments = type == C_BSPLINE || type == H_BSPLINE ? random_int(1, 6) : 0;
        spec = spec_of_spans(type_names[type], length, segments, lo);
        spec.has_range = lo != 0;
    }
    if (type == CE_BEZIER) {
        spec.alpha = random_in(-3, 3);
        spec.beta = random_in(-3, 3);
        spec.gamma = random_in(-3, 1);
    }
    CHECK(taut_basis_new(&spec, 0, &basis, &error) == TAUT_OK, "%s: %s", spec.type, error.message);
    return basis;
}

/* How far rounding of parameters and sums may take a point, over the size of the net: the functions
 * change by (distance from zero) / (shortest span) times a rounding error of the parameter. */
static double noise(const taut_basis *basis)
{
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    const double far = fmax(fabs(breaks[0]), fabs(breaks[spans]));
    double shortest = breaks[spans] - breaks[0];
    for (int i = 0; i < spans; i++) {
        shortest = fmin(shortest, breaks[i + 1] - breaks[i]);
    }
    return TAUT_UNIT_ROUNDOFF * taut_basis_local(basis) * (16 + 4 * far / shortest);
}

static void random_net(size_t count, double *points, double *weights)
{
    for (size_t i = 0; i < 3 * count; i++) {
        points[i] = random_in(-1, 1);
    }
    for (size_t i = 0; i < count; i++) {
        weights[i] = random_log(0.1, 10);
    }
}

static taut_curve *random_curve(int type)
{
    double points[3 * 128], weights[128];
    taut_basis *basis = random_basis(type);
    taut_curve *curve = NULL;
    random_net((size_t)taut_basis_count(basis), points, weights);
    const int rational = taut_basis_allows_weights(basis) && random_int(0, 1);
    CHECK(taut_curve_new("c", basis, points, rational ? weights : NULL, &curve, NULL) == TAUT_OK,
          "%s", type_names[type]);
    taut_basis_free(basis);
    return curve;
}

static taut_surface *random_surface(int type_u, int type_v)
{
    taut_basis *u = random_basis(type_u), *v = random_basis(type_v);
    const size_t count = (size_t)taut_basis_count(u) * (size_t)taut_basis_count(v);
    double *points = malloc(4 * count * sizeof *points);
    taut_surface *surface = NULL;
    random_net(count, points, points + 3 * count);
    const int rational =
        taut_basis_allows_weights(u) && taut_basis_allows_weights(v) && random_int(0, 1);
    CHECK(taut_surface_new("s", u, v, points, rational ? points + 3 * count : NULL, &surface,
                           NULL) == TAUT_OK,
          "%s %s", type_names[type_u], type_names[type_v]);
    free(points);
    taut_basis_free(u);
    taut_basis_free(v);
    return surface;
}

static double distance(const double *a, const double *b)
{
    return fmax(fabs(a[0] - b[0]), fmax(fabs(a[1] - b[1]), fabs(a[2] - b[2])));
}

static double worst_ratio = 0; /* of a distance over its tolerance, for whoever wants to look */

/* `other` at a + b t is `curve` at t, for random t of the range [lo, hi] of t. */
static void same_curve(const taut_curve *curve, const taut_curve *other, double lo, double hi,
                       double a, double b, const char *what)
{
    const taut_basis *t = taut_curve_t(curve), *s = taut_curve_t(other);
    const double rational = taut_curve_weights(curve) != NULL ? 200 : 1; /* weights 0.1 to 10 */
    const double tolerance = rational * 4 * (noise(t) + noise(s));
    for (int i = 0; i < 12; i++) {
        const double x = i == 0 ? lo : i == 1 ? hi : random_in(lo, hi);
        const double y = fmin(fmax(a + b * x, taut_basis_lo(s)), taut_basis_hi(s));
        double p[3], q[3];
        CHECK(taut_curve_eval(curve, x, 0, p) == TAUT_OK, "%s", what);
        CHECK(taut_curve_eval(other, y, 0, q) == TAUT_OK, "%s", what);
        worst_ratio = fmax(worst_ratio, distance(p, q) / tolerance);
        CHECK(distance(p, q) <= tolerance, "%s of %s at %.17g: off by %g > %g", what,
              taut_basis_type(t), x, distance(p, q), tolerance);
    }
}

/* The pieces of a model are the curve, in order and without gaps. */
static void same_pieces(const taut_curve *curve, taut_model *model, const char *what)
{
    double at = taut_basis_lo(taut_curve_t(curve));
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        const taut_curve *piece = taut_model_curve(model, i);
        const taut_basis *t = taut_curve_t(piece);
        CHECK(taut_basis_lo(t) == at, "%s: a piece begins at %.17g, expected %.17g", what,
              taut_basis_lo(t), at);
        at = taut_basis_hi(t);
        same_curve(curve, piece, taut_basis_lo(t), at, 0, 1, what);
    }
    CHECK(at == taut_basis_hi(taut_curve_t(curve)), "%s: ends at %.17g", what, at);
}

static double random_inside(const taut_basis *basis)
{
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    if (spans > 1 && random_int(0, 1)) {
        return breaks[random_int(1, spans - 1)];
    }
    return breaks[0] + (breaks[spans] - breaks[0]) * random_in(0.01, 0.99);
}

static void test_curve_pieces(int type)
{
    taut_curve *curve = random_curve(type);
    taut_model *model = NULL;
    taut_error error = {.message = ""};
    const double t = random_inside(taut_curve_t(curve));
    CHECK(taut_curve_split(curve, t, &model, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_model_curve_count(model) >= 2, "two at least");
    same_pieces(curve, model, "split");
    taut_model_free(model);
    CHECK(taut_curve_pieces(curve, &model, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_model_curve_count(model) == taut_basis_span_count(taut_curve_t(curve)), "spans");
    same_pieces(curve, model, "pieces");
    taut_model_free(model);
    taut_curve_free(curve);
}

static double natural_length(const taut_basis *basis)
{
    taut_basis_spec spec;
    taut_basis_spec_of(basis, &spec);
    return (spec.alpha + spec.beta) * taut_basis_span_count(basis);
}

static void test_curve_changes(int type)
{
    taut_curve *curve = random_curve(type), *other = NULL;
    const taut_basis *t = taut_curve_t(curve);
    const double lo = taut_basis_lo(t), hi = taut_basis_hi(t), shift = random_in(-2, 2);
    const int quasi = type >= C_BEZIER && type <= H_BSPLINE;
    taut_error error = {.message = ""};
    CHECK(taut_curve_refine(curve, &other, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_basis_span_count(taut_curve_t(other)) == 2 * taut_basis_span_count(t), "halved");
    same_curve(curve, other, lo, hi, 0, 1, "refined");
    taut_curve_free(other);

    CHECK(taut_curve_reverse(curve, &other, &error) == TAUT_OK, "%s", error.message);
    same_curve(curve, other, lo, hi, lo + hi, -1, "reversed");
    taut_curve_free(other);

    /* the range of a c- or h- basis is as long as its segments say, which its ends only round to */
    const double scale = quasi ? 1 : random_log(0.1, 10);
    const double from = shift + scale * lo;
    const double to = quasi ? from + natural_length(t) : shift + scale * hi;
    CHECK(taut_curve_rerange(curve, from, to, &other, &error) == TAUT_OK, "%s", error.message);
    same_curve(curve, other, lo, hi, shift, scale, "reranged");
    taut_curve_free(other);
    other = NULL;

    if (quasi) {
        CHECK(taut_curve_elevate(curve, 1, &other, &error) == TAUT_NO_SOLUTION, "no degree");
        CHECK(taut_curve_insert(curve, (lo + hi) / 2, 1, &other, &error) == TAUT_NO_SOLUTION,
              "no knots");
        CHECK(other == NULL, "outputs are untouched on failure");
    } else {
        const int times = random_int(0, 3);
        CHECK(taut_curve_elevate(curve, times, &other, &error) == TAUT_OK, "%s", error.message);
        CHECK(taut_basis_degree(taut_curve_t(other)) == taut_basis_degree(t) + times, "raised");
        same_curve(curve, other, lo, hi, 0, 1, "elevated");
        taut_curve_free(other);
        const double knot = lo + (hi - lo) * random_in(0.01, 0.99);
        CHECK(taut_curve_insert(curve, knot, random_int(0, taut_basis_degree(t)), &other, &error) ==
                  TAUT_OK,
              "%s", error.message);
        same_curve(curve, other, lo, hi, 0, 1, "knots inserted");
        taut_curve_free(other);
    }
    taut_curve_free(curve);
}

/* `other` at (s, t) is `surface` at (u, v) over the range of `other`, with s = u or u and v
 * swapped.
 */
static void same_surface(const taut_surface *surface, const taut_surface *other, int swapped,
                         const char *what)
{
    const taut_basis *u = taut_surface_u(other), *v = taut_surface_v(other);
    const double rational = taut_surface_weights(surface) != NULL ? 200 : 1;
    const double tolerance =
        rational * 4 *
        (noise(taut_surface_u(surface)) + noise(taut_surface_v(surface)) + noise(u) + noise(v));
    for (int i = 0; i < 8; i++) {
        const double s = random_in(taut_basis_lo(u), taut_basis_hi(u));
        const double t = random_in(taut_basis_lo(v), taut_basis_hi(v));
        double p[3], q[3];
        CHECK(taut_surface_eval(surface, swapped ? t : s, swapped ? s : t, 0, p) == TAUT_OK, "%s",
              what);
        CHECK(taut_surface_eval(other, s, t, 0, q) == TAUT_OK, "%s", what);
        worst_ratio = fmax(worst_ratio, distance(p, q) / tolerance);
        CHECK(distance(p, q) <= tolerance, "%s: off by %g > %g", what, distance(p, q), tolerance);
    }
}

static void test_surface(int type_u, int type_v)
{
    taut_surface *surface = random_surface(type_u, type_v), *other = NULL;
    const int direction = random_int(0, 1);
    const taut_basis *along =
        direction == TAUT_ALONG_U ? taut_surface_u(surface) : taut_surface_v(surface);
    taut_model *model = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_surface_split(surface, direction, random_inside(along), &model, &error) == TAUT_OK,
          "%s", error.message);
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        same_surface(surface, taut_model_surface(model, i), 0, "split");
    }
    taut_model_free(model);
    CHECK(taut_surface_pieces(surface, &model, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_model_surface_count(model) == taut_basis_span_count(taut_surface_u(surface)) *
                                                 taut_basis_span_count(taut_surface_v(surface)),
          "one for each pair of spans");
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        same_surface(surface, taut_model_surface(model, i), 0, "pieces");
    }
    taut_model_free(model);
    CHECK(taut_surface_refine(surface, direction, &other, &error) == TAUT_OK, "%s", error.message);
    same_surface(surface, other, 0, "refined");
    taut_surface_free(other);
    CHECK(taut_surface_transpose(surface, &other, &error) == TAUT_OK, "%s", error.message);
    same_surface(surface, other, 1, "transposed");
    taut_surface_free(other);
    taut_surface_free(surface);
}

/* Reversed twice is the net that was, and once is the net turned round. */
static void test_reverse_nets(int type_u, int type_v)
{
    taut_surface *surface = random_surface(type_u, type_v), *once = NULL, *twice = NULL;
    const int nu = taut_basis_count(taut_surface_u(surface));
    const int nv = taut_basis_count(taut_surface_v(surface));
    CHECK(taut_surface_reverse(surface, TAUT_ALONG_V, &once, NULL) == TAUT_OK, "once");
    CHECK(taut_surface_reverse(once, TAUT_ALONG_V, &twice, NULL) == TAUT_OK, "twice");
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const double *p = taut_surface_points(surface) + 3 * (i * nv + j);
            const double *q = taut_surface_points(once) + 3 * (i * nv + nv - 1 - j);
            const double *r = taut_surface_points(twice) + 3 * (i * nv + j);
            CHECK(distance(p, q) <= 4 * TAUT_UNIT_ROUNDOFF, "i=%d j=%d", i, j);
            CHECK(distance(p, r) <= 4 * TAUT_UNIT_ROUNDOFF, "i=%d j=%d", i, j);
        }
    }
    taut_surface_free(surface);
    taut_surface_free(once);
    taut_surface_free(twice);
}

/* Isometries move points as they should, weights stay. */
static void test_transform(void)
{
    const double c = cos(0.3), s = sin(0.3);
    const double matrix[12] = {c, -s, 0, 1, s, c, 0, 2, 0, 0, 1, 3};
    const double broken[12] = {1, 0, 0, 0, 0, nan(""), 0, 0, 0, 0, 1, 0};
    taut_surface *surface = random_surface(BSPLINE, BEZIER), *moved = NULL, *none = NULL;
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    CHECK(taut_surface_transform(surface, matrix, &moved, NULL) == TAUT_OK, "moved");
    for (int i = 0; i < 20; i++) {
        const double a = random_in(taut_basis_lo(u), taut_basis_hi(u));
        const double b = random_in(taut_basis_lo(v), taut_basis_hi(v));
        double p[3], q[3], expected[3];
        taut_surface_eval(surface, a, b, 0, p);
        taut_surface_eval(moved, a, b, 0, q);
        for (int r = 0; r < 3; r++) {
            const double *row = matrix + 4 * r;
            expected[r] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
        }
        CHECK(distance(q, expected) <= 1e-14, "off by %g", distance(q, expected));
    }
    CHECK(taut_surface_transform(surface, broken, &none, NULL) == TAUT_BAD_ARGUMENT, "nan");
    CHECK(none == NULL, "outputs are untouched on failure");
    taut_surface_free(surface);
    taut_surface_free(moved);
}

static void test_refusals(void)
{
    taut_curve *curve = random_curve(BSPLINE), *quasi = random_curve(C_BEZIER), *none = NULL;
    const taut_basis *t = taut_curve_t(curve);
    const double outside[] = {taut_basis_lo(t), taut_basis_hi(t), taut_basis_hi(t) + 1, nan("")};
    taut_model *model = NULL;
    taut_error error = {.where = ""};
    for (int i = 0; i < 4; i++) {
        CHECK(taut_curve_split(curve, outside[i], &model, &error) == TAUT_NO_SOLUTION, "%g",
              outside[i]);
        CHECK(taut_curve_insert(curve, outside[i], 1, &none, &error) == TAUT_NO_SOLUTION, "%g",
              outside[i]);
    }
    CHECK(taut_curve_insert(curve, (outside[0] + outside[1]) / 2, 99, &none, &error) ==
              TAUT_BAD_ARGUMENT,
          "more than the degree");
    CHECK(taut_curve_elevate(curve, TAUT_DEGREE_MAX, &none, &error) == TAUT_BAD_ARGUMENT, "degree");
    CHECK(taut_curve_elevate(curve, -1, &none, &error) == TAUT_BAD_ARGUMENT, "negative");
    CHECK(taut_curve_rerange(curve, 1, 1, &none, &error) == TAUT_BAD_ARGUMENT, "empty range");
    CHECK(taut_curve_rerange(quasi, 0, 77, &none, &error) == TAUT_BAD_INPUT, "another length");
    CHECK(strcmp(error.where, "/range") == 0, "where is %s", error.where);
    CHECK(taut_curve_split(NULL, 0, &model, &error) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(taut_surface_refine(NULL, 2, NULL, &error) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(model == NULL && none == NULL, "outputs are untouched on failure");
    taut_curve_free(curve);
    taut_curve_free(quasi);
}

int main(void)
{
    random_seed(20260104);
    for (int trial = 0; trial < 700; trial++) {
        test_curve_pieces(trial % TYPES);
        test_curve_changes(trial % TYPES);
    }
    for (int trial = 0; trial < 4 * TYPES * TYPES; trial++) {
        test_surface(trial % TYPES, trial / TYPES % TYPES);
        test_reverse_nets(trial % TYPES, trial / TYPES % TYPES);
    }
    test_transform();
    test_refusals();
    if (getenv("TAUT_TEST_SAY") != NULL) {
        printf("worst distance over tolerance: %g\n", worst_ratio);
    }
    return check_failures != 0;
}
