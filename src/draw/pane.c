#include "draw/pane.h"

#include "core/elementary/elementary.h"
#include "geometry/whole.h"
#include "mesh/colour.h"

#include <math.h>
#include <string.h>

static int net_u(const taut_surface *s)
{
    return taut_basis_count(taut_surface_u(s));
}

static int net_v(const taut_surface *s)
{
    return taut_basis_count(taut_surface_v(s));
}

int taut_pane_shows(const taut_pane *pane, const taut_write_options *options, int i)
{
    return pane->surface >= 0 ? pane->surface == i
                              : taut_model_shows(pane->model, options->surface, i);
}

/* Flat pieces are strained along the threads that they have where they are made. */
static taut_status sample_film(const taut_pane *pane, const taut_write_options *options, int i,
                               taut_arena *arena, taut_sheet *sheet)
{
    const taut_model *own = pane->own != NULL ? pane->own : pane->model;
    const taut_surface *shown = sheet->surface;
    sheet->surface = taut_model_surface(own, i);
    const taut_status status = taut_sheet_film(options, own, arena, sheet);
    sheet->surface = shown;
    return status;
}

static taut_status sample_surface(taut_pane *pane, const taut_write_options *options, int i,
                                  int cells, int most, taut_arena *arena)
{
    taut_sheet *sheet = &pane->sheets[pane->sheet_count++];
    const taut_status status =
        taut_sheet_new(taut_model_surface(pane->model, i), cells, most, options, arena, sheet);
    if (status == TAUT_OK && options->colour >= TAUT_COLOUR_GAP) {
        return sample_film(pane, options, i, arena, sheet);
    }
    return status == TAUT_OK && options->isolines > 0 && options->colour != TAUT_COLOUR_PLAIN
               ? taut_sheet_corners(options, arena, sheet)
               : status;
}

static taut_status sample_surfaces(taut_pane *pane, const taut_write_options *options, int cells,
                                   int most, taut_arena *arena)
{
    taut_status status = TAUT_OK;
    for (int i = 0; i < taut_model_surface_count(pane->model) && status == TAUT_OK; i++) {
        if (taut_pane_shows(pane, options, i)) {
            status = sample_surface(pane, options, i, cells, most, arena);
        }
    }
    return status;
}

/* The curves belong to the whole model: one surface alone is shown without. */
static taut_status sample_curves(taut_pane *pane, const taut_write_options *options, int along,
                                 taut_arena *arena)
{
    const int count =
        options->surface == NULL && pane->surface < 0 ? taut_model_curve_count(pane->model) : 0;
    taut_status status = TAUT_OK;

    pane->curves = taut_arena_take(arena, (size_t)count, sizeof *pane->curves);
    if (pane->curves == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        taut_polyline *line = &pane->curves[pane->curve_count++];
        line->curve = taut_model_curve(pane->model, i);
        status = taut_parts_sample_curve(line->curve, count > 1000 ? 16 : along, arena,
                                         &line->count, &line->points);
    }
    return status;
}

/* The diagonal of the box of the surfaces. */
static double size_of_sheets(const taut_pane *pane)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};

    for (int i = 0; i < pane->sheet_count; i++) {
        const taut_sheet *s = &pane->sheets[i];
        for (size_t k = 0; k < 3 * (size_t)s->u.count * (size_t)s->v.count; k++) {
            low[k % 3] = fmin(low[k % 3], s->points[k]);
            high[k % 3] = fmax(high[k % 3], s->points[k]);
        }
    }
    return taut_hypot(taut_hypot(high[0] - low[0], high[1] - low[1]), high[2] - low[2]);
}

/* The longest tooth is an eighth of the size. */
static taut_status sample_combs(taut_pane *pane, taut_arena *arena)
{
    const double size = size_of_sheets(pane);
    taut_status status = TAUT_OK;

    pane->combs = taut_arena_take(arena, (size_t)pane->sheet_count, sizeof *pane->combs);
    if (pane->combs == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < pane->sheet_count && status == TAUT_OK; i++) {
        status = taut_combs_fill(pane->sheets[i].surface, &pane->combs[i], &pane->comb_most);
    }
    const int bends = pane->comb_most * size > 1e-9 && isfinite(pane->comb_most * size);
    pane->comb_scale = bends ? size / 8 / pane->comb_most : 0;
    for (int i = 0; i < pane->sheet_count && status == TAUT_OK; i++) {
        taut_combs_scale(&pane->combs[i], pane->comb_scale);
    }
    return status;
}

