/* least.c -- the claim `least`: no surface with this boundary has less area, but for so much.
 *
 * The model may carry a witness: a direction e and a function psi on the spans of the film. Whatever
 * they are, if what follows is shown, then D of docs/least.md is a lower bound of the area of every
 * surface with the boundary of the film, orientable or not, a graph or not:
 *
 *     psi is a spline on the breaks of the film; the weights are positive
 *     J is of one sign, |grad psi| <= 1        certify/plateau/flux.h, which also bounds A - D
 *     the projected boundary is convex, but for an angle theta that rounding leaves, at most 1e-9
 *                                              certify/plateau/outline.h
 *     the projection encloses more than 6 theta (its length)^2
 *
 * By theta, |psi(a) - psi(b)| <= |a - b| / cos(theta / 2): psi over that much is 1-Lipschitz, can be
 * continued so to the whole plane, and its D, concave in psi and not negative at 0, is lower by no
 * more than theta^2 D. So the gap is that of flux.h and theta^2 A.
 *
 * residual (A - D) / A. Above the limit nothing is wrong with the film that is known: undecided,
 * unless the document set the limit with "gap".
 */
#include "certify/plateau/least.h"

#include "certify/common/quasi.h"
#include "certify/common/verdict.h"
#include "certify/plateau/given.h"
#include "core/arena.h"
#include "taut/plateau.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double limit_default = 1e-6;
static const double theta_most = 1e-9;
static const double area_apart = 1e-3; /* of the area measured, from the bounds of it */

typedef taut_least_finding finding;

/* ---- the witness, as it was written by whoever ---- */

/* Powers of two above the largest distance of a coordinate from the first point, and the weights. */
static int find_unit(const taut_surface *surface, taut_flux_task *task)
{
    const size_t count = (size_t)taut_basis_count(taut_surface_u(surface)) *
                         (size_t)taut_basis_count(taut_surface_v(surface));
    const double *points = taut_surface_points(surface), *weights = taut_surface_weights(surface);
    double largest = 0, heaviest = 0;

    for (size_t k = 0; k < 3 * count; k++) {
        largest = taut_certify_max(largest, fabs(0.5 * points[k] - 0.5 * points[k % 3]));
        heaviest = weights != NULL ? taut_certify_max(heaviest, weights[k / 3]) : 1;
    }
    if (!(largest > 0) || !isfinite(largest)) {
        return 0;
    }
    (void)frexp(largest, &task->exponent);
    task->exponent += 1;
    (void)frexp(heaviest, &task->weight_exponent);
    task->weight_exponent = weights != NULL ? task->weight_exponent : 0;
    return 1;
}

/* Why the witness is not valid, or NULL. */
static const char *read_witness(const taut_least_request *request, taut_arena *arena,
                                taut_flux_task *task, double direction[3])
{
    const taut_record *witness = request->witness;

    task->surface = request->surface;
    task->crew = request->crew;
    task->wanted = request->gap > 0 ? request->gap : limit_default;
    if (!taut_given_frame(taut_record_get(witness, "direction"), arena, task)) {
        return TAUT_GIVEN_NO_DIRECTION;
    }
    memcpy(direction, task->frame[2], 3 * sizeof(double));
    if (!find_unit(request->surface, task)) {
        return "range: the film has no size";
    }
    return taut_given_psi(witness, arena, task);
}

/* ---- what it proves ---- */

const char *taut_least_reason(taut_flux_verdict verdict)
{
    static const char *const reasons[] = {
        [TAUT_FLUX_FOLDS] = "folds: along the direction the film is not shown to be a graph",
        [TAUT_FLUX_STEEP] = "steep: the slope of the witness is not shown to be at most 1",
        [TAUT_FLUX_WORK] = "work: the proof would take too long",
        [TAUT_FLUX_RANGE] = "range: " TAUT_CERTIFY_OUT_OF_RANGE};
    return reasons[verdict];
}

void taut_least_conclude(const taut_flux_bound *flux, const taut_outline_bound *outline,
                         taut_least_finding *found)
{
    const double theta = outline->turned_back;

    if (!(theta <= theta_most) || !(flux->shadow > 6 * theta * outline->length * outline->length)) {
        found->why = "outline: along the direction the boundary is not shown to be convex";
        return;
    }
    found->area_low = flux->area_low;
    found->area_high = flux->area_high;
    found->gap = (1 + 0x1p-40) * (flux->gap + theta * theta * flux->area_high);
}

