#include "io/cad/format_nurbs.h"

#include "core/fail.h"
#include "io/format.h"
#include "taut/operations.h"

/* Only the surface that is asked for, or all there is. */
static taut_status choose(const taut_model *model, const taut_write_options *options,
                          taut_model **chosen)
{
    taut_model *made = NULL;
    taut_surface *copy = NULL;
    taut_curve *curve = NULL;
    taut_status status = taut_model_new(&made);

    if (status == TAUT_OK) {
        taut_model_set_unit(made, taut_model_unit(model));
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(model); i++) {
        if (taut_format_wants(model, options, i)) {
            status = taut_surface_copy(taut_model_surface(model, i), &copy);
            if (status == TAUT_OK && taut_model_add_surface(made, copy) != TAUT_OK) {
                taut_surface_free(copy);
                status = TAUT_NO_MEMORY;
            }
        }
    }
    for (int i = 0;
         status == TAUT_OK && options->surface == NULL && i < taut_model_curve_count(model); i++) {
        status = taut_curve_copy(taut_model_curve(model, i), &curve);
        if (status == TAUT_OK && taut_model_add_curve(made, curve) != TAUT_OK) {
            taut_curve_free(curve);
            status = TAUT_NO_MEMORY;
        }
    }
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *chosen = made;
    return TAUT_OK;
}

taut_status taut_format_nurbs(const taut_model *model, const taut_write_options *options,
                              double tolerance, taut_model **nurbs, double *bound,
                              taut_error *error)
{
    taut_model *chosen = NULL;
    taut_status status = TAUT_OK;

    if (taut_model_surface_count(model) + taut_model_curve_count(model) == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", NULL, 0, 1,
                         "the model has neither surfaces nor curves");
    }
    if (choose(model, options, &chosen) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = taut_model_to_nurbs(chosen, tolerance, nurbs, bound, error);
    taut_model_free(chosen);
    return status;
}
