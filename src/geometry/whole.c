#include "geometry/whole.h"

#include <string.h>

int taut_model_shows(const taut_model *model, const char *name, int i)
{
    const char *own = taut_surface_name(taut_model_surface(model, i));
    const taut_record *whole = taut_record_get(taut_model_details(model), "whole");

    if (name != NULL) {
        return strcmp(name, own) == 0;
    }
    return taut_record_kind_of(whole) != TAUT_RECORD_TEXT || taut_model_surface_count(model) < 2 ||
           strcmp(taut_record_text(whole), own) != 0;
}
