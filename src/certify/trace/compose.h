/* compose.h -- how far a curve is from the surface over its place in the window: proved, by Bernstein coefficients.
 *
 * On a span the window's curve c is a quintic and S a polynomial of degree p x q (or N/w) of one cell, so that
 * C - S(c) is a polynomial of degree 5 (p + q) (C w(c) - N(c) one of 5 more): it is nowhere longer than the longest
 * of its coefficients, over the least of w's.
 */
#ifndef TAUT_CERTIFY_TRACE_COMPOSE_H
#define TAUT_CERTIFY_TRACE_COMPOSE_H

#include "certify/trace/cells.h"
#include "certify/trace/spans.h"

/* Room to work in, of one thread. */
typedef struct taut_net_composer taut_net_composer;

/* In the arena. TAUT_NO_MEMORY. */
taut_status taut_net_composer_new(taut_arena *arena, taut_net_cells *cells,
                                  taut_net_composer **composer);

/* A number that the distance of the span in space from its surface at the window's place exceeds nowhere, rounding
 * counted. INFINITY where nothing is proved: no polynomials, a degree above that, or a cell that the span leaves. */
double taut_net_compose_distance(taut_net_composer *composer, const taut_net_span *span);

#endif /* TAUT_CERTIFY_TRACE_COMPOSE_H */
