/* pane.h -- one picture of a figure: some surfaces and curves under one camera.
 *
 * A figure has one pane for each model, or, side by side, one for each surface of one model.
 */
#ifndef TAUT_DRAW_PANE_H
#define TAUT_DRAW_PANE_H

#include "draw/parts.h"
#include "taut/model.h"

typedef struct taut_polyline {
    const taut_curve *curve;
    size_t count;
    double *points;
    int is_seen; /* once drawn: a fiftieth of it, of an axis a fifth */
} taut_polyline;

typedef struct taut_pane {
    const taut_model *model;
    const taut_model *
        own; /* with the same surfaces, flat pieces where the model has them; NULL: the model itself */
    int surface;       /* the one that is shown, or -1: all that options->surface leaves */
    const char *label; /* what stands above, or NULL */
    int sheet_count, curve_count;
    taut_sheet *sheets;
    taut_combs *combs; /* [sheet_count], or NULL */
    double comb_scale, comb_most;
    taut_arrows arrows; /* of no support where they are not asked for */
    double arrow_scale, arrow_most;
    taut_polyline *curves;
    double **pages; /* [sheet_count] the sheets' points on the page */
    taut_camera
        core; /* the box of surfaces, curves, combs and arrows: nets far beyond are left out */
    taut_camera camera;
} taut_pane;

/* Does the pane show surface i of its model? */
int taut_pane_shows(const taut_pane *pane, const taut_write_options *options, int i);
/* Samples what the pane shows, in about `cells` cells a surface, `most` at the most. */
taut_status taut_pane_sample(taut_pane *pane, const taut_write_options *options, int cells,
                             int most, int along, taut_arena *arena);
/* visit(camera, count, points) for surfaces, curves, combs and arrows, and for the nets that are drawn. */
void taut_pane_visit_core(const taut_pane *pane, taut_camera *camera,
                          void (*visit)(taut_camera *, size_t, const double *));
void taut_pane_visit_nets(const taut_pane *pane, const taut_write_options *options,
                          taut_camera *camera,
                          void (*visit)(taut_camera *, size_t, const double *));
/* The number of a surface's plain colour, and of a curve's (mesh/colour.h). */
int taut_pane_sheet_colour(const taut_pane *pane, int i);
int taut_pane_curve_colour(const taut_pane *pane, int i);
/* How many nets the pane leaves out as they lie far beyond its core, and how many there are. */
int taut_pane_far_nets(const taut_pane *pane, const taut_write_options *options);
int taut_pane_nets(const taut_pane *pane, const taut_write_options *options);

/* In this order, each for every pane before the next: cells; lines; curves and points of nets.
 * limit: the range of the colours. */
taut_status taut_pane_add_cells(taut_pane *pane, const taut_write_options *options, double limit,
                                taut_arena *arena, taut_scene *scene);
taut_status taut_pane_add_lines(taut_pane *pane, const taut_write_options *options, double limit,
                                taut_arena *arena, taut_scene *scene);
taut_status taut_pane_add_curves(taut_pane *pane, const taut_write_options *options,
                                 taut_arena *arena, taut_scene *scene);

#endif /* TAUT_DRAW_PANE_H */
