#include "construct/pattern/flatten.h"

#include "construct/pattern/conformal.h"
#include "construct/pattern/develop.h"
#include "construct/pattern/strains.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/keep.h"
#include "numeric/quadrature.h"
#include "pattern/flat/line.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ALONG = 16, ACROSS = 4, EDGE_NODES = 16, FINEST_CELLS = 128 * 32 };
/* Stretches that differ by less are the same. */
static const double same_stretch = 1e-11;
/* Sides between straight ends are of one length where they differ by less, over it. */
static const double same_sides = 1e-4;
/* Of a piece for the pulse: operations, roughly. */
static const double work_of_piece = 5e7;

/* ---- edges of flat pieces ---- */

/* An edge of a flat piece, in the order of taut_flat_edge, as s or t grows: points (y_1, y_2, 0), the arena's. */
static taut_status edge_curve(const taut_flat *flat, int edge, taut_arena *arena,
                              const taut_curve **curve)
{
    const int way = edge == TAUT_FLAT_START || edge == TAUT_FLAT_END, count = flat->count[way];
    const int last = edge == TAUT_FLAT_END    ? flat->count[0] - 1
                     : edge == TAUT_FLAT_LEFT ? flat->count[1] - 1
                                              : 0;
    double *points = taut_arena_take(arena, (size_t)count, 3 * sizeof(double));
    const taut_basis_spec spec = {.type = "bspline",
                                  .degree = TAUT_FLAT_DEGREE,
                                  .knot_count = count + TAUT_FLAT_DEGREE + 1,
                                  .knots = flat->knots[way]};
    taut_basis *basis = NULL;
    taut_curve *made = NULL;

    if (points == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < count; k++) {
        const int i = way ? last : k, j = way ? k : last;
        memcpy(points + 3 * (size_t)k, flat->points + 2 * (i * flat->count[1] + j),
               2 * sizeof(double));
    }
    taut_status status = taut_basis_new(&spec, count, &basis, NULL);
    if (status == TAUT_OK) {
        status = taut_curve_new(NULL, basis, points, NULL, &made, NULL);
    }
    taut_basis_free(basis);
    *curve = made;
    return status == TAUT_OK && taut_keep_curve(arena, made) ? TAUT_OK : TAUT_NO_MEMORY;
}

static taut_status all_edges(const taut_flat *flat, taut_arena *arena,
                             const taut_curve *edges[TAUT_FLAT_EDGES])
{
    taut_status status = TAUT_OK;
    for (int e = 0; status == TAUT_OK && e < TAUT_FLAT_EDGES; e++) {
        status = edge_curve(flat, e, arena, &edges[e]);
    }
    return status;
}

/* |y_x| and its derivative by x, of a piece alone. */
static void own_speed(const taut_pattern_piece *piece, int edge, double x, double speed[2])
{
    double y[3][3];
    taut_curve_eval(piece->alone_edges[edge], x, 2, y[0]);
    speed[0] = taut_hypot(y[1][0], y[1][1]);
    speed[1] = (y[1][0] * y[2][0] + y[1][1] * y[2][1]) / speed[0];
}

/* The share by which a piece's edge is cut smaller on the average, of warp and weft and how it runs between them; where they fade
 * out, `is_faded`, or as if they did not. */
static double seam_compensation(const taut_pattern_layout *layout, const taut_pattern_cut *cut,
                                int piece, int edge, int is_faded)
{
    double nodes[EDGE_NODES], weights[EDGE_NODES], sum = 0;
    const taut_pattern_piece *own = &layout->pieces[piece];
    const int is_across = edge == TAUT_FLAT_START || edge == TAUT_FLAT_END;
    const double fixed = edge == TAUT_FLAT_END || edge == TAUT_FLAT_LEFT;
    if (cut->compensation.has_seam) {
        return cut->compensation.seam;
    }
    taut_gauss_rule(EDGE_NODES, nodes, weights);
    for (int i = 0; i < EDGE_NODES; i++) {
        const double x = (1 + nodes[i]) / 2;
        double y[2][3], shrink[2] = {1 - own->shares[0], 1 - own->shares[1]};
        if (is_faded) {
            taut_pattern_piece_shrink(own, is_across ? fixed : x, is_across ? x : fixed, shrink);
        }
        taut_curve_eval(own->alone_edges[edge], x, 1, y[0]);
        /* the direction on the surface is that before the cloth was made smaller */
        const double a = y[1][0] / shrink[0], b = y[1][1] / shrink[1];
        sum += weights[i] / 2 * (1 - taut_hypot(y[1][0], y[1][1]) / taut_hypot(a, b));
    }
    return sum;
}

