/* attack.h -- every claim is attacked alike: a model moved by ten times the limit fails it, one moved
 * by a tenth of it holds. */
#ifndef TAUT_TEST_ATTACK_H
#define TAUT_TEST_ATTACK_H

#include "taut/certify.h"
#include "taut/construct.h"

/* A problem out of a document's text, or of the worked example of that name, with its model. */
typedef struct subject {
    taut_problem *problem;
    taut_model *model;
} subject;

subject subject_of(const char *text);
subject subject_example(const char *name);
void subject_free(subject *s);

/* A copy of a model with surface k's control point p moved by `by`; k -1: as it is. Without details
 * and certificate. */
taut_model *model_moved(const taut_model *model, int k, int p, const double by[3]);
/* A copy with surface k replaced by one that is taken over. */
taut_model *model_with(const taut_model *model, int k, taut_surface *surface);
/* A copy with every coordinate times 2^exponent. */
taut_model *model_scaled(const taut_model *model, int exponent);

/* The certificate; problem NULL: of the model alone, as one of `construct`. CHECKs that there is
 * one. */
taut_certificate *prove(const taut_model *model, const taut_problem *problem,
                        const char *construct);

/* What is moved: points first .. last of a surface (in the order of its net) in random directions.
 * most: no limit that rounding explains is larger. */
typedef struct attack {
    const char *example;
    const char *claim;
    taut_claim_kind kind;
    int surface, first, last;
    double most;
} attack;

/* CHECKs a row `directions` times. A claim of limit 0 fails by one rounding. */
void attack_claim(const attack *row, int directions);

#endif /* TAUT_TEST_ATTACK_H */
