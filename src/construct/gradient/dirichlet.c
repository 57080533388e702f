/* dirichlet.c -- derivatives through the surface of least Dirichlet energy.
 *
 *     A_pp p = -A_pk k,    dF/dk = F_k - A_kp l,    A_pp l = F_p      ([WuWang2011] section 3)
 *
 * A is symmetric, so the solve is the construction's own with another right side.
 */
#include "construct/dirichlet/system.h"
#include "construct/gradient/gradient.h"
#include "core/fail.h"

#include <math.h>
#include <string.h>

/* right = F_p, between 1/2 and 1 at the largest; the power of two that was taken out. */
static int scale_right(const taut_mask *mask, const double *seed, double *right)
{
    const size_t size = 3 * (size_t)mask->nu * (size_t)mask->nv;
    double largest = 0;
    int exponent = 0;

    memcpy(right, seed, size * sizeof(double));
    taut_mask_clear_known(mask, right);
    for (size_t i = 0; i < size; i++) {
        largest = fmax(largest, fabs(right[i]));
    }
    (void)frexp(largest, &exponent);
    for (size_t i = 0; i < size; i++) {
        right[i] = ldexp(right[i], -exponent);
    }
    return exponent;
}

/* seed -= A l 2^exponent at known points, 0 at the others. */
static taut_status subtract_product(const taut_dirichlet_form *form, const taut_mask *mask,
                                    int exponent, const double *l, double *product, double *seed)
{
    const taut_status status = taut_dirichlet_form_apply(form, l, product);
    for (size_t i = 0; i < 3 * (size_t)mask->nu * (size_t)mask->nv; i++) {
        seed[i] = mask->known[i / 3] ? seed[i] - ldexp(product[i], exponent) : 0;
    }
    return status;
}

static taut_status pull(const taut_dirichlet_problem *problem, const taut_mask *mask,
                        taut_dirichlet_form *form, const taut_monitor *monitor, double *nets[2],
                        double *seed, taut_error *error)
{
    taut_dirichlet_system *system = NULL;
    const int exponent = scale_right(mask, seed, nets[0]);
    taut_status status = taut_dirichlet_system_new(form, mask, monitor, 1, &system, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_dirichlet_system_solve_right(system, problem->aspect > 0 ? problem->aspect : 1,
                                               nets[0], nets[1], error);
    if (status == TAUT_OK &&
        subtract_product(form, mask, exponent, nets[1], nets[0], seed) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    taut_dirichlet_system_free(system);
    return status;
}

taut_status taut_gradient_pull_dirichlet(const taut_dirichlet_problem *problem,
                                         const taut_monitor *monitor, taut_arena *arena,
                                         double *seed, taut_error *error)
{
    const int nu = taut_basis_count(problem->u), nv = taut_basis_count(problem->v);
    const size_t count = (size_t)nu * (size_t)nv;
    double *nets[2] = {taut_arena_take(arena, count, 3 * sizeof(double)),
                       taut_arena_take(arena, count, 3 * sizeof(double))};
    taut_dirichlet_form form;
    taut_mask mask;
    taut_status status = TAUT_OK;

    if (taut_mask_new(nu, nv, problem->known, arena, &mask) != TAUT_OK ||
        taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (mask.unknowns == 0) {
        return TAUT_OK;
    }
    status = taut_dirichlet_form_new(problem->u, problem->v, problem->weights, &form, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = pull(problem, &mask, &form, monitor, nets, seed, error);
    taut_dirichlet_form_clear(&form);
    return status;
}

static taut_status pull_problem(const void *context, const taut_surface *surface,
                                const taut_gradient_request *request, taut_arena *arena,
                                double *seed, taut_error *error)
{
    (void)surface;
    return taut_gradient_pull_dirichlet(context, &request->monitor, arena, seed, error);
}

taut_status taut_dirichlet_gradient(const taut_dirichlet_problem *problem, const taut_model *model,
                                    const taut_gradient_request *request, double *gradient,
                                    taut_error *error)
{
    if (problem == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_dirichlet_gradient needs a problem");
    }
    if (problem->aspect_auto) {
        return taut_gradient_refuse("an aspect that is searched for moves with the points: give it "
                                    "as a number",
                                    error);
    }
    if (problem->through_count > 0) {
        return taut_gradient_refuse(
            "points to pass through hold the surface besides those that are known: "
            "leave them out",
            error);
    }
    const taut_gradient_net net = {problem->u, problem->v, problem->points, problem->known, 0};
    return taut_gradient_run(&net, model, request, pull_problem, problem, gradient, error);
}
