/* test_colour.c -- colours that mean what they should, numbers and words as they are written. */
#include "check.h"

#include "draw/camera.h"
#include "draw/label.h"
#include "mesh/colour.h"

#include <string.h>

/* Relative luminance of sRGB (IEC 61966-2-1), another road than the CIELAB the map is built in. */
static double luminance(taut_ink ink)
{
    const double part[3] = {0.2126, 0.7152, 0.0722};
    const unsigned char byte[3] = {ink.r, ink.g, ink.b};
    double sum = 0;
    for (int c = 0; c < 3; c++) {
        const double x = byte[c] / 255.0;
        sum += part[c] * (x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4));
    }
    return sum;
}

static double lightness(taut_ink ink)
{
    return 116 * cbrt(luminance(ink)) - 16;
}

/* Lightness 96 - 58 |t| on both arms. Bytes are rounded to half a step: at the dark end a step of
 * all three channels is 0.4 of lightness. */
static void test_map(void)
{
    for (int i = 0; i <= 200; i++) {
        const double t = i / 100.0 - 1;
        const taut_ink ink = taut_colour_diverging(t);
        CHECK_NEAR(lightness(ink), 96 - 58 * fabs(t), 0.4, "t=%g", t);
        if (fabs(t) > 0.05) {
            CHECK(t < 0 ? ink.b > ink.r : ink.r > ink.b, "t=%g %d %d %d", t, ink.r, ink.g, ink.b);
        }
    }
    const taut_ink grey = taut_colour_diverging((double)NAN);
    CHECK(grey.r == grey.g && grey.g == grey.b, "NaN is grey");
    CHECK(taut_colour_diverging(7).r == taut_colour_diverging(1).r, "cut off above");
    CHECK(taut_colour_diverging(-INFINITY).b == taut_colour_diverging(-1).b, "cut off below");
}

static void test_shade(void)
{
    const taut_ink ink = {166, 198, 230};
    const double facing[3] = {0, 0, 1}, away[3] = {0.9, -0.43, 0.05};
    CHECK(luminance(taut_colour_shade(ink, facing, 1)) > luminance(taut_colour_shade(ink, away, 1)),
          "the side away from the light is darker");
    for (int i = 0; i < 200; i++) {
        const double n[3] = {random_in(-1, 1), random_in(-1, 1), random_in(0.01, 1)};
        const taut_ink none = taut_colour_shade(ink, n, 0);
        CHECK(none.r == ink.r && none.g == ink.g && none.b == ink.b, "strength 0");
    }
}

/* The limit holds every value unless it says so, and is never far above what is needed. */
static void test_limit(void)
{
    for (int trial = 0; trial < 200; trial++) {
        const double scale = random_log(1e-200, 1e200);
        double values[100], most = 0;
        int cut = 7;
        for (int i = 0; i < 100; i++) {
            values[i] = scale * random_in(-1, 1);
            most = fmax(most, fabs(values[i]));
        }
        const double limit = taut_colour_limit(100, values, scale * 1e-9, &cut);
        CHECK(cut == 0 && limit >= most * (1 - 1e-9) && limit <= 1.1 * most + 1e-9 * scale,
              "limit=%g most=%g cut=%d", limit, most, cut);
    }
    double spike[100] = {0}, none[2] = {(double)NAN, INFINITY};
    int cut = 0;
    for (int i = 0; i < 99; i++) {
        spike[i] = i % 2 ? 0.5 : -0.5;
    }
    spike[99] = 1e6;
    CHECK_NEAR(taut_colour_limit(100, spike, 1e-9, &cut), 0.5, 0, "a spike is cut off");
    CHECK(cut == 1, "and said to be");
    CHECK_NEAR(taut_colour_limit(2, none, 0.125, &cut), 0.13, 1e-15, "nothing but noise");
    CHECK(cut == 0, "nothing cut");
}

static void check_fixed(double value, int decimals, const char *expected)
{
    char text[32];
    taut_label_fixed(value, decimals, text, sizeof text);
    CHECK(strcmp(text, expected) == 0, "%g: found %s, expected %s", value, text, expected);
}

static void check_clean(const char *from, size_t most, const char *expected)
{
    char text[32];
    taut_label_clean(from, most, text, sizeof text);
    CHECK(strcmp(text, expected) == 0, "%s: found %s, expected %s", from, text, expected);
}

