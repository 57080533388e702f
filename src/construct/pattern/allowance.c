#include "construct/pattern/allowance.h"

#include "construct/pattern/line.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    FIRST = 16,
    MOST = 512, /* spans of a parallel curve */
    LOOK = 128, /* places of an edge, for its radius */
    ROUNDS = 40,
    PARTS = 4 * TAUT_FLAT_EDGES /* of each edge two lines, a curve and a line */
};
/* How far a parallel curve is off, over the allowance; the least 1 + a k; the sine of an angle that is none; a length over the
 * allowance that is none. */
static const double off_most = 1e-7, least_turn = 1e-3, straight_on = 1e-6, no_length = 1e-9;
/* A corner is cut off so many allowances away from it. */
static const double mitre_most = 2, square_most = 1;
/* Of allowances, over the surface's size. */
static const double least_size = 1e-6, most_size = 10;
/* Of the parameters of an edge, for its corners. */
static const double corner_share = 0.0625;
/* Of the way between the parallels of both sides: half the length that a tip is given. */
static const double tip_share = 1e-3;

/* ---- how much is left ---- */

int taut_pattern_border_of(const taut_pattern_layout *layout, int piece, int edge)
{
    const taut_pattern_piece *one = &layout->pieces[piece];
    return taut_pattern_is_sewn(one, edge) ? -1 : one->bounds[edge].border;
}

/* Does a seam run so that an edge of a piece is to its right? Of two surfaces it runs as that side which tells it, the later one's. */
static int lies_right(const taut_pattern_layout *layout, int piece, int edge)
{
    const int side = layout->pieces[piece].bounds[edge].side, twin = layout->sides[side].twin;
    const int is_told = twin < side || layout->sides[twin].ground == layout->sides[side].ground;
    for (int k = 0; !is_told && k < TAUT_FLAT_EDGES * layout->piece_count; k++) {
        const int other = k % TAUT_FLAT_EDGES;
        if (layout->pieces[k / TAUT_FLAT_EDGES].bounds[other].side == twin) {
            return other != TAUT_FLAT_LEFT && other != TAUT_FLAT_START;
        }
    }
    return edge == TAUT_FLAT_LEFT || edge == TAUT_FLAT_START;
}

/* What a seam is given for itself, or `width`. */
static double seam_width(const taut_pattern_allowance *a, const taut_pattern_layout *layout,
                         int piece, int edge, double width)
{
    const char *seam = layout->pieces[piece].bounds[edge].line->seam;
    for (int k = 0; k < a->seam_count; k++) {
        if (strcmp(a->seams[k].seam, seam) == 0) {
            return lies_right(layout, piece, edge) ? a->seams[k].right : a->seams[k].left;
        }
    }
    return width;
}

taut_status taut_pattern_check_seams(const taut_pattern_allowance *allowance,
                                     const taut_pattern_layout *layout, taut_error *error)
{
    for (int k = 0; k < allowance->seam_count; k++) {
        const char *name = allowance->seams[k].seam;
        int count = 0, is_there = 0;
        for (int i = 0; i < layout->side_count; i++) {
            const taut_pattern_side *side = &layout->sides[i];
            count += side->is_seam && side->twin < i;
            is_there |= side->is_seam && strcmp(side->seam, name) == 0;
        }
        if (!is_there) {
            char where[64];
            snprintf(where, sizeof where, "/allowance/%.40s", name);
            return taut_fail(error, TAUT_BAD_INPUT, "allowance", where, taut_none, taut_none,
                             "found the name \"%.40s\", and of the pattern's seams, %d, none has "
                             "it",
                             name, count);
        }
    }
    return TAUT_OK;
}

taut_pattern_margin taut_pattern_margin_of(const taut_pattern_problem *problem,
                                           const taut_pattern_layout *layout, int piece)
{
    const taut_pattern_allowance *a = &problem->allowance;
    taut_pattern_margin margin = {{0}, {0}};
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        const int border = taut_pattern_border_of(layout, piece, e);
        double width = border >= 0 ? a->border : a->seam;
        if (border < 0 && a->overlap > 0) {
            width = a->is_split ? a->overlap / 2 : piece % 2 == 0 ? a->overlap : 0;
        }
        if (border < 0 && a->has_butt && (e == TAUT_FLAT_START || e == TAUT_FLAT_END)) {
            width = a->butt;
        }
        if (border < 0) {
            width = seam_width(a, layout, piece, e, width);
        }
        for (int k = 0; border >= 0 && k < problem->hem_count; k++) {
            if ((int)problem->hems[k].edge == border) {
                width = 2 * problem->hems[k].pocket + a->seam;
                margin.is_folded[e] = 1;
            }
        }
        margin.width[e] = ldexp(width, -layout->carrier->scale);
    }
    for (int e = TAUT_FLAT_END; e <= TAUT_FLAT_START; e += TAUT_FLAT_START - TAUT_FLAT_END) {
        if (layout->pieces[piece].bounds[e].is_point) { /* a tip is cut square */
            margin.width[e] = fmax(margin.width[TAUT_FLAT_RIGHT], margin.width[TAUT_FLAT_LEFT]);
            margin.is_folded[e] = 0;
        }
    }
    return margin;
}

