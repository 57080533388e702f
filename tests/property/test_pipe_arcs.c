/* test_pipe_arcs.c -- runs with arcs for elbows: lengths, areas and volumes in closed form, every point of their surfaces
 * at the radius from the circle, and what is no torus refused. */
#include "certificates.h"
#include "check.h"
#include "pipe_runs.h"

#include "core/constants.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { PLACES = 24 };
static const char *const claims[] = {"joints", "embedded", "bend_radius", "tube", "ends"};

/* The length of corners rounded by arcs of radius R: each saves 2 R tan(A / 2) - R A. */
static double length_of(const pipe_random *r)
{
    const int count = r->problem.route.count, closed = r->problem.route.closed;
    double length = 0;
    for (int i = 0; i + !closed < count; i++) {
        length += taut_distance(r->corners[i], r->corners[(i + 1) % count]);
    }
    for (int i = !closed; i + !closed < count; i++) {
        double a[3], b[3], across[3];
        taut_difference(r->corners[i], r->corners[(i + count - 1) % count], a);
        taut_difference(r->corners[(i + 1) % count], r->corners[i], b);
        taut_cross(a, b, across);
        const double angle = atan2(taut_norm(across), taut_dot(a, b));
        length -= r->problem.bend_radius * (2 * tan(angle / 2) - angle);
    }
    return length;
}

/* How far the points of an elbow are from the tube about the circle on whose tangents the corner lies. */
static double worst_miss(const taut_surface *surface, const taut_curve *axis, double radius)
{
    const double *p = taut_curve_points(axis);
    double a[3], b[3], n[3], centre[3], out[3], worst = 0;
    taut_difference(p + 3, p, a);
    taut_difference(p + 6, p + 3, b);
    taut_cross(a, b, n);
    taut_cross(n, a, out); /* to the centre */
    const double leg = taut_norm(a), angle = atan2(taut_norm(n), taut_dot(a, b));
    const double bend = leg / tan(angle / 2);
    for (int k = 0; k < 3; k++) {
        centre[k] = p[k] + bend * out[k] / taut_norm(out);
    }
    for (int i = 0; i <= PLACES * PLACES; i++) {
        double x[3], way[3], x_axis[3];
        taut_surface_eval(surface, (double)(i / PLACES) / PLACES, (double)(i % PLACES) / PLACES, 0,
                          x);
        taut_difference(x, centre, way);
        const double high = taut_dot(way, n) / taut_norm(n);
        taut_add_scaled(-high / taut_norm(n), n, way);
        worst = fmax(worst, fabs(hypot(taut_norm(way) - bend, high) - radius) / radius);
        taut_curve_eval(axis, (double)(i / PLACES) / PLACES, 0, x_axis);
        worst = fmax(worst, fabs(taut_distance(x_axis, centre) - bend) / radius);
        worst = fmax(worst, fabs(taut_distance(x_axis, x) - radius) / radius);
    }
    return worst;
}

static int random_arcs(int kind, pipe_random *r, taut_model **model)
{
    pipe_random_run(kind, r);
    r->problem.elbow = TAUT_PIPE_ELBOW_ARC;
    r->problem.joint = TAUT_PIPE_G1;
    r->problem.radius = 0.02;
    for (int i = 0; kind == 2 && i < r->problem.route.count; i++) {
        r->corners[i][2] = 0.25; /* in one plane: the frame comes round */
    }
    *model = pipe_random_made(r, 1e-6);
    return *model != NULL;
}

