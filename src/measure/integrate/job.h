/* job.h -- what the parts of one adaptive integral share. */
#ifndef TAUT_MEASURE_INTEGRATE_JOB_H
#define TAUT_MEASURE_INTEGRATE_JOB_H

#include "core/arena.h"
#include "core/pulse.h"
#include "geometry/nurbs/cells.h"
#include "measure/integrate/absolute.h"
#include "measure/integrate/integrate.h"
#include "numeric/sum.h"

#include <stddef.h>
#include <stdint.h>

/* cell.c: the derivative vectors at the nodes of one cell, a rectangle within one span by one span,
 * and weighted sums over them. */
enum { TAUT_KEPT_MAX = 4, TAUT_NODES_KEPT = 1024 };

/* A surface made ready. */
typedef struct taut_scaled_surface {
    const taut_basis *basis[2];
    const double *points, *weights;
    int dim;      /* 3, or 4 with weights */
    int local[2]; /* functions alive per direction */
    int scale;
    int shift[2];
} taut_scaled_surface;

void taut_scaled_surface_init(const taut_surface *surface, taut_scaled_surface *scaled);

/* The nodes of a rule in one interval of one span: basis functions to `order`, weights that sum to
 * the length of the interval (scaled). */
typedef struct taut_nodes {
    int count;
    double *values;    /* [count][order+1][local] */
    double *weights;   /* [count] */
    double *most;      /* [order+1][local]: over the nodes, of |N_a^(k)| */
    double largest[3]; /* over the nodes, of sum_a |N_a^(k)| */
} taut_nodes;

void taut_nodes_fill(const taut_scaled_surface *scaled, int direction, int span, double lo,
                     double hi, int order, int count, const double *rule_nodes,
                     const double *rule_weights, taut_nodes *nodes);

/* Scratch of one worker. */
typedef struct taut_cell_work {
    double *net;      /* [local u][local v][dim] of the cell at hand */
    double *polygons; /* [order+1][local v][dim] */
    double *field;    /* [6][3][stride] (with weights [6][4] until they are divided out) */
    double *out;      /* [TAUT_FIELDS_MAX][stride] */
    double *kept[TAUT_KEPT_MAX]; /* [TAUT_NODES_KEPT] each */
    int stride;                  /* nodes handled at a time */
    double size;                 /* of the cell's net, largest distance of a coordinate */
    double cross;                /* see taut_bounds */
    taut_pulse
        *pulse; /* told of rows of nodes: where one cell is long, of the caller's thread; or NULL */
} taut_cell_work;

/* In the arena, whose status tells whether all is there, and told to nobody. `row` is the largest number of nodes in v. */
void taut_cell_work_init(const taut_scaled_surface *scaled, int row, taut_arena *arena,
                         taut_cell_work *work);

/* taut_bounds.cross from the largest coordinates and the largest of these: what the products of two of the sizes are over the
 * square of the largest; eight times that, so that only nets far longer than they are wide and high have less than 1. */
double taut_cross_share(const double sizes[3], double size);

/* Takes the net of spans su, sv into the work. */
void taut_cell_load(const taut_scaled_surface *scaled, int su, int sv, taut_cell_work *work);

/* sums[f] = sum over the nodes of weight times out[f], f < field_count. The `kept` fields that
 * follow them go to work->kept[k], row by row, if there are no more than TAUT_NODES_KEPT nodes.
 * order is 1 or 2. Once the work's pulse is stopped the sums have no meaning. */
void taut_cell_sum(const taut_scaled_surface *scaled, const taut_nodes *u, const taut_nodes *v,
                   int order, taut_fields *fields, int field_count, int kept, taut_cell_work *work,
                   double *sums);

/* The same fields at the nodes of row i, kept in work: vectors in field, fields in out. */
void taut_cell_row(const taut_scaled_surface *scaled, const taut_nodes *u, int i,
                   const taut_nodes *v, int order, taut_fields *fields, taut_cell_work *work);

/* rules.c: the Gauss rules that an adaptive integral climbs through. */
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
    int most[2]; /* nodes of the largest rule */
} taut_rules;

/* Numbers in the arena; 0 when memory runs out. */
int taut_rules_init(taut_rules *rules, const taut_scaled_surface *scaled, taut_arena *arena);

/* The nodes of a rule in one interval of one span. */
void taut_rule_fill(const taut_rule *rule, const taut_scaled_surface *scaled, int direction,
                    int span, double lo, double hi, int order, taut_nodes *nodes);

/* Cells per side of a task of the first pass; and of one that works on eight at a time. */
enum { TAUT_BLOCK = 16, TAUT_WIDE_BLOCK = 48 };

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
    taut_nodes nodes[2];           /* made for one cell */
    double *samples[3];            /* [samples u][samples v] */
    taut_nodes *block[2][2];       /* [direction][level 0, 1][cell of the block] */
    struct taut_eight_work *eight; /* NULL: one cell at a time */
} taut_worker;

typedef struct taut_job {
    taut_arena *arena; /* scratch of the workers, and the rules */
    taut_scaled_surface scaled;
    taut_basis *moved[2]; /* near_zero.h; NULL: as the surface has it */
    const taut_integrand *integrand;
    taut_rules rules;
    taut_cells *cells
        [2]; /* along u and v: spans, long ones of hyperbolic bases cut; a cell is a pair of them */
    int by_eights; /* cells of the first pass */
    int side;      /* cells per side of a block */
    int blocks[2];
    int worker_count;
    taut_worker *workers;     /* [worker_count] */
    taut_task_result *shares; /* [tasks] */
    int64_t share_count;
    unsigned char *hard;    /* [cells along u][along v], first pass */
    taut_rectangle *active; /* rounds */
    unsigned char *split;
    int64_t active_count;
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

/* Is every field good by its own goal? */
int taut_cell_is_good(const taut_integrand *integrand, const double *value, const double *error);

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
