/* pressure.h -- pressures that no film holds, decided before anything is solved.
 *
 *     p |a| <= sum s L,    a = 1/2 int r x dr
 *
 * over the rim of the sides of a cell, where it is held all round and nothing else meets the sheets: the pressure on them is p a
 * whatever their shape, and they pull the rim with s at most, per length. For a circle p <= 2 s / r, which is sharp. */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_PRESSURE_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_PRESSURE_H

#include "construct/film/complex/layout.h"

/* TAUT_NO_SOLUTION: pressure-too-high. TAUT_NO_MEMORY. */
taut_status taut_film_pressure_check(const taut_film_layout *layout, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_PRESSURE_H */
