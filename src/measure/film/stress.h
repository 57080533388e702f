/* stress.h -- what threads along u and v (warp and weft) pull with at a point of a film of force densities a and b, by the figures
 * of its certificate. To be looked at: what is proved is the certificate's.
 *
 *     a |x_u| / |x_v|,    b |x_v| / |x_u|,    u and v over [0, 1]        force per width ([Schek1974], docs/film.md)
 */
#ifndef TAUT_MEASURE_FILM_STRESS_H
#define TAUT_MEASURE_FILM_STRESS_H

#include "taut/measure.h"
#include "taut/model.h"

/* a and b of a surface of the model, `force_density` among the figures of its certificate: of films of many patches a list by their
 * order, in which their images go on. 0 where there are none. */
int taut_stress_densities(const taut_model *model, const taut_surface *surface,
                          double densities[2]);

/* Along u and along v, in terms of the first fundamental form there; NaN where x_u or x_v is 0. */
void taut_stress_of(const taut_surface *surface, const double densities[2], const taut_forms *forms,
                    double stress[2]);

#endif /* TAUT_MEASURE_FILM_STRESS_H */
