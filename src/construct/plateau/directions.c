#include "construct/plateau/directions.h"

#include "construct/common/greville.h"
#include "core/memory.h"
#include "core/vec3.h"

#include <string.h>

/* Makes x unit and returns 1, or zeroes it and returns 0. `size` is what a full normal has. */
static int make_unit(double x[3], double size)
{
    const double length = taut_norm(x);
    const int is_there = isfinite(length) && length > 1e-9 * size;
    for (int c = 0; c < 3; c++) {
        x[c] = is_there ? x[c] / length : 0;
    }
    return is_there;
}

/* Fills the gaps from neighbours, ring by ring, until none is left. */
static void mend(int nu, int nv, double *directions)
{
    int left = 1;
    for (int round = 0; left > 0 && round < nu + nv; round++) {
        left = 0;
        for (int at = 0; at < nu * nv; at++) {
            double *d = directions + 3 * (size_t)at, sum[3] = {0, 0, 0};
            if (taut_dot(d, d) > 0) {
                continue;
            }
            for (int k = 0; k < 9; k++) {
                const int i = at / nv + k / 3 - 1, j = at % nv + k % 3 - 1;
                if (i >= 0 && i < nu && j >= 0 && j < nv) {
                    taut_add_scaled(1, directions + 3 * ((size_t)i * (size_t)nv + (size_t)j), sum);
                }
            }
            left += !make_unit(sum, 1);
            memcpy(d, sum, sizeof sum);
        }
    }
    for (int at = 0; at < nu * nv; at++) {
        double *d = directions + 3 * (size_t)at;
        if (!(taut_dot(d, d) > 0)) {
            d[2] = 1;
        }
    }
}

taut_status taut_plateau_directions(const taut_surface *surface, double *directions)
{
    const int nu = taut_basis_count(taut_surface_u(surface));
    const int nv = taut_basis_count(taut_surface_v(surface));
    double *u = taut_alloc((size_t)nu, sizeof(double));
    double *v = taut_alloc((size_t)nv, sizeof(double));
    double *jets = taut_alloc_aligned((size_t)nu * (size_t)nv, 9 * sizeof(double));
    taut_status status = u != NULL && v != NULL && jets != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    if (status == TAUT_OK) {
        taut_greville(taut_surface_u(surface), u);
        taut_greville(taut_surface_v(surface), v);
        status = taut_surface_eval_grid(surface, nu, u, nv, v, 1, 1, jets);
    }
    if (status == TAUT_OK) {
        double largest = 0;
        for (size_t i = 0; i < (size_t)nu * (size_t)nv; i++) {
            taut_cross(jets + 9 * i + 3, jets + 9 * i + 6, directions + 3 * i);
            largest = fmax(largest, taut_norm(directions + 3 * i));
        }
        for (size_t i = 0; i < (size_t)nu * (size_t)nv; i++) {
            make_unit(directions + 3 * i, largest);
        }
        mend(nu, nv, directions);
    }
    taut_free(u);
    taut_free(v);
    taut_free(jets);
    return status;
}
