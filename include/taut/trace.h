/* taut/trace.h -- nets of curves on a surface: asymptotic, principal, geodesic, isoparametric.
 *
 * With the unit normal n = x_u x x_v / |x_u x x_v|, a unit tangent T and S = n x T,
 *
 *     T' = k_g S + k_n n,      n' = -k_n T - tau_g S
 *
 * an asymptotic curve has k_n = 0, a principal one tau_g = 0, a geodesic k_g = 0. Families are
 * geometric: asymptotic curves `+` have tau_g > 0, `-` tau_g < 0; principal ones `max` bend by the
 * larger curvature, `min` by the lesser; of isoparametric ones `u` holds u, `v` holds v. Laths of the
 * first family are named A1, A2, ..., of the second B1, B2, ..., geodesics G1, G2, ...
 *
 * Sources: [doCarmo1976] chapter 3, [HairerNorsettWanner1993] II.5 (the integrator).
 */
#ifndef TAUT_TRACE_H
#define TAUT_TRACE_H

#include "taut/construct.h"
#include "taut/join.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The most seeds of a document, and curves of a net. */
enum { TAUT_TRACE_SEEDS_MAX = 1000, TAUT_TRACE_LATHS_MAX = 2000 };

/* Which curves. */
typedef enum taut_trace_net {
    TAUT_TRACE_ASYMPTOTIC = 0,
    TAUT_TRACE_PRINCIPAL,
    TAUT_TRACE_GEODESIC,
    TAUT_TRACE_ISOPARAMETRIC
} taut_trace_net;

/* What equal parts are measured by. */
typedef enum taut_trace_by {
    TAUT_TRACE_CONFORMAL = 0, /* (-K)^(1/4) ds, R^(1/2) ds; of other nets the length */
    TAUT_TRACE_LENGTH,
    TAUT_TRACE_PARAMETER
} taut_trace_by;

/* Where curves begin. */
typedef enum taut_trace_seed_kind {
    TAUT_TRACE_AT =
        0, /* through the point `at`, both ways; a geodesic along `direction`, or to `to` */
    TAUT_TRACE_EDGE, /* `count` points that cut the edge into count + 1 equal parts */
    TAUT_TRACE_LINE, /* the same of the straight line of the window from `at` to `to` */
    TAUT_TRACE_LATH, /* the same of the traced curve named `lath`, for the other family */
    TAUT_TRACE_CELL, /* a net over the whole window, a node at `at`, the part nearest to `cell` */
    TAUT_TRACE_CELLS /* the same with the part 1/count of the longer curve through `at` */
} taut_trace_seed_kind;

/* One of them; what its kind does not name is not looked at. */
typedef struct taut_trace_seed {
    taut_trace_seed_kind kind;
    int family;          /* 1 or 2: of the first or the second alone; 0: of both */
    int has_at;          /* cell, cells: nonzero, or the node lies in the middle */
    double at[2];        /* u, v */
    double to[2];        /* line: its end; geodesics: where it goes */
    int has_to;          /* geodesics: nonzero: to `to`, and `direction` is not looked at */
    double direction[2]; /* geodesics: du, dv, not both 0 */
    int both;            /* geodesics: nonzero: both ways */
    taut_edge edge;
    int count;
    int ends; /* edge, line, lath: nonzero: the ends too */
    taut_trace_by by;
    const char *lath;
    const char
        *surface; /* of a net that is carried on: the one that it lies on; NULL: the problem's */
    double cell;  /* in the document's unit (conformal: in that of the measure) */
} taut_trace_seed;

/* How a lath sits on its curve. */
typedef enum taut_trace_strip {
    TAUT_TRACE_STANDING = 0, /* along the normal */
    TAUT_TRACE_PLANK,        /* along the surface */
    TAUT_TRACE_DEVELOPABLE, /* near the normal, and only bent: the envelope of the planes of tangent and normal */
    TAUT_TRACE_ENVELOPE /* near the surface, and only bent: the envelope of its tangent planes */
} taut_trace_strip;

/* How long a lath is cut that is longer at its edges, as it twists. */
typedef enum taut_trace_cut {
    TAUT_TRACE_CUT_MEAN = 0, /* the mean over its width: no force along it */
    TAUT_TRACE_CUT_AXIS      /* its axis */
} taut_trace_cut;

/* Moduli of elasticity and shear, and strength, in N/mm^2, all above 0; or all 0: not given. */
typedef struct taut_trace_material {
    double e, g, strength;
} taut_trace_material;

/* The laths of a net. Zero: not given; without a width no stretch, without a thickness no slots,
 * without a thickness or a material no stresses. Lengths in the document's unit. */
typedef struct taut_trace_laths {
    taut_trace_strip strip;
    double width, thickness;
    taut_trace_material material;
    taut_trace_cut cut;
    int has_play; /* nonzero, or slots have a play of 0.2 mm, at most the thickness */
    double play;  /* not negative */
} taut_trace_laths;

