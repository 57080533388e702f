/* parabolic.h -- the last piece of an asymptotic curve before K = 0, where its field is not
 * Lipschitz: D = sqrt(M^2 - LN) itself is the variable,
 *
 *     g = M^2 - LN,   g' = g_u a + g_v b,   ds/dD = 2 D / g',   du/dD = a ds/dD,   dv/dD = b ds/dD
 *
 * which is smooth down to D = 0 at cusps (g' not 0) and at envelopes (g' = O(D)): Gauss collocation
 * of 8 stages, whose nodes never touch 0.
 */
#ifndef TAUT_TRACE_PARABOLIC_H
#define TAUT_TRACE_PARABOLIC_H

#include "trace/follow.h"

enum { TAUT_PARABOLIC_LEVELS = 48 };

typedef struct taut_parabolic {
    int count;                                     /* of states, 0: not here */
    taut_walk_state states[TAUT_PARABOLIC_LEVELS]; /* at falling D, the last at D = 0 */
    double d[TAUT_PARABOLIC_LEVELS];               /* D of each */
    int is_envelope;                               /* the line K = 0 is touched, not met */
} taut_parabolic;

/* Tries it from a state; count is 0 where K = 0 is not near, or lies beyond the cell. */
void taut_parabolic_finish(const taut_carrier *carrier, taut_linefield_kind kind,
                           const taut_walk_state *state, taut_parabolic *found);

#endif /* TAUT_TRACE_PARABOLIC_H */
