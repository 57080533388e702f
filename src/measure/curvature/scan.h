/* scan.h -- the six derivative vectors on a grid, one line at a time.
 *
 * As taut_surface_eval_grid, but one-sided where asked for, without keeping the grid, and with
 * derivatives from differences: as the derivatives of the basis functions sum to 0,
 *     sum_a N_a' P_a = sum_a N_a' (P_a - P_first),
 * whose rounding is that of the net near by, not of its distance from the origin. Sums over the first direction are
 * rounded before the second one takes their differences, so that a net far away (a thousand times its size) is
 * brought to the origin first, and positions are told from there: no one needs these but to judge rounding.
 */
#ifndef TAUT_MEASURE_CURVATURE_SCAN_H
#define TAUT_MEASURE_CURVATURE_SCAN_H

#include "geometry/grid/table.h"
#include "measure/integrate/parameters.h"
#include "taut/surface.h"

#include <stddef.h>

typedef struct taut_scan {
    taut_table *u, *v;
    int dim; /* 3, or 4 with weights */
    int columns;
    const double *net; /* [rows][columns][dim], homogeneous with weights */
    double centre[3];  /* taken off a homogeneous net */
    int is_far;        /* from the origin: taken off any net, and off the positions told */
} taut_scan;

/* In the arena. The surface must outlive the scan. TAUT_NO_MEMORY, also where the arena has failed;
 * TAUT_BAD_ARGUMENT for parameters out of range. */
taut_status taut_scan_new(taut_arena *arena, const taut_surface *surface, const taut_parameters *u,
                          const taut_parameters *v, taut_scan **scan);

/* Numbers of scratch one worker needs. */
size_t taut_scan_scratch(const taut_scan *scan);
/* values[j][6][3] along line i of u, all entries j of v. */
void taut_scan_line(const taut_scan *scan, int i, double *scratch, double *values);

#endif /* TAUT_MEASURE_CURVATURE_SCAN_H */