/* The sheets that laths are cut from, in the document's unit. */
typedef struct taut_trace_sheet {
    double size[2]; /* along the pieces and across, above 0; or both 0: one as large as they need */
    int has_gap;    /* nonzero, or pieces are 5 mm apart */
    double gap;     /* not negative */
} taut_trace_sheet;

/* Zero means default everywhere. One of `model` and `of`. */
typedef struct taut_trace_problem {
    const taut_model *model; /* the surface is in it */
    const taut_problem *of;  /* or in what this makes */
    const char *surface;     /* its name; NULL: the only one */
    int carry; /* nonzero: curves go on to the model's other surfaces, across edges that join with one normal;
                 * without `surface` seeds lie on the first one */
    taut_trace_net net;
    int families;   /* 1 or 2: the first or the second alone; 0: both */
    int seed_count; /* 0: { cells: 8 } */
    const taut_trace_seed *seeds;
    double max_length;             /* 0: 20 times the size of the surface */
    const taut_trace_laths *laths; /* NULL: curves alone */
    const taut_trace_sheet *sheet; /* NULL: one as large as the pieces need */
    int panels;                    /* principal nets, nonzero: the quads between nodes are judged */
} taut_trace_problem;

/* Reasons: word, meaning, remedy. */
#define TAUT_TRACE_REASON_LIST(X)                                                                  \
    X("net", "a net that is not known, or a seed or an option that this net has no use for",       \
      "leave it out, or trace another net")                                                        \
    X("family", "the net has no family of this name", "take one of those that the message names")  \
    X("edge", "an edge that is not known", "take u0, u1, v0 or v1")                                \
    X("count", "a number of curves that is no whole number above 0, or too large",                 \
      "give one from 1 to 1000")                                                                   \
    X("direction", "a geodesic without a direction or an end, or a direction that is 0",           \
      "give two numbers that are not both 0, or \"to\"")                                           \
    X("no-geodesic", "no geodesic between the two places was found inside the window",             \
      "bring them nearer to each other")                                                           \
    X("outside", "a seed lies outside the window of the surface", "give one inside its ranges")    \
    X("elliptic", "asymptotic curves where the Gauss curvature is positive",                       \
      "seed where it is negative, as at the place that the message names")                         \
    X("parabolic", "the Gauss curvature vanishes everywhere: one direction, no net",               \
      "trace another net")                                                                         \
    X("flat", "the second fundamental form vanishes at the seed, or everywhere",                   \
      "seed elsewhere, or trace another net")                                                      \
    X("umbilic", "both principal curvatures are equal at the seed, or everywhere",                 \
      "seed elsewhere, or trace another net")                                                      \
    X("along", "every curve of the family runs along the edge that seeds it",                      \
      "seed it on another edge")                                                                   \
    X("singular", "the surface has no normal at the seed, or where a curve comes to",              \
      "seed elsewhere")                                                                            \
    X("crease", "the normal of the surface jumps at the seed", "seed beside the crease")           \
    X("extreme-size", "the surface is so large or small that lengths along it are no parameters",  \
      "scale it")                                                                                  \
    X("stalled", "a curve could not be followed on", "seed elsewhere")                             \
    X("too-many-laths", "the net would have too many curves", "ask for fewer")                     \
    X("width", "the width of laths is no positive number", "give one, in the document's unit")     \
    X("material", "a material that has no numbers above 0, or a name that is not known",           \
      "give E, G and strength in N/mm^2, or a name that the message gives")                        \
    X("folds", "a strip bends so much in its own plane that it folds over itself",                 \
      "take a width below the one that the message gives")                                         \
    X("developable", "a strip that is only bent does not exist along the curve, or not so wide",   \
      "take the width that the message gives, or another strip")                                   \
    X("slots", "slots overlap, or laths turn into each other within their width",                  \
      "take thinner or less wide laths, or fewer")                                                 \
    X("sheet", "a piece is larger than the sheet, and cannot be split between crossings",          \
      "take sheets of the size that the message gives")

/* Makes the model: the surface and a curve a lath, quintic B-splines over arc length, named A1, B1,
 * ...; details as docs/trace.md has them. TAUT_BAD_INPUT, TAUT_NO_SOLUTION and TAUT_NOT_CONVERGED with
 * the reasons above. */
TAUT_API taut_status taut_trace_make(const taut_trace_problem *problem,
                                     const taut_make_options *options, taut_model **model,
                                     taut_error *error);

/* The laths of a finished net in space, as details tell them: strips of degree 5 x 1, named A1-strip and so on,
 * `solid` nonzero: the six faces of solids of their thickness; its panels, bilinear patches P1, P2, ...; and the
 * curves. TAUT_NO_SOLUTION, reasons "width" (the model has neither), "missing" (a thickness) and "developable"; TAUT_BAD_INPUT, reason "value". */
