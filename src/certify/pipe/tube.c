/* tube.c -- do the surfaces meet, and are they the tube?
 *
 *   joint1, joint2  along both edges of a joint: the larger of gap over radius and sine between the
 *                   normals
 *   tube            over all three surfaces: | distance from the axis - radius | / radius, where
 *                   the axis is the curve and its tangent lines at the ends; on the blend not what
 *                   samples show but what lies between them at most, by second differences
 */
#include "certify/pipe/parts.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { AROUND = 96, RING = 32, PER_SPAN = 8, NEWTON_STEPS = 6 };

static double at(const taut_basis *basis, int k, int n)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    return k == n ? hi : lo + (hi - lo) * k / n;
}

/* The unit normal of two tangents, whatever their lengths; 0 where there is none. */
static void normal_of(const double xu[3], const double xv[3], double normal[3])
{
    const double u = taut_norm(xu), v = taut_norm(xv);
    double a[3], b[3], length = 0;
    for (int k = 0; k < 3; k++) {
        a[k] = u > 0 ? xu[k] / u : 0;
        b[k] = v > 0 ? xv[k] / v : 0;
    }
    taut_cross(a, b, normal);
    length = taut_norm(normal);
    for (int k = 0; k < 3 && length > 0; k++) {
        normal[k] /= length;
    }
}

/* The sine between two unit normals; 1 where they look apart or one is missing. */
static double sine(const double a[3], const double b[3])
{
    double across[3];
    taut_cross(a, b, across);
    return taut_dot(a, b) > 0.5 ? taut_norm(across) : 1;
}

double taut_pipe_sideways(const taut_pipe_parts *parts, int side, const double changes[3])
{
    const double *tangent = parts->line.tangent[side];
    double square = 0;
    for (int k = 0; k < 3; k++) {
        const double rounding =
            tangent[k] != 0 || changes[k] != 0 ? 2 * DBL_EPSILON * parts->sizes[k] : 0;
        square += rounding * rounding * (1 - tangent[k]) * (1 + tangent[k]);
    }
    return sqrt(square);
}

/* An edge u0 (edge 0) or u1 of a surface, and what rounding does to its tangents across. */
typedef struct edge {
    const taut_surface *surface;
    int last;
    double sideways; /* of control points */
    double leg;      /* times |x_u|: the distance to the next ring that makes it up */
} edge;

static edge edge_of(const taut_pipe_parts *parts, int side, const taut_surface *surface, int last)
{
    const taut_basis *u = taut_surface_u(surface);
    const int nu = taut_basis_count(u), nv = taut_basis_count(taut_surface_v(surface));
    const int spans = taut_basis_span_count(u);
    const double *breaks = taut_basis_breaks(u), *points = taut_surface_points(surface);
    const double *ring = points + (size_t)(last ? nu - 1 : 0) * 3 * (size_t)nv;
    const double *next = points + (size_t)(last ? nu - 2 : 1) * 3 * (size_t)nv;
    double changes[3] = {0, 0, 0};
    for (int j = 0; j < 3 * nv; j++) {
        changes[j % 3] = fmax(changes[j % 3], fabs(ring[j] - next[j]));
    }
    return (edge){
        .surface = surface,
        .last = last,
        .sideways = taut_pipe_sideways(parts, side, changes),
        .leg = (last ? breaks[spans] - breaks[spans - 1] : breaks[1] - breaks[0]) /
               fmax(1, taut_basis_degree(u)),
    };
}

/* The point and the unit normal at v; returns what rounding turns the normal by: only the part of
 * x_u at right angles to the ring holds it. */
static double look(const edge *e, double v, double x[3], double normal[3])
{
    double d[3][3], around[3], across[3], length = 0;
    taut_pipe_edge_eval(e->surface, e->last, v, 1, d);
    memcpy(x, d[0], sizeof d[0]);
    normal_of(d[TAUT_XU], d[TAUT_XV], normal);
    length = taut_norm(d[TAUT_XV]);
    for (int k = 0; k < 3; k++) {
        around[k] = length > 0 ? d[TAUT_XV][k] / length : 0;
    }
    taut_cross(d[TAUT_XU], around, across);
    length = taut_norm(across) * e->leg;
    return e->sideways > 0 || !(length > 0) ? e->sideways / length : 0;
}

