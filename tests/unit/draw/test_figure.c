/* test_figure.c -- whole figures: their structure, that they repeat, hostile models, faults.
 *
 * needs: cairo
 */
#include "check.h"
#include "cloths.h"
#include "shapes.h"

#include "draw/figure.h"
#include "platform/system.h"

#include <stdlib.h>
#include <string.h>

/* Under LeakSanitizer: fontconfig keeps its configuration, once, to the end of the process. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:libfontconfig";
}

static const char *const kinds[] = {"svg", "pdf", "png"};

static taut_surface *patch(const char *name, int degree, const double *points,
                           const double *weights)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = degree};
    taut_basis *basis = NULL;
    taut_surface *surface = NULL;
    CHECK(taut_basis_new(&spec, degree + 1, &basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_surface_new(name, basis, basis, points, weights, &surface, NULL) == TAUT_OK,
          "surface %s", name);
    taut_basis_free(basis);
    return surface;
}

/* Enneper's surface (u - u^3/3 + u v^2, v - v^3/3 + v u^2, u^2 - v^2) over [-1, 1]^2 in Bernstein
 * form: the coefficients of 1, t, t^2, t^3 on [-1, 1] in degree 3 are below. */
static taut_surface *enneper(void)
{
    static const double t1[4] = {-1, -1.0 / 3, 1.0 / 3, 1}, t2[4] = {1, -1.0 / 3, -1.0 / 3, 1};
    static const double t3[4] = {-1, 1, -1, 1};
    double points[16][3];
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            points[4 * i + j][0] = t1[i] - t3[i] / 3 + t1[i] * t2[j];
            points[4 * i + j][1] = t1[j] - t3[j] / 3 + t1[j] * t2[i];
            points[4 * i + j][2] = t2[i] - t2[j];
        }
    }
    return patch("Enneper", 3, &points[0][0], NULL);
}

/* The figure in memory, ended by a 0; 64 zeros when it failed. The caller frees it. */
static char *draw(const taut_model *model, const taut_write_options *options, const char *kind,
                  size_t *size, taut_status expected)
{
    char *bytes = NULL;
    FILE *out = taut_system_spool(&bytes, size);
    taut_error error = {.status = TAUT_OK};
    const taut_status status = taut_draw_figure(model, options, kind, out, &error);
    CHECK(taut_system_spooled(out, &bytes, size) == 0, "%s", kind);
    CHECK(status == expected, "%s: %s, %s", kind, taut_status_text(status), error.message);
    CHECK(status == TAUT_OK || (error.status == status && error.message[0] != '\0'), "%s says why",
          kind);
    if (status != TAUT_OK) {
        free(bytes);
        bytes = calloc(64, 1);
        *size = 64;
    }
    return bytes;
}

/* Draws what must work and forgets it; vectors in all colours, PNG (slower) in one. */
static void draw_all_ways(const taut_model *model, const char *what)
{
    for (int k = 0; k < 3; k++) {
        for (int colour = k == 2 ? 2 : 0; colour < 3; colour++) {
            const taut_write_options options = {.colour = (taut_colour)colour};
            size_t size = 0;
            char *bytes = draw(model, &options, kinds[k], &size, TAUT_OK);
            CHECK(size > 500, "%s as %s: %zu bytes", what, kinds[k], size);
            CHECK(k > 0 || (strstr(bytes, "nan") == NULL && strstr(bytes, "inf") == NULL),
                  "%s: every number is one", what);
            free(bytes);
        }
    }
}

static unsigned big_endian(const char *at)
{
    const unsigned char *b = (const unsigned char *)at;
    return (unsigned)b[0] << 24 | (unsigned)b[1] << 16 | (unsigned)b[2] << 8 | b[3];
}

static void test_png(void)
{
    taut_model *model = shape_model(enneper());
    size_t size = 0;
    char *png = draw(model, NULL, "png", &size, TAUT_OK);
    CHECK(size > 1000 && memcmp(png, "\x89PNG\r\n\x1a\n", 8) == 0, "signature");
    CHECK(memcmp(png + 12, "IHDR", 4) == 0, "header first");
    CHECK(big_endian(png + 16) == 1200 && big_endian(png + 20) > 600 && big_endian(png + 20) < 1200,
          "%u by %u", big_endian(png + 16), big_endian(png + 20));
    CHECK(memcmp(png + size - 8, "IEND", 4) == 0, "whole");
    free(png);
    taut_model_free(model);
}

