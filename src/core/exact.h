/* exact.h -- harmonic surfaces in rational arithmetic: what the module `exact` (FLINT) does.
 *
 * A number is its text, "p" or "p/q", or where it has none the double, which is a rational too.
 * Results have both: the text in lowest terms and the nearest double. Texts that reach the module
 * have been checked: an optional sign, digits, and a denominator that is not 0.
 */
#ifndef TAUT_CORE_EXACT_H
#define TAUT_CORE_EXACT_H

#include "core/arena.h"
#include "platform/module.h"

#include <stddef.h>

/* Numbers in order; texts NULL: none has one. */
typedef struct taut_exact_numbers {
    const double *values;
    const char *const *texts;
} taut_exact_numbers;

/* Where results go: take(context, count, size) is zeroed memory, or NULL. */
typedef struct taut_exact_memory {
    void *context;
    void *(*take)(void *context, size_t count, size_t size);
} taut_exact_memory;

/* What to complete a harmonic net from ([NiWang2015] sections 2.4, 2.5). */
typedef struct taut_exact_lines {
    int n, m;                   /* degrees across the lines and along them */
    double across[2], along[2]; /* ranges: their lengths are differences that no double holds */
    int from_derivative;        /* the second line is dx/du, by parameter length */
    int corner_missing;         /* the last point of the second line is to be found */
    int even; /* what to do when lines of even degree do not agree: 0 nothing, 1 move that
               * last point, 2 move both lines least, 3 raise n */
    taut_exact_numbers line[2]; /* [m+1][3] */
} taut_exact_lines;

typedef struct taut_exact_net {
    int n, m;
    double *values;     /* [n+1][m+1][3] */
    const char **texts; /* of the same, none NULL */
    int moved;          /* a repair was made */
    double change;      /* the largest move of a given number */
    double defect;      /* of lines that do not agree; then, with `even` 0, there is no net */
} taut_exact_net;

typedef struct taut_exact_ops {
    size_t size; /* of this table, which the user compares */
    /* Each returns 0 when memory runs out. */
    int (*complete)(const taut_exact_lines *lines, const taut_exact_memory *memory,
                    taut_exact_net *net);
    /* The same polynomial over another range of u (or v): range = {lo, hi, from, to}. */
    int (*rerange)(int n, int m, const taut_exact_numbers *net, int along_v, const double range[4],
                   const taut_exact_memory *memory, taut_exact_net *out);
    /* max |R_ij| of relation (2) over the rectangle {u lo, u hi, v lo, v hi}, rounded: 0 only where
     * it is 0. */
    int (*residual)(int n, int m, const taut_exact_numbers *net, const double rectangle[4],
                    double *largest);
} taut_exact_ops;

/* Results go to the arena. */
taut_exact_memory taut_exact_memory_of(taut_arena *arena);

/* The module, or TAUT_IO with the advice what to install. */
#ifdef TAUT_NO_MODULES /* a build that loads none: compilers leave out what would come behind it */
static inline taut_status taut_exact_load(const taut_exact_ops **ops, taut_error *error)
{
    const void *none = NULL;
    (void)ops;
    (void)taut_module_load("exact", "libflint-dev", &none, error);
    return TAUT_IO;
}
#else
taut_status taut_exact_load(const taut_exact_ops **ops, taut_error *error);
#endif

#endif /* TAUT_CORE_EXACT_H */
