/* boundary.c -- the order of four curves around a surface, and the net that they bound. */
#include "geometry/boundary/boundary.h"

#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "taut/operations.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void taut_boundary_free(taut_curve *sides[TAUT_SIDES])
{
    for (int s = 0; s < TAUT_SIDES; s++) {
        taut_curve_free(sides[s]);
        sides[s] = NULL;
    }
}

int taut_boundary_is_rational(taut_curve *const sides[TAUT_SIDES])
{
    int is_rational = 0;
    for (int s = 0; s < TAUT_SIDES; s++) {
        is_rational |= taut_curve_weights(sides[s]) != NULL;
    }
    return is_rational;
}

/* The four curves of the problem, their ends and size. */
typedef struct loose_curves {
    double ends[TAUT_SIDES][2][3];
    double size;
} loose_curves;

/* Which curve is which side, and whether it is reversed. */
typedef struct arrangement {
    int curve[TAUT_SIDES], reversed[TAUT_SIDES];
} arrangement;

/* The corners: which end (0: where the parameter begins) of which two sides meets there. */
static const struct {
    const char *name;
    int side[2], end[2];
} corners[4] = {{"u0v0", {TAUT_SIDE_V0, TAUT_SIDE_U0}, {0, 0}},
                {"u1v0", {TAUT_SIDE_V0, TAUT_SIDE_U1}, {1, 0}},
                {"u1v1", {TAUT_SIDE_U1, TAUT_SIDE_V1}, {1, 1}},
                {"u0v1", {TAUT_SIDE_U0, TAUT_SIDE_V1}, {1, 0}}};

static void measure_curves(const taut_curve *const curves[TAUT_SIDES], loose_curves *loose)
{
    double lo[3] = {INFINITY, INFINITY, INFINITY}, hi[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < TAUT_SIDES; i++) {
        const taut_basis *t = taut_curve_t(curves[i]);
        const double *points = taut_curve_points(curves[i]);
        for (int k = 0; k < 3 * taut_basis_count(t); k++) {
            lo[k % 3] = fmin(lo[k % 3], points[k]);
            hi[k % 3] = fmax(hi[k % 3], points[k]);
        }
        taut_curve_eval(curves[i], taut_basis_lo(t), 0, loose->ends[i][0]);
        taut_curve_eval(curves[i], taut_basis_hi(t), 0, loose->ends[i][1]);
    }
    loose->size = taut_length_between(lo, hi);
}

/* Do the curves begin and end in their first and last control points? c- and h-bsplines do not, and
 * a net whose outer rows are theirs is not bounded by them. */
static taut_status check_clamped(const taut_curve *const curves[TAUT_SIDES],
                                 const loose_curves *loose, taut_error *error)
{
    for (int i = 0; i < TAUT_SIDES; i++) {
        const double *points = taut_curve_points(curves[i]);
        const double *last = points + 3 * (taut_basis_count(taut_curve_t(curves[i])) - 1);
        if (!(taut_length_between(points, loose->ends[i][0]) <= 1e-12 * loose->size) ||
            !(taut_length_between(last, loose->ends[i][1]) <= 1e-12 * loose->size)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "not-clamped", NULL, taut_none, taut_none,
                             "curve %d, a %s, does not begin and end in control points: convert it "
                             "to a B-spline",
                             i + 1, taut_basis_type(taut_curve_t(curves[i])));
        }
    }
    return TAUT_OK;
}

static const double *end_of(const loose_curves *loose, const arrangement *a, int side, int end)
{
    return loose->ends[a->curve[side]][end ^ a->reversed[side]];
}

/* The widest gap of an arrangement, and the corner it is at. */
static double widest_gap(const loose_curves *loose, const arrangement *a, int *corner)
{
    double widest = -1;
    for (int c = 0; c < 4; c++) {
        const double gap =
            taut_length_between(end_of(loose, a, corners[c].side[0], corners[c].end[0]),
                                end_of(loose, a, corners[c].side[1], corners[c].end[1]));
        if (gap > widest) {
            widest = gap;
            *corner = c;
        }
    }
    return widest;
}

