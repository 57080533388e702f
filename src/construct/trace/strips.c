/* strips.c -- the laths and the panels of a finished net as surfaces in space.
 *
 *     of each curve, at the means of its basis's knots: n from the surface at the window's place, T from the
 *     curve, and what a strip of its kind goes along, d, and across, e: unit but for a ruling's skew
 *     d and e as splines on the curve's basis through those values: a totally positive matrix, factored
 *     without pivots ([PieglTiller1997] 9.2.1)
 *     the strip C + h d, |h| <= w/2, of degree 5 x 1; a solid's six faces C + h d + z e, |z| <= t/2
 *     a panel: the bilinear patch through its four nodes
 */
#include "taut/trace.h"

#include "basis/basis_ops.h"
#include "construct/common/build.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/keep.h"
#include "taut/measure.h"

#include <stdio.h>
#include <string.h>

enum { DEGREE = 5, BAND = 2 * DEGREE + 1 };

static const char *const words[] = {"standing", "plank", "developable", "envelope"};

typedef struct request {
    const taut_model *model;
    int solid;
} request;

/* A curve and what the details say of it. */
typedef struct lath {
    const taut_model *model;
    const taut_curve *curve;
    const taut_record *domain; /* of all curves */
    taut_trace_strip strip;
    double width, thickness;
} lath;

/* ---- details ---- */

static const taut_record *find_named(const taut_record *list, const char *name)
{
    for (size_t k = 0; k < taut_record_count(list); k++) {
        const taut_record *one = taut_record_at(list, k);
        if (strcmp(taut_record_text(taut_record_get(one, "name")), name) == 0) {
            return one;
        }
    }
    return NULL;
}

static int read_lath(const taut_model *model, const taut_curve *curve, lath *l)
{
    const taut_record *details = taut_model_details(model);
    const taut_record *one = find_named(taut_record_get(details, "laths"), taut_curve_name(curve));
    const char *word = taut_record_text(taut_record_get(one, "strip"));

    *l = (lath){.model = model, .curve = curve, .domain = taut_record_get(details, "domain")};
    l->width = one != NULL ? taut_record_number(taut_record_get(one, "width")) : 0;
    l->thickness = one != NULL ? taut_record_number(taut_record_get(one, "thickness")) : 0;
    for (int k = 0; k < 4; k++) {
        if (strcmp(word, words[k]) == 0 && l->width > 0) {
            l->strip = (taut_trace_strip)k;
            return 1;
        }
    }
    return 0;
}

/* The surface that a stretch is in the window of: the one that it names, or the first one. */
static const taut_surface *surface_of(const taut_model *model, const taut_record *stretch)
{
    const char *name = taut_record_text(taut_record_get(stretch, "surface"));
    for (int k = 0; k < taut_model_surface_count(model); k++) {
        if (strcmp(taut_surface_name(taut_model_surface(model, k)), name) == 0) {
            return taut_model_surface(model, k);
        }
    }
    return taut_model_surface(model, 0);
}

/* The place of the window at t, and the surface it is of: of the stretch of details that holds it. */
static int window_at(const lath *l, double t, double at[2], const taut_surface **surface)
{
    for (size_t k = 0; k < taut_record_count(l->domain); k++) {
        const taut_record *one = taut_record_at(l->domain, k);
        const taut_record *list = taut_record_get(taut_record_get(one, "t"), "knots");
        const taut_record *rows = taut_record_get(one, "points");
        const size_t count = taut_record_count(list);
        double work[DEGREE + 1][2], knots[2 * DEGREE];
        size_t low = DEGREE;
        if (strcmp(taut_record_text(taut_record_get(one, "name")), taut_curve_name(l->curve)) !=
                0 ||
            count < 2 * (DEGREE + 1) || taut_record_count(rows) + DEGREE + 1 != count ||
            !(t >= taut_record_number(taut_record_at(list, 0))) ||
            !(t <= taut_record_number(taut_record_at(list, count - 1)))) {
            continue;
        }
        while (low + DEGREE + 2 < count && taut_record_number(taut_record_at(list, low + 1)) <= t) {
            low++;
        }
        for (size_t i = 0; i < 2 * DEGREE; i++) { /* de Boor's algorithm */
            knots[i] = taut_record_number(taut_record_at(list, low - DEGREE + 1 + i));
        }
        for (size_t i = 0; i <= DEGREE; i++) {
            const taut_record *row = taut_record_at(rows, low - DEGREE + i);
            work[i][0] = taut_record_number(taut_record_at(row, 0));
            work[i][1] = taut_record_number(taut_record_at(row, 1));
        }
        for (int level = DEGREE; level > 0; level--) {
            for (int i = 0; i < level; i++) {
                const double a = knots[i + DEGREE - level], b = knots[i + DEGREE];
                const double share = (t - a) / (b - a);
                work[i][0] += share * (work[i + 1][0] - work[i][0]);
                work[i][1] += share * (work[i + 1][1] - work[i][1]);
            }
        }
        memcpy(at, work[0], 2 * sizeof(double));
        *surface = surface_of(l->model, one);
        return 1;
    }
    return 0;
}

