/* sheet.h -- what is drawn of one surface: a grid of points and a value in each cell. */
#ifndef TAUT_DRAW_SHEET_H
#define TAUT_DRAW_SHEET_H

#include "core/arena.h"
#include "draw/camera.h"
#include "taut/measure.h"
#include "taut/model.h"
#include "taut/surface.h"
#include "taut/write.h"

/* The grid lines in one direction: every break of the basis is one, until there are too many. */
typedef struct taut_grid_lines {
    int count;              /* lines; cells are one fewer */
    double *at;             /* [count] parameters */
    double *middle;         /* [count - 1] parameters between them */
    unsigned char *is_knot; /* [count]: an inner break to be shown */
} taut_grid_lines;

typedef struct taut_sheet {
    const taut_surface *surface;
    int is_seen; /* once drawn: some of it, in front of all else */
    taut_grid_lines u, v;
    double *points;  /* [u.count][v.count][3]; not finite where the surface overflows */
    double *values;  /* [u.count-1][v.count-1] what the colour shows; NaN: none; NULL when plain */
    double *corners; /* [u.count-1][v.count-1][4] the same at the corners of the cells, seen from
                        within, for isolines; NULL without */
    double
        *stripes; /* likewise: the phase of the lights, whose sine is above 0 where one is mirrored;
                        NULL without */
} taut_sheet;

/* What a colour shows at a point; NaN where it has none. */
double taut_sheet_value(taut_colour colour, const taut_forms *forms);

/* Samples a surface into about `cells` cells, or into `divide` by `divide` cells a knot span when
 * divide > 0 (fewer when that would be more than `most`). */
taut_status taut_sheet_new(const taut_surface *surface, int cells, int most,
                           const taut_write_options *options, taut_arena *arena, taut_sheet *sheet);

/* Fills sheet->corners, in the order (u, v), (u+, v), (u+, v+), (u, v+). A jump of curvature at a
 * knot stays one, as each cell is looked at from within. */
taut_status taut_sheet_corners(const taut_write_options *options, taut_arena *arena,
                               taut_sheet *sheet);
/* Are there values below 0, too, of what a colour shows? */
static inline int taut_sheet_has_signs(taut_colour colour)
{
    return colour == TAUT_COLOUR_MEAN || colour == TAUT_COLOUR_GAUSSIAN ||
           colour == TAUT_COLOUR_STRAIN;
}
/* For colours that only films and cloth have fills sheet->values, and with isolines sheet->corners: the gap by the witness in the
 * details of the model (measure/dual/density.h), the stress by the figures of its certificate (measure/film/stress.h), the
 * strain of flat pieces (measure/cloth/mounted.h); NaN where there is none. */
taut_status taut_sheet_film(const taut_write_options *options, const taut_model *model,
                            taut_arena *arena, taut_sheet *sheet);
/* Fills sheet->stripes by the reflection lines that `lights` lamps leave. They are tubes along
 * `up`, far away, spread evenly around the figure, each as broad as the gap to the next: the ray
 * from the eye leaves a point as r = 2 (n.eye) n - eye, and meets a lamp where
 *     sin(lights atan2(r.right, r.eye)) > 0 */
taut_status taut_sheet_stripes(const taut_write_options *options, const taut_camera *camera,
                               taut_arena *arena, taut_sheet *sheet);

#endif /* TAUT_DRAW_SHEET_H */
