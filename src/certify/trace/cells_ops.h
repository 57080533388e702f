/* cells_ops.h -- the innermost loops of cells.c and compose.c, one table per instruction set. Results are the same bit for
 * bit: what a sum takes in which order does not depend on the width of vectors.
 */
#ifndef TAUT_CERTIFY_TRACE_CELLS_OPS_H
#define TAUT_CERTIFY_TRACE_CELLS_OPS_H

/* TAUT_NET_CURVE (p + q) at most of a cell of degree p x q, so that curves composed with it are bounded too. */
enum {
    TAUT_NET_CURVE = 5,
    TAUT_NET_COMPOSE_DEGREE = 120,
    TAUT_NET_CELL_SIDE = TAUT_NET_COMPOSE_DEGREE / TAUT_NET_CURVE, /* the most of p, and of q */
    TAUT_NET_COMPOSE_ROOM = TAUT_NET_COMPOSE_DEGREE + TAUT_NET_CURVE + 1
};

typedef double taut_net_compose_row[TAUT_NET_COMPOSE_ROOM];

typedef struct taut_net_cell_ops {
    /* x, x_u, x_v, x_uu, x_uv, x_vv of a cell that is a polynomial
     *
     *     points  double[p + 1][q + 1][4]
     *     u, v    Bernstein's polynomials, their first and second derivatives in [0, 1] */
    void (*sum)(int p, int q, const double *points, const double width[2],
                double u[3][TAUT_NET_CELL_SIDE + 1], double v[3][TAUT_NET_CELL_SIDE + 1],
                double x[6][3]);
    /* out[0 .. TAUT_NET_CURVE (p + q)] = sum_ij x_ij first_i second_j, coefficients times their binomials
     *
     *     x       double[p + 1][q + 1]
     *     first   of degree TAUT_NET_CURVE p each, second of TAUT_NET_CURVE q */
    void (*compose)(int p, int q, const double *x, const taut_net_compose_row *first,
                    const taut_net_compose_row *second, double *out);
} taut_net_cell_ops;

extern const taut_net_cell_ops taut_net_cell_baseline;
#if defined(__x86_64__)
extern const taut_net_cell_ops taut_net_cell_avx2;
#endif

#endif /* TAUT_CERTIFY_TRACE_CELLS_OPS_H */
