/* isometric.c
 *
 *     on each span the unit tangent of the net's field at the window's places, at Gauss's nodes
 *     k_g = S.T' and the edge's speed by derivatives of the polynomials through those nodes: no formula of
 *     rulings, nor third derivatives of the surface
 */
#include "certify/trace/isometric.h"

#include "certify/common/verdict.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "taut/measure.h"

#include <string.h>

enum { NODES = 14 };

/* What is known at a node of a span. */
typedef struct spot {
    double x[3], tangent[3], normal[3], sideways[3];
    double k_n, tau;
} spot;

/* d[i][k]: the derivative at node i of the k-th Lagrange polynomial of the nodes. */
static void derive(const double *nodes, double d[NODES][NODES])
{
    double scale[NODES];
    for (int i = 0; i < NODES; i++) {
        scale[i] = 1;
        for (int k = 0; k < NODES; k++) {
            scale[i] *= k == i ? 1 : 2 * (nodes[i] - nodes[k]);
        }
    }
    for (int i = 0; i < NODES; i++) {
        d[i][i] = 0;
        for (int k = 0; k < NODES; k++) {
            if (k != i) {
                d[i][k] = scale[i] / scale[k] / (nodes[i] - nodes[k]);
                d[i][i] += 1 / (nodes[i] - nodes[k]);
            }
        }
    }
}

/* The direction of the field nearest to (a, b): A a^2 + 2 B ab + C b^2 = 0, by Newton on the angle. */
static void correct(taut_trace_net net, const taut_forms *f, double ab[2])
{
    const int is_asymptotic = net == TAUT_TRACE_ASYMPTOTIC;
    const double p = is_asymptotic ? f->l : f->e * f->m - f->f * f->l;
    const double q = is_asymptotic ? f->m : (f->e * f->n - f->g * f->l) / 2;
    const double r = is_asymptotic ? f->n : f->f * f->n - f->g * f->m;
    if (net == TAUT_TRACE_GEODESIC || net == TAUT_TRACE_ISOPARAMETRIC) {
        return;
    }
    for (int round = 0; round < 4; round++) {
        const double a = ab[0], b = ab[1];
        const double value = p * a * a + 2 * q * a * b + r * b * b;
        const double slope = 2 * (q * (a * a - b * b) + (r - p) * a * b);
        const double turn = value / slope; /* (a, b) + turn (b, -a) has value - turn slope */
        ab[0] = a + turn * b;
        ab[1] = b - turn * a;
    }
}

/* Within the stretch that holds t. */
static int spot_at(const taut_net_lines *lines, const taut_surface *const *surfaces,
                   const taut_net_line *line, double t, spot *s)
{
    int k = 0;
    double window[2][3], at[2], x[3][3], cross[3];
    taut_forms f;

    while (k < line->count - 1 && t > taut_basis_hi(taut_curve_t(line->window[k]))) {
        k++;
    }
    if (line->count == 0 || taut_curve_eval(line->window[k], t, 1, window[0]) != TAUT_OK) {
        return 0;
    }
    const taut_surface *surface = surfaces[line->on[k]];
    for (int d = 0; d < 2; d++) {
        const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
        at[d] = fmin(fmax(window[0][d], taut_basis_lo(basis)), taut_basis_hi(basis));
    }
    if (taut_surface_forms_points(surface, 1, &at[0], &at[1], 1, &f) != TAUT_OK || !f.regular ||
        taut_surface_eval(surface, at[0], at[1], 1, x[0]) != TAUT_OK) {
        return 0;
    }
    double ab[2] = {window[1][0], window[1][1]};
    correct(lines->net, &f, ab);
    const double speed = sqrt(f.e * ab[0] * ab[0] + 2 * f.f * ab[0] * ab[1] + f.g * ab[1] * ab[1]);
    const double a = ab[0] / speed, b = ab[1] / speed;
    for (int c = 0; c < 3; c++) {
        s->x[c] = x[0][c];
        s->tangent[c] = a * x[1][c] + b * x[2][c];
    }
    memcpy(s->normal, f.normal, sizeof s->normal);
    taut_cross(f.normal, s->tangent, cross);
    memcpy(s->sideways, cross, sizeof s->sideways);
    s->k_n = f.l * a * a + 2 * f.m * a * b + f.n * b * b;
    s->tau =
        ((f.m * a + f.n * b) * (f.e * a + f.f * b) - (f.l * a + f.m * b) * (f.f * a + f.g * b)) /
        f.w;
    return 1;
}

