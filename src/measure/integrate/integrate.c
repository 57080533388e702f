/* integrate.c -- an adaptive integral over a surface: a first pass over all cells, then rounds over
 * those that resist, which are cut in four.
 *
 * A round tries every active cell; those whose error is within an equal share of what the goal
 * leaves are taken, the others quartered. At a corner where the normal vanishes one cell a round is
 * left; along a kink their number doubles while the error of each falls eightfold.
 */
#include "measure/integrate/eight.h"
#include "measure/integrate/job.h"

#include "core/memory.h"
#include "geometry/nurbs/spread.h"
#include "measure/integrate/near_zero.h"
#include "platform/parallel.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum {
    SHARE = 8,       /* cells per task */
    NODE_WORK = 200, /* operations at a node, as pulses count them; and so many times as
                            many for second derivatives: */
    SECOND_WORK = 5,
    LONG_CELL = 256,     /* points of a cell that is long work by itself: one of degree 16 */
    ROUNDS_MAX = 40,     /* a corner's share is then below 2^-80 of its cell */
    ACTIVE_MAX = 1 << 18 /* cells in one round, over four times those of the first: then errors are
                            taken as they are */
};

/* Adds up the shares in their order; *pending is replaced. */
static void gather_shares(const taut_job *job, taut_sum *value, taut_sum *error, double *pending)
{
    for (int f = 0; f < 2 * job->integrand->count; f++) {
        pending[f] = 0;
        for (int64_t i = 0; i < job->share_count; i++) {
            taut_sum_add(&value[f], job->shares[i].value[f].high);
            taut_sum_add(&value[f], job->shares[i].value[f].low);
            taut_sum_add(&error[f], job->shares[i].error[f]);
            pending[f] += job->shares[i].pending[f];
        }
    }
}

static void fill_block(taut_job *job, taut_worker *worker, int direction, int from, int to)
{
    const taut_cells *p = job->cells[direction];
    const int levels = job->integrand->exact ? 1 : 2;
    for (int level = 0; level < levels; level++) {
        for (int s = from; s < to; s++) {
            taut_rule_fill(&job->rules.at[TAUT_WHOLE][direction][level], &job->scaled, direction,
                           p->span[s], p->lo[s], p->hi[s], job->integrand->order,
                           &worker->block[direction][level][s - from]);
        }
    }
}

/* The cell of interval i of u and j of v. */
static taut_rectangle cell_at(const taut_job *job, int i, int j)
{
    const taut_cells *u = job->cells[0], *v = job->cells[1];
    return (taut_rectangle){{u->span[i], v->span[j]}, {u->lo[i], v->lo[j]}, {u->hi[i], v->hi[j]}};
}

/* The cell of intervals i, j, the a-th and b-th of the block. */
static void first_cell(taut_job *job, taut_worker *worker, int i, int j, int a, int b,
                       taut_task_result *share)
{
    const taut_rectangle r = cell_at(job, i, j);
    const int exact = job->integrand->exact;
    const taut_nodes *first[2] = {&worker->block[0][0][a], &worker->block[1][0][b]};
    const taut_nodes *second[2] = {exact ? NULL : &worker->block[0][1][a],
                                   exact ? NULL : &worker->block[1][1][b]};
    double value[TAUT_FIELDS_MAX], error[TAUT_FIELDS_MAX];

    taut_cell_load(&job->scaled, r.span[0], r.span[1], &worker->cell);
    const int good = taut_cell_try(job, worker, TAUT_WHOLE, &r, first, second, NULL, value, error);
    taut_task_result_add(share, good, 2 * job->integrand->count, value, error);
    job->hard[(size_t)i * (size_t)job->cells[1]->count + (size_t)j] = !good;
}

/* The cells from j on of row i, up to eight, that are at hand in worker->eight. */
static void first_eight(taut_job *job, taut_worker *worker, int i, int j, int a, int b,
                        taut_task_result *share)
{
    const taut_nodes *u[2] = {&worker->block[0][0][a], &worker->block[0][1][a]};
    double value[TAUT_EIGHT][TAUT_FIELDS_MAX], error[TAUT_EIGHT][TAUT_FIELDS_MAX];
    int is_good[TAUT_EIGHT];

    taut_eight_try(job, i, u, worker->eight, value, error, is_good);
    for (int k = 0; k < worker->eight->count; k++) {
        if (is_good[k]) {
            taut_task_result_add(share, 1, 2 * job->integrand->count, value[k], error[k]);
            job->hard[(size_t)i * (size_t)job->cells[1]->count + (size_t)(j + k)] = 0;
        } else {
            first_cell(job, worker, i, j + k, a, b + k, share);
        }
    }
}

