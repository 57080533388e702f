/* test_ended.c -- a film that is to end before it is done: the best so far, told as such, and never
 * worse than what was there before; and one that is stopped, of which nothing is left. No clock is
 * looked at: a limit of no time at all is over at the first report, one of years never. */
#include "check.h"
#include "films.h"
#include "monitors.h"

#include "taut/measure.h"
#include "taut/write.h"

#include <stdlib.h>
#include <string.h>

static const char *stopped_of(const taut_model *model)
{
    return taut_record_text(taut_record_get(taut_model_details(model), "stopped"));
}

static double area_of(const taut_model *model)
{
    double area = nan("");
    CHECK(taut_surface_area(taut_model_surface(model, 0), &area, NULL) == TAUT_OK, "area");
    return area;
}

/* What the certificate says of the claim `stationary`; the points that were given must be there. */
static taut_verdict prove(const taut_model *model, const taut_plateau_problem *problem)
{
    taut_certificate *certificate = NULL;
    taut_verdict stationary = TAUT_UNDECIDED;
    CHECK(taut_plateau_certify(model, problem, NULL, &certificate, NULL) == TAUT_OK, "certify");
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        if (strcmp(claim->claim, "stationary") == 0) {
            stationary = claim->holds;
        } else if (strcmp(claim->claim, "known") == 0 || strcmp(claim->claim, "identity") == 0) {
            CHECK(claim->holds == TAUT_TRUE, "%s", claim->claim);
        }
    }
    taut_certificate_free(certificate);
    return stationary;
}

static int same_text(const taut_model *a, const taut_model *b)
{
    char *text[2] = {NULL, NULL};
    size_t length[2] = {0, 0};
    CHECK(taut_model_write_text(a, "json", NULL, &text[0], &length[0], NULL) == TAUT_OK, "a");
    CHECK(taut_model_write_text(b, "json", NULL, &text[1], &length[1], NULL) == TAUT_OK, "b");
    const int same = length[0] == length[1] && memcmp(text[0], text[1], length[0]) == 0;
    taut_text_free(text[0]);
    taut_text_free(text[1]);
    return same;
}

/* Ended at every report in turn: the area falls from that of the Dirichlet surface to the least, which
 * is `least`; stopped at every report, nothing is left. *unproved: ends at which `stationary` fails. */
static void check_ends(const taut_plateau_problem *problem, int reports, double least,
                       int *unproved)
{
    double before = INFINITY;
    for (int k = 1; k <= reports; k++) {
        watch enough = {.stop_at = k, .answer = TAUT_ENOUGH}, stop = {.stop_at = k};
        taut_make_options options = {.monitor = monitor_of(&enough)};
        taut_model *model = NULL;
        taut_error error = {.status = TAUT_OK};
        const taut_status status = taut_plateau_make(problem, &options, &model, &error);
        CHECK(enough.reports == k, "it goes on after report %d: %d", k, enough.reports);
        if (status == TAUT_OK) {
            const double area = area_of(model);
            const double first =
                taut_record_number(taut_record_get(taut_model_details(model), "dirichlet_area"));
            CHECK(strcmp(stopped_of(model), "request") == 0, "report %d: \"%s\"", k,
                  stopped_of(model));
            CHECK(area <= fmin(before, first) * (1 + 1e-14) && area >= least * (1 - 1e-13),
                  "report %d: %.17g after %.17g, least %.17g", k, area, before, least);
            before = area;
            *unproved += prove(model, problem) == TAUT_FALSE;
        } else {
            CHECK(status == TAUT_NOT_CONVERGED && strcmp(error.reason, "time") == 0 &&
                      before == INFINITY && model == NULL,
                  "report %d: %s", k, error.message);
        }
        taut_model_free(model);
        model = NULL;
        options.monitor = monitor_of(&stop);
        CHECK(taut_plateau_make(problem, &options, &model, &error) == TAUT_INTERRUPTED &&
                  strcmp(error.reason, "interrupted") == 0 && model == NULL,
              "report %d: %s", k, error.message);
    }
    CHECK(before < INFINITY, "it never ends with anything to show");
}

