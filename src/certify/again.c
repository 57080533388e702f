/* again.c -- a saved certificate proved again: what the model alone decides is proved, the rest stays as it was saved, and is
 * marked so. */
#include "core/fail.h"
#include "taut/construct.h"
#include "taut/model.h"

#include <string.h>

static int has_claim(const taut_certificate *certificate, const char *name)
{
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        if (strcmp(taut_certificate_claim(certificate, i)->claim, name) == 0) {
            return 1;
        }
    }
    return 0;
}

/* The claims of `saved` that `proved` has none of that name of. */
static taut_status add_saved(const taut_certificate *saved, taut_certificate *proved)
{
    taut_status status = TAUT_OK;

    for (int i = 0; status == TAUT_OK && i < taut_certificate_claim_count(saved); i++) {
        taut_claim claim = *taut_certificate_claim(saved, i);
        claim.as_saved = 1;
        if (!has_claim(proved, claim.claim)) {
            status = taut_certificate_add(proved, &claim);
        }
    }
    return status;
}

taut_status taut_certify_again(const taut_model *model, const taut_certify_options *options,
                               taut_certificate **certificate, taut_error *error)
{
    taut_certificate *proved = NULL;
    taut_status status = taut_certify(model, NULL, options, &proved, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (add_saved(taut_model_certificate(model), proved) != TAUT_OK) {
        taut_certificate_free(proved);
        return taut_fail_memory(error);
    }
    *certificate = proved;
    return TAUT_OK;
}
