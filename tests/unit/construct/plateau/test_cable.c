/* test_cable.c -- the length of a cable, its gradient and its operators against differences, and
 * the Hessian of a functional with cables against its product. */
#include "check.h"

#include "construct/plateau/area.h"
#include "construct/plateau/hessian_band.h"

#include <string.h>

enum { SIDE = 7, NUMBERS = 3 * SIDE * SIDE };

static void shift(const double *net, double t, const double *d, double *moved)
{
    for (int i = 0; i < NUMBERS; i++) {
        moved[i] = net[i] + t * d[i];
    }
}

static double dot(const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < NUMBERS; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

static void random_net(double *net, double *d)
{
    for (int i = 0; i < SIDE; i++) {
        for (int j = 0; j < SIDE; j++) {
            for (int c = 0; c < 3; c++) {
                net[3 * (i * SIDE + j) + c] = (c == 0 ? i : c == 1 ? j : 0) + random_in(-0.3, 0.3);
                d[3 * (i * SIDE + j) + c] = random_in(-1, 1);
            }
        }
    }
}

static void test_length(const taut_basis *basis, taut_arena *arena)
{
    const double h = 1e-5;
    double net[NUMBERS], d[NUMBERS], moved[NUMBERS], g[NUMBERS] = {0}, up[NUMBERS] = {0},
                                                     down[NUMBERS] = {0}, hd[NUMBERS] = {0},
                                                     ld[NUMBERS] = {0};
    taut_area_cable cable;

    CHECK(taut_area_cable_new(basis, 3, SIDE - 1, SIDE, arena, &cable) == TAUT_OK, "cable");
    cable.tension = 2.5;
    random_net(net, d);
    shift(net, h, d, moved);
    const double more = taut_area_cable_gradient(&cable, moved, up);
    shift(net, -h, d, moved);
    const double less = taut_area_cable_gradient(&cable, moved, down);
    const double length = taut_area_cable_gradient(&cable, net, g);
    CHECK_NEAR(taut_area_cable_length(&cable, net), length, 1e-14 * length, "length");
    CHECK_NEAR(dot(g, d), 2.5 * (more - less) / (2 * h), 1e-8 * length, "gradient");
    taut_area_cable_product(&cable, 0, d, hd);
    taut_area_cable_product(&cable, 1, d, ld);
    for (int i = 0; i < NUMBERS; i++) {
        CHECK_NEAR(hd[i], (up[i] - down[i]) / (2 * h), 1e-6, "product %d", i);
    }
    shift(net, 1, d, moved);
    CHECK(2.5 * taut_area_cable_length(&cable, moved) <=
              2.5 * length + dot(g, d) + 0.5 * dot(ld, d) + 1e-12,
          "the metric bounds the length from above");
    CHECK(dot(ld, d) >= dot(hd, d), "and the second derivative");
}

/* A cable that gives way: C' = p, C'' = k, nothing where it is slack. */
static void test_law(const taut_basis *basis, taut_arena *arena)
{
    const double h = 1e-5;
    double net[NUMBERS], d[NUMBERS], moved[NUMBERS], g[NUMBERS] = {0}, up[NUMBERS] = {0},
                                                     down[NUMBERS] = {0}, hd[NUMBERS] = {0};
    taut_area_cable cable;

    CHECK(taut_area_cable_new(basis, 3, SIDE - 1, SIDE, arena, &cable) == TAUT_OK, "cable");
    random_net(net, d);
    cable.stiffness = 3;
    cable.base = 0.5;
    cable.target = 0.8 * taut_area_cable_length(&cable, net);
    shift(net, h, d, moved);
    const double more = taut_area_cable_energy(&cable, taut_area_cable_gradient(&cable, moved, up));
    shift(net, -h, d, moved);
    const double less =
        taut_area_cable_energy(&cable, taut_area_cable_gradient(&cable, moved, down));
    const double length = taut_area_cable_gradient(&cable, net, g);
    CHECK_NEAR(cable.tension, 0.5 + 3 * 0.2 * length, 1e-13 * length, "force");
    CHECK_NEAR(dot(g, d), (more - less) / (2 * h), 1e-7 * length, "gradient");
    taut_area_cable_product(&cable, 0, d, hd);
    for (int i = 0; i < NUMBERS; i++) {
        CHECK_NEAR(hd[i], (up[i] - down[i]) / (2 * h), 1e-5, "product %d", i);
    }
    cable.target = 2 * length;
    memset(g, 0, sizeof g);
    CHECK(taut_area_cable_energy(&cable, taut_area_cable_gradient(&cable, net, g)) == 0, "slack");
    taut_area_cable_product(&cable, 0, d, g);
    CHECK(dot(g, g) == 0, "slack");
}

/* B^-1 (B d) = d, with the matrix on one side and the product on the other. */
static void test_hessian(const taut_basis *basis, int gives_way, taut_arena *arena)
{
    const double theta = 0.5;
    double net[NUMBERS], d[NUMBERS], g[NUMBERS], image[NUMBERS];
    unsigned char known[SIDE * SIDE] = {0};
    taut_area_cable cables[2];
    taut_area_functional *functional = NULL;
    taut_area_hessian *hessian = NULL;
    taut_mask mask;

    random_net(net, d);
    for (int k = 0; k < SIDE; k++) { /* two edges held, two drawn */
        known[k] = known[k * SIDE] = 1;
        memset(d + 3 * k, 0, 3 * sizeof(double));
        memset(d + 3 * k * SIDE, 0, 3 * sizeof(double));
    }
    CHECK(taut_area_functional_new(basis, basis, NULL, 2, &functional) == TAUT_OK &&
              taut_mask_new(SIDE, SIDE, known, arena, &mask) == TAUT_OK &&
              taut_area_cable_new(basis, 3, SIDE - 1, SIDE, arena, &cables[0]) == TAUT_OK &&
              taut_area_cable_new(basis, 3, (SIDE - 1) * SIDE, 1, arena, &cables[1]) == TAUT_OK,
          "parts");
    cables[0].tension = 3;
    cables[1].tension = 0.5;
    for (int k = 0; gives_way && k < 2; k++) { /* with these forces at this net */
        cables[k].stiffness = 5 + k;
        cables[k].base = cables[k].tension;
        cables[k].target = taut_area_cable_length(&cables[k], net);
    }
    const double area = taut_area_functional_value(functional, net).area;
    functional->cables = cables;
    functional->cable_count = 2;
    CHECK(taut_area_hessian_new(functional, &mask, &hessian) == TAUT_OK, "matrix");
    const double all = taut_area_functional_gradient(functional, net, g).area;
    CHECK_NEAR(all,
               area + taut_area_cable_energy(&cables[0], taut_area_cable_length(&cables[0], net)) +
                   taut_area_cable_energy(&cables[1], taut_area_cable_length(&cables[1], net)),
               1e-13 * all, "value");
    CHECK_NEAR(cables[0].tension + cables[1].tension, 3.5, 1e-12, "forces");
    taut_area_functional_product(functional, theta, d, image);
    taut_area_hessian_assemble(hessian, functional);
    if (taut_area_hessian_factor(hessian, theta) == TAUT_OK) {
        taut_area_hessian_solve(hessian, image);
        for (int i = 0; i < NUMBERS; i++) {
            CHECK_NEAR(image[i], d[i], 1e-8, "number %d", i);
        }
    } else {
        CHECK(0, "half the metric operator leaves it indefinite");
    }
    taut_area_hessian_free(hessian);
    taut_area_functional_free(functional);
}

int main(void)
{
    const taut_basis_spec spec = {.type = "bspline", .degree = 3, .count = SIDE};
    taut_basis *basis = NULL;
    taut_arena *arena = taut_arena_new();

    random_seed(1);
    CHECK(taut_basis_new(&spec, SIDE, &basis, NULL) == TAUT_OK, "basis");
    for (int k = 0; k < 5; k++) {
        test_length(basis, arena);
        test_law(basis, arena);
        test_hessian(basis, 0, arena);
        test_hessian(basis, 1, arena);
    }
    taut_basis_free(basis);
    taut_arena_free(arena);
    return check_failures != 0;
}
