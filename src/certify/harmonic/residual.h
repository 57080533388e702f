/* residual.h -- is a Bezier net harmonic over its own rectangle? */
#ifndef TAUT_CERTIFY_HARMONIC_RESIDUAL_H
#define TAUT_CERTIFY_HARMONIC_RESIDUAL_H

#include "core/twice.h"
#include "taut/join.h"
#include "taut/surface.h"

#include <stddef.h>

typedef struct taut_harmonic_residual {
    double largest; /* max |R_ij|, the control points of x_uu + x_vv in the parameters of the
                       rectangle */
    double scaled;  /* rho = largest / (max(n^2/a^2, m^2/b^2) S), S the size about the mean point; 0
                       where S is */
    double size;    /* S */
    double reach;   /* the largest coordinate over S, at least 1 */
    int i, j;       /* where */
} taut_harmonic_residual;

/* By relation (2) of [NiWang2015] section 2.2 with weights 1/a^2, 1/b^2, a and b the widths of the
 * ranges as doubles, in twice the precision: of the points as they are stored, nothing is lost. A
 * polynomial is nowhere larger than its largest control point, so that |x_uu + x_vv|, each
 * coordinate, is at most `largest` on the whole rectangle. `square` nonzero: with weights 1, as over the unit square. Bezier bases without weights.
 */
taut_harmonic_residual taut_harmonic_residual_of(const taut_surface *surface, int square);

/* 1/a^2 and 1/b^2 over the larger of them, to twice the precision: a and b are doubles. */
void taut_certify_laplacian_weights(double a, double b, taut_twice w[2]);

/* The control points of w[0] x_uu + w[1] x_vv, in the bidegree of the net [n+1][m+1][3], by
 * relation (2). Not in place. */
void taut_certify_laplacian(int n, int m, const taut_twice w[2], const taut_twice *net,
                            taut_twice *laplacian);

/* Half the largest extent of double[count][3], and the largest coordinate, of points where `known`
 * (NULL: all). */
double taut_certify_extent(const double *points, const unsigned char *known, size_t count,
                           double *reach);

/* The edge of p beyond which q lies, by their ranges; v0 where none is shared. */
taut_edge taut_certify_shared_edge(const taut_surface *p, const taut_surface *q);

#endif /* TAUT_CERTIFY_HARMONIC_RESIDUAL_H */
