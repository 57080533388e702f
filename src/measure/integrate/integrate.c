/* integrate.c -- setting up, and the first pass over all cells. */
#include "measure/integrate/job.h"

#include "core/memory.h"
#include "measure/integrate/near_zero.h"
#include "measure/integrate/parallel.h"

#include <string.h>

void taut_job_gather(const taut_job *job, taut_sum *value, taut_sum *error, double *pending)
{
    for (int f = 0; f < 2 * job->integrand->count; f++) {
        pending[f] = 0;
        for (long i = 0; i < job->share_count; i++) {
            taut_sum_add(&value[f], job->shares[i].value[f].high);
            taut_sum_add(&value[f], job->shares[i].value[f].low);
            taut_sum_add(&error[f], job->shares[i].error[f]);
            pending[f] += job->shares[i].pending[f];
        }
    }
}

static void fill_block(taut_job *job, taut_bench *bench, int direction, int from, int to)
{
    const taut_panels *p = job->panels[direction];
    const int levels = job->integrand->exact ? 1 : 2;
    for (int level = 0; level < levels; level++) {
        for (int s = from; s < to; s++) {
            taut_rule_fill(&job->rules.at[TAUT_WHOLE][direction][level], &job->cells, direction,
                           p->span[s], p->lo[s], p->hi[s], job->integrand->order,
                           &bench->block[direction][level][s - from]);
        }
    }
}

taut_rectangle taut_job_cell(const taut_job *job, int i, int j)
{
    const taut_panels *u = job->panels[0], *v = job->panels[1];
    return (taut_rectangle){{u->span[i], v->span[j]}, {u->lo[i], v->lo[j]}, {u->hi[i], v->hi[j]}};
}

/* The cell of panels i, j, the a-th and b-th of the block. */
static void first_cell(taut_job *job, taut_bench *bench, int i, int j, int a, int b,
                       taut_share *share)
{
    const taut_rectangle r = taut_job_cell(job, i, j);
    const int exact = job->integrand->exact;
    const taut_nodes *first[2] = {&bench->block[0][0][a], &bench->block[1][0][b]};
    const taut_nodes *second[2] = {exact ? NULL : &bench->block[0][1][a],
                                   exact ? NULL : &bench->block[1][1][b]};
    double value[TAUT_FIELDS_MAX], error[TAUT_FIELDS_MAX];

    taut_cell_load(&job->cells, r.span[0], r.span[1], &bench->cell);
    const int good = taut_cell_try(job, bench, TAUT_WHOLE, &r, first, second, NULL, value, error);
    taut_share_take(share, good, 2 * job->integrand->count, value, error);
    job->hard[(size_t)i * (size_t)job->panels[1]->count + (size_t)j] = !good;
}

static void first_task(void *context, int worker, long task)
{
    taut_job *job = context;
    taut_bench *bench = &job->benches[worker];
    taut_share *share = &job->shares[task];
    int from[2], to[2];

    memset(share, 0, sizeof *share);
    from[0] = (int)(task / job->blocks[1]) * job->side;
    from[1] = (int)(task % job->blocks[1]) * job->side;
    for (int d = 0; d < 2; d++) {
        const int count = job->panels[d]->count;
        to[d] = count - from[d] < job->side ? count : from[d] + job->side;
        fill_block(job, bench, d, from[d], to[d]);
    }
    for (int i = from[0]; i < to[0]; i++) {
        for (int j = from[1]; j < to[1]; j++) {
            first_cell(job, bench, i, j, i - from[0], j - from[1], share);
        }
    }
}

/* Nodes for `count` points take their memory from *at, or only say how much (at NULL). */
static size_t nodes_place(const taut_job *job, int direction, int count, taut_nodes *nodes,
                          double **at)
{
    const size_t values =
        (size_t)count * ((size_t)job->integrand->order + 1) * (size_t)job->cells.local[direction];
    if (*at != NULL) {
        nodes->values = *at;
        nodes->weights = *at + values;
        *at += values + (size_t)count;
    }
    return values + (size_t)count;
}

