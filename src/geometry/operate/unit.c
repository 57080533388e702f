/* unit.c -- a model told in another unit: every coordinate times one number. */
#include "taut/operations.h"

#include "core/fail.h"
#include "core/unit.h"
#include "geometry/operate/change.h"
#include "geometry/operate/points.h"

static taut_status scale_objects(const taut_model *model, const double matrix[12], taut_model *to,
                                 taut_error *error)
{
    taut_status status = TAUT_OK;

    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(model); i++) {
        taut_surface *moved = NULL;
        status = taut_surface_transform(taut_model_surface(model, i), matrix, &moved, error);
        status = taut_operate_placed(status, "surfaces", i, error);
        status = status == TAUT_OK ? taut_operate_add_surface(to, moved, error) : status;
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_curve_count(model); i++) {
        taut_curve *moved = NULL;
        status = taut_curve_transform(taut_model_curve(model, i), matrix, &moved, error);
        status = taut_operate_placed(status, "curves", i, error);
        status = status == TAUT_OK ? taut_operate_add_curve(to, moved, error) : status;
    }
    return status;
}

taut_status taut_model_to_unit(const taut_model *model, const char *unit, taut_model **converted,
                               taut_error *error)
{
    if (model == NULL || unit == NULL || converted == NULL) {
        return taut_operate_null(error);
    }
    const double ratio = taut_unit_ratio(taut_model_unit(model), unit);
    const double matrix[12] = {ratio, 0, 0, 0, 0, ratio, 0, 0, 0, 0, ratio, 0};
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (!(ratio > 0)) {
        return taut_fail_expected(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none,
                                  "mm, cm, m, in or ft", "\"%.20s\" is no unit of length", unit);
    }
    status = taut_operate_begin(model, &made, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_model_set_unit(made, unit);
    status = status == TAUT_OK ? scale_objects(model, matrix, made, error) : status;
    return taut_operate_end(status, made, converted);
}
