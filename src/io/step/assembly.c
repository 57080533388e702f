/* assembly.c -- the parts of an assembly, each in coordinates of its own.
 *
 *     part k of the model, at x -> A x + b       surfaces of k by the inverse, if A is a rotation; else where they are
 *     parts of one name, with the same nets      one product, used several times
 *     what is not in a part, and all curves      the whole
 *
 * Going there and back rounds: how far the control points are from where they were is counted.
 */
#include "io/step/assembly.h"

#include "core/vec3.h"
#include "geometry/exponent.h"
#include "geometry/keep.h"
#include "mesh/colour.h"
#include "taut/operations.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double rigid = 1e-9;  /* of A A' - 1 */
static const double alike = 1e-12; /* of the size: what rounding parts of two nets that are one */

/* Is A a rotation? Then its inverse is (A' | -A' b). */
static int invert(const double place[12], double inverse[12])
{
    double product[9], determinant = taut_det(place, place + 4, place + 8);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            product[3 * i + j] = taut_dot(place + 4 * i, place + 4 * j) - (i == j);
            inverse[4 * i + j] = place[4 * j + i];
        }
        inverse[4 * i + 3] =
            -(place[i] * place[3] + place[4 + i] * place[7] + place[8 + i] * place[11]);
    }
    for (int i = 0; i < 9; i++) {
        if (!(fabs(product[i]) <= rigid)) {
            return 0;
        }
    }
    return determinant > 0 && isfinite(inverse[3]) && isfinite(inverse[7]) && isfinite(inverse[11]);
}

/* The largest distance of the points of `own`, placed, from those of `whole`. */
static double moved_by(const double place[12], const taut_surface *own, const taut_surface *whole)
{
    const double *p = taut_surface_points(own), *q = taut_surface_points(whole);
    double most = 0;
    for (size_t i = 0; i < taut_point_count(own); i++) {
        double x[3];
        for (int c = 0; c < 3; c++) {
            x[c] = taut_dot(place + 4 * c, p + 3 * i) + place[4 * c + 3];
        }
        most = fmax(most, taut_distance(x, q + 3 * i));
    }
    return most;
}

/* The colours of some surfaces, for a model of these. */
static taut_status pick_colours(const taut_model *nurbs, const int *part, int number,
                                taut_model *model)
{
    taut_record *details = taut_record_new();
    taut_record *colours = taut_record_add_list(details, "colours");
    for (int i = 0; i < taut_model_surface_count(nurbs); i++) {
        if (part[i] == number) {
            char text[8];
            const taut_ink ink = taut_colour_plain(taut_colour_of_surface(nurbs, i));
            snprintf(text, sizeof text, "#%02x%02x%02x", (unsigned)ink.r, (unsigned)ink.g,
                     (unsigned)ink.b);
            taut_record_add_text(colours, NULL, text);
        }
    }
    if (taut_record_status(details) != TAUT_OK) {
        taut_record_free(details);
        return TAUT_NO_MEMORY;
    }
    taut_model_set_details(model, details);
    return TAUT_OK;
}

static taut_status add_surface(const taut_surface *surface, const taut_step_part *p,
                               taut_model *model)
{
    taut_surface *own = NULL;
    double inverse[12];
    const taut_status status = p->is_placed && invert(p->place, inverse)
                                   ? taut_surface_transform(surface, inverse, &own, NULL)
                                   : taut_surface_copy(surface, &own);
    if (status != TAUT_OK) {
        return status;
    }
    if (taut_model_add_surface(model, own) != TAUT_OK) {
        taut_surface_free(own);
        return TAUT_NO_MEMORY;
    }
    return TAUT_OK;
}

