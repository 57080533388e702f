#include "draw/flat_page.h"

#include "core/fail.h"
#include "core/unit.h"
#include "io/flat/flat.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* In mm: lines; of paper, what is left of its edges and of the lower one; the overlap; crosses, each way; the ruler, its marks and its
 * step; letters. */
static const double line_width = 0.1, margin = 10, foot = 18, overlap = 10, cross = 4, ruler = 100,
                    ruler_mark = 2, ruler_step = 10, letters = 3.5;
static const double papers[][2] = {
    [TAUT_PAPER_A4] = {210, 297},
    [TAUT_PAPER_A3] = {297, 420},
};
static const taut_ink black = {0, 0, 0}, grey = {160, 160, 160};

/* A part of the plan on a page: what is inside [low, high], in the model's unit, so many page units large, with the model's (low[0], high[1])
 * at `corner`. */
typedef struct window {
    const taut_flat *flat;
    const taut_canvas_ops *ops;
    taut_canvas *canvas;
    double low[2], high[2], scale, corner[2];
    double width;        /* of lines, in page units */
    double (*points)[2]; /* room for any line */
} window;

/* The colour of a layer, "#d00000". */
static taut_ink ink_of(const taut_flat *flat, int layer)
{
    static const char digits[] = "0123456789abcdef";
    unsigned char parts[3];
    for (int k = 0; k < 3; k++) {
        const char *pair = flat->layers[layer].colour + 1 + 2 * k;
        parts[k] = (unsigned char)(16 * (strchr(digits, pair[0]) - digits) +
                                   (strchr(digits, pair[1]) - digits));
    }
    return (taut_ink){parts[0], parts[1], parts[2]};
}

/* y goes down on the page. */
static void place(const window *w, const double at[2], double xy[2])
{
    xy[0] = w->corner[0] + w->scale * (at[0] - w->low[0]);
    xy[1] = w->corner[1] + w->scale * (w->high[1] - at[1]);
}

/* The part of a segment that is inside: from a + t[0] (b - a) to a + t[1] (b - a). 0: none. */
static int inside(const window *w, const double a[2], const double b[2], double t[2])
{
    t[0] = 0;
    t[1] = 1;
    for (int d = 0; d < 2; d++) {
        const double step = b[d] - a[d];
        const double to_low = w->low[d] - a[d], to_high = w->high[d] - a[d];
        if (step == 0) {
            if (to_low > 0 || to_high < 0) {
                return 0;
            }
            continue;
        }
        t[0] = fmax(t[0], (step > 0 ? to_low : to_high) / step);
        t[1] = fmin(t[1], (step > 0 ? to_high : to_low) / step);
    }
    return t[0] <= t[1];
}

/* A line, in as many parts as are inside; whether any is. `is_drawn`: or only looked at. */
static int put_line(const window *w, const taut_flat_line *line, int is_drawn)
{
    const size_t count = line->count + (size_t)(line->is_closed != 0);
    const taut_ink ink = ink_of(w->flat, line->layer);
    int n = 0, any = 0;

    for (size_t k = 0; k + 1 < count; k++) {
        const double *a = line->points[k], *b = line->points[(k + 1) % line->count];
        double t[2];
        if (!inside(w, a, b, t)) {
            continue;
        }
        any = 1;
        if (n == 0 || t[0] > 0) {
            if (n > 1 && is_drawn) {
                w->ops->line(w->canvas, n, (const double(*)[2])w->points, ink, w->width);
            }
            const double from[2] = {a[0] + t[0] * (b[0] - a[0]), a[1] + t[0] * (b[1] - a[1])};
            place(w, from, w->points[0]);
            n = 1;
        }
        const double to[2] = {t[1] < 1 ? a[0] + t[1] * (b[0] - a[0]) : b[0],
                              t[1] < 1 ? a[1] + t[1] * (b[1] - a[1]) : b[1]};
        place(w, to, w->points[n++]);
        if (t[1] < 1) {
            if (is_drawn) {
                w->ops->line(w->canvas, n, (const double(*)[2])w->points, ink, w->width);
            }
            n = 0;
        }
    }
    if (n > 1 && is_drawn) {
        w->ops->line(w->canvas, n, (const double(*)[2])w->points, ink, w->width);
    }
    return any;
}

static void put_all(const window *w)
{
    for (size_t k = 0; k < w->flat->line_count; k++) {
        put_line(w, &w->flat->lines[k], 1);
    }
    for (size_t k = 0; k < w->flat->text_count; k++) {
        const taut_flat_text *text = &w->flat->texts[k];
        double xy[2];
        place(w, text->at, xy);
        if (text->at[0] >= w->low[0] && text->at[0] <= w->high[0] && text->at[1] >= w->low[1] &&
            text->at[1] <= w->high[1]) {
            w->ops->turned_text(w->canvas, xy[0], xy[1], w->scale * text->height, -text->angle,
                                ink_of(w->flat, w->flat->text_layer), text->text);
        }
    }
}

