#include "construct/pattern/roll.h"

#include "core/elementary/elementary.h"
#include "pattern/sheet/sheet.h"

#include <math.h>

/* Chords of a span, and places where its bend is looked at; what is added to how far it is outside of them, over the roll's width. */
enum { CHORDS = 16, LOOK = 8 };
static const double outside = 1e-8;

/* How far a curve is outside of its chords at the most, by its second derivative, doubled. */
static double bulge_of(const taut_curve *curve)
{
    const taut_basis *basis = taut_curve_t(curve);
    const double *breaks = taut_basis_breaks(basis);
    double most = 0;
    for (int k = 0; k < taut_basis_span_count(basis) * LOOK; k++) {
        const double a = breaks[k / LOOK], h = breaks[k / LOOK + 1] - a;
        double y[3][3];
        taut_curve_eval(curve, a + h * (k % LOOK + 0.5) / LOOK, 2, y[0]);
        most = fmax(most, taut_hypot(y[2][0], y[2][1]) * h * h);
    }
    return 2 * most / (8.0 * CHORDS * CHORDS);
}

static taut_status shape_of(const taut_pattern_outline *outline, taut_arena *arena,
                            taut_nest_shape *shape)
{
    const taut_basis *basis = taut_curve_t(outline->cut);
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    double(*points)[2] = taut_arena_take(arena, (size_t)spans * CHORDS, sizeof *points);

    if (points == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < spans * CHORDS; k++) {
        const int i = k / CHORDS;
        double y[3];
        taut_curve_eval(outline->cut,
                        breaks[i] + (breaks[i + 1] - breaks[i]) * (k % CHORDS) / CHORDS, 0, y);
        points[k][0] = y[0];
        points[k][1] = y[1];
    }
    *shape = (taut_nest_shape){.count = (size_t)spans * CHORDS,
                               .points = (const double(*)[2])points,
                               .low = {outline->low[0], outline->low[1]},
                               .high = {outline->high[0], outline->high[1]}};
    return TAUT_OK;
}

/* In rows that run across the roll; its length. */
static taut_status by_boxes(int count, const taut_pattern_outline *outlines, double width,
                            double gap, taut_arena *arena, taut_nest_place *places, double *length)
{
    taut_sheet_box *boxes = taut_arena_take(arena, (size_t)count, sizeof *boxes);
    double size[2] = {width, 0};
    int sheets = 0;

    if (boxes == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < count; k++) {
        boxes[k].size[0] = outlines[k].high[1] - outlines[k].low[1];
        boxes[k].size[1] = outlines[k].high[0] - outlines[k].low[0];
        size[1] += boxes[k].size[1] + gap;
    }
    const taut_status status = taut_sheet_pack(arena, count, boxes, gap, size, &sheets);
    *length = 0;
    for (int k = 0; status == TAUT_OK && k < count; k++) {
        places[k] = (taut_nest_place){
            .at = {boxes[k].at[1] - outlines[k].low[0], boxes[k].at[0] - outlines[k].low[1]}};
        *length = fmax(*length, boxes[k].at[1] + boxes[k].size[1]);
    }
    return status;
}

taut_status taut_pattern_roll_new(int count, const taut_pattern_outline *outlines, double width,
                                  double gap, int has_nap, taut_arena *arena,
                                  taut_pattern_roll *roll)
{
    const size_t n = (size_t)count;
    taut_nest_shape *shapes = taut_arena_take(arena, n, sizeof *shapes);
    taut_nest_place *nested = taut_arena_take(arena, n, sizeof *nested);
    double widest = 0, area = 0, length = INFINITY, bulge = 0;
    taut_status status = TAUT_OK;

    *roll = (taut_pattern_roll){.places = taut_arena_take(arena, n, sizeof *roll->places)};
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; status == TAUT_OK && k < count; k++) {
        area += outlines[k].area;
        widest = fmax(widest, outlines[k].high[1] - outlines[k].low[1]);
        bulge = fmax(bulge, bulge_of(outlines[k].cut));
        status = shape_of(&outlines[k], arena, &shapes[k]);
    }
    roll->size[1] = width > 0 ? width : widest;
    if (status == TAUT_OK) {
        status = by_boxes(count, outlines, roll->size[1], gap, arena, roll->places, &roll->size[0]);
    }
    if (status == TAUT_OK) {
        const double slack = bulge + outside * roll->size[1];
        status =
            taut_nest(arena, count, shapes, roll->size[1], gap, slack, !has_nap, nested, &length);
    }
    if (length < roll->size[0]) {
        roll->size[0] = length;
        roll->places = nested;
    }
    roll->waste = 1 - area / (roll->size[0] * roll->size[1]);
    return status;
}
