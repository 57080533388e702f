/* parting.h -- films between two rims, which may be too far apart.
 *
 *     rims     the nodes of edges that are held whole, as these join them: two, or one and the nodes of slides apart from it
 *     way      from the middle of the first rim to that of the second
 *     share    0 on the first, 1 on the second, between them the mean of its neighbours in the nets: what lies between is moved by
 *              so much of the way when the second is
 */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_PARTING_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_PARTING_H

#include "construct/film/complex/layout.h"

typedef struct taut_film_parting {
    int count;        /* of rims: 2, or there is no way */
    int slides;       /* nonzero: the second rim is one of slides */
    double way[3];    /* scaled */
    signed char *rim; /* [nodes]: 0, 1, or -1 of neither */
    double *share;    /* [nodes] */
    int *class;       /* [2 patch_count]: room for strips */
} taut_film_parting;

/* Rims and way, in the arena. TAUT_NO_MEMORY. */
taut_status taut_film_parting_new(const taut_film_layout *layout, taut_arena *arena,
                                  taut_film_parting *parting);
/* The rest. TAUT_NO_MEMORY. */
taut_status taut_film_parting_spread(const taut_film_layout *layout, taut_arena *arena,
                                     taut_film_parting *parting);

/* Refuses two rims that no connected film of one tension spans, without lines, cables and cells (construct/film/cone.h).
 * TAUT_NO_SOLUTION: collapses; TAUT_NO_MEMORY. */
taut_status taut_film_parting_check(const taut_film_layout *layout,
                                    const taut_film_parting *parting, taut_arena *arena,
                                    taut_error *error);

/* The area of two films that each span one of such rims by itself, at most, in the user's unit: of cones over them with their tips in
 * the middle. 0 of others. TAUT_NO_MEMORY. */
taut_status taut_film_parting_discs(const taut_film_layout *layout,
                                    const taut_film_parting *parting, taut_arena *arena,
                                    double *area);

/* The shortest chain of lines across a strip of patches over the shorter side of the strip at the start: of nets that are scaled.
 * class: [2 patch_count]. */
double taut_film_parting_neck(const taut_film_layout *layout, const double *x, int *class);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_PARTING_H */
