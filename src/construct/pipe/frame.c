#include "construct/pipe/frame.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "numeric/bernstein.h"

#include <math.h>
#include <string.h>

enum {
    SAMPLES = 512, /* of a binormal */
    GOLDEN_STEPS = 60,
    CARRY_STEPS = 4096, /* from end to end, for the turn of a section */
    ROOM_SAMPLES = 2000 /* of what a canal surface leaves */
};

static void make_unit(double v[3])
{
    const double length = taut_length(v);
    for (int k = 0; k < 3 && length > 0; k++) {
        v[k] /= length;
    }
}

void taut_pipe_first_normal(const double tangent[3], double u[3])
{
    int least = 0;
    for (int k = 1; k < 3; k++) {
        least = fabs(tangent[k]) < fabs(tangent[least]) ? k : least;
    }
    for (int k = 0; k < 3; k++) {
        u[k] = (k == least ? 1.0 : 0.0) - tangent[least] * tangent[k];
    }
    make_unit(u);
}

/* v - 2 (m . v) m / (m . m) */
static void mirror_vector(const double m[3], double square, double v[3])
{
    taut_add_scaled(-2 * taut_dot(m, v) / square, m, v);
}

int taut_pipe_reflect(const double x0[3], const double t0[3], const double r0[3],
                      const double x1[3], const double t1[3], double r1[3])
{
    double v1[3], v2[3], r[3], t[3];
    double c1 = 0, c2 = 0;

    memcpy(r, r0, sizeof r);
    memcpy(t, t0, sizeof t);
    taut_difference(x1, x0, v1);
    c1 = taut_dot(v1, v1);
    if (!(c1 > 0)) {
        return 0;
    }
    mirror_vector(v1, c1, r);
    mirror_vector(v1, c1, t);
    taut_difference(t1, t, v2);
    c2 = taut_dot(v2, v2);
    if (!(c2 > 0.01)) { /* it is near 4 for short steps */
        return 0;
    }
    mirror_vector(v2, c2, r);
    memcpy(r1, r, sizeof r);
    return 1;
}

/* Are the three points one? At a cusp, in double precision, they can be, and no halves help. */
static int stand_still(const taut_pipe_jet *a, const taut_pipe_jet *b, const taut_pipe_jet *c)
{
    return memcmp(a->point, b->point, sizeof a->point) == 0 &&
           memcmp(b->point, c->point, sizeof b->point) == 0;
}

/* One step, in halves where it is too long; at the bottom the vector is only made normal. */
static void carry_step(const taut_pipe_arc *arc, const taut_pipe_jet *from, double t0, double t1,
                       int depth, double u[3], taut_pipe_jet *to)
{
    taut_pipe_jet middle;
    taut_pipe_arc_jet(arc, t1, to);
    if (taut_pipe_reflect(from->point, from->tangent, u, to->point, to->tangent, u)) {
        return;
    }
    taut_pipe_arc_jet(arc, 0.5 * (t0 + t1), &middle);
    if (depth > 0 && !stand_still(from, &middle, to)) {
        carry_step(arc, from, t0, 0.5 * (t0 + t1), depth - 1, u, &middle);
        carry_step(arc, &middle, 0.5 * (t0 + t1), t1, depth - 1, u, to);
        return;
    }
    taut_add_scaled(-taut_dot(u, to->tangent), to->tangent, u);
    make_unit(u);
}

void taut_pipe_carry(const taut_pipe_arc *arc, double from, double to, int steps, double u[3])
{
    taut_pipe_jet here, there;
    taut_pipe_arc_jet(arc, from, &here);
    for (int i = 0; i < steps; i++) {
        const double t0 = from + (to - from) * i / steps;
        const double t1 = i + 1 == steps ? to : from + (to - from) * (i + 1) / steps;
        carry_step(arc, &here, t0, t1, 20, u, &there);
        here = there;
    }
}

