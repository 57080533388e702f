#include "certificates.h"

#include "check.h"
#include "problem/problem.h"

#include <string.h>

taut_certificate *certificate_of(const taut_model *model, int construct, const void *data)
{
    taut_problem *problem = NULL;
    taut_certificate *certificate = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_problem_new(construct, &problem) == TAUT_OK, "problem");
    problem->data = data;
    CHECK(taut_certify(model, problem, NULL, &certificate, &error) == TAUT_OK, "%s: %s",
          error.where, error.message);
    taut_problem_free(problem);
    return certificate;
}

static const taut_claim missing = {
    .claim = "", .residual = INFINITY, .holds = TAUT_UNDECIDED, .where = "missing"};

const taut_claim *claim_of(const taut_certificate *certificate, const char *name)
{
    for (int k = 0; certificate != NULL && k < taut_certificate_claim_count(certificate); k++) {
        const taut_claim *claim = taut_certificate_claim(certificate, k);
        if (strcmp(claim->claim, name) == 0) {
            return claim;
        }
    }
    return &missing;
}

int has_claim(const taut_certificate *certificate, const char *name)
{
    return claim_of(certificate, name) != &missing;
}

double figure_of(const taut_certificate *certificate, const char *name)
{
    return certificate != NULL
               ? taut_record_number(taut_record_get(taut_certificate_figures(certificate), name))
               : nan("");
}

double detail_of(const taut_model *model, const char *name)
{
    return taut_record_number(taut_record_get(taut_model_details(model), name));
}
