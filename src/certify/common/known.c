#include "certify/common/known.h"

#include "core/constants.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* |a - b| over size, at least 2^-52 where they differ at all. */
static double relative_difference(double a, double b, double size)
{
    const double apart = fabs(0.5 * a - 0.5 * b) / (0.5 * size);
    return a == b ? 0 : fmax(apart, 2 * TAUT_UNIT_ROUNDOFF);
}

/* How far apart two bases of the same count are, over their range. */
static double basis_difference(const taut_basis *a, const taut_basis *b)
{
    const int spans = taut_basis_span_count(a);
    const double range = taut_basis_hi(b) - taut_basis_lo(b);
    double largest = 0;

    if (taut_basis_equal(a, b)) {
        return 0;
    }
    if (strcmp(taut_basis_type(a), taut_basis_type(b)) != 0 ||
        taut_basis_local(a) != taut_basis_local(b) || taut_basis_span_count(b) != spans) {
        return 1;
    }
    for (int k = 0; k <= spans; k++) {
        largest = fmax(
            largest, relative_difference(taut_basis_breaks(a)[k], taut_basis_breaks(b)[k], range));
    }
    return largest > 0 ? largest : 1;
}

static double weights_difference(const taut_surface *surface, const taut_dirichlet_problem *problem,
                                 size_t at)
{
    const double *found = taut_surface_weights(surface), *given = problem->weights;
    if (found == NULL && given == NULL) {
        return 0;
    }
    return relative_difference(found != NULL ? found[at] : 1, given != NULL ? given[at] : 1,
                               given != NULL ? given[at] : 1);
}

/* The size of the known points of the problem: their largest distance from their middle. */
static double known_size(const taut_dirichlet_problem *problem)
{
    const size_t count =
        (size_t)taut_basis_count(problem->u) * (size_t)taut_basis_count(problem->v);
    double size = 0;
    for (int c = 0; c < 3; c++) {
        double lo = INFINITY, hi = -INFINITY;
        for (size_t i = 0; i < count; i++) {
            if (problem->known[i]) {
                lo = fmin(lo, problem->points[3 * i + (size_t)c]);
                hi = fmax(hi, problem->points[3 * i + (size_t)c]);
            }
        }
        size = fmax(size, 0.5 * hi - 0.5 * lo);
    }
    return size > 0 ? size : 1;
}

taut_status taut_certify_add_known(const taut_surface *surface,
                                   const taut_dirichlet_problem *problem,
                                   taut_certificate *certificate)
{
    const int nu = taut_basis_count(problem->u), nv = taut_basis_count(problem->v);
    const double *points = taut_surface_points(surface);
    const double size = known_size(problem);
    char where[64] = "";
    taut_claim claim = {.claim = "known", .kind = TAUT_EXACT, .holds = TAUT_TRUE, .where = where};

    claim.residual = fmax(basis_difference(taut_surface_u(surface), problem->u),
                          basis_difference(taut_surface_v(surface), problem->v));
    if (claim.residual > 0) {
        snprintf(where, sizeof where, "/surfaces/0/u or /surfaces/0/v");
    }
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const size_t at = (size_t)i * (size_t)nv + (size_t)j;
            double apart = weights_difference(surface, problem, at);
            for (size_t c = 0; problem->known[at] && c < 3; c++) {
                apart = fmax(apart, relative_difference(points[3 * at + c],
                                                        problem->points[3 * at + c], size));
            }
            if (apart > claim.residual) {
                claim.residual = apart;
                snprintf(where, sizeof where, "/surfaces/0/points/%d/%d", i, j);
            }
        }
    }
    claim.holds = claim.residual == 0 ? TAUT_TRUE : TAUT_FALSE;
    return taut_certificate_add(certificate, &claim);
}
