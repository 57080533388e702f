/* loop.h -- splines that go around: those of a clamped basis whose ends meet with all derivatives
 * below the degree.
 *
 * Over its n clamped functions a bspline of degree p has m = n - p splines that are periodic over
 * the range, with a simple knot at the seam. They are written with the functions M_0 .. M_(n-1) of
 * the knots that go on beyond both ends with the period, t_(k+m) = t_k + range, of which M_(j+m) is
 * the copy of M_j:
 *
 *     x = sum_j M_j c_j,   c_(j+m) = c_j          N_i = sum_j K_ji M_j,   P_i = sum_j K_ij c_j
 *
 * K is the identity but in its first and last p - 1 rows, which are Boehm's insertions of the knot
 * at the seam ([PieglTiller1997] 5.2): convex combinations, K_ij > 0 for i <= j < p, and mirrored at the
 * other end. On each span the same p + 1 indices are alive of both kinds.
 */
#ifndef TAUT_GEOMETRY_NURBS_LOOP_H
#define TAUT_GEOMETRY_NURBS_LOOP_H

#include "core/arena.h"
#include "taut/basis.h"

typedef struct taut_loop {
    int degree;
    int count;     /* n */
    int period;    /* m */
    double *first; /* [degree][degree]: K of the first rows; the last of them is a unit row */
    double
        *last; /* [degree][degree]: K of the last rows, [k] that of n - 1 - k at n - 1 - column */
} taut_loop;

/* The least number of functions: fewer have functions that overlap themselves. */
static inline int taut_loop_least(int degree)
{
    return 2 * degree + 1;
}

/* basis: a bspline of degree 2 or more, of at least taut_loop_least functions, no knot inside
 * repeated as often as the degree. In the arena: TAUT_NO_MEMORY. */
taut_status taut_loop_new(const taut_basis *basis, taut_arena *arena, taut_loop *loop);

/* values double[degree + 1] of the N alive from `first` on become those of the M. */
void taut_loop_open(const taut_loop *loop, int first, double *values);

/* P_i from c double[n or more, at i][3] by `step` points: the clamped net of the c, in place. */
void taut_loop_clamp(const taut_loop *loop, size_t step, double *points);

/* The c of a clamped net that is closed, in place: the inverse of the above, of its first points. */
void taut_loop_unclamp(const taut_loop *loop, size_t step, double *points);
/* Derivatives by the c, those of copies being 0, become derivatives by the first points of the clamped net that they are
 * found from; the others have 0. In place. */
void taut_loop_unclamp_slopes(const taut_loop *loop, size_t step, double *slopes);

/* The mean of the knots inside the support of M_j, brought into the range. */
double taut_loop_greville(const taut_basis *basis, int j);

#endif /* TAUT_GEOMETRY_NURBS_LOOP_H */
