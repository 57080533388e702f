/* sweep.h -- a surface of a pipe against the axis that it goes along, as polynomials.
 *
 * With R(u, v) = x(u, v) - P(s(u)), s the same place along the axis as u is along the surface, all
 * that is proved of a surface is proved of w R, a polynomial, on ever smaller patches.
 */
#ifndef TAUT_CERTIFY_PIPE_SWEEP_H
#define TAUT_CERTIFY_PIPE_SWEEP_H

#include "certify/common/field.h"
#include "certify/pipe/circle.h"
#include "certify/pipe/parts.h"

typedef struct taut_pipe_sweep {
    const taut_pipe_parts *parts;
    const taut_surface *surface;
    const char *name;
    taut_field axis[4][3]; /* P and its derivatives by s, 0 <= s <= 1, local */
    double most[4];        /* their largest lengths */
    double from, to;       /* its parameters on the line */
    double radius;         /* local; of a radius that changes the larger one */
    double tolerance;      /* over the radius */
    int straight;          /* nonzero: a line, along which places count too */
    int changes;           /* nonzero: the radius r changes along the axis */
    taut_field half[4];    /* then: r^2 / 2 and its derivatives by s, */
    double rate;           /* the largest |dr/ds|, */
    double half_most[2];   /* the largest of the second and the third derivative */
} taut_pipe_sweep;

/* A rectangle of a surface: w R, w, P' and P'' over it, each on [0, 1]^2. */
typedef struct taut_pipe_patch {
    taut_field way[3], w, first[3], second[3];
    taut_field half[3]; /* r^2 / 2 and two derivatives by s, where r changes */
    double u[2], v[2];
} taut_pipe_patch;

/* What is proved of a surface. */
typedef struct taut_pipe_cover {
    double bound, found; /* of the distance from the tube, over the radius: proved, and seen */
    char where[96];      /* the largest seen */
    const char *fault;   /* why it is not the tube; NULL */
    const char *open;    /* why that is not proved; NULL */
} taut_pipe_cover;

/* The largest length of a vector of fields. */
double taut_pipe_longest(const taut_field f[3]);
/* The fields of an axis, once axis[0] is there; 0: it is none to prove about. */
int taut_pipe_sweep_derive(taut_arena *arena, taut_pipe_sweep *sweep);
/* axis[0] of a curve of one piece; of the straight pipe `side`, `length` long (local). */
void taut_pipe_sweep_curve(taut_arena *arena, const taut_curve *curve, taut_pipe_sweep *sweep);
void taut_pipe_sweep_line(taut_arena *arena, int side, double length, taut_pipe_sweep *sweep);

/* Where the patch of span (i, j) is, u and v alone; returns it. */
const taut_pipe_patch *taut_pipe_patch_place(const taut_pipe_sweep *sweep, int i, int j,
                                             taut_pipe_patch *patch);
/* The patch of span (i, j); 0 where bases are none of polynomials. */
int taut_pipe_patch_of(taut_arena *arena, const taut_pipe_sweep *sweep, int i, int j,
                       taut_pipe_patch *patch);
void taut_pipe_patch_halve(taut_arena *arena, const taut_pipe_patch *patch, int direction,
                           taut_pipe_patch halves[2]);

/* The torus about an arc: is the surface it? (torus.c) */
void taut_pipe_cover_torus(const taut_pipe_parts *parts, const taut_surface *surface,
                           const taut_pipe_circle *circle, double tolerance,
                           taut_pipe_cover *cover);

/* +1: f is proved to be positive everywhere; -1: it is not so somewhere, rounding counted; 0: neither
 * is known (bent.c). *left: the pieces that may still be looked at. */
int taut_pipe_sign_of(taut_arena *arena, const taut_field *f, int *left);

/* How often the rings go around the axis, +1 or -1; 0 where that is not so or not proved, with the
 * reason. The first ring is looked at; the others go around as often where the tube is proved. */
int taut_pipe_winding(taut_arena *arena, const taut_pipe_sweep *sweep, taut_pipe_cover *cover);
/* How far the last point of a ring is from its first, at most, over the radius. */
double taut_pipe_ring_gap(taut_arena *arena, const taut_pipe_sweep *sweep);

/* Both, as far as they make the surface what it should be: what taut_pipe_winding returns. */
int taut_pipe_cover_rings(taut_arena *arena, const taut_pipe_sweep *sweep, taut_pipe_cover *cover);
/* The radius from one of parts->ellipses to the other, as sections change (section.c). */
void taut_pipe_sweep_radii(taut_arena *arena, taut_pipe_sweep *sweep);
/* Is the surface the tube of circles? TAUT_NO_MEMORY. */
taut_status taut_pipe_cover_round(const taut_pipe_sweep *sweep, taut_pipe_cover *cover);

#endif /* TAUT_CERTIFY_PIPE_SWEEP_H */
