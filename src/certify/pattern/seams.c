/* seams.c
 *
 *   cover       pieces tile the window: along each side, to its left and to its right, parts of edges follow on each other from end to end;
 *               along borders on the window's side alone, and all four borders are covered; edges of a piece meet at its corners, and go
 *               around it one way (exact, corners to rounding). With the document, seams told as lines that it does not ask for
 *   on-surface  largest distance of S(t) from X(w(t)) over the size, PLACES in each span (check)
 *   geodesic    int |k_g| ds by the seam's own second derivative (check)
 *   edges       largest distance of the line that is sewn from the flat piece's own edge, and of the line that is cut from it where no
 *               cloth is left anywhere, over the size (check)
 *   seams       lengths of the two flat edges from their beginning to equal places of the surface, their largest difference over
 *               the length (check)
 *   lengths     of seams whose length is to be that of the surface: what they are longer by, over it (check)
 */
#include "certify/pattern/seams.h"

#include "certify/pattern/lengths.h"
#include "certify/pattern/worst.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "taut/measure.h"

#include <string.h>

enum { PLACES = 8, NODES = 16, STEPS = 1024 };
/* Corners, evaluated along both edges that meet there, over the window. */
static const double same_corner = 1e-13;
static const double geodesic_limit = 1e-6, seam_limit = 1e-9, edge_limit = 1e-6, end_limit = 1e-9;
/* Where pieces meet on either hand of a seam, the same place but for rounding, over its length. */
static const double same_place = 1e-12;
/* Of a side for the pulse: operations, roughly. */
static const double work_of_side = 2e7;

/* ---- cover ---- */

/* Which border of the window a place is on exactly, from 0: u0, u1, v0, v1; -1: none. */
static int is_on(const taut_surface *on, const double *at, int border)
{
    const taut_basis *basis = border < 2 ? taut_surface_u(on) : taut_surface_v(on);
    return at[border / 2] == (border % 2 == 0 ? taut_basis_lo(basis) : taut_basis_hi(basis));
}

static const double *end_of(const taut_cloth_side *side, int end)
{
    const int count = taut_basis_count(taut_curve_t(side->window));
    return taut_curve_points(side->window) + (end == 0 ? 0 : 3 * (count - 1));
}

/* All of a side on one border, exactly: its control points are. */
static int lies_on(const taut_cloth_side *side, int border)
{
    const int count = taut_basis_count(taut_curve_t(side->window));
    int all = 1;
    for (int k = 0; k < count; k++) {
        all &= is_on(side->on, taut_curve_points(side->window) + 3 * k, border);
    }
    return all;
}

static void count_wrong(taut_worst *w, int is_wrong, const char *name, double at)
{
    if (is_wrong) {
        if (w->residual == 0) {
            snprintf(w->where, sizeof w->where, "%.40s at %.6g", name, at);
        }
        w->residual += 1;
    }
}

/* Of a line, from one share to another one. */
typedef struct stretch {
    double from, to;
} stretch;

enum { PIECES = TAUT_PATTERN_PIECES_MAX };

/* How often stretches do not follow on each other from 0 to 1. */
static int gaps(stretch *list, int count, double from, double to)
{
    int wrong = 0;
    for (int i = 0; i < count; i++) { /* the next one each time */
        int next = -1;
        for (int k = i; k < count; k++) {
            next = list[k].from == from ? k : next;
        }
        if (next < 0) {
            return wrong + 1;
        }
        const stretch found = list[next];
        list[next] = list[i];
        list[i] = found;
        from = found.to;
    }
    return wrong + (from != to);
}

/* Along a side and its twin: the parts to its left (0) or right (1). */
static int parts_along(const taut_cloth *cloth, const taut_cloth_side *side, int hand,
                       stretch list[PIECES])
{
    int count = 0;
    for (int k = 0; k < cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k];
        for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
            const taut_cloth_side *own =
                piece->sides[e] >= 0 ? &cloth->sides[piece->sides[e]] : NULL;
            const int is_there =
                own == side || (own != NULL && own->on == side->on && side->seam != NULL &&
                                own->seam != NULL && strcmp(own->seam, side->seam) == 0);
            if (is_there && taut_cloth_hand(e) == hand && count < PIECES) {
                list[count++] = (stretch){piece->part[e][0], piece->part[e][1]};
            }
        }
    }
    return count;
}

