/* seams.h -- where surfaces of one model meet: edges that are the same curve, point by point.
 *
 * Edge 4 i + e is edge e of surface i: e = 0, 1, 2, 3 for u0, u1, v0, v1.
 */
#ifndef TAUT_MESH_SEAMS_H
#define TAUT_MESH_SEAMS_H

#include "core/arena.h"
#include "taut/surface.h"

/* Two edges a > b with the same points at the same share of their ranges, or, reversed, at shares
 * that sum to 1. */
typedef struct taut_seam {
    int a, b, reversed;
} taut_seam;

/* The seams among surfaces[count], each edge with at most one earlier one (in an order of its own),
 * and collapsed[4 count]: nonzero where an edge is a single point; both judged on samples, within
 * `tolerance`, a length. All from the arena. TAUT_NO_MEMORY.
 * Cost: a sort of the edges, and a comparison for pairs with the same middle. */
taut_status taut_seams_find(const taut_surface *const *surfaces, int count, double tolerance,
                            taut_arena *arena, taut_seam **seams, int *seam_count,
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

#endif /* TAUT_MESH_SEAMS_H */
