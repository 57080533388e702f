/* worst.h -- the worst that a claim has seen so far, and where. */
#ifndef TAUT_CERTIFY_PATTERN_WORST_H
#define TAUT_CERTIFY_PATTERN_WORST_H

#include "certify/common/verdict.h"

#include <stdio.h>
#include <string.h>

typedef struct taut_worst {
    double residual;
    char where[96];
} taut_worst;

static inline void taut_worst_take(taut_worst *w, double residual, const char *name, double t)
{
    const double larger = taut_certify_max(w->residual, residual);
    if (w->where[0] == '\0' || !(larger == w->residual)) {
        snprintf(w->where, sizeof w->where, "%.40s at %.6g", name, t);
    }
    w->residual = larger;
}

/* What was found beside it, of what comes after. */
static inline void taut_worst_join(taut_worst *w, const taut_worst *next)
{
    const double larger = taut_certify_max(w->residual, next->residual);
    if (w->where[0] == '\0' || !(larger == w->residual)) {
        memcpy(w->where, next->where, sizeof w->where);
    }
    w->residual = larger;
}

/* Adds the claim: below the limit. TAUT_NO_MEMORY. */
static inline taut_status taut_worst_add(const taut_worst *w, const char *name,
                                         taut_claim_kind kind, double limit,
                                         taut_certificate *certificate)
{
    taut_claim claim = {
        .claim = name, .kind = kind, .residual = w->residual, .limit = limit, .where = w->where};
    claim.holds = isinf(w->residual) ? TAUT_FALSE : taut_certify_below(w->residual, limit);
    return taut_certificate_add(certificate, &claim);
}

#endif /* TAUT_CERTIFY_PATTERN_WORST_H */
