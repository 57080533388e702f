#include "certify/film/least.h"

#include "certify/film/calibration.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { SIDES = 4 };
static const double flat_share = 1e-12; /* of the size: a corner in the plane of the others */
/* Of what is added up: what rounding may have taken from the bound, a few hundred units of it. */
static const double rounding = 0x1p-44;
static const double flat_limit = 1e-6, space_limit = 1e-3;
static const double inside = 1 - 1e-12; /* of R: as far as a corner may be along a chord */

/* The corners as they run round the sail, and the edge from each to the next. */
typedef struct polygon {
    double at[SIDES][2];
    int edge[SIDES];
    double area; /* above 0 */
} polygon;

static void find_corner(const taut_film_sheet *sheet, int c, double x[3])
{
    const size_t i = (size_t)(c % 2 * (sheet->nu - 1)), j = (size_t)(c / 2 * (sheet->nv - 1));
    memcpy(x, sheet->points + 3 * (i * (size_t)sheet->nv + j), 3 * sizeof(double));
}

/* In the plane across the vector area of the chords; 0 where they do not lie in it. */
static int lay_flat(const taut_film_sheet *sheet, polygon *p)
{
    static const int round[SIDES] = {0, 1, 3, 2}, edges[SIDES] = {2, 1, 3, 0};
    double x[SIDES][3], d[2][3], n[3], e[2][3];

    for (int k = 0; k < SIDES; k++) {
        find_corner(sheet, round[k], x[k]);
        p->edge[k] = edges[k];
    }
    taut_difference(x[2], x[0], d[0]);
    taut_difference(x[3], x[1], d[1]);
    taut_cross(d[0], d[1], n); /* twice the vector area */
    const double size = taut_length(n), across = taut_length(d[0]);
    if (!(size > flat_share) || !(across > 0)) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        n[c] /= size;
        e[0][c] = d[0][c] / across;
    }
    taut_cross(n, e[0], e[1]);
    for (int k = 0; k < SIDES; k++) {
        double from[3];
        taut_difference(x[k], x[0], from);
        if (!(fabs(taut_dot(from, n)) <= flat_share)) {
            return 0;
        }
        p->at[k][0] = taut_dot(from, e[0]);
        p->at[k][1] = taut_dot(from, e[1]);
    }
    p->area = 0.5 * size;
    return 1;
}

/* Do all corners lie within R of the middle of side k, along it? *chord its length. */
static int is_within(const polygon *p, int k, double radius, double *chord)
{
    const double *a = p->at[k], *b = p->at[(k + 1) % SIDES];
    const double along[2] = {b[0] - a[0], b[1] - a[1]};
    *chord = sqrt(along[0] * along[0] + along[1] * along[1]);
    for (int c = 0; c < SIDES; c++) {
        const double from[2] = {p->at[c][0] - 0.5 * (a[0] + b[0]),
                                p->at[c][1] - 0.5 * (a[1] + b[1])};
        const double x = (from[0] * along[0] + from[1] * along[1]) / *chord;
        if (!(fabs(x) <= inside * radius)) {
            return 0;
        }
    }
    return 1;
}

/* What the energy has beside T L, at the least. User's unit. */
static double stored(const taut_film_sheet *sheet, int e, double given)
{
    const taut_film_edge *edge = &sheet->problem->edges[e];
    const double force = sheet->forces[e];

    if (edge->law == TAUT_FILM_FORCE) {
        return 0;
    }
    return edge->law == TAUT_FILM_ELASTIC
               ? -force * edge->unstressed * (1 + 0.5 * force / edge->stiffness)
               : -force * given;
}

/* What is added up, and the sum of the sizes. User's unit. */
typedef struct total {
    double sum, sizes;
} total;

static const char *find_obstacle(const taut_film_sheet *sheet)
{
    if (sheet->problem->ring != TAUT_FILM_OPEN) {
        return "ring: the bound is one of films with four corners";
    }
    for (int e = 0; e < 4; e++) {
        if (sheet->problem->edges[e].kind == TAUT_FILM_SLIDE ||
            sheet->problem->corner_kinds[e] != TAUT_FILM_HELD) {
            return "moving: the bound is one of corners that are held, and of no slides";
        }
    }
    return NULL;
}

/* By the fields in closed form, without what cables store. */
static const char *bound_flat(const taut_film_sheet *sheet, total *t)
{
    const double unit = sheet->tension; /* of energy, over scaled squares */
    polygon p;

    for (int e = 0; e < 4; e++) {
        const taut_curve *curve = sheet->problem->edges[e].curve;
        if (curve != NULL && taut_basis_count(taut_curve_t(curve)) > 2) { /* two points: a line */
            return "curved: the edges are not straight, and the model carries no witness";
        }
    }
    if (!lay_flat(sheet, &p)) {
        return "space: the corners lie in no plane, and the model carries no witness";
    }
    t->sum = t->sizes = unit * ldexp(p.area, 2 * sheet->unit);
    for (int k = 0; k < SIDES; k++) {
        const int e = p.edge[k];
        const double radius = sheet->ratios[e];
        double chord = 0;
        if (!taut_film_sheet_is_cable(sheet, e)) {
            continue;
        }
        if (!is_within(&p, k, radius, &chord)) {
            return "long: a corner lies beyond the circle of a cable, along its chord";
        }
        const double half = 0.5 * chord / radius, a = taut_asin(half);
        const double arc = radius * radius * (a + half * sqrt((1 - half) * (1 + half)));
        t->sum += unit * ldexp(arc, 2 * sheet->unit);
        t->sizes += unit * ldexp(arc, 2 * sheet->unit);
    }
    t->sizes *= rounding;
    return NULL;
}

/* By the fields that the model carries. */
static taut_status bound_space(const taut_film_sheet *sheet, const taut_record *witness, total *t,
                               const char **why)
{
    taut_film_calibration calibration;
    const taut_status status = taut_film_calibrate(sheet, witness, &calibration);

    *why = calibration.why;
    t->sum = sheet->tension * ldexp(calibration.flux, 2 * sheet->unit);
    t->sizes = sheet->tension * ldexp(calibration.off, 2 * sheet->unit);
    return status;
}

taut_status taut_film_least_of(const taut_film_sheet *sheet, const taut_record *witness,
                               const double given[4], taut_film_least *least)
{
    total t = {0, 0};
    taut_status status = TAUT_OK;

    *least = (taut_film_least){.why = find_obstacle(sheet), .limit = flat_limit};
    if (least->why != NULL) {
        return TAUT_OK;
    }
    least->why = bound_flat(sheet, &t);
    if (least->why != NULL && taut_record_kind_of(witness) == TAUT_RECORD_OBJECT) {
        least->limit = space_limit;
        status = bound_space(sheet, witness, &t, &least->why);
    }
    for (int e = 0; e < 4; e++) {
        const double more = taut_film_sheet_is_cable(sheet, e) ? stored(sheet, e, given[e]) : 0;
        t.sum += more;
        t.sizes += rounding * fabs(more);
    }
    least->bound = t.sum - t.sizes;
    if (least->why == NULL && !isfinite(least->bound)) {
        least->why = "a value leaves the range of doubles";
    }
    return status;
}
