/* judge_patches.c -- judges of minimal nets and of patches between asymptotic curves.
 *
 *     isothermal, harmonic, minimal   at an irregular grid of every span
 *     formula                         docs/bonnet.md, at the same places
 *     smooth                          first derivatives on both sides of every knot
 *     closed-form                     own integral of the area against its closed form
 *     asymptotic, osculating          N . x_tt / |x_t|^2 along the edges, and that over the curvature
 *     regular                         a grid, then a compass from every low place that turns and
 *                                     stretches to its valley
 */
#include "oracle/oracle.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static oracle_real share_of(const oracle_basis *basis, oracle_real share)
{
    return basis->lo + share * ((oracle_real)basis->hi - basis->lo);
}

/* The functions at a share of the range. */
static void share_row(const oracle_basis *basis, oracle_real share, oracle_row *row)
{
    const oracle_real t = share_of(basis, share);

    oracle_basis_row(basis, oracle_basis_span(basis, t), t, 1, row);
}

typedef oracle_real (*place_fn)(oracle_real x[6][3]);

static oracle_real isothermal_at(oracle_real x[6][3])
{
    const oracle_real e = oracle_dot(x[1], x[1]), f = oracle_dot(x[1], x[2]),
                      g = oracle_dot(x[2], x[2]);

    return fmaxl(fabsl(e - g), fabsl(f)) / fmaxl(e, g);
}

static oracle_real minimal_at(oracle_real x[6][3])
{
    const oracle_real e = oracle_dot(x[1], x[1]), f = oracle_dot(x[1], x[2]),
                      g = oracle_dot(x[2], x[2]);
    oracle_real n[3];

    oracle_cross(x[1], x[2], n);
    const oracle_real w = oracle_norm(n);
    const oracle_real l = oracle_dot(x[3], n) / w, m = oracle_dot(x[4], n) / w,
                      k = oracle_dot(x[5], n) / w;
    const oracle_real h = (e * k - 2 * f * m + g * l) / (2 * w * w);
    const oracle_real gauss = fabsl(l * k - m * m) / (w * w);
    const oracle_real scale = (e * fabsl(k) + 2 * fabsl(f * m) + g * fabsl(l)) / (2 * w * w);
    return fabsl(h) / fmaxl(sqrtl(gauss), scale); /* at a flat point nothing is said */
}

static double worst_place(const oracle_case *about, place_fn find)
{
    oracle_real worst = 0;

    for (int s = 0; s < oracle_subject_count(about); s++) {
        oracle_sheet sheet;
        if (!oracle_sheet_of(oracle_subject(about, s), &sheet)) {
            return NAN;
        }
        const int per = sheet.u.spans * sheet.v.spans > 400 ? 2 : 5;
        for (int i = 0; i < sheet.u.spans * per; i++) {
            for (int j = 0; j < sheet.v.spans * per; j++) {
                const oracle_real ulo = sheet.u.breaks[i / per], vlo = sheet.v.breaks[j / per];
                oracle_real x[6][3], found;
                oracle_sheet_eval(
                    &sheet, ulo + (sheet.u.breaks[i / per + 1] - ulo) * (i % per + 0.37L) / per,
                    vlo + (sheet.v.breaks[j / per + 1] - vlo) * (j % per + 0.61L) / per, 2, x);
                found = find(x);
                worst = found > worst ? found : worst;
            }
        }
        oracle_sheet_free(&sheet);
    }
    return (double)worst;
}

double oracle_isothermal(const oracle_case *about)
{
    return worst_place(about, isothermal_at);
}

double oracle_minimal(const oracle_case *about)
{
    return worst_place(about, minimal_at);
}

