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

/* Of the quadratures that judge a choice: those of searches, and of their last steps. */
enum { TAUT_PIPE_INTERVALS = 4, TAUT_PIPE_INTERVALS_FINE = 16 };

typedef struct taut_pipe_task {
    const taut_pipe_problem *problem;
    const taut_monitor *monitor; /* or NULL; asked before each axis that is tried */
    int is_stopped;              /* it said so: no other axis is tried */
    double outer; /* the user's unit: the radius, or that of the circle around the larger section */
    taut_arena *arena;
    double scale;       /* a power of two: local = (x - origin) / scale */
    double radius;      /* outer, local */
    double bend_radius; /* local; 0: none asked for */
    double lengths[2];  /* of the straight pipes, the user's unit; INFINITY: half lines */
    double tails[2];    /* the same, local */
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
    int intervals;             /* of the quadrature that judges a choice, one of the two below */
    taut_pipe_nodes *nodes[2]; /* of arcs of a degree, by so many intervals */
    int nodes_degree;          /* 0: not filled */
    int evaluations;           /* of the choices */
    int chose_shape;
} taut_pipe_task;

taut_status taut_pipe_check_length(double value, const char *where, taut_error *error);
taut_status taut_pipe_check_point(const double point[3], const char *where, taut_error *error);
/* The power of two at or below a size: dividing by it is exact. */
double taut_pipe_power_below(double size);

/* The options' tolerance, or the default; TAUT_BAD_ARGUMENT for one below what rounding leaves. */
taut_status taut_pipe_tolerance(const taut_make_options *options, double *tolerance,
                                taut_error *error);
/* Is each choice one of 0 .. last? */
typedef struct taut_pipe_choice {
    const char *where;
    int chosen, last;
} taut_pipe_choice;
taut_status taut_pipe_check_choices(const taut_pipe_choice *choices, size_t count,
                                    taut_error *error);

/* Checks the numbers, and fills the task up to `across`; handles that are given, 0 for others. */
taut_status taut_pipe_begin(taut_pipe_task *task, taut_error *error);
/* The edges for given handles, before anything is rounded. */
void taut_pipe_edges(const taut_pipe_task *task, const double handles[2], double edges[3][3]);
/* The arc with these edges and shape numbers, of the kind the joints ask for. */
void taut_pipe_arc_of(const taut_pipe_task *task, const double edges[3][3], const double shape[3],
                      taut_pipe_arc *arc);
/* The polygon from handles, and the local edges from the polygon. */
taut_status taut_pipe_settle(taut_pipe_task *task, taut_error *error);

/* Tells the monitor that work goes on; nonzero, from then on, when it asks to stop. */
int taut_pipe_is_stopped(taut_pipe_task *task, const char *what);

/* Handles that are not given, shape numbers that are not (choose.c). */
void taut_pipe_choose_handles(taut_pipe_task *task);
taut_status taut_pipe_choose_shape(taut_pipe_task *task, taut_error *error);

/* All of this in turn, to the axis with its bends, refused where it has a cusp or bends more
 * sharply than asked for (decide.c). name: of the axis in messages. TAUT_INTERRUPTED. */
taut_status taut_pipe_decide(taut_pipe_task *task, const char *name, taut_error *error);
/* Which radius would work, in words; none where the axis meets itself. */
void taut_pipe_describe_radius(double rho, char *text, size_t size);

#endif /* TAUT_PIPE_TASK_H */
