/* taut/draw.h -- figures and pages: the library libtaut-draw, which uses libtaut.
 *
 * libtaut writes models, meshes and CAD files. Figures (svg, pdf, png) and the page to turn a model in (html), with the
 * viewer that is in it, are a library of their own: link it (`pkg-config --libs taut-draw`) and hand its formats to the
 * writer,
 *
 *     const taut_write_options options = {.formats = taut_draw_formats(), .colour = TAUT_COLOUR_MEAN};
 *     status = taut_model_write(model, "figure.svg", &options, &error);
 *
 * What a figure shows is said by the options in taut/write.h.
 */
#ifndef TAUT_DRAW_H
#define TAUT_DRAW_H

#include "taut/write.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The formats html, pdf, png and svg; for the life of the process. They go with the libtaut of the same version only, which
 * refuses others ("format"). */
TAUT_API const taut_formats *taut_draw_formats(void);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_DRAW_H */
