#include "construct/film/flat.h"

#include "construct/film/arc.h"
#include "construct/film/equilibrium.h"
#include "construct/film/polygon.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double flat_share = 1e-12; /* of the size: a corner in the plane of the others */

typedef struct quad {
    taut_film_arc sides[4];
    int edges[4]; /* of the film */
    taut_film_polygon polygon;
} quad;

/* The largest of the four triangles' normals. */
static void find_normal(const double *const corner[4], double n[3])
{
    memset(n, 0, 3 * sizeof(double));
    for (int k = 0; k < 4; k++) {
        double a[3], b[3], normal[3];
        taut_difference(corner[(k + 1) % 4], corner[k], a);
        taut_difference(corner[(k + 2) % 4], corner[k], b);
        taut_cross(a, b, normal);
        if (taut_dot(normal, normal) > taut_dot(n, n)) {
            memcpy(n, normal, sizeof normal);
        }
    }
}

/* The corners in their own plane, over size 1, in the order in which the sides run round the sail;
 * 0 where they do not lie in one. */
static int lay_flat(const taut_film_space *space, double flat[4][2])
{
    static const int round[4] = {0, 1, 3, 2}; /* u0v0, u1v0, u1v1, u0v1 */
    const size_t last_u = (size_t)(space->nu - 1) * (size_t)space->nv,
                 last_v = (size_t)space->nv - 1;
    const double *corner[4] = {space->start, space->start + 3 * last_u, space->start + 3 * last_v,
                               space->start + 3 * (last_u + last_v)};
    double n[3], e[2][3];

    find_normal(corner, n);
    const double size = taut_norm(n);
    taut_difference(corner[1], corner[0], e[0]);
    const double side_length = taut_norm(e[0]);
    if (!(size > flat_share) || !(side_length > 0)) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        n[c] /= size;
        e[0][c] /= side_length;
    }
    taut_cross(n, e[0], e[1]);
    for (int k = 0; k < 4; k++) {
        double x[3];
        taut_difference(corner[round[k]], corner[0], x);
        if (fabs(taut_dot(x, n)) > flat_share) {
            return 0;
        }
        flat[k][0] = taut_dot(x, e[0]);
        flat[k][1] = taut_dot(x, e[1]);
    }
    return 1;
}

static int has_curves(const taut_film_problem *problem)
{
    return problem->edges[0].curve != NULL || problem->edges[1].curve != NULL ||
           problem->edges[2].curve != NULL || problem->edges[3].curve != NULL;
}

/* Are the arcs of all cables known? */
static int has_arcs(const taut_film_space *space)
{
    for (int e = 0; e < 4; e++) {
        if (space->ratios[e] > 0 && !space->is_arc[e]) {
            return 0;
        }
    }
    return 1;
}

static void make_polygon(const taut_film_space *space, double flat[4][2], quad *q)
{
    static const int edge_of[2][4] = {{2, 1, 3, 0}, {0, 3, 1, 2}}; /* as they run round */
    double area = 0;

    for (int k = 0; k < 4; k++) {
        const double *one = flat[k], *next = flat[(k + 1) % 4];
        area += 0.5 * (one[0] * next[1] - one[1] * next[0]);
    }
    for (int k = 0; k < 4; k++) {
        /* the other way round where the sail lies on the right */
        const int turned = area < 0, from = turned ? (4 - k) % 4 : k;
        const int to = turned ? (from + 3) % 4 : (from + 1) % 4;
        q->edges[k] = edge_of[turned][k];
        taut_film_arc_set(&q->sides[k], flat[from], flat[to], space->ratios[q->edges[k]]);
    }
    q->polygon = (taut_film_polygon){.count = 4, .sides = q->sides};
}

static taut_status refuse_weak(const taut_film_space *space, quad *q, taut_error *error)
{
    const double factor = taut_film_polygon_factor(&q->polygon);
    char where[32], given[64] = "";
    int e = -1;

    for (int k = 0; e < 0 && k < 4; k++) {
        e = space->ratios[k] > 0 ? k : -1;
    }
    const double force = taut_film_force(space, e, 1);
    const taut_film_edge *edge = &space->problem->edges[e];
    if (edge->law != TAUT_FILM_FORCE) { /* the length that comes to that force */
        const double most =
                         taut_film_arc_length(taut_film_chord(space, e), factor * space->ratios[e]),
                     strain = edge->law == TAUT_FILM_ELASTIC ? factor * force / edge->stiffness : 0;
        snprintf(given, sizeof given, ", of a length of %.12g",
                 ldexp(most / (1 + strain), space->scaling.outer + space->scaling.inner));
    }
    snprintf(where, sizeof where, "/edges/%s/cable", taut_film_edge_names[e]);
    return taut_fail(error, TAUT_NO_SOLUTION, "cable-too-weak", where, force, factor * force,
                     "the cables are too weak for this flat sail of tension %g: with these forces "
                     "their arcs touch or do not span their chords; expected more than %.15g times "
                     "the forces (%.15g for edge %s%s), or so much less tension",
                     taut_film_tension(space->problem), factor, factor * force,
                     taut_film_edge_names[e], given);
}

taut_status taut_film_flat_check(const taut_film_space *space, taut_error *error)
{
    double flat[4][2];
    quad q;

    if (space->leader != NULL || taut_film_has_density(space->problem) ||
        has_curves(space->problem) || !has_arcs(space) || !lay_flat(space, flat)) {
        return TAUT_OK;
    }
    make_polygon(space, flat, &q);
    if (taut_film_polygon_is_crossed(&q.polygon)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "crossed", "/corners", taut_none, taut_none,
                         "the corners u0v0, u1v0, u1v1, u0v1, in this order, bound no polygon: "
                         "its sides cross or run back into themselves; exchange two of them");
    }
    return taut_film_polygon_exists(&q.polygon, 1) ? TAUT_OK : refuse_weak(space, &q, error);
}
