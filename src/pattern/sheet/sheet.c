#include "pattern/sheet/sheet.h"

#include <math.h>

/* A row of pieces. */
typedef struct shelf {
    int sheet;
    double from, height; /* across the sheet */
    double used;         /* along it */
} shelf;

/* The order by falling length, stable. */
static int *order_of(taut_arena *arena, int count, const taut_sheet_box *boxes)
{
    int *order = taut_arena_take(arena, (size_t)count + 1, sizeof *order);
    for (int k = 0; order != NULL && k < count; k++) {
        int i = k;
        for (; i > 0 && boxes[order[i - 1]].size[0] < boxes[k].size[0]; i--) {
            order[i] = order[i - 1];
        }
        order[i] = k;
    }
    return order;
}

static void stack(int count, const int *order, taut_sheet_box *boxes, double gap, double size[2])
{
    double top = 0;
    for (int k = 0; k < count; k++) {
        taut_sheet_box *box = &boxes[order[k]];
        box->sheet = 0;
        box->at[0] = 0;
        box->at[1] = k > 0 ? top + gap : 0;
        top = box->at[1] + box->size[1];
        size[0] = fmax(size[0], box->size[0]);
    }
    size[1] = top;
}

static int fits(const shelf *on, const taut_sheet_box *box, double gap, const double size[2])
{
    const double from = on->used > 0 ? on->used + gap : 0;
    return box->size[1] <= on->height && from + box->size[0] <= size[0];
}

taut_status taut_sheet_pack(taut_arena *arena, int count, taut_sheet_box *boxes, double gap,
                            double size[2], int *sheets)
{
    shelf *shelves = taut_arena_take(arena, (size_t)count + 1, sizeof *shelves);
    const int *order = order_of(arena, count, boxes);
    int shelf_count = 0;

    *sheets = count > 0;
    if (shelves == NULL || order == NULL) {
        return TAUT_NO_MEMORY;
    }
    if (size[0] == 0) {
        stack(count, order, boxes, gap, size);
        return TAUT_OK;
    }
    for (int k = 0; k < count; k++) {
        taut_sheet_box *box = &boxes[order[k]];
        int i = 0;
        while (i < shelf_count && !fits(&shelves[i], box, gap, size)) {
            i++;
        }
        if (i == shelf_count) {
            const shelf *last = shelf_count > 0 ? &shelves[shelf_count - 1] : NULL;
            const double from = last != NULL ? last->from + last->height + gap : 0;
            const int is_new = last != NULL && from + box->size[1] > size[1];
            shelves[shelf_count++] = (shelf){
                .sheet = *sheets - 1 + is_new, .from = is_new ? 0 : from, .height = box->size[1]};
            *sheets += is_new;
        }
        box->sheet = shelves[i].sheet;
        box->at[0] = shelves[i].used > 0 ? shelves[i].used + gap : 0;
        box->at[1] = shelves[i].from;
        shelves[i].used = box->at[0] + box->size[0];
    }
    return TAUT_OK;
}
