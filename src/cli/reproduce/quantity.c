/* quantity.c -- quantities by their first word. */
#include "cli/reproduce/reproduce.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WORDS_MAX = 8, WORD_SIZE = 48 };

typedef struct words {
    int count;
    char word[WORDS_MAX][WORD_SIZE];
} words;

static int integer(const words *w, int i)
{
    return i < w->count ? (int)strtol(w->word[i], NULL, 10) : 0;
}

static double real(const words *w, int i)
{
    return i < w->count ? strtod(w->word[i], NULL) : (double)NAN;
}

/* "x", "y", "z" as 0, 1, 2. */
static int coordinate(const words *w, int i)
{
    return i < w->count && w->word[i][0] >= 'x' && w->word[i][0] <= 'z' ? w->word[i][0] - 'x' : 0;
}

/* A surface by its name, or the first one where the word is a number or missing. */
static const taut_surface *surface_of(const cli_subject *s, const char *name)
{
    for (int i = 0; name != NULL && i < taut_model_surface_count(s->model); i++) {
        if (strcmp(taut_surface_name(taut_model_surface(s->model, i)), name) == 0) {
            return taut_model_surface(s->model, i);
        }
    }
    return taut_model_surface(s->model, 0);
}

static double measured(const cli_subject *s, const words *w,
                       double (*pick)(const taut_surface_measure *))
{
    const taut_measure_options options = {.grid = w->count > 1 ? integer(w, 1) : 0};
    taut_surface_measure measure;
    if (taut_measure_surface(surface_of(s, NULL), &options, &measure, NULL) != TAUT_OK) {
        return (double)NAN;
    }
    return pick(&measure);
}

static double pick_max_mean(const taut_surface_measure *m)
{
    return m->max_abs_mean;
}

static double pick_mean_mean(const taut_surface_measure *m)
{
    return m->mean_abs_mean;
}

/* point I J C, or point NAME I J C */
static double point(const cli_subject *s, const words *w)
{
    const int named = w->count > 4;
    const taut_surface *surface = surface_of(s, named ? w->word[1] : NULL);
    const int i = integer(w, 1 + named), j = integer(w, 2 + named), c = coordinate(w, 3 + named);
    const int columns = surface != NULL ? taut_basis_count(taut_surface_v(surface)) : 0;
    if (surface == NULL || i < 0 || j < 0 || j >= columns ||
        i >= taut_basis_count(taut_surface_u(surface))) {
        return (double)NAN;
    }
    return taut_surface_points(surface)[3 * (i * columns + j) + c];
}

static double max_abs_mean(const cli_subject *s, const words *w)
{
    return measured(s, w, pick_max_mean);
}

static double mean_abs_mean(const cli_subject *s, const words *w)
{
    return measured(s, w, pick_mean_mean);
}

static double pick_min_gaussian(const taut_surface_measure *m)
{
    return m->min_gaussian;
}

static double pick_max_gaussian(const taut_surface_measure *m)
{
    return m->max_gaussian;
}

static double min_gaussian(const cli_subject *s, const words *w)
{
    return measured(s, w, pick_min_gaussian);
}

static double max_gaussian(const cli_subject *s, const words *w)
{
    return measured(s, w, pick_max_gaussian);
}

/* edge_length u0 */
static double edge_length(const cli_subject *s, const words *w)
{
    const taut_measure_options options = {.grid = 2};
    const char *edge = w->word[1];
    taut_surface_measure measure;
    return taut_measure_surface(surface_of(s, NULL), &options, &measure, NULL) == TAUT_OK
               ? measure.edges[2 * (edge[0] == 'v') + (edge[1] == '1')].length
               : (double)NAN;
}

/* gaussian U V, or gaussian NAME U V */
static double gaussian(const cli_subject *s, const words *w)
{
    const int named = w->count > 3;
    const taut_surface *surface = surface_of(s, named ? w->word[1] : NULL);
    double x[6][3];
    taut_forms forms;
    if (surface == NULL || taut_surface_eval(surface, real(w, 1 + named), real(w, 2 + named), 2,
                                             &x[0][0]) != TAUT_OK) {
        return (double)NAN;
    }
    taut_forms_of((const double(*)[3])x, &forms);
    return forms.gaussian;
}

