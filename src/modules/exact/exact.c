/* exact.c -- module `exact`: harmonic nets in rational arithmetic, by FLINT.
 *
 * The algorithms are the shortest ones, since nothing is rounded: completion by the chain of power
 * coefficients ([NiWang2015] sections 2.4, 2.5), other ranges by de Casteljau's triangle.
 */
#include "core/exact.h"
#include "rationals.h"
#include "taut/export.h"

#include <flint/fmpq.h>
#include <math.h>
#include <stdint.h>

static void set_binomial(fmpq_t x, int n, int k)
{
    fmpz_bin_uiui(fmpq_numref(x), (ulong)n, (ulong)k);
    fmpz_one(fmpq_denref(x));
}

/* One coordinate of two lines at work. */
typedef struct chain {
    int n, m;
    taut_rationals line[2]; /* Bernstein coefficients */
    taut_rationals power;   /* [n+1][m+1]: of u^k v^l */
    fmpq_t mu;
} chain;

/* The v^l coefficient of a line: C(m,l) Delta^l. */
static void find_coefficient(const chain *c, int side, int l, fmpq_t out)
{
    fmpq_t term;
    fmpq_init(term);
    fmpq_zero(out);
    for (int j = 0; j <= l; j++) {
        set_binomial(term, l, j);
        fmpq_mul(term, term, c->line[side].x + j);
        if ((l - j) % 2 != 0) {
            fmpq_neg(term, term);
        }
        fmpq_add(out, out, term);
    }
    set_binomial(term, c->m, l);
    fmpq_mul(out, out, term);
    fmpq_clear(term);
}

/* power[k][l] = -mu (l+1)(l+2) / (k(k-1)) power[k-2][l+2], from the two lines. */
static void run_chain(chain *c, int from_derivative)
{
    const int columns = c->m + 1;
    for (int l = c->m; l >= 0; l--) {
        fmpq *first = c->power.x + l, *second = first + columns;
        find_coefficient(c, 0, l, first);
        find_coefficient(c, 1, l, second);
        if (!from_derivative) {
            fmpq_sub(second, second, first);
        }
        for (int k = 2; k <= c->n; k++) {
            fmpq *at = first + k * columns;
            fmpq_zero(at);
            if (l + 2 <= c->m) {
                fmpq_set_si(at, -(int64_t)(l + 1) * (l + 2), (ulong)k * (ulong)(k - 1));
                fmpq_mul(at, at, c->mu);
                fmpq_mul(at, at, c->power.x + (k - 2) * columns + l + 2);
            }
            if (!from_derivative) {
                fmpq_sub(second, second, at);
            }
        }
    }
}

/* Lines of Bernstein coefficients from power coefficients: b_i = sum_k C(i,k) / C(d,k) a_k. */
static void to_bernstein(int d, int64_t stride, fmpq *a)
{
    taut_rationals b = taut_rationals_new(d + 1);
    fmpq_t ratio, term;
    fmpq_init(ratio);
    fmpq_init(term);
    for (int i = 0; i <= d; i++) {
        for (int k = 0; k <= i; k++) {
            set_binomial(ratio, i, k);
            set_binomial(term, d, k);
            fmpq_div(ratio, ratio, term);
            fmpq_mul(term, ratio, a + k * stride);
            fmpq_add(b.x + i, b.x + i, term);
        }
    }
    for (int i = 0; i <= d; i++) {
        fmpq_set(a + i * stride, b.x + i);
    }
    fmpq_clear(ratio);
    fmpq_clear(term);
    taut_rationals_free(&b);
}

static void note_move(taut_exact_net *net, const fmpq_t move)
{
    net->moved = 1;
    net->change = fmax(net->change, fabs(taut_rational_nearest(move)));
}

