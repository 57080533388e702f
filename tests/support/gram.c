#include "gram.h"

#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

enum { DEGREE_MAX = 15 };

const char *const gram_names[GRAM_KINDS] = {"uniform", "graded", "random", "repeated", "mirrored"};

static double next_random(unsigned long long *state)
{
    unsigned long long x = *state += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    x ^= x >> 31;
    return (double)(x >> 11) * 0x1p-53;
}

static double span_length(gram_knots kind, int degree, int spans, int s, unsigned seed)
{
    const int mirror = kind == GRAM_MIRRORED && s > spans - 1 - s ? spans - 1 - s : s;
    unsigned long long state = (unsigned long long)seed * 1000003u + (unsigned long long)mirror;
    switch ((int)kind) {
    case GRAM_GRADED:
        return spans > 1 ? pow(10.0, -6.0 * s / (spans - 1)) : 1.0;
    case GRAM_RANDOM:
    case GRAM_MIRRORED:
        return 0.1 + 0.9 * next_random(&state);
    case GRAM_REPEATED:
        return s % (degree + 2) == 0 ? 1.0 : s % (degree + 2) <= degree - 1 ? 0.0 : 1.0;
    default:
        return 1.0;
    }
}

void gram_knots_make(gram_knots kind, int degree, int count, unsigned seed, double *knots)
{
    const int spans = count - degree;
    double at = 0.0;
    for (int i = 0; i <= degree; i++) {
        knots[i] = 0.0;
    }
    for (int s = 0; s < spans; s++) {
        double length = span_length(kind, degree, spans, s, seed);
        at += s == spans - 1 && length == 0.0 ? 1.0 : length;
        knots[degree + 1 + s] = at;
    }
    for (int i = 0; i < degree; i++) {
        knots[count + 1 + i] = at;
    }
    if (kind == GRAM_MIRRORED) { /* exactly symmetric about 0 */
        for (int i = 0; i <= (count + degree) / 2; i++) {
            knots[i] = -(knots[count + degree - i] = (knots[count + degree - i] - knots[i]) / 2.0);
        }
    }
}

/* Values and first derivatives of the degree + 1 functions on knot span `span`, at the point
 * `after` behind its start and `before` in front of its end: distances to the knots are sums of
 * lengths, so nothing cancels and mirrored knots give mirrored values. */
static void basis(int degree, const double *knots, int span, double after, double before,
                  double *value, double *slope)
{
    double lower[DEGREE_MAX + 1] = {1.0};
    value[0] = 1.0;
    for (int p = 1; p <= degree; p++) {
        memcpy(lower, value, (size_t)p * sizeof *lower);
        double carried = 0.0;
        for (int r = 0; r < p; r++) {
            const double to_right = (knots[span + 1 + r] - knots[span + 1]) + before;
            const double from_left = (knots[span] - knots[span + 1 + r - p]) + after;
            const double width = knots[span + 1 + r] - knots[span + 1 + r - p];
            value[r] = carried + to_right * lower[r] / width;
            carried = from_left * lower[r] / width;
        }
        value[p] = carried;
    }
    for (int r = 0; r <= degree; r++) {
        slope[r] = 0.0;
        if (r > 0) {
            slope[r] += degree * lower[r - 1] / (knots[span + r] - knots[span + r - degree]);
        }
        if (r < degree) {
            slope[r] -= degree * lower[r] / (knots[span + 1 + r] - knots[span + 1 + r - degree]);
        }
    }
}

static void add_span(int degree, const double *knots, int span, int first, int last,
                     taut_band *stiff, taut_band *mass)
{
    double node[DEGREE_MAX + 1], weight[DEGREE_MAX + 1], value[DEGREE_MAX + 1],
        slope[DEGREE_MAX + 1];
    taut_gauss_rule(degree + 1, node, weight);
    const double half = (knots[span + 1] - knots[span]) / 2.0;
    for (int g = 0; g <= degree; g++) {
        basis(degree, knots, span, half * (1.0 + node[g]), half * (1.0 - node[g]), value, slope);
        for (int r = 0; r <= degree; r++) {
            for (int s = 0; s <= r; s++) {
                const int i = span - degree + r, j = span - degree + s;
                if (j >= first && i <= last) {
                    taut_band_row(stiff, i - first)[r - s] +=
                        half * weight[g] * slope[r] * slope[s];
                    taut_band_row(mass, i - first)[r - s] += half * weight[g] * value[r] * value[s];
                }
            }
        }
    }
}

int gram_make(int degree, int count, const double *knots, int first, int last, taut_band *stiff,
              taut_band *mass)
{
    if (taut_band_init(last - first + 1, degree, stiff) != TAUT_OK) {
        return 0;
    }
    if (taut_band_init(last - first + 1, degree, mass) != TAUT_OK) {
        taut_band_clear(stiff);
        return 0;
    }
    for (int span = degree; span < count; span++) {
        if (knots[span + 1] > knots[span]) {
            add_span(degree, knots, span, first, last, stiff, mass);
        }
    }
    return 1;
}
