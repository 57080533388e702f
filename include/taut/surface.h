/* taut/surface.h -- tensor-product surfaces, optionally rational.
 *
 *     x(u, v) = sum_ij w_ij P_ij N_i(u) N_j(v) / sum_ij w_ij N_i(u) N_j(v),   w = 1 without weights
 *
 * Points are Euclidean (not multiplied by weights), double points[nu][nv][3], u slowest. A surface
 * is immutable and a deep copy of what it was given, so every call here is safe from any thread. A
 * surface carries its parameter range: it is the range of its bases.
 */
#ifndef TAUT_SURFACE_H
#define TAUT_SURFACE_H

#include "taut/basis.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct taut_surface taut_surface;

/* Reasons that surfaces, curves, models, what is done to them and what is measured of them give,
 * besides the general ones (taut/status.h) and those of documents (taut/read.h): word, meaning,
 * remedy. */
#define TAUT_GEOMETRY_REASON_LIST(X)                                                               \
    X("bases-differ", "opposite curves are on c- or h- bases that differ",                         \
      "give both on the same basis, or convert them to B-splines")                                 \
    X("basis", "a basis of this type has no such operation", "convert it to NURBS first")          \
    X("close-knots", "knots of two curves lie too close to be distinguished",                      \
      "make the knots that are meant to be one the same number")                                   \
    X("corner-weights", "weights of four curves do not agree at the corners they share",           \
      "scale the weights until both ways around give the same ones")                               \
    X("degree", "a degree is higher, or would be raised higher, than is taken there",              \
      "keep to the largest degree that the message names")                                         \
    X("empty", "a model or a file holds no surface and no curve, or none that the format takes",   \
      "give one that holds some")                                                                  \
    X("fold", "a sheet given a thickness folds over itself",                                       \
      "take a smaller thickness, or a coarser mesh")                                               \
    X("gap", "four curves do not close",                                                           \
      "move the ends that the message names together, or allow a larger gap")                      \
    X("no-such-object", "nothing in the model has this name",                                      \
      "give the name of one that is there")                                                        \
    X("no-surface", "the model has no surface", "give a model that has one")                       \
    X("not-bezier", "a curve has several spans, or is on a basis that is no polynomial one",       \
      "give a curve of one Bezier span")                                                           \
    X("not-clamped", "a curve does not begin and end in control points",                           \
      "convert it to a B-spline")                                                                  \
    X("not-converged", "the largest quadrature rule does not settle the integrals of a basis",     \
      "use weights that vary less, or a shape that is less extreme")                               \
    X("not-exact", "rational arithmetic is for polynomial surfaces on bezier bases",               \
      "split it without exact arithmetic")                                                         \
    X("not-in-family", "the surface is no minimal surface with planar curvature lines",            \
      "give a net on the bases that hold the family")                                              \
    X("parameter", "a parameter is not inside the open range", "give one between the ends")        \
    X("sheet",                                                                                     \
      "surfaces meet so that they have no two sides to give a thickness to, or none so near",      \
      "part them, raise --tolerance, or write them one by one: --surface")                         \
    X("tolerance", "a tolerance is below what rounding leaves", "ask for the limit at least")      \
    X("too-fine", "a mesh would have too many vertices", "ask for a coarser one")                  \
    X("too-large", "coordinates are too large to prove a distance", "scale them")                  \
    X("too-many-objects", "a model would hold too many surfaces or curves",                        \
      "cut fewer of them at a time")                                                               \
    X("too-many-points", "a result would have too many control points",                            \
      "ask for a larger tolerance, or refine less")

/* name     at most TAUT_NAME_MAX bytes of UTF-8 (else U+FFFD in JSON), NULL means ""
 * u, v     the bases, copied
 * points   double[nu][nv][3], finite, nu and nv the counts of u and v
 * weights  double[nu][nv], finite and positive, or NULL; only on bases that allow them
 * TAUT_BAD_INPUT with error->where such as "/weights/0/3"; TAUT_NO_MEMORY. The caller owns
 * *surface. */
