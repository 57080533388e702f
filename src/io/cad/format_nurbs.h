/* format_nurbs.h -- what formats that hold NURBS begin with. */
#ifndef TAUT_IO_CAD_FORMAT_NURBS_H
#define TAUT_IO_CAD_FORMAT_NURBS_H

#include "taut/write.h"

/* The surface that is asked for, or all surfaces and curves, as NURBS within `tolerance` of the
 * size of each; *bound is the largest proved distance, a length. TAUT_NO_SOLUTION where there is
 * nothing; else as taut_model_to_nurbs. */
taut_status taut_format_nurbs(const taut_model *model, const taut_write_options *options,
                              double tolerance, taut_model **nurbs, double *bound,
                              taut_error *error);

#endif /* TAUT_IO_CAD_FORMAT_NURBS_H */
