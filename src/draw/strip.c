/* strip.c -- each frame keeps its size; cells of one width and height, in as many columns as show
 * them largest, left to right and top to bottom. */
#include "draw/strip.h"

#include "core/arena.h"
#include "draw/camera.h"
#include "taut/operate.h"

#include <math.h>
#include <stdio.h>

enum { GRID = 16 };
static const double page[2] = {900, 760};          /* what the page has for them */
static const double azimuth = -60, elevation = 35; /* as in view.h */
static const double gap = 1.12;                    /* cells over what is in them */

/* A frame on the page: its box along right and up. */
typedef struct frame {
    double low[2], high[2];
} frame;

int taut_strip_is(const taut_model *model, const taut_write_options *options)
{
    const taut_record *list = taut_record_get(taut_model_details(model), "lambda");
    return options->surface == NULL && taut_model_surface_count(model) > 1 &&
           taut_model_curve_count(model) == 0 && taut_record_kind_of(list) == TAUT_RECORD_LIST &&
           taut_record_count(list) == (size_t)taut_model_surface_count(model);
}

static void widen(const taut_camera *camera, const double *x, frame *f)
{
    const double *const axes[2] = {camera->right, camera->up};
    for (int d = 0; d < 2; d++) {
        const double at = x[0] * axes[d][0] + x[1] * axes[d][1] + x[2] * axes[d][2];
        if (isfinite(at)) {
            f->low[d] = fmin(f->low[d], at);
            f->high[d] = fmax(f->high[d], at);
        }
    }
}

static double place(const taut_basis *basis, int k)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    return k == GRID ? hi : lo + (hi - lo) * k / GRID;
}

static void frame_of(const taut_surface *s, const taut_camera *camera, int net, frame *f)
{
    const taut_basis *u = taut_surface_u(s), *v = taut_surface_v(s);
    const long points = (long)taut_basis_count(u) * taut_basis_count(v);

    *f = (frame){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int k = 0; k < (GRID + 1) * (GRID + 1); k++) {
        double x[3];
        if (taut_surface_eval(s, place(u, k / (GRID + 1)), place(v, k % (GRID + 1)), 0, x) ==
            TAUT_OK) {
            widen(camera, x, f);
        }
    }
    for (long k = 0; net && k < points; k++) {
        widen(camera, taut_surface_points(s) + 3 * k, f);
    }
}

/* The columns that leave the cells largest. */
static int columns_of(int count, const double cell[2])
{
    int best = 1;
    double largest = 0;
    for (int columns = 1; columns <= count; columns++) {
        const int rows = (count + columns - 1) / columns;
        const double scale = fmin(page[0] / (columns * cell[0]), page[1] / (rows * cell[1]));
        if (scale > largest) {
            largest = scale;
            best = columns;
        }
    }
    return best;
}

/* One frame, moved so that the middle of its box comes to `to` on the page. */
static taut_status add_frame(const taut_surface *s, const frame *f, const double to[2],
                             const taut_camera *camera, double lambda, taut_model *strip)
{
    const double by[2] = {to[0] - 0.5 * (f->low[0] + f->high[0]),
                          to[1] - 0.5 * (f->low[1] + f->high[1])};
    double matrix[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    char name[48];
    taut_surface *moved = NULL, *named = NULL;
    taut_status status = TAUT_OK;

    for (int c = 0; c < 3; c++) {
        matrix[c][3] = by[0] * camera->right[c] + by[1] * camera->up[c];
    }
    snprintf(name, sizeof name, "lambda %.4g", lambda);
    status = taut_surface_transform(s, &matrix[0][0], &moved, NULL);
    if (status == TAUT_OK) {
        status =
            taut_surface_new(name, taut_surface_u(moved), taut_surface_v(moved),
                             taut_surface_points(moved), taut_surface_weights(moved), &named, NULL);
    }
    taut_surface_free(moved);
    if (status == TAUT_OK) {
        status = taut_model_add_surface(strip, named);
        if (status != TAUT_OK) {
            taut_surface_free(named);
        }
    }
    return status;
}

static taut_status add_frames(const taut_model *model, const frame *frames,
                              const taut_camera *camera, taut_model *strip)
{
    const taut_record *lambda = taut_record_get(taut_model_details(model), "lambda");
    const int count = taut_model_surface_count(model);
    double cell[2] = {0, 0};
    taut_status status = taut_model_set_unit(strip, taut_model_unit(model));

    for (int i = 0; i < count; i++) {
        for (int d = 0; d < 2; d++) {
            cell[d] = fmax(cell[d], gap * (frames[i].high[d] - frames[i].low[d]));
        }
    }
    if (!(cell[0] > 0) || !(cell[1] > 0)) {
        return TAUT_BAD_ARGUMENT;
    }
    const int columns = columns_of(count, cell);
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        const double to[2] = {cell[0] * (i % columns), -cell[1] * (double)(i / columns)};
        status = add_frame(taut_model_surface(model, i), &frames[i], to, camera,
                           taut_record_number(taut_record_at(lambda, (size_t)i)), strip);
    }
    return status;
}

taut_status taut_strip_new(const taut_model *model, taut_write_options *options, taut_model **strip)
{
    const int count = taut_model_surface_count(model);
    taut_arena *arena = taut_arena_new();
    frame *frames = arena != NULL ? taut_arena_take(arena, (size_t)count, sizeof *frames) : NULL;
    taut_model *made = NULL;
    taut_camera camera;
    taut_status status = frames != NULL ? taut_model_new(&made) : TAUT_NO_MEMORY;

    if (!options->has_view) {
        options->has_view = 1;
        options->view[0] = azimuth;
        options->view[1] = elevation;
    }
    taut_camera_init(&camera);
    taut_camera_aim(&camera, options->view[0], options->view[1]);
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        frame_of(taut_model_surface(model, i), &camera, !options->no_net, &frames[i]);
    }
    if (status == TAUT_OK) {
        status = add_frames(model, frames, &camera, made);
    }
    taut_arena_free(arena);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *strip = made;
    return TAUT_OK;
}
