/* test_pulse.c -- taut_certify and the measures tell a monitor that work goes on, as often as there is work; after a report that is
 * answered by an end they go no further and leave nothing. What is made does not depend on who watches. */
#include "check.h"
#include "cli/embedded_files.h"
#include "core/crew.h"
#include "monitors.h"
#include "problems.h"

#include "taut/biharmonic.h"
#include "taut/construct.h"
#include "taut/measure.h"
#include "taut/read.h"

#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

/* Where it is stopped: at some three reports. */
static int next_stop(int k, int reports)
{
    return k + 1 + reports / 3;
}

static void check_same(const taut_certificate *a, const taut_certificate *b, const char *name)
{
    CHECK(taut_certificate_claim_count(a) == taut_certificate_claim_count(b), "%s", name);
    for (int i = 0; i < taut_certificate_claim_count(a); i++) {
        const taut_claim *x = taut_certificate_claim(a, i), *y = taut_certificate_claim(b, i);
        CHECK(strcmp(x->claim, y->claim) == 0 && x->holds == y->holds &&
                  memcmp(&x->residual, &y->residual, sizeof x->residual) == 0,
              "%s: %s", name, x->claim);
    }
}

static taut_status certify(const taut_model *model, const taut_problem *problem, int threads,
                           watch *w, taut_certificate **certificate)
{
    const taut_certify_options options = {.threads = threads, .monitor = monitor_of(w)};
    taut_error error = {.status = TAUT_OK};
    const taut_status status = taut_certify(model, problem, &options, certificate, &error);
    CHECK(status == TAUT_OK || strcmp(error.reason, "interrupted") == 0, "%s", error.message);
    return status;
}

/* Returns the reports. */
static int check_watched(const taut_model *model, const taut_problem *problem, int threads,
                         const char *name)
{
    watch all = {.stop_at = 0};
    taut_certificate *plain = NULL, *watched = NULL;

    CHECK(taut_certify(model, problem, NULL, &plain, NULL) == TAUT_OK, "%s", name);
    CHECK(certify(model, problem, threads, &all, &watched) == TAUT_OK, "%s", name);
    CHECK(all.reports >= 1, "%s: no report", name);
    check_same(plain, watched, name);
    taut_certificate_free(plain);
    taut_certificate_free(watched);
    for (int k = 1; k <= all.reports; k = next_stop(k, all.reports)) {
        watch stop = {.stop_at = k, .answer = k % 2 != 0 ? TAUT_STOP : TAUT_ENOUGH};
        taut_certificate *none = NULL;
        const taut_status status = certify(model, problem, threads, &stop, &none);
        if (threads > 1 && status == TAUT_OK) { /* the other thread may have had the last tasks */
            taut_certificate_free(none);
            continue;
        }
        CHECK(status == TAUT_INTERRUPTED && none == NULL && stop.reports == k,
              "%s: stopped at %d of %d, status %d, went on to %d", name, k, all.reports,
              (int)status, stop.reports);
    }
    return all.reports;
}

/* Is it one whose proof is long after its last steps? */
static int is_long(const char *name)
{
    static const char *const names[] = {"film-tent.json", "film-warp-weft.json",
                                        "pattern-cone.json"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        if (strcmp(name, names[k]) == 0) {
            return 1;
        }
    }
    return 0;
}

/* The first example of each construction, and the long ones, which report more often. */
static void test_examples(void)
{
    char last[64] = "";
    int constructions = 0;
    for (const taut_embedded *file = taut_examples; file->name != NULL; file++) {
        taut_problem *problem = NULL;
        taut_model *model = NULL;
        CHECK(taut_problem_read_text(file->text, file->length, file->name, &problem, NULL) ==
                  TAUT_OK,
              "%s", file->name);
        const int is_first = strcmp(last, taut_problem_construction(problem)) != 0;
        constructions += is_first;
        snprintf(last, sizeof last, "%s", taut_problem_construction(problem));
        if (is_first || is_long(file->name)) {
            CHECK(taut_make(problem, NULL, &model, NULL) == TAUT_OK, "%s", file->name);
            const int reports = check_watched(model, problem, 1, file->name);
            CHECK(!is_long(file->name) || reports > 8, "%s: %d reports", file->name, reports);
            check_watched(model, problem, 2, file->name);
        }
        taut_model_free(model);
        taut_problem_free(problem);
    }
    CHECK(constructions >= 10, "%d constructions", constructions);
}

/* The gradient's rule has 4 nodes a span and direction at least, the integrals' 4 and 5: so many nodes of at least 200
 * operations. */
