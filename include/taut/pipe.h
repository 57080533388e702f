/* taut/pipe.h -- a curved pipe between two straight ones, tangent-plane continuous at both joints.
 *
 * Two round pipes of radius a have axes that need not meet. Their axes are blended by one curve
 * with four points and three shape numbers, on the basis "ce-bezier":
 *     P(t) = sum_i V_i B_i(t; alpha, beta, gamma),   V_0, V_1 on axis 1, V_2, V_3 on axis 2
 * and a circle of radius a is swept along it, perpendicular to it:
 *     X(t, phi) = P(t) + a (cos phi U(t) + sin phi W(t)),   U, W, P'/|P'| a moving frame.
 * Pipe 1 flows along V_1 - V_0 and ends at V_0, pipe 2 starts at V_3 and flows along V_3 - V_2. The
 * three cut neither themselves nor each other where a is below the largest radius rho of the
 * composite axis.
 *
 * Source: [WangBai2018], corrected in docs/papers/pipe.md.
 */
#ifndef TAUT_PIPE_H
#define TAUT_PIPE_H

#include "taut/construct.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How the four points come about. */
typedef enum taut_pipe_axis {
    TAUT_PIPE_POLYGON = 0, /* given */
    TAUT_PIPE_ENDS,        /* V_0 and V_3 with the directions of flow there, and handles */
    TAUT_PIPE_FEET,        /* two lines: V_1 and V_2 are the feet of their common perpendicular */
    TAUT_PIPE_CORNERS,     /* a run along straight legs from corner to corner */
    TAUT_PIPE_LEGS         /* a run of straight pipes, each where it is */
} taut_pipe_axis;

typedef struct taut_pipe_end {
    double point[3];     /* V_0 or V_3; with TAUT_PIPE_FEET any point of the line */
    double direction[3]; /* of flow, not zero; any length */
    double handle;       /* |V_1 - V_0| or |V_3 - V_2|, > 0; 0: chosen */
} taut_pipe_end;

/* One of a run: a corner, or a straight pipe that flows from a place to another. */
typedef struct taut_pipe_leg {
    double from[3];      /* the corner, or where the pipe starts */
    double to[3];        /* where it ends; not used with TAUT_PIPE_CORNERS */
    double direction[3]; /* where to = from: of flow, not zero, of any length */
} taut_pipe_leg;

typedef enum taut_pipe_shape {
    TAUT_PIPE_SHAPE_GIVEN = 0,
    TAUT_PIPE_LEAST_BENDING,  /* least integral of curvature squared */
    TAUT_PIPE_LEAST_CURVATURE /* least largest curvature */
} taut_pipe_shape;

typedef enum taut_pipe_frame {
    TAUT_PIPE_ROTATION_MINIMIZING = 0,
    TAUT_PIPE_FRENET /* U the normal, W the binormal; they must exist all along */
} taut_pipe_frame;

typedef enum taut_pipe_joint {
    TAUT_PIPE_TANGENT = 0,    /* "g1": the quartic of the basis "ce-bezier" */
    TAUT_PIPE_CURVATURE_JOINT /* "g2": a quintic with three points on either axis */
} taut_pipe_joint;

typedef struct taut_pipe_section {
    double a, b;         /* semi-axes, > 0; a of both sections 0: round, by the radius */
    double direction[3]; /* of a; its part across the axis counts */
} taut_pipe_section;

typedef struct taut_pipe_problem {
    double radius;                 /* a > 0; not used with sections */
    taut_pipe_section sections[2]; /* at V_0 and V_3 */
    double radii[2];               /* > 0, round pipes of unlike radii; 0, 0: not so */
    int naive;                     /* nonzero: radii by the naive sweep, not the canal surface */
    taut_pipe_axis axis;
    double polygon[4][3];  /* TAUT_PIPE_POLYGON: V_0 .. V_3 */
    taut_pipe_end ends[2]; /* else */
    taut_pipe_shape shape;
    double alpha, beta, gamma; /* of the given shape */
    int extended;              /* nonzero: shape numbers outside the legal box are accepted */
    taut_pipe_frame frame;
    taut_pipe_joint joint;
    double lengths[2]; /* of the straight pipes, > 0; 0: half lines, drawn three radii long */
    int leg_count;     /* TAUT_PIPE_CORNERS, _LEGS: 2 or more; closed corners 3 or more */
    const taut_pipe_leg *legs;
    int closed;         /* nonzero: a run whose last leg is joined to its first */
    double bend_radius; /* the least radius of curvature of the axis, > 0; 0: none asked for, and
                         * three radii for TAUT_PIPE_CORNERS */
    int caps;           /* nonzero: discs over the free ends */
} taut_pipe_problem;

