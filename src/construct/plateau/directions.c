#include "construct/plateau/directions.h"

#include "basis/basis_ops.h"
#include "core/arena.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

void taut_plateau_greville(const taut_basis *basis, double *t)
{
    const int count = taut_basis_count(basis);
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);

    if (basis->ops->linear != NULL) {
        basis->ops->linear(basis, t);
    }
    for (int i = 0; i < count; i++) {
        const double even = lo + (hi - lo) * i / (count - 1);
        t[i] = fmin(hi, fmax(lo, basis->ops->linear != NULL ? t[i] : even));
    }
}

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
static void fill_gaps(int nu, int nv, double *directions)
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

/* Slopes of about unit size, by a power of two: products of them neither overflow nor vanish. */
static void scale_slopes(size_t count, double *jets)
{
    double largest = 0;
    int exponent = 0;

    for (size_t k = 0; k < 9 * count; k++) {
        largest = fmax(largest, k % 9 >= 3 ? fabs(jets[k]) : 0);
    }
    (void)frexp(largest, &exponent);
    for (size_t k = 0; k < 9 * count; k++) {
        jets[k] = ldexp(jets[k], -exponent);
    }
}

static taut_status find_normals(const taut_surface *surface, taut_arena *arena, double *directions)
{
    const taut_basis *basis_u = taut_surface_u(surface), *basis_v = taut_surface_v(surface);
    const int nu = taut_basis_count(basis_u), nv = taut_basis_count(basis_v);
    const size_t count = (size_t)nu * (size_t)nv;
    double *u = taut_arena_take(arena, (size_t)nu, sizeof(double));
    double *v = taut_arena_take(arena, (size_t)nv, sizeof(double));
    double *jets = taut_arena_take(arena, count, 9 * sizeof(double));
    double largest = 0;
    taut_status status = taut_arena_status(arena);

    if (status != TAUT_OK) {
        return status;
    }
    taut_plateau_greville(basis_u, u);
    taut_plateau_greville(basis_v, v);
    status = taut_surface_eval_grid(surface, nu, u, nv, v, 1, 1, jets);
    if (status != TAUT_OK) {
        return status;
    }
    scale_slopes(count, jets);
    for (size_t i = 0; i < count; i++) {
        taut_cross(jets + 9 * i + 3, jets + 9 * i + 6, directions + 3 * i);
        largest = fmax(largest, taut_norm(directions + 3 * i));
    }
    for (size_t i = 0; i < count; i++) {
        make_unit(directions + 3 * i, largest);
    }
    fill_gaps(nu, nv, directions);
    return TAUT_OK;
}

taut_status taut_plateau_directions(const taut_surface *surface, double *directions)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status = find_normals(surface, arena, directions);

    taut_arena_free(arena);
    return status;
}
