/* edges.c -- edges that are points, that are closed, and that are one with another.
 *
 *     for each edge        its row of control points: all within the limit of the first? a point
 *     pairs at one place   by samples (mesh/seams), then proved: by their coefficients where the knots
 *                          are the same, else by those of their difference (measure/join)
 *     faces on top of each other, as a whole on its part, are not joined (samples)
 *     an edge in two pairs is in none: three faces at one edge make no shell
 *
 * A row of control points holds its curve in its convex hull ([Farin2002] 4.3; weights are positive):
 * what is said of points is said of the edge.
 */
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "measure/join/side.h"
#include "mesh/seams.h"
#include "shell/parts.h"

#include <float.h>
#include <math.h>

enum { FOLD_SAMPLES = 8, CROWDED = -2 };
static const double fold_angle = 1e-6; /* roundings of derivatives are far below */

/* The control points of one edge. */
typedef struct row {
    const double *first;
    const double *weights; /* NULL: all 1 */
    size_t step, weight_step;
    int count;
    const taut_basis *basis;
} row;

static row row_of(const taut_surface *surface, int edge)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const size_t nu = (size_t)taut_basis_count(u), nv = (size_t)taut_basis_count(v);
    const int along_v = edge % 4 == TAUT_EDGE_U0 || edge % 4 == TAUT_EDGE_U1;
    const size_t first = edge % 4 == TAUT_EDGE_U1   ? (nu - 1) * nv
                         : edge % 4 == TAUT_EDGE_V1 ? nv - 1
                                                    : 0;
    const double *weights = taut_surface_weights(surface);
    return (row){.first = taut_surface_points(surface) + 3 * first,
                 .weights = weights != NULL ? weights + first : NULL,
                 .step = along_v ? 3 : 3 * nv,
                 .weight_step = along_v ? 1 : nv,
                 .count = (int)(along_v ? nv : nu),
                 .basis = along_v ? v : u};
}

static const double *point_of(const row *r, int i)
{
    return r->first + (size_t)i * r->step;
}

static double weight_of(const row *r, int i)
{
    return r->weights != NULL ? r->weights[(size_t)i * r->weight_step] : 1;
}

static int is_point(const row *points, double limit)
{
    int i = 1;
    while (i < points->count && taut_distance(points->first, point_of(points, i)) <= limit) {
        i++;
    }
    return i == points->count;
}

static int is_loop(const row *points, double limit)
{
    return taut_distance(points->first, point_of(points, points->count - 1)) <= limit;
}

/* What a gap may be, seen from one surface: as taut/join.h says. */
static double limit_of(const taut_surface *surface)
{
    const double *points = taut_surface_points(surface);
    return taut_join_tolerance * 2 * taut_half_size(taut_point_count(surface), points) +
           16 * DBL_EPSILON * taut_largest_coordinate(points);
}

/* Are the knots of b those of a, from the other end where `reversed`, or moved, to the last bit? */
static int have_same_knots(const row *a, const row *b, int reversed)
{
    taut_basis_spec sa, sb;
    taut_basis_spec_of(a->basis, &sa);
    taut_basis_spec_of(b->basis, &sb);
    if (sa.degree != sb.degree || sa.knot_count != sb.knot_count) {
        return 0;
    }
    const int last = sa.knot_count - 1;
    const int bezier = sa.knot_count == 2 * (sa.degree + 1);
    int same = 1;
    for (int k = 0; k <= last && same && !bezier; k++) {
        const double from_a = sa.knots[k] - sa.knots[0];
        const double from_b =
            reversed ? sb.knots[last] - sb.knots[last - k] : sb.knots[k] - sb.knots[0];
        same = from_a == from_b;
    }
    return same;
}

/* The distance of two edges on the same knots, by their coefficients: with points that differ by e at
 * most, and weights by a common factor but for a share d,
 *     | sum R_i P_i - sum S_i Q_i | <= e + max |R_i / S_i - 1| max |Q_i - Q_0|,
 *     | R_i / S_i - 1 | <= 2 d / (1 - d)
 * and a few roundings; NaN where the knots differ, or the weights by too much. */
static double coefficient_gap(const row *a, const row *b, int reversed)
{
    double apart = 0, reach = 0, largest = 0, share = 0;
    const double factor = weight_of(b, reversed ? b->count - 1 : 0) / weight_of(a, 0);
    if (!have_same_knots(a, b, reversed)) {
        return nan("");
    }
    for (int i = 0; i < a->count; i++) {
        const int j = reversed ? b->count - 1 - i : i;
        apart = fmax(apart, taut_distance(point_of(a, i), point_of(b, j)));
        reach = fmax(reach, taut_distance(point_of(b, 0), point_of(b, j)));
        largest = fmax(largest, taut_largest_coordinate(point_of(b, j)));
        share = fmax(share, fabs(weight_of(b, j) / (weight_of(a, i) * factor) - 1));
    }
    share += 4 * DBL_EPSILON;
    return share < 1e-6 ? apart + 2 * share / (1 - share) * reach + 8 * DBL_EPSILON * largest
                        : nan("");
}

/* The unit vector across edge 4 f + e at a share of its range, into the surface and square to the
 * edge; 0 where there is none. */
