/* forms_grid.c -- fundamental forms and curvatures over a grid, a line at a time. */
#include "measure/curvature/scan.h"
#include "platform/parallel.h"
#include "taut/limits.h"
#include "taut/measure.h"

#include <stdint.h>

enum { NUMBERS = 18 }; /* of a point: six vectors */

typedef struct grid {
    const taut_scan *scan;
    int nv;
    size_t room;     /* numbers of scratch per worker: the scan's, then a line */
    double *scratch; /* [workers][room] */
    taut_forms *forms;
} grid;

static void find_forms(void *context, int worker, int64_t i)
{
    const grid *g = context;
    double *scratch = g->scratch + (size_t)worker * g->room;
    double *values = scratch + g->room - (size_t)g->nv * NUMBERS;

    taut_scan_line(g->scan, (int)i, scratch, values);
    for (size_t j = 0; j < (size_t)g->nv; j++) {
        taut_forms_of((const double(*)[3])(values + j * NUMBERS),
                      g->forms + (size_t)i * (size_t)g->nv + j);
    }
}

/* Every line of the grid, once there is scratch for `workers`. */
static taut_status run_lines(taut_arena *arena, const taut_surface *surface, int nu,
                             const double *u, const double *v, int workers, grid *g)
{
    const taut_parameters lines[2] = {{.count = nu, .t = (double *)u},
                                      {.count = g->nv, .t = (double *)v}};
    taut_scan *scan = NULL;
    const taut_status status = taut_scan_new(arena, surface, &lines[0], &lines[1], &scan);

    if (status != TAUT_OK) {
        return status;
    }
    g->scan = scan;
    g->room = taut_scan_scratch(scan) + (size_t)g->nv * NUMBERS;
    g->scratch = taut_arena_take(arena, (size_t)workers * g->room, sizeof(double));
    if (g->scratch == NULL) {
        return TAUT_NO_MEMORY;
    }
    if (g->nv > 0) {
        taut_parallel_run(workers, nu, find_forms, g);
    }
    return TAUT_OK;
}

taut_status taut_surface_forms_grid(const taut_surface *surface, int nu, const double *u, int nv,
                                    const double *v, int threads, taut_forms *forms)
{
    grid g = {.nv = nv, .forms = forms};
    taut_arena *arena = NULL;
    taut_status status = TAUT_OK;

    if (surface == NULL || u == NULL || v == NULL || forms == NULL || nu < 0 || nv < 0 ||
        threads < 0 || threads > TAUT_THREADS_MAX) {
        return TAUT_BAD_ARGUMENT;
    }
    arena = taut_arena_new();
    status =
        run_lines(arena, surface, nu, u, v, taut_parallel_workers(threads, nu > 0 ? nu : 1), &g);
    taut_arena_free(arena);
    return status;
}
