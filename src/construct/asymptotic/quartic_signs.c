/* quartic_signs.c -- to which sides the edges of degree 4 can bend. Docs page section 4.1. */
#include "construct/asymptotic/quartic.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>

int taut_quartic_interval(const taut_quartic_line *line, int sign, double range[2])
{
    range[0] = -INFINITY;
    range[1] = INFINITY;
    for (int k = 1; k <= 2; k++) {
        const double at = sign * line->at[k], along = sign * line->along[k];
        if (along > 0) {
            range[0] = fmax(range[0], -at / along);
        } else if (along < 0) {
            range[1] = fmin(range[1], -at / along);
        } else if (!(at > 0)) {
            return 0;
        }
    }
    return range[0] < range[1];
}

int taut_quartic_allows(const taut_quartic *quartic, const int signs[4])
{
    for (int e = 0; e < 4; e++) {
        double range[2];
        if (!quartic->data->edges[e].straight &&
            (signs[e] == 0 || !taut_quartic_interval(&quartic->lines[e], signs[e], range))) {
            return 0;
        }
    }
    for (int c = 0; c < 4; c++) {
        double product = 1.0;
        for (int k = 0; k < 2 && quartic->linked[c]; k++) {
            const taut_quad_meeting *const m = &taut_quad_corner[c][k];
            const double sign = m->end == 0 ? 1.0 : -1.0; /* (4.3) */
            product *=
                sign * signs[m->edge] * (quartic->lines[m->edge].torsion[m->end] > 0 ? 1.0 : -1.0);
        }
        if (quartic->linked[c] && product > 0) {
            return 0;
        }
    }
    return 1;
}

static int allows_any(const taut_quartic *quartic)
{
    for (int code = 0; code < 16; code++) {
        const int signs[4] = {code & 1 ? 1 : -1, code & 2 ? 1 : -1, code & 4 ? 1 : -1,
                              code & 8 ? 1 : -1};
        if (taut_quartic_allows(quartic, signs)) {
            return 1;
        }
    }
    return 0;
}

/* An edge that bends to different sides at its ends wherever its middle point lies, or -1. */
static int turning_edge(const taut_quartic *quartic)
{
    for (int e = 0; e < 4; e++) {
        double range[2];
        if (!quartic->data->edges[e].straight &&
            !taut_quartic_interval(&quartic->lines[e], 1, range) &&
            !taut_quartic_interval(&quartic->lines[e], -1, range)) {
            return e;
        }
    }
    return -1;
}

/* (4.3): the sign of mu drops out around a ring. Opposite torsions at its four corners need an even
 * number of edges on which the numerators have different signs. */
static int is_odd_ring(const taut_quartic *quartic)
{
    int odd = 0;
    for (int e = 0; e < 4; e++) {
        odd ^= (quartic->lines[e].torsion[0] > 0) != (quartic->lines[e].torsion[1] > 0);
    }
    return quartic->ring && odd;
}

/* The sine of the point beside the other end of an edge off the tangent plane at this one. */
static double off_plane(const taut_quartic *quartic, int edge, int end)
{
    const taut_corner_edge *const e = &quartic->data->edges[edge];
    double arm[3];
    taut_difference(e->point[1 - end], e->point[end], arm);
    taut_add_scaled(end == 0 ? -1.0 : 1.0, e->leg[1 - end], arm);
    return fabs(quartic->lines[edge].torsion[end]) / (taut_norm(e->normal[end]) * taut_norm(arm));
}

static taut_status fail_odd(const taut_quartic *quartic, taut_error *error)
{
    int edge = 0, end = 0;
    for (int k = 1; k < 8; k++) {
        if (off_plane(quartic, k / 2, k % 2) < off_plane(quartic, edge, end)) {
            edge = k / 2;
            end = k % 2;
        }
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "torsion-signs", "/edges",
                     off_plane(quartic, edge, end), 0.0,
                     "the signs of the torsions cannot be opposite at all four corners, whatever "
                     "curvatures and weights are: a control point beside a corner lies on the "
                     "wrong side of a tangent plane; the nearest is point %d of %s, off that of "
                     "corner %s by a sine of %.6g: turn its leg through it",
                     end == 0 ? 3 : 1, taut_asymptotic_edge_name(edge),
                     taut_asymptotic_corner_name(taut_quad_partner[edge][end].corner),
                     off_plane(quartic, edge, end));
}

taut_status taut_quartic_check_signs(const taut_quartic *quartic, taut_error *error)
{
    const int edge = turning_edge(quartic);
    if (allows_any(quartic)) {
        return TAUT_OK;
    }
    if (edge >= 0) {
        const double *const at = quartic->lines[edge].at;
        return taut_fail(error, TAUT_NO_SOLUTION, "turns-over", "/edges", at[2] / at[1], 0.0,
                         "edge %s bends to different sides at its two ends, wherever its middle "
                         "point lies on the line common to the tangent planes there (mu and nu are "
                         "%.6g and %.6g): turn one of its legs or of the legs it meets",
                         taut_asymptotic_edge_name(edge), at[1], at[2]);
    }
    return is_odd_ring(quartic)
               ? fail_odd(quartic, error)
               : taut_fail(error, TAUT_NO_SOLUTION, "torsion-signs", "/edges", 0.0, taut_none,
                           "no choice of sides to bend to gives opposite torsions at all corners "
                           "and one side per edge: change the direction of a leg");
}
