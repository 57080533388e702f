/* frame.h -- unit vectors normal to an axis, carried along it, and sections about them. */
#ifndef TAUT_PIPE_FRAME_H
#define TAUT_PIPE_FRAME_H

#include "construct/pipe/arc.h"

typedef struct taut_pipe_normals {
    double u[3], du[3];    /* first vector and its derivative by t */
    double w[3], dw[3];    /* tangent x u */
    double ddu[3], ddw[3]; /* second derivatives, of rotation-minimising ones */
    double c[3], dc[3];    /* of canal surfaces: how far back the circle is */
} taut_pipe_normals;

/* The coordinate axis with the smallest component in `tangent`, made normal to it; the lowest of
 * equals. */
void taut_pipe_first_normal(const double tangent[3], double u[3]);

/* One double reflection ([WangJuttler2008]): r0, normal to t0 at x0, becomes r1, normal to t1 at
 * x1, with an error of order 4 over a whole curve. 0 where the step is so long that the second
 * reflection has no plane. */
int taut_pipe_reflect(const double x0[3], const double t0[3], const double r0[3],
                      const double x1[3], const double t1[3], double r1[3]);

/* Carries u from parameter `from` to `to` in `steps` double reflections, halving those that are too
 * long. */
void taut_pipe_carry(const taut_pipe_arc *arc, double from, double to, int steps, double u[3]);

/* The rotation-minimising normals at t, where u is known: derivatives are along the tangent,
 *     u' = -(u . T') T,   u'' = -(u . T'') T - (u . T') T',   w alike */
void taut_pipe_bishop(const taut_pipe_arc *arc, double t, const double u[3],
                      taut_pipe_normals *normals);

/* Frenet's: u the normal, w the binormal. P' x P'' = t^p (1-t)^q K(t) with p, q the zeros at the
 * ends, so that the limits there are those of K. */
typedef struct taut_pipe_binormal {
    int degree;
    double k[2 * TAUT_PIPE_DEGREE_MAX - 3][3];
    double least; /* the smallest |K| over its largest coefficient; 0 for a straight arc */
    double least_at;
} taut_pipe_binormal;

void taut_pipe_binormal_of(const taut_pipe_arc *arc, taut_pipe_binormal *binormal);
void taut_pipe_frenet(const taut_pipe_arc *arc, const taut_pipe_binormal *binormal, double t,
                      taut_pipe_normals *normals);

/* Elliptic sections in place of round ones ([WangBai2018] section 10.6):
 *
 *     X(t, phi) = P + a(t) cos phi E_1(t) + b(t) sin phi E_2(t),
 *     E_1 = cos psi U + sin psi W,   E_2 = -sin psi U + cos psi W
 *
 * U, W the rotation-minimising frame that begins along the first major axis, psi, a and b from one
 * end to the other by a step whose rate vanishes at both: where psi or the semi-axes still moved,
 * the tangent planes would not be those of the straight pipes.
 */
/* What a section is from end to end. */
typedef struct taut_pipe_profile {
    double first[3];   /* unit, along the major axis at the start */
    double a[2], b[2]; /* at both ends, over the radius of the circle around the larger */
    double turn;       /* psi at the end, in (-pi/2, pi/2] */
    int smooth;        /* nonzero: second derivatives vanish at the ends too */
    double canal;      /* the radius that a and b are over, local: circles of a canal surface,
                        *     X = P - r r_s T + r sqrt(1 - r_s^2) (cos phi U + sin phi W)
                        * with r_s = dr/ds ([WangBai2018] section 10.5); 0: others */
} taut_pipe_profile;

/* a E_1 and b E_2 with their derivatives, where `frame` is the rotation-minimising one. */
void taut_pipe_profile_at(const taut_pipe_profile *profile, const taut_pipe_arc *arc, double t,
                          const taut_pipe_normals *frame, taut_pipe_normals *section);
/* What a canal surface with this r(t) leaves, the least over the axis: of 1 - |r_s|, and of
 *     1 - r_s^2 - r r_ss - r kappa sqrt(1 - r_s^2)
 * which are positive where it is real, and regular; and where these are. */
typedef struct taut_pipe_canal_room {
    double real, real_at, regular, regular_at;
} taut_pipe_canal_room;
void taut_pipe_canal_room_of(const taut_pipe_profile *canal, const taut_pipe_arc *arc,
                             taut_pipe_canal_room *room);
/* first and turn, from the directions wanted at both ends; 0 for one that is along the axis there
 * (*side tells which). */
int taut_pipe_profile_turn(const taut_pipe_arc *arc, const double *const directions[2],
                           taut_pipe_profile *profile, int *side);

#endif /* TAUT_PIPE_FRAME_H */
