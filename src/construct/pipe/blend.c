#include "construct/pipe/blend.h"

#include "construct/pipe/bend.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/keep.h"
#include "numeric/bernstein.h"

#include <math.h>
#include <string.h>

enum { SEGMENTS_MAX = 100000, ANGLES = 16, LEVEL_MAX = 30, FRAMES_PER_UNIT = 1024, PLACES = 2048 };

/* Of the sine between a ruling and the axis (g2: of the curvature across it, times the radius). */
static const double near_enough = 5e-14;
static const double part_of_way = 1e-3; /* from the end ring, that a point may move */

/* The control points of the unit circle; weights 1 and sqrt(1/2) in turns. */
static const double circle[TAUT_PIPE_RING][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                                 {-1, -1}, {0, -1}, {1, -1}, {1, 0}};

/* The tube while it is cut into segments. */
typedef struct blend_maker {
    const taut_pipe_arc *arc;
    const taut_pipe_binormal *binormal;
    const taut_pipe_profile *profile; /* or NULL: round */
    double radius, tolerance;
    double sharpest; /* parameter of the largest curvature: never stepped over unseen */
    taut_arena *arena;
    int count, room; /* of nodes */
    double *t;
    taut_pipe_normals *normals;
} blend_maker;

static int add_node(blend_maker *m, double t, const taut_pipe_normals *normals)
{
    if (m->count == m->room) {
        const int room = m->room > 0 ? 2 * m->room : 128;
        double *const grown_t = taut_arena_take(m->arena, (size_t)room, sizeof *grown_t);
        taut_pipe_normals *const grown = taut_arena_take(m->arena, (size_t)room, sizeof *grown);
        if (grown_t == NULL || grown == NULL) {
            return 0;
        }
        if (m->count > 0) {
            memcpy(grown_t, m->t, (size_t)m->count * sizeof *grown_t);
            memcpy(grown, m->normals, (size_t)m->count * sizeof *grown);
        }
        m->t = grown_t;
        m->normals = grown;
        m->room = room;
    }
    m->t[m->count] = t;
    m->normals[m->count++] = *normals;
    return 1;
}

/* The frame at t1, or the axes of the ellipse there; u is carried from t0. */
static void carry_frame(const blend_maker *m, double t0, double t1, double u[3],
                        taut_pipe_normals *normals)
{
    taut_pipe_normals frame;
    if (m->binormal != NULL) {
        taut_pipe_frenet(m->arc, m->binormal, t1, normals);
        return;
    }
    if (t1 > t0) {
        taut_pipe_carry(m->arc, t0, t1, (int)ceil(FRAMES_PER_UNIT * (t1 - t0)) + 1, u);
    }
    taut_pipe_bishop(m->arc, t1, u, m->profile != NULL ? &frame : normals);
    if (m->profile != NULL) {
        taut_pipe_profile_at(m->profile, m->arc, t1, &frame, normals);
    }
}

/* A vector at one end of a segment, with its derivatives. */
typedef struct vector_jet {
    const double *x, *d1, *d2;
} vector_jet;

/* Hermite's interpolant on a segment of length h, as a Bezier polygon: cubic, and quintic with
 * second derivatives where the axis has that degree anyway. Returns its degree. */
static int interpolate(const blend_maker *m, vector_jet a, vector_jet b, double h, double (*out)[3])
{
    const int n = m->binormal == NULL && m->arc->degree >= 5 ? 5 : 3;
    for (int k = 0; k < 3; k++) {
        out[0][k] = a.x[k];
        out[1][k] = a.x[k] + h * a.d1[k] / n;
        out[n - 1][k] = b.x[k] - h * b.d1[k] / n;
        out[n][k] = b.x[k];
        if (n == 5) {
            out[2][k] = a.x[k] + 2 * h * a.d1[k] / 5 + h * h * a.d2[k] / 20;
            out[3][k] = b.x[k] - 2 * h * b.d1[k] / 5 + h * h * b.d2[k] / 20;
        }
    }
    return n;
}

