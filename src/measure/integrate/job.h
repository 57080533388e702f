/* job.h -- what the parts of one adaptive integral share. */
#ifndef TAUT_MEASURE_INTEGRATE_JOB_H
#define TAUT_MEASURE_INTEGRATE_JOB_H

#include "geometry/nurbs/cells.h"
#include "measure/integrate/absolute.h"
#include "measure/integrate/integrate.h"
#include "numeric/sum.h"

/* The Gauss rules that an adaptive integral climbs through. */
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
int taut_rules_init(taut_rules *rules, const taut_scaled_surface *scaled);
void taut_rules_free(taut_rules *rules);

/* The nodes of a rule in one interval of one span. */
void taut_rule_fill(const taut_rule *rule, const taut_scaled_surface *scaled, int direction,
                    int span, double lo, double hi, int order, taut_nodes *nodes);

enum { TAUT_BLOCK = 16 }; /* cells per side of a task of the first pass */

/* A part of a cell that resists. */
typedef struct taut_rectangle {
    int span[2];
    double lo[2], hi[2];
} taut_rectangle;

/* What one task found. */
typedef struct taut_task_result {
    taut_sum value[TAUT_FIELDS_MAX]; /* of what is good enough */
    double error[TAUT_FIELDS_MAX];
    double pending[TAUT_FIELDS_MAX]; /* estimates of what is not */
} taut_task_result;

/* Scratch of one worker. */
typedef struct taut_worker {
    taut_cell_work cell;
    taut_nodes nodes[2];                /* made for one cell */
    double *samples[3];                 /* [samples u][samples v] */
    taut_nodes block[2][2][TAUT_BLOCK]; /* [direction][level 0, 1][cell of the block] */
    double *numbers;                    /* behind all of them */
} taut_worker;

typedef struct taut_job {
    taut_scaled_surface scaled;
    taut_basis *moved[2]; /* near_zero.h; NULL: as the surface has it */
    const taut_integrand *integrand;
    taut_rules rules;
    taut_cells *cells
        [2]; /* along u and v: spans, long ones of hyperbolic bases cut; a cell is a pair of them */
    int side; /* cells per side of a block */
    int blocks[2];
    int worker_count;
    taut_worker *workers;     /* [worker_count] */
    taut_task_result *shares; /* [tasks] */
    long share_count;
    unsigned char *hard;    /* [cells along u][along v], first pass */
    taut_rectangle *active; /* rounds */
    unsigned char *split;
    long active_count;
    double allowed[TAUT_FIELDS_MAX]; /* error a cell of the round may keep */
    int last;                        /* nonzero: this round takes everything */
} taut_job;

/* Raises the number of nodes in a cell whose net is loaded, along a ladder of rules, until every
 * field is good by its own target or within `allowed` (NULL: by its own), and returns 1; or 0 if
 * more nodes do not pay. first, second: the nodes of levels 0 and 1; second[0] NULL takes the first
 * rule's word. */
int taut_cell_try(const taut_job *job, taut_worker *worker, int ladder, const taut_rectangle *r,
                  const taut_nodes *const first[2], const taut_nodes *const second[2],
                  const double *allowed, double *value, double *error);

/* The arguments of W and |s| in one cell, as polynomials through two rules' nodes. */
typedef struct taut_arguments {
    taut_fit fit[2][2];  /* [W, s][level % 2] */
    int near[2], had[2]; /* [W, s]: comes near 0, and is known, at this rule; at the one before */
    int now;             /* level % 2 of this rule */
    int doubt; /* W comes near 0, but x_u x x_v keeps to no line: no polynomial is known */
} taut_arguments;

/* After a rule's sums: takes its values into `a`, and where an argument comes near 0 makes the
 * error of its field what the last two polynomials differ by. */
void taut_arguments_take(const taut_job *job, const taut_worker *worker, int ladder, int level,
                         const taut_rectangle *r, taut_arguments *a, const double *value,
                         double *error);

/* Replaces the integrals of W and |s|, where their arguments come near 0, by those of the absolute
 * values of the polynomials. */
void taut_arguments_settle(const taut_job *job, const taut_rectangle *r, const taut_arguments *a,
                           double *value);

/* Looks at closed samples of the cell for places where x_u x x_v turns over between the nodes, and
 * raises error[0] to what those may amount to. */
void taut_cell_turns(const taut_job *job, taut_worker *worker, int ladder, const taut_rectangle *r,
                     double *error);

/* Takes the cell's numbers into the share: for good, or as pending. */
void taut_task_result_add(taut_task_result *share, int is_good, int count, const double *value,
                          const double *error);

#endif /* TAUT_MEASURE_INTEGRATE_JOB_H */