void taut_pipe_bishop(const taut_pipe_arc *arc, double t, const double u[3],
                      taut_pipe_normals *normals)
{
    taut_pipe_jet jet;
    taut_pipe_arc_jet(arc, t, &jet);
    memcpy(normals->u, u, sizeof normals->u);
    taut_cross(jet.tangent, u, normals->w);
    for (int k = 0; k < 3; k++) {
        normals->du[k] = -taut_dot(normals->u, jet.turn) * jet.tangent[k];
        normals->dw[k] = -taut_dot(normals->w, jet.turn) * jet.tangent[k];
        normals->ddu[k] = -taut_dot(normals->u, jet.bent) * jet.tangent[k] -
                          taut_dot(normals->u, jet.turn) * jet.turn[k];
        normals->ddw[k] = -taut_dot(normals->w, jet.bent) * jet.tangent[k] -
                          taut_dot(normals->w, jet.turn) * jet.turn[k];
    }
}

static double size_at(const taut_pipe_binormal *b, double t)
{
    double value[3];
    taut_bernstein_point(b->degree, 3, &b->k[0][0], t, value, NULL);
    return taut_length(value);
}

/* The smallest |K|: samples, then golden section beside the smallest of them. */
static void find_least(taut_pipe_binormal *b, double largest)
{
    const double ratio = 0.61803398874989485;
    double lo = 0, hi = 0;
    b->least = INFINITY;
    for (int i = 0; i <= SAMPLES; i++) {
        const double size = size_at(b, (double)i / SAMPLES);
        if (size < b->least) {
            b->least = size;
            b->least_at = (double)i / SAMPLES;
        }
    }
    lo = fmax(0, b->least_at - 1.0 / SAMPLES);
    hi = fmin(1, b->least_at + 1.0 / SAMPLES);
    for (int i = 0; i < GOLDEN_STEPS; i++) {
        const double left = hi - ratio * (hi - lo), right = lo + ratio * (hi - lo);
        *(size_at(b, left) <= size_at(b, right) ? &hi : &lo) =
            size_at(b, left) <= size_at(b, right) ? right : left;
    }
    if (size_at(b, 0.5 * (lo + hi)) < b->least) {
        b->least_at = 0.5 * (lo + hi);
        b->least = size_at(b, b->least_at);
    }
    b->least /= largest;
}

void taut_pipe_binormal_of(const taut_pipe_arc *arc, taut_pipe_binormal *b)
{
    const double zero = 1e-14; /* of the largest: the rounding of the products */
    const int degree = 2 * arc->degree - 4;
    double largest = 0;
    int p = 0, q = 0;

    *b = (taut_pipe_binormal){.degree = 0};
    for (int i = 0; i <= degree; i++) {
        largest = fmax(largest, taut_norm(arc->cross[i]));
    }
    if (!(largest > 0)) {
        return;
    }
    while (taut_norm(arc->cross[p]) <= zero * largest) {
        p++;
    }
    while (taut_norm(arc->cross[degree - q]) <= zero * largest) {
        q++;
    }
    b->degree = degree - p - q;
    largest = 0;
    for (int i = 0; i <= b->degree; i++) {
        const double ratio = taut_binomial(degree, i + p) / taut_binomial(b->degree, i);
        for (int k = 0; k < 3; k++) {
            b->k[i][k] = ratio * arc->cross[i + p][k];
        }
        largest = fmax(largest, taut_norm(b->k[i]));
    }
    find_least(b, largest);
}

/* B = K / |K|, B' = (K' - (B . K') B) / |K|, N = B x T. */
void taut_pipe_frenet(const taut_pipe_arc *arc, const taut_pipe_binormal *binormal, double t,
                      taut_pipe_normals *normals)
{
    taut_pipe_jet jet;
    double k1[3], part[3], size = 0;

    taut_pipe_arc_jet(arc, t, &jet);
    taut_bernstein_point(binormal->degree, 3, &binormal->k[0][0], t, normals->w, k1);
    size = taut_length(normals->w);
    for (int k = 0; k < 3; k++) {
        normals->w[k] /= size;
    }
    for (int k = 0; k < 3; k++) {
        normals->dw[k] = (k1[k] - taut_dot(normals->w, k1) * normals->w[k]) / size;
    }
    taut_cross(normals->w, jet.tangent, normals->u);
    taut_cross(normals->dw, jet.tangent, normals->du);
    taut_cross(normals->w, jet.turn, part);
    taut_add_scaled(1, part, normals->du);
}