/* All cells of the block by eights, column by column of eights. */
static void first_eights(taut_job *job, taut_worker *worker, const int from[2], const int to[2],
                         taut_task_result *share)
{
    for (int j = from[1]; j < to[1]; j += TAUT_EIGHT) {
        const int b = j - from[1], count = to[1] - j < TAUT_EIGHT ? to[1] - j : TAUT_EIGHT;
        const taut_nodes *v[2] = {&worker->block[1][0][b], &worker->block[1][1][b]};
        taut_eight_take(job, v, j, count, worker->eight);
        for (int i = from[0]; i < to[0]; i++) {
            first_eight(job, worker, i, j, i - from[0], b, share);
        }
    }
}

static void first_task(void *context, int index, int64_t task)
{
    taut_job *job = context;
    taut_worker *worker = &job->workers[index];
    taut_task_result *share = &job->shares[task];
    int from[2], to[2];

    memset(share, 0, sizeof *share);
    from[0] = (int)(task / job->blocks[1]) * job->side;
    from[1] = (int)(task % job->blocks[1]) * job->side;
    for (int d = 0; d < 2; d++) {
        const int count = job->cells[d]->count;
        to[d] = count - from[d] < job->side ? count : from[d] + job->side;
        fill_block(job, worker, d, from[d], to[d]);
    }
    if (worker->eight != NULL) {
        first_eights(job, worker, from, to, share);
        return;
    }
    for (int i = from[0]; i < to[0]; i++) {
        for (int j = from[1]; j < to[1]; j++) {
            first_cell(job, worker, i, j, i - from[0], j - from[1], share);
        }
    }
}

/* Nodes for `count` points take their memory from *at, or only say how much (at NULL). */
static size_t place_nodes(const taut_job *job, int direction, int count, taut_nodes *nodes,
                          double **at)
{
    const size_t one = ((size_t)job->integrand->order + 1) * (size_t)job->scaled.local[direction];
    const size_t values = (size_t)count * one, total = values + one + (size_t)count;
    if (*at != NULL) {
        nodes->values = *at;
        nodes->most = *at + values;
        nodes->weights = *at + values + one;
        *at += total;
    }
    return total;
}

/* The lists of a worker's nodes, and what it needs for eight cells at a time. */
static int take_blocks(const taut_job *job, taut_worker *worker)
{
    taut_nodes *nodes = taut_arena_take(job->arena, 4 * (size_t)job->side, sizeof *nodes);
    for (int k = 0; k < 4 && nodes != NULL; k++) {
        worker->block[k / 2][k % 2] = nodes + (size_t)k * (size_t)job->side;
    }
    worker->eight = job->by_eights ? taut_arena_take(job->arena, 1, sizeof *worker->eight) : NULL;
    if (worker->eight != NULL) {
        taut_eight_init(job, worker->eight);
    }
    return taut_arena_status(job->arena) == TAUT_OK;
}

/* All memory of one worker in one piece: counted first, then dealt out. */
static size_t place_worker(const taut_job *job, taut_worker *worker, double *at)
{
    const taut_rule *samples = job->rules.samples[TAUT_WHOLE];
    const size_t sample_count = (size_t)samples[0].count * (size_t)samples[1].count;
    size_t total = 3 * sample_count;

    for (int k = 0; k < 3 && at != NULL; k++, at += sample_count) {
        worker->samples[k] = at;
    }
    for (int d = 0; d < 2; d++) {
        total += place_nodes(job, d, job->rules.most[d], &worker->nodes[d], &at);
        for (int level = 0; level < 2; level++) {
            for (int s = 0; s < job->side; s++) {
                total += place_nodes(job, d, job->rules.at[TAUT_WHOLE][d][level].count,
                                     &worker->block[d][level][s], &at);
            }
        }
    }
    return total;
}

/* The cells of one direction, graded by the weights of all lines along it: rules that see nothing
 * of a layer agree about it. */
static taut_status cut_direction(const taut_scaled_surface *scaled, int direction,
                                 taut_cells **cells)
{
    const int lines = taut_basis_count(scaled->basis[1 - direction]);
    const size_t columns = (size_t)taut_basis_count(scaled->basis[1]);
    const size_t step = direction == 0 ? columns : 1, next = direction == 0 ? 1 : columns;
    return taut_cells_new(scaled->basis[direction], lines, scaled->weights, step, next, cells);
}