/* Of seams whose length is that of the surface: the mean of both sides, each piece as long as it lies along it. */
static void set_share(const taut_pattern_layout *layout, const taut_pattern_cut *cut,
                      taut_pattern_side *side)
{
    double sums[2] = {0, 0};
    for (int k = 0; k < side->holder_count; k++) {
        const taut_pattern_holder *one = &side->holders[k];
        sums[one->hand] +=
            fabs(one->to - one->from) * seam_compensation(layout, cut, one->piece, one->edge, 0);
    }
    side->share = 1 - (sums[0] + sums[1]) / 2;
}

/* The stretch over the surface that a hand's pieces have alone at a share x of the side, and its derivative by x. */
static void hand_stretch(const taut_pattern_layout *layout, const taut_pattern_side *side, int hand,
                         double x, double stretch[2])
{
    const taut_pattern_holder *at = NULL;
    for (int k = 0; k < side->holder_count; k++) {
        const taut_pattern_holder *one = &side->holders[k];
        if (one->hand == hand && (at == NULL || x >= fmin(one->from, one->to))) {
            at = one;
        }
    }
    const double range = at->to - at->from;
    own_speed(&layout->pieces[at->piece], at->edge, (x - at->from) / range, stretch);
    stretch[0] /= fabs(range);
    stretch[1] /= fabs(range) * range;
}

/* P_0 .. P_5 and their derivatives, over [0, 1]. */
static void legendre(double x, double p[2][TAUT_SIDE_MEAN])
{
    const double z = 2 * x - 1;
    p[0][0] = 1;
    p[1][0] = 0;
    p[0][1] = z;
    p[1][1] = 2;
    for (int k = 1; k + 1 < TAUT_SIDE_MEAN; k++) {
        p[0][k + 1] = ((2 * k + 1) * z * p[0][k] - k * p[0][k - 1]) / (k + 1);
        p[1][k + 1] = p[1][k - 1] + 2 * (2 * k + 1) * p[0][k];
    }
}

/* Where pieces meet on a side the mean of both hands jumps: the polynomial that is nearest to it. */
static void set_mean(const taut_pattern_layout *layout, taut_pattern_side *side)
{
    double nodes[EDGE_NODES], weights[EDGE_NODES];
    taut_gauss_rule(EDGE_NODES, nodes, weights);
    memset(side->mean, 0, sizeof side->mean);
    for (int h = 0; h < side->holder_count; h++) {
        const taut_pattern_holder *one = &side->holders[h];
        for (int i = 0; i < EDGE_NODES; i++) {
            const double x = one->from + (one->to - one->from) * (1 + nodes[i]) / 2;
            double p[2][TAUT_SIDE_MEAN], stretch[2];
            legendre(x, p);
            hand_stretch(layout, side, one->hand, x, stretch);
            for (int k = 0; k < TAUT_SIDE_MEAN; k++) { /* half of each hand */
                side->mean[k] +=
                    (2 * k + 1) * weights[i] / 4 * fabs(one->to - one->from) * stretch[0] * p[0][k];
            }
        }
    }
}

double taut_pattern_own_stretch(const taut_pattern_layout *layout, const taut_pattern_side *side,
                                const taut_pattern_holder *holder, double x)
{
    const double range = holder->to - holder->from;
    double speed[2];
    own_speed(&layout->pieces[holder->piece], holder->edge, (x - holder->from) / range, speed);
    return speed[0] / (fabs(range) * side->length);
}

int taut_pattern_is_held(const taut_pattern_cut *cut, const taut_pattern_piece *piece, int edge)
{
    const taut_pattern_bound *bound = &piece->bounds[edge];
    return !taut_pattern_is_sewn(piece, edge) && !bound->is_point &&
           (cut->held.edges[edge] || (bound->border >= 0 && cut->held.borders[bound->border]));
}