static int holds(const char *bytes, size_t size, const char *text)
{
    const size_t length = strlen(text);
    for (size_t i = 0; i + length <= size; i++) {
        if (memcmp(bytes + i, text, length) == 0) {
            return 1;
        }
    }
    return 0;
}

static void test_pdf(void)
{
    taut_model *model = shape_model(enneper());
    const taut_write_options options = {.title = "A title"};
    size_t size = 0;
    char *pdf = NULL;

    unsetenv("SOURCE_DATE_EPOCH");
    pdf = draw(model, &options, "pdf", &size, TAUT_OK);
    CHECK(memcmp(pdf, "%PDF-", 5) == 0, "header");
    CHECK(memcmp(pdf + size - 6, "%%EOF", 5) == 0, "whole");
    CHECK(holds(pdf, size, "(A title)"), "title");
    CHECK(!holds(pdf, size, "CreationDate"), "no date but a given one");
    free(pdf);
    setenv("SOURCE_DATE_EPOCH", "951782400", 1); /* 2000-02-29 */
    pdf = draw(model, NULL, "pdf", &size, TAUT_OK);
    CHECK(holds(pdf, size, "20000229"), "the date given");
    free(pdf);
    unsetenv("SOURCE_DATE_EPOCH");
    taut_model_free(model);
}

/* Tags closed in order, attributes quoted, references known: enough of XML for what is written. */
static void check_well_formed(const char *svg)
{
    char open[16][16];
    int depth = 0;
    for (const char *p = svg; *p != '\0'; p++) {
        if (*p == '&') {
            CHECK(strncmp(p, "&lt;", 4) == 0 || strncmp(p, "&gt;", 4) == 0 ||
                      strncmp(p, "&amp;", 5) == 0,
                  "%.20s", p);
        } else if (*p == '<' && p[1] == '/') {
            const char *name = depth > 0 ? open[--depth] : "";
            CHECK(strncmp(p + 2, name, strlen(name)) == 0 && p[2 + strlen(name)] == '>', "%.20s",
                  p);
        } else if (*p == '<') {
            const char *name = p + 1;
            int quotes = 0;
            for (; *p != '>' || quotes % 2 != 0; p++) {
                CHECK(*p != '\0', "a tag ends");
                quotes += *p == '"';
            }
            if (p[-1] != '/' && p[-1] != '?') {
                CHECK(depth < 16, "depth");
                snprintf(open[depth++], 16, "%.*s", (int)strcspn(name, " >"), name);
            }
        }
    }
    CHECK(depth == 0, "%d tags left open", depth);
}

static void test_svg(void)
{
    taut_model *model = shape_model(enneper());
    const taut_write_options options = {.colour = TAUT_COLOUR_GAUSSIAN, .title = "a < b & \"c\""};
    size_t size = 0;
    char *svg = draw(model, &options, "svg", &size, TAUT_OK);
    check_well_formed(svg);
    CHECK(strstr(svg, "Gaussian") != NULL && strstr(svg, "curvature K") != NULL, "label");
    CHECK(strstr(svg, "1/mm\xc2\xb2") != NULL, "unit");
    /* K = -4 / (1 + u^2 + v^2)^4 is -4 in the middle and nowhere above 0: so is the scale */
    CHECK(strstr(svg, ">0<") != NULL && strstr(svg, ">4<") == NULL &&
              strstr(svg, ">\xe2\x88\x92"
                          "4<") != NULL,
          "ends of scale");
    CHECK(strstr(svg, ">a &lt; b &amp; \"c\"</text>") != NULL, "title");
    CHECK(size < 400000, "%zu bytes", size);
    free(svg);

    const taut_write_options mean = {.colour = TAUT_COLOUR_MEAN, .no_net = 1};
    CHECK(taut_model_set_unit(model, "in") == TAUT_OK, "unit");
    svg = draw(model, &mean, "svg", &size, TAUT_OK);
    /* H = 0: the scale ends at the noise, 1e-9 / (8/3 / 2) rounded up to 1e-9, and shows none */
    CHECK(strstr(svg, "curvature H") != NULL && strstr(svg, "/in<") != NULL, "label");
    CHECK(strstr(svg, ">0 to rounding everywhere<") != NULL, "nothing but noise is said");
    CHECK(strstr(svg, ">\xc3\x97"
                      "10</text>") != NULL &&
              strstr(svg, ">\xe2\x88\x92"
                          "9</text>") != NULL,
          "the noise");
    CHECK(strstr(svg, "<circle") == NULL, "no net");
    free(svg);
    taut_model_free(model);
}

