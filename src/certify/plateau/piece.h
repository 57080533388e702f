/* piece.h -- one span of a film in the frame of its direction. */
#ifndef TAUT_CERTIFY_PLATEAU_PIECE_H
#define TAUT_CERTIFY_PLATEAU_PIECE_H

#include "certify/common/field.h"
#include "certify/plateau/flux.h"

#include <math.h>

/* One of the control points of span (i, j): the origin there. Nothing here depends on where a film
 * lies, and rounding is of the size of the span. */
static inline const double *taut_certify_origin(const taut_flux_task *task, int i, int j)
{
    const taut_basis *u = taut_surface_u(task->surface), *v = taut_surface_v(task->surface);
    const size_t at = (size_t)taut_basis_first(u, i) * (size_t)taut_basis_count(v) +
                      (size_t)taut_basis_first(v, j);
    return taut_surface_points(task->surface) + 3 * at;
}

/* X, Y, Z, w as they are given, turned into the frame, with an error that counts the frame's. */
static inline void taut_certify_turn(taut_arena *arena, const taut_flux_task *task,
                                     taut_field given[4], taut_field x[4])
{
    for (int c = 0; c < 4; c++) {
        for (int k = 0; given[c].a != NULL && k < (given[c].p + 1) * (given[c].q + 1); k++) {
            given[c].a[k] = ldexp(given[c].a[k], -task->weight_exponent);
            given[c].e[k] = ldexp(given[c].e[k], -task->weight_exponent) + 0x1p-1060;
        }
    }
    for (int c = 0; c < 3; c++) {
        const double *row = task->frame[c];
        const taut_field two = taut_field_combine(arena, row[0], &given[0], row[1], &given[1]);
        x[c] = taut_field_combine(arena, 1, &two, row[2], &given[2]);
        for (int k = 0; x[c].a != NULL && k < (x[c].p + 1) * (x[c].q + 1); k++) {
            for (int d = 0; d < 3; d++) {
                x[c].e[k] += 1.001 * task->frame_error * (fabs(given[d].a[k]) + given[d].e[k]);
            }
        }
    }
    x[3] = given[3];
}

/* x[0..2], w: the film on span (i, j) as X, Y, Z, w. */
static inline int taut_certify_piece(taut_arena *arena, const taut_flux_task *task, int i, int j,
                                     taut_field x[4])
{
    taut_field given[4];

    if (!taut_field_of_surface(arena, task->surface, i, j, taut_certify_origin(task, i, j),
                               task->exponent, given, NULL)) {
        return 0;
    }
    taut_certify_turn(arena, task, given, x);
    return 1;
}

#endif /* TAUT_CERTIFY_PLATEAU_PIECE_H */
