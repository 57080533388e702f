/* edges.c -- right-hand sides that are zero but along the edges of the net.
 *
 * Boundary values reach only the rows and columns of the right-hand side along the edges. It is
 * split in two: what lies along the edges of the second direction is solved with the modes of the
 * first, (su lambda_i Mv + sv Kv) y_i = g_i,   g_i zero but at both ends, and the rest the other
 * way round. Such y_i fall off from the ends like exp(-sqrt(lambda_i) distance): most entries are
 * below rounding and are neither computed nor multiplied. That leaves O(n^2 log n) of O(n^3). */
#include "numeric/tensor/internal.h"

#include <math.h>
#include <string.h>

/* Entries that change the residual by less than this share of the largest right-hand side are left
 * out: the square root of their number times it stays below 2^-53. */
static const double negligible = 0x1p-60;

/* Rows at each end of direction e that carry the right-hand side. */
static size_t depth_of(const taut_tensor_solver *solver, int e)
{
    return (size_t)solver->direction[e].k.width;
}

int taut_edges_hold(const taut_tensor_solver *solver, int nrhs, const double *x)
{
    const size_t nu = (size_t)solver->direction[0].k.n, nv = (size_t)solver->direction[1].k.n;
    const size_t fu = depth_of(solver, 0), fv = depth_of(solver, 1), rhs = (size_t)nrhs;
    if (nu < 4 * fu + 4 || nv < 4 * fv + 4) {
        return 0;
    }
    for (size_t i = fu; i < nu - fu; i++) {
        const double *row = x + i * nv * rhs;
        for (size_t j = fv * rhs; j < (nv - fv) * rhs; j++) {
            if (row[j] != 0.0) {
                return 0;
            }
        }
    }
    return 1;
}

/* The part of x along the ends of direction e, as double[n_d][2 f][nrhs]; d = 1 leaves the corners
 * to d = 0. */
static void copy_edges(const taut_tensor_solver *solver, int d, size_t rhs, const double *x,
                       double *edges)
{
    const size_t nu = (size_t)solver->direction[0].k.n, nv = (size_t)solver->direction[1].k.n;
    const size_t fu = depth_of(solver, 0), fv = depth_of(solver, 1);
    const size_t n = d == 0 ? nu : nv, other = d == 0 ? nv : nu, f = d == 0 ? fv : fu;
    for (size_t i = 0; i < n; i++) {
        const int is_corner = d == 1 && (i < fv || i >= nv - fv);
        for (size_t e = 0; e < 2 * f; e++) {
            const size_t j = e < f ? e : other - 2 * f + e;
            const double *from = x + (d == 0 ? i * nv + j : j * nv + i) * rhs;
            double *to = edges + (i * 2 * f + e) * rhs;
            for (size_t c = 0; c < rhs; c++) {
                to[c] = is_corner ? 0.0 : from[c];
            }
        }
    }
}

/* Edges become V^T edges. Returns the largest entry. */
static double analyse_edges(const taut_contraction *work, size_t columns, double *edges)
{
    const size_t n = (size_t)work->modes->n;
    const taut_unfolding unfolding = {columns, columns, columns, 0};
    taut_contract_points(work, &unfolding, edges);
    double most = 0.0;
    for (size_t i = 0; i < n * columns; i++) {
        most = fmax(most, fabs(edges[i]));
    }
    return most;
}

/* One direction of modes at work. */
struct side {
    taut_systems systems;
    taut_arena *arena;
    size_t rhs, f;       /* f: rows at each end that carry the right-hand side */
    const double *edges; /* double[modes][2 f][nrhs] */
    double threshold;
};

/* Puts the ends of modes first..first+used-1 into systems->x: those at the start (end 0) as its
 * first rows, those at the end (end 1) as its last of `rows`. */
