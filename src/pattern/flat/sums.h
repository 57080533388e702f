/* sums.h -- an energy's first and second variation over a tensor spline, summed one direction after the other.
 *
 * A function N = S_i(s) T_k(t) that moves y_d has the gradient (S_i' T_k, S_i T_k'). With the density's second derivatives
 * M by the entries of J,
 *
 *     H(ikd, i'k'e) = sum_q  sum_ab S_i^a S_i'^b  sum_r T_k^a T_k'^b M_qr(da, eb)
 *
 * the sum over r once for each place of s, for all pairs (k, k') that share a span; a fifth of the work of a sum over
 * all places for all pairs of functions.
 */
#ifndef TAUT_PATTERN_SUMS_H
#define TAUT_PATTERN_SUMS_H

#include "numeric/band.h"
#include "pattern/flat/density.h"
#include "pattern/flat/line.h"

typedef struct taut_flat_sums {
    const taut_flat_line *s, *t;
    int pairs;      /* of functions of t that share a span */
    int *row;       /* [count of t]: where the pairs of a function begin */
    int *across;    /* [pairs]: where (k', k) is */
    double *speed;  /* [count of t][4]: y_s and y at a place of s */
    double *folded; /* T_k^a T_k'^b: [spans of t][GAUSS][2][2][LOCAL * LOCAL] */
    double *moment; /* sums over r: [4][4][pairs] */
    double *half;   /* with S_i^a: [2][4][pairs] */
    double *whole;  /* [LOCAL][LOCAL][2][2][pairs] */
    double *pull;   /* [count of t][4]: first derivatives */
} taut_flat_sums;

/* Of lines that outlive it, in the arena. 0 where there is no memory. */
int taut_flat_sums_new(taut_arena *arena, const taut_flat_line *s, const taut_flat_line *t,
                       taut_flat_sums *sums);

/* J of all places of t, [spans of t * GAUSS], at place q of span a of s; y: [count of s][count of t][2]. */
void taut_flat_sums_slopes(taut_flat_sums *sums, const double *y, int a, int q, double (*j)[2][2]);

/* The span's sums begin at zero; then each of its places of s is added, with the forms of all places of t and whether each is
 * there; then all goes to gradient and band. */
void taut_flat_sums_begin(taut_flat_sums *sums);
void taut_flat_sums_add(taut_flat_sums *sums, int a, int q, const taut_flat_form *forms,
                        const char *is_there, double *gradient);
void taut_flat_sums_end(const taut_flat_sums *sums, int a, taut_band *hessian);

#endif /* TAUT_PATTERN_SUMS_H */
