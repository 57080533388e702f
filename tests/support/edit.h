/* edit.h -- a model with everything in it open to change, and bases to forge from. */
#ifndef TAUT_TEST_FORGE_EDIT_H
#define TAUT_TEST_FORGE_EDIT_H

#include "taut/construct.h"

#include <stddef.h>
#include <stdint.h>

/* What one forgery takes; all is given back at once. */
typedef struct forge_pool {
    char *bytes;
    size_t size, used;
} forge_pool;

void *pool_take(forge_pool *pool, size_t bytes); /* never NULL: ends the program where it is out */

/* splitmix64, one for each forgery, so that a seed and a number name it. */
typedef struct forge_random {
    uint64_t state;
} forge_random;

uint64_t forge_bits(forge_random *random);
double forge_in(forge_random *random, double lo, double hi);
int forge_int(forge_random *random, int lo, int hi);
double forge_log(forge_random *random, double lo, double hi);
double forge_sign(forge_random *random);

enum { EDIT_OBJECTS_MAX = 40 };

typedef struct edit_surface {
    const char *name;
    taut_basis_spec u, v;
    int nu, nv;
    double *points, *weights;
} edit_surface;

typedef struct edit_curve {
    const char *name;
    taut_basis_spec t;
    int n;
    double *points, *weights;
} edit_curve;

typedef struct edit_model {
    forge_pool *pool;
    const char *construct, *unit;
    int surfaces, curves;
    edit_surface surface[EDIT_OBJECTS_MAX];
    edit_curve curve[EDIT_OBJECTS_MAX];
    taut_record *details; /* owned, or NULL */
} edit_model;

/* A worked example, made. */
typedef struct forge_base {
    const char *name, *construct;
    const char *text;
    size_t length;
    taut_problem *problem;
    taut_record *document;
    taut_model *model;
} forge_base;

/* 0 where it is not made. */
int base_open(const char *name, const char *text, size_t length, forge_base *base);
void base_close(forge_base *base);

void edit_open(const taut_model *model, const char *construct, forge_pool *pool, edit_model *edit);
/* The model, with a certificate that names its construction; NULL where no such model can be. */
taut_model *edit_close(edit_model *edit);

/* Ways to forge, in kinds.c. */
typedef void (*forge_fn)(edit_model *edit, const forge_base *base, const forge_base *other,
                         forge_random *random);
typedef struct forge_kind {
    const char *name;
    forge_fn apply;
} forge_kind;
extern const forge_kind forge_kinds[];
extern const int forge_kind_count;

/* Random legal problems, in made.c: the text of one, from the pool. */
const char *made_problem(const forge_base *base, forge_pool *pool, forge_random *random);

#endif /* TAUT_TEST_FORGE_EDIT_H */
