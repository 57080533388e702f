/* prepare.h -- what STEP and IGES begin with: NURBS, and what the file's header says of them. */
#ifndef TAUT_IO_CAD_PREPARE_H
#define TAUT_IO_CAD_PREPARE_H

#include "core/arena.h"
#include "core/date.h"
#include "taut/limits.h"
#include "taut/write.h"

typedef struct taut_cad_facts {
    double bound;     /* how far the NURBS may be from the model: a length, proved */
    double thickness; /* of the sheets that they are; 0: none */
    double measured;  /* how far the sides of these were found from where they belong, a check */
    double proved;    /* how far they are at most; infinite where it is not proved */
    const int
        *from; /* the surface that each comes from of those that were asked for; NULL: the same */
    double precision;             /* what the file states as its uncertainty, above 0 */
    int part_count;               /* of an assembly; 0: it is one part */
    const char *const *parts;     /* [part_count] names of their products */
    const double *places;         /* [part_count][12]: where they are, the rows of (A | b) */
    const int *part;              /* the part of each surface, -1: of none */
    char date[TAUT_DATE_ROOM];    /* "2026-03-01T12:00:00", UTC: SOURCE_DATE_EPOCH, else now */
    char made[64], exact[128];    /* lines for people */
    char name[TAUT_NAME_MAX + 1]; /* of the whole: its construction, else its first part */
} taut_cad_facts;

/* The surfaces and curves that options ask for as NURBS, the caller's. What is polynomial or
 * rational stays exactly as it is; c- and h- directions come within the tolerance, with a proved
 * bound (taut/operations.h). With a thickness: sheets of the surfaces (shell/thick), without the
 * curves. details.colours are those of the model. What facts point at is in the arena.
 * TAUT_NO_SOLUTION: nothing, or a degree above 25, the most that OpenCASCADE and what is made of it
 * have; else as taut_model_to_nurbs and taut_thick_new. */
taut_status taut_cad_prepare(const taut_model *model, const taut_write_options *options,
                             taut_arena *arena, taut_model **nurbs, taut_cad_facts *facts,
                             taut_error *error);

/* facts->exact, of facts->bound and what sheets add to it. */
void taut_cad_say_bound(const char *unit, taut_cad_facts *facts);
/* What is proved of the distance from the model, or from the sides of its sheets; NAN: nothing. */
double taut_cad_bound(const taut_cad_facts *facts);

/* looks.c: details.colours of what comes from `model`, and the parts of facts. TAUT_NO_MEMORY. */
taut_status taut_cad_keep_looks(const taut_model *model, const taut_write_options *options,
                                taut_arena *arena, taut_model *nurbs, taut_cad_facts *facts,
                                taut_error *error);

/* sheets.c: puts the sheets of the surfaces in their place, within `tolerance`, a length. TAUT_NO_SOLUTION: there are no surfaces;
 * else as taut_thick_new. */
taut_status taut_cad_make_sheets(const taut_write_options *options, double tolerance,
                                 taut_arena *arena, taut_model **nurbs, taut_cad_facts *facts,
                                 taut_error *error);

#endif /* TAUT_IO_CAD_PREPARE_H */
