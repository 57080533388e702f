/* asked.c
 *
 *   layout        with the document: seams are as many as its rules make, and the ends of each lie where one puts them, edges measured
 *                 here, and circles around a pole all along; largest distance in space over the size (check). A number of strips that is searched for, and seams square to
 *                 another one, are as many as there are
 *   thread        the angle from the asked one to the chord from the middle of start to that of end, of each piece (check)
 *   compensation  of true and held lengths: what details tell, against what warp and weft make of the way the finished edges run, over
 *                 their difference (check); pieces were laid out by edges of the first pass, which run nearly the same way
 */
#include "certify/pattern/asked.h"

#include "certify/pattern/worst.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS = 256, NODES = 4, ROUNDS = 60, EDGE_CELLS = 32 };
static const double thread_limit = 1e-9, share_limit = 0.01;

/* ---- edges of the window by their length ---- */

typedef struct ruler {
    const taut_surface *on;
    int edge;
    double sums[CELLS + 1];
} ruler;

/* The place at a share of an edge's parameter range. */
static void place_on(const taut_surface *on, int edge, double share, double at[2])
{
    const taut_basis *bases[2] = {taut_surface_u(on), taut_surface_v(on)};
    const int held = edge / 2, along = 1 - held;
    const double lo = taut_basis_lo(bases[along]), hi = taut_basis_hi(bases[along]);
    at[held] = edge % 2 == 0 ? taut_basis_lo(bases[held]) : taut_basis_hi(bases[held]);
    at[along] = share < 1 ? lo + share * (hi - lo) : hi;
}

/* The length of an edge between two shares of its range. */
static double length_of(const taut_surface *on, int edge, double a, double b)
{
    const taut_basis *along = edge / 2 == 0 ? taut_surface_v(on) : taut_surface_u(on);
    const double range = taut_basis_hi(along) - taut_basis_lo(along);
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int q = 0; q < NODES; q++) {
        double at[2], x[3][3] = {{0}};
        place_on(on, edge, a + (b - a) * (1 + nodes[q]) / 2, at);
        taut_surface_eval(on, at[0], at[1], 1, x[0]);
        sum += weights[q] * (b - a) / 2 * range * taut_norm(x[edge / 2 == 0 ? 2 : 1]);
    }
    return sum;
}

static void measure(const taut_surface *on, int edge, ruler *r)
{
    r->on = on;
    r->edge = edge;
    r->sums[0] = 0;
    for (int k = 0; k < CELLS; k++) {
        r->sums[k + 1] =
            r->sums[k] + length_of(on, edge, (double)k / CELLS, (double)(k + 1) / CELLS);
    }
}

