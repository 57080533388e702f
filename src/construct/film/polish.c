#include "construct/film/polish.h"

#include "construct/film/greville.h"
#include "construct/plateau/hessian_band.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { STEPS = 8 };
static const double enough = 1e-14;  /* residual: rounding from here on */
static const double stiffness = 1e4; /* over the largest of H: what is left moves 1e-4 a step */

typedef struct work {
    taut_area_functional *functional;
    const taut_film_space *space;
    const taut_mask *mask;
    size_t count;
    double *net, *gradient, *step, *before; /* [nu][nv][3] */
    double *directions;                     /* [nu][nv][3][3] */
    double *moments;                        /* [nu][nv][3] */
    double any;                             /* of the last look */
} work;

static void make_unit(double x[3])
{
    const double size = taut_length(x);
    for (int c = 0; c < 3; c++) {
        x[c] = size > 0 ? x[c] / size : 0;
    }
}

/* x_u x x_v times the weight at Gauss point (line, k). */
static void weighted_normal(const work *w, int line, int k, double normal[3])
{
    const taut_area_axis *u = &w->functional->u, *v = &w->functional->v;
    const double *n = u->value + line * u->local, *d = u->slope + line * u->local;
    const double *m = v->value + k * v->local, *s = v->slope + k * v->local;
    double xu[3] = {0, 0, 0}, xv[3] = {0, 0, 0};

    for (int a = 0; a < u->local; a++) {
        const double *row =
            w->net + 3 * ((size_t)(u->first[line] + a) * (size_t)w->mask->nv + (size_t)v->first[k]);
        double still[3] = {0, 0, 0}, along[3] = {0, 0, 0};
        for (int b = 0; b < v->local; b++) {
            taut_add_scaled(m[b], row + 3 * b, still);
            taut_add_scaled(s[b], row + 3 * b, along);
        }
        taut_add_scaled(d[a], still, xu);
        taut_add_scaled(n[a], along, xv);
    }
    taut_cross(xu, xv, normal);
    for (int c = 0; c < 3; c++) {
        normal[c] *= u->weights[line] * v->weights[k];
    }
}

static void find_moments(work *w)
{
    const taut_area_axis *u = &w->functional->u, *v = &w->functional->v;

    memset(w->moments, 0, 3 * w->count * sizeof(double));
    for (int line = 0; line < u->count; line++) {
        for (int k = 0; k < v->count; k++) {
            double normal[3];
            weighted_normal(w, line, k, normal);
            for (int p = 0; p < u->local * v->local; p++) {
                const int a = p / v->local, b = p % v->local;
                const size_t at =
                    (size_t)(u->first[line] + a) * (size_t)w->mask->nv + (size_t)(v->first[k] + b);
                taut_add_scaled(u->value[line * u->local + a] * v->value[k * v->local + b], normal,
                                w->moments + 3 * at);
            }
        }
    }
    taut_mask_reduce(w->mask, w->moments);
}

/* Up to three vectors become unit and orthogonal, the longest first; what is left of the others beside it
 * is nothing where it is small. */
static void orthonormalise(double (*d)[3])
{
    const double small = 1e-6;

    for (int k = 0; k < 3; k++) {
        int longest = k;
        for (int m = k + 1; m < 3; m++) {
            longest = taut_length(d[m]) > taut_length(d[longest]) ? m : longest;
        }
        double x[3];
        memcpy(x, d[longest], sizeof x);
        memcpy(d[longest], d[k], sizeof x);
        const double size = taut_length(x);
        for (int c = 0; c < 3; c++) {
            d[k][c] = size > small ? x[c] / size : 0;
        }
        for (int m = k + 1; m < 3; m++) {
            taut_add_scaled(-taut_dot(d[k], d[m]), d[k], d[m]);
        }
    }
}

/* The directions of point `at`, unit or 0, become what is allowed of them. */
static void allow(work *w, size_t at)
{
    double(*d)[3] = (double(*)[3])(w->directions + 9 * at);

    if (w->mask->allowed == NULL) {
        return;
    }
    for (int k = 0; k < 3; k++) {
        taut_mask_project(w->mask->allowed + 6 * at, d[k]);
    }
    orthonormalise(d);
}

/* x_t on the edge at the Greville abscissa of its function k. */
static void find_tangent(const work *w, const taut_basis *basis, double greville, size_t first,
                         size_t step, int k, double t[3])
{
    const taut_loop *around = w->space->around;
    double values[2 * (TAUT_DEGREE_MAX + 1)];
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const double where =
        around != NULL ? taut_loop_greville(basis, k) : fmin(hi, lo + greville * (hi - lo));
    const int span = taut_basis_span(basis, where), local = taut_basis_local(basis);
    const int alive = taut_basis_first(basis, span);

    memset(t, 0, 3 * sizeof(double));
    if (taut_basis_eval(basis, span, where, 1, values) != TAUT_OK) {
        return;
    }
    if (around != NULL) {
        taut_loop_open(around, alive, values + local);
    }
    for (int a = 0; a < local; a++) {
        taut_add_scaled(values[local + a], w->net + 3 * (first + (size_t)(alive + a) * step), t);
    }
    make_unit(t);
}

