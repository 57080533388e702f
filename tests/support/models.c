#include "models.h"

#include "check.h"

#include <stdlib.h>
#include <string.h>

double any_number(void)
{
    static const double edges[] = {0.0, -0.0, 1e308, -1e308, 0x1p-1074, -0x1p-1022, 0.1, 1e15};
    const int pick = random_int(0, 11);
    double x = 0;
    if (pick < 4) {
        return random_in(-10, 10);
    }
    if (pick < 8) {
        return edges[random_int(0, 7)];
    }
    do {
        const uint64_t bits = random_bits();
        memcpy(&x, &bits, sizeof x);
    } while (!isfinite(x));
    return x;
}

/* A Bezier basis with or without a range, or a B-spline on uneven knots. */
static taut_basis *any_basis(void)
{
    taut_basis_spec spec = {.type = "bezier", .degree = random_int(1, 5)};
    taut_basis *basis = NULL;
    double knots[32];
    const int inner = random_int(0, 6);
    int n = 0;

    if (random_int(0, 1) == 0) {
        spec.has_range = random_int(0, 1);
        spec.range[0] = spec.has_range ? random_in(-5, 0) : 0;
        spec.range[1] = spec.has_range ? random_in(0.1, 5) : 0;
    } else {
        spec.type = "bspline";
        for (int i = 0; i <= spec.degree; i++) {
            knots[n++] = -0.125;
        }
        for (int i = 0; i < inner; i++) {
            knots[n++] = i + random_in(0, 0.9);
        }
        for (int i = 0; i <= spec.degree; i++) {
            knots[n++] = 7.1;
        }
        spec.knots = knots;
        spec.knot_count = n;
    }
    CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "basis of degree %d", spec.degree);
    return basis;
}

static double *any_numbers(int count)
{
    double *numbers = malloc(sizeof(double) * (size_t)count);
    for (int i = 0; i < count; i++) {
        numbers[i] = any_number();
    }
    return numbers;
}

static double *any_weights(int count)
{
    double *weights = any_numbers(count);
    for (int i = 0; i < count; i++) {
        weights[i] = weights[i] == 0 ? 1 : fabs(weights[i]);
    }
    return weights;
}

/* Takes the bases and the numbers over. */
static void add_surface(taut_model *model, const char *name, taut_basis *u, taut_basis *v,
                        double *points, double *weights)
{
    taut_surface *surface = NULL;
    CHECK(taut_surface_new(name, u, v, points, weights, &surface, NULL) == TAUT_OK, "surface");
    CHECK(taut_model_add_surface(model, surface) == TAUT_OK, "add");
    taut_basis_free(u);
    taut_basis_free(v);
    free(points);
    free(weights);
}

static void add_curve(taut_model *model, const char *name, taut_basis *t, double *points,
                      double *weights)
{
    taut_curve *curve = NULL;
    CHECK(taut_curve_new(name, t, points, weights, &curve, NULL) == TAUT_OK, "curve");
    CHECK(taut_model_add_curve(model, curve) == TAUT_OK, "add");
    taut_basis_free(t);
    free(points);
    free(weights);
}

void add_any_surface(taut_model *model, const char *name)
{
    taut_basis *u = any_basis(), *v = any_basis();
    const int count = taut_basis_count(u) * taut_basis_count(v);
    double *points = any_numbers(3 * count);
    add_surface(model, name, u, v, points, random_int(0, 1) ? any_weights(count) : NULL);
}

void add_any_curve(taut_model *model, const char *name)
{
    taut_basis *t = any_basis();
    const int count = taut_basis_count(t);
    double *points = any_numbers(3 * count);
    add_curve(model, name, t, points, random_int(0, 1) ? any_weights(count) : NULL);
}

/* Knots with every multiplicity up to the degree, or a bezier basis. */
static taut_basis *some_basis(void)
{
    taut_basis_spec spec = {.type = "bezier", .degree = random_int(1, random_int(0, 19) ? 5 : 25)};
    taut_basis *basis = NULL;
    double knots[200], t = random_in(-2, 2);
    int n = 0;
    if (random_int(0, 2) == 0) {
        spec.has_range = 1;
        spec.range[0] = random_in(-5, 0);
        spec.range[1] = random_in(0.1, 5);
    } else {
        const int inner = random_int(0, 5);
        spec.type = "bspline";
        for (int k = 0; k <= inner + 1; k++) {
            const int times = k == 0 || k > inner ? spec.degree + 1 : random_int(1, spec.degree);
            for (int i = 0; i < times; i++) {
                knots[n++] = t;
            }
            t += random_in(0.01, 1);
        }
        spec.knots = knots;
        spec.knot_count = n;
    }
    CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "basis of degree %d", spec.degree);
    return basis;
}

double *numbers_in(int count, double lo, double hi)
{
    double *numbers = malloc(sizeof(double) * (size_t)count);
    for (int i = 0; i < count; i++) {
        numbers[i] = random_in(lo, hi);
    }
    return numbers;
}

void add_some_surface(taut_model *model, const char *name)
{
    taut_basis *u = some_basis(), *v = some_basis();
    const int count = taut_basis_count(u) * taut_basis_count(v);
    double *points = numbers_in(3 * count, -10, 10);
    add_surface(model, name, u, v, points, random_int(0, 1) ? numbers_in(count, 0.1, 3) : NULL);
}

void add_some_curve(taut_model *model, const char *name)
{
    taut_basis *t = some_basis();
    const int count = taut_basis_count(t);
    double *points = numbers_in(3 * count, -10, 10);
    add_curve(model, name, t, points, random_int(0, 1) ? numbers_in(count, 0.1, 3) : NULL);
}

static int same_numbers(int count, const double *a, const double *b)
{
    if (a == NULL || b == NULL) {
        return a == b;
    }
    return memcmp(a, b, sizeof(double) * (size_t)count) == 0;
}

static int same_basis(const taut_basis *a, const taut_basis *b)
{
    const int spans = taut_basis_span_count(a);
    return taut_basis_equal(a, b) &&
           same_numbers(spans + 1, taut_basis_breaks(a), taut_basis_breaks(b));
}

int same_surface(const taut_surface *a, const taut_surface *b)
{
    const taut_basis *u = taut_surface_u(a), *v = taut_surface_v(a);
    const int count = taut_basis_count(u) * taut_basis_count(v);
    return strcmp(taut_surface_name(a), taut_surface_name(b)) == 0 &&
           same_basis(u, taut_surface_u(b)) && same_basis(v, taut_surface_v(b)) &&
           same_numbers(3 * count, taut_surface_points(a), taut_surface_points(b)) &&
           same_numbers(count, taut_surface_weights(a), taut_surface_weights(b));
}

int same_curve(const taut_curve *a, const taut_curve *b)
{
    const int count = taut_basis_count(taut_curve_t(a));
    return strcmp(taut_curve_name(a), taut_curve_name(b)) == 0 &&
           same_basis(taut_curve_t(a), taut_curve_t(b)) &&
           same_numbers(3 * count, taut_curve_points(a), taut_curve_points(b)) &&
           same_numbers(count, taut_curve_weights(a), taut_curve_weights(b));
}

const taut_surface *surface_named(const taut_model *model, const char *name)
{
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        if (strcmp(taut_surface_name(taut_model_surface(model, i)), name) == 0) {
            return taut_model_surface(model, i);
        }
    }
    return NULL;
}

const taut_curve *curve_named(const taut_model *model, const char *name)
{
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        if (strcmp(taut_curve_name(taut_model_curve(model, i)), name) == 0) {
            return taut_model_curve(model, i);
        }
    }
    return NULL;
}
