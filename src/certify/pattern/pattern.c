/* pattern.c -- do these flat pieces make the surface? From the finished model, none of it by the code that made it.
 *
 *   surface      with the problem: the surface is the one given, or what its problem makes (certify/common/of.h)
 *   cover, on-surface, geodesic, edges, seams, lengths   (certify/pattern/seams.h)
 *   no-fold, no-overlap   (certify/pattern/fold.h)
 *   allowance    (certify/pattern/allowance.h)
 *   layout, thread, compensation, details   (certify/pattern/asked.h)
 *   stationary   gradient of the Lagrangian over the largest that strains of 1 would give; of pieces that were solved (check)
 *   stable       the lowest eigenvalue on the constraints over the largest of the diagonal; of these (check)
 *   conformal    of all pieces that were laid flat by angles: the largest ratio of both stretches, less 1 (check)
 *   isometric    largest strain of pieces that are told to have none (check)
 *   strain       largest principal strain, where one is asked for (certify/pattern/strain.h: bound; else of places, check)
 *   exhausts     certify/pattern/area.h
 *   roll         pieces that are not proved apart on the roll, or leave it (certify/pattern/roll.h)
 */
#include "taut/pattern.h"

#include "certify/certify_ops.h"
#include "certify/common/of.h"
#include "certify/pattern/allowance.h"
#include "certify/pattern/area.h"
#include "certify/pattern/asked.h"
#include "certify/pattern/energy.h"
#include "certify/pattern/fold.h"
#include "certify/pattern/lengths.h"
#include "certify/pattern/roll.h"
#include "certify/pattern/seams.h"
#include "certify/pattern/strain.h"
#include "certify/pattern/unavoidable.h"
#include "certify/pattern/worst.h"
#include "core/fail.h"

#include <string.h>

static const double tolerance_default = 1e-6, stationary_limit = 1e-9, isometric_limit = 1e-11;
/* Of the ratio of stretches: at corners angles are off by what a spline leaves of r^2 log r. */
static const double angle_limit = 1e-3;
/* Between stations limits were found to be 1.07 times at the most what they are there. */
static const double near_the_most = 0.85;
/* Of a piece for the pulse: operations, roughly. */
static const double work_of_piece = 5e7;

/* ---- pieces, each by itself ---- */

typedef struct states {
    const taut_cloth *cloth;
    taut_cloth_state *list;
    taut_cloth_limit *limits;
    taut_status *status;
    int *near;      /* of what each may have the largest */
    double *bounds; /* of its strains, where they are asked for; NaN: not proved */
} states;

static void look(void *context, int worker, int64_t task)
{
    const states *s = context;
    const taut_cloth_piece *piece = &s->cloth->pieces[task];
    s->status[task] =
        taut_cloth_look_at(s->cloth, piece, !piece->is_developed && !s->cloth->is_conformal,
                           worker == 0 ? s->cloth->crew->pulse : NULL, &s->list[task]);
}

static void bound_strain(void *context, int worker, int64_t task)
{
    const states *s = context;
    s->bounds[task] =
        taut_cloth_strain_bound(s->cloth, &s->cloth->pieces[task], s->list[task].largest,
                                s->cloth->strain, worker == 0 ? s->cloth->crew->pulse : NULL);
}

static void find_limit(void *context, int worker, int64_t task)
{
    const states *s = context;
    taut_cloth_limit_of(s->cloth, &s->cloth->pieces[task],
                        worker == 0 ? s->cloth->crew->pulse : NULL, &s->limits[task]);
}

static void refine_limit(void *context, int worker, int64_t task)
{
    const states *s = context;
    taut_cloth_limit_refine(s->cloth, &s->cloth->pieces[task], s->near[task],
                            worker == 0 ? s->cloth->crew->pulse : NULL, &s->limits[task]);
}

