/* test_pipe.c -- construct `pipe` through its public header: rings and normals at the joints,
 * degenerate geometry, refusals. */
#include "certificates.h"
#include "check.h"
#include "monitors.h"
#include "pipes.h"

#include "core/vec3.h"
#include "taut/taut.h"

#include <stdlib.h>
#include <string.h>

static taut_pipe_problem paper(double alpha, double beta, double gamma)
{
    const taut_pipe_problem problem = {
        .axis = {.polygon = {{5, 0, 0}, {5, 2, 0}, {0, 6, 0}, {0, 6, 3}}},
        .section = {.radius = 1},
        .shape = {.alpha = alpha, .beta = beta, .gamma = gamma},
    };
    return problem;
}

static taut_pipe_problem planar(const double polygon[4][3], double radius)
{
    taut_pipe_problem problem = {.section = {.radius = radius}};
    memcpy(problem.axis.polygon, polygon, sizeof problem.axis.polygon);
    return problem;
}

/* Made and proved: its certificate, or NULL with a failure told. */
static taut_certificate *proved(const taut_pipe_problem *problem, const char *name,
                                taut_model **model)
{
    taut_error error = {.message = ""};
    taut_certificate *certificate = NULL;
    const taut_status status = taut_pipe_make(problem, NULL, model, &error);
    CHECK(status == TAUT_OK, "%s: %s %s", name, error.where, error.message);
    if (status == TAUT_OK) {
        CHECK(taut_pipe_certify(*model, problem, NULL, &certificate, &error) == TAUT_OK, "%s: %s",
              name, error.message);
        for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
            const taut_claim *claim = taut_certificate_claim(certificate, i);
            CHECK(claim->holds == TAUT_TRUE && claim->residual <= claim->limit,
                  "%s: %s %g, limit %g, %s", name, claim->claim, claim->residual, claim->limit,
                  claim->where);
        }
    }
    return certificate;
}

/* Must be refused for this reason, and *model untouched. */
static taut_error refused(const taut_pipe_problem *problem, taut_status wanted, const char *reason)
{
    taut_error error = {.message = ""};
    taut_model *model = NULL;
    const taut_status status = taut_pipe_make(problem, NULL, &model, &error);
    CHECK(status == wanted && model == NULL, "%s: %s: %s", reason, taut_status_text(status),
          error.message);
    CHECK(strcmp(error.reason, reason) == 0, "%s: %s: %s", reason, error.reason, error.message);
    taut_model_free(model);
    return error;
}

