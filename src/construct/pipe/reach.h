/* reach.h -- the largest radius a pipe about a composite axis can have without cutting itself.
 *
 *     rho = min( 1 / kappa_max,  1/2 min |c(s) - c(s')| over |s - s'| >= pi / kappa_max )
 *
 * c the axis by arc length: arcs one after the other, and a straight pipe at either end
 * ([WangBai2018] section 4.4). The tube of radius a is embedded where a < rho.
 */
#ifndef TAUT_PIPE_REACH_H
#define TAUT_PIPE_REACH_H

#include "construct/pipe/bend.h"
#include "core/pulse.h"

enum { TAUT_PIPE_REACH_SAMPLES = 400 };
#define TAUT_PIPE_REACH_ROOM(arcs) (4 * (size_t)(arcs) * (TAUT_PIPE_REACH_SAMPLES + 2))

typedef struct taut_pipe_composite {
    int count; /* arcs, tangent-continuous one after the other */
    const taut_pipe_arc *arcs;
    double tails[2];   /* lengths of the straight pipes before and after; INFINITY: half lines */
    int samples;       /* of an arc, at most TAUT_PIPE_REACH_SAMPLES; 0: so many */
    int closed;        /* nonzero: the last arc ends where the first begins; no tails */
    taut_pulse *pulse; /* or NULL; once it says stop the reach has no meaning */
} taut_pipe_composite;

typedef struct taut_pipe_reach {
    double radius;    /* rho; INFINITY for a straight axis */
    double curvature; /* the largest, */
    double curvature_at;
    int curvature_arc; /* and on which arc */
    int by_distance;   /* nonzero: a pair of points binds, 0: the curvature */
    double binding[2]; /* arc length from the start of the first arc: of the pair */
    int shortcut;      /* nonzero: the axis turns less than pi in all, so no pair can bind */
} taut_pipe_reach;

/* scratch: double[TAUT_PIPE_REACH_ROOM(count)]. Where all tails are 0 the ends of the arcs are
 * free ends, or joined. */
void taut_pipe_reach_of(const taut_pipe_composite *composite, double *scratch,
                        taut_pipe_reach *reach);

#endif /* TAUT_PIPE_REACH_H */
