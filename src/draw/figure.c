/* figure.c -- from a model to a page: choose what is drawn, sample it, aim the camera, cut into
 * pieces, paint. */
#include "draw/figure.h"

#include "core/arena.h"
#include "core/fail.h"
#include "core/module.h"
#include "draw/colour.h"
#include "draw/label.h"
#include "draw/legend.h"
#include "draw/parts.h"
#include "draw/strip.h"
#include "draw/view.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double page_width = 1200, page_height = 900;

typedef struct polyline {
    const taut_curve *curve;
    size_t count;
    double *points;
} polyline;

/* All of one figure. */
typedef struct figure {
    const taut_model *model;
    taut_write_options options;
    int vector; /* svg, pdf: fewer pieces */
    taut_arena *arena;
    int sheet_count, curve_count;
    taut_sheet *sheets;
    polyline *curves;
    taut_camera camera;
    taut_scene scene;
    double limit; /* of the colours */
    int cut, has_grey;
} figure;

static int is_drawn(const figure *f, const char *name)
{
    return f->options.surface == NULL || strcmp(f->options.surface, name) == 0;
}

static int interrupted(const figure *f, double done)
{
    const taut_monitor *monitor = &f->options.monitor;
    return monitor->progress != NULL && monitor->progress(monitor->context, done, "drawing") != 0;
}

/* Cells for each of `sheets` surfaces: the more there are, the fewer each. */
static int cells_each(const figure *f, int sheets)
{
    const int one = f->vector ? 3600 : 20000, all = f->vector ? 7200 : 60000;
    const int share = all / (sheets > 0 ? sheets : 1);
    const int least = sheets <= 1000 ? 64 : 4;
    return share > one ? one : share < least ? least : share;
}

static taut_status sample_surfaces(figure *f, taut_error *error)
{
    const int all = taut_model_surface_count(f->model);
    int drawn = 0;
    taut_status status = TAUT_OK;

    for (int i = 0; i < all; i++) {
        drawn += is_drawn(f, taut_surface_name(taut_model_surface(f->model, i)));
    }
    if (f->options.surface != NULL && drawn == 0) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, NULL, 0, 1, "no surface is named \"%s\"",
                         f->options.surface);
    }
    f->sheets = taut_arena_take(f->arena, (size_t)drawn, sizeof *f->sheets);
    if (f->sheets == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < all && status == TAUT_OK; i++) {
        const taut_surface *surface = taut_model_surface(f->model, i);
        if (is_drawn(f, taut_surface_name(surface))) {
            status = interrupted(f, 0.5 * f->sheet_count / drawn)
                         ? TAUT_INTERRUPTED
                         : taut_sheet_new(surface, cells_each(f, drawn),
                                          (f->vector ? 40000 : 1000000) / drawn + 1, &f->options,
                                          f->arena, &f->sheets[f->sheet_count++]);
        }
    }
    return status == TAUT_OK ? TAUT_OK
                             : taut_fail(error, status, NULL, taut_none, taut_none, "%s",
                                         taut_status_text(status));
}

static taut_status sample_curves(figure *f, taut_error *error)
{
    const int count = f->options.surface == NULL ? taut_model_curve_count(f->model) : 0;
    const int most = count > 1000 ? 16 : f->vector ? 120 : 400;
    taut_status status = TAUT_OK;

    f->curves = taut_arena_take(f->arena, (size_t)count, sizeof *f->curves);
    if (f->curves == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        polyline *line = &f->curves[f->curve_count++];
        line->curve = taut_model_curve(f->model, i);
        status = taut_parts_sample_curve(line->curve, most, f->arena, &line->count, &line->points);
    }
    return status == TAUT_OK ? TAUT_OK
                             : taut_fail(error, status, NULL, taut_none, taut_none, "%s",
                                         taut_status_text(status));
}

static size_t cell_count(const taut_sheet *sheet)
{
    return (size_t)(sheet->u.count - 1) * (size_t)(sheet->v.count - 1);
}

/* Rows of names beside a figure of several plain things, too many for none. */
static int names_shown(const figure *f)
{
    const int things = f->sheet_count + f->curve_count;
    return f->options.colour == TAUT_COLOUR_PLAIN && things > 1 && things <= TAUT_LEGEND_ROWS
               ? things
               : 0;
}

