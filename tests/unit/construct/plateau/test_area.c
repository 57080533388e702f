/* test_area.c -- the operators of the area against differences of what they derive from, by every
 * set of kernels that this machine runs; with and without weights, cells that fill no vector. */
#include "check.h"
#include "shapes.h"

#include "construct/plateau/area.h"
#include "numeric/kernel/kernel.h"

#include <stdlib.h>
#include <string.h>

enum { SIDE = 7, POINTS = SIDE * SIDE, NUMBERS = 3 * POINTS };

static double dot(const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < NUMBERS; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

static void shift(const double *net, double t, const double *d, double *moved)
{
    for (int i = 0; i < NUMBERS; i++) {
        moved[i] = net[i] + t * d[i];
    }
}

/* d.H d and d.L d of construct/plateau/area.h; central differences are good to h^2 and rounding over
 * h. */
static void check_operators(taut_area_functional *functional, const double *net, const double *d,
                            const char *what)
{
    const double h = 1e-5, along = 1e-8;
    double moved[NUMBERS], g[NUMBERS], up[NUMBERS], down[NUMBERS], hd[NUMBERS], ld[NUMBERS];
    double mixed[NUMBERS];

    shift(net, h, d, moved);
    const double more = taut_area_functional_gradient(functional, moved, up).area;
    shift(net, -h, d, moved);
    const double less = taut_area_functional_gradient(functional, moved, down).area;
    const taut_area_value value = taut_area_functional_gradient(functional, net, g);
    CHECK_NEAR(taut_area_functional_value(functional, net).area, value.area, 1e-14 * value.area,
               "%s", what);
    CHECK_NEAR(dot(g, d), (more - less) / (2 * h), along * value.area, "%s", what);
    taut_area_functional_product(functional, 0, d, hd);
    taut_area_functional_product(functional, 1, d, ld);
    taut_area_functional_product(functional, 0.25, d, mixed);
    for (int i = 0; i < NUMBERS; i++) {
        CHECK_NEAR(hd[i], (up[i] - down[i]) / (2 * h), along, "%s: H, %d", what, i);
        CHECK_NEAR(mixed[i], 0.75 * hd[i] + 0.25 * ld[i], 1e-13, "%s: B, %d", what, i);
    }
    /* L is the area's own quadratic form at the net itself: x . L x = 2 A, L x = dA (7.1) */
    taut_area_functional_product(functional, 1, net, ld);
    CHECK_NEAR(dot(net, ld), 2 * value.area, 1e-12 * value.area, "%s: x.L x", what);
    for (int i = 0; i < NUMBERS; i++) {
        CHECK_NEAR(ld[i], g[i], 1e-13, "%s: L x, %d", what, i);
    }
}

static void check_kernels(const char *name, int trials)
{
    char what[64];
    if (setenv("TAUT_KERNEL", name, 1) != 0 || strcmp(taut_area_ops_chosen()->name, name) != 0) {
        return; /* not on this machine */
    }
    for (int trial = 0; trial < trials; trial++) {
        taut_basis *u = shape_bspline(1 + trial % 5, SIDE), *v = shape_bspline(5 - trial % 4, SIDE);
        double net[NUMBERS], d[NUMBERS], weights[POINTS];
        taut_area_functional *functional = NULL;
        for (int i = 0; i < POINTS; i++) {
            net[3 * i] = i / SIDE + random_in(-0.2, 0.2);
            net[3 * i + 1] = i % SIDE + random_in(-0.2, 0.2);
            net[3 * i + 2] = random_in(-1, 1);
            weights[i] = random_log(0.5, 2);
        }
        for (int i = 0; i < NUMBERS; i++) {
            d[i] = random_in(-1, 1);
        }
        snprintf(what, sizeof what, "%s, trial %d", name, trial);
        CHECK(taut_area_functional_new(u, v, trial % 2 ? weights : NULL, trial % 4, &functional) ==
                  TAUT_OK,
              "%s", what);
        if (functional != NULL) {
            check_operators(functional, net, d, what);
        }
        taut_area_functional_free(functional);
        taut_basis_free(u);
        taut_basis_free(v);
    }
}

/* Values, gradients and products of every kernel are the same, bit for bit. */
static void check_same(int trials)
{
    static const char *const kernels[] = {"baseline", "avx2", "avx512"};
    for (int trial = 0; trial < trials; trial++) {
        taut_basis *u = shape_bspline(1 + trial % 5, SIDE), *v = shape_bspline(5 - trial % 4, SIDE);
        double net[NUMBERS], weights[POINTS], made[3][2 * NUMBERS + 1];
        for (int i = 0; i < NUMBERS; i++) {
            net[i] = random_in(-1, 1);
        }
        for (int i = 0; i < POINTS; i++) {
            weights[i] = random_log(0.5, 2);
        }
        for (int k = 0; k < 3; k++) {
            taut_area_functional *functional = NULL;
            setenv("TAUT_KERNEL", kernels[k], 1);
            CHECK(taut_area_functional_new(u, v, trial % 2 ? weights : NULL, trial % 4,
                                           &functional) == TAUT_OK,
                  "%s", kernels[k]);
            if (functional != NULL) {
                made[k][0] = taut_area_functional_gradient(functional, net, made[k] + 1).area;
                taut_area_functional_product(functional, 0.3, net, made[k] + 1 + NUMBERS);
                CHECK(memcmp(made[0], made[k], sizeof made[0]) == 0, "%s differs from baseline",
                      kernels[k]);
            }
            taut_area_functional_free(functional);
        }
        taut_basis_free(u);
        taut_basis_free(v);
    }
    unsetenv("TAUT_KERNEL");
}

int main(void)
{
    random_seed(7);
    check_kernels("baseline", random_trials(20));
    check_kernels("avx2", random_trials(20));
    check_kernels("avx512", random_trials(20));
    check_same(random_trials(20));
    return check_failures != 0;
}
