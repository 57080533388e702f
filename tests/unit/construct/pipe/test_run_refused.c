/* test_run_refused.c -- what is refused of a run, and that what is told to work does. */
#include "check.h"
#include "pipe_runs.h"

#include "core/vec3.h"

#include <stdlib.h>
#include <string.h>

static void test_refusals(void)
{
    const taut_pipe_leg back[] = {
        {.from = {0, 0, 0}}, {.from = {4, 0, 0}}, {.from = {1, 0, 0}}, {.from = {1, 3, 0}}};
    const taut_pipe_leg twice[] = {{.from = {0, 0, 0}}, {.from = {4, 0, 0}}, {.from = {4, 0, 0}}};
    const taut_pipe_leg straight[] = {
        {.from = {0, 0, 0}}, {.from = {2, 0, 0}}, {.from = {4, 0, 0}}};
    /* out and back beside itself: half of 0.5 is too near for 0.3 */
    const taut_pipe_leg near[] = {{.from = {0, 0, 0}, .to = {4, 0, 0}},
                                  {.from = {8, 3, 0}, .to = {8, 3, 0}, .direction = {-1, 1, 0}},
                                  {.from = {4, 0.5, 0.1}, .to = {0, 0.5, 0}}};
    taut_pipe_problem problem = pipe_run_of(TAUT_PIPE_CORNERS, back, 4);
    taut_error error = pipe_refused(&problem, TAUT_NO_SOLUTION, "TURNS_BACK");
    CHECK(strcmp(error.where, "/run/1") == 0, "at %s", error.where);
    problem = pipe_run_of(TAUT_PIPE_CORNERS, twice, 3);
    error = pipe_refused(&problem, TAUT_BAD_INPUT, "leave one out");
    CHECK(strcmp(error.where, "/run/2") == 0, "at %s", error.where);
    problem = pipe_run_of(TAUT_PIPE_CORNERS, straight, 3);
    pipe_refused(&problem, TAUT_NO_SOLUTION, "RUN_STRAIGHT");
    problem = pipe_run_of(TAUT_PIPE_CORNERS, pipe_stair, 4);
    problem.bend_radius = 0.4;
    problem.radius = 0.5;
    error = pipe_refused(&problem, TAUT_NO_SOLUTION, "SELF_INTERSECT_LOCAL");
    problem.radius = 0.999 * error.limit;
    taut_model_free(pipe_made(&problem, 1e-3));
    problem = pipe_run_of(TAUT_PIPE_LEGS, near, 3);
    problem.radius = 0.3;
    problem.alpha = problem.gamma = 0;
    error = pipe_refused(&problem, TAUT_NO_SOLUTION, "SELF_INTERSECT_GLOBAL");
    CHECK_NEAR(error.limit, 0.25, 0.01, "half the distance of the pipes");
    CHECK(strstr(error.message, "pipe1") != NULL && strstr(error.message, "pipe3") != NULL, "%s",
          error.message);
    problem.radius = 0.999 * error.limit;
    taut_model_free(pipe_made(&problem, 1e-3));
    problem = pipe_run_of(TAUT_PIPE_LEGS, pipe_placed, 2); /* every blend names its own */
    problem.bend_radius = 50;
    error = pipe_refused(&problem, TAUT_NO_SOLUTION, "BEND_RADIUS");
    problem.bend_radius = 0.99 * error.limit;
    taut_model_free(pipe_made(&problem, 1e-3));
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
        taut_pipe_leg legs[4] = {{.from = {0}}};
        taut_pipe_problem problem = pipe_run_of(TAUT_PIPE_CORNERS, legs, 4);
        memcpy(legs, pipe_stair, sizeof pipe_stair);
        problem.radius = 0.01;
        problem.bend_radius = 100;
        problem.alpha = problem.gamma = random_in(-2.5, 0);
        legs[2].from[1] = random_in(1, 3);
        legs[3].from[1] = legs[2].from[1];
        taut_error error = pipe_refused(&problem, TAUT_NO_SOLUTION, "LEG_TOO_SHORT");
        problem.bend_radius = told(&error, "bend radius of at most ");
        taut_model_free(pipe_made(&problem, 1e-2));
        problem.bend_radius *= 1.1; /* now only one leg is too short */
        error = pipe_refused(&problem, TAUT_NO_SOLUTION, "LEG_TOO_SHORT");
        legs[2].from[1] = legs[3].from[1] = told(&error, "leg of at least ");
        taut_model_free(pipe_made(&problem, 1e-2));
        /* no bend is as sharp as this pipe is wide */
        legs[2].from[1] = legs[3].from[1] = 0.1;
        problem.radius = 0.2;
        problem.bend_radius = 0.3;
        error = pipe_refused(&problem, TAUT_NO_SOLUTION, "with a radius below that");
        problem.bend_radius = told(&error, "bend radius of at most ");
        problem.radius = 0.99 * problem.bend_radius;
        error = (taut_error){.message = ""};
        taut_model *model = NULL;
        const taut_status status = taut_pipe_make(&problem, NULL, &model, &error);
        /* the leg is as short as the pipe is narrow: what may touch is the pipe beyond it */
        CHECK(status == TAUT_OK || strstr(error.message, "GLOBAL") != NULL, "%s", error.message);
        taut_model_free(model);
    }
}

