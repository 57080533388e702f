/* mask.h -- which points of a net are unknown.
 *
 * The hull of the unknowns is the box (rows that hold one) x (columns that hold one); rows and
 * columns need not be neighbours. Where every point of the hull is unknown the system keeps its
 * tensor structure.
 */
#ifndef TAUT_CONSTRUCT_COMMON_MASK_H
#define TAUT_CONSTRUCT_COMMON_MASK_H

#include "core/arena.h"
#include "taut/status.h"

#include <stddef.h>

typedef struct taut_mask {
    int nu, nv;
    const unsigned char *known; /* [nu][nv], borrowed */
    size_t unknowns;
    int rows, columns;         /* of the hull */
    int *row, *column;         /* their indices, increasing */
    int is_box;                /* the unknowns are the whole hull */
    int is_interior;           /* the unknowns are exactly the points inside the boundary */
    unsigned char *hull_known; /* [rows][columns] */
} taut_mask;

/* Memory comes from the arena: TAUT_NO_MEMORY. */
taut_status taut_mask_new(int nu, int nv, const unsigned char *known, taut_arena *arena,
                          taut_mask *mask);

/* hull double[rows][columns][3] from net double[nu][nv][3]. */
void taut_mask_gather(const taut_mask *mask, const double *net, double *hull);
/* net += hull at the unknowns; nothing elsewhere. */
void taut_mask_add(const taut_mask *mask, const double *hull, double *net);
/* net = 0 at the known points. */
void taut_mask_clear_known(const taut_mask *mask, double *net);

#endif /* TAUT_CONSTRUCT_COMMON_MASK_H */
