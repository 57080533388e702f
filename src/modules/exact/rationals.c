#include "rationals.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

taut_rationals taut_rationals_new(int64_t count)
{
    taut_rationals r = {flint_malloc((size_t)count * sizeof(fmpq)), count};
    for (int64_t i = 0; i < count; i++) {
        fmpq_init(r.x + i);
    }
    return r;
}

void taut_rationals_free(taut_rationals *r)
{
    for (int64_t i = 0; i < r->count; i++) {
        fmpq_clear(r->x + i);
    }
    flint_free(r->x);
}

void taut_rational_set_double(fmpq_t x, double value)
{
    int exponent = 0;
    const double mantissa = frexp(value, &exponent);
    fmpz_set_d(fmpq_numref(x), ldexp(mantissa, 53));
    fmpz_one(fmpq_denref(x));
    if (exponent >= 53) {
        fmpq_mul_2exp(x, x, (ulong)(exponent - 53));
    } else {
        fmpq_div_2exp(x, x, (ulong)(53 - exponent));
    }
}

void taut_rational_set(fmpq_t x, const taut_exact_numbers *from, size_t i)
{
    if (from->texts == NULL || from->texts[i] == NULL || fmpq_set_str(x, from->texts[i], 10) != 0) {
        taut_rational_set_double(x, from->values[i]);
    }
    fmpq_canonicalise(x);
}

/* |x - value| */
static void set_distance(fmpq_t out, const fmpq_t x, double value)
{
    taut_rational_set_double(out, value);
    fmpq_sub(out, x, out);
    fmpq_abs(out, out);
}

/* The nearest double: FLINT's is at most one away. */
double taut_rational_nearest(const fmpq_t x)
{
    double best = fmpq_get_d(x);
    fmpq_t least, other;
    if (!isfinite(best)) {
        return best;
    }
    fmpq_init(least);
    fmpq_init(other);
    set_distance(least, x, best);
    for (int side = 0; side < 2; side++) {
        const double next = nextafter(fmpq_get_d(x), side == 0 ? -INFINITY : INFINITY);
        if (isfinite(next)) {
            set_distance(other, x, next);
            if (fmpq_cmp(other, least) < 0) {
                fmpq_swap(other, least);
                best = next;
            }
        }
    }
    fmpq_clear(least);
    fmpq_clear(other);
    return best;
}

/* Texts and nearest doubles of a net [n+1][m+1][3]. */
int taut_rationals_deliver(int n, int m, const taut_rationals *from,
                           const taut_exact_memory *memory, taut_exact_net *net)
{
    const size_t count = (size_t)from->count;
    net->n = n;
    net->m = m;
    net->values = memory->take(memory->context, count, sizeof *net->values);
    net->texts = memory->take(memory->context, count, sizeof *net->texts);
    for (size_t i = 0; net->values != NULL && net->texts != NULL && i < count; i++) {
        char *text = fmpq_get_str(NULL, 10, from->x + i);
        const size_t length = strlen(text) + 1;
        char *kept = memory->take(memory->context, length, 1);
        if (kept != NULL) {
            memcpy(kept, text, length);
        }
        flint_free(text);
        if (kept == NULL) {
            return 0;
        }
        net->texts[i] = kept;
        net->values[i] = taut_rational_nearest(from->x + i);
    }
    return net->values != NULL && net->texts != NULL;
}
