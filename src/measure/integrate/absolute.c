/* absolute.c -- iint |p| line by line.
 *
 * In Legendre polynomials p(u,v) = sum_ik c_ik P_i(u) P_k(v), with c from the Gauss rules
 * themselves ([DLMF] 3.5(v), 18.2). On a line of constant u the roots in v are found and p is
 * integrated between them in closed form,
 *     int P_k = (P_{k+1} - P_{k-1}) / (2k+1),
 * with alternating signs. What is left is a function of u: smooth but where a root enters or leaves
 * through v = -1 or 1 (its second derivative jumps: the roots of p(u,-1) and p(u,1), found first)
 * or where two roots meet (a power 3/2). Adaptive Gauss rules between those u do the rest.
 */
#include "measure/integrate/absolute.h"

#include "numeric/quadrature.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    N = TAUT_FIT_MAX,
    SAMPLES = 2 * N + 1,
    ROOTS = SAMPLES + 1,
    CUTS = 4 * ROOTS,
    FEW = 3, /* nodes of the two rules in u: these where little is asked for, */
    LOW = 5, /* else these */
    HIGH = 8,
    DEPTH = 30,
    STRETCHES = 200
};

/* Above this part of the integral FEW and LOW nodes agree at once. */
static const double coarse = 1e-6;

/* Where polynomials of n coefficients are sampled: closed, evenly, twice as densely as the degree.
 */
typedef struct samples {
    int n, count;
    double x[SAMPLES], p[N][SAMPLES]; /* P_k(x) */
} samples;

/* P_{k+1} = step[k] x P_k - back[k] P_{k-1};  over[k] = 1 / (2k+1). */
typedef struct recurrence {
    double step[N + 2], back[N + 2], over[N + 2];
} recurrence;

typedef struct rule {
    int count;
    double nodes[HIGH], weights[HIGH];
} rule;

typedef struct series {
    const taut_fit *fit;
    samples u, v;
    recurrence legendre;
    rule rules[2];
} series;

/* P_0(x) .. P_{n-1}(x). */
static void eval_legendre(int n, double x, double *p)
{
    p[0] = 1;
    p[n > 1] = n > 1 ? x : 1;
    for (int k = 1; k + 1 < n; k++) {
        p[k + 1] = ((2 * k + 1) * x * p[k] - k * p[k - 1]) / (k + 1);
    }
}

static double sum_of(int n, const double *c, const double *p)
{
    double sum = 0;
    for (int k = 0; k < n; k++) {
        sum += c[k] * p[k];
    }
    return sum;
}

static void recurrence_init(recurrence *r)
{
    for (int k = 0; k < N + 2; k++) {
        r->step[k] = (2.0 * k + 1) / (k + 1);
        r->back[k] = (double)k / (k + 1);
        r->over[k] = 1 / (2.0 * k + 1);
    }
}

/* sum_k c[k] P_k(x) and its derivative, from the last term on (Clenshaw, [DLMF] 3.11(ii)). */
static double value_at(const recurrence *r, int n, const double *c, double x, double *slope)
{
    double b1 = 0, b2 = 0, d1 = 0, d2 = 0;
    for (int k = n - 1; k >= 0; k--) {
        const double step = r->step[k] * x;
        const double b = (c[k] - r->back[k + 1] * b2) + step * b1;
        const double d = (r->step[k] * b1 - r->back[k + 1] * d2) + step * d1;
        b2 = b1;
        b1 = b;
        d2 = d1;
        d1 = d;
    }
    *slope = d1;
    return b1;
}

static void samples_init(samples *s, int n)
{
    s->n = n;
    s->count = 2 * n + 1;
    for (int i = 0; i < s->count; i++) {
        double p[N];
        s->x[i] = i == 2 * n ? 1 : -1 + 1.0 / n * i;
        eval_legendre(n, s->x[i], p);
        for (int k = 0; k < n; k++) {
            s->p[k][i] = p[k];
        }
    }
}

