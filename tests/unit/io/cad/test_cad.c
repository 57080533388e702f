/* test_cad.c -- STEP and IGES: what is written comes back the same, what is approximated lies
 * within the bound that is told, and broken files are refused.
 *
 * needs: posix
 */
#include "check.h"
#include "folder.h"
#include "models.h"
#include "shapes.h"

#include "taut/limits.h"
#include "taut/operations.h"
#include "taut/read.h"
#include "taut/write.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static const char *const endings[] = {"model.step", "model.igs", "model.stp", "model.IGES"};

static taut_model *read_back(const char *path)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_model_read(path, &model, &error) == TAUT_OK, "%s: %s: %s", path, error.where,
          error.message);
    return model;
}

static taut_model *written_and_read(const taut_model *model, const char *path, double tolerance,
                                    double *bound)
{
    const taut_write_options options = {.tolerance = tolerance, .bound = bound};
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_model_write(model, path, &options, &error) == TAUT_OK, "%s: %s", path,
          error.message);
    return error.status == TAUT_OK ? read_back(path) : NULL;
}

/* Bit for bit, also names, units and order: a bezier basis as the bspline that it is. */
static void check_same(const taut_model *back, const taut_model *model, const char *path)
{
    const int surfaces = taut_model_surface_count(model), curves = taut_model_curve_count(model);
    CHECK(taut_model_surface_count(back) == surfaces && taut_model_curve_count(back) == curves,
          "%s: %d surfaces of %d, %d curves of %d", path, taut_model_surface_count(back), surfaces,
          taut_model_curve_count(back), curves);
    CHECK(strcmp(taut_model_unit(back), taut_model_unit(model)) == 0, "%s: %s", path,
          taut_model_unit(back));
    for (int i = 0; i < surfaces && i < taut_model_surface_count(back); i++) {
        taut_surface *nurbs = NULL;
        CHECK(taut_surface_to_nurbs(taut_model_surface(model, i), 1, &nurbs, NULL, NULL) == TAUT_OK,
              "nurbs");
        CHECK(same_surface(taut_model_surface(back, i), nurbs), "%s: surface %d \"%s\"", path, i,
              taut_surface_name(nurbs));
        taut_surface_free(nurbs);
    }
    for (int i = 0; i < curves && i < taut_model_curve_count(back); i++) {
        taut_curve *nurbs = NULL;
        CHECK(taut_curve_to_nurbs(taut_model_curve(model, i), 1, &nurbs, NULL, NULL) == TAUT_OK,
              "nurbs");
        CHECK(same_curve(taut_model_curve(back, i), nurbs), "%s: curve %d \"%s\"", path, i,
              taut_curve_name(nurbs));
        taut_curve_free(nurbs);
    }
}

static void test_round_trip(void)
{
    static const char *const units[] = {"mm", "m", "cm", "in", "ft"};
    static const char *const names[] = {"plain", "it's", "a\\b", "",
                                        "\303\244\342\202\254\360\237\230\200"};
    for (int trial = 0; trial < random_trials(8); trial++) {
        const char *path = in_folder(endings[trial % 4]);
        taut_model *model = NULL, *back = NULL;
        double bound = -1;
        CHECK(taut_model_new(&model) == TAUT_OK, "model");
        CHECK(taut_model_set_unit(model, units[trial % 5]) == TAUT_OK, "unit");
        for (int i = random_int(0, 3); i >= 0; i--) {
            add_some_surface(model, names[random_int(0, 4)]);
        }
        for (int i = random_int(0, 2); i > 0; i--) {
            add_some_curve(model, names[random_int(0, 4)]);
        }
        back = written_and_read(model, path, 0, &bound);
        CHECK(bound == 0, "%s: bound %g", path, bound);
        if (back != NULL) {
            check_same(back, model, path);
        }
        taut_model_free(model);
        taut_model_free(back);
    }
}

/* Surfaces whose opposite edges meet, or lie nearer than what CAD takes for one, rational or not:
 * every bit as well. */
