/* pipe_runs.h -- runs of pipes, given and random. */
#ifndef TAUT_TEST_PIPE_RUNS_H
#define TAUT_TEST_PIPE_RUNS_H

#include "pipes.h"

enum { LEGS = 12 };

/* Four corners, and three straight pipes, the second with a direction only. */
extern const double pipe_stair[4][3];
extern const taut_pipe_leg pipe_placed[3];
/* A run along them, of radius 0.2. */
taut_pipe_run_problem pipe_run_of_corners(const double (*corners)[3], int count);
taut_pipe_run_problem pipe_run_of_legs(const taut_pipe_leg *legs, int count);

/* As of single pipes: pipes.h. */
taut_model *pipe_run_made(const taut_pipe_run_problem *problem, double tolerance);
taut_certificate *pipe_run_proved(const taut_model *model, const taut_pipe_run_problem *problem,
                                  double tolerance);
taut_error pipe_run_refused(const taut_pipe_run_problem *problem, taut_status status,
                            const char *reason);
taut_verdict pipe_run_verdict(const taut_model *model, const taut_pipe_run_problem *problem,
                              const char *name);

/* A problem with the places it points to. */
typedef struct pipe_random {
    taut_pipe_run_problem problem;
    double corners[LEGS][3];
    taut_pipe_leg legs[LEGS];
} pipe_random;

/* Corners of a random walk (kind 0), of a square stair that winds over itself more closely than it
 * bends (1), of a closed ring (2); or straight pipes with directions of their own (3). */
void pipe_random_run(int kind, pipe_random *r);
/* Again, where it was copied. */
void pipe_attach(pipe_random *r);
/* Made coarsely; where legs are too short, or the pipe too wide, with what is told to work. */
taut_model *pipe_random_made(pipe_random *r, double tolerance);

#endif /* TAUT_TEST_PIPE_RUNS_H */
