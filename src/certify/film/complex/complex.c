/* complex.c -- is this film of many patches at rest, and on what holds it?
 *
 * Claims, as certify/film/film.c has them of one patch:
 *
 *   boundary    edges that are held against their chords and curves, each by its own limit
 *   held        corners, planes and lines: distance over the size; 64 2^-53
 *   seams       the largest difference of coordinates of points that are one by seams and poles: 0
 *   mirror      of edges in mirrors
 *   cables      how many numbers of the curves differ from the edges they are: 0
 *   volume      of cells of given volume: the largest difference from it over it; 1e-10
 *   length      of cables of given length: the same
 *   stationary  as of one patch, over the nodes, of E - sum p V; pressures and forces that are not given are those that leave the least;
 *               forces must be above 0
 *   stable      lowest eigenvalue of the second variation over the moves, scaled; above 1e-6
 *   least       films whose boundary is one closed curve, by what the model carries (certify/film/complex/least.h)
 *   equilibrium where it is asked for: the largest defect
 *   details     only where they say what the certificate does not find (certify/film/complex/told.h)
 */
#include "certify/film/complex/complex.h"
#include "certify/film/folds.h"

#include "certify/common/verdict.h"
#include "certify/film/complex/defects.h"
#include "certify/film/complex/least.h"
#include "certify/film/complex/paired.h"
#include "certify/film/complex/told.h"
#include "certify/film/edge.h"
#include "certify/film/images.h"
#include "certify/film/sheet.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "problem/film_cells.h"
#include "problem/film_ropes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { RULES = 6, SECOND_EXTRA = 1, SECOND_CELLS = 4 /* volumes are of higher degree */ };
static const int extra_nodes[RULES] = {4, 8, 15, 27, 48, 76};
static const double tolerance_default = 1e-10, largest_limit = 1e-6, stable_limit = 1e-6,
                    kept_limit = 0x1p-47, /* 64 2^-53 */
    volume_limit = 1e-10, length_limit = 1e-10;
static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};
static const char *const corner_names[4] = {"u0v0", "u1v0", "u0v1", "u1v1"};

/* What is certified, and what is found. */
typedef struct request {
    const taut_model *model;
    const taut_film_problem *problem;
    taut_arena *arena;
    taut_film_complex complex;
    const taut_surface **surfaces; /* [patch_count] */
    double tolerance, size;
    int all; /* nonzero: all coordinates count, found by the method `full`, which folds some nets: these say `normal` */
    double residual;
    int at;                 /* the node of it */
    double off, length_off; /* of given volumes, of given lengths */
    int off_cell, off_rope;
    int slack;  /* a cable that is not drawn, or -1 */
    int passed; /* 4 patch + corner, where a cable passes another edge, or -1 */
    int settled;
    double area, area_apart; /* by the last rule, and from the one before */
    double lowest, lowest_user;
    int below;
    taut_crew crew;
} request;

static taut_status find_surfaces(request *r, taut_error *error)
{
    double largest = 0;

    for (int p = 0; p < r->problem->patch_count; p++) {
        const taut_film_problem *patch = &r->problem->patches[p];
        const taut_surface *surface = taut_film_find_surface(r->model, patch->name);
        if (surface == NULL || !taut_basis_equal(patch->u, taut_surface_u(surface)) ||
            !taut_basis_equal(patch->v, taut_surface_v(surface)) ||
            taut_surface_weights(surface) != NULL) {
            return taut_fail(
                error, TAUT_BAD_INPUT, "model", "/surfaces", p, taut_none,
                "the model has no surface \"%.80s\" on the bases of that patch, without "
                "weights: they do not belong together",
                patch->name);
        }
        r->surfaces[p] = surface;
        const double *first = taut_surface_points(r->surfaces[0]),
                     *x = taut_surface_points(surface);
        for (int k = 0; k < 3 * (r->complex.first[p + 1] - r->complex.first[p]); k++) {
            largest = taut_certify_max(fabs(x[k] / 2 - first[k % 3] / 2), largest);
        }
    }
    r->size = 2 * largest;
    return TAUT_OK;
}

static const double *point_at(const request *r, int p, int k)
{
    return taut_surface_points(r->surfaces[p]) + 3 * k;
}

static const double *corner_at(const request *r, int p, int c)
{
    const taut_film_problem *patch = &r->problem->patches[p];
    const int last = taut_film_complex_along(patch, c % 2) - 1;
    return point_at(r, p, taut_film_complex_point(patch, c % 2, c / 2 * last));
}

