/* dual.h -- the gap between the area of a film and the flux of a dual field, at Gauss points.
 *
 *     N   = S_u x S_v = (N_h, J) in a frame whose third axis is e;  s = sign J, the same everywhere
 *     q   = psi_u (x_v, y_v) - psi_v (x_u, y_u),    h = q / J: the horizontal part of the unit field
 *           X = (-psi_y, psi_x, s sqrt(1 - |h|^2)), which has no divergence
 *     gap = iint f(h),    f(h) = |N| - s N_h . h - |J| sqrt(1 - |h|^2)  >= 0
 *
 * f is convex in h, and so is the gap in the coefficients of psi; f is 0 at g = s N_h / |N| alone.
 * Theory: docs/least.md, docs/papers/least.md. What is computed here need not be trusted: the
 * certificate does it again, by other formulas.
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_DUAL_H
#define TAUT_CONSTRUCT_PLATEAU_DUAL_H

#include "core/arena.h"
#include "core/pulse.h"
#include "numeric/band.h"
#include "taut/surface.h"

/* The functions of psi in one direction at Gauss nodes on every span, slopes over the unit
 * interval. */
typedef struct taut_dual_axis {
    int count, local, spans, nodes; /* functions, those alive on a span, spans, nodes on each */
    int *first;                     /* [spans] */
    double *t, *weight;             /* [spans * nodes]; the weights sum to 1 */
    double *value, *slope;          /* [spans * nodes][local] */
} taut_dual_axis;

enum { TAUT_DUAL_STATE = 7 }; /* N in the frame; x_u, y_u, x_v, y_v */

typedef struct taut_dual {
    taut_dual_axis u, v;
    double *state;        /* [u nodes][v nodes][TAUT_DUAL_STATE] */
    double *slopes;       /* [2][v nodes in all]: psi_u, psi_v on a line */
    double *element;      /* [3][v.local][v.local]: scratch of the assembly */
    double *right, *step; /* [count]: of a system */
    double *work;         /* of its factors */
    double sign, area;    /* s; iint |N| */
    int along_u;          /* unknowns are numbered along u inside, along v outside */
    taut_band matrix;     /* cleared by taut_dual_clear */
    taut_pulse *pulse;    /* told of systems and their factors; or NULL */
} taut_dual;

/* What a psi is worth. */
typedef struct taut_dual_value {
    double gap;      /* in squares of the unit of the surface */
    double steepest; /* largest |h|; from 1 on the gap is NaN */
} taut_dual_value;

/* Where psi is not told, it is double[u.count][v.count]. */

/* `frame`: rows are the axes, the last is e. psi on the bases u and v, whose spans are those of the
 * surface. Of *dual its pulse is read. TAUT_NO_SOLUTION: J vanishes or changes its sign at a node. TAUT_NO_MEMORY,
 * TAUT_INTERRUPTED. */
taut_status taut_dual_new(const taut_surface *surface, const taut_basis *u, const taut_basis *v,
                          double frame[3][3], taut_arena *arena, taut_dual *dual);
void taut_dual_clear(taut_dual *dual);

/* density, where it is not NULL: double[u.spans][v.spans], the gap of each. */
taut_dual_value taut_dual_evaluate(taut_dual *dual, const double *psi, double *density);

/* The psi whose h is next to g: least (h - g) . f''(g) (h - g), one linear system.
 * TAUT_NO_SOLUTION: it is too ill-conditioned. TAUT_INTERRUPTED. */
taut_status taut_dual_start(taut_dual *dual, double *psi);
/* Newton's step from psi, to dual->step. The same statuses. */
taut_status taut_dual_newton(taut_dual *dual, const double *psi);

/* The matrix and the right side alone, numbered by taut_dual_number; psi NULL: of the start. TAUT_INTERRUPTED. */
taut_status taut_dual_assemble(taut_dual *dual, const double *psi);
int taut_dual_number(const taut_dual *dual, int i, int j);

/* About so many flops: one of these two. */
double taut_dual_cost(const taut_dual *dual);

#endif /* TAUT_CONSTRUCT_PLATEAU_DUAL_H */
