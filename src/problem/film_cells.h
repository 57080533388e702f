/* film_cells.h -- cells of films: are they bounded?
 *
 *     dV = iint +-d . (x_u x x_v) du dv + 1/3 int over rims of (x - from) . (d x dx)
 *
 * The rim of a cell is what its sides leave when those that run against each other cancel. Where it moves, x - from, d and dx must
 * be in one plane: else -p V would draw at the edge.
 */
#ifndef TAUT_PROBLEM_FILM_CELLS_H
#define TAUT_PROBLEM_FILM_CELLS_H

#include "problem/film_complex.h"

/* How often patch p bounds the cell: 1, -1, or 0. */
int taut_film_cell_turn(const taut_film_cell *cell, int patch);
/* +1, -1: a patch's boundary runs with edge e, or against it. */
int taut_film_edge_turn(int edge);
/* How often, with its sign, the rim of the cell runs along an edge, or along the seam that it is in, as its first side is run. */
int taut_film_cell_rim(const taut_film_complex *complex, const taut_film_cell *cell, int patch,
                       int edge);
void taut_film_cell_name(const taut_film_problem *problem, int cell, char name[TAUT_FILM_NAME]);

/* TAUT_BAD_INPUT: cell-sides. TAUT_NO_SOLUTION: open-cell. */
taut_status taut_film_cells_check(const taut_film_complex *complex, taut_error *error);

#endif /* TAUT_PROBLEM_FILM_CELLS_H */
