/* figure.c -- from models to a page: choose what is drawn, sample it, aim the cameras, cut into
 * pieces, paint. */
#include "draw/figure.h"

#include "core/arena.h"
#include "core/date.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "draw/flat_page.h"
#include "draw/flat_svg.h"
#include "draw/label.h"
#include "draw/legend.h"
#include "draw/pane.h"
#include "draw/panes.h"
#include "io/flat/cloth.h"
#include "io/flat/flat.h"
#include "io/flat/spread.h"
#include "io/format.h"
#include "mesh/colour.h"
#include "platform/module.h"
#include "platform/system.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A page before it is cropped: 600 points wide, or a column of 88 mm. Letters of a column are at least 6 point. */
static const double page_width = 1200, page_height = 900, page_point = 0.5;
static const double column_width = 700, column_height = 900, column_point = 88 / 25.4 * 72 / 700;
/* Beside the picture for names or a scale, below for the scale bar, for a title. */
static const double legend_width = 160, names_width = 200, foot = 52, title_height = 44;

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
    int is_noise;         /* no value is more than rounding */
    int sign;             /* of all values, 0: both */
    double width, height; /* of the page */
    double point;         /* of a page unit */
    double top, right;    /* what title and legend take */
    double axes[2];       /* where the axes meet */
    double foot;          /* what the scale bar and the note take below */
    char note[256];
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

/* A row of the names beside a figure: of all things of one colour. */
typedef struct named {
    int colour, is_curve, count;
    const char *first, *last;
} named;

/* The rows, as they appear, once drawn of what is seen; returns how many there are, more than `most` where not all found room. */
static int name_rows(const taut_pane *pane, int drawn, int most, named *rows)
{
    int count = 0;
    for (int i = 0; i < pane->sheet_count + pane->curve_count; i++) {
        const int c = i - pane->sheet_count, is_curve = c >= 0;
        if (drawn && !(is_curve ? pane->curves[c].is_seen : pane->sheets[i].is_seen)) {
            continue;
        }
        const int colour =
            is_curve ? taut_pane_curve_colour(pane, c) : taut_pane_sheet_colour(pane, i);
        const char *name = is_curve ? taut_curve_name(pane->curves[c].curve)
                                    : taut_surface_name(pane->sheets[i].surface);
        int row = 0;
        while (row < count && row < most &&
               (rows[row].is_curve != is_curve || rows[row].colour != colour)) {
            row++;
        }
        if (row == count) {
            count++;
        }
        const int is_image = name[0] != '\0' && name[strlen(name) - 1] == '\'';
        if (row < most && !(is_image && rows[row].count > 0)) {
            rows[row] = (named){colour, is_curve, rows[row].count + 1,
                                rows[row].count > 0 ? rows[row].first : name, name};
        }
    }
    return count;
}

/* Rows of names beside a figure of several plain things, too many for none. */
static int names_shown(const figure *f, int drawn, named rows[TAUT_LEGEND_ROWS])
{
    memset(rows, 0, TAUT_LEGEND_ROWS * sizeof *rows);
    if (f->panes.count != 1 || f->options.colour != TAUT_COLOUR_PLAIN) {
        return 0;
    }
    const int count = name_rows(f->panes.pane, drawn, TAUT_LEGEND_ROWS, rows);
    return count > 1 && count <= TAUT_LEGEND_ROWS ? count : 0;
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
                           [TAUT_COLOUR_GAP] = 1e-15,
                           [TAUT_COLOUR_WARP] = 0, /* of any unit: nothing is rounding */
                           [TAUT_COLOUR_WEFT] = 0,
                           [TAUT_COLOUR_STRAIN] = 1};
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
    f->limit = taut_colour_range(count, values, noise_of(f), &f->cut, &f->sign);
    f->sign = taut_sheet_has_signs(f->options.colour) ? f->sign : 1;
    f->is_noise = taut_sheet_has_signs(f->options.colour) && f->limit <= 1.1 * noise_of(f);
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

/* What comes after the last dot: of "front.u0", u0. */
static const char *own_name(const char *name)
{
    const char *dot = strrchr(name, '.');
    return dot != NULL && dot[1] != '\0' ? dot + 1 : name;
}

/* Of one thing its name; of more, of which the first and the last are given, what they have in common: the names after the dot
 * where those are alike, "S1 ... 4" where they are numbered. */
