/* film_net.h -- nets in the documents of films: `points`, which hold edges and corners, and `start`. */
#ifndef TAUT_IO_PROBLEM_FILM_NET_H
#define TAUT_IO_PROBLEM_FILM_NET_H

#include "core/arena.h"
#include "io/json/in.h"
#include "taut/film.h"

/* "points": [[P | null, ..], ..] in place of corners. A corner that is given is held, else free; the row of
 * an edge that is held becomes its curve, that of any other where it starts. named[e]: has the document a
 * word on edge e? TAUT_FILM_EDGE_JOINED: it is in a seam of patches. Bases, edges and seams have been read. */
enum { TAUT_FILM_EDGE_JOINED = 2 };
void taut_film_document_points(taut_reader *document, taut_arena *arena,
                               const unsigned char named[4], taut_film_problem *data);

/* "start": a model with a surface of the name of each of `count` parts (NULL: "film"), on its bases. */
void taut_film_document_start(taut_reader *document, taut_arena *arena, int count,
                              taut_film_problem *parts);

/* The document is well written, and there is no such film: TAUT_NO_SOLUTION. */
taut_status taut_film_document_none(const taut_json *at, const char *reason, const char *message,
                                    taut_error *error);

#endif /* TAUT_IO_PROBLEM_FILM_NET_H */
