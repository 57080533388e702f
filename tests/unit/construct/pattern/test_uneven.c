/* test_uneven.c -- pieces that usual places do not measure: large control points, free edges of few spans, K that is uneven. */
#include "certificates.h"
#include "check.h"
#include "cloths.h"
#include "core/pulse.h"
#include "monitors.h"

#include <string.h>

/* Control points of a patch of size 1 that are as large as 200: the area by products of their bounds is 8e-10 off 1.5436892865126284
 * (Gauss' rule with 20 nodes in 32 x 32 cells). */
static void test_large_control_points(void)
{
    made_cloth made = cloth_of_example(
        "asymptotic-4", "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 1 }]");
    CHECK(claim_of(made.proof, "exhausts")->holds == TAUT_TRUE, "pieces have the area: %g",
          claim_of(made.proof, "exhausts")->residual);
    CHECK_NEAR(figure_of(made.proof, "area"), 1.5436892865126284, 3e-10, "of one strip");
    cloth_free(&made);
}

/* Strips whose free edges, outlines, or curvatures are uneven between the places that usual pieces are measured by: free edges of one
 * span in four that bend by half a turn, an outline whose farthest place is next to a short span, K 40 times its mean beside a mast. */
static void test_uneven(void)
{
    static const char *const names[] = {"asymptotic-1-in", "asymptotic-4-in", "dirichlet-mast",
                                        "bonnet-figure-4"};
    for (int k = 0; k < 4; k++) {
        made_cloth made = cloth_of_example(
            names[k], "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 1 }]");
        const taut_claim *details = claim_of(made.proof, "details");
        CHECK(details->holds == TAUT_TRUE, "%s: %g at %s", names[k], details->residual,
              details->where);
        if (k == 1) { /* 24 x 24 places of Gauss in each of 8 x 8 cells; to 1e-7 of iint |K| dA */
            CHECK_NEAR(cloth_number(&made, "pieces", "P1", "curvature"), -4.96624074761, 1.1e-6,
                       "iint K dA");
        }
        cloth_free(&made);
    }
}

/* The proof of a piece on fine splines tells a monitor that it goes on as often as Cholesky's factor of its Hessian, n unknowns in a band of
 * w, and the inverse iteration have work: n w^2 and 24 times 4 n w operations. Where it is stopped it goes no further. */
static void check_watched(const made_cloth *made)
{
    double operations = 0;
    for (int k = 1; k < taut_model_surface_count(made->model); k++) {
        const taut_surface *flat = taut_model_surface(made->model, k);
        const double along = taut_basis_count(taut_surface_u(flat));
        const double across = taut_basis_count(taut_surface_v(flat));
        const double n = 2 * along * across, w = 2 * 9 * across;
        operations += n * w * w + 24 * 4 * n * w;
    }
    int last = 0;
    for (int k = 0; k <= last; k += 1 + last / 4) {
        watch all = {.stop_at = k};
        const taut_certify_options options = {.monitor = monitor_of(&all)};
        taut_certificate *proof = NULL;
        const taut_status status = taut_certify(made->model, made->problem, &options, &proof, NULL);
        last = k == 0 ? all.reports : last;
        CHECK(k > 0 || all.reports > operations / TAUT_PULSE_WORK, "%d reports of %g operations",
              all.reports, operations);
        CHECK(k == 0 ? status == TAUT_OK : status == TAUT_INTERRUPTED && all.reports == k,
              "stopped at %d: %d, went on to %d", k, (int)status, all.reports);
        taut_certificate_free(proof);
    }
}

/* Strips that get finer splines: one that took many steps on coarse ones begins where it ended there, 34 steps if not. By symmetry both
 * outer ones have one energy, whichever way they came. */
static void test_begun(void)
{
    made_cloth made = cloth_of_example(
        "asymptotic-2-mirror", "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }]");
    CHECK(cloth_number(&made, "pieces", "P3", "steps") <= 12, "%g steps",
          cloth_number(&made, "pieces", "P3", "steps"));
    /* strain is -0.32 in corners of P2: lines to sew end 2.6e-9 of their lengths from them on 64 x 16 spans */
    CHECK(claim_of(made.proof, "seams")->holds == TAUT_TRUE, "seams are off by %g",
          claim_of(made.proof, "seams")->residual);
    CHECK(claim_of(made.proof, "no-overlap")->holds == TAUT_TRUE, "outlines are closed");
    CHECK_NEAR(cloth_number(&made, "pieces", "P3", "energy"),
               cloth_number(&made, "pieces", "P1", "energy"), 1e-12, "mirrored");
    check_watched(&made);
    cloth_free(&made);
}

/* Held edges beside corners where strain is singular: laid end to end, and what is free takes the rest. Brought into corners of the
 * splines they were 4e-8 too long. */
static void test_held(void)
{
    static const char *const asked[] = {
        "\"held\": [\"v0\", \"v1\"], \"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2 }]"};
    for (int k = 0; k < 1; k++) {
        made_cloth made = cloth_of_example("asymptotic-4", asked[k]);
        const taut_claim *lengths = claim_of(made.proof, "lengths");
        CHECK(lengths->holds == TAUT_TRUE && lengths->residual < 1e-11, "%d: %g at %s", k,
              lengths->residual, lengths->where);
        CHECK(claim_of(made.proof, "no-overlap")->holds == TAUT_TRUE, "outlines are closed");
        cloth_free(&made);
    }
}

/* A piece that folds beside its corners, between the places of quadrature where its energy sees no fold. */
static void test_folds(void)
{
    made_cloth made = cloth_try_example(
        "dirichlet-hammock", "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 1 }]");
    CHECK(made.status == TAUT_NOT_CONVERGED && strcmp(made.error.reason, "folds") == 0, "%d: %s",
          (int)made.status, made.error.message);
    cloth_free(&made);
}

/* What no splines follow is refused with its place: K of this minimal surface is -((1 + lambda)/(1 - lambda))^2 in a corner, 1e10 times its
 * mean, for lambda 0.999. */
static void test_sharp(void)
{
    static const char *const asked[] = {
        "\"seams\": [{ \"across\": [\"u0\", \"u1\"], \"count\": 1 }]",
        "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 1 }]"};
    static const char *const reasons[] = {"folds", "not-converged"};
    for (int k = 0; k < 2; k++) {
        made_cloth made = cloth_try_example("bonnet-figure-4-limit", asked[k]);
        CHECK(made.status == TAUT_NOT_CONVERGED && strcmp(made.error.reason, reasons[k]) == 0,
              "%d: %s", (int)made.status, made.error.message);
        CHECK_NEAR(made.error.found, -1999.0 * 1999, 1, "K in the corner");
        cloth_free(&made);
    }
}

/* Finer splines that bring lines to sew no nearer to the edges are given up at once, with how far off they are. */
static void test_unsettled(void)
{
    made_cloth made = cloth_try_example(
        "pipe-paper", "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 1 }]");
    CHECK(made.status == TAUT_NOT_CONVERGED && strcmp(made.error.reason, "not-converged") == 0,
          "%d: %s", (int)made.status, made.error.message);
    CHECK(made.error.limit == 1e-9 && made.error.found > 1e-9, "ends %g from corners",
          made.error.found);
    cloth_free(&made);
}

int main(void)
{
    test_large_control_points();
    test_uneven();
    test_begun();
    test_held();
    test_folds();
    test_sharp();
    test_unsettled();
    return check_failures != 0;
}
