/* threads.h -- forces along threads in the place of a tension: what is given of them, and as densities at Gauss nodes. */
#ifndef TAUT_CONSTRUCT_FILM_THREADS_H
#define TAUT_CONSTRUCT_FILM_THREADS_H

#include "construct/film/edges.h"
#include "construct/plateau/density.h"

/* One kind of them, and a reference with a prestress, on the bases of the film. TAUT_BAD_INPUT: value, conflict, missing, basis. */
taut_status taut_film_threads_check(const taut_film_problem *problem, taut_error *error);

/* a, b over a tension at the nodes of the functional: the densities, or of a prestress |X_u x X_v| s / |X_u|^2 by u and v over
 * [0, 1]. From then on the functional is that of the threads. */
void taut_film_threads_lay(const taut_film_problem *problem, const taut_surface *reference,
                           double tension, taut_area_functional *functional,
                           taut_area_density *density);

#endif /* TAUT_CONSTRUCT_FILM_THREADS_H */
