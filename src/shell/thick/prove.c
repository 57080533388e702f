/* prove.c -- how far sides are from where they belong, proved.
 *
 * A side is x^ + h n^ where x + h n belongs, h = T/2 or -T/2, so that with d = x^ - x and e = n^ - n
 *
 *     |(x^ + h n^) - (x + h n)| <= |d| + T/2 |e|
 *
 * x = X / w is a spline, rational or not, and n = N / |N| is not. Of n^ let s be the part across n and c the part along it:
 *
 *     s = |n^ x N| / |N|,     c^2 + s^2 = |n^|^2,     |e|^2 = s^2 + (c - 1)^2,     c - 1 = (|n^|^2 - 1 - s^2) / (c + 1)
 *
 * On a cell, where all are polynomials, Bernstein coefficients bound w x^ - X, |n^|^2 - 1 and n^ x N' from above, w and N' . a from
 * below ([Farouki2012] 4): N' = w^3 N, and a is its direction in the middle, so that |N'| >= N' . a. As s and |n^|^2 - 1 are small,
 * c does not vanish, and is positive all over the cell where it is at one place.
 *
 * Cells whose bound is well above what was found are halved both ways, a few times. What rounding may have done to the coefficients
 * is added.
 */
#include "core/constants.h"
#include "core/vec3.h"
#include "geometry/lattice.h"
#include "numeric/bernstein.h"
#include "shell/thick/parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    DEGREE_MAX = 25, /* of what is proved: that of CAD systems */
    HALVED_MAX = 3   /* how often a cell is halved */
};

enum { X, X_U, X_V, PLACE, MOVE, NORMAL, ONE, SCRATCH, FORMS };

static const double well_above = 1.2; /* times what was found */
static const double well_within =
    1.0 / 16; /* of the tolerance: what is below is not looked at again */
static const double one_break = 8 * TAUT_UNIT_ROUNDOFF; /* shares nearer than this are one */

/* A polynomial on a cell: nets of Bernstein coefficients [nu + 1][nv + 1][dim], each times its two binomials. */
typedef struct patch {
    int nu, nv, dim;
    double *a;
} patch;

/* A direction of a surface and of its sides. */
typedef struct line {
    const taut_basis *own, *side;
    double lo, width; /* of the own range */
    int count;        /* of breaks */
    double *breaks;   /* [count]: shares, all of both */
} line;

/* Rows of one direction on a cell: Bernstein coefficients out of the control points of a span. */
typedef struct rows {
    int degree, first;
    double value[DEGREE_MAX + 1][DEGREE_MAX + 1];
    double slope[DEGREE_MAX + 1][DEGREE_MAX + 1]; /* of the derivative, of degree one less */
} rows;

typedef struct proving {
    taut_lattice lattice;         /* of the surface */
    const double *places, *moves; /* nets of the sides */
    line lines[2];
    double half, sign; /* T/2; -1 where the sheet is turned */
    double rounding;   /* of a coefficient, in units of what it is a sum of */
    double size;       /* the largest coordinate */
    double enough;     /* a bound that need not be lower */
    double found;      /* the largest so far */
    rows own[2], side[2];
    patch form[FORMS]; /* of a cell; X: (wx, wy, wz, w), less its middle times w */
} proving;

/* ---- splines on a cell ---- */

/* The knots of a basis and its degree; those of a bezier one in `room`. */
static const double *knots_of(const taut_basis *basis, double *room, int *degree)
{
    taut_basis_spec spec;
    taut_basis_spec_of(basis, &spec);
    *degree = taut_basis_degree(basis);
    if (spec.knot_count > 0) {
        return spec.knots;
    }
    for (int k = 0; k <= 2 * *degree + 1; k++) {
        room[k] = k <= *degree ? taut_basis_lo(basis) : taut_basis_hi(basis);
    }
    return room;
}

/* Coefficient k of a spline of this degree on [a, b], by its control points from `first` on: its blossom at degree - k times a and k
 * times b ([Farin2002] 10). knots: those from `first` on. */
