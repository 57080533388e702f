/* test_asymptotic.c -- every number of the worked examples in docs/papers/asymptotic.md, which come
 * from an independent reference. Tolerances: curve data to 12 digits (the reference's energy
 * gradient is below 1e-13); surface points to their 11 digits. For degree 5 surfaces are compared,
 * not inner points. */
#include "asymptotic.h"
#include "asymptotic_page.h"
#include "check.h"

#include <string.h>

enum { EXAMPLES = sizeof page_examples / sizeof *page_examples };

static double relative(double size)
{
    return 2e-12 * fmax(1.0, fabs(size));
}

static const taut_record *member(const taut_record *record, const char *a, const char *b,
                                 const char *c)
{
    return taut_record_get(taut_record_get(taut_record_get(record, a), b), c);
}

static void check_list(const taut_record *list, int count, const double *expected, const char *what,
                       const char *which)
{
    CHECK((int)taut_record_count(list) == count, "%s of %s: %zu", what, which,
          taut_record_count(list));
    for (int k = 0; k < count; k++) {
        CHECK_NEAR(taut_record_number(taut_record_at(list, (size_t)k)), expected[k],
                   6e-12 * fmax(1.0, fabs(expected[k])), "%s %d of %s", what, k, which);
    }
}

static const taut_curve *curve_of(const taut_model *model, const char *name)
{
    for (int k = 0; k < taut_model_curve_count(model); k++) {
        if (strcmp(taut_curve_name(taut_model_curve(model, k)), name) == 0) {
            return taut_model_curve(model, k);
        }
    }
    return NULL;
}

static double curvature_at(const taut_curve *curve, double t)
{
    double x[3][3], b[3], speed = 0.0;
    CHECK(taut_curve_eval(curve, t, 2, &x[0][0]) == TAUT_OK, "t=%g", t);
    for (int k = 0; k < 3; k++) {
        b[k] = x[1][(k + 1) % 3] * x[2][(k + 2) % 3] - x[1][(k + 2) % 3] * x[2][(k + 1) % 3];
    }
    speed = sqrt(x[1][0] * x[1][0] + x[1][1] * x[1][1] + x[1][2] * x[1][2]);
    return sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]) / (speed * speed * speed);
}

static void check_edge(const page_example *page, const taut_model *model, int e)
{
    const page_edge *const edge = &page->edges[e];
    const char *const name = taut_asymptotic_edge_name(e);
    const taut_curve *const curve = curve_of(model, name);
    const taut_record *const details = taut_model_details(model);
    const int straight = edge->beta[0] == 0.0;
    for (int j = 0; j <= page->degree; j++) {
        CHECK_NEAR(taut_curve_weights(curve)[j], edge->weights[j], relative(1.0), "%d%s %s w_%d",
                   page->number, page->branch, name, j);
        for (int k = 0; k < 3; k++) {
            CHECK_NEAR(taut_curve_points(curve)[3 * j + k], edge->points[j][k], relative(1.0),
                       "%d%s %s P_%d", page->number, page->branch, name, j);
        }
    }
    CHECK(taut_record_bool(member(details, "edges", name, "straight")) == straight, "%s", name);
    if (straight) {
        return;
    }
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR(curvature_at(curve, k / 2.0), edge->curvature[k], 1e-10, "%d%s %s k(%d/2)",
                   page->number, page->branch, name, k);
    }
    check_list(member(details, "edges", name, "torsion"), 2, edge->torsion, "torsion", name);
    check_list(member(details, "edges", name, "alpha"), 3 * page->degree - 4, edge->alpha, "alpha",
               name);
    check_list(member(details, "edges", name, "beta"), 2, edge->beta, "beta", name);
    check_list(member(details, "edges", name, "sigma"), 2, edge->sigma, "sigma", name);
}

