#include "construct/harmonic/space.h"

#include "numeric/quadrature.h"

#include <assert.h>
#include <math.h>
#include <string.h>

/* Operations in twice the precision a complex number of a net, as pulses count them. */
enum { OF_RAISE = 10, OF_SUBTRACT = 6, OF_MULTIPLY = 30 };

/* A complex number, or a factor of the recurrence. */
typedef struct complex_wide {
    taut_twice re, im;
} complex_wide;

/* The polynomials q_0 .. q_steps, all raised to bidegree (degree, degree). */
typedef struct recurrence {
    taut_twice a, b; /* A and B: z is at most about 1 in size */
    int steps, degree, size;
    complex_wide *net; /* [steps+1][size][size], size = steps + 1: the leading (degree+1)^2 used */
    complex_wide *value; /* [steps+1][samples] */
    complex_wide *z;     /* [samples] */
    double *weight;      /* [samples] */
    int samples;
    taut_twice last; /* leading coefficient of the last polynomial over that of the one before */
    taut_pulse *pulse;
} recurrence;

static complex_wide times(complex_wide x, complex_wide y)
{
    return (complex_wide){
        taut_twice_gain(taut_twice_times(x.re, y.re), taut_twice_negative(x.im), y.im),
        taut_twice_gain(taut_twice_times(x.re, y.im), x.im, y.re)};
}

static complex_wide divide(complex_wide x, double by)
{
    return (complex_wide){taut_twice_over_number(x.re, by), taut_twice_over_number(x.im, by)};
}

/* Nonzero when it is to end; so many operations in twice the precision for each number of a net. */
static int beat(const recurrence *r, int operations)
{
    return taut_pulse_beat(r->pulse, (double)TAUT_TWICE_WORK * operations * r->size * r->size);
}

static void add_scaled(double share, complex_wide x, complex_wide *sum)
{
    sum->re = taut_twice_gain(sum->re, taut_twice_of(share), x.re);
    sum->im = taut_twice_gain(sum->im, taut_twice_of(share), x.im);
}

static complex_wide less(complex_wide x, complex_wide y)
{
    return (complex_wide){taut_twice_less(x.re, y.re), taut_twice_less(x.im, y.im)};
}

/* The share of corner (di, dj) in the mean over the four neighbours that raises a net to bidegree
 * (k+1, k+1), times (k+1)^2. */
static int share_of_corner(int k, int i, int j, int di, int dj)
{
    return (di ? i : k + 1 - i) * (dj ? j : k + 1 - j);
}

/* to[i][j], bidegree (k+1, k+1), of the net from[i][j], bidegree (k, k), times z (sign 1) or
 * conj(z) (sign -1): the mean over the four neighbours of the coefficient times the factor's at
 * that corner. Safe in place. */
static void multiply_net(const recurrence *r, int k, int sign, const complex_wide *from,
                         complex_wide *to)
{
    const taut_twice a = taut_twice_scale(0.5, r->a), b = taut_twice_scale(0.5 * sign, r->b);
    for (int i = k + 1; i >= 0; i--) {
        for (int j = k + 1; j >= 0; j--) {
            complex_wide sum = {{0, 0}, {0, 0}};
            for (int corner = 0; corner < 4; corner++) {
                const int di = corner / 2, dj = corner % 2;
                const int share = share_of_corner(k, i, j, di, dj);
                if (share != 0) {
                    const complex_wide factor = {di ? a : taut_twice_negative(a),
                                                 dj ? b : taut_twice_negative(b)};
                    add_scaled(share, times(factor, from[(i - di) * r->size + j - dj]), &sum);
                }
            }
            to[i * r->size + j] = divide(sum, (k + 1) * (k + 1));
        }
    }
}

