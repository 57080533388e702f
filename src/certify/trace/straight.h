/* straight.h -- nets of minimal surfaces whose curves are straight lines of the window: what can be proved.
 *
 * A surface that is minimal by the coefficients of its c- and h- (or cubic) bases has a Hopf differential
 * phi = L - i M that is constant over the window ([XuWang2006] section 10): its asymptotic curves and lines
 * of curvature are straight lines there, at angles that phi says.
 */
#ifndef TAUT_CERTIFY_TRACE_STRAIGHT_H
#define TAUT_CERTIFY_TRACE_STRAIGHT_H

#include "certify/trace/lines.h"
#include "taut/recognise.h"

typedef struct taut_net_straight {
    int is_known;   /* the rest is of use */
    double hopf[2]; /* L, M */
    taut_family_member member;
} taut_net_straight;

/* Of a surface about 1 in size: is it one of those? */
void taut_net_straight_look(const taut_surface *surface, taut_net_straight *straight);

/* The direction of a family's lines in the window; asymptotic and principal nets. */
void taut_net_straight_way(const taut_net_straight *straight, taut_trace_net net, int family,
                           double way[2]);

/* A number that |k_n|/R of the window's curve (principal: |tau_g|/R) exceeds nowhere: twice the sine of the
 * largest angle that its tangents can have with the line, by its control points. INFINITY where they say nothing. */
double taut_net_straight_residual(const taut_net_line *line, const double way[2]);

/* A number that the distance of the curve in space from the surface at the window's place exceeds nowhere, on
 * surface and curve times 2^-unit. INFINITY where the two have other knots. */
double taut_net_straight_distance(const taut_surface *surface, const taut_net_straight *straight,
                                  const taut_net_line *line, int unit, const double way[2]);

#endif /* TAUT_CERTIFY_TRACE_STRAIGHT_H */
