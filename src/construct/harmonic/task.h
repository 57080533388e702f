/* task.h -- one completion at work: the data turned so that the known rows run along v. */
#ifndef TAUT_HARMONIC_TASK_H
#define TAUT_HARMONIC_TASK_H

#include "construct/harmonic/lidstone.h"
#include "construct/harmonic/unit_map.h"
#include "core/arena.h"
#include "core/pulse.h"
#include "taut/harmonic.h"

typedef struct taut_harmonic_task {
    const taut_harmonic_problem *problem;
    taut_arena *arena;
    taut_pulse *pulse; /* told of the work; once it says stop the net has no meaning */
    int turned;        /* nonzero: the known lines are columns, so u and v change places in here */
    int n;             /* degree across the known rows; may grow by one when raised */
    int m;             /* degree along them */
    taut_twice mu;     /* (width across / width along)^2 */
    taut_unit_map map;
    double *row[2]; /* double[m+1][3], in unit size: two rows, or a row and the derivative across by
                     * parameter length; `width` times it is that by the normalised parameter */
    double width;
    int corner_missing;
    taut_harmonic_even repair; /* that was made; TAUT_EVEN_REFUSE: none */
    double repair_change;      /* the largest move of a given point, in the user's unit */
    double amplification;
    double *net;        /* double[n+1][m+1][3], turned as the rows are */
    const char **texts; /* of the same, in rational arithmetic; else NULL */
} taut_harmonic_task;

/* What the problem asks for where data of even degree does not agree. */
taut_harmonic_even taut_harmonic_even_of(const taut_harmonic_problem *problem);

/* Reads the known points into task->row; TAUT_BAD_INPUT where their mask is none of those that the
 * construction knows. */
taut_status taut_harmonic_collect(taut_harmonic_task *task, taut_error *error);
/* Makes rows of even degree agree in the way the problem asks for, or refuses. */
taut_status taut_harmonic_agree(taut_harmonic_task *task, taut_error *error);

/* In rational arithmetic, in place of what follows taut_harmonic_collect. */
taut_status taut_harmonic_exact(taut_harmonic_task *task, taut_error *error);
/* Point j of line i of the turned net among the points of rows. */
size_t taut_harmonic_index(const taut_harmonic_task *task, int i, int j);
/* The nearest net to four boundary rows, in task->net, not turned. */
taut_status taut_harmonic_fit(taut_harmonic_task *task, taut_error *error);

#endif /* TAUT_HARMONIC_TASK_H */