/* What the second pass holds. */
static void set_seams(taut_pattern_layout *layout, const taut_pattern_cut *cut)
{
    for (int k = 0; k < layout->side_count; k++) {
        taut_pattern_side *side = &layout->sides[k];
        if (side->is_seam) {
            set_share(layout, cut, side);
        }
        if (side->is_seam && side->is_jointed) {
            set_mean(layout, side);
        }
    }
    for (int k = 0; k < layout->piece_count * TAUT_FLAT_EDGES; k++) {
        taut_pattern_piece *piece = &layout->pieces[k / TAUT_FLAT_EDGES];
        const int e = k % TAUT_FLAT_EDGES;
        if (taut_pattern_is_held(cut, piece, e)) {
            piece->bounds[e].share = 1 - seam_compensation(layout, cut, k / TAUT_FLAT_EDGES, e, 1);
        }
    }
}

/* Is it the warp that is nearer to the direction of an edge across strips, or along them? */
static int is_warp(const taut_pattern_cut *cut, int is_across)
{
    const double along = fabs(taut_cos(cut->thread)), across = fabs(taut_sin(cut->thread));
    return is_across ? across > along : along >= across;
}

/* Where compensation fades out: what is left of that of an edge, and its derivative along a line of the window, w and w'. */
static void left_along(const taut_pattern_cut *cut, const taut_pattern_piece *piece, int edge,
                       const double w[2][2], double left[2])
{
    const int d = !is_warp(cut, edge == TAUT_FLAT_START || edge == TAUT_FLAT_END);
    double x[3][3], at[2], way[3], nearest[3], away[3];
    left[0] = 1;
    left[1] = 0;
    for (int k = 0; k < 2; k++) { /* rounding may leave the window */
        at[k] = fmin(fmax(w[0][k], piece->carrier->lo[k]), piece->carrier->hi[k]);
    }
    if (piece->fade_count > 0) {
        taut_surface_eval(piece->carrier->surface, at[0], at[1], 1, x[0]);
        for (int c = 0; c < 3; c++) {
            way[c] = x[1][c] * w[1][0] + x[2][c] * w[1][1];
        }
    }
    for (int k = 0; k < piece->fade_count; k++) {
        const taut_pattern_fade *fade = &piece->fades[k];
        const double far = taut_border_nearest(&fade->border, x[0], nearest),
                     z = far / fade->length;
        if (fade->is_faded[d] && z < 1) {
            taut_difference(x[0], nearest, away);
            const double grows = far > 0 ? taut_dot(away, way) / (far * fade->length) : 0;
            const double share = z * z * (3 - 2 * z);
            left[1] = left[1] * share + left[0] * 6 * z * (1 - z) * grows;
            left[0] *= share;
        }
    }
}

/* |y_x| over x, the share of the side, and its derivative. */
static void side_speed(const taut_pattern_layout *layout, const taut_pattern_cut *cut,
                       const taut_pattern_side *side, double x, double speed[2])
{
    double both[2][2], p[2][TAUT_SIDE_MEAN];
    if (cut->seam_length == TAUT_PATTERN_TRUE) {
        const taut_pattern_holder *one = &side->holders[0];
        double w[3][2], left[2];
        speed[0] = side->share * side->length;
        speed[1] = 0;
        if (layout->pieces[one->piece].fade_count == 0) {
            return;
        }
        taut_pattern_side_at(side, x, w);
        left_along(cut, &layout->pieces[one->piece], one->edge, (const double(*)[2])w, left);
        speed[0] = (1 - left[0] * (1 - side->share)) * side->length;
        speed[1] = -left[1] * (1 - side->share) * side->length;
        return;
    }
    if (side->is_jointed) {
        legendre(x, p);
        speed[0] = speed[1] = 0;
        for (int k = 0; k < TAUT_SIDE_MEAN; k++) {
            speed[0] += side->mean[k] * p[0][k];
            speed[1] += side->mean[k] * p[1][k];
        }
        return;
    }
    for (int hand = 0; hand < 2; hand++) {
        hand_stretch(layout, side, hand, x, both[hand]);
    }
    speed[0] = (both[0][0] + both[1][0]) / 2;
    speed[1] = (both[0][1] + both[1][1]) / 2;
}

