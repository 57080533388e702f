#include "measure/rules.h"

#include "core/memory.h"
#include "numeric/quadrature.h"

#include <string.h>

static int next_count(int before)
{
    const int count = before + (before + 1) / 2;
    return count < TAUT_GAUSS_MAX ? count : TAUT_GAUSS_MAX;
}

int taut_rules_init(taut_rules *rules, const taut_cells *cells)
{
    size_t total = 0;
    double *at = NULL;

    memset(rules, 0, sizeof *rules);
    for (int d = 0; d < 2; d++) {
        for (int level = 0; level < TAUT_LEVELS_MAX; level++) {
            rules->count[d][level] =
                level < 2 ? cells->local[d] + level : next_count(rules->count[d][level - 1]);
            total += 2 * (size_t)rules->count[d][level];
        }
    }
    rules->levels = TAUT_LEVELS_MAX;
    while (rules->levels > 2 &&
           rules->count[0][rules->levels - 1] == rules->count[0][rules->levels - 2] &&
           rules->count[1][rules->levels - 1] == rules->count[1][rules->levels - 2]) {
        rules->levels--;
    }
    at = rules->numbers = taut_alloc(total, sizeof(double));
    if (at == NULL) {
        return 0;
    }
    for (int d = 0; d < 2; d++) {
        for (int level = 0; level < TAUT_LEVELS_MAX; level++) {
            const int count = rules->count[d][level];
            rules->nodes[d][level] = at;
            rules->weights[d][level] = at + count;
            at += 2 * count;
            taut_gauss_rule(count, rules->nodes[d][level], rules->weights[d][level]);
        }
    }
    return 1;
}

void taut_rules_free(taut_rules *rules)
{
    taut_free(rules->numbers);
}

void taut_rule_fill(const taut_rules *rules, const taut_cells *cells, int direction, int level,
                    int span, double lo, double hi, int order, taut_nodes *nodes)
{
    taut_nodes_fill(cells, direction, span, lo, hi, order, rules->count[direction][level],
                    rules->nodes[direction][level], rules->weights[direction][level], nodes);
}
