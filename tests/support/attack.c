#include "attack.h"

#include "certificates.h"
#include "check.h"
#include "cli/embedded_files.h"

#include "taut/model.h"
#include "taut/read.h"

#include <stdlib.h>
#include <string.h>

subject subject_of(const char *text)
{
    subject s = {NULL, NULL};
    taut_error error = {.message = ""};
    CHECK(taut_problem_read_text(text, strlen(text), "problem", &s.problem, &error) == TAUT_OK &&
              taut_make(s.problem, NULL, &s.model, &error) == TAUT_OK,
          "%s: %s", error.where, error.message);
    return s;
}

subject subject_example(const char *name)
{
    const taut_embedded *file = taut_examples;
    char wanted[128];
    snprintf(wanted, sizeof wanted, "%s.json", name);
    while (file->name != NULL && strcmp(file->name, wanted) != 0) {
        file++;
    }
    CHECK(file->name != NULL, "no example %s", name);
    return subject_of(file->name != NULL ? file->text : "{}");
}

void subject_free(subject *s)
{
    taut_model_free(s->model);
    taut_problem_free(s->problem);
}

static int count_of(const taut_surface *s)
{
    return taut_basis_count(taut_surface_u(s)) * taut_basis_count(taut_surface_v(s));
}

/* The surface with its coordinates times `factor`, and point p moved (-1: none). */
static taut_surface *changed(const taut_surface *s, double factor, int p, const double by[3])
{
    const size_t numbers = 3 * (size_t)count_of(s);
    double *points = malloc(numbers * sizeof *points);
    taut_surface *made = NULL;
    for (size_t k = 0; k < numbers; k++) {
        points[k] = factor * taut_surface_points(s)[k];
    }
    for (int c = 0; p >= 0 && c < 3; c++) {
        points[3 * p + c] += by[c];
    }
    CHECK(taut_surface_new(taut_surface_name(s), taut_surface_u(s), taut_surface_v(s), points,
                           taut_surface_weights(s), &made, NULL) == TAUT_OK,
          "a surface");
    free(points);
    return made;
}

/* Takes over `surface`, in place of surface k. */
static taut_model *copied(const taut_model *model, double factor, int k, taut_surface *surface)
{
    taut_model *copy = NULL;
    CHECK(taut_model_new(&copy) == TAUT_OK &&
              taut_model_set_unit(copy, taut_model_unit(model)) == TAUT_OK,
          "a model");
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        taut_surface *s =
            i == k ? surface : changed(taut_model_surface(model, i), factor, -1, NULL);
        CHECK(taut_model_add_surface(copy, s) == TAUT_OK, "surface %d", i);
    }
    return copy;
}

taut_model *model_moved(const taut_model *model, int k, int p, const double by[3])
{
    taut_surface *s = k < 0 ? NULL : changed(taut_model_surface(model, k), 1, p, by);
    return copied(model, 1, k, s);
}

taut_model *model_with(const taut_model *model, int k, taut_surface *surface)
{
    return copied(model, 1, k, surface);
}

taut_model *model_scaled(const taut_model *model, int exponent)
{
    return copied(model, ldexp(1, exponent), -1, NULL);
}

taut_certificate *prove(const taut_model *model, const taut_problem *problem, const char *construct)
{
    taut_certificate *certificate = NULL, *label = NULL;
    taut_error error = {.message = ""};
    taut_model *own = NULL;

    if (problem == NULL) { /* the model says what it is */
        own = model_moved(model, -1, 0, NULL);
        CHECK(taut_certificate_new(construct, &label) == TAUT_OK, "a label");
        taut_model_set_certificate(own, label);
    }
    CHECK(taut_certify(own != NULL ? own : model, problem, NULL, &certificate, &error) == TAUT_OK,
          "%s: %s", error.where, error.message);
    taut_model_free(own);
    return certificate;
}

/* The claim after point p was moved. */
static taut_claim after(const subject *s, const attack *row, int p, const double direction[3],
                        double by)
{
    const double moved[3] = {by * direction[0], by * direction[1], by * direction[2]};
    taut_model *model = model_moved(s->model, row->surface, p, moved);
    taut_certificate *certificate = prove(model, s->problem, NULL);
    taut_claim claim = *claim_of(certificate, row->claim);
    claim.claim = claim.where = "";
    taut_certificate_free(certificate);
    taut_model_free(model);
    return claim;
}

static double largest_of(const taut_surface *s)
{
    double largest = 0;
    for (int k = 0; k < 3 * count_of(s); k++) {
        largest = fmax(largest, fabs(taut_surface_points(s)[k]));
    }
    return largest;
}

void attack_claim(const attack *row, int directions)
{
    subject s = subject_example(row->example);
    const double size = largest_of(taut_model_surface(s.model, row->surface));
    const double none[3] = {0, 0, 0};

    CHECK(row->last < count_of(taut_model_surface(s.model, row->surface)), "%s has no point %d",
          row->example, row->last);
    for (int k = 0; k < directions; k++) {
        const int p = random_int(row->first, row->last);
        const double direction[3] = {random_in(0.3, 1), random_in(-1, -0.3), random_in(0.3, 1)};
        const taut_claim plain = after(&s, row, p, none, 0);
        const taut_claim far = after(&s, row, p, direction, 1e-4 * size);
        const double slope = far.residual / (1e-4 * size);
        CHECK(plain.holds == TAUT_TRUE && plain.kind == row->kind, "%s %s: %d, %g over %g",
              row->example, row->claim, (int)plain.holds, plain.residual, plain.limit);
        CHECK(plain.limit <= row->most, "%s %s: limit %g, at most %g", row->example, row->claim,
              plain.limit, row->most);
        CHECK(far.holds == TAUT_FALSE, "%s %s, point %d far away: %d", row->example, row->claim, p,
              (int)far.holds);
        if (plain.limit == 0) {
            CHECK(after(&s, row, p, direction, 0x1p-51 * size).holds == TAUT_FALSE,
                  "%s %s, point %d a rounding away", row->example, row->claim, p);
            continue;
        }
        const double step = plain.limit / slope;
        const taut_claim tenth = after(&s, row, p, direction, 0.1 * step);
        const taut_claim ten = after(&s, row, p, direction, 10 * step);
        CHECK(tenth.holds == TAUT_TRUE, "%s %s, point %d by a tenth: %g over %g", row->example,
              row->claim, p, tenth.residual, tenth.limit);
        CHECK(ten.holds != TAUT_TRUE, "%s %s, point %d by ten: %g over %g", row->example,
              row->claim, p, ten.residual, ten.limit);
    }
    subject_free(&s);
}