int taut_pattern_held_speed(const taut_pattern_layout *layout, const taut_pattern_cut *cut,
                            int piece, int edge, double x, double speed[2])
{
    const taut_pattern_bound *bound = &layout->pieces[piece].bounds[edge];
    const double range = bound->to - bound->from;
    if (taut_pattern_is_held(cut, &layout->pieces[piece], edge)) {
        taut_pattern_bound_speed(&layout->pieces[piece], edge, x, speed);
        if (cut->compensation.has_seam && layout->pieces[piece].fade_count > 0) {
            const int is_across = edge == TAUT_FLAT_START || edge == TAUT_FLAT_END;
            const double fixed = edge == TAUT_FLAT_END || edge == TAUT_FLAT_LEFT;
            double w[6][2], left[2];
            taut_pattern_piece_window(&layout->pieces[piece], is_across ? fixed : x,
                                      is_across ? x : fixed, w);
            memcpy(w[1], w[1 + is_across], sizeof w[1]);
            left_along(cut, &layout->pieces[piece], edge, (const double(*)[2])w, left);
            const double share = 1 - left[0] * (1 - bound->share);
            speed[1] = share * speed[1] - left[1] * (1 - bound->share) * speed[0];
            speed[0] *= share;
            return 1;
        }
        speed[0] *= bound->share;
        speed[1] *= bound->share;
        return 1;
    }
    if (!taut_pattern_is_sewn(&layout->pieces[piece], edge)) {
        return 0;
    }
    side_speed(layout, cut, bound->line, bound->from + x * range, speed);
    speed[0] *= range;
    speed[1] *= range * range;
    return 1;
}

/* ---- the passes ---- */

typedef struct pass {
    taut_pattern_layout *layout;
    const taut_pattern_cut *cut;
    taut_flat_options options;
    taut_pulse *pulse;   /* of the first worker */
    taut_status *status; /* of each piece */
    taut_arena **arenas; /* of each piece: what it keeps */
    int *folded;
    double *energies; /* of each piece, its thread turned */
} pass;

static taut_flat_strip strip_of(const taut_pattern_across *across)
{
    return (taut_flat_strip){
        across->piece->log_scale != NULL ? taut_pattern_scaled_metric : taut_pattern_across_metric,
        across, across->piece->fade_count > 0 ? taut_pattern_across_shrink : NULL};
}

/* Areas and energies are those of the cloth: of the piece's own metric. */
static void measure(const taut_pattern_across *across, taut_flat *flat)
{
    const taut_flat_strip own = {taut_pattern_across_metric, across, NULL};
    if (across->piece->log_scale != NULL) {
        taut_flat_measure(&own, flat);
    }
}

/* What is asked of this piece. */
static taut_flat_options options_of(const pass *p, const taut_pattern_piece *piece, int worker)
{
    taut_flat_options own = p->options;
    own.pulse = worker == 0 ? p->pulse : NULL;
    memcpy(own.spans, piece->spans, sizeof own.spans);
    own.graded = piece->is_graded;
    own.is_point[0] = piece->bounds[TAUT_FLAT_START].is_point;
    own.is_point[1] = piece->bounds[TAUT_FLAT_END].is_point;
    return own;
}

/* A piece that took so many steps on some spans begins on twice as many where it ended, and so on. */
enum { MANY_STEPS = 16 };

static int is_begun(taut_pattern_piece *piece, int which, const taut_flat *coarse)
{
    piece->is_hard[which] |= coarse->steps >= MANY_STEPS;
    return piece->is_hard[which] && piece->log_scale == NULL &&
           piece->spans[0] == 2 * coarse->spans[0] && piece->spans[1] == 2 * coarse->spans[1];
}

/* From a coarser piece where it is one that is begun, else, or where nothing comes of it, from what it is else begun with. */
static taut_status flatten_from(taut_pattern_piece *piece, int which, const taut_flat_strip *strip,
                                const taut_flat_options *own, const taut_flat *other,
                                taut_arena *scratch, taut_flat *flat)
{
    const taut_flat *coarse = which == 0 ? &piece->alone : &piece->flat;
    if (is_begun(piece, which, coarse)) {
        taut_flat start;
        taut_status status = taut_flat_halve(scratch, coarse, &start);
        if (status == TAUT_OK) {
            status = taut_flatten(scratch, strip, own, &start, flat);
        }
        if (status != TAUT_NOT_CONVERGED) {
            return status;
        }
    }
    return taut_flatten(scratch, strip, own, other, flat);
}

