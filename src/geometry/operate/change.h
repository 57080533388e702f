/* change.h -- the changes of basis behind taut/operations.h, with their arguments checked, and
 * the names of pieces. */
#ifndef TAUT_GEOMETRY_OPERATE_CHANGE_H
#define TAUT_GEOMETRY_OPERATE_CHANGE_H

#include "basis/change.h"

/* As the members of taut_change_ops, for a parameter or number of times that may be anything. */
taut_status taut_operate_split(const taut_basis *basis, double t, taut_change_list *list,
                               taut_error *error);
taut_status taut_operate_insert(const taut_basis *basis, double t, int times, taut_change **change,
                                taut_error *error);
taut_status taut_operate_elevate(const taut_basis *basis, int times, taut_change **change,
                                 taut_error *error);
taut_status taut_operate_rerange(const taut_basis *basis, double lo, double hi,
                                 taut_change **change, taut_error *error);

/* out: "<name>-<i>" with `dashes` of them, the name cut (between characters) if it is too long. */
void taut_operate_piece_name(const char *name, int dashes, int i, char out[TAUT_NAME_MAX + 1]);

/* TAUT_BAD_ARGUMENT for a NULL. */
taut_status taut_operate_null(taut_error *error);

#endif /* TAUT_GEOMETRY_OPERATE_CHANGE_H */
