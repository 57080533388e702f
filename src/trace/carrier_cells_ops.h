/* carrier_cells_ops.h -- the innermost loops of carrier_cells.c, one table per instruction set. Results are the same bit
 * for bit: four coordinates are four sums at every width of vectors.
 */
#ifndef TAUT_TRACE_CARRIER_CELLS_OPS_H
#define TAUT_TRACE_CARRIER_CELLS_OPS_H

enum { TAUT_CARRIER_CELLS_DEGREE = 5 };

typedef struct taut_carrier_cells_ops {
    /* The derivatives up to `order` of sum_ij c_ij s[0]^i s[1]^j, c double[degree[0] + 1][degree[1] + 1][4]; `inverse`: ds
     * over what derivatives are by. Of the first three coordinates, and of the fourth. */
    void (*at)(const int degree[2], const double *c, const double s[2], const double inverse[2],
               int order, double (*x)[3], double *weights);
} taut_carrier_cells_ops;

extern const taut_carrier_cells_ops taut_carrier_cells_baseline;
#if defined(__x86_64__)
extern const taut_carrier_cells_ops taut_carrier_cells_avx2;
#endif

#endif /* TAUT_TRACE_CARRIER_CELLS_OPS_H */
