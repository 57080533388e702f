/* test_run.c -- runs of pipes: what comes out, false claims, caps and closed meshes. */
#include "certificates.h"
#include "check.h"
#include "pipe_runs.h"

#include "core/vec3.h"

#include <stdlib.h>
#include <string.h>

static const double square[][3] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}};

static void names_are(const taut_model *model, const char *const *names)
{
    int i = 0;
    for (; model != NULL && names[i] != NULL; i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        char axis[64];
        CHECK(surface != NULL && strcmp(taut_surface_name(surface), names[i]) == 0, "%s is there",
              names[i]);
        snprintf(axis, sizeof axis, "axis-%s", names[i]);
        CHECK(strncmp(names[i], "cap", 3) == 0 ||
                  strcmp(taut_curve_name(taut_model_curve(model, i)), axis) == 0,
              "%s is there", axis);
    }
    CHECK(model != NULL && taut_model_surface_count(model) == i, "%d surfaces", i);
}

static void all_hold(const taut_model *model, const taut_pipe_run_problem *problem,
                     const char *what)
{
    taut_certificate *certificate = pipe_run_proved(model, problem, 1e-6);
    for (int i = 0; certificate != NULL && i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        CHECK(claim->holds == TAUT_TRUE, "%s: %s, %g, limit %g, %s", what, claim->claim,
              claim->residual, claim->limit, claim->where);
    }
    taut_certificate_free(certificate);
}

/* The pieces, in the order of flow; straight pipes of no length and corners without a turn are left
 * out; claims hold with the problem and without. */
static void test_pieces(void)
{
    static const char *const of_stair[] = {"pipe1", "blend1", "pipe2", "blend2", "pipe3", NULL};
    static const char *const of_square[] = {"pipe1",  "blend1", "pipe2",  "blend2", "pipe3",
                                            "blend3", "pipe4",  "blend4", NULL};
    static const char *const of_placed[] = {"pipe1", "blend1", "blend2", "pipe3",
                                            "cap1",  "cap2",   NULL};
    static const char *const of_bent[] = {"pipe1", "blend1", "pipe2", NULL};
    const double bent[][3] = {{0, 0, 0}, {1, 0, 0}, {4, 0, 0}, {4, 3, 0}, {4, 5, 0}};
    /* begins in the middle of a side */
    const double ring[][3] = {{2, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}, {0, 0, 0}};
    taut_pipe_run_problem problems[] = {pipe_run_of_corners(pipe_stair, 4),
                                        pipe_run_of_corners(square, 4),
                                        pipe_run_of_legs(pipe_placed, 3),
                                        pipe_run_of_corners(bent, 5), pipe_run_of_corners(ring, 5)};
    const char *const *const names[] = {of_stair, of_square, of_placed, of_bent, of_square};
    problems[1].route.closed = problems[4].route.closed = 1;
    problems[2].joint = TAUT_PIPE_G2;
    problems[2].caps = 1;
    for (int i = 0; i < 5; i++) {
        taut_model *model = pipe_run_made(&problems[i], 1e-6);
        names_are(model, names[i]);
        all_hold(model, &problems[i], names[i][0]);
        all_hold(model, NULL, "from the details");
        taut_model_free(model);
    }
}

/* Elbows are as sharp as asked and no sharper; what the message says would work does. */
static void test_bend_radius(void)
{
    for (int trial = 0; trial < 3; trial++) {
        taut_pipe_run_problem problem = pipe_run_of_corners(pipe_stair, 4);
        problem.joint = trial % 2 == 0 ? TAUT_PIPE_G1 : TAUT_PIPE_G2;
        problem.shape.kind = trial < 2 ? TAUT_PIPE_SHAPE_GIVEN : TAUT_PIPE_LEAST_BENDING;
        problem.bend_radius = random_in(0.3, 0.49);
        taut_model *model = pipe_run_made(&problem, 1e-3);
        taut_certificate *certificate = pipe_run_proved(model, &problem, 1e-3);
        CHECK_NEAR(figure_of(certificate, "least_bend_radius"), problem.bend_radius,
                   2e-7 * problem.bend_radius, "trial %d", trial);
        taut_certificate_free(certificate);
        taut_model_free(model);
        problem.bend_radius = 100;
        const taut_error error = pipe_run_refused(&problem, TAUT_NO_SOLUTION, "leg-too-short");
        CHECK(error.limit < 100 && strcmp(error.where, "/run/1") == 0, "at %s", error.where);
        problem.bend_radius = error.limit; /* the leg is used up: no straight pipe between */
        problem.radius = 0.1 * error.limit;
        model = pipe_run_made(&problem, 1e-6);
        CHECK(model != NULL && taut_model_surface_count(model) == 4, "elbow on elbow");
        if (problem.joint == TAUT_PIPE_G1) { /* else rounding counts over the first rings */
            all_hold(model, &problem, "elbow on elbow");
        }
        taut_model_free(model);
        problem.bend_radius = error.limit * 1.001;
        if (trial < 2) { /* another search for a shape would show no more */
            pipe_run_refused(&problem, TAUT_NO_SOLUTION, "leg-too-short");
        }
    }
}

