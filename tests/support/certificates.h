/* certificates.h -- certificates, and what they and models say by name. */
#ifndef TAUT_TEST_CERTIFICATES_H
#define TAUT_TEST_CERTIFICATES_H

#include "taut/construct.h"

/* Of a model against its problem: the index of the construction (problem/construct_list.h) and its
 * problem struct. CHECKs that it can be made; free it. */
taut_certificate *certificate_of(const taut_model *model, int construct, const void *data);

/* The claim of that name; where there is none an undecided one, at "missing". The certificate may
 * be NULL. */
const taut_claim *claim_of(const taut_certificate *certificate, const char *name);
int has_claim(const taut_certificate *certificate, const char *name);

/* The number of that name among the figures of a certificate, the details of a model; NaN if there
 * is none. */
double figure_of(const taut_certificate *certificate, const char *name);
double detail_of(const taut_model *model, const char *name);

#endif /* TAUT_TEST_CERTIFICATES_H */