static taut_status add(taut_certificate *certificate, const taut_claim *claim, taut_error *error)
{
    return taut_certificate_add(certificate, claim) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

/* ---- the boundary ---- */

static taut_status check_edge(const request *r, int p, int e, taut_film_boundary *b, char where[96],
                              taut_error *error)
{
    const taut_film_problem *patch = &r->problem->patches[p];
    const int n = taut_film_complex_along(patch, e);
    taut_film_asked asked = {
        .curve = patch->edges[e].curve, .size = r->size, .away = taut_norm(point_at(r, 0, 0))};
    int is_worst = 0;

    for (int end = 0; end < 2; end++) {
        memcpy(asked.ends[end], point_at(r, p, taut_film_complex_point(patch, e, end * (n - 1))),
               sizeof asked.ends[end]);
    }
    const taut_status status = taut_film_judge_edge(r->surfaces[p], e, &asked, b, &is_worst, error);
    if (is_worst) {
        taut_film_complex_name(r->problem, p, edge_names[e], where);
    }
    return status;
}

static taut_status add_boundary(const request *r, taut_certificate *certificate, taut_error *error)
{
    taut_film_boundary b = {.count = 0};
    char where[96] = "";

    for (int k = 0; k < 4 * r->problem->patch_count; k++) {
        if (r->problem->patches[k / 4].edges[k % 4].kind == TAUT_FILM_FIXED &&
            taut_film_complex_seam(r->problem, k / 4, k % 4) < 0) {
            const taut_status status = check_edge(r, k / 4, k % 4, &b, where, error);
            if (status != TAUT_OK) {
                return status;
            }
        }
    }
    const taut_claim claim = {.claim = "boundary",
                              .kind = b.fitted ? TAUT_BOUND : TAUT_EXACT,
                              .residual = b.residual,
                              .limit = b.limit,
                              .holds = taut_certify_below(b.residual, b.limit),
                              .where = where};
    return b.count > 0 ? add(certificate, &claim, error) : TAUT_OK;
}

/* ---- what is held, joined, mirrored ---- */

static void take_farther(double away, const request *r, int p, const char *what, char where[96],
                         taut_claim *claim)
{
    if (!(away <= claim->residual)) {
        claim->residual = away;
        taut_film_complex_name(r->problem, p, what, where);
    }
}

static double away_from(const request *r, const double *x, const taut_film_guide *guide, int line)
{
    double from[3], across[3];

    taut_difference(x, guide->point, from);
    taut_cross(from, guide->direction, across);
    const double away = line ? taut_norm(across) : fabs(taut_dot(from, guide->direction));
    return away / taut_norm(guide->direction) / r->size;
}

static double leave_plane(const request *r, const taut_film_side *side,
                          const taut_film_guide *plane)
{
    const taut_film_problem *patch = &r->problem->patches[side->patch];
    double largest = 0;

    for (int k = 0; k < taut_film_complex_along(patch, side->edge); k++) {
        const double *x = point_at(r, side->patch, taut_film_complex_point(patch, side->edge, k));
        largest = taut_certify_max(away_from(r, x, plane, 0), largest);
    }
    return largest;
}

static taut_status add_held(const request *r, taut_certificate *certificate, taut_error *error)
{
    char where[96] = "";
    taut_claim claim = {.claim = "held", .kind = TAUT_EXACT, .limit = kept_limit, .where = where};

    for (int p = 0; p < r->problem->patch_count; p++) {
        const taut_film_problem *patch = &r->problem->patches[p];
        for (int c = 0; c < 4; c++) {
            const double *x = corner_at(r, p, c);
            const taut_film_corner_kind kind = patch->corner_kinds[c];
            if (kind == TAUT_FILM_HELD && patch->has_corner[c]) {
                take_farther(taut_distance(x, patch->corners[c]) / r->size, r, p, corner_names[c],
                             where, &claim);
            } else if (kind == TAUT_FILM_ON_LINE || kind == TAUT_FILM_ON_PLANE) {
                take_farther(away_from(r, x, &patch->guides[c], kind == TAUT_FILM_ON_LINE), r, p,
                             corner_names[c], where, &claim);
            }
        }
        for (int e = 0; e < 4; e++) {
            const taut_film_edge *edge = &patch->edges[e];
            const taut_film_side side = {p, e, 0};
            if (edge->kind == TAUT_FILM_SLIDE ||
                (edge->kind == TAUT_FILM_CABLE && edge->has_plane)) {
                take_farther(leave_plane(r, &side, &edge->plane), r, p, edge_names[e], where,
                             &claim);
            }
        }
    }
    for (int s = 0; s < r->problem->seam_count; s++) {
        const taut_film_seam *seam = &r->problem->seams[s];
        if (seam->edge.kind == TAUT_FILM_CABLE && seam->edge.has_plane) {
            take_farther(leave_plane(r, &seam->sides[0], &seam->edge.plane), r,
                         seam->sides[0].patch, edge_names[seam->sides[0].edge], where, &claim);
        }
    }
    claim.holds = taut_certify_below(claim.residual, claim.limit);
    return add(certificate, &claim, error);
}

/* Point k of a side, as it is run. */
static const double *run_point(const request *r, const taut_film_side *side, int k)
{
    const taut_film_problem *patch = &r->problem->patches[side->patch];
    const int last = taut_film_complex_along(patch, side->edge) - 1;
    return point_at(r, side->patch,
                    taut_film_complex_point(patch, side->edge, side->reversed ? last - k : k));
}

/* Straight from the seams of the problem, edge by edge. */
static taut_status add_seams(const request *r, taut_certificate *certificate, taut_error *error)
{
    char where[96] = "";
    taut_claim claim = {.claim = "seams", .kind = TAUT_EXACT, .where = where};

    for (int s = 0; s < r->problem->seam_count; s++) {
        const taut_film_seam *seam = &r->problem->seams[s];
        const taut_film_problem *patch = &r->problem->patches[seam->sides[0].patch];
        for (int j = 1; j < seam->count; j++) {
            for (int k = 0; k < taut_film_complex_along(patch, seam->sides[0].edge); k++) {
                double d[3];
                taut_difference(run_point(r, &seam->sides[0], k), run_point(r, &seam->sides[j], k),
                                d);
                take_farther(taut_largest_coordinate(d), r, seam->sides[j].patch,
                             edge_names[seam->sides[j].edge], where, &claim);
            }
        }
    }
    for (int k = 0; k < 4 * r->problem->patch_count; k++) {
        const taut_film_side side = {k / 4, k % 4, 0};
        const taut_film_problem *patch = &r->problem->patches[k / 4];
        for (int i = 1; patch->edges[k % 4].kind == TAUT_FILM_POLE &&
                        i < taut_film_complex_along(patch, k % 4);
             i++) {
            double d[3];
            taut_difference(run_point(r, &side, i), run_point(r, &side, 0), d);
            take_farther(taut_largest_coordinate(d), r, k / 4, edge_names[k % 4], where, &claim);
        }
    }
    claim.holds = taut_certify_below(claim.residual, 0);
    return add(certificate, &claim, error);
}

static taut_status add_mirror(const request *r, taut_certificate *certificate, taut_error *error)
{
    char where[96] = "";
    taut_claim claim = {.claim = "mirror", .kind = TAUT_EXACT, .limit = kept_limit, .where = where};
    int count = 0;

    for (int k = 0; k < 4 * r->problem->patch_count; k++) {
        const taut_film_edge *edge = &r->problem->patches[k / 4].edges[k % 4];
        const taut_film_side side = {k / 4, k % 4, 0};
        if (edge->kind == TAUT_FILM_SLIDE && edge->is_mirror) {
            take_farther(leave_plane(r, &side, &edge->plane), r, k / 4, edge_names[k % 4], where,
                         &claim);
            count++;
        }
    }
    claim.holds = taut_certify_below(claim.residual, claim.limit);
    return count > 0 ? add(certificate, &claim, error) : TAUT_OK;
}

/* ---- cables ---- */

static void strand_name(const request *r, int k, char name[96])
{
    const taut_film_side *side = &r->complex.strands[k].side;
    taut_film_complex_name(r->problem, side->patch, edge_names[side->edge], name);
}

static int count_differences(const request *r, const taut_curve *curve, const taut_film_side *side)
{
    const taut_film_problem *patch = &r->problem->patches[side->patch];
    const taut_basis *basis = side->edge < 2 ? patch->v : patch->u;
    const int count = taut_basis_count(basis);
    int differences = 0;

    if (curve == NULL || !taut_basis_equal(taut_curve_t(curve), basis) ||
        taut_curve_weights(curve) != NULL) {
        return 3 * count;
    }
    for (int k = 0; k < count; k++) {
        const double *x = run_point(r, side, k);
        for (int c = 0; c < 3; c++) {
            differences += taut_curve_points(curve)[3 * k + c] != x[c];
        }
    }
    return differences;
}

static taut_status add_cables(const request *r, taut_certificate *certificate, taut_error *error)
{
    char where[96] = "";
    taut_claim claim = {.claim = "cables", .kind = TAUT_EXACT, .where = where};

    for (int k = 0; k < r->complex.strand_count; k++) {
        const taut_curve *curve = NULL;
        char name[96];
        strand_name(r, k, name);
        for (int i = 0; i < taut_model_curve_count(r->model); i++) {
            if (strcmp(taut_curve_name(taut_model_curve(r->model, i)), name) == 0) {
                curve = taut_model_curve(r->model, i);
            }
        }
        const int differences = count_differences(r, curve, &r->complex.strands[k].side);
        if (differences > 0) {
            memcpy(where, name, sizeof where);
        }
        claim.residual += differences;
    }
    claim.holds = claim.residual == 0 ? TAUT_TRUE : TAUT_FALSE;
    return r->complex.strand_count > 0 ? add(certificate, &claim, error) : TAUT_OK;
}

/* ---- at rest ---- */

/* The largest derivative along moves, and along all that is free as it counts, over the largest. */
static void judge(request *r, const taut_sheets *s)
{
    r->residual = 0;
    for (int a = 0; a < r->complex.nodes; a++) {
        const taut_film_hold *hold = &r->complex.holds[a];
        double g[3], largest = 0;
        memcpy(g, s->gradient + 3 * a, sizeof g);
        for (int m = s->first[a]; m < s->first[a + 1]; m++) {
            largest = taut_certify_max(fabs(taut_dot(g, s->way + 3 * m)), largest);
        }
        for (int k = 0; k < hold->count; k++) {
            taut_add_scaled(-taut_dot(g, hold->normals[k]), hold->normals[k], g);
        }
        if (r->complex.kind[a] != TAUT_FILM_NODE_HELD && r->all) {
            largest = taut_certify_max(taut_largest_coordinate(g) * (r->tolerance / largest_limit),
                                       largest);
        }
        if (!(largest / s->scales[a] <= r->residual)) {
            r->residual = largest / s->scales[a];
            r->at = a;
        }
    }
}

static void judge_volumes(request *r, const taut_sheets *s)
{
    r->off = 0;
    for (int k = 0; k < r->problem->cell_count; k++) {
        const taut_film_cell *cell = &r->problem->cells[k];
        const double off =
            cell->has_volume ? fabs((s->volumes[k] - cell->volume) / cell->volume) : 0;
        if (!(off <= r->off)) {
            r->off = off;
            r->off_cell = k;
        }
    }
}

static void judge_ropes(request *r, const taut_sheets *s)
{
    r->length_off = 0;
    r->slack = -1;
    for (int k = 0; k < r->complex.rope_count; k++) {
        const double given = taut_film_rope_length(&r->complex, k);
        const double off = taut_film_rope_is_given(r->complex.ropes[k].edge)
                               ? fabs((s->lengths[k] - given) / given)
                               : 0;
        if (!(off <= r->length_off)) {
            r->length_off = off;
            r->off_rope = k;
        }
        r->slack = s->forces[k] > 0 ? r->slack : k;
    }
}

static taut_status add_length(const request *r, taut_certificate *certificate, taut_error *error)
{
    char where[TAUT_FILM_NAME] = "";
    const taut_claim claim = {.claim = "length",
                              .kind = TAUT_CHECK,
                              .residual = r->length_off,
                              .limit = length_limit,
                              .holds = taut_certify_below(r->length_off, length_limit),
                              .where = where};
    int given = 0;

    for (int k = 0; k < r->complex.rope_count; k++) {
        given += taut_film_rope_is_given(r->complex.ropes[k].edge);
    }
    if (given == 0) {
        return TAUT_OK;
    }
    taut_film_rope_name(&r->complex, r->off_rope, where);
    return add(certificate, &claim, error);
}

static taut_status add_volume(const request *r, taut_certificate *certificate, taut_error *error)
{
    char where[TAUT_FILM_NAME] = "";
    const taut_claim claim = {.claim = "volume",
                              .kind = TAUT_CHECK,
                              .residual = r->off,
                              .limit = volume_limit,
                              .holds = taut_certify_below(r->off, volume_limit),
                              .where = where};
    int given = 0;

    for (int k = 0; k < r->problem->cell_count; k++) {
        given += r->problem->cells[k].has_volume;
    }
    if (given == 0) {
        return TAUT_OK;
    }
    taut_film_cell_name(r->problem, r->off_cell, where);
    return add(certificate, &claim, error);
}

static void judge_area(request *r, const taut_sheets *s)
{
    double area = 0;
    for (int p = 0; p < r->problem->patch_count; p++) {
        area += s->areas[p];
    }
    r->area_apart = fabs(area - r->area);
    r->area = area;
}

static taut_status settle(request *r)
{
    const double limit = r->tolerance;
    double before = INFINITY;

    for (int rule = 0; rule < RULES && !r->settled; rule++) {
        taut_arena *arena = taut_arena_new();
        taut_sheets s;
        const taut_status status =
            taut_sheets_new(&r->complex, r->surfaces, extra_nodes[rule], arena, &s);
        if (status == TAUT_OK) {
            judge(r, &s);
            judge_volumes(r, &s);
            judge_ropes(r, &s);
            judge_area(r, &s);
            r->passed = taut_complex_passed(&s);
        }
        taut_arena_free(arena);
        if (status != TAUT_OK) {
            return status;
        }
        r->settled = (r->residual <= limit && before <= limit) ||
                     fabs(r->residual - before) <= 0.25 * fmin(r->residual, before);
        before = r->residual;
    }
    return TAUT_OK;
}

static const char updated[] = "updates: the last reference is no part of the model";

static int has_updates(const taut_film_problem *problem)
{
    int has = 0;
    for (int p = 0; p < problem->patch_count; p++) {
        has |= problem->patches[p].updates > 0;
    }
    return has;
}

static taut_status add_stationary(const request *r, taut_certificate *certificate,
                                  taut_error *error)
{
    char where[96];
    taut_claim claim = {.claim = "stationary",
                        .kind = TAUT_CHECK,
                        .residual = r->residual,
                        .limit = r->tolerance,
                        .where = where};
    int k = 0, p = 0;

    if (has_updates(r->problem)) {
        claim.residual = taut_none;
        claim.where = updated;
        claim.holds = TAUT_UNDECIDED;
        return add(certificate, &claim, error);
    }
    while (k < r->complex.points - 1 && r->complex.node[k] != r->at) {
        k++;
    }
    while (r->complex.first[p + 1] <= k) {
        p++;
    }
    const int nv = taut_basis_count(r->problem->patches[p].v), local = k - r->complex.first[p];
    snprintf(where, sizeof where, "/surfaces/%d/points/%d/%d", p, local / nv, local % nv);
    claim.holds = taut_certify_below(claim.residual, claim.limit);
    int folds = 0;
    double u = 0, v = 0;
    for (p = 0; p < r->problem->patch_count && !folds; p++) {
        if (taut_film_find_fold(r->surfaces[p], &folds, &u, &v) != TAUT_OK) {
            return taut_fail_memory(error);
        }
    }
    if (claim.holds == TAUT_UNDECIDED) {
        snprintf(where, sizeof where, TAUT_CERTIFY_OUT_OF_RANGE);
    } else if (folds) {
        claim.holds = TAUT_FALSE;
        claim.residual = taut_certify_max(claim.residual, 1);
        snprintf(where, sizeof where, "/surfaces/%d: it folds over at u = %.4g, v = %.4g", p - 1, u,
                 v);
    } else if (r->passed >= 0) {
        claim.holds = TAUT_FALSE;
        claim.residual = taut_certify_max(claim.residual, 1);
        snprintf(where, sizeof where, "/surfaces/%d: a cable passes another edge in corner u%dv%d",
                 r->passed / 4, r->passed % 2, r->passed % 4 / 2);
    } else if (r->slack >= 0) {
        claim.holds = TAUT_FALSE;
        snprintf(where, sizeof where, "a cable is slack");
    } else if (!r->settled) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "no Gauss rule settles the integrals");
    }
    return add(certificate, &claim, error);
}