double oracle_harmonic_net(const oracle_case *about)
{
    oracle_real worst = 0;

    for (int s = 0; s < oracle_subject_count(about); s++) {
        oracle_sheet sheet;
        oracle_real sum = 0, second = 0;
        if (!oracle_sheet_of(oracle_subject(about, s), &sheet)) {
            return NAN;
        }
        const int nu = 4 * sheet.u.spans + 1, nv = 4 * sheet.v.spans + 1;
        for (int i = 0; i < nu * nv && nu * nv < 20000; i++) {
            const oracle_real a = (oracle_real)(i % nu) / (nu - 1),
                              b = (oracle_real)(i / nu) / (nv - 1);
            oracle_real x[6][3], d[3];
            oracle_sheet_eval(&sheet, sheet.u.lo * (1 - a) + sheet.u.hi * a,
                              sheet.v.lo * (1 - b) + sheet.v.hi * b, 2, x);
            for (int k = 0; k < 3; k++) {
                d[k] = x[3][k] + x[5][k];
            }
            sum = fmaxl(sum, oracle_norm(d));
            second = fmaxl(second,
                           fmaxl(oracle_norm(x[3]), fmaxl(oracle_norm(x[4]), oracle_norm(x[5]))));
        }
        oracle_sheet_free(&sheet);
        if (second > 0) {
            worst = fmaxl(worst, sum / second / 2); /* the largest may lie between samples */
        }
    }
    return (double)worst;
}

/* r(u, v) of the family and its conjugate, turned by theta. */
static void family(oracle_real lambda, int plus, oracle_real theta, oracle_real u, oracle_real v,
                   oracle_real r[3])
{
    const oracle_real s = plus ? 1 : -1, w = sqrtl(1 - lambda * lambda);
    const oracle_real x[3] = {(lambda * u + s * sinl(u) * coshl(v)) / w,
                              (v + s * lambda * cosl(u) * sinhl(v)) / w, s * cosl(u) * coshl(v)};
    /* the conjugate: y_u = x_v ... up to sign, y_u = -x_v, y_v = x_u */
    const oracle_real y[3] = {(lambda * v + s * cosl(u) * sinhl(v)) / w,
                              -(u + s * lambda * sinl(u) * coshl(v)) / w, -s * sinl(u) * sinhl(v)};

    for (int k = 0; k < 3; k++) {
        r[k] = cosl(theta) * x[k] + sinl(theta) * y[k];
    }
}

double oracle_formula(const oracle_case *about)
{
    const taut_record *p = about->problem;
    const double lambda = oracle_number(taut_record_get(p, "lambda"));
    oracle_real worst = 0, largest = 0;
    oracle_sheet sheet;

    if (p == NULL || isnan(lambda) || taut_record_get(p, "normalize") != NULL ||
        taut_record_get(p, "theta") != NULL || !oracle_sheet_of(oracle_subject(about, 0), &sheet)) {
        return NAN;
    }
    const taut_record *start = taut_record_get(p, "start");
    const oracle_real u0 = start != NULL ? oracle_number(taut_record_at(start, 0)) : 0;
    const oracle_real v0 = start != NULL ? oracle_number(taut_record_at(start, 1)) : 0;
    const int plus = strcmp(taut_record_text(taut_record_get(p, "sign")), "-") != 0;
    for (int i = 0; i < 441; i++) {
        const oracle_real a = (oracle_real)(i % 21) / 20, b = (oracle_real)(i / 21) / 20;
        const oracle_real u = sheet.u.lo * (1 - a) + sheet.u.hi * a;
        const oracle_real v = sheet.v.lo * (1 - b) + sheet.v.hi * b;
        oracle_real x[6][3], r[3];
        oracle_sheet_eval(&sheet, u, v, 0, x);
        family(lambda, plus, 0, u - sheet.u.lo + u0, v - sheet.v.lo + v0, r);
        for (int k = 0; k < 3; k++) {
            worst = fmaxl(worst, fabsl(x[0][k] + sheet.middle[k] - r[k]));
            largest = fmaxl(largest, fabsl(r[k]));
        }
    }
    oracle_sheet_free(&sheet);
    return (double)(worst / largest / 2);
}

