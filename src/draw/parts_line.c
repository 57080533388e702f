/* parts_line.c -- control nets and curves. */
#include "core/elementary/elementary.h"
#include "draw/parts.h"

#include <math.h>
#include <stdint.h>

enum { LINES_SHOWN = 33, POINTS_ALONG = 132 };

static const taut_ink net_ink = {68, 74, 90}, faint_ink = {112, 126, 152};
static const taut_ink point_ink = {250, 250, 250}, point_rim = {60, 66, 82};

/* Of `count` points in one direction every `line`-th has a line across, and a line along runs
 * through every `point`-th; `line` is a multiple of `point`. The last counts too. */
typedef struct thinning {
    int point, line;
} thinning;

static thinning thinning_of(int count)
{
    thinning t = {(count + POINTS_ALONG - 1) / POINTS_ALONG, 0};
    const int points = (count + t.point - 1) / t.point;
    t.line = t.point * ((points + LINES_SHOWN - 1) / LINES_SHOWN);
    return t;
}

/* The step that starts at i: to i + step, or to the last point. */
static int next_line(int i, int step, int count)
{
    return i + step < count || i == count - 1 ? i + step : count - 1;
}

/* A net lies near its surface, within a part of its own gaps: so far behind it is not hidden, so
 * that a line that runs along the surface is not torn where it dips below. */
typedef struct net_style {
    double width, slack;
} net_style;

/* The lines along one direction: `along` points `stride` apart, `across` lines `stride_across`
 * apart. row: double[along][3]. */
static void add_net_lines(int along, size_t stride, int across, size_t stride_across,
                          const double *points, const taut_camera *camera, const net_style *style,
                          double *row, taut_scene *scene)
{
    const int step_along = thinning_of(along).point, step_across = thinning_of(across).line;
    for (int j = 0; j < across; j = next_line(j, step_across, across)) {
        size_t count = 0;
        for (int i = 0; i < along; i = next_line(i, step_along, along)) {
            taut_camera_project(camera, points + (size_t)i * stride + (size_t)j * stride_across,
                                row + 3 * count++);
        }
        taut_scene_line_through(scene, count, row, net_ink, faint_ink, style->width, style->slack);
    }
}

int taut_parts_net_is_whole(int nu, int nv)
{
    return thinning_of(nu).line == 1 && thinning_of(nv).line == 1;
}

/* How large the points are drawn: 0.03 of the mean distance between them, as if they were spread
 * evenly over the diagonal of what the net takes of the page, from 1.4 to 4.2 page units. */
static double point_radius(size_t count, const double *points, const taut_camera *camera)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (size_t i = 0; i < count; i++) {
        double at[3];
        taut_camera_project(camera, points + 3 * i, at);
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], at[c]);
            high[c] = fmax(high[c], at[c]);
        }
    }
    const double size = taut_hypot(high[0] - low[0], high[1] - low[1]);
    return fmin(fmax(0.03 * size / (sqrt((double)count) - 0.5), 1.4), 4.2);
}

taut_status taut_parts_net(int nu, int nv, const double *points, const taut_camera *camera,
                           taut_arena *arena, taut_scene *scene)
{
    const size_t row = 3 * (size_t)nv, count = (size_t)nu * (size_t)nv;
    const double radius = point_radius(count, points, camera); /* 0.03 of the gaps */
    const net_style style = {fmax(0.3 * radius, 0.6), fmin(1.5 + 5 * radius, 8)};
    double *page = taut_arena_take(arena, (size_t)(nu > nv ? nu : nv), 3 * sizeof(double));

    if (page == NULL) {
        return TAUT_NO_MEMORY;
    }
    add_net_lines(nv, 3, nu, row, points, camera, &style, page, scene);
    if (nu > 1) {
        add_net_lines(nu, row, nv, 3, points, camera, &style, page, scene);
    }
    return scene->status;
}

void taut_parts_net_points(int nu, int nv, const double *points, const taut_camera *camera,
                           taut_scene *scene)
{
    const size_t count = (size_t)nu * (size_t)nv;
    const double radius = point_radius(count, points, camera);
    for (size_t i = 0; i < count && taut_parts_net_is_whole(nu, nv); i++) {
        double at[3];
        taut_camera_project(camera, points + 3 * i, at);
        taut_scene_disc(scene, at, point_ink, point_rim, radius);
    }
}

taut_status taut_parts_curve(size_t count, const double *points, const taut_camera *camera,
                             taut_ink ink, taut_arena *arena, taut_scene *scene)
{
    double *page = taut_arena_take(arena, count, 3 * sizeof(double));
    if (page == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        taut_camera_project(camera, points + 3 * i, page + 3 * i);
    }
    taut_scene_line(scene, count, page, ink, 3);
    return scene->status;
}

taut_status taut_parts_sample_curve(const taut_curve *curve, int most, taut_arena *arena,
                                    size_t *count, double **points)
{
    const taut_basis *basis = taut_curve_t(curve);
    const int spans = taut_basis_span_count(basis);
    const double *breaks = taut_basis_breaks(basis);
    const int per = most > spans ? (most + spans - 1) / spans : 1;
    const int steps = most > spans ? per * spans : most;
    taut_status status = TAUT_OK;

    *count = (size_t)steps + 1;
    *points = taut_arena_take(arena, *count, 3 * sizeof(double));
    if (*points == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i <= steps && status == TAUT_OK; i++) {
        const int span = most > spans ? i / per : (int)((int64_t)i * spans / steps);
        const double s = (double)(i % per) / per;
        const double t =
            i % per == 0 ? breaks[span]
                         : fmin(fmax((1 - s) * breaks[span] + s * breaks[span + 1], breaks[span]),
                                breaks[span + 1]);
        status = taut_curve_eval(curve, t, 0, *points + 3 * i);
    }
    return status;
}