static void test_closed(void)
{
    for (int trial = 0; trial < 8; trial++) {
        const double gap = trial < 4 ? 0 : random_log(1e-12, 5e-8);
        const taut_basis_spec spec = {.type = "bspline", .degree = 2, .count = 6};
        const char *path = in_folder(endings[trial % 2]);
        double *points = numbers_in(6 * 6 * 3, -10, 10), *weights = numbers_in(6 * 6, 0.1, 3);
        taut_surface *surface = NULL;
        taut_model *model = NULL, *back = NULL;
        taut_basis *basis = NULL;
        double bound = -1;
        for (int i = 0; i < 6; i++) {
            for (int k = 0; k < 3; k++) {
                points[(i * 6 + 5) * 3 + k] = points[i * 6 * 3 + k] + gap;
            }
            weights[i * 6 + 5] = weights[i * 6];
        }
        CHECK(taut_model_new(&model) == TAUT_OK &&
                  taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK &&
                  taut_surface_new("closed", basis, basis, points, trial % 4 < 2 ? weights : NULL,
                                   &surface, NULL) == TAUT_OK &&
                  taut_model_add_surface(model, surface) == TAUT_OK,
              "trial %d", trial);
        back = written_and_read(model, path, 0, &bound);
        if (back != NULL) {
            check_same(back, model, path);
        }
        taut_model_free(model);
        taut_model_free(back);
        taut_basis_free(basis);
        free(points);
        free(weights);
    }
}

/* The surfaces of a model at the same parameters lie no farther apart than the bound. */
static void check_distance(const taut_surface *exact, const taut_surface *near, double bound,
                           const char *path)
{
    enum { GRID = 201 };
    const double u0 = taut_basis_lo(taut_surface_u(exact)),
                 u1 = taut_basis_hi(taut_surface_u(exact));
    const double v0 = taut_basis_lo(taut_surface_v(exact)),
                 v1 = taut_basis_hi(taut_surface_v(exact));
    double worst = 0;
    for (int i = 0; i < GRID; i++) {
        for (int j = 0; j < GRID; j++) {
            const double u = fmin(u1, u0 + (u1 - u0) * i / (GRID - 1));
            const double v = fmin(v1, v0 + (v1 - v0) * j / (GRID - 1));
            double x[3], y[3], sum = 0;
            CHECK(taut_surface_eval(exact, u, v, 0, x) == TAUT_OK, "u=%g v=%g", u, v);
            CHECK(taut_surface_eval(near, u, v, 0, y) == TAUT_OK, "u=%g v=%g", u, v);
            for (int c = 0; c < 3; c++) {
                sum += (x[c] - y[c]) * (x[c] - y[c]);
            }
            worst = fmax(worst, sqrt(sum));
        }
    }
    CHECK(worst <= bound, "%s: %g off, told %g", path, worst, bound);
    CHECK(worst >= bound / 100 || bound < 1e-11, "%s: the bound %g is far from %g", path, bound,
          worst);
}

static void add_quasi(taut_model *model, const char *type_u, const char *type_v)
{
    const char *types[2] = {type_u, type_v};
    taut_basis *bases[2] = {NULL, NULL};
    taut_surface *surface = NULL;
    double *points = NULL;
    for (int d = 0; d < 2; d++) {
        taut_basis_spec spec = {.type = types[d]};
        const double length = random_log(0.05, 3);
        spec.alpha = types[d][0] == 'c' ? length : 0;
        spec.beta = types[d][0] == 'h' ? length : 0;
        spec.segments = strstr(types[d], "spline") != NULL ? random_int(1, 4) : 0;
        CHECK(taut_basis_new(&spec, 0, &bases[d], NULL) == TAUT_OK, "%s", types[d]);
    }
    points = numbers_in(3 * taut_basis_count(bases[0]) * taut_basis_count(bases[1]), -10, 10);
    CHECK(taut_surface_new("quasi", bases[0], bases[1], points, NULL, &surface, NULL) == TAUT_OK,
          "surface");
    CHECK(taut_model_add_surface(model, surface) == TAUT_OK, "add");
    taut_basis_free(bases[0]);
    taut_basis_free(bases[1]);
    free(points);
}

