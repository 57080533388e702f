/* check.c -- what [XuWang2006] asks of the parameters (section 8 of the page), each refused by name
 * with the way out. */
#include "construct/bonnet/check.h"

#include "core/fail.h"

#include <math.h>

static const double pi = 3.14159265358979323846;
/* F_0^4, which curvatures divide by, must stay finite: cosh(177)^4 does; on Enneper's surface
 * (1 + q^2)^4. */
static const double farthest = 177, farthest_enneper = 1e30;
/* A window this far from zero, in units of its own length, is a point in double precision. */
static const double farthest_start = 1e12;

static taut_status check_lambda(const taut_bonnet_problem *problem, taut_error *error)
{
    for (int i = 0; i < 2; i++) {
        const double lambda = problem->lambda[i];
        const char *where = problem->frames > 1 ? (i == 0 ? "/lambda/0" : "/lambda/1") : "/lambda";
        if (!isfinite(lambda)) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", where, lambda, 1,
                             "lambda is not a finite number");
        }
        if (lambda < 0) {
            return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", where, lambda, 0,
                             "lambda is %.17g, expected 0 or more: the other sign is this surface "
                             "turned by pi about the y axis",
                             lambda);
        }
        if (lambda > 1) {
            return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", where, lambda, 1,
                             "lambda is %.17g, expected less than 1 (or 1 with \"normalize\": "
                             "true): beyond, 1 - lambda^2 has no real root",
                             lambda);
        }
        if (lambda == 1 && !problem->normalize) {
            return taut_fail(
                error, TAUT_NO_SOLUTION, "no-solution", where, lambda, 1,
                "lambda is %.17g, expected less than 1, where the surface grows without "
                "bound: \"normalize\": true has lambda = 1, Enneper's surface",
                lambda);
        }
    }
    return TAUT_OK;
}

/* w of the first frame that needs the longest window: lambda is monotone, so at an end. */
static double widest(const taut_bonnet_problem *problem)
{
    const double lambda = fmin(problem->lambda[0], problem->lambda[problem->frames > 1]);
    return sqrt((1 - lambda) * (1 + lambda));
}

static taut_status check_lengths(const taut_bonnet_problem *problem, taut_error *error)
{
    if (!(problem->alpha > 0) || !isfinite(problem->alpha)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/alpha", problem->alpha, 0,
                         "alpha is %.17g, expected a positive length", problem->alpha);
    }
    if (!(problem->beta > 0) || !isfinite(problem->beta)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/beta", problem->beta, 0,
                         "beta is %.17g, expected a positive length", problem->beta);
    }
    if (!isfinite(problem->start[0]) || !isfinite(problem->start[1]) || !isfinite(problem->theta)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "", taut_none, taut_none,
                         "a number is not finite");
    }
    if (problem->bspline && problem->alpha >= pi) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/alpha", problem->alpha, pi,
                         "alpha is %.17g, expected less than pi, where the four functions of a "
                         "c-bspline become dependent: use more segments",
                         problem->alpha);
    }
    if (!problem->bspline && !problem->normalize && problem->alpha > pi) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/alpha", problem->alpha, pi,
                         "alpha is %.17g, expected at most pi for one c-bezier segment: use "
                         "\"mesh\": \"bspline\" with more segments",
                         problem->alpha);
    }
    if (problem->normalize && widest(problem) * problem->alpha > pi) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/alpha", problem->alpha,
                         pi / widest(problem),
                         "alpha is %.17g, expected at most pi / sqrt(1 - lambda^2) = %.6g for one "
                         "segment: make it of two windows",
                         problem->alpha, pi / widest(problem));
    }
    return TAUT_OK;
}

