/* sweep.c -- the polynomials of a surface that goes along an axis.
 *
 * The axis over a span of the surface comes of its Bezier points by blossoms: with A[lo..hi] the
 * coefficients on [lo, hi],
 *
 *     A_k = blossom(lo, .. n - k times, hi, .. k times)
 *
 * ([Farin2002] section 4.4), each level a convex combination whose rounding is counted.
 */
#include "certify/pipe/sweep.h"
#include "certify/common/verdict.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

static const double unit = TAUT_UNIT_ROUNDOFF;

static int exponent_of(const taut_pipe_sweep *sweep)
{
    return ilogb(sweep->parts->line.scale);
}

double taut_pipe_longest(const taut_field f[3])
{
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        const double most = taut_field_largest(&f[k]);
        sum += most * most;
    }
    return sqrt(sum) * (1 + 8 * unit);
}

int taut_pipe_sweep_derive(taut_arena *arena, taut_pipe_sweep *sweep)
{
    int is_finite = 1;
    for (int order = 1; order < 4; order++) {
        for (int k = 0; k < 3; k++) {
            sweep->axis[order][k] = taut_field_du(arena, &sweep->axis[order - 1][k]);
        }
    }
    for (int order = 0; order < 4; order++) {
        sweep->most[order] = taut_pipe_longest(sweep->axis[order]);
        is_finite = is_finite && isfinite(sweep->most[order]);
    }
    return is_finite;
}

/* Points of four as those of the quartic ([WangBai2018] section 2.2):
 *     Q_1 = ((1 - alpha) V_0 + (3 + alpha) V_1) / 4,  Q_2 = ((3 + beta) V_1 + (3 - beta) V_2) / 6,
 *     Q_3 = ((3 + gamma) V_2 + (1 - gamma) V_3) / 4. */
static void quartic_of(taut_arena *arena, const double v[4], const double e[4],
                       const taut_basis_spec *spec, taut_field *out)
{
    const double first[3] = {1 - spec->alpha, 3 + spec->beta, 3 + spec->gamma};
    const double second[3] = {3 + spec->alpha, 3 - spec->beta, 1 - spec->gamma};
    *out = taut_field_new(arena, 4, 0);
    if (out->a == NULL) {
        return;
    }
    for (int side = 0; side < 2; side++) {
        out->a[4 * side] = v[3 * side];
        out->e[4 * side] = e[3 * side];
    }
    for (int i = 0; i < 3; i++) {
        const double parts = i == 1 ? 6 : 4;
        out->a[i + 1] = (first[i] * v[i] + second[i] * v[i + 1]) / parts;
        out->e[i + 1] = (fabs(first[i]) * (e[i] + 6 * unit * fabs(v[i])) +
                         fabs(second[i]) * (e[i + 1] + 6 * unit * fabs(v[i + 1]))) /
                        parts * (1 + 16 * unit);
    }
}

void taut_pipe_sweep_curve(taut_arena *arena, const taut_curve *curve, taut_pipe_sweep *sweep)
{
    const taut_pipe_line *line = &sweep->parts->line;
    const double *points = taut_curve_points(curve);
    taut_basis_spec spec;
    taut_field x[4];

    if (strcmp(taut_basis_type(taut_curve_t(curve)), "ce-bezier") != 0) {
        if (taut_basis_degree(taut_curve_t(curve)) >= 0 &&
            taut_basis_span_count(taut_curve_t(curve)) == 1 && taut_curve_weights(curve) == NULL &&
            taut_field_of_curve(arena, curve, 0, line->origin, exponent_of(sweep), x, NULL)) {
            memcpy(sweep->axis[0], x, sizeof sweep->axis[0]);
        }
        return;
    }
    taut_basis_spec_of(taut_curve_t(curve), &spec);
    for (int k = 0; k < 3; k++) {
        double v[4], e[4];
        for (int i = 0; i < 4; i++) {
            v[i] = (points[3 * i + k] - line->origin[k]) / line->scale;
            e[i] = unit * fabs(v[i]);
        }
        quartic_of(arena, v, e, &spec, &sweep->axis[0][k]);
    }
}

/* The unit direction of either end of the axis comes of two points of it, each rounded where it was
 * moved to the origin. */
static double tangent_error(const taut_pipe_line *line, int side)
{
    const taut_pipe_piece *piece = &line->pieces[side == 0 ? 0 : line->count - 1];
    const double *a = piece->points[side == 0 ? 0 : piece->degree - 1];
    const double *b = piece->points[side == 0 ? 1 : piece->degree];
    return (8 + 8 * (taut_norm(a) + taut_norm(b)) / taut_distance(a, b)) * unit;
}

