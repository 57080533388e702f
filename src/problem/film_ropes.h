/* film_ropes.h -- the cables of a film, one by one: each an edge, a seam, or several of these with one force. */
#ifndef TAUT_PROBLEM_FILM_ROPES_H
#define TAUT_PROBLEM_FILM_ROPES_H

#include "problem/film_complex.h"

/* The law of a cable. */
static inline const taut_film_edge *taut_film_rope_law(const taut_film_complex *complex, int rope)
{
    return complex->ropes[rope].edge;
}

/* Does it draw with a force that is not given? */
static inline int taut_film_rope_is_given(const taut_film_edge *law)
{
    return law->law == TAUT_FILM_LENGTH || law->law == TAUT_FILM_SAG;
}

/* As the details call it: its edge, or its name. */
void taut_film_rope_name(const taut_film_complex *complex, int rope, char name[TAUT_FILM_NAME]);
/* Where it is in the document, "/edges/u0/cable" or the like. */
enum { TAUT_FILM_ROPE_WHERE = 80 };
void taut_film_rope_where(const taut_film_complex *complex, int rope, const char *member,
                          char where[TAUT_FILM_ROPE_WHERE]);

/* The distance of its ends where both are held, else 0. */
double taut_film_rope_chord(const taut_film_complex *complex, int rope);
/* The length that is given, by its sag too, 0 where this has no chord; 0 of other laws. */
double taut_film_rope_length(const taut_film_complex *complex, int rope);

/* complex->ropes, of its strands, in the arena. TAUT_BAD_INPUT: curve-ends, edge-conflict; TAUT_BAD_ARGUMENT, TAUT_NO_MEMORY. */
taut_status taut_film_ropes_find(taut_film_complex *complex, taut_arena *arena, taut_error *error);
/* Once holds are known. TAUT_NO_SOLUTION: cable-too-short. */
taut_status taut_film_ropes_check(const taut_film_complex *complex, taut_error *error);

#endif /* TAUT_PROBLEM_FILM_ROPES_H */
