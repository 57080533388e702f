#include "construct/pipe/section.h"

#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { STEPS = 4096, SAMPLES = 2000 };

static const double pi = 3.14159265358979323846;

/* 0 to 1 with its first two derivatives: t^2 (3 - 2 t), or t^3 (10 - 15 t + 6 t^2). */
static void step_at(int smooth, double t, double s[3])
{
    const double u = 1 - t;
    s[0] = smooth ? t * t * t * (10 - 15 * t + 6 * t * t) : t * t * (3 - 2 * t);
    s[1] = smooth ? 30 * t * t * u * u : 6 * t * u;
    s[2] = smooth ? 60 * t * u * (u - t) : 6 * (u - t);
}

/* f e with its derivatives by the product rule. */
static void scale(const double ends[2], const double s[3], const double e[3], const double de[3],
                  const double dde[3], double *out[3])
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
static void canal_at(const taut_pipe_ellipse *canal, const taut_pipe_jet *jet, const double s[3],
                     const taut_pipe_normals *frame, taut_pipe_normals *out)
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
void taut_pipe_canal_room_of(const taut_pipe_ellipse *canal, const taut_pipe_arc *arc,
                             taut_pipe_canal_room *room)
{
    *room = (taut_pipe_canal_room){.real = INFINITY, .regular = INFINITY};
    for (int i = 0; i <= SAMPLES; i++) {
        const double t = (double)i / SAMPLES, change = canal->canal * (canal->a[1] - canal->a[0]);
        double s[3];
        taut_pipe_jet jet;
        taut_pipe_arc_jet(arc, t, &jet);
        step_at(canal->smooth, t, s);
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
void taut_pipe_ellipse_at(const taut_pipe_ellipse *ellipse, const taut_pipe_arc *arc, double t,
                          const taut_pipe_normals *frame, taut_pipe_normals *section)
{
    double s[3], e[2][3], de[2][3], dde[2][3];
    taut_pipe_jet jet;

    taut_pipe_arc_jet(arc, t, &jet);
    step_at(ellipse->smooth, t, s);
    if (ellipse->canal > 0) {
        canal_at(ellipse, &jet, s, frame, section);
        return;
    }
    const double c = cos(ellipse->turn * s[0]), z = sin(ellipse->turn * s[0]);
    const double rate[2] = {ellipse->turn * s[1], -ellipse->turn * s[1]};
    const double rate1[2] = {ellipse->turn * s[2], -ellipse->turn * s[2]};
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
    scale(ellipse->a, s, e[0], de[0], dde[0], (double *[]){section->u, section->du, section->ddu});
    scale(ellipse->b, s, e[1], de[1], dde[1], (double *[]){section->w, section->dw, section->ddw});
}

/* The part of a direction across the tangent, made unit; 0 where it has none. */
static int across(const double direction[3], const double tangent[3], double out[3])
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

int taut_pipe_ellipse_turn(const taut_pipe_arc *arc, const double *const directions[2],
                           taut_pipe_ellipse *ellipse, int *side)
{
    taut_pipe_jet jet;
    double carried[3], wanted[3], w[3], angle = 0;

    *side = 0;
    taut_pipe_arc_jet(arc, 0, &jet);
    if (!across(directions[0], jet.tangent, ellipse->first)) {
        return 0;
    }
    *side = 1;
    taut_pipe_arc_jet(arc, 1, &jet);
    if (!across(directions[1], jet.tangent, wanted)) {
        return 0;
    }
    memcpy(carried, ellipse->first, sizeof carried);
    taut_pipe_carry(arc, 0, 1, STEPS, carried);
    taut_cross(jet.tangent, carried, w);
    angle = atan2(taut_dot(wanted, w), taut_dot(wanted, carried));
    ellipse->turn = angle > pi / 2 ? angle - pi : angle <= -pi / 2 ? angle + pi : angle;
    return 1;
}
