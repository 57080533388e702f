/* run_legs.c -- where the straight pipes of a run are, and what blends them.
 *
 * Corners: an elbow has V_1 = V_2 at its corner and equal handles h. Its curvature is that of the
 * elbow with h = 1 divided by h, so that h = R kappa_1 makes the least radius of curvature R, and
 * the elbows of a leg fit on it up to R = length / (sum of both kappa_1).
 * Legs: straight pipes stay where they are, handles are chosen as between any two directed ends.
 */
#include "construct/pipe/run.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Sine of a turn that is none; over the radius, a straight pipe that is none, and what is left of a
 * leg when its elbows take all of it. */
static const double turns_not = 1e-9, no_length = 1e-6, nothing_left = 1e-8;
static const double least_inside = 1e-3; /* over the radius: a wall, and what is inside it */
static const double same_turn = 1e-12;   /* of its cosine */
static const double bend_of_corners = 3;
static const double unit_radius = 0x1p-20; /* of an elbow with handles of 1, to choose its shape */

static taut_status check_leg(const taut_pipe_leg *leg, const char *where, taut_error *error)
{
    const taut_status status = taut_pipe_check_point(leg->from, where, error);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_pipe_check_point(leg->kind == TAUT_PIPE_LEG_SPAN ? leg->to : leg->direction, where,
                                 error);
}

static taut_status check_route(const taut_pipe_route *route, taut_error *error)
{
    const int are_corners = route->kind == TAUT_PIPE_CORNERS;
    const int least = are_corners && route->closed ? 3 : 2;
    taut_status status = TAUT_OK;
    if (route->count < least) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/run", route->count, least,
                         "found %d, expected at least %d: a run has two pipes or more",
                         route->count, least);
    }
    for (int i = 0; i < route->count && status == TAUT_OK; i++) {
        char where[32];
        snprintf(where, sizeof where, "/run/%d", i);
        status = are_corners ? taut_pipe_check_point(route->corners + 3 * (size_t)i, where, error)
                             : check_leg(&route->legs[i], where, error);
    }
    return status;
}

/* What is left inside is a pipe. */
static taut_status check_wall(const taut_pipe_run_problem *p, taut_error *error)
{
    const double least = least_inside * p->radius;
    if (p->wall == 0) {
        return TAUT_OK;
    }
    if (p->route.closed) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "conflict", "/wall", taut_none,
                                  "an open run",
                                  "a closed run has no ends where inside and outside are joined");
    }
    if (!(p->wall >= least && p->radius - p->wall >= least)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/wall", p->wall, p->radius,
                         "a wall of %.6g, expected one between %.6g and %.6g: the radius is %.6g",
                         p->wall, least, p->radius - least, p->radius);
    }
    return TAUT_OK;
}

static taut_status check_run(const taut_pipe_run_problem *p, taut_error *error)
{
    const taut_pipe_choice choices[] = {{"/run", (int)p->route.kind, TAUT_PIPE_LEGS},
                                        {"/shape", (int)p->shape.kind, TAUT_PIPE_LEAST_CURVATURE},
                                        {"/joint", (int)p->joint, TAUT_PIPE_G2},
                                        {"/elbow", (int)p->elbow, TAUT_PIPE_ELBOW_ARC}};
    taut_status status = taut_pipe_check_choices(choices, sizeof choices / sizeof *choices, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (p->route.count > 0 &&
        (p->route.kind == TAUT_PIPE_CORNERS ? p->route.corners == NULL : p->route.legs == NULL)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a run of %d legs needs the legs", p->route.count);
    }
    if (p->elbow == TAUT_PIPE_ELBOW_ARC &&
        (p->route.kind != TAUT_PIPE_CORNERS || p->joint != TAUT_PIPE_G1)) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "conflict", "/elbow", taut_none,
                                  "corners, joined with equal tangent planes",
                                  "arcs round the corners of a run, and are curved from their ends "
                                  "on: give corners, and \"g1\"");
    }
    status = taut_pipe_check_length(p->radius, "/radius", error);
    if (status != TAUT_OK) {
        return status;
    }
    status = check_wall(p, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = check_route(&p->route, error);
    if (status != TAUT_OK || p->bend_radius == 0) {
        return status;
    }
    return taut_pipe_check_length(p->bend_radius, "/bend_radius", error);
}

