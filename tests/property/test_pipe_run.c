/* test_pipe_run.c -- random runs of pipes: the verdict against the global radius of curvature of
 * the whole axis, joints, areas and volumes, the turn of a closed frame, other units and places. */
#include "check.h"
#include "pipes.h"

#include "core/vec3.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum { LEGS = 12, STEPS = 400, GRID = 64, KEPT = 3 };

static const double pi = 3.14159265358979323846;

/* A problem with the legs it points to. */
typedef struct request {
    taut_pipe_problem problem;
    taut_pipe_leg legs[LEGS];
} request;

/* Corners of a random walk (kind 0), of a square stair that winds over itself (1), of a closed ring
 * (2); or straight pipes with directions of their own (3). */
static void random_run(int kind, request *r)
{
    taut_pipe_problem *const p = &r->problem;
    double at[3] = {0, 0, 0};
    const double rise = random_in(0.1, 0.4), twist = random_in(-0.3, 0.3);
    memset(r, 0, sizeof *r);
    *p = (taut_pipe_problem){.radius = 1e-3,
                             .axis = kind == 3 ? TAUT_PIPE_LEGS : TAUT_PIPE_CORNERS,
                             .leg_count = kind == 3   ? 3
                                          : kind == 2 ? 5
                                                      : 7,
                             .closed = kind == 2,
                             .alpha = random_in(-2, 1),
                             .gamma = random_in(-2, 1),
                             .bend_radius = kind == 3 ? 0 : random_in(0.05, 0.3),
                             .joint = random_int(0, 1) == 0 ? TAUT_PIPE_TANGENT
                                                            : TAUT_PIPE_CURVATURE_JOINT};
    for (int i = 0; i < p->leg_count; i++) {
        for (int k = 0; k < 3; k++) {
            const double turn = i * (0.5 * pi + twist * rise);
            const double ring = 2 * pi * i / p->leg_count;
            r->legs[i].from[k] = kind == 1   ? (k == 0   ? cos(turn)
                                                : k == 1 ? sin(turn)
                                                         : rise * i / 4)
                                 : kind == 2 ? (k == 0   ? cos(ring)
                                                : k == 1 ? 0.4 * sin(ring)
                                                         : random_in(-0.3, 0.3))
                                             : at[k];
            at[k] += random_in(-1, 1);
            r->legs[i].to[k] = at[k];
            at[k] += random_in(-1, 1);
        }
    }
}

static void attach(request *r)
{
    r->problem.legs = r->legs;
}

/* Made coarsely; where legs are too short, with the bend radius that is told to work. */
static taut_model *made(request *r, double tolerance)
{
    const taut_make_options coarse = {.tolerance = tolerance};
    taut_error error = {.message = ""};
    taut_model *model = NULL;
    attach(r);
    taut_status status = taut_pipe_make(&r->problem, &coarse, &model, &error);
    if (status == TAUT_NO_SOLUTION && strstr(error.message, "LEG_TOO_SHORT") != NULL) {
        r->problem.bend_radius = 0.999 * error.limit;
        r->problem.radius = fmin(r->problem.radius, 0.1 * error.limit);
        status = taut_pipe_make(&r->problem, &coarse, &model, &error);
    }
    CHECK(status == TAUT_OK, "%s %s", error.where, error.message);
    return model;
}

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
    for (int trial = 0; trial < random_trials(6); trial++) {
        request r;
        random_run(trial % 4, &r);
        taut_model *model = made(&r, 1e-2);
        taut_certificate *certificate = NULL;
        if (model == NULL ||
            taut_pipe_certify(model, &r.problem, NULL, &certificate, NULL) != TAUT_OK) {
            CHECK(0, "trial %d", trial);
            continue;
        }
        const double rho = pipe_figure(certificate, "largest_radius");
        axis a = axis_of(model, r.problem.closed);
        const double reference = global_radius(&a);
        free(a.samples);
        /* free ends are held against samples: quadratic at a minimum, linear where pi radii end */
        CHECK_NEAR(rho, reference, (r.problem.closed ? 1e-6 : 2e-3) * reference, "trial %d", trial);
        CHECK(r.problem.closed || rho <= reference * (1 + 1e-6), "trial %d: not above", trial);
        const char *binding =
            taut_record_text(taut_record_get(taut_certificate_figures(certificate), "binding"));
        by_distance += strcmp(binding, "distance") == 0;
        compared++;
        taut_certificate_free(certificate);
        taut_model_free(model);
        r.problem.radius = 1.0005 * rho;
        r.problem.bend_radius = r.problem.axis == TAUT_PIPE_LEGS ? 0 : r.problem.bend_radius;
        if (r.problem.axis == TAUT_PIPE_CORNERS) { /* legs choose other handles for other radii */
            const taut_error error = pipe_refused(&r.problem, TAUT_NO_SOLUTION, "SELF_INTERSECT");
            CHECK_NEAR(error.limit, rho, 1e-9 * rho, "trial %d", trial);
            r.problem.radius = 0.9995 * error.limit;
            taut_model_free(pipe_made(&r.problem, 1e-2));
        }
    }
    CHECK(compared > 0 && (by_distance > 1 || compared < 6), "%d of %d bind by distance",
          by_distance, compared);
}

