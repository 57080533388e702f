#include "io/step/entities.h"
#include "mesh/colour.h"

static size_t put_colour(taut_part21 *out, taut_ink ink)
{
    return TAUT_NEW(out, "COLOUR_RGB('',%,%,%)", TAUT_REAL(ink.r / 255.0), TAUT_REAL(ink.g / 255.0),
                    TAUT_REAL(ink.b / 255.0));
}

static size_t put_item(taut_part21 *out, size_t style, size_t item)
{
    return TAUT_NEW(out, "STYLED_ITEM('',(%),%)", TAUT_REF(style), TAUT_REF(item));
}

size_t taut_step_style_face(taut_part21 *out, size_t item, int i, size_t *style)
{
    size_t own = 0, *known = i < TAUT_COLOUR_OWN ? &style[i % TAUT_STEP_COLOURS] : &own;
    if (*known == 0) {
        const size_t colour = put_colour(out, taut_colour_plain(i));
        const size_t fill = TAUT_NEW(out, "FILL_AREA_STYLE_COLOUR('',%)", TAUT_REF(colour));
        const size_t area = TAUT_NEW(out, "FILL_AREA_STYLE('',(%))", TAUT_REF(fill));
        const size_t used = TAUT_NEW(out, "SURFACE_STYLE_FILL_AREA(%)", TAUT_REF(area));
        const size_t side = TAUT_NEW(out, "SURFACE_SIDE_STYLE('',(%))", TAUT_REF(used));
        const size_t both = TAUT_NEW(out, "SURFACE_STYLE_USAGE(.BOTH.,%)", TAUT_REF(side));
        *known = TAUT_NEW(out, "PRESENTATION_STYLE_ASSIGNMENT((%))", TAUT_REF(both));
    }
    return put_item(out, *known, item);
}

size_t taut_step_style_curve(taut_part21 *out, size_t item, int i, size_t *style)
{
    size_t *known = &style[i % TAUT_STEP_COLOURS];
    if (*known == 0) {
        const size_t colour = put_colour(out, taut_colour_curve(i));
        const size_t font =
            TAUT_NEW(out, "DRAUGHTING_PRE_DEFINED_CURVE_FONT(%)", TAUT_TEXT("continuous"));
        const size_t line = TAUT_NEW(out, "CURVE_STYLE('',%,POSITIVE_LENGTH_MEASURE(0.1),%)",
                                     TAUT_REF(font), TAUT_REF(colour));
        *known = TAUT_NEW(out, "PRESENTATION_STYLE_ASSIGNMENT((%))", TAUT_REF(line));
    }
    return put_item(out, *known, item);
}
