/* taut/pattern.h -- cutting patterns: a surface cut along seams into pieces, each flattened so that the cloth is strained least.
 *
 * A piece is carried by (s, t) in [0, 1]^2, s along the strip: its edges `right` (t = 0), `end` (s = 1), `left` (t = 1) and `start`
 * (s = 0) run counter-clockwise seen from the side of n = x_u x x_v. With the metric G(s, t) of the piece and J = (y_s, y_t) of its flat
 * piece y, y_1 along the warp,
 *
 *     W(y) = iint 1/2 E : D : E  det F0 det J ds dt,   E = 1/2 (F0^-1 C F0^-1 - 1),   C = J^-T G J^-1
 *
 * is least, F0 = diag(1/(1 - warp), 1/(1 - weft)). Each piece is flattened alone first; the two sides of a seam then get the mean
 * of their stretches, held, so that they are equally long at every point.
 *
 * Sources: [LinhardWuechnerBletzinger2008] (least deviation of stress), [doCarmo1976] chapter 4 (geodesics).
 */
#ifndef TAUT_PATTERN_H
#define TAUT_PATTERN_H

#include "taut/construct.h"
#include "taut/join.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The most pieces that a rule makes, and rules of a document. */
enum { TAUT_PATTERN_PIECES_MAX = 500, TAUT_PATTERN_RULES_MAX = 100 };

/* How a rule lays its seams. */
typedef enum taut_pattern_rule_kind {
    TAUT_PATTERN_ACROSS = 0, /* strips from one edge to the opposite one, between geodesics */
    TAUT_PATTERN_RADIAL,     /* the same from a short edge, or one that is a point */
    TAUT_PATTERN_PARALLEL,   /* geodesics square to a given one, at equal steps of it */
    TAUT_PATTERN_GEODESIC,   /* one, between two places of the border */
    TAUT_PATTERN_LINE,       /* parameter lines */
    TAUT_PATTERN_CURVE,      /* a curve of the model that lies on the surface */
    TAUT_PATTERN_BUTT        /* geodesics across one strip */
} taut_pattern_rule_kind;

/* What an edge is cut in equal parts of. */
typedef enum taut_pattern_by {
    TAUT_PATTERN_BY_LENGTH = 0,
    TAUT_PATTERN_BY_PARAMETER
} taut_pattern_by;

/* What tells a place of an edge. */
typedef enum taut_pattern_place {
    TAUT_PATTERN_PART = 0, /* a share of the edge's length, 0 to 1 */
    TAUT_PATTERN_LENGTH,   /* a length from the edge's beginning */
    TAUT_PATTERN_PARAMETER /* u or v there */
} taut_pattern_place;

/* A place of the surface: (u, v), or on an edge. */
typedef struct taut_pattern_at {
    double uv[2];
    int is_on_edge; /* nonzero: `edge`, `place` and `value`, not uv */
    taut_edge edge;
    taut_pattern_place place;
    double value;
} taut_pattern_at;

/* One of them. */
typedef struct taut_pattern_rule {
    taut_pattern_rule_kind kind;
    taut_edge edges[2]; /* across, radial: opposite ones, strips run from the first to the second */
    int count;     /* of strips, 1 to TAUT_PATTERN_PIECES_MAX; 0: the least whose pieces all fit */
    double width;  /* where count is 0: into this width, or 0: into that of the cloth */
    double strain; /* where count is 0: and none is strained more than this; 0: as much as it is */
    double
        trim; /* radial, where one edge is one place: strips end at this distance from it along parameter lines, around a cap; 0: in
                  * it */
    taut_pattern_by by;
    taut_pattern_at
        at[2];       /* parallel, geodesic: where it begins and ends; a seam's on the border */
    double spacing;  /* parallel: of the steps, above 0 */
    int held;        /* line: 0: u, 1: v */
    int value_count; /* line: at least 1; butt: where it cuts, in shares of both long edges */
    const double *values;
    const char *curve; /* its name */
    int strip; /* butt: of strips from 0, in the order of their names; -1, in the last rule: all that are longer than the cloth, in equal parts */
    const char *surface; /* of several: the one that it cuts; NULL: each */
} taut_pattern_rule;

/* How long seams are made. */
typedef enum taut_pattern_seam_length {
    TAUT_PATTERN_SHARED = 0, /* the mean of the stretches that the two pieces have alone */
    TAUT_PATTERN_TRUE        /* that of the surface, less the compensation */
} taut_pattern_seam_length;