/* 0 to 1 with its first two derivatives: t^2 (3 - 2 t), or t^3 (10 - 15 t + 6 t^2). */
static void evaluate_step(int smooth, double t, double s[3])
{
    const double u = 1 - t;
    s[0] = smooth ? t * t * t * (10 - 15 * t + 6 * t * t) : t * t * (3 - 2 * t);
    s[1] = smooth ? 30 * t * t * u * u : 6 * t * u;
    s[2] = smooth ? 60 * t * u * (u - t) : 6 * (u - t);
}

/* f e with its derivatives by the product rule. */
static void scale_vector(const double ends[2], const double s[3], const double e[3],
                         const double de[3], const double dde[3], double *out[3])
{
    const double change = ends[1] - ends[0], f = ends[0] + change * s[0];
    for (int k = 0; k < 3; k++) {
        out[0][k] = f * e[k];
        out[1][k] = change * s[1] * e[k] + f * de[k];
        out[2][k] = change * s[2] * e[k] + 2 * change * s[1] * de[k] + f * dde[k];
    }
}

/* With q = P' . P'', v = |P'| and w = r_s^2 = r'^2 / v^2,
 *     c = -(r r' / v^2) P',   rho = r sqrt(1 - w),   rho U and rho W with U' = -(U . T') T */
static void evaluate_canal(const taut_pipe_profile *canal, const taut_pipe_jet *jet,
                           const double s[3], const taut_pipe_normals *frame,
                           taut_pipe_normals *out)
{
    const double change = canal->canal * (canal->a[1] - canal->a[0]);
    const double r = canal->canal * canal->a[0] + change * s[0], r1 = change * s[1];
    const double r2 = change * s[2], v2 = jet->speed * jet->speed, q = taut_dot(jet->d1, jet->d2);
    const double w = r1 * r1 / v2, w1 = 2 * r1 * r2 / v2 - 2 * r1 * r1 * q / (v2 * v2);
    const double root = sqrt(fmax(1 - w, 1e-12));
    const double rho = r * root / canal->canal, g = r * r1 / v2 / canal->canal;
    const double rho1 = (r1 * root - 0.5 * r * w1 / root) / canal->canal;
    const double g1 = ((r1 * r1 + r * r2) / v2 - 2 * r * r1 * q / (v2 * v2)) / canal->canal;
    for (int k = 0; k < 3; k++) {
        out->c[k] = -g * jet->d1[k];
        out->dc[k] = -g1 * jet->d1[k] - g * jet->d2[k];
        out->u[k] = rho * frame->u[k];
        out->w[k] = rho * frame->w[k];
        out->du[k] = rho1 * frame->u[k] + rho * frame->du[k];
        out->dw[k] = rho1 * frame->w[k] + rho * frame->dw[k];
    }
}

/* r_ss = (r'' - r' q / v^2) / v^2 */
void taut_pipe_canal_room_of(const taut_pipe_profile *canal, const taut_pipe_arc *arc,
                             taut_pipe_canal_room *room)
{
    *room = (taut_pipe_canal_room){.real = INFINITY, .regular = INFINITY};
    for (int i = 0; i <= ROOM_SAMPLES; i++) {
        const double t = (double)i / ROOM_SAMPLES,
                     change = canal->canal * (canal->a[1] - canal->a[0]);
        double s[3];
        taut_pipe_jet jet;
        taut_pipe_arc_jet(arc, t, &jet);
        evaluate_step(canal->smooth, t, s);
        const double v2 = jet.speed * jet.speed, r = canal->canal * canal->a[0] + change * s[0];
        const double rs = change * s[1] / jet.speed;
        const double rss = (change * s[2] - change * s[1] * taut_dot(jet.d1, jet.d2) / v2) / v2;
        const double left = 1 - rs * rs - r * rss - r * jet.curvature * sqrt(fmax(1 - rs * rs, 0));
        if (1 - fabs(rs) < room->real) {
            room->real = 1 - fabs(rs);
            room->real_at = t;
        }
        if (left < room->regular) {
            room->regular = left;
            room->regular_at = t;
        }
    }
}

