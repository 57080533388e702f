/* films.h -- what tests of least areas share. */
#ifndef TAUT_TEST_FILMS_H
#define TAUT_TEST_FILMS_H

#include "problems.h"

#include "taut/plateau.h"

/* The net's film by a method, all else as it is by default. */
taut_plateau_problem film_problem(const test_problem *net, taut_plateau_method method);
/* The area of a model whose certificate must hold; NaN where it cannot be had. */
double film_proved_area(const taut_model *model, const taut_plateau_problem *problem,
                        const char *what);
/* Makes and proves; the area, NaN if that fails. */
double film_area(const taut_plateau_problem *problem, const char *what);

#endif /* TAUT_TEST_FILMS_H */
