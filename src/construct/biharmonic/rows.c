/* rows.c -- the surface with four given rows: the 4 n biharmonic polynomials of bidegree (n, n)
 * against the 4 n boundary points ([NiWang2015] section 8.4). */
#include "construct/biharmonic/biharmonic.h"
#include "construct/common/build.h"
#include "construct/harmonic/rim.h"
#include "construct/harmonic/unit_map.h"
#include "core/fail.h"

#include <string.h>

/* Past this rounding of the rows leaves the net less than five digits; past this
 * degree the growth is not looked for. */
enum { DEGREE_MAX = 24 };
static const double amplification_limit = 1e11;

static taut_status check_mask(const taut_biharmonic_rows *rows, taut_error *error)
{
    const int nu = taut_basis_count(rows->u), nv = taut_basis_count(rows->v);
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const int edge = i == 0 || i == nu - 1 || j == 0 || j == nv - 1;
            if ((rows->known[i * nv + j] != 0) != edge) {
                return taut_fail(error, TAUT_BAD_INPUT, "mask", "/points", taut_none, taut_none,
                                 "expected the four boundary rows, and null inside");
            }
        }
    }
    if (nu != nv) {
        return taut_fail(error, TAUT_NO_SOLUTION, "degree", nu < nv ? "/u/degree" : "/v/degree",
                         nu < nv ? nu - 1 : nv - 1, nu < nv ? nv - 1 : nu - 1,
                         "four rows determine a biharmonic surface of one degree both ways, found "
                         "%d and %d: raise the lower one",
                         nu - 1, nv - 1);
    }
    return TAUT_OK;
}

static taut_status check_amplification(int degree, double amplification, taut_error *error)
{
    if (!(amplification <= amplification_limit)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "ill-conditioned", "/u/degree", amplification,
                         amplification_limit,
                         "rounding in four rows of degree %d would grow more than %.0e times: the "
                         "result would mean nothing (a lower degree is better)",
                         degree, amplification_limit);
    }
    return TAUT_OK;
}

/* The net in the user's coordinates, its rows as they were given. */
static taut_status solve_net(const taut_biharmonic_rows *rows, taut_arena *arena, taut_pulse *pulse,
                             double *net, double *amplification, taut_error *error)
{
    const int n = taut_basis_degree(rows->u);
    const size_t points = (size_t)(n + 1) * (size_t)(n + 1);
    const double across = taut_basis_hi(rows->u) - taut_basis_lo(rows->u);
    const double along = taut_basis_hi(rows->v) - taut_basis_lo(rows->v);
    const taut_unit_map map = taut_unit_map_of(points, rows->points, rows->known);
    taut_space space;
    taut_rim boundary;
    taut_status status = TAUT_OK;

    if (n > DEGREE_MAX) {
        return check_amplification(n, 2 * amplification_limit, error);
    }
    if (!taut_space_biharmonic(n, across, along, arena, pulse, &space) ||
        !taut_rim_solve(&space, arena, &boundary)) {
        return taut_fail_memory(error);
    }
    *amplification = taut_rim_amplification(&boundary);
    if (taut_pulse_is_stopped(pulse)) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    status = check_amplification(n, *amplification, error);
    if (status != TAUT_OK) {
        return status;
    }
    memcpy(net, rows->points, 3 * points * sizeof(double));
    taut_unit_map_apply(&map, points, net);
    if (!taut_rim_net(&boundary, arena, net, net)) {
        return taut_fail_memory(error);
    }
    taut_unit_map_undo(&map, points, net);
    for (size_t k = 0; k < points; k++) {
        if (rows->known[k]) {
            memcpy(net + 3 * k, rows->points + 3 * k, 3 * sizeof(double));
        }
    }
    return TAUT_OK;
}

taut_status taut_biharmonic_add_rows(const taut_biharmonic_rows *rows, taut_arena *arena,
                                     taut_pulse *pulse, taut_model *model, double *amplification,
                                     taut_error *error)
{
    const size_t points = (size_t)taut_basis_count(rows->u) * (size_t)taut_basis_count(rows->v);
    double *net = taut_arena_take(arena, 3 * points, sizeof(double));
    taut_surface *surface = NULL;
    taut_status status = TAUT_OK;

    if (net == NULL) {
        return taut_fail_memory(error);
    }
    status = check_mask(rows, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = solve_net(rows, arena, pulse, net, amplification, error);
    if (taut_pulse_is_stopped(pulse)) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_surface_new(rows->name != NULL ? rows->name : "biharmonic", rows->u, rows->v, net,
                              NULL, &surface, error);
    return status == TAUT_OK ? taut_construct_add_surface(model, surface, error) : status;
}
