#include "shapes.h"

#include "check.h"

#include <stdlib.h>
#include <string.h>

taut_basis *shape_basis(const taut_basis_spec *spec)
{
    taut_basis *basis = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_basis_new(spec, 0, &basis, &error) == TAUT_OK, "basis: %s", error.message);
    return basis;
}

taut_basis *shape_bezier(int degree, double lo, double hi)
{
    const taut_basis_spec spec = {
        .type = "bezier", .degree = degree, .has_range = 1, .range = {lo, hi}};
    return shape_basis(&spec);
}

taut_basis *shape_bspline(int degree, int count)
{
    const taut_basis_spec spec = {.type = "bspline", .degree = degree, .count = count};
    return shape_basis(&spec);
}

taut_surface *shape_surface(taut_basis *u, taut_basis *v, const double *points,
                            const double *weights)
{
    taut_surface *surface = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_surface_new("shape", u, v, points, weights, &surface, &error) == TAUT_OK,
          "surface: %s", error.message);
    taut_basis_free(u);
    taut_basis_free(v);
    return surface;
}

taut_curve *shape_curve(taut_basis *t, const double *points, const double *weights)
{
    taut_curve *curve = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_curve_new("shape", t, points, weights, &curve, &error) == TAUT_OK, "curve: %s",
          error.message);
    taut_basis_free(t);
    return curve;
}

taut_model *shape_model(taut_surface *surface)
{
    taut_model *model = NULL;
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    CHECK(surface == NULL || taut_model_add_surface(model, surface) == TAUT_OK, "add");
    return model;
}

/* The blossom of t^k at degree - i times lo and i times hi: the k-th elementary symmetric function
 * of these over C(degree, k). */
void shape_bernstein(int degree, int terms, const double *c, double lo, double hi, double *b)
{
    for (int i = 0; i <= degree; i++) {
        double e[64] = {1};
        double binomial = 1;
        for (int a = 0; a < degree; a++) {
            for (int k = a + 1; k > 0; k--) {
                e[k] += e[k - 1] * (a < degree - i ? lo : hi);
            }
        }
        b[i] = 0;
        for (int k = 0; k < terms; k++) {
            b[i] += c[k] * e[k] / binomial;
            binomial = binomial * (degree - k) / (k + 1);
        }
    }
}

taut_surface *shape_enneper(double u0, double u1, double v0, double v1)
{
    double u[4][4], v[4][4], points[4][4][3];
    for (int k = 0; k < 4; k++) {
        double c[4] = {0, 0, 0, 0};
        c[k] = 1;
        shape_bernstein(3, 4, c, u0, u1, u[k]);
        shape_bernstein(3, 4, c, v0, v1, v[k]);
    }
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            points[i][j][0] = u[1][i] - u[3][i] / 3 + u[1][i] * v[2][j];
            points[i][j][1] = -v[1][j] - u[2][i] * v[1][j] + v[3][j] / 3;
            points[i][j][2] = u[2][i] - v[2][j];
        }
    }
    return shape_surface(shape_bezier(3, u0, u1), shape_bezier(3, v0, v1), &points[0][0][0], NULL);
}

/* The nine points (cos, sin) and weights of a whole circle in quarters. */
static const double circle[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                    {-1, -1}, {0, -1}, {1, -1}, {1, 0}};

static double circle_weight(int i)
{
    return i % 2 == 0 ? 1 : sqrt(0.5);
}

static taut_basis *quarters(int count)
{
    double knots[12] = {0, 0, 0};
    taut_basis_spec spec = {.type = "bspline", .degree = 2};
    spec.knot_count = 2 * count + 4;
    for (int k = 3; k < spec.knot_count; k++) {
        knots[k] = (k - 1) / 2 < count ? (double)((k - 1) / 2) : count;
    }
    spec.knots = knots;
    return shape_basis(&spec);
}

taut_surface *shape_torus(double large, double small)
{
    double points[9][9][3], weights[9][9];
    for (int i = 0; i < 9; i++) {
        for (int j = 0; j < 9; j++) {
            const double r = large + small * circle[j][0];
            points[i][j][0] = r * circle[i][0];
            points[i][j][1] = r * circle[i][1];
            points[i][j][2] = small * circle[j][1];
            weights[i][j] = circle_weight(i) * circle_weight(j);
        }
    }
    return shape_surface(quarters(4), quarters(4), &points[0][0][0], &weights[0][0]);
}

