/* tangents.h -- the directions of R_u and R_v over a piece of a surface, as polynomials that can be
 * halved fast.
 *
 *     R = X / w:    A = w X_u - w_u X = w^2 R_u,    B = w X_v - w_v X = w^2 R_v,
 *
 * of degrees (2p - 2, 2q) and (2p, 2q - 2), and of (p - 1, q) and (p, q - 1) without weights. The
 * sine between R_u and R_v is that between A and B: their lengths do not matter, so nothing has to be
 * known of w but that it is positive.
 */
#ifndef TAUT_CERTIFY_COMMON_TANGENTS_H
#define TAUT_CERTIFY_COMMON_TANGENTS_H

#include "certify/common/field.h"

/* The coefficients of A (0) and B (1), of degrees p, q: double[p + 1][4][q + 1], the three
 * coordinates and a majorant: each of them is within error * majorant of the exact one. */
typedef struct taut_tangents {
    int p[2], q[2];
    double *a[2];
    double error;
} taut_tangents;

/* Numbers in both: the size of one block for `a`. */
size_t taut_tangents_size(const taut_tangents *t);
/* a[] laid over a block of that size. */
void taut_tangents_place(taut_tangents *t, double *block);

/* From a piece of taut_field_of_surface. 0, with *t spoilt, where memory ran out or a coefficient
 * leaves the range of doubles. */
int taut_tangents_of(taut_arena *arena, const taut_field piece[4], taut_tangents *t);

/* Halves over u (direction 0) or v (1) at 1/2: *t becomes the high one, *low is laid over `block`. */
void taut_tangents_halve(taut_tangents *t, int direction, double *block, taut_tangents *low);

/* A number proved not to exceed the sine anywhere on the closed piece; 0 where R_u and R_v, or one of
 * them and 0, cannot be told apart. *direction: which of the two to halve, by how A and B turn. */
double taut_tangents_bound(const taut_tangents *t, int *direction);

/* A and B at a point of [0, 1]^2. */
typedef struct taut_tangent_pair {
    double x[2][3];  /* A, B */
    double du[2][3]; /* and their derivatives */
    double dv[2][3];
    double error[2];  /* |A|, |B| are known to so much, at these u, v */
    double sine;      /* nearest; NaN where A or B is 0 */
    double sine_most; /* that the exact sine does not exceed; 1 where that is not known */
} taut_tangent_pair;
/* The sine between two directions, each coordinate of them known to so much; and *most. */
double taut_tangents_sine(double x[2][3], const double error[2], double *most);
void taut_tangents_at(const taut_tangents *t, double u, double v, taut_tangent_pair *pair);
/* The same at the corner u = i, v = j, where coefficients are values; without derivatives. */
double taut_tangents_corner(const taut_tangents *t, int i, int j, double *sine_most);

/* Sines on a grid, to begin searches from: double[count][count], at (u_i, v_j); NaN where A or B is
 * 0. */
void taut_tangents_grid(const taut_tangents *t, int count, const double *u, const double *v,
                        double *sines);

#endif /* TAUT_CERTIFY_COMMON_TANGENTS_H */
