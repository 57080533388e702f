#include "construct/harmonic/frame.h"

#include <math.h>

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
            frame.centre[c] = 0.5 * low + 0.5 * high;
            frame.size = fmax(frame.size, 0.5 * high - 0.5 * low);
        }
    }
    if (!(frame.size > 0)) {
        frame.size = 1;
    }
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
