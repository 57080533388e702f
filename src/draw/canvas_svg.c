/* canvas_svg.c -- the drawing operations as SVG 1.1.
 *
 * Written here and not by cairo, which would turn letters into outlines (nobody could search or
 * edit a legend) and write every coordinate with eight digits: a figure is a fifth of that size.
 * Coordinates are whole tenths or hundredths of a page unit, later points of a shape relative to
 * the one before, rounded so that nothing adds up. Numbers are put together from integers: no
 * locale has a say.
 */
#include "draw/canvas.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { BUFFER = 4096, ITEM_MAX = 64 };

struct taut_canvas {
    const taut_page *page;
    int failed;
    size_t used;
    char buffer[BUFFER];
};

static void flush_text(taut_canvas *canvas)
{
    if (!canvas->failed && canvas->used > 0) {
        canvas->failed = !canvas->page->write(canvas->page->context, canvas->buffer, canvas->used);
    }
    canvas->used = 0;
}

static void put_bytes(taut_canvas *canvas, const char *bytes, size_t count)
{
    while (count > 0) {
        const size_t room = BUFFER - canvas->used;
        const size_t part = count < room ? count : room;
        memcpy(canvas->buffer + canvas->used, bytes, part);
        canvas->used += part;
        bytes += part;
        count -= part;
        if (canvas->used == BUFFER) {
            flush_text(canvas);
        }
    }
}

static void put_text(taut_canvas *canvas, const char *text)
{
    put_bytes(canvas, text, strlen(text));
}

/* value / 100 with no digit more than needed. */
static void put_hundredths(taut_canvas *canvas, int64_t value)
{
    char text[ITEM_MAX];
    size_t at = sizeof text;
    const int64_t size = value < 0 ? -value : value;
    int64_t rest = size % 100, whole = size / 100;

    if (rest != 0) {
        if (rest % 10 != 0) {
            text[--at] = (char)('0' + rest % 10);
        }
        text[--at] = (char)('0' + rest / 10);
        text[--at] = '.';
    }
    while (whole > 0 || at == sizeof text) {
        text[--at] = (char)('0' + whole % 10);
        whole /= 10;
    }
    if (value < 0) {
        text[--at] = '-';
    }
    put_bytes(canvas, text + at, sizeof text - at);
}

static void put_number(taut_canvas *canvas, double value)
{
    put_hundredths(canvas, llround(100 * value));
}

static void put_attribute(taut_canvas *canvas, const char *name, double value)
{
    put_text(canvas, " ");
    put_text(canvas, name);
    put_text(canvas, "=\"");
    put_number(canvas, value);
    put_text(canvas, "\"");
}

static void put_ink(taut_canvas *canvas, const char *name, taut_ink ink)
{
    static const char digit[] = "0123456789abcdef";
    const char text[8] = {'#',
                          digit[ink.r / 16],
                          digit[ink.r % 16],
                          digit[ink.g / 16],
                          digit[ink.g % 16],
                          digit[ink.b / 16],
                          digit[ink.b % 16],
                          '"'};
    put_text(canvas, " ");
    put_text(canvas, name);
    put_text(canvas, "=\"");
    put_bytes(canvas, text, sizeof text);
}

static void put_escaped(taut_canvas *canvas, const char *text)
{
    for (; *text != '\0'; text++) {
        if (*text == '<') {
            put_text(canvas, "&lt;");
        } else if (*text == '>') {
            put_text(canvas, "&gt;");
        } else if (*text == '&') {
            put_text(canvas, "&amp;");
        } else {
            put_bytes(canvas, text, 1);
        }
    }
}

/* d="Mx,y lx,y x,y ...": relative steps of whole `unit` hundredths. A minus sign separates. */
static void put_path(taut_canvas *canvas, int count, const double (*xy)[2], int64_t unit,
                     const char *end)
{
    int64_t last[2] = {0, 0};
    put_text(canvas, " d=\"");
    for (int i = 0; i < count; i++) {
        put_text(canvas, i == 0 ? "M" : i == 1 ? "l" : "");
        for (int c = 0; c < 2; c++) {
            const int64_t at = llround(xy[i][c] * 100 / (double)unit) * unit;
            const int64_t step = at - last[c];
            if ((c > 0 || i > 1) && step >= 0) {
                put_text(canvas, " ");
            }
            put_hundredths(canvas, step);
            last[c] = at;
        }
    }
    put_text(canvas, end);
}

static taut_status svg_begin(taut_canvas *canvas, const taut_page *page)
{
    canvas->page = page;
    put_text(canvas, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                     "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"");
    put_number(canvas, page->width * page->point);
    put_text(canvas, "pt\" height=\"");
    put_number(canvas, page->height * page->point);
    put_text(canvas, "pt\" viewBox=\"0 0 ");
    put_number(canvas, page->width);
    put_text(canvas, " ");
    put_number(canvas, page->height);
    put_text(canvas, "\" role=\"img\">\n");
    if (page->title != NULL) {
        put_text(canvas, "<title>");
        put_escaped(canvas, page->title);
        put_text(canvas, "</title>\n");
    }
    /* shapes that share an edge share its pixels: smoothed, the edge would show between them */
    put_text(canvas, "<style>path:not([stroke]){shape-rendering:crispEdges}</style>\n"
                     "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
                     "<g font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" "
                     "stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
    return TAUT_OK;
}

static void svg_polygon(taut_canvas *canvas, int count, const double (*xy)[2], taut_ink ink)
{
    put_text(canvas, "<path");
    put_ink(canvas, "fill", ink);
    put_path(canvas, count, xy, 10, "z\"/>\n");
}

static void svg_line(taut_canvas *canvas, int count, const double (*xy)[2], taut_ink ink,
                     double width)
{
    put_text(canvas, "<path fill=\"none\"");
    put_ink(canvas, "stroke", ink);
    put_attribute(canvas, "stroke-width", width);
    put_path(canvas, count, xy, 5, "\"/>\n");
}

static void svg_disc(taut_canvas *canvas, const double xy[2], double radius, taut_ink ink,
                     taut_ink rim, double rim_width)
{
    put_text(canvas, "<circle");
    put_attribute(canvas, "cx", xy[0]);
    put_attribute(canvas, "cy", xy[1]);
    put_attribute(canvas, "r", radius);
    put_ink(canvas, "fill", ink);
    put_ink(canvas, "stroke", rim);
    put_attribute(canvas, "stroke-width", rim_width);
    put_text(canvas, "/>\n");
}

static void svg_text(taut_canvas *canvas, double x, double y, double size, taut_anchor anchor,
                     taut_ink ink, const char *text)
{
    static const char *const anchors[] = {"", " text-anchor=\"middle\"", " text-anchor=\"end\""};
    put_text(canvas, "<text");
    put_attribute(canvas, "x", x);
    put_attribute(canvas, "y", y);
    put_attribute(canvas, "font-size", size);
    put_text(canvas, anchors[anchor]);
    put_ink(canvas, "fill", ink);
    put_text(canvas, ">");
    put_escaped(canvas, text);
    put_text(canvas, "</text>\n");
}

static taut_status svg_finish(taut_canvas *canvas)
{
    put_text(canvas, "</g>\n</svg>\n");
    flush_text(canvas);
    return canvas->failed ? TAUT_IO : TAUT_OK;
}

const taut_canvas_ops taut_canvas_svg = {
    .size = sizeof(taut_canvas),
    .begin = svg_begin,
    .polygon = svg_polygon,
    .line = svg_line,
    .disc = svg_disc,
    .text = svg_text,
    .finish = svg_finish,
};
