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

/* Surfaces whose area has few kinks: certificates have no monitor, and integrate to ten digits. */
static int is_quick(const taut_model *model)
{
    long points = 0;
    for (int s = 0; s < taut_model_surface_count(model); s++) {
        const taut_surface *surface = taut_model_surface(model, s);
        points += (long)taut_basis_count(taut_surface_u(surface)) *
                  taut_basis_count(taut_surface_v(surface));
    }
    return points <= 16;
}

static void make_and_certify(const taut_problem *problem)
{
    const taut_make_options options = {.monitor = patient_monitor(1)};
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error error = {TAUT_OK, 0, 0, "", ""};
    taut_status status = taut_make(problem, &options, &model, &error);
    if (status != TAUT_OK) {
        require_error(status, &error);
        require(status != TAUT_INTERNAL && model == NULL);
        return;
    }
    require_model(model);
    if (is_quick(model)) {
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
    taut_error error = {TAUT_OK, 0, 0, "", ""};
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
