/* model_nurbs.c -- every surface and curve of a model as NURBS, each by its own size. */
#include "taut/operations.h"

#include "core/fail.h"
#include "geometry/operate/change.h"
#include "geometry/operate/points.h"

#include <math.h>

/* Grows a box {low, high} by a point. */
static void grow(double box[2][3], const double *x)
{
    for (int c = 0; c < 3; c++) {
        box[0][c] = fmin(box[0][c], x[c]);
        box[1][c] = fmax(box[1][c], x[c]);
    }
}

static double diagonal(double box[2][3])
{
    return hypot(hypot(box[1][0] - box[0][0], box[1][1] - box[0][1]), box[1][2] - box[0][2]);
}

enum { SAMPLES = 17 };

/* Sample i of a range, the ends exactly. */
static double sample(const taut_basis *basis, int i)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    return i == SAMPLES - 1 ? hi : lo + (hi - lo) * i / (SAMPLES - 1);
}

/* The diagonal of the box around sampled points; 1 for a single point, whose size says nothing. */
static double surface_size(const taut_surface *surface)
{
    double box[2][3] = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (int i = 0; i < SAMPLES * SAMPLES; i++) {
        double x[3] = {0, 0, 0};
        taut_surface_eval(surface, sample(taut_surface_u(surface), i / SAMPLES),
                          sample(taut_surface_v(surface), i % SAMPLES), 0, x);
        grow(box, x);
    }
    return diagonal(box) > 0 ? diagonal(box) : 1;
}

static double curve_size(const taut_curve *curve)
{
    double box[2][3] = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (int i = 0; i < SAMPLES; i++) {
        double x[3] = {0, 0, 0};
        taut_curve_eval(curve, sample(taut_curve_t(curve), i), 0, x);
        grow(box, x);
    }
    return diagonal(box) > 0 ? diagonal(box) : 1;
}

/* A tolerance that rounding forbids was told as a length; here it is asked for over the size. */
static taut_status over_size(taut_status status, double tolerance, double size, taut_error *error)
{
    if (status == TAUT_BAD_ARGUMENT && error != NULL && error->limit > 0) {
        return taut_fail(error, status, "value", NULL, tolerance, error->limit / size,
                         "tolerance %g (over the size, %g) is below what rounding leaves; ask for "
                         "%g at least",
                         tolerance, size, error->limit / size);
    }
    return status;
}

taut_status taut_model_to_nurbs(const taut_model *model, double tolerance, taut_model **nurbs,
                                double *bound, taut_error *error)
{
    taut_model *made = NULL;
    taut_status status = TAUT_OK;
    double largest = 0;

    if (model == NULL || nurbs == NULL) {
        return taut_operate_null(error);
    }
    status = taut_operate_begin(model, &made, error);
    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(model); i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        taut_surface *converted = NULL;
        const double size = surface_size(surface);
        double one = 0;
        status = taut_surface_to_nurbs(surface, tolerance * size, &converted, &one, error);
        status = over_size(status, tolerance, size, error);
        if (status == TAUT_OK) {
            status = taut_operate_add_surface(made, converted, error);
        }
        largest = fmax(largest, one);
        status = taut_operate_placed(status, "surfaces", i, error);
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_curve_count(model); i++) {
        const taut_curve *curve = taut_model_curve(model, i);
        taut_curve *converted = NULL;
        const double size = curve_size(curve);
        double one = 0;
        status = taut_curve_to_nurbs(curve, tolerance * size, &converted, &one, error);
        status = over_size(status, tolerance, size, error);
        if (status == TAUT_OK) {
            status = taut_operate_add_curve(made, converted, error);
        }
        largest = fmax(largest, one);
        status = taut_operate_placed(status, "curves", i, error);
    }
    status = taut_operate_end(status, made, nurbs);
    if (status == TAUT_OK && bound != NULL) {
        *bound = largest;
    }
    return status;
}
