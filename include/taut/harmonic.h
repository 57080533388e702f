/* taut/harmonic.h -- harmonic Bezier surfaces: completed from their edges, and extended.
 *
 * A surface over the parameter rectangle of widths a, b is harmonic when x_uu + x_vv = 0 in its own
 * parameters. In normalised parameters (each in [0, 1]) that is P_uu / a^2 + P_vv / b^2 = 0, so
 * every formula carries mu = (a / b)^2. Harmonic nets are rigid: two opposite rows decide all the
 * others, and a harmonic surface has just one harmonic neighbour that meets it with equal
 * derivatives.
 *
 * Source: [NiWang2015] sections 2.2 to 2.7, 3, 8.2, 8.3, 8.6.
 */
#ifndef TAUT_HARMONIC_H
#define TAUT_HARMONIC_H

#include "taut/construct.h"
#include "taut/join.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What to do when rows of even degree n, in bidegree (n, n), over-determine the surface. */
typedef enum taut_harmonic_even {
    TAUT_EVEN_REFUSE = 0, /* TAUT_NO_SOLUTION with the defect */
    TAUT_EVEN_CORNER,     /* replace the last point of the second row */
    TAUT_EVEN_PROJECT,    /* the least change of both rows */
    TAUT_EVEN_RAISE       /* bidegree (n+1, n), which asks for nothing */
} taut_harmonic_even;

/* What a surface is made from. */
typedef enum taut_harmonic_given {
    TAUT_HARMONIC_ROWS = 0,   /* two opposite boundary rows, or columns: `rows` */
    TAUT_HARMONIC_DERIVATIVE, /* edge u0 and the derivative across it: `derivative` */
    TAUT_HARMONIC_BOUNDARY    /* four boundary rows, which it comes nearest to: `boundary` */
} taut_harmonic_given;

/* Texts "p/q" of numbers, where they are rational, are for options->exact; NULL: none. */
typedef struct taut_harmonic_rows {
    const double *points;       /* double[nu][nv][3]; unknown points are not read */
    const unsigned char *known; /* [nu][nv]: the mask of the two rows or columns */
    const char *const *exact;   /* [nu][nv][3], of the points */
    taut_harmonic_even even;
    int allow_ill_conditioned; /* nonzero: complete even where the amplification says that the
                                * result means nothing (degree above about 20) */
} taut_harmonic_rows;

typedef struct taut_harmonic_derivative {
    const double *edge;             /* double[nv][3]: Bernstein coefficients of x along u0 */
    const double *cross;            /* double[nv][3]: of dx/du along u0 */
    const char *const *exact_edge;  /* [nv][3] */
    const char *const *exact_cross; /* [nv][3] */
    int raise;                      /* nonzero: what TAUT_EVEN_RAISE does, else TAUT_EVEN_REFUSE */
    int allow_ill_conditioned;      /* as of rows */
} taut_harmonic_derivative;

/* The sum over the edges of the mean squared distance, each edge by its normalised parameter, is
 * least. Not in rational arithmetic. */
typedef struct taut_harmonic_boundary {
    const double *points;       /* double[nu][nv][3]; inner points are not read */
    const unsigned char *known; /* [nu][nv]: the boundary, and nothing inside */
} taut_harmonic_boundary;

typedef struct taut_harmonic_problem {
    const char *name;        /* of the surface; NULL: "harmonic" */
    const taut_basis *u, *v; /* bezier, any range */
    taut_harmonic_given given;
    union { /* the part that `given` names */
        taut_harmonic_rows rows;
        taut_harmonic_derivative derivative;
        taut_harmonic_boundary boundary;
    };
} taut_harmonic_problem;

