/* test_geometry.c -- bases, curves, surfaces, grids and models when memory runs out. */
#include "calls.h"
#include "check.h"
#include "fault.h"

#include "taut/model.h"

#include <string.h>

enum { COUNT = 6, DEGREE = 3 };

/* What the calls work on; made before any of them fails. */
typedef struct fixture {
    taut_basis_spec spec;
    double points[COUNT * COUNT * 3];
    double weights[COUNT * COUNT];
    taut_basis *basis;
    taut_curve *curve;
    taut_surface *surface;
} fixture;

static void release_basis(void *basis)
{
    taut_basis_free(basis);
}

static taut_status new_basis(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    taut_basis *basis = *result;
    const taut_status status = taut_basis_new(&f->spec, COUNT, &basis, error);
    *result = basis;
    return status;
}

static taut_status copy_basis(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    taut_basis *basis = *result;
    const taut_status status = taut_basis_copy(f->basis, &basis);
    (void)error;
    *result = basis;
    return status;
}

static taut_status new_curve(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    taut_curve *curve = *result;
    const taut_status status =
        taut_curve_new("curve", f->basis, f->points, f->weights, &curve, error);
    *result = curve;
    return status;
}

static taut_status copy_curve(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    taut_curve *curve = *result;
    const taut_status status = taut_curve_copy(f->curve, &curve);
    (void)error;
    *result = curve;
    return status;
}

static taut_status new_surface(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    taut_surface *surface = *result;
    const taut_status status =
        taut_surface_new("surface", f->basis, f->basis, f->points, f->weights, &surface, error);
    *result = surface;
    return status;
}

static taut_status copy_surface(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    taut_surface *surface = *result;
    const taut_status status = taut_surface_copy(f->surface, &surface);
    (void)error;
    *result = surface;
    return status;
}

static taut_status eval_grid(const void *context, void **result, taut_error *error)
{
    enum { LINES = 9, VECTORS = 6 };
    static double values[LINES * LINES * VECTORS * 3];
    const fixture *f = context;
    double t[LINES];
    taut_status status = TAUT_OK;
    (void)result;
    (void)error;
    for (int i = 0; i < LINES; i++) {
        t[i] = i / (LINES - 1.0);
    }
    values[0] = 7;
    status = taut_surface_eval_grid(f->surface, LINES, t, LINES, t, 2, 2, values);
    CHECK((status == TAUT_OK) == (values[0] != 7), "values are written on success, only then");
    return status;
}

/* Five of each, so that both arrays grow more than once. */
static taut_status make_model(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    taut_model *model = NULL;
    taut_status status = taut_model_new(&model);
    (void)error;
    for (int i = 0; i < 5 && status == TAUT_OK; i++) {
        taut_surface *surface = NULL;
        taut_curve *curve = NULL;
        status = taut_surface_copy(f->surface, &surface);
        if (status == TAUT_OK) {
            status = taut_model_add_surface(model, surface);
            if (status != TAUT_OK) {
                taut_surface_free(surface); /* still ours */
            }
        }
        if (status == TAUT_OK) {
            status = taut_curve_copy(f->curve, &curve);
        }
        if (status == TAUT_OK) {
            status = taut_model_add_curve(model, curve);
            if (status != TAUT_OK) {
                taut_curve_free(curve);
            }
        }
    }
    if (status != TAUT_OK) {
        taut_model_free(model);
        return status;
    }
    *result = model;
    return TAUT_OK;
}

static void make_fixture(fixture *f)
{
    memset(f, 0, sizeof *f);
    f->spec = (taut_basis_spec){.type = "bspline", .degree = DEGREE, .count = COUNT};
    for (int i = 0; i < COUNT * COUNT; i++) {
        f->points[3 * i] = i / COUNT;
        f->points[3 * i + 1] = i % COUNT;
        f->points[3 * i + 2] = random_in(-1, 1);
        f->weights[i] = random_in(1, 2);
    }
    CHECK(taut_basis_new(&f->spec, COUNT, &f->basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_curve_new("c", f->basis, f->points, f->weights, &f->curve, NULL) == TAUT_OK,
          "curve");
    CHECK(taut_surface_new("s", f->basis, f->basis, f->points, f->weights, &f->surface, NULL) ==
              TAUT_OK,
          "surface");
}

int main(void)
{
    fixture f;
    random_seed(20260110);
    make_fixture(&f);
    const fault_call calls[] = {
        {"taut_basis_new", new_basis, release_basis, &f},
        {"taut_basis_copy", copy_basis, release_basis, &f},
        {"taut_curve_new", new_curve, release_curve, &f},
        {"taut_curve_copy", copy_curve, release_curve, &f},
        {"taut_surface_new", new_surface, release_surface, &f},
        {"taut_surface_copy", copy_surface, release_surface, &f},
        {"taut_surface_eval_grid", eval_grid, NULL, &f},
        {"taut_model", make_model, release_model, &f},
    };
    for (size_t i = 0; i < sizeof calls / sizeof calls[0]; i++) {
        const long allocations = fault_loop(&calls[i]);
        CHECK(allocations > 0, "%s takes memory", calls[i].name);
    }
    taut_basis_free(f.basis);
    taut_curve_free(f.curve);
    taut_surface_free(f.surface);
    CHECK(fault_live() == 0, "%ld blocks left", fault_live());
    return check_failures != 0;
}
