#include "certify/film/circulation.h"

#include "certify/common/bernstein.h"
#include "numeric/quadrature.h"
#include "taut/limits.h"

#include <math.h>
#include <string.h>

enum { NODES = 12 };
static const double rounding = 0x1p-48; /* of a place, of a value: what sums of some terms leave */
static const double enough = 0x1p-46;   /* of what is added up: no smaller error is asked for */

static double power_of(double x, int n)
{
    double product = 1;
    for (int k = 0; k < n; k++) {
        product *= x;
    }
    return product;
}

static double cross2(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

static double norm2(const double a[2])
{
    return sqrt(a[0] * a[0] + a[1] * a[1]);
}

/* r = q0 + s e + t f + s t g. */
typedef struct bilinear {
    double q[2], e[2], f[2], g[2], size;
} bilinear;

static bilinear bilinear_of(const taut_film_flow *flow)
{
    bilinear r = {.size = 0};

    for (int c = 0; c < 2; c++) {
        r.q[c] = flow->corners[0][c];
        r.e[c] = flow->corners[1][c] - r.q[c];
        r.f[c] = flow->corners[3][c] - r.q[c];
        r.g[c] = flow->corners[2][c] - flow->corners[1][c] - r.f[c];
        for (int k = 0; k < 4; k++) {
            r.size = fmax(r.size, fabs(flow->corners[k][c]));
        }
    }
    return r;
}

/* The map at (s, t): r_s, r_t, their cross product and no less than the norm of the inverse. */
typedef struct tangent {
    double s[2], t[2], j, alpha;
} tangent;

static tangent tangent_at(const bilinear *r, const double st[2])
{
    tangent d;

    for (int c = 0; c < 2; c++) {
        d.s[c] = r->e[c] + st[1] * r->g[c];
        d.t[c] = r->f[c] + st[0] * r->g[c];
    }
    d.j = cross2(d.s, d.t);
    d.alpha = (norm2(d.s) + norm2(d.t)) / fabs(d.j);
    return d;
}

/* The closed form, (p - t f) x (e + t g) = 0, and a step of Newton's. */
static void guess(const bilinear *r, const double at[2], double st[2])
{
    const double p[2] = {at[0] - r->q[0], at[1] - r->q[1]};
    const double a = -cross2(r->f, r->g), b = cross2(p, r->g) + cross2(r->e, r->f);
    const double c = cross2(p, r->e);
    const double t = -2 * c / (b + sqrt(fmax(0, b * b - 4 * a * c)));
    const double along[2] = {r->e[0] + t * r->g[0], r->e[1] + t * r->g[1]};

    st[0] = ((p[0] - t * r->f[0]) * along[0] + (p[1] - t * r->f[1]) * along[1]) /
            (along[0] * along[0] + along[1] * along[1]);
    st[1] = t;
}

static void miss_of(const bilinear *r, const double at[2], const double st[2], double miss[2])
{
    for (int c = 0; c < 2; c++) {
        miss[c] = at[c] - (r->q[c] + st[0] * r->e[c] + st[1] * (r->f[c] + st[0] * r->g[c]));
    }
}

/* How far the true parameters are from these. */
static double doubt_of(const bilinear *r, const double at[2], const double st[2], const tangent *d)
{
    double miss[2];

    miss_of(r, at, st, miss);
    const double away = norm2(miss) + rounding * (r->size + norm2(at));
    const int is_inside = st[0] >= 0 && st[0] <= 1 && st[1] >= 0 && st[1] <= 1;
    const int is_sure = 4 * d->alpha * d->alpha * norm2(r->g) * away <= 1;
    return is_inside && is_sure ? 2 * d->alpha * away : (double)INFINITY;
}

static tangent settle(const bilinear *r, const double at[2], double st[2])
{
    double miss[2];

    guess(r, at, st);
    const tangent d = tangent_at(r, st);
    miss_of(r, at, st, miss);
    st[0] += cross2(miss, d.t) / d.j;
    st[1] += cross2(d.s, miss) / d.j;
    return tangent_at(r, st);
}

double taut_film_locate(const taut_film_flow *flow, const double at[2], double st[2])
{
    const bilinear r = bilinear_of(flow);
    const tangent d = settle(&r, at, st);

    return doubt_of(&r, at, st, &d);
}

double taut_film_flow_value(const taut_field *f, const double st[2], double off, double *value)
{
    const double most = taut_field_largest(f);

    *value = taut_field_value(f, st[0], st[1]);
    /* derivatives are at most twice the degree times the largest coefficient; a little beyond the square */
    return most * (rounding + 2 * (f->p + f->q) * off * power_of(1 + 2 * off, f->p + f->q));
}

/* ---- one piece ---- */

/* x(tau) = middle + sum_j a_j tau^j: |a_j| of x, y and of z. */
typedef struct piece {
    int degree;
    const double *points; /* [degree + 1][3] */
    double middle[3], bend[TAUT_DEGREE_MAX + 1], rise[TAUT_DEGREE_MAX + 1];
} piece;

static void value_at(int degree, const double *points, double x, double out[3])
{
    double row[3 * (TAUT_DEGREE_MAX + 1)];

    memcpy(row, points, 3 * ((size_t)degree + 1) * sizeof *row);
    for (int r = degree; r > 0; r--) {
        for (int k = 0; k < 3 * r; k++) {
            row[k] = (1 - x) * row[k] + x * row[k + 3];
        }
    }
    memcpy(out, row, 3 * sizeof *out);
}

static piece piece_of(int degree, const double *points)
{
    piece p = {.degree = degree, .points = points};
    double steps[3 * (TAUT_DEGREE_MAX + 1)], factor = 1;

    memcpy(steps, points, 3 * ((size_t)degree + 1) * sizeof *steps);
    value_at(degree, points, 0.5, p.middle);
    for (int j = 1; j <= degree; j++) {
        double a[3];
        factor *= 0.5 * (degree - j + 1) / j;
        for (int k = 0; k < 3 * (degree - j + 1); k++) {
            steps[k] = steps[k + 3] - steps[k];
        }
        value_at(degree - j, steps, 0.5, a);
        p.bend[j] = factor * norm2(a);
        p.rise[j] = factor * fabs(a[2]);
    }
    return p;
}

/* sum_j |a_j| r^j, and sum_j j |a_j| r^(j-1) in *slope. */
static double sum_of(int degree, const double *a, double r, double *slope)
{
    double sum = 0, grown = 1;

    *slope = 0;
    for (int j = 1; j <= degree; j++) {
        *slope += j * a[j] * grown;
        grown *= r;
        sum += a[j] * grown;
    }
    return sum;
}

/* The largest of |B t' - psi z'| on the ellipse, infinity where it is not known. */
static double most_on(const taut_film_flow *flow, const bilinear *r, const tangent *d, double doubt,
                      const piece *p, double rho)
{
    const double width = 0.5 * (rho + 1 / rho), g = norm2(r->g);
    double along = 0, rise = 0;
    const double away = sum_of(p->degree, p->bend, width, &along);
    const double distance = away + rounding * (r->size + norm2(p->middle));
    const double radius = 2 * d->alpha * distance + doubt;

    if (!(4 * d->alpha * d->alpha * g * distance <= 0.5) || !(d->alpha * g * radius <= 0.5)) {
        return INFINITY;
    }
    const double slope = (norm2(d->s) + g * radius) * along / (0.5 * fabs(d->j));
    const double b =
        taut_field_largest(flow->b) * power_of(1 + 2 * radius, flow->b->p + flow->b->q);
    const double psi =
        taut_field_largest(flow->psi) * power_of(1 + 2 * radius, flow->psi->p + flow->psi->q);
    (void)sum_of(p->degree, p->rise, width, &rise);
    return b * slope + psi * rise;
}

/* The least that a Gauss rule may be told to miss. */
static double miss_of_rule(const taut_film_flow *flow, const bilinear *r, const tangent *d,
                           double doubt, const piece *p)
{
    static const double rhos[] = {1.5, 2, 3, 4, 6, 9, 14, 20};
    double least = INFINITY;

    for (size_t k = 0; k < sizeof rhos / sizeof *rhos; k++) {
        const double down = 1 / (rhos[k] * rhos[k]);
        const double most = most_on(flow, r, d, doubt, p, rhos[k]);
        least = fmin(least, 64 * most * power_of(down, NODES - 1) / (15 * (1 - down)));
    }
    return least;
}

static void add_node(const taut_film_flow *flow, const bilinear *r, const piece *p, double node,
                     double weight, taut_film_total *total)
{
    double x[3], ahead[3], st[2], b = 0, psi = 0;
    double steps[3 * TAUT_DEGREE_MAX];

    value_at(p->degree, p->points, 0.5 * (1 + node), x);
    for (int k = 0; k < 3 * p->degree; k++) {
        steps[k] = 0.5 * p->degree * (p->points[k + 3] - p->points[k]);
    }
    value_at(p->degree - 1, steps, 0.5 * (1 + node), ahead);
    const tangent d = settle(r, x, st);
    const double doubt = doubt_of(r, x, st, &d), g = norm2(r->g);
    const double off_b = taut_film_flow_value(flow->b, st, doubt, &b),
                 off_psi = taut_film_flow_value(flow->psi, st, doubt, &psi);
    const double dt = cross2(d.s, ahead) / d.j;
    double along = 0, rise = 0;
    (void)sum_of(p->degree, p->bend, 1, &along);
    (void)sum_of(p->degree, p->rise, 1, &rise);
    const double most = norm2(d.s) * (along + rounding * r->size) / fabs(d.j);
    const double off_dt =
        most * (8 * rounding + 4 * d.alpha * g * doubt) + g * doubt * along / fabs(d.j);

    total->sum += weight * (b * dt - psi * ahead[2]);
    total->off += fabs(weight) * (off_b * (fabs(dt) + off_dt) + fabs(b) * off_dt + off_psi * rise +
                                  rounding * (fabs(b * dt) + fabs(psi) * rise));
}

taut_status taut_film_circulate(const taut_film_flow *flow, int degree, const double *points,
                                double sign, int *pieces, taut_film_total *total)
{
    const bilinear r = bilinear_of(flow);
    const piece p = piece_of(degree, points);
    double st[2], nodes[NODES], weights[NODES];
    const tangent d = settle(&r, p.middle, st);
    const double doubt = doubt_of(&r, p.middle, st, &d);
    const double miss = miss_of_rule(flow, &r, &d, doubt, &p);
    const double worth = most_on(flow, &r, &d, doubt, &p, 1);

    if (--*pieces < 0) {
        total->off = INFINITY;
        return TAUT_OK;
    }
    if (!isfinite(miss) || !(miss <= enough * worth)) {
        double low[3 * (TAUT_DEGREE_MAX + 1)], high[3 * (TAUT_DEGREE_MAX + 1)];
        taut_certify_halve(degree, 3, points, low, high);
        const taut_status status = taut_film_circulate(flow, degree, low, sign, pieces, total);
        return status == TAUT_OK && isfinite(total->off)
                   ? taut_film_circulate(flow, degree, high, sign, pieces, total)
                   : status;
    }
    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < NODES; k++) {
        add_node(flow, &r, &p, nodes[k], sign * weights[k], total);
    }
    total->off += miss;
    return TAUT_OK;
}