/* ---- directions ---- */

/* d and e of the strip at t. */
static int directions_at(const lath *l, double t, double d[3], double e[3])
{
    const taut_surface *surface = NULL;
    double c[3][3], x[3][3], at[2], tangent[3], sideways[3], normal[3];
    taut_forms f;

    if (!window_at(l, t, at, &surface) || taut_curve_eval(l->curve, t, 2, c[0]) != TAUT_OK) {
        return 0;
    }
    for (int i = 0; i < 2; i++) {
        const taut_basis *basis = i == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
        at[i] = fmin(fmax(at[i], taut_basis_lo(basis)), taut_basis_hi(basis));
    }
    if (taut_surface_forms_points(surface, 1, &at[0], &at[1], 1, &f) != TAUT_OK || !f.regular ||
        taut_surface_eval(surface, at[0], at[1], 1, x[0]) != TAUT_OK) {
        return 0;
    }
    const double speed = taut_length(c[1]);
    for (int i = 0; i < 3; i++) {
        tangent[i] = c[1][i] / speed;
        normal[i] = f.normal[i];
    }
    const double along = taut_dot(normal, tangent); /* rounding */
    taut_add_scaled(-along, tangent, normal);
    taut_cross(normal, tangent, sideways);
    const int lies = l->strip == TAUT_TRACE_PLANK || l->strip == TAUT_TRACE_ENVELOPE;
    double skew = 0;
    if (l->strip == TAUT_TRACE_DEVELOPABLE || l->strip == TAUT_TRACE_ENVELOPE) {
        const double p = taut_dot(tangent, x[1]), q = taut_dot(tangent, x[2]), area = f.w * f.w;
        const double a = (f.g * p - f.f * q) / area, b = (f.e * q - f.f * p) / area;
        const double tau = ((f.m * a + f.n * b) * (f.e * a + f.f * b) -
                            (f.l * a + f.m * b) * (f.f * a + f.g * b)) /
                           f.w;
        const double k_n = f.l * a * a + 2 * f.m * a * b + f.n * b * b;
        skew = lies ? -tau / k_n : tau / (taut_dot(c[2], sideways) / (speed * speed));
    }
    for (int i = 0; i < 3; i++) {
        d[i] = (lies ? sideways[i] : normal[i]) + skew * tangent[i];
        e[i] = lies ? normal[i] : sideways[i];
    }
    return isfinite(skew);
}

/* Solves A X = B for a banded A that needs no pivots; rows a[i][BAND] about the diagonal, x[i][6]. */
static void solve(int n, double (*a)[BAND], double (*x)[6])
{
    for (int k = 0; k < n; k++) {
        for (int i = k + 1; i < n && i <= k + DEGREE; i++) {
            const double factor = a[i][k - i + DEGREE] / a[k][DEGREE];
            for (int j = k + 1; factor != 0 && j < n && j <= k + DEGREE; j++) {
                a[i][j - i + DEGREE] -= factor * a[k][j - k + DEGREE];
            }
            for (int c = 0; factor != 0 && c < 6; c++) {
                x[i][c] -= factor * x[k][c];
            }
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n && j <= k + DEGREE; j++) {
            for (int c = 0; c < 6; c++) {
                x[k][c] -= a[k][j - k + DEGREE] * x[j][c];
            }
        }
        for (int c = 0; c < 6; c++) {
            x[k][c] /= a[k][DEGREE];
        }
    }
}

