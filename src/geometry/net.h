/* net.h -- checks and small arithmetic on arrays of control points. */
#ifndef TAUT_GEOMETRY_NET_H
#define TAUT_GEOMETRY_NET_H

#include "taut/status.h"

#include <stddef.h>

/* Are the 3 * count numbers finite? error->where: "/points/i" or, with columns > 0,
 * "/points/i/j". */
taut_status taut_net_check_points(size_t count, int columns, const double *points,
                                  taut_error *error);
/* Are the weights finite and positive? */
taut_status taut_net_check_weights(size_t count, int columns, const double *weights,
                                   taut_error *error);
/* Are the texts, those that are not NULL, rational numbers "p" or "p/q": an optional minus, digits,
 * and digits that are not all 0? error->where: "/points/i/j/c". */
taut_status taut_net_check_exact(size_t count, int columns, const char *const *exact,
                                 taut_error *error);

/* net[k] = (w x, w y, w z, w) of each point: double[count][4]. */
void taut_net_homogeneous(size_t count, const double *points, const double *weights, double *net);

/* The quotient rule on surfaces: in h[k][4], the six derivatives of (wx, wy, wz, w) in the order of
 * TAUT_X.., as many as `order` gives; out values[k][3]. h and values may not overlap. */
void taut_net_project(int order, const double *h, double *values);

#endif /* TAUT_GEOMETRY_NET_H */
