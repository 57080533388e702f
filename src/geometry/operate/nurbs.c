/* nurbs.c -- NURBS within a proved tolerance: as many spans as the proof wants. */
#include "taut/operations.h"

#include "core/fail.h"
#include "geometry/exponent.h"
#include "geometry/lattice.h"
#include "geometry/nurbs/proof.h"
#include "geometry/operate/change.h"

#include <math.h>

/* What a conversion works with, and frees. */
typedef struct conversion {
    taut_lattice whole;
    taut_nurbs_side sides[2];
    taut_change *changes[2];
    double bound; /* proved, rounding included */
} conversion;

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
        return taut_fail(error, TAUT_NO_SOLUTION, "too-many-points", NULL, rows * columns,
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
    double share = u->exact || v->exact ? tolerance : 0.49 * tolerance;

    do {
        taut_status status = TAUT_OK;
        if (!u->exact) {
            status = taut_nurbs_cut(whole, TAUT_ALONG_U, u, v, share, error);
        }
        if (status == TAUT_OK && !v->exact) {
            status = taut_nurbs_cut(whole, TAUT_ALONG_V, v, u, share, error);
        }
        if (status != TAUT_OK) {
            return status;
        }
        status = check_size(u, v, tolerance, error);
        if (status != TAUT_OK) {
            return status;
        }
        status = taut_nurbs_prove(whole, u, v, bound, error);
        if (status != TAUT_OK) {
            return status;
        }
        share *= 0.8;
    } while (!(*bound <= tolerance));
    return TAUT_OK;
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

static taut_status below_rounding(double tolerance, double least, taut_error *error)
{
    return taut_fail(error, TAUT_BAD_ARGUMENT, "tolerance", NULL, tolerance, least,
                     "a distance of %g is below what rounding leaves; ask for a distance of %g at "
                     "least",
                     tolerance, least);
}

/* Rows sum to 1, so that no work is lost on tolerances far below what rounding leaves; and no sum
 * of the proof may overflow. */
static taut_status check_points(double size, double tolerance, taut_error *error)
{
    if (!(size <= POINTS_LARGEST)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "too-large", "/points", size, POINTS_LARGEST,
                         "coordinates of up to %g are too large to prove a distance; expected at "
                         "most %g: scale them",
                         size, POINTS_LARGEST);
    }
    return tolerance >= TAUT_ROUNDING * size
               ? TAUT_OK
               : below_rounding(tolerance, 4 * TAUT_ROUNDING * size, error);
}

