/* By Sylvester's law the number of eigenvalues of (K, M) below s is the number of negative pivots
 * of K - s M ([Parlett1998] 3.3.1); the product of the pivots is its determinant. */
#include "core/elementary/elementary.h"
#include "numeric/eigen/internal.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { CHUNK = 48 }; /* rows of factors kept: they fit the first-level cache */

taut_counter taut_counter_of(const taut_pencil *pencil, taut_arena *arena)
{
    const size_t w = (size_t)pencil->k.width, lanes = TAUT_LANES;
    return (taut_counter){pencil,
                          taut_arena_take(arena, (CHUNK + w) * (w + 1), lanes * sizeof(double))};
}

/* One shift a lane. Rows of factors are made CHUNK at a time, and the last `width` carried over. */
static void count_lanes(const taut_counter *counter, const double *minus, double *negative,
                        double *log)
{
    const taut_pencil *p = counter->pencil;
    const int n = p->k.n, w = p->k.width, lanes = TAUT_LANES;
    const size_t row = ((size_t)w + 1) * (size_t)lanes, carried = (size_t)w * row;
    double mantissa[TAUT_LANES];
    int64_t exponent[TAUT_LANES] = {0};

    for (int l = 0; l < lanes; l++) {
        mantissa[l] = 1.0;
        negative[l] = 0.0;
    }
    memset(counter->factor, 0, carried * sizeof(double));
    for (int first = 0; first < n; first += CHUNK) {
        const int end = first + CHUNK < n ? first + CHUNK : n;
        if (first > 0) {
            memmove(counter->factor, counter->factor + CHUNK * row, carried * sizeof(double));
        }
        p->kernel->band_factor(first, end, w, p->k.a, p->m.a, 1.0, minus, p->tiny, counter->factor,
                               negative);
        p->kernel->lane_product(end - first, row, counter->factor + carried, mantissa, exponent);
    }
    for (int l = 0; l < lanes; l++) { /* slot 0 of a factor is 1/D */
        log[l] = -(double)exponent[l] - taut_log2(fabs(mantissa[l]));
    }
}

taut_status taut_counter_run(const taut_counter *counter, int shifts, const double *shift,
                             int *count, double *log)
{
    const int lanes = TAUT_LANES;
    for (int start = 0; start < shifts; start += lanes) {
        if (taut_pencil_beat(counter->pencil, 1)) {
            return TAUT_INTERRUPTED;
        }
        double minus[TAUT_LANES], negative[TAUT_LANES], logs[TAUT_LANES];
        for (int l = 0; l < lanes; l++) {
            minus[l] = -shift[start + l < shifts ? start + l : shifts - 1];
        }
        count_lanes(counter, minus, negative, logs);
        for (int l = 0; l < lanes && start + l < shifts; l++) {
            count[start + l] = (int)negative[l];
            log[start + l] = logs[l];
        }
    }
    return TAUT_OK;
}
