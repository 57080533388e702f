/* grid_kernel_body.h -- the loops behind grid_kernel.h, compiled once per instruction set.
 *
 * The including file defines GRID_LANES (doubles in a vector), GRID_STREAM(pointer, four) for a
 * store past the caches, GRID_FENCE(), and may let a*b+c contract to one fused operation: sums of
 * four to a few dozen terms, so results of different sets agree to rounding. Vectors are gcc's and
 * clang's vector extension, which both lower to whatever the target has.
 */
#include "geometry/grid_kernel.h"
#include "geometry/net.h"
#include "taut/surface.h"

#include <stdint.h>
#include <string.h>

typedef double lanes __attribute__((vector_size(8 * GRID_LANES), aligned(8), may_alias));
typedef double four __attribute__((vector_size(32), aligned(8), may_alias));

#define LANES_AT(pointer) (*(lanes *)(void *)(pointer))
#define LANES_OF(pointer) (*(const lanes *)(const void *)(pointer))
#define FOUR_AT(pointer) (*(four *)(void *)(pointer))
#define FOUR_OF(pointer) (*(const four *)(const void *)(pointer))

/* Two vectors of points at a time, so that each polygon number is fetched once for both. */
static void grid_accumulate4(const taut_grid_run *run, int local, const double *basis,
                             size_t basis_stride, const double *polygon, double *out)
{
    const double *q = polygon + (ptrdiff_t)run->first * 4;
    for (int j = run->from; j < run->to; j += 2 * GRID_LANES) {
        lanes x0 = {0}, x1 = {0}, y0 = {0}, y1 = {0}, z0 = {0}, z1 = {0}, w0 = {0}, w1 = {0};
        for (int b = 0; b < local; b++) {
            const double *n = basis + (size_t)b * basis_stride + j;
            const lanes n0 = LANES_OF(n), n1 = LANES_OF(n + GRID_LANES);
            const double x = q[4 * b], y = q[4 * b + 1], z = q[4 * b + 2], w = q[4 * b + 3];
            x0 += n0 * x;
            x1 += n1 * x;
            y0 += n0 * y;
            y1 += n1 * y;
            z0 += n0 * z;
            z1 += n1 * z;
            w0 += n0 * w;
            w1 += n1 * w;
        }
        double *p = out + j;
        LANES_AT(p) = x0;
        LANES_AT(p + GRID_LANES) = x1;
        LANES_AT(p + TAUT_GRID_STRIDE) = y0;
        LANES_AT(p + TAUT_GRID_STRIDE + GRID_LANES) = y1;
        LANES_AT(p + 2 * TAUT_GRID_STRIDE) = z0;
        LANES_AT(p + 2 * TAUT_GRID_STRIDE + GRID_LANES) = z1;
        LANES_AT(p + 3 * TAUT_GRID_STRIDE) = w0;
        LANES_AT(p + 3 * TAUT_GRID_STRIDE + GRID_LANES) = w1;
    }
}

static void grid_accumulate3(const taut_grid_run *run, int local, const double *basis,
                             size_t basis_stride, const double *polygon, double *out)
{
    const double *q = polygon + (ptrdiff_t)run->first * 3;
    for (int j = run->from; j < run->to; j += 2 * GRID_LANES) {
        lanes x0 = {0}, x1 = {0}, y0 = {0}, y1 = {0}, z0 = {0}, z1 = {0};
        for (int b = 0; b < local; b++) {
            const double *n = basis + (size_t)b * basis_stride + j;
            const lanes n0 = LANES_OF(n), n1 = LANES_OF(n + GRID_LANES);
            const double x = q[3 * b], y = q[3 * b + 1], z = q[3 * b + 2];
            x0 += n0 * x;
            x1 += n1 * x;
            y0 += n0 * y;
            y1 += n1 * y;
            z0 += n0 * z;
            z1 += n1 * z;
        }
        double *p = out + j;
        LANES_AT(p) = x0;
        LANES_AT(p + GRID_LANES) = x1;
        LANES_AT(p + TAUT_GRID_STRIDE) = y0;
        LANES_AT(p + TAUT_GRID_STRIDE + GRID_LANES) = y1;
        LANES_AT(p + 2 * TAUT_GRID_STRIDE) = z0;
        LANES_AT(p + 2 * TAUT_GRID_STRIDE + GRID_LANES) = z1;
    }
}

static void grid_accumulate(const taut_grid_run *run, int local, int dim, const double *basis,
                            size_t basis_stride, const double *polygon, double *out)
{
    if (dim == 4) {
        grid_accumulate4(run, local, basis, basis_stride, polygon, out);
    } else {
        grid_accumulate3(run, local, basis, basis_stride, polygon, out);
    }
}

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

#define PLANE(vector, component) (planes + ((vector)*4 + (component)) * TAUT_GRID_STRIDE + j)

