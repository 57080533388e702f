/* test_envelope.c -- `regular`, `graph` and `tube` of pipes of two radii, against closed forms about a
 * straight axis, against spheres and feet sought from outside, and where each must be false. */
#include "certificates.h"
#include "check.h"
#include "edit.h"
#include "pipes.h"

#include "core/constants.h"
#include "core/vec3.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Along z from 0 to 3, with P = (0, 0, 3 t). */
static taut_pipe_problem straight(double from, double to)
{
    return (taut_pipe_problem){
        .axis = {.kind = TAUT_PIPE_ENDS,
                 .ends = {{{0, 0, 0}, {0, 0, 1}, 1}, {{0, 0, 3}, {0, 0, 1}, 1}}},
        .section = {.kind = TAUT_PIPE_CANAL, .radii = {from, to}}};
}

/* 1 - r_s^2 - r r_ss and sqrt(1 - r_s^2) at s = 3 t. */
static void forms_at(double from, double to, double t, double forms[2])
{
    const double c = to - from, r = from + c * t * t * (3 - 2 * t);
    const double rs = 6 * c * t * (1 - t) / 3, rss = 6 * c * (1 - 2 * t) / 9;
    forms[0] = 1 - rs * rs - r * rss;
    forms[1] = sqrt(fmax(0, 1 - rs * rs));
}

/* The least of both. */
static void least_of(double from, double to, double least[2])
{
    forms_at(from, to, 0, least);
    for (int i = 1; i <= 100000; i++) {
        double forms[2];
        forms_at(from, to, i / 1e5, forms);
        for (int k = 0; k < 2; k++) {
            least[k] = forms[k] < least[k] ? forms[k] : least[k];
        }
    }
}

static const taut_claim *claim_with(const taut_model *model, const taut_pipe_problem *problem,
                                    const char *name, taut_certificate **certificate)
{
    CHECK(taut_pipe_certify(model, problem, NULL, certificate, NULL) == TAUT_OK, "%s", name);
    return claim_of(*certificate, name);
}

