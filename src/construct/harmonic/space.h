/* space.h -- the harmonic and the biharmonic polynomials of one bidegree, as Bernstein nets.
 *
 * With z = A (u - 1/2) + i B (v - 1/2), A : B the sides of the rectangle, the harmonic polynomials
 * are Re and Im of polynomials in z, the biharmonic ones of those and conj(z) times them
 * ([NiWang2015] sections 2.3, 8.3, 8.4). Powers of z are useless as a basis beyond low degrees: the
 * polynomials q_k here are orthonormal over points of the boundary, by Arnoldi's recurrence
 * ([BrubeckNakatsukasaTrefethen2021]), which is run on their Bernstein coefficients at the same
 * time.
 */
#ifndef TAUT_HARMONIC_SPACE_H
#define TAUT_HARMONIC_SPACE_H

#include "construct/harmonic/lidstone.h"
#include "core/arena.h"
#include "core/pulse.h"

enum { TAUT_SPACE_DEGREE_MAX = 64 };

typedef struct taut_space {
    int n, m;
    int count;        /* functions */
    taut_twice *nets; /* [count][n+1][m+1] */
    unsigned char *
        odd; /* [count]: 1, odd about u = 1/2; 2, about v = 1/2; 3, about both; 0, about neither: even */
    taut_pulse *pulse; /* told of the work with it, or NULL */
} taut_space;

/* All harmonic polynomials of bidegree (n, m): 2 min(n, m) + 2 of them, one less for even n = m.
 * across, along > 0: the sides. Degrees 1..TAUT_SPACE_DEGREE_MAX. Returns 0 when memory runs out, and
 * when the pulse says stop.
 */
int taut_space_harmonic(int n, int m, double across, double along, taut_arena *arena,
                        taut_pulse *pulse, taut_space *space);
/* All biharmonic polynomials of bidegree (n, n): 4 n. */
int taut_space_biharmonic(int n, double across, double along, taut_arena *arena, taut_pulse *pulse,
                          taut_space *space);

#endif /* TAUT_HARMONIC_SPACE_H */
