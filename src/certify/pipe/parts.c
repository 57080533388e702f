/* parts.c -- a finished pipe taken apart: its surfaces and curves, the polygon and the shape numbers
 * of its axis (a "ce-bezier" of four points, or a quintic whose points 0, 2, 3, 5 are the polygon),
 * feet on it; and how a claim is made that rounding may leave open.
 */
#include "certify/pipe/parts.h"
#include "certify/common/verdict.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { NEWTON_STEPS = 6 };

static const double limit_most = 1e-6;
/* Of a difference of an axis's points, over its size: products of four are still numbers. */
static const double shortest = 1e-70;
static const int places[4] = {0, 2, 3, 5};

taut_status taut_pipe_read_axis(taut_pipe_parts *parts, taut_error *error)
{
    const taut_basis *t = taut_curve_t(parts->axis);
    const double *points = taut_curve_points(parts->axis);
    taut_basis_spec spec;

    taut_basis_spec_of(t, &spec);
    parts->quintic = strcmp(taut_basis_type(t), "bezier") == 0 && taut_basis_degree(t) == 5;
    if (!parts->quintic && strcmp(taut_basis_type(t), "ce-bezier") != 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "name", "/curves/0/t/type", taut_none, taut_none,
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

    if (status != TAUT_OK) {
        return status;
    }
    for (int i = 0; i < 4; i++) {
        memcpy(points[parts->quintic ? places[i] : i], v[i], sizeof points[0]);
    }
    for (int k = 0; k < 3 && parts->quintic; k++) {
        points[1][k] = v[0][k] + first * (v[1][k] - v[0][k]);
        points[4][k] = v[3][k] - last * (v[3][k] - v[2][k]);
    }
    status = taut_curve_new("", basis, &points[0][0], NULL, curve, error);
    taut_basis_free(basis);
    return status;
}

double taut_pipe_held(double noise)
{
    return fmin(noise, limit_most);
}

taut_status taut_pipe_add_claim(const char *name, taut_claim_kind kind, double residual,
                                double limit, double noise, const char *where,
                                taut_certificate *certificate)
{
    const double held = limit > 0 ? limit : taut_pipe_held(noise);
    const taut_verdict holds = taut_certify_below(residual, held);
    const int is_noise = holds == TAUT_FALSE && residual <= noise;
    const taut_claim claim = {
        .claim = name,
        .kind = kind,
        .residual = residual,
        .limit = held,
        .holds = is_noise ? TAUT_UNDECIDED : holds,
        .where = is_noise                                   ? "rounding of the coordinates"
                 : holds == TAUT_UNDECIDED && where[0] == 0 ? TAUT_CERTIFY_OUT_OF_RANGE
                                                            : where,
    };
    return taut_certificate_add(certificate, &claim);
}

const taut_surface *taut_pipe_find_surface(const taut_model *model, const char *name)
{
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        if (strcmp(taut_surface_name(taut_model_surface(model, i)), name) == 0) {
            return taut_model_surface(model, i);
        }
    }
    return NULL;
}

const taut_curve *taut_pipe_find_curve(const taut_model *model, const char *name)
{
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        if (strcmp(taut_curve_name(taut_model_curve(model, i)), name) == 0) {
            return taut_model_curve(model, i);
        }
    }
    return NULL;
}

void taut_pipe_add_sizes(const taut_surface *surface, taut_pipe_parts *parts)
{
    const int count =
        3 * taut_basis_count(taut_surface_u(surface)) * taut_basis_count(taut_surface_v(surface));
    for (int i = 0; i < count; i++) {
        parts->sizes[i % 3] = fmax(parts->sizes[i % 3], fabs(taut_surface_points(surface)[i]));
    }
    parts->size = fmax(parts->sizes[0], fmax(parts->sizes[1], parts->sizes[2]));
}

double taut_pipe_radius_told(const taut_model *model, double seen)
{
    const double told = taut_record_number(taut_record_get(taut_model_details(model), "radius"));
    return told > 0 ? told : seen;
}

/* What is left of the proof that parts are far enough from each other is a pair of points like any
 * other, where it is far enough along the axis to count. */
static void offer_left(taut_pipe_parts *parts)
{
    const taut_pipe_apart *left = &parts->apart;
    taut_pipe_figures *const f = &parts->figures;
    const double around = parts->line.closed ? f->length - left->way : INFINITY;
    if (!left->proved && fmin(left->way, around) * f->curvature >= TAUT_PI * (1 - 1e-9) &&
        0.5 * left->distance < f->rho) {
        f->rho = 0.5 * left->distance;
        f->by_distance = 1;
        f->binding[0] = left->from;
        f->binding[1] = left->from + left->way;
    }
}

taut_status taut_pipe_find_figures(taut_pipe_parts *parts)
{
    const double radius = parts->radius / parts->line.scale;
    taut_status status = TAUT_OK;
    taut_pipe_integrate(&parts->line, &parts->figures);
    taut_pipe_bound_curvature(&parts->line, &parts->figures);
    status = taut_pipe_bound_reach(&parts->line, &parts->figures);
    parts->apart = (taut_pipe_apart){.proved = 1};
    parts->is_bent_little = 1;
    if (status == TAUT_OK && isfinite(parts->figures.rho)) {
        status = taut_pipe_prove_apart(&parts->line, radius, &parts->apart);
        offer_left(parts);
    }
    if (status == TAUT_OK && isfinite(parts->figures.rho)) {
        status = taut_pipe_prove_bend(parts, 1 / (radius * (1 + 1e-11)), &parts->is_bent_little);
    }
    return status;
}

