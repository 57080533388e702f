/* laws.h -- what the cables of a film of many patches draw with.
 *
 *     force     r L
 *     elastic   p^2 / (2 k),  p = max(0, r_0 + k (L - L_0)) with r_0 = 0
 *     length    nothing: L stays L_0, and p is the multiplier of L - L_0; while cables are soft, the spring above, with r_0 the force of
 *               its flat arc
 *
 * L is the length of all edges of a cable. Lengths are scaled, forces over the tension of the first patch and scaled.
 */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_LAWS_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_LAWS_H

#include "construct/common/scaling.h"
#include "problem/film_ropes.h"

typedef struct taut_film_drawn {
    taut_film_law law;
    double ratio;     /* r; where there is no such law the force of a flat arc, or a guess */
    double stiffness; /* k, elastic */
    double length;    /* L_0: given, or unstressed */
    /* What it begins with: a spring of that force at its length, which draws with half of it or more at the start. */
    double target; /* 0: it begins as it is */
    double shy;    /* what its start lacks of that length */
    int is_closed;
} taut_film_drawn;

/* Of the ropes of a complex, whose nodes start at points[nodes][3] in the user's unit. drawn: [rope_count]. TAUT_BAD_INPUT: value. */
taut_status taut_film_laws_find(const taut_film_complex *complex, const taut_scaling *scaling,
                                const double *points, const double *tensions,
                                taut_film_drawn *drawn, taut_error *error);

/* soft: 0, or so many times the force of its flat arc it begins with. */
/* k of a cable as it is taken; 0: none. */
double taut_film_law_stiffness(const taut_film_drawn *drawn, double soft);
/* p at a length, and what it stores, where it has a stiffness. */
double taut_film_law_force(const taut_film_drawn *drawn, double soft, double length);
double taut_film_law_energy(const taut_film_drawn *drawn, double soft, double length);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_LAWS_H */