/* Where v ends: refused at the member that is to blame, its start where that is beyond already. */
static taut_status check_far(const taut_bonnet_problem *problem, double scale, taut_error *error)
{
    const int segments = problem->segments[1] > 0 ? problem->segments[1] : 1;
    const double start = problem->start[1], end = start + problem->beta * segments;
    const double most = scale > 0 ? fmin(farthest / scale, farthest_enneper) : farthest_enneper;

    if (fabs(start) > most) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/start/1", start, most,
                         "the window begins at v = %.6g, expected at most %.6g in size: beyond, "
                         "curvatures overflow. Begin nearer to 0, where the surface has its waist",
                         start, most);
    }
    if (fabs(end) > most) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/beta", end, most,
                         "the window reaches v = %.6g, expected at most %.6g in size: beyond, "
                         "curvatures overflow. From its start a beta of up to %.6g will do",
                         end, most, (most - start) / segments);
    }
    return TAUT_OK;
}

/* The window must be on this side of where numbers end. */
static taut_status check_window(const taut_bonnet_problem *problem, taut_error *error)
{
    const double lengths[2] = {problem->alpha, problem->beta};
    const double scale = problem->normalize ? widest(problem) : 1;

    for (int d = 0; d < 2; d++) {
        if (fabs(problem->start[d]) > farthest_start * lengths[d]) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", d == 0 ? "/start/0" : "/start/1",
                             problem->start[d], farthest_start * lengths[d],
                             "the window begins at %.6g, expected at most %g of its lengths from "
                             "zero: u may be moved by 2 pi",
                             problem->start[d], farthest_start);
        }
    }
    if (problem->normalize && fabs(problem->start[0]) + problem->alpha > farthest_enneper) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/alpha", problem->alpha,
                         farthest_enneper,
                         "the window reaches %.6g in p, expected at most %g: beyond, curvatures "
                         "overflow",
                         fabs(problem->start[0]) + problem->alpha, farthest_enneper);
    }
    return check_far(problem, scale, error);
}

/* Control points of all frames together. */
static double points_of(const taut_bonnet_problem *problem)
{
    const double frames = problem->frames > 1 ? problem->frames : 1;
    return frames * (fmax(problem->segments[0], 1) + 3) * (fmax(problem->segments[1], 1) + 3);
}

static taut_status check_rest(const taut_bonnet_problem *problem, taut_error *error)
{
    if (problem->sign != 1 && problem->sign != -1) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/sign", problem->sign, 1,
                         "expected \"+\" or \"-\"");
    }
    if (problem->normalize && (problem->sign != -1 || problem->bspline)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", problem->bspline ? "/mesh" : "/sign",
                         taut_none, taut_none,
                         "the normalised family has sign \"-\" and mesh \"bezier\"");
    }
    if (!problem->bspline && (problem->segments[0] > 1 || problem->segments[1] > 1)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/segments", taut_none, taut_none,
                         "the quasi-Bezier mesh has one segment: use \"mesh\": \"bspline\"");
    }
    if (problem->segments[0] < 0 || problem->segments[1] < 0 ||
        problem->segments[0] > TAUT_COUNT_MAX / 2 || problem->segments[1] > TAUT_COUNT_MAX / 2 ||
        problem->frames < 0 || problem->frames > TAUT_OBJECTS_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/segments", taut_none, TAUT_COUNT_MAX / 2,
                         "segments and frames must be at least 1 and not more than taut takes");
    }
    if (points_of(problem) > TAUT_POINTS_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "value",
                         problem->frames > 1 ? "/frames" : "/segments", points_of(problem),
                         TAUT_POINTS_MAX,
                         "the surfaces have %.0f points in all, expected at most %d",
                         points_of(problem), TAUT_POINTS_MAX);
    }
    return TAUT_OK;
}

taut_status taut_bonnet_check(const taut_bonnet_problem *problem, taut_error *error)
{
    taut_status status = check_lambda(problem, error);

    if (status == TAUT_OK) {
        status = check_lengths(problem, error);
    }
    if (status == TAUT_OK) {
        status = check_rest(problem, error);
    }
    return status == TAUT_OK ? check_window(problem, error) : status;
}
