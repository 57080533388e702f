/* test_model.c -- the container: what is added comes back, in order, and is owned. */
#include "check.h"

#include "taut/model.h"

#include <stdio.h>
#include <string.h>

static void test_objects(void)
{
    enum { COUNT = 37 };
    const double points[2][2][3] = {{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}};
    taut_basis_spec spec = {.type = "bezier", .degree = 1};
    taut_basis *basis = NULL;
    taut_model *model = NULL;
    char name[16];

    CHECK(taut_basis_new(&spec, 2, &basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    for (int i = 0; i < COUNT; i++) {
        taut_surface *surface = NULL;
        taut_curve *curve = NULL;
        snprintf(name, sizeof name, "%d", i);
        CHECK(taut_surface_new(name, basis, basis, &points[0][0][0], NULL, &surface, NULL) ==
                  TAUT_OK,
              "i=%d", i);
        CHECK(taut_curve_new(name, basis, &points[0][0][0], NULL, &curve, NULL) == TAUT_OK, "i=%d",
              i);
        CHECK(taut_model_add_surface(model, surface) == TAUT_OK, "i=%d", i);
        CHECK(taut_model_add_curve(model, curve) == TAUT_OK, "i=%d", i);
    }
    CHECK(taut_model_surface_count(model) == COUNT && taut_model_curve_count(model) == COUNT,
          "counts");
    for (int i = 0; i < COUNT; i++) {
        snprintf(name, sizeof name, "%d", i);
        CHECK(strcmp(taut_surface_name(taut_model_surface(model, i)), name) == 0, "i=%d", i);
        CHECK(strcmp(taut_curve_name(taut_model_curve(model, i)), name) == 0, "i=%d", i);
    }
    CHECK(taut_model_surface(model, COUNT) == NULL && taut_model_surface(model, -1) == NULL &&
              taut_model_curve(model, COUNT) == NULL && taut_model_curve(model, -1) == NULL,
          "beyond");
    taut_model_free(model);
    taut_basis_free(basis);
    taut_model_free(NULL);
}

/* Setting replaces and frees; NULL removes. The sanitizers see to the freeing. */
static void test_parts(void)
{
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    CHECK(taut_model_details(model) == NULL && taut_model_certificate(model) == NULL, "empty");
    taut_model_set_details(model, taut_record_new());
    taut_model_set_details(model, taut_record_new());
    CHECK(taut_model_details(model) != NULL, "details");
    taut_model_set_details(model, NULL);
    CHECK(taut_model_details(model) == NULL, "removed");
    CHECK(taut_certificate_new("x", &certificate) == TAUT_OK, "certificate");
    taut_model_set_certificate(model, certificate);
    CHECK(taut_model_certificate(model) == certificate, "certificate");
    taut_model_set_certificate(model, NULL);
    CHECK(taut_model_certificate(model) == NULL, "removed");
    taut_model_free(model);
}

static void test_unit(void)
{
    static const char *const units[] = {"m", "cm", "in", "ft", "mm"};
    taut_model *model = NULL;
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    CHECK(strcmp(taut_model_unit(model), "mm") == 0, "the default");
    for (int i = 0; i < 5; i++) {
        CHECK(taut_model_set_unit(model, units[i]) == TAUT_OK, "%s", units[i]);
        CHECK(strcmp(taut_model_unit(model), units[i]) == 0, "%s", units[i]);
    }
    CHECK(taut_model_set_unit(model, "furlong") == TAUT_BAD_INPUT, "unknown");
    CHECK(strcmp(taut_model_unit(model), "mm") == 0, "left alone");
    taut_model_free(model);
}

int main(void)
{
    test_objects();
    test_parts();
    test_unit();
    return check_failures != 0;
}
