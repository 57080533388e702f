/* extension.c -- is this the harmonic neighbour? Claims:
 *
 *   harmonic    each surface over its own rectangle (claims.h). The merged surface is harmonic over
 *               the union of the two, and not over the unit square as the source's corollary has it:
 *               figure merged_square_residual is the largest control point of its Laplacian there
 *               ([NiWang2015] section 2.7).
 *   boundary    the given surface is there as it was, bit for bit: largest distance of its points
 *               over its size.
 *   continuity  on the shared edge: gap over size, and the difference of the derivatives across
 *               over the largest (contact c1), or the sine between the normals (g1), by coefficients
 *               (contact.h); the ranges meet there.
 *   merged      `h`, cut at the edge, is the given surface and the extension (merged.h).
 *   contact     with the problem, g1: the derivative across is c P_across + (alpha + beta s) P_along
 *               (contact.h), and the extension is as wide as was asked for.
 */
#include "taut/harmonic.h"

#include "certify/certify_ops.h"
#include "certify/common/verdict.h"
#include "certify/harmonic/claims.h"
#include "certify/harmonic/contact.h"
#include "certify/harmonic/merged.h"
#include "certify/harmonic/residual.h"
#include "core/arena.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"

#include <float.h>
#include <math.h>

static double largest_coordinate(const taut_surface *surface)
{
    const size_t count = 3 * (size_t)taut_basis_count(taut_surface_u(surface)) *
                         (size_t)taut_basis_count(taut_surface_v(surface));
    double most = 0;
    for (size_t i = 0; i < count; i++) {
        most = fmax(most, fabs(taut_surface_points(surface)[i]));
    }
    return most;
}

/* Proved, seen to be false, or neither. */
static taut_status add_contact(const char *name, const taut_contact *found, const char *where,
                               taut_certificate *certificate)
{
    const double limit = fmin(found->limit, TAUT_HARMONIC_LIMIT);
    const taut_verdict below = taut_certify_below(found->residual, limit);
    const int is_seen = found->seen > limit && found->seen > found->limit;
    const taut_claim claim = {
        .claim = name,
        .kind = TAUT_BOUND,
        .residual = below == TAUT_TRUE || !is_seen ? found->residual : found->seen,
        .limit = limit,
        .holds = below == TAUT_TRUE ? TAUT_TRUE
                 : is_seen          ? TAUT_FALSE
                                    : TAUT_UNDECIDED,
        .where = below == TAUT_TRUE || is_seen ? where
                 : found->why != NULL          ? found->why
                 : below == TAUT_UNDECIDED     ? TAUT_CERTIFY_OUT_OF_RANGE
                                               : "rounding of the points may leave as much"};
    return taut_certificate_add(certificate, &claim);
}

static taut_status add_apart(const char *name, const char *where, taut_certificate *certificate)
{
    const taut_claim claim = {.claim = name,
                              .kind = TAUT_BOUND,
                              .residual = 1,
                              .limit = 0,
                              .holds = TAUT_FALSE,
                              .where = where};
    return taut_certificate_add(certificate, &claim);
}

static taut_status add_continuity(const taut_model *model, taut_edge edge, int g1,
                                  taut_arena *arena, taut_certificate *certificate)
{
    const taut_surface *p = taut_model_surface(model, 0), *q = taut_model_surface(model, 1);

    if (!taut_contact_ranges(p, q, edge)) {
        return add_apart("continuity", "the ranges of the two surfaces do not meet in the edge",
                         certificate);
    }
    const taut_contact found =
        g1 ? taut_contact_g1(p, q, edge, arena) : taut_contact_c1(p, q, edge, arena);
    return taut_arena_status(arena) != TAUT_OK
               ? TAUT_NO_MEMORY
               : add_contact("continuity", &found, g1 ? "tangent planes" : "derivatives across",
                             certificate);
}

/* Is the extension as wide as was asked for, to the rounding of its ends? */
static int has_width(const taut_model *model, const taut_harmonic_extension_problem *problem)
{
    const int u = problem->edge == TAUT_EDGE_U0 || problem->edge == TAUT_EDGE_U1;
    const taut_surface *p = problem->surface, *q = taut_model_surface(model, 1);
    const taut_surface *like =
        problem->given == TAUT_EXTENSION_MERGE ? problem->merge.neighbour : p;
    const taut_basis *old = u ? taut_surface_u(p) : taut_surface_v(p);
    const taut_basis *same = u ? taut_surface_u(like) : taut_surface_v(like);
    const taut_basis *beyond = u ? taut_surface_u(q) : taut_surface_v(q);
    const double asked = problem->given == TAUT_EXTENSION_C1   ? problem->c1.width
                         : problem->given == TAUT_EXTENSION_G1 ? problem->g1.width
                                                               : 0;
    const double wanted = asked > 0 ? asked : taut_basis_hi(same) - taut_basis_lo(same);
    const double width = taut_basis_hi(beyond) - taut_basis_lo(beyond);
    const double far = fmax(fmax(fabs(taut_basis_lo(beyond)), fabs(taut_basis_hi(beyond))),
                            fmax(fabs(taut_basis_lo(old)), fabs(taut_basis_hi(old))));
    return fabs(width - wanted) <= 16 * TAUT_UNIT_ROUNDOFF * (far + wanted);
}

