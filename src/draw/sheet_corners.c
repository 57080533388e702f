/* sheet_corners.c -- values at the corners of the cells of a sheet, as the cell itself sees them.
 */
#include "draw/sheet.h"

#include "core/elementary/elementary.h"
#include "taut/measure.h"

#include <math.h>

/* What is asked at a point; context is the asker's. */
typedef double (*asked)(const void *context, const taut_forms *forms);

/* The two lines of every cell, a millionth of it within. */
static double *lines_within(const taut_grid_lines *lines, taut_arena *arena)
{
    const int cells = lines->count - 1;
    double *at = taut_arena_take(arena, 2 * (size_t)cells, sizeof(double));
    for (int i = 0; at != NULL && i < cells; i++) {
        const double a = lines->at[i], b = lines->at[i + 1];
        at[2 * i] = fmin(a + 1e-6 * (b - a), b);
        at[2 * i + 1] = fmax(b - 1e-6 * (b - a), a);
    }
    return at;
}

/* corners[j][k] of one row of cells from the vectors of its two lines, double[2][2*nv][6][3]. */
static void fill_row(int nv, const double *vectors, asked ask, const void *context, double *corners)
{
    static const size_t line[4] = {0, 1, 1, 0}, column[4] = {0, 0, 1, 1};
    for (size_t j = 0; j < (size_t)nv; j++) {
        for (size_t k = 0; k < 4; k++) {
            const double *at = vectors + 18 * (line[k] * 2 * (size_t)nv + 2 * j + column[k]);
            taut_forms forms;
            taut_forms_of((const double(*)[3])at, &forms);
            corners[4 * j + k] = ask(context, &forms);
        }
    }
}

static taut_status fill_corners(const taut_sheet *sheet, asked ask, const void *context,
                                int threads, taut_arena *arena, double **corners)
{
    const int nu = sheet->u.count - 1, nv = sheet->v.count - 1;
    const double *u = lines_within(&sheet->u, arena), *v = lines_within(&sheet->v, arena);
    double *vectors = taut_arena_take(arena, 4 * (size_t)nv, 18 * sizeof(double));
    double *made = taut_arena_take(arena, (size_t)nu * (size_t)nv, 4 * sizeof(double));

    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < nu; i++) {
        const taut_status status =
            taut_surface_eval_grid(sheet->surface, 2, u + 2 * i, 2 * nv, v, 2, threads, vectors);
        if (status != TAUT_OK) {
            return status;
        }
        fill_row(nv, vectors, ask, context, made + 4 * (size_t)i * (size_t)nv);
    }
    *corners = made;
    return TAUT_OK;
}

static double ask_value(const void *context, const taut_forms *forms)
{
    const taut_write_options *options = context;
    return taut_sheet_value(options->colour, forms);
}

taut_status taut_sheet_corners(const taut_write_options *options, taut_arena *arena,
                               taut_sheet *sheet)
{
    return fill_corners(sheet, ask_value, options, options->threads, arena, &sheet->corners);
}

typedef struct room {
    const taut_camera *camera;
    int lights;
} room;

/* Either side of a surface mirrors alike: r does not change with the sign of n. */
static double ask_light(const void *context, const taut_forms *forms)
{
    const room *lit = context;
    const taut_camera *c = lit->camera;
    const double *n = forms->normal;
    const double across = n[0] * c->right[0] + n[1] * c->right[1] + n[2] * c->right[2];
    const double toward = n[0] * c->eye[0] + n[1] * c->eye[1] + n[2] * c->eye[2];
    return lit->lights * taut_atan2(2 * toward * across, 2 * toward * toward - 1);
}

taut_status taut_sheet_stripes(const taut_write_options *options, const taut_camera *camera,
                               taut_arena *arena, taut_sheet *sheet)
{
    const room lit = {camera, options->reflections};
    return fill_corners(sheet, ask_light, &lit, options->threads, arena, &sheet->stripes);
}
