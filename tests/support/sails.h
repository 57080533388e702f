/* sails.h -- films to test: four corners, and cables of one force or edges that are held. */
#ifndef TAUT_TEST_SAILS_H
#define TAUT_TEST_SAILS_H

#include "taut/film.h"

typedef struct sail {
    taut_basis *u, *v;
    taut_curve *curve; /* of an edge, or NULL */
    taut_film_problem problem;
} sail;

/* Splines of this degree with so many points in both directions. corners: u0v0, u1v0, u0v1, u1v1.
 * force 0: all edges are straight. */
sail sail_new(int degree, int count, const double corners[4][3], double force);
/* Corners of the square of side 2 in a plane, and of a saddle over it (height 0.5 up and down). */
extern const double sail_square[4][3], sail_saddle[4][3];
/* The strip of a helicoid: u0 a cable from (a, 0, 0) to (a cos h, a sin h, h), u1 the helix of
 * radius 2 beside it; with force = (1 + a^2) / a the helix of radius a is where it rests. */
sail sail_helicoid(int degree, int count, double a, double h);
void sail_free(sail *s);

/* The model with its certificate, which must hold; NULL (a failure) where it is not made. */
taut_model *sail_make(const sail *s, taut_certificate **certificate);

/* The model of any film, and its certificate, whatever that says; NULL (a failure) where one of them is not made. */
taut_model *film_made(const taut_film_problem *problem, taut_certificate **certificate,
                      const char *what);
/* CHECKs that these claims hold. */
void film_holds(const taut_certificate *certificate, size_t count, const char *const *claims,
                const char *what);

/* Number `at` of a list among the figures. */
double sail_figure(const taut_certificate *certificate, const char *name, size_t at);

#endif /* TAUT_TEST_SAILS_H */
