/* caps.c -- discs over the free ends: surface "cap1" over u0 of the first surface, "cap2" over
 * u1 of the last; that edge is u1 of cap1 and u0 of cap2, as u runs along the flow everywhere, and
 * all of a cap lies in the plane across it.
 *
 * A cap is ruled from one point inside the ring to the ring, with the ring's own functions around.
 * So it is no farther from the ring, and from a plane through three points of it, than its control
 * points are: the larger of both, over the radius, is a bound of the whole cap.
 */
#include "certify/common/verdict.h"
#include "certify/pipe/parts.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

/* A row of control points and weights (NULL: 1). */
typedef struct ring {
    const double (*points)[3];
    const double *weights;
} ring;

static ring ring_of(const taut_surface *s, int last)
{
    const size_t nu = (size_t)taut_basis_count(taut_surface_u(s));
    const size_t nv = (size_t)taut_basis_count(taut_surface_v(s)), row = last ? (nu - 1) * nv : 0;
    const double *weights = taut_surface_weights(s);
    return (ring){(const double(*)[3])(const void *)(taut_surface_points(s) + 3 * row),
                  weights != NULL ? weights + row : NULL};
}

static double weight_of(const ring *r, int j)
{
    return r->weights != NULL ? r->weights[j] : 1;
}

/* The unit normal of the plane through three points of a ring; 0 where there is none. */
static void find_normal(const ring *r, int count, double normal[3])
{
    double a[3], b[3], across[3];
    taut_difference(r->points[count / 3], r->points[0], a);
    taut_difference(r->points[2 * count / 3], r->points[0], b);
    taut_cross(a, b, across);
    taut_pipe_unit(across, normal);
}

/* INFINITY for what is no disc in the way said above. */
static double miss_of(const taut_surface *cap, const taut_surface *end, const taut_surface *inside,
                      int side)
{
    const taut_basis *u = taut_surface_u(cap), *v = taut_surface_v(cap);
    const int count = taut_basis_count(v);
    const ring rim = ring_of(cap, side == 0), hub = ring_of(cap, side == 1);
    const ring edge = ring_of(end, side == 1);
    const ring within = ring_of(inside != NULL ? inside : end, side == 1);
    double normal[3], middle[3] = {0, 0, 0}, worst = 0;
    if (taut_basis_degree(u) != 1 || taut_basis_span_count(u) != 1 ||
        !taut_basis_equal(v, taut_surface_v(end))) {
        return INFINITY;
    }
    find_normal(&edge, count, normal);
    if (!(taut_norm(normal) > 0.5)) {
        return INFINITY;
    }
    for (int j = 0; j < count; j++) {
        double away[3];
        taut_difference(hub.points[j], edge.points[0], away);
        worst = taut_certify_max(worst, taut_distance(rim.points[j], edge.points[j]));
        worst = taut_certify_max(
            worst, taut_distance(hub.points[j], inside != NULL ? within.points[j] : hub.points[0]));
        worst = taut_certify_max(worst, fabs(taut_dot(away, normal)));
        taut_difference(edge.points[j], edge.points[0], away);
        worst = taut_certify_max(worst, fabs(taut_dot(away, normal)));
        taut_add_scaled(1.0 / count, edge.points[j], middle);
        if (weight_of(&rim, j) != weight_of(&edge, j) || weight_of(&hub, j) != weight_of(&rim, j)) {
            return INFINITY;
        }
    }
    if (inside != NULL) {
        return taut_basis_equal(v, taut_surface_v(inside)) ? worst : INFINITY;
    }
    /* half way to the nearest point of the ring, so that rays from the hub meet it once */
    for (int j = 0; j < count; j++) {
        if (!(2 * taut_distance(hub.points[0], middle) < taut_distance(middle, edge.points[j]))) {
            return INFINITY;
        }
    }
    return worst;
}

taut_status taut_pipe_claim_caps(const taut_model *model, const taut_pipe_parts *parts,
                                 const taut_surface *const ends[2],
                                 const taut_surface *const inside[2], taut_certificate *certificate)
{
    double worst = 0;
    char where[8] = "";
    int found = 0;
    for (int side = 0; side < 2; side++) {
        const taut_surface *cap = taut_pipe_find_surface(model, side == 0 ? "cap1" : "cap2");
        const double miss =
            cap != NULL ? miss_of(cap, ends[side], inside != NULL ? inside[side] : NULL, side) : 0;
        found += cap != NULL;
        if (!(miss <= worst) && !isnan(worst)) {
            worst = miss;
            snprintf(where, sizeof where, "cap%d", side + 1);
        }
    }
    if (found == 0 && inside == NULL) {
        return TAUT_OK;
    }
    if (found != 2 || isinf(worst)) { /* what is no disc misses it by a radius */
        worst = parts->radius;
    }
    return taut_pipe_add_claim("caps", TAUT_BOUND, worst / parts->radius, 0,
                               (8 * DBL_EPSILON * parts->size / parts->radius + 16 * DBL_EPSILON) *
                                   parts->flatness,
                               where, certificate);
}