static void alone(void *context, int worker, int64_t task)
{
    const pass *p = context;
    taut_pattern_piece *piece = &p->layout->pieces[task];
    taut_pattern_kept kept = {.s = NAN};
    const taut_pattern_across across = {piece, &kept};
    const taut_flat_options own = options_of(p, piece, worker);

    p->status[task] = TAUT_OK;
    if (piece->alone.points != NULL &&
        (piece->is_developable ||
         memcmp(piece->alone.spans, piece->spans, sizeof piece->spans) == 0)) {
        return; /* it was laid flat on these before its neighbours got finer ones */
    }
    taut_pattern_look_at_curvature(piece, own.pulse);
    piece->is_developable &= piece->fade_count == 0; /* cut smaller by parts it is strained */
    if (piece->is_developable) {
        p->status[task] = taut_pattern_develop(piece, &own, p->arenas[task]);
        if (p->status[task] == TAUT_OK && piece->is_developable) {
            p->status[task] = all_edges(&piece->alone, p->arenas[task], piece->alone_edges);
        }
        if (p->status[task] != TAUT_OK || piece->is_developable) {
            return;
        }
    }
    taut_arena *scratch = taut_arena_new();
    taut_flat flat = {.steps = 0};
    taut_status status = scratch != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    if (status == TAUT_OK && p->cut->is_conformal) {
        status = taut_pattern_find_scale(piece, own.pulse, p->arenas[task]);
    }
    if (status == TAUT_OK) {
        const taut_flat_strip strip = strip_of(&across);
        status = flatten_from(piece, 0, &strip, &own, NULL, scratch, &flat);
    }
    if (status == TAUT_OK) {
        measure(&across, &flat);
        status = taut_flat_copy(p->arenas[task], &flat, &piece->alone);
    }
    if (status == TAUT_OK) {
        status = all_edges(&piece->alone, p->arenas[task], piece->alone_edges);
    }
    p->folded[task] = status == TAUT_NOT_CONVERGED && isinf(flat.energy);
    p->status[task] = status;
    taut_arena_free(scratch);
}

/* |y_x| over |X_x| at the Gauss points of the spans; *is_natural: the piece has it already. */
static int hold(const pass *p, int index, int edge, int spans, double *stretch, int *is_natural)
{
    double nodes[TAUT_FLAT_GAUSS], weights[TAUT_FLAT_GAUSS];
    const taut_pattern_piece *piece = &p->layout->pieces[index];
    const int is_across = edge == TAUT_FLAT_START || edge == TAUT_FLAT_END;
    const double fixed = edge == TAUT_FLAT_END || edge == TAUT_FLAT_LEFT;
    taut_gauss_rule(TAUT_FLAT_GAUSS, nodes, weights);
    for (int k = 0; k < spans * TAUT_FLAT_GAUSS; k++) {
        const double x = taut_flat_place(spans, piece->is_graded, k / TAUT_FLAT_GAUSS,
                                         nodes[k % TAUT_FLAT_GAUSS]);
        double g[3], speed[2], own[2];
        if (!taut_pattern_held_speed(p->layout, p->cut, index, edge, x, speed)) {
            return 0;
        }
        taut_pattern_piece_metric(piece, is_across ? fixed : x, is_across ? x : fixed, g);
        own_speed(piece, edge, x, own);
        stretch[k] = speed[0] / sqrt(g[is_across ? 2 : 0]);
        *is_natural &= fabs(own[0] - speed[0]) <= same_stretch * own[0];
    }
    return 1;
}

static taut_status hold_piece(const pass *p, int index, int worker, taut_arena *scratch,
                              taut_flat *flat)
{
    taut_pattern_piece *piece = &p->layout->pieces[index];
    taut_pattern_kept kept = {.s = NAN};
    const taut_pattern_across across = {piece, &kept};
    const taut_flat_strip strip = strip_of(&across);
    taut_flat_options own = options_of(p, piece, worker);
    int is_natural = 1, is_same = !p->cut->is_straight;

    /* not of pieces alone: corners that are forced would say how seams stretch */
    own.straight = p->cut->is_straight;

    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        const int spans = own.spans[e == TAUT_FLAT_START || e == TAUT_FLAT_END];
        double *stretch = taut_arena_take(scratch, (size_t)spans * TAUT_FLAT_GAUSS, sizeof(double));
        if (stretch == NULL) {
            return TAUT_NO_MEMORY;
        }
        if (hold(p, index, e, spans, stretch, &is_natural)) {
            own.held[e] = stretch;
            is_same = 0;
        }
    }
    if (is_same || (piece->is_developable && is_natural && !own.straight)) {
        *flat = piece->alone;
        return TAUT_OK;
    }
    const taut_status status =
        flatten_from(piece, 1, &strip, &own,
                     piece->is_developable || own.straight ? NULL : &piece->alone, scratch, flat);
    if (status == TAUT_OK) {
        measure(&across, flat);
    }
    return status;
}

