#include "draw/strip.h"

#include <stdio.h>

static const taut_record *lambdas(const taut_model *model)
{
    return taut_record_get(taut_model_details(model), "lambda");
}

int taut_strip_is(const taut_model *model)
{
    return taut_model_surface_count(model) > 1 && taut_model_curve_count(model) == 0 &&
           taut_record_kind_of(lambdas(model)) == TAUT_RECORD_LIST &&
           taut_record_count(lambdas(model)) == (size_t)taut_model_surface_count(model);
}

const char *taut_strip_label(const taut_model *model, int i, taut_arena *arena)
{
    enum { ROOM = 32 };
    char *label = taut_arena_take(arena, ROOM, 1);
    if (label != NULL) {
        snprintf(label, ROOM, "lambda %.4g",
                 taut_record_number(taut_record_at(lambdas(model), (size_t)i)));
    }
    return label;
}
