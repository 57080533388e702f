/* rules.h -- the Gauss rules that an adaptive integral climbs through. */
#ifndef TAUT_MEASURE_INTEGRATE_RULES_H
#define TAUT_MEASURE_INTEGRATE_RULES_H

#include "measure/integrate/cell.h"

enum { TAUT_LEVELS_MAX = 6 };

/* Two ladders per direction, with p the degree. On whole spans: p+1 nodes, which are exact for
 * squares of derivatives; p+2 to confirm them; then half as many again at each level, at most
 * TAUT_GAUSS_MAX. On parts of spans, where the integrand is short of smoothness: from 5 nodes (or
 * p+1 if that is less). And closed samples, evenly spaced, to look for what nodes do not see. */
enum { TAUT_WHOLE, TAUT_PART, TAUT_LADDERS };

typedef struct taut_rule {
    int count;
    double *nodes, *weights;
    double *to_legendre; /* [count][count], see absolute.h; NULL above TAUT_FIT_MAX nodes */
} taut_rule;

typedef struct taut_rules {
    int levels[TAUT_LADDERS];
    taut_rule at[TAUT_LADDERS][2][TAUT_LEVELS_MAX]; /* [ladder][direction][level] */
    taut_rule samples[TAUT_LADDERS][2];
    int most[2];     /* nodes of the largest rule */
    double *numbers; /* behind all of them */
} taut_rules;

/* 0 when memory runs out; free in any case. */
int taut_rules_init(taut_rules *rules, const taut_cells *cells);
void taut_rules_free(taut_rules *rules);

/* The nodes of a rule in one interval of one span. */
void taut_rule_fill(const taut_rule *rule, const taut_cells *cells, int direction, int span,
                    double lo, double hi, int order, taut_nodes *nodes);

#endif /* TAUT_MEASURE_INTEGRATE_RULES_H */
