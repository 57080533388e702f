/* test_refusals.c -- what no operation does: without arguments, beyond the limits, or below
 * what rounding leaves. Each says so and leaves its output as it was. */
#include "check.h"
#include "shapes.h"

#include "taut/limits.h"
#include "taut/operations.h"

#include <stdlib.h>
#include <string.h>

static const double unit_matrix[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

/* A refusal for this reason; NULL: one of the basis's own. */
static void check_refused(const char *what, taut_status status, taut_status expected,
                          const taut_error *error, const char *reason, const void *output)
{
    CHECK(status == expected && error->status == expected, "%s: status %d", what, (int)status);
    CHECK(reason == NULL || strcmp(error->reason, reason) == 0, "%s: %s", what, error->reason);
    CHECK(output == NULL, "%s: the output was touched", what);
}

/* Of every operation with one argument left out. */
static void test_missing(void)
{
    taut_curve *curve = shape_curve(shape_bezier(1, 0, 1), (double[]){0, 0, 0, 1, 0, 0}, NULL);
    taut_curve *curves = NULL;
    taut_surface *surface = shape_saddle(1), *surfaces = NULL;
    taut_model *models = NULL;
    taut_error error = {.message = ""};
    const struct {
        const char *name;
        taut_status status;
    } calls[] = {
#define CALL(name, ...) {#name, name(__VA_ARGS__, &error)}
        CALL(taut_curve_split, NULL, 0.5, &models),
        CALL(taut_curve_split, curve, 0.5, NULL),
        CALL(taut_curve_pieces, NULL, &models),
        CALL(taut_curve_pieces, curve, NULL),
        CALL(taut_curve_refine, NULL, &curves),
        CALL(taut_curve_refine, curve, NULL),
        CALL(taut_curve_insert, NULL, 0.5, 1, &curves),
        CALL(taut_curve_insert, curve, 0.5, 1, NULL),
        CALL(taut_curve_elevate, NULL, 1, &curves),
        CALL(taut_curve_elevate, curve, 1, NULL),
        CALL(taut_curve_reverse, NULL, &curves),
        CALL(taut_curve_reverse, curve, NULL),
        CALL(taut_curve_rerange, NULL, 0, 2, &curves),
        CALL(taut_curve_rerange, curve, 0, 2, NULL),
        CALL(taut_curve_transform, NULL, unit_matrix, &curves),
        CALL(taut_curve_transform, curve, NULL, &curves),
        CALL(taut_curve_transform, curve, unit_matrix, NULL),
        CALL(taut_curve_to_nurbs, NULL, 1e-6, &curves, NULL),
        CALL(taut_curve_to_nurbs, curve, 1e-6, NULL, NULL),
        CALL(taut_surface_split, NULL, TAUT_ALONG_U, 0.5, &models),
        CALL(taut_surface_split, surface, 7, 0.5, &models),
        CALL(taut_surface_split, surface, TAUT_ALONG_U, 0.5, NULL),
        CALL(taut_surface_pieces, NULL, &models),
        CALL(taut_surface_pieces, surface, NULL),
        CALL(taut_surface_refine, NULL, TAUT_ALONG_U, &surfaces),
        CALL(taut_surface_refine, surface, -1, &surfaces),
        CALL(taut_surface_refine, surface, TAUT_ALONG_V, NULL),
        CALL(taut_surface_insert, NULL, TAUT_ALONG_U, 0.5, 1, &surfaces),
        CALL(taut_surface_insert, surface, 2, 0.5, 1, &surfaces),
        CALL(taut_surface_elevate, NULL, TAUT_ALONG_U, 1, &surfaces),
        CALL(taut_surface_elevate, surface, TAUT_ALONG_U, 1, NULL),
        CALL(taut_surface_reverse, NULL, TAUT_ALONG_U, &surfaces),
        CALL(taut_surface_reverse, surface, TAUT_ALONG_V, NULL),
        CALL(taut_surface_rerange, NULL, TAUT_ALONG_U, 0, 2, &surfaces),
        CALL(taut_surface_rerange, surface, TAUT_ALONG_U, 0, 2, NULL),
        CALL(taut_surface_transpose, NULL, &surfaces),
        CALL(taut_surface_transpose, surface, NULL),
        CALL(taut_surface_transform, NULL, unit_matrix, &surfaces),
        CALL(taut_surface_transform, surface, NULL, &surfaces),
        CALL(taut_surface_transform, surface, unit_matrix, NULL),
        CALL(taut_surface_to_nurbs, NULL, 1e-6, &surfaces, NULL),
        CALL(taut_surface_to_nurbs, surface, 1e-6, NULL, NULL),
        CALL(taut_model_split, NULL, NULL, TAUT_ALONG_U, 0.5, &models),
        CALL(taut_model_refine, NULL, NULL, 0, 0, &models),
        CALL(taut_model_to_nurbs, NULL, 1e-6, &models, NULL),
#undef CALL
    };
    for (size_t i = 0; i < sizeof calls / sizeof calls[0]; i++) {
        CHECK(calls[i].status == TAUT_BAD_ARGUMENT, "call %zu, %s: status %d", i, calls[i].name,
              (int)calls[i].status);
    }
    CHECK(strcmp(error.reason, "argument") == 0, "%s", error.reason);
    CHECK(curves == NULL && surfaces == NULL && models == NULL, "an output was touched");
    taut_curve_free(curve);
    taut_surface_free(surface);
}

/* Points that no line holds, in the unit cube. */
static double *grid(int nu, int nv)
{
    double *points = malloc(3 * (size_t)nu * (size_t)nv * sizeof *points);
    for (int k = 0; k < 3 * nu * nv; k++) {
        points[k] = (k * 7 + k / nv * 3) % 11 / 10.0;
    }
    return points;
}

static taut_curve *curve_on(const taut_basis_spec *spec)
{
    taut_basis *basis = shape_basis(spec);
    double *points = grid(taut_basis_count(basis), 1);
    taut_curve *curve = shape_curve(basis, points, NULL);
    free(points);
    return curve;
}

static taut_surface *surface_on(const taut_basis_spec *u, const taut_basis_spec *v)
{
    taut_basis *bases[2] = {shape_basis(u), shape_basis(v)};
    double *points = grid(taut_basis_count(bases[0]), taut_basis_count(bases[1]));
    taut_surface *surface = shape_surface(bases[0], bases[1], points, NULL);
    free(points);
    return surface;
}

static taut_basis_spec linear(int spans)
{
    return (taut_basis_spec){.type = "bspline", .degree = 1, .count = spans + 1};
}

/* One more piece than a model holds, 400 by 251 patches, 16 * 3000 + 1 by 1100 points. */
static void test_limits(void)
{
    const taut_basis_spec many = linear(TAUT_OBJECTS_MAX + 1), rows = linear(400),
                          columns = linear(251), long_rows = linear(3000), wide = linear(1099);
    taut_curve *curve = curve_on(&many);
    taut_surface *surface = surface_on(&rows, &columns), *raised = NULL;
    taut_model *pieces = NULL;
    taut_error error = {.message = ""};
    taut_status status = taut_curve_pieces(curve, &pieces, &error);
    check_refused("curve pieces", status, TAUT_NO_SOLUTION, &error, "too-many-objects", pieces);
    CHECK(error.limit == TAUT_OBJECTS_MAX, "limit %g", error.limit);
    status = taut_surface_pieces(surface, &pieces, &error);
    check_refused("patches", status, TAUT_NO_SOLUTION, &error, "too-many-objects", pieces);
    CHECK(error.found == 100400 && error.limit == TAUT_OBJECTS_MAX, "%g of %g", error.found,
          error.limit);
    taut_surface_free(surface);
    surface = surface_on(&long_rows, &wide);
    status = taut_surface_elevate(surface, TAUT_ALONG_U, 15, &raised, &error);
    check_refused("points", status, TAUT_NO_SOLUTION, &error, "too-many-points", raised);
    CHECK(error.found == 52801100 && error.limit == TAUT_POINTS_MAX, "%g of %g", error.found,
          error.limit);
    taut_surface_free(surface);
    taut_curve_free(curve);
}

/* A span for each of so many segments is more than a spline has; 80 spans for each of 1000, by 80
 * for the other side, are more points than a surface has. */
static void test_many_spans(void)
{
    const taut_basis_spec longest = {.type = "c-bspline", .alpha = 1, .segments = 336000};
    const taut_basis_spec layers = {.type = "h-bspline", .beta = 700, .segments = 1000};
    const taut_basis_spec layer = {.type = "h-bezier", .beta = 700};
    taut_curve *curve = curve_on(&longest), *nurbs = NULL;
    taut_surface *surface = surface_on(&layers, &layer), *converted = NULL;
    taut_error error = {.message = ""};
    taut_status status = taut_curve_to_nurbs(curve, 0.1, &nurbs, NULL, &error);
    check_refused("curve", status, TAUT_NO_SOLUTION, &error, "too-many-points", nurbs);
    CHECK(error.found == error.limit && error.limit == (TAUT_COUNT_MAX - 3) / 3, "%g of %g",
          error.found, error.limit);
    status = taut_surface_to_nurbs(surface, 1e-12, &converted, NULL, &error);
    check_refused("surface", status, TAUT_NO_SOLUTION, &error, "too-many-points", converted);
    CHECK(error.found > error.limit && error.limit == TAUT_POINTS_MAX, "%g of %g", error.found,
          error.limit);
    taut_surface_free(surface);
    taut_curve_free(curve);
}

/* So near that the rounding of the spline's own rows is more than half of it: the distance that the
 * refusal names can be had. */
static void test_below_rounding(void)
{
    const taut_basis_spec spec = {.type = "c-bezier", .alpha = 2};
    taut_curve *curve = curve_on(&spec), *nurbs = NULL;
    taut_error error = {.message = ""};
    double bound = 0;
    const double asked = 1.01e-13;
    const taut_status status = taut_curve_to_nurbs(curve, asked, &nurbs, &bound, &error);
    check_refused("near", status, TAUT_BAD_ARGUMENT, &error, "tolerance", nurbs);
    CHECK(error.found == asked && error.limit > asked && error.limit < 10 * asked, "%g of %g",
          error.found, error.limit);
    CHECK(taut_curve_to_nurbs(curve, error.limit, &nurbs, &bound, NULL) == TAUT_OK, "at %g",
          error.limit);
    CHECK(bound > 0 && bound <= error.limit, "bound %g of %g", bound, error.limit);
    taut_curve_free(nurbs);
    taut_curve_free(curve);
}

/* Cuts and halves that leave pieces without parameters of their own. */
static void test_too_short(void)
{
    const double next = 1 + 0x1p-52, knots[] = {0, 0, 1, next, 2, 2};
    const taut_basis_spec narrow = {
        .type = "bspline", .degree = 1, .knots = knots, .knot_count = 6};
    const taut_basis_spec circular = {.type = "c-bezier", .alpha = 1};
    const taut_basis_spec spline = {.type = "c-bspline", .alpha = 1, .segments = 2};
    taut_curve *curve = curve_on(&narrow), *refined = NULL;
    taut_model *pieces = NULL;
    taut_error error = {.message = ""};
    taut_status status = taut_curve_refine(curve, &refined, &error);
    check_refused("halve", status, TAUT_NO_SOLUTION, &error, NULL, refined);
    CHECK(strcmp(error.where, "/knots") == 0 && error.found == 0x1p-52, "%s, %g", error.where,
          error.found);
    taut_curve_free(curve);
    for (int i = 0; i < 2; i++) {
        const double near = i == 0 ? 0 : 1; /* an end; a knot inside */
        curve = curve_on(i == 0 ? &circular : &spline);
        status = taut_curve_split(curve, near + 1e-15, &pieces, &error);
        check_refused("cut", status, TAUT_NO_SOLUTION, &error, NULL, pieces);
        CHECK(error.found < error.limit && error.found < 1.2e-15, "%g of %g", error.found,
              error.limit);
        CHECK(taut_curve_split(curve, near + 2 * error.limit, &pieces, NULL) == TAUT_OK,
              "a piece of %g", 2 * error.limit);
        taut_model_free(pieces);
        pieces = NULL;
        taut_curve_free(curve);
    }
}

/* A knot that is there gains as many as there is room for up to the degree, and no more; the curve
 * stays. */
static void test_knot_again(void)
{
    const double knots[] = {0, 0, 0, 0, 0.25, 0.25, 1, 1, 1, 1};
    const taut_basis_spec spec = {.type = "bspline", .degree = 3, .knots = knots, .knot_count = 10};
    taut_curve *curve = curve_on(&spec), *more = NULL;
    taut_error error = {.message = ""};
    taut_status status = taut_curve_insert(curve, 0.25, 2, &more, &error);
    check_refused("insert", status, TAUT_BAD_ARGUMENT, &error, NULL, more);
    CHECK(error.found == 2 && error.limit == 1, "%g of %g", error.found, error.limit);
    CHECK(taut_curve_insert(curve, 0.25, 1, &more, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_basis_count(taut_curve_t(more)) == 7, "%d functions",
          taut_basis_count(taut_curve_t(more)));
    for (int k = 0; k <= 16; k++) {
        double x[3], y[3];
        taut_curve_eval(curve, k / 16.0, 0, x);
        taut_curve_eval(more, k / 16.0, 0, y);
        CHECK_NEAR(x[0], y[0], 1e-14, "k=%d", k);
    }
    taut_curve_free(more);
    taut_curve_free(curve);
}

/* The range of a ce-bezier that is asked for the one it has stays on its basis. */
static void test_same_range(void)
{
    const taut_basis_spec spec = {.type = "ce-bezier", .alpha = 1, .beta = 2, .gamma = -1};
    taut_curve *curve = curve_on(&spec), *moved = NULL;
    CHECK(taut_curve_rerange(curve, 0, 1, &moved, NULL) == TAUT_OK, "rerange");
    CHECK(taut_basis_equal(taut_curve_t(curve), taut_curve_t(moved)), "its basis");
    CHECK(memcmp(taut_curve_points(curve), taut_curve_points(moved), 12 * sizeof(double)) == 0,
          "its points");
    taut_curve_free(moved);
    taut_curve_free(curve);
}

/* Weights where a basis carries none; names that are too long. */
static void test_objects(void)
{
    const taut_basis_spec circular = {.type = "c-bezier", .alpha = 1};
    const double weights[16] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    double *points = grid(4, 4);
    taut_basis *c = shape_basis(&circular), *b = shape_bezier(3, 0, 1);
    taut_curve *curve = NULL;
    taut_surface *surface = NULL;
    taut_error error = {.message = ""};
    char name[TAUT_NAME_MAX + 2];
    taut_status status = taut_curve_new("", c, points, weights, &curve, &error);
    check_refused("curve", status, TAUT_BAD_INPUT, &error, "conflict", curve);
    CHECK(strcmp(error.where, "/weights") == 0, "%s", error.where);
    for (int i = 0; i < 2; i++) {
        status = taut_surface_new("", i ? c : b, i ? b : c, points, weights, &surface, &error);
        check_refused("surface", status, TAUT_BAD_INPUT, &error, "conflict", surface);
        CHECK(strcmp(error.where, "/weights") == 0, "%s", error.where);
    }
    memset(name, 'x', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    status = taut_surface_new(name, b, b, points, NULL, &surface, &error);
    check_refused("name", status, TAUT_BAD_INPUT, &error, "size", surface);
    CHECK(strcmp(error.where, "/name") == 0 && error.limit == TAUT_NAME_MAX, "%s", error.where);
    taut_basis_free(b);
    taut_basis_free(c);
    free(points);
}

int main(void)
{
    test_missing();
    test_limits();
    test_many_spans();
    test_below_rounding();
    test_too_short();
    test_knot_again();
    test_same_range();
    test_objects();
    return check_failures != 0;
}