/* ---- parallel curves ---- */

typedef struct edge {
    const taut_curve *curve;
    double width, sign; /* of the outward normal (y_2', -y_1') */
    double lo, hi;      /* the part of it that is left, in its own parameter */
    double begin[2][2]; /* its first and last place and direction, the way around */
    double end[2][2];
} edge;

/* Place, first and second derivative; *turn = 1 + a k. */
static void parallel_at(const edge *e, double x, double y[3][2], double *turn)
{
    double c[4][3];
    taut_curve_eval(e->curve, x, 3, c[0]);
    const double v = taut_hypot(c[1][0], c[1][1]), t[2] = {c[1][0] / v, c[1][1] / v};
    const double bend = c[1][0] * c[2][1] - c[1][1] * c[2][0]; /* v^3 k */
    const double speed = (c[1][0] * c[2][0] + c[1][1] * c[2][1]) / v;
    const double vk = bend / (v * v);
    const double vk1 =
        (c[1][0] * c[3][1] - c[1][1] * c[3][0]) / (v * v) - 2 * bend * speed / (v * v * v);
    const double a = e->sign * e->width, first = v + a * vk, second = speed + a * vk1;
    y[0][0] = c[0][0] + a * t[1];
    y[0][1] = c[0][1] - a * t[0];
    for (int d = 0; d < 2; d++) {
        const double normal = d == 0 ? -t[1] : t[0];
        y[1][d] = first * t[d];
        y[2][d] = second * t[d] + first * vk * normal;
    }
    *turn = first / v;
}

/* The largest allowance that the edge takes, where it is least. */
static double largest_of(const edge *e, double *at)
{
    double most = INFINITY;
    for (int i = 0; i <= LOOK; i++) {
        double y[3][2], turn;
        parallel_at(e, (double)i / LOOK, y, &turn);
        /* 1 + a k = turn: the radius is -1/k */
        const double radius = turn < 1 ? e->width / (1 - turn) : INFINITY;
        if (radius < most) {
            most = radius;
            *at = (double)i / LOOK;
        }
    }
    return (1 - least_turn) * most;
}

static taut_status fail_radius(const taut_pattern_piece *piece, int which, const edge *e,
                               double most, double at, taut_error *error)
{
    static const char *const names[TAUT_FLAT_EDGES] = {"right", "end", "left", "start"};
    const int scale = piece->carrier->scale;
    return taut_fail(error, TAUT_NO_SOLUTION, "allowance", "/allowance", ldexp(e->width, scale),
                     ldexp(most, scale),
                     "%s.%s turns inwards at %.6g of its length: an allowance of at most %.6g can "
                     "be left there, not %.6g",
                     piece->name, names[which], at, ldexp(most, scale), ldexp(e->width, scale));
}

/* The part [lo, hi] as quintics, fine enough. */
static taut_status parallel(const edge *e, double enough, taut_arena *arena,
                            const taut_curve **curve)
{
    for (int spans = FIRST; spans <= MOST; spans *= 2) {
        const double range = e->hi - e->lo;
        taut_pattern_station *at = taut_arena_take(arena, (size_t)spans + 1, sizeof *at);
        double turn, off = 0;
        if (at == NULL) {
            return TAUT_NO_MEMORY;
        }
        for (int k = 0; k <= spans; k++) {
            at[k].x = (double)k / spans;
            parallel_at(e, k < spans ? e->lo + range * k / spans : e->hi, at[k].y, &turn);
            for (int d = 0; d < 2; d++) {
                at[k].y[1][d] *= range;
                at[k].y[2][d] *= range * range;
            }
        }
        const taut_status status = taut_pattern_quintics(spans, at, arena, curve);
        if (status != TAUT_OK) {
            return status;
        }
        for (int k = 0; k < 2 * spans; k++) {
            const double x = (k / 2 + (k % 2 == 0 ? 0.27 : 0.73)) / spans;
            double is[3], to[3][2];
            taut_curve_eval(*curve, x, 0, is);
            parallel_at(e, e->lo + range * x, to, &turn);
            off = fmax(off, taut_hypot(is[0] - to[0][0], is[1] - to[0][1]));
        }
        if (off <= enough) {
            break;
        }
    }
    return TAUT_OK;
}

