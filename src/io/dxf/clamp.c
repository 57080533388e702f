/* clamp.c -- floating and periodic knots to clamped ones.
 *
 * A spline of degree p on knots t is a curve over [t_p, t_n]. Its points on other knots s, of the same breaks, are the polar
 * forms f(s_(j+1), ..., s_(j+p)) of a polynomial piece beside them ([Farin2002], blossoms; de Boor's triangle with an argument a row):
 *
 *     d_i <- ((t_(i+p+1-r) - u_r) d_(i-1) + (u_r - t_i) d_i) / (t_(i+p+1-r) - t_i),    r = 1..p
 */
#include "io/dxf/clamp.h"

#include "core/arena.h"
#include "taut/limits.h"

#include <string.h>

static int is_clamped(const taut_dxf_curve *curve)
{
    const size_t p = (size_t)curve->degree, n = curve->count;
    for (size_t k = 1; k <= p; k++) {
        if (curve->knots[k] != curve->knots[0] || curve->knots[n + k] != curve->knots[n]) {
            return 0;
        }
    }
    return curve->knots[n] > curve->knots[0];
}

static int do_increase(const double *knots, size_t count)
{
    for (size_t k = 1; k < count; k++) {
        if (!(knots[k] >= knots[k - 1])) {
            return 0;
        }
    }
    return 1;
}

/* The polar form of the piece over [t_k, t_(k+1)] at p arguments. */
static void polar(const taut_dxf_curve *curve, size_t k, const double *arguments, double out[4])
{
    const size_t p = (size_t)curve->degree;
    const double *t = curve->knots;
    double d[TAUT_DEGREE_MAX + 1][4];
    memcpy(d, curve->points[k - p], (p + 1) * sizeof d[0]);
    for (size_t r = 1; r <= p; r++) {
        for (size_t i = p; i >= r; i--) {
            const double lo = t[k - p + i], hi = t[k + i + 1 - r];
            const double part = (arguments[r - 1] - lo) / (hi - lo);
            for (int c = 0; c < 4; c++) {
                d[i][c] = (1 - part) * d[i - 1][c] + part * d[i][c];
            }
        }
    }
    memcpy(out, d[p], sizeof d[p]);
}

/* Point j on the new knots; 0 where no piece lies beside it. */
static int find_point(const taut_dxf_curve *curve, const double *knots, size_t j, double out[4])
{
    const size_t p = (size_t)curve->degree, n = curve->count;
    size_t s = j, k = p;
    while (s <= j + p && !(knots[s] < knots[s + 1])) {
        s++;
    }
    if (s > j + p) {
        return 0;
    }
    while (k + 1 < n && curve->knots[k + 1] <= knots[s]) {
        k++;
    }
    for (size_t i = k - p; i <= k; i++) {
        if (memcmp(curve->knots + i + 1, knots + j + 1, p * sizeof *knots) == 0) {
            memcpy(out, curve->points[i], sizeof curve->points[i]);
            return 1;
        }
    }
    polar(curve, k, knots + j + 1, out);
    return 1;
}

int taut_dxf_clamp(taut_dxf_curve *curve, taut_arena *arena)
{
    const size_t p = (size_t)curve->degree, n = curve->count;
    taut_dxf_curve made = {.degree = curve->degree, .room = n};

    if (is_clamped(curve)) {
        return 1;
    }
    if (!do_increase(curve->knots, n + p + 1) || !(curve->knots[p] < curve->knots[n])) {
        return 0;
    }
    made.points = taut_arena_take(arena, n, sizeof *made.points);
    made.knots = taut_arena_take(arena, n + p + 1, sizeof *made.knots);
    if (made.points == NULL || made.knots == NULL) {
        return 0;
    }
    for (size_t k = 0; k <= p; k++) {
        made.knots[made.count++] = curve->knots[p];
    }
    for (size_t k = p + 1; k < n; k++) {
        if (curve->knots[k] > curve->knots[p] && curve->knots[k] < curve->knots[n]) {
            made.knots[made.count++] = curve->knots[k];
        }
    }
    for (size_t k = 0; k <= p; k++) {
        made.knots[made.count + k] = curve->knots[n];
    }
    for (size_t j = 0; j < made.count; j++) {
        if (!find_point(curve, made.knots, j, made.points[j])) {
            return 0;
        }
    }
    *curve = made;
    return 1;
}
