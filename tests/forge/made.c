/* made.c -- random legal problems: the numbers of worked examples moved.
 *
 *     points          by a random affine map, and known points of nets by noise besides
 *     legs, directions  by its linear part
 *     bonnet          lambda, lengths, sign
 *     film            corners under an affine map, bases, forces, which edges are held
 *     asymptotic      the curves of a made patch under an affine map, which keeps their property
 */
#include "edit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct made_text {
    char *text;
    size_t size, used;
    double map[3][3], offset[3], noise;
    forge_random *random;
} made_text;

static void put(made_text *out, const char *text)
{
    const size_t n = strlen(text);

    if (out->used + n + 1 < out->size) {
        memcpy(out->text + out->used, text, n + 1);
        out->used += n;
    }
}

static void put_number(made_text *out, double value)
{
    char text[40];

    snprintf(text, sizeof text, "%.17g", value);
    put(out, text);
}

static int is_point(const taut_record *record)
{
    if (taut_record_kind_of(record) != TAUT_RECORD_LIST || taut_record_count(record) != 3) {
        return 0;
    }
    for (size_t k = 0; k < 3; k++) {
        if (taut_record_kind_of(taut_record_at(record, k)) != TAUT_RECORD_NUMBER) {
            return 0;
        }
    }
    return 1;
}

static void put_mapped(made_text *out, const double p[3], int direction)
{
    put(out, "[");
    for (int k = 0; k < 3; k++) {
        double sum = direction ? 0 : out->offset[k] + out->noise * forge_in(out->random, -1, 1);
        for (int l = 0; l < 3; l++) {
            sum += out->map[k][l] * p[l];
        }
        put_number(out, sum);
        put(out, k < 2 ? "," : "]");
    }
}

static int is_direction(const char *key)
{
    return strcmp(key, "direction") == 0 || strcmp(key, "legs") == 0 ||
           strcmp(key, "cross_derivative") == 0;
}

static void put_record(made_text *out, const taut_record *record, const char *key)
{
    const taut_record_kind kind = taut_record_kind_of(record);
    const int object = kind == TAUT_RECORD_OBJECT;

    if (is_point(record) && strcmp(key, "knots") != 0 && strcmp(key, "weights") != 0) {
        double p[3];
        for (size_t k = 0; k < 3; k++) {
            p[k] = taut_record_number(taut_record_at(record, k));
        }
        put_mapped(out, p, is_direction(key));
    } else if (kind == TAUT_RECORD_LIST || object) {
        put(out, object ? "{" : "[");
        for (size_t i = 0; i < taut_record_count(record); i++) {
            put(out, i > 0 ? "," : "");
            if (object) {
                put(out, "\"");
                put(out, taut_record_key(record, i));
                put(out, "\":");
            }
            put_record(out, taut_record_at(record, i), object ? taut_record_key(record, i) : key);
        }
        put(out, object ? "}" : "]");
    } else if (kind == TAUT_RECORD_NUMBER) {
        double value = taut_record_number(record);
        if (strcmp(key, "weights") == 0) {
            value *= out->noise > 0 ? forge_log(out->random, 0.5, 2) : 1;
        } else if (strcmp(key, "radius") == 0) {
            value *= forge_log(out->random, 0.3, 1.2);
        }
        put_number(out, value);
    } else if (kind == TAUT_RECORD_TEXT) {
        put(out, "\"");
        put(out, taut_record_text(record));
        put(out, "\"");
    } else if (kind == TAUT_RECORD_BOOL) {
        put(out, taut_record_bool(record) ? "true" : "false");
    } else {
        put(out, "null");
    }
}

