#include "numeric/tensor_solver.h"

#include "core/memory.h"
#include "numeric/contract.h"
#include "numeric/modes.h"
#include "numeric/tensor_apply.h"

#include <math.h>
#include <string.h>

/* One direction is diagonalised ("modes"), the other is left banded. */
struct taut_tensor_solver {
    taut_band ku, mu, kv, mv; /* as given */
    double su, sv;
    int is_first; /* the modes are those of the first direction */
    taut_modes *modes;
    taut_band stiff, mass; /* of the banded direction, one width */
};

/* x of an n x m net costs about n^2 m for modes along n, half when the modes are halves. */
static double cost(const taut_band *k, const taut_band *m, int other)
{
    (void)m;
    return (double)k->n * (double)k->n * (double)other;
}

/* The weights of the diagonalised and of the banded direction. */
static double modes_weight(const taut_tensor_solver *solver)
{
    return solver->is_first ? solver->su : solver->sv;
}

static double band_weight(const taut_tensor_solver *solver)
{
    return solver->is_first ? solver->sv : solver->su;
}

/* Is  weight_modes lambda M + weight_band K  positive definite for the least lambda? It is then for
 * all. */
static taut_status check_definite(const taut_tensor_solver *solver, double modes_scale,
                                  double band_scale)
{
    const taut_modes *modes = solver->modes;
    double least = modes->values[0];
    for (int p = 1; p < modes->parts; p++) {
        least = fmin(least, modes->values[modes->part[p].first]);
    }
    taut_band system = {0, 0, NULL};
    taut_status status = taut_band_widen(&solver->mass, solver->mass.width, &system);
    for (size_t i = 0; status == TAUT_OK && i < (size_t)system.n * ((size_t)system.width + 1);
         i++) {
        system.a[i] = modes_scale * least * system.a[i] + band_scale * solver->stiff.a[i];
    }
    if (status == TAUT_OK) {
        status = taut_band_factor(&system);
    }
    taut_band_clear(&system);
    return status;
}

static int is_weight(double s)
{
    return isfinite(s) && s > 0.0;
}

/* Rounding leaves eigenvalues that are zero a little to either side; below zero they would spoil
 * definiteness. Those that are truly negative are left for check_definite to find. */
static void clamp_values(taut_modes *modes)
{
    double most = 0.0;
    for (int i = 0; i < modes->n; i++) {
        most = fmax(most, fabs(modes->values[i]));
    }
    for (int i = 0; i < modes->n; i++) {
        if (modes->values[i] < 0.0 && modes->values[i] > -0x1p-40 * most) {
            modes->values[i] = 0.0;
        }
    }
}

static taut_status fill(const taut_band *ku, const taut_band *mu, const taut_band *kv,
                        const taut_band *mv, taut_tensor_solver *solver)
{
    const taut_band *const given[] = {ku, mu, kv, mv};
    taut_band *const copies[] = {&solver->ku, &solver->mu, &solver->kv, &solver->mv};
    taut_status status = TAUT_OK;
    for (int i = 0; i < 4 && status == TAUT_OK; i++) {
        status = taut_band_widen(given[i], given[i]->width, copies[i]);
    }
    solver->is_first = cost(ku, mu, kv->n) <= cost(kv, mv, ku->n);
    const taut_band *stiff = solver->is_first ? kv : ku, *mass = solver->is_first ? mv : mu;
    const int width = stiff->width > mass->width ? stiff->width : mass->width;
    if (status == TAUT_OK) {
        status = taut_band_widen(stiff, width, &solver->stiff);
    }
    if (status == TAUT_OK) {
        status = taut_band_widen(mass, width, &solver->mass);
    }
    if (status == TAUT_OK) { /* the other mass matrix is checked with the modes */
        taut_band factor = {0, 0, NULL};
        status = taut_band_widen(mass, width, &factor);
        status = status == TAUT_OK ? taut_band_factor(&factor) : status;
        taut_band_clear(&factor);
    }
    if (status == TAUT_OK) {
        status =
            taut_modes_new(solver->is_first ? ku : kv, solver->is_first ? mu : mv, &solver->modes);
    }
    if (status == TAUT_OK) {
        clamp_values(solver->modes);
    }
    return status;
}

