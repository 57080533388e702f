/* panels.c -- exact conical and circular meshes: windows out of problems and nets, their vertices
 * into a model, the residuals into its details. */
#include "taut/panels.h"

#include "construct/bonnet/net.h"
#include "construct/panels/residuals.h"
#include "construct/panels/vertices.h"
#include "core/arena.h"
#include "core/fail.h"
#include "problem/problem.h"
#include "taut/recognise.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* Neighbouring tangent planes are refused where they meet at less than this share of the angle that
 * small steps have: vertices run away from the surface. */
static const double least_share = 0.1;

/* What is being made. */
typedef struct making {
    const taut_panels_options *options;
    taut_arena *arena;
    taut_model *model;
    taut_record *lists; /* planarity, balance or circle, distance */
    taut_record *list[3];
} making;

static int panels_along(const taut_panels_options *options, int d)
{
    return options->divide[d] > 0 ? options->divide[d] : 8;
}

static taut_status check_options(const taut_panels_options *options, taut_error *error)
{
    const double vertices = (panels_along(options, 0) + 1.0) * (panels_along(options, 1) + 1.0);
    if ((options->kind != TAUT_PANELS_CONICAL && options->kind != TAUT_PANELS_CIRCULAR) ||
        options->divide[0] < 0 || options->divide[1] < 0) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "panels are conical or circular, and their numbers positive");
    }
    if (panels_along(options, 0) >= TAUT_COUNT_MAX || panels_along(options, 1) >= TAUT_COUNT_MAX ||
        vertices > TAUT_POINTS_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", NULL, vertices, TAUT_POINTS_MAX,
                         "%.0f vertices, expected at most %d", vertices, TAUT_POINTS_MAX);
    }
    return TAUT_OK;
}

/* theta must be a multiple of pi, within the rounding of a recognised one. */
static taut_status check_theta(double theta, taut_error *error)
{
    if (fabs(sin(theta)) <= 1e-9) {
        return TAUT_OK;
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/theta", theta, 0,
                     "theta is %.6g, expected 0: the panels follow lines of curvature, which the "
                     "parameter lines of other associates are not",
                     theta);
}

/* A bspline of degree 1 whose functions peak at the lines of the mesh. */
static taut_status basis_of(making *m, double lo, double hi, int count, taut_basis **basis,
                            taut_error *error)
{
    taut_basis_spec spec = {.type = "bspline", .degree = 1, .knot_count = count + 2};
    double *knots = taut_arena_take(m->arena, (size_t)count + 2, sizeof *knots);
    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < count; i++) {
        knots[i + 1] = i == count - 1 ? hi : lo + (hi - lo) * i / (count - 1);
    }
    knots[0] = lo;
    knots[count + 1] = hi;
    spec.knots = knots;
    return taut_basis_new(&spec, count, basis, error);
}

/* The vertices as double[nu][nv][3]; `turned` has the window's first direction along v. */
static taut_status fill(const making *m, const taut_panels_window *window, int turned,
                        double *vertices, double *distance, taut_error *error)
{
    const int nu = window->count[turned] + 1, nv = window->count[1 - turned] + 1;
    *distance = 0;
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            double x[3], on[3], placed[3], *vertex = vertices + 3 * ((long)i * nv + j);
            const int a = turned ? j : i, b = turned ? i : j;
            if (m->options->kind == TAUT_PANELS_CIRCULAR) {
                taut_panels_circular(window, a, b, x);
            } else {
                const double share = taut_panels_conical(window, a, b, x);
                if (!(share > least_share)) {
                    return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", NULL, share,
                                     least_share,
                                     "the tangent planes of such large panels do not meet near "
                                     "the surface: use more panels");
                }
            }
            taut_panels_surface(window, a, b, on);
            taut_panels_place(window, x, vertex);
            taut_panels_place(window, on, placed);
            const double apart =
                hypot(vertex[0] - placed[0], hypot(vertex[1] - placed[1], vertex[2] - placed[2]));
            *distance = fmax(*distance, apart);
        }
    }
    return TAUT_OK;
}

/* range: of the window's own surface, u and v. */
static taut_status add(making *m, const char *name, const taut_panels_window *window, int turned,
                       const double range[2][2], taut_error *error)
{
    const int nu = window->count[turned] + 1, nv = window->count[1 - turned] + 1;
    double *vertices = taut_arena_take(m->arena, 3 * (size_t)nu * (size_t)nv, sizeof *vertices);
    taut_panels_residuals r = {0, 0, 0, 0};
    taut_basis *u = NULL, *v = NULL;
    taut_surface *surface = NULL;
    double distance = 0;
    taut_status status = vertices != NULL ? fill(m, window, turned, vertices, &distance, error)
                                          : taut_fail_memory(error);

    if (status == TAUT_OK) {
        status = basis_of(m, range[0][0], range[0][1], nu, &u, error);
    }
    if (status == TAUT_OK) {
        status = basis_of(m, range[1][0], range[1][1], nv, &v, error);
    }
    if (status == TAUT_OK) {
        status = taut_surface_new(name, u, v, vertices, NULL, &surface, error);
    }
    if (status == TAUT_OK && taut_model_add_surface(m->model, surface) != TAUT_OK) {
        taut_surface_free(surface);
        status = taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        taut_panels_measure(nu, nv, vertices, &r);
        taut_record_add_number(m->list[0], NULL, r.planarity);
        taut_record_add_number(m->list[1], NULL,
                               m->options->kind == TAUT_PANELS_CONICAL ? r.balance : r.circle);
        taut_record_add_number(m->list[2], NULL, distance);
    }
    taut_basis_free(u);
    taut_basis_free(v);
    return status;
}

