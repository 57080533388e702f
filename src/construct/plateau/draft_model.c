#include "construct/plateau/draft_model.h"

#include "construct/common/build.h"
#include "construct/common/scaling.h"
#include "construct/plateau/draft.h"
#include "core/fail.h"

typedef struct request {
    const taut_dirichlet_problem *net;
    const taut_surface *before;
    int steps;
} request;

static int has_draft(const taut_plateau_problem *problem, const taut_surface *before)
{
    const taut_dirichlet_problem *net = &problem->net;

    return problem->curves[0] == NULL && problem->start == NULL && net->weights == NULL &&
           net->through_count == 0 && before != NULL && taut_surface_weights(before) == NULL &&
           taut_basis_equal(taut_surface_u(before), net->u) &&
           taut_basis_equal(taut_surface_v(before), net->v);
}

static taut_status find_points(const request *r, taut_arena *arena, double *points,
                               taut_error *error)
{
    const taut_dirichlet_problem *net = r->net;
    const int nu = taut_basis_count(net->u), nv = taut_basis_count(net->v);
    const size_t count = (size_t)nu * (size_t)nv;
    const taut_scaling scaling = taut_scaling_of(count, net->points, net->known);
    double *held = taut_arena_take(arena, count, 3 * sizeof(double));
    double *drafted = taut_arena_take(arena, count, 3 * sizeof(double));
    taut_area_functional *functional = NULL;
    taut_mask mask;

    if (held == NULL || drafted == NULL ||
        taut_mask_new(nu, nv, net->known, arena, &mask) != TAUT_OK ||
        taut_area_functional_new(net->u, net->v, NULL, TAUT_AREA_DRAFT_EXTRA, &functional) !=
            TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_scaling_apply(&scaling, count, net->points, net->known, held);
    taut_scaling_apply(&scaling, count, taut_surface_points(r->before), NULL, drafted);
    taut_status status =
        mask.unknowns > 0 ? taut_area_draft(functional, &mask, held, r->steps, drafted) : TAUT_OK;
    taut_area_functional_free(functional);
    return status == TAUT_OK
               ? taut_scaling_undo(&scaling, count, net->points, net->known, drafted, points, error)
               : taut_fail_status(error, status);
}

static taut_status build(void *context, taut_arena *arena, taut_model *model, taut_error *error)
{
    const request *r = context;
    const size_t count = (size_t)taut_basis_count(r->net->u) * (size_t)taut_basis_count(r->net->v);
    double *points = taut_arena_take(arena, count, 3 * sizeof(double));
    taut_surface *surface = NULL;

    if (points == NULL) {
        return taut_fail_memory(error);
    }
    taut_status status = find_points(r, arena, points, error);
    if (status == TAUT_OK) {
        status = taut_surface_new(r->net->name != NULL ? r->net->name : "plateau", r->net->u,
                                  r->net->v, points, NULL, &surface, error);
    }
    return status == TAUT_OK ? taut_construct_add_surface(model, surface, error) : status;
}

taut_status taut_plateau_draft(const taut_plateau_problem *problem, const taut_model *before,
                               int steps, taut_model **model, taut_error *error)
{
    request r = {.net = &problem->net, .before = taut_model_surface(before, 0), .steps = steps};
    return has_draft(problem, r.before) ? taut_construct_build(build, &r, model, error) : TAUT_OK;
}
