#include "certify/harmonic/claims.h"

#include "certify/common/verdict.h"
#include "certify/harmonic/residual.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/exact.h"
#include "core/fail.h"
#include "measure/integrate/integrals.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

taut_status taut_harmonic_check_model(const taut_model *model, int least, taut_error *error)
{
    if (taut_model_surface_count(model) < least) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces",
                         taut_model_surface_count(model), least,
                         "the model has %d surfaces, expected at least %d",
                         taut_model_surface_count(model), least);
    }
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        if (strcmp(taut_basis_type(taut_surface_u(surface)), "bezier") != 0 ||
            strcmp(taut_basis_type(taut_surface_v(surface)), "bezier") != 0 ||
            taut_surface_weights(surface) != NULL) {
            char where[32];
            snprintf(where, sizeof where, "/surfaces/%d", i);
            return taut_fail(error, TAUT_BAD_INPUT, "not-bezier", where, taut_none, taut_none,
                             "expected a polynomial surface on \"bezier\" bases");
        }
    }
    return TAUT_OK;
}

taut_status taut_harmonic_add_claim(const char *name, taut_claim_kind kind, double residual,
                                    double limit, const char *where, taut_certificate *certificate)
{
    const double held = fmin(limit, TAUT_HARMONIC_LIMIT);
    const taut_verdict below = isnan(limit) ? TAUT_UNDECIDED : taut_certify_below(residual, held);
    const int open = below == TAUT_FALSE && residual <= limit;
    const taut_claim claim = {.claim = name,
                              .kind = kind,
                              .residual = residual,
                              .limit = held,
                              .holds = open ? TAUT_UNDECIDED : below,
                              .where =
                                  below == TAUT_UNDECIDED ? TAUT_CERTIFY_OUT_OF_RANGE
                                  : open ? "the rounding of points so far from the origin hides it"
                                         : where};
    return taut_certificate_add(certificate, &claim);
}

double taut_harmonic_rank(double residual, double limit)
{
    const double held = fmin(limit, TAUT_HARMONIC_LIMIT);

    if (isnan(residual) || isnan(limit)) {
        return INFINITY; /* nothing stands before what is no number */
    }
    if (residual > limit) { /* false: before all that is open */
        return 0x1p300 * (residual / limit);
    }
    return held > 0 ? residual / held : residual; /* above 1: open */
}

/* The largest residual of the exact points, scaled as the other is. */
static taut_status add_exact(const taut_model *model, taut_certificate *certificate,
                             taut_error *error)
{
    const taut_exact_ops *ops = NULL;
    double worst = 0;
    char where[96] = "in rational arithmetic";
    taut_status status = taut_exact_load(&ops, error);

    for (int k = 0; k < taut_model_surface_count(model) && status == TAUT_OK; k++) {
        const taut_surface *surface = taut_model_surface(model, k);
        const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
        const double rectangle[4] = {taut_basis_lo(u), taut_basis_hi(u), taut_basis_lo(v),
                                     taut_basis_hi(v)};
        const taut_exact_numbers net = {taut_surface_points(surface), taut_surface_exact(surface)};
        const taut_harmonic_residual rounded = taut_harmonic_residual_of(surface, 0);
        const double scale = rounded.scaled > 0 ? rounded.scaled / rounded.largest : 1;
        double largest = 0;
        if (!ops->residual(taut_basis_degree(u), taut_basis_degree(v), &net, rectangle, &largest)) {
            return TAUT_NO_MEMORY; /* not reached: FLINT's numbers abort without memory */
        }
        if (largest * scale > worst) {
            worst = largest * scale;
            snprintf(where, sizeof where, "in rational arithmetic, surface %.40s",
                     taut_surface_name(surface));
        }
    }
    return status == TAUT_OK
               ? taut_harmonic_add_claim("harmonic", TAUT_EXACT, worst, 0, where, certificate)
               : status;
}

/* How far two opposite edges of even degree miss the condition of harmonic patches of bidegree
 * (n, n), that their top differences agree ([NiWang2015] section 2.4): d = |Delta^n (row n - row
 * 0)|; direction 0: the edges are u = 0 and 1. 0 for other bidegrees. */
static double defect_of(const taut_surface *surface, int direction)
{
    const int n = taut_basis_degree(taut_surface_u(surface));
    const double *points = taut_surface_points(surface);
    const size_t step = direction == 0 ? 3 : 3 * ((size_t)n + 1);
    const size_t across = (size_t)n * (direction == 0 ? 3 * ((size_t)n + 1) : 3);
    double most = 0;
    if (n % 2 != 0 || taut_basis_degree(taut_surface_v(surface)) != n) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        double binomial = 1, sum = 0;
        for (int j = 0; j <= n; j++) {
            const double *point = points + step * (size_t)j + c;
            sum += binomial * (point[across] - point[0]);
            binomial *= -(double)(n - j) / (j + 1);
        }
        most = fmax(most, fabs(sum));
    }
    return most;
}

