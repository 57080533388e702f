/* seams.h -- where surfaces of one model meet: edges that are the same curve, point by point; lines
 * that agree there (share.c), and vertices that become one place (weld.c).
 *
 * Edge 4 i + e is edge e of surface i: e = 0, 1, 2, 3 for u0, u1, v0, v1.
 */
#ifndef TAUT_MESH_SEAMS_H
#define TAUT_MESH_SEAMS_H

#include "core/arena.h"
#include "taut/mesh.h"
#include "taut/surface.h"

/* Two edges a > b with the same points at the same share of their ranges, or, reversed, at shares
 * that sum to 1. */
typedef struct taut_seam {
    int a, b, reversed;
} taut_seam;

/* The seams among surfaces[count], each edge with at most one earlier one (in an order of its own),
 * and collapsed[4 count]: nonzero where an edge is a single point, which has no seam; both judged on
 * samples, within `tolerance` and `point`, lengths. All from the arena. TAUT_NO_MEMORY.
 * Cost: a sort of the edges, and a comparison for pairs with the same middle. */
taut_status taut_seams_find(const taut_surface *const *surfaces, int count, double tolerance,
                            double point, taut_arena *arena, taut_seam **seams, int *seam_count,
                            unsigned char **collapsed);

/* The direction (0: u, 1: v) that an edge runs along. */
static inline int taut_edge_along(int edge)
{
    return edge % 4 < 2;
}

/* A forest of sets whose members are equal to their root or mirrored: up[i] is a parent (i itself
 * at a root), flip[i] says whether i is mirrored against it. */
typedef struct taut_mirror_sets {
    int *up;
    unsigned char *flip;
    unsigned char *both; /* at a root: nonzero where a member is its own mirror image */
} taut_mirror_sets;

/* count sets of one member each; 0 when memory runs out. */
int taut_mirror_sets_new(int count, taut_arena *arena, taut_mirror_sets *sets);
/* The root of i; *flip is how i lies against it. */
int taut_mirror_root(taut_mirror_sets *sets, int i, int *flip);
void taut_mirror_unite(taut_mirror_sets *sets, int i, int j, int flip);

/* share.c: lines that agree wherever surfaces meet.
 *
 * Directions (u and v of all surfaces) that meet along a seam are cut alike: at the breaks of all
 * of them, and between these into as many cells as the neediest asks for. What holds for one seam
 * holds for the opposite edge too, as a line runs across the whole surface; so directions hang
 * together in chains, such as the ribs of a tube. */
typedef struct taut_direction {
    const taut_basis *basis;
    const double *bending; /* [spans], as taut_cell_count wants them */
    double wish;           /* cells in all, whole; perhaps too large for any use */
    double *lines;         /* double[wish + 1] */
} taut_direction;

/* How the directions hang together. */
typedef struct taut_chains {
    taut_direction *directions; /* 2 i and 2 i + 1: u and v of surface i */
    int count;
    taut_mirror_sets sets;
    int *first, *next; /* the members of the chain of a root, -1 at the end */
    double *breaks;    /* room for the breaks of the longest chain, twice, */
    double *cells;     /* and for as many cells */
    double tolerance;  /* chord error, a length */
    int divide;        /* cells a span, or 0 */
} taut_chains;

/* Chains of directions[count] along seams; TAUT_NO_MEMORY. A direction with a span narrower than
 * 1e-7 of its range is in no chain, and its seams stay open. */
taut_status taut_chains_new(taut_direction *directions, int count, const taut_seam *seams,
                            int seam_count, double tolerance, int divide, taut_arena *arena,
                            taut_chains *chains);
/* Sets each direction's wish; with `lay` nonzero its lines too, for which there must be room. */
void taut_chains_cut(taut_chains *chains, int lay);

/* weld.c: vertices along seams become one place, and surfaces that meet are turned alike. */
typedef struct taut_weld {
    const taut_seam *seams; /* edges count through the groups */
    int seam_count;
    const unsigned char *collapsed; /* [4 groups] */
    double tolerance;               /* a length */
    int own;                        /* nonzero: the vertices are control points */
    taut_mesh_group *groups;
    int group_count;
    double *positions; /* double[vertices][3]: welded ones take the place of the first of them */
    uint32_t *welded;  /* uint32_t[vertices], out: the first vertex at the same place */
    size_t vertex_count;
} taut_weld;

/* Welds the vertices of each seam whose two edges have as many, all within the tolerance, and those
 * of collapsed edges; sets groups[].turned. TAUT_NO_MEMORY. */
taut_status taut_weld_vertices(const taut_weld *weld);

#endif /* TAUT_MESH_SEAMS_H */
