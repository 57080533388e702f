/* cuts.h -- where a spline face is cut into several: at knots that are there as often as the degree.
 *
 * By its knots a surface is no more than continuous there, even if it is smooth, as the four quarters of a ring are: CAD
 * systems take it for a face with creases, which they neither thicken nor offset. Between such knots its net is a net of
 * its own with the same numbers, so that a cut costs nothing and moves nothing.
 *
 * An edge is cut where one of its faces is. A spline face is cut along a direction only if all that share an edge in that
 * direction have the same knots there; what has a name (elementary.h) stays whole, its edges are cut with the others'.
 * Directions of degree 1 are not cut, facets are creases, nor those that would be more than 16 pieces, as those of the
 * sides of sheets: a file of thousands of faces helps nobody.
 */
#ifndef TAUT_IO_STEP_CUTS_H
#define TAUT_IO_STEP_CUTS_H

#include "core/arena.h"
#include "io/step/elementary.h"
#include "shell/shell.h"
#include "taut/model.h"

/* Of a face, in the directions u and v. */
typedef struct taut_step_cuts {
    int pieces[2]; /* at least 1 */
    int *lines[2]; /* [pieces + 1] control points where pieces begin and end */
    int is_cut[2]; /* 0: it is whole, but its edges are cut there if others are */
} taut_step_cuts;

/* (*cuts)[faces], from the arena; of sheets all are whole. TAUT_NO_MEMORY. */
taut_status taut_step_find_cuts(const taut_model *model, const taut_shells *shells,
                                const taut_step_form *forms, int are_sheets, taut_arena *arena,
                                taut_step_cuts **cuts);

/* In how many pieces a face is along a direction. */
static inline int taut_step_pieces(const taut_step_cuts *cuts, int d)
{
#ifdef TAUT_WHOLE_FACES /* a build that has no room for cuts */
    (void)cuts;
    (void)d;
    return 1;
#else
    return cuts->is_cut[d] ? cuts->pieces[d] : 1;
#endif
}

/* The parameter of the control point at the beginning or the end of a piece. */
static inline double taut_step_parameter(const taut_basis *basis, int line)
{
    taut_basis_spec spec;
    taut_basis_spec_of(basis, &spec);
    return line == 0                             ? taut_basis_lo(basis)
           : line == taut_basis_count(basis) - 1 ? taut_basis_hi(basis)
                                                 : spec.knots[line + 1];
}

#endif /* TAUT_IO_STEP_CUTS_H */