/* ---- corners ---- */

/* Place and direction the way around, of the parameter where the edge begins or ends. */
static void look_along(const edge *e, int is_back, int at_end, double out[2][2])
{
    double y[3][2], turn;
    parallel_at(e, at_end != is_back ? e->hi : e->lo, y, &turn);
    const double length = taut_hypot(y[1][0], y[1][1]);
    memcpy(out[0], y[0], sizeof y[0]);
    for (int d = 0; d < 2; d++) {
        out[1][d] = (is_back ? -1 : 1) * y[1][d] / length;
    }
}

/* Where two parallel curves cross next to a corner that points inwards, by Newton's method; cuts them there. */
static int cross(edge *a, edge *b, int a_is_back, int b_is_back)
{
    double x[2] = {a_is_back ? a->lo : a->hi, b_is_back ? b->hi : b->lo};
    for (int round = 0; round < ROUNDS; round++) {
        double p[3][2], q[3][2], turn;
        parallel_at(a, x[0], p, &turn);
        parallel_at(b, x[1], q, &turn);
        const double gap[2] = {q[0][0] - p[0][0], q[0][1] - p[0][1]};
        const double det = p[1][0] * -q[1][1] + p[1][1] * q[1][0];
        const double step[2] = {(gap[0] * -q[1][1] + gap[1] * q[1][0]) / det,
                                (p[1][0] * gap[1] - p[1][1] * gap[0]) / det};
        if (!isfinite(step[0]) || !isfinite(step[1])) {
            return 0;
        }
        for (int k = 0; k < 2; k++) {
            x[k] = fmin(fmax(x[k] + step[k], 0), 1);
        }
        if (fabs(step[0]) + fabs(step[1]) < 1e-14) {
            break;
        }
    }
    *(a_is_back ? &a->lo : &a->hi) = x[0];
    *(b_is_back ? &b->hi : &b->lo) = x[1];
    double p[3][2], q[3][2], turn;
    parallel_at(a, x[0], p, &turn);
    parallel_at(b, x[1], q, &turn);
    return a->lo < a->hi && b->lo < b->hi &&
           taut_hypot(p[0][0] - q[0][0], p[0][1] - q[0][1]) <= no_length * fmax(a->width, b->width);
}

typedef struct corner {
    double at[3][2]; /* places between the end of one edge and the beginning of the next */
    int count, own;  /* how many; those of the first edge */
} corner;

/* A place of the line at + x way. */
static void on_line(const double line[2][2], double x, double out[2])
{
    for (int d = 0; d < 2; d++) {
        out[d] = line[0][d] + x * line[1][d];
    }
}

/* How far along a line it meets another one. */
static double meets(const double line[2][2], const double place[2], const double way[2])
{
    const double det = line[1][0] * -way[1] + line[1][1] * way[0];
    return ((place[0] - line[0][0]) * -way[1] + (place[1] - line[0][1]) * way[0]) / det;
}

/* Cuts a parallel curve where it crosses a line next to its end or its beginning. */
static int cut_at(edge *e, int is_back, int at_end, const double line[2][2])
{
    double *x = at_end != is_back ? &e->hi : &e->lo, y[3][2], turn;
    for (int round = 0; round < ROUNDS; round++) {
        parallel_at(e, *x, y, &turn);
        const double off =
            (y[0][0] - line[0][0]) * line[1][1] - (y[0][1] - line[0][1]) * line[1][0];
        const double slope = y[1][0] * line[1][1] - y[1][1] * line[1][0];
        const double step = -off / slope;
        if (!(fabs(step) > 1e-15)) {
            break;
        }
        *x = fmin(fmax(*x + step, 0), 1);
    }
    look_along(e, is_back, at_end, at_end ? e->end : e->begin);
    return e->lo < e->hi;
}

