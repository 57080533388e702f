/* closed.c -- whether four given curves close, and which of them run the wrong way if they do not.
 */
#include "construct/asymptotic/quad.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

/* How far the two edges at corner c are apart, with the edges of the set `turned` taken from their
 * other ends: bit e for edge e. */
static double gap_at(const taut_quad *quad, int c, int turned)
{
    const double *at[2];
    for (int k = 0; k < 2; k++) {
        const taut_quad_meeting *const m = &taut_quad_corner[c][k];
        at[k] = taut_quad_point(quad, m->edge, m->end ^ (turned >> m->edge & 1), 0);
    }
    return taut_distance(at[0], at[1]);
}

static int is_closed(const taut_quad *quad, int turned, double most)
{
    for (int c = 0; c < 4; c++) {
        if (!(gap_at(quad, c, turned) <= most)) {
            return 0;
        }
    }
    return 1;
}

static int size_of(int set)
{
    return (set & 1) + (set >> 1 & 1) + (set >> 2 & 1) + (set >> 3 & 1);
}

/* "; all four close with u0 and v1 reversed: ..." for the fewest such curves; or nothing. */
static void turned_text(const taut_quad *quad, double most, char text[160])
{
    int best = 0;
    text[0] = '\0';
    for (int turned = 1; turned < 16; turned++) {
        if (is_closed(quad, turned, most) && (best == 0 || size_of(turned) < size_of(best))) {
            best = turned;
        }
    }
    for (int e = 0, left = size_of(best); e < 4; e++) {
        if (best >> e & 1) {
            left--;
            (void)strcat(text, text[0] == '\0' ? "; all four close with "
                               : left > 0      ? ", "
                                               : " and ");
            (void)strcat(text, taut_asymptotic_edge_name(e));
        }
    }
    if (best != 0) {
        (void)strcat(text, " reversed: control points and weights in the opposite order");
    }
}

taut_status taut_quad_check_closed(const taut_quad *quad, taut_error *error)
{
    const double most = 1e-12 * taut_quad_size(quad) + 4 * taut_quad_rounding(quad);
    for (int c = 0; c < 4; c++) {
        const taut_quad_meeting *const m = taut_quad_corner[c];
        const char *const first = taut_asymptotic_edge_name(m[0].edge);
        const char *const second = taut_asymptotic_edge_name(m[1].edge);
        const double gap = gap_at(quad, c, 0);
        if (!(gap <= most)) {
            char text[160];
            turned_text(quad, most, text);
            return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/curves", gap, most,
                             "curves %s and %s do not meet at corner %s: the gap is %.3g%s", first,
                             second, taut_asymptotic_corner_name(c), gap, text);
        }
    }
    return TAUT_OK;
}