void taut_pipe_add_torsion(taut_record *figures, double torsion)
{
    taut_record_add_number(figures, "total_torsion", torsion);
    if (isnan(torsion)) {
        taut_record_add_text(figures, "total_torsion_open",
                             "the curvature at an end of the axis cannot be told from 0");
    }
}

/* Of a curved piece, a difference of points so short beside the axis that its products vanish: no curvature
 * there is known. */
static int is_too_short(const taut_pipe_line *line)
{
    for (int i = 0; i < line->count; i++) {
        const taut_pipe_piece *piece = &line->pieces[i];
        for (int k = 0; piece->degree > 1 && k < piece->degree; k++) {
            double side[3];
            taut_difference(piece->points[k + 1], piece->points[k], side);
            const double longest = taut_largest_coordinate(side);
            if (longest > 0 && longest < shortest) {
                return 1;
            }
        }
    }
    return 0;
}

taut_status taut_pipe_claim_embedded(const taut_pipe_parts *parts, const char *where,
                                     taut_certificate *certificate)
{
    const double rho = parts->figures.rho, scale = parts->line.scale;
    const double residual = isfinite(rho) ? parts->radius / (rho * scale) : 0;
    /* about the wider of both: an axis that meets itself is not in doubt */
    const double open = 1e-11 + 8 * parts->line.noise * (1 + 1 / fmax(rho, parts->radius / scale));
    const int is_short = is_too_short(&parts->line);
    const int is_open = fabs(residual - 1) <= open || !(residual >= 0) || is_short;
    const int is_proved = residual == 0 || (parts->apart.proved && parts->is_bent_little);
    const taut_claim claim = {
        .claim = "embedded",
        .kind = TAUT_BOUND,
        .residual = residual,
        .limit = 1,
        .holds = is_open        ? TAUT_UNDECIDED
                 : residual > 1 ? TAUT_FALSE
                 : is_proved    ? TAUT_TRUE
                                : TAUT_UNDECIDED,
        .where = is_short                               ? TAUT_CERTIFY_OUT_OF_RANGE
                 : is_open || residual > 1 || is_proved ? where
                 : !parts->is_bent_little ? "how sharply the axis bends is not bounded"
                                          : "how near the axis comes to itself is not bounded",
    };
    return taut_certificate_add(certificate, &claim);
}

double taut_pipe_sideways(const taut_pipe_parts *parts, int side, const double changes[3])
{
    const double *tangent = parts->line.tangent[side];
    double most = 0;
    for (int k = 0; k < 3; k++) {
        const double rounding =
            tangent[k] != 0 || changes[k] != 0 ? 2 * DBL_EPSILON * parts->sizes[k] : 0;
        most = taut_hypot(most, rounding * sqrt(fmax((1 - tangent[k]) * (1 + tangent[k]), 0)));
    }
    return most;
}

void taut_pipe_find_foot(const taut_pipe_line *line, const double x[3], double t, int *at_piece,
                         double *at_s, double offset[3])
{
    const taut_pipe_piece *piece = &line->pieces[0];
    double s = 0, d[3][3], apart[3];
    for (int lo = 0, hi = line->count - 1; lo < hi;) { /* the first that reaches t, or the last */
        const int middle = (lo + hi) / 2;
        *(t > line->pieces[middle].hi ? &lo : &hi) = middle + (t > line->pieces[middle].hi);
        piece = &line->pieces[lo];
    }
    s = fmin(1, fmax(0, (t - piece->lo) / (piece->hi - piece->lo)));
    for (int i = 0; i < NEWTON_STEPS; i++) {
        taut_pipe_piece_eval(piece, s, 2, d);
        taut_difference(d[0], x, apart);
        const double slope = taut_dot(d[1], d[1]) + taut_dot(apart, d[2]);
        const double move = slope > 0 ? taut_dot(apart, d[1]) / slope : 0;
        s = fmin(1, fmax(0, s - move));
        if (fabs(move) < 1e-9) { /* the distance is flat there: its error is the square of that */
            break;
        }
    }
    taut_pipe_piece_eval(piece, s, 0, d);
    *at_piece = (int)(piece - line->pieces);
    *at_s = s;
    taut_difference(x, d[0], offset);
}

void taut_pipe_to_local(const taut_pipe_line *line, const double x[3], double local[3])
{
    for (int k = 0; k < 3; k++) {
        local[k] = (x[k] - line->origin[k]) / line->scale;
    }
}

double taut_pipe_parameter(const taut_basis *basis, int k, int n)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    return k == n ? hi : lo + (hi - lo) * k / n;
}

void taut_pipe_unit(const double v[3], double out[3])
{
    const double length = taut_norm(v);
    for (int k = 0; k < 3; k++) {
        out[k] = length > 0 ? v[k] / length : 0;
    }
}

void taut_pipe_unit_normal(const double xu[3], const double xv[3], double normal[3])
{
    const double u = taut_norm(xu), v = taut_norm(xv);
    double a[3], b[3], length = 0;
    for (int k = 0; k < 3; k++) {
        a[k] = u > 0 ? xu[k] / u : 0;
        b[k] = v > 0 ? xv[k] / v : 0;
    }
    taut_cross(a, b, normal);
    length = taut_norm(normal);
    for (int k = 0; k < 3 && length > 0; k++) {
        normal[k] /= length;
    }
}
