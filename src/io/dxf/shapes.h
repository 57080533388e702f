/* shapes.h -- an entity of a DXF file as a curve. */
#ifndef TAUT_IO_DXF_SHAPES_H
#define TAUT_IO_DXF_SHAPES_H

#include "io/dxf/pairs.h"
#include "taut/curve.h"

/* A curve under way: B-spline of a degree, homogeneous points (w x, w y, w z, w). */
typedef struct taut_dxf_curve {
    int degree;
    size_t count, room;
    double (*points)[4];
    double *knots; /* double[count + degree + 1] */
} taut_dxf_curve;

/* Rows of [x' = M (x, 1)]. */
typedef double taut_dxf_placing[3][4];

/* The placing of coordinates of an object with the normal `normal` (the arbitrary axis algorithm). */
void taut_dxf_object_axes(const double normal[3], taut_dxf_placing placing);
/* first, then second. */
void taut_dxf_compose(taut_dxf_placing second, taut_dxf_placing first, taut_dxf_placing out);

/* What an entity is. Vertices of a POLYLINE are in `pairs` as well, up to its SEQEND. */
typedef enum taut_dxf_kind {
    TAUT_DXF_OTHER, /* no curve */
    TAUT_DXF_MADE,
    TAUT_DXF_UNREADABLE /* a curve that is not read; `why` says what of it */
} taut_dxf_kind;

/* *curve is of the arena, in the coordinates of the block. TAUT_BAD_INPUT, TAUT_NO_MEMORY. */
taut_status taut_dxf_shape(taut_dxf_pairs pairs, taut_arena *arena, taut_dxf_curve *curve,
                           taut_dxf_kind *kind, const char **why, taut_error *error);

#endif /* TAUT_IO_DXF_SHAPES_H */
