/* test_panels.c -- conical panels lie in the surface's own tangent planes, circular vertices are
 * those of the published formula, both have the angles they are named for; and what is refused. */
#include "certificates.h"
#include "check.h"
#include "core/pulse.h"
#include "monitors.h"

#include "core/constants.h"
#include "taut/panels.h"
#include "taut/read.h"

#include <string.h>

static const double *vertices(const taut_model *panels)
{
    return taut_surface_points(taut_model_surface(panels, 0));
}

static taut_bonnet_problem random_problem(void)
{
    taut_bonnet_problem p = {.sign = random_int(0, 1) ? 1 : -1,
                             .alpha = random_in(0.5, 2.5),
                             .beta = random_in(0.5, 2),
                             .theta = random_int(0, 3) == 0 ? TAUT_PI : 0,
                             .start = {random_in(-2, 1), random_in(-2, 1)},
                             .bspline = random_int(0, 1)};
    const double lambdas[] = {0, 0.9, random_in(0, 0.9)};
    p.lambda[0] = p.lambda[1] = lambdas[random_int(0, 2)];
    if (random_int(0, 2) == 0) {
        p.normalize = 1;
        p.sign = -1;
        p.bspline = 0;
        p.alpha = random_in(0.5, 1.5);
        if (random_int(0, 1)) {
            p.lambda[0] = p.lambda[1] = random_int(0, 1) ? 1 : 1 - random_log(1e-12, 0.1);
        }
    }
    p.segments[0] = p.bspline ? random_int(1, 3) : 1;
    p.segments[1] = p.bspline ? random_int(1, 3) : 1;
    return p;
}

/* Panel (i, j) in the tangent plane at the middle of its parameters; distances over the size. */
static void in_tangent_planes(const taut_surface *surface, const taut_model *panels,
                              const int divide[2], int trial)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const int nv = divide[1] + 1;
    for (int k = 0; k < divide[0] * divide[1]; k++) {
        const int i = k / divide[1], j = k % divide[1];
        const double a = (taut_basis_hi(u) - taut_basis_lo(u)) / divide[0];
        const double b = (taut_basis_hi(v) - taut_basis_lo(v)) / divide[1];
        double x[3][3], n[3], length = 0, size = 0, farthest = 0;
        taut_surface_eval(surface, taut_basis_lo(u) + (i + 0.5) * a,
                          taut_basis_lo(v) + (j + 0.5) * b, 1, &x[0][0]);
        for (int c = 0; c < 3; c++) {
            const int d = (c + 1) % 3, e = (c + 2) % 3;
            n[c] = x[1][d] * x[2][e] - x[1][e] * x[2][d];
            length = hypot(length, n[c]);
        }
        for (int corner = 0; corner < 4; corner++) {
            const double *p = vertices(panels) + 3 * ((i + corner / 2) * nv + j + corner % 2);
            double apart = 0, away = 0;
            for (int c = 0; c < 3; c++) {
                apart += n[c] / length * (p[c] - x[0][c]);
                away = hypot(away, p[c] - x[0][c]);
                size = fmax(size, fabs(p[c]));
            }
            farthest = fmax(farthest, fabs(apart));
            size = fmax(size, away);
        }
        /* normals from the net are good to the rounding of points over a cell's share of them */
        CHECK(farthest <= 1e-12 * size, "trial %d panel %d %d: %g of %g", trial, i, j, farthest,
              size);
    }
}

/* [(lambda n sin a + s sin u cosh v)/w, ...] up to a translation. */
static void by_formula(const taut_bonnet_problem *p, const taut_model *panels, const int divide[2],
                       int trial)
{
    const double l = p->lambda[0], w = sqrt((1 - l) * (1 + l)), s = p->sign;
    const double a = p->alpha * p->segments[0] / divide[0];
    const double b = p->beta * p->segments[1] / divide[1], side = cos(p->theta);
    double offset[3] = {0, 0, 0}, size = 0;
    for (int k = 0; k < (divide[0] + 1) * (divide[1] + 1); k++) {
        const int n = k / (divide[1] + 1), m = k % (divide[1] + 1);
        const double u = p->start[0] + n * a, v = p->start[1] + m * b;
        const double x[3] = {(l * n * sin(a) + s * sin(u) * cosh(v)) / w,
                             (m * sinh(b) + s * l * cos(u) * sinh(v)) / w, s * cos(u) * cosh(v)};
        for (int c = 0; c < 3; c++) {
            const double apart = vertices(panels)[3 * k + c] - side * x[c];
            size = fmax(size, fabs(x[c]) + (c < 2 ? (fabs(u) + fabs(v)) / w : 0));
            offset[c] = k == 0 ? apart : offset[c];
            CHECK_NEAR(apart, offset[c], 1e-14 * size, "trial %d vertex %d %d", trial, n, m);
        }
    }
}