/* Figures are the largest of all pieces: between its stations only a piece is looked at that can be the one. */
static void choose_near(states *s)
{
    double unavoidable = 0, expected = 0;
    for (int k = 0; k < s->cloth->piece_count; k++) {
        unavoidable = fmax(unavoidable, s->limits[k].unavoidable);
        expected = fmax(expected, s->limits[k].expected);
    }
    for (int k = 0; k < s->cloth->piece_count; k++) {
        const taut_cloth_limit *one = &s->limits[k];
        s->near[k] =
            (one->unavoidable >= near_the_most * unavoidable ? TAUT_CLOTH_UNAVOIDABLE : 0) |
            (one->expected >= near_the_most * expected ? TAUT_CLOTH_EXPECTED : 0);
    }
}

static taut_status look_at_all(const taut_cloth *cloth, taut_arena *arena, taut_cloth_state **list,
                               taut_cloth_limit **limits, double **bounds)
{
    const size_t count = (size_t)cloth->piece_count;
    states s = {cloth,
                taut_arena_take(arena, count + 1, sizeof *s.list),
                taut_arena_take(arena, count + 1, sizeof *s.limits),
                taut_arena_take(arena, count + 1, sizeof *s.status),
                taut_arena_take(arena, count + 1, sizeof *s.near),
                taut_arena_take(arena, count + 1, sizeof *s.bounds)};
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    const int workers = taut_crew_workers(cloth->crew, (int64_t)count);
    if (taut_crew_run(cloth->crew, workers, (int64_t)count, work_of_piece, look, &s) ||
        taut_crew_run(cloth->crew, workers, (int64_t)count, work_of_piece, find_limit, &s)) {
        return TAUT_INTERRUPTED;
    }
    choose_near(&s);
    if (taut_crew_run(cloth->crew, workers, (int64_t)count, work_of_piece, refine_limit, &s)) {
        return TAUT_INTERRUPTED;
    }
    if (cloth->strain > 0 &&
        taut_crew_run(cloth->crew, workers, (int64_t)count, work_of_piece, bound_strain, &s)) {
        return TAUT_INTERRUPTED;
    }
    *list = s.list;
    *limits = s.limits;
    *bounds = s.bounds;
    for (size_t k = 0; k < count; k++) {
        if (s.status[k] != TAUT_OK) {
            return s.status[k];
        }
    }
    return TAUT_OK;
}

/* Where all pieces are proved to be strained no more between the places that are looked at, by how much that is. */
static taut_status add_strain(const taut_cloth *cloth, const taut_cloth_state *list,
                              const double *bounds, taut_certificate *certificate)
{
    taut_worst found = {0, ""}, proved = {0, ""};
    int is_proved = 1;
    for (int k = 0; k < cloth->piece_count; k++) {
        const char *name = cloth->pieces[k].name;
        taut_worst_take(&found, list[k].is_folded ? INFINITY : list[k].largest, name, 0);
        taut_worst_take(&proved, bounds[k], name, 0);
        is_proved &= !list[k].is_folded && isfinite(bounds[k]);
    }
    return taut_worst_add(is_proved ? &proved : &found, "strain",
                          is_proved ? TAUT_BOUND : TAUT_CHECK, cloth->strain, certificate);
}

static taut_status add_states(const taut_cloth *cloth, const taut_cloth_state *list,
                              const double *bounds, taut_certificate *certificate)
{
    taut_worst gradient = {0, ""}, isometric = {0, ""}, stable = {0, ""}, angle = {0, ""};
    int solved = 0, developed = 0;
    double lowest = INFINITY;

    for (int k = 0; k < cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k];
        const taut_cloth_state *one = &list[k];
        taut_worst_take(&angle, one->is_folded ? INFINITY : one->angle, piece->name, 0);
        if (piece->is_developed) {
            developed = 1;
            taut_worst_take(&isometric, one->is_folded ? INFINITY : one->largest, piece->name, 0);
            continue;
        }
        if (cloth->is_conformal) {
            continue;
        }
        solved = 1;
        taut_worst_take(&gradient, one->is_folded ? INFINITY : one->residual, piece->name, 0);
        if (!(one->stiffness >= lowest)) {
            lowest = one->stiffness;
            snprintf(stable.where, sizeof stable.where, "%.40s", piece->name);
        }
    }
    taut_status status = cloth->is_conformal ? taut_worst_add(&angle, "conformal", TAUT_CHECK,
                                                              angle_limit, certificate)
                                             : TAUT_OK;
    if (status == TAUT_OK && solved) {
        status = taut_worst_add(&gradient, "stationary", TAUT_CHECK, stationary_limit, certificate);
    }
    if (status == TAUT_OK && solved) {
        const taut_claim claim = {.claim = "stable",
                                  .kind = TAUT_CHECK,
                                  .residual = lowest,
                                  .limit = 0,
                                  .holds = taut_certify_above(lowest, 0),
                                  .where = stable.where};
        status = taut_certificate_add(certificate, &claim);
    }
    if (status == TAUT_OK && developed) {
        status = taut_worst_add(&isometric, "isometric", TAUT_CHECK, isometric_limit, certificate);
    }
    if (status == TAUT_OK && cloth->strain > 0) {
        status = add_strain(cloth, list, bounds, certificate);
    }
    return status;
}

