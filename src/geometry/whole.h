/* whole.h -- a surface that lies on others of its model, as it is the whole of which they are the parts. */
#ifndef TAUT_GEOMETRY_WHOLE_H
#define TAUT_GEOMETRY_WHOLE_H

#include "taut/model.h"

/* Is surface i shown and exported where `name` is asked for? With NULL all are but the one that details.whole names, where
 * the model has others: what is there twice flickers in pictures and is no body. */
int taut_model_shows(const taut_model *model, const char *name, int i);

#endif /* TAUT_GEOMETRY_WHOLE_H */
