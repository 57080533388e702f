/* parts.h -- a finished pipe taken apart, for its certificate. */
#ifndef TAUT_CERTIFY_PIPE_PARTS_H
#define TAUT_CERTIFY_PIPE_PARTS_H

#include "certify/common/audit.h"
#include "certify/pipe/axis.h"
#include "taut/pipe.h"

typedef struct taut_pipe_parts {
    const taut_surface *blend, *pipes[2];
    const taut_curve *axis;
    const taut_pipe_problem *problem; /* or NULL */
    int quintic;                      /* nonzero: a quintic with three points on either end edge */
    double polygon[4][3];             /* V_0 .. V_3 of the axis, */
    double shape[3];                  /* and its shape numbers */
    const taut_curve *const *axes;    /* of all pieces, */
    int axis_count;                   /* straight pipes of a single one aside */
    taut_pipe_line line;
    taut_pipe_figures figures;
    taut_pipe_apart apart;
    int is_bent_little; /* nonzero: the curvature is proved to leave room for the radius */
    double radius;      /* the user's unit; of ellipses, that of the circle around the larger */
    taut_pipe_ellipse ellipses[2]; /* a of the first 0: round */
    double flatness;               /* the largest semi-axis over the smallest; 1 for round ones */
    int unlike;                    /* nonzero: they are circles of unlike radii */
    int canal;                     /* nonzero: they are of a canal surface, a = b = r */
    double turn;                   /* psi at the end */
    double (*frames)[3];           /* U along the pieces (section.c) */
    double drawn[2];               /* how long the straight pipes should be, local */
    double size;                   /* the largest coordinate of any control point, */
    double sizes[3];               /* and the largest x, y, z */
    const taut_crew *crew;
} taut_pipe_parts;

/* How far rounding moves one control point against another at right angles to the axis, where both
 * should lie along it at end `side`: coordinates that do not change along it, nor between them, are
 * exact. */
double taut_pipe_sideways(const taut_pipe_parts *parts, int side, const double changes[3]);

/* quintic, polygon and shape from the axis; TAUT_BAD_INPUT for an axis of another kind. */
taut_status taut_pipe_read_axis(taut_pipe_parts *parts, taut_error *error);
/* The axis with other shape numbers. */
taut_status taut_pipe_axis_with(const taut_pipe_parts *parts, const double shape[3],
                                taut_curve **curve, taut_error *error);

/* sections, flatness, turn and frames; radius, where there are sections. TAUT_NO_MEMORY. */
taut_status taut_pipe_read_sections(const taut_model *model, taut_pipe_parts *parts);
/* How far a point is from the ellipse at parameter s of a piece, over the radius; `offset` is where
 * it is from the axis there, local. */
double taut_pipe_section_miss(const taut_pipe_parts *parts, int piece, double s,
                              const double offset[3]);
/* pi times the integral of a b along the axis; the area, by quadrature both ways. */
double taut_pipe_section_volume(const taut_pipe_parts *parts);
double taut_pipe_section_area(const taut_pipe_parts *parts);
/* U, W and dT/ds at parameter s of a piece. */
void taut_pipe_section_frame(const taut_pipe_parts *parts, int piece, double s, double u[3],
                             double w[3], double turn[3]);

/* How far a point (local) is from the canal surface, over the radius: |x - P(t)| - r(t) at its
 * least, sought from t; *convex is how it bends there, over |P'|^2 / |x - P|, 0 on a crease. */
double taut_pipe_canal_miss(const taut_pipe_parts *parts, const double x[3], double t,
                            double *convex);
/* Area and volume by their closed forms. */
void taut_pipe_canal_measures(const taut_pipe_parts *parts, double *area, double *volume);

/* What taut_surface_eval gives at v of the edge u0, or u1 where `last`, order 1 or 2, with
 * derivatives along u of the accuracy of differences of neighbouring points. */
void taut_pipe_edge_eval(const taut_surface *s, int last, double v, int order, double (*d)[3]);

/* Two surfaces at the end `side` of the blend and its straight pipe, as a claim that is made: the
 * residual, what rounding leaves of it, and where. */
typedef struct taut_pipe_meeting {
    double residual, noise;
    taut_claim_kind kind; /* a check where the residual is of places only */
    char where[64];
} taut_pipe_meeting;

/* The larger of gap over radius and sine between the normals, bounded all along; jumps of principal
 * curvatures, bounded where that decides, else sampled. TAUT_NO_MEMORY. */
taut_status taut_pipe_measure_joint(const taut_pipe_parts *parts, int side,
                                    taut_pipe_meeting *meeting);
