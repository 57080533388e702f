/* asymptotic.c -- from the problem to the model: the quadrilateral (Algorithm 1, or as given), the
 * rows along its edges and the inner points (Algorithm 2).
 */
#include "construct/asymptotic/branch.h"
#include "construct/asymptotic/conditions.h"
#include "construct/asymptotic/low.h"
#include "construct/asymptotic/plate.h"
#include "construct/asymptotic/ribbon.h"
#include "construct/common/build.h"
#include "construct/construct_ops.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/bernstein.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* All that one call holds; lives in its arena. */
typedef struct work {
    const taut_asymptotic_problem *problem;
    const taut_monitor *monitor; /* or NULL */
    taut_quad quad;
    taut_branches branches;
    taut_ribbon ribbons[4];
    taut_patch patch;
    taut_plate_freedom freedoms[TAUT_PLATE_FREEDOMS];
    double factors[TAUT_PLATE_FREEDOMS];
    double center[3];
    double curve_energy, patch_energy;
} work;

/* The mean of the corners: problems are moved so that it is the origin, as products of coordinates
 * then lose nothing to a far one. */
static void center_of(const double *corners, double center[3])
{
    memset(center, 0, 3 * sizeof *center);
    for (int c = 0; c < 4; c++) {
        taut_add_scaled(0.25, corners + 3 * c, center);
    }
}

/* Torsions, energies and their derivatives are products of up to eight lengths: beyond these they
 * leave the range of double. */
static const double least_size = 1e-20, most_size = 1e20;
static const double least_weight = 1e-30; /* of the largest at the corners, as in corner data */
/* Coordinates are rounded by 2^-53 of themselves. Where that is more than this share of the size,
 * no claim on the patch could be decided: the certificate's limits end there. */
static const double most_rounding = 1e-6;

/* The largest distance of a corner from their mean along an axis. Corners that are not finite are
 * told elsewhere. */
static taut_status check_size(const double *corners, const double center[3], const char *where,
                              double *size, taut_error *error)
{
    double far = 0.0;
    *size = 0.0;
    for (int k = 0; k < 12; k++) {
        *size = fmax(*size, fabs(corners[k] - center[k % 3]));
        far = fmax(far, fabs(corners[k]));
    }
    if (isfinite(far) && *size > 0 && TAUT_UNIT_ROUNDOFF * far > most_rounding * *size) {
        return taut_fail(error, TAUT_BAD_INPUT, "far-away", where, TAUT_UNIT_ROUNDOFF * far / *size,
                         most_rounding,
                         "coordinates of %.3g hold the corners, %.3g from their mean, to %.1e of "
                         "that only, expected at most %.0e: move the origin nearer",
                         far, *size, TAUT_UNIT_ROUNDOFF * far / *size, most_rounding);
    }
    if (isfinite(center[0]) && isfinite(center[1]) && isfinite(center[2]) && *size > 0 &&
        !(*size >= least_size && *size <= most_size)) {
        return taut_fail(
            error, TAUT_BAD_INPUT, "too-large", where, *size, taut_none,
            "the corners lie %.3g from their mean, expected %.0e to %.0e: take another "
            "unit of length",
            *size, least_size, most_size);
    }
    return TAUT_OK;
}

/* All weights times one power of two, which changes no curve and rounds nothing, where the corners'
 * are far from the 1 that the inner weights are. */
static void scale_weights(taut_quad *quad)
{
    double most = 0.0;
    int power = 0;
    for (int c = 0; c < 4; c++) {
        most = fmax(most, taut_quad_weight(quad, c, 0, 0));
    }
    (void)frexp(most, &power);
    for (int e = 0; e < 4 && abs(power) > 10; e++) {
        for (int j = 0; j <= quad->degree; j++) {
            quad->edges[e].weights[j] = ldexp(quad->edges[e].weights[j], -power);
        }
    }
}

static taut_status check_points(const taut_quad *quad, taut_error *error)
{
    for (int e = 0; e < 4; e++) {
        for (int j = 0; j <= quad->degree; j++) {
            const double w = quad->edges[e].weights[j];
            if (!(w >= least_weight && w <= 1 / least_weight)) {
                return taut_fail(error, TAUT_BAD_INPUT, "value", "/curves", w, taut_none,
                                 "weights of %s are %.3g of those at the corners, expected %.0e to "
                                 "%.0e",
                                 taut_asymptotic_edge_name(e), w, least_weight, 1 / least_weight);
            }
        }
        for (int j = 0; j <= quad->degree; j++) {
            const double *const p = quad->edges[e].points[j];
            const double far = fmax(fmax(fabs(p[0]), fabs(p[1])), fabs(p[2]));
            if (!(far <= most_size)) {
                return taut_fail(error, TAUT_BAD_INPUT, "too-large", "/curves", far, most_size,
                                 "a control point of %s has a coordinate of %.3g, expected %.0e at "
                                 "the most",
                                 taut_asymptotic_edge_name(e), far, most_size);
            }
        }
    }
    return TAUT_OK;
}

