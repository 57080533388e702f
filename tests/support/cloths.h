/* cloths.h -- cutting patterns from the text of a document, made and proved. */
#ifndef TAUT_TEST_CLOTHS_H
#define TAUT_TEST_CLOTHS_H

#include "taut/taut.h"

/* z = 0.3 (x^2 - y^2) over [-1, 1]^2, as JSON for `of`. */
#define SADDLE                                                                                     \
    "{ \"taut\": 1, \"surfaces\": [{ \"name\": \"sail\", \"u\": { \"type\": \"bezier\", "          \
    "\"degree\": 2 }, \"v\": { \"type\": \"bezier\", \"degree\": 2 }, \"points\": [[[-1, -1, 0], " \
    "[-1, 0, 0.6], [-1, 1, 0]], [[0, -1, -0.6], [0, 0, 0], [0, 1, -0.6]], [[1, -1, 0], [1, 0, "    \
    "0.6], [1, 1, 0]]] }] }"

/* Height 3, all around an ellipse of half axes `a`, which is negative with `b`, and 2: four rational arcs, whose speeds change by jumps. */
#define RING(a, b)                                                                                 \
    "{ \"taut\": 1, \"surfaces\": [{ \"name\": \"ring\", \"u\": { \"type\": \"bspline\", "         \
    "\"degree\": 2, \"knots\": [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4] }, \"v\": { \"type\": "        \
    "\"bezier\", \"degree\": 1 }, \"points\": [[[" a ", 0, 0], [" a ", 0, 3]], [[" a               \
    ", 2, 0], [" a ", 2, 3]], [[0, 2, 0], [0, 2, 3]], [[" b ", 2, 0], [" b ", 2, 3]], [[" b        \
    ", 0, 0], [" b ", 0, 3]], [[" b ", -2, 0], [" b ", -2, 3]], [[0, -2, 0], [0, -2, 3]], [[" a    \
    ", -2, 0], [" a ", -2, 3]], [[" a ", 0, 0], [" a                                               \
    ", 0, 3]]], \"weights\": [[1, 1], [0.70710678118654752, "                                      \
    "0.70710678118654752], [1, 1], [0.70710678118654752, 0.70710678118654752], [1, 1], "           \
    "[0.70710678118654752, 0.70710678118654752], [1, 1], [0.70710678118654752, "                   \
    "0.70710678118654752], [1, 1]] }] }"

typedef struct made_cloth {
    taut_problem *problem;
    taut_model *model;
    taut_certificate *proof;
    taut_status status; /* of the first call that failed */
    taut_error error;
} made_cloth;

/* "of": surface (JSON), and the rest of the members, such as "\"seams\": [...]". */
made_cloth cloth_make(const char *surface, const char *members);
/* Of the problem of examples/, without ".json"; `of` must succeed. */
made_cloth cloth_try_example(const char *name, const char *members);
made_cloth cloth_of_example(const char *name, const char *members);
void cloth_free(made_cloth *made);

/* A piece or a seam of details by its name, or NULL. */
const taut_record *cloth_told(const made_cloth *made, const char *list, const char *name);
/* A number of a piece, along a path of members: "edges/right/flat_length", "extent/0". NaN if there is none. */
double cloth_number(const made_cloth *made, const char *list, const char *name, const char *path);

/* A copy of details in which a text of this key is another one, or with the key "part" a number, wherever it is; with `new` NULL, without
 * that key. */
taut_record *cloth_edited(const taut_record *from, const char *key, const char *old,
                          const char *new);

#endif /* TAUT_TEST_CLOTHS_H */
