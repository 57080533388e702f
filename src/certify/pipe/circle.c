#include "certify/pipe/circle.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { DEGREE = TAUT_PIPE_PIECE_DEGREE, HALF = (DEGREE + 1) / 2 };

static const double no_circle = 1e-9; /* of the legs */

void taut_pipe_circle_directions(const taut_pipe_circle *circle, double angle, double out[3],
                                 double ahead[3])
{
    const double c = taut_cos(angle), s = taut_sin(angle);
    for (int k = 0; k < 3; k++) {
        out[k] = c * circle->out[k] + s * circle->ahead[k];
        ahead[k] = c * circle->ahead[k] - s * circle->out[k];
    }
}

int taut_pipe_circle_of(const taut_curve *curve, taut_pipe_circle *circle)
{
    const taut_basis *t = taut_curve_t(curve);
    const double *w = taut_curve_weights(curve), *p = taut_curve_points(curve);
    double a[3], b[3], across[3], end[3], ahead[3];
    if (w == NULL || taut_basis_degree(t) != 2 || taut_basis_span_count(t) != 1) {
        return 0;
    }
    taut_difference(p + 3, p, a);
    taut_difference(p + 6, p + 3, b);
    taut_cross(a, b, across);
    const double leg = taut_norm(a), sine = taut_norm(across), cosine = taut_dot(a, b);
    circle->angle = taut_atan2(sine, cosine);
    circle->radius = leg / taut_tan(0.5 * circle->angle);
    for (int k = 0; k < 3; k++) {
        circle->ahead[k] = a[k] / leg;
    }
    taut_cross(circle->ahead, across, circle->out);
    for (int k = 0; k < 3; k++) {
        circle->out[k] /= sine;
        circle->centre[k] = p[k] - circle->radius * circle->out[k];
    }
    taut_pipe_circle_directions(circle, circle->angle, end, ahead);
    memcpy(across, circle->centre, sizeof across);
    taut_add_scaled(circle->radius, end, across);
    /* a weight that is off moves a point by as much of the legs at most */
    const double middle = taut_cos(0.5 * circle->angle);
    circle->miss = taut_distance(across, p + 6) +
                   2 * leg * (fabs(w[1] / w[0] - middle) + fabs(w[2] / w[0] - 1)) / middle;
    return circle->miss <= no_circle * leg;
}

/* b_i = sum over k of C(i, k) (n - k)! / n! P^(k) from one end, and with (-1)^k from the other. */
double taut_pipe_circle_piece(const taut_pipe_circle *circle, const taut_pipe_line *line,
                              taut_pipe_piece *piece)
{
    const double radius = circle->radius / line->scale;
    double off = radius;
    piece->degree = DEGREE;
    for (int end = 0; end < 2; end++) {
        double directions[2][3];
        taut_pipe_circle_directions(circle, end * circle->angle, directions[0], directions[1]);
        for (int i = 0; i < HALF; i++) {
            double *const b = piece->points[end == 0 ? i : DEGREE - i];
            double factor = radius; /* of the k-th derivative: out, ahead, -out, -ahead */
            for (int c = 0; c < 3; c++) {
                b[c] = (circle->centre[c] - line->origin[c]) / line->scale;
            }
            for (int k = 0; k <= i; k++) {
                taut_add_scaled(k % 4 < 2 ? factor : -factor, directions[k % 2], b);
                factor *=
                    (end == 0 ? 1 : -1) * circle->angle * (i - k) / ((k + 1.0) * (DEGREE - k));
            }
        }
    }
    for (int k = 1; k <= 2 * HALF; k++) {
        off *= 0.5 * circle->angle / k;
    }
    return off + circle->miss / line->scale;
}

double taut_pipe_circle_noise(const taut_curve *curve, double size)
{
    const double *p = taut_curve_points(curve);
    return 16 * TAUT_UNIT_ROUNDOFF * (1 + size / taut_distance(p, p + 3));
}
