/* test_fit.c -- the error a pipe's certificate states is none below what is there: against
 * samples eight times as dense, with the axis sought from the curve alone. */
#include "certificates.h"
#include "check.h"

#include "core/vec3.h"
#include "taut/taut.h"

#include <string.h>

enum { DENSE = 48, AROUND = 240 };

/* The distance of x from the curve, sought from parameter t. */
static double distance_from(const taut_curve *curve, const double x[3], double t)
{
    double d[3][3], apart[3];
    for (int i = 0; i < 8; i++) {
        taut_curve_eval(curve, t, 2, d[0]);
        taut_difference(d[0], x, apart);
        t -= taut_dot(apart, d[1]) / (taut_dot(d[1], d[1]) + taut_dot(apart, d[2]));
        t = fmin(1, fmax(0, t));
    }
    taut_curve_eval(curve, t, 0, d[0]);
    return taut_distance(d[0], x);
}

/* The largest | distance - radius | / radius seen on the blend. */
static double error_of(const taut_model *model, double radius)
{
    const taut_surface *blend = taut_model_surface(model, 0);
    const taut_basis *u = taut_surface_u(blend);
    double most = 0;
    for (int i = 0; i < taut_basis_span_count(u); i++) {
        const double lo = taut_basis_breaks(u)[i], hi = taut_basis_breaks(u)[i + 1];
        for (int k = 0; k < DENSE * AROUND; k++) {
            const double t = lo + (hi - lo) * ((k / AROUND) + 0.5) / DENSE;
            double x[3];
            taut_surface_eval(blend, t, (k % AROUND + 0.5) / AROUND, 0, x);
            most =
                fmax(most, fabs(distance_from(taut_model_curve(model, 0), x, t) - radius) / radius);
        }
    }
    return most;
}

static void test_error(void)
{
    double least = INFINITY, largest = 0;
    for (int trial = 0; trial < random_trials(14); trial++) {
        taut_pipe_problem problem = {.axis = {.kind = TAUT_PIPE_ENDS},
                                     .section = {.radius = random_in(0.02, 0.3)}};
        const taut_make_options options = {.tolerance = random_log(1e-5, 1e-3)};
        const taut_certify_options proof = {.tolerance = options.tolerance};
        taut_model *model = NULL;
        taut_certificate *certificate = NULL;
        for (int side = 0; side < 2; side++) {
            for (int k = 0; k < 3; k++) {
                problem.axis.ends[side].point[k] = random_in(-1, 1);
                problem.axis.ends[side].direction[k] = random_in(-1, 1);
            }
            problem.axis.ends[side].handle = random_in(0.5, 2);
        }
        problem.joint = trial % 2 == 0 ? TAUT_PIPE_G1 : TAUT_PIPE_G2;
        if (taut_pipe_make(&problem, &options, &model, NULL) != TAUT_OK) {
            continue; /* too sharp */
        }
        CHECK(taut_pipe_certify(model, &problem, &proof, &certificate, NULL) == TAUT_OK, "proof");
        const double found = error_of(model, problem.section.radius);
        const double told =
            taut_record_number(taut_record_get(taut_certificate_figures(certificate), "fit_error"));
        CHECK(found <= told, "trial %d: found %.6g, told %.6g", trial, found, told);
        CHECK(told <= options.tolerance, "trial %d: told %.6g", trial, told);
        least = fmin(least, found / told);
        largest = fmax(largest, found / told);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
    CHECK(least > 0.75 && largest > 0.9, "found %.3g to %.3g of what is told", least, largest);
}

int main(void)
{
    random_seed(20261128);
    test_error();
    return check_failures != 0;
}