/* The share of the range at a length. */
static double share_at(const ruler *r, double length)
{
    int cell = 0;
    while (cell + 1 < CELLS && r->sums[cell + 1] < length) {
        cell++;
    }
    const double from = (double)cell / CELLS;
    double low = from, high = (double)(cell + 1) / CELLS;
    for (int round = 0; round < ROUNDS; round++) {
        const double middle = (low + high) / 2;
        if (r->sums[cell] + length_of(r->on, r->edge, from, middle) < length) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return (low + high) / 2;
}

/* ---- the ends of seams ---- */

typedef struct layout {
    const taut_cloth *cloth;
    char *is_met; /* of each side: a seam that a rule asks for */
    taut_worst worst;
} layout;

/* A seam that does not lie along a border. */
static int is_cut(const taut_cloth_side *side)
{
    const double *points = taut_curve_points(side->window);
    const int count = taut_basis_count(taut_curve_t(side->window));
    int all[4] = {1, 1, 1, 1};
    for (int b = 0; b < 4; b++) {
        double at[2];
        place_on(side->on, b, 0, at);
        for (int k = 0; k < count; k++) {
            all[b] &= points[3 * k + b / 2] == at[b / 2];
        }
    }
    return side->seam != NULL && !all[0] && !all[1] && !all[2] && !all[3];
}

/* The point of a place, which rounding may have out of the window. */
static int point_at(const taut_surface *on, const double at[2], double x[3])
{
    const taut_basis *bases[2] = {taut_surface_u(on), taut_surface_v(on)};
    double inside[2];
    for (int d = 0; d < 2; d++) {
        const double lo = taut_basis_lo(bases[d]), hi = taut_basis_hi(bases[d]);
        const double room = 1e-9 * (hi - lo);
        if (!(at[d] >= lo - room) || !(at[d] <= hi + room)) {
            return 0;
        }
        inside[d] = fmin(fmax(at[d], lo), hi);
    }
    return taut_surface_eval(on, inside[0], inside[1], 0, x) == TAUT_OK;
}

static double apart(const taut_surface *on, const double a[2], const double b[2])
{
    double x[3], y[3];
    return point_at(on, a, x) && point_at(on, b, y) ? taut_distance(x, y) : INFINITY;
}

/* Somewhere there is a seam between two places, either way. */
static void meet(layout *l, const taut_surface *on, const double ends[2][2], int rule)
{
    int best = -1;
    double least = INFINITY;
    char where[24];
    for (int k = 0; k < l->cloth->side_count; k++) {
        const taut_cloth_side *side = &l->cloth->sides[k];
        double at[2][2];
        if (side->on != on || l->is_met[k] || !is_cut(side)) {
            continue;
        }
        taut_cloth_side_at(side, 0, at[0]);
        taut_cloth_side_at(side, 1, at[1]);
        const double same = fmax(apart(on, at[0], ends[0]), apart(on, at[1], ends[1]));
        const double turned = fmax(apart(on, at[1], ends[0]), apart(on, at[0], ends[1]));
        if (fmin(same, turned) < least) {
            least = fmin(same, turned);
            best = k;
        }
    }
    if (best >= 0) {
        l->is_met[best] = 1;
    }
    snprintf(where, sizeof where, "/seams/%d", rule);
    taut_worst_take(&l->worst, least / l->cloth->size, where, 0);
}

/* Where the first k of so many parts of an edge end, as a share of its range. */
static double part_of(const taut_pattern_rule *rule, const ruler *r, int k, int count)
{
    return rule->by == TAUT_PATTERN_BY_PARAMETER ? (double)k / count
                                                 : share_at(r, r->sums[CELLS] * k / count);
}

static void meet_strips(layout *l, const taut_surface *on, const taut_pattern_rule *rule, int index,
                        int count)
{
    ruler rulers[2];
    for (int e = 0; e < 2; e++) {
        measure(on, (int)rule->edges[e], &rulers[e]);
    }
    for (int k = 1; k < count; k++) {
        double ends[2][2];
        for (int e = 0; e < 2; e++) {
            const double share = part_of(rule, &rulers[e], k, count);
            place_on(on, (int)rule->edges[e], share, ends[e]);
        }
        meet(l, on, (const double(*)[2])ends, index);
    }
}

/* ---- circles around a pole ---- */

/* Which edge of a rule with a trim is one place of the surface: the one that pieces have a tip on. -1: none. */
static int pole_of(const taut_cloth *cloth, const taut_surface *on, const taut_pattern_rule *rule)
{
    for (int e = 0; e < 2; e++) {
        for (int k = 0; k < cloth->piece_count; k++) {
            const taut_cloth_piece *piece = &cloth->pieces[k];
            for (int i = 0; i < TAUT_CLOTH_EDGES; i++) {
                if (piece->on == on && piece->is_point[i] &&
                    piece->border[i] == (int)rule->edges[e]) {
                    return e;
                }
            }
        }
    }
    return -1;
}

/* The length of a parameter line from a pole to a place, span by span. */
static double distance_from(const taut_surface *on, int pole, const double at[2])
{
    const int held = pole / 2;
    const taut_basis *basis = held == 0 ? taut_surface_u(on) : taut_surface_v(on);
    const double *breaks = taut_basis_breaks(basis);
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < taut_basis_span_count(basis) * EDGE_CELLS; k++) {
        const int span = k / EDGE_CELLS;
        const double lo = pole % 2 == 0 ? breaks[span] : fmax(breaks[span], at[held]);
        const double hi = pole % 2 == 0 ? fmin(breaks[span + 1], at[held]) : breaks[span + 1];
        for (int q = 0; hi > lo && q < NODES; q++) {
            double place[2] = {at[0], at[1]}, x[3][3] = {{0}};
            place[held] = lo + (hi - lo) * (k % EDGE_CELLS + (1 + nodes[q]) / 2) / EDGE_CELLS;
            taut_surface_eval(on, place[0], place[1], 1, x[0]);
            sum += weights[q] / 2 * (hi - lo) / EDGE_CELLS * taut_norm(x[1 + held]);
        }
    }
    return sum;
}

