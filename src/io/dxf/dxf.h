/* dxf.h -- the drawing exchange format of AutoCAD 2000 (AC1015), in text: layers, and lines, polylines, splines and texts on them.
 *
 *     taut_dxf_begin    header with the unit, tables with the layers, blocks
 *     taut_dxf_line ... one entity each, in the model space
 *     taut_dxf_end      objects, end
 *
 * Numbers are the shortest that come back as the same doubles. Nothing in a file says when it was made. Failures stick to
 * the sink.
 */
#ifndef TAUT_IO_DXF_DXF_H
#define TAUT_IO_DXF_DXF_H

#include "io/file/sink.h"
#include "taut/curve.h"

/* A layer: its name, in which what DXF forbids becomes _, and its colour of AutoCAD's index (7: black or white). */
typedef struct taut_dxf_layer {
    const char *name;
    int colour;
} taut_dxf_layer;

typedef struct taut_dxf {
    taut_sink *sink;
    size_t handle; /* the last one given */
    const taut_dxf_layer *layers;
} taut_dxf;

/* Begins a drawing in a unit of taut's ("mm"); the layers are borrowed until the end. Entities name a layer by its place. */
taut_dxf taut_dxf_begin(taut_sink *sink, const char *unit, int layer_count,
                        const taut_dxf_layer *layers);
void taut_dxf_end(taut_dxf *dxf);

/* Every entity may have a name, which goes as extended data of the application TAUT; "" or NULL: none. */
void taut_dxf_line(taut_dxf *dxf, int layer, const char *name, const double from[3],
                   const double to[3]);
/* points double[count][2] at one height z; closed: back to the first. */
void taut_dxf_outline(taut_dxf *dxf, int layer, const char *name, size_t count,
                      const double *points, double z, int closed);
/* points double[count][3] */
void taut_dxf_polyline(taut_dxf *dxf, int layer, const char *name, size_t count,
                       const double *points);
/* A polynomial or rational B-spline, with its own knots, points and weights. */
void taut_dxf_spline(taut_dxf *dxf, int layer, const char *name, const taut_curve *curve);
/* A curve as the simplest of these that is the same: bases of B-splines only. */
void taut_dxf_curve(taut_dxf *dxf, int layer, const taut_curve *curve);
/* A line of text, its middle at (x, y, 0). */
void taut_dxf_text(taut_dxf *dxf, int layer, const char *text, double x, double y, double height);

#endif /* TAUT_IO_DXF_DXF_H */
