/* figure.c -- from models to a page: choose what is drawn, sample it, aim the cameras, cut into
 * pieces, paint. */
#include "draw/figure.h"
#include "draw/flat_page.h"
#include "draw/flat_svg.h"

#include "core/arena.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "draw/flat_svg.h"
#include "draw/label.h"
#include "draw/legend.h"
#include "draw/pane.h"
#include "draw/panes.h"
#include "io/flat/flat.h"
#include "io/format.h"
#include "mesh/colour.h"
#include "platform/module.h"
#include "platform/system.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static const double page_width = 1200, page_height = 900;

/* All of one figure. */
typedef struct figure {
    taut_write_options options;
    int vector;               /* svg, pdf: fewer pieces */
    const taut_model *pieces; /* laths to cut on a page of their own, or NULL */
    taut_arena *arena;
    taut_panes panes;
    taut_scene scene;
    double limit; /* of the colours */
    int cut, has_grey;
} figure;

static int is_interrupted(const figure *f, double done)
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

static taut_status sample_panes(figure *f)
{
    const int sheets = taut_panes_sheets(&f->panes, &f->options);
    const int most = (f->vector ? 40000 : 1000000) / (sheets > 0 ? sheets : 1) + 1;
    taut_status status = TAUT_OK;

    for (int i = 0; i < f->panes.count && status == TAUT_OK; i++) {
        status = is_interrupted(f, 0.5 * i / f->panes.count)
                     ? TAUT_INTERRUPTED
                     : taut_pane_sample(&f->panes.pane[i], &f->options, cells_each(f, sheets), most,
                                        f->vector ? 120 : 400, f->arena);
    }
    return status;
}

/* Rows of names beside a figure of several plain things, too many for none. */
static int names_shown(const figure *f)
{
    const taut_pane *pane = f->panes.pane;
    const int things = f->panes.count == 1 ? pane->sheet_count + pane->curve_count : 0;
    return f->options.colour == TAUT_COLOUR_PLAIN && things > 1 && things <= TAUT_LEGEND_ROWS
               ? things
               : 0;
}

static size_t cell_count(const taut_sheet *sheet)
{
    return (size_t)(sheet->u.count - 1) * (size_t)(sheet->v.count - 1);
}

/* What a value below is rounding: 1e-9 of 1/size (H), 1/size^2 (K) or 1; the power of ten above
 * that ends the scale at the least. */
static double noise_of(const figure *f)
{
    const double size = f->panes.pane[0].camera.half;
    const double unit[] = {[TAUT_COLOUR_PLAIN] = 1,
                           [TAUT_COLOUR_MEAN] = 1 / size,
                           [TAUT_COLOUR_GAUSSIAN] = 1 / size / size,
                           [TAUT_COLOUR_ISOTHERMALITY] = 1,
                           [TAUT_COLOUR_GAP] = 1e-15};
    return taut_pow(10,
                    ceil(taut_log10(fmin(fmax(1e-9 * unit[f->options.colour], 1e-290), 1e290))));
}

/* One range for all surfaces. */
static taut_status choose_limit(figure *f)
{
    size_t count = 0, at = 0;
    double *values = NULL;

    for (int p = 0; p < f->panes.count; p++) {
        for (int i = 0; i < f->panes.pane[p].sheet_count; i++) {
            count += cell_count(&f->panes.pane[p].sheets[i]);
        }
    }
    values = taut_arena_take(f->arena, count, sizeof *values);
    if (values == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int p = 0; p < f->panes.count; p++) {
        for (int i = 0; i < f->panes.pane[p].sheet_count; i++) {
            const taut_sheet *sheet = &f->panes.pane[p].sheets[i];
            memcpy(values + at, sheet->values, cell_count(sheet) * sizeof *values);
            at += cell_count(sheet);
        }
    }
    for (size_t i = 0; i < count; i++) {
        f->has_grey |= isnan(values[i]);
    }
    f->limit = taut_colour_limit(count, values, noise_of(f), &f->cut);
    return TAUT_OK;
}

/* All cells before any line, as lines are judged by the depth of what is there. */
static taut_status add_all(figure *f)
{
    taut_status status = TAUT_OK;
    for (int i = 0; i < f->panes.count && status == TAUT_OK; i++) {
        status = taut_pane_add_cells(&f->panes.pane[i], &f->options, f->limit, f->arena, &f->scene);
    }
    for (int i = 0; i < f->panes.count && status == TAUT_OK; i++) {
        status = taut_pane_add_lines(&f->panes.pane[i], &f->options, f->limit, f->arena, &f->scene);
    }
    for (int i = 0; i < f->panes.count && status == TAUT_OK; i++) {
        status = taut_pane_add_curves(&f->panes.pane[i], &f->options, f->arena, &f->scene);
    }
    return status;
}

