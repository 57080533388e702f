/* film.c -- is this film at rest, and on what holds it?
 *
 * Claims:
 *
 *   boundary    where edges are held: the largest distance of one from its chord or curve, at equal
 *               parts of their ranges, proved (certify/common/curve_distance.h), over the size of
 *               the film; of several the one nearest to its limit. Limit: twice what a least squares fit of the certificate's own is proved to
 *               be off by (certify/plateau/fit.h), and rounding, 64 (p + q + n) 2^-53.
 *   held        largest distance of a corner from the problem's, over the size: 0. Where points are kept on planes or lines,
 *               the largest distance of one from them too, and then the limit is 64 2^-53.
 *   seams       of a film that goes around: the largest difference of two coordinates that are one: 0.
 *   mirror      of edges in mirrors: largest distance of a point from the plane, over the size. Limit 64 2^-53.
 *   cables      how many numbers of the curves differ from the edges they are: 0.
 *   length      of cables of given length: the largest |L - given| / given, by the quadrature of
 *               `stationary`. Limit 1e-10.
 *   stationary  largest derivative of E along a move that E sees (certify/film/moves.h) over the
 *               largest of the area alone in the net, held points too, and along a cable over its
 *               force where that is more; or, where that is more, tolerance / 1e-6 times the same
 *               over all coordinates. Limit: the tolerance, at most 1e-6. Nodes are raised
 *               until the judgement stays. The force of a cable of given length is the certificate's
 *               own (certify/film/sheet.h), and has to be positive.
 *   stable      lowest eigenvalue of the second variation over those moves, scaled; holds above
 *               1e-6, by the inertia of the factors.
 *   least       (energy - bound) / energy (certify/film/least.h). Null where that is above the limit,
 *               1e-6, by fields that the model carries 1e-3, or no bound is known, and why.
 *   equilibrium where it is asked for: the largest defect.
 *   details     only where they say what the certificate does not find (certify/film/complex/told.h)
 */
#include "taut/film.h"

#include "certify/certify_ops.h"
#include "certify/common/verdict.h"
#include "certify/film/complex/complex.h"
#include "certify/film/complex/told.h"
#include "certify/film/edge.h"
#include "certify/film/folds.h"
#include "certify/film/images.h"
#include "certify/film/least.h"
#include "certify/film/lines.h"
#include "certify/film/moves.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "measure/integrate/integrals.h"
#include "measure/integrate/line.h"
#include "problem/film_complex.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { GRID = 101 /* as taut_measure_surface */, RULES = 6, SECOND_EXTRA = 1 };
static const int extra_nodes[RULES] = {4, 8, 15, 27, 48, 76};
static const double tolerance_default = 1e-10, largest_limit = 1e-6, stable_limit = 1e-6,
                    length_limit = 1e-10, kept_limit = 0x1p-47; /* 64 2^-53 */
static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};
static const char *const corner_names[4] = {"u0v0", "u1v0", "u0v1", "u1v1"};

/* What is certified. */
typedef struct request {
    const taut_model *model;
    const taut_surface *surface;
    const taut_film_problem *problem;
    int nu, nv;
    int all; /* is it to rest in all coordinates? Not by the method `normal`, asked for or told in the details */
    double tolerance;
    double
        half; /* half the size of the film: of the largest coordinate of a point from the first */
    taut_crew crew;
} request;

static int corner_of(int e, int end)
{
    return e < 2 ? e + 2 * end : end + 2 * (e - 2);
}

static const double *corner_point(const request *r, int c)
{
    const size_t i = (size_t)(c % 2 * (r->nu - 1)), j = (size_t)(c / 2 * (r->nv - 1));
    return taut_surface_points(r->surface) + 3 * (i * (size_t)r->nv + j);
}

static taut_status read_request(const taut_model *model, const taut_film_problem *problem,
                                request *r, taut_error *error)
{
    *r = (request){.model = model, .surface = taut_model_surface(model, 0), .problem = problem};
    if (r->surface == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces", 0, 1,
                         "the model has no surface, expected the one of its problem");
    }
    if (problem == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "needs-problem", "/edges", taut_none, taut_none,
                         "the model does not say how its edges were held: give the problem the "
                         "model was made from too");
    }
    if (problem->u == NULL || problem->v == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a film problem needs two bases");
    }
    const char *method = taut_record_text(taut_record_get(taut_model_details(model), "method"));
    r->all =
        problem->method == TAUT_FILM_FULL && !(method != NULL && strcmp(method, "normal") == 0);
    r->nu = taut_basis_count(taut_surface_u(r->surface));
    r->nv = taut_basis_count(taut_surface_v(r->surface));
    if (!taut_basis_equal(problem->u, taut_surface_u(r->surface)) ||
        !taut_basis_equal(problem->v, taut_surface_v(r->surface)) ||
        taut_surface_weights(r->surface) != NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces/0/points", taut_none, taut_none,
                         "the model's net is %d by %d and not on the bases of the problem, %d by "
                         "%d without weights: they do not belong together",
                         r->nu, r->nv, taut_basis_count(problem->u), taut_basis_count(problem->v));
    }
    r->tolerance =
        fmin(problem->tolerance > 0 ? problem->tolerance : tolerance_default, largest_limit);
    r->half = taut_half_size(taut_point_count(r->surface), taut_surface_points(r->surface));
    return TAUT_OK;
}

