/* everywhere.c
 *
 *     of each cell: m^2 - l n > 0 by the ranges of l, m, n alone; where that does not say
 *     the discriminant as a polynomial that knows its rounding (certify/common/field.h)
 *     its least coefficient is above 0, or that of its halves, and of theirs
 *     a corner that is not above 0, or too many pieces: not proved
 */
#include "certify/trace/everywhere.h"

#include "core/constants.h"

#include <math.h>

enum { DEPTH = 12 /* halvings of a cell */, PIECES = 256 /* of a cell */ };

typedef struct request {
    taut_arena *arena;
    int pieces;
} request;

static int is_positive(request *r, const taut_field *f, int depth)
{
    taut_field low, high;
    if (f->a == NULL || ++r->pieces > PIECES) {
        return 0;
    }
    if (taut_field_low(f) > 0) {
        return 1;
    }
    if (depth == 0 || !(f->a[0] > 0) || !(f->a[(f->p + 1) * (f->q + 1) - 1] > 0)) {
        return 0;
    }
    taut_field_halve(r->arena, f, depth % 2, &low, &high);
    return is_positive(r, &low, depth - 1) && is_positive(r, &high, depth - 1);
}

/* What the forms of a cell are made of. */
typedef struct forms {
    taut_field u[3], v[3], l, m, n;
} forms;

static void forms_of(taut_arena *arena, const taut_field x[3], forms *q)
{
    taut_field uu[3], uv[3], vv[3], normal[3];
    for (int c = 0; c < 3; c++) {
        q->u[c] = taut_field_du(arena, &x[c]);
        q->v[c] = taut_field_dv(arena, &x[c]);
        uu[c] = taut_field_du(arena, &q->u[c]);
        uv[c] = taut_field_dv(arena, &q->u[c]);
        vv[c] = taut_field_dv(arena, &q->v[c]);
    }
    taut_field_cross(arena, q->u, q->v, normal);
    q->l = taut_field_dot(arena, uu, normal);
    q->m = taut_field_dot(arena, uv, normal);
    q->n = taut_field_dot(arena, vv, normal);
}

/* The least |m|^2 above the largest l n, of all that lies between their bounds, with room for rounding. */
static int is_saddle(const forms *q)
{
    const double l[2] = {taut_field_low(&q->l), taut_field_high(&q->l)};
    const double n[2] = {taut_field_low(&q->n), taut_field_high(&q->n)};
    const double m = fmax(taut_field_low(&q->m), -taut_field_high(&q->m));
    const double product = fmax(fmax(l[0] * n[0], l[0] * n[1]), fmax(l[1] * n[0], l[1] * n[1]));
    const double square = m > 0 ? m * m : 0;
    const int are_finite = isfinite(l[0]) && isfinite(l[1]) && isfinite(n[0]) && isfinite(n[1]);
    return are_finite && square - product > 4 * TAUT_UNIT_ROUNDOFF * (square + fabs(product));
}

/* m^2 - l n. */
static taut_field saddle_of(taut_arena *arena, const forms *q)
{
    const taut_field square = taut_field_product(arena, &q->m, &q->m);
    const taut_field product = taut_field_product(arena, &q->l, &q->n);
    return taut_field_difference(arena, &square, &product);
}

/* (E n - 2 F m + G l)^2 + 4 (EG - F^2)(m^2 - l n). */
static taut_field round_of(taut_arena *arena, const forms *q, const taut_field *saddle)
{
    const taut_field e = taut_field_dot(arena, q->u, q->u), f = taut_field_dot(arena, q->u, q->v);
    const taut_field g = taut_field_dot(arena, q->v, q->v);
    const taut_field en = taut_field_product(arena, &e, &q->n);
    const taut_field fm = taut_field_product(arena, &f, &q->m);
    const taut_field gl = taut_field_product(arena, &g, &q->l);
    const taut_field ends = taut_field_sum(arena, &en, &gl);
    const taut_field mean = taut_field_combine(arena, 1, &ends, -2, &fm);
    const taut_field eg = taut_field_product(arena, &e, &g);
    const taut_field ff = taut_field_product(arena, &f, &f);
    const taut_field area = taut_field_difference(arena, &eg, &ff);
    const taut_field square = taut_field_product(arena, &mean, &mean);
    const taut_field rest = taut_field_product(arena, &area, saddle);
    return taut_field_combine(arena, 1, &square, 4, &rest);
}

/* Lengths of parameters do not matter: the discriminants of the two grow by a positive factor. */
static int cell_has_net(taut_arena *arena, const taut_net_cell *one, taut_trace_net net)
{
    request r = {.arena = arena};
    forms q;

    if (one == NULL || one->x[3].p > 0 || one->x[3].q > 0) {
        return 0;
    }
    forms_of(arena, one->x, &q);
    if (is_saddle(&q)) {
        return 1;
    }
    const taut_field saddle = saddle_of(arena, &q);
    if (is_positive(&r, &saddle, DEPTH)) {
        return 1;
    }
    if (net == TAUT_TRACE_ASYMPTOTIC) {
        return 0;
    }
    const taut_field round = round_of(arena, &q, &saddle);
    r.pieces = 0;
    return is_positive(&r, &round, DEPTH);
}

taut_status taut_net_everywhere(taut_net_cells *cells, taut_trace_net net, int *is_proved)
{
    const taut_surface *surface = cells->surfaces[0];
    const int spans[2] = {taut_basis_span_count(taut_surface_u(surface)),
                          taut_basis_span_count(taut_surface_v(surface))};
    taut_status status = TAUT_OK;

    *is_proved = taut_surface_weights(surface) == NULL;
    for (int k = 0; status == TAUT_OK && *is_proved && k < spans[0] * spans[1]; k++) {
        const int span[2] = {k / spans[1], k % spans[1]};
        taut_arena *arena = taut_arena_new(); /* a cell each: the next one needs as much again */
        if (arena == NULL) {
            return TAUT_NO_MEMORY;
        }
        *is_proved = cell_has_net(arena, taut_net_cell_of(cells, 0, span), net);
        status = taut_arena_status(arena);
        status = status == TAUT_OK ? taut_arena_status(cells->arena) : status;
        taut_arena_free(arena);
    }
    return status;
}
