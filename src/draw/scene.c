#include "draw/scene.h"

#include "core/elementary/elementary.h"
#include "core/memory.h"
#include "draw/label.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A point this much behind a surface, in page units, or this far beside it still counts as on it; a line is judged
 * every STEP units; fewer than SHORTEST steps in a row are a ripple and follow what is around them. */
static const double usual_slack = 1.5, usual_reach = 0.4, step_length = 1;
enum { SHORTEST = 4 };

taut_status taut_scene_init(taut_scene *scene, double width, double height, taut_arena *arena)
{
    memset(scene, 0, sizeof *scene);
    scene->status =
        taut_depth_new((int)width, (int)height, arena, &scene->depth) ? TAUT_OK : TAUT_NO_MEMORY;
    return scene->status;
}

void taut_scene_clear(taut_scene *scene)
{
    taut_free(scene->cells);
    taut_free(scene->strokes);
    taut_free(scene->points);
    taut_free(scene->hidden);
    taut_free(scene->tags);
    memset(scene, 0, sizeof *scene);
}

/* `array` with room for `count` + `more` items, or NULL, and then the scene has failed. */
static void *with_room(taut_scene *scene, void *array, size_t count, size_t more, size_t size,
                       size_t *room)
{
    if (count + more > *room) {
        const size_t wanted = count + more > 2 * *room ? count + more + 1024 : 2 * *room;
        void *grown = scene->status == TAUT_OK ? taut_realloc(array, wanted, size) : NULL;
        if (grown == NULL) {
            scene->status = TAUT_NO_MEMORY;
            return array;
        }
        *room = wanted;
        return grown;
    }
    return array;
}

static int is_finite(const double p[3])
{
    return isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]);
}

/* Corners are moved 0.35 of a page unit outwards, so that neighbours overlap and no white shows
 * through between their smoothed edges. 0 when a corner is not finite or all are one point. */
static int shape_cell(const double *const corner[4], taut_cell *cell)
{
    double centre[2] = {0, 0}, reach = 0;
    for (int i = 0; i < 4; i++) {
        if (!is_finite(corner[i])) {
            return 0;
        }
        centre[0] += corner[i][0] / 4;
        centre[1] += corner[i][1] / 4;
        cell->depth += corner[i][2] / 4;
    }
    for (int i = 0; i < 4; i++) {
        const double d[2] = {corner[i][0] - centre[0], corner[i][1] - centre[1]};
        const double length = taut_hypot(d[0], d[1]);
        reach = fmax(reach, length);
        for (int c = 0; c < 2; c++) {
            cell->xy[i][c] = corner[i][c] + (length > 0.01 ? 0.35 * d[c] / length : 0);
        }
    }
    return reach > 0.01;
}

static void add_cell(taut_scene *scene, const taut_cell *cell)
{
    scene->cells = with_room(scene, scene->cells, scene->cell_count, 1, sizeof *scene->cells,
                             &scene->cell_room);
    if (scene->status == TAUT_OK) {
        scene->cells[scene->cell_count++] = *cell;
    }
}

void taut_scene_cell(taut_scene *scene, const double *const corner[4], taut_ink ink)
{
    taut_cell cell = {.ink = ink, .order = scene->cell_count};
    if (shape_cell(corner, &cell)) {
        add_cell(scene, &cell);
        if (!taut_depth_triangle(&scene->depth, corner[0], corner[1], corner[2]) ||
            !taut_depth_triangle(&scene->depth, corner[0], corner[2], corner[3])) {
            scene->status = TAUT_NO_MEMORY;
        }
    }
}

void taut_scene_over(taut_scene *scene, const double *const corner[4], taut_ink ink)
{
    taut_cell cell = {.ink = ink, .order = scene->cell_count};
    assert(scene->cell_count > 0);
    if (shape_cell(corner, &cell)) {
        cell.depth = scene->cells[scene->cell_count - 1].depth;
        add_cell(scene, &cell);
    }
}

int taut_scene_hides(const taut_scene *scene, const double at[3], double slack)
{
    return taut_depth_hides(&scene->depth, at, usual_reach, slack);
}