static void blossom(int degree, const double *knots, double a, double b, int k, double *row)
{
    double net[DEGREE_MAX + 1][DEGREE_MAX + 1] = {{0}};
    for (int i = 0; i <= degree; i++) {
        net[i][i] = 1;
    }
    for (int r = 1; r <= degree; r++) {
        const double t = r <= degree - k ? a : b;
        for (int i = 0; i <= degree - r; i++) {
            const double lo = knots[i + r], hi = knots[i + degree + 1];
            const double part = (t - lo) / (hi - lo);
            for (int c = 0; c <= degree; c++) {
                net[i][c] = (1 - part) * net[i][c] + part * net[i + 1][c];
            }
        }
    }
    memcpy(row, net[0], ((size_t)degree + 1) * sizeof *row);
}

/* The span of a basis around t, and its rows on [a, b]. */
static void find_rows(const taut_basis *basis, double t, double a, double b, rows *at)
{
    double room[2 * DEGREE_MAX + 2], lower[DEGREE_MAX + 1];
    const double *knots = knots_of(basis, room, &at->degree);
    const int degree = at->degree;
    at->first = taut_basis_first(basis, taut_basis_span(basis, t));
    knots += at->first;
    for (int k = 0; k <= degree; k++) {
        blossom(degree, knots, a, b, k, at->value[k]);
    }
    memset(at->slope, 0, sizeof at->slope);
    for (int k = 0; k < degree; k++) {
        blossom(degree - 1, knots + 1, a, b, k, lower);
        for (int i = 0; i < degree; i++) {
            const double part = lower[i] * degree / (knots[i + degree + 1] - knots[i + 1]);
            at->slope[k][i] -= part;
            at->slope[k][i + 1] += part;
        }
    }
}

/* out = the net of control points `net`, local [u degree + 1][v degree + 1][dim], by rows of both directions. */
static void lay_form(const rows *u, int du, const rows *v, int dv, int dim, const double *net,
                     patch *out)
{
    const int nu = u->degree, nv = v->degree;
    double column[DEGREE_MAX + 1][4];
    out->nu = nu - du > 0 ? nu - du : 0;
    out->nv = nv - dv > 0 ? nv - dv : 0;
    out->dim = dim;
    for (int i = 0; i <= out->nu; i++) {
        const double *along = du ? u->slope[i] : u->value[i];
        for (int j = 0; j <= nv; j++) {
            for (int c = 0; c < dim; c++) {
                column[j][c] = 0;
                for (int k = 0; k <= nu; k++) {
                    column[j][c] += along[k] * net[(k * (nv + 1) + j) * dim + c];
                }
            }
        }
        for (int j = 0; j <= out->nv; j++) {
            const double *across = dv ? v->slope[j] : v->value[j];
            const double scale = taut_binomial(out->nu, i) * taut_binomial(out->nv, j);
            for (int c = 0; c < dim; c++) {
                double sum = 0;
                for (int k = 0; k <= nv; k++) {
                    sum += across[k] * column[k][c];
                }
                out->a[(i * (out->nv + 1) + j) * dim + c] = scale * sum;
            }
        }
    }
}

/* ---- the algebra ---- */

static void clear(patch *out, int nu, int nv, int dim)
{
    out->nu = nu;
    out->nv = nv;
    out->dim = dim;
    memset(out->a, 0, ((size_t)nu + 1) * ((size_t)nv + 1) * (size_t)dim * sizeof *out->a);
}

/* out += factor * component ca of a * component cb of b, as component c of out, whose degrees are the sums. */
static void add_product(double factor, const patch *a, int ca, const patch *b, int cb, patch *out,
                        int c)
{
    for (int i = 0; i <= a->nu; i++) {
        for (int j = 0; j <= a->nv; j++) {
            const double by = factor * a->a[(i * (a->nv + 1) + j) * a->dim + ca];
            for (int k = 0; k <= b->nu; k++) {
                const double *from = b->a + (k * (b->nv + 1)) * b->dim + cb;
                double *to = out->a + ((i + k) * (out->nv + 1) + j) * out->dim + c;
                for (int l = 0; l <= b->nv; l++) {
                    to[l * out->dim] += by * from[l * b->dim];
                }
            }
        }
    }
}

