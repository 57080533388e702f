/* test_pulse.c -- how often taut_make tells its monitor that work goes on: as often as there is work, counted in operations
 * and not by a clock; and it goes on no further after a report that is answered by an end. */
#include "check.h"
#include "cli/embedded_files.h"
#include "core/pulse.h"
#include "monitors.h"
#include "problems.h"

#include "taut/biharmonic.h"
#include "taut/construct.h"
#include "taut/gradient.h"
#include "taut/harmonic.h"
#include "taut/measure.h"
#include "taut/mesh.h"
#include "taut/read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static taut_status make_net(const test_problem *problem, watch *w)
{
    taut_make_options options = {.monitor = monitor_of(w)};
    taut_model *model = NULL;
    const taut_status status = taut_dirichlet_make(&problem->data, &options, &model, NULL);
    CHECK((model != NULL) == (status == TAUT_OK), "status %d", (int)status);
    taut_model_free(model);
    return status;
}

/* Two solves for n x n unknowns, three right-hand sides, uniform knots that mirror: the modes, even and odd, are matrices of
 * n/2 x n/2 each, and go to the net and from it: 2 2 3 n (n^2 / 2) multiplications, as many sums, each time. */
static void test_dirichlet(int count)
{
    const double n = count - 2, operations = 12.0 * n * n * n;
    test_problem problem = problem_tetrahedron(count);
    watch all = {.stop_at = 0};

    CHECK(make_net(&problem, &all) == TAUT_OK, "made");
    CHECK(all.reports >= operations / TAUT_PULSE_WORK, "%d x %d: %d reports of %.3g operations",
          count, count, all.reports, operations);
    for (int k = 1; k <= all.reports; k += 1 + all.reports / 12) {
        watch stop = {.stop_at = k};
        CHECK(make_net(&problem, &stop) == TAUT_INTERRUPTED && stop.reports == k,
              "stopped at %d of %d: went on to %d", k, all.reports, stop.reports);
    }
    problem_free(&problem);
}

typedef struct words {
    watch counted;
    int witness; /* reports of one */
} words;

static int count_words(void *context, double done, const char *what)
{
    words *w = context;
    const taut_monitor inner = monitor_of(&w->counted);
    w->witness += strcmp(what, "witness") == 0;
    return inner.progress(inner.context, done, what);
}

static taut_status make_with(const char *name, int threads, words *w, taut_model **model)
{
    const taut_make_options options = {.threads = threads, .monitor = {count_words, w}};
    taut_problem *problem = NULL;
    taut_status status = TAUT_BAD_ARGUMENT;
    for (const taut_embedded *file = taut_examples; file->name != NULL; file++) {
        if (strcmp(file->name, name) == 0) {
            CHECK(taut_problem_read_text(file->text, file->length, name, &problem, NULL) == TAUT_OK,
                  "%s", name);
            status = taut_make(problem, &options, model, NULL);
        }
    }
    taut_problem_free(problem);
    return status;
}

static taut_status make_example(const char *name, words *w, taut_model **model)
{
    return make_with(name, 1, w, model);
}

/* What follows the steps of a construction reports too: so many reports at least, and an end at any of them leaves nothing. */
static void test_what_follows(void)
{
    static const struct {
        const char *name;
        int least;
    } cases[] = {{"film-cap.json", 100},      {"film-ridge.json", 60},
                 {"film-warp-weft.json", 18}, {"pattern-cone.json", 600},
                 {"pipe-run-arcs.json", 20},  {"trace-planks.json", 600}};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        words all = {.witness = 0};
        taut_model *model = NULL;
        CHECK(make_example(cases[c].name, &all, &model) == TAUT_OK, "%s", cases[c].name);
        taut_model_free(model);
        const int count = all.counted.reports;
        CHECK(count >= cases[c].least, "%s: %d reports", cases[c].name, count);
        for (int k = count; k >= 1; k -= k > count - 3 ? 1 : 1 + count / 3) {
            for (int threads = 1; threads <= 2; threads++) {
                words stop = {.counted = {.stop_at = k}};
                model = NULL;
                const taut_status status = make_with(cases[c].name, threads, &stop, &model);
                CHECK((model == NULL) == (status != TAUT_OK), "status %d", (int)status);
                CHECK(threads > 1 || (status == TAUT_INTERRUPTED && stop.counted.reports == k),
                      "%s: stopped at %d of %d, status %d, went on to %d", cases[c].name, k, count,
                      (int)status, stop.counted.reports);
                taut_model_free(model);
            }
        }
    }
}

