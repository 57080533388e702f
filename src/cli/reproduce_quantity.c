/* reproduce_quantity.c -- quantities by their first word. */
#include "reproduce.h"

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

/* figure NAME: of the certificate */
static double figure(const cli_subject *s, const words *w)
{
    return taut_record_number(
        taut_record_get(taut_certificate_figures(s->certificate), w->word[1]));
}

/* detail NAME [NAME...]: of the model */
static double detail(const cli_subject *s, const words *w)
{
    const taut_record *at = taut_model_details(s->model);
    for (int i = 1; i < w->count; i++) {
        at = taut_record_kind_of(at) == TAUT_RECORD_LIST ? taut_record_at(at, (size_t)integer(w, i))
                                                         : taut_record_get(at, w->word[i]);
    }
    return taut_record_number(at);
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

static const struct {
    const char *name;
    double (*value)(const cli_subject *, const words *);
} quantities[] = {
    {"point", point},
    {"figure", figure},
    {"detail", detail},
    {"max_abs_mean", max_abs_mean},
    {"mean_abs_mean", mean_abs_mean},
    {"triangulated_area", triangulated},
    {"unnormalised_max", unnormalised_max},
    {"unnormalised_mean", unnormalised_mean},
    {"cotes_point", cotes_point},
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