static void test_bound(void)
{
    static const char *const types[] = {"c-bezier", "h-bezier", "c-bspline", "h-bspline"};
    static const double tolerances[] = {0, 1e-3, 1e-9};
    for (int trial = 0; trial < random_trials(8); trial++) {
        const char *path = in_folder(endings[trial % 2]);
        const double tolerance = tolerances[trial % 3];
        taut_model *model = NULL, *back = NULL;
        double bound = -1;
        CHECK(taut_model_new(&model) == TAUT_OK, "model");
        add_quasi(model, types[random_int(0, 3)], types[random_int(0, 3)]);
        back = written_and_read(model, path, tolerance, &bound);
        CHECK(bound > 0 && bound <= (tolerance > 0 ? tolerance : 1e-6) * 35, "bound %g", bound);
        if (back != NULL && taut_model_surface_count(back) == 1) {
            check_distance(taut_model_surface(model, 0), taut_model_surface(back, 0), bound, path);
        }
        taut_model_free(model);
        taut_model_free(back);
    }
}

/* The day of a second, as STEP and IGES write it. */
static void day_of(time_t now, char day[2][16])
{
    const struct tm *date = gmtime(&now);
    strftime(day[0], 16, "%Y-%m-%dT", date);
    strftime(day[1], 16, "15H%Y%m%d.", date);
}

/* Today's date; with SOURCE_DATE_EPOCH that, and the same bytes whenever it is written. */
static void test_same_bytes(void)
{
    taut_model *model = NULL;
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    add_some_surface(model, "one");
    setenv("SOURCE_DATE_EPOCH", "86400", 1);
    for (int e = 0; e < 2; e++) {
        const char *path = in_folder(endings[e]);
        size_t lengths[2];
        char *bytes[2];
        for (int k = 0; k < 2; k++) {
            CHECK(taut_model_write(model, path, NULL, NULL) == TAUT_OK, "%s", path);
            bytes[k] = file_bytes(path, &lengths[k]);
        }
        CHECK(lengths[0] == lengths[1] && memcmp(bytes[0], bytes[1], lengths[0]) == 0, "%s", path);
        CHECK(strstr(bytes[0], e == 0 ? "1970-01-02T00:00:00" : "19700102.000000") != NULL, "date");
        free(bytes[0]);
        free(bytes[1]);
    }
    unsetenv("SOURCE_DATE_EPOCH");
    for (int e = 0; e < 2; e++) {
        char day[2][2][16]; /* it may be midnight */
        day_of(time(NULL), day[0]);
        CHECK(taut_model_write(model, in_folder(endings[e]), NULL, NULL) == TAUT_OK, "date");
        day_of(time(NULL), day[1]);
        char *bytes = file_bytes(in_folder(endings[e]), NULL);
        CHECK(strstr(bytes, day[0][e]) != NULL || strstr(bytes, day[1][e]) != NULL, "today");
        free(bytes);
    }
    taut_model_free(model);
}

/* Degree 26 is more than the library has: told before a file is there. */
static void test_degree(void)
{
    taut_basis_spec spec = {.type = "bezier", .degree = 26};
    taut_basis *basis = NULL;
    taut_curve *curve = NULL;
    taut_model *model = NULL;
    double *points = numbers_in(3 * 27, -1, 1);
    CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_curve_new("high", basis, points, NULL, &curve, NULL) == TAUT_OK, "curve");
    CHECK(taut_model_new(&model) == TAUT_OK && taut_model_add_curve(model, curve) == TAUT_OK,
          "add");
    for (int e = 0; e < 2; e++) {
        taut_error error = {.status = TAUT_OK};
        const char *path = in_folder(e == 0 ? "high.step" : "high.igs");
        CHECK(taut_model_write(model, path, NULL, &error) == TAUT_NO_SOLUTION, "%s", path);
        CHECK(strcmp(error.reason, "degree") == 0, "%s", error.message);
        CHECK(access(path, F_OK) != 0, "%s is there", path);
    }
    taut_basis_free(basis);
    taut_model_free(model);
    free(points);
}

/* A model, or a refusal that says why; never anything else. */
static int is_refused(const char *path)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    const taut_status status = taut_model_read(path, &model, &error);
    CHECK(status == TAUT_OK || status == TAUT_BAD_INPUT || status == TAUT_IO, "%s: %d %s", path,
          (int)status, error.message);
    CHECK(status == TAUT_OK || (error.status == status && error.message[0] != '\0'), "%s", path);
    CHECK((status == TAUT_OK) == (model != NULL), "%s", path);
    taut_model_free(model);
    return status != TAUT_OK;
}