/* out = a x b. */
static void cross(const patch *a, const patch *b, patch *out)
{
    clear(out, a->nu + b->nu, a->nv + b->nv, 3);
    for (int c = 0; c < 3; c++) {
        const int d = (c + 1) % 3, e = (c + 2) % 3;
        add_product(1, a, d, b, e, out, c);
        add_product(-1, a, e, b, d, out, c);
    }
}

/* out += factor s a: component c of s, vectors a. */
static void add_scaled(double factor, const patch *s, int c, const patch *a, patch *out)
{
    for (int k = 0; k < 3; k++) {
        add_product(factor, s, c, a, k, out, k);
    }
}

/* 1. */
static void lay_one(int nu, int nv, patch *out)
{
    clear(out, nu, nv, 1);
    for (int i = 0; i <= nu; i++) {
        for (int j = 0; j <= nv; j++) {
            out->a[i * (nv + 1) + j] = taut_binomial(nu, i) * taut_binomial(nv, j);
        }
    }
}

/* Coefficient (i, j). */
static void coefficient(const patch *f, int i, int j, double *value)
{
    const double scale = taut_binomial(f->nu, i) * taut_binomial(f->nv, j);
    for (int c = 0; c < f->dim; c++) {
        value[c] = f->a[(i * (f->nv + 1) + j) * f->dim + c] / scale;
    }
}

/* The largest coefficient, of its first three components. */
static double largest(const patch *f)
{
    double most = 0, value[4] = {0};
    for (int i = 0; i <= f->nu; i++) {
        for (int j = 0; j <= f->nv; j++) {
            coefficient(f, i, j, value);
            most = fmax(most, f->dim >= 3 ? taut_length(value) : fabs(value[0]));
        }
    }
    return most;
}

/* The least and largest of component c. */
static void range_of(const patch *f, int c, double range[2])
{
    range[0] = INFINITY;
    range[1] = -INFINITY;
    for (int i = 0; i <= f->nu; i++) {
        for (int j = 0; j <= f->nv; j++) {
            double value[4];
            coefficient(f, i, j, value);
            range[0] = fmin(range[0], value[c]);
            range[1] = fmax(range[1], value[c]);
        }
    }
}

static double size_of_part(const patch *f, int c)
{
    double range[2];
    range_of(f, c, range);
    return fmax(fabs(range[0]), fabs(range[1]));
}

/* ---- what is bounded ---- */

/* What a cell says: bounds, and what is met at its first corner. */
typedef struct findings {
    double weight[2];            /* w: least, largest */
    double gap, gap_at[3];       /* w x^ - X */
    double length, move_at[3];   /* |n^|^2 - 1; n^ */
    double across;               /* |n^ x N'| */
    double normal, normal_at[3]; /* N' . a from below; N' */
    double weight_at;
} findings;

/* w x^ - X. */
static void bound_gap(proving *p, findings *f)
{
    patch *const form = p->form, *x = &form[X], *place = &form[PLACE], *one = &form[ONE];
    const int rational = x->dim == 4;
    const int more_u = rational || x->nu < TAUT_THICK_DEGREE ? TAUT_THICK_DEGREE : x->nu;
    const int more_v = rational || x->nv < TAUT_THICK_DEGREE ? TAUT_THICK_DEGREE : x->nv;
    const int nu = rational ? x->nu + more_u : more_u, nv = rational ? x->nv + more_v : more_v;
    double first[4] = {0};
    f->weight[0] = f->weight[1] = f->weight_at = 1;
    clear(&form[SCRATCH], nu, nv, 3);
    if (rational) {
        range_of(x, 3, f->weight);
        coefficient(x, 0, 0, first);
        f->weight_at = first[3];
        add_scaled(1, x, 3, place, &form[SCRATCH]);
    } else {
        lay_one(nu - place->nu, nv - place->nv, one);
        add_scaled(1, one, 0, place, &form[SCRATCH]);
    }
    lay_one(nu - x->nu, nv - x->nv, one);
    add_scaled(-1, one, 0, x, &form[SCRATCH]);
    f->gap = largest(&form[SCRATCH]) +
             p->rounding * (f->weight[1] * (p->size + largest(place)) + largest(x));
    coefficient(&form[SCRATCH], 0, 0, f->gap_at);
}

