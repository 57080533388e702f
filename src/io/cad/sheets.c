/* sheets.c -- surfaces as solid sheets. */
#include "core/fail.h"
#include "io/cad/prepare.h"
#include "shell/thick/thick.h"

#include <math.h>

static const double side_of_thickness =
    1e-4; /* sides of sheets come nearer than that of T, as said or not */

enum { TRIES = 4 }; /* splines come nearer from one to the next, by half */

/* How far a sheet is from where it belongs: proved where anything is. */
static double how_near(const taut_thick *sheet)
{
    return sheet->bound < INFINITY ? sheet->bound : sheet->distance;
}

/* A sheet within the tolerance, as long as finer splines come nearer; else one that is not. */
static taut_status make_sheet(const taut_model *nurbs, taut_thick_request *request,
                              double tolerance, taut_arena *arena, taut_thick *sheet,
                              taut_error *error)
{
    for (int k = 0;; k++) {
        const taut_status status = taut_thick_new(nurbs, request, arena, sheet, error);
        if (status != TAUT_OK || request->moved > 0 || how_near(sheet) <= tolerance ||
            sheet->parted > tolerance || k + 1 == TRIES) {
            return status;
        }
        request->tolerance /= 2;
        taut_model_free(sheet->model);
    }
}

static taut_status fail_sheet(const taut_thick *sheet, double thickness, double tolerance,
                              taut_error *error)
{
    return taut_fail(error, TAUT_NO_SOLUTION, "sheet", NULL, how_near(sheet), tolerance,
                     "a sheet of thickness %.6g is within %.3g of where it belongs, expected at "
                     "most %.3g, the tolerance: angles between surfaces take %.3g of it (give them "
                     "more points, or raise --tolerance)",
                     thickness, how_near(sheet), tolerance, sheet->parted);
}

taut_status taut_cad_make_sheets(const taut_write_options *options, double tolerance,
                                 taut_arena *arena, taut_model **nurbs, taut_cad_facts *facts,
                                 taut_error *error)
{
    taut_thick sheet;
    taut_thick_request request = {.thickness = options->thickness,
                                  .tolerance =
                                      fmin(tolerance, side_of_thickness * options->thickness),
                                  .moved = facts->bound,
                                  .threads = options->threads};
    if (taut_model_surface_count(*nurbs) == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-surface", NULL, 0, 1,
                         "a thickness is for surfaces, and the model has none");
    }
    const taut_status status = make_sheet(*nurbs, &request, tolerance, arena, &sheet, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (options->tolerance > 0 && facts->bound == 0 && !(how_near(&sheet) <= tolerance)) {
        taut_model_free(sheet.model);
        return fail_sheet(&sheet, options->thickness, tolerance, error);
    }
    taut_model_free(*nurbs);
    *nurbs = sheet.model;
    facts->from = sheet.from;
    facts->thickness = options->thickness;
    facts->measured = sheet.distance;
    facts->proved = facts->bound == 0 ? sheet.bound : INFINITY;
    return TAUT_OK;
}