/* Cut off anywhere, a file is refused; with bytes changed it is at least no disaster. */
static void test_broken(void)
{
    taut_model *model = NULL;
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    add_some_surface(model, "one");
    add_some_curve(model, "two");
    for (int e = 0; e < 2; e++) {
        const char *path = in_folder(endings[e]);
        const char *broken = in_folder(e == 0 ? "broken.step" : "broken.igs");
        size_t length = 0;
        char *bytes = NULL;
        CHECK(taut_model_write(model, path, NULL, NULL) == TAUT_OK, "%s", path);
        bytes = file_bytes(path, &length);
        for (int k = 0; k < 6; k++) {
            const size_t cut = (length - 2) * (size_t)k / 5; /* the last byte is a line's end */
            file_put(broken, bytes, cut);
            CHECK(is_refused(broken), "%s: cut at %zu of %zu", broken, cut, length);
        }
        for (int k = 0; k < random_trials(8); k++) {
            char *changed = malloc(length);
            memcpy(changed, bytes, length);
            for (int n = random_int(1, 6); n > 0; n--) {
                changed[(size_t)random_in(0, (double)length)] =
                    "0123456789,;()#E+-'$*\n A\377"[random_int(0, 24)];
            }
            file_put(broken, changed, length);
            is_refused(broken);
            free(changed);
        }
        free(bytes);
    }
    taut_model_free(model);
}

/* A file that lies: every `from` becomes `to`. */
typedef struct lie {
    int ending;
    const char *from, *to;
} lie;

static const lie lies[] = {
    {0, "OPEN_SHELL('',(#58))", "OPEN_SHELL('',(#67))"}, /* its own part */
    {0, "(#14,#68)", "(#14,#900)"},                      /* with mapped_cycle: maps itself */
    {0, "2),(2,2),", "2),(9,2),"},                       /* of knots */
    {0, "2),(2,2),", "2),(1999999999,2),"},
    {0, "(0.,0.,2.5)", "(0.,0.,NAN)"},
    {0, "(0.,0.,2.5)", "(0.,0.,1.E999)"},
    {0, "(0.,0.,2.5)", "(0.,0.,#10)"},
    {0, "B_SPLINE_SURFACE_WITH_KNOTS('',1", "B_SPLINE_SURFACE_WITH_KNOTS('',9"},
    {0, "END-ISO", "end_iso"},
    {1, "128,1,1,1,1,0,0,1,0,0,", "128,9,9,1,1,0,0,1,0,0,"},
    {1, "128,1,1,1,1,0,0,1,0,0,", "128,1999999999,9,1,1,0"},
    {1, "2.5000000000000000E+00", "NAN                   "},
    {1, "2.5000000000000000E+00", "2.5000000000000000E999"},
    {1, "     128       2 ", "     128     999 "},
    {1, "D      4P", "D      6P"},
};

/* The text with all of `from` replaced, and, before the data end, two entities more. */
static size_t tell_lie(const lie *told, const char *bytes, char *changed, size_t room)
{
    static const char mapped_cycle[] =
        "#900=MAPPED_ITEM('',#901,#14);\n#901=REPRESENTATION_MAP(#14,#69);\n";
    const char *last = strstr(bytes, "ENDSEC;\nEND-ISO");
    size_t n = 0;
    int found = 0;
    while (*bytes != '\0' && n + 200 < room) {
        if (bytes == last) {
            n += (size_t)snprintf(changed + n, room - n, "%s", mapped_cycle);
        }
        if (strncmp(bytes, told->from, strlen(told->from)) == 0) {
            n += (size_t)snprintf(changed + n, room - n, "%s", told->to);
            bytes += strlen(told->from);
            found++;
        } else {
            changed[n++] = *bytes++;
        }
    }
    CHECK(found > 0 && *bytes == '\0', "\"%s\" has no place", told->from);
    return n;
}