/* ---- sheets of paper ---- */

typedef struct tiling {
    double paper[2], frame[2]; /* mm */
    int count[2];              /* along the plan and across */
    double unit;               /* page units of a mm */
    double millimetre;         /* of the model's unit */
    window window;             /* of all the plan */
} tiling;

/* How many frames cover a length, each beyond the first but for the overlap. */
static double frames_of(double length, double frame)
{
    return fmax(ceil((length - overlap) / (frame - overlap)), 1);
}

/* Upright or lying, whichever takes fewer sheets. */
static double lay_out(tiling *t, taut_paper paper, const double size[2])
{
    double least = INFINITY;
    for (int turned = 0; turned < 2; turned++) {
        const double wide = papers[paper][turned], high = papers[paper][1 - turned];
        const double frame[2] = {wide - 2 * margin, high - margin - foot};
        const double count[2] = {frames_of(size[0] * t->millimetre, frame[0]),
                                 frames_of(size[1] * t->millimetre, frame[1])};
        if (count[0] * count[1] < least) {
            least = count[0] * count[1];
            t->paper[0] = wide;
            t->paper[1] = high;
            memcpy(t->frame, frame, sizeof frame);
            t->count[0] = (int)fmin(count[0], TAUT_TILES_MAX + 1.0);
            t->count[1] = (int)fmin(count[1], TAUT_TILES_MAX + 1.0);
        }
    }
    return least;
}

/* A straight line, in mm from the upper left corner of the paper. */
static void rule(const tiling *t, double x0, double y0, double x1, double y1, taut_ink ink)
{
    const double xy[2][2] = {{x0 * t->unit, y0 * t->unit}, {x1 * t->unit, y1 * t->unit}};
    t->window.ops->line(t->window.canvas, 2, xy, ink, line_width * t->unit);
}

static void put_text(const tiling *t, double x, double y, double height, taut_anchor anchor,
                     const char *text)
{
    t->window.ops->text(t->window.canvas, x * t->unit, y * t->unit, height * t->unit, anchor, black,
                        text);
}

static void put_frame(const tiling *t, double left, double top, double right, double bottom)
{
    rule(t, left, top, right, top, grey);
    rule(t, right, top, right, bottom, grey);
    rule(t, right, bottom, left, bottom, grey);
    rule(t, left, bottom, left, top, grey);
}

/* Of sheet (column, row), rows from above: its part of the plan. */
static window window_of(const tiling *t, int column, int row)
{
    const double step[2] = {(t->frame[0] - overlap) / t->millimetre,
                            (t->frame[1] - overlap) / t->millimetre};
    window w = t->window;
    w.low[0] = column * step[0];
    w.high[0] = w.low[0] + t->frame[0] / t->millimetre;
    w.high[1] = w.flat->size[1] - row * step[1];
    w.low[1] = w.high[1] - t->frame[1] / t->millimetre;
    w.scale = t->millimetre * t->unit;
    w.corner[0] = w.corner[1] = margin * t->unit;
    return w;
}

static int has_something(const window *w)
{
    for (size_t k = 0; k < w->flat->line_count; k++) {
        if (put_line(w, &w->flat->lines[k], 0)) {
            return 1;
        }
    }
    return 0;
}

static void put_crosses(const tiling *t)
{
    for (int k = 0; k < 4; k++) {
        const double x = margin + (k % 2 == 0 ? overlap / 2 : t->frame[0] - overlap / 2);
        const double y = margin + (k / 2 == 0 ? overlap / 2 : t->frame[1] - overlap / 2);
        rule(t, x - cross, y, x + cross, y, black);
        rule(t, x, y - cross, x, y + cross, black);
    }
}

static void put_ruler(const tiling *t)
{
    const double y = t->paper[1] - foot / 2, x = t->paper[0] - margin - ruler;
    rule(t, x, y, x + ruler, y, black);
    for (int k = 0; k <= ruler / ruler_step; k++) {
        const double at = x + k * ruler_step;
        rule(t, at, y, at, y - ruler_mark * (k % 5 == 0 ? 2 : 1), black);
    }
    put_text(t, x + ruler / 2, y + 1.4 * letters, letters, TAUT_ANCHOR_MIDDLE,
             "100 mm, printed at 100 %");
}

/* A sheet is named by its row and its column. */
static void name_sheet(int row, int column, char text[32])
{
    snprintf(text, 32, "%d.%d", row + 1, column + 1);
}