/* The changes to the splines of both sides; those there were are freed. */
static taut_status find_splines(conversion *c, taut_error *error)
{
    for (int d = 0; d < 2; d++) {
        const taut_nurbs_side *s = &c->sides[d];
        const int spans = s->exact ? 0 : s->first[s->pieces.count];
        taut_change_free(c->changes[d]);
        c->changes[d] = NULL;
        if (s->basis == NULL) {
            continue;
        }
        const taut_status status =
            s->basis->ops->changes->to_bspline(s->basis, spans, s->ends, &c->changes[d], error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    return TAUT_OK;
}

/* The splines of both sides, fine enough that distance and rounding stay below the tolerance. */
static taut_status find_changes(conversion *c, double tolerance, taut_error *error)
{
    taut_nurbs_side *u = &c->sides[0], *v = &c->sides[1];
    const double size =
        taut_largest((size_t)c->whole.count[0] * (size_t)c->whole.count[1], c->whole.net);
    double left = tolerance;
    taut_status status = TAUT_OK;

    if (u->exact && v->exact) {
        return find_splines(c, error);
    }
    status = check_points(size, tolerance, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int attempt = 0;; attempt++) {
        status = divide_until(&c->whole, u, v, left, &c->bound, error);
        if (status != TAUT_OK) {
            return status;
        }
        status = find_splines(c, error);
        if (status != TAUT_OK) {
            return status;
        }
        const double rounding = TAUT_ROUNDING * row_norm(c->changes[0]) *
                                (c->changes[1] != NULL ? row_norm(c->changes[1]) : 1) * size;
        if (c->bound + rounding <= tolerance) {
            c->bound += rounding;
            return TAUT_OK;
        }
        if (!(rounding <= tolerance / 2) || attempt > 20) {
            return below_rounding(tolerance, 2 * rounding, error);
        }
        left = tolerance - rounding; /* below the bound, so that there is progress */
    }
}

static taut_status check_tolerance(double tolerance, taut_error *error)
{
    if (!(tolerance > 0) || !isfinite(tolerance)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "tolerance", NULL, tolerance, 0,
                         "tolerance is %g, expected a positive number", tolerance);
    }
    return TAUT_OK;
}

/* From the lattice to the changes, for the bases u and v (NULL: a curve). */
static taut_status begin_and_find(conversion *c, const taut_basis *u, const taut_basis *v,
                                  double tolerance, taut_error *error)
{
    taut_status status = taut_nurbs_side_begin(u, &c->sides[0], error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_nurbs_side_begin(v, &c->sides[1], error);
    return status == TAUT_OK ? find_changes(c, tolerance, error) : status;
}

static void clear_conversion(conversion *c)
{
    for (int d = 0; d < 2; d++) {
        taut_nurbs_side_free(&c->sides[d]);
        taut_change_free(c->changes[d]);
    }
    taut_lattice_free(&c->whole);
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

static taut_status convert_curve(conversion *c, const taut_curve *curve, double tolerance,
                                 taut_curve **nurbs, taut_error *error)
{
    const char *name = taut_curve_name(curve);
    taut_status status = taut_lattice_of_curve(curve, &c->whole, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = begin_and_find(c, taut_curve_t(curve), NULL, tolerance, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (is_identity(c->changes[0], taut_curve_t(curve))) {
        return taut_curve_new(name, c->changes[0]->to, taut_curve_points(curve),
                              taut_curve_weights(curve), nurbs, error);
    }
    return taut_curve_changed(curve, c->changes[0], name, nurbs, error);
}

taut_status taut_curve_to_nurbs(const taut_curve *curve, double tolerance, taut_curve **nurbs,
                                double *bound, taut_error *error)
{
    conversion c = {.bound = 0};
    taut_status status = TAUT_OK;

    if (curve == NULL || nurbs == NULL) {
        return taut_operate_null(error);
    }
    status = check_tolerance(tolerance, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = convert_curve(&c, curve, tolerance, nurbs, error);
    if (status == TAUT_OK && bound != NULL) {
        *bound = c.bound;
    }
    clear_conversion(&c);
    return status;
}

/* whole -> along u -> along v -> surface. */
static taut_status apply_both(const taut_surface *surface, const taut_lattice *whole,
                              taut_change *const changes[2], taut_surface **nurbs,
                              taut_error *error)
{
    const char *name = taut_surface_name(surface);
    taut_lattice half, full;
    taut_status status = TAUT_OK;

    if (is_identity(changes[0], taut_surface_u(surface)) &&
        is_identity(changes[1], taut_surface_v(surface))) {
        return taut_surface_new(name, changes[0]->to, changes[1]->to, taut_surface_points(surface),
                                taut_surface_weights(surface), nurbs, error);
    }
    status = taut_lattice_change(whole, TAUT_ALONG_U, changes[0], &half, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_lattice_change(&half, TAUT_ALONG_V, changes[1], &full, error);
    taut_lattice_free(&half);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_lattice_into_surface(&full, name, changes[0]->to, changes[1]->to, nurbs, error);
}

static taut_status convert_surface(conversion *c, const taut_surface *surface, double tolerance,
                                   taut_surface **nurbs, taut_error *error)
{
    taut_status status = taut_lattice_of_surface(surface, &c->whole, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = begin_and_find(c, taut_surface_u(surface), taut_surface_v(surface), tolerance, error);
    return status == TAUT_OK ? apply_both(surface, &c->whole, c->changes, nurbs, error) : status;
}

taut_status taut_surface_to_nurbs(const taut_surface *surface, double tolerance,
                                  taut_surface **nurbs, double *bound, taut_error *error)
{
    conversion c = {.bound = 0};
    taut_status status = TAUT_OK;

    if (surface == NULL || nurbs == NULL) {
        return taut_operate_null(error);
    }
    status = check_tolerance(tolerance, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = convert_surface(&c, surface, tolerance, nurbs, error);
    if (status == TAUT_OK && bound != NULL) {
        *bound = c.bound;
    }
    clear_conversion(&c);
    return status;
}
