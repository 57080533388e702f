#include "outcome.h"

#include "io/format.h"
#include "taut/read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double deadline; /* of the one monitor there is */

void require(int condition)
{
    if (!condition) {
        abort();
    }
}

void require_error(taut_status status, const taut_error *error)
{
    require(status == error->status && error->message[0] != '\0');
    require(memchr(error->message, '\0', sizeof error->message) != NULL);
    require(memchr(error->where, '\0', sizeof error->where) != NULL);
}

static char *text_of(const taut_model *model, size_t *length)
{
    const taut_write_options options = {0};
    char *text = NULL;
    FILE *out = open_memstream(&text, length);
    require(out != NULL);
    require(taut_format_json.write(model, &options, out, NULL) == TAUT_OK);
    require(fclose(out) == 0);
    return text;
}

void require_model(const taut_model *model)
{
    size_t length = 0, again_length = 0;
    char *text = text_of(model, &length), *again = NULL;
    taut_model *back = NULL;
    for (int s = 0; s < taut_model_surface_count(model); s++) {
        const taut_surface *surface = taut_model_surface(model, s);
        const long count = (long)taut_basis_count(taut_surface_u(surface)) *
                           taut_basis_count(taut_surface_v(surface));
        for (long i = 0; i < 3 * count; i++) {
            require(isfinite(taut_surface_points(surface)[i]));
        }
    }
    require(taut_model_read_text(text, length, "text", &back, NULL) == TAUT_OK);
    again = text_of(back, &again_length);
    require(length == again_length && memcmp(text, again, length) == 0);
    free(text);
    free(again);
    taut_model_free(back);
}

void require_certificate(const taut_certificate *certificate)
{
    taut_verdict verdict = TAUT_TRUE;
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        require(claim->holds != TAUT_TRUE || (!isnan(claim->residual) && !isnan(claim->limit)));
        if (claim->holds == TAUT_FALSE ||
            (claim->holds == TAUT_UNDECIDED && verdict == TAUT_TRUE)) {
            verdict = claim->holds;
        }
    }
    require(taut_certificate_holds(certificate) == verdict);
}

static int look_at_clock(void *context, double done, const char *what)
{
    (void)context;
    (void)done;
    (void)what;
    return (double)clock() / CLOCKS_PER_SEC > deadline;
}

taut_monitor patient_monitor(double seconds)
{
    const taut_monitor monitor = {look_at_clock, NULL};
    deadline = (double)clock() / CLOCKS_PER_SEC + seconds;
    return monitor;
}