taut_surface *shape_sphere(double radius)
{
    static const double half[5][2] = {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}};
    double points[9][5][3], weights[9][5];
    for (int i = 0; i < 9; i++) {
        for (int j = 0; j < 5; j++) {
            points[i][j][0] = radius * half[j][0] * circle[i][0];
            points[i][j][1] = radius * half[j][0] * circle[i][1];
            points[i][j][2] = radius * half[j][1];
            weights[i][j] = circle_weight(i) * circle_weight(j);
        }
    }
    return shape_surface(quarters(4), quarters(2), &points[0][0][0], &weights[0][0]);
}

taut_surface *shape_octant(double radius)
{
    const double w[3] = {1, sqrt(0.5), 1};
    double points[9][3], weights[9];
    for (int k = 0; k < 9; k++) {
        const int i = k / 3, j = k % 3;
        points[k][0] = radius * circle[i][0] * circle[j][0];
        points[k][1] = radius * circle[i][1] * circle[j][0];
        points[k][2] = radius * circle[j][1];
        weights[k] = w[i] * w[j];
    }
    return shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), points[0], weights);
}

taut_surface *shape_far_net(const double middle[3])
{
    double points[9][3], weights[9];
    for (int k = 0; k < 9; k++) {
        points[k][0] = k / 3 - 1.0;
        points[k][1] = k % 3 - 1.0;
        points[k][2] = 0;
        weights[k] = k == 4 ? 1e-9 : 1;
    }
    memcpy(points[4], middle, sizeof points[4]);
    return shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), points[0], weights);
}

taut_surface *shape_cylinder(double radius, double height, int degree)
{
    double points[9 * 32][3], weights[9 * 32];
    for (int i = 0; i < 9; i++) {
        for (int j = 0; j <= degree; j++) {
            double *x = points[i * (degree + 1) + j];
            x[0] = radius * circle[i][0];
            x[1] = radius * circle[i][1];
            x[2] = height * j / degree;
            weights[i * (degree + 1) + j] = circle_weight(i);
        }
    }
    return shape_surface(quarters(4), shape_bezier(degree, 0, 1), points[0], weights);
}

taut_surface *shape_saddle(double c)
{
    const double points[4][3] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, c}};
    return shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), points[0], NULL);
}

taut_surface *shape_random(int degree_u, int degree_v, int rational)
{
    const int nu = degree_u + random_int(1, 5), nv = degree_v + random_int(1, 5);
    double *points = malloc((size_t)(nu * nv) * 3 * sizeof(double));
    double *weights = malloc((size_t)(nu * nv) * sizeof(double));
    taut_surface *surface = NULL;
    for (int k = 0; k < nu * nv; k++) {
        points[3 * k] = (double)(k / nv) / (nu - 1) + random_in(-0.1, 0.1);
        points[3 * k + 1] = (double)(k % nv) / (nv - 1) + random_in(-0.1, 0.1);
        points[3 * k + 2] = random_in(-0.3, 0.3);
        weights[k] = random_log(0.5, 2);
    }
    surface = shape_surface(shape_bspline(degree_u, nu), shape_bspline(degree_v, nv), points,
                            rational ? weights : NULL);
    free(points);
    free(weights);
    return surface;
}

static taut_basis *copy_of(const taut_basis *basis)
{
    taut_basis *copy = NULL;
    CHECK(taut_basis_copy(basis, &copy) == TAUT_OK, "copy");
    return copy;
}

taut_surface *shape_moved(const taut_surface *surface, double scale, const double rotation[3][3],
                          const double shift[3])
{
    const int count =
        taut_basis_count(taut_surface_u(surface)) * taut_basis_count(taut_surface_v(surface));
    const double *x = taut_surface_points(surface);
    double *points = malloc((size_t)count * 3 * sizeof(double));
    taut_surface *moved = NULL;
    for (int k = 0; k < count; k++) {
        for (int r = 0; r < 3; r++) {
            points[3 * k + r] = scale * (rotation[r][0] * x[3 * k] + rotation[r][1] * x[3 * k + 1] +
                                         rotation[r][2] * x[3 * k + 2]) +
                                shift[r];
        }
    }
    moved = shape_surface(copy_of(taut_surface_u(surface)), copy_of(taut_surface_v(surface)),
                          points, taut_surface_weights(surface));
    free(points);
    return moved;
}

