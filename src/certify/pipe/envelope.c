/* envelope.c -- is the canal surface about an axis regular, and a graph over the tube around it?
 *
 * Of the exact envelope of spheres of radius r about P ([WangBai2018] section 10.5), by polynomials
 * along the axis: what goes around it is at its least where the normal n looks to the centre of
 * curvature. With q = P' . P', d = P' . P'', all by the curve's parameter:
 *
 *   regular  1 - r_s^2 - r r_ss - r kappa sqrt(1 - r_s^2) > 0 everywhere. Times q^2 it is A - sqrt B,
 *
 *                A = q^2 - q r'^2 - r r'' q + r r' d
 *                B = r^2 |P' x P''|^2 (q - r'^2)
 *
 *            so that q - r'^2, A and A^2 - B must be positive, one polynomial in which cancels what
 *            both terms have in common.
 *   graph    n . (X - F) > 0, F the foot of X = P + r n on the axis. By arc length (X - P)^2 / 2 has
 *            the slope r r_s at P and bends by c = 1 - r kappa at least as long as it falls, so that F
 *            is no farther than L = r |r_s| / c along the axis, and as n . T = -r_s at P and changes
 *            by kappa at most,
 *
 *                n . (X - F) / r >= 1 - (r_s^2 / c) (1 + r kappa / (2 c)),
 *
 *            the largest kappa within L of P, on equal parts of the axis.
 */
#include "certify/common/verdict.h"
#include "certify/pipe/sweep.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>

enum { PLACES = 256, AROUND = 16, VISITS = 4000, HALVINGS = 7, PARTS = 1 << HALVINGS };
#define FINE 0x1p-12 /* of the parameter */

static const double limit = 1e-6; /* what is not above it is none */
static const double clear = 1e-9; /* rounding of a cosine is far below */
static const double rounded = 1 + 256 * TAUT_UNIT_ROUNDOFF;

/* r, r', r'' as polynomials. */
typedef struct spheres {
    taut_field r[3];
} spheres;

static spheres spheres_of(taut_arena *arena, const taut_pipe_parts *parts)
{
    const double scale = parts->line.scale;
    spheres s = {.r = {taut_field_new(arena, 3, 0)}};
    for (int i = 0; i < 4 && s.r[0].a != NULL; i++) {
        s.r[0].a[i] = parts->ellipses[i / 2].a / scale;
        s.r[0].e[i] = TAUT_UNIT_ROUNDOFF * s.r[0].a[i];
    }
    s.r[1] = taut_field_du(arena, &s.r[0]);
    s.r[2] = taut_field_du(arena, &s.r[1]);
    return s;
}

/* What both claims are made of. */
typedef struct terms {
    taut_field speed;          /* q */
    taut_field real;           /* q - r'^2 */
    taut_field room;           /* A */
    taut_field area;           /* |P' x P''|^2 */
    taut_field curve;          /* B */
    taut_field slope;          /* r r' */
    taut_field radius, square; /* r, r'^2 */
} terms;

static terms terms_of(taut_arena *arena, const taut_pipe_sweep *sweep)
{
    const taut_field *first = sweep->axis[1], *second = sweep->axis[2];
    const spheres s = spheres_of(arena, sweep->parts);
    taut_field across[3];
    terms t = {.speed = taut_field_dot(arena, first, first),
               .square = taut_field_product(arena, &s.r[1], &s.r[1]),
               .slope = taut_field_product(arena, &s.r[0], &s.r[1]),
               .radius = s.r[0]};
    const taut_field d = taut_field_dot(arena, first, second);
    const taut_field qq = taut_field_product(arena, &t.speed, &t.speed);
    const taut_field turn = taut_field_product(arena, &t.slope, &d);
    const taut_field growth = taut_field_product(arena, &s.r[0], &s.r[2]);
    const taut_field loss = taut_field_sum(arena, &t.square, &growth);
    const taut_field lost = taut_field_product(arena, &t.speed, &loss);
    const taut_field rr = taut_field_product(arena, &s.r[0], &s.r[0]);
    t.real = taut_field_difference(arena, &t.speed, &t.square);
    const taut_field bend = taut_field_sum(arena, &qq, &turn);
    t.room = taut_field_difference(arena, &bend, &lost);
    taut_field_cross(arena, first, second, across);
    t.area = taut_field_dot(arena, across, across);
    const taut_field both = taut_field_product(arena, &t.area, &t.real);
    t.curve = taut_field_product(arena, &rr, &both);
    return t;
}

