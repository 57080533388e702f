#include "certify/film/sheet.h"

#include "certify/common/verdict.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "geometry/keep.h"
#include "numeric/quadrature.h"
#include "numeric/sum.h"

#include <math.h>
#include <string.h>

static taut_status make_nodes(const taut_basis *basis, int extra, taut_arena *arena,
                              taut_film_nodes *nodes)
{
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis), wanted = taut_basis_local(basis) + extra;
    const int each = wanted < TAUT_GAUSS_MAX ? wanted : TAUT_GAUSS_MAX, count = spans * each;
    int *span = taut_arena_take(arena, (size_t)count, sizeof(int));
    taut_table *table = NULL;

    nodes->at = taut_arena_take(arena, (size_t)count, sizeof(double));
    nodes->weights = taut_arena_take(arena, (size_t)count, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_gauss_rule(each, node, weight);
    for (int k = 0; k < count; k++) {
        const double lo = breaks[k / each], hi = breaks[k / each + 1];
        span[k] = k / each;
        nodes->at[k] = fmin(hi, lo + 0.5 * (hi - lo) * (1 + node[k % each]));
        nodes->weights[k] = 0.5 * (hi - lo) * weight[k % each];
    }
    const taut_status status = taut_table_new(basis, count, nodes->at, span, 1, &table);
    if (status != TAUT_OK || !taut_keep_table(arena, table)) {
        return TAUT_NO_MEMORY;
    }
    nodes->table = nodes->moves = table;
    return TAUT_OK;
}

/* The functions of a direction that goes around. */
static taut_status open_nodes(const taut_basis *basis, taut_arena *arena, taut_film_nodes *nodes)
{
    const taut_table *table = nodes->table;
    taut_loop loop;
    taut_table *moves = NULL;

    if (taut_loop_new(basis, arena, &loop) != TAUT_OK ||
        taut_table_new(basis, table->count, nodes->at, NULL, 1, &moves) != TAUT_OK ||
        !taut_keep_table(arena, moves)) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < table->count; k++) {
        moves->first[k] = table->first[k];
        for (int order = 0; order <= 1; order++) {
            double *row = moves->values + ((size_t)k * 2 + (size_t)order) * (size_t)moves->local;
            memcpy(row, taut_table_row(table, k, order), (size_t)moves->local * sizeof(double));
            taut_loop_open(&loop, moves->first[k], row);
        }
    }
    nodes->moves = moves;
    nodes->period = loop.period;
    return TAUT_OK;
}

/* ---- threads ---- */

void taut_film_threads_of(const taut_film_problem *problem, const taut_surface *surface,
                          double tension, double u, double v, double threads[2])
{
    const taut_basis *along = taut_surface_u(surface), *across = taut_surface_v(surface);
    const double ratio = (taut_basis_hi(along) - taut_basis_lo(along)) /
                         (taut_basis_hi(across) - taut_basis_lo(across));
    double x[TAUT_SURFACE_VECTORS(1)][3], normal[3];

    threads[0] = problem->force_density[0] / tension * ratio;
    threads[1] = problem->force_density[1] / tension / ratio;
    if (problem->prestress[0] > 0) {
        (void)taut_surface_eval(problem->reference, u, v, 1, x[0]);
        taut_cross(x[TAUT_XU], x[TAUT_XV], normal);
        const double area = taut_norm(normal), lu = taut_norm(x[TAUT_XU]),
                     lv = taut_norm(x[TAUT_XV]);
        threads[0] = problem->prestress[0] / tension * (area / lu / lu);
        threads[1] = problem->prestress[1] / tension * (area / lv / lv);
    }
}

void taut_film_sheet_threads(const taut_film_sheet *sheet, double u, double v, double threads[2])
{
    taut_film_threads_of(sheet->problem, sheet->surface, sheet->tension, u, v, threads);
}

double taut_film_sheet_stored(const taut_film_sheet *sheet)
{
    taut_sum sum = {0, 0};

    for (int a = 0; a < sheet->u.table->count; a++) {
        taut_film_sheet_line(sheet, a);
        for (int b = 0; b < sheet->v.table->count; b++) {
            taut_film_place place;
            double threads[2];
            taut_film_sheet_place(sheet, a, b, &place);
            taut_film_sheet_threads(sheet, sheet->u.at[a], sheet->v.at[b], threads);
            taut_sum_add(&sum, 0.5 * place.weight * (threads[0] * place.e + threads[1] * place.g));
        }
    }
    return taut_sum_total(&sum);
}

