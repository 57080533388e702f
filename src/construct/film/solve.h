/* solve.h -- the film of least energy in its spline space. */
#ifndef TAUT_CONSTRUCT_FILM_SOLVE_H
#define TAUT_CONSTRUCT_FILM_SOLVE_H

#include "construct/film/equilibrium.h"
#include "taut/construct.h"

typedef struct taut_film_solution {
    double *points;    /* [nu][nv][3], in the arena: held ones bit for bit */
    double lengths[4]; /* of the cables; 0: no cable */
    double forces[4];
    double *
        changes; /* [problem->updates], in the arena: how far each update moved a point, over the size; or NULL */
    double area;   /* of the film, in the user's unit; as far as doubles reach */
    double rival;  /* of a ring: the area of two films that each span one of its edges; else 0 */
    double energy; /* of film and cables, in the user's unit */
    int iterations;
    int negative;       /* eigenvalues of the second variation below 0; -1: not looked at */
    double residual;    /* largest derivative along a move that the energy sees over the largest */
    int by_moves;       /* found by the method `normal`, asked for or not */
    const char *method; /* of the steps: "factors" or "conjugate-gradients" */
} taut_film_solution;

/* TAUT_NO_SOLUTION: no-area, cable-too-weak; TAUT_NOT_CONVERGED: folds, not-converged;
 * TAUT_INTERRUPTED, TAUT_NO_MEMORY. */
taut_status taut_film_solve(const taut_film_space *space, const taut_make_options *options,
                            taut_arena *arena, taut_film_solution *solution, taut_error *error);

/* All but `changes` from w->net. TAUT_NO_SOLUTION: overflow; TAUT_NO_MEMORY. */
taut_status taut_film_fill_solution(taut_film_work *w, taut_arena *arena,
                                    taut_film_solution *solution, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_SOLVE_H */