static void name_row(const named *r, char *name, size_t room)
{
    const int is_part = strcmp(own_name(r->first), r->first) != 0 &&
                        strcmp(own_name(r->last), r->last) != 0 && r->count > 1;
    const int in_turn = !is_part || strcmp(own_name(r->first), own_name(r->last)) <= 0;
    const char *first = is_part ? own_name(in_turn ? r->first : r->last) : r->first;
    const char *last = is_part ? own_name(in_turn ? r->last : r->first) : r->last;
    const size_t stem = strcspn(last, "0123456789");
    const int is_numbered = strncmp(first, last, stem) == 0 && stem > 0 &&
                            last[stem + strspn(last + stem, "0123456789")] == '\0';

    if (r->count == 1 || strcmp(first, last) == 0) {
        snprintf(name, room, "%.400s", first);
    } else if (r->count == 2 || is_part) {
        const int is_long = strlen(first) + strlen(last) > 10;
        snprintf(name, room, "%.200s, %.200s", first, is_numbered && is_long ? last + stem : last);
    } else {
        snprintf(name, room, "%.200s \xe2\x80\xa6 %.200s", first, is_numbered ? last + stem : last);
    }
}

static void draw_names(const figure *f, const taut_legend *legend)
{
    named rows[TAUT_LEGEND_ROWS];
    const int shown = names_shown(f, 1, rows);
    for (int row = 0; row < shown; row++) {
        const named *r = &rows[row];
        char name[512];
        name_row(r, name, sizeof name);
        taut_legend_name(legend, row,
                         r->is_curve ? taut_colour_curve(r->colour) : taut_colour_plain(r->colour),
                         r->is_curve, name);
    }
}

/* The smallest letters, in page units: 6 point in a column. */
static double least_of(const figure *f)
{
    return f->options.column ? 6 / f->point : 0;
}

/* Sizes mean the same in all panes. */
static int has_bar(const figure *f)
{
    return f->panes.count == 1 || f->panes.is_one_size;
}

/* Do the axes lie beside the scale bar? */
static int has_axes_below(const figure *f)
{
    return f->axes[1] > f->height - f->foot - 28;
}

static void draw_legend(const figure *f, const taut_legend *legend)
{
    const taut_write_options *o = &f->options;
    const char *unit = taut_model_unit(f->panes.pane[0].model);
    const double y = legend->height - f->foot + 34;
    double x = has_axes_below(f) ? 24 + 2 * TAUT_LEGEND_AXES : 24;

    if (o->title != NULL) {
        taut_legend_title(legend, o->title);
    }
    if (o->colour != TAUT_COLOUR_PLAIN && taut_panes_sheets(&f->panes, o) > 0) {
        const taut_legend_range range = {
            .limit = f->limit, .sign = f->sign, .cut = f->cut, .has_grey = f->has_grey};
        taut_legend_scale(legend, o->colour, &range, unit);
    }
    for (int i = 0; i < f->panes.count; i++) {
        if (f->panes.pane[i].label != NULL) {
            taut_legend_label(legend, f->panes.place[i], f->panes.pane[i].label);
        }
    }
    draw_names(f, legend);
    if (has_bar(f)) {
        x = taut_legend_bar(legend, &f->panes.pane[0].camera, x, y, unit) + 36;
    }
    taut_legend_note(legend, x, y + 2, f->note);
}

/* Is nothing drawn within `reach` of a point of the page? */
static int is_free(const figure *f, double x, double y, double reach)
{
    for (double dy = -reach; dy <= reach; dy += 3) {
        for (double dx = -reach; dx <= reach; dx += 3) {
            if (isfinite(taut_depth_at(&f->scene.depth, x + dx, y + dy))) {
                return 0;
            }
        }
    }
    for (size_t i = 0; i < f->scene.point_count; i++) {
        const double *p = f->scene.points[i];
        if (fabs(p[0] - x) <= reach && fabs(p[1] - y) <= reach) {
            return 0;
        }
    }
    return 1;
}

/* The axes go into a corner of the picture that is free, or else below it. */
static void place_axes(figure *f)
{
    const double reach = TAUT_LEGEND_AXES, low = f->height - f->foot;
    const double right = f->width - f->right - (f->right > 0 ? 30 : 0); /* clear of the legend */
    const double corner[4][2] = {{reach + 10, low - reach + 18},
                                 {right - reach - 12, low - reach + 18},
                                 {reach + 10, f->top + reach},
                                 {right - reach - 12, f->top + reach}};
    for (int k = 0; k < 4; k++) {
        if (is_free(f, corner[k][0], corner[k][1], reach)) {
            memcpy(f->axes, corner[k], sizeof f->axes);
            return;
        }
    }
    f->height += 2 * reach - 30;
    f->axes[0] = reach + 10;
    f->axes[1] = f->height - reach;
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
    return text != NULL && end != text && *end == '\0' && date >= 0 && date <= TAUT_DATE_MOST ? date
                                                                                              : -1;
}

