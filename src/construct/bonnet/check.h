/* check.h -- the legal problems. */
#ifndef TAUT_BONNET_CHECK_H
#define TAUT_BONNET_CHECK_H

#include "taut/bonnet.h"

/* TAUT_OK, TAUT_NO_SOLUTION or TAUT_BAD_INPUT as taut_bonnet_make has them. */
taut_status taut_bonnet_check(const taut_bonnet_problem *problem, taut_error *error);

#endif /* TAUT_BONNET_CHECK_H */
