/* test_refusals.c -- what no certificate is made for: missing arguments, arithmetic a construction
 * does not know, curves whose knots cannot be told apart. */
#include "check.h"
#include "shapes.h"

#include "certify/common/curve_distance.h"
#include "taut/construct.h"
#include "taut/dirichlet.h"

#include <string.h>

static taut_model *model_of(taut_surface *surface, const char *construct)
{
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    CHECK(taut_model_new(&model) == TAUT_OK && taut_model_add_surface(model, surface) == TAUT_OK,
          "model");
    CHECK(taut_certificate_new(construct, &certificate) == TAUT_OK, "certificate");
    taut_model_set_certificate(model, certificate);
    return model;
}

static void test_arguments(void)
{
    const taut_certify_options exactly = {.exact = 1};
    taut_model *model = model_of(shape_saddle(1), "dirichlet");
    taut_certificate *certificate = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_certify(NULL, NULL, NULL, &certificate, &error) == TAUT_BAD_ARGUMENT, "no model");
    CHECK(strcmp(error.reason, "argument") == 0, "%s", error.message);
    CHECK(taut_certify(model, NULL, NULL, NULL, &error) == TAUT_BAD_ARGUMENT, "no place");
    CHECK(taut_dirichlet_certify(model, NULL, NULL, NULL, &error) == TAUT_BAD_ARGUMENT &&
              strcmp(error.reason, "argument") == 0,
          "%s", error.message);
    CHECK(taut_certify(model, NULL, &exactly, &certificate, &error) == TAUT_BAD_ARGUMENT, "exact");
    CHECK(strcmp(error.reason, "no-rationals") == 0, "%s", error.message);
    CHECK(certificate == NULL, "the output was touched");
    taut_model_free(model);
}

/* Two knots of one curve within a rounding of the one knot of the other. */
static void test_knots(void)
{
    const double near[] = {0, 0, 0, 0.5, 0.5 + 1e-13, 1, 1, 1}, one[] = {0, 0, 0, 0.5, 1, 1, 1};
    const double points[5][3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
    const taut_basis_spec specs[2] = {
        {.type = "bspline", .degree = 2, .knots = near, .knot_count = 8},
        {.type = "bspline", .degree = 2, .knots = one, .knot_count = 7}};
    taut_curve *a = shape_curve(shape_basis(&specs[0]), &points[0][0], NULL);
    taut_curve *b = shape_curve(shape_basis(&specs[1]), &points[0][0], NULL);
    taut_error error = {.message = ""};
    double bound = -1;
    CHECK(taut_certify_distance(a, b, &bound, &error) == TAUT_NO_SOLUTION, "a from b");
    CHECK(strcmp(error.reason, "close-knots") == 0, "%s", error.message);
    CHECK(taut_certify_distance(b, a, &bound, NULL) == TAUT_NO_SOLUTION, "b from a");
    CHECK(bound == -1, "the output was touched");
    taut_curve_free(a);
    taut_curve_free(b);
}

int main(void)
{
    test_arguments();
    test_knots();
    return check_failures != 0;
}
