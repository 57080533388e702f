#include "construct/harmonic/space.h"

#include "numeric/quadrature.h"
#include "numeric/wide.h"

#include <assert.h>
#include <math.h>
#include <string.h>

/* Operations in twice the precision a complex number of a net, as pulses count them. */
enum { OF_RAISE = 2, OF_SUBTRACT = 3, OF_MULTIPLY = 6 };

/* The polynomials q_0 .. q_steps, all raised to bidegree (degree, degree). Complex numbers are two after one another. Nets are
 * weighted: C(degree,i) C(degree,j) times the coefficient. What is even or odd in z is so in the sum over the boundary, which is
 * that of the quarter u, v <= 1/2 then, and real. */
typedef struct recurrence {
    taut_twice a, b; /* A and B: z is at most about 1 in size */
    int steps, degree, size;
    taut_twice *net; /* [steps+1][size][size][2], size = steps + 1: the leading (degree+1)^2 used */
    taut_twice *value; /* [steps+1][samples][2] */
    taut_twice *z;     /* [samples][2] */
    double *weight;    /* [samples] */
    int samples;
    taut_twice last; /* leading coefficient of the last polynomial over that of the one before */
    taut_pulse *pulse;
} recurrence;

/* Nonzero when it is to end; so many operations in twice the precision for each number of a net. */
static int beat(const recurrence *r, int operations)
{
    return taut_pulse_beat(r->pulse, (double)TAUT_TWICE_WORK * operations * r->size * r->size);
}

/* to = x y. */
static void multiply(const taut_twice *x, const taut_twice *y, taut_twice *to)
{
    to[0] = taut_twice_gain(taut_twice_times(x[0], y[0]), taut_twice_negative(x[1]), y[1]);
    to[1] = taut_twice_gain(taut_twice_times(x[0], y[1]), x[1], y[0]);
}

/* A number of a net of bidegree (k, k), 0 beyond it. */
static taut_twice number_at(const recurrence *r, int k, const taut_twice *net, int i, int j,
                            int part)
{
    const int is_there = i >= 0 && j >= 0 && i <= k && j <= k;
    return is_there ? net[2 * (i * r->size + j) + part] : taut_twice_of(0);
}

/* to[i][j], bidegree (k+1, k+1), of the net from[i][j], bidegree (k, k), times z (sign 1) or conj(z) (sign -1), which is
 * a/2 (+-1 along u) + i b/2 (+-1 along v). */
static void multiply_net(const recurrence *r, int k, int sign, const taut_twice *from,
                         taut_twice *to)
{
    const taut_twice a = taut_twice_scale(0.5, r->a), b = taut_twice_scale(0.5 * sign, r->b);
    for (int i = 0; i <= k + 1; i++) {
        for (int j = 0; j <= k + 1; j++) {
            taut_twice along_u[2], along_v[2], *const at = to + 2 * (i * r->size + j);
            for (int part = 0; part < 2; part++) {
                const taut_twice both = taut_twice_less(number_at(r, k, from, i - 1, j - 1, part),
                                                        number_at(r, k, from, i, j, part));
                const taut_twice one = taut_twice_less(number_at(r, k, from, i - 1, j, part),
                                                       number_at(r, k, from, i, j - 1, part));
                along_u[part] = taut_twice_add(both, one);
                along_v[part] = taut_twice_less(both, one);
            }
            at[0] = taut_twice_gain(taut_twice_times(a, along_u[0]), taut_twice_negative(b),
                                    along_v[1]);
            at[1] = taut_twice_gain(taut_twice_times(a, along_u[1]), b, along_v[0]);
        }
    }
}

/* The same net, bidegree (k, k), with bidegree (k+1, k+1). In place. */
static void raise_net(const recurrence *r, int k, taut_twice *net)
{
    taut_raise_weighted(k, k + 1, 2 * r->size, net);
    for (int i = 0; i <= k + 1; i++) {
        taut_raise_weighted(k, k + 1, 2, net + 2 * i * r->size);
    }
}

static taut_twice *net_of(const recurrence *r, int k)
{
    return r->net + 2 * (size_t)k * (size_t)r->size * (size_t)r->size;
}

static taut_twice *values_of(const recurrence *r, int k)
{
    return r->value + 2 * k * r->samples;
}

/* Points of the edges u = 0 and v = 0 at Gauss nodes to the middle, of whole edges more than a polynomial of the degree can vanish
 * at; each for four of the boundary, in the middle for two. */
static void sample_boundary(recurrence *r, int nodes)
{
    double t[TAUT_GAUSS_MAX], w[TAUT_GAUSS_MAX];
    const int half = r->samples / 2;
    taut_gauss_rule(nodes, t, w);
    for (int s = 0; s < r->samples; s++) {
        const int k = s % half;
        const double at = t[k] / 2, end = -0.5;
        r->z[2 * s] = taut_twice_scale(s < half ? end : at, r->a);
        r->z[2 * s + 1] = taut_twice_scale(s < half ? at : end, r->b);
        r->weight[s] = w[k] / (2 * k + 1 == nodes ? 4 : 2);
    }
}

