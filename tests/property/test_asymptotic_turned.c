/* test_asymptotic_turned.c -- corner data turned at random, in any unit and far away: nothing is a
 * decimal, no coefficient is exactly zero, and the same quadrilateral comes out.
 */
#include "asymptotic.h"
#include "certificates.h"
#include "check.h"

#include <stdio.h>
#include <string.h>

/* x -> Q x for a random rotation Q, from a unit quaternion. */
static void random_rotation(double q[3][3])
{
    double h[4], size = 0.0;
    for (int k = 0; k < 4; k++) {
        h[k] = random_in(-1, 1);
        size += h[k] * h[k];
    }
    for (int i = 0; i < 3; i++) { /* (h0^2 - h.h) I + 2 h h' + 2 h0 [h]x */
        const int a = (i + 1) % 3, b = (i + 2) % 3;
        const double *const v = h + 1;
        q[i][i] = (h[0] * h[0] + v[i] * v[i] - v[a] * v[a] - v[b] * v[b]) / size;
        q[i][a] = 2 * (v[i] * v[a] - h[0] * v[b]) / size;
        q[i][b] = 2 * (v[i] * v[b] + h[0] * v[a]) / size;
    }
}

/* x -> s Q x + t of corner data. */
static taut_asymptotic_problem similar(const taut_asymptotic_problem *problem, double s,
                                       double q[3][3], double shift)
{
    taut_asymptotic_problem image = *problem;
    for (int e = 0; e < 4; e++) {
        for (int i = 0; i < 3; i++) {
            const double *const p = problem->corners.points[e], *const q_i = q[i];
            image.corners.points[e][i] =
                s * (q_i[0] * p[0] + q_i[1] * p[1] + q_i[2] * p[2]) + shift;
            for (int k = 0; k < 2; k++) {
                const double *const leg = problem->corners.edges[e].legs[k];
                image.corners.edges[e].legs[k][i] =
                    s * (q_i[0] * leg[0] + q_i[1] * leg[1] + q_i[2] * leg[2]);
            }
        }
        for (int k = 0; k < 2; k++) {
            image.corners.edges[e].curvature[k] /= s;
        }
    }
    return image;
}

/* The examples turned at random and in any unit: the same energies, and claims that hold. Turned,
 * no coordinate is a decimal and no coefficient exactly zero. */
static void test_turned_units(void)
{
    static const double units[3] = {1e3, 1e18, 1e-18};
    for (int number = 1; number <= 7; number++) {
        taut_asymptotic_problem problem = asymptotic_example(number < 7 ? number : 1, NULL);
        taut_model *model = NULL;
        double curves = 0.0, plate = 0.0;
        problem.surface = number == 7 ? TAUT_BIDEGREE_N_PLUS_3 : TAUT_BIDEGREE_5N_MINUS_7;
        problem.report_singular = number == 3;
        if (number == 4) {
            continue; /* a quintic takes long */
        }
        model = asymptotic_make(&problem, "as printed");
        curves = detail_of(model, "curve_energy");
        plate = detail_of(model, "plate_energy");
        taut_model_free(model);
        for (int k = 0; k < random_trials(3); k++) {
            const double s = units[k];
            double q[3][3];
            char what[48];
            taut_asymptotic_problem image;
            random_rotation(q);
            image = similar(&problem, s, q, 0.0);
            (void)snprintf(what, sizeof what, "example %d, unit %g", number, s);
            model = asymptotic_make(&image, what);
            CHECK_NEAR(detail_of(model, "curve_energy") / (s * s) / curves, 1, 1e-13, "%s", what);
            CHECK_NEAR(detail_of(model, "plate_energy") / (s * s) / plate, 1, 1e-12, "%s", what);
            if (number == 3 || number == 6) { /* R_u is 0 inside the latter */
                asymptotic_check_claims_or_fold(model, &image, what);
            } else {
                asymptotic_check_claims(model, &image, what);
            }
            taut_model_free(model);
        }
    }
}

/* The examples turned at random and 1e6 away, where coordinates have lost six digits: what the
 * data meets exactly it still meets to rounding, and all that follows is found to as much. */
static void test_turned_far(void)
{
    for (int number = 1; number <= 6; number++) {
        taut_asymptotic_problem problem = asymptotic_example(number, NULL), image;
        taut_certificate *certificate = NULL;
        taut_model *model = NULL;
        double curves = 0.0, q[3][3];
        char what[48];
        problem.report_singular = number == 3;
        if (number == 4) {
            continue; /* a quintic takes long */
        }
        model = asymptotic_make(&problem, "as printed");
        curves = detail_of(model, "curve_energy");
        taut_model_free(model);
        random_rotation(q);
        image = similar(&problem, 1.0, q, 1e6);
        (void)snprintf(what, sizeof what, "example %d, far", number);
        model = asymptotic_make(&image, what);
        CHECK_NEAR(detail_of(model, "curve_energy") / curves, 1, 1e-8, "%s", what);
        certificate = asymptotic_certify(model, &image, what);
        for (int c = 0; c < taut_certificate_claim_count(certificate); c++) {
            const taut_claim *const claim = taut_certificate_claim(certificate, c);
            CHECK(claim->holds != TAUT_FALSE ||
                      ((number == 3 || number == 6) && strcmp(claim->claim, "regular") == 0),
                  "%s: %s %g, limit %g, at %s", what, claim->claim, claim->residual, claim->limit,
                  claim->where);
        }
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

int main(void)
{
    random_seed(2019);
    test_turned_units();
    test_turned_far();
    return check_failures != 0;
}
