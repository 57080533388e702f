/* member.h -- members that several problems have, and those that may be missing. */
#ifndef TAUT_IO_PROBLEM_MEMBER_H
#define TAUT_IO_PROBLEM_MEMBER_H

#include "core/arena.h"
#include "io/json/in.h"
#include "taut/basis.h"
#include "taut/join.h"

/* A number, and one of a few words: as taut_json_number and taut_json_word; *value stays as it is
 * where the member is missing. */
taut_status taut_member_number(const taut_json *document, const char *key, double *value,
                               taut_error *error);
taut_status taut_member_word(const taut_json *document, const char *key, const char *const *words,
                             int *value, taut_error *error);

/* A surface, which the arena owns. */
taut_status taut_member_surface(const taut_json *document, const char *key, taut_arena *arena,
                                const taut_surface **surface, taut_error *error);
/* Gives a basis to the arena. */
taut_status taut_member_keep_basis(taut_arena *arena, taut_basis *made, const taut_basis **basis,
                                   taut_error *error);
/* The member "name"; NULL where it is missing or empty. */
taut_status taut_member_name(const taut_json *document, taut_arena *arena, const char **name,
                             taut_error *error);

/* "u0", "u1", "v0" or "v1". */
taut_status taut_member_edge(const taut_json *document, taut_edge *edge, taut_error *error);
/* "width": a positive number, or 0 where it is missing. */
taut_status taut_member_width(const taut_json *document, double *width, taut_error *error);

/* TAUT_BAD_INPUT at a basis that is not of type bezier. */
taut_status taut_member_check_bezier(const taut_json *document, const char *key,
                                     const taut_basis *basis, taut_error *error);
/* TAUT_BAD_INPUT at the first member of a list (ended by NULL) that is there all the same:
 * "found <member> <why>". */
taut_status taut_member_refuse(const taut_json *document, const char *const *strangers,
                               const char *why, taut_error *error);
/* "allow_ill_conditioned", or "insist", as it was called: true, or false, or not there, which is
 * false too. */
taut_status taut_member_allow_ill_conditioned(const taut_json *document, int *value,
                                              taut_error *error);

#endif /* TAUT_IO_PROBLEM_MEMBER_H */