static void test_panels(void)
{
    for (int trial = 0; trial < random_trials(150); trial++) {
        const taut_bonnet_problem p = random_problem();
        taut_panels_options o = {.kind = TAUT_PANELS_CONICAL,
                                 .divide = {random_int(8, 20), random_int(8, 20)}};
        taut_model *model = NULL, *panels = NULL, *again = NULL;
        taut_error error = {.message = ""};
        o.divide[0] *= p.segments[0];
        o.divide[1] *= p.segments[1];
        CHECK(taut_bonnet_make(&p, NULL, &model, &error) == TAUT_OK, "%s", error.message);
        CHECK(taut_panels_of_bonnet(&p, &o, &panels, &error) == TAUT_OK, "trial %d: %s", trial,
              error.message);
        if (panels != NULL) {
            in_tangent_planes(taut_model_surface(model, 0), panels, o.divide, trial);
            /* rounding of coordinates over panels of a hundredth of the size */
            CHECK(detail_of(panels, "planarity") < 1e-12, "trial %d: %g", trial,
                  detail_of(panels, "planarity"));
            CHECK(detail_of(panels, "balance") < 1e-10, "trial %d: %g", trial,
                  detail_of(panels, "balance"));
        }
        taut_model_free(panels);
        panels = NULL;
        o.kind = TAUT_PANELS_CIRCULAR;
        CHECK(taut_panels_of_bonnet(&p, &o, &panels, &error) == TAUT_OK, "trial %d: %s", trial,
              error.message);
        CHECK(detail_of(panels, "planarity") < 1e-12 && detail_of(panels, "circle") < 1e-10,
              "trial %d: %g %g", trial, detail_of(panels, "planarity"),
              detail_of(panels, "circle"));
        if (!p.normalize) {
            by_formula(&p, panels, o.divide, trial);
            CHECK(taut_panels_of_model(model, &o, &again, &error) == TAUT_OK, "trial %d: %s", trial,
                  error.message);
            for (int k = 0; again != NULL && k < 3 * (o.divide[0] + 1) * (o.divide[1] + 1); k++) {
                CHECK_NEAR(vertices(again)[k], vertices(panels)[k],
                           1e-10 * (1 + fabs(vertices(panels)[k])), "trial %d, %d", trial, k);
            }
        }
        taut_model_free(again);
        taut_model_free(panels);
        taut_model_free(model);
    }
}

/* Halving the steps leaves a quarter of the distance. */
static void test_order(void)
{
    const taut_bonnet_problem p = {
        .lambda = {0.4, 0.4}, .sign = 1, .alpha = 2, .beta = 1.5, .start = {0.2, -0.5}};
    for (int kind = 0; kind < 2; kind++) {
        double last = 0;
        for (int n = 16; n <= 64; n *= 2) {
            const taut_panels_options o = {.kind = (taut_panels_kind)kind, .divide = {n, n}};
            taut_model *panels = NULL;
            CHECK(taut_panels_of_bonnet(&p, &o, &panels, NULL) == TAUT_OK, "%d", n);
            const double distance = detail_of(panels, "distance");
            CHECK(n == 16 || fabs(last / distance - 4) < 0.1, "kind %d, %d: %g after %g", kind, n,
                  distance, last);
            last = distance;
            taut_model_free(panels);
        }
    }
}

static taut_status refused(taut_bonnet_problem p, int nu, int nv)
{
    const taut_panels_options o = {.kind = TAUT_PANELS_CONICAL, .divide = {nu, nv}};
    taut_model *panels = NULL;
    taut_error error;
    const taut_status status = taut_panels_of_bonnet(&p, &o, &panels, &error);
    CHECK(panels == NULL && (status == TAUT_OK || error.message[0] != '\0'), "untouched");
    return status;
}