TAUT_API taut_status taut_surface_new(const char *name, const taut_basis *u, const taut_basis *v,
                                      const double *points, const double *weights,
                                      taut_surface **surface, taut_error *error);
/* A deep copy, the caller's. TAUT_NO_MEMORY. */
TAUT_API taut_status taut_surface_copy(const taut_surface *surface, taut_surface **copy);
/* As taut_surface_new, with points that are rational: exact[nu][nv][3] are texts "p" or "p/q", of
 * which `points` are the nearest doubles (not compared); NULL where a coordinate is the double
 * itself. The texts are copied, and are written in place of the doubles as JSON; only operations
 * that say so keep them. TAUT_BAD_INPUT also where a text is no rational number, error->where such
 * as "/points/0/3/2". */
TAUT_API taut_status taut_surface_new_exact(const char *name, const taut_basis *u,
                                            const taut_basis *v, const double *points,
                                            const double *weights, const char *const *exact,
                                            taut_surface **surface, taut_error *error);
TAUT_API void taut_surface_free(taut_surface *surface); /* NULL is fine */

TAUT_API const char *taut_surface_name(const taut_surface *surface);      /* borrowed, never NULL */
TAUT_API const taut_basis *taut_surface_u(const taut_surface *surface);   /* borrowed */
TAUT_API const taut_basis *taut_surface_v(const taut_surface *surface);   /* borrowed */
TAUT_API const double *taut_surface_points(const taut_surface *surface);  /* borrowed */
TAUT_API const double *taut_surface_weights(const taut_surface *surface); /* borrowed, or NULL */
/* Borrowed, [nu][nv][3]; NULL where all coordinates are doubles. */
TAUT_API const char *const *taut_surface_exact(const taut_surface *surface);

/* Vectors per point at each order, in the order written. */
enum {
    TAUT_X = 0,  /* position */
    TAUT_XU = 1, /* first derivatives */
    TAUT_XV = 2,
    TAUT_XUU = 3, /* second derivatives */
    TAUT_XUV = 4,
    TAUT_XVV = 5
};
/* 1, 3 or 6 vectors for order 0, 1 or 2. */
#define TAUT_SURFACE_VECTORS(order) (((order) + 1) * ((order) + 2) / 2)

/* Evaluates on the grid of nu by nv parameters:
 *     values[i][j][k][3],  k = TAUT_X .. as many as the order gives, at (u[i], v[j])
 * u, v     double[nu], double[nv]; in the closed ranges (TAUT_BAD_ARGUMENT otherwise, nothing
 *          written); at an inner knot the derivatives are those from the right
 * order    0, 1 or 2
 * values   double[nu][nv][TAUT_SURFACE_VECTORS(order)][3], the caller's
 * threads  0 or 1: this thread; more: so many; the result is the same for any number
 * Cost: basis functions once per line, then O(nv local_u) + O(local_v) multiply-adds a row and
 * point. TAUT_NO_MEMORY if the scratch of O(nu + nv + count_v) numbers is not to be had. */
TAUT_API taut_status taut_surface_eval_grid(const taut_surface *surface, int nu, const double *u,
                                            int nv, const double *v, int order, int threads,
                                            double *values);

/* The single point: values double[TAUT_SURFACE_VECTORS(order)][3]. No allocation. */
TAUT_API taut_status taut_surface_eval(const taut_surface *surface, double u, double v, int order,
                                       double *values);

/* Evaluates at `count` places in no order: what taut_surface_eval gives at (u[i], v[i]), bit for
 * bit,
 *     values[i][k][3],  k = TAUT_X .. as many as the order gives
 * u, v     double[count]; in the closed ranges (TAUT_BAD_ARGUMENT otherwise, nothing written)
 * values   double[count][TAUT_SURFACE_VECTORS(order)][3], the caller's
 * threads  as of taut_surface_eval_grid
 * No allocation. Where the places are a grid, taut_surface_eval_grid is several times as fast.
 * Normals and curvatures: taut_surface_forms_points (taut/measure.h). */
TAUT_API taut_status taut_surface_eval_points(const taut_surface *surface, int count,
                                              const double *u, const double *v, int order,
                                              int threads, double *values);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_SURFACE_H */
