#include "geometry/stretch.h"

#include "geometry/keep.h"
#include "taut/surface.h"

#include <string.h>

taut_status taut_stretch_read(const taut_record *item, taut_arena *arena, taut_curve **stretch)
{
    const taut_record *t = taut_record_get(item, "t"), *rows = taut_record_get(item, "points");
    const taut_record *list = taut_record_get(t, "knots");
    const size_t knot_count = taut_record_count(list), count = taut_record_count(rows);
    double *knots = taut_arena_take(arena, knot_count + 1, sizeof(double));
    double *points = taut_arena_take(arena, count + 1, 3 * sizeof(double));
    taut_basis *basis = NULL;

    *stretch = NULL;
    if (knots == NULL || points == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < knot_count; k++) {
        knots[k] = taut_record_number(taut_record_at(list, k));
    }
    for (size_t k = 0; k < count; k++) {
        const taut_record *row = taut_record_at(rows, k);
        points[3 * k] = taut_record_number(taut_record_at(row, 0));
        points[3 * k + 1] = taut_record_number(taut_record_at(row, 1));
    }
    if (knot_count > TAUT_POINTS_MAX ||
        strcmp(taut_record_text(taut_record_get(t, "type")), "bspline") != 0 ||
        taut_record_number(taut_record_get(t, "degree")) != 5) {
        return TAUT_OK;
    }
    const taut_basis_spec spec = {
        .type = "bspline", .degree = 5, .knot_count = (int)knot_count, .knots = knots};
    taut_status status = taut_basis_new(&spec, (int)count, &basis, NULL);
    if (status == TAUT_OK && (size_t)taut_basis_count(basis) == count) {
        status = taut_curve_new(NULL, basis, points, NULL, stretch, NULL);
    }
    taut_basis_free(basis);
    if (status == TAUT_OK && *stretch != NULL && !taut_keep_curve(arena, *stretch)) {
        *stretch = NULL;
        return TAUT_NO_MEMORY;
    }
    return status == TAUT_NO_MEMORY ? status : TAUT_OK;
}