static void test_refusals(void)
{
    const taut_bonnet_problem p = {.lambda = {0.4, 0.4}, .sign = 1, .alpha = 2, .beta = 1.5};
    taut_bonnet_problem q = p;
    q.theta = 0.3;
    CHECK(refused(q, 8, 8) == TAUT_NO_SOLUTION, "theta");
    q = p;
    q.alpha = TAUT_PI;
    CHECK(refused(q, 1, 8) == TAUT_NO_SOLUTION, "a step of pi");
    q.lambda[0] = q.lambda[1] = 0.99;
    q.sign = -1;
    q.alpha = 2;
    CHECK(refused(q, 2, 1) == TAUT_NO_SOLUTION, "steps too large");
    q.lambda[0] = 2;
    CHECK(refused(q, 8, 8) == TAUT_NO_SOLUTION, "no such surface");
    CHECK(refused(p, 999999, 999999) == TAUT_BAD_INPUT, "too many");
    CHECK(refused(p, -1, 8) == TAUT_BAD_ARGUMENT, "negative");
    CHECK(taut_panels_of_model(NULL, NULL, NULL, NULL) == TAUT_BAD_ARGUMENT, "nothing");
    CHECK(taut_panels_of_problem(NULL, NULL, NULL, NULL) == TAUT_BAD_ARGUMENT, "nothing");
}

