/* isolines.c -- lines of equal value on a sheet, and lines of equal parameter. */
#include "core/elementary/elementary.h"
#include "draw/label.h"
#include "draw/parts.h"
#include "mesh/colour.h"

#include <math.h>
#include <string.h>

static const taut_ink line_ink = {44, 48, 60};
static const double line_width = 1.0, zero_width = 2.0;

/* The points on the sides of a triangle where s = level; 2, or 0. */
static int find_crossings(const double *const p[3], const double s[3], double level,
                          double at[2][3])
{
    int count = 0;
    for (int k = 0; k < 3; k++) {
        const double *a = p[k], *b = p[(k + 1) % 3];
        const double sa = s[k] - level, sb = s[(k + 1) % 3] - level;
        if ((sa > 0) != (sb > 0) && count < 2) {
            for (int c = 0; c < 3; c++) {
                at[count][c] = a[c] + sa / (sa - sb) * (b[c] - a[c]);
            }
            count++;
        }
    }
    return count;
}

/* Every level k step, k = first .. last, that the triangle crosses. */
static void add_triangle(const double *const p[3], const double s[3], double step, int first,
                         int last, taut_scene *scene)
{
    const double low = fmin(s[0], fmin(s[1], s[2])), high = fmax(s[0], fmax(s[1], s[2]));
    /* a value that is the same but for rounding would be crossed everywhere */
    if (!(high - low > 1e-5 * step)) {
        return;
    }
    const int from = (int)fmax(first, ceil(fmax(low / step, first)));
    const int to = (int)fmin(last, floor(fmin(high / step, last)));
    for (int k = from; k <= to; k++) {
        double at[2][3];
        if (find_crossings(p, s, k * step, at) == 2) {
            taut_scene_line(scene, 2, at[0], line_ink, k == 0 ? zero_width : line_width);
        }
    }
}

taut_status taut_parts_isolines(const taut_sheet *sheet, const double *page, double step, int first,
                                int last, taut_scene *scene)
{
    const size_t columns = (size_t)sheet->v.count;
    for (size_t i = 0; i + 1 < (size_t)sheet->u.count; i++) {
        for (size_t j = 0; j + 1 < columns; j++) {
            const double *corner = page + 3 * (i * columns + j);
            const double *s = sheet->corners + 4 * (i * (columns - 1) + j);
            const double *const one[3] = {corner, corner + 3 * columns, corner + 3 * columns + 3};
            const double *const two[3] = {corner, corner + 3 * columns + 3, corner + 3};
            const double s_two[3] = {s[0], s[2], s[3]};
            if (isfinite(s[0]) && isfinite(s[1]) && isfinite(s[2]) && isfinite(s[3])) {
                add_triangle(one, s, step, first, last, scene);
                add_triangle(two, s_two, step, first, last, scene);
            }
        }
    }
    return scene->status;
}

/* Where a level may be named: where lines are far from each other, then nearest to the middle of
 * the picture, all of the name on the surface and away from other names. */
typedef struct search {
    double level, step, size[2], middle[2];
    double best[3], score;
} search;

static const double tag_gap = 44; /* page units from name to name */

/* How far the next line is, in page units, where s is linear on a triangle. */
static double gap_of(const double *const p[3], const double s[3], double step)
{
    const double a[2] = {p[1][0] - p[0][0], p[1][1] - p[0][1]};
    const double b[2] = {p[2][0] - p[0][0], p[2][1] - p[0][1]};
    const double area = a[0] * b[1] - a[1] * b[0], sa = s[1] - s[0], sb = s[2] - s[0];
    const double slope = taut_hypot(sa * b[1] - sb * a[1], sb * a[0] - sa * b[0]) / fabs(area);
    return step / fmax(slope, step / 1000);
}

static void try_triangle(const double *const p[3], const double s[3], const taut_scene *scene,
                         search *found)
{
    double at[2][3], mid[3];
    if (find_crossings(p, s, found->level, at) != 2) {
        return;
    }
    for (int c = 0; c < 3; c++) {
        mid[c] = at[0][c] / 2 + at[1][c] / 2;
    }
    const double gap = gap_of(p, s, found->step);
    const double score =
        fmin(gap, 80) - 0.1 * taut_hypot(mid[0] - found->middle[0], mid[1] - found->middle[1]);
    if (gap > found->size[1] && score > found->score &&
        taut_scene_has_room(scene, mid, found->size, tag_gap)) {
        found->score = score;
        memcpy(found->best, mid, sizeof mid);
    }
}

