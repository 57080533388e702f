/* test_film.c -- the construction `film` when memory runs out: all of it without the bound of its energy, and the last part of it
 * with. */
#include "calls.h"
#include "check.h"
#include "fault.h"
#include "sails.h"
#include "taut/taut.h"

#include <string.h>

static taut_status make(const void *context, void **result, taut_error *error)
{
    taut_model *model = *result;
    const taut_status status = taut_film_make(context, NULL, &model, error);
    *result = model;
    return status;
}

/* The proof of a model. */
typedef struct proof {
    const taut_model *model;
    const taut_film_problem *problem;
} proof;

static taut_status prove(const void *context, void **result, taut_error *error)
{
    const proof *p = context;
    taut_certificate *certificate = *result;
    const taut_status status = taut_film_certify(p->model, p->problem, NULL, &certificate, error);
    *result = certificate;
    return status;
}

static taut_status derive(const void *context, void **result, taut_error *error)
{
    static taut_film_slopes slopes;
    const proof *p = context;
    const taut_film_gradient_request area = {.of = TAUT_FILM_GRADIENT_AREA};
    const taut_status status = taut_film_gradient(p->problem, p->model, &area, &slopes, error);
    if (status == TAUT_OK) {
        *result = &slopes;
    }
    return status;
}

static void release_nothing(void *result)
{
    (void)result;
}

/* Fails so many allocations of making and proving a sail, or all. */
static void run_out(int without_least, int most)
{
    sail s = sail_new(2, 5, sail_saddle, 2);
    taut_model *model = NULL;

    s.problem.without_least = without_least;
    const fault_call making = {"film", make, release_model, &s.problem};
    CHECK(fault_loop_some(&making, most) > 100, "a film takes memory");
    CHECK(taut_film_make(&s.problem, NULL, &model, NULL) == TAUT_OK, "a sail");
    const proof context = {model, &s.problem};
    const fault_call proving = {"film's certificate", prove, release_certificate, &context};
    CHECK(model == NULL || fault_loop_some(&proving, most) > 100, "a proof takes memory");
    const fault_call deriving = {"taut_film_gradient", derive, release_nothing, &context};
    CHECK(model == NULL || fault_loop_some(&deriving, most) > 10, "derivatives take memory");
    taut_model_free(model);
    sail_free(&s);
}

static taut_status make_any(const void *context, void **result, taut_error *error)
{
    taut_model *model = *result;
    const taut_status status = taut_make(context, NULL, &model, error);
    *result = model;
    return status;
}

typedef struct any_proof {
    const taut_model *model;
    const taut_problem *problem;
} any_proof;

static taut_status prove_any(const void *context, void **result, taut_error *error)
{
    const any_proof *p = context;
    taut_certificate *certificate = *result;
    const taut_status status = taut_certify(p->model, p->problem, NULL, &certificate, error);
    *result = certificate;
    return status;
}

/* ---- a draft ---- */

static taut_status draft_any(const void *context, void **result, taut_error *error)
{
    const any_proof *p = context;
    taut_model *model = *result;
    const taut_status status = taut_draft(p->problem, p->model, 2, &model, error);
    *result = model;
    return status;
}

static void run_out_of_drafts(const char *text)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;

    CHECK(taut_problem_read_text(text, strlen(text), "text", &problem, NULL) == TAUT_OK, "text");
    CHECK(taut_make(problem, NULL, &model, NULL) == TAUT_OK, "a film");
    const any_proof context = {model, problem};
    const fault_call drafting = {"taut_draft", draft_any, release_model, &context};
    CHECK(fault_loop_some(&drafting, 2000) > 20, "a draft takes memory");
    taut_model_free(model);
    taut_problem_free(problem);
}

static const char drawn[] = "{\"taut\":1,\"construct\":\"film\",\"least\":false,"
                            "\"u\":{\"type\":\"bspline\",\"degree\":2,\"count\":4},"
                            "\"v\":{\"type\":\"bspline\",\"degree\":2,\"count\":4},"
                            "\"corners\":{\"u0v0\":[-1,-1,0.5],\"u1v0\":[1,-1,-0.5],"
                            "\"u0v1\":[-1,1,-0.5],\"u1v1\":[1,1,0.5]},"
                            "\"edges\":{\"u0\":{\"cable\":{\"force\":2}}}}";
