/* product.c -- the frame around the shapes: unit, uncertainty, product (ISO 10303-41, -43, -242).
 *
 * One product has one representation. Where solids, surface models and curves come together, each
 * kind has a representation of its own, as readers expect it, tied to one with the origin alone.
 */
#include "io/step/entities.h"

#include <string.h>

/* Inches and feet are so many millimetres. */
typedef struct unit_row {
    const char *unit, *prefix, *name;
    double millimetres;
} unit_row;

static const unit_row units[] = {{"mm", ".MILLI.", NULL, 1},
                                 {"cm", ".CENTI.", NULL, 10},
                                 {"m", "$", NULL, 1000},
                                 {"in", ".MILLI.", "INCH", 25.4},
                                 {"ft", ".MILLI.", "FOOT", 304.8}};

static size_t put_length(taut_part21 *out, const char *unit)
{
    size_t i = 0;
    while (i + 1 < sizeof units / sizeof units[0] && strcmp(units[i].unit, unit) != 0) {
        i++;
    }
    const size_t metric =
        TAUT_NEW(out, "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(%,.METRE.))", TAUT_WORD(units[i].prefix));
    if (units[i].name == NULL) {
        return metric;
    }
    const size_t factor = TAUT_NEW(out, "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(%),%)",
                                   TAUT_REAL(units[i].millimetres), TAUT_REF(metric));
    const size_t exponents =
        taut_part21_new(out, "DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)", NULL);
    return TAUT_NEW(out, "(CONVERSION_BASED_UNIT(%,%)LENGTH_UNIT()NAMED_UNIT(%))",
                    TAUT_TEXT(units[i].name), TAUT_REF(factor), TAUT_REF(exponents));
}

size_t taut_step_put_direction(taut_part21 *out, size_t count, const double *direction)
{
    return TAUT_NEW(out, "DIRECTION('',%)", TAUT_REALS(count, direction, 1));
}

void taut_step_put_spaces(taut_part21 *out, const char *unit, double precision,
                          taut_step_spaces *spaces)
{
    static const double along[2][2] = {{1, 0}, {0, 1}};
    static const double origin[3] = {0, 0, 0}, axis[3] = {0, 0, 1}, ahead[3] = {1, 0, 0};
    const size_t length = put_length(out, unit);
    const size_t angle =
        taut_part21_new(out, "(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))", NULL);
    const size_t solid =
        taut_part21_new(out, "(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())", NULL);
    const size_t near = TAUT_NEW(
        out, "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(%),%,'distance_accuracy_value','')",
        TAUT_REAL(precision), TAUT_REF(length));
    spaces->space =
        TAUT_NEW(out,
                 "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((%))"
                 "\nGLOBAL_UNIT_ASSIGNED_CONTEXT((%,%,%))REPRESENTATION_CONTEXT('',''))",
                 TAUT_REF(near), TAUT_REF(length), TAUT_REF(angle), TAUT_REF(solid));
    spaces->plane =
        taut_part21_new(out,
                        "(GEOMETRIC_REPRESENTATION_CONTEXT(2)"
                        "PARAMETRIC_REPRESENTATION_CONTEXT()REPRESENTATION_CONTEXT('',''))",
                        NULL);
    for (int d = 0; d < 2; d++) {
        const size_t direction = taut_step_put_direction(out, 2, along[d]);
        spaces->along[d] = TAUT_NEW(out, "VECTOR('',%,1.)", TAUT_REF(direction));
    }
    const size_t point = TAUT_NEW(out, "CARTESIAN_POINT('',%)", TAUT_REALS(3, origin, 1));
    const size_t up = taut_step_put_direction(out, 3, axis),
                 right = taut_step_put_direction(out, 3, ahead);
    spaces->placement = TAUT_NEW(out, "AXIS2_PLACEMENT_3D('',%,%,%)", TAUT_REF(point), TAUT_REF(up),
                                 TAUT_REF(right));
}