/* The jump of first derivatives across every knot, over the sizes of both at that place. */
double oracle_smooth(const oracle_case *about)
{
    oracle_real worst = 0;

    for (int s = 0; s < oracle_subject_count(about); s++) {
        oracle_sheet sheet;
        oracle_real largest = 0, jump = 0;
        if (!oracle_sheet_of(oracle_subject(about, s), &sheet)) {
            return NAN;
        }
        for (int d = 0; d < 2; d++) {
            const oracle_basis *along = d == 0 ? &sheet.u : &sheet.v;
            const oracle_basis *beside = d == 0 ? &sheet.v : &sheet.u;
            for (int i = 0; i < 9 * (along->spans - 1); i++) {
                const int span = i / 9;
                const oracle_real f = (i % 9 + 0.5L) / 9;
                oracle_row row[2], other;
                oracle_real x[2][6][3], apart[3];
                oracle_basis_row(along, span, along->breaks[span + 1], 2, &row[0]);
                oracle_basis_row(along, span + 1, along->breaks[span + 1], 2, &row[1]);
                oracle_basis_row(beside, oracle_basis_span(beside, share_of(beside, f)),
                                 share_of(beside, f), 2, &other);
                for (int side = 0; side < 2; side++) {
                    oracle_sheet_at(&sheet, d == 0 ? &row[side] : &other,
                                    d == 0 ? &other : &row[side], 2, x[side]);
                }
                for (int k = 0; k < 3; k++) {
                    apart[k] = x[0][1 + d][k] - x[1][1 + d][k];
                }
                /* a span's end and the next one's start are the same to rounding of the range */
                const oracle_real bend =
                    oracle_norm(x[0][3 + 2 * d]) + oracle_norm(x[1][3 + 2 * d]);
                jump = fmaxl(jump, oracle_norm(apart) -
                                       bend * 0x1p-51L * (fabsl(along->lo) + fabsl(along->hi)));
                largest = fmaxl(largest, oracle_norm(x[0][1 + d]) + oracle_norm(x[1][1 + d]));
            }
        }
        oracle_sheet_free(&sheet);
        /* sums of some twenty terms in the wider format are no better than this */
        worst = jump > 0x1p-58L * largest ? fmaxl(worst, jump / largest) : worst;
    }
    return (double)worst;
}

/* The area of the surface of the problem: x_u . x_u = ((cosh v + s lambda cos u) / w)^2, whatever
 * theta, integrated by elementary functions. */
static oracle_real area_of_family(oracle_real lambda, int plus, const oracle_real u[2],
                                  const oracle_real v[2])
{
    const oracle_real a = plus ? lambda : -lambda, width = u[1] - u[0], height = v[1] - v[0];
    const oracle_real cosh2 = height / 2 + (sinhl(2 * v[1]) - sinhl(2 * v[0])) / 4;
    const oracle_real cos2 = width / 2 + (sinl(2 * u[1]) - sinl(2 * u[0])) / 4;

    return (width * cosh2 + 2 * a * (sinl(u[1]) - sinl(u[0])) * (sinhl(v[1]) - sinhl(v[0])) +
            a * a * cos2 * height) /
           (1 - lambda * lambda);
}

/* The area by own integrals against the closed form over the window of the problem, relative; half
 * of it, as `closed-form` tells of area and total curvature the one nearer to its limit. */