/* A model is held against another request: whichever claim is false says so. */
static void test_false_claims(void)
{
    double moved[4][3];
    taut_pipe_run_problem problem = pipe_run_of_corners(pipe_stair, 4), other = problem;
    taut_pipe_problem blend = {.axis = {.polygon = {{0, 0, 0}}}};
    taut_model *model = NULL;
    problem.bend_radius = 0.6;
    model = pipe_run_made(&problem, 1e-6);
    other = problem;
    other.bend_radius = 0.6001;
    CHECK(pipe_run_verdict(model, &problem, "bend_radius") == TAUT_TRUE, "as sharp as asked");
    CHECK(pipe_run_verdict(model, &other, "bend_radius") == TAUT_FALSE, "too sharp");
    other = problem;
    other.radius *= 1 + 1e-5;
    CHECK(pipe_run_verdict(model, &other, "tube") == TAUT_FALSE, "another radius");
    other.radius = 0.601;
    CHECK(pipe_run_verdict(model, &other, "embedded") == TAUT_FALSE, "wider than its bends");
    other = problem;
    for (int i = 0; i < 4; i++) {
        memcpy(moved, pipe_stair, sizeof pipe_stair);
        moved[i][1 + i % 2] += 1e-9;
        other.route.corners = &moved[0][0];
        CHECK(pipe_run_verdict(model, &other, "ends") == TAUT_FALSE, "corner %d moved", i);
    }
    blend.section.radius = problem.radius;
    CHECK(pipe_verdict(model, &blend, "ends") == TAUT_FALSE, "not a run that was asked for");
    taut_model_free(model);
    blend = pipe_random_ends();
    blend.section.radius = problem.radius;
    model = pipe_made(&blend, 1e-3);
    CHECK(pipe_run_verdict(model, &problem, "ends") == TAUT_FALSE,
          "not a blend that was asked for");
    taut_model_free(model);
}

/* A free end that comes near the side of another pipe is a point of the axis like any other. */
static void test_free_end(void)
{
    const double hook[][3] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 4, 0}, {2, 0.5, 0}};
    taut_pipe_run_problem problem = pipe_run_of_corners(hook, 5);
    problem.bend_radius = 0.6;
    taut_model *model = pipe_run_made(&problem, 1e-3);
    taut_certificate *certificate = pipe_run_proved(model, &problem, 1e-3);
    CHECK_NEAR(figure_of(certificate, "largest_radius"), 0.25, 1e-12, "half the way to the side");
    taut_certificate_free(certificate);
    taut_model_free(model);
    problem.radius = 0.26;
    const taut_error error = pipe_run_refused(&problem, TAUT_NO_SOLUTION, "self-intersect-global");
    CHECK_NEAR(error.limit, 0.25, 1e-12, "half the way to the side");
    CHECK(strstr(error.message, "pipe1") != NULL && strstr(error.message, "pipe4") != NULL, "%s",
          error.message);
}

/* Every edge between two welded vertices lies in two triangles that run through it oppositely:
 * closed; and what they enclose. */
