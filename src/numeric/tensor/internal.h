/* internal.h -- what the files of the tensor-product solver share. */
#ifndef TAUT_NUMERIC_TENSOR_INTERNAL_H
#define TAUT_NUMERIC_TENSOR_INTERNAL_H

#include "numeric/band.h"
#include "numeric/modes.h"
#include "numeric/tensor/contract.h"
#include "numeric/tensor/solver.h"

/* One direction of the net: its matrices, as given but of one width, and its modes if they were
 * worked out. */
typedef struct taut_direction {
    taut_band k, m;
    double weight; /* su, sv */
    taut_modes *modes;
} taut_direction;

struct taut_tensor_solver {
    taut_direction direction[2];
    int diagonal;   /* the direction that is diagonalised for any right-hand side */
    int has_shared; /* both directions have the same modes, owned by the first */
};

/* kernel->lanes banded systems  weight_d lambda M + weight_e K,  lambda the values of modes of
 * direction d, M and K of direction e = 1 - d, over a range of rows of e. */
typedef struct taut_systems {
    const taut_tensor_solver *solver;
    int d;
    double *factor; /* double[width + n][width + 1][lanes] */
    double *x;      /* double[n][nrhs][lanes] */
} taut_systems;

/* TAUT_OK or TAUT_NO_MEMORY; clear also after a failure. */
taut_status taut_systems_init(const taut_tensor_solver *solver, int d, int nrhs, taut_systems *out);
void taut_systems_clear(taut_systems *systems);
/* Solves those of modes first..first+used-1, used <= lanes, in systems->x, of which row 0 is row
 * `from` of rows from..upto-1; what lies outside is taken for zero. */
void taut_systems_solve(const taut_systems *systems, int first, int used, int from, int upto,
                        int nrhs);

/* Is x zero but for the rows and columns along the edges that boundary values reach? Then
 * taut_frame_solve may be used, if both directions have modes. */
int taut_frame_holds(const taut_tensor_solver *solver, int nrhs, const double *x);
/* Solves in place. TAUT_OK or TAUT_NO_MEMORY (x untouched). */
taut_status taut_frame_solve(const taut_tensor_solver *solver, int nrhs, double *x);

#endif /* TAUT_NUMERIC_TENSOR_INTERNAL_H */
