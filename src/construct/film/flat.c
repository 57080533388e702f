#include "construct/film/flat.h"

#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { BISECTIONS = 60 };
static const double flat_share = 1e-12; /* of the size: a corner in the plane of the others */
static const double touch_share = 1e-9; /* of the size: nearer to their corner sides may touch */
static const double turn_least = 1e-12; /* radians: below it a side runs back into the last */
static const double factor_most = 1e5;  /* of all forces */

/* One side, run with the sail on its left. */
typedef struct side {
    double a[2], b[2]; /* its ends */
    double chord;
    double radius; /* of the arc, over size 1; 0: straight */
    int edge;
} side;

typedef struct polygon {
    side sides[4];
    double factor; /* of all radii */
} polygon;

/* ---- in the plane ---- */

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
static void find_centre(const polygon *p, const side *s, double centre[2])
{
    const double half = 0.5 * s->chord, r = p->factor * s->radius;
    const double away = -sqrt(fmax(0, (r - half) * (r + half)));
    const double left[2] = {-(s->b[1] - s->a[1]) / s->chord, (s->b[0] - s->a[0]) / s->chord};
    for (int c = 0; c < 2; c++) {
        centre[c] = 0.5 * (s->a[c] + s->b[c]) + away * left[c];
    }
}

/* The angle between chord and arc at its ends. */
static double arc_angle(const polygon *p, const side *s)
{
    return s->radius > 0 ? taut_asin(fmin(1, s->chord / (2 * p->factor * s->radius))) : 0;
}

/* The angle inside at the corner from side s to the next, in (0, 2 pi). */
static double corner_angle(const side *s, const side *next)
{
    double in[2], out[2];
    minus2(s->a, s->b, in); /* backwards along s */
    minus2(next->b, next->a, out);
    const double angle = taut_atan2(cross2(out, in), out[0] * in[0] + out[1] * in[1]);
    return fabs(angle) <= turn_least ? 0 : angle > 0 ? angle : angle + 2 * TAUT_PI;
}

/* Is x, a point of the side's line or circle, on the side itself, its ends left out by `slack`? */
static int is_on(const side *s, const double x[2], double slack)
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
static int line_line(const side *s, const side *o, double x[2][2])
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

static int line_circle(const polygon *p, const side *line, const side *arc, double x[2][2])
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

static int circle_circle(const polygon *p, const side *s, const side *o, double x[2][2])
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

/* Opposite sides: anywhere. */
static int opposite_meet(const polygon *p, const side *s, const side *o)
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
static int neighbours_meet(const polygon *p, const side *s, const side *next)
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
        const side *line = s->radius > 0 ? next : s;
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

/* Is there a sail with all forces `factor` times what they are? */
static int exists(polygon *p, double factor)
{
    p->factor = factor;
    for (int k = 0; k < 4; k++) {
        const side *s = &p->sides[k];
        if (s->radius > 0 && s->chord > 2 * factor * s->radius) {
            return 0;
        }
    }
    for (int k = 0; k < 4; k++) {
        const side *s = &p->sides[k], *next = &p->sides[(k + 1) % 4];
        if (!(corner_angle(s, next) > arc_angle(p, s) + arc_angle(p, next))) {
            return 0;
        }
    }
    for (int k = 0; k < 4; k++) {
        if (neighbours_meet(p, &p->sides[k], &p->sides[(k + 1) % 4])) {
            return 0;
        }
    }
    return !opposite_meet(p, &p->sides[0], &p->sides[2]) &&
           !opposite_meet(p, &p->sides[1], &p->sides[3]);
}

/* ---- from the net ---- */

/* The largest of the four triangles' normals. */
static void find_normal(const double *const corner[4], double n[3])
{
    memset(n, 0, 3 * sizeof(double));
    for (int k = 0; k < 4; k++) {
        double a[3], b[3], normal[3];
        taut_difference(corner[(k + 1) % 4], corner[k], a);
        taut_difference(corner[(k + 2) % 4], corner[k], b);
        taut_cross(a, b, normal);
        if (taut_dot(normal, normal) > taut_dot(n, n)) {
            memcpy(n, normal, sizeof normal);
        }
    }
}

/* The corners in their own plane, over size 1, in the order in which the sides run round the sail;
 * 0 where they do not lie in one. */
