/* test_model.c -- operations on whole models: what is cut, what is copied, names, places.
 */
#include "check.h"

#include "taut/operations.h"

#include <string.h>

static taut_basis *make_basis(taut_basis_spec spec)
{
    taut_basis *basis = NULL;
    CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "%s", spec.type);
    return basis;
}

static void add_surface(taut_model *model, const char *name, taut_basis_spec u, taut_basis_spec v)
{
    taut_basis *bu = make_basis(u), *bv = make_basis(v);
    double points[3 * 64];
    taut_surface *surface = NULL;
    for (int i = 0; i < 3 * 64; i++) {
        points[i] = random_in(-1, 1);
    }
    CHECK(taut_surface_new(name, bu, bv, points, NULL, &surface, NULL) == TAUT_OK, "%s", name);
    CHECK(taut_model_add_surface(model, surface) == TAUT_OK, "%s", name);
    taut_basis_free(bu);
    taut_basis_free(bv);
}

static void add_curve(taut_model *model, const char *name, taut_basis_spec t)
{
    taut_basis *basis = make_basis(t);
    double points[3 * 16];
    taut_curve *curve = NULL;
    for (int i = 0; i < 3 * 16; i++) {
        points[i] = random_in(-1, 1);
    }
    CHECK(taut_curve_new(name, basis, points, NULL, &curve, NULL) == TAUT_OK, "%s", name);
    CHECK(taut_model_add_curve(model, curve) == TAUT_OK, "%s", name);
    taut_basis_free(basis);
}

static const taut_basis_spec cubic = {.type = "bezier", .degree = 3};
static const taut_basis_spec circular = {.type = "c-bspline", .alpha = 0.5, .segments = 2};
static const taut_basis_spec shaped = {.type = "ce-bezier", .alpha = 1, .beta = 2, .gamma = -1};

/* Surfaces "a" and "a-0", a curve on [0, 1] and one on [2, 3]. */
static taut_model *mixed(void)
{
    taut_model *model = NULL;
    const taut_basis_spec away = {.type = "bezier", .degree = 2, .has_range = 1, .range = {2, 3}};
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    CHECK(taut_model_set_unit(model, "cm") == TAUT_OK, "unit");
    add_surface(model, "a", cubic, circular);
    add_surface(model, "a-0", circular, cubic);
    add_curve(model, "axis", shaped);
    add_curve(model, "away", away);
    taut_model_set_details(model, taut_record_new());
    return model;
}

static int name_count(const taut_model *model, const char *name)
{
    int count = 0;
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        count += strcmp(taut_surface_name(taut_model_surface(model, i)), name) == 0;
    }
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        count += strcmp(taut_curve_name(taut_model_curve(model, i)), name) == 0;
    }
    return count;
}

static void check_distinct(const taut_model *model)
{
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        const char *name = taut_surface_name(taut_model_surface(model, i));
        CHECK(name_count(model, name) == 1, "\"%s\" comes more than once", name);
    }
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        const char *name = taut_curve_name(taut_model_curve(model, i));
        CHECK(name_count(model, name) == 1, "\"%s\" comes more than once", name);
    }
}

/* Along u at 0.25: a in two, a-0 (c-bspline, off its knot) in three, the axis in two quartics, the
 * curve on [2, 3] copied. */
static void test_split_all(void)
{
    taut_model *model = mixed(), *split = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_model_split(model, NULL, TAUT_ALONG_U, 0.25, &split, &error) == TAUT_OK, "%s",
          error.message);
    CHECK(taut_model_surface_count(split) == 5, "%d surfaces", taut_model_surface_count(split));
    CHECK(taut_model_curve_count(split) == 3, "%d curves", taut_model_curve_count(split));
    check_distinct(split);
    CHECK(name_count(split, "axis-0") == 1 && name_count(split, "away") == 1, "names");
    CHECK(strcmp(taut_model_unit(split), "cm") == 0, "the unit stays");
    CHECK(taut_model_details(split) == NULL && taut_model_certificate(split) == NULL, "dropped");
    const taut_basis *t = taut_curve_t(taut_model_curve(split, 0));
    CHECK(strcmp(taut_basis_type(t), "bezier") == 0 && taut_basis_degree(t) == 4, "a quartic");
    CHECK(taut_basis_lo(t) == 0 && taut_basis_hi(t) == 0.25, "its parameters");
    taut_model_free(split);
    taut_model_free(model);
}

