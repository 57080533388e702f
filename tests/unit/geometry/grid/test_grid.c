/* test_grid.c -- the grid against single points, on every kernel, for any degree, weights, number
 * of threads, and places of the result in memory. */
#include "check.h"

#include "taut/surface.h"

#include <stdlib.h>
#include <string.h>

enum { NU = 23, NV = 301, ROOM = NU * NV * 18 + 8 };

static taut_basis *random_basis(void)
{
    double knots[400];
    const int degree = random_int(1, 6), spans = random_int(1, 30);
    taut_basis_spec spec = {.type = "bspline", .degree = degree, .knots = knots};
    taut_basis *basis = NULL;
    double t = random_in(-1, 1);
    int n = 0;
    for (int i = 0; i <= degree; i++) {
        knots[n++] = t;
    }
    for (int s = 0; s < spans; s++) {
        t += random_log(1e-2, 1);
        for (int i = s + 1 < spans ? random_int(degree > 1 ? 1 - degree / 2 : 0, 0) : -degree;
             i <= 0; i++) {
            knots[n++] = t;
        }
    }
    spec.knot_count = n;
    CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "basis");
    return basis;
}

static taut_surface *random_surface(int rational)
{
    taut_basis *u = random_basis(), *v = random_basis();
    const int n = taut_basis_count(u) * taut_basis_count(v);
    double *points = malloc((size_t)n * 3 * sizeof(double));
    double *weights = malloc((size_t)n * sizeof(double));
    taut_surface *surface = NULL;
    for (int i = 0; i < 3 * n; i++) {
        points[i] = random_in(-1, 1);
    }
    for (int i = 0; i < n; i++) {
        weights[i] = random_in(0.5, 2);
    }
    CHECK(taut_surface_new("", u, v, points, rational ? weights : NULL, &surface, NULL) == TAUT_OK,
          "surface");
    free(points);
    free(weights);
    taut_basis_free(u);
    taut_basis_free(v);
    return surface;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* In order, as grids have them: with a knot in few groups of the kernels or, where the points are
 * few, in most; or one after another at random. */
static void parameters(const taut_basis *basis, int n, double *t)
{
    for (int i = 0; i < n; i++) {
        const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
        t[i] = i == 0 ? lo : i == n - 1 ? hi : random_in(lo, hi);
    }
    if (random_int(0, 2) > 0) {
        qsort(t, (size_t)n, sizeof *t, ascending);
    }
}

/* Sums of at most 7 x 7 terms in either order: a few dozen roundings of the largest value met. */
static void compare(const taut_surface *surface, int order, int threads, int shift, int nv)
{
    static double u[NU], v[NV], grid[ROOM];
    const int vectors = TAUT_SURFACE_VECTORS(order);
    double size[6] = {0};
    double *values = grid + shift;
    parameters(taut_surface_u(surface), NU, u);
    parameters(taut_surface_v(surface), nv, v);
    grid[(size_t)shift + (size_t)(NU * nv * vectors * 3)] = 12345;
    CHECK(taut_surface_eval_grid(surface, NU, u, nv, v, order, threads, values) == TAUT_OK, "grid");
    CHECK(values[NU * nv * vectors * 3] == 12345, "nothing is written past the end");
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < NU * nv; i++) {
            double one[18];
            CHECK(taut_surface_eval(surface, u[i / nv], v[i % nv], order, one) == TAUT_OK, "one");
            for (int c = 0; c < 3 * vectors; c++) {
                if (pass == 0) {
                    size[c / 3] = fmax(size[c / 3], fabs(one[c]));
                } else if (!(fabs(values[3 * vectors * i + c] - one[c]) <= 4e-13 * size[c / 3])) {
                    CHECK(0, "order=%d i=%d c=%d found %.17g expected %.17g", order, i, c,
                          values[3 * vectors * i + c], one[c]);
                    return;
                }
            }
        }
    }
}

