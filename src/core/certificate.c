/* certificate.c -- the container of claims and figures. */
#include "taut/certify.h"

#include "core/memory.h"

#include <string.h>

struct taut_certificate {
    char *construct;
    taut_claim *claims; /* the strings are owned */
    int claim_count;
    taut_record *figures;
};

static char *text_copy(const char *text)
{
    const char *from = text != NULL ? text : "";
    char *copy = taut_alloc(strlen(from) + 1, 1);
    if (copy != NULL) {
        memcpy(copy, from, strlen(from) + 1);
    }
    return copy;
}

taut_status taut_certificate_new(const char *construct, taut_certificate **certificate)
{
    taut_certificate *made = NULL;
    if (certificate == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    made->construct = text_copy(construct);
    made->figures = taut_record_new();
    if (made->construct == NULL || made->figures == NULL) {
        taut_certificate_free(made);
        return TAUT_NO_MEMORY;
    }
    *certificate = made;
    return TAUT_OK;
}

void taut_certificate_free(taut_certificate *certificate)
{
    if (certificate == NULL) {
        return;
    }
    for (int i = 0; i < certificate->claim_count; i++) {
        taut_free((void *)(size_t)certificate->claims[i].claim);
        taut_free((void *)(size_t)certificate->claims[i].where);
    }
    taut_free(certificate->claims);
    taut_free(certificate->construct);
    taut_record_free(certificate->figures);
    taut_free(certificate);
}

taut_status taut_certificate_add(taut_certificate *certificate, const taut_claim *claim)
{
    taut_claim *claims = NULL;
    char *name = NULL, *where = NULL;
    size_t count = 0;

    if (certificate == NULL || claim == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    count = (size_t)certificate->claim_count;
    claims = certificate->claims;
    if ((count & (count - 1)) == 0) { /* full: room doubles at powers of two */
        claims = taut_realloc(claims, count > 0 ? 2 * count : 1, sizeof *claims);
        if (claims == NULL) {
            return TAUT_NO_MEMORY;
        }
        certificate->claims = claims;
    }
    name = text_copy(claim->claim);
    where = text_copy(claim->where);
    if (name == NULL || where == NULL) {
        taut_free(name);
        taut_free(where);
        return TAUT_NO_MEMORY;
    }
    claims[count] = *claim;
    claims[count].claim = name;
    claims[count].where = where;
    certificate->claim_count++;
    return TAUT_OK;
}

void taut_certificate_set_figures(taut_certificate *certificate, taut_record *figures)
{
    if (certificate->figures != figures) {
        taut_record_free(certificate->figures);
    }
    certificate->figures = figures;
}

taut_status taut_certificate_copy(const taut_certificate *certificate, taut_certificate **copy)
{
    taut_certificate *made = NULL;
    taut_status status = TAUT_OK;
    if (certificate == NULL || copy == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    status = taut_certificate_new(certificate->construct, &made);
    for (int i = 0; status == TAUT_OK && i < certificate->claim_count; i++) {
        status = taut_certificate_add(made, &certificate->claims[i]);
    }
    if (status == TAUT_OK && certificate->figures != NULL) {
        taut_record *figures = taut_record_copy(certificate->figures);
        taut_certificate_set_figures(made, figures);
        status = figures != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    }
    if (status != TAUT_OK) {
        taut_certificate_free(made);
        return status;
    }
    *copy = made;
    return TAUT_OK;
}

const char *taut_claim_kind_name(taut_claim_kind kind)
{
    static const char *const names[] = {
        [TAUT_CHECK] = "check", [TAUT_BOUND] = "bound", [TAUT_EXACT] = "exact"};
    return (int)kind >= 0 && kind <= TAUT_EXACT ? names[kind] : "";
}

const char *taut_certificate_construct(const taut_certificate *certificate)
{
    return certificate->construct;
}

taut_verdict taut_certificate_holds(const taut_certificate *certificate)
{
    taut_verdict verdict = TAUT_TRUE;
    for (int i = 0; i < certificate->claim_count; i++) {
        if (certificate->claims[i].holds == TAUT_FALSE) {
            return TAUT_FALSE;
        }
        if (certificate->claims[i].holds == TAUT_UNDECIDED &&
            strcmp(certificate->claims[i].claim, "least") != 0) {
            verdict = TAUT_UNDECIDED;
        }
    }
    return verdict;
}

int taut_certificate_claim_count(const taut_certificate *certificate)
{
    return certificate->claim_count;
}

const taut_claim *taut_certificate_claim(const taut_certificate *certificate, int i)
{
    return i >= 0 && i < certificate->claim_count ? &certificate->claims[i] : NULL;
}

const taut_record *taut_certificate_figures(const taut_certificate *certificate)
{
    return certificate->figures;
}
