/* cells.c
 *
 * S and its derivatives at a place: sums of coefficients by Bernstein's polynomials and theirs,
 *     B[n,i]' = n (B[n-1,i-1] - B[n-1,i]),      B[n,i]'' = n (n - 1) (B[n-2,i-2] - 2 B[n-2,i-1] + B[n-2,i])
 * ([PieglTiller1997] 1.3), and the forms by their definitions.
 */
#include "certify/trace/cells.h"

#include "basis/basis_ops.h"
#include "core/vec3.h"
#include "numeric/kernel/name.h"

#include <math.h>
#include <string.h>

enum { SIDE_MOST = TAUT_NET_CELL_SIDE };
/* W over sqrt(E G): below, the normal is left to who knows what vanishes. */
static const double clear_normal = 1e-4;

static const taut_net_cell_ops *chosen_ops(void)
{
#if defined(__x86_64__)
    if (!taut_kernel_is("baseline")) {
        return &taut_net_cell_avx2;
    }
#endif
    return &taut_net_cell_baseline;
}

taut_status taut_net_cells_new(taut_arena *arena, int count, const taut_surface *const *surfaces,
                               taut_net_cells **made)
{
    taut_net_cells *cells = taut_arena_take(arena, 1, sizeof *cells);
    if (cells == NULL) {
        return TAUT_NO_MEMORY;
    }
    cells->arena = arena;
    cells->ops = chosen_ops();
    cells->surfaces = surfaces;
    memcpy(cells->origin, taut_surface_points(surfaces[0]), sizeof cells->origin);
    cells->list = taut_arena_take(arena, (size_t)count, sizeof *cells->list);
    for (int k = 0; taut_arena_status(arena) == TAUT_OK && k < count; k++) {
        const size_t spans = (size_t)taut_basis_span_count(taut_surface_u(surfaces[k])) *
                             (size_t)taut_basis_span_count(taut_surface_v(surfaces[k]));
        cells->list[k] = taut_arena_take(arena, spans, sizeof(taut_net_cell));
    }
    *made = cells;
    return taut_arena_status(arena);
}

/* The coefficients of a polynomial side by side; 0 where there is no memory for them. */
static int find_points(taut_net_cells *cells, taut_net_cell *one)
{
    const size_t count = (size_t)(one->x[0].p + 1) * (size_t)(one->x[0].q + 1);
    double *points = NULL;

    if (one->x[3].p > 0 || one->x[3].q > 0) {
        return 1;
    }
    points = taut_arena_take(cells->arena, 4 * count, sizeof *points);
    for (size_t k = 0; points != NULL && k < count; k++) {
        for (size_t c = 0; c < 3; c++) {
            points[4 * k + c] = one->x[c].a[k];
        }
    }
    one->points = points;
    return points != NULL;
}

/* Is it one of a degree that is small enough? Then what is told of it is found. */
static int find_cell(taut_net_cells *cells, int on, const int span[2], taut_net_cell *one)
{
    const taut_surface *surface = cells->surfaces[on];
    const taut_basis *basis[2] = {taut_surface_u(surface), taut_surface_v(surface)};

    if (!taut_field_of_surface(cells->arena, surface, span[0], span[1], cells->origin, 0, one->x,
                               one->width) ||
        one->x[3].a == NULL ||
        TAUT_NET_CURVE * (one->x[0].p + one->x[0].q) > TAUT_NET_COMPOSE_DEGREE) {
        return 0;
    }
    for (int d = 0; d < 2; d++) {
        one->lo[d] = taut_basis_breaks(basis[d])[span[d]];
        one->hi[d] = taut_basis_breaks(basis[d])[span[d] + 1];
    }
    for (int c = 0; c < 4; c++) {
        const int count = (one->x[c].p + 1) * (one->x[c].q + 1);
        for (int k = 0; k < count; k++) {
            one->error = fmax(one->error, one->x[c].e[k]);
            one->largest = fmax(one->largest, fabs(one->x[c].a[k]));
        }
    }
    return find_points(cells, one);
}

const taut_net_cell *taut_net_cell_of(taut_net_cells *cells, int on, const int span[2])
{
    const int columns = taut_basis_span_count(taut_surface_v(cells->surfaces[on]));
    taut_net_cell *one = &cells->list[on][(size_t)span[0] * (size_t)columns + (size_t)span[1]];

    if (one->state == 0) {
        one->state = find_cell(cells, on, span, one) ? 1 : -1;
    }
    return one->state == 1 ? one : NULL;
}

/* Is a place in the cell, and in no other one? */
static int is_within(const taut_net_cell *one, const double at[2])
{
    return at[0] >= one->lo[0] && at[0] < one->hi[0] && at[1] >= one->lo[1] && at[1] < one->hi[1];
}

const taut_net_cell *taut_net_cell_at(taut_net_cells *cells, int on, const double at[2])
{
    const taut_surface *surface = cells->surfaces[on];
    const taut_net_cell *last = cells->last;
    if (last != NULL && cells->last_on == on && is_within(last, at)) {
        return last;
    }
    const int span[2] = {taut_basis_span(taut_surface_u(surface), at[0]),
                         taut_basis_span(taut_surface_v(surface), at[1])};
    cells->last = taut_net_cell_of(cells, on, span);
    cells->last_on = on;
    return cells->last;
}