/* The longest arrow is an eighth of the size. */
static void sample_arrows(taut_pane *pane)
{
    const double size = size_of_sheets(pane);
    const int is_alone = pane->sheet_count == 1;

    taut_arrows_fill(pane->model, is_alone ? pane->sheets[0].surface : NULL, &pane->arrows,
                     &pane->arrow_most);
    pane->arrow_scale = pane->arrow_most > 0 ? size / 8 / pane->arrow_most : 0;
    pane->arrow_scale = isfinite(pane->arrow_scale) ? pane->arrow_scale : 0;
    taut_arrows_scale(&pane->arrows, pane->arrow_scale);
}

taut_status taut_pane_sample(taut_pane *pane, const taut_write_options *options, int cells,
                             int most, int along, taut_arena *arena)
{
    int shown = 0;
    taut_status status = TAUT_OK;

    for (int i = 0; i < taut_model_surface_count(pane->model); i++) {
        shown += taut_pane_shows(pane, options, i);
    }
    pane->sheets = taut_arena_take(arena, (size_t)shown, sizeof *pane->sheets);
    pane->pages = taut_arena_take(arena, (size_t)shown, sizeof *pane->pages);
    if (pane->sheets == NULL || pane->pages == NULL) {
        return TAUT_NO_MEMORY;
    }
    status = sample_surfaces(pane, options, cells, most, arena);
    if (status != TAUT_OK) {
        return status;
    }
    if (options->reactions && pane->sheet_count > 0) {
        sample_arrows(pane);
    }
    status = sample_curves(pane, options, along, arena);
    return status == TAUT_OK && options->combs ? sample_combs(pane, arena) : status;
}

/* The net of sheet i, or, from sheet_count on, the polygon of a curve. */
typedef struct net {
    int nu, nv;
    const double *points;
} net;

static net net_of(const taut_pane *pane, int i)
{
    if (i < pane->sheet_count) {
        const taut_surface *s = pane->sheets[i].surface;
        return (net){net_u(s), net_v(s), taut_surface_points(s)};
    }
    const taut_curve *c = pane->curves[i - pane->sheet_count].curve;
    return (net){1, taut_basis_count(taut_curve_t(c)), taut_curve_points(c)};
}

static size_t size_of(net n)
{
    return (size_t)n.nu * (size_t)n.nv;
}

/* Unless it is asked for, pipes are shown without: their nets are far off, and say nothing of them; and films, traces and patterns,
 * whose nets nobody has chosen, dense enough to hide them. */
static int has_nets(const taut_pane *pane, const taut_write_options *options)
{
    const taut_certificate *certificate = taut_model_certificate(pane->model);
    const char *name = certificate != NULL ? taut_certificate_construct(certificate) : "";
    static const char *const without[] = {"pipe", "film", "trace", "pattern"};
    int shows = options->no_net == 0;
    for (int k = 0; k < 4; k++) {
        shows = shows && strcmp(name, without[k]) != 0;
    }
    return options->no_net < 0 || shows;
}

static int draws_net(const taut_pane *pane, const taut_write_options *options, int i)
{
    const net n = net_of(pane, i);
    return has_nets(pane, options) && !taut_camera_is_far(&pane->core, size_of(n), n.points);
}

int taut_pane_nets(const taut_pane *pane, const taut_write_options *options)
{
    return has_nets(pane, options) ? pane->sheet_count + pane->curve_count : 0;
}

int taut_pane_far_nets(const taut_pane *pane, const taut_write_options *options)
{
    int far = 0;
    for (int i = 0; i < taut_pane_nets(pane, options); i++) {
        far += !draws_net(pane, options, i);
    }
    return far;
}

void taut_pane_visit_core(const taut_pane *pane, taut_camera *camera,
                          void (*visit)(taut_camera *, size_t, const double *))
{
    for (int i = 0; i < pane->sheet_count; i++) {
        const taut_sheet *s = &pane->sheets[i];
        visit(camera, (size_t)s->u.count * (size_t)s->v.count, s->points);
        if (pane->combs != NULL) {
            visit(camera, (size_t)4 * TAUT_COMB_TEETH, &pane->combs[i].tip[0][0][0]);
        }
    }
    visit(camera, (size_t)pane->arrows.count, pane->arrows.tail[0]);
    for (int i = 0; i < pane->curve_count; i++) {
        visit(camera, pane->curves[i].count, pane->curves[i].points);
    }
}

void taut_pane_visit_nets(const taut_pane *pane, const taut_write_options *options,
                          taut_camera *camera, void (*visit)(taut_camera *, size_t, const double *))
{
    for (int i = 0; i < taut_pane_nets(pane, options); i++) {
        const net n = net_of(pane, i);
        if (draws_net(pane, options, i)) {
            visit(camera, size_of(n), n.points);
        }
    }
}

