/* test_trim.c -- gores that end on a circle around a pole, and the cap inside it: lengths and areas of cones, spheres and plane sectors in
 * closed form, poles at either end, lines of uneven speed; what is refused. */
#include "certificates.h"
#include "check.h"
#include "cloths.h"
#include "domes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

static void check_holds(const made_cloth *made, const char *what)
{
    CHECK(made->status == TAUT_OK, "%s: %s", what, made->error.message);
    CHECK(taut_certificate_holds(made->proof) == TAUT_TRUE, "%s holds", what);
    for (int k = 0; k < taut_certificate_claim_count(made->proof); k++) {
        const taut_claim *claim = taut_certificate_claim(made->proof, k);
        CHECK(claim->holds == TAUT_TRUE, "%s: %s %g", what, claim->claim, claim->residual);
    }
}

static double sum_of(const made_cloth *made, int from, int to, const char *path)
{
    double sum = 0;
    for (int k = from; k <= to; k++) {
        char name[8];
        snprintf(name, sizeof name, "P%d", k);
        sum += cloth_number(made, "pieces", name, path);
    }
    return sum;
}

/* The name of the seam of a kind. */
static const char *seam_of(const made_cloth *made, const char *kind)
{
    for (int k = 0; k < taut_pattern_seam_count(made->model); k++) {
        taut_pattern_sewn_seam seam;
        if (taut_pattern_seam_at(made->model, k, NULL, NULL, NULL, &seam, NULL) == TAUT_OK &&
            strcmp(seam.kind, kind) == 0) {
            return seam.name;
        }
    }
    return "none";
}

/* Half a turn, sine 0.6, slant 3: the cap of slant 1 is a sector of 0.3 of the turn, and stays without strain. */
static void test_cone(void)
{
    char *surface = dome_text(DOME_CONE, 0);
    made_cloth made =
        cloth_make(surface, "\"seams\": [{ \"radial\": \"v0\", \"count\": 5, \"trim\": 1 }]");
    check_holds(&made, "cone");
    CHECK(taut_pattern_piece_count(made.model) == 6, "1 + 5");
    CHECK_NEAR(sum_of(&made, 1, 1, "flat_area"), 0.3 * pi, 1e-11, "cap");
    CHECK_NEAR(sum_of(&made, 2, 6, "flat_area"), 0.3 * pi * 8, 1e-10, "gores");
    CHECK_NEAR(cloth_number(&made, "pieces", "P4", "edges/start/flat_length"), 0.6 * pi / 5, 1e-11,
               "start");
    CHECK_NEAR(cloth_number(&made, "pieces", "P1", "edges/left/flat_length"), 1, 1e-11, "side");
    CHECK_NEAR(cloth_number(&made, "seams", seam_of(&made, "circle"), "length"), 0.6 * pi, 1e-11,
               "circle");
    CHECK(claim_of(made.proof, "isometric")->holds == TAUT_TRUE, "isometric");
    taut_pattern_flat_piece second;
    CHECK(taut_pattern_piece_at(made.model, 2, &second, NULL) == TAUT_OK, "P3");
    CHECK_NEAR(fabs(second.edges[3].part[1] - second.edges[3].part[0]), 0.2, 1e-9, "a fifth");
    cloth_free(&made);
    free_dome(surface);
}

/* The unit sphere to 0.8 from its pole, the cap to 0.3; and what a certificate says of another distance. */
static void test_sphere(void)
{
    char *surface = dome_text(DOME_SPHERE, 0.8);
    made_cloth made =
        cloth_make(surface, "\"seams\": [{ \"radial\": \"v1\", \"count\": 12, \"trim\": 0.3 }]");
    made_cloth other = {.status = TAUT_OK}; /* only read */
    char text[9000];
    const int length = snprintf(text, sizeof text,
                                "{ \"taut\": 1, \"pattern\": \"cloth\", \"of\": %s, \"seams\": [{ "
                                "\"radial\": \"v1\", \"count\": 12, \"trim\": 0.30001 }] }",
                                surface);
    CHECK(taut_problem_read_text(text, (size_t)length, "other", &other.problem, NULL) == TAUT_OK,
          "read");
    check_holds(&made, "sphere");
    if (made.status != TAUT_OK) {
        return;
    }
    CHECK(taut_pattern_piece_count(made.model) == 15, "3 + 12");
    CHECK_NEAR(sum_of(&made, 1, 3, "area"), 2 * pi * (1 - cos(0.3)), 1e-10, "cap");
    CHECK_NEAR(sum_of(&made, 1, 3, "curvature"), 2 * pi * (1 - cos(0.3)), 1e-9, "K = 1");
    CHECK_NEAR(sum_of(&made, 4, 15, "area"), 2 * pi * (cos(0.3) - cos(0.8)), 1e-10, "gores");
    CHECK_NEAR(cloth_number(&made, "seams", seam_of(&made, "circle"), "length"), 2 * pi * sin(0.3),
               1e-11, "circle");
    CHECK_NEAR(cloth_number(&made, "pieces", "P5", "edges/left/length"), 0.5, 1e-11, "gore");
    CHECK(cloth_number(&made, "pieces", "P1", "strain/max") < 0.01 &&
              cloth_number(&made, "pieces", "P1", "strain/min") > -0.01,
          "K r^2/8 is 0.011: the tip is no place of strain");
    taut_certificate *proof = NULL;
    CHECK(taut_certify(made.model, other.problem, NULL, &proof, NULL) == TAUT_OK, "certified");
    CHECK(claim_of(proof, "layout")->holds == TAUT_FALSE, "another distance");
    CHECK_NEAR(claim_of(proof, "layout")->residual * 2 * sin(0.8), 1e-5, 1e-6, "by as much");
    taut_certificate_free(proof);
    cloth_free(&other);
    cloth_free(&made);
    free_dome(surface);
}

