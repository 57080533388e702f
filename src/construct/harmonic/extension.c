/* extension.c -- construct `harmonic-extension`: the harmonic neighbour across an edge.
 *
 * Contact c1: equal derivatives leave one harmonic surface, and it is the polynomial itself carried
 * on
 * ([NiWang2015] section 2.6), so its net is a de Casteljau extrapolation, as is that of the merged
 * surface. Contact g1: equal tangent planes leave three numbers free; the edge and the derivative
 * across it are completed (section 8.6).
 */
#include "construct/construct_ops.h"
#include "construct/harmonic/complete.h"
#include "construct/harmonic/frame.h"
#include "construct/harmonic/lidstone.h"
#include "core/arena.h"
#include "core/fail.h"
#include "taut/harmonic.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A given surface counts as harmonic up to this scaled residual. */
static const double harmonic_limit = 1e-10;

/* The given surface turned so that the edge is u = 1 of the turned net. */
typedef struct extension {
    const taut_harmonic_extension_problem *problem;
    taut_arena *arena;
    int turned;           /* u and v change places */
    int reversed;         /* the direction across the edge is reversed */
    int n, m;             /* degrees across the edge and along it */
    double across, along; /* parameter widths */
    double ratio;         /* width of the extension over that of the surface */
    taut_frame frame;
    double *net; /* double[n+1][m+1][3], in the frame */
} extension;

static size_t index_of(const extension *e, int columns, int i, int j)
{
    const int line = e->reversed ? e->n - i : i;
    return e->turned ? (size_t)j * (size_t)columns + (size_t)line
                     : (size_t)line * (size_t)columns + (size_t)j;
}

static taut_status turn(extension *e, taut_error *error)
{
    const taut_surface *surface = e->problem->surface;
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double *points = taut_surface_points(surface);

    e->turned = e->problem->edge == TAUT_EDGE_V0 || e->problem->edge == TAUT_EDGE_V1;
    e->reversed = e->problem->edge == TAUT_EDGE_U0 || e->problem->edge == TAUT_EDGE_V0;
    e->n = taut_basis_degree(e->turned ? v : u);
    e->m = taut_basis_degree(e->turned ? u : v);
    e->across = taut_basis_hi(e->turned ? v : u) - taut_basis_lo(e->turned ? v : u);
    e->along = taut_basis_hi(e->turned ? u : v) - taut_basis_lo(e->turned ? u : v);
    e->ratio = e->problem->width > 0 ? e->problem->width / e->across : 1;
    const size_t count = (size_t)(e->n + 1) * (size_t)(e->m + 1);
    e->frame = taut_frame_of(count, points, NULL);
    e->net = taut_arena_take(e->arena, 3 * count, sizeof(double));
    if (e->net == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i <= e->n; i++) {
        for (int j = 0; j <= e->m; j++) {
            memcpy(e->net + 3 * (i * (e->m + 1) + j),
                   points + 3 * index_of(e, taut_basis_count(v), i, j), 3 * sizeof(double));
        }
    }
    taut_frame_enter(&e->frame, count, e->net);
    return TAUT_OK;
}

/* |x_uu + x_vv| as relation (2) of section 2.2, scaled: largest control point of the Laplacian over
 * max(w_u n^2, w_v m^2) times the largest coordinate about the mean. */
static double harmonic_residual(const extension *e)
{
    const int n = e->n, m = e->m;
    const double wu = 1 / (e->across * e->across), wv = 1 / (e->along * e->along);
    double most = 0;
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= m; j++) {
            for (int c = 0; c < 3; c++) {
                const double *p = e->net + 3 * (i * (m + 1) + j) + c;
                const long du = 3 * (m + 1), dv = 3;
                double sum = 0;
                if (i + 1 < n) {
                    sum += wu * (n - i) * (n - i - 1) * (p[2 * du] - 2 * p[du] + p[0]);
                }
                if (i > 0 && i < n) {
                    sum += wu * 2 * i * (n - i) * (p[du] - 2 * p[0] + p[-du]);
                }
                if (i > 1) {
                    sum += wu * i * (i - 1) * (p[0] - 2 * p[-du] + p[-2 * du]);
                }
                if (j + 1 < m) {
                    sum += wv * (m - j) * (m - j - 1) * (p[2 * dv] - 2 * p[dv] + p[0]);
                }
                if (j > 0 && j < m) {
                    sum += wv * 2 * j * (m - j) * (p[dv] - 2 * p[0] + p[-dv]);
                }
                if (j > 1) {
                    sum += wv * j * (j - 1) * (p[0] - 2 * p[-dv] + p[-2 * dv]);
                }
                most = fmax(most, fabs(sum));
            }
        }
    }
    return most / fmax(wu * n * n, wv * m * m);
}

/* The net over [1, 1 + h] of the normalised parameter, or with `merged` over [0, 1 + h]: row k is
 * the blossom with k arguments 1 + h and the others 1, or 0, which is one side of de Casteljau's
 * triangle at 1 + h. */
