/* sheet_film.c -- what is known of a film beside its forms, on the cells of a sheet: where it is how far from least, what its threads pull
 * with; and how a flat piece of cloth is strained. */
#include "draw/sheet.h"

#include "measure/cloth/mounted.h"
#include "measure/dual/density.h"
#include "measure/film/stress.h"

#include <math.h>

/* What there is at a place; NaN: nothing. */
typedef double place_value(const void *of, double u, double v);

/* At corner k of cell (i, j) seen from a millionth within it: (u, v), (u+, v), (u+, v+), (u, v+). */
static double corner_of(const taut_sheet *sheet, int i, int j, int k, place_value *value,
                        const void *of)
{
    const double *u = sheet->u.at + i, *v = sheet->v.at + j;
    const double s = k == 1 || k == 2 ? 1 - 1e-6 : 1e-6, t = k >= 2 ? 1 - 1e-6 : 1e-6;
    return value(of, fmin(u[0] + s * (u[1] - u[0]), u[1]), fmin(v[0] + t * (v[1] - v[0]), v[1]));
}

static void fill_cells(const taut_sheet *sheet, place_value *value, const void *of)
{
    const int nu = sheet->u.count - 1, nv = sheet->v.count - 1;

    for (int at = 0; at < nu * nv; at++) {
        const int i = at / nv, j = at % nv;
        sheet->values[at] = value(of, sheet->u.middle[i], sheet->v.middle[j]);
        for (int k = 0; k < 4 && sheet->corners != NULL; k++) {
            sheet->corners[4 * at + k] = corner_of(sheet, i, j, k, value, of);
        }
    }
}

static double none_at(const void *of, double u, double v)
{
    (void)of;
    (void)u;
    (void)v;
    return (double)NAN;
}

static double gap_at(const void *of, double u, double v)
{
    return taut_dual_density_at(of, u, v);
}

static taut_status fill_gaps(const taut_sheet *sheet, const taut_record *details)
{
    taut_dual_density *density = NULL;
    const taut_status status = taut_dual_density_new(sheet->surface, details, &density);

    if (status == TAUT_OK) {
        fill_cells(sheet, density != NULL ? gap_at : none_at, density);
    }
    taut_dual_density_free(density);
    return status;
}

typedef struct threads {
    const taut_surface *surface;
    double densities[2];
    int along; /* 0: u, the warp; 1: v, the weft */
} threads;

static double stress_at(const void *of, double u, double v)
{
    const threads *t = of;
    double vectors[TAUT_SURFACE_VECTORS(2)][3], stress[2];
    taut_forms forms;

    if (taut_surface_eval(t->surface, u, v, 2, vectors[0]) != TAUT_OK) {
        return (double)NAN;
    }
    taut_forms_of((const double(*)[3])vectors, &forms);
    taut_stress_of(t->surface, t->densities, &forms, stress);
    return stress[t->along];
}

static double strain_at(const void *of, double s, double t)
{
    double point[3], normal[3], strain = NAN;
    taut_mounted_at(of, s, t, point, normal, &strain);
    return strain;
}

static taut_status fill_strains(const taut_sheet *sheet, const taut_model *model, taut_arena *arena)
{
    taut_mounted piece;
    const taut_status status = taut_mounted_new(model, sheet->surface, arena, &piece);

    if (status == TAUT_OK) {
        fill_cells(sheet, piece.flat != NULL ? strain_at : none_at, &piece);
    }
    return status;
}

taut_status taut_sheet_film(const taut_write_options *options, const taut_model *model,
                            taut_arena *arena, taut_sheet *sheet)
{
    const size_t cells = (size_t)(sheet->u.count - 1) * (size_t)(sheet->v.count - 1);
    threads t = {.surface = sheet->surface, .along = options->colour == TAUT_COLOUR_WEFT};

    if (options->isolines > 0) {
        sheet->corners = taut_arena_take(arena, cells, 4 * sizeof(double));
    }
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    if (options->colour == TAUT_COLOUR_GAP) {
        return fill_gaps(sheet, taut_model_details(model));
    }
    if (options->colour == TAUT_COLOUR_STRAIN) {
        return fill_strains(sheet, model, arena);
    }
    fill_cells(sheet, taut_stress_densities(model, t.surface, t.densities) ? stress_at : none_at,
               &t);
    return TAUT_OK;
}
