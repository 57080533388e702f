/* sheets.c -- surfaces as solid sheets. */
#include "core/fail.h"
#include "io/cad/prepare.h"
#include "shell/thick/thick.h"

#include <math.h>

static const double side_of_thickness =
    1e-4; /* sides of sheets come nearer than that of T, as said or not */

taut_status taut_cad_make_sheets(const taut_write_options *options, double tolerance,
                                 taut_arena *arena, taut_model **nurbs, taut_cad_facts *facts,
                                 taut_error *error)
{
    taut_thick sheet;
    const taut_thick_request request = {.thickness = options->thickness,
                                        .tolerance =
                                            fmin(tolerance, side_of_thickness * options->thickness),
                                        .moved = facts->bound,
                                        .threads = options->threads};
    if (taut_model_surface_count(*nurbs) == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-surface", NULL, 0, 1,
                         "a thickness is for surfaces, and the model has none");
    }
    const taut_status status = taut_thick_new(*nurbs, &request, arena, &sheet, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_model_free(*nurbs);
    *nurbs = sheet.model;
    facts->from = sheet.from;
    facts->thickness = options->thickness;
    facts->measured = sheet.distance;
    facts->proved = facts->bound == 0 ? sheet.bound : INFINITY;
    return TAUT_OK;
}
