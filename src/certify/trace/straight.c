/* straight.c
 *
 * The distance, on each span of length h: e = C - S(c) is interpolated at both ends up to its second
 * derivative, and what is left is h^6/46080 |e^(6)|. C has degree 5, so e^(6) is that of S(p + tau(s) way),
 *
 *     g6 t1^6 + 15 g5 t1^4 t2 + g4 (20 t1^3 t3 + 45 t1^2 t2^2) + g3 (15 t1^2 t4 + 60 t1 t2 t3 + 15 t2^3)
 *     + g2 (6 t1 t5 + 15 t2 t4 + 10 t3^2),     g_k >= |d^k S/dt^k|, t_k >= |tau^(k)| by control points
 *
 * On the family, S = Re (A z + B e^(iz) + D e^(-iz)) with B.B = D.D = 0: for k >= 2 all g_k are
 * scale sqrt(2) cosh(y)/w at most ([XuWang2006] section 10); on Enneper's surface g3 is constant, g4 to g6
 * vanish.
 */
#include "certify/trace/straight.h"

#include "basis/basis_ops.h"
#include "certify/bonnet/parts.h"
#include "core/vec3.h"
#include "taut/measure.h"

#include <string.h>

enum { DEGREE = 5, ORDERS = 3, DERIVATIVES = 7 };
/* The Hopf differential of two spans, relative: they are one surface. */
static const double same_hopf = 1e-9;
/* The most of the basis functions of quintic Hermite interpolation for first and second derivatives. */
static const double first_most = 0.2, second_most = 0.0175;

static int hopf_at(const taut_surface *surface, int i, int j, double hopf[2])
{
    const double *bu = taut_basis_breaks(taut_surface_u(surface)) + i;
    const double *bv = taut_basis_breaks(taut_surface_v(surface)) + j;
    const double u = bu[0] + (bu[1] - bu[0]) / 2, v = bv[0] + (bv[1] - bv[0]) / 2;
    taut_forms forms;

    if (taut_surface_forms_points(surface, 1, &u, &v, 1, &forms) != TAUT_OK || !forms.regular) {
        return 0;
    }
    hopf[0] = forms.l;
    hopf[1] = forms.m;
    return 1;
}

void taut_net_straight_look(const taut_surface *surface, taut_net_straight *straight)
{
    const int spans[2] = {taut_basis_span_count(taut_surface_u(surface)),
                          taut_basis_span_count(taut_surface_v(surface))};
    *straight = (taut_net_straight){0};
    if (!taut_bonnet_is_algebraic(surface) ||
        taut_surface_recognise(surface, &straight->member, NULL) != TAUT_OK ||
        !hopf_at(surface, 0, 0, straight->hopf)) {
        return;
    }
    const double size = taut_hypot(straight->hopf[0], straight->hopf[1]);
    for (int i = 0; i < spans[0]; i++) {
        for (int j = 0; j < spans[1]; j++) {
            double there[2];
            if (!hopf_at(surface, i, j, there) ||
                !(taut_hypot(there[0] - straight->hopf[0], there[1] - straight->hopf[1]) <=
                  same_hopf * size)) {
                return;
            }
        }
    }
    straight->is_known = size > 0;
}

/* In conformal parameters, at the angle psi: k_n E = L cos 2 psi + M sin 2 psi, tau_g E = M cos 2 psi - L
 * sin 2 psi. */
void taut_net_straight_way(const taut_net_straight *straight, taut_trace_net net, int family,
                           double way[2])
{
    const double l = straight->hopf[0], m = straight->hopf[1], sign = family == 0 ? 1 : -1;
    const double psi = net == TAUT_TRACE_ASYMPTOTIC ? taut_atan2(-sign * l, sign * m) / 2
                                                    : taut_atan2(sign * m, sign * l) / 2;
    way[0] = taut_cos(psi);
    way[1] = taut_sin(psi);
}

double taut_net_straight_residual(const taut_net_line *line, const double way[2])
{
    double across = 0, along = INFINITY;
    for (int k = 0; k < line->count; k++) {
        const taut_basis *basis = taut_curve_t(line->window[k]);
        const double *points = taut_curve_points(line->window[k]);
        const double *knots = basis->knots;
        for (int i = 0; i + 1 < taut_basis_count(basis); i++) {
            const double width = knots[i + 1 + DEGREE] - knots[i + 1];
            const double du = (points[3 * i + 3] - points[3 * i]) / width;
            const double dv = (points[3 * i + 4] - points[3 * i + 1]) / width;
            if (width > 0) {
                across = fmax(across, fabs(du * way[1] - dv * way[0]));
                along = fmin(along, fabs(du * way[0] + dv * way[1]));
            }
        }
    }
    return line->count > 0 && along > across ? 2 * across / along : INFINITY;
}