static void draw_names(const figure *f, const taut_legend *legend)
{
    const taut_pane *pane = f->panes.pane;
    const int shown = names_shown(f);
    for (int row = 0; row < shown; row++) {
        const int curve = row - pane->sheet_count;
        if (curve < 0) {
            taut_legend_name(legend, row, taut_colour_plain(row), 0,
                             taut_surface_name(pane->sheets[row].surface));
        } else {
            taut_legend_name(legend, row, taut_colour_curve(curve), 1,
                             taut_curve_name(pane->curves[curve].curve));
        }
    }
}

static void draw_legend(const figure *f, const taut_legend *legend)
{
    const taut_write_options *o = &f->options;
    char note[256] = "";

    if (o->title != NULL) {
        taut_legend_title(legend, o->title);
    }
    if (o->colour != TAUT_COLOUR_PLAIN && taut_panes_sheets(&f->panes, o) > 0) {
        taut_legend_scale(legend, o->colour, f->limit, f->cut, f->has_grey,
                          taut_model_unit(f->panes.pane[0].model));
    }
    for (int i = 0; i < f->panes.count; i++) {
        if (f->panes.pane[i].label != NULL) {
            taut_legend_label(legend, f->panes.place[i], f->panes.pane[i].label);
        }
    }
    draw_names(f, legend);
    taut_panes_note(&f->panes, o, f->limit, note, sizeof note);
    taut_legend_note(legend, note);
}

static int write_bytes(void *context, const void *bytes, size_t count)
{
    return fwrite(bytes, 1, count, context) == count;
}

/* SOURCE_DATE_EPOCH, or -1 where it is not a second of the years 1970 to 9999. */
static int64_t source_date(void)
{
    const char *text = getenv("SOURCE_DATE_EPOCH");
    char *end = NULL;
    const int64_t date = text != NULL ? strtoll(text, &end, 10) : -1;
    return text != NULL && end != text && *end == '\0' && date >= 0 && date <= INT64_C(253402300799)
               ? date
               : -1;
}

/* TAUT_IO when the bytes do not arrive. */
static taut_status paint_page(figure *f, const taut_canvas_ops *ops, const char *kind, FILE *out)
{
    char title[512] = "";
    taut_page page = {.kind = kind,
                      .width = page_width,
                      .height = page_height,
                      .date = source_date(),
                      .pixels = f->options.width > 0 ? f->options.width : (int)page_width,
                      .write = write_bytes,
                      .context = out};
    taut_canvas *canvas = taut_arena_take(f->arena, 1, ops->size);
    const taut_legend legend = {ops, canvas, page_width, page_height};

    if (canvas == NULL) {
        return TAUT_NO_MEMORY;
    }
    if (f->options.title != NULL) {
        taut_label_clean(f->options.title, sizeof title, title, sizeof title);
        page.title = title;
    }
    errno = 0;
    taut_status status = ops->begin(canvas, &page);
    if (status != TAUT_OK) {
        return status;
    }
    taut_legend_axes(&legend, &f->panes.pane[0].camera);
    taut_scene_paint(&f->scene, ops, canvas);
    draw_legend(f, &legend);
    const taut_status sheets =
        f->pieces != NULL ? taut_flat_page(f->pieces, ops, canvas, f->arena, NULL) : TAUT_OK;
    status = ops->finish(canvas);
    if (status != TAUT_OK || sheets != TAUT_OK) {
        return sheets != TAUT_OK ? sheets : status;
    }
    return fflush(out) != 0 || ferror(out) ? TAUT_IO : TAUT_OK;
}

/* What paint_page() says, in words; errno is of its last write. */
static taut_status fail_painting(taut_status status, taut_error *error)
{
    char text[128];
    if (status != TAUT_IO) {
        return taut_fail_status(error, status);
    }
    return taut_fail(
        error, TAUT_IO, "write", NULL, taut_none, taut_none, "the figure could not be written: %s",
        errno != 0 ? taut_system_reason(errno, text, sizeof text) : "the device took no more");
}

/* Everything up to the page, from sampled panes that are aimed. */
static taut_status make_scene(figure *f)
{
    if (f->options.colour != TAUT_COLOUR_PLAIN && choose_limit(f) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_status status = taut_scene_init(&f->scene, page_width, page_height, f->arena);
    if (status != TAUT_OK) {
        return status;
    }
    status = add_all(f);
    return status == TAUT_OK && is_interrupted(f, 0.7) ? TAUT_INTERRUPTED : status;
}

static taut_status draw_panes(figure *f, const taut_canvas_ops *ops, const char *kind, FILE *out,
                              taut_error *error)
{
    const int wide = f->options.colour != TAUT_COLOUR_PLAIN;
    taut_status status = sample_panes(f);

    if (status != TAUT_OK) {
        return taut_fail_status(error, status);
    }
    const double title = f->options.title == NULL ? 0 : f->panes.count > 1 ? 60 : 30;
    const double page[4] = {0, title, page_width - (wide || names_shown(f) > 0 ? 160 : 0),
                            page_height};
    if (!taut_panes_aim(&f->panes, &f->options, page)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, 0, 1,
                         "there is nothing to draw: no surface or curve has a finite point");
    }
    status = make_scene(f);
    if (status != TAUT_OK) {
        return taut_fail_status(error, status);
    }
    status = paint_page(f, ops, kind, out);
    return status == TAUT_OK ? TAUT_OK : fail_painting(status, error);
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
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "no figure is of kind \"%s\", only svg, pdf and png", kind);
    }
    status = taut_module_load("cairo", "libcairo2-dev", &table, error);
    *ops = table;
    return status;
}

