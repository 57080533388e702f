/* test_harmonic.c -- the certificates of harmonic and harmonic-extension attacked: points moved by
 * ten times each limit and by a tenth, other surfaces in place of the merged one, repairs that the
 * model claims, edges of another degree or range, surfaces without normals, sizes. */
#include "attack.h"
#include "certificates.h"
#include "check.h"
#include "shapes.h"

#include "taut/operations.h"

#include <string.h>

static void test_attacked(void)
{
    static const attack rows[] = {
        {"harmonic-rows", "harmonic", TAUT_BOUND, 0, 4, 11, 2e-14},
        {"harmonic-rows", "boundary", TAUT_EXACT, 0, 0, 3, 1e-14},
        {"harmonic-rows", "boundary", TAUT_EXACT, 0, 12, 15, 1e-14},
        {"harmonic-derivative", "boundary", TAUT_EXACT, 0, 4, 7, 1e-14},
        {"harmonic-even", "harmonic", TAUT_BOUND, 0, 5, 9, 2e-14},
        {"harmonic-fit", "nearest", TAUT_EXACT, 0, 0, 4, 2e-14},
        {"harmonic-extension", "harmonic", TAUT_BOUND, 1, 4, 15, 2e-14},
        {"harmonic-extension", "boundary", TAUT_EXACT, 0, 0, 15, 1e-14},
        {"harmonic-extension", "continuity", TAUT_BOUND, 1, 0, 7, 1e-12},
        {"harmonic-extension", "merged", TAUT_EXACT, 2, 0, 15, 2e-14},
        {"harmonic-extension", "merged", TAUT_EXACT, 1, 0, 15, 2e-14},
        {"harmonic-neighbour", "continuity", TAUT_BOUND, 1, 4, 7, 1e-12},
        {"harmonic-neighbour", "contact", TAUT_BOUND, 1, 4, 7, 1e-12},
    };
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        attack_claim(&rows[k], 4);
    }
}

static taut_verdict verdict_of(const taut_model *model, const taut_problem *problem,
                               const char *construct, const char *name)
{
    taut_certificate *certificate = prove(model, problem, construct);
    const taut_verdict holds = claim_of(certificate, name)->holds;
    taut_certificate_free(certificate);
    return holds;
}

/* The surface with (x, y, z) -> (7 + y, 3 - x, 2 z): as harmonic as before, and another one. */
static taut_surface *turned(const taut_surface *s)
{
    double points[64][3];
    taut_surface *made = NULL;
    const int count = taut_basis_count(taut_surface_u(s)) * taut_basis_count(taut_surface_v(s));
    for (int k = 0; k < count; k++) {
        const double *x = taut_surface_points(s) + 3 * k;
        const double y[3] = {7 + x[1], 3 - x[0], 2 * x[2]};
        memcpy(points[k], y, sizeof y);
    }
    CHECK(taut_surface_new(taut_surface_name(s), taut_surface_u(s), taut_surface_v(s),
                           &points[0][0], NULL, &made, NULL) == TAUT_OK,
          "turned");
    return made;
}

static void test_merged(void)
{
    subject s = subject_example("harmonic-extension");
    for (int k = 0; k < 3; k++) {
        taut_model *other = model_with(s.model, k, turned(taut_model_surface(s.model, k)));
        CHECK(verdict_of(other, s.problem, NULL, "harmonic") == TAUT_TRUE, "surface %d", k);
        CHECK(verdict_of(other, s.problem, NULL, "merged") == TAUT_FALSE, "surface %d", k);
        CHECK(verdict_of(other, NULL, "harmonic-extension", "merged") == TAUT_FALSE, "alone, %d",
              k);
        taut_model_free(other);
    }
    subject_free(&s);
}

static taut_model *without(const taut_model *model, int last)
{
    taut_model *made = NULL;
    CHECK(taut_model_new(&made) == TAUT_OK, "a model");
    for (int i = 0; i < last; i++) {
        taut_surface *copy = NULL;
        CHECK(taut_surface_copy(taut_model_surface(model, i), &copy) == TAUT_OK &&
                  taut_model_add_surface(made, copy) == TAUT_OK,
              "surface %d", i);
    }
    return made;
}

/* With the problem the merged surface has to be there. */
static void test_missing(void)
{
    subject s = subject_example("harmonic-extension");
    taut_model *two = without(s.model, 2);
    taut_certificate *certificate = NULL;
    CHECK(taut_certify(two, s.problem, NULL, &certificate, NULL) == TAUT_BAD_INPUT, "h left out");
    taut_model_free(two);
    subject_free(&s);
}

