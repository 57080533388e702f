#include "certify/film/complex/defects.h"

#include "certify/common/verdict.h"
#include "certify/film/sheet.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { PLACES = 40, SAMPLES = 101 };

/* Derivatives of a patch at parts (s, t) of its ranges. */
static void look(const taut_sheets *s, int p, double at_u, double at_v, int order, double (*x)[3])
{
    const taut_basis *u = taut_surface_u(s->surfaces[p]), *v = taut_surface_v(s->surfaces[p]);
    (void)taut_surface_eval(
        s->surfaces[p], taut_basis_lo(u) + at_u * (taut_basis_hi(u) - taut_basis_lo(u)),
        taut_basis_lo(v) + at_v * (taut_basis_hi(v) - taut_basis_lo(v)), order, x[0]);
}

/* 2 H at a place. */
static double mean_at(const taut_sheets *s, int p, double u, double v)
{
    double x[TAUT_SURFACE_VECTORS(2)][3], n[3];

    look(s, p, u, v, 2, x);
    taut_cross(x[TAUT_XU], x[TAUT_XV], n);
    const double w = taut_norm(n), e = taut_dot(x[TAUT_XU], x[TAUT_XU]),
                 f = taut_dot(x[TAUT_XU], x[TAUT_XV]), g = taut_dot(x[TAUT_XV], x[TAUT_XV]);
    return (e * taut_dot(x[TAUT_XVV], n) - 2 * f * taut_dot(x[TAUT_XUV], n) +
            g * taut_dot(x[TAUT_XUU], n)) /
           (w * w * w);
}

/* A place of an edge: its tangent, c'' by arc length, the outward conormal and the normal of its sheet, and what this pulls with. */
typedef struct rim {
    double t[3], bend[3], nu[3], n[3], x[3], pull[3];
} rim;

static double tension_of(const taut_sheets *s, int p)
{
    return s->shares[p] * s->tension;
}

static int has_threads(const taut_sheets *s, int p)
{
    return taut_film_sheet_has_threads(&s->complex->problem->patches[p]);
}

/* Threads at parts of the ranges of a patch, in the user's unit, by its knots. */
static void find_threads(const taut_sheets *s, int p, double at_u, double at_v, double threads[2])
{
    const taut_basis *u = taut_surface_u(s->surfaces[p]), *v = taut_surface_v(s->surfaces[p]);
    taut_film_threads_of(&s->complex->problem->patches[p], s->surfaces[p], 1,
                         taut_basis_lo(u) + at_u * (taut_basis_hi(u) - taut_basis_lo(u)),
                         taut_basis_lo(v) + at_v * (taut_basis_hi(v) - taut_basis_lo(v)), threads);
}

static void find_rim(const taut_sheets *s, const taut_film_side *side, double part, rim *at)
{
    const int e = side->edge;
    const double along = side->reversed ? 1 - part : part;
    double x[TAUT_SURFACE_VECTORS(2)][3];

    look(s, side->patch, e < 2 ? e : along, e < 2 ? along : e - 2, 2, x);
    const double *first = e < 2 ? x[TAUT_XV] : x[TAUT_XU],
                 *second = e < 2 ? x[TAUT_XVV] : x[TAUT_XUU];
    const double *out = e < 2 ? x[TAUT_XU] : x[TAUT_XV], speed = taut_norm(first);
    const double sign = e % 2 == 0 ? -1 : 1;

    memcpy(at->x, x[0], sizeof at->x);
    for (int k = 0; k < 3; k++) {
        at->t[k] = first[k] / speed;
    }
    for (int k = 0; k < 3; k++) {
        at->bend[k] = (second[k] - taut_dot(second, at->t) * at->t[k]) / (speed * speed);
        at->nu[k] = sign * (out[k] - taut_dot(out, at->t) * at->t[k]);
    }
    const double size = taut_norm(at->nu);
    for (int k = 0; k < 3; k++) {
        at->nu[k] /= size;
    }
    taut_cross(at->t, at->nu, at->n);
    double threads[2] = {0, 0};
    if (has_threads(s, side->patch)) {
        find_threads(s, side->patch, e < 2 ? e : along, e < 2 ? along : e - 2, threads);
    }
    for (int k = 0; k < 3; k++) {
        at->pull[k] = threads[0] > 0 ? sign * threads[e < 2 ? 0 : 1] * out[k] / speed
                                     : tension_of(s, side->patch) * at->nu[k];
    }
}