static void test_labels(void)
{
    check_fixed(0, 0, "0");
    check_fixed(-0.0001, 2, "0.00");
    check_fixed(-1.5, 1,
                "\xe2\x88\x92"
                "1.5");
    check_fixed(0.045, 3, "0.045");
    check_fixed(12, 2, "12.00");
    check_fixed(999.999, 2, "1000.00");
    check_clean("plain", 10, "plain");
    check_clean("a\tb\x7f", 10, "a?b?");
    check_clean("\xc3\xa9\xe2\x82\xac", 10, "\xc3\xa9\xe2\x82\xac");
    check_clean("\xc3", 10, "?");
    check_clean("\xc0\xaf", 10, "??");           /* overlong */
    check_clean("\xed\xa0\x80", 10, "???");      /* a surrogate */
    check_clean("\xef\xbf\xbf", 10, "?");        /* no character of XML */
    check_clean("\xf4\x90\x80\x80", 10, "????"); /* above U+10FFFF */
    check_clean("abcdef", 4, "abc\xe2\x80\xa6"); /* too many letters */
    check_clean("abcd", 4, "abcd");
    for (int trial = 0; trial < 2000; trial++) {
        char from[64], text[16];
        const int length = random_int(0, 63);
        for (int i = 0; i < length; i++) {
            from[i] = (char)random_int(1, 255);
        }
        from[length] = '\0';
        taut_label_clean(from, 50, text, sizeof text);
        CHECK(strlen(text) < sizeof text, "length %d", length);
    }
}

/* The frame of the camera is orthonormal and right-handed; depth and page are what it says. */
static void test_camera(void)
{
    for (int trial = 0; trial < 500; trial++) {
        const double corner[6] = {-1, -2, -3, 4, 5, 6};
        const double frame[4] = {0, 0, 100, 100};
        taut_camera camera;
        taut_camera_init(&camera);
        taut_camera_include(&camera, 2, corner);
        CHECK(taut_camera_settle(&camera), "a box");
        taut_camera_aim(&camera, random_in(-360, 360), random_in(-90, 90));
        taut_camera_see(&camera, 2, corner);
        taut_camera_fit(&camera, frame);
        const double *r = camera.right, *u = camera.up, *e = camera.eye;
        for (int c = 0; c < 3; c++) {
            const int d = (c + 1) % 3, f = (c + 2) % 3;
            CHECK_NEAR(r[d] * u[f] - r[f] * u[d], e[c], 4e-16, "right x up = eye");
        }
        CHECK(u[2] >= 0, "z is up");
        for (int i = 0; i < 2; i++) {
            double page[3];
            taut_camera_project(&camera, corner + 3 * i, page);
            CHECK(page[0] >= -1e-9 && page[0] <= 100 + 1e-9 && page[1] >= -1e-9 &&
                      page[1] <= 100 + 1e-9,
                  "(%g, %g) in the frame", page[0], page[1]);
        }
    }
}

static const char *name_of(const void *of, int i)
{
    return ((const char *const *)of)[i];
}

/* Names that differ in their number share a colour; pipes and bends have theirs in every model. */
static void test_groups(void)
{
    static const char *const run[] = {"blend1", "pipe1", "pipe2", "blend2", "cap", "cap7"};
    static const int run_groups[] = {1, 0, 0, 1, 2, 2};
    static const char *const parts[] = {"p", "", "extension", "h2", "p3", "7", ""};
    static const int part_groups[] = {0, 1, 2, 3, 0, 4, 5};
    for (int i = 0; i < 6; i++) {
        CHECK(taut_colour_group(name_of, run, 6, i) == run_groups[i], "%s: %d", run[i],
              taut_colour_group(name_of, run, 6, i));
    }
    static const char *const films[] = {"a", "a'", "a''12", "b", "b.u0", "a.u1", "a.v1"};
    static const int film_groups[] = {0, 0, 0, 1, 2, 2, 3};
    for (int i = 0; i < 7; i++) {
        CHECK(taut_colour_group(name_of, films, 7, i) == film_groups[i], "%s", films[i]);
    }
    for (int i = 0; i < 7; i++) {
        CHECK(taut_colour_group(name_of, parts, 7, i) == part_groups[i], "%s: %d", parts[i],
              taut_colour_group(name_of, parts, 7, i));
    }
}

static int sign_of(size_t count, const double *values, double noise)
{
    double copy[128];
    int cut = 0, sign = 7;
    memcpy(copy, values, count * sizeof *values);
    taut_colour_range(count, copy, noise, &cut, &sign);
    return sign;
}

static void test_signs(void)
{
    const double up[] = {0, 2, -1e-9, (double)NAN}, down[] = {-3, 1e-8, -1}, both[] = {-1, 0.1};
    const double unseen[] = {-0.54, 1.7e-5, -0.3}, seen[] = {-1, 0.005, -0.3};
    double spike[101];
    CHECK(sign_of(4, up, 1e-12) == 1 && sign_of(3, down, 1e-12) == -1, "one");
    CHECK(sign_of(2, both, 1e-12) == 0, "both");
    CHECK(sign_of(4, up, 5) == 0, "nothing but noise");
    CHECK(sign_of(3, unseen, 1e-12) == -1 && sign_of(3, seen, 1e-12) == 0, "less than a shade");
    for (int i = 0; i < 100; i++) {
        spike[i] = i % 2 == 0 ? -1 : 0.5;
    }
    spike[100] = -1000; /* beyond the scale: a shade is one of what the scale shows */
    CHECK(sign_of(101, spike, 1e-12) == 0, "a spike");
}

int main(void)
{
    random_seed(20260411);
    test_map();
    test_shade();
    test_limit();
    test_labels();
    test_camera();
    test_groups();
    test_signs();
    return check_failures != 0;
}