/* The same net, bidegree (k, k), with bidegree (k+1, k+1). In place. */
static void raise_net(const recurrence *r, int k, complex_wide *net)
{
    for (int i = k + 1; i >= 0; i--) {
        for (int j = k + 1; j >= 0; j--) {
            complex_wide sum = {{0, 0}, {0, 0}};
            for (int corner = 0; corner < 4; corner++) {
                const int di = corner / 2, dj = corner % 2;
                const int share = share_of_corner(k, i, j, di, dj);
                if (share != 0) {
                    add_scaled(share, net[(i - di) * r->size + j - dj], &sum);
                }
            }
            net[i * r->size + j] = divide(sum, (k + 1) * (k + 1));
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
            const double at = t[k] / 2, end = side % 2 == 0 ? -0.5 : 0.5;
            const int s = side * nodes + k;
            r->z[s].re = taut_twice_scale(side < 2 ? end : at, r->a);
            r->z[s].im = taut_twice_scale(side < 2 ? at : end, r->b);
            r->weight[s] = w[k] / 8;
        }
    }
}

static complex_wide inner(const recurrence *r, const complex_wide *x, const complex_wide *y)
{
    complex_wide sum = {{0, 0}, {0, 0}};
    for (int s = 0; s < r->samples; s++) {
        const complex_wide conjugate = {x[s].re, taut_twice_negative(x[s].im)};
        add_scaled(r->weight[s], times(conjugate, y[s]), &sum);
    }
    return sum; /* <x, y> = sum w conj(x) y */
}

/* q -= h q_j on samples and net. */
static void subtract_polynomial(const recurrence *r, complex_wide h, int j, int k)
{
    complex_wide *net = net_of(r, k);
    const complex_wide *other = net_of(r, j);
    for (int s = 0; s < r->samples; s++) {
        complex_wide *const at = r->value + k * r->samples + s;
        *at = less(*at, times(h, r->value[j * r->samples + s]));
    }
    for (int i = 0; i <= r->degree; i++) {
        for (int c = 0; c <= r->degree; c++) {
            complex_wide *const at = net + i * r->size + c;
            *at = less(*at, times(h, other[i * r->size + c]));
        }
    }
}

/* Divides q_k by its norm; returns the factor. */
static taut_twice normalise(const recurrence *r, int k)
{
    complex_wide *value = r->value + k * r->samples, *net = net_of(r, k);
    const taut_twice norm = taut_twice_root(inner(r, value, value).re);
    const complex_wide factor = {taut_twice_over(taut_twice_of(1), norm), {0, 0}};
    for (int s = 0; s < r->samples; s++) {
        value[s] = times(factor, value[s]);
    }
    for (int i = 0; i < r->size * r->size; i++) {
        net[i] = times(factor, net[i]);
    }
    return factor.re;
}

/* q_k = (z q_{k-1} - sum_j h_j q_j) / h, orthogonalised twice. */
static void advance(recurrence *r, int k)
{
    const complex_wide *before = r->value + (k - 1) * r->samples;
    complex_wide *value = r->value + k * r->samples;

    multiply_net(r, k - 1, 1, net_of(r, k - 1), net_of(r, k));
    for (int s = 0; s < r->samples; s++) {
        value[s] = times(r->z[s], before[s]);
    }
    r->degree = k;
    for (int j = 0; j < k && !beat(r, OF_RAISE); j++) {
        raise_net(r, k - 1, net_of(r, j));
    }
    for (int pass = 0; pass < 2; pass++) {
        for (int j = 0; j < k && !beat(r, OF_SUBTRACT); j++) {
            subtract_polynomial(r, inner(r, r->value + j * r->samples, value), j, k);
        }
    }
    r->last = normalise(r, k);
}

static int recurrence_run(int steps, double across, double along, taut_arena *arena,
                          taut_pulse *pulse, recurrence *r)
{
    const int nodes = steps + 2;
    const double side = fmax(across, along);

    *r = (recurrence){.a = taut_twice_scale(2, taut_twice_over_number(taut_twice_of(across), side)),
                      .b = taut_twice_scale(2, taut_twice_over_number(taut_twice_of(along), side)),
                      .steps = steps,
                      .size = steps + 1,
                      .samples = 4 * nodes,
                      .pulse = pulse};
    const size_t polynomials = (size_t)steps + 1, samples = (size_t)r->samples;
    r->net = taut_arena_take(arena, polynomials * polynomials * polynomials, sizeof *r->net);
    r->value = taut_arena_take(arena, polynomials * samples, sizeof *r->value);
    r->z = taut_arena_take(arena, samples, sizeof *r->z);
    r->weight = taut_arena_take(arena, samples, sizeof *r->weight);
    if (r->net == NULL || r->value == NULL || r->z == NULL || r->weight == NULL) {
        return 0;
    }
    sample_boundary(r, nodes);
    r->net[0].re = taut_twice_of(1);
    for (int s = 0; s < r->samples; s++) {
        r->value[s].re = taut_twice_of(1);
    }
    (void)normalise(r, 0);
    for (int k = 1; k <= steps && !taut_pulse_is_stopped(pulse); k++) {
        advance(r, k);
    }
    return 1;
}

