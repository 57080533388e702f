/* axis.h -- the axis of a finished pipe as the certificate sees it: plain Bezier pieces in
 * coordinates of unit size about its first point, worked out from the model's curve, and nothing of
 * what the construction knew about it. */
#ifndef TAUT_CERTIFY_PIPE_AXIS_H
#define TAUT_CERTIFY_PIPE_AXIS_H

#include "core/arena.h"
#include "taut/model.h"

enum { TAUT_PIPE_PIECE_DEGREE = 15 };

/* A curvature below this, over the size of the axis, cannot be told from none. */
#define TAUT_PIPE_STRAIGHT 1e-12

typedef struct taut_pipe_piece {
    int degree;
    double points[TAUT_PIPE_PIECE_DEGREE + 1][3];
    double lo, hi; /* its parameters on the curve */
    int flat[2];   /* nonzero: there is no curvature at that end, but for rounding */
    double radius; /* of an arc, of which this is nearly the polynomial (circle.h); 0: none */
} taut_pipe_piece;

typedef struct taut_pipe_figures {
    double length, turning, torsion, bending; /* integrals of 1, curvature, torsion, curvature^2;
                                               * torsion NaN: rounding decides it */
    double curvature, curvature_at;           /* the largest, and the curve's parameter there */
    double ends[2];                           /* curvature at either end */
    double rho;                               /* the largest radius; INFINITY where unbounded */
    double curvature_bound;                   /* the largest curvature, proved from above */
    int by_distance;   /* what binds it: a pair of points, or the curvature */
    double binding[2]; /* arc lengths from the first point */
} taut_pipe_figures;

typedef struct taut_pipe_line {
    taut_arena *arena;
    int count;
    taut_pipe_piece *pieces;
    double origin[3], scale; /* x = origin + scale * local */
    double noise;            /* how far rounding of the coordinates moves a local one */
    double tangent[2][3];    /* unit, at either end */
    double lengths[2];       /* local, of the straight pipes; INFINITY: half lines */
    int run;                 /* nonzero: the pieces are all there is, straight pipes among them, */
    int closed;              /* and the last ends where the first begins */
} taut_pipe_line;

/* From the curve. TAUT_BAD_INPUT for one that is rational, no polynomial, of too high a degree, or
 * without a direction at an end. The arena owns the pieces. */
taut_status taut_pipe_line_of(const taut_curve *curve, taut_arena *arena, taut_pipe_line *line,
                              taut_error *error);
/* From the curves of a run, one Bezier piece or one arc each, piece i over [i, i + 1]. */
taut_status taut_pipe_line_of_run(const taut_curve *const *curves, int count, taut_arena *arena,
                                  taut_pipe_line *line, taut_error *error);
/* d[k][3]: the k-th derivative by the piece's own parameter in [0, 1], k = 0..order <= 3. */
void taut_pipe_piece_eval(const taut_pipe_piece *piece, double t, int order, double (*d)[3]);
double taut_pipe_piece_curvature(const taut_pipe_piece *piece, double t);

/* Figures, local: integrals by adaptive quadrature (axis.c), the largest curvature by bounds
 * on ever smaller pieces (bend.c), rho by bounds on pairs of them (reach.c). */
void taut_pipe_integrate(const taut_pipe_line *line, taut_pipe_figures *figures);
void taut_pipe_bound_curvature(const taut_pipe_line *line, taut_pipe_figures *figures);
taut_status taut_pipe_bound_reach(const taut_pipe_line *line, taut_pipe_figures *figures);

/* A step of both parameters down |p - q|^2 / 2, from points with two derivatives. */
void taut_pipe_pair_step(const double p[3][3], const double q[3][3], double move[2]);

/* Is there no chord of 2 `radius` (local) or less that a pipe would cut itself at? If not, or not
 * proved, one that is left (apart.c). */
typedef struct taut_pipe_apart {
    int proved;
    int piece[2]; /* where, in the order of flow, straight pipes included */
    double at[2];
    double distance, way; /* through space and along the axis, */
    double from;          /* which begins there, from the first point of the curve */
} taut_pipe_apart;
taut_status taut_pipe_prove_apart(const taut_pipe_line *line, double radius, taut_pipe_apart *out);

#endif /* TAUT_CERTIFY_PIPE_AXIS_H */
