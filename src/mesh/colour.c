#include "mesh/colour.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static unsigned char to_byte(double x)
{
    return (unsigned char)lround(255 * fmin(fmax(x, 0), 1));
}

static double lab_inverse(double t)
{
    return t > 6.0 / 29 ? t * t * t : 108.0 / 841 * (t - 4.0 / 29);
}

static double srgb_gamma(double x)
{
    return x > 0.0031308 ? 1.055 * taut_pow(x, 1 / 2.4) - 0.055 : 12.92 * x;
}

/* CIELAB (white D65) to sRGB, cut off at the gamut. */
static taut_ink from_lab(double lightness, double a, double b)
{
    const double fy = (lightness + 16) / 116;
    const double x = 0.95047 * lab_inverse(fy + a / 500);
    const double y = lab_inverse(fy);
    const double z = 1.08883 * lab_inverse(fy - b / 200);
    const double red = 3.2404542 * x - 1.5371385 * y - 0.4985314 * z;
    const double green = -0.9692660 * x + 1.8760108 * y + 0.0415560 * z;
    const double blue = 0.0556434 * x - 0.2040259 * y + 1.0572252 * z;
    return (taut_ink){to_byte(srgb_gamma(red)), to_byte(srgb_gamma(green)),
                      to_byte(srgb_gamma(blue))};
}

/* L = 96 - 58 |t|, chroma c |t|^0.9 at hue 285 (blue, c = 54) and 38 degrees (red, c = 58): both
 * arms stay inside the gamut of sRGB, so that nothing is cut off. */
taut_ink taut_colour_diverging(double t)
{
    static const double blue[2] = {14.0, -52.2}, red[2] = {45.7, 35.7};
    const double size = fmin(fabs(t), 1);
    const double *arm = t < 0 ? blue : red;
    if (isnan(t)) {
        return (taut_ink){158, 158, 158};
    }
    return from_lab(96 - 58 * size, arm[0] * taut_pow(size, 0.9), arm[1] * taut_pow(size, 0.9));
}

taut_ink taut_colour_plain(int i)
{
    static const taut_ink palette[] = {
        {166, 198, 230}, {238, 206, 150}, {174, 216, 182}, {228, 174, 172},
        {200, 186, 228}, {158, 214, 216}, {222, 214, 158}, {210, 194, 180},
    };
    if (i >= TAUT_COLOUR_OWN) {
        return (taut_ink){(unsigned char)(i >> 16 & 255), (unsigned char)(i >> 8 & 255),
                          (unsigned char)(i & 255)};
    }
    return palette[(size_t)i % (sizeof palette / sizeof palette[0])];
}

/* The letters of a name: after what it belongs to and a dot, before its number and the primes of an
 * image. */
static size_t stem_of(const char *name, const char **first)
{
    const char *dot = strrchr(name, '.');
    *first = dot != NULL ? dot + 1 : name;
    size_t length = strlen(*first);
    while (length > 0 && strchr("0123456789'", (*first)[length - 1]) != NULL) {
        length--;
    }
    return length;
}

static int is_alike(const char *a, const char *b)
{
    const char *first, *other;
    const size_t length = stem_of(a, &first);
    return length > 0 && length == stem_of(b, &other) && memcmp(first, other, length) == 0;
}

/* Straight and bent, in every model alike. */
static const char *const meanings[] = {"pipe", "blend"};
enum { MEANINGS = sizeof meanings / sizeof meanings[0], GROUPS_MOST = 64 };

static int meaning_of(const char *name)
{
    for (int k = 0; k < MEANINGS; k++) {
        if (is_alike(meanings[k], name)) {
            return k;
        }
    }
    return -1;
}

/* The first thing that shares i's colour. */
static int first_alike(const char *(*name)(const void *of, int i), const void *of, int i)
{
    int first = 0;
    while (first < i && !is_alike(name(of, first), name(of, i))) {
        first++;
    }
    return first;
}

int taut_colour_group(const char *(*name)(const void *of, int i), const void *of, int count, int i)
{
    const int meaning = meaning_of(name(of, i)), first = first_alike(name, of, i);
    int before = 0;

    if (meaning >= 0 || first >= GROUPS_MOST) { /* so many are not told apart by colour anyway */
        return meaning >= 0 ? meaning : first;
    }
    for (int k = 0; k < count && k < GROUPS_MOST && before == 0; k++) {
        before = meaning_of(name(of, k)) >= 0 ? MEANINGS : 0;
    }
    for (int k = 0; k < first; k++) {
        before += meaning_of(name(of, k)) < 0 && first_alike(name, of, k) == k;
    }
    return before;
}

