/* construct_ops.h -- what one construction must provide. */
#ifndef TAUT_CONSTRUCT_OPS_H
#define TAUT_CONSTRUCT_OPS_H

#include "problem/construct_list.h"
#include "taut/construct.h"

typedef struct taut_construct_ops {
    /* data: the construction's own struct. options is never NULL. The model gets its surfaces,
     * curves and details. */
    taut_status (*make)(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error);
    /* From a model that it made a moment before, some steps; or NULL. *model stays where there is no way from there. */
    taut_status (*draft)(const void *data, const taut_model *before, int steps, taut_model **model,
                         taut_error *error);
    int exact;      /* nonzero: knows options->exact */
    int ends_early; /* nonzero: has its own pace (core/pace.h), and a best so far to show */
} taut_construct_ops;

#define TAUT_CONSTRUCT_DECLARE(identifier, name)                                                   \
    extern const taut_construct_ops taut_construct_##identifier;
TAUT_CONSTRUCT_LIST(TAUT_CONSTRUCT_DECLARE)
#undef TAUT_CONSTRUCT_DECLARE

#endif /* TAUT_CONSTRUCT_OPS_H */