/* visit(camera, count, points) for all that is drawn, nets included. */
static void visit_points(figure *f, void (*visit)(taut_camera *, size_t, const double *))
{
    const int net = !f->options.no_net;
    for (int i = 0; i < f->sheet_count; i++) {
        const taut_sheet *s = &f->sheets[i];
        visit(&f->camera, (size_t)s->u.count * (size_t)s->v.count, s->points);
        if (net) {
            visit(&f->camera,
                  (size_t)taut_basis_count(taut_surface_u(s->surface)) *
                      (size_t)taut_basis_count(taut_surface_v(s->surface)),
                  taut_surface_points(s->surface));
        }
    }
    for (int i = 0; i < f->curve_count; i++) {
        const polyline *line = &f->curves[i];
        visit(&f->camera, line->count, line->points);
        if (net) {
            visit(&f->camera, (size_t)taut_basis_count(taut_curve_t(line->curve)),
                  taut_curve_points(line->curve));
        }
    }
}

/* The camera on all of it: 0 when nothing of it is finite. */
static int aim(figure *f)
{
    const int wide = f->options.colour != TAUT_COLOUR_PLAIN || names_shown(f) > 0;
    const double frame[4] = {60, f->options.title != NULL ? 90 : 60, page_width - (wide ? 220 : 60),
                             page_height - 60};

    taut_camera_init(&f->camera);
    visit_points(f, taut_camera_include);
    if (!taut_camera_settle(&f->camera)) {
        return 0;
    }
    if (f->options.has_view) {
        taut_camera_aim(&f->camera, f->options.view[0], f->options.view[1]);
    } else {
        taut_view_aim(&f->camera, f->sheet_count, f->sheets);
    }
    visit_points(f, taut_camera_see);
    taut_camera_fit(&f->camera, frame);
    return 1;
}

/* One range for all surfaces. Curvature is in units of 1/size (H) or 1/size^2 (K); what is below
 * 1e-9 of that is rounding of second derivatives; the power of ten above that ends the scale at the
 * least. */
static taut_status choose_limit(figure *f)
{
    const double size = f->camera.half;
    const double rounding =
        f->options.colour == TAUT_COLOUR_MEAN ? 1e-9 / size : 1e-9 / size / size;
    const double noise = pow(10, ceil(log10(fmin(fmax(rounding, 1e-290), 1e290))));
    size_t count = 0, at = 0;
    double *values = NULL;

    for (int i = 0; i < f->sheet_count; i++) {
        count += cell_count(&f->sheets[i]);
    }
    values = taut_arena_take(f->arena, count, sizeof *values);
    if (values == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < f->sheet_count; i++) {
        const size_t cells = cell_count(&f->sheets[i]);
        memcpy(values + at, f->sheets[i].values, cells * sizeof *values);
        at += cells;
    }
    for (size_t i = 0; i < count; i++) {
        f->has_grey |= isnan(values[i]);
    }
    f->limit = taut_colour_limit(count, values, noise, &f->cut);
    return TAUT_OK;
}

static taut_status add_net(figure *f, const taut_surface *s)
{
    return taut_parts_net(taut_basis_count(taut_surface_u(s)), taut_basis_count(taut_surface_v(s)),
                          taut_surface_points(s), &f->camera, f->arena, &f->scene);
}

/* Knot lines say nothing beside a net so dense that it lies in the surface. */
static int has_knot_lines(const figure *f, const taut_surface *s)
{
    return f->options.no_net || taut_parts_net_is_whole(taut_basis_count(taut_surface_u(s)),
                                                        taut_basis_count(taut_surface_v(s)));
}

/* All cells, then the lines of every surface, the boundaries last: they must not be paler where a
 * net runs along them. */
static taut_status add_surfaces(figure *f)
{
    double **pages = taut_arena_take(f->arena, (size_t)f->sheet_count, sizeof *pages);
    taut_status status = pages != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    for (int i = 0; i < f->sheet_count && status == TAUT_OK; i++) {
        status = taut_parts_cells(&f->sheets[i], &f->camera, taut_colour_plain(i), f->limit,
                                  f->arena, &f->scene, &pages[i]);
    }
    for (int i = 0; i < f->sheet_count && status == TAUT_OK; i++) {
        const taut_sheet *sheet = &f->sheets[i];
        status = taut_parts_silhouette(sheet, pages[i], f->arena, &f->scene);
        if (status == TAUT_OK && has_knot_lines(f, sheet->surface)) {
            status =
                taut_parts_outline(sheet, pages[i], 0, taut_colour_plain(i), f->arena, &f->scene);
        }
        if (status == TAUT_OK && !f->options.no_net) {
            status = add_net(f, sheet->surface);
        }
    }
    for (int i = 0; i < f->sheet_count && status == TAUT_OK; i++) {
        status = taut_parts_outline(&f->sheets[i], pages[i], 1, taut_colour_plain(i), f->arena,
                                    &f->scene);
    }
    return status;
}

