/* test_run_refused.c -- what is refused of a run, and that what is told to work does. */
#include "check.h"
#include "pipe_runs.h"

#include "core/vec3.h"

#include <stdlib.h>
#include <string.h>

static void test_refusals(void)
{
    const double back[][3] = {{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {1, 3, 0}};
    const double twice[][3] = {{0, 0, 0}, {4, 0, 0}, {4, 0, 0}};
    const double straight[][3] = {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}};
    /* out and back beside itself: half of 0.5 is too near for 0.3 */
    const taut_pipe_leg near[] = {
        {.from = {0, 0, 0}, .to = {4, 0, 0}},
        {.kind = TAUT_PIPE_LEG_POINT, .from = {8, 3, 0}, .direction = {-1, 1, 0}},
        {.from = {4, 0.5, 0.1}, .to = {0, 0.5, 0}}};
    taut_pipe_run_problem problem = pipe_run_of_corners(back, 4);
    taut_error error = pipe_run_refused(&problem, TAUT_NO_SOLUTION, "turns-back");
    CHECK(strcmp(error.where, "/run/1") == 0, "at %s", error.where);
    problem = pipe_run_of_corners(twice, 3);
    error = pipe_run_refused(&problem, TAUT_BAD_INPUT, "value");
    CHECK(strcmp(error.where, "/run/2") == 0, "at %s", error.where);
    problem = pipe_run_of_corners(straight, 3);
    pipe_run_refused(&problem, TAUT_NO_SOLUTION, "run-straight");
    problem = pipe_run_of_corners(pipe_stair, 4);
    problem.bend_radius = 0.4;
    problem.radius = 0.5;
    error = pipe_run_refused(&problem, TAUT_NO_SOLUTION, "self-intersect-local");
    problem.radius = 0.999 * error.limit;
    taut_model_free(pipe_run_made(&problem, 1e-3));
    problem = pipe_run_of_legs(near, 3);
    problem.radius = 0.3;
    problem.shape.alpha = problem.shape.gamma = 0;
    error = pipe_run_refused(&problem, TAUT_NO_SOLUTION, "self-intersect-global");
    CHECK_NEAR(error.limit, 0.25, 0.01, "half the distance of the pipes");
    CHECK(strstr(error.message, "pipe1") != NULL && strstr(error.message, "pipe3") != NULL, "%s",
          error.message);
    problem.radius = 0.999 * error.limit;
    taut_model_free(pipe_run_made(&problem, 1e-3));
    problem = pipe_run_of_legs(pipe_placed, 2); /* every blend names its own */
    problem.bend_radius = 50;
    error = pipe_run_refused(&problem, TAUT_NO_SOLUTION, "bend-radius");
    problem.bend_radius = 0.99 * error.limit;
    taut_model_free(pipe_run_made(&problem, 1e-3));
}

/* The number behind some words of a message. */
static double told(const taut_error *error, const char *words)
{
    const char *at = strstr(error->message, words);
    CHECK(at != NULL, "no \"%s\" in: %s", words, error->message);
    return at != NULL ? strtod(at + strlen(words), NULL) : 0;
}

/* The numbers of a message, as they are printed, are followed: each way out is one. */
static void test_ways_out(void)
{
    for (int trial = 0; trial < 4; trial++) {
        double corners[4][3];
        taut_pipe_run_problem problem = pipe_run_of_corners((const double(*)[3])corners, 4);
        memcpy(corners, pipe_stair, sizeof corners);
        problem.radius = 0.01;
        problem.bend_radius = 100;
        problem.shape.alpha = problem.shape.gamma = random_in(-2.5, 0);
        corners[2][1] = random_in(1, 3);
        corners[3][1] = corners[2][1];
        taut_error error = pipe_run_refused(&problem, TAUT_NO_SOLUTION, "leg-too-short");
        problem.bend_radius = told(&error, "bend radius of at most ");
        taut_model_free(pipe_run_made(&problem, 1e-2));
        problem.bend_radius *= 1.1; /* now only one leg is too short */
        error = pipe_run_refused(&problem, TAUT_NO_SOLUTION, "leg-too-short");
        corners[2][1] = corners[3][1] = told(&error, "leg of at least ");
        taut_model_free(pipe_run_made(&problem, 1e-2));
        /* no bend is as sharp as this pipe is wide */
        corners[2][1] = corners[3][1] = 0.1;
        problem.radius = 0.2;
        problem.bend_radius = 0.3;
        error = pipe_run_refused(&problem, TAUT_NO_SOLUTION, "leg-too-short");
        problem.bend_radius = told(&error, "bend radius of at most ");
        problem.radius = 0.99 * problem.bend_radius;
        error = (taut_error){.message = ""};
        taut_model *model = NULL;
        const taut_status status = taut_pipe_run_make(&problem, NULL, &model, &error);
        /* the leg is as short as the pipe is narrow: what may touch is the pipe beyond it */
        CHECK(status == TAUT_OK || strcmp(error.reason, "self-intersect-global") == 0, "%s",
              error.message);
        taut_model_free(model);
    }
}

/* An axis that leaves its legs within 1e-10 of its length: as near as asked for it is not made, but
 * where less is asked, as the message advises. */
