/* sheet_gap.c -- where a film is how far from least, on the cells of a sheet. */
#include "draw/sheet.h"

#include "measure/dual/density.h"

#include <math.h>

/* Corner k of cell (i, j) seen from a millionth within it: (u, v), (u+, v), (u+, v+), (u, v+). */
static double corner_of(const taut_dual_density *density, const taut_sheet *sheet, int i, int j,
                        int k)
{
    const double *u = sheet->u.at + i, *v = sheet->v.at + j;
    const double s = k == 1 || k == 2 ? 1 - 1e-6 : 1e-6, t = k >= 2 ? 1 - 1e-6 : 1e-6;
    return taut_dual_density_at(density, fmin(u[0] + s * (u[1] - u[0]), u[1]),
                                fmin(v[0] + t * (v[1] - v[0]), v[1]));
}

static void fill_gaps(const taut_dual_density *density, taut_sheet *sheet)
{
    const int nu = sheet->u.count - 1, nv = sheet->v.count - 1;

    for (int at = 0; at < nu * nv; at++) {
        const int i = at / nv, j = at % nv;
        sheet->values[at] =
            density != NULL ? taut_dual_density_at(density, sheet->u.middle[i], sheet->v.middle[j])
                            : (double)NAN;
        for (int k = 0; k < 4 && sheet->corners != NULL; k++) {
            sheet->corners[4 * at + k] =
                density != NULL ? corner_of(density, sheet, i, j, k) : (double)NAN;
        }
    }
}

taut_status taut_sheet_gap(const taut_write_options *options, const taut_record *details,
                           taut_arena *arena, taut_sheet *sheet)
{
    const size_t cells = (size_t)(sheet->u.count - 1) * (size_t)(sheet->v.count - 1);
    taut_dual_density *density = NULL;

    if (options->isolines > 0) {
        sheet->corners = taut_arena_take(arena, cells, 4 * sizeof(double));
    }
    if (taut_arena_status(arena) != TAUT_OK ||
        taut_dual_density_new(sheet->surface, details, &density) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    fill_gaps(density, sheet);
    taut_dual_density_free(density);
    return TAUT_OK;
}