/* Of a line of Bernstein coefficients of degree d that has degree d-1 in truth: to degree d-1, from
 * both ends to the middle, where the factors i / (d - i) are at most 1. */
static void reduce_line(int d, ptrdiff_t stride, taut_twice *c)
{
    taut_twice reduced[TAUT_SPACE_DEGREE_MAX + 2];
    for (int i = 0; 2 * i < d; i++) {
        const taut_twice all = taut_twice_scale(d, c[i * stride]);
        const taut_twice rest =
            i > 0 ? taut_twice_gain(all, taut_twice_of(-i), reduced[i - 1]) : all;
        reduced[i] = taut_twice_over_number(rest, d - i);
    }
    for (int i = d - 1; 2 * i >= d; i--) {
        const taut_twice all = taut_twice_scale(d, c[(i + 1) * stride]);
        const taut_twice rest =
            i < d - 1 ? taut_twice_gain(all, taut_twice_of(i + 1 - d), reduced[i + 1]) : all;
        reduced[i] = taut_twice_over_number(rest, i + 1);
    }
    for (int i = 0; i < d; i++) {
        c[i * stride] = reduced[i];
    }
}

static void raise_line(int from, int to, ptrdiff_t stride, taut_twice *c)
{
    for (int d = from + 1; d <= to; d++) {
        c[d * stride] = c[(d - 1) * stride];
        for (int i = d - 1; i > 0; i--) {
            const taut_twice low = taut_twice_scale(i, c[(i - 1) * stride]);
            const taut_twice sum = taut_twice_gain(low, taut_twice_of(d - i), c[i * stride]);
            c[i * stride] = taut_twice_over_number(sum, d);
        }
    }
}

/* Brings a net of bidegree (d, d), rows of `size` numbers, to the space's bidegree as its next
 * function. Where a degree falls it is by one, of a net that has no more. */
static void add_net(taut_space *space, int d, int size, taut_twice *net)
{
    taut_twice *to =
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
                     int imaginary, int size, taut_twice *work)
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

/* Before two nets are brought to the space's bidegree. */
static int beat_of_lines(const taut_space *space, const recurrence *r)
{
    const int most = larger(space->n, space->m);
    return beat(r, 4 * (1 + larger(0, most - r->degree)));
}

int taut_space_harmonic(int n, int m, double across, double along, taut_arena *arena,
                        taut_pulse *pulse, taut_space *space)
{
    const int least = n < m ? n : m;
    /* which part of z^(least+1) lacks the pure powers that the bidegree forbids; -1: neither */
    const int extra = n == m ? (n % 2 != 0 ? 1 : -1) : n < m ? 1 : least % 2 != 0 ? 1 : 0;
    const int steps = extra >= 0 ? least + 1 : least, size = larger(steps, larger(n, m)) + 1;
    const size_t numbers = (size_t)(n + 1) * (size_t)(m + 1);
    taut_twice *work = taut_arena_take(arena, (size_t)size * (size_t)size, sizeof *work);
    recurrence r;

    *space = (taut_space){.n = n, .m = m, .pulse = pulse};
    space->nets = taut_arena_take(arena, (size_t)(2 * least + 2) * numbers, sizeof(taut_twice));
    if (work == NULL || space->nets == NULL ||
        !recurrence_run(steps, across, along, arena, pulse, &r)) {
        return 0;
    }
    for (int k = 0; k <= least && !beat_of_lines(space, &r);
         k++) { /* all were raised along: one degree too many */
        add_part(space, &r, r.degree, net_of(&r, k), 0, size, work);
        if (k > 0) {
            add_part(space, &r, r.degree, net_of(&r, k), 1, size, work);
        }
    }
    if (extra >= 0 && !taut_pulse_is_stopped(pulse)) {
        add_part(space, &r, r.degree, net_of(&r, steps), extra, size, work);
    }
    return !taut_pulse_is_stopped(pulse);
}