/* Direction and length of a straight pipe, which must not be lost in its coordinates; without a
 * length it has the direction given, NULL where none is. */
static taut_status measure_straight(taut_pipe_straight *s, const double *direction, double radius,
                                    int at, taut_error *error)
{
    double d[3], size = 0, least = 0;
    char where[32];
    taut_difference(s->to, s->from, d);
    s->length = taut_norm(d);
    for (int k = 0; k < 3; k++) {
        least = fmax(least, 0x1p-44 * fmax(fabs(s->from[k]), fabs(s->to[k])));
    }
    snprintf(where, sizeof where, "/run/%d", at);
    if (radius < least) {
        return taut_fail(error, TAUT_NO_SOLUTION, "too-small", "/radius", radius, least,
                         "TOO_SMALL: %.6g is lost in the rounding of coordinates of this size; "
                         "move the origin near, or take more than %.6g",
                         radius, least);
    }
    if (s->length > 0 && s->length < fmax(least, no_length * radius)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "too-small", where, s->length, no_length * radius,
                         "TOO_SMALL: the straight pipe is %.6g long; give one place with "
                         "its direction, or places farther apart than %.6g",
                         s->length, fmax(least, no_length * radius));
    }
    if (!(s->length > 0) && direction != NULL) {
        memcpy(d, direction, sizeof d);
    }
    size = taut_norm(d);
    if (!(size >= 1e-90)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", where, size, 0,
                         "the direction is zero: which way does the pipe flow?");
    }
    for (int k = 0; k < 3; k++) {
        s->direction[k] = d[k] / size;
    }
    return TAUT_OK;
}

