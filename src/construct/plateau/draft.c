#include "construct/plateau/draft.h"

#include "construct/plateau/hessian_band.h"
#include "core/vec3.h"
#include "numeric/band.h"

#include <math.h>
#include <string.h>

static const double moved_enough = 1e-9; /* in a unit in which the boundary lies in [-1, 1] */

enum { KEPT_MAX = 4, SWEEPS = 16 };

typedef struct work {
    taut_area_functional *functional;
    const taut_mask *mask;
    int *index; /* [nu][nv], -1 at known points */
    int *alive; /* [local]: those of a cell */
    int local, wide;
    double *element;                             /* [local][wide] */
    double *slope_u, *slope_v, *flux_u, *flux_v; /* [wide] */
    double *gradient, *delta, *product, *right;  /* [nu][nv][3], the last [unknowns][3] */
    double *tiles;
    taut_band metric;
    const double *held;
    size_t kept[KEPT_MAX]; /* points in planes and on lines */
    int kept_count;
    double *column; /* [unknowns][KEPT_MAX]: L_g^-1 of one at each */
} work;

static taut_status prepare(work *w, taut_arena *arena)
{
    const taut_area_functional *f = w->functional;
    const size_t net = (size_t)f->nu * (size_t)f->nv, vector = 3 * sizeof(double);
    int width = 0;

    w->local = f->u.local * f->v.local;
    w->wide = (w->local + TAUT_AREA_PAD - 1) / TAUT_AREA_PAD * TAUT_AREA_PAD;
    const size_t wide = (size_t)w->wide;
    w->index = taut_arena_take(arena, net, sizeof(int));
    w->alive = taut_arena_take(arena, (size_t)w->local, sizeof(int));
    w->element = taut_arena_take(arena, (size_t)w->local * wide, sizeof(double));
    w->slope_u = taut_arena_take(arena, 4 * wide, sizeof(double));
    w->gradient = taut_arena_take(arena, net, vector);
    w->delta = taut_arena_take(arena, net, vector);
    w->product = taut_arena_take(arena, net, vector);
    w->right = taut_arena_take(arena, w->mask->unknowns, vector);
    w->column = taut_arena_take(arena, w->mask->unknowns, KEPT_MAX * sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    w->slope_v = w->slope_u + wide;
    w->flux_u = w->slope_v + wide;
    w->flux_v = w->flux_u + wide;
    const int count = taut_area_number(f, w->mask, w->index, &width);
    w->tiles = taut_arena_take(arena, taut_band_tiles_work(count, width), sizeof(double));
    return w->tiles == NULL ? TAUT_NO_MEMORY : taut_band_init(count, width, &w->metric);
}

/* Adds w (G p_u q_u - F (p_u q_v + p_v q_u) + E p_v q_v) / W of a node to the element. */
static void add_node(work *w, int line, int k)
{
    const taut_area_axis *u = &w->functional->u, *v = &w->functional->v;
    const double *n = u->value + line * u->local, *d = u->slope + line * u->local;
    const double *m = v->value + k * v->local, *e = v->slope + k * v->local;
    double *restrict pu = w->slope_u, *restrict pv = w->slope_v;
    double state[TAUT_AREA_STATE];

    taut_area_functional_state(w->functional, line, k, state);
    for (int a = 0, p = 0; a < u->local; a++) {
        for (int b = 0; b < v->local; b++, p++) {
            pu[p] = d[a] * m[b];
            pv[p] = n[a] * e[b];
            w->flux_u[p] = state[5] * pu[p] - state[4] * pv[p];
            w->flux_v[p] = state[3] * pv[p] - state[4] * pu[p];
        }
    }
    for (int p = 0; p < w->local; p++) {
        const double fu = w->flux_u[p], fv = w->flux_v[p];
        double *restrict row = w->element + (size_t)p * (size_t)w->wide;
        for (int q = 0; q < w->wide; q++) {
            row[q] += fu * pu[q] + fv * pv[q];
        }
    }
}

static void add_number(work *w, int a, int b, double value)
{
    if (a >= b && b >= 0) {
        taut_band_row(&w->metric, a)[a - b] += value;
    }
}

static void add_element(work *w, int line, int k)
{
    const taut_area_axis *u = &w->functional->u, *v = &w->functional->v;
    const int *index =
        w->index + (size_t)u->first[line] * (size_t)w->mask->nv + (size_t)v->first[k];
    int *at = w->alive;

    for (int p = 0; p < w->local; p++) {
        at[p] = index[(size_t)(p / v->local) * (size_t)w->mask->nv + (size_t)(p % v->local)];
    }
    for (int p = 0; p < w->local; p++) {
        const double *row = w->element + (size_t)p * (size_t)w->wide;
        for (int q = 0; at[p] >= 0 && q < w->local; q++) {
            add_number(w, at[p], at[q], row[q]);
        }
    }
}

static void add_cable(work *w, const taut_area_cable *cable)
{
    const int *index = w->index + cable->first;

    for (int node = 0; node < cable->nodes; node++) {
        const double *slope = cable->slope + (size_t)node * (size_t)cable->local;
        const double weight = cable->tension * cable->state[node * TAUT_AREA_CABLE_STATE + 3];
        for (int p = 0; p < cable->local * cable->local; p++) {
            const int a = p / cable->local, b = p % cable->local;
            add_number(w, index[(size_t)(cable->alive[node] + a) * cable->step],
                       index[(size_t)(cable->alive[node] + b) * cable->step],
                       weight * slope[a] * slope[b]);
        }
    }
}

/* L_g of the last gradient's net, and its factors. */
static taut_status factor_metric(work *w)
{
    const taut_area_functional *f = w->functional;
    const size_t numbers = (size_t)w->local * (size_t)w->wide;

    memset(w->metric.a, 0, (size_t)w->metric.n * ((size_t)w->metric.width + 1) * sizeof(double));
    for (int line = 0; line < f->u.count; line += f->u.nodes) {
        for (int k = 0; k < f->v.count; k += f->v.nodes) {
            memset(w->element, 0, numbers * sizeof(double));
            for (int g = 0; g < f->u.nodes * f->v.nodes; g++) {
                add_node(w, line + g / f->v.nodes, k + g % f->v.nodes);
            }
            add_element(w, line, k);
        }
    }
    for (int k = 0; k < f->cable_count; k++) {
        add_cable(w, f->cables + k);
    }
    return w->metric.width >= TAUT_BAND_TILES_LEAST
               ? taut_band_factor_tiled(&w->metric, w->tiles, NULL)
               : taut_band_factor(&w->metric);
}

/* The multipliers of cables that are to have a length go on from what they draw with now. */
static void lead_multipliers(taut_area_functional *f)
{
    for (int k = 0; k < f->cable_count; k++) {
        if (f->cables[k].stiffness > 0 && f->cables[k].base > 0) {
            f->cables[k].base = f->cables[k].tension;
        }
    }
}

/* The unknown points that are not free; TAUT_NO_SOLUTION: more than there is room for. */
static taut_status find_kept(work *w)
{
    const taut_mask *mask = w->mask;
    for (size_t i = 0; mask->allowed != NULL && i < (size_t)mask->nu * (size_t)mask->nv; i++) {
        const double *p = mask->allowed + 6 * i;
        if (w->index[i] >= 0 && p[0] + p[2] + p[5] < 2.5) { /* the trace is its rank */
            if (w->kept_count == KEPT_MAX) {
                return TAUT_NO_SOLUTION;
            }
            w->kept[w->kept_count++] = i;
        }
    }
    return TAUT_OK;
}

/* What is across the way of kept point k of x. */
static void take_across(const work *w, int k, double x[3])
{
    double along[3] = {x[0], x[1], x[2]};
    taut_mask_project(w->mask->allowed + 6 * w->kept[k], along);
    taut_add_scaled(-1, along, x);
}

/* The least of the quadratic form among the moves that bring kept points to their planes and lines: forces across these that
 * hold them, one point after the other. What is left of rounding and sweeps is taken off. */
static void keep(work *w, const double *net)
{
    const int count = w->metric.n, kept = w->kept_count;

    if (kept == 0) {
        return;
    }
    memset(w->column, 0, (size_t)count * KEPT_MAX * sizeof(double));
    for (int k = 0; k < kept; k++) {
        w->column[w->index[w->kept[k]] * KEPT_MAX + k] = 1;
    }
    taut_band_solve(&w->metric, KEPT_MAX, w->column);
    for (int sweep = 0; sweep <= SWEEPS; sweep++) {
        for (int k = 0; k < kept; k++) {
            const size_t at = w->kept[k];
            const int own = w->index[at];
            double lack[3];
            for (int c = 0; c < 3; c++) {
                lack[c] =
                    w->held[3 * at + (size_t)c] - net[3 * at + (size_t)c] - w->right[3 * own + c];
            }
            take_across(w, k, lack);
            if (sweep == SWEEPS) {
                taut_add_scaled(1, lack, w->right + 3 * own);
                continue;
            }
            for (int i = 0; i < count; i++) {
                taut_add_scaled(w->column[i * KEPT_MAX + k] / w->column[own * KEPT_MAX + k], lack,
                                w->right + 3 * i);
            }
        }
    }
}

/* One step; *moved: how far its farthest point went. moves_known: `delta` holds what known points do, else they do nothing. */
static taut_status step(work *w, int moves_known, double *net, double *moved)
{
    const size_t count = (size_t)w->mask->nu * (size_t)w->mask->nv;

    (void)taut_area_functional_gradient(w->functional, net, w->gradient);
    taut_mask_reduce(w->mask, w->gradient);
    lead_multipliers(w->functional);
    const taut_status status = factor_metric(w);
    if (status != TAUT_OK) {
        return status;
    }
    memset(w->product, 0, 3 * count * sizeof(double));
    if (moves_known) {
        taut_area_functional_product(w->functional, 1, w->delta, w->product);
        taut_mask_reduce(w->mask, w->product);
    }
    for (size_t i = 0; i < 3 * count; i++) {
        if (!w->mask->known[i / 3]) {
            w->right[3 * (size_t)w->index[i / 3] + i % 3] = -(w->gradient[i] + w->product[i]);
        }
    }
    taut_band_solve(&w->metric, 3, w->right);
    keep(w, net);
    *moved = 0;
    for (size_t i = 0; i < count; i++) {
        const double *d = w->index[i] >= 0 ? w->right + 3 * (size_t)w->index[i] : w->delta + 3 * i;
        if (w->index[i] >= 0 || moves_known) {
            taut_add_scaled(1, d, net + 3 * i);
            *moved = fmax(*moved, taut_length(d));
        }
    }
    return isfinite(*moved) ? TAUT_OK : TAUT_NO_SOLUTION;
}

taut_status taut_area_draft(taut_area_functional *functional, const taut_mask *mask,
                            const double *held, int steps, double *net)
{
    const size_t count = (size_t)mask->nu * (size_t)mask->nv;
    taut_arena *arena = taut_arena_new();
    work w = {.functional = functional, .mask = mask, .held = held};
    double moved = INFINITY;
    taut_status status = prepare(&w, arena);

    if (status == TAUT_OK) {
        status = find_kept(&w);
    }
    for (size_t i = 0; status == TAUT_OK && i < 3 * count; i++) {
        w.delta[i] = mask->known[i / 3] && w.index[i / 3] < 0 ? held[i] - net[i] : 0;
    }
    for (int k = 0; status == TAUT_OK && k < steps && moved > moved_enough; k++) {
        status = step(&w, k == 0, net, &moved);
    }
    taut_band_clear(&w.metric);
    taut_arena_free(arena);
    return status;
}
