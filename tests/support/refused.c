#include "refused.h"

#include "check.h"

#include "taut/construct.h"
#include "taut/read.h"

#include <string.h>

taut_error check_document_refused(const char *text, taut_status status, const char *reason,
                                  const char *where)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_status found = taut_problem_read_text(text, strlen(text), "text", &problem, &error);

    if (found == TAUT_OK) {
        found = taut_make(problem, NULL, &model, &error);
    }
    CHECK(found == status && strcmp(error.reason, reason) == 0 && strcmp(error.where, where) == 0,
          "%s at %s: status %d, %s at %s: %s", reason, where, (int)found, error.reason, error.where,
          error.message);
    taut_model_free(model);
    taut_problem_free(problem);
    return error;
}