static taut_status add_rule(const taut_model *model, const taut_harmonic_extension_problem *problem,
                            taut_arena *arena, taut_certificate *certificate)
{
    const taut_extension_g1 *g1 = &problem->g1;
    const double rule[3] = {g1->c, g1->alpha, g1->beta};
    const taut_contact found = taut_contact_rule(
        taut_model_surface(model, 0), taut_model_surface(model, 1), problem->edge, rule, arena);

    if (!has_width(model, problem)) {
        return add_apart("contact", "/surfaces/1: its width is not the one asked for", certificate);
    }
    return taut_arena_status(arena) != TAUT_OK
               ? TAUT_NO_MEMORY
               : add_contact("contact", &found, "derivatives across", certificate);
}

static taut_status add_merged(const taut_model *model, taut_edge edge,
                              const taut_harmonic_extension_problem *problem,
                              taut_certificate *certificate)
{
    const taut_merged found =
        taut_merged_of(taut_model_surface(model, 0), taut_model_surface(model, 1),
                       taut_model_surface(model, 2), edge);
    const double limit = fmin(found.limit, TAUT_HARMONIC_LIMIT);
    const int is_wide = problem == NULL || has_width(model, problem);
    const taut_verdict below = taut_certify_below(found.residual, limit);
    const taut_claim claim = {
        .claim = "merged",
        .kind = TAUT_EXACT,
        .residual = is_wide ? found.residual : 1,
        .limit = limit,
        .holds = !is_wide                                               ? TAUT_FALSE
                 : below == TAUT_FALSE && found.residual <= found.limit ? TAUT_UNDECIDED
                                                                        : below,
        .where = is_wide ? found.piece : "/surfaces/1: its width is not the one asked for"};
    return taut_certificate_add(certificate, &claim);
}

static taut_status add_boundary(const taut_model *model, const taut_surface *given,
                                taut_certificate *certificate)
{
    const taut_surface *found = taut_model_surface(model, 0);
    const int same = taut_basis_equal(taut_surface_u(found), taut_surface_u(given)) &&
                     taut_basis_equal(taut_surface_v(found), taut_surface_v(given));
    const size_t count = 3 * (size_t)taut_basis_count(taut_surface_u(given)) *
                         (size_t)taut_basis_count(taut_surface_v(given));
    const double size = largest_coordinate(given);
    double most = same ? 0 : 1;
    for (size_t i = 0; same && i < count; i++) {
        const double apart = taut_surface_points(found)[i] / 2 - taut_surface_points(given)[i] / 2;
        const int differs = taut_surface_points(found)[i] != taut_surface_points(given)[i];
        most = taut_certify_max(most, differs ? fmax(fabs(apart), DBL_MIN) : 0);
    }
    const double residual = !same || size == 0 ? most : most / (size / 2);
    return taut_harmonic_add_claim("boundary", TAUT_EXACT,
                                   most > 0 ? fmax(residual, TAUT_UNIT_ROUNDOFF) : 0, 0,
                                   most > 0 ? "/surfaces/0" : "", certificate);
}

/* The edge the problem names, or without it the one where the first two surfaces' ranges meet. */
static taut_edge edge_of(const taut_model *model, const taut_harmonic_extension_problem *problem)
{
    const taut_surface *p = taut_model_surface(model, 0), *q = taut_model_surface(model, 1);
    return problem != NULL ? problem->edge : taut_certify_shared_edge(p, q);
}

/* What the points that are carried on have met, and a third of what the rounding of the given ones
 * may grow to at worst, (1 + 2 h)^n, h the ratio of the widths: rounding errors are seldom of one mind.
 * What q carried back meets is as large as the p that it comes from: one larger counts as that. */