/* Derivatives up to the second of a curve by the polynomial of a span. */
static void in_span(const taut_curve *curve, int span, double t, double out[ORDERS][3])
{
    const taut_basis *basis = taut_curve_t(curve);
    const double *points = taut_curve_points(curve) + 3 * taut_basis_first(basis, span);
    double values[ORDERS * (DEGREE + 1)];
    taut_basis_eval(basis, span, t, ORDERS - 1, values);
    memset(out, 0, ORDERS * sizeof out[0]);
    for (int k = 0; k < ORDERS; k++) {
        for (int a = 0; a <= DEGREE; a++) {
            taut_add_scaled(values[k * (DEGREE + 1) + a], points + 3 * a, out[k]);
        }
    }
}

/* How far C and S(c) are apart at an end of a span, to second derivatives over s; and x_t, x_tt of the line
 * there. */
typedef struct end_gap {
    double gap[ORDERS];
    double first[3], second[3];
} end_gap;

static int gap_at(const taut_surface *surface, const taut_net_line *line, int unit, int span,
                  double t, const double way[2], end_gap *end)
{
    double space[ORDERS][3], window[ORDERS][3], x[6][3];
    double at[2];

    in_span(line->space, span, t, space);
    in_span(line->window[0], span, t, window);
    for (int d = 0; d < 2; d++) {
        const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
        at[d] = fmin(fmax(window[0][d], taut_basis_lo(basis)), taut_basis_hi(basis));
        if (fabs(at[d] - window[0][d]) > 1e-9) {
            return 0;
        }
    }
    if (taut_surface_eval(surface, at[0], at[1], 2, x[0]) != TAUT_OK) {
        return 0;
    }
    const double a = window[1][0], b = window[1][1];
    double away[ORDERS] = {0};
    for (int c = 0; c < 3; c++) {
        const double on[ORDERS] = {x[TAUT_X][c], a * x[TAUT_XU][c] + b * x[TAUT_XV][c],
                                   window[2][0] * x[TAUT_XU][c] + window[2][1] * x[TAUT_XV][c] +
                                       a * a * x[TAUT_XUU][c] + 2 * a * b * x[TAUT_XUV][c] +
                                       b * b * x[TAUT_XVV][c]};
        for (int k = 0; k < ORDERS; k++) {
            const double gap = ldexp(space[k][c], -unit) - on[k];
            away[k] += gap * gap;
        }
        end->first[c] = way[0] * x[TAUT_XU][c] + way[1] * x[TAUT_XV][c];
        end->second[c] = way[0] * way[0] * x[TAUT_XUU][c] + 2 * way[0] * way[1] * x[TAUT_XUV][c] +
                         way[1] * way[1] * x[TAUT_XVV][c];
    }
    for (int k = 0; k < ORDERS; k++) {
        end->gap[k] = sqrt(away[k]);
    }
    return 1;
}

/* t[k] >= |tau^(k)| on the span, tau the way along the line; *off >= how far c is beside it. */
static void bound_window(const taut_net_line *line, int span, double from, double to,
                         const double way[2], double t[DERIVATIVES], double *off)
{
    const double h = to - from;
    double ends[2][ORDERS][3], tau[DEGREE + 1], beside[DEGREE + 1];
    in_span(line->window[0], span, from, ends[0]);
    in_span(line->window[0], span, to, ends[1]);
    for (int part = 0; part < 2; part++) {
        double v[2][ORDERS];
        double *b = part == 0 ? tau : beside;
        for (int e = 0; e < 2; e++) {
            for (int k = 0; k < ORDERS; k++) {
                const double du = ends[e][k][0] - (k == 0 ? ends[0][0][0] : 0);
                const double dv = ends[e][k][1] - (k == 0 ? ends[0][0][1] : 0);
                v[e][k] = part == 0 ? du * way[0] + dv * way[1] : du * way[1] - dv * way[0];
            }
        }
        b[0] = v[0][0];
        b[1] = b[0] + h / 5 * v[0][1];
        b[2] = b[0] + 2 * h / 5 * v[0][1] + h * h / 20 * v[0][2];
        b[5] = v[1][0];
        b[4] = b[5] - h / 5 * v[1][1];
        b[3] = b[5] - 2 * h / 5 * v[1][1] + h * h / 20 * v[1][2];
    }
    *off = 0;
    for (int i = 0; i <= DEGREE; i++) {
        *off = fmax(*off, fabs(beside[i]));
    }
    double factor = 1;
    for (int k = 1; k <= DEGREE; k++) {
        factor *= (DEGREE + 1 - k) / h;
        t[k] = 0;
        for (int i = 0; i <= DEGREE - k; i++) {
            tau[i] = tau[i + 1] - tau[i];
            t[k] = fmax(t[k], fabs(tau[i]) * factor);
        }
    }
}

