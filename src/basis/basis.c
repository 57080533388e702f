/* basis.c -- what all bases share: making, copying, finding spans. */
#include "taut/basis.h"

#include "basis/basis_ops.h"
#include "core/fail.h"
#include "core/memory.h"

#include <assert.h>
#include <math.h>
#include <string.h>

static const taut_basis_ops *const ops_table[] = {
#define TAUT_BASIS_ROW(identifier, name) &taut_basis_##identifier,
    TAUT_BASIS_LIST(TAUT_BASIS_ROW)
#undef TAUT_BASIS_ROW
};
enum { OPS_COUNT = (int)(sizeof ops_table / sizeof ops_table[0]) };

const taut_basis_ops *taut_basis_ops_at(int i)
{
    return i >= 0 && i < OPS_COUNT ? ops_table[i] : NULL;
}

const taut_basis_ops *taut_basis_ops_find(const char *type)
{
    for (int i = 0; type != NULL && i < OPS_COUNT; i++) {
        if (strcmp(ops_table[i]->type, type) == 0) {
            return ops_table[i];
        }
    }
    return NULL;
}

/* The members a spec gives, as bits; one that is 0 cannot be told from one left out. */
static unsigned members_given(const taut_basis_spec *spec)
{
    return (spec->degree != 0 ? (unsigned)TAUT_MEMBER_DEGREE : 0U) |
           (spec->count != 0 ? (unsigned)TAUT_MEMBER_COUNT : 0U) |
           (spec->knots != NULL ? (unsigned)TAUT_MEMBER_KNOTS : 0U) |
           (spec->alpha != 0 ? (unsigned)TAUT_MEMBER_ALPHA : 0U) |
           (spec->beta != 0 ? (unsigned)TAUT_MEMBER_BETA : 0U) |
           (spec->gamma != 0 ? (unsigned)TAUT_MEMBER_GAMMA : 0U) |
           (spec->segments != 0 ? (unsigned)TAUT_MEMBER_SEGMENTS : 0U) |
           (spec->has_range ? (unsigned)TAUT_MEMBER_RANGE : 0U);
}

/* What every type asks of its spec. */
static taut_status check_spec(const taut_basis_ops *ops, const taut_basis_spec *spec,
                              taut_error *error)
{
    const double numbers[] = {spec->alpha, spec->beta, spec->gamma, spec->range[0], spec->range[1]};
    static const char *const names[] = {"/alpha", "/beta", "/gamma", "/range/0", "/range/1"};

    for (int i = 0; i < 5; i++) {
        if (!isfinite(numbers[i])) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", names[i], numbers[i], taut_none,
                             "a number is not finite");
        }
    }
    if ((members_given(spec) & ~(ops->needs | ops->allows)) != 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "unknown-member", "", taut_none, taut_none,
                         "a basis of type \"%s\" was given a member it does not have", ops->type);
    }
    if (((ops->needs | ops->allows) & TAUT_MEMBER_DEGREE) != 0 &&
        (spec->degree < 1 || spec->degree > TAUT_DEGREE_MAX)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/degree", spec->degree, TAUT_DEGREE_MAX,
                         "degree is %d, expected 1 to %d", spec->degree, TAUT_DEGREE_MAX);
    }
    if (spec->has_range &&
        !(spec->range[0] < spec->range[1] && isfinite(spec->range[1] - spec->range[0]))) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/range", spec->range[1] - spec->range[0],
                         0, "range is [%.17g, %.17g], expected two increasing numbers",
                         spec->range[0], spec->range[1]);
    }
    return TAUT_OK;
}

