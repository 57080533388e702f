/* taut/asymptotic.h -- a rational patch whose four boundary curves are asymptotic curves.
 *
 * On an asymptotic curve the normal curvature vanishes: the surface's tangent plane is the
 * curve's osculating plane. Algorithm 1 finds four rational Bezier curves of degree n that can
 * bound such a patch, from corner points, end legs, end curvatures and end weights; Algorithm 2
 * builds the patch on them. Source: [WangZhuLi2017], corrected in docs/papers/asymptotic.md.
 *
 * Edges are named by the parameter held, and numbered as the source numbers its curves:
 *     0  v0   u runs, from corner u0v0 to u1v0      1  u0   v runs, from u0v0 to u0v1
 *     2  v1   u runs, from u0v1 to u1v1             3  u1   v runs, from u1v0 to u1v1
 */
#ifndef TAUT_ASYMPTOTIC_H
#define TAUT_ASYMPTOTIC_H

#include "taut/construct.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    TAUT_ASYMPTOTIC_DEGREE_MAX = 8, /* of the boundary curves; the least is 3 */
    TAUT_ASYMPTOTIC_V0 = 0,         /* edges */
    TAUT_ASYMPTOTIC_U0 = 1,
    TAUT_ASYMPTOTIC_V1 = 2,
    TAUT_ASYMPTOTIC_U1 = 3,
    TAUT_ASYMPTOTIC_U0V0 = 0, /* corners */
    TAUT_ASYMPTOTIC_U1V0 = 1,
    TAUT_ASYMPTOTIC_U0V1 = 2,
    TAUT_ASYMPTOTIC_U1V1 = 3
};

/* What is given of one boundary curve with points P_0 .. P_n and weights w_0 .. w_n. */
typedef struct taut_asymptotic_edge {
    double legs[2][3];   /* P_1 - P_0 and P_n - P_(n-1); degree 3: only the first */
    double curvature[2]; /* at the ends, positive; both 0 for a straight edge; degree 3: not read */
    double weights[4];   /* w_0 and w_n; degree 3: all four. Equal where edges meet */
} taut_asymptotic_edge;

typedef enum taut_asymptotic_surface {
    TAUT_BIDEGREE_5N_MINUS_7 = 0, /* the source's bidegree, 5n - 7 */
    TAUT_BIDEGREE_N_PLUS_3 = 1    /* the low-degree patch, n + 3 */
} taut_asymptotic_surface;

typedef struct taut_asymptotic_problem {
    int degree; /* of the boundary, 3..TAUT_ASYMPTOTIC_DEGREE_MAX; not read with curves */
    double corners[4][3];
    taut_asymptotic_edge edges[4];
    /* All four, in the order of the edges, on "bezier" bases over [0, 1], or all NULL; given, they
     * are the boundary and corners and edges above are not read. Raised to a common degree. */
    const taut_curve *curves[4];
    int has_branch; /* nonzero: take the branch below; 0: the one of lowest energy */
    int branch[4];  /* sign of mu on each edge, in the order of the edges: 1, -1; 0 if straight */
    taut_asymptotic_surface surface;
    int report_singular; /* nonzero: build a patch with singular boundary points all the same */
    int free_all; /* nonzero: the free alpha are found together with the inner points, not 0 */
} taut_asymptotic_problem;

/* Makes the model: surface `patch`, curves `v0`, `v1`, `u0`, `u1`; details curve_energy, degree,
 * branch, branches, edges, corners. TAUT_BAD_INPUT: data out of range; TAUT_NO_SOLUTION: no such
 * quadrilateral, or no regular patch on it: *error says which condition fails, by how much, and
 * what is nearest. Cost: O(m^6) for a patch of bidegree m. */
TAUT_API taut_status taut_asymptotic_make(const taut_asymptotic_problem *problem,
                                          const taut_make_options *options, taut_model **model,
                                          taut_error *error);

/* The certificate: claims boundary, asymptotic, osculating, regular, positive-weights; figures
 * bending_energy, smallest_weight, asymptotic_bound and, by edge name, edges. */
TAUT_API taut_status taut_asymptotic_certify(const taut_model *model,
                                             const taut_asymptotic_problem *problem,
                                             const taut_certify_options *options,
                                             taut_certificate **certificate, taut_error *error);

/* "v0", "u0", "v1", "u1" and "u0v0", "u1v0", "u0v1", "u1v1"; NULL for others. */
TAUT_API const char *taut_asymptotic_edge_name(int edge);
TAUT_API const char *taut_asymptotic_corner_name(int corner);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_ASYMPTOTIC_H */
