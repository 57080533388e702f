/* everywhere.c
 *
 *     of each cell: m^2 - l n > 0 by the ranges of the derivatives alone; where that does not say
 *     by those of l, m, n as polynomials; where that does not either
 *     the discriminant as a polynomial that knows its rounding (certify/common/field.h)
 *     its least coefficient is above 0, or that of its halves, and of theirs
 *     a corner that is not above 0, or too many pieces: not proved
 */
#include "certify/trace/everywhere.h"

#include "core/constants.h"

#include <math.h>

enum { DEPTH = 12 /* halvings of a cell */, PIECES = 256 /* of a cell */ };
/* More than underflow may lose. */
static const double least_size = 0x1p-1000;

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
    taut_field u[3], v[3], second[3][3]; /* x_uu, x_uv, x_vv */
    taut_field l, m, n;
} forms;

static void derive(taut_arena *arena, const taut_field x[3], forms *q)
{
    for (int c = 0; c < 3; c++) {
        q->u[c] = taut_field_du(arena, &x[c]);
        q->v[c] = taut_field_dv(arena, &x[c]);
        q->second[0][c] = taut_field_du(arena, &q->u[c]);
        q->second[1][c] = taut_field_dv(arena, &q->u[c]);
        q->second[2][c] = taut_field_dv(arena, &q->v[c]);
    }
}

static void forms_of(taut_arena *arena, forms *q)
{
    taut_field normal[3];
    taut_field_cross(arena, q->u, q->v, normal);
    q->l = taut_field_dot(arena, q->second[0], normal);
    q->m = taut_field_dot(arena, q->second[1], normal);
    q->n = taut_field_dot(arena, q->second[2], normal);
}

/* All between two numbers, rounding and all. */
typedef struct range {
    double low, high;
} range;

static range range_of(const taut_field *f)
{
    return (range){taut_field_low(f), taut_field_high(f)};
}

/* sum + sign a b */
static range add_product(range sum, int sign, range a, range b)
{
    const double p[4] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    const double low = fmin(fmin(p[0], p[1]), fmin(p[2], p[3]));
    const double high = fmax(fmax(p[0], p[1]), fmax(p[2], p[3]));
    const double room =
        8 * TAUT_UNIT_ROUNDOFF *
        (fmax(fabs(low), fabs(high)) + fmax(fabs(sum.low), fabs(sum.high)) + least_size);
    return sign > 0 ? (range){sum.low + low - room, sum.high + high + room}
                    : (range){sum.low - high - room, sum.high - low + room};
}

/* The least |m|^2 above the largest l n, of all that lies between their bounds, with room for rounding. */
static int are_saddle(range l, range m, range n)
{
    const double least = fmax(m.low, -m.high);
    const double product =
        fmax(fmax(l.low * n.low, l.low * n.high), fmax(l.high * n.low, l.high * n.high));
    const double square = least > 0 ? least * least : 0;
    const int are_finite =
        isfinite(l.low) && isfinite(l.high) && isfinite(n.low) && isfinite(n.high);
    return are_finite && square - product > 4 * TAUT_UNIT_ROUNDOFF * (square + fabs(product));
}

/* By the ranges of derivatives, of each coordinate alone: a small share of the work, and enough where cells are small. */
static int is_plainly_saddle(const forms *q)
{
    range normal[3], form[3];
    for (int c = 0; c < 3; c++) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        const range u[2] = {range_of(&q->u[a]), range_of(&q->u[b])};
        const range v[2] = {range_of(&q->v[a]), range_of(&q->v[b])};
        normal[c] = add_product((range){0, 0}, 1, u[0], v[1]);
        normal[c] = add_product(normal[c], -1, u[1], v[0]);
    }
    for (int k = 0; k < 3; k++) {
        form[k] = (range){0, 0};
        for (int c = 0; c < 3; c++) {
            form[k] = add_product(form[k], 1, range_of(&q->second[k][c]), normal[c]);
        }
    }
    return are_saddle(form[0], form[1], form[2]);
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
    derive(arena, one->x, &q);
    if (is_plainly_saddle(&q)) {
        return 1;
    }
    forms_of(arena, &q);
    if (are_saddle(range_of(&q.l), range_of(&q.m), range_of(&q.n))) {
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