/* Of both vectors of the frame. */
static int interpolate_frame(const blend_maker *m, const taut_pipe_normals *n0,
                             const taut_pipe_normals *n1, double h, double (*u)[3], double (*w)[3])
{
    interpolate(m, (vector_jet){n0->u, n0->du, n0->ddu}, (vector_jet){n1->u, n1->du, n1->ddu}, h,
                u);
    return interpolate(m, (vector_jet){n0->w, n0->dw, n0->ddw},
                       (vector_jet){n1->w, n1->dw, n1->ddw}, h, w);
}

/* How far back the circles of a canal surface are; 0 for others. Returns the degree. */
static int interpolate_offset(const blend_maker *m, const taut_pipe_normals *n0,
                              const taut_pipe_normals *n1, double h, double (*c)[3])
{
    static const double none[3] = {0, 0, 0};
    if (m->profile != NULL && m->profile->canal > 0) {
        return interpolate(m, (vector_jet){n0->c, n0->dc, none}, (vector_jet){n1->c, n1->dc, none},
                           h, c);
    }
    return interpolate(m, (vector_jet){none, none, none}, (vector_jet){none, none, none}, h, c);
}

/* The largest distance of X from the tube at a fraction s of a segment, over the radius. With
 * g = c U + s W and e its part along the tangent, the point of the axis nearest to X has moved by
 * a e / (1 - a kappa_n), so that the distance from the axis is a sqrt(g.g - e^2 / (1 - a kappa_n)).
 */
static double round_deviation(const blend_maker *m, double t0, const taut_pipe_normals *n0,
                              double t1, const taut_pipe_normals *n1, double s)
{
    const double h = t1 - t0;
    double u[3], w[3], most = 0;
    double polygon_u[TAUT_PIPE_DEGREE_MAX + 1][3], polygon_w[TAUT_PIPE_DEGREE_MAX + 1][3];
    const int degree = interpolate_frame(m, n0, n1, h, polygon_u, polygon_w);
    taut_pipe_jet jet;

    taut_pipe_arc_jet(m->arc, t0 + s * h, &jet);
    taut_bernstein_point(degree, 3, &polygon_u[0][0], s, u, NULL);
    taut_bernstein_point(degree, 3, &polygon_w[0][0], s, w, NULL);
    for (int k = 0; k < ANGLES; k++) {
        const double c = taut_cos(2 * TAUT_PI * k / ANGLES), z = taut_sin(2 * TAUT_PI * k / ANGLES);
        double g[3], e = 0, turn = 0, square = 0;
        for (int i = 0; i < 3; i++) {
            g[i] = c * u[i] + z * w[i];
        }
        e = taut_dot(g, jet.tangent);
        turn = 1 - m->radius * taut_dot(g, jet.turn) / jet.speed;
        square = taut_dot(g, g) - e * e / fmax(turn, 1e-3);
        most = fmax(most, fabs(sqrt(fmax(square, 0)) - 1));
    }
    return most;
}

/* The same of elliptic sections: no point of X is farther from the ellipse than from the one that
 * has its angle there. u is carried to t0. */