static int inward(const taut_surface *surface, int edge, double share, double w[3])
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const int held = edge % 4 >= 2, high = edge % 2; /* u0 u1 hold u, v0 v1 hold v */
    double at[2], values[9];
    for (int d = 0; d < 2; d++) {
        const double lo = taut_basis_lo(bases[d]), hi = taut_basis_hi(bases[d]);
        const double part = d == held ? high : share;
        at[d] = part < 1 ? fmin(hi, lo + (hi - lo) * part) : hi;
    }
    if (taut_surface_eval(surface, at[0], at[1], 1, values) != TAUT_OK) {
        return 0;
    }
    const double *across = values + 3 * (1 + held), *along = values + 3 * (2 - held);
    const double square = taut_dot(along, along);
    for (int c = 0; c < 3; c++) {
        w[c] = (high ? -1 : 1) *
               (across[c] - (square > 0 ? taut_dot(across, along) / square * along[c] : 0));
    }
    const double length = taut_length(w);
    for (int c = 0; c < 3 && length > 0; c++) {
        w[c] /= length;
    }
    return length > 0;
}

/* Do both surfaces go the same way from their common edge, all along it? Then one lies on the other
 * there, as a whole on its part: an angle of 0 is no body's edge. */
static int is_fold(const taut_surface *a, int edge_a, const taut_surface *b, int edge_b,
                   int reversed)
{
    int same = 0, seen = 0;
    for (int k = 1; k < FOLD_SAMPLES; k++) {
        const double share = (double)k / FOLD_SAMPLES;
        double wa[3], wb[3];
        if (inward(a, edge_a, share, wa) && inward(b, edge_b, reversed ? 1 - share : share, wb)) {
            seen++;
            same += taut_length_between(wa, wb) < fold_angle;
        }
    }
    return seen > 0 && same == seen;
}

/* The proved distance of two edges, by their coefficients or by those of their difference; NaN where
 * there is no proof. */
static taut_status prove_gap(const taut_surface *a, int edge_a, const taut_surface *b, int edge_b,
                             int reversed, double *gap)
{
    const row row_a = row_of(a, edge_a), row_b = row_of(b, edge_b);
    *gap = coefficient_gap(&row_a, &row_b, reversed);
    return isnan(*gap) ? taut_join_gap(a, (taut_edge)(edge_a % 4), b, (taut_edge)(edge_b % 4),
                                       reversed, gap)
                       : TAUT_OK;
}

/* Proves the pairs; those that hold are linked, and an edge in two of them is crowded from then on. */
static taut_status link_pairs(const taut_surface *const *surfaces, const taut_seam *seams,
                              int seam_count, const double *limits, double moved,
                              taut_shell_joints *joints)
{
    for (int s = 0; s < seam_count; s++) {
        const int a = seams[s].b, b = seams[s].a; /* a < b: the first gives the curve */
        const double limit = fmax(fmax(limits[a / 4], limits[b / 4]), 2 * moved);
        double gap = 0;
        if (joints->pole[a] || joints->pole[b]) {
            continue;
        }
        const taut_status status =
            prove_gap(surfaces[a / 4], a, surfaces[b / 4], b, seams[s].reversed, &gap);
        if (status != TAUT_OK) {
            return status;
        }
        if (!(gap <= limit) || is_fold(surfaces[a / 4], a, surfaces[b / 4], b, seams[s].reversed)) {
            continue;
        }
        for (int end = 0; end < 2; end++) {
            const int edge = end == 0 ? a : b;
            joints->partner[edge] = joints->partner[edge] != -1 ? CROWDED : end == 0 ? b : a;
            joints->reversed[edge] = (unsigned char)(seams[s].reversed != 0);
            joints->gap[edge] = gap;
        }
    }
    return TAUT_OK;
}

/* An edge that is crowded, or whose partner is, has none. */
static void part_crowds(int edges, int *partner)
{
    for (int e = 0; e < edges; e++) {
        if (partner[e] < 0 || partner[partner[e]] != e) {
            partner[e] = -1;
        }
    }
}

taut_status taut_shell_join_edges(const taut_surface *const *surfaces, int count, double moved,
                                  taut_arena *arena, taut_shell_joints *joints)
{
    const size_t edges = 4 * (size_t)count;
    double *limits = taut_arena_take(arena, (size_t)count, sizeof *limits);
    unsigned char *collapsed = NULL;
    taut_seam *seams = NULL;
    int seam_count = 0;
    double widest = 2 * moved;

    joints->pole = taut_arena_take(arena, edges, 1);
    joints->loop = taut_arena_take(arena, edges, 1);
    joints->partner = taut_arena_take(arena, edges, sizeof *joints->partner);
    joints->reversed = taut_arena_take(arena, edges, 1);
    joints->gap = taut_arena_take(arena, edges, sizeof *joints->gap);
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int f = 0; f < count; f++) {
        limits[f] = limit_of(surfaces[f]);
        widest = fmax(widest, limits[f]);
    }
    for (size_t e = 0; e < edges; e++) {
        const row points = row_of(surfaces[e / 4], (int)(e % 4));
        joints->partner[e] = -1;
        joints->pole[e] = (unsigned char)is_point(&points, limits[e / 4]);
        joints->loop[e] = (unsigned char)is_loop(&points, limits[e / 4]);
    }
    if (!(widest < 1e134)) {
        return TAUT_OK; /* from coordinates of 1e148 on squares of lengths would be none: each face stands alone */
    }
    taut_status status =
        taut_seams_find(surfaces, count, widest, 0, arena, &seams, &seam_count, &collapsed);
    if (status == TAUT_OK) {
        status = link_pairs(surfaces, seams, seam_count, limits, moved, joints);
    }
    part_crowds((int)edges, joints->partner);
    return status;
}
