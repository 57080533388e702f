/* modes_lent.h -- modes for a solver, lent: where one problem follows another on the same bases, as in a page whose hand drags,
 * they may be those of the last (src/web/modes_lent.c). Elsewhere they are new, and nothing is kept. */
#ifndef TAUT_NUMERIC_MODES_LENT_H
#define TAUT_NUMERIC_MODES_LENT_H

#include "numeric/modes.h"

/* As taut_modes_new. */
taut_status taut_modes_lend(const taut_band *k, const taut_band *m, taut_pulse *pulse,
                            const taut_modes **modes);
void taut_modes_give_back(const taut_modes *modes); /* NULL is fine */

#endif /* TAUT_NUMERIC_MODES_LENT_H */