/* Makes the model: curve `axis` (ce-bezier, exact), surfaces `blend`, `pipe1`, `pipe2`. u runs
 * along the flow over [0, 1], v around from the frame's first vector; they share the basis of v,
 * and their rings at the joints point by point. The blend is within options->tolerance (times the
 * radius) of the exact tube, and exactly tangent to both cylinders, which are exact.
 *
 * Chosen: the shape, in alpha, gamma in (-3, 1], beta in [-3, 3], subject to radius < 0.999 rho;
 * handles of ends, least length times bending; handles of feet, equal, the shortest with rho at
 * least three radii (a long-radius elbow).
 *
 * With TAUT_PIPE_CURVATURE_JOINT the axis is the quintic Bezier curve of V_0, Q_1, V_1, V_2, Q_4,
 * V_3,
 *
 *     Q_1 = V_0 + (3 + alpha)/4 (V_1 - V_0),   Q_4 = V_3 - (3 + gamma)/4 (V_3 - V_2)
 *
 * without curvature at its ends, so that blend and cylinders have equal curvatures at the joints;
 * beta is 0.
 *
 * With sections the pipes are elliptic: the ellipse is carried along by the rotation-minimising
 * frame and turned by t^2 (3 - 2 t) (with TAUT_PIPE_CURVATURE_JOINT t^3 (10 - 15 t + 6 t^2)) of the
 * angle that is left, at most a right one. The circle around the larger is what must not cut
 * itself.
 *
 * With radii the blend is a canal surface, the envelope of spheres of radius r(t) = r_1 + (r_2 -
 * r_1) t^2 (3 - 2 t) about P(t); or the naive sweep of circles of that radius across the axis,
 * which is another surface. The tube of the larger radius is what must not cut itself.
 *
 * A run is a chain of straight pipes with a blend between each two, the frame carried through, and
 * one verdict over all of it. Its model has surfaces pipe1, blend1, pipe2, ... in the order of
 * flow, and a curve axis-pipe1, axis-blend1, ... for each; straight pipes of no length are left
 * out. Corners: every elbow is the shortest of its shape with the least radius of curvature asked
 * for. Legs: handles are chosen as those of ends. The frame of a closed run comes round turned;
 * what is left is distributed over its blends by their lengths. Not used: sections, radii, frame,
 * lengths, ends, polygon.
 *
 * With caps surfaces cap1 and cap2 stand behind the pipes whose free ends they close.
 *
 * TAUT_BAD_INPUT: numbers out of range. TAUT_BAD_ARGUMENT: NULL, or a tolerance below 1e-12.
 * TAUT_NO_SOLUTION, the message beginning with
 *
 *     DEGENERATE_EDGE        V_0 = V_1 or V_2 = V_3
 *     PARALLEL_AXES          no common perpendicular
 *     PARAMETER_DOMAIN       a shape number outside the legal box, not extended; beta with "g2"
 *     TANGENT_LOST           alpha or gamma at or below -3
 *     SECTION_ALONG          the direction of a section is along the axis
 *     TOO_SMALL              a length that is lost in the rounding of the coordinates, or none
 *     NOT_REGULAR            the axis has a cusp
 *     CANAL_NOT_REAL         the radius changes as fast as the axis runs
 *     CANAL_NOT_REGULAR      the spheres' envelope has a crease
 *     CANAL_JOINT            a canal surface with "g2"
 *     SELF_INTERSECT_LOCAL   the radius is not below the least radius of curvature
 *     SELF_INTERSECT_GLOBAL  the radius is not below half the distance of two parts of the axis
 *     BEND_RADIUS            the axis bends more sharply than bend_radius
 *     LEG_TOO_SHORT          two elbows do not fit on the leg between their corners
 *     TURNS_BACK             a corner at which the run turns back on itself
 *     RUN_STRAIGHT           no corner turns
 *     FRENET_UNDEFINED       the curvature vanishes where it takes the normal along; also with "g2"
 * with error->limit the largest radius that would work, for SELF_INTERSECT_*, the largest bend
 * radius for BEND_RADIUS and LEG_TOO_SHORT. */
TAUT_API taut_status taut_pipe_make(const taut_pipe_problem *problem,
                                    const taut_make_options *options, taut_model **model,
                                    taut_error *error);

/* Proves it again: claims joint1, joint2, embedded, tube, for "g2" curvature1 and curvature2, and
 * with a problem ends, and optimal where the shape was chosen; of a canal surface regular and
 * graph; with caps caps; of a run joints, curvatures, embedded, tube, ends, bend_radius
 * (docs/pipe.md). problem may be NULL. */
TAUT_API taut_status taut_pipe_certify(const taut_model *model, const taut_pipe_problem *problem,
                                       const taut_certify_options *options,
                                       taut_certificate **certificate, taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_PIPE_H */
