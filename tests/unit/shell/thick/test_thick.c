/* test_thick.c -- sheets as splines: one closed body, its sides at T/2, and Steiner's volume
 *
 *     V = T A + T^3 / 12 int K dA
 *
 * in closed form for planes, tubes and tori, by quadrature of the thin surfaces for others; what has no two sides, or folds, is
 * refused. Volumes of sheets are sums of Gauss's rule over spans, which is exact for them. */
#include "check.h"
#include "shapes.h"

#include "numeric/quadrature.h"
#include "shell/shell.h"
#include "shell/thick/thick.h"
#include "taut/measure.h"
#include "taut/operations.h"

#include <string.h>

enum { NODES = 16 };
static const double pi = 3.14159265358979323846;

/* Sums over a surface: x . n dA / 3, dA, K dA. */
typedef struct sums {
    double volume, area, curvature;
} sums;

static void add_spans(const taut_surface *surface, int su, int sv, double sign, sums *sum)
{
    const double *bu = taut_basis_breaks(taut_surface_u(surface)) + su;
    const double *bv = taut_basis_breaks(taut_surface_v(surface)) + sv;
    double nodes[NODES], weights[NODES];
    taut_gauss_rule(NODES, nodes, weights);
    for (int i = 0; i < NODES; i++) {
        for (int j = 0; j < NODES; j++) {
            const double u = bu[0] + (bu[1] - bu[0]) * (0.5 + nodes[i] / 2);
            const double v = bv[0] + (bv[1] - bv[0]) * (0.5 + nodes[j] / 2);
            const double part = weights[i] * weights[j] * (bu[1] - bu[0]) * (bv[1] - bv[0]) / 4;
            double x[6][3];
            taut_forms forms;
            taut_surface_eval(surface, u, v, 2, &x[0][0]);
            taut_forms_of((const double(*)[3])x, &forms);
            for (int c = 0; c < 3; c++) {
                sum->volume += sign * part * forms.w * forms.normal[c] * x[0][c] / 3;
            }
            sum->area += part * forms.w;
            sum->curvature += part * forms.w * forms.gaussian;
        }
    }
}

static void add_surface(const taut_surface *surface, double sign, sums *sum)
{
    for (int i = 0; i < taut_basis_span_count(taut_surface_u(surface)); i++) {
        for (int j = 0; j < taut_basis_span_count(taut_surface_v(surface)); j++) {
            add_spans(surface, i, j, sign, sum);
        }
    }
}

static sums sums_of(const taut_model *model)
{
    sums sum = {0, 0, 0};
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        add_surface(taut_model_surface(model, i), 1, &sum);
    }
    return sum;
}

/* How far a side is from where it belongs, at 8 x 8 places of each of its cells. */
static double distance_of(const taut_surface *thin, const taut_surface *side, double height)
{
    enum { PLACES = 8 };
    const taut_basis *u = taut_surface_u(side), *v = taut_surface_v(side);
    const taut_basis *tu = taut_surface_u(thin), *tv = taut_surface_v(thin);
    double most = 0;
    for (int i = 0; i <= PLACES * taut_basis_span_count(u); i++) {
        for (int j = 0; j <= PLACES * taut_basis_span_count(v); j++) {
            double at[2], x[6][3], y[3], off[3];
            const int index[2] = {i, j};
            taut_forms forms;
            for (int d = 0; d < 2; d++) {
                const taut_basis *basis = d == 0 ? u : v;
                const double *breaks = taut_basis_breaks(basis) + index[d] / PLACES;
                const double part = (double)(index[d] % PLACES) / PLACES;
                at[d] = part > 0 ? breaks[0] + part * (breaks[1] - breaks[0]) : breaks[0];
            }
            const double a = taut_basis_lo(tu) + at[0] * (taut_basis_hi(tu) - taut_basis_lo(tu));
            const double b = taut_basis_lo(tv) + at[1] * (taut_basis_hi(tv) - taut_basis_lo(tv));
            taut_surface_eval(side, at[0], at[1], 0, y);
            taut_surface_eval(thin, fmin(a, taut_basis_hi(tu)), fmin(b, taut_basis_hi(tv)), 2,
                              &x[0][0]);
            taut_forms_of((const double(*)[3])x, &forms);
            for (int c = 0; c < 3; c++) {
                off[c] = y[c] - x[0][c] - height * forms.normal[c];
            }
            most = fmax(most, sqrt(off[0] * off[0] + off[1] * off[1] + off[2] * off[2]));
        }
    }
    return most;
}

