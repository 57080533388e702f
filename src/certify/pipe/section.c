/* section.c -- elliptic sections, by a frame of the certificate's own: the transport equation
 *
 *     U' = -(U . T') T
 *
 * by the classical Runge-Kutta method of order 4 on fixed steps, begun along the first major axis;
 * and psi at the end from the direction wanted there ([WangBai2018] section 10.6).
 */
#include "certify/pipe/parts.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

enum { STEPS = 2048, GAUSS = 12, INTERVALS = 32, AROUND = 48 };

static void tangent_of(const taut_pipe_piece *piece, double s, double tangent[3], double turn[3])
{
    double d[3][3], speed = 0;
    taut_pipe_piece_eval(piece, s, 2, d);
    speed = taut_norm(d[1]);
    for (int k = 0; k < 3; k++) {
        tangent[k] = d[1][k] / speed;
    }
    for (int k = 0; k < 3; k++) {
        turn[k] = (d[2][k] - taut_dot(d[2], tangent) * tangent[k]) / speed;
    }
}

static void transport_rate(const taut_pipe_piece *piece, double s, const double u[3],
                           const double k[3], double h, double out[3])
{
    double tangent[3], turn[3], at[3];
    memcpy(at, u, sizeof at);
    taut_add_scaled(h, k, at);
    tangent_of(piece, s, tangent, turn);
    for (int i = 0; i < 3; i++) {
        out[i] = -taut_dot(at, turn) * tangent[i];
    }
}

/* One step from s to s + h. */
static void transport(const taut_pipe_piece *piece, double s, double h, double u[3])
{
    double k1[3], k2[3], k3[3], k4[3];
    transport_rate(piece, s, u, u, 0, k1);
    transport_rate(piece, s + 0.5 * h, u, k1, 0.5 * h, k2);
    transport_rate(piece, s + 0.5 * h, u, k2, 0.5 * h, k3);
    transport_rate(piece, s + h, u, k3, h, k4);
    for (int i = 0; i < 3; i++) {
        u[i] += h * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) / 6;
    }
}

static void make_across(const double direction[3], const double tangent[3], double out[3])
{
    double size = 0;
    memcpy(out, direction, 3 * sizeof *out);
    taut_add_scaled(-taut_dot(direction, tangent), tangent, out);
    size = taut_norm(out);
    for (int k = 0; k < 3; k++) {
        out[k] = size > 0 ? out[k] / size : 0;
    }
}

/* Circles of two radii: any direction across the axis will do. */
static void set_circle(taut_pipe_parts *parts, int side, double radius)
{
    const double *tangent = parts->line.tangent[side];
    taut_pipe_ellipse *const e = &parts->ellipses[side];
    int least = 0;
    for (int k = 1; k < 3; k++) {
        least = fabs(tangent[k]) < fabs(tangent[least]) ? k : least;
    }
    *e = (taut_pipe_ellipse){.a = radius, .b = radius};
    e->direction[least] = 1;
    parts->unlike = 1;
}

static void set_asked(const taut_pipe_section *section, taut_pipe_parts *parts)
{
    for (int side = 0; side < 2; side++) {
        if (section->kind == TAUT_PIPE_ELLIPTIC) {
            parts->ellipses[side] = section->ellipses[side];
        } else if (section->kind != TAUT_PIPE_ROUND) {
            set_circle(parts, side, section->radii[side]);
        }
    }
    parts->canal = section->kind == TAUT_PIPE_CANAL;
}

static void set_told(const taut_record *details, taut_pipe_parts *parts)
{
    const taut_record *list = taut_record_get(details, "sections");
    const taut_record *radii = taut_record_get(details, "radii");
    const char *surface = taut_record_text(taut_record_get(details, "surface"));
    for (size_t side = 0; side < 2; side++) {
        const taut_record *told = taut_record_at(list, side);
        const double radius = radii != NULL ? taut_record_number(taut_record_at(radii, side)) : 0;
        taut_pipe_ellipse *const e = &parts->ellipses[side];
        if (radius > 0) {
            set_circle(parts, (int)side, radius);
            parts->canal = surface != NULL && strcmp(surface, "canal") == 0;
        } else if (told != NULL) {
            const taut_record *direction = taut_record_get(told, "direction");
            e->a = taut_record_number(taut_record_get(told, "a"));
            e->b = taut_record_number(taut_record_get(told, "b"));
            for (size_t k = 0; k < 3; k++) {
                e->direction[k] = taut_record_number(taut_record_at(direction, k));
            }
        }
    }
}