/* Each lie is refused, however long its numbers would take to be believed. */
static void test_lies(void)
{
    enum { ROOM = 1 << 16 };
    const double points[4][3] = {{0, 0, 2.5}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}};
    const taut_basis_spec spec = {.type = "bezier", .degree = 1};
    taut_model *model = NULL;
    taut_basis *basis = NULL;
    taut_surface *surface = NULL;
    char *changed = malloc(ROOM);
    CHECK(taut_model_new(&model) == TAUT_OK && taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK &&
              taut_surface_new("lie", basis, basis, &points[0][0], NULL, &surface, NULL) ==
                  TAUT_OK &&
              taut_model_add_surface(model, surface) == TAUT_OK,
          "model");
    for (int i = 0; i < (int)(sizeof lies / sizeof lies[0]); i++) {
        const char *path = in_folder(lies[i].ending == 0 ? "lies.step" : "lies.igs");
        size_t length = 0;
        char *bytes = NULL;
        CHECK(taut_model_write(model, path, NULL, NULL) == TAUT_OK, "%s", path);
        bytes = file_bytes(path, &length);
        bytes[length] = '\0';
        file_put(path, changed, tell_lie(&lies[i], bytes, changed, ROOM));
        CHECK(is_refused(path), "lie %d is believed: \"%s\"", i, lies[i].to);
        free(bytes);
    }
    free(changed);
    taut_basis_free(basis);
    taut_model_free(model);
}

static void test_no_files(void)
{
    file_put(in_folder("empty.step"), "", 0);
    file_put(in_folder("noise.igs"), "not a drawing\n", 14);
    CHECK(is_refused(in_folder("empty.step")), "empty");
    CHECK(is_refused(in_folder("noise.igs")), "noise");
    CHECK(is_refused(in_folder("missing.step")), "missing");
    CHECK(taut_model_read(in_folder(""), NULL, NULL) == TAUT_BAD_ARGUMENT, "NULL");
}

/* Was OpenCASCADE there when this was built? Where nothing may be left out it must be. */
static int is_there(void)
{
    const char *required = getenv("TAUT_REQUIRE");
    taut_error error = {.status = TAUT_OK};
    taut_model *model = NULL;
    taut_status status = TAUT_OK;
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    add_some_curve(model, "");
    status = taut_model_write(model, in_folder("probe.igs"), NULL, &error);
    taut_model_free(model);
    if (status == TAUT_IO && strcmp(error.reason, "not-installed") == 0) {
        CHECK(required == NULL || strcmp(required, "all") != 0, "%s", error.message);
        printf("left out: OpenCASCADE is not here: tools/deps.sh test, and build anew\n");
        return 0;
    }
    CHECK(status == TAUT_OK, "%s", error.message);
    return status == TAUT_OK;
}

/* A surface that is one point: IGES gives it back, STEP would not and says so; points of different
 * places that are near each other are given back by both. */
static void test_point(void)
{
    for (int k = 0; k < 2; k++) {
        const double near = k == 0 ? 0 : 1e-12;
        const double points[12] = {1, 2, 3, 1, 2 + near, 3, 1 + near, 2, 3, 1 + near, 2 + near, 3};
        const char *const step = in_folder("point.step");
        taut_surface *surface =
            shape_surface(shape_bspline(1, 2), shape_bspline(1, 2), points, NULL);
        taut_model *model = NULL;
        taut_error error = {.status = TAUT_OK};

        CHECK(taut_model_new(&model) == TAUT_OK &&
                  taut_model_add_surface(model, surface) == TAUT_OK,
              "model");
        taut_model *back = written_and_read(model, in_folder("point.igs"), 0, NULL);
        CHECK(back != NULL && taut_model_surface_count(back) == 1, "iges, near %g", near);
        taut_model_free(back);
        if (k == 0) {
            CHECK(taut_model_write(model, step, NULL, &error) == TAUT_NO_SOLUTION &&
                      strcmp(error.reason, "single-point") == 0,
                  "%s", error.message);
            CHECK(access(step, F_OK) != 0, "nothing is left of it");
        } else {
            back = written_and_read(model, step, 0, NULL);
            CHECK(back != NULL && taut_model_surface_count(back) == 1, "step, near %g", near);
            taut_model_free(back);
        }
        taut_model_free(model);
    }
}

static void test_all(void)
{
    test_round_trip();
    test_closed();
    test_bound();
    test_same_bytes();
    test_degree();
    test_broken();
    test_lies();
    test_no_files();
    test_point();
}

int main(void)
{
    random_seed(20260305);
    folder_make();
    const int is_here = is_there();
    if (is_here) {
        test_all();
    }
    folder_remove();
    return check_failures != 0 ? 1 : is_here ? 0 : 77;
}
