/* extremes.c -- one task per grid parameter in u; what the tasks find is joined in their order. */
#include "measure/curvature/extremes.h"

#include "core/vec3.h"
#include "measure/curvature/scan.h"
#include "taut/measure.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

typedef struct search {
    taut_scan *scan;
    const taut_parameters *u, *v;
    taut_extremes *rows; /* [grid] */
    size_t room;         /* numbers of scratch a worker has: polygons, values, flags */
    double *scratch;     /* [workers][room] */
} search;

/* Operations, as pulses count them: at a point, and of three derivatives of a function alive there. */
enum { POINT_WORK = 300, SUM_WORK = 9 };

static const taut_extremes nothing = {
    .max_e_minus_g = 0, .max_f = 0, .max_laplacian = 0, .singular = 0};

static void clear_extremes(taut_extremes *e)
{
    *e = nothing;
    e->max_abs_mean = e->min_gaussian = e->max_gaussian = nan("");
    e->max_abs_mean_at[0] = e->max_abs_mean_at[1] = nan("");
}

static void take_point(const double values[6][3], double u, double v, taut_extremes *e,
                       double *flag)
{
    double laplacian[3];
    taut_forms forms;

    taut_forms_of(values, &forms);
    for (int c = 0; c < 3; c++) {
        laplacian[c] = values[TAUT_XUU][c] + values[TAUT_XVV][c];
    }
    e->max_e_minus_g = fmax(e->max_e_minus_g, fabs(forms.e - forms.g));
    e->max_f = fmax(e->max_f, fabs(forms.f));
    e->max_laplacian = fmax(e->max_laplacian, taut_norm(laplacian));
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

static void search_row(void *context, int worker, int64_t i)
{
    const search *s = context;
    double *scratch = s->scratch + (size_t)worker * s->room;
    double *values = scratch + taut_scan_scratch(s->scan);
    double *flags = values + (size_t)s->v->count * 18;
    taut_extremes *e = &s->rows[i];

    clear_extremes(e);
    memset(flags, 0, (size_t)s->v->grid * sizeof(double));
    for (int line = s->u->first[i]; line < s->u->first[i + 1]; line++) {
        taut_scan_line(s->scan, line, scratch, values);
        for (int j = 0; j < s->v->grid; j++) {
            for (int k = s->v->first[j]; k < s->v->first[j + 1]; k++) {
                take_point((const double(*)[3])(values + 18 * (size_t)k), s->u->t[line], s->v->t[k],
                           e, &flags[j]);
            }
        }
    }
    for (int j = 0; j < s->v->grid; j++) {
        e->singular += flags[j] != 0;
    }
}

static void join_rows(const search *s, taut_extremes *all)
{
    clear_extremes(all);
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

/* Operations, as pulses count them, of a grid parameter in u. */
static double work_of_row(const taut_surface *surface, const taut_parameters *u,
                          const taut_parameters *v)
{
    const double lines = (double)u->count / u->grid;
    const double along = taut_basis_count(taut_surface_v(surface));
    return lines *
           (SUM_WORK * taut_basis_local(taut_surface_u(surface)) * along +
            v->count * (POINT_WORK + 2.0 * SUM_WORK * taut_basis_local(taut_surface_v(surface))));
}

static taut_status search_grid(taut_arena *arena, const taut_surface *surface, int grid,
                               const taut_crew *crew, taut_extremes *extremes)
{
    const taut_parameters *u = taut_parameters_new(arena, taut_surface_u(surface), grid, 0);
    const taut_parameters *v = taut_parameters_new(arena, taut_surface_v(surface), grid, 0);
    const int workers = taut_crew_workers(crew, grid);
    search s = {.u = u, .v = v};

    if (taut_scan_new(arena, surface, u, v, &s.scan) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    s.room = taut_scan_scratch(s.scan) + (size_t)v->count * 18 + (size_t)v->grid;
    s.rows = taut_arena_take(arena, (size_t)grid, sizeof *s.rows);
    s.scratch = taut_arena_take(arena, (size_t)workers * s.room, sizeof(double));
    if (s.scratch == NULL) {
        return TAUT_NO_MEMORY;
    }
    if (taut_crew_run(crew, workers, grid, work_of_row(surface, u, v), search_row, &s)) {
        return TAUT_INTERRUPTED;
    }
    join_rows(&s, extremes);
    return TAUT_OK;
}

taut_status taut_extremes_of(const taut_surface *surface, int grid, const taut_crew *crew,
                             taut_extremes *extremes)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status = search_grid(arena, surface, grid, crew, extremes);
    taut_arena_free(arena);
    return status;
}