static taut_status add_curves(const taut_model *nurbs, taut_model *model)
{
    for (int i = 0; i < taut_model_curve_count(nurbs); i++) {
        taut_curve *curve = NULL;
        if (taut_curve_copy(taut_model_curve(nurbs, i), &curve) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        if (taut_model_add_curve(model, curve) != TAUT_OK) {
            taut_curve_free(curve);
            return TAUT_NO_MEMORY;
        }
    }
    return TAUT_OK;
}

/* The surfaces of part `number`, in a model that the arena frees; those of none, -1, with all curves. */
static taut_status pick_part(const taut_model *nurbs, const taut_cad_facts *facts, int number,
                             taut_arena *arena, taut_step_part *p)
{
    taut_model *model = NULL;
    if (taut_model_new(&model) != TAUT_OK || !taut_keep_model(arena, model)) {
        return TAUT_NO_MEMORY;
    }
    taut_model_set_unit(model, taut_model_unit(nurbs));
    for (int i = 0; i < taut_model_surface_count(nurbs); i++) {
        if (facts->part[i] == number &&
            add_surface(taut_model_surface(nurbs, i), p, model) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
    }
    if (number < 0 && add_curves(nurbs, model) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    int *said = taut_arena_take(arena, (size_t)taut_model_surface_count(nurbs) + 1, sizeof *said);
    if (said == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0, k = 0; i < taut_model_surface_count(nurbs); i++) {
        if (facts->part[i] == number) {
            said[k++] = taut_colour_said(nurbs, i);
        }
    }
    p->said = said;
    p->model = model;
    return pick_colours(nurbs, facts->part, number, model);
}

/* Is it the part's own name, or that and a number: what the reader calls faces that have none, all uses in one row? */
static int is_numbered(const char *name, const char *part)
{
    const size_t length = strlen(part);
    return strncmp(name, part, length) == 0 &&
           (name[length] == '\0' ||
            (name[length] == '.' && name[length + 1] != '\0' &&
             name[length + 1 + strspn(name + length + 1, "0123456789")] == '\0'));
}

static int is_same_surface(const taut_surface *a, const taut_surface *b, const char *part)
{
    const double *p = taut_surface_points(a), *q = taut_surface_points(b);
    const double *w = taut_surface_weights(a), *z = taut_surface_weights(b);
    const size_t count = taut_point_count(a);
    if (!taut_basis_equal(taut_surface_u(a), taut_surface_u(b)) ||
        !taut_basis_equal(taut_surface_v(a), taut_surface_v(b)) || (w == NULL) != (z == NULL) ||
        (w != NULL && memcmp(w, z, count * sizeof *w) != 0)) {
        return 0;
    }
    const double near = alike * fmax(taut_largest(count, p), taut_largest(count, q));
    for (size_t i = 0; i < 3 * count; i++) {
        if (!(fabs(p[i] - q[i]) <= near)) {
            return 0;
        }
    }
    return strcmp(taut_surface_name(a), taut_surface_name(b)) == 0 ||
           (is_numbered(taut_surface_name(a), part) && is_numbered(taut_surface_name(b), part));
}

/* The same faces, under the same name, and given the same colours? Those that taut gives go by names and numbers in the whole. */
static int is_same_part(const taut_step_part *a, const taut_step_part *b)
{
    const int count = taut_model_surface_count(a->model);
    int i = 0;
    if (strcmp(a->name, b->name) != 0 || count != taut_model_surface_count(b->model)) {
        return 0;
    }
    while (i < count && a->said[i] == b->said[i] &&
           is_same_surface(taut_model_surface(a->model, i), taut_model_surface(b->model, i),
                           a->name)) {
        i++;
    }
    return i == count;
}

/* The product of an earlier part that this one is a use of; and how far its points are from where they were. */
static double settle_part(const taut_model *nurbs, const taut_cad_facts *facts, int number, int at,
                          taut_step_part *parts)
{
    double moved = 0;
    int own = 1, k = 0;
    while (own < at && !(parts[own].of == own && is_same_part(&parts[own], &parts[at]))) {
        own++;
    }
    parts[at].of = own;
    for (int i = 0; i < taut_model_surface_count(nurbs); i++) {
        if (facts->part[i] == number) {
            moved = fmax(moved, moved_by(parts[at].place, taut_model_surface(parts[own].model, k++),
                                         taut_model_surface(nurbs, i)));
        }
    }
    return moved;
}

taut_status taut_step_list_parts(const taut_model *nurbs, const taut_cad_facts *facts,
                                 taut_arena *arena, int *count, taut_step_part **parts,
                                 double *moved)
{
    static const double here[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    const int is_assembly = facts->part_count > 0 && facts->thickness == 0;
    taut_step_part *list = taut_arena_take(arena, (size_t)facts->part_count + 1, sizeof *list);
    *moved = 0;
    *count = 1;
    *parts = list;
    if (list == NULL) {
        return TAUT_NO_MEMORY;
    }
    list[0] = (taut_step_part){.name = facts->name, .model = nurbs};
    for (int k = -1; is_assembly && k < facts->part_count; k++) {
        taut_step_part *p = &list[k < 0 ? 0 : *count];
        double inverse[12];
        p->name = k < 0 || facts->parts[k][0] == '\0' ? facts->name : facts->parts[k];
        p->is_placed = k >= 0 && invert(facts->places + 12 * k, inverse);
        memcpy(p->place, p->is_placed ? facts->places + 12 * k : here, sizeof p->place);
        if (pick_part(nurbs, facts, k, arena, p) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        if (k >= 0 && taut_model_surface_count(p->model) > 0) {
            *moved = fmax(*moved, settle_part(nurbs, facts, k, *count, list));
            *count += 1;
        }
    }
    return TAUT_OK;
}

/* A placement; A is a rotation. */
static size_t put_place(taut_part21 *out, const double place[12])
{
    const double origin[3] = {place[3], place[7], place[11]};
    const double axis[3] = {place[2], place[6], place[10]};
    const double ahead[3] = {place[0], place[4], place[8]};
    const size_t point = TAUT_NEW(out, "CARTESIAN_POINT('',%)", TAUT_REALS(3, origin, 1));
    const size_t up = taut_step_put_direction(out, 3, axis),
                 right = taut_step_put_direction(out, 3, ahead);
    return TAUT_NEW(out, "AXIS2_PLACEMENT_3D('',%,%,%)", TAUT_REF(point), TAUT_REF(up),
                    TAUT_REF(right));
}

/* A use of a part, at a placement. */
static void put_use(taut_part21 *out, size_t number, const char *name, size_t at,
                    const taut_step_spaces *spaces, const taut_step_product *whole,
                    const taut_step_product *part)
{
    const size_t use =
        TAUT_NEW(out, "NEXT_ASSEMBLY_USAGE_OCCURRENCE('%',%,'',%,%,$)", TAUT_NUMBER(number),
                 TAUT_TEXT(name), TAUT_REF(whole->definition), TAUT_REF(part->definition));
    const size_t form = TAUT_NEW(out, "PRODUCT_DEFINITION_SHAPE('','',%)", TAUT_REF(use));
    const size_t place = TAUT_NEW(out, "ITEM_DEFINED_TRANSFORMATION('','',%,%)",
                                  TAUT_REF(spaces->placement), TAUT_REF(at));
    const size_t relation = TAUT_NEW(
        out,
        "(REPRESENTATION_RELATIONSHIP('','',%,%)REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(%)"
        "\nSHAPE_REPRESENTATION_RELATIONSHIP())",
        TAUT_REF(part->shape), TAUT_REF(whole->shape), TAUT_REF(place));
    TAUT_NEW(out, "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(%,%)", TAUT_REF(relation),
             TAUT_REF(form));
}

void taut_step_put_places(taut_part21 *out, int count, taut_step_part *parts, size_t *places)
{
    for (int i = 1; i < count; i++) {
        places[i] = put_place(out, parts[i].place);
    }
    parts[0].content.place_count = (size_t)count - 1;
    parts[0].content.places = places;
}

void taut_step_put_uses(taut_part21 *out, int count, const taut_step_part *parts,
                        const taut_step_spaces *spaces)
{
    for (int i = 1; i < count; i++) {
        put_use(out, (size_t)i, parts[i].name, parts[0].content.places[i], spaces,
                &parts[0].product, &parts[parts[i].of].product);
    }
}
