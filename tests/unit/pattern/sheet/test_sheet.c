/* test_sheet.c -- boxes on shelves, against places reckoned by hand. */
#include "check.h"
#include "pattern/sheet/sheet.h"

static const double sides[5][2] = {{3, 1}, {6, 2}, {3, 1}, {5, 1}, {2, 2}};

static void fill(taut_sheet_box boxes[5])
{
    for (int k = 0; k < 5; k++) {
        boxes[k] = (taut_sheet_box){.size = {sides[k][0], sides[k][1]}};
    }
}

/* By falling length 6, 5, 3, 3, 2: the first shelf holds 6 and the second 3; 5 begins a shelf of height 1, on which nothing of height 2
 * stands, and the sheet is full at 5.5: 2 begins another sheet. */
static void test_shelves(void)
{
    const double at[5][3] = {{0, 6.5, 0}, {0, 0, 0}, {0, 5.5, 2.5}, {0, 0, 2.5}, {1, 0, 0}};
    taut_arena *arena = taut_arena_new();
    taut_sheet_box boxes[5];
    double size[2] = {10, 5};
    int sheets = 0;

    fill(boxes);
    CHECK(taut_sheet_pack(arena, 5, boxes, 0.5, size, &sheets) == TAUT_OK, "pack");
    CHECK(sheets == 2, "%d sheets", sheets);
    CHECK(size[0] == 10 && size[1] == 5, "a given size stays");
    for (int k = 0; k < 5; k++) {
        CHECK(boxes[k].sheet == (int)at[k][0] && boxes[k].at[0] == at[k][1] &&
                  boxes[k].at[1] == at[k][2],
              "box %d: sheet %d, %g %g", k, boxes[k].sheet, boxes[k].at[0], boxes[k].at[1]);
    }
    taut_arena_free(arena);
}

/* Without a size one above the other: 2 + 1 + 1 + 1 + 2 and four gaps. */
static void test_stack(void)
{
    taut_arena *arena = taut_arena_new();
    taut_sheet_box boxes[5];
    double size[2] = {0, 0};
    int sheets = 0;

    fill(boxes);
    CHECK(taut_sheet_pack(arena, 5, boxes, 0.5, size, &sheets) == TAUT_OK, "pack");
    CHECK(sheets == 1 && size[0] == 6 && size[1] == 9, "%d sheets, %g x %g", sheets, size[0],
          size[1]);
    CHECK(boxes[3].at[1] == 2.5 && boxes[0].at[1] == 4 && boxes[2].at[1] == 5.5 &&
              boxes[4].at[1] == 7,
          "%g %g %g %g", boxes[3].at[1], boxes[0].at[1], boxes[2].at[1], boxes[4].at[1]);
    taut_arena_free(arena);
}

static void test_nothing(void)
{
    taut_arena *arena = taut_arena_new();
    taut_sheet_box box = {.size = {1, 1}};
    double size[2] = {0, 0};
    int sheets = 7;
    CHECK(taut_sheet_pack(arena, 0, &box, 1, size, &sheets) == TAUT_OK && sheets == 0, "none");
    taut_arena_free(arena);
}

int main(void)
{
    test_shelves();
    test_stack();
    test_nothing();
    return check_failures != 0;
}
