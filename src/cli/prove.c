/* prove.c -- what a saved certificate says is proved again before a page or a figure shows it. */
#include "cli/cli.h"

#include <stdio.h>
#include <string.h>

/* Proofs of more points may take minutes. */
enum { QUICK_POINTS = 10000 };

static int point_count(const taut_model *model)
{
    double count = 0;
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        count += (double)taut_basis_count(taut_surface_u(surface)) *
                 (double)taut_basis_count(taut_surface_v(surface));
    }
    return count > QUICK_POINTS ? QUICK_POINTS + 1 : (int)count;
}

static void warn_of_claims(const char *file, const taut_certificate *certificate)
{
    char text[400] = "not all claims hold:";

    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        const size_t used = strlen(text);
        if (claim->holds == TAUT_FALSE && used < 300) {
            snprintf(text + used, sizeof text - used, " %.60s", claim->claim);
        }
    }
    cli_warn(file, text);
}

/* `as`: how a certificate that is not proved again is used ("shown"); NULL: not at all, which needs no word. */
static void prove_again(const char *file, const char *as, taut_model *model,
                        const cli_options *options)
{
    const taut_certify_options chosen = {.threads = options->threads};
    taut_certificate *certificate = NULL;
    taut_error error;
    char text[400];

    if (taut_model_certificate(model) == NULL) {
        return;
    }
    if (point_count(model) > QUICK_POINTS) {
        snprintf(text, sizeof text,
                 "the certificate is %s as saved, since proving so large a model again takes long: "
                 "see `taut certify`",
                 as != NULL ? as : "");
    } else if (taut_certify_again(model, &chosen, &certificate, &error) != TAUT_OK) {
        snprintf(text, sizeof text, "the certificate is %s as saved, not proved again: %.300s",
                 as != NULL ? as : "", error.message);
    } else {
        if (taut_certificate_holds(certificate) == TAUT_FALSE) {
            warn_of_claims(file, certificate);
        }
        taut_model_set_certificate(model, certificate);
        return;
    }
    if (as != NULL) {
        cli_warn(file, text);
    }
}

void cli_prove_again(const char *file, taut_model *model, const cli_options *options)
{
    prove_again(file, "shown", model, options);
}

int cli_prove_against(const char *file, const char *problem_file, taut_model *model,
                      const cli_options *options)
{
    const taut_certify_options chosen = {.threads = options->threads,
                                         .monitor = cli_monitor(options->json)};
    taut_certificate *certificate = NULL;
    taut_problem *problem = NULL;
    taut_error error;
    const int is_read = taut_problem_read(problem_file, &problem, &error) == TAUT_OK;
    const int is_proved =
        is_read && taut_certify(model, problem, &chosen, &certificate, &error) == TAUT_OK;

    cli_monitor_done();
    taut_problem_free(problem);
    if (!is_proved) {
        return cli_fail_in(is_read ? file : problem_file, &error);
    }
    if (taut_certificate_holds(certificate) == TAUT_FALSE) {
        warn_of_claims(file, certificate);
    }
    taut_model_set_certificate(model, certificate);
    return 0;
}

int cli_prove_for_outputs(const char *file, taut_model **model, const cli_options *options,
                          taut_model **shown)
{
    int is_shown = 0, is_kept = 0;
    taut_model *proved = NULL;
    for (int i = 0; i < options->output_count; i++) {
        is_shown |= cli_is_picture(options->outputs[i]);
        is_kept |= cli_is_json(options->outputs[i]);
    }
    *shown = NULL;
    if (taut_model_certificate(*model) == NULL) {
        return 0;
    }
    if (taut_model_copy(*model, &proved) != TAUT_OK) {
        return cli_no_memory();
    }
    prove_again(file, is_shown ? "shown" : is_kept ? "kept" : NULL, proved, options);
    if (taut_certificate_holds(taut_model_certificate(proved)) == TAUT_FALSE) {
        taut_model_free(*model); /* whose certificate says what is not so */
        *model = proved;
    } else if (is_shown) {
        *shown = proved;
    } else {
        taut_model_free(proved);
    }
    return 0;
}