/* What the file is called within: the title, or what the model is. */
static void name_page(const figure *f, char *title, size_t size)
{
    const taut_model *model = f->panes.pane[0].model;
    const taut_certificate *certificate = taut_model_certificate(model);
    if (f->options.title != NULL) {
        taut_label_clean(f->options.title, size, title, size);
        return;
    }
    snprintf(title, size, "%s, a figure by taut",
             certificate != NULL && taut_certificate_construct(certificate)[0] != '\0'
                 ? taut_certificate_construct(certificate)
                 : "surface");
}

/* TAUT_IO when the bytes do not arrive. */
static taut_status paint_page(figure *f, const taut_canvas_ops *ops, const char *kind, FILE *out,
                              taut_error *error)
{
    char title[512] = "";
    const int pixels = f->options.column ? 1039 /* 300 an inch */ : (int)page_width;
    taut_page page = {.kind = kind,
                      .width = f->width,
                      .height = f->height,
                      .point = f->point,
                      .title = title,
                      .date = source_date(),
                      .pixels = f->options.width > 0 ? f->options.width : pixels,
                      .write = write_bytes,
                      .context = out};
    taut_canvas *canvas = taut_arena_take(f->arena, 1, ops->size);
    const taut_legend legend = {ops, canvas, f->width, f->height, f->top, least_of(f)};

    if (canvas == NULL) {
        return TAUT_NO_MEMORY;
    }
    name_page(f, title, sizeof title);
    errno = 0;
    taut_status status = ops->begin(canvas, &page);
    if (status != TAUT_OK) {
        return status;
    }
    taut_scene_paint(&f->scene, ops, canvas);
    taut_legend_axes(&legend, &f->panes.pane[0].camera, f->axes);
    draw_legend(f, &legend);
    const taut_status sheets = f->pieces != NULL ? taut_flat_page(f->pieces, &f->options, f->point,
                                                                  ops, canvas, f->arena, error)
                                                 : TAUT_OK;
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
    if (status == TAUT_BAD_INPUT ||
        status == TAUT_BAD_ARGUMENT) { /* of a plan, which says what it is */
        return status;
    }
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
    taut_status status = taut_scene_init(&f->scene, f->width, f->height, f->arena);
    if (status != TAUT_OK) {
        return status;
    }
    f->scene.tag_size = fmax(15, least_of(f));
    status = add_all(f);
    return status == TAUT_OK && is_interrupted(f, 0.7) ? TAUT_INTERRUPTED : status;
}

static int aim(figure *f)
{
    const double page[4] = {0, f->top, f->width - f->right, f->height - f->foot};
    return taut_panes_aim(&f->panes, &f->options, page);
}

/* Aims at a page, and crops it to what that takes. 0 where there is nothing to draw. A column keeps its width. */
static int lay_out(figure *f)
{
    named rows[TAUT_LEGEND_ROWS];
    const int names = names_shown(f, 0, rows), has_scale = f->options.colour != TAUT_COLOUR_PLAIN;
    double size[2];

    f->point = f->options.column ? column_point : page_point;
    f->width = f->options.column ? column_width : page_width;
    f->height = f->options.column ? column_height : page_height;
    f->top = f->options.title != NULL ? title_height : 0;
    f->right = has_scale ? legend_width : names > 0 ? names_width : 0;
    f->foot = foot;
    if (!aim(f)) {
        return 0;
    }
    taut_panes_used(&f->panes, size);
    const double least = has_scale ? 480 : fmax(30.0 * names + 60, 240);
    f->height = fmin(f->height, fmax(f->top + size[1], least) + f->foot);
    if (!f->options.column) { /* no taller than wide: letters would be large beside others' */
        f->width = fmin(f->width, fmax(fmax(size[0], 420) + f->right, f->height));
    }
    return aim(f);
}

