/* net.h -- the control nets of the family out of the coefficients of each direction. */
#ifndef TAUT_BONNET_NET_H
#define TAUT_BONNET_NET_H

#include "construct/bonnet/coefficients.h"
#include "taut/bonnet.h"

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
