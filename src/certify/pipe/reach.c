/* reach.c -- the largest radius about a composite axis, by bounds on pairs of its pieces.
 *
 *     rho = min( 1 / kappa_max,  1/2 min |c(s) - c(s')| ),   over |s - s'| >= pi / kappa_max
 *
 * ([WangBai2018] section 4.4). The axis, its straight pipes included, is halved into a tree of
 * pieces, each in a ball and with its tangents in a cone. A pair of pieces is dropped when
 *     its balls are farther apart than the best pair seen,
 *     no two points of it are pi / kappa_max apart along the axis (either way round), or
 *     no chord between its balls is at right angles to a tangent of both cones,
 * for the least distance is taken at such a chord, or at a free end. Pairs of leaves that are left
 * are solved for the least distance by Newton's method.
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

enum { DEPTH = 7, LEAVES = 1 << DEPTH, NODES = 2 * LEAVES, GAUSS = 8, STEPS = 30 };

static const double slack = 1e-12; /* of cones and of lengths: rounding at unit size */

/* A piece of the tree. Node 1 is the whole, 2k and 2k + 1 the halves of node k. */
typedef struct node {
    double centre[3], radius;
    double mean[3], cone; /* unit, and the half angle about it */
    double from, to;      /* arc length from the first point of the curve */
} node;

typedef struct tree {
    taut_pipe_piece piece; /* tails are pieces of degree 1 */
    node nodes[NODES];
    double gauss_nodes[GAUSS], gauss_weights[GAUSS];
} tree;

typedef struct finder {
    tree *trees;
    int count;
    double apart; /* pi / kappa_max */
    double round; /* the length of a closed axis; INFINITY: it is open */
    double best;
    double binding[2];
    double ends[2][3]; /* free ends of finite pipes */
    double at_end[2];  /* their arc lengths */
} finder;

static void offer_pair(finder *f, double distance, double from, double to)
{
    const double way = fmin(fabs(to - from), f->round - fabs(to - from));
    if (distance < f->best && way >= f->apart * (1 - slack)) {
        f->best = distance;
        f->binding[0] = fmin(from, to);
        f->binding[1] = fmax(from, to);
    }
}

/* Ball and cone of Bezier points: both hold the piece, by the hull property. */
static void enclose_points(node *n, int degree, const double (*points)[3])
{
    double chord[3], length = 0;
    for (int k = 0; k < 3; k++) {
        n->centre[k] = 0.5 * (points[0][k] + points[degree][k]);
    }
    taut_difference(points[degree], points[0], chord);
    length = taut_norm(chord);
    n->radius = n->cone = 0;
    for (int k = 0; k < 3; k++) {
        n->mean[k] = length > 0 ? chord[k] / length : 0;
    }
    for (int i = 0; i <= degree; i++) {
        n->radius = fmax(n->radius, taut_distance(points[i], n->centre));
    }
    for (int i = 0; i < degree; i++) {
        double e[3], across[3];
        taut_difference(points[i + 1], points[i], e);
        taut_cross(e, n->mean, across);
        n->cone = fmax(n->cone, taut_atan2(taut_norm(across), taut_dot(e, n->mean)));
    }
    n->cone = length > 0 ? n->cone : TAUT_PI;
}

static void grow_tree(tree *t, int at, const double (*points)[3])
{
    const int degree = t->piece.degree;
    double halves[2][TAUT_PIPE_PIECE_DEGREE + 1][3];
    enclose_points(&t->nodes[at], degree, points);
    taut_certify_halve(degree, 3, &points[0][0], &halves[0][0][0], &halves[1][0][0]);
    for (int upper = 0; upper < 2 && at < LEAVES; upper++) {
        grow_tree(t, 2 * at + upper, (const double(*)[3])halves[upper]);
    }
}

/* The length from t = lo to hi. */
static double length_of(const tree *t, double lo, double hi)
{
    const double *const nodes = t->gauss_nodes, *const weights = t->gauss_weights;
    double length = 0;
    for (int i = 0; i < GAUSS; i++) {
        double d[2][3];
        taut_pipe_piece_eval(&t->piece, 0.5 * (lo + hi) + 0.5 * (hi - lo) * nodes[i], 1, d);
        length += 0.5 * (hi - lo) * weights[i] * taut_norm(d[1]);
    }
    return length;
}