static void test_net(int count)
{
    const double spans = count - 3.0, operations = 200 * (16 + 16 + 25) * spans * spans;
    test_problem made = problem_tetrahedron(count);
    taut_model *model = NULL;

    CHECK(taut_dirichlet_make(&made.data, NULL, &model, NULL) == TAUT_OK, "made");
    for (int threads = 1; threads <= 2; threads++) {
        watch all = {.stop_at = 0};
        const taut_certify_options options = {.threads = threads, .monitor = monitor_of(&all)};
        taut_certificate *certificate = NULL;
        CHECK(taut_dirichlet_certify(model, &made.data, &options, &certificate, NULL) == TAUT_OK,
              "certified");
        taut_certificate_free(certificate);
        CHECK(threads > 1 || all.reports > operations / TAUT_PULSE_WORK,
              "%d reports of %.3g operations", all.reports, operations);
        for (int k = 1; threads == 1 && k <= all.reports; k = next_stop(k, all.reports)) {
            watch stop = {.stop_at = k};
            const taut_certify_options stopped = {.monitor = monitor_of(&stop)};
            CHECK(taut_dirichlet_certify(model, &made.data, &stopped, &certificate, NULL) ==
                          TAUT_INTERRUPTED &&
                      stop.reports == k,
                  "stopped at %d: went on to %d", k, stop.reports);
        }
    }
    taut_model_free(model);
    problem_free(&made);
}

static taut_status measure(const taut_surface *surface, watch *w, taut_surface_measure *figures)
{
    const taut_measure_options options = {.monitor = monitor_of(w)};
    return taut_measure_surface(surface, &options, figures, NULL);
}

static void test_measure(int count)
{
    test_problem made = problem_tetrahedron(count);
    taut_model *model = NULL;
    taut_surface_measure plain, watched;
    watch all = {.stop_at = 0};

    CHECK(taut_dirichlet_make(&made.data, NULL, &model, NULL) == TAUT_OK, "made");
    const taut_surface *surface = taut_model_surface(model, 0);
    CHECK(taut_measure_surface(surface, NULL, &plain, NULL) == TAUT_OK, "measured");
    CHECK(measure(surface, &all, &watched) == TAUT_OK, "measured");
    CHECK(plain.area == watched.area && plain.max_abs_mean == watched.max_abs_mean, "the same");
    CHECK(all.reports >= 2, "%d reports", all.reports);
    for (int k = 1; k <= all.reports; k = next_stop(k, all.reports)) {
        watch stop = {.stop_at = k};
        taut_surface_measure none = {.area = -1};
        CHECK(measure(surface, &stop, &none) == TAUT_INTERRUPTED && none.area == -1 &&
                  stop.reports == k,
              "stopped at %d: went on to %d", k, stop.reports);
    }
    taut_model_free(model);
    problem_free(&made);
}

/* x, y, z x y on bezier bases of degree n, one point inside raised by `lift`. */
static taut_surface *bilinear(int n, double z, double lift)
{
    enum { MOST = 97 };
    static double points[3 * MOST * MOST];
    const taut_basis_spec spec = {.type = "bezier", .degree = n};
    taut_basis *basis = NULL;
    taut_surface *surface = NULL;
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= n; j++) {
            const double u = (double)i / n, v = (double)j / n;
            const double x[3] = {u, v, z * u * v + (i == 1 && j == 1 ? lift : 0)};
            memcpy(points + 3 * (i * (n + 1) + j), x, sizeof x);
        }
    }
    CHECK(n < MOST && taut_basis_new(&spec, n + 1, &basis, NULL) == TAUT_OK &&
              taut_surface_new("p", basis, basis, points, NULL, &surface, NULL) == TAUT_OK,
          "surface");
    taut_basis_free(basis);
    return surface;
}

/* Of a planar patch there is a proof of the sign of its Jacobian, whose coefficients are n (n + 1) m (m + 1) products of two
 * differences each, seven operations at least. */
static void test_planar(int n)
{
    const double operations = 7.0 * n * n * (n + 1) * (n + 1);
    taut_surface *flat = bilinear(n, 0, 0), *lifted = bilinear(n, 0, 1);
    watch of_flat = {.stop_at = 0}, of_lifted = {.stop_at = 0};
    taut_surface_measure figures;

    CHECK(measure(flat, &of_flat, &figures) == TAUT_OK &&
              figures.jacobian.state == TAUT_JACOBIAN_ONE_SIGN,
          "flat");
    CHECK(measure(lifted, &of_lifted, &figures) == TAUT_OK &&
              figures.jacobian.state == TAUT_JACOBIAN_NONE,
          "lifted");
    const int reports = of_flat.reports;
    for (int k = reports; k > 0 && k > reports - operations / TAUT_PULSE_WORK; k--) {
        watch stop = {.stop_at = k};
        CHECK(measure(flat, &stop, &figures) == TAUT_INTERRUPTED && stop.reports == k,
              "stopped at %d of %d: went on to %d", k, reports, stop.reports);
    }
    CHECK(reports >= 4 + 1 + operations / TAUT_PULSE_WORK, "%d reports", reports);
    taut_surface_free(flat);
    taut_surface_free(lifted);
}

