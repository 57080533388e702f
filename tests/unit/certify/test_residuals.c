/* test_residuals.c -- models that are off by what is known: a claim says how far, not only that they are. */
#include "attack.h"
#include "certificates.h"
#include "check.h"
#include "edit.h"

#include "taut/certify.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static forge_pool pool;
static edit_model edit;

/* The claim of the example that was changed as `change` does. */
static double residual_of(const char *example, const char *construct, const char *claim,
                          void (*change)(double by), double by)
{
    subject s = subject_example(example);
    pool.used = 0;
    edit_open(s.model, construct, &pool, &edit);
    change(by);
    taut_model *model = edit_close(&edit);
    taut_certificate *certificate = NULL;
    CHECK(taut_certify(model, s.problem, NULL, &certificate, NULL) == TAUT_OK, "%s", example);
    const double residual = claim_of(certificate, claim)->residual;
    CHECK(claim_of(certificate, claim)->holds == TAUT_FALSE, "%s %s", example, claim);
    taut_certificate_free(certificate);
    taut_model_free(model);
    subject_free(&s);
    return residual;
}

static void grow(double by)
{
    for (int k = 0; k < edit.surfaces; k++) {
        for (int i = 0; i < 3 * edit.surface[k].nu * edit.surface[k].nv; i++) {
            edit.surface[k].points[i] *= 1 + by;
        }
    }
}

/* Larger by 1 + a, its area is larger by 2 a + a^2; its total curvature is as it was. */
static void test_area(void)
{
    for (double by = 1e-3; by > 1e-9; by /= 10) {
        const double found = residual_of("bonnet-figure-2a", "bonnet", "closed-form", grow, by);
        CHECK_NEAR(found, by * (2 + by), 2e-12, "area");
    }
}

static void raise_middle(double by)
{
    edit_surface *s = &edit.surface[0];
    s->points[3 * (s->nu / 2 * s->nv + s->nv / 2) + 2] += by;
}

/* Relations between coefficients are off in proportion to what a point is off, by more than a tenth of it: coefficients are about
 * as large as the surface. */
static void test_relations(void)
{
    double last = 0;
    for (double by = 1e-4; by > 1e-8; by /= 10) {
        const double found =
            residual_of("bonnet-figure-2a", "bonnet", "algebraic", raise_middle, by);
        CHECK(found > 0.1 * by && found < 100 * by, "a point off by %g: %g", by, found);
        CHECK(last == 0 || fabs(last / found - 10) < 0.1, "%g after %g", found, last);
        last = found;
    }
}

static void turn_rim(double by)
{
    for (int k = 0; k < edit.surfaces; k++) {
        edit_surface *s = &edit.surface[k];
        if (strcmp(s->name, "cap1") == 0) {
            s->points[3 * ((s->nu - 1) * s->nv + 1)] += by;
        }
    }
}

static void move_start(double by)
{
    edit.curve[0].points[1] += by;
}

/* Of a pipe of radius 8 and one of radius 1. */
static void test_pipes(void)
{
    for (double by = 1e-2; by > 1e-9; by /= 10) {
        CHECK_NEAR(residual_of("pipe-run-coil", "pipe", "caps", turn_rim, by), by / 8, 1e-13,
                   "a point of a cap");
        CHECK_NEAR(residual_of("pipe-paper", "pipe", "ends", move_start, by), by, 1e-13,
                   "the start of the axis");
    }
}

/* The second ring of the blend is off by 0.01 of the radius, of a model 2^-by times as large as its problem: products of four
 * of its lengths are out of range. */
static void lean_when_small(double by)
{
    for (int k = 0; k < edit.surfaces; k++) {
        edit_surface *s = &edit.surface[k];
        for (int j = 1; strcmp(s->name, "blend") == 0 && j < s->nv - 1; j++) {
            s->points[3 * (s->nv + j) + j % 3] += 0.01;
        }
        for (int i = 0; i < 3 * s->nu * s->nv; i++) {
            s->points[i] = ldexp(s->points[i], -(int)by);
        }
    }
    for (int i = 0; i < 3 * edit.curve[0].n; i++) {
        edit.curve[0].points[i] = ldexp(edit.curve[0].points[i], -(int)by);
    }
}

static void test_small_joint(void)
{
    const double whole = residual_of("pipe-flat-start", "pipe", "joint1", lean_when_small, 0);
    CHECK(whole > 0.1, "leans by %g", whole);
    CHECK_NEAR(residual_of("pipe-flat-start", "pipe", "joint1", lean_when_small, 180), whole, 1e-9,
               "of a small model");
}

int main(void)
{
    pool = (forge_pool){malloc((size_t)8 << 20), (size_t)8 << 20, 0};
    test_area();
    test_relations();
    test_pipes();
    test_small_joint();
    free(pool.bytes);
    return check_failures != 0;
}
