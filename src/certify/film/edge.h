/* edge.h -- an edge of a film that is held: how far from its curve, or its chord, and what is allowed.
 *
 * The limit is twice what a least squares fit of the certificate's own is proved to be off by, where the curve is none of the
 * edge's space, and rounding. Of several edges the one that comes nearest to its limit, or is farthest beyond it, is kept.
 */
#ifndef TAUT_CERTIFY_FILM_EDGE_H
#define TAUT_CERTIFY_FILM_EDGE_H

#include "taut/curve.h"
#include "taut/model.h"

/* What an edge has to be. */
typedef struct taut_film_asked {
    const taut_curve *curve; /* or NULL: the chord */
    double ends[2][3];
    int is_fitted;     /* nonzero: the curve is fitted whatever its basis */
    double size, away; /* of the film, and of it from the origin */
} taut_film_asked;

typedef struct taut_film_boundary {
    double residual, limit;
    int count, fitted; /* edges; nonzero: one of them is held on a curve of another basis */
} taut_film_boundary;

/* Edge e of a surface; *is_worst: it is the one that is kept now. */
taut_status taut_film_judge_edge(const taut_surface *surface, int e, const taut_film_asked *asked,
                                 taut_film_boundary *boundary, int *is_worst, taut_error *error);

/* The first surface of a name, or NULL. */
const taut_surface *taut_film_find_surface(const taut_model *model, const char *name);

#endif /* TAUT_CERTIFY_FILM_EDGE_H */
