/* film_curves.h -- the member `curves` of films: a boundary of 3 to 12 curves, cut into patches. */
#ifndef TAUT_IO_PROBLEM_FILM_CURVES_H
#define TAUT_IO_PROBLEM_FILM_CURVES_H

#include "io/problem/film_patches.h"
#include "taut/film.h"

/* Reads a curve, or a shape. */
typedef void taut_film_curve_read(taut_reader *document, const taut_json *at, taut_arena *arena,
                                  const taut_curve **curve);

/* "curves", or those of the file that "boundary" names, with "degree" and "count". Four curves without an open corner are the edges of
 * the film, whose bases, and name, have been read. Else they are cut into polygons (io/problem/film_curves_cut.h), and of each
 *
 *     patch k    from its corner k to its centre: its v0 the first half of side k, its u0 the second half of the side before, run
 *                backwards
 *     seam k     from the middle of side k to the centre: u1 of patch k, v1 of patch k + 1
 *
 * A curve is halved in the middle of its parameters. */
void taut_film_document_curves(taut_reader *document, taut_problem *problem,
                               taut_film_curve_read *read, taut_film_problem *data,
                               taut_film_parts *parts);

#endif /* TAUT_IO_PROBLEM_FILM_CURVES_H */
