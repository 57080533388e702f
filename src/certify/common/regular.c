/* regular.c -- a lower bound of the sine between R_u and R_v, and where it is smallest.
 *
 *     search from the lowest places of a grid
 *     for every span of the surface: pieces = { the span }
 *       while there are pieces, the one with the lowest bound of the last two first:
 *         look at the sine in its corners; where nothing separates, search from its middle
 *         bound >= share * smallest sine found, or > LEAST and enough work done: it is proved
 *         small and around a place where R_u or R_v = 0: nothing is proved, and it is left
 *         else halve it
 *     stop as soon as a sine <= LEAST is found: it is singular
 *     at the end search from where the bounds were lowest
 *
 * Where R_u = 0 the sine has no limit, and may be large all around: that place is undecided. A sine
 * is taken to be at most LEAST when that much is sure with all rounding.
 *
 * An isolated point in which R_u x R_v = 0 with R_u, R_v != 0 stays under small changes of a surface
 * (rank 1 of a 3 x 2 matrix has codimension 2), so it must be found as a point: sines near it grow
 * in proportion to the distance, and Gauss-Newton steps on the cross product of the unit directions
 * converge quadratically.
 */
#include "certify/common/regular.h"

#include "certify/common/directions.h"
#include "certify/common/tangents.h"
#include "core/arena.h"
#include "core/constants.h"
#include "core/memory.h"
#include "core/vec3.h"

#include <float.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum {
    DEPTH = 48, /* halvings in each direction: what is not separated then is rounding */
    LEVELS = 2 * DEPTH + 2,
    ALL_NUMBERS = 1 << 24, /* coefficients of pieces looked at before it is given up */
    MORE_PIECES = 64,      /* and so many for each span */
    EARLY = 16,            /* the share of both before a bound above LEAST is enough */
    SEARCH_DEPTH = 10,     /* halvings before a piece that does not separate is searched */
    SEARCHES = 16,         /* of these, a span */
    STARTS = 8,            /* and at the end, and of a grid */
    GRID = 33,             /* of one span; less of many */
    GRID_LEAST = 4,
    STEPS = 40,
    CLOSER = 512,     /* places seen in twice the precision */
    PIECE_WORK = 100, /* operations at a coefficient of a piece, as pulses count them */
    ZERO_DEPTH = 28,  /* halvings before a piece around a zero of R_u or R_v is left */
    ZEROS = 16
};
static const double share = 0.5;          /* of the smallest sine found */
static const double search_again = 0.25;  /* of the smallest sine of the last search: a new one */
static const double weight_range = 1e-60; /* of the largest weight */

/* A piece that waits: [at, at + 2^-depth] of a span in each direction. */
typedef struct leaf {
    taut_tangents tangents;
    double *block;
    double bound, at[2];
    int depth[2], direction;
} leaf;

/* The whole work. */
typedef struct work {
    taut_regular *found;
    const taut_surface *surface;
    const taut_crew *crew;
    double origin[3];
    int exponent[2]; /* of points and weights: unit size */
    int span[2];
    double lo[2], width[2];    /* of the span at hand */
    int growth[2];             /* its weights grow by 2^this from line to line: see balance */
    const taut_tangents *root; /* of the span, to evaluate */
    leaf stack[LEVELS];
    size_t size; /* of a block */
    int64_t budget;
    int closer, grid;
    int searches, done;     /* done: it is singular, or the budget is spent */
    double searched;        /* the smallest sine after the last search */
    double best[2];         /* in the span: the place of the smallest sine, if it is in this one */
    double zeros[ZEROS][2]; /* in the span: R_u or R_v is 0 there */
    int zero_count;
    struct {
        double bound, at[2]; /* in the span */
    } starts[STARTS];
    int start_count;
    double lines[GRID], sines[GRID * GRID];
} work;

/* The surface's own parameter. */
static double place(const work *w, int d, double s)
{
    const double t = s / (s + ldexp(1 - s, w->growth[d]));
    return fmin(w->lo[d] + t * w->width[d], w->lo[d] + w->width[d]);
}

