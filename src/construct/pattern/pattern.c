/* pattern.c -- the construction `pattern`: a surface cut in pieces that are laid flat.
 *
 *     1. the surface: of the model, or of what the problem makes
 *     2. the pieces that the rule cuts it in (layout.h); where it says no count, of the least count that fits the roll
 *     3. each piece flat, alone and then with its seams held (flatten.h)
 *     4. the lines to sew and to cut along (outline.h), on the roll (roll.h)
 */
#include "taut/pattern.h"

#include "construct/common/build.h"
#include "construct/common/of.h"
#include "construct/construct_ops.h"
#include "construct/pattern/allowance.h"
#include "construct/pattern/details.h"
#include "construct/pattern/overlap.h"
#include "construct/pattern/rule.h"
#include "core/fail.h"
#include "core/unit.h"
#include "core/vec3.h"
#include "geometry/chart/least_strain.h"
#include "geometry/exponent.h"
#include "problem/problem.h"
#include "taut/join.h"
#include "trace/seam.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Lengths are parameters, which are from 1e-60 to 1e60 (docs/limits.md): of sizes below 2^this. */
enum { EXPONENT_MOST = 150, MARKS_MOST = 1000 /* along a seam */ };
/* Of the outline of a piece for the pulse: operations, roughly. */
static const double work_of_outline = 1e7;
/* Edges of exact length leave those of the flat spline by so much of the size at the most, or it gets twice the spans both ways. */
static const double drift_most = 2e-7;
enum { REFINEMENTS = 3, DRIFT_PLACES = 64, CLAIMED_PLACES = 1024 /* of the certificate */ };
/* What is claimed of them, over the size; and of their lengths, which are off by what is left at their ends. */
static const double drift_claimed = 1e-6, closure_claimed = 1e-9;
/* Seams are claimed to be as equal over their own length, with what is left at the ends of both sides. */
static const double closure_most = 3e-10, longer_most = 4e-10;
/* Lengths settle to a tolerance that is smaller. */
static const double tolerance_default = 1e-6;
/* Steps with its seams held after which a piece gets no finest splines, whose steps take a second each. */
enum { TOO_MANY = 24 };
/* Edges that are so many times as far off as is claimed, and hardly nearer than on half the spans, come no nearer. */
static const double far_off = 100, hardly = 0.5;
enum { HOPED = 10 }; /* what twice the spans gain of these, where strain is singular at a corner */
/* Strains between the places that are looked at may be larger. */
static const double strain_room = 0.999;
/* Corners of surfaces that meet, over the size. */
static const double same_corner = 1e-9;

typedef struct request {
    const taut_pattern_problem *problem;
    const taut_make_options *options;
    taut_pattern_cut cut;
    const taut_crew *crew;
} request;

/* The surfaces that are cut. */
typedef struct cut_surfaces {
    int count;
    taut_pattern_ground *grounds;
} cut_surfaces;

/* All that was made of a count of strips. */
typedef struct made_pieces {
    taut_arena *arena;
    taut_pattern_layout layout;
    taut_pattern_outline *outlines;
    taut_pattern_margin *margins;
    double widest; /* extent across of a cut piece, in the carrier's unit */
    int widest_piece;
    double longest; /* and along */
    int longest_piece;
    double strain; /* the largest of all principal ones */
    double
        ruled_out; /* above 0: nothing was laid flat, as none is strained by less than this, more than is asked for */
    int ruled_out_piece;
} made_pieces;

/* ---- what is asked for ---- */

static taut_status check_range(double value, double low, double high, const char *reason,
                               const char *where, taut_error *error)
{
    if (value >= low && value <= high) {
        return TAUT_OK;
    }
    return taut_fail(error, TAUT_BAD_INPUT, reason, where, value, value < low ? low : high,
                     "found %.17g, expected a number from %.17g to %.17g", value, low, high);
}

static taut_status check_material(const taut_pattern_material *m, taut_error *error)
{
    if (m->e[0] == 0 && m->e[1] == 0 && m->nu == 0 && m->g == 0) {
        return TAUT_OK;
    }
    const int is_cloth = m->e[0] > 0 && m->e[1] > 0 && m->g > 0 && m->nu >= 0 &&
                         m->nu * m->nu * m->e[1] < m->e[0] && isfinite(m->e[0]) &&
                         isfinite(m->e[1]) && isfinite(m->g);
    return is_cloth ? TAUT_OK
                    : taut_fail(error, TAUT_BAD_INPUT, "material", "/cloth/material", taut_none,
                                taut_none,
                                "found moduli %.6g and %.6g, nu %.6g, G %.6g, expected E and G "
                                "above 0, and nu^2 below E_warp/E_weft",
                                m->e[0], m->e[1], m->nu, m->g);
}

/* Strips of a number that is not told. */
static int is_searched(const taut_pattern_rule *rule)
{
    return (rule->kind == TAUT_PATTERN_ACROSS || rule->kind == TAUT_PATTERN_RADIAL) &&
           rule->count == 0;
}

static taut_status check_strips(const taut_pattern_problem *problem, int index, taut_error *error)
{
    const taut_pattern_rule *rule = &problem->rules[index];
    char where[48];
    snprintf(where, sizeof where, "/seams/%d/%s", index,
             rule->kind == TAUT_PATTERN_RADIAL ? "radial" : "across");
    if ((unsigned)rule->edges[0] > 3 || (unsigned)rule->edges[1] > 3 ||
        rule->edges[0] == rule->edges[1] || (int)rule->edges[0] / 2 != (int)rule->edges[1] / 2) {
        return taut_fail(error, TAUT_BAD_INPUT, "edge", where, taut_none, taut_none,
                         "found %s and %s, expected two opposite edges",
                         taut_edge_name(rule->edges[0]), taut_edge_name(rule->edges[1]));
    }
    snprintf(where, sizeof where, "/seams/%d/count", index);
    if (rule->count < 0 || rule->count > TAUT_PATTERN_PIECES_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "count", where, rule->count,
                         TAUT_PATTERN_PIECES_MAX, "found %d, expected a number from 1 to %d",
                         rule->count, TAUT_PATTERN_PIECES_MAX);
    }
    if (is_searched(rule) && !(rule->width > 0) && !(problem->cloth.width > 0) &&
        !(rule->strain > 0)) {
        return taut_fail(error, TAUT_BAD_INPUT, "missing", "/cloth/width", taut_none, taut_none,
                         "found no count, no width and no strain, expected one of them");
    }
    snprintf(where, sizeof where, "/seams/%d/trim", index);
    if (rule->trim != 0 && rule->kind != TAUT_PATTERN_RADIAL) {
        return taut_fail(error, TAUT_BAD_INPUT, "rule", where, rule->trim, 0,
                         "found a trim across, expected it beside \"radial\" alone");
    }
    const taut_status status = check_range(rule->trim, 0, 1e300, "value", where, error);
    if (status != TAUT_OK) {
        return status;
    }
    snprintf(where, sizeof where, "/seams/%d/strain", index);
    return check_range(rule->strain, 0, 1, "value", where, error);
}

static taut_status check_at(const taut_pattern_at *at, int index, taut_error *error)
{
    char where[48];
    snprintf(where, sizeof where, "/seams/%d", index);
    if (at->is_on_edge && (unsigned)at->edge > 3) {
        return taut_fail(error, TAUT_BAD_INPUT, "edge", where, taut_none, taut_none,
                         "found edge %d, expected one of u0, u1, v0 and v1", (int)at->edge);
    }
    return at->is_on_edge ? check_range(at->value, -1e300, 1e300, "outside", where, error)
                          : TAUT_OK;
}

