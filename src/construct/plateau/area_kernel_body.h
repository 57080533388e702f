/* area_kernel_body.h -- the loops behind area_kernel.h, compiled once per instruction set.
 *
 * The including file defines AREA_LANES (doubles in a vector) and AREA_SQRT(vector). A lane is one
 * point or one function, and its sums run in one order: results are the same bit for bit at every
 * width. Vectors are gcc's and clang's vector extension.
 */
#include "construct/plateau/area_kernel.h"

#include <math.h>
#include <stdint.h>

typedef double lanes __attribute__((vector_size(8 * AREA_LANES), aligned(8), may_alias));
typedef int64_t bits __attribute__((vector_size(8 * AREA_LANES), aligned(8), may_alias));

#define AT(pointer) (*(lanes *)(void *)(pointer))
#define OF(pointer) (*(const lanes *)(const void *)(pointer))
#define INLINE static inline __attribute__((always_inline))

static void area_contract(int local, const double *n, const double *d, const double *rows,
                          size_t length, double *still, double *along)
{
    for (size_t c = 0; c < length; c += AREA_LANES) {
        lanes s = {0}, t = {0};
        for (int a = 0; a < local; a++) {
            const lanes row = OF(rows + (size_t)a * length + c);
            s += row * n[a];
            t += row * d[a];
        }
        AT(still + c) = s;
        AT(along + c) = t;
    }
}

static void area_spread(int local, const double *n, const double *d, const double *still,
                        const double *along, size_t length, double *rows)
{
    for (int a = 0; a < local; a++, rows += length) {
        for (size_t c = 0; c < length; c += AREA_LANES) {
            AT(rows + c) += OF(still + c) * n[a] + OF(along + c) * d[a];
        }
    }
}

typedef struct vector {
    lanes x, y, z;
} vector;

