#include "calls.h"

#include "taut/taut.h"

#include <string.h>

taut_status read_model(const void *context, void **result, taut_error *error)
{
    static const taut_read_options whole = {.untrim =
                                                1}; /* what is refused afterwards takes no memory */
    taut_model *model = *result;
    const taut_status status = taut_model_read_with(context, &whole, &model, error);
    *result = model;
    return status;
}

taut_status read_model_text(const void *context, void **result, taut_error *error)
{
    taut_model *model = *result;
    const taut_status status =
        taut_model_read_text_with(context, strlen(context), "text", NULL, &model, error);
    *result = model;
    return status;
}

taut_status read_problem(const void *context, void **result, taut_error *error)
{
    taut_problem *problem = *result;
    const taut_status status = taut_problem_read(context, &problem, error);
    *result = problem;
    return status;
}

taut_status read_problem_text(const void *context, void **result, taut_error *error)
{
    taut_problem *problem = *result;
    const taut_status status =
        taut_problem_read_text(context, strlen(context), "text", &problem, error);
    *result = problem;
    return status;
}

void release_certificate(void *certificate)
{
    taut_certificate_free(certificate);
}

void release_curve(void *curve)
{
    taut_curve_free(curve);
}

void release_model(void *model)
{
    taut_model_free(model);
}

void release_problem(void *problem)
{
    taut_problem_free(problem);
}

void release_record(void *record)
{
    taut_record_free(record);
}

void release_surface(void *surface)
{
    taut_surface_free(surface);
}
