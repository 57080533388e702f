#include "draw/legend.h"

#include "core/elementary/elementary.h"
#include "draw/label.h"
#include "mesh/colour.h"

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

static void draw_box(const taut_legend *l, double x, double y, double w, double h, taut_ink ink)
{
    const double xy[4][2] = {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
    l->ops->polygon(l->canvas, 4, xy, ink);
}

/* The step 1, 2 or 5 times a power of ten that gives two to five steps from 0 to limit. */
static double tick_step(double limit)
{
    const double power = taut_pow(10, floor(taut_log10(limit)));
    const double first = limit / power; /* in [1, 10) */
    return power * (first < 2 ? 0.5 : first < 5 ? 1 : 2);
}

/* Ticks are numbers a such that the value is a 10^*exponent; plain from 0.01 to 9999. */
static double tick_power(double limit, int *exponent)
{
    const int e = (int)floor(taut_log10(limit));
    *exponent = e >= -2 && e <= 3 ? 0 : e;
    return taut_pow(10, *exponent);
}

/* A scale from `from` (-1 or 0) to 1 of its limit. */
typedef struct scale {
    double x, top, limit;
    int from, exponent;
    double power; /* 10^exponent */
} scale;

static void draw_ticks(const taut_legend *l, const scale *s)
{
    const double step = tick_step(s->limit);
    const int count = (int)floor(s->limit / step + 1e-9);
    const int decimals = (int)fmax(0, -floor(taut_log10(step / s->power) + 1e-9));
    char text[48];

    for (int k = s->from * count; k <= count; k++) {
        const double share = (k * step / s->limit - s->from) / (1 - s->from); /* of the height */
        const double y = s->top + bar_height * (1 - share);
        const double mark[2][2] = {{s->x + bar_width, y}, {s->x + bar_width + 6, y}};
        l->ops->line(l->canvas, 2, mark, text_ink, 1.2);
        taut_label_fixed(k * step / s->power, decimals, text, sizeof text);
        write_text(l, s->x + bar_width + 12, y + 0.35 * text_size, text_size, TAUT_ANCHOR_START,
                   text);
    }
}

/* The outline, with a pointed end where values were cut off. */
static void draw_outline(const taut_legend *l, const scale *s, int cut)
{
    const double tip = cut ? 18 : 0, low_tip = s->from < 0 ? tip : 0;
    const double middle = s->x + bar_width / 2, right = s->x + bar_width;
    const double bottom = s->top + bar_height;
    const double xy[7][2] = {{s->x, s->top},  {middle, s->top - tip},     {right, s->top},
                             {right, bottom}, {middle, bottom + low_tip}, {s->x, bottom},
                             {s->x, s->top}};
    if (cut) {
        l->ops->polygon(l->canvas, 3, xy, taut_colour_diverging(1));
        l->ops->polygon(l->canvas, 3, xy + 3, taut_colour_diverging(s->from));
    }
    l->ops->line(l->canvas, 7, xy, text_ink, 1.2);
}

/* Two lines of what is shown, and what the unit of length is raised to below 1. */
typedef struct heading {
    const char *first, *second;
    int power;
} heading;

static const heading headings[] = {
    [TAUT_COLOUR_PLAIN] = {"", "", 0},
    [TAUT_COLOUR_MEAN] = {"Mean", "curvature H", 1},
    [TAUT_COLOUR_GAUSSIAN] = {"Gaussian", "curvature K", 2},
    [TAUT_COLOUR_ISOTHERMALITY] = {"Isothermality", "0: isothermal", 0},
    [TAUT_COLOUR_GAP] = {"Gap per area", "0: least", 0},
};

static void draw_heading(const taut_legend *l, const scale *s, taut_colour colour, const char *unit)
{
    const heading *h = &headings[colour];
    const double x = s->x, y = s->top - 34;
    const int plain = s->exponent == 0;
    const char *square = h->power == 2 ? "\xc2\xb2" : "";
    char text[64] = "";

    write_text(l, x, y - 50, text_size, TAUT_ANCHOR_START, h->first);
    write_text(l, x, y - 27, text_size, TAUT_ANCHOR_START, h->second);
    if (h->power > 0) {
        snprintf(text, sizeof text, "%s%s%s", plain ? "1/" : "/", unit, square);
    }
    if (!plain) {
        /* 10 with the exponent small and raised: no font need have raised digits */
        char raised[16];
        taut_label_fixed(s->exponent, 0, raised, sizeof raised);
        write_text(l, x + 23, y, text_size, TAUT_ANCHOR_END, "10");
        write_text(l, x + 24, y - 9, 0.7 * text_size, TAUT_ANCHOR_START, raised);
    }
    write_text(l, plain ? x : x + 54, y, text_size, TAUT_ANCHOR_START, text);
}

void taut_legend_scale(const taut_legend *legend, taut_colour colour, double limit, int cut,
                       int has_grey, const char *unit)
{
    const double slice = bar_height / SLICES;
    scale s = {.x = legend->width - bar_from_right,
               .top = bar_top,
               .limit = limit,
               .from = colour >= TAUT_COLOUR_ISOTHERMALITY ? 0 : -1};

    s.power = tick_power(limit, &s.exponent);
    for (int k = 0; k < SLICES; k++) {
        const double over = k + 1 < SLICES ? 0.5 : 0; /* no white between slices */
        draw_box(legend, s.x, s.top + k * slice, bar_width, slice + over,
                 taut_colour_diverging(1 - (k + 0.5) / SLICES * (1 - s.from)));
    }
    draw_outline(legend, &s, cut);
    draw_ticks(legend, &s);
    draw_heading(legend, &s, colour, unit);
    if (has_grey) {
        const double y = bar_top + bar_height + 34;
        draw_box(legend, s.x, y, bar_width, 16, taut_colour_diverging((double)NAN));
        write_text(legend, s.x + bar_width + 12, y + 14, text_size, TAUT_ANCHOR_START, "undefined");
    }
}

void taut_legend_label(const taut_legend *legend, const double place[4], const char *label)
{
    char text[256];
    taut_label_clean(label, (size_t)fmax(4, (place[2] - place[0]) / 11), text, sizeof text);
    write_text(legend, (place[0] + place[2]) / 2, place[1] - 10, text_size, TAUT_ANCHOR_MIDDLE,
               text);
}

void taut_legend_note(const taut_legend *legend, const char *note)
{
    if (note[0] != '\0') {
        write_text(legend, 160, legend->height - 22, 16, TAUT_ANCHOR_START, note);
    }
}

void taut_legend_name(const taut_legend *legend, int row, taut_ink ink, int is_curve,
                      const char *name)
{
    const double x = legend->width - bar_from_right - 40, y = 150 + 30.0 * row;
    char text[64];
    taut_label_clean(name, 14, text, sizeof text);
    draw_box(legend, x, is_curve ? y - 8 : y - 14, bar_width, is_curve ? 3 : 16, ink);
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
        const double seen = taut_hypot(d[0], d[1]);
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
