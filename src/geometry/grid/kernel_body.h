/* kernel_body.h -- the loops behind kernel.h, compiled once per instruction set.
 *
 * The including file defines GRID_LANES (doubles in a vector), GRID_STREAM(pointer, four) for a
 * store past the caches, GRID_STREAMS (0: that is a plain store, and no second code is made for it)
 * and GRID_FENCE(). A lane is one point, and its sums run in one order:
 * results are the same bit for bit at every width. Vectors are gcc's and clang's vector extension,
 * which both lower to whatever the target has.
 */
#include "geometry/grid/kernel.h"
#include "taut/surface.h"

#include <stdint.h>

typedef double lanes __attribute__((vector_size(8 * GRID_LANES), aligned(8), may_alias));
typedef double four __attribute__((vector_size(32), aligned(8), may_alias));

#define LANES_AT(pointer) (*(lanes *)(void *)(pointer))
#define LANES_OF(pointer) (*(const lanes *)(const void *)(pointer))
#define FOUR_AT(pointer) (*(four *)(void *)(pointer))
#define FOUR_OF(pointer) (*(const four *)(const void *)(pointer))
#define INLINE static inline __attribute__((always_inline))

enum { GROUP = 2 * GRID_LANES };

static void grid_contract(int local, const double *n, const double *rows, size_t row_stride,
                          size_t length, double *polygon)
{
    size_t c = 0;
    for (; c + GRID_LANES <= length; c += GRID_LANES) {
        lanes sum = {0};
        for (int a = 0; a < local; a++) {
            sum += LANES_OF(rows + (size_t)a * row_stride + c) * n[a];
        }
        LANES_AT(polygon + c) = sum;
    }
    for (; c < length; c++) {
        double sum = 0;
        for (int a = 0; a < local; a++) {
            sum += rows[(size_t)a * row_stride + c] * n[a];
        }
        polygon[c] = sum;
    }
}

/* (wx, wy, wz, w) of a vector of points; w stays unused where there are no weights. */
typedef struct sum {
    lanes x, y, z, w;
} sum;

INLINE void sum_add(int dim, lanes n, const double *q, sum *s)
{
    s->x += n * q[0];
    s->y += n * q[1];
    s->z += n * q[2];
    if (dim == 4) {
        s->w += n * q[3];
    }
}

/* (s - a x - b y) / w, the shape of each line of the quotient rule, with 1/w given. */
INLINE sum sum_less(sum s, lanes a, sum x, lanes b, sum y, lanes inverse)
{
    return (sum){.x = (s.x - a * x.x - b * y.x) * inverse,
                 .y = (s.y - a * x.y - b * y.y) * inverse,
                 .z = (s.z - a * x.z - b * y.z) * inverse};
}

INLINE sum sum_less_one(sum s, lanes a, sum x, lanes inverse)
{
    return (sum){.x = (s.x - a * x.x) * inverse,
                 .y = (s.y - a * x.y) * inverse,
                 .z = (s.z - a * x.z) * inverse};
}

INLINE void sum_store(sum s, int vector, double *planes)
{
    LANES_AT(planes + 3 * vector * GROUP) = s.x;
    LANES_AT(planes + (3 * vector + 1) * GROUP) = s.y;
    LANES_AT(planes + (3 * vector + 2) * GROUP) = s.z;
}

/* Positions of a group: both vectors of points together, so that each polygon number is fetched
 * once for both. */
INLINE void group_positions(int dim, int local, const double *basis, const double *q,
                            double *planes)
{
    const lanes one = (lanes){0} + 1.0;
    sum s = {{0}, {0}, {0}, {0}}, t = s;

    for (int b = 0; b < local; b++) {
        sum_add(dim, LANES_OF(basis + b * GROUP), q + dim * b, &s);
        sum_add(dim, LANES_OF(basis + b * GROUP + GRID_LANES), q + dim * b, &t);
    }
    if (dim == 4) {
        const lanes inverse_s = one / s.w, inverse_t = one / t.w;
        s = (sum){.x = s.x * inverse_s, .y = s.y * inverse_s, .z = s.z * inverse_s};
        t = (sum){.x = t.x * inverse_t, .y = t.y * inverse_t, .z = t.z * inverse_t};
    }
    sum_store(s, 0, planes);
    sum_store(t, 0, planes + GRID_LANES);
}

/* One vector of points with derivatives; the sums that share a polygon are made together. The
 * quotient rule: x_u = (X_u - w_u x) / w, x_uv = (X_uv - w_u x_v - w_v x_u - w_uv x) / w, ... */
