/* entities.h -- what the parts of a STEP file hand to each other: numbers of instances. */
#ifndef TAUT_IO_STEP_ENTITIES_H
#define TAUT_IO_STEP_ENTITIES_H

#include "core/arena.h"
#include "io/step/cuts.h"
#include "io/step/elementary.h"
#include "io/step/part21.h"
#include "shell/shell.h"
#include "taut/model.h"

/* product.c: unit, uncertainty and spaces, which all else refers to; and the product at the end. */
typedef struct taut_step_spaces {
    size_t space;     /* of three dimensions, in the unit, with the uncertainty */
    size_t plane;     /* of parameters */
    size_t along[2];  /* unit vectors of parameters: u, v */
    size_t placement; /* the origin */
} taut_step_spaces;

/* What there is: numbers of solids, surface models, curve sets, each `counts` long. */
enum { TAUT_STEP_SOLIDS, TAUT_STEP_SHELLS, TAUT_STEP_CURVES, TAUT_STEP_KINDS };
typedef struct taut_step_content {
    size_t counts[TAUT_STEP_KINDS];
    size_t *items[TAUT_STEP_KINDS]; /* with room for one more in front */
    size_t style_count, *styles;
    size_t place_count, *places; /* of an assembly, those of its parts: places[1] on */
} taut_step_content;

void taut_step_put_spaces(taut_part21 *out, const char *unit, double precision,
                          taut_step_spaces *spaces);
/* Products; field and stage are what all of a file refer to, 0 at first. */
typedef struct taut_step_product {
    size_t definition, shape, field, stage;
} taut_step_product;
void taut_step_put_product(taut_part21 *out, const char *name, const taut_step_spaces *spaces,
                           taut_step_content *content, taut_step_product *product);
size_t taut_step_put_direction(taut_part21 *out, size_t count, const double *direction);

/* Control points of one direction, both ends included: all, or those of a piece between two knots as often there as the degree. */
typedef struct taut_step_range {
    int from, to;
} taut_step_range;

/* A row of a net along direction 0 u, 1 v, at control point `line` of the other. */
typedef struct taut_step_row {
    int along, line;
    taut_step_range range;
} taut_step_row;

/* geometry.c: the points of a surface, u slowest: the number of the first; a surface, or a piece of it, on them; a curve of its own;
 * the curve that is a row of a surface's net, on its points, or, where `points` is 0, points of its own. */
size_t taut_step_put_net(taut_part21 *out, const taut_surface *surface);
size_t taut_step_put_surface(taut_part21 *out, const taut_surface *surface, size_t points,
                             const taut_step_range ranges[2]);
size_t taut_step_put_curve(taut_part21 *out, const taut_curve *curve);
size_t taut_step_put_row(taut_part21 *out, const taut_surface *surface, size_t points,
                         const taut_step_row *row);

/* topology.c: all faces, of these forms, in these pieces, as solids and surface models, which enter `content` with their styles.
 * outside[face] is -1, or for a face of the inside of a hollow one of the outside of its body. TAUT_NO_MEMORY. */
taut_status taut_step_put_faces(taut_part21 *out, const taut_model *model,
                                const taut_shells *shells, const taut_step_form *forms,
                                const taut_step_cuts *cuts, const int *outside,
                                const taut_step_spaces *spaces, taut_arena *arena,
                                taut_step_content *content);

/* style.c: what gives an item the i-th colour of surfaces or of curves, as figures and pages have
 * them; style[i % TAUT_STEP_COLOURS] keeps the number of what was written, at first 0. */
enum { TAUT_STEP_COLOURS = 24 };
size_t taut_step_style_face(taut_part21 *out, size_t item, int i, size_t *style);
size_t taut_step_style_curve(taut_part21 *out, size_t item, int i, size_t *style);

#endif /* TAUT_IO_STEP_ENTITIES_H */