static double profile_deviation(const blend_maker *m, double t0, const double carried[3],
                                const taut_pipe_normals *n0, double t1, const taut_pipe_normals *n1,
                                double s)
{
    const double h = t1 - t0;
    double u[3], w[3], at[3], back[3] = {0, 0, 0}, most = 0;
    double polygon_u[TAUT_PIPE_DEGREE_MAX + 1][3], polygon_w[TAUT_PIPE_DEGREE_MAX + 1][3];
    const int degree = interpolate_frame(m, n0, n1, h, polygon_u, polygon_w);
    taut_pipe_normals exact;

    memcpy(at, carried, sizeof at);
    carry_frame(m, t0, t0 + s * h, at, &exact);
    taut_bernstein_point(degree, 3, &polygon_u[0][0], s, u, NULL);
    taut_bernstein_point(degree, 3, &polygon_w[0][0], s, w, NULL);
    taut_difference(u, exact.u, u);
    taut_difference(w, exact.w, w);
    if (m->profile->canal > 0) {
        interpolate_offset(m, n0, n1, h, polygon_u);
        taut_bernstein_point(degree, 3, &polygon_u[0][0], s, back, NULL);
        taut_difference(back, exact.c, back);
    }
    for (int k = 0; k < ANGLES; k++) {
        const double c = taut_cos(2 * TAUT_PI * k / ANGLES), z = taut_sin(2 * TAUT_PI * k / ANGLES);
        double apart[3] = {back[0], back[1], back[2]};
        taut_add_scaled(c, u, apart);
        taut_add_scaled(z, w, apart);
        most = fmax(most, taut_norm(apart));
    }
    return most;
}

static int is_close(const blend_maker *m, double t0, const double carried[3],
                    const taut_pipe_normals *n0, double t1, const taut_pipe_normals *n1)
{
    for (int i = 1; i < 8; i++) {
        const double found = m->profile != NULL
                                 ? profile_deviation(m, t0, carried, n0, t1, n1, i / 8.0)
                                 : round_deviation(m, t0, n0, t1, n1, i / 8.0);
        if (!(found <= 0.8 * m->tolerance)) {
            return 0;
        }
    }
    return m->profile != NULL || !(m->sharpest > t0 && m->sharpest < t1) ||
           round_deviation(m, t0, n0, t1, n1, (m->sharpest - t0) / (t1 - t0)) <= 0.8 * m->tolerance;
}

static taut_status fail_too_fine(const blend_maker *m, const char *name, taut_error *error)
{
    return taut_fail(error, TAUT_NO_SOLUTION, "too-fine", "", m->tolerance, taut_none,
                     "%s needs more than 100000 segments for a tolerance of %g: ask for less, or "
                     "for a smaller radius",
                     name, m->tolerance);
}

/* From the first end to the last in dyadic steps: halved until close, doubled again where the place
 * allows it. */
static taut_status cut_segments(blend_maker *m, const char *name, taut_error *error)
{
    taut_pipe_normals here, next;
    taut_pipe_jet jet;
    int level = 2;
    double t = 0, u[3], carried[3];

    taut_pipe_arc_jet(m->arc, 0, &jet);
    taut_pipe_first_normal(jet.tangent, u);
    if (m->profile != NULL) {
        memcpy(u, m->profile->first, sizeof u);
    }
    carry_frame(m, 0, 0, u, &here);
    if (!add_node(m, 0, &here)) {
        return taut_fail_memory(error);
    }
    while (t < 1) {
        const double h = ldexp(1, -level);
        memcpy(carried, u, sizeof carried);
        carry_frame(m, t, t + h, carried, &next);
        if (!is_close(m, t, u, &here, t + h, &next)) {
            if (++level > LEVEL_MAX) {
                return fail_too_fine(m, name, error);
            }
            continue;
        }
        t += h;
        here = next;
        memcpy(u, carried, sizeof u);
        if (m->count > SEGMENTS_MAX) {
            return fail_too_fine(m, name, error);
        }
        if (!add_node(m, t, &here)) {
            return taut_fail_memory(error);
        }
        /* a step of twice the length must begin at a multiple of itself */
        if (level > 2 && fmod(t, 2 * h) == 0) {
            level--;
        }
    }
    return TAUT_OK;
}

/* A Bezier polygon of degree `from` as one of degree n. */
static void elevate_degree(int from, int n, double (*out)[3])
{
    for (int degree = from + 1; degree <= n; degree++) {
        for (int k = 0; k < 3; k++) {
            out[degree][k] = out[degree - 1][k];
            for (int i = degree - 1; i > 0; i--) {
                const double part = (double)i / degree;
                out[i][k] = part * out[i - 1][k] + (1 - part) * out[i][k];
            }
        }
    }
}