/* The curves with their polygons, and on top the points of all nets. */
static taut_status add_curves(figure *f)
{
    taut_status status = TAUT_OK;
    for (int i = 0; i < f->curve_count && status == TAUT_OK; i++) {
        const taut_curve *c = f->curves[i].curve;
        status = taut_parts_curve(f->curves[i].count, f->curves[i].points, &f->camera,
                                  taut_colour_curve(i), f->arena, &f->scene);
        if (status == TAUT_OK && !f->options.no_net) {
            status = taut_parts_net(1, taut_basis_count(taut_curve_t(c)), taut_curve_points(c),
                                    &f->camera, f->arena, &f->scene);
        }
    }
    for (int i = 0; i < f->sheet_count && !f->options.no_net; i++) {
        const taut_surface *s = f->sheets[i].surface;
        taut_parts_net_points(taut_basis_count(taut_surface_u(s)),
                              taut_basis_count(taut_surface_v(s)), taut_surface_points(s),
                              &f->camera, &f->scene);
    }
    for (int i = 0; i < f->curve_count && !f->options.no_net; i++) {
        const taut_curve *c = f->curves[i].curve;
        taut_parts_net_points(1, taut_basis_count(taut_curve_t(c)), taut_curve_points(c),
                              &f->camera, &f->scene);
    }
    return status == TAUT_OK ? f->scene.status : status;
}

static void draw_legend(const figure *f, const taut_legend *legend)
{
    const int shown = names_shown(f);
    if (f->options.title != NULL) {
        taut_legend_title(legend, f->options.title);
    }
    if (f->options.colour != TAUT_COLOUR_PLAIN && f->sheet_count > 0) {
        taut_legend_scale(legend, f->options.colour, f->limit, f->cut, f->has_grey,
                          taut_model_unit(f->model));
    }
    for (int row = 0; row < shown; row++) {
        const int curve = row - f->sheet_count;
        if (curve < 0) {
            taut_legend_name(legend, row, taut_colour_plain(row), 0,
                             taut_surface_name(f->sheets[row].surface));
        } else {
            taut_legend_name(legend, row, taut_colour_curve(curve), 1,
                             taut_curve_name(f->curves[curve].curve));
        }
    }
}

static int write_bytes(void *context, const void *bytes, size_t count)
{
    return fwrite(bytes, 1, count, context) == count;
}

/* SOURCE_DATE_EPOCH, or -1 where it is not a second of the years 1970 to 9999. */
static long long source_date(void)
{
    const char *text = getenv("SOURCE_DATE_EPOCH");
    char *end = NULL;
    const long long date = text != NULL ? strtoll(text, &end, 10) : -1;
    return text != NULL && end != text && *end == '\0' && date >= 0 && date <= 253402300799LL ? date
                                                                                              : -1;
}

static taut_status paint(figure *f, const taut_canvas_ops *ops, const char *kind, FILE *out,
                         taut_error *error)
{
    char title[512] = "";
    taut_page page = {.kind = kind,
                      .width = page_width,
                      .height = page_height,
                      .date = source_date(),
                      .write = write_bytes,
                      .context = out};
    taut_canvas *canvas = taut_arena_take(f->arena, 1, ops->size);
    const taut_legend legend = {ops, canvas, page_width, page_height};
    taut_status status = TAUT_NO_MEMORY;

    if (f->options.title != NULL) {
        taut_label_clean(f->options.title, sizeof title, title, sizeof title);
        page.title = title;
    }
    errno = 0;
    if (canvas != NULL) {
        status = ops->begin(canvas, &page);
    }
    if (status == TAUT_OK) {
        taut_legend_axes(&legend, &f->camera);
        taut_scene_paint(&f->scene, ops, canvas);
        draw_legend(f, &legend);
        status = ops->finish(canvas);
    }
    if (status == TAUT_OK && (fflush(out) != 0 || ferror(out))) {
        status = TAUT_IO;
    }
    if (status == TAUT_IO) {
        char reason[128] = "the device took no more";
        if (errno != 0) {
            strerror_r(errno, reason, sizeof reason);
        }
        return taut_fail(error, TAUT_IO, NULL, taut_none, taut_none,
                         "the figure could not be written: %s", reason);
    }
    return status == TAUT_OK ? TAUT_OK
                             : taut_fail(error, status, NULL, taut_none, taut_none, "%s",
                                         taut_status_text(status));
}