static taut_status bound_gap(taut_flux_task *task, finding *found)
{
    taut_flux_bound flux;
    taut_outline_bound outline = {0, 0};
    taut_status status = taut_certify_flux(task, &flux);

    if (status != TAUT_OK || flux.verdict != TAUT_FLUX_ADMITTED) {
        found->why = taut_least_reason(flux.verdict);
        return status;
    }
    status = taut_certify_outline(task, &outline);
    taut_least_conclude(&flux, &outline, found);
    return status;
}

/* What stands in the way before any witness is looked at; NULL: nothing. */
static const char *find_obstacle(const taut_least_request *request)
{
    const taut_basis *u = taut_surface_u(request->surface), *v = taut_surface_v(request->surface);

    if (request->is_declined) {
        return "declined: the document says \"least\": false";
    }
    if (request->is_held) {
        return "inside: the surface is held at points to pass through";
    }
    if (!request->boundary_only) {
        return "inside: other points than those of the boundary are known, or not all of those";
    }
    if (taut_certify_degree(u) < 0 || taut_certify_degree(v) < 0) {
        return "basis: no proof on spans of c- or h- bases wider than 4";
    }
    if ((double)taut_basis_count(u) * taut_basis_count(v) > TAUT_PLATEAU_LEAST_MAX) {
        return "size: more than 100 x 100 points";
    }
    if (taut_record_kind_of(request->witness) != TAUT_RECORD_OBJECT) {
        return "convex: no direction is known along which the film is a graph over a convex domain";
    }
    return NULL;
}

static taut_status find_bound(const taut_least_request *request, finding *found)
{
    taut_flux_task task = {.surface = NULL};
    taut_arena *arena = NULL;
    taut_status status = TAUT_OK;

    found->why = find_obstacle(request);
    if (found->why != NULL) {
        return TAUT_OK;
    }
    arena = taut_arena_new();
    found->why = read_witness(request, arena, &task, found->direction);
    found->exponent = task.exponent;
    status = taut_arena_status(arena);
    if (status == TAUT_OK && found->why == NULL) {
        status = bound_gap(&task, found);
    }
    taut_arena_free(arena);
    return status;
}

/* The area measured, where it lies within its bounds, else the lower of these; in squares of
 * 2^exponent. */
static double area_of(double given, const finding *found)
{
    const double area = ldexp(given, -2 * found->exponent);

    return area >= found->area_low * (1 - area_apart) && area <= found->area_high * (1 + area_apart)
               ? area
               : found->area_low;
}

double taut_least_tell(const taut_least_finding *found, double measured, double measured_error,
                       double tension, taut_record *figures)
{
    const double area = area_of(measured, found),
                 told = ldexp(measured_error, -2 * found->exponent);
    const double error = told > 0 ? told : 0;
    const double lower =
        (area - error - found->gap) * (area > error + found->gap ? 1 - 0x1p-50 : 1);

    taut_record_add_number(figures, "lower_bound",
                           tension * ldexp(fmax(0, lower), 2 * found->exponent));
    taut_record_add_number(figures, "gap", tension * ldexp(found->gap, 2 * found->exponent));
    taut_record_add_numbers(figures, "direction", 3, found->direction);
    return area > error ? found->gap / (area - error) : INFINITY;
}

taut_status taut_certify_add_least(const taut_least_request *request, taut_record *figures,
                                   taut_certificate *certificate)
{
    char where[128] = "";
    finding found = {.why = NULL};
    taut_claim claim = {
        .claim = "least",
        .kind = TAUT_BOUND,
        .residual = NAN,
        .limit = request->gap > 0 ? request->gap : limit_default,
        .holds = TAUT_UNDECIDED,
        .where = where,
    };
    const taut_status status = find_bound(request, &found);

    if (status != TAUT_OK) {
        return status;
    }
    if (found.why == NULL) {
        claim.residual = taut_least_tell(&found, request->area, request->area_error, 1, figures);
        claim.holds = taut_certify_below(claim.residual, claim.limit);
        if (claim.holds == TAUT_FALSE && !(request->gap > 0)) {
            claim.holds = TAUT_UNDECIDED;
            snprintf(where, sizeof where, "coarse: ask for a \"gap\" to have knots put in");
        }
    } else {
        snprintf(where, sizeof where, "%s", found.why);
    }
    if (request->gap > 0 && claim.holds == TAUT_UNDECIDED) {
        claim.holds = TAUT_FALSE; /* the document asks for the proof */
    }
    return taut_certificate_add(certificate, &claim);
}
