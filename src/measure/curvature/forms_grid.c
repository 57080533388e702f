/* forms_grid.c -- fundamental forms and curvatures over a grid, a line at a time. */
#include "core/memory.h"
#include "measure/curvature/scan.h"
#include "platform/parallel.h"
#include "taut/limits.h"
#include "taut/measure.h"

enum { NUMBERS = 18 }; /* of a point: six vectors */

typedef struct grid {
    const taut_scan *scan;
    int nv;
    size_t room;     /* numbers of scratch per worker: the scan's, then a line */
    double *scratch; /* [workers][room] */
    taut_forms *forms;
} grid;

static void do_line(void *context, int worker, long i)
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

taut_status taut_surface_forms_grid(const taut_surface *surface, int nu, const double *u, int nv,
                                    const double *v, int threads, taut_forms *forms)
{
    const int workers = taut_parallel_workers(threads, nu > 0 ? nu : 1);
    const taut_parameters lines[2] = {{.count = nu, .t = (double *)u},
                                      {.count = nv, .t = (double *)v}};
    grid g = {.nv = nv, .forms = forms};
    taut_scan *scan = NULL;
    taut_status status = TAUT_OK;

    if (surface == NULL || u == NULL || v == NULL || forms == NULL || nu < 0 || nv < 0 ||
        threads < 0 || threads > TAUT_THREADS_MAX) {
        return TAUT_BAD_ARGUMENT;
    }
    status = taut_scan_new(surface, &lines[0], &lines[1], &scan);
    if (status == TAUT_OK) {
        g.scan = scan;
        g.room = taut_scan_scratch(scan) + (size_t)nv * NUMBERS;
        g.scratch = taut_alloc_aligned((size_t)workers * g.room, sizeof(double));
        status = g.scratch != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    }
    if (status == TAUT_OK && nv > 0) {
        taut_parallel_run(workers, nu, do_line, &g);
    }
    taut_free(g.scratch);
    taut_scan_free(scan);
    return status;
}