void taut_pipe_sweep_line(taut_arena *arena, int side, double length, taut_pipe_sweep *sweep)
{
    const taut_pipe_line *line = &sweep->parts->line;
    const taut_pipe_piece *piece = &line->pieces[side == 0 ? 0 : line->count - 1];
    const double *joint = piece->points[side == 0 ? 0 : piece->degree];
    const double error = tangent_error(line, side);
    for (int k = 0; k < 3; k++) {
        const double way = length * line->tangent[side][k];
        taut_field *const f = &sweep->axis[0][k];
        *f = taut_field_new(arena, 1, 0);
        if (f->a == NULL) {
            return;
        }
        f->a[0] = side == 0 ? joint[k] - way : joint[k];
        f->a[1] = side == 0 ? joint[k] : joint[k] + way;
        f->e[0] = f->e[1] = 2 * unit * fabs(joint[k]);
        f->e[side] += length * error + 2 * unit * fabs(way);
    }
}

/* r = r_0 + (r_1 - r_0) t^2 (3 - 2 t), with the quintic t^3 (10 - 15 t + 6 t^2): by coefficients
 * the first half of them is r_0 and the second r_1. */
void taut_pipe_sweep_radii(taut_arena *arena, taut_pipe_sweep *sweep)
{
    const taut_pipe_parts *parts = sweep->parts;
    const int degree = parts->quintic ? 5 : 3;
    const double scale = parts->line.scale;
    taut_field r = taut_field_new(arena, degree, 0);
    for (int i = 0; i <= degree && r.a != NULL; i++) {
        r.a[i] = parts->ellipses[2 * i > degree].a / scale;
        r.e[i] = unit * r.a[i];
    }
    const taut_field slope = taut_field_du(arena, &r), square = taut_field_product(arena, &r, &r);
    const taut_field none = taut_field_constant(arena, 0);
    sweep->changes = 1;
    sweep->rate = taut_field_largest(&slope);
    sweep->half[0] = taut_field_combine(arena, 0.5, &square, 0, &none);
    for (int order = 1; order < 4; order++) {
        sweep->half[order] = taut_field_du(arena, &sweep->half[order - 1]);
    }
    sweep->half_most[0] = taut_field_largest(&sweep->half[2]);
    sweep->half_most[1] = taut_field_largest(&sweep->half[3]);
}

/* f on [lo, hi], 0 <= lo < hi <= 1. */
static taut_field cut_field(taut_arena *arena, const taut_field *f, double lo, double hi)
{
    double a[TAUT_PIPE_PIECE_DEGREE + 1], e[TAUT_PIPE_PIECE_DEGREE + 1];
    taut_field out = {0, 0, NULL, NULL};
    if ((lo == 0 && hi == 1) || f->a == NULL || f->p > TAUT_PIPE_PIECE_DEGREE) {
        return f->p > TAUT_PIPE_PIECE_DEGREE ? out : *f;
    }
    out = taut_field_new(arena, f->p, 0);
    for (int k = 0; k <= f->p && out.a != NULL; k++) {
        memcpy(a, f->a, ((size_t)f->p + 1) * sizeof *a);
        memcpy(e, f->e, ((size_t)f->p + 1) * sizeof *e);
        for (int level = 0; level < f->p; level++) {
            const double t = level < f->p - k ? lo : hi;
            for (int i = 0; i < f->p - level; i++) {
                const double x = (1 - t) * a[i], y = t * a[i + 1];
                e[i] = ((1 - t) * e[i] + t * e[i + 1] + 4 * unit * (fabs(x) + fabs(y))) *
                       (1 + 16 * unit);
                a[i] = x + y;
            }
        }
        out.a[k] = a[0];
        out.e[k] = e[0];
    }
    return out;
}

/* Where u is between the ends of the basis; exactly so on [0, 1]. */
static double part_of(const taut_basis *basis, double u)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    return u == hi ? 1 : (u - lo) / (hi - lo);
}

/* What rounding of the parameter moves a field by. */
static void add_shift(taut_field *f, double most)
{
    for (int i = 0; i <= f->p && f->a != NULL; i++) {
        f->e[i] += 4 * unit * most;
    }
}

const taut_pipe_patch *taut_pipe_patch_place(const taut_pipe_sweep *sweep, int i, int j,
                                             taut_pipe_patch *patch)
{
    memcpy(patch->u, taut_basis_breaks(taut_surface_u(sweep->surface)) + i, sizeof patch->u);
    memcpy(patch->v, taut_basis_breaks(taut_surface_v(sweep->surface)) + j, sizeof patch->v);
    return patch;
}

