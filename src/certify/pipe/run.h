/* run.h -- a finished run taken apart, for its certificate. */
#ifndef TAUT_CERTIFY_PIPE_RUN_H
#define TAUT_CERTIFY_PIPE_RUN_H

#include "certify/pipe/parts.h"

typedef struct taut_pipe_run_parts {
    taut_pipe_parts parts; /* line: all pieces; radius, sizes, figures, problem */
    const taut_model *model;
    int count;                     /* of pieces, straight or not, in the order of flow */
    const taut_surface **surfaces; /* "pipe1", "blend1", ... */
    const taut_curve **curves;     /* their axes */
    double bend_radius;            /* asked for; 0: none */
} taut_pipe_run_parts;

int taut_pipe_is_blend(const taut_pipe_run_parts *run, int piece);
/* The unit tangent at t in [0, 1] of a piece. */
void taut_pipe_run_tangent(const taut_pipe_run_parts *run, int piece, double t, double tangent[3]);
/* The claim `ends`: run_ends.c. */
taut_status taut_pipe_claim_run_ends(const taut_pipe_run_parts *run, taut_certificate *certificate);

#endif /* TAUT_CERTIFY_PIPE_RUN_H */