static taut_status begin(const taut_panels_options *options, making *m, taut_error *error)
{
    static const char *const names[2][3] = {{"planarity", "balance", "distance"},
                                            {"planarity", "circle", "distance"}};
    taut_status status = check_options(options, error);

    if (status != TAUT_OK) {
        return status;
    }
    m->options = options;
    m->arena = taut_arena_new();
    m->lists = taut_record_new();
    for (int k = 0; k < 3; k++) {
        m->list[k] = taut_record_add_list(m->lists, names[options->kind][k]);
    }
    return m->arena != NULL && taut_model_new(&m->model) == TAUT_OK ? TAUT_OK
                                                                    : taut_fail_memory(error);
}

/* The details; gives the model away, or frees all. */
static taut_status finish(making *m, taut_status status, taut_model **panels, taut_error *error)
{
    if (status == TAUT_OK) {
        taut_record *details = taut_record_new();
        const int circular = m->options->kind == TAUT_PANELS_CIRCULAR;
        taut_record_add_text(details, "panels", circular ? "circular" : "conical");
        taut_record *divide = taut_record_add_list(details, "divide");
        for (int d = 0; d < 2; d++) {
            taut_record_add_number(divide, NULL, panels_along(m->options, d));
        }
        for (size_t k = 0; k < 3; k++) {
            const taut_record *list = taut_record_at(m->lists, k);
            if (taut_record_count(list) == 1) {
                taut_record_add_number(details, taut_record_key(m->lists, k),
                                       taut_record_number(taut_record_at(list, 0)));
            } else {
                taut_record_add_record(details, taut_record_key(m->lists, k), list);
            }
        }
        taut_model_set_details(m->model, details);
        if (taut_record_status(m->lists) != TAUT_OK || taut_record_status(details) != TAUT_OK) {
            status = taut_fail_memory(error);
        }
    }
    taut_record_free(m->lists);
    taut_arena_free(m->arena);
    if (status == TAUT_OK) {
        *panels = m->model;
    } else {
        taut_model_free(m->model);
    }
    return status;
}

/* From lengths in u and v, or in p and q where `unit` is 1: the cells. */
static void cut(const making *m, const double lo[2], const double hi[2], double unit, int turned,
                taut_panels_window *window)
{
    for (int d = 0; d < 2; d++) {
        window->count[d] = panels_along(m->options, turned ? 1 - d : d);
        window->middle[d] = 0.5 * (lo[d] + hi[d]) / unit;
        window->step[d] = (hi[d] - lo[d]) / unit / window->count[d];
    }
}

/* A frame of a problem. Of sign +, r(u, v) = r_-(u - pi, v) + (lambda pi / w, 0, 0). */
static taut_status add_frame(making *m, const taut_bonnet_problem *p, double lambda,
                             const char *name, taut_error *error)
{
    const double w = sqrt((1 - lambda) * (1 + lambda)), side = cos(p->theta) < 0 ? -1 : 1;
    const double length[2] = {p->alpha * (p->segments[0] > 0 ? p->segments[0] : 1),
                              p->beta * (p->segments[1] > 0 ? p->segments[1] : 1)};
    double lo[2] = {p->start[0], p->start[1]}, hi[2] = {lo[0] + length[0], lo[1] + length[1]};
    const double scale = p->normalize && lambda < 1 ? w : 1;
    const double range[2][2] = {{scale * lo[0], scale * hi[0]}, {scale * lo[1], scale * hi[1]}};
    taut_panels_window window = {.lambda = lambda, .w = w, .factor = 1};

    for (int c = 0; c < 3; c++) {
        window.matrix[c][c] = side;
    }
    if (!p->normalize) {
        window.factor = 0.5 * w * w;
        window.lift = -1;
        if (p->sign > 0) {
            lo[0] -= pi;
            hi[0] -= pi;
            window.matrix[0][3] = side * lambda * pi / w;
        }
    }
    cut(m, lo, hi, p->normalize ? 1 : w, 0, &window);
    return add(m, name, &window, 0, range, error);
}

