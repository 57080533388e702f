/* apart.c -- proof that no two parts of an axis are too near each other for a pipe of radius a.
 *
 * A tube of radius a about a curve of curvature below 1 / a cuts itself only where a chord of at
 * most 2 a is at right angles to the curve at both its ends, or at one where the other is a free end
 * ([WangBai2018] section 4.4). The axis, its straight pipes included, is halved into parts, each
 * within `off` of the segment between its ends and with its tangents in a cone. A pair of parts is
 * done with when
 *     their segments are farther apart than 2 a and what the parts are off them,
 *     no chord between them is at right angles to a tangent of both, or
 *     they are one, or meet, and all their tangents are in one cone of less than 45 degrees half
 *     angle: chords are in the same cone, and less than a right angle from any of them.
 * What is left when parts are as small as rounding lets them be is not proved, and is a pair of
 * places to look at.
 */
#include "certify/common/bernstein.h"
#include "certify/pipe/axis.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

enum { DEPTH = 46, VISITS = 400000, VISITS_PER_PIECE = 4000, GAUSS = 12, PANELS = 64, STEPS = 30 };

static const double slack = 1e-12; /* of cones */

/* A part of the axis. */
typedef struct part {
    int degree;
    double points[TAUT_PIPE_PIECE_DEGREE + 1][3];
    double lo, hi;        /* parameters on its piece, */
    int piece;            /* in the order of flow */
    double off, size;     /* from the segment between its ends; half its length and off */
    double mean[3], cone; /* of its tangents: unit, and the half angle about it */
    int depth;
} part;

typedef struct prover {
    const taut_pipe_line *line;
    part *parts; /* the pieces, whole */
    int count;
    double near;    /* 2 a, and what rounding adds */
    double rounded; /* of a distance */
    long long left; /* pairs that may still be looked at */
    taut_pipe_apart *out;
} prover;

static double angle_between(const double a[3], const double b[3])
{
    double across[3];
    taut_cross(a, b, across);
    return taut_atan2(taut_norm(across), taut_dot(a, b));
}

static double clamp(double x)
{
    return fmin(1, fmax(0, x));
}

/* The distance of x from the segment p, q. */
static double point_to_segment(const double x[3], const double p[3], const double q[3])
{
    double way[3], from[3];
    taut_difference(q, p, way);
    taut_difference(x, p, from);
    const double square = taut_dot(way, way);
    taut_add_scaled(-(square > 0 ? clamp(taut_dot(from, way) / square) : 0), way, from);
    return taut_norm(from);
}

/* The distance of two segments: between an end of one and the other, or inside both, where their
 * lines are nearest. */
static double segment_to_segment(const double a[2][3], const double b[2][3])
{
    double d[3], e[3], w[3];
    double least =
        fmin(fmin(point_to_segment(a[0], b[0], b[1]), point_to_segment(a[1], b[0], b[1])),
             fmin(point_to_segment(b[0], a[0], a[1]), point_to_segment(b[1], a[0], a[1])));
    taut_difference(a[1], a[0], d);
    taut_difference(b[1], b[0], e);
    taut_difference(b[0], a[0], w);
    const double dd = taut_dot(d, d), de = taut_dot(d, e), ee = taut_dot(e, e);
    const double det = dd * ee - de * de;
    if (det > 0) {
        const double s = clamp((taut_dot(d, w) * ee - de * taut_dot(e, w)) / det);
        const double r = clamp((s * de - taut_dot(e, w)) / (ee > 0 ? ee : 1));
        double apart[3] = {w[0], w[1], w[2]};
        taut_add_scaled(r, e, apart);
        taut_add_scaled(-s, d, apart);
        least = fmin(least, taut_norm(apart));
    }
    return least;
}

