/* rows.h -- Algorithm 2, steps 3 and 4: the boundary rows and the rows beside them, which carry the
 * ribbons.
 */
#ifndef TAUT_ASYMPTOTIC_ROWS_H
#define TAUT_ASYMPTOTIC_ROWS_H

#include "construct/asymptotic/ribbon.h"

/* Fills the boundary rows, the second rows, and the inner weights with 1; patch->m is 5n - 7.
 * TAUT_NO_SOLUTION if a weight beside the boundary is not positive. */
taut_status taut_rows_fill(const taut_quad *quad, const taut_ribbon ribbons[4], taut_patch *patch,
                           taut_error *error);

#endif /* TAUT_ASYMPTOTIC_ROWS_H */
