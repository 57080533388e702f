/* isometric.c
 *
 *     of each span the edge at Gauss's nodes, by how the curve bends there (certify/trace/bends.h), and its speed by the
 *     derivative of the polynomial through them: no formula of rulings
 */
#include "certify/trace/isometric.h"

#include "certify/common/verdict.h"
#include "certify/trace/bends.h"
#include "core/vec3.h"

#include <string.h>

enum { NODES = TAUT_NET_NODES };

/* What the edge at height h is long on a span; NAN where it is not known. */
static double edge_of(taut_net_cells *cells, const taut_net_lines *lines, const taut_net_line *line,
                      const taut_net_rule *rule, const double ends[2], double h, int is_envelope)
{
    double edge[NODES][3], k_g[NODES], sum = 0;
    taut_net_spot spots[NODES];

    if (!taut_net_spots(cells, lines->net, line, rule, ends[0], ends[1], spots)) {
        return NAN;
    }
    taut_net_sideways_bend(rule, spots, ends[0], ends[1], k_g);
    for (int i = 0; i < NODES; i++) {
        const taut_net_spot *s = &spots[i];
        const double skew = is_envelope ? -s->tau / s->k_n : s->tau / k_g[i];
        memcpy(edge[i], s->x, sizeof edge[i]);
        taut_add_scaled(h, is_envelope ? s->sideways : s->normal, edge[i]);
        taut_add_scaled(h * skew, s->tangent, edge[i]);
    }
    for (int i = 0; i < NODES; i++) {
        double speed[3] = {0, 0, 0};
        for (int k = 0; k < NODES; k++) {
            taut_add_scaled(rule->derive[i][k], edge[k], speed);
        }
        sum += rule->weights[i] * taut_length(speed);
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

double taut_net_isometric(const taut_net_lines *lines, taut_net_cells *cells, int unit,
                          const taut_trace_problem *problem, const char **where)
{
    const taut_trace_laths *laths = problem != NULL ? problem->laths : NULL;
    taut_net_rule rule;
    double worst = -1;

    if (laths == NULL || !(laths->width > 0) ||
        (laths->strip != TAUT_TRACE_DEVELOPABLE && laths->strip != TAUT_TRACE_ENVELOPE)) {
        return worst;
    }
    taut_net_rule_fill(&rule);
    for (int i = 0; i < lines->count; i++) {
        const taut_net_line *line = &lines->lines[i];
        const taut_basis *basis = taut_curve_t(line->space);
        const double *breaks = taut_basis_breaks(basis);
        double length = 0;
        for (int k = 0; k < taut_basis_span_count(basis); k++) {
            length += edge_of(cells, lines, line, &rule, breaks + k, ldexp(laths->width / 2, -unit),
                              laths->strip == TAUT_TRACE_ENVELOPE);
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
