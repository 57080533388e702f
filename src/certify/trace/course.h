/* course.h -- a whole curve of a net as it bends and twists, and what is cut for it: sums from its beginning on.
 *
 *     cut      int 1 ds, of strips that twist int mu ds, mu the mean over the width of sqrt(1 + h^2 tau^2)
 *     theta    int k ds, k what the pattern bends by; x, y int (cos theta, sin theta) d cut
 *
 * Of geodesics k_g is 0, as their own claim bounds it. By Gauss's rule on each span, of the values at its nodes (certify/trace/bends.h).
 */
#ifndef TAUT_CERTIFY_TRACE_COURSE_H
#define TAUT_CERTIFY_TRACE_COURSE_H

#include "certify/trace/bends.h"

enum { TAUT_NET_K_N, TAUT_NET_K_G, TAUT_NET_TAU, TAUT_NET_BENDS };

/* What a lath is, lengths times 2^-unit. */
typedef struct taut_net_cut {
    int is_cut; /* is there a lath at all? */
    taut_trace_strip strip;
    double width, thickness;
    int weak;       /* what it bends by: TAUT_NET_K_N, _K_G */
    int flat;       /* what its pattern bends by; -1: nothing, on this net */
    int only_bends; /* about rulings, and does not stretch */
    int is_mean;    /* cut as long as the mean */
} taut_net_cut;

typedef struct taut_net_bent {
    double from, to; /* parameters */
    double half;     /* half of its length, times 2^-unit */
    double bend[TAUT_NET_BENDS][TAUT_NET_NODES];
    double more[TAUT_NET_NODES]; /* mu - 1 */
    double blur; /* what rounding of the surface may make of k_g, by the nodes' differences */
    double skew[TAUT_NET_NODES],
        slope[TAUT_NET_NODES]; /* of rulings along the axis, and its rate */
    double cut, x, y, theta;   /* where it begins */
} taut_net_bent;

typedef struct taut_net_course {
    const taut_net_rule *rule;
    taut_net_cut cut;
    int count;
    taut_net_bent *spans; /* [count + 1]: the last one is the end */
    double length, stretch, edge;
} taut_net_course;

/* A place of it. */
typedef struct taut_net_course_at {
    double bend[TAUT_NET_BENDS], blur, skew, slope;
    double cut, x, y, theta;
} taut_net_course_at;

/* In the arena of the cells. 0 where a place of the line has no tangent plane, or there is no memory for it. */
int taut_net_course_new(taut_net_cells *cells, const taut_net_lines *lines,
                        const taut_net_line *line, const taut_net_rule *rule,
                        const taut_net_cut *cut, int unit, taut_net_course *course);

/* At a parameter within its range. At a break that is seen from the left, and by _beyond from the right: surfaces may
 * bend otherwise there. */
taut_net_course_at taut_net_course_see(const taut_net_course *course, double t);
taut_net_course_at taut_net_course_beyond(const taut_net_course *course, double t);

/* k_g there once more, by nodes within this part of the span on both sides, for where it changes fast; 0 where they are
 * not known. */
int taut_net_course_closer(taut_net_cells *cells, taut_trace_net net, const taut_net_line *line,
                           const taut_net_course *course, double t, int beyond, double part,
                           double *k_g);

/* The integral of |bend| over the whole; *changes: does it change its sign within a span? */
double taut_net_course_sum(const taut_net_course *course, int bend, int *changes);

/* What a bend makes of a place, not negative. */
typedef double taut_net_measure(const taut_net_course *course, const taut_net_course_at *at);

/* The largest measure from parameter `from` to `to`, and of the nodes alone where `fine` is 0. */
double taut_net_course_most(const taut_net_course *course, taut_net_measure *measure, double from,
                            double to, int fine);

#endif /* TAUT_CERTIFY_TRACE_COURSE_H */