/* In every strip that is longer than the cloth. */
static int is_equal_butts(const taut_pattern_rule *rule)
{
    return rule->kind == TAUT_PATTERN_BUTT && rule->strip == -1;
}

static taut_status check_equal_butts(const taut_pattern_problem *problem, int index,
                                     taut_error *error)
{
    char where[48];
    snprintf(where, sizeof where, "/seams/%d/butt", index);
    if (!(problem->cloth.length > 0)) {
        return taut_fail(
            error, TAUT_BAD_INPUT, "missing", "/cloth/length", taut_none, taut_none,
            "found no length of the cloth, expected one, which \"butt\": \"auto\" cuts "
            "longer strips for");
    }
    return index > 0 && index + 1 == problem->rule_count
               ? TAUT_OK
               : taut_fail(error, TAUT_BAD_INPUT, "rule", where, index, problem->rule_count - 1,
                           "found \"auto\" in rule %d of %d, expected it in the last one, after "
                           "those that make strips",
                           index + 1, problem->rule_count);
}

static taut_status check_rule(const taut_pattern_problem *problem, int index, taut_error *error)
{
    const taut_pattern_rule *rule = &problem->rules[index];
    char where[48];
    snprintf(where, sizeof where, "/seams/%d", index);
    switch (rule->kind) {
    case TAUT_PATTERN_ACROSS:
    case TAUT_PATTERN_RADIAL:
        return check_strips(problem, index, error);
    case TAUT_PATTERN_PARALLEL:
    case TAUT_PATTERN_GEODESIC: {
        taut_status status = check_at(&rule->at[0], index, error);
        if (status == TAUT_OK) {
            status = check_at(&rule->at[1], index, error);
        }
        return status == TAUT_OK && rule->kind == TAUT_PATTERN_PARALLEL
                   ? check_range(rule->spacing, 1e-300, 1e300, "value", where, error)
                   : status;
    }
    case TAUT_PATTERN_LINE:
    case TAUT_PATTERN_BUTT:
        if (is_equal_butts(rule)) {
            return check_equal_butts(problem, index, error);
        }
        if (rule->value_count < 1 || rule->values == NULL ||
            (rule->kind == TAUT_PATTERN_BUTT && (index == 0 || rule->strip < 0))) {
            return taut_fail(error, TAUT_BAD_INPUT, "rule", where, taut_none, taut_none,
                             rule->kind == TAUT_PATTERN_BUTT
                                 ? "found a butt before there are strips, or nowhere, expected one "
                                   "in a strip that rules before it make"
                                 : "found no value of a line, expected one");
        }
        return TAUT_OK;
    case TAUT_PATTERN_CURVE:
        if (rule->curve != NULL) {
            return TAUT_OK;
        }
        break;
    }
    return taut_fail(error, TAUT_BAD_INPUT, "rule", where, (int)rule->kind, taut_none,
                     "found a rule that is not known");
}

static taut_status check_rules(const taut_pattern_problem *problem, taut_error *error)
{
    int searched = 0;
    for (int k = 0; k < problem->rule_count; k++) {
        const taut_status status = check_rule(problem, k, error);
        if (status != TAUT_OK) {
            return status;
        }
        searched += is_searched(&problem->rules[k]);
        if (searched > 1) {
            char where[48];
            snprintf(where, sizeof where, "/seams/%d", k);
            return taut_fail(error, TAUT_BAD_INPUT, "rule", where, searched, 1,
                             "found two rules whose number of strips is to be found, expected one");
        }
    }
    return TAUT_OK;
}

/* How much smaller cloth is cut that is to be stressed so. */
static taut_pattern_compensation compensation_of(const taut_pattern_problem *problem)
{
    const taut_pattern_material *m = &problem->cloth.material;
    const double s[2] = {problem->prestress.warp, problem->prestress.weft};
    taut_pattern_compensation c = problem->compensation;
    if (problem->has_prestress) {
        const double warp = (s[0] - m->nu * s[1]) / m->e[0];
        const double weft = s[1] / m->e[1] - m->nu * s[0] / m->e[0];
        c.warp = warp / (1 + warp);
        c.weft = weft / (1 + weft);
    }
    return c;
}

static taut_status check_decompensate(const taut_pattern_problem *problem, taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int k = 0; status == TAUT_OK && k < problem->decompensate_count; k++) {
        const taut_pattern_decompensate *one = &problem->decompensate[k];
        char where[48];
        snprintf(where, sizeof where, "/decompensate/%d/length", k);
        if ((unsigned)one->edge > 3) {
            return taut_fail(error, TAUT_BAD_INPUT, "edge", "/decompensate", (int)one->edge,
                             taut_none, "found edge %d, expected one of u0, u1, v0 and v1",
                             (int)one->edge);
        }
        status = check_range(one->length, 1e-300, 1e300, "value", where, error);
    }
    return status;
}

/* Pieces of which angles are kept have no material, and are not made smaller or held. */
static taut_status check_flatten(const taut_pattern_problem *problem, taut_error *error)
{
    const taut_pattern_compensation *c = &problem->compensation;
    const char *beside = NULL;
    int held = 0;
    for (int k = 0; k < 4; k++) {
        held |= problem->held.borders[k] || problem->held.edges[k];
    }
    beside = problem->cloth.material.g > 0                 ? "/cloth/material"
             : problem->has_prestress                      ? "/prestress"
             : c->warp != 0 || c->weft != 0 || c->has_seam ? "/compensation"
             : problem->decompensate_count > 0             ? "/decompensate"
             : held                                        ? "/held"
             : problem->ends == TAUT_PATTERN_ENDS_STRAIGHT ? "/ends"
                                                           : NULL;
    if ((unsigned)problem->flatten > TAUT_PATTERN_CONFORMAL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", "/flatten", (int)problem->flatten,
                         TAUT_PATTERN_CONFORMAL, "found a way of flattening that is not known");
    }
    return problem->flatten == TAUT_PATTERN_CONFORMAL && beside != NULL
               ? taut_fail(
                     error, TAUT_BAD_INPUT, "conflict", beside, taut_none, taut_none,
                     "found it beside \"flatten\": \"conformal\", which looks at angles alone, "
                     "expected one of them")
               : TAUT_OK;
}

