#include "numeric/tensor/solver.h"

#include "core/arena.h"
#include "core/memory.h"
#include "numeric/modes_lent.h"
#include "numeric/tensor/apply.h"
#include "numeric/tensor/internal.h"

#include <math.h>
#include <string.h>

/* From this size on a second set of modes costs less than what it saves in one solve for boundary
 * values. */
enum { EDGES_SIZE = 500 };

enum { BLOCK = 16 };

static int is_weight(double s)
{
    return isfinite(s) && s > 0.0;
}

/* Is  weight_d lambda M + weight_e K  positive definite for the least lambda? It is then for all.
 */
static taut_status check_definite(const taut_tensor_solver *solver, const double *weight)
{
    const int d = solver->diagonal;
    const taut_modes *modes = solver->direction[d].modes;
    const taut_direction *banded = &solver->direction[1 - d];
    double least = modes->values[0];
    for (int p = 1; p < modes->parts; p++) {
        least = fmin(least, modes->values[modes->part[p].first]);
    }
    taut_band system = {0, 0, NULL};
    taut_status status = taut_band_widen(&banded->m, banded->m.width, &system);
    if (status != TAUT_OK) {
        return status;
    }
    for (size_t i = 0; i < (size_t)system.n * ((size_t)system.width + 1); i++) {
        system.a[i] = weight[d] * least * system.a[i] + weight[1 - d] * banded->k.a[i];
    }
    status = taut_band_factor(&system);
    taut_band_clear(&system);
    return status;
}

/* M must be definite also where no modes are made. */
static taut_status copy_direction(const taut_band *k, const taut_band *m, taut_direction *out)
{
    const int width = k->width > m->width ? k->width : m->width;
    taut_band factor = {0, 0, NULL};
    taut_status status = taut_band_widen(k, width, &out->k);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_band_widen(m, width, &out->m);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_band_widen(m, width, &factor);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_band_factor(&factor);
    taut_band_clear(&factor);
    return status;
}

static taut_status make_modes(taut_direction *direction, taut_pulse *pulse)
{
    return taut_modes_lend(&direction->k, &direction->m, pulse, &direction->modes);
}

/* Modes of one direction are enough; those of the other, where it pays, make solves for boundary
 * values cheap. */
static taut_status make_directions(const taut_band *const *given, taut_tensor_solver *solver)
{
    taut_direction *u = &solver->direction[0], *v = &solver->direction[1];
    for (int d = 0; d < 2; d++) {
        const taut_status status =
            copy_direction(given[2 * d], given[2 * d + 1], &solver->direction[d]);
        if (status != TAUT_OK) {
            return status;
        }
    }
    solver->diagonal = u->k.n <= v->k.n ? 0 : 1;
    solver->has_shared = taut_band_equal(&u->k, &v->k) && taut_band_equal(&u->m, &v->m);
    const taut_status status = make_modes(&solver->direction[solver->diagonal], solver->crew.pulse);
    if (status != TAUT_OK) {
        return status;
    }
    if (solver->has_shared) {
        v->modes = u->modes;
        return TAUT_OK;
    }
    return u->k.n >= EDGES_SIZE && v->k.n >= EDGES_SIZE
               ? make_modes(&solver->direction[1 - solver->diagonal], solver->crew.pulse)
               : TAUT_OK;
}

taut_status taut_tensor_solver_new(const taut_band *ku, const taut_band *mu, const taut_band *kv,
                                   const taut_band *mv, double su, double sv, const taut_crew *crew,
                                   taut_tensor_solver **out)
{
    const taut_band *const given[] = {ku, mu, kv, mv};
    for (int i = 0; i < 4; i++) {
        if (!taut_band_is_legal(given[i])) {
            return TAUT_BAD_ARGUMENT;
        }
    }
    if (ku->n != mu->n || kv->n != mv->n || out == NULL || !is_weight(su) || !is_weight(sv)) {
        return TAUT_BAD_ARGUMENT;
    }
    taut_tensor_solver *solver = taut_alloc_zero(1, sizeof *solver);
    if (solver == NULL) {
        return TAUT_NO_MEMORY;
    }
    solver->crew = crew != NULL ? *crew : (taut_crew){.threads = 1};
    taut_status status = make_directions(given, solver);
    if (status == TAUT_OK) {
        status = taut_tensor_solver_rescale(solver, su, sv);
    }
    if (status != TAUT_OK) {
        taut_tensor_solver_free(solver);
        return status;
    }
    *out = solver;
    return TAUT_OK;
}

