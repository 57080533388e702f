#include "certify/asymptotic/apart.h"

#include "certify/common/bernstein.h"
#include "certify/common/verdict.h"
#include "core/constants.h"
#include "core/twice.h"
#include "core/vec3.h"

#include <string.h>

enum { CHANNELS = 4 /* D, d */, CUTS = 10 };
static const double sharp = 1.25;        /* times what is seen: not made sharper */
static const double slack = 1 + 0x1p-40; /* over the roundings of d, which has no terms below 0 */

static double weight_of(const taut_bezier_row *row, int i)
{
    return row->weights != NULL ? row->weights[i * row->stride] : 1.0;
}

/* c[k] = D_k and d_k, rounded once. */
static void fill_difference(const taut_bezier_row *a, const taut_bezier_row *b,
                            double c[][CHANNELS])
{
    const int degree = a->degree + b->degree;
    for (int k = 0; k <= degree; k++) {
        taut_twice sum[CHANNELS] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
        for (int i = k > b->degree ? k - b->degree : 0; i <= a->degree && i <= k; i++) {
            const taut_twice ways =
                taut_twice_times(taut_twice_of(taut_certify_binomial(a->degree, i)),
                                 taut_twice_of(taut_certify_binomial(b->degree, k - i)));
            const taut_twice weights = taut_twice_times(taut_twice_of(weight_of(a, i)),
                                                        taut_twice_of(weight_of(b, k - i)));
            const taut_twice part = taut_twice_times(ways, weights);
            for (int d = 0; d < 3; d++) {
                const double apart = a->points[3 * i * a->stride + d];
                const double from = b->points[3 * (k - i) * b->stride + d];
                sum[d] =
                    taut_twice_add(sum[d], taut_twice_times(part, taut_twice_sum(apart, -from)));
            }
            sum[3] = taut_twice_add(sum[3], part);
        }
        for (int d = 0; d < CHANNELS; d++) {
            c[k][d] = taut_twice_over_number(sum[d], taut_certify_binomial(degree, k)).high;
        }
    }
}

/* error: of each coordinate of D. */
static double bound_of(int degree, double c[][CHANNELS], double error, int cuts, double seen)
{
    double low[TAUT_APART_DEGREE + 1][CHANNELS], most = 0, least = INFINITY, halves[2];
    for (int k = 0; k <= degree; k++) {
        most = taut_certify_max(most, taut_norm(c[k]));
        least = taut_certify_min(least, c[k][3]);
    }
    const double bound = slack * (most + 2 * error) / least;
    if (cuts == 0 || bound <= sharp * seen) {
        return bound;
    }
    taut_certify_halve(degree, CHANNELS, &c[0][0], &low[0][0], &c[0][0]);
    error += degree * TAUT_UNIT_ROUNDOFF * most;
    halves[0] = bound_of(degree, low, error, cuts - 1, seen);
    halves[1] = bound_of(degree, c, error, cuts - 1, seen);
    return taut_certify_max(halves[0], halves[1]);
}

double taut_curves_apart(const taut_bezier_row *a, const taut_bezier_row *b, double seen)
{
    double c[TAUT_APART_DEGREE + 1][CHANNELS], most = 0;
    const int degree = a->degree + b->degree;
    if (degree > TAUT_APART_DEGREE) {
        return INFINITY;
    }
    fill_difference(a, b, c);
    for (int k = 0; k <= degree; k++) {
        most = taut_certify_max(most, taut_norm(c[k]));
    }
    return bound_of(degree, c, 2 * TAUT_UNIT_ROUNDOFF * most, CUTS, seen);
}