static void extrapolate(const extension *e, int merged, double *out)
{
    const int n = e->n, length = 3 * (e->m + 1);
    const double t = 1 + e->ratio;
    double column[TAUT_DEGREE_MAX + 1];

    for (int c = 0; c < length; c++) {
        for (int i = 0; i <= n; i++) {
            column[i] = e->net[i * length + c];
        }
        for (int k = 0; k <= n; k++) {
            out[k * length + c] = merged ? column[0] : column[n - k];
            for (int i = 0; i + k < n; i++) {
                column[i] = (1 - t) * column[i] + t * column[i + 1];
            }
        }
    }
}

/* The derivative across the neighbour's first edge, in its own normalised parameter:
 *     h (c P_u + (alpha + beta v) P_v),  P_u and P_v by parameter length on the shared edge. */
static void g1_derivative(const extension *e, double *cross)
{
    const taut_harmonic_extension_problem *p = e->problem;
    const int n = e->n, m = e->m;
    const double *edge = e->net + 3 * n * (m + 1), *before = edge - 3 * (m + 1);
    const double width = e->ratio * e->across;

    for (int j = 0; j <= m; j++) {
        for (int c = 0; c < 3; c++) {
            /* (alpha + beta v) P_v: P_v has degree m-1 and points d_i; alpha P_v is raised to m,
             * beta v P_v is sum_i (i/m) d_{i-1} */
            const double lower = j > 0 ? m * (edge[3 * j + c] - edge[3 * (j - 1) + c]) : 0;
            const double upper = j < m ? m * (edge[3 * (j + 1) + c] - edge[3 * j + c]) : 0;
            const double s = (double)j / m;
            const double along = p->alpha * (s * lower + (1 - s) * upper) + p->beta * s * lower;
            const double across = n * (edge[3 * j + c] - before[3 * j + c]) / e->across;
            cross[3 * j + c] = width * (p->c * across + along / e->along);
        }
    }
}

static taut_status complete_g1(extension *e, double *out, double *amplification, taut_error *error)
{
    const int n = e->n, m = e->m;
    const double ratio = e->ratio * e->across / e->along;
    const double limit = fmax(1e-10, 4 * ldexp(DBL_EPSILON, m) * taut_frame_reach(&e->frame));
    double *cross = taut_arena_take(e->arena, 3 * (size_t)(m + 1), sizeof(double));
    double *scratch =
        taut_arena_take(e->arena, 4 * (size_t)(n + 1) * (size_t)(m + 1), sizeof(double));
    double top[3];

    if (cross == NULL || scratch == NULL) {
        return taut_fail_memory(error);
    }
    if (n < m) {
        return taut_fail(
            error, TAUT_NO_SOLUTION, "/surface", n, m,
            "a neighbour with the same tangent planes needs degree %d across the edge, "
            "found %d",
            m, n);
    }
    g1_derivative(e, cross);
    taut_top_difference(m, cross, top);
    const double defect = fmax(fabs(top[0]), fmax(fabs(top[1]), fabs(top[2])));
    if (m % 2 == 0 && n == m && defect > limit) {
        return taut_fail(error, TAUT_NO_SOLUTION, "/beta", defect * e->frame.size,
                         limit * e->frame.size,
                         "inconsistent derivative: the degree %d is even, so \"beta\" must be 0 "
                         "here (the top difference is %.6g)",
                         m, defect * e->frame.size);
    }
    taut_harmonic_from_derivative(n, m, ratio * ratio, e->net + 3 * n * (m + 1), cross, out);
    *amplification = taut_harmonic_derivative_amplification(n, m, ratio * ratio, scratch);
    return TAUT_OK;
}

/* A surface from a turned net whose first row lies `start` (in widths of the given surface) from
 * its first edge and which is `length` widths long. */
static taut_status to_surface(const extension *e, const char *name, double *net, double start,
                              double length, taut_surface **surface, taut_error *error)
{
    const taut_surface *given = e->problem->surface;
    const taut_basis *across = e->turned ? taut_surface_v(given) : taut_surface_u(given);
    const int columns = taut_basis_count(taut_surface_v(given));
    const size_t count = (size_t)(e->n + 1) * (size_t)(e->m + 1);
    double *points = taut_arena_take(e->arena, 3 * count, sizeof(double));
    const double lo = taut_basis_lo(across), hi = taut_basis_hi(across);
    taut_basis_spec spec;
    taut_basis *basis = NULL;
    taut_status status = TAUT_OK;

    if (points == NULL) {
        return taut_fail_memory(error);
    }
    taut_frame_leave(&e->frame, count, net);
    for (int i = 0; i <= e->n; i++) {
        for (int j = 0; j <= e->m; j++) {
            memcpy(points + 3 * index_of(e, columns, i, j), net + 3 * (i * (e->m + 1) + j),
                   3 * sizeof(double));
        }
    }
    taut_basis_spec_of(across, &spec);
    spec.has_range = 1;
    spec.range[0] = e->reversed ? (hi - (start + length) * e->across) : start > 0 ? hi : lo;
    spec.range[1] = e->reversed ? (start > 0 ? lo : hi) : lo + (start + length) * e->across;
    status = taut_basis_new(&spec, e->n + 1, &basis, error);
    if (status == TAUT_OK) {
        status = taut_surface_new(name, e->turned ? taut_surface_u(given) : basis,
                                  e->turned ? basis : taut_surface_v(given), points, NULL, surface,
                                  error);
    }
    taut_basis_free(basis);
    return status;
}

