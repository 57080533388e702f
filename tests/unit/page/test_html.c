/* test_html.c -- what a page is made of: packed numbers come back, hostile names stay inside, sizes
 * are bounded, what is dropped is said. */
#include "check.h"
#include "shapes.h"

#include "core/memory.h"
#include "page/html_page.h"

#include <stdlib.h>
#include <string.h>

/* Octahedral normals come back to within the 16 bits they are kept in: the unfolding stretches a
 * step of 1/32767 by at most 3. */
static void test_normals(void)
{
    for (int trial = 0; trial < 20000; trial++) {
        double n[3] = {random_in(-1, 1), random_in(-1, 1), random_in(-1, 1)};
        const double size = hypot(hypot(n[0], n[1]), n[2]);
        int16_t packed[2];
        for (int c = 0; c < 3; c++) {
            n[c] /= size;
        }
        taut_page_normal(n, packed);
        double a = packed[0] / 32767.0, b = packed[1] / 32767.0;
        const double z = 1 - fabs(a) - fabs(b);
        if (z < 0) {
            const double folded = (1 - fabs(b)) * (a < 0 ? -1 : 1);
            b = (1 - fabs(a)) * (b < 0 ? -1 : 1);
            a = folded;
        }
        const double length = hypot(hypot(a, b), z);
        CHECK_NEAR(hypot(hypot(a / length - n[0], b / length - n[1]), z / length - n[2]), 0,
                   3 / 32767.0, "%g %g %g", n[0], n[1], n[2]);
    }
    int16_t none[2] = {0, 0};
    taut_page_normal((const double[3]){nan(""), 0, 0}, none);
    CHECK(none[0] == INT16_MIN && none[1] == INT16_MIN, "no normal");
}

static void test_values(void)
{
    CHECK(taut_page_value(nan(""), 2) == INT16_MIN, "no value");
    CHECK(taut_page_value(2.5, 2) == 32767 && taut_page_value(-INFINITY, 2) == -32767, "beyond");
    CHECK(taut_page_value(2, 2) == 32766 && taut_page_value(-1, 2) == -16383, "within");
    CHECK(taut_page_value(1e308, 1e308) == 32766, "large");
}

/* Every so many and the last, none twice. */
static void test_kept(void)
{
    for (int count = 1; count < 40; count++) {
        for (int every = 1; every < 45; every++) {
            const int kept = taut_page_kept(count, every);
            CHECK(taut_page_kept_at(count, every, 0) == 0, "%d %d first", count, every);
            CHECK(taut_page_kept_at(count, every, kept - 1) == count - 1, "%d %d last", count,
                  every);
            for (int i = 1; i < kept; i++) {
                const int gap =
                    taut_page_kept_at(count, every, i) - taut_page_kept_at(count, every, i - 1);
                CHECK(gap >= 1 && gap <= every, "%d %d gap %d", count, every, gap);
            }
        }
    }
}

static char *data_of(const taut_model *model, const taut_write_options *options, size_t *length)
{
    char *text = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_html_data(model, options, &text, length, &error) == TAUT_OK, "%s", error.message);
    return text;
}

static taut_model *frames(int count, int n)
{
    double *points = calloc(3 * (size_t)n * (size_t)n, sizeof(double));
    taut_model *model = NULL;
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    for (int f = 0; f < count; f++) {
        for (int i = 0; i < n * n; i++) {
            points[3 * i] = i / n;
            points[3 * i + 1] = i % n;
            points[3 * i + 2] = sin(0.1 * (i / n) + 0.2 * f) * cos(0.13 * (i % n));
        }
        CHECK(taut_model_add_surface(model, shape_surface(shape_bspline(3, n), shape_bspline(3, n),
                                                          points, NULL)) == TAUT_OK,
              "frame %d", f);
    }
    free(points);
    return model;
}

/* Two hundred frames of 100 by 100 points: 10 MB at the most with the page's scripts, and it says
 * that the net and the knots are thinned; one small surface says nothing. */
static void test_sizes(void)
{
    const taut_write_options options = {.title = ""};
    taut_model *large = frames(random_trials(200), 100), *small = frames(1, 6);
    size_t length = 0;
    char *text = data_of(large, &options, &length);
    CHECK(length < 9000000, "%zu bytes", length);
    CHECK(strstr(text, "coarser than its knots") != NULL, "knots are thinned");
    CHECK(strstr(text, "one point in") != NULL, "the net is thinned");
    taut_free(text);
    text = data_of(small, &options, &length);
    CHECK(length < 700000, "%zu bytes", length);
    CHECK(strstr(text, "\"dropped\": []") != NULL, "nothing is dropped");
    taut_free(text);
    taut_model_free(large);
    taut_model_free(small);
}

/* Extreme coordinates give finite numbers and no failure. */
static void test_extremes(void)
{
    static const double huge[4][3] = {
        {-1.7e308, 0, 0}, {1.7e308, 0, 1e300}, {0, 1.7e308, 0}, {0, -1.7e308, 1e300}};
    static const double point[4][3] = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    const double *nets[] = {&huge[0][0], &point[0][0]};
    for (int k = 0; k < 2; k++) {
        taut_model *model = NULL;
        size_t length = 0;
        CHECK(taut_model_new(&model) == TAUT_OK, "model");
        CHECK(taut_model_add_surface(model, shape_surface(shape_bezier(1, 0, 1),
                                                          shape_bezier(1, 0, 1), nets[k], NULL)) ==
                  TAUT_OK,
              "add");
        char *text = data_of(model, &(taut_write_options){.title = NULL}, &length);
        CHECK(strstr(text, "nan") == NULL && strstr(text, "inf") == NULL, "net %d", k);
        taut_free(text);
        taut_model_free(model);
    }
    taut_model *empty = NULL;
    char *text = NULL;
    size_t length = 0;
    CHECK(taut_model_new(&empty) == TAUT_OK, "model");
    CHECK(taut_html_data(empty, &(taut_write_options){.title = NULL}, &text, &length, NULL) ==
                  TAUT_BAD_ARGUMENT &&
              text == NULL,
          "nothing to show");
    taut_model_free(empty);
}

/* A net far beyond its surface is left out, frames nothing, and the page says so. */
static void test_far_net(void)
{
    for (int k = 0; k < 2; k++) {
        const double middle[3] = {0, 0, k == 0 ? 2.9 : 1e6};
        size_t length = 0;
        taut_model *model = shape_model(shape_far_net(middle));
        char *text = data_of(model, &(taut_write_options){.title = NULL}, &length);
        CHECK((strstr(text, "1 of 1 control nets left out") != NULL) == (k == 1), "reach %d", k);
        CHECK((strstr(text, "\"nu\": 3") != NULL) == (k == 0), "reach %d: points", k);
        CHECK((strstr(text, "\"nu\": 0") != NULL) == (k == 1), "reach %d: no points", k);
        CHECK(strstr(text, k == 0 ? "\"half\": 1.45," : "\"half\": 1,") != NULL, "frame %d", k);
        taut_free(text);
        taut_model_free(model);
    }
}

int main(void)
{
    random_seed(20261121);
    test_normals();
    test_values();
    test_kept();
    test_sizes();
    test_extremes();
    test_far_net();
    return check_failures != 0;
}
