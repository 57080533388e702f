/* unavoidable.h -- the strain that no flat piece avoids, of the Gauss curvature alone. */
#ifndef TAUT_CERTIFY_PATTERN_UNAVOIDABLE_H
#define TAUT_CERTIFY_PATTERN_UNAVOIDABLE_H

#include "certify/pattern/cloth.h"

/* What is known of the axis at s = i/TAUT_CLOTH_STATIONS. */
typedef struct taut_cloth_station {
    double from_start; /* length of the axis up to it */
    double across;     /* of the cross line */
    double distance;   /* to the border */
    double low, high;  /* of K on the cross line */
    double bend;       /* |k_g| of the axis */
} taut_cloth_station;
enum { TAUT_CLOTH_STATIONS = 16 };

typedef struct taut_cloth_limit {
    double
        unavoidable; /* of any one-to-one flattening the largest |strain| is no less; 0 where none is known */
    double
        expected; /* the least that seams of any length allow in a long strip: max |K| (width/4)^2 */
    double at, length,
        radius; /* where the first was found: s on the axis, and l, r times 2^-unit */
    taut_cloth_station stations[TAUT_CLOTH_STATIONS + 1];
    double dome[2], saddle, wide; /* the best of them, in s; NaN: none */
} taut_cloth_limit;

/* At stations of the axis, and then between them about the best ones. pulse: NULL is fine; once it says stop the limit has no meaning. */
void taut_cloth_limit_of(const taut_cloth *cloth, const taut_cloth_piece *piece, taut_pulse *pulse,
                         taut_cloth_limit *limit);
/* The part of `unavoidable` that is proved (geometry/chart/least_strain.h); 0 where nothing is. */
double taut_cloth_limit_proved(const taut_cloth *cloth, const taut_cloth_piece *piece,
                               taut_pulse *pulse);
enum { TAUT_CLOTH_UNAVOIDABLE = 1, TAUT_CLOTH_EXPECTED = 2 /* what is refined */ };
void taut_cloth_limit_refine(const taut_cloth *cloth, const taut_cloth_piece *piece, int what,
                             taut_pulse *pulse, taut_cloth_limit *limit);

#endif /* TAUT_CERTIFY_PATTERN_UNAVOIDABLE_H */
