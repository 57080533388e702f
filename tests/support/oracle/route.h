/* route.h -- the axis of a round pipe as the judges walk it: places, nearest points, and what is one
 * radius around it. For judges of pipes alone.
 */
#ifndef TAUT_TEST_ORACLE_ROUTE_H
#define TAUT_TEST_ORACLE_ROUTE_H

#include "oracle/oracle.h"

/* The axis, carried on straight before its start and after its end by `reach`. */
enum { ROUTE_PLACES = 64 };

typedef struct oracle_route {
    oracle_line line;
    oracle_real lo, hi, reach[2], length; /* s: lo - reach0 .. lo, lo .. hi, hi .. hi + reach1 */
    oracle_real end[2][3], way[2][3];
    double place[ROUTE_PLACES + 1][3];
} oracle_route;

/* A place on a route: where, which way, at which parameter. */
typedef struct oracle_place {
    double x[3], way[3], s;
} oracle_place;

/* Borrows the curve; 0 where there is none. Free by oracle_line_free(&route->line). */
int oracle_route_of(const taut_curve *axis, oracle_route *route);
void oracle_route_at(const oracle_route *route, oracle_real s, oracle_real x[3], oracle_real way[3],
                     oracle_real *speed);
/* The largest distance of a surface from the tube around the route, over the radius; infinity where it
 * does not close around it or leaves a part of it bare. */
oracle_real oracle_tube_along(const oracle_sheet *sheet, const oracle_route *route, double radius);
/* From a pair of places to the pair of nearest points; half their distance if both see the other at
 * right angles and the pair did not run together, else infinity. */
oracle_real oracle_settle(const oracle_route *one, oracle_real s, const oracle_route *other,
                          oracle_real t, double radius);
/* The least radius of curvature seen. */
oracle_real oracle_sharpest(const oracle_route *route);

#endif /* TAUT_TEST_ORACLE_ROUTE_H */
