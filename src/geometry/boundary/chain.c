/* chain.c -- curves of any number, kinks and all, as the four sides of a boundary.
 *
 * Each curve is cut where it has a kink, the pieces are put in a row, each beginning where the one before it ends, and
 * joined between the four sharpest corners of the loop. Pieces come on one degree; the joined parameter runs about with
 * the length; a rational piece is scaled to begin with the weight that the one before it ends with.
 */
#include "core/arena.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/boundary/boundary.h"
#include "geometry/keep.h"
#include "taut/operations.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { PIECES_MAX = 5000 };
static const double kink = 1e-6;       /* an angle below this is none */
static const double told_apart = 1e-3; /* the fourth corner is so much sharper than the fifth */

/* A piece between kinks, and its turn to the next one in the row. */
typedef struct piece {
    const taut_curve *curve;
    double ends[2][3], along[2][3]; /* along: unit tangents */
    double angle;
} piece;

typedef struct chain {
    taut_arena *arena;
    piece *pieces;
    int count, room;
    double size;
} chain;

static taut_status keep(chain *c, taut_curve *curve, taut_error *error)
{
    if (c->count == PIECES_MAX) {
        taut_curve_free(curve);
        return taut_fail(error, TAUT_BAD_INPUT, "size", NULL, c->count, PIECES_MAX,
                         "the curves have more than %d pieces between kinks", PIECES_MAX);
    }
    if (c->count == c->room) {
        const int room = c->room > 0 ? 2 * c->room : 64;
        piece *more = taut_arena_take(c->arena, (size_t)room, sizeof *more);
        if (more == NULL) {
            taut_curve_free(curve);
            return taut_fail_memory(error);
        }
        if (c->count > 0) {
            memcpy(more, c->pieces, (size_t)c->count * sizeof *more);
        }
        c->pieces = more;
        c->room = room;
    }
    if (!taut_keep_curve(c->arena, curve)) {
        return taut_fail_memory(error);
    }
    c->pieces[c->count++] = (piece){.curve = curve};
    return TAUT_OK;
}

/* The tangent at an end: to the next control point that is elsewhere. */
static void find_ends(piece *p)
{
    const int count = taut_basis_count(taut_curve_t(p->curve));
    const double *points = taut_curve_points(p->curve);
    for (int end = 0; end < 2; end++) {
        const double *at = points + (end == 0 ? 0 : 3 * (count - 1));
        double way[3] = {0, 0, 0};
        memcpy(p->ends[end], at, sizeof p->ends[end]);
        for (int i = 1; i < count && taut_norm(way) == 0; i++) {
            const double *next = at + (end == 0 ? 3 * i : -3 * i);
            taut_difference(end == 0 ? next : at, end == 0 ? at : next, way);
        }
        const double length = taut_norm(way);
        for (int k = 0; k < 3; k++) {
            p->along[end][k] = length > 0 ? way[k] / length : 0;
        }
    }
}

static double angle_between(const double a[3], const double b[3])
{
    double across[3];
    taut_cross(a, b, across);
    return taut_atan2(taut_norm(across), taut_dot(a, b));
}

/* Does the curve turn at control point i, where two pieces meet? */
static int turns_at(const taut_curve *curve, int i, double angle)
{
    const double *p = taut_curve_points(curve) + 3 * (ptrdiff_t)i;
    double before[3], after[3];
    taut_difference(p, p - 3, before);
    taut_difference(p + 3, p, after);
    return angle_between(before, after) > angle;
}

double taut_boundary_first_kink(const taut_curve *curve, double angle)
{
    const taut_basis *t = taut_curve_t(curve);
    taut_basis_spec spec;
    taut_basis_spec_of(t, &spec);
    const int p = spec.degree, n = strcmp(spec.type, "bspline") == 0 ? taut_basis_count(t) : 0;
    for (int i = p + 1; i + p - 1 < n; i++) {
        if (spec.knots[i] == spec.knots[i + p - 1] && turns_at(curve, i - 1, angle)) {
            return spec.knots[i];
        }
    }
    return nan("");
}

int taut_boundary_closes_smoothly(const taut_curve *closed, double angle)
{
    piece whole = {.curve = closed};
    find_ends(&whole);
    return angle_between(whole.along[1], whole.along[0]) <= angle;
}