static void place_end(const struct side *side, int first, int used, int end, size_t rows)
{
    const size_t lanes = TAUT_LANES;
    const size_t count = side->f * side->rhs, at = end == 0 ? 0 : rows * side->rhs - count;
    for (size_t l = 0; l < (size_t)used; l++) {
        const double *from = side->edges + ((size_t)first + l) * 2 * count + (end == 0 ? 0 : count);
        for (size_t q = 0; q < count; q++) {
            side->systems.x[(at + q) * lanes + l] = from[q];
        }
    }
}

/* Is row i of the banded direction, row `at` of systems->x, below the threshold for all modes up to
 * `last`? */
static int is_negligible(const struct side *side, int last, int i, size_t at)
{
    const taut_direction *diagonal = &side->systems.solver->direction[side->systems.d];
    const taut_direction *banded = &side->systems.solver->direction[1 - side->systems.d];
    const size_t lanes = TAUT_LANES, count = side->rhs * lanes;
    const double *y = side->systems.x + at * count;
    const double size =
        diagonal->weight * diagonal->modes->values[last] * taut_band_row(&banded->m, i)[0] +
        banded->weight * taut_band_row(&banded->k, i)[0];
    double most = 0.0;
    for (size_t q = 0; q < count; q++) {
        most = fabs(y[q]) > most ? fabs(y[q]) : most;
    }
    return most * size <= side->threshold;
}

/* Solves rows from..upto-1 with the right-hand side at `ends` (bit 0: start, bit 1: end). */
static void solve_range(const struct side *side, int first, int used, int from, int upto, int ends)
{
    const size_t lanes = TAUT_LANES;
    const size_t rows = (size_t)(upto - from);
    memset(side->systems.x, 0, rows * side->rhs * lanes * sizeof(double));
    for (int end = 0; end < 2; end++) {
        if (ends & 1 << end) {
            place_end(side, first, used, end, rows);
        }
    }
    taut_systems_solve(&side->systems, first, used, from, upto, (int)side->rhs);
}

/* Solves from one end over `reach` rows. Returns how many rows are worth keeping, or -1 when the
 * solution has not died out within the reach. */
static int solve_end(const struct side *side, int first, int used, int end, int reach)
{
    const int n = side->systems.solver->direction[1 - side->systems.d].k.n, guard = (int)side->f;
    const int from = end == 0 ? 0 : n - reach;
    solve_range(side, first, used, from, from + reach, 1 << end);
    int keep = reach;
    while (keep > 0) {
        const int at = end == 0 ? keep - 1 : reach - keep;
        if (!is_negligible(side, first + used - 1, from + at, (size_t)at)) {
            break;
        }
        keep--;
    }
    return keep > reach - guard ? -1 : keep;
}

/* Keeps `keep` rows of systems->x, from row `at` on, as one end of the block. */
static void keep_rows(const struct side *side, int end, int keep, int at, taut_tail_block *block)
{
    const size_t lanes = TAUT_LANES;
    const size_t count = (size_t)keep * side->rhs, start = (size_t)at * side->rhs;
    double *values = taut_arena_take_raw(side->arena, (size_t)block->used * count, sizeof *values);
    if (values == NULL) {
        return;
    }
    for (size_t l = 0; l < (size_t)block->used; l++) {
        for (size_t q = 0; q < count; q++) {
            values[l * count + q] = side->systems.x[(start + q) * lanes + l];
        }
    }
    block->values[end] = values;
    block->keep[end] = (size_t)keep;
}

/* All rows at once, for modes that reach far: what is negligible in the middle is still left out.
 */
static void keep_all(const struct side *side, taut_tail_block *block)
{
    const int n = side->systems.solver->direction[1 - side->systems.d].k.n;
    const int last = block->first + block->used - 1;
    int head = n / 2, tail = n - n / 2;
    solve_range(side, block->first, block->used, 0, n, 3);
    while (head > 0 && is_negligible(side, last, head - 1, (size_t)head - 1)) {
        head--;
    }
    while (tail > 0 && is_negligible(side, last, n - tail, (size_t)(n - tail))) {
        tail--;
    }
    keep_rows(side, 0, head, 0, block);
    keep_rows(side, 1, tail, n - tail, block);
}

