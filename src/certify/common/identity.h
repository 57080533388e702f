/* identity.h -- which surfaces and curves a certificate is about: the claim `identity`.
 *
 * Claims are about objects that a construction makes. Whatever else stands in the model is not
 * looked at by them, so it is named: with the problem at hand the claim counts
 *
 *     objects that should be there and are not, or not under their name,
 *     bases that the problem does not let the construction choose and that differ,
 *     objects beyond those expected,
 *     a unit that is not the problem's,
 *
 * and without it only names that stand twice; objects beyond are listed in figures.not_certified.
 * Kind exact: residual the number of differences, limit 0.
 */
#ifndef TAUT_CERTIFY_COMMON_IDENTITY_H
#define TAUT_CERTIFY_COMMON_IDENTITY_H

#include "core/arena.h"
#include "taut/model.h"

typedef struct taut_identity_name {
    const char *name;
    int index;
} taut_identity_name;

typedef struct taut_identity {
    const taut_model *model;
    int with_problem;
    unsigned char *surfaces, *curves; /* [count of the model]: nonzero: a claim is about it */
    taut_identity_name *names;        /* scratch */
    int differences;
    char where[160]; /* the first of them */
} taut_identity;

/* What a basis is to be; zero members leave it to the construction. */
typedef struct taut_expected_basis {
    const taut_basis *same;    /* this one */
    const taut_basis *refined; /* this one with knots inserted */
    const char *type;
    int degree[2];       /* least and most */
    int spans;           /* how many */
    const double *range; /* [2] */
} taut_expected_basis;

/* The callback of a construction (certify/certify_ops.h) calls these, once for each object that
 * its claims look at. index: in the model, or -1 where it is not there. name NULL: any. u, v, t
 * NULL: any basis; only looked at with the problem. */
void taut_identity_surface(taut_identity *identity, int index, const char *name,
                           const taut_expected_basis *u, const taut_expected_basis *v);
void taut_identity_curve(taut_identity *identity, int index, const char *name,
                         const taut_expected_basis *t);
/* The first surface or curve of a name, or -1. */
int taut_identity_find_surface(const taut_identity *identity, const char *name);
int taut_identity_find_curve(const taut_identity *identity, const char *name);

/* Begins, over the arena; and ends: adds the claim, and what is not certified to the figures.
 * unit: the problem's, or NULL where none is known. TAUT_NO_MEMORY. */
taut_status taut_identity_begin(taut_arena *arena, const taut_model *model, int with_problem,
                                taut_identity *identity);
taut_status taut_identity_end(taut_identity *identity, const char *unit,
                              taut_certificate *certificate);

#endif /* TAUT_CERTIFY_COMMON_IDENTITY_H */
