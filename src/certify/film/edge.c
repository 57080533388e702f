#include "certify/film/edge.h"

#include "certify/common/curve_distance.h"
#include "certify/plateau/fit.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum { FIT = 2 };

/* To be freed. */
static taut_status make_wanted(const taut_film_asked *asked, taut_curve **curve, taut_error *error)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = 1};
    taut_basis *basis = NULL;

    if (asked->curve != NULL) {
        return taut_curve_copy(asked->curve, curve) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
    }
    taut_status status = taut_basis_new(&spec, 2, &basis, error);
    if (status == TAUT_OK) {
        status = taut_curve_new(NULL, basis, asked->ends[0], NULL, curve, error);
    }
    taut_basis_free(basis);
    return status;
}

/* How near to its curve the space of the problem lets an edge come. */
static taut_status fit_edge(const taut_curve *wanted, const taut_basis *basis, double *bound,
                            taut_error *error)
{
    taut_curve *fit = NULL;
    taut_status status = taut_certify_fit(wanted, basis, &fit);

    *bound = INFINITY;
    if (status == TAUT_OK) {
        status = taut_certify_distance(fit, wanted, bound, error);
    } else {
        status = status == TAUT_NO_MEMORY ? taut_fail_memory(error) : TAUT_OK;
    }
    taut_curve_free(fit);
    return status;
}

/* One edge against its own limit; nonzero: it is kept. */
static int keep_worst(const taut_film_asked *asked, const taut_curve *found,
                      const taut_curve *wanted, double distance, double fitted,
                      taut_film_boundary *b)
{
    const int degree = taut_basis_degree(taut_curve_t(wanted));
    const double roundings = taut_basis_degree(taut_curve_t(found)) + (degree >= 0 ? degree : 5) +
                             taut_basis_count(taut_curve_t(found));
    const double size = asked->size, residual = distance / size;
    /* what the bound of a distance has for its own rounding: more where the film's size or its first point is not like the edge */
    const double *first = taut_curve_points(found);
    const double reach = fmax(taut_certify_reach(found, first), taut_certify_reach(wanted, first)) +
                         taut_norm(first);
    const double own = 32 * (taut_basis_degree(taut_curve_t(found)) + fmax(degree, 1)) *
                       TAUT_UNIT_ROUNDOFF * reach / size;
    const double limit =
        FIT * fitted / size +
        fmax(64 * roundings * TAUT_UNIT_ROUNDOFF * (1 + asked->away / size), 2 * own);
    const int is_worst = b->count++ == 0 || !(residual / limit <= b->residual / b->limit);

    if (is_worst) {
        b->residual = residual;
        b->limit = limit;
    }
    return is_worst;
}

taut_status taut_film_judge_edge(const taut_surface *surface, int e, const taut_film_asked *asked,
                                 taut_film_boundary *boundary, int *is_worst, taut_error *error)
{
    taut_curve *wanted = NULL, *found = NULL;
    double distance = INFINITY, fitted = 0;
    taut_status status = make_wanted(asked, &wanted, error);

    if (status == TAUT_OK) {
        status = taut_certify_edge(taut_surface_u(surface), taut_surface_v(surface),
                                   taut_surface_points(surface), NULL, e, &found, error);
    }
    if (status == TAUT_OK) {
        status = taut_certify_distance(found, wanted, &distance, error);
    }
    if (status == TAUT_OK && asked->curve != NULL &&
        (asked->is_fitted || taut_curve_weights(asked->curve) != NULL ||
         !taut_basis_equal(taut_curve_t(asked->curve), taut_curve_t(found)))) {
        boundary->fitted = 1;
        status = fit_edge(wanted, taut_curve_t(found), &fitted, error);
    }
    *is_worst = status == TAUT_OK && keep_worst(asked, found, wanted, distance, fitted, boundary);
    taut_curve_free(wanted);
    taut_curve_free(found);
    return status;
}

const taut_surface *taut_film_find_surface(const taut_model *model, const char *name)
{
    for (int k = 0; k < taut_model_surface_count(model); k++) {
        if (strcmp(taut_surface_name(taut_model_surface(model, k)), name) == 0) {
            return taut_model_surface(model, k);
        }
    }
    return NULL;
}
