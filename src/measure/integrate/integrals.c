/* integrals.c -- area, Dirichlet energy, bending energy, isothermality, mean |H|.
 *
 *     A = iint W,   D = 1/2 iint E + G,   B = iint |x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2,
 *     iota = sqrt(iint (E-G)^2 + 4 F^2) / iint E + G,   mean |H| = iint |H| W / A,   mean H^2 alike
 * ([WuWang2011] sections 2.3, 2.6; [NiWang2015] section 8.7). B is the sum over the spans: a crease
 * (a knot where x_u jumps) adds nothing.
 *
 * Fields are integrated with points and parameters scaled to size 1 (integrate.h): a field of dimension
 * length^l u^-i v^-j is brought back by 2^(l scale + (1-i) shift_u + (1-j) shift_v).
 */
#include "measure/integrate/integrals.h"

#include "core/elementary/elementary.h"
#include "measure/integrate/integrate.h"
#include "taut/measure.h"

#include <math.h>

/* Tolerances. A derivative is good to a few roundings of its bound b, so W to 1e-15 b_u b_v; a
 * square s^2 whose root has the error d to 2 s d + d^2 <= t s^2 + (1 + 1/t) d^2 for any t: with d =
 * 1e-15 b and t = 1e-12, to 1e-18 b^2; |H| W like W, with the second derivatives' bounds. H^2 W is
 * as good as the cells of the others make it: beside a point without normal it need not have an
 * integral, and no cell would be small enough. Of a film mean |H| is asked to four digits: it is what its net cannot
 * follow, and roots along its many changes of sign are what more digits cost. */
static const taut_goal area_goals[] = {{1e-11, 1e-15}};
static const taut_goal square_goals[] = {{1e-11, 1e-18}, {1e-11, 1e-18}, {1e-11, 1e-18}};
static const taut_goal all_goals[] = {{1e-11, 1e-15}, {1e-11, 1e-18}, {1e-11, 1e-18},
                                      {1e-11, 1e-18}, {1e-11, 1e-18}, {1e-11, 1e-18},
                                      {1e-11, 1e-18}, {INFINITY, 0},  {2e-7, 1e-12}};
static const taut_goal mean_goals[] = {{1e-11, 1e-15}, {INFINITY, 0}, {5e-5, 1e-12}};

/* Squares of lengths below this lose digits, or all of them: of points scaled to size 1 only where
 * a net is 1e130 times longer than wide. */
static const double smallest = 0x1p-900;

/* The vectors at node j of a batch. */
#define AT(k, c) (x[(3 * (k) + (c)) * stride + j])
#define DOT(k, l) (AT(k, 0) * AT(l, 0) + AT(k, 1) * AT(l, 1) + AT(k, 2) * AT(l, 2))

/* The length of a vector whose square leaves the range of doubles. */
static double length_beyond(const double n[3])
{
    return taut_hypot(taut_hypot(n[0], n[1]), n[2]);
}

/* n[0..2] = x_u x x_v, w its size, reference[0] what w's rounding is proportional to. */
static void normal_fields(int count, int stride, const double *x, const taut_bounds *bounds,
                          double *w, double *reference, double *n)
{
    for (int j = 0; j < count; j++) {
        const double n0 = AT(TAUT_XU, 1) * AT(TAUT_XV, 2) - AT(TAUT_XU, 2) * AT(TAUT_XV, 1);
        const double n1 = AT(TAUT_XU, 2) * AT(TAUT_XV, 0) - AT(TAUT_XU, 0) * AT(TAUT_XV, 2);
        const double n2 = AT(TAUT_XU, 0) * AT(TAUT_XV, 1) - AT(TAUT_XU, 1) * AT(TAUT_XV, 0);
        n[j] = n0;
        n[stride + j] = n1;
        n[2 * stride + j] = n2;
        const double square = n0 * n0 + n1 * n1 + n2 * n2;
        w[j] = square > smallest ? sqrt(square) : length_beyond((const double[3]){n0, n1, n2});
        reference[j] = bounds->cross * bounds->of[TAUT_XU] * bounds->of[TAUT_XV];
    }
}

/* Pair: W; then x_u x x_v. */
static void area_fields(int count, int stride, const double *x, const taut_bounds *bounds,
                        double ratio, double *out)
{
    (void)ratio;
    normal_fields(count, stride, x, bounds, out, out + stride, out + 2 * stride);
}

