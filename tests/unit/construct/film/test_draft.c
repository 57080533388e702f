/* test_draft.c -- drafts of films: from a film nearby they come to the film that taut_make finds, and hold what the problem
 * holds. */
#include "check.h"
#include "documents.h"

#include "geometry/nearest.h"
#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double plain_u[] = {0.05, 0.2, 0.41, 0.5, 0.77, 0.93};

static taut_problem *read_problem(const char *format, double at)
{
    char text[2000];
    snprintf(text, sizeof text, format, at);
    return problem_read(text);
}

/* How far the draft lies from the film: points of it from the nearest of the film, over its size, about 2. */
static double distance(const taut_model *draft, const taut_model *film)
{
    const taut_surface *a = taut_model_surface(draft, 0), *b = taut_model_surface(film, 0);
    double farthest = 0;

    for (int k = 0; k < 36; k++) {
        const double share[2] = {plain_u[k / 6], plain_u[k % 6]};
        double u = taut_basis_lo(taut_surface_u(a)), v = taut_basis_lo(taut_surface_v(a)), x[3],
               y[3];
        u += share[0] * (taut_basis_hi(taut_surface_u(a)) - u);
        v += share[1] * (taut_basis_hi(taut_surface_v(a)) - v);
        CHECK(taut_surface_eval(a, u, v, 0, x) == TAUT_OK, "a point");
        CHECK(taut_surface_nearest(b, x, &u, &v) == TAUT_OK, "the nearest");
        CHECK(taut_surface_eval(b, u, v, 0, y) == TAUT_OK, "it");
        farthest = fmax(farthest, hypot(hypot(x[0] - y[0], x[1] - y[1]), x[2] - y[2]) / 2);
    }
    return farthest;
}

/* From the film of 0.5 to that of `to`: after 60 steps within `close`, and the first already nearer than where it began. */
static void test_film(const char *format, double to, double close)
{
    taut_problem *problems[2] = {read_problem(format, 0.5), read_problem(format, to)};
    taut_model *films[2] = {NULL, NULL}, *draft = NULL, *next = NULL;
    taut_error error = {.status = TAUT_OK};

    for (int k = 0; k < 2; k++) {
        CHECK(taut_make(problems[k], NULL, &films[k], &error) == TAUT_OK, "%s", error.message);
    }
    const double before = distance(films[0], films[1]);
    CHECK(taut_draft(problems[1], films[0], 1, &draft, &error) == TAUT_OK && draft != NULL,
          "a draft");
    const double first = distance(draft, films[1]);
    CHECK(first < 0.7 * before, "%g is nearer than %g", first, before);
    for (int k = 0; k < 60; k++) { /* draft after draft, as a hand that rests leaves them */
        CHECK(taut_draft(problems[1], draft, 1, &next, &error) == TAUT_OK && next != NULL, "next");
        taut_model_free(draft);
        draft = next;
    }
    const double last = distance(draft, films[1]);
    CHECK(last < close, "from %g by %g to %g", before, first, last);
    const double *p = taut_surface_points(taut_model_surface(draft, 0)),
                 *q = taut_surface_points(taut_model_surface(films[1], 0));
    CHECK(memcmp(p, q, 3 * sizeof(double)) == 0, "what is held stands where it is held");
    CHECK(taut_model_certificate(draft) == NULL, "nothing is proved");
    CHECK(taut_model_curve_count(draft) == taut_model_curve_count(films[1]), "its cables");
    taut_model_free(draft);
    for (int k = 0; k < 2; k++) {
        taut_model_free(films[k]);
        taut_problem_free(problems[k]);
    }
}

#define SAIL(cable)                                                                                \
    "{\"taut\":1,\"construct\":\"film\",\"least\":false,"                                          \
    "\"corners\":{\"u0v0\":[-1,-1,%.17g],\"u1v0\":[1,-1,-0.5],\"u0v1\":[-1,1,-0.5],"               \
    "\"u1v1\":[1,1,0.5]},\"edges\":{\"u0\":{\"cable\":{" cable "}},\"u1\":{\"cable\":{" cable      \
    "}},\"v0\":{\"cable\":{" cable "}},\"v1\":{\"cable\":{" cable "}}}}"

