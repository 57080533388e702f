/* film_complex.h -- films of many patches: which points of their nets are one, and what holds them.
 *
 *     seams    points of edges that are one curve, in the order that each is run
 *     poles    all points of an edge
 *
 * make the classes of points, `nodes`. A node is held on planes n . x = c, up to three of them in general position: by the
 * planes of slides and cables, by corners that are held or kept on a line or in a plane, by edges that are held whole.
 *
 *     inside   a point inside a patch or of a seam of two without a cable
 *     line     a point of a cable, a slide, a seam of three or more; a corner where two of one kind run on into each other
 *     vertex   where other lines end
 */
#ifndef TAUT_PROBLEM_FILM_COMPLEX_H
#define TAUT_PROBLEM_FILM_COMPLEX_H

#include "core/arena.h"
#include "taut/film.h"

typedef enum taut_film_node_kind {
    TAUT_FILM_NODE_HELD, /* with a whole edge, or as a corner */
    TAUT_FILM_NODE_INSIDE,
    TAUT_FILM_NODE_LINE,
    TAUT_FILM_NODE_VERTEX
} taut_film_node_kind;

/* n . x = c for each of `count`; n unit and orthogonal. */
typedef struct taut_film_hold {
    int count;
    double normals[3][3], offsets[3];
} taut_film_hold;

/* Edges with a cable: edges of patches, then seams. */
typedef struct taut_film_strand {
    taut_film_side side; /* where its points lie: not reversed */
    const taut_film_edge *edge;
    int seam; /* -1: an edge of its own */
    int rope; /* the cable that it is part of */
} taut_film_strand;

/* A cable: one strand, or those of one along several edges; in the order of figures: of edges, of seams, then along several
 * (problem/film_ropes.h). */
typedef struct taut_film_rope {
    const taut_film_edge *edge; /* its law */
    int along;                  /* which of the problem's along several edges; -1: of one strand */
    int strand;                 /* its first */
    int ends[2];                /* nodes: the same where it closes */
} taut_film_rope;

typedef struct taut_film_complex {
    const taut_film_problem *problem;
    int points; /* of all nets, patch by patch, [nu][nv] */
    int *first; /* [patch_count + 1] */
    int *node;  /* [points] */
    int nodes;
    unsigned char *kind;   /* [nodes] */
    unsigned char *fixed;  /* [nodes]: on an edge that is held whole */
    taut_film_side *line;  /* [nodes]: of a point of a line, one of its edges */
    int *at;               /* [nodes]: of such a point, which of the edge */
    taut_film_hold *holds; /* [nodes] */
    int strand_count;
    taut_film_strand *strands;
    int rope_count;
    taut_film_rope *ropes;
} taut_film_complex;

/* A film of one patch as one of many: what stands here lives as long as it does. */
typedef struct taut_film_lone {
    taut_film_problem problem, patch;
    taut_film_side sides[2];
    taut_film_seam seam; /* of a ring */
} taut_film_lone;

/* Has a film of one patch, which does not go around, an edge that is a point? */
static inline int taut_film_has_tip(const taut_film_problem *problem)
{
    int has = 0;
    for (int e = 0; e < 4; e++) {
        has |= problem->edges[e].kind == TAUT_FILM_POLE;
    }
    return has && problem->ring == TAUT_FILM_OPEN;
}

/* Is the film one that is made and certified as those of many patches are? */
static inline int taut_film_is_complex(const taut_film_problem *problem)
{
    return problem->patch_count > 0 || problem->cell_count > 0 || problem->along_count > 0 ||
           taut_film_has_tip(problem);
}

/* The problem itself, or one of one patch in its room, whose edges go without the patch's name. */
const taut_film_problem *taut_film_complex_of(const taut_film_problem *problem,
                                              taut_film_lone *room);
/* Where something of a film of one patch is, without "/patches/0". */
void taut_film_complex_where(const taut_film_problem *problem, taut_error *error);
/* "NAME.PART", of a film of one patch "PART": an edge, a corner. */
enum { TAUT_FILM_NAME = 96 };
void taut_film_complex_name(const taut_film_problem *problem, int patch, const char *part,
                            char name[TAUT_FILM_NAME]);

/* Point k of an edge among those of its patch. */
int taut_film_complex_point(const taut_film_problem *patch, int edge, int k);
/* How many. */
int taut_film_complex_along(const taut_film_problem *patch, int edge);
/* Point k of a side, as it is run, among all, and its node. */
int taut_film_complex_run(const taut_film_complex *complex, const taut_film_side *side, int k);
int taut_film_complex_node(const taut_film_complex *complex, const taut_film_side *side, int k);
/* The seam that an edge is in, or -1. */
int taut_film_complex_seam(const taut_film_problem *problem, int patch, int edge);

/* The largest distance of given corners and of control points of held curves from the first. */
double taut_film_complex_size(const taut_film_problem *problem);
/* The corner at the first (0) or last (1) end of an edge. */
int taut_film_edge_corner(int edge, int end);
/* The node of a corner: u0v0, u1v0, u0v1, u1v1. */
int taut_film_complex_corner(const taut_film_complex *complex, int patch, int corner);

/* One plane more. 0: it does not meet the others, by more than `gap`. */
int taut_film_hold_add(taut_film_hold *hold, const double normal[3], double offset, double gap);
/* x is moved onto them by the shortest way. */
void taut_film_hold_onto(const taut_film_hold *hold, double x[3]);

/* Unit vectors, orthogonal, along which it leaves a node free: how many; the hold has them too then. */
int taut_film_hold_left(taut_film_hold *hold, double *ways);
/* x_t of the line of a node at its Greville abscissa. points: [points][3]. */
void taut_film_complex_tangent(const taut_film_complex *complex, const double *points, int node,
                               double t[3]);

/* In the arena. TAUT_BAD_INPUT: edge-conflict, seam-mismatch, corner-conflict, corner-missing, curve-ends, value.
 * TAUT_NO_SOLUTION: floating. TAUT_NO_MEMORY. */
taut_status taut_film_complex_new(const taut_film_problem *problem, taut_arena *arena,
                                  taut_film_complex *complex, taut_error *error);

#endif /* TAUT_PROBLEM_FILM_COMPLEX_H */
