/* enclose.h -- where a curve or a surface and its derivatives are over a part of their parameters.
 *
 * Each function of a basis, and each of its derivatives up to the second, as a polynomial over the part, by its Bernstein coefficients
 * and how far it may be off: of polynomials themselves, of c- and h- functions those through six places. What they are combined to
 * lies in the hull of its coefficients [Farin2002, chapter 5]. Of bases of degree above TAUT_ENCLOSE_DEGREE nothing is known.
 */
#ifndef TAUT_GEOMETRY_CHART_ENCLOSE_H
#define TAUT_GEOMETRY_CHART_ENCLOSE_H

#include "geometry/chart/range.h"
#include "taut/curve.h"
#include "taut/surface.h"

enum { TAUT_ENCLOSE_DEGREE = 8 };

/* x, x', x'' over [a, b]; 0 where it is not known. Of curves without weights. */
int taut_enclose_curve(const taut_curve *curve, double a, double b, taut_range x[3][3]);
/* X, X_u, X_v, X_uu, X_uv, X_vv over [a[0], b[0]] x [a[1], b[1]], along the rows of a frame: along normal and tangents ranges are of
 * second order where they are of first order along other axes. NULL: along x, y and z. */
int taut_enclose_surface(const taut_surface *surface, const double a[2], const double b[2],
                         const double frame[3][3], taut_range x[6][3]);
/* Of x, x_u, x_v the rows along x_u, across it in the tangent plane, and along the normal, in which derivatives change least;
 * 0: there is no normal. */
int taut_enclose_frame(const double x[3][3], double frame[3][3]);

#endif /* TAUT_GEOMETRY_CHART_ENCLOSE_H */
