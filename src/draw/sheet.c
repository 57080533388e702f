#include "draw/sheet.h"

#include "core/elementary/elementary.h"
#include "taut/measure.h"

#include <math.h>
#include <stdint.h>

enum { KNOTS_SHOWN = 24 };

/* The mean length of the rows of the net (along v), or of its columns (along u), by a few of each:
 * cells come out about square. */
static double mean_length(const taut_surface *surface, int along_u)
{
    const int nu = taut_basis_count(taut_surface_u(surface));
    const int nv = taut_basis_count(taut_surface_v(surface));
    const int across = along_u ? nv : nu, along = along_u ? nu : nv;
    const size_t step_across = along_u ? 3 : 3 * (size_t)nv;
    const size_t step_along = along_u ? 3 * (size_t)nv : 3;
    const int skip = (across + 7) / 8;
    double sum = 0;

    for (int i = 0; i < across; i += skip) {
        const double *p = taut_surface_points(surface) + (size_t)i * step_across;
        for (int j = 1; j < along; j++, p += step_along) {
            sum += taut_hypot(taut_hypot(p[step_along] - p[0], p[step_along + 1] - p[1]),
                              p[step_along + 2] - p[2]);
        }
    }
    return sum / ((across + skip - 1) / skip);
}

/* cells = *u by *v, squarish, neither below a third of the square root. */
static void share_cells(const taut_surface *surface, int cells, int *u, int *v)
{
    const double length_u = mean_length(surface, 1), length_v = mean_length(surface, 0);
    const double root = sqrt((double)cells);
    double ratio = sqrt(length_u / length_v);

    if (!(ratio >= 1.0 / 3)) { /* also 0/0 and inf/inf */
        ratio = length_u < length_v ? 1.0 / 3 : 1;
    }
    ratio = fmin(ratio, 3);
    *u = (int)fmax(1, round(root * ratio));
    *v = (int)fmax(1, round(root / ratio));
}

/* `cells` cells: the spans cut into equal numbers, or as many breaks as that when there are more
 * spans. Between breaks the parameter is a convex combination, which cannot overflow. */
static taut_status fill_lines(const taut_basis *basis, int cells, taut_arena *arena,
                              taut_grid_lines *lines)
{
    const int spans = taut_basis_span_count(basis);
    const double *breaks = taut_basis_breaks(basis);
    const int per = cells > spans ? (cells + spans / 2) / spans : 1;
    const int count = cells > spans ? per * spans : cells;
    const int shown = (count / per + KNOTS_SHOWN - 1) / KNOTS_SHOWN; /* every so many breaks */

    lines->count = count + 1;
    lines->at = taut_arena_take(arena, (size_t)count + 1, sizeof(double));
    lines->middle = taut_arena_take(arena, (size_t)count, sizeof(double));
    lines->is_knot = taut_arena_take(arena, (size_t)count + 1, 1);
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i <= count; i++) {
        const int span = cells > spans ? i / per : (int)((int64_t)i * spans / count);
        const int part = i % per;
        const double s = (double)part / per;
        lines->at[i] = part == 0
                           ? breaks[span]
                           : fmin(fmax((1 - s) * breaks[span] + s * breaks[span + 1], breaks[span]),
                                  breaks[span + 1]);
        lines->is_knot[i] = part == 0 && i > 0 && i < count && (i / per) % shown == 0;
    }
    for (int i = 0; i < count; i++) {
        lines->middle[i] =
            fmin(fmax(lines->at[i] / 2 + lines->at[i + 1] / 2, lines->at[i]), lines->at[i + 1]);
    }
    return TAUT_OK;
}