static void test_closed_forms(void)
{
    for (int trial = 0; trial < random_trials(12); trial++) {
        pipe_random r;
        taut_model *model = NULL;
        if (!random_arcs(trial % 3, &r, &model)) {
            continue;
        }
        taut_certificate *certificate = pipe_run_proved(model, &r.problem, 1e-6);
        const double length = length_of(&r), radius = r.problem.radius;
        for (int k = 0; k < 5; k++) {
            const taut_claim *claim = claim_of(certificate, claims[k]);
            CHECK(claim->holds == TAUT_TRUE, "trial %d, %s: %g of %g, %s", trial, claims[k],
                  claim->residual, claim->limit, claim->where);
        }
        /* the coordinates are of about unit size: rounding, over the radius */
        CHECK(claim_of(certificate, "tube")->residual < 1e-13 / radius, "trial %d: %g", trial,
              claim_of(certificate, "tube")->residual);
        CHECK_NEAR(figure_of(certificate, "length"), length, 1e-11 * length, "trial %d", trial);
        CHECK_NEAR(figure_of(certificate, "max_curvature") * r.problem.bend_radius, 1, 1e-13,
                   "trial %d", trial);
        CHECK_NEAR(figure_of(certificate, "volume"), TAUT_PI * radius * radius * length,
                   1e-11 * length * radius * radius, "trial %d", trial);
        for (int i = 0; i < taut_model_surface_count(model); i++) {
            const taut_surface *surface = taut_model_surface(model, i);
            if (strncmp(taut_surface_name(surface), "blend", 5) == 0) {
                const double miss = worst_miss(surface, taut_model_curve(model, i), radius);
                CHECK(miss < 1e-13 / radius, "trial %d, %s: %g", trial, taut_surface_name(surface),
                      miss);
            }
        }
        r.problem.bend_radius *= 1 + 1e-9; /* asked for a little more: these bend more sharply */
        CHECK(pipe_run_verdict(model, &r.problem, "bend_radius") != TAUT_TRUE, "trial %d", trial);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

/* The model with point `at` of surface `name` moved by `by`, or its weight made larger by as much of itself. */
static taut_model *broken(const taut_model *model, const char *name, int at, double by, int weight)
{
    taut_model *made = NULL;
    CHECK(taut_model_new(&made) == TAUT_OK, "new");
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        const taut_surface *s = taut_model_surface(model, i);
        const int count = taut_basis_count(taut_surface_u(s)) * taut_basis_count(taut_surface_v(s));
        double points[27 * 3], weights[27];
        taut_surface *copy = NULL;
        memcpy(points, taut_surface_points(s), 3 * (size_t)count * sizeof *points);
        memcpy(weights, taut_surface_weights(s), (size_t)count * sizeof *weights);
        if (strcmp(taut_surface_name(s), name) == 0) {
            points[3 * at + 1] += weight ? 0 : by;
            weights[at] *= weight ? 1 + by : 1;
        }
        CHECK(taut_surface_new(taut_surface_name(s), taut_surface_u(s), taut_surface_v(s), points,
                               weights, &copy, NULL) == TAUT_OK &&
                  taut_model_add_surface(made, copy) == TAUT_OK,
              "copy");
    }
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        taut_curve *copy = NULL;
        CHECK(taut_curve_copy(taut_model_curve(model, i), &copy) == TAUT_OK &&
                  taut_model_add_curve(made, copy) == TAUT_OK,
              "copy");
    }
    return made;
}

/* A net that is no torus's is not proved to be one, and is seen where a surface shows it. */
static void test_broken(void)
{
    pipe_random r;
    taut_model *model = NULL;
    if (!random_arcs(1, &r, &model)) {
        return;
    }
    for (int at = 0; at < 27; at++) {
        taut_model *moved = broken(model, "blend1", at, 1e-3 * r.problem.radius, 0);
        taut_model *heavy = broken(model, "blend2", at, 1e-3, 1);
        taut_model *near = broken(model, "blend2", at, 1e-9 * r.problem.radius, 0);
        CHECK(pipe_run_verdict(moved, &r.problem, "tube") == TAUT_FALSE, "point %d", at);
        CHECK(pipe_run_verdict(heavy, &r.problem, "tube") != TAUT_TRUE, "weight %d", at);
        CHECK(pipe_run_verdict(near, &r.problem, "tube") == TAUT_TRUE, "near %d", at);
        CHECK(pipe_run_verdict(near, &r.problem, "joints") != TAUT_TRUE, "joints, point %d", at);
        taut_model_free(moved);
        taut_model_free(heavy);
        taut_model_free(near);
    }
    taut_model_free(model);
}

/* Wide pipes in sharp bends: the ways around the outside of an elbow are up to five times as long as those around the
 * inside, and so is what rounding of the axis does at a joint. */
