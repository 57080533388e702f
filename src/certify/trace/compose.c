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

#include "basis/basis_ops.h"
#include "certify/common/bernstein.h"
#include "certify/common/field.h"
#include "core/constants.h"

#include <math.h>
#include <string.h>

enum { QUINTIC = 5, DEPTH = 6, MOST = TAUT_NET_COMPOSE_DEGREE + QUINTIC, SIDE = MOST / QUINTIC };
/* Over the width of a cell: so far beyond its border a control point may lie by rounding. */
static const double beyond = 1e-12;
/* Roundings of one coefficient, of the largest. */
static const double roundings = 0x1p-42;

/* A cell as Bernstein coefficients of X, Y, Z, w. */
typedef struct cell {
    int state; /* 0 not looked at, 1 known, -1 none */
    taut_field x[4];
    double lo[2], width[2];
    double error;   /* of a coefficient of X, Y, Z */
    double largest; /* of X, Y, Z */
} cell;

typedef double row[MOST + 1];

struct taut_net_cells {
    taut_arena *arena;
    const taut_surface *const *surfaces;
    double origin[3];
    cell **cells; /* of each surface */
    row *powers;  /* [2][SIDE + 1]: of a and 1 - a */
    row *basis;   /* [2][SIDE + 1]: A, B */
    row *sums;    /* [5]: N, and what is summed up before */
    row choose;   /* binomials of the degree at hand */
};

taut_status taut_net_cells_new(taut_arena *arena, int count, const taut_surface *const *surfaces,
                               taut_net_cells **made)
{
    taut_net_cells *cells = taut_arena_take(arena, 1, sizeof *cells);
    if (cells == NULL) {
        return TAUT_NO_MEMORY;
    }
    cells->arena = arena;
    cells->surfaces = surfaces;
    memcpy(cells->origin, taut_surface_points(surfaces[0]), sizeof cells->origin);
    cells->cells = taut_arena_take(arena, (size_t)count, sizeof *cells->cells);
    cells->powers = taut_arena_take(arena, 2 * ((size_t)SIDE + 1), sizeof *cells->powers);
    cells->basis = taut_arena_take(arena, 2 * ((size_t)SIDE + 1), sizeof *cells->basis);
    cells->sums = taut_arena_take(arena, 5, sizeof *cells->sums);
    for (int k = 0; taut_arena_status(arena) == TAUT_OK && k < count; k++) {
        const size_t spans = (size_t)taut_basis_span_count(taut_surface_u(surfaces[k])) *
                             (size_t)taut_basis_span_count(taut_surface_v(surfaces[k]));
        cells->cells[k] = taut_arena_take(arena, spans, sizeof(cell));
    }
    *made = cells;
    return taut_arena_status(arena);
}

/* The cell of a place; NULL where it is no polynomial of a degree that is small enough. */
static const cell *cell_at(taut_net_cells *cells, int on, const double at[2])
{
    const taut_surface *surface = cells->surfaces[on];
    const taut_basis *basis[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const int span[2] = {taut_basis_span(basis[0], at[0]), taut_basis_span(basis[1], at[1])};
    cell *one = &cells->cells[on][span[0] * taut_basis_span_count(basis[1]) + span[1]];

    if (one->state == 0) {
        one->state = -1;
        if (taut_field_of_surface(cells->arena, surface, span[0], span[1], cells->origin, 0, one->x,
                                  one->width) &&
            one->x[3].a != NULL && QUINTIC * (one->x[0].p + one->x[0].q) <= MOST - QUINTIC) {
            one->state = 1;
            for (int d = 0; d < 2; d++) {
                one->lo[d] = taut_basis_breaks(basis[d])[span[d]];
            }
            for (int c = 0; c < 4; c++) {
                const int count = (one->x[c].p + 1) * (one->x[c].q + 1);
                for (int k = 0; k < count; k++) {
                    one->error = fmax(one->error, one->x[c].e[k]);
                    one->largest = fmax(one->largest, fabs(one->x[c].a[k]));
                }
            }
        }
    }
    return one->state == 1 ? one : NULL;
}

/* C(n, k), each of the one before; a rounding or two of each are counted. */
static void fill_binomials(int n, double *binomials)
{
    binomials[0] = binomials[n] = 1;
    for (int k = 1; k <= n / 2; k++) {
        binomials[k] = binomials[n - k] = binomials[k - 1] * (n - k + 1) / k;
    }
}

/* out += s f g, of degree p + q. */
static void add_product(double s, int p, const double *f, int q, const double *g, double *out)
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
        memset(up[k], 0, sizeof up[k]);
        memset(down[k], 0, sizeof down[k]);
        add_product(1, QUINTIC * (k - 1), up[k - 1], QUINTIC, a, up[k]);
        add_product(1, QUINTIC * (k - 1), down[k - 1], QUINTIC, rest, down[k]);
    }
    for (int k = 0; k <= p; k++) {
        memset(basis[k], 0, sizeof basis[k]);
        add_product(taut_certify_binomial(p, k), QUINTIC * k, up[k], QUINTIC * (p - k), down[p - k],
                    basis[k]);
    }
}