/* Surfaces meet with equal normals (and curvatures), and the frame comes round: 1e-13 at unit size,
 * where the first rings are far enough apart for their rounding. */
static void test_joints(void)
{
    int checked = 0;
    for (int trial = 0; trial < 3 + random_trials(2); trial++) {
        request r;
        random_run(1 + trial % 3, &r); /* at unit size */
        r.problem.alpha = r.problem.gamma = random_in(-0.5, 0.5);
        r.problem.radius = 0.02;
        r.problem.bend_radius = r.problem.axis == TAUT_PIPE_LEGS ? 0 : 0.4;
        taut_model *model = made(&r, 1e-2);
        if (model == NULL || (r.problem.bend_radius > 0 && r.problem.bend_radius < 0.25)) {
            taut_model_free(model); /* elbows so small that rounding counts over their rings */
            continue;
        }
        checked++;
        taut_certificate *certificate = pipe_proved(model, &r.problem, 1e-2);
        const taut_claim *joints = pipe_claim(certificate, "joints");
        const taut_claim *curvatures = pipe_claim(certificate, "curvatures");
        CHECK(joints->residual < 1e-13 && joints->holds == TAUT_TRUE, "trial %d: %g %s", trial,
              joints->residual, joints->where);
        CHECK(r.problem.joint == TAUT_PIPE_TANGENT ||
                  (curvatures->residual < 1e-13 && curvatures->holds == TAUT_TRUE),
              "trial %d: %g %s", trial, curvatures->residual, curvatures->where);
        CHECK(pipe_claim(certificate, "ends")->holds == TAUT_TRUE, "trial %d: %g", trial,
              pipe_claim(certificate, "ends")->residual);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
    CHECK(checked > 0, "%d runs with joints", checked);
}

/* The largest sine between the way from an end ring to the next and a direction, point by point, by
 * differences that are exact. */
static double worst_ruling(const taut_surface *s, int last, const double d[3])
{
    const int nu = taut_basis_count(taut_surface_u(s)), nv = taut_basis_count(taut_surface_v(s));
    const double *ring = taut_surface_points(s) + 3 * (size_t)nv * (size_t)(last ? nu - 1 : 0);
    const double *next = taut_surface_points(s) + 3 * (size_t)nv * (size_t)(last ? nu - 2 : 1);
    double worst = 0;
    for (int j = 0; j < nv; j++) {
        double way[3], across[3];
        taut_difference(next + 3 * (ptrdiff_t)j, ring + 3 * (ptrdiff_t)j, way);
        taut_cross(way, d, across);
        worst = fmax(worst, taut_norm(across) / (taut_norm(way) * taut_norm(d)));
    }
    return worst;
}

/* Elbows askew at coordinates of hundreds: the first rings lie on the lines of the straight pipes
 * to 1e-13, whatever their own rounding is over the short way between them, and the certificate
 * sees that; curvatures too. */
static void test_far_rings(void)
{
    for (int trial = 0; trial < random_trials(4); trial++) {
        taut_pipe_leg legs[4];
        taut_pipe_problem problem = {.radius = 12,
                                     .axis = TAUT_PIPE_CORNERS,
                                     .leg_count = 4,
                                     .legs = legs,
                                     .bend_radius = 36,
                                     .joint = trial % 2 == 0 ? TAUT_PIPE_TANGENT
                                                             : TAUT_PIPE_CURVATURE_JOINT,
                                     .alpha = trial % 2 == 0 ? -2.5 : -1,
                                     .gamma = trial % 2 == 0 ? -2.5 : -1};
        memset(legs, 0, sizeof legs);
        for (int i = 0; i < 4; i++) {
            const double place[3] = {i == 1 || i == 2 ? 500 : 100, i >= 2 ? 500 : 100, 300};
            for (int k = 0; k < 3; k++) {
                legs[i].from[k] = place[k] + random_in(-60, 60);
            }
        }
        taut_model *model = pipe_made(&problem, 1e-6);
        taut_certificate *certificate = pipe_proved(model, &problem, 1e-6);
        for (int i = 0; model != NULL && i + 2 < taut_model_surface_count(model); i += 2) {
            const double *rings = taut_surface_points(taut_model_surface(model, i));
            double d[3];
            taut_difference(rings + 27, rings, d);
            const double after = worst_ruling(taut_model_surface(model, i + 1), 0, d);
            const double before = i > 0 ? worst_ruling(taut_model_surface(model, i - 1), 1, d) : 0;
            CHECK(after < 1e-13 && before < 1e-13, "trial %d: %g, %g", trial, after, before);
        }
        CHECK(pipe_claim(certificate, "joints")->residual < 1e-13, "trial %d: %g", trial,
              pipe_claim(certificate, "joints")->residual);
        CHECK(trial % 2 == 0 || pipe_claim(certificate, "curvatures")->residual < 1e-13,
              "trial %d: %g", trial, pipe_claim(certificate, "curvatures")->residual);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

/* 2 pi a L and pi a^2 L over the whole run, straight pipes and blends. */
static void test_pappus(void)
{
    for (int trial = 0; trial < random_trials(2); trial++) {
        request r;
        random_run(1 + trial, &r);
        r.problem.leg_count = 3;
        r.problem.alpha = r.problem.gamma = 0;
        r.problem.radius = 0.03;
        r.problem.bend_radius = 0.12;
        taut_model *model = made(&r, 1e-11);
        const double disc = pi * r.problem.radius * r.problem.radius;
        taut_certificate *certificate = pipe_proved(model, &r.problem, 1e-11);
        double area = 0, volume = 0;
        for (int i = 0; model != NULL && i < taut_model_surface_count(model); i++) {
            pipe_integrate(taut_model_surface(model, i), &area, &volume);
        }
        for (int side = 0; side < 2 && !r.problem.closed && model != NULL; side++) {
            const int last = taut_model_curve_count(model) - 1;
            double x[2][3];
            taut_curve_eval(taut_model_curve(model, side == 0 ? 0 : last), side, 1, &x[0][0]);
            volume += (side == 0 ? -1 : 1) * pipe_end_volume(x[0], x[1], disc);
        }
        CHECK_NEAR(area, pipe_figure(certificate, "area"), 1e-10 * area, "trial %d", trial);
        CHECK_NEAR(volume, pipe_figure(certificate, "volume"), 1e-10 * volume, "trial %d", trial);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

/* v turned by the smallest rotation that takes unit vector a to b. */
static void rotate(const double a[3], const double b[3], double v[3])
{
    double axis_of_turn[3], first[3], second[3];
    const double c = taut_dot(a, b);
    taut_cross(a, b, axis_of_turn);
    taut_cross(axis_of_turn, v, first);
    taut_cross(axis_of_turn, first, second);
    taut_add_scaled(1, first, v);
    taut_add_scaled(1 / (1 + c), second, v);
}

/* Elbows at corners are planar, so that the rotation-minimising frame turns as the smallest
 * rotation of their directions: what their product leaves is the angle distributed. */
static void test_holonomy(void)
{
    for (int trial = 0; trial < random_trials(4); trial++) {
        request r;
        double d[LEGS][3], u[3] = {0, 0, 0}, w[3], start[3];
        random_run(2, &r);
        taut_model *model = made(&r, 1e-2);
        if (model == NULL) {
            continue;
        }
        const int count = r.problem.leg_count;
        for (int i = 0; i < count; i++) {
            taut_difference(r.legs[(i + 1) % count].from, r.legs[i].from, d[i]);
            const double length = taut_norm(d[i]);
            for (int k = 0; k < 3; k++) {
                d[i][k] /= length;
            }
        }
        taut_cross(d[0], d[1], u);
        const double length = taut_norm(u);
        for (int k = 0; k < 3; k++) {
            start[k] = u[k] = u[k] / length;
        }
        for (int i = 0; i < count; i++) {
            rotate(d[i], d[(i + 1) % count], u);
        }
        taut_cross(d[0], u, w);
        const double angle = atan2(taut_dot(start, w), taut_dot(start, u));
        CHECK_NEAR(taut_record_number(taut_record_get(taut_model_details(model), "holonomy")),
                   angle, 1e-10, "trial %d", trial);
        taut_model_free(model);
    }
}

/* In other units, and far away: the same verdict, and figures in those units. */
static void test_scale_and_shift(void)
{
    static const double moves[][2] = {{1e3, 0}, {1, 1e6}, {1e-70, 0}};
    static const char *const names[] = {"length", "largest_radius", "least_bend_radius"};
    for (int trial = 0; trial < random_trials(3); trial++) {
        request r, other;
        random_run(3 - trial % 4, &r);
        r.problem.leg_count -=
            r.problem.axis == TAUT_PIPE_LEGS; /* one search for handles, not two */
        taut_model *model = made(&r, 1e-2);
        taut_certificate *here = pipe_proved(model, &r.problem, 1e-2);
        if (model == NULL || here == NULL) {
            continue;
        }
        for (size_t i = 0; i < sizeof moves / sizeof moves[0]; i++) {
            const double scale = moves[i][0];
            other = r;
            attach(&other);
            other.problem.radius *= scale;
            other.problem.bend_radius *= scale;
            for (int k = 0; k < 3 * LEGS; k++) {
                other.legs[k / 3].from[k % 3] = scale * r.legs[k / 3].from[k % 3] + moves[i][1];
                other.legs[k / 3].to[k % 3] = scale * r.legs[k / 3].to[k % 3] + moves[i][1];
            }
            taut_model *moved = pipe_made(&other.problem, 1e-2);
            taut_certificate *there = pipe_proved(moved, &other.problem, 1e-2);
            for (size_t k = 0; k < 3; k++) {
                const double value = pipe_figure(here, names[k]);
                /* handles that are searched for end where the search does: 1e-6 of them */
                CHECK_NEAR(pipe_figure(there, names[k]) / scale, value,
                           (trial % 4 == 0 ? 1e-4 : 2e-8) * value, "trial %d, move %zu: %s", trial,
                           i, names[k]);
            }
            for (int k = 0; there != NULL && k < taut_certificate_claim_count(there); k++) {
                const taut_claim *claim = taut_certificate_claim(there, k);
                CHECK(claim->holds != TAUT_FALSE, "trial %d, move %zu: %s %g, limit %g", trial, i,
                      claim->claim, claim->residual, claim->limit);
            }
            taut_certificate_free(there);
            taut_model_free(moved);
        }
        taut_certificate_free(here);
        taut_model_free(model);
    }
}

int main(void)
{
    random_seed(20261126);
    test_largest_radius();
    test_joints();
    test_far_rings();
    test_pappus();
    test_holonomy();
    test_scale_and_shift();
    return check_failures != 0;
}
