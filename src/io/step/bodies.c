/* bodies.c -- sheets as bodies, with or without a hollow. */
#include "core/fail.h"
#include "io/step/assembly.h"

taut_status taut_step_check_bodies(const taut_model *nurbs, const taut_shells *shells,
                                   taut_error *error)
{
    int i = 0;
    while (i < shells->shell_count && shells->shells[i].solid) {
        i++;
    }
    return i == shells->shell_count
               ? TAUT_OK
               : taut_fail(
                     error, TAUT_NO_SOLUTION, "sheet", NULL, taut_none, taut_none,
                     "the sheet around \"%.60s\" does not close: surfaces meet three at an "
                     "edge, or at a corner only, or their sides touch",
                     taut_surface_name(taut_model_surface(nurbs, shells->shells[i].faces[0])));
}

/* The face that is the other side of a body's, for each face of a hollow's inside; -1 for all else. Sides come one after the
 * other; those of a sheet with an outline are in one shell. */
taut_status taut_step_find_hollows(const taut_cad_facts *facts, const taut_shells *shells,
                                   taut_arena *arena, int **outside)
{
    *outside = taut_arena_take(arena, (size_t)shells->face_count, sizeof **outside);
    for (int f = 0; *outside != NULL && f < shells->face_count; f++) {
        const int apart = facts->from != NULL && f > 0 && facts->from[f] == facts->from[f - 1] &&
                          shells->faces[f].shell != shells->faces[f - 1].shell;
        (*outside)[f] = apart ? f - 1 : -1;
    }
    return *outside != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}
