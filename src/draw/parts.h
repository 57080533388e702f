/* parts.h -- surfaces, nets, curves and combs as cells, lines and discs of a scene. */
#ifndef TAUT_DRAW_PARTS_H
#define TAUT_DRAW_PARTS_H

#include "core/arena.h"
#include "draw/camera.h"
#include "draw/scene.h"
#include "draw/sheet.h"
#include "taut/curve.h"
#include "taut/model.h"

/* The shaded cells of a sheet. limit: the range of the colours when the sheet has values. *page,
 * in the arena: the sheet's points on the page, for taut_parts_outline. */
taut_status taut_parts_cells(const taut_sheet *sheet, const taut_camera *camera, taut_ink ink,
                             double limit, taut_arena *arena, taut_scene *scene, double **page);

/* Its silhouette, and its knot lines (or, with boundary, the boundary). */
taut_status taut_parts_silhouette(const taut_sheet *sheet, const double *page, taut_arena *arena,
                                  taut_scene *scene);
taut_status taut_parts_outline(const taut_sheet *sheet, const double *page, int boundary,
                               taut_ink ink, taut_arena *arena, taut_scene *scene);

/* Where its values are k step, k = first .. last; its corners are filled. Zero is drawn bolder. */
taut_status taut_parts_isolines(const taut_sheet *sheet, const double *page, double step, int first,
                                int last, taut_scene *scene);
/* The values on them, one name a level where there is room; all cells and no tag of the page's
 * other sheets are behind. */
taut_status taut_parts_isoline_names(const taut_sheet *sheet, const double *page, double step,
                                     int first, int last, double limit, taut_scene *scene);
/* `count` inner lines of equal u and of equal v, evenly spread. */
taut_status taut_parts_parameter_lines(const taut_surface *surface, int count,
                                       const taut_camera *camera, taut_arena *arena,
                                       taut_scene *scene);

/* The net double points[nu][nv][3], or a polygon when nu is 1. Of many lines every k-th is drawn,
 * and then no points. */
taut_status taut_parts_net(int nu, int nv, const double *points, const taut_camera *camera,
                           taut_arena *arena, taut_scene *scene);
void taut_parts_net_points(int nu, int nv, const double *points, const taut_camera *camera,
                           taut_scene *scene);
/* Is every line of the net drawn? */
int taut_parts_net_is_whole(int nu, int nv);

/* A curve through count points. */
taut_status taut_parts_curve(size_t count, const double *points, const taut_camera *camera,
                             taut_ink ink, taut_arena *arena, taut_scene *scene);

/* The first TAUT_PARTS_NODES nodes of a net of curves (details.nodes): a point each, and its name where there is room. */
enum { TAUT_PARTS_NODES = 4000 };
taut_status taut_parts_nodes(const taut_model *model, const taut_camera *camera, taut_scene *scene);

/* Points along a curve: double[*count][3], in the arena; not finite where it overflows. */
taut_status taut_parts_sample_curve(const taut_curve *curve, int most, taut_arena *arena,
                                    size_t *count, double **points);

/* ---- curvature combs: along a curve, teeth against the side it bends to, as long as it bends ----
 *
 *     tooth from x to x - s k,    k = (x'' - (x''.T) T) / |x'|^2,  T = x' / |x'|
 *
 * s makes the longest tooth of a figure an eighth of its size, and the figure says what that is. */

enum { TAUT_COMB_TEETH = 97 };

/* The combs of the four edges u0, u1, v0, v1 of a surface. NaN where there is no curvature. */
typedef struct taut_combs {
    double foot[4][TAUT_COMB_TEETH][3];
    double bend[4][TAUT_COMB_TEETH][3]; /* k */
    double tip[4][TAUT_COMB_TEETH][3];  /* after taut_combs_scale */
} taut_combs;

/* Returns the largest |k| in *most, which is not lowered. */
taut_status taut_combs_fill(const taut_surface *surface, taut_combs *combs, double *most);
void taut_combs_scale(taut_combs *combs, double scale);
taut_status taut_combs_add(const taut_combs *combs, const taut_camera *camera, taut_scene *scene);

/* ---- reactions: an arrow to each corner that a film is held at, as the cables pull at it ----
 *
 * The longest of a figure is an eighth of its size, and the figure says what it is. */

enum { TAUT_ARROWS_MOST = 64 }; /* supports beyond have none */

typedef struct taut_arrows {
    int count;
    double head[TAUT_ARROWS_MOST][3];  /* the corners */
    double force[TAUT_ARROWS_MOST][3]; /* `reactions` among the figures of the certificate */
    double tail[TAUT_ARROWS_MOST][3];  /* after taut_arrows_scale */
} taut_arrows;

/* Of all surfaces of the model, or of one of them alone. None where the model's certificate tells none. The largest force in *most,
 * which is not lowered. */
void taut_arrows_fill(const taut_model *model, const taut_surface *alone, taut_arrows *arrows,
                      double *most);
void taut_arrows_scale(taut_arrows *arrows, double scale);
taut_status taut_arrows_add(const taut_arrows *arrows, const taut_camera *camera,
                            taut_scene *scene);

#endif /* TAUT_DRAW_PARTS_H */