static void keep_smallest(work *w, double sine, double most, double u, double v)
{
    if (most <= TAUT_REGULAR_LEAST) {
        w->found->holds = TAUT_FALSE;
        w->done = 1;
    }
    if (sine < w->found->sine) {
        w->found->sine = sine;
        w->found->at[0] = place(w, 0, u);
        w->found->at[1] = place(w, 1, v);
        w->best[0] = u;
        w->best[1] = v;
    }
}

/* Nothing is proved any more; the first reason is kept. */
static void leave_open(work *w, const char *why, double u, double v)
{
    if (w->found->bound > 0) {
        (void)snprintf(w->found->where, TAUT_REGULAR_TEXT, "%s u = %.6f, v = %.6f", why,
                       place(w, 0, u), place(w, 1, v));
    }
    w->found->bound = 0;
}

static void keep_zero(work *w, int k, double u, double v)
{
    leave_open(w,
               k == 0 ? "R_u is 0 to rounding, and there is no sine, at"
                      : "R_v is 0 to rounding, and there is no sine, at",
               u, v);
    if (w->zero_count < ZEROS) {
        w->zeros[w->zero_count][0] = u;
        w->zeros[w->zero_count++][1] = v;
    }
}

/* Directions in twice the precision, at u and v as they are told, their lengths left as they are:
 * where rounding is felt. 0 where that cannot be had. */
static int look_closer(work *w, double u, double v, taut_tangent_pair *pair)
{
    double x[2][3], error[2], most = 1;
    if (w->closer++ >= CLOSER ||
        !taut_certify_directions(w->surface, w->span, place(w, 0, u), place(w, 1, v), w->origin,
                                 w->exponent, x, error)) {
        return 0;
    }
    pair->sine = taut_tangents_sine(x, error, &most);
    pair->sine_most = most;
    for (int k = 0; k < 2; k++) {
        const double length = taut_norm(x[k]), wanted = taut_length(pair->x[k]);
        for (int c = 0; c < 3 && length > 0; c++) {
            pair->x[k][c] = x[k][c] / length * wanted;
        }
    }
    return 1;
}

/* Takes a sine if it is smaller than what was found, and known well enough. */
static void take_sine(work *w, double u, double v, taut_tangent_pair *pair)
{
    if (pair->sine < w->found->sine && !(pair->sine_most <= 1.01 * pair->sine)) {
        (void)look_closer(w, u, v, pair);
    }
    if (pair->sine_most < 1 || pair->sine > 0.99) {
        keep_smallest(w, pair->sine, pair->sine_most, u, v);
    }
}

/* Is A (or B) 0, but for rounding, that of u and v as they are told too? */
static int is_zero(const work *w, const taut_tangent_pair *pair, int k)
{
    double nearby = 2 * pair->error[k];
    for (int d = 0; d < 2; d++) {
        const double rounded = 1 + 2 * (fabs(w->lo[d]) + w->width[d]) / w->width[d];
        nearby += TAUT_UNIT_ROUNDOFF * rounded * taut_length(d == 0 ? pair->du[k] : pair->dv[k]);
    }
    return taut_length(pair->x[k]) <= nearby;
}

/* Takes the sine at a place; 0 where R_u or R_v is 0. */
static int judge(work *w, taut_tangent_pair *pair, double u, double v)
{
    take_sine(w, u, v, pair);
    for (int k = 0; k < 2; k++) {
        if (is_zero(w, pair, k)) {
            keep_zero(w, k, u, v);
            return 0;
        }
    }
    return 1;
}

/* ---- searches ---- */

enum { SINE, LENGTH_U, LENGTH_V }; /* what a search makes small */

