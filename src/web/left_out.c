/* left_out.c -- what the module does not have: formats that stand on something that is not there, or that nobody asks a page
 * for, and files. */
#include "certify/certify_ops.h"
#include "certify/film/complex/complex.h"
#include "certify/film/complex/told.h"
#include "construct/construct_ops.h"
#include "construct/film/complex/complex.h"
#include "core/fail.h"
#include "draw/flat_page.h"
#include "io/cad/cad.h"
#include "io/flat/cloth.h"
#include "io/flat/spread.h"
#include "io/format.h"
#include "io/mesh/cloth.h"
#include "io/problem/boundary_file.h"
#include "io/problem/document_ops.h"
#include "io/problem/film_along.h"
#include "io/problem/film_curves.h"
#include "io/problem/film_patches.h"
#include "io/step/assembly.h"
#include "measure/cloth/mounted.h"
#include "mesh/parts.h"

static taut_status write_nothing(const taut_model *model, const taut_write_options *options,
                                 FILE *out, taut_error *error)
{
    (void)model;
    (void)options;
    (void)out;
    return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
                     "this format is not written in the browser: write json, and let the program "
                     "`taut convert` make the file of it");
}

const taut_format_ops taut_format_html = {.write = write_nothing};
const taut_format_ops taut_format_iges = {.write = write_nothing};
const taut_format_ops taut_format_csv = {.write = write_nothing};
const taut_format_ops taut_format_geomdl = {.write = write_nothing};
const taut_format_ops taut_format_dxf = {.write = write_nothing};
const taut_format_ops taut_format_threemf = {.write = write_nothing};

taut_status taut_mesh_thicken(const taut_mesh *thin, const taut_model *model, double thickness,
                              int threads, taut_mesh *thick, taut_error *error)
{
    (void)thin;
    (void)model;
    (void)thickness;
    (void)threads;
    (void)thick;
    return taut_fail(
        error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
        "surfaces are not made thick in the browser: let the program `taut convert` do it");
}

taut_status taut_cad_make_sheets(const taut_write_options *options, double tolerance,
                                 taut_arena *arena, taut_model **nurbs, taut_cad_facts *facts,
                                 taut_error *error)
{
    (void)tolerance;
    (void)arena;
    (void)nurbs;
    (void)facts;
    return taut_mesh_thicken(NULL, NULL, options->thickness, 0, NULL, error);
}

/* All as one part. */
taut_status taut_step_list_parts(const taut_model *nurbs, const taut_cad_facts *facts,
                                 taut_arena *arena, int *count, taut_step_part **parts,
                                 double *moved)
{
    *parts = taut_arena_take(arena, 1, sizeof **parts);
    *count = 1;
    *moved = 0;
    if (*parts == NULL) {
        return TAUT_NO_MEMORY;
    }
    **parts = (taut_step_part){.name = facts->name, .model = nurbs};
    return TAUT_OK;
}

void taut_step_put_places(taut_part21 *out, int count, taut_step_part *parts, size_t *places)
{
    (void)out;
    (void)count;
    (void)parts;
    (void)places;
}

void taut_step_put_uses(taut_part21 *out, int count, const taut_step_part *parts,
                        const taut_step_spaces *spaces)
{
    (void)out;
    (void)count;
    (void)parts;
    (void)spaces;
}

taut_status taut_step_check_bodies(const taut_model *nurbs, const taut_shells *shells,
                                   taut_error *error)
{
    (void)nurbs;
    (void)shells;
    (void)error;
    return TAUT_OK;
}

taut_status taut_step_check_edges(const taut_model *nurbs, const taut_shells *shells,
                                  taut_error *error)
{
    (void)nurbs;
    (void)shells;
    (void)error;
    return TAUT_OK;
}

taut_status taut_step_find_hollows(const taut_cad_facts *facts, const taut_shells *shells,
                                   taut_arena *arena, int **outside)
{
    (void)facts;
    *outside = taut_arena_take(arena, (size_t)shells->face_count, sizeof **outside);
    for (int f = 0; *outside != NULL && f < shells->face_count; f++) {
        (*outside)[f] = -1;
    }
    return *outside != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}

/* No model here was read from such a file. */
taut_status taut_cad_keep_looks(const taut_model *model, const taut_write_options *options,
                                taut_arena *arena, taut_model *nurbs, taut_cad_facts *facts,
                                taut_error *error)
{
    (void)model;
    (void)options;
    (void)arena;
    (void)nurbs;
    (void)facts;
    (void)error;
    return TAUT_OK;
}

