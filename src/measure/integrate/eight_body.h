/* eight_body.h -- the loops behind eight.h, compiled once per instruction set.
 *
 * The including file defines EIGHT_LANES (doubles in a vector, 2, 4 or 8) and EIGHT_SQRT(vector).
 * Vectors are gcc's and clang's vector extension.
 */
#include "measure/integrate/eight.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

typedef double lanes __attribute__((vector_size(8 * EIGHT_LANES), aligned(8), may_alias));
typedef int64_t bits __attribute__((vector_size(8 * EIGHT_LANES), aligned(8), may_alias));

#define AT(pointer) (*(lanes *)(void *)(pointer))
#define OF(pointer) (*(const lanes *)(const void *)(pointer))
#define INLINE static inline __attribute__((always_inline))

INLINE lanes chosen(bits where, lanes a, lanes b)
{
    return (lanes)((where & (bits)a) | (~where & (bits)b));
}

static void eight_centre(int points, double factor, double *net, double *sizes)
{
    for (int q = 0; q < 3 * TAUT_EIGHT; q += EIGHT_LANES) {
        const lanes origin = OF(net + q);
        lanes size = {0};
        for (int k = 0; k < points; k++) {
            double *x = net + (size_t)k * 3 * TAUT_EIGHT + q;
            const lanes moved = (OF(x) - origin) * factor;
            const lanes positive = chosen((bits)(moved < 0), -moved, moved);
            size = chosen((bits)(positive > size), positive, size);
            AT(x) = moved;
        }
        AT(sizes + q) = size;
    }
}

/* polygons[k][b][c] = sum_a N_a^(k) net[a][b][c]. */
INLINE void contract_u(const int local[2], const double *net, const double *n, double *polygons)
{
    const size_t length = (size_t)local[1] * 3 * TAUT_EIGHT;
    const double *d = n + local[0];
    for (size_t q = 0; q < length; q += EIGHT_LANES) {
        lanes still = OF(net + q) * n[0], along = OF(net + q) * d[0];
        for (int a = 1; a < local[0]; a++) {
            const lanes x = OF(net + (size_t)a * length + q);
            still += x * n[a];
            along += x * d[a];
        }
        AT(polygons + q) = still;
        AT(polygons + length + q) = along;
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

INLINE void add_point(lanes n, const double *x, vector *sum)
{
    sum->x += n * OF(x);
    sum->y += n * OF(x + TAUT_EIGHT);
    sum->z += n * OF(x + 2 * TAUT_EIGHT);
}

/* The nodes of one line u = const of EIGHT_LANES of the cells, from lane q on. */
INLINE void add_line(int local, double ratio, double weight, const taut_nodes *v, size_t q,
                     const double *polygons, taut_eight_sums *sums)
{
    const size_t row = (size_t)local * TAUT_EIGHT;
    const double *n = v->values + q, *still = polygons + q, *along = still + 3 * row;
    lanes w = {0}, apart = {0}, e = {0}, g = {0};
    lanes least = OF(sums->least + q), most = OF(sums->most + q);

    for (int j = 0; j < v->count; j++, n += 2 * row) {
        const lanes part = OF(v->weights + (size_t)j * TAUT_EIGHT + q);
        vector xu = {{0}, {0}, {0}}, xv = xu;
        for (size_t b = 0; b < (size_t)local; b++) {
            add_point(OF(n + b * TAUT_EIGHT), along + 3 * b * TAUT_EIGHT, &xu);
            add_point(OF(n + row + b * TAUT_EIGHT), still + 3 * b * TAUT_EIGHT, &xv);
        }
        const vector normal = cross(xu, xv);
        const lanes square = dot(normal, normal), f = dot(xu, xv);
        const lanes uu = dot(xu, xu), vv = dot(xv, xv), difference = uu * ratio - vv / ratio;
        least = chosen((bits)(square > least), least, square); /* takes what is no number */
        most = chosen((bits)(square > most), square, most);
        w += part * EIGHT_SQRT(square);
        apart += part * (difference * difference + f * 4 * f);
        e += part * uu;
        g += part * vv;
    }
    AT(sums->of[0] + q) += w * weight;
    AT(sums->of[1] + q) += apart * weight;
    AT(sums->of[2] + q) += e * weight;
    AT(sums->of[3] + q) += g * weight;
    AT(sums->least + q) = least;
    AT(sums->most + q) = most;
}

static void eight_sum(const int local[2], const double *net, double ratio, const taut_nodes *u,
                      const taut_nodes *v, double *polygons, taut_eight_sums *sums)
{
    memset(sums, 0, sizeof *sums);
    for (int l = 0; l < TAUT_EIGHT; l++) {
        sums->least[l] = INFINITY;
    }
    for (int i = 0; i < u->count; i++) {
        contract_u(local, net, u->values + 2 * (size_t)i * (size_t)local[0], polygons);
        for (size_t q = 0; q < TAUT_EIGHT; q += EIGHT_LANES) {
            if (local[1] == 4) { /* cubics, unrolled */
                add_line(4, ratio, u->weights[i], v, q, polygons, sums);
            } else {
                add_line(local[1], ratio, u->weights[i], v, q, polygons, sums);
            }
        }
    }
}

#define EIGHT_OPS(title)                                                                           \
    {                                                                                              \
        .name = (title), .centre = eight_centre, .sum = eight_sum                                  \
    }