/* <x, y> = sum w conj(x) y, of two polynomials that are both even or both odd. */
static taut_twice inner(const recurrence *r, const taut_twice *x, const taut_twice *y)
{
    taut_twice sum = {0, 0};
    for (int s = 0; s < 2 * r->samples; s++) {
        sum = taut_twice_gain(sum, taut_twice_scale(r->weight[s / 2], x[s]), y[s]);
    }
    return sum;
}

/* q_k += h q_j on samples and net. */
static void add_polynomial(const recurrence *r, taut_twice h, int j, int k)
{
    taut_twice *net = net_of(r, k);
    const taut_twice *other = net_of(r, j);
    taut_wide_gain(2 * r->samples, h, values_of(r, j), values_of(r, k));
    for (int i = 0; i <= r->degree; i++) {
        taut_wide_gain(2 * (r->degree + 1), h, other + 2 * i * r->size, net + 2 * i * r->size);
    }
}

/* Divides q_k by its norm; returns the factor. */
static taut_twice normalise(const recurrence *r, int k)
{
    taut_twice *value = values_of(r, k), *net = net_of(r, k);
    const taut_twice factor =
        taut_twice_over(taut_twice_of(1), taut_twice_root(inner(r, value, value)));
    for (int s = 0; s < 2 * r->samples; s++) {
        value[s] = taut_twice_times(factor, value[s]);
    }
    for (int i = 0; i < 2 * r->size * r->size; i++) {
        net[i] = taut_twice_times(factor, net[i]);
    }
    return factor;
}

