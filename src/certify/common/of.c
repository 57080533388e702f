#include "certify/common/of.h"

#include "certify/common/verdict.h"
#include "core/fail.h"
#include "geometry/keep.h"
#include "problem/problem.h"
#include "taut/join.h"

#include <stdlib.h>
#include <string.h>

/* How many numbers of two surfaces differ; 1 where their bases do. */
static double differences(const taut_surface *a, const taut_surface *b)
{
    const double *wa = taut_surface_weights(a), *wb = taut_surface_weights(b);
    if (!taut_basis_equal(taut_surface_u(a), taut_surface_u(b)) ||
        !taut_basis_equal(taut_surface_v(a), taut_surface_v(b)) || (wa == NULL) != (wb == NULL)) {
        return 1;
    }
    const size_t count =
        (size_t)taut_basis_count(taut_surface_u(a)) * (size_t)taut_basis_count(taut_surface_v(a));
    double wrong = 0;
    for (size_t k = 0; k < 3 * count; k++) {
        wrong += taut_surface_points(a)[k] != taut_surface_points(b)[k];
    }
    for (size_t k = 0; wa != NULL && k < count; k++) {
        wrong += wa[k] != wb[k];
    }
    return wrong;
}

/* The surface that the document names in a model, or the only one. */
const taut_surface *taut_certify_named(const taut_model *model, const char *name)
{
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        const taut_surface *one = taut_model_surface(model, i);
        if (name == NULL || strcmp(taut_surface_name(one), name) == 0) {
            return one;
        }
    }
    return NULL;
}

/* The same of all surfaces of two models. */
static double all_differences(const taut_model *a, const taut_model *b)
{
    const int count = taut_model_surface_count(a);
    double wrong = abs(count - taut_model_surface_count(b));
    for (int k = 0; k < count && k < taut_model_surface_count(b); k++) {
        const taut_surface *one = taut_model_surface(a, k), *other = taut_model_surface(b, k);
        wrong += strcmp(taut_surface_name(one), taut_surface_name(other)) != 0;
        wrong += differences(one, other);
    }
    return wrong;
}

/* What was made first, proved by its own problem: the surface alone, under the details it was made
 * with. */
/* An edge of the surface as a curve under its own name. */
static taut_status add_edge(const taut_surface *surface, int edge, taut_arena *arena,
                            taut_model *model)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const int nu = taut_basis_count(u), nv = taut_basis_count(v), is_u = edge < 2;
    const int count = is_u ? nv : nu, held = edge % 2 == 0 ? 0 : (is_u ? nu : nv) - 1;
    double *points = taut_arena_take(arena, (size_t)count, 3 * sizeof(double));
    taut_curve *curve = NULL;

    if (points == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < count; k++) {
        const int i = is_u ? held : k, j = is_u ? k : held;
        memcpy(points + 3 * (size_t)k,
               taut_surface_points(surface) + 3 * ((size_t)i * (size_t)nv + (size_t)j),
               3 * sizeof(double));
    }
    taut_status status =
        taut_curve_new(taut_edge_name((taut_edge)edge), is_u ? v : u, points, NULL, &curve, NULL);
    if (status == TAUT_OK) {
        status = taut_model_add_curve(model, curve);
        if (status != TAUT_OK) {
            taut_curve_free(curve);
        }
    }
    return status;
}

/* The cables of a film, which are edges of it: the model that goes on from its surface leaves them out. */
static taut_status add_cables(const taut_record *details, const taut_surface *surface,
                              taut_arena *arena, taut_model *model)
{
    const taut_record *cables = taut_record_get(details, "cables");
    taut_status status = TAUT_OK;
    for (size_t k = 0; status == TAUT_OK && k < taut_record_count(cables); k++) {
        const char *name = taut_record_text(taut_record_get(taut_record_at(cables, k), "edge"));
        for (int e = 0; status == TAUT_OK && e < 4; e++) {
            if (strcmp(name, taut_edge_name((taut_edge)e)) == 0) {
                status = add_edge(surface, e, arena, model);
            }
        }
    }
    return status;
}

static taut_status prove_first(const taut_model *whole, const taut_surface *carrier, int all,
                               const taut_problem *problem, taut_arena *arena,
                               const taut_audit *audit, taut_claim *claim, taut_error *error)
{
    const taut_record *of = taut_record_get(taut_model_details(whole), "of");
    const taut_record *details = taut_record_get(of, "details");
    const taut_certify_options options = {.threads = audit->crew.threads,
                                          .tolerance = audit->tolerance,
                                          .exact = audit->exact,
                                          .monitor = *audit->crew.pulse->monitor};
    taut_certificate *inner = NULL;
    taut_model *model = NULL;

    if (taut_model_new(&model) != TAUT_OK || !taut_keep_model(arena, model)) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < (all ? taut_model_surface_count(whole) : 1); k++) {
        taut_surface *surface = NULL;
        if (taut_surface_copy(all ? taut_model_surface(whole, k) : carrier, &surface) != TAUT_OK ||
            taut_model_add_surface(model, surface) != TAUT_OK) {
            taut_surface_free(surface);
            return taut_fail_memory(error);
        }
    }
    if (!all && taut_surface_weights(carrier) == NULL &&
        add_cables(details, carrier, arena, model) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (details != NULL) {
        taut_record *copy = taut_record_copy(details);
        if (copy == NULL) {
            return taut_fail_memory(error);
        }
        taut_model_set_details(model, copy);
    }
    taut_model_set_unit(model, problem->unit);
    const taut_status status = taut_certify(model, problem, &options, &inner, NULL);
    claim->kind = TAUT_CHECK;
    if (status == TAUT_NO_MEMORY || status == TAUT_INTERRUPTED) {
        return taut_fail_status(error, status);
    }
    if (status != TAUT_OK) {
        claim->holds = TAUT_UNDECIDED;
        claim->residual = NAN;
        claim->where = "what was made first cannot be certified by its surface alone";
        return TAUT_OK;
    }
    claim->residual = 0;
    for (int k = 0; k < taut_certificate_claim_count(inner); k++) {
        const taut_claim *one = taut_certificate_claim(inner, k);
        claim->residual += one->holds == TAUT_FALSE;
    }
    claim->holds = taut_certificate_holds(inner);
    taut_certificate_free(inner);
    return TAUT_OK;
}

taut_status taut_certify_of(const taut_model *model, const taut_surface *surface,
                            const taut_certify_given *given, taut_arena *arena,
                            const taut_audit *audit, taut_certificate *certificate,
                            taut_error *error)
{
    taut_claim claim = {.claim = "surface", .kind = TAUT_EXACT, .limit = 0, .where = ""};
    taut_status status = TAUT_OK;

    if (given->of != NULL) {
        status = prove_first(model, surface, given->all, given->of, arena, audit, &claim, error);
    } else {
        const taut_surface *one = taut_certify_named(given->model, given->surface);
        claim.residual = given->all    ? all_differences(given->model, model)
                         : one != NULL ? differences(one, surface)
                                       : 1;
        claim.holds = taut_certify_below(claim.residual, 0);
    }
    if (status != TAUT_OK) {
        return status;
    }
    return taut_certificate_add(certificate, &claim) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}