taut_status taut_pipe_read_sections(const taut_model *model, taut_pipe_parts *parts)
{
    const taut_pipe_line *line = &parts->line;
    const taut_pipe_ellipse *s = parts->ellipses;
    double u[3], w[3], wanted[3], angle = 0, large = 0, small = INFINITY;

    parts->flatness = 1;
    if (parts->problem != NULL) {
        set_asked(&parts->problem->section, parts);
    } else {
        set_told(taut_model_details(model), parts);
    }
    for (int i = 0; i < 2; i++) {
        large = fmax(large, fmax(s[i].a, s[i].b));
        small = fmin(small, fmin(s[i].a, s[i].b));
    }
    if (!(small > 0)) {
        parts->ellipses[0].a = 0;
        return TAUT_OK;
    }
    parts->radius = large;
    parts->flatness = large / small;
    parts->frames =
        taut_arena_take(line->arena, (size_t)line->count * (STEPS + 1), sizeof *parts->frames);
    if (parts->frames == NULL) {
        return TAUT_NO_MEMORY;
    }
    make_across(s[0].direction, line->tangent[0], u);
    for (int i = 0; i < line->count; i++) {
        for (int k = 0; k <= STEPS; k++) {
            memcpy(parts->frames[i * (STEPS + 1) + k], u, sizeof u);
            if (k < STEPS) {
                transport(&line->pieces[i], (double)k / STEPS, 1.0 / STEPS, u);
            }
        }
    }
    make_across(s[1].direction, line->tangent[1], wanted);
    taut_cross(line->tangent[1], u, w);
    angle = taut_atan2(taut_dot(wanted, w), taut_dot(wanted, u));
    parts->turn = parts->unlike           ? 0 /* of circles */
                  : angle > TAUT_PI / 2   ? angle - TAUT_PI
                  : angle <= -TAUT_PI / 2 ? angle + TAUT_PI
                                          : angle;
    return TAUT_OK;
}

/* How far along from the first section to the second: the curve's range is [0, 1]; and its rate by
 * the piece's own parameter (NULL: not wanted). */
static double evaluate_step(const taut_pipe_parts *parts, int piece, double s, double *rate_of)
{
    const taut_pipe_piece *p = &parts->line.pieces[piece];
    const double t = p->lo + s * (p->hi - p->lo), v = 1 - t;
    if (rate_of != NULL) {
        *rate_of = (p->hi - p->lo) * (parts->quintic ? 30 * t * t * v * v : 6 * t * v);
    }
    return parts->quintic ? t * t * t * (10 + t * (6 * t - 15)) : t * t * (3 - 2 * t);
}

void taut_pipe_section_frame(const taut_pipe_parts *parts, int piece, double s, double u[3],
                             double w[3], double turn[3])
{
    const int k = (int)fmin(STEPS - 1, floor(s * STEPS));
    double tangent[3];
    memcpy(u, parts->frames[piece * (STEPS + 1) + k], 3 * sizeof *u);
    transport(&parts->line.pieces[piece], (double)k / STEPS, s - (double)k / STEPS, u);
    tangent_of(&parts->line.pieces[piece], s, tangent, turn);
    taut_cross(tangent, u, w);
}

double taut_pipe_section_miss(const taut_pipe_parts *parts, int piece, double s,
                              const double offset[3])
{
    const taut_pipe_ellipse *e = parts->ellipses;
    const double part = evaluate_step(parts, piece, s, NULL), angle = parts->turn * part;
    const double a = e[0].a + (e[1].a - e[0].a) * part, b = e[0].b + (e[1].b - e[0].b) * part;
    double u[3], w[3], turn[3], q = 0;

    taut_pipe_section_frame(parts, piece, s, u, w, turn);
    const double x0 = parts->line.scale * taut_dot(offset, u);
    const double y0 = parts->line.scale * taut_dot(offset, w);
    const double x = (taut_cos(angle) * x0 + taut_sin(angle) * y0) / a;
    const double y = (taut_cos(angle) * y0 - taut_sin(angle) * x0) / b;
    q = taut_hypot(x, y);
    /* |q - 1| over the length of its gradient, over the radius: the distance to first order */
    return q > 0 ? fabs(q - 1) * q / taut_hypot(x / a, y / b) / parts->radius : 1;
}