void taut_pipe_meet(const taut_pipe_parts *parts, int side, taut_pipe_meeting *meeting)
{
    const edge blend = edge_of(parts, side, parts->blend, side == 1);
    const edge pipe = edge_of(parts, side, parts->pipes[side], side == 0);
    const taut_basis *v = taut_surface_v(blend.surface), *w = taut_surface_v(pipe.surface);
    double turned = 0;

    *meeting = (taut_pipe_meeting){.where = ""};
    for (int k = 0; k <= AROUND; k++) {
        double a[3], b[3], normal_a[3], normal_b[3], residual = 0;
        turned = fmax(turned, look(&blend, at(v, k, AROUND), a, normal_a) +
                                  look(&pipe, at(w, k, AROUND), b, normal_b));
        residual = fmax(taut_distance(a, b) / parts->radius, sine(normal_a, normal_b));
        if (!(residual <= meeting->residual)) {
            meeting->residual = residual;
            snprintf(meeting->where, sizeof meeting->where, "v = %.6g", at(v, k, AROUND));
        }
    }
    meeting->noise = (4 * DBL_EPSILON + DBL_EPSILON * parts->size / parts->radius) *
                         parts->flatness * parts->flatness +
                     turned;
}

taut_status taut_pipe_claim_joint(const taut_pipe_parts *parts, int side,
                                  taut_certificate *certificate)
{
    taut_pipe_meeting m;
    taut_pipe_meet(parts, side, &m);
    return taut_pipe_add_claim(side == 0 ? "joint1" : "joint2", m.residual, 0, m.noise, m.where,
                               certificate);
}

void taut_pipe_foot(const taut_pipe_line *line, const double x[3], double t, int *at_piece,
                    double *at_s, double offset[3])
{
    const taut_pipe_piece *piece = &line->pieces[0];
    double s = 0, d[3][3], apart[3];
    for (int lo = 0, hi = line->count - 1; lo < hi;) { /* the first that reaches t, or the last */
        const int middle = (lo + hi) / 2;
        *(t > line->pieces[middle].hi ? &lo : &hi) = middle + (t > line->pieces[middle].hi);
        piece = &line->pieces[lo];
    }
    s = fmin(1, fmax(0, (t - piece->lo) / (piece->hi - piece->lo)));
    for (int i = 0; i < NEWTON_STEPS; i++) {
        taut_pipe_piece_eval(piece, s, 2, d);
        taut_difference(d[0], x, apart);
        const double slope = taut_dot(d[1], d[1]) + taut_dot(apart, d[2]);
        const double move = slope > 0 ? taut_dot(apart, d[1]) / slope : 0;
        s = fmin(1, fmax(0, s - move));
        if (fabs(move) < 1e-9) { /* the distance is flat there: its error is the square of that */
            break;
        }
    }
    taut_pipe_piece_eval(piece, s, 0, d);
    *at_piece = (int)(piece - line->pieces);
    *at_s = s;
    taut_difference(x, d[0], offset);
}

void taut_pipe_to_local(const taut_pipe_line *line, const double x[3], double local[3])
{
    for (int k = 0; k < 3; k++) {
        local[k] = (x[k] - line->origin[k]) / line->scale;
    }
}

/* The largest deviation gathered while surfaces are gone over. */
typedef struct deviation {
    double worst, convex, graph; /* of canal surfaces: the least */
    char where[64];
} deviation;

/* A place on the blend of a canal surface: from the spheres, and whether its normal, that of the
 * sphere, looks away from the axis: where it does everywhere, the surface is a graph over the tube.
 */
static double see_canal(deviation *d, const taut_pipe_parts *parts, const double x[3], double t,
                        const double offset[3], const double normal[3])
{
    double convex = 0;
    const double residual = taut_pipe_canal_miss(parts, x, t, &convex);
    d->convex = fmin(d->convex, convex);
    d->graph = fmin(d->graph, fabs(taut_dot(normal, offset)) / taut_norm(offset));
    return residual;
}

/* How far a place is from the tube, over the radius: its way from the axis, at s of a piece. */
static double miss(const taut_pipe_parts *parts, int piece, double s, const double offset[3])
{
    return parts->sections[0].a > 0
               ? taut_pipe_section_miss(parts, piece, s, offset)
               : (taut_norm(offset) * parts->line.scale - parts->radius) / parts->radius;
}

static void see(deviation *d, double residual, const char *name, double u, double v)
{
    if (!(residual <= d->worst)) {
        d->worst = residual;
        snprintf(d->where, sizeof d->where, "%s, u = %.6g, v = %.6g", name, u, v);
    }
}

/* What the blend misses by at one place. */
static double blend_miss(deviation *d, const taut_pipe_parts *parts, double u, double v)
{
    double x[3][3], local[3], offset[3], normal[3], foot = 0;
    int piece = 0;
    taut_surface_eval(parts->blend, u, v, 1, x[0]);
    taut_pipe_to_local(&parts->line, x[0], local);
    taut_pipe_foot(&parts->line, local, u, &piece, &foot, offset);
    if (parts->canal) {
        normal_of(x[TAUT_XU], x[TAUT_XV], normal);
        return see_canal(d, parts, local, u, offset, normal);
    }
    return miss(parts, piece, foot, offset);
}

/* |a - 2 b + c|, the second difference. */
static double bend_of(double a, double b, double c)
{
    return fabs((a - b) + (c - b));
}