static const char *sheet_name(const void *of, int i)
{
    return taut_surface_name(((const taut_pane *)of)->sheets[i].surface);
}

static const char *curve_name(const void *of, int i)
{
    return taut_curve_name(((const taut_pane *)of)->curves[i].curve);
}

/* One surface alone is the first colour, where it has none of its own. */
int taut_pane_sheet_colour(const taut_pane *pane, int i)
{
    int k = 0;
    while (k < taut_model_surface_count(pane->model) &&
           taut_model_surface(pane->model, k) != pane->sheets[i].surface) {
        k++;
    }
    const int said = taut_colour_said(pane->model, k);
    return said >= 0            ? said
           : pane->surface >= 0 ? 0
                                : taut_colour_group(sheet_name, pane, pane->sheet_count, i);
}

int taut_pane_curve_colour(const taut_pane *pane, int i)
{
    return taut_colour_group(curve_name, pane, pane->curve_count, i);
}

taut_status taut_pane_add_cells(taut_pane *pane, const taut_write_options *options, double limit,
                                taut_arena *arena, taut_scene *scene)
{
    taut_status status = TAUT_OK;
    for (int i = 0; i < pane->sheet_count && status == TAUT_OK; i++) {
        taut_sheet *sheet = &pane->sheets[i];
        const int colour = taut_pane_sheet_colour(pane, i);
        if (options->reflections > 0) {
            status = taut_sheet_stripes(options, &pane->camera, arena, sheet);
            if (status != TAUT_OK) {
                return status;
            }
        }
        status = taut_parts_cells(sheet, &pane->camera, taut_colour_plain(colour), limit, arena,
                                  scene, &pane->pages[i]);
    }
    return status;
}

/* Knot lines say nothing beside a net so dense that it lies in the surface, and little beside other
 * lines. */
static int has_knot_lines(const taut_pane *pane, const taut_write_options *options, int i)
{
    const taut_surface *s = pane->sheets[i].surface;
    return options->isolines == 0 && options->reflections == 0 &&
           (!draws_net(pane, options, i) || taut_parts_net_is_whole(net_u(s), net_v(s)));
}

static taut_status add_isolines(const taut_pane *pane, const taut_write_options *options, int i,
                                double limit, taut_arena *arena, taut_scene *scene)
{
    const int count = options->isolines;
    const taut_sheet *sheet = &pane->sheets[i];
    if (options->colour == TAUT_COLOUR_PLAIN) {
        return taut_parts_parameter_lines(sheet->surface, count, &pane->camera, arena, scene);
    }
    const int first = taut_sheet_has_signs(options->colour) ? -count : 0;
    const taut_status status =
        taut_parts_isolines(sheet, pane->pages[i], limit / count, first, count, scene);
    return status == TAUT_OK ? taut_parts_isoline_names(sheet, pane->pages[i], limit / count, first,
                                                        count, limit, scene)
                             : status;
}

static taut_status add_lines(const taut_pane *pane, const taut_write_options *options, int i,
                             double limit, taut_arena *arena, taut_scene *scene)
{
    const taut_sheet *sheet = &pane->sheets[i];
    const taut_surface *s = sheet->surface;
    taut_status status = taut_parts_silhouette(sheet, pane->pages[i], arena, scene);

    if (status == TAUT_OK && has_knot_lines(pane, options, i)) {
        const taut_ink ink = taut_colour_plain(taut_pane_sheet_colour(pane, i));
        status = taut_parts_outline(sheet, pane->pages[i], 0, ink, arena, scene);
    }
    if (status == TAUT_OK && options->isolines > 0) {
        status = add_isolines(pane, options, i, limit, arena, scene);
    }
    if (status == TAUT_OK && pane->combs != NULL && pane->comb_scale > 0) {
        status = taut_combs_add(&pane->combs[i], &pane->camera, scene);
    }
    if (status == TAUT_OK && draws_net(pane, options, i)) {
        status =
            taut_parts_net(net_u(s), net_v(s), taut_surface_points(s), &pane->camera, arena, scene);
    }
    return status;
}

/* The boundaries last: they must not be paler where a net runs along them. */
taut_status taut_pane_add_lines(taut_pane *pane, const taut_write_options *options, double limit,
                                taut_arena *arena, taut_scene *scene)
{
    taut_status status = TAUT_OK;
    for (int i = 0; i < pane->sheet_count && status == TAUT_OK; i++) {
        status = add_lines(pane, options, i, limit, arena, scene);
    }
    for (int i = 0; i < pane->sheet_count && status == TAUT_OK; i++) {
        status =
            taut_parts_outline(&pane->sheets[i], pane->pages[i], 1,
                               taut_colour_plain(taut_pane_sheet_colour(pane, i)), arena, scene);
    }
    return status == TAUT_OK ? taut_arrows_add(&pane->arrows, &pane->camera, scene) : status;
}