/* All memory of one worker in one piece: counted first, then dealt out. */
static size_t bench_place(const taut_job *job, taut_bench *bench, double *at)
{
    const taut_rule *samples = job->rules.samples[TAUT_WHOLE];
    const size_t sample_count = (size_t)samples[0].count * (size_t)samples[1].count;
    size_t total = 3 * sample_count;

    for (int k = 0; k < 3 && at != NULL; k++, at += sample_count) {
        bench->samples[k] = at;
    }
    for (int d = 0; d < 2; d++) {
        total += nodes_place(job, d, job->rules.most[d], &bench->nodes[d], &at);
        for (int level = 0; level < 2; level++) {
            for (int s = 0; s < job->side; s++) {
                total += nodes_place(job, d, job->rules.at[TAUT_WHOLE][d][level].count,
                                     &bench->block[d][level][s], &at);
            }
        }
    }
    return total;
}

static int bench_init(const taut_job *job, taut_bench *bench)
{
    bench->numbers = taut_alloc_aligned(bench_place(job, bench, NULL), sizeof(double));
    if (bench->numbers == NULL) {
        return 0;
    }
    bench_place(job, bench, bench->numbers);
    return taut_cell_work_init(&job->cells, job->rules.most[1], &bench->cell);
}

static taut_status job_init(const taut_surface *surface, int threads, taut_job *job)
{
    taut_cells_init(surface, &job->cells);
    for (int d = 0; d < 2; d++) {
        if (!taut_near_zero(job->cells.basis[d], &job->moved[d])) {
            return TAUT_NO_MEMORY;
        }
        job->cells.basis[d] = job->moved[d] != NULL ? job->moved[d] : job->cells.basis[d];
    }
    if (!taut_rules_init(&job->rules, &job->cells)) {
        return TAUT_NO_MEMORY;
    }
    /* a block's tables fit the second cache */
    job->side = 256 / (job->cells.local[0] * job->cells.local[1]);
    job->side = job->side > TAUT_BLOCK ? TAUT_BLOCK : job->side < 1 ? 1 : job->side;
    for (int d = 0; d < 2; d++) {
        if (taut_panels_new(job->cells.basis[d], 1, NULL, 1, 0, &job->panels[d]) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        job->blocks[d] = (job->panels[d]->count + job->side - 1) / job->side;
    }
    job->share_count = (long)job->blocks[0] * job->blocks[1];
    job->worker_count = taut_parallel_workers(threads, 1L << 30);
    job->benches = taut_alloc_zero((size_t)job->worker_count, sizeof *job->benches);
    job->shares = taut_alloc((size_t)job->share_count, sizeof *job->shares);
    job->hard = taut_alloc_zero((size_t)job->panels[0]->count * (size_t)job->panels[1]->count, 1);
    if (job->benches == NULL || job->shares == NULL || job->hard == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int w = 0; w < job->worker_count; w++) {
        if (!bench_init(job, &job->benches[w])) {
            return TAUT_NO_MEMORY;
        }
    }
    return TAUT_OK;
}

static void job_free(taut_job *job)
{
    for (int w = 0; job->benches != NULL && w < job->worker_count; w++) {
        taut_cell_work_free(&job->benches[w].cell);
        taut_free(job->benches[w].numbers);
    }
    for (int d = 0; d < 2; d++) {
        taut_panels_free(job->panels[d]);
        taut_basis_free(job->moved[d]);
    }
    taut_free(job->benches);
    taut_free(job->shares);
    taut_free(job->hard);
    taut_free(job->active);
    taut_free(job->split);
    taut_rules_free(&job->rules);
}

taut_status taut_integrate(const taut_surface *surface, const taut_integrand *integrand,
                           int threads, taut_integrals *integrals)
{
    taut_sum value[TAUT_FIELDS_MAX] = {{0, 0}}, error[TAUT_FIELDS_MAX] = {{0, 0}};
    double pending[TAUT_FIELDS_MAX];
    taut_job job = {.integrand = integrand};
    taut_status status = job_init(surface, threads, &job);

    if (status == TAUT_OK) {
        taut_parallel_run(job.worker_count, job.share_count, first_task, &job);
        taut_job_gather(&job, value, error, pending);
        status = taut_job_rounds(&job, value, error, pending);
    }
    if (status == TAUT_OK) {
        for (int f = 0; f < 2 * integrand->count; f++) {
            integrals->value[f] = taut_sum_total(&value[f]);
            integrals->error[f] = taut_sum_total(&error[f]);
        }
        integrals->scale = job.cells.scale;
        integrals->shift[0] = job.cells.shift[0];
        integrals->shift[1] = job.cells.shift[1];
    }
    job_free(&job);
    return status;
}
