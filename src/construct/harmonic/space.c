#include "construct/harmonic/space.h"

#include "numeric/quadrature.h"

#include <assert.h>
#include <math.h>
#include <string.h>

/* A complex number, or a factor of the recurrence. */
typedef struct complex_wide {
    taut_wide re, im;
} complex_wide;

/* The polynomials q_0 .. q_steps, all raised to bidegree (degree, degree). */
typedef struct recurrence {
    taut_wide a, b; /* A and B: z is at most about 1 in size */
    int steps, degree, size;
    complex_wide *net; /* [steps+1][size][size], size = steps + 1: the leading (degree+1)^2 used */
    complex_wide *value; /* [steps+1][samples] */
    complex_wide *z;     /* [samples] */
    taut_wide *weight;   /* [samples] */
    int samples;
    taut_wide last; /* leading coefficient of the last polynomial over that of the one before */
} recurrence;

static complex_wide times(complex_wide x, complex_wide y)
{
    return (complex_wide){x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
}

/* to[i][j], bidegree (k+1, k+1), of the net from[i][j], bidegree (k, k), times c + z (sign 1) or
 * c + conj(z) (sign -1), both with z scaled by `scale`: the mean over the four neighbours of the
 * coefficient times the factor's at that corner. Safe in place. */
static void multiply_net(const recurrence *r, int k, taut_wide constant, taut_wide scale, int sign,
                         const complex_wide *from, complex_wide *to)
{
    for (int i = k + 1; i >= 0; i--) {
        for (int j = k + 1; j >= 0; j--) {
            complex_wide sum = {0, 0};
            for (int corner = 0; corner < 4; corner++) {
                const int di = corner / 2, dj = corner % 2;
                const taut_wide share = (taut_wide)(di ? i : k + 1 - i) * (dj ? j : k + 1 - j) /
                                        ((taut_wide)(k + 1) * (k + 1));
                if (share != 0) {
                    const complex_wide factor = {constant + scale * (di ? r->a : -r->a) / 2,
                                                 scale * sign * (dj ? r->b : -r->b) / 2};
                    const complex_wide product = times(factor, from[(i - di) * r->size + j - dj]);
                    sum.re += share * product.re;
                    sum.im += share * product.im;
                }
            }
            to[i * r->size + j] = sum;
        }
    }
}

static complex_wide *net_of(const recurrence *r, int k)
{
    return r->net + (size_t)k * (size_t)r->size * (size_t)r->size;
}

/* Points of the four edges at Gauss nodes, more than a polynomial of the degree can vanish at. */
static void sample_boundary(recurrence *r, int nodes)
{
    double t[TAUT_GAUSS_MAX], w[TAUT_GAUSS_MAX];
    taut_gauss_rule(nodes, t, w);
    for (int side = 0; side < 4; side++) {
        for (int k = 0; k < nodes; k++) {
            const taut_wide at = (taut_wide)t[k] / 2, end = side % 2 == 0 ? -0.5L : 0.5L;
            const int s = side * nodes + k;
            r->z[s].re = r->a * (side < 2 ? end : at);
            r->z[s].im = r->b * (side < 2 ? at : end);
            r->weight[s] = (taut_wide)w[k] / 8;
        }
    }
}

static complex_wide inner(const recurrence *r, const complex_wide *x, const complex_wide *y)
{
    complex_wide sum = {0, 0};
    for (int s = 0; s < r->samples; s++) {
        sum.re += r->weight[s] * (x[s].re * y[s].re + x[s].im * y[s].im);
        sum.im += r->weight[s] * (x[s].re * y[s].im - x[s].im * y[s].re);
    }
    return sum; /* <x, y> = sum w conj(x) y */
}

/* q -= h q_j on samples and net. */
static void subtract_polynomial(const recurrence *r, complex_wide h, int j, int k)
{
    complex_wide *net = net_of(r, k);
    const complex_wide *other = net_of(r, j);
    for (int s = 0; s < r->samples; s++) {
        const complex_wide product = times(h, r->value[j * r->samples + s]);
        r->value[k * r->samples + s].re -= product.re;
        r->value[k * r->samples + s].im -= product.im;
    }
    for (int i = 0; i <= r->degree; i++) {
        for (int c = 0; c <= r->degree; c++) {
            const complex_wide product = times(h, other[i * r->size + c]);
            net[i * r->size + c].re -= product.re;
            net[i * r->size + c].im -= product.im;
        }
    }
}

/* Divides q_k by its norm, which it returns. */
static taut_wide normalise(const recurrence *r, int k)
{
    complex_wide *value = r->value + k * r->samples, *net = net_of(r, k);
    const taut_wide norm = sqrtl(inner(r, value, value).re);
    for (int s = 0; s < r->samples; s++) {
        value[s].re /= norm;
        value[s].im /= norm;
    }
    for (int i = 0; i < r->size * r->size; i++) {
        net[i].re /= norm;
        net[i].im /= norm;
    }
    return norm;
}

/* q_k = (z q_{k-1} - sum_j h_j q_j) / h, orthogonalised twice. */
static void advance(recurrence *r, int k)
{
    const complex_wide *before = r->value + (k - 1) * r->samples;
    complex_wide *value = r->value + k * r->samples;

    multiply_net(r, k - 1, 0, 1, 1, net_of(r, k - 1), net_of(r, k));
    for (int s = 0; s < r->samples; s++) {
        value[s] = times(r->z[s], before[s]);
    }
    r->degree = k;
    for (int j = 0; j < k; j++) { /* raised by one: times 1 */
        multiply_net(r, k - 1, 1, 0, 1, net_of(r, j), net_of(r, j));
    }
    for (int pass = 0; pass < 2; pass++) {
        for (int j = 0; j < k; j++) {
            subtract_polynomial(r, inner(r, r->value + j * r->samples, value), j, k);
        }
    }
    r->last = 1 / normalise(r, k);
}

static int recurrence_run(int steps, double across, double along, taut_arena *arena, recurrence *r)
{
    const int nodes = steps + 2;
    const taut_wide side = fmaxl((taut_wide)across, (taut_wide)along);

    *r = (recurrence){.a = 2 * (taut_wide)across / side,
                      .b = 2 * (taut_wide)along / side,
                      .steps = steps,
                      .size = steps + 1,
                      .samples = 4 * nodes};
    const size_t polynomials = (size_t)steps + 1, samples = (size_t)r->samples;
    r->net = taut_arena_take(arena, polynomials * polynomials * polynomials, sizeof *r->net);
    r->value = taut_arena_take(arena, polynomials * samples, sizeof *r->value);
    r->z = taut_arena_take(arena, samples, sizeof *r->z);
    r->weight = taut_arena_take(arena, samples, sizeof *r->weight);
    if (r->net == NULL || r->value == NULL || r->z == NULL || r->weight == NULL) {
        return 0;
    }
    sample_boundary(r, nodes);
    r->net[0].re = 1;
    for (int s = 0; s < r->samples; s++) {
        r->value[s].re = 1;
    }
    (void)normalise(r, 0);
    for (int k = 1; k <= steps; k++) {
        advance(r, k);
    }
    return 1;
}

/* Of a line of Bernstein coefficients of degree d that has degree d-1 in truth: to degree d-1, from
 * both ends to the middle, where the factors i / (d - i) are at most 1. */
static void reduce_line(int d, long stride, taut_wide *c)
{
    taut_wide reduced[TAUT_SPACE_DEGREE_MAX + 2];
    for (int i = 0; 2 * i < d; i++) {
        reduced[i] = (d * c[i * stride] - (i > 0 ? i * reduced[i - 1] : 0)) / (d - i);
    }
    for (int i = d - 1; 2 * i >= d; i--) {
        const taut_wide above = i < d - 1 ? (d - 1 - i) * reduced[i + 1] : 0;
        reduced[i] = (d * c[(i + 1) * stride] - above) / (i + 1);
    }
    for (int i = 0; i < d; i++) {
        c[i * stride] = reduced[i];
    }
}

static void raise_line(int from, int to, long stride, taut_wide *c)
{
    for (int d = from + 1; d <= to; d++) {
        c[d * stride] = c[(d - 1) * stride];
        for (int i = d - 1; i > 0; i--) {
            c[i * stride] = (i * c[(i - 1) * stride] + (d - i) * c[i * stride]) / d;
        }
    }
}

/* Brings a net of bidegree (d, d), rows of `size` numbers, to the space's bidegree as its next
 * function. Where a degree falls it is by one, of a net that has no more. */
static void add_net(taut_space *space, int d, int size, taut_wide *net)
{
    taut_wide *to =
        space->nets + (size_t)space->count * (size_t)(space->n + 1) * (size_t)(space->m + 1);
    assert(space->n >= d - 1 && space->m >= d - 1 && size > space->n && size > space->m);
    for (int j = 0; j <= d; j++) {
        if (space->n < d) {
            reduce_line(d, size, net + j);
        } else {
            raise_line(d, space->n, size, net + j);
        }
    }
    for (int i = 0; i <= space->n; i++) {
        if (space->m < d) {
            reduce_line(d, 1, net + i * size);
        } else {
            raise_line(d, space->m, 1, net + i * size);
        }
        memcpy(to + i * (space->m + 1), net + i * size, (size_t)(space->m + 1) * sizeof *to);
    }
    space->count++;
}

/* The real or imaginary part of a complex net, as the next function. */
static void add_part(taut_space *space, const recurrence *r, int d, const complex_wide *net,
                     int imaginary, int size, taut_wide *work)
{
    for (int i = 0; i <= d; i++) {
        for (int j = 0; j <= d; j++) {
            const complex_wide c = net[i * r->size + j];
            work[i * size + j] = imaginary ? c.im : c.re;
        }
    }
    add_net(space, d, size, work);
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

int taut_space_harmonic(int n, int m, double across, double along, taut_arena *arena,
                        taut_space *space)
{
    const int least = n < m ? n : m;
    /* which part of z^(least+1) lacks the pure powers that the bidegree forbids; -1: neither */
    const int extra = n == m ? (n % 2 != 0 ? 1 : -1) : n < m ? 1 : least % 2 != 0 ? 1 : 0;
    const int steps = extra >= 0 ? least + 1 : least, size = larger(steps, larger(n, m)) + 1;
    const size_t numbers = (size_t)(n + 1) * (size_t)(m + 1);
    taut_wide *work = taut_arena_take(arena, (size_t)size * (size_t)size, sizeof *work);
    recurrence r;

    *space = (taut_space){.n = n, .m = m};
    space->nets = taut_arena_take(arena, (size_t)(2 * least + 2) * numbers, sizeof(taut_wide));
    if (work == NULL || space->nets == NULL || !recurrence_run(steps, across, along, arena, &r)) {
        return 0;
    }
    for (int k = 0; k <= least; k++) { /* all were raised along: one degree too many */
        add_part(space, &r, r.degree, net_of(&r, k), 0, size, work);
        if (k > 0) {
            add_part(space, &r, r.degree, net_of(&r, k), 1, size, work);
        }
    }
    if (extra >= 0) {
        add_part(space, &r, r.degree, net_of(&r, steps), extra, size, work);
    }
    return 1;
}

/* to = x + factor y, complex nets of the recurrence's size. */
static void combine_nets(const recurrence *r, const complex_wide *x, taut_wide factor,
                         const complex_wide *y, complex_wide *to)
{
    for (int i = 0; i < r->size * r->size; i++) {
        to[i].re = x[i].re + factor * y[i].re;
        to[i].im = x[i].im + factor * y[i].im;
    }
}

/* The two functions of degree n+1 without pure powers u^(n+1), v^(n+1). The leading term of q_{n+1}
 * is `last` times that of conj(z) q_n, but for one z that is conjugate: with i^(n+1) real the
 * imaginary parts have none; with it imaginary Re(q_{n+1} - last conj(z) q_n) and Im(q_{n+1} + last
 * conj(z) q_n). */
static void add_extras(taut_space *space, const recurrence *r, const complex_wide *product,
                       complex_wide *sum, taut_wide *work)
{
    const int n = space->n;
    if (n % 2 != 0) {
        add_part(space, r, n + 1, net_of(r, n + 1), 1, r->size, work);
        add_part(space, r, n + 1, product, 1, r->size, work);
    } else {
        combine_nets(r, net_of(r, n + 1), -r->last, product, sum);
        add_part(space, r, n + 1, sum, 0, r->size, work);
        combine_nets(r, net_of(r, n + 1), r->last, product, sum);
        add_part(space, r, n + 1, sum, 1, r->size, work);
    }
}

int taut_space_biharmonic(int n, double across, double along, taut_arena *arena, taut_space *space)
{
    const int steps = n + 1, size = steps + 1;
    const size_t numbers = (size_t)size * (size_t)size;
    taut_wide *work = taut_arena_take(arena, numbers, sizeof *work);
    complex_wide *product = taut_arena_take(arena, 2 * numbers, sizeof *product);
    recurrence r;

    if (n == 1) { /* every bilinear surface */
        return taut_space_harmonic(1, 1, across, along, arena, space);
    }
    *space = (taut_space){.n = n, .m = n};
    space->nets = taut_arena_take(arena, 4 * (size_t)n * (size_t)(n + 1) * (size_t)(n + 1),
                                  sizeof(taut_wide));
    if (work == NULL || product == NULL || space->nets == NULL ||
        !recurrence_run(steps, across, along, arena, &r)) {
        return 0;
    }
    for (int k = 0; k <= n; k++) {
        add_part(space, &r, n + 1, net_of(&r, k), 0, size, work);
        if (k > 0) {
            add_part(space, &r, n + 1, net_of(&r, k), 1, size, work);
        }
    }
    for (int k = 1; k <= n; k++) { /* conj(z) q_k, k < n, has degree n at most */
        complex_wide *low = product + numbers;
        memcpy(low, net_of(&r, k), numbers * sizeof *low);
        for (int pass = 0; pass < 2; pass++) { /* back to bidegree (n, n), each part */
            for (int line = 0; line <= n + 1; line++) {
                taut_wide part[2][TAUT_SPACE_DEGREE_MAX + 2];
                const long stride = pass == 0 ? size : 1;
                complex_wide *first = low + line * (pass == 0 ? 1 : size);
                for (int i = 0; i <= n + 1; i++) {
                    part[0][i] = first[i * stride].re;
                    part[1][i] = first[i * stride].im;
                }
                reduce_line(n + 1, 1, part[0]);
                reduce_line(n + 1, 1, part[1]);
                for (int i = 0; i <= n; i++) {
                    first[i * stride] = (complex_wide){part[0][i], part[1][i]};
                }
            }
        }
        multiply_net(&r, n, 0, 1, -1, low, product);
        if (k < n) {
            add_part(space, &r, n + 1, product, 0, size, work);
            if (k > 1) { /* Im conj(z) q_1 is linear */
                add_part(space, &r, n + 1, product, 1, size, work);
            }
        }
    }
    add_extras(space, &r, product, product + numbers, work);
    return 1;
}