static double carried_of(const taut_model *model, const taut_harmonic_extension_problem *problem)
{
    const taut_surface *p = taut_model_surface(model, 0), *q = taut_model_surface(model, 1);
    const taut_edge edge = edge_of(model, problem);
    const int u = edge == TAUT_EDGE_U0 || edge == TAUT_EDGE_U1;
    const taut_basis *old = u ? taut_surface_u(p) : taut_surface_v(p);
    const taut_basis *beyond = u ? taut_surface_u(q) : taut_surface_v(q);
    const double h =
        (taut_basis_hi(beyond) - taut_basis_lo(beyond)) / (taut_basis_hi(old) - taut_basis_lo(old));
    const double growth = taut_pow(1 + 2 * h, taut_basis_degree(old));
    const double size = largest_coordinate(p);
    const double most = 2 * taut_merged_carried(q, p, (taut_edge)(edge ^ 1)); /* q's own edge */
    const double share = size > most ? most / size : 1; /* p that large is not where q comes from */

    return share * taut_certify_max(taut_merged_carried(p, q, edge), growth * size / 6);
}

static taut_status add_figures(const taut_model *model, const taut_crew *crew,
                               taut_certificate *certificate)
{
    taut_record *figures = taut_record_new();
    const taut_status status = taut_harmonic_add_figures(model, crew, figures);

    if (taut_model_surface_count(model) > 2) {
        taut_record_add_number(figures, "merged_square_residual",
                               taut_harmonic_residual_of(taut_model_surface(model, 2), 1).largest);
        taut_record_add_text(figures, "merged_remark",
                             "h is harmonic over its own rectangle, not over the unit square");
    }
    taut_certificate_set_figures(certificate, figures);
    return status == TAUT_OK ? taut_record_status(figures) : status;
}

/* How the surfaces belong together. */
static taut_status add_meeting(const taut_model *model,
                               const taut_harmonic_extension_problem *problem, int g1,
                               taut_certificate *certificate)
{
    const taut_edge edge = edge_of(model, problem);
    taut_arena *arena = taut_arena_new();
    taut_status status =
        arena != NULL ? add_continuity(model, edge, g1, arena, certificate) : TAUT_NO_MEMORY;

    if (status == TAUT_OK && !g1) {
        status = add_merged(model, edge, problem, certificate);
    } else if (status == TAUT_OK && problem != NULL) {
        status = add_rule(model, problem, arena, certificate);
    }
    taut_arena_free(arena);
    return status;
}

static taut_status add_all(const taut_model *model, const taut_harmonic_extension_problem *problem,
                           const taut_audit *audit, taut_certificate *certificate,
                           taut_error *error)
{
    const int g1 =
        problem != NULL ? problem->given == TAUT_EXTENSION_G1 : taut_model_surface_count(model) < 3;
    taut_status status = taut_harmonic_add_harmonic(
        model, audit->exact, g1 ? 0 : carried_of(model, problem), certificate, error);

    if (status == TAUT_OK && problem != NULL) {
        status = add_boundary(model, problem->surface, certificate);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = add_meeting(model, problem, g1, certificate);
    return status == TAUT_OK ? add_figures(model, &audit->crew, certificate) : status;
}

static taut_status certify(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error)
{
    const taut_harmonic_extension_problem *problem = data;
    const int merged = problem != NULL && problem->given != TAUT_EXTENSION_G1;
    taut_status status = taut_harmonic_check_model(model, merged ? 3 : 2, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = add_all(model, data, audit, certificate, error);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}

static void identify(const taut_model *model, const void *data, taut_identity *identity)
{
    const taut_harmonic_extension_problem *problem = data;
    const taut_expected_basis bezier = {.type = "bezier"};
    taut_expected_basis u = bezier, v = bezier, along = bezier, across = bezier;
    const char *name = NULL;

    if (problem != NULL) {
        u.same = taut_surface_u(problem->surface);
        v.same = taut_surface_v(problem->surface);
        name = taut_surface_name(problem->surface);
    }
    taut_identity_surface(identity, 0, name, &u, &v);
    if (problem != NULL) { /* one polynomial carried on, or one of its degrees */
        along.degree[0] = along.degree[1] = taut_basis_degree(u.same);
        across.degree[0] = across.degree[1] = taut_basis_degree(v.same);
    }
    taut_identity_surface(identity, 1, "extension", &along, &across);
    (void)model;
    if (problem != NULL ? problem->given != TAUT_EXTENSION_G1
                        : taut_identity_find_surface(identity, "h") == 2) {
        taut_identity_surface(identity, 2, "h", &along, &across);
    }
}

const taut_certify_ops taut_certify_harmonic_extension = {
    .certify = certify, .identify = identify, .exact = 1};

taut_status taut_harmonic_extension_certify(const taut_model *model,
                                            const taut_harmonic_extension_problem *problem,
                                            const taut_certify_options *options,
                                            taut_certificate **certificate, taut_error *error)
{
    return taut_certify_with(&taut_certify_harmonic_extension, "harmonic-extension", model, problem,
                             options, certificate, error);
}
