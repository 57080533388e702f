/* test_operate.c -- splitting, refining, converting when memory runs out. */
#include "calls.h"
#include "check.h"
#include "fault.h"

#include "certify/common/curve_distance.h"
#include "geometry/boundary/boundary.h"
#include "taut/operations.h"

#include <stddef.h>

/* What the calls work on; made before any of them fails. */
typedef struct fixture {
    taut_curve *curve;
    taut_surface *surface;
    taut_model *model;
} fixture;

/* A call that makes something out of the fixture. */
#define MAKER(name, type, expression)                                                              \
    static taut_status name(const void *context, void **result, taut_error *error)                 \
    {                                                                                              \
        const fixture *f = context;                                                                \
        type *made = *result;                                                                      \
        const taut_status status = expression;                                                     \
        *result = made;                                                                            \
        return status;                                                                             \
    }

static const double shear[12] = {1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

MAKER(curve_split, taut_model, taut_curve_split(f->curve, 0.4, &made, error))
MAKER(curve_pieces, taut_model, taut_curve_pieces(f->curve, &made, error))
MAKER(curve_refine, taut_curve, taut_curve_refine(f->curve, &made, error))
MAKER(curve_insert, taut_curve, taut_curve_insert(f->curve, 0.4, 2, &made, error))
MAKER(curve_elevate, taut_curve, taut_curve_elevate(f->curve, 2, &made, error))
MAKER(curve_reverse, taut_curve, taut_curve_reverse(f->curve, &made, error))
MAKER(curve_rerange, taut_curve, taut_curve_rerange(f->curve, 1, 2, &made, error))
MAKER(curve_transform, taut_curve, taut_curve_transform(f->curve, shear, &made, error))
MAKER(curve_to_nurbs, taut_curve, taut_curve_to_nurbs(f->curve, 1e-3, &made, NULL, error))
MAKER(split, taut_model, taut_surface_split(f->surface, TAUT_ALONG_V, 0.4, &made, error))
MAKER(pieces, taut_model, taut_surface_pieces(f->surface, &made, error))
MAKER(refine, taut_surface, taut_surface_refine(f->surface, TAUT_ALONG_U, &made, error))
MAKER(reverse, taut_surface, taut_surface_reverse(f->surface, TAUT_ALONG_V, &made, error))
MAKER(rerange, taut_surface, taut_surface_rerange(f->surface, TAUT_ALONG_U, 2, 3, &made, error))
MAKER(transpose, taut_surface, taut_surface_transpose(f->surface, &made, error))
MAKER(transform, taut_surface, taut_surface_transform(f->surface, shear, &made, error))
MAKER(to_nurbs, taut_surface, taut_surface_to_nurbs(f->surface, 1e-2, &made, NULL, error))
MAKER(model_split, taut_model, taut_model_split(f->model, NULL, TAUT_ALONG_U, 0.4, &made, error))
MAKER(curve_split_knot, taut_model, taut_curve_split(f->curve, 0.5, &made, error))
MAKER(model_split_named, taut_model,
      taut_model_split(f->model, "s", TAUT_ALONG_U, 0.4, &made, error))
MAKER(model_refine, taut_model, taut_model_refine(f->model, NULL, 0, 0, &made, error))
MAKER(model_to_unit, taut_model, taut_model_to_unit(f->model, "ft", &made, error))
MAKER(model_boundary, taut_model, taut_model_boundary(f->model, &made, error))
MAKER(model_pieces, taut_model, taut_model_pieces(f->model, NULL, &made, error))
MAKER(model_to_nurbs, taut_model, taut_model_to_nurbs(f->model, 1e-2, &made, NULL, error))

/* The curve as all four sides: on one basis both ways, whatever its type. */
static taut_status fit(const void *context, void **result, taut_error *error)
{
    static const int none[2] = {0, 0};
    const fixture *f = context;
    taut_curve *const sides[TAUT_SIDES] = {f->curve, f->curve, f->curve, f->curve};
    taut_curve *fitted[TAUT_SIDES] = {*result, NULL, NULL, NULL};
    const taut_status status = taut_boundary_fit(sides, none, none, fitted, error);
    *result = fitted[0];
    for (int s = 1; s < TAUT_SIDES; s++) {
        taut_curve_free(fitted[s]);
    }
    return status;
}

/* The proved distance of the curve from itself. */
static taut_status distance(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    double bound = -1;
    const taut_status status = taut_certify_distance(f->curve, f->curve, &bound, error);
    (void)result;
    CHECK((status == TAUT_OK) == (bound >= 0), "the bound is told on success, only then");
    return status;
}

/* Every type has a range of length 1 here; c- and h- have no knots to insert and no degree. */
enum { BEZIER, BSPLINE, C_BEZIER, C_BSPLINE, H_BEZIER, H_BSPLINE, CE_BEZIER, TYPES };

static const taut_basis_spec specs[TYPES] = {
    {.type = "bezier", .degree = 3},
    {.type = "bspline", .degree = 2, .count = 5},
    {.type = "c-bezier", .alpha = 1},
    {.type = "c-bspline", .alpha = 0.5, .segments = 2},
    {.type = "h-bezier", .beta = 1},
    {.type = "h-bspline", .beta = 0.5, .segments = 2},
    {.type = "ce-bezier", .alpha = 1, .beta = 2, .gamma = -1},
};

static int is_polynomial(int type)
{
    return type == BEZIER || type == BSPLINE || type == CE_BEZIER;
}

/* A fixture on one type along u and another along v; weights where both allow them. */
static fixture make_fixture(int type_u, int type_v)
{
    fixture f = {NULL, NULL, NULL};
    double points[3 * 64], weights[64];
    taut_basis *u = NULL, *v = NULL;
    taut_surface *surface = NULL;
    taut_curve *curve = NULL;
    for (int i = 0; i < 64; i++) {
        points[3 * i] = random_in(-1, 1);
        points[3 * i + 1] = random_in(-1, 1);
        points[3 * i + 2] = random_in(-1, 1);
        weights[i] = random_in(1, 2);
    }
    CHECK(taut_basis_new(&specs[type_u], 0, &u, NULL) == TAUT_OK, "u");
    CHECK(taut_basis_new(&specs[type_v], 0, &v, NULL) == TAUT_OK, "v");
    const int rational_u = taut_basis_allows_weights(u);
    const int rational = rational_u && taut_basis_allows_weights(v);
    CHECK(taut_curve_new("c", u, points, rational_u ? weights : NULL, &f.curve, NULL) == TAUT_OK,
          "curve");
    CHECK(taut_surface_new("s", u, v, points, rational ? weights : NULL, &f.surface, NULL) ==
              TAUT_OK,
          "surface");
    CHECK(taut_model_new(&f.model) == TAUT_OK, "model");
    CHECK(taut_surface_copy(f.surface, &surface) == TAUT_OK, "surface");
    CHECK(taut_curve_copy(f.curve, &curve) == TAUT_OK, "curve");
    CHECK(taut_model_add_surface(f.model, surface) == TAUT_OK, "surface");
    CHECK(taut_model_add_curve(f.model, curve) == TAUT_OK, "curve");
    taut_basis_free(u);
    taut_basis_free(v);
    return f;
}

static void free_fixture(fixture *f)
{
    taut_curve_free(f->curve);
    taut_surface_free(f->surface);
    taut_model_free(f->model);
}

static void run(const fault_call *calls, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        CHECK(fault_loop(&calls[i]) > 0, "%s takes memory", calls[i].name);
    }
}

