/* taut/panels.h -- minimal surfaces with planar curvature lines as meshes of plane quads, exact.
 *
 * With the window of taut/bonnet.h cut in NU by NV cells of size a by b:
 *
 *     conical     vertex (i, j) is where the tangent planes n.X = h at the four nodes
 *                 (u_i +- a/2, v_j +- b/2) meet: n and h are each a function of u plus one of v, so
 *                 that they do meet in a point. Panels are tangent to the surface; at each inner
 *                 vertex the panels touch a cone: offsets at constant distance are exact, beams
 *                 meet without twist.
 *     circular    vertex (n, m) is ((lambda n sin a + s sin u cosh v) / w,
 *                                   (m sinh b + s lambda cos u sinh v) / w, s cos u cosh v)
 *                 at u = u_0 + n a, v = v_0 + m b: each panel has a circumcircle.
 *
 * Both tend to the surface like a^2 + b^2. Only for theta = 0: other associates have no curvature
 * lines along their parameters. Source: docs/papers/minimal-mesh.md; [XuWang2006] for the surface.
 */
#ifndef TAUT_PANELS_H
#define TAUT_PANELS_H

#include "taut/bonnet.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Panels around a vertex touch one cone, or the corners of a panel lie on one circle. */
typedef enum taut_panels_kind { TAUT_PANELS_CONICAL = 0, TAUT_PANELS_CIRCULAR } taut_panels_kind;

typedef struct taut_panels_options {
    taut_panels_kind kind;
    int divide[2];       /* panels along u and along v, >= 1; 0: 8 */
    const char *surface; /* of a model: only the surface of this name; NULL: all */
    taut_monitor monitor;
} taut_panels_options;

/* Reasons: word, meaning, remedy. */
#define TAUT_PANELS_REASON_LIST(X)                                                                 \
    X("theta", "theta is not 0: the parameter lines are no lines of curvature",                    \
      "take the surface of theta 0")                                                               \
    X("large-panels", "the tangent planes of so large panels do not meet near the surface",        \
      "use more panels")                                                                           \
    X("enneper", "a net that is Enneper's surface says nothing of its panels",                     \
      "make them from its problem, with \"normalize\": true and \"lambda\": 1")                    \
    X("no-surface", "the model has no surface", "give a model with surfaces of the family")

/* The panels as a model: per surface one bspline surface of degree (1, 1) whose points are the
 * vertices, (NU+1) x (NV+1), over the window's parameters; written as a mesh with divide 1, its
 * quads are the panels. details: kind, divide, and (a number, or a list for several surfaces)
 *
 *     planarity  largest distance between the diagonals of a panel over their mean length
 *     balance    conical: largest |w1 - w2 + w3 - w4| of the angles around an inner vertex, in
 *                radians; null without inner vertices
 *     circle     circular: largest |sum of two opposite angles - pi| of a panel
 *     distance   largest distance of a vertex from the point of the surface at its parameters
 *
 * TAUT_NO_SOLUTION: theta is not 0 (or pi); a step in u of pi or more, or so large steps that the
 * tangent planes of neighbours no longer meet near the surface (found: the share that is left of
 * the angle, limit: what must be). TAUT_BAD_INPUT: more than TAUT_POINTS_MAX vertices.
 */
TAUT_API taut_status taut_panels_of_bonnet(const taut_bonnet_problem *problem,
                                           const taut_panels_options *options, taut_model **panels,
                                           taut_error *error);
/* A problem read from a document: of construct bonnet, or else it is made and recognised. */
TAUT_API taut_status taut_panels_of_problem(const taut_problem *problem,
                                            const taut_panels_options *options, taut_model **panels,
                                            taut_error *error);
/* The surfaces of any model, each recognised by taut/recognise.h first; TAUT_NO_SOLUTION where one
 * is not of the family. */
TAUT_API taut_status taut_panels_of_model(const taut_model *model,
                                          const taut_panels_options *options, taut_model **panels,
                                          taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_PANELS_H */
