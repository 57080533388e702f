/* task.h -- one pipe at work: the problem in local coordinates, and what is decided on the way. */
#ifndef TAUT_PIPE_TASK_H
#define TAUT_PIPE_TASK_H

#include "construct/pipe/reach.h"
#include "core/arena.h"
#include "taut/pipe.h"

/* A pipe is made only about an axis whose largest radius leaves this much room when it is chosen:
 * at rho itself the surface has a crease. */
#define TAUT_PIPE_ROOM 0.999
/* A bend made to have a radius of curvature is made so much larger. */
#define TAUT_PIPE_SLACK 1e-7

typedef struct taut_pipe_task {
    const taut_pipe_problem *problem;
    taut_arena *arena;
    double scale;       /* a power of two: local = (x - origin) / scale */
    double radius;      /* local */
    double bend_radius; /* local; 0: none asked for */
    double tails[2];    /* local; INFINITY: half lines */
    /* where the ends are, local to the origin of `base` */
    double base[3];          /* absolute: V_0, or the first line's foot */
    double directions[2][3]; /* unit, of flow; not used with a polygon */
    double across[3];        /* V_3 - V_0, or foot 2 - foot 1 */
    double handles[2];       /* local */
    double shape[3];
    /* decided */
    double polygon[4][3]; /* absolute, as it goes into the model */
    double edges[3][3];   /* local, of that polygon */
    taut_pipe_arc arc;
    taut_pipe_bend bend;
    taut_pipe_reach reach;
    double *reach_scratch;
    int panels;      /* of the quadrature that judges a choice */
    int evaluations; /* of the choices */
    int chose_handles, chose_shape;
} taut_pipe_task;

taut_status taut_pipe_check_length(double value, const char *where, taut_error *error);
taut_status taut_pipe_check_point(const double point[3], const char *where, taut_error *error);
/* The power of two at or below a size: dividing by it is exact. */
double taut_pipe_power_below(double size);

/* Checks the numbers, and fills the task up to `across`; handles that are given, 0 for others. */
taut_status taut_pipe_begin(taut_pipe_task *task, taut_error *error);
/* The edges for given handles, before anything is rounded. */
void taut_pipe_edges(const taut_pipe_task *task, const double handles[2], double edges[3][3]);
/* Handles that are not given (choose_handles.c), shape numbers that are not (choose_shape.c). */
taut_status taut_pipe_choose_handles(taut_pipe_task *task, taut_error *error);
taut_status taut_pipe_choose_shape(taut_pipe_task *task, taut_error *error);
/* The arc with these edges and shape numbers, of the kind the joints ask for. */
void taut_pipe_arc_of(const taut_pipe_task *task, const double edges[3][3], const double shape[3],
                      taut_pipe_arc *arc);
/* The polygon from handles, and the local edges from the polygon. */
taut_status taut_pipe_settle(taut_pipe_task *task, taut_error *error);

/* What a choice is worth: `goal` where the pipe fits, with room; else 1e200 and more, growing with
 * what is missing. */
typedef enum taut_pipe_goal {
    TAUT_PIPE_BENDING,
    TAUT_PIPE_CURVATURE,
    TAUT_PIPE_FAIRNESS
} taut_pipe_goal;
/* TAUT_PIPE_FAIRNESS: length times bending, which no scaling changes. A value that is not below
 * `bound` may come back without a look at other parts of the pipe. */
double taut_pipe_merit(taut_pipe_task *task, const double edges[3][3], const double shape[3],
                       taut_pipe_goal goal, double bound);

/* The axis of the polygon and shape that were settled, with its bends; reach apart from it. */
void taut_pipe_analyse(taut_pipe_task *task);
/* Which radius would work, in words; none where the axis meets itself. */
void taut_pipe_say_radius(double rho, char *text, size_t size);
/* NOT_REGULAR and BEND_RADIUS. */
taut_status taut_pipe_judge_bends(const taut_pipe_task *task, const char *name, taut_error *error);
/* A run: from its check to its model. */
taut_status taut_pipe_run_make(const taut_pipe_problem *problem, double tolerance,
                               taut_model **model, taut_error *error);

#endif /* TAUT_PIPE_TASK_H */
