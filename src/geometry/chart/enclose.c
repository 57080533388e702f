#include "geometry/chart/enclose.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <string.h>

enum {
    D = TAUT_ENCLOSE_DEGREE,
    ORDERS = 3,
    QUASI = 5 /* degree through places of c- and h- functions */
};
/* Of the largest value: what evaluation, elimination and sums may be off by, some thousand roundings. */
static const double rounding = 1e-12;

/* The functions alive on a span, and their derivatives by the parameter, over a part of it. */
typedef struct patch {
    int degree, local, first;
    double c[ORDERS][D + 1][D + 1]; /* [order][function][coefficient] */
    double off[ORDERS];
} patch;

/* Bernstein coefficients of what has the values `rows` at Chebyshev's places, by elimination: the matrix is totally positive. */
static void solve(int degree, const double *places, int count, double rows[D + 1][ORDERS * (D + 1)])
{
    double a[D + 1][D + 1];
    for (int i = 0; i <= degree; i++) {
        double choose = 1;
        for (int k = 0; k <= degree; k++) {
            a[i][k] = choose;
            for (int p = 0; p < degree; p++) {
                a[i][k] *= p < k ? places[i] : 1 - places[i];
            }
            choose = choose * (degree - k) / (k + 1);
        }
    }
    for (int i = 0; i <= degree; i++) {
        for (int k = i + 1; k <= degree; k++) {
            const double share = a[k][i] / a[i][i];
            for (int c = i; c <= degree; c++) {
                a[k][c] -= share * a[i][c];
            }
            for (int r = 0; r < count; r++) {
                rows[k][r] -= share * rows[i][r];
            }
        }
    }
    for (int i = degree; i >= 0; i--) {
        for (int r = 0; r < count; r++) {
            for (int c = i + 1; c <= degree; c++) {
                rows[i][r] -= a[i][c] * rows[c][r];
            }
            rows[i][r] /= a[i][i];
        }
    }
}

/* What the second derivative of c- and h- functions over the part is at most, of the one where it is most; each further one is so many
 * times `rate`. f'' is a cos + b sin, or a cosh + b sinh, of rate (t - middle), a = f'' and b = f'''/rate there. */
static double bend_of(const taut_basis *basis, int span, double a, double b, double *rate)
{
    const int is_round = taut_basis_type(basis)[0] == 'c';
    const double *breaks = taut_basis_breaks(basis), width = breaks[span + 1] - breaks[span];
    const int local = taut_basis_local(basis);
    double values[4][D + 1], most = 0;
    taut_basis_spec spec;
    taut_basis_spec_of(basis, &spec);
    *rate = (is_round ? spec.alpha : spec.beta) / width;
    (void)taut_basis_eval(basis, span, a + (b - a) / 2, 3, values[0]);
    for (int k = 0; k < local; k++) {
        const double *flat = values[0];
        const double second = fabs(flat[2 * local + k]), third = fabs(flat[3 * local + k]) / *rate;
        most = fmax(most, is_round ? taut_hypot(second, third)
                                   : (second + third) * taut_exp(*rate * (b - a) / 2));
    }
    return most;
}

static int patch_of(const taut_basis *basis, int span, double a, double b, patch *out)
{
    const int degree = taut_basis_degree(basis) >= 0 ? taut_basis_degree(basis) : QUASI;
    const int local = taut_basis_local(basis);
    double places[D + 1], rows[D + 1][ORDERS * (D + 1)], rate = 1;
    if (degree > D || local > D + 1) {
        return 0;
    }
    for (int i = 0; i <= degree; i++) {
        places[i] = (1 - taut_cos((2 * i + 1) * TAUT_PI / (2 * (degree + 1)))) / 2;
        if (taut_basis_eval(basis, span, a + (b - a) * places[i], ORDERS - 1, rows[i]) != TAUT_OK) {
            return 0;
        }
    }
    solve(degree, places, ORDERS * local, rows);
    out->degree = degree;
    out->local = local;
    out->first = taut_basis_first(basis, span);
    double off = 0; /* f^(n)/n! prod abs(x - x_i), which at these places is 2 (h/4)^n/n! f^(n) */
    if (taut_basis_degree(basis) < 0) {
        off = bend_of(basis, span, a, b, &rate);
        for (int i = 1; i <= degree + 1; i++) {
            off *= (b - a) * rate / (4.0 * i);
        }
        off *= 2 / (rate * rate);
    }
    for (int k = 0; k < ORDERS; k++) {
        double most = 0;
        for (int f = 0; f < local; f++) {
            for (int i = 0; i <= degree; i++) {
                out->c[k][f][i] = rows[i][k * local + f];
                most = fmax(most, fabs(out->c[k][f][i]));
            }
        }
        out->off[k] = off + rounding * most;
        off *= rate;
    }
    return 1;
}

