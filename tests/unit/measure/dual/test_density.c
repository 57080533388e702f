/* test_density.c -- the gap place by place: its integral is the gap, and what is no witness has none.
 */
#include "check.h"
#include "problems.h"

#include "construct/plateau/witness.h"
#include "core/vec3.h"
#include "measure/dual/density.h"
#include "numeric/quadrature.h"
#include "taut/plateau.h"

#include <math.h>

enum { NODES = 9 };

/* iint d |x_u x x_v| and iint |x_u x x_v| by Gauss nodes on each span. */
static void integrate(const taut_surface *surface, const taut_dual_density *density, double sum[2])
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double *at_u = taut_basis_breaks(u), *at_v = taut_basis_breaks(v);
    double node[NODES], weight[NODES], jet[9], normal[3];

    taut_gauss_rule(NODES, node, weight);
    sum[0] = sum[1] = 0;
    for (int i = 0; i < taut_basis_span_count(u); i++) {
        for (int j = 0; j < taut_basis_span_count(v); j++) {
            const double du = at_u[i + 1] - at_u[i], dv = at_v[j + 1] - at_v[j];
            for (int g = 0; g < NODES * NODES; g++) {
                const double s = at_u[i] + du * (0.5 + 0.5 * node[g / NODES]);
                const double t = at_v[j] + dv * (0.5 + 0.5 * node[g % NODES]);
                CHECK(taut_surface_eval(surface, s, t, 1, jet) == TAUT_OK, "eval");
                taut_cross(jet + 3, jet + 6, normal);
                const double part =
                    0.25 * weight[g / NODES] * weight[g % NODES] * du * dv * taut_norm(normal);
                sum[0] += part * taut_dual_density_at(density, s, t);
                sum[1] += part;
            }
        }
    }
}

static void test_integral(void)
{
    test_problem net = problem_tetrahedron(9);
    const taut_plateau_problem problem = {.net = net.data};
    taut_model *model = NULL;
    taut_plateau_witness *witness = NULL;
    taut_dual_density *density = NULL;
    double sum[2];

    CHECK(taut_plateau_make(&problem, NULL, &model, NULL) == TAUT_OK, "film");
    const taut_surface *film = taut_model_surface(model, 0);
    CHECK(taut_plateau_witness_new(film, NULL, &witness) == TAUT_OK && witness != NULL, "witness");
    CHECK(taut_dual_density_new(film, taut_model_details(model), &density) == TAUT_OK &&
              density != NULL,
          "density");
    integrate(film, density, sum);
    CHECK_NEAR(sum[0] / sum[1], witness->gap, 1e-2 * witness->gap, "the integral is the gap");
    CHECK(sum[0] > 0 && sum[0] < 1e-8, "%g", sum[0]);
    CHECK(isnan(taut_dual_density_at(density, 7, 0)), "beside the film");
    taut_dual_density_free(density);
    taut_plateau_witness_free(witness);
    taut_model_free(model);
    problem_free(&net);
}

static void test_none(void)
{
    test_problem net = problem_tetrahedron(5);
    const taut_plateau_problem problem = {.net = net.data};
    taut_model *model = NULL;
    taut_record *details = taut_record_new();
    taut_dual_density *density = NULL;

    CHECK(taut_plateau_make(&problem, NULL, &model, NULL) == TAUT_OK, "film");
    const taut_surface *film = taut_model_surface(model, 0);
    const taut_record *least = taut_record_get(taut_model_details(model), "least");
    CHECK(taut_dual_density_new(film, NULL, &density) == TAUT_OK && density == NULL, "no details");
    taut_record *forged = taut_record_add_object(details, "least");
    for (size_t k = 0; k < taut_record_count(least); k++) { /* whole only with the last member */
        CHECK(taut_dual_density_new(film, details, &density) == TAUT_OK && density == NULL,
              "%zu members", k);
        taut_record_add_record(forged, taut_record_key(least, k), taut_record_at(least, k));
    }
    CHECK(taut_dual_density_new(film, details, &density) == TAUT_OK && density != NULL, "all");
    taut_dual_density_free(density);
    taut_record_free(details);
    taut_model_free(model);
    problem_free(&net);
}

int main(void)
{
    test_integral();
    test_none();
    return check_failures != 0;
}
