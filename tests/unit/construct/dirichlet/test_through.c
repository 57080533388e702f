/* test_through.c -- points that a surface passes through: that it does; that no other net that does has less energy, by
 * quadrature of the surfaces alone; nearest points; what contradicts; and what the certificate makes of surfaces that do not. */
#include "bases.h"
#include "certificates.h"
#include "check.h"
#include "shapes.h"

#include "taut/dirichlet.h"
#include "taut/measure.h"

#include <math.h>
#include <string.h>

enum { COUNT = 7, SIZE = COUNT * COUNT, PLACES = 4 };

typedef struct scene {
    taut_basis *u, *v;
    double points[SIZE][3], weights[SIZE];
    unsigned char known[SIZE];
    taut_through through[PLACES];
    taut_dirichlet_problem problem;
} scene;

/* A rough net over a rectangle; its boundary known, or a random part of it. */
static void scene_init(scene *s, int is_pattern, int is_rational, int count)
{
    s->u = shape_bspline(3, COUNT);
    s->v = shape_bspline(2, COUNT);
    for (int k = 0; k < SIZE; k++) {
        const int i = k / COUNT, j = k % COUNT;
        const int is_rim = i == 0 || j == 0 || i == COUNT - 1 || j == COUNT - 1;
        s->points[k][0] = 3 * i + random_in(-1, 1);
        s->points[k][1] = 2 * j + random_in(-1, 1);
        s->points[k][2] = random_in(-2, 2);
        s->weights[k] = is_rational ? random_log(0.5, 2) : 1;
        s->known[k] = (unsigned char)(is_pattern ? k == 0 || random_int(0, 2) == 0 : is_rim);
    }
    for (int k = 0; k < count; k++) {
        s->through[k] = (taut_through){random_in(0.2, 0.8),
                                       random_in(0.2, 0.8),
                                       {random_in(-5, 20), random_in(-5, 15), random_in(-9, 9)}};
    }
    s->problem = (taut_dirichlet_problem){.u = s->u,
                                          .v = s->v,
                                          .points = s->points[0],
                                          .known = s->known,
                                          .weights = is_rational ? s->weights : NULL,
                                          .through = s->through,
                                          .through_count = count};
}

static void scene_free(scene *s)
{
    taut_basis_free(s->u);
    taut_basis_free(s->v);
}

static taut_model *made(const scene *s)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_dirichlet_make(&s->problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    return model;
}

static taut_surface *surface_of(const scene *s, const double *net)
{
    taut_surface *surface = NULL;
    CHECK(taut_surface_new("net", s->u, s->v, net, s->problem.weights, &surface, NULL) == TAUT_OK,
          "surface");
    return surface;
}

static double energy_of(const scene *s, const double *net)
{
    taut_surface *surface = surface_of(s, net);
    double energy = NAN;
    CHECK(taut_surface_dirichlet_energy(surface, &energy) == TAUT_OK, "energy");
    taut_surface_free(surface);
    return energy;
}

/* The heights at the places of a net whose other coordinates are 0. */
static void heights_of(const scene *s, const double *net, double *heights)
{
    taut_surface *surface = surface_of(s, net);
    for (int k = 0; k < s->problem.through_count; k++) {
        double x[3];
        taut_surface_eval(surface, s->through[k].u, s->through[k].v, 0, x);
        heights[k] = x[2];
    }
    taut_surface_free(surface);
}

/* x such that a x = b, by elimination; a is n x n, row by row. */
static void eliminate(int n, double *a, double *b)
{
    for (int k = 0; k < n; k++) {
        int most = k;
        for (int i = k + 1; i < n; i++) {
            most = fabs(a[i * n + k]) > fabs(a[most * n + k]) ? i : most;
        }
        for (int j = 0; j < n; j++) {
            const double held = a[k * n + j];
            a[k * n + j] = a[most * n + j];
            a[most * n + j] = held;
        }
        const double held = b[k];
        b[k] = b[most];
        b[most] = held;
        for (int i = 0; i < n; i++) {
            const double factor = i == k ? 0 : a[i * n + k] / a[k * n + k];
            for (int j = k; j < n; j++) {
                a[i * n + j] -= factor * a[k * n + j];
            }
            b[i] -= factor * b[k];
        }
    }
    for (int k = 0; k < n; k++) {
        b[k] /= a[k * n + k];
    }
}