/* Rings on the cylinders and normals radial to 1e-14; pipe1.u1 is blend.u0 point by point. */
static void test_joints(void)
{
    taut_pipe_problem problem = paper(1, 2, 1);
    taut_model *model = NULL;
    taut_certificate *certificate = proved(&problem, "paper", &model);
    const taut_surface *blend = taut_model_surface(model, 0);
    for (int side = 0; side < 2; side++) {
        const double *joint = problem.axis.polygon[side == 0 ? 0 : 3];
        const taut_surface *pipe = taut_model_surface(model, 1 + side);
        CHECK(strcmp(taut_surface_name(pipe), side == 0 ? "pipe1" : "pipe2") == 0, "names");
        for (int k = 0; k <= 64; k++) {
            double a[3][3], b[3][3], radial[3], normal[3], across[3];
            taut_surface_eval(blend, side, k / 64.0, 1, a[0]);
            taut_surface_eval(pipe, 1 - side, k / 64.0, 1, b[0]);
            taut_difference(a[0], joint, radial);
            taut_cross(a[TAUT_XU], a[TAUT_XV], normal);
            taut_cross(radial, normal, across);
            CHECK_NEAR(taut_norm(radial), 1, 1e-14, "ring %d at %d", side, k);
            CHECK(fabs(radial[side == 0 ? 1 : 2]) < 1e-14, "ring %d at %d in its plane", side, k);
            CHECK(taut_norm(across) / taut_norm(normal) < 1e-14, "normal %d at %d: %g", side, k,
                  taut_norm(across) / taut_norm(normal));
            CHECK(taut_distance(a[0], b[0]) <= 4e-15, "gap %d at %d", side, k);
        }
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
}

/* [WangBai2018] section 3.3. */
static void test_degenerate_geometry(void)
{
    static const double line[4][3] = {{0, 0, 0}, {1, 2, 2}, {2, 4, 4}, {4, 8, 8}};
    static const double offset[4][3] = {{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {12, 4, 0}};
    static const double elbow[4][3] = {{0, 0, 0}, {5, 0, 0}, {5, 0, 0}, {5, 5, 0}};
    static const double parallel[4][3] = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {4, 2, 0}};
    static const double uturn[4][3] = {{0, 0, 0}, {4, 0, 0}, {4, 6, 0}, {0, 6, 0}};
    static const struct {
        const char *name;
        const double (*polygon)[3];
        double curvature[2]; /* at the ends; -1: not 0 */
    } cases[] = {{"line", line, {0, 0}},
                 {"offset", offset, {-1, -1}},
                 {"elbow", elbow, {0, 0}},
                 {"parallel edges", parallel, {0, -1}},
                 {"turn back", uturn, {-1, -1}}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const taut_pipe_problem problem = planar(cases[i].polygon, 0.5);
        taut_model *model = NULL;
        taut_certificate *certificate = proved(&problem, cases[i].name, &model);
        const taut_record *ends =
            taut_record_get(taut_certificate_figures(certificate), "joint_curvature");
        for (int side = 0; side < 2; side++) {
            const double found = taut_record_number(taut_record_at(ends, (size_t)side));
            CHECK(cases[i].curvature[side] < 0 ? found > 0.01 : fabs(found) < 1e-15, "%s: %g",
                  cases[i].name, found);
        }
        CHECK(fabs(figure_of(certificate, "total_torsion")) < 1e-13, "%s is plane", cases[i].name);
        if (i == 0) {
            CHECK_NEAR(figure_of(certificate, "length"), 12, 1e-13, "line");
            CHECK(taut_record_kind_of(taut_record_get(taut_certificate_figures(certificate),
                                                      "largest_radius")) == TAUT_RECORD_NULL,
                  "a line takes any radius");
        }
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

static void test_refusals(void)
{
    static const double cusp[4][3] = {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}};
    static const double offset[4][3] = {{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {12, 4, 0}};
    static const double line[4][3] = {{0, 0, 0}, {1, 2, 2}, {2, 4, 4}, {4, 8, 8}};
    static const double uturn[4][3] = {{0, 0, 0}, {40, 0, 0}, {40, 6, 0}, {0, 6, 0}};
    taut_pipe_problem problem = paper(0, 0, 0);
    problem.axis.polygon[1][1] = 0;
    (void)refused(&problem, TAUT_NO_SOLUTION, "degenerate-edge");
    problem = paper(0, 0, 0);
    problem.lengths[1] = 1e-20;
    (void)refused(&problem, TAUT_NO_SOLUTION, "too-small");
    problem = paper(3, 2, 1);
    (void)refused(&problem, TAUT_NO_SOLUTION, "parameter-domain");
    problem = paper(0, -3.5, 0);
    (void)refused(&problem, TAUT_NO_SOLUTION, "parameter-domain");
    problem = paper(0, 0, 1.5);
    (void)refused(&problem, TAUT_NO_SOLUTION, "parameter-domain");
    problem = paper(-3, 0, 0);
    (void)refused(&problem, TAUT_NO_SOLUTION, "tangent-lost");
    problem = paper(0, 0, -4);
    problem.shape.extended = 1;
    (void)refused(&problem, TAUT_NO_SOLUTION, "tangent-lost");
    problem = planar(cusp, 0.01);
    (void)refused(&problem, TAUT_NO_SOLUTION, "not-regular");
    problem = paper(0, 0, 0);
    problem.section.radius = 1.3;
    const taut_error local = refused(&problem, TAUT_NO_SOLUTION, "self-intersect-local");
    CHECK_NEAR(local.limit, 1.2, 1e-9, "1 / 0.8333333333"); /* [WangBai2018] section 6 */
    problem = planar(uturn, 3.5);
    problem.shape.alpha = problem.shape.gamma = 1;
    problem.section.radius = 3.2;
    const taut_error both = refused(&problem, TAUT_NO_SOLUTION, "self-intersect-local");
    CHECK(both.limit <= 3 + 1e-12, "two half lines 6 apart: %g", both.limit);
    problem = planar(offset, 0.5);
    problem.frame = TAUT_PIPE_FRENET;
    (void)refused(&problem, TAUT_NO_SOLUTION, "frenet-undefined");
    problem = planar(line, 0.5);
    problem.frame = TAUT_PIPE_FRENET;
    (void)refused(&problem, TAUT_NO_SOLUTION, "frenet-undefined");
    problem = (taut_pipe_problem){
        .axis = {.kind = TAUT_PIPE_FEET,
                 .ends = {{{0, 0, 0}, {1, 0, 0}, 1}, {{0, 9, 0}, {-2, 0, 0}, 1}}},
        .section = {.radius = 1}};
    (void)refused(&problem, TAUT_NO_SOLUTION, "parallel-axes");
}

/* Two axes that cross at a distance of 1, far from the blend's own bends. */
static void test_global_refusal(void)
{
    taut_pipe_problem problem = {
        .axis = {.polygon = {{0, 0, 0}, {30, 0, 0}, {0, 30, 1}, {0, -30, 1}}},
        .section = {.radius = 1},
    };
    const taut_error error = refused(&problem, TAUT_NO_SOLUTION, "self-intersect-global");
    taut_model *model = NULL;
    CHECK(error.limit < 1 && error.limit > 0, "%g", error.limit);
    problem.section.radius = 0.99 * error.limit;
    taut_certificate *certificate = proved(&problem, "below the limit", &model);
    CHECK_NEAR(figure_of(certificate, "largest_radius"), error.limit, 1e-9 * error.limit, "both");
    taut_certificate_free(certificate);
    taut_model_free(model);
}

static void test_bad_numbers(void)
{
    const double bad[] = {0, -1, (double)NAN, (double)INFINITY, 1e-200, 1e200};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        taut_pipe_problem problem = paper(0, 0, 0);
        problem.section.radius = bad[i];
        (void)refused(&problem, TAUT_BAD_INPUT, "value");
        problem = paper(0, 0, 0);
        problem.lengths[1] = bad[i];
        if (bad[i] != 0) {
            (void)refused(&problem, TAUT_BAD_INPUT, "value");
        }
    }
    taut_pipe_problem problem = paper(0, 0, (double)NAN);
    (void)refused(&problem, TAUT_BAD_INPUT, "value");
    problem = paper(0, 0, 0);
    problem.axis.polygon[2][1] = (double)NAN;
    (void)refused(&problem, TAUT_BAD_INPUT, "value");
    problem.axis = (taut_pipe_axis){.kind = TAUT_PIPE_ENDS};
    problem.axis.ends[0].direction[0] = 1;
    (void)refused(&problem, TAUT_BAD_INPUT, "value");
    problem.axis.ends[1].direction[0] = (double)INFINITY;
    (void)refused(&problem, TAUT_BAD_INPUT, "value");
    problem.axis.ends[1].direction[0] = 1;
    problem.axis.ends[0].handle = -1;
    (void)refused(&problem, TAUT_BAD_INPUT, "value");
    for (int choice = 0; choice < 5; choice++) {
        problem = paper(0, 0, 0);
        problem.axis.kind = (taut_pipe_axis_kind)(choice == 0 ? TAUT_PIPE_FEET + 1 : 0);
        problem.shape.kind =
            (taut_pipe_shape_kind)(choice == 1 ? TAUT_PIPE_LEAST_CURVATURE + 1 : 0);
        problem.frame = (taut_pipe_frame)(choice == 2 ? TAUT_PIPE_FRENET + 1 : 0);
        problem.joint = (taut_pipe_joint)(choice == 3 ? TAUT_PIPE_G2 + 1 : 0);
        problem.section.kind =
            (taut_pipe_section_kind)(choice == 4 ? TAUT_PIPE_NAIVE_SWEEP + 1 : 0);
        (void)refused(&problem, TAUT_BAD_INPUT, "value");
    }
    taut_model *model = NULL;
    const taut_make_options options = {.tolerance = 1e-15};
    problem = paper(0, 0, 0);
    CHECK(taut_pipe_make(&problem, &options, &model, NULL) == TAUT_BAD_ARGUMENT, "tolerance");
    CHECK(taut_pipe_make(NULL, NULL, &model, NULL) == TAUT_BAD_ARGUMENT, "NULL");
}

/* Frames, tolerances, lengths, handles: each made and proved. */
static void test_choices(void)
{
    taut_pipe_problem problem = paper(1, 3, 1);
    taut_model *model = NULL;
    problem.frame = TAUT_PIPE_FRENET;
    problem.lengths[0] = 7;
    taut_certificate *certificate = proved(&problem, "frenet", &model);
    taut_certificate_free(certificate);
    certificate = NULL;
    /* from the model alone */
    CHECK(taut_pipe_certify(model, NULL, NULL, &certificate, NULL) == TAUT_OK &&
              taut_certificate_holds(certificate) == TAUT_TRUE,
          "without the problem");
    taut_certificate_free(certificate);
    taut_model_free(model);

    /* Frenet's frame turning fast at the joint: x_u nearly along the ring */
    problem = paper(1, 0, 1);
    problem.axis.polygon[2][1] = 1e-7;
    problem.axis.polygon[2][2] = 0;
    problem.frame = TAUT_PIPE_FRENET;
    problem.section.radius = 0.5;
    certificate = proved(&problem, "twisted frenet", &model);
    taut_certificate_free(certificate);
    taut_model_free(model);

    problem = (taut_pipe_problem){
        .axis = {.kind = TAUT_PIPE_FEET,
                 .ends = {{{0, 0, 0}, {1, 0, 0}, 0}, {{0, 0, 3}, {0, 1, 0}, 0}}},
        .section = {.radius = 1},
    };
    certificate = proved(&problem, "feet", &model);
    /* the shortest equal handles with a largest radius of three radii */
    CHECK_NEAR(figure_of(certificate, "largest_radius"), 3, 1e-5, "long-radius elbow");
    const double *points = taut_curve_points(taut_model_curve(model, 0));
    CHECK(points[3] == 0 && points[4] == 0 && points[6] == 0 && points[8] == 3, "the feet");
    CHECK(points[0] == -points[10], "equal handles");
    taut_certificate_free(certificate);
    taut_model_free(model);

    problem.bend_radius = 12; /* wider than three radii: the shortest that bends no more sharply */
    certificate = proved(&problem, "feet and a bend radius", &model);
    CHECK(figure_of(certificate, "max_curvature") <= 1.0 / 12, "too sharp");
    CHECK_NEAR(figure_of(certificate, "max_curvature"), 1.0 / 12, 1e-6,
               "no longer than it has to be");
    taut_certificate_free(certificate);
    taut_model_free(model);

    problem = (taut_pipe_problem){
        .axis = {.kind = TAUT_PIPE_ENDS,
                 .ends = {{{0, 0, 0}, {2, 0, 0}, 0}, {{9, 0, 0}, {3, 0, 0}, 0}}},
        .section = {.radius = 1},
        .shape = {.kind = TAUT_PIPE_LEAST_BENDING},
    };
    certificate = proved(&problem, "straight on", &model);
    points = taut_curve_points(taut_model_curve(model, 0));
    CHECK_NEAR(points[3], 3, 1e-14, "a third of the way");
    CHECK(figure_of(certificate, "max_curvature") == 0, "straight");
    taut_certificate_free(certificate);
    taut_model_free(model);
}

/* The least of a largest curvature lies in creases, where it is reached at two places at once.
 * 0.9332925 is the minimum by sequential linear programming over the curvatures at 20001 places; a
 * search that stops in a crease stays 2e-3 above. */
static void test_least_largest_curvature(void)
{
    const double polygon[4][3] = {
        {3.1, 4.2, -4.8}, {-1.3, -4.5, 2.5}, {-1.5, 4.6, -1.3}, {2.7, 3.7, -2.6}};
    taut_pipe_problem problem = planar(polygon, 0.01);
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    problem.shape.kind = TAUT_PIPE_LEAST_CURVATURE;
    certificate = proved(&problem, "least largest curvature", &model);
    CHECK_NEAR(figure_of(certificate, "max_curvature"), 0.9332925, 2e-4, "least largest curvature");
    taut_certificate_free(certificate);
    taut_model_free(model);
}

/* A tube that bends within 1e-10 of its length cannot be as near as asked for; it is made where as
 * little is asked as the message advises. */
static void test_too_fine(void)
{
    const double polygon[4][3] = {{0, 0, 0}, {1, 1, 1e-5}, {0, 1, 0}, {1, 0, 0}}; /* near a cusp */
    const taut_pipe_problem problem = planar(polygon, 1e-13);
    taut_make_options options = {.tolerance = 1e-12};
    taut_model *model = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_pipe_make(&problem, &options, &model, &error) == TAUT_NO_SOLUTION && model == NULL,
          "made");
    CHECK(strcmp(error.reason, "too-fine") == 0 && error.found == 1e-12, "%s", error.message);
    options.tolerance = 1e-9;
    CHECK(taut_pipe_make(&problem, &options, &model, &error) == TAUT_OK, "%s", error.message);
    taut_model_free(model);
}

/* Stopped at report k: at once, with nothing left. */
static void check_stop(const taut_pipe_problem *blend, const taut_pipe_run_problem *run, int k)
{
    watch stop = {.stop_at = k};
    const taut_make_options options = {.monitor = monitor_of(&stop)};
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    const taut_status status = blend != NULL ? taut_pipe_make(blend, &options, &model, &error)
                                             : taut_pipe_run_make(run, &options, &model, &error);
    CHECK(status == TAUT_INTERRUPTED && strcmp(error.reason, "interrupted") == 0 && model == NULL,
          "report %d: %s", k, error.message);
    CHECK(stop.reports == k, "%d reports, stopped at %d", stop.reports, k);
}

/* A report before each axis that is tried, which is a bounded piece of work; the model is the same with
 * a monitor and without. */
static void test_monitor(void)
{
    static const double corners[4][3] = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {9, 9, 9}};
    const taut_pipe_run_problem run = {
        .route = {.kind = TAUT_PIPE_CORNERS, .count = 4, .corners = corners[0]},
        .radius = 0.5,
        .shape = {.kind = TAUT_PIPE_LEAST_BENDING}};
    taut_pipe_problem blend = pipe_random_ends();
    watch all = {.stop_at = 0}, all_run = {.stop_at = 0};
    const taut_make_options options = {.monitor = monitor_of(&all)};
    const taut_make_options options_run = {.monitor = monitor_of(&all_run)};
    taut_model *model = NULL, *plain = NULL;

    blend.section.radius = 0.01;
    blend.shape.kind = TAUT_PIPE_LEAST_BENDING;
    blend.axis.ends[0].handle = 0; /* this one is chosen, too */
    CHECK(taut_pipe_make(&blend, &options, &model, NULL) == TAUT_OK, "blend");
    CHECK(taut_pipe_make(&blend, NULL, &plain, NULL) == TAUT_OK, "blend");
    const taut_record *details = taut_model_details(model);
    const double evaluations = taut_record_number(taut_record_get(details, "evaluations"));
    CHECK(evaluations > 500 && all.reports > evaluations, "%d reports, %g evaluations", all.reports,
          evaluations);
    const taut_surface *a = taut_model_surface(model, 0), *b = taut_model_surface(plain, 0);
    CHECK(memcmp(taut_surface_points(a), taut_surface_points(b),
                 3 * sizeof(double) * (size_t)taut_basis_count(taut_surface_u(a)) *
                     (size_t)taut_basis_count(taut_surface_v(a))) == 0,
          "the monitor changes nothing");
    taut_model_free(model);
    taut_model_free(plain);
    for (int k = 1; k <= all.reports; k += 1 + all.reports / 3) {
        check_stop(&blend, NULL, k);
    }
    check_stop(&blend, NULL, all.reports);
    model = NULL;
    CHECK(taut_pipe_run_make(&run, &options_run, &model, NULL) == TAUT_OK, "run");
    taut_model_free(model);
    for (int k = 1; k <= all_run.reports; k += 1 + all_run.reports / 2) {
        check_stop(NULL, &run, k);
    }
    check_stop(NULL, &run, all_run.reports);
}

int main(void)
{
    test_monitor();
    test_joints();
    test_degenerate_geometry();
    test_refusals();
    test_global_refusal();
    test_bad_numbers();
    test_choices();
    test_least_largest_curvature();
    test_too_fine();
    return check_failures != 0;
}