static void widen(taut_range *range, double x)
{
    range->lo = fmin(range->lo, x);
    range->hi = fmax(range->hi, x);
}

/* ---- curves ---- */

static void join(int is_first, int count, const taut_range *own, taut_range *all)
{
    for (int k = 0; k < count; k++) {
        all[k] = is_first ? own[k] : taut_range_join(all[k], own[k]);
    }
}

static int curve_on(const taut_curve *curve, int span, double a, double b, taut_range x[3][3])
{
    patch p;
    if (!patch_of(taut_curve_t(curve), span, a, b, &p)) {
        return 0;
    }
    const double *points = taut_curve_points(curve) + 3 * p.first;
    for (int k = 0; k < ORDERS; k++) {
        for (int c = 0; c < 3; c++) {
            double size = 0;
            taut_range range = {INFINITY, -INFINITY};
            for (int i = 0; i <= p.degree; i++) {
                double sum = 0;
                for (int f = 0; f < p.local; f++) {
                    sum += p.c[k][f][i] * points[3 * f + c];
                }
                widen(&range, sum);
            }
            for (int f = 0; f < p.local; f++) {
                size += fabs(points[3 * f + c]);
            }
            x[k][c] = (taut_range){range.lo - p.off[k] * size, range.hi + p.off[k] * size};
        }
    }
    return 1;
}

/* Spans that a part has to do with. */
static void spans_of(const taut_basis *basis, double a, double b, int spans[2])
{
    const double *breaks = taut_basis_breaks(basis);
    spans[0] = taut_basis_span(basis, a);
    spans[1] = taut_basis_span(basis, b);
    if (spans[1] > spans[0] && breaks[spans[1]] >= b) { /* it ends where that one begins */
        spans[1]--;
    }
}

int taut_enclose_curve(const taut_curve *curve, double a, double b, taut_range x[3][3])
{
    const taut_basis *basis = taut_curve_t(curve);
    const double *breaks = taut_basis_breaks(basis);
    int spans[2], is_known = taut_curve_weights(curve) == NULL;
    spans_of(basis, a, b, spans);
    for (int i = spans[0]; is_known && i <= spans[1]; i++) {
        taut_range own[3][3];
        is_known = curve_on(curve, i, fmax(a, breaks[i]), fmin(b, breaks[i + 1]), own);
        join(i == spans[0], 9, own[0], x[0]);
    }
    return is_known;
}

/* ---- surfaces ---- */

/* Orders by u and v of the six vectors. */
static const int orders[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};

/* The net of a span about a place, times weights: [u][v] of x, y, z and w. */
typedef struct local_net {
    double p[D + 1][D + 1][4];
    double about[3], size[4];
} local_net;

static void net_of(const taut_surface *surface, const double frame[3][3], const patch *u,
                   const patch *v, local_net *net)
{
    const int nv = taut_basis_count(taut_surface_v(surface));
    const double *points = taut_surface_points(surface), *weights = taut_surface_weights(surface);
    const size_t first =
        (size_t)(u->first + u->local / 2) * (size_t)nv + (size_t)(v->first + v->local / 2);
    memcpy(net->about, points + 3 * first, sizeof net->about);
    memset(net->size, 0, sizeof net->size);
    for (int i = 0; i < u->local; i++) {
        for (int k = 0; k < v->local; k++) {
            const size_t at = (size_t)(u->first + i) * (size_t)nv + (size_t)(v->first + k);
            const double w = weights != NULL ? weights[at] : 1;
            double to[3], *p = net->p[i][k];
            for (int c = 0; c < 3; c++) {
                to[c] = points[3 * at + (size_t)c] - net->about[c];
            }
            for (int c = 0; c < 4; c++) {
                p[c] = c == 3 ? w : w * (frame != NULL ? taut_dot(frame[c], to) : to[c]);
                net->size[c] += fabs(p[c]);
            }
        }
    }
}

