/* everywhere.h -- is there a net at every place of the window? Proved, by Bernstein coefficients.
 *
 * With N = S_u x S_v, not made unit, l = S_uu . N, m = S_uv . N, n = S_vv . N:
 *
 *     m^2 - l n > 0                                     K < 0: asymptotic curves, and lines of curvature
 *     (E n - 2 F m + G l)^2 - 4 (EG - F^2)(ln - m^2) > 0   R > 0: lines of curvature
 *
 * Either is 0 where N = 0, so that a surface for which one is proved has a normal everywhere. Where the net exists
 * everywhere on the window, a disc, two curves of its families cross at most once: a lens between them would hold a
 * singular point ([doCarmo1976] 4-5, turning tangents).
 */
#ifndef TAUT_CERTIFY_TRACE_EVERYWHERE_H
#define TAUT_CERTIFY_TRACE_EVERYWHERE_H

#include "certify/trace/cells.h"
#include "taut/trace.h"

/* Is it proved of the first surface? 0 too for surfaces with weights, and where the number of pieces is spent. net:
 * asymptotic or principal. TAUT_NO_MEMORY. */
taut_status taut_net_everywhere(taut_net_cells *cells, taut_trace_net net, int *is_proved);

#endif /* TAUT_CERTIFY_TRACE_EVERYWHERE_H */