/* An upper estimate of |f| within half a step of sample (k, j): with its largest value there at x
 * and a Hessian H that has one sign, f(x) exceeds the sample by at most d.H d / 2, |d| at most half
 * a step each way, and |H_uv| <= sqrt(H_uu H_vv):
 *     |f| <= |f_kj| + (sqrt(a) + sqrt(b))^2 / 8,   a, b the second differences along u and along v,
 * here each the largest of the sample's and its neighbours' in its line. */
static double upper(const double f[PER_SPAN + 1][RING], int k, int j)
{
    double a = 0, b = 0;
    for (int i = k - 1; i <= k + 1; i++) {
        const int inner = i < 1 ? 1 : i > PER_SPAN - 1 ? PER_SPAN - 1 : i;
        a = fmax(a, bend_of(f[inner - 1][j], f[inner][j], f[inner + 1][j]));
    }
    for (int i = j + RING - 1; i <= j + RING + 1; i++) {
        b = fmax(b, bend_of(f[k][(i - 1) % RING], f[k][i % RING], f[k][(i + 1) % RING]));
    }
    return fabs(f[k][j]) + (a + b + 2 * sqrt(a * b)) / 8;
}

static void see_blend(deviation *d, const taut_pipe_parts *parts)
{
    const taut_basis *u = taut_surface_u(parts->blend), *v = taut_surface_v(parts->blend);
    const double *breaks = taut_basis_breaks(u);
    for (int i = 0; i < taut_basis_span_count(u); i++) {
        double f[PER_SPAN + 1][RING], t[PER_SPAN + 1];
        for (int k = 0; k <= PER_SPAN; k++) {
            t[k] = k == PER_SPAN ? breaks[i + 1]
                                 : breaks[i] + (breaks[i + 1] - breaks[i]) * k / PER_SPAN;
            for (int j = 0; j < RING; j++) {
                f[k][j] = blend_miss(d, parts, t[k], at(v, j, RING));
            }
        }
        for (int k = 0; k <= PER_SPAN; k++) {
            for (int j = 0; j < RING; j++) {
                see(d, upper((const double(*)[RING])f, k, j), "blend", t[k], at(v, j, RING));
            }
        }
    }
}

/* A straight pipe: distances from the tangent line; it must not reach past the joint. */
static void see_pipe(deviation *d, const taut_pipe_parts *parts, int side)
{
    const taut_pipe_line *line = &parts->line;
    const taut_surface *pipe = parts->pipes[side];
    const taut_basis *u = taut_surface_u(pipe), *v = taut_surface_v(pipe);
    const taut_pipe_piece *piece = &line->pieces[side == 0 ? 0 : line->count - 1];
    const double *joint = piece->points[side == 0 ? 0 : piece->degree];
    for (int k = 0; k <= PER_SPAN; k++) {
        for (int j = 0; j < RING; j++) {
            double x[3], local[3], foot[3], along = 0;
            taut_surface_eval(pipe, at(u, k, PER_SPAN), at(v, j, RING), 0, x);
            taut_pipe_to_local(line, x, local);
            taut_difference(local, joint, foot);
            along = taut_dot(foot, line->tangent[side]);
            taut_add_scaled(-along, line->tangent[side], foot);
            see(d, fabs(miss(parts, side == 0 ? 0 : line->count - 1, side, foot)),
                side == 0 ? "pipe1" : "pipe2", at(u, k, PER_SPAN), at(v, j, RING));
        }
    }
}

/* A claim about the least value of something that must stay positive. */
static taut_status claim_above(const char *name, double value, taut_certificate *certificate)
{
    const taut_claim claim = {.claim = name,
                              .residual = value,
                              .limit = 1e-6,
                              .holds = value > 1e-6 ? TAUT_TRUE : TAUT_FALSE,
                              .where = ""};
    return taut_certificate_add(certificate, &claim);
}

taut_status taut_pipe_claim_tube(const taut_pipe_parts *parts, double tolerance, double *fit_error,
                                 taut_certificate *certificate)
{
    /* rounding of the control points, and of the tangent over the length of a straight pipe */
    const double noise = 8 * DBL_EPSILON * parts->size / parts->radius;
    deviation d = {.worst = 0, .convex = INFINITY, .graph = INFINITY, .where = ""};
    taut_status status = TAUT_OK;
    see_blend(&d, parts);
    *fit_error = d.worst;
    see_pipe(&d, parts, 0);
    see_pipe(&d, parts, 1);
    status =
        taut_pipe_add_claim("tube", d.worst, tolerance, tolerance + noise, d.where, certificate);
    if (status == TAUT_OK && parts->canal) {
        status = claim_above("regular", d.convex, certificate);
    }
    return status == TAUT_OK && parts->canal ? claim_above("graph", d.graph, certificate) : status;
}
