/* test_pipe_run_reach.c -- random runs of pipes: the verdict against the global radius of curvature
 * of the whole axis. */
#include "certificates.h"
#include "check.h"
#include "pipe_runs.h"
#include "touching.h"

#include "core/constants.h"
#include "core/vec3.h"

#include <stdlib.h>
#include <string.h>

enum { STEPS = 400, GRID = 64 };

/* The axis as the test sees it: curves of the model evaluated by their bases. */
typedef struct axis {
    const taut_model *model;
    int count, closed;
    double (*samples)[STEPS + 1]; /* arc lengths along each curve, from the start of the run */
    double length;
    double near; /* pairs nearer along the axis are left out */
} axis;

static void evaluate(const axis *a, int part, double t, double x[3][3])
{
    memset(x, 0, 9 * sizeof(double));
    taut_curve_eval(taut_model_curve(a->model, part), t, 2, &x[0][0]);
}

static axis axis_of(const taut_model *model, int closed)
{
    axis a = {.model = model, .count = taut_model_curve_count(model), .closed = closed};
    a.samples = calloc((size_t)a.count, sizeof *a.samples);
    for (int i = 0; i < a.count; i++) {
        double x[3][3], before[3];
        for (int k = 0; k <= STEPS; k++) {
            evaluate(&a, i, (double)k / STEPS, x);
            a.length += k > 0 ? taut_distance(x[0], before) : 0;
            memcpy(before, x[0], sizeof before);
            a.samples[i][k] = a.length;
        }
    }
    return a;
}

/* Along the axis, the shorter way round. */
static double way(const axis *a, const int part[2], const double t[2])
{
    double s[2];
    for (int i = 0; i < 2; i++) {
        const int k = (int)fmin(STEPS - 1, t[i] * STEPS);
        const double *row = a->samples[part[i]];
        s[i] = row[k] + (t[i] * STEPS - k) * (row[k + 1] - row[k]);
    }
    return a->closed ? fmin(fabs(s[0] - s[1]), a->length - fabs(s[0] - s[1])) : fabs(s[0] - s[1]);
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
    if (way(p->a, p->part, t) < p->a->near) {
        return INFINITY;
    }
    evaluate(p->a, p->part[0], t[0], x);
    evaluate(p->a, p->part[1], t[1], y);
    return touching_radius((const double(*)[3])x, y[0]);
}

/* A part alone, for its curvature: part[0]. */
static double radius_of_curvature(const void *context, double t)
{
    const pair *p = context;
    double x[3][3];
    evaluate(p->a, p->part[0], t, x);
    return touching_curvature_radius((const double(*)[3])x);
}

static double least_curvature_radius(const axis *a)
{
    double best = INFINITY;
    for (int part = 0; part < a->count; part++) {
        const pair p = {a, {part, part}};
        double at = 0, least = INFINITY;
        for (int i = 0; i <= STEPS; i++) {
            const double r = radius_of_curvature(&p, (double)i / STEPS);
            at = r < least ? (double)i / STEPS : at;
            least = fmin(least, r);
        }
        if (isfinite(least)) {
            best = fmin(
                best, fmin(least, touching_least(radius_of_curvature, &p, fmax(0, at - 1.0 / STEPS),
                                                 fmin(1, at + 1.0 / STEPS))));
        }
    }
    return best;
}

/* The best few pairs of a grid over two parts, made exact where they can matter. */
static double least_circle(const axis *a, const int part[2], double best)
{
    static double grid[2][GRID + 1][3][3];
    const pair parts = {a, {part[0], part[1]}};
    touching_kept kept = {.most = 3};
    for (int n = 0; n < 2 * (GRID + 1); n++) {
        evaluate(a, part[n / (GRID + 1)], (double)(n % (GRID + 1)) / GRID,
                 grid[n / (GRID + 1)][n % (GRID + 1)]);
    }
    for (int n = 0; n < (GRID + 1) * (GRID + 1); n++) {
        const int i = n / (GRID + 1), j = n % (GRID + 1);
        const double t[2] = {(double)i / GRID, (double)j / GRID};
        if (way(a, part, t) >= a->near) {
            touching_keep(&kept, touching_radius((const double(*)[3])grid[0][i], grid[1][j][0]), t);
        }
    }
    for (int k = 0; k < kept.count; k++) {
        if (kept.values[k] < 2 * best) {
            best = fmin(best, touching_descend(circle_at, &parts, kept.at[k], 0.5 / GRID, 1e-9));
        }
    }
    return best;
}

