/* curve_baseline.c -- the kernels of curve_kernel.h for any processor. */
#define CURVE_WIDTH 2
#include "construct/asymptotic/curve_kernel_body.h"

const taut_curve_ops taut_curve_baseline = {.energy = curve_energy, .second = curve_second};
