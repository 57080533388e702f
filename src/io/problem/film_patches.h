/* film_patches.h -- the members `patches`, `seams` and `cells` of films. */
#ifndef TAUT_IO_PROBLEM_FILM_PATCHES_H
#define TAUT_IO_PROBLEM_FILM_PATCHES_H

#include "io/problem/document_ops.h"
#include "taut/film.h"

/* How film.c reads what one patch has, its tension or threads, and a cable's law with its plane. */
typedef struct taut_film_patch_readers {
    void (*patch)(taut_reader *patch, taut_problem *problem, taut_film_problem *data);
    void (*tension)(taut_reader *patch, taut_problem *problem, taut_film_problem *data);
    void (*cable)(taut_reader *in, taut_film_edge *edge);
} taut_film_patch_readers;

/* The patches and seams of a film that is being read. */
typedef struct taut_film_parts {
    taut_film_problem *patches;
    taut_film_seam *seams;
} taut_film_parts;

/* Fills the patches and the seams of data, which are those of parts. */
void taut_film_document_patches(taut_reader *document, taut_problem *problem,
                                const taut_film_patch_readers *readers, taut_film_problem *data,
                                taut_film_parts *parts);

/* "NAME.u0" or "-NAME.u0", of a film of one patch without its name. Where it is none: `name` or `type`. */
taut_status taut_film_document_side(const taut_json *at, const taut_film_problem *data,
                                    taut_film_side *side, taut_error *error);

/* The cells; data->patches, or the film itself, by name. */
void taut_film_document_cells(taut_reader *document, taut_problem *problem,
                              taut_film_problem *data);

#endif /* TAUT_IO_PROBLEM_FILM_PATCHES_H */
