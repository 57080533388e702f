#include "construct/common/line_rule.h"

#include "core/memory.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

void taut_line_rule_clear(taut_line_rule *rule)
{
    taut_table_free(rule->table);
    taut_free(rule->weights);
    taut_free(rule->roundings);
    memset(rule, 0, sizeof *rule);
}

/* Parameters and spans of the nodes, and what else the rule holds of them. */
static void place_nodes(const taut_basis *basis, const taut_cells *panels, int nodes, double *t,
                        int *spans, taut_line_rule *rule)
{
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];
    const double length = taut_basis_hi(basis) - taut_basis_lo(basis);

    taut_gauss_rule(nodes, node, weight);
    rule->reach = fmax(fabs(taut_basis_lo(basis)), fabs(taut_basis_hi(basis))) / length;
    for (int i = 0; i < rule->count; i++) {
        const int k = i / nodes, g = i % nodes, span = panels->span[k];
        t[i] = taut_cells_at(panels, k, node[g]);
        spans[i] = span;
        rule->weights[i] = 0.5 * weight[g] * ((panels->hi[k] - panels->lo[k]) / length);
        rule->roundings[i] = fabs(t[i]) / taut_cells_finest(basis, span);
    }
}

static void scale_slopes(taut_table *table, double factor)
{
    for (int i = 0; i < table->count; i++) {
        double *slopes = table->values + ((size_t)i * 2 + 1) * (size_t)table->local;
        for (int a = 0; a < table->local; a++) {
            slopes[a] *= factor;
        }
    }
}

taut_status taut_line_rule_init(const taut_basis *basis, const taut_cells *panels, int nodes,
                                taut_line_rule *rule)
{
    const size_t count = (size_t)panels->count * (size_t)nodes;
    double *t = taut_alloc(count, sizeof(double));
    int *spans = taut_alloc(count, sizeof(int));
    taut_status status = TAUT_NO_MEMORY;

    memset(rule, 0, sizeof *rule);
    rule->count = (int)count;
    rule->weights = taut_alloc(count, sizeof(double));
    rule->roundings = taut_alloc(count, sizeof(double));
    if (t != NULL && spans != NULL && rule->weights != NULL && rule->roundings != NULL) {
        place_nodes(basis, panels, nodes, t, spans, rule);
        status = taut_table_new(basis, rule->count, t, spans, 1, &rule->table);
    }
    taut_free(t);
    taut_free(spans);
    if (status == TAUT_OK) {
        scale_slopes(rule->table, taut_basis_hi(basis) - taut_basis_lo(basis));
    } else {
        taut_line_rule_clear(rule);
    }
    return status;
}
