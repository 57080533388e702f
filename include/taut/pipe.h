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
typedef enum taut_pipe_axis_kind {
    TAUT_PIPE_POLYGON = 0, /* given */
    TAUT_PIPE_ENDS,        /* V_0 and V_3 with the directions of flow there, and handles */
    TAUT_PIPE_FEET         /* two lines: V_1 and V_2 are the feet of their common perpendicular */
} taut_pipe_axis_kind;

typedef struct taut_pipe_end {
    double point[3];     /* V_0 or V_3; with TAUT_PIPE_FEET any point of the line */
    double direction[3]; /* of flow, not zero; any length */
    double handle;       /* |V_1 - V_0| or |V_3 - V_2|, > 0; 0: chosen */
} taut_pipe_end;

typedef struct taut_pipe_axis {
    taut_pipe_axis_kind kind;
    union {
        double polygon[4][3];  /* TAUT_PIPE_POLYGON: V_0 .. V_3 */
        taut_pipe_end ends[2]; /* TAUT_PIPE_ENDS, TAUT_PIPE_FEET */
    };
} taut_pipe_axis;

/* What the straight pipes are across, and the blend between them. */
typedef enum taut_pipe_section_kind {
    TAUT_PIPE_ROUND = 0,  /* of one radius */
    TAUT_PIPE_ELLIPTIC,   /* an ellipse at either end */
    TAUT_PIPE_CANAL,      /* of two radii: the canal surface */
    TAUT_PIPE_NAIVE_SWEEP /* of two radii: circles across the axis */
} taut_pipe_section_kind;

typedef struct taut_pipe_ellipse {
    double a, b;         /* semi-axes, > 0 */
    double direction[3]; /* of a, not zero; its part across the axis counts */
} taut_pipe_ellipse;

typedef struct taut_pipe_section {
    taut_pipe_section_kind kind;
    union {
        double radius;                 /* TAUT_PIPE_ROUND: a > 0 */
        taut_pipe_ellipse ellipses[2]; /* TAUT_PIPE_ELLIPTIC: at V_0 and V_3 */
        double radii[2];               /* TAUT_PIPE_CANAL, TAUT_PIPE_NAIVE_SWEEP: > 0, there */
    };
} taut_pipe_section;

typedef enum taut_pipe_shape_kind {
    TAUT_PIPE_SHAPE_GIVEN = 0,
    TAUT_PIPE_LEAST_BENDING,  /* least integral of curvature squared */
    TAUT_PIPE_LEAST_CURVATURE /* least largest curvature */
} taut_pipe_shape_kind;

typedef struct taut_pipe_shape {
    taut_pipe_shape_kind kind;
    double alpha, beta, gamma; /* TAUT_PIPE_SHAPE_GIVEN; beta is 0 with TAUT_PIPE_G2 */
    int extended;              /* nonzero: numbers outside the legal box are accepted */
} taut_pipe_shape;

typedef enum taut_pipe_joint {
    TAUT_PIPE_G1 = 0, /* equal tangent planes: the quartic of the basis "ce-bezier" */
    TAUT_PIPE_G2      /* equal curvatures: a quintic with three points on either axis */
} taut_pipe_joint;

typedef enum taut_pipe_frame {
    TAUT_PIPE_ROTATION_MINIMIZING = 0,
    TAUT_PIPE_FRENET /* U the normal, W the binormal; they must exist all along; of round pipes */
} taut_pipe_frame;

typedef struct taut_pipe_problem {
    taut_pipe_axis axis;
    taut_pipe_section section;
    taut_pipe_shape shape;
    taut_pipe_joint joint;
    taut_pipe_frame frame;
    double lengths[2];  /* of the straight pipes, > 0; 0: half lines, drawn three radii long */
    double bend_radius; /* the least radius of curvature of the axis, > 0; 0: none asked for */
    int caps;           /* nonzero: discs over the free ends */
} taut_pipe_problem;

/* One straight pipe of a run. */
typedef enum taut_pipe_leg_kind {
    TAUT_PIPE_LEG_SPAN = 0, /* flows from one place to another */
    TAUT_PIPE_LEG_POINT     /* of no length: flows through a place in a direction */
} taut_pipe_leg_kind;