static void random_map(made_text *out, int similar)
{
    const double scale = forge_log(out->random, 0.1, 10);
    double q[4], n = 0;

    for (int k = 0; k < 4; k++) {
        q[k] = forge_in(out->random, -1, 1);
        n += q[k] * q[k];
    }
    n = sqrt(n) + 1e-9;
    const double w = q[0] / n, x = q[1] / n, y = q[2] / n, z = q[3] / n;
    const double turn[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                               {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                               {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
    for (int k = 0; k < 3; k++) {
        const double stretch = similar ? 1 : forge_log(out->random, 0.5, 2);
        for (int l = 0; l < 3; l++) {
            out->map[k][l] = scale * stretch * turn[k][l];
        }
        out->offset[k] = scale * forge_in(out->random, -3, 3);
    }
    out->noise = similar ? 0 : scale * forge_log(out->random, 1e-3, 0.3);
}

static void put_bonnet(made_text *out)
{
    forge_random *r = out->random;
    const int normal = forge_int(r, 0, 4) == 0, bspline = !normal && (forge_bits(r) & 1) != 0;

    put(out, "{\"taut\":1,\"construct\":\"bonnet\",\"lambda\":");
    put_number(out, forge_in(r, 0, 0.95));
    put(out, ",\"sign\":\"");
    put(out, normal || (forge_bits(r) & 1) ? "-" : "+");
    put(out, "\",\"alpha\":");
    put_number(out, forge_in(r, 0.2, 2));
    put(out, ",\"beta\":");
    put_number(out, forge_in(r, 0.2, 2));
    put(out, normal ? ",\"normalize\":true" : "");
    put(out, bspline ? ",\"mesh\":\"bspline\",\"segments\":[2,3]" : "");
    if (!normal && (forge_bits(r) & 1)) {
        put(out, ",\"theta\":");
        put_number(out, forge_in(r, -3, 3));
    }
    put(out, "}");
}

static void put_corner(made_text *out, int c)
{
    const double p[3] = {2.0 * (c % 2) - 1, 2.0 * (c / 2) - 1, c % 3 == 0 ? 0.4 : -0.4};
    double sum[3];

    put(out,
        c % 2 == 0 ? (c < 2 ? "\"u0v0\":[" : "\"u0v1\":[") : (c < 2 ? "\"u1v0\":[" : "\"u1v1\":["));
    for (int k = 0; k < 3; k++) {
        sum[k] = out->offset[k];
        for (int l = 0; l < 3; l++) {
            sum[k] += out->map[k][l] * p[l];
        }
        put_number(out, sum[k]);
        put(out, k < 2 ? "," : "]");
    }
    put(out, c < 3 ? "," : "}");
}

static void put_spline(made_text *out)
{
    const int degree = forge_int(out->random, 2, 5);

    put(out, "{\"type\":\"bspline\",\"degree\":");
    put_number(out, degree);
    put(out, ",\"count\":");
    put_number(out, degree + forge_int(out->random, 1, 4));
    put(out, "},");
}

/* Forces that a square of this size bears, so that few films are looked for in vain. */
static void put_film(made_text *out)
{
    static const char *const names[4] = {"u0", "u1", "v0", "v1"};
    forge_random *r = out->random;
    const double tension = forge_log(r, 1e-3, 1e3), all = forge_log(r, 1, 30);
    double size = 0;

    for (int k = 0; k < 9; k++) {
        size = fmax(size, 4 * fabs(out->map[k / 3][k % 3]));
    }
    put(out, "{\"taut\":1,\"construct\":\"film\",\"u\":");
    put_spline(out);
    put(out, "\"v\":");
    put_spline(out);
    put(out, "\"tension\":");
    put_number(out, tension);
    put(out, ",\"corners\":{");
    for (int c = 0; c < 4; c++) {
        put_corner(out, c);
    }
    put(out, ",\"edges\":{");
    for (int e = 0; e < 4; e++) {
        put(out, e > 0 ? ",\"" : "\"");
        put(out, names[e]);
        put(out, "\":");
        if (forge_int(r, 0, 3) == 0) {
            put(out, "\"fixed\"");
        } else {
            put(out, "{\"cable\":{\"force\":");
            put_number(out, all * forge_log(r, 1, 4) * tension * size);
            put(out, "}}");
        }
    }
    put(out, "}}");
}

static void put_curve(made_text *out, const taut_curve *curve)
{
    const int n = taut_basis_count(taut_curve_t(curve));

    put(out, "{\"t\":{\"type\":\"bezier\",\"degree\":");
    put_number(out, taut_basis_degree(taut_curve_t(curve)));
    put(out, "},\"points\":[");
    for (int i = 0; i < n; i++) {
        put(out, i > 0 ? "," : "");
        put_mapped(out, taut_curve_points(curve) + 3 * i, 0);
    }
    put(out, "]");
    if (taut_curve_weights(curve) != NULL) {
        put(out, ",\"weights\":[");
        for (int i = 0; i < n; i++) {
            put(out, i > 0 ? "," : "");
            put_number(out, taut_curve_weights(curve)[i]);
        }
        put(out, "]");
    }
    put(out, "}");
}

static void put_asymptotic(made_text *out, const forge_base *base)
{
    out->noise = 0;
    put(out, "{\"taut\":1,\"construct\":\"asymptotic\",\"surface\":\"");
    put(out, forge_bits(out->random) & 1 ? "n+3" : "5n-7");
    put(out, "\",\"curves\":{");
    for (int i = 0; i < taut_model_curve_count(base->model); i++) {
        const taut_curve *curve = taut_model_curve(base->model, i);
        put(out, i > 0 ? ",\"" : "\"");
        put(out, taut_curve_name(curve));
        put(out, "\":");
        put_curve(out, curve);
    }
    put(out, "}}");
}

const char *made_problem(const forge_base *base, forge_pool *pool, forge_random *random)
{
    made_text out = {.size = 200000, .random = random};
    const int rigid = strcmp(base->construct, "harmonic-extension") == 0 ||
                      taut_record_get(base->document, "surface") != NULL ||
                      taut_record_get(base->document, "curves") != NULL ||
                      strcmp(base->construct, "harmonic") == 0;

    out.text = pool_take(pool, out.size);
    out.text[0] = 0;
    random_map(&out, rigid);
    if (strcmp(base->construct, "bonnet") == 0) {
        put_bonnet(&out);
    } else if (strcmp(base->construct, "film") == 0) {
        put_film(&out);
    } else if (strcmp(base->construct, "asymptotic") == 0) {
        random_map(&out, 0);
        put_asymptotic(&out, base);
    } else {
        if (strcmp(base->construct, "pipe") == 0) {
            random_map(&out, 1);
            out.noise = 0.05 * fabs(out.map[0][0]);
        }
        put_record(&out, base->document, "");
    }
    return out.text;
}