/* out[0], out[2] = E, G. */
static void stretch_fields(int count, int stride, const double *x, const taut_bounds *bounds,
                           double ratio, double *out)
{
    (void)ratio;
    for (int j = 0; j < count; j++) {
        out[j] = DOT(TAUT_XU, TAUT_XU);
        out[stride + j] = bounds->of[TAUT_XU] * bounds->of[TAUT_XU];
        out[2 * stride + j] = DOT(TAUT_XV, TAUT_XV);
        out[3 * stride + j] = bounds->of[TAUT_XV] * bounds->of[TAUT_XV];
    }
}

/* out[0], out[2], out[4] = |x_uu|^2, |x_uv|^2, |x_vv|^2. */
static void bending_fields(int count, int stride, const double *x, const taut_bounds *bounds,
                           double ratio, double *out)
{
    (void)ratio;
    for (int k = 0; k < 3; k++) {
        const double bound = bounds->of[TAUT_XUU + k];
        for (int j = 0; j < count; j++) {
            out[2 * k * stride + j] = DOT(TAUT_XUU + k, TAUT_XUU + k);
            out[(2 * k + 1) * stride + j] = bound * bound;
        }
    }
}

/* out[0] = (r E - G/r)^2 + 4 F^2; out[2], out[4] = E, G. */
static void isothermality_fields(int count, int stride, const double *x, const taut_bounds *bounds,
                                 double ratio, double *out)
{
    const double bu = bounds->of[TAUT_XU], bv = bounds->of[TAUT_XV];
    const double noise = ratio * bu * bu + bv * bv / ratio;
    stretch_fields(count, stride, x, bounds, ratio, out + 2 * stride);
    for (int j = 0; j < count; j++) {
        const double f = DOT(TAUT_XU, TAUT_XV);
        const double difference = ratio * out[2 * stride + j] - out[4 * stride + j] / ratio;
        out[j] = difference * difference + 4 * f * f;
        out[stride + j] = noise * noise;
    }
}

/* s = H W = (l G - 2 m F + n E) / (2 W^2), l = x_uu . (x_u x x_v) and so on, 0 where there is no
 * normal; square[0] = s^2 / W, pair[0] = |s|. The references have the bounds in place of the second
 * derivatives. */
static void mean_fields(int count, int stride, const double *x, const taut_bounds *bounds,
                        const double *normal, double *square, double *pair, double *s)
{
    for (int j = 0; j < count; j++) {
        const double n0 = normal[j], n1 = normal[stride + j], n2 = normal[2 * stride + j];
        const double e = DOT(TAUT_XU, TAUT_XU), f = DOT(TAUT_XU, TAUT_XV);
        const double g = DOT(TAUT_XV, TAUT_XV), w2 = n0 * n0 + n1 * n1 + n2 * n2;
        const double l = AT(TAUT_XUU, 0) * n0 + AT(TAUT_XUU, 1) * n1 + AT(TAUT_XUU, 2) * n2;
        const double m = AT(TAUT_XUV, 0) * n0 + AT(TAUT_XUV, 1) * n1 + AT(TAUT_XUV, 2) * n2;
        const double n = AT(TAUT_XVV, 0) * n0 + AT(TAUT_XVV, 1) * n1 + AT(TAUT_XVV, 2) * n2;
        const double bound = bounds->of[TAUT_XUU] * g + 2 * bounds->of[TAUT_XUV] * fabs(f) +
                             bounds->of[TAUT_XVV] * e;
        const int is_beyond = e * g < smallest && (n0 != 0 || n1 != 0 || n2 != 0);
        const int regular = w2 > 0x1p-80 * e * g;
        const double w = sqrt(w2);
        s[j] = is_beyond ? (double)NAN : regular ? (l * g - 2 * m * f + n * e) / (2 * w2) : 0;
        pair[j] = fabs(s[j]);
        pair[stride + j] = regular ? bound / (2 * w) : 0;
        square[j] = regular ? s[j] * s[j] / w : 0;
        square[stride + j] = regular ? pair[stride + j] * pair[stride + j] / w : 0;
    }
}

