/* bases.h -- specs of bases for random ones. */
#ifndef TAUT_TEST_BASES_H
#define TAUT_TEST_BASES_H

#include "taut/basis.h"

/* "c-bezier", "c-bspline", "h-bezier" or "h-bspline" on spans of this length from `lo` on, of which
 * the splines have so many segments. The range counts once has_range is set; else it begins at 0.
 */
taut_basis_spec spec_of_spans(const char *type, double length, int segments, double lo);

/* Clamped knots from `lo` on with 1 to `most` spans and repeated inner ones; returns how many. */
int random_knots(int degree, int most, double lo, double *knots);

#endif /* TAUT_TEST_BASES_H */