static void test_types(int type_u, int type_v)
{
    fixture f = make_fixture(type_u, type_v);
    const fault_call calls[] = {
        {"taut_curve_split", curve_split, release_model, &f},
        {"taut_curve_split at a knot", curve_split_knot, release_model, &f},
        {"taut_curve_pieces", curve_pieces, release_model, &f},
        {"taut_curve_refine", curve_refine, release_curve, &f},
        {"taut_curve_reverse", curve_reverse, release_curve, &f},
        {"taut_curve_rerange", curve_rerange, release_curve, &f},
        {"taut_curve_transform", curve_transform, release_curve, &f},
        {"taut_curve_to_nurbs", curve_to_nurbs, release_curve, &f},
        {"taut_certify_distance", distance, NULL, &f},
        {"taut_boundary_fit", fit, release_curve, &f},
        {"taut_surface_split", split, release_model, &f},
        {"taut_surface_pieces", pieces, release_model, &f},
        {"taut_surface_refine", refine, release_surface, &f},
        {"taut_surface_reverse", reverse, release_surface, &f},
        {"taut_surface_rerange", rerange, release_surface, &f},
        {"taut_surface_transpose", transpose, release_surface, &f},
        {"taut_surface_transform", transform, release_surface, &f},
        {"taut_surface_to_nurbs", to_nurbs, release_surface, &f},
        {"taut_model_split", model_split, release_model, &f},
        {"taut_model_split of one name", model_split_named, release_model, &f},
        {"taut_model_refine", model_refine, release_model, &f},
        {"taut_model_pieces", model_pieces, release_model, &f},
        {"taut_model_to_nurbs", model_to_nurbs, release_model, &f},
        {"taut_model_to_unit", model_to_unit, release_model, &f},
        {"taut_model_boundary", model_boundary, release_model, &f},
    };
    const fault_call polynomial[] = {
        {"taut_curve_insert", curve_insert, release_curve, &f},
        {"taut_curve_elevate", curve_elevate, release_curve, &f},
    };
    run(calls, sizeof calls / sizeof calls[0]);
    if (is_polynomial(type_u)) {
        run(polynomial, sizeof polynomial / sizeof polynomial[0]);
    }
    free_fixture(&f);
}

int main(void)
{
    random_seed(20260111);
    for (int type = 0; type < TYPES; type++) {
        test_types(type, (type + 1) % TYPES);
    }
    CHECK(fault_live() == 0, "%ld blocks left", fault_live());
    return check_failures != 0;
}