static taut_status take_pieces(taut_pipe_run *run, int straights, int elbows, taut_error *error)
{
    run->straights = taut_arena_take(run->arena, (size_t)straights, sizeof *run->straights);
    run->elbows = taut_arena_take(run->arena, (size_t)elbows, sizeof *run->elbows);
    return taut_arena_status(run->arena) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

/* What every elbow takes from the run. */
static void begin_elbow(taut_pipe_run *run, int i, taut_pipe_axis_kind axis)
{
    taut_pipe_elbow *const e = &run->elbows[i];
    *e = (taut_pipe_elbow){
        .problem = {.axis = {.kind = axis},
                    .section = {.kind = TAUT_PIPE_ROUND, .radius = run->problem->radius},
                    .shape = run->problem->shape,
                    .joint = run->problem->joint,
                    .bend_radius = run->bend_radius}};
    snprintf(e->name, sizeof e->name, "blend%d", i + 1);
}

/* Handles and shape that are not given, then what the elbow is like; between half lines, or
 * straight pipes of these lengths. */
static taut_status decide_elbow(taut_pipe_run *run, taut_pipe_elbow *e, const double *lengths,
                                taut_error *error)
{
    e->task = (taut_pipe_task){.problem = &e->problem,
                               .monitor = run->monitor,
                               .arena = run->arena,
                               .lengths = {lengths != NULL ? lengths[0] : INFINITY,
                                           lengths != NULL ? lengths[1] : INFINITY}};
    return taut_pipe_decide(&e->task, e->name, error);
}

/* Straight pipes that meet leave no room for a blend. */
static taut_status check_gap(const taut_pipe_run *run, int i, const taut_pipe_straight *a,
                             const taut_pipe_straight *b, taut_error *error)
{
    const double gap = taut_distance(a->to, b->from), least = no_length * run->problem->radius;
    char where[32];
    if (gap >= least) {
        return TAUT_OK;
    }
    snprintf(where, sizeof where, "/run/%d", (i + 1) % run->straight_count);
    return taut_fail(error, TAUT_NO_SOLUTION, "too-small", where, gap, least,
                     "TOO_SMALL: the straight pipe begins where the one before it ends, which "
                     "leaves no room for blend%d; shorten them, make one of both where they are "
                     "in line, or give corners",
                     i + 1);
}

static taut_status lay_straight(taut_pipe_run *run, int i, taut_error *error)
{
    const taut_pipe_leg *const leg = &run->problem->route.legs[i];
    const int is_span = leg->kind == TAUT_PIPE_LEG_SPAN;
    taut_pipe_straight *const s = &run->straights[i];
    memcpy(s->from, leg->from, sizeof s->from);
    memcpy(s->to, is_span ? leg->to : leg->from, sizeof s->to);
    return measure_straight(s, is_span ? NULL : leg->direction, run->problem->radius, i, error);
}

static taut_status lay_blend(taut_pipe_run *run, int i, taut_error *error)
{
    const taut_pipe_straight *const a = &run->straights[i];
    const taut_pipe_straight *const b = &run->straights[(i + 1) % run->straight_count];
    const double lengths[2] = {a->length, b->length};
    const taut_status status = check_gap(run, i, a, b, error);
    taut_pipe_elbow *const e = &run->elbows[i];
    taut_pipe_end *const ends = e->problem.axis.ends;
    if (status != TAUT_OK) {
        return status;
    }
    begin_elbow(run, i, TAUT_PIPE_ENDS);
    memcpy(ends[0].point, a->to, sizeof a->to);
    memcpy(ends[1].point, b->from, sizeof b->from);
    memcpy(ends[0].direction, a->direction, sizeof a->direction);
    memcpy(ends[1].direction, b->direction, sizeof b->direction);
    return decide_elbow(run, e, lengths, error);
}

static taut_status lay_legs(taut_pipe_run *run, taut_error *error)
{
    taut_status status = TAUT_OK;
    run->straight_count = run->problem->route.count;
    run->elbow_count = run->straight_count - (run->closed ? 0 : 1);
    status = take_pieces(run, run->straight_count, run->elbow_count, error);
    for (int i = 0; i < run->straight_count && status == TAUT_OK; i++) {
        status = lay_straight(run, i, error);
    }
    for (int i = 0; i < run->elbow_count && status == TAUT_OK; i++) {
        status = lay_blend(run, i, error);
    }
    return status;
}

/* Corner i, those of a closed run over and over. */
static const double *corner_of(const taut_pipe_run *run, int i)
{
    return run->problem->route.corners + 3 * (size_t)(i % run->problem->route.count);
}

/* A corner apart from the one before it; the first comes again by itself where the run is closed.
 */
static taut_status check_corner(const taut_pipe_run *run, int i, const taut_pipe_straight *next,
                                taut_error *error)
{
    const double length = taut_distance(next->from, next->to);
    const double least = no_length * run->problem->radius;
    const int again = run->closed && i + 1 == run->problem->route.count, place = again ? i : i + 1;
    char where[32];
    snprintf(where, sizeof where, "/run/%d", place);
    if (length >= least) {
        return TAUT_OK;
    }
    if (length > 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "too-small", where, length, least,
                         "TOO_SMALL: the corner is only %.6g from the %s; leave one out, or take "
                         "more than %.6g",
                         length, again ? "first, to which the run comes back" : "one before it",
                         least);
    }
    return taut_fail(
        error, TAUT_BAD_INPUT, "value", where, 0, 0,
        again ? "the corner is where the first is, to which a closed run comes back: leave it out"
              : "the corner is where the one before it is: leave one out");
}