/* Of the 3! ways to name the other three sides and the 2^3 ways to turn them, the one whose widest
 * gap is least. */
static arrangement best_arrangement(const loose_curves *loose)
{
    static const int orders[6][3] = {{1, 2, 3}, {1, 3, 2}, {2, 1, 3},
                                     {2, 3, 1}, {3, 1, 2}, {3, 2, 1}};
    arrangement best = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    double least = INFINITY;
    for (int trial = 0; trial < 48; trial++) {
        const int *order = orders[trial / 8];
        arrangement a;
        int corner = 0;
        a.curve[TAUT_SIDE_V0] = 0;
        a.reversed[TAUT_SIDE_V0] = 0;
        a.curve[TAUT_SIDE_U0] = order[0];
        a.curve[TAUT_SIDE_U1] = order[1];
        a.curve[TAUT_SIDE_V1] = order[2];
        a.reversed[TAUT_SIDE_U0] = trial & 1;
        a.reversed[TAUT_SIDE_U1] = trial >> 1 & 1;
        a.reversed[TAUT_SIDE_V1] = trial >> 2 & 1;
        const double gap = widest_gap(loose, &a, &corner);
        if (gap < least || trial == 0) {
            least = gap;
            best = a;
        }
    }
    return best;
}

/* "curve 2 (\"rail\")" */
static void name_curve(const taut_curve *curve, int i, char *text, size_t size)
{
    if (taut_curve_name(curve)[0] != '\0') {
        snprintf(text, size, "curve %d (\"%.40s\")", i + 1, taut_curve_name(curve));
    } else {
        snprintf(text, size, "curve %d", i + 1);
    }
}

static taut_status refuse_gap(const taut_curve *const curves[TAUT_SIDES], const loose_curves *loose,
                              const arrangement *a, int corner, double gap, double limit,
                              taut_error *error)
{
    const int first = a->curve[corners[corner].side[0]];
    const int second = a->curve[corners[corner].side[1]];
    const double *at = end_of(loose, a, corners[corner].side[0], corners[corner].end[0]);
    char names[2][64];
    name_curve(curves[first], first, names[0], sizeof names[0]);
    name_curve(curves[second], second, names[1], sizeof names[1]);
    return taut_fail(error, TAUT_NO_SOLUTION, "gap", NULL, gap, limit,
                     "the curves do not close: a gap of %.3g is left between %s and %s at (%.6g, "
                     "%.6g, %.6g), more than %.3g",
                     gap, names[0], names[1], at[0], at[1], at[2], limit);
}

/* A copy of a side whose end points are the corners. */
static taut_status close_side(const taut_curve *curve, const double *begin, const double *end,
                              taut_curve **side, taut_error *error)
{
    const size_t count = (size_t)taut_basis_count(taut_curve_t(curve));
    double *points = taut_alloc(3 * count, sizeof *points);
    taut_status status = TAUT_OK;
    if (points == NULL) {
        return taut_fail_memory(error);
    }
    memcpy(points, taut_curve_points(curve), 3 * count * sizeof *points);
    memcpy(points, begin, 3 * sizeof *points);
    memcpy(points + 3 * (count - 1), end, 3 * sizeof *points);
    status = taut_curve_new(taut_curve_name(curve), taut_curve_t(curve), points,
                            taut_curve_weights(curve), side, error);
    taut_free(points);
    return status;
}

