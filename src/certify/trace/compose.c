/* compose.c
 *
 * Polynomials in t are kept as Bernstein coefficients times their binomials: then products are convolutions.
 *
 *     a = (u - lo)/(hi - lo), b = (v - ...)/...            in the cell that the middle of the span lies in
 *     A_i = C(p, i) a^i (1 - a)^(p - i),  B_j likewise
 *     N = sum_i A_i (sum_j S_ij B_j)
 *
 * All terms of A_i and B_j are positive where c stays in its cell, so that rounding is a few hundred units of the
 * largest coefficient ([Higham2002] section 3.1). A span whose control points leave the cell is halved.
 */
#include "certify/trace/compose.h"

#include "certify/common/bernstein.h"
#include "core/constants.h"

#include <math.h>
#include <string.h>

enum { QUINTIC = TAUT_NET_QUINTIC, DEPTH = 6, SIDE = TAUT_NET_COMPOSE_ROOM / QUINTIC };
/* Over the width of a cell: so far beyond its border a control point may lie by rounding. */
static const double beyond = 1e-12;
/* Roundings of one coefficient, of the largest. */
static const double roundings = 0x1p-42;

typedef taut_net_compose_row row;

struct taut_net_composer {
    taut_net_cells *cells;
    row *powers;    /* [2][SIDE + 1]: of a and 1 - a */
    row *basis;     /* [2][SIDE + 1]: A, B */
    row *sums;      /* [4]: N */
    double *choose; /* binomials of the degree at hand */
};

taut_status taut_net_composer_new(taut_arena *arena, taut_net_cells *cells,
                                  taut_net_composer **made)
{
    taut_net_composer *composer = taut_arena_take(arena, 1, sizeof *composer);
    row *rows = taut_arena_take(arena, 4 * ((size_t)SIDE + 1) + 5, sizeof *rows);
    if (composer == NULL || rows == NULL) {
        return TAUT_NO_MEMORY;
    }
    *composer = (taut_net_composer){.cells = cells,
                                    .powers = rows,
                                    .basis = rows + 2 * (SIDE + 1),
                                    .sums = rows + 4 * (SIDE + 1),
                                    .choose = rows[4 * (SIDE + 1) + 4]};
    *made = composer;
    return TAUT_OK;
}

/* C(n, k), each of the one before; a rounding or two of each are counted. */
static void fill_binomials(int n, double *binomials)
{
    binomials[0] = binomials[n] = 1;
    for (int k = 1; k <= n / 2; k++) {
        binomials[k] = binomials[n - k] = binomials[k - 1] * (n - k + 1) / k;
    }
}

/* Coefficients of that degree are 0. */
static void clear(int degree, double *coefficients)
{
    memset(coefficients, 0, ((size_t)degree + 1) * sizeof *coefficients);
}

/* out += s f g, of degree p + q. */
static void add_product(double s, int p, const double *restrict f, int q, const double *restrict g,
                        double *restrict out)
{
    for (int i = 0; i <= p; i++) {
        const double factor = s * f[i];
        for (int j = 0; j <= q; j++) {
            out[i + j] += factor * g[j];
        }
    }
}

/* basis[k] = C(p, k) a^k (1 - a)^(p - k), a by its scaled coefficients, of degree 5 p. */
static void compose_basis(int p, const double a[QUINTIC + 1], row *up, row *down, row *basis)
{
    static const double binomials[QUINTIC + 1] = {1, 5, 10, 10, 5, 1};
    double rest[QUINTIC + 1];

    for (int k = 0; k <= QUINTIC; k++) {
        rest[k] = binomials[k] - a[k];
    }
    up[0][0] = down[0][0] = 1;
    for (int k = 1; k <= p; k++) {
        clear(QUINTIC * k, up[k]);
        clear(QUINTIC * k, down[k]);
        add_product(1, QUINTIC * (k - 1), up[k - 1], QUINTIC, a, up[k]);
        add_product(1, QUINTIC * (k - 1), down[k - 1], QUINTIC, rest, down[k]);
    }
    for (int k = 0; k <= p; k++) {
        clear(QUINTIC * p, basis[k]);
        add_product(taut_certify_binomial(p, k), QUINTIC * k, up[k], QUINTIC * (p - k), down[p - k],
                    basis[k]);
    }
}

static void compose_coordinate(taut_net_composer *w, const taut_field *x, double *out)
{
    w->cells->ops->compose(x->p, x->q, x->a, (const taut_net_compose_row *)w->basis,
                           (const taut_net_compose_row *)w->basis + SIDE + 1, out);
}

/* A part of a span: control points in the window, and in space about the origin. */
typedef struct part {
    double window[QUINTIC + 1][2];
    double space[QUINTIC + 1][3];
} part;