/* ---- the edges ---- */

static taut_status check_edge(const request *r, int e, taut_film_boundary *b, int *worst,
                              taut_error *error)
{
    taut_film_asked asked = {.curve = r->problem->edges[e].curve,
                             .is_fitted = r->problem->ring != TAUT_FILM_OPEN,
                             .size = 2 * r->half,
                             .away = taut_norm(corner_point(r, 0))};
    int is_worst = 0;

    for (int end = 0; end < 2; end++) {
        memcpy(asked.ends[end], corner_point(r, corner_of(e, end)), sizeof asked.ends[end]);
    }
    const taut_status status = taut_film_judge_edge(r->surface, e, &asked, b, &is_worst, error);
    *worst = is_worst ? e : *worst;
    return status;
}

static taut_status add_boundary(const request *r, taut_certificate *certificate, taut_error *error)
{
    taut_film_boundary b = {.count = 0};
    int worst = 0;

    for (int e = 0; e < 4; e++) {
        if (r->problem->edges[e].kind == TAUT_FILM_FIXED &&
            taut_film_sheet_has_edge(r->problem, e)) {
            const taut_status status = check_edge(r, e, &b, &worst, error);
            if (status != TAUT_OK) {
                return status;
            }
        }
    }
    if (b.count == 0) {
        return TAUT_OK;
    }
    taut_claim claim = {.claim = "boundary",
                        .kind = b.fitted ? TAUT_BOUND : TAUT_EXACT,
                        .residual = b.residual,
                        .limit = b.limit,
                        .holds = taut_certify_below(b.residual, b.limit),
                        .where = edge_names[worst]};
    if (claim.holds == TAUT_UNDECIDED) {
        claim.where = "the certificate's own fit fails";
    }
    return taut_certificate_add(certificate, &claim) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

/* How far point (i, j) is from what guide it is kept on, over the size. */
static double away_from(const request *r, int i, int j, const taut_film_guide *guide, int is_line)
{
    const double *x = taut_surface_points(r->surface) + 3 * ((size_t)i * (size_t)r->nv + (size_t)j);
    double from[3], across[3];

    taut_difference(x, guide->point, from);
    taut_cross(from, guide->direction, across);
    const double away = is_line ? taut_norm(across) : fabs(taut_dot(from, guide->direction));
    return away / taut_norm(guide->direction) / (2 * r->half);
}

/* The farthest that a point of edge e is from its plane, over the size. */
static double leave_plane(const request *r, int e)
{
    double largest = 0;

    for (int k = 0; k < (e < 2 ? r->nv : r->nu); k++) {
        const int i = e < 2 ? (e == 1 ? r->nu - 1 : 0) : k, j = e < 2 ? k : e == 3 ? r->nv - 1 : 0;
        largest = taut_certify_max(largest, away_from(r, i, j, &r->problem->edges[e].plane, 0));
    }
    return largest;
}

/* The farther of two, and where. */
static void take_farther(double away, const char *where, taut_claim *claim)
{
    if (!(away <= claim->residual)) {
        claim->residual = away;
        claim->where = where;
    }
}

/* Where corners, lines and planes have to be. */
static taut_status add_held(const request *r, taut_certificate *certificate)
{
    taut_claim claim = {.claim = "held", .kind = TAUT_EXACT, .holds = TAUT_TRUE, .where = ""};

    for (int c = 0; c < 4; c++) {
        const taut_film_corner_kind kind = r->problem->corner_kinds[c];
        const int is_held = kind == TAUT_FILM_HELD;
        if (is_held && r->problem->has_corner[c]) {
            take_farther(taut_distance(corner_point(r, c), r->problem->corners[c]) / (2 * r->half),
                         corner_names[c], &claim);
        }
        if (kind == TAUT_FILM_ON_LINE || kind == TAUT_FILM_ON_PLANE) {
            claim.limit = kept_limit;
            take_farther(away_from(r, c % 2 * (r->nu - 1), c / 2 * (r->nv - 1),
                                   &r->problem->guides[c], kind == TAUT_FILM_ON_LINE),
                         corner_names[c], &claim);
        }
    }
    for (int e = 0; e < 4; e++) {
        if (taut_film_sheet_in_plane(&r->problem->edges[e])) {
            claim.limit = kept_limit;
            take_farther(leave_plane(r, e), edge_names[e], &claim);
        }
    }
    claim.holds = taut_certify_below(claim.residual, claim.limit);
    return taut_certificate_add(certificate, &claim);
}

/* The first and the last row of a net that goes around are one. */
static taut_status add_seams(const request *r, taut_certificate *certificate)
{
    const int along_u = r->problem->ring == TAUT_FILM_RING_U;
    const double *points = taut_surface_points(r->surface);
    taut_claim claim = {.claim = "seams", .kind = TAUT_EXACT, .where = ""};

    for (int k = 0; k < (along_u ? r->nv : r->nu); k++) {
        const size_t nv = (size_t)r->nv, last_u = (size_t)r->nu - 1;
        const double *a = points + 3 * (along_u ? (size_t)k : (size_t)k * nv);
        const double *b =
            points + 3 * (along_u ? last_u * nv + (size_t)k : (size_t)k * nv + nv - 1);
        for (int c = 0; c < 3; c++) {
            claim.residual = taut_certify_max(claim.residual, fabs(a[c] - b[c]));
        }
    }
    claim.holds = taut_certify_below(claim.residual, 0);
    return r->problem->ring != TAUT_FILM_OPEN ? taut_certificate_add(certificate, &claim) : TAUT_OK;
}

static taut_status add_mirror(const request *r, taut_certificate *certificate)
{
    taut_claim claim = {.claim = "mirror", .kind = TAUT_EXACT, .limit = kept_limit, .where = ""};
    int count = 0;

    for (int e = 0; e < 4; e++) {
        if (r->problem->edges[e].kind == TAUT_FILM_SLIDE && r->problem->edges[e].is_mirror) {
            take_farther(leave_plane(r, e), edge_names[e], &claim);
            count++;
        }
    }
    claim.holds = taut_certify_below(claim.residual, claim.limit);
    return count > 0 ? taut_certificate_add(certificate, &claim) : TAUT_OK;
}

/* How many coordinates of a curve are not those of its edge; all, where its basis is another. */
static int count_differences(const request *r, const taut_curve *curve, int e)
{
    const taut_basis *basis = e < 2 ? r->problem->v : r->problem->u;
    const size_t nv = (size_t)r->nv, step = e < 2 ? 1 : nv;
    const size_t first = e == 1 ? (size_t)(r->nu - 1) * nv : e == 3 ? nv - 1 : 0;
    const int count = e < 2 ? r->nv : r->nu;
    int differences = 0;

    if (!taut_basis_equal(taut_curve_t(curve), basis) || taut_curve_weights(curve) != NULL) {
        return 3 * count;
    }
    for (int k = 0; k < count; k++) {
        const double *x = taut_surface_points(r->surface) + 3 * (first + (size_t)k * step);
        for (int c = 0; c < 3; c++) {
            differences += taut_curve_points(curve)[3 * k + c] != x[c];
        }
    }
    return differences;
}

static int find_curve(const taut_model *model, const char *name)
{
    for (int k = 0; k < taut_model_curve_count(model); k++) {
        if (strcmp(taut_curve_name(taut_model_curve(model, k)), name) == 0) {
            return k;
        }
    }
    return -1;
}

static taut_status add_cables(const request *r, taut_certificate *certificate)
{
    taut_claim claim = {.claim = "cables", .kind = TAUT_EXACT, .holds = TAUT_TRUE, .where = ""};
    int count = 0;

    for (int e = 0; e < 4; e++) {
        if (r->problem->edges[e].kind == TAUT_FILM_CABLE) {
            const int at = find_curve(r->model, edge_names[e]);
            const int differences =
                at < 0 ? 1 : count_differences(r, taut_model_curve(r->model, at), e);
            claim.where = differences > 0 ? edge_names[e] : claim.where;
            claim.residual += differences;
            count++;
        }
    }
    claim.holds = claim.residual == 0 ? TAUT_TRUE : TAUT_FALSE;
    return count > 0 ? taut_certificate_add(certificate, &claim) : TAUT_OK;
}

/* ---- at rest ---- */

/* What the derivatives say. */
typedef struct finding {
    double residual; /* along moves, or of all coordinates as it counts */
    double area, lengths[4];
    double stored, gain; /* of threads: P over the tension; what is left of it to gain at most */
    int bounded;         /* is `gain` known? */
    double lowest, relative; /* eigenvalue, and times size^2 over the tension */
    double mean;             /* the largest |H| */
    int below, at;
    int passed; /* the corner in which a cable passes another edge, or -1 */
    int settled;
    double forces[4], given[4]; /* lengths */
} finding;

/* What derivatives are held against: inside the largest of the area alone, along a cable its force
 * where that is more. A cable beside which the film is nothing hides nothing of the film, nor of another cable. */
static double scale_of(const taut_film_sheet *sheet, double largest, int i, int j)
{
    const double at_u = i == 0 ? sheet->ratios[0] : i == sheet->nu - 1 ? sheet->ratios[1] : 0;
    const double at_v = j == 0 ? sheet->ratios[2] : j == sheet->nv - 1 ? sheet->ratios[3] : 0;
    return taut_certify_max(largest, taut_certify_max(at_u, at_v));
}

static void scale_gradient(const taut_film_sheet *sheet, double largest, double *gradient)
{
    for (int k = 0; k < sheet->nu * sheet->nv; k++) {
        const double scale = scale_of(sheet, largest, k / sheet->nv, k % sheet->nv);
        for (int c = 0; c < 3; c++) {
            gradient[3 * k + c] /= scale;
        }
    }
}

/* The largest derivative along a coordinate that is not held. */
static double largest_free(const taut_film_sheet *sheet, const double *gradient, int *point)
{
    double largest = 0;
    for (int at = 0; at < sheet->nu * sheet->nv; at++) {
        double g[3], normals[3][3];
        int e = -1;
        if (taut_film_sheet_way(sheet, at / sheet->nv, at % sheet->nv, &e) == TAUT_FILM_STILL) {
            continue;
        }
        const int count = taut_film_sheet_normals(sheet, at / sheet->nv, at % sheet->nv, normals);
        memcpy(g, gradient + 3 * at, sizeof g);
        for (int n = 0; n < count; n++) {
            taut_add_scaled(-taut_dot(g, normals[n]), normals[n], g);
        }
        const double size = taut_largest_coordinate(g);
        if (!(size <= largest) && !isnan(largest)) {
            largest = size;
            *point = at;
        }
    }
    return largest;
}

static taut_status find_rest(const request *r, int rule, taut_arena *arena, finding *found)
{
    taut_film_sheet sheet;
    taut_film_moves moves;
    const size_t count = taut_point_count(r->surface);
    double *gradient = taut_arena_take(arena, count, 3 * sizeof(double));
    double *moments = taut_arena_take(arena, count, 3 * sizeof(double));
    double largest = 0;
    int at_move = 0, at_free = 0;

    if (taut_arena_status(arena) != TAUT_OK ||
        taut_film_sheet_new(r->surface, r->problem, extra_nodes[rule], arena, &sheet) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_film_sheet_gradient(&sheet, gradient, moments, &found->area, &largest, found->lengths);
    if (taut_film_moves_new(&sheet, moments, &moves) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    scale_gradient(&sheet, largest, gradient);
    const double along = taut_film_moves_largest(&moves, gradient, &at_move);
    const double free =
        r->all ? largest_free(&sheet, gradient, &at_free) * (r->tolerance / largest_limit) : 0;
    found->residual = taut_certify_max(along, free);
    found->at = along >= free ? at_move : at_free;
    found->passed = taut_film_passed_at(&sheet);
    found->area = ldexp(found->area, 2 * sheet.unit);
    for (int e = 0; e < 4; e++) {
        found->lengths[e] = ldexp(found->lengths[e], sheet.unit);
        found->forces[e] = sheet.forces[e];
        found->given[e] = taut_film_sheet_given(r->surface, r->problem, e);
    }
    return TAUT_OK;
}

/* Nodes are raised until what is found stays, to a quarter of what is allowed. */
static taut_status settle_rest(const request *r, finding *found)
{
    const double limit = r->tolerance;
    double before = INFINITY;

    for (int rule = 0; rule < RULES && !found->settled; rule++) {
        taut_arena *arena = taut_arena_new();
        const taut_status status = find_rest(r, rule, arena, found);
        taut_arena_free(arena);
        if (status != TAUT_OK) {
            return status;
        }
        found->settled = (found->residual <= limit && before <= limit) ||
                         fabs(found->residual - before) <= 0.25 * fmin(found->residual, before);
        before = found->residual;
    }
    return TAUT_OK;
}

/* What the threads store, and what is left of it to gain. */
static taut_status find_gain(const request *r, const taut_film_sheet *sheet,
                             const taut_film_moves *moves, const double *gradient, finding *found)
{
    if (!taut_film_sheet_has_threads(r->problem)) {
        return TAUT_OK;
    }
    const taut_status status =
        taut_film_moves_bound(sheet, moves, gradient, r->crew.pulse, &found->gain);
    found->bounded = status == TAUT_OK;
    found->gain = ldexp(found->gain, 2 * sheet->unit);
    found->stored = ldexp(taut_film_sheet_stored(sheet), 2 * sheet->unit);
    return status == TAUT_NOT_CONVERGED ? TAUT_OK : status;
}

static taut_status find_stability(const request *r, finding *found)
{
    taut_arena *arena = taut_arena_new();
    const size_t count = taut_point_count(r->surface);
    double *gradient = taut_arena_take(arena, count, 3 * sizeof(double));
    double *moments = taut_arena_take(arena, count, 3 * sizeof(double));
    double area = 0, largest = 0, lengths[4];
    taut_film_sheet sheet;
    taut_film_moves moves;
    taut_status status = taut_arena_status(arena);

    if (status == TAUT_OK) {
        status = taut_film_sheet_new(r->surface, r->problem, SECOND_EXTRA, arena, &sheet);
    }
    if (status == TAUT_OK) {
        taut_film_sheet_gradient(&sheet, gradient, moments, &area, &largest, lengths);
        status = taut_film_moves_new(&sheet, moments, &moves);
    }
    if (status == TAUT_OK) {
        status = find_gain(r, &sheet, &moves, gradient, found);
    }
    if (status == TAUT_OK) {
        status = taut_film_moves_lowest(&sheet, &moves, ldexp(r->half, 1 - sheet.unit),
                                        stable_limit, r->crew.pulse, &found->lowest, &found->below);
        const double size = ldexp(r->half, 1 - sheet.unit);
        found->relative = found->lowest * size * size;
        found->lowest = ldexp(found->lowest * sheet.tension, -2 * sheet.unit);
    }
    taut_arena_free(arena);
    return status == TAUT_NOT_CONVERGED ? TAUT_OK : status;
}

/* Two searches that share nothing but the request: stability, which takes longer and is watched, and the rest. */
typedef struct searches {
    const request *r;
    finding *found; /* each fills its own members */
    taut_status stability, rest;
} searches;

static void search(void *context, int part, int from, int to)
{
    searches *s = context;

    (void)part;
    for (; from < to; from++) {
        if (from == 0) {
            s->stability = find_stability(s->r, s->found);
        } else {
            s->rest = settle_rest(s->r, s->found);
            if (s->rest == TAUT_OK) {
                s->rest = taut_mean_largest(s->r->surface, GRID, NULL, &s->found->mean);
            }
        }
    }
}

static taut_status find_all(const request *r, finding *found)
{
    searches s = {.r = r, .found = found};

    taut_parallel_for(2, r->crew.threads, search, &s);
    if (taut_pulse_report(r->crew.pulse)) {
        return TAUT_INTERRUPTED;
    }
    return s.stability != TAUT_OK ? s.stability : s.rest;
}

/* Force by force: is every cable drawn? */
static int has_slack(const request *r, const finding *found)
{
    for (int e = 0; e < 4; e++) {
        if (r->problem->edges[e].kind == TAUT_FILM_CABLE && !(found->forces[e] > 0)) {
            return 1;
        }
    }
    return 0;
}

static taut_status add_length(const request *r, const finding *found, taut_certificate *certificate)
{
    taut_claim claim = {.claim = "length", .kind = TAUT_CHECK, .limit = length_limit, .where = ""};
    int count = 0;

    for (int e = 0; e < 4; e++) {
        const double off =
            found->given[e] > 0 ? fabs(found->lengths[e] - found->given[e]) / found->given[e] : 0;
        if (found->given[e] > 0 && (count++ == 0 || !(off <= claim.residual))) {
            claim.residual = off;
            claim.where = edge_names[e];
        }
    }
    claim.holds = taut_certify_below(claim.residual, claim.limit);
    if (r->problem != NULL && count > 0 && claim.holds == TAUT_UNDECIDED) {
        claim.where = TAUT_CERTIFY_OUT_OF_RANGE;
    }
    return count > 0 ? taut_certificate_add(certificate, &claim) : TAUT_OK;
}

static taut_status add_stationary(const request *r, const finding *found,
                                  taut_certificate *certificate)
{
    char where[64];
    int folds = 0;
    double u = 0, v = 0;
    taut_claim claim = {.claim = "stationary",
                        .kind = TAUT_CHECK,
                        .residual = found->residual,
                        .limit = r->tolerance,
                        .where = where};

    snprintf(where, sizeof where, "/surfaces/0/points/%d/%d", found->at / r->nv, found->at % r->nv);
    if (r->problem->updates > 0) {
        claim.residual = taut_none;
        claim.where = "updates: the last reference is no part of the model";
        claim.holds = TAUT_UNDECIDED;
        return taut_certificate_add(certificate, &claim);
    }
    const taut_status status = taut_film_find_fold(r->surface, &folds, &u, &v);
    if (status != TAUT_OK) {
        return status;
    }
    claim.holds = taut_certify_below(claim.residual, claim.limit);
    if (claim.holds == TAUT_UNDECIDED) {
        snprintf(where, sizeof where, TAUT_CERTIFY_OUT_OF_RANGE);
    } else if (folds) {
        claim.holds = TAUT_FALSE;
        claim.residual = taut_certify_max(claim.residual, 1);
        snprintf(where, sizeof where, "it folds over at u = %.4g, v = %.4g", u, v);
    } else if (found->passed >= 0) {
        claim.holds = TAUT_FALSE;
        claim.residual = taut_certify_max(claim.residual, 1);
        snprintf(where, sizeof where, "a cable passes another edge in corner %s",
                 corner_names[found->passed]);
    } else if (has_slack(r, found)) {
        claim.holds = TAUT_FALSE;
        snprintf(where, sizeof where, "a cable is slack");
    } else if (!found->settled) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "no Gauss rule settles the integrals");
    }
    return taut_certificate_add(certificate, &claim);
}

static taut_status add_stable(const request *r, const finding *found, taut_certificate *certificate)
{
    taut_claim claim = {.claim = "stable",
                        .kind = TAUT_CHECK,
                        .residual = found->relative,
                        .limit = stable_limit,
                        .where = ""};

    if (r->problem->accepts_stationary) {
        claim.holds = TAUT_UNDECIDED;
        claim.where = "stationary: the problem accepts films that are no minimum";
        return taut_certificate_add(certificate, &claim);
    }
    claim.holds = found->below < 0    ? TAUT_UNDECIDED
                  : found->below == 0 ? taut_certify_above(claim.residual, claim.limit)
                                      : TAUT_FALSE;
    if (claim.holds == TAUT_UNDECIDED) {
        claim.where = "no eigenvalue is found";
    }
    return taut_certificate_add(certificate, &claim);
}

/* ---- figures ---- */

static double cable_energy(const taut_film_edge *edge, double length)
{
    const double longer = length - edge->unstressed;
    return edge->law == TAUT_FILM_FORCE ? edge->force * length
           : edge->law == TAUT_FILM_ELASTIC
               ? edge->stiffness * longer * longer / (2 * edge->unstressed)
               : 0;
}

static double find_energy(const request *r, const finding *found, const taut_film_sheet *sheet)
{
    double energy =
        sheet->tension * (taut_film_sheet_has_threads(r->problem) ? found->stored : found->area);
    for (int e = 0; e < 4; e++) {
        if (r->problem->edges[e].kind == TAUT_FILM_CABLE) {
            energy += cable_energy(&r->problem->edges[e], found->lengths[e]);
        }
    }
    return energy;
}

/* No film of the space, with the same held points, stores less than this; NULL, or why there is no such number. */
static const char *threads_bound(const request *r, const finding *found,
                                 const taut_film_sheet *sheet, double *bound)
{
    const double rounding = 1e-13; /* of the energy: of sums that are as long as the net is large */
    const double energy = find_energy(r, found, sheet);

    for (int e = 0; e < 4; e++) {
        if (found->given[e] > 0) {
            return "length: the bound is one of cables of force or elasticity";
        }
    }
    if (r->problem->updates > 0) {
        return "updates: the last reference is no part of the model";
    }
    *bound = energy - sheet->tension * found->gain - rounding * energy;
    return found->bounded ? NULL : "the threads' matrix is not safely positive definite";
}

static taut_status find_least(const request *r, const finding *found, const taut_film_sheet *sheet,
                              taut_film_least *least)
{
    *least = (taut_film_least){.limit = largest_limit};
    if (r->problem->without_least) {
        least->why = "declined: the problem asks for no bound";
        return TAUT_OK;
    }
    if (taut_film_sheet_has_threads(r->problem)) {
        least->why = threads_bound(r, found, sheet, &least->bound);
        return TAUT_OK;
    }
    const taut_record *witness = taut_record_get(taut_model_details(r->model), "least");
    return taut_film_least_of(sheet, witness, found->given, least);
}

static taut_status add_least(const request *r, const finding *found, const taut_film_sheet *sheet,
                             taut_record *figures, taut_certificate *certificate)
{
    const double energy = find_energy(r, found, sheet);
    taut_film_least least;
    const taut_status status = find_least(r, found, sheet, &least);
    taut_claim claim = {.claim = "least",
                        .kind = taut_film_sheet_has_threads(r->problem) ? TAUT_CHECK : TAUT_BOUND,
                        .residual = taut_none,
                        .limit = least.limit,
                        .holds = TAUT_UNDECIDED,
                        .where = least.why};

    if (status != TAUT_OK) {
        return status;
    }
    if (least.why == NULL) {
        claim.residual = (energy - least.bound) / energy;
        claim.holds = taut_certify_below(claim.residual, claim.limit);
        claim.where = claim.holds == TAUT_UNDECIDED ? TAUT_CERTIFY_OUT_OF_RANGE
                      : claim.holds == TAUT_FALSE
                          ? "coarse: there is a bound, further below; take more points"
                          : "";
        claim.holds = claim.holds == TAUT_FALSE ? TAUT_UNDECIDED : claim.holds;
        if (claim.residual <
            -largest_limit) { /* less than a bound of all that are held alike: it is not held so */
            claim.holds = TAUT_UNDECIDED;
            claim.where = "below: the film has less energy than the bound, so that it is not held "
                          "as the bound has it";
        }
        taut_record_add_number(figures, "lower_bound", least.bound);
        taut_record_add_number(figures, "gap", energy - least.bound);
    }
    return taut_certificate_add(certificate, &claim);
}

static void add_lists(const request *r, const finding *found, const taut_film_sheet *sheet,
                      taut_record *figures)
{
    double lengths[4], tensions[4], sags[4];
    int count = 0;

    for (int e = 0; e < 4; e++) {
        if (r->problem->edges[e].kind == TAUT_FILM_CABLE) {
            lengths[count] = found->lengths[e];
            tensions[count] = found->forces[e];
            sags[count++] = taut_film_sag(sheet, e);
        }
    }
    taut_record_add_number(figures, "energy", find_energy(r, found, sheet));
    taut_record_add_number(figures, "area", found->area);
    taut_record_add_numbers(figures, "areas", 1, &found->area);
    taut_record_add_numbers(figures, "lengths", count, lengths);
    taut_record_add_numbers(figures, "tensions", count, tensions);
    taut_record_add_numbers(figures, "sags", count, sags);
}

static void add_reactions(const taut_film_sheet *sheet, taut_record *figures)
{
    double forces[4][3], balance = 0;
    unsigned char has[4];
    taut_record *reactions = taut_record_add_list(figures, "reactions");

    taut_film_reactions(sheet, forces, has, &balance);
    for (int c = 0; c < 4; c++) {
        if (has[c]) {
            taut_record_add_numbers(reactions, NULL, 3, forces[c]);
        }
    }
    taut_record_add_number(figures, "balance", balance);
}

static taut_status add_equilibrium(const request *r, double largest, taut_certificate *certificate)
{
    taut_claim claim = {.claim = "equilibrium",
                        .kind = TAUT_CHECK,
                        .residual = largest,
                        .limit = r->problem->equilibrium,
                        .where = ""};
    claim.holds = taut_certify_below(claim.residual, claim.limit);
    return r->problem->equilibrium > 0 ? taut_certificate_add(certificate, &claim) : TAUT_OK;
}

/* The forces per width that the threads reach, over places of a uniform grid: [[least, most] along u, along v]. */
static void add_stress(const taut_film_sheet *sheet, taut_record *figures)
{
    double range[2][2];
    taut_record *stress = taut_record_add_list(figures, "stress");

    taut_film_stress(sheet, range);
    for (int d = 0; d < 2; d++) {
        taut_record_add_numbers(stress, NULL, 2, range[d]);
    }
    if (sheet->problem->force_density[0] > 0) { /* what it is everywhere, by |x_u| and |x_v| */
        taut_record_add_numbers(figures, "force_density", 2, sheet->problem->force_density);
    }
}

static int has_slide(const taut_film_problem *problem)
{
    int has = 0;
    for (int e = 0; e < 4; e++) {
        has = has || problem->edges[e].kind == TAUT_FILM_SLIDE;
    }
    return has;
}

static taut_status fill_figures(const request *r, const finding *found, taut_arena *arena,
                                taut_record *figures, taut_certificate *certificate)
{
    taut_film_sheet sheet;
    taut_status status = taut_film_sheet_new(r->surface, r->problem, SECOND_EXTRA, arena, &sheet);

    if (status != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    const taut_film_defects defects = taut_film_defects_of(&sheet);
    const double mean = taut_film_sheet_has_threads(r->problem) ? 0 : 4 * found->mean * r->half;
    status = add_least(r, found, &sheet, figures, certificate);
    add_lists(r, found, &sheet, figures);
    add_reactions(&sheet, figures);
    taut_record_add_number(figures, "lowest_eigenvalue", found->lowest);
    if (taut_film_sheet_has_threads(r->problem)) {
        add_stress(&sheet, figures);
    } else {
        taut_record_add_number(figures, "mean_curvature", mean);
    }
    taut_record_add_number(figures, "cable_geodesic", defects.geodesic);
    if (!taut_film_sheet_has_threads(r->problem)) {
        taut_record_add_number(figures, "cable_normal", defects.normal);
    }
    if (has_slide(r->problem)) {
        taut_record_add_number(figures, "slide_angle", defects.slide);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = add_equilibrium(r,
                             taut_certify_max(taut_certify_max(mean, defects.slide),
                                              taut_certify_max(defects.geodesic, defects.normal)),
                             certificate);
    return status == TAUT_OK ? taut_record_status(figures) : status;
}

static taut_status add_figures(const request *r, const finding *found,
                               taut_certificate *certificate)
{
    taut_arena *arena = taut_arena_new();
    taut_record *figures = taut_record_new();
    const taut_status status = fill_figures(r, found, arena, figures, certificate);

    taut_certificate_set_figures(certificate, figures);
    taut_arena_free(arena);
    return status;
}

/* ---- the whole ---- */

static taut_status prove(const request *r, taut_certificate *certificate)
{
    finding found = {.lowest = NAN, .relative = NAN, .below = -1};
    taut_status status = add_held(r, certificate);

    if (status == TAUT_OK) {
        status = add_seams(r, certificate);
    }
    if (status == TAUT_OK) {
        status = add_mirror(r, certificate);
    }
    if (status == TAUT_OK) {
        status = add_cables(r, certificate);
    }
    if (status == TAUT_OK) {
        status = find_all(r, &found);
    }
    if (status == TAUT_OK) {
        status = add_length(r, &found, certificate);
    }
    if (status == TAUT_OK) {
        status = add_stationary(r, &found, certificate);
    }
    if (status == TAUT_OK) {
        status = add_stable(r, &found, certificate);
    }
    return status == TAUT_OK ? add_figures(r, &found, certificate) : status;
}

static taut_status certify(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error)
{
    const taut_film_problem *problem = data;
    request r;

    if (problem != NULL && taut_film_is_complex(problem)) {
        return taut_film_complex_certify(model, problem, &audit->crew, certificate, error);
    }
    taut_status status = read_request(model, data, &r, error);

    if (status == TAUT_OK) {
        status = add_boundary(&r, certificate, error);
    }
    if (status == TAUT_OK) {
        const char *name = problem->name != NULL ? problem->name : "film";
        status = taut_film_images_certify(model, problem, 1, &name, certificate, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    r.crew = audit->crew;
    if (prove(&r, certificate) != TAUT_OK ||
        taut_film_told(model, problem, NULL, certificate) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return TAUT_OK;
}

static void identify(const taut_model *model, const void *data, taut_identity *identity)
{
    const taut_film_problem *problem = data;

    (void)model;
    if (problem == NULL) {
        taut_identity_surface(identity, 0, NULL, NULL, NULL);
        return;
    }
    if (taut_film_is_complex(problem)) {
        taut_film_complex_identify(problem, identity);
        return;
    }
    const taut_expected_basis u = {.same = problem->u}, v = {.same = problem->v};
    const char *name = problem->name != NULL ? problem->name : "film";
    taut_identity_surface(identity, 0, name, &u, &v);
    taut_film_images_identify(problem, name, &u, &v, identity);
    for (int e = 0; e < 4; e++) {
        if (problem->edges[e].kind == TAUT_FILM_CABLE) {
            taut_identity_curve(identity, taut_identity_find_curve(identity, edge_names[e]),
                                edge_names[e], e < 2 ? &v : &u);
        }
    }
}

const taut_certify_ops taut_certify_film = {.certify = certify, .identify = identify};

taut_status taut_film_certify(const taut_model *model, const taut_film_problem *problem,
                              const taut_certify_options *options, taut_certificate **certificate,
                              taut_error *error)
{
    return taut_certify_with(&taut_certify_film, "film", model, problem, options, certificate,
                             error);
}
