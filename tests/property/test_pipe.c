/* test_pipe.c -- pipes over random blends: the largest radius against the global radius of
 * curvature, areas and volumes against quadrature, verdicts under scaling and shifting, reversal.
 */
#include "certificates.h"
#include "check.h"
#include "pipes.h"
#include "touching.h"

#include "core/constants.h"
#include "core/vec3.h"

#include <stdlib.h>
#include <string.h>

/* Ends anywhere with any directions; or loops that come back beside where they began,
 * near themselves or their straight pipes. */
static taut_pipe_problem random_blend(int loop)
{
    taut_pipe_problem problem = {.axis = {.kind = TAUT_PIPE_ENDS}, .section = {.radius = 1e-3}};
    taut_pipe_end *const from = &problem.axis.ends[0], *const to = &problem.axis.ends[1];
    for (int side = 0; side < 2; side++) {
        for (int k = 0; k < 3; k++) {
            problem.axis.ends[side].point[k] = random_in(-1, 1);
            problem.axis.ends[side].direction[k] = random_in(-1, 1);
        }
        problem.axis.ends[side].handle = loop ? random_in(1.5, 3) : random_in(0.3, 3);
        problem.lengths[side] = random_int(0, 1) == 0 ? random_in(0.5, 4) : 0;
    }
    if (loop) { /* at right angles, more or less: a round loop */
        const double part =
            taut_dot(from->direction, to->direction) / taut_dot(from->direction, from->direction);
        taut_add_scaled(-part + random_in(-0.3, 0.3), from->direction, to->direction);
        for (int k = 0; k < 3; k++) {
            to->point[k] = from->point[k] + random_in(-0.2, 0.2);
        }
    }
    problem.shape.alpha = loop ? random_in(-0.5, 1) : random_in(-2, 1);
    problem.shape.beta = loop ? random_in(-1, 1) : random_in(-3, 3);
    problem.shape.gamma = loop ? random_in(-0.5, 1) : random_in(-2, 1);
    if (random_int(0, 2) == 0) {
        problem.joint = TAUT_PIPE_G2;
        problem.shape.beta = 0;
    }
    return problem;
}

/* The composite axis of a problem as the test sees it: polynomials evaluated by the basis. */
typedef struct axis {
    const taut_curve *curve;
    double ends[2][3], leave[2][3]; /* where the straight pipes begin, and where they go */
    double lengths[2];              /* at most so far: all contacts are nearer */
    double *run;                    /* arc lengths along the blend, double[STEPS + 1] */
    double near; /* pairs nearer along the axis are left out: two arcs of curvature up to kappa
                  * touch no tangent ball of radius 1 / kappa within pi / kappa */
} axis;

enum { ON_PIPE_1, ON_BLEND, ON_PIPE_2, STEPS = 1000 };

/* Point and derivatives at parameter t in [0, 1] of one of the three parts. */
static void evaluate(const axis *a, int part, double t, double x[3][3])
{
    memset(x, 0, 9 * sizeof(double));
    if (part == ON_BLEND) {
        taut_curve_eval(a->curve, t, 2, &x[0][0]);
        return;
    }
    const int side = part == ON_PIPE_2;
    for (int k = 0; k < 3; k++) {
        x[1][k] = a->lengths[side] * a->leave[side][k];
        x[0][k] = a->ends[side][k] + t * x[1][k];
    }
}

/* Arc length from the start of the blend, negative on pipe 1. */
static double position(const axis *a, int part, double t)
{
    const int i = (int)fmin(STEPS - 1, t * STEPS);
    return part == ON_PIPE_1   ? -t * a->lengths[0]
           : part == ON_PIPE_2 ? a->run[STEPS] + t * a->lengths[1]
                               : a->run[i] + (t * STEPS - i) * (a->run[i + 1] - a->run[i]);
}

static axis axis_of(const taut_curve *curve, const taut_pipe_problem *problem)
{
    axis a = {.curve = curve, .run = calloc(STEPS + 1, sizeof(double))};
    for (int i = 0; i < STEPS; i++) {
        double x[2][3], y[2][3];
        taut_curve_eval(curve, (double)i / STEPS, 0, x[0]);
        taut_curve_eval(curve, (i + 1.0) / STEPS, 0, y[0]);
        a.run[i + 1] = a.run[i] + taut_distance(x[0], y[0]);
    }
    for (int side = 0; side < 2; side++) {
        double x[2][3];
        taut_curve_eval(curve, side, 1, &x[0][0]);
        memcpy(a.ends[side], x[0], sizeof x[0]);
        const double speed = taut_norm(x[1]);
        for (int k = 0; k < 3; k++) {
            a.leave[side][k] = (side == 0 ? -x[1][k] : x[1][k]) / speed;
        }
        a.lengths[side] = problem->lengths[side] > 0 ? problem->lengths[side] : 40;
    }
    return a;
}