/* Straight pipes from corner to corner. */
static taut_status find_corners(taut_pipe_run *run, int *places, taut_error *error)
{
    const int legs = run->problem->route.count - (run->closed ? 0 : 1);
    for (int i = 0; i < legs; i++) {
        taut_pipe_straight *const next = &run->straights[i];
        taut_status status = TAUT_OK;
        memcpy(next->from, corner_of(run, i), sizeof next->from);
        memcpy(next->to, corner_of(run, i + 1), sizeof next->to);
        status = check_corner(run, i, next, error);
        if (status != TAUT_OK) {
            return status;
        }
        status = measure_straight(next, NULL, run->problem->radius, i, error);
        if (status != TAUT_OK) {
            return status;
        }
        places[i] = i;
    }
    run->straight_count = legs;
    return TAUT_OK;
}

static int goes_straight_on(const taut_pipe_straight *a, const taut_pipe_straight *b)
{
    double across[3];
    taut_cross(a->direction, b->direction, across);
    return taut_norm(across) <= turns_not && taut_dot(a->direction, b->direction) > 0;
}

static taut_status check_turn(const taut_pipe_straight *a, const taut_pipe_straight *b, int place,
                              taut_error *error)
{
    double across[3];
    char where[32];
    taut_cross(a->direction, b->direction, across);
    snprintf(where, sizeof where, "/run/%d", place);
    if (taut_norm(across) <= turns_not) {
        return taut_fail(error, TAUT_NO_SOLUTION, "turns-back", where, 0, 0,
                         "TURNS_BACK: the run turns back on itself at this corner; two corners, "
                         "more than two radii apart, make a bend of it");
    }
    return TAUT_OK;
}

/* Corners that do not turn are left out: a leg reaches over them. */
static void join_legs(taut_pipe_run *run, int *places)
{
    int kept = 0;
    for (int i = 0; i < run->straight_count; i++) {
        taut_pipe_straight *const last = &run->straights[kept - (kept > 0)];
        if (kept > 0 && goes_straight_on(last, &run->straights[i])) {
            memcpy(last->to, run->straights[i].to, sizeof last->to);
            last->length = taut_distance(last->to, last->from);
        } else {
            places[kept] = places[i];
            run->straights[kept++] = run->straights[i];
        }
    }
    if (run->closed && kept > 1 &&
        goes_straight_on(&run->straights[kept - 1], &run->straights[0])) {
        memcpy(run->straights[0].from, run->straights[kept - 1].from, 3 * sizeof(double));
        run->straights[0].length = taut_distance(run->straights[0].to, run->straights[0].from);
        places[0] = places[kept - 1];
        kept--;
    }
    run->straight_count = kept;
    run->elbow_count = kept - (run->closed ? 0 : 1);
}

static void give_shape(taut_pipe_elbow *e, const double shape[3])
{
    e->problem.shape.kind = TAUT_PIPE_SHAPE_GIVEN;
    e->problem.shape.alpha = shape[0];
    e->problem.shape.beta = shape[1];
    e->problem.shape.gamma = shape[2];
}

/* The elbow with handles of 1: its shape, given, chosen, or that of an earlier one with the same
 * turn, and its largest curvature. */
static taut_status try_elbow(taut_pipe_run *run, int i, double *curvature, taut_error *error)
{
    taut_pipe_elbow *const e = &run->elbows[i];
    const double *a = run->straights[i].direction;
    const double *b = run->straights[(i + 1) % run->straight_count].direction;
    const double cosine = taut_dot(a, b);
    taut_status status = TAUT_OK;
    begin_elbow(run, i, TAUT_PIPE_POLYGON);
    if (run->problem->elbow == TAUT_PIPE_ELBOW_ARC) { /* tan(angle / 2) */
        double across[3];
        taut_cross(a, b, across);
        *curvature = taut_norm(across) / (1 + cosine);
        return TAUT_OK;
    }
    e->problem.section.radius = unit_radius;
    e->problem.bend_radius = 0;
    for (int k = 0; k < 3; k++) {
        e->problem.axis.polygon[0][k] = -a[k];
        e->problem.axis.polygon[3][k] = b[k];
    }
    for (int j = 0; j < i && e->problem.shape.kind != TAUT_PIPE_SHAPE_GIVEN; j++) {
        if (fabs(run->elbows[j].cosine - cosine) <= same_turn) {
            give_shape(e, run->elbows[j].task.shape);
        }
    }
    status = decide_elbow(run, e, NULL, error);
    e->cosine = cosine;
    *curvature = e->task.bend.curvature / e->task.scale;
    return status;
}

