/* bent.c -- proof that an axis is nowhere more curved than a limit k.
 *
 * On each Bezier piece
 *
 *     k^2 (P' . P')^3 - |P' x P''|^2 > 0,   P' . P' > 0
 *
 * by Bernstein coefficients, halved until they are all positive. One polynomial, so that what both
 * terms have in common cancels, and a largest curvature just below the limit is told from it.
 */
#include "certify/pipe/circle.h"
#include "certify/pipe/sweep.h"

enum { DEPTH = 40, VISITS = 4000 };

static int sign_below(taut_arena *arena, const taut_field *f, int depth, int *left)
{
    taut_field halves[2];
    int first = 0;
    if (taut_field_low(f) > 0) {
        return 1;
    }
    if (f->a != NULL && (f->a[0] + f->e[0] <= 0 || f->a[f->p] + f->e[f->p] <= 0)) {
        return -1;
    }
    if (depth == DEPTH || --*left <= 0 || f->a == NULL) {
        return 0;
    }
    taut_field_halve(arena, f, 0, &halves[0], &halves[1]);
    first = sign_below(arena, &halves[0], depth + 1, left);
    return first != 1 ? first : sign_below(arena, &halves[1], depth + 1, left);
}

int taut_pipe_sign_of(taut_arena *arena, const taut_field *f, int *left)
{
    return sign_below(arena, f, 0, left);
}

static int prove_curve(taut_arena *arena, const taut_pipe_parts *parts, const taut_curve *curve,
                       double limit)
{
    taut_pipe_sweep sweep = {.parts = parts};
    taut_field across[3];
    taut_pipe_circle circle;
    int left = VISITS;
    if (taut_pipe_circle_of(curve, &circle)) {
        const double curvature = parts->line.scale / circle.radius;
        return curvature * (1 + taut_pipe_circle_noise(curve, parts->size)) < limit;
    }
    taut_pipe_sweep_curve(arena, curve, &sweep);
    if (!taut_pipe_sweep_derive(arena, &sweep)) {
        return 0;
    }
    taut_field_cross(arena, sweep.axis[1], sweep.axis[2], across);
    const taut_field speed = taut_field_dot(arena, sweep.axis[1], sweep.axis[1]);
    const taut_field square = taut_field_product(arena, &speed, &speed);
    const taut_field cube = taut_field_product(arena, &square, &speed);
    const taut_field bend = taut_field_dot(arena, across, across);
    const taut_field room = taut_field_combine(arena, limit * limit, &cube, -1, &bend);
    return taut_pipe_sign_of(arena, &speed, &left) > 0 &&
           taut_pipe_sign_of(arena, &room, &left) > 0;
}

taut_status taut_pipe_prove_bend(const taut_pipe_parts *parts, double limit, int *proved)
{
    taut_status status = TAUT_OK;
    *proved = 1;
    for (int i = 0; i < parts->axis_count && *proved && status == TAUT_OK; i++) {
        taut_arena *const arena = taut_arena_new();
        *proved = prove_curve(arena, parts, parts->axes[i], limit);
        status = taut_arena_status(arena);
        taut_arena_free(arena);
    }
    return status;
}