/* f[i] = sum_k c[k] P_k(x_i): all samples at once, since one sum would wait for itself. */
static void eval_samples(const samples *s, const double *restrict c, double *restrict f)
{
    memset(f, 0, (size_t)s->count * sizeof(double));
    for (int k = 0; k < s->n; k++) {
        const double *restrict p = s->p[k];
        const double factor = c[k];
        for (int i = 0; i < s->count; i++) {
            f[i] += factor * p[i];
        }
    }
}

/* The root between a and b, where p has the signs of fa and fb: Newton's steps, halving where they
 * leave the interval. An error d of a root changes the integral by p' d^2 only, and the last step's
 * square is about the error: 2^-20 of it is plenty. */
static double find_root(const series *s, int n, const double *c, double a, double fa, double b,
                        double fb)
{
    double x = (a * fb - b * fa) / (fb - fa);
    for (int i = 0; i < 40; i++) {
        double slope = 0;
        const double fx = value_at(&s->legendre, n, c, x, &slope), next = x - fx / slope;
        if ((fx > 0) == (fb > 0)) {
            b = x;
        } else {
            a = x;
        }
        if (fx == 0 || fabs(next - x) < 0x1p-20 || fabs(b - a) < 0x1p-30) {
            return next >= a && next <= b ? next : x;
        }
        x = next > a && next < b ? next : 0.5 * (a + b);
    }
    return x;
}

/* All roots in order; at most ROOTS. Between samples of one sign p may still dip to the other about
 * a least value: the vertex of the parabola through it and its neighbours is looked at too. */
static int roots_of(const series *all, const samples *s, const double *c, double *roots)
{
    const double step = 1.0 / s->n;
    double f[SAMPLES];
    int made = 0;

    eval_samples(s, c, f);
    for (int i = 0; i + 1 < s->count && made + 2 <= ROOTS; i++) {
        if ((f[i] > 0) != (f[i + 1] > 0)) {
            roots[made++] = find_root(all, s->n, c, s->x[i], f[i], s->x[i + 1], f[i + 1]);
        } else if (i > 0 && fabs(f[i]) <= fabs(f[i - 1]) && fabs(f[i]) <= fabs(f[i + 1]) &&
                   (f[i - 1] > 0) == (f[i] > 0) && f[i - 1] != f[i + 1]) {
            const double second = f[i - 1] - 2 * f[i] + f[i + 1];
            const double least = s->x[i] + step * (f[i - 1] - f[i + 1]) / (2 * second);
            double slope = 0;
            const double at = value_at(&all->legendre, s->n, c, least, &slope);
            if ((at > 0) != (f[i] > 0)) {
                roots[made++] = find_root(all, s->n, c, s->x[i - 1], f[i - 1], least, at);
                roots[made++] = find_root(all, s->n, c, least, at, s->x[i + 1], f[i + 1]);
            }
        }
    }
    return made;
}

/* out[0..n]: the coefficients of
 *     int_-1^x p = c_0 (P_0 + P_1) + sum_{k>0} c_k (P_{k+1} - P_{k-1}) / (2k+1). */
static void integrate_series(const recurrence *r, int n, const double *c, double *out)
{
    out[0] = c[0] - (n > 1 ? c[1] * r->over[1] : 0);
    for (int k = 1; k <= n; k++) {
        out[k] = c[k - 1] * r->over[k - 1] - (k + 1 < n ? c[k + 1] * r->over[k + 1] : 0);
    }
}

