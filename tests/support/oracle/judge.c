/* judge.c -- which judge is for which claim, what is clearly above a limit, and what must not be
 * believed when every claim holds.
 *
 * Clearly above: by a thousandth where the limit is a tolerance, four times where it is rounding
 * noise (below 1e-9; limits are what rounding leaves at the places that the certificate looks at,
 * not at all of them).
 */
#include "oracle/oracle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef double (*judge_fn)(const oracle_case *about);

typedef struct oracle_judge_row {
    const char *construct, *claim;
    judge_fn find;
    int above; /* it holds where its value is above the limit */
} oracle_judge_row;

static const oracle_judge_row judges[] = {
    {"dirichlet", "stationary", oracle_stationary, 0},
    {"dirichlet", "known", oracle_known, 0},
    {"dirichlet", "regular", oracle_smallest_sine, 1},
    {"plateau", "stationary", oracle_stationary, 0},
    {"plateau", "known", oracle_known, 0},
    {"plateau", "regular", oracle_smallest_sine, 1},
    {"harmonic", "harmonic", oracle_laplace, 0},
    {"harmonic", "boundary", oracle_rows, 0},
    {"harmonic-extension", "harmonic", oracle_laplace, 0},
    {"harmonic-extension", "boundary", oracle_rows, 0},
    {"harmonic-extension", "continuity", oracle_contact, 0},
    {"biharmonic", "biharmonic", oracle_bilaplace, 0},
    {"biharmonic", "boundary", oracle_rows, 0},
    {"biharmonic", "continuity", oracle_contact, 0},
    {"asymptotic", "boundary", oracle_edges, 0},
    {"asymptotic", "asymptotic", oracle_normal_curvature, 0},
    {"asymptotic", "osculating", oracle_osculating, 0},
    {"asymptotic", "regular", oracle_smallest_sine, 1},
    {"asymptotic", "positive-weights", oracle_smallest_weight, 1},
    {"bonnet", "isothermal", oracle_isothermal, 0},
    {"bonnet", "harmonic", oracle_harmonic_net, 0},
    {"bonnet", "minimal", oracle_minimal, 0},
    {"bonnet", "algebraic", oracle_minimal, 0},
    {"bonnet", "formula", oracle_formula, 0},
    {"pipe", "joint1", oracle_joint1, 0},
    {"pipe", "joint2", oracle_joint2, 0},
    {"pipe", "tube", oracle_tube, 0},
    {"pipe", "embedded", oracle_embedded, 0},
    {"pipe", "ends", oracle_ends, 0},
    {"dirichlet", "aspect", oracle_aspect, 0},
    {"plateau", "least", oracle_least, 0},
    {"harmonic-extension", "contact", oracle_tangent, 0},
    {"harmonic-extension", "merged", oracle_merged, 0},
    {"bonnet", "smooth", oracle_smooth, 0},
    {"bonnet", "closed-form", oracle_closed, 0},
    {"pipe", "joints", oracle_joints, 0},
    {"pipe", "bend_radius", oracle_bend, 0},
    {"pipe", "caps", oracle_caps, 0},
    {"film", "boundary", oracle_film_boundary, 0},
    {"film", "held", oracle_film_held, 0},
    {"film", "cables", oracle_film_cables, 0},
    {"film", "stationary", oracle_film_stationary, 0},
    {"film", "stable", oracle_film_lowest, 1},
    {NULL, "identity", oracle_identity, 0},
};

static const oracle_judge_row *row_of(const char *construct, const char *claim)
{
    for (size_t i = 0; i < sizeof judges / sizeof judges[0]; i++) {
        if ((judges[i].construct == NULL || strcmp(judges[i].construct, construct) == 0) &&
            strcmp(judges[i].claim, claim) == 0) {
            return &judges[i];
        }
    }
    return NULL;
}

int oracle_knows(const char *construct, const char *claim)
{
    return row_of(construct, claim) != NULL;
}

static int is_false(const oracle_judge_row *row, double found, double limit)
{
    if (row->above) {
        return found < limit * (1 - 1e-3);
    }
    if (limit >= 0.5) { /* `embedded` and the like: ratios */
        return found > limit * (1 + 1e-6);
    }
    return found > (limit >= 1e-9 ? limit * (1 + 1e-3) : 4 * limit);
}

static double number_of(const taut_certificate *certificate, const char *name)
{
    return taut_record_number(taut_record_get(taut_certificate_figures(certificate), name));
}

