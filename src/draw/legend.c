#include "draw/legend.h"

#include "draw/colour.h"
#include "draw/label.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const taut_ink text_ink = {30, 34, 42}, light_ink = {120, 126, 138};
static const double text_size = 18, title_size = 24;

enum { SLICES = 64 };

/* The scale's place: its left, top, width, height from the page's right. */
static const double bar_from_right = 150, bar_top = 250, bar_width = 26, bar_height = 480;

static void write_text(const taut_legend *l, double x, double y, double size, taut_anchor anchor,
                       const char *text)
{
    l->ops->text(l->canvas, x, y, size, anchor, text_ink, text);
}

static void box(const taut_legend *l, double x, double y, double w, double h, taut_ink ink)
{
    const double xy[4][2] = {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
    l->ops->polygon(l->canvas, 4, xy, ink);
}

/* The step 1, 2 or 5 times a power of ten that gives two to five steps from 0 to limit. */
static double tick_step(double limit)
{
    const double power = pow(10, floor(log10(limit)));
    const double first = limit / power; /* in [1, 10) */
    return power * (first < 2 ? 0.5 : first < 5 ? 1 : 2);
}

/* Ticks are numbers a such that the value is a 10^*exponent; plain from 0.01 to 9999. */
static double tick_power(double limit, int *exponent)
{
    const int e = (int)floor(log10(limit));
    *exponent = e >= -2 && e <= 3 ? 0 : e;
    return pow(10, *exponent);
}

static void draw_ticks(const taut_legend *l, double x, double top, double limit, double power)
{
    const double step = tick_step(limit);
    const int count = (int)floor(limit / step + 1e-9);
    const int decimals = (int)fmax(0, -floor(log10(step / power) + 1e-9));
    char text[48];

    for (int k = -count; k <= count; k++) {
        const double y = top + bar_height * (0.5 - 0.5 * k * step / limit);
        const double mark[2][2] = {{x + bar_width, y}, {x + bar_width + 6, y}};
        l->ops->line(l->canvas, 2, mark, text_ink, 1.2);
        taut_label_fixed(k * step / power, decimals, text, sizeof text);
        write_text(l, x + bar_width + 12, y + 0.35 * text_size, text_size, TAUT_ANCHOR_START, text);
    }
}

/* The outline, with a pointed end above and below when values were cut off. */
static void draw_outline(const taut_legend *l, double x, double top, int cut)
{
    const double tip = cut ? 18 : 0, middle = x + bar_width / 2, right = x + bar_width;
    const double bottom = top + bar_height;
    const double xy[7][2] = {{x, top},        {middle, top - tip},    {right, top},
                             {right, bottom}, {middle, bottom + tip}, {x, bottom},
                             {x, top}};
    if (cut) {
        l->ops->polygon(l->canvas, 3, xy, taut_colour_diverging(1));
        l->ops->polygon(l->canvas, 3, xy + 3, taut_colour_diverging(-1));
    }
    l->ops->line(l->canvas, 7, xy, text_ink, 1.2);
}

static void draw_heading(const taut_legend *l, double x, double top, taut_colour colour,
                         int exponent, const char *unit)
{
    const int mean = colour == TAUT_COLOUR_MEAN;
    char text[64];
    write_text(l, x, top - 84, text_size, TAUT_ANCHOR_START, mean ? "Mean" : "Gaussian");
    snprintf(text, sizeof text, "curvature %s", mean ? "H" : "K");
    write_text(l, x, top - 61, text_size, TAUT_ANCHOR_START, text);
    if (exponent == 0) {
        snprintf(text, sizeof text, mean ? "1/%s" : "1/%s\xc2\xb2", unit);
        write_text(l, x, top - 34, text_size, TAUT_ANCHOR_START, text);
    } else {
        /* 10 with the exponent small and raised: no font need have raised digits */
        char raised[16];
        taut_label_fixed(exponent, 0, raised, sizeof raised);
        write_text(l, x + 23, top - 34, text_size, TAUT_ANCHOR_END, "10");
        write_text(l, x + 24, top - 43, 0.7 * text_size, TAUT_ANCHOR_START, raised);
        snprintf(text, sizeof text, mean ? "/%s" : "/%s\xc2\xb2", unit);
        write_text(l, x + 54, top - 34, text_size, TAUT_ANCHOR_START, text);
    }
}

void taut_legend_scale(const taut_legend *legend, taut_colour colour, double limit, int cut,
                       int has_grey, const char *unit)
{
    const double x = legend->width - bar_from_right;
    const double slice = bar_height / SLICES;
    int exponent = 0;
    const double power = tick_power(limit, &exponent);

    for (int k = 0; k < SLICES; k++) {
        const double over = k + 1 < SLICES ? 0.5 : 0; /* no white between slices */
        box(legend, x, bar_top + k * slice, bar_width, slice + over,
            taut_colour_diverging(1 - (2 * k + 1.0) / SLICES));
    }
    draw_outline(legend, x, bar_top, cut);
    draw_ticks(legend, x, bar_top, limit, power);
    draw_heading(legend, x, bar_top, colour, exponent, unit);
    if (has_grey) {
        const double y = bar_top + bar_height + 34;
        box(legend, x, y, bar_width, 16, taut_colour_diverging((double)NAN));
        write_text(legend, x + bar_width + 12, y + 14, text_size, TAUT_ANCHOR_START, "undefined");
    }
}

void taut_legend_name(const taut_legend *legend, int row, taut_ink ink, int is_curve,
                      const char *name)
{
    const double x = legend->width - bar_from_right - 40, y = 150 + 30.0 * row;
    char text[64];
    taut_label_clean(name, 14, text, sizeof text);
    box(legend, x, is_curve ? y - 8 : y - 14, bar_width, is_curve ? 3 : 16, ink);
    write_text(legend, x + bar_width + 12, y, text_size, TAUT_ANCHOR_START, text);
}

void taut_legend_title(const taut_legend *legend, const char *title)
{
    char text[512];
    taut_label_clean(title, 84, text, sizeof text);
    write_text(legend, legend->width / 2, 52, title_size, TAUT_ANCHOR_MIDDLE, text);
}

/* x, y, z from a corner of the page; an axis that points at the viewer is too short for a name. */
void taut_legend_axes(const taut_legend *legend, const taut_camera *camera)
{
    static const char *const names[] = {"x", "y", "z"};
    const double at[2] = {72, legend->height - 72}, length = 46;
    for (int c = 0; c < 3; c++) {
        const double d[2] = {camera->right[c], -camera->up[c]};
        const double seen = hypot(d[0], d[1]);
        const double tip[2] = {at[0] + length * d[0], at[1] + length * d[1]};
        const double shaft[2][2] = {{at[0], at[1]}, {tip[0], tip[1]}};
        if (seen > 0.2) {
            const double e[2] = {d[0] / seen, d[1] / seen};
            const double head[3][2] = {
                {tip[0] + 4 * e[0], tip[1] + 4 * e[1]},
                {tip[0] - 6 * e[0] - 3.5 * e[1], tip[1] - 6 * e[1] + 3.5 * e[0]},
                {tip[0] - 6 * e[0] + 3.5 * e[1], tip[1] - 6 * e[1] - 3.5 * e[0]}};
            legend->ops->line(legend->canvas, 2, shaft, light_ink, 1.4);
            legend->ops->polygon(legend->canvas, 3, head, light_ink);
            legend->ops->text(legend->canvas, tip[0] + 15 * e[0], tip[1] + 15 * e[1] + 5, 16,
                              TAUT_ANCHOR_MIDDLE, light_ink, names[c]);
        }
    }
}