/* The number that words 1, 2, ... lead to: members by name, items by index. */
static double follow(const taut_record *at, const words *w)
{
    for (int i = 1; i < w->count; i++) {
        at = taut_record_kind_of(at) == TAUT_RECORD_LIST ? taut_record_at(at, (size_t)integer(w, i))
                                                         : taut_record_get(at, w->word[i]);
    }
    return taut_record_number(at);
}

/* figure NAME [NAME...]: of the certificate */
static double figure(const cli_subject *s, const words *w)
{
    return follow(taut_certificate_figures(s->certificate), w);
}

/* detail NAME [NAME...]: of the model */
static double detail(const cli_subject *s, const words *w)
{
    return follow(taut_model_details(s->model), w);
}

/* count NAME [NAME...]: the items of a list, or members, in the details */
static double count_of(const cli_subject *s, const words *w)
{
    const taut_record *at = taut_model_details(s->model);
    for (int i = 1; i < w->count; i++) {
        at = taut_record_get(at, w->word[i]);
    }
    return at != NULL ? (double)taut_record_count(at) : (double)NAN;
}

/* at U V C: coordinate of the first surface */
static double evaluate_at(const cli_subject *s, const words *w)
{
    double x[3];
    return taut_surface_eval(surface_of(s, NULL), real(w, 1), real(w, 2), 0, x) == TAUT_OK
               ? x[coordinate(w, 3)]
               : (double)NAN;
}

/* weight I J: of the first surface */
static double weight(const cli_subject *s, const words *w)
{
    const taut_surface *surface = surface_of(s, NULL);
    const int i = integer(w, 1), j = integer(w, 2),
              columns = taut_basis_count(taut_surface_v(surface));
    if (taut_surface_weights(surface) == NULL || i < 0 || j < 0 || j >= columns ||
        i >= taut_basis_count(taut_surface_u(surface))) {
        return (double)NAN;
    }
    return taut_surface_weights(surface)[i * columns + j];
}

/* A curve by its name, or NULL. */
static const taut_curve *curve_of(const cli_subject *s, const char *name)
{
    for (int i = 0; i < taut_model_curve_count(s->model); i++) {
        if (strcmp(taut_curve_name(taut_model_curve(s->model, i)), name) == 0) {
            return taut_model_curve(s->model, i);
        }
    }
    return NULL;
}

/* curve_point NAME J C */
static double curve_point(const cli_subject *s, const words *w)
{
    const taut_curve *curve = curve_of(s, w->word[1]);
    const int j = integer(w, 2);
    return curve != NULL && j >= 0 && j < taut_basis_count(taut_curve_t(curve))
               ? taut_curve_points(curve)[3 * j + coordinate(w, 3)]
               : (double)NAN;
}

/* curve_weight NAME J */
static double curve_weight(const cli_subject *s, const words *w)
{
    const taut_curve *curve = curve_of(s, w->word[1]);
    const int j = integer(w, 2);
    return curve != NULL && taut_curve_weights(curve) != NULL && j >= 0 &&
                   j < taut_basis_count(taut_curve_t(curve))
               ? taut_curve_weights(curve)[j]
               : (double)NAN;
}

/* curvature NAME T: |r' x r''| / |r'|^3 */
static double curvature(const cli_subject *s, const words *w)
{
    const taut_curve *curve = curve_of(s, w->word[1]);
    double x[3][3], b[3], speed = 0.0;
    if (curve == NULL || taut_curve_eval(curve, real(w, 2), 2, &x[0][0]) != TAUT_OK) {
        return (double)NAN;
    }
    for (int k = 0; k < 3; k++) {
        b[k] = x[1][(k + 1) % 3] * x[2][(k + 2) % 3] - x[1][(k + 2) % 3] * x[2][(k + 1) % 3];
    }
    speed = sqrt(x[1][0] * x[1][0] + x[1][1] * x[1][1] + x[1][2] * x[1][2]);
    return sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]) / (speed * speed * speed);
}

/* function NAME I T: basis function i of a curve with one span */
static double function(const cli_subject *s, const words *w)
{
    const taut_curve *curve = curve_of(s, w->word[1]);
    const int i = integer(w, 2);
    double values[TAUT_DEGREE_MAX + 1];
    return curve != NULL && i >= 0 && i < taut_basis_local(taut_curve_t(curve)) &&
                   taut_basis_eval(taut_curve_t(curve), 0, real(w, 3), 0, values) == TAUT_OK
               ? values[i]
               : (double)NAN;
}