/* Three numbers to make small, and their derivatives. */
static double residuals(const taut_tangent_pair *pair, int what, double f[3], double du[3],
                        double dv[3])
{
    double unit[2][3], slope[2][2][3];
    if (what != SINE) {
        const int k = what - LENGTH_U;
        memcpy(f, pair->x[k], 3 * sizeof *f);
        memcpy(du, pair->du[k], 3 * sizeof *du);
        memcpy(dv, pair->dv[k], 3 * sizeof *dv);
        return taut_dot(f, f);
    }
    for (int k = 0; k < 2; k++) {
        const double length = taut_length(pair->x[k]);
        for (int c = 0; c < 3; c++) {
            unit[k][c] = pair->x[k][c] / length;
        }
        for (int d = 0; d < 2; d++) {
            const double *const change = d == 0 ? pair->du[k] : pair->dv[k];
            const double along = taut_dot(change, unit[k]);
            for (int c = 0; c < 3; c++) {
                slope[k][d][c] = (change[c] - along * unit[k][c]) / length;
            }
        }
    }
    taut_cross(unit[0], unit[1], f);
    for (int d = 0; d < 2; d++) {
        double one[3], two[3], *const out = d == 0 ? du : dv;
        taut_cross(slope[0][d], unit[1], one);
        taut_cross(unit[0], slope[1][d], two);
        for (int c = 0; c < 3; c++) {
            out[c] = one[c] + two[c];
        }
    }
    return taut_dot(f, f);
}

/* The damped Gauss-Newton step, in the square: a direction that leads out is left out. */
static void take_step(const double f[3], const double du[3], const double dv[3], double damping,
                      const double at[2], double next[2])
{
    const double uu = taut_dot(du, du), uv = taut_dot(du, dv), vv = taut_dot(dv, dv);
    const double gradient[2] = {taut_dot(f, du), taut_dot(f, dv)};
    const double a = uu * (1 + damping), c = vv * (1 + damping), det = a * c - uv * uv;
    double step[2] = {-(c * gradient[0] - uv * gradient[1]) / det,
                      -(a * gradient[1] - uv * gradient[0]) / det};
    for (int d = 0; d < 2; d++) {
        const double to = at[d] + step[d];
        if (((at[d] <= 0 && to < 0) || (at[d] >= 1 && to > 1)) && isfinite(to)) {
            step[d] = 0;
            step[1 - d] = -gradient[1 - d] / (d == 0 ? c : a);
        }
    }
    for (int d = 0; d < 2; d++) {
        next[d] = fmin(fmax(at[d] + step[d], 0), 1);
    }
}

/* Marquardt's method (damping in proportion, as u and v may have other scales) from a place of the span; all that it sees is judged. */
static void search(work *w, int what, const double from[2])
{
    taut_tangent_pair here, there;
    double at[2] = {from[0], from[1]}, next[2], f[3], du[3], dv[3], damping = 1e-3;
    taut_tangents_at(w->root, at[0], at[1], &here);
    if (!judge(w, &here, at[0], at[1])) {
        return;
    }
    for (int k = 0; k < STEPS && damping < 1e8; k++) {
        const double value = residuals(&here, what, f, du, dv);
        double better = 0, spare[3][3];
        take_step(f, du, dv, damping, at, next);
        if (!isfinite(next[0]) || !isfinite(next[1]) || !isfinite(value) ||
            (next[0] == at[0] && next[1] == at[1])) {
            return;
        }
        taut_tangents_at(w->root, next[0], next[1], &there);
        if (what == SINE && there.sine_most > 1.01 * there.sine) {
            (void)look_closer(w, next[0], next[1], &there);
        }
        if (!judge(w, &there, next[0], next[1])) {
            return;
        }
        better = residuals(&there, what, spare[0], spare[1], spare[2]);
        if (better < value) {
            memcpy(at, next, sizeof at);
            here = there;
            damping *= 0.1;
            if (better > value * (1 - 1e-12)) {
                return;
            }
        } else {
            damping = fmax(8 * damping, 1e-6);
        }
    }
}

/* ---- pieces ---- */

