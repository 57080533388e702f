/* field.h -- polynomials in u, v on [0, 1]^2 by Bernstein coefficients that know their own errors.
 *
 *     f(u, v) = sum_ij a_ij B[p,i](u) B[q,j](v),      |a_ij - exact a_ij| <= e_ij
 *
 * where "exact" is what the operations would give in real numbers, from the doubles of the surface
 * (running error analysis, [Higham2002] section 3.3). A polynomial lies between its least and its
 * largest coefficient, so that taut_field_low and _high are proved bounds over the whole square.
 * A polynomial in one variable has q = 0.
 *
 * On c- and h- bases X, Y, Z are no polynomials; then
 *
 *     |f(u, v) - sum_ij a_ij B[p,i](u) B[q,j](v)| <= sum_ij e_ij B[p,i](u) B[q,j](v),
 *
 * and so are their derivatives of the first two orders by those of the polynomials, with the errors
 * that taut_field_du and _dv tell (certify/common/quasi.h). All operations keep that, but derivatives
 * of products are none: on these bases take the derivatives first.
 *
 * A field that could not be made, because memory ran out or because the degree is above
 * TAUT_FIELD_DEGREE, has a == NULL and makes fields that have a == NULL; their bounds are NaN, and
 * the arena's status, or that they are NULL, tells. A coefficient that left the range of doubles
 * makes the bounds NaN or infinite too: nothing is proved by them.
 */
#ifndef TAUT_CERTIFY_COMMON_FIELD_H
#define TAUT_CERTIFY_COMMON_FIELD_H

#include "core/arena.h"
#include "taut/curve.h"
#include "taut/surface.h"

enum { TAUT_FIELD_DEGREE = 256 };

typedef struct taut_field {
    int p, q;
    double *a, *e; /* [p + 1][q + 1] */
} taut_field;

/* All coefficients 0. */
taut_field taut_field_new(taut_arena *arena, int p, int q);
taut_field taut_field_constant(taut_arena *arena, double value);
taut_field taut_field_copy(taut_arena *arena, const taut_field *f);

/* f g of degree (p + p', q + q'); cost O(p q p' q'). */
taut_field taut_field_product(taut_arena *arena, const taut_field *f, const taut_field *g);
/* The same with one bound for all errors, by the largest coefficients: a third of the cost. */
taut_field taut_field_product_even(taut_arena *arena, const taut_field *f, const taut_field *g);
/* The same polynomial with degrees p + up, q + vp. */
taut_field taut_field_raise(taut_arena *arena, const taut_field *f, int up, int vp);
/* s f + t g, raised to the higher degrees. */
taut_field taut_field_combine(taut_arena *arena, double s, const taut_field *f, double t,
                              const taut_field *g);
taut_field taut_field_sum(taut_arena *arena, const taut_field *f, const taut_field *g);
taut_field taut_field_difference(taut_arena *arena, const taut_field *f, const taut_field *g);
/* df/du and df/dv over [0, 1]^2: divide by the widths of the piece for its own parameters. */
taut_field taut_field_du(taut_arena *arena, const taut_field *f);
taut_field taut_field_dv(taut_arena *arena, const taut_field *f);

/* f x g and f . g of vectors of three fields. */
void taut_field_cross(taut_arena *arena, const taut_field f[3], const taut_field g[3],
                      taut_field out[3]);
taut_field taut_field_dot(taut_arena *arena, const taut_field f[3], const taut_field g[3]);

/* The halves over u (direction 0) or v (1) at 1/2, each on [0, 1]^2. */
void taut_field_halve(taut_arena *arena, const taut_field *f, int direction, taut_field *low,
                      taut_field *high);
/* f on an edge: u0, u1 (polynomials in v) or v0, v1 (in u) for 0..3, as one with q = 0. */
taut_field taut_field_edge(taut_arena *arena, const taut_field *f, int edge);

/* min (a - e), max (a + e) and max (|a| + e), rounded outwards; NaN where f is not there. */
double taut_field_low(const taut_field *f);
double taut_field_high(const taut_field *f);
double taut_field_largest(const taut_field *f);
/* sum a_ij B(u) B(v), without its error: where to look, no proof. */
double taut_field_value(const taut_field *f, double u, double v);

/* Span (i, j) of a surface as X, Y, Z, w on [0, 1]^2: x = X / w, where points are moved by -origin
 * and scaled by 2^-exponent before. w is of degree (0, 0) and 1 for a surface without weights, as
 * those on c- and h- bases are. 0 where a basis is none of bezier, bspline, c- and h-, or one of the
 * latter with spans wider than 4: *out is untouched then.
 * widths[2], unless NULL: the widths of the span. */
int taut_field_of_surface(taut_arena *arena, const taut_surface *surface, int i, int j,
                          const double origin[3], int exponent, taut_field out[4],
                          double widths[2]);
/* Edge u0, u1, v0 or v1 (0..3) of it over a span of the other direction, with q = 0. */
int taut_field_of_edge(taut_arena *arena, const taut_surface *surface, int edge, int span,
                       const double origin[3], int exponent, taut_field out[4]);
/* Span i of a curve, in the same way, with q = 0. */
int taut_field_of_curve(taut_arena *arena, const taut_curve *curve, int i, const double origin[3],
                        int exponent, taut_field out[4], double *width);
/* Span (i, j) of a function with coefficients double[nu][nv]. */
int taut_field_of_net(taut_arena *arena, const taut_basis *u, const taut_basis *v,
                      const double *coefficients, int i, int j, taut_field *out, double widths[2]);

#endif /* TAUT_CERTIFY_COMMON_FIELD_H */
