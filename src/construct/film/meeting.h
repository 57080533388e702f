/* meeting.h -- do cables meet in their corner, or pass each other there?
 *
 *     t(0) = int t dw - 1/r int (1 - w) nu ds,    t(1) = int t dw + 1/r int w nu ds,    w from 0 to 1 with the parameter
 *
 * is where the ends of a cable at rest look, for r t' = nu along its arc length; nu outwards, of a cable in a plane what lies in
 * it. These are far nearer to the film's than tangents of its net, which by their errors keep apart what a weak force draws
 * together.
 */
#ifndef TAUT_CONSTRUCT_FILM_MEETING_H
#define TAUT_CONSTRUCT_FILM_MEETING_H

#include "construct/plateau/area.h"
#include "taut/film.h"

/* Do the edges of the net double[nu][nv][3], at rest and that of the functional's last gradient, pass each other in corner c?
 * radius[e]: r of edge e, 0 where it is no cable. */
int taut_film_passes(const taut_area_functional *f, const taut_film_problem *patch,
                     const double radius[4], const double *net, int c);

#endif /* TAUT_CONSTRUCT_FILM_MEETING_H */
