/* quasi.c -- the c- and h- bases: {1, t, sin t, cos t}, 0 < alpha <= pi, and {1, t, sinh t, cosh t},
 * 0 < beta <= 700, on one segment or as uniform C^2 splines, not clamped, on any number of them.
 * [XuWang2006] sections 3 and 4; the formulas of a segment are in quasi_kernel.h. */
#include "basis/quasi.h"

#include "core/constants.h"
#include "core/fail.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <string.h>

static double alpha_of(const taut_basis_spec *spec)
{
    return spec->alpha;
}

static double beta_of(const taut_basis_spec *spec)
{
    return spec->beta;
}

static void set_alpha(taut_basis_spec *spec, double length)
{
    spec->alpha = length;
}

static void set_beta(taut_basis_spec *spec, double length)
{
    spec->beta = length;
}

static const taut_quasi_kind circular = {
    .kernel = &taut_quasi_circular,
    .length = alpha_of,
    .set_length = set_alpha,
    .where = "/alpha",
    .longest = TAUT_PI,
    .longest_bspline = 0,
    .bezier = "c-bezier",
    .bspline = "c-bspline",
};

static const taut_quasi_kind hyperbolic = {
    .kernel = &taut_quasi_hyperbolic,
    .length = beta_of,
    .set_length = set_beta,
    .where = "/beta",
    .longest = TAUT_QUASI_LONGEST,
    .longest_bspline = 1,
    .bezier = "h-bezier",
    .bspline = "h-bspline",
};

static taut_status check_length(const taut_quasi_kind *kind, double length, int bspline,
                                taut_error *error)
{
    const char *name = kind->where + 1;

    if (!(length >= TAUT_SPAN_MIN)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", kind->where, length, TAUT_SPAN_MIN,
                         "%s is %.17g, expected a positive number, at least %g", name, length,
                         TAUT_SPAN_MIN);
    }
    if (bspline && !kind->longest_bspline && length >= kind->longest) {
        return taut_fail(error, TAUT_NO_SOLUTION, "dependent", kind->where, length, kind->longest,
                         "%s is %.17g, but from pi on the functions of a %s are dependent: use "
                         "more segments, each at most 2.5, say",
                         name, length, kind->bspline);
    }
    if (length > kind->longest) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", kind->where, length, kind->longest,
                         "%s is %.17g, expected at most %.17g: cut it into shorter pieces", name,
                         length, kind->longest);
    }
    return TAUT_OK;
}

/* The range must be as long as the segments together, to the rounding of its own ends, and not so
 * far from zero that parameters could not be told apart within a segment. */
static taut_status check_range(const taut_basis_spec *spec, double length, int segments,
                               taut_error *error)
{
    const double width = spec->range[1] - spec->range[0];
    const double expected = length * segments;
    const double far = fmax(fabs(spec->range[0]), fabs(spec->range[1]));

    if (length < TAUT_QUASI_APART * far) {
        return taut_fail(error, TAUT_BAD_INPUT, "short-span", "/range", far,
                         length / TAUT_QUASI_APART,
                         "range [%.17g, %.17g] is too far from 0 for segments of length %.17g",
                         spec->range[0], spec->range[1], length);
    }
    if (!(fabs(width - expected) <= 2 * DBL_EPSILON * (far + expected))) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/range", width, expected,
                         "range [%.17g, %.17g] has length %.17g, expected %.17g", spec->range[0],
                         spec->range[1], width, expected);
    }
    return TAUT_OK;
}

static taut_status quasi_plan(const taut_basis_ops *ops, const taut_basis_spec *spec, int functions,
                              taut_basis_shape *shape, taut_error *error)
{
    const int bspline = (ops->needs & TAUT_MEMBER_SEGMENTS) != 0;
    const double length = ops->quasi->length(spec);
    const int segments = bspline ? spec->segments : 1;
    taut_status status = check_length(ops->quasi, length, bspline, error);

    (void)functions;
    if (status != TAUT_OK) {
        return status;
    }
    if (segments < 1 || segments > TAUT_COUNT_MAX - 3) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/segments", segments, TAUT_COUNT_MAX - 3,
                         "%d segments, expected 1 to %d", segments, TAUT_COUNT_MAX - 3);
    }
    if (spec->has_range) {
        status = check_range(spec, length, segments, error);
    }
    *shape =
        (taut_basis_shape){.count = segments + 3, .local = 4, .span_count = segments, .degree = -1};
    return status;
}

