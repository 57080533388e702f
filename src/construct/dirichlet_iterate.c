/* dirichlet_iterate.c -- preconditioned conjugate gradients ([GolubVanLoan2013] 11.5), the three
 * coordinates side by side: they share the products with A and P, not the step lengths. A
 * coordinate that has converged to nothing stands still.
 */
#include "construct/dirichlet_system_parts.h"

#include <string.h>

/* x_c . y_c for each coordinate c. */
static void dots(size_t size, const double *x, const double *y, double dot[3])
{
    dot[0] = dot[1] = dot[2] = 0;
    for (size_t i = 0; i < size; i += 3) {
        dot[0] += x[i] * y[i];
        dot[1] += x[i + 1] * y[i + 1];
        dot[2] += x[i + 2] * y[i + 2];
    }
}

/* y_c += factor_c x_c. */
static void add_multiple(size_t size, const double factor[3], const double *x, double *y)
{
    for (size_t i = 0; i < size; i += 3) {
        y[i] += factor[0] * x[i];
        y[i + 1] += factor[1] * x[i + 1];
        y[i + 2] += factor[2] * x[i + 2];
    }
}

/* smooth = P residual, P the inverse of the hull's operator cut down to the unknowns: symmetric
 * and positive definite like it. */
static taut_status precondition(taut_dirichlet_system *system)
{
    const taut_status status = taut_dirichlet_solve_hull(system, system->residual);
    memset(system->smooth, 0, taut_dirichlet_net_size(system) * sizeof(double));
    taut_pattern_add(system->pattern, system->hull, system->smooth);
    return status;
}

taut_status taut_dirichlet_iterate(taut_dirichlet_system *system, double enough, int most,
                                   double *net, taut_error *error)
{
    const size_t size = taut_dirichlet_net_size(system);
    double before[3], now[3], curvature[3], factor[3], minus[3];
    taut_status status = precondition(system);

    memcpy(system->step, system->smooth, size * sizeof(double));
    dots(size, system->residual, system->smooth, now);
    for (int k = 0; status == TAUT_OK && k < most; k++) {
        status = taut_dirichlet_form_apply(system->form, system->step, system->product);
        if (status != TAUT_OK) {
            break;
        }
        taut_pattern_clear_known(system->pattern, system->product);
        system->iterations++;
        dots(size, system->step, system->product, curvature);
        for (int c = 0; c < 3; c++) {
            factor[c] = curvature[c] > 0 ? now[c] / curvature[c] : 0;
            minus[c] = -factor[c];
            before[c] = now[c];
        }
        add_multiple(size, factor, system->step, net);
        add_multiple(size, minus, system->product, system->residual);
        if (taut_dirichlet_omega(system, system->residual) <= enough) {
            break;
        }
        status = precondition(system);
        if (status == TAUT_OK) {
            status = taut_dirichlet_stopped(system, error);
        }
        dots(size, system->residual, system->smooth, now);
        for (int c = 0; c < 3; c++) {
            factor[c] = before[c] > 0 ? now[c] / before[c] : 0;
        }
        for (size_t i = 0; i < size; i++) {
            system->step[i] = system->smooth[i] + factor[i % 3] * system->step[i];
        }
    }
    return status;
}
