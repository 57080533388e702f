/* eight_baseline.c -- the kernels of eight.h for any processor. */
#include <math.h>

#define EIGHT_LANES 2
#define EIGHT_SQRT(v) ((lanes){sqrt((v)[0]), sqrt((v)[1])})
#include "measure/integrate/eight_body.h"

const taut_eight_ops taut_eight_baseline = EIGHT_OPS("baseline");