static taut_status check_numbers(const taut_write_options *o, taut_error *error)
{
    const int least[] = {o->divide, o->threads, o->isolines, o->reflections, o->width};
    const int most[] = {INT_MAX, TAUT_THREADS_MAX, TAUT_ISOLINES_MAX, TAUT_LIGHTS_MAX,
                        TAUT_WIDTH_MAX};
    static const char *const names[] = {"divide", "threads", "isolines", "reflections", "width"};
    for (size_t i = 0; i < sizeof least / sizeof least[0]; i++) {
        if (least[i] < 0 || least[i] > most[i]) {
            return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, least[i], most[i],
                             "the option %s of a figure must lie between 0 and %d", names[i],
                             most[i]);
        }
    }
    if (o->colour > TAUT_COLOUR_GAP) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, (double)o->colour,
                         TAUT_COLOUR_GAP, "there is no such colour");
    }
    return TAUT_OK;
}

static taut_status check_options(const taut_write_options *options, taut_error *error)
{
    const double a = options->view[0], e = options->view[1];
    if (options->has_view && !(isfinite(a) && e >= -90 && e <= 90)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, isfinite(a) ? e : a,
                         isfinite(a) ? 90 : taut_none,
                         "a view needs a finite azimuth and an elevation from -90 to 90 degrees");
    }
    return check_numbers(options, error);
}

/* f is zero but for its options. */
static taut_status draw_models(figure *f, int count, const taut_model *const *models,
                               const char *kind, FILE *out, taut_error *error)
{
    const taut_canvas_ops *ops = NULL;
    taut_status status = check_options(&f->options, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = find_canvas(kind, &ops, error);
    if (status != TAUT_OK) {
        return status;
    }
    f->limit = 1;
    f->vector = strcmp(kind, "png") != 0;
    f->pieces =
        count == 1 && strcmp(kind, "pdf") == 0 && taut_flat_is(models[0]) ? models[0] : NULL;
    f->arena = taut_arena_new();
    if (f->arena == NULL) {
        return taut_fail_memory(error);
    }
    status = taut_panes_new(count, models, &f->options, f->arena, &f->panes, error);
    return status == TAUT_OK ? draw_panes(f, ops, kind, out, error) : status;
}

taut_status taut_draw_figures(int count, const taut_model *const *models,
                              const taut_write_options *options, const char *kind, FILE *out,
                              taut_error *error)
{
    figure f = {.arena = NULL};

    if (count < 1 || count > TAUT_MODELS_MAX || models == NULL || kind == NULL || out == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, count, TAUT_MODELS_MAX,
                         "a figure needs 1 to %d models, a kind and a stream", TAUT_MODELS_MAX);
    }
    if (options != NULL) {
        f.options = *options;
    }
    const taut_status status = draw_models(&f, count, models, kind, out, error);
    taut_scene_clear(&f.scene);
    taut_arena_free(f.arena);
    return status;
}

taut_status taut_draw_figure(const taut_model *model, const taut_write_options *options,
                             const char *kind, FILE *out, taut_error *error)
{
    if (model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a figure needs a model");
    }
    return taut_draw_figures(1, &model, options, kind, out, error);
}

/* Laths to cut are drawn as they are cut, where the figure is to scale. */
static taut_status write_one(const taut_model *model, const taut_write_options *options,
                             const char *kind, FILE *out, taut_error *error)
{
    return strcmp(kind, "svg") == 0 && taut_flat_is(model)
               ? taut_flat_svg_write(model, out, error)
               : taut_draw_figure(model, options, kind, out, error);
}

/* The formats that are pictures. */
#define TAUT_FIGURE(kind)                                                                          \
    static taut_status write_##kind(const taut_model *model, const taut_write_options *options,    \
                                    FILE *out, taut_error *error)                                  \
    {                                                                                              \
        return write_one(model, options, #kind, out, error);                                       \
    }                                                                                              \
    static taut_status write_many_##kind(int count, const taut_model *const *models,               \
                                         const taut_write_options *options, FILE *out,             \
                                         taut_error *error)                                        \
    {                                                                                              \
        return taut_draw_figures(count, models, options, #kind, out, error);                       \
    }                                                                                              \
    const taut_format_ops taut_format_##kind = {                                                   \
        .write = write_##kind, .write_many = write_many_##kind, .models_max = TAUT_MODELS_MAX}

TAUT_FIGURE(svg);
TAUT_FIGURE(pdf);
TAUT_FIGURE(png);
