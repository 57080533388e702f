/* field.h -- the fields of directions whose curves are traced, and what those curves do at a point.
 *
 * A direction is a line: (a, b) up to sign, of unit length in space. Families are geometric: `+` has
 * tau_g > 0, `-` has tau_g < 0, `max` bends by k1, `min` by k2 <= k1 ([doCarmo1976] chapter 3).
 */
#ifndef TAUT_TRACE_FIELD_H
#define TAUT_TRACE_FIELD_H

#include "taut/trace.h"
#include "trace/carrier.h"

typedef struct taut_linefield_kind {
    taut_trace_net net;
    int family; /* 0 (`+`, `max`, u held) or 1 (`-`, `min`, v held) */
} taut_linefield_kind;

/* Why there is no direction. */
typedef enum taut_linefield_fault {
    TAUT_LINEFIELD_FINE = 0,
    TAUT_LINEFIELD_ELLIPTIC, /* K > 0 */
    TAUT_LINEFIELD_ROUND,    /* R is nothing: flat or umbilic */
    TAUT_LINEFIELD_SINGULAR, /* the normal vanishes */
    TAUT_LINEFIELD_CREASE    /* it jumps */
} taut_linefield_fault;

/* Is |x_u x x_v| more there than rounding? */
int taut_linefield_has_normal(const taut_carrier *carrier, const taut_form_pair *q);

/* The direction of the family: of unit length in space, of either sign. */
taut_linefield_fault taut_linefield_direction(const taut_carrier *carrier, taut_linefield_kind kind,
                                              const taut_form_pair *forms, double ab[2]);
/* The same of an asymptotic curve with `d` in place of sqrt(M^2 - LN): near K = 0, where d is known
 * better than that. */
void taut_linefield_asymptotic(const taut_form_pair *forms, int family, double d, double ab[2]);

/* x_u a + x_v b. */
void taut_linefield_tangent(const double x[TAUT_CARRIER_VECTORS][3], const double ab[2],
                            double tangent[3]);

/* Normal curvature and geodesic torsion of a unit direction. */
double taut_linefield_normal_curvature(const taut_form_pair *forms, const double ab[2]);
double taut_linefield_torsion(const taut_form_pair *forms, const double ab[2]);

/* The second derivative over arc length of the curve of the family through the point, in the window
 * (a', b'), of derivatives up to the third. Geodesics: of derivatives up to the second. 0 where it
 * is infinite. */
int taut_linefield_bend(taut_trace_net net, const double x[TAUT_CARRIER_VECTORS][3],
                        const taut_form_pair *forms, const double ab[2], double bend[2]);
/* x'' = a' x_u + b' x_v + Q. */
void taut_linefield_acceleration(const double x[TAUT_CARRIER_VECTORS][3], const double ab[2],
                                 const double bend[2], double out[3]);

/* What equal parts are measured by, per arc length: (-K)^(1/4) or R^(1/2); 0 where there is none. */
double taut_linefield_measure(taut_trace_net net, const taut_form_pair *forms);

#endif /* TAUT_TRACE_FIELD_H */
