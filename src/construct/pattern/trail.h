/* trail.h -- a curve of the model that lies on the surface, as one in its window.
 *
 * Curves that details.domain tells (those of `taut trace`) are taken in the window; of others each place is moved onto the surface
 * squarely, its derivatives with it: X_u u' + X_v v' = c'.
 */
#ifndef TAUT_CONSTRUCT_PATTERN_TRAIL_H
#define TAUT_CONSTRUCT_PATTERN_TRAIL_H

#include "construct/pattern/layout.h"

enum { TAUT_TRAIL_STATIONS = 64 };

typedef struct taut_pattern_trail {
    const char *name;
    const taut_curve *curve;
    int is_window; /* points (u, v, 0), and not in space */
    int is_back;   /* run against the curve */
    int held;      /* of the window's: the coordinate that is the same all along, or -1 */
    double lo, hi;
    double ends[2][2];                         /* places of lo and hi */
    double places[TAUT_TRAIL_STATIONS + 1][2]; /* at equal steps from lo to hi */
} taut_pattern_trail;

/* TAUT_BAD_INPUT, reason curve: there is none of that name, or it leaves the surface. */
taut_status taut_pattern_trail_find(const taut_pattern_ground *ground, const char *name,
                                    const char *where, taut_pattern_trail *trail,
                                    taut_error *error);
/* As a side whose ends are set. TAUT_BAD_INPUT, reason curve. */
taut_status taut_pattern_trail_side(const taut_pattern_ground *ground,
                                    const taut_pattern_trail *trail, const char *where,
                                    taut_pattern_side *side, taut_error *error);

/* The parameter line `held` (0: u, 1: v) = value between two parameters (NULL: all of it), backwards or not, where it may run into a place
 * without a normal: a side, its ends too. */
taut_status taut_pattern_trail_line(const taut_pattern_ground *ground, int held, double value,
                                    const double range[2], int backwards, taut_pattern_side *side,
                                    taut_error *error);

#endif /* TAUT_CONSTRUCT_PATTERN_TRAIL_H */