int taut_boundary_is_smooth(const taut_curve *closed, double angle)
{
    return taut_boundary_closes_smoothly(closed, angle) &&
           isnan(taut_boundary_first_kink(closed, angle));
}

/* A half of a curve, under the curve's own name. */
static taut_status copy_half(const taut_model *halves, int which, const char *name,
                             taut_curve **copy, taut_error *error)
{
    const taut_curve *half = taut_model_curve(halves, which);
    return taut_curve_new(name, taut_curve_t(half), taut_curve_points(half),
                          taut_curve_weights(half), copy, error);
}

/* Cuts a spline, the caller's until then, at all its kinks. */
static taut_status add_spline(chain *c, const char *name, taut_curve *spline, taut_error *error)
{
    for (;;) {
        const double t = taut_boundary_first_kink(spline, kink);
        taut_model *halves = NULL;
        taut_curve *low = NULL, *high = NULL;
        if (isnan(t)) {
            return keep(c, spline, error);
        }
        taut_status status = taut_curve_split(spline, t, &halves, error);
        taut_curve_free(spline);
        if (status != TAUT_OK) {
            return status;
        }
        status = copy_half(halves, 0, name, &low, error);
        status = status == TAUT_OK ? copy_half(halves, 1, name, &high, error) : status;
        taut_model_free(halves);
        if (status != TAUT_OK) {
            taut_curve_free(low);
            return status;
        }
        status = keep(c, low, error);
        if (status != TAUT_OK) {
            taut_curve_free(high);
            return status;
        }
        spline = high;
    }
}

static taut_status add_curve(chain *c, const taut_curve *curve, taut_error *error)
{
    taut_curve *spline = NULL;
    if (taut_basis_degree(taut_curve_t(curve)) < 1) {
        return taut_fail(error, TAUT_NO_SOLUTION, "bases-differ", NULL, taut_none, taut_none,
                         "a curve \"%.40s\" of type %s is not joined to others: give four curves, "
                         "or convert it to a B-spline",
                         taut_curve_name(curve), taut_basis_type(taut_curve_t(curve)));
    }
    const taut_status status = taut_curve_to_nurbs(curve, 1, &spline, NULL, error);
    return status == TAUT_OK ? add_spline(c, taut_curve_name(curve), spline, error) : status;
}

static double find_size(const chain *c)
{
    double lo[3] = {INFINITY, INFINITY, INFINITY}, hi[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < c->count; i++) {
        const double *points = taut_curve_points(c->pieces[i].curve);
        for (int k = 0; k < 3 * taut_basis_count(taut_curve_t(c->pieces[i].curve)); k++) {
            lo[k % 3] = fmin(lo[k % 3], points[k]);
            hi[k % 3] = fmax(hi[k % 3], points[k]);
        }
    }
    return taut_length_between(lo, hi);
}