/* Arc lengths of all nodes, from that of the start; returns that of the end. */
static double measure_tree(tree *t, double start)
{
    for (int i = 0; i < LEAVES; i++) {
        node *leaf = &t->nodes[LEAVES + i];
        leaf->from = start;
        start += length_of(t, (double)i / LEAVES, (i + 1.0) / LEAVES);
        leaf->to = start;
    }
    for (int i = LEAVES - 1; i > 0; i--) {
        t->nodes[i].from = t->nodes[2 * i].from;
        t->nodes[i].to = t->nodes[2 * i + 1].to;
    }
    return start;
}

static double angle_between(const double a[3], const double b[3])
{
    double across[3];
    taut_cross(a, b, across);
    return taut_atan2(taut_norm(across), taut_dot(a, b));
}

/* Can a chord within `spread` of `chord` be at right angles to a tangent of the node? */
static int may_be_normal(const node *n, const double chord[3], double spread)
{
    return fabs(angle_between(chord, n->mean) - 0.5 * TAUT_PI) <= n->cone + spread + slack;
}

static int may_bind(const finder *f, const node *a, const node *b, int a_is_free)
{
    double chord[3], distance = 0, spread = 0;
    taut_difference(b->centre, a->centre, chord);
    distance = taut_norm(chord);
    if (distance - a->radius - b->radius >= f->best ||
        fmax(a->to, b->to) - fmin(a->from, b->from) < f->apart * (1 - slack) ||
        f->round - (fmax(a->from, b->from) - fmin(a->to, b->to)) < f->apart * (1 - slack)) {
        return 0;
    }
    if (a->radius + b->radius >= distance) {
        return 1;
    }
    spread = taut_asin((a->radius + b->radius) / distance);
    return (a_is_free || may_be_normal(a, chord, spread)) && may_be_normal(b, chord, spread);
}

static double arc_length(const tree *t, double at)
{
    const int i = (int)fmin(LEAVES - 1, floor(at * LEAVES));
    return t->nodes[LEAVES + i].from + length_of(t, (double)i / LEAVES, at);
}

/* Newton's step where |p - q|^2 / 2 is convex, else that of the tangent lines. */
void taut_pipe_pair_step(const double p[3][3], const double q[3][3], double move[2])
{
    double d[3];
    taut_difference(p[0], q[0], d);
    const double g0 = taut_dot(d, p[1]), g1 = -taut_dot(d, q[1]);
    const double pp = taut_dot(p[1], p[1]), qq = taut_dot(q[1], q[1]);
    const double h01 = -taut_dot(p[1], q[1]);
    double h00 = pp + taut_dot(d, p[2]), h11 = qq - taut_dot(d, q[2]);
    if (!(h00 > 0 && h00 * h11 - h01 * h01 > 1e-10 * pp * qq)) {
        h00 = pp * (1 + 1e-6);
        h11 = qq * (1 + 1e-6);
    }
    const double det = h00 * h11 - h01 * h01;
    move[0] = -(h11 * g0 - h01 * g1) / det;
    move[1] = -(h00 * g1 - h01 * g0) / det;
}

/* Steps down |p - q|^2 / 2 from the middles of two leaves, kept near them. What it ends at is a
 * pair of points like any other, so no harm is done where it goes astray. */
static void solve_pair(finder *f, const tree *a, int i, const tree *b, int j)
{
    const double width = 1.0 / LEAVES;
    const double start[2] = {(i + 0.5) * width, (j + 0.5) * width};
    double x[2] = {start[0], start[1]}, moved = 1;
    double p[3][3], q[3][3];

    for (int n = 0; n < STEPS && moved > 1e-15; n++) {
        double move[2];
        taut_pipe_piece_eval(&a->piece, x[0], 2, p);
        taut_pipe_piece_eval(&b->piece, x[1], 2, q);
        taut_pipe_pair_step((const double(*)[3])p, (const double(*)[3])q, move);
        moved = 0;
        for (int k = 0; k < 2 && isfinite(move[k]); k++) {
            const double low = fmax(0, start[k] - 2 * width), high = fmin(1, start[k] + 2 * width);
            const double next = fmin(high, fmax(low, x[k] + move[k]));
            moved += fabs(next - x[k]);
            x[k] = next;
        }
    }
    taut_pipe_piece_eval(&a->piece, x[0], 0, p);
    taut_pipe_piece_eval(&b->piece, x[1], 0, q);
    offer_pair(f, taut_distance(p[0], q[0]), arc_length(a, x[0]), arc_length(b, x[1]));
}

