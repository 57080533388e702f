/* area_baseline.c -- a film's kernels for any processor. */
#include <math.h>

#define FILM_LANES 2
#define FILM_SQRT(v) ((lanes){sqrt((v)[0]), sqrt((v)[1])})
#include "construct/plateau/area_kernel_body.h"

const taut_film_ops taut_film_baseline = FILM_OPS("baseline");