/* Only the surface named; its pieces may not take the name of the other surface. */
static void test_split_one(void)
{
    taut_model *model = mixed(), *split = NULL;
    taut_error error = {.where = "", .message = ""};
    CHECK(taut_model_split(model, "a", TAUT_ALONG_V, 0.5, &split, &error) == TAUT_OK, "%s",
          error.message);
    CHECK(taut_model_surface_count(split) == 3 && taut_model_curve_count(split) == 2, "counts");
    check_distinct(split);
    CHECK(name_count(split, "a-0") == 1 && name_count(split, "a--0") == 1, "names");
    taut_model_free(split);
    split = NULL;
    CHECK(taut_model_split(model, "b", TAUT_ALONG_V, 0.5, &split, &error) == TAUT_BAD_ARGUMENT,
          "no such name");
    CHECK(taut_model_split(model, NULL, TAUT_ALONG_V, 1, &split, &error) == TAUT_NO_SOLUTION,
          "at the end of the range");
    CHECK(strcmp(error.where, "/surfaces/0") == 0, "where is %s", error.where);
    CHECK(taut_model_split(model, NULL, 2, 0.5, &split, &error) == TAUT_BAD_ARGUMENT, "direction");
    CHECK(taut_model_split(model, "away", TAUT_ALONG_U, 0.5, &split, &error) == TAUT_NO_SOLUTION,
          "outside of a curve that was named");
    CHECK(strcmp(error.where, "/curves/1") == 0, "where is %s", error.where);
    CHECK(split == NULL, "outputs are untouched on failure");
    taut_model_free(model);
}

