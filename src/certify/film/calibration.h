/* calibration.h -- what a witness proves of all sails that are held alike.
 *
 * A model may carry fields (details.least, docs/film.md): a frame with the third axis e, a convex
 * quadrilateral Q across e, and over its bilinear parameters r(s, t), J = r_s x r_t, polynomials psi,
 * B and for each cable g_k, and a number c_k. Whatever they are,
 *
 *     X   = (-psi_y, psi_x, B_s / J)                on Q x R has no divergence,
 *     A_k = (B grad t + grad g_k, c_k - psi)        has the curl X,
 *
 * and with m the largest of |X| and |A_k| / R_k over Q, R_k = T_k / s, no oriented surface with the
 * boundary of held edges H and cables from P_k to Q_k, all of which lies in Q x R, has
 *
 *     A + sum R_k L_k  <  (1 / m) ( int_H B dt - psi dz - sum [g_k + c_k z] ).
 *
 * m is proved, by coefficients that know their rounding (certify/common/field.h): J > 0 and
 *
 *     B_s^2 + |psi_s r_t - psi_t r_s|^2 <= m^2 J^2,
 *     |g_s r_t - (B + g_t) r_s|^2 + J^2 (c - psi)^2 <= m^2 R^2 J^2
 *
 * on cells that are halved where need be. The integral is by Gauss rules on pieces of the edges, whose errors are bounded
 * (certify/film/circulation.h) and taken off.
 */
#ifndef TAUT_CERTIFY_FILM_CALIBRATION_H
#define TAUT_CERTIFY_FILM_CALIBRATION_H

#include "certify/film/sheet.h"
#include "taut/record.h"

typedef struct taut_film_calibration {
    const char *why; /* there is none; or NULL */
    double flux;     /* the bound of A + sum R_k L_k, in the sheet's unit */
    double off;      /* what rounding and quadrature may have added to it */
} taut_film_calibration;

/* Of a film with four corners that are held. TAUT_NO_MEMORY. */
taut_status taut_film_calibrate(const taut_film_sheet *sheet, const taut_record *witness,
                                taut_film_calibration *calibration);

#endif /* TAUT_CERTIFY_FILM_CALIBRATION_H */
