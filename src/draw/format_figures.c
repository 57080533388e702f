/* format_figures.c -- the formats that are pictures, all drawn by src/draw. */
#include "draw/figure.h"
#include "io/format.h"

#define TAUT_FIGURE(kind)                                                                          \
    static taut_status write_##kind(const taut_model *model, const taut_write_options *options,    \
                                    FILE *out, taut_error *error)                                  \
    {                                                                                              \
        return taut_draw_figure(model, options, #kind, out, error);                                \
    }                                                                                              \
    static taut_status write_many_##kind(int count, const taut_model *const *models,               \
                                         const taut_write_options *options, FILE *out,             \
                                         taut_error *error)                                        \
    {                                                                                              \
        return taut_draw_figures(count, models, options, #kind, out, error);                       \
    }                                                                                              \
    const taut_format_ops taut_format_##kind = {                                                   \
        .write = write_##kind, .write_many = write_many_##kind, .models_max = TAUT_MODELS_MAX}

TAUT_FIGURE(svg);
TAUT_FIGURE(pdf);
TAUT_FIGURE(png);