static void add_stroke(taut_scene *scene, taut_stroke stroke)
{
    scene->strokes = with_room(scene, scene->strokes, scene->stroke_count, 1,
                               sizeof *scene->strokes, &scene->stroke_room);
    if (scene->status == TAUT_OK) {
        scene->strokes[scene->stroke_count++] = stroke;
    }
}

static void add_point(taut_scene *scene, double x, double y)
{
    scene->points = with_room(scene, scene->points, scene->point_count, 1, sizeof *scene->points,
                              &scene->point_room);
    if (scene->status == TAUT_OK) {
        scene->points[scene->point_count][0] = x;
        scene->points[scene->point_count][1] = y;
        scene->point_count++;
    }
}

/* The steps a piece of line is judged in: 0 where it is a point or not finite. */
static size_t steps_of(const double a[3], const double b[3])
{
    const double length = taut_hypot(b[0] - a[0], b[1] - a[1]);
    return is_finite(a) && is_finite(b) && length > 0
               ? (size_t)fmin(ceil(length / step_length), 10000)
               : 0;
}

/* hidden[k] for every step of the line, judged at its middle. Returns how many. */
static size_t mark_hidden(taut_scene *scene, size_t count, const double *points, double reach,
                          double slack)
{
    size_t used = 0;
    for (size_t i = 0; i + 1 < count; i++) {
        const double *a = points + 3 * i, *b = a + 3;
        const size_t steps = steps_of(a, b);
        scene->hidden = with_room(scene, scene->hidden, used, steps, 1, &scene->hidden_room);
        for (size_t k = 0; k < steps && scene->status == TAUT_OK; k++) {
            const double t = ((double)k + 0.5) / (double)steps;
            const double at[3] = {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]),
                                  a[2] + t * (b[2] - a[2])};
            scene->hidden[used++] =
                (unsigned char)taut_depth_hides(&scene->depth, at, reach, slack);
        }
    }
    return used;
}

/* Short runs between two others take their state, left to right. */
static void smooth_hidden(size_t count, unsigned char *hidden)
{
    size_t start = 0;
    for (size_t i = 1; i <= count; i++) {
        if (i == count || hidden[i] != hidden[start]) {
            if (start > 0 && i < count && i - start < SHORTEST) {
                memset(hidden + start, hidden[i], i - start);
            }
            start = i < count && hidden[i] == hidden[start] ? start : i;
        }
    }
}

/* Ends the stroke that began at style.first. */
static void close_run(taut_scene *scene, taut_stroke style)
{
    style.count = (int)(scene->point_count - style.first);
    if (style.count > 1) {
        add_stroke(scene, style);
    }
}

static void add_point_between(taut_scene *scene, const double a[3], const double b[3], double t)
{
    add_point(scene, a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]));
}

/* The visible runs, or the hidden ones, as strokes: cut within a piece where the state changes, broken where a point is
 * not finite. */
static void add_runs(taut_scene *scene, size_t count, const double *points, taut_stroke style,
                     int hidden)
{
    size_t judged = 0;
    int open = 0;
    for (size_t i = 0; i + 1 < count; i++) {
        const double *a = points + 3 * i, *b = a + 3;
        const size_t steps = steps_of(a, b);
        for (size_t k = 0; k < steps; k++) {
            const int visible = scene->hidden[judged++] == hidden;
            if (visible && !open) {
                style.first = scene->point_count;
                add_point_between(scene, a, b, (double)k / (double)steps);
            } else if (!visible && open) {
                add_point_between(scene, a, b, (double)k / (double)steps);
                close_run(scene, style);
            }
            open = visible;
        }
        if (open && steps > 0) {
            add_point(scene, b[0], b[1]);
        } else if (open && !is_finite(b)) {
            close_run(scene, style);
            open = 0;
        }
    }
    if (open) {
        close_run(scene, style);
    }
}

void taut_scene_fold(taut_scene *scene, size_t count, const double *points, taut_ink ink,
                     double width, double reach)
{
    const taut_stroke style = {.size = width, .ink = ink};
    const size_t steps = mark_hidden(scene, count, points, reach, usual_slack);
    if (scene->status == TAUT_OK) {
        smooth_hidden(steps, scene->hidden);
        add_runs(scene, count, points, style, 0);
    }
}

void taut_scene_line(taut_scene *scene, size_t count, const double *points, taut_ink ink,
                     double width)
{
    taut_scene_fold(scene, count, points, ink, width, usual_reach);
}

