#include "pattern/sheet/nest.h"

#include <math.h>

enum { STRIPS = 256 };
/* Widths and places that differ by less are the same. */
static const double same = 1e-9;

/* A shape one way round, from its lower left corner: in each strip the least and the largest x. */
typedef struct profile {
    int count; /* of strips */
    double left[STRIPS], right[STRIPS];
} profile;

static int strip_of(double y, double step, int count)
{
    const int k = (int)floor(y / step);
    return k < 0 ? 0 : k >= count ? count - 1 : k;
}

static void profile_of(const taut_nest_shape *shape, int is_turned, double step, double slack,
                       profile *p)
{
    const double sign = is_turned ? -1 : 1, *corner = is_turned ? shape->high : shape->low;
    const double wide = shape->high[1] - shape->low[1];

    p->count = (int)fmin(ceil(wide / step), STRIPS);
    p->count = p->count > 0 ? p->count : 1;
    for (int k = 0; k < p->count; k++) {
        p->left[k] = INFINITY;
        p->right[k] = -INFINITY;
    }
    for (size_t k = 0; k < shape->count; k++) {
        const double *a = shape->points[k], *b = shape->points[(k + 1) % shape->count];
        const double from[2] = {sign * (a[0] - corner[0]), sign * (a[1] - corner[1])};
        const double to[2] = {sign * (b[0] - corner[0]), sign * (b[1] - corner[1])};
        const int parts = 1 + (int)(2 * fabs(to[1] - from[1]) / step); /* less than a strip high */
        for (int i = 0; i < parts; i++) {
            double x[2], y[2];
            for (int end = 0; end < 2; end++) {
                const double share = (double)(i + end) / parts;
                x[end] = from[0] + share * (to[0] - from[0]);
                y[end] = from[1] + share * (to[1] - from[1]);
            }
            const int first = strip_of(fmin(y[0], y[1]) - slack, step, p->count);
            const int last = strip_of(fmax(y[0], y[1]) + slack, step, p->count);
            for (int s = first; s <= last; s++) {
                p->left[s] = fmin(p->left[s], fmin(x[0], x[1]) - slack);
                p->right[s] = fmax(p->right[s], fmax(x[0], x[1]) + slack);
            }
        }
    }
}

/* Left ends that keep a distance across of so many strips. */
static void widen(const profile *p, int by, double left[3 * STRIPS])
{
    for (int k = -by; k < p->count + by; k++) {
        double least = INFINITY;
        for (int i = k - by < 0 ? 0 : k - by; i <= k + by && i < p->count; i++) {
            least = fmin(least, p->left[i]);
        }
        left[k + by] = least;
    }
}

/* Where a profile that begins at strip `across` may begin along the roll, behind what is there. */
static double begin_of(const double *left, int count, int by, int across, const double *front,
                       double gap)
{
    double x = 0;
    for (int k = -by; k < count + by; k++) {
        if (across + k >= 0 && across + k < STRIPS) {
            x = fmax(x, front[across + k] + gap - left[k + by]);
        }
    }
    return x;
}

static int *order_of(taut_arena *arena, int count, const taut_nest_shape *shapes)
{
    int *order = taut_arena_take(arena, (size_t)count + 1, sizeof *order);
    for (int k = 0; order != NULL && k < count; k++) {
        const double wide = shapes[k].high[1] - shapes[k].low[1];
        int i = k;
        for (; i > 0; i--) { /* one width: but for rounding */
            const taut_nest_shape *before = &shapes[order[i - 1]];
            if (!(before->high[1] - before->low[1] < wide * (1 - same))) {
                break;
            }
            order[i] = order[i - 1];
        }
        order[i] = k;
    }
    return order;
}

taut_status taut_nest(taut_arena *arena, int count, const taut_nest_shape *shapes, double width,
                      double gap, double slack, int may_turn, taut_nest_place *places,
                      double *length)
{
    const double step = width / STRIPS;
    const int by = 1 + (int)fmin(ceil(gap / step), STRIPS - 1.0);
    profile *ways = taut_arena_take(arena, 2, sizeof *ways);
    const int *order = order_of(arena, count, shapes);
    double front[STRIPS], left[3 * STRIPS];

    *length = 0;
    if (ways == NULL || order == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < STRIPS; k++) {
        front[k] = -INFINITY;
    }
    for (int k = 0; k < count; k++) {
        const taut_nest_shape *shape = &shapes[order[k]];
        const double long_ = shape->high[0] - shape->low[0];
        const int most = (int)floor((width - (shape->high[1] - shape->low[1])) / step);
        double best = INFINITY;
        int across = 0, turned = 0;
        for (int way = 0; way < 1 + (may_turn != 0); way++) {
            profile_of(shape, way, step, slack, &ways[way]);
            widen(&ways[way], by, left);
            for (int at = 0; at <= most; at++) {
                const double x = begin_of(left, ways[way].count, by, at, front, gap);
                if (x < best * (1 - same)) {
                    best = x;
                    across = at;
                    turned = way;
                }
            }
        }
        if (!(best < INFINITY)) {
            *length = INFINITY;
            return TAUT_OK;
        }
        for (int i = 0; i < ways[turned].count && across + i < STRIPS; i++) {
            front[across + i] = fmax(front[across + i], best + ways[turned].right[i]);
        }
        const double corner[2] = {best, across * step};
        for (int d = 0; d < 2; d++) {
            places[order[k]].at[d] = corner[d] + (turned ? shape->high[d] : -shape->low[d]);
        }
        places[order[k]].is_turned = turned;
        *length = fmax(*length, best + long_);
    }
    return TAUT_OK;
}
