/* cubic.c -- Algorithm 1 for degree 3 (docs page section 4.3).
 *
 * Corners, start legs and all weights are given. Each corner's tangent plane is known then, and
 * both inner points of an edge lie in the planes of its two ends:
 *     P_2 = P_1 + s d,   d the unit direction of the line common to the two planes.
 * All torsions are constants over s, so opposite torsions at the corners fix the ratios of the four
 * s; around a ring of curved edges the last corner closes or it does not, whatever s is. The energy
 * is a quadratic in the common scale: its minimum is the one stationary point.
 */
#include "construct/asymptotic/conditions.h"
#include "construct/asymptotic/corner_data.h"
#include "construct/asymptotic/family.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"

#include <string.h>

static const double plane_cut = 1e-9;     /* sine below which two corner planes count as one */
static const double closing_cut = 1e-9;   /* of a logarithm, as for degree 4 */
static const double straight_cut = 1e-12; /* sine between leg and chord: decimals' rounding */
static const double planar_cut = 1e-12;   /* relative: a torsion's numerator that is rounding */

typedef struct cubic_edge {
    double first[3], chord_end[3]; /* P_1 and P_3 */
    double direction[3];           /* d */
    double torsion[2];             /* s tau at the ends */
    double noise;                  /* of a torsion, relative: what rounding explains */
    double scale;                  /* s of this edge over the chain's */
    int chain, straight;
} cubic_edge;

typedef struct cubic {
    const double (*corners)[3]; /* those that are given */
    double legs[4][3];
    const taut_asymptotic_corners *given;
    cubic_edge edges[4];
    int linked[4], chains;
    double closing;  /* logarithm by which the ring misses closing */
    double rounding; /* of the corners' coordinates */
} cubic;

static void plane_normals(const cubic *c, double normals[4][3])
{
    /* the points before and beside each corner: first points of the edges that meet there */
    for (int k = 0; k < 4; k++) {
        double arms[2][3];
        for (int j = 0; j < 2; j++) {
            const taut_quad_meeting *const m = &taut_quad_corner[k][j];
            taut_difference(c->edges[m->edge].first, c->corners[k], arms[j]);
        }
        taut_cross(arms[0], arms[1], normals[k]);
    }
}

/* The leg, P_3 - P_1 and d in one plane: one of the two is along d, as both it and d lie in the two
 * tangent planes, and P_2 then leaves no height over that end's leg. */
static taut_status fail_planar(const cubic *c, int e, const double rest[3], taut_error *error)
{
    double cross[2][3], sine[2];
    taut_cross(c->legs[e], c->edges[e].direction, cross[0]);
    taut_cross(c->edges[e].direction, rest, cross[1]);
    sine[0] = taut_norm(cross[0]) / taut_norm(c->legs[e]);
    sine[1] = taut_norm(cross[1]) / taut_norm(rest);
    return taut_fail(
        error, TAUT_NO_SOLUTION, "cannot-bend", "/edges", fmin(sine[0], sine[1]), planar_cut,
        "edge %s cannot bend at corner %s: its first control point and that corner lie "
        "along the line common to the tangent planes at its ends; turn its leg or "
        "those it meets",
        taut_asymptotic_edge_name(e),
        taut_asymptotic_corner_name(taut_corner_of_edge[e][sine[0] > sine[1]]));
}

static taut_status fill_edge(cubic *c, int e, double normals[4][3], taut_error *error)
{
    cubic_edge *const edge = &c->edges[e];
    const double *const w = c->given->edges[e].weights;
    const double *const n0 = normals[taut_corner_of_edge[e][0]];
    const double *const n1 = normals[taut_corner_of_edge[e][1]];
    double rest[3], chord[3], cross[3], det = 0.0, sine = 0.0, reach = 0.0;
    taut_difference(edge->chord_end, edge->first, rest);
    taut_difference(edge->chord_end, c->corners[taut_corner_of_edge[e][0]], chord);
    taut_cross(c->legs[e], chord, cross);
    edge->straight = taut_norm(cross) <=
                     (straight_cut * taut_norm(chord) + 4 * c->rounding) * taut_norm(c->legs[e]);
    edge->torsion[0] = edge->torsion[1] = edge->noise = 0.0;
    taut_cross(n0, n1, edge->direction);
    sine = taut_norm(edge->direction) / (taut_norm(n0) * taut_norm(n1));
    if (edge->straight) { /* whatever the planes at its ends are */
        memcpy(edge->direction, chord, sizeof chord);
    } else if (!(sine > plane_cut)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "parallel-planes", "/edges", sine, plane_cut,
                         "the tangent planes at the two ends of edge %s are one plane (or "
                         "undefined): turn its leg or those it meets",
                         taut_asymptotic_edge_name(e));
    }
    reach = taut_norm(edge->direction);
    for (int k = 0; k < 3; k++) {
        edge->direction[k] /= reach;
    }
    if (edge->straight) {
        return TAUT_OK;
    }
    det = taut_det(c->legs[e], edge->direction, rest);
    if (!(fabs(det) > planar_cut * taut_norm(c->legs[e]) * taut_norm(rest))) {
        return fail_planar(c, e, rest, error);
    }
    taut_cross(c->legs[e], edge->direction, cross);
    edge->noise = taut_norm(cross) / fabs(det);
    det *= w[0] * w[3] / (3 * w[1] * w[2]);
    edge->torsion[0] = det / taut_dot(cross, cross);
    taut_cross(edge->direction, rest, cross);
    edge->noise = 32 * c->rounding * (edge->noise + 2 / taut_norm(cross));
    edge->torsion[1] = det / taut_dot(cross, cross);
    return TAUT_OK;
}