/* Of several surfaces one may be asked for by its name; who watches is asked after each. */
static void test_names(void)
{
    const taut_bonnet_problem two = {
        .lambda = {0.2, 0.6}, .frames = 2, .sign = -1, .alpha = 1, .beta = 1};
    taut_panels_options o = {.kind = TAUT_PANELS_CIRCULAR, .divide = {3, 4}};
    taut_model *model = NULL, *all = NULL;
    taut_error error = {.message = ""};

    CHECK(taut_bonnet_make(&two, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_panels_of_model(model, &o, &all, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_model_surface_count(all) == 2, "two");
    for (int k = 0; k < 2; k++) {
        taut_model *one = NULL;
        o.surface = taut_surface_name(taut_model_surface(model, 1));
        CHECK((k == 0 ? taut_panels_of_model(model, &o, &one, &error)
                      : taut_panels_of_bonnet(&two, &o, &one, &error)) == TAUT_OK,
              "%s", error.message);
        CHECK(taut_model_surface_count(one) == 1, "one of them");
        for (int i = 0; i < 3 * 20; i++) {
            const double *expected = taut_surface_points(taut_model_surface(all, 1));
            CHECK_NEAR(vertices(one)[i], expected[i], k == 0 ? 0 : 1e-12, "%d, %d", k, i);
        }
        taut_model_free(one);
        one = NULL;
        o.surface = NULL;
        watch once = {.stop_at = 1};
        o.monitor = monitor_of(&once);
        CHECK((k == 0 ? taut_panels_of_model(model, &o, &one, &error)
                      : taut_panels_of_bonnet(&two, &o, &one, &error)) == TAUT_INTERRUPTED &&
                  one == NULL && once.reports == 1 && strcmp(error.reason, "interrupted") == 0,
              "%s", error.message);
        o.monitor = (taut_monitor){NULL, NULL};
    }
    taut_model_free(all);
    taut_model_free(model);
}

/* A net of the family, given as a dirichlet problem with every point known: made, recognised and
 * cut as the problem it came from; in the unit of its document. */
static void test_problem_of_points(void)
{
    const taut_bonnet_problem p = {.lambda = {0.4, 0.4}, .sign = -1, .alpha = 1.25, .beta = 1.5};
    const taut_panels_options o = {.kind = TAUT_PANELS_CONICAL, .divide = {6, 5}};
    taut_model *model = NULL, *panels = NULL, *expected = NULL;
    taut_problem *problem = NULL;
    taut_error error = {.message = ""};
    char text[4096];
    int length = snprintf(text, sizeof text,
                          "{\"taut\": 1, \"construct\": \"dirichlet\", \"unit\": \"ft\","
                          " \"u\": {\"type\": \"c-bezier\", \"alpha\": 1.25},"
                          " \"v\": {\"type\": \"h-bezier\", \"beta\": 1.5}, \"points\": [");

    CHECK(taut_bonnet_make(&p, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    for (int k = 0; k < 16; k++) {
        const double *x = taut_surface_points(taut_model_surface(model, 0)) + 3 * k;
        length += snprintf(text + length, sizeof text - (size_t)length, "%s[%.17g, %.17g, %.17g]%s",
                           k % 4 == 0 ? "[" : "", x[0], x[1], x[2],
                           k == 15      ? "]]}"
                           : k % 4 == 3 ? "], "
                                        : ", ");
    }
    CHECK(taut_problem_read_text(text, (size_t)length, "text", &problem, &error) == TAUT_OK, "%s",
          error.message);
    CHECK(taut_panels_of_problem(problem, &o, &panels, &error) == TAUT_OK &&
              taut_panels_of_bonnet(&p, &o, &expected, &error) == TAUT_OK,
          "%s", error.message);
    if (panels != NULL && expected != NULL) {
        CHECK(strcmp(taut_model_unit(panels), "ft") == 0, "in %s", taut_model_unit(panels));
        for (int i = 0; i < 3 * 7 * 6; i++) {
            CHECK_NEAR(vertices(panels)[i], vertices(expected)[i], 1e-11, "%d", i);
        }
    }
    taut_model_free(expected);
    taut_model_free(panels);
    taut_problem_free(problem);
    taut_model_free(model);
}

/* Enneper's surface is recognised, but its panels follow from its problem alone; a model may have
 * no surface at all. */
static void test_refused_models(void)
{
    const taut_bonnet_problem enneper = {
        .lambda = {1, 1}, .sign = -1, .alpha = 0.5, .beta = 0.5, .normalize = 1};
    taut_model *model = NULL, *empty = NULL, *panels = NULL;
    taut_error error = {.message = ""};

    CHECK(taut_bonnet_make(&enneper, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_panels_of_model(model, NULL, &panels, &error) == TAUT_NO_SOLUTION &&
              strcmp(error.where, "/surfaces/0") == 0 && error.found == 1 && panels == NULL &&
              strcmp(error.reason, "enneper") == 0,
          "%s: %s", error.where, error.message);
    CHECK(taut_model_new(&empty) == TAUT_OK, "a model");
    CHECK(taut_panels_of_model(empty, NULL, &panels, &error) == TAUT_NO_SOLUTION &&
              strcmp(error.reason, "no-surface") == 0 && error.found == 0 && panels == NULL,
          "%s: %s", error.where, error.message);
    CHECK(taut_panels_of_bonnet(NULL, NULL, &panels, &error) == TAUT_BAD_ARGUMENT &&
              taut_panels_of_bonnet(&enneper, NULL, NULL, &error) == TAUT_BAD_ARGUMENT &&
              taut_panels_of_model(model, NULL, NULL, &error) == TAUT_BAD_ARGUMENT &&
              panels == NULL,
          "nothing to work on, or no place");
    taut_model_free(empty);
    taut_model_free(model);
}

/* A vertex and its angles take some thousands of operations: twelve sines and cosines, hypotenuses, arcs of eight angles. */
static void test_told(void)
{
    enum { SIDE = 200 };
    const taut_bonnet_problem problem = {.lambda = {0.3, 0.3}, .sign = 1, .alpha = 1, .beta = 1};
    watch all = {.stop_at = 0};
    taut_panels_options o = {.divide = {SIDE, SIDE}, .monitor = monitor_of(&all)};
    taut_model *made = NULL;
    taut_error error = {.status = TAUT_OK};

    CHECK(taut_panels_of_bonnet(&problem, &o, &made, &error) == TAUT_OK, "%s", error.message);
    taut_model_free(made);
    CHECK(all.reports >= 3e3 * SIDE * SIDE / TAUT_PULSE_WORK, "%d reports", all.reports);
    for (int k = 1; k <= all.reports; k++) {
        watch stop = {.stop_at = k};
        made = NULL;
        o.monitor = monitor_of(&stop);
        CHECK(taut_panels_of_bonnet(&problem, &o, &made, &error) == TAUT_INTERRUPTED &&
                  made == NULL && stop.reports == k,
              "stopped at %d of %d: went on to %d", k, all.reports, stop.reports);
    }
}

int main(void)
{
    random_seed(20261123);
    test_panels();
    test_order();
    test_refusals();
    test_names();
    test_problem_of_points();
    test_refused_models();
    test_told();
    return check_failures != 0;
}
