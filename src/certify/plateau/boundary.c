#include "certify/plateau/boundary.h"

#include "certify/common/curve_distance.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

static const double unit_roundoff = 0x1p-53;
static const char *const names[4] = {"u0", "u1", "v0", "v1"};

/* What edge e has to be: to be freed. */
static taut_status wanted_edge(const taut_plateau_problem *problem, int e, taut_curve **curve,
                               taut_error *error)
{
    const taut_dirichlet_problem *net = &problem->net;
    if (problem->curves[e] != NULL) {
        return taut_curve_copy(problem->curves[e], curve) == TAUT_OK ? TAUT_OK
                                                                     : taut_fail_memory(error);
    }
    return taut_certify_edge(net->u, net->v, net->points, net->weights, e, curve, error);
}

static int degree_of(const taut_curve *curve)
{
    const int degree = taut_basis_degree(taut_curve_t(curve));
    return degree >= 0 ? degree : 5; /* as a spline */
}

taut_status taut_certify_plateau_boundary(const taut_surface *surface,
                                          const taut_plateau_problem *problem, double deviation,
                                          taut_certificate *certificate, taut_error *error)
{
    double size = 0, distance = 0, roundings = 0, origin[3] = {0, 0, 0};
    int worst = 0;
    taut_status status = TAUT_OK;

    for (int e = 0; status == TAUT_OK && e < 4; e++) {
        taut_curve *wanted = NULL, *found = NULL;
        double bound = INFINITY;
        status = wanted_edge(problem, e, &wanted, error);
        if (status == TAUT_OK) {
            status = taut_certify_edge(taut_surface_u(surface), taut_surface_v(surface),
                                       taut_surface_points(surface), taut_surface_weights(surface),
                                       e, &found, error);
        }
        if (status == TAUT_OK) {
            status = taut_certify_distance(found, wanted, &bound, error);
        }
        if (status == TAUT_OK) {
            if (e == 0) {
                memcpy(origin, taut_curve_points(wanted), sizeof origin);
            }
            size = fmax(size, taut_certify_reach(wanted, origin));
            roundings = fmax(roundings, degree_of(found) + degree_of(wanted) +
                                            taut_basis_count(taut_curve_t(found)));
            worst = bound <= distance ? worst : e;
            distance = bound <= distance ? distance : bound;
        }
        taut_curve_free(wanted);
        taut_curve_free(found);
    }
    if (status != TAUT_OK) {
        return status;
    }
    roundings *= 1 + taut_norm(origin) / size; /* of points as they are stored */
    const double told = deviation / size, rounding = 64 * roundings * unit_roundoff;
    const taut_claim claim = {
        .claim = "boundary",
        .residual = distance / size,
        .limit = 1.25 * told + rounding,
        .holds = distance / size <= 1.25 * told + rounding && told <= distance / size + rounding
                     ? TAUT_TRUE
                     : TAUT_FALSE,
        .where = names[worst],
    };
    status = taut_certificate_add(certificate, &claim);
    return status == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}
