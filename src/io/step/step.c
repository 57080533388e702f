/* step.c -- the format step: ISO 10303-21, application protocol 242, written without a CAD kernel.
 *
 *     NURBS of all surfaces and curves               (io/cad/prepare)
 *     shells: which edges are one, what is a body    (shell)
 *     units and spaces; faces; curves; the product   (product.c, topology.c, geometry.c, style.c)
 *
 * All of it is known before the first byte is written, but for the numbers of instances, which are
 * counted on the way: nothing refers to what comes later, so that nothing is kept but numbers.
 * Reading is OpenCASCADE's (io/cad).
 */
#include "core/fail.h"
#include "geometry/exponent.h"
#include "io/cad/cad.h"
#include "io/cad/prepare.h"
#include "io/format.h"
#include "io/step/assembly.h"
#include "mesh/colour.h"
#include "taut/version.h"

#include <math.h>

/* A face that is a single point has no edges: STEP's readers leave it out without a word. */
static taut_status check_faces(const taut_model *nurbs, taut_error *error)
{
    for (int i = 0; i < taut_model_surface_count(nurbs); i++) {
        const taut_surface *surface = taut_model_surface(nurbs, i);
        if (taut_half_size(taut_point_count(surface), taut_surface_points(surface)) == 0) {
            return taut_fail(error, TAUT_NO_SOLUTION, "single-point", NULL, 0, taut_none,
                             "surface \"%s\" is a single point, which no STEP file gives back: "
                             "leave it out (--surface), or write IGES or JSON",
                             taut_surface_name(surface));
        }
    }
    return TAUT_OK;
}

static void put_header(taut_part21 *out, const taut_cad_facts *facts)
{
    const taut_part21_value values[] = {TAUT_TEXT(facts->made), TAUT_TEXT(facts->exact),
                                        TAUT_TEXT(facts->name), TAUT_TEXT(facts->date),
                                        TAUT_TEXT("taut " TAUT_VERSION)};
    taut_part21_put(out,
                    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((%,%),'2;1');\n"
                    "FILE_NAME(%,%,(''),(''),%,'taut','');\n"
                    "FILE_SCHEMA(('AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF "
                    "{ 1 0 10303 442 1 1 4 }'));\nENDSEC;\nDATA;\n",
                    values);
}

static void put_curves(taut_part21 *out, const taut_model *nurbs, taut_step_content *content)
{
    size_t styles[TAUT_STEP_COLOURS] = {0};
    for (int i = 0; i < taut_model_curve_count(nurbs); i++) {
        const taut_curve *curve = taut_model_curve(nurbs, i);
        const size_t made = taut_step_put_curve(out, curve);
        content->items[TAUT_STEP_CURVES][++content->counts[TAUT_STEP_CURVES]] = TAUT_NEW(
            out, "GEOMETRIC_CURVE_SET(%,(%))", TAUT_TEXT(taut_curve_name(curve)), TAUT_REF(made));
        content->styles[content->style_count++] =
            taut_step_style_curve(out, made, taut_colour_of_curve(nurbs, i), styles);
    }
}

static taut_status find_shells(const taut_model *nurbs, double moved, taut_arena *arena,
                               taut_shells *shells)
{
    const int count = taut_model_surface_count(nurbs);
    const taut_surface **surfaces = taut_arena_take(arena, (size_t)count, sizeof(taut_surface *));
    if (surfaces == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < count; i++) {
        surfaces[i] = taut_model_surface(nurbs, i);
    }
    return taut_shells_find(surfaces, count, moved, arena, shells);
}

static taut_status take_content(const taut_model *nurbs, const taut_step_cuts *cuts,
                                taut_arena *arena, taut_step_content *content)
{
    const size_t faces = (size_t)taut_model_surface_count(nurbs);
    size_t pieces = 0;
    const size_t curves = (size_t)taut_model_curve_count(nurbs);
    *content = (taut_step_content){.style_count = 0};
    for (int kind = 0; kind < TAUT_STEP_KINDS; kind++) {
        content->items[kind] =
            taut_arena_take(arena, (kind == TAUT_STEP_CURVES ? curves : faces) + 1, sizeof(size_t));
    }
    for (size_t f = 0; f < faces; f++) {
        pieces += (size_t)taut_step_pieces(&cuts[f], 0) * (size_t)taut_step_pieces(&cuts[f], 1);
    }
    content->styles = taut_arena_take(arena, pieces + curves, sizeof(size_t));
    return taut_arena_status(arena);
}

/* Which faces are planes, cylinders and tori: with rings that close, once around in the shell too. */
static taut_status find_forms(const taut_model *nurbs, const taut_shells *shells, taut_arena *arena,
                              taut_step_form **forms)
{
    *forms = taut_arena_take(arena, (size_t)shells->face_count, sizeof **forms);
    for (int f = 0; *forms != NULL && f < shells->face_count; f++) {
        taut_step_form *form = &(*forms)[f];
        taut_step_recognise(taut_model_surface(nurbs, f), form);
        const int *seam = shells->faces[f].edge + 2 * (form->around == 1);
        if (seam[0] < 0 || seam[0] != seam[1]) {
            *form = (taut_step_form){.kind = TAUT_STEP_SPLINE};
        }
    }
    return *forms != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}

/* What the forms are off by. */
static double distance_of(const taut_model *nurbs, const taut_step_form *forms)
{
    double most = 0;
    for (int f = 0; f < taut_model_surface_count(nurbs); f++) {
        most = fmax(most, forms[f].distance);
    }
    return most;
}