/* Two corners on masts that lean. */
static const char masts[] =
    "{\"taut\":1,\"construct\":\"film\",\"least\":false,"
    "\"corners\":{\"u0v0\":[-1,-1,%.17g],\"u1v0\":{\"line\":{\"point\":[1,-1,0],"
    "\"direction\":[0.3,-0.2,1]},\"near\":[1,-1,-0.2]},\"u0v1\":{\"plane\":{\"point\":[-1,1,0],"
    "\"normal\":[1,-1,0.2]},\"near\":[-1,1,-0.5]},\"u1v1\":[1,1,0.5]},"
    "\"edges\":{\"u0\":{\"cable\":{\"force\":3}},\"u1\":{\"cable\":{\"force\":3}},"
    "\"v0\":{\"cable\":{\"force\":3}},\"v1\":{\"cable\":{\"force\":3}}}}";

/* One on a beam that is raised. */
static const char beam[] =
    "{\"taut\":1,\"construct\":\"film\",\"least\":false,"
    "\"corners\":{\"u0v0\":[-1,-1,0.5],\"u1v0\":{\"line\":{\"point\":[1,-1,%.17g],"
    "\"direction\":[1,0.9,0]},\"near\":[1,-1,0]},\"u0v1\":[-1,1,-0.5],\"u1v1\":[1,1,0.5]},"
    "\"edges\":{\"u0\":{\"cable\":{\"force\":3}},\"u1\":{\"cable\":{\"force\":2.5}},"
    "\"v0\":{\"cable\":{\"force\":3}},\"v1\":{\"cable\":{\"force\":3}}}}";

static const char ring[] =
    "{\"taut\":1,\"construct\":\"film\",\"seams\":[[\"u0\",\"u1\"]],"
    "\"u\":{\"type\":\"bspline\",\"degree\":3,\"count\":14},"
    "\"v\":{\"type\":\"bspline\",\"degree\":3,\"count\":8},\"edges\":{"
    "\"v0\":{\"fixed\":{\"circle\":{\"center\":[0,0,0],\"normal\":[0,0,1],\"radius\":1}}},"
    "\"v1\":{\"fixed\":{\"circle\":{\"center\":[0,0,%.17g],\"normal\":[0,0,1],\"radius\":1}}}}}";

static const char held[] =
    "{\"taut\":1,\"construct\":\"plateau\",\"least\":false,"
    "\"u\":{\"type\":\"bezier\",\"degree\":3},\"v\":{\"type\":\"bezier\",\"degree\":3},"
    "\"points\":[[[-1,-1,%.17g],[-1,-0.3,0],[-1,0.3,0],[-1,1,0]],"
    "[[-0.3,-1,0.5],null,null,[-0.3,1,0]],[[0.3,-1,0.3],null,null,[0.3,1,0]],"
    "[[1,-1,0],[1,-0.3,0],[1,0.3,0],[1,1,0.4]]]}";

/* Where there is no way there is no draft, and arguments are checked. */
static void test_none(void)
{
    taut_problem *sail = read_problem(SAIL("\"force\":2"), 0.5), *plate = read_problem(held, 0.5);
    taut_model *film = NULL, *draft = NULL;
    taut_error error = {.status = TAUT_OK};

    CHECK(taut_make(sail, NULL, &film, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_draft(plate, film, 1, &draft, &error) == TAUT_OK && draft == NULL, "another net");
    CHECK(taut_draft(sail, film, 0, &draft, &error) == TAUT_BAD_ARGUMENT, "no step");
    CHECK(taut_draft(NULL, film, 1, &draft, &error) == TAUT_BAD_ARGUMENT, "no problem");
    CHECK(taut_draft(sail, NULL, 1, &draft, &error) == TAUT_BAD_ARGUMENT, "no film");
    CHECK(taut_draft(sail, film, 1, NULL, &error) == TAUT_BAD_ARGUMENT, "no place");
    taut_model_free(film);
    taut_problem_free(sail);
    taut_problem_free(plate);
}

int main(void)
{
    test_film(SAIL("\"force\":2"), 0.65, 1e-4);
    test_film(SAIL("\"length\":2.4"), 0.65, 1e-4);
    test_film(SAIL("\"unstressed\":2.2,\"stiffness\":30"), 0.65, 1e-4);
    test_film(masts, 0.65, 1e-4);
    test_film(beam, 0.65, 1e-4);
    test_film(ring, 0.6, 2e-4);
    test_film(held, 0.7, 2e-3);
    test_none();
    return check_failures != 0;
}