static const char *surface_name(const void *of, int i)
{
    return taut_surface_name(taut_model_surface(of, i));
}

static const char *curve_name(const void *of, int i)
{
    return taut_curve_name(taut_model_curve(of, i));
}

int taut_colour_said(const taut_model *model, int i)
{
    static const char digits[] = "0123456789abcdef";
    const taut_record *colours = taut_record_get(taut_model_details(model), "colours");
    const char *text = taut_record_text(taut_record_at(colours, (size_t)i));
    int number = 0;
    if (text == NULL || strlen(text) != 7 || text[0] != '#') {
        return -1;
    }
    for (int k = 1; k < 7; k++) {
        const char *digit = strchr(digits, text[k]);
        if (digit == NULL) {
            return -1;
        }
        number = 16 * number + (int)(digit - digits);
    }
    return TAUT_COLOUR_OWN + number;
}

int taut_colour_of_surface(const taut_model *model, int i)
{
    const int said = taut_colour_said(model, i);
    return said >= 0 ? said
                     : taut_colour_group(surface_name, model, taut_model_surface_count(model), i);
}

int taut_colour_of_curve(const taut_model *model, int i)
{
    return taut_colour_group(curve_name, model, taut_model_curve_count(model), i);
}

taut_ink taut_colour_curve(int i)
{
    static const taut_ink palette[] = {{176, 42, 48}, {22, 78, 140},  {30, 112, 64},
                                       {150, 84, 12}, {104, 48, 136}, {20, 110, 118}};
    return palette[(size_t)i % (sizeof palette / sizeof palette[0])];
}

taut_ink taut_colour_mix(taut_ink a, taut_ink b, double t)
{
    return (taut_ink){to_byte((a.r + t * (b.r - a.r)) / 255),
                      to_byte((a.g + t * (b.g - a.g)) / 255),
                      to_byte((a.b + t * (b.b - a.b)) / 255)};
}

/* Two-sided: the caller turns n to the viewer. Half Lambert, ((1 + n.l) / 2)^2 scaled, from the
 * upper left, plus a faint highlight; the wrap keeps the dark side readable in print. */
taut_ink taut_colour_shade(taut_ink ink, const double normal[3], double strength)
{
    static const double light[3] = {-0.4583, 0.6110, 0.6455};
    static const double between[3] = {-0.2527, 0.3368, 0.9070}; /* of light and eye */
    static const taut_ink black = {24, 28, 40}, white = {255, 255, 255};
    const double length = taut_length(normal);
    double lit = 0, shine = 0;
    for (int c = 0; c < 3; c++) {
        lit += light[c] * normal[c] / length;
        shine += between[c] * normal[c] / length;
    }
    const double wrap = (1 + lit) / 2;
    const double dark = strength * 0.38 * (1 - wrap * wrap);
    const double bright = strength * 0.2 * taut_pow(fmax(shine, 0), 16);
    return taut_colour_mix(taut_colour_mix(ink, black, dark), white, bright);
}

/* Of one arm of the map: what is less than one of the limit looks like 0. */
enum { SHADES = 256 };

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The largest of all, or of 98 in 100 when it is more than three times that. Rounded up to two
 * digits, so that the scale bar ends at a number that can be said. */
double taut_colour_limit(size_t count, double *values, double noise, int *cut)
{
    size_t kept = 0;
    double limit = noise, most = 0, step = 0;
    for (size_t i = 0; i < count; i++) {
        if (isfinite(values[i])) {
            values[kept++] = fabs(values[i]);
        }
    }
    qsort(values, kept, sizeof(double), by_size);
    *cut = 0;
    if (kept > 0) {
        most = values[kept - 1];
        limit = values[(kept - 1) * 98 / 100];
        *cut = most > 3 * limit && most > 3 * noise;
        limit = fmax(*cut ? limit : most, noise);
    }
    step = taut_pow(10, floor(taut_log10(limit)) - 1);
    return isfinite(ceil(limit / step - 1e-9) * step) && step > 0 ? ceil(limit / step - 1e-9) * step
                                                                  : limit;
}

double taut_colour_range(size_t count, double *values, double noise, int *cut, int *sign)
{
    double low = 0, high = 0;
    for (size_t i = 0; i < count; i++) {
        if (isfinite(values[i])) {
            low = fmin(low, values[i]);
            high = fmax(high, values[i]);
        }
    }
    const double limit = taut_colour_limit(count, values, noise, cut), most = fmax(high, -low);
    const double none = fmax(noise, fmax(limit / SHADES, 1e-6 * most));
    *sign = most <= noise ? 0 : -low <= none ? 1 : high <= none ? -1 : 0;
    return limit;
}
