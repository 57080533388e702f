/* parts_sheet.c -- the shaded cells of a surface, its boundary and its knot lines. */
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "draw/parts.h"
#include "mesh/colour.h"

#include <math.h>
#include <string.h>

static const taut_ink boundary_ink = {36, 42, 54};
static const double boundary_width = 2.0, knot_width = 0.8;

/* The normal of a cell by its diagonals, in the frame (right, up, eye), turned to the viewer and
 * scaled to a largest component of 1; straight at the viewer where the cell has no area. 1 when it
 * had to be turned: the cell shows its back. */
static int cell_normal(const double *const corner[4], double normal[3])
{
    double d[2][3], size = 0;
    int turned = 0;
    for (int k = 0; k < 2; k++) {
        d[k][0] = corner[k + 2][0] - corner[k][0];
        d[k][1] = corner[k][1] - corner[k + 2][1]; /* the page's y runs down */
        d[k][2] = corner[k + 2][2] - corner[k][2];
    }
    for (int c = 0; c < 3; c++) {
        const int e = (c + 1) % 3, f = (c + 2) % 3;
        normal[c] = d[0][e] * d[1][f] - d[0][f] * d[1][e];
        size = fmax(size, fabs(normal[c]));
    }
    if (!(size > 0) || !isfinite(size)) {
        normal[0] = normal[1] = 0;
        normal[2] = size = 1;
    }
    turned = normal[2] < 0;
    for (int c = 0; c < 3; c++) {
        normal[c] /= turned ? -size : size;
    }
    return turned;
}

/* The part of the triangle where s > 0, as one piece over the last cell: linear along its sides. */
static void add_lit(const double *const p[3], const double s[3], taut_ink ink, taut_scene *scene)
{
    double at[4][3];
    int count = 0;
    for (int k = 0; k < 3; k++) {
        const double *a = p[k], *b = p[(k + 1) % 3];
        const double sa = s[k], sb = s[(k + 1) % 3];
        if (sa > 0) {
            memcpy(at[count++], a, sizeof at[0]);
        }
        if ((sa > 0) != (sb > 0)) {
            for (int c = 0; c < 3; c++) {
                at[count][c] = a[c] + sa / (sa - sb) * (b[c] - a[c]);
            }
            count++;
        }
    }
    if (count >= 3) {
        const double *const corner[4] = {at[0], at[1], at[2], at[count - 1]};
        taut_scene_over(scene, corner, ink);
    }
}

/* Page units from lamp to lamp, below which they are a grey and above which they are seen whole. */
static const double finest = 8, clear = 16;

/* How clearly the lamps are seen in a cell, 0 to 1, from their phase at its corners: where the
 * normals fan out, lines would lie closer than any page shows them, and scribble. Phases are equal
 * that differ by whole turns. */
static double contrast_of(const double *const corner[4], const double phase[4])
{
    double steepest = 0; /* in turns a page unit */
    for (int k = 0; k < 4; k++) {
        const double *a = corner[k], *b = corner[(k + 1) % 4];
        const double turns = (phase[(k + 1) % 4] - phase[k]) / (2 * TAUT_PI);
        const double length = fmax(taut_hypot(b[0] - a[0], b[1] - a[1]), 0.5);
        steepest = fmax(steepest, fabs(turns - round(turns)) / length);
    }
    const double gap = 1 / fmax(steepest, 1e-3);
    return fmin(fmax((gap - finest) / (clear - finest), 0), 1);
}

/* Lamps mirrored in a cell, s at its corners; none where there is no normal. */
static void add_stripes(const double *const corner[4], const double s[4], taut_ink ink,
                        taut_scene *scene)
{
    const double *const first[3] = {corner[0], corner[1], corner[2]};
    const double *const second[3] = {corner[0], corner[2], corner[3]};
    const double s_second[3] = {s[0], s[2], s[3]};
    if (isfinite(s[0]) && isfinite(s[1]) && isfinite(s[2]) && isfinite(s[3])) {
        if (s[0] > 0 && s[1] > 0 && s[2] > 0 && s[3] > 0) {
            taut_scene_over(scene, corner, ink);
        } else {
            add_lit(first, s, ink, scene);
            add_lit(second, s_second, ink, scene);
        }
    }
}

/* What the cell's colour is under the light. */
static taut_ink cell_ink(const taut_sheet *sheet, size_t cell, taut_ink ink, double limit,
                         const double *const corner[4])
{
    static const taut_ink back = {150, 138, 140};
    double normal[3];
    const int turned = cell_normal(corner, normal);
    taut_ink shown = turned ? taut_colour_mix(ink, back, 0.35) : ink;
    if (sheet->values != NULL) {
        shown = taut_colour_diverging(sheet->values[cell] / limit);
    }
    return taut_colour_shade(shown, normal, sheet->values != NULL ? 0.32 : 1);
}