static void together(void *context, int worker, int64_t task)
{
    const pass *p = context;
    taut_pattern_piece *piece = &p->layout->pieces[task];
    taut_arena *scratch = taut_arena_new();
    taut_flat flat = {.steps = 0};
    taut_status status =
        scratch != NULL ? hold_piece(p, (int)task, worker, scratch, &flat) : TAUT_NO_MEMORY;
    if (status == TAUT_OK) {
        status = taut_flat_copy(p->arenas[task], &flat, &piece->flat);
    }
    if (status == TAUT_OK) {
        status = all_edges(&piece->flat, p->arenas[task], piece->edges);
        piece->strains = taut_pattern_strains_of(piece, options_of(p, piece, worker).pulse);
    }
    p->status[task] = status;
    taut_arena_free(scratch);
}

/* A piece that was not laid flat: more strips help, unless a place within one of the finest spans turns by itself as a whole piece may. */
static taut_status fail_piece(const taut_pattern_piece *piece, int is_folded, taut_error *error)
{
    const char *reason = is_folded ? "folds" : "not-converged";
    const char *format = is_folded ? "no flat piece %s without folds was found to begin with: %s"
                                   : "the flattening of piece %s did not settle: %s";
    char remedy[160] = "take more strips";
    double at[2], w[6][2], area = 0, g[3];
    const double most = taut_pattern_largest_curvature(piece, at);
    const double gauss = ldexp(most, -2 * piece->carrier->scale);
    for (int k = 0; k < EDGE_NODES * EDGE_NODES; k++) {
        taut_pattern_piece_metric(piece, (k / EDGE_NODES + 0.5) / EDGE_NODES,
                                  (k % EDGE_NODES + 0.5) / EDGE_NODES, g);
        area += sqrt(fmax(g[0] * g[2] - g[1] * g[1], 0)) / (EDGE_NODES * EDGE_NODES);
    }
    const int is_sharp = fabs(most) * area > FINEST_CELLS;
    if (is_sharp) {
        taut_pattern_piece_window(piece, at[0], at[1], w);
        snprintf(remedy, sizeof remedy,
                 "K is %.3g at (u, v) = (%.5g, %.5g), which no splines follow; leave that place "
                 "out of the surface, as more strips do not help",
                 gauss, w[0][0], w[0][1]);
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, reason, "/seams", is_sharp ? gauss : taut_none,
                     taut_none, format, piece->name, remedy);
}

/* What went wrong with the first piece that went wrong. */
static taut_status outcome(const pass *p, taut_error *error)
{
    for (int k = 0; k < p->layout->piece_count; k++) {
        if (p->status[k] == TAUT_NO_MEMORY) {
            return taut_fail_memory(error);
        }
        if (p->status[k] != TAUT_OK) {
            return fail_piece(&p->layout->pieces[k], p->folded[k], error);
        }
    }
    return TAUT_OK;
}

static void release(void *arena)
{
    taut_arena_free(arena);
}

static taut_status run(pass *p, const taut_crew *crew, taut_task *task, taut_error *error)
{
    const int64_t count = p->layout->piece_count;
    if (taut_crew_run(crew, taut_crew_workers(crew, count), count, work_of_piece, task, p)) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    return outcome(p, error);
}

/* The flat length that an edge is held at, over the range of its parameter; 0 where it is free. */
static double held_length(const taut_pattern_layout *layout, const taut_pattern_cut *cut, int piece,
                          int edge)
{
    double nodes[TAUT_FLAT_GAUSS], weights[TAUT_FLAT_GAUSS], sum = 0;
    taut_gauss_rule(TAUT_FLAT_GAUSS, nodes, weights);
    for (int k = 0; k < ALONG * TAUT_FLAT_GAUSS; k++) {
        const int at = k % TAUT_FLAT_GAUSS;
        const double x = (k / TAUT_FLAT_GAUSS + 0.5 + 0.5 * nodes[at]) / ALONG;
        double speed[2];
        if (!taut_pattern_held_speed(layout, cut, piece, edge, x, speed)) {
            return 0;
        }
        sum += weights[at] / (2 * ALONG) * speed[0];
    }
    return sum;
}

