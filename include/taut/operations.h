/* taut/operations.h -- exact operations on curves, surfaces and models; and NURBS within a tolerance.
 *
 * Each makes new objects and leaves the old ones as they were. All but taut_*_to_nurbs represent
 * the same points exactly: their only error is rounding, a few units of 2^-53 of the largest
 * coordinate for each step. Rational weights are carried through in homogeneous coordinates.
 *
 * Outputs are untouched on failure. Statuses all share: TAUT_OK, TAUT_NO_MEMORY, TAUT_BAD_ARGUMENT
 * (NULL, no such direction, a number out of the range said), and TAUT_NO_SOLUTION where
 * the basis has no such operation or the parameter is not inside its range.
 *
 *     operation     bezier            bspline        c-, h-bezier       c-, h-bspline     ce-bezier
 *     split         two bezier        two bspline    two of the type    see below         bezier
 *     refine        bspline, 2 spans  bspline        bspline, 2 segm.   twice the segm.   bspline
 *     pieces        itself            bezier         itself             c-, h-bezier      bezier
 *     insert        bspline           bspline        -                  -                 bspline
 *     elevate       bezier            bspline        -                  -                 bezier
 *     reverse       bezier            bspline        the type           the type          the type
 *     rerange       bezier            bspline        translation        translation       bezier
 *
 * Cut on a knot, a c- or h-bspline becomes two of its type; elsewhere all its segments, the cut one
 * in two, as c- or h-bezier pieces. What comes of a ce-bezier is a quartic.
 *
 * Sources: [PieglTiller1997] ch. 5, [Farin2002] ch. 5-6 (bezier, bspline); [XuWang2006] sections 3,
 * 4, 6 (c-, h-); [WangBai2018] section 2 (ce-).
 */
#ifndef TAUT_OPERATIONS_H
#define TAUT_OPERATIONS_H

#include "taut/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Directions of a surface. */
enum { TAUT_ALONG_U = 0, TAUT_ALONG_V = 1 };

/* Cuts at t, lo < t < hi: the pieces, low ones first, as the surfaces (or curves) of a new model,
 * named "<name>-0", "<name>-1", ... ("piece-0", ... without a name). They keep their parameters. */
TAUT_API taut_status taut_curve_split(const taut_curve *curve, double t, taut_model **pieces,
                                      taut_error *error);
TAUT_API taut_status taut_surface_split(const taut_surface *surface, int direction, double t,
                                        taut_model **pieces, taut_error *error);

/* Every span on its own, on bezier, c-bezier or h-bezier bases; named and ordered as above, for a
 * surface with u slowest. */
TAUT_API taut_status taut_curve_pieces(const taut_curve *curve, taut_model **pieces,
                                       taut_error *error);
TAUT_API taut_status taut_surface_pieces(const taut_surface *surface, taut_model **pieces,
                                         taut_error *error);

/* Halves every span. */
TAUT_API taut_status taut_curve_refine(const taut_curve *curve, taut_curve **refined,
                                       taut_error *error);
TAUT_API taut_status taut_surface_refine(const taut_surface *surface, int direction,
                                         taut_surface **refined, taut_error *error);

/* Puts the knot t, lo < t < hi, in `times` >= 0 more; at most as often as the degree in all. */
TAUT_API taut_status taut_curve_insert(const taut_curve *curve, double t, int times,
                                       taut_curve **refined, taut_error *error);
TAUT_API taut_status taut_surface_insert(const taut_surface *surface, int direction, double t,
                                         int times, taut_surface **refined, taut_error *error);

/* Raises the degree `times` >= 0, up to TAUT_DEGREE_MAX. */
TAUT_API taut_status taut_curve_elevate(const taut_curve *curve, int times, taut_curve **raised,
                                        taut_error *error);
TAUT_API taut_status taut_surface_elevate(const taut_surface *surface, int direction, int times,
                                          taut_surface **raised, taut_error *error);

/* The parameter t becomes lo + hi - t. */
TAUT_API taut_status taut_curve_reverse(const taut_curve *curve, taut_curve **reversed,
                                        taut_error *error);
TAUT_API taut_status taut_surface_reverse(const taut_surface *surface, int direction,
                                          taut_surface **reversed, taut_error *error);
/* u and v change places. */
TAUT_API taut_status taut_surface_transpose(const taut_surface *surface, taut_surface **transposed,
                                            taut_error *error);

/* The range becomes [lo, hi], lo < hi, by an affine map of the parameter. A c- or h- basis can only
 * be moved: TAUT_BAD_INPUT at "/range" for another length. */
TAUT_API taut_status taut_curve_rerange(const taut_curve *curve, double lo, double hi,
                                        taut_curve **moved, taut_error *error);