int taut_pipe_patch_of(taut_arena *arena, const taut_pipe_sweep *sweep, int i, int j,
                       taut_pipe_patch *patch)
{
    const taut_basis *u = taut_surface_u(sweep->surface), *v = taut_surface_v(sweep->surface);
    const double lo = part_of(u, taut_basis_breaks(u)[i]);
    const double hi = part_of(u, taut_basis_breaks(u)[i + 1]);
    const int is_unit = taut_basis_lo(u) == 0 && taut_basis_hi(u) == 1;
    taut_field x[4], at[3];

    if (taut_basis_degree(u) < 0 || taut_basis_degree(v) < 0 ||
        !taut_field_of_surface(arena, sweep->surface, i, j, sweep->parts->line.origin,
                               exponent_of(sweep), x, NULL)) {
        return 0;
    }
    patch->w = x[3];
    for (int k = 0; k < 3; k++) {
        at[k] = cut_field(arena, &sweep->axis[0][k], lo, hi);
        patch->first[k] = cut_field(arena, &sweep->axis[1][k], lo, hi);
        patch->second[k] = cut_field(arena, &sweep->axis[2][k], lo, hi);
        if (!is_unit) {
            at[k] = taut_field_copy(arena, &at[k]);
            add_shift(&at[k], sweep->most[1]);
        }
        const taut_field moved = taut_field_product(arena, &x[3], &at[k]);
        patch->way[k] = taut_field_difference(arena, &x[k], &moved);
    }
    memset(patch->half, 0, sizeof patch->half);
    for (int k = 0; k < 3 && sweep->changes; k++) {
        const taut_field part = cut_field(arena, &sweep->half[k], lo, hi);
        patch->half[k] = taut_field_copy(arena, &part);
        if (!is_unit) {
            add_shift(&patch->half[k], taut_field_largest(&sweep->half[k + 1]));
        }
    }
    taut_pipe_patch_place(sweep, i, j, patch);
    return 1;
}

void taut_pipe_patch_halve(taut_arena *arena, const taut_pipe_patch *patch, int direction,
                           taut_pipe_patch halves[2])
{
    halves[0] = halves[1] = *patch;
    for (int k = 0; k < 3; k++) {
        taut_field_halve(arena, &patch->way[k], direction, &halves[0].way[k], &halves[1].way[k]);
        if (direction == 0) {
            taut_field_halve(arena, &patch->first[k], 0, &halves[0].first[k], &halves[1].first[k]);
            taut_field_halve(arena, &patch->second[k], 0, &halves[0].second[k],
                             &halves[1].second[k]);
        }
    }
    taut_field_halve(arena, &patch->w, direction, &halves[0].w, &halves[1].w);
    for (int k = 0; k < 3 && direction == 0 && patch->half[0].a != NULL; k++) {
        taut_field_halve(arena, &patch->half[k], 0, &halves[0].half[k], &halves[1].half[k]);
    }
    if (direction == 0) {
        halves[0].u[1] = halves[1].u[0] = 0.5 * (patch->u[0] + patch->u[1]);
    } else {
        halves[0].v[1] = halves[1].v[0] = 0.5 * (patch->v[0] + patch->v[1]);
    }
}

/* A piece of a ring: w R and P' of its plane. */
typedef struct ring_piece {
    taut_field way[3], w;
    double first[3];
} ring_piece;

/* The angle about P' from one end of the piece to the other, where all of it lies in one half plane
 * through the axis; else halved. NaN: not found. */
static double swept_angle(taut_arena *arena, const ring_piece *piece, int depth)
{
    enum { HALVINGS = 10 };
    const double along = taut_dot(piece->first, piece->first);
    double a[3], b[3], middle[3], across[3];
    taut_field side = taut_field_constant(arena, 0);
    ring_piece halves[2] = {*piece, *piece};
    double sum = 0;

    for (int k = 0; k < 3; k++) {
        if (piece->way[k].a == NULL) {
            return NAN;
        }
        a[k] = piece->way[k].a[0];
        b[k] = piece->way[k].a[piece->way[k].p];
        middle[k] = taut_field_value(&piece->way[k], 0.5, 0);
    }
    taut_add_scaled(-taut_dot(middle, piece->first) / along, piece->first, middle);
    for (int k = 0; k < 3; k++) {
        side = taut_field_combine(arena, 1, &side, middle[k], &piece->way[k]);
    }
    if (taut_field_low(&side) > 0 && taut_field_low(&piece->w) > 0) {
        taut_add_scaled(-taut_dot(a, piece->first) / along, piece->first, a);
        taut_add_scaled(-taut_dot(b, piece->first) / along, piece->first, b);
        taut_cross(a, b, across);
        return taut_atan2(taut_dot(across, piece->first) / sqrt(along), taut_dot(a, b));
    }
    if (depth == HALVINGS) {
        return NAN;
    }
    for (int k = 0; k < 3; k++) {
        taut_field_halve(arena, &piece->way[k], 0, &halves[0].way[k], &halves[1].way[k]);
    }
    taut_field_halve(arena, &piece->w, 0, &halves[0].w, &halves[1].w);
    for (int k = 0; k < 2; k++) {
        sum += swept_angle(arena, &halves[k], depth + 1);
    }
    return sum;
}