/* n!, rounded up to n times: infinite from 171 on. */
static double factorial(int n)
{
    double product = 1;
    for (int k = 2; k <= n; k++) {
        product *= k;
    }
    return product;
}

/* What such a d leaves of the Laplacian at least, scaled as the residual is: with k = n/2 - 1
 *     w_v mu^k (n! d / 2) |Lambda_k(u) - Lambda_k(1 - u)|,   mu = w_v / w_u,
 * where the difference is at most 1 for k = 0 and 4 zeta(3) / (2 pi)^(2k+1) else (its sine series);
 * its Bernstein coefficients are taken for four times that. */
static double forced_residual(const taut_surface *surface, const taut_harmonic_residual *found)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const int n = taut_basis_degree(bases[0]), k = n / 2 - 1;
    const double width[2] = {taut_basis_hi(bases[0]) - taut_basis_lo(bases[0]),
                             taut_basis_hi(bases[1]) - taut_basis_lo(bases[1])};
    const double least = fmin(width[0], width[1]);
    const double size = found->size * n * n / (least * least);
    double most = 0;
    for (int d = 0; d < 2 && size > 0 && k >= 0; d++) {
        const double across = width[d], along = width[1 - d];
        const double lambda =
            k == 0 ? 1 : 16 * 1.2020569 * taut_exp(-(2 * k + 1) * taut_log(2 * 3.14159265));
        const double miss = defect_of(surface, d);
        if (miss > 0 && miss <= 1e-10 * found->size) {
            most = fmax(most, taut_pow(across / along, 2.0 * k) / (along * along) * 0.5 * miss *
                                  factorial(n) * lambda / size);
        }
    }
    return most;
}

/* The claim of edges that are told to too few digits to bound a harmonic patch of even degree. */
static taut_status add_missed(double residual, double limit, const taut_surface *surface,
                              taut_certificate *certificate)
{
    char where[160];
    snprintf(
        where, sizeof where,
        "two edges of even degree miss the condition of a harmonic patch by %.3g, which leaves "
        "so much; \"even\" can repair them",
        fmax(defect_of(surface, 0), defect_of(surface, 1)));
    const taut_claim claim = {.claim = "harmonic",
                              .kind = TAUT_BOUND,
                              .residual = residual,
                              .limit = limit,
                              .holds = TAUT_UNDECIDED,
                              .where = where};
    return taut_certificate_add(certificate, &claim);
}

taut_status taut_harmonic_add_harmonic(const taut_model *model, int exact, double carried,
                                       taut_certificate *certificate, taut_error *error)
{
    if (exact) {
        return add_exact(model, certificate, error);
    }

    char where[96] = "";
    double worst = -1, residual = 0, limit = 0, spared = 0, first = 0;
    const taut_surface *worst_surface = NULL;

    for (int k = 0; k < taut_model_surface_count(model); k++) {
        const taut_surface *surface = taut_model_surface(model, k);
        const taut_harmonic_residual found = taut_harmonic_residual_of(surface, 0);
        const int degrees =
            taut_basis_degree(taut_surface_u(surface)) + taut_basis_degree(taut_surface_v(surface));
        first = k == 0 ? found.size : first;
        /* the net of a merged surface holds the first one's, and is no smaller */
        const double size = k == 2 ? fmax(found.size, first / 2) : found.size;
        const double noise = size > 0 && k > 0 ? 2 * carried / size : 0;
        const double allowed = 2 * degrees * TAUT_UNIT_ROUNDOFF * fmax(found.reach, noise);
        const double rank = taut_harmonic_rank(found.scaled, allowed);
        if (!(rank <= worst)) {
            worst = rank;
            residual = found.scaled;
            limit = allowed;
            spared = forced_residual(surface, &found);
            worst_surface = surface;
            snprintf(where, sizeof where, "surface %.40s, its own rectangle, point %d %d",
                     taut_surface_name(surface), found.i, found.j);
        }
    }
    if (residual > limit && residual <= limit + spared) {
        return add_missed(residual, limit, worst_surface, certificate);
    }
    return taut_harmonic_add_claim("harmonic", TAUT_BOUND, residual, limit, where, certificate);
}

taut_status taut_harmonic_add_figures(const taut_model *model, const taut_crew *crew,
                                      taut_record *figures)
{
    static const char *const names[2] = {"dirichlet_energy", "isothermality"};
    taut_status (*const measures[2])(const taut_surface *, const taut_crew *, double *) = {
        taut_surface_dirichlet_of, taut_surface_isothermality_of};
    const int count = taut_model_surface_count(model);

    for (int k = 0; k < 2; k++) {
        taut_record *list = count > 1 ? taut_record_add_list(figures, names[k]) : figures;
        for (int i = 0; i < count; i++) {
            double value = 0;
            const taut_status status = measures[k](taut_model_surface(model, i), crew, &value);
            if (status != TAUT_OK) {
                return status;
            }
            taut_record_add_number(list, count > 1 ? NULL : names[k], value);
        }
    }
    return TAUT_OK;
}
