#include "construct/film/polish.h"

#include "construct/film/greville.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/memory.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { STEPS = 8, INVERSIONS = 40 };
static const double enough = 1e-14; /* residual: rounding from here on */
static const double residual_far = 10,
                    enough_far =
                        1e-12; /* what steps in all coordinates may leave along the moves: times
                                                               * what there was, or so much */
static const double falls =
    0.25; /* of a step's length: the least share of the residual that it has to take */
static const double falls_again = 0.1; /* of the residual: what a step by older factors may leave */
static const double gauge_most = 0.1;
static const double strong =
    32; /* over the film: more that cables draw with hides nothing inside */
static const double gauge = 1e-6; /* of the metric, in steps in all coordinates */
static const double gauge_enough = 1e-9,
                    residual_near = 1e-8; /* residuals: of all coordinates; along the moves */
static const double step_longest = 0.3,
                    step_shortest =
                        0x1p-7;      /* of a step: 0.15 of the size; shares of it that are tried */
static const double stiffness = 1e4; /* over the largest of H: what is left moves 1e-4 a step */

typedef struct work {
    taut_area_functional *functional;
    const taut_film_space *space;
    const taut_mask *mask;
    size_t count;
    double *net, *gradient, *step, *before, *tried, *kept; /* [nu][nv][3] */
    double *directions;                                    /* [nu][nv][3][3] */
    double *moments;                                       /* [nu][nv][3] */
    double *rows;                                          /* [3][nv][3] */
    double any, all, area;                                 /* of the last look */
    double alone; /* the largest derivative of the film without cables, or 0 */
    const taut_basis *bases[2];
    double *greville[2];
} work;

static void make_unit(double x[3])
{
    const double size = taut_length(x);
    for (int c = 0; c < 3; c++) {
        x[c] = size > 0 ? x[c] / size : 0;
    }
}

/* x and x_u on line u = const, as functions of v: by the points of a row of the net. */
static void find_row(const work *w, int line, double *still, double *along)
{
    const taut_area_axis *u = &w->functional->u;
    const size_t numbers = 3 * (size_t)w->mask->nv;

    memset(still, 0, numbers * sizeof(double));
    memset(along, 0, numbers * sizeof(double));
    for (int a = 0; a < u->local; a++) {
        const double n = u->value[line * u->local + a], d = u->slope[line * u->local + a];
        const double *row = w->net + numbers * (size_t)(u->first[line] + a);
        for (size_t i = 0; i < numbers; i++) {
            still[i] += n * row[i];
            along[i] += d * row[i];
        }
    }
}

/* x_u x x_v times the weight at Gauss point (line, k), of the row on that line. */
static void weighted_normal(const work *w, int line, int k, const double *still,
                            const double *along, double normal[3])
{
    const taut_area_axis *u = &w->functional->u, *v = &w->functional->v;
    const double *m = v->value + k * v->local, *s = v->slope + k * v->local;
    const size_t first = 3 * (size_t)v->first[k];
    double xu[3] = {0, 0, 0}, xv[3] = {0, 0, 0};

    for (size_t b = 0; b < (size_t)v->local; b++) {
        for (size_t c = 0; c < 3; c++) {
            xu[c] += m[b] * along[first + 3 * b + c];
            xv[c] += s[b] * still[first + 3 * b + c];
        }
    }
    taut_cross(xu, xv, normal);
    for (int c = 0; c < 3; c++) {
        normal[c] *= u->weights[line] * v->weights[k];
    }
}

/* to[j] += sum over the nodes of a line of N_j(v) what is there, [nodes][3]. */
static void spread_node(const work *w, int k, const double x[3], double *to)
{
    const taut_area_axis *v = &w->functional->v;
    double *at = to + 3 * (size_t)v->first[k];

    for (int b = 0; b < v->local; b++) {
        taut_add_scaled(v->value[k * v->local + b], x, at + 3 * b);
    }
}

