/* formats.c -- the formats of libtaut-draw, as libtaut's writer takes them. */
#include "draw/format_list.h"
#include "io/format.h"
#include "taut/draw.h"
#include "taut/version.h"

TAUT_DRAW_FORMAT_LIST(TAUT_FORMAT_DECLARE)

static const taut_format_row rows[] = {TAUT_DRAW_FORMAT_LIST(TAUT_FORMAT_ROW)};

const taut_formats *taut_draw_formats(void)
{
    static const taut_formats formats = {TAUT_VERSION, (int)(sizeof rows / sizeof rows[0]), rows};
    return &formats;
}
