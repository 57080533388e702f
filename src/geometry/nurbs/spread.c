#include "geometry/nurbs/spread.h"

#include "basis/basis_ops.h"

#include <math.h>
#include <stddef.h>

/* Of the weights at steps along one line, span by span. */
static double spread_of_line(const taut_basis *basis, const double *weights, size_t step)
{
    const int local = taut_basis_local(basis), spans = taut_basis_span_count(basis);
    double spread = 1;

    for (int k = 0; k < spans; k++) {
        const double *alive = weights + (size_t)taut_basis_first(basis, k) * step;
        double least = alive[0], largest = alive[0];
        for (int i = 1; i < local; i++) {
            least = fmin(least, alive[(size_t)i * step]);
            largest = fmax(largest, alive[(size_t)i * step]);
        }
        spread = fmax(spread, largest / least);
    }
    return spread;
}

double taut_weight_spread(const taut_surface *surface)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const size_t rows = (size_t)taut_basis_count(u), columns = (size_t)taut_basis_count(v);
    const double *weights = taut_surface_weights(surface);
    double spread = 1;

    if (weights == NULL) {
        return 1;
    }
    for (size_t i = 0; i < rows; i++) {
        spread = fmax(spread, spread_of_line(v, weights + i * columns, 1));
    }
    for (size_t j = 0; j < columns; j++) {
        spread = fmax(spread, spread_of_line(u, weights + j, columns));
    }
    return spread;
}
