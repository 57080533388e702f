/* panels.c -- exact conical and circular meshes: windows out of problems and nets, their vertices
 * into a model, the residuals into its details. */
#include "taut/panels.h"

#include "construct/bonnet/net.h"
#include "construct/common/build.h"
#include "construct/panels/vertices.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/pulse.h"
#include "core/vec3.h"
#include "problem/problem.h"
#include "taut/recognise.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* Neighbouring tangent planes are refused where they meet at less than this share of the angle that
 * small steps have: vertices run away from the surface. */
static const double least_share = 0.1;

/* What is being made. */
typedef struct making {
    const taut_panels_options *options;
    const taut_bonnet_problem *problem; /* or NULL */
    const taut_model *source;           /* the surfaces */
    /* Adds the panels of surface i of the source. */
    taut_status (*add)(struct making *m, int i, taut_error *error);
    taut_arena *arena;
    taut_model *model;
    taut_record *lists; /* planarity, balance or circle, distance */
    taut_record *list[3];
    taut_pulse pulse;
} making;

/* Operations of a vertex, and of its angles, as pulses count them. */
enum { VERTEX_WORK = 1600, ANGLES_WORK = 1000 };

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
        return taut_fail(error, TAUT_BAD_INPUT, "size", NULL, vertices, TAUT_POINTS_MAX,
                         "%.0f vertices, expected at most %d", vertices, TAUT_POINTS_MAX);
    }
    return TAUT_OK;
}

/* theta must be a multiple of pi, within the rounding of a recognised one. */
static taut_status check_theta(double theta, taut_error *error)
{
    if (fabs(taut_sin(theta)) <= 1e-9) {
        return TAUT_OK;
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "theta", "/theta", theta, 0,
                     "theta is %.6g, expected 0: the panels follow lines of curvature, which the "
                     "parameter lines of other associates are not",
                     theta);
}

/* ---- how plane, conical and circular a mesh of quads is, from its vertices alone ---- */

typedef struct residuals {
    double planarity; /* largest distance between the diagonals over their mean length */
    double balance;   /* largest |w1 - w2 + w3 - w4| around an inner vertex; NaN without any */
    double circle;    /* largest |sum of opposite angles - pi| */
} residuals;

/* At `at`, between the directions to a and b. */
static double angle_at(const double *at, const double *a, const double *b)
{
    double p[3], q[3], n[3];
    taut_difference(a, at, p);
    taut_difference(b, at, q);
    taut_cross(p, q, n);
    return taut_atan2(taut_length(n), taut_dot(p, q));
}

static void raise_largest(double *largest, double value)
{
    if (!(value <= *largest)) {
        *largest = value;
    }
}

static void measure_panel(const double *const corner[4], residuals *r)
{
    double one[3], two[3], side[3], n[3];
    taut_difference(corner[2], corner[0], one);
    taut_difference(corner[3], corner[1], two);
    taut_difference(corner[1], corner[0], side);
    taut_cross(one, two, n);
    raise_largest(&r->planarity, 2 * fabs(taut_dot(side, n)) /
                                     (taut_length(n) * (taut_length(one) + taut_length(two))));
    for (int k = 0; k < 2; k++) {
        raise_largest(&r->circle,
                      fabs(angle_at(corner[k], corner[k + 1], corner[(k + 3) % 4]) +
                           angle_at(corner[k + 2], corner[(k + 3) % 4], corner[k + 1]) - TAUT_PI));
    }
}

static residuals measure_mesh(int nu, int nv, const double *vertices, taut_pulse *pulse)
{
    residuals r = {0, nu > 2 && nv > 2 ? 0 : (double)NAN, 0};

    for (int i = 0; i + 1 < nu && !taut_pulse_beat(pulse, (double)ANGLES_WORK * nv); i++) {
        for (int j = 0; j + 1 < nv; j++) {
            const double *const at = vertices + 3 * ((int64_t)i * nv + j);
            const double *const corner[4] = {at, at + 3 * (int64_t)nv, at + 3 * ((int64_t)nv + 1),
                                             at + 3};
            measure_panel(corner, &r);
        }
    }
    for (int i = 1; i + 1 < nu && !taut_pulse_beat(pulse, (double)ANGLES_WORK * nv); i++) {
        for (int j = 1; j + 1 < nv; j++) {
            const double *const at = vertices + 3 * ((int64_t)i * nv + j);
            const double *const around[4] = {at + 3 * (int64_t)nv, at + 3, at - 3 * (int64_t)nv,
                                             at - 3};
            double sum = 0;
            for (int k = 0; k < 4; k++) {
                sum += (k % 2 == 0 ? 1 : -1) * angle_at(at, around[k], around[(k + 1) % 4]);
            }
            raise_largest(&r.balance, fabs(sum));
        }
    }
    return r;
}

/* ---- the meshes ---- */

/* A bspline of degree 1 whose functions peak at the lines of the mesh; its knots into knots[count +
 * 2]. */
