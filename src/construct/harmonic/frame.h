/* frame.h -- data brought to unit size, and near to the origin where it is far, without rounding:
 * what a completion amplifies are the numbers as they were given. */
#ifndef TAUT_HARMONIC_FRAME_H
#define TAUT_HARMONIC_FRAME_H

#include <stddef.h>

typedef struct taut_frame {
    double centre[3];
    double size; /* a power of two: the largest distance of a coordinate from the centre is below it
                  * and at least half of it; 1 where all points coincide */
} taut_frame;

/* The power of two for a largest distance. */
double taut_frame_size(double largest);

/* The frame of points[count][3], of which only those with known[i] != 0 count (NULL: all). */
taut_frame taut_frame_of(size_t count, const double *points, const unsigned char *known);
/* The largest coordinate over the size, at least 1: how much coarser the rounding of the points is,
 * for points far from the origin. */
double taut_frame_reach(const taut_frame *frame);

/* Into the frame and out of it, in place. */
void taut_frame_enter(const taut_frame *frame, size_t count, double *points);
void taut_frame_leave(const taut_frame *frame, size_t count, double *points);

#endif /* TAUT_HARMONIC_FRAME_H */