static double distance_in(taut_net_composer *w, const taut_net_cell *one, const part *p)
{
    static const double binomials[QUINTIC + 1] = {1, 5, 10, 10, 5, 1};
    const int degree[2] = {one->x[0].p, one->x[0].q};
    const int is_rational = one->x[3].p > 0 || one->x[3].q > 0;
    const int n = QUINTIC * (degree[0] + degree[1]), whole = is_rational ? n + QUINTIC : n;
    double rough = 0, longest = 0, least = 1;
    row raise;

    for (int d = 0; d < 2; d++) {
        double a[QUINTIC + 1];
        for (int k = 0; k <= QUINTIC; k++) {
            a[k] = (p->window[k][d] - one->lo[d]) / one->width[d] * binomials[k];
            rough = fmax(rough, 4 * TAUT_UNIT_ROUNDOFF * fabs(p->window[k][d]) / one->width[d]);
        }
        compose_basis(degree[d], a, w->powers, w->powers + SIDE + 1, w->basis + d * (SIDE + 1));
    }
    if (is_rational) {
        compose_coordinate(w, &one->x[3], w->sums[3]);
        fill_binomials(n, w->choose);
        least = INFINITY;
        for (int k = 0; k <= n; k++) {
            least = fmin(least, w->sums[3][k] / w->choose[k]);
        }
    }
    fill_binomials(whole, w->choose);
    if (!(least > 0) || whole < QUINTIC) {
        return INFINITY;
    }
    fill_binomials(is_rational ? QUINTIC : n - QUINTIC, raise);
    row *difference = w->powers; /* done with */
    for (int c = 0; c < 3; c++) {
        double scaled[QUINTIC + 1];
        for (int k = 0; k <= QUINTIC; k++) {
            scaled[k] = p->space[k][c] * binomials[k];
        }
        compose_coordinate(w, &one->x[c], w->sums[c]);
        clear(whole, difference[c]);
        if (is_rational) {
            add_product(1, QUINTIC, scaled, n, w->sums[3], difference[c]);
            add_product(-1, n, w->sums[c], QUINTIC, raise, difference[c]);
        } else {
            add_product(1, QUINTIC, scaled, n - QUINTIC, raise, difference[c]);
            add_product(-1, n, w->sums[c], 0, binomials, difference[c]);
        }
    }
    for (int k = 0; k <= whole; k++) {
        const double e[3] = {difference[0][k], difference[1][k], difference[2][k]};
        longest = fmax(longest, sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) / w->choose[k]);
    }
    /* rounding of coefficients, of the cell's, and of the place in it: |dS| <= 2 degree largest */
    const double moved = 2 * (degree[0] + degree[1]) * (rough + beyond);
    return (longest + 2 * one->error + (roundings + 2 * moved) * (one->largest + 1)) / least;
}

/* Where the middle of a quintic lies. */
static void middle_of(const part *p, double at[2])
{
    for (int d = 0; d < 2; d++) {
        at[d] = (p->window[0][d] + 5 * p->window[1][d] + 10 * p->window[2][d] +
                 10 * p->window[3][d] + 5 * p->window[4][d] + p->window[5][d]) /
                32;
    }
}

static int is_inside(const taut_net_cell *one, const part *p)
{
    for (int k = 0; k <= QUINTIC; k++) {
        for (int d = 0; d < 2; d++) {
            const double room = beyond * one->width[d], away = p->window[k][d] - one->lo[d];
            if (!(away >= -room) || !(away <= one->width[d] + room)) {
                return 0;
            }
        }
    }
    return 1;
}

static double distance_of(taut_net_composer *w, int on, const part *p, int depth)
{
    part low, high;
    double at[2];

    middle_of(p, at);
    const taut_net_cell *one = taut_net_cell_at(w->cells, on, at);
    if (one == NULL) {
        return INFINITY;
    }
    if (is_inside(one, p)) {
        return distance_in(w, one, p);
    }
    if (depth == 0) {
        return INFINITY;
    }
    high = *p;
    taut_certify_halve(QUINTIC, 2, high.window[0], low.window[0], high.window[0]);
    taut_certify_halve(QUINTIC, 3, high.space[0], low.space[0], high.space[0]);
    const double first = distance_of(w, on, &low, depth - 1);
    return isinf(first) ? first : fmax(first, distance_of(w, on, &high, depth - 1));
}

double taut_net_compose_distance(taut_net_composer *composer, const taut_net_span *span)
{
    part p;

    memcpy(p.window, span->window, sizeof p.window);
    for (int k = 0; k <= QUINTIC; k++) {
        for (int c = 0; c < 3; c++) {
            p.space[k][c] = span->space[k][c] - composer->cells->origin[c];
        }
    }
    return distance_of(composer, span->on, &p, DEPTH);
}