/* Takes memory for a basis of this shape; NULL when there is none. */
static taut_basis *basis_alloc(const taut_basis_ops *ops, const taut_basis_spec *spec,
                               const taut_basis_shape *shape)
{
    taut_basis *basis = taut_alloc_zero(1, sizeof *basis);
    if (basis == NULL) {
        return NULL;
    }
    basis->ops = ops;
    basis->spec = *spec;
    basis->spec.type = ops->type;
    basis->spec.knots = NULL;
    basis->shape = *shape;
    basis->breaks = taut_alloc_zero((size_t)shape->span_count + 1, sizeof(double));
    basis->first = taut_alloc_zero((size_t)shape->span_count, sizeof(int));
    basis->knot_span = taut_alloc_zero((size_t)shape->span_count, sizeof(int));
    basis->knots = taut_alloc_zero((size_t)shape->knot_count, sizeof(double));
    if (basis->breaks == NULL || basis->first == NULL || basis->knot_span == NULL ||
        basis->knots == NULL) {
        taut_basis_free(basis);
        return NULL;
    }
    return basis;
}

/* Are the breaks such that nothing built on them overflows? */
static taut_status check_breaks(const taut_basis *basis, taut_error *error)
{
    const char *where = basis->shape.knot_count > 0 ? "/knots"
                        : basis->spec.has_range     ? "/range"
                                                    : "";
    for (int i = 0; i <= basis->shape.span_count; i++) {
        const double now = basis->breaks[i];
        if (!(fabs(now) <= TAUT_PARAMETER_MAX)) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", where, now, TAUT_PARAMETER_MAX,
                             "parameter %.17g, expected at most %g in absolute value", now,
                             TAUT_PARAMETER_MAX);
        }
        if (i > 0 && !(now - basis->breaks[i - 1] >= TAUT_SPAN_MIN)) {
            return taut_fail(error, TAUT_BAD_INPUT, "short-span", where, now - basis->breaks[i - 1],
                             TAUT_SPAN_MIN, "the span from %.17g to %.17g is narrower than %g",
                             basis->breaks[i - 1], now, TAUT_SPAN_MIN);
        }
    }
    return TAUT_OK;
}

static taut_status fail_count(int count, taut_error *error)
{
    return taut_fail(error, TAUT_BAD_INPUT, "size", "", count, TAUT_COUNT_MAX,
                     "a basis of %d functions, expected at most %d", count, TAUT_COUNT_MAX);
}

