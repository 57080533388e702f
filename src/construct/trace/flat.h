/* flat.h -- what the details tell of flat pieces: `sheets` and `pieces`. */
#ifndef TAUT_CONSTRUCT_TRACE_FLAT_H
#define TAUT_CONSTRUCT_TRACE_FLAT_H

#include "taut/record.h"
#include "trace/piece.h"

void taut_trace_describe_flat(const taut_net *net, const taut_pieces *pieces, taut_record *details);

#endif /* TAUT_CONSTRUCT_TRACE_FLAT_H */
