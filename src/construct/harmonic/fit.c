/* fit.c -- the harmonic surface nearest to four boundary rows ([NiWang2015] section 8.3): the sum
 * over the edges of the mean squared distance is least, over all harmonic polynomials of the
 * bidegree. */
#include "construct/harmonic/rim.h"
#include "construct/harmonic/task.h"
#include "core/fail.h"

static taut_status check_mask(const taut_harmonic_problem *problem, taut_error *error)
{
    const int nu = taut_basis_count(problem->u), nv = taut_basis_count(problem->v);
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const int edge = i == 0 || i == nu - 1 || j == 0 || j == nv - 1;
            if ((problem->boundary.known[i * nv + j] != 0) != edge) {
                return taut_fail(error, TAUT_BAD_INPUT, "mask", "/points", taut_none, taut_none,
                                 "expected, with \"fit\", the four boundary rows and null inside");
            }
        }
    }
    if (nu - 1 > TAUT_SPACE_DEGREE_MAX || nv - 1 > TAUT_SPACE_DEGREE_MAX) {
        const int degree = nu > nv ? nu - 1 : nv - 1;
        return taut_fail(error, TAUT_NO_SOLUTION, "degree", nu > nv ? "/u/degree" : "/v/degree",
                         degree, TAUT_SPACE_DEGREE_MAX, "\"fit\" goes to degree %d, found %d",
                         TAUT_SPACE_DEGREE_MAX, degree);
    }
    return TAUT_OK;
}

taut_status taut_harmonic_fit(taut_harmonic_task *task, taut_error *error)
{
    const taut_harmonic_problem *problem = task->problem;
    taut_status status = check_mask(problem, error);
    taut_space space;
    taut_rim boundary;

    if (status != TAUT_OK) {
        return status;
    }
    task->n = taut_basis_degree(problem->u);
    task->m = taut_basis_degree(problem->v);
    const size_t points = (size_t)(task->n + 1) * (size_t)(task->m + 1);
    const double across = taut_basis_hi(problem->u) - taut_basis_lo(problem->u);
    const double along = taut_basis_hi(problem->v) - taut_basis_lo(problem->v);
    task->net = taut_arena_copy(task->arena, problem->boundary.points, 3 * points, sizeof(double));
    if (task->net == NULL ||
        !taut_space_harmonic(task->n, task->m, across, along, task->arena, task->pulse, &space) ||
        !taut_rim_solve(&space, task->arena, &boundary)) {
        return taut_fail_memory(error);
    }
    task->map = taut_unit_map_of(points, problem->boundary.points, problem->boundary.known);
    taut_unit_map_apply(&task->map, points, task->net);
    if (!taut_rim_net(&boundary, task->arena, task->net, task->net)) {
        return taut_fail_memory(error);
    }
    taut_unit_map_undo(&task->map, points, task->net);
    task->amplification = taut_rim_amplification(&boundary);
    return TAUT_OK;
}