/* Pairs: W; (r E - G/r)^2 + 4 F^2, E, G; |x_uu|^2, |x_uv|^2, |x_vv|^2; s^2 / W; |s|. Then
 * x_u x x_v, s. */
static void all_fields(int count, int stride, const double *x, const taut_bounds *bounds,
                       double ratio, double *out)
{
    normal_fields(count, stride, x, bounds, out, out + stride, out + 18 * stride);
    isothermality_fields(count, stride, x, bounds, ratio, out + 2 * stride);
    bending_fields(count, stride, x, bounds, ratio, out + 8 * stride);
    mean_fields(count, stride, x, bounds, out + 18 * stride, out + 14 * stride, out + 16 * stride,
                out + 21 * stride);
}

/* Pairs: W; s^2 / W; |s|. Then x_u x x_v, s. */
static void bent_fields(int count, int stride, const double *x, const taut_bounds *bounds,
                        double ratio, double *out)
{
    (void)ratio;
    normal_fields(count, stride, x, bounds, out, out + stride, out + 6 * stride);
    mean_fields(count, stride, x, bounds, out + 6 * stride, out + 2 * stride, out + 4 * stride,
                out + 9 * stride);
}

/* Figures from the integrals; the pointers are at the fields of each. */

static double area_of(const taut_integrals *in, const double *w)
{
    return ldexp(w[0], 2 * in->scale);
}

static double dirichlet_of(const taut_integrals *in, const double *eg)
{
    const int ratio = in->shift[1] - in->shift[0];
    return ldexp(eg[0], 2 * in->scale + ratio - 1) + ldexp(eg[2], 2 * in->scale - ratio - 1);
}

static double bending_of(const taut_integrals *in, const double *second)
{
    const int u = in->shift[0], v = in->shift[1], l = 2 * in->scale;
    return ldexp(second[0], l - 3 * u + v) + ldexp(second[2], l - u - v + 1) +
           ldexp(second[4], l + u - 3 * v);
}

/* iint (E-G)^2 + 4 F^2 and iint E + G, of scaled points; the root of the first over the second is
 * to be brought back by isothermality_scaled. */
static double isothermal_square(const taut_integrals *in, const double *iso)
{
    return ldexp(iso[0], -((in->shift[0] + in->shift[1]) & 1));
}

static double isothermal_sum(const taut_integrals *in, const double *iso)
{
    const int ratio = in->shift[1] - in->shift[0];
    return ldexp(iso[2], ratio) + ldexp(iso[4], -ratio);
}

/* The square root of the integral has dimension length^2 (u v)^-1/2. */
static double isothermality_scaled(const taut_integrals *in, double root, double both)
{
    return both == 0 ? 0 : ldexp(root / both, -((in->shift[0] + in->shift[1]) >> 1));
}

static double isothermality_of(const taut_integrals *in, const double *iso)
{
    return isothermality_scaled(in, sqrt(isothermal_square(in, iso)), isothermal_sum(in, iso));
}

/* What is worth a word: an error above 1e-10 of its figure. */
static double told_error(double error, double figure)
{
    return error <= 1e-10 * figure ? 0 : error;
}

/* error[f] becomes what rules differed by, and what rounding may do. The difference is that of the
 * last but one rule: far above the error unless the cells were cut until the limits of integrate.c.
 * W is off by d = 1e-15 b_u b_v; squares s^2 whose roots are off by 1e-15 b by 2 s d + d^2, where
 * iint s d <= sqrt(iint s^2 iint d^2). */
static void add_square_rounding(const taut_integrand *integrand, int from, taut_integrals *in)
{
    const double d = area_goals[0].floor;
    for (int f = 2 * from; f < 2 * integrand->count; f += 2) {
        const double value = in->value[f], reference = in->value[f + 1];
        in->error[f] += 2 * d * sqrt(value * reference) + d * d * reference;
    }
}

/* The same where the first field is W. */
static void add_rounding(const taut_integrand *integrand, taut_integrals *in)
{
    in->error[0] += area_goals[0].floor * in->value[1];
    add_square_rounding(integrand, 1, in);
}