/* The representation of all items of a kind; the origin goes first. */
static size_t put_kind(taut_part21 *out, int kind, const taut_step_spaces *spaces,
                       taut_step_content *content)
{
    static const char *const names[TAUT_STEP_KINDS] = {
        "ADVANCED_BREP_SHAPE_REPRESENTATION", "MANIFOLD_SURFACE_SHAPE_REPRESENTATION",
        "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION"};
    content->items[kind][0] = spaces->placement;
    return TAUT_NEW(out, "%('',%,%)", TAUT_WORD(names[kind]),
                    TAUT_REFS(content->counts[kind] + 1, content->items[kind]),
                    TAUT_REF(spaces->space));
}

static size_t put_representation(taut_part21 *out, const taut_step_spaces *spaces,
                                 taut_step_content *content)
{
    size_t each[TAUT_STEP_KINDS] = {0}, last = 0;
    int kinds = 0;
    for (int kind = 0; kind < TAUT_STEP_KINDS; kind++) {
        if (content->counts[kind] > 0) {
            last = each[kind] = put_kind(out, kind, spaces, content);
            kinds++;
        }
    }
    if (kinds == 1 && content->place_count == 0) {
        return last;
    }
    size_t *items = content->places, own = spaces->placement;
    items = content->place_count > 0 ? items : &own;
    items[0] = spaces->placement;
    const size_t whole =
        TAUT_NEW(out, "SHAPE_REPRESENTATION('',%,%)", TAUT_REFS(content->place_count + 1, items),
                 TAUT_REF(spaces->space));
    for (int kind = 0; kind < TAUT_STEP_KINDS; kind++) {
        if (each[kind] != 0) {
            TAUT_NEW(out, "SHAPE_REPRESENTATION_RELATIONSHIP('','',%,%)", TAUT_REF(whole),
                     TAUT_REF(each[kind]));
        }
    }
    return whole;
}

/* What all products refer to, once. */
static void put_contexts(taut_part21 *out, taut_step_product *products)
{
    const size_t about =
        taut_part21_new(out, "APPLICATION_CONTEXT('managed model based 3d engineering')", NULL);
    TAUT_NEW(out,
             "APPLICATION_PROTOCOL_DEFINITION('international standard',"
             "'ap242_managed_model_based_3d_engineering',2014,%)",
             TAUT_REF(about));
    products->field = TAUT_NEW(out, "PRODUCT_CONTEXT('',%,'mechanical')", TAUT_REF(about));
    products->stage =
        TAUT_NEW(out, "PRODUCT_DEFINITION_CONTEXT('part definition',%,'design')", TAUT_REF(about));
}

void taut_step_put_product(taut_part21 *out, const char *name, const taut_step_spaces *spaces,
                           taut_step_content *content, taut_step_product *product)
{
    product->shape = put_representation(out, spaces, content);
    if (content->style_count > 0) {
        TAUT_NEW(out, "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',%,%)",
                 TAUT_REFS(content->style_count, content->styles), TAUT_REF(spaces->space));
    }
    if (product->field == 0) {
        put_contexts(out, product);
    }
    const size_t made = TAUT_NEW(out, "PRODUCT(%,%,'',(%))", TAUT_TEXT(name), TAUT_TEXT(name),
                                 TAUT_REF(product->field));
    TAUT_NEW(out, "PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(%))", TAUT_REF(made));
    const size_t version = TAUT_NEW(out, "PRODUCT_DEFINITION_FORMATION('','',%)", TAUT_REF(made));
    product->definition = TAUT_NEW(out, "PRODUCT_DEFINITION('design','',%,%)", TAUT_REF(version),
                                   TAUT_REF(product->stage));
    const size_t form =
        TAUT_NEW(out, "PRODUCT_DEFINITION_SHAPE('','',%)", TAUT_REF(product->definition));
    TAUT_NEW(out, "SHAPE_DEFINITION_REPRESENTATION(%,%)", TAUT_REF(form), TAUT_REF(product->shape));
}