/* The largest R with which every leg holds its elbows. */
static double largest_bend(const taut_pipe_run *run, const double *curvatures, int *leg)
{
    double largest = INFINITY;
    for (int i = 0; i < run->straight_count; i++) {
        const int before = run->closed ? (i + run->elbow_count - 1) % run->elbow_count : i - 1;
        const double sum =
            (before >= 0 ? curvatures[before] : 0) + (i < run->elbow_count ? curvatures[i] : 0);
        if (run->straights[i].length / sum < largest) {
            largest = run->straights[i].length / sum;
            *leg = i;
        }
    }
    return run->problem->elbow == TAUT_PIPE_ELBOW_ARC ? largest : largest / (1 + TAUT_PIPE_SLACK);
}

/* Of a length that ends at a corner, twice over for its direction's. */
static double rounding_at(const double corner[3], double length)
{
    return 16 * TAUT_UNIT_ROUNDOFF * (length + taut_norm(corner));
}

/* An arc that leaves no straight pipe of a leg takes all of it, and as much of the other: its handle, longer,
 * or shorter by rounding. */
static taut_status fit_arc(const taut_pipe_run *run, int i, const double corner[3], double *handle,
                           taut_error *error)
{
    const double asked = *handle, least = no_length * run->problem->radius;
    const double *const ends[2] = {run->straights[i].from,
                                   run->straights[(i + 1) % run->straight_count].to};
    double low = INFINITY, high = 0;
    for (int end = 0; end < 2; end++) {
        const double room = taut_distance(ends[end], corner);
        if (fabs(room - asked) < least) {
            low = fmin(low, room);
            *handle = high = fmax(high, room);
        }
    }
    high = fmax(asked, high);
    if (low >= high - rounding_at(corner, asked)) {
        return TAUT_OK;
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "too-small", "/run", low, high,
                     "TOO_SMALL: %s needs %.15g of both legs, and one has %.15g: lengthen it",
                     run->elbows[i].name, high, low);
}

