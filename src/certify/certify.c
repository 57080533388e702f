/* certify.c -- from a model (and its problem) to the certificate of its construction. */
#include "certify/certify_ops.h"
#include "core/fail.h"
#include "problem/problem.h"

#include <math.h>

static const taut_certify_ops *const ops_table[] = {
#define TAUT_CERTIFY_ROW(identifier, name) &taut_certify_##identifier,
    TAUT_CONSTRUCT_LIST(TAUT_CERTIFY_ROW)
#undef TAUT_CERTIFY_ROW
};

/* The construction of the problem, or that of the certificate the model carries; -1 if neither. */
static int construct_of(const taut_model *model, const taut_problem *problem)
{
    if (problem != NULL) {
        return problem->construct;
    }
    if (taut_model_certificate(model) == NULL) {
        return -1;
    }
    return taut_construct_find(taut_certificate_construct(taut_model_certificate(model)));
}

/* Which surfaces and curves the claims are about; unit: the problem's, or NULL. */
static taut_status add_identity(const taut_certify_ops *ops, const taut_model *model,
                                const void *data, const char *unit, taut_certificate *certificate)
{
    taut_arena *arena = taut_arena_new();
    taut_identity identity;
    taut_status status = taut_identity_begin(arena, model, data != NULL, &identity);
    if (status == TAUT_OK) {
        ops->identify(model, data, &identity);
        status = taut_identity_end(&identity, unit, certificate);
    }
    taut_arena_free(arena);
    return status;
}

static taut_status certify(const taut_certify_ops *ops, const char *construct,
                           const taut_model *model, const void *data, const char *unit,
                           const taut_certify_options *options, taut_certificate **certificate,
                           taut_error *error)
{
    static const taut_certify_options none;
    const taut_certify_options *asked = options != NULL ? options : &none;
    taut_pulse pulse = {.monitor = &asked->monitor, .what = "proving", .done = NAN};
    const taut_audit audit = {.tolerance = asked->tolerance,
                              .exact = asked->exact,
                              .crew = {.threads = asked->threads, .pulse = &pulse}};
    taut_certificate *made = NULL;
    taut_status status = TAUT_OK;

    if (taut_certificate_new(construct, &made) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (!taut_pulse_report(&pulse)) {
        status = ops->certify(model, data, &audit, made, error);
    }
    if (pulse.is_stopped) {
        status = taut_fail_status(error, TAUT_INTERRUPTED);
    }
    if (status == TAUT_OK && add_identity(ops, model, data, unit, made) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    if (status != TAUT_OK) {
        taut_certificate_free(made);
        return status;
    }
    *certificate = made;
    return TAUT_OK;
}

taut_status taut_certify_with(const taut_certify_ops *ops, const char *construct,
                              const taut_model *model, const void *data,
                              const taut_certify_options *options, taut_certificate **certificate,
                              taut_error *error)
{
    if (model == NULL || certificate == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "certifying `%s` needs a model and a place for the certificate",
                         construct);
    }
    return certify(ops, construct, model, data, NULL, options, certificate, error);
}

taut_status taut_certify(const taut_model *model, const taut_problem *problem,
                         const taut_certify_options *options, taut_certificate **certificate,
                         taut_error *error)
{
    int construct = 0;

    if (model == NULL || certificate == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_certify needs a model and a place for the certificate");
    }
    construct = construct_of(model, problem);
    if (construct < 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "needs-problem", "/certificate/construct",
                         taut_none, taut_none,
                         "the model does not say which construction it came from: give its "
                         "problem too");
    }
    if (options != NULL && options->exact && !ops_table[construct]->exact) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "no-rationals", NULL, taut_none, taut_none,
                         "rational arithmetic is for harmonic and harmonic-extension, not for %s",
                         taut_construct_name(construct));
    }
    return certify(ops_table[construct], taut_construct_name(construct), model,
                   problem != NULL ? problem->data : NULL, problem != NULL ? problem->unit : NULL,
                   options, certificate, error);
}