static const taut_claim *claim_of(const cli_subject *s, const char *name)
{
    for (int i = 0; i < taut_certificate_claim_count(s->certificate); i++) {
        if (strcmp(taut_certificate_claim(s->certificate, i)->claim, name) == 0) {
            return taut_certificate_claim(s->certificate, i);
        }
    }
    return NULL;
}

/* claim NAME: its residual */
static double claim(const cli_subject *s, const words *w)
{
    const taut_claim *found = claim_of(s, w->word[1]);
    return found != NULL ? found->residual : (double)NAN;
}

/* holds NAME: 1 or 0 */
static double holds(const cli_subject *s, const words *w)
{
    const taut_claim *found = claim_of(s, w->word[1]);
    return found != NULL ? found->holds == TAUT_TRUE : (double)NAN;
}

static double triangulated(const cli_subject *s, const words *w)
{
    return cli_triangulated_area(surface_of(s, NULL), integer(w, 1));
}

static double unnormalised_max(const cli_subject *s, const words *w)
{
    return cli_unnormalised_curvature(surface_of(s, NULL), integer(w, 1), 0);
}

static double unnormalised_mean(const cli_subject *s, const words *w)
{
    return cli_unnormalised_curvature(surface_of(s, NULL), integer(w, 1), 1);
}

/* cotes_point PANELS I J C */
static double cotes_point(const cli_subject *s, const words *w)
{
    return cli_cotes_point(surface_of(s, NULL), integer(w, 1), integer(w, 2), integer(w, 3),
                           coordinate(w, 4));
}

/* basis_k u */
static const taut_basis *basis_of(const cli_subject *s, const words *w)
{
    return w->word[1][0] == 'v' ? taut_surface_v(surface_of(s, NULL))
                                : taut_surface_u(surface_of(s, NULL));
}

static double basis_k(const cli_subject *s, const words *w)
{
    return cli_basis_k(basis_of(s, w));
}

static double basis_m(const cli_subject *s, const words *w)
{
    return cli_basis_m(basis_of(s, w));
}

static double lambda_of(const cli_subject *s)
{
    return taut_record_number(taut_record_get(taut_model_details(s->model), "lambda"));
}

static double literal_index(const cli_subject *s, const words *w)
{
    (void)w;
    return cli_literal_index(surface_of(s, NULL), lambda_of(s));
}

static double literal_h42(const cli_subject *s, const words *w)
{
    (void)w;
    return cli_literal_h42(surface_of(s, NULL), lambda_of(s));
}

static double literal_slope(const cli_subject *s, const words *w)
{
    (void)w;
    return cli_literal_slope(surface_of(s, NULL), lambda_of(s));
}

static const struct {
    const char *name;
    double (*value)(const cli_subject *, const words *);
} quantities[] = {
    {"point", point},
    {"figure", figure},
    {"detail", detail},
    {"count", count_of},
    {"at", evaluate_at},
    {"weight", weight},
    {"curve_point", curve_point},
    {"curve_weight", curve_weight},
    {"curvature", curvature},
    {"function", function},
    {"claim", claim},
    {"holds", holds},
    {"max_abs_mean", max_abs_mean},
    {"mean_abs_mean", mean_abs_mean},
    {"triangulated_area", triangulated},
    {"unnormalised_max", unnormalised_max},
    {"unnormalised_mean", unnormalised_mean},
    {"cotes_point", cotes_point},
    {"gaussian", gaussian},
    {"min_gaussian", min_gaussian},
    {"max_gaussian", max_gaussian},
    {"edge_length", edge_length},
    {"basis_k", basis_k},
    {"basis_m", basis_m},
    {"literal_index", literal_index},
    {"literal_h42", literal_h42},
    {"literal_slope", literal_slope},
};

double cli_quantity(const cli_subject *subject, const char *quantity)
{
    words w = {0, {""}};
    const char *p = quantity;
    while (*p != '\0' && w.count < WORDS_MAX) {
        const size_t length = strcspn(p, " ");
        if (length > 0 && length < WORD_SIZE) {
            memcpy(w.word[w.count], p, length);
            w.word[w.count++][length] = '\0';
        }
        p += length + (p[length] == ' ');
    }
    for (size_t i = 0; w.count > 0 && i < sizeof quantities / sizeof quantities[0]; i++) {
        if (strcmp(quantities[i].name, w.word[0]) == 0) {
            return quantities[i].value(subject, &w);
        }
    }
    return (double)NAN;
}