/* What the cable along an edge, or the seam that it is in, draws with. */
static double force_of(const taut_sheets *s, const taut_film_edge *edge)
{
    const taut_film_complex *c = s->complex;
    int k = 0;
    while (c->strands[k].edge != edge) {
        k++;
    }
    return s->forces[c->strands[k].rope];
}

/* Without its part along a plane's normal. */
static void into_plane(const taut_film_edge *edge, double x[3])
{
    const double size = taut_norm(edge->plane.direction);
    double n[3];
    for (int k = 0; k < 3; k++) {
        n[k] = edge->plane.direction[k] / size;
    }
    taut_add_scaled(-taut_dot(x, n), n, x);
}

static double seam_at(const taut_sheets *s, const taut_film_seam *seam, double part)
{
    double sum[3] = {0, 0, 0}, largest = 0;

    for (int k = 0; k < seam->count; k++) {
        rim at;
        find_rim(s, &seam->sides[k], part, &at);
        taut_add_scaled(1, at.pull, sum);
        largest = fmax(largest, taut_norm(at.pull));
        if (k == 0 && seam->edge.kind == TAUT_FILM_CABLE) {
            taut_add_scaled(-force_of(s, &seam->edge), at.bend, sum);
        }
    }
    if (seam->edge.kind == TAUT_FILM_CABLE && seam->edge.has_plane) {
        into_plane(&seam->edge, sum);
    }
    return taut_norm(sum) / largest;
}

static void edge_at(const taut_sheets *s, const taut_film_side *side, double part,
                    taut_complex_defects *d, double *threads, double *most)
{
    const taut_film_edge *edge = &s->complex->problem->patches[side->patch].edges[side->edge];
    rim at;

    find_rim(s, side, part, &at);
    if (edge->kind == TAUT_FILM_SLIDE) {
        const double whole = taut_norm(at.pull);
        into_plane(edge, at.pull); /* nu - (nu . N) N */
        d->slide = taut_certify_max(taut_norm(at.pull) / whole, d->slide);
    } else if (edge->kind == TAUT_FILM_CABLE && has_threads(s, side->patch)) {
        *most = taut_certify_max(taut_norm(at.pull), *most);
        if (edge->has_plane) {
            into_plane(edge, at.pull);
        }
        taut_add_scaled(-force_of(s, edge), at.bend, at.pull);
        *threads = taut_certify_max(taut_norm(at.pull), *threads);
    } else if (edge->kind == TAUT_FILM_CABLE) {
        const double radius = force_of(s, edge) / tension_of(s, side->patch);
        if (edge->has_plane) {
            into_plane(edge, at.nu);
            for (int k = 0; k < 3; k++) {
                at.nu[k] -= radius * at.bend[k];
            }
            d->geodesic = taut_certify_max(taut_norm(at.nu), d->geodesic);
        } else {
            d->geodesic =
                taut_certify_max(fabs(taut_dot(at.bend, at.nu) * radius - 1), d->geodesic);
            d->normal = taut_certify_max(fabs(taut_dot(at.bend, at.n)) * radius, d->normal);
        }
    }
}

taut_complex_defects taut_complex_defects_of(const taut_sheets *sheets)
{
    const taut_sheets *s = sheets;
    const taut_film_problem *problem = s->complex->problem;
    taut_complex_defects d = {0, 0, 0, 0, 0};

    for (int p = 0; p < problem->patch_count; p++) {
        const double pressure = ldexp(s->pull[p] / s->shares[p], -s->unit);
        for (int k = 0; k < PLACES * PLACES && !has_threads(s, p); k++) {
            const double bend =
                mean_at(s, p, (k / PLACES + 0.5) / PLACES, (k % PLACES + 0.5) / PLACES);
            d.mean = taut_certify_max(fabs(bend + pressure) * (2 * s->half), d.mean);
        }
        for (int e = 0; e < 4; e++) {
            const taut_film_side side = {p, e, 0};
            double threads = 0, most = 0;
            for (int k = 0; k < SAMPLES; k++) {
                edge_at(s, &side, (k + 0.5) / SAMPLES, &d, &threads, &most);
            }
            d.geodesic = most > 0 ? taut_certify_max(threads / most, d.geodesic) : d.geodesic;
        }
    }
    for (int k = 0; k < problem->seam_count * SAMPLES; k++) {
        d.seam = taut_certify_max(
            seam_at(s, &problem->seams[k / SAMPLES], (k % SAMPLES + 0.5) / SAMPLES), d.seam);
    }
    return d;
}

