/* line_rule.h -- Gauss quadrature along one direction of a surface, over the unit interval. */
#ifndef TAUT_CONSTRUCT_COMMON_LINE_RULE_H
#define TAUT_CONSTRUCT_COMMON_LINE_RULE_H

#include "geometry/grid/table.h"
#include "geometry/nurbs/cells.h"

typedef struct taut_line_rule {
    int count;         /* nodes */
    taut_table *table; /* order 1; slopes over the unit interval, not the basis' own range */
    double *weights;   /* [count], their sum is 1 */
    double *roundings; /* [count]: |t| over the width of its span, what a rounding of t is there */
    double reach;      /* max |t| over the length of the range */
} taut_line_rule;

/* `nodes` Gauss nodes, 1..TAUT_GAUSS_MAX, on every panel. TAUT_NO_MEMORY leaves *rule empty. */
taut_status taut_line_rule_init(const taut_basis *basis, const taut_cells *panels, int nodes,
                                taut_line_rule *rule);
void taut_line_rule_clear(taut_line_rule *rule); /* also an empty one */

#endif /* TAUT_CONSTRUCT_COMMON_LINE_RULE_H */
