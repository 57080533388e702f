/* lines.c -- how fine a surface is cut.
 *
 * Bilinear interpolation on a cell of hu by hv is off by at most hu^2 |x_uu|/8 + hv^2 |x_vv|/8, and
 * cutting the quad into two triangles adds hu hv |x_uv|/4. For any r > 0
 *
 *     2 hu hv <= r hu^2 + hv^2 / r,
 *
 * so that the sum is at most hu^2 (|x_uu| + r |x_uv|)/8 + hv^2 (|x_vv| + |x_uv|/r)/8, and each half
 * is given half of the tolerance T:  hu^2 = 4 T / (|x_uu| + r |x_uv|). With r = |x_u| / |x_v|, the
 * ratio of the mean speeds over the span of u and the span of v, cells are about as long as they
 * are wide where the twist decides, and knots that lie closer elsewhere do not matter.
 */
#include "mesh/lines.h"

#include "core/vec3.h"
#include "geometry/exponent.h"

#include <math.h>

/* Samples a span: even the twist of a bilinear cell has its peak inside, where the normal turns;
 * with 17 the tolerance held on thousands of random surfaces, with 4 to 9 it was passed by up to 6
 * %. */
enum { SAMPLES_IN_ALL = 200, SAMPLES_LEAST = 2, SAMPLES_ENOUGH = 17, SAMPLES_MOST = 24 };

static int samples_per_span(const taut_basis *basis)
{
    const int wish = SAMPLES_IN_ALL / taut_basis_span_count(basis);
    const int bends = 2 * taut_basis_local(basis);
    const int enough = bends < SAMPLES_ENOUGH ? SAMPLES_ENOUGH
                       : bends < SAMPLES_MOST ? bends
                                              : SAMPLES_MOST;
    return wish < SAMPLES_LEAST ? SAMPLES_LEAST : wish < enough ? wish : enough;
}

/* Parameters double[spans * each], evenly over each closed span; the last one of a span lies just
 * inside, so that it is that span's. */
static void fill_samples(const taut_basis *basis, int each, double *t)
{
    const double *breaks = taut_basis_breaks(basis);
    for (int s = 0; s < taut_basis_span_count(basis); s++) {
        const double width = breaks[s + 1] - breaks[s];
        for (int i = 0; i < each - 1; i++) {
            t[s * each + i] = breaks[s] + width * i / (each - 1);
        }
        t[s * each + each - 1] = nextafter(breaks[s + 1], breaks[s]);
    }
}

/* The length of what is left of `a` without its part along `along`. */
static double part_across(const double *a, const double *along)
{
    double c[3];
    const double length = taut_length(along);
    if (!(length > 0)) {
        return taut_length(a);
    }
    taut_cross(a, along, c);
    return taut_length(c) / length;
}

/* The part of x_uv along the normal; all of it where there is none. */
static double twist_of(const double *x)
{
    double n[3];
    taut_cross(x + 3 * TAUT_XU, x + 3 * TAUT_XV, n);
    const double length = taut_length(n);
    const double *uv = x + 3 * TAUT_XUV;
    return length > 0 ? fabs(taut_dot(uv, n)) / length : taut_length(uv);
}

/* What is known of one span: the largest second derivative along it, and the sum of the speeds. */
typedef struct span_facts {
    double bend, speed;
} span_facts;

/* And of all: twist[s][t], the largest |x_uv| where span s of u meets span t of v. */
typedef struct facts {
    int spans_u, spans_v;
    span_facts *u, *v; /* [spans_u], [spans_v] */
    double *twist;     /* [spans_u][spans_v] */
} facts;

static void take_sample(const double *x, int s, int t, facts *known, taut_bending *bending)
{
    const double u = taut_length(x + 3 * TAUT_XU);
    const double v = taut_length(x + 3 * TAUT_XV);
    double *twisted = &known->twist[(size_t)s * (size_t)known->spans_v + (size_t)t];
    known->u[s].bend = fmax(known->u[s].bend, part_across(x + 3 * TAUT_XUU, x + 3 * TAUT_XU));
    known->v[t].bend = fmax(known->v[t].bend, part_across(x + 3 * TAUT_XVV, x + 3 * TAUT_XV));
    *twisted = fmax(*twisted, twist_of(x));
    known->u[s].speed += u;
    known->v[t].speed += v;
    bending->longest_u = fmax(bending->longest_u, u);
    bending->longest_v = fmax(bending->longest_v, v);
    for (int c = 0; c < 3; c++) {
        bending->lo[c] = fmin(bending->lo[c], x[c]);
        bending->hi[c] = fmax(bending->hi[c], x[c]);
    }
}

