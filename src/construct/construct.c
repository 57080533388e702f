/* construct.c -- from a problem to its construction. */
#include "construct/construct_ops.h"
#include "core/fail.h"
#include "core/pace.h"
#include "problem/problem.h"

#include <math.h>

static const taut_construct_ops *const ops_table[] = {
#define TAUT_CONSTRUCT_ROW(identifier, name) &taut_construct_##identifier,
    TAUT_CONSTRUCT_LIST(TAUT_CONSTRUCT_ROW)
#undef TAUT_CONSTRUCT_ROW
};

/* Of a construction that has nothing to show before it is done, an end is no result. */
static taut_status make(const taut_construct_ops *ops, const void *data,
                        const taut_make_options *options, taut_model **model, taut_error *error)
{
    taut_pace pace;
    if (ops->ends_early) {
        return ops->make(data, options, model, error);
    }
    const taut_make_options own = taut_pace_options(&pace, options);
    return taut_pace_end(&pace, ops->make(data, &own, model, error), error);
}

/* What the problem's reader converted and chose stands among what the construction decided. */
static taut_status add_notes(const taut_problem *problem, taut_model *model, taut_error *error)
{
    taut_record *details = NULL;

    if (problem->notes == NULL) {
        return TAUT_OK;
    }
    details = taut_model_details(model) != NULL ? taut_record_copy(taut_model_details(model))
                                                : taut_record_new();
    taut_record_add_record(details, "notes", problem->notes);
    if (taut_record_status(details) != TAUT_OK) {
        taut_record_free(details);
        return taut_fail_memory(error);
    }
    taut_model_set_details(model, details);
    return TAUT_OK;
}

taut_status taut_make(const taut_problem *problem, const taut_make_options *options,
                      taut_model **model, taut_error *error)
{
    static const taut_make_options none;
    const taut_make_options *chosen = options != NULL ? options : &none;
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (problem == NULL || model == NULL || !(chosen->tolerance >= 0) || isinf(chosen->tolerance) ||
        chosen->threads < 0 || chosen->threads > TAUT_THREADS_MAX || !(chosen->time_limit >= 0)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "an argument of taut_make is out of its range");
    }
    if (chosen->exact && !ops_table[problem->construct]->exact) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "no-rationals", NULL, taut_none, taut_none,
                         "rational arithmetic is for harmonic and harmonic-extension, not for %s",
                         taut_construct_name(problem->construct));
    }
    status = make(ops_table[problem->construct], problem->data, chosen, &made, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_model_set_unit(made, problem->unit);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return taut_fail(error, TAUT_INTERNAL, "fault", NULL, taut_none, taut_none,
                         "an unknown unit");
    }
    status = add_notes(problem, made, error);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *model = made;
    return TAUT_OK;
}

taut_status taut_draft(const taut_problem *problem, const taut_model *before, int steps,
                       taut_model **model, taut_error *error)
{
    taut_model *made = NULL;

    if (problem == NULL || before == NULL || model == NULL || steps < 1) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "an argument of taut_draft is out of its range");
    }
    const taut_construct_ops *ops = ops_table[problem->construct];
    taut_status status =
        ops->draft != NULL ? ops->draft(problem->data, before, steps, &made, error) : TAUT_OK;
    if (status == TAUT_NO_SOLUTION || status == TAUT_NOT_CONVERGED) {
        status = TAUT_OK; /* whether there is none taut_make says */
    }
    if (status == TAUT_OK && made != NULL) {
        status = taut_model_set_unit(made, problem->unit);
        if (status != TAUT_OK) {
            taut_model_free(made);
            return taut_fail(error, TAUT_INTERNAL, "fault", NULL, taut_none, taut_none,
                             "an unknown unit");
        }
    }
    if (status == TAUT_OK) {
        *model = made;
    }
    return status;
}
