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
} taut_patch;

taut_status taut_patch_new(taut_arena *arena, int m, taut_patch *patch);

/* Entry k along an edge, `depth` rows in from it. */
double *taut_patch_at(const taut_patch *patch, int edge, int depth, int k);

/* Boundary rows: the edges raised to degree m; both edges of a corner give the same entry. */
void taut_patch_boundary(const taut_quad *quad, taut_patch *patch);

/* Homogeneous coefficients (w x, w y, w z, w) of an edge: double[n + 1][4]. */
void taut_quad_homogeneous(const taut_quad_edge *edge, int n, double (*h)[4]);

#endif /* TAUT_ASYMPTOTIC_PATCH_H */
