/* patch.h -- the net of a patch of bidegree (m, m) while it is being built, and the rows beside its
 * four edges.
 */
#ifndef TAUT_ASYMPTOTIC_PATCH_H
#define TAUT_ASYMPTOTIC_PATCH_H

#include "construct/asymptotic/quad.h"
#include "core/arena.h"

/* net[i][j] = (W S, W): numerator and weight, i along u, j along v. */
typedef struct taut_patch {
    int m;
    double (*net)[4];   /* [m + 1][m + 1] */
    double twist[4][3]; /* R_uv at the corners */
    double weight[4];   /* of the next inner point at the corners */
    double share[4][2]; /* of each edge's end in that point (taut_patch_boundary) */
} taut_patch;

taut_status taut_patch_new(taut_arena *arena, int m, taut_patch *patch);

/* Entry k along an edge, `depth` rows in from it. */
double *taut_patch_at(const taut_patch *patch, int edge, int depth, int k);

/* Boundary rows: the edges raised to degree m; both edges of a corner give the same entry. And the
 * shares of the two edges of a corner in the inner point S_11 next to it, which each of them gives:
 * the two differ along the normal by some d where the data's torsions are opposite only to the
 * rounding of the points, which near an inflection is much. With shares s + s' = 1 edge e misses
 * its own by s' d and gets a normal curvature of some k_e s' d; the shares
 *     s = k_e^2 / (k_e^2 + k_f^2),   k^2 the mean at 0, 1/m and 2/m from the corner,
 * make the sum of the squares of the two least. */
void taut_patch_boundary(const taut_quad *quad, taut_patch *patch);

/* Homogeneous coefficients (w x, w y, w z, w) of an edge: double[n + 1][4]. */
void taut_quad_homogeneous(const taut_quad_edge *edge, int n, double (*h)[4]);

#endif /* TAUT_ASYMPTOTIC_PATCH_H */