/* Each part once to the left and once to the right of a seam; of a border once, on the side of the window. */
static void look_along(const taut_cloth *cloth, int index, taut_worst *w)
{
    const taut_cloth_side *side = &cloth->sides[index];
    stretch list[PIECES];
    int counts[2];
    for (int hand = 0; hand < 2; hand++) {
        counts[hand] = parts_along(cloth, side, hand, list);
        if ((side->seam != NULL && side->mate < 0) || counts[hand] > 0) {
            count_wrong(w, counts[hand] == 0 || gaps(list, counts[hand], 0, 1) > 0, side->name, 0);
        }
    }
    if (side->seam == NULL || side->mate >= 0) {
        count_wrong(w, (counts[0] > 0) == (counts[1] > 0), side->name, 0);
    }
}

/* The borders of the window go around it: u of v0 grows, v of u1, .. */
static int is_forward(int border, const double a[2], const double b[2])
{
    const int along = 1 - border / 2;
    return border == 1 || border == 2 ? a[along] < b[along] : a[along] > b[along];
}

/* The corners of a piece: right and left at s = 0 and 1. */
static void corners_of(const taut_cloth *cloth, const taut_cloth_piece *piece, double at[2][2][2])
{
    for (int k = 0; k < 2; k++) {
        const int e = k == 0 ? TAUT_CLOTH_RIGHT : TAUT_CLOTH_LEFT;
        for (int end = 0; end < 2; end++) {
            taut_cloth_side_at(&cloth->sides[piece->sides[e]], piece->part[e][end], at[k][end]);
        }
    }
}

/* Two places of the window that are one. */
static int is_one(const taut_surface *on, const double a[2], const double b[2])
{
    const taut_basis *bases[2] = {taut_surface_u(on), taut_surface_v(on)};
    int all = 1;
    for (int d = 0; d < 2; d++) {
        const double range = taut_basis_hi(bases[d]) - taut_basis_lo(bases[d]);
        all &= fabs(a[d] - b[d]) <= same_corner * range;
    }
    return all;
}

/* Start and end meet right and left; where they are straight they are told to be on a border, and run around the window. */
static void look_at_ends(const taut_cloth *cloth, const taut_cloth_piece *piece, taut_worst *w)
{
    double at[2][2][2], ends[2][2];
    corners_of(cloth, piece, at);
    for (int end = 0; end < 2; end++) {
        const int e = end == 0 ? TAUT_CLOTH_START : TAUT_CLOTH_END;
        const double *right = at[0][end], *left = at[1][end];
        if (piece->sides[e] >= 0) {
            for (int k = 0; k < 2; k++) {
                taut_cloth_side_at(&cloth->sides[piece->sides[e]], piece->part[e][k], ends[k]);
            }
            count_wrong(w, !is_one(piece->on, right, ends[0]) || !is_one(piece->on, left, ends[1]),
                        piece->name, end);
            continue;
        }
        const int border = piece->border[e];
        count_wrong(
            w, border < 0 || !is_on(piece->on, right, border) || !is_on(piece->on, left, border),
            piece->name, end);
        const int is_none = piece->is_point[e] && right[0] == left[0] && right[1] == left[1];
        const int is_fine =
            is_none || (border >= 0 && (end == 0 ? is_forward(border, left, right)
                                                 : is_forward(border, right, left)));
        count_wrong(w, !is_fine, piece->name, end);
    }
}

/* A border is covered once: by a side all along it, or by straight ends of pieces. */
static void look_at_border(const taut_cloth *cloth, const taut_surface *on, int border,
                           taut_worst *w)
{
    static const char *const names[] = {"u0", "u1", "v0", "v1"};
    const int along = 1 - border / 2;
    const taut_basis *basis = along == 0 ? taut_surface_u(on) : taut_surface_v(on);
    const double range[2] = {taut_basis_lo(basis), taut_basis_hi(basis)};
    stretch list[PIECES];
    int times = 0, count = 0;
    for (int k = 0; k < cloth->side_count; k++) {
        const taut_cloth_side *side = &cloth->sides[k];
        const double *a = end_of(side, 0), *b = end_of(side, 1);
        if (side->on != on || !lies_on(side, border)) {
            continue;
        }
        const double low = fmin(a[along], b[along]), high = fmax(a[along], b[along]);
        /* of a ring's, the window lies to one hand, and its twin's to the other */
        const int hand = !is_forward(border, a, b);
        int on_hand = 0;
        for (int p = 0; p < cloth->piece_count; p++) {
            for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
                on_hand += cloth->pieces[p].sides[e] == k;
                count_wrong(w, cloth->pieces[p].sides[e] == k && taut_cloth_hand(e) != hand,
                            side->name, 0);
            }
        }
        times += on_hand > 0 && low == range[0] && high == range[1];
    }
    for (int k = 0; k < cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k];
        double at[2][2][2];
        corners_of(cloth, piece, at);
        for (int end = 0; end < 2; end++) {
            const int e = end == 0 ? TAUT_CLOTH_START : TAUT_CLOTH_END;
            if (piece->on == on && piece->sides[e] < 0 && piece->border[e] == border &&
                count < PIECES && at[0][end][along] != at[1][end][along]) {
                list[count++] = (stretch){fmin(at[0][end][along], at[1][end][along]),
                                          fmax(at[0][end][along], at[1][end][along])};
            }
        }
    }
    count_wrong(w, times > 0 ? times > 1 || count > 0 : gaps(list, count, range[0], range[1]) > 0,
                names[border], 0);
}

