/* pipe.h -- what a document of `pipe` asks for: one blend between two straight pipes, or a run. */
#ifndef TAUT_PROBLEM_PIPE_H
#define TAUT_PROBLEM_PIPE_H

#include "taut/pipe.h"

typedef struct taut_pipe_request {
    int is_run;
    union {
        taut_pipe_problem blend;
        taut_pipe_run_problem run;
    };
} taut_pipe_request;

#endif /* TAUT_PROBLEM_PIPE_H */
