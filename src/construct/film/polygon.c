#include "construct/film/polygon.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"

#include <math.h>
#include <string.h>

enum { BISECTIONS = 60 };
static const double touch_share = 1e-9; /* of the size: nearer to their corner sides may touch */
static const double turn_least = 1e-12; /* radians: below it a side runs back into the last */
static const double factor_most = 1e5;  /* of all forces */

static double cross2(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

static void minus2(const double a[2], const double b[2], double d[2])
{
    d[0] = a[0] - b[0];
    d[1] = a[1] - b[1];
}

/* The middle of the arc's circle: beyond the middle of the chord, on the right, since the arc bows
 * to the left. */
static void find_centre(const taut_film_polygon *p, const taut_film_arc *s, double centre[2])
{
    const double half = 0.5 * s->chord, r = p->factor * s->radius;
    const double away = -sqrt(fmax(0, (r - half) * (r + half)));
    const double left[2] = {-(s->b[1] - s->a[1]) / s->chord, (s->b[0] - s->a[0]) / s->chord};
    for (int c = 0; c < 2; c++) {
        centre[c] = 0.5 * (s->a[c] + s->b[c]) + away * left[c];
    }
}

/* The angle between chord and arc at its ends. */
static double arc_angle(const taut_film_polygon *p, const taut_film_arc *s)
{
    return s->radius > 0 ? taut_asin(fmin(1, s->chord / (2 * p->factor * s->radius))) : 0;
}

/* The angle inside at the corner from side s to the next, in (0, 2 pi). */
static double corner_angle(const taut_film_arc *s, const taut_film_arc *next)
{
    double in[2], out[2];
    minus2(s->a, s->b, in); /* backwards along s */
    minus2(next->b, next->a, out);
    const double angle = taut_atan2(cross2(out, in), out[0] * in[0] + out[1] * in[1]);
    return fabs(angle) <= turn_least ? 0 : angle > 0 ? angle : angle + 2 * TAUT_PI;
}

/* Is x, a point of the side's line or circle, on the side itself, its ends left out by `slack`? */
static int is_on(const taut_film_arc *s, const double x[2], double slack)
{
    double from[2], along[2];
    minus2(x, s->a, from);
    minus2(s->b, s->a, along);
    const double t = (from[0] * along[0] + from[1] * along[1]) / (s->chord * s->chord);
    const double height = cross2(along, from) / s->chord;

    /* an arc of at most half its circle lies on the left of its chord */
    return (s->radius == 0 || height >= -slack) && t * s->chord >= slack &&
           (1 - t) * s->chord >= slack;
}

/* The points where the lines or circles of two sides meet: at most 2. */
static int line_line(const taut_film_arc *s, const taut_film_arc *o, double x[2][2])
{
    double d[2], e[2], w[2];
    minus2(s->b, s->a, d);
    minus2(o->b, o->a, e);
    minus2(o->a, s->a, w);
    const double det = cross2(d, e);
    if (det == 0) {
        return 0;
    }
    const double t = cross2(w, e) / det;
    x[0][0] = s->a[0] + t * d[0];
    x[0][1] = s->a[1] + t * d[1];
    return 1;
}

static int line_circle(const taut_film_polygon *p, const taut_film_arc *line,
                       const taut_film_arc *arc, double x[2][2])
{
    double centre[2], d[2], w[2];
    find_centre(p, arc, centre);
    minus2(line->b, line->a, d);
    minus2(centre, line->a, w);
    const double r = p->factor * arc->radius;
    const double t = (w[0] * d[0] + w[1] * d[1]) / (line->chord * line->chord);
    const double h = cross2(d, w) / line->chord, under = (r - h) * (r + h);
    if (under < 0) {
        return 0;
    }
    const double step = sqrt(under) / line->chord;
    for (int k = 0; k < 2; k++) {
        const double at = t + (k == 0 ? -step : step);
        x[k][0] = line->a[0] + at * d[0];
        x[k][1] = line->a[1] + at * d[1];
    }
    return 2;
}

static int circle_circle(const taut_film_polygon *p, const taut_film_arc *s, const taut_film_arc *o,
                         double x[2][2])
{
    double c[2], e[2], d[2];
    find_centre(p, s, c);
    find_centre(p, o, e);
    minus2(e, c, d);
    const double r = p->factor * s->radius, q = p->factor * o->radius;
    const double far = sqrt(d[0] * d[0] + d[1] * d[1]);
    if (far == 0) {
        return 0;
    }
    const double along = 0.5 * (far + (r - q) * (r + q) / far);
    const double under = (r - along) * (r + along);
    if (under < 0) {
        return 0;
    }
    const double up = sqrt(under);
    for (int k = 0; k < 2; k++) {
        const double side_of = k == 0 ? up : -up;
        x[k][0] = c[0] + (along * d[0] - side_of * d[1]) / far;
        x[k][1] = c[1] + (along * d[1] + side_of * d[0]) / far;
    }
    return 2;
}

/* Sides without a common corner: anywhere. */
static int opposite_meet(const taut_film_polygon *p, const taut_film_arc *s, const taut_film_arc *o)
{
    double x[2][2];
    const int count = s->radius > 0 && o->radius > 0 ? circle_circle(p, s, o, x)
                      : s->radius > 0                ? line_circle(p, o, s, x)
                      : o->radius > 0                ? line_circle(p, s, o, x)
                                                     : line_line(s, o, x);
    for (int n = 0; n < count; n++) {
        if (is_on(s, x[n], 0) && is_on(o, x[n], 0)) {
            return 1;
        }
    }
    return 0;
}

/* A side and the next: in the second point where their circles meet, the mirror image of their
 * corner in the line of the centres; of a circle and a line, in the line's perpendicular through
 * the centre. */
static int neighbours_meet(const taut_film_polygon *p, const taut_film_arc *s,
                           const taut_film_arc *next)
{
    double c[2], along[2], w[2], x[2];
    if (s->radius == 0 && next->radius == 0) {
        return 0;
    }
    if (s->radius > 0 && next->radius > 0) {
        double e[2];
        find_centre(p, s, c);
        find_centre(p, next, e);
        minus2(e, c, along);
    } else {
        const taut_film_arc *line = s->radius > 0 ? next : s;
        double d[2];
        find_centre(p, s->radius > 0 ? s : next, c);
        minus2(line->b, line->a, d);
        along[0] = -d[1];
        along[1] = d[0];
    }
    minus2(s->b, c, w);
    const double square = along[0] * along[0] + along[1] * along[1];
    const double t = (w[0] * along[0] + w[1] * along[1]) / square;
    for (int k = 0; k < 2; k++) {
        x[k] = c[k] + 2 * t * along[k] - w[k];
    }
    return is_on(s, x, touch_share) && is_on(next, x, touch_share);
}

int taut_film_polygon_exists(taut_film_polygon *p, double factor)
{
    p->factor = factor;
    for (int k = 0; k < p->count; k++) {
        const taut_film_arc *s = &p->sides[k];
        if (s->radius > 0 && s->chord > 2 * factor * s->radius) {
            return 0;
        }
    }
    for (int k = 0; k < p->count; k++) {
        const taut_film_arc *s = &p->sides[k], *next = &p->sides[(k + 1) % p->count];
        if (!(corner_angle(s, next) > arc_angle(p, s) + arc_angle(p, next))) {
            return 0;
        }
    }
    for (int k = 0; k < p->count; k++) {
        if (neighbours_meet(p, &p->sides[k], &p->sides[(k + 1) % p->count])) {
            return 0;
        }
    }
    for (int k = 0; k < p->count; k++) {
        for (int other = k + 2; other < p->count && other - k < p->count - 1; other++) {
            if (opposite_meet(p, &p->sides[k], &p->sides[other])) {
                return 0;
            }
        }
    }
    return 1;
}

int taut_film_polygon_is_crossed(taut_film_polygon *p)
{
    for (int k = 0; k < p->count; k++) {
        p->sides[k].kept = p->sides[k].radius;
        p->sides[k].radius = 0;
    }
    const int is_one = taut_film_polygon_exists(p, 1);
    for (int k = 0; k < p->count; k++) {
        p->sides[k].radius = p->sides[k].kept;
    }
    return !is_one;
}

double taut_film_polygon_factor(taut_film_polygon *p)
{
    double no = 1, yes = factor_most;
    for (int k = 0; k < BISECTIONS && yes - no > 1e-15 * no; k++) {
        const double middle = sqrt(no) * sqrt(yes);
        if (taut_film_polygon_exists(p, middle)) {
            yes = middle;
        } else {
            no = middle;
        }
    }
    return yes;
}

void taut_film_arc_set(taut_film_arc *side, const double a[2], const double b[2], double radius)
{
    double d[2];
    memcpy(side->a, a, sizeof side->a);
    memcpy(side->b, b, sizeof side->b);
    minus2(side->b, side->a, d);
    side->chord = sqrt(d[0] * d[0] + d[1] * d[1]);
    side->radius = radius;
}
