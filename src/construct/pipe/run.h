/* run.h -- a run of pipes at work: straight ones with a blend between each two.
 *
 *     1  where the straight pipes are, and the shape of each blend                    run_legs.c
 *     2  one axis of all, its largest radius, the verdict                             run.c
 *     3  the frame carried through, the blends as NURBS                               run_sweep.c
 *     4  the model                                                                    run_model.c
 */
#ifndef TAUT_PIPE_RUN_H
#define TAUT_PIPE_RUN_H

#include "construct/pipe/blend.h"
#include "construct/pipe/task.h"

/* A straight pipe; absolute. */
typedef struct taut_pipe_straight {
    double from[3], to[3]; /* bit for bit the same: none, the blends meet */
    double direction[3];   /* unit */
    double length;
} taut_pipe_straight;

/* The blend from one straight pipe to the next. */
typedef struct taut_pipe_elbow {
    taut_pipe_problem problem;
    taut_pipe_task task;
    char name[24];
    double cosine;   /* of its turn, at a corner */
    double first[3]; /* the frame's vector at its start, */
    double turn;     /* and the angle it turns about the rotation-minimising one on the way */
    taut_pipe_blend blend;
    double *points; /* double[rows][TAUT_PIPE_RING][3], absolute */
} taut_pipe_elbow;

typedef struct taut_pipe_run {
    const taut_pipe_run_problem *problem;
    const taut_monitor *monitor; /* or NULL */
    taut_arena *arena;
    double bend_radius; /* asked for, or three radii at corners; 0: none */
    int closed;
    int straight_count;
    taut_pipe_straight *straights;
    int elbow_count; /* elbow i follows straight pipe i */
    taut_pipe_elbow *elbows;
    double origin[3], scale; /* of the whole: local = (x - origin) / scale */
    taut_pipe_reach reach;
    double holonomy; /* of a closed run: from the frame that comes round to the one that started */
} taut_pipe_run;

/* The numbers checked, straights and elbows settled, each elbow on its own. */
taut_status taut_pipe_run_lay(taut_pipe_run *run, taut_error *error);
taut_status taut_pipe_run_sweep(taut_pipe_run *run, double tolerance, taut_error *error);
taut_status taut_pipe_run_model(taut_pipe_run *run, taut_model **model, taut_error *error);

#endif /* TAUT_PIPE_RUN_H */