taut_status taut_basis_new(const taut_basis_spec *spec, int functions, taut_basis **basis,
                           taut_error *error)
{
    const taut_basis_ops *ops = NULL;
    taut_basis_shape shape = {0, 0, 0, 0, -1};
    taut_basis *made = NULL;
    taut_status status = TAUT_OK;

    if (spec == NULL || basis == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a basis needs a spec and a place to go");
    }
    ops = taut_basis_ops_find(spec->type);
    if (ops == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "name", "/type", taut_none, taut_none,
                         "there is no basis of type \"%.40s\"",
                         spec->type != NULL ? spec->type : "");
    }
    if (functions > TAUT_COUNT_MAX) {
        return fail_count(functions, error);
    }
    status = check_spec(ops, spec, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = ops->plan(ops, spec, functions, &shape, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (shape.count > TAUT_COUNT_MAX) {
        return fail_count(shape.count, error);
    }
    made = basis_alloc(ops, spec, &shape);
    if (made == NULL) {
        return taut_fail_memory(error);
    }
    if (shape.knot_count > 0) {
        made->spec.knots = spec->knots; /* read by fill, then replaced by our own */
    }
    ops->fill(made);
    made->spec.knots = shape.knot_count > 0 ? made->knots : NULL;
    made->spec.knot_count = shape.knot_count;
    status = check_breaks(made, error);
    if (status != TAUT_OK) {
        taut_basis_free(made);
        return status;
    }
    *basis = made;
    return TAUT_OK;
}

taut_status taut_basis_copy(const taut_basis *basis, taut_basis **copy)
{
    taut_basis *made = NULL;
    if (basis == NULL || copy == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    made = basis_alloc(basis->ops, &basis->spec, &basis->shape);
    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    const size_t spans = (size_t)basis->shape.span_count;
    memcpy(made->breaks, basis->breaks, (spans + 1) * sizeof(double));
    memcpy(made->first, basis->first, spans * sizeof(int));
    memcpy(made->knot_span, basis->knot_span, spans * sizeof(int));
    memcpy(made->knots, basis->knots, (size_t)basis->shape.knot_count * sizeof(double));
    memcpy(made->data, basis->data, sizeof made->data);
    made->spec.knots = basis->spec.knots != NULL ? made->knots : NULL;
    *copy = made;
    return TAUT_OK;
}

void taut_basis_free(taut_basis *basis)
{
    if (basis != NULL) {
        taut_free(basis->breaks);
        taut_free(basis->first);
        taut_free(basis->knot_span);
        taut_free(basis->knots);
        taut_free(basis);
    }
}

void taut_basis_spec_of(const taut_basis *basis, taut_basis_spec *spec)
{
    *spec = basis->spec;
}

int taut_basis_equal(const taut_basis *a, const taut_basis *b)
{
    const size_t knots = (size_t)a->shape.knot_count;
    return a->ops == b->ops && a->spec.degree == b->spec.degree &&
           a->shape.count == b->shape.count && a->shape.span_count == b->shape.span_count &&
           a->shape.knot_count == b->shape.knot_count && a->spec.alpha == b->spec.alpha &&
           a->spec.beta == b->spec.beta && a->spec.gamma == b->spec.gamma &&
           taut_basis_lo(a) == taut_basis_lo(b) && taut_basis_hi(a) == taut_basis_hi(b) &&
           memcmp(a->knots, b->knots, knots * sizeof(double)) == 0;
}

const char *taut_basis_type(const taut_basis *basis)
{
    return basis->ops->type;
}

int taut_basis_count(const taut_basis *basis)
{
    return basis->shape.count;
}

int taut_basis_local(const taut_basis *basis)
{
    return basis->shape.local;
}

int taut_basis_span_count(const taut_basis *basis)
{
    return basis->shape.span_count;
}

const double *taut_basis_breaks(const taut_basis *basis)
{
    return basis->breaks;
}

double taut_basis_lo(const taut_basis *basis)
{
    return basis->breaks[0];
}

double taut_basis_hi(const taut_basis *basis)
{
    return basis->breaks[basis->shape.span_count];
}

int taut_basis_degree(const taut_basis *basis)
{
    return basis->shape.degree;
}

int taut_basis_allows_weights(const taut_basis *basis)
{
    return basis->ops->weights;
}

int taut_basis_span(const taut_basis *basis, double t)
{
    int low = 0;
    int high = basis->shape.span_count; /* breaks[low] <= t < breaks[high], or at an end */
    const double *breaks = basis->breaks, lo = breaks[0], hi = breaks[high];
    if (t > lo && t < hi) { /* even breaks are no search */
        const int even = (int)((t - lo) / (hi - lo) * high);
        if (even < high && t >= breaks[even] && t < breaks[even + 1]) {
            return even;
        }
    }
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (t >= basis->breaks[middle]) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

int taut_basis_first(const taut_basis *basis, int span)
{
    return basis->first[span];
}

taut_status taut_basis_eval(const taut_basis *basis, int span, double t, int order, double *values)
{
    if (basis == NULL || values == NULL || order < 0 || order > TAUT_ORDER_MAX || span < 0 ||
        span >= basis->shape.span_count ||
        !(t >= basis->breaks[span] && t <= basis->breaks[span + 1])) {
        return TAUT_BAD_ARGUMENT;
    }
    basis->ops->eval(basis, span, t, order, values);
    return TAUT_OK;
}

void taut_basis_eval_beside(const taut_basis *basis, int span, double t, double rest, int order,
                            double *values)
{
    assert(t >= basis->breaks[span] && t <= basis->breaks[span + 1]);
    if (basis->ops->eval_beside != NULL) {
        basis->ops->eval_beside(basis, span, t, rest, order, values);
    } else {
        basis->ops->eval(basis, span, t, order, values);
    }
}