static void copy_corners(const taut_quad *quad, double corners[4][3])
{
    for (int c = 0; c < 4; c++) {
        const taut_quad_meeting *const m = taut_quad_corner[c];
        memcpy(corners[c], taut_quad_point(quad, m->edge, m->end, 0), sizeof corners[c]);
    }
}

/* Moves the quadrilateral there. */
static void center_quad(work *w)
{
    double corners[4][3], moved[3];
    copy_corners(&w->quad, corners);
    center_of(&corners[0][0], moved);
    for (int e = 0; e < 4; e++) {
        for (int j = 0; j <= w->quad.degree; j++) {
            taut_add_scaled(-1.0, moved, w->quad.edges[e].points[j]);
        }
    }
    taut_add_scaled(1.0, moved, w->center);
}

static taut_status use_curves(work *w, taut_error *error)
{
    taut_curve_rule rule;
    double corners[4][3], center[3], size = 0.0;
    taut_status status = taut_quad_of_curves(w->problem->curves, &w->quad, error);
    if (status != TAUT_OK) {
        return status;
    }
    copy_corners(&w->quad, corners);
    center_of(&corners[0][0], center);
    status = check_size(&corners[0][0], center, "/curves", &size, error);
    if (status != TAUT_OK) {
        return status;
    }
    scale_weights(&w->quad);
    status = check_points(&w->quad, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_curve_rule_fill(w->quad.degree, TAUT_CURVE_FINE, &rule);
    w->curve_energy = taut_quad_energy(&rule, &w->quad);
    return TAUT_OK;
}

/* Algorithm 1, about the mean of the corners where that is far away. */
static taut_status find_curves(work *w, taut_error *error)
{
    taut_asymptotic_corners moved = w->problem->corners;
    double center[3], size = 0.0, far = 0.0;
    int chosen = 0;
    taut_status status = TAUT_OK;
    for (int k = 0; k < 12; k++) {
        far = fmax(far, fabs(moved.points[k / 3][k % 3]));
    }
    center_of(&moved.points[0][0], center);
    status = check_size(&moved.points[0][0], center, "/corners", &size, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (fmax(fmax(fabs(center[0]), fabs(center[1])), fabs(center[2])) > 8.0 * size) {
        memcpy(w->center, center, sizeof center);
        for (int c = 0; c < 4; c++) {
            taut_add_scaled(-1.0, center, moved.points[c]);
        }
    }
    status = taut_branches_find(&moved, TAUT_UNIT_ROUNDOFF * far, w->monitor, &w->branches, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_branch_choose(&moved, &w->branches, &chosen, error);
    w->quad = w->branches.list[chosen].quad;
    w->quad.rounding = TAUT_UNIT_ROUNDOFF * far;
    w->curve_energy = w->branches.list[chosen].energy;
    return status;
}

/* (C4): an edge whose beta changes sign is singular where it vanishes. */
static taut_status check_regular(const work *w, taut_error *error)
{
    for (int e = 0; e < 4; e++) {
        const double at = taut_ribbon_singular(&w->ribbons[e]);
        if (isfinite(at)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "singular", "", at, taut_none,
                             "edge %s is singular at parameter %.6f: its normal would have to "
                             "turn over (sigma %+d and %+d at its ends, no inflection between); "
                             "other legs, or \"singular\": \"report\", build it",
                             taut_asymptotic_edge_name(e), at, taut_quad_sigma(&w->quad, e, 0),
                             taut_quad_sigma(&w->quad, e, 1));
        }
    }
    return TAUT_OK;
}

/* The free alpha_j, 2 <= j <= 3n-7: each adds B_j P / m to its row. */
static int list_freedoms(work *w)
{
    const int n = w->quad.degree, m = w->patch.m, degree = 3 * n - 5;
    int count = 0;
    for (int e = 0; e < 4; e++) {
        const int low = e == TAUT_ASYMPTOTIC_V0 || e == TAUT_ASYMPTOTIC_U0;
        for (int j = 2; j <= degree - 2 && !w->ribbons[e].straight; j++) {
            taut_plate_freedom *const freedom = &w->freedoms[count++];
            double unit[TAUT_RIBBON_ALPHA] = {0}, row[TAUT_QUAD_PATCH + 1][3];
            unit[j] = (low ? 1.0 : -1.0) / m;
            freedom->parts = 1;
            freedom->part[0].edge = e;
            taut_bernstein_scale(degree, unit, 2 * n - 2, 3, &w->ribbons[e].p[0][0], &row[0][0]);
            for (int k = 0; k <= m; k++) {
                memcpy(freedom->part[0].row[k], row[k], sizeof row[k]);
            }
        }
    }
    return count;
}

static void set_alphas(work *w, int count)
{
    const int per = 3 * w->quad.degree - 8;
    int k = 0;
    for (int e = 0; e < 4 && k < count; e++) {
        for (int j = 0; j < per && !w->ribbons[e].straight; j++) {
            w->ribbons[e].alpha[2 + j] = w->factors[k++];
        }
    }
}

/* Algorithm 2 at degree 5n - 7. */
static taut_status fill_paper(work *w, taut_error *error)
{
    const taut_plate_options options = {0, w->monitor};
    taut_status status = TAUT_OK;
    int count = 0;
    for (int e = 0; e < 4; e++) {
        taut_ribbon_fill(&w->quad, e, &w->ribbons[e]);
    }
    for (int e = 0; e < 4; e++) {
        taut_ribbon_ends(&w->quad, e, w->ribbons);
    }
    status = w->problem->report_singular ? TAUT_OK : check_regular(w, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_ribbon_twists(&w->quad, w->ribbons, w->patch.twist, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_ribbon_rows(&w->quad, w->ribbons, &w->patch, error);
    if (status != TAUT_OK) {
        return status;
    }
    count = w->problem->free_all ? list_freedoms(w) : 0;
    status = taut_plate_solve(&w->patch, count, w->freedoms, w->factors, &options, &w->patch_energy,
                              error);
    set_alphas(w, count);
    return status;
}

static taut_status fill_low(work *w, taut_error *error)
{
    if (w->problem->free_all) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "/free", taut_none, taut_none,
                         "the free alpha belong to surface \"5n-7\": leave out \"free\" or "
                         "\"surface\"");
    }
    return taut_low_fill(&w->quad, w->problem->report_singular, w->monitor, &w->patch,
                         &w->patch_energy, error);
}

/* ---- the model ---- */

static taut_status add_curve(const work *w, int e, taut_model *model, taut_error *error)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = w->quad.degree};
    const taut_quad_edge *const edge = &w->quad.edges[e];
    double points[TAUT_QUAD_POINTS][3];
    taut_basis *basis = NULL;
    taut_curve *curve = NULL;
    taut_status status = taut_basis_new(&spec, 0, &basis, error);
    if (status != TAUT_OK) {
        return status;
    }
    memcpy(points, edge->points, sizeof points);
    for (int j = 0; j <= w->quad.degree; j++) {
        taut_add_scaled(1.0, w->center, points[j]);
    }
    status = taut_curve_new(taut_asymptotic_edge_name(e), basis, &points[0][0], edge->weights,
                            &curve, error);
    taut_basis_free(basis);
    return status == TAUT_OK ? taut_construct_add_curve(model, curve, error) : status;
}