/* Is A - limit q^2 > sqrt B everywhere? +1, -1 and 0 as taut_pipe_sign_of has them. */
static int regular_sign(taut_arena *arena, const terms *t)
{
    int left = VISITS;
    const taut_field qq = taut_field_product(arena, &t->speed, &t->speed);
    const taut_field room = taut_field_combine(arena, 1, &t->room, -limit, &qq);
    const taut_field square = taut_field_product(arena, &room, &room);
    const taut_field apart = taut_field_difference(arena, &square, &t->curve);
    const taut_field *const all[4] = {&t->speed, &t->real, &room, &apart};
    int sign = 1;
    for (int i = 0; i < 4 && sign == 1; i++) {
        sign = taut_pipe_sign_of(arena, all[i], &left);
    }
    return sign;
}

/* What is known of a part of the axis, at most: kappa, r, |r_s|; at least: its length. */
typedef struct part_of_axis {
    double curvature, radius, rate, length;
} part_of_axis;

/* The parts from `first` on, 2^halvings of them. */
static void bound_parts(taut_arena *arena, const taut_field f[4], int halvings, part_of_axis *parts)
{
    taut_field halves[2][4];
    if (halvings == 0) {
        const double least = taut_field_low(&f[0]), speed = least > 0 ? sqrt(least) : NAN;
        *parts = (part_of_axis){.curvature = sqrt(fmax(taut_field_high(&f[1]), 0)) /
                                             (least * speed) * rounded,
                                .radius = taut_field_high(&f[2]),
                                .rate = sqrt(fmax(taut_field_high(&f[3]), 0)) / speed * rounded,
                                .length = speed / PARTS / rounded};
        return;
    }
    for (int k = 0; k < 4; k++) {
        taut_field_halve(arena, &f[k], 0, &halves[0][k], &halves[1][k]);
    }
    bound_parts(arena, halves[0], halvings - 1, parts);
    bound_parts(arena, halves[1], halvings - 1, parts + (1 << (halvings - 1)));
}

/* The parts on one side of part i, the nearest first, as far as `reach`: the largest curvature. The
 * axis goes on straight beyond its ends. */
static double sharpest_within(const part_of_axis *parts, int i, int step, double reach)
{
    double sharpest = 0, length = 0;
    for (int k = i + step; k >= 0 && k < PARTS && !(length > reach); k += step) {
        sharpest = taut_certify_max(sharpest, parts[k].curvature);
        length += parts[k].length;
    }
    return sharpest;
}

/* A bound of the cosine from below for spheres about part i; NAN where there is none. */
static double cosine_bound(const part_of_axis *parts, int i)
{
    const double r = parts[i].radius, rate = parts[i].rate;
    double curvature = parts[i].curvature;
    for (int k = 0; k < PARTS; k++) {
        const double bend = 1 - r * curvature * rounded, reach = r * rate / bend * rounded;
        if (!(bend > 0)) {
            return NAN;
        }
        const double wider = taut_certify_max(sharpest_within(parts, i, -1, reach),
                                              sharpest_within(parts, i, 1, reach));
        if (wider <= curvature) {
            return 1 - rounded * rate * rate / bend * (1 + 0.5 * r * curvature / bend);
        }
        curvature = wider;
    }
    return NAN;
}

static int is_graph(taut_arena *arena, const terms *t)
{
    const taut_field f[4] = {t->speed, t->area, t->radius, t->square};
    part_of_axis parts[PARTS];
    int holds = 1;
    bound_parts(arena, f, HALVINGS, parts);
    for (int i = 0; i < PARTS && holds; i++) {
        holds = cosine_bound(parts, i) > limit;
    }
    return holds;
}

/* The least that is seen of either, and where. */
typedef struct seen {
    double least[2], at[2];
} seen;

static void see(seen *s, int claim, double value, double t)
{
    if (!(value >= s->least[claim]) && !isnan(s->least[claim])) {
        s->least[claim] = value;
        s->at[claim] = t;
    }
}

/* The way to x from its foot, as one comes to it down from t in the direction of `step`: that of
 * another part of the axis, which may be nearer, is none of its tube. */
static void descend(const taut_pipe_sweep *sweep, const double x[3], double t, double step,
                    double way[3])
{
    double slope = 0, size = 0;
    do {
        double tangent[3];
        for (int k = 0; k < 3; k++) {
            way[k] = x[k] - taut_field_value(&sweep->axis[0][k], t, 0);
            tangent[k] = taut_field_value(&sweep->axis[1][k], t, 0);
        }
        size = taut_norm(tangent);
        slope = taut_dot(way, tangent) / size;
        taut_add_scaled(-slope / size, tangent, way);
        t += step;
    } while (slope * step > 0 && t >= 0 && t <= 1);
}

