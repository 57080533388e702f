/* told.h -- what the details of a finished model say, by the names of their members: for its structs. */
#ifndef TAUT_CONSTRUCT_COMMON_TOLD_H
#define TAUT_CONSTRUCT_COMMON_TOLD_H

#include "taut/model.h"

/* A list of details that have the member `mark`, which says of what construction they are; NULL: there is none. */
const taut_record *taut_told_list(const taut_model *model, const char *mark, const char *name);
/* Item i of such a list, where there is a place for what is told of it; `what` the model is, for the message. TAUT_BAD_ARGUMENT. */
taut_status taut_told_item(const taut_record *list, const char *what, const char *name, int i,
                           const void *place, const taut_record **found, taut_error *error);
/* A member: NaN or "" where there is none. */
double taut_told_number(const taut_record *at, const char *name);
const char *taut_told_text(const taut_record *at, const char *name);
/* The first `count` numbers of a list; NaN where it has fewer. */
void taut_told_numbers(const taut_record *at, const char *name, size_t count, double *out);

#endif /* TAUT_CONSTRUCT_COMMON_TOLD_H */