/* A corner that points outwards: `tip` of the edges themselves, ways of them there. */
static int turn_corner(edge *a, edge *b, const int back[2], const double tip[2],
                       taut_pattern_corner kind, corner *c)
{
    const double(*from)[2] = (const double(*)[2])a->end, (*to)[2] = (const double(*)[2])b->begin;
    const double sine = a->end[1][0] * b->begin[1][1] - a->end[1][1] * b->begin[1][0];
    const double most =
        (kind == TAUT_PATTERN_SQUARE ? square_most : mitre_most) * fmax(a->width, b->width);
    double out[2] = {a->end[1][0] - b->begin[1][0], a->end[1][1] - b->begin[1][1]}, mitre[2];

    *c = (corner){.count = 0};
    if (fabs(sine) < straight_on) {
        return 1; /* straight on: from one to the other */
    }
    const double on[2] = {meets(from, b->begin[0], b->begin[1]), meets(to, a->end[0], a->end[1])};
    if (on[0] < 0 || on[1] > 0) { /* more is left along one than the other: that one ends before */
        return on[0] < 0 ? cut_at(a, back[0], 1, to) : cut_at(b, back[1], 0, from);
    }
    on_line(from, on[0], mitre);
    const double size = taut_hypot(out[0], out[1]);
    const double far = ((mitre[0] - tip[0]) * out[0] + (mitre[1] - tip[1]) * out[1]) / size;
    if (far <= most) {
        memcpy(c->at[0], mitre, sizeof mitre);
        c->count = c->own = 1;
        return 1;
    }
    const double across[2] = {-out[1], out[0]};
    const double place[2] = {tip[0] + most * out[0] / size, tip[1] + most * out[1] / size};
    const double x = meets(from, place, across), y = meets(to, place, across);
    on_line(from, fmax(x, 0), c->at[0]);
    on_line(to, fmin(y, 0), c->at[1]);
    c->count = 2;
    c->own = 1;
    return 1;
}

/* The allowance of a seam folded over covers the allowance of the border: cut along the border's mirror image, and along the seam as far
 * as the border is cut. */
static void mirror_corner(const edge *seam, const double seam_line[2][2], edge *border,
                          int border_is_back, int seam_is_first, corner *c)
{
    const double(*from)[2] = (const double(*)[2])(seam_is_first ? border->begin : border->end);
    const double *way = seam_line[1];
    const edge before = *border;
    double foot[2], tip[2];
    double along = meets(from, seam_line[0], way); /* on from where the border begins */
    if ((seam_is_first ? along > 0 : along < 0) &&
        !cut_at(border, border_is_back, !seam_is_first, seam_line)) {
        *border = before;
        return;
    }
    on_line(seam_line, meets(seam_line, from[0], from[1]), foot);
    along = 2 * (from[1][0] * way[0] + from[1][1] * way[1]);
    const double image[2] = {along * way[0] - from[1][0], along * way[1] - from[1][1]};
    const double(*line)[2] = seam_is_first ? seam->end : seam->begin;
    const double x = meets(line, foot, image);
    on_line(line, x, tip);
    if (!isfinite(x) || (seam_is_first ? x < 0 : x > 0)) {
        *border = before;
        return;
    }
    memcpy(c->at[seam_is_first ? 0 : 1], tip, sizeof tip);
    memcpy(c->at[seam_is_first ? 1 : 0], foot, sizeof foot);
    c->count = 2;
    c->own = 1;
}

/* ---- the whole ---- */

typedef struct build {
    edge edges[TAUT_FLAT_EDGES];
    corner corners[TAUT_FLAT_EDGES]; /* after each edge */
    taut_pattern_part parts[PARTS];
    int count;
    double width; /* the largest */
    taut_arena *arena;
} build;

static void add_part(build *b, const taut_curve *curve, int is_back, double begin, double end)
{
    b->parts[b->count++] = (taut_pattern_part){curve, is_back, begin, end};
}