taut_status taut_pipe_measure_curvatures(const taut_pipe_parts *parts, int side,
                                         taut_pipe_meeting *meeting);

/* The foot of a local point on the axis, sought from parameter `t` of the curve, and the way from
 * it. */
void taut_pipe_find_foot(const taut_pipe_line *line, const double x[3], double t, int *at_piece,
                         double *at_s, double offset[3]);
void taut_pipe_to_local(const taut_pipe_line *line, const double x[3], double local[3]);

/* Parameter k of n + 1 evenly over a basis; the ends exactly. */
double taut_pipe_parameter(const taut_basis *basis, int k, int n);
/* v made unit; 0 where it is. */
void taut_pipe_unit(const double v[3], double out[3]);
/* The unit normal of two tangents, whatever their lengths; 0 where there is none. */
void taut_pipe_unit_normal(const double xu[3], const double xv[3], double normal[3]);

/* Surface and curve of a name, or NULL. */
const taut_surface *taut_pipe_find_surface(const taut_model *model, const char *name);
const taut_curve *taut_pipe_find_curve(const taut_model *model, const char *name);
/* The radius that the details tell; `seen` where they do not. */
double taut_pipe_radius_told(const taut_model *model, double seen);
/* sizes, of one more surface. */
void taut_pipe_add_sizes(const taut_surface *surface, taut_pipe_parts *parts);
/* Is this the model of a run? Its certificate. */
int taut_pipe_is_run(const taut_model *model);
taut_status taut_pipe_claim_run(const taut_model *model, const taut_pipe_run_problem *problem,
                                const taut_audit *audit, taut_certificate *certificate,
                                taut_error *error);
/* The figure total_torsion, null with the reason where it is not to be had. */
void taut_pipe_add_torsion(taut_record *figures, double torsion);
/* All figures of the axis. TAUT_NO_MEMORY. */
taut_status taut_pipe_find_figures(taut_pipe_parts *parts);
/* Is the curvature proved to be below a limit (local) everywhere (bent.c)? TAUT_NO_MEMORY. */
taut_status taut_pipe_prove_bend(const taut_pipe_parts *parts, double limit, int *proved);
/* The claim `embedded`, which holds where the radius is below the largest: rounding of the axis
 * moves that by a part of itself, within which the verdict is open. */
taut_status taut_pipe_claim_embedded(const taut_pipe_parts *parts, const char *where,
                                     taut_certificate *certificate);

/* The claims: joint.c, tube.c, envelope.c, caps.c, ends.c. Each adds one, or returns TAUT_NO_MEMORY. */
taut_status taut_pipe_claim_joint(const taut_pipe_parts *parts, int side,
                                  taut_certificate *certificate);
taut_status taut_pipe_claim_curvature(const taut_pipe_parts *parts, int side,
                                      taut_certificate *certificate);
taut_status taut_pipe_claim_tube(const taut_pipe_parts *parts, double tolerance, double *fit_error,
                                 taut_certificate *certificate);
taut_status taut_pipe_claim_run_tube(const char *name, const taut_pipe_parts *parts, int count,
                                     const taut_surface *const *surfaces,
                                     const taut_curve *const *curves, double tolerance,
                                     double *fit_error, taut_certificate *certificate);
/* `regular` and `graph` of the canal surface about the axis. */
taut_status taut_pipe_claim_envelope(const taut_pipe_parts *parts, taut_certificate *certificate);
/* `caps`, where there are any, over the free ends of the first and the last surface, or between them and those
 * inside (NULL: discs). */
taut_status taut_pipe_claim_caps(const taut_model *model, const taut_pipe_parts *parts,
                                 const taut_surface *const ends[2],
                                 const taut_surface *const inside[2],
                                 taut_certificate *certificate);
taut_status taut_pipe_claim_ends(const taut_pipe_parts *parts, taut_certificate *certificate);
taut_status taut_pipe_claim_optimal(const taut_pipe_parts *parts, taut_certificate *certificate,
                                    taut_error *error);

/* What rounding by `noise` lets a residual be: at most 1e-6. */
double taut_pipe_held(double noise);

/* A claim about a residual that rounding makes uncertain by `noise`: it holds up to the limit, is
 * open up to the noise, and else is false. The limit is `noise`, at most 1e-6, where `limit` is 0.
 */
taut_status taut_pipe_add_claim(const char *name, taut_claim_kind kind, double residual,
                                double limit, double noise, const char *where,
                                taut_certificate *certificate);

#endif /* TAUT_CERTIFY_PIPE_PARTS_H */