/* One of the six, of all four coordinates. */
static void combine(const patch *u, const patch *v, const local_net *net, const int order[2],
                    taut_range out[4])
{
    double rows[D + 1][D + 1][4]; /* [function of u][coefficient of v] */
    double most[2] = {0, 0};
    memset(rows, 0, sizeof rows);
    for (int i = 0; i < u->local; i++) {
        for (int k = 0; k < v->local; k++) {
            for (int n = 0; n <= v->degree; n++) {
                const double f = v->c[order[1]][k][n];
                most[1] = fmax(most[1], fabs(f));
                for (int c = 0; c < 4; c++) {
                    rows[i][n][c] += f * net->p[i][k][c];
                }
            }
        }
    }
    for (int c = 0; c < 4; c++) {
        out[c] = (taut_range){INFINITY, -INFINITY};
    }
    for (int m = 0; m <= u->degree; m++) {
        for (int n = 0; n <= v->degree; n++) {
            double sum[4] = {0, 0, 0, 0};
            for (int i = 0; i < u->local; i++) {
                const double f = u->c[order[0]][i][m];
                most[0] = fmax(most[0], fabs(f));
                for (int c = 0; c < 4; c++) {
                    sum[c] += f * rows[i][n][c];
                }
            }
            for (int c = 0; c < 4; c++) {
                widen(&out[c], sum[c]);
            }
        }
    }
    const double off =
        (u->off[order[0]] * (most[1] + v->off[order[1]]) + v->off[order[1]] * most[0]);
    for (int c = 0; c < 4; c++) {
        out[c].lo -= off * net->size[c];
        out[c].hi += off * net->size[c];
    }
}

static taut_range over(taut_range a, taut_range w)
{
    return taut_range_times(a, (taut_range){1 / w.hi, 1 / w.lo});
}

/* X = H/w, X_a = (H_a - X w_a)/w, X_ab = (H_ab - X_a w_b - X_b w_a - X w_ab)/w. */
static int divide(taut_range h[6][4], taut_range x[6][3])
{
    if (!(h[0][3].lo > 0)) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        x[0][c] = over(h[0][c], h[0][3]);
        for (int a = 1; a < 3; a++) {
            x[a][c] = over(taut_range_minus(h[a][c], taut_range_times(x[0][c], h[a][3])), h[0][3]);
        }
        for (int k = 3; k < 6; k++) {
            const int a = k == 5 ? 2 : 1, b = k == 3 ? 1 : 2;
            taut_range sum = taut_range_minus(h[k][c], taut_range_times(x[0][c], h[k][3]));
            sum = taut_range_minus(sum, taut_range_times(x[a][c], h[b][3]));
            sum = taut_range_minus(sum, taut_range_times(x[b][c], h[a][3]));
            x[k][c] = over(sum, h[0][3]);
        }
    }
    return 1;
}

static int surface_on(const taut_surface *surface, const int span[2], const double a[2],
                      const double b[2], const double frame[3][3], taut_range x[6][3])
{
    const int is_rational = taut_surface_weights(surface) != NULL;
    patch u, v;
    local_net net;
    taut_range h[6][4];
    if (!patch_of(taut_surface_u(surface), span[0], a[0], b[0], &u) ||
        !patch_of(taut_surface_v(surface), span[1], a[1], b[1], &v)) {
        return 0;
    }
    net_of(surface, frame, &u, &v, &net);
    for (int k = 0; k < 6; k++) {
        combine(&u, &v, &net, orders[k], h[k]);
        memcpy(x[k], h[k], sizeof x[k]);
    }
    if (is_rational && !divide(h, x)) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        const double about = frame != NULL ? taut_dot(frame[c], net.about) : net.about[c];
        x[0][c] = taut_range_add(x[0][c], taut_range_of(about));
    }
    return 1;
}

int taut_enclose_surface(const taut_surface *surface, const double a[2], const double b[2],
                         const double frame[3][3], taut_range x[6][3])
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    int spans[2][2], is_known = 1;
    for (int d = 0; d < 2; d++) {
        spans_of(bases[d], a[d], b[d], spans[d]);
    }
    for (int i = spans[0][0]; is_known && i <= spans[0][1]; i++) {
        for (int k = spans[1][0]; is_known && k <= spans[1][1]; k++) {
            const int span[2] = {i, k};
            double low[2], high[2];
            taut_range own[6][3];
            for (int d = 0; d < 2; d++) {
                const double *breaks = taut_basis_breaks(bases[d]);
                low[d] = fmax(a[d], breaks[span[d]]);
                high[d] = fmin(b[d], breaks[span[d] + 1]);
            }
            is_known = surface_on(surface, span, low, high, frame, own);
            join(i == spans[0][0] && k == spans[1][0], 18, own[0], x[0]);
        }
    }
    return is_known;
}

int taut_enclose_frame(const double x[3][3], double frame[3][3])
{
    taut_cross(x[1], x[2], frame[2]);
    const double lengths[2] = {taut_norm(x[1]), taut_norm(frame[2])};
    for (int c = 0; c < 3; c++) {
        frame[0][c] = x[1][c] / lengths[0];
        frame[2][c] /= lengths[1];
    }
    taut_cross(frame[2], frame[0], frame[1]);
    return lengths[0] > 0 && lengths[1] > 0;
}
