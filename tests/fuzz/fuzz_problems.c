/* fuzz_problems.c -- problem documents of every construction: read, made, proved.
 *
 * With libFuzzer documents are mutated as what they are (mutate_problems.c), so that most get past
 * the reader. Small nets only, and work is stopped when it has taken a second: what is looked for
 * is a crash, an outcome that contradicts itself, or a step that does not come back to its monitor.
 */
#include "outcome.h"

#include "taut/read.h"

#include <stdint.h>
#include <string.h>
#include <time.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { SMALL = 3000 }; /* bytes */

static void make_and_certify(const taut_problem *problem)
{
    const taut_make_options options = {.monitor = patient_monitor(1)};
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_status status = taut_make(problem, &options, &model, &error);
    if (status != TAUT_OK) {
        require_error(status, &error);
        require(status != TAUT_INTERNAL && model == NULL);
        return;
    }
    require_model(model);
    if (is_tame(model)) {
        status = taut_certify(model, problem, NULL, &certificate, &error);
        if (status == TAUT_OK) {
            require_certificate(certificate);
        } else {
            require_error(status, &error);
        }
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    taut_problem *problem = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_status status = TAUT_OK;
    if (size > SMALL) {
        return 0;
    }
    status = taut_problem_read_text((const char *)data, size, "problem", &problem, &error);
    if (status == TAUT_OK) {
        make_and_certify(problem);
    } else {
        require_error(status, &error);
    }
    taut_problem_free(problem);
    return 0;
}
