/* rationals.h -- arrays of rationals, from numbers and texts and back. */
#ifndef TAUT_EXACT_RATIONALS_H
#define TAUT_EXACT_RATIONALS_H

#include "core/exact.h"

#include <flint/fmpq.h>
#include <stdint.h>

/* Rationals in order. */
typedef struct taut_rationals {
    fmpq *x;
    int64_t count;
} taut_rationals;

taut_rationals taut_rationals_new(int64_t count);
void taut_rationals_free(taut_rationals *r);

/* The rational a double is, and number i: its text, or its double. */
void taut_rational_set_double(fmpq_t x, double value);
void taut_rational_set(fmpq_t x, const taut_exact_numbers *from, size_t i);
/* The nearest double; infinite where it is too large. */
double taut_rational_nearest(const fmpq_t x);

/* Texts and nearest doubles of a net [n+1][m+1][3]; 0 when memory runs out. */
int taut_rationals_deliver(int n, int m, const taut_rationals *from,
                           const taut_exact_memory *memory, taut_exact_net *net);

#endif /* TAUT_EXACT_RATIONALS_H */
