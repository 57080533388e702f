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

/* What the boundary is made from. */
typedef enum taut_asymptotic_given {
    TAUT_ASYMPTOTIC_CORNERS = 0, /* corner points and what is given of each edge: `corners` */
    TAUT_ASYMPTOTIC_CURVES       /* the curves themselves: `curves` */
} taut_asymptotic_given;

typedef struct taut_asymptotic_corners {
    int degree; /* of the boundary, 3..TAUT_ASYMPTOTIC_DEGREE_MAX */
    double points[4][3];
    taut_asymptotic_edge edges[4];
    int has_branch; /* nonzero: take the branch below; 0: the one of lowest energy */
    int branch[4];  /* sign of mu on each edge, in the order of the edges: 1, -1; 0 if straight */
} taut_asymptotic_corners;

typedef struct taut_asymptotic_problem {
    taut_asymptotic_given given;
    union { /* the part that `given` names */
        taut_asymptotic_corners corners;
        /* All four, in the order of the edges, on "bezier" bases over [0, 1]; raised to a common
         * degree. */
        const taut_curve *curves[4];
    };
    taut_asymptotic_surface surface;
    int report_singular; /* nonzero: build a patch with singular boundary points all the same */
    int free_all; /* nonzero: the free alpha are found together with the inner points, not 0 */
} taut_asymptotic_problem;

/* Reasons: word, meaning, remedy. */
#define TAUT_ASYMPTOTIC_REASON_LIST(X)                                                             \
    X("not-bezier", "a curve is not a bezier curve over [0, 1]", "give bezier curves over [0, 1]") \
    X("far-away", "the corners are so far from the origin that few of their digits are left",      \
      "move the origin nearer")                                                                    \
    X("too-large", "a length is too large or too small for products of eight lengths",             \
      "take another unit of length")                                                               \
    X("same-corner", "an edge begins and ends at the same corner point", "move a corner")          \
    X("not-closed", "two curves do not meet at their corner",                                      \
      "reverse the curves that the message names, or correct their end points")                    \
    X("end-weights", "the weights of two edges differ at the corner where they meet",              \
      "take the weights that the message names")                                                   \
    X("no-leg", "a control point lies on the corner beside it", "move it off the corner")          \
    X("parallel-legs", "the legs of two edges are parallel at their corner",                       \
      "turn a leg: the two span the tangent plane")                                                \
    X("parallel-planes", "the tangent planes at the two ends of an edge are parallel",             \
      "turn one of its legs or of the legs it meets")                                              \
    X("straight-edge", "an edge is straight at its ends but its legs leave the chord",             \
      "put the legs on the chord and within it, or give curvatures")                               \
    X("cannot-bend", "a leg lies along the line common to the tangent planes at its edge's ends",  \
      "turn the leg or those it meets")                                                            \
    X("turns-over", "an edge would bend to different sides at its two ends",                       \
      "turn one of its legs or of the legs it meets")                                              \
    X("no-curvature", "a curved edge has curvature 0 at an end, and no osculating plane there",    \
      "move its second control point off the leg")                                                 \
    X("osculating-plane",                                                                          \
      "an osculating plane at a corner does not hold the other edge's tangent",                    \
      "move control points into the tangent plane of the corner")                                  \
    X("torsion", "the torsions of two edges at their corner are not opposite",                     \
      "multiply inner weights by the factors that the message names")                              \
    X("torsion-signs", "no sides to bend to give opposite torsions at all four corners",           \
      "turn the leg that the message names")                                                       \
    X("closing", "the torsions cannot close around the four corners",                              \
      "take the curvatures or legs that the message names")                                        \
    X("no-minimum", "the curve energy has no minimum", "change legs, curvatures or the degree")    \
    X("no-branch", "there is no branch of the signs that were asked for",                          \
      "ask for one that the message names, or for \"lowest\"")                                     \
    X("singular", "the normal would have to turn over along an edge",                              \
      "change the legs, or build it with \"singular\": \"report\"")                                \
    X("inflection", "the patch of degree n+3 would be singular at an edge's inflection",           \
      "take surface \"5n-7\"")                                                                     \
    X("twist", "two edges have no common twist at their corner",                                   \
      "make their torsions opposite there")                                                        \
    X("negative-weight", "a weight beside the boundary does not come out positive",                \
      "take end weights and curvatures that differ less, or the other surface")                    \
    X("ill-conditioned", "the least-squares problem for the inner points is singular",             \
      "take weights that differ less")

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
