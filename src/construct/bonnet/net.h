/* net.h -- the control nets of the family out of the coefficients of each direction: those of 1, t
 * and the trigonometric or hyperbolic pair on a window, in the quasi-Bezier or quasi-B-spline basis
 * ([XuWang2006] sections 3, 4, 9). */
#ifndef TAUT_BONNET_NET_H
#define TAUT_BONNET_NET_H

#include "taut/bonnet.h"

/* ---- coefficients.c ---- */

/* One direction. Each pointer is double[count], the caller's. */
typedef struct taut_bonnet_rows {
    int count;
    double *t; /* of the parameter itself */
    double *s; /* of sin, or sinh */
    double *c; /* of cos, or cosh */
    double *f; /* of t - sin t, or sinh t - t (bezier only; else NULL) */
    double *g; /* of 1 - cos t, or cosh t - 1 (bezier only; else NULL) */
} taut_bonnet_rows;

/* Four coefficients on [start, start + length]; circular or hyperbolic. */
void taut_bonnet_bezier_rows(int hyperbolic, double start, double length, taut_bonnet_rows *rows);
/* segments + 3 coefficients on [start, start + segments length]. */
void taut_bonnet_bspline_rows(int hyperbolic, double start, double length, int segments,
                              taut_bonnet_rows *rows);

/* ---- net.c ---- */

/* lambda of frame i: equal steps, ends included. */
double taut_bonnet_frame_lambda(const taut_bonnet_problem *problem, int i);

/* [XuWang2006] section 5, turned by theta into the associate family: double
 * points[u.count][v.count][3]. */
void taut_bonnet_net(double lambda, int sign, double theta, const taut_bonnet_rows *u,
                     const taut_bonnet_rows *v, double *points);
/* The normalised family, lambda < 1, in the form without cancellation (section 9). Needs f and g.
 */
void taut_bonnet_normalised_net(double lambda, double theta, const taut_bonnet_rows *u,
                                const taut_bonnet_rows *v, double *points);
/* Its end: Enneper's surface on [p0, p1] x [q0, q1] as a bicubic Bezier net double points[4][4][3].
 */
void taut_bonnet_enneper_net(double theta, const double p[2], const double q[2], double *points);

#endif /* TAUT_BONNET_NET_H */
