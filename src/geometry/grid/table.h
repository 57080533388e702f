/* table.h -- the basis functions at many parameters, worked out once per line of a grid. */
#ifndef TAUT_GEOMETRY_GRID_TABLE_H
#define TAUT_GEOMETRY_GRID_TABLE_H

#include "taut/basis.h"

#include <stdint.h>

typedef struct taut_table {
    int count;      /* parameters */
    int order;      /* highest derivative */
    int local;      /* functions alive at each */
    int *first;     /* [count]: index of the first of them */
    double *values; /* [count][order+1][local] */
} taut_table;

/* At t[0..count-1] in the closed range. spans: [count], the span to take each from (for one-sided
 * derivatives), or NULL for the span on the right. TAUT_BAD_ARGUMENT for a parameter outside,
 * TAUT_NO_MEMORY. The caller frees *table. */
taut_status taut_table_new(const taut_basis *basis, int count, const double *t, const int *spans,
                           int order, taut_table **table);
void taut_table_free(taut_table *table); /* NULL is fine */

/* The values of derivative k at parameter i: double[local]. */
static inline const double *taut_table_row(const taut_table *table, int i, int k)
{
    return table->values + ((int64_t)i * (table->order + 1) + k) * table->local;
}

#endif /* TAUT_GEOMETRY_GRID_TABLE_H */