/* One patch of degree n is one cell: the sums of its integrals are told row by row. Those with second derivatives take two rules
 * of n + 1 nodes each way at least; a row of nodes sums n + 1 points each way for three coordinates: once each for u, three
 * orders, once each node for v, five derivatives. */
static void test_cell(int n)
{
    const double count = n + 1.0, row = count * count * 3 * (3 + 5);
    const double operations = 2 * count * row;
    taut_surface *surface = bilinear(n, 1, 0);
    taut_surface_measure figures;
    watch all = {.stop_at = 0};

    CHECK(measure(surface, &all, &figures) == TAUT_OK, "measured");
    CHECK(all.reports > 1 + 4 + operations / TAUT_PULSE_WORK, "%d reports of %.3g operations",
          all.reports, operations);
    for (int k = 1; k <= all.reports; k++) {
        watch stop = {.stop_at = k};
        taut_surface_measure none = {.area = -1};
        CHECK(measure(surface, &stop, &none) == TAUT_INTERRUPTED && none.area == -1 &&
                  stop.reports == k,
              "stopped at %d of %d: went on to %d", k, all.reports, stop.reports);
    }
    taut_surface_free(surface);
}

/* Least bending is looked at along 2 (n - 1) directions at least, at (n + 1)^2 places each, with a power series of half as many
 * terms, six operations each. */
static void test_bending(int n)
{
    const double places = (n + 1.0) * (n + 1), operations = 2 * (n - 1) * places * places / 2 * 6;
    taut_surface *surface = bilinear(n, 1, 0);
    const taut_biharmonic_problem problem = {
        .given = TAUT_BIHARMONIC_NEIGHBOUR,
        .neighbour = {
            .surface = surface, .edge = TAUT_EDGE_U1, .contact = 1, .allow_ill_conditioned = 1}};
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    watch all = {.stop_at = 0};
    const taut_certify_options options = {.monitor = monitor_of(&all)};

    CHECK(taut_biharmonic_make(&problem, NULL, &model, NULL) == TAUT_OK, "made");
    CHECK(taut_biharmonic_certify(model, &problem, &options, &certificate, NULL) == TAUT_OK,
          "certified");
    taut_certificate_free(certificate);
    CHECK(all.reports >= operations / TAUT_PULSE_WORK, "%d reports of %.3g operations", all.reports,
          operations);
    for (int k = 1; k <= all.reports; k = next_stop(k, all.reports)) {
        watch stop = {.stop_at = k};
        const taut_certify_options stopped = {.monitor = monitor_of(&stop)};
        certificate = NULL;
        CHECK(taut_biharmonic_certify(model, &problem, &stopped, &certificate, NULL) ==
                      TAUT_INTERRUPTED &&
                  certificate == NULL && stop.reports == k,
              "stopped at %d: went on to %d", k, stop.reports);
    }
    taut_model_free(model);
    taut_surface_free(surface);
}

static _Thread_local int is_caller; /* on the thread of main */

static int report_here(void *context, double done, const char *what)
{
    const taut_monitor inner = monitor_of(context);
    CHECK(is_caller, "a report from another thread");
    return inner.progress(inner.context, done, what);
}

static void count_task(void *context, int worker, int64_t task)
{
    atomic_int *done = context;
    (void)worker;
    atomic_fetch_add(done + task, 1);
}

/* Of so many tasks each is done once; none that is not begun once it is to end. */
static void test_crew(void)
{
    enum { TASKS = 50 };
    for (int threads = 1; threads <= 4; threads++) {
        for (int stop_at = 0; stop_at <= TASKS + 1; stop_at++) {
            watch w = {.stop_at = stop_at};
            const taut_monitor monitor = {report_here, &w};
            taut_pulse pulse = {.monitor = &monitor, .what = "tasks", .done = NAN};
            const taut_crew crew = {threads, &pulse};
            atomic_int done[TASKS];
            int sum = 0;
            for (int i = 0; i < TASKS; i++) {
                atomic_init(&done[i], 0);
            }
            const int is_over = taut_crew_run(&crew, taut_crew_workers(&crew, TASKS), TASKS,
                                              TAUT_PULSE_WORK, count_task, done);
            for (int i = 0; i < TASKS; i++) {
                sum += atomic_load(&done[i]);
                CHECK(atomic_load(&done[i]) <= 1, "task %d twice", i);
            }
            CHECK(is_over == (stop_at > 0 && w.reports >= stop_at), "over");
            CHECK(is_over || sum == TASKS, "%d of %d tasks", sum, TASKS);
            CHECK(threads > 1 || !is_over || sum == stop_at, "%d tasks until report %d", sum,
                  stop_at);
        }
    }
}

int main(void)
{
    is_caller = 1;
    test_crew();
    test_examples();
    test_net(160);
    test_measure(160);
    test_planar(40);
    test_cell(96);
    test_bending(21);
    return check_failures != 0;
}