/* net += N_i(u) row on that line. */
static void spread_row(const work *w, int line, const double *row, double *net)
{
    const taut_area_axis *u = &w->functional->u;
    const size_t numbers = 3 * (size_t)w->mask->nv;

    for (int a = 0; a < u->local; a++) {
        const double n = u->value[line * u->local + a];
        double *to = net + numbers * (size_t)(u->first[line] + a);
        for (size_t i = 0; i < numbers; i++) {
            to[i] += n * row[i];
        }
    }
}

static void find_moments(work *w)
{
    const size_t row = 3 * (size_t)w->mask->nv;
    double *const still = w->rows, *const along = w->rows + row, *const back = w->rows + 2 * row;

    memset(w->moments, 0, 3 * w->count * sizeof(double));
    for (int line = 0; line < w->functional->u.count; line++) {
        find_row(w, line, still, along);
        memset(back, 0, row * sizeof(double));
        for (int k = 0; k < w->functional->v.count; k++) {
            double normal[3];
            weighted_normal(w, line, k, still, along, normal);
            spread_node(w, k, normal, back);
        }
        spread_row(w, line, back, w->moments);
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

static void find_directions(work *w)
{
    const taut_basis **bases = w->bases;
    double *const *greville = w->greville;
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

/* Is point i on a cable? */
static int is_drawn(const work *w, size_t i)
{
    const double *ratios = w->space->ratios;
    const size_t nv = (size_t)w->mask->nv, row = i / nv, column = i % nv;
    return (ratios[0] > 0 && row == 0) || (ratios[1] > 0 && row == (size_t)w->mask->nu - 1) ||
           (ratios[2] > 0 && column == 0) || (ratios[3] > 0 && column == nv - 1);
}

/* The gradient of the net, its part along the directions in `step`, and what that is of all; `any`: what the largest
 * derivative is of all, in whatever way is allowed. */
static double look(work *w)
{
    double along = 0, all = 0, any = 0;

    w->area = taut_area_functional_gradient(w->functional, w->net, w->gradient).area;
    memset(w->step, 0, 3 * w->count * sizeof(double));
    for (size_t i = 0; i < w->count; i++) {
        all = fmax(all, taut_largest_coordinate(w->gradient + 3 * i));
    }
    taut_mask_reduce(w->mask, w->gradient);
    const double inner = w->alone > 0 ? fmax(1, all / (strong * w->alone)) : 1;
    for (size_t i = 0; i < w->count; i++) {
        const double *g = w->gradient + 3 * i;
        any = fmax(any, taut_largest_coordinate(g));
        for (int k = 0; k < 3 && !w->mask->known[i]; k++) {
            const double *p = w->directions + 9 * i + 3 * k;
            const double size = taut_dot(g, p);
            along = fmax(along, fabs(size) * (is_drawn(w, i) ? 1 : inner));
            taut_add_scaled(size, p, w->step + 3 * i);
        }
    }
    w->any = all > 0 ? any / all : 0;
    w->all = all;
    return all > 0 ? along / all : 0;
}

/* net -= the step by the factors: the residual then; the net before is kept. */
static double make_step(work *w, taut_area_hessian *factors)
{
    taut_area_hessian_solve(factors, w->step);
    memcpy(w->before, w->net, 3 * w->count * sizeof(double));
    for (size_t i = 0; i < 3 * w->count; i++) {
        w->net[i] -= w->step[i];
    }
    return look(w);
}

/* The largest derivative in the net of the film without its cables. */
static double film_alone(work *w)
{
    const int cables = w->functional->cable_count;
    double largest = 0;

    w->functional->cable_count = 0;
    taut_area_functional_gradient(w->functional, w->net, w->gradient);
    w->functional->cable_count = cables;
    for (size_t i = 0; i < w->count; i++) {
        largest = fmax(largest, taut_largest_coordinate(w->gradient + 3 * i));
    }
    return largest;
}

static void undo_step(work *w)
{
    memcpy(w->net, w->before, 3 * w->count * sizeof(double));
    look(w);
}

/* Factors of the net as it is, in the place of those in memory. */
static taut_status renew_factors(work *w, taut_film_memory *memory)
{
    taut_area_hessian_free(memory->factors);
    memory->factors = NULL;
    taut_status status = taut_area_hessian_new(w->functional, w->mask, &memory->factors);
    if (status == TAUT_OK) {
        taut_area_hessian_assemble(memory->factors, w->functional);
        taut_area_hessian_stiffen(memory->factors, w->directions, stiffness);
        status = taut_area_hessian_factor(memory->factors, 0);
    }
    if (status != TAUT_OK) {
        taut_area_hessian_free(memory->factors);
        memory->factors = NULL;
    }
    return status;
}

/* Steps by the factors in memory for as long as each takes nearly all of the residual; returns what is left. */
static double polish_again(work *w, taut_area_hessian *factors, double least, double found)
{
    for (int k = 0; k < STEPS && found > fmax(least, enough); k++) {
        const double next = make_step(w, factors);
        if (!(next < falls_again * found)) {
            undo_step(w);
            break;
        }
        found = next;
    }
    return found;
}

static taut_status polish(work *w, taut_film_memory *memory, double least,
                          taut_film_polished *result, int *is_definite)
{
    double found = result->first = look(w);
    taut_status status = TAUT_OK;

    if (memory->factors != NULL) {
        found = polish_again(w, memory->factors, least, found);
    }
    for (int k = 0; k < STEPS && found > fmax(least, enough); k++) {
        status = renew_factors(w, memory);
        *is_definite = status == TAUT_OK && taut_area_hessian_is_definite(memory->factors);
        if (status != TAUT_OK) {
            break;
        }
        const double next = make_step(w, memory->factors);
        if (!(next < 0.5 * found)) { /* rounding, or no minimum along these moves */
            undo_step(w);
            break;
        }
        found = polish_again(w, memory->factors, least, next);
    }
    result->residual = found;
    result->any = memory->scale > 0 ? w->any * w->all / memory->scale : w->any;
    result->area = w->area;
    return status == TAUT_NO_MEMORY || status == TAUT_INTERRUPTED ? status : TAUT_OK;
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
    const taut_status status = taut_area_hessian_factor(hessian, 0);
    if (status != TAUT_OK) {
        return status;
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

/* Arrays: what all calls below begin with. */
static taut_status take_arrays(work *w, taut_arena *arena)
{
    const taut_mask *mask = w->mask;

    w->bases[0] = w->space->problem->u;
    w->bases[1] = w->space->problem->v;
    w->count = (size_t)mask->nu * (size_t)mask->nv;
    w->gradient = taut_arena_take(arena, w->count, 3 * sizeof(double));
    w->step = taut_arena_take(arena, w->count, 3 * sizeof(double));
    w->before = taut_arena_take(arena, w->count, 3 * sizeof(double));
    w->tried = taut_arena_take(arena, w->count, 3 * sizeof(double));
    w->kept = taut_arena_take(arena, w->count, 3 * sizeof(double));
    w->moments = taut_arena_take(arena, w->count, 3 * sizeof(double));
    w->rows = taut_arena_take(arena, (size_t)mask->nv, 9 * sizeof(double));
    w->greville[0] = taut_arena_take(arena, (size_t)mask->nu, sizeof(double));
    w->greville[1] = taut_arena_take(arena, (size_t)mask->nv, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_film_greville(w->bases[0], w->greville[0]);
    taut_film_greville(w->bases[1], w->greville[1]);
    return TAUT_OK;
}

/* The same, directions and the matrix. */
static taut_status prepare(work *w, taut_arena *arena, taut_area_hessian **hessian)
{
    taut_status status = take_arrays(w, arena);

    if (status == TAUT_OK) {
        w->directions = taut_arena_take(arena, w->count, 9 * sizeof(double));
        status = taut_arena_status(arena);
    }
    if (status == TAUT_OK) {
        status = taut_area_hessian_new(w->functional, w->mask, hessian);
    }
    if (status == TAUT_OK) {
        find_directions(w);
    }
    return status;
}

taut_status taut_film_respond(taut_area_functional *functional, const taut_film_space *space,
                              double *net, double response[4][4])
{
    work w = {.functional = functional, .space = space, .mask = &space->mask, .net = net};
    taut_area_hessian *hessian = NULL;

    taut_arena *arena = taut_arena_new();
    taut_status status = prepare(&w, arena, &hessian);
    if (status == TAUT_OK) {
        status = respond(&w, hessian, response);
    }
    taut_area_hessian_free(hessian);
    taut_arena_free(arena);
    return status;
}

void taut_film_memory_clear(taut_film_memory *memory)
{
    taut_area_hessian_free(memory->factors);
    taut_free(memory->directions);
    *memory = (taut_film_memory){.factors = NULL};
}

taut_status taut_film_polish(taut_area_functional *functional, const taut_film_space *space,
                             double *net, double least, taut_film_memory *memory,
                             taut_film_polished *found, int *is_definite)
{
    work w = {.functional = functional, .space = space, .mask = &space->mask, .net = net};

    *found = (taut_film_polished){.first = 0};
    taut_arena *arena = taut_arena_new();
    taut_status status = take_arrays(&w, arena);
    const int is_new = memory->directions == NULL;
    /* where the other coordinates are not at rest, the directions of a net are its own */
    const int follows = space->problem->method == TAUT_FILM_NORMAL;
    if (status == TAUT_OK && is_new) {
        memory->directions = taut_alloc_zero(w.count, 9 * sizeof(double));
        status = memory->directions != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    }
    w.directions = memory->directions;
    if (status == TAUT_OK && (is_new || follows)) {
        find_directions(&w);
    }
    if (status == TAUT_OK && is_new) {
        memory->scale = film_alone(&w);
    }
    w.alone = memory->scale;
    if (status == TAUT_OK) {
        status = polish(&w, memory, least, found, is_definite);
    }
    if (status == TAUT_OK && follows) {
        find_directions(&w);
        found->residual = look(&w);
    }
    taut_arena_free(arena);
    return status;
}

/* ---- films at rest that may be no minimum ---- */

/* How far the largest part of a step takes a point. */
static double largest_move(const work *w)
{
    double largest = 0;
    for (size_t i = 0; i < w->count; i++) {
        largest = fmax(largest, taut_length(w->step + 3 * i));
    }
    return largest;
}

/* Along the moves, or in all coordinates that are allowed: the residual; the gradient is in `step`. */
static double look_at(work *w, int all)
{
    if (!all) {
        find_directions(w);
    }
    const double along = look(w);
    if (all) {
        memcpy(w->step, w->gradient, 3 * w->count * sizeof(double));
    }
    return all ? w->any : along;
}

/* One step of Newton's, shortened until the residual falls: 0 where it does not. */
static int step_nearer(work *w, taut_area_hessian *hessian, int all, double theta, double *found)
{
    int negative = 0;

    taut_area_hessian_assemble(hessian, w->functional);
    if (!all) {
        taut_area_hessian_stiffen(hessian, w->directions, stiffness);
    }
    if (taut_area_hessian_factor_any(hessian, theta, NULL, &negative) != TAUT_OK) {
        return 0;
    }
    taut_area_hessian_solve(hessian, w->step);
    taut_mask_follow(w->mask, w->step);
    memcpy(w->before, w->net, 3 * w->count * sizeof(double));
    memcpy(w->tried, w->step, 3 * w->count * sizeof(double));
    const double first = fmin(1, step_longest / fmax(largest_move(w), step_longest));
    for (double t = first; t > step_shortest * first; t *= 0.5) {
        for (size_t i = 0; i < 3 * w->count; i++) {
            w->net[i] = w->before[i] - t * w->tried[i];
        }
        const double next = look_at(w, all);
        if (next < (1 - falls * t) * *found) {
            *found = next;
            return 1;
        }
    }
    memcpy(w->net, w->before, 3 * w->count * sizeof(double));
    look_at(w, all);
    return 0;
}

/* How often the direction in `step` goes up and down around a ring. */
static int count_waves(const work *w)
{
    const int along_u = w->space->problem->ring == TAUT_FILM_RING_U;
    const int period = w->space->around->period, across = along_u ? w->mask->nv : w->mask->nu;
    const size_t nv = (size_t)w->mask->nv;
    double best = -1;
    int waves = 0;

    for (int m = 0; m <= period / 2; m++) {
        double power = 0;
        for (int k = 0; k < across; k++) {
            double real = 0, imaginary = 0;
            for (int i = 0; i < period; i++) {
                const size_t at = along_u ? (size_t)i * nv + (size_t)k : (size_t)k * nv + (size_t)i;
                const double angle = 2 * TAUT_PI * (double)(m * i % period) / period;
                const double x = taut_dot(w->step + 3 * at, w->directions + 9 * at);
                real += x * taut_cos(angle);
                imaginary += x * taut_sin(angle);
            }
            power += real * real + imaginary * imaginary;
        }
        if (power > best) {
            best = power;
            waves = m;
        }
    }
    return waves;
}

/* out = M in, M(d, d) = iint (n . d)^2 dA. */
static void weigh(const work *w, const double *in, double *out)
{
    const taut_area_axis *u = &w->functional->u, *v = &w->functional->v;
    const size_t row = 3 * (size_t)w->mask->nv;
    double *const still = w->rows, *const along = w->rows + row, *const back = w->rows + 2 * row;

    memset(out, 0, 3 * w->count * sizeof(double));
    for (int line = 0; line < u->count; line++) {
        find_row(w, line, still, along);
        memset(back, 0, row * sizeof(double));
        for (int k = 0; k < v->count; k++) {
            double normal[3], part = 0;
            weighted_normal(w, line, k, still, along, normal);
            for (int p = 0; p < u->local * v->local; p++) {
                const int a = p / v->local, b = p % v->local;
                const size_t at =
                    (size_t)(u->first[line] + a) * (size_t)w->mask->nv + (size_t)(v->first[k] + b);
                part += u->value[line * u->local + a] * v->value[k * v->local + b] *
                        taut_dot(normal, in + 3 * at);
            }
            const double size = taut_length(normal);
            for (int c = 0; c < 3; c++) {
                normal[c] *= part / size;
            }
            spread_node(w, k, normal, back);
        }
        spread_row(w, line, back, out);
    }
    taut_mask_reduce(w->mask, out);
}

static double dot_nets(const work *w, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < 3 * w->count; i++) {
        sum += w->mask->known[i / 3] ? 0 : a[i] * b[i];
    }
    return sum;
}

/* The lowest eigenvalue, about, by inverse iterations with as much of the metric as makes it definite; its direction is in
 * `step`. Hessian: assembled, stiffened. */
static double find_lowest(work *w, taut_area_hessian *hessian)
{
    unsigned seed = 12345;
    double theta = 1e-6, lowest = 0;

    while (theta < 1 && taut_area_hessian_factor(hessian, theta) != TAUT_OK) {
        theta = fmin(1, 1.5 * theta);
    }
    for (size_t i = 0; i < 3 * w->count; i++) { /* a direction that no symmetry shares */
        seed = 1664525u * seed + 1013904223u;
        w->step[i] = w->mask->known[i / 3] ? 0 : (double)(seed >> 8) * 0x1p-24 - 0.25;
    }
    for (int k = 0; k < INVERSIONS; k++) {
        taut_mask_follow(w->mask, w->step);
        weigh(w, w->step, w->tried);
        const double mass = dot_nets(w, w->step, w->tried);
        memcpy(w->before, w->step, 3 * w->count * sizeof(double));
        memcpy(w->step, w->tried, 3 * w->count * sizeof(double));
        taut_area_hessian_solve(hessian, w->step);
        const double size = sqrt(mass);
        for (size_t i = 0; i < 3 * w->count; i++) {
            w->step[i] /= size;
        }
    }
    taut_mask_follow(w->mask, w->step);
    weigh(w, w->step, w->tried);
    const double mass = dot_nets(w, w->step, w->tried);
    memset(w->before, 0, 3 * w->count * sizeof(double));
    taut_area_functional_product(w->functional, 0, w->step, w->before);
    taut_mask_reduce(w->mask, w->before);
    lowest = dot_nets(w, w->step, w->before) / mass;
    return lowest;
}

/* What kind of rest the net is at. */
static void judge(work *w, taut_area_hessian *hessian, const unsigned char *rigid,
                  taut_film_rest_point *at)
{
    at->residual = look_at(w, 0);
    at->any = w->any;
    at->waves = -1;
    taut_area_hessian_assemble(hessian, w->functional);
    taut_area_hessian_stiffen(hessian, w->directions, stiffness);
    if (taut_area_hessian_factor_any(hessian, 0, rigid, &at->negative) != TAUT_OK) {
        at->negative = -1;
    }
    if (at->negative > 0) {
        at->eigenvalue = find_lowest(w, hessian);
        at->waves = w->space->around != NULL ? count_waves(w) : -1;
    }
}

/* Steps in all coordinates, with as little of the metric as lets the residual fall. */
static double settle_gauge(work *w, taut_area_hessian *hessian, int steps)
{
    double found = look_at(w, 1), theta = gauge;

    for (int k = 0; k < steps && found > gauge_enough && theta <= gauge_most; k++) {
        theta = step_nearer(w, hessian, 1, theta, &found) ? fmax(gauge, 0.1 * theta) : 10 * theta;
    }
    return found;
}

/* Steps and looks end early, with outputs of no meaning, where they are told to. */
static taut_status stopped(const work *w)
{
    return taut_pulse_is_stopped(w->functional->pulse) ? TAUT_INTERRUPTED : TAUT_OK;
}

static void seek(work *w, taut_area_hessian *hessian, int steps, int all)
{
    const int full = w->space->problem->method == TAUT_FILM_FULL;
    double found = look_at(w, 0);

    for (int k = 0; k < steps && found > enough && step_nearer(w, hessian, 0, 0, &found); k++) {
    }
    if (!full || taut_film_has_density(w->space->problem) || !(found < residual_near)) {
        return;
    }
    const double before = found;
    memcpy(w->kept, w->net, 3 * w->count * sizeof(double));
    (void)settle_gauge(w, hessian, all);
    found = look_at(w, 0);
    for (int k = 0; k < STEPS && found > enough && step_nearer(w, hessian, 0, 0, &found); k++) {
    }
    if (!(found <=
          fmax(residual_far * before, enough_far))) { /* what the first steps found stands */
        memcpy(w->net, w->kept, 3 * w->count * sizeof(double));
    }
}

taut_status taut_film_seek(taut_area_functional *functional, const taut_film_space *space,
                           double *net, const unsigned char rigid[4], int steps, int all,
                           taut_film_rest_point *at)
{
    work w = {.functional = functional, .space = space, .mask = &space->mask, .net = net};
    taut_area_hessian *hessian = NULL;

    *at = (taut_film_rest_point){.negative = -1};
    taut_arena *arena = taut_arena_new();
    taut_status status = prepare(&w, arena, &hessian);
    double *first = taut_arena_copy(arena, net, w.count, 3 * sizeof(double));
    status = first == NULL ? TAUT_NO_MEMORY : status;
    if (status == TAUT_OK) {
        at->first = look_at(&w, 0);
        if (steps > 0) {
            seek(&w, hessian, steps, all);
        }
        for (size_t i = 0; i < w.count; i++) {
            at->moved = fmax(at->moved, taut_distance(first + 3 * i, net + 3 * i));
        }
        judge(&w, hessian, rigid, at);
        status = stopped(&w);
    }
    taut_area_hessian_free(hessian);
    taut_arena_free(arena);
    return status;
}