static taut_status find_stability(request *r)
{
    taut_arena *arena = taut_arena_new();
    taut_sheets s;
    taut_status status =
        taut_sheets_new(&r->complex, r->surfaces,
                        r->problem->cell_count > 0 ? SECOND_CELLS : SECOND_EXTRA, arena, &s);

    if (status == TAUT_OK) {
        status = taut_sheets_lowest(&s, stable_limit, r->crew.pulse, &r->lowest, &r->below);
        r->lowest_user = r->lowest * s.tension / r->size / r->size;
    }
    taut_arena_free(arena);
    return status == TAUT_NOT_CONVERGED ? TAUT_OK : status;
}

/* Two searches that fill members of their own: stability, which takes longer and is watched, and the rest. */
typedef struct searches {
    request *r;
    taut_status stability, rest;
} searches;

static void search(void *context, int part, int from, int to)
{
    searches *s = context;

    (void)part;
    for (; from < to; from++) {
        if (from == 0) {
            s->stability = find_stability(s->r);
        } else {
            s->rest = settle(s->r);
        }
    }
}

static taut_status find_all(request *r, taut_error *error)
{
    searches s = {.r = r};

    taut_parallel_for(2, r->crew.threads, search, &s);
    if (taut_pulse_report(r->crew.pulse)) {
        return TAUT_INTERRUPTED;
    }
    return s.stability != TAUT_OK || s.rest != TAUT_OK ? taut_fail_memory(error) : TAUT_OK;
}

