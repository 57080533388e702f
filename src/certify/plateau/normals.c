#include "certify/plateau/normals.h"

#include "basis/basis_ops.h"
#include "core/vec3.h"
#include "geometry/keep.h"

#include <math.h>
#include <string.h>

/* A normal this short, of the longest, is none. */
static const double none = 1e-9;

taut_surface *taut_certify_read_net(const taut_record *rows, const taut_surface *film,
                                    taut_arena *arena)
{
    const size_t nu = (size_t)taut_basis_count(taut_surface_u(film));
    const size_t nv = (size_t)taut_basis_count(taut_surface_v(film));
    double *points = taut_arena_take(arena, 3 * nu * nv, sizeof(double));
    taut_surface *made = NULL;

    if (points == NULL || taut_record_count(rows) != nu) {
        return NULL;
    }
    for (size_t i = 0; i < nu * nv; i++) {
        const taut_record *row = taut_record_at(rows, i / nv);
        const taut_record *point = taut_record_at(row, i % nv);
        for (size_t c = 0; c < 3; c++) {
            points[3 * i + c] = taut_record_number(taut_record_at(point, c));
        }
        if (taut_record_count(row) != nv || taut_record_count(point) != 3) {
            return NULL;
        }
    }
    const taut_status status = taut_surface_new("", taut_surface_u(film), taut_surface_v(film),
                                                points, taut_surface_weights(film), &made, NULL);
    if (status == TAUT_OK || status == TAUT_NO_MEMORY) {
        return taut_keep_surface(arena, made) ? made : NULL;
    }
    return NULL; /* a number that is none */
}

/* Where control point i belongs: the coefficients of the function t, within the range. */
static void find_places(const taut_basis *basis, double *t)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const int count = taut_basis_count(basis);

    if (basis->ops->linear != NULL) {
        basis->ops->linear(basis, t);
    }
    for (int i = 0; i < count; i++) {
        t[i] = basis->ops->linear != NULL ? t[i] : lo + (hi - lo) * i / (count - 1);
        t[i] = t[i] < lo ? lo : t[i] > hi ? hi : t[i];
    }
}

/* x over its length where that is more than `least`, else 0. */
static int normalise(double x[3], double least)
{
    const double length = taut_norm(x);
    const int is_long = isfinite(length) && length > least;

    for (int c = 0; c < 3; c++) {
        x[c] = is_long ? x[c] / length : 0;
    }
    return is_long;
}

/* The mean of the directions around point `at`; 0 where there is none yet. */
static int take_mean(int nu, int nv, int at, double *directions)
{
    double mean[3] = {0, 0, 0};

    for (int i = at / nv - 1; i <= at / nv + 1; i++) {
        for (int j = at % nv - 1; j <= at % nv + 1; j++) {
            if (i >= 0 && i < nu && j >= 0 && j < nv) {
                taut_add_scaled(1, directions + 3 * ((size_t)i * (size_t)nv + (size_t)j), mean);
            }
        }
    }
    const int is_there = normalise(mean, none);
    memcpy(directions + 3 * (size_t)at, mean, sizeof mean);
    return is_there;
}

/* Points without a normal, row by row, again and again while any of them gains one. */
static void fill_gaps(int nu, int nv, double *directions)
{
    for (int round = 0, gained = 1; gained && round < nu + nv; round++) {
        gained = 0;
        for (int at = 0; at < nu * nv; at++) {
            const double *d = directions + 3 * (size_t)at;
            gained |= taut_dot(d, d) == 0 && take_mean(nu, nv, at, directions);
        }
    }
    for (int at = 0; at < nu * nv; at++) {
        double *d = directions + 3 * (size_t)at;
        d[2] = taut_dot(d, d) == 0 ? 1 : d[2];
    }
}

taut_status taut_certify_normals(const taut_surface *surface, double *directions)
{
    const taut_basis *basis[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const int nu = taut_basis_count(basis[0]), nv = taut_basis_count(basis[1]);
    taut_arena *arena = taut_arena_new();
    double *u = taut_arena_take(arena, (size_t)nu, sizeof(double));
    double *v = taut_arena_take(arena, (size_t)nv, sizeof(double));
    double *values = taut_arena_take(arena, (size_t)nu * (size_t)nv, 9 * sizeof(double));
    double longest = 0, steepest = 0;
    int exponent = 0; /* slopes are brought to unit size: squares of them may leave the range */
    taut_status status = taut_arena_status(arena);

    if (status == TAUT_OK) {
        find_places(basis[0], u);
        find_places(basis[1], v);
        status = taut_surface_eval_grid(surface, nu, u, nv, v, 1, 1, values);
    }
    for (int k = 0; k < 9 * nu * nv && status == TAUT_OK; k++) {
        steepest = k % 9 < 3 ? steepest : fmax(steepest, fabs(values[k]));
    }
    (void)frexp(steepest, &exponent);
    for (int k = 0; k < nu * nv && status == TAUT_OK; k++) {
        double *d = directions + 3 * (size_t)k, slopes[6];
        for (int c = 0; c < 6; c++) {
            slopes[c] = ldexp(values[9 * (size_t)k + 3 + (size_t)c], -exponent);
        }
        taut_cross(slopes, slopes + 3, d);
        longest = fmax(longest, taut_norm(d));
    }
    for (int k = 0; k < nu * nv && status == TAUT_OK; k++) {
        (void)normalise(directions + 3 * (size_t)k, none * longest);
    }
    if (status == TAUT_OK) {
        fill_gaps(nu, nv, directions);
    }
    taut_arena_free(arena);
    return status;
}
