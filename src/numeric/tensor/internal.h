/* internal.h -- what the files of the tensor-product solver share. */
#ifndef TAUT_NUMERIC_TENSOR_INTERNAL_H
#define TAUT_NUMERIC_TENSOR_INTERNAL_H

#include "core/arena.h"
#include "core/crew.h"
#include "numeric/band.h"
#include "numeric/modes.h"
#include "numeric/tensor/solver.h"

/* One direction of the net: its matrices, as given but of one width, and its modes if they were
 * worked out. */
typedef struct taut_direction {
    taut_band k, m;
    double weight;           /* su, sv */
    const taut_modes *modes; /* lent (numeric/modes_lent.h) */
} taut_direction;

struct taut_tensor_solver {
    taut_direction direction[2];
    int diagonal;   /* the direction that is diagonalised for any right-hand side */
    int has_shared; /* both directions have the same modes, owned by the first */
    taut_crew crew; /* its pulse may be NULL */
};

/* TAUT_LANES banded systems  weight_d lambda M + weight_e K,  lambda the values of modes of
 * direction d, M and K of direction e = 1 - d, over a range of rows of e. */
typedef struct taut_systems {
    const taut_tensor_solver *solver;
    int d;
    double *factor; /* double[width + n][width + 1][lanes] */
    double *x;      /* double[n][nrhs][lanes] */
} taut_systems;

/* Takes the scratch; the arena's status tells whether it is there. */
taut_systems taut_systems_of(const taut_tensor_solver *solver, int d, int nrhs, taut_arena *arena);
/* Solves those of modes first..first+used-1, used <= lanes, in systems->x, of which row 0 is row
 * `from` of rows from..upto-1; what lies outside is taken for zero. */
void taut_systems_solve(const taut_systems *systems, int first, int used, int from, int upto,
                        int nrhs);

/* The operations of one such solve over so many rows. */
double taut_systems_work(const taut_systems *systems, int rows, size_t nrhs);

/* Is x zero but for the rows and columns along the edges that boundary values reach? Then
 * taut_edges_solve may be used, if both directions have modes. */
int taut_edges_hold(const taut_tensor_solver *solver, int nrhs, const double *x);
/* Solves in place. TAUT_OK, TAUT_INTERRUPTED or TAUT_NO_MEMORY (x untouched). */
taut_status taut_edges_solve(const taut_tensor_solver *solver, int nrhs, double *x);

/* ---- products of V or V^T with a net, a panel of columns at a time (contract.c) ---- */

/* A net double[..] seen along one direction is a matrix of n rows and any number of columns;
 * column c has its entries at
 *     x[offset(c) + row * stride],    offset(c) = c / inner * outer + c % inner
 */
typedef struct taut_unfolding {
    size_t columns;
    size_t stride, inner, outer;
} taut_unfolding;

/* Seen along the first direction of double[nu][nv][nrhs], and along the second. */
taut_unfolding taut_unfolding_first(size_t nu, size_t nv, size_t nrhs);
taut_unfolding taut_unfolding_second(size_t nu, size_t nv, size_t nrhs);

/* The modes that a net is contracted with, and scratch of each worker: some columns in slivers of kernel->tile_columns, as the
 * tile kernel wants them, and some rows of their product. */
typedef struct taut_contraction {
    const taut_modes *modes;
    taut_crew crew;
    taut_pulse *pulse; /* of the worker at it, or NULL: the caller's thread alone beats */
    int workers;
    size_t in_size, out_size; /* numbers of one worker's */
    double *in, *out;
    size_t *panels; /* first columns of panels */
} taut_contraction;

/* For nets of so many columns at most. Takes 1 MiB or so a worker; the arena's status tells whether it is there. */
taut_contraction taut_contraction_of(const taut_modes *modes, size_t columns, const taut_crew *crew,
                                     taut_arena *arena);

/* x becomes V^T x in place; rows are then modes. Rows of zeros cost nothing in between. */
void taut_contract_points(const taut_contraction *work, const taut_unfolding *unfolding, double *x);
/* x becomes V x. */
void taut_contract_modes(const taut_contraction *work, const taut_unfolding *unfolding, double *x);

/* Rows of modes that are zero but at their ends: those of up to TAUT_LANES modes of one part,
 * the same ends for all of them. */
typedef struct taut_tail_block {
    int first, used;   /* modes */
    size_t keep[2];    /* points at the start and at the end of each row */
    double *values[2]; /* double[used][keep][rhs] */
} taut_tail_block;

typedef struct taut_tails {
    size_t blocks[2]; /* of each part, in the order of its modes */
    taut_tail_block *block[2];
    size_t points, rhs; /* a whole row is double[points][rhs] */
} taut_tails;

/* Blocks for all modes, nothing kept yet; the arena's status tells whether they are there. */
taut_tails taut_tails_of(const taut_modes *modes, size_t points, size_t rhs, taut_arena *arena);

/* x becomes, or gains if not is_new, V times the tails. */
void taut_contract_tails(const taut_contraction *work, const taut_unfolding *unfolding,
                         const taut_tails *tails, int is_new, double *x);

#endif /* TAUT_NUMERIC_TENSOR_INTERNAL_H */