/* A straight edge asks for no torsion. */
static void fill_links(cubic *c)
{
    for (int k = 0; k < 4; k++) {
        const taut_quad_meeting *const m = taut_quad_corner[k];
        c->linked[k] = !c->edges[m[0].edge].straight && !c->edges[m[1].edge].straight;
    }
}

/* s_f = -s_e (torsion_f / torsion_e) along a tree of corners; what is left over is the closing
 * condition. */
static void propagate(cubic *c)
{
    int seen[4] = {0}, used[4] = {0};
    c->chains = 0;
    c->closing = 0.0;
    for (int root = 0; root < 4; root++) {
        int grew = !seen[root];
        if (seen[root]) {
            continue;
        }
        seen[root] = 1;
        c->edges[root].scale = 1.0;
        c->edges[root].chain = c->chains++;
        while (grew) {
            grew = 0;
            for (int k = 0; k < 4; k++) {
                const taut_quad_meeting *const m = taut_quad_corner[k];
                const int from = seen[m[0].edge] ? 0 : 1;
                cubic_edge *const e = &c->edges[m[from].edge];
                cubic_edge *const f = &c->edges[m[1 - from].edge];
                if (!c->linked[k] || seen[m[0].edge] == seen[m[1].edge]) {
                    continue;
                }
                f->scale = -e->scale * f->torsion[m[1 - from].end] / e->torsion[m[from].end];
                f->chain = e->chain;
                seen[m[1 - from].edge] = used[k] = grew = 1;
            }
        }
    }
    for (int k = 0; k < 4; k++) {
        const taut_quad_meeting *const m = taut_quad_corner[k];
        const cubic_edge *const e = &c->edges[m[0].edge], *const f = &c->edges[m[1].edge];
        if (c->linked[k] && !used[k]) {
            const double ratio =
                -(e->torsion[m[0].end] / e->scale) / (f->torsion[m[1].end] / f->scale);
            c->closing = taut_log(ratio); /* positive: an edge's two torsions have one sign */
        }
    }
}