/* A pair of points of two parts. */
typedef struct pair {
    const axis *a;
    int part[2];
} pair;

/* INFINITY for pairs that are left out. */
static double circle_at(const void *context, const double t[2])
{
    const pair *p = context;
    double x[3][3], y[3][3];
    if (fabs(position(p->a, p->part[0], t[0]) - position(p->a, p->part[1], t[1])) < p->a->near) {
        return INFINITY;
    }
    evaluate(p->a, p->part[0], t[0], x);
    evaluate(p->a, p->part[1], t[1], y);
    return touching_radius((const double(*)[3])x, y[0]);
}

static double radius_of_curvature(const void *context, double t)
{
    double x[3][3];
    evaluate(context, ON_BLEND, t, x);
    return touching_curvature_radius((const double(*)[3])x);
}

static double least_radius_of_curvature(const axis *a)
{
    enum { N = 2000 };
    double best = INFINITY, at = 0;
    for (int i = 0; i <= N; i++) {
        const double r = radius_of_curvature(a, (double)i / N);
        at = r < best ? (double)i / N : at;
        best = fmin(best, r);
    }
    return fmin(
        best, touching_least(radius_of_curvature, a, fmax(0, at - 1.0 / N), fmin(1, at + 1.0 / N)));
}

/* The infimum over all pairs of points: a grid on the blend and both pipes, the best of each pair
 * of parts made exact. Free ends by the distance to them: half of it binds ([WangBai2018] 4.4). */
static double global_radius(axis *a, const taut_pipe_problem *problem)
{
    enum { N = 120 };
    static double grid[3][N + 1][3][3];
    double best = least_radius_of_curvature(a);
    const double local = best;
    for (int i = 0; i < 3 * (N + 1); i++) {
        evaluate(a, i / (N + 1), (double)(i % (N + 1)) / N, grid[i / (N + 1)][i % (N + 1)]);
    }
    a->near = 0.5 * best;
    for (int p = 0; p < 9; p++) {
        const pair parts = {a, {p / 3, p % 3}};
        touching_kept kept = {.most = 4};
        for (int k = 0; k < (N + 1) * (N + 1); k++) {
            const int i = k / (N + 1), j = k % (N + 1);
            const double at[2] = {(double)i / N, (double)j / N};
            if (fabs(position(a, p / 3, at[0]) - position(a, p % 3, at[1])) >= a->near) {
                touching_keep(
                    &kept, touching_radius((const double(*)[3])grid[p / 3][i], grid[p % 3][j][0]),
                    at);
            }
        }
        for (int k = 0; k < kept.count; k++) {
            best = fmin(best, touching_descend(circle_at, &parts, kept.at[k], 0.5 / N, 1e-10));
        }
    }
    /* free ends: distances to all points farther along the axis than pi times the local radius */
    for (int side = 0; side < 2; side++) {
        double end[3][3], length = 0, before[3];
        if (!(problem->lengths[side] > 0)) {
            continue;
        }
        evaluate(a, side == 0 ? ON_PIPE_1 : ON_PIPE_2, 1, end);
        memcpy(before, end[0], sizeof before);
        for (int i = 0; i <= 3 * 4000; i++) { /* from the free end through all parts */
            const int part = side == 0 ? i / 4001 : 2 - i / 4001;
            double t = (i - 4001 * (i / 4001)) / 4000.0, x[3][3];
            if (part == (side == 0 ? ON_PIPE_1 : ON_PIPE_2) || (part == ON_BLEND && side == 1)) {
                t = 1 - t;
            }
            evaluate(a, part, fmin(1, fmax(0, t)), x);
            length += taut_distance(x[0], before);
            memcpy(before, x[0], sizeof before);
            if (length >= TAUT_PI * local) {
                best = fmin(best, 0.5 * taut_distance(x[0], end[0]));
            }
        }
    }
    return best;
}

/* Construction, certificate and the global radius agree; the construction's comes out of its
 * refusal of a radius that is too large. */