double taut_sheet_value(taut_colour colour, const taut_forms *forms)
{
    const double x[] = {
        [TAUT_COLOUR_PLAIN] = (double)NAN,
        [TAUT_COLOUR_MEAN] = forms->regular ? forms->mean : (double)NAN,
        [TAUT_COLOUR_GAUSSIAN] = forms->regular ? forms->gaussian : (double)NAN,
        [TAUT_COLOUR_ISOTHERMALITY] =
            taut_hypot(forms->e - forms->g, 2 * forms->f) / (forms->e + forms->g),
        [TAUT_COLOUR_GAP] = (double)NAN, /* forms do not tell: taut_sheet_film */
        [TAUT_COLOUR_WARP] = (double)NAN,
        [TAUT_COLOUR_WEFT] = (double)NAN,
        [TAUT_COLOUR_STRAIN] = (double)NAN,
    };
    return isfinite(x[colour]) ? x[colour] : (double)NAN;
}

/* values[i] from the six vectors of each of `count` cells. */
static void forms_to_values(const taut_write_options *options, size_t count, const double *vectors,
                            double *values)
{
    for (size_t i = 0; i < count; i++) {
        taut_forms forms;
        taut_forms_of((const double(*)[3])(vectors + 18 * i), &forms);
        values[i] = taut_sheet_value(options->colour, &forms);
    }
}

/* What the colour shows in the middle of each cell, some rows of the grid at a time. */
static taut_status fill_values(const taut_write_options *options, taut_arena *arena,
                               taut_sheet *sheet)
{
    const int nu = sheet->u.count - 1, nv = sheet->v.count - 1;
    const int rows = nu < 64 ? nu : 64;
    double *vectors = taut_arena_take(arena, (size_t)rows * (size_t)nv, 18 * sizeof(double));

    sheet->values = taut_arena_take(arena, (size_t)nu * (size_t)nv, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < nu; i += rows) {
        const int part = nu - i < rows ? nu - i : rows;
        const taut_status status =
            taut_surface_eval_grid(sheet->surface, part, sheet->u.middle + i, nv, sheet->v.middle,
                                   2, options->threads, vectors);
        if (status != TAUT_OK) {
            return status;
        }
        forms_to_values(options, (size_t)part * (size_t)nv, vectors,
                        sheet->values + (size_t)i * (size_t)nv);
    }
    return TAUT_OK;
}

/* The cells in each direction: `divide` a span, or about `cells` in all. */
static void choose_cells(const taut_surface *surface, int cells, int most, int divide, int *u,
                         int *v)
{
    const double spans_u = taut_basis_span_count(taut_surface_u(surface));
    const double spans_v = taut_basis_span_count(taut_surface_v(surface));
    if (divide > 0) {
        const double all = spans_u * divide * (spans_v * divide);
        const double shrink = fmin(1, sqrt(most / all));
        *u = (int)fmax(1, fmin(spans_u * divide * shrink, most));
        *v = (int)fmax(1, fmin(spans_v * divide * shrink, most));
    } else {
        share_cells(surface, cells, u, v);
    }
}

taut_status taut_sheet_new(const taut_surface *surface, int cells, int most,
                           const taut_write_options *options, taut_arena *arena, taut_sheet *sheet)
{
    int cells_u = 1, cells_v = 1;

    choose_cells(surface, cells, most, options->divide, &cells_u, &cells_v);
    sheet->surface = surface;
    if (fill_lines(taut_surface_u(surface), cells_u, arena, &sheet->u) != TAUT_OK ||
        fill_lines(taut_surface_v(surface), cells_v, arena, &sheet->v) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    sheet->points =
        taut_arena_take(arena, (size_t)sheet->u.count * (size_t)sheet->v.count, 3 * sizeof(double));
    if (sheet->points == NULL) {
        return TAUT_NO_MEMORY;
    }
    const taut_status status =
        taut_surface_eval_grid(surface, sheet->u.count, sheet->u.at, sheet->v.count, sheet->v.at, 0,
                               options->threads, sheet->points);
    return status == TAUT_OK && options->colour != TAUT_COLOUR_PLAIN
               ? fill_values(options, arena, sheet)
               : status;
}
