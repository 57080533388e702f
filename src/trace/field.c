#include "trace/field.h"

#include "core/vec3.h"

/* R below this much of its largest value on the surface is a flat or an umbilic point; |x_u x x_v|
 * below that much of its largest is none. */
static const double least_radius = 1e-8, least_area = 1e-10;
/* |H| over the largest R, above which a point where R vanishes is no flat one: K > 0 there. */
static const double flat_mean = 1e-6;

static void make_unit(const taut_form_pair *q, double ab[2])
{
    const double square = q->e * ab[0] * ab[0] + 2 * q->f * ab[0] * ab[1] + q->g * ab[1] * ab[1];
    const double length = sqrt(square);
    ab[0] /= length;
    ab[1] /= length;
}

void taut_linefield_asymptotic(const taut_form_pair *q, int family, double d, double ab[2])
{
    const double root = family == 0 ? -d : d; /* sigma D */
    /* Neither cancels; where M is small beside L or N, the larger of these keeps its digits where D and
     * M vanish together. */
    const int by_size = fabs(q->m) < 0.5 * fmax(fabs(q->l), fabs(q->n));
    if (by_size ? fabs(q->l) > fabs(q->n) : root * q->m <= 0) {
        ab[0] = root - q->m;
        ab[1] = q->l;
    } else {
        ab[0] = q->n;
        ab[1] = -q->m - root;
    }
    make_unit(q, ab);
}

static taut_linefield_fault principal(const taut_carrier *carrier, int family,
                                      const taut_form_pair *q, double ab[2])
{
    const double p = q->l / q->e, s = (q->m * q->e - q->l * q->f) / (q->e * q->w);
    const double r =
        (q->n * q->e * q->e - 2 * q->m * q->e * q->f + q->l * q->f * q->f) / (q->e * q->w * q->w);
    const double radius = sqrt((p - r) * (p - r) / 4 + s * s), root = sqrt(q->e);

    if (!(radius > least_radius * carrier->roundest)) {
        return TAUT_LINEFIELD_ROUND;
    }
    const double phi = taut_atan2(2 * s, p - r) / 2;
    double sine = taut_sin(phi), cosine = taut_cos(phi);
    if (family == 1) {
        const double turned = -sine;
        sine = cosine;
        cosine = turned;
    }
    ab[0] = cosine / root - q->f * sine / (q->w * root);
    ab[1] = root * sine / q->w;
    return TAUT_LINEFIELD_FINE;
}

int taut_linefield_has_normal(const taut_carrier *carrier, const taut_form_pair *q)
{
    return q->w > least_area * carrier->widest;
}

taut_linefield_fault taut_linefield_direction(const taut_carrier *carrier, taut_linefield_kind kind,
                                              const taut_form_pair *q, double ab[2])
{
    if (!taut_linefield_has_normal(carrier, q)) {
        return TAUT_LINEFIELD_SINGULAR;
    }
    if (kind.net == TAUT_TRACE_PRINCIPAL) {
        return principal(carrier, kind.family, q, ab);
    }
    if (kind.net == TAUT_TRACE_ASYMPTOTIC) {
        const double square = q->m * q->m - q->l * q->n;
        if (!(taut_form_pair_radius(q) > least_radius * carrier->roundest)) {
            return fabs(taut_form_pair_mean(q)) <= flat_mean * carrier->roundest
                       ? TAUT_LINEFIELD_ROUND
                       : TAUT_LINEFIELD_ELLIPTIC;
        }
        if (!(square > 0)) {
            return TAUT_LINEFIELD_ELLIPTIC;
        }
        taut_linefield_asymptotic(q, kind.family, sqrt(square), ab);
        return TAUT_LINEFIELD_FINE;
    }
    ab[0] = kind.family == 0 ? 0 : 1;
    ab[1] = kind.family == 0 ? 1 : 0;
    make_unit(q, ab);
    return TAUT_LINEFIELD_FINE;
}

void taut_linefield_tangent(const double x[TAUT_CARRIER_VECTORS][3], const double ab[2],
                            double tangent[3])
{
    for (int c = 0; c < 3; c++) {
        tangent[c] = ab[0] * x[1][c] + ab[1] * x[2][c];
    }
}

double taut_linefield_normal_curvature(const taut_form_pair *q, const double ab[2])
{
    return q->l * ab[0] * ab[0] + 2 * q->m * ab[0] * ab[1] + q->n * ab[1] * ab[1];
}

double taut_linefield_torsion(const taut_form_pair *q, const double ab[2])
{
    const double a = ab[0], b = ab[1];
    return ((q->m * a + q->n * b) * (q->e * a + q->f * b) -
            (q->l * a + q->m * b) * (q->f * a + q->g * b)) /
           q->w;
}

