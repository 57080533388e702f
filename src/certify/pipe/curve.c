/* curve.c -- the polygon and the shape numbers of an axis, read off its curve, and the curve
 * with others: a "ce-bezier" of four points, or a quintic whose points 0, 2, 3, 5 are the polygon.
 */
#include "certify/pipe/parts.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <string.h>

static const int places[4] = {0, 2, 3, 5};

taut_status taut_pipe_read_axis(taut_pipe_parts *parts, taut_error *error)
{
    const taut_basis *t = taut_curve_t(parts->axis);
    const double *points = taut_curve_points(parts->axis);
    taut_basis_spec spec;

    taut_basis_spec_of(t, &spec);
    parts->quintic = strcmp(taut_basis_type(t), "bezier") == 0 && taut_basis_degree(t) == 5;
    if (!parts->quintic && strcmp(taut_basis_type(t), "ce-bezier") != 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/curves/0/t/type", taut_none, taut_none,
                         "the axis of a pipe is on a basis of type \"ce-bezier\", or \"bezier\" of "
                         "degree 5");
    }
    for (int i = 0; i < 4; i++) {
        memcpy(parts->polygon[i], points + 3 * (parts->quintic ? places[i] : i),
               sizeof parts->polygon[i]);
    }
    parts->shape[0] = spec.alpha;
    parts->shape[1] = spec.beta;
    parts->shape[2] = spec.gamma;
    if (parts->quintic) { /* q_1 and q_4 at parts (3 + alpha) / 4, (3 + gamma) / 4 of their edges */
        const double first = taut_distance(points, points + 6);
        const double last = taut_distance(points + 9, points + 15);
        parts->shape[0] = first > 0 ? 4 * taut_distance(points, points + 3) / first - 3 : -3;
        parts->shape[1] = 0;
        parts->shape[2] = last > 0 ? 4 * taut_distance(points + 12, points + 15) / last - 3 : -3;
    }
    return TAUT_OK;
}

taut_status taut_pipe_axis_with(const taut_pipe_parts *parts, const double shape[3],
                                taut_curve **curve, taut_error *error)
{
    const taut_basis_spec quasi = {
        .type = "ce-bezier", .alpha = shape[0], .beta = shape[1], .gamma = shape[2]};
    const taut_basis_spec bezier = {.type = "bezier", .degree = 5};
    const double first = (3 + shape[0]) / 4, last = (3 + shape[2]) / 4;
    const double(*v)[3] = parts->polygon;
    double points[6][3];
    taut_basis *basis = NULL;
    taut_status status =
        taut_basis_new(parts->quintic ? &bezier : &quasi, parts->quintic ? 6 : 4, &basis, error);

    for (int i = 0; i < 4; i++) {
        memcpy(points[parts->quintic ? places[i] : i], v[i], sizeof points[0]);
    }
    for (int k = 0; k < 3 && parts->quintic; k++) {
        points[1][k] = v[0][k] + first * (v[1][k] - v[0][k]);
        points[4][k] = v[3][k] - last * (v[3][k] - v[2][k]);
    }
    if (status == TAUT_OK) {
        status = taut_curve_new("", basis, &points[0][0], NULL, curve, error);
    }
    taut_basis_free(basis);
    return status;
}
