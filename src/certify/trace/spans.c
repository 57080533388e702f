#include "certify/trace/spans.h"

#include "basis/basis_ops.h"

#include <math.h>
#include <string.h>

enum { QUINTIC = TAUT_NET_QUINTIC };

int taut_net_line_is_quintic(const taut_net_line *line)
{
    const taut_basis *space = taut_curve_t(line->space);
    int are = line->count > 0 && strcmp(taut_basis_type(space), "bspline") == 0 &&
              taut_basis_local(space) == QUINTIC + 1 && taut_curve_weights(line->space) == NULL;
    for (int k = 0; are && k < line->count; k++) { /* certify/common/of.h: B-splines of degree 5 */
        are = taut_basis_local(taut_curve_t(line->window[k])) == QUINTIC + 1;
    }
    return are;
}

/* The span of a basis from one break to the next, or -1. */
static int span_between(const taut_basis *basis, double from, double to)
{
    const double *breaks = taut_basis_breaks(basis);
    const int span = taut_basis_span(basis, from);
    return breaks[span] == from && breaks[span + 1] == to ? span : -1;
}

/* One level of de Boor's scheme. */
static inline void blend(int level, const double *share, const double *rest,
                         double work[QUINTIC + 1][3])
{
    for (int k = 0; k <= QUINTIC - level; k++) {
        for (int c = 0; c < 3; c++) {
            work[k][c] = rest[k] * work[k][c] + share[k] * work[k + 1][c];
        }
    }
}

/* The Bernstein coefficients of a span, [6][3]: the blossom at so many times its ends ([PieglTiller1997] 5.2). */
static void bezier_of(const taut_curve *curve, int span, double from, double to,
                      double points[QUINTIC + 1][3])
{
    const taut_basis *basis = taut_curve_t(curve);
    const int first = taut_basis_first(basis, span);
    const double *knots = basis->knots + first;
    const double ends[2] = {from, to};
    double shares[2][QUINTIC + 1][QUINTIC], rests[2][QUINTIC + 1][QUINTIC];
    double begun[QUINTIC + 1][3];

    for (int level = 1; level <= QUINTIC; level++) {
        for (int k = 0; k <= QUINTIC - level; k++) {
            const double low = knots[k + level], high = knots[k + QUINTIC + 1];
            for (int end = 0; end < 2; end++) {
                shares[end][level][k] = (ends[end] - low) / (high - low);
                rests[end][level][k] = (high - ends[end]) / (high - low);
            }
        }
    }
    memcpy(begun, taut_curve_points(curve) + 3 * first, sizeof begun);
    for (int i = 0; i <= QUINTIC;
         i++) { /* the first i levels at the span's end, the others at its beginning */
        double work[QUINTIC + 1][3];
        if (i > 0) {
            blend(i, shares[1][i], rests[1][i], begun);
        }
        memcpy(work, begun, sizeof work);
        for (int level = i + 1; level <= QUINTIC; level++) {
            blend(level, shares[0][level], rests[0][level], work);
        }
        memcpy(points[i], work[0], sizeof work[0]);
    }
}

int taut_net_span_of(const taut_net_line *line, int i, int unit, taut_net_span *span)
{
    const double *breaks = taut_basis_breaks(taut_curve_t(line->space)) + i;
    const double scale = ldexp(1, -unit);
    double window[QUINTIC + 1][3];
    int there = -1;

    *span = (taut_net_span){.from = breaks[0], .to = breaks[1]};
    for (int k = 0; there < 0 && k < line->count; k++) {
        const taut_basis *basis = taut_curve_t(line->window[k]);
        if (breaks[0] >= taut_basis_lo(basis) && breaks[1] <= taut_basis_hi(basis)) {
            there = span_between(basis, breaks[0], breaks[1]);
            if (there < 0) {
                return 0;
            }
            bezier_of(line->window[k], there, breaks[0], breaks[1], window);
            span->on = line->on[k];
        }
    }
    if (there < 0) {
        return 0;
    }
    bezier_of(line->space, i, breaks[0], breaks[1], span->space);
    for (int k = 0; k <= QUINTIC; k++) {
        memcpy(span->window[k], window[k], sizeof span->window[k]);
        for (int c = 0; c < 3; c++) {
            span->space[k][c] *= scale;
        }
    }
    return 1;
}
