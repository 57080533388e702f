/* iterate.c -- preconditioned conjugate gradients ([GolubVanLoan2013] 11.5), the three
 * coordinates side by side: they share the products with A and P, not the step lengths. A
 * coordinate that has converged to nothing stands still.
 */
#include "construct/dirichlet/rational.h"
#include "construct/dirichlet/system_parts.h"

#include <math.h>
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

/* Weights that differ make the functions of their points differ in size, and with them the rows of
 * A: the hull's operator K knows nothing of it. s = sqrt(K_ii / A_ii) at the unknowns makes the
 * diagonals of S A S and K the same ([GolubVanLoan2013] 11.5.3). */
static void find_scales(taut_dirichlet_system *system)
{
    const taut_mask *p = system->mask;
    const taut_dirichlet_form *form = system->form;

    for (int a = 0; a < p->rows; a++) {
        const double mass_u = taut_band_row(&system->u.mass, a)[0];
        const double stiffness_u = taut_band_row(&system->u.stiffness, a)[0];
        for (int b = 0; b < p->columns; b++) {
            const double hull = form->fu * stiffness_u * taut_band_row(&system->v.mass, b)[0] +
                                form->fv * mass_u * taut_band_row(&system->v.stiffness, b)[0];
            const double own =
                taut_dirichlet_rational_diagonal(form->rational, p->row[a], p->column[b]);
            const double s = sqrt(hull / own);
            system->scales[(size_t)p->row[a] * (size_t)p->nv + (size_t)p->column[b]] =
                isfinite(s) ? s : 1;
        }
    }
}

static void scale(const taut_dirichlet_system *system, const double *x, double *scaled)
{
    for (size_t i = 0; i < taut_dirichlet_net_size(system); i++) {
        scaled[i] = system->scales[i / 3] * x[i];
    }
}

/* smooth = P residual, P the inverse of the hull's operator cut down to the unknowns, between the
 * scales where there are any: symmetric and positive definite like it. */
static taut_status precondition(taut_dirichlet_system *system)
{
    const int is_scaled = system->scales != NULL;
    taut_status status = TAUT_OK;

    if (is_scaled) {
        scale(system, system->residual, system->smooth);
    }
    status = taut_dirichlet_solve_hull(system, is_scaled ? system->smooth : system->residual);
    memset(system->smooth, 0, taut_dirichlet_net_size(system) * sizeof(double));
    taut_mask_add(system->mask, system->hull, system->smooth);
    if (is_scaled) {
        scale(system, system->smooth, system->smooth);
    }
    return status;
}

taut_status taut_dirichlet_iterate(taut_dirichlet_system *system, double enough, int most,
                                   double *net, taut_error *error)
{
    const size_t size = taut_dirichlet_net_size(system);
    double before[3], now[3], curvature[3], factor[3], minus[3];
    taut_status status = TAUT_OK;

    if (system->scales != NULL) {
        find_scales(system);
    }
    status = precondition(system);
    memcpy(system->step, system->smooth, size * sizeof(double));
    dots(size, system->residual, system->smooth, now);
    for (int k = 0; status == TAUT_OK && k < most; k++) {
        status = taut_dirichlet_form_apply(system->form, system->step, system->product);
        if (status != TAUT_OK) {
            break;
        }
        taut_mask_clear_known(system->mask, system->product);
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