/* On the parameter line through a place: where it is at a distance from the pole. */
static void place_at(const taut_surface *on, int pole, double distance, double at[2])
{
    const int held = pole / 2;
    const taut_basis *basis = held == 0 ? taut_surface_u(on) : taut_surface_v(on);
    double near = pole % 2 == 0 ? taut_basis_lo(basis) : taut_basis_hi(basis);
    double far = pole % 2 == 0 ? taut_basis_hi(basis) : taut_basis_lo(basis);
    for (int round = 0; round < ROUNDS; round++) {
        at[held] = (near + far) / 2;
        *(distance_from(on, pole, at) < distance ? &near : &far) = at[held];
    }
}

/* From a pole to a place inside the window: what cuts a cap. */
static int is_spoke(const taut_cloth *cloth, const taut_cloth_side *side)
{
    for (int i = 0; i < cloth->problem->rule_count; i++) {
        const taut_pattern_rule *rule = &cloth->problem->rules[i];
        const int e = rule->trim > 0 ? pole_of(cloth, side->on, rule) : -1;
        for (int end = 0; e >= 0 && end < 2; end++) {
            const int held = (int)rule->edges[0] / 2;
            double at[2], other[2], pole[2], far[2];
            taut_cloth_side_at(side, end, at);
            taut_cloth_side_at(side, 1 - end, other);
            place_on(side->on, (int)rule->edges[e], 0, pole);
            place_on(side->on, (int)rule->edges[1 - e], 0, far);
            if (at[held] == pole[held] && other[held] != far[held]) {
                return 1;
            }
        }
    }
    return 0;
}

/* A place of a circle, or of what ends on it: how far its distance is off. */
static void take_distance(layout *l, const taut_cloth_side *side, const taut_pattern_rule *rule,
                          int pole, double share)
{
    double at[2];
    taut_cloth_side_at(side, share, at);
    const double off = distance_from(side->on, pole, at) - ldexp(rule->trim, -l->cloth->unit);
    taut_worst_take(&l->worst, fabs(off) / l->cloth->size, side->name, share);
}

/* The circle, all along it; seams from it to the opposite edge; and those from the pole to it, however many. */
static void meet_trimmed(layout *l, const taut_surface *on, const taut_pattern_rule *rule,
                         int index, int count)
{
    const int e = pole_of(l->cloth, on, rule), held = (int)rule->edges[0] / 2;
    const int pole = (int)rule->edges[e < 0 ? 0 : e], opposite = pole ^ 1;
    const taut_basis *along = held == 0 ? taut_surface_v(on) : taut_surface_u(on);
    int circles = 0;
    ruler r;
    for (int k = 0; k < l->cloth->side_count; k++) {
        const taut_cloth_side *side = &l->cloth->sides[k];
        if (side->on != on || side->seam == NULL || l->is_met[k]) {
            continue;
        }
        double ends[2][2], tip[2];
        taut_cloth_side_at(side, 0, ends[0]);
        taut_cloth_side_at(side, 1, ends[1]);
        place_on(on, pole, 0, tip);
        if (is_spoke(l->cloth, side)) {
            l->is_met[k] = 1;
            take_distance(l, side, rule, pole, ends[0][held] == tip[held]);
        } else if (strcmp(side->kind, "circle") == 0) {
            const double low = fmin(ends[0][1 - held], ends[1][1 - held]);
            const double high = fmax(ends[0][1 - held], ends[1][1 - held]);
            circles += low == taut_basis_lo(along) && high == taut_basis_hi(along);
            l->is_met[k] = 1;
            for (int i = 0; i <= CELLS; i++) {
                take_distance(l, side, rule, pole, (double)i / CELLS);
            }
        }
    }
    if (e < 0 || circles != 1) {
        taut_worst_take(&l->worst, INFINITY, "circle", circles);
    }
    measure(on, opposite, &r);
    for (int k = 1; k < count; k++) {
        double ends[2][2];
        place_on(on, opposite, part_of(rule, &r, k, count), ends[1]);
        memcpy(ends[0], ends[1], sizeof ends[0]);
        place_at(on, pole, ldexp(rule->trim, -l->cloth->unit), ends[0]);
        meet(l, on, (const double(*)[2])ends, index);
    }
}

static void place_of(const layout *l, const taut_surface *on, const taut_pattern_at *asked,
                     double at[2])
{
    const int edge = (int)asked->edge;
    ruler r;
    if (!asked->is_on_edge) {
        memcpy(at, asked->uv, 2 * sizeof(double));
        return;
    }
    if (asked->place == TAUT_PATTERN_PARAMETER) {
        place_on(on, edge, 0, at);
        at[1 - edge / 2] = asked->value;
        return;
    }
    measure(on, edge, &r);
    place_on(on, edge,
             share_at(&r, asked->place == TAUT_PATTERN_PART ? asked->value * r.sums[CELLS]
                                                            : ldexp(asked->value, -l->cloth->unit)),
             at);
}