void taut_complex_stress(const taut_sheets *sheets, double range[2][2])
{
    const int patches = sheets->complex->problem->patch_count;

    for (int d = 0; d < 2; d++) {
        range[d][0] = INFINITY;
        range[d][1] = 0;
    }
    for (int k = 0; k < patches * SAMPLES * SAMPLES; k++) {
        const int p = k / (SAMPLES * SAMPLES);
        const double u = (double)(k / SAMPLES % SAMPLES) / (SAMPLES - 1),
                     v = (double)(k % SAMPLES) / (SAMPLES - 1);
        double x[TAUT_SURFACE_VECTORS(1)][3], threads[2];
        if (!has_threads(sheets, p)) {
            continue;
        }
        look(sheets, p, u, v, 1, x);
        find_threads(sheets, p, u, v, threads);
        const double lu = taut_norm(x[TAUT_XU]), lv = taut_norm(x[TAUT_XV]);
        const double stress[2] = {threads[0] * lu / lv, threads[1] * lv / lu};
        for (int d = 0; d < 2; d++) {
            range[d][0] = stress[d] < range[d][0] ? stress[d] : range[d][0];
            range[d][1] = taut_certify_max(range[d][1], stress[d]);
        }
    }
}

/* The tangent of a strand at an end, leaving it, and the end. */
static void leave_end(const taut_sheets *s, const taut_film_side *side, int end, double t[3])
{
    double x[TAUT_SURFACE_VECTORS(1)][3];
    const int e = side->edge;

    look(s, side->patch, e < 2 ? e : end, e < 2 ? end : e - 2, 1, x);
    const double *first = e < 2 ? x[TAUT_XV] : x[TAUT_XU];
    for (int k = 0; k < 3; k++) {
        t[k] = (end == 0 ? 1 : -1) * first[k] / taut_norm(first);
    }
}

void taut_complex_pulls(const taut_sheets *sheets, double *forces)
{
    const taut_film_complex *c = sheets->complex;

    memset(forces, 0, 3 * (size_t)c->nodes * sizeof(double));
    for (int k = 0; k < c->strand_count; k++) {
        const taut_film_side *side = &c->strands[k].side;
        const int last = taut_film_complex_along(&c->problem->patches[side->patch], side->edge) - 1;
        for (int end = 0; end < 2; end++) {
            double t[3];
            leave_end(sheets, side, end, t);
            taut_add_scaled(sheets->forces[c->strands[k].rope], t,
                            forces + 3 * taut_film_complex_node(c, side, end * last));
        }
    }
}

/* What is in balance: the sum of forces, and of their sizes; over the tension of the first patch, scaled. */
typedef struct scales {
    double sum[3], size;
} scales;

static void put(scales *on, double times, const double force[3])
{
    taut_add_scaled(times, force, on->sum);
    on->size += fabs(times) * taut_norm(force);
}

/* What a hold takes of a force. */
static void take_held(const taut_film_hold *hold, double force[3])
{
    double taken[3] = {0, 0, 0};
    for (int k = 0; k < hold->count; k++) {
        taut_add_scaled(taut_dot(force, hold->normals[k]), hold->normals[k], taken);
    }
    memcpy(force, taken, sizeof taken);
}

/* What holds an edge that draws with `force`: all of an edge that is held, across its plane of one that moves in it. 0: nothing. */
static int take_edge(const taut_sheets *s, const taut_film_side *side, double force[3])
{
    const taut_film_complex *c = s->complex;
    const int seam = taut_film_complex_seam(c->problem, side->patch, side->edge);
    const taut_film_edge *edge = seam < 0 ? &c->problem->patches[side->patch].edges[side->edge]
                                          : &c->problem->seams[seam].edge;

    if (edge->kind == TAUT_FILM_POLE) {
        take_held(&c->holds[taut_film_complex_node(c, side, 0)], force);
        return has_threads(s, side->patch);
    }
    if (edge->kind == TAUT_FILM_SLIDE || (edge->kind == TAUT_FILM_CABLE && edge->has_plane)) {
        double in[3] = {force[0], force[1], force[2]};
        into_plane(edge, in);
        taut_add_scaled(-1, in, force);
        return 1;
    }
    return seam < 0 && edge->kind == TAUT_FILM_FIXED;
}

