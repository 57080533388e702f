/* test_named.c -- the certificate that a construction's own call gives is the one that taut_certify gives of its problem. */
#include "attack.h"
#include "certificates.h"
#include "check.h"

#include "problem/problem.h"
#include "taut/biharmonic.h"
#include "taut/harmonic.h"

#include <string.h>

static taut_status harmonic(const taut_model *model, const void *data, taut_certificate **made,
                            taut_error *error)
{
    return taut_harmonic_certify(model, data, NULL, made, error);
}

static taut_status extension(const taut_model *model, const void *data, taut_certificate **made,
                             taut_error *error)
{
    return taut_harmonic_extension_certify(model, data, NULL, made, error);
}

static taut_status biharmonic(const taut_model *model, const void *data, taut_certificate **made,
                              taut_error *error)
{
    return taut_biharmonic_certify(model, data, NULL, made, error);
}

static void check_same(const taut_certificate *a, const taut_certificate *b, const char *what)
{
    CHECK(taut_certificate_holds(a) == taut_certificate_holds(b), "%s", what);
    CHECK(taut_certificate_claim_count(a) == taut_certificate_claim_count(b), "%s", what);
    for (int k = 0; k < taut_certificate_claim_count(a) && k < taut_certificate_claim_count(b);
         k++) {
        const taut_claim *c = taut_certificate_claim(a, k), *d = taut_certificate_claim(b, k);
        CHECK(strcmp(c->claim, d->claim) == 0 && c->residual == d->residual &&
                  c->limit == d->limit && c->holds == d->holds,
              "%s: %s, %s", what, c->claim, d->claim);
    }
}

int main(void)
{
    static const struct {
        const char *example;
        taut_status (*certify)(const taut_model *, const void *, taut_certificate **, taut_error *);
    } rows[] = {{"harmonic-rows", harmonic},       {"harmonic-fit", harmonic},
                {"harmonic-extension", extension}, {"harmonic-neighbour", extension},
                {"biharmonic-rows", biharmonic},   {"biharmonic-c1", biharmonic}};
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        subject given = subject_example(rows[k].example);
        taut_certificate *general = NULL, *named = NULL;
        taut_error error = {.message = ""};
        CHECK(taut_certify(given.model, given.problem, NULL, &general, &error) == TAUT_OK, "%s",
              error.message);
        CHECK(rows[k].certify(given.model, given.problem->data, &named, &error) == TAUT_OK, "%s",
              error.message);
        check_same(general, named, rows[k].example);
        taut_certificate_free(named);
        CHECK(rows[k].certify(given.model, NULL, &named, &error) == TAUT_OK, "alone: %s",
              error.message);
        taut_certificate_free(named);
        CHECK(rows[k].certify(NULL, given.problem->data, &named, &error) == TAUT_BAD_ARGUMENT, "%s",
              rows[k].example);
        taut_certificate_free(general);
        subject_free(&given);
    }
    return check_failures != 0;
}
