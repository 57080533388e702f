/* nurbs_proof.c -- how far a quintic spline is from a curve or surface on c- and h- bases.
 *
 * On a panel of length h, two-point Hermite interpolation of degree 5 leaves
 *
 *     |x - Hx| <= (h/2)^6 / 6! max |x^(6)| = h^6 / 46080 max |x^(6)|
 *
 * for vectors too, since Peano's kernel does not change sign. The sixth derivative of any function
 * over {1, t, sin, cos} or {1, t, sinh, cosh} is its second, y, so that with m the middle of a
 * panel
 *
 *     |y(t)| <= at |y(m)| + slope |y'(m)|      (taut_change_ops.growth)
 *
 * and y(m), y'(m) come from the net itself. On a surface
 *
 *     x - H_u H_v x = (x - H_u x) + (x - H_v x) - (1 - H_u)(1 - H_v) x,
 *
 * three terms of this kind; along the other direction the first is bounded by the convex hull of a
 * Bezier-like piece, the last panel by panel. [XuWang2006] gives such a bound for its own surface
 * (minimal-mesh page, section 11.6); this one holds for every net.
 */
#include "geometry/nurbs_proof.h"

#include "core/fail.h"
#include "core/memory.h"
#include "taut/operate.h"

#include <math.h>

void taut_side_free(taut_side *s)
{
    taut_change_list_free(&s->pieces);
    taut_free(s->bends);
    s->bends = NULL;
}

taut_status taut_side_begin(const taut_basis *basis, taut_side *s, taut_error *error)
{
    *s = (taut_side){.basis = basis, .exact = 1};
    if (basis == NULL) {
        return TAUT_OK;
    }
    s->exact = taut_basis_degree(basis) >= 0;
    s->panels = s->exact ? 0 : 1;
    return basis->ops->changes->pieces(basis, &s->pieces, error);
}

/* Fills what depends on the number of panels. */
static taut_status divide(taut_side *s, taut_error *error)
{
    double widest = 0;

    if (s->exact) {
        return TAUT_OK;
    }
    taut_free(s->bends);
    s->bends = taut_alloc((size_t)s->pieces.count * (size_t)s->panels * 8, sizeof(double));
    if (s->bends == NULL) {
        return taut_fail_memory(error);
    }
    for (int p = 0; p < s->pieces.count; p++) {
        const taut_basis *piece = s->pieces.items[p]->to;
        const double lo = taut_basis_lo(piece), h = (taut_basis_hi(piece) - lo) / s->panels;
        widest = fmax(widest, h);
        for (int k = 0; k < s->panels; k++) {
            double u[4 * 4];
            double *to = s->bends + 8 * ((size_t)p * (size_t)s->panels + (size_t)k);
            piece->ops->eval(piece, 0, lo + h * (k + 0.5), 3, u);
            for (int i = 0; i < 8; i++) {
                to[i] = u[8 + i];
            }
        }
    }
    s->basis->ops->changes->growth(widest / 2, &s->at, &s->slope);
    s->factor = pow(widest, 6) / 46080;
    return TAUT_OK;
}

/* A patch: its points [rows][columns][3]. */
typedef struct patch {
    int rows, columns;
    double *points;
} patch;

static double length_of(const double *x)
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

/* out = sum_i weights[i] x[i * stride], vectors of 3. */
static void combine(int count, const double *weights, const double *x, size_t stride, double *out)
{
    out[0] = out[1] = out[2] = 0;
    for (int i = 0; i < count; i++) {
        const double *p = x + (size_t)i * stride;
        out[0] += weights[i] * p[0];
        out[1] += weights[i] * p[1];
        out[2] += weights[i] * p[2];
    }
}

/* Largest x - H x along one direction of a patch with four points that way: `across` lines of
 * points, each `line` numbers after the last, its points `step` numbers apart. */
static double along_bound(const taut_side *s, int piece, const patch *net, int across, size_t line,
                          size_t step)
{
    double largest = 0;
    for (int k = 0; k < s->panels; k++) {
        const double *bends = s->bends + 8 * ((size_t)piece * (size_t)s->panels + (size_t)k);
        for (int j = 0; j < across; j++) {
            double y[3], slope[3];
            combine(4, bends, net->points + (size_t)j * line, step, y);
            combine(4, bends + 4, net->points + (size_t)j * line, step, slope);
            largest = fmax(largest, s->at * length_of(y) + s->slope * length_of(slope));
        }
    }
    return s->factor * largest;
}

/* Largest (1 - H_u)(1 - H_v) x on a patch of 4 by 4 points. */
static double mixed_bound(const taut_side *u, int pu, const taut_side *v, int pv, const patch *net)
{
    double largest = 0;
    for (int k = 0; k < u->panels; k++) {
        const double *bu = u->bends + 8 * ((size_t)pu * (size_t)u->panels + (size_t)k);
        double rows[2][4][3]; /* y along u, and its slope, for each column */
        for (int j = 0; j < 4; j++) {
            combine(4, bu, net->points + 3 * (size_t)j, 12, rows[0][j]);
            combine(4, bu + 4, net->points + 3 * (size_t)j, 12, rows[1][j]);
        }
        for (int l = 0; l < v->panels; l++) {
            const double *bv = v->bends + 8 * ((size_t)pv * (size_t)v->panels + (size_t)l);
            double sum = 0, x[3];
            for (int a = 0; a < 2; a++) {
                for (int b = 0; b < 2; b++) {
                    combine(4, bv + 4 * (size_t)b, rows[a][0], 3, x);
                    sum += (a == 0 ? u->at : u->slope) * (b == 0 ? v->at : v->slope) * length_of(x);
                }
            }
            largest = fmax(largest, sum);
        }
    }
    return u->factor * v->factor * largest;
}

/* Adds one patch to the largest distances. */
static void add_patch(const taut_side *u, int p, const taut_side *v, int q,
                      const taut_lattice *lattice, taut_distances *d)
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
    d->along[0] = fmax(d->along[0], e[0]);
    d->along[1] = fmax(d->along[1], e[1]);
    d->total = fmax(d->total, e[0] + e[1] + mixed);
}

/* Adds the patches of one strip: itself where there is no second direction. */
static taut_status add_strip(const taut_side *u, int p, const taut_side *v,
                             const taut_lattice *strip, taut_distances *d, taut_error *error)
{
    taut_status status = TAUT_OK;

    if (v->basis == NULL) {
        add_patch(u, p, v, 0, strip, d);
    }
    for (int q = 0; status == TAUT_OK && q < v->pieces.count; q++) {
        taut_lattice one = {{0, 0}, 0, NULL};
        status = taut_lattice_change(strip, TAUT_ALONG_V, v->pieces.items[q], &one, error);
        if (status == TAUT_OK) {
            add_patch(u, p, v, q, &one, d);
        }
        taut_lattice_free(&one);
    }
    return status;
}

taut_status taut_nurbs_prove(const taut_lattice *whole, taut_side *u, taut_side *v,
                             taut_distances *d, taut_error *error)
{
    taut_status status = divide(u, error);

    *d = (taut_distances){{0, 0}, 0};
    if (status == TAUT_OK) {
        status = divide(v, error);
    }
    for (int p = 0; status == TAUT_OK && p < u->pieces.count; p++) {
        taut_lattice strip = {{0, 0}, 0, NULL};
        status = taut_lattice_change(whole, TAUT_ALONG_U, u->pieces.items[p], &strip, error);
        if (status == TAUT_OK) {
            status = add_strip(u, p, v, &strip, d, error);
        }
        taut_lattice_free(&strip);
    }
    return status;
}