/* Half the distance of free end `side` from what is farther along the axis than pi radii. */
static double least_from_end(const axis *a, int side, double local, double best)
{
    enum { FINE = 2000 };
    double end[3][3], x[3][3];
    evaluate(a, side == 0 ? 0 : a->count - 1, side, end);
    for (int n = 0; n <= a->count * FINE; n++) {
        const int part[2] = {(int)fmin(a->count - 1, n / FINE), side == 0 ? 0 : a->count - 1};
        const double t[2] = {(n - part[0] * FINE) / (double)FINE, side};
        if (way(a, part, t) >= TAUT_PI * local) {
            evaluate(a, part[0], t[0], x);
            best = fmin(best, 0.5 * taut_distance(x[0], end[0]));
        }
    }
    return best;
}

static double global_radius(axis *a)
{
    const double local = least_curvature_radius(a);
    double best = local;
    a->near = 0.5 * local;
    for (int i = 0; i < a->count * a->count; i++) {
        const int part[2] = {i / a->count, i % a->count};
        best = least_circle(a, part, best);
    }
    for (int side = 0; side < 2 && !a->closed; side++) {
        best = least_from_end(a, side, local, best);
    }
    return best;
}

/* Construction, certificate and the global radius agree, and so does the verdict on either side. */
static void test_largest_radius(void)
{
    for (int trial = 0; trial < random_trials(8); trial++) {
        pipe_random r;
        pipe_random_run(trial % 4, &r);
        taut_model *model = pipe_random_made(&r, 1e-2);
        taut_certificate *certificate = NULL;
        if (model == NULL ||
            taut_pipe_run_certify(model, &r.problem, NULL, &certificate, NULL) != TAUT_OK) {
            CHECK(0, "trial %d", trial);
            continue;
        }
        const double rho = figure_of(certificate, "largest_radius");
        axis a = axis_of(model, r.problem.route.closed);
        const double reference = global_radius(&a);
        free(a.samples);
        /* free ends are held against samples: quadratic at a minimum, linear where pi radii end */
        CHECK_NEAR(rho, reference, (r.problem.route.closed ? 1e-6 : 2e-3) * reference, "trial %d",
                   trial);
        CHECK(r.problem.route.closed || rho <= reference * (1 + 1e-6), "trial %d: not above",
              trial);
        const char *binding =
            taut_record_text(taut_record_get(taut_certificate_figures(certificate), "binding"));
        CHECK(trial % 4 != 1 || strcmp(binding, "distance") == 0, "trial %d: %s", trial, binding);
        taut_certificate_free(certificate);
        taut_model_free(model);
        r.problem.radius = 1.0005 * rho;
        r.problem.bend_radius = r.problem.route.kind == TAUT_PIPE_LEGS ? 0 : r.problem.bend_radius;
        if (r.problem.route.kind ==
            TAUT_PIPE_CORNERS) { /* legs choose other handles for other radii */
            taut_error error = {.message = ""};
            CHECK(taut_pipe_run_make(&r.problem, NULL, &model, &error) == TAUT_NO_SOLUTION &&
                      strncmp(error.reason, "self-intersect-", 15) == 0,
                  "trial %d: %s %s", trial, error.where, error.message);
            CHECK_NEAR(error.limit, rho, 1e-9 * rho, "trial %d", trial);
            r.problem.radius = 0.9995 * error.limit;
            taut_model_free(pipe_run_made(&r.problem, 1e-2));
        }
    }
}

int main(void)
{
    random_seed(20261126);
    test_largest_radius();
    return check_failures != 0;
}
