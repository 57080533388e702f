/* family.h -- which way a family of a net goes through a place of the window, by the surface's forms there. */
#ifndef TAUT_CERTIFY_TRACE_FAMILY_H
#define TAUT_CERTIFY_TRACE_FAMILY_H

#include "taut/measure.h"
#include "taut/trace.h"

/* Is a direction of an asymptotic or principal net nearer to this family's than to the other's? *off: what the net says of it, 0
 * on its curves. */
int taut_net_is_of_family(taut_trace_net net, int family, const taut_forms *f, const double way[2],
                          double *off);

/* The family's direction, A a^2 + 2 B a b + C b^2 = 0 of its quadratic form, or along the parameter; 0 where the net does not
 * exist. */
int taut_net_family_way(taut_trace_net net, int family, const taut_forms *f, double way[2]);

#endif /* TAUT_CERTIFY_TRACE_FAMILY_H */