taut_status taut_tensor_solver_new(const taut_band *ku, const taut_band *mu, const taut_band *kv,
                                   const taut_band *mv, double su, double sv,
                                   taut_tensor_solver **out)
{
    if (!taut_band_is_legal(ku) || !taut_band_is_legal(mu) || !taut_band_is_legal(kv) ||
        !taut_band_is_legal(mv) || ku->n != mu->n || kv->n != mv->n || !is_weight(su) ||
        !is_weight(sv) || out == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    taut_tensor_solver *solver = taut_alloc_zero(1, sizeof *solver);
    if (solver == NULL) {
        return TAUT_NO_MEMORY;
    }
    taut_status status = fill(ku, mu, kv, mv, solver);
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
    taut_modes_free(solver->modes);
    taut_band *const bands[] = {&solver->ku, &solver->mu,    &solver->kv,
                                &solver->mv, &solver->stiff, &solver->mass};
    for (size_t i = 0; i < sizeof bands / sizeof *bands; i++) {
        taut_band_clear(bands[i]);
    }
    taut_free(solver);
}

taut_status taut_tensor_solver_rescale(taut_tensor_solver *solver, double su, double sv)
{
    if (solver == NULL || !is_weight(su) || !is_weight(sv)) {
        return TAUT_BAD_ARGUMENT;
    }
    const taut_status status =
        check_definite(solver, solver->is_first ? su : sv, solver->is_first ? sv : su);
    if (status == TAUT_OK) {
        solver->su = su;
        solver->sv = sv;
    }
    return status;
}

/* ---- the banded systems
 * -------------------------------------------------------------------------------- */

/* Scratch for kernel->lanes of them. */
struct systems {
    double *factor; /* double[width + n][width + 1][lanes] */
    double *x;      /* double[n][nrhs][lanes] */
};

/* Rows first..first+lanes-1 of the modes: gathered, solved, put back. The net is seen along the
 * modes: row i of `lines`, with the banded direction across, `step` apart. */
static void solve_systems(const taut_tensor_solver *solver, const struct systems *systems,
                          int first, size_t row_stride, size_t step, int nrhs, double *x)
{
    const taut_kernel *kernel = solver->modes->kernel;
    const int n = solver->stiff.n, w = solver->stiff.width, lanes = kernel->lanes;
    const int used = solver->modes->n - first < lanes ? solver->modes->n - first : lanes;
    const size_t rhs = (size_t)nrhs;
    double shift[TAUT_LANES_MAX], negative[TAUT_LANES_MAX] = {0};

    for (int l = 0; l < lanes; l++) {
        shift[l] = modes_weight(solver) * solver->modes->values[first + (l < used ? l : used - 1)];
    }
    kernel->band_factor(0, n, w, solver->stiff.a, solver->mass.a, band_weight(solver), shift,
                        0x1p-1000, systems->factor, negative);
    for (int l = 0; l < lanes; l++) {
        const double *row = x + (size_t)(first + (l < used ? l : used - 1)) * row_stride;
        for (size_t j = 0; j < (size_t)n; j++) {
            for (size_t c = 0; c < rhs; c++) {
                systems->x[(j * rhs + c) * (size_t)lanes + (size_t)l] = row[j * step + c];
            }
        }
    }
    kernel->band_substitute(n, w, nrhs, systems->factor, systems->x);
    for (int l = 0; l < used; l++) {
        double *row = x + (size_t)(first + l) * row_stride;
        for (size_t j = 0; j < (size_t)n; j++) {
            for (size_t c = 0; c < rhs; c++) {
                row[j * step + c] = systems->x[(j * rhs + c) * (size_t)lanes + (size_t)l];
            }
        }
    }
}

taut_status taut_tensor_solver_solve(const taut_tensor_solver *solver, int nrhs, double *x)
{
    if (solver == NULL || nrhs < 1 || x == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    const size_t nu = (size_t)solver->ku.n, nv = (size_t)solver->kv.n, rhs = (size_t)nrhs;
    const size_t w = (size_t)solver->stiff.width, n = (size_t)solver->stiff.n;
    const size_t lane_bytes = (size_t)solver->modes->kernel->lanes * sizeof(double);
    const taut_lines lines =
        solver->is_first ? taut_lines_first(nu, nv, rhs) : taut_lines_second(nu, nv, rhs);
    const size_t step = solver->is_first ? rhs : nv * rhs;
    taut_panel panel;
    taut_status status = taut_panel_init(solver->modes, lines.columns, &panel);
    struct systems systems = {taut_alloc_aligned((n + w) * (w + 1), lane_bytes),
                              taut_alloc_aligned(n * rhs, lane_bytes)};
    if (status != TAUT_OK || systems.factor == NULL || systems.x == NULL) {
        status = TAUT_NO_MEMORY;
        goto done;
    }
    memset(systems.factor, 0, w * (w + 1) * lane_bytes);
    for (size_t c = 0; c < lines.columns; c += panel.width) {
        taut_panel_analyse(&panel, &lines, c,
                           lines.columns - c < panel.width ? lines.columns - c : panel.width, x);
    }
    for (int first = 0; first < solver->modes->n; first += solver->modes->kernel->lanes) {
        solve_systems(solver, &systems, first, lines.stride, step, nrhs, x);
    }
    for (size_t c = 0; c < lines.columns; c += panel.width) {
        taut_panel_synthesise(&panel, &lines, c,
                              lines.columns - c < panel.width ? lines.columns - c : panel.width, x);
    }

done:
    taut_free(systems.x);
    taut_free(systems.factor);
    taut_panel_clear(&panel);
    return status;
}

taut_status taut_tensor_solver_refine(const taut_tensor_solver *solver, int nrhs,
                                      const double *right, double *x, double *before)
{
    if (solver == NULL || nrhs < 1 || right == NULL || x == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    const taut_tensor tensor = {&solver->ku, &solver->mu, &solver->kv,
                                &solver->mv, solver->su,  solver->sv};
    const size_t entries = (size_t)solver->ku.n * (size_t)solver->kv.n * (size_t)nrhs;
    double *r = taut_alloc(entries, sizeof *r);
    taut_status status = r == NULL ? TAUT_NO_MEMORY : TAUT_OK;
    double norm = 0.0;
    if (status == TAUT_OK) {
        status = taut_tensor_residual(&tensor, nrhs, right, x, r, &norm);
    }
    if (status == TAUT_OK) {
        status = taut_tensor_solver_solve(solver, nrhs, r);
    }
    if (status == TAUT_OK) {
        for (size_t i = 0; i < entries; i++) {
            x[i] += r[i];
        }
        if (before != NULL) {
            *before = norm;
        }
    }
    taut_free(r);
    return status;
}