TAUT_API taut_status taut_surface_rerange(const taut_surface *surface, int direction, double lo,
                                          double hi, taut_surface **moved, taut_error *error);

/* x becomes A x + b, matrix double[3][4] = (A | b), finite: isometries, scalings, any affine map.
 */
TAUT_API taut_status taut_curve_transform(const taut_curve *curve, const double *matrix,
                                          taut_curve **moved, taut_error *error);
TAUT_API taut_status taut_surface_transform(const taut_surface *surface, const double *matrix,
                                            taut_surface **moved, taut_error *error);

/* The same on bspline bases. Polynomial directions are exact. On c- and h- directions quintic C^2
 * Hermite interpolants stand in, on spans so narrow that the distance between points of
 * equal parameters is proved below `tolerance` (> 0, a length). *bound, if not NULL, is the proved
 * distance, rounding included; 0 where all is exact.
 * TAUT_BAD_ARGUMENT: the tolerance is below what rounding leaves (error->limit says what).
 * TAUT_NO_SOLUTION: it would take more than TAUT_COUNT_MAX functions or TAUT_POINTS_MAX points.
 * Cost: O(spans u * spans v) for the proof; the spans grow as tolerance^(-1/6). */
TAUT_API taut_status taut_curve_to_nurbs(const taut_curve *curve, double tolerance,
                                         taut_curve **nurbs, double *bound, taut_error *error);
TAUT_API taut_status taut_surface_to_nurbs(const taut_surface *surface, double tolerance,
                                           taut_surface **nurbs, double *bound, taut_error *error);

/* Whole models. Details and certificate, which speak of the old surfaces, are left out; the unit
 * stays. `name` is the surface or curve to take, or NULL. Where it is NULL every surface is cut,
 * and every curve whose range holds t when the direction is u (they run along their own parameter)
 * or there are no surfaces; what is not cut is copied. Pieces stand in the place of the whole, with
 * names that are distinct in the model. TAUT_NO_SOLUTION, with error->where the place such as
 * "/surfaces/1": t is not inside. TAUT_BAD_ARGUMENT: nothing has that name, or nothing to cut. */
TAUT_API taut_status taut_model_split(const taut_model *model, const char *name, int direction,
                                      double t, taut_model **split, taut_error *error);

/* The same in rational arithmetic, t taken as the number it is: the pieces have exact points. All
 * surfaces that are cut are polynomial on bezier bases, else TAUT_NO_SOLUTION; curves are cut as
 * above. TAUT_IO where FLINT was not there when taut was built. */
TAUT_API taut_status taut_model_split_exact(const taut_model *model, const char *name,
                                            int direction, double t, taut_model **split,
                                            taut_error *error);

/* Halves the spans of every surface, or of the one named, along u and along v as the two flags
 * say (neither: both); curves when named, or where there are no surfaces. */
TAUT_API taut_status taut_model_refine(const taut_model *model, const char *name, int along_u,
                                       int along_v, taut_model **refined, taut_error *error);

/* Every span of every surface and curve, or of those named, on its own: on bezier, c-bezier or
 * h-bezier bases (a ce-bezier as its quartic bezier); names as above. */
TAUT_API taut_status taut_model_pieces(const taut_model *model, const char *name,
                                       taut_model **pieces, taut_error *error);

/* Every surface and curve as NURBS, each within `tolerance` times its own size: the diagonal of the
 * box around its points on a 17 by 17 grid. *bound, if not NULL, is the largest proved distance, a
 * length. */
TAUT_API taut_status taut_model_to_nurbs(const taut_model *model, double tolerance,
                                         taut_model **nurbs, double *bound, taut_error *error);

/* The curves that a document's "boundary" may name, as a model of curves in the same unit: first those of the model, as they are, then
 * the edges u0, u1, v0, v1 of its surfaces, named "SURFACE.u0" (or "surface3.u0" of the third one, where it has no name), along the
 * parameter of the surface. Edges that are a point, and those that are no row of the net (on bases that do not end in their points), are left
 * out. TAUT_NO_SOLUTION: more than TAUT_OBJECTS_MAX; TAUT_NO_MEMORY. */
TAUT_API taut_status taut_model_boundary(const taut_model *model, taut_model **curves,
                                         taut_error *error);

/* The same model in another unit, "mm", "cm", "m", "in" or "ft": coordinates times one number, the ratio of the two rounded
 * to a double. TAUT_BAD_ARGUMENT: no such unit. TAUT_NO_SOLUTION: a coordinate leaves the range of doubles. */
TAUT_API taut_status taut_model_to_unit(const taut_model *model, const char *unit,
                                        taut_model **converted, taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_OPERATIONS_H */
