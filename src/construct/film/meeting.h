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

#include "construct/film/equilibrium.h"

/* The corner, or -1, in which a cable of the net at rest passes another edge. */
int taut_film_passed_corner(const taut_film_work *w);

#endif /* TAUT_CONSTRUCT_FILM_MEETING_H */