static void refuse_file(taut_reader *document)
{
    const taut_json at = taut_json_member(document->object, "boundary");
    if (document->status == TAUT_OK) {
        document->status =
            taut_json_fail(&at, document->error, "not-installed", taut_none, taut_none,
                           "files are not read in the browser: let the program "
                           "`taut make` do it");
    }
}

void taut_boundary_file_net(taut_reader *document, taut_problem *problem, taut_net_document *net)
{
    (void)problem;
    (void)net;
    refuse_file(document);
}

void taut_boundary_curves_net(taut_reader *document, taut_problem *problem,
                              const taut_curve *const curves[TAUT_SIDES], taut_net_document *net)
{
    const taut_json at = taut_json_member(document->object, "curves");
    (void)problem;
    (void)curves;
    (void)net;
    if (document->status == TAUT_OK) {
        document->status = taut_json_fail(
            &at, document->error, "not-installed", taut_none, taut_none,
            "say \"u\" and \"v\" with points to find: they are not chosen in the browser");
    }
}

void taut_boundary_file_bezier(taut_reader *document, taut_problem *problem,
                               const char *const *others, int agree,
                               const taut_curve *sides[TAUT_SIDES])
{
    (void)problem;
    (void)others;
    (void)agree;
    (void)sides;
    refuse_file(document);
}

taut_status taut_cad_read_step(const char *path, const taut_read_options *options,
                               taut_model **model, taut_error *error)
{
    (void)path;
    (void)options;
    (void)model;
    return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
                     "STEP is not read in the browser: let the program `taut convert` read it");
}

/* Films of many patches: what nobody drags by hand. */
static const char no_patches[] =
    "films of many patches, with cells or cables along several edges, are not made in the "
    "browser: let the program `taut make` do it";

void taut_film_document_patches(taut_reader *document, taut_problem *problem,
                                const taut_film_patch_readers *readers, taut_film_problem *data,
                                taut_film_parts *parts)
{
    const taut_json at = taut_json_member(document->object, "patches");
    (void)parts;
    (void)readers;
    (void)problem;
    (void)data;
    if (document->status == TAUT_OK) {
        document->status = taut_json_fail(&at, document->error, "not-installed", taut_none,
                                          taut_none, "%s", no_patches);
    }
}

void taut_film_document_curves(taut_reader *document, taut_problem *problem,
                               taut_film_curve_read *read, taut_film_problem *data,
                               taut_film_parts *parts)
{
    const taut_json at = taut_json_member(document->object, "curves");
    (void)parts;
    (void)problem;
    (void)read;
    (void)data;
    if (document->status == TAUT_OK) {
        document->status = taut_json_fail(&at, document->error, "not-installed", taut_none,
                                          taut_none, "%s", no_patches);
    }
}

void taut_film_document_along(taut_reader *document, taut_problem *problem,
                              const taut_film_parts *parts, taut_film_law_read *read_law,
                              taut_film_problem *data)
{
    const taut_json at = taut_json_member(document->object, "cables");
    (void)problem;
    (void)parts;
    (void)read_law;
    (void)data;
    if (document->status == TAUT_OK) {
        document->status = taut_json_fail(&at, document->error, "not-installed", taut_none,
                                          taut_none, "%s", no_patches);
    }
}

void taut_film_document_cells(taut_reader *document, taut_problem *problem, taut_film_problem *data)
{
    const taut_json at = taut_json_member(document->object, "cells");
    (void)problem;
    (void)data;
    if (document->status == TAUT_OK) {
        document->status = taut_json_fail(&at, document->error, "not-installed", taut_none,
                                          taut_none, "%s", no_patches);
    }
}

taut_status taut_film_complex_make(const taut_film_problem *problem,
                                   const taut_make_options *options, taut_model **model,
                                   taut_error *error)
{
    (void)problem;
    (void)options;
    (void)model;
    return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none, "%s", no_patches);
}

taut_status taut_film_complex_certify(const taut_model *model, const taut_film_problem *problem,
                                      const taut_crew *crew, taut_certificate *certificate,
                                      taut_error *error)
{
    (void)model;
    (void)problem;
    (void)crew;
    (void)certificate;
    return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none, "%s", no_patches);
}

