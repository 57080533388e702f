/* rings.h -- films that go around the z axis. */
#ifndef TAUT_TEST_RINGS_H
#define TAUT_TEST_RINGS_H

#include "taut/film.h"

typedef struct ring {
    taut_basis *u, *v;
    taut_curve *rims[2]; /* circles, or NULL */
    taut_film_problem problem;
} ring;

/* Splines of degree p around with n points, of degree q along with m; edges v0 and v1 are still to come. */
ring ring_new(int p, int n, int q, int m);
void ring_free(ring *r);
/* Edge v0 (k = 0) or v1 is held on a circle at this height, drawn by a cable in that plane, or slides in it. */
void ring_circle(ring *r, int k, double z, double radius);
void ring_cable(ring *r, int k, double z, double force);
void ring_slide(ring *r, int k, double z);
/* Points p become R p + d: everything that the problem says of places. */
void ring_move(ring *r, double turn[3][3], const double d[3]);

/* The catenoid between circles of radius 1 at distance h, the wider neck: its radius; its area. */
double ring_neck(double h);
double ring_area(double h);

#endif /* TAUT_TEST_RINGS_H */
