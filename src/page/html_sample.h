/* html_sample.h -- what a page shows of a surface, in few bytes.
 *
 * A grid of vertices over the parameters, in each knot span from end to end, so that at a knot two
 * lines lie together, each with the curvature of its side. All is stored in 16 bits:
 *     points   32767 (x - centre) / half                    of the box of all that is shown
 *     normals  octahedral: (a, b) = n / (|nx|+|ny|+|nz|), folded over where nz < 0, times 32767
 *     values   32766 v / limit, 32767 and -32767 beyond the scale, -32768 where there is none
 */
#ifndef TAUT_PAGE_HTML_SAMPLE_H
#define TAUT_PAGE_HTML_SAMPLE_H

#include "core/arena.h"
#include "draw/camera.h"
#include "taut/surface.h"

#include <stdint.h>

enum { TAUT_PAGE_H, TAUT_PAGE_K, TAUT_PAGE_I, TAUT_PAGE_FIELDS };

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
    int every[2];                     /* every so many points of the net are kept, along u and v */
} taut_page_surface;

/* About `vertices` vertices, or, where divide is above 0, so many cells a knot span but no more
 * vertices than that; and at most `net` points of the net. */
taut_status taut_page_sample(const taut_surface *surface, int vertices, int divide, int net,
                             int threads, taut_arena *arena, taut_page_surface *page);

/* How many points are kept of `count`, every so many and the last; and which is the i-th. */
int taut_page_kept(int count, int every);
int taut_page_kept_at(int count, int every, int i);

int16_t taut_page_value(double value, double limit);
void taut_page_normal(const double normal[3], int16_t packed[2]);
void taut_page_point(const taut_camera *box, const double point[3], int16_t packed[3]);

#endif /* TAUT_PAGE_HTML_SAMPLE_H */
