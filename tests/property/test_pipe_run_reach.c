/* test_pipe_run_reach.c -- random runs of pipes: the verdict against the global radius of curvature
 * of the whole axis. */
#include "check.h"
#include "pipe_runs.h"

#include "core/vec3.h"

#include <stdlib.h>
#include <string.h>

enum { STEPS = 400, GRID = 64, KEPT = 3 };

static const double pi = 3.14159265358979323846;

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

/* |x - y|^2 / (2 dist(y, tangent line at x)) ([GonzalezMaddocks1999]). */
static double circle_of(const double x[3][3], const double y[3])
{
    double d[3], across[3];
    taut_difference(y, x[0], d);
    taut_cross(d, x[1], across);
    const double distance = taut_norm(across) / taut_norm(x[1]), square = taut_dot(d, d);
    return distance > 1e-9 * sqrt(square) ? square / (2 * distance) : (double)INFINITY;
}

/* INFINITY for pairs that are left out. */
static double circle(const axis *a, const int part[2], const double t[2])
{
    double x[3][3], y[3][3];
    if (way(a, part, t) < a->near) {
        return INFINITY;
    }
    evaluate(a, part[0], t[0], x);
    evaluate(a, part[1], t[1], y);
    return circle_of((const double(*)[3])x, y[0]);
}

static double descend(const axis *a, const int part[2], const double start[2])
{
    double t[2] = {start[0], start[1]}, best = circle(a, part, t), step = 0.5 / GRID;
    for (int rounds = 0; step > 1e-9 && rounds < 2000; rounds++) {
        int better = 0;
        for (int k = 0; k < 8 && !better; k++) {
            static const int moves[8][2] = {{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                                            {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
            const double next[2] = {fmin(1, fmax(0, t[0] + step * moves[k][0])),
                                    fmin(1, fmax(0, t[1] + step * moves[k][1]))};
            const double value = circle(a, part, next);
            if (value < best) {
                best = value;
                memcpy(t, next, sizeof t);
                better = 1;
            }
        }
        step *= better ? 1.5 : 0.5;
    }
    return best;
}

static double curvature_radius(const axis *a, int part, double t)
{
    double x[3][3], across[3];
    evaluate(a, part, t, x);
    taut_cross(x[1], x[2], across);
    return taut_norm(across) > 0 ? pow(taut_norm(x[1]), 3) / taut_norm(across) : (double)INFINITY;
}

static double least_curvature_radius(const axis *a)
{
    double best = INFINITY;
    for (int part = 0; part < a->count; part++) {
        double at = 0, least = INFINITY;
        for (int i = 0; i <= STEPS; i++) {
            const double r = curvature_radius(a, part, (double)i / STEPS);
            at = r < least ? (double)i / STEPS : at;
            least = fmin(least, r);
        }
        double lo = fmax(0, at - 1.0 / STEPS), hi = fmin(1, at + 1.0 / STEPS);
        for (int i = 0; i < 100 && isfinite(least); i++) {
            const double left = (2 * lo + hi) / 3, right = (lo + 2 * hi) / 3;
            *(curvature_radius(a, part, left) < curvature_radius(a, part, right) ? &hi : &lo) =
                curvature_radius(a, part, left) < curvature_radius(a, part, right) ? right : left;
        }
        best = fmin(best, fmin(least, curvature_radius(a, part, 0.5 * (lo + hi))));
    }
    return best;
}

/* The best few pairs of a grid over two parts, made exact where they can matter. */
static double least_circle(const axis *a, const int part[2], double best)
{
    double kept[KEPT], at[KEPT][2];
    static double grid[2][GRID + 1][3][3];
    int count = 0;
    for (int n = 0; n < 2 * (GRID + 1); n++) {
        evaluate(a, part[n / (GRID + 1)], (double)(n % (GRID + 1)) / GRID,
                 grid[n / (GRID + 1)][n % (GRID + 1)]);
    }
    for (int n = 0; n < (GRID + 1) * (GRID + 1); n++) {
        const int i = n / (GRID + 1), j = n % (GRID + 1);
        const double t[2] = {(double)i / GRID, (double)j / GRID};
        const double value = way(a, part, t) < a->near
                                 ? (double)INFINITY
                                 : circle_of((const double(*)[3])grid[0][i], grid[1][j][0]);
        int slot = count;
        for (; slot > 0 && value < kept[slot - 1]; slot--) {
            if (slot < KEPT) {
                kept[slot] = kept[slot - 1];
                memcpy(at[slot], at[slot - 1], sizeof at[slot]);
            }
        }
        if (slot < KEPT && isfinite(value)) {
            kept[slot] = value;
            memcpy(at[slot], t, sizeof t);
            count = count < KEPT ? count + 1 : count;
        }
    }
    for (int k = 0; k < count; k++) {
        best = kept[k] < 2 * best ? fmin(best, descend(a, part, at[k])) : best;
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
        if (way(a, part, t) >= pi * local) {
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
    int by_distance = 0, compared = 0;
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
        const double rho = pipe_figure(certificate, "largest_radius");
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
        by_distance += strcmp(binding, "distance") == 0;
        compared++;
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
    CHECK(compared > 0 && (by_distance > 1 || compared < 8), "%d of %d bind by distance",
          by_distance, compared);
}

int main(void)
{
    random_seed(20261126);
    test_largest_radius();
    return check_failures != 0;
}