double oracle_closed(const oracle_case *about)
{
    const taut_record *p = about->problem, *start = taut_record_get(p, "start");
    const double lambda = oracle_number(taut_record_get(p, "lambda"));
    oracle_sheet sheet;
    oracle_integrals own = {.area = NAN};

    if (p == NULL || about->honest == NULL || isnan(lambda) ||
        taut_record_get(p, "normalize") != NULL ||
        !oracle_sheet_of(oracle_subject(about, 0), &sheet)) {
        return NAN;
    }
    if (sheet.u.spans * sheet.v.spans <= 6) {
        oracle_integrate(&sheet, 1e-11L, 2, &own);
    }
    oracle_sheet_free(&sheet);
    if (!oracle_sheet_of(taut_model_surface(about->honest, 0), &sheet)) {
        return NAN;
    }
    const oracle_real u0 = start != NULL ? oracle_number(taut_record_at(start, 0)) : 0;
    const oracle_real v0 = start != NULL ? oracle_number(taut_record_at(start, 1)) : 0;
    const oracle_real u[2] = {u0, u0 + (oracle_real)sheet.u.hi - sheet.u.lo};
    const oracle_real v[2] = {v0, v0 + (oracle_real)sheet.v.hi - sheet.v.lo};
    const int plus = strcmp(taut_record_text(taut_record_get(p, "sign")), "-") != 0;
    const oracle_real area = area_of_family(lambda, plus, u, v);
    oracle_sheet_free(&sheet);
    return (double)((fabsl(own.area - area) - own.area_error) / area / 2);
}

/* ---- asymptotic ---- */

static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};

/* Edge e of the patch at s, with the derivatives of the surface. */
static void on_edge(const oracle_sheet *sheet, int e, oracle_real s, oracle_real x[6][3])
{
    const oracle_real a = e < 2 ? (oracle_real)e : s, b = e < 2 ? s : (oracle_real)(e - 2);

    oracle_sheet_eval(sheet, sheet->u.lo * (1 - a) + sheet->u.hi * a,
                      sheet->v.lo * (1 - b) + sheet->v.hi * b, 2, x);
}

static void edge_values(const oracle_sheet *sheet, int e, oracle_real s, oracle_real *normal,
                        oracle_real *curvature)
{
    oracle_real x[6][3], n[3], c[3];
    const int t = e < 2 ? 2 : 1, tt = e < 2 ? 5 : 3;

    on_edge(sheet, e, s, x);
    oracle_cross(x[1], x[2], n);
    oracle_cross(x[t], x[tt], c);
    const oracle_real speed = oracle_norm(x[t]);
    *normal = fabsl(oracle_dot(n, x[tt])) / oracle_norm(n) / (speed * speed);
    *curvature = oracle_norm(c) / (speed * speed * speed);
    if (!(oracle_norm(n) > 1e-9L * speed * speed)) { /* beside a singular point nothing is said */
        *normal = 0;
    }
}

/* Of the edge and the next row alone: the normal curvature along an edge is made of positions and
 * derivatives there, to which no other row gives anything. Taken about the middle of the whole net
 * one inner point that is a million sizes away costs six of the digits, which then look like a
 * curvature, and accuse a certificate that is right. */
static void look_at_edge(oracle_sheet *sheet, int e)
{
    const int nu = sheet->u.count - 1, nv = sheet->v.count - 1;

    oracle_sheet_about(sheet, e == 1 ? nu - 1 : 0, e == 0 ? 1 : nu, e == 3 ? nv - 1 : 0,
                       e == 2 ? 1 : nv);
}

static double worst_edge(const oracle_case *about, int osculating)
{
    enum { EDGE_PLACES = 100 };
    oracle_sheet sheet;
    oracle_real worst = 0;

    if (!oracle_sheet_of(oracle_subject(about, 0), &sheet)) {
        return NAN;
    }
    for (int e = 0; e < 4; e++) {
        oracle_real largest = 0, normal[EDGE_PLACES], curvature[EDGE_PLACES];
        look_at_edge(&sheet, e);
        for (int i = 0; i < EDGE_PLACES; i++) {
            edge_values(&sheet, e, (i + 0.43L) / EDGE_PLACES, &normal[i], &curvature[i]);
            largest = fmaxl(largest, curvature[i]);
        }
        for (int i = 0; i < EDGE_PLACES; i++) {
            const int bent = curvature[i] > 0.1L * largest && largest * sheet.extent > 1e-6L;
            const oracle_real found = !osculating ? normal[i] : bent ? normal[i] / curvature[i] : 0;
            worst = found > worst ? found : worst;
        }
    }
    oracle_sheet_free(&sheet);
    return (double)worst;
}

