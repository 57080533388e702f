#include "construct/harmonic/neighbour.h"

#include "core/exact.h"
#include "core/fail.h"
#include "taut/limits.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

static size_t index_of(const taut_neighbour *e, int columns, int i, int j)
{
    const int line = e->reversed ? e->n - i : i;
    return e->turned ? (size_t)j * (size_t)columns + (size_t)line
                     : (size_t)line * (size_t)columns + (size_t)j;
}

/* The parameter where `other` ends if its range begins at the edge; else `end`. */
static double far_end(const taut_neighbour *e, double here, double end)
{
    const int is_v = e->edge == TAUT_EDGE_V0 || e->edge == TAUT_EDGE_V1;
    if (e->other == NULL) {
        return end;
    }
    const taut_basis *across = is_v ? taut_surface_v(e->other) : taut_surface_u(e->other);
    const double near = e->reversed ? taut_basis_hi(across) : taut_basis_lo(across);
    const double far = e->reversed ? taut_basis_lo(across) : taut_basis_hi(across);
    return near == here ? far : end;
}

taut_status taut_neighbour_turn(taut_neighbour *e, double width, taut_error *error)
{
    const taut_surface *surface = e->surface;
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double *points = taut_surface_points(surface);

    e->turned = e->edge == TAUT_EDGE_V0 || e->edge == TAUT_EDGE_V1;
    e->reversed = e->edge == TAUT_EDGE_U0 || e->edge == TAUT_EDGE_V0;
    e->n = taut_basis_degree(e->turned ? v : u);
    e->m = taut_basis_degree(e->turned ? u : v);
    e->across = taut_basis_hi(e->turned ? v : u) - taut_basis_lo(e->turned ? v : u);
    e->along = taut_basis_hi(e->turned ? u : v) - taut_basis_lo(e->turned ? u : v);
    e->ratio = width > 0 ? width / e->across : 1;
    const taut_basis *across = e->turned ? v : u;
    const double lo = taut_basis_lo(across), hi = taut_basis_hi(across);
    const double reach = (1 + e->ratio) * e->across;
    const double edge = e->reversed ? lo : hi;
    const double end = far_end(e, edge, e->reversed ? hi - reach : lo + reach);
    if (end == edge || !(fabs(end) <= TAUT_PARAMETER_MAX)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/width", width, taut_none,
                         "bad parameter: the width %.17g from the edge at %.17g leads to %.17g, "
                         "expected another parameter, at most %g in absolute value",
                         width, edge, end, TAUT_PARAMETER_MAX);
    }
    const size_t count = (size_t)(e->n + 1) * (size_t)(e->m + 1);
    e->here = edge;
    e->end = end;
    e->ratio = fabs(end - edge) / e->across; /* of the parameters that there are */
    e->map = taut_unit_map_of(count, points, NULL);
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
    taut_unit_map_apply(&e->map, count, e->net);
    return TAUT_OK;
}

taut_status taut_neighbour_check(const taut_surface *surface, double width, taut_error *error)
{
    if (strcmp(taut_basis_type(taut_surface_u(surface)), "bezier") != 0 ||
        strcmp(taut_basis_type(taut_surface_v(surface)), "bezier") != 0 ||
        taut_surface_weights(surface) != NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "not-bezier", "/surface", taut_none, taut_none,
                         "expected a polynomial surface on \"bezier\" bases");
    }
    if (!(width >= 0) || !isfinite(width)) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "value", "/width", width,
                                  "a positive number", "bad parameter: width is %.17g", width);
    }
    return TAUT_OK;
}

void taut_net_laplacian(int n, int m, double wu, double wv, const double *net, double *laplacian)
{
    const int64_t du = 3 * (m + 1), dv = 3;
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= m; j++) {
            for (int c = 0; c < 3; c++) {
                const double *p = net + i * du + j * dv + c;
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
                laplacian[i * du + j * dv + c] = sum;
            }
        }
    }
}

double taut_neighbour_residual(const taut_neighbour *e, int times, double *scratch)
{
    const int n = e->n, m = e->m, numbers = 3 * (n + 1) * (m + 1);
    const double wu = 1 / (e->across * e->across), wv = 1 / (e->along * e->along);
    const double most = fmax(wu * n * n, wv * m * m);
    const double *from = e->net;
    double *to = scratch, largest = 0;

    for (int k = 0; k < times; k++) {
        taut_net_laplacian(n, m, wu / most, wv / most, from, to);
        from = to;
        to = scratch + numbers;
    }
    for (int i = 0; i < numbers; i++) {
        largest = fmax(largest, fabs(from[i]));
    }
    return largest;
}

/* Row k is the blossom with k arguments 1 + h and the others 1, or 0, which is one side of de
 * Casteljau's triangle at 1 + h. */
void taut_neighbour_extrapolate(const taut_neighbour *e, int merged, double *out)
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

taut_status taut_neighbour_surface(const taut_neighbour *e, const char *name, double *net,
                                   int merged, taut_surface **surface, taut_error *error)
{
    const taut_surface *given = e->surface;
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
    taut_unit_map_undo(&e->map, count, net);
    for (int i = 0; i <= e->n; i++) {
        for (int j = 0; j <= e->m; j++) {
            memcpy(points + 3 * index_of(e, columns, i, j), net + 3 * (i * (e->m + 1) + j),
                   3 * sizeof(double));
        }
    }
    for (int j = 0; j <= e->m; j++) { /* the line it shares with the given surface, bit for bit */
        memcpy(points + 3 * index_of(e, columns, 0, j),
               taut_surface_points(given) + 3 * index_of(e, columns, merged ? 0 : e->n, j),
               3 * sizeof(double));
    }
    taut_basis_spec_of(across, &spec);
    spec.has_range = 1;
    const double near = !merged ? e->here : e->reversed ? hi : lo;
    spec.range[0] = e->reversed ? e->end : near;
    spec.range[1] = e->reversed ? near : e->end;
    status = taut_basis_new(&spec, e->n + 1, &basis, error);
    if (status != TAUT_OK) {
        return status;
    }
    status =
        taut_surface_new(name, e->turned ? taut_surface_u(given) : basis,
                         e->turned ? basis : taut_surface_v(given), points, NULL, surface, error);
    taut_basis_free(basis);
    return status;
}

taut_status taut_neighbour_exact(const taut_surface *surface, taut_arena *arena,
                                 taut_surface **beyond, taut_error *error)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const int along_v = taut_basis_equal(u, taut_surface_u(*beyond));
    const taut_basis *old = along_v ? v : u;
    const taut_basis *other = along_v ? taut_surface_v(*beyond) : taut_surface_u(*beyond);
    const double range[4] = {taut_basis_lo(old), taut_basis_hi(old), taut_basis_lo(other),
                             taut_basis_hi(other)};
    const taut_exact_numbers numbers = {taut_surface_points(surface), taut_surface_exact(surface)};
    const taut_exact_memory memory = taut_exact_memory_of(arena);
    const taut_exact_ops *ops = NULL;
    taut_exact_net net;
    taut_surface *made = NULL;
    taut_status status = taut_exact_load(&ops, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (!ops->rerange(taut_basis_degree(u), taut_basis_degree(v), &numbers, along_v, range, &memory,
                      &net)) {
        return taut_fail_memory(error);
    }
    status =
        taut_surface_new_exact(taut_surface_name(*beyond), taut_surface_u(*beyond),
                               taut_surface_v(*beyond), net.values, NULL, net.texts, &made, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_surface_free(*beyond);
    *beyond = made;
    return TAUT_OK;
}
