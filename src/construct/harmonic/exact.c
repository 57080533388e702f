/* exact.c -- completion in rational arithmetic (core/exact.h): the lines with their texts, and what
 * to do when those of even degree do not agree. */
#include "core/exact.h"

#include "construct/harmonic/task.h"
#include "core/fail.h"

#include <string.h>

/* Line `side` of the problem as it was given. */
static taut_status line_of(const taut_harmonic_task *task, int side, taut_exact_numbers *line)
{
    const taut_harmonic_problem *p = task->problem;
    const size_t count = 3 * ((size_t)task->m + 1);
    double *values = taut_arena_take(task->arena, count, sizeof *values);
    const char **texts = taut_arena_take(task->arena, count, sizeof *texts);

    if (values == NULL || texts == NULL) {
        return TAUT_NO_MEMORY;
    }
    const int rows = p->given == TAUT_HARMONIC_ROWS;
    const double *from = rows        ? p->rows.points
                         : side == 0 ? p->derivative.edge
                                     : p->derivative.cross;
    const char *const *exact = rows        ? p->rows.exact
                               : side == 0 ? p->derivative.exact_edge
                                           : p->derivative.exact_cross;
    for (size_t k = 0; k < count; k++) {
        const size_t at =
            rows ? 3 * taut_harmonic_index(task, side * task->n, (int)(k / 3)) + k % 3 : k;
        values[k] = from[at];
        texts[k] = exact != NULL ? exact[at] : NULL;
    }
    line->values = values;
    line->texts = texts;
    return TAUT_OK;
}

static taut_status fail_inconsistent(const taut_harmonic_task *task, double defect,
                                     taut_error *error)
{
    const int from_derivative = task->problem->given == TAUT_HARMONIC_DERIVATIVE;
    return taut_fail(error, TAUT_NO_SOLUTION, "inconsistent",
                     from_derivative ? "/cross_derivative" : "/points", defect, 0,
                     "inconsistent %s: the degree %d is even and the top difference is %.6g, not "
                     "exactly 0; \"even\" can repair it",
                     from_derivative ? "derivative" : "boundary", task->m, defect);
}

taut_status taut_harmonic_exact(taut_harmonic_task *task, taut_error *error)
{
    const taut_harmonic_problem *p = task->problem;
    const taut_basis *across = task->turned ? p->v : p->u, *along = task->turned ? p->u : p->v;
    const taut_exact_memory memory = taut_exact_memory_of(task->arena);
    const taut_exact_ops *ops = NULL;
    taut_exact_net net;
    taut_exact_lines lines = {.n = task->n,
                              .m = task->m,
                              .across = {taut_basis_lo(across), taut_basis_hi(across)},
                              .along = {taut_basis_lo(along), taut_basis_hi(along)},
                              .from_derivative = p->given == TAUT_HARMONIC_DERIVATIVE,
                              .corner_missing = task->corner_missing,
                              .even = (int)taut_harmonic_even_of(p)};
    taut_status status = taut_exact_load(&ops, error);

    if (status != TAUT_OK) {
        return status;
    }
    memset(&net, 0, sizeof net);
    if (line_of(task, 0, &lines.line[0]) != TAUT_OK ||
        line_of(task, 1, &lines.line[1]) != TAUT_OK || !ops->complete(&lines, &memory, &net)) {
        return taut_fail_memory(error);
    }
    if (net.values == NULL) {
        return fail_inconsistent(task, net.defect, error);
    }
    task->n = net.n;
    task->net = net.values;
    task->texts = net.texts;
    task->repair = net.moved ? taut_harmonic_even_of(p) : TAUT_EVEN_REFUSE;
    task->repair_change = net.change;
    return TAUT_OK;
}
