/* curve_avx2.c -- the kernels of curve_kernel.h for AVX2 (this file is compiled for it). */
#if defined(__x86_64__)
#define CURVE_WIDTH 4
#include "construct/asymptotic/curve_kernel_body.h"

const taut_curve_ops taut_curve_avx2 = {.energy = curve_energy, .second = curve_second};
#else
extern int taut_curve_avx2_is_for_x86;
#endif