/* to = x + factor y, complex nets of the recurrence's size. */
static void combine_nets(const recurrence *r, const complex_wide *x, taut_twice factor,
                         const complex_wide *y, complex_wide *to)
{
    for (int i = 0; i < r->size * r->size; i++) {
        to[i].re = taut_twice_gain(x[i].re, factor, y[i].re);
        to[i].im = taut_twice_gain(x[i].im, factor, y[i].im);
    }
}

/* The two functions of degree n+1 without pure powers u^(n+1), v^(n+1). The leading term of q_{n+1}
 * is `last` times that of conj(z) q_n, but for one z that is conjugate: with i^(n+1) real the
 * imaginary parts have none; with it imaginary Re(q_{n+1} - last conj(z) q_n) and Im(q_{n+1} + last
 * conj(z) q_n). */
static void add_extras(taut_space *space, const recurrence *r, const complex_wide *product,
                       complex_wide *sum, taut_twice *work)
{
    const int n = space->n;
    if (n % 2 != 0) {
        add_part(space, r, n + 1, net_of(r, n + 1), 1, r->size, work);
        add_part(space, r, n + 1, product, 1, r->size, work);
    } else {
        combine_nets(r, net_of(r, n + 1), taut_twice_negative(r->last), product, sum);
        add_part(space, r, n + 1, sum, 0, r->size, work);
        combine_nets(r, net_of(r, n + 1), r->last, product, sum);
        add_part(space, r, n + 1, sum, 1, r->size, work);
    }
}

int taut_space_biharmonic(int n, double across, double along, taut_arena *arena, taut_pulse *pulse,
                          taut_space *space)
{
    const int steps = n + 1, size = steps + 1;
    const size_t numbers = (size_t)size * (size_t)size;
    taut_twice *work = taut_arena_take(arena, numbers, sizeof *work);
    complex_wide *product = taut_arena_take(arena, 2 * numbers, sizeof *product);
    recurrence r;

    if (n == 1) { /* every bilinear surface */
        return taut_space_harmonic(1, 1, across, along, arena, pulse, space);
    }
    *space = (taut_space){.n = n, .m = n, .pulse = pulse};
    space->nets = taut_arena_take(arena, 4 * (size_t)n * (size_t)(n + 1) * (size_t)(n + 1),
                                  sizeof(taut_twice));
    if (work == NULL || product == NULL || space->nets == NULL ||
        !recurrence_run(steps, across, along, arena, pulse, &r)) {
        return 0;
    }
    for (int k = 0; k <= n && !beat_of_lines(space, &r); k++) {
        add_part(space, &r, n + 1, net_of(&r, k), 0, size, work);
        if (k > 0) {
            add_part(space, &r, n + 1, net_of(&r, k), 1, size, work);
        }
    }
    /* conj(z) q_k, k < n, has degree n at most */
    for (int k = 1; k <= n && !beat_of_lines(space, &r) && !beat(&r, OF_MULTIPLY); k++) {
        complex_wide *low = product + numbers;
        memcpy(low, net_of(&r, k), numbers * sizeof *low);
        for (int pass = 0; pass < 2; pass++) { /* back to bidegree (n, n), each part */
            for (int line = 0; line <= n + 1; line++) {
                taut_twice part[2][TAUT_SPACE_DEGREE_MAX + 2];
                const ptrdiff_t stride = pass == 0 ? size : 1;
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
        multiply_net(&r, n, -1, low, product);
        if (k < n) {
            add_part(space, &r, n + 1, product, 0, size, work);
            if (k > 1) { /* Im conj(z) q_1 is linear */
                add_part(space, &r, n + 1, product, 1, size, work);
            }
        }
    }
    if (taut_pulse_is_stopped(pulse)) {
        return 0;
    }
    add_extras(space, &r, product, product + numbers, work);
    return 1;
}
