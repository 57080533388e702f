/* film_curves_cut.c -- see film_curves_cut.h.
 *
 *     polygons to look at: the boundary
 *     while there are some: one of them
 *         a line: both parts are looked at in its place
 *         none, but an open corner: triangles about the centre; of the whole where they would be thin
 */
#include "io/problem/film_curves_cut.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { SIDES_ENOUGH = 6 };
static const double open_corner =
    155 * (TAUT_PI / 180); /* nets fold in corners that are not much wider */
static const double least_angle = 20 * (TAUT_PI / 180);
static const double tie = 1e-9; /* radians: of two lines as good as each other the first is taken */
static const double aside =
    0.5; /* the sine with which a corner that turns the other way must do it */

static const double thin =
    0.5; /* triangles with angles so much smaller than those of the whole are not made */

typedef struct shape {
    double corners[TAUT_FILM_CURVES_MAX][3], middles[TAUT_FILM_CURVES_MAX][3];
    double out[TAUT_FILM_CURVES_MAX][3],
        back[TAUT_FILM_CURVES_MAX][3]; /* along curve c from its beginning, from its end */
    double normal[3];                  /* of the area that the boundary goes round */
    int has_lines_outside;             /* a corner is wider than a straight angle */
} shape;

static void take_tangent(const taut_curve *curve, int end, double tangent[3])
{
    const taut_basis *t = taut_curve_t(curve);
    const double lo = taut_basis_lo(t), hi = taut_basis_hi(t);
    double x[2][3], far[3];

    (void)taut_curve_eval(curve, end == 0 ? lo : hi, 1, x[0]);
    (void)taut_curve_eval(curve, 0.5 * (lo + hi), 0, far);
    for (int k = 0; k < 3; k++) {
        tangent[k] = end == 0 ? x[1][k] : -x[1][k];
    }
    if (!(taut_norm(tangent) * (hi - lo) > 1e-6 * taut_distance(x[0], far))) {
        taut_difference(far, x[0], tangent); /* it begins at no speed */
    }
}

static double angle_between(const double a[3], const double b[3])
{
    double across[3];
    taut_cross(a, b, across);
    return taut_atan2(taut_norm(across), taut_dot(a, b));
}

/* From a to b about the normal, 0 to 2 pi. */
static double angle_about(const double normal[3], const double a[3], const double b[3])
{
    const double angle = taut_atan2(taut_det(a, b, normal) / taut_norm(normal), taut_dot(a, b));
    return angle < 0 ? angle + 2 * TAUT_PI : angle;
}

/* Along side k of a polygon from its corner k, and along the side before it. */
static void take_ways(const shape *s, const taut_film_polygon *p, int k, double ways[2][3])
{
    const int before = (k + p->count - 1) % p->count, after = (k + 1) % p->count;
    const double *here = s->corners[p->corners[k]];

    if (p->sides[k] >= 0) {
        memcpy(ways[0], s->out[p->sides[k]], sizeof ways[0]);
    } else {
        taut_difference(s->corners[p->corners[after]], here, ways[0]);
    }
    if (p->sides[before] >= 0) {
        memcpy(ways[1], s->back[p->sides[before]], sizeof ways[1]);
    } else {
        taut_difference(s->corners[p->corners[before]], here, ways[1]);
    }
}

static double corner_angle(const shape *s, const double ways[2][3])
{
    double across[3];
    const double angle = angle_between(ways[0], ways[1]);

    taut_cross(ways[0], ways[1], across);
    return taut_dot(across, s->normal) < -aside * taut_norm(across) * taut_norm(s->normal)
               ? 2 * TAUT_PI - angle
               : angle;
}

/* The smallest angle of a line to corner `to` with the sides at corner k. */
static double angle_left(const shape *s, const taut_film_polygon *p, int k, int to)
{
    double ways[2][3], line[3];

    take_ways(s, p, k, ways);
    taut_difference(s->corners[p->corners[to]], s->corners[p->corners[k]], line);
    const double angle = corner_angle(s, (const double(*)[3])ways);
    double one = angle_between(ways[0], line), other = angle_between(ways[1], line);
    if (angle > TAUT_PI) {
        one = angle_about(s->normal, ways[0], line);
        other = angle - one;
    }
    return fmin(one, other) - fmax(0, one + other - angle);
}

