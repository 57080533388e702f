/* film_along.h -- the member `cables` of films: cables along several edges. */
#ifndef TAUT_IO_PROBLEM_FILM_ALONG_H
#define TAUT_IO_PROBLEM_FILM_ALONG_H

#include "io/problem/film_patches.h"

/* Reads the law of a cable from the members of `law`, the object at `at`. */
typedef void taut_film_law_read(taut_reader *law, const taut_json *at, taut_film_edge *edge);

/* Fills the cables of data; their edges, of parts, become parts of them. Of a film of one patch parts->patches is data itself. */
void taut_film_document_along(taut_reader *document, taut_problem *problem,
                              const taut_film_parts *parts, taut_film_law_read *read_law,
                              taut_film_problem *data);

#endif /* TAUT_IO_PROBLEM_FILM_ALONG_H */
