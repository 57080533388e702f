#include "certify/harmonic/contact.h"

#include "certify/common/field.h"
#include "certify/common/verdict.h"
#include "certify/harmonic/residual.h"
#include "core/constants.h"

#include <math.h>

/* Halved so often at least, coefficients are about values; and at most. */
enum { SHALLOW = 4, DEPTH = 24, PIECES = 256 };

/* Both surfaces on the edge: points, derivatives across (outwards from p) and along by parameter
 * length; coordinates times 2^-unit. */
typedef struct edge_pair {
    taut_arena *arena;
    taut_field point[2][3], across[2][3], along[2][3];
    double size, own;     /* half the extent of both nets, of the given one */
    double reach;         /* the largest coordinate */
    double degree, width; /* of q across */
    int degrees;          /* of q, both */
} edge_pair;

static taut_edge opposite(taut_edge edge)
{
    static const taut_edge others[] = {TAUT_EDGE_U1, TAUT_EDGE_U0, TAUT_EDGE_V1, TAUT_EDGE_V0};
    return others[edge];
}

static int is_across_u(taut_edge edge)
{
    return edge == TAUT_EDGE_U0 || edge == TAUT_EDGE_U1;
}

int taut_contact_ranges(const taut_surface *p, const taut_surface *q, taut_edge edge)
{
    const int u = is_across_u(edge);
    const taut_basis *from = u ? taut_surface_u(p) : taut_surface_v(p);
    const taut_basis *beyond = u ? taut_surface_u(q) : taut_surface_v(q);
    const taut_basis *along[2] = {u ? taut_surface_v(p) : taut_surface_u(p),
                                  u ? taut_surface_v(q) : taut_surface_u(q)};
    const int high = edge == TAUT_EDGE_U1 || edge == TAUT_EDGE_V1;
    return taut_basis_lo(along[0]) == taut_basis_lo(along[1]) &&
           taut_basis_hi(along[0]) == taut_basis_hi(along[1]) &&
           (high ? taut_basis_hi(from) == taut_basis_lo(beyond)
                 : taut_basis_lo(from) == taut_basis_hi(beyond));
}

static size_t count_of(const taut_surface *s)
{
    return (size_t)taut_basis_count(taut_surface_u(s)) *
           (size_t)taut_basis_count(taut_surface_v(s));
}

static taut_field scaled(taut_arena *arena, double factor, const taut_field *f)
{
    const taut_field none = taut_field_constant(arena, 0);
    return taut_field_combine(arena, factor, f, 0, &none);
}

/* One of the two: its edge, and the derivatives there. */
static void fill_side(edge_pair *e, int side, const taut_surface *s, taut_edge edge,
                      double outwards, int unit)
{
    static const double origin[3] = {0, 0, 0};
    const int u = is_across_u(edge);
    taut_field net[4];
    double widths[2] = {1, 1};

    if (!taut_field_of_surface(e->arena, s, 0, 0, origin, unit, net, widths)) {
        return; /* not reached: check_model lets only bezier bases in */
    }
    for (int c = 0; c < 3; c++) {
        const taut_field du = taut_field_du(e->arena, &net[c]);
        const taut_field dv = taut_field_dv(e->arena, &net[c]);
        const taut_field across = taut_field_edge(e->arena, u ? &du : &dv, (int)edge);
        const taut_field along = taut_field_edge(e->arena, u ? &dv : &du, (int)edge);
        e->point[side][c] = taut_field_edge(e->arena, &net[c], (int)edge);
        e->across[side][c] = scaled(e->arena, outwards / widths[u ? 0 : 1], &across);
        e->along[side][c] = scaled(e->arena, 1 / widths[u ? 1 : 0], &along);
    }
}