static void look_at_corners(work *w, const leaf *l)
{
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            taut_tangent_pair pair = {.sine = 1};
            const double u = l->at[0] + i * ldexp(1, -l->depth[0]);
            const double v = l->at[1] + j * ldexp(1, -l->depth[1]);
            pair.sine = taut_tangents_corner(&l->tangents, i, j, &pair.sine_most);
            take_sine(w, u, v, &pair);
        }
    }
}

static void look_at(work *w, leaf *l)
{
    w->found->pieces++;
    w->done = w->done || taut_crew_beat(w->crew, PIECE_WORK * (double)w->size);
    look_at_corners(w, l);
    l->bound = taut_tangents_bound(&l->tangents, &l->direction);
    if (l->depth[l->direction] >= DEPTH) {
        l->direction = 1 - l->direction;
    }
}

/* Where pieces came much nearer to 0 than searches did, and where one is small and not separated. */
static void search_from_pieces(work *w, const leaf *l)
{
    const double middle[2] = {l->at[0] + ldexp(0.5, -l->depth[0]),
                              l->at[1] + ldexp(0.5, -l->depth[1])};
    const int depth = l->depth[0] + l->depth[1];
    if (w->found->sine < search_again * w->searched) {
        const double best[2] = {w->best[0], w->best[1]};
        search(w, SINE, best);
        w->searched = w->found->sine;
    }
    if (l->bound > 0 || depth < SEARCH_DEPTH || depth % SEARCH_DEPTH != 0 ||
        w->searches++ >= SEARCHES) {
        return;
    }
    for (int what = SINE; what <= LENGTH_V && !w->done; what++) {
        search(w, what, middle);
    }
    w->searched = w->found->sine;
}

/* The places of the lowest bounds, or sines, lowest first. */
static void keep_start(work *w, double bound, double u, double v)
{
    int k = w->start_count;
    for (; k > 0 && w->starts[k - 1].bound > bound; k--) {
        if (k < STARTS) {
            w->starts[k] = w->starts[k - 1];
        }
    }
    if (k < STARTS) {
        w->start_count += w->start_count < STARTS;
        w->starts[k].bound = bound;
        w->starts[k].at[0] = u;
        w->starts[k].at[1] = v;
    }
}

/* ---- a grid ---- */

static int is_low(const double *sines, int count, int i, int j)
{
    for (int k = i > 0 ? i - 1 : 0; k <= i + 1 && k < count; k++) {
        for (int l = j > 0 ? j - 1 : 0; l <= j + 1 && l < count; l++) {
            if (sines[k * count + l] < sines[i * count + j]) {
                return 0;
            }
        }
    }
    return !isnan(sines[i * count + j]);
}

/* Searches from the lowest of the local minima. */
static void search_grid(work *w, const taut_tangents *tangents, int count)
{
    for (int k = 0; k < count; k++) {
        w->lines[k] = k / (count - 1.0);
    }
    taut_tangents_grid(tangents, count, w->lines, w->lines, w->sines);
    w->start_count = 0;
    for (int k = 0; k < count * count; k++) {
        if (is_low(w->sines, count, k / count, k % count)) {
            keep_start(w, w->sines[k], w->lines[k / count], w->lines[k % count]);
        }
    }
    for (int k = 0; k < w->start_count && !w->done; k++) {
        if (k == 0 || w->starts[k].bound < 2 * w->found->sine) {
            search(w, SINE, w->starts[k].at);
        }
    }
    w->start_count = 0;
}

/* ---- pieces again ---- */

static int is_enough(const work *w, const leaf *l)
{
    const int late = w->found->pieces > w->budget / EARLY;
    return l->bound > TAUT_REGULAR_LEAST && (late || l->bound >= share * w->found->sine);
}

