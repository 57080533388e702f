/* kinks.c -- kinks of |x_u x x_v| and |s|.
 *
 * Gauss rules are slow on an absolute value whose argument changes sign, and blind to a change of
 * sign in a corner that no node looks into: two rules then agree on the integral of the smooth
 * argument. The argument itself is smooth, so the polynomial through its values at the nodes is
 * close to it, and its absolute value is integrated exactly (absolute.c). s is such an argument;
 * for W there is one where x_u x x_v keeps to a line, as on all plane surfaces. On others it
 * vanishes at isolated points only, and turns over along edges that are collapsed; those are looked
 * for on a closed grid of samples.
 */
#include "measure/integrate/job.h"

#include <float.h>
#include <math.h>

/* An argument that nowhere comes below this part of its largest value at a node is not suspected of
 * a kink. */
static const double suspicion = 0.2;

/* Absolute values are integrated to these parts of what is asked of them: a tenth of that is asked
 * of cells, which W is held to; |s| has no use for it. */
static const double fine[2] = {0.02, 0.5};

static double area_of(const taut_job *job, const taut_rectangle *r)
{
    return ldexp(r->hi[0] - r->lo[0], -job->scaled.shift[0]) *
           ldexp(r->hi[1] - r->lo[1], -job->scaled.shift[1]);
}

/* The size of the largest of the vectors n, along `unit`; the smallest size goes to *least. */
static double find_largest(double *const n[3], int count, double unit[3], double *least)
{
    double largest = 0;
    *least = INFINITY;
    unit[0] = unit[1] = 0;
    unit[2] = 1;
    for (int k = 0; k < count; k++) {
        const double w = sqrt(n[0][k] * n[0][k] + n[1][k] * n[1][k] + n[2][k] * n[2][k]);
        *least = w < *least ? w : *least; /* a call of fmin takes longer than the rest */
        if (w > largest) {
            largest = w;
            for (int c = 0; c < 3; c++) {
                unit[c] = n[c][k] / w;
            }
        }
    }
    return largest;
}

/* n[0] becomes the component of the vectors n along `unit`; returns the largest part across it. */
static double project_on_line(double *const n[3], int count, const double unit[3])
{
    double most = 0;
    for (int k = 0; k < count; k++) {
        const double along = unit[0] * n[0][k] + unit[1] * n[1][k] + unit[2] * n[2][k];
        for (int c = 0; c < 3; c++) {
            const double across = fabs(n[c][k] - along * unit[c]);
            most = across > most ? across : most;
        }
        n[0][k] = along;
    }
    return most;
}

static int comes_near_zero(const double *f, int count)
{
    double lo = INFINITY, hi = -INFINITY;
    for (int k = 0; k < count; k++) {
        lo = f[k] < lo ? f[k] : lo;
        hi = f[k] > hi ? f[k] : hi;
    }
    return !(lo > suspicion * hi) && !(hi < suspicion * lo);
}

/* Takes f into the fits of argument k. */
static void take_fit(const taut_job *job, int ladder, int level, const double *f, int k,
                     taut_arguments *a)
{
    const taut_rule *u = &job->rules.at[ladder][0][level], *v = &job->rules.at[ladder][1][level];
    a->near[k] = u->count <= TAUT_FIT_MAX && v->count <= TAUT_FIT_MAX;
    if (a->near[k]) {
        taut_fit_init(u->count, u->to_legendre, v->count, v->to_legendre, f, &a->fit[k][a->now]);
    }
}

