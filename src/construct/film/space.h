/* space.h -- the net of a film before it is solved: what is held, and where the rest starts. */
#ifndef TAUT_CONSTRUCT_FILM_SPACE_H
#define TAUT_CONSTRUCT_FILM_SPACE_H

#include "construct/common/mask.h"
#include "construct/common/scaling.h"
#include "construct/film/edges.h"
#include "core/arena.h"
#include "geometry/nurbs/loop.h"
#include "taut/film.h"

/* What a cable does, scaled. */
typedef struct taut_film_cable {
    double length;    /* given; else 0 */
    double stiffness; /* elastic: force over tension per length; else 0 */
    double target;    /* elastic: its unstressed length */
    double start; /* the length that the force of the start belongs to; 0 where force is given */
} taut_film_cable;

typedef struct taut_film_space {
    const taut_film_problem *problem;
    int nu, nv;
    size_t count;         /* nu nv */
    double corners[4][3]; /* u0v0, u1v0, u0v1, u1v1 */
    double deviation;     /* of fitted edges from their curves */
    double size;          /* of the boundary: of a point of it from the first corner */
    const taut_loop
        *around;    /* of the direction that goes around, or NULL; nets are on its functions then */
    double *points; /* [nu][nv][3]: what is held, in the user's unit; else 0 */
    unsigned char *known;    /* [nu][nv] */
    int *leader;             /* [nu][nv] as a mask has them, or NULL */
    double *allowed;         /* [nu][nv][6] as a mask has them, or NULL */
    taut_mask mask;          /* of known */
    double *greville[2];     /* [nu], [nv]: abscissae over [0, 1] */
    taut_scaling scaling;    /* of the points held */
    double *given;           /* [nu][nv][3]: the start of the problem (begin.h), or NULL */
    int has_inside;          /* does it have points inside? */
    double *start;           /* [nu][nv][3], scaled: chords for cables, a Coons net inside */
    double ratios[4];        /* force over tension of each cable, in the scaled unit; 0: no cable.
                           * Where it is not given, that of the arc of a circle over its chord */
    unsigned char is_arc[4]; /* is it a cable whose flat film would have this arc? */
    taut_film_cable cables[4];
} taut_film_space;

/* The force of cable e, in the user's unit, at `share` of its ratio. */
double taut_film_force(const taut_film_space *space, int e, double share);

/* All of it, in the arena. TAUT_BAD_INPUT, TAUT_NO_SOLUTION, TAUT_NOT_CONVERGED by the reasons of
 * taut/film.h; TAUT_NO_MEMORY. */
taut_status taut_film_space_new(const taut_film_problem *problem, taut_arena *arena,
                                taut_film_space *space, taut_error *error);

/* Lays the inside of net double[nu][nv][3] between its edges: a net of Coons, of a ring straight lines. */
void taut_film_space_fill(const taut_film_space *space, double *net);

#endif /* TAUT_CONSTRUCT_FILM_SPACE_H */
