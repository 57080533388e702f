#include "documents.h"

#include "check.h"

#include <string.h>

taut_problem *problem_read(const char *text)
{
    taut_problem *problem = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_problem_read_text(text, strlen(text), "text", &problem, &error) == TAUT_OK, "%s: %s",
          error.where, error.message);
    return problem;
}