/* The rings of one segment: all n + 1 of them. */
static void set_rings(const blend_maker *m, int i, double (*out)[TAUT_PIPE_RING][3])
{
    const int n = m->arc->degree;
    const taut_pipe_normals *n0 = &m->normals[i], *n1 = &m->normals[i + 1];
    const double h = m->t[i + 1] - m->t[i];
    double p[TAUT_PIPE_DEGREE_MAX + 1][3], u[TAUT_PIPE_DEGREE_MAX + 1][3],
        w[TAUT_PIPE_DEGREE_MAX + 1][3], c[TAUT_PIPE_DEGREE_MAX + 1][3];
    int degree = 0;

    taut_pipe_arc_piece(m->arc, m->t[i], m->t[i + 1], p);
    degree = interpolate_frame(m, n0, n1, h, u, w);
    elevate_degree(degree, n, u);
    elevate_degree(degree, n, w);
    interpolate_offset(m, n0, n1, h, c);
    elevate_degree(degree, n, c);
    for (int row = 0; row <= n; row++) {
        for (int j = 0; j < TAUT_PIPE_RING; j++) {
            for (int k = 0; k < 3; k++) {
                out[row][j][k] = p[row][k] + m->radius * (c[row][k] + circle[j][0] * u[row][k] +
                                                          circle[j][1] * w[row][k]);
            }
        }
    }
}

taut_status taut_pipe_blend_make(const taut_pipe_arc *arc, double radius, double tolerance,
                                 const taut_pipe_binormal *binormal,
                                 const taut_pipe_profile *profile, taut_arena *arena,
                                 const char *name, taut_pipe_blend *blend, taut_error *error)
{
    blend_maker m = {.arc = arc,
                     .binormal = binormal,
                     .profile = profile,
                     .radius = radius,
                     .tolerance = tolerance,
                     .arena = arena};
    const int n = arc->degree;
    double ring[TAUT_PIPE_DEGREE_MAX + 1][TAUT_PIPE_RING][3];
    double(*points)[TAUT_PIPE_RING][3] = NULL;
    taut_pipe_bend bend;
    taut_status status = TAUT_OK;

    taut_pipe_bend_extremes(arc, 200, &bend);
    m.sharpest = bend.curvature_at;
    status = cut_segments(&m, name, error);
    if (status != TAUT_OK) {
        return status;
    }
    blend->segments = m.count - 1;
    blend->rows = (n - 1) * blend->segments + 2;
    blend->breaks = m.t;
    points = taut_arena_take(arena, (size_t)blend->rows, sizeof *points);
    if (points == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < blend->segments; i++) {
        set_rings(&m, i, ring);
        /* the pieces meet C^1: of the points at an inner break none is left in a B-spline whose
         * knots there are n - 1 fold */
        memcpy(points[(n - 1) * i + (i > 0)], ring[i > 0], (size_t)(n - (i > 0)) * sizeof ring[0]);
    }
    memcpy(points[blend->rows - 1], ring[n], sizeof ring[0]);
    blend->points = &points[0][0][0];
    memcpy(blend->last, m.normals[m.count - 1].u, sizeof blend->last);
    /* Frenet's frames turn about the axis: their points are not on lines along it */
    blend->slack = binormal != NULL ? 0 : fmin(1e-9, 0.1 * tolerance);
    return TAUT_OK;
}

/* The distance of p from the line through q along d. */
static double off_line(const double p[3], const double q[3], const double d[3])
{
    double way[3], across[3];
    taut_difference(p, q, way);
    taut_cross(way, d, across);
    return taut_norm(across);
}

/* p moved along the line to where it is nearest to it, or to the first place that is near enough.
 */
