/* shell.h -- which surfaces make one shell: faces, the edges and vertices they share, what is closed
 * and what is solid.
 *
 * Edge e of face f is 4 f + e, e = 0, 1, 2, 3 for u0, u1, v0, v1 (taut_edge). Its corners are 4 f + c,
 * c = 2 (u is high) + (v is high); it runs along its parameter from the first to the second:
 *
 *     u0: 0 1     u1: 2 3     v0: 0 2     v1: 1 3
 *
 * Two edges are one where the gap between them is proved, point for point (measure/join), to be at
 * most 1e-9 of the larger net, or what conversion to NURBS may have moved; where they run against
 * each other round faces that are turned alike; and where no third edge lies there too. Edges that are
 * one point are none; faces that lie on each other along an edge do not meet there. What meets along part of an edge, or at a corner only, is not joined.
 */
#ifndef TAUT_SHELL_SHELL_H
#define TAUT_SHELL_SHELL_H

#include "core/arena.h"
#include "taut/join.h"

/* An edge of one face or of two. */
typedef struct taut_shell_edge {
    int side[2];   /* 4 face + edge: the first gives the curve; the second, or -1 */
    int reversed;  /* the second runs against the first */
    int vertex[2]; /* where the curve begins and ends; the same where it is closed */
} taut_shell_edge;

typedef struct taut_shell_face {
    int shell;
    int turned;  /* its outside is where du x dv does not point */
    int edge[4]; /* -1: one point */
    int pole;    /* the vertex of the first such edge; -1 */
} taut_shell_face;

typedef struct taut_shell {
    int face_count, *faces; /* ascending */
    int closed;             /* no edge has one use only */
    int solid;              /* closed, and holds a volume; its faces are turned outwards */
} taut_shell;

typedef struct taut_shells {
    int face_count, edge_count, vertex_count, shell_count;
    taut_shell_face *faces;
    taut_shell_edge *edges;
    int *vertices;      /* the corner that is its place */
    taut_shell *shells; /* by their first faces */
    double gap;         /* the largest proved one of edges that were joined */
} taut_shells;

/* The shells of surfaces[count] on polynomial bases, all from the arena. `moved` is how far the
 * surfaces may be from what they stand for. TAUT_NO_MEMORY.
 * Cost: a sort of the edges, a proof for each two at the same place, and for closed shells one pass
 * over the surfaces. */
taut_status taut_shells_find(const taut_surface *const *surfaces, int count, double moved,
                             taut_arena *arena, taut_shells *shells);

/* The corner at the beginning (0) or the end (1) of edge 4 f + e. */
static inline int taut_shell_corner(int edge, int end)
{
    static const int corners[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
    return edge / 4 * 4 + corners[edge % 4][end];
}

/* Going round the parameters with the inside on the left: 1 where that is along edge 4 f + e. */
static inline int taut_shell_is_along(int edge)
{
    return edge % 4 == TAUT_EDGE_U1 || edge % 4 == TAUT_EDGE_V0;
}

#endif /* TAUT_SHELL_SHELL_H */