/* The least of both around the characteristic circle at t, the first by its formula. */
static void see_ring(const taut_pipe_sweep *sweep, const terms *fields, double t, seen *s)
{
    const taut_pipe_line *line = &sweep->parts->line;
    const double q = taut_field_value(&fields->speed, t, 0);
    const double a = taut_field_value(&fields->room, t, 0);
    const double b = taut_field_value(&fields->curve, t, 0);
    const double r = taut_field_value(&fields->radius, t, 0);
    const double slope = taut_field_value(&fields->slope, t, 0) / r;
    const double part = taut_field_value(&fields->real, t, 0) / q;
    double p[3], tangent[3], bend[3], across[3][3];
    int least = 0;

    see(s, 0, part > 0 ? (a - sqrt(fmax(b, 0))) / (q * q) : part, t);
    if (!(part > 0)) {
        see(s, 1, part, t);
        return;
    }
    for (int k = 0; k < 3; k++) {
        p[k] = taut_field_value(&sweep->axis[0][k], t, 0);
        tangent[k] = taut_field_value(&sweep->axis[1][k], t, 0) / sqrt(q);
        bend[k] = taut_field_value(&sweep->axis[2][k], t, 0);
    }
    for (int k = 1; k < 3; k++) {
        least = fabs(tangent[k]) < fabs(tangent[least]) ? k : least;
    }
    taut_add_scaled(-taut_dot(bend, tangent), tangent, bend);
    if (!(taut_norm(bend) > TAUT_PIPE_STRAIGHT * q)) { /* straight: any direction will do */
        for (int k = 0; k < 3; k++) {
            bend[k] = (k == least) - tangent[least] * tangent[k];
        }
    }
    taut_pipe_unit(bend, across[0]);
    taut_cross(tangent, across[0], across[1]);
    for (int i = 0; i < AROUND; i++) {
        const double phi = 2 * TAUT_PI * i / AROUND, out = sqrt(part);
        double n[3], x[3], way[3], at = 0;
        int piece = 0;
        for (int k = 0; k < 3; k++) {
            n[k] = -slope / sqrt(q) * tangent[k] +
                   out * (taut_cos(phi) * across[0][k] + taut_sin(phi) * across[1][k]);
            x[k] = p[k] + r * n[k];
        }
        taut_pipe_find_foot(line, x, t, &piece, &at, way);
        if (!(taut_dot(n, way) > limit * taut_norm(way))) {
            descend(sweep, x, t, slope > 0 ? -FINE : FINE, way);
        }
        see(s, 1, taut_dot(n, way) / taut_norm(way), t);
    }
}

/* A claim about the least value of something that must stay positive; sign as of
 * taut_pipe_sign_of. */
static taut_status claim_above(const char *name, double least, double at, int sign,
                               taut_certificate *certificate)
{
    char where[80] = "";
    const int is_range = !isfinite(least);
    taut_claim claim = {.claim = name,
                        .kind = TAUT_BOUND,
                        .residual = least,
                        .limit = limit,
                        .holds = is_range    ? TAUT_UNDECIDED
                                 : sign < 0  ? TAUT_FALSE
                                 : sign == 0 ? TAUT_UNDECIDED
                                             : TAUT_TRUE,
                        .where = where};
    if (is_range) {
        snprintf(where, sizeof where, TAUT_CERTIFY_OUT_OF_RANGE);
    } else {
        snprintf(where, sizeof where, "t = %.6g%s", at,
                 sign == 0 ? ": the bound does not come near what is seen" : "");
    }
    return taut_certificate_add(certificate, &claim);
}

taut_status taut_pipe_claim_envelope(const taut_pipe_parts *parts, taut_certificate *certificate)
{
    taut_arena *const arena = taut_arena_new();
    taut_pipe_sweep sweep = {.parts = parts};
    seen s = {{INFINITY, INFINITY}, {0, 0}};
    int regular = 0, graph = 0;
    taut_status status = TAUT_OK;

    taut_pipe_sweep_curve(arena, parts->axis, &sweep);
    if (taut_pipe_sweep_derive(arena, &sweep)) {
        const terms t = terms_of(arena, &sweep);
        for (int i = 0; i <= PLACES && t.curve.a != NULL; i++) {
            see_ring(&sweep, &t, (double)i / PLACES, &s);
        }
        regular = regular_sign(arena, &t);
        graph = s.least[1] < limit - clear ? -1 : regular > 0 && is_graph(arena, &t);
    }
    status = taut_arena_status(arena);
    taut_arena_free(arena);
    status = status == TAUT_OK ? claim_above("regular", s.least[0], s.at[0], regular, certificate)
                               : status;
    return status == TAUT_OK ? claim_above("graph", s.least[1], s.at[1], graph, certificate)
                             : status;
}
