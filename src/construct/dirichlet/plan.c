#include "construct/dirichlet/plan.h"

#include "core/fail.h"
#include "core/memory.h"

#include <string.h>

static size_t count_of(const taut_dirichlet_problem *problem)
{
    return (size_t)taut_basis_count(problem->u) * (size_t)taut_basis_count(problem->v);
}

/* Copies of the bases, the known places and the weights, and the mask of the unknowns. */
static taut_status copy_problem(const taut_dirichlet_problem *problem, taut_dirichlet_plan *plan)
{
    const size_t count = count_of(problem);
    taut_status status = TAUT_OK;

    plan->arena = taut_arena_new();
    if (plan->arena == NULL) {
        return TAUT_NO_MEMORY;
    }
    plan->known = taut_arena_take(plan->arena, count, 1);
    if (plan->known == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        plan->known[i] = problem->known[i] != 0;
    }
    if (problem->weights != NULL) {
        plan->weights = taut_arena_take(plan->arena, count, sizeof(double));
        if (plan->weights == NULL) {
            return TAUT_NO_MEMORY;
        }
        memcpy(plan->weights, problem->weights, count * sizeof(double));
    }
    status = taut_basis_copy(problem->u, &plan->u);
    if (status == TAUT_OK) {
        status = taut_basis_copy(problem->v, &plan->v);
    }
    if (status == TAUT_OK) {
        status = taut_mask_new(taut_basis_count(plan->u), taut_basis_count(plan->v), plan->known,
                               plan->arena, &plan->mask);
    }
    return status;
}

taut_status taut_dirichlet_plan_new(const taut_dirichlet_problem *problem,
                                    const taut_monitor *monitor, taut_dirichlet_plan **plan,
                                    taut_error *error)
{
    taut_dirichlet_plan *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = TAUT_OK;

    if (made == NULL || copy_problem(problem, made) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    if (status == TAUT_OK && made->mask.unknowns > 0) {
        status = taut_dirichlet_form_new(made->u, made->v, made->weights, &made->form, error);
        if (status == TAUT_OK) {
            status =
                taut_dirichlet_system_new(&made->form, &made->mask, monitor, &made->system, error);
        }
    }
    if (status != TAUT_OK) {
        taut_dirichlet_plan_free(made);
        return status;
    }
    made->is_lasting = made->form.rational == NULL;
    *plan = made;
    return TAUT_OK;
}

void taut_dirichlet_plan_free(void *plan)
{
    taut_dirichlet_plan *p = plan;
    if (p != NULL) {
        taut_dirichlet_system_free(p->system);
        taut_dirichlet_form_clear(&p->form);
        taut_basis_free(p->u);
        taut_basis_free(p->v);
        taut_arena_free(p->arena);
        taut_free(p);
    }
}

int taut_dirichlet_plan_serves(const taut_dirichlet_plan *plan,
                               const taut_dirichlet_problem *problem)
{
    const size_t count = count_of(problem);
    if (!taut_basis_equal(plan->u, problem->u) || !taut_basis_equal(plan->v, problem->v) ||
        (plan->weights == NULL) != (problem->weights == NULL) ||
        (plan->weights != NULL &&
         memcmp(plan->weights, problem->weights, count * sizeof(double)) != 0)) {
        return 0;
    }
    for (size_t i = 0; i < count; i++) {
        if (plan->known[i] != (problem->known[i] != 0)) {
            return 0;
        }
    }
    return 1;
}