/* Everything that follows from the legs. */
static taut_status fill_from_legs(cubic *c, taut_error *error)
{
    double normals[4][3];
    taut_status status = TAUT_OK;
    for (int e = 0; e < 4; e++) {
        const int *const ends = taut_corner_of_edge[e];
        memcpy(c->edges[e].first, c->corners[ends[0]], sizeof c->edges[e].first);
        taut_add_scaled(1.0, c->legs[e], c->edges[e].first);
        memcpy(c->edges[e].chord_end, c->corners[ends[1]], sizeof c->edges[e].chord_end);
    }
    plane_normals(c, normals);
    for (int e = 0; e < 4 && status == TAUT_OK; e++) {
        status = fill_edge(c, e, normals, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    fill_links(c);
    propagate(c);
    return TAUT_OK;
}

/* Legs of least relative change that close the ring: Newton steps of least norm. 0 if they fail. */
static int nearest_legs(cubic *c)
{
    for (int iteration = 0; iteration < 30; iteration++) {
        double gradient[4][3], squares = 0.0;
        const double miss = c->closing;
        if (fabs(miss) <= 1e-12) {
            return 1;
        }
        for (int e = 0; e < 4; e++) {
            for (int k = 0; k < 3; k++) {
                const double keep = c->legs[e][k], step = 1e-6 * taut_norm(c->legs[e]);
                c->legs[e][k] = keep + step;
                gradient[e][k] =
                    fill_from_legs(c, NULL) == TAUT_OK ? (c->closing - miss) / step : 0.0;
                c->legs[e][k] = keep;
                squares += gradient[e][k] * gradient[e][k] * taut_dot(c->legs[e], c->legs[e]);
            }
        }
        for (int e = 0; e < 4; e++) {
            const double part = -miss / squares * taut_dot(c->legs[e], c->legs[e]);
            taut_add_scaled(part, gradient[e], c->legs[e]);
        }
        if (!(squares > 0) || fill_from_legs(c, NULL) != TAUT_OK) {
            return 0;
        }
    }
    return 0;
}

static taut_status fail_closing(cubic *c, taut_error *error)
{
    const double gap = c->closing;
    if (!nearest_legs(c)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "closing", "/edges", gap, closing_cut,
                         "the torsions cannot close around the four corners: they miss it by a "
                         "factor of %.9g, which no weights and no free length repair; change the "
                         "legs",
                         taut_exp(gap));
    }
    return taut_fail(
        error, TAUT_NO_SOLUTION, "closing", "/edges", gap, closing_cut,
        "the torsions miss closing around the corners by a factor of %.12g; nearest "
        "legs: v0 [%.15g,%.15g,%.15g] v1 [%.15g,%.15g,%.15g] u0 [%.15g,%.15g,%.15g] u1 "
        "[%.15g,%.15g,%.15g]",
        taut_exp(gap), c->legs[0][0], c->legs[0][1], c->legs[0][2], c->legs[2][0], c->legs[2][1],
        c->legs[2][2], c->legs[1][0], c->legs[1][1], c->legs[1][2], c->legs[3][0], c->legs[3][1],
        c->legs[3][2]);
}

static void place_edge(const cubic *c, int e, double s, taut_quad_edge *made)
{
    const cubic_edge *const edge = &c->edges[e];
    memcpy(made->points[0], c->corners[taut_corner_of_edge[e][0]], sizeof made->points[0]);
    memcpy(made->points[1], edge->first, sizeof made->points[1]);
    memcpy(made->points[2], edge->first, sizeof made->points[2]);
    taut_add_scaled(s, edge->direction, made->points[2]);
    memcpy(made->points[3], edge->chord_end, sizeof made->points[3]);
    memcpy(made->weights, c->given->edges[e].weights, 4 * sizeof *made->weights);
    made->straight = edge->straight;
}

/* The scale of a chain at which its energy e_1 S + e_2 S^2 is least; 0 if it is degenerate. */
static double best_scale(const cubic *c, const taut_curve_rule *rule, int chain)
{
    double linear = 0.0, square = 0.0;
    for (int e = 0; e < 4; e++) {
        taut_quad_edge made;
        const double step = taut_distance(c->edges[e].first, c->edges[e].chord_end);
        double slope[2], by_point[TAUT_QUAD_POINTS][3], by_log[TAUT_QUAD_POINTS];
        if (c->edges[e].chain != chain) {
            continue;
        }
        for (int s = 0; s < 2; s++) {
            place_edge(c, e, s * step, &made);
            (void)taut_curve_energy(rule, &made, by_point, by_log);
            slope[s] = taut_dot(by_point[2], c->edges[e].direction);
        }
        linear += c->edges[e].scale * slope[0];
        square += c->edges[e].scale * c->edges[e].scale * (slope[1] - slope[0]) / step;
    }
    return -linear / square;
}

static taut_status find_lengths(const cubic *c, taut_branches *branches, taut_error *error)
{
    taut_curve_rule rule;
    taut_branch *const branch = &branches->list[0];
    double energy[4] = {0};
    taut_curve_rule_fill(3, TAUT_CURVE_FINE, &rule);
    memset(branch, 0, sizeof *branch);
    branch->quad.degree = 3;
    for (int e = 0; e < 4; e++) {
        const double scale = best_scale(c, &rule, c->edges[e].chain);
        const double s = c->edges[e].scale * scale;
        if (!isfinite(s) || !(fabs(s) > 0)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "no-minimum", "/edges", s, taut_none,
                             "the curve energy of edge %s has no minimum with a free length "
                             "that is not zero",
                             taut_asymptotic_edge_name(e));
        }
        place_edge(c, e, s, &branch->quad.edges[e]);
        energy[e] = taut_curve_energy(&rule, &branch->quad.edges[e], NULL, NULL);
    }
    branch->energy = energy[0] + energy[1] + energy[2] + energy[3];
    branch->found = 1;
    for (int e = 0; e < 4; e++) {
        branch->signs[e] = taut_quad_side(&branch->quad, e, 0);
    }
    branches->count = 1;
    branches->unknowns = c->chains;
    return TAUT_OK;
}

taut_status taut_cubic_find(const taut_asymptotic_corners *corners, double rounding,
                            taut_branches *branches, taut_error *error)
{
    cubic c;
    double noise = 0.0;
    taut_status status = TAUT_OK;
    memset(&c, 0, sizeof c);
    c.given = corners;
    c.rounding = rounding;
    c.corners = corners->points;
    for (int e = 0; e < 4; e++) {
        memcpy(c.legs[e], corners->edges[e].legs[0], sizeof c.legs[e]);
    }
    status = fill_from_legs(&c, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int e = 0; e < 4; e++) {
        noise += c.edges[e].noise;
    }
    if (!(fabs(c.closing) <= closing_cut + noise)) {
        return fail_closing(&c, error);
    }
    branches->closing = c.linked[0] && c.linked[1] && c.linked[2] && c.linked[3]
                            ? TAUT_CLOSING_IDENTITY
                            : TAUT_CLOSING_NONE;
    return find_lengths(&c, branches, error);
}
