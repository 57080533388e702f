#include "certify/film/lines.h"

#include "certify/common/verdict.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { GRID = 101 }; /* as the mean curvature is looked at */

/* A place on an edge, scaled. */
typedef struct spot {
    double x[3], d[3], dd[3]; /* the curve and its derivatives along the edge */
    double out[3];            /* the conormal, outwards, unit */
    double pull
        [3]; /* what the film pulls with, per length, over the tension, outwards: the conormal but for threads */
    double normal[3]; /* of the surface, unit */
    double speed;
} spot;

static double parameter(const taut_basis *basis, int k)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    return k == GRID - 1 ? hi : lo + (hi - lo) * k / (GRID - 1);
}

/* out points from the film to beyond its edge. */
static void look(const taut_film_sheet *sheet, int e, double at, spot *s)
{
    const taut_surface *surface = sheet->surface;
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double end_u = e == 0 ? taut_basis_lo(u) : taut_basis_hi(u);
    const double end_v = e == 2 ? taut_basis_lo(v) : taut_basis_hi(v);
    double values[TAUT_SURFACE_VECTORS(2)][3];

    (void)taut_surface_eval(surface, e < 2 ? end_u : at, e < 2 ? at : end_v, 2, values[0]);
    for (int k = 0; k < TAUT_SURFACE_VECTORS(2); k++) {
        for (int c = 0; c < 3; c++) {
            const double from = k == TAUT_X ? sheet->origin[c] : 0;
            values[k][c] = ldexp(values[k][c] - from, -sheet->unit);
        }
    }
    const double *inwards = values[e < 2 ? TAUT_XU : TAUT_XV];
    memcpy(s->x, values[TAUT_X], sizeof s->x);
    memcpy(s->d, values[e < 2 ? TAUT_XV : TAUT_XU], sizeof s->d);
    memcpy(s->dd, values[e < 2 ? TAUT_XVV : TAUT_XUU], sizeof s->dd);
    taut_cross(values[TAUT_XU], values[TAUT_XV], s->normal);
    s->speed = taut_length(s->d);
    const double sign = e % 2 == 0 ? -1 : 1; /* the parameter across grows inwards at u0 and v0 */
    const double along = taut_dot(inwards, s->d) / (s->speed * s->speed);
    for (int c = 0; c < 3; c++) {
        s->out[c] = sign * (inwards[c] - along * s->d[c]);
    }
    const double w = taut_length(s->normal), width = taut_length(s->out);
    for (int c = 0; c < 3; c++) {
        s->normal[c] /= w;
        s->pull[c] = s->out[c] /= width;
    }
    if (taut_film_sheet_has_threads(sheet->problem)) {
        double threads[2];
        taut_film_sheet_threads(sheet, e < 2 ? end_u : at, e < 2 ? at : end_v, threads);
        for (int c = 0; c < 3; c++) {
            s->pull[c] = sign * threads[e < 2 ? 0 : 1] * inwards[c] / s->speed;
        }
    }
}

static const taut_basis *basis_of(const taut_film_sheet *sheet, int e)
{
    return e < 2 ? taut_surface_v(sheet->surface) : taut_surface_u(sheet->surface);
}

/* What lies in the plane of an edge. */
static void into_plane(const taut_film_edge *edge, double x[3])
{
    const double *n = edge->plane.direction, size = taut_norm(n);
    const double unit[3] = {n[0] / size, n[1] / size, n[2] / size};
    taut_add_scaled(-taut_dot(unit, x), unit, x);
}

/* |r c'' - p|, p what the film pulls with, of a cable in a plane the part there; c'' along arc length. */
static double pull_left(const taut_film_edge *edge, const spot *s, double r)
{
    const double square = s->speed * s->speed, along = taut_dot(s->dd, s->d) / square;
    double out[3] = {s->pull[0], s->pull[1], s->pull[2]};

    if (taut_film_sheet_in_plane(edge)) {
        into_plane(edge, out);
    }
    for (int c = 0; c < 3; c++) {
        out[c] = r * (s->dd[c] - along * s->d[c]) / square - out[c];
    }
    return taut_length(out);
}

