/* side.h -- the forms of a surface by the polynomial of a span of choice: on the one side of a break and on the other
 * curvatures may differ.
 */
#ifndef TAUT_CERTIFY_TRACE_SIDE_H
#define TAUT_CERTIFY_TRACE_SIDE_H

#include "taut/measure.h"

/* At a place of the closed span. */
void taut_net_side_forms(const taut_surface *surface, const int span[2], const double at[2],
                         taut_forms *forms);

/* Does a place lie on a break of direction d inside the window, to rounding? Then *span is the one above it, else that of
 * the place. */
int taut_net_on_break(const taut_surface *surface, int d, const double at[2], int *span);

#endif /* TAUT_CERTIFY_TRACE_SIDE_H */