/* d sqrt(s) / sum: where s is smaller than its error, the root of that. */
static double isothermality_error_of(const taut_integrals *in, int at)
{
    const double *iso = in->value + at, *error = in->error + at;
    const double square = isothermal_square(in, iso), apart = isothermal_square(in, error);
    const double both = isothermal_sum(in, iso), root = sqrt(square);
    const double step = fmin(sqrt(apart), root > 0 ? apart / root : INFINITY);
    const double share = both > 0 ? isothermal_sum(in, error) / both : 0;
    return isothermality_scaled(in, step + root * share, both);
}

/* The mean over the area of the integral at `of`, in the unit of the points to the power `length`;
 * NaN where x_u x x_v vanishes but for rounding. */
static double mean_of(const taut_integrals *in, int of, int length)
{
    /* as for single normals: an area of 2^-40 of what the net allows is rounding */
    const int has_normal = in->value[0] > 0x1p-40 * in->value[1];
    return has_normal ? ldexp(in->value[of] / in->value[0], length * in->scale) : nan("");
}

/* NaN where rules do not agree to four digits of the root. */
static double mean_square_of(const taut_integrals *in, int of)
{
    const int is_found =
        in->error[of] <= 1e-4 * in->value[of] || in->error[of] <= 1e-18 * in->value[of + 1];
    return is_found ? mean_of(in, of, -2) : nan("");
}

static double finite_or_none(double x)
{
    return isfinite(x) ? x : nan("");
}

static int is_polynomial(const taut_surface *surface)
{
    return taut_basis_degree(taut_surface_u(surface)) >= 0 &&
           taut_basis_degree(taut_surface_v(surface)) >= 0 && taut_surface_weights(surface) == NULL;
}