/* On the page, of the strokes from number `first` on. */
static double length_since(const taut_scene *scene, size_t first)
{
    double length = 0;
    for (size_t i = first; i < scene->stroke_count; i++) {
        const taut_stroke *s = &scene->strokes[i];
        for (size_t k = s->first; k + 1 < s->first + (size_t)s->count; k++) {
            const double(*xy)[2] = (const double(*)[2])(scene->points + k);
            length += taut_hypot(xy[1][0] - xy[0][0], xy[1][1] - xy[0][1]);
        }
    }
    return length;
}

static double length_of(const taut_polyline *line, const taut_camera *camera)
{
    double length = 0, last[3], at[3];
    for (size_t i = 0; i < line->count; i++) {
        taut_camera_project(camera, line->points + 3 * i, at);
        const double piece = i > 0 ? taut_hypot(at[0] - last[0], at[1] - last[1]) : 0;
        length += isfinite(piece) ? piece : 0;
        memcpy(last, at, sizeof last);
    }
    return length;
}

static const double near_enough = 0.25; /* in page units: what is a surface is not hidden by it */

/* The middle of a cell; not finite where a corner is not. */
static void middle_of(const double *const corner[4], double at[3])
{
    for (int c = 0; c < 3; c++) {
        at[c] = (corner[0][c] + corner[1][c] + corner[2][c] + corner[3][c]) / 4;
    }
}

/* Is one of a hundred of its cells or more the nearest, at the middle? Of a cap at the far end of a pipe, whose edge is the pipe's,
 * cells beside that edge come near. */
static int is_seen(const taut_sheet *sheet, const double *page, const taut_depth *depth)
{
    const size_t nu = (size_t)sheet->u.count, nv = (size_t)sheet->v.count;
    size_t seen = 0;
    for (size_t i = 0; i + 1 < nu; i++) {
        for (size_t j = 0; j + 1 < nv; j++) {
            const double *at = page + 3 * (i * nv + j);
            double middle[3];
            middle_of((const double *const[4]){at, at + 3, at + 3 * nv, at + 3 * nv + 3}, middle);
            seen += isfinite(middle[0]) && isfinite(middle[1]) && isfinite(middle[2]) &&
                    middle[2] + near_enough >= taut_depth_at(depth, middle[0], middle[1]);
        }
    }
    return 100 * seen >= (nu - 1) * (nv - 1);
}

static int is_axis(const taut_polyline *line)
{
    return strncmp(taut_curve_name(line->curve), "axis", 4) == 0;
}

/* An axis runs within its pipe: what an open end shows of it is a scratch, no line. */
static int is_within(const taut_pane *pane, const taut_polyline *line)
{
    return pane->sheet_count > 0 && !line->is_seen && is_axis(line);
}

taut_status taut_pane_add_curves(taut_pane *pane, const taut_write_options *options,
                                 taut_arena *arena, taut_scene *scene)
{
    taut_status status = TAUT_OK;
    for (int i = 0; i < pane->sheet_count; i++) {
        pane->sheets[i].is_seen = is_seen(&pane->sheets[i], pane->pages[i], &scene->depth);
    }
    for (int i = 0; i < pane->curve_count && status == TAUT_OK; i++) {
        taut_polyline *line = &pane->curves[i];
        const size_t before = scene->stroke_count;
        status = taut_parts_curve(line->count, line->points, &pane->camera,
                                  taut_colour_curve(taut_pane_curve_colour(pane, i)), arena, scene);
        line->is_seen = length_since(scene, before) >
                        (is_axis(line) ? 0.2 : 0.02) * length_of(line, &pane->camera);
        scene->stroke_count = is_within(pane, line) ? before : scene->stroke_count;
        if (status == TAUT_OK && draws_net(pane, options, pane->sheet_count + i)) {
            status = taut_parts_net(1, taut_basis_count(taut_curve_t(line->curve)),
                                    taut_curve_points(line->curve), &pane->camera, arena, scene);
        }
    }
    for (int i = 0; i < taut_pane_nets(pane, options); i++) {
        const net n = net_of(pane, i);
        if (draws_net(pane, options, i)) {
            taut_parts_net_points(n.nu, n.nv, n.points, &pane->camera, scene);
        }
    }
    if (status == TAUT_OK && pane->curve_count > 0) { /* with the curves of a net its nodes */
        status = taut_parts_nodes(pane->model, &pane->camera, scene);
    }
    return status == TAUT_OK ? scene->status : status;
}