double oracle_normal_curvature(const oracle_case *about)
{
    return worst_edge(about, 0);
}

double oracle_osculating(const oracle_case *about)
{
    return worst_edge(about, 1);
}

/* Points of the model's curves against the edges that carry their names, and corners against the
 * problem's. Over twice the size, which is the most that any other measure of it gives. */
double oracle_edges(const oracle_case *about)
{
    const taut_record *corners = taut_record_get(about->problem, "corners");
    static const char *const corner_names[4] = {"u0v0", "u1v0", "u0v1", "u1v1"};
    oracle_sheet sheet;
    oracle_real worst = 0;

    if (!oracle_sheet_of(oracle_subject(about, 0), &sheet)) {
        return NAN;
    }
    for (int e = 0; e < 4; e++) {
        oracle_line line;
        double corner[3];
        oracle_real x[6][3], y[3][3];
        if (oracle_line_of(oracle_curve(about->model, edge_names[e]), &line)) {
            for (int i = 0; i <= 20; i++) {
                const oracle_real s = (oracle_real)i / 20;
                on_edge(&sheet, e, s, x);
                oracle_line_eval(&line, line.t.lo * (1 - s) + line.t.hi * s, y);
                for (int k = 0; k < 3; k++) {
                    worst = fmaxl(worst, fabsl(x[0][k] + sheet.middle[k] - y[0][k]));
                }
            }
            oracle_line_free(&line);
        }
        if (oracle_point(taut_record_get(corners, corner_names[e]), corner)) {
            oracle_sheet_eval(&sheet, e % 2 ? sheet.u.hi : sheet.u.lo,
                              e / 2 ? sheet.v.hi : sheet.v.lo, 0, x);
            for (int k = 0; k < 3; k++) {
                worst = fmaxl(worst, fabsl(x[0][k] + sheet.middle[k] - corner[k]));
            }
        }
    }
    worst /= 2 * sheet.size;
    oracle_sheet_free(&sheet);
    return (double)worst;
}

double oracle_smallest_weight(const oracle_case *about)
{
    const taut_surface *surface = oracle_subject(about, 0);
    const double *weights = surface != NULL ? taut_surface_weights(surface) : NULL;
    double least = INFINITY;

    if (weights == NULL) {
        return NAN;
    }
    for (int i = 0;
         i < taut_basis_count(taut_surface_u(surface)) * taut_basis_count(taut_surface_v(surface));
         i++) {
        least = fmin(least, weights[i]);
    }
    return least;
}

/* The sine; 0 where a derivative vanishes: there is no normal. Of weights far apart derivatives may be as
 * small as their quotient, so that rounding alone counts as nothing. */
static oracle_real sine_of(const oracle_sheet *sheet, const oracle_row *u, const oracle_row *v)
{
    const oracle_real a = (oracle_real)sheet->u.hi - sheet->u.lo,
                      b = (oracle_real)sheet->v.hi - sheet->v.lo;
    oracle_real x[6][3], n[3];

    oracle_sheet_at(sheet, u, v, 1, x);
    oracle_cross(x[1], x[2], n);
    const oracle_real lu = oracle_norm(x[1]), lv = oracle_norm(x[2]);
    const oracle_real nothing = 64 * LDBL_EPSILON * sheet->size;
    if (!(lu > nothing / a) || !(lv > nothing / b)) {
        return 0;
    }
    return oracle_norm(n) / (lu * lv);
}

static oracle_real sine_at(const oracle_sheet *sheet, const oracle_real at[2])
{
    oracle_row row[2];

    share_row(&sheet->u, at[0], &row[0]);
    share_row(&sheet->v, at[1], &row[1]);
    return sine_of(sheet, &row[0], &row[1]);
}