static int is_left(const shape *s, const double a[3], const double b[3], const double c[3])
{
    double ab[3], ac[3];
    taut_difference(b, a, ab);
    taut_difference(c, a, ac);
    return taut_det(ab, ac, s->normal) > 0;
}

static int are_crossing(const shape *s, const double a[3], const double b[3], const double c[3],
                        const double d[3])
{
    return is_left(s, a, b, c) != is_left(s, a, b, d) && is_left(s, c, d, a) != is_left(s, c, d, b);
}

/* Seen along the normal, does the line from corner i to corner j cross the boundary? */
static int leaves(const shape *s, const taut_film_polygon *p, int i, int j)
{
    const double *a = s->corners[p->corners[i]], *b = s->corners[p->corners[j]];

    for (int k = 0; s->has_lines_outside && k < p->count; k++) {
        const int next = (k + 1) % p->count;
        const double *c = s->corners[p->corners[k]], *d = s->corners[p->corners[next]];
        if (p->sides[k] < 0) {
            if (k != i && k != j && next != i && next != j && are_crossing(s, a, b, c, d)) {
                return 1;
            }
            continue;
        }
        const double *m = s->middles[p->sides[k]];
        if ((k != i && k != j && are_crossing(s, a, b, c, m)) ||
            (next != i && next != j && are_crossing(s, a, b, m, d))) {
            return 1;
        }
    }
    return 0;
}

static int is_open(const shape *s, const taut_film_polygon *p, int k)
{
    double ways[2][3];
    take_ways(s, p, k, ways);
    return corner_angle(s, (const double(*)[3])ways) > open_corner;
}

/* The line that cuts a polygon. 0: none is to. */
static int find_line(const shape *s, const taut_film_polygon *p, int ends[2])
{
    double best = least_angle;
    int found = 0;

    for (int i = 0; i < p->count; i++) {
        for (int j = i + 2; j < p->count - (i == 0); j++) {
            if (p->count <= SIDES_ENOUGH && !is_open(s, p, i) && !is_open(s, p, j)) {
                continue;
            }
            const double angle = fmin(angle_left(s, p, i, j), angle_left(s, p, j, i));
            if (angle > best + tie && !leaves(s, p, i, j)) {
                best = angle;
                ends[0] = i;
                ends[1] = j;
                found = 1;
            }
        }
    }
    return found;
}

/* The sides from one corner on to another, and a line back. */
static void take_part(const taut_film_polygon *whole, int from, int to, int line,
                      taut_film_polygon *part)
{
    part->count = 0;
    for (int k = from;; k = (k + 1) % whole->count) {
        part->corners[part->count] = whole->corners[k];
        part->sides[part->count++] = k == to ? -1 - line : whole->sides[k];
        if (k == to) {
            return;
        }
    }
}

static void add_polygon(taut_film_cut *cut, const taut_film_polygon *p)
{
    cut->polygons[cut->polygon_count++] = *p;
    cut->patch_count += p->count;
}

static void add_triangles(taut_film_cut *cut, const taut_film_polygon *p)
{
    const int first = cut->line_count;

    for (int k = 0; k < p->count; k++) {
        const int next = (k + 1) % p->count;
        add_polygon(cut, &(taut_film_polygon){
                             .count = 3,
                             .corners = {p->corners[k], p->corners[next], TAUT_FILM_CENTRE},
                             .sides = {p->sides[k], -1 - (first + next), -1 - (first + k)}});
        cut->from[cut->line_count++] = p->corners[k];
    }
}

