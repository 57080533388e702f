/* compose.h -- how far a curve is from the surface over its place in the window: proved, by Bernstein coefficients.
 *
 * On a span the window's curve c is a quintic and S a polynomial of degree p x q (or N/w) of one cell, so that
 * C - S(c) is a polynomial of degree 5 (p + q) (C w(c) - N(c) one of 5 more): it is nowhere longer than the longest
 * of its coefficients, over the least of w's.
 */
#ifndef TAUT_CERTIFY_TRACE_COMPOSE_H
#define TAUT_CERTIFY_TRACE_COMPOSE_H

#include "certify/trace/lines.h"

enum { TAUT_NET_COMPOSE_DEGREE = 120 }; /* 5 (p + q) at most */

typedef struct taut_net_cells taut_net_cells;

/* The cells of surfaces about 1 in size, their points moved by -origin. The arena's. TAUT_NO_MEMORY. */
taut_status taut_net_cells_new(taut_arena *arena, int count, const taut_surface *const *surfaces,
                               taut_net_cells **cells);

/* A number that the distance of the curve in space, times 2^-unit, from its surface at the window's place exceeds
 * nowhere, rounding counted. INFINITY where nothing is proved: other knots than the window's, no polynomials, a
 * degree above that, or a cell that a span leaves. */
double taut_net_compose_distance(taut_net_cells *cells, const taut_net_line *line, int unit);

#endif /* TAUT_CERTIFY_TRACE_COMPOSE_H */
