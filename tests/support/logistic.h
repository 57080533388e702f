/* logistic.h -- integrals over rational Bezier patches by another route than the library's.
 *
 * With u = 1 / (1 + e^-s) and v alike the square becomes the plane, where the trapezoidal rule is
 * as good as analyticity allows ([TrefethenWeideman2014]). The weight function is
 * (1 - u)^n p(e^s), p with positive coefficients: by Descartes' rule for angles it has no zero with
 * |Im s| < pi / n, however far apart its weights are. So the layers that weights make, of any width,
 * are resolved by one step for all, and the change when the step is halved says how well.
 */
#ifndef TAUT_TEST_LOGISTIC_H
#define TAUT_TEST_LOGISTIC_H

#include "taut/surface.h"

enum { LOGISTIC_AREA, LOGISTIC_DIRICHLET, LOGISTIC_BENDING, LOGISTIC_ISOTHERMAL, LOGISTIC_FIGURES };

/* Area, Dirichlet energy, bending energy, isothermality of one Bezier patch over [0, 1]^2 with or
 * without weights, of degrees 1 to 8: s and t from -reach to reach, `step` apart. */
void logistic_integrals(const taut_surface *surface, double reach, double step,
                        double figures[LOGISTIC_FIGURES]);

#endif /* TAUT_TEST_LOGISTIC_H */