/* Moduli of warp and weft in kN/m, Poisson's ratio and shear; only ratios matter. All 0: E = 1, nu = 0, G = 1/2, which makes the
 * squares of all strains least. */
typedef struct taut_pattern_material {
    double e[2], nu, g;
} taut_pattern_material;

/* The cloth. Zero: not given. */
typedef struct taut_pattern_cloth {
    double width;  /* of the roll, in the document's unit; 0: pieces may be as wide as they are */
    double length; /* that no piece is longer than along the roll; 0: they may be */
    taut_pattern_material material;
    double
        thread; /* the angle from the piece's chord to the warp, in (-pi, pi]; 0: the warp runs along */
    int has_gap; /* nonzero, or pieces are 5 mm apart on the roll */
    double gap;  /* not negative */
    int has_nap; /* nonzero: pieces all lie one way on the roll; or some are turned by half a turn */
    int shows_lower; /* nonzero: files show the side that the normal leaves from, mirrored; or the upper one */
} taut_pattern_cloth;

/* How much smaller the cloth is cut than it is mounted: flat = (1 - c) mounted; each in [-0.1, 0.3]. */
typedef struct taut_pattern_compensation {
    double warp, weft;
    int has_seam; /* nonzero: `seam` is that of held lengths; or it is the mean of what warp and weft make of the edge */
    double seam;
} taut_pattern_compensation;

/* Of the mounted cloth, in kN/m, with moduli that are the cloth's own: e = D^-1 s, and c = e/(1 + e) of warp and weft. */
typedef struct taut_pattern_prestress {
    double warp, weft;
} taut_pattern_prestress;

/* How the cloth that is left is cut at corners. */
typedef enum taut_pattern_corner {
    TAUT_PATTERN_MITRE =
        0, /* on to where both lines meet, at most twice what is left away from the corner */
    TAUT_PATTERN_SQUARE, /* off at what is left away from the corner */
    TAUT_PATTERN_MIRROR  /* a seam's folded over covers the border's */
} taut_pattern_corner;

/* What is left along one seam, on the pieces to its right and to its left as its curve runs, seen from the upper side (of two surfaces that
 * meet on it, of the later one). */
typedef struct taut_pattern_seam_allowance {
    const char *seam; /* its name, "S3" */
    double right, left;
} taut_pattern_seam_allowance;

/* What is left beyond the line that is sewn, in the document's unit; none negative. */
typedef struct taut_pattern_allowance {
    double seam, border;
    double
        overlap; /* above 0: of welded seams, in place of seam: all of it on the piece of odd number */
    int is_split; /* or half of it on both */
    int has_butt; /* nonzero: `butt` is that of seams across strips, or it is that of seams */
    double butt;
    taut_pattern_corner corner;
    int seam_count; /* of seams with an allowance of their own, in place of all the others */
    const taut_pattern_seam_allowance *seams;
} taut_pattern_allowance;

/* An edge folded over, and sewn down at the width of the pocket: twice that and the allowance of seams are left. */
typedef struct taut_pattern_hem {
    taut_edge edge;
    double pocket; /* above 0 */
} taut_pattern_hem;

/* How a mark is drawn. */
typedef enum taut_pattern_notch {
    TAUT_PATTERN_SLIT = 0, /* a line across the allowance, from the line that is sewn */
    TAUT_PATTERN_V,        /* a notch in it */
    TAUT_PATTERN_DOT       /* on the line itself */
} taut_pattern_notch;

/* Marks that meet when a seam is sewn: at equal lengths of the surface from where pieces start. */
typedef struct taut_pattern_marks {
    double spacing; /* 0: none */
    taut_pattern_notch notch;
} taut_pattern_marks;

/* Edges to which nothing is sewn, held at the length of the surface less the compensation; nonzero: held. Of the window, u0 to v1, and of
 * every piece, right, end, left and start. */
typedef struct taut_pattern_held {
    int borders[4], edges[4];
} taut_pattern_held;

/* What is cut in full near an edge that does not yield. */
typedef enum taut_pattern_component {
    TAUT_PATTERN_COMPONENT_ALONG =
        0, /* that of warp and weft which is nearer to the edge's direction */
    TAUT_PATTERN_COMPONENT_BOTH
} taut_pattern_component;

/* Compensation times 3 x^2 - 2 x^3, x = min(1, distance in space from the edge / length). */
typedef struct taut_pattern_decompensate {
    taut_edge edge; /* of the window */
    double length;  /* above 0 */
    taut_pattern_component component;
} taut_pattern_decompensate;