static void check_patch(const page_example *page, const taut_model *model)
{
    const taut_surface *const patch = taut_model_surface(model, 0);
    const int columns = page->patch_degree + 1;
    for (int c = 0; c < 4; c++) {
        const char *const name = taut_asymptotic_corner_name(c);
        const taut_record *const details = taut_model_details(model);
        check_list(member(details, "corners", name, "twist"), 3, page->twist[c], "twist", name);
        CHECK_NEAR(taut_record_number(member(details, "corners", name, "weight")),
                   page->corner_weight[c], relative(1.0), "%d%s W_11 at %s", page->number,
                   page->branch, name);
    }
    for (int i = 1; i <= page->row_count; i++) {
        CHECK_NEAR(taut_surface_weights(patch)[i * columns + 1], page->row[i - 1][0], relative(1.0),
                   "%d%s W_%d1", page->number, page->branch, i);
        for (int k = 0; k < 3; k++) {
            CHECK_NEAR(taut_surface_points(patch)[3 * (i * columns + 1) + k],
                       page->row[i - 1][k + 1], relative(1.0), "%d%s S_%d1", page->number,
                       page->branch, i);
        }
    }
    for (int j = 0; j < PAGE_PLACES; j++) {
        double x[3];
        CHECK(taut_surface_eval(patch, page->place[j][0], page->place[j][1], 0, x) == TAUT_OK,
              "at");
        for (int k = 0; k < 3; k++) {
            CHECK_NEAR(x[k], page->value[j][k], 1e-11, "%d%s R(%g, %g)", page->number, page->branch,
                       page->place[j][0], page->place[j][1]);
        }
    }
}

static void check_example(const page_example *page)
{
    taut_asymptotic_problem problem = asymptotic_example(page->number, page->branch);
    taut_model *model = NULL;
    const taut_record *details = NULL;
    double least = INFINITY;
    problem.report_singular = page->number == 3;
    model = asymptotic_make(&problem, page->branch);
    if (model == NULL) {
        return;
    }
    details = taut_model_details(model);
    CHECK_NEAR(taut_record_number(taut_record_get(details, "curve_energy")), page->curve_energy,
               1e-12 * page->curve_energy, "%d%s A1", page->number, page->branch);
    CHECK_NEAR(taut_record_number(taut_record_get(details, "plate_energy")), page->plate_energy,
               5e-11 * page->plate_energy, "%d%s A2", page->number, page->branch);
    CHECK_NEAR(taut_record_number(taut_record_get(details, "degree")), page->patch_degree, 0,
               "degree");
    for (int k = 0; k < (page->patch_degree + 1) * (page->patch_degree + 1); k++) {
        least = fmin(least, taut_surface_weights(taut_model_surface(model, 0))[k]);
    }
    CHECK_NEAR(least, page->smallest_weight, 5e-8, "smallest weight");
    for (int e = 0; e < 4; e++) {
        check_edge(page, model, e);
    }
    check_patch(page, model);
    taut_model_free(model);
}

/* Where the page says that the singular points of example 3 lie. */
static void test_singular(void)
{
    static const double places[4] = {0.811599, 0.811599, 0.911183, 0.911183};
    taut_asymptotic_problem problem = asymptotic_example(3, NULL);
    taut_model *model = NULL;
    taut_error error;
    CHECK(taut_asymptotic_make(&problem, NULL, &model, &error) == TAUT_NO_SOLUTION, "refused");
    CHECK_NEAR(error.found, 0.811599, 5e-7, "the first place");
    CHECK(strcmp(error.reason, "singular") == 0 && strstr(error.message, "edge v0 ") != NULL, "%s",
          error.message);
    problem.report_singular = 1;
    model = asymptotic_make(&problem, "report");
    for (int e = 0; e < 4; e++) {
        CHECK_NEAR(taut_record_number(member(taut_model_details(model), "edges",
                                             taut_asymptotic_edge_name(e), "singular_at")),
                   places[e], 5e-7, "edge %d", e);
    }
    taut_model_free(model);
}

/* Both branches of each example are reported, the lowest first, whichever is returned. */
static void test_branches(void)
{
    for (int k = 0; k < EXAMPLES; k++) {
        const page_example *const page = &page_examples[k];
        taut_asymptotic_problem problem = asymptotic_example(page->number, page->branch);
        taut_model *model = NULL;
        const taut_record *branches = NULL;
        int found = 0;
        double before = 0.0;
        problem.surface = TAUT_BIDEGREE_N_PLUS_3;
        problem.report_singular = 1;
        model = asymptotic_make(&problem, page->branch);
        branches = taut_record_get(taut_model_details(model), "branches");
        for (size_t j = 0; j < taut_record_count(branches); j++) {
            const taut_record *const branch = taut_record_at(branches, j);
            const double energy = taut_record_number(taut_record_get(branch, "energy"));
            found +=
                strcmp(taut_record_text(taut_record_get(branch, "branch")), page->branch) == 0 &&
                fabs(energy - page->curve_energy) <= 1e-12 * energy;
            CHECK(energy >= before, "in order");
            before = energy;
        }
        CHECK(found == 1, "example %d branch %s", page->number, page->branch);
        taut_model_free(model);
    }
}

int main(void)
{
    for (int k = 0; k < EXAMPLES; k++) {
        check_example(&page_examples[k]);
    }
    test_singular();
    test_branches();
    return check_failures != 0;
}
