/* nurbs.c -- NURBS within a proved tolerance: as many spans as the proof wants. */
#include "taut/operations.h"

#include "core/fail.h"
#include "geometry/lattice.h"
#include "geometry/nurbs/proof.h"
#include "geometry/operate/change.h"

#include <math.h>

/* Rounding of a spline's coefficients over the size of net and rows: the basis functions are good
 * to 1e-14 (taut/basis.h), four of them to a row, and as much again for the sums. */
#define TAUT_ROUNDING 1e-13
#define POINTS_LARGEST 1e200

static double spline_count(const taut_nurbs_side *s)
{
    return s->basis == NULL ? 1
           : s->exact       ? taut_basis_count(s->basis)
                            : 3.0 * s->first[s->pieces.count] + 3;
}

/* Would the result be of a size that is allowed? */
static taut_status check_size(const taut_nurbs_side *u, const taut_nurbs_side *v, double tolerance,
                              taut_error *error)
{
    const double rows = spline_count(u), columns = spline_count(v);
    if (rows * columns > TAUT_POINTS_MAX) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", NULL, rows * columns,
                         TAUT_POINTS_MAX,
                         "a NURBS within %g needs %.0f by %.0f points, more than fit: ask for a "
                         "larger tolerance",
                         tolerance, rows, columns);
    }
    return TAUT_OK;
}

/* Spans such that the proof holds: each side for its share alone, the mixed term taking what is
 * left; where that is not enough, smaller shares. */
static taut_status divide_until(const taut_lattice *whole, taut_nurbs_side *u, taut_nurbs_side *v,
                                double tolerance, double *bound, taut_error *error)
{
    double share = u->exact || v->exact ? tolerance : 0.49 * tolerance, distance = 0;
    taut_status status = TAUT_OK;

    do {
        if (!u->exact) {
            status = taut_nurbs_cut(whole, TAUT_ALONG_U, u, v, share, error);
        }
        if (status == TAUT_OK && !v->exact) {
            status = taut_nurbs_cut(whole, TAUT_ALONG_V, v, u, share, error);
        }
        if (status == TAUT_OK) {
            status = check_size(u, v, tolerance, error);
        }
        if (status == TAUT_OK) {
            status = taut_nurbs_prove(whole, u, v, &distance, error);
        }
        share *= 0.8;
    } while (status == TAUT_OK && !(distance <= tolerance));
    *bound = distance;
    return status;
}

/* The largest sum of |entries| over the rows of a change. */
static double row_norm(const taut_change *change)
{
    double largest = 0;
    for (int i = 0; i < taut_basis_count(change->to); i++) {
        double sum = 0;
        for (int a = 0; a < change->width; a++) {
            sum += fabs(taut_change_row(change, i)[a]);
        }
        largest = fmax(largest, sum);
    }
    return largest;
}

static double net_size(const taut_lattice *lattice)
{
    const size_t numbers = (size_t)lattice->count[0] * (size_t)lattice->count[1] * 3;
    double largest = 0;
    for (size_t i = 0; i < numbers; i++) {
        largest = fmax(largest, fabs(lattice->net[i]));
    }
    return largest;
}

static taut_status below_rounding(double tolerance, double least, taut_error *error)
{
    return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, tolerance, least,
                     "a distance of %g is below what rounding leaves; ask for a distance of %g at "
                     "least",
                     tolerance, least);
}

/* Rows sum to 1, so that no work is lost on tolerances far below what rounding leaves; and no sum
 * of the proof may overflow. */
static taut_status check_points(double size, double tolerance, taut_error *error)
{
    if (!(size <= POINTS_LARGEST)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/points", size, POINTS_LARGEST,
                         "coordinates of up to %g are too large to prove a distance; expected at "
                         "most %g: scale them",
                         size, POINTS_LARGEST);
    }
    return tolerance >= TAUT_ROUNDING * size
               ? TAUT_OK
               : below_rounding(tolerance, 4 * TAUT_ROUNDING * size, error);
}

static taut_status to_spline(const taut_nurbs_side *s, taut_change **change, taut_error *error)
{
    return s->basis == NULL
               ? TAUT_OK
               : s->basis->ops->changes->to_bspline(
                     s->basis, s->exact ? 0 : s->first[s->pieces.count], s->ends, change, error);
}

/* The splines of both sides, fine enough that distance and rounding stay below the tolerance. */
static taut_status find_changes(const taut_lattice *whole, taut_nurbs_side *u, taut_nurbs_side *v,
                                double tolerance, taut_change *changes[2], double *bound,
                                taut_error *error)
{
    const int exact = u->exact && v->exact;
    const double size = net_size(whole);
    double left = tolerance, rounding = 0;
    taut_status status = exact ? TAUT_OK : check_points(size, tolerance, error);

    *bound = 0;
    for (int attempt = 0; status == TAUT_OK; attempt++) {
        if (!exact) {
            status = divide_until(whole, u, v, left, bound, error);
        }
        if (status == TAUT_OK) {
            status = to_spline(u, &changes[0], error);
        }
        if (status == TAUT_OK) {
            status = to_spline(v, &changes[1], error);
        }
        if (status != TAUT_OK || exact) {
            break;
        }
        rounding = TAUT_ROUNDING * row_norm(changes[0]) *
                   (changes[1] != NULL ? row_norm(changes[1]) : 1) * size;
        if (*bound + rounding <= tolerance) {
            break;
        }
        if (!(rounding <= tolerance / 2) || attempt > 20) {
            status = below_rounding(tolerance, 2 * rounding, error);
            break;
        }
        left = tolerance - rounding; /* below *bound, so that there is progress */
        taut_change_free(changes[0]);
        taut_change_free(changes[1]);
        changes[0] = changes[1] = NULL;
    }
    *bound += rounding;
    return status;
}

