/* film_curves_closed.h -- one closed curve, or two, as the edges of a film that goes around. */
#ifndef TAUT_IO_PROBLEM_FILM_CURVES_CLOSED_H
#define TAUT_IO_PROBLEM_FILM_CURVES_CLOSED_H

#include "problem/problem.h"
#include "taut/film.h"

/* Is it closed, and smooth all round? */
int taut_film_curve_is_closed(const taut_curve *curve);

/* The pieces, at most `most`, of a closed curve between its corners; *count is 0 where it is not closed, has none or has more. They
 * go on from each other, as the curve runs; where it begins in the middle of one, that is the first. The arena owns them. */
taut_status taut_film_curve_cut(taut_arena *arena, const taut_curve *curve, int most,
                                const taut_curve **pieces, int *count, taut_error *error);

/* Of closed curves, one or two: a film around, u0 and u1 one curve inside it. v0 is the first one; v1 the second, or of one a
 * pole. Both run about the same way round. Those that are circles become circles with equal angles, which begin beside
 * each other; that is noted, and so is a pole. The bases have the degree and the count of `spec` along v, twice as many functions along u.
 * The problem's arena owns all of it. */
taut_status taut_film_curves_around(taut_problem *problem, int count, const taut_curve **curves,
                                    const taut_basis_spec *spec, taut_film_problem *data,
                                    taut_error *error);

#endif /* TAUT_IO_PROBLEM_FILM_CURVES_CLOSED_H */
