#include "measure/integrate/eight.h"

#include "geometry/exponent.h"
#include "numeric/kernel/name.h"

#include <math.h>

/* Squares below this are for cell.c, as in integrals.c; and a W that comes below this part of its
 * largest is suspected of a kink, as in kinks.c. */
static const double smallest = 0x1p-900, suspicion = 0.2;

const taut_eight_ops *taut_eight_ops_chosen(void)
{
    return TAUT_KERNEL_OF(taut_eight);
}

void taut_eight_init(const taut_job *job, taut_eight_work *work)
{
    const size_t nu = (size_t)job->scaled.local[0], nv = (size_t)job->scaled.local[1];

    *work = (taut_eight_work){
        .ops = taut_eight_ops_chosen(),
        .net = taut_arena_take(job->arena, 3 * TAUT_EIGHT * nu * nv, sizeof(double)),
        .polygons = taut_arena_take(job->arena, 6 * TAUT_EIGHT * nv, sizeof(double)),
        .window = taut_arena_take(job->arena, 3 * (TAUT_EIGHT + nv), sizeof(double)),
    };
    for (int level = 0; level < 2; level++) {
        taut_nodes *v = &work->v[level];
        v->count = job->rules.at[TAUT_WHOLE][1][level].count;
        v->values =
            taut_arena_take(job->arena, 2 * TAUT_EIGHT * nv * (size_t)v->count, sizeof(double));
        v->weights = taut_arena_take(job->arena, TAUT_EIGHT * (size_t)v->count, sizeof(double));
    }
}

/* Lane `lane` of the nodes side by side. */
static void take_nodes(const taut_nodes *from, int local, int lane, taut_nodes *to)
{
    for (int k = 0; k < from->count; k++) {
        to->weights[k * TAUT_EIGHT + lane] = from->weights[k];
    }
    for (int k = 0; k < 2 * local * from->count; k++) {
        to->values[k * TAUT_EIGHT + lane] = from->values[k];
    }
}

void taut_eight_take(const taut_job *job, const taut_nodes *const nodes[2], int from, int count,
                     taut_eight_work *work)
{
    const taut_cells *cells = job->cells[1];

    work->count = count;
    for (int lane = 0; lane < TAUT_EIGHT; lane++) { /* those beyond are the last one again */
        const int at = lane < count ? lane : count - 1;
        work->first[lane] = taut_basis_first(job->scaled.basis[1], cells->span[from + at]);
        work->width[lane] =
            ldexp(cells->hi[from + at] - cells->lo[from + at], -job->scaled.shift[1]);
        for (int level = 0; level < 2; level++) {
            take_nodes(&nodes[level][at], job->scaled.local[1], lane, &work->v[level]);
        }
        for (int k = 0; k < 2; k++) {
            work->largest[k][lane] = nodes[1][at].largest[k];
        }
    }
}

/* Half of each coordinate, lane by lane. Columns that follow each other are read once for all. */
static void load_halves(const taut_job *job, size_t first_row, taut_eight_work *work)
{
    const size_t columns = (size_t)taut_basis_count(job->scaled.basis[1]);
    const size_t nv = (size_t)job->scaled.local[1], wide = TAUT_EIGHT + nv;
    const size_t begin = (size_t)work->first[0];
    const int is_run = work->first[work->count - 1] - work->first[0] == work->count - 1;
    double *out = work->net;

    for (size_t a = 0; a < (size_t)job->scaled.local[0]; a++) {
        const double *row = job->scaled.points + 3 * (first_row + a) * columns;
        for (size_t t = 0; is_run && t < wide; t++) {
            const size_t at = begin + t < columns ? begin + t : columns - 1;
            for (size_t c = 0; c < 3; c++) {
                work->window[c * wide + t] = row[3 * at + c] / 2;
            }
        }
        for (size_t b = 0; b < nv; b++) {
            for (size_t c = 0; c < 3; c++, out += TAUT_EIGHT) {
                for (size_t lane = 0; lane < TAUT_EIGHT; lane++) {
                    out[lane] = is_run ? work->window[c * wide + b + lane]
                                       : row[3 * ((size_t)work->first[lane] + b) + c] / 2;
                }
            }
        }
    }
}

/* Values of the fields, and what their rounding is judged by (taut_bounds), from level 1. */
static void fill_references(const taut_job *job, const taut_nodes *u, double width_u,
                            const double *sizes, const taut_eight_work *work, int lane,
                            double *value)
{
    const double ratio = ldexp(1, job->scaled.shift[1] - job->scaled.shift[0]);
    const double size[3] = {sizes[lane], sizes[TAUT_EIGHT + lane], sizes[2 * TAUT_EIGHT + lane]};
    const double largest = fmax(size[0], fmax(size[1], size[2]));
    const double bu = largest * u->largest[1] * work->largest[0][lane];
    const double bv = largest * u->largest[0] * work->largest[1][lane];
    const double area = width_u * work->width[lane], noise = ratio * bu * bu + bv * bv / ratio;

    value[1] = taut_cross_share(size, largest) * bu * bv * area;
    value[3] = noise * noise * area;
    value[5] = bu * bu * area;
    value[7] = bv * bv * area;
}

void taut_eight_try(const taut_job *job, int i, const taut_nodes *const u[2], taut_eight_work *work,
                    double value[TAUT_EIGHT][TAUT_FIELDS_MAX],
                    double error[TAUT_EIGHT][TAUT_FIELDS_MAX], int is_good[TAUT_EIGHT])
{
    const taut_cells *cells = job->cells[0];
    const int *local = job->scaled.local;
    const double ratio = ldexp(1, job->scaled.shift[1] - job->scaled.shift[0]);
    const double width = ldexp(cells->hi[i] - cells->lo[i], -job->scaled.shift[0]);
    double sizes[3 * TAUT_EIGHT];
    taut_eight_sums low, high;

    load_halves(job, (size_t)taut_basis_first(job->scaled.basis[0], cells->span[i]), work);
    work->ops->centre(local[0] * local[1], taut_half_factor(job->scaled.scale), work->net, sizes);
    work->ops->sum(local, work->net, ratio, u[0], &work->v[0], work->polygons, &low);
    work->ops->sum(local, work->net, ratio, u[1], &work->v[1], work->polygons, &high);
    for (int lane = 0; lane < work->count; lane++) {
        const double least = high.least[lane];
        for (int f = 0; f < TAUT_EIGHT_FIELDS; f++) {
            value[lane][2 * f] = high.of[f][lane];
            error[lane][2 * f] = fabs(high.of[f][lane] - low.of[f][lane]);
            error[lane][2 * f + 1] = 0;
        }
        fill_references(job, u[1], width, sizes, work, lane, value[lane]);
        is_good[lane] = low.least[lane] > smallest && least > smallest &&
                        sqrt(least) > suspicion * sqrt(high.most[lane]) &&
                        taut_cell_is_good(job->integrand, value[lane], error[lane]);
    }
}