static taut_status add_patch(const work *w, taut_arena *arena, taut_model *model, taut_error *error)
{
    const int m = w->patch.m, counts[2] = {0, 0};
    const size_t count = (size_t)(m + 1) * (size_t)(m + 1);
    const taut_basis_spec spec = {.type = "bezier", .degree = m}, specs[2] = {spec, spec};
    double *const points = taut_arena_take(arena, 3 * count, sizeof *points);
    double *const weights = taut_arena_take(arena, count, sizeof *weights);
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (size_t k = 0; k < count; k++) {
        const double *const entry = w->patch.net[k];
        for (int d = 0; d < 3; d++) {
            points[3 * k + (size_t)d] = entry[d] / entry[3] + w->center[d];
        }
        weights[k] = entry[3];
    }
    return taut_construct_add_net(model, "patch", specs, counts, points, weights, NULL, error);
}

static const char *const closing_names[] = {"none", "identity", "constraint"};

static void add_edge(const work *w, int e, taut_record *edges)
{
    const taut_quad *const quad = &w->quad;
    const double sigma[2] = {taut_quad_sigma(quad, e, 0), taut_quad_sigma(quad, e, 1)};
    taut_record *const edge = taut_record_add_object(edges, taut_asymptotic_edge_name(e));
    taut_record_add_bool(edge, "straight", quad->edges[e].straight);
    if (quad->edges[e].straight) {
        return;
    }
    taut_record_add_numbers(edge, "sigma", 2, sigma);
    if (w->problem->surface == TAUT_BIDEGREE_5N_MINUS_7) {
        const taut_ribbon *const ribbon = &w->ribbons[e];
        const double torsion[2] = {taut_quad_torsion(quad, e, 0), taut_quad_torsion(quad, e, 1)};
        const double singular = taut_ribbon_singular(ribbon);
        taut_record_add_numbers(edge, "alpha", 3 * quad->degree - 4, ribbon->alpha);
        taut_record_add_numbers(edge, "beta", 2, ribbon->beta);
        taut_record_add_numbers(edge, "torsion", 2, torsion);
        taut_record_add_numbers(edge, "inflections", ribbon->inflections, ribbon->inflection);
        if (isfinite(singular)) {
            taut_record_add_number(edge, "singular_at", singular);
        }
    }
}