/* off, size, mean and cone of its points. */
static void enclose(part *p)
{
    const int n = p->degree;
    double chord[3], length = 0;
    taut_difference(p->points[n], p->points[0], chord);
    length = taut_norm(chord);
    p->off = p->cone = 0;
    for (int k = 0; k < 3; k++) {
        p->mean[k] = length > 0 ? chord[k] / length : 0;
    }
    for (int i = 1; i < n; i++) {
        p->off = fmax(p->off, point_to_segment(p->points[i], p->points[0], p->points[n]));
    }
    for (int i = 0; i < n; i++) {
        double e[3];
        taut_difference(p->points[i + 1], p->points[i], e);
        p->cone = fmax(p->cone, angle_between(e, p->mean));
    }
    p->cone = length > 0 ? p->cone : TAUT_PI;
    p->size = 0.5 * length + p->off;
}

static void halve(const part *whole, part halves[2])
{
    halves[0] = halves[1] = *whole;
    taut_certify_halve(whole->degree, 3, &whole->points[0][0], &halves[0].points[0][0],
                       &halves[1].points[0][0]);
    halves[0].hi = halves[1].lo = 0.5 * (whole->lo + whole->hi);
    for (int k = 0; k < 2; k++) {
        halves[k].depth++;
        enclose(&halves[k]);
    }
}

/* Do they meet, one after the other? */
static int meet(const prover *p, const part *a, const part *b)
{
    if (a->piece == b->piece) {
        return a->hi == b->lo || b->hi == a->lo;
    }
    const part *first = a->piece < b->piece ? a : b, *second = a->piece < b->piece ? b : a;
    const int round = p->line->closed && first->piece == 0 && second->piece == p->count - 1;
    return (second->piece == first->piece + 1 && first->hi == 1 && second->lo == 0) ||
           (round && first->lo == 0 && second->hi == 1);
}

/* Are all tangents of both in one cone of less than 45 degrees half angle? */
static int turn_little(const part *a, const part *b)
{
    double mean[3] = {a->mean[0] + b->mean[0], a->mean[1] + b->mean[1], a->mean[2] + b->mean[2]};
    const double half =
        fmax(angle_between(mean, a->mean) + a->cone, angle_between(mean, b->mean) + b->cone);
    return taut_norm(mean) > 0 && half < 0.25 * TAUT_PI - slack;
}

static void centre_of(const part *p, double centre[3])
{
    for (int k = 0; k < 3; k++) {
        centre[k] = 0.5 * (p->points[0][k] + p->points[p->degree][k]);
    }
}

/* Can a chord from a to b, within `spread` of `chord`, be at right angles to a tangent of p? */
static int may_be_normal(const part *p, const double chord[3], double spread)
{
    return fabs(angle_between(chord, p->mean) - 0.5 * TAUT_PI) <= p->cone + spread + slack;
}

/* Is there nothing in the way of a pipe between the parts? `a` may be a point: of degree 0. */
static int are_done(const prover *p, const part *a, const part *b)
{
    const double ends[2][2][3] = {
        {{a->points[0][0], a->points[0][1], a->points[0][2]},
         {a->points[a->degree][0], a->points[a->degree][1], a->points[a->degree][2]}},
        {{b->points[0][0], b->points[0][1], b->points[0][2]},
         {b->points[b->degree][0], b->points[b->degree][1], b->points[b->degree][2]}}};
    double from[3], to[3], chord[3], distance = 0, spread = 0;
    if (segment_to_segment(ends[0], ends[1]) - a->off - b->off - p->rounded > p->near) {
        return 1;
    }
    centre_of(a, from);
    centre_of(b, to);
    taut_difference(to, from, chord);
    distance = taut_norm(chord);
    if (a->size + b->size + p->rounded >= distance) {
        return 0;
    }
    spread = taut_asin((a->size + b->size + p->rounded) / distance);
    return !((a->degree == 0 || may_be_normal(a, chord, spread)) &&
             may_be_normal(b, chord, spread));
}

static void fail(prover *p, const part *a, const part *b)
{
    taut_pipe_apart *const out = p->out;
    out->proved = 0;
    out->piece[0] = a->piece;
    out->piece[1] = b->piece;
    out->at[0] = 0.5 * (a->lo + a->hi);
    out->at[1] = 0.5 * (b->lo + b->hi);
}