static void place_on_line(const double q[3], const double d[3], double most, double enough,
                          double p[3])
{
    double way[3], best = off_line(p, q, d), along = 0;
    taut_difference(p, q, way);
    along = taut_dot(way, d);
    for (int n = 1; n <= 2 * PLACES && best > enough; n++) {
        const double s = along + (n % 2 == 0 ? most : -most) * ((n + 1) / 2) / PLACES;
        const double next[3] = {q[0] + s * d[0], q[1] + s * d[1], q[2] + s * d[2]};
        const double off = off_line(next, q, d);
        if (off < best) {
            best = off;
            memcpy(p, next, sizeof next);
        }
    }
}

/*  * At a joint x_u is the way from the end ring to the next, which exactly is along the axis; the
 * rounding of its points turns it by their last digit over that way, which in short first segments
 * far from the origin is thousands of digits. Where on its line a point lies matters little, so
 * it is moved along by less than the tube can tell, to where rounding happens to leave it on the
 * line.
 */
void taut_pipe_straighten(const taut_pipe_arc *arc, const taut_pipe_blend *blend, double radius,
                          double *points)
{
    const int depth = arc->degree == 5 ? 2 : 1, rows = blend->rows;
    for (int n = 0; n < 2 * depth * TAUT_PIPE_RING && blend->slack > 0; n++) {
        const int side = n % 2, j = n / 2 % TAUT_PIPE_RING, row = 1 + n / (2 * TAUT_PIPE_RING);
        const int step = 3 * TAUT_PIPE_RING;
        const double *const q = points + 3 * j + (side == 0 ? 0 : (rows - 1) * step);
        const double *const first = q + (side == 0 ? step : -step);
        double *const p = points + 3 * j + (side == 0 ? row : rows - 1 - row) * step;
        const double leg = taut_distance(first, q);
        taut_pipe_jet jet;
        taut_pipe_arc_jet(arc, side, &jet);
        place_on_line(q, jet.tangent, fmin(blend->slack * radius, part_of_way * leg),
                      near_enough * leg * (depth == 2 ? fmin(1, leg / radius) : 1), p);
    }
}

taut_status taut_pipe_basis(const taut_basis_spec *spec, int count, taut_arena *arena,
                            const taut_basis **basis, taut_error *error)
{
    taut_basis *made = NULL;
    const taut_status status = taut_basis_new(spec, count, &made, error);
    if (status != TAUT_OK) {
        return status;
    }
    *basis = made;
    return taut_keep_basis(arena, made) ? TAUT_OK : taut_fail_memory(error);
}

taut_status taut_pipe_basis_u(const taut_pipe_arc *arc, const taut_pipe_blend *blend,
                              taut_arena *arena, const taut_basis **u, taut_error *error)
{
    const int n = arc->degree;
    const int count = blend->rows + n + 1;
    double *knots = taut_arena_take(arena, (size_t)count, sizeof *knots);
    const taut_basis_spec spec = {
        .type = "bspline", .degree = n, .knot_count = count, .knots = knots};
    int k = 0;

    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i <= blend->segments; i++) {
        const int times = i == 0 || i == blend->segments ? n + 1 : n - 1;
        for (int j = 0; j < times; j++) {
            knots[k++] = blend->breaks[i];
        }
    }
    return taut_pipe_basis(&spec, blend->rows, arena, u, error);
}

taut_status taut_pipe_basis_v(taut_arena *arena, const taut_basis **v, taut_error *error)
{
    static const double knots[] = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
    const taut_basis_spec spec = {
        .type = "bspline", .degree = 2, .knot_count = TAUT_PIPE_RING + 3, .knots = knots};
    return taut_pipe_basis(&spec, TAUT_PIPE_RING, arena, v, error);
}

taut_status taut_pipe_basis_line(taut_arena *arena, const taut_basis **line, taut_error *error)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = 1};
    return taut_pipe_basis(&spec, 2, arena, line, error);
}

void taut_pipe_weights(int rows, double *weights)
{
    for (int i = 0; i < rows * TAUT_PIPE_RING; i++) {
        weights[i] = i % TAUT_PIPE_RING % 2 == 0 ? 1 : sqrt(0.5);
    }
}
