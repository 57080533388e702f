/* taut/film.h -- soap films and sails: a surface under tension, with edges held or drawn by cables.
 *
 *     E(x) = s A(x) + sum over cables C_k(L_k),     A = iint |x_u x x_v| du dv,  L_k = int |x_t| dt
 *
 * or, with forces in two directions of threads, u and v over [0, 1],
 *
 *     P(x) = 1/2 iint a |x_u|^2 + b |x_v|^2 du dv   in place of s A
 *
 * is least over the spline space of one patch. s is the tension of the film, a force per length;
 * C_k is T_k L_k for a cable of given force T_k, 0 for one of given length, whose force is the
 * multiplier of L_k, and EA (L_k - L0)^2 / (2 L0) for an elastic one. Where the film rests its mean
 * curvature is 0, and each cable is an asymptotic curve of it with curvature s / T_k
 * (docs/film.md).
 */
#ifndef TAUT_FILM_H
#define TAUT_FILM_H

#include "taut/construct.h"
#include "taut/curve.h"
#include "taut/surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The most control points of a film. */
enum { TAUT_FILM_POINTS_MAX = 2500 };
/* The least and the most that a force over tension times size may be. */
#define TAUT_FILM_FORCE_MIN 1e-6
#define TAUT_FILM_FORCE_MAX 1e6

/* How an edge is held. */
typedef enum taut_film_edge_kind {
    TAUT_FILM_FIXED = 0, /* on `curve`, or on the straight line between its corners */
    TAUT_FILM_CABLE,     /* drawn by a cable */
    TAUT_FILM_SLIDE,     /* free in `plane`: the film meets it at a right angle */
    TAUT_FILM_POLE /* one point: of a ring free, else as its two corners, one point, are held or move */
} taut_film_edge_kind;

/* What goes around: a film that is closed in one direction, without corners. */
typedef enum taut_film_ring {
    TAUT_FILM_OPEN = 0,
    TAUT_FILM_RING_U, /* along u: its edges u0 and u1 are one curve inside the film */
    TAUT_FILM_RING_V  /* along v */
} taut_film_ring;

/* A plane, or a line. */
typedef struct taut_film_guide {
    double point[3];
    double direction[3]; /* the normal of a plane, the direction of a line; of any length but 0 */
} taut_film_guide;

/* How a corner that is not held may move. */
typedef enum taut_film_corner_kind {
    TAUT_FILM_HELD = 0, /* where it is given, or where a curve ends */
    TAUT_FILM_FREE,     /* wherever its edges draw it */
    TAUT_FILM_ON_LINE,  /* along its guide */
    TAUT_FILM_ON_PLANE  /* in its guide */
} taut_film_corner_kind;

/* What is given of a cable. */
typedef enum taut_film_law {
    TAUT_FILM_FORCE = 0, /* `force` */
    TAUT_FILM_LENGTH,    /* `length` */
    TAUT_FILM_SAG,       /* the length of the arc of a circle that rises by `sag` times its chord */
    TAUT_FILM_ELASTIC    /* force = stiffness (length - unstressed) / unstressed */
} taut_film_law;

typedef struct taut_film_edge {
    taut_film_edge_kind kind;
    const taut_curve *curve; /* fixed: fitted to the basis of the edge; or NULL */
    taut_film_law law;       /* cable */
    double force;            /* above 0 */
    double length;           /* above the distance of the corners */
    double sag;              /* above 0, below 1/2 */
    double unstressed;       /* above 0 */
    double stiffness;        /* above 0: a force, EA */
    unsigned char has_plane; /* of a cable: it is kept in `plane`; a slide always has one */
    unsigned char is_mirror; /* of a slide: the claim `mirror` too */
    taut_film_guide plane;
    int along; /* of a cable: 1 + the one of the problem's `along` that it is part of, whose law counts; 0: one of its own */
} taut_film_edge;

/* The most patches of a film, and the most control points of all of them. */
enum { TAUT_FILM_PATCHES_MAX = 64, TAUT_FILM_PATCHES_POINTS_MAX = 20000 };

/* One edge of one of many patches. */
typedef struct taut_film_side {
    int patch, edge;
    unsigned char reversed; /* nonzero: run backwards */
} taut_film_side;

/* Edges that are one curve: two join their sheets, three or more are a line of the film. */
typedef struct taut_film_seam {
    int count; /* 2 or more */
    const taut_film_side *sides;
    taut_film_edge edge; /* a cable where one runs along the seam, or all zero */
} taut_film_seam;

/* One cable along several edges or seams, with one force: its law counts the whole length. Each of its edges, or the seam that this
 * is in, is a cable with this one's number in `along`. */
typedef struct taut_film_along {
    const char *name; /* NULL: "cable-0", ... */
    int count;
    const taut_film_side *sides; /* as it runs: each begins where the one before it ends */
    taut_film_edge edge;         /* a cable: the law */
} taut_film_along;

/* One side of a patch: the one that x_u x x_v points to, or, reversed, the other. */
typedef struct taut_film_face {
    int patch;
    unsigned char reversed;
} taut_film_face;

