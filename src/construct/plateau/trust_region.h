/* trust_region.h -- from a net to the net of least area.
 *
 *     z = ((1 - theta) H + theta L_g)^-1 (-g),    x <- x + z
 *
 * theta is small where Newton's model is good and near 1 where it is not; at 1 the area falls
 * whatever the net, so no line search is needed ([WuWang2011] 7.1). The area never rises by more
 * than its rounding. A net where the gradient vanishes but a direction of negative curvature is
 * left is a saddle: it is stepped off along that direction.
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_TRUST_REGION_H
#define TAUT_CONSTRUCT_PLATEAU_TRUST_REGION_H

#include "construct/plateau/newton_step.h"

typedef struct taut_trust_region {
    /* given */
    double tolerance;
    int max_iterations;
    int has_free_edge;
    double *areas; /* [areas_max]: after each iteration, or NULL */
    int areas_max;
    double work_max;    /* flops, about: more are not spent on the way */
    double theta_least; /* theta is not lowered below it: moves that the area does not see then
                         * stay smooth, and symmetric */
    double
        rest_step; /* share: a step in all coordinates that gains less is the last, where the surface is
                         * level then; 0: five steps have to gain less than a tenth of the tolerance */
    double rest_from; /* area: a step that gains less than 1/250 of what there was from here on is
                         * the last, too; 0: none */
    int is_minimum;   /* the net given is a minimum along normals: no saddle is looked for */
    double
        gain_enough; /* share: a step that gains less is the last, where the residual is below `residual_enough` (0: 8e-7) and
                         * its theta was at most `theta_enough` (0: any); 0: the area is followed to rounding */
    double residual_enough, theta_enough;
    int patience; /* steps before that counts */
    double theta; /* of the first step; 0: 1e-2 */
    /* found; iterations and work are added to */
    int iterations;
    double work;
    double theta_next; /* of the step that would be next */
    int areas_count;
    double area;
    double residual; /* largest derivative along an unknown over the largest in the net */
    double gain;     /* what the last model still had to gain, over the area */
} taut_trust_region;

/* net double[nu][nv][3] is improved in place, on failure too. TAUT_NOT_CONVERGED, TAUT_NO_SOLUTION,
 * TAUT_INTERRUPTED, TAUT_NO_MEMORY. */
taut_status taut_trust_region_minimise(taut_area_functional *functional, taut_newton_step *newton,
                                       taut_trust_region *region, double *net, taut_error *error);

#endif /* TAUT_CONSTRUCT_PLATEAU_TRUST_REGION_H */
