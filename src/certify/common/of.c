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

/* Of a model's surfaces those that are another one's. */
static int count_of(const taut_model *model, int count)
{
    const int all = taut_model_surface_count(model);
    return count > 0 && count < all ? count : all;
}

/* The same of all surfaces of two models, of the second one the first so many. */
static double all_differences(const taut_model *a, const taut_model *b, int first)
{
    const int count = taut_model_surface_count(a), others = count_of(b, first);
    double wrong = abs(count - others);
    for (int k = 0; k < count && k < others; k++) {
        const taut_surface *one = taut_model_surface(a, k), *other = taut_model_surface(b, k);
        wrong += strcmp(taut_surface_name(one), taut_surface_name(other)) != 0;
        wrong += differences(one, other);
    }
    return wrong;
}

/* An edge of a surface as a curve of this name. */
static taut_status add_edge(const taut_surface *surface, int edge, const char *name,
                            taut_arena *arena, taut_model *model)
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
    taut_status status = taut_curve_new(name, is_u ? v : u, points, NULL, &curve, NULL);
    if (status == TAUT_OK) {
        status = taut_model_add_curve(model, curve);
        if (status != TAUT_OK) {
            taut_curve_free(curve);
        }
    }
    return status;
}

/* The edge that a cable is told to be, "u0", or of one of several surfaces "NAME.u0"; -1. */
static int edge_of(const char *cable, const taut_surface *surface)
{
    const char *dot = strrchr(cable, '.'), *name = taut_surface_name(surface);
    const size_t length = dot != NULL ? (size_t)(dot - cable) : 0;
    if (dot != NULL && (strlen(name) != length || strncmp(name, cable, length) != 0)) {
        return -1;
    }
    for (int e = 0; e < 4; e++) {
        if (strcmp(dot != NULL ? dot + 1 : cable, taut_edge_name((taut_edge)e)) == 0) {
            return e;
        }
    }
    return -1;
}

/* The cables of a film, which are edges of it: the model that goes on from its surfaces leaves them out. */
static taut_status add_cables(const taut_record *details, const taut_surface *surface,
                              taut_arena *arena, taut_model *model)
{
    const taut_record *cables = taut_record_get(details, "cables");
    taut_status status = TAUT_OK;
    for (size_t k = 0; status == TAUT_OK && k < taut_record_count(cables); k++) {
        const char *name = taut_record_text(taut_record_get(taut_record_at(cables, k), "edge"));
        const int edge = edge_of(name, surface);
        status = edge >= 0 ? add_edge(surface, edge, name, arena, model) : TAUT_OK;
    }
    return status;
}

/* What was made first, proved by its own problem: the surfaces alone, under the details they were made with. */
static taut_status prove_first(const taut_model *whole, const taut_surface *carrier, int all,
                               int first, const taut_problem *problem, taut_arena *arena,
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
    for (int k = 0; k < (all ? count_of(whole, first) : 1); k++) {
        const taut_surface *from = all ? taut_model_surface(whole, k) : carrier;
        taut_surface *surface = NULL;
        if (taut_surface_copy(from, &surface) != TAUT_OK ||
            taut_model_add_surface(model, surface) != TAUT_OK) {
            taut_surface_free(surface);
            return taut_fail_memory(error);
        }
        if (taut_surface_weights(from) == NULL &&
            add_cables(details, from, arena, model) != TAUT_OK) {
            return taut_fail_memory(error);
        }
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
        status = prove_first(model, surface, given->all, given->count, given->of, arena, audit,
                             &claim, error);
    } else {
        const taut_surface *one = taut_certify_named(given->model, given->surface);
        claim.residual = given->all    ? all_differences(given->model, model, given->count)
                         : one != NULL ? differences(one, surface)
                                       : 1;
        claim.holds = taut_certify_below(claim.residual, 0);
    }
    if (status != TAUT_OK) {
        return status;
    }
    return taut_certificate_add(certificate, &claim) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}
