/* member.h -- members that several problems have. */
#ifndef TAUT_IO_PROBLEM_MEMBER_H
#define TAUT_IO_PROBLEM_MEMBER_H

#include "core/arena.h"
#include "io/json/in.h"
#include "taut/basis.h"
#include "taut/curve.h"
#include "taut/join.h"

/* A surface, and a curve, which the arena owns. */
void taut_member_surface(taut_reader *document, const char *key, taut_arena *arena,
                         const taut_surface **surface);
void taut_member_curve(taut_reader *document, const char *key, taut_arena *arena,
                       const taut_curve **curve);
/* The member "name"; NULL where it is missing or empty. */
void taut_member_name(taut_reader *document, taut_arena *arena, const char **name);

/* "u0", "u1", "v0" or "v1". */
void taut_member_edge(taut_reader *document, taut_edge *edge);
/* "width": a positive number, or 0 where it is missing. */
void taut_member_width(taut_reader *document, double *width);

/* TAUT_BAD_INPUT at a basis that is not of type bezier. */
void taut_member_check_bezier(taut_reader *document, const char *key, const taut_basis *basis);
/* TAUT_BAD_INPUT at the first member of a list (ended by NULL) that is there all the same:
 * "found <member> <why>". */
void taut_member_refuse(taut_reader *document, const char *const *strangers, const char *why);
/* "allow_ill_conditioned", or "insist", as it was called: true, or false, or not there, which is
 * false too. */
void taut_member_allow_ill_conditioned(taut_reader *document, int *value);
/* "regular": true, or false, or not there, which is false too: is the claim `regular` asked for? */
void taut_member_regular(taut_reader *document, int *value);

#endif /* TAUT_IO_PROBLEM_MEMBER_H */