static void fill_pair(const taut_surface *p, const taut_surface *q, taut_edge edge,
                      taut_arena *arena, edge_pair *e)
{
    const taut_basis *across = is_across_u(edge) ? taut_surface_u(q) : taut_surface_v(q);
    const double outwards = edge == TAUT_EDGE_U1 || edge == TAUT_EDGE_V1 ? 1 : -1;
    double reach[2], size[2];

    size[0] = taut_certify_extent(taut_surface_points(p), NULL, count_of(p), &reach[0]);
    size[1] = taut_certify_extent(taut_surface_points(q), NULL, count_of(q), &reach[1]);
    const double most = taut_certify_max(reach[0], reach[1]);
    const int unit = most > 0 && isfinite(most) ? ilogb(most) : 0;
    *e = (edge_pair){.arena = arena,
                     .size = ldexp(fmax(size[0], size[1]), -unit),
                     .own = ldexp(size[0], -unit),
                     .reach = ldexp(most, -unit),
                     .degree = taut_basis_degree(across),
                     .width = taut_basis_hi(across) - taut_basis_lo(across),
                     .degrees = taut_basis_degree(taut_surface_u(q)) +
                                taut_basis_degree(taut_surface_v(q))};
    fill_side(e, 0, p, edge, outwards, unit);
    fill_side(e, 1, q, opposite(edge), outwards, unit);
}

/* The largest coefficient of three. */
static double largest_of(const taut_field f[3])
{
    return taut_certify_max(taut_field_largest(&f[0]),
                            taut_certify_max(taut_field_largest(&f[1]), taut_field_largest(&f[2])));
}

static void differ(const edge_pair *e, const taut_field f[3], const taut_field g[3],
                   taut_field out[3])
{
    for (int c = 0; c < 3; c++) {
        out[c] = taut_field_difference(e->arena, &f[c], &g[c]);
    }
}

/* 1 where every coefficient is 0: then no error of rounding, which is of the least number there is,
 * counts. */
static int is_zero(const taut_field f[3])
{
    for (int c = 0; c < 3; c++) {
        for (int k = 0; f[c].a == NULL || k <= f[c].p; k++) {
            if (f[c].a == NULL || f[c].a[k] != 0) {
                return 0;
            }
        }
    }
    return 1;
}

static double ratio_of(const taut_field f[3], double size)
{
    return is_zero(f) ? 0 : largest_of(f) / size;
}

static double gap_of(const edge_pair *e)
{
    taut_field apart[3];
    differ(e, e->point[0], e->point[1], apart);
    return ratio_of(apart,
                    e->own); /* the edge is the given surface's, however far the other goes */
}

/* What rounding the points leaves of a derivative of size `slope`, over it. */
static double rounding_of(const edge_pair *e, double slope)
{
    const double derivative = e->degree * e->reach / e->width;
    return 16 * e->degrees * TAUT_UNIT_ROUNDOFF *
           (slope > 0 ? taut_certify_max(1, derivative / slope) : 1);
}

/* From the gap and a difference of derivatives. */
static taut_contact of_difference(const edge_pair *e, const taut_field wanted[3])
{
    const double slope = taut_certify_max(largest_of(e->across[0]), largest_of(e->across[1]));
    taut_field apart[3];
    differ(e, e->across[1], wanted, apart);
    taut_contact found = {.limit = rounding_of(e, slope)};
    found.residual = taut_certify_max(gap_of(e), ratio_of(apart, slope));
    found.seen = found.residual;
    return found;
}

taut_contact taut_contact_c1(const taut_surface *p, const taut_surface *q, taut_edge edge,
                             taut_arena *arena)
{
    edge_pair e;
    fill_pair(p, q, edge, arena, &e);
    return of_difference(&e, e.across[0]);
}

taut_contact taut_contact_rule(const taut_surface *p, const taut_surface *q, taut_edge edge,
                               const double rule[3], taut_arena *arena)
{
    edge_pair e;
    taut_field wanted[3], turn = taut_field_new(arena, 1, 0);
    double most = 0;

    fill_pair(p, q, edge, arena, &e);
    if (turn.a != NULL) {
        turn.a[0] = rule[1];
        turn.a[1] = rule[1] + rule[2];
        turn.e[1] = TAUT_UNIT_ROUNDOFF * fabs(turn.a[1]);
    }
    for (int c = 0; c < 3; c++) {
        const taut_field along = taut_field_product(arena, &turn, &e.along[0][c]);
        wanted[c] = taut_field_combine(arena, rule[0], &e.across[0][c], 1, &along);
        most = taut_certify_max(most, taut_field_largest(&along));
    }
    taut_contact found = of_difference(&e, wanted);
    const double slope = taut_certify_max(largest_of(e.across[0]), largest_of(e.across[1]));
    /* the terms that are added may be larger than what they add up to */
    found.limit = taut_certify_max(
        found.limit,
        rounding_of(&e, slope) *
            (1 + (slope > 0 ? (fabs(rule[0]) * largest_of(e.across[0]) + most) / slope : 0)));
    return found;
}

