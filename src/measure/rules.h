/* rules.h -- the Gauss rules that an adaptive integral climbs through. */
#ifndef TAUT_MEASURE_RULES_H
#define TAUT_MEASURE_RULES_H

#include "measure/cell.h"

enum { TAUT_LEVELS_MAX = 6 };

/* Per direction, with p the degree: p+1 nodes, which are exact for squares of derivatives; p+2 to
 * confirm them; then half as many again at each level, at most TAUT_GAUSS_MAX. */
typedef struct taut_rules {
    int levels;
    int count[2][TAUT_LEVELS_MAX];
    double *nodes[2][TAUT_LEVELS_MAX];
    double *weights[2][TAUT_LEVELS_MAX];
    double *numbers; /* behind all of them */
} taut_rules;

/* 0 when memory runs out; free in any case. */
int taut_rules_init(taut_rules *rules, const taut_cells *cells);
void taut_rules_free(taut_rules *rules);

/* The nodes of a level in one interval of one span. */
void taut_rule_fill(const taut_rules *rules, const taut_cells *cells, int direction, int level,
                    int span, double lo, double hi, int order, taut_nodes *nodes);

#endif /* TAUT_MEASURE_RULES_H */
