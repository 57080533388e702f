/* regular.h -- the claim `regular`: nowhere on the closed surface are R_u and R_v parallel, or 0.
 *
 * The sine between R_u and R_v is bounded from below over pieces that are halved until the bound is
 * near the smallest sine found, or says enough (certify/common/tangents.h). Proved for the whole
 * domain, rounding counted: kind `bound`. The same for every parameter that goes with u alone or v
 * alone, so neither ranges nor weights c^i d^j matter. On c- and h- bases with spans wider than 4
 * nothing is proved.
 */
#ifndef TAUT_CERTIFY_COMMON_REGULAR_H
#define TAUT_CERTIFY_COMMON_REGULAR_H

#include "core/crew.h"
#include "taut/certify.h"
#include "taut/surface.h"

#include <stdint.h>

#define TAUT_REGULAR_LEAST 1e-6 /* a sine at or below this is none */

enum { TAUT_REGULAR_TEXT = 160 };

typedef struct taut_regular {
    taut_verdict holds;
    double sine;    /* the smallest found; 0 where R_u or R_v is 0 to rounding */
    double at[2];   /* u, v there */
    double bound;   /* the smallest sine is no less: 0 where nothing is proved */
    int64_t pieces; /* that were looked at */
    char where[TAUT_REGULAR_TEXT];
} taut_regular;

/* TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_certify_regular(const taut_surface *surface, const taut_crew *crew,
                                 taut_regular *regular);

/* The claim; and the figure `regular_bound`, null where nothing is proved. */
taut_status taut_certify_add_regular(const taut_regular *regular, taut_certificate *certificate);
void taut_certify_regular_figure(const taut_regular *regular, taut_record *figures);
/* All of it at once. TAUT_NO_MEMORY. */
taut_status taut_certify_add_regular_of(const taut_surface *surface, const taut_crew *crew,
                                        taut_certificate *certificate, taut_record *figures);

#endif /* TAUT_CERTIFY_COMMON_REGULAR_H */