/* Straight from place to place, between two parameters. */
static taut_status add_straight(build *b, int count, const double (*at)[2], double begin,
                                double end)
{
    for (int k = 0; k + 1 < count; k++) {
        const taut_curve *line = NULL;
        if (taut_pattern_straight(at[k], at[k + 1], b->arena, &line) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        add_part(b, line, 0, begin + (end - begin) * k / (count - 1),
                 k + 2 < count ? begin + (end - begin) * (k + 1) / (count - 1) : end);
    }
    return TAUT_OK;
}

/* The places of a corner before or after the edge's own curve that are apart from it. */
static int places_of(const build *b, int e, int is_after, double at[4][2])
{
    const corner *c = &b->corners[is_after ? e : (e + TAUT_FLAT_EDGES - 1) % TAUT_FLAT_EDGES];
    const edge *one = &b->edges[e];
    const int first = is_after ? 0 : c->own > 0 ? c->own - 1 : 0;
    const int last = is_after ? c->own : c->count;
    int n = 0;
    if (is_after) {
        memcpy(at[n++], one->end[0], sizeof at[0]);
    }
    for (int k = first; k < last; k++) {
        memcpy(at[n++], c->at[k], sizeof at[0]);
    }
    if (!is_after && c->count == 0) { /* straight on, or cut: from the edge before */
        memcpy(at[n++], b->edges[(e + TAUT_FLAT_EDGES - 1) % TAUT_FLAT_EDGES].end[0], sizeof at[0]);
    }
    if (!is_after) {
        memcpy(at[n++], one->begin[0], sizeof at[0]);
    }
    int kept = 1;
    for (int k = 1; k < n; k++) { /* those that are not where the one before is */
        if (taut_hypot(at[k][0] - at[kept - 1][0], at[k][1] - at[kept - 1][1]) >
            no_length * b->width) {
            memcpy(at[kept++], at[k], sizeof at[0]);
        }
    }
    return kept;
}

static taut_status add_edge(build *b, int e)
{
    const double begin = e + corner_share, end = e + 1 - corner_share;
    double before[4][2], after[4][2];
    const int n = places_of(b, e, 0, before), m = places_of(b, e, 1, after);
    const taut_curve *curve = b->edges[e].curve;
    const int is_own = b->edges[e].width == 0 && b->edges[e].lo == 0 && b->edges[e].hi == 1;
    taut_status status =
        is_own ? TAUT_OK : parallel(&b->edges[e], off_most * b->width, b->arena, &curve);
    if (status == TAUT_OK) {
        status = add_straight(b, n, (const double(*)[2])before, e, begin);
    }
    if (status == TAUT_OK) {
        add_part(b, curve, taut_pattern_edge_is_back[e], n > 1 ? begin : e, m > 1 ? end : e + 1);
        status = add_straight(b, m, (const double(*)[2])after, end, e + 1);
    }
    return status;
}

/* The edge itself at its end or its beginning, the way around. */
static void own_line(const edge *e, int is_back, int at_end, double out[2][2])
{
    edge bare = *e;
    bare.width = 0;
    bare.lo = 0;
    bare.hi = 1;
    look_along(&bare, is_back, at_end, out);
}

static taut_status fail_corner(const taut_pattern_piece *piece, const edge *a, const edge *b,
                               taut_error *error)
{
    return taut_fail(error, TAUT_NO_SOLUTION, "allowance", "/allowance",
                     ldexp(fmax(a->width, b->width), piece->carrier->scale), taut_none,
                     "the allowances of piece %s do not meet at a corner: leave less", piece->name);
}

static taut_status make_corner(build *b, int e, const taut_pattern_piece *piece,
                               const taut_pattern_margin *margin, taut_pattern_corner kind,
                               taut_error *error)
{
    const int next = (e + 1) % TAUT_FLAT_EDGES;
    const int back[2] = {taut_pattern_edge_is_back[e], taut_pattern_edge_is_back[next]};
    edge *a = &b->edges[e], *c = &b->edges[next];
    double lines[2][2][2];
    own_line(a, back[0], 1, lines[0]);
    own_line(c, back[1], 0, lines[1]);
    const double sine = lines[0][1][0] * lines[1][1][1] - lines[0][1][1] * lines[1][1][0];

    if (sine < -straight_on) {
        b->corners[e] = (corner){.count = 0};
        return cross(a, c, back[0], back[1]) ? TAUT_OK : fail_corner(piece, a, c, error);
    }
    look_along(a, back[0], 1, a->end);
    look_along(c, back[1], 0, c->begin);
    if (!turn_corner(a, c, back, lines[0][0], kind, &b->corners[e])) {
        return fail_corner(piece, a, c, error);
    }
    /* between a seam and a border */
    const int seam = taut_pattern_is_sewn(piece, e) ? e : next;
    const int is_seam = taut_pattern_is_sewn(piece, e) != taut_pattern_is_sewn(piece, next);
    if (kind == TAUT_PATTERN_MIRROR && is_seam && margin->width[seam] > 0) {
        mirror_corner(seam == e ? a : c, (const double(*)[2])lines[seam == e ? 0 : 1],
                      seam == e ? c : a, seam == e ? back[1] : back[0], seam == e, &b->corners[e]);
    }
    return TAUT_OK;
}

/* A tip as an edge of hardly any length, square to the way in the middle of both sides, and so placed that its parallel lies between
 * theirs. */
static taut_status open_tip(const build *b, int e, taut_arena *arena, const taut_curve **curve)
{
    const int is_end = e == TAUT_FLAT_END;
    double way[2] = {0, 0}, tip[2], lines[2][2][2], at[2];
    for (int side = 0; side < 2; side++) { /* along the piece */
        const edge *one = &b->edges[side == 0 ? TAUT_FLAT_RIGHT : TAUT_FLAT_LEFT];
        const double out = side == 0 ? one->width : -one->width;
        double y[2][3];
        taut_curve_eval(one->curve, is_end, 1, y[0]);
        const double speed = taut_hypot(y[1][0], y[1][1]);
        for (int d = 0; d < 2; d++) {
            lines[side][1][d] = y[1][d] / speed;
            way[d] += y[1][d] / speed;
            tip[d] = y[0][d];
        }
        lines[side][0][0] = tip[0] + out * lines[side][1][1]; /* of the parallel */
        lines[side][0][1] = tip[1] - out * lines[side][1][0];
    }
    const double length = taut_hypot(way[0], way[1]);
    const double across[2] = {-way[1] / length, way[0] / length}; /* from right to left */
    const double back = (is_end ? 1 : -1) * b->edges[e].width / length;
    const double line[2][2] = {{tip[0] + back * way[0], tip[1] + back * way[1]},
                               {across[0], across[1]}};
    for (int side = 0; side < 2; side++) {
        at[side] = meets(line, lines[side][0], lines[side][1]);
    }
    const double middle = (at[0] + at[1]) / 2, half = tip_share * fabs(at[1] - at[0]);
    const double ends[2][2] = {
        {tip[0] + (middle - half) * across[0], tip[1] + (middle - half) * across[1]},
        {tip[0] + (middle + half) * across[0], tip[1] + (middle + half) * across[1]}};
    return taut_pattern_straight(ends[0], ends[1], arena, curve);
}

taut_status taut_pattern_leave(const taut_pattern_piece *piece, const taut_pattern_margin *margin,
                               taut_pattern_corner corner_kind, taut_arena *arena,
                               taut_pattern_outline *outline, taut_error *error)
{
    build b = {.arena = arena};
    taut_status status = TAUT_OK;

    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        b.width = fmax(b.width, margin->width[e]);
        b.edges[e] = (edge){.curve = outline->edges[e],
                            .width = margin->width[e],
                            .sign = taut_pattern_edge_is_back[e] ? -1 : 1,
                            .hi = 1};
    }
    if (!(b.width > 0)) {
        return TAUT_OK;
    }
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        if (piece->bounds[e].is_point && open_tip(&b, e, arena, &b.edges[e].curve) != TAUT_OK) {
            return taut_fail_memory(error);
        }
    }
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        const double width = margin->width[e], size = piece->carrier->size;
        if (width > 0 && (!(width >= least_size * size) || !(width <= most_size * size))) {
            return taut_fail(error, TAUT_BAD_INPUT, "allowance", "/allowance",
                             ldexp(width, piece->carrier->scale),
                             ldexp(most_size * size, piece->carrier->scale),
                             "found an allowance of %.6g, expected 0, or from a millionth of the "
                             "surface's size to ten times it",
                             ldexp(width, piece->carrier->scale));
        }
    }
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        double at = 0;
        const double most = largest_of(&b.edges[e], &at);
        if (!(b.edges[e].width <= most)) {
            return fail_radius(piece, e, &b.edges[e], most, at, error);
        }
    }
    for (int e = 0; status == TAUT_OK && e < TAUT_FLAT_EDGES; e++) {
        status = make_corner(&b, e, piece, margin, corner_kind, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) { /* corners that point inwards have cut them */
        look_along(&b.edges[e], taut_pattern_edge_is_back[e], 0, b.edges[e].begin);
        look_along(&b.edges[e], taut_pattern_edge_is_back[e], 1, b.edges[e].end);
    }
    for (int e = 0; status == TAUT_OK && e < TAUT_FLAT_EDGES; e++) {
        status = add_edge(&b, e);
    }
    if (status == TAUT_OK) {
        status = taut_pattern_join(b.count, b.parts, arena, &outline->cut);
    }
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_pattern_outline_bound(outline);
    return TAUT_OK;
}
