/* test_limits.c -- limits that no short document reaches: each is refused with the limit in the
 * error, before anything of that size is read or taken. */
#include "check.h"
#include "shapes.h"

#include "taut/asymptotic.h"
#include "taut/limits.h"
#include "taut/model.h"
#include "taut/operations.h"

#include <stdlib.h>
#include <string.h>

/* A refusal: the status, the limit, the output as it was. */
static void check_refused(const char *what, taut_status status, taut_status expected,
                          const taut_error *error, double limit, const void *output)
{
    CHECK(status == expected && error->status == expected, "%s: status %d", what, (int)status);
    CHECK(error->limit == limit, "%s: limit %g, expected %g", what, error->limit, limit);
    CHECK(output == NULL, "%s: the output was touched", what);
}

/* 10,000 x 10,000 points are refused before the first one is read: there is only one. */
static void test_points(void)
{
    static const double point[3] = {0, 0, 0};
    const taut_basis_spec spec = {.type = "bspline", .degree = 3, .count = 10000};
    taut_basis *basis = shape_basis(&spec);
    taut_surface *surface = NULL;
    taut_error error = {.status = TAUT_OK};
    const taut_status status = taut_surface_new("s", basis, basis, point, NULL, &surface, &error);
    check_refused("points", status, TAUT_BAD_INPUT, &error, TAUT_POINTS_MAX, surface);
    taut_basis_free(basis);
}

static void test_counts(void)
{
    taut_basis *basis = NULL;
    taut_error error = {.status = TAUT_OK};
    const taut_basis_spec high = {.type = "bezier", .degree = TAUT_DEGREE_MAX + 1};
    const taut_basis_spec many = {.type = "bspline", .degree = 1, .count = TAUT_COUNT_MAX + 1};
    taut_status status = taut_basis_new(&high, 0, &basis, &error);
    check_refused("degree", status, TAUT_BAD_INPUT, &error, TAUT_DEGREE_MAX, basis);
    status = taut_basis_new(&many, 0, &basis, &error);
    check_refused("count", status, TAUT_BAD_INPUT, &error, TAUT_COUNT_MAX, basis);
}

static void test_name(void)
{
    static const double points[2][3] = {{0, 0, 0}, {1, 0, 0}};
    char name[TAUT_NAME_MAX + 2];
    taut_basis *basis = shape_bezier(1, 0, 1);
    taut_curve *curve = NULL;
    taut_error error = {.status = TAUT_OK};
    memset(name, 'x', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    const taut_status status = taut_curve_new(name, basis, &points[0][0], NULL, &curve, &error);
    check_refused("name", status, TAUT_BAD_INPUT, &error, TAUT_NAME_MAX, curve);
    name[TAUT_NAME_MAX] = '\0';
    CHECK(taut_curve_new(name, basis, &points[0][0], NULL, &curve, &error) == TAUT_OK,
          "a name of the largest size");
    taut_curve_free(curve);
    taut_basis_free(basis);
}

/* Raised from 120 to 128 and not further. */
static void test_elevate(void)
{
    enum { DEGREE = TAUT_DEGREE_MAX - 8 };
    double points[DEGREE + 1][3];
    taut_curve *curve = NULL, *raised = NULL;
    taut_error error = {.status = TAUT_OK};
    for (int i = 0; i <= DEGREE; i++) {
        points[i][0] = i;
        points[i][1] = points[i][2] = 0;
    }
    curve = shape_curve(shape_bezier(DEGREE, 0, 1), &points[0][0], NULL);
    taut_status status = taut_curve_elevate(curve, 9, &raised, &error);
    check_refused("elevate", status, TAUT_BAD_ARGUMENT, &error, 8, raised);
    CHECK(taut_curve_elevate(curve, 8, &raised, &error) == TAUT_OK, "to the largest degree");
    taut_curve_free(raised);
    taut_curve_free(curve);
}

/* One model takes so many curves and no more; the one too many stays the caller's. */
static void test_objects(void)
{
    static const double points[2][3] = {{0, 0, 0}, {1, 0, 0}};
    taut_model *model = NULL;
    taut_curve *curve = shape_curve(shape_bezier(1, 0, 1), &points[0][0], NULL), *copy = NULL;
    taut_status status = taut_model_new(&model);
    for (int i = 0; i < TAUT_OBJECTS_MAX && status == TAUT_OK; i++) {
        status = taut_curve_copy(curve, &copy);
        if (status == TAUT_OK) {
            status = taut_model_add_curve(model, copy);
        }
    }
    CHECK(status == TAUT_OK, "as many as the limit: status %d", (int)status);
    CHECK(taut_model_add_curve(model, curve) != TAUT_OK, "one more is taken");
    CHECK(taut_model_curve_count(model) == TAUT_OBJECTS_MAX, "%d curves",
          taut_model_curve_count(model));
    taut_curve_free(curve);
    taut_model_free(model);
}

static void test_orders(void)
{
    static const double points[2][3] = {{0, 0, 0}, {1, 0, 0}};
    double values[TAUT_ORDER_MAX + 2][3] = {{7}};
    taut_curve *curve = shape_curve(shape_bezier(1, 0, 1), &points[0][0], NULL);
    CHECK(taut_curve_eval(curve, 0.5, TAUT_ORDER_MAX + 1, &values[0][0]) == TAUT_BAD_ARGUMENT &&
              values[0][0] == 7,
          "an order past the largest");
    CHECK(taut_curve_eval(curve, 0.5, TAUT_ORDER_MAX, &values[0][0]) == TAUT_OK, "the largest");
    taut_curve_free(curve);
}

int main(void)
{
    test_points();
    test_counts();
    test_name();
    test_elevate();
    test_objects();
    test_orders();
    return check_failures != 0;
}