/* One vector of points through the quotient rule: see taut_net_project. */
static inline void grid_project_lanes(int order, int j, double *planes)
{
    const lanes one = (lanes){0} + 1.0;
    const lanes inverse = one / LANES_OF(PLANE(TAUT_X, 3));
    lanes wu = one, wv = one, wuu = one, wuv = one, wvv = one;

    if (order > 0) {
        wu = LANES_OF(PLANE(TAUT_XU, 3)) * inverse;
        wv = LANES_OF(PLANE(TAUT_XV, 3)) * inverse;
    }
    if (order > 1) {
        wuu = LANES_OF(PLANE(TAUT_XUU, 3)) * inverse;
        wuv = LANES_OF(PLANE(TAUT_XUV, 3)) * inverse;
        wvv = LANES_OF(PLANE(TAUT_XVV, 3)) * inverse;
    }
    for (int c = 0; c < 3; c++) {
        const lanes x = LANES_OF(PLANE(TAUT_X, c)) * inverse;
        LANES_AT(PLANE(TAUT_X, c)) = x;
        if (order > 0) {
            const lanes xu = LANES_OF(PLANE(TAUT_XU, c)) * inverse - wu * x;
            const lanes xv = LANES_OF(PLANE(TAUT_XV, c)) * inverse - wv * x;
            LANES_AT(PLANE(TAUT_XU, c)) = xu;
            LANES_AT(PLANE(TAUT_XV, c)) = xv;
            if (order > 1) {
                LANES_AT(PLANE(TAUT_XUU, c)) =
                    LANES_OF(PLANE(TAUT_XUU, c)) * inverse - 2.0 * wu * xu - wuu * x;
                LANES_AT(PLANE(TAUT_XUV, c)) =
                    LANES_OF(PLANE(TAUT_XUV, c)) * inverse - wu * xv - wv * xu - wuv * x;
                LANES_AT(PLANE(TAUT_XVV, c)) =
                    LANES_OF(PLANE(TAUT_XVV, c)) * inverse - 2.0 * wv * xv - wvv * x;
            }
        }
    }
}

#undef PLANE

static void grid_project(int order, int count, double *planes)
{
    for (int j = 0; j < count; j += GRID_LANES) {
        grid_project_lanes(order, j, planes);
    }
}

/* Points from..to-1, number by number. */
static void interleave_plain(int vectors, int dim, int from, int to, const double *planes,
                             double *values)
{
    for (int j = from; j < to; j++) {
        double *out = values + (ptrdiff_t)j * vectors * 3;
        for (int k = 0; k < vectors; k++) {
            for (int c = 0; c < 3; c++) {
                out[3 * k + c] = planes[(k * dim + c) * TAUT_GRID_STRIDE + j];
            }
        }
    }
}

#define PUT(pointer, value)                                                                        \
    do {                                                                                           \
        if (streaming) {                                                                           \
            GRID_STREAM(pointer, value);                                                           \
        } else {                                                                                   \
            FOUR_AT(pointer) = value;                                                              \
        }                                                                                          \
    } while (0)

/* Four points of three numbers: x0y0z0x1 y1z1x2y2 z2x3y3z3. */
static inline void interleave_points(const double *planes, int streaming, double *out)
{
    const four x = FOUR_OF(planes);
    const four y = FOUR_OF(planes + TAUT_GRID_STRIDE);
    const four z = FOUR_OF(planes + 2 * TAUT_GRID_STRIDE);
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
 * vectors: pairs 01 23 45 67 of the even one, 8 with the odd one's 0, then 12 34 56 78. */
static inline void interleave_second(const double *const plane[18], int j, int streaming,
                                     double *out)
{
    four lo[9], hi[9];
    for (int m = 0; m < 9; m++) {
        const four a = FOUR_OF(plane[2 * m] + j), b = FOUR_OF(plane[2 * m + 1] + j);
        lo[m] = __builtin_shufflevector(a, b, 0, 4, 2, 6);
        hi[m] = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    }
    for (int m = 0; m < 4; m++) {
        const four even0 = __builtin_shufflevector(lo[2 * m], lo[2 * m + 1], 0, 1, 4, 5);
        const four even2 = __builtin_shufflevector(lo[2 * m], lo[2 * m + 1], 2, 3, 6, 7);
        PUT(out + 4 * m, even0);
        PUT(out + 36 + 4 * m, even2);
    }
    const four cross0 = __builtin_shufflevector(lo[8], hi[0], 0, 1, 4, 5);
    const four cross2 = __builtin_shufflevector(lo[8], hi[0], 2, 3, 6, 7);
    PUT(out + 16, cross0);
    PUT(out + 52, cross2);
    for (int m = 0; m < 4; m++) {
        const four odd1 = __builtin_shufflevector(hi[2 * m + 1], hi[2 * m + 2], 0, 1, 4, 5);
        const four odd3 = __builtin_shufflevector(hi[2 * m + 1], hi[2 * m + 2], 2, 3, 6, 7);
        PUT(out + 20 + 4 * m, odd1);
        PUT(out + 56 + 4 * m, odd3);
    }
}

#undef PUT

/* How many points to write singly before `values` is aligned for streaming; -1 if it never is. */
static int points_to_alignment(const double *values, int vectors)
{
    for (int j = 0; j < 4; j++) {
        if ((uintptr_t)(values + (ptrdiff_t)j * vectors * 3) % 32 == 0) {
            return j;
        }
    }
    return -1;
}

static void grid_interleave(int vectors, int dim, int count, const double *planes, int streaming,
                            double *values)
{
    const int head = points_to_alignment(values, vectors);
    const int stream = streaming && head >= 0;
    int j = stream && head < count ? head : 0;

    interleave_plain(vectors, dim, 0, j, planes, values);
    if (vectors == 1) {
        for (; j + 4 <= count; j += 4) {
            interleave_points(planes + j, stream, values + 3 * j);
        }
    } else if (vectors == 6) {
        const double *plane[18];
        for (int k = 0; k < 18; k++) {
            plane[k] = planes + (k / 3 * dim + k % 3) * TAUT_GRID_STRIDE;
        }
        for (; j + 4 <= count; j += 4) {
            interleave_second(plane, j, stream, values + (ptrdiff_t)18 * j);
        }
    }
    interleave_plain(vectors, dim, j, count, planes, values);
}

static void grid_fence(void)
{
    GRID_FENCE();
}

#define GRID_OPS(set)                                                                              \
    {                                                                                              \
        .name = set, .accumulate = grid_accumulate, .contract = grid_contract,                     \
        .project = grid_project, .interleave = grid_interleave, .fence = grid_fence,               \
    }