void taut_tensor_solver_free(taut_tensor_solver *solver)
{
    if (solver == NULL) {
        return;
    }
    for (int d = 0; d < 2; d++) {
        taut_direction *direction = &solver->direction[d];
        if (d == 0 || !solver->has_shared) {
            taut_modes_give_back(direction->modes);
        }
        taut_band_clear(&direction->k);
        taut_band_clear(&direction->m);
    }
    taut_free(solver);
}

taut_status taut_tensor_solver_rescale(taut_tensor_solver *solver, double su, double sv)
{
    if (solver == NULL || !is_weight(su) || !is_weight(sv)) {
        return TAUT_BAD_ARGUMENT;
    }
    const double weight[2] = {su, sv};
    const taut_status status = check_definite(solver, weight);
    if (status == TAUT_OK) {
        solver->direction[0].weight = su;
        solver->direction[1].weight = sv;
    }
    return status;
}

/* Entry (j, c) of mode i, a row of the net by now, is at x[i * row + j * step + c]. */
struct layout {
    size_t row, step, n, rhs;
};

/* Modes first..first+used-1 to and from lanes: inside[(j * rhs + c) * lanes + l]. A few j at a
 * time, so that what is written with gaps stays in the first-level cache. */
static void gather_modes(const struct layout *at, size_t first, size_t used, size_t lanes,
                         const double *x, double *inside)
{
    for (size_t block = 0; block < at->n; block += BLOCK) {
        const size_t end = block + BLOCK < at->n ? block + BLOCK : at->n;
        for (size_t l = 0; l < used; l++) {
            const double *from = x + (first + l) * at->row;
            for (size_t j = block; j < end; j++) {
                for (size_t c = 0; c < at->rhs; c++) {
                    inside[(j * at->rhs + c) * lanes + l] = from[j * at->step + c];
                }
            }
        }
    }
}

static void scatter_modes(const struct layout *at, size_t first, size_t used, size_t lanes,
                          const double *inside, double *x)
{
    for (size_t block = 0; block < at->n; block += BLOCK) {
        const size_t end = block + BLOCK < at->n ? block + BLOCK : at->n;
        for (size_t l = 0; l < used; l++) {
            double *to = x + (first + l) * at->row;
            for (size_t j = block; j < end; j++) {
                for (size_t c = 0; c < at->rhs; c++) {
                    to[j * at->step + c] = inside[(j * at->rhs + c) * lanes + l];
                }
            }
        }
    }
}

/* The banded systems of all modes, some side by side. */
struct rows_job {
    const taut_systems *systems; /* of each worker */
    const struct layout *at;
    double *x;
};

static void solve_some(void *context, int worker, int64_t task)
{
    const struct rows_job *job = context;
    const struct layout *at = job->at;
    const taut_systems *systems = &job->systems[worker];
    const size_t lanes = TAUT_LANES, first = (size_t)task * lanes;
    const size_t left = (size_t)systems->solver->direction[systems->d].modes->n - first;
    const size_t used = left < lanes ? left : lanes;

    if (used < lanes) {
        memset(systems->x, 0, at->n * at->rhs * lanes * sizeof *systems->x);
    }
    gather_modes(at, first, used, lanes, job->x, systems->x);
    taut_systems_solve(systems, (int)first, (int)used, 0, (int)at->n, (int)at->rhs);
    scatter_modes(at, first, used, lanes, systems->x, job->x);
}