static taut_status check_problem(const taut_harmonic_extension_problem *problem, taut_error *error)
{
    const taut_surface *surface = problem != NULL ? problem->surface : NULL;
    if (surface == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, NULL, taut_none, taut_none,
                         "an extension needs a surface");
    }
    if (strcmp(taut_basis_type(taut_surface_u(surface)), "bezier") != 0 ||
        strcmp(taut_basis_type(taut_surface_v(surface)), "bezier") != 0 ||
        taut_surface_weights(surface) != NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "/surface", taut_none, taut_none,
                         "expected a polynomial surface on \"bezier\" bases");
    }
    if (!(problem->width >= 0) || !isfinite(problem->width)) {
        return taut_fail(error, TAUT_BAD_INPUT, "/width", problem->width, 0,
                         "bad parameter: width is %.17g, expected a positive number",
                         problem->width);
    }
    if (problem->contact == TAUT_CONTACT_G1 &&
        !(problem->c > 0 && isfinite(problem->c) && isfinite(problem->alpha) &&
          isfinite(problem->beta))) {
        return taut_fail(error, TAUT_BAD_INPUT, "/c", problem->c, 0,
                         "bad parameter: c is %.17g, expected a positive number", problem->c);
    }
    return TAUT_OK;
}

static taut_status fill_model(extension *e, taut_model *model, taut_error *error)
{
    const size_t numbers = 3 * (size_t)(e->n + 1) * (size_t)(e->m + 1);
    const int g1 = e->problem->contact == TAUT_CONTACT_G1;
    double *next = taut_arena_take(e->arena, numbers, sizeof(double));
    double *merged = taut_arena_take(e->arena, numbers, sizeof(double));
    double amplification = pow(1 + 2 * e->ratio, e->n);
    taut_surface *surfaces[3] = {NULL, NULL, NULL};
    taut_record *details = NULL;
    taut_status status = next != NULL && merged != NULL ? TAUT_OK : taut_fail_memory(error);

    if (status == TAUT_OK && g1) {
        status = complete_g1(e, next, &amplification, error);
    } else if (status == TAUT_OK) {
        extrapolate(e, 0, next);
        extrapolate(e, 1, merged);
    }
    if (status == TAUT_OK && taut_surface_copy(e->problem->surface, &surfaces[0]) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        memcpy(next, e->net + 3 * e->n * (e->m + 1), (size_t)(3 * (e->m + 1)) * sizeof(double));
        status = to_surface(e, "extension", next, 1, e->ratio, &surfaces[1], error);
    }
    if (status == TAUT_OK && !g1) {
        status = to_surface(e, "h", merged, 0, 1 + e->ratio, &surfaces[2], error);
    }
    for (int i = 0; i < 3; i++) {
        if (status == TAUT_OK && surfaces[i] != NULL) {
            status = taut_model_add_surface(model, surfaces[i]);
            surfaces[i] = status == TAUT_OK ? NULL : surfaces[i];
        }
        taut_surface_free(surfaces[i]);
    }
    if (status == TAUT_OK) {
        details = taut_record_new();
        taut_record_add_number(details, "amplification", amplification);
        taut_record_add_null(details, "repair");
        taut_model_set_details(model, details);
        status = taut_record_status(details) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
    }
    return status;
}

taut_status taut_harmonic_extension_make(const taut_harmonic_extension_problem *problem,
                                         const taut_make_options *options, taut_model **model,
                                         taut_error *error)
{
    extension e = {.problem = problem};
    taut_model *made = NULL;
    taut_status status = check_problem(problem, error);

    (void)options; /* exact to rounding, and quick */
    if (status != TAUT_OK) {
        return status;
    }
    e.arena = taut_arena_new();
    status =
        e.arena != NULL && taut_model_new(&made) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
    if (status == TAUT_OK) {
        status = turn(&e, error);
    }
    if (status == TAUT_OK) {
        const double residual = harmonic_residual(&e);
        const double limit = fmax(harmonic_limit, 4 * DBL_EPSILON * taut_frame_reach(&e.frame));
        if (!(residual <= limit)) {
            status = taut_fail(error, TAUT_NO_SOLUTION, "/surface", residual, limit,
                               "not harmonic: the surface's scaled residual is %.3g, expected at "
                               "most %.0e over its own rectangle",
                               residual, limit);
        }
    }
    if (status == TAUT_OK) {
        status = fill_model(&e, made, error);
    }
    taut_arena_free(e.arena);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *model = made;
    return TAUT_OK;
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_harmonic_extension_make(data, options, model, error);
}

const taut_construct_ops taut_construct_harmonic_extension = {.make = make};