INLINE void group_derivatives(int order, int dim, int local, const double *basis,
                              const double *polygons, size_t polygon_stride, double *planes)
{
    const lanes zero = {0}, one = zero + 1.0;
    const double *const dv = basis + local * GROUP, *const dvv = dv + local * GROUP;
    const double *const q = polygons, *const qu = q + polygon_stride,
                        *const quu = qu + polygon_stride;
    sum x = {{0}, {0}, {0}, {0}}, xv = x, xvv = x, xu = x, xuv = x, xuu = x;
    lanes inverse = one;

    for (int b = 0; b < local; b++) {
        sum_add(dim, LANES_OF(basis + b * GROUP), q + dim * b, &x);
        sum_add(dim, LANES_OF(dv + b * GROUP), q + dim * b, &xv);
        if (order > 1) {
            sum_add(dim, LANES_OF(dvv + b * GROUP), q + dim * b, &xvv);
        }
    }
    const lanes wv = xv.w, twice_wv = wv + wv;
    if (dim == 4) {
        inverse = one / x.w;
        x = (sum){.x = x.x * inverse, .y = x.y * inverse, .z = x.z * inverse};
        xv = sum_less_one(xv, wv, x, inverse);
        xvv = sum_less(xvv, xvv.w, x, twice_wv, xv, inverse);
    }
    sum_store(x, TAUT_X, planes);
    sum_store(xv, TAUT_XV, planes);
    if (order > 1) {
        sum_store(xvv, TAUT_XVV, planes);
    }
    for (int b = 0; b < local; b++) {
        sum_add(dim, LANES_OF(basis + b * GROUP), qu + dim * b, &xu);
        if (order > 1) {
            sum_add(dim, LANES_OF(dv + b * GROUP), qu + dim * b, &xuv);
        }
    }
    const lanes wu = xu.w, twice_wu = wu + wu;
    if (dim == 4) {
        xu = sum_less_one(xu, wu, x, inverse);
        xuv = sum_less(xuv, xuv.w, x, wv, xu, one);
        xuv = sum_less_one(xuv, wu, xv, inverse);
    }
    sum_store(xu, TAUT_XU, planes);
    if (order > 1) {
        sum_store(xuv, TAUT_XUV, planes);
        for (int b = 0; b < local; b++) {
            sum_add(dim, LANES_OF(basis + b * GROUP), quu + dim * b, &xuu);
        }
        if (dim == 4) {
            xuu = sum_less(xuu, xuu.w, x, twice_wu, xu, inverse);
        }
        sum_store(xuu, TAUT_XUU, planes);
    }
}

#define PUT(pointer, value)                                                                        \
    do {                                                                                           \
        if (streaming) {                                                                           \
            GRID_STREAM(pointer, value);                                                           \
        } else {                                                                                   \
            FOUR_AT(pointer) = (value);                                                            \
        }                                                                                          \
    } while (0)

#define FOUR_LOW(a, b) __builtin_shufflevector(a, b, 0, 1, 4, 5)
#define FOUR_HIGH(a, b) __builtin_shufflevector(a, b, 2, 3, 6, 7)

/* Four points of three numbers: x0y0z0x1 y1z1x2y2 z2x3y3z3. */
INLINE void interleave_points(const double *planes, int streaming, double *out)
{
    const four x = FOUR_OF(planes), y = FOUR_OF(planes + GROUP), z = FOUR_OF(planes + 2 * GROUP);
    const four xy = __builtin_shufflevector(x, y, 0, 4, 1, 5); /* x0 y0 x1 y1 */
    const four yz = __builtin_shufflevector(y, z, 1, 5, 2, 6); /* y1 z1 y2 z2 */
    const four zx = __builtin_shufflevector(x, y, 3, 7, 3, 7); /* x3 y3 .. .. */
    const four a = __builtin_shufflevector(xy, z, 0, 1, 4, 2); /* x0 y0 z0 x1 */
    const four b = __builtin_shufflevector(yz, x, 0, 1, 6, 2); /* y1 z1 x2 y2 */
    const four c = __builtin_shufflevector(z, zx, 2, 4, 5, 3); /* z2 x3 y3 z3 */
    PUT(out, a);
    PUT(out + 4, b);
    PUT(out + 8, c);
}

/* Four points of 18 numbers. Number pairs m = (2m, 2m+1) of even points (lo) and odd ones (hi)
 * are unpacked within halves; a point of 18 numbers is nine pairs, so two points are nine whole
 * vectors: pairs 01 23 45 67 of the even one, 8 with the odd one's 0, then 12 34 56 78. They are
 * written in order: a streamed line that waits half full is slow. */
INLINE void interleave_second(const double *planes, int streaming, double *out)
{
    four lo[9], hi[9];
    for (int m = 0; m < 9; m++) {
        const four a = FOUR_OF(planes + 2 * m * GROUP), b = FOUR_OF(planes + (2 * m + 1) * GROUP);
        lo[m] = __builtin_shufflevector(a, b, 0, 4, 2, 6);
        hi[m] = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    }
    for (int m = 0; m < 4; m++) {
        PUT(out + 4 * m, FOUR_LOW(lo[2 * m], lo[2 * m + 1]));
    }
    PUT(out + 16, FOUR_LOW(lo[8], hi[0]));
    for (int m = 0; m < 4; m++) {
        PUT(out + 20 + 4 * m, FOUR_LOW(hi[2 * m + 1], hi[2 * m + 2]));
    }
    for (int m = 0; m < 4; m++) {
        PUT(out + 36 + 4 * m, FOUR_HIGH(lo[2 * m], lo[2 * m + 1]));
    }
    PUT(out + 52, FOUR_HIGH(lo[8], hi[0]));
    for (int m = 0; m < 4; m++) {
        PUT(out + 56 + 4 * m, FOUR_HIGH(hi[2 * m + 1], hi[2 * m + 2]));
    }
}

