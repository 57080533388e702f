#include "page/html_page.h"

#include "core/fail.h"
#include "draw/parts.h"
#include "draw/view.h"
#include "io/format.h"
#include "mesh/colour.h"

#include <math.h>
#include <string.h>

/* Vertices: of one surface, of all of a small model, of each of many, of all in the end; points of
 * nets; curves. 300 000 vertices are about 6 MB of page. */
enum {
    ONE_MAX = 10000,
    SMALL_ALL = 30000,
    EACH_MIN = 1500,
    ALL_MAX = 300000,
    NET_MAX = 60000,
    NET_ONE = 33 * 33, /* more lines than that hide the surface */
    CURVES_MAX = 200,
    VIEWED = 16
};

static int net_u(const taut_surface *s)
{
    return taut_basis_count(taut_surface_u(s));
}

static int net_v(const taut_surface *s)
{
    return taut_basis_count(taut_surface_v(s));
}

static int clamp(int x, int low, int high)
{
    return x < low ? low : x > high ? high : x;
}

static taut_status sample_curves(taut_page_model *p)
{
    taut_status status = TAUT_OK;

    p->curve_count =
        p->options->surface == NULL ? clamp(taut_model_curve_count(p->model), 0, CURVES_MAX) : 0;
    p->curves = taut_arena_take(p->arena, (size_t)p->curve_count, sizeof *p->curves);
    if (p->curves == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < p->curve_count && status == TAUT_OK; i++) {
        taut_page_curve *c = &p->curves[i];
        c->curve = taut_model_curve(p->model, i);
        status =
            taut_parts_sample_curve(c->curve, TAUT_PAGE_ALONG, p->arena, &c->count, &c->points);
    }
    return status;
}

static taut_status sample_model(taut_page_model *p)
{
    const int all = taut_model_surface_count(p->model);
    const taut_monitor *monitor = &p->options->monitor;
    int wanted = 0;

    for (int i = 0; i < all; i++) {
        wanted += taut_format_wants(p->model, p->options, i);
    }
    p->count = clamp(wanted, 0, ALL_MAX / 64);
    p->left_out = wanted - p->count;
    p->surfaces = taut_arena_take(p->arena, (size_t)p->count, sizeof *p->surfaces);
    if (p->surfaces == NULL) {
        return TAUT_NO_MEMORY;
    }
    const int share = p->count > 0 ? clamp(SMALL_ALL / p->count, EACH_MIN, ONE_MAX) : 0;
    const int each = p->count > 0 ? clamp(share, 16, ALL_MAX / p->count) : 0;
    for (int i = 0, k = 0; i < all && k < p->count; i++) {
        if (!taut_format_wants(p->model, p->options, i)) {
            continue;
        }
        const taut_status status =
            taut_page_sample(taut_model_surface(p->model, i), p->model, each, p->options->divide,
                             clamp(NET_MAX / p->count, 9, NET_ONE), p->options->threads, p->arena,
                             &p->surfaces[k++]);
        if (status != TAUT_OK) {
            return status;
        }
        if (monitor->progress != NULL &&
            monitor->progress(monitor->context, (double)k / p->count, "sampling") != 0) {
            return TAUT_INTERRUPTED;
        }
    }
    return sample_curves(p);
}

static void include_net(taut_page_model *p, size_t count, const double *points)
{
    if (taut_camera_is_far(&p->core, count, points)) {
        p->far_nets++;
    } else {
        taut_camera_include(&p->box, count, points);
    }
}

/* The box of all that is shown: surfaces and curves, and the nets near them. 0 where nothing is
 * finite. */
static int choose_box(taut_page_model *p)
{
    taut_camera_init(&p->core);
    for (int i = 0; i < p->count; i++) {
        const taut_page_surface *s = &p->surfaces[i];
        taut_camera_include(&p->core, (size_t)s->u.count * (size_t)s->v.count, s->points);
    }
    for (int i = 0; i < p->curve_count; i++) {
        taut_camera_include(&p->core, p->curves[i].count, p->curves[i].points);
    }
    if (!taut_camera_settle(&p->core)) {
        return 0;
    }
    p->box = p->core;
    for (int i = 0; i < p->count; i++) {
        const taut_surface *s = p->surfaces[i].surface;
        include_net(p, (size_t)net_u(s) * (size_t)net_v(s), taut_surface_points(s));
    }
    for (int i = 0; i < p->curve_count; i++) {
        const taut_curve *c = p->curves[i].curve;
        include_net(p, (size_t)taut_basis_count(taut_curve_t(c)), taut_curve_points(c));
    }
    return taut_camera_settle(&p->box);
}

/* The scale of each field over all surfaces, as in figures (mesh/colour.h). */
static taut_status choose_limits(taut_page_model *p)
{
    const double noise[TAUT_PAGE_FIELDS] = {
        1e-9 / p->box.half, 1e-9 / p->box.half / p->box.half, 1e-9, 1e-15, 1e-9, 0, 0};
    size_t count = 0;
    double *values = NULL;

    for (int i = 0; i < p->count; i++) {
        count += (size_t)p->surfaces[i].u.count * (size_t)p->surfaces[i].v.count;
    }
    values = taut_arena_take(p->arena, count, sizeof *values);
    for (int k = 0; values != NULL && k < TAUT_PAGE_FIELDS; k++) {
        size_t at = 0;
        for (int i = 0; i < p->count; i++) {
            const taut_page_surface *s = &p->surfaces[i];
            const size_t own = (size_t)s->u.count * (size_t)s->v.count;
            memcpy(values + at, s->fields[k], own * sizeof *values);
            at += own;
        }
        const double none = fmin(fmax(noise[k], 1e-290), 1e290);
        p->limits[k] = taut_colour_range(count, values, none, &p->cut[k], &p->sign[k]);
        p->sign[k] = k == TAUT_PAGE_I || k == TAUT_PAGE_GAP ? 1 : p->sign[k];
    }
    return values != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}

/* As a figure would be looked at. */
static taut_status choose_view(taut_page_model *p)
{
    static const taut_write_options plain;
    taut_sheet sheets[VIEWED];
    const int count = clamp(p->count, 0, VIEWED);

    memset(sheets, 0, sizeof sheets);
    memcpy(p->view, p->options->view, sizeof p->view);
    if (p->options->has_view) {
        return TAUT_OK;
    }
    for (int i = 0; i < count; i++) {
        const taut_status status =
            taut_sheet_new(p->surfaces[i].surface, 400, 4000, &plain, p->arena, &sheets[i]);
        if (status != TAUT_OK) {
            return status;
        }
    }
    taut_view_choose(&p->box, count, sheets, p->view);
    return TAUT_OK;
}

taut_status taut_page_prepare(taut_page_model *p, taut_error *error)
{
    taut_status status = sample_model(p);

    if (status != TAUT_OK) {
        return taut_fail_status(error, status);
    }
    if (!choose_box(p)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, 0, 1,
                         "there is nothing to show: no surface or curve has a finite point");
    }
    status = choose_limits(p);
    return taut_fail_status(error, status == TAUT_OK ? choose_view(p) : status);
}
