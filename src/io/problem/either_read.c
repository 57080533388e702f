/* either_read.c -- a file that may hold a problem or a model. */
#include "core/fail.h"
#include "io/format.h"
#include "io/model/model.h"
#include "taut/read.h"

taut_status taut_problem_or_model_read(const char *path, taut_problem **problem, taut_model **model,
                                       taut_error *error)
{
    taut_json_document *root = NULL;
    taut_problem *read_problem = NULL;
    taut_model *read_model = NULL;
    const taut_format_ops *ops = NULL;
    taut_status status = TAUT_OK;

    if (path == NULL || problem == NULL || model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_problem_or_model_read needs a path and places for both");
    }
    ops = taut_format_ops_at(taut_format_of(path, NULL));
    if (ops != NULL && ops->read != NULL) {
        status = ops->read(path, &read_model, error);
    } else {
        status = taut_json_load(path, &root, error);
    }
    if (status == TAUT_OK && root != NULL) {
        const taut_json document = taut_json_root(root);
        status = taut_json_find(document.value, "construct") != NULL
                     ? taut_problem_of_document(root, path, &read_problem, error)
                     : taut_model_of_document(root, &read_model, error);
    }
    taut_json_document_free(root);
    if (status != TAUT_OK) {
        return status;
    }
    *problem = read_problem;
    *model = read_model;
    return TAUT_OK;
}