/* Is it small, and around or beside a zero of R_u or R_v? */
static int is_at_zero(const work *w, const leaf *l)
{
    const double size[2] = {ldexp(1, -l->depth[0]), ldexp(1, -l->depth[1])};
    for (int k = 0; k < w->zero_count && l->depth[0] + l->depth[1] >= ZERO_DEPTH; k++) {
        if (fabs(w->zeros[k][0] - l->at[0] - 0.5 * size[0]) <= 2 * size[0] &&
            fabs(w->zeros[k][1] - l->at[1] - 0.5 * size[1]) <= 2 * size[1]) {
            return 1;
        }
    }
    return 0;
}

/* Is there no way on? */
static int is_lost(work *w, const leaf *l)
{
    if (w->found->pieces > w->budget) {
        leave_open(w, "given up: as many pieces as are allowed do not separate it from 0 near",
                   l->at[0], l->at[1]);
        w->done = 1;
        return 1;
    }
    if (l->depth[l->direction] >= DEPTH) {
        leave_open(w, "rounding hides whether it is 0 near", l->at[0], l->at[1]);
        return 1;
    }
    return is_at_zero(w, l);
}

static taut_status halve(work *w, int top)
{
    leaf *const high = &w->stack[top], *const low = &w->stack[top + 1];
    const int d = high->direction;
    if (low->block == NULL) {
        low->block = taut_alloc(w->size, sizeof *low->block);
        if (low->block == NULL) {
            return TAUT_NO_MEMORY;
        }
    }
    taut_tangents_halve(&high->tangents, d, low->block, &low->tangents);
    high->depth[d]++;
    memcpy(low->depth, high->depth, sizeof low->depth);
    memcpy(low->at, high->at, sizeof low->at);
    high->at[d] += ldexp(1, -high->depth[d]);
    look_at(w, high);
    look_at(w, low);
    if (low->bound > high->bound) {
        const leaf kept = *low;
        *low = *high;
        *high = kept;
    }
    return TAUT_OK;
}

static taut_status visit_pieces(work *w)
{
    taut_status status = TAUT_OK;
    for (int top = 0; top >= 0 && !w->done && status == TAUT_OK;) {
        leaf *const l = &w->stack[top];
        search_from_pieces(w, l);
        if (w->done) {
            return TAUT_OK;
        }
        if (is_enough(w, l)) {
            w->found->bound = fmin(w->found->bound, l->bound);
            keep_start(w, l->bound, l->at[0] + ldexp(0.5, -l->depth[0]),
                       l->at[1] + ldexp(0.5, -l->depth[1]));
            top--;
        } else if (is_lost(w, l)) {
            top--;
        } else {
            status = halve(w, top);
            top++;
        }
    }
    return status;
}

/* One span, from its tangents. */
static taut_status visit_span(work *w, taut_tangents *tangents)
{
    leaf *const first = &w->stack[0];
    taut_status status = TAUT_OK;
    if (first->block == NULL) {
        w->size = taut_tangents_size(tangents);
        w->budget += (int64_t)(ALL_NUMBERS / w->size);
        first->block = taut_alloc(w->size, sizeof *first->block);
        if (first->block == NULL) {
            return TAUT_NO_MEMORY;
        }
    }
    w->root = tangents;
    w->start_count = w->searches = w->zero_count = 0;
    memcpy(first->block, tangents->a[0], w->size * sizeof *first->block);
    first->tangents = *tangents;
    taut_tangents_place(&first->tangents, first->block);
    first->at[0] = first->at[1] = 0;
    first->depth[0] = first->depth[1] = 0;
    search_grid(w, tangents, w->grid);
    w->searched = w->found->sine;
    look_at(w, first);
    status = visit_pieces(w);
    for (int k = 0; k < w->start_count && !w->done; k++) {
        if (w->starts[k].bound < w->found->sine) {
            search(w, SINE, w->starts[k].at);
        }
    }
    return status;
}

/* ---- the surface ---- */

