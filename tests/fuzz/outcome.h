/* outcome.h -- what the fuzz targets hold every outcome against, beyond not crashing. */
#ifndef TAUT_TEST_FUZZ_OUTCOME_H
#define TAUT_TEST_FUZZ_OUTCOME_H

#include "taut/construct.h"

/* Ends the program when the condition is false: a finding. */
void require(int condition);
/* A refusal is told whole: the status, a sentence that ends. */
void require_error(taut_status status, const taut_error *error);
/* A model can be written, and what is written reads back to the same bytes; all points finite. */
void require_model(const taut_model *model);
/* The verdict is that of the claims; no claim holds by a NaN. */
void require_certificate(const taut_certificate *certificate);
/* Are the normals of every surface nowhere far from their mean? Where a surface folds over, its
 * area is an integral with kinks, which takes seconds here and has no monitor. */
int is_tame(const taut_model *model);
/* A monitor that stops work after so many seconds of this processor's time. */
taut_monitor patient_monitor(double seconds);

#endif /* TAUT_TEST_FUZZ_OUTCOME_H */