/* Even degree: makes the lines agree as asked ([NiWang2015] section 3, B.1). */
static void mend_lines(chain *c, const taut_exact_lines *lines, const fmpq_t defect,
                       taut_exact_net *net)
{
    fmpq_t weight, share;
    fmpq_init(weight);
    fmpq_init(share);
    if (lines->corner_missing || lines->even == 1) {
        fmpq_sub(c->line[1].x + c->m, c->line[1].x + c->m, defect);
        if (!lines->corner_missing) {
            note_move(net, defect);
        }
    } else {
        for (int j = 0; j <= c->m; j++) {
            set_binomial(weight, c->m, j);
            set_binomial(share, 2 * c->m, c->m);
            fmpq_div(weight, weight, share);
            fmpq_div_2exp(weight, weight, 1);
            fmpq_mul(weight, weight, defect);
            if ((c->m - j) % 2 != 0) {
                fmpq_neg(weight, weight);
            }
            fmpq_add(c->line[0].x + j, c->line[0].x + j, weight);
            fmpq_sub(c->line[1].x + j, c->line[1].x + j, weight);
            note_move(net, weight);
        }
    }
    fmpq_clear(weight);
    fmpq_clear(share);
}

/* The v^m coefficients must agree where m = n is even: their difference, the derivative's own. */
static void defect_of(const chain *c, int from_derivative, fmpq_t defect)
{
    fmpq_t first;
    fmpq_init(first);
    find_coefficient(c, 1, c->m, defect);
    if (!from_derivative) {
        find_coefficient(c, 0, c->m, first);
        fmpq_sub(defect, defect, first);
    }
    fmpq_clear(first);
}

/* to - from, which as a double may be rounded. */
static void length_of(const double range[2], fmpq_t length)
{
    fmpq_t from;
    fmpq_init(from);
    taut_rational_set_double(from, range[0]);
    taut_rational_set_double(length, range[1]);
    fmpq_sub(length, length, from);
    fmpq_clear(from);
}

static void read_lines(chain *c, const taut_exact_lines *lines, int coordinate)
{
    fmpq_t width;
    fmpq_init(width);
    length_of(lines->across, width);
    for (int side = 0; side < 2; side++) {
        for (int j = 0; j <= c->m; j++) {
            taut_rational_set(c->line[side].x + j, &lines->line[side],
                              (size_t)(3 * j + coordinate));
            if (side == 1 && lines->from_derivative) {
                fmpq_mul(c->line[side].x + j, c->line[side].x + j, width);
            }
        }
    }
    fmpq_clear(width);
}

/* Is a degree raised, or is there no net? Any coordinate can say so. */
static int survey_lines(chain *c, const taut_exact_lines *lines, taut_exact_net *net)
{
    const int open = c->m % 2 == 0 && c->n == c->m && !lines->corner_missing;
    fmpq_t defect;
    fmpq_init(defect);
    for (int coordinate = 0; open && coordinate < 3; coordinate++) {
        read_lines(c, lines, coordinate);
        defect_of(c, lines->from_derivative, defect);
        if (!fmpq_is_zero(defect)) {
            net->defect = fmax(net->defect, fmax(fabs(taut_rational_nearest(defect)), 0x1p-1000));
        }
    }
    fmpq_clear(defect);
    return net->defect > 0 && lines->even == 0;
}

static void chain_new(chain *c, const taut_exact_lines *lines, int n)
{
    fmpq_t along;
    c->n = n;
    c->m = lines->m;
    c->line[0] = taut_rationals_new(c->m + 1);
    c->line[1] = taut_rationals_new(c->m + 1);
    c->power = taut_rationals_new((int64_t)(n + 1) * (c->m + 1));
    fmpq_init(c->mu);
    fmpq_init(along);
    length_of(lines->across, c->mu);
    length_of(lines->along, along);
    fmpq_div(c->mu, c->mu, along);
    fmpq_mul(c->mu, c->mu, c->mu);
    fmpq_clear(along);
}

static void chain_free(chain *c)
{
    taut_rationals_free(&c->line[0]);
    taut_rationals_free(&c->line[1]);
    taut_rationals_free(&c->power);
    fmpq_clear(c->mu);
}

