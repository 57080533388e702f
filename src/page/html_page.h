/* html_page.h -- what a page shows: surfaces and curves sampled, the box around them, the scales of
 * the colours and the view. */
#ifndef TAUT_PAGE_HTML_PAGE_H
#define TAUT_PAGE_HTML_PAGE_H

#include "core/arena.h"
#include "draw/camera.h"
#include "page/html_sample.h"
#include "taut/model.h"
#include "taut/write.h"

/* Pieces a curve is drawn in at the least, and points that are kept of its polygon. */
enum { TAUT_PAGE_ALONG = 96 };

typedef struct taut_page_curve {
    const taut_curve *curve;
    size_t count;
    double *points; /* [count][3] along it */
} taut_page_curve;

typedef struct taut_page_model {
    const taut_model *model;
    const taut_write_options *options;
    taut_arena *arena;
    int count, left_out, curve_count, far_nets;
    taut_page_surface *surfaces;
    taut_page_curve *curves;
    taut_camera core; /* the box of surfaces and curves: nets far beyond are left out */
    taut_camera box;
    double limits[TAUT_PAGE_FIELDS];
    int cut[TAUT_PAGE_FIELDS];
    double view[2];
} taut_page_model;

/* Fills all but model, options and arena, which are given. TAUT_BAD_ARGUMENT: nothing is finite. */
taut_status taut_page_prepare(taut_page_model *p, taut_error *error);

#endif /* TAUT_PAGE_HTML_PAGE_H */
