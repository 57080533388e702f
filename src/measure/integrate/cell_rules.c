/* cell_rules.c -- one cell: more nodes until two rules agree. */
#include "measure/integrate/job.h"

#include <math.h>
#include <string.h>

void taut_task_result_add(taut_task_result *share, int is_good, int count, const double *value,
                          const double *error)
{
    for (int f = 0; f < count; f++) {
        if (is_good) {
            taut_sum_add(&share->value[f], value[f]);
            share->error[f] += error[f];
        } else {
            share->pending[f] += value[f];
        }
    }
}

/* Is field f good by its own goal, a tenth of its relative tolerance, or within `allowed`? */
static int is_good(const taut_integrand *integrand, int f, const double *value, const double *error,
                   const double *allowed)
{
    const taut_goal *goal = &integrand->goals[f / 2];
    const double limit = 0.1 * goal->relative * fabs(value[f]) + goal->floor * fabs(value[f + 1]);
    return isinf(goal->relative) || error[f] <= limit ||
           (allowed != NULL && error[f] <= allowed[f]);
}

int taut_cell_is_good(const taut_integrand *integrand, const double *value, const double *error)
{
    int all = 1;
    for (int f = 0; f < 2 * integrand->count; f += 2) {
        all = all && is_good(integrand, f, value, error, NULL);
    }
    return all;
}

/* What to do after a rule: take the cell, try more nodes, or give up since the error of some field
 * falls too slowly. Three rules, each half again as large, cost as much as four quarters; on smooth
 * integrands each gains a factor of ten and more. What has overflowed does not get better: taken.
 * `before` is the error one level down, 0 if none. */
enum { TAKE, MORE, GIVE_UP };
static int judge_rule(const taut_integrand *integrand, const double *value, const double *error,
                      const double *before, const double *allowed)
{
    int verdict = TAKE;
    for (int f = 0; f < 2 * integrand->count; f += 2) {
        if (!is_good(integrand, f, value, error, allowed) && isfinite(value[f])) {
            if (before[f] > 0 && !(error[f] <= 0.1 * before[f])) {
                return GIVE_UP;
            }
            verdict = MORE;
        }
    }
    return verdict;
}

int taut_cell_try(const taut_job *job, taut_worker *worker, int ladder, const taut_rectangle *r,
                  const taut_nodes *const first[2], const taut_nodes *const second[2],
                  const double *allowed, double *value, double *error)
{
    static const double nothing[TAUT_FIELDS_MAX];
    const taut_integrand *in = job->integrand;
    const int kept = in->kinks == 0 ? 0 : 2 + in->kinks;
    double before[TAUT_FIELDS_MAX], low[TAUT_FIELDS_MAX] = {0};
    taut_arguments arguments;

    arguments.near[0] = arguments.near[1] = arguments.doubt = 0;
    taut_cell_sum(&job->scaled, first[0], first[1], in->order, in->fields, 2 * in->count, kept,
                  &worker->cell, low);
    memset(error, 0, sizeof low);
    if (second[0] == NULL || taut_pulse_is_stopped(worker->cell.pulse)) {
        memcpy(value, low, sizeof low);
        return 1;
    }
    if (kept > 0) {
        taut_arguments_take(job, worker, ladder, 0, r, &arguments, low, error);
        memset(error, 0, sizeof low);
    }
    for (int level = 1;; level++) {
        const taut_nodes *nodes[2] = {second[0], second[1]};
        int verdict = MORE;
        for (int d = 0; d < 2 && level > 1; d++) {
            taut_rule_fill(&job->rules.at[ladder][d][level], &job->scaled, d, r->span[d], r->lo[d],
                           r->hi[d], in->order, &worker->nodes[d]);
            nodes[d] = &worker->nodes[d];
        }
        taut_cell_sum(&job->scaled, nodes[0], nodes[1], in->order, in->fields, 2 * in->count, kept,
                      &worker->cell, value);
        if (taut_pulse_is_stopped(worker->cell.pulse)) {
            return 1;
        }
        for (int f = 0; f < 2 * in->count; f++) {
            before[f] = error[f];
            error[f] = fabs(value[f] - low[f]);
            low[f] = value[f];
        }
        if (kept > 0) {
            taut_arguments_take(job, worker, ladder, level, r, &arguments, value, error);
        }
        verdict = judge_rule(in, value, error, before, allowed);
        if (verdict == TAKE && arguments.doubt) {
            taut_cell_turns(job, worker, ladder, r, error);
            verdict = judge_rule(in, value, error, nothing, allowed) == TAKE ? TAKE : GIVE_UP;
        }
        if (verdict != MORE || level + 1 >= job->rules.levels[ladder]) {
            if (verdict == TAKE || job->last) {
                taut_arguments_settle(job, r, &arguments, value);
            }
            return verdict == TAKE;
        }
    }
}