static void search_sheet(const taut_sheet *sheet, const double *page, const taut_scene *scene,
                         search *found)
{
    const size_t columns = (size_t)sheet->v.count;
    for (size_t i = 0; i + 1 < (size_t)sheet->u.count; i++) {
        for (size_t j = 0; j + 1 < columns; j++) {
            const double *corner = page + 3 * (i * columns + j);
            const double *s = sheet->corners + 4 * (i * (columns - 1) + j);
            const double *const one[3] = {corner, corner + 3 * columns, corner + 3 * columns + 3};
            const double *const two[3] = {corner, corner + 3 * columns + 3, corner + 3};
            const double s_two[3] = {s[0], s[2], s[3]};
            if (isfinite(s[0]) && isfinite(s[1]) && isfinite(s[2]) && isfinite(s[3])) {
                try_triangle(one, s, scene, found);
                try_triangle(two, s_two, scene, found);
            }
        }
    }
}

/* The middle of what the sheet takes of the page. */
static void middle_of(const taut_sheet *sheet, const double *page, double middle[2])
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (size_t k = 0; k < (size_t)sheet->u.count * (size_t)sheet->v.count; k++) {
        for (size_t c = 0; c < 2; c++) {
            low[c] = fmin(low[c], page[3 * k + c]);
            high[c] = fmax(high[c], page[3 * k + c]);
        }
    }
    for (int c = 0; c < 2; c++) {
        middle[c] = low[c] / 2 + high[c] / 2;
    }
}

taut_status taut_parts_isoline_names(const taut_sheet *sheet, const double *page, double step,
                                     int first, int last, double limit, taut_scene *scene)
{
    static const taut_ink light = {255, 255, 255};
    double middle[2];

    middle_of(sheet, page, middle);
    for (int k = first; k <= last; k++) {
        taut_tag tag;
        const double share = k * step / limit;
        taut_label_number(k * step, tag.text, sizeof tag.text);
        search found = {.level = k * step,
                        .step = step,
                        .size = {taut_label_width(tag.text, scene->tag_size) + 4, scene->tag_size},
                        .middle = {middle[0], middle[1]},
                        .score = -INFINITY};
        search_sheet(sheet, page, scene, &found);
        if (found.score > -INFINITY) {
            tag.xy[0] = found.best[0];
            tag.xy[1] = found.best[1];
            tag.paper = taut_colour_diverging(share);
            tag.ink = fabs(share) > 0.55 ? light : line_ink;
            taut_scene_tag(scene, &tag);
        }
    }
    return scene->status;
}

enum { STEPS = 96 };

static double parameter_at(const taut_basis *basis, int i, int of)
{
    const double a = taut_basis_lo(basis), b = taut_basis_hi(basis), s = (double)i / of;
    return fmin(fmax((1 - s) * a + s * b, a), b);
}

taut_status taut_parts_parameter_lines(const taut_surface *surface, int count,
                                       const taut_camera *camera, taut_arena *arena,
                                       taut_scene *scene)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    double along[STEPS + 1];
    double *points = taut_arena_take(arena, STEPS + 1, 3 * sizeof(double));

    if (points == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int held = 0; held < 2; held++) {
        for (int i = 0; i <= STEPS; i++) {
            along[i] = parameter_at(bases[1 - held], i, STEPS);
        }
        for (int k = 1; k <= count; k++) {
            const double at = parameter_at(bases[held], k, count + 1);
            const taut_status status =
                held == 0 ? taut_surface_eval_grid(surface, 1, &at, STEPS + 1, along, 0, 1, points)
                          : taut_surface_eval_grid(surface, STEPS + 1, along, 1, &at, 0, 1, points);
            if (status != TAUT_OK) {
                return status;
            }
            for (int i = 0; i <= STEPS; i++) {
                taut_camera_project(camera, points + 3 * i, points + 3 * i);
            }
            taut_scene_line(scene, STEPS + 1, points, line_ink, line_width);
        }
    }
    return scene->status;
}