static void meet_line(layout *l, const taut_surface *on, const taut_pattern_rule *rule, int index)
{
    for (int i = 0; i < rule->value_count; i++) {
        double ends[2][2];
        for (int e = 0; e < 2; e++) { /* from one border that runs across to the other one */
            place_on(on, 2 * (1 - rule->held) + e, 0, ends[e]);
            ends[e][rule->held] = rule->values[i];
        }
        meet(l, on, (const double(*)[2])ends, index);
    }
}

/* Of the piece of a strip that a share of its long edges lies in. */
static void meet_butts(layout *l, const taut_pattern_rule *rule, int index)
{
    char name[24];
    snprintf(name, sizeof name, "P%d", rule->strip + 1);
    const size_t length = strlen(name);
    for (int i = 0; i < rule->value_count; i++) {
        double ends[2][2];
        const taut_cloth_piece *strip = NULL;
        for (int k = 0; k < l->cloth->piece_count; k++) {
            const taut_cloth_piece *one = &l->cloth->pieces[k];
            strip = strncmp(one->name, name, length) == 0 &&
                            (one->name[length] == '\0' || one->name[length] == '-')
                        ? one
                        : strip;
        }
        if (strip == NULL) {
            taut_worst_take(&l->worst, INFINITY, name, 0);
            continue;
        }
        for (int e = 0; e < 2; e++) {
            const int edge = e == 0 ? TAUT_CLOTH_RIGHT : TAUT_CLOTH_LEFT;
            taut_cloth_side_at(&l->cloth->sides[strip->sides[edge]], rule->values[i], ends[e]);
        }
        meet(l, strip->on, (const double(*)[2])ends, index);
    }
}

/* In every strip that is longer than the cloth. */
static int is_equal_butts(const taut_pattern_rule *rule)
{
    return rule->kind == TAUT_PATTERN_BUTT && rule->strip < 0;
}

/* The number of a piece's strip, from 1, as its name tells it: that of P2-1 is 2. */
static int64_t strip_of(const taut_cloth_piece *piece)
{
    return piece->name[0] == 'P' ? strtoll(piece->name + 1, NULL, 10) : 0;
}

/* Parts that a piece's strip has. */
static int parts_of(const taut_cloth *cloth, const taut_cloth_piece *piece)
{
    int count = 0;
    for (int k = 0; k < cloth->piece_count; k++) {
        count += strip_of(&cloth->pieces[k]) == strip_of(piece);
    }
    return count;
}

/* Strips in as many parts as there are: equal ones, of every second strip the first and the last half as long. */
static void meet_equal_butts(layout *l, int index)
{
    for (int k = 0; k < l->cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &l->cloth->pieces[k];
        const int count = parts_of(l->cloth, piece), is_staggered = strip_of(piece) % 2 == 0;
        const int is_first = k == 0 || strip_of(piece - 1) != strip_of(piece);
        for (int i = 1; is_first && i < count; i++) {
            const double x = is_staggered ? (i - 0.5) / (count - 1) : (double)i / count;
            double ends[2][2];
            for (int e = 0; e < 2; e++) {
                const int edge = e == 0 ? TAUT_CLOTH_RIGHT : TAUT_CLOTH_LEFT;
                taut_cloth_side_at(&l->cloth->sides[piece->sides[edge]], x, ends[e]);
            }
            meet(l, piece->on, (const double(*)[2])ends, index);
        }
    }
}

/* Butts that there are. */
static int count_equal_butts(const taut_cloth *cloth)
{
    int count = 0;
    for (int k = 1; k < cloth->piece_count; k++) {
        count += strip_of(&cloth->pieces[k]) == strip_of(&cloth->pieces[k - 1]);
    }
    return count;
}

/* Seams that a rule makes of a surface; -1: as many as there are. */
static int count_of(const taut_pattern_rule *rule)
{
    switch (rule->kind) {
    case TAUT_PATTERN_ACROSS:
    case TAUT_PATTERN_RADIAL:
        return rule->count > 0 ? rule->count - 1 : -1;
    case TAUT_PATTERN_PARALLEL:
        return -1;
    case TAUT_PATTERN_LINE:
    case TAUT_PATTERN_BUTT:
        return rule->value_count;
    default:
        return 1;
    }
}

