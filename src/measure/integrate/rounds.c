/* rounds.c -- the cells that resist are cut in four, round by round.
 *
 * A round tries every active cell; those whose error is within an equal share of what the goal
 * leaves are taken, the others quartered. At a corner where the normal vanishes one cell a round is
 * left; along a kink their number doubles while the error of each falls eightfold.
 */
#include "measure/integrate/job.h"

#include "core/memory.h"
#include "measure/integrate/parallel.h"

#include <math.h>
#include <string.h>

enum {
    SHARE = 8,           /* cells per task */
    ROUNDS_MAX = 40,     /* a corner's share is then below 2^-80 of its cell */
    ACTIVE_MAX = 1 << 18 /* cells in one round, over four times those of the first: then errors are
                            taken as they are */
};

static void round_task(void *context, int worker, long task)
{
    taut_job *job = context;
    taut_bench *bench = &job->benches[worker];
    taut_share *share = &job->shares[task];
    const long from = task * SHARE;
    const long to = job->active_count - from < SHARE ? job->active_count : from + SHARE;
    double value[TAUT_FIELDS_MAX], error[TAUT_FIELDS_MAX];

    memset(share, 0, sizeof *share);
    for (long i = from; i < to; i++) {
        const taut_rectangle *r = &job->active[i];
        const taut_nodes *first[2], *second[2];
        for (int d = 0; d < 2; d++) {
            for (int level = 0; level < 2; level++) {
                taut_rule_fill(&job->rules.at[TAUT_PART][d][level], &job->cells, d, r->span[d],
                               r->lo[d], r->hi[d], job->integrand->order,
                               &bench->block[d][level][0]);
            }
            first[d] = &bench->block[d][0][0];
            second[d] = &bench->block[d][1][0];
        }
        taut_cell_load(&job->cells, r->span[0], r->span[1], &bench->cell);
        job->split[i] =
            !taut_cell_try(job, bench, TAUT_PART, r, first, second, job->allowed, value, error) &&
            !job->last;
        taut_share_take(share, !job->split[i], 2 * job->integrand->count, value, error);
    }
}

/* The cells that the first pass left, in order. */
static taut_status collect(taut_job *job)
{
    const size_t columns = (size_t)job->panels[1]->count;
    const size_t cells = (size_t)job->panels[0]->count * columns;
    long count = 0;

    for (size_t i = 0; i < cells; i++) {
        count += job->hard[i];
    }
    job->active = taut_alloc((size_t)count, sizeof *job->active);
    if (job->active == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < cells; i++) {
        if (job->hard[i]) {
            job->active[job->active_count++] =
                taut_job_cell(job, (int)(i / columns), (int)(i % columns));
        }
    }
    return TAUT_OK;
}

/* Each rectangle marked becomes its four quarters. */
static taut_status cut(taut_job *job)
{
    long count = 0, made = 0;
    taut_rectangle *next = NULL;
    for (long i = 0; i < job->active_count; i++) {
        count += 4 * job->split[i];
    }
    next = taut_alloc((size_t)count, sizeof *next);
    if (next == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (long i = 0; i < job->active_count; i++) {
        for (int q = 0; q < 4 && job->split[i]; q++) {
            taut_rectangle quarter = job->active[i];
            for (int d = 0; d < 2; d++) {
                const double middle = quarter.lo[d] + (quarter.hi[d] - quarter.lo[d]) / 2;
                double *end = (q >> d & 1) != 0 ? &quarter.lo[d] : &quarter.hi[d];
                *end = middle;
            }
            next[made++] = quarter;
        }
    }
    taut_free(job->active);
    job->active = next;
    job->active_count = made;
    return TAUT_OK;
}

/* What a cell of this round may keep: an equal part of a sixteenth of the goal, as other rounds
 * take theirs too. */
static void allow(taut_job *job, const taut_sum *value, const double *pending)
{
    for (int f = 0; f < 2 * job->integrand->count; f += 2) {
        const taut_target *target = &job->integrand->targets[f / 2];
        const double size = fabs(taut_sum_total(&value[f]) + pending[f]);
        const double noise = fabs(taut_sum_total(&value[f + 1]) + pending[f + 1]);
        job->allowed[f] =
            (target->relative * size + target->floor * noise) / (16 * (double)job->active_count);
    }
}

taut_status taut_job_rounds(taut_job *job, taut_sum *value, taut_sum *error, double *pending)
{
    taut_status status = collect(job);
    const long most = ACTIVE_MAX + 4 * job->active_count;

    for (int round = 0; status == TAUT_OK && job->active_count > 0; round++) {
        job->last = round + 1 >= ROUNDS_MAX || job->active_count > most;
        job->share_count = (job->active_count + SHARE - 1) / SHARE;
        taut_free(job->shares);
        taut_free(job->split);
        job->shares = taut_alloc((size_t)job->share_count, sizeof *job->shares);
        job->split = taut_alloc((size_t)job->active_count, 1);
        if (job->shares == NULL || job->split == NULL) {
            return TAUT_NO_MEMORY;
        }
        allow(job, value, pending);
        taut_parallel_run(job->worker_count, job->share_count, round_task, job);
        taut_job_gather(job, value, error, pending);
        status = cut(job);
    }
    return status;
}