/* The tails of both ends within `reach` rows; 0 when one has not died out by then. */
static int keep_ends(const struct side *side, int reach, taut_tail_block *block)
{
    for (int end = 0; end < 2; end++) {
        const int keep = solve_end(side, block->first, block->used, end, reach);
        if (keep < 0) {
            return 0;
        }
        keep_rows(side, end, keep, end == 0 ? 0 : reach - keep, block);
    }
    return 1;
}

/* The tails of the modes of a block. *reach is a guess of how many rows they take, made better for
 * the next block; an arena that fails leaves them empty. */
static void fill_block(const struct side *side, int *reach, taut_tail_block *block)
{
    const int n = side->systems.solver->direction[1 - side->systems.d].k.n, guard = (int)side->f;
    const double work = taut_systems_work(&side->systems, *reach < n ? *reach : n, side->rhs);
    if (taut_crew_beat(&side->systems.solver->crew, work)) {
        return;
    }
    while (*reach <= n / 3 && !keep_ends(side, *reach, block)) {
        *reach *= 2;
    }
    if (*reach > n / 3) {
        keep_all(side, block);
    }
    const size_t longest = block->keep[0] > block->keep[1] ? block->keep[0] : block->keep[1];
    *reach = (int)longest + 2 * guard;
}

/* All tails of direction d, for right-hand sides `edges` (after analysis). */
static void fill_tails(const struct side *side, taut_tails *tails)
{
    const int d = side->systems.d;
    const taut_tensor_solver *solver = side->systems.solver;
    for (int p = 0; p < solver->direction[d].modes->parts; p++) {
        int reach = solver->direction[1 - d].k.n;
        for (size_t b = 0; b < tails->blocks[p]; b++) {
            fill_block(side, &reach, &tails->block[p][b]);
        }
    }
}

static taut_status solve_with(const taut_tensor_solver *solver, size_t rhs, taut_arena *arena,
                              double *x)
{
    const size_t n[2] = {(size_t)solver->direction[0].k.n, (size_t)solver->direction[1].k.n};
    const taut_unfolding unfolding[2] = {taut_unfolding_first(n[0], n[1], rhs),
                                         taut_unfolding_second(n[0], n[1], rhs)};
    taut_contraction work[2];
    taut_tails tails[2];

    for (int d = 0; d < 2; d++) {
        const taut_modes *modes = solver->direction[d].modes;
        const size_t f = depth_of(solver, 1 - d), columns = 2 * f * rhs;
        double *edges = taut_arena_take_raw(arena, n[d] * columns, sizeof *edges);
        struct side side = {.systems = taut_systems_of(solver, d, (int)rhs, arena),
                            .arena = arena,
                            .rhs = rhs,
                            .f = f,
                            .edges = edges};
        work[d] = taut_contraction_of(modes, n[1 - d] * rhs, &solver->crew, arena);
        tails[d] = taut_tails_of(modes, n[1 - d], rhs, arena);
        if (taut_arena_status(arena) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        copy_edges(solver, d, rhs, x, edges);
        side.threshold = negligible * analyse_edges(&work[d], columns, edges);
        fill_tails(&side, &tails[d]);
    }
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int d = 0; d < 2; d++) {
        taut_contract_tails(&work[d], &unfolding[d], &tails[d], d == 0, x);
    }
    return taut_pulse_is_stopped(solver->crew.pulse) ? TAUT_INTERRUPTED : TAUT_OK;
}

taut_status taut_edges_solve(const taut_tensor_solver *solver, int nrhs, double *x)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status = solve_with(solver, (size_t)nrhs, arena, x);
    taut_arena_free(arena);
    return status;
}