double taut_film_threads_tension(const taut_film_problem *problem)
{
    const double *along = problem->prestress[0] > 0 ? problem->prestress : problem->force_density;
    if (taut_film_sheet_has_threads(problem)) {
        return along[0] > along[1] ? along[0] : along[1];
    }
    return problem->tension > 0 ? problem->tension : 1;
}

/* ---- who moves ---- */

int taut_film_sheet_owner(const taut_film_sheet *sheet, int i, int j)
{
    const taut_film_ring ring = sheet->problem->ring;

    i = sheet->u.period > 0 ? i % sheet->u.period : i;
    j = sheet->v.period > 0 ? j % sheet->v.period : j;
    const int at_edge = ring == TAUT_FILM_RING_U ? (j == 0               ? 2
                                                    : j == sheet->nv - 1 ? 3
                                                                         : -1)
                                                 : (i == 0               ? 0
                                                    : i == sheet->nu - 1 ? 1
                                                                         : -1);
    if (ring != TAUT_FILM_OPEN && at_edge >= 0 &&
        sheet->problem->edges[at_edge].kind == TAUT_FILM_POLE) {
        i = ring == TAUT_FILM_RING_U ? 0 : i;
        j = ring == TAUT_FILM_RING_V ? 0 : j;
    }
    return i * sheet->nv + j;
}

/* The edges that point (i, j) lies on. */
static int edges_at(const taut_film_sheet *sheet, int i, int j, int edges[2])
{
    int count = 0;
    if (sheet->u.period == 0 && (i == 0 || i == sheet->nu - 1)) {
        edges[count++] = i > 0;
    }
    if (sheet->v.period == 0 && (j == 0 || j == sheet->nv - 1)) {
        edges[count++] = 2 + (j > 0);
    }
    return count;
}

taut_film_way taut_film_sheet_way(const taut_film_sheet *sheet, int i, int j, int *edge)
{
    int edges[2] = {-1, -1};
    const int count = edges_at(sheet, i, j, edges);

    *edge = edges[0];
    if (taut_film_sheet_owner(sheet, i, j) != i * sheet->nv + j) {
        return TAUT_FILM_STILL;
    }
    if (count == 2) {
        const int corner = (i > 0) + 2 * (j > 0);
        return sheet->problem->corner_kinds[corner] == TAUT_FILM_HELD ? TAUT_FILM_STILL
                                                                      : TAUT_FILM_CORNER;
    }
    if (count == 0) {
        return TAUT_FILM_INSIDE;
    }
    switch (sheet->problem->edges[edges[0]].kind) {
    case TAUT_FILM_FIXED:
        return TAUT_FILM_STILL;
    case TAUT_FILM_POLE:
        return TAUT_FILM_INSIDE;
    case TAUT_FILM_CABLE:
    case TAUT_FILM_SLIDE:
        break;
    }
    return TAUT_FILM_ALONG;
}

/* One normal more, if it is none of those that are there. */
static int add_normal(const double normal[3], double normals[3][3], int count)
{
    double n[3] = {normal[0], normal[1], normal[2]};

    for (int k = -1; k < count; k++) { /* unit first, then across the others */
        const double size = taut_norm(n);
        for (int c = 0; k < 0 && c < 3; c++) {
            n[c] /= size;
        }
        if (k >= 0) {
            taut_add_scaled(-taut_dot(n, normals[k]), normals[k], n);
        }
    }
    const double left = taut_norm(n);
    if (!(left > 1e-9)) {
        return count;
    }
    for (int c = 0; c < 3; c++) {
        normals[count][c] = n[c] / left;
    }
    return count + 1;
}

static int add_guide(const taut_film_sheet *sheet, int corner, double normals[3][3], int count)
{
    const double *d = sheet->problem->guides[corner].direction;

    if (sheet->problem->corner_kinds[corner] == TAUT_FILM_ON_PLANE) {
        return add_normal(d, normals, count);
    }
    for (int k = 0; sheet->problem->corner_kinds[corner] == TAUT_FILM_ON_LINE && k < 3; k++) {
        const double axis[3] = {k == 0, k == 1, k == 2}, size = taut_norm(d);
        const double unit[3] = {d[0] / size, d[1] / size, d[2] / size};
        double across[3];
        taut_cross(unit, axis, across);
        if (taut_norm(across) > 0.1 && count < 3) {
            count = add_normal(across, normals, count);
        }
    }
    return count;
}

