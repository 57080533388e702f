/* figures.h -- are the numbers that details give of laths those of their curves? */
#ifndef TAUT_CERTIFY_TRACE_FIGURES_H
#define TAUT_CERTIFY_TRACE_FIGURES_H

#include "certify/trace/course.h"

/* The figure that is farthest off, relative to what it is of. INFINITY where one is missing or cannot be found again. */
typedef struct taut_net_off {
    double residual;
    char where[96];
} taut_net_off;

void taut_net_off_take(taut_net_off *off, double residual, const char *name, const char *member);

/* Over the range: a place that is so near to a knot may as well be beyond it. */
#define TAUT_NET_AT_KNOT 1e-9

/* Is the place on an inner knot line? */
int taut_net_is_on_knot(const taut_surface *surface, const double at[2]);

/* What figures are held against. */
typedef struct taut_net_audit {
    const taut_net_lines *lines;
    taut_net_cells *cells; /* of surfaces times 2^-unit */
    const taut_net_rule *rule;
    const taut_trace_problem *problem; /* or NULL: then laths are what details say they are */
    int unit;
    double size; /* times 2^-unit */
} taut_net_audit;

/* Of one lath: `family`, `from`, `to`, `twist`, `turn`, `k_n`, `k_g`, `tau_g`, and what is cut for it; not between the
 * ends of the line and clear[0], clear[1], where a net's own end lets curvatures grow without bound. */
void taut_net_figures_of(const taut_net_audit *audit, const taut_net_line *line,
                         const double clear[2], taut_net_off *off);

#endif /* TAUT_CERTIFY_TRACE_FIGURES_H */
