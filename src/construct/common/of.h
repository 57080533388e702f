/* of.h -- the surface that curves or pieces are made on: of a model that is given, or of what another problem makes;
 * and how a curve in its window is told. */
#ifndef TAUT_CONSTRUCT_COMMON_OF_H
#define TAUT_CONSTRUCT_COMMON_OF_H

#include "core/arena.h"
#include "taut/construct.h"

/* *made: `model`, or what `of` makes, which the arena owns; of what is wrong there the place is under "/of". */
taut_status taut_construct_of(const taut_model *model, const taut_problem *of,
                              const taut_make_options *options, taut_arena *arena,
                              const taut_model **made, taut_error *error);
/* The surface of a name, or of no name the only one. TAUT_BAD_INPUT, at "/surface". */
taut_status taut_construct_choose(const taut_model *model, const char *name,
                                  const taut_surface **surface, taut_error *error);
/* Adds "of": what was made first, and the details it was made with. */
void taut_construct_describe_of(const taut_problem *of, const taut_model *made,
                                taut_record *details);
/* Adds an item to "domain": a curve of the window, double[count][2], on its basis; of a surface of that name, or NULL:
 * the only one. */
void taut_construct_add_stretch(taut_record *domain, const char *name, const char *surface,
                                const taut_basis *basis, const double *points);

#endif /* TAUT_CONSTRUCT_COMMON_OF_H */