static void visit(prover *p, const part *a, const part *b)
{
    const int same = a->piece == b->piece && a->lo == b->lo && a->hi == b->hi;
    part halves[2];
    if (!p->out->proved) {
        return;
    }
    if (same || meet(p, a, b)) {
        if (turn_little(a, b)) {
            return;
        }
    } else if (are_done(p, a, b)) {
        return;
    }
    if (p->left-- <= 0 || (a->depth >= DEPTH && b->depth >= DEPTH)) {
        fail(p, a, b);
        return;
    }
    if (same) {
        halve(a, halves);
        visit(p, &halves[0], &halves[0]);
        visit(p, &halves[0], &halves[1]);
        visit(p, &halves[1], &halves[1]);
    } else if (a->degree > 0 && (b->depth >= DEPTH || (a->size > b->size && a->depth < DEPTH))) {
        halve(a, halves);
        visit(p, &halves[0], b);
        visit(p, &halves[1], b);
    } else {
        halve(b, halves);
        visit(p, a, &halves[0]);
        visit(p, a, &halves[1]);
    }
}

/* A free end against part b: the chord is at right angles to b alone. */
static void visit_end(prover *p, const part *end, const part *b)
{
    part halves[2];
    const int at_end = b->piece == end->piece && (b->lo == end->lo || b->hi == end->lo);
    if (!p->out->proved || (at_end ? b->cone < 0.25 * TAUT_PI - slack : are_done(p, end, b))) {
        return;
    }
    if (p->left-- <= 0 || b->depth >= DEPTH) {
        fail(p, end, b);
        return;
    }
    halve(b, halves);
    visit_end(p, end, &halves[0]);
    visit_end(p, end, &halves[1]);
}

/* The arc length from one place to the other, of the same piece or of later ones. */
static double length_between(const prover *p, const int piece[2], const double at[2])
{
    double nodes[GAUSS], weights[GAUSS], length = 0;
    taut_gauss_rule(GAUSS, nodes, weights);
    for (int i = piece[0]; i <= piece[1]; i++) {
        const taut_pipe_piece one = {.degree = p->parts[i].degree};
        taut_pipe_piece whole = one;
        const double lo = i == piece[0] ? at[0] : 0, hi = i == piece[1] ? at[1] : 1;
        memcpy(whole.points, p->parts[i].points, sizeof whole.points);
        for (int k = 0; k < PANELS * GAUSS; k++) {
            const double t = (k / GAUSS + 0.5 * (1 + nodes[k % GAUSS])) / PANELS;
            double d[2][3];
            taut_pipe_piece_eval(&whole, lo + (hi - lo) * t, 1, d);
            length += (hi - lo) * 0.5 / PANELS * weights[k % GAUSS] * taut_norm(d[1]);
        }
    }
    return length;
}

static void evaluate(const prover *p, int i, double at, double x[3][3])
{
    taut_pipe_piece piece = {.degree = p->parts[i].degree};
    memcpy(piece.points, p->parts[i].points, sizeof piece.points);
    taut_pipe_piece_eval(&piece, at, 2, x);
}

/* Down to where the two places are nearest to each other, as long as that brings them nearer; the
 * distance there. */
static double approach(const prover *p, const int piece[2], double at[2])
{
    double x[3][3], y[3][3], distance = 0;
    evaluate(p, piece[0], at[0], x);
    evaluate(p, piece[1], at[1], y);
    distance = taut_distance(x[0], y[0]);
    for (int step = 0; step < STEPS; step++) {
        double move[2], next[2];
        taut_pipe_pair_step((const double(*)[3])x, (const double(*)[3])y, move);
        for (int k = 0; k < 2; k++) {
            next[k] = isfinite(move[k]) ? clamp(at[k] + move[k]) : at[k];
        }
        evaluate(p, piece[0], next[0], x);
        evaluate(p, piece[1], next[1], y);
        if (!(taut_distance(x[0], y[0]) < distance) ||
            (piece[0] == piece[1] && next[0] >= next[1])) {
            break;
        }
        distance = taut_distance(x[0], y[0]);
        memcpy(at, next, sizeof next);
    }
    return distance;
}

