/* scene.h -- what is to be painted: cells of surfaces, lines and discs, hidden parts hidden.
 *
 * Cells are painted from the farthest to the nearest (painter's algorithm: they are small, so the
 * depth of their middle decides). Lines and discs come after all cells: of a line only the parts
 * that no surface hides are kept, judged point by point against the depth of the surfaces on the
 * page, so that what is left is a few long strokes and not a dotted row of pieces.
 */
#ifndef TAUT_DRAW_SCENE_H
#define TAUT_DRAW_SCENE_H

#include "draw/canvas.h"
#include "draw/depth.h"

typedef struct taut_cell {
    double depth;
    size_t order; /* in which it was added: decides between equal depths */
    double xy[4][2];
    taut_ink ink;
} taut_cell;

/* A line through points[first .. first+count-1], or a disc when count is 1. */
typedef struct taut_stroke {
    size_t first;
    int count;
    double size; /* width, or radius */
    taut_ink ink, rim;
} taut_stroke;

/* A number on a line, on paper of its own. */
typedef struct taut_tag {
    double xy[2]; /* its middle */
    char text[24];
    taut_ink ink, paper;
} taut_tag;

typedef struct taut_scene {
    taut_cell *cells;
    taut_stroke *strokes;
    double (*points)[2];
    unsigned char *hidden; /* scratch of taut_scene_line */
    taut_tag *tags;
    size_t tag_count, tag_room;
    double tag_size; /* of their letters, in page units */
    size_t cell_count, stroke_count, point_count;
    size_t cell_room, stroke_room, point_room, hidden_room;
    taut_depth depth;
    taut_status status; /* TAUT_NO_MEMORY sticks: later additions do nothing */
} taut_scene;

/* Width and height of the page. Clear it also when this fails. */
taut_status taut_scene_init(taut_scene *scene, double width, double height, taut_arena *arena);
void taut_scene_clear(taut_scene *scene);

/* Points are (x, y, depth) in page units, the larger depth nearer. What has a coordinate that is
 * not finite is left out. All cells before any line. */
void taut_scene_cell(taut_scene *scene, const double *const corner[4], taut_ink ink);
/* A piece of the cell that was added last, painted right over it; corners as above. */
void taut_scene_over(taut_scene *scene, const double *const corner[4], taut_ink ink);
/* points: double[count][3] */
void taut_scene_line(taut_scene *scene, size_t count, const double *points, taut_ink ink,
                     double width);
/* The same of where a surface turns away: the line is found to within `reach` of it, and that far beside the surface
 * it still counts as seen. */
void taut_scene_fold(taut_scene *scene, size_t count, const double *points, taut_ink ink,
                     double width, double reach);
/* The same, where hidden by no more than `slack` still seen, and where hidden by more a thinner
 * line of the ink `faint`: of nets, which lie along their surface and behind it. */
void taut_scene_line_through(taut_scene *scene, size_t count, const double *points, taut_ink ink,
                             taut_ink faint, double width, double slack);
void taut_scene_disc(taut_scene *scene, const double at[3], taut_ink ink, taut_ink rim,
                     double radius);

/* Is a finite point behind a surface by more than `slack`? */
int taut_scene_hides(const taut_scene *scene, const double at[3], double slack);
/* Does a box of this size about a point lie on surfaces whole, and away from all tags by `gap`? */
int taut_scene_has_room(const taut_scene *scene, const double at[3], const double size[2],
                        double gap);
void taut_scene_tag(taut_scene *scene, const taut_tag *tag);

/* Sorts and draws: cells, then lines and discs as they were added, then tags. */
void taut_scene_paint(taut_scene *scene, const taut_canvas_ops *ops, taut_canvas *canvas);

#endif /* TAUT_DRAW_SCENE_H */