static taut_basis_spec spec_of(double lo, double hi, int count, double *knots)
{
    const taut_basis_spec spec = {
        .type = "bspline", .degree = 1, .knot_count = count + 2, .knots = knots};
    for (int i = 0; i < count; i++) {
        knots[i + 1] = i == count - 1 ? hi : lo + (hi - lo) * i / (count - 1);
    }
    knots[0] = lo;
    knots[count + 1] = hi;
    return spec;
}

static taut_status refuse_stop(taut_error *error)
{
    return taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none, "stopped");
}

/* The vertices as double[nu][nv][3]; `turned` has the window's first direction along v. */
static taut_status fill_vertices(making *m, const taut_panels_window *window, int turned,
                                 double *vertices, double *distance, taut_error *error)
{
    const int nu = window->count[turned] + 1, nv = window->count[1 - turned] + 1;
    *distance = 0;
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            double x[3], on[3], placed[3], *vertex = vertices + 3 * ((int64_t)i * nv + j);
            const int a = turned ? j : i, b = turned ? i : j;
            if (m->options->kind == TAUT_PANELS_CIRCULAR) {
                taut_panels_circular(window, a, b, x);
            } else {
                const double share = taut_panels_conical(window, a, b, x);
                if (!(share > least_share)) {
                    return taut_fail(error, TAUT_NO_SOLUTION, "large-panels", NULL, share,
                                     least_share,
                                     "the tangent planes of such large panels do not meet near "
                                     "the surface: use more panels");
                }
            }
            taut_panels_surface(window, a, b, on);
            taut_panels_place(window, x, vertex);
            taut_panels_place(window, on, placed);
            const double apart = taut_hypot(
                vertex[0] - placed[0], taut_hypot(vertex[1] - placed[1], vertex[2] - placed[2]));
            *distance = fmax(*distance, apart);
        }
        if (taut_pulse_beat(&m->pulse, (double)VERTEX_WORK * nv)) {
            return refuse_stop(error);
        }
    }
    return TAUT_OK;
}

/* range: of the window's own surface, u and v. */
static taut_status add_mesh(making *m, const char *name, const taut_panels_window *window,
                            int turned, const double range[2][2], taut_error *error)
{
    const int nu = window->count[turned] + 1, nv = window->count[1 - turned] + 1;
    const int counts[2] = {nu, nv};
    double *vertices = taut_arena_take(m->arena, 3 * (size_t)nu * (size_t)nv, sizeof *vertices);
    double *knots = taut_arena_take(m->arena, (size_t)nu + (size_t)nv + 4, sizeof *knots);
    double distance = 0;
    taut_status status = TAUT_OK;

    if (taut_arena_status(m->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = fill_vertices(m, window, turned, vertices, &distance, error);
    if (status != TAUT_OK) {
        return status;
    }
    const taut_basis_spec specs[2] = {spec_of(range[0][0], range[0][1], nu, knots),
                                      spec_of(range[1][0], range[1][1], nv, knots + nu + 2)};
    status = taut_construct_add_net(m->model, name, specs, counts, vertices, NULL, NULL, error);
    if (status != TAUT_OK) {
        return status;
    }
    const residuals r = measure_mesh(nu, nv, vertices, &m->pulse);
    if (taut_pulse_is_stopped(&m->pulse)) {
        return refuse_stop(error);
    }
    taut_record_add_number(m->list[0], NULL, r.planarity);
    taut_record_add_number(m->list[1], NULL,
                           m->options->kind == TAUT_PANELS_CONICAL ? r.balance : r.circle);
    taut_record_add_number(m->list[2], NULL, distance);
    return TAUT_OK;
}

static taut_record *details_of(const making *m)
{
    taut_record *details = taut_record_new();
    taut_record *divide = NULL;
    const int circular = m->options->kind == TAUT_PANELS_CIRCULAR;

    taut_record_add_text(details, "panels", circular ? "circular" : "conical");
    divide = taut_record_add_list(details, "divide");
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
    return details;
}

/* From lengths in u and v, or in p and q where `unit` is 1: the cells. */
static void cut_window(const making *m, const double lo[2], const double hi[2], double unit,
                       int turned, taut_panels_window *window)
{
    for (int d = 0; d < 2; d++) {
        window->count[d] = panels_along(m->options, turned ? 1 - d : d);
        window->middle[d] = 0.5 * (lo[d] + hi[d]) / unit;
        window->step[d] = (hi[d] - lo[d]) / unit / window->count[d];
    }
}

/* A surface of a problem. Of sign +, r(u, v) = r_-(u - pi, v) + (lambda pi / w, 0, 0). */
static taut_status add_asked(making *m, int i, taut_error *error)
{
    const taut_bonnet_problem *p = m->problem;
    const double lambda = taut_bonnet_frame_lambda(p, i);
    const char *name = taut_surface_name(taut_model_surface(m->source, i));
    const double w = sqrt((1 - lambda) * (1 + lambda)), side = taut_cos(p->theta) < 0 ? -1 : 1;
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
            lo[0] -= TAUT_PI;
            hi[0] -= TAUT_PI;
            window.matrix[0][3] = side * lambda * TAUT_PI / w;
        }
    }
    cut_window(m, lo, hi, p->normalize ? 1 : w, 0, &window);
    return add_mesh(m, name, &window, 0, range, error);
}