/* A mesh reports as its samples and vertices are made. */
static void test_mesh(int count)
{
    test_problem problem = problem_tetrahedron(count);
    taut_model *model = NULL;
    watch all = {.stop_at = 0};
    const taut_mesh_options options = {.monitor = monitor_of(&all)};
    taut_mesh *mesh = NULL;

    CHECK(taut_dirichlet_make(&problem.data, NULL, &model, NULL) == TAUT_OK, "made");
    CHECK(taut_mesh_new(model, &options, &mesh, NULL) == TAUT_OK, "mesh");
    CHECK(all.reports >= 4, "%d reports", all.reports);
    taut_mesh_free(mesh);
    for (int k = 1; k <= all.reports; k++) {
        watch stop = {.stop_at = k};
        const taut_mesh_options stopped = {.monitor = monitor_of(&stop)};
        mesh = NULL;
        CHECK(taut_mesh_new(model, &stopped, &mesh, NULL) == TAUT_INTERRUPTED && mesh == NULL &&
                  stop.reports == k,
              "stopped at %d of %d: went on to %d", k, all.reports, stop.reports);
    }
    taut_model_free(model);
    problem_free(&problem);
}

/* Each of 16 sign branches that the data allows is searched for from several starts: a report of each. */
static void test_branches(void)
{
    words all = {.witness = 0};
    taut_model *model = NULL;
    CHECK(make_example("asymptotic-low.json", &all, &model) == TAUT_OK, "made");
    CHECK(all.counted.reports > 16 + 6, "%d reports", all.counted.reports);
    taut_model_free(model);
    for (int k = 1; k <= all.counted.reports; k += 1 + all.counted.reports / 12) {
        words stop = {.counted = {.stop_at = k}};
        model = NULL;
        CHECK(make_example("asymptotic-low.json", &stop, &model) == TAUT_INTERRUPTED &&
                  model == NULL && stop.counted.reports == k,
              "stopped at %d: went on to %d", k, stop.counted.reports);
    }
}

/* The witness of a film has its reports: stopped at one nothing is left, ended at one there is the film without it. */
static void test_witness(void)
{
    static const char name[] = "plateau-biquadratic-spline.json";
    words all = {.witness = 0};
    taut_model *model = NULL;
    CHECK(make_example(name, &all, &model) == TAUT_OK, "made");
    CHECK(all.witness >= 1, "no report of the witness");
    taut_model_free(model);
    for (int k = all.counted.reports - all.witness + 1; k <= all.counted.reports; k++) {
        words stop = {.counted = {.stop_at = k}};
        words enough = {.counted = {.stop_at = k, .answer = TAUT_ENOUGH}};
        model = NULL;
        CHECK(make_example(name, &stop, &model) == TAUT_INTERRUPTED && model == NULL, "stop");
        CHECK(make_example(name, &enough, &model) == TAUT_OK, "enough");
        CHECK(enough.counted.reports == k && stop.counted.reports == k, "it went on");
        CHECK(taut_record_get(taut_model_details(model), "stopped") != NULL &&
                  taut_record_get(taut_model_details(model), "least") == NULL,
              "ended at the witness");
        taut_model_free(model);
    }
}

static double detail_of(const taut_model *model, const char *name)
{
    return taut_record_number(taut_record_get(taut_model_details(model), name));
}

static double area_of(const taut_model *model)
{
    double area = NAN;
    CHECK(taut_surface_area(taut_model_surface(model, 0), &area, NULL) == TAUT_OK, "area");
    return area;
}

/* Steps by factors: each of 3 m m unknowns, m along a side of the net without its rim, a band of 3 (degree m) about, whose factor
 * takes the square of its width for each row. Ended within one there is the film of the step before. */