/* An axis that leaves its legs within 1e-10 of its length: as near as asked for it is not made, but
 * where less is asked, as the message advises. */
static void test_too_fine(void)
{
    const taut_pipe_leg legs[] = {{.from = {0, 0, 0}}, {.from = {5, 0, 0}}, {.from = {5, 5, 1}}};
    const taut_make_options options = {.tolerance = 1e-12};
    taut_pipe_problem problem = pipe_run_of(TAUT_PIPE_CORNERS, legs, 3);
    taut_model *model = NULL;
    taut_error error = {.message = ""};
    problem.alpha = problem.gamma = -3 + 1e-5;
    problem.radius = 1e-10;
    problem.bend_radius = 1e-9;
    CHECK(taut_pipe_make(&problem, &options, &model, &error) == TAUT_NO_SOLUTION && model == NULL,
          "made");
    CHECK(strstr(error.message, "blend1 needs more than 100000 segments") != NULL &&
              error.found == 1e-12,
          "%s", error.message);
    taut_model_free(pipe_made(&problem, 1e-6));
}

/* Corners and straight pipes where others are. */
static void test_same_places(void)
{
    const taut_pipe_leg again[] = {
        {.from = {0, 0, 0}}, {.from = {4, 0, 0}}, {.from = {4, 4, 1}}, {.from = {0, 0, 0}}};
    const taut_pipe_leg twice[] = {{.from = {0, 0, 0}}, {.from = {0, 0, 0}}, {.from = {4, 0, 1}}};
    const taut_pipe_leg nearly[] = {
        {.from = {0, 0, 0}}, {.from = {1e-8, 0, 0}}, {.from = {4, 0, 1}}};
    const taut_pipe_leg touching[] = {{.from = {0, 0, 0}, .to = {4, 0, 0}},
                                      {.from = {4, 0, 0}, .to = {4, 4, 0}}};
    taut_pipe_problem problem = pipe_run_of(TAUT_PIPE_CORNERS, again, 4);
    problem.closed = 1;
    taut_error error = pipe_refused(&problem, TAUT_BAD_INPUT, "by itself: leave it out");
    CHECK(strcmp(error.where, "/run/3") == 0, "at %s", error.where);
    problem = pipe_run_of(TAUT_PIPE_CORNERS, twice, 3);
    error = pipe_refused(&problem, TAUT_BAD_INPUT, "leave one out");
    CHECK(strcmp(error.where, "/run/1") == 0, "at %s", error.where);
    problem = pipe_run_of(TAUT_PIPE_CORNERS, nearly, 3);
    pipe_refused(&problem, TAUT_NO_SOLUTION, "the corner is only 1e-08");
    problem = pipe_run_of(TAUT_PIPE_LEGS, touching, 2);
    error = pipe_refused(&problem, TAUT_NO_SOLUTION, "no room for blend1");
    CHECK(strcmp(error.where, "/run/1") == 0, "at %s", error.where);
}

static void test_bad_numbers(void)
{
    taut_pipe_leg legs[4] = {{.from = {0}}};
    taut_pipe_problem problem = pipe_run_of(TAUT_PIPE_LEGS, legs, 3);
    memcpy(legs, pipe_placed, sizeof pipe_placed);
    legs[1].direction[1] = 0;
    pipe_refused(&problem, TAUT_BAD_INPUT, "direction is zero");
    legs[1].direction[1] = NAN;
    pipe_refused(&problem, TAUT_BAD_INPUT, "coordinate");
    memcpy(legs, pipe_placed, sizeof pipe_placed);
    legs[2].to[0] = INFINITY;
    pipe_refused(&problem, TAUT_BAD_INPUT, "coordinate");
    memcpy(legs, pipe_placed, sizeof pipe_placed);
    legs[0].to[0] = 1e-9;
    pipe_refused(&problem, TAUT_NO_SOLUTION, "TOO_SMALL");
    memcpy(legs, pipe_placed, sizeof pipe_placed);
    problem.leg_count = 1;
    pipe_refused(&problem, TAUT_BAD_INPUT, "at least 2");
    problem.leg_count = 3;
    problem.legs = NULL;
    pipe_refused(&problem, TAUT_BAD_ARGUMENT, "needs the legs");
    problem.legs = legs;
    problem.bend_radius = NAN;
    pipe_refused(&problem, TAUT_BAD_INPUT, "positive length");
    problem.bend_radius = -1;
    pipe_refused(&problem, TAUT_BAD_INPUT, "positive length");
    problem.bend_radius = 0;
    problem.radius = -1;
    pipe_refused(&problem, TAUT_BAD_INPUT, "positive length");
    problem.radius = 1e-30; /* beside coordinates of 5 */
    pipe_refused(&problem, TAUT_NO_SOLUTION, "TOO_SMALL");
    problem.radius = 0.2;
    problem.radii[0] = 1;
    pipe_refused(&problem, TAUT_BAD_INPUT, "of one radius");
    problem.radii[0] = 0;
    problem.alpha = -3;
    pipe_refused(&problem, TAUT_NO_SOLUTION, "TANGENT_LOST");
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