/* One parameter is the same all along. */
static int is_held(const taut_cloth_side *side, int d)
{
    const double *points = taut_curve_points(side->window);
    int all = 1;
    for (int k = 1; k < taut_basis_count(taut_curve_t(side->window)); k++) {
        all &= points[3 * k + d] == points[d];
    }
    return all;
}

/* A border of the window that is one place. */
static int is_pole(const taut_cloth *cloth, const taut_surface *on, int border)
{
    for (int k = 0; k < cloth->piece_count; k++) {
        for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
            if (cloth->pieces[k].on == on && cloth->pieces[k].is_point[e] &&
                cloth->pieces[k].border[e] == border) {
                return 1;
            }
        }
    }
    return 0;
}

/* A seam told as a parameter line is where a ring closes, or one that is asked for, all along. */
static int is_asked_line(const taut_cloth *cloth, const taut_cloth_side *side)
{
    const double *at = end_of(side, 0);
    for (int b = 0; b < 4; b++) {
        if (lies_on(side, b)) {
            return 1;
        }
    }
    for (int k = 0; k < cloth->problem->rule_count; k++) {
        const taut_pattern_rule *rule = &cloth->problem->rules[k];
        const int is_strips =
            rule->kind == TAUT_PATTERN_ACROSS || rule->kind == TAUT_PATTERN_RADIAL;
        for (int e = 0; is_strips && e < 2; e++) { /* from a pole they run along parameter lines */
            const int across = 1 - (int)rule->edges[0] / 2;
            if (is_pole(cloth, side->on, (int)rule->edges[e]) && is_held(side, across)) {
                return 1;
            }
        }
        for (int i = 0; rule->kind == TAUT_PATTERN_LINE && i < rule->value_count; i++) {
            if (at[rule->held] == rule->values[i] && is_held(side, rule->held)) {
                return 1;
            }
        }
    }
    return 0;
}

/* Seams that are not told to be geodesics were asked for as something else. */
static void look_at_kinds(const taut_cloth *cloth, taut_worst *w)
{
    int curves = 0, circles = 0;
    for (int k = 0; k < cloth->problem->rule_count; k++) {
        curves += cloth->problem->rules[k].kind == TAUT_PATTERN_CURVE;
        circles += cloth->problem->rules[k].trim > 0 ? cloth->surface_count : 0;
    }
    for (int k = 0; k < cloth->side_count; k++) {
        const taut_cloth_side *side = &cloth->sides[k];
        if (side->seam == NULL || strcmp(side->kind, "geodesic") == 0) {
            continue;
        }
        const int is_line = strcmp(side->kind, "line") == 0,
                  is_circle = strcmp(side->kind, "circle") == 0;
        curves -= !is_line && !is_circle;
        circles -= is_circle;
        count_wrong(w,
                    is_line     ? !is_asked_line(cloth, side)
                    : is_circle ? circles < 0
                                : curves < 0,
                    side->name, 0);
    }
}

static taut_status add_cover(const taut_cloth *cloth, taut_certificate *certificate)
{
    taut_worst w = {cloth->missing, ""};

    snprintf(w.where, sizeof w.where, "%.80s", cloth->where);
    for (int k = 0; k < cloth->side_count; k++) {
        look_along(cloth, k, &w);
    }
    for (int k = 0; k < cloth->piece_count; k++) {
        look_at_ends(cloth, &cloth->pieces[k], &w);
    }
    for (int border = 0; border < 4 * cloth->surface_count; border++) {
        look_at_border(cloth, cloth->surfaces[border / 4], border % 4, &w);
    }
    if (cloth->problem != NULL) {
        look_at_kinds(cloth, &w);
    }
    return taut_worst_add(&w, "cover", TAUT_EXACT, 0, certificate);
}