static taut_status draw(figure *f, const taut_canvas_ops *ops, const char *kind, FILE *out,
                        taut_error *error)
{
    taut_status status = sample_surfaces(f, error);
    if (status == TAUT_OK) {
        status = sample_curves(f, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    if (!aim(f)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, NULL, 0, 1,
                         "there is nothing to draw: no surface or curve has a finite point");
    }
    if (f->options.colour != TAUT_COLOUR_PLAIN) {
        status = choose_limit(f);
    }
    if (status == TAUT_OK) {
        status = taut_scene_init(&f->scene, page_width, page_height, f->arena);
    }
    if (status == TAUT_OK) {
        status = add_surfaces(f);
    }
    if (status == TAUT_OK) {
        status = add_curves(f);
    }
    if (status == TAUT_OK && interrupted(f, 0.7)) {
        status = TAUT_INTERRUPTED;
    }
    return status == TAUT_OK ? paint(f, ops, kind, out, error)
                             : taut_fail(error, status, NULL, taut_none, taut_none, "%s",
                                         taut_status_text(status));
}

/* The table that draws this kind; cairo is loaded for what needs it. */
static taut_status find_canvas(const char *kind, const taut_canvas_ops **ops, taut_error *error)
{
    const void *table = NULL;
    taut_status status = TAUT_OK;
    if (strcmp(kind, "svg") == 0) {
        *ops = &taut_canvas_svg;
        return TAUT_OK;
    }
    if (strcmp(kind, "pdf") != 0 && strcmp(kind, "png") != 0) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, NULL, taut_none, taut_none,
                         "no figure is of kind \"%s\", only svg, pdf and png", kind);
    }
    status = taut_module_load("cairo", "libcairo2-dev", &table, error);
    *ops = table;
    return status;
}

static taut_status check(const taut_write_options *options, taut_error *error)
{
    const double a = options->view[0], e = options->view[1];
    if (options->has_view && !(isfinite(a) && e >= -90 && e <= 90)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, NULL, isfinite(a) ? e : a,
                         isfinite(a) ? 90 : taut_none,
                         "a view needs a finite azimuth and an elevation from -90 to 90 degrees");
    }
    if (options->divide < 0 || options->threads < 0 || options->threads > TAUT_THREADS_MAX) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, NULL,
                         options->divide < 0 ? options->divide : options->threads, taut_none,
                         "divide and threads must not be negative, nor threads above %d",
                         TAUT_THREADS_MAX);
    }
    return TAUT_OK;
}

taut_status taut_draw_figure(const taut_model *model, const taut_write_options *options,
                             const char *kind, FILE *out, taut_error *error)
{
    const taut_canvas_ops *ops = NULL;
    figure f = {.model = model, .limit = 1};
    taut_model *strip = NULL;
    taut_status status = TAUT_OK;

    if (model == NULL || kind == NULL || out == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, NULL, taut_none, taut_none,
                         "a figure needs a model, a kind and a stream");
    }
    if (options != NULL) {
        f.options = *options;
    }
    status = check(&f.options, error);
    if (status == TAUT_OK) {
        status = find_canvas(kind, &ops, error);
    }
    if (status == TAUT_OK && taut_strip_is(model, &f.options)) {
        status = taut_strip_new(model, &f.options, &strip);
        f.model = strip;
        if (status != TAUT_OK) {
            return taut_fail(error, status, NULL, taut_none, taut_none, "%s",
                             taut_status_text(status));
        }
    }
    if (status == TAUT_OK) {
        f.vector = strcmp(kind, "png") != 0;
        f.arena = taut_arena_new();
        status = f.arena != NULL ? draw(&f, ops, kind, out, error) : taut_fail_memory(error);
    }
    taut_scene_clear(&f.scene);
    taut_arena_free(f.arena);
    taut_model_free(strip);
    return status;
}