static int holds_claim(const taut_certificate *certificate, const char *name)
{
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        if (strcmp(claim->claim, name) == 0) {
            return claim->holds == TAUT_TRUE;
        }
    }
    return 0;
}

/* sine: where it was looked for already. A proved bound of the smallest sine that the search went below; a lower bound of the least area
 * that an area with the same boundary is below. */
static const char *figures_lie(const oracle_case *about, const taut_certificate *certificate,
                               double sine, oracle_finding *finding)
{
    const double bound = number_of(certificate, "regular_bound");
    const double least = number_of(certificate, "lower_bound");

    if (bound > 0) {
        finding->found = isnan(sine) ? oracle_smallest_sine(about) : sine;
        finding->limit = bound;
        if (finding->found < bound * (1 - 1e-9)) {
            return "figure regular_bound is above a sine that is there";
        }
    }
    if (least > 0 && holds_claim(certificate, "known") && about->problem != NULL &&
        about->honest_area < least * (1 - 1e-9)) {
        finding->found = about->honest_area;
        finding->limit = least;
        return "figure lower_bound is above the area of a surface with this boundary";
    }
    return NULL;
}

/* How far a model may be from what its problem has as its one solution, when all claims hold. Where
 * the solution is free (inner points of an asymptotic patch, a film's slides), infinity. */
static double freedom(const oracle_case *about)
{
    if (strcmp(about->construct, "asymptotic") == 0 || strcmp(about->construct, "plateau") == 0 ||
        strcmp(about->construct, "film") == 0) {
        return INFINITY;
    }
    return strcmp(about->construct, "pipe") == 0 ? 1e-3 : 1e-6;
}

static const char *whole_lies(const oracle_case *about, oracle_finding *finding)
{
    if (about->problem == NULL || about->honest == NULL) {
        return NULL;
    }
    finding->limit = freedom(about);
    finding->found = strcmp(about->construct, "pipe") == 0
                         ? oracle_pipe_distance(about)
                         : oracle_distance(about->model, about->honest);
    if (finding->found > finding->limit) {
        return "the model is not the one solution of its problem";
    }
    if (strcmp(about->construct, "film") == 0) {
        finding->found = oracle_film_energy(about, about->model, NULL);
        finding->limit = oracle_film_energy(about, about->honest, NULL);
        if (finding->found > finding->limit * 1.01) {
            return "the film has more energy than the one that was made";
        }
    }
    if (strcmp(about->construct, "plateau") == 0) {
        oracle_sheet film;
        oracle_integrals own = {.area = NAN};
        if (finding->found > 1e-3 && oracle_sheet_of(oracle_subject(about, 0), &film)) {
            oracle_integrate(&film, 1e-5L, 1, &own);
            oracle_sheet_free(&film);
        }
        finding->found = (double)own.area;
        finding->limit = about->honest_area;
        /* another film may be another minimum, but not by far */
        if (own.area - own.area_error > about->honest_area * 1.01L) {
            return "the film has a larger area than the one that was made";
        }
    }
    return NULL;
}

/* Where `identity` does not hold, a claim may be about the surface of that name or the one at that
 * place, which are not the same then: what is true of either is no lie. */
static double find_either(const oracle_judge_row *row, const oracle_case *about, int is_identified)
{
    oracle_case other = *about;
    double found[2] = {row->find(about), NAN};

    if (is_identified || about->honest == NULL || isnan(found[0])) {
        return found[0];
    }
    other.by_place = 1;
    found[1] = row->find(&other);
    return isnan(found[1]) ? NAN : row->above ? fmax(found[0], found[1]) : fmin(found[0], found[1]);
}