static int is_for(const taut_cloth *cloth, const taut_pattern_rule *rule, int surface)
{
    return rule->surface == NULL || !cloth->is_several ||
           strcmp(rule->surface, taut_surface_name(taut_model_surface(cloth->model, surface))) == 0;
}

static void meet_rule(layout *l, int surface, int index, int count)
{
    const taut_pattern_rule *rule = &l->cloth->problem->rules[index];
    const taut_surface *on = l->cloth->surfaces[surface];
    double ends[2][2];
    if (rule->trim > 0) {
        meet_trimmed(l, on, rule, index, count);
    } else if (rule->kind == TAUT_PATTERN_ACROSS || rule->kind == TAUT_PATTERN_RADIAL) {
        meet_strips(l, on, rule, index, count);
    } else if (rule->kind == TAUT_PATTERN_LINE) {
        meet_line(l, on, rule, index);
    } else if (rule->kind == TAUT_PATTERN_GEODESIC) {
        place_of(l, on, &rule->at[0], ends[0]);
        place_of(l, on, &rule->at[1], ends[1]);
        meet(l, on, (const double(*)[2])ends, index);
    }
}

static taut_status add_layout(const taut_cloth *cloth, taut_arena *arena,
                              taut_certificate *certificate)
{
    const taut_pattern_problem *p = cloth->problem;
    layout l = {cloth, taut_arena_take(arena, (size_t)cloth->side_count + 1, 1), {0, ""}};
    int found = 0, known = 0, searched = 0, is_open = 0, last = 0;

    if (l.is_met == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < cloth->side_count; k++) {
        found += is_cut(&cloth->sides[k]) && !is_spoke(cloth, &cloth->sides[k]);
    }
    for (int i = 0; i < p->rule_count; i++) {
        const int count = count_of(&p->rules[i]), is_butt = p->rules[i].kind == TAUT_PATTERN_BUTT;
        last = is_butt ? last : i; /* strips that are cut later have other names then */
        for (int k = 0; k < (is_butt ? 1 : cloth->surface_count); k++) {
            const int is_here = is_for(cloth, &p->rules[i], k);
            known += is_here && count > 0 ? count : 0;
            known += is_here && p->rules[i].trim > 0; /* the circle */
            searched += is_here && count < 0 && p->rules[i].kind != TAUT_PATTERN_PARALLEL;
            is_open |= p->rules[i].kind == TAUT_PATTERN_PARALLEL;
        }
        known += is_equal_butts(&p->rules[i]) ? count_equal_butts(cloth) : 0;
    }
    /* strips of a number that is not asked for: all others */
    const int strips = searched > 0 ? (found - known) / searched + 1 : 0;
    if (!is_open && (found < known || found - known != searched * (strips - 1) * (searched > 0))) {
        taut_worst_take(&l.worst, INFINITY, "/seams", found);
    }
    for (int i = 0; i < p->rule_count; i++) {
        for (int k = 0; k < cloth->surface_count; k++) {
            const int count = p->rules[i].count > 0 ? p->rules[i].count : strips;
            if (is_for(cloth, &p->rules[i], k) && !(is_open && p->rules[i].count == 0)) {
                meet_rule(&l, k, i, count);
            }
        }
        if (is_equal_butts(&p->rules[i])) {
            meet_equal_butts(&l, i);
        } else if (p->rules[i].kind == TAUT_PATTERN_BUTT && i >= last) {
            meet_butts(&l, &p->rules[i], i);
        }
    }
    return taut_worst_add(&l.worst, "layout", TAUT_CHECK, cloth->tolerance, certificate);
}

/* ---- the thread ---- */

/* Straight ends are square to the warp, which the claim `ends` is about. */
static taut_status add_thread(const taut_cloth *cloth, taut_certificate *certificate)
{
    const double way[2] = {taut_cos(cloth->thread), taut_sin(cloth->thread)};
    taut_worst w = {0, ""};
    if (cloth->is_straight) {
        return TAUT_OK;
    }
    for (int k = 0; k < cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k];
        double from[3], to[3];
        taut_surface_eval(piece->flat, 0, 0.5, 0, from);
        taut_surface_eval(piece->flat, 1, 0.5, 0, to);
        const double chord[2] = {to[0] - from[0], to[1] - from[1]};
        taut_worst_take(&w,
                        fabs(taut_atan2(way[0] * chord[1] - way[1] * chord[0],
                                        way[0] * chord[0] + way[1] * chord[1])),
                        piece->name, 0);
    }
    return taut_worst_add(&w, "thread", TAUT_CHECK, thread_limit, certificate);
}

