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

typedef struct taut_harmonic_problem {
    const char *name;           /* of the surface; NULL: "harmonic" */
    const taut_basis *u, *v;    /* bezier, any range */
    const double *points;       /* double[nu][nv][3]; unknown points are not read */
    const unsigned char *known; /* [nu][nv]: two opposite boundary rows, or columns */
    int fit; /* nonzero: all four boundary rows are known, and the harmonic surface nearest to them
              * is wanted: the sum over the edges of the mean squared distance, each edge by its
              * normalised parameter, is least */
    int from_derivative; /* nonzero: complete from edge u0 and the derivative across it */
    const double *edge;  /* double[nv][3]: Bernstein coefficients of x along u0 */
    const double *cross_derivative; /* double[nv][3]: of dx/du along u0 */
    /* Texts "p/q" of the same numbers where they are rational, for options->exact; NULL: none. */
    const char *const *exact_points;           /* [nu][nv][3] */
    const char *const *exact_edge;             /* [nv][3] */
    const char *const *exact_cross_derivative; /* [nv][3] */
    taut_harmonic_even even;
    int insist; /* nonzero: complete even where the amplification says that the result
                 * means nothing (degree above about 20) */
} taut_harmonic_problem;

/* Makes the surface. details: amplification, repair (null, or kind and change), warnings.
 * TAUT_NO_SOLUTION when rows of even degree do not agree (found: the defect), when the
 * amplification is past 1e15 without `insist`, when the transverse degree is too low for the rows.
 */
TAUT_API taut_status taut_harmonic_make(const taut_harmonic_problem *problem,
                                        const taut_make_options *options, taut_model **model,
                                        taut_error *error);

typedef enum taut_contact {
    TAUT_CONTACT_C1 = 0, /* equal derivatives: the continuation of the polynomial itself */
    TAUT_CONTACT_G1      /* equal tangent planes: Q_u = c P_u + (alpha + beta v) P_v on the edge */
} taut_contact;

typedef struct taut_harmonic_extension_problem {
    const taut_surface *surface; /* bezier bases, no weights, harmonic to 1e-10 (section 3 A) */
    taut_edge edge;
    double width;                  /* in parameter length; 0: that of the given surface */
    const taut_surface *neighbour; /* NULL, or the other piece of one surface, which is to be merged
                                    * with the first: u and v run as they do there, its range may
                                    * begin anywhere. No width and contact c1 then */
    taut_contact contact;
    double c, alpha, beta; /* contact g1: c > 0; v runs from 0 to 1 along the edge */
} taut_harmonic_extension_problem;

/* The model holds the given surface, `extension`, and (contact c1) the merged one, `h`; each
 * carries its rectangle. details: amplification. TAUT_NO_SOLUTION: not harmonic; `neighbour` is not
 * the same surface (found: the gap). */
TAUT_API taut_status taut_harmonic_extension_make(const taut_harmonic_extension_problem *problem,
                                                  const taut_make_options *options,
                                                  taut_model **model, taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_HARMONIC_H */
