/* extremes.c -- one task per grid parameter in u; what the tasks find is joined in their order. */
#include "measure/curvature/extremes.h"

#include "core/memory.h"
#include "measure/curvature/scan.h"
#include "platform/parallel.h"
#include "taut/measure.h"

#include <math.h>
#include <string.h>

typedef struct search {
    const taut_scan *scan;
    const taut_parameters *u, *v;
    taut_extremes *rows; /* [grid] */
    double **scratch;    /* [workers], each: polygons, values, flags */
} search;

static const taut_extremes nothing = {
    .max_e_minus_g = 0, .max_f = 0, .max_laplacian = 0, .singular = 0};

static void clear(taut_extremes *e)
{
    *e = nothing;
    e->max_abs_mean = e->min_gaussian = e->max_gaussian = nan("");
    e->max_abs_mean_at[0] = e->max_abs_mean_at[1] = nan("");
}

/* |v|, also where the square would not be a number of this size. */
static double norm(const double *v)
{
    return hypot(hypot(v[0], v[1]), v[2]);
}

static void visit(const double values[6][3], double u, double v, taut_extremes *e, double *flag)
{
    double laplacian[3];
    taut_forms forms;

    taut_forms_of(values, &forms);
    for (int c = 0; c < 3; c++) {
        laplacian[c] = values[TAUT_XUU][c] + values[TAUT_XVV][c];
    }
    e->max_e_minus_g = fmax(e->max_e_minus_g, fabs(forms.e - forms.g));
    e->max_f = fmax(e->max_f, fabs(forms.f));
    e->max_laplacian = fmax(e->max_laplacian, norm(laplacian));
    if (!forms.regular) {
        *flag = 1;
        return;
    }
    if (!(fabs(forms.mean) <= e->max_abs_mean)) {
        e->max_abs_mean = fabs(forms.mean);
        e->max_abs_mean_at[0] = u;
        e->max_abs_mean_at[1] = v;
    }
    e->min_gaussian = fmin(e->min_gaussian, forms.gaussian);
    e->max_gaussian = fmax(e->max_gaussian, forms.gaussian);
}

static void search_row(void *context, int worker, long i)
{
    const search *s = context;
    double *values = s->scratch[worker] + taut_scan_scratch(s->scan);
    double *flags = values + (size_t)s->v->count * 18;
    taut_extremes *e = &s->rows[i];

    clear(e);
    memset(flags, 0, (size_t)s->v->grid * sizeof(double));
    for (int line = s->u->first[i]; line < s->u->first[i + 1]; line++) {
        taut_scan_line(s->scan, line, s->scratch[worker], values);
        for (int j = 0; j < s->v->grid; j++) {
            for (int k = s->v->first[j]; k < s->v->first[j + 1]; k++) {
                visit((const double(*)[3])(values + 18 * (size_t)k), s->u->t[line], s->v->t[k], e,
                      &flags[j]);
            }
        }
    }
    for (int j = 0; j < s->v->grid; j++) {
        e->singular += flags[j] != 0;
    }
}

static void join_rows(const search *s, taut_extremes *all)
{
    clear(all);
    for (int i = 0; i < s->u->grid; i++) {
        const taut_extremes *e = &s->rows[i];
        all->max_e_minus_g = fmax(all->max_e_minus_g, e->max_e_minus_g);
        all->max_f = fmax(all->max_f, e->max_f);
        all->max_laplacian = fmax(all->max_laplacian, e->max_laplacian);
        all->singular += e->singular;
        if (!isnan(e->max_abs_mean) && !(e->max_abs_mean <= all->max_abs_mean)) {
            all->max_abs_mean = e->max_abs_mean;
            memcpy(all->max_abs_mean_at, e->max_abs_mean_at, sizeof all->max_abs_mean_at);
        }
        all->min_gaussian = fmin(all->min_gaussian, e->min_gaussian);
        all->max_gaussian = fmax(all->max_gaussian, e->max_gaussian);
    }
}

static taut_status run(search *s, int threads, taut_extremes *extremes)
{
    const int workers = taut_parallel_workers(threads, s->u->grid);
    const size_t numbers =
        taut_scan_scratch(s->scan) + (size_t)s->v->count * 18 + (size_t)s->v->grid;
    taut_status status = TAUT_OK;

    s->rows = taut_alloc((size_t)s->u->grid, sizeof *s->rows);
    s->scratch = taut_alloc_zero((size_t)workers, sizeof *s->scratch);
    status = s->rows != NULL && s->scratch != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    for (int w = 0; status == TAUT_OK && w < workers; w++) {
        s->scratch[w] = taut_alloc_aligned(numbers, sizeof(double));
        status = s->scratch[w] != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    }
    if (status == TAUT_OK) {
        taut_parallel_run(workers, s->u->grid, search_row, s);
        join_rows(s, extremes);
    }
    for (int w = 0; s->scratch != NULL && w < workers; w++) {
        taut_free(s->scratch[w]);
    }
    taut_free(s->scratch);
    taut_free(s->rows);
    return status;
}

taut_status taut_extremes_of(const taut_surface *surface, int grid, int threads,
                             taut_extremes *extremes)
{
    taut_parameters *u = NULL, *v = NULL;
    taut_scan *scan = NULL;
    taut_status status = taut_parameters_new(taut_surface_u(surface), grid, 0, &u);

    if (status == TAUT_OK) {
        status = taut_parameters_new(taut_surface_v(surface), grid, 0, &v);
    }
    if (status == TAUT_OK) {
        status = taut_scan_new(surface, u, v, &scan);
    }
    if (status == TAUT_OK) {
        search s = {.scan = scan, .u = u, .v = v};
        status = run(&s, threads, extremes);
    }
    taut_scan_free(scan);
    taut_parameters_free(u);
    taut_parameters_free(v);
    return status;
}