static void test_straight(void)
{
    static const double radii[][2] = {{0.8, 0.3}, {0.2, 0.9}, {0.5, 0.49}, {0.05, 1}};
    for (size_t i = 0; i < sizeof radii / sizeof radii[0]; i++) {
        const taut_pipe_problem problem = straight(radii[i][0], radii[i][1]);
        taut_model *model = pipe_made(&problem, 1e-6);
        taut_certificate *certificate = NULL;
        double least[2];
        least_of(radii[i][0], radii[i][1], least);
        const taut_claim *regular = claim_with(model, &problem, "regular", &certificate);
        const taut_claim *graph = claim_of(certificate, "graph");
        CHECK(regular->kind == TAUT_BOUND && graph->kind == TAUT_BOUND &&
                  claim_of(certificate, "tube")->kind == TAUT_BOUND,
              "%zu: proved", i);
        CHECK(regular->holds == TAUT_TRUE && graph->holds == TAUT_TRUE, "%zu", i);
        /* at 257 places of t: off by what curves within 1/512, below 1e-4 */
        CHECK_NEAR(regular->residual, least[0], 1e-4, "%zu", i);
        CHECK_NEAR(graph->residual, least[1], 1e-4, "%zu", i);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

/* The same axis with radii that it has no such surface of. */
static void test_false(void)
{
    /* not real: r_s = 1.2; a crease: 1 - r r_ss < 0 at t = 1; real, regular, just so or just not */
    static const struct {
        double radii[2];
        taut_verdict regular, graph;
    } rows[] = {{{2.5, 0.1}, TAUT_FALSE, TAUT_FALSE},
                {{3, 1.3}, TAUT_FALSE, TAUT_UNDECIDED},
                {{1.5, 0.75}, TAUT_TRUE, TAUT_TRUE}};
    const taut_pipe_problem made = straight(0.8, 0.3);
    taut_model *model = pipe_made(&made, 1e-6);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const taut_pipe_problem other = straight(rows[i].radii[0], rows[i].radii[1]);
        taut_certificate *certificate = NULL;
        const taut_claim *regular = claim_with(model, &other, "regular", &certificate);
        CHECK(regular->holds == rows[i].regular, "%zu: regular %d, %g", i, (int)regular->holds,
              regular->residual);
        CHECK(claim_of(certificate, "graph")->holds == rows[i].graph, "%zu: graph %d", i,
              (int)claim_of(certificate, "graph")->holds);
        CHECK(claim_of(certificate, "tube")->holds != TAUT_TRUE, "%zu: tube", i);
        taut_certificate_free(certificate);
    }
    taut_model_free(model);
}

/* r r_ss = 1 at t = 0 where r_0 (r_1 - r_0) = 3 / 2: a hair on either side is told apart. */
static void test_verge(void)
{
    const taut_pipe_problem made = straight(0.8, 0.3);
    taut_model *model = pipe_made(&made, 1e-6);
    for (int side = -1; side <= 1; side += 2) {
        const taut_pipe_problem other = straight(2, 2.75 * (1 + side * 1e-5));
        taut_certificate *certificate = NULL;
        const taut_claim *regular = claim_with(model, &other, "regular", &certificate);
        CHECK((regular->holds == TAUT_TRUE) == (side < 0) && regular->holds != TAUT_UNDECIDED,
              "side %d: %d, %g", side, (int)regular->holds, regular->residual);
        taut_certificate_free(certificate);
    }
    taut_model_free(model);
}

/* How far a point is from the surface at most, over the larger radius: the spheres or circles at 400
 * places of the axis, then around the best by thirds. */
static double miss_of(const taut_pipe_problem *problem, const taut_curve *axis, const double x[3])
{
    const double *radii = problem->section.radii;
    const int canal = problem->section.kind == TAUT_PIPE_CANAL;
    double lo = 0, hi = 1, value[2];
    for (int round = 0; round < 40; round++) {
        const int places = round == 0 ? 400 : 8;
        double best = INFINITY, at = lo;
        for (int i = 0; i <= places; i++) {
            const double t = lo + (hi - lo) * i / places;
            double p[3];
            taut_curve_eval(axis, t, 0, p);
            const double r = radii[0] + (radii[1] - radii[0]) * t * t * (3 - 2 * t);
            const double apart = taut_distance(x, p) - (canal ? r : 0);
            at = apart < best ? t : at;
            best = fmin(best, apart);
            value[0] = best;
            value[1] = at;
        }
        const double step = (hi - lo) / places;
        lo = fmax(0, at - step);
        hi = fmin(1, at + step);
    }
    const double t = value[1];
    const double r = radii[0] + (radii[1] - radii[0]) * t * t * (3 - 2 * t);
    return fabs(canal ? value[0] : value[0] - r) / fmax(radii[0], radii[1]);
}

static const taut_surface *blend_of(const taut_model *model)
{
    const taut_surface *s = taut_model_surface(model, 0);
    for (int i = 1; i < taut_model_surface_count(model); i++) {
        s = strcmp(taut_surface_name(s), "blend") == 0 ? s : taut_model_surface(model, i);
    }
    return s;
}

/* The bound of `tube` is above what is found between the places it looks at, and near it. */
static void compare_tube(const taut_model *model, const taut_pipe_problem *problem, int trial)
{
    const taut_certify_options options = {.tolerance = 1e-4};
    taut_certificate *certificate = NULL;
    CHECK(taut_pipe_certify(model, problem, &options, &certificate, NULL) == TAUT_OK, "proved");
    const taut_claim *tube = claim_of(certificate, "tube");
    const taut_surface *blend = blend_of(model);
    double worst = 0;
    for (int i = 0; i < 2000; i++) {
        double x[3];
        taut_surface_eval(blend, random_in(0, 1), random_in(0, 1), 0, x);
        worst = fmax(worst, miss_of(problem, taut_model_curve(model, 0), x));
    }
    CHECK(tube->holds == TAUT_TRUE && tube->kind == TAUT_BOUND, "trial %d: %d", trial,
          (int)tube->holds);
    CHECK(worst <= tube->residual && worst > 0.8 * tube->residual, "trial %d: %g, told %g", trial,
          worst, tube->residual);
    taut_certificate_free(certificate);
}

static void test_tube(void)
{
    for (int trial = 0; trial < random_trials(8); trial++) {
        taut_pipe_problem problem = pipe_random_ends();
        problem.section.kind = trial % 2 ? TAUT_PIPE_CANAL : TAUT_PIPE_NAIVE_SWEEP;
        problem.section.radii[0] = random_in(0.1, 0.5);
        problem.section.radii[1] = random_in(0.1, 0.5);
        taut_model *model = pipe_made(&problem, 1e-4);
        compare_tube(model, &problem, trial);
        taut_model_free(model);
    }
}

/* A copy with one ring of the blend, or one point of it, moved, and about the z axis made wider. */
static taut_model *moved_ring(const taut_model *model, int only, const double by[3], double wider)
{
    static edit_model edit;
    forge_pool pool = {malloc((size_t)1 << 20), (size_t)1 << 20, 0};
    edit_open(model, "pipe", &pool, &edit);
    edit_surface *s = &edit.surface[0];
    for (int i = 0; i < edit.surfaces; i++) {
        s = strcmp(edit.surface[i].name, "blend") == 0 ? &edit.surface[i] : s;
    }
    for (int j = 0; j < s->nv; j++) {
        for (int k = 0; k < 3 && (only < 0 || j == only); k++) {
            double *const x = &s->points[3 * (s->nu / 2 * s->nv + j) + k];
            *x = *x * (k < 2 ? wider : 1) + by[k];
        }
    }
    taut_model *moved = edit_close(&edit);
    free(pool.bytes);
    return moved;
}

/* A point of the blend moved out by a hundred tolerances; a ring slid along, where circles that are
 * those of the foot are nearer than those that the ring belonged to. */
static void test_moved(void)
{
    static const double out[3] = {1e-4, 0, 0}, along[3] = {0, 0, 5e-5};
    taut_pipe_problem problem = straight(0.8, 0.3);
    for (int naive = 0; naive < 2; naive++) {
        problem.section.kind = naive ? TAUT_PIPE_NAIVE_SWEEP : TAUT_PIPE_CANAL;
        taut_model *model = pipe_made(&problem, 1e-7), *bulge = moved_ring(model, 1, out, 1);
        taut_model *slid = moved_ring(model, -1, along, 1);
        taut_certificate *certificate = NULL;
        CHECK(claim_with(bulge, &problem, "tube", &certificate)->holds == TAUT_FALSE, "naive %d",
              naive);
        compare_tube(slid, &problem, naive);
        taut_certificate_free(certificate);
        taut_model_free(slid);
        taut_model_free(bulge);
        taut_model_free(model);
    }
}

/* A ring of a naive sweep slid along, and as wide as the sweep is there: it is still on it. */
static void test_slid_on(void)
{
    static const double along[3] = {0, 0, 5e-5};
    /* in the middle the radius is 0.55 and its slope 0.25 down */
    const double wider = 1 - 0.25 * along[2] / 0.55;
    const taut_certify_options options = {.tolerance = 2e-6};
    taut_pipe_problem problem = straight(0.8, 0.3);
    problem.section.kind = TAUT_PIPE_NAIVE_SWEEP;
    taut_model *model = pipe_made(&problem, 1e-7);
    for (int on = 0; on < 2; on++) {
        taut_certificate *certificate = NULL;
        taut_model *slid = moved_ring(model, -1, along, on ? wider : 1);
        CHECK(taut_pipe_certify(slid, &problem, &options, &certificate, NULL) == TAUT_OK, "%d", on);
        const taut_claim *tube = claim_of(certificate, "tube");
        CHECK(tube->holds == (on ? TAUT_TRUE : TAUT_FALSE), "%d: %d, %g", on, (int)tube->holds,
              tube->residual);
        taut_certificate_free(certificate);
        taut_model_free(slid);
    }
    taut_model_free(model);
}

/* The least of n . (X - F) / |X - F| at places, X = P + r n, the foot F sought down from P by halving
 * the slope's sign; of real ones only. -1: somewhere it is not real. */
static double least_cosine(const taut_curve *axis, const double radii[2], int places)
{
    double least = INFINITY;
    for (int i = 0; i <= places; i++) {
        const double t = (double)i / places, c = radii[1] - radii[0];
        const double r = radii[0] + c * t * t * (3 - 2 * t), slope = 6 * c * t * (1 - t);
        double d[3][3], tangent[3], u[3], w[3];
        taut_curve_eval(axis, t, 2, d[0]);
        const double speed = taut_norm(d[1]), rate = slope / speed;
        if (!(fabs(rate) < 1)) {
            return -1;
        }
        for (int k = 0; k < 3; k++) {
            tangent[k] = d[1][k] / speed;
        }
        taut_cross(tangent, d[2], w);
        const double size = taut_norm(w);
        for (int k = 0; k < 3; k++) {
            w[k] /= size;
        }
        taut_cross(w, tangent, u);
        for (int j = 0; j < 24; j++) {
            const double phi = 2 * TAUT_PI * j / 24, out = sqrt(1 - rate * rate);
            double n[3], x[3], p[2][3], way[3] = {0, 0, 0};
            for (int k = 0; k < 3; k++) {
                n[k] = -rate * tangent[k] + out * (cos(phi) * u[k] + sin(phi) * w[k]);
                x[k] = d[0][k] + r * n[k];
            }
            double at = t;
            const double step = slope > 0 ? -1.0 / places : 1.0 / places;
            for (int k = 0; k <= places && at >= 0 && at <= 1; k++) { /* on as long as it falls */
                taut_curve_eval(axis, at, 1, p[0]);
                taut_difference(x, p[0], way);
                if (!(taut_dot(way, p[1]) * step > 0)) {
                    break;
                }
                at += step;
            }
            taut_add_scaled(-taut_dot(way, p[1]) / taut_dot(p[1], p[1]), p[1], way);
            least = fmin(least, taut_dot(n, way) / taut_norm(way));
        }
    }
    return least;
}

/* Radii that the axis of another pipe has no room for, or just so. */
static void test_verdicts(void)
{
    int counts[3] = {0, 0, 0};
    for (int trial = 0; trial < random_trials(60); trial++) {
        taut_pipe_problem problem = pipe_random_ends();
        problem.section.kind = TAUT_PIPE_CANAL;
        problem.section.radii[0] = problem.section.radii[1] = 0.2;
        problem.section.radii[1] = 0.21;
        taut_model *model = pipe_made(&problem, 1e-4);
        taut_certificate *certificate = NULL;
        problem.section.radii[0] = random_in(0.2, 1.5);
        problem.section.radii[1] = problem.section.radii[0] * random_in(1.2, 4);
        const taut_claim *graph = claim_with(model, &problem, "graph", &certificate);
        const double least = least_cosine(taut_model_curve(model, 0), problem.section.radii,
                                          graph->holds == TAUT_FALSE ? 2000 : 400);
        CHECK(graph->holds != TAUT_TRUE || least > 0, "trial %d: %g", trial, least);
        CHECK(graph->holds != TAUT_FALSE || least < 0.02, "trial %d: %g", trial, least);
        if (graph->holds != TAUT_UNDECIDED ||
            claim_of(certificate, "regular")->holds == TAUT_TRUE) {
            counts[(int)graph->holds]++;
        }
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
    /* and what no bound reaches is open */
    CHECK(counts[TAUT_TRUE] > 0 && counts[TAUT_FALSE] > 0 && counts[TAUT_UNDECIDED] > 0,
          "%d hold, %d do not", counts[TAUT_TRUE], counts[TAUT_FALSE]);
}

/* The least of 1 - (r_s^2 / c) (1 + r kappa / (2 c)), c = 1 - r kappa, along the axis, by its own
 * derivatives: what proves `graph` is no larger, as it takes the largest kappa near by. */
static double least_of_bound(const taut_curve *axis, const double radii[2])
{
    double least = INFINITY;
    for (int i = 0; i <= 2000; i++) {
        const double t = i / 2000.0, change = radii[1] - radii[0];
        const double r = radii[0] + change * t * t * (3 - 2 * t);
        double d[3][3], across[3];
        CHECK(taut_curve_eval(axis, t, 2, d[0]) == TAUT_OK, "%g", t);
        const double speed = taut_norm(d[1]), slope = change * 6 * t * (1 - t) / speed;
        taut_cross(d[1], d[2], across);
        const double bent = r * taut_norm(across) / (speed * speed * speed), c = 1 - bent;
        least = fmin(least, c > 0 ? 1 - slope * slope / c * (1 + bent / (2 * c)) : -INFINITY);
    }
    return least;
}

/* Of one bend, radii that the bound of `graph` has room for, and radii that it has not though the
 * normals that are seen look away from the axis, and the bound would be met without its last term. */
static void test_graph(void)
{
    static const double radii[2][2] = {{2.76, 3.2}, {2.76, 5.76}};
    for (int i = 0; i < 2; i++) {
        taut_pipe_problem problem = {
            .axis = {.kind = TAUT_PIPE_ENDS,
                     .ends = {{{0, 0, 0}, {1, 0, 0}, 5}, {{8, 8, 0}, {0, 1, 0}, 5}}},
            .section = {.kind = TAUT_PIPE_CANAL, .radii = {radii[i][0], radii[i][1]}}};
        taut_model *model = pipe_made(&problem, 1e-3);
        taut_certificate *certificate = NULL;
        const taut_claim *graph = claim_with(model, &problem, "graph", &certificate);
        const double least = least_of_bound(taut_model_curve(model, 0), radii[i]);
        CHECK(graph->residual > 0.5 && (least > 0) == (i == 0), "%d: %g, %g", i, graph->residual,
              least);
        CHECK(graph->holds == (i == 0 ? TAUT_TRUE : TAUT_UNDECIDED), "%d: %d", i,
              (int)graph->holds);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

int main(void)
{
    random_seed(20261201);
    test_straight();
    test_false();
    test_graph();
    test_verge();
    test_tube();
    test_moved();
    test_slid_on();
    test_verdicts();
    return check_failures != 0;
}