static taut_status turn_piece(chain *c, piece *p, taut_error *error)
{
    taut_curve *turned = NULL;
    const taut_status status = taut_curve_reverse(p->curve, &turned, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (!taut_keep_curve(c->arena, turned)) {
        return taut_fail_memory(error);
    }
    p->curve = turned;
    find_ends(p);
    return TAUT_OK;
}

static taut_status fail_gap(const piece *from, double gap, double limit, taut_error *error)
{
    return taut_fail(
        error, TAUT_NO_SOLUTION, "gap", NULL, gap, limit,
        "the curves do not close: a gap of %.3g is left after \"%.40s\" at (%.6g, %.6g, "
        "%.6g), more than %.3g",
        gap, taut_curve_name(from->curve), from->ends[1][0], from->ends[1][1], from->ends[1][2],
        limit);
}

/* The pieces in a row: behind each the nearest end of those that are left. */
static taut_status put_in_row(chain *c, double tolerance, taut_error *error)
{
    const double limit = tolerance * c->size;
    for (int i = 0; i + 1 < c->count; i++) {
        int nearest = i + 1, turned = 0;
        double least = INFINITY;
        for (int j = i + 1; j < c->count; j++) {
            for (int end = 0; end < 2; end++) {
                const double gap =
                    taut_length_between(c->pieces[i].ends[1], c->pieces[j].ends[end]);
                if (gap < least) {
                    least = gap;
                    nearest = j;
                    turned = end;
                }
            }
        }
        if (!(least <= limit)) {
            return fail_gap(&c->pieces[i], least, limit, error);
        }
        const piece next = c->pieces[nearest];
        c->pieces[nearest] = c->pieces[i + 1];
        c->pieces[i + 1] = next;
        if (turned) {
            const taut_status status = turn_piece(c, &c->pieces[i + 1], error);
            if (status != TAUT_OK) {
                return status;
            }
        }
    }
    const piece *last = &c->pieces[c->count - 1];
    const double gap = taut_length_between(last->ends[1], c->pieces[0].ends[0]);
    return gap <= limit ? TAUT_OK : fail_gap(last, gap, limit, error);
}

/* Marks the pieces that a side ends with: those before the four sharpest corners. */
static taut_status find_corners(chain *c, int last[TAUT_SIDES], taut_error *error)
{
    int found = 0;
    double least = INFINITY, fifth = 0;
    for (int i = 0; i < c->count; i++) {
        c->pieces[i].angle =
            angle_between(c->pieces[i].along[1], c->pieces[(i + 1) % c->count].along[0]);
        found += c->pieces[i].angle > kink;
    }
    if (found < TAUT_SIDES) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", NULL, found, TAUT_SIDES,
                         "the curves make a loop of %d corners, expected %d at least: say where "
                         "the corners are by four curves, or take `film`, which spans closed "
                         "curves and loops of three corners",
                         found, TAUT_SIDES);
    }
    for (int s = 0; s < TAUT_SIDES; s++) {
        int sharpest = -1;
        for (int i = 0; i < c->count; i++) {
            int taken = 0;
            for (int k = 0; k < s; k++) {
                taken = taken || last[k] == i;
            }
            if (!taken && (sharpest < 0 || c->pieces[i].angle > c->pieces[sharpest].angle)) {
                sharpest = i;
            }
        }
        last[s] = sharpest;
        least = fmin(least, c->pieces[sharpest].angle);
    }
    for (int i = 0; i < c->count; i++) {
        const int taken = i == last[0] || i == last[1] || i == last[2] || i == last[3];
        fifth = taken ? fifth : fmax(fifth, c->pieces[i].angle);
    }
    if (!(least >= fifth * (1 + told_apart))) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", NULL, found, TAUT_SIDES,
                         "the curves make a loop of %d corners, of which no four are sharper than "
                         "the others: say where the corners are by four curves",
                         found);
    }
    return TAUT_OK;
}

/* A side under way. */
typedef struct side {
    int degree, rational;
    size_t count, room;
    double *points, *weights, *knots;
} side;

static double length_of(const taut_curve *curve)
{
    const double *p = taut_curve_points(curve);
    const int count = taut_basis_count(taut_curve_t(curve));
    double length = 0;
    for (int i = 1; i < count; i++) {
        length += taut_distance(p + 3 * (ptrdiff_t)i, p + 3 * (ptrdiff_t)i - 3);
    }
    return 0.5 * length + 0.5 * taut_distance(p, p + 3 * (ptrdiff_t)(count - 1));
}

/* Adds a piece of the side's degree. */
static void add_piece(side *s, const taut_curve *curve)
{
    taut_basis_spec spec;
    taut_basis_spec_of(taut_curve_t(curve), &spec);
    const size_t count = (size_t)taut_basis_count(taut_curve_t(curve)), p = (size_t)s->degree;
    const double *w = taut_curve_weights(curve);
    const double lo = spec.knots[0], hi = spec.knots[count];
    const double from = s->count > 0 ? s->knots[s->count] : 0;
    const double scale = length_of(curve) / (hi - lo);
    const double by = s->count > 0 ? s->weights[s->count - 1] / (w != NULL ? w[0] : 1) : 1;
    const size_t first = s->count > 0; /* the point that both have is there */
    const size_t base = s->count > 0 ? s->count - 1 : 0;
    for (size_t i = first; i < count; i++) {
        memcpy(s->points + 3 * (base + i), taut_curve_points(curve) + 3 * i, 3 * sizeof(double));
        s->weights[base + i] = by * (w != NULL ? w[i] : 1);
    }
    for (size_t i = s->count > 0 ? p + 1 : 0; i < count + p + 1; i++) {
        s->knots[base + i] = from + scale * (spec.knots[i] - lo);
    }
    s->count = base + count;
}