/* Two directions across the tangent. */
static void lay_across(work *w, const double t[3], size_t at)
{
    double axis[3] = {0, 0, 0}, *p = w->directions + 9 * at, *q = p + 3;
    const double x = fabs(t[0]), y = fabs(t[1]), z = fabs(t[2]);

    axis[x <= y && x <= z ? 0 : y <= z ? 1 : 2] = 1; /* least along the tangent */
    taut_cross(t, axis, p);
    make_unit(p);
    taut_cross(t, p, q);
    allow(w, at);
}

static void lay_edge(work *w, int e, const taut_basis *basis, const double *greville)
{
    const taut_loop *around = w->space->around;
    size_t first = 0, step = 0;
    int count = 0;

    taut_film_edge_points(w->mask->nu, w->mask->nv, e, &first, &step, &count);
    const int begin = around != NULL ? 0 : 1, end = around != NULL ? around->period : count - 1;
    for (int k = begin; k < end; k++) {
        double t[3];
        find_tangent(w, basis, greville[k], first, step, k, t);
        lay_across(w, t, first + (size_t)k * step);
    }
}

/* A point that moves in every way that is allowed. */
static void lay_vertex(work *w, size_t at)
{
    double *d = w->directions + 9 * at;

    for (int c = 0; c < 9 && !w->mask->known[at]; c++) {
        d[c] = c % 4 == 0;
    }
    allow(w, at);
}

static void find_directions(work *w, const taut_basis *bases[2], double *const greville[2])
{
    const taut_film_problem *problem = w->space->problem;
    const size_t nu = (size_t)w->mask->nu, nv = (size_t)w->mask->nv;

    find_moments(w);
    memset(w->directions, 0, 9 * w->count * sizeof(double));
    for (size_t i = 0; i < w->count; i++) {
        memcpy(w->directions + 9 * i, w->moments + 3 * i, 3 * sizeof(double));
        make_unit(w->directions + 9 * i);
        if (taut_film_has_density(problem)) {
            lay_vertex(w, i);
        }
    }
    for (int e = 0; e < 4 && !taut_film_has_density(problem); e++) {
        const taut_film_edge_kind kind = problem->edges[e].kind;
        if (taut_film_has_edge(problem, e) &&
            (kind == TAUT_FILM_CABLE || kind == TAUT_FILM_SLIDE)) {
            lay_edge(w, e, bases[e < 2], greville[e < 2]);
        }
    }
    for (size_t c = 0; problem->ring == TAUT_FILM_OPEN && c < 4; c++) {
        lay_vertex(w, c % 2 * (nu - 1) * nv + c / 2 * (nv - 1));
    }
}

/* The gradient of the net, its part along the directions in `step`, and what that is of all; `any`: what the largest
 * derivative is of all, in whatever way is allowed. */
static double look(work *w)
{
    double along = 0, all = 0, any = 0;

    taut_area_functional_gradient(w->functional, w->net, w->gradient);
    memset(w->step, 0, 3 * w->count * sizeof(double));
    for (size_t i = 0; i < w->count; i++) {
        all = fmax(all, taut_largest_coordinate(w->gradient + 3 * i));
    }
    taut_mask_reduce(w->mask, w->gradient);
    for (size_t i = 0; i < w->count; i++) {
        const double *g = w->gradient + 3 * i;
        any = fmax(any, taut_largest_coordinate(g));
        for (int k = 0; k < 3 && !w->mask->known[i]; k++) {
            const double *p = w->directions + 9 * i + 3 * k;
            const double size = taut_dot(g, p);
            along = fmax(along, fabs(size));
            taut_add_scaled(size, p, w->step + 3 * i);
        }
    }
    w->any = all > 0 ? any / all : 0;
    return all > 0 ? along / all : 0;
}

static taut_status polish(work *w, taut_area_hessian *hessian, double residual[3])
{
    double found = look(w);

    residual[0] = found;
    for (int k = 0; k < STEPS && found > enough; k++) {
        taut_area_hessian_assemble(hessian, w->functional);
        taut_area_hessian_stiffen(hessian, w->directions, stiffness);
        if (taut_area_hessian_factor(hessian, 0) != TAUT_OK) {
            break;
        }
        taut_area_hessian_solve(hessian, w->step);
        memcpy(w->before, w->net, 3 * w->count * sizeof(double));
        for (size_t i = 0; i < 3 * w->count; i++) {
            w->net[i] -= w->step[i];
        }
        const double next = look(w);
        if (!(next < 0.5 * found)) { /* rounding, or no minimum along these moves */
            memcpy(w->net, w->before, 3 * w->count * sizeof(double));
            break;
        }
        found = next;
    }
    residual[1] = found;
    look(w);
    residual[2] = w->any;
    return TAUT_OK;
}