static void visit_pair(finder *f, const tree *a, int i, const tree *b, int j)
{
    const int a_leaf = i >= LEAVES, b_leaf = j >= LEAVES;
    if (!may_bind(f, &a->nodes[i], &b->nodes[j], 0)) {
        return;
    }
    if (a == b && i == j) {
        if (!a_leaf) {
            visit_pair(f, a, 2 * i, b, 2 * j);
            visit_pair(f, a, 2 * i, b, 2 * j + 1);
            visit_pair(f, a, 2 * i + 1, b, 2 * j + 1);
        }
        return;
    }
    if (a_leaf && b_leaf) {
        solve_pair(f, a, i - LEAVES, b, j - LEAVES);
    } else if (b_leaf || (!a_leaf && a->nodes[i].radius > b->nodes[j].radius)) {
        visit_pair(f, a, 2 * i, b, j);
        visit_pair(f, a, 2 * i + 1, b, j);
    } else {
        visit_pair(f, a, i, b, 2 * j);
        visit_pair(f, a, i, b, 2 * j + 1);
    }
}

/* Free end `side` against node j of a piece: the foot of the end there. */
static void visit_end(finder *f, int side, const tree *b, int j)
{
    node end = {.from = f->at_end[side], .to = f->at_end[side]};
    memcpy(end.centre, f->ends[side], sizeof end.centre);
    if (!may_bind(f, &end, &b->nodes[j], 1)) {
        return;
    }
    if (j < LEAVES) {
        visit_end(f, side, b, 2 * j);
        visit_end(f, side, b, 2 * j + 1);
        return;
    }
    double x = (j - LEAVES + 0.5) / LEAVES, q[3][3], d[3];
    for (int step = 0; step < STEPS; step++) {
        taut_pipe_piece_eval(&b->piece, x, 2, q);
        taut_difference(q[0], f->ends[side], d);
        const double slope = taut_dot(q[1], q[1]) + taut_dot(d, q[2]);
        x = fmin(1, fmax(0, x - (slope != 0 ? taut_dot(d, q[1]) / slope : 0)));
    }
    taut_pipe_piece_eval(&b->piece, x, 0, q);
    offer_pair(f, taut_distance(q[0], f->ends[side]), f->at_end[side], arc_length(b, x));
}

/* The straight pipes as pieces: of their length, or as far as any point of the axis has its foot
 * there. */
static void add_tails(const taut_pipe_line *line, finder *f)
{
    double reach = 0;
    for (int i = 0; i < line->count; i++) {
        const taut_pipe_piece *piece = &line->pieces[i];
        for (int k = 0; k <= piece->degree; k++) {
            reach = fmax(reach, taut_distance(piece->points[k], line->pieces[0].points[0]));
        }
    }
    for (int side = 0; side < 2; side++) {
        const taut_pipe_piece *next = &line->pieces[side == 0 ? 0 : line->count - 1];
        const double *joint = next->points[side == 0 ? 0 : next->degree];
        const double length = isfinite(line->lengths[side]) ? line->lengths[side] : 4 * reach;
        tree *t = &f->trees[side == 0 ? 0 : f->count - 1];
        t->piece = (taut_pipe_piece){.degree = 1, .hi = 1};
        for (int k = 0; k < 3; k++) {
            const double far = joint[k] + (side == 0 ? -length : length) * line->tangent[side][k];
            t->piece.points[0][k] = side == 0 ? far : joint[k];
            t->piece.points[1][k] = side == 0 ? joint[k] : far;
            f->ends[side][k] = far;
        }
    }
}

