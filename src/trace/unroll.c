/* unroll.c
 *
 *     of each segment the pattern's curvature and the stretch as sums of Legendre polynomials P_n(x),
 *     x = 2 t - 1, through the NODES of Gauss's rule; the angle is the sum's integral,
 *         int_-1^x P_n = (P_{n+1}(x) - P_{n-1}(x)) / (2 n + 1)       ([DLMF] 18.9.19)
 *     cut, x, y up to t by the rule again, of these sums
 */
#include "trace/unroll.h"

#include "core/elementary/elementary.h"
#include "numeric/quadrature.h"

#include <math.h>

enum { NODES = 16, PLANE_NODES = 8, TERMS = 22 };
/* From this y on mu - 1 by its closed form loses no more than a digit. */
static const double closed_form = 0.5;

struct taut_unrolled_segment {
    double length;
    double turn[NODES], stretch[NODES], edge[NODES]; /* coefficients of P_n, per length */
    taut_unrolled_point from;
    taut_unrolled_point to;
};

/* Rules on [-1, 1], and the matrix from values at the nodes to coefficients. */
typedef struct rules {
    double nodes[NODES], weights[NODES];
    double fit[NODES][NODES]; /* [term][node]: (2 n + 1) / 2 w_k P_n(x_k) */
} rules;

/* P_0 .. P_count at x. */
static void legendre(int count, double x, double *p)
{
    p[0] = 1;
    p[1] = x;
    for (int n = 1; n < count; n++) {
        p[n + 1] = ((2 * n + 1) * x * p[n] - n * p[n - 1]) / (n + 1);
    }
}

static void make_rules(rules *r)
{
    taut_gauss_rule(NODES, r->nodes, r->weights);
    for (int k = 0; k < NODES; k++) {
        double p[NODES + 1];
        legendre(NODES, r->nodes[k], p);
        for (int n = 0; n < NODES; n++) {
            r->fit[n][k] = (2 * n + 1) / 2.0 * r->weights[k] * p[n];
        }
    }
}

static void fit(const rules *r, const double *values, double *coefficients)
{
    for (int n = 0; n < NODES; n++) {
        double sum = 0;
        for (int k = 0; k < NODES; k++) {
            sum += r->fit[n][k] * values[k];
        }
        coefficients[n] = sum;
    }
}

/* Half the integral from -1 to x, of t therefore, of a sum whose P_0 .. P_NODES at x are p. */
static double integral_of(const double *coefficients, const double *p)
{
    double sum = coefficients[0] * (p[1] + 1);
    for (int n = 1; n < NODES; n++) {
        sum += coefficients[n] * (p[n + 1] - p[n - 1]) / (2 * n + 1);
    }
    return sum / 2;
}

/* mu - 1 = sum_n C(1/2, n) y^(2n) / (2n + 1). */
static double mean_stretch(double y)
{
    const double square = y * y;
    if (y > closed_form) {
        const double root = sqrt(1 + square);
        return (root + taut_log(y + root) / y) / 2 - 1;
    }
    double power = 1, sum = 0, binomial = 1;
    for (int n = 1; n <= TERMS; n++) {
        binomial *= (1.5 - n) / n;
        power *= square;
        sum += binomial * power / (2 * n + 1);
    }
    return sum;
}

static void fit_segment(const taut_unroll_rule *rule, const rules *r, taut_linefield_kind kind,
                        const taut_segment *on, taut_unrolled_segment *made)
{
    double turn[NODES] = {0}, stretch[NODES] = {0}, edge[NODES] = {0};
    made->length = on->to.s - on->from.s;
    for (int k = 0; k < NODES && (rule->flat >= 0 || rule->width > 0); k++) {
        const taut_lath_bending b = taut_lath_bending_at(kind, on, (1 + r->nodes[k]) / 2);
        const double y = rule->width * fabs(b.value[TAUT_TAU_G]) / 2;
        turn[k] = rule->flat >= 0 ? b.value[rule->flat] : 0;
        stretch[k] = mean_stretch(y);
        edge[k] = y * y / (1 + sqrt(1 + y * y));
    }
    fit(r, turn, made->turn);
    fit(r, stretch, made->stretch);
    fit(r, edge, made->edge);
}

/* What lies between the beginning of a segment and t. */
static taut_unrolled_point point_at(const taut_unrolled *all, const taut_unrolled_segment *on,
                                    double t)
{
    const taut_unroll_rule *rule = &all->rule;
    double p[NODES + 1];
    taut_unrolled_point at = on->from;

    legendre(NODES, 2 * t - 1, p);
    const double stretch = integral_of(on->stretch, p) * on->length;
    at.edge += integral_of(on->edge, p) * on->length;
    at.stretch += stretch;
    at.cut += t * on->length + (rule->is_stretched ? stretch : 0);
    at.theta += integral_of(on->turn, p) * on->length;
    if (rule->flat < 0) {
        at.x = at.cut;
        return at;
    }
    for (int k = 0; k < PLANE_NODES; k++) {
        const double here = t * (1 + all->nodes[k]) / 2;
        double more = 1;
        legendre(NODES, 2 * here - 1, p);
        for (int n = 0; n < NODES && rule->is_stretched; n++) {
            more += on->stretch[n] * p[n];
        }
        const double angle = on->from.theta + integral_of(on->turn, p) * on->length;
        const double ds = all->weights[k] / 2 * t * on->length * more;
        at.x += taut_cos(angle) * ds;
        at.y += taut_sin(angle) * ds;
    }
    return at;
}

taut_status taut_unroll(taut_arena *arena, taut_linefield_kind kind, const taut_lath *lath,
                        const taut_unroll_rule *rule, taut_unrolled *unrolled)
{
    double *nodes = taut_arena_take(arena, 2 * PLANE_NODES, sizeof *nodes);
    taut_unrolled_segment *segments =
        taut_arena_take(arena, (size_t)lath->count + 1, sizeof *segments);
    rules r;

    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    *unrolled = (taut_unrolled){*rule, segments, nodes, nodes + PLANE_NODES};
    make_rules(&r);
    taut_gauss_rule(PLANE_NODES, nodes, nodes + PLANE_NODES);
    for (int k = 0; k < lath->count; k++) {
        taut_unrolled_segment *on = &segments[k];
        fit_segment(rule, &r, kind, &lath->segments[k], on);
        on->from = k > 0 ? on[-1].to : (taut_unrolled_point){0};
        on->to = point_at(unrolled, on, 1);
    }
    return TAUT_OK;
}

taut_unrolled_point taut_unrolled_at(const taut_unrolled *unrolled, int segment, double t)
{
    const taut_unrolled_segment *on = &unrolled->segments[segment];
    return t == 0 ? on->from : t == 1 ? on->to : point_at(unrolled, on, t);
}
