/* enneper.c -- a bicubic net that is harmonic and isothermal: Phi' = a + b z + c z^2 with
 * Phi'.Phi' = 0 is (p^2 - q^2, i (p^2 + q^2), 2 p q) up to rotation, p and q linear in z; a unitary
 * change of p and q, which turns the surface, makes p constant. So it is Enneper's surface in
 * parameters z / L, times a scale s, and
 *
 *     |b.b| = 4 s^2 / L^4,    |c| = sqrt(2) s / L^3
 */
#include "measure/recognise/recognise.h"
#include "taut/measure.h"

#include <math.h>

enum { GRID = 8 };

static double place(const taut_basis *basis, int k)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    return k == GRID ? hi : lo + (hi - lo) * k / GRID;
}

static double length(const double *x)
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

/* Largest of |E-G|/E, |F|/E, |r_uu + r_vv|/|r_uu| on a grid. */
static double defect_of(const taut_surface *surface)
{
    double largest = 0;
    for (int k = 0; k < (GRID + 1) * (GRID + 1); k++) {
        const double u = place(taut_surface_u(surface), k / (GRID + 1));
        const double v = place(taut_surface_v(surface), k % (GRID + 1));
        double x[6][3], sum[3];
        taut_forms f;
        taut_surface_eval(surface, u, v, 2, &x[0][0]);
        taut_forms_of((const double(*)[3])x, &f);
        for (int c = 0; c < 3; c++) {
            sum[c] = x[TAUT_XUU][c] + x[TAUT_XVV][c];
        }
        const double second = fmax(length(x[TAUT_XUU]), length(x[TAUT_XUV]));
        const double here = fmax(fmax(fabs(f.e - f.g), fabs(f.f)) / f.e, length(sum) / second);
        largest = here <= largest ? largest : here;
        if (!(here <= 1)) { /* infinite or NaN too: a point, a line, a plane in affine parameters */
            return INFINITY;
        }
    }
    return largest;
}

void taut_recognise_enneper(const taut_surface *surface, taut_family_member *member)
{
    const double at[2] = {
        0.5 * (place(taut_surface_u(surface), 0) + place(taut_surface_u(surface), GRID)),
        0.5 * (place(taut_surface_v(surface), 0) + place(taut_surface_v(surface), GRID))};
    const double defect = defect_of(surface);
    double complex phi[3][3], bb = 0;
    double cc = 0, b2 = 0;

    taut_phi_of(surface, 0, at, phi);
    for (int k = 0; k < 3; k++) {
        bb += phi[1][k] * phi[1][k];
        b2 += creal(phi[1][k] * conj(phi[1][k]));
        cc += 0.25 * creal(phi[2][k] * conj(phi[2][k]));
    }
    /* a plane conformally mapped has b.b = 0 */
    if (!(cabs(bb) > 1e-6 * b2) || !(cc > 0)) {
        return;
    }
    const double second = 0.5 * sqrt(cabs(bb)), third = sqrt(0.5 * cc), unit = second / third;
    member->name = "Enneper's surface";
    member->scale = second * unit * unit;
    member->lambda = 1;
    member->residual = defect;
}