/* q_k = (z q_{k-1} - sum_j h_j q_j) / h, orthogonalised twice; h_j is 0 where one is even and one odd. */
static void advance(recurrence *r, int k)
{
    taut_twice *value = values_of(r, k);

    multiply_net(r, k - 1, 1, net_of(r, k - 1), net_of(r, k));
    for (int s = 0; s < r->samples; s++) {
        multiply(r->z + 2 * s, values_of(r, k - 1) + 2 * s, value + 2 * s);
    }
    r->degree = k;
    for (int j = 0; j < k && !beat(r, OF_RAISE); j++) {
        raise_net(r, k - 1, net_of(r, j));
    }
    for (int pass = 0; pass < 2; pass++) {
        for (int j = k % 2; j < k && !beat(r, OF_SUBTRACT); j += 2) {
            add_polynomial(r, taut_twice_negative(inner(r, values_of(r, j), value)), j, k);
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
                      .samples = 2 * ((nodes + 1) / 2),
                      .pulse = pulse};
    const size_t polynomials = (size_t)steps + 1, samples = (size_t)r->samples;
    r->net = taut_arena_take(arena, 2 * polynomials * polynomials * polynomials, sizeof *r->net);
    r->value = taut_arena_take(arena, 2 * polynomials * samples, sizeof *r->value);
    r->z = taut_arena_take(arena, 2 * samples, sizeof *r->z);
    r->weight = taut_arena_take(arena, samples, sizeof *r->weight);
    if (r->net == NULL || r->value == NULL || r->z == NULL || r->weight == NULL) {
        return 0;
    }
    sample_boundary(r, nodes);
    r->net[0] = taut_twice_of(1);
    for (int s = 0; s < r->samples; s++) {
        r->value[2 * s] = taut_twice_of(1);
    }
    (void)normalise(r, 0);
    for (int k = 1; k <= steps && !taut_pulse_is_stopped(pulse); k++) {
        advance(r, k);
    }
    return 1;
}

/* Of a weighted line of degree d that has degree d-1 in truth: to degree d-1, from both ends to the middle, where unweighted
 * numbers get factors i / (d - i) of at most 1. */
static void reduce_line(int d, ptrdiff_t stride, taut_twice *c)
{
    const int middle = (d + 1) / 2;
    for (int i = 1; i < middle; i++) {
        c[i * stride] = taut_twice_less(c[i * stride], c[(i - 1) * stride]);
    }
    for (int i = d - 1; i > middle; i--) {
        c[i * stride] = taut_twice_less(c[i * stride], c[(i + 1) * stride]);
    }
    for (int i = middle; i < d; i++) {
        c[i * stride] = c[(i + 1) * stride];
    }
}

/* Brings a weighted net of bidegree (d, d), rows of `size` numbers, to the space's bidegree as its next
 * function. Where a degree falls it is by one, of a net that has no more. */
static void add_net(taut_space *space, int d, int size, taut_twice *net)
{
    const int n = space->n, m = space->m;
    taut_twice across[TAUT_SPACE_DEGREE_MAX + 1], along[TAUT_SPACE_DEGREE_MAX + 1];
    taut_twice *to = space->nets + (size_t)space->count * (size_t)(n + 1) * (size_t)(m + 1);
    assert(n >= d - 1 && m >= d - 1 && size > n && size > m);
    taut_binomials(n, across);
    taut_binomials(m, along);
    for (int j = 0; j <= d && n < d; j++) {
        reduce_line(d, size, net + j);
    }
    taut_raise_weighted(d, n, size, net);
    for (int i = 0; i <= n; i++) {
        taut_twice *const row = net + i * size;
        if (m < d) {
            reduce_line(d, 1, row);
        }
        taut_raise_weighted(d, m, 1, row);
        for (int j = 0; j <= m; j++) {
            to[i * (m + 1) + j] = taut_twice_over(row[j], taut_twice_times(across[i], along[j]));
        }
    }
    space->count++;
}

/* The real or imaginary part of a complex net, as the next function. It is odd and even as that of z^power. */
static void add_part(taut_space *space, const recurrence *r, int power, const taut_twice *net,
                     int imaginary, int size, taut_twice *work)
{
    const int d = r->degree;
    for (int i = 0; i <= d; i++) {
        for (int j = 0; j <= d; j++) {
            work[i * size + j] = net[2 * (i * r->size + j) + imaginary];
        }
    }
    space->odd[space->count] = (unsigned char)((power + imaginary) % 2 + 2 * imaginary);
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
    space->odd = taut_arena_take(arena, (size_t)(2 * least + 2), 1);
    if (work == NULL || space->nets == NULL || space->odd == NULL ||
        !recurrence_run(steps, across, along, arena, pulse, &r)) {
        return 0;
    }
    for (int k = 0; k <= least && !beat_of_lines(space, &r);
         k++) { /* all were raised along: one degree too many */
        add_part(space, &r, k, net_of(&r, k), 0, size, work);
        if (k > 0) {
            add_part(space, &r, k, net_of(&r, k), 1, size, work);
        }
    }
    if (extra >= 0 && !taut_pulse_is_stopped(pulse)) {
        add_part(space, &r, steps, net_of(&r, steps), extra, size, work);
    }
    return !taut_pulse_is_stopped(pulse);
}

/* to = x + factor y, complex nets of the recurrence's size. */
static void combine_nets(const recurrence *r, const taut_twice *x, taut_twice factor,
                         const taut_twice *y, taut_twice *to)
{
    const int numbers = 2 * r->size * r->size;
    memcpy(to, x, (size_t)numbers * sizeof *to);
    taut_wide_gain(numbers, factor, y, to);
}

/* The two functions of degree n+1 without pure powers u^(n+1), v^(n+1). The leading term of q_{n+1}
 * is `last` times that of conj(z) q_n, but for one z that is conjugate: with i^(n+1) real the
 * imaginary parts have none; with it imaginary Re(q_{n+1} - last conj(z) q_n) and Im(q_{n+1} + last
 * conj(z) q_n). */
static void add_extras(taut_space *space, const recurrence *r, const taut_twice *product,
                       taut_twice *sum, taut_twice *work)
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
    taut_twice *product = taut_arena_take(arena, 4 * numbers, sizeof *product);
    recurrence r;

    if (n == 1) { /* every bilinear surface */
        return taut_space_harmonic(1, 1, across, along, arena, pulse, space);
    }
    *space = (taut_space){.n = n, .m = n, .pulse = pulse};
    space->nets = taut_arena_take(arena, 4 * (size_t)n * (size_t)(n + 1) * (size_t)(n + 1),
                                  sizeof(taut_twice));
    space->odd = taut_arena_take(arena, 4 * (size_t)n, 1);
    if (work == NULL || product == NULL || space->nets == NULL || space->odd == NULL ||
        !recurrence_run(steps, across, along, arena, pulse, &r)) {
        return 0;
    }
    for (int k = 0; k <= n && !beat_of_lines(space, &r); k++) {
        add_part(space, &r, k, net_of(&r, k), 0, size, work);
        if (k > 0) {
            add_part(space, &r, k, net_of(&r, k), 1, size, work);
        }
    }
    /* conj(z) q_k, k < n, has degree n at most */
    for (int k = 1; k <= n && !beat_of_lines(space, &r) && !beat(&r, OF_MULTIPLY); k++) {
        taut_twice *low = product + 2 * numbers; /* back to bidegree (n, n) */
        memcpy(low, net_of(&r, k), 2 * numbers * sizeof *low);
        for (int line = 0; line < 2 * size; line++) {
            reduce_line(n + 1, 2 * size, low + line);
        }
        for (int line = 0; line < 2 * size; line++) {
            reduce_line(n + 1, 2, low + line / 2 * 2 * size + line % 2);
        }
        multiply_net(&r, n, -1, low, product);
        if (k < n) {
            add_part(space, &r, k + 1, product, 0, size, work);
            if (k > 1) { /* Im conj(z) q_1 is linear */
                add_part(space, &r, k + 1, product, 1, size, work);
            }
        }
    }
    if (taut_pulse_is_stopped(pulse)) {
        return 0;
    }
    add_extras(space, &r, product, product + 2 * numbers, work);
    return 1;
}
