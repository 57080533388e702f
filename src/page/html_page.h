/* html_page.h -- what a page shows: surfaces and curves sampled, the box around them, the scales of
 * the colours and the view. */
#ifndef TAUT_PAGE_HTML_PAGE_H
#define TAUT_PAGE_HTML_PAGE_H

#include "core/arena.h"
#include "draw/camera.h"
#include "taut/model.h"
#include "taut/surface.h"
#include "taut/write.h"

#include <stdint.h>

/* ---- of a surface, in few bytes (html_sample.c) ----
 *
 * A grid of vertices over the parameters, in each knot span from end to end, so that at a knot two
 * lines lie together, each with the curvature of its side. All is stored in 16 bits:
 *     points   32767 (x - centre) / half                    of the box of all that is shown
 *     normals  octahedral: (a, b) = n / (|nx|+|ny|+|nz|), folded over where nz < 0, times 32767
 *     values   32766 v / limit, 32767 and -32767 beyond the scale, -32768 where there is none
 */

enum {
    TAUT_PAGE_H,
    TAUT_PAGE_K,
    TAUT_PAGE_I,
    TAUT_PAGE_GAP,
    TAUT_PAGE_STRAIN,
    TAUT_PAGE_WARP,
    TAUT_PAGE_WEFT,
    TAUT_PAGE_FIELDS
};

/* Parameters of the lines in one direction. */
typedef struct taut_page_lines {
    int count;
    double *at;             /* [count] */
    unsigned char *is_knot; /* [count]: a break, to be drawn as a knot line */
    int skipped;            /* knots without a line of their own */
} taut_page_lines;

typedef struct taut_page_surface {
    const taut_surface *surface;
    taut_page_lines u, v;
    double *points;                   /* [u.count][v.count][3] */
    double *normals;                  /* likewise; NaN where there is none */
    double *fields[TAUT_PAGE_FIELDS]; /* [u.count][v.count] */
    int has_gap;                      /* a witness tells the gap (measure/dual/density.h) */
    int has_stress;                   /* of threads (measure/film/stress.h) */
    double *mounted,
        *mounted_normals; /* of a flat piece of cloth, where its places are on the surface; or NULL, and there is no strain */
    int every[2]; /* every so many points of the net are kept, along u and v */
} taut_page_surface;

/* model: that it is in: where details hold a witness, the gap is among the fields; of a cutting pattern, the strain of its pieces; of a film of force
 * densities, the stress along both.
 * About `vertices` vertices, or, where divide is above 0, so many cells a knot span but no more
 * vertices than that; and at most `net` points of the net. */
taut_status taut_page_sample(const taut_surface *surface, const taut_model *model, int vertices,
                             int divide, int net, int threads, taut_arena *arena,
                             taut_page_surface *page);

/* How many points are kept of `count`, every so many and the last; and which is the i-th. */
int taut_page_kept(int count, int every);
int taut_page_kept_at(int count, int every, int i);

int16_t taut_page_value(double value, double limit);
void taut_page_normal(const double normal[3], int16_t packed[2]);
void taut_page_point(const taut_camera *box, const double point[3], int16_t packed[3]);

/* ---- of a model (html_page.c) ---- */

/* Pieces a curve is drawn in at the least, and points that are kept of its polygon. */
enum { TAUT_PAGE_ALONG = 96, TAUT_PAGE_NODES = 4000 };

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
    int sign[TAUT_PAGE_FIELDS]; /* of all values; 0: both (mesh/colour.h) */
    double view[2];
} taut_page_model;

/* Fills all but model, options and arena, which are given. TAUT_BAD_ARGUMENT: nothing is finite. */
taut_status taut_page_prepare(taut_page_model *p, taut_error *error);

/* ---- the JSON that a page holds: all numbers and names it shows (html_data.c) ---- */

/* *text is the caller's, to be freed by taut_free. Members: title, unit, view, frames, box, map
 * (colours of the scale), limits, surfaces, curves, certificate, details, dropped (what is not
 * shown, in sentences). */
taut_status taut_html_data(const taut_model *model, const taut_write_options *options, char **text,
                           size_t *length, taut_error *error);

#endif /* TAUT_PAGE_HTML_PAGE_H */