/* A random move of the unknown points that leaves every place where it is. */
static void random_move(const scene *s, double *move)
{
    const int n = s->problem.through_count;
    static double nets[PLACES + 1][3 * SIZE];
    double heights[PLACES + 1][PLACES], a[PLACES * PLACES], b[PLACES] = {0};

    memset(nets, 0, sizeof nets);
    for (int m = 0; m <= n; m++) {
        for (int k = 0; k < SIZE; k++) {
            nets[m][3 * k + 2] = s->known[k] ? 0 : random_in(-1, 1);
        }
        heights_of(s, nets[m], heights[m]);
    }
    for (int k = 0; k < n; k++) {
        for (int m = 0; m < n; m++) {
            a[k * n + m] = heights[m + 1][k];
        }
        b[k] = -heights[0][k];
    }
    eliminate(n, a, b);
    memcpy(move, nets[0], sizeof nets[0]);
    for (int m = 0; m < n; m++) {
        for (int k = 0; k < 3 * SIZE; k++) {
            move[k] += b[m] * nets[m + 1][k];
        }
    }
}

/* D(x + z) - D(x - z) is four times the product of x and z, 0 where x is the least. */
static void check_least(const scene *s, const double *net, int trial)
{
    static double move[3 * SIZE], up[3 * SIZE], down[3 * SIZE];
    random_move(s, move);
    for (int k = 0; k < 3 * SIZE; k++) {
        up[k] = net[k] + move[k];
        down[k] = net[k] - move[k];
    }
    const double own = energy_of(s, net), of_move = energy_of(s, move);
    const double slope = (energy_of(s, up) - energy_of(s, down)) / sqrt(own * of_move);
    CHECK_NEAR(slope, 0, 3e-14, "trial %d", trial); /* 1.2e-14 was seen */
}

static void check_passes(const scene *s, const taut_model *model, int trial)
{
    const taut_surface *surface = taut_model_surface(model, 0);
    for (int k = 0; k < s->problem.through_count; k++) {
        double x[3];
        taut_surface_eval(surface, s->through[k].u, s->through[k].v, 0, x);
        for (int c = 0; c < 3; c++) {
            CHECK_NEAR(x[c], s->through[k].point[c], 1e-12, "trial %d, place %d", trial, k);
        }
    }
}

static void test_least(void)
{
    for (int trial = 0; trial < random_trials(40); trial++) {
        scene s;
        scene_init(&s, trial % 2, trial % 4 >= 2, random_int(1, PLACES));
        taut_model *model = made(&s);
        taut_certificate *proof = NULL;
        if (model != NULL) {
            check_passes(&s, model, trial);
            check_least(&s, taut_surface_points(taut_model_surface(model, 0)), trial);
            CHECK(taut_dirichlet_certify(model, &s.problem, NULL, &proof, NULL) == TAUT_OK,
                  "proof");
            CHECK(taut_certificate_holds(proof) == TAUT_TRUE, "trial %d: %s %g", trial,
                  claim_of(proof, "stationary")->where, claim_of(proof, "stationary")->residual);
        }
        taut_certificate_free(proof);
        taut_model_free(model);
        scene_free(&s);
    }
}

/* A point of the surface itself changes nothing; one beside it is passed through at its foot. */
static void test_nearest(void)
{
    for (int trial = 0; trial < random_trials(20); trial++) {
        scene s;
        scene_init(&s, 0, trial % 2, 0);
        taut_model *free_model = made(&s);
        const taut_surface *own = taut_model_surface(free_model, 0);
        const double u = random_in(0.1, 0.9), v = random_in(0.1, 0.9);
        double x[3][3], normal[3];
        taut_surface_eval(own, u, v, 1, x[0]);
        for (int c = 0; c < 3; c++) {
            const int d = (c + 1) % 3, e = (c + 2) % 3;
            normal[c] = x[1][d] * x[2][e] - x[1][e] * x[2][d];
        }
        const double size =
            sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        const double above = trial % 4 < 2 ? 0 : 1e-3;
        s.through[0] = (taut_through){NAN, NAN, {0}};
        for (int c = 0; c < 3; c++) {
            s.through[0].point[c] = x[0][c] + above * normal[c] / size;
        }
        s.problem.through_count = 1;
        taut_model *model = made(&s);
        const taut_record *told =
            taut_record_at(taut_record_get(taut_model_details(model), "through"), 0);
        CHECK_NEAR(taut_record_number(taut_record_get(told, "u")), u, 1e-7, "u of trial %d", trial);
        CHECK_NEAR(taut_record_number(taut_record_get(told, "v")), v, 1e-7, "v of trial %d", trial);
        const double *a = taut_surface_points(own);
        const double *b = taut_surface_points(taut_model_surface(model, 0));
        for (int k = 0; above == 0 && k < 3 * SIZE; k++) {
            CHECK_NEAR(b[k], a[k], 1e-11, "trial %d: number %d", trial, k);
        }
        taut_model_free(free_model);
        taut_model_free(model);
        scene_free(&s);
    }
}