/* The smallest angle of the triangles about the centre of a polygon with its sides; below 0 where one is turned over. */
static double angle_of_triangles(const shape *s, const taut_film_polygon *p)
{
    double centre[3] = {0}, normal[3] = {0}, least = TAUT_PI;
    double ways[TAUT_FILM_CURVES_MAX + 1][3], across[TAUT_FILM_CURVES_MAX][3];

    for (int k = 0; k < p->count; k++) {
        taut_add_scaled(1.0 / p->count, s->corners[p->corners[k]], centre);
    }
    for (int k = 0; k <= p->count; k++) {
        taut_difference(s->corners[p->corners[k % p->count]], centre, ways[k]);
    }
    for (int k = 0; k < p->count; k++) {
        taut_cross(ways[k], ways[k + 1], across[k]);
        taut_add_scaled(1, across[k], normal);
    }
    for (int k = 0; k < p->count; k++) {
        double side[3];
        taut_difference(ways[k + 1], ways[k], side);
        const double angle =
            fmin(angle_between(ways[k + 1], side), TAUT_PI - angle_between(ways[k], side));
        least = fmin(least, taut_dot(across[k], normal) > 0 ? angle : -angle);
    }
    return least;
}

static void take_shape(int count, const taut_curve *const *curves, shape *s)
{
    memset(s->normal, 0, sizeof s->normal);
    for (int c = 0; c < count; c++) {
        const taut_basis *t = taut_curve_t(curves[c]);
        (void)taut_curve_eval(curves[c], taut_basis_lo(t), 0, s->corners[c]);
        (void)taut_curve_eval(curves[c], 0.5 * (taut_basis_lo(t) + taut_basis_hi(t)), 0,
                              s->middles[c]);
        take_tangent(curves[c], 0, s->out[c]);
        take_tangent(curves[c], 1, s->back[c]);
    }
    for (int c = 0; c < count; c++) {
        const double *ends[2] = {s->corners[c], s->corners[(c + 1) % count]};
        for (int half = 0; half < 2; half++) {
            double a[3], b[3], across[3];
            taut_difference(half == 0 ? ends[0] : s->middles[c], s->corners[0], a);
            taut_difference(half == 0 ? s->middles[c] : ends[1], s->corners[0], b);
            taut_cross(a, b, across);
            taut_add_scaled(1, across, s->normal);
        }
    }
}

void taut_film_curves_cut(int count, const taut_curve *const *curves, int patches_most,
                          taut_film_cut *cut)
{
    taut_film_polygon waiting[TAUT_FILM_CURVES_MAX], whole = {.count = count};
    int left = 1;
    shape s = {.has_lines_outside = 0};

    take_shape(count, curves, &s);
    *cut = (taut_film_cut){.polygon_count = 0};
    for (int c = 0; c < count; c++) {
        whole.corners[c] = whole.sides[c] = c;
    }
    waiting[0] = whole;
    for (int c = 0; c < count; c++) {
        double ways[2][3];
        take_ways(&s, &whole, c, ways);
        s.has_lines_outside |= corner_angle(&s, (const double(*)[3])ways) > TAUT_PI;
    }
    while (left > 0) {
        const taut_film_polygon p = waiting[--left];
        int ends[2] = {0, 0}, open = 0, others = 0;
        for (int k = 0; k < p.count; k++) {
            open += is_open(&s, &p, k);
        }
        for (int k = 0; k < left; k++) {
            others += waiting[k].count;
        }
        if (2 * open <= p.count && (open > 0 || p.count > SIDES_ENOUGH) &&
            find_line(&s, &p, ends)) {
            take_part(&p, ends[1], ends[0], cut->line_count, &waiting[left++]);
            take_part(&p, ends[0], ends[1], cut->line_count, &waiting[left++]);
            cut->from[cut->line_count++] = p.corners[ends[0]];
        } else if (open > 0 && cut->patch_count + others + 3 * p.count <= patches_most) {
            if (thin * angle_of_triangles(&s, &whole) > angle_of_triangles(&s, &p) &&
                3 * count <= patches_most) {
                *cut = (taut_film_cut){.polygon_count = 0};
                add_triangles(cut, &whole);
                return;
            }
            add_triangles(cut, &p);
        } else {
            add_polygon(cut, &p);
        }
    }
}
