/* frame.h -- unit vectors normal to an axis, carried along it. */
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

#endif /* TAUT_PIPE_FRAME_H */
