/* gauss_bonnet.c
 *
 *     iint K dA  =  sum of the corners' angles - 2 pi - int k_g ds counter-clockwise along the border
 *
 *     k_g ds  =  (X'' . (n x X')) / |X'|^2 dx,      X(x) an edge, n the normal
 *
 * of the border just inside, as edges may lie on knots across which the surface's derivatives jump. With theta the angle from X_s to X_t the corners add up to theta(0, 0) - theta(1, 0) + theta(1, 1) - theta(0, 1) + 2 pi.
 */
#include "certify/pattern/gauss_bonnet.h"

#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <math.h>

enum { NODES = 8, FIRST = 16, MOST = 512 /* cells of an edge */ };
/* What more of them change. */
static const double settled = 1e-9;
/* Of s and t: inside. */
static const double aside = 1e-8;

/* X_s, X_t, the second derivative along s (d = 0) or t (1), and the normal, of no fixed length. */
typedef struct spot {
    double first[2][3], second[3], normal[3];
} spot;

static int look_at(const taut_cloth *cloth, const taut_cloth_piece *piece, double s, double t,
                   int d, spot *at)
{
    taut_cloth_across across;
    double w[6][2], x[6][3];
    taut_cloth_across_at(cloth, piece, s, 2, &across);
    if (!taut_cloth_bend_on(cloth, &across, t, w) ||
        taut_surface_eval(piece->on, w[0][0], w[0][1], 2, x[0]) != TAUT_OK) {
        return 0;
    }
    const double *a = w[1 + d], *aa = w[d == 0 ? 3 : 5];
    for (int c = 0; c < 3; c++) {
        for (int k = 0; k < 2; k++) {
            at->first[k][c] = x[TAUT_XU][c] * w[1 + k][0] + x[TAUT_XV][c] * w[1 + k][1];
        }
        at->second[c] = x[TAUT_XUU][c] * a[0] * a[0] + 2 * x[TAUT_XUV][c] * a[0] * a[1] +
                        x[TAUT_XVV][c] * a[1] * a[1] + x[TAUT_XU][c] * aa[0] +
                        x[TAUT_XV][c] * aa[1];
    }
    taut_cross(at->first[0], at->first[1], at->normal);
    return taut_norm(at->normal) > 0;
}

/* int k_g ds of an edge, as s or t grows. */
static double turn_of(const taut_cloth *cloth, const taut_cloth_piece *piece, int edge, int cells)
{
    const int d = edge == TAUT_CLOTH_START || edge == TAUT_CLOTH_END;
    const double fixed = edge == TAUT_CLOTH_END || edge == TAUT_CLOTH_LEFT ? 1 - aside : aside;
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < cells * NODES; k++) {
        const double x = (k / NODES + (1 + nodes[k % NODES]) / 2) / cells;
        spot at;
        double sideways[3];
        if (!look_at(cloth, piece, d ? fixed : x, d ? x : fixed, d, &at)) {
            return NAN;
        }
        taut_cross(at.normal, at.first[d], sideways);
        sum += weights[k % NODES] / 2 / cells * taut_dot(at.second, sideways) /
               (taut_norm(at.normal) * taut_dot(at.first[d], at.first[d]));
    }
    return sum;
}

static double settled_turn(const taut_cloth *cloth, const taut_cloth_piece *piece, int edge)
{
    double before = turn_of(cloth, piece, edge, FIRST);
    for (int cells = 2 * FIRST; cells <= MOST; cells *= 2) {
        const double after = turn_of(cloth, piece, edge, cells);
        const double apart = fabs(after - before);
        before = after;
        if (!(apart > settled)) {
            break;
        }
    }
    return before;
}

/* From X_s to X_t. */
static double angle_at(const taut_cloth *cloth, const taut_cloth_piece *piece, double s, double t)
{
    spot at;
    return look_at(cloth, piece, s, t, 0, &at)
               ? taut_atan2(taut_norm(at.normal), taut_dot(at.first[0], at.first[1]))
               : (double)NAN;
}

double taut_cloth_gauss_bonnet(const taut_cloth *cloth, const taut_cloth_piece *piece)
{
    static const int signs[TAUT_CLOTH_EDGES] = {1, 1, -1, -1};
    const double a = aside, b = 1 - aside;
    double sum = angle_at(cloth, piece, a, a) - angle_at(cloth, piece, b, a) +
                 angle_at(cloth, piece, b, b) - angle_at(cloth, piece, a, b);
    for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
        sum -= signs[e] * settled_turn(cloth, piece, e);
    }
    return sum;
}