/* The member of the family that a surface is. */
static taut_status add_member(making *m, const taut_surface *surface, taut_error *error)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    taut_panels_window window;
    taut_family_member f;
    double lo[2], hi[2], range[2][2];
    taut_status status = taut_surface_recognise(surface, &f, error);

    if (status == TAUT_OK && f.lambda == 1) {
        status = taut_fail(error, TAUT_NO_SOLUTION, "no-solution", NULL, f.lambda, 1,
                           "this is Enneper's surface: make its panels from its problem, with "
                           "\"normalize\": true and \"lambda\": 1");
    }
    if (status == TAUT_OK) {
        status = check_theta(f.theta, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    for (int d = 0; d < 2; d++) {
        const int at = f.turned ? 1 - d : d;
        range[d][0] = taut_basis_lo(bases[d]);
        range[d][1] = taut_basis_hi(bases[d]);
        lo[d] = taut_basis_lo(bases[at]) + f.shift[d];
        hi[d] = taut_basis_hi(bases[at]) + f.shift[d];
    }
    window = (taut_panels_window){
        .lambda = f.lambda, .w = sqrt((1 - f.lambda) * (1 + f.lambda)), .lift = -f.scale};
    window.factor = 0.5 * f.scale * window.w * window.w;
    memcpy(window.matrix, f.motion, sizeof window.matrix);
    for (int k = 0; k < 9 && cos(f.theta) < 0; k++) {
        window.matrix[k / 3][k % 3] = -window.matrix[k / 3][k % 3];
    }
    cut(m, lo, hi, window.w, f.turned, &window);
    return add(m, taut_surface_name(surface), &window, f.turned, (const double(*)[2])range, error);
}

/* Between surfaces: progress, and whether to stop. */
static taut_status step(const making *m, double part, taut_error *error)
{
    const taut_monitor *monitor = &m->options->monitor;
    return monitor->progress != NULL && monitor->progress(monitor->context, part, "panels") != 0
               ? taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                           "stopped")
               : TAUT_OK;
}

taut_status taut_panels_of_bonnet(const taut_bonnet_problem *problem,
                                  const taut_panels_options *options, taut_model **panels,
                                  taut_error *error)
{
    static const taut_panels_options none;
    making m = {.options = NULL};
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (problem == NULL || panels == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_panels_of_bonnet needs a problem and a place for the panels");
    }
    status = taut_bonnet_make(problem, NULL, &made, error); /* is it legal? */
    if (status == TAUT_OK) {
        status = check_theta(problem->theta, error);
    }
    if (status == TAUT_OK) {
        status = begin(options != NULL ? options : &none, &m, error);
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(made); i++) {
        const double lambda = taut_bonnet_frame_lambda(problem, i);
        const char *name = taut_surface_name(taut_model_surface(made, i));
        if (options == NULL || options->surface == NULL || strcmp(options->surface, name) == 0) {
            status = add_frame(&m, problem, lambda, name, error);
        }
        if (status == TAUT_OK) {
            status = step(&m, (i + 1.0) / taut_model_surface_count(made), error);
        }
    }
    taut_model_free(made);
    return finish(&m, status, panels, error);
}

taut_status taut_panels_of_model(const taut_model *model, const taut_panels_options *options,
                                 taut_model **panels, taut_error *error)
{
    static const taut_panels_options none;
    making m = {.options = NULL};
    taut_status status = TAUT_OK;

    if (model == NULL || panels == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_panels_of_model needs a model and a place for the panels");
    }
    status = begin(options != NULL ? options : &none, &m, error);
    if (status == TAUT_OK) {
        status = taut_model_set_unit(m.model, taut_model_unit(model));
    }
    if (status == TAUT_OK && taut_model_surface_count(model) == 0) {
        status = taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/surfaces", 0, 1,
                           "the model has no surface");
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(model); i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        char where[32];
        if (m.options->surface != NULL &&
            strcmp(m.options->surface, taut_surface_name(surface)) != 0) {
            continue;
        }
        status = add_member(&m, surface, error);
        if (status == TAUT_OK) {
            status = step(&m, (i + 1.0) / taut_model_surface_count(model), error);
        } else {
            snprintf(where, sizeof where, "/surfaces/%d", i);
            taut_error_prefix(error, where);
        }
    }
    return finish(&m, status, panels, error);
}

taut_status taut_panels_of_problem(const taut_problem *problem, const taut_panels_options *options,
                                   taut_model **panels, taut_error *error)
{
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (problem == NULL || panels == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_panels_of_problem needs a problem and a place for the panels");
    }
    if (strcmp(taut_problem_construction(problem), "bonnet") == 0) {
        status = taut_panels_of_bonnet(problem->data, options, &made, error);
        if (status == TAUT_OK) {
            (void)taut_model_set_unit(made, problem->unit); /* a problem has no unknown unit */
            *panels = made;
        }
        return status;
    }
    status = taut_make(problem, NULL, &made, error);
    if (status == TAUT_OK) {
        status = taut_panels_of_model(made, options, panels, error);
    }
    taut_model_free(made);
    return status;
}