INLINE lanes dot(vector a, vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

INLINE vector cross(vector a, vector b)
{
    return (vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

INLINE vector scaled(lanes r, vector a)
{
    return (vector){r * a.x, r * a.y, r * a.z};
}

INLINE vector plus(vector a, vector b)
{
    return (vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

INLINE void add_plane(lanes n, const double *plane, size_t stride, vector *sum)
{
    sum->x += n * plane[0];
    sum->y += n * plane[stride];
    sum->z += n * plane[2 * stride];
}

/* x_u, x_v at points at .. at + AREA_LANES - 1; with weights (X_u - (w_u / w) X) / w. */
INLINE void find_slopes(const taut_area_cell *p, int at, vector *u, vector *v)
{
    const size_t group = (size_t)p->group;
    vector x = {{0}, {0}, {0}}, xu = x, xv = x;

    for (int b = 0; b < p->local; b++) {
        const lanes n = OF(p->value + (size_t)b * group + at);
        add_plane(n, p->along + b, p->stride, &xu);
        add_plane(OF(p->slope + (size_t)b * group + at), p->still + b, p->stride, &xv);
        if (p->quotient != NULL) {
            add_plane(n, p->still + b, p->stride, &x);
        }
    }
    if (p->quotient != NULL) {
        const lanes q = OF(p->quotient + at);
        xu = scaled(q, plus(xu, scaled(-OF(p->quotient + group + at), x)));
        xv = scaled(q, plus(xv, scaled(-OF(p->quotient + 2 * group + at), x)));
    }
    *u = xu;
    *v = xv;
}

/* Fluxes of the whole cell: f_u and f_v with which N_i' N_j and N_i N_j' go back, and, with
 * weights, what N_i N_j takes. */
typedef struct fluxes {
    double u[3][TAUT_AREA_GROUP_MAX], v[3][TAUT_AREA_GROUP_MAX], back[3][TAUT_AREA_GROUP_MAX];
} fluxes;

INLINE void store_flux(vector f, int at, double to[3][TAUT_AREA_GROUP_MAX])
{
    AT(to[0] + at) = f.x;
    AT(to[1] + at) = f.y;
    AT(to[2] + at) = f.z;
}

INLINE void keep_fluxes(const taut_area_cell *p, int at, vector u, vector v, fluxes *f)
{
    if (p->quotient != NULL) {
        const lanes qu = OF(p->quotient + p->group + at), qv = OF(p->quotient + 2 * p->group + at);
        u = scaled(OF(p->quotient + at), u);
        v = scaled(OF(p->quotient + at), v);
        store_flux(plus(scaled(qu, u), scaled(qv, v)), at, f->back);
    }
    store_flux(u, at, f->u);
    store_flux(v, at, f->v);
}

/* spread_still += N_j' f_v - N_j back, spread_u += N_j f_u; lanes are functions here. */
INLINE void gather_fluxes(const taut_area_cell *p, const fluxes *f)
{
    for (int b = 0; b < p->wide; b += AREA_LANES) {
        for (size_t c = 0; c < 3; c++) {
            lanes still = {0}, along = {0};
            for (int g = 0; g < p->nodes; g++) {
                const lanes n = OF(p->values + (size_t)g * (size_t)p->wide + b);
                still += OF(p->slopes + (size_t)g * (size_t)p->wide + b) * f->v[c][g];
                along += n * f->u[c][g];
                if (p->quotient != NULL) {
                    still -= n * f->back[c][g];
                }
            }
            AT(p->spread_still + c * p->stride + b) += still;
            AT(p->spread_u + c * p->stride + b) += along;
        }
    }
}

static void area_elements(const taut_area_cell *p, double *w)
{
    for (int at = 0; at < p->group; at += AREA_LANES) {
        vector u, v;
        find_slopes(p, at, &u, &v);
        const vector n = cross(u, v);
        AT(w + at) = AREA_SQRT(dot(n, n));
    }
}

static void area_gradient(const taut_area_cell *p, const double *weights, double *state, double *w)
{
    const size_t group = (size_t)p->group;
    const lanes one = (lanes){0} + 1, least = (lanes){0} + 0x1p-500;
    fluxes f;

    for (int at = 0; at < p->group; at += AREA_LANES) {
        vector u, v, n;
        find_slopes(p, at, &u, &v);
        n = cross(u, v);
        const lanes size = AREA_SQRT(dot(n, n));
        /* no normal where W is 0 */
        const bits there = (bits)(size > least);
        const lanes inverse = (lanes)((bits)(one / size) & there);
        const lanes weight = (lanes)((bits)OF(weights + at) & there), part = weight * inverse;
        n = scaled(inverse, n);
        double *s = state + at;
        AT(s) = n.x;
        AT(s + group) = n.y;
        AT(s + 2 * group) = n.z;
        AT(s + 3 * group) = part * dot(u, u);
        AT(s + 4 * group) = part * dot(u, v);
        AT(s + 5 * group) = part * dot(v, v);
        AT(s + 6 * group) = weight;
        AT(w + at) = size;
        keep_fluxes(p, at, scaled(weight, cross(v, n)), scaled(weight, cross(n, u)), &f);
    }
    gather_fluxes(p, &f);
}

/* area.h's df_u, df_v. */
static void area_product(const taut_area_cell *p, double theta, const double *state)
{
    const size_t group = (size_t)p->group;
    const double rest = 1 - theta;
    fluxes f;

    for (int at = 0; at < p->group; at += AREA_LANES) {
        const double *s = state + at;
        const vector n = {OF(s), OF(s + group), OF(s + 2 * group)};
        const lanes e = OF(s + 3 * group), m = OF(s + 4 * group), g = OF(s + 5 * group);
        const lanes weight = OF(s + 6 * group) * rest;
        vector u, v;
        find_slopes(p, at, &u, &v);
        const lanes nu = dot(n, u) * rest, nv = dot(n, v) * rest;
        const lanes mixed = -m * theta;
        const vector fu = plus(scaled(g * nu - m * nv, n), scaled(weight, cross(v, n)));
        const vector fv = plus(scaled(e * nv - m * nu, n), scaled(weight, cross(n, u)));
        keep_fluxes(p, at, plus(fu, plus(scaled(g * theta, u), scaled(mixed, v))),
                    plus(fv, plus(scaled(e * theta, v), scaled(mixed, u))), &f);
    }
    gather_fluxes(p, &f);
}

/* One row of the element, AREA_LANES functions q side by side. */
INLINE void add_pairs(const taut_area_pairs *p, size_t row, size_t at, double *element)
{
    const size_t wide = (size_t)p->wide;
    lanes sum[TAUT_AREA_BLOCK];

    for (size_t c = 0; c < TAUT_AREA_BLOCK; c++) {
        sum[c] = p->begins ? (lanes){0} : OF(element + c * wide + at);
    }
    for (int g = 0; g < p->nodes; g++) {
        const size_t from = (size_t)g * wide;
        const double *normal = p->normal + g * (TAUT_AREA_BLOCK - 1);
        const lanes qu = OF(p->slope_u + from + at), qv = OF(p->slope_v + from + at);
        const lanes s = p->flux_u[from + row] * qu + p->flux_v[from + row] * qv;
        const lanes t = p->slope_v[from + row] * qu - p->slope_u[from + row] * qv;
        for (int c = 0; c < 6; c++) {
            sum[c] += s * normal[c];
        }
        for (int c = 6; c < 9; c++) {
            sum[c] += t * normal[c];
        }
        sum[9] += s;
    }
    for (size_t c = 0; c < TAUT_AREA_BLOCK; c++) {
        AT(element + c * wide + at) = sum[c];
    }
}

static void area_pairs(const taut_area_pairs *points, double *element)
{
    const size_t row = TAUT_AREA_BLOCK * (size_t)points->wide;
    for (size_t p = 0; p < (size_t)points->local; p++) {
        for (size_t q = 0; q <= p; q += AREA_LANES) {
            add_pairs(points, p, q, element + p * row);
        }
    }
}

#define AREA_OPS(title)                                                                            \
    {                                                                                              \
        .name = (title), .lanes = AREA_LANES, .contract = area_contract, .spread = area_spread,    \
        .area = area_elements, .gradient = area_gradient, .product = area_product,                 \
        .pairs = area_pairs                                                                        \
    }
