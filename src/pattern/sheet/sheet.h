/* sheet.h -- flat pieces on sheets, by the boxes around them.
 *
 * Shelves: the pieces by falling length, those of one length in their order; each goes on the first shelf of
 * the first sheet where it fits, or on a new shelf above the last one, or on a new sheet.
 */
#ifndef TAUT_PATTERN_SHEET_H
#define TAUT_PATTERN_SHEET_H

#include "core/arena.h"

typedef struct taut_sheet_box {
    double size[2]; /* along the sheet and across */
    int sheet;      /* from 0 */
    double at[2];   /* its lower left corner */
} taut_sheet_box;

/* Places all of them, `gap` apart. size: of the sheets, which no box is larger than; or zeros, and it becomes that
 * of one that is as large as they need, one above the other. *sheets: how many. TAUT_NO_MEMORY. */
taut_status taut_sheet_pack(taut_arena *arena, int count, taut_sheet_box *boxes, double gap,
                            double size[2], int *sheets);

#endif /* TAUT_PATTERN_SHEET_H */
