/* test_grid.c -- the grid against single points, on every kernel, for any degree, weights, number
 * of threads, and places of the result in memory. */
#include "check.h"

#include "geometry/grid_kernel.h"
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

static void parameters(const taut_basis *basis, int n, double *t)
{
    for (int i = 0; i < n; i++) {
        const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
        t[i] = i == 0 ? lo : i == n - 1 ? hi : random_in(lo, hi);
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
        for (int trial = 0; trial < 12; trial++) {
            taut_surface *surface = random_surface(trial % 2);
            for (int order = 0; order <= 2; order++) {
                compare(surface, order, 1 + trial % 3, trial % 4, random_int(2, NV));
            }
            taut_surface_free(surface);
        }
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

/* The interleaving past the caches writes what the plain one does: streaming is forced here, as it
 * takes large results to come about by itself. */
static void test_streaming(void)
{
    static double planes[18 * TAUT_GRID_STRIDE], plain[128 * 18 + 4], streamed[128 * 18 + 4];
    const taut_grid_ops *ops = taut_grid_ops_chosen();
    for (int i = 0; i < 18 * TAUT_GRID_STRIDE; i++) {
        planes[i] = i;
    }
    for (int vectors = 1; vectors <= 6; vectors += vectors == 1 ? 2 : 3) {
        for (int shift = 0; shift < 4; shift++) {
            ops->interleave(vectors, 3, 127, planes, 0, plain + shift);
            ops->interleave(vectors, 3, 127, planes, 1, streamed + shift);
            ops->fence();
            CHECK(memcmp(plain + shift, streamed + shift,
                         (size_t)(127 * vectors * 3) * sizeof(double)) == 0,
                  "vectors=%d shift=%d", vectors, shift);
        }
    }
}

int main(void)
{
    random_seed(20260103);
    test_kernels();
    test_threads();
    test_streaming();
    return check_failures != 0;
}