static void test_factors(int n)
{
    const double m = n - 2.0, factor = 3 * m * m * (9 * m) * (9 * m);
    test_problem net = problem_tetrahedron(n);
    taut_plateau_problem problem = {.net = net.data, .without_least = 1};
    watch all = {.stop_at = 0};
    taut_make_options options = {.monitor = monitor_of(&all)};
    taut_model *model = NULL;

    CHECK(taut_plateau_make(&problem, &options, &model, NULL) == TAUT_OK, "made");
    const double dirichlet = detail_of(model, "dirichlet_area");
    CHECK(all.reports > 2 * factor / TAUT_PULSE_WORK, "%d reports of %.3g operations", all.reports,
          2 * factor);
    taut_model_free(model);
    for (int k = 1; k <= all.reports; k += 1 + all.reports / 12) {
        watch stop = {.stop_at = k}, enough = {.stop_at = k, .answer = TAUT_ENOUGH};
        model = NULL;
        options.monitor = monitor_of(&stop);
        CHECK(taut_plateau_make(&problem, &options, &model, NULL) == TAUT_INTERRUPTED &&
                  model == NULL && stop.reports == k,
              "stopped at %d of %d: went on to %d", k, all.reports, stop.reports);
        options.monitor = monitor_of(&enough);
        if (taut_plateau_make(&problem, &options, &model, NULL) == TAUT_OK) {
            CHECK(enough.reports == k && area_of(model) <= dirichlet * (1 + 1e-9),
                  "ended at %d: went on to %d, area %.17g", k, enough.reports, area_of(model));
            taut_model_free(model);
        }
    }
    problem_free(&net);
}

/* Derivatives of the area: two rules at least look at all their points, 16 a cell, 12 operations for each function alive and
 * four more, twice, of which four are done at once; what follows takes as long as where there are no derivatives to find. */
static void test_gradient(int n)
{
    test_problem net = problem_tetrahedron(n);
    taut_model *model = NULL;
    double *gradient = calloc((size_t)n * (size_t)n, 3 * sizeof *gradient);
    watch all = {.stop_at = 0};
    taut_gradient_request request = {.monitor = monitor_of(&all)};
    watch solve = {.stop_at = 0};
    taut_gradient_request plain = {.of = TAUT_GRADIENT_POINTS, .monitor = monitor_of(&solve)};
    const double spans = n - 3.0, operations = 2 * 16 * spans * spans * 2 * 12 * 8 / 4;

    CHECK(gradient != NULL && taut_dirichlet_make(&net.data, NULL, &model, NULL) == TAUT_OK,
          "made");
    CHECK(taut_dirichlet_gradient(&net.data, model, &request, gradient, NULL) == TAUT_OK,
          "derived");
    plain.factors = taut_surface_points(taut_model_surface(model, 0));
    CHECK(taut_dirichlet_gradient(&net.data, model, &plain, gradient, NULL) == TAUT_OK, "plain");
    CHECK(all.reports - solve.reports >= operations / TAUT_PULSE_WORK - 1,
          "%d and %d reports, %.3g operations", all.reports, solve.reports, operations);
    for (int k = 1; k <= all.reports; k++) {
        watch stop = {.stop_at = k};
        request.monitor = monitor_of(&stop);
        gradient[0] = 7;
        CHECK(taut_dirichlet_gradient(&net.data, model, &request, gradient, NULL) ==
                      TAUT_INTERRUPTED &&
                  gradient[0] == 7 && stop.reports == k,
              "stopped at %d of %d: went on to %d", k, all.reports, stop.reports);
    }
    free(gradient);
    taut_model_free(model);
    problem_free(&net);
}

/* One of two problems. */
typedef struct dense {
    taut_harmonic_problem harmonic;
    taut_biharmonic_problem biharmonic; /* where the harmonic one has no bases */
} dense;

static taut_status make_dense(const dense *d, watch *w)
{
    const taut_make_options options = {.monitor = monitor_of(w)};
    taut_error error = {.status = TAUT_OK};
    taut_model *model = NULL;
    const taut_status status = d->harmonic.u != NULL
                                   ? taut_harmonic_make(&d->harmonic, &options, &model, &error)
                                   : taut_biharmonic_make(&d->biharmonic, &options, &model, &error);
    CHECK((model != NULL) == (status == TAUT_OK), "status %d", (int)status);
    CHECK(status == TAUT_OK || strcmp(error.reason, "interrupted") == 0, "%s", error.message);
    taut_model_free(model);
    return status;
}

/* `operations` in twice the precision, each a product of two doubles with what it rounds off, 17 operations ([Dekker1971]),
 * at least. */
