#include "construct/asymptotic/inflection.h"

#include "core/vec3.h"
#include "numeric/bernstein.h"

#include <string.h>

/* |q| at its least over its largest coefficient: q is a product of differences of the data, known
 * to some times the data's rounding, and a curve whose data is given to ten digits still has its
 * inflection. */
static const double zero_cut = 1e-10, zero_factor = 64.0;
/* And over what is summed there, sum |q_j| B_j: where that is as small as |q| itself nothing
 * cancels, and a small q is no zero. */
static const double cancels = 1e-6;
enum { LENGTH = TAUT_BERNSTEIN_MAX + 1, SAMPLES_PER_DEGREE = 8, BISECTIONS = 60 };

/* q.q' at t: half the derivative of |q|^2. */
static double slope_at(int degree, double (*q)[3], double (*derivative)[3], double t)
{
    double value[3], slope[3];
    taut_bernstein_point(degree, 3, &q[0][0], t, value, NULL);
    taut_bernstein_point(degree - 1, 3, &derivative[0][0], t, slope, NULL);
    return taut_dot(value, slope);
}

static double length_at(int degree, double (*q)[3], double t)
{
    double value[3];
    taut_bernstein_point(degree, 3, &q[0][0], t, value, NULL);
    return taut_norm(value);
}

/* The parameter of least |q| in [0, 1], among the ends and the minima that the samples separate. */
static double least_place(int degree, double (*q)[3])
{
    double derivative[LENGTH][3], best = 0.0, least = length_at(degree, q, 0.0);
    const int samples = SAMPLES_PER_DEGREE * degree;
    for (int j = 0; j < degree; j++) {
        taut_difference(q[j + 1], q[j], derivative[j]);
    }
    if (length_at(degree, q, 1.0) < least) {
        best = 1.0;
        least = length_at(degree, q, 1.0);
    }
    for (int k = 0; k < samples; k++) {
        double low = (double)k / samples, high = (k + 1.0) / samples;
        if (!(slope_at(degree, q, derivative, low) <= 0) ||
            !(slope_at(degree, q, derivative, high) >= 0)) {
            continue;
        }
        for (int step = 0; step < BISECTIONS; step++) {
            const double middle = 0.5 * (low + high);
            if (slope_at(degree, q, derivative, middle) < 0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        if (length_at(degree, q, low) < least) {
            best = low;
            least = length_at(degree, q, low);
        }
    }
    return best;
}

static double summed_at(int degree, double (*q)[3], double t)
{
    double lengths[LENGTH], sum = 0.0;
    for (int j = 0; j <= degree; j++) {
        lengths[j] = taut_norm(q[j]);
    }
    taut_bernstein_point(degree, 1, lengths, t, &sum, NULL);
    return sum;
}

static double largest_coefficient(int degree, double (*q)[3])
{
    double most = 0.0;
    for (int j = 0; j <= degree; j++) {
        most = fmax(most, taut_norm(q[j]));
    }
    return most;
}

int taut_inflections_remove(int degree, double rounding, double (*q)[3], double *at)
{
    const double cut = zero_cut + zero_factor * rounding;
    int left = degree, count = 0;
    double work[LENGTH][3];
    while (left > 0) {
        const double place = least_place(left, q);
        int k = count;
        if (!(length_at(left, q, place) <=
              fmin(cut * largest_coefficient(left, q), cancels * summed_at(left, q, place)))) {
            break;
        }
        taut_bernstein_deflate(left, 3, &q[0][0], place, &work[0][0]);
        left--;
        memcpy(q, work, (size_t)(left + 1) * sizeof *q);
        for (; k > 0 && at[k - 1] > place; k--) {
            at[k] = at[k - 1];
        }
        at[k] = place;
        count++;
    }
    taut_bernstein_raise(left, 3, &q[0][0], degree - left, &work[0][0]);
    memcpy(q, work, (size_t)(degree + 1) * sizeof *q);
    return count;
}
