/* claims.h -- what the certificates of `harmonic` and `harmonic-extension` share. */
#ifndef TAUT_CERTIFY_HARMONIC_CLAIMS_H
#define TAUT_CERTIFY_HARMONIC_CLAIMS_H

#include "core/crew.h"
#include "taut/certify.h"
#include "taut/harmonic.h"
#include "taut/model.h"

/* Are the surfaces of the model polynomial on bezier bases? TAUT_BAD_INPUT if one is not, or if
 * there are fewer than `least`. */
taut_status taut_harmonic_check_model(const taut_model *model, int least, taut_error *error);

/* Claim `harmonic`, a bound: the largest rho over the surfaces, each over its own rectangle; its limit is
 * 2 (n + m) 2^-53 times the largest coordinate over the size, the rounding of the points through
 * relation (2), whose factors sum to at most 4 n^2 and 4 m^2. With `exact` the residual of the
 * exact points in rational arithmetic, and limit 0; TAUT_IO where there is no module for it.
 * `carried`: the points of all surfaces but the first are those of the first carried on, which met
 * numbers as large; 0: they are not. They are let have twice as much, a third
 * surface (which covers the first: its control net is no smaller) over half the first one's size at least. */
taut_status taut_harmonic_add_harmonic(const taut_model *model, int exact, double carried,
                                       taut_certificate *certificate, taut_error *error);

/* Figures dirichlet_energy and isothermality: numbers for one surface, lists for several. */
taut_status taut_harmonic_add_figures(const taut_model *model, const taut_crew *crew,
                                      taut_record *figures);

/* No limit is above this. */
#define TAUT_HARMONIC_LIMIT 1e-6

/* By which the worst of several surfaces is chosen for one claim: residuals above their own limit
 * first, then those that only the cap of 1e-6 is below, then the others; infinity for NaN. */
double taut_harmonic_rank(double residual, double limit);
/* A claim that holds when residual <= limit, which is held to 1e-6 at most: between that and a
 * larger limit, which rounding explains, it is undecided, as where a number is not finite. */
taut_status taut_harmonic_add_claim(const char *name, taut_claim_kind kind, double residual,
                                    double limit, const char *where, taut_certificate *certificate);

/* Claim `nearest` (of four boundary rows): the largest product, over the boundary, of the distance to the
 * given rows with a harmonic polynomial of norm 1, over the size of the rows. Limit 8 (n + m) 2^-53
 * times the largest coordinate over the size: what rounding the points leaves. */
taut_status taut_harmonic_add_nearest(const taut_surface *surface,
                                      const taut_harmonic_problem *problem, const taut_crew *crew,
                                      taut_certificate *certificate);
/* The largest distance of the edges from the rows, at equal parameters, and the parameters there.
 */
void taut_harmonic_fit_gap(const taut_surface *surface, const taut_harmonic_problem *problem,
                           double *gap, double at[2]);

#endif /* TAUT_CERTIFY_HARMONIC_CLAIMS_H */
