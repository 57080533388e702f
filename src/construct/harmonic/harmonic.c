/* harmonic.c -- construct `harmonic`: collect the data, make it agree, sum the series, put it back.
 */
#include "taut/harmonic.h"

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
    taut_wide *scratch = NULL;

    if (!task->problem->from_derivative) {
        task->amplification = taut_harmonic_rows_amplification(n, m, task->mu);
        return TAUT_OK;
    }
    scratch = taut_arena_take(task->arena, 4 * (size_t)(n + 1) * (size_t)(m + 1), sizeof *scratch);
    if (scratch == NULL) {
        return taut_fail_memory(error);
    }
    task->amplification = taut_harmonic_derivative_amplification(n, m, task->mu, scratch);
    return TAUT_OK;
}

static taut_status check_amplification(const taut_harmonic_task *task, taut_error *error)
{
    if (!(task->amplification <= amplification_limit) && !task->problem->insist) {
        return taut_fail(
            error, TAUT_NO_SOLUTION, "no-solution", "", task->amplification, amplification_limit,
            "rounding in the data would grow %.3g times, past %.0e: the result would mean "
            "nothing (\"insist\": true builds it all the same; a lower degree or data "
            "from one edge is better)",
            task->amplification, amplification_limit);
    }
    return TAUT_OK;
}

static taut_status check_degrees(const taut_harmonic_task *task, taut_error *error)
{
    if (task->n < task->m) {
        return taut_fail(
            error, TAUT_NO_SOLUTION, "no-solution", task->turned ? "/v/degree" : "/u/degree",
            task->n, task->m,
            "rows of degree %d need degree %d across them for a harmonic surface, found %d",
            task->m, task->m % 2 != 0 ? task->m : task->m + 1, task->n);
    }
    return TAUT_OK;
}

static taut_status complete(taut_harmonic_task *task, taut_error *error)
{
    const size_t points = (size_t)(task->n + 1) * (size_t)(task->m + 1);
    taut_wide *wide = taut_arena_take(task->arena, 3 * points, sizeof *wide);

    task->net = taut_arena_take(task->arena, 3 * points, sizeof(double));
    if (task->net == NULL || wide == NULL) {
        return taut_fail_memory(error);
    }
    if (task->problem->from_derivative) {
        taut_harmonic_from_derivative(task->n, task->m, task->mu, task->row[0], task->width,
                                      task->row[1], wide, task->net);
    } else {
        taut_harmonic_from_rows(task->n, task->m, task->mu, task->row[0], task->row[1], wide,
                                task->net);
    }
    taut_frame_leave(&task->frame, points, task->net);
    for (size_t i = 0; i < 3 * points; i++) {
        if (!isfinite(task->net[i])) {
            return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "", task->amplification,
                             amplification_limit,
                             "the control points overflow: degree %d amplifies the data %.3g times",
                             task->m, task->amplification);
        }
    }
    return TAUT_OK;
}

/* What was given comes back bit for bit, unless a repair moved it. */
static void restore_given(taut_harmonic_task *task, double *points)
{
    const taut_harmonic_problem *problem = task->problem;
    const int nu = taut_basis_count(problem->u), nv = taut_basis_count(problem->v);
    if (problem->fit) {
        return; /* nothing given is kept */
    }
    if (problem->from_derivative) {
        memcpy(points, problem->edge, (size_t)nv * 3 * sizeof(double));
        return;
    }
    if (task->repair != NULL && strcmp(task->repair, "project") == 0) {
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
            if (problem->known[i * nv + j] &&
                !(corner && task->repair != NULL && strcmp(task->repair, "corner") == 0)) {
                memcpy(points + 3 * (to_i * (columns + 1) + to_j),
                       problem->points + 3 * (i * nv + j), 3 * sizeof(double));
            }
        }
    }
}

/* A bezier basis of this degree over the range of another. */
static taut_status basis_like(const taut_basis *basis, int degree, taut_basis **like,
                              taut_error *error)
{
    taut_basis_spec spec;
    taut_basis_spec_of(basis, &spec);
    spec.degree = degree;
    return taut_basis_new(&spec, degree + 1, like, error);
}

/* The texts turned back as the points are. */
static void turn_texts(const taut_harmonic_task *task, int rows, int columns, const char **texts)
{
    for (int i = 0; i <= rows; i++) {
        for (int j = 0; j <= columns; j++) {
            const int from = task->turned ? j * (rows + 1) + i : i * (columns + 1) + j;
            memcpy(texts + 3 * (i * (columns + 1) + j), task->texts + 3 * from, 3 * sizeof *texts);
        }
    }
}

