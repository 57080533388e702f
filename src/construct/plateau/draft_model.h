/* draft_model.h -- the draft of a surface of least area, from one that was there a moment ago. */
#ifndef TAUT_CONSTRUCT_PLATEAU_DRAFT_MODEL_H
#define TAUT_CONSTRUCT_PLATEAU_DRAFT_MODEL_H

#include "taut/model.h"
#include "taut/plateau.h"

/* So many steps (construct/plateau/draft.h). *model stays where there is no way from there: curves, weights, points to pass
 * through, a start, or other bases. The problem has been checked. */
taut_status taut_plateau_draft(const taut_plateau_problem *problem, const taut_model *before,
                               int steps, taut_model **model, taut_error *error);

#endif /* TAUT_CONSTRUCT_PLATEAU_DRAFT_MODEL_H */
