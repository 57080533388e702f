/* film_curves.h -- the member `curves` of films: a boundary of 3 to 12 curves, cut into patches. */
#ifndef TAUT_IO_PROBLEM_FILM_CURVES_H
#define TAUT_IO_PROBLEM_FILM_CURVES_H

#include "io/problem/film_patches.h"
#include "taut/film.h"

enum { TAUT_FILM_CURVES_MAX = 12 };

/* Reads a curve, or a shape. */
typedef void taut_film_curve_read(taut_reader *document, const taut_json *at, taut_arena *arena,
                                  const taut_curve **curve);

/* "curves", or those of the file that "boundary" names, with "degree" and "count". Four curves are the edges of the film, whose bases, and name, have been read. Else
 *
 *     patch k    from the corner where curve k begins to the centre: its v0 the first half of curve k, its u0 the second half of
 *                the curve before, run backwards
 *     seam k     from the middle of curve k to the centre: u1 of patch k, v1 of patch k + 1
 *
 * A curve is halved in the middle of its parameters. */
void taut_film_document_curves(taut_reader *document, taut_problem *problem,
                               taut_film_curve_read *read, taut_film_problem *data,
                               taut_film_parts *parts);

#endif /* TAUT_IO_PROBLEM_FILM_CURVES_H */
