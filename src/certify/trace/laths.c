#include "certify/trace/laths.h"

#include <math.h>
#include <string.h>

const taut_record *taut_net_lath_of(const taut_net_lines *lines, const taut_net_line *line)
{
    const taut_record *laths = taut_record_get(taut_model_details(lines->model), "laths");
    const size_t count = taut_record_count(laths);
    for (size_t i = 0; i < count; i++) { /* mostly in the order of the curves */
        const taut_record *lath = taut_record_at(laths, ((size_t)line->index + i) % count);
        if (strcmp(taut_record_text(taut_record_get(lath, "name")), taut_curve_name(line->space)) ==
            0) {
            return lath;
        }
    }
    return NULL;
}

double taut_net_lath_off(const taut_net_lines *lines, const taut_net_line *line)
{
    const taut_record *lath = taut_net_lath_of(lines, line);
    const double length = taut_record_number(taut_record_get(lath, "length"));
    return lath != NULL ? fabs(length - line->length) / line->length : (double)NAN;
}

int taut_net_lath_is_asked(const taut_record *lath, const taut_trace_laths *laths)
{
    static const char *const strips[] = {"standing", "plank", "developable", "envelope"};
    const taut_record *width = taut_record_get(lath, "width");
    const taut_record *thickness = taut_record_get(lath, "thickness");
    return strcmp(taut_record_text(taut_record_get(lath, "strip")), strips[laths->strip]) == 0 &&
           (width != NULL ? taut_record_number(width) : 0) == laths->width &&
           (thickness != NULL ? taut_record_number(thickness) : 0) == laths->thickness;
}
