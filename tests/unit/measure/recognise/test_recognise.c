/* test_recognise.c -- members of the family, moved, scaled, mirrored and transposed, are told with
 * their scale, lambda and theta; other nets are not. */
#include "check.h"

#include "core/constants.h"
#include "taut/bonnet.h"
#include "taut/operations.h"
#include "taut/recognise.h"

#include <string.h>

static taut_surface *made(const taut_bonnet_problem *p)
{
    taut_model *model = NULL;
    taut_surface *copy = NULL;
    CHECK(taut_bonnet_make(p, NULL, &model, NULL) == TAUT_OK, "makes");
    CHECK(taut_surface_copy(taut_model_surface(model, 0), &copy) == TAUT_OK, "copies");
    taut_model_free(model);
    return copy;
}

/* x -> scale R x + t, R a rotation, or its negative where mirrored. */
static taut_surface *moved(taut_surface *surface, double scale, int mirrored)
{
    double q[4], n = 0, m[3][4];
    taut_surface *result = NULL;
    for (int k = 0; k < 4; k++) {
        q[k] = random_in(-1, 1);
        n += q[k] * q[k];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        m[i][i] = 1 - 2 * (q[j] * q[j] + q[k] * q[k]) / n;
        m[i][j] = 2 * (q[i] * q[j] - q[k] * q[3]) / n;
        m[i][k] = 2 * (q[i] * q[k] + q[j] * q[3]) / n;
        for (int c = 0; c < 3; c++) {
            m[i][c] *= mirrored ? -scale : scale;
        }
        m[i][3] = scale * random_in(-3, 3);
    }
    CHECK(taut_surface_transform(surface, &m[0][0], &result, NULL) == TAUT_OK, "moves");
    taut_surface_free(surface);
    return result;
}

/* The difference of two angles in (-pi, pi]. */
static double turn(double a, double b)
{
    return remainder(a - b, 2 * TAUT_PI);
}

static void test_members(void)
{
    for (int trial = 0; trial < random_trials(400); trial++) {
        const double lambdas[] = {0, random_in(0, 1), 1 - random_log(1e-5, 1)};
        const double thetas[] = {0, 0.5 * TAUT_PI, random_in(-TAUT_PI, TAUT_PI)};
        taut_bonnet_problem p = {.sign = random_int(0, 1) ? 1 : -1,
                                 .alpha = random_in(0.5, 2.5),
                                 .beta = random_in(0.5, 4),
                                 .theta = thetas[random_int(0, 2)],
                                 .bspline = random_int(0, 1),
                                 .start = {random_in(-3, 3), random_in(-3, 1)}};
        const double scale = random_log(1e-3, 1e3);
        const int mirrored = random_int(0, 3) == 0;
        taut_family_member m;
        p.lambda[0] = p.lambda[1] = lambdas[random_int(0, 2)];
        p.normalize = p.lambda[0] < 0.9999 && !p.bspline && random_int(0, 3) == 0;
        p.sign = p.normalize ? -1 : p.sign;
        p.segments[0] = p.segments[1] = p.bspline ? 2 : 1;
        const double w2 = (1 - p.lambda[0]) * (1 + p.lambda[0]);
        const double unit = p.normalize ? 2 / w2 : 1;
        taut_surface *s = moved(made(&p), scale, mirrored);
        const taut_status status = taut_surface_recognise(s, &m, NULL);
        CHECK(status == TAUT_OK, "lambda %.17g theta %g normalize %d", p.lambda[0], p.theta,
              p.normalize);
        if (status == TAUT_OK) {
            /* third derivatives of the net are known to 1e-14 of its size over alpha^3, which
             * grows like 1/w against the curvature */
            const double noise = 1e-12 / w2;
            CHECK_NEAR(m.lambda, p.lambda[0], noise, "trial %d", trial);
            CHECK_NEAR(m.scale / (unit * scale), 1, noise, "trial %d", trial);
            CHECK_NEAR(turn(m.theta, p.theta + (mirrored ? TAUT_PI : 0)), 0, noise, "trial %d",
                       trial);
            CHECK((strcmp(m.name, "helicoid") == 0) ==
                      (p.lambda[0] == 0 && fabs(p.theta) == 0.5 * TAUT_PI),
                  "a %s", m.name);
        }
        taut_surface_free(s);
    }
}

