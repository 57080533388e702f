/* canvas_cairo.c -- the drawing operations as PDF and PNG, by cairo.
 *
 * A PNG is drawn three times as large and then made smaller. Polygons are drawn without smoothing,
 * each point of the large page belonging to one of them: smoothed edges of neighbours would let the
 * ground shine through as a mesh of hairlines. */
#include "core/date.h"
#include "draw/canvas.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <string.h>

struct taut_canvas {
    const taut_page *page;
    cairo_surface_t *surface;
    cairo_t *cairo;
};

extern TAUT_API const taut_canvas_ops taut_module_table;

static cairo_status_t write_bytes(void *closure, const unsigned char *bytes, unsigned int count)
{
    const taut_page *page = closure;
    return page->write(page->context, bytes, count) ? CAIRO_STATUS_SUCCESS
                                                    : CAIRO_STATUS_WRITE_ERROR;
}

static taut_status status_of(cairo_status_t status)
{
    if (status == CAIRO_STATUS_SUCCESS) {
        return TAUT_OK;
    }
    if (status == CAIRO_STATUS_NO_MEMORY) {
        return TAUT_NO_MEMORY;
    }
    return status == CAIRO_STATUS_WRITE_ERROR ? TAUT_IO : TAUT_INTERNAL;
}

/* cairo would write the time of the day; an empty date leaves it out. */
static void set_metadata(cairo_surface_t *surface, const taut_page *page)
{
    char date[TAUT_DATE_ROOM] = "";

    if (page->date >= 0) {
        taut_date_text(page->date, date);
        strcat(date, "Z");
    }
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, date);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "taut");
    if (page->title != NULL) {
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, page->title);
    }
}

enum { OVERSAMPLING = 3 };

static int pixels_down(const taut_page *page)
{
    return (int)(page->pixels * page->height / page->width + 0.5);
}

