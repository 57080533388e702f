/* forms.c -- fundamental forms and curvatures at one point ([WuWang2011] section 2.6).
 *
 * With x_u = a p, x_v = b q, a and b the powers of two that bring p and q to size 1, and e, f, g, w
 * the first form of p and q,
 *     H = (L/a^2 g - 2 M/(ab) f + N/b^2 e) / (2 w^2),   K = (L/a^2 N/b^2 - (M/(ab))^2) / w^2:
 * nothing is squared that is not of size 1, so that coordinates and parameters of any size neither
 * overflow nor underflow before the result itself does.
 */
#include "taut/measure.h"

#include "core/vec3.h"

#include <math.h>

/* unit = v / 2^exponent with its largest component in [1/2, 1); a zero vector stays, exponent 0. */
static int normalise(const double *v, double *unit)
{
    const double largest = taut_largest_coordinate(v);
    int exponent = 0;
    frexp(largest, &exponent);
    if (largest == 0 || !isfinite(largest)) {
        exponent = 0;
    }
    for (int c = 0; c < 3; c++) {
        unit[c] = ldexp(v[c], -exponent);
    }
    return exponent;
}

/* Does the normal vanish? w is |p x q|. Two reasons, neither of which knows the unit of length or
 * of the parameters:
 *
 * W <= 2^-40 |x_u||x_v|: the directions differ by less than 1e-12, while rounding alone turns each
 * by about 1e-15 times the degree; a normal from them would have three digits at best.
 *
 * W <= 2^-46 |x||x_uv|: along a collapsed edge x_v should be 0 but is a sum that cancels only to
 * eps |x| times the speed of the basis functions, d. There x_u and x_uv do not vanish, and |x_uv|
 * is about d |x_u|, so the noise makes W about 2^-53 |x||x_uv|; the rest is for the degree. */
static int vanishes(double w, int exponent, double e, double g, const double values[6][3])
{
    double x[3], twist[3];
    const int shift = normalise(values[TAUT_X], x) + normalise(values[TAUT_XUV], twist) - exponent;
    const double noise = sqrt(taut_dot(x, x) * taut_dot(twist, twist));

    return !(w > 0x1p-40 * sqrt(e * g)) || !(w > ldexp(noise, shift - 46));
}

static void find_curvatures(int a, int b, double e, double f, double g, double w, taut_forms *forms)
{
    const double l = ldexp(forms->l, -2 * a);
    const double m = ldexp(forms->m, -a - b);
    const double n = ldexp(forms->n, -2 * b);
    const double second[3] = {l, m, n};
    double unit[3];
    const int c = normalise(second, unit);

    forms->mean = ldexp((unit[0] * g - 2 * unit[1] * f + unit[2] * e) / (2 * w * w), c);
    forms->gaussian = ldexp((unit[0] * unit[2] - unit[1] * unit[1]) / (w * w), 2 * c) + 0.0;
}

void taut_forms_of(const double values[6][3], taut_forms *forms)
{
    double p[3], q[3], n[3];
    const int a = normalise(values[TAUT_XU], p), b = normalise(values[TAUT_XV], q);
    const double e = taut_dot(p, p), f = taut_dot(p, q), g = taut_dot(q, q);
    double w = 0;

    taut_cross(p, q, n);
    w = taut_length(n);
    forms->e = ldexp(e, 2 * a);
    forms->f = ldexp(f, a + b);
    forms->g = ldexp(g, 2 * b);
    forms->w = ldexp(w, a + b);
    forms->regular = isfinite(w) && !vanishes(w, a + b, e, g, values);
    for (int c = 0; c < 3; c++) {
        forms->normal[c] = forms->regular ? n[c] / w : nan("");
    }
    forms->l = taut_dot(values[TAUT_XUU], forms->normal);
    forms->m = taut_dot(values[TAUT_XUV], forms->normal);
    forms->n = taut_dot(values[TAUT_XVV], forms->normal);
    forms->mean = forms->gaussian = nan("");
    if (forms->regular) {
        find_curvatures(a, b, e, f, g, w, forms);
    }
}
