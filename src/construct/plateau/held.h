/* held.h -- moves of a net that leave the surface where it is held.
 *
 *     sum_ij c_k,ij z_ij = 0 in each coordinate,    c_k,ij = R_ij(u_k, v_k) at unknown points
 *
 * or, where each point moves along a direction d_ij of its own, z_ij = zeta_ij d_ij, three conditions on these numbers. A step of
 * least B-norm among them: with y = B^-1 b and W = B^-1 Q^T, Q the conditions made orthonormal,
 *
 *     z = y - W (Q W)^-1 Q y            ([NocedalWright2006] 16.2, the Schur complement)
 *
 * Vectors are those of construct/plateau/newton_step.h.
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_HELD_H
#define TAUT_CONSTRUCT_PLATEAU_HELD_H

#include "construct/common/mask.h"
#include "construct/common/through.h"

typedef struct taut_held {
    int count;     /* of independent conditions */
    size_t size;   /* of a vector */
    double *row;   /* [count][size]: Q */
    double *image; /* [count][size]: W, filled by who has B */
    double *small; /* [count][count]: of Q W, then its Cholesky factor */
    double *part;  /* [count] */
} taut_held;

/* So many numbers that takes. */
double taut_held_numbers(int conditions, size_t points, int is_directed);

/* directions double[nu][nv][3] or NULL; all in the arena. TAUT_NO_MEMORY. */
taut_status taut_held_new(const taut_conditions *conditions, const taut_mask *mask,
                          const double *directions, taut_arena *arena, taut_held *held);

/* z less its part across. */
void taut_held_project(const taut_held *held, double *z);

static inline const double *taut_held_row(const taut_held *held, int r)
{
    return held->row + (size_t)r * held->size;
}

static inline double *taut_held_image(const taut_held *held, int r)
{
    return held->image + (size_t)r * held->size;
}

/* Q W from the images. 0 where it is not positive definite. */
int taut_held_factor(taut_held *held);
/* z = B^-1 b is made the step. */
void taut_held_correct(const taut_held *held, double *z);

#endif /* TAUT_CONSTRUCT_PLATEAU_HELD_H */
