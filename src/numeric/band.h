/* band.h -- symmetric banded matrices: the Gram matrices of a spline basis, and the systems made of
 * them.
 *
 *     A(i, j) = A(j, i),     A(i, j) = 0 for |i - j| > width
 *
 * Stored by rows of the lower triangle, the diagonal first:
 *     a[i*(width + 1) + d] = A(i, i - d),    d = 0..width;    entries with i < d are zero.
 */
#ifndef TAUT_NUMERIC_BAND_H
#define TAUT_NUMERIC_BAND_H

#include "core/pulse.h"
#include "taut/status.h"

#include <stddef.h>

typedef struct taut_band {
    int n;     /* rows, >= 1 */
    int width; /* half-width >= 0; may exceed n - 1, what lies outside is then zero */
    double *a; /* double[n][width+1], owned by whoever made it */
} taut_band;

/* A zero matrix. TAUT_BAD_ARGUMENT (n < 1, width < 0, too large) or TAUT_NO_MEMORY leave *out
 * alone. */
taut_status taut_band_init(int n, int width, taut_band *out);
/* Frees out->a and zeroes *out. */
void taut_band_clear(taut_band *band);
/* A copy with half-width `width` >= from->width. Statuses as taut_band_init. */
taut_status taut_band_widen(const taut_band *from, int width, taut_band *out);

/* 1 when n, width and a make sense, all entries are finite and those with i < d are zero. */
int taut_band_is_legal(const taut_band *band);
/* 1 when both have the same size, width and entries, bit for bit. */
int taut_band_equal(const taut_band *a, const taut_band *b);

static inline double *taut_band_row(const taut_band *band, int i)
{
    return band->a + (size_t)i * ((size_t)band->width + 1);
}

/* A(i, j), zero outside the band; 0 <= i, j < n. */
double taut_band_at(const taut_band *band, int i, int j);

/* y += factor A x; x, y double[n], apart. Cost O(n width). */
void taut_band_multiply_add(const taut_band *band, double factor, const double *x, double *y);

/* Replaces A by its factors L D L^T, L unit lower ([GolubVanLoan2013] 4.3.5): row i then holds D(i)
 * followed by L(i, i-1), L(i, i-2), ... No pivoting: for A positive definite. Returns TAUT_OK, or
 * TAUT_NO_SOLUTION when a pivot is not above 8 n 2^-53 A(i, i), so that A is not safely positive
 * definite; `band` is then spoilt. Cost O(n width^2). */
taut_status taut_band_factor(taut_band *band);
/* The same, of which pulse, which may be NULL, is told: TAUT_INTERRUPTED, and `band` is spoilt. */
taut_status taut_band_factor_watched(taut_band *band, taut_pulse *pulse);

/* The same for A that may have eigenvalues below 0: *negative of them (Sylvester). TAUT_NO_SOLUTION when a pivot is not
 * safely different from 0. Without pivoting it is as exact as the least pivot lets it be: for A of which few eigenvalues are
 * negative, and when what is made with it is judged. pulse as above. */
taut_status taut_band_factor_signed(taut_band *band, int *negative, taut_pulse *pulse);

/* Solves A X = B in place; x double[n][count]; `factor` from taut_band_factor. Cost O(n width
 * count). */
void taut_band_solve(const taut_band *factor, int count, double *x);

/* ---- wide bands (band_tiles.c) ---- */

enum { TAUT_BAND_TILES_LEAST = 64 }; /* half-width from which the tiles pay */

/* How many doubles taut_band_factor_tiled needs as `work`, aligned to 64 bytes, for this size. */
size_t taut_band_tiles_work(int n, int width);

/* As taut_band_factor, for a half-width >= TAUT_BAND_TILES_LEAST; the factors agree to rounding.
 * Nothing is allocated. pulse, which may be NULL, is told of it: TAUT_INTERRUPTED. */
taut_status taut_band_factor_tiled(taut_band *band, double *work, taut_pulse *pulse);

#endif /* TAUT_NUMERIC_BAND_H */
