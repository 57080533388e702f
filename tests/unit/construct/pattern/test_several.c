/* test_several.c -- patterns of several surfaces: halves of the saddle, whichever way their parameters run, are cut as the whole is, and
 * what details say of where they are sewn together is not believed. */
#include "certificates.h"
#include "check.h"
#include "cloths.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* z = 0.3 (x^2 - y^2) over [from, to] x [-1, 1]; its parameters run otherwise: u along y, and v against x. */
static void add_half(char *text, size_t room, const char *name, double from, double to,
                     int is_otherwise)
{
    const double x[3] = {from, (from + to) / 2, to}, xx[3] = {from * from, from * to, to * to};
    static const double y[3] = {-1, 0, 1}, yy[3] = {1, -1, 1};
    size_t n = strlen(text);
    n += (size_t)snprintf(text + n, room - n,
                          "{ \"name\": \"%s\", \"u\": { \"type\": \"bezier\", \"degree\": 2 }, "
                          "\"v\": { \"type\": \"bezier\", \"degree\": 2 }, \"points\": [",
                          name);
    for (int i = 0; i < 3; i++) {
        n += (size_t)snprintf(text + n, room - n, "%s[", i > 0 ? ", " : "");
        for (int k = 0; k < 3; k++) {
            const int a = is_otherwise ? 2 - k : i, b = is_otherwise ? i : k;
            n += (size_t)snprintf(text + n, room - n, "%s[%.17g, %.17g, %.17g]", k > 0 ? ", " : "",
                                  x[a], y[b], 0.3 * (xx[a] - yy[b]));
        }
        n += (size_t)snprintf(text + n, room - n, "]");
    }
    snprintf(text + n, room - n, "] }");
}

static void halves(char *text, size_t room, int is_otherwise)
{
    snprintf(text, room, "{ \"taut\": 1, \"surfaces\": [");
    add_half(text, room, "west", -1, 0, 0);
    snprintf(text + strlen(text), room - strlen(text), ", ");
    add_half(text, room, "east", 0, 1, is_otherwise);
    snprintf(text + strlen(text), room - strlen(text), "] }");
}

static double energy_of(const made_cloth *made)
{
    return taut_record_number(taut_record_get(taut_certificate_figures(made->proof), "energy"));
}

/* The middle line is a geodesic: two strips a half are the four of the whole. */
static void test_halves(void)
{
    static const char *const rules[2] = {
        "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2 }]",
        "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2, \"surface\": \"west\" }, { "
        "\"across\": [\"u0\", \"u1\"], \"count\": 2, \"surface\": \"east\" }]"};
    char text[4096];
    made_cloth whole =
        cloth_make(SADDLE, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 4 }]");
    for (int k = 0; k < 2; k++) {
        halves(text, sizeof text, k);
        made_cloth made = cloth_make(text, rules[k]);
        CHECK(made.status == TAUT_OK, "%s", made.error.message);
        CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "halves %d", k);
        CHECK_NEAR(energy_of(&made), energy_of(&whole), 1e-12, "energy");
        for (int p = 0; p < 4; p++) {
            static const char *const paths[] = {"flat_area", "width_middle",
                                                "edges/end/flat_length", "strain/max"};
            char name[8], same[8];
            snprintf(name, sizeof name, "P%d", p + 1);
            /* v runs against x: the other way around */
            snprintf(same, sizeof same, "P%d", k == 1 && p >= 2 ? 6 - p : p + 1);
            for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
                CHECK_NEAR(cloth_number(&made, "pieces", name, paths[i]),
                           cloth_number(&whole, "pieces", same, paths[i]), 1e-9, "%s", paths[i]);
            }
        }
        cloth_free(&made);
    }
    cloth_free(&whole);
}