static taut_status check_tolerance(double tolerance, taut_error *error)
{
    if (!(tolerance > 0) || !isfinite(tolerance)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, tolerance, 0,
                         "tolerance is %g, expected a positive number", tolerance);
    }
    return TAUT_OK;
}

/* Both sides begun, changes found; the caller frees sides and changes. */
static taut_status begin_and_find(const taut_lattice *whole, const taut_basis *u,
                                  const taut_basis *v, double tolerance, taut_change *changes[2],
                                  double *bound, taut_error *error)
{
    taut_nurbs_side sides[2] = {{.basis = NULL}, {.basis = NULL}};
    taut_status status = taut_nurbs_side_begin(u, &sides[0], error);

    if (status == TAUT_OK) {
        status = taut_nurbs_side_begin(v, &sides[1], error);
    }
    if (status == TAUT_OK) {
        status = find_changes(whole, &sides[0], &sides[1], tolerance, changes, bound, error);
    }
    taut_nurbs_side_free(&sides[0]);
    taut_nurbs_side_free(&sides[1]);
    return status;
}

/* Does a change leave every coefficient as it is? Then so it must stay, bit for bit: weights that
 * are multiplied in and divided out again would round. */
static int is_identity(const taut_change *change, const taut_basis *from)
{
    const int count = taut_basis_count(change->to);
    int is_same = count == taut_basis_count(from);
    for (int i = 0; is_same && i < count; i++) {
        for (int a = 0; a < change->width; a++) {
            is_same &= taut_change_row(change, i)[a] == (change->first[i] + a == i);
        }
    }
    return is_same;
}

taut_status taut_curve_to_nurbs(const taut_curve *curve, double tolerance, taut_curve **nurbs,
                                double *bound, taut_error *error)
{
    taut_lattice whole = {{0, 0}, 0, NULL};
    taut_change *changes[2] = {NULL, NULL};
    double proved = 0;
    taut_status status = TAUT_OK;

    if (curve == NULL || nurbs == NULL) {
        return taut_operate_null(error);
    }
    status = check_tolerance(tolerance, error);
    if (status == TAUT_OK) {
        status = taut_lattice_of_curve(curve, &whole, error);
    }
    if (status == TAUT_OK) {
        status =
            begin_and_find(&whole, taut_curve_t(curve), NULL, tolerance, changes, &proved, error);
    }
    if (status == TAUT_OK) {
        status =
            is_identity(changes[0], taut_curve_t(curve))
                ? taut_curve_new(taut_curve_name(curve), changes[0]->to, taut_curve_points(curve),
                                 taut_curve_weights(curve), nurbs, error)
                : taut_curve_changed(curve, changes[0], taut_curve_name(curve), nurbs, error);
    }
    if (status == TAUT_OK && bound != NULL) {
        *bound = proved;
    }
    taut_change_free(changes[0]);
    taut_lattice_free(&whole);
    return status;
}

/* whole -> along u -> along v -> surface. */
static taut_status apply_both(const taut_surface *surface, const taut_lattice *whole,
                              taut_change *changes[2], taut_surface **nurbs, taut_error *error)
{
    taut_lattice half = {{0, 0}, 0, NULL}, full = {{0, 0}, 0, NULL};
    taut_status status = TAUT_OK;

    if (is_identity(changes[0], taut_surface_u(surface)) &&
        is_identity(changes[1], taut_surface_v(surface))) {
        return taut_surface_new(taut_surface_name(surface), changes[0]->to, changes[1]->to,
                                taut_surface_points(surface), taut_surface_weights(surface), nurbs,
                                error);
    }
    status = taut_lattice_change(whole, TAUT_ALONG_U, changes[0], &half, error);
    if (status == TAUT_OK) {
        status = taut_lattice_change(&half, TAUT_ALONG_V, changes[1], &full, error);
    }
    if (status == TAUT_OK) {
        status = taut_lattice_to_surface(&full, taut_surface_name(surface), changes[0]->to,
                                         changes[1]->to, nurbs, error);
    }
    taut_lattice_free(&half);
    taut_lattice_free(&full);
    return status;
}

taut_status taut_surface_to_nurbs(const taut_surface *surface, double tolerance,
                                  taut_surface **nurbs, double *bound, taut_error *error)
{
    taut_lattice whole = {{0, 0}, 0, NULL};
    taut_change *changes[2] = {NULL, NULL};
    double proved = 0;
    taut_status status = TAUT_OK;

    if (surface == NULL || nurbs == NULL) {
        return taut_operate_null(error);
    }
    status = check_tolerance(tolerance, error);
    if (status == TAUT_OK) {
        status = taut_lattice_of_surface(surface, &whole, error);
    }
    if (status == TAUT_OK) {
        status = begin_and_find(&whole, taut_surface_u(surface), taut_surface_v(surface), tolerance,
                                changes, &proved, error);
    }
    if (status == TAUT_OK) {
        status = apply_both(surface, &whole, changes, nurbs, error);
    }
    if (status == TAUT_OK && bound != NULL) {
        *bound = proved;
    }
    taut_change_free(changes[0]);
    taut_change_free(changes[1]);
    taut_lattice_free(&whole);
    return status;
}