taut_status taut_parts_cells(const taut_sheet *sheet, const taut_camera *camera, taut_ink ink,
                             double limit, taut_arena *arena, taut_scene *scene, double **page)
{
    static const taut_ink dark = {30, 36, 52};
    static const double lit_mix = 0.72;
    const size_t columns = (size_t)sheet->v.count, count = (size_t)sheet->u.count * columns;
    double *p = taut_arena_take(arena, count, 3 * sizeof(double));

    if (p == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        taut_camera_project(camera, sheet->points + 3 * i, p + 3 * i);
    }
    for (size_t i = 0; i + 1 < (size_t)sheet->u.count; i++) {
        for (size_t j = 0; j + 1 < columns; j++) {
            const double *first = p + 3 * (i * columns + j);
            const double *const corner[4] = {first, first + 3 * columns, first + 3 * columns + 3,
                                             first + 3};
            const size_t cell = i * (columns - 1) + j, before = scene->cell_count;
            const taut_ink shown = cell_ink(sheet, cell, ink, limit, corner);
            if (sheet->stripes == NULL) {
                taut_scene_cell(scene, corner, shown);
                continue;
            }
            const double *phase = sheet->stripes + 4 * cell;
            const double contrast = contrast_of(corner, phase);
            taut_scene_cell(scene, corner,
                            taut_colour_mix(shown, dark, lit_mix / 2 * (1 - contrast)));
            if (contrast > 0 && scene->cell_count > before) {
                const double s[4] = {taut_sin(phase[0]), taut_sin(phase[1]), taut_sin(phase[2]),
                                     taut_sin(phase[3])};
                add_stripes(corner, s, taut_colour_mix(shown, dark, lit_mix / 2 * (1 + contrast)),
                            scene);
            }
        }
    }
    *page = p;
    return scene->status;
}

/* The grid as the outline takes it: `lines` lines of `along` points. */
typedef struct grid {
    const double *page;
    size_t lines, along;
    size_t line_stride, along_stride;
} grid;

static const double *point_at(const grid *g, size_t line, size_t k)
{
    return g->page + line * g->line_stride + k * g->along_stride;
}

/* Do the first and the last line fall together, as on a tube? */
static int is_seam(const grid *g)
{
    for (size_t k = 0; k < g->along; k++) {
        const double *a = point_at(g, 0, k), *b = point_at(g, g->lines - 1, k);
        if (!(fabs(a[0] - b[0]) + fabs(a[1] - b[1]) + fabs(a[2] - b[2]) < 0.01)) {
            return 0;
        }
    }
    return 1;
}

static void add_grid_line(const grid *g, size_t line, taut_ink ink, double width, double *row,
                          taut_scene *scene)
{
    for (size_t k = 0; k < g->along; k++) {
        memcpy(row + 3 * k, point_at(g, line, k), 3 * sizeof(double));
    }
    taut_scene_line(scene, g->along, row, ink, width);
}

/* One direction's knot lines, or its two boundary lines (one thin line where they are a seam). */
static void add_lines(const grid *g, const taut_grid_lines *lines, int boundary, taut_ink knot_ink,
                      double *row, taut_scene *scene)
{
    const size_t last = g->lines - 1;
    for (size_t i = 1; i < last && !boundary; i++) {
        if (lines->is_knot[i]) {
            add_grid_line(g, i, knot_ink, knot_width, row, scene);
        }
    }
    if (is_seam(g)) {
        if (!boundary) {
            add_grid_line(g, 0, knot_ink, knot_width, row, scene);
        }
    } else if (boundary) {
        add_grid_line(g, 0, boundary_ink, boundary_width, row, scene);
        add_grid_line(g, last, boundary_ink, boundary_width, row, scene);
    }
}

taut_status taut_parts_outline(const taut_sheet *sheet, const double *page, int boundary,
                               taut_ink ink, taut_arena *arena, taut_scene *scene)
{
    static const taut_ink dark = {40, 44, 56}, grey = {120, 120, 126};
    const size_t nu = (size_t)sheet->u.count, nv = (size_t)sheet->v.count;
    const taut_ink knot_ink = sheet->values != NULL ? grey : taut_colour_mix(ink, dark, 0.45);
    const grid along_v = {page, nu, nv, 3 * nv, 3}, along_u = {page, nv, nu, 3, 3 * nv};
    double *row = taut_arena_take(arena, nu > nv ? nu : nv, 3 * sizeof(double));

    if (row == NULL) {
        return TAUT_NO_MEMORY;
    }
    add_lines(&along_v, &sheet->u, boundary, knot_ink, row, scene);
    add_lines(&along_u, &sheet->v, boundary, knot_ink, row, scene);
    return scene->status;
}