/* ---- on the surface ---- */

/* A place of a seam: the distance from the surface there, and k_g. 0 where it leaves the window. */
static int look_at(const taut_cloth *cloth, const taut_cloth_side *side, double t, double *away,
                   double *bend, double *speed)
{
    const taut_basis *bases[2] = {taut_surface_u(side->on), taut_surface_v(side->on)};
    double c[3][3], at[2], on[3][3], sideways[3], apart[3];
    taut_forms forms;

    const taut_basis *basis = taut_curve_t(side->space);
    const double lo_t = taut_basis_lo(basis), range = taut_basis_hi(basis) - lo_t;
    taut_cloth_line(cloth, side->space, t, 2, c);
    const double share = (t - lo_t) / range;
    taut_cloth_side_at(side, side->is_turned ? 1 - share : share, at);
    for (int d = 0; d < 2; d++) {
        const double lo = taut_basis_lo(bases[d]), hi = taut_basis_hi(bases[d]);
        const double room = 1e-9 * (hi - lo);
        if (!(at[d] >= lo - room) || !(at[d] <= hi + room)) {
            return 0;
        }
        at[d] = fmin(fmax(at[d], lo), hi);
    }
    if (taut_surface_eval(side->on, at[0], at[1], 1, on[0]) != TAUT_OK ||
        taut_surface_forms_points(side->on, 1, &at[0], &at[1], 1, &forms) != TAUT_OK) {
        return 0;
    }
    taut_difference(c[0], on[0], apart);
    *away = taut_norm(apart) / cloth->size;
    *speed = taut_norm(c[1]);
    taut_cross(forms.normal, c[1], sideways);
    *bend = taut_dot(c[2], sideways) / (*speed * *speed * *speed);
    return 1;
}

/* What is found of each side. */
typedef struct sides {
    const taut_cloth *cloth;
    taut_worst *distance;
    double *turn;
} sides;

static void look_along_side(void *context, int worker, int64_t task)
{
    const sides *all = context;
    const taut_cloth_side *side = &all->cloth->sides[task];
    const taut_basis *basis = side->space != NULL ? taut_curve_t(side->space) : NULL;
    double nodes[NODES], weights[NODES], sum = 0, away = 0, bend = 0, speed = 0;
    (void)worker;

    taut_gauss_rule(NODES, nodes, weights);
    all->distance[task] = (taut_worst){0, ""};
    for (int i = 0; basis != NULL && i < taut_basis_span_count(basis); i++) {
        const double a = taut_basis_breaks(basis)[i], b = taut_basis_breaks(basis)[i + 1];
        for (int q = 0; q < PLACES; q++) {
            const double t = a + (b - a) * (q + 0.5) / PLACES;
            const int is_there = look_at(all->cloth, side, t, &away, &bend, &speed);
            taut_worst_take(&all->distance[task], is_there ? away : INFINITY, side->name, t);
        }
        for (int q = 0; q < NODES; q++) {
            const double t = (a + b) / 2 + (b - a) / 2 * nodes[q];
            sum += look_at(all->cloth, side, t, &away, &bend, &speed)
                       ? weights[q] * (b - a) / 2 * fabs(bend) * speed
                       : INFINITY;
        }
    }
    all->turn[task] = sum;
}

static taut_status add_on_surface(const taut_cloth *cloth, taut_arena *arena,
                                  taut_certificate *certificate)
{
    const size_t count = (size_t)cloth->side_count;
    const int workers = taut_crew_workers(cloth->crew, (int64_t)count);
    sides all = {cloth, taut_arena_take(arena, count + 1, sizeof *all.distance),
                 taut_arena_take(arena, count + 1, sizeof *all.turn)};
    taut_worst distance = {0, ""}, turn = {0, ""};
    int any = 0, geodesics = 0;

    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    if (taut_crew_run(cloth->crew, workers, (int64_t)count, work_of_side, look_along_side, &all)) {
        return TAUT_INTERRUPTED;
    }
    for (size_t k = 0; k < count; k++) {
        const taut_cloth_side *side = &cloth->sides[k];
        if (side->space == NULL) {
            continue;
        }
        any = 1;
        taut_worst_join(&distance, &all.distance[k]);
        if (strcmp(side->kind, "geodesic") == 0) {
            geodesics++;
            taut_worst_take(&turn, all.turn[k], side->name,
                            taut_basis_lo(taut_curve_t(side->space)));
        }
    }
    if (!any) {
        return TAUT_OK;
    }
    const taut_status status =
        taut_worst_add(&distance, "on-surface", TAUT_CHECK, cloth->tolerance, certificate);
    return status == TAUT_OK && geodesics > 0
               ? taut_worst_add(&turn, "geodesic", TAUT_CHECK, geodesic_limit, certificate)
               : status;
}

