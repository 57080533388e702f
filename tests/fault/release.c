#include "release.h"

#include "taut/taut.h"

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