/* g[k] >= the k-th derivative of S along the line over the span, k >= 1. */
static void bound_surface(const taut_surface *surface, const taut_net_straight *straight,
                          const end_gap ends[2], double tau, double g[DERIVATIVES])
{
    const taut_family_member *m = &straight->member;
    if (m->lambda == 1) {
        double third[3];
        taut_difference(ends[1].second, ends[0].second, third);
        g[2] = fmax(taut_length(ends[0].second), taut_length(ends[1].second));
        g[3] = taut_length(third) / tau;
        g[1] = fmax(taut_length(ends[0].first), taut_length(ends[1].first)) + tau * g[2];
        g[4] = g[5] = g[6] = 0;
        return;
    }
    const taut_basis *along = m->turned ? taut_surface_u(surface) : taut_surface_v(surface);
    const double y =
        fmax(fabs(taut_basis_lo(along) + m->shift[1]), fabs(taut_basis_hi(along) + m->shift[1]));
    const double w = sqrt((1 - m->lambda) * (1 + m->lambda));
    g[1] = m->scale * (taut_cosh(y) + m->lambda) / w;
    for (int k = 2; k < DERIVATIVES; k++) {
        g[k] = m->scale * sqrt(2) * taut_cosh(y) / w;
    }
}

static double sixth(const double g[DERIVATIVES], const double t[DERIVATIVES])
{
    const double square = t[1] * t[1];
    return g[6] * square * square * square + 15 * g[5] * square * square * t[2] +
           g[4] * (20 * square * t[1] * t[3] + 45 * square * t[2] * t[2]) +
           g[3] * (15 * square * t[4] + 60 * t[1] * t[2] * t[3] + 15 * t[2] * t[2] * t[2]) +
           g[2] * (6 * t[1] * t[5] + 15 * t[2] * t[4] + 10 * t[3] * t[3]);
}

double taut_net_straight_distance(const taut_surface *surface, const taut_net_straight *straight,
                                  const taut_net_line *line, int unit, const double way[2])
{
    const taut_basis *basis = taut_curve_t(line->space);
    const double *breaks = taut_basis_breaks(basis);
    double most = 0;

    if (line->count != 1 || !taut_basis_equal(basis, taut_curve_t(line->window[0])) ||
        taut_basis_local(basis) != DEGREE + 1) {
        return INFINITY;
    }
    for (int i = 0; i < taut_basis_span_count(basis); i++) {
        const double h = breaks[i + 1] - breaks[i];
        double t[DERIVATIVES] = {0}, g[DERIVATIVES] = {0}, off = 0;
        end_gap ends[2];
        for (int e = 0; e < 2; e++) {
            if (!gap_at(surface, line, unit, i, breaks[i + e], way, &ends[e])) {
                return INFINITY;
            }
        }
        bound_window(line, i, breaks[i], breaks[i + 1], way, t, &off);
        bound_surface(surface, straight, ends, t[1] * h, g);
        const double cube = h * h * h, rest = cube * cube / 46080 * sixth(g, t);
        const double at_ends = fmax(ends[0].gap[0], ends[1].gap[0]) +
                               first_most * h * (ends[0].gap[1] + ends[1].gap[1]) +
                               second_most * h * h * (ends[0].gap[2] + ends[1].gap[2]);
        most = fmax(most, at_ends + rest + g[1] * off);
    }
    return most + 2 * straight->member.residual; /* over a size of 2 at most */
}
