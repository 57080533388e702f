/* draft.h -- a film from one that was there a moment ago. */
#ifndef TAUT_CONSTRUCT_FILM_DRAFT_H
#define TAUT_CONSTRUCT_FILM_DRAFT_H

#include "construct/film/solve.h"

/* Has this film drafts? Not where edges slide, corners are free, a film becomes its own reference, or patches and images are
 * joined. */
int taut_film_has_draft(const taut_film_problem *problem);

/* The problem as a draft begins from the surface `before`, on the same bases: its net is the start, without what the problem
 * holds. *start: in the arena. TAUT_NO_MEMORY. */
taut_status taut_film_draft_begin(const taut_film_problem *problem, const taut_surface *before,
                                  taut_arena *arena, taut_film_problem *begun);

/* So many steps (construct/plateau/draft.h) in the space of such a problem; forces[4] of its cables in the film before, 0 where
 * not known. TAUT_NO_SOLUTION: it leads nowhere; TAUT_NO_MEMORY. */
taut_status taut_film_draft(const taut_film_space *space, const taut_surface *before,
                            const double forces[4], int steps, taut_arena *arena,
                            taut_film_solution *solution, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_DRAFT_H */
