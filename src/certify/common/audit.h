/* audit.h -- what a certificate is asked for, and who looks. */
#ifndef TAUT_CERTIFY_COMMON_AUDIT_H
#define TAUT_CERTIFY_COMMON_AUDIT_H

#include "core/crew.h"

typedef struct taut_audit {
    double tolerance; /* as of taut_certify_options, and so the next */
    int exact;
    taut_crew crew;
} taut_audit;

#endif /* TAUT_CERTIFY_COMMON_AUDIT_H */