/* ---- flat lengths ---- */

/* An edge that is sewn. */
typedef struct sewn {
    int piece, edge;
} sewn;

/* Two pieces on the two hands of a seam: the flat lengths of both from the beginning of what they share of it on. */
static void compare(const taut_cloth *cloth, const char *name, const sewn both[2], taut_worst *w)
{
    const taut_cloth_piece *pieces[2] = {&cloth->pieces[both[0].piece],
                                         &cloth->pieces[both[1].piece]};
    double parts[2][2];
    for (int k = 0; k < 2; k++) { /* as the seam runs: from > to against it */
        const double *part = pieces[k]->part[both[k].edge];
        const int is_turned = cloth->sides[pieces[k]->sides[both[k].edge]].is_turned;
        parts[k][0] = is_turned ? 1 - part[0] : part[0];
        parts[k][1] = is_turned ? 1 - part[1] : part[1];
    }
    const double from = fmax(fmin(parts[0][0], parts[0][1]), fmin(parts[1][0], parts[1][1]));
    const double to = fmin(fmax(parts[0][0], parts[0][1]), fmax(parts[1][0], parts[1][1]));
    double nodes[TAUT_CLOTH_FEW], weights[TAUT_CLOTH_FEW], sums[2] = {0, 0}, apart = 0, at = 0;

    if (!(to - from > same_place)) {
        return;
    }
    taut_gauss_rule(TAUT_CLOTH_FEW, nodes, weights);
    for (int i = 0; i < STEPS; i++) {
        const double a = (double)i / STEPS, b = (double)(i + 1) / STEPS;
        for (int k = 0; k < 2; k++) {
            const double range = parts[k][1] - parts[k][0];
            sums[k] += fabs(taut_cloth_length_between(
                cloth, pieces[k]->edges[both[k].edge],
                (from + a * (to - from) - parts[k][0]) / range,
                (from + b * (to - from) - parts[k][0]) / range, nodes, weights));
        }
        if (!(fabs(sums[0] - sums[1]) <= apart)) {
            apart = fabs(sums[0] - sums[1]);
            at = from + b * (to - from);
        }
    }
    taut_worst_take(w, apart / fmax(sums[0], sums[1]), name, at);
}

/* Is it asked that this edge is held? */
static int is_asked(const taut_pattern_held *held, const taut_cloth_piece *piece, int e)
{
    return !piece->is_sewn[e] && !piece->is_point[e] &&
           (held->edges[e] || (piece->border[e] >= 0 && held->borders[piece->border[e]]));
}

/* Lengths of an edge from its beginning to places along it, flat against the surface's times a share; or where that fades out, less what
 * is left of it. */
static double measure_along(const taut_cloth *cloth, const taut_cloth_piece *piece, int e,
                            double share, int is_faded)
{
    const int is_across = e == TAUT_CLOTH_START || e == TAUT_CLOTH_END;
    const double fixed = e == TAUT_CLOTH_END || e == TAUT_CLOTH_LEFT;
    double nodes[TAUT_CLOTH_FEW], weights[TAUT_CLOTH_FEW];
    double sums[2] = {0, 0}, apart = 0;
    taut_gauss_rule(TAUT_CLOTH_FEW, nodes, weights);
    for (int i = 0; i < STEPS; i++) {
        const double a = (double)i / STEPS, b = (double)(i + 1) / STEPS;
        for (int q = 0; q < TAUT_CLOTH_FEW; q++) {
            const double x = a + (b - a) * (1 + nodes[q]) / 2;
            double g[3] = {NAN, NAN, NAN}, own = share, at[3][2] = {{0}};
            taut_cloth_across across;
            taut_cloth_across_at(cloth, piece, is_across ? fixed : x, 1, &across);
            taut_cloth_metric_on(cloth, &across, is_across ? x : fixed, g);
            if (is_faded) {
                taut_cloth_window_on(cloth, &across, is_across ? x : fixed, at);
                own = 1 - taut_cloth_left(cloth, piece, e, at[0]) * (1 - share);
            }
            sums[0] += weights[q] * (b - a) / 2 * own * sqrt(g[is_across ? 2 : 0]);
        }
        sums[1] += taut_cloth_length_between(cloth, piece->edges[e], a, b, nodes, weights);
        apart = taut_certify_max(apart, fabs(sums[0] - sums[1]));
    }
    return apart / sums[0];
}