taut_status taut_surface_area(const taut_surface *surface, double *area, double *error_estimate)
{
    const taut_integrand integrand = {area_fields, 1, 1, 0, area_goals, 1, 0};
    taut_integrals in;

    if (surface == NULL || area == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    const taut_status status = taut_integrate(surface, &integrand, NULL, &in);
    if (status != TAUT_OK) {
        return status;
    }
    *area = finite_or_none(area_of(&in, in.value));
    if (error_estimate != NULL) {
        add_rounding(&integrand, &in);
        *error_estimate = finite_or_none(told_error(area_of(&in, in.error), *area));
    }
    return TAUT_OK;
}

/* One number out of the integrals of some fields. */
static taut_status integrate_to(const taut_surface *surface, const taut_integrand *integrand,
                                const taut_crew *crew,
                                double (*to_figure)(const taut_integrals *, const double *),
                                double *figure)
{
    taut_integrals in;
    const taut_status status = taut_integrate(surface, integrand, crew, &in);
    if (status != TAUT_OK) {
        return status;
    }
    *figure = finite_or_none(to_figure(&in, in.value));
    return TAUT_OK;
}

taut_status taut_surface_dirichlet_of(const taut_surface *surface, const taut_crew *crew,
                                      double *energy)
{
    const taut_integrand integrand = {stretch_fields, 2, 1, is_polynomial(surface),
                                      square_goals,   0, 0};
    return integrate_to(surface, &integrand, crew, dirichlet_of, energy);
}

taut_status taut_surface_dirichlet_energy(const taut_surface *surface, double *energy)
{
    if (surface == NULL || energy == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    return taut_surface_dirichlet_of(surface, NULL, energy);
}

taut_status taut_surface_bending_energy(const taut_surface *surface, double *energy)
{
    if (surface == NULL || energy == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    const taut_integrand integrand = {bending_fields, 3, 2, is_polynomial(surface),
                                      square_goals,   0, 0};
    return integrate_to(surface, &integrand, NULL, bending_of, energy);
}

taut_status taut_surface_bending_of(const taut_surface *surface, const taut_crew *crew,
                                    double *energy, double *error)
{
    const taut_integrand integrand = {bending_fields, 3, 2, is_polynomial(surface),
                                      square_goals,   0, 0};
    taut_integrals in;
    const taut_status status = taut_integrate(surface, &integrand, crew, &in);

    if (status != TAUT_OK) {
        return status;
    }
    add_square_rounding(&integrand, 0, &in);
    *energy = finite_or_none(bending_of(&in, in.value));
    *error = finite_or_none(told_error(bending_of(&in, in.error), *energy));
    return TAUT_OK;
}

taut_status taut_surface_isothermality_of(const taut_surface *surface, const taut_crew *crew,
                                          double *isothermality)
{
    const taut_integrand integrand = {isothermality_fields, 3, 1, 0, square_goals, 0, 0};
    return integrate_to(surface, &integrand, crew, isothermality_of, isothermality);
}

taut_status taut_surface_isothermality(const taut_surface *surface, double *isothermality)
{
    if (surface == NULL || isothermality == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    return taut_surface_isothermality_of(surface, NULL, isothermality);
}

static void take_area(const taut_integrals *in, taut_surface_integrals *made)
{
    const double area = area_of(in, in->value);
    made->area = finite_or_none(area);
    made->area_error = finite_or_none(told_error(area_of(in, in->error), area));
}

/* From the pairs (r E - G/r)^2 + 4 F^2, E, G at value + at, error + at. */
static void take_stretch(const taut_integrals *in, int at, taut_surface_integrals *made)
{
    const double energy = dirichlet_of(in, in->value + at + 2);
    const double isothermality = isothermality_of(in, in->value + at);

    made->dirichlet = finite_or_none(energy);
    made->dirichlet_error =
        finite_or_none(told_error(dirichlet_of(in, in->error + at + 2), energy));
    made->isothermality = finite_or_none(isothermality);
    made->isothermality_error =
        finite_or_none(told_error(isothermality_error_of(in, at), isothermality));
}

/* Pairs: W; (r E - G/r)^2 + 4 F^2, E, G. Then x_u x x_v. */
static void first_fields(int count, int stride, const double *x, const taut_bounds *bounds,
                         double ratio, double *out)
{
    normal_fields(count, stride, x, bounds, out, out + stride, out + 8 * stride);
    isothermality_fields(count, stride, x, bounds, ratio, out + 2 * stride);
}

static taut_status integrate_first(const taut_surface *surface, const taut_crew *crew,
                                   taut_surface_integrals *made)
{
    const taut_integrand first = {first_fields, 4, 1, 0, all_goals, 1, 1};
    taut_integrals in;
    const taut_status status = taut_integrate(surface, &first, crew, &in);

    if (status != TAUT_OK) {
        return status;
    }
    add_rounding(&first, &in);
    take_area(&in, made);
    take_stretch(&in, 2, made);
    return TAUT_OK;
}

static taut_status integrate_all(const taut_surface *surface, const taut_crew *crew,
                                 taut_surface_integrals *made)
{
    const taut_integrand all = {all_fields, 9, 2, 0, all_goals, 2, 0};
    taut_integrals in;
    const taut_status status = taut_integrate(surface, &all, crew, &in);

    if (status != TAUT_OK) {
        return status;
    }
    add_rounding(&all, &in);
    take_area(&in, made);
    take_stretch(&in, 2, made);
    const double bending = bending_of(&in, in.value + 8);
    made->bending = finite_or_none(bending);
    made->bending_error = finite_or_none(told_error(bending_of(&in, in.error + 8), bending));
    made->mean_abs = finite_or_none(mean_of(&in, 16, -1));
    made->mean_square = finite_or_none(mean_square_of(&in, 14));
    return TAUT_OK;
}

taut_status taut_surface_integrals_of(const taut_surface *surface, int order, const taut_crew *crew,
                                      taut_surface_integrals *integrals)
{
    taut_surface_integrals made = {.bending = 0};
    const taut_status status =
        order > 1 ? integrate_all(surface, crew, &made) : integrate_first(surface, crew, &made);
    if (status == TAUT_OK) {
        *integrals = made;
    }
    return status;
}

taut_status taut_surface_mean(const taut_surface *surface, const taut_crew *crew,
                              taut_surface_integrals *integrals)
{
    const taut_integrand integrand = {bent_fields, 3, 2, 0, mean_goals, 2, 0};
    taut_integrals in;
    const taut_status status = taut_integrate(surface, &integrand, crew, &in);

    if (status != TAUT_OK) {
        return status;
    }
    add_rounding(&integrand, &in);
    *integrals = (taut_surface_integrals){
        .mean_abs = finite_or_none(mean_of(&in, 4, -1)),
        .mean_square = finite_or_none(mean_square_of(&in, 2)),
    };
    take_area(&in, integrals);
    return TAUT_OK;
}