int oracle_judge(const oracle_case *about, const taut_certificate *certificate,
                 oracle_finding *finding)
{
    const taut_record *left_out =
        taut_record_get(taut_certificate_figures(certificate), "not_certified");
    double sine = NAN;

    *finding = (oracle_finding){.claim = ""};
    if (taut_record_count(left_out) > 0) {
        return 0; /* which of them the claims are about is not for the oracle to guess */
    }
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        const oracle_judge_row *row = row_of(about->construct, claim->claim);
        if (claim->holds != TAUT_TRUE) {
            continue;
        }
        if (!isfinite(claim->residual) || !isfinite(claim->limit)) {
            finding->why = "it holds with a residual or a limit that is no number";
        } else if (row != NULL) {
            const double found = find_either(row, about, holds_claim(certificate, "identity"));
            sine = row->find == oracle_smallest_sine ? found : sine;
            finding->judged += !isnan(found);
            if (isnan(found) || !is_false(row, found, claim->limit)) {
                continue;
            }
            finding->found = found;
            finding->why = row->above ? "a smaller value is there" : "a larger residual is there";
        } else {
            finding->unjudged++;
            continue;
        }
        finding->claim = claim->claim;
        finding->limit = claim->limit;
        return 1;
    }
    finding->why = figures_lie(about, certificate, sine, finding);
    if (finding->why != NULL) {
        finding->claim = "figures";
        return 1;
    }
    if (taut_certificate_holds(certificate) == TAUT_TRUE) {
        finding->why = whole_lies(about, finding);
        finding->claim = finding->why != NULL ? "whole" : "";
    }
    return finding->why != NULL;
}

double oracle_number(const taut_record *record)
{
    char *end;
    double value;

    if (taut_record_kind_of(record) == TAUT_RECORD_NUMBER) {
        return taut_record_number(record);
    }
    if (taut_record_kind_of(record) != TAUT_RECORD_TEXT) {
        return NAN;
    }
    value = strtod(taut_record_text(record), &end);
    return *end == '/' ? value / strtod(end + 1, NULL) : value;
}

int oracle_point(const taut_record *record, double point[3])
{
    if (taut_record_kind_of(record) != TAUT_RECORD_LIST || taut_record_count(record) != 3) {
        return 0;
    }
    for (size_t k = 0; k < 3; k++) {
        point[k] = oracle_number(taut_record_at(record, k));
        if (isnan(point[k])) {
            return 0;
        }
    }
    return 1;
}

const taut_surface *oracle_surface(const taut_model *model, const char *name)
{
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        if (strcmp(taut_surface_name(taut_model_surface(model, i)), name) == 0) {
            return taut_model_surface(model, i);
        }
    }
    return NULL;
}

int oracle_subject_count(const oracle_case *about)
{
    return taut_model_surface_count(about->honest != NULL ? about->honest : about->model);
}

const taut_surface *oracle_subject(const oracle_case *about, int i)
{
    return about->honest == NULL || about->by_place
               ? taut_model_surface(about->model, i)
               : oracle_surface(about->model,
                                taut_surface_name(taut_model_surface(about->honest, i)));
}

const taut_curve *oracle_curve(const taut_model *model, const char *name)
{
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        if (strcmp(taut_curve_name(taut_model_curve(model, i)), name) == 0) {
            return taut_model_curve(model, i);
        }
    }
    return NULL;
}

static double sheet_distance(const taut_surface *a, const taut_surface *b)
{
    oracle_sheet s, t;
    oracle_real worst = 0;

    if (!oracle_sheet_of(a, &s)) {
        return NAN;
    }
    if (!oracle_sheet_of(b, &t)) {
        oracle_sheet_free(&s);
        return NAN;
    }
    for (int i = 0; i < 81; i++) {
        const oracle_real x = (oracle_real)(i % 9) / 8, y = (oracle_real)(i / 9) / 8;
        oracle_real p[6][3], q[6][3];
        oracle_sheet_eval(&s, s.u.lo * (1 - x) + s.u.hi * x, s.v.lo * (1 - y) + s.v.hi * y, 0, p);
        oracle_sheet_eval(&t, t.u.lo * (1 - x) + t.u.hi * x, t.v.lo * (1 - y) + t.v.hi * y, 0, q);
        for (int k = 0; k < 3; k++) {
            worst = fmaxl(worst, fabsl(p[0][k] + s.middle[k] - q[0][k] - t.middle[k]));
        }
    }
    worst /= t.size;
    oracle_sheet_free(&s);
    oracle_sheet_free(&t);
    return (double)worst;
}

double oracle_distance(const taut_model *a, const taut_model *b)
{
    double worst = 0;

    if (taut_model_surface_count(a) != taut_model_surface_count(b)) {
        return INFINITY;
    }
    for (int i = 0; i < taut_model_surface_count(a); i++) {
        const taut_surface *own = taut_model_surface(b, i);
        const double d = sheet_distance(oracle_surface(a, taut_surface_name(own)), own);
        worst = isnan(d) ? INFINITY : fmax(worst, d);
    }
    return worst;
}
