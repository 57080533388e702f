/* taut/certify.h -- certificates: numbers that prove what a model claims to be.
 *
 * A certificate is computed from the finished model and the problem, never from what the
 * construction knew, by code that the construction does not share (a check on the includes keeps it
 * so).
 */
#ifndef TAUT_CERTIFY_H
#define TAUT_CERTIFY_H

#include "taut/record.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum taut_verdict {
    TAUT_FALSE = 0,
    TAUT_TRUE = 1,
    TAUT_UNDECIDED = 2 /* rounding leaves it open: `holds` is null */
} taut_verdict;

/* What a claim rests on. *Proved* is said of the second and the third only. */
typedef enum taut_claim_kind {
    TAUT_CHECK = 0, /* compared at places */
    TAUT_BOUND = 1, /* an inequality proved over the whole domain, rounding counted */
    TAUT_EXACT = 2  /* an identity, in integers, rationals or to rounding in coefficients */
} taut_claim_kind;

typedef struct taut_claim {
    const char *claim; /* its name, such as "stationary" */
    taut_claim_kind kind;
    double residual; /* what was found */
    double limit;    /* what it was held against */
    taut_verdict holds;
    const char *where; /* "" or the place of the largest residual, or why it is undecided */
    int as_saved;      /* nonzero: read from a document, not proved since */
} taut_claim;

typedef struct taut_certificate taut_certificate;

TAUT_API void taut_certificate_free(taut_certificate *certificate); /* NULL is fine */
/* A deep copy, the caller's. TAUT_NO_MEMORY. */
TAUT_API taut_status taut_certificate_copy(const taut_certificate *certificate,
                                           taut_certificate **copy);

/* The construction's name, such as "dirichlet"; borrowed. */
TAUT_API const char *taut_certificate_construct(const taut_certificate *certificate);
/* "check", "bound" or "exact"; "" for no kind. */
TAUT_API const char *taut_claim_kind_name(taut_claim_kind kind);
/* TAUT_FALSE if any claim is, else TAUT_UNDECIDED if any is, else TAUT_TRUE. A claim `least` that
 * is undecided does not count: it is offered, not owed. */
TAUT_API taut_verdict taut_certificate_holds(const taut_certificate *certificate);
/* The claims, i = 0 .. count-1, NULL beyond; and the figures, an object. Borrowed. */
TAUT_API int taut_certificate_claim_count(const taut_certificate *certificate);
TAUT_API const taut_claim *taut_certificate_claim(const taut_certificate *certificate, int i);
TAUT_API const taut_record *taut_certificate_figures(const taut_certificate *certificate);

/* Building one, for certificates of your own. *certificate is the caller's; names and claims are
 * copied; figures are owned by the certificate from then on, in place of what was there.
 * TAUT_NO_MEMORY. */
TAUT_API taut_status taut_certificate_new(const char *construct, taut_certificate **certificate);
TAUT_API taut_status taut_certificate_add(taut_certificate *certificate, const taut_claim *claim);
TAUT_API void taut_certificate_set_figures(taut_certificate *certificate, taut_record *figures);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_CERTIFY_H */
