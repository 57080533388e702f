/* taut/basis.h -- one-directional function bases: Bezier, B-spline and their relatives.
 *
 * A basis is a list of `count` functions on a parameter range [lo, hi] that is cut into spans.
 * On each span `local` consecutive functions are alive, and they sum to 1. A curve is
 * sum_i P_i N_i(t), a surface sum_ij P_ij N_i(u) N_j(v). Every basis has this shape, so all that
 * is built on top (evaluation, quadrature, energies) is written once.
 *
 *     type         functions                                     natural range
 *     "bezier"     Bernstein polynomials of one degree           [0, 1]
 *     "bspline"    clamped B-splines, any legal knots            the knots' own
 *     "c-bezier"   4 over {1, t, sin t, cos t}, 0 < alpha <= pi   [0, alpha]
 *     "c-bspline"  the same, C^2 and uniform, 0 < alpha < pi      [0, segments alpha]
 *     "h-bezier"   4 over {1, t, sinh t, cosh t}, 0 < beta        [0, beta]
 *     "h-bspline"  the same, C^2 and uniform, 0 < beta            [0, segments beta]
 *     "ce-bezier"  4 quartic polynomials with three shape numbers [0, 1]
 *
 * src/basis/basis_list.h names all; docs/format.md gives the members of each.
 *
 * Lengths alpha and beta are at least TAUT_SPAN_MIN, beta at most 700 (cosh must not overflow); the
 * shape numbers of a ce-bezier are at most 1000 in size, those outside its legal box included.
 *
 * Accuracy of the c-, h- and ce- bases, t in the closed range: each value and derivative within
 * 1e-14 of the largest of its order there (c-bspline: on that span; ce-bezier: the largest shape
 * number times that), t taken as exact to a rounding error of the ends of its range.
 *
 * Sources: [WuWang2011] sections 2.1-2.2 (knots, recursion), [PieglTiller1997] A2.2-A2.3;
 * [XuWang2006] sections 3-4 (c-, h-), [WangBai2018] section 2 (ce-).
 */
#ifndef TAUT_BASIS_H
#define TAUT_BASIS_H

#include "taut/limits.h"
#include "taut/status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { TAUT_ORDER_MAX = 3 }; /* highest derivative any evaluation gives */

/* Immutable; every call on a const one is safe from any thread. */
typedef struct taut_basis taut_basis;

/* What a basis is made from, the members of its document. Zero-initialise, then fill what the
 * type needs; a member the type does not know must be left zero. */
typedef struct taut_basis_spec {
    const char *type;
    int degree;     /* bezier, bspline: 1..TAUT_DEGREE_MAX */
    int count;      /* bspline without knots: number of functions, uniform on [0, 1] */
    int knot_count; /* bspline: count+degree+1, or count+degree-1 with the outermost two dropped */
    const double *knots; /* bspline: double[knot_count], non-decreasing, clamped */
    double alpha;        /* c-bezier, c-bspline: length of a segment; ce-bezier: shape */
    double beta;         /* h-bezier, h-bspline: length of a segment; ce-bezier: shape */
    double gamma;        /* ce-bezier: shape */
    int segments;        /* c-bspline, h-bspline: number of segments */
    int has_range;       /* nonzero: `range` replaces the natural range */
    double range[2];
} taut_basis_spec;

/* What can be wrong with a basis, or with a change of it, besides what is of any document
 * (TAUT_DOCUMENT_REASON_LIST in taut/read.h): word, meaning, remedy. */
#define TAUT_BASIS_REASON_LIST(X)                                                                  \
    X("knots", "the knots decrease, are not clamped, or repeat more often than the degree allows", \
      "give knots that do not decrease, the ends degree + 1 times, inner ones at most degree")     \
    X("short-span", "a span is, or would become, too short for its parameters or its slopes",      \
      "take breaks, or a cut, further apart")                                                      \
    X("dependent", "a c-bspline of segments of pi or longer has dependent functions",              \
      "use more segments, each at most 2.5, say")

/* Makes a basis. `functions` is the number of control points it must serve, or 0 if not known yet;
 * a bspline needs it to tell the two knot forms apart (0 takes the full form).
 * TAUT_BAD_INPUT: the spec is illegal; error->where is the member, such as "/knots/3", "" where it
 * is the spec as a whole. TAUT_NO_SOLUTION: alpha so large that the functions are dependent.
 * TAUT_NO_MEMORY. The caller owns *basis. */
TAUT_API taut_status taut_basis_new(const taut_basis_spec *spec, int functions, taut_basis **basis,
                                    taut_error *error);
/* A deep copy, the caller's. TAUT_NO_MEMORY. */
TAUT_API taut_status taut_basis_copy(const taut_basis *basis, taut_basis **copy);
TAUT_API void taut_basis_free(taut_basis *basis); /* NULL is fine */

/* The spec that makes this basis again, in full form; spec->knots is borrowed from the basis. */
TAUT_API void taut_basis_spec_of(const taut_basis *basis, taut_basis_spec *spec);
/* Nonzero: both are the same basis over the same range, bit for bit. */
TAUT_API int taut_basis_equal(const taut_basis *a, const taut_basis *b);

TAUT_API const char *taut_basis_type(const taut_basis *basis); /* such as "bezier"; borrowed */
TAUT_API int taut_basis_count(const taut_basis *basis);        /* functions */
TAUT_API int taut_basis_local(const taut_basis *basis);        /* functions alive on one span */
TAUT_API int taut_basis_span_count(const taut_basis *basis);   /* non-empty spans */
/* double[span_count + 1], strictly increasing; the ends are the range. Borrowed. */
TAUT_API const double *taut_basis_breaks(const taut_basis *basis);
/* The ends of the range. */
TAUT_API double taut_basis_lo(const taut_basis *basis);
TAUT_API double taut_basis_hi(const taut_basis *basis);
/* Polynomial degree on each span, or -1 where the functions are not polynomials. */
TAUT_API int taut_basis_degree(const taut_basis *basis);
/* Nonzero where curves and surfaces on this basis may carry rational weights. */
TAUT_API int taut_basis_allows_weights(const taut_basis *basis);

/* The span that holds t: the one on the right at an inner break, the last one at the upper end.
 * t outside the range takes the first or last span. */
TAUT_API int taut_basis_span(const taut_basis *basis, double t);
/* Index of the first function alive on a span, 0 .. span_count-1. */
TAUT_API int taut_basis_first(const taut_basis *basis, int span);

/* The functions alive on a span, and their derivatives:
 *     values[k][a] = d^k/dt^k N[first+a](t),   k = 0..order, a = 0..local-1
 * t       finite, in the closed span (derivatives are one-sided at its ends)
 * order   0..TAUT_ORDER_MAX
 * values  double[order+1][local], the caller's
 * Cost: O(order local^2) flops, no allocation, safe from any thread.
 * Returns TAUT_OK or TAUT_BAD_ARGUMENT (NULL, order, span or t out of range: nothing written). */
TAUT_API taut_status taut_basis_eval(const taut_basis *basis, int span, double t, int order,
                                     double *values);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_BASIS_H */
