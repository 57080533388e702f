/* merged.c -- p and q are h cut in two ([NiWang2015] section 2.7): with t the share of h that the
 * lower piece has, column by column,
 *
 *     h[0][i] = h[i],  h[k][i] = (1-t) h[k-1][i] + t h[k-1][i+1]
 *     lower[k] = h[k][0],  upper[k] = h[n-k][k]
 */
#include "certify/harmonic/merged.h"

#include "certify/common/verdict.h"
#include "certify/harmonic/residual.h"
#include "core/constants.h"
#include "core/twice.h"
#include "taut/limits.h"

#include <math.h>
#include <string.h>

/* The three nets, turned such that lines run along the edge. */
typedef struct task {
    const taut_surface *lower, *upper, *whole;
    int across_v, n, m;
    int unit;
    taut_twice t, rest; /* shares of the lower and the upper piece */
} task;

static const taut_basis *across_of(const taut_surface *s, int across_v)
{
    return across_v ? taut_surface_v(s) : taut_surface_u(s);
}

static const taut_basis *along_of(const taut_surface *s, int across_v)
{
    return across_v ? taut_surface_u(s) : taut_surface_v(s);
}

/* Are these two pieces of one rectangle? */
static int is_cut(const task *k)
{
    const taut_basis *low = across_of(k->lower, k->across_v);
    const taut_basis *high = across_of(k->upper, k->across_v);
    const taut_basis *whole = across_of(k->whole, k->across_v);
    const taut_basis *along = along_of(k->whole, k->across_v);
    return taut_basis_degree(low) == k->n && taut_basis_degree(high) == k->n &&
           taut_basis_degree(whole) == k->n && taut_basis_lo(low) == taut_basis_lo(whole) &&
           taut_basis_hi(low) == taut_basis_lo(high) &&
           taut_basis_hi(high) == taut_basis_hi(whole) &&
           taut_basis_equal(along, along_of(k->lower, k->across_v)) &&
           taut_basis_equal(along, along_of(k->upper, k->across_v));
}

static const double *point_of(const task *k, const taut_surface *s, int i, int j)
{
    const int columns = taut_basis_count(taut_surface_v(s));
    return taut_surface_points(s) + 3 * (k->across_v ? j * columns + i : i * columns + j);
}

static double coordinate(const task *k, const taut_surface *s, int i, int j, int c)
{
    return ldexp(point_of(k, s, i, j)[c], -k->unit);
}

/* The largest distances of a column of both pieces from those of h. */
static void compare_column(const task *k, int j, int c, double apart[2])
{
    taut_twice column[TAUT_DEGREE_MAX + 1];

    for (int i = 0; i <= k->n; i++) {
        column[i] = taut_twice_of(coordinate(k, k->whole, i, j, c));
    }
    for (int step = 0; step <= k->n; step++) {
        const int last = k->n - step;
        const taut_twice low =
            taut_twice_less(column[0], taut_twice_of(coordinate(k, k->lower, step, j, c)));
        const taut_twice high =
            taut_twice_less(column[last], taut_twice_of(coordinate(k, k->upper, last, j, c)));
        apart[0] = taut_certify_max(apart[0], fabs(taut_twice_round(low)));
        apart[1] = taut_certify_max(apart[1], fabs(taut_twice_round(high)));
        for (int i = 0; i < last; i++) {
            column[i] = taut_twice_add(taut_twice_times(k->rest, column[i]),
                                       taut_twice_times(k->t, column[i + 1]));
        }
    }
}

/* The largest number met when a piece is carried on over the whole, about its rounding. */
static double carried_of(const task *k, const taut_surface *piece, double share)
{
    double column[TAUT_DEGREE_MAX + 1], most = 0;
    const int is_lower = piece == k->lower;

    for (int j = 0; j <= k->m; j++) {
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i <= k->n; i++) {
                column[i] = coordinate(k, piece, is_lower ? i : k->n - i, j, c);
                most = taut_certify_max(most, fabs(column[i]));
            }
            for (int last = k->n; last > 0; last--) {
                for (int i = 0; i < last; i++) {
                    column[i] += (column[i + 1] - column[i]) / share;
                    most = taut_certify_max(most, fabs(column[i]));
                }
            }
        }
    }
    return most;
}