static void put_sheet(const tiling *t, int column, int row)
{
    const window w = window_of(t, column, row);
    char name[32], text[96];
    if (!has_something(&w)) {
        return;
    }
    t->window.ops->next_page(t->window.canvas, t->paper[0] * t->unit, t->paper[1] * t->unit);
    put_all(&w);
    put_frame(t, margin, margin, margin + t->frame[0], margin + t->frame[1]);
    put_crosses(t);
    name_sheet(row, column, name);
    snprintf(text, sizeof text, "%s: row %d of %d, column %d of %d", name, row + 1, t->count[1],
             column + 1, t->count[0]);
    put_text(t, margin, t->paper[1] - foot / 2, letters, TAUT_ANCHOR_START, text);
    put_ruler(t);
}

/* The whole plan within a frame, and where each sheet is. */
static void put_overview(const tiling *t)
{
    const double *size = t->window.flat->size;
    window w = t->window;
    const double share = fmin(t->frame[0] / size[0], t->frame[1] / size[1]); /* mm of paper */
    w.low[0] = w.low[1] = 0;
    memcpy(w.high, size, sizeof w.high);
    w.scale = share * t->unit;
    w.corner[0] = w.corner[1] = margin * t->unit;
    t->window.ops->next_page(t->window.canvas, t->paper[0] * t->unit, t->paper[1] * t->unit);
    for (int k = 0; k < t->count[0] * t->count[1]; k++) {
        const int row = k / t->count[0], column = k % t->count[0];
        const window one = window_of(t, column, row);
        double corners[2][2], middle[2], size_of[2];
        char name[32];
        if (!has_something(&one)) {
            continue;
        }
        place(&w, (const double[2]){one.low[0], fmax(one.low[1], 0)}, corners[0]);
        place(&w, (const double[2]){fmin(one.high[0], size[0]), one.high[1]}, corners[1]);
        put_frame(t, corners[0][0] / t->unit, corners[1][1] / t->unit, corners[1][0] / t->unit,
                  corners[0][1] / t->unit);
        for (int d = 0; d < 2; d++) {
            middle[d] = (corners[0][d] + corners[1][d]) / 2 / t->unit;
            size_of[d] = fabs(corners[1][d] - corners[0][d]) / t->unit;
        }
        name_sheet(row, column, name);
        const double wide = size_of[0] / (double)strlen(name);
        put_text(t, middle[0], middle[1], fmin(letters, fmin(size_of[1] / 2, wide)),
                 TAUT_ANCHOR_MIDDLE, name);
    }
    put_all(&w);
}

static taut_status put_tiles(tiling *t, taut_paper paper, taut_error *error)
{
    const double *size = t->window.flat->size;
    const double count = lay_out(t, paper, size);
    if (count > TAUT_TILES_MAX) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", "/details", count, TAUT_TILES_MAX,
                         "found a plan of %.6g x %.6g mm, which takes %.6g sheets of paper, "
                         "expected at most %d: print it smaller, on one page",
                         size[0] * t->millimetre, size[1] * t->millimetre, count, TAUT_TILES_MAX);
    }
    put_overview(t);
    for (int k = 0; k < t->count[0] * t->count[1]; k++) {
        put_sheet(t, k % t->count[0], k / t->count[0]);
    }
    return TAUT_OK;
}

taut_status taut_flat_page(const taut_model *model, const taut_write_options *options, double point,
                           const taut_canvas_ops *ops, taut_canvas *canvas, taut_arena *arena,
                           taut_error *error)
{
    const double unit = 72 / 25.4 / point; /* page units of a mm */
    const double millimetre = taut_unit_ratio(taut_model_unit(model), "mm");
    const double reduction = options->reduction > 0 ? options->reduction : 1;
    taut_flat flat;
    size_t most = 0;

    if (ops->next_page == NULL) {
        return TAUT_OK;
    }
    const taut_status status = taut_flat_read(model, arena, &flat, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (size_t k = 0; k < flat.line_count; k++) {
        most = flat.lines[k].count > most ? flat.lines[k].count : most;
    }
    const double scale = millimetre * unit / reduction;
    window whole = {.flat = &flat,
                    .ops = ops,
                    .canvas = canvas,
                    .high = {flat.size[0], flat.size[1]},
                    .scale = scale,
                    .width = line_width * unit,
                    .points = taut_arena_take(arena, most + 2, sizeof *whole.points)};
    if (whole.points == NULL) {
        return taut_fail_memory(error);
    }
    if (options->tiles != TAUT_PAPER_NONE) {
        tiling t = {.unit = unit, .millimetre = millimetre, .window = whole};
        return put_tiles(&t, options->tiles, error);
    }
    ops->next_page(canvas, scale * flat.size[0], scale * flat.size[1]);
    put_all(&whole);
    return TAUT_OK;
}
