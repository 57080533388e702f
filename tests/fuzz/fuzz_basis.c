/* fuzz_basis.c -- bases out of arbitrary specs, and every call on those that are made.
 *
 * The input is a spec in fixed places, then its knots. What holds for every legal
 * basis is checked: values are finite and sum to 1.
 */
#include "basis/basis_ops.h"
#include "taut/basis.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

typedef struct input {
    const uint8_t *data;
    size_t size;
} input;

static void take(input *in, void *to, size_t size)
{
    const size_t n = in->size < size ? in->size : size;
    memset(to, 0, size);
    memcpy(to, in->data, n);
    in->data += n;
    in->size -= n;
}

static int take_small(input *in)
{
    int8_t value = 0;
    take(in, &value, sizeof value);
    return value;
}

static int take_int(input *in)
{
    int32_t value = 0;
    take(in, &value, sizeof value);
    return value;
}

static double take_double(input *in)
{
    double value = 0;
    take(in, &value, sizeof value);
    return value;
}

/* Values in a span sum to 1; the bound is loose, as extreme knots cost digits. */
static void use(const taut_basis *basis)
{
    static double values[(TAUT_ORDER_MAX + 1) * (TAUT_DEGREE_MAX + 1)];
    const int spans = taut_basis_span_count(basis);
    const int local = taut_basis_local(basis);
    for (int i = 0; i < 8; i++) {
        const int span = spans * i / 8;
        const double *breaks = taut_basis_breaks(basis);
        const double t = breaks[span] / 2 + breaks[span + 1] / 2;
        double sum = 0;
        if (taut_basis_eval(basis, span, t, TAUT_ORDER_MAX, values) != TAUT_OK) {
            abort();
        }
        for (int a = 0; a < local; a++) {
            sum += values[a];
        }
        if (!(fabs(sum - 1) < 1e-3)) {
            abort();
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input in = {data, size};
    taut_basis_spec spec = {.type = NULL};
    taut_basis *basis = NULL;
    taut_error error;
    double *knots = NULL;
    int functions = 0;

    for (int i = take_small(&in); i >= 0 && taut_basis_ops_at(i) != NULL; i = -1) {
        spec.type = taut_basis_ops_at(i)->type;
    }
    spec.degree = take_small(&in);
    functions = take_small(&in) < 0 ? take_int(&in) : take_small(&in);
    spec.count = take_small(&in) < 0 ? take_int(&in) : take_small(&in);
    spec.segments = take_small(&in) < 0 ? take_int(&in) : take_small(&in);
    spec.has_range = take_small(&in);
    spec.alpha = take_double(&in);
    spec.beta = take_double(&in);
    spec.gamma = take_double(&in);
    spec.range[0] = take_double(&in);
    spec.range[1] = take_double(&in);
    spec.knot_count = (int)(in.size / sizeof(double));
    if (spec.knot_count > 0) {
        knots = malloc((size_t)spec.knot_count * sizeof(double));
        if (knots == NULL) {
            return 0;
        }
        for (int i = 0; i < spec.knot_count; i++) {
            knots[i] = take_double(&in);
        }
        spec.knots = knots;
    }
    if (taut_basis_new(&spec, functions, &basis, &error) == TAUT_OK) {
        use(basis);
        taut_basis_free(basis);
    } else if (error.message[0] == '\0') {
        abort();
    }
    free(knots);
    return 0;
}