/* Strips of one end on the side of the other, and marks are those of one seam. */
static void test_across(void)
{
    char text[4096];
    halves(text, sizeof text, 1);
    made_cloth made =
        cloth_make(text, "\"seams\": [{ \"across\": [\"u0\", \"u1\"], \"count\": 3, \"surface\": "
                         "\"west\" }], \"marks\": { \"spacing\": 0.5 }, \"seam_length\": \"true\"");
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "across");
    CHECK(taut_record_count(taut_record_get(taut_model_details(made.model), "pieces")) == 4,
          "three strips, and a surface that no rule is for");
    cloth_free(&made);
}

/* The certificate of details that were changed, beside the document or alone. */
static taut_verdict judge(const made_cloth *made, const taut_record *details)
{
    taut_model *copy = NULL;
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_verdict verdict = TAUT_FALSE;
    taut_model_new(&copy);
    for (int i = 0; i < taut_model_surface_count(made->model); i++) {
        taut_surface *surface = NULL;
        taut_surface_copy(taut_model_surface(made->model, i), &surface);
        taut_model_add_surface(copy, surface);
    }
    for (int i = 0; i < taut_model_curve_count(made->model); i++) {
        taut_curve *curve = NULL;
        taut_curve_copy(taut_model_curve(made->model, i), &curve);
        taut_model_add_curve(copy, curve);
    }
    taut_model_set_details(copy, taut_record_copy(details));
    if (taut_certify(copy, made->problem, NULL, &proof, &error) == TAUT_OK) {
        verdict = taut_certificate_holds(proof);
    }
    taut_certificate_free(proof);
    taut_model_free(copy);
    return verdict;
}

static void test_told(void)
{
    static const char *const rows[][3] = {{"turned", "", NULL},
                                          {"surface", "east", "west"},
                                          {"surface", "", NULL},
                                          {"edge", "v1", "v0"}};
    char text[4096];
    halves(text, sizeof text, 1);
    made_cloth made = cloth_make(
        text, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2, \"surface\": \"west\" }]");
    const taut_record *details = taut_model_details(made.model);
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    CHECK(judge(&made, details) == TAUT_TRUE, "as they are");
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        taut_record *changed = cloth_edited(details, rows[k][0], rows[k][1], rows[k][2]);
        CHECK(judge(&made, changed) == TAUT_FALSE, "%s: %s as %s", rows[k][0], rows[k][1],
              rows[k][2] != NULL ? rows[k][2] : "nothing");
        taut_record_free(changed);
    }
    cloth_free(&made);
}

/* What is left on the right and on the left of the seam between the halves: as its curve runs, from above. */
static void test_left_between(void)
{
    static const char *const rules[3] = {
        "{ \"across\": [\"v0\", \"v1\"], \"count\": 1 }",
        "{ \"across\": [\"v0\", \"v1\"], \"count\": 1, \"surface\": \"west\" }, { \"across\": "
        "[\"u0\", \"u1\"], \"count\": 1, \"surface\": \"east\" }",
        "{ \"across\": [\"v0\", \"v1\"], \"count\": 1, \"surface\": \"west\" }, { \"across\": "
        "[\"u1\", \"u0\"], \"count\": 1, \"surface\": \"east\" }"}; /* strips against each other */
    char text[4096], members[512];
    for (int k = 0; k < 3; k++) {
        int found = 0;
        halves(text, sizeof text, k > 0);
        snprintf(members, sizeof members,
                 "\"seams\": [%s], \"allowance\": { \"S1\": [0.03, 0.01] }", rules[k]);
        made_cloth made = cloth_make(text, members);
        CHECK(made.status == TAUT_OK, "%s", made.error.message);
        CHECK(taut_certificate_holds(made.proof) == TAUT_TRUE, "certificate %d", k);
        for (int i = 0; made.status == TAUT_OK && i < taut_model_curve_count(made.model); i++) {
            const taut_curve *curve = taut_model_curve(made.model, i);
            double y[2][3];
            taut_curve_eval(curve, 0.5, 1, y[0]);
            if (strcmp(taut_curve_name(curve), "S1") != 0) {
                continue;
            }
            for (int p = 0; p < 8; p++) {
                static const char *const edges[] = {"right", "end", "left", "start"};
                const taut_record *edge = taut_record_get(
                    taut_record_get(cloth_told(&made, "pieces", p < 4 ? "P1" : "P2"), "edges"),
                    edges[p % 4]);
                const int is_right = (y[1][1] > 0) == (p >= 4); /* P2 is the eastern one */
                if (taut_record_get(edge, "seam") != NULL) {
                    found++;
                    CHECK_NEAR(taut_record_number(taut_record_get(edge, "allowance")),
                               is_right ? 0.03 : 0.01, 1e-15, "%d: %s", k, edges[p % 4]);
                }
            }
        }
        CHECK(found == 2, "%d edges at S1", found);
        cloth_free(&made);
    }
}

