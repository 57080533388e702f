#include "geometry/operate/points.h"

#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>

taut_status taut_operate_points(const double *matrix, size_t count, const double *points,
                                double **moved, taut_error *error)
{
    double *made = NULL;
    for (int i = 0; i < 12; i++) {
        if (!isfinite(matrix[i])) {
            return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, matrix[i], taut_none,
                             "a number of the matrix is not finite");
        }
    }
    made = taut_alloc(3 * count, sizeof(double));
    if (made == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t i = 0; i < count; i++) {
        for (size_t c = 0; c < 3; c++) {
            const double *row = matrix + 4 * c, *x = points + 3 * i;
            made[3 * i + c] = taut_dot(row, x) + row[3];
        }
    }
    *moved = made;
    return TAUT_OK;
}

/* Why an object was not added. */
static taut_status refuse_object(taut_status status, taut_error *error)
{
    if (status == TAUT_NO_MEMORY) {
        return taut_fail_memory(error);
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "too-many-objects", NULL, TAUT_OBJECTS_MAX,
                     TAUT_OBJECTS_MAX, "a model holds at most %d surfaces and as many curves",
                     TAUT_OBJECTS_MAX);
}

taut_status taut_operate_add_surface(taut_model *model, taut_surface *surface, taut_error *error)
{
    const taut_status status = taut_model_add_surface(model, surface);
    if (status != TAUT_OK) {
        taut_surface_free(surface);
        return refuse_object(status, error);
    }
    return TAUT_OK;
}

taut_status taut_operate_add_curve(taut_model *model, taut_curve *curve, taut_error *error)
{
    const taut_status status = taut_model_add_curve(model, curve);
    if (status != TAUT_OK) {
        taut_curve_free(curve);
        return refuse_object(status, error);
    }
    return TAUT_OK;
}

taut_status taut_operate_copy_surface(const taut_surface *surface, taut_model *to,
                                      taut_error *error)
{
    taut_surface *copy = NULL;
    if (taut_surface_copy(surface, &copy) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return taut_operate_add_surface(to, copy, error);
}

taut_status taut_operate_copy_curve(const taut_curve *curve, taut_model *to, taut_error *error)
{
    taut_curve *copy = NULL;
    if (taut_curve_copy(curve, &copy) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return taut_operate_add_curve(to, copy, error);
}

taut_status taut_operate_begin(const taut_model *model, taut_model **made, taut_error *error)
{
    if (taut_model_new(made) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_model_set_unit(*made, taut_model_unit(model));
    return TAUT_OK;
}

/* Hands the model over, or frees it. */
taut_status taut_operate_end(taut_status status, taut_model *made, taut_model **result)
{
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *result = made;
    return TAUT_OK;
}

/* Puts "/surfaces/i" or "/curves/i" before the place of a failure. */
taut_status taut_operate_placed(taut_status status, const char *array, int i, taut_error *error)
{
    if (status != TAUT_OK && status != TAUT_NO_MEMORY) {
        char prefix[48];
        snprintf(prefix, sizeof prefix, "/%s/%d", array, i);
        taut_error_prefix(error, prefix);
    }
    return status;
}