/* E_1' = psi' E_2 - (E_1 . T') T, E_2' = -psi' E_1 - (E_2 . T') T, and once more. */
void taut_pipe_profile_at(const taut_pipe_profile *profile, const taut_pipe_arc *arc, double t,
                          const taut_pipe_normals *frame, taut_pipe_normals *section)
{
    double s[3], e[2][3], de[2][3], dde[2][3];
    taut_pipe_jet jet;

    taut_pipe_arc_jet(arc, t, &jet);
    evaluate_step(profile->smooth, t, s);
    if (profile->canal > 0) {
        evaluate_canal(profile, &jet, s, frame, section);
        return;
    }
    const double c = taut_cos(profile->turn * s[0]), z = taut_sin(profile->turn * s[0]);
    const double rate[2] = {profile->turn * s[1], -profile->turn * s[1]};
    const double rate1[2] = {profile->turn * s[2], -profile->turn * s[2]};
    for (int k = 0; k < 3; k++) {
        e[0][k] = c * frame->u[k] + z * frame->w[k];
        e[1][k] = c * frame->w[k] - z * frame->u[k];
    }
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 3; k++) {
            de[i][k] = rate[i] * e[1 - i][k] - taut_dot(e[i], jet.turn) * jet.tangent[k];
        }
    }
    for (int i = 0; i < 2; i++) {
        const double along = taut_dot(de[i], jet.turn) + taut_dot(e[i], jet.bent);
        for (int k = 0; k < 3; k++) {
            dde[i][k] = rate1[i] * e[1 - i][k] + rate[i] * de[1 - i][k] - along * jet.tangent[k] -
                        taut_dot(e[i], jet.turn) * jet.turn[k];
        }
    }
    scale_vector(profile->a, s, e[0], de[0], dde[0],
                 (double *[]){section->u, section->du, section->ddu});
    scale_vector(profile->b, s, e[1], de[1], dde[1],
                 (double *[]){section->w, section->dw, section->ddw});
}

/* The part of a direction across the tangent, made unit; 0 where it has none. */
static int make_across(const double direction[3], const double tangent[3], double out[3])
{
    const double length = taut_norm(direction), along = 1e-6; /* sine */
    double size = 0;
    for (int k = 0; k < 3; k++) {
        out[k] = direction[k] / length;
    }
    taut_add_scaled(-taut_dot(out, tangent), tangent, out);
    size = taut_norm(out);
    for (int k = 0; k < 3 && size > along; k++) {
        out[k] /= size;
    }
    taut_add_scaled(-taut_dot(out, tangent), tangent, out);
    return size > along;
}

int taut_pipe_profile_turn(const taut_pipe_arc *arc, const double *const directions[2],
                           taut_pipe_profile *profile, int *side)
{
    taut_pipe_jet jet;
    double carried[3], wanted[3], w[3], angle = 0;

    *side = 0;
    taut_pipe_arc_jet(arc, 0, &jet);
    if (!make_across(directions[0], jet.tangent, profile->first)) {
        return 0;
    }
    *side = 1;
    taut_pipe_arc_jet(arc, 1, &jet);
    if (!make_across(directions[1], jet.tangent, wanted)) {
        return 0;
    }
    memcpy(carried, profile->first, sizeof carried);
    taut_pipe_carry(arc, 0, 1, CARRY_STEPS, carried);
    taut_cross(jet.tangent, carried, w);
    angle = taut_atan2(taut_dot(wanted, w), taut_dot(wanted, carried));
    profile->turn = angle > TAUT_PI / 2     ? angle - TAUT_PI
                    : angle <= -TAUT_PI / 2 ? angle + TAUT_PI
                                            : angle;
    return 1;
}