static void test_wide(void)
{
    for (int trial = 0; trial < random_trials(160); trial++) {
        pipe_random r;
        pipe_random_run(0, &r);
        r.problem.elbow = TAUT_PIPE_ELBOW_ARC;
        r.problem.joint = TAUT_PIPE_G1;
        r.problem.radius = r.problem.bend_radius / random_in(1.5, 2.5);
        taut_model *model = pipe_random_made(&r, 1e-6);
        taut_certificate *certificate = pipe_run_proved(model, &r.problem, 1e-6);
        const taut_claim *claim = claim_of(certificate, "joints");
        CHECK(claim->holds == TAUT_TRUE, "trial %d: %g of %g, %s", trial, claim->residual,
              claim->limit, claim->where);
        CHECK(claim->where[0] != 0 && claim->where[strlen(claim->where) - 1] == '0', "%s",
              claim->where);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

/* Inside and outside of random runs, arcs or blends; an inside that is broken or missing is seen. */
static void test_walls(void)
{
    for (int trial = 0; trial < random_trials(4); trial++) {
        pipe_random r;
        taut_model *model = NULL;
        pipe_random_run(trial % 2, &r);
        r.problem.radius = 0.02;
        r.problem.elbow = trial % 4 < 2 ? TAUT_PIPE_ELBOW_ARC : TAUT_PIPE_ELBOW_BLEND;
        r.problem.joint = trial % 4 < 3 ? TAUT_PIPE_G1 : TAUT_PIPE_G2;
        taut_model_free(pipe_random_made(&r, 1e-6)); /* at a radius that fits */
        r.problem.wall = 0.05 * r.problem.radius;
        model = pipe_run_made(&r.problem, 1e-6);
        taut_certificate *certificate = pipe_run_proved(model, &r.problem, 1e-6);
        const double a = r.problem.radius, b = a - r.problem.wall;
        CHECK(claim_of(certificate, "inner_joints")->holds == TAUT_TRUE &&
                  claim_of(certificate, "inner_tube")->holds == TAUT_TRUE &&
                  claim_of(certificate, "caps")->holds == TAUT_TRUE &&
                  (r.problem.joint == TAUT_PIPE_G1 ||
                   claim_of(certificate, "inner_curvatures")->holds == TAUT_TRUE),
              "trial %d: %s, %s, %s", trial, claim_of(certificate, "inner_joints")->where,
              claim_of(certificate, "inner_tube")->where, claim_of(certificate, "caps")->where);
        const double material = TAUT_PI * (a * a - b * b) * figure_of(certificate, "length");
        CHECK_NEAR(figure_of(certificate, "wall_volume"), material, 1e-12 * material, "trial %d",
                   trial);
        r.problem.wall *= 1.001; /* asked for a thicker one */
        CHECK(pipe_run_verdict(model, &r.problem, "inner_tube") == TAUT_FALSE, "trial %d", trial);
        r.problem.wall /= 1.001;
        if (r.problem.elbow == TAUT_PIPE_ELBOW_ARC) {
            taut_model *tube = broken(model, "inner-blend1", 4, 1e-3 * b, 0);
            taut_model *ring = broken(model, "cap1", 12, 1e-3 * b, 0);
            CHECK(pipe_run_verdict(tube, &r.problem, "inner_tube") == TAUT_FALSE, "trial %d",
                  trial);
            CHECK(pipe_run_verdict(ring, &r.problem, "caps") == TAUT_FALSE, "trial %d", trial);
            taut_model_free(tube);
            taut_model_free(ring);
        }
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

/* Corners turned in space, of bends of 1 one right after the other, which leave `over` of the leg between the
 * last two. */
static pipe_random back_to_back(int count, double over)
{
    pipe_random r = {.problem = {.route = {.kind = TAUT_PIPE_CORNERS, .count = count + 2},
                                 .radius = 0.1,
                                 .bend_radius = 1,
                                 .elbow = TAUT_PIPE_ELBOW_ARC}};
    double ahead[3], side[3], up[3], angle = 0, taken = 1;
    for (int k = 0; k < 3; k++) {
        ahead[k] = random_in(-1, 1);
        side[k] = random_in(-1, 1);
        r.corners[0][k] = random_in(-2, 2);
    }
    for (int i = 0; i <= count; i++) {
        const double next = random_in(0.3, 1.5), tangent = i < count ? tan(next / 2) : 1;
        const double twist = random_in(-1, 1),
                     length = taken + tangent + (i == count - 1 ? over : 0);
        taut_add_scaled(1 / taut_norm(ahead) - 1, ahead, ahead);
        taut_add_scaled(-taut_dot(side, ahead), ahead, side);
        taut_add_scaled(1 / taut_norm(side) - 1, side, side);
        taut_cross(ahead, side, up);
        for (int k = 0; k < 3; k++) {
            r.corners[i + 1][k] = r.corners[i][k] + length * ahead[k];
            side[k] = cos(twist) * side[k] + sin(twist) * up[k];
            angle = ahead[k];
            ahead[k] = cos(next) * ahead[k] + sin(next) * side[k];
            side[k] = cos(next) * side[k] - sin(next) * angle;
        }
        taken = tangent;
    }
    pipe_attach(&r);
    return r;
}

/* Elbows with no straight pipe between them are made wherever rounding puts their corners; they take up what would be
 * a pipe too short to be one; what they lack is refused. */
static void test_back_to_back(void)
{
    static const double over[] = {0, 0, 1e-12, 1e-9, 5e-8};
    for (int trial = 0; trial < random_trials(20); trial++) {
        const int count = 2 + trial % 3;
        pipe_random r = back_to_back(count, over[trial % 5]);
        r.problem.wall = trial % 2 == 0 ? 0 : 0.05;
        pipe_attach(&r);
        taut_error error = {.message = ""};
        taut_model *model = NULL;
        if (taut_pipe_run_make(&r.problem, NULL, &model, &error) == TAUT_NO_SOLUTION &&
            strcmp(error.reason, "self-intersect-global") == 0) {
            continue; /* it happens to cross itself */
        }
        CHECK(model != NULL, "trial %d: %s %s", trial, error.where, error.message);
        taut_certificate *certificate = pipe_run_proved(model, &r.problem, 1e-6);
        for (int k = 0; k < 5; k++) {
            const taut_claim *claim = claim_of(certificate, claims[k]);
            CHECK(claim->holds == TAUT_TRUE, "trial %d, %s: %g of %g, %s", trial, claims[k],
                  claim->residual, claim->limit, claim->where);
        }
        CHECK_NEAR(figure_of(certificate, "length"), length_of(&r), 1e-12 + 2 * over[trial % 5],
                   "trial %d", trial);
        CHECK(taut_model_curve_count(model) == count + 2, "trial %d: %d", trial,
              taut_model_curve_count(model));
        taut_certificate_free(certificate);
        taut_model_free(model);
        r = back_to_back(count, -1e-11);
        pipe_attach(&r);
        pipe_run_refused(&r.problem, TAUT_NO_SOLUTION, "leg-too-short");
    }
}

/* One arc cannot take up both. */
static void test_taken_up(void)
{
    double corners[3][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1 + 1e-7, 0}};
    taut_pipe_run_problem p = pipe_run_of_corners((const double(*)[3])corners, 3);
    p.elbow = TAUT_PIPE_ELBOW_ARC;
    p.bend_radius = 1;
    const taut_error error = pipe_run_refused(&p, TAUT_NO_SOLUTION, "too-small");
    CHECK_NEAR(error.found, 1, 1e-15, "the shorter leg");
    CHECK_NEAR(error.limit, 1 + 1e-7, 1e-15, "what it should have");
    corners[1][0] = corners[2][0] = 1 + 1e-7;
    taut_model *model = pipe_run_made(&p, 1e-6);
    CHECK(pipe_run_verdict(model, &p, "joints") == TAUT_TRUE &&
              pipe_run_verdict(model, &p, "bend_radius") == TAUT_TRUE &&
              taut_model_surface_count(model) == 1,
          "an elbow alone");
    taut_model_free(model);
}

static void test_refused(void)
{
    static const double ring[5][3] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}, {-2, 2, 3}};
    taut_pipe_run_problem p = pipe_run_of_corners(ring, 5);
    p.elbow = TAUT_PIPE_ELBOW_ARC;
    p.route.closed = 1;
    pipe_run_refused(&p, TAUT_NO_SOLUTION, "arc-frame");
    p.route.closed = 0;
    p.joint = TAUT_PIPE_G2;
    pipe_run_refused(&p, TAUT_BAD_INPUT, "conflict");
    p = pipe_run_of_legs(pipe_placed, 3);
    p.elbow = TAUT_PIPE_ELBOW_ARC;
    pipe_run_refused(&p, TAUT_BAD_INPUT, "conflict");
    p = pipe_run_of_corners(pipe_stair, 4);
    p.wall = p.radius;
    pipe_run_refused(&p, TAUT_BAD_INPUT, "value");
    p.wall = -1e-2;
    pipe_run_refused(&p, TAUT_BAD_INPUT, "value");
    p.wall = 1e-2;
    p.route.closed = 1;
    pipe_run_refused(&p, TAUT_BAD_INPUT, "conflict");
    p.wall = p.route.closed = 0;
    p.elbow = TAUT_PIPE_ELBOW_ARC;
    p.bend_radius = 1.6; /* two quarter circles on a leg of 3 */
    const taut_error error = pipe_run_refused(&p, TAUT_NO_SOLUTION, "leg-too-short");
    CHECK_NEAR(error.limit, 1.5, 1e-15, "the largest bend radius");
    p.bend_radius = 1.5; /* both meet in its middle, with no straight pipe between */
    taut_model *model = pipe_run_made(&p, 1e-6);
    CHECK(pipe_run_verdict(model, &p, "joints") == TAUT_TRUE &&
              taut_model_surface_count(model) == 4,
          "elbow to elbow");
    taut_model_free(model);
    p.bend_radius = 0.19; /* below the radius */
    pipe_run_refused(&p, TAUT_NO_SOLUTION, "self-intersect-local");
}

int main(void)
{
    random_seed(20261126);
    test_closed_forms();
    test_broken();
    test_wide();
    test_walls();
    test_back_to_back();
    test_taken_up();
    test_refused();
    return check_failures != 0;
}
