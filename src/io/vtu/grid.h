/* grid.h -- an unstructured grid in memory: what a piece of a VTU file holds. */
#ifndef TAUT_IO_VTU_GRID_H
#define TAUT_IO_VTU_GRID_H

#include "core/arena.h"
#include "core/pulse.h"
#include "io/mesh/fields.h"
#include "taut/write.h"

#include <stdint.h>

enum {
    VTK_POLY_LINE = 4,
    VTK_QUAD = 9,
    VTK_LAGRANGE_QUADRILATERAL = 70,
    VTK_BEZIER_QUADRILATERAL = 77
};

/* The highest degree of VTK's Bezier and Lagrange cells. */
enum { VTU_DEGREE_MAX = 10 };

/* All arrays are as long as they may become; the counts say how long they are. */
typedef struct taut_vtu_grid {
    size_t points, cells, corners; /* corners: of all cells together */
    double *positions;             /* [points][3] */
    double *weights;               /* [points] */
    double *fields;                /* [points][TAUT_FIELDS] */
    int64_t *connectivity;         /* [corners] */
    int64_t *offsets;              /* [cells]: where each cell's corners end */
    uint8_t *types;                /* [cells] */
    int32_t *degrees;              /* [cells][3] */
    int32_t *surfaces;             /* [cells] */
    taut_pulse *pulse;             /* borrowed: is told of cells and fields; NULL at first */
} taut_vtu_grid;

/* Room for so many; whether there was memory is taut_arena_status. */
taut_vtu_grid taut_vtu_grid_of(taut_arena *arena, size_t points, size_t cells, size_t corners);
/* Adds a cell on points that are, or will be, there; returns where its corners go. */
int64_t *taut_vtu_grid_add_cell(taut_vtu_grid *grid, int type, size_t corners, int degree_u,
                                int degree_v, int surface);
/* Adds a point with a weight; its fields are NaN. Returns its index. */
size_t taut_vtu_grid_add_point(taut_vtu_grid *grid, const double *position, double weight);

/* A surface as Bezier cells: what it is, exactly, with the values of fields on a grid in each cell, or coefficients that
 * interpolate at Chebyshev points inside. Or as Lagrange cells: a polynomial surface by its points at the same grid, exactly too. */
typedef struct taut_vtu_cells {
    int degree[2], per_span[2], count[2]; /* cells in all along u and v */
    int coefficients;                     /* nonzero: those of the fields */
    int lagrange;                         /* nonzero: Lagrange cells */
} taut_vtu_cells;

/* Can it be, with such options? Then how many cells, for `divide` of them per span (0: by the number of spans). */
int taut_vtu_cells_plan(const taut_surface *surface, const taut_write_options *options,
                        taut_vtu_cells *plan);
taut_status taut_vtu_cells_add(const taut_surface *surface, const taut_vtu_cells *plan, int index,
                               taut_vtu_grid *grid, taut_error *error);

#endif /* TAUT_IO_VTU_GRID_H */