/* |n^|^2 - 1. */
static void bound_length(proving *p, findings *f)
{
    patch *const form = p->form, *move = &form[MOVE];
    const double most = largest(move);
    lay_one(2 * move->nu, 2 * move->nv, &form[SCRATCH]);
    for (int k = 0; k < (2 * move->nu + 1) * (2 * move->nv + 1); k++) {
        form[SCRATCH].a[k] = -form[SCRATCH].a[k];
    }
    for (int c = 0; c < 3; c++) {
        add_product(1, move, c, move, c, &form[SCRATCH], 0);
    }
    f->length = largest(&form[SCRATCH]) + p->rounding * (1 + most * most);
    coefficient(move, 0, 0, f->move_at);
}

/* N' = X_u x X_v, or w X_u x X_v + w_v X x X_u + w_u X_v x X; returns what it is a sum of. */
static double lay_normal(proving *p, const findings *f)
{
    patch *const form = p->form, *x = &form[X], *xu = &form[X_U], *xv = &form[X_V];
    const double along = largest(xu), across = largest(xv);
    if (x->dim == 3) {
        cross(xu, xv, &form[NORMAL]);
        return along * across;
    }
    clear(&form[NORMAL], xu->nu + 2 * x->nu, xv->nv + 2 * x->nv, 3);
    cross(xu, xv, &form[SCRATCH]);
    add_scaled(1, x, 3, &form[SCRATCH], &form[NORMAL]);
    cross(x, xu, &form[SCRATCH]);
    add_scaled(1, xv, 3, &form[SCRATCH], &form[NORMAL]);
    cross(xv, x, &form[SCRATCH]);
    add_scaled(1, xu, 3, &form[SCRATCH], &form[NORMAL]);
    return f->weight[1] * along * across +
           largest(x) * (size_of_part(xv, 3) * along + size_of_part(xu, 3) * across);
}

/* |N'| and |n^ x N'|. */
static void bound_across(proving *p, findings *f)
{
    patch *const form = p->form, *normal = &form[NORMAL], *move = &form[MOVE];
    const double terms = lay_normal(p, f);
    double sum[3] = {0}, least = INFINITY;
    for (int pass = 0; pass < 2; pass++) {
        const double length = taut_length(sum);
        for (int i = 0; i <= normal->nu; i++) {
            for (int j = 0; j <= normal->nv; j++) {
                double value[3];
                coefficient(normal, i, j, value);
                if (pass == 0) {
                    taut_add_scaled(1, value, sum);
                } else {
                    least = fmin(least, taut_dot(value, sum) / length);
                }
            }
        }
    }
    f->normal = least - p->rounding * terms;
    coefficient(normal, 0, 0, f->normal_at);
    cross(move, normal, &form[SCRATCH]);
    f->across = largest(&form[SCRATCH]) + p->rounding * largest(move) * terms;
}

/* What was found at the first corner of a cell. */
static double find_distance(const proving *p, const findings *f)
{
    const double length = taut_length(f->normal_at);
    double most = 0;
    for (int side = -1; side <= 1; side += 2) {
        double off[3] = {0};
        taut_add_scaled(1 / f->weight_at, f->gap_at, off);
        taut_add_scaled(side * p->half, f->move_at, off);
        taut_add_scaled(-side * p->half * p->sign / length, f->normal_at, off);
        most = fmax(most, taut_length(off));
    }
    return most;
}

/* |d| + T/2 |e|, or infinite. */
static double distance_of(const proving *p, const findings *f)
{
    const double s = f->across / f->normal;
    const double least = 1 - f->length - s * s; /* of c^2 */
    if (!(f->normal > 0) || !(f->weight[0] > 0) || !(least > 0) ||
        !(p->sign * taut_dot(f->move_at, f->normal_at) > 0)) {
        return INFINITY;
    }
    const double along = (f->length + s * s) / (1 + sqrt(least));
    const double bound = f->gap / f->weight[0] + p->half * sqrt(s * s + along * along);
    return bound >= 0 ? bound : INFINITY;
}