/* The bound of a sheet is not below what is found at many more places, and not much above it. */
static void check_bound(const taut_model *thin, const taut_thick *sheet, double thickness,
                        double slack, const char *what)
{
    double most = 0;
    for (int i = 0; i < taut_model_surface_count(sheet->model); i++) {
        const taut_surface *side = taut_model_surface(sheet->model, i);
        const taut_surface *of = taut_model_surface(thin, sheet->from[i]);
        const char *end = strrchr(taut_surface_name(side), '.');
        end = end != NULL ? end + 1 : taut_surface_name(side);
        if (strcmp(end, "top") == 0 || strcmp(end, "bottom") == 0) {
            /* a surface that is turned in its shell has its top below */
            most = fmax(most, fmin(distance_of(of, side, thickness / 2),
                                   distance_of(of, side, -thickness / 2)));
        }
    }
    CHECK(sheet->bound >= most * (1 - 1e-9), "%s: bound %.17g, %.17g found", what, sheet->bound,
          most);
    CHECK(sheet->bound >= sheet->distance, "%s: bound %.17g, %.17g told as found", what,
          sheet->bound, sheet->distance);
    CHECK(sheet->bound <= 1.5 * most + slack, "%s: bound %g, %g found", what, sheet->bound, most);
}

/* Makes a sheet and counts its bodies; its volume, of `bodies` shells that are all solid. */
static double volume_of(const taut_model *thin, double thickness, double tolerance, int bodies,
                        int faces, const char *what)
{
    const taut_thick_request request = {.thickness = thickness, .tolerance = tolerance};
    taut_arena *arena = taut_arena_new();
    const taut_surface *surfaces[400];
    taut_thick sheet = {NULL, NULL, 0, 0, 0};
    taut_shells shells;
    taut_error error = {.status = TAUT_OK};
    sums sum = {0, 0, 0};
    CHECK(taut_thick_new(thin, &request, arena, &sheet, &error) == TAUT_OK, "%s: %s", what,
          error.message);
    if (sheet.model == NULL) {
        taut_arena_free(arena);
        return 0;
    }
    const int count = taut_model_surface_count(sheet.model);
    CHECK(count == faces, "%s: %d faces, expected %d", what, count, faces);
    CHECK(sheet.distance <= 4 * tolerance, "%s: %g off, asked for %g", what, sheet.distance,
          tolerance);
    check_bound(thin, &sheet, thickness, fmax(tolerance / 8, 1e-11), what);
    for (int i = 0; i < count && i < 400; i++) {
        surfaces[i] = taut_model_surface(sheet.model, i);
        CHECK(sheet.from[i] >= 0 && sheet.from[i] < taut_model_surface_count(thin), "%s: from",
              what);
    }
    CHECK(taut_shells_find(surfaces, count, 0, arena, &shells) == TAUT_OK, "%s", what);
    CHECK(shells.shell_count == bodies, "%s: %d shells", what, shells.shell_count);
    for (int i = 0; i < shells.shell_count; i++) {
        CHECK(shells.shells[i].solid, "%s: shell %d is no body", what, i);
    }
    for (int i = 0; i < count; i++) {
        /* the inside of a hollow, which follows its outside, looks the other way */
        const int is_inside = bodies == 2 && shells.faces[i].shell == 1;
        add_surface(surfaces[i], shells.faces[i].turned != is_inside ? -1 : 1, &sum);
    }
    taut_model_free(sheet.model);
    taut_arena_free(arena);
    return sum.volume;
}

/* A plate, a piece of a tube and a tube: one body; a torus, which is a hollow. */
static void test_closed_forms(void)
{
    const double corners[4][3] = {{1, 2, 3}, {1, 5, 3}, {3, 2, 3}, {3, 5, 3}};
    taut_model *plate =
        shape_model(shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), corners[0], NULL));
    CHECK_NEAR(volume_of(plate, 0.5, 1e-9, 1, 6, "plate"), 3, 1e-14, "plate");
    taut_model *tube = shape_model(shape_cylinder(2, 3, 2));
    CHECK_NEAR(volume_of(tube, 0.5, 1e-9, 1, 4, "tube"), 2 * pi * 2 * 3 * 0.5, 5e-9, "tube");
    taut_model *torus = shape_model(shape_torus(3, 1));
    CHECK_NEAR(volume_of(torus, 0.5, 1e-7, 2, 2, "torus"), 4 * pi * pi * 3 * 0.5, 1e-6, "torus");
    taut_model_free(plate);
    taut_model_free(tube);
    taut_model_free(torus);
}