/* How start and end of pieces run. */
typedef enum taut_pattern_ends {
    TAUT_PATTERN_ENDS_FREE = 0,
    TAUT_PATTERN_ENDS_STRAIGHT /* straight and square to y_1, along which the thread runs */
} taut_pattern_ends;

/* What pieces are laid flat by. */
typedef enum taut_pattern_flattening {
    TAUT_PATTERN_ELASTIC = 0, /* W above */
    TAUT_PATTERN_CONFORMAL /* angles are kept, seams have the surface's length: for prints, not for cloth */
} taut_pattern_flattening;

/* Zero means default everywhere. One of `model` and `of`. */
typedef struct taut_pattern_problem {
    const taut_model *model; /* the surface is in it */
    const taut_problem *of;  /* or in what this makes */
    const char *
        surface; /* its name; NULL: the only one, or all of several, which are sewn where they share an edge */
    int rule_count; /* at least 1 */
    const taut_pattern_rule *rules;
    taut_pattern_seam_length seam_length;
    taut_pattern_cloth cloth;
    taut_pattern_compensation compensation;
    int has_prestress; /* nonzero: in place of warp and weft, what `prestress` makes of them */
    taut_pattern_prestress prestress;
    taut_pattern_allowance allowance;
    int hem_count; /* at most 4 */
    const taut_pattern_hem *hems;
    taut_pattern_marks marks;
    double
        strain; /* claim: the largest |principal strain| is no more; 0: that of the rule, or none */
    taut_pattern_held held;
    taut_pattern_ends ends;
    int decompensate_count; /* at most 4; with held lengths on one surface alone */
    const taut_pattern_decompensate *decompensate;
    taut_pattern_flattening
        flatten; /* conformal: without material, compensation, prestress, held edges and straight ends */
} taut_pattern_problem;

/* Reasons: word, meaning, remedy. */
#define TAUT_PATTERN_REASON_LIST(X)                                                                \
    X("rule", "a rule that is not known, or rules that cannot follow each other",                  \
      "give one of across, radial, parallel, geodesic, line, curve; a butt after them")            \
    X("edge", "an edge that is not known, or two that are not opposite",                           \
      "take u0 and u1, or v0 and v1")                                                              \
    X("count", "a number of strips that is no whole number above 0, or too large",                 \
      "give one from 1 to 500")                                                                    \
    X("outside", "a place that is not on the surface, or a seam's that is not on its border",      \
      "give a place of the window, or of an edge")                                                 \
    X("curve", "a curve that the model does not have, that leaves the surface or has a corner",    \
      "give one of its curves, from border to border of the window")                               \
    X("held", "an edge to hold that is not known",                                                 \
      "give edges of the window, u0, u1, v0, v1, or of every piece, right, end, left, start")      \
    X("ends", "straight ends of a piece whose sides have not one length, or that has a tip",       \
      "leave ends free, or cut strips alike on both sides")                                        \
    X("material", "a material that is not known, or whose moduli are those of no cloth",           \
      "give a name that the message gives, or E and G above 0 with nu^2 below E_warp/E_weft")      \
    X("compensation", "a compensation outside [-0.1, 0.3]",                                        \
      "give the share by which the cloth is cut smaller: 2 % is 0.02")                             \
    X("no-geodesic", "no geodesic between the two places was found inside the window",             \
      "take fewer, wider strips (beside an edge that bows in a geodesic leaves the surface), or "  \
      "run them between the other edges")                                                          \
    X("crossing", "two seams cross, or a piece turns over between them",                           \
      "take other strips: the message names the place")                                            \
    X("shape", "a seam leaves a piece that has two sides, or five",                                \
      "run seams between opposite edges, not around a corner of the window")                       \
    X("singular", "the surface has no normal somewhere in a piece",                                \
      "keep seams and edges away from the place that the message names")                           \
    X("crease", "the surface has a kink, which no piece of cloth follows",                         \
      "cut it along the kink into surfaces of their own")                                          \
    X("extreme-size", "the surface is so large or small that lengths along it are no parameters",  \
      "scale it")                                                                                  \
    X("width", "a flat piece is wider than the roll, or no number of strips up to 500 fits",       \
      "take more strips, or a wider roll")                                                         \
    X("length", "a flat piece is longer than the cloth",                                           \
      "cut it across by butts: the message says in how many parts")                                \
    X("allowance", "an edge turns inwards more tightly than what is to be left along it",          \
      "leave less there: the message says how much")                                               \
    X("strain",                                                                                    \
      "no number of strips up to 500, or not the one that is given, is strained as little as "     \
      "that",                                                                                      \
      "allow more strain, or take more strips: halving their width quarters it")                   \
    X("overlap", "a flat piece lies over itself", "cut it across, by a butt, or take more strips") \
    X("folds", "no flat piece without folds was found to begin with", "take more strips")          \
    X("not-converged", "the flattening did not settle",                                            \
      "take more strips, or a material whose moduli differ less")