/* Solves them in place, each worker with systems of its own. */
static void solve_rows(const taut_systems *systems, int workers, const struct layout *at, double *x)
{
    const taut_tensor_solver *solver = systems->solver;
    const int n = solver->direction[systems->d].modes->n;
    struct rows_job job = {systems, at, x};

    taut_crew_run(&solver->crew, workers, (n + TAUT_LANES - 1) / TAUT_LANES,
                  taut_systems_work(systems, (int)at->n, at->rhs), solve_some, &job);
}

static taut_status solve_dense(const taut_tensor_solver *solver, size_t rhs, taut_arena *arena,
                               double *x)
{
    const int d = solver->diagonal;
    const size_t nu = (size_t)solver->direction[0].k.n, nv = (size_t)solver->direction[1].k.n;
    const taut_unfolding unfolding =
        d == 0 ? taut_unfolding_first(nu, nv, rhs) : taut_unfolding_second(nu, nv, rhs);
    const struct layout layout = {unfolding.stride, d == 0 ? rhs : nv * rhs, d == 0 ? nv : nu, rhs};
    const int workers = taut_crew_workers(&solver->crew, solver->direction[d].k.n / TAUT_LANES + 1);
    taut_systems *systems = taut_arena_take_raw(arena, (size_t)workers, sizeof *systems);
    const taut_contraction work =
        taut_contraction_of(solver->direction[d].modes, unfolding.columns, &solver->crew, arena);
    for (int i = 0; systems != NULL && i < workers; i++) {
        systems[i] = taut_systems_of(solver, d, (int)rhs, arena);
    }
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_contract_points(&work, &unfolding, x);
    solve_rows(systems, workers, &layout, x);
    taut_contract_modes(&work, &unfolding, x);
    return taut_pulse_is_stopped(solver->crew.pulse) ? TAUT_INTERRUPTED : TAUT_OK;
}

taut_status taut_tensor_solver_solve(const taut_tensor_solver *solver, int nrhs, double *x)
{
    if (solver == NULL || nrhs < 1 || x == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    const taut_direction *u = &solver->direction[0], *v = &solver->direction[1];
    const int may_part =
        u->modes != NULL && v->modes != NULL && u->k.n >= EDGES_SIZE && v->k.n >= EDGES_SIZE;
    if (may_part && taut_edges_hold(solver, nrhs, x)) {
        return taut_edges_solve(solver, nrhs, x);
    }
    taut_arena *arena = taut_arena_new();
    const taut_status status = solve_dense(solver, (size_t)nrhs, arena, x);
    taut_arena_free(arena);
    return status;
}

/* r is scratch. */
static taut_status refine_with(const taut_tensor_solver *solver, int nrhs, const double *right,
                               double *r, double *x, double *before)
{
    const taut_direction *u = &solver->direction[0], *v = &solver->direction[1];
    const taut_tensor tensor = {&u->k, &u->m, &v->k, &v->m, u->weight, v->weight, &solver->crew};
    const size_t entries = (size_t)u->k.n * (size_t)v->k.n * (size_t)nrhs;
    double norm = 0.0;
    taut_status status = taut_tensor_residual(&tensor, nrhs, right, x, r, &norm);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_tensor_solver_solve(solver, nrhs, r);
    if (status != TAUT_OK) {
        return status;
    }
    for (size_t i = 0; i < entries; i++) {
        x[i] += r[i];
    }
    if (before != NULL) {
        *before = norm;
    }
    return TAUT_OK;
}

taut_status taut_tensor_solver_refine(const taut_tensor_solver *solver, int nrhs,
                                      const double *right, double *x, double *before)
{
    if (solver == NULL || nrhs < 1 || right == NULL || x == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    const size_t entries =
        (size_t)solver->direction[0].k.n * (size_t)solver->direction[1].k.n * (size_t)nrhs;
    double *r = taut_alloc(entries, sizeof *r);
    const taut_status status =
        r != NULL ? refine_with(solver, nrhs, right, r, x, before) : TAUT_NO_MEMORY;
    taut_free(r);
    return status;
}
