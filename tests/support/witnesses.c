#include "witnesses.h"

#include "check.h"

#include "taut/read.h"

#include <string.h>

static double changed(witness_change *c, double x, int is_meant)
{
    const long k = c->seen++;

    if (!is_meant) {
        return x;
    }
    if (c->at >= 0) {
        return k == c->at ? c->instead : x;
    }
    return random_int(0, 2) == 0 ? x + c->by * random_in(-1, 1) : x;
}

static void copy(const taut_record *from, const char *key, taut_record *to, witness_change *c,
                 int is_meant)
{
    const taut_record_kind kind = taut_record_kind_of(from);

    if (kind == TAUT_RECORD_NUMBER) {
        taut_record_add_number(to, key, changed(c, taut_record_number(from), is_meant));
    } else if (kind == TAUT_RECORD_TEXT) {
        taut_record_add_text(to, key, taut_record_text(from));
    } else {
        const int is_list = kind == TAUT_RECORD_LIST;
        taut_record *one =
            is_list ? taut_record_add_list(to, key) : taut_record_add_object(to, key);
        for (size_t k = 0; k < taut_record_count(from); k++) {
            const char *name = is_list ? NULL : taut_record_key(from, k);
            if (name == NULL || c->without == NULL || strcmp(name, c->without) != 0) {
                copy(taut_record_at(from, k), name, one, c,
                     is_meant || (name != NULL && c->only != NULL && strcmp(name, c->only) == 0));
            }
        }
    }
}

taut_model *witness_changed(const taut_model *model, witness_change change)
{
    const taut_record *least = taut_record_get(taut_model_details(model), "least");
    taut_record *details = taut_record_new();
    taut_model *other = NULL;

    CHECK(taut_model_copy(model, &other) == TAUT_OK, "copy");
    copy(least, "least", details, &change, change.only == NULL);
    CHECK(taut_record_status(details) == TAUT_OK, "record");
    taut_model_set_details(other, details);
    return other;
}