static const char plate[] =
    "{\"taut\":1,\"construct\":\"plateau\",\"least\":false,"
    "\"u\":{\"type\":\"bezier\",\"degree\":2},\"v\":{\"type\":\"bezier\",\"degree\":2},"
    "\"points\":[[[-1,-1,0.5],[-1,0,0],[-1,1,0]],[[0,-1,0.5],null,[0,1,0]],"
    "[[1,-1,0],[1,0,0],[1,1,0.4]]]}";

/* A cap over a square, of two sheets, one with a volume under it. */
static const char cushion[] =
    "{\"taut\":1,\"construct\":\"film\",\"patches\":["
    "{\"name\":\"a\",\"u\":{\"type\":\"bspline\",\"degree\":2,\"count\":4},"
    "\"v\":{\"type\":\"bspline\",\"degree\":2,\"count\":4},\"corners\":{\"u0v0\":[0,0,0],"
    "\"u1v0\":[1,0,0],\"u0v1\":[0,1,0],\"u1v1\":[1,1,0]}},"
    "{\"name\":\"b\",\"u\":{\"type\":\"bspline\",\"degree\":2,\"count\":4},"
    "\"v\":{\"type\":\"bspline\",\"degree\":2,\"count\":4},\"corners\":{\"u0v0\":[1,0,0],"
    "\"u1v0\":[2,0,0],\"u0v1\":[1,1,0],\"u1v1\":[2,1,0]},"
    "\"edges\":{\"u1\":{\"cable\":{\"force\":3},\"plane\":{\"point\":[0,0,0],\"normal\":[0,0,1]}}}}"
    "],"
    "\"seams\":[[\"a.u1\",\"b.u0\"]],"
    "\"cells\":[{\"sides\":[\"a\",\"b\"],\"volume\":0.1}]}";

/* A sheet of a tension beside one of threads, between cables of a length and of a spring, one along both; found in two spaces. */
#define CORNERS                                                                                    \
    "\"u\":{\"type\":\"bspline\",\"degree\":2,\"count\":4},\"v\":{\"type\":\"bspline\","           \
    "\"degree\":"                                                                                  \
    "2,\"count\":4},\"corners\":"
static const char threads[] =
    "{\"taut\":1,\"construct\":\"film\",\"refine\":1,\"patches\":[{\"name\":\"a\"," CORNERS
    "{\"u0v0\":[0,0,0],\"u0v1\":[0,1,0]},\"edges\":{\"u0\":{\"cable\":{\"unstressed\":1,"
    "\"stiffness\":20}}}},{\"name\":\"b\",\"force_density\":[1,1]," CORNERS
    "{\"u1v0\":[2,0,0],\"u1v1\":[2,1,0]}}],\"seams\":[[\"a.u1\",\"b.u0\"]],\"cables\":[{"
    "\"along\":[\"a.v0\",\"b.v0\"],\"length\":2.05},{\"along\":[\"a.v1\",\"b.v1\"],"
    "\"force\":4}]}";

/* Two sheets with a bound. */
static const char bent[] =
    "{\"taut\":1,\"construct\":\"film\",\"patches\":[{\"name\":\"a\"," CORNERS
    "{\"u0v0\":[0,0,0],\"u1v0\":[1,0,0],\"u0v1\":[0,1,0.2],\"u1v1\":[1,1,0]}},{\"name\":"
    "\"b\"," CORNERS
    "{\"u0v0\":[1,0,0],\"u1v0\":[2,0,0.2],\"u0v1\":[1,1,0],\"u1v1\":[2,1,0]}}],\"seams\":[["
    "\"a.u1\",\"b.u0\"]]}";

static void run_out_of_patches(const char *text, int most)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;

    CHECK(taut_problem_read_text(text, strlen(text), "text", &problem, NULL) == TAUT_OK, "text");
    const fault_call making = {"film of patches", make_any, release_model, problem};
    CHECK(fault_loop_some(&making, most) > 40, "a film takes memory");
    CHECK(taut_make(problem, NULL, &model, NULL) == TAUT_OK, "a film");
    const any_proof context = {model, problem};
    const fault_call proving = {"its certificate", prove_any, release_certificate, &context};
    CHECK(model == NULL || fault_loop_some(&proving, most) > 40, "a proof takes memory");
    taut_model_free(model);
    taut_problem_free(problem);
}

int main(void)
{
    random_seed(7);
    run_out(1, 2000);
    run_out(0, 60);
    run_out_of_patches(cushion, 2000);
    run_out_of_patches(threads, 100);
    run_out_of_patches(bent, 200);
    run_out_of_drafts(drawn);
    run_out_of_drafts(plate);
    return check_failures != 0;
}
