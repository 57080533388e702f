#include "pipes.h"
#include "certificates.h"

#include "check.h"

#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <string.h>

taut_model *pipe_made(const taut_pipe_problem *problem, double tolerance)
{
    const taut_make_options options = {.tolerance = tolerance};
    taut_error error = {.message = ""};
    taut_model *model = NULL;
    CHECK(taut_pipe_make(problem, &options, &model, &error) == TAUT_OK, "%s %s", error.where,
          error.message);
    return model;
}

taut_certificate *pipe_proved(const taut_model *model, const taut_pipe_problem *problem,
                              double tolerance)
{
    const taut_certify_options options = {.tolerance = tolerance};
    taut_certificate *certificate = NULL;
    CHECK(taut_pipe_certify(model, problem, &options, &certificate, NULL) == TAUT_OK, "proved");
    return certificate;
}

taut_error pipe_refused(const taut_pipe_problem *problem, taut_status status, const char *reason)
{
    taut_error error = {.message = ""};
    taut_model *model = NULL;
    CHECK(taut_pipe_make(problem, NULL, &model, &error) == status &&
              strcmp(error.reason, reason) == 0 && model == NULL,
          "%s: %s %s %s", reason, error.reason, error.where, error.message);
    taut_model_free(model);
    return error;
}

taut_verdict pipe_verdict(const taut_model *model, const taut_pipe_problem *problem,
                          const char *name)
{
    taut_certificate *certificate = pipe_proved(model, problem, 1e-6);
    const taut_verdict holds = claim_of(certificate, name)->holds;
    taut_certificate_free(certificate);
    return holds;
}

taut_pipe_problem pipe_random_ends(void)
{
    const taut_pipe_problem problem = {
        .axis = {.kind = TAUT_PIPE_ENDS,
                 .ends = {{{random_in(-1, 1), random_in(-1, 1), random_in(-1, 1)},
                           {random_in(-1, 1), random_in(-1, 1), 2},
                           random_in(2, 3)},
                          {{random_in(4, 5), random_in(-1, 1), random_in(5, 6)},
                           {random_in(1, 2), random_in(-1, 1), random_in(-1, 1)},
                           random_in(2, 3)}}},
        .shape = {.alpha = random_in(-1, 1), .gamma = random_in(-1, 1)},
    };
    return problem;
}

void pipe_integrate(const taut_surface *surface, double *area, double *volume)
{
    enum { G = 12 };
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    double nodes[G], weights[G];
    taut_gauss_rule(G, nodes, weights);
    for (int i = 0; i < taut_basis_span_count(u) * taut_basis_span_count(v); i++) {
        const double *bu = taut_basis_breaks(u) + i / taut_basis_span_count(v);
        const double *bv = taut_basis_breaks(v) + i % taut_basis_span_count(v);
        for (int k = 0; k < G * G; k++) {
            double x[3][3], normal[3];
            const double w =
                0.25 * (bu[1] - bu[0]) * (bv[1] - bv[0]) * weights[k / G] * weights[k % G];
            taut_surface_eval(surface, bu[0] + (bu[1] - bu[0]) * 0.5 * (1 + nodes[k / G]),
                              bv[0] + (bv[1] - bv[0]) * 0.5 * (1 + nodes[k % G]), 1, x[0]);
            taut_cross(x[TAUT_XV], x[TAUT_XU], normal); /* x_u x x_v looks at the axis */
            *area += w * taut_norm(normal);
            *volume += w * taut_dot(x[0], normal) / 3;
        }
    }
}

double pipe_end_volume(const double point[3], const double direction[3], double area)
{
    return taut_dot(point, direction) / taut_norm(direction) * area / 3;
}

double pipe_volume(const taut_model *model, const taut_pipe_problem *problem,
                   const double end_areas[2], double *area)
{
    double volume = 0;
    *area = 0;
    pipe_integrate(taut_model_surface(model, 0), area, &volume);
    for (int side = 0; side < 2; side++) {
        const taut_pipe_end *end = &problem->axis.ends[side];
        volume +=
            (side == 0 ? -1 : 1) * pipe_end_volume(end->point, end->direction, end_areas[side]);
    }
    return volume;
}
