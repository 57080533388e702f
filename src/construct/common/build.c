#include "construct/common/build.h"

#include "core/fail.h"

taut_status taut_construct_build(taut_construct_builder *build, void *context, taut_model **model,
                                 taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    taut_model *made = NULL;
    taut_status status = arena != NULL && taut_model_new(&made) == TAUT_OK
                             ? build(context, arena, made, error)
                             : taut_fail_memory(error);

    taut_arena_free(arena);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *model = made;
    return TAUT_OK;
}

/* Two bases, or none. */
static taut_status make_bases(const taut_basis_spec specs[2], const int counts[2],
                              taut_basis *bases[2], taut_error *error)
{
    taut_status status = taut_basis_new(&specs[0], counts[0], &bases[0], error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_basis_new(&specs[1], counts[1], &bases[1], error);
    if (status != TAUT_OK) {
        taut_basis_free(bases[0]);
    }
    return status;
}

taut_status taut_construct_add_net(taut_model *model, const char *name,
                                   const taut_basis_spec specs[2], const int counts[2],
                                   const double *points, const double *weights,
                                   const char *const *exact, taut_error *error)
{
    taut_basis *bases[2] = {NULL, NULL};
    taut_surface *surface = NULL;
    taut_status status = make_bases(specs, counts, bases, error);

    if (status != TAUT_OK) {
        return status;
    }
    status =
        taut_surface_new_exact(name, bases[0], bases[1], points, weights, exact, &surface, error);
    taut_basis_free(bases[0]);
    taut_basis_free(bases[1]);
    return status == TAUT_OK ? taut_construct_add_surface(model, surface, error) : status;
}

taut_status taut_construct_add_surface(taut_model *model, taut_surface *surface, taut_error *error)
{
    if (taut_model_add_surface(model, surface) == TAUT_OK) {
        return TAUT_OK;
    }
    taut_surface_free(surface);
    return taut_fail_memory(error);
}

taut_status taut_construct_add_curve(taut_model *model, taut_curve *curve, taut_error *error)
{
    if (taut_model_add_curve(model, curve) == TAUT_OK) {
        return TAUT_OK;
    }
    taut_curve_free(curve);
    return taut_fail_memory(error);
}

taut_status taut_construct_set_details(taut_model *model, taut_record *details, taut_error *error)
{
    if (taut_record_status(details) == TAUT_OK) {
        taut_model_set_details(model, details);
        return TAUT_OK;
    }
    taut_record_free(details);
    return taut_fail_memory(error);
}