/* Room for the note, once the scale of the colours is known; names of nothing that is seen take none. */
static void finish_layout(figure *f)
{
    named rows[TAUT_LEGEND_ROWS];
    const taut_legend legend = {.width = f->width, .least = least_of(f)};

    if (f->right > 0 && f->options.colour == TAUT_COLOUR_PLAIN && names_shown(f, 1, rows) == 0 &&
        !f->options.column) {
        f->width -= f->right;
        f->right = 0;
    }
    place_axes(f);
    taut_panes_note(&f->panes, &f->options, f->limit, f->note, sizeof f->note);
    if (f->is_noise) {
        const size_t used = strlen(f->note);
        snprintf(f->note + used, sizeof f->note - used, "%s0 to rounding everywhere",
                 used > 0 ? "; " : "");
    }
    const double x = 0.2 * f->width + 24 + 120 + (has_axes_below(f) ? 124 : 0);
    const int lines = taut_legend_note(&legend, x, 0, f->note);
    f->height += fmax(lines - 1, 0) * TAUT_LEGEND_LINE;
    f->foot += fmax(lines - 1, 0) * TAUT_LEGEND_LINE;
}

static taut_status draw_panes(figure *f, const taut_canvas_ops *ops, const char *kind, FILE *out,
                              taut_error *error)
{
    taut_status status = sample_panes(f);

    if (status != TAUT_OK) {
        return taut_fail_status(error, status);
    }
    if (!lay_out(f)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, 0, 1,
                         "there is nothing to draw: no surface or curve has a finite point");
    }
    status = make_scene(f);
    if (status != TAUT_OK) {
        return taut_fail_status(error, status);
    }
    finish_layout(f);
    status = paint_page(f, ops, kind, out, error);
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
    if (o->tiles > TAUT_PAPER_A3 || !(o->reduction >= 0) || !isfinite(o->reduction)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, o->reduction, taut_none,
                         "there is no such paper, or a reduction that is no number above 0");
    }
    if (o->colour > TAUT_COLOUR_STRAIN) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, (double)o->colour,
                         TAUT_COLOUR_STRAIN, "there is no such colour");
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

/* f is zero but for its options. own: the models as they are. */
static taut_status draw_models(figure *f, int count, const taut_model *const *models,
                               const taut_model *const *own, const char *kind, FILE *out,
                               taut_error *error)
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
    f->arena = taut_arena_new();
    if (f->arena == NULL) {
        return taut_fail_memory(error);
    }
    status = taut_panes_new(count, models, &f->options, f->arena, &f->panes, error);
    for (int i = 0; status == TAUT_OK && i < f->panes.count; i++) {
        for (int k = 0; k < count; k++) {
            if (models[k] == f->panes.pane[i].model) {
                f->panes.pane[i].own = own[k];
            }
        }
    }
    return status == TAUT_OK ? draw_panes(f, ops, kind, out, error) : status;
}

/* The plane of the page for pieces that lie flat, from the view, which is that of solids at first sight where none is asked for; in a
 * view that is chosen by what is seen they would lie askew. */
static void choose_plane(figure *f, double plane[2][3])
{
    taut_camera camera;
    if (!f->options.has_view) {
        f->options.view[0] = -60;
        f->options.view[1] = 35;
        f->options.has_view = 1;
    }
    taut_camera_init(&camera);
    taut_camera_aim(&camera, f->options.view[0], f->options.view[1]);
    memcpy(plane[0], camera.right, sizeof camera.right);
    memcpy(plane[1], camera.up, sizeof camera.up);
}

/* The same with the flat pieces of cutting patterns below their surfaces, in the plane of the page. */
static taut_status draw_spread(figure *f, int count, const taut_model *const *models,
                               const char *kind, FILE *out, taut_error *error)
{
    taut_model *own[TAUT_MODELS_MAX] = {NULL};
    const taut_model *shown[TAUT_MODELS_MAX] = {NULL};
    taut_status status = TAUT_OK;
    f->pieces =
        count == 1 && models[0] != NULL && strcmp(kind, "pdf") == 0 && taut_flat_is(models[0])
            ? models[0]
            : NULL;
    for (int i = 0; status == TAUT_OK && i < count; i++) {
        double plane[2][3];
        const int is_cloth = models[i] != NULL && taut_flat_is_cloth(models[i]);
        if (is_cloth) {
            choose_plane(f, plane);
        }
        status =
            is_cloth ? taut_flat_spread(models[i], (const double(*)[3])plane, &own[i]) : TAUT_OK;
        shown[i] = own[i] != NULL ? own[i] : models[i];
    }
    status = status == TAUT_OK ? draw_models(f, count, shown, models, kind, out, error)
                               : taut_fail_memory(error);
    for (int i = 0; i < count; i++) {
        taut_model_free(own[i]);
    }
    return status;
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
    const taut_status status = draw_spread(&f, count, models, kind, out, error);
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