/* Turns and closes one side. */
static taut_status make_side(const taut_curve *curve, int reversed, const double *begin,
                             const double *end, taut_curve **side, taut_error *error)
{
    taut_curve *turned = NULL;
    taut_status status = TAUT_OK;
    if (!reversed) {
        return close_side(curve, begin, end, side, error);
    }
    status = taut_curve_reverse(curve, &turned, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = close_side(turned, begin, end, side, error);
    taut_curve_free(turned);
    return status;
}

taut_status taut_boundary_order(const taut_curve *const curves[TAUT_SIDES], double tolerance,
                                taut_curve *sides[TAUT_SIDES], taut_error *error)
{
    taut_curve *made[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    double ends[TAUT_SIDES][2][3];
    loose_curves loose;
    arrangement a;
    double gap = 0;
    int corner = 0;
    taut_status status = TAUT_OK;

    measure_curves(curves, &loose);
    status = check_clamped(curves, &loose, error);
    if (status != TAUT_OK) {
        return status;
    }
    a = best_arrangement(&loose);
    gap = widest_gap(&loose, &a, &corner);
    if (!(gap <= tolerance * loose.size)) {
        return refuse_gap(curves, &loose, &a, corner, gap, tolerance * loose.size, error);
    }
    for (int c = 0; c < 4; c++) {
        const double *p = end_of(&loose, &a, corners[c].side[0], corners[c].end[0]);
        const double *q = end_of(&loose, &a, corners[c].side[1], corners[c].end[1]);
        for (int k = 0; k < 3; k++) {
            const double middle = p[k] == q[k] ? p[k] : p[k] / 2 + q[k] / 2;
            ends[corners[c].side[0]][corners[c].end[0]][k] = middle;
            ends[corners[c].side[1]][corners[c].end[1]][k] = middle;
        }
    }
    for (int s = 0; status == TAUT_OK && s < TAUT_SIDES; s++) {
        status =
            make_side(curves[a.curve[s]], a.reversed[s], ends[s][0], ends[s][1], &made[s], error);
    }
    if (status != TAUT_OK) {
        taut_boundary_free(made);
        return status;
    }
    memcpy(sides, made, sizeof made);
    return TAUT_OK;
}

static double weight_at(const taut_curve *curve, int i)
{
    return taut_curve_weights(curve) != NULL ? taut_curve_weights(curve)[i] : 1;
}

/* The logarithm of the weight inside at (i, j): Coons' blend of those on the boundary,
 *     (1-s) a(t) + s b(t) + (1-t) c(s) + t d(s) - the bilinear blend of the corners. */
static double blend_weight(taut_curve *const sides[TAUT_SIDES], int i, int nu, int j, int nv)
{
    const double s = (double)i / (nu - 1), t = (double)j / (nv - 1);
    const double a = taut_log(weight_at(sides[TAUT_SIDE_U0], j));
    const double b = taut_log(weight_at(sides[TAUT_SIDE_U1], j));
    const double c = taut_log(weight_at(sides[TAUT_SIDE_V0], i));
    const double d = taut_log(weight_at(sides[TAUT_SIDE_V1], i));
    const double low = (1 - s) * taut_log(weight_at(sides[TAUT_SIDE_V0], 0)) +
                       s * taut_log(weight_at(sides[TAUT_SIDE_V0], nu - 1));
    const double high = (1 - s) * taut_log(weight_at(sides[TAUT_SIDE_V1], 0)) +
                        s * taut_log(weight_at(sides[TAUT_SIDE_V1], nu - 1));
    return (1 - s) * a + s * b + (1 - t) * c + t * d - (1 - t) * low - t * high;
}

void taut_boundary_net(taut_curve *const fitted[TAUT_SIDES], double *points, unsigned char *known,
                       double *weights)
{
    const int nu = taut_basis_count(taut_curve_t(fitted[TAUT_SIDE_V0]));
    const int nv = taut_basis_count(taut_curve_t(fitted[TAUT_SIDE_U0]));
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const size_t at = (size_t)i * (size_t)nv + (size_t)j;
            const int along_v = i == 0 || i == nu - 1, along_u = j == 0 || j == nv - 1;
            const int side = along_u ? (j == 0 ? TAUT_SIDE_V0 : TAUT_SIDE_V1)
                                     : (i == 0 ? TAUT_SIDE_U0 : TAUT_SIDE_U1);
            const int k = along_u ? i : j;
            known[at] = (unsigned char)(along_u || along_v);
            for (int c = 0; c < 3; c++) {
                points[3 * at + (size_t)c] =
                    known[at] ? taut_curve_points(fitted[side])[3 * k + c] : 0;
            }
            if (weights != NULL) {
                weights[at] = known[at] ? weight_at(fitted[side], k)
                                        : taut_exp(blend_weight(fitted, i, nu, j, nv));
            }
        }
    }
}