/* The whole of it, its reports counted, and with a limit that is never reached: the same bytes. */
static void check_problem(const taut_plateau_problem *problem, const char *what)
{
    watch all = {.stop_at = 0};
    const taut_make_options counted = {.monitor = monitor_of(&all), .time_limit = 1e9};
    const taut_make_options hurried = {.time_limit = 1e-9};
    taut_model *model = NULL, *plain = NULL, *none = NULL;
    taut_error error = {.status = TAUT_OK};
    int unproved = 0;

    CHECK(taut_plateau_make(problem, NULL, &plain, &error) == TAUT_OK, "%s: %s", what,
          error.message);
    CHECK(taut_plateau_make(problem, &counted, &model, NULL) == TAUT_OK, "%s", what);
    CHECK(strcmp(stopped_of(model), "") == 0 && same_text(model, plain), "%s", what);
    CHECK(all.reports > 4, "%s: %d reports", what, all.reports);
    check_ends(problem, all.reports < 40 ? all.reports : 40, area_of(model), &unproved);
    CHECK(unproved > 0, "%s: an unfinished film is proved", what);
    CHECK(taut_plateau_make(problem, &hurried, &none, &error) == TAUT_NOT_CONVERGED &&
              strcmp(error.reason, "time") == 0 && error.limit == 1e-9 && none == NULL,
          "%s: %s", what, error.message);
    taut_model_free(model);
    taut_model_free(plain);
}

static void test_full(void)
{
    test_problem net = problem_tetrahedron(8);
    const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    check_problem(&problem, "full");
    problem_free(&net);
}

/* From points that are given: ended before the first step they are what there is. */
static void test_start(void)
{
    test_problem net = problem_tetrahedron(6);
    taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    const double *dirichlet = NULL;
    taut_model *first = problem_make(&net, &dirichlet);
    watch enough = {.stop_at = 2, .answer = TAUT_ENOUGH};
    const taut_make_options options = {.monitor = monitor_of(&enough)};
    taut_model *model = NULL;
    problem.start = dirichlet;
    CHECK(taut_plateau_make(&problem, &options, &model, NULL) == TAUT_OK, "ended");
    CHECK_NEAR(area_of(model), area_of(first), 1e-14, "the start is what there is");
    taut_model_free(model);
    taut_model_free(first);
    problem_free(&net);
}

/* A net so large that it is approached along normals: ended on that way, the Dirichlet surface is what
 * there is. */
static void test_approach(void)
{
    test_problem net = problem_tetrahedron(54);
    const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    const double *dirichlet = NULL;
    taut_model *first = problem_make(&net, &dirichlet), *model = NULL;
    watch enough = {.stop_at = 2, .answer = TAUT_ENOUGH};
    const taut_make_options options = {.monitor = monitor_of(&enough)};
    CHECK(taut_plateau_make(&problem, &options, &model, NULL) == TAUT_OK, "ended");
    CHECK_NEAR(area_of(model), area_of(first), 1e-13, "the Dirichlet surface");
    const taut_record *details = taut_model_details(model);
    CHECK(strcmp(taut_record_text(taut_record_get(details, "solver")), "none") == 0, "solver");
    CHECK(taut_record_kind_of(taut_record_get(details, "residual")) == TAUT_RECORD_NULL,
          "residual");
    taut_model_free(model);
    taut_model_free(first);
    problem_free(&net);
}

/* A gap that takes several spaces: the last one that was done, proved to be at rest. */
static void test_spaces(void)
{
    test_problem net = problem_tetrahedron(5);
    taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    watch all = {.stop_at = 0};
    taut_make_options options = {.monitor = monitor_of(&all)};
    taut_model *model = NULL;
    int finer = 0;
    problem.tolerance_area = 1e-3;
    CHECK(taut_plateau_make(&problem, &options, &model, NULL) == TAUT_OK, "tolerance_area");
    taut_model_free(model);
    for (int k = all.reports / 2; k < all.reports; k += 1 + all.reports / 16) {
        watch enough = {.stop_at = k, .answer = TAUT_ENOUGH};
        options.monitor = monitor_of(&enough);
        model = NULL;
        CHECK(taut_plateau_make(&problem, &options, &model, NULL) == TAUT_OK, "report %d", k);
        const taut_surface *surface = taut_model_surface(model, 0);
        CHECK(strcmp(stopped_of(model), "request") == 0, "report %d", k);
        finer += taut_basis_count(taut_surface_u(surface)) > 5;
        taut_model_free(model);
    }
    CHECK(finer > 0, "no finer space was kept");
    problem_free(&net);
}

int main(void)
{
    test_full();
    test_start();
    test_approach();
    test_spaces();
    return check_failures != 0;
}
