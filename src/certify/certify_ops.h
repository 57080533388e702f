/* certify_ops.h -- what the certificate of one construction must provide. */
#ifndef TAUT_CERTIFY_OPS_H
#define TAUT_CERTIFY_OPS_H

#include "certify/common/audit.h"
#include "certify/common/identity.h"
#include "problem/construct_list.h"
#include "taut/construct.h"

typedef struct taut_certify_ops {
    /* data: the problem's struct, or NULL when there is only the model.
     * `certificate` is new and carries the construction's name: add claims and figures. */
    taut_status (*certify)(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error);
    /* Names the objects that the claims are about, as they are to be; data as above. */
    void (*identify)(const taut_model *model, const void *data, taut_identity *identity);
    int exact; /* nonzero: knows audit->exact */
} taut_certify_ops;

/* The public function of one construction: checks the arguments, makes a certificate with the
 * construction's name, lets `ops` fill it and adds the claim `identity`; NULL options are none. */
taut_status taut_certify_with(const taut_certify_ops *ops, const char *construct,
                              const taut_model *model, const void *data,
                              const taut_certify_options *options, taut_certificate **certificate,
                              taut_error *error);

#define TAUT_CERTIFY_DECLARE(identifier, name)                                                     \
    extern const taut_certify_ops taut_certify_##identifier;
TAUT_CONSTRUCT_LIST(TAUT_CERTIFY_DECLARE)
#undef TAUT_CERTIFY_DECLARE

#endif /* TAUT_CERTIFY_OPS_H */
