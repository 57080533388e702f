#include "construct/pattern/roll.h"

#include "pattern/sheet/sheet.h"

#include <math.h>

taut_status taut_pattern_roll_new(int count, const taut_pattern_outline *outlines, double width,
                                  double gap, double cut_area, taut_arena *arena,
                                  taut_pattern_roll *roll)
{
    taut_sheet_box *boxes = taut_arena_take(arena, (size_t)count, sizeof *boxes);
    double size[2] = {width, 0}, widest = 0;
    int sheets = 0;

    *roll = (taut_pattern_roll){.at = taut_arena_take(arena, (size_t)count, sizeof *roll->at)};
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < count; k++) { /* a shelf runs across the roll */
        boxes[k].size[0] = outlines[k].high[1] - outlines[k].low[1];
        boxes[k].size[1] = outlines[k].high[0] - outlines[k].low[0];
        size[1] += boxes[k].size[1] + gap;
        widest = fmax(widest, boxes[k].size[0]);
    }
    size[0] = width > 0 ? width : widest;
    const taut_status status = taut_sheet_pack(arena, count, boxes, gap, size, &sheets);
    for (int k = 0; status == TAUT_OK && k < count; k++) {
        roll->at[k][0] = boxes[k].at[1] - outlines[k].low[0];
        roll->at[k][1] = boxes[k].at[0] - outlines[k].low[1];
        roll->size[0] = fmax(roll->size[0], boxes[k].at[1] + boxes[k].size[1]);
    }
    roll->size[1] = size[0];
    roll->waste = 1 - cut_area / (roll->size[0] * roll->size[1]);
    return status;
}
