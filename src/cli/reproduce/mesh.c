/* mesh.c -- the constants of c- and h- bases out of their functions, and how far the
 * formulas of [XuWang2006] miss the surface where they are taken as they are printed. */
#include "cli/reproduce/reproduce.h"

#include "core/elementary/elementary.h"

#include <math.h>
#include <string.h>

enum { GRID = 400 };

/* values[d][a], d = 0..2, of the first span at parameter k of GRID + 1. */
static void functions(const taut_basis *basis, int k, double values[3][4])
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    if (taut_basis_local(basis) != 4 ||
        taut_basis_eval(basis, 0, k == GRID ? hi : lo + (hi - lo) * k / GRID, 2, &values[0][0]) !=
            TAUT_OK) {
        for (int i = 0; i < 12; i++) {
            values[i / 4][i % 4] = (double)NAN;
        }
    }
}

/* A bezier's U_1'(0) = 1/k. */
double cli_basis_k(const taut_basis *basis)
{
    double values[3][4];
    functions(basis, 0, values);
    return 1 / values[1][1];
}

static double length_of(const taut_basis *basis)
{
    return (taut_basis_hi(basis) - taut_basis_lo(basis)) / taut_basis_span_count(basis);
}

/* U_2''(0) = m k / f, f = alpha - sin alpha or sinh beta - beta. */
double cli_basis_m(const taut_basis *basis)
{
    const double x = length_of(basis);
    const double f = taut_basis_type(basis)[0] == 'c' ? x - taut_sin(x) : taut_sinh(x) - x;
    double values[3][4];
    functions(basis, 0, values);
    return values[2][2] * f / cli_basis_k(basis);
}

/* y with h_2i for h_2j: sum h_2i U_i(u) in the place of v, over w. */
double cli_literal_index(const taut_surface *surface, double lambda)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double beta = length_of(v), w = sqrt((1 - lambda) * (1 + lambda));
    const int bezier = strcmp(taut_basis_type(v), "h-bezier") == 0;
    const double k = bezier ? cli_basis_k(v) : beta;
    const double h2[4] = {bezier ? 0 : -beta, bezier ? k : 0, bezier ? beta - k : beta,
                          bezier ? beta : 2 * beta};
    double largest = 0;
    for (int i = 0; i <= GRID; i++) {
        double values[3][4], sum = 0;
        functions(u, i, values);
        for (int a = 0; a < 4; a++) {
            sum += h2[a] * values[0][a];
        }
        largest = fmax(largest, fmax(fabs(sum), fabs(sum - beta)) / w);
    }
    return largest;
}

/* x and z with c_h + k_h s_h for c_h - k_h s_h in P_i2: 2 k_h s_h V_2(v) times (sin u/w, cos u). */
double cli_literal_h42(const taut_surface *surface, double lambda)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double w = sqrt((1 - lambda) * (1 + lambda));
    double along = 0, around = 0;
    for (int i = 0; i <= GRID; i++) {
        const double t = taut_basis_lo(u) + length_of(u) * i / GRID;
        double values[3][4];
        functions(v, i, values);
        along = fmax(along, values[0][2]);
        around = fmax(around, taut_hypot(taut_sin(t) / w, taut_cos(t)));
    }
    return 2 * cli_basis_k(v) * taut_sinh(length_of(v)) * along * around;
}

/* |E - G| / E when the second component of r_v lacks its 1/w, the largest on a grid. */
double cli_literal_slope(const taut_surface *surface, double lambda)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double w = sqrt((1 - lambda) * (1 + lambda));
    double largest = 0;
    for (int k = 0; k < 41 * 41; k++) {
        const double a = taut_basis_lo(u) + length_of(u) * (k / 41) / 40;
        const double b = taut_basis_lo(v) + length_of(v) * (k % 41) / 40;
        double x[3][3], e = 0, g = 0;
        if (taut_surface_eval(surface, a, b, 1, &x[0][0]) != TAUT_OK) {
            return (double)NAN;
        }
        x[2][1] -= 1 / w;
        for (int c = 0; c < 3; c++) {
            e += x[1][c] * x[1][c];
            g += x[2][c] * x[2][c];
        }
        largest = fmax(largest, fabs(e - g) / e);
    }
    return largest;
}