typedef struct refusal {
    taut_through at[2];
    int count;
    taut_status status;
    const char *reason, *where;
} refusal;

static void test_refused(void)
{
    static const refusal rows[] = {
        {{{0.5, 0.5, {1, 2, 3}}, {0.5, 0.5, {1, 2, 3.5}}},
         2,
         TAUT_NO_SOLUTION,
         "through",
         "/through/1"},
        {{{0.5, 0.5, {1, 2, 3}}, {0.5, 0.5, {1, 2, 3}}}, 2, TAUT_OK, "", ""},
        {{{0, 0, {100, 2, 3}}}, 1, TAUT_NO_SOLUTION, "through", "/through/0"},
        {{{0, 0.3, {100, 2, 3}}}, 1, TAUT_NO_SOLUTION, "through", "/through/0"},
        {{{1.5, 0.5, {1, 2, 3}}}, 1, TAUT_BAD_INPUT, "value", "/through/0/u"},
        {{{0.5, -1e-9, {1, 2, 3}}}, 1, TAUT_BAD_INPUT, "value", "/through/0/v"},
        {{{0.5, NAN, {1, 2, 3}}}, 1, TAUT_BAD_INPUT, "value", "/through/0/v"},
        {{{0.5, 0.5, {1, INFINITY, 3}}}, 1, TAUT_BAD_INPUT, "value", "/through/0/point"},
        {{{0.5, 0.5, {1, 2, 3}}}, -1, TAUT_BAD_INPUT, "size", "/through"},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        scene s;
        taut_model *model = NULL;
        taut_error error = {.status = TAUT_OK};
        scene_init(&s, 0, 0, 0);
        memcpy(s.through, rows[k].at, sizeof rows[k].at);
        s.problem.through_count = rows[k].count;
        CHECK(taut_dirichlet_make(&s.problem, NULL, &model, &error) == rows[k].status,
              "row %zu: %s", k, error.message);
        if (rows[k].status != TAUT_OK) {
            CHECK(strcmp(error.reason, rows[k].reason) == 0, "row %zu: %s", k, error.reason);
            CHECK(strcmp(error.where, rows[k].where) == 0, "row %zu: %s", k, error.where);
            CHECK(model == NULL, "row %zu: a model was made", k);
        }
        taut_model_free(model);
        scene_free(&s);
    }
    scene s;
    taut_model *model = NULL;
    scene_init(&s, 0, 0, 1);
    s.problem.aspect_auto = 1;
    CHECK(taut_dirichlet_make(&s.problem, NULL, &model, NULL) == TAUT_BAD_INPUT, "with auto");
    memset(s.known, 1, sizeof s.known);
    s.problem.aspect_auto = 0;
    CHECK(taut_dirichlet_make(&s.problem, NULL, &model, NULL) == TAUT_NO_SOLUTION, "all known");
    scene_free(&s);
}

/* Claims fail where the point is elsewhere, and where the net is not the least. */
static void test_forged(void)
{
    for (int trial = 0; trial < random_trials(12); trial++) {
        scene s;
        taut_certificate *proof = NULL;
        scene_init(&s, trial % 2, 0, 3);
        taut_model *model = made(&s);
        s.through[1].point[2] += 1e-9;
        CHECK(taut_dirichlet_certify(model, &s.problem, NULL, &proof, NULL) == TAUT_OK, "proof");
        CHECK(claim_of(proof, "through")->holds == TAUT_FALSE, "moved point of trial %d", trial);
        taut_certificate_free(proof);
        s.problem.through_count = 0; /* what holds it is not told */
        CHECK(taut_dirichlet_certify(model, &s.problem, NULL, &proof, NULL) == TAUT_OK, "proof");
        CHECK(claim_of(proof, "stationary")->holds == TAUT_FALSE, "support of trial %d", trial);
        taut_certificate_free(proof);
        taut_model_free(model);
        scene_free(&s);
    }
}

int main(void)
{
    random_seed(20261123);
    test_least();
    test_nearest();
    test_refused();
    test_forged();
    return check_failures != 0;
}
