/* proof.c -- how far a quintic spline is from a curve or surface on c- and h- bases.
 *
 * On a span of length h, two-point Hermite interpolation of degree 5 leaves
 *
 *     |x - Hx| <= (h/2)^6 / 6! max |x^(6)| = h^6 / 46080 max |x^(6)|
 *
 * for vectors too, since Peano's kernel does not change sign. The sixth derivative of any function
 * over {1, t, sin, cos} or {1, t, sinh, cosh} is its second, y, so that with m the middle of a span
 *
 *     |y(t)| <= at |y(m)| + slope |y'(m)|      (taut_change_ops.growth)
 *
 * and y(m), y'(m) come from the net itself. On a surface
 *
 *     x - H_u H_v x = (x - H_u x) + (x - H_v x) - (1 - H_u)(1 - H_v) x,
 *
 * three terms of this kind; along the other direction the first is bounded by the convex hull of a
 * Bezier-like piece, the last span by span. [XuWang2006] gives such a bound for its own surface
 * (minimal-mesh page, section 11.6); this one holds for every net, and for spans of any widths.
 */
#include "geometry/nurbs/proof.h"

#include "core/elementary/elementary.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "taut/operations.h"

#include <math.h>

void taut_nurbs_side_free(taut_nurbs_side *s)
{
    taut_change_list_free(&s->pieces);
    taut_free(s->first);
    taut_free(s->ends);
    taut_free(s->spans);
    s->first = NULL;
    s->ends = NULL;
    s->spans = NULL;
}

taut_status taut_nurbs_side_begin(const taut_basis *basis, taut_nurbs_side *s, taut_error *error)
{
    *s = (taut_nurbs_side){.basis = basis, .exact = 1};
    if (basis == NULL) {
        return TAUT_OK;
    }
    s->exact = taut_basis_degree(basis) >= 0;
    return basis->ops->changes->pieces(basis, &s->pieces, error);
}

/* Far from the ends of a long hyperbolic piece the derivatives are as small as the growth is large:
 * only their product stays in range. */
taut_nurbs_span taut_nurbs_span_of(const taut_nurbs_side *s, int p, double lo, double hi)
{
    const taut_basis *piece = s->pieces.items[p]->to;
    const double h = hi - lo, factor = taut_pow(h, 6) / 46080;
    double at = 0, slope = 0, u[4 * 4];
    taut_nurbs_span span;

    piece->ops->eval(piece, 0, lo + h / 2, 3, u);
    s->basis->ops->changes->growth(s->basis, h / 2, &at, &slope);
    for (int i = 0; i < 4; i++) {
        span.rows[0][i] = factor * at * u[8 + i];
        span.rows[1][i] = factor * slope * u[12 + i];
    }
    return span;
}

/* Scaled where squares would overflow, or vanish. */
static double length_of(const double *x)
{
    const double square = taut_dot(x, x);
    return square > 1e-280 && square < 1e300 ? sqrt(square) : taut_norm(x);
}

/* |sum_i weights[i] x[i * stride]|, vectors of 3. */
static double combine_points(int count, const double *weights, const double *x, size_t stride,
                             double *sum)
{
    sum[0] = sum[1] = sum[2] = 0;
    for (int i = 0; i < count; i++) {
        const double *p = x + (size_t)i * stride;
        sum[0] += weights[i] * p[0];
        sum[1] += weights[i] * p[1];
        sum[2] += weights[i] * p[2];
    }
    return length_of(sum);
}

double taut_nurbs_along(const taut_nurbs_span *span, int lines, const double *points, size_t line,
                        size_t step)
{
    double largest = 0, sum[3];
    for (int l = 0; l < lines; l++) {
        const double *p = points + (size_t)l * line;
        largest = fmax(largest, combine_points(4, span->rows[0], p, step, sum) +
                                    combine_points(4, span->rows[1], p, step, sum));
    }
    return largest;
}

/* A patch: its points [rows][columns][3]. */
typedef struct patch {
    int rows, columns;
    const double *points;
} patch;

/* Largest x - H x along one direction of a patch with four points that way. */
static double along_bound(const taut_nurbs_side *s, int piece, const patch *net, int across,
                          size_t line, size_t step)
{
    double largest = 0;
    for (int k = s->first[piece]; k < s->first[piece + 1]; k++) {
        largest = fmax(largest, taut_nurbs_along(&s->spans[k], across, net->points, line, step));
    }
    return largest;
}

/* Largest (1 - H_u)(1 - H_v) x on a patch of 4 by 4 points. */
static double mixed_bound(const taut_nurbs_side *u, int pu, const taut_nurbs_side *v, int pv,
                          const patch *net)
{
    double largest = 0;
    for (int k = u->first[pu]; k < u->first[pu + 1]; k++) {
        double rows[2][4][3]; /* the two sums along u, for each column */
        for (int j = 0; j < 4; j++) {
            for (int a = 0; a < 2; a++) {
                (void)combine_points(4, u->spans[k].rows[a], net->points + 3 * (size_t)j, 12,
                                     rows[a][j]);
            }
        }
        for (int l = v->first[pv]; l < v->first[pv + 1]; l++) {
            double total = 0, sum[3];
            for (int a = 0; a < 2; a++) {
                for (int b = 0; b < 2; b++) {
                    total += combine_points(4, v->spans[l].rows[b], rows[a][0], 3, sum);
                }
            }
            largest = fmax(largest, total);
        }
    }
    return largest;
}

/* The distance on one patch. */
static double patch_bound(const taut_nurbs_side *u, int p, const taut_nurbs_side *v, int q,
                          const taut_lattice *lattice)
{
    const patch net = {lattice->count[0], lattice->count[1], lattice->net};
    const size_t row = 3 * (size_t)net.columns;
    double e[2] = {0, 0}, mixed = 0;

    if (!u->exact) {
        e[0] = along_bound(u, p, &net, net.columns, 3, row);
    }
    if (!v->exact) {
        e[1] = along_bound(v, q, &net, net.rows, row, 3);
    }
    if (!u->exact && !v->exact) {
        mixed = mixed_bound(u, p, v, q, &net);
    }
    return e[0] + e[1] + mixed;
}

/* The patches of strip p: itself where there is no second direction. */
static taut_status prove_strip(const taut_lattice *whole, const taut_nurbs_side *u, int p,
                               const taut_nurbs_side *v, double *largest, taut_error *error)
{
    taut_lattice strip;
    taut_status status =
        taut_lattice_change(whole, TAUT_ALONG_U, u->pieces.items[p], &strip, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (v->basis == NULL) {
        *largest = fmax(*largest, patch_bound(u, p, v, 0, &strip));
    }
    for (int q = 0; status == TAUT_OK && q < v->pieces.count; q++) {
        taut_lattice one;
        status = taut_lattice_change(&strip, TAUT_ALONG_V, v->pieces.items[q], &one, error);
        if (status == TAUT_OK) {
            *largest = fmax(*largest, patch_bound(u, p, v, q, &one));
        }
        taut_lattice_free(&one);
    }
    taut_lattice_free(&strip);
    return status;
}

taut_status taut_nurbs_prove(const taut_lattice *whole, const taut_nurbs_side *u,
                             const taut_nurbs_side *v, double *distance, taut_error *error)
{
    double largest = 0;

    for (int p = 0; p < u->pieces.count; p++) {
        const taut_status status = prove_strip(whole, u, p, v, &largest, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    *distance = largest;
    return TAUT_OK;
}
