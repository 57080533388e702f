/* neighbour.h -- a surface turned so that one of its edges is u = 1, and what lies beyond. */
#ifndef TAUT_HARMONIC_NEIGHBOUR_H
#define TAUT_HARMONIC_NEIGHBOUR_H

#include "construct/harmonic/unit_map.h"
#include "core/arena.h"
#include "taut/join.h"

typedef struct taut_neighbour {
    const taut_surface *surface; /* on bezier bases, without weights */
    taut_edge edge;
    const taut_surface *other; /* said to be what lies beyond; NULL: none */
    taut_arena *arena;
    int turned;           /* u and v change places */
    int reversed;         /* the direction across the edge is reversed */
    int n, m;             /* degrees across the edge and along it */
    double across, along; /* parameter widths */
    double ratio;         /* width of what lies beyond over that of the surface */
    double here, end;     /* the parameters of the shared edge and of the far one beyond */
    taut_unit_map map;
    double *net; /* double[n+1][m+1][3], in unit size */
} taut_neighbour;

/* Fills `e` from surface, edge, arena, and width (0: that of the surface). */
taut_status taut_neighbour_turn(taut_neighbour *e, double width, taut_error *error);

/* TAUT_BAD_INPUT for a surface that is not polynomial on bezier bases, or a bad width. */
taut_status taut_neighbour_check(const taut_surface *surface, double width, taut_error *error);

/* merge.c. The width of `other`, or TAUT_NO_SOLUTION where its degrees are others. */
taut_status taut_neighbour_match(const taut_neighbour *e, double *width, taut_error *error);
/* TAUT_NO_SOLUTION with the gap where `other` has not the points of the surface beyond: to
 * rounding, or to the last digit. */
taut_status taut_neighbour_compare(const taut_neighbour *e, const taut_surface *beyond, int exact,
                                   taut_error *error);

/* The control points of w_u P_uu + w_v P_vv in bidegree (n, m), relation (2) of [NiWang2015]
 * section 2.2: nets double[n+1][m+1][3], not the same. */
void taut_net_laplacian(int n, int m, double wu, double wv, const double *net, double *laplacian);

/* What has to vanish, |x_uu + x_vv| (times 1) or its Laplacian (times 2), scaled by as many factors
 * max(w_u n^2, w_v m^2); scratch [2][n+1][m+1][3]. */
double taut_neighbour_residual(const taut_neighbour *e, int times, double *scratch);

/* The net over [1, 1 + h] of the normalised parameter, or with `merged` over [0, 1 + h]. */
void taut_neighbour_extrapolate(const taut_neighbour *e, int merged, double *out);

/* The polynomial of `surface` over the ranges of another (one of which is the same), in rational
 * arithmetic: replaces *beyond, which has them, by one with exact points. */
taut_status taut_neighbour_exact(const taut_surface *surface, taut_arena *arena,
                                 taut_surface **beyond, taut_error *error);

/* A surface from a turned net that taut_neighbour_extrapolate gives; `net` leaves unit size. */
taut_status taut_neighbour_surface(const taut_neighbour *e, const char *name, double *net,
                                   int merged, taut_surface **surface, taut_error *error);

#endif /* TAUT_HARMONIC_NEIGHBOUR_H */