#undef FOUR_LOW
#undef FOUR_HIGH
#undef PUT

/* values[j][c] = plane[c][j], number by number. */
static void interleave_plain(int numbers, const double *planes, double *out)
{
    for (int j = 0; j < GROUP; j++) {
        for (int c = 0; c < numbers; c++) {
            out[numbers * j + c] = planes[c * GROUP + j];
        }
    }
}

/* Has the polygon read again where it is used, instead of copied to the stack before the loop. */
#define KEEP_IN_MEMORY(pointer) __asm__ volatile("" : "+r"(pointer))

/* One group into the caller's layout. */
INLINE void group_fill(int order, int dim, int local, const double *basis, const double *polygons,
                       size_t polygon_stride, int streaming, double *out)
{
    double planes[18 * GROUP];
    if (order == 0) {
        group_positions(dim, local, basis, polygons, planes);
        for (int j = 0; j < GROUP; j += 4) {
            interleave_points(planes + j, streaming, out + 3 * j);
        }
        return;
    }
    for (int j = 0; j < GROUP; j += GRID_LANES) {
        KEEP_IN_MEMORY(polygons);
        group_derivatives(order, dim, local, basis + j, polygons, polygon_stride, planes + j);
    }
    if (order == 1) {
        interleave_plain(9, planes, out);
        return;
    }
    for (int j = 0; j < GROUP; j += 4) {
        interleave_second(planes + j, streaming, out + 18 * j);
    }
}

/* What has kernels of its own for four functions, the cubic's, and for five, where a group has a knot: all; where code is to be
 * small, first derivatives of surfaces without weights, which is what is drawn. */
#ifdef TAUT_SMALL_KERNEL
#define GRID_OWN(order, dim) ((order) == 1 && (dim) == 3)
#else
#define GRID_OWN(order, dim) 1
#endif

/* Groups of the same kind. */
INLINE void fill_kind(int order, int dim, int streaming, const taut_grid_group *groups, int count,
                      const double *polygons, size_t polygon_stride, double *out)
{
    for (int i = 0; i < count; i++) {
        const taut_grid_group g = groups[i];
        const double *q = polygons + (ptrdiff_t)g.first * dim;
        double *to = out + (ptrdiff_t)i * GROUP * TAUT_SURFACE_VECTORS(order) * 3;
        if (GRID_OWN(order, dim) && g.local == 4) {
            group_fill(order, dim, 4, g.basis, q, polygon_stride, streaming, to);
        } else if (GRID_OWN(order, dim) && g.local == 5) {
            group_fill(order, dim, 5, g.basis, q, polygon_stride, streaming, to);
        } else {
            group_fill(order, dim, g.local, g.basis, q, polygon_stride, streaming, to);
        }
    }
}

INLINE void fill_order(int order, int dim, int streaming, const taut_grid_group *groups, int count,
                       const double *polygons, size_t polygon_stride, double *out)
{
    if (dim == 4 && GRID_STREAMS && streaming) {
        fill_kind(order, 4, 1, groups, count, polygons, polygon_stride, out);
    } else if (dim == 4) {
        fill_kind(order, 4, 0, groups, count, polygons, polygon_stride, out);
    } else if (GRID_STREAMS && streaming) {
        fill_kind(order, 3, 1, groups, count, polygons, polygon_stride, out);
    } else {
        fill_kind(order, 3, 0, groups, count, polygons, polygon_stride, out);
    }
}

static void grid_fill(int order, int dim, int streaming, const taut_grid_group *groups, int count,
                      const double *polygons, size_t polygon_stride, double *out)
{
    if (order == 0) {
        fill_order(0, dim, streaming, groups, count, polygons, polygon_stride, out);
    } else if (order == 1) {
        fill_order(1, dim, 0, groups, count, polygons, polygon_stride, out);
    } else {
        fill_order(2, dim, streaming, groups, count, polygons, polygon_stride, out);
    }
}

/* A line of a cache that is both streamed and stored is slow: so whole lines alone are streamed, or, where what
 * is beside them was streamed too, whole vectors. */
static void grid_copy(size_t count, const double *from, double *to)
{
    const size_t unit = (uintptr_t)to % 32 == 0 ? 4 : 8;
    size_t i = 0;
    for (; i < count && (uintptr_t)(to + i) % (8 * unit) != 0; i++) {
        to[i] = from[i];
    }
    for (; i + unit <= count; i += unit) {
        for (size_t k = 0; k < unit; k += 4) {
            GRID_STREAM(to + i + k, FOUR_OF(from + i + k));
        }
    }
    for (; i < count; i++) {
        to[i] = from[i];
    }
}

static void grid_fence(void)
{
    GRID_FENCE();
}

#define GRID_OPS(set)                                                                              \
    {                                                                                              \
        .name = set, .group = GROUP, .contract = grid_contract, .fill = grid_fill,                 \
        .copy = grid_copy, .fence = grid_fence,                                                    \
    }
