/* taut/construct.h -- problems, and making a model from one.
 *
 * A problem is one document's request in memory: which construction, and its data. It comes from
 * taut_problem_read (taut/read.h). Programs that hold their data already call a construction
 * directly, through its own header (taut/dirichlet.h, ...), with the plain struct found there.
 *
 *     document -> taut_problem_read -> taut_make -> taut_certify -> taut_model_set_certificate
 */
#ifndef TAUT_CONSTRUCT_H
#define TAUT_CONSTRUCT_H

#include "taut/model.h"
#include "taut/monitor.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Immutable once read: any number of threads may make and certify from one. */
typedef struct taut_problem taut_problem;

TAUT_API void taut_problem_free(taut_problem *problem); /* NULL is fine */
/* The construction's name, such as "dirichlet". */
TAUT_API const char *taut_problem_construction(const taut_problem *problem);
/* The document that it was read from (of a list, its item alone), byte for byte and with a 0 behind
 * it; *length may be NULL. Borrowed: it lives as long as the problem. Read again it is the same
 * problem, but for paths in it, which are relative to where the first one was read from. */
TAUT_API const char *taut_problem_text(const taut_problem *problem, size_t *length);

/* The names of all constructions, i = 0 .. count-1; NULL beyond. */
TAUT_API int taut_construct_count(void);
TAUT_API const char *taut_construct_name(int i);

/* Zero means default everywhere. taut_make refuses what is out of its range (TAUT_BAD_ARGUMENT); a
 * construction called through its own header reads only what it has a use for. */
typedef struct taut_make_options {
    double tolerance; /* largest distance from the exact surface over its size; 0: 1e-6 */
    int threads;      /* 0: 1 */
    taut_monitor monitor;
    int exact; /* nonzero: in rational arithmetic (harmonic and harmonic-extension): surfaces come
                * with their exact points. TAUT_BAD_ARGUMENT from taut_make for other
                * constructions, TAUT_IO without FLINT */
    double time_limit; /* seconds by the clock on the wall, above 0: then it ends with the best so
                        * far, as TAUT_ENOUGH of a monitor does; 0: none. Only taut_make and
                        * taut_plateau_make look at it, between reports. What comes out depends on
                        * the machine */
} taut_make_options;

/* Makes the model: surfaces, curves and `details`, no certificate yet. options may be NULL.
 * Ended early (a time limit, TAUT_ENOUGH), `plateau` gives the surface as far as it came, with
 * `details.stopped` ("time" or "request"), and leaves it to the certificate to say what does not hold
 * of it; `film`, once it is at rest, gives that without what comes after, finer spaces and the witness
 * of `least`. Other constructions, and these before they have a surface, are TAUT_NOT_CONVERGED,
 * reason "time".
 * TAUT_BAD_ARGUMENT: NULL, or an option out of its range; TAUT_BAD_INPUT: data that is,
 * error->where the member; TAUT_NO_SOLUTION: well formed, but what it asks for does not exist;
 * TAUT_NOT_CONVERGED; TAUT_NO_MEMORY; TAUT_INTERRUPTED. *model is the caller's on success,
 * untouched on failure. */
TAUT_API taut_status taut_make(const taut_problem *problem, const taut_make_options *options,
                               taut_model **model, taut_error *error);

/* A draft of the model, from one that was made or drafted of nearly the same problem a moment before: at most `steps` >= 1
 * cheap steps, each nearer (docs/film.md), none at all where it is at rest. For a hand that drags: nothing is proved, and what
 * taut_make says of the problem may be another thing. *model is NULL where there is no way from there, as where the bases are
 * others, and for constructions that have no drafts: all but `film` and `plateau`.
 * Statuses as taut_make. *model is the caller's on success, untouched on failure. */
TAUT_API taut_status taut_draft(const taut_problem *problem, const taut_model *before, int steps,
                                taut_model **model, taut_error *error);

/* Zero means default everywhere. */
typedef struct taut_certify_options {
    int threads;      /* 0: 1 */
    double tolerance; /* that the model was made to, where a claim depends on it; 0: 1e-6 */
    int exact; /* nonzero: the claim `harmonic` in rational arithmetic, its limit 0; as above */
    taut_monitor
        monitor; /* TAUT_INTERRUPTED where it says stop, or enough: a certificate is whole */
} taut_certify_options;

/* What a certificate may miss: the word in error->reason, its meaning, a remedy. */
#define TAUT_CERTIFY_REASON_LIST(X)                                                                \
    X("needs-problem", "the model alone does not say what it was to be",                           \
      "give the problem it was made from too")                                                     \
    X("model", "the construction makes no such model, or not of this problem",                     \
      "give the model of this problem")                                                            \
    X("details", "the model's details lack what its claims are about, or are wrong",               \
      "make the model again")

/* Proves a model again from its numbers alone. problem NULL: the construction is taken from the
 * certificate the model carries, and claims that need the problem's data are judged from the model
 * and its details where that is possible (each construction's page says how), else
 * TAUT_BAD_INPUT says that the problem is needed. */
TAUT_API taut_status taut_certify(const taut_model *model, const taut_problem *problem,
                                  const taut_certify_options *options,
                                  taut_certificate **certificate, taut_error *error);

/* The certificate that a saved model carries, proved again as far as the model alone decides it; claims that need the problem
 * are those that were saved, `as_saved` set. Figures are new. Errors as taut_certify without a problem. */
TAUT_API taut_status taut_certify_again(const taut_model *model,
                                        const taut_certify_options *options,
                                        taut_certificate **certificate, taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_CONSTRUCT_H */
