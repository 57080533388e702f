/* turns.h -- are the singular points of details places that directions turn round, and as often? */
#ifndef TAUT_CERTIFY_TRACE_TURNS_H
#define TAUT_CERTIFY_TRACE_TURNS_H

#include "certify/trace/audit.h"

/* `singular_points` of asymptotic and principal nets; other nets have none. */
void taut_net_turns_look(const taut_net_audit *audit, taut_net_off *off);

#endif /* TAUT_CERTIFY_TRACE_TURNS_H */
