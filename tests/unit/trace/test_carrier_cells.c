/* test_carrier_cells.c -- cells as polynomials against the bases' own values, inside cells and beyond. */
#include "check.h"
#include "core/arena.h"
#include "trace/carrier_cells.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COUNT = 10, TRIALS = 40 };

static double net[COUNT * COUNT * 4];

/* d^i/du^i d^j/dv^j of a component by the bases. */
static double by_bases(const taut_basis *const basis[2], const int span[2], const double at[2],
                       int i, int j, int c)
{
    double u[4 * 8], v[4 * 8], sum = 0;
    const int local_u = taut_basis_local(basis[0]), local_v = taut_basis_local(basis[1]);
    const double *points = net;
    taut_basis_eval(basis[0], span[0], at[0], i, u);
    taut_basis_eval(basis[1], span[1], at[1], j, v);
    for (int a = 0; a < local_u; a++) {
        for (int b = 0; b < local_v; b++) {
            const int64_t row = taut_basis_first(basis[0], span[0]) + a;
            const int64_t column = taut_basis_first(basis[1], span[1]) + b;
            sum += u[i * local_u + a] * v[j * local_v + b] *
                   points[4 * (row * taut_basis_count(basis[1]) + column) + c];
        }
    }
    return sum;
}

/* Uneven knots, a double one among them where it may be. */
static taut_basis *spline(int degree)
{
    const double inner[] = {0.2, 0.25, 0.6, degree > 1 ? 0.6 : 0.7};
    double knots[20];
    taut_basis *basis = NULL;
    const int count = degree + 5;
    for (int k = 0; k < count + degree + 1; k++) {
        knots[k] = k <= degree ? -1 : k >= count ? 1 : inner[k - degree - 1];
    }
    const taut_basis_spec spec = {
        .type = "bspline", .degree = degree, .knot_count = count + degree + 1, .knots = knots};
    const taut_status status = taut_basis_new(&spec, count, &basis, NULL);
    CHECK(status == TAUT_OK, "degree %d", degree);
    return basis;
}

/* The same bits by the loops of every processor. */
static void compare_kernels(taut_arena *arena, const taut_basis *const basis[2])
{
    static const char *const kernels[3] = {"baseline", "avx2", "avx512"};
    for (int order = 0; order <= 3; order++) {
        double x[3][10][3] = {{{0}}}, weights[3][10] = {{0}};
        const double at[2] = {random_in(-1, 0.2), random_in(-1, 0.2)};
        for (int k = 0; k < 3; k++) {
            const taut_carrier_cells *cells = NULL;
            setenv("TAUT_KERNEL", kernels[k], 1); /* one that is not there is passed over */
            taut_carrier_cells_new(arena, basis, net, &cells);
            taut_carrier_cells_at(cells, (int[2]){0, 0}, at, order, x[k], weights[k]);
        }
        unsetenv("TAUT_KERNEL");
        for (int k = 1; k < 3; k++) {
            CHECK(memcmp(x[0], x[k], sizeof x[0]) == 0, "%s, order %d", kernels[k], order);
            CHECK(memcmp(weights[0], weights[k], sizeof weights[0]) == 0, "%s, order %d",
                  kernels[k], order);
        }
    }
}

static void compare(taut_arena *arena, int p, int q)
{
    taut_basis *made[2] = {spline(p), spline(q)};
    const taut_basis *const basis[2] = {made[0], made[1]};
    const taut_carrier_cells *cells = NULL;

    CHECK(taut_carrier_cells_new(arena, basis, net, &cells) == TAUT_OK && cells != NULL,
          "degrees %d, %d", p, q);
    for (int trial = 0; trial < TRIALS; trial++) {
        double x[10][3], weights[10], at[2];
        int span[2];
        for (int d = 0; d < 2; d++) {
            const double *breaks = taut_basis_breaks(basis[d]);
            span[d] = random_int(0, taut_basis_span_count(basis[d]) - 1);
            at[d] = random_in(breaks[span[d]], breaks[span[d] + 1]);
        }
        taut_carrier_cells_at(cells, span, at, trial % 4, x, weights);
        for (int i = 0; i <= trial % 4; i++) {
            for (int j = 0; i + j <= trial % 4; j++) {
                for (int c = 0; c < 4; c++) {
                    const double want = by_bases(basis, span, at, i, j, c);
                    /* derivatives grow with the narrowest span, 0.05 */
                    const int n = (i + j) * (i + j + 1) / 2 + j;
                    CHECK_NEAR(c < 3 ? x[n][c] : weights[n], want,
                               1e-13 * pow(100, i + j) + 1e-13 * fabs(want),
                               "degrees %d, %d: %d, %d", p, q, i, j);
                }
            }
        }
    }
    compare_kernels(arena, basis);
    taut_basis_free(made[0]);
    taut_basis_free(made[1]);
}

/* Too high a degree, or no polynomials: no cells, and no failure. */
static void test_none(taut_arena *arena)
{
    const taut_basis_spec specs[] = {{.type = "bezier", .degree = 6},
                                     {.type = "ce-bezier", .alpha = 0.5, .beta = 0.5}};
    for (int k = 0; k < 2; k++) {
        taut_basis *high = NULL, *low = spline(2);
        const taut_carrier_cells *cells = NULL;
        CHECK(taut_basis_new(&specs[k], k == 0 ? 7 : 0, &high, NULL) == TAUT_OK, "%d", k);
        const taut_basis *const basis[2] = {low, high};
        CHECK(taut_carrier_cells_new(arena, basis, net, &cells) == TAUT_OK, "%d", k);
        CHECK(cells == NULL, "%d", k);
        taut_basis_free(high);
        taut_basis_free(low);
    }
}

int main(void)
{
    taut_arena *arena = taut_arena_new();
    random_seed(1);
    for (int i = 0; i < COUNT * COUNT * 4; i++) {
        net[i] = random_in(-1, 1);
    }
    for (int p = 1; p <= 5; p++) {
        for (int q = 1; q <= 5; q++) {
            compare(arena, p, q);
        }
    }
    test_none(arena);
    taut_arena_free(arena);
    return check_failures != 0;
}
