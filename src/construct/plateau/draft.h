/* draft.h -- a film near one of another boundary, as far as a few cheap steps lead: what a hand that drags waits for.
 *
 *     x_0            the film that was there
 *     d_0            known points where they belong now; L_g(x_0) (x_0 + d_0) = 0 in the others
 *     d_k            L_g(x_k) (x_k + d_k) = 0 in the unknown points
 *
 * L_g is the metric operator of construct/plateau/area.h, cables with it: each step goes to the least of a quadratic form that
 * lies above the energy and meets it in x_k, so none raises it ([PinkallPolthier1993]). It is one number where the Hessian
 * has nine, so that its factors cost a ninth of a ninth of those of Newton's step.
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_DRAFT_H
#define TAUT_CONSTRUCT_PLATEAU_DRAFT_H

#include "construct/common/mask.h"
#include "construct/plateau/area.h"

/* Nodes a cell beyond the functions alive there. With fewer, moves within the surface find gaps between nodes and wrinkle it. */
enum { TAUT_AREA_DRAFT_EXTRA = 0 };

/* So many steps of net double[nu][nv][3]; held double[nu][nv][3]: where known points belong. Ends where a step moves nothing by
 * more than 1e-9. Of points that are kept in a plane or on a line, at most four, `held` has a place there. Cables that give way lead their multiplier. TAUT_NO_SOLUTION: the metric is not safely positive definite; TAUT_NO_MEMORY. */
taut_status taut_area_draft(taut_area_functional *functional, const taut_mask *mask,
                            const double *held, int steps, double *net);

#endif /* TAUT_CONSTRUCT_PLATEAU_DRAFT_H */
