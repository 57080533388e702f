/* flux.h -- how far the area of a film is above the flux of a dual field, proved.
 *
 *     N = S_u x S_v = n / w^3,    S = (X, Y, Z) / w in a frame whose third axis is e
 *     q = psi_u (x_v, y_v) - psi_v (x_u, y_u) = Q / w^3,    J = N_z,    s = sign J
 *
 * The field X = (q_1, q_2, s sqrt(J^2 - |q|^2)) / J is (-psi_y, psi_x, s sqrt(1 - |grad psi|^2)) over
 * the film's projection: of length 1, and without divergence. With m = s n / |n|, e = Q |n| - |J| n_h
 * (so that X_h - m_h = e / (J |n|)), area less flux is
 *
 *     A - D = iint |N| |m - X|^2 / 2 du dv
 *           = 1/2 iint |e|^2 / (w^3 J^2 |n|)
 *           + 1/2 iint (e.n_h + |e|^2 / 2|J|)^2 / (w^3 J^4 |n|) r^-2,    r = (m_z + X_z) |n| / 2|J|
 *
 * as both are unit vectors. It is bounded from above, not computed. On each cell take polynomials
 *
 *     T ~ |n|,   R ~ |n|^(1/2),   K ~ w^(1/2),   V ~ 1 / (w^(3/2) J |n|^(1/2)),   U ~ V / J
 *     E = Q T - |J| n_h
 *
 * which may be any, as what they lack is bounded by coefficients too:
 *
 *     ||n| - T|   <= d = max |n.n - T^2| / (min |n| + min T),      |e - E| <= |Q| d <= |J| d
 *     1 / (w^3 J^2 |n|) <= c V^2,    1 / c  = min(w K V J R)^2   (1 - k) (1 - l) (1 - d / min T)
 *     1 / (w^3 J^4 |n|) <= b U^2,    1 / b  = min(w K U J^2 R)^2 (1 - k) (1 - l) (1 - d / min T)
 *     w >= (1 - k) K^2,    T >= (1 - l) R^2,    r >= 1 - max |e| max |n|^2 / min |n| min |J|^3
 *
 *     A - D <= sum over cells of c/2 (||V E|| + d max |V J|)^2
 *            + b/2 (||U E.n_h|| + d max |U J| |n| + max |U| |e|^2 / 2 min |J|)^2 / min r^2
 *
 * with ||f|| the root of the integral of f^2, from its coefficients. R, K, V, U are of degree 3, as they
 * only weigh; T is of as high a degree as makes d small beside the root of the gap, for one of twice the
 * degree does what four cells do. Cells are halved both ways while the bound is far above what it is
 * without d and with b = c = r = 1. All coefficients know their rounding errors, those of a product one
 * bound for all (certify/common/field.h).
 */
#ifndef TAUT_CERTIFY_PLATEAU_FLUX_H
#define TAUT_CERTIFY_PLATEAU_FLUX_H

#include "core/crew.h"
#include "taut/surface.h"

/* What is to be compared: a film on polynomial bases, and psi on the same breaks. */
typedef struct taut_flux_task {
    const taut_surface *surface;
    const taut_basis *u, *v;    /* of psi */
    const double *coefficients; /* double[count of u][count of v], scaled by 2^-exponent */
    double frame[3][3];         /* rows within frame_error of an orthonormal right-handed frame */
    double frame_error;
    double wanted;       /* share of the area that A - D is to be within: tight from there on */
    int exponent;        /* the film is scaled by 2^-exponent */
    int weight_exponent; /* weights are scaled by 2 to minus this */
    double sign;         /* of J, once it is known; 0 before */
    const taut_crew *crew;
} taut_flux_task;

typedef enum taut_flux_verdict {
    TAUT_FLUX_ADMITTED = 0,
    TAUT_FLUX_FOLDS, /* J is not shown to be of one sign */
    TAUT_FLUX_STEEP, /* |grad psi| <= 1 is not shown */
    TAUT_FLUX_WORK,  /* it would take too long */
    TAUT_FLUX_RANGE  /* a value leaves the range of doubles */
} taut_flux_verdict;

/* In squares of 2^exponent. */
typedef struct taut_flux_bound {
    taut_flux_verdict verdict;
    double gap;                 /* A - D is no more */
    double area_low, area_high; /* the area of the film lies between */
    double shadow;              /* the area of its projection is no less */
} taut_flux_bound;

/* Sets task->sign, and the bound whatever it returns. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_certify_flux(taut_flux_task *task, taut_flux_bound *bound);

#endif /* TAUT_CERTIFY_PLATEAU_FLUX_H */
