/* cone.h -- two rims that no connected film spans: curves in the two nappes of a cone of half angle 56.47 degrees
 * ([DierkesHildebrandtKuesterWohlrab1992] 6.2). */
#ifndef TAUT_CONSTRUCT_FILM_CONE_H
#define TAUT_CONSTRUCT_FILM_CONE_H

#include "taut/curve.h"

typedef struct taut_film_rims {
    int count[2];
    double *points[2]; /* [count][3]: whose hull holds the rim */
    double span[2];    /* by taut_film_cone_gap: the largest rho / sinh t0 of each */
    double height;     /* the least distance between them along the axis */
} taut_film_rims;

/* How much room for the apex there is on the axis, a point and a direction from the first rim to the second: above 0, and there is
 * no film. */
double taut_film_cone_gap(taut_film_rims *rims, const double axis[6]);
/* The same of the axis with the most room that is found near this one, which it becomes; -1 without a direction. */
double taut_film_cone_widest(taut_film_rims *rims, double axis[6]);
/* That there is no film between such rims, at `where`: collapses. digits: of how wide rims are joined up to. TAUT_NO_SOLUTION. */
taut_status taut_film_cone_refuse(const taut_film_rims *rims, int digits, const char *where,
                                  taut_error *error);
/* 1/2 int |(x - tip) x x_t| dt: the area of the cone over a curve. */
double taut_film_cone_area(const taut_curve *curve, const double tip[3]);

#endif /* TAUT_CONSTRUCT_FILM_CONE_H */
