/* run.h -- a run of pipes at work: straight ones with a blend between each two.
 *
 *     1  where the straight pipes are, and the shape of each blend                    run_legs.c
 *     2  one axis of all, its largest radius, the verdict                             run.c
 *     3  the frame carried through, the blends as NURBS                               run_sweep.c
 *        elbows that are arcs: all of this for them                                  run_arc.c
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

/* An elbow that is an arc, from `out` of its centre by `angle` towards `ahead`. */
typedef struct taut_pipe_round {
    double radius, angle;             /* angle 0: it is none */
    double centre[3];                 /* absolute */
    double out[3], ahead[3], axis[3]; /* unit */
} taut_pipe_round;

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
    taut_pipe_round round;
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
    struct taut_pipe_run *inner; /* the inside of the wall; NULL */
    double holonomy; /* of a closed run: from the frame that comes round to the one that started */
} taut_pipe_run;

/* The numbers checked, straights and elbows settled, each elbow on its own. */
taut_status taut_pipe_run_lay(taut_pipe_run *run, taut_error *error);
/* Of an elbow that is an arc, its polygon settled (angle 0 else): `round`; the parts of it, short enough
 * that a polynomial is as good, in coordinates about `origin` over `scale`, up to TAUT_PIPE_ROUND_PARTS; its
 * rings, and the frame's vector after it; its surface of this name and, where that is the elbow's, its axis. */
enum { TAUT_PIPE_ROUND_PARTS = 16 };
void taut_pipe_round_settle(const double from[3], const double to[3], taut_pipe_elbow *elbow);
int taut_pipe_round_parts(const taut_pipe_round *round, const double origin[3], double scale,
                          taut_pipe_arc parts[TAUT_PIPE_ROUND_PARTS]);
taut_status taut_pipe_round_sweep(taut_pipe_run *run, taut_pipe_elbow *elbow, double u[3],
                                  taut_error *error);
taut_status taut_pipe_round_add(const taut_pipe_run *run, const taut_pipe_elbow *elbow,
                                const char *name, const taut_basis *v, taut_model *model,
                                taut_error *error);

taut_status taut_pipe_run_sweep(taut_pipe_run *run, double tolerance, taut_error *error);
/* run->inner, swept about the same axes; for a run that was swept, with a wall. */
taut_status taut_pipe_run_sweep_inner(taut_pipe_run *run, double tolerance, taut_error *error);
taut_status taut_pipe_run_model(taut_pipe_run *run, taut_model **model, taut_error *error);

#endif /* TAUT_PIPE_RUN_H */