/* *threads, *most: of a cable beside threads, what is left and what they pull with. */
static void add_defects(const taut_film_sheet *sheet, int e, const spot *s,
                        taut_film_defects *found, double *threads, double *most)
{
    const taut_film_edge *edge = &sheet->problem->edges[e];
    const double square = s->speed * s->speed, r = sheet->ratios[e];

    if (edge->kind == TAUT_FILM_SLIDE) {
        double out[3] = {s->pull[0], s->pull[1], s->pull[2]};
        into_plane(edge, out);
        found->slide = taut_certify_max(found->slide, taut_length(out) / taut_length(s->pull));
    } else if (taut_film_sheet_has_threads(sheet->problem)) {
        *threads = taut_certify_max(*threads, pull_left(edge, s, r));
        *most = taut_certify_max(*most, taut_length(s->pull));
    } else if (taut_film_sheet_in_plane(edge)) {
        found->geodesic = taut_certify_max(found->geodesic, pull_left(edge, s, r));
    } else if (taut_film_sheet_is_cable(sheet, e)) {
        found->geodesic =
            taut_certify_max(found->geodesic, fabs(r * taut_dot(s->dd, s->out) / square - 1));
        found->normal =
            taut_certify_max(found->normal, fabs(r * taut_dot(s->dd, s->normal) / square));
    }
}

taut_film_defects taut_film_defects_of(const taut_film_sheet *sheet)
{
    taut_film_defects found = {0, 0, 0};

    for (int e = 0; e < 4; e++) {
        const taut_film_edge_kind kind = sheet->problem->edges[e].kind;
        double threads = 0, most = 0;
        for (int k = 0; k < GRID && (kind == TAUT_FILM_CABLE || kind == TAUT_FILM_SLIDE); k++) {
            spot s;
            look(sheet, e, parameter(basis_of(sheet, e), k), &s);
            add_defects(sheet, e, &s, &found, &threads, &most);
        }
        found.geodesic =
            most > 0 ? taut_certify_max(found.geodesic, threads / most) : found.geodesic;
    }
    return found;
}

void taut_film_stress(const taut_film_sheet *sheet, double range[2][2])
{
    const taut_surface *surface = sheet->surface;

    for (int d = 0; d < 2; d++) {
        range[d][0] = INFINITY;
        range[d][1] = 0;
    }
    for (int k = 0; k < GRID * GRID; k++) {
        const double u = parameter(taut_surface_u(surface), k / GRID),
                     v = parameter(taut_surface_v(surface), k % GRID);
        double x[TAUT_SURFACE_VECTORS(1)][3], threads[2];
        (void)taut_surface_eval(surface, u, v, 1, x[0]);
        taut_film_sheet_threads(sheet, u, v, threads);
        const double lu = taut_norm(x[TAUT_XU]), lv = taut_norm(x[TAUT_XV]);
        const double stress[2] = {sheet->tension * threads[0] * lu / lv,
                                  sheet->tension * threads[1] * lv / lu};
        for (int d = 0; d < 2; d++) {
            range[d][0] = stress[d] < range[d][0] ? stress[d] : range[d][0];
            range[d][1] = taut_certify_max(range[d][1], stress[d]);
        }
    }
}

double taut_film_sag(const taut_film_sheet *sheet, int e)
{
    spot first, last;
    double chord[3], largest = 0;

    look(sheet, e, parameter(basis_of(sheet, e), 0), &first);
    look(sheet, e, parameter(basis_of(sheet, e), GRID - 1), &last);
    taut_difference(last.x, first.x, chord);
    const double length = taut_length(chord);
    for (int k = 1; k < GRID - 1; k++) {
        spot s;
        double from[3], across[3];
        look(sheet, e, parameter(basis_of(sheet, e), k), &s);
        taut_difference(s.x, first.x, from);
        taut_cross(from, chord, across);
        largest = taut_certify_max(largest, taut_length(across) / (length * length));
    }
    return largest;
}

/* sum -= int nu ds over an edge, in scaled lengths, of one in a plane what lies across it; *size that of int ds. */
static void add_held(const taut_film_sheet *sheet, int e, double sum[3], double *size)
{
    const taut_film_nodes *nodes = e < 2 ? &sheet->v : &sheet->u;
    const taut_film_edge *edge = &sheet->problem->edges[e];
    for (int k = 0; k < nodes->table->count; k++) {
        spot s;
        double in[3] = {0, 0, 0};
        look(sheet, e, nodes->at[k], &s);
        if (taut_film_sheet_in_plane(edge)) {
            memcpy(in, s.pull, sizeof in);
            into_plane(edge, in);
        }
        for (int c = 0; c < 3; c++) {
            sum[c] -= nodes->weights[k] * s.speed * (s.pull[c] - in[c]);
        }
        *size += nodes->weights[k] * s.speed;
    }
}

