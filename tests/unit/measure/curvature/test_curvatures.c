/* test_curvatures.c -- H, K and normals over grids, against the closed forms of known surfaces on
 * the bases that hold them exactly. */
#include "check.h"
#include "shapes.h"

#include "core/constants.h"
#include "taut/measure.h"

#include <stddef.h>
#include <string.h>

enum { GRID = 9, COUNT_MAX = 12 };

/* Coefficients of the functions 1, t, s, c along one direction: s, c are sin, cos or sinh, cosh. */
typedef struct direction {
    taut_basis *basis;
    int count;
    double t[COUNT_MAX], s[COUNT_MAX], c[COUNT_MAX];
} direction;

/* On a window: phi, phi + k phi', phi - k phi', phi at its ends ([XuWang2006] section 3). */
static void bezier_coefficients(double lo, double length, int hyperbolic, direction *d)
{
    const double hi = lo + length;
    const double k = hyperbolic ? (length - sinh(length)) / (1 - cosh(length))
                                : (length - sin(length)) / (1 - cos(length));
    const double sign = hyperbolic ? 1 : -1;
    const double s[2] = {hyperbolic ? sinh(lo) : sin(lo), hyperbolic ? sinh(hi) : sin(hi)};
    const double c[2] = {hyperbolic ? cosh(lo) : cos(lo), hyperbolic ? cosh(hi) : cos(hi)};
    d->count = 4;
    for (int end = 0; end < 2; end++) {
        const int at = end == 0 ? 0 : 3, next = end == 0 ? 1 : 2;
        const double step = end == 0 ? k : -k;
        d->t[at] = end == 0 ? lo : hi;
        d->s[at] = s[end];
        d->c[at] = c[end];
        d->t[next] = d->t[at] + step;
        d->s[next] = s[end] + step * c[end];
        d->c[next] = c[end] + step * sign * s[end];
    }
}

/* X_i, A sin X_i, A cos X_i, A = a / sin a, at the knots and one more at either end (section 4). */
static void bspline_coefficients(double lo, double length, int segments, int hyperbolic,
                                 direction *d)
{
    const double a = length / (hyperbolic ? sinh(length) : sin(length));
    d->count = segments + 3;
    for (int i = 0; i < d->count; i++) {
        const double x = lo + (i - 1) * length;
        d->t[i] = x;
        d->s[i] = a * (hyperbolic ? sinh(x) : sin(x));
        d->c[i] = a * (hyperbolic ? cosh(x) : cos(x));
    }
}

/* A window of random place and length; on a spline or not. */
static direction random_direction(int hyperbolic)
{
    static const char *const types[4] = {"c-bezier", "c-bspline", "h-bezier", "h-bspline"};
    const int spline = random_int(0, 1), segments = spline ? random_int(1, 6) : 1;
    const double length = random_in(0.5, hyperbolic ? 1.5 : spline ? 1.2 : TAUT_PI);
    const double lo = random_in(-1.5, 0.5);
    direction d = {.basis = NULL};
    taut_basis_spec spec = {.type = types[2 * hyperbolic + spline], .has_range = 1};
    spec.range[0] = lo;
    spec.range[1] = lo + segments * length;
    spec.segments = spline ? segments : 0;
    *(hyperbolic ? &spec.beta : &spec.alpha) = length;
    d.basis = shape_basis(&spec);
    if (spline) {
        bspline_coefficients(lo, length, segments, hyperbolic, &d);
    } else {
        bezier_coefficients(lo, length, hyperbolic, &d);
    }
    return d;
}

/* What a surface has at (u, v); H by the sign of r_u x r_v. */
typedef struct closed_form {
    double mean, gaussian;
} closed_form;

typedef closed_form (*closed)(double u, double v, double size);

/* Bit for bit, but for what pads a struct. */
static int same(int count, const taut_forms *a, const taut_forms *b)
{
    int equal = 1;
    for (int i = 0; i < count; i++) {
        equal &= memcmp(&a[i], &b[i], offsetof(taut_forms, regular)) == 0;
        equal &= a[i].regular == b[i].regular;
    }
    return equal;
}

/* H and K at one place within `tolerance` of the largest curvature squared there. */
static void check_forms(const taut_forms *forms, closed_form expected, double tolerance,
                        const char *what, double u, double v)
{
    const double k = expected.gaussian, h = expected.mean;
    const double largest = fabs(h) + sqrt(fmax(0, h * h - k)); /* principal curvature */
    CHECK(forms->regular, "%s at %g, %g", what, u, v);
    CHECK_NEAR(forms->mean, h, tolerance * largest, "%s: H at %g, %g", what, u, v);
    CHECK_NEAR(forms->gaussian, k, tolerance * largest * largest, "%s: K at %g, %g", what, u, v);
}

