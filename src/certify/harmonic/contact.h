/* contact.h -- how two Bezier surfaces meet along an edge, proved over the whole of it from
 * coefficients (certify/common/field.h). */
#ifndef TAUT_CERTIFY_HARMONIC_CONTACT_H
#define TAUT_CERTIFY_HARMONIC_CONTACT_H

#include "core/arena.h"
#include "taut/certify.h"
#include "taut/join.h"
#include "taut/surface.h"

typedef struct taut_contact {
    double residual; /* nowhere on the edge is it larger */
    double limit;    /* what rounding the points explains of it */
    double seen;     /* somewhere it is this large */
    const char *why; /* it is undecided; else NULL */
} taut_contact;

/* Gap over size, and |P_across - Q_across| over the largest coefficient of both, p's `edge` on the
 * opposite one of q; the derivatives by parameter length. Limit
 *     16 2^-53 (n + m) max(1, n S / (width D)),
 * what rounding points of size S leaves of derivatives of size D, n degree and width of q. */
taut_contact taut_contact_c1(const taut_surface *p, const taut_surface *q, taut_edge edge,
                             taut_arena *arena);

/* Gap over size, and |N_p x N_q| / (|N_p| |N_q|), the sine between the normals N_p = P_across x
 * P_along, N_q, by coefficients of the numerator and of |N|^2 on pieces of the edge. Undecided where
 * a normal cannot be told from 0. Limit that of c1 over the least of |N| / (|P_across| |P_along|). */
taut_contact taut_contact_g1(const taut_surface *p, const taut_surface *q, taut_edge edge,
                             taut_arena *arena);

/* As c1, of Q_across - c P_across - (alpha + beta s) P_along, s from 0 to 1 along the edge; across is
 * outwards from p. */
taut_contact taut_contact_rule(const taut_surface *p, const taut_surface *q, taut_edge edge,
                               const double rule[3], taut_arena *arena);

/* Is q's range across beyond p's edge, and along the same? */
int taut_contact_ranges(const taut_surface *p, const taut_surface *q, taut_edge edge);

#endif /* TAUT_CERTIFY_HARMONIC_CONTACT_H */