/* Between straight ends that are parallel the longer one of two sides has to wave: sides that are held have one length. */
static taut_status check_ends(const taut_pattern_layout *layout, const taut_pattern_cut *cut,
                              taut_error *error)
{
    for (int k = 0; cut->is_straight && k < layout->piece_count; k++) {
        const taut_pattern_piece *piece = &layout->pieces[k];
        const double right = held_length(layout, cut, k, TAUT_FLAT_RIGHT),
                     left = held_length(layout, cut, k, TAUT_FLAT_LEFT);
        if (piece->bounds[TAUT_FLAT_START].is_point || piece->bounds[TAUT_FLAT_END].is_point) {
            return taut_fail(error, TAUT_NO_SOLUTION, "ends", "/ends", taut_none, taut_none,
                             "an end of piece %s is one place, and cannot be straight: leave ends "
                             "free",
                             piece->name);
        }
        if (right > 0 && left > 0 && fabs(right - left) > same_sides * fmax(right, left)) {
            const double unit = ldexp(1, layout->carrier->scale);
            return taut_fail(error, TAUT_NO_SOLUTION, "ends", "/ends", fmax(right, left) * unit,
                             fmin(right, left) * unit,
                             "the sides of piece %s are to be %.6g and %.6g long: between straight "
                             "ends both have one length; leave ends free",
                             piece->name, right * unit, left * unit);
        }
    }
    return TAUT_OK;
}

/* ---- where compensation fades out ---- */

/* Does an edge of the window run across strips, that is, do they start or end on it? */
static int runs_across(const taut_pattern_layout *layout, int ground, int border)
{
    int any = 0;
    for (int k = 0; k < layout->piece_count; k++) {
        const taut_pattern_bound *bounds = layout->pieces[k].bounds;
        any |= layout->pieces[k].ground == ground &&
               (bounds[TAUT_FLAT_START].border == border || bounds[TAUT_FLAT_END].border == border);
    }
    return any;
}

/* The share of warp, or of weft, that fades out near an edge across strips or along them. */
static void choose_component(const taut_pattern_cut *cut, taut_pattern_component component,
                             int is_across, int is_faded[2])
{
    is_faded[0] = component == TAUT_PATTERN_COMPONENT_BOTH || is_warp(cut, is_across);
    is_faded[1] = component == TAUT_PATTERN_COMPONENT_BOTH || !is_warp(cut, is_across);
}

static taut_status set_shares(taut_pattern_layout *layout, const taut_pattern_cut *cut)
{
    const size_t count = (size_t)cut->decompensate_count;
    taut_pattern_fade *all =
        taut_arena_take(layout->arena, count * (size_t)layout->ground_count + 1, sizeof *all);
    if (all == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int g = 0; g < layout->ground_count; g++) {
        taut_pattern_fade *fades = all + (size_t)g * count;
        for (int k = 0; k < cut->decompensate_count; k++) {
            const taut_pattern_decompensate *asked = &cut->decompensate[k];
            const int edge = (int)asked->edge;
            if (taut_border_new(layout->arena, layout->grounds[g].carrier->surface, edge,
                                &fades[k].border) != TAUT_OK) {
                return TAUT_NO_MEMORY;
            }
            fades[k].length = asked->length;
            choose_component(cut, asked->component, runs_across(layout, g, edge),
                             fades[k].is_faded);
        }
        for (int k = 0; k < layout->piece_count; k++) {
            taut_pattern_piece *piece = &layout->pieces[k];
            if (piece->ground == g) {
                piece->shares[0] = cut->compensation.warp;
                piece->shares[1] = cut->compensation.weft;
                piece->fade_count = cut->decompensate_count;
                piece->fades = fades;
            }
        }
    }
    return TAUT_OK;
}

static taut_flat_options options_for(const taut_pattern_cut *cut)
{
    return (taut_flat_options){.law = cut->has_law ? &cut->law : NULL,
                               .warp = cut->compensation.warp,
                               .weft = cut->compensation.weft,
                               .thread = cut->thread};
}