static void quasi_fill(taut_basis *basis)
{
    const taut_quasi_kind *kind = basis->ops->quasi;
    const double length = kind->length(&basis->spec);
    const int segments = basis->shape.span_count;
    taut_quasi_segment segment;

    if (!basis->spec.has_range) {
        basis->spec.range[0] = 0;
        basis->spec.range[1] = length * segments;
    }
    for (int i = 0; i < segments; i++) {
        basis->breaks[i] = basis->spec.range[0] + i * length;
        basis->first[i] = i;
    }
    basis->breaks[segments] = basis->spec.range[1];

    kind->kernel->prepare(length, &segment);
    assert(sizeof segment <= sizeof basis->data);
    memcpy(basis->data, &segment, sizeof segment);
}

taut_quasi_segment taut_quasi_segment_of(const taut_basis *basis)
{
    taut_quasi_segment segment;
    memcpy(&segment, basis->data, sizeof segment);
    return segment;
}

/* The local parameter x - y, x >= y the ends of a piece of a span; *rest is what rounding took off.
 * Where the span is not exactly as long as a segment (its ends are rounded), it is stretched. */
static double local_parameter(double x, double y, double width, double length, double *rest)
{
    const double difference = x - y;
    const double back = difference - x;

    *rest = 0;
    if (width != length) {
        return length * (difference / width);
    }
    *rest = (x - (difference - back)) - (y + back);
    return difference;
}

/* The kernel's half at t + rest, rest a rounding error: one term of Taylor's series. On a long
 * hyperbolic segment the functions grow by as much as that from one number to the next. The fourth
 * derivatives are the second ones, with the sign of the kernel. */
static void half_at(const taut_quasi_kernel *kernel, const taut_quasi_segment *segment, double t,
                    double rest, int order, double (*values)[2])
{
    const int last = TAUT_QUASI_ROWS - 1;
    double next[2] = {0, 0};

    kernel->half(segment, t, rest != 0 && order < last ? order + 1 : order, values);
    if (rest == 0) {
        return;
    }
    if (order == last) {
        next[0] = kernel->sign * values[2][0];
        next[1] = kernel->sign * values[2][1];
    } else {
        memcpy(next, values[order + 1], sizeof next);
    }
    for (int d = order; d >= 0; d--) {
        const double here[2] = {values[d][0], values[d][1]};
        values[d][0] += rest * next[0];
        values[d][1] += rest * next[1];
        memcpy(next, here, sizeof next);
    }
}

void taut_quasi_four(const taut_quasi_kernel *kernel, const taut_quasi_segment *segment, double lo,
                     double hi, double t, int order, double (*u)[4])
{
    double low[TAUT_QUASI_ROWS][2], high[TAUT_QUASI_ROWS][2];
    double rest = 0;
    double x = local_parameter(t, lo, hi - lo, segment->length, &rest);

    half_at(kernel, segment, x, rest, order, low);
    x = local_parameter(hi, t, hi - lo, segment->length, &rest);
    half_at(kernel, segment, x, rest, order, high);
    for (int d = 0; d <= order; d++) {
        const double sign = d % 2 == 0 ? 1 : -1;
        u[d][0] = sign * high[d][1];
        u[d][1] = sign * high[d][0];
        u[d][2] = low[d][0];
        u[d][3] = low[d][1];
    }
}