/* Every coordinate of every path is on the page. */
static void test_on_page(void)
{
    taut_model *model = shape_model(shape_octant(2));
    size_t size = 0;
    char *svg = draw(model, NULL, "svg", &size, TAUT_OK);
    int paths = 0;
    for (char *p = svg; (p = strstr(p, " d=\"M")) != NULL; paths++) {
        double x = strtod(p + 5, &p), y = strtod(p, &p);
        CHECK(x >= 0 && x <= 1200 && y >= 0 && y <= 900, "(%g, %g)", x, y);
        for (p += *p == 'l'; *p != 'z' && *p != '"';) {
            x += strtod(p, &p);
            y += strtod(p, &p);
            CHECK(x >= 0 && x <= 1200 && y >= 0 && y <= 900, "(%g, %g)", x, y);
        }
    }
    CHECK(paths > 1000, "%d paths", paths);
    free(svg);
    taut_model_free(model);
}

/* The same model and options give the same bytes, for any number of threads. */
static void test_repeats(void)
{
    taut_model *model = shape_model(shape_octant(2));
    for (int k = 0; k < 3; k++) {
        const taut_write_options one = {.colour = TAUT_COLOUR_MEAN, .threads = 1};
        const taut_write_options two = {.colour = TAUT_COLOUR_MEAN, .threads = 2};
        size_t size_a = 0, size_b = 0;
        char *a = draw(model, &one, kinds[k], &size_a, TAUT_OK);
        char *b = draw(model, &two, kinds[k], &size_b, TAUT_OK);
        CHECK(size_a == size_b && memcmp(a, b, size_a) == 0, "%s", kinds[k]);
        free(a);
        free(b);
    }
    taut_model_free(model);
}

static void draw_patch(const char *what, int degree, const double *points)
{
    taut_model *model = shape_model(patch(what, degree, points, NULL));
    draw_all_ways(model, what);
    taut_model_free(model);
}

static void test_degenerate(void)
{
    const double point[12] = {1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3};
    const double line[12] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3};
    const double collapsed[12] = {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1};
    const double huge[12] = {-1.7e308, 0, 0, 1.7e308, 0, 1e300, 0, 1.7e308, 0, 0, -1.7e308, 1e300};
    const double tiny[12] = {0, 0, 0, 5e-324, 0, 0, 0, 5e-324, 0, 0, 0, 5e-324};
    const double far[12] = {1e15, 0, 0, 1e15 + 1, 0, 0, 1e15, 1, 0, 1e15 + 1, 1, 1};
    const double flat[12] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0};
    const taut_write_options edge_on = {.has_view = 1, .view = {30, 0}};
    const taut_write_options above = {.has_view = 1, .view = {-720, 90}, .divide = 7};
    taut_model *model = shape_model(patch("flat", 1, flat, NULL));
    size_t size = 0;

    draw_patch("point", 1, point);
    draw_patch("line", 1, line);
    draw_patch("collapsed", 1, collapsed);
    draw_patch("huge", 1, huge);
    draw_patch("tiny", 1, tiny);
    draw_patch("far", 1, far);
    free(draw(model, &edge_on, "svg", &size, TAUT_OK));
    free(draw(model, &above, "svg", &size, TAUT_OK));
    taut_model_free(model);
    model = shape_model(shape_octant(2));
    draw_all_ways(model, "sphere");
    taut_model_free(model);
}