/* The member of the family that a surface is. */
static taut_status add_recognised(making *m, int i, taut_error *error)
{
    const taut_surface *surface = taut_model_surface(m->source, i);
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    taut_panels_window window;
    taut_family_member f;
    double lo[2], hi[2], range[2][2];
    taut_status status = taut_surface_recognise(surface, &f, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (f.lambda == 1) {
        return taut_fail(error, TAUT_NO_SOLUTION, "enneper", NULL, f.lambda, 1,
                         "this is Enneper's surface: make its panels from its problem, with "
                         "\"normalize\": true and \"lambda\": 1");
    }
    status = check_theta(f.theta, error);
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
    for (int k = 0; k < 9 && taut_cos(f.theta) < 0; k++) {
        window.matrix[k / 3][k % 3] = -window.matrix[k / 3][k % 3];
    }
    cut_window(m, lo, hi, window.w, f.turned, &window);
    return add_mesh(m, taut_surface_name(surface), &window, f.turned, (const double(*)[2])range,
                    error);
}

/* As add_recognised, the place named. */
static taut_status add_member(making *m, int i, taut_error *error)
{
    const taut_status status = add_recognised(m, i, error);
    if (status != TAUT_OK) {
        char where[32];
        snprintf(where, sizeof where, "/surfaces/%d", i);
        taut_error_prefix(error, where);
    }
    return status;
}

static taut_status add_surfaces(making *m, taut_error *error)
{
    const taut_panels_options *options = m->options;
    const int count = taut_model_surface_count(m->source);
    if (count == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-surface", "/surfaces", 0, 1,
                         "the model has no surface");
    }
    for (int i = 0; i < count; i++) {
        const char *name = taut_surface_name(taut_model_surface(m->source, i));
        const int wanted = options->surface == NULL || strcmp(options->surface, name) == 0;
        const taut_status status = wanted ? m->add(m, i, error) : TAUT_OK;
        if (status != TAUT_OK) {
            return status;
        }
        m->pulse.done = (i + 1.0) / count;
        if (taut_pulse_report(&m->pulse)) {
            return refuse_stop(error);
        }
    }
    return TAUT_OK;
}

static taut_status fill_model(void *context, taut_arena *arena, taut_model *model,
                              taut_error *error)
{
    static const char *const names[2][3] = {{"planarity", "balance", "distance"},
                                            {"planarity", "circle", "distance"}};
    making *m = context;
    taut_status status = TAUT_OK;

    m->arena = arena;
    m->model = model;
    m->lists = taut_record_new();
    for (int k = 0; k < 3; k++) {
        m->list[k] = taut_record_add_list(m->lists, names[m->options->kind][k]);
    }
    status = add_surfaces(m, error);
    if (status == TAUT_OK && taut_record_status(m->lists) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    status = status == TAUT_OK ? taut_construct_set_details(model, details_of(m), error) : status;
    taut_record_free(m->lists);
    return status;
}

static taut_status make_panels(making *m, const taut_panels_options *options, taut_model **panels,
                               taut_error *error)
{
    static const taut_panels_options none;
    taut_status status = TAUT_OK;

    m->options = options != NULL ? options : &none;
    m->pulse = (taut_pulse){.monitor = &m->options->monitor, .what = "panels"};
    status = check_options(m->options, error);
    return status == TAUT_OK ? taut_construct_build(fill_model, m, panels, error) : status;
}

taut_status taut_panels_of_bonnet(const taut_bonnet_problem *problem,
                                  const taut_panels_options *options, taut_model **panels,
                                  taut_error *error)
{
    making m = {.problem = problem, .add = add_asked};
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (problem == NULL || panels == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_panels_of_bonnet needs a problem and a place for the panels");
    }
    status = taut_bonnet_make(problem, NULL, &made, error); /* is it legal? */
    if (status != TAUT_OK) {
        return status;
    }
    m.source = made;
    status = check_theta(problem->theta, error);
    status = status == TAUT_OK ? make_panels(&m, options, panels, error) : status;
    taut_model_free(made);
    return status;
}

taut_status taut_panels_of_model(const taut_model *model, const taut_panels_options *options,
                                 taut_model **panels, taut_error *error)
{
    making m = {.source = model, .add = add_member};
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (model == NULL || panels == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_panels_of_model needs a model and a place for the panels");
    }
    status = make_panels(&m, options, &made, error);
    if (status != TAUT_OK) {
        return status;
    }
    (void)taut_model_set_unit(made, taut_model_unit(model)); /* a model has no unknown unit */
    *panels = made;
    return TAUT_OK;
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
        if (status != TAUT_OK) {
            return status;
        }
        (void)taut_model_set_unit(made, problem->unit); /* a problem has no unknown unit */
        *panels = made;
        return TAUT_OK;
    }
    status = taut_make(problem, NULL, &made, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_panels_of_model(made, options, panels, error);
    taut_model_free(made);
    return status;
}