static void quasi_bezier_eval(const taut_basis *basis, int span, double t, int order,
                              double *values)
{
    const taut_quasi_segment segment = taut_quasi_segment_of(basis);
    double u[TAUT_QUASI_ROWS][4];

    taut_quasi_four(basis->ops->quasi->kernel, &segment, basis->breaks[span],
                    basis->breaks[span + 1], t, order, u);
    memcpy(values, u, 4 * sizeof(double) * ((size_t)order + 1));
}

/* With x = t/a along a segment of length a,
 *     N_0 = rho U_0,  N_1 = 1 - x - 2 N_0 + N_3,  N_2 = x + N_0 - 2 N_3,  N_3 = rho U_3,
 * the matrix of [XuWang2006] section 4 with its sine terms gathered by sin(a - t). */
static void quasi_bspline_eval(const taut_basis *basis, int span, double t, int order,
                               double *values)
{
    const taut_quasi_segment segment = taut_quasi_segment_of(basis);
    const double lo = basis->breaks[span], hi = basis->breaks[span + 1];
    double u[TAUT_QUASI_ROWS][4];

    taut_quasi_four(basis->ops->quasi->kernel, &segment, lo, hi, t, order, u);
    for (int d = 0; d <= order; d++) {
        const double n0 = segment.rho * u[d][0];
        const double n3 = segment.rho * u[d][3];
        values[4 * d] = n0;
        values[4 * d + 1] = n3 - 2 * n0;
        values[4 * d + 2] = n0 - 2 * n3;
        values[4 * d + 3] = n3;
    }
    values[1] += (hi - t) / (hi - lo);
    values[2] += (t - lo) / (hi - lo);
    if (order >= 1) {
        values[4 + 1] -= 1 / segment.length;
        values[4 + 2] += 1 / segment.length;
    }
}

/* 0, k, a - k, a ([XuWang2006] section 3). */
static void quasi_bezier_linear(const taut_basis *basis, double *t)
{
    const double k = taut_quasi_segment_of(basis).k;
    t[0] = basis->breaks[0];
    t[1] = basis->breaks[0] + k;
    t[2] = basis->breaks[1] - k;
    t[3] = basis->breaks[1];
}

/* The knots, and one more at either end (ibid. section 4). */
static void quasi_bspline_linear(const taut_basis *basis, double *t)
{
    const double length = taut_quasi_segment_of(basis).length;
    const int last = basis->shape.count - 1;
    for (int i = 1; i < last; i++) {
        t[i] = basis->breaks[i - 1];
    }
    t[0] = basis->breaks[0] - length;
    t[last] = basis->breaks[basis->shape.span_count] + length;
}

/*    identifier, name in documents, kind, form, members, layers of width 1 at the ends */
#define QUASI_LIST(X)                                                                              \
    X(c_bezier, "c-bezier", circular, bezier, TAUT_MEMBER_ALPHA, 0)                                \
    X(c_bspline, "c-bspline", circular, bspline, TAUT_MEMBER_ALPHA | TAUT_MEMBER_SEGMENTS, 0)      \
    X(h_bezier, "h-bezier", hyperbolic, bezier, TAUT_MEMBER_BETA, 1)                               \
    X(h_bspline, "h-bspline", hyperbolic, bspline, TAUT_MEMBER_BETA | TAUT_MEMBER_SEGMENTS, 1)

#define QUASI_OPS(identifier, name, kind, form, members, has_layers)                               \
    const taut_basis_ops taut_basis_##identifier = {                                               \
        .type = (name),                                                                            \
        .needs = (members),                                                                        \
        .allows = TAUT_MEMBER_RANGE,                                                               \
        .weights = 0,                                                                              \
        .layers = (has_layers),                                                                    \
        .plan = quasi_plan,                                                                        \
        .fill = quasi_fill,                                                                        \
        .eval = quasi_##form##_eval,                                                               \
        .linear = quasi_##form##_linear,                                                           \
        .changes = &taut_quasi_##form##_changes,                                                   \
        .quasi = &(kind),                                                                          \
    };
QUASI_LIST(QUASI_OPS)
#undef QUASI_OPS
