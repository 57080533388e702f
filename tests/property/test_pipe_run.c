/* test_pipe_run.c -- random runs of pipes: joints, areas and volumes, the turn of a closed frame,
 * other units and places. */
#include "certificates.h"
#include "check.h"
#include "pipe_runs.h"

#include "core/constants.h"
#include "core/vec3.h"

#include <stddef.h>
#include <string.h>

/* Surfaces meet with equal normals (and curvatures), and the frame comes round: 1e-13 at unit size,
 * where the first rings are far enough apart for their rounding. */
static void test_joints(void)
{
    int checked = 0;
    for (int trial = 0; trial < 3 + random_trials(3); trial++) {
        pipe_random r;
        pipe_random_run(1 + trial % 3, &r); /* at unit size */
        r.problem.shape.alpha = r.problem.shape.gamma = random_in(-0.5, 0.5);
        r.problem.radius = 0.02;
        r.problem.bend_radius = r.problem.route.kind == TAUT_PIPE_LEGS ? 0 : 0.4;
        taut_model *model = pipe_random_made(&r, 1e-2);
        if (model == NULL || (r.problem.bend_radius > 0 && r.problem.bend_radius < 0.25)) {
            taut_model_free(model); /* elbows so small that rounding counts over their rings */
            continue;
        }
        checked++;
        taut_certificate *certificate = pipe_run_proved(model, &r.problem, 1e-2);
        const taut_claim *joints = claim_of(certificate, "joints");
        const taut_claim *curvatures = claim_of(certificate, "curvatures");
        CHECK(joints->residual < 1e-13 && joints->holds == TAUT_TRUE, "trial %d: %g %s", trial,
              joints->residual, joints->where);
        CHECK(r.problem.joint == TAUT_PIPE_G1 ||
                  (curvatures->residual < 1e-13 && curvatures->holds == TAUT_TRUE),
              "trial %d: %g %s", trial, curvatures->residual, curvatures->where);
        CHECK(claim_of(certificate, "ends")->holds == TAUT_TRUE, "trial %d: %g", trial,
              claim_of(certificate, "ends")->residual);
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
        double corners[4][3];
        const taut_pipe_run_problem problem = {
            .route = {.kind = TAUT_PIPE_CORNERS, .count = 4, .corners = &corners[0][0]},
            .radius = 12,
            .shape = {.alpha = trial % 2 == 0 ? -2.5 : -1, .gamma = trial % 2 == 0 ? -2.5 : -1},
            .joint = trial % 2 == 0 ? TAUT_PIPE_G1 : TAUT_PIPE_G2,
            .bend_radius = 36};
        for (int i = 0; i < 4; i++) {
            const double place[3] = {i == 1 || i == 2 ? 500 : 100, i >= 2 ? 500 : 100, 300};
            for (int k = 0; k < 3; k++) {
                corners[i][k] = place[k] + random_in(-60, 60);
            }
        }
        taut_model *model = pipe_run_made(&problem, 1e-6);
        taut_certificate *certificate = pipe_run_proved(model, &problem, 1e-6);
        for (int i = 0; model != NULL && i + 2 < taut_model_surface_count(model); i += 2) {
            const double *rings = taut_surface_points(taut_model_surface(model, i));
            double d[3];
            taut_difference(rings + 27, rings, d);
            const double after = worst_ruling(taut_model_surface(model, i + 1), 0, d);
            const double before = i > 0 ? worst_ruling(taut_model_surface(model, i - 1), 1, d) : 0;
            CHECK(after < 1e-13 && before < 1e-13, "trial %d: %g, %g", trial, after, before);
        }
        CHECK(claim_of(certificate, "joints")->residual < 1e-13, "trial %d: %g", trial,
              claim_of(certificate, "joints")->residual);
        CHECK(trial % 2 == 0 || claim_of(certificate, "curvatures")->residual < 1e-13,
              "trial %d: %g", trial, claim_of(certificate, "curvatures")->residual);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

/* 2 pi a L and pi a^2 L over the whole run, straight pipes and blends. */
static void test_pappus(void)
{
    for (int trial = 0; trial < random_trials(2); trial++) {
        pipe_random r;
        pipe_random_run(1 + trial, &r);
        r.problem.route.count = trial == 1 ? 5 : 3;
        r.problem.shape.alpha = r.problem.shape.gamma = 0;
        r.problem.radius = 0.03;
        r.problem.bend_radius = 0.12;
        taut_model *model = pipe_random_made(&r, 1e-11);
        const double disc = TAUT_PI * r.problem.radius * r.problem.radius;
        taut_certificate *certificate = pipe_run_proved(model, &r.problem, 1e-11);
        double area = 0, volume = 0;
        for (int i = 0; model != NULL && i < taut_model_surface_count(model); i++) {
            pipe_integrate(taut_model_surface(model, i), &area, &volume);
        }
        for (int side = 0; side < 2 && !r.problem.route.closed && model != NULL; side++) {
            const int last = taut_model_curve_count(model) - 1;
            double x[2][3];
            taut_curve_eval(taut_model_curve(model, side == 0 ? 0 : last), side, 1, &x[0][0]);
            volume += (side == 0 ? -1 : 1) * pipe_end_volume(x[0], x[1], disc);
        }
        CHECK_NEAR(area, figure_of(certificate, "area"), 1e-10 * area, "trial %d", trial);
        CHECK_NEAR(volume, figure_of(certificate, "volume"), 1e-10 * volume, "trial %d", trial);
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
        pipe_random r;
        double d[LEGS][3], u[3] = {0, 0, 0}, w[3], start[3];
        pipe_random_run(2, &r);
        taut_model *model = pipe_random_made(&r, 1e-2);
        if (model == NULL) {
            continue;
        }
        const int count = r.problem.route.count;
        for (int i = 0; i < count; i++) {
            taut_difference(r.corners[(i + 1) % count], r.corners[i], d[i]);
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
        CHECK_NEAR(detail_of(model, "holonomy"), angle, 1e-10, "trial %d", trial);
        taut_model_free(model);
    }
}

/* In other units, and far away: the same verdict, and figures in those units. */
static void test_scale_and_shift(void)
{
    static const double moves[][2] = {{1e3, 0}, {1, 1e6}, {1e-70, 0}};
    static const char *const names[] = {"length", "largest_radius", "least_bend_radius"};
    for (int trial = 0; trial < random_trials(3); trial++) {
        pipe_random r, other;
        pipe_random_run(3 - trial % 4, &r);
        r.problem.route.count -=
            r.problem.route.kind == TAUT_PIPE_LEGS; /* one search for handles, not two */
        taut_model *model = pipe_random_made(&r, 1e-2);
        taut_certificate *here = pipe_run_proved(model, &r.problem, 1e-2);
        if (model == NULL || here == NULL) {
            continue;
        }
        for (size_t i = 0; i < sizeof moves / sizeof moves[0]; i++) {
            const double scale = moves[i][0];
            other = r;
            pipe_attach(&other);
            other.problem.radius *= scale;
            other.problem.bend_radius *= scale;
            for (int k = 0; k < 3 * LEGS; k++) {
                const int i3 = k / 3, c = k % 3;
                other.corners[i3][c] = scale * r.corners[i3][c] + moves[i][1];
                other.legs[i3].from[c] = scale * r.legs[i3].from[c] + moves[i][1];
                other.legs[i3].to[c] = scale * r.legs[i3].to[c] + moves[i][1];
            }
            taut_model *moved = pipe_run_made(&other.problem, 1e-2);
            taut_certificate *there = pipe_run_proved(moved, &other.problem, 1e-2);
            for (size_t k = 0; k < 3; k++) {
                const double value = figure_of(here, names[k]);
                /* handles that are searched for end where the search does: 1e-6 of them */
                CHECK_NEAR(figure_of(there, names[k]) / scale, value,
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
    test_joints();
    test_far_rings();
    test_pappus();
    test_holonomy();
    test_scale_and_shift();
    return check_failures != 0;
}
