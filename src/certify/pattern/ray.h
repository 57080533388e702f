/* ray.h -- geodesics of a piece, from a place on until they leave it.
 *
 * In (s, t), by Runge and Kutta's rule of order 4: p^k' = -G^kl <X_l, X_ab> p^a p^b, |p| = 1.
 */
#ifndef TAUT_CERTIFY_PATTERN_RAY_H
#define TAUT_CERTIFY_PATTERN_RAY_H

#include "certify/pattern/cloth.h"

/* A place of a piece. */
typedef struct taut_cloth_spot {
    double first[2][3];  /* X_s, X_t */
    double second[3][3]; /* X_ss, X_st, X_tt */
    double g[3], area;   /* g_ss, g_st, g_tt and its root of the determinant */
    double gauss;
    double bend; /* geodesic curvature of the line t = const */
} taut_cloth_spot;

/* 0 where the surface has no metric. Places outside [0, 1]^2 are moved to its border. */
int taut_cloth_spot_at(const taut_cloth *cloth, const taut_cloth_piece *piece, double s, double t,
                       taut_cloth_spot *spot);

typedef struct taut_cloth_ray {
    double length; /* from the place on; the limit where it did not leave the piece */
    int border;   /* that it left by, TAUT_CLOTH_RIGHT ..; -1: none, -2: it could not be followed */
    double slant; /* cosine of the angle between the ray and that border, as s or t grows */
    double gauss[2]; /* least and largest Gauss curvature on its way */
} taut_cloth_ray;

/* `angle` from X_s towards X_t; followed for at most `limit`, in steps of at most `step`. */
void taut_cloth_ray_from(const taut_cloth *cloth, const taut_cloth_piece *piece, const double at[2],
                         double angle, double limit, double step, taut_cloth_ray *ray);
/* How far a place is from the border, at most `limit`: the least of rays that meet it squarely, and of rays all around; 0 where
 * none of them meets it soon after. */
double taut_cloth_distance(const taut_cloth *cloth, const taut_cloth_piece *piece,
                           const double at[2], double limit);

#endif /* TAUT_CERTIFY_PATTERN_RAY_H */