/* net = dL of a cable. */
static void lay_pull(const work *w, const taut_area_cable *cable, double *net)
{
    memset(net, 0, 3 * w->count * sizeof(double));
    for (int k = 0; k < cable->count; k++) {
        const size_t at = cable->first + (size_t)k * cable->step;
        memcpy(net + 3 * at, cable->pull + 3 * k, 3 * sizeof(double));
    }
    taut_mask_reduce(w->mask, net);
}

static taut_status respond(work *w, taut_area_hessian *hessian, double response[4][4])
{
    look(w);
    taut_area_hessian_assemble(hessian, w->functional);
    taut_area_hessian_stiffen(hessian, w->directions, stiffness);
    if (taut_area_hessian_factor(hessian, 0) != TAUT_OK) {
        return TAUT_NO_SOLUTION;
    }
    for (int l = 0; l < w->functional->cable_count; l++) {
        const taut_area_cable *cable = w->functional->cables + l;
        if (cable->stiffness == 0) {
            continue;
        }
        lay_pull(w, cable, w->step);
        taut_area_hessian_solve(hessian, w->step);
        for (int k = 0; k < w->functional->cable_count; k++) {
            const taut_area_cable *other = w->functional->cables + k;
            response[k][l] = 0;
            for (int i = 0; i < other->count && other->stiffness > 0; i++) {
                response[k][l] += taut_dot(other->pull + 3 * i,
                                           w->step + 3 * (other->first + (size_t)i * other->step));
            }
        }
    }
    return TAUT_OK;
}

/* Arrays, directions, the matrix: what both calls below begin with. */
static taut_status prepare(work *w, taut_arena *arena, taut_area_hessian **hessian)
{
    const taut_mask *mask = w->mask;
    const taut_basis *bases[2] = {w->space->problem->u, w->space->problem->v};
    double *greville[2];

    w->count = (size_t)mask->nu * (size_t)mask->nv;
    w->gradient = taut_arena_take(arena, w->count, 3 * sizeof(double));
    w->step = taut_arena_take(arena, w->count, 3 * sizeof(double));
    w->before = taut_arena_take(arena, w->count, 3 * sizeof(double));
    w->moments = taut_arena_take(arena, w->count, 3 * sizeof(double));
    w->directions = taut_arena_take(arena, w->count, 9 * sizeof(double));
    greville[0] = taut_arena_take(arena, (size_t)mask->nu, sizeof(double));
    greville[1] = taut_arena_take(arena, (size_t)mask->nv, sizeof(double));
    taut_status status = taut_arena_status(arena);
    if (status == TAUT_OK) {
        status = taut_area_hessian_new(w->functional, mask, hessian);
    }
    if (status == TAUT_OK) {
        taut_film_greville(bases[0], greville[0]);
        taut_film_greville(bases[1], greville[1]);
        find_directions(w, bases, greville);
    }
    return status;
}

taut_status taut_film_respond(taut_area_functional *functional, const taut_film_space *space,
                              double *net, double response[4][4])
{
    work w = {.functional = functional, .space = space, .mask = &space->mask, .net = net};
    taut_area_hessian *hessian = NULL;

    if (!taut_area_hessian_pays(functional, w.mask)) {
        return TAUT_NO_SOLUTION;
    }
    taut_arena *arena = taut_arena_new();
    taut_status status = prepare(&w, arena, &hessian);
    if (status == TAUT_OK) {
        status = respond(&w, hessian, response);
    }
    taut_area_hessian_free(hessian);
    taut_arena_free(arena);
    return status;
}

taut_status taut_film_polish(taut_area_functional *functional, const taut_film_space *space,
                             double *net, double residual[3])
{
    work w = {.functional = functional, .space = space, .mask = &space->mask, .net = net};
    taut_area_hessian *hessian = NULL;

    residual[0] = residual[1] = residual[2] = 0;
    if (!taut_area_hessian_pays(functional, w.mask)) {
        return TAUT_OK;
    }
    taut_arena *arena = taut_arena_new();
    taut_status status = prepare(&w, arena, &hessian);
    if (status == TAUT_OK) {
        status = polish(&w, hessian, residual);
    }
    taut_area_hessian_free(hessian);
    taut_arena_free(arena);
    return status;
}
