/* test_stress.c -- the stress of threads place by place: it does the work that the certificate's energy is, by another basis on
 * ranges of its own; films without threads have none. */
#include "check.h"
#include "sails.h"

#include "core/vec3.h"
#include "measure/film/stress.h"
#include "numeric/quadrature.h"

#include <math.h>

enum { NODES = 9, COUNT = 12, DEGREE = 4, SPANS = COUNT - DEGREE };

/* A basis over [lo, hi]. */
static taut_basis *spline_over(double lo, double hi)
{
    double knots[COUNT + DEGREE + 1];
    const taut_basis_spec spec = {
        .type = "bspline", .degree = DEGREE, .knots = knots, .knot_count = COUNT + DEGREE + 1};
    taut_basis *basis = NULL;

    for (int k = 0; k < spec.knot_count; k++) {
        const double share = fmin(fmax((double)(k - DEGREE) / SPANS, 0), 1);
        knots[k] = lo + (hi - lo) * share;
    }
    CHECK(taut_basis_new(&spec, COUNT, &basis, NULL) == TAUT_OK, "[%g, %g]", lo, hi);
    return basis;
}

/* 1/2 iint (along + across) |x_u| |x_v| du dv: what threads of these forces per width have stored, for a constant second stress. */
static double stored(const taut_surface *surface, const double densities[2])
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double *at_u = taut_basis_breaks(u), *at_v = taut_basis_breaks(v);
    double node[NODES], weight[NODES], sum = 0;

    taut_gauss_rule(NODES, node, weight);
    for (int k = 0; k < SPANS * SPANS * NODES * NODES; k++) {
        const int i = k / (SPANS * NODES * NODES), j = k / (NODES * NODES) % SPANS;
        const int g = k / NODES % NODES, h = k % NODES;
        const double du = at_u[i + 1] - at_u[i], dv = at_v[j + 1] - at_v[j];
        double jet[TAUT_SURFACE_VECTORS(2)][3], stress[2];
        taut_forms forms;
        CHECK(taut_surface_eval(surface, at_u[i] + du * (0.5 + 0.5 * node[g]),
                                at_v[j] + dv * (0.5 + 0.5 * node[h]), 2, jet[0]) == TAUT_OK,
              "eval");
        taut_forms_of((const double(*)[3])jet, &forms);
        taut_stress_of(surface, densities, &forms, stress);
        sum += 0.25 * weight[g] * weight[h] * du * dv * 0.5 * (stress[0] + stress[1]) *
               taut_norm(jet[TAUT_XU]) * taut_norm(jet[TAUT_XV]);
    }
    return sum;
}

static void test_work(void)
{
    const double given[2] = {3, 1.5};
    sail s = sail_new(DEGREE, COUNT, sail_saddle, 0);
    taut_certificate *proof = NULL;
    double densities[2] = {0, 0};

    taut_basis_free(s.u);
    taut_basis_free(s.v);
    s.problem.u = s.u = spline_over(2, 5);
    s.problem.v = s.v = spline_over(-1, -0.25);
    for (int d = 0; d < 2; d++) {
        s.problem.force_density[d] = given[d];
    }
    for (int e = 0; e < 2; e++) {
        s.problem.edges[e] = (taut_film_edge){.kind = TAUT_FILM_CABLE, .force = 4};
    }
    taut_model *model = sail_make(&s, &proof);
    CHECK(!taut_stress_densities(model, taut_model_surface(model, 0), densities),
          "without a certificate");
    const double cables = 4 * (sail_figure(proof, "lengths", 0) + sail_figure(proof, "lengths", 1));
    const double energy =
        taut_record_number(taut_record_get(taut_certificate_figures(proof), "energy"));
    taut_model_set_certificate(model, proof);
    CHECK(taut_stress_densities(model, taut_model_surface(model, 0), densities), "densities");
    CHECK(densities[0] == given[0] && densities[1] == given[1], "%g %g", densities[0],
          densities[1]);
    CHECK_NEAR(stored(taut_model_surface(model, 0), densities) / (energy - cables), 1, 1e-13,
               "%.17g", energy - cables);
    taut_model_free(model);
    sail_free(&s);
}

static void test_none(void)
{
    sail s = sail_new(DEGREE, COUNT, sail_square, 2);
    taut_certificate *proof = NULL;
    taut_model *model = sail_make(&s, &proof);
    double densities[2], stress[2];
    taut_forms forms = {.e = 0, .g = 1};

    taut_model_set_certificate(model, proof);
    CHECK(!taut_stress_densities(model, taut_model_surface(model, 0), densities),
          "a film of one tension");
    taut_stress_of(taut_model_surface(model, 0), (const double[2]){1, 1}, &forms, stress);
    CHECK(isnan(stress[0]) && isnan(stress[1]), "where x_u is 0: %g %g", stress[0], stress[1]);
    taut_model_free(model);
    sail_free(&s);
}

int main(void)
{
    test_work();
    test_none();
    return check_failures != 0;
}