static const char rows_text[] =
    "{\"taut\": 1, \"construct\": \"harmonic\", \"u\": {\"type\": \"bezier\", \"degree\": %d%s},"
    " \"v\": {\"type\": \"bezier\", \"degree\": %d}, %s"
    " \"points\": [[[0,0,0],[0,1,1],[0,2,0]%s], %s [[2,0,0],[2,1,%s],[2,2,0]%s]]}";

/* A document of two rows of degree m in bidegree (m, m); `top` is a coordinate of the second. */
static subject two_rows(int m, const char *range, const char *even, const char *top)
{
    char text[1024];
    snprintf(text, sizeof text, rows_text, m, range, m, even, m == 3 ? ",[0,3,0]" : "",
             m == 3 ? "[null,null,null,null],[null,null,null,null]," : "[null,null,null],", top,
             m == 3 ? ",[2,3,0]" : "");
    return subject_of(text);
}

/* What the model's details say of a repair counts for nothing; what the problem says does. */
static void test_repair(void)
{
    static const char *const kinds[] = {"corner", "project", "raise"};
    subject plain = two_rows(3, "", "", "0.3"), moved = two_rows(3, "", "", "0.35");
    for (size_t k = 0; k < 3; k++) {
        taut_record *details = taut_record_new();
        taut_record_add_text(taut_record_add_object(details, "repair"), "kind", kinds[k]);
        taut_model_set_details(moved.model, details);
        CHECK(verdict_of(moved.model, plain.problem, NULL, "boundary") == TAUT_FALSE, "%s",
              kinds[k]);
    }
    subject_free(&plain);
    subject_free(&moved);

    for (size_t k = 0; k < 3; k++) {
        char even[64];
        snprintf(even, sizeof even, "\"even\": \"%s\",", kinds[k]);
        subject asked = two_rows(2, "", even, "0.3"), not_asked = two_rows(2, "", "", "1");
        taut_model_set_details(asked.model, taut_record_new());
        CHECK(verdict_of(asked.model, asked.problem, NULL, "boundary") == TAUT_TRUE, "%s",
              kinds[k]);
        CHECK(verdict_of(asked.model, asked.problem, NULL, "harmonic") == TAUT_TRUE, "%s",
              kinds[k]);
        if (k < 2) { /* bidegree (2, 2), which the other problem has too */
            CHECK(verdict_of(asked.model, not_asked.problem, NULL, "boundary") == TAUT_FALSE, "%s",
                  kinds[k]);
        }
        subject_free(&asked);
        subject_free(&not_asked);
    }
}

/* Harmonic over another rectangle, or with edges of another degree that begin alike. */
static void test_other_edges(void)
{
    subject here = two_rows(3, "", "", "0.3"), wide = two_rows(3, ", \"range\": [0, 2]", "", "0.3");
    taut_surface *raised = NULL;
    taut_certificate *certificate = NULL;
    taut_model *model = NULL;

    CHECK(taut_certify(wide.model, here.problem, NULL, &certificate, NULL) == TAUT_BAD_INPUT,
          "another rectangle");
    CHECK(taut_surface_elevate(taut_model_surface(here.model, 0), 0, 2, &raised, NULL) == TAUT_OK,
          "raised");
    model = model_with(here.model, 0, raised);
    CHECK(taut_certify(model, here.problem, NULL, &certificate, NULL) == TAUT_BAD_INPUT,
          "another degree");
    taut_model_free(model);
    subject_free(&here);
    subject_free(&wide);
}

/* A surface that is a segment has no tangent planes to compare: nothing is decided. */
static void test_without_normals(void)
{
    static const double line[4][3] = {{0, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}};
    static const double beyond[4][3] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 5}};
    static const double flat[4][3] = {{-1, 0, 0}, {-1, 1, 0}, {0, 0, 0}, {0, 1, 0}};
    static const double level[4][3] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};
    const struct {
        const double (*p)[3], (*q)[3];
        taut_verdict wanted;
    } pairs[] = {
        {line, beyond, TAUT_UNDECIDED}, {flat, level, TAUT_TRUE}, {flat, beyond, TAUT_FALSE}};
    for (size_t k = 0; k < 3; k++) {
        taut_surface *p =
            shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), &pairs[k].p[0][0], NULL);
        taut_surface *q =
            shape_surface(shape_bezier(1, 1, 2), shape_bezier(1, 0, 1), &pairs[k].q[0][0], NULL);
        taut_model *model = shape_model(p);
        CHECK(taut_model_add_surface(model, q) == TAUT_OK, "a pair");
        CHECK(verdict_of(model, NULL, "harmonic-extension", "continuity") == pairs[k].wanted,
              "pair %zu", k);
        taut_model_free(model);
    }
}

