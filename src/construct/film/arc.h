/* arc.h -- the arc of a circle over a chord, as the cable of a flat film is one.
 *
 *     L = c a / sin a,    R = c / (2 sin a),    a in (0, pi) half the angle of the arc
 */
#ifndef TAUT_CONSTRUCT_FILM_ARC_H
#define TAUT_CONSTRUCT_FILM_ARC_H

/* a of an arc of length L > c > 0. */
double taut_film_arc_angle(double chord, double length);

/* The length of an arc of up to half a circle. */
double taut_film_arc_length(double chord, double radius);

/* The length of the arc that rises by sag times the chord, 0 < sag < 1/2. */
double taut_film_arc_of_sag(double chord, double sag);

/* The radius of the arc of an elastic cable over a chord: R = k (L(R) - L_0), k its stiffness per
 * length over the film's tension. 0 where that is no arc of up to half a circle. */
double taut_film_arc_elastic(double chord, double unstressed, double k);

#endif /* TAUT_CONSTRUCT_FILM_ARC_H */
