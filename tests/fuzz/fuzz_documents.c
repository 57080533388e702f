/* fuzz_documents.c -- any bytes as a problem and as a model.
 *
 * Beyond not crashing: a refusal is told whole (status, a sentence), a model that was read can be
 * written, and what is written reads back to the same bytes. A small problem that was read is made
 * and certified too.
 */
#include "outcome.h"

#include "taut/read.h"

#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { SMALL = 4096 }; /* bytes of a problem that is quick to solve */

static void make_and_certify(const taut_problem *problem)
{
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error error = {.status = TAUT_OK};
    const taut_make_options options = {.monitor = patient_monitor(2)};
    taut_status status = taut_make(problem, &options, &model, &error);
    if (status != TAUT_OK) {
        require_error(status, &error);
        return;
    }
    require_model(model);
    status = is_tame(model) ? taut_certify(model, problem, NULL, &certificate, &error) : TAUT_OK;
    if (status != TAUT_OK) {
        require_error(status, &error);
    } else if (certificate != NULL) {
        require_certificate(certificate);
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
}

/* Wherever a pointer leads in a document that was read, the changed one is read or refused whole. */
static void change_places(const taut_problem *problem)
{
    static const char *const pointers[] = {
        "", "/points/0/0", "/u/degree", "/name", "/from/point/2", "/curves/v0/points/1", "/1"};
    for (size_t i = 0; i < sizeof pointers / sizeof pointers[0]; i++) {
        taut_problem *changed = NULL;
        taut_error error = {.status = TAUT_OK};
        const taut_status status =
            taut_problem_change(problem, pointers[i], "[1, 2, 3]", 9, &changed, &error);
        if (status != TAUT_OK) {
            require_error(status, &error);
        }
        taut_problem_free(changed);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const char *text = (const char *)data;
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_status status = taut_problem_read_text(text, size, "problem", &problem, &error);

    if (status != TAUT_OK) {
        require_error(status, &error);
    } else if (size <= SMALL) {
        make_and_certify(problem);
        change_places(problem);
    }
    taut_problem_free(problem);
    error.status = TAUT_OK;
    status = taut_model_read_text(text, size, "model", &model, &error);
    if (status != TAUT_OK) {
        require_error(status, &error);
    } else {
        require_model(model);
    }
    taut_model_free(model);
    return 0;
}