/* Nelder and Mead from a small triangle: it turns into valleys by itself. */
static oracle_real go_down(const oracle_sheet *sheet, const oracle_real from[2], oracle_real step)
{
    oracle_real p[3][2], f[3];

    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 2; k++) {
            const oracle_real move = i == k + 1 ? (from[k] > 0.5L ? -step : step) : 0;
            p[i][k] = fminl(1, fmaxl(0, from[k] + move));
        }
        f[i] = sine_at(sheet, p[i]);
    }
    for (int turn = 0; turn < 90; turn++) {
        int best = f[0] <= f[1] ? 0 : 1, worst = 1 - best;
        if (f[2] < f[best]) {
            best = 2;
        } else if (f[2] > f[worst]) {
            worst = 2;
        }
        const int middle = 3 - best - worst;
        static const oracle_real ways[4] = {-1, -2, -0.5L, 0.5L};
        int better = 0;
        oracle_real chosen[2], value = f[worst];
        for (int w = 0; w < 4; w++) {
            oracle_real q[2];
            for (int k = 0; k < 2; k++) {
                const oracle_real centre = (p[best][k] + p[middle][k]) / 2;
                q[k] = fminl(1, fmaxl(0, centre + ways[w] * (p[worst][k] - centre)));
            }
            const oracle_real g = sine_at(sheet, q);
            if (g < value) {
                value = g;
                memcpy(chosen, q, sizeof q);
                better = 1;
            }
        }
        if (better) {
            memcpy(p[worst], chosen, sizeof chosen);
            f[worst] = value;
            continue;
        }
        for (int i = 0; i < 3; i++) { /* shrink */
            for (int k = 0; k < 2; k++) {
                p[i][k] = (p[i][k] + p[best][k]) / 2;
            }
            f[i] = sine_at(sheet, p[i]);
        }
    }
    return fminl(f[0], fminl(f[1], f[2]));
}

double oracle_smallest_sine(const oracle_case *about)
{
    enum { GRID = 33, LOWEST = 8 };
    static _Thread_local oracle_real sine[GRID][GRID];
    static _Thread_local oracle_row rows[2][GRID];
    int low[LOWEST] = {0}, count = 0;
    oracle_sheet sheet;

    if (!oracle_sheet_of(oracle_subject(about, 0), &sheet)) {
        return NAN;
    }
    for (int i = 0; i < 2 * GRID; i++) {
        share_row(i % 2 ? &sheet.v : &sheet.u, (oracle_real)(i / 2) / (GRID - 1),
                  &rows[i % 2][i / 2]);
    }
    for (int i = 0; i < GRID * GRID; i++) {
        sine[i / GRID][i % GRID] = sine_of(&sheet, &rows[0][i / GRID], &rows[1][i % GRID]);
    }
    for (int i = 0; i < GRID * GRID; i++) { /* the lowest of the local minima */
        const int r = i / GRID, c = i % GRID;
        int lowest = 1, k;
        for (int d = 0; d < 9 && lowest; d++) {
            const int rr = r + d / 3 - 1, cc = c + d % 3 - 1;
            lowest = rr < 0 || cc < 0 || rr >= GRID || cc >= GRID || sine[r][c] <= sine[rr][cc];
        }
        if (!lowest) {
            continue;
        }
        for (k = count < LOWEST ? count++ : LOWEST - 1;
             k > 0 && sine[low[k - 1] / GRID][low[k - 1] % GRID] > sine[r][c]; k--) {
            low[k] = low[k - 1];
        }
        if (k < LOWEST - 1 || count < LOWEST || sine[low[k] / GRID][low[k] % GRID] > sine[r][c]) {
            low[k] = i;
        }
    }
    oracle_real least = sine[low[0] / GRID][low[0] % GRID];
    for (int k = 0; k < count; k++) {
        const oracle_real at[2] = {(oracle_real)(low[k] / GRID) / (GRID - 1),
                                   (oracle_real)(low[k] % GRID) / (GRID - 1)};
        least = fminl(least, go_down(&sheet, at, 0.5L / GRID));
    }
    oracle_sheet_free(&sheet);
    return (double)least;
}