int taut_pipe_winding(taut_arena *arena, const taut_pipe_sweep *sweep, taut_pipe_cover *cover)
{
    const int spans = taut_basis_span_count(taut_surface_v(sweep->surface));
    double angle = 0, turns = 0;
    for (int j = 0; j < spans && isfinite(angle); j++) {
        taut_pipe_patch patch;
        ring_piece piece;
        if (!taut_pipe_patch_of(arena, sweep, 0, j, &patch)) {
            angle = NAN;
        } else {
            for (int k = 0; k < 3; k++) {
                piece.way[k] = taut_field_edge(arena, &patch.way[k], 0);
                piece.first[k] = patch.first[k].a != NULL ? patch.first[k].a[0] : NAN;
            }
            piece.w = taut_field_edge(arena, &patch.w, 0);
            angle += swept_angle(arena, &piece, 0);
        }
    }
    turns = angle / (2 * TAUT_PI);
    if (!isfinite(turns)) {
        cover->open = "how often a ring goes around the axis is not decided";
        return 0;
    }
    if (!(fabs(fabs(turns) - 1) < 1e-3)) { /* what does not close is told as a gap */
        cover->fault = "a ring does not go around the axis once";
        return 0;
    }
    return turns > 0 ? 1 : -1;
}

/* Are the first and the last point of every ring the same, bit for bit? */
static int is_closed_exactly(const taut_surface *surface)
{
    const int nu = taut_basis_count(taut_surface_u(surface));
    const int nv = taut_basis_count(taut_surface_v(surface));
    const double *points = taut_surface_points(surface), *weights = taut_surface_weights(surface);
    for (int i = 0; i < nu; i++) {
        const size_t first = (size_t)i * (size_t)nv, last = first + (size_t)nv - 1;
        for (size_t k = 0; k < 3; k++) {
            if (points[3 * first + k] != points[3 * last + k]) {
                return 0;
            }
        }
        if (weights != NULL && weights[first] != weights[last]) {
            return 0;
        }
    }
    return 1;
}

/* |X_0 w_1 - X_1 w_0| / (w_0 w_1), at most, along one span of the edges v0 and v1. */
static double edge_gap(taut_arena *arena, const taut_pipe_patch *low, const taut_pipe_patch *high)
{
    taut_field w[2] = {taut_field_edge(arena, &low->w, 2), taut_field_edge(arena, &high->w, 3)};
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        const taut_field a = taut_field_edge(arena, &low->way[k], 2);
        const taut_field b = taut_field_edge(arena, &high->way[k], 3);
        const taut_field x = taut_field_product(arena, &a, &w[1]);
        const taut_field y = taut_field_product(arena, &b, &w[0]);
        const taut_field apart = taut_field_difference(arena, &x, &y);
        const double most = taut_field_largest(&apart);
        sum += most * most;
    }
    const double least[2] = {taut_field_low(&w[0]), taut_field_low(&w[1])};
    return least[0] > 0 && least[1] > 0 ? sqrt(sum) / (least[0] * least[1]) : NAN;
}

double taut_pipe_ring_gap(taut_arena *arena, const taut_pipe_sweep *sweep)
{
    const taut_basis *u = taut_surface_u(sweep->surface), *v = taut_surface_v(sweep->surface);
    double gap = 0;
    if (is_closed_exactly(sweep->surface)) {
        return 0;
    }
    for (int i = 0; i < taut_basis_span_count(u); i++) {
        taut_pipe_patch low, high;
        gap = taut_certify_max(
            gap, taut_pipe_patch_of(arena, sweep, i, 0, &low) &&
                         taut_pipe_patch_of(arena, sweep, i, taut_basis_span_count(v) - 1, &high)
                     ? edge_gap(arena, &low, &high)
                     : NAN);
    }
    return gap / sweep->radius;
}
