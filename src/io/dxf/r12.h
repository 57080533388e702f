/* r12.h -- flat pieces as a drawing of AutoCAD release 12 (AC1009), which every cutter reads. */
#ifndef TAUT_IO_DXF_R12_H
#define TAUT_IO_DXF_R12_H

#include "taut/write.h"

#include <stdio.h>

/* 1:1 in the model's unit: polylines and texts on the layers of io/flat/flat.h. */
taut_status taut_r12_write(const taut_model *model, FILE *out, taut_error *error);

#endif /* TAUT_IO_DXF_R12_H */