/* One piece of the edge: |N_p x N_q| by its three coordinates, |N_p|^2, |N_q|^2. */
typedef struct sine_piece {
    taut_field cross[3], square[2];
    int depth;
} sine_piece;

typedef struct sine_bound {
    double upper, seen, least; /* least |N|^2 from below, where the sine was found */
    int is_lost;
} sine_bound;

static double length_upper(const taut_field f[3])
{
    const double x = taut_field_largest(&f[0]), y = taut_field_largest(&f[1]);
    const double z = taut_field_largest(&f[2]);
    return sqrt(x * x + y * y + z * z);
}

static double sine_at(const sine_piece *p)
{
    double sum = 0;
    for (int c = 0; c < 3; c++) {
        const double x = taut_field_value(&p->cross[c], 0.5, 0);
        sum += x * x;
    }
    const double squares =
        taut_field_value(&p->square[0], 0.5, 0) * taut_field_value(&p->square[1], 0.5, 0);
    return squares > 0 ? sqrt(sum / squares) : 0;
}

/* Cuts the edge in halves until the normals keep their length on each piece, about. */
static sine_bound bound_sine(taut_arena *arena, const sine_piece *whole)
{
    sine_piece stack[DEPTH + 2];
    sine_bound found = {0, 0, INFINITY, 0};
    int held = 0, pieces = 1;

    stack[held++] = *whole;
    while (held > 0) {
        const sine_piece p = stack[--held];
        const double low[2] = {taut_field_low(&p.square[0]), taut_field_low(&p.square[1])};
        const double high[2] = {taut_field_high(&p.square[0]), taut_field_high(&p.square[1])};
        const double seen = sine_at(&p);
        found.seen = taut_certify_max(found.seen, isfinite(seen) ? seen : 0);
        if (p.depth >= SHALLOW && low[0] > 0.5 * high[0] && low[1] > 0.5 * high[1]) {
            found.upper =
                taut_certify_max(found.upper, length_upper(p.cross) / sqrt(low[0] * low[1]));
            found.least = taut_certify_min(found.least, taut_certify_min(low[0], low[1]));
            continue;
        }
        if (p.depth >= DEPTH || pieces >= PIECES) {
            found.is_lost = 1;
            continue;
        }
        pieces++;
        sine_piece parts[2];
        for (int c = 0; c < 3; c++) {
            taut_field_halve(arena, &p.cross[c], 0, &parts[0].cross[c], &parts[1].cross[c]);
        }
        for (int s = 0; s < 2; s++) {
            taut_field_halve(arena, &p.square[s], 0, &parts[0].square[s], &parts[1].square[s]);
        }
        for (int s = 0; s < 2; s++) {
            parts[s].depth = p.depth + 1;
            stack[held++] = parts[s];
        }
    }
    return found;
}

taut_contact taut_contact_g1(const taut_surface *p, const taut_surface *q, taut_edge edge,
                             taut_arena *arena)
{
    taut_contact found = {0, 0, 0, NULL};
    sine_piece whole = {.depth = 0};
    taut_field normal[2][3];
    double spread = 0, gap = 0;
    edge_pair e;

    fill_pair(p, q, edge, arena, &e);
    for (int s = 0; s < 2; s++) {
        taut_field_cross(arena, e.across[s], e.along[s], normal[s]);
        whole.square[s] = taut_field_dot(arena, normal[s], normal[s]);
        const double product = 3 * largest_of(e.across[s]) * largest_of(e.along[s]);
        spread = taut_certify_max(spread, product);
    }
    taut_field_cross(arena, normal[0], normal[1], whole.cross);
    const sine_bound sine = bound_sine(arena, &whole);
    const double slope = taut_certify_min(largest_of(e.across[0]), largest_of(e.across[1]));
    const double ratio = spread > 0 ? sqrt(sine.least) / spread : 0;
    gap = gap_of(&e);
    found.limit = rounding_of(&e, slope) / (ratio < 1 ? fmax(ratio, TAUT_UNIT_ROUNDOFF) : 1);
    found.residual = taut_certify_max(gap, sine.is_lost ? INFINITY : sine.upper);
    found.seen = taut_certify_max(gap, sine.seen);
    found.why = sine.is_lost ? "warning: a normal vanishes, or cannot be told from 0" : NULL;
    return found;
}
