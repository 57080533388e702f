/* tube.c -- are the surfaces the tube?
 *
 *   tube  over all three surfaces: | distance from the axis - radius | / radius, where the axis is
 *         the curve and its tangent lines at the ends; on the blend not what samples show but what
 *         lies between them at most, by second differences
 */
#include "certify/pipe/parts.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { RING = 32, PER_SPAN = 8 };

/* The largest deviation gathered while surfaces are gone over. */
typedef struct deviation {
    double worst, convex, graph; /* of canal surfaces: the least */
    char where[64];
} deviation;

/* A place on the blend of a canal surface: from the spheres, and whether its normal, that of the
 * sphere, looks away from the axis: where it does everywhere, the surface is a graph over the tube.
 */
static double record_canal(deviation *d, const taut_pipe_parts *parts, const double x[3], double t,
                           const double offset[3], const double normal[3])
{
    double convex = 0;
    const double residual = taut_pipe_canal_miss(parts, x, t, &convex);
    d->convex = fmin(d->convex, convex);
    d->graph = fmin(d->graph, fabs(taut_dot(normal, offset)) / taut_norm(offset));
    return residual;
}

/* How far a place is from the tube, over the radius: its way from the axis, at s of a piece. */
static double miss_of(const taut_pipe_parts *parts, int piece, double s, const double offset[3])
{
    return parts->ellipses[0].a > 0
               ? taut_pipe_section_miss(parts, piece, s, offset)
               : (taut_norm(offset) * parts->line.scale - parts->radius) / parts->radius;
}

static void record(deviation *d, double residual, const char *name, double u, double v)
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
    taut_pipe_find_foot(&parts->line, local, u, &piece, &foot, offset);
    if (parts->canal) {
        taut_pipe_unit_normal(x[TAUT_XU], x[TAUT_XV], normal);
        return record_canal(d, parts, local, u, offset, normal);
    }
    return miss_of(parts, piece, foot, offset);
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
static double upper_estimate(const double f[PER_SPAN + 1][RING], int k, int j)
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

static void record_blend(deviation *d, const taut_pipe_parts *parts)
{
    const taut_basis *u = taut_surface_u(parts->blend), *v = taut_surface_v(parts->blend);
    const double *breaks = taut_basis_breaks(u);
    for (int i = 0; i < taut_basis_span_count(u); i++) {
        double f[PER_SPAN + 1][RING], t[PER_SPAN + 1];
        for (int k = 0; k <= PER_SPAN; k++) {
            t[k] = k == PER_SPAN ? breaks[i + 1]
                                 : breaks[i] + (breaks[i + 1] - breaks[i]) * k / PER_SPAN;
            for (int j = 0; j < RING; j++) {
                f[k][j] = blend_miss(d, parts, t[k], taut_pipe_parameter(v, j, RING));
            }
        }
        for (int k = 0; k <= PER_SPAN; k++) {
            for (int j = 0; j < RING; j++) {
                record(d, upper_estimate((const double(*)[RING])f, k, j), "blend", t[k],
                       taut_pipe_parameter(v, j, RING));
            }
        }
    }
}

/* A straight pipe: distances from the tangent line; it must not reach past the joint. */
static void record_pipe(deviation *d, const taut_pipe_parts *parts, int side)
{
    const taut_pipe_line *line = &parts->line;
    const taut_surface *pipe = parts->pipes[side];
    const taut_basis *u = taut_surface_u(pipe), *v = taut_surface_v(pipe);
    const taut_pipe_piece *piece = &line->pieces[side == 0 ? 0 : line->count - 1];
    const double *joint = piece->points[side == 0 ? 0 : piece->degree];
    for (int k = 0; k <= PER_SPAN; k++) {
        for (int j = 0; j < RING; j++) {
            double x[3], local[3], foot[3], along = 0;
            taut_surface_eval(pipe, taut_pipe_parameter(u, k, PER_SPAN),
                              taut_pipe_parameter(v, j, RING), 0, x);
            taut_pipe_to_local(line, x, local);
            taut_difference(local, joint, foot);
            along = taut_dot(foot, line->tangent[side]);
            taut_add_scaled(-along, line->tangent[side], foot);
            record(d, fabs(miss_of(parts, side == 0 ? 0 : line->count - 1, side, foot)),
                   side == 0 ? "pipe1" : "pipe2", taut_pipe_parameter(u, k, PER_SPAN),
                   taut_pipe_parameter(v, j, RING));
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
    record_blend(&d, parts);
    *fit_error = d.worst;
    record_pipe(&d, parts, 0);
    record_pipe(&d, parts, 1);
    status =
        taut_pipe_add_claim("tube", d.worst, tolerance, tolerance + noise, d.where, certificate);
    if (status == TAUT_OK && parts->canal) {
        status = claim_above("regular", d.convex, certificate);
    }
    return status == TAUT_OK && parts->canal ? claim_above("graph", d.graph, certificate) : status;
}