/* A held edge to which nothing is sewn. */
static void measure_held(const taut_cloth *cloth, const taut_cloth_piece *piece, int e,
                         taut_worst *w)
{
    const double share = cloth->has_seam                        ? 1 - cloth->seam
                         : cloth->warp == 0 && cloth->weft == 0 ? 1
                                                                : piece->held[e];
    taut_worst_take(w,
                    measure_along(cloth, piece, e, share, cloth->has_seam && cloth->fade_count > 0),
                    piece->name, e);
}

/* Of true length: the flat edge against that of the surface. */
static void measure(const taut_cloth *cloth, const sewn *one, taut_worst *w)
{
    const taut_cloth_piece *piece = &cloth->pieces[one->piece];
    const taut_cloth_side *side = &cloth->sides[piece->sides[one->edge]];
    const double *part = piece->part[one->edge];
    double share = cloth->warp == 0 && cloth->weft == 0 ? 1 : side->share;
    if (cloth->has_seam) {
        share = 1 - cloth->seam;
    }
    if (cloth->fade_count > 0) {
        taut_worst_take(w, measure_along(cloth, piece, one->edge, share, 1), side->seam, 1);
        return;
    }
    const double flat = piece->flat_lengths[one->edge];
    taut_worst_take(w, fabs(flat / (share * (part[1] - part[0]) * side->length) - 1), side->seam,
                    1);
}

/* Of all pieces; whether there is any. */
static int measure_all_held(const taut_cloth *cloth, taut_worst *w)
{
    int any = 0;
    for (int k = 0; k < cloth->piece_count * TAUT_CLOTH_EDGES; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k / TAUT_CLOTH_EDGES];
        const int e = k % TAUT_CLOTH_EDGES, is_held = !isnan(piece->held[e]);
        if (is_held) {
            measure_held(cloth, piece, e, w);
        }
        if (cloth->problem != NULL && is_held != is_asked(&cloth->problem->held, piece, e) &&
            piece->flat_lengths[e] > 0) {
            taut_worst_take(w, INFINITY, piece->name, e);
            any = 1;
        }
        any |= is_held;
    }
    return any;
}

/* What is found of the seam of each edge that is first. */
typedef struct seams {
    const taut_cloth *cloth;
    taut_worst *apart;
} seams;

static void compare_all(void *context, int worker, int64_t task)
{
    const seams *all = context;
    const taut_cloth *cloth = all->cloth;
    const sewn a = {(int)task / TAUT_CLOTH_EDGES, (int)task % TAUT_CLOTH_EDGES};
    const taut_cloth_piece *piece = &cloth->pieces[a.piece];
    (void)worker;

    all->apart[task] = (taut_worst){0, ""};
    if (!piece->is_sewn[a.edge] || !taut_cloth_is_first(cloth, piece, a.edge)) {
        return;
    }
    const char *name = cloth->sides[piece->sides[a.edge]].seam;
    for (int k = 0; k < cloth->piece_count * TAUT_CLOTH_EDGES; k++) {
        const sewn both[2] = {a, {k / TAUT_CLOTH_EDGES, k % TAUT_CLOTH_EDGES}};
        const taut_cloth_piece *other = &cloth->pieces[both[1].piece];
        if (other->is_sewn[both[1].edge] && !taut_cloth_is_first(cloth, other, both[1].edge) &&
            strcmp(cloth->sides[other->sides[both[1].edge]].seam, name) == 0) {
            compare(cloth, name, both, &all->apart[task]);
        }
    }
}