void taut_scene_line_through(taut_scene *scene, size_t count, const double *points, taut_ink ink,
                             taut_ink faint, double width, double slack)
{
    const taut_stroke seen = {.size = width, .ink = ink};
    const taut_stroke behind = {.size = 0.7 * width, .ink = faint};
    const size_t steps = mark_hidden(scene, count, points, usual_reach, slack);
    if (scene->status == TAUT_OK) {
        smooth_hidden(steps, scene->hidden);
        add_runs(scene, count, points, behind, 1);
        add_runs(scene, count, points, seen, 0);
    }
}

void taut_scene_disc(taut_scene *scene, const double at[3], taut_ink ink, taut_ink rim,
                     double radius)
{
    const taut_stroke style = {
        .size = radius, .ink = ink, .rim = rim, .first = scene->point_count, .count = 1};
    if (is_finite(at) && !taut_scene_hides(scene, at, usual_slack)) {
        add_point(scene, at[0], at[1]);
        add_stroke(scene, style);
    }
}

int taut_scene_has_room(const taut_scene *scene, const double at[3], const double size[2],
                        double gap)
{
    if (!is_finite(at) || taut_scene_hides(scene, at, usual_slack)) {
        return 0;
    }
    for (int k = 0; k < 4; k++) {
        const double x = at[0] + (k % 2 == 0 ? -0.5 : 0.5) * size[0];
        const double y = at[1] + (k < 2 ? -0.5 : 0.5) * size[1];
        if (!isfinite(taut_depth_at(&scene->depth, x, y))) {
            return 0;
        }
    }
    for (size_t i = 0; i < scene->tag_count; i++) {
        const double *other = scene->tags[i].xy;
        if (taut_hypot(at[0] - other[0], at[1] - other[1]) < gap) {
            return 0;
        }
    }
    return 1;
}

void taut_scene_tag(taut_scene *scene, const taut_tag *tag)
{
    scene->tags =
        with_room(scene, scene->tags, scene->tag_count, 1, sizeof *scene->tags, &scene->tag_room);
    if (scene->status == TAUT_OK) {
        scene->tags[scene->tag_count++] = *tag;
    }
}

static void paint_tag(const taut_scene *scene, const taut_tag *tag, const taut_canvas_ops *ops,
                      taut_canvas *canvas)
{
    const double w = 0.5 * taut_label_width(tag->text, scene->tag_size) + 2,
                 h = 0.56 * scene->tag_size;
    const double x = tag->xy[0], y = tag->xy[1];
    const double box[4][2] = {{x - w, y - h}, {x + w, y - h}, {x + w, y + h}, {x - w, y + h}};
    ops->polygon(canvas, 4, box, tag->paper);
    ops->text(canvas, x, y + 0.36 * scene->tag_size, scene->tag_size, TAUT_ANCHOR_MIDDLE, tag->ink,
              tag->text);
}

static int farther_first(const void *a, const void *b)
{
    const taut_cell *x = a, *y = b;
    if (x->depth < y->depth || x->depth > y->depth) {
        return x->depth < y->depth ? -1 : 1;
    }
    return x->order < y->order ? -1 : 1;
}

void taut_scene_paint(taut_scene *scene, const taut_canvas_ops *ops, taut_canvas *canvas)
{
    if (scene->cell_count > 0) {
        qsort(scene->cells, scene->cell_count, sizeof *scene->cells, farther_first);
    }
    for (size_t i = 0; i < scene->cell_count; i++) {
        const taut_cell *cell = &scene->cells[i];
        ops->polygon(canvas, 4, (const double(*)[2])cell->xy, cell->ink);
    }
    for (size_t i = 0; i < scene->stroke_count; i++) {
        const taut_stroke *s = &scene->strokes[i];
        const double(*xy)[2] = (const double(*)[2])(scene->points + s->first);
        if (s->count > 1) {
            ops->line(canvas, s->count, xy, s->ink, s->size);
        } else {
            ops->disc(canvas, xy[0], s->size, s->ink, s->rim, 0.4 * s->size);
        }
    }
    for (size_t i = 0; i < scene->tag_count; i++) {
        paint_tag(scene, &scene->tags[i], ops, canvas);
    }
}