taut_status taut_film_told(const taut_model *model, const taut_film_problem *problem,
                           const taut_film_complex *complex, taut_certificate *certificate)
{
    (void)model;
    (void)problem;
    (void)complex;
    (void)certificate;
    return TAUT_OK;
}

void taut_film_complex_identify(const taut_film_problem *problem, taut_identity *identity)
{
    (void)problem;
    (void)identity;
}

/* ---- cloth ---- */

static taut_status refuse_cloth(taut_error *error)
{
    return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
                     "cloth is not cut by this module: let the program `taut pattern` do it");
}

static taut_status make_cloth(const void *data, const taut_make_options *options,
                              taut_model **model, taut_error *error)
{
    (void)data;
    (void)options;
    (void)model;
    return refuse_cloth(error);
}

static taut_status certify_cloth(const taut_model *model, const void *data, const taut_audit *audit,
                                 taut_certificate *certificate, taut_error *error)
{
    (void)model;
    (void)data;
    (void)audit;
    (void)certificate;
    return refuse_cloth(error);
}

const taut_construct_ops taut_construct_pattern = {.make = make_cloth};
const taut_certify_ops taut_certify_pattern = {.certify = certify_cloth};

static void read_cloth(taut_reader *document, taut_problem *problem, void *data)
{
    (void)problem;
    (void)data;
    document->status = refuse_cloth(document->error);
}

/* As io/problem/pattern.c has them, so that a member that is none is named here too. */
static const char *const cloth_members[] = {
    "pattern",      "of",        "surface",      "seams",     "seam_length", "cloth",
    "compensation", "prestress", "decompensate", "allowance", "held",        "ends",
    "hems",         "marks",     "strain",       "flatten",   "untrim",      NULL};

const taut_document_ops taut_document_pattern = {
    .members = cloth_members,
    .size = 1,
    .read = read_cloth,
};

int taut_flat_is_cloth(const taut_model *model)
{
    (void)model;
    return 0;
}

taut_status taut_flat_read_cloth(const taut_model *model, taut_arena *arena, taut_flat *flat,
                                 taut_error *error)
{
    (void)model;
    (void)arena;
    (void)flat;
    return refuse_cloth(error);
}

taut_status taut_mesh_strains(const taut_model *model, const taut_mesh *mesh, taut_arena *arena,
                              double *values)
{
    (void)model;
    (void)mesh;
    (void)arena;
    (void)values;
    return TAUT_NO_MEMORY;
}

void taut_mesh_put_line(taut_json_out *out, const char *name, int accessor, int material)
{
    (void)out;
    (void)name;
    (void)accessor;
    (void)material;
}

void taut_mesh_write_lines(taut_sink *sink, int count, const taut_mesh_line *lines,
                           const double origin[3])
{
    (void)sink;
    (void)count;
    (void)lines;
    (void)origin;
}

taut_status taut_mesh_lines(const taut_model *model, double lift, taut_arena *arena, int *count,
                            const taut_mesh_line **lines)
{
    (void)model;
    (void)lift;
    (void)arena;
    (void)count;
    (void)lines;
    return TAUT_NO_MEMORY;
}

taut_status taut_flat_spread(const taut_model *model, const double plane[2][3], taut_model **spread)
{
    (void)model;
    (void)plane;
    *spread = NULL;
    return TAUT_OK;
}

/* More pages are a PDF file's, and those are not written here. */
taut_status taut_flat_page(const taut_model *model, const taut_write_options *options, double point,
                           const taut_canvas_ops *ops, taut_canvas *canvas, taut_arena *arena,
                           taut_error *error)
{
    (void)model;
    (void)options;
    (void)point;
    (void)ops;
    (void)canvas;
    (void)arena;
    (void)error;
    return TAUT_OK;
}

/* No piece of cloth: none is cut here, and figures of those that are given go without their strain. */
taut_status taut_mounted_new(const taut_model *model, const taut_surface *flat, taut_arena *arena,
                             taut_mounted *mounted)
{
    (void)model;
    (void)flat;
    (void)arena;
    *mounted = (taut_mounted){.flat = NULL};
    return TAUT_OK;
}

void taut_mounted_at(const taut_mounted *mounted, double s, double t, double point[3],
                     double normal[3], double *strain)
{
    (void)mounted;
    (void)s;
    (void)t;
    (void)point;
    (void)normal;
    (void)strain;
}
