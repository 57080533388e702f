/* edges.h -- edges and corners of a film: what they are called, and where they lie in its net. */
#ifndef TAUT_CONSTRUCT_FILM_EDGES_H
#define TAUT_CONSTRUCT_FILM_EDGES_H

#include "taut/film.h"

#include <stddef.h>

/* Names of edges and corners, as documents have them. */
extern const char *const taut_film_edge_names[4];
extern const char *const taut_film_corner_names[4];

/* Which of the corners edge e runs from (end 0) and to (1). */
static inline int taut_film_corner_of(int e, int end)
{
    return e < 2 ? e + 2 * end : end + 2 * (e - 2);
}

/* Is the edge kept in its plane? */
static inline int taut_film_has_plane(const taut_film_edge *edge)
{
    return edge->kind == TAUT_FILM_SLIDE || (edge->kind == TAUT_FILM_CABLE && edge->has_plane);
}

/* Is edge e one that the film has, and not a seam that it goes around? */
static inline int taut_film_has_edge(const taut_film_problem *problem, int e)
{
    return problem->ring == TAUT_FILM_OPEN || (problem->ring == TAUT_FILM_RING_U) == (e >= 2);
}

/* Is it drawn along its threads, by a force density or a prestress? */
static inline int taut_film_has_density(const taut_film_problem *problem)
{
    return problem->force_density[0] > 0 || problem->prestress[0] > 0;
}

/* What forces are compared with: the tension, or the larger of the two along the threads. */
static inline double taut_film_tension(const taut_film_problem *problem)
{
    const double *along = problem->prestress[0] > 0 ? problem->prestress : problem->force_density;
    if (taut_film_has_density(problem)) {
        return along[0] > along[1] ? along[0] : along[1];
    }
    return problem->tension > 0 ? problem->tension : 1;
}

/* Where the points of edge e lie in a net of nu by nv: the first, from one to the next, how many. */
void taut_film_edge_points(int nu, int nv, int e, size_t *first, size_t *step, int *count);

#endif /* TAUT_CONSTRUCT_FILM_EDGES_H */
