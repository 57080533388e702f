/* spans.h -- a curve of a net span by span, as Bernstein coefficients in space and in the window. */
#ifndef TAUT_CERTIFY_TRACE_SPANS_H
#define TAUT_CERTIFY_TRACE_SPANS_H

#include "certify/trace/lines.h"

enum { TAUT_NET_QUINTIC = 5 };

typedef struct taut_net_span {
    double from, to;
    double space[TAUT_NET_QUINTIC + 1][3];  /* times 2^-unit */
    double window[TAUT_NET_QUINTIC + 1][2]; /* in that of surface `on` */
    int on;
} taut_net_span;

/* Quintic B-splines without weights in space and in the window, as a net's curves are? */
int taut_net_line_is_quintic(const taut_net_line *line);

/* Span i of such a curve; 0 where the window has other knots there. */
int taut_net_span_of(const taut_net_line *line, int i, int unit, taut_net_span *span);

#endif /* TAUT_CERTIFY_TRACE_SPANS_H */
