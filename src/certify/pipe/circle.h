/* circle.h -- axes that are arcs of circles, and the tori about them.
 *
 * An arc is a rational Bezier curve of degree 2 on points P_0, P_1, P_2 with P_1 as far from both, and weights
 * w, w cos(A / 2), w, A the angle between its legs. It is no polynomial; what is proved of axes as polynomials is
 * proved of one that has its point and seven derivatives at both ends, which is off by at most
 * R (A / 2)^16 / 16!. What is to be had in closed form (curvature, the tube) is had from the arc itself.
 */
#ifndef TAUT_CERTIFY_PIPE_CIRCLE_H
#define TAUT_CERTIFY_PIPE_CIRCLE_H

#include "certify/pipe/axis.h"

typedef struct taut_pipe_circle {
    double radius, angle;
    double centre[3], out[3], ahead[3]; /* both unit, at its beginning */
    double miss;                        /* how far the curve is from this, at most */
} taut_pipe_circle;

/* The arc that a curve is; 0 where it is none, to 1e-9 of its legs. */
int taut_pipe_circle_of(const taut_curve *curve, taut_pipe_circle *circle);
/* The directions from the centre, and of flow, at an angle. */
void taut_pipe_circle_directions(const taut_pipe_circle *circle, double angle, double out[3],
                                 double ahead[3]);
/* The polynomial, in the line's coordinates, and how far it is off in them. */
double taut_pipe_circle_piece(const taut_pipe_circle *circle, const taut_pipe_line *line,
                              taut_pipe_piece *piece);
/* What rounding of coordinates up to `size` makes of an arc's radius, over itself. */
double taut_pipe_circle_noise(const taut_curve *curve, double size);

#endif /* TAUT_CERTIFY_PIPE_CIRCLE_H */
