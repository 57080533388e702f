/* seams.h -- the surfaces of a net that goes on from one to the next: which edges join, and is it right where
 * curves pass?
 */
#ifndef TAUT_CERTIFY_TRACE_SEAMS_H
#define TAUT_CERTIFY_TRACE_SEAMS_H

#include "certify/trace/lines.h"
#include "taut/certify.h"

/* Two edges, u0, u1, v0, v1 of two surfaces, with one tangent plane all along and normals that agree. */
typedef struct taut_net_seam {
    int surfaces[2], edges[2];
    int is_proved; /* up to first derivatives, all along (taut/join.h) */
} taut_net_seam;

typedef struct taut_net_seams {
    const taut_surface *const *surfaces; /* at one scale */
    int count;
    taut_net_seam *list;
} taut_net_seams;

/* In the arena. TAUT_NO_MEMORY. */
taut_status taut_net_seams_new(taut_arena *arena, int count, const taut_surface *const *surfaces,
                               taut_net_seams *seams);
/* Does an edge join exactly one other? */
int taut_net_seams_join(const taut_net_seams *seams, int surface, int edge);

/* The claim `seams`: how far, where curves go on to another surface, the place of the second window is from
 * that of the first, over 1, and the normals from each other. A bound where the edges passed are proved to
 * join. */
taut_status taut_net_seams_add(const taut_net_seams *seams, const taut_net_lines *lines,
                               taut_certificate *certificate);

#endif /* TAUT_CERTIFY_TRACE_SEAMS_H */
