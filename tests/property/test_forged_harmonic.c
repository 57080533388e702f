/* test_forged_harmonic.c -- models of harmonic-extension, harmonic and biharmonic that somebody changed: any
 * other harmonic surface in place of one of the three, moved points, details that lie, edges that
 * are not those asked for. No certificate of a forgery holds, every honest one does not fail. */
#include "attack.h"
#include "certificates.h"
#include "check.h"
#include "shapes.h"

#include "taut/harmonic.h"

#include <math.h>
#include <string.h>

enum { MOST = 8 };

/* A harmonic surface of bidegree (n, n), n odd, over a rectangle: from two random rows. */
static taut_model *random_harmonic(int n, const double range[4])
{
    static double points[3 * MOST * MOST];
    static unsigned char known[MOST * MOST];
    taut_basis *u = shape_bezier(n, range[0], range[1]), *v = shape_bezier(n, range[2], range[3]);
    taut_harmonic_problem problem = {.u = u, .v = v, .rows = {.points = points, .known = known}};
    taut_model *model = NULL;
    taut_error error = {.message = ""};

    for (int k = 0; k < (n + 1) * (n + 1); k++) {
        known[k] = k / (n + 1) == 0 || k / (n + 1) == n;
        for (int c = 0; c < 3; c++) {
            points[3 * k + c] = random_in(-1, 1);
        }
    }
    CHECK(taut_harmonic_make(&problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    taut_basis_free(u);
    taut_basis_free(v);
    return model;
}

static void ranges_of(const taut_surface *s, double range[4])
{
    const taut_basis *u = taut_surface_u(s), *v = taut_surface_v(s);
    const double found[4] = {taut_basis_lo(u), taut_basis_hi(u), taut_basis_lo(v),
                             taut_basis_hi(v)};
    memcpy(range, found, sizeof found);
}

/* A surface of that name. */
static taut_surface *named(const char *name, const taut_surface *s)
{
    taut_surface *made = NULL;
    CHECK(taut_surface_new(name, taut_surface_u(s), taut_surface_v(s), taut_surface_points(s), NULL,
                           &made, NULL) == TAUT_OK,
          "named");
    return made;
}

static taut_verdict verdict_of(const taut_model *model, int construct, const void *data,
                               const char *name)
{
    taut_certificate *certificate = certificate_of(model, construct, data);
    const taut_verdict holds =
        name != NULL ? claim_of(certificate, name)->holds : taut_certificate_holds(certificate);
    taut_certificate_free(certificate);
    return holds;
}

static int construct_named(const char *name)
{
    for (int i = 0; i < taut_construct_count(); i++) {
        if (strcmp(taut_construct_name(i), name) == 0) {
            return i;
        }
    }
    return -1;
}

/* Random surfaces carried on across random edges; then one of the three is another harmonic surface
 * over the same rectangle, or the same moved by a part of its size. */
static void test_extension(void)
{
    const int construct = construct_named("harmonic-extension");
    for (int trial = 0; trial < random_trials(60); trial++) {
        const double range[4] = {random_in(-2, 0), random_in(0.5, 2), random_in(-1, 0),
                                 random_in(1, 2)};
        const int n = 2 * random_int(0, 2) + 1;
        taut_model *given = random_harmonic(n, range), *model = NULL;
        taut_harmonic_extension_problem problem = {.surface = taut_model_surface(given, 0),
                                                   .edge = (taut_edge)random_int(0, 3),
                                                   .c1 = {.width = random_in(0.3, 3)}};
        taut_error error = {.message = ""};
        if (random_int(0, 2) == 0) {
            problem.given = TAUT_EXTENSION_G1;
            problem.g1 = (taut_extension_g1){.width = random_in(0.3, 3),
                                             .c = random_in(0.2, 2),
                                             .alpha = random_in(-1, 1),
                                             .beta = random_in(-1, 1)};
        }
        const taut_status status = taut_harmonic_extension_make(&problem, NULL, &model, &error);
        CHECK(status == TAUT_OK, "%s", error.message);
        CHECK(verdict_of(model, construct, &problem, NULL) != TAUT_FALSE,
              "honest, n %d edge %d g1 %d", n, (int)problem.edge,
              problem.given == TAUT_EXTENSION_G1);
        CHECK(verdict_of(model, construct, &problem,
                         problem.given == TAUT_EXTENSION_G1 ? "contact" : "merged") == TAUT_TRUE,
              "honest, n %d", n);

        const int k = random_int(0, taut_model_surface_count(model) - 1);
        const taut_surface *victim = taut_model_surface(model, k);
        double own[4];
        ranges_of(victim, own);
        taut_model *other = random_harmonic(n, own);
        taut_model *forged =
            model_with(model, k, named(taut_surface_name(victim), taut_model_surface(other, 0)));
        CHECK(verdict_of(forged, construct, &problem, NULL) == TAUT_FALSE, "another surface %d", k);
        taut_model_free(forged);

        const double by[3] = {random_log(1e-8, 1), 0, 0};
        forged = model_moved(model, k, random_int(0, (n + 1) * (n + 1) - 1), by);
        CHECK(verdict_of(forged, construct, &problem, NULL) != TAUT_TRUE, "surface %d moved by %g",
              k, by[0]);
        taut_model_free(forged);
        taut_model_free(other);
        taut_model_free(model);
        taut_model_free(given);
    }
}

/* The given surface a million million times as large: what its carrying on might have lost says nothing
 * of a merged surface that does not cover it, nor of an extension that cannot come from it; moved points
 * of both are seen. */
static void test_large_first(void)
{
    static double points[3 * MOST * MOST];
    const int construct = construct_named("harmonic-extension");
    const double range[4] = {0, 1, 0, 1}, by[3] = {1e-12, 0, 0};
    taut_model *given = random_harmonic(3, range), *model = NULL;
    const taut_surface *first = taut_model_surface(given, 0);
    taut_harmonic_extension_problem problem = {
        .surface = first, .edge = TAUT_EDGE_U1, .c1 = {.width = 1}};
    taut_surface *large = NULL;

    CHECK(taut_harmonic_extension_make(&problem, NULL, &model, NULL) == TAUT_OK, "made");
    for (int i = 0; i < 3 * 16; i++) {
        points[i] = ldexp(taut_surface_points(first)[i], 40);
    }
    CHECK(taut_surface_new(taut_surface_name(taut_model_surface(model, 0)), taut_surface_u(first),
                           taut_surface_v(first), points, NULL, &large, NULL) == TAUT_OK,
          "large");
    taut_model *forged = model_with(model, 0, large);
    CHECK(verdict_of(forged, construct, NULL, "harmonic") == TAUT_TRUE, "each is harmonic");
    taut_model *moved = model_moved(forged, 2, 15, by);
    CHECK(verdict_of(moved, construct, NULL, "harmonic") == TAUT_FALSE, "the merged one is not");
    taut_model_free(moved);
    moved = model_moved(forged, 1, 5, by);
    CHECK(verdict_of(moved, construct, NULL, "harmonic") == TAUT_FALSE, "the extension is not");
    taut_model_free(moved);
    taut_model_free(forged);
    taut_model_free(model);
    taut_model_free(given);
}

/* A point of a known row moved, and details that call it a repair. */
static void test_repairs(void)
{
    static const char *const kinds[] = {"corner", "project", "raise", "none"};
    const int construct = construct_named("harmonic");
    for (int trial = 0; trial < random_trials(60); trial++) {
        const double range[4] = {0, random_in(0.5, 2), 0, 1};
        const int n = random_int(1, 5), side = random_int(0, 1), j = random_int(0, n);
        double points[3 * 36];
        unsigned char known[36];
        taut_basis *u = shape_bezier(n, range[0], range[1]), *v = shape_bezier(n, 0, 1);
        taut_harmonic_problem problem = {
            .u = u, .v = v, .rows = {.points = points, .known = known, .even = TAUT_EVEN_PROJECT}};
        taut_model *model = NULL, *moved = NULL;
        const double by[3] = {0, random_log(1e-7, 1), 0};
        taut_record *details = taut_record_new();

        for (int k = 0; k < (n + 1) * (n + 1); k++) {
            known[k] = k / (n + 1) == 0 || k / (n + 1) == n;
            for (int c = 0; c < 3; c++) {
                points[3 * k + c] = random_in(-1, 1);
            }
        }
        CHECK(taut_harmonic_make(&problem, NULL, &model, NULL) == TAUT_OK, "n %d", n);
        CHECK(verdict_of(model, construct, &problem, NULL) != TAUT_FALSE, "honest, n %d", n);
        moved = model_moved(model, 0, side * n * (n + 1) + j, by);
        taut_record_add_text(taut_record_add_object(details, "repair"), "kind",
                             kinds[random_int(0, 3)]);
        taut_model_set_details(moved, details);
        CHECK(verdict_of(moved, construct, &problem, "boundary") == TAUT_FALSE,
              "n %d side %d point %d", n, side, j);
        taut_model_free(moved);
        taut_model_free(model);
        taut_basis_free(u);
        taut_basis_free(v);
    }
}

int main(void)
{
    random_seed(20261214);
    test_extension();
    test_large_first();
    test_repairs();
    return check_failures != 0;
}
