/* line.h -- plane lines of degree 5 that others are made of: quintics between stations, straight ones, several end to end. */
#ifndef TAUT_CONSTRUCT_PATTERN_LINE_H
#define TAUT_CONSTRUCT_PATTERN_LINE_H

#include "core/arena.h"
#include "taut/curve.h"

/* A parameter of a curve, its place there, and its first two derivatives. */
typedef struct taut_pattern_station {
    double x, y[3][2];
} taut_pattern_station;

/* The quintics between stations from 0 to 1, as one spline of triple knots: [3 spans + 3] points. TAUT_NO_MEMORY. */
taut_status taut_pattern_quintics(int spans, const taut_pattern_station *at, taut_arena *arena,
                                  const taut_curve **curve);
/* Over [0, 1]. TAUT_NO_MEMORY. */
taut_status taut_pattern_straight(const double from[2], const double to[2], taut_arena *arena,
                                  const taut_curve **curve);

/* A curve over [0, 1], run through backwards or not between two parameters of the whole. */
typedef struct taut_pattern_part {
    const taut_curve *curve;
    int is_back;
    double begin, end;
} taut_pattern_part;

/* Curves end to end as a closed one, fivefold knots where they meet; their last and first points there are one, that of the curve before.
 * TAUT_NO_MEMORY. */
taut_status taut_pattern_join(int count, const taut_pattern_part *parts, taut_arena *arena,
                              const taut_curve **whole);

#endif /* TAUT_CONSTRUCT_PATTERN_LINE_H */