/* What the edge at height h is long on a span; NAN where it is not known. */
static double edge_of(const taut_net_lines *lines, const taut_surface *const *surfaces,
                      const taut_net_line *line, const double ends[2], double scale, double h,
                      int is_envelope)
{
    double nodes[NODES], weights[NODES], d[NODES][NODES], edge[NODES][3], sum = 0;
    const double half = (ends[1] - ends[0]) / 2 * scale;
    spot spots[NODES];

    taut_gauss_rule(NODES, nodes, weights);
    derive(nodes, d);
    for (int k = 0; k < NODES; k++) {
        const double t = (ends[0] + ends[1]) / 2 + (ends[1] - ends[0]) / 2 * nodes[k];
        if (!spot_at(lines, surfaces, line, t, &spots[k])) {
            return NAN;
        }
    }
    for (int i = 0; i < NODES; i++) {
        const spot *s = &spots[i];
        double turned[3] = {0, 0, 0};
        for (int k = 0; k < NODES; k++) {
            taut_add_scaled(d[i][k] / half, spots[k].tangent, turned);
        }
        const double skew = is_envelope ? -s->tau / s->k_n : s->tau / taut_dot(turned, s->sideways);
        memcpy(edge[i], s->x, sizeof edge[i]);
        taut_add_scaled(h, is_envelope ? s->sideways : s->normal, edge[i]);
        taut_add_scaled(h * skew, s->tangent, edge[i]);
    }
    for (int i = 0; i < NODES; i++) {
        double speed[3] = {0, 0, 0};
        for (int k = 0; k < NODES; k++) {
            taut_add_scaled(d[i][k], edge[k], speed);
        }
        sum += weights[i] * taut_length(speed);
    }
    return sum;
}

/* `edge_length` of a curve of details; NAN where there is none. */
static double told_edge(const taut_net_lines *lines, const char *name)
{
    const taut_record *laths = taut_record_get(taut_model_details(lines->model), "laths");
    for (size_t k = 0; k < taut_record_count(laths); k++) {
        const taut_record *lath = taut_record_at(laths, k);
        const taut_record *edge = taut_record_get(lath, "edge_length");
        if (strcmp(taut_record_text(taut_record_get(lath, "name")), name) == 0) {
            return edge != NULL ? taut_record_number(edge) : NAN;
        }
    }
    return NAN;
}

double taut_net_isometric(const taut_net_lines *lines, const taut_surface *const *surfaces,
                          int unit, const taut_trace_problem *problem, const char **where)
{
    const taut_trace_laths *laths = problem != NULL ? problem->laths : NULL;
    double worst = -1;

    if (laths == NULL || !(laths->width > 0) ||
        (laths->strip != TAUT_TRACE_DEVELOPABLE && laths->strip != TAUT_TRACE_ENVELOPE)) {
        return worst;
    }
    for (int i = 0; i < lines->count; i++) {
        const taut_net_line *line = &lines->lines[i];
        const taut_basis *basis = taut_curve_t(line->space);
        const double *breaks = taut_basis_breaks(basis);
        double length = 0;
        for (int k = 0; k < taut_basis_span_count(basis); k++) {
            length += edge_of(lines, surfaces, line, breaks + k, ldexp(1, -unit),
                              ldexp(laths->width / 2, -unit), laths->strip == TAUT_TRACE_ENVELOPE);
        }
        const double told = ldexp(told_edge(lines, taut_curve_name(line->space)), -unit);
        const double away = fabs(told - length) / length;
        if (*where == NULL || !(away <= worst)) {
            *where = taut_curve_name(line->space);
        }
        worst = taut_certify_max(worst, isnan(away) ? INFINITY : away);
    }
    return worst;
}