/* The most cables along several edges. */
enum { TAUT_FILM_ALONG_MAX = 64 };

/* The most cells of a film. */
enum { TAUT_FILM_CELLS_MAX = 64 };

/* What lies on one side of sheets and is under pressure: a bubble, a cushion.
 *
 *     V = 1/3 sum over sides of +-iint (x - from) . (x_u x x_v) du dv
 *
 * E becomes E - p V; a pressure above 0 pushes a side along its x_u x x_v, a reversed one against it. Of a closed cell `from`
 * does not matter; of an open one it lies in the planes that its moving edges are kept in. */
typedef struct taut_film_cell {
    const char *name; /* NULL: "cell-0", ... */
    int count;        /* of sides */
    const taut_film_face *sides;
    unsigned char
        has_volume; /* nonzero: `volume` is given and the pressure found; else `pressure` is given */
    double volume;  /* not 0 */
    double pressure; /* a force per area */
    double from[3];
} taut_film_cell;

/* The most surfaces of a film with its images, and the most control points of all of them. */
enum { TAUT_FILM_IMAGES_MAX = 4096, TAUT_FILM_IMAGES_POINTS_MAX = 4000000 };

typedef enum taut_film_image_kind {
    TAUT_FILM_MIRROR = 0, /* in the plane `guide` */
    TAUT_FILM_HALF_TURN,  /* about the line `guide` */
    TAUT_FILM_TURN, /* about it by `angle`, counter-clockwise as one looks against its direction */
    TAUT_FILM_TRANSLATE /* by `vector` */
} taut_film_image_kind;

/* A map that the film is repeated by: its first `count` powers add a copy each of all that is there so far. */
typedef struct taut_film_image {
    taut_film_image_kind kind;
    taut_film_guide guide;
    double angle;     /* radians */
    double vector[3]; /* not 0 */
    int count;        /* 1 or more; 0: 1 */
} taut_film_image;

typedef struct taut_film_problem taut_film_problem;

/* How a film is found. */
typedef enum taut_film_method {
    TAUT_FILM_FULL = 0, /* in all coordinates of the net */
    TAUT_FILM_NORMAL /* at the end in those alone that the energy sees; the net lies as it came */
} taut_film_method;

/* The most rounds of refinement. */
enum { TAUT_FILM_REFINE_MAX = 6 };
/* The most updates of a reference. */
enum { TAUT_FILM_UPDATES_MAX = 100 };

/* Zero means default everywhere. */
typedef struct taut_film_problem {
    const char *name;            /* of the surface; NULL: "film" */
    const taut_basis *u, *v;     /* bezier or bspline of degree 2 or more */
    double corners[4][3];        /* u0v0, u1v0, u0v1, u1v1 */
    unsigned char has_corner[4]; /* 0: the end of a curve of its edges; if it moves: its start */
    taut_film_edge edges[4];     /* u0, u1 along v; v0, v1 along u */
    double tension;              /* of the film; 0: 1 */
    double tolerance;            /* of the claim `stationary`, from 1e-14 to 1e-3; 0: 1e-10 */
    int max_iterations;          /* 0: 200 */
    double equilibrium;          /* above 0: the claim of that name, below 1 */
    int without_least;           /* nonzero: no bound is sought for the claim `least` */
    taut_film_ring ring; /* bspline of 2 degree + 1 points or more that way, and no corners */
    taut_film_corner_kind corner_kinds[4];
    taut_film_guide guides[4]; /* of corners on lines and planes */
    double force_density[2];   /* both above 0: a, b in place of a tension; 0, 0: none */
    double prestress[2];       /* both above 0: forces per width along u and v, on `reference` */
    const taut_surface *reference; /* regular, on the bases of the film; with prestress */
    int updates;                   /* so often the film becomes the reference, 0 to 100 */
    const double *start; /* double[nu][nv][3], where to begin; NaN: a point that is not given */
    taut_film_method method;
    int accepts_stationary; /* nonzero: films at rest that are no minimum too */
    int refine;             /* 0 to 6: found anew so often, each time with all spans halved */
    /* Films of many patches: then of the members above tolerance, max_iterations, method, without_least, accepts_stationary,
     * equilibrium and refine alone count. Of a patch name, u, v, corners, edges, start and tension, or threads, count; an edge in a seam is left all zero. */
    int patch_count;
    const taut_film_problem *patches;
    int seam_count;
    const taut_film_seam *seams;
    /* Of films of one patch too. */
    int cell_count;
    const taut_film_cell *cells;
    /* Of films of one patch too, as cells. */
    int along_count; /* at most TAUT_FILM_ALONG_MAX */
    const taut_film_along *along;
    /* Of all films: each in turn. Copy n of surface "a" is called a with n primes, "a'", "a''", and from the ninth on "a'9". */
    int image_count;
    const taut_film_image *images;
} taut_film_problem;