taut_status taut_pattern_flatten(taut_pattern_layout *layout, const taut_pattern_cut *cut,
                                 const taut_crew *crew, taut_error *error)
{
    const size_t count = (size_t)layout->piece_count;
    pass p = {.layout = layout,
              .cut = cut,
              .options = options_for(cut),
              .pulse = crew->pulse,
              .status = taut_arena_take(layout->arena, count, sizeof *p.status),
              .arenas = taut_arena_take(layout->arena, count, sizeof *p.arenas),
              .folded = taut_arena_take(layout->arena, count, sizeof *p.folded)};

    if (taut_arena_status(layout->arena) != TAUT_OK || set_shares(layout, cut) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (size_t k = 0; k < count; k++) {
        if (layout->pieces[k].spans[0] == 0) {
            layout->pieces[k].spans[0] = ALONG;
            layout->pieces[k].spans[1] = ACROSS;
            layout->pieces[k].is_graded = cut->tolerance > 0 && !cut->is_conformal;
        }
        p.arenas[k] = taut_arena_new();
        if (p.arenas[k] == NULL || !taut_arena_keep(layout->arena, p.arenas[k], release)) {
            return taut_fail_memory(error);
        }
    }
    taut_status status = run(&p, crew, alone, error);
    if (status != TAUT_OK) {
        return status;
    }
    set_seams(layout, cut);
    status = check_ends(layout, cut, error);
    return status == TAUT_OK ? run(&p, crew, together, error) : status;
}

/* ---- the bias ---- */

static void turned(void *context, int worker, int64_t task)
{
    const pass *p = context;
    const taut_pattern_piece *piece = &p->layout->pieces[task];
    taut_pattern_kept kept = {.s = NAN};
    const taut_pattern_across across = {piece, &kept};
    const taut_flat_strip strip = strip_of(&across);
    const taut_flat_options own = options_of(p, piece, worker);
    taut_arena *scratch = taut_arena_new();
    taut_flat flat = {.steps = 0};

    p->energies[task] = piece->alone.energy;
    p->status[task] = TAUT_OK;
    if (!piece->is_developable) {
        p->status[task] =
            scratch != NULL ? taut_flatten(scratch, &strip, &own, NULL, &flat) : TAUT_NO_MEMORY;
        p->energies[task] = p->status[task] == TAUT_OK ? flat.energy : (double)NAN;
    }
    taut_arena_free(scratch);
}

/* Is it the same in all directions? */
static int is_isotropic(const taut_flat_law *law)
{
    static const double same = 1e-9;
    return fabs(law->d11 - law->d22) <= same * law->d11 &&
           fabs(law->d11 - law->d12 - 2 * law->d33) <= same * law->d11;
}

taut_status taut_pattern_bias(const taut_pattern_layout *layout, const taut_pattern_cut *cut,
                              const taut_crew *crew, double *bias, taut_error *error)
{
    const size_t count = (size_t)layout->piece_count;
    taut_pattern_layout own = *layout;
    pass p = {.layout = &own,
              .cut = cut,
              .options = options_for(cut),
              .pulse = crew->pulse,
              .status = taut_arena_take(layout->arena, count, sizeof *p.status),
              .energies = taut_arena_take(layout->arena, count, sizeof *p.energies)};
    double sums[2] = {0, 0};
    int is_strained = 0;

    *bias = (double)NAN;
    if (taut_arena_status(layout->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (size_t k = 0; k < count; k++) {
        is_strained |= !layout->pieces[k].is_developable;
    }
    if (!cut->has_law || is_isotropic(&cut->law) || !is_strained) {
        return TAUT_OK;
    }
    /* no matter which way: a law along warp and weft is the same of their mirror images */
    p.options.thread += p.options.thread > 0 ? -TAUT_PI / 4 : TAUT_PI / 4;
    if (taut_crew_run(crew, taut_crew_workers(crew, layout->piece_count), layout->piece_count,
                      work_of_piece, turned, &p)) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    for (size_t k = 0; k < count; k++) {
        if (p.status[k] == TAUT_NO_MEMORY) {
            return taut_fail_memory(error);
        }
        sums[0] += layout->pieces[k].alone.energy;
        sums[1] += p.energies[k];
    }
    *bias = sums[0] > 0 ? sums[1] / sums[0] : (double)NAN;
    return TAUT_OK;
}