/* ---- figures ---- */

/* Of the piece that has the most to be proved. */
static double proved_of(const taut_cloth *cloth, const taut_cloth_limit *limits)
{
    int most = 0;
    for (int k = 1; k < cloth->piece_count; k++) {
        most = limits[k].unavoidable > limits[most].unavoidable ? k : most;
    }
    return limits[most].unavoidable > 0
               ? taut_cloth_limit_proved(cloth, &cloth->pieces[most], cloth->crew->pulse)
               : 0;
}

static taut_status add_figures(const taut_cloth *cloth, const taut_cloth_state *list,
                               const taut_cloth_limit *limits, double area,
                               taut_certificate *certificate)
{
    taut_record *figures = taut_record_new();
    const taut_record *roll = taut_record_get(taut_model_details(cloth->model), "roll");
    double flat = 0, cut = 0, energy = 0, plain = 0, seams = 0, unavoidable = 0, expected = 0;
    double conformal = 0;
    double strain[2] = {INFINITY, -INFINITY}, inner[2] = {INFINITY, -INFINITY};

    for (int k = 0; k < cloth->piece_count; k++) {
        flat += list[k].flat_area;
        cut += taut_cloth_cut_area(cloth, &cloth->pieces[k]);
        energy += list[k].energy;
        plain += list[k].plain;
        conformal += list[k].conformal;
        strain[0] = taut_certify_min(strain[0], list[k].strain[0]);
        strain[1] = taut_certify_max(strain[1], list[k].strain[1]);
        inner[0] = taut_certify_min(inner[0], list[k].inner[0]);
        inner[1] = taut_certify_max(inner[1], list[k].inner[1]);
        unavoidable = taut_certify_max(unavoidable, limits[k].unavoidable);
        expected = taut_certify_max(expected, limits[k].expected);
    }
    for (int k = 0; k < cloth->piece_count; k++) {
        for (int e = 0; e < TAUT_CLOTH_EDGES; e++) { /* once a seam: those to its left */
            const taut_cloth_piece *piece = &cloth->pieces[k];
            seams += piece->is_sewn[e] && taut_cloth_is_first(cloth, piece, e)
                         ? piece->flat_lengths[e]
                         : 0;
        }
    }
    taut_record_add_number(figures, "pieces", cloth->piece_count);
    taut_record_add_number(figures, "area", ldexp(area, 2 * cloth->unit));
    taut_record_add_number(figures, "flat_area", ldexp(flat, 2 * cloth->unit));
    taut_record_add_number(figures, "seam_length", ldexp(seams, cloth->unit));
    taut_record_add_number(figures, "waste",
                           1 - ldexp(cut, 2 * cloth->unit) /
                                   (taut_record_number(taut_record_get(roll, "length")) *
                                    taut_record_number(taut_record_get(roll, "width"))));
    taut_record *curvature = taut_record_add_list(figures, "curvature");
    for (int k = 0; k < cloth->piece_count; k++) {
        taut_record_add_number(curvature, NULL, list[k].curvature);
    }
    taut_record_add_number(figures, "max_strain", strain[1]);
    taut_record_add_number(figures, "min_strain", strain[0]);
    taut_record_add_number(figures, "inner_max_strain", inner[1]);
    taut_record_add_number(figures, "inner_min_strain", inner[0]);
    taut_record_add_number(figures, "rms_strain", sqrt(2 * plain / area));
    taut_record_add_number(figures, "energy", ldexp(energy, 2 * cloth->unit));
    if (cloth->is_conformal) {
        taut_record_add_number(figures, "conformal_energy", ldexp(conformal, 2 * cloth->unit));
    }
    if (cloth->fade_count > 0) { /* the theorem is of one compensation everywhere */
        taut_record_add_null(figures, "unavoidable_strain");
    } else {
        taut_record_add_number(figures, "unavoidable_strain", unavoidable);
    }
    taut_record_add_text(figures, "unavoidable_kind", "check");
    if (cloth->fade_count > 0) {
        taut_record_add_null(figures, "proved_strain");
    } else {
        taut_record_add_number(figures, "proved_strain", proved_of(cloth, limits));
    }
    taut_record_add_number(figures, "expected_strain", expected);
    const taut_status status = taut_record_status(figures);
    taut_certificate_set_figures(certificate, figures);
    return status;
}