static void test_transposed(void)
{
    const taut_bonnet_problem p = {
        .lambda = {0.3, 0.3}, .sign = 1, .alpha = 2, .beta = 1.5, .theta = 0.25};
    taut_surface *s = moved(made(&p), 2, 0), *t = NULL;
    taut_family_member m;
    CHECK(taut_surface_transpose(s, &t, NULL) == TAUT_OK, "transposes");
    CHECK(taut_surface_recognise(t, &m, NULL) == TAUT_OK, "is recognised");
    CHECK(m.turned == 1 && fabs(m.lambda - 0.3) < 1e-12 && fabs(m.scale - 2) < 1e-12,
          "lambda %.17g scale %.17g", m.lambda, m.scale);
    CHECK_NEAR(turn(m.theta, 0.25), 0, 1e-12, "its angle");
    taut_surface_free(s);
    taut_surface_free(t);
}

static void test_enneper(void)
{
    for (int trial = 0; trial < 20; trial++) {
        const taut_bonnet_problem p = {.lambda = {1, 1},
                                       .sign = -1,
                                       .normalize = 1,
                                       .alpha = random_in(0.5, 2),
                                       .beta = random_in(0.5, 2),
                                       .theta = random_in(-3, 3),
                                       .start = {random_in(-2, 1), random_in(-2, 1)}};
        const double scale = random_log(1e-2, 1e2);
        taut_surface *s = moved(made(&p), scale, 0);
        taut_family_member m;
        CHECK(taut_surface_recognise(s, &m, NULL) == TAUT_OK, "trial %d", trial);
        CHECK(strcmp(m.name, "Enneper's surface") == 0, "a %s", m.name);
        CHECK_NEAR(m.scale / scale, 1, 1e-9, "trial %d", trial);
        taut_surface_free(s);
    }
}

/* Nets that are none of them: one point moved, a sheared one, a plane. */
static void test_strangers(void)
{
    const taut_bonnet_problem p = {.lambda = {0.5, 0.5}, .sign = 1, .alpha = 2, .beta = 1};
    const taut_bonnet_problem enneper = {
        .lambda = {1, 1}, .sign = -1, .normalize = 1, .alpha = 1, .beta = 1};
    for (int kind = 0; kind < 6; kind++) {
        taut_surface *s = made(kind % 2 ? &enneper : &p), *t = NULL;
        taut_family_member m = {.name = "untouched"};
        taut_error error;
        double points[48];
        memcpy(points, taut_surface_points(s), sizeof points);
        for (int i = 0; i < 16; i++) {
            double *x = points + 3 * i;
            if (kind / 2 == 1) {
                x[0] += 1e-3 * x[2];
            } else if (kind / 2 == 2) {
                x[2] = 0;
            }
        }
        points[random_int(0, 47)] += kind / 2 == 0 ? 1e-6 : 0;
        CHECK(taut_surface_new("", taut_surface_u(s), taut_surface_v(s), points, NULL, &t, NULL) ==
                  TAUT_OK,
              "kind %d", kind);
        CHECK(taut_surface_recognise(t, &m, &error) == TAUT_NO_SOLUTION, "kind %d: a %s", kind,
              m.name);
        CHECK(strcmp(m.name, "untouched") == 0, "kind %d", kind);
        taut_surface_free(s);
        taut_surface_free(t);
    }
    CHECK(taut_surface_recognise(NULL, NULL, NULL) == TAUT_BAD_ARGUMENT, "nothing");
}

int main(void)
{
    random_seed(20261122);
    test_members();
    test_transposed();
    test_enneper();
    test_strangers();
    return check_failures != 0;
}