/* Its middle, and the power of two that brings it to unit size. */
static int size_of(const taut_surface *surface, double origin[3])
{
    const int64_t count = (int64_t)taut_basis_count(taut_surface_u(surface)) *
                          taut_basis_count(taut_surface_v(surface));
    const double *const points = taut_surface_points(surface);
    double size = 0;
    int exponent = 0;
    for (int d = 0; d < 3; d++) {
        double low = INFINITY, high = -INFINITY;
        for (int64_t k = 0; k < count; k++) {
            low = fmin(low, points[3 * k + d]);
            high = fmax(high, points[3 * k + d]);
        }
        origin[d] = 0.5 * low + 0.5 * high;
        size = fmax(size, 0.5 * high - 0.5 * low);
    }
    (void)frexp(size, &exponent);
    return exponent;
}

/* Weights as the algebra can hold their squares: NULL where they differ by more. */
static const char *look_at_weights(const taut_surface *surface, int *exponent)
{
    const int64_t count = (int64_t)taut_basis_count(taut_surface_u(surface)) *
                          taut_basis_count(taut_surface_v(surface));
    const double *const weights = taut_surface_weights(surface);
    double least = INFINITY, most = 0;
    *exponent = 0;
    for (int64_t k = 0; weights != NULL && k < count; k++) {
        least = fmin(least, weights[k]);
        most = fmax(most, weights[k]);
    }
    if (weights == NULL) {
        return NULL;
    }
    (void)frexp(most, exponent);
    return least >= weight_range * most ? NULL : "the weights differ by more than 1e60";
}

/* Coefficient (i, j) of X, Y, Z and w times 2^(k + i g + j h), with k, g, h such that the largest
 * weight is about 1 and the weights at the four corners are alike: exact, and the surface in other
 * parameters s, t = s / (s + 2^g (1 - s)). Without that a piece on which weights grow like c^i
 * happens in a corner of the square. */
static void balance(work *w, taut_field piece[4])
{
    const int p = piece[3].p, q = piece[3].q;
    const size_t row = (size_t)q + 1, last = (size_t)p * row;
    int corner[4];
    if (piece[0].a == NULL || piece[1].a == NULL || piece[2].a == NULL || piece[3].a == NULL ||
        (p == 0 && q == 0)) {
        return;
    }
    (void)frexp(piece[3].a[0], &corner[0]);
    (void)frexp(piece[3].a[q], &corner[1]);
    (void)frexp(piece[3].a[last], &corner[2]);
    (void)frexp(piece[3].a[last + (size_t)q], &corner[3]);
    w->growth[0] = p > 0 ? (corner[2] + corner[3] - corner[0] - corner[1]) / (2 * p) : 0;
    w->growth[1] = q > 0 ? (corner[1] + corner[3] - corner[0] - corner[2]) / (2 * q) : 0;
    for (int c = 0; c < 4; c++) {
        for (size_t k = 0; k < last + row; k++) {
            const int power =
                (int)(k / row) * w->growth[0] + (int)(k % row) * w->growth[1] + w->exponent[1];
            piece[c].a[k] = ldexp(piece[c].a[k], -power);
            piece[c].e[k] = ldexp(piece[c].e[k], -power);
        }
    }
}

static void stop(work *w, const char *why)
{
    w->done = 1;
    w->found->bound = 0;
    (void)snprintf(w->found->where, TAUT_REGULAR_TEXT, "%s", why);
}

static taut_status visit_span_of(work *w)
{
    taut_arena *const arena = taut_arena_new();
    taut_field piece[4];
    taut_tangents tangents;
    taut_status status = taut_arena_status(arena);
    if (status == TAUT_OK && !taut_field_of_surface(arena, w->surface, w->span[0], w->span[1],
                                                    w->origin, w->exponent[0], piece, NULL)) {
        stop(w, "basis: no proof on spans of c- or h- bases wider than 4");
    } else if (status == TAUT_OK) {
        w->growth[0] = w->growth[1] = 0;
        balance(w, piece);
        if (taut_tangents_of(arena, piece, &tangents)) {
            status = visit_span(w, &tangents);
        } else if (taut_arena_status(arena) == TAUT_OK) {
            stop(w, "a value leaves the range of doubles, or the degree is too high");
        }
    }
    status = status == TAUT_OK ? taut_arena_status(arena) : status;
    taut_arena_free(arena);
    return status;
}