/* ---- cells ---- */

/* The control points of a span of both directions, less `middle` (times the weight). */
static void gather(const double *net, int across, int dim, const rows *u, const rows *v,
                   const double *middle, double *local)
{
    for (int i = 0; i <= u->degree; i++) {
        for (int j = 0; j <= v->degree; j++) {
            const double *from =
                net +
                ((size_t)(u->first + i) * (size_t)across + (size_t)(v->first + j)) * (size_t)dim;
            const double by = dim == 4 ? from[3] : 1;
            for (int c = 0; c < dim; c++) {
                *local++ = c < 3 && middle != NULL ? from[c] - by * middle[c] : from[c];
            }
        }
    }
}

static void lay_forms(proving *p)
{
    double local[(DEGREE_MAX + 1) * (DEGREE_MAX + 1) * 4], middle[3];
    const rows *u = &p->own[0], *v = &p->own[1], *su = &p->side[0], *sv = &p->side[1];
    const int across = taut_basis_count(p->lines[1].side), dim = p->lattice.dim;
    memcpy(middle, p->places + 3 * ((size_t)su->first * (size_t)across + (size_t)sv->first),
           sizeof middle);
    gather(p->lattice.net, p->lattice.count[1], dim, u, v, middle, local);
    lay_form(u, 0, v, 0, dim, local, &p->form[X]);
    lay_form(u, 1, v, 0, dim, local, &p->form[X_U]);
    lay_form(u, 0, v, 1, dim, local, &p->form[X_V]);
    gather(p->places, across, 3, su, sv, middle, local);
    lay_form(su, 0, sv, 0, 3, local, &p->form[PLACE]);
    gather(p->moves, across, 3, su, sv, NULL, local);
    lay_form(su, 0, sv, 0, 3, local, &p->form[MOVE]);
}

/* The bound of the cell [at[0], at[1]] x [at[2], at[3]] of shares. */
static double bound_cell(proving *p, const double at[4])
{
    findings f;
    for (int d = 0; d < 2; d++) {
        const line *l = &p->lines[d];
        const double a = at[2 * d], b = at[2 * d + 1], t = a + (b - a) / 2;
        find_rows(l->side, t, a, b, &p->side[d]);
        find_rows(l->own, l->lo + t * l->width, l->lo + a * l->width, l->lo + b * l->width,
                  &p->own[d]);
    }
    lay_forms(p);
    bound_gap(p, &f);
    bound_length(p, &f);
    bound_across(p, &f);
    p->found = fmax(p->found, find_distance(p, &f));
    return distance_of(p, &f);
}

/* The same, of its parts where these are halved. */
static double bound_parts(proving *p, const double at[4], int halved)
{
    const double whole = bound_cell(p, at);
    const double u = at[0] + (at[1] - at[0]) / 2, v = at[2] + (at[3] - at[2]) / 2;
    const double parts[4][4] = {
        {at[0], u, at[2], v}, {at[0], u, v, at[3]}, {u, at[1], at[2], v}, {u, at[1], v, at[3]}};
    double most = 0;
    if (halved == HALVED_MAX || whole <= fmax(well_above * p->found, p->enough)) {
        return whole;
    }
    for (int k = 0; k < 4; k++) {
        most = fmax(most, bound_parts(p, parts[k], halved + 1));
    }
    return most;
}

/* ---- a surface ---- */

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