typedef struct taut_pipe_leg {
    taut_pipe_leg_kind kind;
    double from[3]; /* where it starts, or the place */
    union {
        double to[3];        /* TAUT_PIPE_LEG_SPAN: where it ends, apart from `from` */
        double direction[3]; /* TAUT_PIPE_LEG_POINT: of flow, not zero; any length */
    };
} taut_pipe_leg;

/* Where a run goes. */
typedef enum taut_pipe_route_kind {
    TAUT_PIPE_CORNERS = 0, /* straight from corner to corner, rounded there */
    TAUT_PIPE_LEGS         /* along straight pipes, each where it is */
} taut_pipe_route_kind;

typedef struct taut_pipe_route {
    taut_pipe_route_kind kind;
    int count; /* 2 or more; of closed corners 3 or more */
    union {
        const double *corners;     /* TAUT_PIPE_CORNERS: double[count][3] */
        const taut_pipe_leg *legs; /* TAUT_PIPE_LEGS: taut_pipe_leg[count] */
    };
    int closed; /* nonzero: the last is joined to the first */
} taut_pipe_route;

/* What rounds a corner of a run. */
typedef enum taut_pipe_elbow_kind {
    TAUT_PIPE_ELBOW_BLEND = 0, /* a blend, whose curvature grows from its ends */
    TAUT_PIPE_ELBOW_ARC /* a circular arc of the bend radius, as tube benders bend: a torus */
} taut_pipe_elbow_kind;

/* A run: round pipes of one radius, one after the other. */
typedef struct taut_pipe_run_problem {
    taut_pipe_route route;
    double radius;         /* > 0 */
    taut_pipe_shape shape; /* of every blend */
    taut_pipe_joint joint;
    double bend_radius; /* as above; 0: three radii for TAUT_PIPE_CORNERS, none for others */
    int caps;           /* nonzero: discs over the free ends, where it has any */
    taut_pipe_elbow_kind
        elbow; /* with TAUT_PIPE_ELBOW_ARC corners, `shape` has no part, and TAUT_PIPE_G1 */
    double
        wall; /* > 0, below the radius: an inner surface as far inside, rings over the free ends of an open
                  * run; 0: none */
} taut_pipe_run_problem;

/* What can be wrong with what is asked for, but for numbers out of range ("value", "size"): word,
 * meaning, remedy. */
#define TAUT_PIPE_REASON_LIST(X)                                                                   \
    X("arc-frame", "a closed run of arcs comes round turned, and arcs do not turn it back",        \
      "leave \"elbow\" out, or keep the corners in one plane")                                     \
    X("bend-radius", "the axis bends more sharply than the bend radius asked for",                 \
      "ask for the one named, or take ends farther apart")                                         \
    X("canal-joint", "a canal surface is joined with equal curvatures",                            \
      "join it with \"g1\", or take the naive sweep")                                              \
    X("canal-not-real", "the radius changes as fast as the axis runs",                             \
      "take radii nearer to each other, ends farther apart, longer handles")                       \
    X("canal-not-regular", "the envelope of the spheres has a crease",                             \
      "take smaller radii, nearer to each other, or ends farther apart")                           \
    X("degenerate-edge", "V_0 = V_1 or V_2 = V_3", "move the points apart")                        \
    X("frenet-undefined", "Frenet's frame has no value somewhere, or sections have their own",     \
      "take the rotation-minimizing one")                                                          \
    X("leg-too-short", "the elbows at both ends of a leg take more than it has",                   \
      "ask for the bend radius named, or make the leg as long as named")                           \
    X("not-regular", "the axis has a cusp", "take other shape numbers or shorter handles")         \
    X("parallel-axes", "two lines have no common perpendicular of their own",                      \
      "say where each pipe ends")                                                                  \
    X("parameter-domain", "a shape number is outside the legal box, or beta with \"g2\"",          \
      "stay in the box, or ask for the extended domain")                                           \
    X("run-straight", "no corner of the run turns", "give a corner off the line")                  \
    X("section-along", "the direction of a section is along the axis", "give one across it")       \
    X("self-intersect-global", "two parts of the pipe touch", "take a radius below the one named") \
    X("self-intersect-local", "the radius is not below the least radius of curvature",             \
      "take a radius below the one named")                                                         \
    X("tangent-lost", "alpha or gamma is at or below -3", "take more")                             \
    X("too-fine", "the tube would need more than 100000 segments for this tolerance",              \
      "ask for a larger tolerance, or for a smaller radius")                                       \
    X("too-small", "a length is lost in the rounding of the coordinates, or is 0",                 \
      "move the origin near, or give one place for both")                                          \
    X("turns-back", "a run turns back on itself at a corner", "give two corners in its place")