static int complete_net(const taut_exact_lines *lines, const taut_exact_memory *memory,
                        taut_exact_net *net)
{
    const int columns = lines->m + 1;
    taut_exact_net made = {.n = lines->n, .m = lines->m};
    taut_rationals all;
    chain c;
    fmpq_t defect;
    int done = 1;

    chain_new(&c, lines, lines->n);
    const int none = survey_lines(&c, lines, &made);
    if (made.defect > 0 && lines->even == 3) {
        made.moved = 1;
        made.n++;
        chain_free(&c);
        chain_new(&c, lines, made.n);
    }
    all = taut_rationals_new(INT64_C(3) * (made.n + 1) * columns);
    fmpq_init(defect);
    for (int coordinate = 0; !none && coordinate < 3; coordinate++) {
        read_lines(&c, lines, coordinate);
        if (c.m % 2 == 0 && c.n == c.m) {
            defect_of(&c, lines->from_derivative, defect);
            if (!fmpq_is_zero(defect)) {
                mend_lines(&c, lines, defect, &made);
            }
        }
        run_chain(&c, lines->from_derivative);
        for (int l = 0; l <= c.m; l++) {
            to_bernstein(c.n, columns, c.power.x + l);
        }
        for (int i = 0; i <= c.n; i++) {
            to_bernstein(c.m, 1, c.power.x + i * columns);
            for (int j = 0; j <= c.m; j++) {
                fmpq_set(all.x + 3 * (i * columns + j) + coordinate, c.power.x + i * columns + j);
            }
        }
    }
    if (!none) {
        done = taut_rationals_deliver(made.n, made.m, &all, memory, &made);
    }
    fmpq_clear(defect);
    taut_rationals_free(&all);
    chain_free(&c);
    if (done) {
        *net = made;
    }
    return done;
}

/* (at - lo) / (hi - lo) */
static void share_of(const double range[4], double at, fmpq_t share)
{
    fmpq_t lo, hi;
    fmpq_init(lo);
    fmpq_init(hi);
    taut_rational_set_double(lo, range[0]);
    taut_rational_set_double(hi, range[1]);
    taut_rational_set_double(share, at);
    fmpq_sub(share, share, lo);
    fmpq_sub(hi, hi, lo);
    fmpq_div(share, share, hi);
    fmpq_clear(lo);
    fmpq_clear(hi);
}

/* A line over [s, 1] when `high`, else over [0, s]: the sides of de Casteljau's triangle at s. */
static void cut_line(int d, int64_t stride, const fmpq_t s, int high, fmpq *c)
{
    fmpq_t low, part;
    fmpq_init(low);
    fmpq_init(part);
    fmpq_one(low);
    fmpq_sub(low, low, s);
    for (int step = 1; step <= d; step++) {
        if (high) { /* c[d-step+1 ..] stays, the rest moves up the triangle */
            for (int i = 0; i + step <= d; i++) {
                fmpq_mul(part, s, c + (i + 1) * stride);
                fmpq_mul(c + i * stride, low, c + i * stride);
                fmpq_add(c + i * stride, c + i * stride, part);
            }
        } else {
            for (int i = d; i >= step; i--) {
                fmpq_mul(part, low, c + (i - 1) * stride);
                fmpq_mul(c + i * stride, s, c + i * stride);
                fmpq_add(c + i * stride, c + i * stride, part);
            }
        }
    }
    fmpq_clear(low);
    fmpq_clear(part);
}

/* To [0, to] first, then to [from / to, 1] of that; both shares of the old range. to > from, and to
 * is not 0 unless the new range ends at the old one's beginning, which begins with the other cut.
 */
static void rerange_line(int d, int64_t stride, const fmpq_t from, const fmpq_t to, fmpq *c)
{
    fmpq_t inner, one;
    fmpq_init(inner);
    fmpq_init(one);
    fmpq_one(one);
    if (!fmpq_is_zero(to)) {
        cut_line(d, stride, to, 0, c);
        fmpq_div(inner, from, to);
        cut_line(d, stride, inner, 1, c);
    } else { /* [from, 1], then the share (0 - from) / (1 - from) of it */
        cut_line(d, stride, from, 1, c);
        fmpq_sub(one, one, from);
        fmpq_div(inner, from, one);
        fmpq_neg(inner, inner);
        cut_line(d, stride, inner, 0, c);
    }
    fmpq_clear(inner);
    fmpq_clear(one);
}