/* All breaks of a direction, of the surface and of its sides. */
static taut_status lay_line(const taut_basis *own, const taut_basis *side, taut_arena *arena,
                            line *l)
{
    const int sides = taut_basis_span_count(side) + 1, owns = taut_basis_span_count(own) + 1;
    *l = (line){.own = own,
                .side = side,
                .lo = taut_basis_lo(own),
                .width = taut_basis_hi(own) - taut_basis_lo(own)};
    double *at = taut_arena_take(arena, (size_t)sides + (size_t)owns, sizeof *at);
    if (at == NULL) {
        return TAUT_NO_MEMORY;
    }
    memcpy(at, taut_basis_breaks(side), (size_t)sides * sizeof *at);
    for (int k = 0; k < owns; k++) {
        at[sides + k] = fmin(fmax((taut_basis_breaks(own)[k] - l->lo) / l->width, 0), 1);
    }
    qsort(at, (size_t)sides + (size_t)owns, sizeof *at, by_size);
    for (int k = 0; k < sides + owns; k++) {
        if (l->count == 0 || at[k] - at[l->count - 1] > one_break) {
            at[l->count++] = at[k];
        }
    }
    at[l->count - 1] = 1;
    l->breaks = at;
    return TAUT_OK;
}

/* Room for forms of these degrees. */
static taut_status take_forms(int pu, int pv, taut_arena *arena, proving *p)
{
    const size_t most_u = 3 * (size_t)pu + 2 * TAUT_THICK_DEGREE + 1;
    const size_t most_v = 3 * (size_t)pv + 2 * TAUT_THICK_DEGREE + 1;
    for (int k = 0; k < FORMS; k++) {
        p->form[k].a = taut_arena_take(arena, most_u * most_v, 4 * sizeof(double));
    }
    return taut_arena_status(arena);
}

static double size_of_net(const taut_lattice *lattice)
{
    double most = 0;
    for (size_t k = 0; k < (size_t)lattice->count[0] * (size_t)lattice->count[1]; k++) {
        const double *x = lattice->net + k * (size_t)lattice->dim;
        most = fmax(most, taut_largest_coordinate(x) / (lattice->dim == 4 ? x[3] : 1));
    }
    return most;
}

static taut_status begin(const taut_thick_work *work, int face, const taut_thick_sides *sides,
                         taut_arena *arena, proving *p)
{
    const taut_surface *surface = work->surfaces[face];
    const int pu = taut_basis_degree(taut_surface_u(surface));
    const int pv = taut_basis_degree(taut_surface_v(surface));
    p->places = sides->places;
    p->moves = sides->moves;
    p->half = work->half;
    p->sign = work->shells->faces[face].turned ? -1 : 1;
    p->rounding = (256 + 16 * (pu + 1) * (pv + 1)) * TAUT_UNIT_ROUNDOFF;
    if (lay_line(taut_surface_u(surface), sides->u, arena, &p->lines[0]) != TAUT_OK ||
        lay_line(taut_surface_v(surface), sides->v, arena, &p->lines[1]) != TAUT_OK ||
        take_forms(pu, pv, arena, p) != TAUT_OK ||
        taut_lattice_of_surface(surface, &p->lattice, NULL) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    p->size = size_of_net(&p->lattice);
    return TAUT_OK;
}

taut_status taut_thick_prove(const taut_thick_work *work, int face, const taut_thick_sides *sides,
                             double tolerance, double found, double *bound)
{
    const taut_surface *surface = work->surfaces[face];
    taut_arena *arena = taut_arena_new();
    proving *p = taut_arena_take(arena, 1, sizeof *p);
    *bound = INFINITY;
    if (taut_basis_degree(taut_surface_u(surface)) > DEGREE_MAX ||
        taut_basis_degree(taut_surface_v(surface)) > DEGREE_MAX) {
        taut_arena_free(arena);
        return TAUT_OK;
    }
    if (p == NULL || begin(work, face, sides, arena, p) != TAUT_OK) {
        taut_arena_free(arena);
        return TAUT_NO_MEMORY;
    }
    p->found = found;
    p->enough = well_within * tolerance;
    *bound = 0;
    for (int i = 0; i + 1 < p->lines[0].count; i++) {
        for (int j = 0; j + 1 < p->lines[1].count; j++) {
            const double *u = p->lines[0].breaks + i, *v = p->lines[1].breaks + j;
            const double at[4] = {u[0], u[1], v[0], v[1]};
            *bound = fmax(*bound, bound_parts(p, at, 0));
        }
    }
    taut_lattice_free(&p->lattice);
    taut_arena_free(arena);
    return TAUT_OK;
}
