#include "construct/asymptotic/end_weights.h"

#include "core/elementary/elementary.h"
#include "core/fail.h"

#include <math.h>
#include <stdio.h>

static const double match = 1e-12; /* relative */
/* The curves as messages list them. */
static const int order[4] = {TAUT_ASYMPTOTIC_V0, TAUT_ASYMPTOTIC_V1, TAUT_ASYMPTOTIC_U0,
                             TAUT_ASYMPTOTIC_U1};

double taut_corner_end_weight(const taut_asymptotic_corners *corners, int edge, int end)
{
    return corners->edges[edge].weights[end == 0 ? 0 : corners->degree == 3 ? 3 : 1];
}

/* The first corner where the ends differ, or -1; nearest[edge][end] is what they should be. */
static int differ_at(double ends[4][2], double nearest[4][2])
{
    int at = -1;
    for (int c = 3; c >= 0; c--) {
        const taut_quad_meeting *const m = taut_quad_corner[c];
        const double w0 = ends[m[0].edge][m[0].end], w1 = ends[m[1].edge][m[1].end];
        const int same = fabs(w0 - w1) <= match * fmax(w0, w1);
        at = same ? at : c;
        for (int k = 0; k < 2; k++) {
            const double own = ends[m[k].edge][m[k].end];
            nearest[m[k].edge][m[k].end] = same ? own : sqrt(w0) * sqrt(w1);
        }
    }
    return at;
}

static taut_status fail_at(int c, const char *where, double ends[4][2], const char *text,
                           taut_error *error)
{
    const taut_quad_meeting *const m = taut_quad_corner[c];
    const double w0 = ends[m[0].edge][m[0].end], w1 = ends[m[1].edge][m[1].end];
    return taut_fail(error, TAUT_NO_SOLUTION, "end-weights", where, w0 / w1, 1.0,
                     "the end weights of %s and %s differ at corner %s (%.6g and %.6g): %s",
                     taut_asymptotic_edge_name(m[0].edge), taut_asymptotic_edge_name(m[1].edge),
                     taut_asymptotic_corner_name(c), w0, w1, text);
}

taut_status taut_end_weights_of_data(const taut_asymptotic_corners *corners, taut_error *error)
{
    double ends[4][2], nearest[4][2];
    char text[560] = "nearest weights:";
    size_t used = 16;
    int c = 0;
    for (int e = 0; e < 4; e++) {
        for (int k = 0; k < 2; k++) {
            ends[e][k] = taut_corner_end_weight(corners, e, k);
        }
    }
    c = differ_at(ends, nearest);
    for (int k = 0; k < 4 && c >= 0 && used < sizeof text; k++) {
        const int e = order[k];
        const double *const inner = corners->edges[e].weights + 1;
        char between[64] = ",";
        if (corners->degree == 3) {
            (void)snprintf(between, sizeof between, ",%.17g,%.17g,", inner[0], inner[1]);
        }
        used +=
            (size_t)snprintf(text + used, sizeof text - used, " %s [%.17g%s%.17g]",
                             taut_asymptotic_edge_name(e), nearest[e][0], between, nearest[e][1]);
    }
    return c < 0 ? TAUT_OK : fail_at(c, "/edges", ends, text, error);
}

taut_status taut_end_weights_of_curves(const taut_quad *quad, const int degrees[4],
                                       taut_error *error)
{
    double ends[4][2], nearest[4][2];
    char text[560] = "multiply weight j of a curve by c q^j, which leaves it unchanged; nearest:";
    size_t used = 74;
    int c = 0;
    for (int e = 0; e < 4; e++) {
        for (int k = 0; k < 2; k++) {
            ends[e][k] = taut_quad_weight(quad, e, k, 0);
        }
    }
    c = differ_at(ends, nearest);
    for (int k = 0; k < 4 && c >= 0 && used < sizeof text; k++) {
        const int e = order[k];
        const double first = nearest[e][0] / ends[e][0], last = nearest[e][1] / ends[e][1];
        used += (size_t)snprintf(text + used, sizeof text - used, "%s %s c = %.17g, q = %.17g",
                                 k > 0 ? ";" : "", taut_asymptotic_edge_name(e), first,
                                 taut_exp((taut_log(last) - taut_log(first)) / degrees[e]));
    }
    return c < 0 ? TAUT_OK : fail_at(c, "/curves", ends, text, error);
}