static int rerange_net(int n, int m, const taut_exact_numbers *net, int along_v,
                       const double range[4], const taut_exact_memory *memory, taut_exact_net *out)
{
    const int64_t count = INT64_C(3) * (n + 1) * (m + 1), row = INT64_C(3) * (m + 1);
    taut_exact_net made = {.n = n, .m = m};
    taut_rationals all = taut_rationals_new(count);
    fmpq_t from, to;
    int done = 0;

    fmpq_init(from);
    fmpq_init(to);
    share_of(range, range[2], from);
    share_of(range, range[3], to);
    for (int64_t i = 0; i < count; i++) {
        taut_rational_set(all.x + i, net, (size_t)i);
    }
    if (along_v) {
        for (int i = 0; i <= n; i++) {
            for (int c = 0; c < 3; c++) {
                rerange_line(m, 3, from, to, all.x + i * row + c);
            }
        }
    } else {
        for (int64_t c = 0; c < row; c++) {
            rerange_line(n, row, from, to, all.x + c);
        }
    }
    done = taut_rationals_deliver(n, m, &all, memory, &made);
    fmpq_clear(from);
    fmpq_clear(to);
    taut_rationals_free(&all);
    if (done) {
        *out = made;
    }
    return done;
}

/* sum += w f net[at], f and at of relation (2) at index i of degree d. */
static void add_second(int d, int i, int64_t stride, const fmpq_t weight, const fmpq *at,
                       fmpq_t sum)
{
    const int64_t a0 = (int64_t)(d - i) * (d - i - 1), a1 = INT64_C(2) * i * (d - i),
                  a2 = (int64_t)i * (i - 1);
    const int64_t f[5] = {a2, a1 - 2 * a2, a0 - 2 * a1 + a2, a1 - 2 * a0, a0};
    fmpq_t term, factor;
    fmpq_init(term);
    fmpq_init(factor);
    for (int s = -2; s <= 2; s++) {
        if (f[s + 2] != 0 && i + s >= 0 && i + s <= d) {
            fmpq_set_si(factor, f[s + 2], 1);
            fmpq_mul(term, weight, factor);
            fmpq_mul(term, term, at + s * stride);
            fmpq_add(sum, sum, term);
        }
    }
    fmpq_clear(term);
    fmpq_clear(factor);
}

static int find_residual(int n, int m, const taut_exact_numbers *net, const double rectangle[4],
                         double *largest)
{
    const int64_t count = INT64_C(3) * (n + 1) * (m + 1), row = INT64_C(3) * (m + 1);
    taut_rationals all = taut_rationals_new(count);
    fmpq_t weight[2], sum, most;

    fmpq_init(sum);
    fmpq_init(most);
    for (int d = 0; d < 2; d++) {
        fmpq_init(weight[d]);
        length_of(rectangle + 2 * d, weight[d]);
        fmpq_mul(weight[d], weight[d], weight[d]);
        fmpq_inv(weight[d], weight[d]);
    }
    for (int64_t i = 0; i < count; i++) {
        taut_rational_set(all.x + i, net, (size_t)i);
    }
    for (int64_t at = 0; at < count; at++) {
        fmpq_zero(sum);
        add_second(n, (int)(at / row), row, weight[0], all.x + at, sum);
        add_second(m, (int)(at % row / 3), 3, weight[1], all.x + at, sum);
        fmpq_abs(sum, sum);
        if (fmpq_cmp(sum, most) > 0) {
            fmpq_swap(sum, most);
        }
    }
    *largest = fmpq_is_zero(most) ? 0 : fmax(taut_rational_nearest(most), 0x1p-1000);
    for (int d = 0; d < 2; d++) {
        fmpq_clear(weight[d]);
    }
    fmpq_clear(sum);
    fmpq_clear(most);
    taut_rationals_free(&all);
    return 1;
}

extern TAUT_API const taut_exact_ops taut_module_table;
const taut_exact_ops taut_module_table = {
    .size = sizeof(taut_exact_ops),
    .complete = complete_net,
    .rerange = rerange_net,
    .residual = find_residual,
};