/* PNG: as many pixels as asked for. PDF: as the page says. */
static taut_status cairo_begin(taut_canvas *canvas, const taut_page *page)
{
    const int png = strcmp(page->kind, "png") == 0;
    const double unit = png ? OVERSAMPLING * page->pixels / page->width : page->point;
    taut_status status = TAUT_OK;

    canvas->page = page;
    if (png) {
        canvas->surface = cairo_image_surface_create(
            CAIRO_FORMAT_RGB24, OVERSAMPLING * page->pixels, OVERSAMPLING * pixels_down(page));
    } else {
        canvas->surface = cairo_pdf_surface_create_for_stream(
            write_bytes, (void *)page, page->width * page->point, page->height * page->point);
        set_metadata(canvas->surface, page);
    }
    canvas->cairo = cairo_create(canvas->surface);
    cairo_scale(canvas->cairo, unit, unit);
    cairo_set_line_cap(canvas->cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(canvas->cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_select_font_face(canvas->cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_source_rgb(canvas->cairo, 1, 1, 1);
    cairo_paint(canvas->cairo);
    status = status_of(cairo_status(canvas->cairo));
    if (status != TAUT_OK) {
        cairo_destroy(canvas->cairo);
        cairo_surface_destroy(canvas->surface);
    }
    return status;
}

static void set_ink(cairo_t *cairo, taut_ink ink)
{
    cairo_set_source_rgb(cairo, ink.r / 255.0, ink.g / 255.0, ink.b / 255.0);
}

static void trace_path(cairo_t *cairo, int count, const double (*xy)[2])
{
    for (int i = 0; i < count; i++) {
        cairo_line_to(cairo, xy[i][0], xy[i][1]);
    }
}

static void cairo_polygon(taut_canvas *canvas, int count, const double (*xy)[2], taut_ink ink)
{
    set_ink(canvas->cairo, ink);
    trace_path(canvas->cairo, count, xy);
    cairo_close_path(canvas->cairo);
    cairo_set_antialias(canvas->cairo, CAIRO_ANTIALIAS_NONE);
    cairo_fill(canvas->cairo);
    cairo_set_antialias(canvas->cairo, CAIRO_ANTIALIAS_DEFAULT);
}

static void cairo_line(taut_canvas *canvas, int count, const double (*xy)[2], taut_ink ink,
                       double width)
{
    set_ink(canvas->cairo, ink);
    cairo_set_line_width(canvas->cairo, width);
    trace_path(canvas->cairo, count, xy);
    cairo_stroke(canvas->cairo);
}

static void cairo_disc(taut_canvas *canvas, const double xy[2], double radius, taut_ink ink,
                       taut_ink rim, double rim_width)
{
    cairo_arc(canvas->cairo, xy[0], xy[1], radius, 0, 6.283185307179586);
    set_ink(canvas->cairo, ink);
    cairo_fill_preserve(canvas->cairo);
    set_ink(canvas->cairo, rim);
    cairo_set_line_width(canvas->cairo, rim_width);
    cairo_stroke(canvas->cairo);
}

static void cairo_text(taut_canvas *canvas, double x, double y, double size, taut_anchor anchor,
                       taut_ink ink, const char *text)
{
    cairo_text_extents_t extents;
    cairo_set_font_size(canvas->cairo, size);
    cairo_text_extents(canvas->cairo, text, &extents);
    set_ink(canvas->cairo, ink);
    cairo_move_to(canvas->cairo, x - 0.5 * (double)anchor * extents.x_advance, y);
    cairo_show_text(canvas->cairo, text);
    cairo_new_path(canvas->cairo);
}

/* A new page is not white but empty; its size is in points. */
static void cairo_next_page(taut_canvas *canvas, double width, double height)
{
    cairo_show_page(canvas->cairo);
    if (strcmp(canvas->page->kind, "pdf") == 0) {
        cairo_pdf_surface_set_size(canvas->surface, width * canvas->page->point,
                                   height * canvas->page->point);
    }
}

static void cairo_turned_text(taut_canvas *canvas, double x, double y, double size, double angle,
                              taut_ink ink, const char *text)
{
    cairo_save(canvas->cairo);
    cairo_translate(canvas->cairo, x, y);
    cairo_rotate(canvas->cairo, angle);
    cairo_text(canvas, 0, 0.35 * size, size, TAUT_ANCHOR_MIDDLE, ink, text);
    cairo_restore(canvas->cairo);
}

/* The page, each pixel the mean of OVERSAMPLING^2. */
static cairo_status_t write_png(const taut_canvas *canvas)
{
    cairo_surface_t *small = cairo_image_surface_create(CAIRO_FORMAT_RGB24, canvas->page->pixels,
                                                        pixels_down(canvas->page));
    cairo_t *cairo = cairo_create(small);
    cairo_status_t status = CAIRO_STATUS_SUCCESS;

    cairo_scale(cairo, 1.0 / OVERSAMPLING, 1.0 / OVERSAMPLING);
    cairo_set_source_surface(cairo, canvas->surface, 0, 0);
    cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_GOOD);
    cairo_paint(cairo);
    status = cairo_status(cairo);
    cairo_destroy(cairo);
    if (status == CAIRO_STATUS_SUCCESS) {
        status = cairo_surface_write_to_png_stream(small, write_bytes, (void *)canvas->page);
    }
    cairo_surface_destroy(small);
    return status;
}

static taut_status cairo_finish(taut_canvas *canvas)
{
    cairo_status_t status = cairo_status(canvas->cairo);
    cairo_destroy(canvas->cairo);
    if (status == CAIRO_STATUS_SUCCESS && strcmp(canvas->page->kind, "png") == 0) {
        status = write_png(canvas);
    }
    cairo_surface_finish(canvas->surface);
    if (status == CAIRO_STATUS_SUCCESS) {
        status = cairo_surface_status(canvas->surface);
    }
    cairo_surface_destroy(canvas->surface);
    return status_of(status);
}

const taut_canvas_ops taut_module_table = {
    .size = sizeof(taut_canvas),
    .begin = cairo_begin,
    .polygon = cairo_polygon,
    .line = cairo_line,
    .disc = cairo_disc,
    .text = cairo_text,
    .next_page = cairo_next_page,
    .turned_text = cairo_turned_text,
    .finish = cairo_finish,
};