/* rows[i] = (d, e): their splines' coefficients. */
static taut_status fit(const lath *l, taut_arena *arena, double (**rows)[6], taut_error *error)
{
    const taut_basis *basis = taut_curve_t(l->curve);
    const int n = taut_basis_count(basis);
    double(*a)[BAND] = taut_arena_take(arena, (size_t)n, sizeof *a);
    double *means = taut_arena_take(arena, (size_t)n, sizeof *means);

    *rows = taut_arena_take(arena, (size_t)n, sizeof **rows);
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (basis->shape.local != DEGREE + 1 || basis->ops->linear == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/curves", taut_none, taut_none,
                         "%s is no quintic: it is not a curve of a net", taut_curve_name(l->curve));
    }
    basis->ops->linear(basis, means);
    for (int i = 0; i < n; i++) {
        double values[DEGREE + 1];
        means[i] = fmin(fmax(means[i], taut_basis_lo(basis)), taut_basis_hi(basis));
        const int span = taut_basis_span(basis, means[i]), first = taut_basis_first(basis, span);
        taut_basis_eval(basis, span, means[i], 0, values);
        for (int k = 0; k <= DEGREE; k++) {
            const int place = first + k - i + DEGREE;
            if (place >= 0 && place < BAND) {
                a[i][place] = values[k];
            }
        }
        if (!directions_at(l, means[i], (*rows)[i], (*rows)[i] + 3)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "developable", NULL, taut_none, taut_none,
                             "the strip of %s has no direction %.6g along it",
                             taut_curve_name(l->curve), means[i]);
        }
    }
    solve(n, a, *rows);
    return TAUT_OK;
}

/* ---- surfaces ---- */

/* C + h d + z e as a face between two corners (h, z) of the section. */
static taut_status add_face(const lath *l, double (*rows)[6], const double from[2],
                            const double to[2], const taut_basis *linear, const char *which,
                            taut_arena *arena, taut_model *model, taut_error *error)
{
    const taut_basis *basis = taut_curve_t(l->curve);
    const int n = taut_basis_count(basis);
    double *points = taut_arena_take(arena, (size_t)n, 6 * sizeof(double));
    char name[TAUT_NAME_MAX + 16];
    taut_surface *surface = NULL;

    if (points == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < 2 * n; i++) {
        const double *at = i % 2 == 0 ? from : to, *row = rows[i / 2];
        memcpy(points + 3 * i, taut_curve_points(l->curve) + 3 * (i / 2), 3 * sizeof(double));
        taut_add_scaled(at[0], row, points + 3 * i);
        taut_add_scaled(at[1], row + 3, points + 3 * i);
    }
    snprintf(name, sizeof name, "%.60s-%s", taut_curve_name(l->curve), which);
    const taut_status status = taut_surface_new(name, basis, linear, points, NULL, &surface, error);
    return status == TAUT_OK ? taut_construct_add_surface(model, surface, error) : status;
}

/* The end of a solid: its four corners. */
static taut_status add_end(const lath *l, double (*rows)[6], int last, const taut_basis *linear,
                           taut_model *model, taut_error *error)
{
    const int i = last ? taut_basis_count(taut_curve_t(l->curve)) - 1 : 0;
    double points[4][3];
    char name[TAUT_NAME_MAX + 16];
    taut_surface *surface = NULL;

    for (int k = 0; k < 4; k++) {
        memcpy(points[k], taut_curve_points(l->curve) + 3 * i, sizeof points[k]);
        taut_add_scaled((k < 2 ? -1 : 1) * l->width / 2, rows[i], points[k]);
        taut_add_scaled((k % 2 == 0 ? -1 : 1) * l->thickness / 2, rows[i] + 3, points[k]);
    }
    snprintf(name, sizeof name, "%.60s-%s", taut_curve_name(l->curve), last ? "to" : "from");
    const taut_status status =
        taut_surface_new(name, linear, linear, points[0], NULL, &surface, error);
    return status == TAUT_OK ? taut_construct_add_surface(model, surface, error) : status;
}