static int stop(void *context, double done, const char *what)
{
    (void)context;
    (void)what;
    return done >= 0;
}

static void test_refusals(void)
{
    const taut_write_options view = {.has_view = 1, .view = {(double)NAN, 0}};
    const taut_write_options steep = {.has_view = 1, .view = {0, 91}};
    const taut_write_options other = {.surface = "other"};
    const taut_write_options divide = {.divide = -1};
    const taut_write_options stopped = {.monitor = {stop, NULL}};
    taut_model *model = shape_model(enneper()), *empty = shape_model(NULL);
    size_t size = 0;
    free(draw(model, &view, "svg", &size, TAUT_BAD_ARGUMENT));
    free(draw(model, &steep, "svg", &size, TAUT_BAD_ARGUMENT));
    free(draw(model, &other, "svg", &size, TAUT_BAD_ARGUMENT));
    free(draw(model, &divide, "svg", &size, TAUT_BAD_ARGUMENT));
    free(draw(model, NULL, "gif", &size, TAUT_BAD_ARGUMENT));
    free(draw(model, &stopped, "svg", &size, TAUT_INTERRUPTED));
    free(draw(empty, NULL, "svg", &size, TAUT_BAD_ARGUMENT));
    CHECK(taut_draw_figure(NULL, NULL, "svg", stdout, NULL) == TAUT_BAD_ARGUMENT, "no model");
    taut_model_free(model);
    taut_model_free(empty);
}

/* Every way to draw, on what has edges, knots, a pole and nothing. */
static void test_options(void)
{
    static const char *const labels[] = {"first", "second", "third"};
    const double line[12] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3};
    taut_model *a = shape_model(enneper()), *b = shape_model(shape_octant(2)),
               *c = shape_model(patch("", 1, line, NULL));
    const taut_model *models[] = {a, b, c};
    size_t size = 0;
    char *svg = NULL;

    CHECK(taut_model_add_surface(a, shape_octant(2)) == TAUT_OK, "two surfaces");
    for (int colour = 0; colour < 4; colour++) {
        const taut_write_options options = {.colour = (taut_colour)colour,
                                            .isolines = 5,
                                            .divide = 6,
                                            .reflections = 9,
                                            .combs = 1,
                                            .side_by_side = colour % 2};
        for (int i = 0; i < 3; i++) {
            svg = draw(models[i], &options, "svg", &size, TAUT_OK);
            CHECK(strstr(svg, "nan") == NULL && strstr(svg, "inf") == NULL, "model %d", i);
            CHECK(strstr(svg, "the longest tooth") != NULL, "the scale of the combs is said");
            CHECK((strstr(svg, ">Enneper<") != NULL) ==
                      (i == 0 && (colour == 0 || colour % 2 == 1)),
                  "its name is there");
            free(svg);
        }
    }
    FILE *out = taut_system_spool(&svg, &size);
    CHECK(taut_draw_figures(3, models, &(taut_write_options){.labels = labels, .combs = 1}, "svg",
                            out, NULL) == TAUT_OK,
          "three models");
    CHECK(taut_system_spooled(out, &svg, &size) == 0, "three models");
    for (int i = 0; i < 3; i++) {
        CHECK(strstr(svg, labels[i]) != NULL, "%s", labels[i]);
    }
    CHECK(strstr(svg, "each model at its own scale") != NULL && strstr(svg, "at first") == NULL,
          "whose tooth is told");
    free(svg);
    CHECK(taut_draw_figures(0, models, NULL, "svg", stdout, NULL) == TAUT_BAD_ARGUMENT, "none");
    CHECK(taut_draw_figures(TAUT_MODELS_MAX + 1, models, NULL, "svg", stdout, NULL) ==
              TAUT_BAD_ARGUMENT,
          "too many");
    free(draw(a, &(taut_write_options){.isolines = -1}, "svg", &size, TAUT_BAD_ARGUMENT));
    free(draw(a, &(taut_write_options){.reflections = 101}, "svg", &size, TAUT_BAD_ARGUMENT));
    free(draw(a, &(taut_write_options){.width = 5000}, "png", &size, TAUT_BAD_ARGUMENT));
    free(draw(a, &(taut_write_options){.colour = (taut_colour)(TAUT_COLOUR_STRAIN + 1)}, "svg",
              &size, TAUT_BAD_ARGUMENT));
    svg = draw(a, &(taut_write_options){.width = 300}, "png", &size, TAUT_OK);
    CHECK(big_endian(svg + 16) == 300 && big_endian(svg + 20) > 100, "as wide as asked for");
    free(svg);
    taut_model_free(a);
    taut_model_free(b);
    taut_model_free(c);
}