/* The same at places in no order: row i at the parameters of column i, and its mirror image. */
static void check_places(const taut_surface *s, double at[2][GRID], closed form, double size,
                         double tolerance, const char *what)
{
    taut_forms found[2 * GRID], again[2 * GRID];
    double u[2 * GRID], v[2 * GRID];
    for (int i = 0; i < GRID; i++) {
        u[i] = u[GRID + i] = at[0][i];
        v[i] = at[1][i];
        v[GRID + i] = at[1][GRID - 1 - i];
    }
    CHECK(taut_surface_forms_points(s, 2 * GRID, u, v, 1, found) == TAUT_OK, "%s", what);
    CHECK(taut_surface_forms_points(s, 2 * GRID, u, v, 3, again) == TAUT_OK, "%s", what);
    CHECK(same(2 * GRID, found, again), "the same for any number of threads");
    for (int i = 0; i < 2 * GRID; i++) {
        check_forms(&found[i], form(u[i], v[i], size), tolerance, what, u[i], v[i]);
    }
}

/* H and K on a grid, and at places in no order. */
static void check_grid(taut_surface *s, closed form, double size, double tolerance,
                       const char *what)
{
    const taut_basis *u = taut_surface_u(s), *v = taut_surface_v(s);
    static taut_forms all[3][GRID][GRID];
    double at[2][GRID];
    for (int i = 0; i < GRID; i++) {
        const double part = i / (GRID - 1.0);
        at[0][i] = i == GRID - 1 ? taut_basis_hi(u)
                                 : taut_basis_lo(u) + part * (taut_basis_hi(u) - taut_basis_lo(u));
        at[1][i] = i == GRID - 1 ? taut_basis_hi(v)
                                 : taut_basis_lo(v) + part * (taut_basis_hi(v) - taut_basis_lo(v));
    }
    for (int threads = 1; threads <= 3; threads++) {
        CHECK(taut_surface_forms_grid(s, GRID, at[0], GRID, at[1], threads,
                                      &all[threads - 1][0][0]) == TAUT_OK,
              "%s", what);
    }
    CHECK(same(GRID * GRID, all[0][0], all[1][0]) && same(GRID * GRID, all[0][0], all[2][0]),
          "the same for any number of threads");
    for (int i = 0; i < GRID; i++) {
        for (int j = 0; j < GRID; j++) {
            check_forms(&all[0][i][j], form(at[0][i], at[1][j], size), tolerance, what, at[0][i],
                        at[1][j]);
        }
    }
    check_places(s, at, form, size, tolerance, what);
    taut_surface_free(s);
}

static closed_form of_catenoid(double u, double v, double size)
{
    (void)u;
    (void)size;
    return (closed_form){0, -pow(cosh(v), -4)};
}

static closed_form of_enneper(double u, double v, double size)
{
    (void)size;
    return (closed_form){0, -4 * pow(1 + u * u + v * v, -4)};
}

/* z = c x y, W^2 = 1 + c^2 (x^2 + y^2): H = -c^3 x y / W^3, K = -c^2 / W^4. */
static closed_form of_saddle(double u, double v, double c)
{
    const double w2 = 1 + c * c * (u * u + v * v);
    return (closed_form){-c * c * c * u * v / pow(w2, 1.5), -c * c / (w2 * w2)};
}

/* (cos u cosh v, sin u cosh v, v), or the helicoid (sinh v sin u, -sinh v cos u, u), its conjugate:
 * the same metric, so the same K. */
static taut_surface *minimal(int conjugate)
{
    direction u = random_direction(0), v = random_direction(1);
    double points[COUNT_MAX * COUNT_MAX][3];
    for (int i = 0; i < u.count; i++) {
        for (int j = 0; j < v.count; j++) {
            double *p = points[i * v.count + j];
            p[0] = conjugate ? u.s[i] * v.s[j] : u.c[i] * v.c[j];
            p[1] = conjugate ? -u.c[i] * v.s[j] : u.s[i] * v.c[j];
            p[2] = conjugate ? u.t[i] : v.t[j];
        }
    }
    return shape_surface(u.basis, v.basis, points[0], NULL);
}

/* Derivatives are good to 1e-14 of the largest of their order (taut/basis.h), which is at most some
 * 20 times that at a point on these lengths, each of at least 1/2; twice that for the forms. Seen:
 * 4e-14. */
static void test_minimal_surfaces(void)
{
    for (int trial = 0; trial < random_trials(300); trial++) {
        check_grid(minimal(0), of_catenoid, 0, 2e-13, "catenoid");
        check_grid(minimal(1), of_catenoid, 0, 2e-13, "helicoid");
    }
}

static void test_polynomials(void)
{
    for (int trial = 0; trial < random_trials(300); trial++) {
        const double u = random_in(-2, 1), v = random_in(-2, 1), c = random_log(0.1, 10);
        check_grid(shape_enneper(u, u + random_in(0.5, 2), v, v + random_in(0.5, 2)), of_enneper, 0,
                   2e-13, "Enneper");
        check_grid(shape_saddle(c), of_saddle, c, 2e-14, "hyperbolic paraboloid");
    }
}

