/* paired.h -- a number that no film is below whose sheets keep the same regions apart: paired calibrations of constant fields
 * ([LawlorMorgan1994]).
 *
 *     sheets part space into regions i; w_i a vector of each, |w_i - w_j| <= s for all pairs, along every plane that an edge slides in
 *     E >= D = sum over sheets (w_behind - w_ahead) . iint x_u x x_v du dv
 *
 * The flux of w_i out of region i is none; summed, what goes through sheets is what goes through the faces that close the regions
 * outside, between held edges, whatever the sheets do, and through planes nothing goes. D depends on the held edges alone.
 *
 * Regions are found at seams: the side of a sheet goes on on the next sheet around the seam. w comes from the film: behind a sheet and
 * ahead of it they differ by s times its mean normal. Of flat sheets that meet at 120 degrees D is E: walls over Fermat's point, the
 * cone over a tetrahedron's edges.
 */
#ifndef TAUT_CERTIFY_FILM_COMPLEX_PAIRED_H
#define TAUT_CERTIFY_FILM_COMPLEX_PAIRED_H

#include "certify/film/complex/sheets.h"

/* D in the user's unit, less what rounding may add; NaN where there is none: cells, cables, threads, several tensions, regions that
 * cannot be told. TAUT_NO_MEMORY. */
taut_status taut_complex_paired(const taut_sheets *sheets, double *bound);

#endif /* TAUT_CERTIFY_FILM_COMPLEX_PAIRED_H */
