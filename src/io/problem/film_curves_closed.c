/* film_curves_closed.c -- see film_curves_closed.h.
 *
 *     sample each curve; take a circle for what lies on one, once around
 *     turn the second about as the first: the sum of x_i x x_(i+1) along the same way
 *     let a circle begin where the other curve does, as seen from its centre
 */
#include "io/problem/film_curves_closed.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/arc.h"
#include "geometry/boundary/boundary.h"
#include "geometry/keep.h"
#include "taut/operations.h"

#include <math.h>
#include <string.h>

enum { SAMPLES = 96 };               /* a multiple of 3 */
static const double closed = 1e-9;   /* the widest gap, of the size */
static const double smooth = 1e-3;   /* the largest turn at a knot */
static const double circular = 1e-9; /* what a circle may be off, of its radius */

typedef struct around {
    const taut_curve *curve;
    double points[SAMPLES + 1][3]; /* the last is the first */
    double centre[3];              /* of the circle, else of the samples */
    double normal[3], radius;      /* of the circle */
    int is_circle;
} around;

static double size_of(const taut_curve *curve)
{
    const double *points = taut_curve_points(curve);
    double size = 0;
    for (int i = 1; i < taut_basis_count(taut_curve_t(curve)); i++) {
        size = fmax(size, taut_distance(points, points + 3 * (ptrdiff_t)i));
    }
    return size;
}

static void sample(around *a)
{
    const taut_basis *t = taut_curve_t(a->curve);
    const double lo = taut_basis_lo(t), hi = taut_basis_hi(t);
    memset(a->centre, 0, sizeof a->centre);
    for (int i = 0; i < SAMPLES; i++) {
        (void)taut_curve_eval(a->curve, lo + (hi - lo) * i / SAMPLES, 0, a->points[i]);
        taut_add_scaled(1.0 / SAMPLES, a->points[i], a->centre);
    }
    memcpy(a->points[SAMPLES], a->points[0], sizeof a->points[0]);
}

static int ends_meet(const taut_curve *curve)
{
    const taut_basis *t = taut_curve_t(curve);
    double first[3], last[3];
    (void)taut_curve_eval(curve, taut_basis_lo(t), 0, first);
    (void)taut_curve_eval(curve, taut_basis_hi(t), 0, last);
    return taut_distance(first, last) <= closed * size_of(curve);
}

int taut_film_curve_is_closed(const taut_curve *curve)
{
    return ends_meet(curve) && taut_boundary_is_smooth(curve, smooth);
}

