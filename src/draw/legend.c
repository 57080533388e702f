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

/* The scale's place: its left from the page's right, its width, how high it is at the most, what its heading takes. */
static const double bar_from_right = 150, bar_width = 26, bar_most = 480, heading_height = 104;

static void write_text(const taut_legend *l, double x, double y, double size, taut_anchor anchor,
                       const char *text)
{
    l->ops->text(l->canvas, x, y, fmax(size, l->least), anchor, text_ink, text);
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

/* A scale from `from` (-1 or 0) to `to` (0 or 1) of its limit. */
typedef struct scale {
    double x, top, height, limit;
    int from, to, exponent;
    double power; /* 10^exponent */
} scale;

static void draw_ticks(const taut_legend *l, const scale *s)
{
    const double step = tick_step(s->limit);
    const int count = (int)floor(s->limit / step + 1e-9);
    const int decimals = (int)fmax(0, -floor(taut_log10(step / s->power) + 1e-9));
    char text[48];

    for (int k = s->from * count; k <= s->to * count; k++) {
        const double share =
            (k * step / s->limit - s->from) / (s->to - s->from); /* of the height */
        const double y = s->top + s->height * (1 - share);
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
    const double tip = cut ? 18 : 0, low_tip = s->from < 0 ? tip : 0, top_tip = s->to > 0 ? tip : 0;
    const double middle = s->x + bar_width / 2, right = s->x + bar_width;
    const double bottom = s->top + s->height;
    const double xy[7][2] = {{s->x, s->top},  {middle, s->top - top_tip}, {right, s->top},
                             {right, bottom}, {middle, bottom + low_tip}, {s->x, bottom},
                             {s->x, s->top}};
    if (cut) {
        l->ops->polygon(l->canvas, 3, xy, taut_colour_diverging(s->to));
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
    [TAUT_COLOUR_WARP] = {"Stress, warp", "force per width", 1},
    [TAUT_COLOUR_WEFT] = {"Stress, weft", "force per width", 1},
    [TAUT_COLOUR_STRAIN] = {"Strain", "larger principal", 0},
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
        /* times 10 with the exponent small and raised: no font need have raised digits */
        char raised[16];
        taut_label_fixed(s->exponent, 0, raised, sizeof raised);
        write_text(l, x + 38, y, text_size, TAUT_ANCHOR_END,
                   "\xc3\x97"
                   "10");
        write_text(l, x + 39, y - 9, 0.7 * text_size, TAUT_ANCHOR_START, raised);
    }
    write_text(l, plain ? x : x + 69, y, text_size, TAUT_ANCHOR_START, text);
}

void taut_legend_scale(const taut_legend *legend, taut_colour colour,
                       const taut_legend_range *range, const char *unit)
{
    const double room = legend->height - legend->top - heading_height - 130;
    const double height = fmax(fmin(bar_most, room), 100), slice = height / SLICES;
    scale s = {.x = legend->width - bar_from_right,
               .top = legend->top + heading_height + fmax(0, (room - height) / 2),
               .height = height,
               .limit = range->limit,
               .from = range->sign > 0 ? 0 : -1,
               .to = range->sign < 0 ? 0 : 1};

    s.power = tick_power(range->limit, &s.exponent);
    for (int k = 0; k < SLICES; k++) {
        const double over = k + 1 < SLICES ? 0.5 : 0; /* no white between slices */
        draw_box(legend, s.x, s.top + k * slice, bar_width, slice + over,
                 taut_colour_diverging(s.to - (k + 0.5) / SLICES * (s.to - s.from)));
    }
    draw_outline(legend, &s, range->cut);
    draw_ticks(legend, &s);
    draw_heading(legend, &s, colour, unit);
    if (range->has_grey) {
        const double y = s.top + height + 34;
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

/* How many bytes of the note fit into the width, up to a "; " but at least to the first. */
static size_t part_of(const char *note, double width, double size)
{
    size_t fits = 0;
    for (const char *end = note; end != NULL;) {
        char part[256];
        end = strstr(end + (fits > 0 ? 2 : 0), "; ");
        const size_t length = end != NULL ? (size_t)(end - note) : strlen(note);
        snprintf(part, sizeof part, "%.*s", (int)length, note);
        if (fits > 0 && taut_label_width(part, size) > width) {
            break;
        }
        fits = length;
    }
    return fits;
}

int taut_legend_note(const taut_legend *legend, double x, double y, const char *note)
{
    const double size = fmax(16, legend->least);
    int lines = 0;

    while (*note != '\0') {
        const double room = legend->width - 24 - (lines == 0 ? x : 24);
        size_t length = part_of(note, room, size);
        char text[256];
        snprintf(text, sizeof text, "%.*s", (int)length, note);
        if (lines == 0 && x > 24 && taut_label_width(text, size) > room) { /* all below */
            x = 24;
            lines = 1;
            continue;
        }
        if (legend->canvas != NULL) {
            write_text(legend, lines == 0 ? x : 24, y + lines * TAUT_LEGEND_LINE, size,
                       TAUT_ANCHOR_START, text);
        }
        lines++;
        note += length;
        note += *note != '\0' ? 2 : 0; /* the "; " */
    }
    return lines;
}

/* The longest of 1, 2, 5 times a power of ten that is no wider than this share of the page. */
static const double bar_share = 0.2;

double taut_legend_bar(const taut_legend *legend, const taut_camera *camera, double x, double y,
                       const char *unit)
{
    const double most = bar_share * legend->width / camera->scale * camera->half;
    const double power = taut_pow(10, floor(taut_log10(most)));
    const double first = most / power;
    const double length = power * (first >= 5 ? 5 : first >= 2 ? 2 : 1);
    const double end = x + length / camera->half * camera->scale;
    const double line[4][2] = {{x, y - 7}, {x, y}, {end, y}, {end, y - 7}};
    char number[48], text[64];

    if (!isfinite(end) || !(end > x)) {
        return x;
    }
    legend->ops->line(legend->canvas, 4, line, text_ink, 1.6);
    taut_label_short(length, number, sizeof number);
    snprintf(text, sizeof text, "%s %s", number, unit);
    write_text(legend, end + 10, y + 2, text_size - 2, TAUT_ANCHOR_START, text);
    return end + 10 + taut_label_width(text, text_size - 2);
}

void taut_legend_name(const taut_legend *legend, int row, taut_ink ink, int is_curve,
                      const char *name)
{
    const double x = legend->width - bar_from_right - 40, y = legend->top + 60 + 30.0 * row;
    char text[64];
    taut_label_clean(name, 13, text, sizeof text);
    draw_box(legend, x, is_curve ? y - 8 : y - 14, bar_width, is_curve ? 3 : 16, ink);
    write_text(legend, x + bar_width + 12, y, text_size, TAUT_ANCHOR_START, text);
}

void taut_legend_title(const taut_legend *legend, const char *title)
{
    char text[512];
    taut_label_clean(title, (size_t)(legend->width / (0.61 * title_size)), text, sizeof text);
    write_text(legend, legend->width / 2, 52, title_size, TAUT_ANCHOR_MIDDLE, text);
}

/* x, y, z from a corner of the page; an axis that points at the viewer is too short for a name. */
void taut_legend_axes(const taut_legend *legend, const taut_camera *camera, const double at[2])
{
    static const char *const names[] = {"x", "y", "z"};
    const double length = 46;
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
            legend->ops->text(legend->canvas, tip[0] + 15 * e[0], tip[1] + 15 * e[1] + 5,
                              fmax(16, legend->least), TAUT_ANCHOR_MIDDLE, light_ink, names[c]);
        }
    }
}
