/* collect.c -- what is asked for: which points are known, and the rows they make. */
#include "construct/harmonic/task.h"
#include "core/fail.h"

#include <math.h>
#include <string.h>

taut_harmonic_even taut_harmonic_even_of(const taut_harmonic_problem *problem)
{
    if (problem->given == TAUT_HARMONIC_DERIVATIVE) {
        return problem->derivative.raise ? TAUT_EVEN_RAISE : TAUT_EVEN_REFUSE;
    }
    return problem->rows.even;
}

static double width_of(const taut_basis *basis)
{
    return taut_basis_hi(basis) - taut_basis_lo(basis);
}

/* Point j of line i, i across the known rows. */
size_t taut_harmonic_index(const taut_harmonic_task *task, int i, int j)
{
    const int columns = taut_basis_count(task->problem->v);
    return task->turned ? (size_t)j * (size_t)columns + (size_t)i
                        : (size_t)i * (size_t)columns + (size_t)j;
}

static void set_direction(taut_harmonic_task *task, int turned)
{
    const taut_basis *across = turned ? task->problem->v : task->problem->u;
    const taut_basis *along = turned ? task->problem->u : task->problem->v;
    const taut_twice ratio =
        taut_twice_over_number(taut_twice_of(width_of(across)), width_of(along));
    task->turned = turned;
    task->n = taut_basis_degree(across);
    task->m = taut_basis_degree(along);
    task->mu = taut_twice_times(ratio, ratio);
}

/* Do the known points make two opposite lines in this direction and nothing else? The last point of
 * the second may be missing where the degree along is even. */
static int is_two_lines(taut_harmonic_task *task, int turned)
{
    set_direction(task, turned);
    task->corner_missing = 0;
    for (int i = 0; i <= task->n; i++) {
        for (int j = 0; j <= task->m; j++) {
            const int known = task->problem->rows.known[taut_harmonic_index(task, i, j)] != 0;
            const int wanted = i == 0 || i == task->n;
            const int corner = i == task->n && j == task->m && task->m % 2 == 0;
            if (known != wanted && !(corner && !known)) {
                return 0;
            }
            task->corner_missing = corner && !known ? 1 : task->corner_missing;
        }
    }
    return 1;
}

/* 0 when memory runs out. */
static int copy_rows(taut_harmonic_task *task, const double *first, const double *second)
{
    const size_t count = (size_t)task->m + 1;
    task->row[0] = taut_arena_copy(task->arena, first, 3 * count, sizeof(double));
    task->row[1] = taut_arena_copy(task->arena, second, 3 * count, sizeof(double));
    return taut_arena_status(task->arena) == TAUT_OK;
}

/* The two known lines, out of the net. */
static taut_status collect_lines(taut_harmonic_task *task, taut_error *error)
{
    const taut_harmonic_problem *problem = task->problem;
    double lines[2][TAUT_DEGREE_MAX + 1][3];
    const size_t points =
        (size_t)taut_basis_count(problem->u) * (size_t)taut_basis_count(problem->v);

    task->map = taut_unit_map_of(points, problem->rows.points, problem->rows.known);
    for (int side = 0; side < 2; side++) {
        for (int j = 0; j <= task->m; j++) {
            const size_t index = taut_harmonic_index(task, side * task->n, j);
            memcpy(lines[side][j], problem->rows.points + 3 * index, sizeof lines[side][j]);
        }
    }
    if (task->corner_missing) { /* any number will do: it is computed */
        memcpy(lines[1][task->m], lines[0][task->m], sizeof lines[1][0]);
    }
    if (!copy_rows(task, &lines[0][0][0], &lines[1][0][0])) {
        return taut_fail_memory(error);
    }
    taut_unit_map_apply(&task->map, (size_t)task->m + 1, task->row[0]);
    taut_unit_map_apply(&task->map, (size_t)task->m + 1, task->row[1]);
    return TAUT_OK;
}

/* Edge u0 and dx/du along it. */
static taut_status collect_derivative(taut_harmonic_task *task, taut_error *error)
{
    const taut_harmonic_problem *problem = task->problem;
    const double *edge = problem->derivative.edge;
    double size = 0;

    set_direction(task, 0);
    if (!copy_rows(task, edge, problem->derivative.cross)) {
        return taut_fail_memory(error);
    }
    task->map = taut_unit_map_of((size_t)task->m + 1, edge, NULL);
    task->width = width_of(problem->u);
    for (int i = 0; i < 3 * (task->m + 1); i++) {
        size = fmax(size, fabs(task->row[1][i]) * task->width);
    }
    if (size > task->map.size) {
        task->map.size = taut_unit_map_size(size);
    }
    taut_unit_map_apply(&task->map, (size_t)task->m + 1, task->row[0]);
    for (int i = 0; i < 3 * (task->m + 1); i++) {
        task->row[1][i] /= task->map.size;
    }
    return TAUT_OK;
}

taut_status taut_harmonic_collect(taut_harmonic_task *task, taut_error *error)
{
    if (task->problem->given == TAUT_HARMONIC_DERIVATIVE) {
        return collect_derivative(task, error);
    }
    if (is_two_lines(task, 0) || is_two_lines(task, 1)) {
        return collect_lines(task, error);
    }
    return taut_fail(error, TAUT_BAD_INPUT, "mask", "/points", taut_none, taut_none,
                     "expected two opposite boundary rows, or two opposite columns, and null "
                     "everywhere else");
}