/* int |p(u, v)| dv. */
static double integrate_line(const series *s, double u)
{
    const int nu = s->u.n, nv = s->v.n;
    double p[N], c[N] = {0}, whole[N + 1], roots[ROOTS + 2];
    double sum = 0, before = 0, others = 0, slope = 0;
    int count = 0;

    eval_legendre(nu, u, p);
    for (int i = 0; i < nu; i++) {
        const double *restrict row = s->fit->c[i];
        const double factor = p[i];
        for (int k = 0; k < nv; k++) {
            c[k] += factor * row[k];
        }
    }
    for (int k = 1; k < nv; k++) {
        others += fabs(c[k]);
    }
    if (fabs(c[0]) > others) {
        return 2 * fabs(c[0]); /* |P_k| <= 1: no root */
    }
    count = roots_of(s, &s->v, c, roots);
    integrate_series(&s->legendre, nv, c, whole);
    for (int r = 0; r <= count; r++) {
        const double next =
            r < count ? value_at(&s->legendre, nv + 1, whole, roots[r], &slope) : 2 * c[0];
        sum += fabs(next - before);
        before = next;
    }
    return sum;
}

static double integrate_stretch(const series *s, double lo, double hi, const rule *r)
{
    double sum = 0;
    for (int i = 0; i < r->count; i++) {
        sum += r->weights[i] * integrate_line(s, (lo + hi) / 2 + (hi - lo) / 2 * r->nodes[i]);
    }
    return sum * (hi - lo) / 2;
}

/* Halves until two rules agree to `relative` of the stretch or within `floor`. Rounding may keep
 * them apart: the number of stretches is bounded. */
static double integrate_between(const series *s, double from, double to, double relative,
                                double floor)
{
    double lo[DEPTH + 1] = {from}, hi[DEPTH + 1] = {to}, sum = 0;
    int depth = 0, done = 0;

    while (depth >= 0) {
        const double a = lo[depth], b = hi[depth], middle = (a + b) / 2;
        const double low = integrate_stretch(s, a, b, &s->rules[0]),
                     high = integrate_stretch(s, a, b, &s->rules[1]);
        if (fabs(high - low) <= fmax(relative * high, floor) || depth == DEPTH ||
            ++done > STRETCHES || !isfinite(high)) {
            sum += high;
            depth--;
        } else {
            lo[depth] = middle;
            lo[depth + 1] = a;
            hi[depth + 1] = middle;
            depth++;
        }
    }
    return sum;
}