void taut_arguments_take(const taut_job *job, const taut_worker *worker, int ladder, int level,
                         const taut_rectangle *r, taut_arguments *a, const double *value,
                         double *error)
{
    const taut_integrand *in = job->integrand;
    const int count = job->rules.at[ladder][0][level].count * job->rules.at[ladder][1][level].count;
    const int field[2] = {0, 2 * in->count - 2};
    double *const *kept = worker->cell.kept;
    double least = 0, largest = 0, unit[3];

    for (int k = 0; k < 2; k++) {
        a->had[k] = a->near[k];
        a->near[k] = 0;
    }
    a->now = level % 2;
    a->doubt = count > TAUT_NODES_KEPT;
    if (a->doubt) {
        return;
    }
    /* not where |s| is all rounding, as on minimal surfaces */
    if (in->kinks > 1 && comes_near_zero(kept[3], count) &&
        value[field[1]] > in->goals[in->count - 1].floor * value[field[1] + 1]) {
        take_fit(job, ladder, level, kept[3], 1, a);
    }
    largest = find_largest(kept, count, unit, &least);
    if (largest > 0 && !(least > suspicion * largest)) {
        if (project_on_line(kept, count, unit) <= 64 * DBL_EPSILON * largest) {
            take_fit(job, ladder, level, kept[0], 0, a);
        }
        a->doubt = !a->near[0];
    }
    for (int k = 0; k < 2; k++) {
        if (a->near[k]) {
            error[field[k]] =
                a->had[k] ? area_of(job, r) / 4 * taut_fit_distance(&a->fit[k][0], &a->fit[k][1])
                          : INFINITY;
        }
    }
}

void taut_arguments_settle(const taut_job *job, const taut_rectangle *r, const taut_arguments *a,
                           double *value)
{
    const int field[2] = {0, 2 * job->integrand->count - 2};
    for (int k = 0; k < 2; k++) {
        if (a->near[k]) {
            const double asked = job->integrand->goals[field[k] / 2].relative;
            value[field[k]] =
                area_of(job, r) / 4 * taut_fit_absolute(&a->fit[k][a->now], fine[k] * asked);
        }
    }
}

/* worker->samples: x_u x x_v. */
static void sample_normals(const taut_job *job, taut_worker *worker, int ladder,
                           const taut_rectangle *r)
{
    const taut_integrand *in = job->integrand;
    const size_t stride = (size_t)worker->cell.stride;
    taut_nodes *nodes = worker->nodes;

    for (int d = 0; d < 2; d++) {
        taut_rule_fill(&job->rules.samples[ladder][d], &job->scaled, d, r->span[d], r->lo[d],
                       r->hi[d], in->order, &nodes[d]);
    }
    for (int i = 0; i < nodes[0].count; i++) {
        taut_cell_row(&job->scaled, &nodes[0], i, &nodes[1], in->order, in->fields, &worker->cell);
        for (int k = 0; k < 3; k++) {
            const double *out = worker->cell.out + (size_t)(2 * in->count + k) * stride;
            for (int j = 0; j < nodes[1].count; j++) {
                worker->samples[k][i * nodes[1].count + j] = out[j];
            }
        }
    }
}

/* An eighth of the second difference at place i of n, `step` apart; 0 at the ends. */
static double dip_at(const double *f, int i, int n, int step)
{
    return i > 0 && i < n - 1 ? fabs(f[-step] - 2 * f[0] + f[step]) / 8 : 0;
}

/* Mean over the samples of what f may be below 0 there or between. Across an edge no difference is
 * taken: on a collapsed edge f is 0, and its differences along the edge too: no kink, as it must
 * be.
 */
static double mean_shortfall(const double *f, const int count[2], double noise)
{
    double sum = 0;
    for (int i = 0; i < count[0]; i++) {
        for (int j = 0; j < count[1]; j++) {
            const double *at = f + (size_t)i * (size_t)count[1] + (size_t)j;
            const int on_u = i == 0 || i == count[0] - 1, on_v = j == 0 || j == count[1] - 1;
            const double along_u = on_u ? 0 : dip_at(at, i, count[0], count[1]);
            const double along_v = on_v ? 0 : dip_at(at, j, count[1], 1);
            const double deficit =
                (on_v || !on_u ? along_u : 0) + (on_u || !on_v ? along_v : 0) - *at;
            sum += deficit > noise ? deficit : 0;
        }
    }
    return sum / ((double)count[0] * count[1]);
}

void taut_cell_turns(const taut_job *job, taut_worker *worker, int ladder, const taut_rectangle *r,
                     double *error)
{
    double largest = 0, least = 0, unit[3];
    int count[2];

    sample_normals(job, worker, ladder, r);
    count[0] = worker->nodes[0].count;
    count[1] = worker->nodes[1].count;
    largest = find_largest(worker->samples, count[0] * count[1], unit, &least);
    (void)project_on_line(worker->samples, count[0] * count[1], unit);
    error[0] =
        fmax(error[0], 2 * area_of(job, r) *
                           mean_shortfall(worker->samples[0], count, 64 * DBL_EPSILON * largest));
}