/* Two patches of "a", two of "a-0", one piece of each curve; or those of one name alone. */
static void test_pieces(void)
{
    taut_model *model = mixed(), *pieces = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_model_pieces(model, NULL, &pieces, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_model_surface_count(pieces) == 4 && taut_model_curve_count(pieces) == 2, "all");
    CHECK(strcmp(taut_model_unit(pieces), "cm") == 0, "unit");
    check_distinct(pieces);
    for (int i = 0; i < 4; i++) {
        const taut_surface *piece = taut_model_surface(pieces, i);
        const taut_surface *whole = taut_model_surface(model, i / 2);
        const double u = taut_basis_lo(taut_surface_u(piece)) + 0.125;
        const double v = taut_basis_lo(taut_surface_v(piece)) + 0.375;
        double x[3], y[3];
        CHECK(strstr(taut_basis_type(taut_surface_u(piece)), "bezier") != NULL, "u of %d", i);
        CHECK(strstr(taut_basis_type(taut_surface_v(piece)), "bezier") != NULL, "v of %d", i);
        CHECK(taut_surface_eval(piece, u, v, 0, x) == TAUT_OK, "%d", i);
        CHECK(taut_surface_eval(whole, u, v, 0, y) == TAUT_OK, "%d", i);
        for (int c = 0; c < 3; c++) {
            CHECK_NEAR(x[c], y[c], 1e-14, "piece %d", i);
        }
    }
    CHECK(strcmp(taut_basis_type(taut_curve_t(taut_model_curve(pieces, 0))), "bezier") == 0,
          "a ce-bezier becomes a quartic");
    taut_model_free(pieces);
    pieces = NULL;
    CHECK(taut_model_pieces(model, "a-0", &pieces, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_model_surface_count(pieces) == 3, "one alone");
    CHECK(name_count(pieces, "a") == 1 && name_count(pieces, "axis") == 1, "the rest is copied");
    taut_model_free(pieces);
    pieces = NULL;
    CHECK(taut_model_pieces(model, "b", &pieces, &error) == TAUT_BAD_ARGUMENT, "no such name");
    CHECK(taut_model_pieces(NULL, "b", &pieces, &error) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(pieces == NULL, "outputs are untouched on failure");
    taut_model_free(model);
}

/* Each length times the ratio of the units, from every unit to every other and back: each step rounds once. */
static void test_to_unit(void)
{
    static const char *const units[] = {"mm", "cm", "m", "in", "ft"};
    static const double metres[] = {1e-3, 1e-2, 1, 0.0254, 0.3048};
    taut_model *model = mixed(), *once = NULL, *back = NULL;
    taut_error error = {.message = ""};

    for (int from = 0; from < 5; from++) {
        for (int to = 0; to < 5; to++) {
            CHECK(taut_model_set_unit(model, units[from]) == TAUT_OK, "%s", units[from]);
            CHECK(taut_model_to_unit(model, units[to], &once, &error) == TAUT_OK, "%s",
                  error.message);
            CHECK(taut_model_to_unit(once, units[from], &back, &error) == TAUT_OK, "%s",
                  error.message);
            CHECK(strcmp(taut_model_unit(once), units[to]) == 0, "unit");
            CHECK(taut_model_surface_count(once) == taut_model_surface_count(model) &&
                      taut_model_curve_count(once) == taut_model_curve_count(model),
                  "all of it");
            for (int i = 0; i < taut_model_curve_count(model); i++) {
                const double *x = taut_curve_points(taut_model_curve(model, i));
                const double *y = taut_curve_points(taut_model_curve(once, i));
                const double *z = taut_curve_points(taut_model_curve(back, i));
                CHECK_NEAR(y[3], x[3] * metres[from] / metres[to], 1e-15 * fabs(y[3]), "%s to %s",
                           units[from], units[to]);
                CHECK_NEAR(z[3], x[3], 1e-15 * fabs(x[3]), "%s and back", units[to]);
                CHECK(from != to || y[3] == x[3], "nothing to do");
            }
            taut_model_free(back);
            taut_model_free(once);
            back = once = NULL;
        }
    }
    CHECK(taut_model_to_unit(model, "yd", &once, &error) == TAUT_BAD_ARGUMENT, "no such unit");
    CHECK(taut_model_to_unit(NULL, "mm", &once, &error) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(once == NULL, "outputs are untouched on failure");
    taut_model_free(model);
}

static void test_refine(void)
{
    taut_model *model = mixed(), *fine = NULL, *curves = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_model_refine(model, NULL, 0, 0, &fine, &error) == TAUT_OK, "%s", error.message);
    const taut_surface *a = taut_model_surface(fine, 0);
    CHECK(strcmp(taut_surface_name(a), "a") == 0, "the name stays");
    CHECK(taut_basis_span_count(taut_surface_u(a)) == 2 &&
              taut_basis_span_count(taut_surface_v(a)) == 4,
          "both directions");
    CHECK(taut_basis_span_count(taut_curve_t(taut_model_curve(fine, 0))) == 1, "curves are copied");
    taut_model_free(fine);
    CHECK(taut_model_refine(model, "a", 0, 1, &fine, &error) == TAUT_OK, "%s", error.message);
    a = taut_model_surface(fine, 0);
    CHECK(taut_basis_span_count(taut_surface_u(a)) == 1 &&
              taut_basis_span_count(taut_surface_v(a)) == 4,
          "along v");
    CHECK(taut_basis_span_count(taut_surface_u(taut_model_surface(fine, 1))) == 2, "not the other");
    taut_model_free(fine);
    taut_model_free(model);
    fine = NULL;

    CHECK(taut_model_new(&curves) == TAUT_OK, "model");
    CHECK(taut_model_refine(curves, NULL, 0, 0, &fine, &error) == TAUT_BAD_ARGUMENT, "empty");
    add_curve(curves, "", shaped);
    CHECK(taut_model_refine(curves, NULL, 1, 0, &fine, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_basis_span_count(taut_curve_t(taut_model_curve(fine, 0))) == 2, "refined");
    taut_model_free(fine);
    CHECK(taut_model_split(curves, NULL, TAUT_ALONG_V, 0.5, &fine, &error) == TAUT_OK, "%s",
          error.message);
    CHECK(name_count(fine, "piece-1") == 1, "a name for the nameless");
    taut_model_free(fine);
    taut_model_free(curves);
}

/* A name of the greatest length stays within it, and whole characters. */
static void test_long_names(void)
{
    taut_model *model = NULL, *split = NULL;
    char name[TAUT_NAME_MAX + 1];
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    for (int i = 0; i < TAUT_NAME_MAX; i += 3) {
        memcpy(name + i, "\xe2\x82\xac", 3);
    }
    name[TAUT_NAME_MAX] = '\0';
    add_curve(model, name, cubic);
    CHECK(taut_model_split(model, NULL, TAUT_ALONG_U, 0.5, &split, NULL) == TAUT_OK, "split");
    const char *cut = taut_curve_name(taut_model_curve(split, 1));
    CHECK(strlen(cut) == TAUT_NAME_MAX - 1 && strcmp(cut + strlen(cut) - 2, "-1") == 0, "%s", cut);
    taut_model_free(split);
    taut_model_free(model);
}

static void test_to_nurbs(void)
{
    taut_model *model = mixed(), *nurbs = NULL;
    taut_error error = {.message = ""};
    double bound = -1;
    CHECK(taut_model_to_nurbs(model, 1e-6, &nurbs, &bound, &error) == TAUT_OK, "%s", error.message);
    CHECK(bound > 0 && bound < 1e-5, "bound %g", bound); /* sizes are at most 2 sqrt 3 */
    for (int i = 0; i < taut_model_surface_count(nurbs); i++) {
        const taut_surface *surface = taut_model_surface(nurbs, i);
        CHECK(strcmp(taut_basis_type(taut_surface_u(surface)), "bspline") == 0, "u of %d", i);
        CHECK(strcmp(taut_basis_type(taut_surface_v(surface)), "bspline") == 0, "v of %d", i);
    }
    CHECK(taut_basis_degree(taut_curve_t(taut_model_curve(nurbs, 0))) == 4, "the exact quartic");
    taut_model_free(nurbs);
    nurbs = NULL;
    CHECK(taut_model_to_nurbs(model, -1, &nurbs, &bound, &error) == TAUT_BAD_ARGUMENT, "negative");
    CHECK(nurbs == NULL, "outputs are untouched on failure");
    taut_model_free(model);
}

/* The tolerance is one of size, whatever the unit; beyond what squares hold there is a refusal. */
static void test_to_nurbs_of_any_size(void)
{
    const double sizes[] = {1e-300, 1e-150, 1, 1e150, 1e250};
    for (int n = 0; n < 5; n++) {
        const taut_basis_spec layered = {.type = "h-bezier", .beta = 300};
        const double matrix[12] = {sizes[n], 0, 0, 0, 0, sizes[n], 0, 0, 0, 0, sizes[n], 0};
        taut_model *model = NULL, *scaled = NULL, *nurbs = NULL;
        taut_surface *surface = NULL;
        taut_error error = {.message = ""};
        double bound = -1;
        CHECK(taut_model_new(&model) == TAUT_OK && taut_model_new(&scaled) == TAUT_OK, "model");
        add_surface(model, "a", layered, cubic);
        CHECK(taut_surface_transform(taut_model_surface(model, 0), matrix, &surface, NULL) ==
                  TAUT_OK,
              "scaled");
        CHECK(taut_model_add_surface(scaled, surface) == TAUT_OK, "scaled");
        const taut_status status = taut_model_to_nurbs(scaled, 1e-6, &nurbs, &bound, &error);
        if (sizes[n] > 1e200) {
            CHECK(status == TAUT_NO_SOLUTION && strcmp(error.where, "/surfaces/0/points") == 0,
                  "%s: %s", error.where, error.message);
        } else {
            CHECK(status == TAUT_OK, "size %g: %s", sizes[n], error.message);
            CHECK(bound > 1e-8 * sizes[n] && bound < 1e-5 * sizes[n], "size %g: %g", sizes[n],
                  bound);
            CHECK(taut_basis_span_count(taut_surface_u(taut_model_surface(nurbs, 0))) > 10,
                  "size %g", sizes[n]);
        }
        taut_model_free(nurbs);
        taut_model_free(scaled);
        taut_model_free(model);
    }
}

int main(void)
{
    random_seed(20260106);
    test_split_all();
    test_split_one();
    test_pieces();
    test_to_unit();
    test_refine();
    test_long_names();
    test_to_nurbs();
    test_to_nurbs_of_any_size();
    return check_failures != 0;
}