static void test_too_fine(void)
{
    const double legs[][3] = {{0, 0, 0}, {5, 0, 0}, {5, 5, 1}};
    const taut_make_options options = {.tolerance = 1e-12};
    taut_pipe_run_problem problem = pipe_run_of_corners(legs, 3);
    taut_model *model = NULL;
    taut_error error = {.message = ""};
    problem.shape.alpha = problem.shape.gamma = -3 + 1e-5;
    problem.radius = 1e-10;
    problem.bend_radius = 1e-9;
    CHECK(taut_pipe_run_make(&problem, &options, &model, &error) == TAUT_NO_SOLUTION &&
              model == NULL,
          "made");
    CHECK(strcmp(error.reason, "too-fine") == 0 && error.found == 1e-12 &&
              strncmp(error.message, "blend1 ", 7) == 0,
          "%s", error.message);
    taut_model_free(pipe_run_made(&problem, 1e-6));
}

/* Corners and straight pipes where others are. */
static void test_same_places(void)
{
    const double again[][3] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 0, 0}};
    const double twice[][3] = {{0, 0, 0}, {0, 0, 0}, {4, 0, 1}};
    const double nearly[][3] = {{0, 0, 0}, {1e-8, 0, 0}, {4, 0, 1}};
    const taut_pipe_leg touching[] = {{.from = {0, 0, 0}, .to = {4, 0, 0}},
                                      {.from = {4, 0, 0}, .to = {4, 4, 0}}};
    taut_pipe_run_problem problem = pipe_run_of_corners(again, 4);
    problem.route.closed = 1;
    taut_error error = pipe_run_refused(&problem, TAUT_BAD_INPUT, "value");
    CHECK(strcmp(error.where, "/run/3") == 0, "at %s", error.where);
    problem = pipe_run_of_corners(twice, 3);
    error = pipe_run_refused(&problem, TAUT_BAD_INPUT, "value");
    CHECK(strcmp(error.where, "/run/1") == 0, "at %s", error.where);
    problem = pipe_run_of_corners(nearly, 3);
    pipe_run_refused(&problem, TAUT_NO_SOLUTION, "too-small");
    problem = pipe_run_of_legs(touching, 2);
    error = pipe_run_refused(&problem, TAUT_NO_SOLUTION, "too-small");
    CHECK(strcmp(error.where, "/run/1") == 0, "at %s", error.where);
}

static void test_bad_numbers(void)
{
    taut_pipe_leg legs[3] = {pipe_placed[0], pipe_placed[1], pipe_placed[2]};
    taut_pipe_run_problem problem = pipe_run_of_legs(legs, 3);
    legs[1].direction[1] = 0;
    pipe_run_refused(&problem, TAUT_BAD_INPUT, "value");
    legs[1].direction[1] = NAN;
    pipe_run_refused(&problem, TAUT_BAD_INPUT, "value");
    memcpy(legs, pipe_placed, sizeof pipe_placed);
    legs[2].to[0] = INFINITY;
    pipe_run_refused(&problem, TAUT_BAD_INPUT, "value");
    memcpy(legs, pipe_placed, sizeof pipe_placed);
    legs[0].to[0] = 1e-9;
    pipe_run_refused(&problem, TAUT_NO_SOLUTION, "too-small");
    memcpy(legs, pipe_placed, sizeof pipe_placed);
    problem.route.count = 1;
    pipe_run_refused(&problem, TAUT_BAD_INPUT, "size");
    problem.route.count = 3;
    problem.route.legs = NULL;
    pipe_run_refused(&problem, TAUT_BAD_ARGUMENT, "argument");
    problem.route.legs = legs;
    problem.bend_radius = NAN;
    pipe_run_refused(&problem, TAUT_BAD_INPUT, "value");
    problem.bend_radius = -1;
    pipe_run_refused(&problem, TAUT_BAD_INPUT, "value");
    problem.bend_radius = 0;
    problem.radius = -1;
    pipe_run_refused(&problem, TAUT_BAD_INPUT, "value");
    problem.radius = 1e-30; /* beside coordinates of 5 */
    pipe_run_refused(&problem, TAUT_NO_SOLUTION, "too-small");
    problem.radius = 0.2;
    for (int choice = 0; choice < 3; choice++) {
        taut_pipe_run_problem other = problem;
        other.route.kind = (taut_pipe_route_kind)(choice == 0 ? TAUT_PIPE_LEGS + 1 : 0);
        other.shape.kind = (taut_pipe_shape_kind)(choice == 1 ? TAUT_PIPE_LEAST_CURVATURE + 1 : 0);
        other.joint = (taut_pipe_joint)(choice == 2 ? TAUT_PIPE_G2 + 1 : 0);
        pipe_run_refused(&other, TAUT_BAD_INPUT, "value");
    }
    problem.shape.alpha = -3;
    pipe_run_refused(&problem, TAUT_NO_SOLUTION, "tangent-lost");
}

int main(void)
{
    random_seed(20261128);
    test_refusals();
    test_ways_out();
    test_too_fine();
    test_same_places();
    test_bad_numbers();
    return check_failures != 0;
}