static int lay_flat(const taut_film_space *space, double flat[4][2])
{
    static const int round[4] = {0, 1, 3, 2}; /* u0v0, u1v0, u1v1, u0v1 */
    const size_t last_u = (size_t)(space->nu - 1) * (size_t)space->nv,
                 last_v = (size_t)space->nv - 1;
    const double *corner[4] = {space->start, space->start + 3 * last_u, space->start + 3 * last_v,
                               space->start + 3 * (last_u + last_v)};
    double n[3], e[2][3];

    find_normal(corner, n);
    const double size = taut_norm(n);
    taut_difference(corner[1], corner[0], e[0]);
    const double side_length = taut_norm(e[0]);
    if (!(size > flat_share) || !(side_length > 0)) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        n[c] /= size;
        e[0][c] /= side_length;
    }
    taut_cross(n, e[0], e[1]);
    for (int k = 0; k < 4; k++) {
        double x[3];
        taut_difference(corner[round[k]], corner[0], x);
        if (fabs(taut_dot(x, n)) > flat_share) {
            return 0;
        }
        flat[k][0] = taut_dot(x, e[0]);
        flat[k][1] = taut_dot(x, e[1]);
    }
    return 1;
}

static int has_curves(const taut_film_problem *problem)
{
    return problem->edges[0].curve != NULL || problem->edges[1].curve != NULL ||
           problem->edges[2].curve != NULL || problem->edges[3].curve != NULL;
}

/* Are the arcs of all cables known? */
static int has_arcs(const taut_film_space *space)
{
    for (int e = 0; e < 4; e++) {
        if (space->ratios[e] > 0 && !space->is_arc[e]) {
            return 0;
        }
    }
    return 1;
}

static void make_polygon(const taut_film_space *space, double flat[4][2], polygon *p)
{
    static const int edge_of[2][4] = {{2, 1, 3, 0}, {0, 3, 1, 2}}; /* as they run round */
    double area = 0;

    for (int k = 0; k < 4; k++) {
        area += 0.5 * cross2(flat[k], flat[(k + 1) % 4]);
    }
    for (int k = 0; k < 4; k++) {
        /* the other way round where the sail lies on the right */
        const int turned = area < 0, from = turned ? (4 - k) % 4 : k;
        const int to = turned ? (from + 3) % 4 : (from + 1) % 4;
        side *s = &p->sides[k];
        double d[2];
        memcpy(s->a, flat[from], sizeof s->a);
        memcpy(s->b, flat[to], sizeof s->b);
        minus2(s->b, s->a, d);
        s->chord = sqrt(d[0] * d[0] + d[1] * d[1]);
        s->edge = edge_of[turned][k];
        s->radius = space->ratios[s->edge];
    }
}

/* Do the chords bound no polygon? */
static int is_crossed(const polygon *p)
{
    polygon chords = *p;
    for (int k = 0; k < 4; k++) {
        chords.sides[k].radius = 0;
    }
    return !exists(&chords, 1);
}

/* The least factor of all forces with which there is a sail. */
static double least_factor(polygon *p)
{
    double no = 1, yes = factor_most;
    for (int k = 0; k < BISECTIONS && yes - no > 1e-15 * no; k++) {
        const double middle = sqrt(no) * sqrt(yes);
        if (exists(p, middle)) {
            yes = middle;
        } else {
            no = middle;
        }
    }
    return yes;
}

static taut_status refuse_weak(const taut_film_space *space, polygon *p, taut_error *error)
{
    const double factor = least_factor(p);
    char where[32];
    int e = -1;

    for (int k = 0; e < 0 && k < 4; k++) {
        e = space->ratios[k] > 0 ? k : -1;
    }
    const double force = taut_film_force(space, e, 1);
    snprintf(where, sizeof where, "/edges/%s/cable", taut_film_edge_names[e]);
    return taut_fail(error, TAUT_NO_SOLUTION, "cable-too-weak", where, force, factor * force,
                     "the cables are too weak for this flat sail of tension %g: with these forces "
                     "their arcs touch or do not span their chords; expected more than %.15g times "
                     "the forces (%.15g for edge %s), or so much less tension",
                     taut_film_tension(space->problem), factor, factor * force,
                     taut_film_edge_names[e]);
}

taut_status taut_film_flat_check(const taut_film_space *space, taut_error *error)
{
    double flat[4][2];
    polygon p;

    if (space->leader != NULL || taut_film_has_density(space->problem) ||
        has_curves(space->problem) || !has_arcs(space) || !lay_flat(space, flat)) {
        return TAUT_OK;
    }
    make_polygon(space, flat, &p);
    if (is_crossed(&p)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "crossed", "/corners", taut_none, taut_none,
                         "the corners u0v0, u1v0, u1v1, u0v1, in this order, bound no polygon: "
                         "its sides cross or run back into themselves; exchange two of them");
    }
    return exists(&p, 1) ? TAUT_OK : refuse_weak(space, &p, error);
}