/* sums[c] = x[c] of the cell at c(t), of degree 5 (p + q). */
static void compose_coordinate(taut_net_cells *w, const taut_field *x, double *out)
{
    row *inner = &w->sums[4];
    row *first = w->basis, *second = w->basis + SIDE + 1;

    memset(out, 0, sizeof(row));
    for (int i = 0; i <= x->p; i++) {
        memset(*inner, 0, sizeof *inner);
        for (int j = 0; j <= x->q; j++) {
            const double factor = x->a[i * (x->q + 1) + j];
            for (int k = 0; k <= QUINTIC * x->q; k++) {
                (*inner)[k] += factor * second[j][k];
            }
        }
        add_product(1, QUINTIC * x->p, first[i], QUINTIC * x->q, *inner, out);
    }
}

/* A part of a span: control points in the window, and in space about the origin. */
typedef struct part {
    double window[QUINTIC + 1][2];
    double space[QUINTIC + 1][3];
} part;

static double distance_in(taut_net_cells *w, const cell *one, const part *p)
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
        memset(difference[c], 0, sizeof difference[c]);
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

static int is_inside(const cell *one, const part *p)
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

static double distance_of(taut_net_cells *w, int on, const part *p, int depth)
{
    part low, high;
    double at[2];

    middle_of(p, at);
    const cell *one = cell_at(w, on, at);
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

/* The span of a basis from one break to the next, or -1. */
static int span_between(const taut_basis *basis, double from, double to)
{
    const double *breaks = taut_basis_breaks(basis);
    const int span = taut_basis_span(basis, from);
    return breaks[span] == from && breaks[span + 1] == to ? span : -1;
}

/* The Bernstein coefficients of a span, [6][3]: the blossom at so many times its ends ([PieglTiller1997] 5.2). */
static void bezier_of(const taut_curve *curve, int span, double from, double to,
                      double points[QUINTIC + 1][3])
{
    const taut_basis *basis = taut_curve_t(curve);
    const int first = taut_basis_first(basis, span);
    const double *knots = basis->knots + first;

    for (int i = 0; i <= QUINTIC; i++) {
        double work[QUINTIC + 1][3];
        memcpy(work, taut_curve_points(curve) + 3 * first, sizeof work);
        for (int level = 1; level <= QUINTIC; level++) {
            const double at = level <= i ? to : from;
            for (int k = 0; k <= QUINTIC - level; k++) {
                const double low = knots[k + level], high = knots[k + QUINTIC + 1];
                const double share = (at - low) / (high - low), rest = (high - at) / (high - low);
                for (int c = 0; c < 3; c++) {
                    work[k][c] = rest * work[k][c] + share * work[k + 1][c];
                }
            }
        }
        memcpy(points[i], work[0], sizeof work[0]);
    }
}

/* Span i of a stretch of the window. */
static double span_distance(taut_net_cells *w, const taut_net_line *line, int stretch, int i,
                            int unit)
{
    const taut_curve *window = line->window[stretch];
    const double *breaks = taut_basis_breaks(taut_curve_t(window));
    const int span = span_between(taut_curve_t(line->space), breaks[i], breaks[i + 1]);
    const double scale = ldexp(1, -unit);
    double place[QUINTIC + 1][3];
    part p;

    if (span < 0) {
        return INFINITY;
    }
    bezier_of(window, i, breaks[i], breaks[i + 1], place);
    bezier_of(line->space, span, breaks[i], breaks[i + 1], p.space);
    for (int k = 0; k <= QUINTIC; k++) {
        memcpy(p.window[k], place[k], sizeof p.window[k]);
        for (int c = 0; c < 3; c++) {
            p.space[k][c] = scale * p.space[k][c] - w->origin[c];
        }
    }
    return distance_of(w, line->on[stretch], &p, DEPTH);
}

/* Quintic B-splines both, as a net's curves are. */
static int are_quintic(const taut_net_line *line)
{
    const taut_basis *space = taut_curve_t(line->space);
    int are = line->count > 0 && strcmp(taut_basis_type(space), "bspline") == 0 &&
              taut_basis_local(space) == QUINTIC + 1 && taut_curve_weights(line->space) == NULL;
    for (int k = 0; are && k < line->count; k++) { /* certify/common/of.h: B-splines of degree 5 */
        are = taut_basis_local(taut_curve_t(line->window[k])) == QUINTIC + 1;
    }
    return are;
}

double taut_net_compose_distance(taut_net_cells *cells, const taut_net_line *line, int unit)
{
    double most = 0;
    if (!are_quintic(line)) {
        return INFINITY;
    }
    for (int stretch = 0; stretch < line->count; stretch++) {
        const int spans = taut_basis_span_count(taut_curve_t(line->window[stretch]));
        for (int i = 0; i < spans; i++) {
            const double here = span_distance(cells, line, stretch, i, unit);
            if (!(here < INFINITY)) {
                return INFINITY;
            }
            most = fmax(most, here);
        }
    }
    return most;
}