/* The number after the text. */
static double number_after(const char *svg, const char *text)
{
    const char *at = strstr(svg, text);
    return at != NULL ? strtod(at + strlen(text), NULL) : -1;
}

/* The smallest letters, in points; 0 without any. */
static double least_letters(const char *svg)
{
    const double point = number_after(svg, " width=\"") / number_after(svg, "viewBox=\"0 0 ");
    double least = 0;
    for (const char *p = svg; (p = strstr(p, "font-size=\"")) != NULL; p++) {
        const double size = point * strtod(p + 11, NULL);
        least = least > 0 && least < size ? least : size;
    }
    return least;
}

/* A page is cropped to what is on it; a column is 88 mm wide and its letters can be read; the bar of the scale is as long as
 * its number says, measured on a line of known length; isolines have their values. */
static void test_page(void)
{
    static const double flat[12] = {0, 0, 0, 0, 10, 0, 200, 0, 0, 200, 10, 0}; /* 200 by 10 */
    taut_model *wide = shape_model(patch("wide", 1, flat, NULL)), *a = shape_model(enneper());
    const taut_write_options above = {.no_net = 1, .has_view = 1, .view = {-90, 90}};
    const taut_write_options column = {
        .column = 1, .colour = TAUT_COLOUR_GAUSSIAN, .isolines = 4, .title = "a title"};
    size_t size = 0;
    char *svg = draw(wide, &above, "svg", &size, TAUT_OK);

    CHECK_NEAR(number_after(svg, " width=\""), 600, 1e-9, "600 points");
    CHECK(number_after(svg, " height=\"") < 200, "no taller than what is on it");
    CHECK(strstr(svg, ">20 mm<") != NULL || strstr(svg, ">50 mm<") != NULL, "a scale bar");
    CHECK(strstr(svg, "<title>") != NULL && strstr(svg, "role=\"img\"") != NULL, "a title");
    free(svg);
    svg = draw(a, &column, "svg", &size, TAUT_OK);
    CHECK_NEAR(number_after(svg, " width=\""), 88 / 25.4 * 72, 0.01, "a column of 88 mm");
    CHECK(least_letters(svg) >= 6 - 0.01, "letters of %g point", least_letters(svg));
    CHECK(strstr(svg, ">\xe2\x88\x92"
                      "2.00<") != NULL,
          "a line's value");
    free(svg);
    svg = draw(a, &column, "pdf", &size, TAUT_OK);
    CHECK(holds(svg, size, "MediaBox [ 0 0 249.4"), "a PDF of the same width");
    free(svg);
    taut_model_free(wide);
    taut_model_free(a);
}

/* From the least to the largest number that follows the text. */
static double extent(const char *svg, const char *text)
{
    double low = 1e9, high = -1e9;
    for (const char *at = svg; (at = strstr(at, text)) != NULL; at++) {
        const double x = strtod(at + strlen(text), NULL);
        low = fmin(low, x);
        high = fmax(high, x);
    }
    return high - low;
}

/* A net is drawn while its middle point is near, and left out of picture and frame, with a word
 * about it, where that is far: the surface takes the page. It does not follow the point, whose
 * weight is next to nothing. */
