/* integrate_job.h -- what the parts of one adaptive integral share. */
#ifndef TAUT_MEASURE_INTEGRATE_JOB_H
#define TAUT_MEASURE_INTEGRATE_JOB_H

#include "measure/integrate.h"
#include "measure/rules.h"
#include "numeric/sum.h"

enum { TAUT_BLOCK = 16 }; /* spans per side of a task of the first pass */

/* A part of a cell that resists. */
typedef struct taut_rectangle {
    int span[2];
    double lo[2], hi[2];
} taut_rectangle;

/* What one task found. */
typedef struct taut_share {
    taut_sum value[TAUT_FIELDS_MAX]; /* of what is good enough */
    double error[TAUT_FIELDS_MAX];
    double pending[TAUT_FIELDS_MAX]; /* estimates of what is not */
} taut_share;

/* Scratch of one worker. */
typedef struct taut_bench {
    taut_cell_work cell;
    taut_nodes nodes[2];                /* made for one cell */
    double *samples[4];                 /* [samples u][samples v] */
    taut_nodes block[2][2][TAUT_BLOCK]; /* [direction][level 0, 1][span of the block] */
    double *numbers;                    /* behind all of them */
} taut_bench;

typedef struct taut_job {
    taut_cells cells;
    const taut_integrand *integrand;
    taut_rules rules;
    int spans[2];
    int side; /* spans per side of a block */
    int blocks[2];
    int worker_count;
    taut_bench *benches; /* [worker_count] */
    taut_share *shares;  /* [tasks] */
    long share_count;
    unsigned char *hard;    /* [spans u][spans v], first pass */
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
int taut_cell_try(const taut_job *job, taut_bench *bench, int ladder, const taut_rectangle *r,
                  const taut_nodes *const first[2], const taut_nodes *const second[2],
                  const double *allowed, double *value, double *error);

/* Looks at closed samples of the cell for kinks that the nodes, which saw W and s in range[0] and
 * range[1], may have missed, and raises the errors of their fields to what those may amount to. */
void taut_cell_kinks(const taut_job *job, taut_bench *bench, int ladder, const taut_rectangle *r,
                     const double range[2][2], double *error);

/* Takes the cell's numbers into the share: for good, or as pending. */
void taut_share_take(taut_share *share, int is_good, int count, const double *value,
                     const double *error);

/* Adds up the shares in their order; *pending is replaced. */
void taut_job_gather(const taut_job *job, taut_sum *value, taut_sum *error, double *pending);

/* The rounds over the cells marked hard. TAUT_NO_MEMORY. */
taut_status taut_job_rounds(taut_job *job, taut_sum *value, taut_sum *error, double *pending);

#endif /* TAUT_MEASURE_INTEGRATE_JOB_H */