static taut_status add_seams(const taut_cloth *cloth, taut_arena *arena,
                             taut_certificate *certificate)
{
    const size_t count = (size_t)cloth->piece_count * TAUT_CLOTH_EDGES;
    const int workers = taut_crew_workers(cloth->crew, (int64_t)count);
    seams all = {cloth, taut_arena_take(arena, count + 1, sizeof *all.apart)};
    taut_worst w = {0, ""}, lengths = {0, ""};
    int any = 0;

    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    if (taut_crew_run(cloth->crew, workers, (int64_t)count, work_of_side, compare_all, &all)) {
        return TAUT_INTERRUPTED;
    }
    const int any_held = measure_all_held(cloth, &lengths);
    for (int i = 0; i < cloth->piece_count * TAUT_CLOTH_EDGES; i++) {
        const sewn a = {i / TAUT_CLOTH_EDGES, i % TAUT_CLOTH_EDGES};
        if (!cloth->pieces[a.piece].is_sewn[a.edge]) {
            continue;
        }
        any = 1;
        if (cloth->is_true) {
            measure(cloth, &a, &lengths);
        }
        if (all.apart[i].where[0] != '\0') {
            taut_worst_join(&w, &all.apart[i]);
        }
    }
    const taut_status status =
        any ? taut_worst_add(&w, "seams", TAUT_CHECK, seam_limit, certificate) : TAUT_OK;
    return status == TAUT_OK && ((any && cloth->is_true) || any_held)
               ? taut_worst_add(&lengths, "lengths", TAUT_CHECK, seam_limit, certificate)
               : status;
}

/* Is no cloth left along any edge? Then the piece is cut along the lines that are sewn. */
static int is_bare(const taut_cloth_piece *piece)
{
    int all = 1;
    for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
        all &= piece->allowance[e] == 0;
    }
    return all;
}

/* Ends that are told to be straight and square to y_1: how far apart their y_1 are, over the size. */
static taut_status add_ends(const taut_cloth *cloth, taut_certificate *certificate)
{
    static const int ends[2] = {TAUT_CLOTH_START, TAUT_CLOTH_END};
    taut_worst w = {0, ""};
    for (int k = 0; k < 2 * cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k / 2];
        const taut_curve *line = piece->edges[ends[k % 2]];
        double first[1][3], y[1][3];
        taut_cloth_line(cloth, line, 0, 0, first);
        for (int i = 1; i <= STEPS; i++) {
            taut_cloth_line(cloth, line, (double)i / STEPS, 0, y);
            taut_worst_take(&w, fabs(y[0][0] - first[0][0]) / cloth->size, piece->name,
                            (double)i / STEPS);
        }
    }
    return taut_worst_add(&w, "ends", TAUT_CHECK, end_limit, certificate);
}

static taut_status add_edges(const taut_cloth *cloth, taut_certificate *certificate)
{
    taut_worst w = {0, ""};
    for (int k = 0; k < cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k];
        for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
            for (int i = 0; i <= STEPS / 4; i++) {
                const double x = (double)i / (STEPS / 4);
                const int along = e == TAUT_CLOTH_RIGHT || e == TAUT_CLOTH_LEFT;
                const double fixed = e == TAUT_CLOTH_END || e == TAUT_CLOTH_LEFT;
                double y[1][3], on[3], cut[1][3];
                taut_cloth_line(cloth, piece->edges[e], x, 0, y);
                taut_surface_eval(piece->flat, along ? x : fixed, along ? fixed : x, 0, on);
                taut_worst_take(&w, taut_distance(y[0], on) / cloth->size, piece->name, x);
                if (is_bare(piece)) { /* right and end as they run, left and start backwards */
                    taut_cloth_line(cloth, piece->cut, taut_cloth_hand(e) ? e + 1 - x : e + x, 0,
                                    cut);
                    taut_worst_take(&w, taut_distance(cut[0], on) / cloth->size, piece->name, x);
                }
            }
        }
    }
    return taut_worst_add(&w, "edges", TAUT_CHECK, edge_limit, certificate);
}

taut_status taut_cloth_add_lines(const taut_cloth *cloth, taut_arena *arena,
                                 taut_certificate *certificate)
{
    taut_status status = add_cover(cloth, certificate);
    if (status == TAUT_OK) {
        status = add_on_surface(cloth, arena, certificate);
    }
    if (status == TAUT_OK) {
        status = add_edges(cloth, certificate);
    }
    if (status == TAUT_OK && cloth->is_straight) {
        status = add_ends(cloth, certificate);
    }
    return status == TAUT_OK ? add_seams(cloth, arena, certificate) : status;
}
