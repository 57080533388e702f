/* integrate.h -- integrals of functions of the derivative vectors over a surface.
 *
 * Cell by cell (span by span, so that nothing is asked to be smooth across a knot) by tensor Gauss
 * rules. In each cell the number of nodes is raised until two rules agree; where that is slow (the
 * normal vanishes, an absolute value has a kink) the cell is cut in four, those first that carry
 * the most error. Compensated sums in a fixed order: the result is the same for any number of
 * threads.
 *
 * Everything is brought to size 1 by powers of two, which round nothing: points by 2^-scale,
 * parameters by 2^-shift[0], 2^-shift[1]. Points are taken relative to one of the cell's own, so
 * that rounding is that of the cell, not of its distance from the origin.
 */
#ifndef TAUT_MEASURE_INTEGRATE_INTEGRATE_H
#define TAUT_MEASURE_INTEGRATE_INTEGRATE_H

#include "core/crew.h"
#include "taut/surface.h"

enum { TAUT_FIELDS_MAX = 22 };

/* What a cell's rounding is judged by: bounds of |x_u|, |x_v|, |x_uu|, |x_uv|, |x_vv| in the order
 * of the vectors, from the size of its net and the sums of |basis functions|; [TAUT_X] is the size
 * itself. */
typedef struct taut_bounds {
    double of[6];
    /* Of |x_u x x_v| over the product of their bounds, at most 1: coordinates are rounded each by
     * itself, and in a thin net along an axis no two that are multiplied are large. */
    double cross;
} taut_bounds;

/* The functions to be integrated, at `count` nodes: x[3*k + c][stride] is component c of vector k,
 * out[f][stride]. `ratio` is 2^(shift[1] - shift[0]), what |x_u| / |x_v| is to be multiplied by
 * to be that of the surface's own parameters. */
typedef void taut_fields(int count, int stride, const double *x, const taut_bounds *bounds,
                         double ratio, double *out);

/* When the integral of a field is good: error <= relative * |integral| + floor * |integral of its
 * reference|. The reference, the odd field that follows it, is what the rounding of the integrand
 * is proportional to. Single cells are judged against a tenth of `relative`. INFINITY: not judged, as good as the
 * others make it. */
typedef struct taut_goal {
    double relative, floor;
} taut_goal;

typedef struct taut_integrand {
    taut_fields *fields;
    int count; /* pairs of field and reference: out[2*f], out[2*f + 1] */
    int order; /* 1 or 2, of the derivatives that are wanted */
    int exact; /* nonzero: squares of derivatives of polynomials, which the first rule integrates */
    const taut_goal *goals; /* [count] */
    /* 0; or 1: the field of the first pair is W = |x_u x x_v|, and that vector's components follow
     * the pairs; or 2: besides, the field of the last pair is |s|, and s follows. Absolute values
     * have kinks where their argument is 0, which nodes resolve badly or miss. */
    int kinks;
    int is_first; /* nonzero: the fields are those of eight.h, which may make them its own way */
} taut_integrand;

typedef struct taut_integrals {
    double value[TAUT_FIELDS_MAX]; /* [2*count], of scaled points and parameters */
    double error[TAUT_FIELDS_MAX]; /* estimates */
    int scale, shift[2];
} taut_integrals;

/* All NaN where weights are further apart than TAUT_SPREAD_MAX (geometry/nurbs/spread.h). TAUT_NO_MEMORY,
 * TAUT_INTERRUPTED. */
taut_status taut_integrate(const taut_surface *surface, const taut_integrand *integrand,
                           const taut_crew *crew, taut_integrals *integrals);

#endif /* TAUT_MEASURE_INTEGRATE_INTEGRATE_H */