/* Degree and room of the pieces from `from` on, `count` of them; degrees made equal. */
static taut_status begin_side(chain *c, int from, int count, side *s, taut_error *error)
{
    *s = (side){.degree = 1};
    for (int k = 0; k < count; k++) {
        const taut_curve *curve = c->pieces[(from + k) % c->count].curve;
        const int degree = taut_basis_degree(taut_curve_t(curve));
        s->degree = degree > s->degree ? degree : s->degree;
        s->rational = s->rational || taut_curve_weights(curve) != NULL;
    }
    for (int k = 0; k < count; k++) {
        piece *p = &c->pieces[(from + k) % c->count];
        const int times = s->degree - taut_basis_degree(taut_curve_t(p->curve));
        taut_curve *raised = NULL;
        const taut_status status = taut_curve_elevate(p->curve, times, &raised, error);
        if (status != TAUT_OK) {
            return status;
        }
        if (!taut_keep_curve(c->arena, raised)) {
            return taut_fail_memory(error);
        }
        p->curve = raised;
        s->room += (size_t)taut_basis_count(taut_curve_t(raised));
    }
    s->points = taut_arena_take(c->arena, 3 * s->room, sizeof *s->points);
    s->weights = taut_arena_take(c->arena, s->room, sizeof *s->weights);
    s->knots = taut_arena_take(c->arena, s->room + (size_t)s->degree + 1, sizeof *s->knots);
    return s->points != NULL && s->weights != NULL && s->knots != NULL ? TAUT_OK
                                                                       : taut_fail_memory(error);
}

static taut_status join_side(chain *c, int from, int count, taut_curve **made, taut_error *error)
{
    taut_basis *t = NULL;
    side s;
    taut_status status = begin_side(c, from, count, &s, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int k = 0; k < count; k++) {
        add_piece(&s, c->pieces[(from + k) % c->count].curve);
    }
    const taut_basis_spec spec = {.type = "bspline",
                                  .degree = s.degree,
                                  .knot_count = (int)s.count + s.degree + 1,
                                  .knots = s.knots};
    status = taut_basis_new(&spec, (int)s.count, &t, error);
    if (status == TAUT_OK) {
        status = taut_curve_new(taut_curve_name(c->pieces[from].curve), t, s.points,
                                s.rational ? s.weights : NULL, made, error);
    }
    taut_basis_free(t);
    return status;
}

static taut_status join_sides(chain *c, int count, const taut_curve *const *curves,
                              double tolerance, taut_curve *joined[TAUT_SIDES], taut_error *error)
{
    int last[TAUT_SIDES] = {0}, ends[TAUT_SIDES] = {0}, n = 0;
    taut_status status = TAUT_OK;
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        status = add_curve(c, curves[i], error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    for (int i = 0; i < c->count; i++) {
        find_ends(&c->pieces[i]);
    }
    c->size = find_size(c);
    status = put_in_row(c, tolerance, error);
    if (status == TAUT_OK) {
        status = find_corners(c, last, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    for (int i = 0; i < c->count; i++) { /* in the order of the row */
        for (int s = 0; s < TAUT_SIDES; s++) {
            if (last[s] == i) {
                ends[n++] = i;
            }
        }
    }
    for (int s = 0; s < TAUT_SIDES && status == TAUT_OK; s++) {
        const int from = (ends[(s + TAUT_SIDES - 1) % TAUT_SIDES] + 1) % c->count;
        const int pieces = (ends[s] - from + c->count) % c->count + 1;
        status = join_side(c, from, pieces, &joined[s], error);
    }
    return status;
}

taut_status taut_boundary_join(int count, const taut_curve *const *curves, double tolerance,
                               taut_curve *joined[TAUT_SIDES], taut_error *error)
{
    chain c = {.arena = taut_arena_new()};
    taut_curve *made[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    const taut_status status = join_sides(&c, count, curves, tolerance, made, error);
    taut_arena_free(c.arena);
    if (status != TAUT_OK) {
        taut_boundary_free(made);
        return status;
    }
    memcpy(joined, made, sizeof made);
    return TAUT_OK;
}

taut_status taut_boundary_link(const taut_curve *first, const taut_curve *second,
                               taut_curve **linked, taut_error *error)
{
    chain c = {.arena = taut_arena_new()};
    taut_status status = add_curve(&c, first, error);
    if (status == TAUT_OK) {
        status = add_curve(&c, second, error);
    }
    if (status == TAUT_OK) {
        status = join_side(&c, 0, c.count, linked, error);
    }
    taut_arena_free(c.arena);
    return status;
}