static int compare_numbers(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Where the integral over a line is not smooth in u: roots of p along v = -1 and v = 1, and rows
 * between which the sign changes along a sampled line of constant v, as is about small islands. */
static int cuts_of(const series *s, double *cuts)
{
    double c[N];
    int made = 1;

    cuts[0] = -1;
    for (int side = 0; side < 3; side++) {
        for (int i = 0; i < s->u.n; i++) {
            c[i] = 0;
            for (int k = 0; k < s->v.n; k++) {
                c[i] += s->fit->c[i][k] * s->v.p[k][side * s->v.n];
            }
        }
        made += roots_of(s, &s->u, c, cuts + made);
    }
    cuts[made++] = 1;
    qsort(cuts, (size_t)made, sizeof(double), compare_numbers);
    return made;
}

void taut_fit_table(int count, const double *nodes, const double *weights, double *table)
{
    double p[N];
    assert(count >= 1 && count <= N);
    for (int j = 0; j < count; j++) {
        eval_legendre(count, nodes[j], p);
        for (int k = 0; k < count; k++) {
            table[k * count + j] = (k + 0.5) * weights[j] * p[k];
        }
    }
}

/* half[i][k] = sum_j table_v[k][j] f[i][j], then c[i][k] = sum_j table_u[i][j] half[j][k]. */
void taut_fit_init(int nu, const double *table_u, int nv, const double *table_v, const double *f,
                   taut_fit *fit)
{
    double half[N * N];

    assert(nu >= 1 && nu <= N && nv >= 1 && nv <= N);
    fit->nu = nu;
    fit->nv = nv;
    for (int i = 0; i < nu; i++) {
        for (int k = 0; k < nv; k++) {
            half[i * nv + k] = sum_of(nv, table_v + k * nv, f + i * nv);
        }
    }
    for (int i = 0; i < nu; i++) {
        memset(fit->c[i], 0, (size_t)nv * sizeof(double));
        for (int j = 0; j < nu; j++) {
            const double t = table_u[i * nu + j];
            for (int k = 0; k < nv; k++) {
                fit->c[i][k] += t * half[j * nv + k];
            }
        }
    }
}

/* iint |d| <= 2 sqrt(iint d^2), and iint d^2 = sum_ik 4 d_ik^2 / ((2i+1) (2k+1)). */
double taut_fit_distance(const taut_fit *a, const taut_fit *b)
{
    const int nu = a->nu > b->nu ? a->nu : b->nu, nv = a->nv > b->nv ? a->nv : b->nv;
    double sum = 0;
    for (int i = 0; i < nu; i++) {
        for (int k = 0; k < nv; k++) {
            const double d = (i < a->nu && k < a->nv ? a->c[i][k] : 0) -
                             (i < b->nu && k < b->nv ? b->c[i][k] : 0);
            sum += 4 * d * d / ((2 * i + 1) * (2 * k + 1));
        }
    }
    return 2 * sqrt(sum);
}

/* The sum of |c_ik| over row i (direction 0) or column i within the first n[0] by n[1]. */
static double sum_slice(const taut_fit *fit, const int n[2], int direction, int i)
{
    double sum = 0;
    for (int k = 0; k < n[1 - direction]; k++) {
        sum += fabs(direction == 0 ? fit->c[i][k] : fit->c[k][i]);
    }
    return sum;
}

/* How many rows and columns are wanted: |P_k| <= 1, so what is left out changes iint |p| by at most
 * 4 sum |c_ik| over it, and iint |p| >= iint p^2 / max |p|. */
static void truncate_fit(const taut_fit *fit, double relative, int n[2])
{
    double square = 0, all = 0, budget = 0;

    n[0] = fit->nu;
    n[1] = fit->nv;
    for (int i = 0; i < n[0]; i++) {
        for (int k = 0; k < n[1]; k++) {
            square += 4 * fit->c[i][k] * fit->c[i][k] / ((2 * i + 1) * (2 * k + 1));
            all += fabs(fit->c[i][k]);
        }
    }
    budget = all > 0 ? 0.125 * relative * (square / all) / 4 : 0;
    for (int d = 0; d < 2; d++) {
        while (n[d] > 1 && sum_slice(fit, n, d, n[d] - 1) <= budget) {
            budget -= sum_slice(fit, n, d, n[d] - 1);
            n[d]--;
        }
    }
}

double taut_fit_absolute(const taut_fit *fit, double relative)
{
    int n[2];
    double cuts[CUTS], sum = 0, others = -fabs(fit->c[0][0]);
    series s;
    int count = 0;

    for (int i = 0; i < fit->nu; i++) {
        for (int k = 0; k < fit->nv; k++) {
            others += fabs(fit->c[i][k]);
        }
    }
    if (fabs(fit->c[0][0]) >= others) {
        return 4 * fabs(fit->c[0][0]); /* no change of sign */
    }
    s.fit = fit;
    recurrence_init(&s.legendre);
    truncate_fit(fit, relative, n);
    samples_init(&s.u, n[0]);
    samples_init(&s.v, n[1]);
    for (int r = 0; r < 2; r++) {
        s.rules[r].count = relative < coarse ? (r == 0 ? LOW : HIGH) : (r == 0 ? FEW : LOW);
        taut_gauss_rule(s.rules[r].count, s.rules[r].nodes, s.rules[r].weights);
    }
    count = cuts_of(&s, cuts);
    for (int i = 0; i + 1 < count; i++) {
        if (cuts[i + 1] > cuts[i]) {
            const double floor = relative / 8 * (fabs(fit->c[0][0]) + others);
            sum += integrate_between(&s, cuts[i], cuts[i + 1], relative, floor);
        }
    }
    return sum;
}