/* Two half lines that come nearest far out: the feet of their common perpendicular. */
static void offer_feet(const taut_pipe_line *line, finder *f, double length)
{
    const double *b = f->trees[f->count - 1].piece.points[0], *a = f->trees[0].piece.points[1];
    double n[3], w[3], square = 0;
    taut_cross(line->tangent[0], line->tangent[1], n);
    square = taut_dot(n, n);
    taut_difference(b, a, w);
    if (square > slack * slack) {
        const double s = -taut_det(w, line->tangent[1], n) / square; /* back along pipe 1 */
        const double r = taut_det(w, line->tangent[0], n) / square;
        if (s >= 0 && r >= 0 && s <= line->lengths[0] && r <= line->lengths[1]) {
            offer_pair(f, fabs(taut_dot(w, n)) / sqrt(square), -s, length + r);
        }
    }
}

/* The ends of a run that is open. */
static void set_ends(const taut_pipe_line *line, finder *f, double length)
{
    for (int side = 0; side < 2; side++) {
        const taut_pipe_piece *piece = &line->pieces[side == 0 ? 0 : line->count - 1];
        memcpy(f->ends[side], piece->points[side == 0 ? 0 : piece->degree], sizeof f->ends[side]);
        f->at_end[side] = side == 0 ? 0 : length;
    }
}

static void find_in_run(const taut_pipe_line *line, finder *f, double length)
{
    for (int i = 0; i < f->count; i++) {
        for (int j = i; j < f->count; j++) {
            visit_pair(f, &f->trees[i], 1, &f->trees[j], 1);
        }
    }
    if (line->closed) {
        return;
    }
    set_ends(line, f, length);
    for (int side = 0; side < 2; side++) {
        for (int i = 0; i < f->count; i++) {
            visit_end(f, side, &f->trees[i], 1);
        }
    }
    offer_pair(f, taut_distance(f->ends[0], f->ends[1]), 0, length);
}

static void find_about_blend(const taut_pipe_line *line, finder *f, double length)
{
    for (int i = 0; i < f->count; i++) {
        for (int j = i; j < f->count; j++) {
            visit_pair(f, &f->trees[i], 1, &f->trees[j], 1);
        }
    }
    for (int side = 0; side < 2; side++) {
        f->at_end[side] = side == 0 ? -line->lengths[0] : length + line->lengths[1];
    }
    for (int side = 0; side < 2; side++) {
        for (int i = 0; i < f->count && isfinite(line->lengths[side]); i++) {
            if (i != (side == 0 ? 0 : f->count - 1)) {
                visit_end(f, side, &f->trees[i], 1);
            }
        }
    }
    if (isfinite(line->lengths[0]) && isfinite(line->lengths[1])) {
        offer_pair(f, taut_distance(f->ends[0], f->ends[1]), f->at_end[0], f->at_end[1]);
    }
    offer_feet(line, f, length);
}

taut_status taut_pipe_bound_reach(const taut_pipe_line *line, taut_pipe_figures *figures)
{
    const int before = line->run ? 0 : 1; /* straight pipes of their own, at either end */
    finder f = {.count = line->count + 2 * before,
                .round = line->closed ? figures->length : INFINITY};
    double length = 0;

    figures->rho = INFINITY;
    figures->by_distance = 0;
    if (!(figures->curvature > 0)) {
        return TAUT_OK;
    }
    f.apart = TAUT_PI / figures->curvature;
    f.best = 2 / figures->curvature;
    f.trees = taut_arena_take(line->arena, (size_t)f.count, sizeof *f.trees);
    if (f.trees == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < line->count; i++) {
        f.trees[i + before].piece = line->pieces[i];
    }
    if (!line->run) {
        add_tails(line, &f);
    }
    for (int i = 0; i < f.count; i++) {
        taut_gauss_rule(GAUSS, f.trees[i].gauss_nodes, f.trees[i].gauss_weights);
        grow_tree(&f.trees[i], 1, (const double(*)[3])f.trees[i].piece.points);
        if (i < before) { /* the curve itself begins at arc length 0 */
            (void)measure_tree(&f.trees[0], -taut_distance(f.trees[0].piece.points[0],
                                                           f.trees[0].piece.points[1]));
        } else {
            length = measure_tree(&f.trees[i], i == before ? 0 : length);
        }
    }
    if (line->run) {
        find_in_run(line, &f, figures->length);
    } else {
        find_about_blend(line, &f, figures->length);
    }
    figures->rho = 0.5 * f.best;
    figures->by_distance = f.best < 2 / figures->curvature;
    memcpy(figures->binding, f.binding, sizeof f.binding);
    return TAUT_OK;
}