/* What the first pass needs; the scratch of all workers lies in the arena. */
static taut_status begin_job(const taut_surface *surface, const taut_crew *crew, taut_job *job)
{
    taut_scaled_surface_init(surface, &job->scaled);
    for (int d = 0; d < 2; d++) {
        if (!taut_near_zero(job->scaled.basis[d], &job->moved[d])) {
            return TAUT_NO_MEMORY;
        }
        job->scaled.basis[d] = job->moved[d] != NULL ? job->moved[d] : job->scaled.basis[d];
    }
    job->arena = taut_arena_new();
    if (!taut_rules_init(&job->rules, &job->scaled, job->arena)) {
        return TAUT_NO_MEMORY;
    }
    /* a block's tables fit the second cache */
    job->side = 256 / (job->scaled.local[0] * job->scaled.local[1]);
    job->side = job->side > TAUT_BLOCK ? TAUT_BLOCK : job->side < 1 ? 1 : job->side;
    job->by_eights = job->integrand->is_first && job->scaled.weights == NULL;
    job->side = job->by_eights ? TAUT_WIDE_BLOCK : job->side;
    for (int d = 0; d < 2; d++) {
        if (cut_direction(&job->scaled, d, &job->cells[d]) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        job->blocks[d] = (job->cells[d]->count + job->side - 1) / job->side;
    }
    const int is_long = job->scaled.local[0] * job->scaled.local[1] > LONG_CELL;
    job->share_count = (int64_t)job->blocks[0] * job->blocks[1];
    job->worker_count = taut_crew_workers(crew, INT64_C(1) << 30);
    job->workers = taut_arena_take(job->arena, (size_t)job->worker_count, sizeof *job->workers);
    job->hard =
        taut_arena_take(job->arena, (size_t)job->cells[0]->count * (size_t)job->cells[1]->count, 1);
    job->shares = taut_alloc((size_t)job->share_count, sizeof *job->shares);
    for (int w = 0; job->workers != NULL && w < job->worker_count; w++) {
        taut_worker *worker = &job->workers[w];
        if (!take_blocks(job, worker)) {
            return TAUT_NO_MEMORY;
        }
        double *numbers =
            taut_arena_take(job->arena, place_worker(job, worker, NULL), sizeof(double));
        place_worker(job, worker, numbers);
        taut_cell_work_init(&job->scaled, job->rules.most[1], job->arena, &worker->cell);
        worker->cell.pulse = w == 0 && is_long && crew != NULL ? crew->pulse : NULL;
    }
    return job->shares != NULL ? taut_arena_status(job->arena) : TAUT_NO_MEMORY;
}

static void clear_job(taut_job *job)
{
    for (int d = 0; d < 2; d++) {
        taut_cells_free(job->cells[d]);
        taut_basis_free(job->moved[d]);
    }
    taut_free(job->shares);
    taut_free(job->active);
    taut_free(job->split);
    taut_arena_free(job->arena);
}

static void round_task(void *context, int index, int64_t task)
{
    taut_job *job = context;
    taut_worker *worker = &job->workers[index];
    taut_task_result *share = &job->shares[task];
    const int64_t from = task * SHARE;
    const int64_t to = job->active_count - from < SHARE ? job->active_count : from + SHARE;
    double value[TAUT_FIELDS_MAX], error[TAUT_FIELDS_MAX];

    memset(share, 0, sizeof *share);
    for (int64_t i = from; i < to; i++) {
        const taut_rectangle *r = &job->active[i];
        const taut_nodes *first[2], *second[2];
        for (int d = 0; d < 2; d++) {
            for (int level = 0; level < 2; level++) {
                taut_rule_fill(&job->rules.at[TAUT_PART][d][level], &job->scaled, d, r->span[d],
                               r->lo[d], r->hi[d], job->integrand->order,
                               &worker->block[d][level][0]);
            }
            first[d] = &worker->block[d][0][0];
            second[d] = &worker->block[d][1][0];
        }
        taut_cell_load(&job->scaled, r->span[0], r->span[1], &worker->cell);
        job->split[i] =
            !taut_cell_try(job, worker, TAUT_PART, r, first, second, job->allowed, value, error) &&
            !job->last;
        taut_task_result_add(share, !job->split[i], 2 * job->integrand->count, value, error);
    }
}

/* The cells that the first pass left, in order. */
static taut_status collect_hard(taut_job *job)
{
    const size_t columns = (size_t)job->cells[1]->count;
    const size_t cells = (size_t)job->cells[0]->count * columns;
    int64_t count = 0;

    for (size_t i = 0; i < cells; i++) {
        count += job->hard[i];
    }
    job->active = taut_alloc((size_t)count, sizeof *job->active);
    if (job->active == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < cells; i++) {
        if (job->hard[i]) {
            job->active[job->active_count++] = cell_at(job, (int)(i / columns), (int)(i % columns));
        }
    }
    return TAUT_OK;
}

/* Each rectangle marked becomes its four quarters. */
static taut_status quarter_cells(taut_job *job)
{
    int64_t count = 0, made = 0;
    taut_rectangle *next = NULL;
    for (int64_t i = 0; i < job->active_count; i++) {
        count += 4 * job->split[i];
    }
    next = taut_alloc((size_t)count, sizeof *next);
    if (next == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int64_t i = 0; i < job->active_count; i++) {
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

/* Operations, as pulses count them, of the first two rules in one cell. */
static double work_of_cell(const taut_job *job)
{
    const taut_rule(*rule)[TAUT_LEVELS_MAX] = job->rules.at[TAUT_WHOLE];
    return NODE_WORK * (job->integrand->order > 1 ? SECOND_WORK : 1.0) *
           (rule[0][0].count * rule[1][0].count + rule[0][1].count * rule[1][1].count);
}

static double work_of_block(const taut_job *job)
{
    return work_of_cell(job) * job->side * job->side;
}

/* What a cell of this round may keep: an equal part of a sixteenth of the goal, as other rounds
 * take theirs too. */
static void allow_errors(taut_job *job, const taut_sum *value, const double *pending)
{
    for (int f = 0; f < 2 * job->integrand->count; f += 2) {
        const taut_goal *goal = &job->integrand->goals[f / 2];
        const double size = fabs(taut_sum_total(&value[f]) + pending[f]);
        const double noise = fabs(taut_sum_total(&value[f + 1]) + pending[f + 1]);
        job->allowed[f] =
            (goal->relative * size + goal->floor * noise) / (16 * (double)job->active_count);
    }
}

/* The rounds over the cells marked hard. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
static taut_status run_rounds(taut_job *job, const taut_crew *crew, taut_sum *value,
                              taut_sum *error, double *pending)
{
    taut_status status = collect_hard(job);
    const int64_t most = ACTIVE_MAX + 4 * job->active_count;

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
        allow_errors(job, value, pending);
        if (taut_crew_run(crew, job->worker_count, job->share_count, SHARE * work_of_cell(job),
                          round_task, job)) {
            return TAUT_INTERRUPTED;
        }
        gather_shares(job, value, error, pending);
        status = quarter_cells(job);
    }
    return status;
}

static taut_status run_job(const taut_surface *surface, const taut_crew *crew, taut_job *job,
                           taut_integrals *integrals)
{
    taut_sum value[TAUT_FIELDS_MAX] = {{0, 0}}, error[TAUT_FIELDS_MAX] = {{0, 0}};
    double pending[TAUT_FIELDS_MAX];

    if (begin_job(surface, crew, job) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    if (taut_crew_run(crew, job->worker_count, job->share_count, work_of_block(job), first_task,
                      job)) {
        return TAUT_INTERRUPTED;
    }
    gather_shares(job, value, error, pending);
    const taut_status status = run_rounds(job, crew, value, error, pending);
    if (status != TAUT_OK) {
        return status;
    }
    for (int f = 0; f < 2 * job->integrand->count; f++) {
        integrals->value[f] = taut_sum_total(&value[f]);
        integrals->error[f] = taut_sum_total(&error[f]);
    }
    integrals->scale = job->scaled.scale;
    integrals->shift[0] = job->scaled.shift[0];
    integrals->shift[1] = job->scaled.shift[1];
    return TAUT_OK;
}

/* No number at all, where a number would be that of a surface without its layers. */
static taut_status find_nothing(const taut_integrand *integrand, taut_integrals *integrals)
{
    for (int f = 0; f < 2 * integrand->count; f++) {
        integrals->value[f] = integrals->error[f] = nan("");
    }
    integrals->scale = integrals->shift[0] = integrals->shift[1] = 0;
    return TAUT_OK;
}

taut_status taut_integrate(const taut_surface *surface, const taut_integrand *integrand,
                           const taut_crew *crew, taut_integrals *integrals)
{
    taut_job job = {.integrand = integrand};
    if (taut_weight_spread(surface) > TAUT_SPREAD_MAX) {
        return find_nothing(integrand, integrals);
    }
    const taut_status status = run_job(surface, crew, &job, integrals);
    clear_job(&job);
    return status;
}