static taut_status add_lath(const request *r, const lath *l, const taut_basis *linear,
                            taut_arena *arena, taut_model *model, taut_error *error)
{
    static const char *const faces[] = {"low", "front", "high", "back"};
    const double h = l->width / 2, z = l->thickness / 2;
    const double corners[5][2] = {{-h, -z}, {-h, z}, {h, z}, {h, -z}, {-h, -z}};
    const double ends[2][2] = {{-h, 0}, {h, 0}};
    double(*rows)[6] = NULL;
    taut_status status = fit(l, arena, &rows, error);

    if (status == TAUT_OK && !r->solid) {
        return add_face(l, rows, ends[0], ends[1], linear, "strip", arena, model, error);
    }
    if (status == TAUT_OK && !(z > 0)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "missing", "/laths/thickness", taut_none,
                         taut_none, "the laths have no thickness, and so no solids");
    }
    for (int k = 0; status == TAUT_OK && k < 4; k++) {
        status =
            add_face(l, rows, corners[k], corners[k + 1], linear, faces[k], arena, model, error);
    }
    for (int last = 0; status == TAUT_OK && last < 2; last++) {
        status = add_end(l, rows, last, linear, model, error);
    }
    return status;
}

/* Corners of details go round; P1, P2, ... in their order. How many there are: *count. */
static taut_status add_panels(const request *r, const taut_basis *linear, taut_model *model,
                              int *count, taut_error *error)
{
    const taut_record *panels = taut_record_get(taut_model_details(r->model), "panels");
    static const size_t corners[4] = {0, 3, 1, 2}; /* of rows u0v0, u0v1, u1v0, u1v1 */
    taut_status status = TAUT_OK;

    for (size_t k = 0; status == TAUT_OK && k < taut_record_count(panels); k++) {
        const taut_record *list = taut_record_get(taut_record_at(panels, k), "points");
        double points[4][3];
        char name[24];
        taut_surface *surface = NULL;
        for (size_t i = 0; i < 4; i++) {
            for (size_t c = 0; c < 3; c++) {
                points[i][c] =
                    taut_record_number(taut_record_at(taut_record_at(list, corners[i]), c));
            }
        }
        snprintf(name, sizeof name, "P%d", ++*count);
        status = taut_surface_new(name, linear, linear, points[0], NULL, &surface, error);
        if (status == TAUT_OK) {
            status = taut_construct_add_surface(model, surface, error);
        }
    }
    return status;
}

static taut_status build(void *context, taut_arena *arena, taut_model *model, taut_error *error)
{
    static const taut_basis_spec spec = {.type = "bezier", .degree = 1};
    const request *r = context;
    taut_basis *linear = NULL;
    int count = 0;
    taut_status status = taut_basis_new(&spec, 2, &linear, error);

    if (status == TAUT_OK && !taut_keep_basis(arena, linear)) {
        return taut_fail_memory(error);
    }
    if (status == TAUT_OK && taut_model_set_unit(model, taut_model_unit(r->model)) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        status = add_panels(r, linear, model, &count, error);
    }
    const int has_panels = count > 0;
    for (int i = 0; status == TAUT_OK && i < taut_model_curve_count(r->model); i++) {
        const taut_curve *curve = taut_model_curve(r->model, i);
        taut_curve *copy = NULL;
        lath l;
        const int is_lath = read_lath(r->model, curve, &l);
        if (!is_lath && !has_panels) {
            continue;
        }
        count++;
        status = is_lath ? add_lath(r, &l, linear, arena, model, error) : TAUT_OK;
        if (status == TAUT_OK) {
            status = taut_curve_copy(curve, &copy) == TAUT_OK
                         ? taut_construct_add_curve(model, copy, error)
                         : taut_fail_memory(error);
        }
    }
    if (status == TAUT_OK && count == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "width", "/laths/width", taut_none, taut_none,
                         "the model has no laths with a width and no panels, and so no strips");
    }
    return status;
}

taut_status taut_trace_strips(const taut_model *model, int solid, taut_model **strips,
                              taut_error *error)
{
    request r = {model, solid};
    if (model == NULL || strips == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_trace_strips needs a model, and a place for the strips");
    }
    if (taut_model_surface_count(model) == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "width", "/laths/width", taut_none, taut_none,
                         "the model has no surface, and so no strips on it");
    }
    return taut_construct_build(build, &r, strips, error);
}
