#include "certify/trace/bends.h"

#include "certify/trace/audit.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <string.h>

enum { NODES = TAUT_NET_NODES };

void taut_net_rule_fill(taut_net_rule *rule)
{
    double scale[NODES];

    taut_gauss_rule(NODES, rule->nodes, rule->weights);
    for (int i = 0; i < NODES; i++) {
        scale[i] = 1;
        for (int k = 0; k < NODES; k++) {
            scale[i] *= k == i ? 1 : 2 * (rule->nodes[i] - rule->nodes[k]);
        }
        rule->share[i] = 1 / scale[i];
    }
    for (int i = 0; i < NODES; i++) {
        rule->derive[i][i] = 0;
        for (int k = 0; k < NODES; k++) {
            if (k != i) {
                rule->derive[i][k] = scale[i] / scale[k] / (rule->nodes[i] - rule->nodes[k]);
                rule->derive[i][i] += 1 / (rule->nodes[i] - rule->nodes[k]);
            }
        }
    }
}

double taut_net_rule_at(const taut_net_rule *rule, const double *values, double x)
{
    double sum = 0, shares = 0;
    for (int k = 0; k < NODES; k++) {
        if (x == rule->nodes[k]) {
            return values[k];
        }
        const double share = rule->share[k] / (x - rule->nodes[k]);
        sum += share * values[k];
        shares += share;
    }
    return sum / shares;
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
int taut_net_spot_at(taut_net_cells *cells, taut_trace_net net, const taut_net_line *line, double t,
                     taut_net_spot *s)
{
    int k = 0;
    double window[2][3], at[2], x[3][3];
    taut_forms f;

    while (k < line->count - 1 && t > taut_basis_hi(taut_curve_t(line->window[k]))) {
        k++;
    }
    if (line->count == 0 || taut_curve_eval(line->window[k], t, 1, window[0]) != TAUT_OK) {
        return 0;
    }
    const taut_surface *surface = cells->surfaces[line->on[k]];
    for (int d = 0; d < 2; d++) {
        const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
        at[d] = fmin(fmax(window[0][d], taut_basis_lo(basis)), taut_basis_hi(basis));
    }
    if (!taut_net_cells_look(cells, line->on[k], at, x, &f) || !f.regular) {
        return 0;
    }
    double ab[2] = {window[1][0], window[1][1]};
    if (net == TAUT_TRACE_ISOPARAMETRIC) {
        ab[line->family == 0 ? 0 : 1] =
            0; /* what is left there is rounding, and its slope large on short spans */
    }
    s->speed = sqrt(f.e * ab[0] * ab[0] + 2 * f.f * ab[0] * ab[1] + f.g * ab[1] * ab[1]);
    correct(net, &f, ab);
    const double speed = sqrt(f.e * ab[0] * ab[0] + 2 * f.f * ab[0] * ab[1] + f.g * ab[1] * ab[1]);
    const double a = ab[0] / speed, b = ab[1] / speed;
    for (int c = 0; c < 3; c++) {
        s->x[c] = x[0][c];
        s->tangent[c] = a * x[1][c] + b * x[2][c];
    }
    s->blur = net == TAUT_TRACE_ASYMPTOTIC || net == TAUT_TRACE_PRINCIPAL
                  ? taut_net_blur(surface, 1, at, &f)
                  : 0;
    memcpy(s->normal, f.normal, sizeof s->normal);
    taut_cross(f.normal, s->tangent, s->sideways);
    s->k_n = f.l * a * a + 2 * f.m * a * b + f.n * b * b;
    s->tau =
        ((f.m * a + f.n * b) * (f.e * a + f.f * b) - (f.l * a + f.m * b) * (f.f * a + f.g * b)) /
        f.w;
    return 1;
}

int taut_net_spots(taut_net_cells *cells, taut_trace_net net, const taut_net_line *line,
                   const taut_net_rule *rule, double from, double to,
                   taut_net_spot spots[TAUT_NET_NODES])
{
    for (int k = 0; k < NODES; k++) {
        const double t = (from + to) / 2 + (to - from) / 2 * rule->nodes[k];
        if (!taut_net_spot_at(cells, net, line, t, &spots[k])) {
            return 0;
        }
    }
    return 1;
}

void taut_net_sideways_bend(const taut_net_rule *rule, const taut_net_spot *spots, double from,
                            double to, double k_g[TAUT_NET_NODES])
{
    for (int i = 0; i < NODES; i++) {
        const double rate = spots[i].speed * (to - from) / 2;
        double turned[3] = {0, 0, 0};
        for (int k = 0; k < NODES; k++) {
            taut_add_scaled(rule->derive[i][k] / rate, spots[k].tangent, turned);
        }
        k_g[i] = taut_dot(turned, spots[i].sideways);
    }
}
