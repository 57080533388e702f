#include "io/cad/format_nurbs.h"

#include "core/fail.h"
#include "io/format.h"
#include "taut/operations.h"

/* Only the surface that is asked for, or all there is, into an empty model. */
static taut_status copy_chosen(const taut_model *model, const taut_write_options *options,
                               taut_model *chosen)
{
    taut_surface *surface = NULL;
    taut_curve *curve = NULL;

    taut_model_set_unit(chosen, taut_model_unit(model));
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        if (!taut_format_wants(model, options, i)) {
            continue;
        }
        if (taut_surface_copy(taut_model_surface(model, i), &surface) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        if (taut_model_add_surface(chosen, surface) != TAUT_OK) {
            taut_surface_free(surface);
            return TAUT_NO_MEMORY;
        }
    }
    for (int i = 0; options->surface == NULL && i < taut_model_curve_count(model); i++) {
        if (taut_curve_copy(taut_model_curve(model, i), &curve) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        if (taut_model_add_curve(chosen, curve) != TAUT_OK) {
            taut_curve_free(curve);
            return TAUT_NO_MEMORY;
        }
    }
    return TAUT_OK;
}

taut_status taut_format_nurbs(const taut_model *model, const taut_write_options *options,
                              double tolerance, taut_model **nurbs, double *bound,
                              taut_error *error)
{
    taut_model *chosen = NULL;
    taut_status status = TAUT_OK;

    if (taut_model_surface_count(model) + taut_model_curve_count(model) == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "empty", NULL, 0, 1,
                         "the model has neither surfaces nor curves");
    }
    if (taut_model_new(&chosen) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = copy_chosen(model, options, chosen) == TAUT_OK
                 ? taut_model_to_nurbs(chosen, tolerance, nurbs, bound, error)
                 : taut_fail_memory(error);
    taut_model_free(chosen);
    return status;
}
