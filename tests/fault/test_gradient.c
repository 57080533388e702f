/* test_gradient.c -- derivatives when memory runs out. */
#include "calls.h"
#include "check.h"
#include "fault.h"
#include "problems.h"

#include "taut/gradient.h"
#include "taut/read.h"

#include <stdlib.h>
#include <string.h>

/* A derivative of a problem's model. */
typedef struct request {
    const taut_problem *problem;
    const taut_model *model;
    taut_gradient_request what;
} request;

static taut_status derive(const void *context, void **result, taut_error *error)
{
    static double gradient[75];
    const request *r = context;
    const taut_status status = taut_gradient(r->problem, r->model, &r->what, gradient, error);
    if (status == TAUT_OK) {
        *result = gradient;
    }
    return status;
}

/* The gradients of a document's surface, of 5 x 5 points at most. */
static void derive_text(const char *name, const char *text, taut_gradient_of of)
{
    static const double factors[75] = {1, 2, 3, -1};
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    CHECK(taut_problem_read_text(text, strlen(text), name, &problem, NULL) == TAUT_OK, "%s", name);
    CHECK(taut_make(problem, NULL, &model, NULL) == TAUT_OK, "%s", name);
    const request context = {
        problem, model, {of, of == TAUT_GRADIENT_POINTS ? factors : NULL, {0}}};
    fault_check(name, derive, NULL, &context, 3);
    taut_model_free(model);
    taut_problem_free(problem);
}

/* The same of structs. */
typedef struct direct {
    const taut_plateau_problem *problem;
    const taut_model *model;
} direct;

static taut_status derive_dirichlet(const void *context, void **result, taut_error *error)
{
    static double gradient[48];
    const direct *d = context;
    const taut_status status =
        taut_dirichlet_gradient(&d->problem->net, d->model, NULL, gradient, error);
    if (status == TAUT_OK) {
        *result = gradient;
    }
    return status;
}

static taut_status derive_plateau(const void *context, void **result, taut_error *error)
{
    static double gradient[48];
    const direct *d = context;
    const taut_status status = taut_plateau_gradient(d->problem, d->model, NULL, gradient, error);
    if (status == TAUT_OK) {
        *result = gradient;
    }
    return status;
}

static void derive_structs(void)
{
    test_problem net = problem_tetrahedron(4);
    const taut_plateau_problem problem = {.net = net.data, .method = TAUT_PLATEAU_NORMAL};
    direct context = {&problem, NULL};
    taut_model *models[2] = {NULL, NULL};

    CHECK(taut_dirichlet_make(&net.data, NULL, &models[0], NULL) == TAUT_OK, "dirichlet");
    CHECK(taut_plateau_make(&problem, NULL, &models[1], NULL) == TAUT_OK, "plateau");
    context.model = models[0];
    fault_check("taut_dirichlet_gradient", derive_dirichlet, NULL, &context, 3);
    context.model = models[1];
    fault_check("taut_plateau_gradient", derive_plateau, NULL, &context, 3);
    taut_model_free(models[0]);
    taut_model_free(models[1]);
    problem_free(&net);
}

static taut_status derive_film(const void *context, void **result, taut_error *error)
{
    static taut_film_slopes slopes;
    const request *r = context;
    const taut_film_gradient_request area = {.of = TAUT_FILM_GRADIENT_AREA};
    const taut_status status = taut_gradient_of_film(r->problem, r->model, &area, &slopes, error);
    if (status == TAUT_OK) {
        *result = &slopes;
    }
    return status;
}

/* A flat sail. */
static void derive_sail(void)
{
    static const char text[] =
        "{\"taut\":1,\"construct\":\"film\",\"u\":{\"type\":\"bezier\",\"degree\":2},"
        "\"v\":{\"type\":\"bezier\",\"degree\":2},\"corners\":{\"u0v0\":[0,0,0],\"u1v0\":[2,0,0],"
        "\"u0v1\":[0,2,0],\"u1v1\":[2,2,0]},\"edges\":{\"u0\":{\"cable\":{\"force\":2}},"
        "\"u1\":{\"cable\":{\"length\":2.1}}}}";
    request context = {NULL, NULL, {0}};
    taut_problem *problem = NULL;
    taut_model *model = NULL;

    CHECK(taut_problem_read_text(text, strlen(text), "sail", &problem, NULL) == TAUT_OK, "sail");
    CHECK(taut_make(problem, NULL, &model, NULL) == TAUT_OK, "sail");
    context.problem = problem;
    context.model = model;
    fault_check("taut_gradient_of_film", derive_film, NULL, &context, 3);
    taut_model_free(model);
    taut_problem_free(problem);
}

#define NET                                                                                        \
    "\"u\":{\"type\":\"bezier\",\"degree\":3},\"v\":{\"type\":\"bezier\",\"degree\":3},"           \
    "\"points\":[[[0,0,0],[0,1,1],[0,2,1],[0,3,0]],[[1,0,1],null,null,[1,3,1]],"                   \
    "[[2,0,1],null,null,[2,3,1]],[[3,0,0],[3,1,1],[3,2,1],[3,3,0]]]}"

int main(void)
{
    derive_text("dirichlet", "{\"taut\":1,\"construct\":\"dirichlet\"," NET, TAUT_GRADIENT_AREA);
    derive_text("weights",
                "{\"taut\":1,\"construct\":\"dirichlet\",\"weights\":[[1,1,1,1],[1,1.1,1,1],"
                "[1,1,1.2,1],[1,1,1,1]]," NET,
                TAUT_GRADIENT_DIRICHLET_ENERGY);
    derive_text("film", "{\"taut\":1,\"construct\":\"plateau\",\"method\":\"normal\"," NET,
                TAUT_GRADIENT_POINTS);
    derive_text("biharmonic", "{\"taut\":1,\"construct\":\"biharmonic\"," NET,
                TAUT_GRADIENT_POINTS);
    derive_structs();
    derive_sail();
    return check_failures != 0;
}