/* ---- the whole ---- */

/* Between what takes long: TAUT_INTERRUPTED where it is to end. */
static taut_status report(const taut_cloth *cloth)
{
    return taut_pulse_report(cloth->crew->pulse) ? TAUT_INTERRUPTED : TAUT_OK;
}

static taut_status prove(const taut_cloth *cloth, taut_arena *arena, taut_certificate *certificate)
{
    taut_cloth_state *list = NULL;
    taut_cloth_limit *limits = NULL;
    double area = 0, *bounds = NULL;
    taut_status status = taut_cloth_add_lines(cloth, arena, certificate);
    if (status == TAUT_OK) {
        status = report(cloth);
    }
    if (status == TAUT_OK) {
        status = taut_cloth_add_folds(cloth, arena, certificate);
    }
    if (status == TAUT_OK) {
        status = report(cloth);
    }
    if (status == TAUT_OK) {
        status = taut_cloth_add_allowance(cloth, arena, certificate);
    }
    if (status == TAUT_OK) {
        status = look_at_all(cloth, arena, &list, &limits, &bounds);
    }
    if (status == TAUT_OK) {
        status = taut_cloth_add_asked(cloth, arena, certificate);
    }
    if (status == TAUT_OK) {
        status = add_states(cloth, list, bounds, certificate);
    }
    if (status == TAUT_OK) {
        status = taut_cloth_add_told(cloth, list, certificate);
    }
    if (status == TAUT_OK) {
        status = report(cloth);
    }
    if (status == TAUT_OK) {
        status = taut_cloth_add_exhausts(cloth, &area, certificate);
    }
    if (status == TAUT_OK) {
        status = report(cloth);
    }
    if (status == TAUT_OK) {
        status = taut_cloth_add_roll(cloth, arena, certificate);
    }
    return status == TAUT_OK ? add_figures(cloth, list, limits, area, certificate) : status;
}

static taut_status add_surface(const taut_cloth *cloth, taut_arena *arena, const taut_audit *audit,
                               taut_certificate *certificate, taut_error *error)
{
    const taut_pattern_problem *p = cloth->problem;
    /* of a model all are cut where none is named */
    const int asked = p != NULL && p->model != NULL && p->surface == NULL
                          ? taut_model_surface_count(p->model)
                          : 1;
    const int count = p != NULL && p->model != NULL ? asked
                      : cloth->is_several           ? cloth->surface_count
                                                    : 1;
    const taut_certify_given given = {p != NULL ? p->model : NULL, p != NULL ? p->of : NULL,
                                      p != NULL ? p->surface : NULL, count > 1,
                                      cloth->surface_count};
    return p != NULL ? taut_certify_of(cloth->model, taut_model_surface(cloth->model, 0), &given,
                                       arena, audit, certificate, error)
                     : TAUT_OK;
}