/* Gives a patch another sense, and knots of its own. */
static taut_surface *changed(taut_surface *surface, int way)
{
    taut_surface *made = NULL;
    for (int d = 0; d < 2; d++) {
        if ((way & (1 << d)) != 0) {
            CHECK(taut_surface_reverse(surface, d, &made, NULL) == TAUT_OK, "reverse");
            taut_surface_free(surface);
            surface = made;
        }
    }
    if ((way & 4) != 0) {
        CHECK(taut_surface_transpose(surface, &made, NULL) == TAUT_OK, "transpose");
        taut_surface_free(surface);
        surface = made;
    }
    if ((way & 8) != 0) {
        const taut_basis *u = taut_surface_u(surface);
        const double t = taut_basis_lo(u) + 0.3 * (taut_basis_hi(u) - taut_basis_lo(u));
        CHECK(taut_surface_insert(surface, TAUT_ALONG_U, t, 1, &made, NULL) == TAUT_OK, "insert");
        taut_surface_free(surface);
        surface = made;
    }
    return surface;
}

/* Enneper's surface in four pieces, each with parameters of its own: a body of 8 sides and 8 walls, with Steiner's volume. */
static void test_pieces(void)
{
    for (int trial = 0; trial < 8; trial++) {
        const double mid_u = random_in(-0.2, 0.2), mid_v = random_in(-0.2, 0.2), t = 0.05;
        taut_model *model = shape_model(NULL);
        for (int k = 0; k < 4; k++) {
            taut_surface *patch = shape_enneper(k / 2 ? mid_u : -0.6, k / 2 ? 0.6 : mid_u,
                                                k % 2 ? mid_v : -0.6, k % 2 ? 0.6 : mid_v);
            CHECK(taut_model_add_surface(model, changed(patch, random_int(0, 15))) == TAUT_OK,
                  "add");
        }
        const sums thin = sums_of(model);
        const double expected = t * thin.area + t * t * t / 12 * thin.curvature;
        CHECK_NEAR(volume_of(model, t, 1e-8, 1, 16, "pieces"), expected, 2e-8, "trial %d", trial);
        taut_model_free(model);
    }
}

static void check_refused(taut_model *model, double thickness, const char *reason)
{
    const taut_thick_request request = {.thickness = thickness, .tolerance = 1e-6};
    taut_arena *arena = taut_arena_new();
    taut_thick sheet = {NULL, NULL, 0, 0, 0};
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_thick_new(model, &request, arena, &sheet, &error) == TAUT_NO_SOLUTION, "%s", reason);
    CHECK(strcmp(error.reason, reason) == 0, "%s, expected %s: %s", error.reason, reason,
          error.message);
    CHECK(sheet.model == NULL, "%s", reason);
    taut_arena_free(arena);
    taut_model_free(model);
}

static taut_surface *half_plane(double angle)
{
    const double points[4][3] = {
        {0, 0, 0}, {0, 1, 0}, {cos(angle), 0, sin(angle)}, {cos(angle), 1, sin(angle)}};
    return shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), points[0], NULL);
}

/* Leaves that meet at one edge. */
static taut_model *book(int leaves, double angle)
{
    taut_model *model = shape_model(NULL);
    for (int i = 0; i < leaves; i++) {
        CHECK(taut_model_add_surface(model, half_plane(i * angle)) == TAUT_OK, "leaf");
    }
    return model;
}

static void test_refused(void)
{
    check_refused(shape_model(shape_cylinder(1, 2, 1)), 2, "fold");
    check_refused(shape_model(shape_sphere(1)), 0.1, "sheet"); /* poles */
    check_refused(book(2, 2), 0.01, "sheet");                  /* an edge */
    check_refused(book(3, 2), 0.01, "sheet");                  /* three at an edge */
}

/* Two leaves that are one degree from being plane: what is left of the angle is shared out, and sides are as far from each plane. */
static void test_nearly_smooth(void)
{
    const double bend = pi / 180, t = 0.02;
    taut_model *model = book(2, pi - bend);
    const taut_thick_request request = {.thickness = t, .tolerance = 1e-8};
    taut_arena *arena = taut_arena_new();
    taut_thick sheet = {NULL, NULL, 0, 0, 0};
    CHECK(taut_thick_new(model, &request, arena, &sheet, NULL) == TAUT_OK, "nearly smooth");
    CHECK(sheet.distance < t / 2 * bend, "moved by %g", sheet.distance);
    CHECK(sheet.distance > t / 2 * bend / 4, "moved by %g", sheet.distance);
    check_bound(model, &sheet, t, 0, "nearly smooth");
    taut_model_free(sheet.model);
    taut_arena_free(arena);
    /* what the bend adds outside it takes inside */
    CHECK(fabs(volume_of(model, t, 1e-3, 1, 10, "nearly smooth") - 2 * t) < 1e-9, "volume");
    taut_model_free(model);
}

int main(void)
{
    test_closed_forms();
    test_pieces();
    test_refused();
    test_nearly_smooth();
    return check_failures != 0;
}
