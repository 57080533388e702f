/* trust_region_step.h -- where a descent stands, and places it may go to. Private to descent*.c. */
#ifndef TAUT_CONSTRUCT_PLATEAU_TRUST_REGION_STEP_H
#define TAUT_CONSTRUCT_PLATEAU_TRUST_REGION_STEP_H

#include "construct/plateau/trust_region.h"

enum { TAUT_WALK_PAST = 5 }; /* accepted steps whose areas are kept */

typedef struct taut_place {
    taut_film_value value;
    double *net, *gradient; /* [nu][nv][3] */
    double residual;
} taut_place;

typedef struct taut_walk {
    taut_film *film;
    taut_film_solver *solver;
    taut_descent *descent;
    size_t count, size; /* points; unknowns */
    taut_place here, there;
    double *right, *step, *image, *turn; /* unknowns */
    double *move, *bend;                 /* nets */
    double theta, model, first_norm, start_area;
    double first_work; /* of the film, before */
    double barrier;    /* no step may take the smallest area element, over the mean, below this */
    double fence;      /* B was last seen indefinite at this theta; forgotten by and by */
    double past[TAUT_WALK_PAST];
    int steps, flat_steps;
    int is_barred; /* the last step tried went below the barrier */
} taut_walk;

/* The net to start from becomes here's, and stays the caller's. TAUT_NO_MEMORY. */
taut_status taut_walk_new(taut_film *film, taut_film_solver *solver, taut_descent *descent,
                          double *net, taut_walk *walk);
void taut_walk_clear(taut_walk *walk);

/* max |x_i| */
double taut_largest(size_t count, const double *x);

/* Area, gradient and residual of the place's net; the film's operators are its own from now on. */
void taut_walk_look(taut_walk *walk, taut_place *place);
/* there = here + factor step. */
void taut_walk_try(taut_walk *walk, double factor);
/* here = there. */
void taut_walk_accept(taut_walk *walk);

/* there = the best place found along the curve that begins with the step at hand, whose factors are
 * still those of its B. 0 where there are no factors, or no place is better than here; there is
 * here + step then. */
int taut_walk_bend(taut_walk *walk);
/* Steps with the factors at hand for as long as each halves the residual. */
void taut_walk_polish(taut_walk *walk);

#endif /* TAUT_CONSTRUCT_PLATEAU_TRUST_REGION_STEP_H */
