/* figure.h -- a model as a picture: SVG, PDF or PNG.
 *
 * Surfaces are shaded, or coloured by H or K over a scale symmetric about 0 or by isothermality
 * over one from 0 (options->colour), with their boundaries, knot lines, control nets (unless
 * no_net) and curves, and where asked for isolines, reflections, curvature combs and reactions; hidden parts
 * hidden, in an orthographic view with z up. The page is white, 1200 by 900 units: 1200 by 900
 * pixels of PNG (unless width), 600 by 450 points of SVG and PDF. The frames of a deformation stand
 * side by side (panes.h).
 */
#ifndef TAUT_DRAW_FIGURE_H
#define TAUT_DRAW_FIGURE_H

#include "taut/model.h"
#include "taut/write.h"

#include <stdio.h>

/* kind     "svg", "pdf" or "png"
 * options  or NULL: surface (then no curves), side_by_side, divide (cells a knot span; else about
 *          20000 cells in a PNG and 3600 in vectors), threads, colour, isolines, reflections, combs, reactions,
 *          no_net, view (elevation in [-90, 90]; else one that shows the surfaces' faces), title,
 *          labels, width, monitor
 * out      flushed on success, left open
 *
 * The same model and options give the same bytes on one machine; the date in a PDF is that of
 * SOURCE_DATE_EPOCH, none without it. Points that are not finite are left out; where there is no
 * curvature the surface is grey. TAUT_BAD_ARGUMENT: kind, view, no surface of that name, nothing to
 * draw; TAUT_IO: writing failed, or cairo (PDF, PNG) is not there; TAUT_INTERRUPTED;
 * TAUT_NO_MEMORY. */
taut_status taut_draw_figure(const taut_model *model, const taut_write_options *options,
                             const char *kind, FILE *out, taut_error *error);

/* Several models side by side, 1 .. TAUT_MODELS_MAX. */
taut_status taut_draw_figures(int count, const taut_model *const *models,
                              const taut_write_options *options, const char *kind, FILE *out,
                              taut_error *error);

#endif /* TAUT_DRAW_FIGURE_H */
