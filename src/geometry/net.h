/* net.h -- checks and small arithmetic on arrays of control points. */
#ifndef TAUT_GEOMETRY_NET_H
#define TAUT_GEOMETRY_NET_H

#include "taut/basis.h"

#include <stddef.h>

/* What every curve and surface is asked: a name (or NULL) of at most TAUT_NAME_MAX bytes, at most
 * TAUT_POINTS_MAX points, all finite; weights, if not NULL, finite and positive, and none where
 * `plain` is a basis that carries none. columns is 0 for a curve. TAUT_BAD_INPUT with error->where
 * "/points/i" or, with columns > 0, "/points/i/j", and so on. */
taut_status taut_net_check(const char *name, size_t count, int columns, const double *points,
                           const double *weights, const taut_basis *plain, taut_error *error);
/* Are the texts, those that are not NULL, rational numbers "p" or "p/q": an optional minus, digits,
 * and digits that are not all 0? error->where: "/points/i/j/c". */
taut_status taut_net_check_exact(size_t count, int columns, const char *const *exact,
                                 taut_error *error);

/* net[k] = (w x, w y, w z, w) of each point: double[count][4]. */
void taut_net_homogeneous(size_t count, const double *points, const double *weights, double *net);

/* The quotient rule on surfaces: in h[k][4], the six derivatives of (wx, wy, wz, w) in the order of
 * TAUT_X.., as many as `order` gives; out values[k][3]. h and values may not overlap. */
void taut_net_project(int order, const double *h, double *values);

/* The same along a curve, for order 0..TAUT_ORDER_MAX: h[k] is derivative k of (wx, wy, wz, w). */
void taut_net_project_curve(int order, double h[TAUT_ORDER_MAX + 1][4], double *values);

#endif /* TAUT_GEOMETRY_NET_H */
