/* density.h -- where a film is how far from least, by the witness that its model carries.
 *
 *     d(u, v) = 1 - m . X,     m the film's unit normal, X the field of psi (docs/least.md)
 *
 * is the gap at a point for each unit of area: 0 where the field blows square to the film. To be
 * looked at: what is proved is the certificate's.
 */
#ifndef TAUT_MEASURE_DUAL_DENSITY_H
#define TAUT_MEASURE_DUAL_DENSITY_H

#include "taut/record.h"
#include "taut/surface.h"

typedef struct taut_dual_density taut_dual_density;

/* Of the witness details.least. *density is NULL where it is none, or not over the range of the
 * film. TAUT_NO_MEMORY. */
taut_status taut_dual_density_new(const taut_surface *film, const taut_record *details,
                                  taut_dual_density **density);
void taut_dual_density_free(taut_dual_density *density); /* NULL is fine */

/* d at a point of the closed range; NaN where the film has no normal, or psi is too steep. */
double taut_dual_density_at(const taut_dual_density *density, double u, double v);

#endif /* TAUT_MEASURE_DUAL_DENSITY_H */
