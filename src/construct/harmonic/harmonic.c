/* harmonic.c -- construct `harmonic`: collect the data, make it agree, sum the series, put it back.
 */
#include "taut/harmonic.h"

#include "construct/common/build.h"
#include "construct/construct_ops.h"
#include "construct/harmonic/complete.h"
#include "construct/harmonic/task.h"
#include "core/fail.h"

#include <math.h>
#include <string.h>

/* Past this the net means nothing in double precision; from the warning on, data known to
 * rounding gives less than nine digits ([NiWang2015] section 7: degrees 21 and 12 for two rows on a
 * square). */
static const double amplification_limit = 1e15, amplification_warning = 5e6;

/* Of the degrees that the net has in the end. */
static taut_status measure_amplification(taut_harmonic_task *task, taut_error *error)
{
    const int n = task->n, m = task->m;
    const size_t points = (size_t)(n + 1) * (size_t)(m + 1);

    if (task->problem->given == TAUT_HARMONIC_ROWS) {
        task->amplification =
            taut_harmonic_rows_amplification(n, m, taut_twice_round(task->mu), task->pulse);
        return TAUT_OK;
    }
    taut_twice *net = taut_arena_take(task->arena, 3 * points, sizeof *net);
    double *sum = taut_arena_take(task->arena, points, sizeof *sum);
    if (taut_arena_status(task->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    task->amplification =
        taut_harmonic_derivative_amplification(n, m, task->mu, net, sum, task->pulse);
    return TAUT_OK;
}

static taut_status check_amplification(const taut_harmonic_task *task, taut_error *error)
{
    const taut_harmonic_problem *problem = task->problem;
    const int allowed = problem->given == TAUT_HARMONIC_ROWS
                            ? problem->rows.allow_ill_conditioned
                            : problem->derivative.allow_ill_conditioned;
    if (!(task->amplification <= amplification_limit) && !allowed) {
        return taut_fail(
            error, TAUT_NO_SOLUTION, "ill-conditioned", "", task->amplification,
            amplification_limit,
            "rounding in the data would grow %.3g times, past %.0e: the result would mean "
            "nothing (\"allow_ill_conditioned\": true builds it all the same; a lower degree or "
            "data from one edge is better)",
            task->amplification, amplification_limit);
    }
    return TAUT_OK;
}

static taut_status check_degrees(const taut_harmonic_task *task, taut_error *error)
{
    if (task->n < task->m) {
        return taut_fail(
            error, TAUT_NO_SOLUTION, "degree", task->turned ? "/v/degree" : "/u/degree", task->n,
            task->m,
            "rows of degree %d need degree %d across them for a harmonic surface, found %d",
            task->m, task->m % 2 != 0 ? task->m : task->m + 1, task->n);
    }
    return TAUT_OK;
}

static size_t count_numbers(const taut_harmonic_task *task)
{
    return 3 * (size_t)(task->n + 1) * (size_t)(task->m + 1);
}

static int is_finite(const taut_harmonic_task *task)
{
    for (size_t i = 0; i < count_numbers(task); i++) {
        if (!isfinite(task->net[i])) {
            return 0;
        }
    }
    return 1;
}

static taut_status complete_net(taut_harmonic_task *task, taut_error *error)
{
    const size_t numbers = count_numbers(task);
    taut_twice *wide = taut_arena_take(task->arena, numbers, sizeof *wide);

    task->net = taut_arena_take(task->arena, numbers, sizeof(double));
    if (taut_arena_status(task->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (task->problem->given == TAUT_HARMONIC_DERIVATIVE) {
        taut_harmonic_from_derivative(task->n, task->m, task->mu, task->row[0], task->width,
                                      task->row[1], wide, task->net, task->pulse);
    } else {
        taut_harmonic_from_rows(task->n, task->m, task->mu, task->row[0], task->row[1], wide,
                                task->net, task->pulse);
    }
    taut_unit_map_undo(&task->map, numbers / 3, task->net);
    if (!is_finite(task)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "overflow", "", task->amplification,
                         amplification_limit,
                         "the control points overflow: degree %d amplifies the data %.3g times",
                         task->m, task->amplification);
    }
    return TAUT_OK;
}

/* The two rows come back bit for bit, but for what a repair moved. */
static void restore_rows(const taut_harmonic_task *task, double *points)
{
    const taut_harmonic_problem *problem = task->problem;
    const int nu = taut_basis_count(problem->u), nv = taut_basis_count(problem->v);
    if (task->repair == TAUT_EVEN_PROJECT) {
        return;
    }
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const int last_u = !task->turned && task->n + 1 > nu && i == nu - 1;
            const int last_v = task->turned && task->n + 1 > nv && j == nv - 1;
            const int rows = task->turned ? task->m : task->n,
                      columns = task->turned ? task->n : task->m;
            const int to_i = last_u ? rows : i, to_j = last_v ? columns : j;
            const int corner = to_i == rows && to_j == columns;
            if (problem->rows.known[i * nv + j] && !(corner && task->repair == TAUT_EVEN_CORNER)) {
                memcpy(points + 3 * (to_i * (columns + 1) + to_j),
                       problem->rows.points + 3 * (i * nv + j), 3 * sizeof(double));
            }
        }
    }
}

/* What was given comes back bit for bit; of a boundary nothing is kept. */
static void restore_given(const taut_harmonic_task *task, double *points)
{
    const taut_harmonic_problem *problem = task->problem;
    if (problem->given == TAUT_HARMONIC_DERIVATIVE) {
        memcpy(points, problem->derivative.edge,
               (size_t)taut_basis_count(problem->v) * 3 * sizeof(double));
    } else if (problem->given == TAUT_HARMONIC_ROWS) {
        restore_rows(task, points);
    }
}

/* A bezier basis of this degree over the range of another. */
static taut_basis_spec spec_like(const taut_basis *basis, int degree)
{
    taut_basis_spec spec;
    taut_basis_spec_of(basis, &spec);
    spec.degree = degree;
    return spec;
}

/* The net turned back, as a surface in a model. */
static taut_status add_surface(taut_harmonic_task *task, taut_model *model, taut_error *error)
{
    const taut_harmonic_problem *problem = task->problem;
    const int rows = task->turned ? task->m : task->n, columns = task->turned ? task->n : task->m;
    const taut_basis_spec specs[2] = {spec_like(problem->u, rows), spec_like(problem->v, columns)};
    const int counts[2] = {rows + 1, columns + 1};
    double *points = taut_arena_take(task->arena, count_numbers(task), sizeof(double));
    const char **texts = taut_arena_take(task->arena, count_numbers(task), sizeof *texts);

    if (taut_arena_status(task->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i <= rows; i++) {
        for (int j = 0; j <= columns; j++) {
            const int from = task->turned ? j * (rows + 1) + i : i * (columns + 1) + j;
            const int to = i * (columns + 1) + j;
            memcpy(points + 3 * to, task->net + 3 * from, 3 * sizeof(double));
            if (task->texts != NULL) {
                memcpy(texts + 3 * to, task->texts + 3 * from, 3 * sizeof *texts);
            }
        }
    }
    if (task->texts == NULL) {
        restore_given(task, points);
    }
    return taut_construct_add_net(model, problem->name != NULL ? problem->name : "harmonic", specs,
                                  counts, points, NULL, task->texts != NULL ? texts : NULL, error);
}

static taut_record *details_of(const taut_harmonic_task *task)
{
    static const char *const repairs[] = {NULL, "corner", "project", "raise"};
    taut_record *details = taut_record_new();
    taut_record_add_number(details, "amplification", task->amplification);
    if (task->repair != TAUT_EVEN_REFUSE) {
        taut_record *repair = taut_record_add_object(details, "repair");
        taut_record_add_text(repair, "kind", repairs[task->repair]);
        taut_record_add_number(repair, "change", task->repair_change);
    } else {
        taut_record_add_null(details, "repair");
    }
    if (task->texts != NULL) {
        taut_record_add_text(details, "arithmetic", "rational");
    } else if (task->amplification >= amplification_warning) {
        taut_record *warnings = taut_record_add_list(details, "warnings");
        taut_record_add_text(
            warnings, NULL,
            "rounding in the data grows by the amplification: expect few true digits");
    }
    return details;
}

static int has_data(const taut_harmonic_problem *problem)
{
    switch (problem->given) {
    case TAUT_HARMONIC_ROWS:
        return problem->rows.points != NULL && problem->rows.known != NULL;
    case TAUT_HARMONIC_DERIVATIVE:
        return problem->derivative.edge != NULL && problem->derivative.cross != NULL;
    case TAUT_HARMONIC_BOUNDARY:
        return problem->boundary.points != NULL && problem->boundary.known != NULL;
    }
    return 0;
}

static taut_status check_problem(const taut_harmonic_problem *problem, taut_error *error)
{
    if (problem == NULL || problem->u == NULL || problem->v == NULL || !has_data(problem)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a harmonic problem needs two bases and its data");
    }
    if (strcmp(taut_basis_type(problem->u), "bezier") != 0 ||
        strcmp(taut_basis_type(problem->v), "bezier") != 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "not-bezier",
                         strcmp(taut_basis_type(problem->u), "bezier") != 0 ? "/u" : "/v",
                         taut_none, taut_none, "expected a basis of type \"bezier\"");
    }
    return TAUT_OK;
}

/* Rational arithmetic amplifies nothing, so that any degree will do. */
static taut_status solve_exactly(taut_harmonic_task *task, taut_error *error)
{
    taut_status status = taut_harmonic_exact(task, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = measure_amplification(task, error);
    if (status == TAUT_OK && !is_finite(task)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "overflow", "", task->amplification,
                         amplification_limit,
                         "the control points are too large for doubles: degree %d amplifies the "
                         "data %.3g times",
                         task->m, task->amplification);
    }
    return status;
}

static taut_status solve_in_doubles(taut_harmonic_task *task, taut_error *error)
{
    taut_status status = taut_harmonic_agree(task, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = measure_amplification(task, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = check_amplification(task, error);
    return status == TAUT_OK ? complete_net(task, error) : status;
}

/* From the data to task->net. */
static taut_status solve_net(taut_harmonic_task *task, int exact, taut_error *error)
{
    taut_status status = TAUT_OK;
    if (task->problem->given == TAUT_HARMONIC_BOUNDARY) {
        return exact ? taut_fail(error, TAUT_BAD_ARGUMENT, "no-rationals", "/fit", taut_none,
                                 taut_none, "\"fit\" is not done in rational arithmetic")
                     : taut_harmonic_fit(task, error);
    }
    status = taut_harmonic_collect(task, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = check_degrees(task, error);
    if (status != TAUT_OK) {
        return status;
    }
    return exact ? solve_exactly(task, error) : solve_in_doubles(task, error);
}

typedef struct request {
    const taut_harmonic_problem *problem;
    int exact;
    taut_pulse *pulse;
} request;

static taut_status fill_model(void *context, taut_arena *arena, taut_model *model,
                              taut_error *error)
{
    const request *asked = context;
    taut_harmonic_task task = {.problem = asked->problem, .arena = arena, .pulse = asked->pulse};
    taut_status status = solve_net(&task, asked->exact, error);

    if (asked->pulse->is_stopped) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = add_surface(&task, model, error);
    return status == TAUT_OK ? taut_construct_set_details(model, details_of(&task), error) : status;
}

taut_status taut_harmonic_make(const taut_harmonic_problem *problem,
                               const taut_make_options *options, taut_model **model,
                               taut_error *error)
{
    taut_pulse pulse = {.monitor = options != NULL ? &options->monitor : NULL,
                        .what = "solving",
                        .done = taut_none};
    request asked = {problem, options != NULL && options->exact, &pulse};
    const taut_status status = check_problem(problem, error);

    return status == TAUT_OK ? taut_construct_build(fill_model, &asked, model, error) : status;
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_harmonic_make(data, options, model, error);
}

const taut_construct_ops taut_construct_harmonic = {.make = make, .exact = 1};