/* Reasons of both constructions here: word, meaning, remedy. */
#define TAUT_HARMONIC_REASON_LIST(X)                                                               \
    X("mask", "the known points are not those that the way of making the surface takes",           \
      "give two opposite rows or columns, with \"fit\" the whole boundary, and null elsewhere")    \
    X("not-bezier", "a basis is not of type bezier, or a given surface has weights",               \
      "give polynomial surfaces on bezier bases")                                                  \
    X("rational", "a known curve of a boundary file has weights that differ",                      \
      "give polynomial curves: harmonic surfaces are polynomial")                                  \
    X("degree", "the degrees leave no such surface: too low across the edge, or too high to fit",  \
      "raise or lower the degree that the message names")                                          \
    X("inconsistent", "data of even degree asks for more than the bidegree can hold",              \
      "choose a repair with \"even\", or take an odd degree")                                      \
    X("ill-conditioned", "rounding in the data would grow past 1e15 times",                        \
      "lower the degree, give data from one edge, or allow it with \"allow_ill_conditioned\"")     \
    X("overflow", "the control points are too large for doubles", "lower the degree")              \
    X("not-harmonic", "the surface to extend is not harmonic over its own rectangle",              \
      "give a harmonic surface with all its digits")                                               \
    X("other-surface", "the neighbour is no piece of the same surface",                            \
      "give the piece across that edge, u and v as in the surface")

/* Makes the surface. details: amplification, repair (null, or kind and change), warnings.
 * TAUT_NO_SOLUTION when rows of even degree do not agree (found: the defect), when the
 * amplification is past 1e15 and that is not allowed, when the transverse degree is too low for the
 * rows. */
TAUT_API taut_status taut_harmonic_make(const taut_harmonic_problem *problem,
                                        const taut_make_options *options, taut_model **model,
                                        taut_error *error);

/* The certificate: claims harmonic, boundary (nearest, of a fit), identity; figures dirichlet_energy, isothermality, and of
 * a fit boundary_gap and where it is. problem may be NULL: then without boundary. */
TAUT_API taut_status taut_harmonic_certify(const taut_model *model,
                                           const taut_harmonic_problem *problem,
                                           const taut_certify_options *options,
                                           taut_certificate **certificate, taut_error *error);

/* How the surface beyond the edge is found. */
typedef enum taut_extension_given {
    TAUT_EXTENSION_C1 = 0, /* equal derivatives: the polynomial itself carried on: `c1` */
    TAUT_EXTENSION_G1,     /* equal tangent planes: Q_u = c P_u + (alpha + beta v) P_v: `g1` */
    TAUT_EXTENSION_MERGE   /* it is given, a piece of the same surface: `merge` */
} taut_extension_given;

typedef struct taut_extension_c1 {
    double width; /* in parameter length; 0: that of the given surface */
} taut_extension_c1;

typedef struct taut_extension_g1 {
    double width;          /* as of c1 */
    double c, alpha, beta; /* c > 0; v runs from 0 to 1 along the edge */
} taut_extension_g1;

typedef struct taut_extension_merge {
    const taut_surface *neighbour; /* u and v run as in the surface, the range may begin anywhere */
} taut_extension_merge;

typedef struct taut_harmonic_extension_problem {
    const taut_surface *surface; /* bezier bases, no weights, harmonic to 1e-10 (section 3 A) */
    taut_edge edge;
    taut_extension_given given;
    union { /* the part that `given` names */
        taut_extension_c1 c1;
        taut_extension_g1 g1;
        taut_extension_merge merge;
    };
} taut_harmonic_extension_problem;

/* The model holds the given surface, `extension`, and (but with g1) the merged one, `h`; each
 * carries its rectangle. details: amplification. TAUT_NO_SOLUTION: not harmonic; the neighbour is
 * not the same surface (found: the gap). */
TAUT_API taut_status taut_harmonic_extension_make(const taut_harmonic_extension_problem *problem,
                                                  const taut_make_options *options,
                                                  taut_model **model, taut_error *error);

/* The certificate: claims harmonic, boundary, continuity, with g1 contact, else merged, and identity; the figures of
 * taut_harmonic_certify, one number a surface. problem may be NULL: then without boundary. */
TAUT_API taut_status taut_harmonic_extension_certify(const taut_model *model,
                                                     const taut_harmonic_extension_problem *problem,
                                                     const taut_certify_options *options,
                                                     taut_certificate **certificate,
                                                     taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_HARMONIC_H */
