/* lengths.h -- how long the edges of pieces are, flat and on the surface. */
#ifndef TAUT_CERTIFY_PATTERN_LENGTHS_H
#define TAUT_CERTIFY_PATTERN_LENGTHS_H

#include "certify/pattern/cloth.h"

/* Fills `lengths` and `flat_lengths` of all pieces. TAUT_INTERRUPTED. */
taut_status taut_cloth_measure_edges(taut_cloth *cloth);

/* Of a line of the model between two of its parameters, by a rule of TAUT_CLOTH_FEW nodes, times 2^-unit. */
enum { TAUT_CLOTH_FEW = 4 };
double taut_cloth_length_between(const taut_cloth *cloth, const taut_curve *line, double a,
                                 double b, const double nodes[TAUT_CLOTH_FEW],
                                 const double weights[TAUT_CLOTH_FEW]);

#endif /* TAUT_CERTIFY_PATTERN_LENGTHS_H */
