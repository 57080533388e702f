/* figures.h -- are the numbers that details give of laths those of their curves? */
#ifndef TAUT_CERTIFY_TRACE_FIGURES_H
#define TAUT_CERTIFY_TRACE_FIGURES_H

#include "certify/trace/audit.h"

/* Of one lath: `family`, `from`, `to`, `twist`, `turn`, `k_n`, `k_g`, `tau_g`, and what is cut for it; not between the
 * ends of the line and clear[0], clear[1], where a net's own end lets curvatures grow without bound. */
void taut_net_figures_of(const taut_net_audit *audit, const taut_net_line *line,
                         const double clear[2], taut_net_off *off);

/* The parameter at which the line passes its seed; NaN where there is none. *away: how far it does, over the size. */
double taut_net_seed_at(const taut_net_audit *audit, const taut_net_line *line,
                        const taut_record *lath, double *away);

#endif /* TAUT_CERTIFY_TRACE_FIGURES_H */
