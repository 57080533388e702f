/* test_record.c -- the members of the documents, and null where a figure is undefined. */
#include "check.h"
#include "shapes.h"

#include "taut/measure.h"

#include <string.h>

static const taut_record *member(const taut_record *record, const char *path)
{
    char key[64];
    while (*path != '\0') {
        const size_t length = strcspn(path, "/");
        memcpy(key, path, length);
        key[length] = '\0';
        record = taut_record_get(record, key);
        path += length + (path[length] == '/');
    }
    return record;
}

static void check_kind(const taut_record *record, const char *path, taut_record_kind kind)
{
    const taut_record *found = member(record, path);
    CHECK(found != NULL, "no %s", path);
    CHECK(taut_record_kind_of(found) == kind, "%s: kind %d", path, (int)taut_record_kind_of(found));
}

static taut_record *record_of(const taut_surface *surface)
{
    taut_record *record = taut_record_new();
    taut_surface_measure m;
    CHECK(taut_measure_surface(surface, NULL, &m, NULL) == TAUT_OK, "measure");
    taut_measure_surface_record(surface, &m, record);
    CHECK(taut_record_status(record) == TAUT_OK, "record");
    return record;
}

static void test_surface(void)
{
    static const char *const numbers[] = {"area",
                                          "dirichlet_energy",
                                          "bending_energy",
                                          "isothermality/max_e_minus_g",
                                          "isothermality/max_f",
                                          "isothermality/integral",
                                          "harmonicity/max_abs_laplacian",
                                          "edges/u0/length",
                                          "edges/u1/length",
                                          "edges/v0/length",
                                          "edges/v1/length",
                                          "singular_points"};
    static const char *const normals[] = {"mean_curvature/max_abs",
                                          "mean_curvature/mean_abs",
                                          "gaussian_curvature/min",
                                          "gaussian_curvature/max",
                                          "edges/u0/max_abs_normal_curvature",
                                          "edges/v1/max_abs_normal_curvature"};
    const double points[4][3] = {{0}};
    taut_surface *surfaces[2] = {
        shape_saddle(1),
        shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), points[0], NULL)};
    for (int s = 0; s < 2; s++) {
        taut_record *record = record_of(surfaces[s]);
        const taut_record *box = taut_record_get(record, "bounding_box");
        CHECK(strcmp(taut_record_key(record, 0), "name") == 0, "name comes first");
        CHECK(strcmp(taut_record_text(taut_record_get(record, "name")), "shape") == 0, "name");
        for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) {
            check_kind(record, numbers[k], TAUT_RECORD_NUMBER);
        }
        for (size_t k = 0; k < sizeof normals / sizeof *normals; k++) {
            check_kind(record, normals[k], s == 0 ? TAUT_RECORD_NUMBER : TAUT_RECORD_NULL);
        }
        check_kind(record, "edges/u1/max_angle_normal_binormal", TAUT_RECORD_NULL);
        CHECK(taut_record_count(box) == 2 && taut_record_count(taut_record_at(box, 1)) == 3, "box");
        CHECK(taut_record_number(taut_record_at(taut_record_at(box, 1), 2)) == (s == 0), "box");
        CHECK(taut_record_get(record, "area_error") == NULL, "only where it is needed");
        taut_record_free(record);
        taut_surface_free(surfaces[s]);
    }
}

static void test_curve(void)
{
    const double line[6] = {0, 0, 0, 1, 2, 2};
    taut_curve *curve = shape_curve(shape_bezier(1, 0, 1), line, NULL);
    taut_record *record = taut_record_new();
    taut_curve_measure m;
    CHECK(taut_measure_curve(curve, NULL, &m, NULL) == TAUT_OK, "measure");
    taut_measure_curve_record(curve, &m, record);
    CHECK_NEAR(taut_record_number(taut_record_get(record, "length")), 3, 1e-15 * 3, "length");
    CHECK(taut_record_number(taut_record_get(record, "max_curvature")) == 0, "max_curvature");
    check_kind(record, "max_torsion", TAUT_RECORD_NULL);
    check_kind(record, "name", TAUT_RECORD_TEXT);
    taut_record_free(record);
    taut_curve_free(curve);
}

int main(void)
{
    test_surface();
    test_curve();
    return check_failures != 0;
}