static void test_refusals(void)
{
    char text[4096];
    halves(text, sizeof text, 0);
    made_cloth made = cloth_make(text, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2, "
                                       "\"surface\": \"north\" }]");
    CHECK(made.status == TAUT_BAD_INPUT && strcmp(made.error.reason, "rule") == 0 &&
              strcmp(made.error.where, "/seams/0/surface") == 0,
          "%s at %s", made.error.reason, made.error.where);
    cloth_free(&made);
    made = cloth_make(text, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2 }], "
                            "\"seam_length\": \"true\", \"decompensate\": [{ \"edge\": \"v0\", "
                            "\"length\": 1 }]");
    CHECK(made.status == TAUT_BAD_INPUT && strcmp(made.error.reason, "conflict") == 0 &&
              strcmp(made.error.where, "/decompensate") == 0,
          "%s at %s", made.error.reason, made.error.where);
    cloth_free(&made);
    made = cloth_make(text, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2 }, { "
                            "\"butt\": \"P5\", \"at\": 0.5 }]");
    CHECK(made.status == TAUT_BAD_INPUT && strcmp(made.error.reason, "rule") == 0, "%s",
          made.error.message);
    cloth_free(&made);
    made = cloth_make(text, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2 }, { "
                            "\"butt\": \"P3\", \"at\": 0.5 }]");
    CHECK(made.status == TAUT_OK && cloth_told(&made, "pieces", "P3-2") != NULL, "a butt in P3: %s",
          made.error.message);
    CHECK(made.status == TAUT_OK && taut_certificate_holds(made.proof) == TAUT_TRUE, "a butt");
    cloth_free(&made);
}

/* A piece that is wider than the roll: of the rule that cuts its surface, with the number of strips of which all pieces of it fit, one less
 * does not, and the other surface may be too wide besides. */
static void test_width(void)
{
    static const char *const rules = "\"cloth\": { \"width\": 0.5 }, \"seams\": [{ \"across\": "
                                     "[\"v0\", \"v1\"], \"count\": %d, "
                                     "\"surface\": \"west\" }, { \"across\": [\"v0\", \"v1\"], "
                                     "\"count\": %d, \"surface\": \"east\" "
                                     "}]";
    static const struct {
        int west, east;
        const char *where;
    } all[] = {{3, 2, "/seams/1"}, {1, 2, "/seams/0"}, {2, 3, "/seams/0"}, {3, 3, NULL}};
    char text[4096], asked[512];
    halves(text, sizeof text, 0);
    for (int k = 0; k < 4; k++) {
        snprintf(asked, sizeof asked, rules, all[k].west, all[k].east);
        made_cloth made = cloth_make(text, asked);
        CHECK(made.status == (all[k].where != NULL ? TAUT_NO_SOLUTION : TAUT_OK), "%d: %s", k,
              made.error.message);
        CHECK(all[k].where == NULL || (strcmp(made.error.reason, "width") == 0 &&
                                       strcmp(made.error.where, all[k].where) == 0 &&
                                       strstr(made.error.message, "count of 3 ") != NULL),
              "%d: at %s: %s", k, made.error.where, made.error.message);
        cloth_free(&made);
    }
}

int main(void)
{
    test_halves();
    test_across();
    test_told();
    test_left_between();
    test_refusals();
    test_width();
    return check_failures != 0;
}
