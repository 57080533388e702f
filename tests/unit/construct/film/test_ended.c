/* test_ended.c -- films that are told to be done: found, one is shown without what comes after; before that there is nothing
 * to show. Stopped, nothing is left. */
#include "certificates.h"
#include "check.h"
#include "documents.h"
#include "monitors.h"

#include "taut/taut.h"

#include <string.h>

enum { ENDS = 5 };

static const char sail[] =
    "{\"taut\":1,\"construct\":\"film\",\"corners\":{\"u0v0\":[-1,-1,0.5],\"u1v0\":[1,-1,-0.5],"
    "\"u0v1\":[-1,1,-0.5],\"u1v1\":[1,1,0.5]},\"edges\":{\"u0\":{\"cable\":{\"force\":2}},"
    "\"u1\":{\"cable\":{\"force\":2}},\"v0\":{\"cable\":{\"force\":2}},\"v1\":{\"cable\":{"
    "\"force\":2}}},\"u\":{\"type\":\"bspline\",\"degree\":3,\"count\":5},\"v\":{\"type\":"
    "\"bspline\",\"degree\":3,\"count\":5},\"refine\":1}";
static const char patches[] =
    "{\"taut\":1,\"construct\":\"film\",\"patches\":[{\"name\":\"l\",\"u\":{\"type\":\"bspline\","
    "\"degree\":3,\"count\":5},\"v\":{\"type\":\"bspline\",\"degree\":3,\"count\":5},\"corners\":{"
    "\"u0v0\":[0,0,0],\"u1v0\":[1,0,0.5],\"u0v1\":[0,2,0.5],\"u1v1\":[1,2,0]}},{\"name\":\"r\","
    "\"u\":{\"type\":\"bspline\",\"degree\":3,\"count\":5},\"v\":{\"type\":\"bspline\",\"degree\":"
    "3,\"count\":5},\"corners\":{\"u0v0\":[1,0,0.5],\"u1v0\":[2,0,0],\"u0v1\":[1,2,0],\"u1v1\":["
    "2,2,0.5]}}],\"seams\":[[\"l.u1\",\"r.u0\"]],\"refine\":1}";

static int same_points(const taut_model *a, const taut_model *b)
{
    int same = taut_model_surface_count(a) == taut_model_surface_count(b);
    for (int k = 0; same && k < taut_model_surface_count(a); k++) {
        const taut_surface *x = taut_model_surface(a, k), *y = taut_model_surface(b, k);
        const size_t count = (size_t)taut_basis_count(taut_surface_u(x)) *
                             (size_t)taut_basis_count(taut_surface_v(x));
        same =
            memcmp(taut_surface_points(x), taut_surface_points(y), 3 * count * sizeof(double)) == 0;
    }
    return same;
}

static const taut_record *detail(const taut_model *model, const char *name)
{
    return taut_record_get(taut_model_details(model), name);
}

/* Of a film that was shown early all claims hold that the whole one's do, but what was left out is not there. */
static void check_shown(const taut_problem *problem, const taut_model *model, const char *what)
{
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};

    CHECK(taut_certify(model, problem, NULL, &proof, &error) == TAUT_OK, "%s: %s", what,
          error.message);
    CHECK(claim_of(proof, "stationary")->holds == TAUT_TRUE, "%s: not at rest", what);
    CHECK(claim_of(proof, "least")->holds == TAUT_UNDECIDED, "%s: least without a witness", what);
    CHECK(taut_certificate_holds(proof) != TAUT_FALSE, "%s: false", what);
    taut_certificate_free(proof);
}

static void check_ends(const char *text, const char *what)
{
    taut_problem *problem = problem_read(text);
    watch all = {.stop_at = 0};
    taut_make_options options = {.monitor = monitor_of(&all), .time_limit = 1e9};
    taut_model *whole = NULL;
    taut_error error = {.status = TAUT_OK};
    int shown = 0, proved = 0;

    CHECK(taut_make(problem, &options, &whole, &error) == TAUT_OK, "%s: %s", what, error.message);
    CHECK(detail(whole, "stopped") == NULL && detail(whole, "refinement") != NULL &&
              detail(whole, "least") != NULL,
          "%s: the whole", what);
    options.time_limit = 0;
    for (int k = 1; k <= all.reports; k += 1 + all.reports / ENDS) {
        watch enough = {.stop_at = k, .answer = TAUT_ENOUGH}, stop = {.stop_at = k};
        taut_model *model = NULL;
        options.monitor = monitor_of(&enough);
        const taut_status status = taut_make(problem, &options, &model, &error);
        CHECK(enough.reports == k, "%s: it goes on after report %d: %d", what, k, enough.reports);
        CHECK(status == TAUT_OK ||
                  (status == TAUT_NOT_CONVERGED && strcmp(error.reason, "time") == 0 && shown == 0),
              "%s: report %d of %d: %d, %s", what, k, all.reports, (int)status, error.message);
        if (status == TAUT_OK) {
            CHECK(strcmp(taut_record_text(detail(model, "stopped")), "request") == 0, "%s: %d",
                  what, k);
            CHECK(same_points(model, whole), "%s: report %d: another film", what, k);
            CHECK(detail(model, "refinement") == NULL || detail(model, "least") == NULL,
                  "%s: report %d: nothing is left out", what, k);
            if (shown++ == 0) {
                check_shown(problem, model, what);
                proved++;
            }
        }
        taut_model_free(model);
        model = NULL;
        options.monitor = monitor_of(&stop);
        CHECK(taut_make(problem, &options, &model, &error) == TAUT_INTERRUPTED && model == NULL,
              "%s: stopped at report %d", what, k);
    }
    CHECK(shown > 1 && proved == 1, "%s: %d of %d ends have a film to show", what, shown,
          all.reports);
    taut_model_free(whole);
    taut_problem_free(problem);
}

int main(void)
{
    check_ends(sail, "sail");
    check_ends(patches, "patches");
    return check_failures != 0;
}