/* Many rows on many threads, each as the point by itself; what is out of range is refused. */
static void test_grid(void)
{
    enum { ROWS = 131, COLUMNS = 7 };
    taut_surface *s = shape_enneper(0, 1, 0, 1);
    double u[ROWS], v[COLUMNS];
    static taut_forms forms[ROWS][COLUMNS], again[ROWS][COLUMNS];
    for (int i = 0; i < ROWS; i++) {
        u[i] = i / (ROWS - 1.0);
    }
    for (int j = 0; j < COLUMNS; j++) {
        v[j] = j / (COLUMNS - 1.0);
    }
    CHECK(taut_surface_forms_grid(s, ROWS, u, COLUMNS, v, 0, &forms[0][0]) == TAUT_OK, "one");
    CHECK(taut_surface_forms_grid(s, ROWS, u, COLUMNS, v, 8, &again[0][0]) == TAUT_OK, "eight");
    CHECK(same(ROWS * COLUMNS, forms[0], again[0]), "the same for any number of threads");
    for (int i = 0; i < ROWS; i++) {
        for (int j = 0; j < COLUMNS; j++) {
            double x[6][3];
            taut_forms one;
            CHECK(taut_surface_eval(s, u[i], v[j], 2, &x[0][0]) == TAUT_OK, "%d %d", i, j);
            taut_forms_of((const double(*)[3])x, &one);
            CHECK_NEAR(forms[i][j].gaussian, one.gaussian, 1e-13, "%d %d", i, j);
            CHECK_NEAR(forms[i][j].normal[0], one.normal[0], 1e-14, "%d %d", i, j);
        }
    }
    CHECK(taut_surface_forms_grid(s, 0, u, COLUMNS, v, 1, &again[0][0]) == TAUT_OK, "empty");
    u[ROWS - 1] = 1.01;
    CHECK(taut_surface_forms_grid(s, ROWS, u, COLUMNS, v, 1, &again[0][0]) == TAUT_BAD_ARGUMENT,
          "out of range");
    CHECK(taut_surface_forms_grid(NULL, ROWS, u, COLUMNS, v, 1, &again[0][0]) == TAUT_BAD_ARGUMENT,
          "NULL");
    CHECK(taut_surface_forms_grid(s, 1, u, -1, v, 1, &again[0][0]) == TAUT_BAD_ARGUMENT, "count");
    CHECK(same(ROWS * COLUMNS, forms[0], again[0]), "outputs are untouched on failure");
    taut_surface_free(s);
}

/* Normals of a rational surface: those of the sphere are its points. The first is at a pole, where
 * there is none. A place out of range is refused before anything is written. */
static void test_places(void)
{
    enum { COUNT = 40 };
    taut_surface *s = shape_octant(2);
    double u[COUNT], v[COUNT], x[COUNT][3];
    taut_forms forms[COUNT], before;
    int poles = 0;
    for (int i = 0; i < COUNT; i++) {
        u[i] = i == 0 ? 1 : random_in(0, 0.9);
        v[i] = i == 0 ? 1 : random_in(0, 0.9);
    }
    CHECK(taut_surface_forms_points(s, COUNT, u, v, 2, forms) == TAUT_OK, "sphere");
    CHECK(taut_surface_eval_points(s, COUNT, u, v, 0, 2, x[0]) == TAUT_OK, "sphere");
    for (int i = 0; i < COUNT; i++) {
        double along = 0;
        for (int c = 0; c < 3; c++) {
            along += forms[i].normal[c] * x[i][c] / 2;
        }
        poles += !forms[i].regular;
        CHECK(forms[i].regular ? fabs(fabs(along) - 1) < 1e-13 : isnan(along), "at %g %g: %.17g",
              u[i], v[i], along);
        CHECK(!forms[i].regular || fabs(forms[i].gaussian - 0.25) < 1e-12, "K = %.17g",
              forms[i].gaussian);
    }
    CHECK(poles <= 1, "%d places have no normal", poles);
    before = forms[0];
    v[COUNT - 1] = nextafter(1, 2);
    CHECK(taut_surface_forms_points(s, COUNT, u, v, 1, forms) == TAUT_BAD_ARGUMENT, "range");
    CHECK(taut_surface_forms_points(s, COUNT, v, u, 1, forms) == TAUT_BAD_ARGUMENT, "range");
    CHECK(taut_surface_forms_points(s, -1, u, u, 1, forms) == TAUT_BAD_ARGUMENT, "count");
    CHECK(taut_surface_forms_points(s, 1, u, NULL, 1, forms) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(taut_surface_forms_points(s, 0, u, u, 1, forms) == TAUT_OK, "none");
    CHECK(same(1, &before, forms), "outputs are untouched on failure");
    taut_surface_free(s);
}

int main(void)
{
    random_seed(20260716);
    test_minimal_surfaces();
    test_polynomials();
    test_grid();
    test_places();
    return check_failures != 0;
}
