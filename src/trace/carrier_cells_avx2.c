/* carrier_cells_avx2.c -- the loops of carrier_cells.c for AVX2 (this file is compiled for it). */
#if defined(__x86_64__)
#include "trace/carrier_cells_body.h"

const taut_carrier_cells_ops taut_carrier_cells_avx2 = {evaluate_at};
#else
extern int taut_carrier_cells_avx2_is_for_x86;
#endif