static double size_of(const task *k, const taut_surface *s)
{
    double reach = 0;
    const size_t count = (size_t)(k->n + 1) * (size_t)(k->m + 1);
    return ldexp(taut_certify_extent(taut_surface_points(s), NULL, count, &reach), -k->unit);
}

static void begin(const taut_surface *p, const taut_surface *q, const taut_surface *h,
                  taut_edge edge, task *k)
{
    const int p_is_lower = edge == TAUT_EDGE_U1 || edge == TAUT_EDGE_V1;
    double reach = 0;

    k->lower = p_is_lower ? p : q;
    k->upper = p_is_lower ? q : p;
    k->whole = h;
    k->across_v = edge == TAUT_EDGE_V0 || edge == TAUT_EDGE_V1;
    k->n = taut_basis_degree(across_of(p, k->across_v));
    k->m = taut_basis_degree(along_of(p, k->across_v));
    (void)taut_certify_extent(taut_surface_points(h), NULL,
                              (size_t)taut_basis_count(taut_surface_u(h)) *
                                  (size_t)taut_basis_count(taut_surface_v(h)),
                              &reach);
    k->unit = reach > 0 && isfinite(reach) ? ilogb(reach) : 0;
}

static void fill_shares(task *k)
{
    const taut_basis *whole = across_of(k->whole, k->across_v);
    const double lo = taut_basis_lo(whole), hi = taut_basis_hi(whole);
    const double middle = taut_basis_hi(across_of(k->lower, k->across_v));
    const taut_twice width = taut_twice_sum(hi, -lo);
    k->t = taut_twice_over(taut_twice_sum(middle, -lo), width);
    k->rest = taut_twice_over(taut_twice_sum(hi, -middle), width);
}

taut_merged taut_merged_of(const taut_surface *p, const taut_surface *q, const taut_surface *h,
                           taut_edge edge)
{
    taut_merged merged = {1, 0, "ranges"};
    double apart[2] = {0, 0}, most = 0;
    task k;

    begin(p, q, h, edge, &k);
    if (!is_cut(&k)) {
        return merged;
    }
    fill_shares(&k);
    most = carried_of(&k, p, taut_twice_round(p == k.lower ? k.t : k.rest));
    for (int j = 0; j <= k.m; j++) {
        for (int c = 0; c < 3; c++) {
            compare_column(&k, j, c, apart);
        }
    }
    for (int side = 0; side < 2; side++) {
        const taut_surface *piece = side == 0 ? k.lower : k.upper;
        const double size = size_of(&k, piece), noise = 4 * (k.n + 1) * TAUT_UNIT_ROUNDOFF * most;
        const double residual = apart[side] == 0 ? 0 : apart[side] / size;
        if (side == 0 || !(residual * merged.limit <= merged.residual * noise / size)) {
            merged = (taut_merged){residual, size > 0 ? noise / size : 0, taut_surface_name(piece)};
        }
    }
    return merged;
}

double taut_merged_carried(const taut_surface *p, const taut_surface *q, taut_edge edge)
{
    const int across_v = edge == TAUT_EDGE_V0 || edge == TAUT_EDGE_V1;
    const taut_basis *old = across_of(p, across_v), *beyond = across_of(q, across_v);
    const double from = taut_basis_hi(old) - taut_basis_lo(old);
    const double width = taut_basis_hi(beyond) - taut_basis_lo(beyond);
    task k;

    begin(p, q, p, edge, &k);
    return ldexp(carried_of(&k, p, from / (from + width)), k.unit);
}
