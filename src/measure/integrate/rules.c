/* rules.c -- the Gauss rules that an adaptive integral climbs through. */
#include "measure/integrate/job.h"

#include "numeric/quadrature.h"

#include <string.h>

static int next_count(int before)
{
    const int count = before + (before + 1) / 2;
    return count < TAUT_GAUSS_MAX ? count : TAUT_GAUSS_MAX;
}

/* How many nodes each rule has. */
static void plan_counts(const taut_scaled_surface *scaled, taut_rules *rules)
{
    for (int k = 0; k < 2 * TAUT_LADDERS; k++) {
        const int d = k % 2, ladder = k / 2, local = scaled->local[d];
        const int first = ladder == TAUT_PART && local > 5 ? 5 : local;
        for (int level = 0; level < TAUT_LEVELS_MAX; level++) {
            taut_rule *rule = &rules->at[ladder][d][level];
            rule->count = level < 2 ? first + level : next_count(rule[-1].count);
            rules->most[d] = rule->count > rules->most[d] ? rule->count : rules->most[d];
        }
        rules->samples[ladder][d].count = 2 * first + 1 < 65 ? 2 * first + 1 : 65;
        if (rules->most[d] < rules->samples[ladder][d].count) {
            rules->most[d] = rules->samples[ladder][d].count;
        }
    }
    for (int ladder = 0; ladder < TAUT_LADDERS; ladder++) {
        const taut_rule *u = rules->at[ladder][0], *v = rules->at[ladder][1];
        int levels = TAUT_LEVELS_MAX;
        while (levels > 2 && u[levels - 1].count == u[levels - 2].count &&
               v[levels - 1].count == v[levels - 2].count) {
            levels--;
        }
        rules->levels[ladder] = levels;
    }
}

static int is_fitted(const taut_rule *rule)
{
    return rule->count <= TAUT_FIT_MAX;
}

static size_t numbers_of(const taut_rule *rule)
{
    const size_t count = (size_t)rule->count;
    return 2 * count + (is_fitted(rule) ? count * count : 0);
}

static double *place_rule(taut_rule *rule, double *at)
{
    rule->nodes = at;
    rule->weights = at + rule->count;
    rule->to_legendre = is_fitted(rule) ? at + 2 * rule->count : NULL;
    return at + numbers_of(rule);
}

static void fill_samples(taut_rule *rule)
{
    for (int i = 0; i < rule->count; i++) {
        rule->nodes[i] = -1 + 2.0 * i / (rule->count - 1);
        rule->weights[i] = 2.0 / rule->count;
    }
}

int taut_rules_init(taut_rules *rules, const taut_scaled_surface *scaled, taut_arena *arena)
{
    size_t total = 0;
    double *at = NULL;

    memset(rules, 0, sizeof *rules);
    plan_counts(scaled, rules);
    for (int k = 0; k < 2 * TAUT_LADDERS; k++) {
        total += numbers_of(&rules->samples[k / 2][k % 2]);
        for (int level = 0; level < TAUT_LEVELS_MAX; level++) {
            total += numbers_of(&rules->at[k / 2][k % 2][level]);
        }
    }
    at = taut_arena_take(arena, total, sizeof(double));
    if (at == NULL) {
        return 0;
    }
    for (int k = 0; k < 2 * TAUT_LADDERS; k++) {
        const int d = k % 2, ladder = k / 2;
        at = place_rule(&rules->samples[ladder][d], at);
        fill_samples(&rules->samples[ladder][d]);
        for (int level = 0; level < TAUT_LEVELS_MAX; level++) {
            taut_rule *rule = &rules->at[ladder][d][level];
            at = place_rule(rule, at);
            taut_gauss_rule(rule->count, rule->nodes, rule->weights);
            if (is_fitted(rule)) {
                taut_fit_table(rule->count, rule->nodes, rule->weights, rule->to_legendre);
            }
        }
    }
    return 1;
}

void taut_rule_fill(const taut_rule *rule, const taut_scaled_surface *scaled, int direction,
                    int span, double lo, double hi, int order, taut_nodes *nodes)
{
    taut_nodes_fill(scaled, direction, span, lo, hi, order, rule->count, rule->nodes, rule->weights,
                    nodes);
}
