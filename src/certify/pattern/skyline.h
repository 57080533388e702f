/* skyline.h -- Cholesky's factor of a symmetric matrix that is kept by rows, each from its first entry on. */
#ifndef TAUT_CERTIFY_PATTERN_SKYLINE_H
#define TAUT_CERTIFY_PATTERN_SKYLINE_H

#include "core/arena.h"
#include "core/pulse.h"

typedef struct taut_skyline {
    int n;
    const int *first; /* [n]: the first column of each row */
    double **rows; /* [n]: row i from its first column on; rows[i][i - first[i]] is the diagonal */
} taut_skyline;

/* Zeros, in the arena; first[n] is kept by reference. TAUT_NO_MEMORY. */
taut_status taut_skyline_new(taut_arena *arena, int n, const int *first, taut_skyline *matrix);
/* How many entries it keeps. */
double taut_skyline_room(const taut_skyline *matrix);
/* In place; 0 where the matrix is not positive, and where the pulse, which may be NULL, says stop. */
int taut_skyline_factor(taut_skyline *matrix, taut_pulse *pulse);
/* x becomes the solution, of a factor. */
void taut_skyline_solve(const taut_skyline *factor, double *x);

#endif /* TAUT_CERTIFY_PATTERN_SKYLINE_H */