static void add_branches(const work *w, taut_record *details)
{
    taut_record *const list = taut_record_add_list(details, "branches");
    char text[5];
    for (int k = 0; k < w->branches.count; k++) {
        taut_record *const item = taut_record_add_object(list, NULL);
        taut_branch_text(w->branches.list[k].signs, text);
        taut_record_add_text(item, "branch", text);
        taut_record_add_number(item, "energy", w->branches.list[k].energy);
    }
}

/* What was decided. */
static taut_record *details_of(const work *w)
{
    taut_record *const details = taut_record_new();
    taut_record *edges = NULL, *corners = NULL;
    char text[5];
    int signs[4];
    for (int e = 0; e < 4; e++) {
        signs[e] = taut_quad_side(&w->quad, e, 0);
    }
    taut_branch_text(signs, text);
    taut_record_add_number(details, "curve_energy", w->curve_energy);
    taut_record_add_number(details, "plate_energy", w->patch_energy);
    taut_record_add_number(details, "degree", w->patch.m);
    taut_record_add_text(details, "branch", text);
    if (w->branches.count > 0) {
        taut_record_add_number(details, "unknowns", w->branches.unknowns);
        taut_record_add_text(details, "closing", closing_names[w->branches.closing]);
    }
    add_branches(w, details);
    edges = taut_record_add_object(details, "edges");
    for (int e = 0; e < 4; e++) {
        add_edge(w, e, edges);
    }
    corners = taut_record_add_object(details, "corners");
    for (int c = 0; c < 4; c++) {
        taut_record *const corner = taut_record_add_object(corners, taut_asymptotic_corner_name(c));
        taut_record_add_numbers(corner, "twist", 3, w->patch.twist[c]);
        taut_record_add_number(corner, "weight", w->patch.weight[c]);
    }
    return details;
}

static taut_status add_all(const work *w, taut_arena *arena, taut_model *model, taut_error *error)
{
    static const int order[4] = {TAUT_ASYMPTOTIC_V0, TAUT_ASYMPTOTIC_V1, TAUT_ASYMPTOTIC_U0,
                                 TAUT_ASYMPTOTIC_U1};
    taut_status status = add_patch(w, arena, model, error);
    for (int k = 0; k < 4 && status == TAUT_OK; k++) {
        status = add_curve(w, order[k], model, error);
    }
    return status == TAUT_OK ? taut_construct_set_details(model, details_of(w), error) : status;
}

static taut_status fill_quad(work *w, taut_error *error)
{
    const taut_status status =
        w->problem->given == TAUT_ASYMPTOTIC_CURVES ? use_curves(w, error) : find_curves(w, error);
    return status == TAUT_OK ? taut_quad_check(&w->quad, error) : status;
}

typedef struct request {
    const taut_asymptotic_problem *problem;
    const taut_monitor *monitor;
} request;

static taut_status fill_model(void *context, taut_arena *arena, taut_model *model,
                              taut_error *error)
{
    const request *const asked = context;
    const int low = asked->problem->surface == TAUT_BIDEGREE_N_PLUS_3;
    work *const w = taut_arena_take(arena, 1, sizeof *w);
    taut_status status = TAUT_OK;
    if (w == NULL) {
        return taut_fail_memory(error);
    }
    w->problem = asked->problem;
    w->monitor = asked->monitor;
    status = fill_quad(w, error);
    if (status != TAUT_OK) {
        return status;
    }
    center_quad(w);
    status = taut_patch_new(arena, low ? w->quad.degree + 3 : 5 * w->quad.degree - 7, &w->patch);
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = low ? fill_low(w, error) : fill_paper(w, error);
    return status == TAUT_OK ? add_all(w, arena, model, error) : status;
}

taut_status taut_asymptotic_make(const taut_asymptotic_problem *problem,
                                 const taut_make_options *options, taut_model **model,
                                 taut_error *error)
{
    request asked = {problem, options != NULL ? &options->monitor : NULL};

    if (problem == NULL || model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_asymptotic_make needs a problem and a place for the model");
    }
    return taut_construct_build(fill_model, &asked, model, error);
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_asymptotic_make(data, options, model, error);
}

const taut_construct_ops taut_construct_asymptotic = {.make = make};
