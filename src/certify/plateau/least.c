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
#include "certify/plateau/flux.h"
#include "certify/plateau/outline.h"
#include "core/arena.h"
#include "core/vec3.h"
#include "geometry/keep.h"
#include "taut/plateau.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { DEGREES_ABOVE = 4 /* of psi over the film */ };
static const double limit_default = 1e-6;
static const double theta_most = 1e-9;
static const double area_apart = 1e-3; /* of the area measured, from the bounds of it */
/* Rows whose products differ by at most 8 u from those of orthonormal rows, as computed, are within
 * 36 u of such rows: sqrt(9) 12 u by the polar factor. */
static const double frame_defect = 8 * 0x1p-53, frame_error = 36 * 0x1p-53;

/* Why there is no bound, or the bound. */
typedef struct finding {
    const char *why; /* NULL: there is one */
    double gap;      /* in squares of 2^exponent */
    double area_low, area_high;
    double direction[3];
    int exponent;
} finding;

/* ---- the witness, as it was written by whoever ---- */

static const double *read_numbers(const taut_record *list, size_t count, taut_arena *arena)
{
    double *numbers = taut_arena_take(arena, count, sizeof(double));

    if (numbers == NULL || taut_record_count(list) != count) {
        return NULL;
    }
    for (size_t k = 0; k < count; k++) {
        numbers[k] = taut_record_number(taut_record_at(list, k));
    }
    return numbers;
}

/* A basis on the breaks of `film`, a few degrees above it at most; NULL for any other. */
static const taut_basis *read_basis(const taut_record *record, const taut_basis *film,
                                    taut_arena *arena)
{
    const char *type = taut_record_text(taut_record_get(record, "type"));
    const double degree = taut_record_number(taut_record_get(record, "degree"));
    const taut_record *knots = taut_record_get(record, "knots");
    const taut_record *range = taut_record_get(record, "range");
    const int most = taut_basis_local(film) - 1 + DEGREES_ABOVE,
              spans = taut_basis_span_count(film);
    taut_basis_spec spec = {.type = type};
    taut_basis *basis = NULL;

    if (!(degree >= 1 && degree <= most && degree <= TAUT_DEGREE_MAX) || degree != floor(degree)) {
        return NULL;
    }
    spec.degree = (int)degree;
    if (strcmp(type, "bspline") == 0) {
        if (taut_record_count(knots) > (size_t)(spec.degree + 1) * ((size_t)spans + 1)) {
            return NULL;
        }
        spec.knot_count = (int)taut_record_count(knots);
        spec.knots = read_numbers(knots, taut_record_count(knots), arena);
    } else if (strcmp(type, "bezier") != 0) {
        return NULL;
    } else if (range != NULL) {
        const double *ends = read_numbers(range, 2, arena);
        spec.has_range = 1;
        if (ends == NULL) {
            return NULL;
        }
        memcpy(spec.range, ends, sizeof spec.range);
    }
    const taut_status status = taut_basis_new(&spec, 0, &basis, NULL);
    if ((status == TAUT_OK || status == TAUT_NO_MEMORY) && !taut_keep_basis(arena, basis)) {
        return NULL; /* the arena tells */
    }
    if (status != TAUT_OK) {
        return NULL;
    }
    return taut_basis_span_count(basis) == spans &&
                   memcmp(taut_basis_breaks(basis), taut_basis_breaks(film),
                          ((size_t)spans + 1) * sizeof(double)) == 0
               ? basis
               : NULL;
}

/* The coefficients over 2^exponent, all finite; NULL otherwise. */
static const double *read_coefficients(const taut_record *rows, const taut_flux_task *task,
                                       taut_arena *arena)
{
    const size_t nu = (size_t)taut_basis_count(task->u), nv = (size_t)taut_basis_count(task->v);
    double *all = taut_arena_take(arena, nu * nv, sizeof(double));
    double largest = 0;

    if (all == NULL || taut_record_count(rows) != nu) {
        return NULL;
    }
    for (size_t i = 0; i < nu; i++) {
        const taut_record *row = taut_record_at(rows, i);
        if (taut_record_count(row) != nv) {
            return NULL;
        }
        for (size_t j = 0; j < nv; j++) {
            const double x = taut_record_number(taut_record_at(row, j));
            all[i * nv + j] = ldexp(x, -task->exponent);
            largest = taut_certify_max(largest, fabs(all[i * nv + j]));
        }
    }
    return isfinite(largest) ? all : NULL;
}

