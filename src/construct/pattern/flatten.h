/* flatten.h -- all pieces of a layout laid flat, in two passes.
 *
 *     1. each piece alone, no edge held; developable ones by quadrature
 *     2. each piece again, its seams held: at the mean of the speeds that both sides have alone, or at the length of
 *        the surface less the compensation, as other edges are that are to be held
 */
#ifndef TAUT_CONSTRUCT_PATTERN_FLATTEN_H
#define TAUT_CONSTRUCT_PATTERN_FLATTEN_H

#include "construct/pattern/layout.h"
#include "core/crew.h"

/* What is asked of all pieces. */
typedef struct taut_pattern_cut {
    taut_pattern_seam_length seam_length;
    taut_flat_law law;
    int has_law; /* nonzero, or the squares of all strains are made least */
    taut_pattern_compensation compensation;
    double thread;
    double tolerance; /* of lengths, over the size; 0: that of the first splines */
    taut_pattern_held held;
    int is_straight;  /* start and end of pieces are */
    int is_conformal; /* angles are kept, and seams have the surface's length */
    int decompensate_count;
    const taut_pattern_decompensate *decompensate;
} taut_pattern_cut;

/* Is an edge held to which nothing is sewn? */
int taut_pattern_is_held(const taut_pattern_cut *cut, const taut_pattern_piece *piece, int edge);

/* |y_x| that an edge is held at, and its derivative by x, s or t along it, in the carrier's unit; 0 where it is free. */
int taut_pattern_held_speed(const taut_pattern_layout *layout, const taut_pattern_cut *cut,
                            int piece, int edge, double x, double speed[2]);

/* The stretch over the surface that a piece along a side has alone, at a share x of the side. */
double taut_pattern_own_stretch(const taut_pattern_layout *layout, const taut_pattern_side *side,
                                const taut_pattern_holder *holder, double x);

/* Fills alone and flat of every piece, of as many spans as each is to have, or 16 x 4 where it does not say. TAUT_NO_MEMORY,
 * TAUT_INTERRUPTED; TAUT_NOT_CONVERGED, reasons folds and not-converged. */
taut_status taut_pattern_flatten(taut_pattern_layout *layout, const taut_pattern_cut *cut,
                                 const taut_crew *crew, taut_error *error);

/* Of pieces alone: how much energy the cloth would hold with its thread turned by pi/4, over what it holds. NaN where the law has no
 * direction, no piece is strained, or one was not found. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_pattern_bias(const taut_pattern_layout *layout, const taut_pattern_cut *cut,
                              const taut_crew *crew, double *bias, taut_error *error);

#endif /* TAUT_CONSTRUCT_PATTERN_FLATTEN_H */