/* The same surface with the net rearranged: point (i, j) comes from `from(i, j)`. */
static taut_surface *rearranged(const taut_surface *surface, taut_basis *u, taut_basis *v,
                                int transpose)
{
    const int nu = taut_basis_count(u), nv = taut_basis_count(v);
    const double *x = taut_surface_points(surface), *w = taut_surface_weights(surface);
    double *points = malloc((size_t)(nu * nv) * 3 * sizeof(double));
    double *weights = malloc((size_t)(nu * nv) * sizeof(double));
    taut_surface *made = NULL;
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const int from = transpose ? j * nu + i : (nu - 1 - i) * nv + j;
            memcpy(points + 3 * (i * nv + j), x + 3 * from, 3 * sizeof(double));
            weights[i * nv + j] = w != NULL ? w[from] : 1;
        }
    }
    made = shape_surface(u, v, points, w != NULL ? weights : NULL);
    free(points);
    free(weights);
    return made;
}

taut_surface *shape_transposed(const taut_surface *surface)
{
    return rearranged(surface, copy_of(taut_surface_v(surface)), copy_of(taut_surface_u(surface)),
                      1);
}

/* Knots mirrored; the range stays. */
taut_surface *shape_reversed(const taut_surface *surface)
{
    taut_basis_spec spec;
    double knots[256];
    taut_basis_spec_of(taut_surface_u(surface), &spec);
    if (spec.knots != NULL) {
        const double ends = spec.knots[0] + spec.knots[spec.knot_count - 1];
        for (int k = 0; k < spec.knot_count; k++) {
            knots[k] = ends - spec.knots[spec.knot_count - 1 - k];
        }
        spec.knots = knots;
    }
    return rearranged(surface, shape_basis(&spec), copy_of(taut_surface_v(surface)), 0);
}

/* Gram and Schmidt on random vectors. */
void shape_rotation(double rotation[3][3])
{
    for (int r = 0; r < 3; r++) {
        double norm = 0;
        while (norm < 1e-2) {
            norm = 0;
            for (int c = 0; c < 3; c++) {
                rotation[r][c] = random_in(-1, 1);
            }
            for (int q = 0; q < r; q++) {
                const double *a = rotation[q];
                const double *b = rotation[r];
                const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
                for (int c = 0; c < 3; c++) {
                    rotation[r][c] -= dot * a[c];
                }
            }
            for (int c = 0; c < 3; c++) {
                norm += rotation[r][c] * rotation[r][c];
            }
        }
        for (int c = 0; c < 3; c++) {
            rotation[r][c] /= sqrt(norm);
        }
    }
}

double shape_apart(const taut_surface *a, const taut_surface *b, double *largest)
{
    const int count = 3 * taut_basis_count(taut_surface_u(a)) * taut_basis_count(taut_surface_v(a));
    const double *p = taut_surface_points(a), *q = taut_surface_points(b);
    double most = 0;
    *largest = 0;
    for (int k = 0; k < count; k++) {
        *largest = fmax(*largest, fabs(p[k]));
        most = fmax(most, fabs(p[k] - q[k]));
    }
    return most;
}

taut_surface *shape_strip(void)
{
    double points[7][2][3];
    const double ring[7][2] = {{1, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}, {1, 0}};
    for (int i = 0; i < 7; i++) {
        const double angle = acos(-1) * i / 6;
        for (int j = 0; j < 2; j++) {
            const double out = (2 * j - 1) * 0.4;
            const double z = out * sin(angle);
            points[i][j][0] = ring[i][0] * (1 + (i % 6 == 0 ? 1 : 0.5) * out * cos(angle));
            points[i][j][1] = ring[i][1];
            points[i][j][2] = i % 6 == 0 ? 0 : z;
        }
    }
    return shape_surface(shape_bezier(6, 0, 1), shape_bezier(1, 0, 1), &points[0][0][0], NULL);
}