/* b[k][i]: the k-th derivatives of B[n,i] at s. */
static void bernstein_at(int n, double s, double b[3][SIDE_MOST + 1])
{
    double low[3]
              [SIDE_MOST + 4]; /* B of degrees n - 2, n - 1 and n, two places on; 0 beside them */
    memset(low, 0, sizeof low);
    memset(b, 0, 3 * sizeof b[0]);
    low[0][2] = n >= 2; /* of degree 0 */
    for (int degree = 1; degree <= n - 2; degree++) {
        for (int i = degree; i >= 0; i--) {
            low[0][i + 2] = (1 - s) * low[0][i + 2] + s * low[0][i + 1];
        }
    }
    if (n == 1) {
        low[1][2] = 1;
    }
    for (int level = 1; level <= 2; level++) {
        const int degree = n - 2 + level;
        for (int i = 0; degree >= 1 && i <= degree; i++) {
            low[level][i + 2] = (1 - s) * low[level - 1][i + 2] + s * low[level - 1][i + 1];
        }
    }
    if (n == 0) {
        low[2][2] = 1;
    }
    for (int i = 0; i <= n; i++) {
        b[0][i] = low[2][i + 2];
        b[1][i] = n * (low[1][i + 1] - low[1][i + 2]);
        b[2][i] = n * (n - 1) * (low[0][i] - 2 * low[0][i + 1] + low[0][i + 2]);
    }
}

/* The same of degree 3, written out. */
static void bernstein_cubic(double s, double b[3][SIDE_MOST + 1])
{
    const double r = 1 - s;
    const double two[3] = {r * r, r * s + s * r, s * s};

    b[0][0] = r * two[0];
    b[0][1] = r * two[1] + s * two[0];
    b[0][2] = r * two[2] + s * two[1];
    b[0][3] = s * two[2];
    b[1][0] = 3 * -two[0];
    b[1][1] = 3 * (two[0] - two[1]);
    b[1][2] = 3 * (two[1] - two[2]);
    b[1][3] = 3 * two[2];
    b[2][0] = 6 * r;
    b[2][1] = 6 * (s - 2 * r);
    b[2][2] = 6 * (r - 2 * s);
    b[2][3] = 6 * s;
}

static void derivatives_at(const taut_net_cell_ops *ops, const taut_net_cell *one,
                           const double at[2], double x[6][3])
{
    const int p = one->x[0].p, q = one->x[0].q;
    const double s = (at[0] - one->lo[0]) / one->width[0];
    const double t = (at[1] - one->lo[1]) / one->width[1];
    double u[3][SIDE_MOST + 1], v[3][SIDE_MOST + 1];

    if (p == 3 && q == 3) {
        bernstein_cubic(s, u);
        bernstein_cubic(t, v);
    } else {
        bernstein_at(p, s, u);
        bernstein_at(q, t, v);
    }
    ops->sum(one->x[0].p, one->x[0].q, one->points, one->width, u, v, x);
}

/* 0 where the normal is too near to vanishing. */
static int forms_from(const double x[6][3], taut_forms *q)
{
    double normal[3];

    *q = (taut_forms){.e = taut_dot(x[1], x[1]),
                      .f = taut_dot(x[1], x[2]),
                      .g = taut_dot(x[2], x[2]),
                      .regular = 1};
    taut_cross(x[1], x[2], normal);
    q->w = taut_length(normal);
    if (!(q->w > clear_normal * sqrt(q->e * q->g))) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        q->normal[c] = normal[c] / q->w;
    }
    q->l = taut_dot(x[3], q->normal);
    q->m = taut_dot(x[4], q->normal);
    q->n = taut_dot(x[5], q->normal);
    const double area = q->w * q->w;
    q->mean = (q->e * q->n - 2 * q->f * q->m + q->g * q->l) / (2 * area);
    q->gaussian = (q->l * q->n - q->m * q->m) / area;
    return isfinite(q->mean) && isfinite(q->gaussian);
}

int taut_net_cells_look(taut_net_cells *cells, int on, const double at[2], double s[3][3],
                        taut_forms *forms)
{
    const taut_surface *surface = cells->surfaces[on];
    const taut_net_cell *one = taut_net_cell_at(cells, on, at);
    double x[6][3];

    if (one != NULL && one->x[3].p == 0 && one->x[3].q == 0) {
        derivatives_at(cells->ops, one, at, x);
        if (forms_from((const double(*)[3])x, forms)) {
            for (int c = 0; s != NULL && c < 3; c++) {
                s[0][c] = x[0][c] + cells->origin[c];
                s[1][c] = x[1][c];
                s[2][c] = x[2][c];
            }
            return 1;
        }
    }
    return (s == NULL || taut_surface_eval(surface, at[0], at[1], 1, s[0]) == TAUT_OK) &&
           taut_surface_forms_points(surface, 1, &at[0], &at[1], 1, forms) == TAUT_OK;
}
