/* cells_avx2.c -- the loops of cells.c and compose.c for AVX2 (this file is compiled for it). */
#if defined(__x86_64__)
#include "certify/trace/cells_body.h"

const taut_net_cell_ops taut_net_cell_avx2 = {sum_cell, compose_cell};
#else
extern int taut_net_cell_avx2_is_for_x86;
#endif
