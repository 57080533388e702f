/* either_read.c -- a file that may hold a problem or a model. */
#include "core/fail.h"
#include "io/format.h"
#include "io/model/model.h"
#include "io/problem/read.h"
#include "taut/read.h"

/* What a file turns out to hold: one of them. */
typedef struct either {
    const char *path;
    taut_problem_source source;
    taut_problem *problem;
    taut_model *model;
} either;

static taut_status read_root(const taut_json *document, void *into, taut_error *error)
{
    either *e = into;
    return taut_json_find(document->value, "construct") != NULL ||
                   taut_json_find(document->value, "trace") != NULL ||
                   taut_json_find(document->value, "pattern") != NULL
               ? taut_problem_document_read(document, e->path, &e->source, &e->problem, error)
               : taut_model_document_read(document, &e->model, error);
}

taut_status taut_problem_or_model_read_with(const char *path, const taut_read_options *options,
                                            taut_problem **problem, taut_model **model,
                                            taut_error *error)
{
    either e = {.path = path};
    const taut_format_ops *ops = NULL;
    taut_pulse pulse = taut_read_pulse(options);
    taut_status status = TAUT_OK;

    if (path == NULL || problem == NULL || model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_problem_or_model_read needs a path and places for both");
    }
    ops = taut_format_ops_at(taut_format_of(path, NULL));
    status = ops != NULL && ops->read != NULL
                 ? taut_model_format_read(ops, path, options, &e.model, error)
                 : taut_problem_read_file(path, &pulse, read_root, &e, &e.source, error);
    if (status != TAUT_OK) {
        return status;
    }
    *problem = e.problem;
    *model = e.model;
    return TAUT_OK;
}

taut_status taut_problem_or_model_read(const char *path, taut_problem **problem, taut_model **model,
                                       taut_error *error)
{
    return taut_problem_or_model_read_with(path, NULL, problem, model, error);
}