static taut_status check_problem(const taut_pattern_problem *problem, taut_error *error)
{
    const taut_pattern_compensation *c = problem != NULL ? &problem->compensation : NULL;
    if (problem == NULL || (problem->model == NULL) == (problem->of == NULL) ||
        problem->rule_count < 1 || problem->rules == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a pattern needs a model or a problem of its surface, and a rule");
    }
    taut_status status = check_rules(problem, error);
    if (status == TAUT_OK) {
        status = check_flatten(problem, error);
    }
    if (status == TAUT_OK) {
        status = check_range(problem->cloth.width, 0, 1e300, "value", "/cloth/width", error);
    }
    if (status == TAUT_OK) {
        status = check_range(problem->cloth.length, 0, 1e300, "value", "/cloth/length", error);
    }
    if (status == TAUT_OK) {
        status = check_range(problem->cloth.gap, 0, 1e300, "value", "/cloth/gap", error);
    }
    if (status == TAUT_OK) {
        status = check_range(problem->cloth.thread, -4, 4, "value", "/cloth/thread", error);
    }
    if (status == TAUT_OK) {
        status = check_material(&problem->cloth.material, error);
    }
    if (status == TAUT_OK && problem->ends == TAUT_PATTERN_ENDS_STRAIGHT &&
        problem->cloth.thread != 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "/ends", problem->cloth.thread, 0,
                         "found ends that are straight, square to the warp, beside a thread that "
                         "does not run along");
    }
    if (status == TAUT_OK && problem->has_prestress && !(problem->cloth.material.g > 0)) {
        return taut_fail(error, TAUT_BAD_INPUT, "material", "/prestress", taut_none, taut_none,
                         "found a prestress without the moduli of a material");
    }
    const taut_pattern_compensation shrunk =
        status == TAUT_OK ? compensation_of(problem) : (taut_pattern_compensation){.warp = 0};
    const taut_pattern_allowance *a = &problem->allowance;
    const double lengths[5] = {a->seam, a->border, a->overlap, problem->marks.spacing, a->butt};
    static const char *const left[5] = {"/allowance/seam", "/allowance/border",
                                        "/allowance/overlap", "/marks/spacing", "/allowance/butt"};
    for (int k = 0; status == TAUT_OK && k < 5; k++) {
        status = check_range(lengths[k], 0, 1e300, "allowance", left[k], error);
    }
    for (int k = 0; status == TAUT_OK && k < 2 * a->seam_count; k++) {
        const taut_pattern_seam_allowance *own = &a->seams[k / 2];
        char where[64];
        snprintf(where, sizeof where, "/allowance/%.40s", own->seam != NULL ? own->seam : "");
        status = own->seam == NULL
                     ? taut_fail(error, TAUT_BAD_ARGUMENT, "argument", "/allowance", taut_none,
                                 taut_none, "an allowance of a seam needs its name")
                     : check_range(k % 2 == 0 ? own->right : own->left, 0, 1e300, "allowance",
                                   where, error);
    }
    for (int k = 0; status == TAUT_OK && k < problem->hem_count; k++) {
        status = check_range(problem->hems[k].pocket, 0, 1e300, "allowance", "/hems", error);
    }
    if (status == TAUT_OK) {
        status = check_decompensate(problem, error);
    }
    const double shares[3] = {shrunk.warp, shrunk.weft, c->has_seam ? c->seam : 0};
    const int pressed = problem->has_prestress;
    const char *const places[3] = {pressed ? "/prestress/0" : "/compensation/warp",
                                   pressed ? "/prestress/1" : "/compensation/weft",
                                   "/compensation/seam"};
    if (status == TAUT_OK) {
        status = check_range(problem->strain, 0, 1, "value", "/strain", error);
    }
    for (int k = 0; status == TAUT_OK && k < 3; k++) {
        status = check_range(shares[k], -0.1, 0.3, "compensation", places[k], error);
    }
    return status;
}

static void take_cut(request *r)
{
    const taut_pattern_material *m = &r->problem->cloth.material;
    const int is_conformal = r->problem->flatten == TAUT_PATTERN_CONFORMAL;
    const double asked = r->options->tolerance;
    r->cut = (taut_pattern_cut){.seam_length =
                                    is_conformal ? TAUT_PATTERN_TRUE : r->problem->seam_length,
                                .is_conformal = is_conformal,
                                .has_law = m->g > 0,
                                .compensation = compensation_of(r->problem),
                                .thread = r->problem->cloth.thread,
                                .tolerance = asked > 0 && asked < tolerance_default ? asked : 0,
                                .held = r->problem->held,
                                .is_straight = r->problem->ends == TAUT_PATTERN_ENDS_STRAIGHT,
                                .decompensate_count = r->problem->decompensate_count,
                                .decompensate = r->problem->decompensate};
    if (r->cut.has_law) {
        const double d = 1 - m->nu * m->nu * m->e[1] / m->e[0], unit = m->e[0];
        r->cut.law = (taut_flat_law){.d11 = m->e[0] / d / unit,
                                     .d22 = m->e[1] / d / unit,
                                     .d12 = m->nu * m->e[1] / d / unit,
                                     .d33 = m->g / unit};
    }
}

/* ---- pieces ---- */

static const char *unit_of(const request *r)
{
    return r->problem->of != NULL ? r->problem->of->unit : taut_model_unit(r->problem->model);
}

static double gap_of(const request *r)
{
    static const double gap_default = 5; /* mm */
    return r->problem->cloth.has_gap ? r->problem->cloth.gap
                                     : gap_default * taut_unit_ratio("mm", unit_of(r));
}