/* The extension as a whole moved away, over a rectangle elsewhere, or of another width. */
static void test_apart(void)
{
    static const char format[] =
        "{\"taut\": 1, \"construct\": \"harmonic-extension\", \"edge\": \"u1\", \"width\": %d,"
        " \"surface\": {\"u\": {\"type\": \"bezier\", \"degree\": 1},"
        " \"v\": {\"type\": \"bezier\", \"degree\": 1},"
        " \"points\": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,1]]]}}";
    char text[512];
    snprintf(text, sizeof text, format, 1);
    subject one = subject_of(text);
    snprintf(text, sizeof text, format, 2);
    subject two = subject_of(text);
    const taut_surface *q = taut_model_surface(one.model, 1);
    double points[12];

    CHECK(verdict_of(one.model, one.problem, NULL, "merged") == TAUT_TRUE, "as wide");
    CHECK(verdict_of(two.model, two.problem, NULL, "merged") == TAUT_TRUE, "twice as wide");
    CHECK(verdict_of(two.model, one.problem, NULL, "merged") == TAUT_FALSE, "not as wide");
    CHECK(verdict_of(two.model, one.problem, NULL, "continuity") == TAUT_TRUE, "twice as wide");

    memcpy(points, taut_surface_points(taut_model_surface(one.model, 0)), sizeof points);
    taut_model *shorter = model_with(
        one.model, 0, shape_surface(shape_bezier(1, 0.2, 1), shape_bezier(1, 0, 1), points, NULL));
    CHECK(verdict_of(shorter, NULL, "harmonic-extension", "merged") == TAUT_FALSE,
          "a shorter range");
    taut_model_free(shorter);

    memcpy(points, taut_surface_points(q), sizeof points);
    taut_model *away =
        model_with(one.model, 1,
                   shape_surface(shape_bezier(1, 1.5, 2.5), shape_bezier(1, 0, 1), points, NULL));
    CHECK(verdict_of(away, one.problem, NULL, "continuity") == TAUT_FALSE, "another rectangle");
    taut_model_free(away);
    for (int k = 0; k < 4; k++) {
        points[3 * k + 2] += 1e-9;
    }
    away = model_with(one.model, 1,
                      shape_surface(shape_bezier(1, 1, 2), shape_bezier(1, 0, 1), points, NULL));
    CHECK(verdict_of(away, one.problem, NULL, "continuity") == TAUT_FALSE, "a gap");
    taut_model_free(away);
    subject_free(&one);
    subject_free(&two);
}

/* The same verdicts at every size. */
static void test_sizes(void)
{
    static const int exponents[] = {-1010, -600, 0, 600, 1010};
    static const char *const examples[] = {"harmonic-extension", "harmonic-neighbour"};
    for (size_t e = 0; e < 2; e++) {
        subject s = subject_example(examples[e]);
        for (size_t k = 0; k < sizeof exponents / sizeof exponents[0]; k++) {
            const double by[3] = {0, ldexp(1e-6, exponents[k]), 0};
            taut_model *scaled = model_scaled(s.model, exponents[k]);
            taut_model *moved = model_moved(scaled, 1, 6, by);
            static const char *const names[] = {"harmonic", "continuity"};
            for (int i = 0; i < 2; i++) {
                CHECK(verdict_of(scaled, NULL, "harmonic-extension", names[i]) == TAUT_TRUE,
                      "%s at 2^%d", names[i], exponents[k]);
                CHECK(verdict_of(moved, NULL, "harmonic-extension", names[i]) == TAUT_FALSE,
                      "%s moved at 2^%d", names[i], exponents[k]);
            }
            taut_model_free(scaled);
            taut_model_free(moved);
        }
        subject_free(&s);
    }
}

int main(void)
{
    random_seed(20261212);
    test_attacked();
    test_merged();
    test_missing();
    test_repair();
    test_other_edges();
    test_without_normals();
    test_apart();
    test_sizes();
    return check_failures != 0;
}