static taut_status add_stable(const request *r, taut_certificate *certificate, taut_error *error)
{
    taut_claim claim = {.claim = "stable",
                        .kind = TAUT_CHECK,
                        .residual = r->lowest,
                        .limit = stable_limit,
                        .where = ""};

    if (r->problem->accepts_stationary) {
        claim.holds = TAUT_UNDECIDED;
        claim.where = "stationary: the problem accepts films that are no minimum";
        return add(certificate, &claim, error);
    }
    claim.holds = r->below < 0    ? TAUT_UNDECIDED
                  : r->below == 0 ? taut_certify_above(claim.residual, claim.limit)
                                  : TAUT_FALSE;
    if (claim.holds == TAUT_UNDECIDED) {
        claim.where = "no eigenvalue is found";
    }
    return add(certificate, &claim, error);
}

/* ---- figures ---- */

static void add_reactions(const request *r, const taut_sheets *s, double *forces,
                          unsigned char *seen, taut_record *figures)
{
    taut_record *reactions = taut_record_add_list(figures, "reactions");

    taut_complex_pulls(s, forces);
    for (int k = 0; k < 4 * r->problem->patch_count; k++) {
        const int p = k / 4;
        const int node = taut_film_complex_corner(&r->complex, p, k % 4);
        if (r->complex.holds[node].count == 3 && !seen[node]) {
            seen[node] = 1;
            taut_record_add_numbers(reactions, NULL, 3, forces + 3 * node);
        }
    }
}

