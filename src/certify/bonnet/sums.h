/* sums.h -- derivatives of a net at one point after the other, each with its noise: what
 * rounding every control point, basis function and sum once may leave. */
#ifndef TAUT_CERTIFY_BONNET_SUMS_H
#define TAUT_CERTIFY_BONNET_SUMS_H

#include "core/arena.h"
#include "taut/measure.h"

enum { TAUT_BONNET_ORDERS = 4 };

/* How well the points of a net can be known: each carries |P| and what cancelled in it, |A_u| |u| +
 * |A_v| |v| with A_u, A_v the coefficients of u and of v in the surface. */
typedef struct taut_bonnet_scale {
    double linear[2]; /* |A_u|, |A_v|; 0 where the terms were taken apart before adding */
    double shift[2];  /* rounding of a parameter so far from zero, beyond that of its segment */
} taut_bonnet_scale;

/* is_exact: the net was made without cancellation (the normalised family). */
void taut_bonnet_scale_of(const taut_surface *surface, int is_exact, taut_bonnet_scale *scale);
/* The size of control point (i, j) with what cancelled in it. */
double taut_bonnet_point_size(const taut_surface *surface, const taut_bonnet_scale *scale, int i,
                              int j);

/* One parameter: the functions alive there and their derivatives. */
typedef struct taut_bonnet_line {
    double t;
    int first, local;
    double *values; /* [TAUT_BONNET_ORDERS][local], the caller's */
} taut_bonnet_line;

void taut_bonnet_line_fill(const taut_basis *basis, int span, double t, taut_bonnet_line *line);

typedef struct taut_bonnet_sums {
    const taut_surface *surface;
    const taut_bonnet_scale *scale;
    const double *sizes;      /* [nu][nv] */
    double *rows, *row_sizes; /* of one line: [ORDERS][nv][3], [ORDERS][nv] */
    int columns;
} taut_bonnet_sums;

/* One point. */
typedef struct taut_bonnet_spot {
    double x[6][3];
    double noise[2]; /* of first and of second derivatives */
    taut_forms forms;
    double slope; /* noise[0] / |r_u| */
    double bend;  /* noise of L and N and of what multiplies them: noise[1] + (|L| + 2 |M| + |N|)
                     slope */
} taut_bonnet_spot;

/* Scratch from the arena. TAUT_NO_MEMORY. */
taut_status taut_bonnet_sums_init(const taut_surface *surface, const taut_bonnet_scale *scale,
                                  taut_arena *arena, taut_bonnet_sums *sums);
/* Takes a line u = const, columns from .. to - 1; then points on it that need no others. */
void taut_bonnet_sums_contract(taut_bonnet_sums *sums, const taut_bonnet_line *u, int from, int to);
void taut_bonnet_sums_at(const taut_bonnet_sums *sums, const taut_bonnet_line *v,
                         taut_bonnet_spot *spot);

#endif /* TAUT_CERTIFY_BONNET_SUMS_H */