static double enclosed(const taut_model *model, const char *what)
{
    const taut_mesh_options options = {.tolerance = 2e-3};
    taut_mesh *mesh = NULL;
    if (model == NULL || taut_mesh_new(model, &options, &mesh, NULL) != TAUT_OK) {
        CHECK(0, "%s: no mesh", what);
        return 0;
    }
    const size_t count = taut_mesh_vertex_count(mesh);
    const uint32_t *weld = taut_mesh_welded(mesh), *triangles = taut_mesh_triangles(mesh);
    int *next = calloc(8 * count, sizeof *next);
    size_t open = 0;
    double volume = 0;
    for (int g = 0; g < taut_mesh_group_count(mesh); g++) {
        const taut_mesh_group *group = taut_mesh_group_at(mesh, g);
        const size_t faces = 2 * (size_t)(group->nu - 1) * (size_t)(group->nv - 1);
        for (size_t f = 0; f < faces; f++) {
            const uint32_t *t = triangles + 3 * (2 * group->first_quad + f);
            const double *x[3];
            double across[3];
            for (int k = 0; k < 3; k++) {
                x[k] = taut_mesh_positions(mesh) + 3 * weld[t[k]];
            }
            taut_cross(x[1], x[2], across);
            volume += (group->turned ? -1 : 1) * taut_dot(x[0], across) / 6;
            for (int k = 0; k < 3; k++) { /* edges as a sum of signs, hashed by their ends */
                const uint32_t a = weld[t[k]], b = weld[t[(k + 1) % 3]];
                const uint64_t low = a < b ? a : b, high = a < b ? b : a;
                if (a != b) {
                    next[(low * 2654435761u + high * 40503u) % (8 * count)] +=
                        ((a < b) != (group->turned != 0)) ? 1 : -1;
                }
            }
        }
    }
    for (size_t i = 0; i < 8 * count; i++) {
        open += next[i] != 0;
    }
    CHECK(open == 0, "%s: %zu open edges", what, open);
    free(next);
    taut_mesh_free(mesh);
    return fabs(volume);
}

static void test_run_meshes(void)
{
    taut_pipe_run_problem problems[2] = {pipe_run_of_corners(pipe_stair, 4),
                                         pipe_run_of_corners(square, 4)};
    problems[1].route.closed = 1;
    for (int i = 0; i < 2; i++) {
        problems[i].caps = 1;
        taut_model *model = pipe_run_made(&problems[i], 1e-6);
        taut_certificate *certificate = pipe_run_proved(model, &problems[i], 1e-6);
        const double volume = enclosed(model, i == 0 ? "run" : "closed run");
        const double whole = figure_of(certificate, "volume");
        CHECK(i == 1 || claim_of(certificate, "caps")->holds == TAUT_TRUE, "caps");
        /* the mesh lies inside, by as much as its chords are away */
        CHECK(volume < whole && volume > 0.9 * whole, "run %d: %g of %g", i, volume, whole);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

static void test_blend_meshes(void)
{
    taut_pipe_problem problems[3];
    problems[0] = problems[1] = problems[2] = pipe_random_ends();
    problems[0].section.radius = 0.3;
    problems[1].section = (taut_pipe_section){.kind = TAUT_PIPE_CANAL, .radii = {0.3, 0.2}};
    problems[2].section = (taut_pipe_section){
        .kind = TAUT_PIPE_ELLIPTIC, .ellipses = {{0.3, 0.2, {1, 0, 0}}, {0.2, 0.3, {0, 1, 1}}}};
    problems[2].joint = TAUT_PIPE_G2;
    for (int i = 0; i < 3; i++) {
        char what[16];
        snprintf(what, sizeof what, "mesh %d", i);
        problems[i].caps = 1;
        taut_model *model = pipe_made(&problems[i], 1e-6);
        taut_certificate *certificate = pipe_proved(model, &problems[i], 1e-6);
        (void)enclosed(model, what);
        CHECK(claim_of(certificate, "caps")->holds == TAUT_TRUE, "%s: caps", what);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

/* Where the elbow takes all of the last leg there is no pipe behind it. */
static void test_leg_used_up(void)
{
    static const char *const names[] = {"pipe1", "blend1", NULL};
    double corners[][3] = {{0, 0, 0}, {5, 0, 0}, {5, 0.5, 0}};
    taut_pipe_run_problem problem = pipe_run_of_corners((const double(*)[3])corners, 3);
    problem.bend_radius = 1;
    taut_error error = pipe_run_refused(&problem, TAUT_NO_SOLUTION, "leg-too-short");
    const char *const told = strstr(error.message, "leg of at least ");
    CHECK(told != NULL, "%s", error.message);
    corners[2][1] = told != NULL ? strtod(told + 16, NULL) : 0;
    taut_model *model = pipe_run_made(&problem, 1e-6);
    names_are(model, names);
    all_hold(model, &problem, "a leg used up");
    taut_model_free(model);
}

int main(void)
{
    random_seed(20261127);
    test_pieces();
    test_bend_radius();
    test_false_claims();
    test_free_end();
    test_run_meshes();
    test_blend_meshes();
    test_leg_used_up();
    return check_failures != 0;
}
