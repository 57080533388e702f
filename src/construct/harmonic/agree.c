/* agree.c -- rows of even degree over-determine a surface of bidegree (n, n): their v^n
 * coefficients must agree ([NiWang2015] section 2.4). Refuse, or one of three repairs (section 3,
 * B.1). */
#include "construct/harmonic/lidstone.h"
#include "construct/harmonic/task.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>

/* delta, what must vanish: the difference of the rows' top differences, or the top difference of
 * the cross derivative. */
static void defect_of(const taut_harmonic_task *task, double delta[3])
{
    double first[3] = {0, 0, 0};
    const int from_derivative = task->problem->given == TAUT_HARMONIC_DERIVATIVE;
    taut_top_difference(task->m, task->row[1], delta);
    taut_top_difference(task->m, task->row[0], first);
    for (int c = 0; c < 3; c++) {
        delta[c] = from_derivative ? task->width * delta[c] : delta[c] - first[c];
    }
}

/* Moves the last point of the second row. */
static void repair_corner(taut_harmonic_task *task, const double delta[3])
{
    for (int c = 0; c < 3; c++) {
        task->row[1][3 * task->m + c] -= delta[c];
    }
    task->repair_change = taut_largest_coordinate(delta) * task->map.size;
}

/* The least change of both rows: +- w_j delta with w_j = (-1)^(m-j) C(m,j) / (2 C(2m,m)). */
static void repair_project(taut_harmonic_task *task, const double delta[3])
{
    const int m = task->m;
    double weight = 0.5; /* C(m,j) / (2 C(2m,m)), from j = 0 */
    double most = 0;
    for (int i = 1; i <= m; i++) {
        weight *= (double)i / (m + i);
    }
    for (int j = 0; j <= m; j++) {
        const double w = (m - j) % 2 == 0 ? weight : -weight;
        for (int c = 0; c < 3; c++) {
            task->row[0][3 * j + c] += w * delta[c];
            task->row[1][3 * j + c] -= w * delta[c];
        }
        most = fmax(most, weight);
        weight *= (double)(m - j) / (j + 1);
    }
    task->repair_change = most * taut_largest_coordinate(delta) * task->map.size;
}

static taut_status fail_inconsistent(const taut_harmonic_task *task, double defect, double limit,
                                     taut_error *error)
{
    if (task->problem->given == TAUT_HARMONIC_DERIVATIVE) {
        return taut_fail(error, TAUT_NO_SOLUTION, "inconsistent", "/cross_derivative", defect,
                         limit,
                         "inconsistent derivative: the degree %d is even and the top difference of "
                         "the cross derivative is %.6g, not 0; \"even\": \"raise\" gives bidegree "
                         "(%d, %d)",
                         task->m, defect, task->n + 1, task->m);
    }
    return taut_fail(
        error, TAUT_NO_SOLUTION, "inconsistent", "/points", defect, limit,
        "inconsistent boundary: the degree %d is even and the top differences of the two "
        "rows differ by %.6g, not 0; \"even\" can be \"corner\", \"project\" or \"raise\"",
        task->m, defect);
}

taut_status taut_harmonic_agree(taut_harmonic_task *task, taut_error *error)
{
    const taut_harmonic_even even = taut_harmonic_even_of(task->problem);
    /* a repair that was asked for is made of all that rounding does not explain */
    const double rounding = 4 * ldexp(DBL_EPSILON, task->m) * taut_unit_map_reach(&task->map);
    const double limit = even == TAUT_EVEN_REFUSE ? fmax(1e-10, rounding) : rounding;
    double delta[3] = {0, 0, 0};

    if (task->m % 2 != 0 || task->n != task->m) {
        if (task->corner_missing) {
            return taut_fail(error, TAUT_BAD_INPUT, "mask", "/points", taut_none, taut_none,
                             "the last point of the second row is null, but this bidegree does not "
                             "decide it");
        }
        return TAUT_OK;
    }
    defect_of(task, delta);
    if (task->corner_missing) {
        repair_corner(task, delta);
        task->repair_change = 0; /* nothing given was moved */
        return TAUT_OK;
    }
    if (taut_largest_coordinate(delta) <= limit) {
        return TAUT_OK;
    }
    task->repair = even;
    switch (even) {
    case TAUT_EVEN_RAISE:
        task->n++;
        return TAUT_OK;
    case TAUT_EVEN_CORNER:
        repair_corner(task, delta);
        return TAUT_OK;
    case TAUT_EVEN_PROJECT:
        repair_project(task, delta);
        return TAUT_OK;
    case TAUT_EVEN_REFUSE:
        break;
    }
    return fail_inconsistent(task, taut_largest_coordinate(delta) * task->map.size,
                             limit * task->map.size, error);
}
