/* integrate_kinks.c -- kinks of |x_u x x_v| and |s| that fall between the nodes.
 *
 * Two rules agree on an absolute value whose argument changes sign in a corner of the cell that
 * neither looks into: both then integrate the smooth argument. The argument is sampled instead, on
 * a closed grid twice as dense as the degree. For W it is the component of x_u x x_v along the
 * largest one sampled; if that is positive with room for what it may dip between two samples (an
 * eighth of the second difference each way), W is smooth. Along a collapsed edge it is 0 and its
 * differences along the edge too: no kink, as it must be.
 */
#include "measure/integrate_job.h"

#include <float.h>
#include <math.h>

/* A smooth argument that nowhere comes below this part of its largest value at a node is not
 * suspected. */
static const double suspicion = 0.2;

static double area_of(const taut_job *job, const taut_rectangle *r)
{
    return ldexp(r->hi[0] - r->lo[0], -job->cells.shift[0]) *
           ldexp(r->hi[1] - r->lo[1], -job->cells.shift[1]);
}

/* samples[0..2]: x_u x x_v, samples[3]: s (0 if it is not asked for). */
static void sample(const taut_job *job, taut_bench *bench, int ladder, const taut_rectangle *r)
{
    const taut_integrand *in = job->integrand;
    taut_nodes *nodes = bench->nodes;
    const size_t stride = (size_t)bench->cell.stride;

    for (int d = 0; d < 2; d++) {
        taut_rule_fill(&job->rules.samples[ladder][d], &job->cells, d, r->span[d], r->lo[d],
                       r->hi[d], in->order, &nodes[d]);
    }
    for (int i = 0; i < nodes[0].count; i++) {
        taut_cell_row(&job->cells, &nodes[0], i, &nodes[1], in->order, in->fields, &bench->cell);
        for (int j = 0; j < nodes[1].count; j++) {
            const double *x = bench->cell.field + j;
            const int at = i * nodes[1].count + j;
            for (int c = 0; c < 3; c++) {
                const size_t d = (size_t)(c + 1) % 3, e = (size_t)(c + 2) % 3;
                bench->samples[c][at] = x[(3 + d) * stride] * x[(6 + e) * stride] -
                                        x[(3 + e) * stride] * x[(6 + d) * stride];
            }
            bench->samples[3][at] =
                in->kinks > 1 ? bench->cell.out[2 * (size_t)in->count * stride + (size_t)j] : 0;
        }
    }
}

/* samples[0] becomes the component of x_u x x_v along the largest one; returns that one's size. */
static double project(taut_bench *bench, int count)
{
    double **n = bench->samples;
    double largest = 0, unit[3] = {0, 0, 1};
    for (int k = 0; k < count; k++) {
        const double w = sqrt(n[0][k] * n[0][k] + n[1][k] * n[1][k] + n[2][k] * n[2][k]);
        if (w > largest) {
            largest = w;
            for (int c = 0; c < 3; c++) {
                unit[c] = n[c][k] / w;
            }
        }
    }
    for (int k = 0; k < count; k++) {
        n[0][k] = unit[0] * n[0][k] + unit[1] * n[1][k] + unit[2] * n[2][k];
    }
    return largest;
}

/* An eighth of the second difference at place i of n, `step` apart; 0 at the ends. */
static double dip(const double *f, int i, int n, int step)
{
    return i > 0 && i < n - 1 ? fabs(f[-step] - 2 * f[0] + f[step]) / 8 : 0;
}

/* Mean over the samples of what the argument may be below 0. */
static double shortfall(const double *f, const int count[2], double noise)
{
    double sum = 0;
    for (int i = 0; i < count[0]; i++) {
        for (int j = 0; j < count[1]; j++) {
            const double *at = f + (size_t)i * (size_t)count[1] + (size_t)j;
            const int inside = i > 0 && i < count[0] - 1 && j > 0 && j < count[1] - 1;
            const double along_u =
                inside || j == 0 || j == count[1] - 1 ? dip(at, i, count[0], count[1]) : 0;
            const double along_v =
                inside || i == 0 || i == count[0] - 1 ? dip(at, j, count[1], 1) : 0;
            const double deficit = along_u + along_v - *at;
            sum += deficit > noise ? deficit : 0;
        }
    }
    return sum / ((double)count[0] * count[1]);
}

/* Mean of the smaller of the positive and the negative part. */
static double minority(const double *s, int count)
{
    double above = 0, below = 0;
    for (int k = 0; k < count; k++) {
        above += fmax(s[k], 0);
        below += fmax(-s[k], 0);
    }
    return fmin(above, below) / count;
}

void taut_cell_kinks(const taut_job *job, taut_bench *bench, int ladder, const taut_rectangle *r,
                     const double range[2][2], double *error)
{
    const taut_integrand *in = job->integrand;
    const int w = in->kinks > 0 && !(range[0][0] > suspicion * range[0][1]);
    /* where the nodes saw both signs, the rules differ as they should */
    const int s = in->kinks > 1 && ((range[1][0] > 0 && !(range[1][0] > suspicion * range[1][1])) ||
                                    (range[1][1] < 0 && !(range[1][1] < suspicion * range[1][0])));
    const int last = 2 * in->count - 2;
    int count[2];

    if (!w && !s) {
        return;
    }
    sample(job, bench, ladder, r);
    count[0] = bench->nodes[0].count;
    count[1] = bench->nodes[1].count;
    if (w) {
        const double largest = project(bench, count[0] * count[1]);
        const double noise = 64 * DBL_EPSILON * largest;
        error[0] = fmax(error[0], 2 * area_of(job, r) * shortfall(bench->samples[0], count, noise));
    }
    if (s) {
        error[last] = fmax(error[last],
                           2 * area_of(job, r) * minority(bench->samples[3], count[0] * count[1]));
    }
}