/* The part of a curve before t, and what is left; the arena owns both. */
static taut_status cut_off(taut_arena *arena, double t, const taut_curve **part,
                           const taut_curve **left, taut_error *error)
{
    taut_model *halves = NULL;
    const taut_status status = taut_curve_split(*left, t, &halves, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (!taut_keep_model(arena, halves)) {
        return taut_fail_memory(error);
    }
    *part = taut_model_curve(halves, 0);
    *left = taut_model_curve(halves, 1);
    return TAUT_OK;
}

/* *curve follows what is left of the curve that it began. */
static taut_status link_to(taut_arena *arena, const taut_curve *left, const taut_curve **curve,
                           taut_error *error)
{
    taut_curve *made = NULL;
    const taut_status status = taut_boundary_link(left, *curve, &made, error);
    if (status == TAUT_OK && !taut_keep_curve(arena, made)) {
        return taut_fail_memory(error);
    }
    *curve = status == TAUT_OK ? made : *curve;
    return status;
}

taut_status taut_film_curve_cut(taut_arena *arena, const taut_curve *curve, int most,
                                const taut_curve **pieces, int *count, taut_error *error)
{
    const taut_curve *left = curve;
    taut_status status = TAUT_OK;
    double kink = taut_boundary_first_kink(left, smooth);
    int n = 0;

    *count = 0;
    if (!ends_meet(curve)) {
        return TAUT_OK;
    }
    while (status == TAUT_OK && !isnan(kink) && n < most) {
        status = cut_off(arena, kink, &pieces[n++], &left, error);
        kink = taut_boundary_first_kink(left, smooth);
    }
    const int begins_within =
        taut_boundary_closes_smoothly(curve, smooth); /* an edge, in no corner */
    if (status != TAUT_OK || !isnan(kink) || n == 0 || n + !begins_within > most) {
        return status;
    }
    if (begins_within) {
        status = link_to(arena, left, &pieces[0], error);
    } else {
        pieces[n++] = left;
    }
    *count = status == TAUT_OK ? n : 0;
    return status;
}

/* The circle through three points; 0 where they are on a line. */
static int circle_through(const double p[3], const double q[3], const double r[3], double centre[3],
                          double normal[3])
{
    double a[3], b[3], n[3], across_a[3], across_b[3];
    taut_difference(q, p, a);
    taut_difference(r, p, b);
    taut_cross(a, b, n);
    const double nn = taut_dot(n, n), aa = taut_dot(a, a), bb = taut_dot(b, b);
    if (!(nn > 1e-12 * aa * bb)) {
        return 0;
    }
    taut_cross(n, a, across_a);
    taut_cross(b, n, across_b);
    for (int c = 0; c < 3; c++) {
        centre[c] = p[c] + (bb * across_a[c] + aa * across_b[c]) / (2 * nn);
        normal[c] = n[c] / sqrt(nn);
    }
    return 1;
}

/* Do all samples lie on one circle, one after the other, and once around? */
static void find_circle(around *a)
{
    double centre[3], normal[3], turned = 0;
    a->is_circle = 0;
    if (!circle_through(a->points[0], a->points[SAMPLES / 3], a->points[2 * SAMPLES / 3], centre,
                        normal)) {
        return;
    }
    const double radius = taut_distance(a->points[0], centre);
    for (int i = 0; i < SAMPLES; i++) {
        double from[3], to[3], across[3];
        taut_difference(a->points[i], centre, from);
        taut_difference(a->points[i + 1], centre, to);
        taut_cross(from, to, across);
        const double step = taut_atan2(taut_dot(across, normal), taut_dot(from, to));
        if (!(fabs(taut_norm(from) - radius) <= circular * radius) ||
            !(fabs(taut_dot(from, normal)) <= circular * radius) || !(step > 0)) {
            return;
        }
        turned += step;
    }
    if (turned < 3 * TAUT_PI) {
        memcpy(a->centre, centre, sizeof centre);
        memcpy(a->normal, normal, sizeof normal);
        a->radius = radius;
        a->is_circle = 1;
    }
}

/* Twice the area that it goes around, as a vector. */
static void area_of(const around *a, double area[3])
{
    memset(area, 0, 3 * sizeof *area);
    for (int i = 0; i < SAMPLES; i++) {
        double from[3], to[3], across[3];
        taut_difference(a->points[i], a->centre, from);
        taut_difference(a->points[i + 1], a->centre, to);
        taut_cross(from, to, across);
        taut_add_scaled(1, across, area);
    }
}

static taut_status keep(taut_arena *arena, taut_status status, taut_curve *made, around *a,
                        taut_error *error)
{
    if (status == TAUT_OK && !taut_keep_curve(arena, made)) {
        status = taut_fail_memory(error);
    }
    a->curve = status == TAUT_OK ? made : a->curve;
    return status;
}

/* Both about the same way round. */
static taut_status turn_alike(taut_arena *arena, around a[2], taut_error *error)
{
    double areas[2][3];
    taut_curve *made = NULL;
    area_of(&a[0], areas[0]);
    area_of(&a[1], areas[1]);
    if (taut_dot(areas[0], areas[1]) >= 0) {
        return TAUT_OK;
    }
    taut_status status = taut_curve_reverse(a[1].curve, &made, error);
    status = keep(arena, status, made, &a[1], error);
    if (status == TAUT_OK) {
        sample(&a[1]);
        find_circle(&a[1]);
    }
    return status;
}

/* As a circle with equal angles, which begins towards `from`, or, where that is no direction in its plane, where it did. */
static taut_status make_circle(taut_arena *arena, const around *beside, around *a,
                               taut_error *error)
{
    double way[3];
    taut_curve *made = NULL;
    taut_difference(beside->points[0], beside->centre, way);
    taut_status status = taut_circle_new(a->centre, a->normal, a->radius, way, &made);
    if (status == TAUT_NO_SOLUTION) {
        taut_difference(a->points[0], a->centre, way);
        status = taut_circle_new(a->centre, a->normal, a->radius, way, &made);
    }
    return keep(arena, status == TAUT_OK ? status : taut_fail_memory(error), made, a, error);
}

static taut_status make_bases(taut_arena *arena, const taut_basis_spec *spec,
                              taut_film_problem *data, taut_error *error)
{
    const int least = 2 * spec->degree + 1;
    taut_basis_spec about = *spec;
    taut_basis *u = NULL, *v = NULL;
    about.count = 2 * spec->count > least ? 2 * spec->count : least;
    taut_status status = taut_basis_new(&about, about.count, &u, error);
    if (status == TAUT_OK && !taut_keep_basis(arena, u)) {
        return taut_fail_memory(error);
    }
    status = status == TAUT_OK ? taut_basis_new(spec, spec->count, &v, error) : status;
    if (status == TAUT_OK && !taut_keep_basis(arena, v)) {
        return taut_fail_memory(error);
    }
    data->u = u;
    data->v = v;
    return status;
}

static taut_status note(taut_problem *problem, int count, int circles, taut_error *error)
{
    taut_status status = TAUT_OK;
    if (count == 1) {
        status = taut_problem_note(problem, "one closed curve: the film closes in a pole, v1");
    }
    if (status == TAUT_OK && circles > 0) {
        status = taut_problem_note(
            problem, circles == 2 ? "both curves are circles, run with equal angles"
                     : count == 2 ? "one of the curves is a circle, run with equal angles"
                                  : "the curve is a circle, run with equal angles");
    }
    return status == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

taut_status taut_film_curves_around(taut_problem *problem, int count, const taut_curve **curves,
                                    const taut_basis_spec *spec, taut_film_problem *data,
                                    taut_error *error)
{
    around a[2] = {{.curve = curves[0]}, {.curve = curves[count - 1]}};
    taut_status status = TAUT_OK;
    int circles = 0;

    for (int k = 0; k < count; k++) {
        sample(&a[k]);
        find_circle(&a[k]);
        circles += a[k].is_circle;
    }
    status = count == 2 ? turn_alike(problem->arena, a, error) : status;
    for (int k = 0; status == TAUT_OK && k < count; k++) {
        const around *beside = count == 2 && (k == 1 || !a[1].is_circle) ? &a[1 - k] : &a[k];
        if (a[k].is_circle) {
            status = make_circle(problem->arena, beside, &a[k], error);
        }
    }
    status = status == TAUT_OK ? make_bases(problem->arena, spec, data, error) : status;
    status = status == TAUT_OK ? note(problem, count, circles, error) : status;
    data->ring = TAUT_FILM_RING_U;
    data->edges[2] = (taut_film_edge){.kind = TAUT_FILM_FIXED, .curve = a[0].curve};
    data->edges[3] = count == 2 ? (taut_film_edge){.kind = TAUT_FILM_FIXED, .curve = a[1].curve}
                                : (taut_film_edge){.kind = TAUT_FILM_POLE};
    return status;
}
