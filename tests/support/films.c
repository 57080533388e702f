#include "films.h"

#include "check.h"

#include "taut/measure.h"

#include <string.h>

taut_plateau_problem film_problem(const test_problem *net, taut_plateau_method method)
{
    taut_plateau_problem problem;
    memset(&problem, 0, sizeof problem);
    problem.net = net->data;
    problem.method = method;
    return problem;
}

double film_proved_area(const taut_model *model, const taut_plateau_problem *problem,
                        const char *what)
{
    taut_certificate *certificate = NULL;
    taut_error error = {0};
    double area = nan("");

    CHECK(taut_surface_area(taut_model_surface(model, 0), &area, NULL) == TAUT_OK, "%s", what);
    CHECK(taut_plateau_certify(model, problem, NULL, &certificate, &error) == TAUT_OK, "%s: %s",
          what, error.message);
    if (certificate != NULL) {
        const size_t count =
            (size_t)taut_basis_count(problem->net.u) * (size_t)taut_basis_count(problem->net.v);
        const int is_open = problem->curves[0] == NULL && problem->tolerance_area == 0 &&
                            memchr(problem->net.known, 0, count) == NULL;
        CHECK(taut_certificate_holds(certificate) == (is_open ? TAUT_UNDECIDED : TAUT_TRUE),
              "%s: residual %.3g", what, taut_certificate_claim(certificate, 0)->residual);
    }
    taut_certificate_free(certificate);
    return area;
}

double film_area(const taut_plateau_problem *problem, const char *what)
{
    taut_model *model = NULL;
    taut_error error = {0};
    double area = nan("");

    CHECK(taut_plateau_make(problem, NULL, &model, &error) == TAUT_OK, "%s: %s", what,
          error.message);
    if (model != NULL) {
        area = film_proved_area(model, problem, what);
    }
    taut_model_free(model);
    return area;
}
