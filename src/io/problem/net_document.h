/* net_document.h -- what documents with control points share: nets and the bases that go with them.
 */
#ifndef TAUT_IO_PROBLEM_NET_DOCUMENT_H
#define TAUT_IO_PROBLEM_NET_DOCUMENT_H

#include "core/arena.h"
#include "io/json/in.h"
#include "taut/basis.h"
#include "taut/dirichlet.h"

/* A net of a problem: some points may be unknown. */
typedef struct taut_net_document {
    const taut_basis *u, *v;
    double *points;       /* double[nu][nv][3], 0 where unknown */
    unsigned char *known; /* [nu][nv] */
    double *weights;      /* double[nu][nv], or NULL */
} taut_net_document;

/* Reads the members `u`, `v`, `points` (null: unknown) and `weights` of a problem; the arena owns
 * it all. */
void taut_net_document_read(taut_reader *document, taut_arena *arena, taut_net_document *net);
/* TAUT_BAD_INPUT where one of its bases "u" and "v" is no basis of surfaces. */
void taut_net_document_check_bases(taut_reader *document, const taut_basis *u, const taut_basis *v);

/* The same of a surface, whose points are all known: net->known is NULL. */
taut_status taut_net_document_read_known(const taut_json *object, taut_arena *arena,
                                         taut_net_document *net, taut_error *error);

/* The rows and columns of an array of arrays, each row as long as the first. */
taut_status taut_net_document_shape(const taut_json *points, int *rows, int *columns,
                                    taut_error *error);
/* One point [x, y, z], each a number or the text of a rational one. */
taut_status taut_net_document_point(const taut_json *at, double point[3], taut_error *error);
/* points double[rows][columns][3]; known [rows][columns] or NULL where every point must be given.
 * rows 0: a plain list of columns points. The shape has been read already. */
taut_status taut_net_document_points(const taut_json *at, int rows, int columns, double *points,
                                     unsigned char *known, taut_error *error);
/* The texts of rational coordinates, [rows][columns][3], borrowed from the document, NULL for
 * numbers and unknown points; *found whether there are any; `texts` may be NULL. The points have
 * been read already. */
void taut_net_document_texts(const taut_json *at, int rows, int columns, const char **texts,
                             int *found);
/* weights double[rows][columns], positive; rows 0 as above. */
taut_status taut_net_document_weights(const taut_json *at, int rows, int columns, double *weights,
                                      taut_error *error);

/* The member `through`, if it is there; points without u and v have NaN for them. */
void taut_net_document_through(taut_reader *document, taut_arena *arena,
                               taut_dirichlet_problem *data);

#endif /* TAUT_IO_PROBLEM_NET_DOCUMENT_H */
