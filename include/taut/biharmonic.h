/* taut/biharmonic.h -- biharmonic Bezier surfaces: from four boundary rows, and their neighbours.
 *
 * A surface is biharmonic when the Laplacian of x_uu + x_vv vanishes in its own parameters:
 *     x_uuuu + 2 x_uuvv + x_vvvv = 0.
 * In bidegree (n, n) the four boundary rows, 4 n points, determine it. A biharmonic neighbour that
 * meets it with equal first (and second) derivatives is not determined: 2 (n - 1) numbers a
 * coordinate are free with C^1 contact, 2 floor((n - 1) / 2) with C^2; here they are chosen such
 * that the bending energy iint |x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2 du dv of the neighbour is least.
 * With C^3 contact it would be the surface itself carried on.
 *
 * Source: [NiWang2015] section 8.4.
 */
#ifndef TAUT_BIHARMONIC_H
#define TAUT_BIHARMONIC_H

#include "taut/construct.h"
#include "taut/join.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a surface is made from. */
typedef enum taut_biharmonic_given {
    TAUT_BIHARMONIC_ROWS = 0, /* four boundary rows: `rows` */
    TAUT_BIHARMONIC_NEIGHBOUR /* a surface that it meets: `neighbour` */
} taut_biharmonic_given;

typedef struct taut_biharmonic_rows {
    const char *name;           /* of the surface; NULL: "biharmonic" */
    const taut_basis *u, *v;    /* bezier, of one degree, any range */
    const double *points;       /* double[nu][nv][3]; inner points are not read */
    const unsigned char *known; /* [nu][nv]: the boundary, and nothing inside */
} taut_biharmonic_rows;

typedef struct taut_biharmonic_neighbour {
    const taut_surface *surface; /* bezier bases of one degree, no weights, biharmonic to 1e-10 */
    taut_edge edge;
    double width;              /* in parameter length; 0: that of the given surface */
    int contact;               /* 1 or 2: derivatives across the edge that are equal */
    int allow_ill_conditioned; /* nonzero: build also where rounding leaves nothing of least
                                * bending */
} taut_biharmonic_neighbour;

typedef struct taut_biharmonic_problem {
    taut_biharmonic_given given;
    union { /* the part that `given` names */
        taut_biharmonic_rows rows;
        taut_biharmonic_neighbour neighbour;
    };
} taut_biharmonic_problem;

/* Reasons: word, meaning, remedy. */
#define TAUT_BIHARMONIC_REASON_LIST(X)                                                             \
    X("mask", "the known points are not the four boundary rows",                                   \
      "give the whole boundary, and null inside")                                                  \
    X("not-bezier", "a basis is not of type bezier, or the given surface has weights",             \
      "give polynomial surfaces on bezier bases")                                                  \
    X("degree", "the two degrees differ, or are too high for a neighbour",                         \
      "raise the lower degree, or lower both")                                                     \
    X("ill-conditioned", "rounding in the data would leave too few digits of the result",          \
      "lower the degree, change the width, or allow it with \"allow_ill_conditioned\"")            \
    X("not-biharmonic", "the surface to meet is not biharmonic over its own rectangle",            \
      "give a biharmonic surface with all its digits")

/* From rows: one surface; details: amplification. A neighbour: the given surface and `extension`,
 * each with its rectangle; details: contact ("c1", "c2"), free (numbers chosen, a coordinate),
 * amplification (of rounding in the rows that meet).
 * TAUT_BAD_INPUT: not the boundary, other bases. TAUT_NO_SOLUTION: unequal degrees, a surface that
 * is not biharmonic, degrees (from 18 on a square) whose rows let rounding grow past 1e11;
 * where it is not allowed, neighbours in which it grows past 2e9, that miss the rows they meet by
 * 4 2^-52 of the size, or of a degree above 32. */
TAUT_API taut_status taut_biharmonic_make(const taut_biharmonic_problem *problem,
                                          const taut_make_options *options, taut_model **model,
                                          taut_error *error);

/* The certificate: claims biharmonic, boundary, of neighbours continuity and least-bending, and identity; figures
 * bending_energy. problem may be NULL: then without boundary. */
TAUT_API taut_status taut_biharmonic_certify(const taut_model *model,
                                             const taut_biharmonic_problem *problem,
                                             const taut_certify_options *options,
                                             taut_certificate **certificate, taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_BIHARMONIC_H */