/* Its ends pull at corners, where they are held. */
static void add_ends(const taut_film_sheet *sheet, int e, double forces[4][3], double sum[3],
                     double *size)
{
    for (int end = 0; end < 2; end++) {
        const int corner = e < 2 ? e + 2 * end : end + 2 * (e - 2);
        const double sign = end == 0 ? 1 : -1, r = sheet->ratios[e];
        spot s;
        look(sheet, e, parameter(basis_of(sheet, e), end * (GRID - 1)), &s);
        taut_add_scaled(sign * sheet->forces[e] / s.speed, s.d, forces[corner]);
        taut_add_scaled(sign * r / s.speed, s.d, sum);
        *size += r;
    }
}

void taut_film_reactions(const taut_film_sheet *sheet, double forces[4][3], unsigned char has[4],
                         double *balance)
{
    double sum[3] = {0, 0, 0}, size = 0;

    memset(forces, 0, 12 * sizeof(double));
    for (int c = 0; c < 4; c++) {
        has[c] = sheet->problem->ring == TAUT_FILM_OPEN &&
                 sheet->problem->corner_kinds[c] == TAUT_FILM_HELD;
    }
    for (int e = 0; e < 4; e++) {
        const taut_film_edge *edge = &sheet->problem->edges[e];
        if (!taut_film_sheet_has_edge(sheet->problem, e) || edge->kind == TAUT_FILM_POLE) {
            continue;
        }
        if (!taut_film_sheet_is_cable(sheet, e) || taut_film_sheet_in_plane(edge)) {
            add_held(sheet, e, sum, &size);
        }
        if (taut_film_sheet_is_cable(sheet, e) && sheet->problem->ring == TAUT_FILM_OPEN) {
            add_ends(sheet, e, forces, sum, &size);
        }
    }
    *balance = size > 0 ? taut_length(sum) / size : 0; /* forces that vanish beside the tension */
}

/* Where edge e leaves its two corners; *normals: of the film there. */
static void leave_corners(const taut_film_sheet *sheet, int e, double ways[2][3],
                          double normals[2][3])
{
    const taut_film_nodes *nodes = e < 2 ? &sheet->v : &sheet->u;
    const taut_film_edge *edge = &sheet->problem->edges[e];
    const double lo = taut_basis_lo(basis_of(sheet, e)),
                 range = taut_basis_hi(basis_of(sheet, e)) - lo, r = sheet->ratios[e];
    spot s;

    for (int end = 0; end < 2; end++) {
        look(sheet, e, parameter(basis_of(sheet, e), end * (GRID - 1)), &s);
        memcpy(normals[end], s.normal, sizeof s.normal);
        memset(ways[end], 0, sizeof ways[end]);
        taut_add_scaled(r > 0 ? 0 : 1 - 2 * end, s.d, ways[end]);
    }
    for (int k = 0; r > 0 && k < nodes->table->count; k++) {
        const double t = (nodes->at[k] - lo) / range;
        look(sheet, e, nodes->at[k], &s);
        if (taut_film_sheet_in_plane(edge)) {
            into_plane(edge, s.out);
        }
        for (int end = 0; end < 2; end++) {
            taut_add_scaled(nodes->weights[k] * (1 - 2 * end) / (range * s.speed), s.d, ways[end]);
            taut_add_scaled(-nodes->weights[k] * s.speed / r * (end ? t : 1 - t), s.out, ways[end]);
        }
    }
}

int taut_film_passed_at(const taut_film_sheet *sheet)
{
    const taut_film_edge *edges = sheet->problem->edges;
    double ways[4][2][3], normals[4][2][3];

    if (sheet->problem->ring != TAUT_FILM_OPEN || taut_film_sheet_has_threads(sheet->problem)) {
        return -1;
    }
    for (int e = 0; e < 4; e++) {
        leave_corners(sheet, e, ways[e], normals[e]);
    }
    for (int c = 0; c < 4; c++) {
        const int u = 2 + c / 2, v = c % 2; /* the edges that end there */
        const double *along = ways[u][v], *across = ways[v][c / 2];
        const double turn =
            taut_det(along, across, normals[v][c / 2]) * (c == 1 || c == 2 ? -1 : 1);
        if (sheet->ratios[u] + sheet->ratios[v] > 0 && edges[u].kind != TAUT_FILM_SLIDE &&
            edges[v].kind != TAUT_FILM_SLIDE && !(turn > 0)) {
            return c;
        }
    }
    return -1;
}
