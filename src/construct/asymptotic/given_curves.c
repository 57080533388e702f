/* given_curves.c -- the quadrilateral of four given curves: of one degree, closed (or which of them
 * run the wrong way), with equal end weights. */
#include "construct/asymptotic/end_weights.h"
#include "construct/asymptotic/quad.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* How far the two edges at corner c are apart, with the edges of the set `turned` taken from their
 * other ends: bit e for edge e. */
static double gap_at(const taut_quad *quad, int c, int turned)
{
    const double *at[2];
    for (int k = 0; k < 2; k++) {
        const taut_quad_meeting *const m = &taut_quad_corner[c][k];
        at[k] = taut_quad_point(quad, m->edge, m->end ^ (turned >> m->edge & 1), 0);
    }
    return taut_distance(at[0], at[1]);
}

static int is_closed(const taut_quad *quad, int turned, double most)
{
    for (int c = 0; c < 4; c++) {
        if (!(gap_at(quad, c, turned) <= most)) {
            return 0;
        }
    }
    return 1;
}

static int size_of(int set)
{
    return (set & 1) + (set >> 1 & 1) + (set >> 2 & 1) + (set >> 3 & 1);
}

/* "; all four close with u0 and v1 reversed: ..." for the fewest such curves; or nothing. */
static void turned_text(const taut_quad *quad, double most, char text[160])
{
    int best = 0;
    text[0] = '\0';
    for (int turned = 1; turned < 16; turned++) {
        if (is_closed(quad, turned, most) && (best == 0 || size_of(turned) < size_of(best))) {
            best = turned;
        }
    }
    for (int e = 0, left = size_of(best); e < 4; e++) {
        if (best >> e & 1) {
            left--;
            (void)strcat(text, text[0] == '\0' ? "; all four close with "
                               : left > 0      ? ", "
                                               : " and ");
            (void)strcat(text, taut_asymptotic_edge_name(e));
        }
    }
    if (best != 0) {
        (void)strcat(text, " reversed: control points and weights in the opposite order");
    }
}

/* Do the two edges at each corner share its point? TAUT_NO_SOLUTION names the corner, and the
 * curves that would have to be reversed where that is all there is to it. */
static taut_status check_closed(const taut_quad *quad, taut_error *error)
{
    const double most = 1e-12 * taut_quad_size(quad) + 4 * taut_quad_rounding(quad);
    for (int c = 0; c < 4; c++) {
        const taut_quad_meeting *const m = taut_quad_corner[c];
        const char *const first = taut_asymptotic_edge_name(m[0].edge);
        const char *const second = taut_asymptotic_edge_name(m[1].edge);
        const double gap = gap_at(quad, c, 0);
        if (!(gap <= most)) {
            char text[160];
            turned_text(quad, most, text);
            return taut_fail(error, TAUT_NO_SOLUTION, "not-closed", "/curves", gap, most,
                             "curves %s and %s do not meet at corner %s: the gap is %.3g%s", first,
                             second, taut_asymptotic_corner_name(c), gap, text);
        }
    }
    return TAUT_OK;
}

/* Is every control point on the chord, up to rounding of the coordinates? */
static int is_straight(const taut_quad *quad, int edge)
{
    const taut_quad_edge *const e = &quad->edges[edge];
    const double rounding = 4 * taut_quad_rounding(quad);
    double chord[3], reach = 0.0, off = 0.0;
    taut_difference(e->points[quad->degree], e->points[0], chord);
    for (int j = 1; j < quad->degree; j++) {
        double d[3], normal[3];
        taut_difference(e->points[j], e->points[0], d);
        taut_cross(chord, d, normal);
        off = fmax(off, taut_norm(normal));
        reach = fmax(reach, taut_norm(d));
    }
    return off <= taut_norm(chord) * (1e-13 * fmax(reach, taut_norm(chord)) + rounding);
}

static void copy_curve(const taut_curve *curve, int n, taut_quad_edge *edge)
{
    const int p = taut_basis_count(taut_curve_t(curve)) - 1;
    const double *const weights = taut_curve_weights(curve);
    memcpy(edge->points, taut_curve_points(curve), (size_t)(p + 1) * sizeof *edge->points);
    for (int j = 0; j <= p; j++) {
        edge->weights[j] = weights != NULL ? weights[j] : 1.0;
    }
    taut_quad_raise_edge(p, n, edge);
}

/* One degree for all four; TAUT_BAD_INPUT names the curve that cannot be a boundary. */
static taut_status common_degree(const taut_curve *const curves[4], int *degree, taut_error *error)
{
    *degree = 3;
    for (int a = 0; a < 4; a++) {
        const taut_basis *t = NULL;
        char where[32];
        (void)snprintf(where, sizeof where, "/curves/%s", taut_asymptotic_edge_name(a));
        if (curves[a] == NULL) {
            return taut_fail(error, TAUT_BAD_INPUT, "missing", where, taut_none, taut_none,
                             "curve %s is missing: all four are needed",
                             taut_asymptotic_edge_name(a));
        }
        t = taut_curve_t(curves[a]);
        if (strcmp(taut_basis_type(t), "bezier") != 0 || taut_basis_lo(t) != 0.0 ||
            taut_basis_hi(t) != 1.0) {
            return taut_fail(error, TAUT_BAD_INPUT, "not-bezier", where, taut_none, taut_none,
                             "curve %s must be a bezier curve over [0, 1]",
                             taut_asymptotic_edge_name(a));
        }
        if (taut_basis_degree(t) > TAUT_QUAD_DEGREE) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", where, taut_basis_degree(t),
                             TAUT_QUAD_DEGREE,
                             "curve %s has degree %d: boundary curves have degree at most %d",
                             taut_asymptotic_edge_name(a), taut_basis_degree(t), TAUT_QUAD_DEGREE);
        }
        *degree = taut_basis_degree(t) > *degree ? taut_basis_degree(t) : *degree;
    }
    return TAUT_OK;
}

taut_status taut_quad_of_curves(const taut_curve *const curves[4], taut_quad *quad,
                                taut_error *error)
{
    int degrees[4];
    taut_status status = common_degree(curves, &quad->degree, error);
    if (status != TAUT_OK) {
        return status;
    }
    quad->rounding = 0.0;
    for (int a = 0; a < 4; a++) {
        degrees[a] = taut_basis_degree(taut_curve_t(curves[a]));
        copy_curve(curves[a], quad->degree, &quad->edges[a]);
        quad->edges[a].straight = is_straight(quad, a);
    }
    quad->rounding = taut_quad_rounding(quad);
    status = check_closed(quad, error);
    return status == TAUT_OK ? taut_end_weights_of_curves(quad, degrees, error) : status;
}
