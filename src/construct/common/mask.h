/* mask.h -- which points of a net are unknown.
 *
 * The hull of the unknowns is the box (rows that hold one) x (columns that hold one); rows and
 * columns need not be neighbours. Where every point of the hull is unknown the system keeps its
 * tensor structure.
 *
 * Points may be tied: those of a net that goes around are copies of others, those of a pole are one
 * (`leader`; followers count as known). And they may be kept in a plane or on a line (`allowed`).
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
    const int
        *leader; /* [nu][nv]: the point that each moves with, or NULL: none is tied; borrowed */
    const double
        *allowed; /* [nu][nv][6], or NULL: the moves that a point may make, as the projector
                                * onto them, xx, yx, yy, zx, zy, zz; borrowed */
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

/* A net of derivatives becomes that of the moves there are: what followers have is their leader's, what
 * is not allowed is taken off, and known points have none. */
void taut_mask_reduce(const taut_mask *mask, double *net);
/* Followers get what their leaders have. */
void taut_mask_follow(const taut_mask *mask, double *net);

/* x = P x, P a projector as `allowed` has them; NULL: the identity. */
static inline void taut_mask_project(const double *p, double x[3])
{
    if (p != NULL) {
        const double y[3] = {x[0], x[1], x[2]};
        x[0] = p[0] * y[0] + p[1] * y[1] + p[3] * y[2];
        x[1] = p[1] * y[0] + p[2] * y[1] + p[4] * y[2];
        x[2] = p[3] * y[0] + p[4] * y[1] + p[5] * y[2];
    }
}

#endif /* TAUT_CONSTRUCT_COMMON_MASK_H */