/* ---- compensation of lengths ---- */

/* Flat over mounted along an edge, of warp and weft alone, on the average of its surface; where they fade out, `is_faded`, or as if
 * they did not. */
static double share_of(const taut_cloth *cloth, const taut_cloth_piece *piece, int e, int is_faded)
{
    const int is_across = e == TAUT_CLOTH_START || e == TAUT_CLOTH_END;
    const double fixed = e == TAUT_CLOTH_END || e == TAUT_CLOTH_LEFT;
    double nodes[NODES], weights[NODES], sum = 0, whole = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int i = 0; i < EDGE_CELLS * NODES; i++) {
        const double x = (i / NODES + (1 + nodes[i % NODES]) / 2) / EDGE_CELLS;
        double y[2][3], w[3][2] = {{0}}, shrink[2] = {1 - cloth->warp, 1 - cloth->weft};
        if (is_faded && cloth->fade_count > 0) {
            taut_cloth_across across;
            taut_cloth_across_at(cloth, piece, is_across ? fixed : x, 1, &across);
            taut_cloth_window_on(cloth, &across, is_across ? x : fixed, w);
            taut_cloth_shrink(cloth, piece, w[0], shrink);
        }
        taut_cloth_line(cloth, piece->edges[e], x, 1, y);
        const double mounted = taut_hypot(y[1][0] / shrink[0], y[1][1] / shrink[1]);
        sum += weights[i % NODES] * taut_hypot(y[1][0], y[1][1]) / mounted;
        whole += weights[i % NODES];
    }
    return sum / whole;
}

/* The mean over both sides of a seam, each piece as long as it lies along it. */
static double seam_share(const taut_cloth *cloth, const char *seam)
{
    double sums[2] = {0, 0}, parts[2] = {0, 0};
    for (int k = 0; k < cloth->piece_count * TAUT_CLOTH_EDGES; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k / TAUT_CLOTH_EDGES];
        const int e = k % TAUT_CLOTH_EDGES;
        if (piece->is_sewn[e] && strcmp(cloth->sides[piece->sides[e]].seam, seam) == 0) {
            const int hand = !taut_cloth_is_first(cloth, piece, e);
            const double part = piece->part[e][1] - piece->part[e][0];
            sums[hand] += part * share_of(cloth, piece, e, 0);
            parts[hand] += part;
        }
    }
    return (sums[0] / parts[0] + sums[1] / parts[1]) / 2;
}

static taut_status add_compensation(const taut_cloth *cloth, taut_certificate *certificate)
{
    const double room = fabs(cloth->warp - cloth->weft);
    /* of equal shares both ways there is one for all, up to rounding */
    const double over = room > 1e-6 ? room : 1e-6;
    taut_worst w = {0, ""};
    int any = 0;
    for (int k = 0; k < cloth->piece_count * TAUT_CLOTH_EDGES; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k / TAUT_CLOTH_EDGES];
        const int e = k % TAUT_CLOTH_EDGES;
        if (!isnan(piece->held[e])) {
            const double own = cloth->has_seam ? 1 - cloth->seam : share_of(cloth, piece, e, 1);
            taut_worst_take(&w, fabs(piece->held[e] - own) / over, piece->name, e);
            any = 1;
        }
    }
    for (int k = 0; cloth->is_true && k < cloth->side_count; k++) {
        const taut_cloth_side *side = &cloth->sides[k];
        if (side->seam != NULL) {
            const double own = cloth->has_seam ? 1 - cloth->seam : seam_share(cloth, side->seam);
            taut_worst_take(&w, fabs(side->share - own) / over, side->seam, 0);
            any = 1;
        }
    }
    return any ? taut_worst_add(&w, "compensation", TAUT_CHECK, share_limit, certificate) : TAUT_OK;
}

taut_status taut_cloth_add_asked(const taut_cloth *cloth, taut_arena *arena,
                                 taut_certificate *certificate)
{
    taut_status status = cloth->problem != NULL ? add_layout(cloth, arena, certificate) : TAUT_OK;
    if (status == TAUT_OK) {
        status = add_thread(cloth, certificate);
    }
    return status == TAUT_OK ? add_compensation(cloth, certificate) : status;
}
