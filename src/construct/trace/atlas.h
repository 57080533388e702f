/* atlas.h -- the surfaces that a net lies on, and where its curves go on from one to the next. */
#ifndef TAUT_CONSTRUCT_TRACE_ATLAS_H
#define TAUT_CONSTRUCT_TRACE_ATLAS_H

#include "core/arena.h"
#include "taut/trace.h"
#include "trace/carrier.h"

/* Two edges that join smoothly. */
typedef struct taut_atlas_seam {
    int surfaces[2], edges[2];
    int is_carried; /* curves go on: the normals agree, and no third edge is joined to one of these */
    int is_proved; /* the join is (taut/join.h), not only seen */
} taut_atlas_seam;

typedef struct taut_atlas {
    int count;
    taut_carrier **carriers;
    int home; /* where seeds lie that name no surface */
    int seam_count;
    taut_atlas_seam *seams;
} taut_atlas;

/* In the arena: the surface that the problem names, and with `carry` all others of the model, their
 * carriers with their seams. TAUT_BAD_INPUT, TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_atlas_new(taut_arena *arena, const taut_trace_problem *problem,
                           const taut_model *model, taut_atlas *atlas, taut_error *error);
/* Adds "joins", where there are several surfaces. */
void taut_atlas_describe(const taut_atlas *atlas, taut_record *details);

#endif /* TAUT_CONSTRUCT_TRACE_ATLAS_H */