/* The power of two that brings the points of a surface near 1, so that no square leaves the range
 * of doubles; 1 for a surface at the origin. */
static double scale_of(const taut_surface *surface)
{
    const double largest = taut_largest(taut_point_count(surface), taut_surface_points(surface));
    return largest > 0 ? taut_half_factor(taut_exponent(largest)) : 1;
}

/* bending->u and v out of what is known. A pair of spans has as many samples as any other, so that
 * the sums of the speeds, over one span and all of the other way, are the means but for a factor.
 */
static void find_bending(const facts *known, taut_bending *bending)
{
    for (int s = 0; s < known->spans_u; s++) {
        bending->u[s] = known->u[s].bend;
    }
    for (int t = 0; t < known->spans_v; t++) {
        bending->v[t] = known->v[t].bend;
    }
    for (int s = 0; s < known->spans_u; s++) {
        for (int t = 0; t < known->spans_v; t++) {
            const double u = known->u[s].speed / known->spans_v;
            const double v = known->v[t].speed / known->spans_u;
            const double r = u > 0 && v > 0 ? u / v : 1;
            const double twisted = known->twist[(size_t)s * (size_t)known->spans_v + (size_t)t];
            bending->u[s] = fmax(bending->u[s], known->u[s].bend + r * twisted);
            bending->v[t] = fmax(bending->v[t], known->v[t].bend + twisted / r);
        }
    }
}

/* Back to the surface's own unit. */
static void undo_scale(double scale, const facts *known, taut_bending *bending)
{
    for (int s = 0; s < known->spans_u; s++) {
        bending->u[s] /= scale;
    }
    for (int t = 0; t < known->spans_v; t++) {
        bending->v[t] /= scale;
    }
    bending->longest_u /= scale;
    bending->longest_v /= scale;
    for (int c = 0; c < 3; c++) {
        bending->lo[c] /= scale;
        bending->hi[c] /= scale;
    }
}

taut_status taut_bending_sample(const taut_surface *surface, const taut_crew *crew,
                                taut_arena *arena, taut_bending *bending)
{
    enum { OF_SAMPLE = 500 }; /* operations, roughly */
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const int each_u = samples_per_span(u), each_v = samples_per_span(v);
    const int spans_u = taut_basis_span_count(u), spans_v = taut_basis_span_count(v);
    const int count_u = spans_u * each_u, count_v = spans_v * each_v;
    const double scale = scale_of(surface);
    double *tu = taut_arena_take(arena, (size_t)count_u, sizeof(double));
    double *tv = taut_arena_take(arena, (size_t)count_v, sizeof(double));
    double *x = taut_arena_take(arena, (size_t)count_v, 18 * sizeof(double));
    double *of_u = taut_arena_take(arena, (size_t)spans_u, sizeof(double));
    double *of_v = taut_arena_take(arena, (size_t)spans_v, sizeof(double));
    facts known = {spans_u, spans_v, taut_arena_take(arena, (size_t)spans_u, sizeof(span_facts)),
                   taut_arena_take(arena, (size_t)spans_v, sizeof(span_facts)),
                   taut_arena_take(arena, (size_t)spans_u * (size_t)spans_v, sizeof(double))};
    taut_status status = TAUT_OK;

    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    *bending = (taut_bending){
        of_u, of_v, 0, 0, {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    fill_samples(u, each_u, tu);
    fill_samples(v, each_v, tv);
    for (int i = 0; status == TAUT_OK && i < count_u; i++) {
        status = taut_surface_eval_grid(surface, 1, tu + i, count_v, tv, 2, crew->threads, x);
        for (int j = 0; status == TAUT_OK && j < count_v; j++) {
            double *at = x + 18 * (size_t)j;
            for (int c = 0; c < 18; c++) {
                at[c] *= scale;
            }
            take_sample(at, i / each_u, j / each_v, &known, bending);
        }
        if (status == TAUT_OK && taut_crew_beat(crew, (double)OF_SAMPLE * count_v)) {
            status = TAUT_INTERRUPTED;
        }
    }
    find_bending(&known, bending);
    undo_scale(scale, &known, bending);
    return status;
}

double taut_cell_count(double width, double bending, double tolerance)
{
    const double cells = width * sqrt(bending / (4 * tolerance)); /* width / hu */
    return cells > 1 ? ceil(cells) : cells >= 0 ? 1 : bending > 0 ? INFINITY : 1;
}