/* The elbow in its place: handles h along both legs, which get shorter by them. */
static taut_status place_elbow(taut_pipe_run *run, int i, double handle, const double corner[3],
                               taut_error *error)
{
    taut_pipe_elbow *const e = &run->elbows[i];
    taut_pipe_straight *const a = &run->straights[i];
    taut_pipe_straight *const b = &run->straights[(i + 1) % run->straight_count];
    const double shape[3] = {e->task.shape[0], e->task.shape[1], e->task.shape[2]};
    double(*const polygon)[3] = e->problem.axis.polygon;
    taut_status status = TAUT_OK;
    begin_elbow(run, i, TAUT_PIPE_POLYGON);
    give_shape(e, shape);
    if (run->problem->elbow == TAUT_PIPE_ELBOW_ARC) {
        status = fit_arc(run, i, corner, &handle, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    for (int k = 0; k < 3; k++) {
        a->to[k] = corner[k] - handle * a->direction[k];
        polygon[1][k] = polygon[2][k] = corner[k];
        b->from[k] = corner[k] + handle * b->direction[k];
    }
    if (taut_distance(a->from, a->to) < nothing_left * run->problem->radius) {
        memcpy(a->to, a->from, sizeof a->to); /* the elbow before ends here */
    }
    if (taut_distance(b->from, b->to) < nothing_left * run->problem->radius) {
        memcpy(b->from, b->to, sizeof b->from);
    }
    memcpy(polygon[0], a->to, sizeof a->to);
    memcpy(polygon[3], b->from, sizeof b->from);
    a->length = taut_distance(a->from, a->to);
    b->length = taut_distance(b->from, b->to);
    if (run->problem->elbow == TAUT_PIPE_ELBOW_ARC) {
        taut_pipe_round_settle(a->direction, b->direction, e);
        return TAUT_OK;
    }
    status = decide_elbow(run, e, NULL, error);
    e->problem.shape.kind = run->problem->shape.kind;
    return status;
}

/* What is told to work is rounded to the side that does. */
static taut_status fail_short(const taut_pipe_run *run, int leg, int place, double largest,
                              taut_error *error)
{
    const double digits = 1e-11, length = run->straights[leg].length;
    const double fits = largest * (1 - digits);
    char where[32];
    snprintf(where, sizeof where, "/run/%d", place);
    return taut_fail(error, TAUT_NO_SOLUTION, "leg-too-short", where, run->bend_radius, largest,
                     "LEG_TOO_SHORT: with a bend radius of %.12g%s the elbows take more than the "
                     "leg of %.6g that begins here; a bend radius of at most %.12g%s would work, "
                     "or a leg of at least %.12g",
                     run->bend_radius,
                     run->problem->bend_radius > 0 ? "" : " (three radii, where none is given)",
                     length, fits,
                     /* no bend is as sharp as the pipe is wide */
                     fits > run->problem->radius ? "" : " with a radius below that",
                     length * run->bend_radius / fits);
}

static taut_status place_elbows(taut_pipe_run *run, const double *curvatures, const int *places,
                                taut_error *error)
{
    int leg = 0;
    const double largest = largest_bend(run, curvatures, &leg);
    taut_status status = TAUT_OK;
    const double length = run->straights[leg].length;
    if (!(length * (run->bend_radius / largest - 1) <=
          rounding_at(run->straights[leg].to, length))) {
        return fail_short(run, leg, places[leg], largest, error);
    }
    for (int i = 0; i < run->elbow_count && status == TAUT_OK; i++) {
        const double *corner = corner_of(run, places[(i + 1) % run->straight_count]);
        const double slack = run->problem->elbow == TAUT_PIPE_ELBOW_ARC ? 0 : TAUT_PIPE_SLACK;
        status = place_elbow(run, i, run->bend_radius * curvatures[i] * (1 + slack), corner, error);
    }
    return status;
}

static taut_status lay_corners(taut_pipe_run *run, taut_error *error)
{
    const int count = run->problem->route.count;
    int *const places = taut_arena_take(run->arena, (size_t)count + 1, sizeof *places);
    double *const curvatures = taut_arena_take(run->arena, (size_t)count, sizeof *curvatures);
    taut_status status = take_pieces(run, count, count, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = find_corners(run, places, error);
    if (status != TAUT_OK) {
        return status;
    }
    join_legs(run, places);
    if (run->elbow_count < 1) {
        return taut_fail(error, TAUT_NO_SOLUTION, "run-straight", "/run", 0, 0,
                         "RUN_STRAIGHT: no corner turns, so that the run is one cylinder; give a "
                         "corner off the line");
    }
    for (int i = 0; i < run->elbow_count; i++) {
        const int next = (i + 1) % run->straight_count;
        status = check_turn(&run->straights[i], &run->straights[next], places[next], error);
        if (status != TAUT_OK) {
            return status;
        }
        status = try_elbow(run, i, &curvatures[i], error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    return place_elbows(run, curvatures, places, error);
}

taut_status taut_pipe_run_lay(taut_pipe_run *run, taut_error *error)
{
    const taut_pipe_run_problem *p = run->problem;
    const int are_corners = p->route.kind == TAUT_PIPE_CORNERS;
    const taut_status status = check_run(p, error);
    if (status != TAUT_OK) {
        return status;
    }
    run->closed = p->route.closed != 0;
    run->bend_radius = p->bend_radius != 0 ? p->bend_radius
                       : are_corners       ? bend_of_corners * p->radius
                                           : 0;
    return are_corners ? lay_corners(run, error) : lay_legs(run, error);
}