/* A right-handed frame whose third row is e made unit; 0 where rounding leaves none. */
static int make_frame(const double given[3], double frame[3][3])
{
    const double largest = taut_largest_coordinate(given);
    double e[3], axis[3] = {0, 0, 0};
    int flat = 0;

    if (!(largest > 0) || !isfinite(largest) || !isfinite(given[0] + given[1] + given[2])) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        e[c] = given[c] / largest;
        flat = fabs(given[c]) < fabs(given[flat]) ? c : flat;
    }
    const double length = sqrt(taut_dot(e, e));
    axis[flat] = 1;
    for (int c = 0; c < 3; c++) {
        frame[2][c] = e[c] / length;
    }
    taut_cross(frame[2], axis, frame[1]);
    const double across = sqrt(taut_dot(frame[1], frame[1]));
    for (int c = 0; c < 3; c++) {
        frame[1][c] /= across;
    }
    taut_cross(frame[1], frame[2], frame[0]);
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b <= a; b++) {
            if (!(fabs(taut_dot(frame[a], frame[b]) - (a == b)) <= frame_defect)) {
                return 0;
            }
        }
    }
    return 1;
}

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

/* Why the witness is none, or NULL. */
static const char *read_witness(const taut_least_request *request, taut_arena *arena,
                                taut_flux_task *task, double direction[3])
{
    const taut_record *witness = request->witness;
    const double *e = read_numbers(taut_record_get(witness, "direction"), 3, arena);

    task->surface = request->surface;
    task->frame_error = frame_error;
    task->crew = request->crew;
    task->wanted = request->gap > 0 ? request->gap : limit_default;
    if (e == NULL || !make_frame(e, task->frame)) {
        return "witness: its direction is none";
    }
    memcpy(direction, task->frame[2], 3 * sizeof(double));
    if (!find_unit(request->surface, task)) {
        return "range: the film has no size";
    }
    task->u = read_basis(taut_record_get(witness, "u"), taut_surface_u(task->surface), arena);
    task->v = read_basis(taut_record_get(witness, "v"), taut_surface_v(task->surface), arena);
    if (task->u == NULL || task->v == NULL) {
        return "witness: its bases are not on the spans of the film";
    }
    task->coefficients = read_coefficients(taut_record_get(witness, "coefficients"), task, arena);
    return task->coefficients != NULL ? NULL : "witness: its coefficients do not fit its bases";
}

/* ---- what it proves ---- */

static const char *reason_of(taut_flux_verdict verdict)
{
    static const char *const reasons[] = {
        [TAUT_FLUX_FOLDS] = "folds: along the direction the film is not shown to be a graph",
        [TAUT_FLUX_STEEP] = "steep: the slope of the witness is not shown to be at most 1",
        [TAUT_FLUX_WORK] = "work: the proof would take too long",
        [TAUT_FLUX_RANGE] = "range: " TAUT_CERTIFY_OUT_OF_RANGE};
    return reasons[verdict];
}

static taut_status bound_gap(taut_flux_task *task, finding *found)
{
    taut_flux_bound flux;
    taut_outline_bound outline = {0, 0};
    taut_status status = taut_certify_flux(task, &flux);

    if (status != TAUT_OK || flux.verdict != TAUT_FLUX_ADMITTED) {
        found->why = reason_of(flux.verdict);
        return status;
    }
    status = taut_certify_outline(task, &outline);
    const double theta = outline.turned_back;
    if (!(theta <= theta_most) || !(flux.shadow > 6 * theta * outline.length * outline.length)) {
        found->why = "outline: along the direction the boundary is not shown to be convex";
        return status;
    }
    found->area_low = flux.area_low;
    found->area_high = flux.area_high;
    found->gap = (1 + 0x1p-40) * (flux.gap + theta * theta * flux.area_high);
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
static double area_of(const taut_least_request *request, const finding *found)
{
    const double area = ldexp(request->area, -2 * found->exponent);

    return area >= found->area_low * (1 - area_apart) && area <= found->area_high * (1 + area_apart)
               ? area
               : found->area_low;
}

/* What is proved: the residual, and the figures. */
static double tell(const taut_least_request *request, const finding *found, taut_record *figures)
{
    const double area = area_of(request, found),
                 told = ldexp(request->area_error, -2 * found->exponent);
    const double error = told > 0 ? told : 0;
    const double lower =
        (area - error - found->gap) * (area > error + found->gap ? 1 - 0x1p-50 : 1);

    taut_record_add_number(figures, "lower_bound", ldexp(fmax(0, lower), 2 * found->exponent));
    taut_record_add_number(figures, "gap", ldexp(found->gap, 2 * found->exponent));
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
        claim.residual = tell(request, &found, figures);
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
