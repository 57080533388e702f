/* pipe_runs.h -- runs of pipes, given and random. */
#ifndef TAUT_TEST_PIPE_RUNS_H
#define TAUT_TEST_PIPE_RUNS_H

#include "pipes.h"

enum { LEGS = 12 };

/* Four corners, and three straight pipes, the second with a direction only. */
extern const taut_pipe_leg pipe_stair[4], pipe_placed[3];
/* A run along legs, of radius 0.2. */
taut_pipe_problem pipe_run_of(taut_pipe_axis axis, const taut_pipe_leg *legs, int count);

/* A problem with the legs it points to. */
typedef struct pipe_request {
    taut_pipe_problem problem;
    taut_pipe_leg legs[LEGS];
} pipe_request;

/* Corners of a random walk (kind 0), of a square stair that winds over itself (1), of a closed ring
 * (2); or straight pipes with directions of their own (3). */
void pipe_random_run(int kind, pipe_request *r);
/* Again, where it was copied. */
void pipe_attach(pipe_request *r);
/* Made coarsely; where legs are too short, with the bend radius that is told to work. */
taut_model *pipe_run_made(pipe_request *r, double tolerance);

#endif /* TAUT_TEST_PIPE_RUNS_H */