/* What the sheet pulls inwards with along an edge, and the pressure on it: of its vector area 1/2 oint x x dx. */
static void weigh_edge(const taut_sheets *s, const taut_film_side *side, scales *on)
{
    const int p = side->patch, e = side->edge;
    const taut_sheet_axis *axis = &s->axes[2 * p + (e < 2)];
    const taut_basis *basis =
        e < 2 ? taut_surface_v(s->surfaces[p]) : taut_surface_u(s->surfaces[p]);
    const double lo = taut_basis_lo(basis), range = taut_basis_hi(basis) - lo;
    const double *origin = taut_surface_points(s->surfaces[0]);

    for (int k = 0; k < axis->table->count; k++) {
        const double t = (axis->at[k] - lo) / range;
        double x[TAUT_SURFACE_VECTORS(1)][3], from[3], area[3], force[3] = {0, 0, 0};
        look(s, p, e < 2 ? e : t, e < 2 ? t : e - 2, 1, x);
        for (int d = 0; d < 3; d++) {
            from[d] = ldexp(x[0][d] - origin[d], -s->unit);
            x[TAUT_XU][d] = ldexp(x[TAUT_XU][d], -s->unit);
            x[TAUT_XV][d] = ldexp(x[TAUT_XV][d], -s->unit);
        }
        const double *along = x[e < 2 ? TAUT_XV : TAUT_XU], *out = x[e < 2 ? TAUT_XU : TAUT_XV];
        taut_cross(from, along, area);
        taut_add_scaled((e == 1 || e == 2 ? 0.5 : -0.5) * s->pull[p] * axis->weights[k], area,
                        on->sum);
        if (has_threads(s, p)) {
            double threads[2];
            find_threads(s, p, e < 2 ? e : t, e < 2 ? t : e - 2, threads);
            taut_add_scaled(threads[e < 2 ? 0 : 1] / s->tension, out, force);
        } else {
            const double speed = taut_norm(along);
            taut_add_scaled(1, out, force);
            taut_add_scaled(-taut_dot(out, along) / (speed * speed), along, force);
            const double width = taut_norm(force);
            for (int d = 0; d < 3; d++) {
                force[d] *= s->shares[p] * speed / width;
            }
        }
        if (take_edge(s, side, force)) {
            put(on, (e % 2 == 0 ? -1 : 1) * axis->weights[k], force);
        }
    }
}

double taut_complex_balance(const taut_sheets *sheets)
{
    const taut_film_complex *c = sheets->complex;
    scales on = {{0, 0, 0}, 0};

    for (int k = 0; k < 4 * c->problem->patch_count; k++) {
        const taut_film_side side = {k / 4, k % 4, 0};
        weigh_edge(sheets, &side, &on);
        on.size += k % 4 > 0
                       ? 0
                       : fabs(sheets->pull[k / 4]) * ldexp(sheets->areas[k / 4], -2 * sheets->unit);
    }
    for (int k = 0; k < 2 * c->strand_count; k++) {
        const taut_film_side *side = &c->strands[k / 2].side;
        const int last = taut_film_complex_along(&c->problem->patches[side->patch], side->edge) - 1;
        double t[3];
        leave_end(sheets, side, k % 2, t);
        take_held(&c->holds[taut_film_complex_node(c, side, k % 2 * last)], t);
        put(&on, -sheets->ratios[c->strands[k / 2].rope], t); /* what holds it draws it outwards */
    }
    return on.size > 0 ? taut_norm(on.sum) / on.size : 0;
}

/* The place of part `at` of a strand. */
static void find_place(const taut_sheets *s, const taut_film_side *side, double at, double x[3])
{
    double values[TAUT_SURFACE_VECTORS(0)][3];
    const int e = side->edge;
    look(s, side->patch, e < 2 ? e : at, e < 2 ? at : e - 2, 0, values);
    memcpy(x, values[0], 3 * sizeof(double));
}