int taut_film_sheet_normals(const taut_film_sheet *sheet, int i, int j, double normals[3][3])
{
    int edges[2] = {-1, -1}, found = 0;
    const int count = edges_at(sheet, i, j, edges);

    for (int k = 0; k < count; k++) {
        const taut_film_edge *edge = &sheet->problem->edges[edges[k]];
        if (taut_film_sheet_in_plane(edge)) {
            found = add_normal(edge->plane.direction, normals, found);
        }
    }
    return count == 2 ? add_guide(sheet, (i > 0) + 2 * (j > 0), normals, found) : found;
}

static void scale_points(taut_film_sheet *sheet)
{
    const double *from = taut_surface_points(sheet->surface);
    const size_t count = taut_point_count(sheet->surface);
    const double half = taut_half_size(count, from);

    sheet->unit = half > 0 ? taut_exponent(half) + 1 : 0;
    memcpy(sheet->origin, from, sizeof sheet->origin);
    for (size_t k = 0; k < 3 * count; k++) {
        sheet->points[k] = ldexp(0.5 * from[k] - 0.5 * from[k % 3], 1 - sheet->unit);
    }
}

/* The chord of edge e, in the user's unit. */
static double find_chord(const taut_surface *surface, int e)
{
    const size_t nu = (size_t)taut_basis_count(taut_surface_u(surface)),
                 nv = (size_t)taut_basis_count(taut_surface_v(surface));
    const size_t first = e == 1 ? (nu - 1) * nv : e == 3 ? nv - 1 : 0;
    const size_t last = first + (e < 2 ? nv - 1 : (nu - 1) * nv);
    const double *points = taut_surface_points(surface);
    return taut_distance(points + 3 * first, points + 3 * last);
}

double taut_film_sheet_given(const taut_surface *surface, const taut_film_problem *problem, int e)
{
    const taut_film_edge *edge = &problem->edges[e];
    if (edge->kind != TAUT_FILM_CABLE || edge->law == TAUT_FILM_FORCE ||
        edge->law == TAUT_FILM_ELASTIC) {
        return 0;
    }
    if (edge->law == TAUT_FILM_LENGTH) {
        return edge->length;
    }
    /* the arc that rises by f of its chord c: tan(a / 2) = 2 f, L = c a / sin a */
    const double a = 2 * taut_atan(2 * edge->sag);
    return find_chord(surface, e) * a / taut_sin(a);
}

