/* flat.h -- films of many patches that lie in a plane, told before anything is solved.
 *
 * Where all that is held lies in a plane, one tension draws all patches, they are joined two by two without cables, and their
 * boundary is one closed curve of straight edges that are held and of cables of given forces between corners that are held, the
 * film is the region between arcs of circles of construct/film/flat.h, with as many sides.
 */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_FLAT_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_FLAT_H

#include "construct/film/complex/layout.h"

/* TAUT_OK where the film is another, or exists. TAUT_NO_SOLUTION: cable-too-weak, error->limit the least force of the cable named in
 * error->where, all forces raised alike. TAUT_NO_MEMORY. */
taut_status taut_film_complex_flat_check(const taut_film_layout *layout, taut_arena *arena,
                                         taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_FLAT_H */