static taut_status certify_in(taut_arena *arena, const taut_model *model,
                              const taut_pattern_problem *problem, const taut_audit *audit,
                              taut_certificate *certificate, taut_error *error)
{
    taut_cloth cloth = {.crew = &audit->crew,
                        .tolerance = audit->tolerance > 0 ? audit->tolerance : tolerance_default};
    taut_status status = taut_cloth_read(arena, model, problem, &cloth, error);

    if (status == TAUT_OK) {
        status = add_surface(&cloth, arena, audit, certificate, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_cloth_measure_edges(&cloth);
    if (status == TAUT_OK) {
        status = prove(&cloth, arena, certificate);
    }
    return status == TAUT_OK ? TAUT_OK : taut_fail_status(error, status);
}

static taut_status certify(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status = arena != NULL
                                   ? certify_in(arena, model, data, audit, certificate, error)
                                   : taut_fail_memory(error);
    taut_arena_free(arena);
    return status;
}

/* Does no piece before this one lie on its surface? */
static int is_first_of(const taut_record *pieces, size_t piece)
{
    const char *name = taut_record_text(taut_record_get(taut_record_at(pieces, piece), "surface"));
    for (size_t k = 0; k < piece; k++) {
        if (strcmp(taut_record_text(taut_record_get(taut_record_at(pieces, k), "surface")), name) ==
            0) {
            return 0;
        }
    }
    return 1;
}

/* The surface, and of each piece of details its flat surface and its lines; the seams. */
static void identify(const taut_model *model, const void *data, taut_identity *identity)
{
    static const char *const lines[] = {"right", "end", "left", "start", "cut"};
    const taut_pattern_problem *problem = data;
    const taut_record *details = taut_model_details(model);
    const taut_record *pieces = taut_record_get(details, "pieces");
    const taut_record *seams = taut_record_get(details, "seams");
    const taut_surface *given = problem != NULL && problem->model != NULL
                                    ? taut_certify_named(problem->model, problem->surface)
                                    : NULL;

    if (taut_record_get(taut_record_at(pieces, 0), "surface") == NULL) {
        taut_identity_surface(identity, 0, given != NULL ? taut_surface_name(given) : NULL, NULL,
                              NULL);
    }
    for (size_t k = 0; k < taut_record_count(pieces); k++) { /* of several, that of each piece */
        const taut_record *surface = taut_record_get(taut_record_at(pieces, k), "surface");
        const int index = taut_identity_find_surface(identity, taut_record_text(surface));
        if (surface != NULL && index >= 0 && is_first_of(pieces, k)) {
            taut_identity_surface(identity, index, taut_record_text(surface), NULL, NULL);
        }
    }
    for (size_t k = 0; k < taut_record_count(pieces); k++) {
        const char *name = taut_record_text(taut_record_get(taut_record_at(pieces, k), "name"));
        taut_identity_surface(identity, taut_identity_find_surface(identity, name), name, NULL,
                              NULL);
        for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
            char line[TAUT_NAME_MAX + 16];
            snprintf(line, sizeof line, "%.200s.%s", name, lines[i]);
            const int index = taut_identity_find_curve(identity, line);
            taut_identity_curve(identity, index,
                                index >= 0 ? taut_curve_name(taut_model_curve(model, index)) : name,
                                NULL);
        }
    }
    for (size_t k = 0; k < taut_record_count(seams); k++) {
        const char *name = taut_record_text(taut_record_get(taut_record_at(seams, k), "name"));
        taut_identity_curve(identity, taut_identity_find_curve(identity, name), name, NULL);
    }
}

const taut_certify_ops taut_certify_pattern = {.certify = certify, .identify = identify};

taut_status taut_pattern_certify(const taut_model *model, const taut_pattern_problem *problem,
                                 const taut_certify_options *options,
                                 taut_certificate **certificate, taut_error *error)
{
    return taut_certify_with(&taut_certify_pattern, "pattern", model, problem, options, certificate,
                             error);
}