/* What the film pulls across edge e with for each unit of what the cable pulls: the multiplier. */
static taut_status find_multiplier(taut_film_sheet *sheet, int e)
{
    const size_t count = (size_t)sheet->nu * (size_t)sheet->nv;
    double *gradient = taut_arena_take(sheet->arena, count, 3 * sizeof(double));
    double *moments = taut_arena_take(sheet->arena, count, 3 * sizeof(double));
    double *pull = taut_arena_take(sheet->arena, count, 3 * sizeof(double));
    double area = 0, largest = 0, lengths[4], both = 0, square = 0;
    size_t first = 0, step = 0;
    int points = 0;

    if (taut_arena_status(sheet->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_film_sheet_gradient(sheet, gradient, moments, &area, &largest, lengths); /* r is 0 yet */
    taut_film_sheet_pull(sheet, e, pull);
    taut_film_sheet_edge(sheet, e, &first, &step, &points);
    for (int k = 0; k < points; k++) {
        const size_t at = first + (size_t)k * step;
        const double *g = gradient + 3 * at;
        double t[3], normals[3][3], p[3] = {pull[3 * k], pull[3 * k + 1], pull[3 * k + 2]};
        int edge = -1;
        if (taut_film_sheet_way(sheet, (int)at / sheet->nv, (int)at % sheet->nv, &edge) !=
            TAUT_FILM_ALONG) {
            continue;
        }
        if (taut_film_sheet_normals(sheet, (int)at / sheet->nv, (int)at % sheet->nv, normals) > 0) {
            taut_add_scaled(-taut_dot(p, normals[0]), normals[0], p);
        }
        taut_film_sheet_tangent(sheet, e, k, t);
        both += taut_dot(g, p) - taut_dot(g, t) * taut_dot(p, t);
        square += taut_dot(p, p) - taut_dot(p, t) * taut_dot(p, t);
    }
    sheet->ratios[e] = -both / square;
    return TAUT_OK;
}

static taut_status find_force(taut_film_sheet *sheet, int e)
{
    const taut_film_edge *edge = &sheet->problem->edges[e];
    if (edge->law == TAUT_FILM_FORCE) {
        sheet->forces[e] = edge->force;
        sheet->ratios[e] = ldexp(edge->force / sheet->tension, -sheet->unit);
        return TAUT_OK;
    }
    if (edge->law != TAUT_FILM_ELASTIC) {
        const taut_status status = find_multiplier(sheet, e);
        sheet->forces[e] = sheet->tension * ldexp(sheet->ratios[e], sheet->unit);
        return status;
    }
    double *pull =
        taut_arena_take(sheet->arena, (size_t)(sheet->nu + sheet->nv), 3 * sizeof(double));
    if (pull == NULL) {
        return TAUT_NO_MEMORY;
    }
    const double length = ldexp(taut_film_sheet_pull(sheet, e, pull), sheet->unit);
    sheet->forces[e] = edge->stiffness * (length - edge->unstressed) / edge->unstressed;
    sheet->ratios[e] = ldexp(sheet->forces[e] / sheet->tension, -sheet->unit);
    sheet->stiffness[e] = edge->stiffness / sheet->tension / edge->unstressed;
    return TAUT_OK;
}

taut_status taut_film_sheet_new(const taut_surface *surface, const taut_film_problem *problem,
                                int extra, taut_arena *arena, taut_film_sheet *sheet)
{
    *sheet = (taut_film_sheet){.arena = arena, .surface = surface, .problem = problem};
    sheet->nu = taut_basis_count(taut_surface_u(surface));
    sheet->nv = taut_basis_count(taut_surface_v(surface));
    sheet->points = taut_arena_take(arena, taut_point_count(surface), 3 * sizeof(double));
    sheet->still = taut_arena_take(arena, (size_t)sheet->nv, 3 * sizeof(double));
    sheet->along = taut_arena_take(arena, (size_t)sheet->nv, 3 * sizeof(double));
    for (int k = 0; k < 3; k++) {
        sheet->back[k] = taut_arena_take(arena, (size_t)sheet->nv, 3 * sizeof(double));
    }
    if (taut_arena_status(arena) != TAUT_OK ||
        make_nodes(taut_surface_u(surface), extra, arena, &sheet->u) != TAUT_OK ||
        make_nodes(taut_surface_v(surface), extra, arena, &sheet->v) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    if ((problem->ring == TAUT_FILM_RING_U &&
         open_nodes(taut_surface_u(surface), arena, &sheet->u) != TAUT_OK) ||
        (problem->ring == TAUT_FILM_RING_V &&
         open_nodes(taut_surface_v(surface), arena, &sheet->v) != TAUT_OK)) {
        return TAUT_NO_MEMORY;
    }
    scale_points(sheet);
    sheet->tension = taut_film_threads_tension(problem);
    for (int e = 0; e < 4; e++) {
        if (taut_film_sheet_is_cable(sheet, e) && find_force(sheet, e) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
    }
    return TAUT_OK;
}

void taut_film_sheet_tangent(const taut_film_sheet *sheet, int e, int k, double t[3])
{
    const taut_basis *basis =
        e < 2 ? taut_surface_v(sheet->surface) : taut_surface_u(sheet->surface);
    const int degree = taut_basis_degree(basis), n = taut_basis_count(basis);
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    double values[2 * (TAUT_DEGREE_MAX + 1)], at = 0;
    size_t first = 0, step = 0;
    int count = 0;
    taut_basis_spec spec;

    taut_basis_spec_of(basis, &spec);
    for (int p = 1; p <= degree; p++) {
        at += (spec.knots != NULL ? spec.knots[k + p] : lo) / degree;
    }
    if (sheet->problem->ring != TAUT_FILM_OPEN) {
        at = taut_loop_greville(basis, k);
    }
    at = spec.knots != NULL ? fmin(hi, fmax(lo, at)) : lo + (hi - lo) * k / (n - 1);
    const int span = taut_basis_span(basis, at);
    memset(t, 0, 3 * sizeof(double));
    if (taut_basis_eval(basis, span, at, 1, values) != TAUT_OK) {
        return;
    }
    taut_film_sheet_edge(sheet, e, &first, &step, &count);
    for (int a = 0; a <= degree; a++) {
        taut_add_scaled(
            values[degree + 1 + a],
            sheet->points + 3 * (first + (size_t)(taut_basis_first(basis, span) + a) * step), t);
    }
    const double size = taut_norm(t);
    for (int c = 0; c < 3 && size > 0; c++) {
        t[c] /= size;
    }
}

void taut_film_sheet_line(const taut_film_sheet *sheet, int a)
{
    const taut_table *u = sheet->u.table;
    const double *n = taut_table_row(u, a, 0), *d = taut_table_row(u, a, 1);
    const size_t numbers = 3 * (size_t)sheet->nv;

    memset(sheet->still, 0, numbers * sizeof(double));
    memset(sheet->along, 0, numbers * sizeof(double));
    for (int i = 0; i < u->local; i++) {
        const double *row = sheet->points + numbers * (size_t)(u->first[a] + i);
        for (size_t k = 0; k < numbers; k++) {
            sheet->still[k] += n[i] * row[k];
            sheet->along[k] += d[i] * row[k];
        }
    }
}

void taut_film_sheet_place(const taut_film_sheet *sheet, int a, int b, taut_film_place *place)
{
    const taut_table *v = sheet->v.table;
    const double *m = taut_table_row(v, b, 0), *s = taut_table_row(v, b, 1);
    const size_t first = 3 * (size_t)v->first[b];

    *place = (taut_film_place){.weight = sheet->u.weights[a] * sheet->v.weights[b]};
    for (size_t j = 0; j < (size_t)v->local; j++) {
        for (size_t c = 0; c < 3; c++) {
            place->u[c] += m[j] * sheet->along[first + 3 * j + c];
            place->v[c] += s[j] * sheet->still[first + 3 * j + c];
        }
    }
    taut_cross(place->u, place->v, place->normal);
    place->e = taut_dot(place->u, place->u);
    place->f = taut_dot(place->u, place->v);
    place->g = taut_dot(place->v, place->v);
    place->w = taut_length(place->normal);
}

void taut_film_sheet_edge(const taut_film_sheet *sheet, int e, size_t *first, size_t *step,
                          int *count)
{
    const size_t nv = (size_t)sheet->nv;
    *first = e == 1 ? (size_t)(sheet->nu - 1) * nv : e == 3 ? nv - 1 : 0;
    *step = e < 2 ? 1 : nv;
    *count = e < 2 ? sheet->nv : sheet->nu;
}

void taut_film_sheet_slope(const taut_film_sheet *sheet, int e, int node, double d[3])
{
    const taut_table *t = e < 2 ? sheet->v.table : sheet->u.table;
    const double *slopes = taut_table_row(t, node, 1);
    size_t first = 0, step = 0;
    int count = 0;

    taut_film_sheet_edge(sheet, e, &first, &step, &count);
    memset(d, 0, 3 * sizeof(double));
    for (int k = 0; k < t->local; k++) {
        const size_t at = first + (size_t)(t->first[node] + k) * step;
        taut_add_scaled(slopes[k], sheet->points + 3 * at, d);
    }
}

/* The two fluxes and the normal go back to the functions of v that are alive at the node. */
static void spread_place(const taut_film_sheet *sheet, int a, int b, const taut_film_place *p)
{
    const taut_table *v = sheet->v.moves;
    const double *m = taut_table_row(v, b, 0), *s = taut_table_row(v, b, 1);
    double along_u[3], along_v[3], threads[2];

    for (int c = 0; c < 3; c++) {
        along_u[c] = p->weight * (p->g * p->u[c] - p->f * p->v[c]) / p->w;
        along_v[c] = p->weight * (p->e * p->v[c] - p->f * p->u[c]) / p->w;
    }
    if (taut_film_sheet_has_threads(sheet->problem)) {
        taut_film_sheet_threads(sheet, sheet->u.at[a], sheet->v.at[b], threads);
        for (int c = 0; c < 3; c++) {
            along_u[c] = p->weight * threads[0] * p->u[c];
            along_v[c] = p->weight * threads[1] * p->v[c];
        }
    }
    for (int j = 0; j < v->local; j++) {
        const size_t at = 3 * (size_t)(v->first[b] + j);
        taut_add_scaled(m[j], along_u, sheet->back[0] + at);
        taut_add_scaled(s[j], along_v, sheet->back[1] + at);
        taut_add_scaled(p->weight * m[j], p->normal, sheet->back[2] + at);
    }
}

/* And from there to the points that are alive on the line. */
static void spread_line(const taut_film_sheet *sheet, int a, double *gradient, double *moments)
{
    const taut_table *u = sheet->u.moves;
    const double *n = taut_table_row(u, a, 0), *d = taut_table_row(u, a, 1);

    for (int i = 0; i < u->local; i++) {
        for (int j = 0; j < sheet->nv; j++) {
            const size_t at = 3 * (size_t)j;
            const size_t owner = (size_t)taut_film_sheet_owner(sheet, u->first[a] + i, j);
            taut_add_scaled(d[i], sheet->back[0] + at, gradient + 3 * owner);
            taut_add_scaled(n[i], sheet->back[1] + at, gradient + 3 * owner);
            taut_add_scaled(n[i], sheet->back[2] + at, moments + 3 * owner);
        }
    }
}

/* net += r dL of the cable of edge e, its points at first, first + step, ..; its length. */
static double add_cable(const taut_film_sheet *sheet, int e, double r, size_t from, size_t by,
                        double *net)
{
    const taut_film_nodes *nodes = e < 2 ? &sheet->v : &sheet->u;
    const taut_table *t = nodes->moves;
    taut_sum sum = {0, 0};

    for (int node = 0; node < t->count; node++) {
        const double *slopes = taut_table_row(t, node, 1);
        double d[3];
        taut_film_sheet_slope(sheet, e, node, d);
        const double speed = taut_length(d);
        taut_sum_add(&sum, nodes->weights[node] * speed);
        for (int k = 0; k < t->local; k++) {
            const int own = t->first[node] + k;
            const size_t at = from + (size_t)(nodes->period > 0 ? own % nodes->period : own) * by;
            taut_add_scaled(r * nodes->weights[node] * slopes[k] / speed, d, net + 3 * at);
        }
    }
    return taut_sum_total(&sum);
}

double taut_film_sheet_pull(const taut_film_sheet *sheet, int e, double *pull)
{
    memset(pull, 0, 3 * (size_t)(e < 2 ? sheet->nv : sheet->nu) * sizeof(double));
    return add_cable(sheet, e, 1, 0, 1, pull);
}

void taut_film_sheet_gradient(const taut_film_sheet *sheet, double *gradient, double *moments,
                              double *area, double *largest, double lengths[4])
{
    const size_t count = (size_t)sheet->nu * (size_t)sheet->nv;
    const size_t size = 3 * count * sizeof(double);
    taut_sum sum = {0, 0};

    memset(gradient, 0, size);
    memset(moments, 0, size);
    for (int a = 0; a < sheet->u.table->count; a++) {
        taut_film_sheet_line(sheet, a);
        for (int k = 0; k < 3; k++) {
            memset(sheet->back[k], 0, 3 * (size_t)sheet->nv * sizeof(double));
        }
        for (int b = 0; b < sheet->v.table->count; b++) {
            taut_film_place place;
            taut_film_sheet_place(sheet, a, b, &place);
            taut_sum_add(&sum, place.weight * place.w);
            spread_place(sheet, a, b, &place);
        }
        spread_line(sheet, a, gradient, moments);
    }
    *area = taut_sum_total(&sum);
    *largest = 0;
    for (size_t k = 0; k < count; k++) {
        *largest = taut_certify_max(*largest, taut_largest_coordinate(gradient + 3 * k));
    }
    for (int e = 0; e < 4; e++) {
        size_t first = 0, step = 0;
        int on_edge = 0;
        taut_film_sheet_edge(sheet, e, &first, &step, &on_edge);
        lengths[e] = taut_film_sheet_is_cable(sheet, e)
                         ? add_cable(sheet, e, sheet->ratios[e], first, step, gradient)
                         : 0;
    }
}