static void check_dense(const dense *d, double operations, const char *name)
{
    watch all = {.stop_at = 0};
    CHECK(make_dense(d, &all) == TAUT_OK, "%s", name);
    CHECK(all.reports >= 17 * operations / TAUT_PULSE_WORK, "%s: %d reports of %.3g operations",
          name, all.reports, 17 * operations);
    for (int k = 1; k <= all.reports; k += k < 3 ? 1 : 1 + all.reports / 6) {
        watch stop = {.stop_at = k};
        CHECK(make_dense(d, &stop) == TAUT_INTERRUPTED && stop.reports == k,
              "%s: stopped at %d of %d: went on to %d", name, k, all.reports, stop.reports);
    }
}

/* Points of a net of bidegree (n, n), [n+1][n+1][3], of which the edge is marked. */
static void fill_dense(int n, double *points, unsigned char *edge)
{
    for (int k = 0; k < (n + 1) * (n + 1); k++) {
        const int i = k / (n + 1), j = k % (n + 1);
        const double u = (double)i / n, v = (double)j / n, x[3] = {u, v, u * v};
        memcpy(points + 3 * k, x, sizeof x);
        edge[k] = i == 0 || j == 0 || i == n || j == n;
    }
}

/* Harmonic and biharmonic surfaces of high degree are small nets, and long work. */
static void test_fit(int n)
{
    const size_t row = (size_t)n + 1;
    double *points = calloc(row * row, 3 * sizeof *points);
    unsigned char *edge = calloc(row * row, 1);
    taut_basis *basis = NULL;
    const taut_basis_spec spec = {.type = "bezier", .degree = n};

    CHECK(taut_basis_new(&spec, n + 1, &basis, NULL) == TAUT_OK && points != NULL && edge != NULL,
          "bases");
    fill_dense(n, points, edge);
    const dense fit = {
        .harmonic = {
            .u = basis, .v = basis, .given = TAUT_HARMONIC_BOUNDARY, .boundary = {points, edge}}};
    /* its growth: each point of a quarter by each function and each boundary point of a quarter */
    check_dense(&fit, 0.25 * n * n * 2 * n * n, "fit");
    taut_basis_free(basis);
    free(points);
    free(edge);
}

static void test_dense(int n)
{
    const size_t row = (size_t)n + 1;
    const double columns = n + 1.0, unknown = 2.0 * (n - 1), sides = 2 * columns + 3;
    double *points = calloc(row * row, 3 * sizeof *points);
    double *cross = calloc(row, 3 * sizeof *cross);
    unsigned char *edge = calloc(row * row, 1);
    taut_basis *basis = NULL;
    taut_surface *surface = NULL;
    const taut_basis_spec spec = {.type = "bezier", .degree = n};

    CHECK(taut_basis_new(&spec, n + 1, &basis, NULL) == TAUT_OK && points != NULL &&
              cross != NULL && edge != NULL,
          "bases");
    fill_dense(n, points, edge);
    for (size_t i = 0; i < row; i++) {
        cross[3 * i] = 1;
        cross[3 * i + 2] = (double)i / n;
    }
    const dense derivative = {
        .harmonic = {.u = basis,
                     .v = basis,
                     .given = TAUT_HARMONIC_DERIVATIVE,
                     .derivative = {.edge = points, .cross = cross, .allow_ill_conditioned = 1}}};
    /* its growth: of each third of 2 (n + 1) rows the sum of the products of (n + 1)/2 terms, twice, with the net */
    check_dense(&derivative, 2 * columns / 3 * columns * 3 * columns * columns, "derivative");

    CHECK(taut_surface_new("p", basis, basis, points, NULL, &surface, NULL) == TAUT_OK, "surface");
    const dense neighbour = {.biharmonic = {.given = TAUT_BIHARMONIC_NEIGHBOUR,
                                            .neighbour = {.surface = surface,
                                                          .edge = TAUT_EDGE_U1,
                                                          .contact = 1,
                                                          .allow_ill_conditioned = 1}}};
    /* least squares: 3 (n + 1)^2 rows against all columns to the right of each */
    check_dense(&neighbour, 3 * columns * columns * 2 * unknown * (unknown / 2 + sides),
                "neighbour");
    taut_surface_free(surface);
    taut_basis_free(basis);
    free(points);
    free(cross);
    free(edge);
}

int main(void)
{
    test_fit(50);
    test_dense(25);
    test_dirichlet(160);
    test_dirichlet(240);
    test_factors(34);
    test_gradient(160);
    test_branches();
    test_witness();
    test_what_follows();
    test_mesh(160);
    return check_failures != 0;
}
