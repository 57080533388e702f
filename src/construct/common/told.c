#include "construct/common/told.h"

#include "core/fail.h"

#include <math.h>

const taut_record *taut_told_list(const taut_model *model, const char *mark, const char *name)
{
    const taut_record *details = model != NULL ? taut_model_details(model) : NULL;
    return taut_record_get(details, mark) != NULL ? taut_record_get(details, name) : NULL;
}

taut_status taut_told_item(const taut_record *list, const char *what, const char *name, int i,
                           const void *place, const taut_record **found, taut_error *error)
{
    if (place == NULL || i < 0 || (size_t)i >= taut_record_count(list)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, i,
                         (double)taut_record_count(list), "the %s has %zu %s, and no number %d",
                         what, taut_record_count(list), name, i);
    }
    *found = taut_record_at(list, (size_t)i);
    return TAUT_OK;
}

double taut_told_number(const taut_record *at, const char *name)
{
    const taut_record *one = taut_record_get(at, name);
    return one != NULL ? taut_record_number(one) : NAN;
}

const char *taut_told_text(const taut_record *at, const char *name)
{
    return taut_record_text(taut_record_get(at, name));
}

void taut_told_numbers(const taut_record *at, const char *name, size_t count, double *out)
{
    const taut_record *list = taut_record_get(at, name);
    for (size_t k = 0; k < count; k++) {
        out[k] = k < taut_record_count(list) ? taut_record_number(taut_record_at(list, k)) : NAN;
    }
}
