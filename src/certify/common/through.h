/* through.h -- points that the problem wants the surface to pass through: the claim `through`, and what holds the surface there.
 *
 * A surface that is held at S(u_k, v_k) rests where
 *
 *     dD/dP_ij = sum_k mu_k c_k,ij,    c_k,ij = dS(u_k, v_k)/dP_ij,
 *
 * at every unknown point, for some multipliers mu_k (the forces of the supports). Any mu proves that much: they are the
 * certificate's own, of least squares over the unknown points.
 */
#ifndef TAUT_CERTIFY_COMMON_THROUGH_H
#define TAUT_CERTIFY_COMMON_THROUGH_H

#include "core/arena.h"
#include "taut/certify.h"
#include "taut/dirichlet.h"
#include "taut/model.h"

/* places[through_count]: the problem's, with the parameters of the model's details where it gives none, in the arena.
 * TAUT_BAD_INPUT where the details have none in range; TAUT_NO_MEMORY. */
taut_status taut_certify_through_places(const taut_model *model,
                                        const taut_dirichlet_problem *problem, taut_arena *arena,
                                        taut_through **places, taut_error *error);

/* The claim: the largest distance over the size of what the problem gives (known points and points to pass through, the
 * largest difference of a coordinate from the first of these). Limit 64 (k + l) 2^-53 times what rounds, k and l the functions alive: evaluation loses less. A bound, the errors of all that is computed in it, by the Bernstein
 * coefficients of the span about the point (certify/common/field.h) where these know the basis and that is
 * below the limit; else a check by evaluation. TAUT_NO_MEMORY. */
taut_status taut_certify_add_through(const taut_surface *surface,
                                     const taut_dirichlet_problem *problem,
                                     const taut_through *places, taut_certificate *certificate);

/* gradient double[nu][nv][3] less sum mu_k c_k at the unknown points; with directions double[nu][nv][3], unit ones, along which the
 * points move, at unknown points what is left of its part along them, times them; gross double[nu][nv] more by what rounding of
 * that acts on; *held the largest of what was taken. TAUT_NO_MEMORY. */
taut_status taut_certify_release(const taut_surface *surface, const unsigned char *known,
                                 const double *directions, const taut_through *places, int count,
                                 double *gradient, double *gross, double *held);

#endif /* TAUT_CERTIFY_COMMON_THROUGH_H */
