#include "construct/harmonic/frame.h"

#include <float.h>
#include <math.h>

double taut_frame_size(double size)
{
    int exponent = 0;
    if (!(size > 0)) {
        return 1;
    }
    (void)frexp(size, &exponent);
    return ldexp(1, exponent < DBL_MAX_EXP ? exponent : DBL_MAX_EXP - 1);
}

/* A middle at least three times as far as the ends are from it: all points lie between half of it
 * and twice of it, where subtraction is exact. A nearer one is left at 0. */
taut_frame taut_frame_of(size_t count, const double *points, const unsigned char *known)
{
    taut_frame frame = {{0, 0, 0}, 0};
    for (int c = 0; c < 3; c++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < count; i++) {
            if (known == NULL || known[i]) {
                low = fmin(low, points[3 * i + (size_t)c]);
                high = fmax(high, points[3 * i + (size_t)c]);
            }
        }
        if (low <= high) {
            const double middle = 0.5 * low + 0.5 * high;
            frame.centre[c] = fabs(middle) > 3 * (0.5 * high - 0.5 * low) ? middle : 0;
            frame.size = fmax(frame.size, fmax(high - frame.centre[c], frame.centre[c] - low));
        }
    }
    frame.size = taut_frame_size(frame.size);
    return frame;
}

double taut_frame_reach(const taut_frame *frame)
{
    const double *c = frame->centre;
    return 1 + fmax(fabs(c[0]), fmax(fabs(c[1]), fabs(c[2]))) / frame->size;
}

void taut_frame_enter(const taut_frame *frame, size_t count, double *points)
{
    for (size_t i = 0; i < 3 * count; i++) {
        points[i] = (points[i] - frame->centre[i % 3]) / frame->size;
    }
}

void taut_frame_leave(const taut_frame *frame, size_t count, double *points)
{
    for (size_t i = 0; i < 3 * count; i++) {
        points[i] = frame->centre[i % 3] + frame->size * points[i];
    }
}
