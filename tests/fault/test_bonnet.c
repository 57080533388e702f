/* test_bonnet.c -- the construction `bonnet`, its certificate and its panels when memory runs out.
 */
#include "calls.h"
#include "check.h"
#include "fault.h"
#include "folder.h"

#include "taut/panels.h"
#include "taut/read.h"

static taut_status make(const void *context, void **result, taut_error *error)
{
    taut_model *model = *result;
    const taut_status status = taut_bonnet_make(context, NULL, &model, error);
    *result = model;
    return status;
}

/* What a call works on. */
typedef struct given {
    const taut_model *model;
    const taut_bonnet_problem *problem;
} given;

static taut_status certify(const void *context, void **result, taut_error *error)
{
    const given *const g = context;
    taut_certificate *certificate = *result;
    const taut_status status = taut_bonnet_certify(g->model, g->problem, NULL, &certificate, error);
    *result = certificate;
    return status;
}

static taut_status panels_of_problem(const void *context, void **result, taut_error *error)
{
    const taut_panels_options options = {.kind = TAUT_PANELS_CONICAL, .divide = {4, 4}};
    const given *const g = context;
    taut_model *panels = *result;
    const taut_status status = taut_panels_of_bonnet(g->problem, &options, &panels, error);
    *result = panels;
    return status;
}

static taut_status panels_of_model(const void *context, void **result, taut_error *error)
{
    const taut_panels_options options = {.kind = TAUT_PANELS_CIRCULAR, .divide = {4, 4}};
    const given *const g = context;
    taut_model *panels = *result;
    const taut_status status = taut_panels_of_model(g->model, &options, &panels, error);
    *result = panels;
    return status;
}

static taut_status read(const void *context, void **result, taut_error *error)
{
    taut_problem *problem = *result;
    taut_model *model = NULL;
    const taut_status status =
        taut_problem_or_model_read_with(context, NULL, &problem, &model, error);
    *result = problem;
    return status;
}

int main(void)
{
    static const char document[] =
        "{\"taut\":1,\"construct\":\"bonnet\",\"lambda\":0.5,\"sign\":\"+\",\"alpha\":1,"
        "\"beta\":1}";
    const taut_bonnet_problem frames = {
        .lambda = {0, 0.5}, .frames = 2, .sign = -1, .alpha = 2, .beta = 1};
    taut_model *model = NULL;

    folder_make();
    const char *const path = in_folder("either.json");
    file_put_text(path, document);
    CHECK(taut_bonnet_make(&frames, NULL, &model, NULL) == TAUT_OK, "frames");
    const given context = {model, &frames};
    const fault_call calls[] = {
        {"make", make, release_model, &frames},
        {"certify", certify, release_certificate, &context},
        {"panels of a problem", panels_of_problem, release_model, &context},
        {"panels of a model", panels_of_model, release_model, &context},
        {"read either", read, release_problem, path},
    };
    for (size_t i = 0; i < sizeof calls / sizeof calls[0]; i++) {
        CHECK(fault_loop(&calls[i]) > 5, "%s takes memory", calls[i].name);
    }
    taut_model_free(model);
    folder_remove();
    return check_failures != 0;
}
