/* layers.h -- on which layers the curves of a model go. */
#ifndef TAUT_IO_DXF_LAYERS_H
#define TAUT_IO_DXF_LAYERS_H

#include "core/arena.h"
#include "io/dxf/dxf.h"
#include "taut/model.h"

/* Of a net the curves of one family go on a layer named after net and family ("asymptotic +"), of a film those with a cable on
 * "cables", axes of pipes on "axes", others on "curves". */
typedef struct taut_dxf_layers {
    taut_dxf_layer *layers;
    int count;
    int *of; /* [curves]: the layer of each */
} taut_dxf_layers;

/* All from the arena. TAUT_NO_MEMORY. */
taut_status taut_dxf_layers_of(const taut_model *model, taut_arena *arena, taut_dxf_layers *layers);

#endif /* TAUT_IO_DXF_LAYERS_H */
