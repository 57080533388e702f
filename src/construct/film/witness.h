/* witness.h -- fields that show how near a sail in space is to the least energy of all.
 *
 * Those of construct/film/flows.h with the largest D, by a barrier over places in the quadrilateral; where a
 * length is found to be large between the places, more are put. They go into the model, for the
 * certificate to judge, and need no trust.
 */
#ifndef TAUT_CONSTRUCT_FILM_WITNESS_H
#define TAUT_CONSTRUCT_FILM_WITNESS_H

#include "taut/film.h"
#include "taut/monitor.h"
#include "taut/record.h"

/* Adds details.least, of a film whose corners are held and lie in no plane: else none is needed, or none
 * known. forces: of the cables, over the tension; 0: no cable. TAUT_OK, also where there is no
 * witness; TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_film_witness_add(const taut_film_problem *problem, const taut_surface *surface,
                                  const double radii[4], const taut_monitor *monitor,
                                  taut_record *details);

#endif /* TAUT_CONSTRUCT_FILM_WITNESS_H */