TAUT_API taut_status taut_trace_strips(const taut_model *model, int solid, taut_model **strips,
                                       taut_error *error);

/* ---- what a finished net says, as structs: of details, which belong to the model ---- */

/* The value at the seed, the largest absolute one, and the length at which it is. */
typedef struct taut_trace_bending {
    double seed, most, most_at;
} taut_trace_bending;

/* A curve, and what is cut for it. What there is not is NaN; lengths in the model's unit. */
typedef struct taut_trace_lath {
    const char *name, *family; /* "A1", "+" */
    const char *from_word,
        *to_word; /* where it ends: "edge u0", "parabolic", ... (docs/trace.md) */
    double seed[2], from[2], to[2];
    double length, twist, turn; /* int |tau_g| ds, int |k_g| ds */
    taut_trace_bending k_n, k_g, tau_g;
    int steps, node_count;
    double width, thickness, least_radius, edge_length, mean_stretch, cut_length;
    double pattern_end[3]; /* x, y, angle */
    double use;            /* of its strength */
} taut_trace_lath;

/* A crossing. */
typedef struct taut_trace_node {
    const char *name; /* "A3B5" */
    double at[2], point[3], normal[3];
    double angle;               /* acute, radians */
    double tau, mean_curvature; /* sqrt(-K), or 0; H */
    double s[2];                /* the lengths on both curves */
    double slot, slot_twisted;  /* widths of slots over the thickness; NaN where there are none */
    int is_on_border;
} taut_trace_node;

/* A flat piece on its sheet. */
typedef struct taut_trace_piece {
    const char *name, *lath; /* "A3/1" of "A3" */
    int sheet;               /* from 1 */
    int point_count, slot_count;
} taut_trace_piece;

/* How many there are; 0 of a model that is no net. */
TAUT_API int taut_trace_lath_count(const taut_model *net);
TAUT_API int taut_trace_node_count(const taut_model *net);
TAUT_API int taut_trace_piece_count(const taut_model *net);

/* One of them, i from 0. TAUT_BAD_ARGUMENT: there is none. */
TAUT_API taut_status taut_trace_lath_at(const taut_model *net, int i, taut_trace_lath *lath,
                                        taut_error *error);
TAUT_API taut_status taut_trace_node_at(const taut_model *net, int i, taut_trace_node *node,
                                        taut_error *error);
/* A piece, and its outline, double outline[point_count][2], counter-clockwise or not, closed by its first
 * point; NULL: the struct alone, to ask for its size. room: for so many points; TAUT_BAD_ARGUMENT where it
 * is too small. */
TAUT_API taut_status taut_trace_pattern(const taut_model *net, int i, int room, double *outline,
                                        taut_trace_piece *piece, taut_error *error);

/* ---- one curve, step by step ---- */

/* A place of a curve that is followed. */
typedef struct taut_trace_step {
    double s;     /* length from the seed */
    double at[2]; /* u, v */
    double point[3], tangent[3], normal[3];
    double k_n, k_g, tau_g;
} taut_trace_step;

/* Is handed the seed and then the end of every step; nonzero: enough. */
typedef int taut_trace_sink(void *context, const taut_trace_step *step);

/* How a curve that was followed ended. */
typedef struct taut_trace_end {
    const char *word; /* "edge", "corner", "parabolic", ..., "length", or "sink": it had enough */
    double at[2], length;
    int steps;
} taut_trace_end;

/* Follows the curve of a family, 1 or 2, through `at`, one way: that of the direction `way` of the window, du, dv
 * (of a geodesic its own, of other nets whichever of both ways is nearer to it); at most `max_length` long (0: 20
 * times the size). The steps are those of taut_trace_make, [HairerNorsettWanner1993] II.5, each to 1e-12 of the
 * size. end: or NULL. TAUT_BAD_ARGUMENT; TAUT_BAD_INPUT, reasons "outside", "direction", "value"; TAUT_NO_SOLUTION,
 * reasons "elliptic", "flat", "singular", "crease", "extreme-size"; TAUT_NOT_CONVERGED, reason "stalled". */
TAUT_API taut_status taut_trace_follow(const taut_surface *surface, taut_trace_net net, int family,
                                       const double at[2], const double way[2], double max_length,
                                       taut_trace_sink *sink, void *context, taut_trace_end *end,
                                       taut_error *error);

/* The certificate: claims on-surface, asymptotic (principal, geodesic, isoparametric), length, ends,
 * nodes, complete, right-angled, pattern, and with the problem `surface`, spacing, isometric. docs/trace.md
 * says what each is held against. */
TAUT_API taut_status taut_trace_certify(const taut_model *model, const taut_trace_problem *problem,
                                        const taut_certify_options *options,
                                        taut_certificate **certificate, taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_TRACE_H */
