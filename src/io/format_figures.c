/* format_figures.c -- the formats that are pictures, all drawn by src/draw. */
#include "draw/figure.h"
#include "io/format.h"

static taut_status write_svg(const taut_model *model, const taut_write_options *options, FILE *out,
                             taut_error *error)
{
    return taut_draw_figure(model, options, "svg", out, error);
}

static taut_status write_pdf(const taut_model *model, const taut_write_options *options, FILE *out,
                             taut_error *error)
{
    return taut_draw_figure(model, options, "pdf", out, error);
}

static taut_status write_png(const taut_model *model, const taut_write_options *options, FILE *out,
                             taut_error *error)
{
    return taut_draw_figure(model, options, "png", out, error);
}

const taut_format_ops taut_format_svg = {.write = write_svg};
const taut_format_ops taut_format_pdf = {.write = write_pdf};
const taut_format_ops taut_format_png = {.write = write_png};