static void test_far_net(void)
{
    static const double reach[3] = {1.5, 2.9, 1e6};
    for (int k = 0; k < 3; k++) {
        const double middle[3] = {reach[k], 0, 0};
        size_t size = 0;
        char *svg = NULL, *bare = NULL;
        taut_model *model = shape_model(shape_far_net(middle));
        svg = draw(model, &(taut_write_options){.divide = 4}, "svg", &size, TAUT_OK);
        bare = draw(model, &(taut_write_options){.divide = 4, .no_net = 1}, "svg", &size, TAUT_OK);
        CHECK((strstr(svg, "1 of 1 control nets left out") != NULL) == (k == 2), "reach %g",
              reach[k]);
        CHECK((strstr(svg, "<circle") != NULL) == (k < 2), "reach %g: points", reach[k]);
        CHECK(strstr(bare, "left out") == NULL, "reach %g: not asked for", reach[k]);
        CHECK(k < 2 || extent(svg, " d=\"M") == extent(bare, " d=\"M"),
              "reach %g: the frame is the surface's", reach[k]);
        free(svg);
        free(bare);
        taut_model_free(model);
    }
}

static void test_full_device(void)
{
    taut_model *model = shape_model(enneper());
    for (int k = 0; k < 3; k++) {
        FILE *full = fopen("/dev/full", "wb");
        taut_error error = {.status = TAUT_OK};
        if (full != NULL) {
            CHECK(taut_draw_figure(model, NULL, kinds[k], full, &error) == TAUT_IO, "%s", kinds[k]);
            CHECK(error.status == TAUT_IO && strcmp(error.reason, "write") == 0, "%s",
                  error.message);
            fclose(full);
        }
    }
    taut_model_free(model);
}

static taut_surface *square(const char *name, double x, double half, double height)
{
    const double points[4][3] = {{x - half, -half, height},
                                 {x - half, half, height},
                                 {x + half, -half, height},
                                 {x + half, half, height}};
    return patch(name, 1, points[0], NULL);
}

/* What is behind something else has no name, from above; from below it has. */
static void test_hidden_names(void)
{
    taut_model *model = shape_model(square("above", 0, 1, 1));
    CHECK(taut_model_add_surface(model, square("behind", 0, 0.5, 0)) == TAUT_OK, "behind");
    CHECK(taut_model_add_surface(model, square("beside", 3, 1, 0)) == TAUT_OK, "beside");
    for (int below = 0; below < 2; below++) {
        const taut_write_options options = {
            .has_view = 1, .view = {0, below ? -90 : 90}, .no_net = 1};
        size_t size = 0;
        char *svg = draw(model, &options, "svg", &size, TAUT_OK);
        CHECK(strstr(svg, ">above<") != NULL && strstr(svg, ">beside<") != NULL, "below %d", below);
        CHECK((strstr(svg, ">behind<") != NULL) == below, "below %d", below);
        free(svg);
    }
    taut_model_free(model);
}

/* Pieces of a saddle in the colours of their strains: red along the seams, which are tight, and blue in the middle; the surface grey. */
static void test_strain(void)
{
    size_t size = 0;
    made_cloth made =
        cloth_make(SADDLE, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }]");
    CHECK(made.status == TAUT_OK, "%s", made.error.message);
    char *svg = draw(made.model, &(taut_write_options){.colour = TAUT_COLOUR_STRAIN, .no_net = 1},
                     "svg", &size, TAUT_OK);
    int red = 0, blue = 0;
    for (const char *at = svg; at != NULL && (at = strstr(at, "fill=\"#")) != NULL; at++) {
        const unsigned long ink = strtoul(at + 7, NULL, 16);
        const int r = (int)(ink >> 16), b = (int)(ink & 255);
        red += r > b + 60;
        blue += b > r + 60;
    }
    CHECK(red > 50 && blue > 50, "%d red cells, %d blue ones", red, blue);
    CHECK(strstr(svg, ">\xe2\x88\x92") != NULL, "a scale of both signs"); /* a minus */
    CHECK(svg != NULL && strstr(svg, "larger principal") != NULL &&
              strstr(svg, "undefined") != NULL,
          "the legend");
    free(svg);
    cloth_free(&made);
}

int main(void)
{
    test_strain();
    test_png();
    test_pdf();
    test_svg();
    test_on_page();
    test_page();
    test_repeats();
    test_degenerate();
    test_refusals();
    test_options();
    test_far_net();
    test_full_device();
    test_hidden_names();
    return check_failures != 0;
}