/* Reasons: word, meaning, remedy. */
#define TAUT_FILM_REASON_LIST(X)                                                                   \
    X("not-yet", "a member or a word of films that this version cannot do", "leave it out")        \
    X("basis", "a basis is not of type bezier or bspline of degree 2 or more, or could crease",    \
      "take a bspline of degree 4, say")                                                           \
    X("corner-missing", "an edge is held on a line from a corner that is not given",               \
      "give the corner")                                                                           \
    X("free-edge", "an edge is neither held, drawn nor kept in a plane",                           \
      "give it a cable or a plane")                                                                \
    X("start", "a start is of another net, or not on what holds the film",                         \
      "give a model of the same surface, held in the same places")                                 \
    X("curve-ends", "a curve does not end in the corners of its edge",                             \
      "let u0 and u1 run with v, v0 and v1 with u, from corner to corner")                         \
    X("edge-conflict", "an edge is in a seam, and held or drawn too", "leave out one of them")     \
    X("corner-conflict",                                                                           \
      "a corner is where a ring has none, not in the plane of its edge, or moves at the end of "   \
      "a held edge",                                                                               \
      "move the corner, or leave it out")                                                          \
    X("seam-mismatch", "two edges that are not opposite ones of a patch are to be one",            \
      "join u0 with u1, or v0 with v1")                                                            \
    X("point-support", "a point inside is held, or a pole: a point holds no film",                 \
      "use a ring, or cables that end there")                                                      \
    X("no-corner", "two cables meet in a corner that is free: they draw it straight",              \
      "hold it, or keep it on a line or in a plane")                                               \
    X("floating", "held points, lines and planes leave a translation free", "hold a corner")       \
    X("collapses", "the edges of a ring are too far apart: no film connects them",                 \
      "bring them together")                                                                       \
    X("slides-away", "the film gets smaller and smaller as an edge slides", "hold more of it")     \
    X("curve-fit", "a curve cannot be fitted to the basis of its edge",                            \
      "lower the degree, or even out the knots")                                                   \
    X("no-area", "the edges span no area, or two corners are one",                                 \
      "give corners that are apart, and no line")                                                  \
    X("crossed", "the corners of a flat film, in their order, bound no polygon",                   \
      "u0v0, u1v0, u1v1, u0v1 must run round it")                                                  \
    X("cable-too-weak", "the film draws a cable into another edge",                                \
      "give the cables the force that the message names, or more, or the film less tension (1 "    \
      "where the document says none)")                                                             \
    X("cable-too-short", "a cable is not longer than the chord it has to span",                    \
      "give it more length, or draw the corners together")                                         \
    X("cell-sides", "a side of a patch bounds two cells",                                          \
      "name each side once, the other one with a minus sign")                                      \
    X("open-cell", "a cell has an edge that moves, and its cone is not flat there",                \
      "close the cell, or give it a `from` in the plane of that edge")                             \
    X("image-twice", "an image lies where another surface of the film lies already",               \
      "give each image once, of a film that it does not map to itself")                            \
    X("pressure-too-high", "no film holds this pressure",                                          \
      "lower the pressure to what the message names, or give a volume")                            \
    X("unstable", "the start lies at a film that is no minimum",                                   \
      "begin elsewhere, or accept what is stationary")                                             \
    X("unbalanced", "forces that meet in a free line or vertex cannot balance",                    \
      "hold it, or change tensions or forces")                                                     \
    X("folds", "the film folds on its way to the least energy",                                    \
      "raise the forces, or move the corners")                                                     \
    X("not-converged", "the most iterations were made, or no step lowers the energy any more",     \
      "allow more, raise the tolerance, or take fewer points")                                     \
    X("overflow", "a point of the film is beyond the range of double precision",                   \
      "scale the points down")                                                                     \
    X("ill-conditioned", "the knots or the degree are too extreme for doubles",                    \
      "lower the degree, or even out the knots")

/* Makes the model: the surface, and each cable as a curve named as its edge ("u0"); details:
 * unknowns, iterations, method, residual, updates, cables (edge, force, length, of elastic ones unstressed),
 * supports (the held corners), refinement, verdict { exists, stable, least }, rivals,
 * deviation of fitted curves, least: of sails in space the witness of the claim `least`, unless
 * without_least (docs/film.md).
 * TAUT_BAD_INPUT: data out of range, error->where the member. TAUT_NO_SOLUTION: no-area, crossed,
 * cable-too-weak, cable-too-short. TAUT_NOT_CONVERGED: folds, not-converged, curve-fit. */
TAUT_API taut_status taut_film_make(const taut_film_problem *problem,
                                    const taut_make_options *options, taut_model **model,
                                    taut_error *error);

/* The certificate: claims boundary, cables, held, length, stationary, stable, least, and
 * equilibrium where it is asked for; figures energy, of `least` lower_bound and gap, area, areas, lengths, tensions, sags,
 * reactions, lowest_eigenvalue, mean_curvature, cable_geodesic, cable_normal (docs/film.md).
 * TAUT_BAD_INPUT without a problem: the model does not say what its edges were. */
TAUT_API taut_status taut_film_certify(const taut_model *model, const taut_film_problem *problem,
                                       const taut_certify_options *options,
                                       taut_certificate **certificate, taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_FILM_H */
