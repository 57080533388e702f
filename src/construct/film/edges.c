#include "construct/film/edges.h"

const char *const taut_film_edge_names[4] = {"u0", "u1", "v0", "v1"};
const char *const taut_film_corner_names[4] = {"u0v0", "u1v0", "u0v1", "u1v1"};

void taut_film_edge_points(int nu, int nv, int e, size_t *first, size_t *step, int *count)
{
    const size_t columns = (size_t)nv;
    *first = e == 1 ? (size_t)(nu - 1) * columns : e == 3 ? columns - 1 : 0;
    *step = e < 2 ? 1 : columns;
    *count = e < 2 ? nv : nu;
}