/* Makes the model: curve `axis` (ce-bezier, exact), surfaces `blend`, `pipe1`, `pipe2`. u runs
 * along the flow over [0, 1], v around from the frame's first vector; they share the basis of v,
 * and their rings at the joints point by point. The blend is within options->tolerance (times the
 * radius) of the exact tube, and exactly tangent to both cylinders, which are exact.
 *
 * Chosen: the shape, in alpha, gamma in (-3, 1], beta in [-3, 3], subject to radius < 0.999 rho;
 * handles of ends, least length times bending; handles of feet, equal, the shortest with rho at
 * least three radii (a long-radius elbow).
 *
 * With TAUT_PIPE_G2 the axis is the quintic Bezier curve of V_0, Q_1, V_1, V_2, Q_4, V_3,
 *
 *     Q_1 = V_0 + (3 + alpha)/4 (V_1 - V_0),   Q_4 = V_3 - (3 + gamma)/4 (V_3 - V_2)
 *
 * without curvature at its ends, so that blend and cylinders have equal curvatures at the joints;
 * beta is 0.
 *
 * An ellipse is carried along by the rotation-minimising frame and turned by t^2 (3 - 2 t) (with
 * TAUT_PIPE_G2 t^3 (10 - 15 t + 6 t^2)) of the angle that is left, at most a right one. The circle
 * around the larger is what must not cut itself.
 *
 * A canal surface is the envelope of spheres of radius r(t) = r_1 + (r_2 - r_1) t^2 (3 - 2 t) about
 * P(t); the naive sweep, of circles of that radius across the axis, is another surface. The tube of
 * the larger radius is what must not cut itself.
 *
 * With caps surfaces cap1 and cap2 stand behind the pipes whose free ends they close.
 *
 * TAUT_BAD_INPUT: numbers out of range. TAUT_BAD_ARGUMENT: NULL, or a tolerance below 1e-12.
 * TAUT_NO_SOLUTION, with a reason of the list above: error->limit is the largest radius that would
 * work for self-intersect-local and -global, the largest bend radius for bend-radius and
 * leg-too-short. */
TAUT_API taut_status taut_pipe_make(const taut_pipe_problem *problem,
                                    const taut_make_options *options, taut_model **model,
                                    taut_error *error);

/* A run is a chain of straight pipes with a blend between each two, the frame carried through, and
 * one verdict over all of it. Its model has surfaces pipe1, blend1, pipe2, ... in the order of
 * flow, and a curve axis-pipe1, axis-blend1, ... for each; straight pipes of no length are left
 * out. Corners: every elbow is the shortest of its shape with the least radius of curvature asked
 * for; or, with TAUT_PIPE_ELBOW_ARC, the arc of that radius, a rational curve of degree 2, and its surface
 * the torus, of bidegree (2, 2). Legs: handles are chosen as those of ends. The frame of a closed run comes round turned;
 * what is left is distributed over its blends by their lengths.
 *
 * With a wall surfaces inner-pipe1, inner-blend1, ... follow, about the same axes at radius - wall; cap1 and
 * cap2 are then the rings between them and the outer ones.
 *
 * Caps and statuses as above. */
TAUT_API taut_status taut_pipe_run_make(const taut_pipe_run_problem *problem,
                                        const taut_make_options *options, taut_model **model,
                                        taut_error *error);

/* Proves it again: claims joint1, joint2, embedded, tube, for "g2" curvature1 and curvature2, and
 * with a problem ends, and optimal where the shape was chosen; of a canal surface regular and
 * graph; with caps caps. Of a run joints, curvatures, embedded, tube, ends, bend_radius, caps
 * (docs/pipe.md). Which of both it is the model shows; `ends` is false where the other was asked
 * for. problem may be NULL. */
TAUT_API taut_status taut_pipe_certify(const taut_model *model, const taut_pipe_problem *problem,
                                       const taut_certify_options *options,
                                       taut_certificate **certificate, taut_error *error);
TAUT_API taut_status taut_pipe_run_certify(const taut_model *model,
                                           const taut_pipe_run_problem *problem,
                                           const taut_certify_options *options,
                                           taut_certificate **certificate, taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_PIPE_H */
