/* section.h -- elliptic sections in place of round ones ([WangBai2018] section 10.6).
 *
 *     X(t, phi) = P + a(t) cos phi E_1(t) + b(t) sin phi E_2(t),
 *     E_1 = cos psi U + sin psi W,   E_2 = -sin psi U + cos psi W
 *
 * U, W the rotation-minimising frame that begins along the first major axis, psi, a and b from one
 * end to the other by a step whose rate vanishes at both: where psi or the semi-axes still moved,
 * the tangent planes would not be those of the straight pipes.
 */
#ifndef TAUT_PIPE_SECTION_H
#define TAUT_PIPE_SECTION_H

#include "construct/pipe/frame.h"

typedef struct taut_pipe_ellipse {
    double first[3];   /* unit, along the major axis at the start */
    double a[2], b[2]; /* at both ends, over the radius of the circle around the larger */
    double turn;       /* psi at the end, in (-pi/2, pi/2] */
    int smooth;        /* nonzero: second derivatives vanish at the ends too */
    double canal;      /* the radius that a and b are over, local: circles of a canal surface,
                        *     X = P - r r_s T + r sqrt(1 - r_s^2) (cos phi U + sin phi W)
                        * with r_s = dr/ds ([WangBai2018] section 10.5); 0: others */
} taut_pipe_ellipse;

/* a E_1 and b E_2 with their derivatives, where `frame` is the rotation-minimising one. */
void taut_pipe_ellipse_at(const taut_pipe_ellipse *ellipse, const taut_pipe_arc *arc, double t,
                          const taut_pipe_normals *frame, taut_pipe_normals *section);
/* What a canal surface with this r(t) leaves, the least over the axis: of 1 - |r_s|, and of
 *     1 - r_s^2 - r r_ss - r kappa sqrt(1 - r_s^2)
 * which are positive where it is real, and regular; and where these are. */
typedef struct taut_pipe_canal_room {
    double real, real_at, regular, regular_at;
} taut_pipe_canal_room;
void taut_pipe_canal_room_of(const taut_pipe_ellipse *canal, const taut_pipe_arc *arc,
                             taut_pipe_canal_room *room);
/* first and turn, from the directions wanted at both ends; 0 for one that is along the axis there
 * (*side tells which). */
int taut_pipe_ellipse_turn(const taut_pipe_arc *arc, const double *const directions[2],
                           taut_pipe_ellipse *ellipse, int *side);

#endif /* TAUT_PIPE_SECTION_H */