/* What is left is told: how far apart the places are, and how far along the axis. */
static void describe(prover *p)
{
    taut_pipe_apart *const out = p->out;
    if (out->piece[0] > out->piece[1] ||
        (out->piece[0] == out->piece[1] && out->at[0] > out->at[1])) {
        const int piece = out->piece[0];
        const double at = out->at[0];
        out->piece[0] = out->piece[1];
        out->at[0] = out->at[1];
        out->piece[1] = piece;
        out->at[1] = at;
    }
    out->distance = approach(p, out->piece, out->at);
    out->way = length_between(p, out->piece, out->at);
    out->from =
        length_between(p, (const int[2]){0, out->piece[0]}, (const double[2]){0, out->at[0]}) -
        (p->line->run ? 0 : 2 * p->parts[0].size);
}

static void set_part(part *p, int piece, int degree, const double (*points)[3])
{
    *p = (part){.degree = degree, .hi = 1, .piece = piece};
    memcpy(p->points, points, ((size_t)degree + 1) * sizeof *points);
    enclose(p);
}

/* Straight pipes as parts, as far as any point of the axis has its foot there. */
static void set_tails(prover *p)
{
    const taut_pipe_line *line = p->line;
    double reach = 0;
    for (int i = 0; i < line->count; i++) {
        for (int k = 0; k <= line->pieces[i].degree; k++) {
            reach =
                fmax(reach, taut_distance(line->pieces[i].points[k], line->pieces[0].points[0]));
        }
    }
    for (int side = 0; side < 2; side++) {
        const taut_pipe_piece *next = &line->pieces[side == 0 ? 0 : line->count - 1];
        const double *joint = next->points[side == 0 ? 0 : next->degree];
        const double length = isfinite(line->lengths[side]) ? line->lengths[side] : 4 * reach;
        double ends[2][3];
        for (int k = 0; k < 3; k++) {
            ends[side][k] = joint[k] + (side == 0 ? -length : length) * line->tangent[side][k];
            ends[1 - side][k] = joint[k];
        }
        set_part(&p->parts[side == 0 ? 0 : p->count - 1], side == 0 ? 0 : p->count - 1, 1,
                 (const double(*)[3])ends);
    }
}

static void go_over_ends(prover *p)
{
    for (int side = 0; side < 2 && !p->line->closed; side++) {
        const part *last = &p->parts[side == 0 ? 0 : p->count - 1];
        part end = {.piece = last->piece, .lo = side, .hi = side};
        memcpy(end.points[0], last->points[side == 0 ? 0 : last->degree], sizeof end.points[0]);
        for (int i = 0; i < p->count && (p->line->run || isfinite(p->line->lengths[side])); i++) {
            visit_end(p, &end, &p->parts[i]);
        }
    }
}

taut_status taut_pipe_prove_apart(const taut_pipe_line *line, double radius, taut_pipe_apart *out)
{
    const int before = line->run ? 0 : 1; /* straight pipes of their own, at either end */
    prover p = {.line = line, .count = line->count + 2 * before, .out = out};
    double size = 1;
    *out = (taut_pipe_apart){.proved = 1, .distance = INFINITY};
    p.parts = taut_arena_take(line->arena, (size_t)p.count, sizeof *p.parts);
    if (p.parts == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < line->count; i++) {
        set_part(&p.parts[i + before], i + before, line->pieces[i].degree,
                 (const double(*)[3])line->pieces[i].points);
    }
    if (!line->run) {
        set_tails(&p);
    }
    for (int i = 0; i < p.count; i++) {
        size = fmax(size, p.parts[i].size);
    }
    p.rounded = 16 * TAUT_UNIT_ROUNDOFF * size + 2 * line->noise;
    p.near = 2 * radius * (1 + 1e-11);
    p.left = VISITS + (long long)VISITS_PER_PIECE * p.count;
    for (int i = 0; i < p.count && out->proved; i++) {
        for (int j = i; j < p.count; j++) {
            visit(&p, &p.parts[i], &p.parts[j]);
        }
    }
    go_over_ends(&p);
    if (!out->proved) {
        describe(&p);
    }
    return TAUT_OK;
}
