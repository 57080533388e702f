/* format_dxf.c -- the format `dxf`: the curves of a model where they are, or what is to be cut laid flat, 1:1: the panels of
 * `taut panels`, the laths of a net (io/dxf/r12.h).
 *
 * Curves are lines, polylines and splines, exactly where their bases are polynomial or rational, else within the tolerance (io/cad/prepare).
 * Panels stand in rows, u to the right and v upwards, one surface above the other, each named in its middle. */
#include "core/fail.h"
#include "io/cad/prepare.h"
#include "io/dxf/layers.h"
#include "io/dxf/panels.h"
#include "io/dxf/r12.h"
#include "io/dxf/read.h"
#include "io/flat/flat.h"
#include "io/format.h"
#include "io/mesh/out.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { PANELS, NAMES };

/* The gap between panels, and the height of their names, as shares of the largest one. */
static const double gap_share = 0.1, text_share = 0.05;

static int panels_along(const taut_basis *basis)
{
    return taut_basis_count(basis) - 1;
}

/* The largest sides of the boxes around the panels of a surface. */
static void measure_panels(const taut_surface *surface, double size[2])
{
    for (int i = 0; i < panels_along(taut_surface_u(surface)); i++) {
        for (int j = 0; j < panels_along(taut_surface_v(surface)); j++) {
            const taut_flat_panel panel = taut_lay_flat(surface, i, j);
            size[0] = fmax(size[0], panel.size[0]);
            size[1] = fmax(size[1], panel.size[1]);
        }
    }
}

/* One panel in the middle of its place, with its name. */
static void put_panel(taut_dxf *dxf, const taut_surface *surface, int i, int j,
                      const double place[2], const double size[2])
{
    char name[TAUT_NAME_MAX + 32];
    taut_flat_panel panel = taut_lay_flat(surface, i, j);
    double middle[2] = {0, 0};

    if (panel.count < 3) { /* no area */
        return;
    }
    for (int k = 0; k < panel.count; k++) {
        for (int c = 0; c < 2; c++) {
            panel.corners[k][c] += place[c] + (size[c] - panel.size[c]) / 2;
            middle[c] += panel.corners[k][c] / panel.count;
        }
    }
    snprintf(name, sizeof name, "%s %d,%d", taut_surface_name(surface), i + 1, j + 1);
    taut_dxf_outline(dxf, PANELS, name, (size_t)panel.count, &panel.corners[0][0], 0, 1);
    taut_dxf_text(dxf, NAMES, name, middle[0], middle[1], text_share * fmin(size[0], size[1]));
}

/* The panels of a surface from the height *bottom on, which goes up by them. */
static void put_surface(taut_dxf *dxf, const taut_surface *surface, double *bottom)
{
    const int nu = panels_along(taut_surface_u(surface));
    const int nv = panels_along(taut_surface_v(surface));
    double size[2] = {0, 0};
    measure_panels(surface, size);
    const double gap = gap_share * fmax(size[0], size[1]);
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const double place[2] = {i * (size[0] + gap), *bottom + j * (size[1] + gap)};
            put_panel(dxf, surface, i, j, place, size);
        }
    }
    *bottom += nv * (size[1] + gap) + 2 * gap;
}

static int count_panels(const taut_model *model, const taut_write_options *options)
{
    int count = 0;
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        count += taut_format_wants(model, options, i) && taut_is_panels(model, i);
    }
    return count;
}

static taut_status write_panels(const taut_model *model, const taut_write_options *options,
                                FILE *out, taut_error *error)
{
    static const taut_dxf_layer layers[] = {[PANELS] = {"panels", 7}, [NAMES] = {"names", 5}};
    double bottom = 0;
    taut_sink sink = taut_sink_to(out);
    taut_dxf dxf = taut_dxf_begin(&sink, taut_model_unit(model), 2, layers);
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        if (taut_format_wants(model, options, i) && taut_is_panels(model, i)) {
            put_surface(&dxf, taut_model_surface(model, i), &bottom);
        }
    }
    taut_dxf_end(&dxf);
    return taut_mesh_out_finish(&sink, error);
}

static taut_status put_curves(const taut_model *model, const taut_model *nurbs, FILE *out,
                              taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    taut_dxf_layers layers;
    if (taut_dxf_layers_of(model, arena, &layers) != TAUT_OK) {
        taut_arena_free(arena);
        return taut_fail_memory(error);
    }
    taut_sink sink = taut_sink_to(out);
    taut_dxf dxf = taut_dxf_begin(&sink, taut_model_unit(model), layers.count, layers.layers);
    for (int i = 0; i < taut_model_curve_count(nurbs); i++) {
        taut_dxf_curve(&dxf, layers.of[i], taut_model_curve(nurbs, i));
    }
    taut_dxf_end(&dxf);
    const taut_status status = taut_mesh_out_finish(&sink, error);
    taut_arena_free(arena);
    return status;
}

/* A model of the curves of another one alone. */
static taut_status copy_curves(const taut_model *model, taut_model *curves)
{
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        taut_curve *curve = NULL;
        if (taut_curve_copy(taut_model_curve(model, i), &curve) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        if (taut_model_add_curve(curves, curve) != TAUT_OK) {
            taut_curve_free(curve);
            return TAUT_NO_MEMORY;
        }
    }
    return taut_model_set_unit(curves, taut_model_unit(model));
}

static taut_status write_curves(const taut_model *model, const taut_write_options *options,
                                FILE *out, taut_error *error)
{
    taut_write_options all = *options;
    taut_model *curves = NULL, *nurbs = NULL;
    taut_cad_facts facts;
    all.surface = NULL; /* the curves are of the whole */
    all.thickness = 0;
    taut_status status = taut_model_new(&curves);
    if (status == TAUT_OK) {
        status = copy_curves(model, curves);
    }
    status = status == TAUT_OK ? taut_cad_prepare(curves, &all, NULL, &nurbs, &facts, error)
                               : taut_fail_memory(error);
    if (status == TAUT_OK) {
        status = put_curves(model, nurbs, out, error);
    }
    if (status == TAUT_OK && options->bound != NULL) {
        *options->bound = facts.bound;
    }
    taut_model_free(nurbs);
    taut_model_free(curves);
    return status;
}

/* Pieces that keep angles are no cloth. */
static int is_print(const taut_model *model)
{
    const taut_record *way = taut_record_get(taut_model_details(model), "flatten");
    return strcmp(taut_record_text(way), "conformal") == 0;
}

static taut_status write_dxf(const taut_model *model, const taut_write_options *options, FILE *out,
                             taut_error *error)
{
    if (count_panels(model, options) > 0) {
        return write_panels(model, options, out, error);
    }
    if (taut_flat_is(model)) {
        return is_print(model)
                   ? taut_fail(error, TAUT_NO_SOLUTION, "no-drawing", "/details/flatten", taut_none,
                               taut_none,
                               "found pieces that are laid flat by angles, for prints, expected "
                               "ones to cut cloth by: write .svg or .pdf, or leave out \"flatten\"")
                   : taut_r12_write(model, out, error);
    }
    if (taut_model_curve_count(model) > 0) {
        return write_curves(model, options, out, error);
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "no-drawing", NULL, 0, 1,
                     "the model has no curves and no panels to draw: DXF holds the curves of nets, "
                     "films and pipes, and what `taut panels` makes");
}

const taut_format_ops taut_format_dxf = {.write = write_dxf, .read = taut_dxf_read};