static void test_largest_radius(void)
{
    int by_distance = 0, compared = 0;
    for (int trial = 0; trial < random_trials(16); trial++) {
        taut_pipe_problem problem = random_blend(trial % 3 > 0);
        taut_model *model = NULL;
        taut_certificate *certificate = NULL;
        taut_error error = {.message = ""};
        const taut_make_options coarse = {.tolerance = 1e-2};
        if (taut_pipe_make(&problem, &coarse, &model, NULL) != TAUT_OK) {
            continue; /* too sharp even for a thousandth */
        }
        CHECK(taut_pipe_certify(model, &problem, NULL, &certificate, NULL) == TAUT_OK, "proof");
        const double rho = figure_of(certificate, "largest_radius");
        axis a = axis_of(taut_model_curve(model, 0), &problem);
        const double reference = global_radius(&a, &problem);
        free(a.run);
        /* free ends are sampled, 1e-3 apart at most along the axis: quadratic at a minimum */
        const double tolerance = problem.lengths[0] + problem.lengths[1] > 0 ? 2e-5 : 2e-7;
        CHECK_NEAR(rho, reference, tolerance * reference, "trial %d", trial);
        by_distance +=
            strcmp(
                taut_record_text(taut_record_get(taut_certificate_figures(certificate), "binding")),
                "distance") == 0;
        compared++;
        problem.section.radius = 1.001 * rho;
        taut_model *none = NULL;
        CHECK(taut_pipe_make(&problem, &coarse, &none, &error) == TAUT_NO_SOLUTION, "trial %d",
              trial);
        CHECK_NEAR(error.limit, rho, 1e-9 * rho, "trial %d: %s", trial, error.message);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
    CHECK(compared > 2 && (by_distance > 3 || compared < 12), "%d pairs bind of %d", by_distance,
          compared);
}

/* Pappus: 2 pi a L and pi a^2 L, against the surface made to 1e-11, ends closed by discs. */
static void test_pappus(void)
{
    const int wanted = random_trials(4);
    int done = 0; /* of tubes that are to be had, either joint in turns */
    for (int trial = 0; trial < 200 && done < wanted; trial++) {
        const taut_make_options fine = {.tolerance = 1e-11};
        const taut_certify_options proof = {.tolerance = 1e-11};
        taut_pipe_problem problem = random_blend(trial % 3 > 0);
        taut_model *model = NULL;
        taut_certificate *certificate = NULL;
        double area = 0, volume = 0;
        problem.lengths[0] = problem.lengths[1] = 0;
        problem.section.radius = 0.05;
        problem.joint = done % 2 == 0 ? TAUT_PIPE_G1 : TAUT_PIPE_G2;
        problem.shape.beta = 0;
        problem.frame = done % 2 == 0 ? TAUT_PIPE_FRENET : TAUT_PIPE_ROTATION_MINIMIZING;
        if (taut_pipe_make(&problem, &fine, &model, NULL) != TAUT_OK) {
            continue;
        }
        CHECK(taut_pipe_certify(model, &problem, &proof, &certificate, NULL) == TAUT_OK, "proof");
        pipe_integrate(taut_model_surface(model, 0), &area, &volume);
        for (int side = 0; side < 2; side++) { /* discs look back at V_0, on at V_3 */
            double x[2][3];
            taut_curve_eval(taut_model_curve(model, 0), side, 1, &x[0][0]);
            volume += (side == 0 ? -1 : 1) * taut_dot(x[0], x[1]) / taut_norm(x[1]) * TAUT_PI *
                      0.05 * 0.05 / 3;
        }
        CHECK_NEAR(area, figure_of(certificate, "area"), 1e-10 * area, "trial %d", trial);
        CHECK_NEAR(volume, figure_of(certificate, "volume"), 1e-10 * volume, "trial %d", trial);
        CHECK(figure_of(certificate, "fit_error") <= 1e-11, "trial %d", trial);
        taut_certificate_free(certificate);
        taut_model_free(model);
        done++;
    }
    CHECK(done == wanted, "%d tubes of %d", done, wanted);
}

/* The same pipe, x -> scale x + shift. */
static taut_pipe_problem moved(const taut_pipe_problem *problem, double scale, double shift)
{
    taut_pipe_problem other = *problem;
    other.section.radius *= scale;
    for (int side = 0; side < 2; side++) {
        for (int k = 0; k < 3; k++) {
            other.axis.ends[side].point[k] = scale * other.axis.ends[side].point[k] + shift;
        }
        other.axis.ends[side].handle *= scale;
        other.lengths[side] *= scale;
    }
    return other;
}

/* In millimetres, micrometres or metres, at the origin or a kilometre away: the verdict is one. */
static void test_scale_and_shift(void)
{
    static const double moves[][2] = {{1e-3, 0}, {1e3, 0},   {1e-3, 1e6},
                                      {1, 1e9},  {1e-80, 0}, {1e80, 0}};
    for (int trial = 0; trial < random_trials(4); trial++) {
        taut_pipe_problem problem = random_blend(trial % 3 > 0);
        taut_error error = {.message = ""};
        taut_model *model = NULL;
        problem.section.radius = 1e4; /* refused, with the largest */
        if (taut_pipe_make(&problem, NULL, &model, &error) != TAUT_NO_SOLUTION) {
            CHECK(0, "a radius of 10 km");
            continue;
        }
        const double rho = error.limit;
        if (!(rho > 0.01)) {
            continue;
        }
        for (size_t i = 0; i < sizeof moves / sizeof moves[0]; i++) {
            for (int above = 0; above < 2; above++) {
                taut_certificate *certificate = NULL;
                const taut_make_options coarse = {.tolerance = 1e-3};
                const taut_certify_options proof = {.tolerance = 1e-3};
                problem.section.radius = above ? 1.0001 * rho : 0.9999 * rho;
                taut_pipe_problem other = moved(&problem, moves[i][0], moves[i][1]);
                const taut_status status = taut_pipe_make(&other, &coarse, &model, &error);
                CHECK(status == (above ? TAUT_NO_SOLUTION : TAUT_OK), "trial %d, move %zu: %s",
                      trial, i, error.message);
                if (status != TAUT_OK) {
                    CHECK_NEAR(error.limit / moves[i][0], rho, 2e-5 * rho, "trial %d, move %zu",
                               trial, i);
                    continue;
                }
                CHECK(taut_pipe_certify(model, &other, &proof, &certificate, NULL) == TAUT_OK,
                      "proof");
                for (int k = 0; k < taut_certificate_claim_count(certificate); k++) {
                    const taut_claim *claim = taut_certificate_claim(certificate, k);
                    CHECK(claim->holds != TAUT_FALSE, "trial %d, move %zu: %s %g, limit %g, %s",
                          trial, i, claim->claim, claim->residual, claim->limit, claim->where);
                    CHECK(claim->holds == TAUT_TRUE || strcmp(claim->claim, "embedded") != 0,
                          "trial %d, move %zu: embedded %g, %s", trial, i, claim->residual,
                          claim->where);
                }
                taut_certificate_free(certificate);
                taut_model_free(model);
                model = NULL;
            }
        }
    }
}

/* A pipe that flows the other way is the same pipe. */
static void test_reversal(void)
{
    for (int trial = 0; trial < random_trials(8); trial++) {
        taut_pipe_problem problem = random_blend(trial % 3 > 0), back = problem;
        taut_model *models[2] = {NULL, NULL};
        taut_certificate *certificates[2] = {NULL, NULL};
        const taut_make_options coarse = {.tolerance = 1e-2};
        for (int side = 0; side < 2; side++) {
            back.axis.ends[side] = problem.axis.ends[1 - side];
            back.lengths[side] = problem.lengths[1 - side];
            for (int k = 0; k < 3; k++) {
                back.axis.ends[side].direction[k] *= -1;
            }
        }
        back.shape.alpha = problem.shape.gamma;
        back.shape.beta = -problem.shape.beta;
        back.shape.gamma = problem.shape.alpha;
        const taut_status first = taut_pipe_make(&problem, &coarse, &models[0], NULL);
        CHECK(taut_pipe_make(&back, &coarse, &models[1], NULL) == first, "trial %d", trial);
        if (first == TAUT_OK) {
            static const char *const names[] = {"length",         "max_curvature",
                                                "largest_radius", "total_curvature",
                                                "total_torsion",  "bending"};
            CHECK(taut_pipe_certify(models[0], NULL, NULL, &certificates[0], NULL) == TAUT_OK &&
                      taut_pipe_certify(models[1], NULL, NULL, &certificates[1], NULL) == TAUT_OK,
                  "proofs");
            for (int k = 0; k < 6; k++) {
                const double a = figure_of(certificates[0], names[k]);
                CHECK_NEAR(figure_of(certificates[1], names[k]), a, 1e-9 * (1 + fabs(a)),
                           "trial %d: %s", trial, names[k]);
            }
        }
        for (int k = 0; k < 2; k++) {
            taut_certificate_free(certificates[k]);
            taut_model_free(models[k]);
        }
    }
}

int main(void)
{
    random_seed(20261122);
    test_largest_radius();
    test_pappus();
    test_scale_and_shift();
    test_reversal();
    return check_failures != 0;
}