/* A piece that lies over itself cannot be cut out of one cloth. */
static taut_status check_overlap(const taut_pattern_piece *piece,
                                 const taut_pattern_outline *outline, taut_arena *arena,
                                 taut_error *error)
{
    const int scale = piece->carrier->scale;
    double at[2] = {0, 0};
    int is_crossed = 0;
    if (taut_pattern_overlap(outline, arena, &is_crossed, at) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return is_crossed
               ? taut_fail(error, TAUT_NO_SOLUTION, "overlap", "/seams", taut_none, taut_none,
                           "the flat piece %s lies over itself at (%.6g, %.6g): cut it across",
                           piece->name, ldexp(at[0], scale), ldexp(at[1], scale))
               : TAUT_OK;
}

typedef struct drawing {
    const request *request;
    made_pieces *made;
    taut_arena **arenas; /* of each piece */
    taut_status *status;
} drawing;

static void draw(void *context, int worker, int64_t task)
{
    const drawing *d = context;
    (void)worker;
    d->status[task] = taut_pattern_outline_new(&d->made->layout, &d->request->cut, (int)task,
                                               d->arenas[task], &d->made->outlines[task]);
}

static void release(void *arena)
{
    taut_arena_free(arena);
}

static taut_status draw_all(const request *r, made_pieces *made, taut_error *error)
{
    const size_t count = (size_t)made->layout.piece_count;
    const int workers = taut_crew_workers(r->crew, (int64_t)count);
    drawing d = {r, made, taut_arena_take(made->arena, count, sizeof *d.arenas),
                 taut_arena_take(made->arena, count, sizeof *d.status)};
    taut_status status = taut_arena_status(made->arena);
    for (size_t k = 0; status == TAUT_OK && k < count; k++) {
        d.arenas[k] = taut_arena_new();
        if (d.arenas[k] == NULL || !taut_arena_keep(made->arena, d.arenas[k], release)) {
            status = TAUT_NO_MEMORY;
        }
    }
    if (status == TAUT_OK &&
        taut_crew_run(r->crew, workers, (int64_t)count, work_of_outline, draw, &d)) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    for (size_t k = 0; status == TAUT_OK && k < count; k++) {
        status = d.status[k];
    }
    return status == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

static taut_status make_outlines(const request *r, made_pieces *made, taut_error *error)
{
    const int count = made->layout.piece_count;
    made->outlines = taut_arena_take(made->arena, (size_t)count, sizeof *made->outlines);
    made->margins = taut_arena_take(made->arena, (size_t)count, sizeof *made->margins);
    taut_status status = taut_arena_status(made->arena);
    if (status == TAUT_OK) {
        status = draw_all(r, made, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    made->widest = made->longest = made->strain = 0;
    for (int k = 0; status == TAUT_OK && k < count; k++) {
        taut_pattern_outline *outline = &made->outlines[k];
        if (taut_pulse_report(r->crew->pulse)) {
            return taut_fail_status(error, TAUT_INTERRUPTED);
        }
        made->margins[k] = taut_pattern_margin_of(r->problem, &made->layout, k);
        status = taut_pattern_leave(&made->layout.pieces[k], &made->margins[k],
                                    r->problem->allowance.corner, made->arena, outline, error);
        if (status == TAUT_OK) {
            status = check_overlap(&made->layout.pieces[k], outline, made->arena, error);
        }
        if (status != TAUT_OK) {
            return status;
        }
        if (outline->high[1] - outline->low[1] > made->widest) {
            made->widest = outline->high[1] - outline->low[1];
            made->widest_piece = k;
        }
        if (outline->high[0] - outline->low[0] > made->longest) {
            made->longest = outline->high[0] - outline->low[0];
            made->longest_piece = k;
        }
        const taut_pattern_strains *strains = &made->layout.pieces[k].strains;
        made->strain = fmax(made->strain, fmax(strains->high, -strains->low));
    }
    return status == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

static taut_status check_marks(const request *r, const taut_pattern_layout *layout,
                               taut_error *error)
{
    const double spacing = ldexp(r->problem->marks.spacing, -layout->carrier->scale);
    for (int k = 0; spacing > 0 && k < layout->side_count; k++) {
        if (layout->sides[k].length > spacing * MARKS_MOST) {
            return taut_fail(error, TAUT_BAD_INPUT, "allowance", "/marks/spacing",
                             r->problem->marks.spacing, taut_none,
                             "found %.6g, which makes more than %d marks along a seam",
                             r->problem->marks.spacing, MARKS_MOST);
        }
    }
    return TAUT_OK;
}

/* How far the lines to sew are from the edges of a flat piece. */
static double drift_of(const taut_pattern_piece *piece, const taut_pattern_outline *outline,
                       int places)
{
    double most = 0;
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        for (int k = 0; outline->edges[e] != piece->edges[e] && k <= places; k++) {
            double exact[3], weak[3];
            taut_curve_eval(outline->edges[e], (double)k / places, 0, exact);
            taut_curve_eval(piece->edges[e], (double)k / places, 0, weak);
            most = fmax(most, taut_length_between(exact, weak));
        }
    }
    return most;
}

/* As the certificate has it: of several surfaces that of the largest one, not of all together. */
static double size_of(const taut_pattern_layout *layout)
{
    double half = 0;
    for (int g = 0; g < layout->ground_count; g++) {
        const taut_carrier *carrier = layout->grounds[g].carrier;
        const size_t count = taut_point_count(carrier->surface);
        const double own = taut_half_size(count, taut_surface_points(carrier->surface));
        half = fmax(half, ldexp(own, 1 - carrier->scale));
    }
    return half;
}

/* Of a flat piece: its edges, its axis, and its width in the middle. */
static void lengths_of(const taut_flat *flat, double lengths[TAUT_FLAT_EDGES + 2])
{
    static const double ends[2][4] = {{0, 0.5, 1, 0.5}, {0.5, 0, 0.5, 1}};
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        lengths[e] = taut_flat_edge_length(flat, NULL, (taut_flat_edge)e, NULL);
    }
    for (int k = 0; k < 2; k++) {
        double from[3][2], to[3][2];
        taut_flat_at(flat, ends[k][0], ends[k][1], from);
        taut_flat_at(flat, ends[k][2], ends[k][3], to);
        lengths[TAUT_FLAT_EDGES + k] = taut_hypot(to[0][0] - from[0][0], to[0][1] - from[0][1]);
    }
}

/* By how much lengths of a piece differ from those on half the spans, where they are to settle: at first all of them. */
static void settle(taut_pattern_piece *piece)
{
    double lengths[TAUT_FLAT_EDGES + 2];
    if (!piece->is_graded || (piece->is_developable && piece->flat.steps == 0) ||
        piece->measured == piece->flat.spans[0]) {
        return;
    }
    lengths_of(&piece->flat, lengths);
    piece->measured = piece->flat.spans[0];
    piece->unsettled = 0;
    for (int k = 0; k < TAUT_FLAT_EDGES + 2; k++) {
        piece->unsettled = fmax(piece->unsettled, fabs(lengths[k] - piece->lengths[k]));
    }
    memcpy(piece->lengths, lengths, sizeof lengths);
}

/* Finer splines where the edges of these are not what is sewn, or, at first, end elsewhere; whether there are any. The last ones only
 * where claims would not hold. Not between straight ends, whose corners finer ones do not settle. */
static int refine(const request *r, made_pieces *made, int round)
{
    const double size = size_of(&made->layout);
    const double most = (round < REFINEMENTS - 1 ? drift_most : drift_claimed / 2) * size;
    int any = 0;
    for (int k = 0; k < made->layout.piece_count; k++) {
        taut_pattern_piece *piece = &made->layout.pieces[k];
        const taut_pattern_outline *outline = &made->outlines[k];
        if (round == REFINEMENTS - 1 && piece->flat.steps > TOO_MANY) {
            continue; /* the cloth gives way on each of them elsewhere */
        }
        if ((round < REFINEMENTS - 1 && piece->unsettled > r->cut.tolerance * size) ||
            drift_of(piece, outline, DRIFT_PLACES) > most ||
            (round == 0 && outline->closure > closure_most * size) ||
            (outline->longer > longer_most &&
             (round == 0 || (round == 1 && outline->longer < HOPED * longer_most)))) {
            piece->spans[0] *= 2;
            piece->spans[1] *= 2;
            any = 1;
        }
    }
    return any;
}

static taut_status fail_drift(const taut_pattern_piece *piece, double closure, double drift,
                              taut_error *error)
{
    const int is_open = closure > closure_claimed;
    return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", "/seams",
                     is_open ? closure : drift, is_open ? closure_claimed : drift_claimed,
                     "the lines to sew of piece %s end %.2g of the size from its corners and are "
                     "%.2g of it off its edges, expected %.2g and %.2g at most: lengths that are "
                     "held are too far from what the cloth does near its corners; take more "
                     "strips, compensate both alike, or hold fewer edges",
                     piece->name, closure, drift, closure_claimed, drift_claimed);
}

/* No piece of which finer splines are no better: the cloth gives way elsewhere on each of them. */
static taut_status check_settling(made_pieces *made, int round, taut_error *error)
{
    const double size = size_of(&made->layout);
    for (int k = 0; k < made->layout.piece_count; k++) {
        taut_pattern_piece *piece = &made->layout.pieces[k];
        const double drift = drift_of(piece, &made->outlines[k], DRIFT_PLACES) / size;
        if (round > 0 && drift > far_off * drift_claimed && drift > hardly * piece->drift) {
            return fail_drift(piece, made->outlines[k].closure / size, drift, error);
        }
        piece->drift = drift;
        settle(piece);
    }
    return TAUT_OK;
}

/* The finest splines have edges that are what is sewn, or what is held near their corners is too far from what the cloth beside them
 * does: strain is singular there. */
static taut_status check_drift(const made_pieces *made, taut_error *error)
{
    const double size = size_of(&made->layout);
    for (int k = 0; k < made->layout.piece_count; k++) {
        const taut_pattern_piece *piece = &made->layout.pieces[k];
        double drift = drift_of(piece, &made->outlines[k], DRIFT_PLACES) / size;
        if (drift > drift_most) { /* by all places that are looked at then */
            drift = drift_of(piece, &made->outlines[k], CLAIMED_PLACES) / size;
        }
        if (made->outlines[k].closure / size > closure_claimed || drift > drift_claimed) {
            return fail_drift(piece, made->outlines[k].closure / size, drift, error);
        }
    }
    return TAUT_OK;
}

/* The finest splines have the lengths that are asked for. */
static taut_status check_lengths(const request *r, const made_pieces *made, taut_error *error)
{
    const double size = size_of(&made->layout);
    for (int k = 0; k < made->layout.piece_count; k++) {
        const taut_pattern_piece *piece = &made->layout.pieces[k];
        if (piece->unsettled > r->cut.tolerance * size) {
            return taut_fail(
                error, TAUT_NOT_CONVERGED, "not-converged", "/seams", piece->unsettled / size,
                r->cut.tolerance,
                "lengths of piece %s differ by %.2g of the size between the two finest "
                "splines, expected %.2g at most: take a larger tolerance",
                piece->name, piece->unsettled / size, r->cut.tolerance);
        }
    }
    return TAUT_OK;
}

/* Between the places of quadrature, where W sees it, the last splines may still fold. */
static taut_status check_folds(const made_pieces *made, taut_error *error)
{
    for (int k = 0; k < made->layout.piece_count; k++) {
        const taut_pattern_piece *piece = &made->layout.pieces[k];
        if (piece->strains.is_folded) {
            return taut_fail(error, TAUT_NOT_CONVERGED, "folds", "/seams", taut_none, taut_none,
                             "flat piece %s folds at (s, t) = (%.4g, %.4g): take more strips, or "
                             "run them between the other edges",
                             piece->name, piece->strains.fold[0], piece->strains.fold[1]);
        }
    }
    return TAUT_OK;
}

/* What no principal strain is to be above, as the certificate has it; 0: nothing. */
static double asked_strain(const taut_pattern_problem *problem)
{
    double strain = problem->strain;
    for (int k = 0; !(problem->strain > 0) && k < problem->rule_count; k++) {
        strain = fmax(strain, problem->rules[k].strain);
    }
    return strain;
}

/* The piece that needs the most strain, to first order: |K| times the square of the width. */
static int most_curved(const taut_pattern_layout *layout)
{
    enum { PLACES = 5 };
    double most = 0;
    int piece = 0;
    for (int k = 0; k < layout->piece_count; k++) {
        for (int i = 1; i < PLACES; i++) {
            double g[3], bend[2], gauss;
            taut_pattern_piece_metric(&layout->pieces[k], (double)i / PLACES, 0.5, g);
            taut_pattern_piece_bends(&layout->pieces[k], (double)i / PLACES, 0.5, bend, &gauss);
            if (fabs(gauss) * g[2] > most) {
                most = fabs(gauss) * g[2];
                piece = k;
            }
        }
    }
    return piece;
}

/* Is it proved, before anything is laid flat, that strains are above what is asked for? The theorem is of one compensation everywhere. */
static void rule_out(const request *r, made_pieces *made)
{
    const double asked = asked_strain(r->problem);
    made->ruled_out = 0;
    if (asked > 0 && r->problem->decompensate_count == 0) {
        const int piece = most_curved(&made->layout);
        const taut_chart chart = taut_pattern_piece_chart(&made->layout.pieces[piece]);
        const double least = taut_chart_least_strain(&chart, r->crew->pulse).strain;
        made->ruled_out = least > asked ? least : 0;
        made->ruled_out_piece = piece;
    }
}

/* All of strips that are cut across as told. */
static taut_status make_parts(const request *r, const taut_pattern_ground *own, int ground_count,
                              const taut_pattern_counts *counts, made_pieces *made,
                              taut_error *error)
{
    taut_status status =
        taut_pattern_lay_out(own, ground_count, r->problem, counts, &made->layout, error);
    if (status == TAUT_OK) {
        status = check_marks(r, &made->layout, error);
    }
    if (status == TAUT_OK) {
        rule_out(r, made);
        if (taut_pulse_is_stopped(r->crew->pulse)) {
            return taut_fail_status(error, TAUT_INTERRUPTED);
        }
        if (made->ruled_out > 0) {
            return TAUT_OK;
        }
    }
    for (int round = 0, is_rough = 1; status == TAUT_OK && is_rough; round++) {
        status = taut_pattern_flatten(&made->layout, &r->cut, r->crew, error);
        if (status == TAUT_OK) {
            status = make_outlines(r, made, error);
        }
        if (status == TAUT_OK) {
            status = check_settling(made, round, error);
        }
        is_rough = status == TAUT_OK && round < (r->cut.is_straight ? 0 : REFINEMENTS) &&
                   refine(r, made, round);
    }
    if (status == TAUT_OK) {
        status = check_folds(made, error);
    }
    if (status == TAUT_OK && !r->cut.is_straight) {
        status = check_lengths(r, made, error);
    }
    return status == TAUT_OK ? check_drift(made, error) : status;
}

/* More parts of strips whose parts are longer than the cloth, and shorter than before; whether there are any. As parts add up to
 * the strip, and what is left at butts comes on top, n parts that are too long by a factor f are n f at least. */
static int cut_longer(const made_pieces *made, double most, double *lengths, int *parts)
{
    double longest[TAUT_PATTERN_PIECES_MAX] = {0};
    int any = 0;
    for (int k = 0; k < made->layout.piece_count; k++) {
        const taut_pattern_outline *outline = &made->outlines[k];
        double *own = &longest[made->layout.pieces[k].strip];
        *own = fmax(*own, outline->high[0] - outline->low[0]);
    }
    for (int k = 0; k < TAUT_PATTERN_PIECES_MAX; k++) {
        if (longest[k] > most && longest[k] < lengths[k]) {
            lengths[k] = longest[k];
            parts[k] = (int)fmin(fmax(parts[k] + 1, ceil(parts[k] * longest[k] / most)),
                                 TAUT_PATTERN_PIECES_MAX);
            any = 1;
        }
    }
    return any;
}

/* All of so many strips. */
static taut_status make_strips(const request *r, const cut_surfaces *all, int count,
                               taut_arena *arena, made_pieces *made, taut_error *error)
{
    taut_pattern_ground *own =
        taut_arena_copy(arena, all->grounds, (size_t)all->count, sizeof *all->grounds);
    int parts[TAUT_PATTERN_PIECES_MAX];
    double lengths[TAUT_PATTERN_PIECES_MAX];
    const taut_pattern_counts counts = {count, parts};
    const double most = ldexp(r->problem->cloth.length, -all->grounds->carrier->scale);
    const int is_cut = is_equal_butts(&r->problem->rules[r->problem->rule_count - 1]);

    made->arena = arena;
    if (own == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < all->count; k++) {
        own[k].arena = arena;
    }
    for (int k = 0; k < TAUT_PATTERN_PIECES_MAX; k++) {
        parts[k] = 1;
        lengths[k] = INFINITY;
    }
    taut_status status = make_parts(r, own, all->count, &counts, made, error);
    while (is_cut && status == TAUT_OK && made->ruled_out == 0 &&
           cut_longer(made, most, lengths, parts)) {
        status = make_parts(r, own, all->count, &counts, made, error);
    }
    return status;
}

static taut_status check_length(const request *r, const made_pieces *made, int scale,
                                taut_error *error)
{
    const double most = r->problem->cloth.length, found = ldexp(made->longest, scale);
    return !(most > 0) || found <= most
               ? TAUT_OK
               : taut_fail(error, TAUT_NO_SOLUTION, "length", "/cloth/length", found, most,
                           "piece %s is %.6g long, and the cloth %.6g: cut it across by butts, in "
                           "%.0f parts",
                           made->layout.pieces[made->longest_piece].name, found, most,
                           ceil(found / most));
}

/* What pieces are to keep within; 0: nothing of this sort. */
typedef struct wish {
    double width, strain; /* in the carrier's unit */
    const char *surface;  /* those of this one; NULL: all */
} wish;

/* Does a rule cut this surface? name: NULL where there is one surface alone. */
static int is_of(const char *surface, const taut_pattern_ground *ground)
{
    return surface == NULL || ground->name == NULL || strcmp(surface, ground->name) == 0;
}

static double widest_of(const made_pieces *made, const char *surface)
{
    double widest = 0;
    for (int k = 0; k < made->layout.piece_count; k++) {
        const taut_pattern_ground *ground = &made->layout.grounds[made->layout.pieces[k].ground];
        const taut_pattern_outline *outline = &made->outlines[k];
        if (is_of(surface, ground)) {
            widest = fmax(widest, outline->high[1] - outline->low[1]);
        }
    }
    return widest;
}

/* By how many times too few strips there are, as widths fall with their number and strains with its square; 1 or less: enough. */
static double shortage(const request *r, const made_pieces *made, const wish *w)
{
    if (made->ruled_out > 0) {
        return sqrt(made->ruled_out / asked_strain(r->problem));
    }
    const double wide = w->width > 0 ? widest_of(made, w->surface) / w->width : 0;
    const double strained = w->strain > 0 ? made->strain / (strain_room * w->strain) : 0;
    return fmax(wide, strained > 1 ? sqrt(strained) : strained);
}

static taut_status fail_wish(const taut_carrier *carrier, const wish *w, taut_error *error)
{
    const double width = ldexp(w->width, carrier->scale);
    return w->strain > 0
               ? taut_fail(error, TAUT_NO_SOLUTION, "strain", "/seams/0/strain", w->strain,
                           taut_none, "no number of strips up to %d is strained by at most %.6g%s",
                           TAUT_PATTERN_PIECES_MAX, w->strain,
                           w->width > 0 ? " and fits the roll" : "")
               : taut_fail(error, TAUT_NO_SOLUTION, "width", "/seams/0", width, taut_none,
                           "no number of strips up to %d has pieces that are at most %.6g wide",
                           TAUT_PATTERN_PIECES_MAX, width);
}

/* The least number of strips, `first` or more, that are all as wished, up from one that is too few, or nearly; in an arena of its own. */
static taut_status fit(const request *r, const cut_surfaces *all, const wish *w, int first,
                       made_pieces *made, int *found, taut_error *error)
{
    int count = first, last = first - 1;
    taut_arena *kept = NULL;

    while (count <= TAUT_PATTERN_PIECES_MAX) {
        taut_arena *own = taut_arena_new();
        made_pieces one = {.arena = own};
        taut_status status =
            own != NULL ? make_strips(r, all, count, own, &one, error) : taut_fail_memory(error);
        if (status != TAUT_OK &&
            (status == TAUT_NO_MEMORY || status == TAUT_INTERRUPTED || count > 8)) {
            taut_arena_free(own);
            taut_arena_free(kept);
            return status;
        }
        const double missing = status == TAUT_OK ? shortage(r, &one, w) : INFINITY;
        if (missing <= 1) {
            taut_arena_free(kept);
            kept = own;
            *made = one;
            *found = count;
            if (count == last + 1) { /* one less did not fit */
                break;
            }
            count--;
            continue;
        }
        taut_arena_free(own);
        if (kept != NULL) {
            break;
        }
        last = count;
        /* what is missing, seen from here, but for one strip in ten */
        const double need = status == TAUT_OK ? 0.9 * count * missing : count + 1.0;
        count = need > count + 1 ? (int)fmin(need, TAUT_PATTERN_PIECES_MAX + 1.0) : count + 1;
    }
    if (kept == NULL) {
        return fail_wish(all->grounds->carrier, w, error);
    }
    made->arena = kept;
    return TAUT_OK;
}

/* The rule that alone makes strips of a surface, in the last place that is looked at; how many do. */
static int rules_of(const taut_pattern_problem *problem, const taut_pattern_ground *ground,
                    int *only)
{
    int count = 0;
    for (int k = 0; k < problem->rule_count; k++) {
        const taut_pattern_rule *rule = &problem->rules[k];
        if ((rule->kind == TAUT_PATTERN_ACROSS || rule->kind == TAUT_PATTERN_RADIAL) &&
            is_of(rule->surface, ground)) {
            count++;
            *only = k;
        }
    }
    return count;
}

/* With how many strips of a rule, more than it makes, it is not proved that strains are above what is asked for; 0: with none that can be
 * laid out. */
static taut_status count_not_ruled_out(const request *r, const cut_surfaces *all, int rule,
                                       double ruled_out, int *found, taut_error *error)
{
    taut_pattern_problem other = *r->problem;
    taut_pattern_rule *rules =
        taut_arena_copy(all->grounds->arena, other.rules, (size_t)other.rule_count, sizeof *rules);
    const double share = sqrt(ruled_out / asked_strain(r->problem));
    request more = *r;
    int parts[TAUT_PATTERN_PIECES_MAX];
    taut_status status = rules != NULL ? TAUT_OK : taut_fail_memory(error);

    for (int k = 0; k < TAUT_PATTERN_PIECES_MAX; k++) {
        parts[k] = 1;
    }
    if (rules == NULL) {
        return status;
    }
    const int count = rules[rule].count;
    other.rules = rules;
    more.problem = &other;
    /* strains fall with the square, or hardly faster */
    int next = (int)fmax(count + 1.0, 0.9 * count * share);
    for (*found = 0; *found == 0 && next <= TAUT_PATTERN_PIECES_MAX; next++) {
        const taut_pattern_counts counts = {next, parts};
        made_pieces one = {.arena = taut_arena_new()};
        taut_pattern_ground *own =
            taut_arena_copy(one.arena, all->grounds, (size_t)all->count, sizeof *all->grounds);
        rules[rule].count = next;
        for (int k = 0; own != NULL && k < all->count; k++) {
            own[k].arena = one.arena;
        }
        status = own != NULL
                     ? taut_pattern_lay_out(own, all->count, &other, &counts, &one.layout, error)
                     : taut_fail_memory(error);
        if (status == TAUT_OK) {
            rule_out(&more, &one);
            *found = one.ruled_out > 0 ? 0 : next;
        }
        taut_arena_free(one.arena);
        if (taut_pulse_is_stopped(r->crew->pulse)) {
            return taut_fail_status(error, TAUT_INTERRUPTED);
        }
        if (status != TAUT_OK) {
            return status;
        }
    }
    return TAUT_OK;
}

/* No pattern of so many strips is strained by as little as is asked for. */
static taut_status fail_ruled_out(const request *r, const cut_surfaces *all,
                                  const made_pieces *made, taut_error *error)
{
    const taut_pattern_piece *piece = &made->layout.pieces[made->ruled_out_piece];
    const taut_pattern_ground *ground = &made->layout.grounds[piece->ground];
    char remedy[96] = "run seams nearer to each other";
    int only = 0, found = 0;
    const int told = rules_of(r->problem, ground, &only);

    if (told == 1) {
        taut_error none = {.message = ""};
        const taut_status status =
            count_not_ruled_out(r, all, only, made->ruled_out, &found, &none);
        if (status == TAUT_INTERRUPTED || status == TAUT_NO_MEMORY) {
            return taut_fail_status(error, status);
        }
    }
    if (found > 0) {
        snprintf(remedy, sizeof remedy, "take at least %d strips, and rather more", found);
    } else if (told > 0) {
        snprintf(remedy, sizeof remedy, "take more strips");
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "strain", "/strain", made->ruled_out,
                     asked_strain(r->problem),
                     "no flat piece %s is strained by less than %.6g, by its curvature alone, and "
                     "%.6g is asked for: %s",
                     piece->name, made->ruled_out, asked_strain(r->problem), remedy);
}

/* A piece is wider than the roll: where one rule makes so many strips of its surface, with how many they would fit. */
static taut_status fail_width(const request *r, const cut_surfaces *all, const made_pieces *made,
                              taut_error *error)
{
    const taut_pattern_problem *problem = r->problem;
    const int scale = all->grounds->carrier->scale;
    const double roll = problem->cloth.width, extent = ldexp(made->widest, scale);
    taut_pattern_rule *rules =
        taut_arena_copy(made->arena, problem->rules, (size_t)problem->rule_count, sizeof *rules);
    const taut_pattern_ground *ground =
        &made->layout.grounds[made->layout.pieces[made->widest_piece].ground];
    char remedy[96] = "run seams nearer to each other", where[32];
    int only = 0, found = 0;
    const int told = rules_of(problem, ground, &only);

    if (rules == NULL) {
        return taut_fail_memory(error);
    }
    if (told == 1) {
        const int count = rules[only].count;
        taut_pattern_problem other = *problem;
        request more = *r;
        made_pieces fitting = {.arena = NULL};
        taut_error none = {.message = ""};
        const wish w = {ldexp(roll, -scale), 0, rules[only].surface};
        rules[only].count = 0;
        other.rules = rules;
        more.problem = &other;
        const taut_status status = fit(&more, all, &w, count + 1, &fitting, &found, &none);
        if (status == TAUT_OK) {
            taut_arena_free(fitting.arena);
        } else if (status == TAUT_INTERRUPTED || status == TAUT_NO_MEMORY) {
            return taut_fail_status(error, status);
        }
        snprintf(remedy, sizeof remedy,
                 found == 0                    ? "no count that was tried fits"
                 : rules[only].surface == NULL ? "with a count of %d all fit"
                                               : "with a count of %d all of this surface fit",
                 found);
    } else if (told > 1) {
        snprintf(remedy, sizeof remedy, "take more strips");
    }
    snprintf(where, sizeof where, "/seams/%d", only);
    return taut_fail(error, TAUT_NO_SOLUTION, "width", where, extent, roll,
                     "piece %s is %.6g wide, and the roll %.6g: %s",
                     made->layout.pieces[made->widest_piece].name, extent, roll, remedy);
}

static taut_status cut_pieces(const request *r, const cut_surfaces *all, made_pieces *made,
                              taut_error *error)
{
    const taut_pattern_rule *searched = NULL;
    const double roll = r->problem->cloth.width;
    const int scale = all->grounds->carrier->scale;

    for (int k = 0; k < r->problem->rule_count; k++) {
        searched = is_searched(&r->problem->rules[k]) ? &r->problem->rules[k] : searched;
    }
    if (searched != NULL) {
        const wish w = {ldexp(searched->width > 0 ? searched->width : roll, -scale),
                        searched->strain, NULL};
        int found = 0;
        return fit(r, all, &w, 1, made, &found, error);
    }
    const taut_status status = make_strips(r, all, 0, all->grounds->arena, made, error);
    if (status == TAUT_OK && made->ruled_out > 0) {
        return fail_ruled_out(r, all, made, error);
    }
    return status == TAUT_OK && roll > 0 && made->widest > ldexp(roll, -scale)
               ? fail_width(r, all, made, error)
               : status;
}

/* ---- the model ---- */

static taut_status add_flat(const taut_pattern_piece *piece, taut_model *model, taut_arena *arena,
                            taut_error *error)
{
    const taut_flat *flat = &piece->flat;
    const size_t count = (size_t)flat->count[0] * (size_t)flat->count[1];
    double *points = taut_arena_take(arena, count, 3 * sizeof(double));
    taut_basis_spec specs[2];

    if (points == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t k = 0; k < count; k++) {
        points[3 * k] = ldexp(flat->points[2 * k], piece->carrier->scale);
        points[3 * k + 1] = ldexp(flat->points[2 * k + 1], piece->carrier->scale);
    }
    for (int d = 0; d < 2; d++) {
        specs[d] = (taut_basis_spec){.type = "bspline",
                                     .degree = TAUT_FLAT_DEGREE,
                                     .knot_count = flat->count[d] + TAUT_FLAT_DEGREE + 1,
                                     .knots = flat->knots[d]};
    }
    return taut_construct_add_net(model, piece->name, specs, flat->count, points, NULL, NULL,
                                  error);
}

/* A curve of the outline in the surface's own unit. */
static taut_status add_line(const taut_pattern_piece *piece, const char *what,
                            const taut_curve *line, taut_model *model, taut_arena *arena,
                            taut_error *error)
{
    const size_t count = 3 * (size_t)taut_basis_count(taut_curve_t(line));
    double *points = taut_arena_take(arena, count, sizeof(double));
    char name[TAUT_SIDE_NAME + 8];
    taut_curve *curve = NULL;

    if (points == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t k = 0; k < count; k++) {
        points[k] = ldexp(taut_curve_points(line)[k], piece->carrier->scale);
    }
    snprintf(name, sizeof name, "%s.%s", piece->name, what);
    const taut_status status =
        taut_curve_new(name, taut_curve_t(line), points, NULL, &curve, error);
    return status == TAUT_OK ? taut_construct_add_curve(model, curve, error) : status;
}

static taut_status add_piece(const made_pieces *made, int index, taut_model *model,
                             taut_arena *arena, taut_error *error)
{
    static const char *const names[TAUT_FLAT_EDGES] = {"right", "end", "left", "start"};
    const taut_pattern_piece *piece = &made->layout.pieces[index];
    const taut_pattern_outline *outline = &made->outlines[index];
    taut_status status = TAUT_OK;

    for (int e = 0; status == TAUT_OK && e < TAUT_FLAT_EDGES; e++) {
        status = add_line(piece, names[e], outline->edges[e], model, arena, error);
    }
    return status == TAUT_OK ? add_line(piece, "cut", outline->cut, model, arena, error) : status;
}

static taut_status add_seam(const taut_pattern_side *side, taut_model *model, taut_error *error)
{
    taut_curve *curve = NULL;
    const taut_status status =
        taut_curve_new(side->seam, side->part.basis, side->part.space, NULL, &curve, error);
    return status == TAUT_OK ? taut_construct_add_curve(model, curve, error) : status;
}

static taut_status add_all(const made_pieces *made, taut_model *model, taut_arena *arena,
                           taut_error *error)
{
    const taut_pattern_layout *layout = &made->layout;
    taut_status status = TAUT_OK;

    for (int k = 0; status == TAUT_OK && k < layout->ground_count; k++) {
        taut_surface *surface = NULL;
        status = taut_surface_copy(layout->grounds[k].carrier->surface, &surface);
        status = status == TAUT_OK ? taut_construct_add_surface(model, surface, error)
                                   : taut_fail_memory(error);
    }
    for (int k = 0; status == TAUT_OK && k < layout->piece_count; k++) {
        status = add_flat(&layout->pieces[k], model, arena, error);
    }
    for (int k = 0; status == TAUT_OK && k < layout->side_count; k++) {
        const taut_pattern_side *side = &layout->sides[k];
        status = side->is_seam && side->twin < k ? add_seam(side, model, error) : TAUT_OK;
    }
    for (int k = 0; status == TAUT_OK && k < layout->piece_count; k++) {
        status = add_piece(made, k, model, arena, error);
    }
    return status;
}

static taut_status place_on_roll(const request *r, const made_pieces *made, taut_arena *arena,
                                 taut_pattern_roll *roll, taut_error *error)
{
    const taut_pattern_layout *layout = &made->layout;
    const int scale = layout->carrier->scale;
    return taut_pattern_roll_new(layout->piece_count, made->outlines,
                                 ldexp(r->problem->cloth.width, -scale), ldexp(gap_of(r), -scale),
                                 r->problem->cloth.has_nap, arena, roll) == TAUT_OK
               ? TAUT_OK
               : taut_fail_memory(error);
}

static taut_status fill(const request *r, const taut_model *of, const made_pieces *made,
                        taut_arena *arena, taut_model *model, taut_error *error)
{
    taut_pattern_roll roll;
    double bias = (double)NAN;
    taut_status status = taut_pattern_bias(&made->layout, &r->cut, r->crew, &bias, error);

    if (status == TAUT_OK) {
        status = add_all(made, model, arena, error);
    }

    if (status == TAUT_OK) {
        status = place_on_roll(r, made, arena, &roll, error);
    }
    if (status == TAUT_OK && taut_pulse_report(r->crew->pulse)) {
        status = taut_fail_status(error, TAUT_INTERRUPTED);
    }
    if (status != TAUT_OK) {
        return status;
    }
    taut_record *details = taut_record_new();
    if (details == NULL) {
        return taut_fail_memory(error);
    }
    const taut_pattern_told told = {&made->layout, &r->cut, r->problem, made->outlines,
                                    made->margins, &roll,   gap_of(r),  bias};
    taut_pattern_describe(&told, details);
    if (r->problem->of != NULL) {
        taut_construct_describe_of(r->problem->of, of, details);
    }
    return taut_construct_set_details(model, details, error);
}

static taut_status check_carrier(const taut_carrier *carrier, taut_error *error)
{
    if (!(carrier->scale > -EXPONENT_MOST) || !(carrier->scale < EXPONENT_MOST)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "extreme-size", "/of", ldexp(0.5, carrier->scale),
                         ldexp(1, EXPONENT_MOST),
                         "the surface is %.3g large, and lengths along it cannot be parameters",
                         ldexp(carrier->size, carrier->scale));
    }
    return carrier->widest > 0 ? TAUT_OK
                               : taut_fail(error, TAUT_NO_SOLUTION, "singular", "/of", taut_none,
                                           taut_none, "the surface has no normal anywhere");
}

/* Edges that two surfaces share are one line in space. */
static taut_status find_mates(const cut_surfaces *all, taut_error *error)
{
    for (int i = 0; i < 4 * all->count; i++) {
        for (int k = 4 * (i / 4 + 1); k < 4 * all->count; k++) {
            taut_pattern_ground *a = &all->grounds[i / 4], *b = &all->grounds[k / 4];
            taut_join join;
            if (a->mates[i % 4].is_there || b->mates[k % 4].is_there || a->is_ring[i % 4 / 2] ||
                b->is_ring[k % 4 / 2] ||
                taut_seam_ends_meet(a->carrier, i % 4, b->carrier, k % 4, same_corner) == 0) {
                continue;
            }
            const taut_status status =
                taut_join_measure(a->carrier->surface, (taut_edge)(i % 4), b->carrier->surface,
                                  (taut_edge)(k % 4), &join, error);
            if (status != TAUT_OK) {
                return status;
            }
            if (join.c_order >= 0) {
                a->mates[i % 4] = (taut_pattern_mate){1, k / 4, k % 4, join.reversed};
                b->mates[k % 4] = (taut_pattern_mate){1, i / 4, i % 4, join.reversed};
            }
        }
    }
    return TAUT_OK;
}

/* The surface that is named, or all of the model. */
static taut_status choose(const request *r, const taut_model *of, taut_arena *arena,
                          cut_surfaces *all, taut_error *error)
{
    const int is_all = r->problem->surface == NULL && taut_model_surface_count(of) > 1;
    const size_t count = is_all ? (size_t)taut_model_surface_count(of) : 1;
    const taut_surface **surfaces = taut_arena_take(arena, count, sizeof *surfaces);
    taut_carrier **carriers = NULL;

    all->count = (int)count;
    all->grounds = taut_arena_take(arena, count, sizeof *all->grounds);
    if (surfaces == NULL || all->grounds == NULL) {
        return taut_fail_memory(error);
    }
    if (!is_all) {
        const taut_status status =
            taut_construct_choose(of, r->problem->surface, &surfaces[0], error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    for (int k = 0; is_all && k < all->count; k++) {
        surfaces[k] = taut_model_surface(of, k);
    }
    if (taut_carriers_new(arena, all->count, surfaces, &carriers) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < all->count; k++) {
        taut_pattern_ground *ground = &all->grounds[k];
        const taut_status status = check_carrier(carriers[k], error);
        if (status != TAUT_OK) {
            return status;
        }
        *ground = (taut_pattern_ground){.carrier = carriers[k],
                                        .name = is_all ? taut_surface_name(surfaces[k]) : NULL,
                                        .model = of,
                                        .monitor = &r->options->monitor,
                                        .arena = arena};
        memcpy(ground->is_ring, carriers[k]->wraps, sizeof ground->is_ring);
        for (int e = 0; e < 4; e++) { /* pieces do not go on across it */
            ground->is_pole[e] = taut_pattern_is_place(carriers[k], e);
            carriers[k]->wraps[e / 2] = 0;
            carriers[k]->seams[e] = NULL;
        }
    }
    return find_mates(all, error);
}

/* A length that fades out along a seam between two surfaces would be another one on each. */
static taut_status check_fades(const request *r, const cut_surfaces *all, taut_error *error)
{
    const taut_pattern_problem *p = r->problem;
    const int is_held = p->seam_length == TAUT_PATTERN_TRUE || p->compensation.has_seam;
    return p->decompensate_count > 0 && is_held && all->count > 1
               ? taut_fail(error, TAUT_BAD_INPUT, "conflict", "/decompensate", all->count, 1,
                           "found it beside seams of %s on %d surfaces, expected it on one, or one "
                           "of them",
                           p->compensation.has_seam ? "a compensation of their own"
                                                    : "the surface's length",
                           all->count)
               : TAUT_OK;
}

/* Rules for one surface name one that there is. */
static taut_status check_named(const request *r, const cut_surfaces *all, taut_error *error)
{
    for (int i = 0; i < r->problem->rule_count; i++) {
        const char *name = r->problem->rules[i].surface;
        int is_there = name == NULL;
        for (int k = 0; !is_there && k < all->count; k++) {
            is_there = strcmp(taut_surface_name(all->grounds[k].carrier->surface), name) == 0;
        }
        if (!is_there) {
            char where[48];
            snprintf(where, sizeof where, "/seams/%d/surface", i);
            return taut_fail(error, TAUT_BAD_INPUT, "rule", where, taut_none, taut_none,
                             "found \"%.60s\", expected the name of a surface that is cut", name);
        }
    }
    return TAUT_OK;
}

static taut_status build(void *context, taut_arena *arena, taut_model *model, taut_error *error)
{
    const request *r = context;
    const taut_model *of = NULL;
    cut_surfaces all = {0, NULL};
    made_pieces made = {.arena = arena};
    taut_status status =
        taut_construct_of(r->problem->model, r->problem->of, r->options, arena, &of, error);

    if (status == TAUT_OK) {
        status = choose(r, of, arena, &all, error);
    }
    if (status == TAUT_OK) {
        status = check_named(r, &all, error);
    }
    if (status == TAUT_OK) {
        status = check_fades(r, &all, error);
    }
    if (status == TAUT_OK) {
        status = cut_pieces(r, &all, &made, error);
    }
    if (status == TAUT_OK) {
        status = taut_pattern_check_seams(&r->problem->allowance, &made.layout, error);
    }
    if (status == TAUT_OK) {
        status = check_length(r, &made, all.grounds->carrier->scale, error);
    }
    if (status == TAUT_OK) {
        status = fill(r, of, &made, arena, model, error);
    }
    if (made.arena != arena) {
        taut_arena_free(made.arena);
    }
    return status;
}

taut_status taut_pattern_make(const taut_pattern_problem *problem, const taut_make_options *options,
                              taut_model **model, taut_error *error)
{
    static const taut_make_options none;
    request r = {.problem = problem, .options = options != NULL ? options : &none};
    taut_pulse pulse = {.monitor = &r.options->monitor, .what = "pieces", .done = taut_none};
    const taut_crew crew = {.threads = r.options->threads, .pulse = &pulse};
    const taut_status status = check_problem(problem, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_pattern_make needs a place for the model");
    }
    r.crew = &crew;
    take_cut(&r);
    return taut_construct_build(build, &r, model, error);
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_pattern_make(data, options, model, error);
}

const taut_construct_ops taut_construct_pattern = {.make = make};