static int has_slide(const taut_film_problem *problem)
{
    for (int k = 0; k < 4 * problem->patch_count; k++) {
        if (problem->patches[k / 4].edges[k % 4].kind == TAUT_FILM_SLIDE) {
            return 1;
        }
    }
    return 0;
}

/* The stress that threads reach, and what it is everywhere, by |x_u| and |x_v|: of patches by their order. */
static void add_stress(const taut_film_problem *problem, const taut_sheets *sheets,
                       taut_record *figures)
{
    double stress[2][2];
    int has_densities = 0;
    taut_record *list = taut_record_add_list(figures, "stress");

    taut_complex_stress(sheets, stress);
    for (int k = 0; k < 2; k++) {
        taut_record_add_numbers(list, NULL, 2, stress[k]);
    }
    for (int p = 0; p < problem->patch_count; p++) {
        has_densities |= problem->patches[p].force_density[0] > 0;
    }
    list = has_densities ? taut_record_add_list(figures, "force_density") : NULL;
    for (int p = 0; has_densities && p < problem->patch_count; p++) {
        if (problem->patches[p].force_density[0] > 0) {
            taut_record_add_numbers(list, NULL, 2, problem->patches[p].force_density);
        } else {
            taut_record_add_null(list, NULL);
        }
    }
}

