/* panels.h -- plane panels, each in its true size, side by side. */
#ifndef TAUT_IO_DXF_PANELS_H
#define TAUT_IO_DXF_PANELS_H

#include "taut/model.h"

#include <stddef.h>

/* One panel laid flat: its corners without those that fall together, from the lower left of their box. */
typedef struct taut_flat_panel {
    int count;
    double corners[4][2];
    double size[2]; /* of the box */
} taut_flat_panel;

/* Is surface i of the model one of `taut panels`? */
int taut_is_panels(const taut_model *model, int i);

/* Cell (i, j) of a surface of bidegree (1, 1) in its own plane: the first side along x, all distances kept. */
taut_flat_panel taut_lay_flat(const taut_surface *surface, int i, int j);

#endif /* TAUT_IO_DXF_PANELS_H */
