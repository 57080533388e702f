/* lines.h -- the curves of a net as the certificate sees them: each curve of the model with its
 * stretches in the window, which the model's details give and which prove themselves.
 */
#ifndef TAUT_CERTIFY_TRACE_LINES_H
#define TAUT_CERTIFY_TRACE_LINES_H

#include "core/arena.h"
#include "taut/model.h"
#include "taut/trace.h"

typedef struct taut_net_line {
    const taut_curve *space;
    int index;                 /* of the model's curves */
    int family;                /* by its name: 0 for A and G, 1 for B */
    int count;                 /* of stretches, 0 where none fits */
    const taut_curve **window; /* [count], points (u, v, 0), in order; the arena's */
    int *on;                   /* [count]: in the window of which surface */
    double length;             /* of the range */
} taut_net_line;

typedef struct taut_net_lines {
    const taut_model *model;
    const taut_surface *surface; /* the first one */
    int surface_count;           /* 1, or of a net that goes on across seams all of the model's */
    taut_trace_net net;
    double
        size; /* largest distance of a control point from the first one's first, by coordinates */
    int count;
    taut_net_line *lines;
} taut_net_lines;

/* Reads them, in the arena; problem NULL: the net is that of details. TAUT_NO_MEMORY; TAUT_BAD_INPUT,
 * reason "details" or "model". */
taut_status taut_net_lines_new(taut_arena *arena, const taut_model *model,
                               const taut_trace_problem *problem, taut_net_lines *lines,
                               taut_error *error);

/* The window's place at t of a line, its range's, and the surface it is of; 0 where no stretch holds it. */
int taut_net_line_window(const taut_net_line *line, double t, double at[2], int *on);

/* The two curves that a node's name is made of, "A3B5" or "A3B5.2"; 0 where there are no such two. */
int taut_net_lines_of_node(const taut_net_lines *lines, const char *name,
                           const taut_net_line *both[2]);

#endif /* TAUT_CERTIFY_TRACE_LINES_H */