static int has_lines(const taut_film_problem *problem)
{
    int has = 0;
    for (int k = 0; k < problem->seam_count; k++) {
        has |= problem->seams[k].count > 2;
    }
    return has;
}

/* Films with lines of three sheets, where constant fields prove them. */
static taut_status add_paired(const taut_sheets *s, double energy, taut_record *figures,
                              taut_claim *claim)
{
    double bound = NAN;
    const taut_status status = taut_complex_paired(s, &bound);

    if (status == TAUT_OK && energy > 0 && (energy - bound) / energy <= claim->limit) {
        taut_record_add_number(figures, "lower_bound", bound);
        taut_record_add_number(figures, "gap", energy - bound);
        claim->residual = fabs(energy - bound) / energy;
        claim->holds = bound <= energy ? TAUT_TRUE : TAUT_UNDECIDED;
        claim->where = "";
    }
    return status;
}

static taut_status add_least(const request *r, const taut_sheets *s, double energy,
                             taut_record *figures, taut_certificate *certificate, taut_error *error)
{
    const double tension = s->shares[0] * s->tension;
    const taut_record *details = taut_model_details(r->model);
    taut_least_finding found = {.why = "declined: the problem asks for no bound"};
    taut_claim claim = {.claim = "least",
                        .kind = TAUT_BOUND,
                        .residual = taut_none,
                        .limit = largest_limit,
                        .holds = TAUT_UNDECIDED,
                        .where = ""};

    if (!r->problem->without_least) {
        const taut_status status = taut_complex_least_of(
            &r->complex, r->surfaces, taut_record_get(details, "least"), r->crew.pulse, &found);
        if (status != TAUT_OK) {
            return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
        }
    }
    if (found.why == NULL) {
        claim.residual = taut_least_tell(&found, r->area, r->area_apart, tension, figures);
        claim.holds = taut_certify_below(claim.residual, claim.limit);
    } else {
        claim.where = found.why;
    }
    if (!r->problem->without_least && found.why != NULL && has_lines(r->problem) &&
        add_paired(s, energy, figures, &claim) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (claim.holds == TAUT_FALSE) {
        claim.holds = TAUT_UNDECIDED;
        claim.where = "coarse: the film or its witness is too coarse for a bound that is so near";
    }
    return add(certificate, &claim, error);
}

static taut_status fill_figures(const request *r, taut_record *figures,
                                taut_certificate *certificate, taut_error *error)
{
    const int patches = r->problem->patch_count, ropes = r->complex.rope_count;
    taut_sheets s;
    double *sags = taut_arena_take(r->arena, (size_t)ropes, sizeof(double));
    double *pressures = taut_arena_take(r->arena, (size_t)r->problem->cell_count, sizeof(double));
    double *forces = taut_arena_take(r->arena, (size_t)r->complex.nodes, 3 * sizeof(double));
    unsigned char *seen = taut_arena_take(r->arena, (size_t)r->complex.nodes, 1);
    double energy = 0, area = 0;
    int plain = 0, has_threads = 0;

    if (taut_arena_status(r->arena) != TAUT_OK ||
        taut_sheets_new(&r->complex, r->surfaces, extra_nodes[1], r->arena, &s) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int p = 0; p < patches; p++) {
        area += s.areas[p];
        const int threads = taut_film_sheet_has_threads(&r->problem->patches[p]);
        energy += s.shares[p] * s.tension * (threads ? s.stored[p] : s.areas[p]);
        plain |= !threads;
        has_threads |= threads;
    }
    for (int k = 0; k < ropes; k++) {
        const taut_film_edge *law = r->complex.ropes[k].edge;
        const double longer = fmax(0, s.lengths[k] - law->unstressed);
        sags[k] = taut_complex_sag(&s, k);
        energy += law->law == TAUT_FILM_FORCE ? law->force * s.lengths[k]
                  : law->law == TAUT_FILM_ELASTIC
                      ? law->stiffness * longer * longer / (2 * law->unstressed)
                      : 0;
    }
    for (int k = 0; k < r->problem->cell_count; k++) {
        const taut_film_cell *cell = &r->problem->cells[k];
        pressures[k] =
            cell->has_volume ? ldexp(s.pressures[k], -s.unit) * s.tension : cell->pressure;
        energy -= cell->has_volume ? 0 : cell->pressure * s.volumes[k];
    }
    taut_record_add_number(figures, "energy", energy);
    const taut_status status = add_least(r, &s, energy, figures, certificate, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_record_add_number(figures, "area", area);
    taut_record_add_numbers(figures, "areas", patches, s.areas);
    taut_record_add_numbers(figures, "lengths", ropes, s.lengths);
    taut_record_add_numbers(figures, "tensions", ropes, s.forces);
    taut_record_add_numbers(figures, "sags", ropes, sags);
    if (r->problem->cell_count > 0) {
        taut_record_add_numbers(figures, "volumes", r->problem->cell_count, s.volumes);
        taut_record_add_numbers(figures, "pressures", r->problem->cell_count, pressures);
    }
    add_reactions(r, &s, forces, seen, figures);
    taut_record_add_number(figures, "balance", taut_complex_balance(&s));
    if (r->below >= 0) {
        taut_record_add_number(figures, "lowest_eigenvalue", r->lowest_user);
    }
    const taut_complex_defects d = taut_complex_defects_of(&s);
    if (plain) {
        taut_record_add_number(figures, "mean_curvature", d.mean);
    }
    if (has_threads) {
        add_stress(r->problem, &s, figures);
    }
    if (ropes > 0) {
        taut_record_add_number(figures, "cable_geodesic", d.geodesic);
        if (plain) {
            taut_record_add_number(figures, "cable_normal", d.normal);
        }
    }
    if (r->problem->seam_count > 0) {
        taut_record_add_number(figures, "seam_angle", d.seam);
    }
    if (has_slide(r->problem)) {
        taut_record_add_number(figures, "slide_angle", d.slide);
    }
    taut_claim claim = {.claim = "equilibrium",
                        .kind = TAUT_CHECK,
                        .residual = taut_certify_max(
                            taut_certify_max(d.mean, d.seam),
                            taut_certify_max(d.slide, taut_certify_max(d.geodesic, d.normal))),
                        .limit = r->problem->equilibrium,
                        .where = ""};
    claim.holds = taut_certify_below(claim.residual, claim.limit);
    return r->problem->equilibrium > 0 ? add(certificate, &claim, error) : TAUT_OK;
}

static taut_status add_figures(const request *r, taut_certificate *certificate, taut_error *error)
{
    taut_record *figures = taut_record_new();
    taut_status status = fill_figures(r, figures, certificate, error);

    if (status == TAUT_OK && taut_record_status(figures) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    taut_certificate_set_figures(certificate, figures);
    return status;
}

static taut_status add_images(const request *r, taut_certificate *certificate, taut_error *error)
{
    const int count = r->problem->patch_count;
    const char **names = taut_arena_take(r->arena, (size_t)count, sizeof *names);

    if (names == NULL) {
        return taut_fail_memory(error);
    }
    for (int p = 0; p < count; p++) {
        names[p] = r->problem->patches[p].name;
    }
    return taut_film_images_certify(r->model, r->problem, count, names, certificate, error);
}

/* ---- the whole ---- */

static taut_status prove(request *r, taut_certificate *certificate, taut_error *error)
{
    taut_status status = add_boundary(r, certificate, error);

    if (status == TAUT_OK) {
        status = add_held(r, certificate, error);
    }
    if (status == TAUT_OK) {
        status = add_seams(r, certificate, error);
    }
    if (status == TAUT_OK) {
        status = add_mirror(r, certificate, error);
    }
    if (status == TAUT_OK) {
        status = add_images(r, certificate, error);
    }
    if (status == TAUT_OK) {
        status = add_cables(r, certificate, error);
    }
    if (status == TAUT_OK) {
        status = find_all(r, error);
    }
    if (status == TAUT_OK) {
        status = add_volume(r, certificate, error);
    }
    if (status == TAUT_OK) {
        status = add_length(r, certificate, error);
    }
    if (status == TAUT_OK) {
        status = add_stationary(r, certificate, error);
    }
    if (status == TAUT_OK) {
        status = add_stable(r, certificate, error);
    }
    return status == TAUT_OK ? add_figures(r, certificate, error) : status;
}

taut_status taut_film_complex_certify(const taut_model *model, const taut_film_problem *problem,
                                      const taut_crew *crew, taut_certificate *certificate,
                                      taut_error *error)
{
    taut_film_lone room;
    const taut_film_problem *whole = taut_film_complex_of(problem, &room);
    request r = {.model = model,
                 .problem = whole,
                 .arena = taut_arena_new(),
                 .tolerance = fmin(problem->tolerance > 0 ? problem->tolerance : tolerance_default,
                                   largest_limit),
                 .lowest = NAN,
                 .lowest_user = NAN,
                 .below = -1,
                 .crew = *crew};
    const char *method = taut_record_text(taut_record_get(taut_model_details(model), "method"));
    r.all = problem->method == TAUT_FILM_FULL && !(method != NULL && strcmp(method, "normal") == 0);
    taut_status status = taut_film_complex_new(whole, r.arena, &r.complex, error);

    if (status == TAUT_OK) {
        status = taut_film_cells_check(&r.complex, error);
    }
    if (status == TAUT_OK) {
        r.surfaces =
            taut_arena_take(r.arena, (size_t)whole->patch_count, sizeof(const taut_surface *));
        status = r.surfaces == NULL ? taut_fail_memory(error) : find_surfaces(&r, error);
    }
    if (status == TAUT_OK) {
        status = prove(&r, certificate, error);
    }
    if (status == TAUT_OK && taut_film_told(model, whole, &r.complex, certificate) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    if (status != TAUT_OK) {
        taut_film_complex_where(whole, error);
    }
    taut_arena_free(r.arena);
    return status;
}

static void identify(const taut_film_problem *problem, taut_identity *identity)
{
    for (int p = 0; p < problem->patch_count; p++) {
        const taut_film_problem *patch = &problem->patches[p];
        const taut_expected_basis u = {.same = patch->u}, v = {.same = patch->v};
        taut_identity_surface(identity, taut_identity_find_surface(identity, patch->name),
                              patch->name, &u, &v);
        taut_film_images_identify(problem, patch->name, &u, &v, identity);
        for (int e = 0; e < 4; e++) {
            const int s = taut_film_complex_seam(problem, p, e);
            const int speaks = s < 0 || (problem->seams[s].sides[0].patch == p &&
                                         problem->seams[s].sides[0].edge == e);
            const taut_film_edge *edge = s < 0 ? &patch->edges[e] : &problem->seams[s].edge;
            if (speaks && edge->kind == TAUT_FILM_CABLE) {
                char name[96];
                taut_film_complex_name(problem, p, edge_names[e], name);
                taut_identity_curve(identity, taut_identity_find_curve(identity, name), name,
                                    e < 2 ? &v : &u);
            }
        }
    }
}

void taut_film_complex_identify(const taut_film_problem *problem, taut_identity *identity)
{
    taut_film_lone room;
    identify(taut_film_complex_of(problem, &room), identity);
}
