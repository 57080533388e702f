/* read.h -- DXF in: the curves of a drawing, R12 to 2018, in text. */
#ifndef TAUT_IO_DXF_READ_H
#define TAUT_IO_DXF_READ_H

#include "taut/read.h"

/* Lines, polylines, arcs, circles, ellipses and splines of the model space, blocks inserted, in the drawing's unit.
 * A curve is named after its extended data (what taut writes), else its layer, BLOCK/LAYER in a block, with .1, .2, ...
 * where several would be called alike. What else there is, is counted in details.notes. */
taut_status taut_dxf_read(const char *path, const taut_read_options *options, taut_model **model,
                          taut_error *error);

#endif /* TAUT_IO_DXF_READ_H */
