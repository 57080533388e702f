/* share.h -- lines that agree wherever surfaces meet.
 *
 * Directions (u and v of all surfaces) that meet along a seam are cut alike: at the breaks of all
 * of them, and between these into as many cells as the neediest asks for. What holds for one seam
 * holds for the opposite edge too, as a line runs across the whole surface; so directions hang
 * together in chains, such as the ribs of a tube.
 */
#ifndef TAUT_MESH_SHARE_H
#define TAUT_MESH_SHARE_H

#include "core/arena.h"
#include "mesh/seams.h"

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

#endif /* TAUT_MESH_SHARE_H */