/* Where a node is. */
static void find_node(const taut_sheets *s, int rope, int end, double x[3])
{
    const taut_film_complex *c = s->complex;

    for (int k = 0; k < c->strand_count; k++) {
        const taut_film_side *side = &c->strands[k].side;
        const int last = taut_film_complex_along(&c->problem->patches[side->patch], side->edge) - 1;
        for (int at = 0; c->strands[k].rope == rope && at < 2; at++) {
            if (taut_film_complex_node(c, side, at * last) == c->ropes[rope].ends[end]) {
                find_place(s, side, at, x);
            }
        }
    }
}

double taut_complex_sag(const taut_sheets *sheets, int rope)
{
    const taut_film_complex *c = sheets->complex;
    double first[3] = {0, 0, 0}, last[3] = {0, 0, 0}, chord[3], largest = 0;

    find_node(sheets, rope, 0, first);
    find_node(sheets, rope, 1, last);
    taut_difference(last, first, chord);
    const double length = taut_norm(chord);
    for (int k = 0; k < c->strand_count * SAMPLES && length > 0; k++) {
        double x[3], from[3], across[3];
        if (c->strands[k / SAMPLES].rope == rope) {
            find_place(sheets, &c->strands[k / SAMPLES].side, (double)(k % SAMPLES) / SAMPLES, x);
            taut_difference(x, first, from);
            taut_cross(from, chord, across);
            largest = taut_certify_max(taut_norm(across) / length / length, largest);
        }
    }
    return largest;
}

/* Where edge e of patch p leaves corner `end` of its two, r: T / s of a cable, else 0. */
static void leave_corner(const taut_sheets *s, int p, int e, int end, double r, double way[3])
{
    const taut_film_side side = {p, e, 0};
    const taut_sheet_axis *axis = &s->axes[2 * p + (e < 2)];
    const taut_film_problem *patch = &s->complex->problem->patches[p];
    const taut_basis *basis = e < 2 ? patch->v : patch->u;
    const double lo = taut_basis_lo(basis), range = taut_basis_hi(basis) - lo;

    memset(way, 0, 3 * sizeof *way);
    if (r <= 0) {
        leave_end(s, &side, end, way);
    }
    for (int k = 0; r > 0 && k < axis->table->count; k++) {
        const double t = (axis->at[k] - lo) / range, weight = axis->weights[k] / range;
        double x[TAUT_SURFACE_VECTORS(1)][3];
        rim at;
        find_rim(s, &side, t, &at);
        look(s, p, e < 2 ? e : t, e < 2 ? t : e - 2, 1, x);
        const double speed = range * taut_norm(x[e < 2 ? TAUT_XV : TAUT_XU]);
        if (patch->edges[e].has_plane) {
            into_plane(&patch->edges[e], at.nu);
        }
        taut_add_scaled(weight * (1 - 2 * end), at.t, way);
        taut_add_scaled(-weight * speed / r * (end ? t : 1 - t), at.nu, way);
    }
}

int taut_complex_passed(const taut_sheets *s)
{
    const taut_film_complex *complex = s->complex;

    for (int k = 0; k < 4 * complex->problem->patch_count; k++) {
        const int p = k / 4, c = k % 4, edges[2] = {2 + c / 2, c % 2}, ends[2] = {c % 2, c / 2};
        const int node = taut_film_complex_corner(complex, p, c);
        double ways[2][3], x[TAUT_SURFACE_VECTORS(1)][3], n[3];
        int cables = 0, open = has_threads(s, p) || s->first[node + 1] > s->first[node];
        for (int d = 0; d < 2 && !open; d++) {
            const taut_film_edge *edge = &complex->problem->patches[p].edges[edges[d]];
            const int is_cable = edge->kind == TAUT_FILM_CABLE;
            open = taut_film_complex_seam(complex->problem, p, edges[d]) >= 0 ||
                   (!is_cable && edge->kind != TAUT_FILM_FIXED);
            cables += is_cable;
            leave_corner(s, p, edges[d], ends[d],
                         !open && is_cable ? force_of(s, edge) / tension_of(s, p) : 0, ways[d]);
        }
        look(s, p, c % 2, c / 2, 1, x);
        taut_cross(x[TAUT_XU], x[TAUT_XV], n);
        if (!open && cables > 0 &&
            !(taut_det(ways[0], ways[1], n) * (c == 1 || c == 2 ? -1 : 1) > 0)) {
            return k;
        }
    }
    return -1;
}