static taut_status visit_surface(work *w)
{
    const taut_basis *const bases[2] = {taut_surface_u(w->surface), taut_surface_v(w->surface)};
    const int spans[2] = {taut_basis_span_count(bases[0]), taut_basis_span_count(bases[1])};
    const char *const weights = look_at_weights(w->surface, &w->exponent[1]);
    int *const span = w->span;
    taut_status status = TAUT_OK;
    w->exponent[0] = size_of(w->surface, w->origin);
    w->budget = (int64_t)MORE_PIECES * spans[0] * spans[1];
    w->grid = (int)fmax(GRID_LEAST, GRID / sqrt((double)spans[0] * spans[1]));
    if (weights != NULL) {
        stop(w, weights);
    }
    for (span[0] = 0; span[0] < spans[0]; span[0]++) {
        for (span[1] = 0; span[1] < spans[1] && !w->done && status == TAUT_OK; span[1]++) {
            for (int d = 0; d < 2; d++) {
                w->lo[d] = taut_basis_breaks(bases[d])[span[d]];
                w->width[d] = taut_basis_breaks(bases[d])[span[d] + 1] - w->lo[d];
            }
            status = visit_span_of(w);
        }
    }
    return status;
}

taut_status taut_certify_regular(const taut_surface *surface, const taut_crew *crew,
                                 taut_regular *regular)
{
    work *const w = taut_alloc_zero(1, sizeof *w);
    taut_status status = TAUT_NO_MEMORY;
    if (w == NULL) {
        return TAUT_NO_MEMORY;
    }
    memset(regular, 0, sizeof *regular);
    regular->holds = TAUT_UNDECIDED;
    regular->sine = 1;
    regular->bound = 1;
    w->found = regular;
    w->surface = surface;
    w->crew = crew;
    status = visit_surface(w);
    if (crew != NULL && taut_pulse_is_stopped(crew->pulse)) {
        status = TAUT_INTERRUPTED;
    }
    for (int k = 0; k < LEVELS; k++) {
        taut_free(w->stack[k].block);
    }
    taut_free(w);
    if (regular->holds == TAUT_FALSE) {
        regular->bound = 0;
        (void)snprintf(regular->where, TAUT_REGULAR_TEXT, "u = %.6f, v = %.6f", regular->at[0],
                       regular->at[1]);
    } else if (regular->bound > TAUT_REGULAR_LEAST) {
        regular->holds = TAUT_TRUE;
        (void)snprintf(regular->where, TAUT_REGULAR_TEXT, "u = %.6f, v = %.6f; nowhere below %.3g",
                       regular->at[0], regular->at[1], regular->bound);
    }
    return status;
}

taut_status taut_certify_add_regular(const taut_regular *regular, taut_certificate *certificate)
{
    const taut_claim claim = {.claim = "regular",
                              .kind = TAUT_BOUND,
                              .residual = regular->sine,
                              .limit = TAUT_REGULAR_LEAST,
                              .holds = regular->holds,
                              .where = regular->where};
    return taut_certificate_add(certificate, &claim);
}

void taut_certify_regular_figure(const taut_regular *regular, taut_record *figures)
{
    if (regular->bound > 0) {
        taut_record_add_number(figures, "regular_bound", regular->bound);
    } else {
        taut_record_add_null(figures, "regular_bound");
    }
}

taut_status taut_certify_add_regular_of(const taut_surface *surface, const taut_crew *crew,
                                        taut_certificate *certificate, taut_record *figures)
{
    taut_regular regular;
    const taut_status status = taut_certify_regular(surface, crew, &regular);
    if (status != TAUT_OK) {
        return status;
    }
    taut_certify_regular_figure(&regular, figures);
    return taut_certify_add_regular(&regular, certificate);
}
