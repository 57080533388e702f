/* bends.h -- how a curve of a net bends and twists over a surface, span by span.
 *
 * On each span the unit tangent of the net's field at the window's places, at Gauss's nodes; k_g by the derivative
 * of the polynomial through these tangents: no formula of the field's own bend, nor third derivatives of the surface.
 */
#ifndef TAUT_CERTIFY_TRACE_BENDS_H
#define TAUT_CERTIFY_TRACE_BENDS_H

#include "certify/trace/cells.h"
#include "certify/trace/lines.h"

enum { TAUT_NET_NODES = 14 };

/* What is known at a node of a span. Lengths times 2^-unit. */
typedef struct taut_net_spot {
    double x[3], tangent[3], normal[3], sideways[3]; /* sideways: normal x tangent */
    double k_n, tau;                                 /* tau: of the surface along the tangent */
    double speed;                                    /* length per parameter */
    double blur; /* what rounding of the surface may make of the tangent, over the size */
} taut_net_spot;

/* Gauss's rule on [-1, 1] and the polynomials through its nodes. */
typedef struct taut_net_rule {
    double nodes[TAUT_NET_NODES], weights[TAUT_NET_NODES];
    double derive[TAUT_NET_NODES][TAUT_NET_NODES]; /* [i][k]: the derivative at i of the k-th */
    double share[TAUT_NET_NODES];                  /* barycentric weights */
} taut_net_rule;

void taut_net_rule_fill(taut_net_rule *rule);

/* The polynomial through values at the nodes, at x in [-1, 1]. */
double taut_net_rule_at(const taut_net_rule *rule, const double *values, double x);

/* At a parameter of a line; 0 where there is no tangent plane. */
int taut_net_spot_at(taut_net_cells *cells, taut_trace_net net, const taut_net_line *line, double t,
                     taut_net_spot *spot);

/* A line from `from` to `to`, its parameters, at the nodes between; 0 where some place has no tangent plane. */
int taut_net_spots(taut_net_cells *cells, taut_trace_net net, const taut_net_line *line,
                   const taut_net_rule *rule, double from, double to,
                   taut_net_spot spots[TAUT_NET_NODES]);

/* k_g at the nodes between the parameters `from` and `to`. */
void taut_net_sideways_bend(const taut_net_rule *rule, const taut_net_spot *spots, double from,
                            double to, double k_g[TAUT_NET_NODES]);

#endif /* TAUT_CERTIFY_TRACE_BENDS_H */
