/* test_bonnet.c -- the nets of Figures 2 and 3 as docs/papers/minimal-mesh.md has them, the limit
 * of the normalised family, windows and signs, long segments, NURBS of associates, and refusals. */
#include "check.h"

#include "core/constants.h"
#include "taut/bonnet.h"
#include "taut/measure.h"
#include "taut/operations.h"

#include <string.h>

static taut_model *made(const taut_bonnet_problem *p)
{
    taut_model *model = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_bonnet_make(p, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    return model;
}

static const double *points(const taut_model *model)
{
    return taut_surface_points(taut_model_surface(model, 0));
}

/* Evaluated to 40 digits and rounded to 12: half a unit of the last is 5e-11 of the largest. */
static const double figure_2a[4][4][3] = {{{0, 0, 1},
                                           {0, .558770373098, 1},
                                           {0, 1.17328043447, 1.16395341374},
                                           {0, 1.83320326388, 1.54308063482}},
                                          {{2.72069904635, 0, 1},
                                           {2.72069904635, .558770373098, 1},
                                           {3.01807764395, 1.17328043447, 1.16395341374},
                                           {3.70573835651, 1.83320326388, 1.54308063482}},
                                          {{2.72069904635, 0, -1},
                                           {2.72069904635, .186256791033, -1},
                                           {3.01807764395, .391093478157, -1.16395341374},
                                           {3.70573835651, .476197812877, -1.54308063482}},
                                          {{1.81379936423, 0, -1},
                                           {1.81379936423, .186256791033, -1},
                                           {1.81379936423, .391093478157, -1.16395341374},
                                           {1.81379936423, .476197812877, -1.54308063482}}};
static const double figure_2b[4][4][3] = {{{0, 0, -1},
                                           {0, .135119816303, -1},
                                           {0, .323711651438, -1.626070571},
                                           {0, -2.9002149016, -3.76219569108}},
                                          {{-.360365392073, 0, -1},
                                           {-.360365392073, .135119816303, -1},
                                           {-2.6165070599, .323711651438, -1.626070571},
                                           {-10.3143627241, -2.9002149016, -3.76219569108}},
                                          {{-.360365392073, 0, 1},
                                           {-.360365392073, 2.56727650975, 1},
                                           {-2.6165070599, 6.15052137733, 1.626070571},
                                           {-10.3143627241, 12.0768442564, 3.76219569108}},
                                          {{6.48657705731, 0, 1},
                                           {6.48657705731, 2.56727650975, 1},
                                           {6.48657705731, 6.15052137733, 1.626070571},
                                           {6.48657705731, 12.0768442564, 3.76219569108}}};
static const double figure_3a[4][4][3] = {{{2.626070571, -1, 1.2018410351},
                                           {1.70183625648, 0, .778858219062},
                                           {2.626070571, 1, 1.2018410351},
                                           {6.40264103105, 2, 2.93021703572}},
                                          {{0, -1, -2.88802155766},
                                           {0, 0, -1.87159471288},
                                           {0, 1, -2.88802155766},
                                           {0, 2, -7.04130556424}},
                                          {{-2.626070571, -1, 1.2018410351},
                                           {-1.70183625648, 0, .778858219062},
                                           {-2.626070571, 1, 1.2018410351},
                                           {-6.40264103105, 2, 2.93021703572}},
                                          {{2.18566192134, -1, 1.88773686808},
                                           {1.41642754891, 0, 1.22335594491},
                                           {2.18566192134, 1, 1.88773686808},
                                           {5.32887762124, 2, 4.60250446461}}};
static const double figure_3b[4][4][3] = {{{.672008816746, -.391994096862, -.694729254094},
                                           {.530604961078, 0, -.616099021777},
                                           {.672008816746, .391994096862, -.694729254094},
                                           {1.13231399088, .736675672924, -.950690469632}},
                                          {{0, -.234290152077, -1.28581582301},
                                           {0, 0, -1.14028575315},
                                           {0, .234290152077, -1.28581582301},
                                           {0, .381013547014, -1.75955286385}},
                                          {{-.672008816746, -.391994096862, -.694729254094},
                                           {-.530604961078, 0, -.616099021777},
                                           {-.672008816746, .391994096862, -.694729254094},
                                           {-1.13231399088, .736675672924, -.950690469632}},
                                          {{-.195362651598, -.720113651671, .535088187128},
                                           {-.0425609930451, 0, .474526308934},
                                           {-.195362651598, .720113651671, .535088187128},
                                           {-.692770545571, 1.47666793231, .732232358027}}};

static void test_figures(void)
{
    static const struct {
        const double (*net)[4][3];
        taut_bonnet_problem problem;
    } figures[] = {
        {figure_2a, {.lambda = {0.5, 0.5}, .sign = 1, .alpha = TAUT_PI, .beta = 1}},
        {figure_2b, {.lambda = {0.9, 0.9}, .sign = -1, .alpha = TAUT_PI, .beta = 2}},
        {figure_3a, {.lambda = {0, 0}, .sign = -1, .alpha = 2, .beta = 1, .bspline = 1}},
        {figure_3b, {.lambda = {0.5, 0.5}, .sign = -1, .alpha = 1, .beta = 0.5, .bspline = 1}},
    };
    for (size_t f = 0; f < sizeof figures / sizeof figures[0]; f++) {
        taut_model *model = made(&figures[f].problem);
        for (int k = 0; k < 48; k++) {
            const double expected = figures[f].net[k / 12][k / 3 % 4][k % 3];
            CHECK_NEAR(points(model)[k], expected, fabs(expected) >= 10 ? 5e-11 : 1e-11,
                       "figure %zu, number %d", f, k);
        }
        taut_model_free(model);
    }
}

/* |normalised - Enneper| on [0, 1]^2 is at most 0.817 (1 - lambda) to leading order: the numbers of
 * section 2. */
static void test_limit(void)
{
    static const double lambdas[] = {0.9, 0.99, 0.999, 0.9999, 1 - 1e-9, 1 - 1e-12};
    static const double largest[] = {0.0846, 0.00820, 8.17e-4, 8.17e-5, 8.17e-10, 8.17e-13};
    for (int i = 0; i < 6; i++) {
        const taut_bonnet_problem p = {
            .lambda = {lambdas[i], lambdas[i]}, .sign = -1, .alpha = 1, .beta = 1, .normalize = 1};
        taut_model *model = made(&p);
        const taut_surface *s = taut_model_surface(model, 0);
        const double w = sqrt((1 - lambdas[i]) * (1 + lambdas[i]));
        double apart = 0;
        for (int k = 0; k < 41 * 41; k++) {
            const double a = k / 41 / 40.0, b = k % 41 / 40.0;
            const double e[3] = {-(a - a * a * a / 3 + a * b * b), b - b * b * b / 3 + a * a * b,
                                 a * a - b * b};
            double x[3];
            CHECK(taut_surface_eval(s, fmin(w * a, taut_basis_hi(taut_surface_u(s))),
                                    fmin(w * b, taut_basis_hi(taut_surface_v(s))), 0, x) == TAUT_OK,
                  "inside");
            apart = fmax(apart, hypot(x[0] - e[0], hypot(x[1] - e[1], x[2] - e[2])));
        }
        CHECK_NEAR(apart / largest[i], 1, 6e-3, "lambda 1 - %g", 1 - lambdas[i]);
        taut_model_free(model);
    }
}

/* The sign is a shift of the window; the two meshes are one surface. */
static void test_windows(void)
{
    for (int trial = 0; trial < random_trials(100); trial++) {
        const double l = random_in(0, 0.95), w = sqrt((1 - l) * (1 + l));
        taut_bonnet_problem p = {.lambda = {l, l},
                                 .sign = -1,
                                 .alpha = random_in(0.1, 1),
                                 .beta = random_in(0.1, 1),
                                 .theta = 0,
                                 .segments = {3, 2},
                                 .bspline = 1,
                                 .start = {random_in(-3, 3), random_in(-2, 2)}};
        taut_model *minus = made(&p), *plus = NULL, *whole = NULL;
        p.sign = 1;
        p.start[0] += TAUT_PI;
        plus = made(&p);
        for (int k = 0; k < 3 * 6 * 5; k++) {
            CHECK_NEAR(points(minus)[k] + (k % 3 == 0 ? l * TAUT_PI / w : 0), points(plus)[k],
                       3e-14 * (1 + fabs(points(plus)[k])) / w, "trial %d", trial);
        }
        p.sign = -1;
        p.start[0] -= TAUT_PI;
        p.bspline = 0;
        p.alpha *= p.segments[0];
        p.beta *= p.segments[1];
        p.segments[0] = p.segments[1] = 1;
        whole = made(&p);
        for (int k = 1; k < 10; k++) {
            double x[3], y[3];
            const double u = p.start[0] + p.alpha * k / 10, v = p.start[1] + p.beta * k / 10;
            taut_surface_eval(taut_model_surface(minus, 0), u, v, 0, x);
            taut_surface_eval(taut_model_surface(whole, 0), u, v, 0, y);
            for (int c = 0; c < 3; c++) {
                CHECK_NEAR(x[c], y[c], 3e-14 / w * cosh(5), "trial %d", trial);
            }
        }
        taut_model_free(minus);
        taut_model_free(plus);
        taut_model_free(whole);
    }
}

/* H and K from the net on a segment of length 100: |E - G| / E and |H| / sqrt |K| stay at rounding.
 */
static void test_long_segment(void)
{
    const taut_bonnet_problem p = {.lambda = {0.5, 0.5}, .sign = 1, .alpha = 2, .beta = 100};
    taut_model *model = made(&p);
    for (int k = 0; k <= 20 * 100; k++) {
        double x[6][3];
        taut_forms f;
        taut_surface_eval(taut_model_surface(model, 0), 2 * (k / 100) / 20.0, k % 100 + 0.5, 2,
                          &x[0][0]);
        taut_forms_of((const double(*)[3])x, &f);
        CHECK(fabs(f.e - f.g) / f.e < 1e-13 && fabs(f.f) / f.e < 1e-13, "at %d: %g", k,
              (f.e - f.g) / f.e);
        CHECK(fabs(f.l + 1) < 1e-11 * f.w && fabs(f.n - 1) < 1e-11 * f.w, "at %d: %g", k, f.l);
    }
    taut_model_free(model);
}

/* The distance proved by NURBS of a member with theta is not passed on a dense sample. */
static void test_nurbs(void)
{
    for (int trial = 0; trial < random_trials(8); trial++) {
        const taut_bonnet_problem p = {.lambda = {random_in(0, 0.9), 0},
                                       .sign = 1,
                                       .alpha = random_in(0.5, 2.5),
                                       .beta = random_in(0.5, 3),
                                       .theta = random_in(-4, 4),
                                       .bspline = trial % 2,
                                       .segments = {1 + trial % 2, 1 + trial % 2}};
        taut_model *model = made(&p);
        const taut_surface *s = taut_model_surface(model, 0);
        const taut_basis *u = taut_surface_u(s), *v = taut_surface_v(s);
        taut_surface *nurbs = NULL;
        double bound = 0, farthest = 0;
        CHECK(taut_surface_to_nurbs(s, random_log(1e-8, 1e-2), &nurbs, &bound, NULL) == TAUT_OK,
              "trial %d", trial);
        for (int k = 0; nurbs != NULL && k < 121 * 121; k++) {
            const double a =
                fmin(taut_basis_lo(u) + (taut_basis_hi(u) - taut_basis_lo(u)) * (k / 121) / 120,
                     taut_basis_hi(u));
            const double b =
                fmin(taut_basis_lo(v) + (taut_basis_hi(v) - taut_basis_lo(v)) * (k % 121) / 120,
                     taut_basis_hi(v));
            double x[3], y[3];
            taut_surface_eval(s, a, b, 0, x);
            taut_surface_eval(nurbs, a, b, 0, y);
            farthest = fmax(farthest, hypot(x[0] - y[0], hypot(x[1] - y[1], x[2] - y[2])));
        }
        CHECK(farthest <= bound && bound <= 100 * farthest, "trial %d: %g proved, %g seen", trial,
              bound, farthest);
        taut_surface_free(nurbs);
        taut_model_free(model);
    }
}

static void test_refusals(void)
{
    const taut_bonnet_problem legal = {.lambda = {0.5, 0.5}, .sign = 1, .alpha = 1, .beta = 1};
    static const double wrong[] = {NAN, INFINITY, -INFINITY, -1, 1e308};
    taut_bonnet_problem p;
    taut_model *model = NULL;
    taut_error error;

    CHECK(taut_bonnet_make(NULL, NULL, &model, NULL) == TAUT_BAD_ARGUMENT, "nothing");
    CHECK(taut_bonnet_make(&legal, NULL, NULL, NULL) == TAUT_BAD_ARGUMENT, "no place");
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        for (int member = 0; member < 5; member++) {
            p = legal;
            *(double *[]){&p.lambda[0], &p.alpha, &p.beta, &p.start[0], &p.start[1]}[member] =
                wrong[i];
            if (member >= 3 && wrong[i] == -1) {
                continue; /* legal */
            }
            CHECK(taut_bonnet_make(&p, NULL, &model, &error) != TAUT_OK && error.message[0] != '\0',
                  "member %d is %g", member, wrong[i]);
        }
    }
    for (int member = 0; member < 4; member++) {
        p = legal;
        *(int *[]){&p.sign, &p.frames, &p.segments[0], &p.segments[1]}[member] = -2147483647;
        CHECK(taut_bonnet_make(&p, NULL, &model, &error) == TAUT_BAD_INPUT, "member %d", member);
    }
    static const struct {
        double start, beta;
        const char *where, *way;
    } far[] = {
        {200, 1, "/start/1", ""}, {-200, 300, "/start/1", ""}, {100, 100, "/beta", "up to 77 "}};
    for (size_t i = 0; i < sizeof far / sizeof far[0]; i++) {
        p = legal;
        p.start[1] = far[i].start;
        p.beta = far[i].beta;
        CHECK(taut_bonnet_make(&p, NULL, &model, &error) == TAUT_NO_SOLUTION, "case %zu", i);
        CHECK(strcmp(error.reason, "far-window") == 0 && strcmp(error.where, far[i].where) == 0 &&
                  strstr(error.message, far[i].way) != NULL,
              "case %zu: %s: %s", i, error.where, error.message);
    }
    p = legal;
    p.theta = NAN;
    CHECK(taut_bonnet_make(&p, NULL, &model, &error) == TAUT_BAD_INPUT, "theta");
    p = legal;
    p.bspline = 1;
    p.segments[0] = p.segments[1] = 100000;
    p.beta = 1e-5;
    CHECK(taut_bonnet_make(&p, NULL, &model, &error) == TAUT_BAD_INPUT, "too many points");
    p = legal;
    p.normalize = 1;
    p.sign = 1;
    CHECK(taut_bonnet_make(&p, NULL, &model, &error) == TAUT_BAD_INPUT &&
              strcmp(error.where, "/sign") == 0,
          "sign: %s", error.where);
    p.sign = -1;
    p.bspline = 1;
    CHECK(taut_bonnet_make(&p, NULL, &model, &error) == TAUT_BAD_INPUT &&
              strcmp(error.where, "/mesh") == 0,
          "mesh: %s", error.where);
    p.bspline = 0;
    p.lambda[0] = p.lambda[1] = 1; /* Enneper's surface, where p has no period */
    p.start[0] = -0.5e30;
    p.alpha = 0.75e30;
    CHECK(taut_bonnet_make(&p, NULL, &model, &error) == TAUT_NO_SOLUTION &&
              strcmp(error.where, "/alpha") == 0 && strcmp(error.reason, "far-window") == 0,
          "%s: %s", error.where, error.message);
    CHECK(model == NULL, "untouched");
}

/* Stopped after the second of five frames. */
static int stop_at_second(void *context, double done, const char *what)
{
    ++*(int *)context;
    CHECK_NEAR(done, *(int *)context / 5.0, 1e-15, "%s", what);
    return done > 0.3;
}

static void test_interrupted(void)
{
    const taut_bonnet_problem p = {
        .lambda = {0, 0.5}, .frames = 5, .sign = -1, .alpha = 1, .beta = 1, .segments = {1, 1}};
    int calls = 0;
    const taut_make_options options = {.monitor = {stop_at_second, &calls}};
    taut_model *model = NULL;
    taut_error error;
    CHECK(taut_bonnet_make(&p, &options, &model, &error) == TAUT_INTERRUPTED && model == NULL &&
              calls == 2,
          "%d calls", calls);
}

int main(void)
{
    random_seed(20261124);
    test_figures();
    test_limit();
    test_windows();
    test_long_segment();
    test_nurbs();
    test_refusals();
    test_interrupted();
    return check_failures != 0;
}