/* v c(u) in the plane, c of uneven length, over a quarter of the turn: rays are parameter lines, and the circle is one, within 1e-10 of
 * the size as curves on surfaces are. */
static void test_plane(void)
{
    for (int end = 0; end < 2; end++) {
        char members[120];
        char *surface = dome_text(end == 0 ? DOME_RAYS : DOME_RAYS_TURNED, 0);
        snprintf(members, sizeof members,
                 "\"seams\": [{ \"radial\": \"v%d\", \"count\": 3, \"trim\": 0.7 }]", end);
        made_cloth made = cloth_make(surface, members);
        check_holds(&made, "plane");
        CHECK(taut_pattern_piece_count(made.model) == 4, "1 + 3");
        CHECK_NEAR(cloth_number(&made, "pieces", "P1", "flat_area"), 0.49 * pi / 4, 5e-10, "cap");
        CHECK_NEAR(cloth_number(&made, "seams", seam_of(&made, "circle"), "length"), 0.7 * pi / 2,
                   1e-10, "circle");
        CHECK_NEAR(cloth_number(&made, "pieces", "P1", "edges/right/length"), 0.7, 1e-11, "radius");
        cloth_free(&made);
        /* strips towards the pole: the cap is the last */
        snprintf(members, sizeof members,
                 "\"seams\": [{ \"radial\": \"v%d\", \"count\": 3, \"trim\": 0.7 }]", 1 - end);
        made = cloth_make(surface, members);
        check_holds(&made, "towards");
        CHECK_NEAR(cloth_number(&made, "pieces", "P4", "flat_area"), 0.49 * pi / 4, 5e-10,
                   "the last");
        cloth_free(&made);
        free_dome(surface);
    }
}

static void test_refused(void)
{
    static const struct {
        const char *rule, *reason;
        int is_saddle;
    } all[] = {{"\"across\": [\"v0\", \"v1\"], \"count\": 2, \"trim\": 1", "rule", 1},
               {"\"radial\": \"v0\", \"count\": 2, \"trim\": 1", "rule", 1},
               {"\"radial\": \"v0\", \"count\": 2, \"trim\": 3", "outside", 0},
               {"\"radial\": \"v0\", \"count\": 2, \"trim\": 0", "value", 0},
               {"\"radial\": \"v0\", \"count\": 2, \"trim\": \"all\"", "type", 0}};
    for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) {
        char *cone = dome_text(DOME_CONE, 0);
        char members[200];
        snprintf(members, sizeof members, "\"seams\": [{ %s }]", all[k].rule);
        made_cloth made = cloth_make(all[k].is_saddle ? SADDLE : cone, members);
        CHECK(made.status == TAUT_BAD_INPUT && strcmp(made.error.reason, all[k].reason) == 0,
              "%s: %s", all[k].rule, made.error.reason);
        cloth_free(&made);
        free_dome(cone);
    }
    /* crossing what was cut before */
    char *cone = dome_text(DOME_CONE, 0);
    made_cloth made =
        cloth_make(cone, "\"seams\": [{ \"radial\": \"v0\", \"count\": 2 }, { \"radial\": \"v0\", "
                         "\"count\": 2, \"trim\": 1 }]");
    CHECK(made.status == TAUT_NO_SOLUTION && strcmp(made.error.reason, "crossing") == 0, "%s",
          made.error.reason);
    cloth_free(&made);
    free_dome(cone);
}

int main(void)
{
    test_cone();
    test_sphere();
    test_plane();
    test_refused();
    return check_failures != 0;
}
