/* assembly.h -- what of a model becomes which product. */
#ifndef TAUT_IO_STEP_ASSEMBLY_H
#define TAUT_IO_STEP_ASSEMBLY_H

#include "io/cad/prepare.h"
#include "io/step/entities.h"

/* One part of an assembly, or the whole: a model of its own, whose faces are sewn among themselves. */
typedef struct taut_step_part {
    const char *name;
    const taut_model *model; /* in coordinates of its own */
    const int *said;         /* the colours that its surfaces were given, -1 for none */
    double place[12];        /* the rows of (A | b), where it is in the whole */
    int is_placed;           /* elsewhere than as it is */
    int of; /* the part whose product this is a use of: itself, or an earlier one */
    taut_shells shells;
    taut_step_form *forms;
    taut_step_cuts *cuts;
    int *outside;
    taut_step_content content;
    taut_step_product product;
} taut_step_part;

/* parts[0] is the whole, or what of it is in no part, and [1] to [count - 1] its parts: none where the model is no assembly, or is made
 * to sheets. *moved: how far a point is from where the model has it, a length. All from the arena. TAUT_NO_MEMORY. */
taut_status taut_step_list_parts(const taut_model *nurbs, const taut_cad_facts *facts,
                                 taut_arena *arena, int *count, taut_step_part **parts,
                                 double *moved);

/* The placements of parts, into places[count] and the content of the whole; and, after all products, their uses. */
void taut_step_put_places(taut_part21 *out, int count, taut_step_part *parts, size_t *places);
void taut_step_put_uses(taut_part21 *out, int count, const taut_step_part *parts,
                        const taut_step_spaces *spaces);

/* That no edge of a solid is so short that readers take it for a point: TAUT_NO_SOLUTION, reason "single-point". */
taut_status taut_step_check_edges(const taut_model *nurbs, const taut_shells *shells,
                                  taut_error *error);
/* bodies.c: sheets are bodies, every one: else TAUT_NO_SOLUTION, "sheet". */
taut_status taut_step_check_bodies(const taut_model *nurbs, const taut_shells *shells,
                                   taut_error *error);
/* (*outside)[faces]: see taut_step_put_faces; from the arena. TAUT_NO_MEMORY. */
taut_status taut_step_find_hollows(const taut_cad_facts *facts, const taut_shells *shells,
                                   taut_arena *arena, int **outside);

#endif /* TAUT_IO_STEP_ASSEMBLY_H */