double taut_pipe_section_volume(const taut_pipe_parts *parts)
{
    const taut_pipe_ellipse *e = parts->ellipses;
    const double scale = parts->line.scale;
    double nodes[GAUSS], weights[GAUSS], sum = 0;
    taut_gauss_rule(GAUSS, nodes, weights);
    for (int i = 0; i < parts->line.count; i++) {
        for (int k = 0; k < INTERVALS * GAUSS; k++) {
            const double s = (k / GAUSS + 0.5 * (1 + nodes[k % GAUSS])) / INTERVALS;
            const double part = evaluate_step(parts, i, s, NULL);
            double d[2][3];
            taut_pipe_piece_eval(&parts->line.pieces[i], s, 1, d);
            sum += 0.5 / INTERVALS * weights[k % GAUSS] * taut_norm(d[1]) *
                   (e[0].a + (e[1].a - e[0].a) * part) * (e[0].b + (e[1].b - e[0].b) * part);
        }
    }
    return TAUT_PI * sum * scale;
}

/* The mean over phi of |X_s x X_phi|, times 2 pi: with E_1, E_2 and X_s = A T + p E_1 + q E_2,
 *     A = |P'| - a cos phi E_1 . T' - b sin phi E_2 . T'
 *     p = a' cos phi - psi' b sin phi,   q = b' sin phi + psi' a cos phi
 *     |X_s x X_phi|^2 = (p b cos phi + q a sin phi)^2 + A^2 (b^2 cos^2 phi + a^2 sin^2 phi)
 * the trapezoidal rule is exact but for terms of the order of its points. */
static double ring_area(const taut_pipe_parts *parts, int piece, double s, int points)
{
    const taut_pipe_ellipse *e = parts->ellipses;
    const double scale = parts->line.scale;
    double rate_of = 0, u[3], w[3], turn[3], d[2][3], sum = 0;
    const double part = evaluate_step(parts, piece, s, &rate_of), angle = parts->turn * part;
    const double da = (e[1].a - e[0].a) / scale, db = (e[1].b - e[0].b) / scale;
    const double a = e[0].a / scale + da * part, b = e[0].b / scale + db * part;
    const double twist = parts->turn * rate_of;
    taut_pipe_section_frame(parts, piece, s, u, w, turn);
    taut_pipe_piece_eval(&parts->line.pieces[piece], s, 1, d);
    const double speed = taut_norm(d[1]), x = taut_dot(u, turn), y = taut_dot(w, turn);
    const double k1 = a * (taut_cos(angle) * x + taut_sin(angle) * y);
    const double k2 = b * (taut_cos(angle) * y - taut_sin(angle) * x);
    for (int k = 0; k < points; k++) {
        const double c = taut_cos(2 * TAUT_PI * k / points), z = taut_sin(2 * TAUT_PI * k / points);
        const double along = speed - c * k1 - z * k2;
        const double p = da * rate_of * c - twist * b * z, q = db * rate_of * z + twist * a * c;
        const double side = p * b * c + q * a * z;
        sum += sqrt(side * side + along * along * (b * b * c * c + a * a * z * z));
    }
    return 2 * TAUT_PI * sum / points;
}

double taut_pipe_section_area(const taut_pipe_parts *parts)
{
    const double scale = parts->line.scale;
    /* flat ellipses have poles of the root near the real phi */
    const int points = (int)fmin(4096, AROUND * ceil(parts->flatness));
    double nodes[GAUSS], weights[GAUSS], sum = 0;
    taut_gauss_rule(GAUSS, nodes, weights);
    for (int i = 0; i < parts->line.count; i++) {
        for (int k = 0; k < INTERVALS * GAUSS; k++) {
            const double s = (k / GAUSS + 0.5 * (1 + nodes[k % GAUSS])) / INTERVALS;
            sum += 0.5 / INTERVALS * weights[k % GAUSS] * ring_area(parts, i, s, points);
        }
    }
    return sum * scale * scale;
}