static void test_kernels(void)
{
    static const char *const kernels[] = {"baseline", "avx2", "avx512"};
    for (int k = 0; k < 3; k++) {
        setenv("TAUT_KERNEL", kernels[k], 1);
        for (int trial = 0; trial < 18; trial++) {
            taut_surface *surface = random_surface(trial % 2);
            for (int order = 0; order <= 2; order++) {
                compare(surface, order, 1 + trial % 3, trial % 4,
                        trial % 3 ? random_int(2, NV) : random_int(2, 12));
            }
            taut_surface_free(surface);
        }
    }
    unsetenv("TAUT_KERNEL");
}

/* Every kernel gives the same numbers, bit for bit. */
static void test_same_kernels(void)
{
    static const char *const kernels[] = {"baseline", "avx2", "avx512"};
    static double u[NU], v[NV], first[ROOM], other[ROOM];
    for (int trial = 0; trial < 12; trial++) {
        taut_surface *surface = random_surface(trial % 2);
        const int order = trial % 3;
        const size_t size =
            (size_t)NU * NV * (size_t)TAUT_SURFACE_VECTORS(order) * 3 * sizeof(double);
        parameters(taut_surface_u(surface), NU, u);
        parameters(taut_surface_v(surface), NV, v);
        for (int k = 0; k < 3; k++) {
            double *values = k == 0 ? first : other;
            setenv("TAUT_KERNEL", kernels[k], 1);
            CHECK(taut_surface_eval_grid(surface, NU, u, NV, v, order, 1, values) == TAUT_OK,
                  "grid");
            CHECK(memcmp(first, values, size) == 0, "%s: trial %d, order %d", kernels[k], trial,
                  order);
        }
        taut_surface_free(surface);
    }
    unsetenv("TAUT_KERNEL");
}

/* Any number of threads gives the same numbers, bit for bit. */
static void test_threads(void)
{
    static double u[NU], v[NV], one[ROOM], many[ROOM];
    taut_surface *surface = random_surface(1);
    parameters(taut_surface_u(surface), NU, u);
    parameters(taut_surface_v(surface), NV, v);
    taut_surface_eval_grid(surface, NU, u, NV, v, 2, 1, one);
    for (int threads = 2; threads <= 7; threads++) {
        taut_surface_eval_grid(surface, NU, u, NV, v, 2, threads, many);
        CHECK(memcmp(one, many, (size_t)NU * NV * 18 * sizeof(double)) == 0, "threads=%d", threads);
    }
    taut_surface_free(surface);
}

/* Results large enough to go past the caches are the same numbers, wherever they lie in memory:
 * each row is what a grid of that row alone gives, which is too small for such stores. */
static void test_streaming(void)
{
    enum { LINES = 800 };
    static double u[LINES], v[NV], row[NV * 18];
    double *values = malloc(((size_t)LINES * NV * 18 + 8) * sizeof(double));
    taut_surface *surface = random_surface(1);
    parameters(taut_surface_u(surface), LINES, u);
    parameters(taut_surface_v(surface), NV, v);
    for (int order = 0; order <= 2; order++) {
        const size_t numbers = (size_t)NV * (size_t)(3 * TAUT_SURFACE_VECTORS(order));
        for (int shift = 0; shift < 8; shift++) {
            const int nv = NV - shift;
            const size_t count = numbers / NV * (size_t)nv;
            CHECK(taut_surface_eval_grid(surface, LINES, u, nv, v, order, 2, values + shift) ==
                      TAUT_OK,
                  "large");
            for (int i = 0; i < LINES; i += 61) {
                taut_surface_eval_grid(surface, 1, u + i, nv, v, order, 1, row);
                CHECK(memcmp(row, values + shift + (size_t)i * count, count * sizeof *row) == 0,
                      "order=%d shift=%d i=%d", order, shift, i);
            }
        }
    }
    free(values);
    taut_surface_free(surface);
}

int main(void)
{
    random_seed(20260103);
    test_kernels();
    test_same_kernels();
    test_threads();
    test_streaming();
    return check_failures != 0;
}