/* Makes the model: the surface, a flat surface P1, P2, ... (z = 0) a piece, curves S1, S2, ... of the seams on the surface, and of
 * each piece P1.right, P1.end, P1.left, P1.start and the outline P1.cut; details as docs/pattern.md has them. TAUT_BAD_INPUT,
 * TAUT_NO_SOLUTION and TAUT_NOT_CONVERGED with the reasons above. A tolerance below 1e-6 is one of the lengths of flat pieces, over the
 * size. */
TAUT_API taut_status taut_pattern_make(const taut_pattern_problem *problem,
                                       const taut_make_options *options, taut_model **model,
                                       taut_error *error);

/* ---- what a finished pattern says, as structs: of its details, which belong to the model, as do its surfaces and curves ---- */

/* An edge of a piece. What there is not is NaN or NULL; lengths in the model's unit, areas in its square. */
typedef struct taut_pattern_sewn_edge {
    const char *seam;       /* that it is sewn along; NULL: none */
    double part[2];         /* of the seam, from .. to, shares of its length */
    double length;          /* on the surface */
    double flat_length;     /* of the line to sew along */
    double allowance;       /* left beyond it */
    const taut_curve *line; /* to sew along, as s or t grows: P1.right */
} taut_pattern_sewn_edge;

/* A flat piece: `edges` right, end, left, start. */
typedef struct taut_pattern_flat_piece {
    const char *name;         /* "P1" */
    const taut_surface *flat; /* z = 0, over (s, t) in [0, 1]^2 */
    const taut_curve *cut; /* the outline, counter-clockwise from the corner of right and start */
    taut_pattern_sewn_edge edges[4];
    double area, flat_area, cut_area; /* on the surface, flat, with allowances */
    double curvature;                 /* the integral of K */
    double extent[2];                 /* along and across the warp, with allowances */
    double strain[2]; /* principal ones beyond the compensation, least and largest */
    double energy;
    double on_roll[2]; /* where its origin is */
    int is_turned;     /* by half a turn about it */
} taut_pattern_flat_piece;

/* A seam. */
typedef struct taut_pattern_sewn_seam {
    const char *name, *kind; /* "S1", "geodesic", "line", "curve" or "circle" */
    const taut_curve *curve; /* on the surface */
    double length, flat_length;
    double stretch[2];   /* flat over mounted length, least and largest */
    double disagreement; /* largest difference of the stretches that both sides have alone */
    int piece_count, mark_count;
} taut_pattern_sewn_seam;

/* How many there are; 0 of a model that is no pattern. */
TAUT_API int taut_pattern_piece_count(const taut_model *cloth);
TAUT_API int taut_pattern_seam_count(const taut_model *cloth);

/* One of them, i from 0. TAUT_BAD_ARGUMENT: there is none. */
TAUT_API taut_status taut_pattern_piece_at(const taut_model *cloth, int i,
                                           taut_pattern_flat_piece *piece, taut_error *error);
/* A seam; the names of the pieces along it, const char *pieces[piece_count], and its marks, double marks[mark_count], lengths of the
 * surface from its beginning; each NULL: not asked for. rooms: for so many pieces and marks; TAUT_BAD_ARGUMENT where one is too small. */
TAUT_API taut_status taut_pattern_seam_at(const taut_model *cloth, int i, const int rooms[2],
                                          const char **pieces, double *marks,
                                          taut_pattern_sewn_seam *seam, taut_error *error);

/* The certificate: claims surface, cover, on-surface, geodesic, seams, lengths, no-fold, no-overlap, stationary, stable, isometric,
 * strain, exhausts, roll; docs/pattern.md says what each is held against. */
TAUT_API taut_status taut_pattern_certify(const taut_model *model,
                                          const taut_pattern_problem *problem,
                                          const taut_certify_options *options,
                                          taut_certificate **certificate, taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_PATTERN_H */
