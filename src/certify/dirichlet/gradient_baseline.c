/* gradient_baseline.c -- the kernels of gradient.c for any processor. */
#include <math.h>

#define SHEAF_LANES 2
#define SHEAF_SQRT(v) ((lanes){sqrt((v)[0]), sqrt((v)[1])})
#include "certify/dirichlet/gradient_kernel_body.h"

const taut_gradient_ops taut_gradient_baseline = GRADIENT_OPS("baseline");