/* The net turned back, as a surface in a model. */
static taut_status to_model(taut_harmonic_task *task, taut_model **model, taut_error *error)
{
    const taut_harmonic_problem *problem = task->problem;
    const int rows = task->turned ? task->m : task->n, columns = task->turned ? task->n : task->m;
    double *points = taut_arena_take(task->arena, 3 * (size_t)(rows + 1) * (size_t)(columns + 1),
                                     sizeof(double));
    const char **texts =
        taut_arena_take(task->arena, 3 * (size_t)(rows + 1) * (size_t)(columns + 1), sizeof *texts);
    taut_basis *u = NULL, *v = NULL;
    taut_surface *surface = NULL;
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (points == NULL || texts == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i <= rows; i++) {
        for (int j = 0; j <= columns; j++) {
            const int from = task->turned ? j * (rows + 1) + i : i * (columns + 1) + j;
            memcpy(points + 3 * (i * (columns + 1) + j), task->net + 3 * from, 3 * sizeof(double));
        }
    }
    if (task->texts != NULL) {
        turn_texts(task, rows, columns, texts);
    } else {
        restore_given(task, points);
    }
    status = basis_like(problem->u, rows, &u, error);
    if (status == TAUT_OK) {
        status = basis_like(problem->v, columns, &v, error);
    }
    if (status == TAUT_OK) {
        status =
            taut_surface_new_exact(problem->name != NULL ? problem->name : "harmonic", u, v, points,
                                   NULL, task->texts != NULL ? texts : NULL, &surface, error);
    }
    if (status == TAUT_OK &&
        (taut_model_new(&made) != TAUT_OK || taut_model_add_surface(made, surface) != TAUT_OK)) {
        taut_surface_free(surface);
        taut_model_free(made);
        status = taut_fail_memory(error);
    }
    taut_basis_free(u);
    taut_basis_free(v);
    if (status == TAUT_OK) {
        *model = made;
    }
    return status;
}

static taut_record *details_of(const taut_harmonic_task *task)
{
    taut_record *details = taut_record_new();
    taut_record_add_number(details, "amplification", task->amplification);
    if (task->repair != NULL) {
        taut_record *repair = taut_record_add_object(details, "repair");
        taut_record_add_text(repair, "kind", task->repair);
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

static taut_status check_problem(const taut_harmonic_problem *problem, taut_error *error)
{
    if (problem == NULL || problem->u == NULL || problem->v == NULL ||
        (problem->from_derivative ? problem->edge == NULL || problem->cross_derivative == NULL
                                  : problem->points == NULL || problem->known == NULL)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a harmonic problem needs two bases and its data");
    }
    if (strcmp(taut_basis_type(problem->u), "bezier") != 0 ||
        strcmp(taut_basis_type(problem->v), "bezier") != 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "value",
                         strcmp(taut_basis_type(problem->u), "bezier") != 0 ? "/u" : "/v",
                         taut_none, taut_none, "expected a basis of type \"bezier\"");
    }
    return TAUT_OK;
}

/* Rational arithmetic amplifies nothing, so that any degree will do. */
static taut_status check_exact(taut_harmonic_task *task, taut_error *error)
{
    taut_status status = taut_harmonic_exact(task, error);
    if (status == TAUT_OK) {
        status = measure_amplification(task, error);
    }
    for (int i = 0; status == TAUT_OK && i < 3 * (task->n + 1) * (task->m + 1); i++) {
        if (!isfinite(task->net[i])) {
            return taut_fail(
                error, TAUT_NO_SOLUTION, "no-solution", "", task->amplification,
                amplification_limit,
                "the control points are too large for doubles: degree %d amplifies the "
                "data %.3g times",
                task->m, task->amplification);
        }
    }
    return status;
}

/* From the data to task->net. */
static taut_status solve(taut_harmonic_task *task, int exact, taut_error *error)
{
    taut_status status = TAUT_OK;
    if (exact && task->problem->fit) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", "/fit", taut_none, taut_none,
                         "\"fit\" is not done in rational arithmetic");
    }
    if (task->problem->fit) {
        return taut_harmonic_fit(task, error);
    }
    status = taut_harmonic_collect(task, error);
    if (status == TAUT_OK) {
        status = check_degrees(task, error);
    }
    if (status == TAUT_OK && exact) {
        return check_exact(task, error);
    }
    if (status == TAUT_OK) {
        status = taut_harmonic_agree(task, error);
    }
    if (status == TAUT_OK) {
        status = measure_amplification(task, error);
    }
    if (status == TAUT_OK) {
        status = check_amplification(task, error);
    }
    return status == TAUT_OK ? complete(task, error) : status;
}

taut_status taut_harmonic_make(const taut_harmonic_problem *problem,
                               const taut_make_options *options, taut_model **model,
                               taut_error *error)
{
    taut_harmonic_task task = {.problem = problem};
    taut_model *made = NULL;
    taut_record *details = NULL;
    taut_status status = check_problem(problem, error);

    if (status != TAUT_OK) {
        return status;
    }
    task.arena = taut_arena_new();
    status = task.arena != NULL ? solve(&task, options != NULL && options->exact, error)
                                : taut_fail_memory(error);
    if (status == TAUT_OK) {
        status = to_model(&task, &made, error);
    }
    if (status == TAUT_OK) {
        details = details_of(&task);
        taut_model_set_details(made, details);
        status = taut_record_status(details) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
    }
    taut_arena_free(task.arena);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *model = made;
    return TAUT_OK;
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_harmonic_make(data, options, model, error);
}

const taut_construct_ops taut_construct_harmonic = {.make = make, .exact = 1};
