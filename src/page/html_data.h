/* html_data.h -- the JSON that a page holds: all numbers and names it shows. */
#ifndef TAUT_PAGE_HTML_DATA_H
#define TAUT_PAGE_HTML_DATA_H

#include "taut/model.h"
#include "taut/write.h"

/* *text is the caller's, to be freed by taut_free. Members: title, unit, view, frames, box, map
 * (colours of the scale), limits, surfaces, curves, certificate, details, dropped (what is not
 * shown, in sentences). */
taut_status taut_html_data(const taut_model *model, const taut_write_options *options, char **text,
                           size_t *length, taut_error *error);

#endif /* TAUT_PAGE_HTML_DATA_H */