/* The quadratic form whose zeros are the directions: A a^2 + 2 B ab + C b^2 = 0, and its slopes. */
static void form_of_net(taut_trace_net net, const taut_form_pair *q, const double slopes[6][2],
                        double form[3], double form_slopes[3][2])
{
    if (net == TAUT_TRACE_ASYMPTOTIC) {
        form[0] = q->l;
        form[1] = q->m;
        form[2] = q->n;
    } else { /* principal: F and M of the other form mixed */
        form[0] = q->e * q->m - q->f * q->l;
        form[1] = (q->e * q->n - q->g * q->l) / 2;
        form[2] = q->f * q->n - q->g * q->m;
    }
    for (int d = 0; d < 2; d++) {
        const double e = slopes[0][d], f = slopes[1][d], g = slopes[2][d];
        const double l = slopes[3][d], m = slopes[4][d], n = slopes[5][d];
        if (net == TAUT_TRACE_ASYMPTOTIC) {
            form_slopes[0][d] = l;
            form_slopes[1][d] = m;
            form_slopes[2][d] = n;
        } else {
            form_slopes[0][d] = e * q->m + q->e * m - f * q->l - q->f * l;
            form_slopes[1][d] = (e * q->n + q->e * n - g * q->l - q->g * l) / 2;
            form_slopes[2][d] = f * q->n + q->f * n - g * q->m - q->g * m;
        }
    }
}

/* Q = a^2 x_uu + 2ab x_uv + b^2 x_vv. */
static void second(const double x[TAUT_CARRIER_VECTORS][3], const double ab[2], double out[3])
{
    for (int c = 0; c < 3; c++) {
        out[c] = ab[0] * ab[0] * x[3][c] + 2 * ab[0] * ab[1] * x[4][c] + ab[1] * ab[1] * x[5][c];
    }
}

/* Geodesics: x'' has no part in the tangent plane. */
static int geodesic_bend(const double x[TAUT_CARRIER_VECTORS][3], const taut_form_pair *q,
                         const double ab[2], double bend[2])
{
    double out[3];
    second(x, ab, out);
    const double u = taut_dot(out, x[1]), v = taut_dot(out, x[2]), area = q->w * q->w;
    bend[0] = (q->f * v - q->g * u) / area;
    bend[1] = (q->f * u - q->e * v) / area;
    return 1;
}

int taut_linefield_bend(taut_trace_net net, const double x[TAUT_CARRIER_VECTORS][3],
                        const taut_form_pair *q, const double ab[2], double bend[2])
{
    double slopes[6][2], form[3], form_slopes[3][2], right[2] = {0, 0};
    const double a = ab[0], b = ab[1], squares[3] = {a * a, 2 * a * b, b * b};

    if (net == TAUT_TRACE_GEODESIC) {
        return geodesic_bend(x, q, ab, bend);
    }
    taut_carrier_slopes(x, q, slopes);
    for (int k = 0; k < 3; k++) {
        right[1] -= (slopes[k][0] * a + slopes[k][1] * b) * squares[k] / 2;
    }
    if (net == TAUT_TRACE_ISOPARAMETRIC) {
        const int along_u = q->e * a * a > q->g * b * b;
        bend[0] = along_u ? right[1] / (q->e * a) : 0;
        bend[1] = along_u ? 0 : right[1] / (q->g * b);
        return 1;
    }
    form_of_net(net, q, (const double(*)[2])slopes, form, form_slopes);
    for (int k = 0; k < 3; k++) {
        right[0] -= (form_slopes[k][0] * a + form_slopes[k][1] * b) * squares[k] / 2;
    }
    const double top[2] = {form[0] * a + form[1] * b, form[1] * a + form[2] * b};
    const double low[2] = {q->e * a + q->f * b, q->f * a + q->g * b};
    const double det = top[0] * low[1] - top[1] * low[0];
    bend[0] = (right[0] * low[1] - right[1] * top[1]) / det;
    bend[1] = (right[1] * top[0] - right[0] * low[0]) / det;
    return isfinite(bend[0]) && isfinite(bend[1]);
}

void taut_linefield_acceleration(const double x[TAUT_CARRIER_VECTORS][3], const double ab[2],
                                 const double bend[2], double out[3])
{
    second(x, ab, out);
    taut_add_scaled(bend[0], x[1], out);
    taut_add_scaled(bend[1], x[2], out);
}

double taut_linefield_measure(taut_trace_net net, const taut_form_pair *q)
{
    if (net == TAUT_TRACE_ASYMPTOTIC) {
        const double square = q->m * q->m - q->l * q->n;
        return square > 0 ? sqrt(sqrt(square) / q->w) : 0;
    }
    return net == TAUT_TRACE_PRINCIPAL ? sqrt(taut_form_pair_radius(q)) : 1;
}
