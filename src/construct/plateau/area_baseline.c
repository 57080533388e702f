/* area_baseline.c -- the kernels of the area for any processor. */
#include <math.h>

#define AREA_LANES 2
#define AREA_SQRT(v) ((lanes){sqrt((v)[0]), sqrt((v)[1])})
#include "construct/plateau/area_kernel_body.h"

const taut_area_ops taut_area_baseline = AREA_OPS("baseline");
