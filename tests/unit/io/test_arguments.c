/* test_arguments.c -- NULL where a function with a status needs something is TAUT_BAD_ARGUMENT, its
 * outputs left alone; what a caller may do by mistake with what it owns does no harm. */
#include "check.h"

#include "taut/taut.h"

#include <string.h>

static const double points[2][2][3] = {{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}};

/* What the calls below are made with. */
typedef struct things {
    taut_basis *basis;
    taut_surface *surface;
    taut_curve *curve;
    taut_model *model;
    taut_certificate *certificate;
    taut_record *record;
} things;

static things things_new(void)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = 1};
    things t = {.record = taut_record_new()};
    taut_surface *copy = NULL;
    CHECK(taut_basis_new(&spec, 2, &t.basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_surface_new("s", t.basis, t.basis, &points[0][0][0], NULL, &t.surface, NULL) ==
              TAUT_OK,
          "surface");
    CHECK(taut_curve_new("c", t.basis, &points[0][0][0], NULL, &t.curve, NULL) == TAUT_OK, "curve");
    CHECK(taut_model_new(&t.model) == TAUT_OK, "model");
    CHECK(taut_surface_copy(t.surface, &copy) == TAUT_OK, "copy");
    CHECK(taut_model_add_surface(t.model, copy) == TAUT_OK, "add");
    CHECK(taut_certificate_new("x", &t.certificate) == TAUT_OK, "certificate");
    return t;
}

static void things_free(things *t)
{
    taut_record_free(t->record);
    taut_certificate_free(t->certificate);
    taut_model_free(t->model);
    taut_curve_free(t->curve);
    taut_surface_free(t->surface);
    taut_basis_free(t->basis);
}

#define REFUSED(call) CHECK((call) == TAUT_BAD_ARGUMENT, #call)

static void test_objects(const things *t)
{
    taut_surface *surface = NULL;
    taut_curve *curve = NULL;
    taut_certificate *certificate = NULL;
    taut_record *record = NULL;
    const taut_claim claim = {.claim = "c", .where = ""};
    taut_error error;

    REFUSED(taut_surface_copy(NULL, &surface));
    REFUSED(taut_surface_copy(t->surface, NULL));
    REFUSED(taut_curve_copy(NULL, &curve));
    REFUSED(taut_curve_copy(t->curve, NULL));
    REFUSED(taut_model_new(NULL));
    REFUSED(taut_model_add_surface(NULL, t->surface));
    REFUSED(taut_model_add_surface(t->model, NULL));
    REFUSED(taut_model_add_curve(NULL, t->curve));
    REFUSED(taut_model_add_curve(t->model, NULL));
    REFUSED(taut_model_set_unit(NULL, "mm"));
    REFUSED(taut_model_set_unit(t->model, NULL));
    REFUSED(taut_certificate_new("x", NULL));
    REFUSED(taut_certificate_add(NULL, &claim));
    REFUSED(taut_certificate_add(t->certificate, NULL));
    REFUSED(taut_certificate_copy(NULL, &certificate));
    REFUSED(taut_certificate_copy(t->certificate, NULL));
    REFUSED(taut_outputs_new(NULL));
    REFUSED(taut_record_read_text(NULL, 2, "r", &record, &error));
    REFUSED(taut_record_read_text("{}", 2, NULL, &record, &error));
    REFUSED(taut_record_read_text("{}", 2, "r", NULL, &error));
    CHECK(surface == NULL && curve == NULL && certificate == NULL && record == NULL, "untouched");
    CHECK(taut_model_surface_count(t->model) == 1 && taut_model_curve_count(t->model) == 0,
          "model");
    CHECK(taut_format_of(NULL, &error) == -1 && error.status == TAUT_BAD_ARGUMENT, "format");
}

/* Problems that were begun and not filled. */
static void test_problems(const things *t)
{
    const taut_dirichlet_problem dirichlet = {.u = t->basis, .v = t->basis};
    const taut_plateau_problem plateau = {.net = {.u = t->basis, .v = t->basis}};
    const taut_plateau_problem three = {.curves = {t->curve, t->curve, t->curve, NULL}};
    taut_certificate *certificate = NULL;
    taut_model *model = NULL;

    REFUSED(taut_dirichlet_certify(t->model, &dirichlet, NULL, &certificate, NULL));
    REFUSED(taut_plateau_certify(t->model, &plateau, NULL, &certificate, NULL));
    REFUSED(taut_plateau_certify(t->model, &three, NULL, &certificate, NULL));
    REFUSED(taut_dirichlet_make(&dirichlet, NULL, &model, NULL));
    CHECK(certificate == NULL && model == NULL, "untouched");
}

static void test_records(things *t)
{
    taut_record *list = taut_record_new_list();

    taut_record_add_number(t->record, "one", 1);
    taut_record_add_record(t->record, "self", t->record); /* a copy of what it was */
    CHECK(taut_record_status(t->record) == TAUT_OK && taut_record_count(t->record) == 2, "itself");
    CHECK(taut_record_count(taut_record_get(t->record, "self")) == 1, "as it was");
    taut_record_add_number(t->record, NULL, 2);
    REFUSED(taut_record_status(t->record));
    CHECK(taut_record_count(t->record) == 2, "nothing was added");
    taut_record_add_number(list, "key", 2);
    REFUSED(taut_record_status(list));
    taut_record_free(list);
}

/* What is there already is set again. */
static void test_same(things *t)
{
    taut_record *details = taut_record_new(), *figures = taut_record_new();
    taut_certificate_set_figures(t->certificate, figures);
    taut_certificate_set_figures(t->certificate, figures);
    taut_model_set_details(t->model, details);
    taut_model_set_details(t->model, details);
    taut_model_set_certificate(t->model, t->certificate);
    taut_model_set_certificate(t->model, t->certificate);
    CHECK(taut_record_count(taut_model_details(t->model)) == 0, "details");
    CHECK(taut_certificate_figures(taut_model_certificate(t->model)) == figures, "figures");
    t->certificate = NULL; /* the model's */
}

int main(void)
{
    things t = things_new();
    test_objects(&t);
    test_problems(&t);
    test_records(&t);
    test_same(&t);
    things_free(&t);
    return check_failures != 0;
}