static taut_status prepare_part(taut_step_part *p, const taut_cad_facts *facts, taut_arena *arena,
                                taut_error *error)
{
    taut_status status = find_shells(p->model, facts->bound, arena, &p->shells);
    if (status == TAUT_OK) {
        status = taut_step_check_edges(p->model, &p->shells, error);
    }
    if (status == TAUT_OK) {
        status = find_forms(p->model, &p->shells, arena, &p->forms);
    }
    if (status == TAUT_OK) {
        status = taut_step_find_cuts(p->model, &p->shells, p->forms, facts->thickness > 0, arena,
                                     &p->cuts);
    }
    if (status == TAUT_OK) {
        status = take_content(p->model, p->cuts, arena, &p->content);
    }
    if (status == TAUT_OK) {
        status = taut_step_find_hollows(facts, &p->shells, arena, &p->outside);
    }
    return status == TAUT_OK && facts->thickness > 0
               ? taut_step_check_bodies(p->model, &p->shells, error)
               : status;
}

/* What is looked at before the first byte: shells and forms, and how near all is. */
static taut_status prepare_parts(int count, taut_step_part *parts, taut_cad_facts *facts,
                                 taut_arena *arena, taut_error *error)
{
    double gap = 0, distance = 0;
    for (int i = 0; i < count; i++) {
        if (i > 0 && parts[i].of != i) {
            continue;
        }
        const taut_status status = prepare_part(&parts[i], facts, arena, error);
        if (status != TAUT_OK) {
            return status;
        }
        gap = fmax(gap, parts[i].shells.gap);
        distance = fmax(distance, distance_of(parts[i].model, parts[i].forms));
    }
    facts->bound += distance;
    facts->precision = fmax(facts->precision, gap);
    taut_cad_say_bound(taut_model_unit(parts[0].model), facts);
    return TAUT_OK;
}

/* A part as a product, where it is the first of its kind. */
static taut_status put_part(taut_part21 *out, const taut_step_spaces *spaces, taut_arena *arena,
                            taut_step_part *p)
{
    const taut_status status = taut_step_put_faces(out, p->model, &p->shells, p->forms, p->cuts,
                                                   p->outside, spaces, arena, &p->content);
    if (status == TAUT_OK) {
        put_curves(out, p->model, &p->content);
        taut_step_put_product(out, p->name, spaces, &p->content, &p->product);
    }
    return status;
}

/* All between the header and the end. */
static taut_status put_data(taut_part21 *out, int count, taut_step_part *parts,
                            taut_cad_facts *facts, taut_arena *arena, taut_error *error)
{
    taut_step_spaces spaces;
    size_t *places = taut_arena_take(arena, (size_t)count, sizeof *places);
    taut_status status =
        places != NULL ? prepare_parts(count, parts, facts, arena, error) : TAUT_NO_MEMORY;
    if (status != TAUT_OK) {
        return status;
    }
    put_header(out, facts);
    taut_step_put_spaces(out, taut_model_unit(parts[0].model), facts->precision, &spaces);
    taut_step_put_places(out, count, parts, places);
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        parts[i].product.field = i > 0 ? parts[0].product.field : 0;
        parts[i].product.stage = i > 0 ? parts[0].product.stage : 0;
        status = i == 0 || parts[i].of == i ? put_part(out, &spaces, arena, &parts[i]) : TAUT_OK;
    }
    if (status == TAUT_OK) {
        taut_step_put_uses(out, count, parts, &spaces);
    }
    taut_part21_put(out, "ENDSEC;\nEND-ISO-10303-21;\n", NULL);
    return status;
}

static taut_status put_file(const taut_model *nurbs, taut_cad_facts *facts,
                            const taut_monitor *monitor, FILE *file, taut_arena *arena,
                            taut_error *error)
{
    taut_part21 out = {.sink = taut_sink_to(file)};
    taut_sink_watch(&out.sink, monitor);
    taut_step_part *parts = NULL;
    double moved = 0;
    int count = 0;
    taut_status put = taut_step_list_parts(nurbs, facts, arena, &count, &parts, &moved);
    facts->bound += moved;
    put = put == TAUT_OK ? put_data(&out, count, parts, facts, arena, error) : put;
    const taut_status sent = taut_sink_finish(&out.sink);
    return put == TAUT_NO_MEMORY || sent == TAUT_NO_MEMORY ? taut_fail_memory(error)
           : put != TAUT_OK                                ? put
                                                           : sent;
}

static taut_status write_step(const taut_model *model, const taut_write_options *options,
                              FILE *file, taut_error *error)
{
    taut_model *nurbs = NULL;
    taut_cad_facts facts;
    taut_arena *arena = taut_arena_new();
    taut_status status = taut_cad_prepare(model, options, arena, &nurbs, &facts, error);

    if (status == TAUT_OK) {
        status = check_faces(nurbs, error);
    }
    if (status == TAUT_OK) {
        status = put_file(nurbs, &facts, &options->monitor, file, arena, error);
    }
    taut_model_free(nurbs);
    taut_arena_free(arena);
    if (status == TAUT_OK && options->bound != NULL) {
        *options->bound = taut_cad_bound(&facts);
    }
    return status;
}

const taut_format_ops taut_format_step = {.write = write_step, .read = taut_cad_read_step};
