#include "geometry/nearest.h"

#include "core/arena.h"
#include "core/vec3.h"

#include <math.h>

enum { PER_SPAN = 8, LINES_MAX = 512, STARTS = 32, STEPS = 60, HALVINGS = 30 };

/* Half the square of the distance, its gradient and second derivatives, at t. */
typedef struct local {
    double value, gradient[2], hessian[3]; /* uu, uv, vv */
    double gauss[3];                       /* the part of the hessian that is never negative */
} local;

typedef struct grid {
    int count[2];
    double *at[2];   /* parameters */
    double *squares; /* [u][v] */
} grid;

static local local_at(const taut_surface *s, const double point[3], const double t[2])
{
    double x[6][3], d[3]; /* S, S_u, S_v, S_uu, S_uv, S_vv */
    local l = {.value = INFINITY};

    if (taut_surface_eval(s, t[0], t[1], 2, x[0]) != TAUT_OK) {
        return l;
    }
    for (int c = 0; c < 3; c++) {
        d[c] = x[0][c] - point[c];
    }
    l.value = 0.5 * taut_dot(d, d);
    l.gradient[0] = taut_dot(d, x[1]);
    l.gradient[1] = taut_dot(d, x[2]);
    l.gauss[0] = taut_dot(x[1], x[1]);
    l.gauss[1] = taut_dot(x[1], x[2]);
    l.gauss[2] = taut_dot(x[2], x[2]);
    for (int k = 0; k < 3; k++) {
        l.hessian[k] = l.gauss[k] + taut_dot(d, x[3 + k]);
    }
    return l;
}

/* The step of a 2 x 2 system, in the coordinates that are free; 0 where it is not definite. */
static int solve_step(const double h[3], const double g[2], const int is_free[2], double step[2])
{
    const double det = h[0] * h[2] - h[1] * h[1];

    step[0] = step[1] = 0;
    if (is_free[0] && is_free[1]) {
        if (!(h[0] > 0 && det > 1e-14 * h[0] * h[2])) {
            return 0;
        }
        step[0] = -(h[2] * g[0] - h[1] * g[1]) / det;
        step[1] = -(h[0] * g[1] - h[1] * g[0]) / det;
        return 1;
    }
    for (int d = 0; d < 2; d++) {
        if (is_free[d] && !(h[2 * d] > 0)) {
            return 0;
        }
        step[d] = is_free[d] ? -g[d] / h[2 * d] : 0;
    }
    return 1;
}

/* Down from t, within the window; the least half square. */
static double descend(const taut_surface *s, const double point[3], const double lo[2],
                      const double hi[2], double t[2])
{
    local now = local_at(s, point, t);

    for (int k = 0; k < STEPS; k++) {
        double step[2];
        int is_free[2];
        for (int d = 0; d < 2; d++) {
            is_free[d] =
                !((t[d] <= lo[d] && now.gradient[d] > 0) || (t[d] >= hi[d] && now.gradient[d] < 0));
        }
        if (!solve_step(now.hessian, now.gradient, is_free, step) &&
            !solve_step(now.gauss, now.gradient, is_free, step)) {
            return now.value;
        }
        local next = now;
        double share = 1, to[2] = {t[0], t[1]};
        for (int halving = 0; halving < HALVINGS; halving++, share /= 2) {
            for (int d = 0; d < 2; d++) {
                to[d] = fmin(fmax(t[d] + share * step[d], lo[d]), hi[d]);
            }
            next = local_at(s, point, to);
            if (next.value < now.value) {
                break;
            }
        }
        if (!(next.value < now.value)) {
            return now.value;
        }
        t[0] = to[0];
        t[1] = to[1];
        now = next;
    }
    return now.value;
}

static int fill_parameters(const taut_basis *basis, taut_arena *arena, double **at)
{
    const int spans = taut_basis_span_count(basis);
    const double *breaks = taut_basis_breaks(basis);
    const int per = spans * PER_SPAN + 1 <= LINES_MAX ? PER_SPAN : 1;
    const int count = spans * per + 1;

    *at = taut_arena_take(arena, (size_t)count, sizeof(double));
    for (int k = 0; *at != NULL && k < count; k++) {
        const int span = k / per < spans ? k / per : spans - 1;
        const double share = (double)(k - span * per) / per;
        (*at)[k] = k + 1 == count ? breaks[spans]
                                  : breaks[span] + share * (breaks[span + 1] - breaks[span]);
    }
    return count;
}

/* Is no neighbour nearer? Of equals the first is taken. */
static int is_lowest(const grid *g, int i, int j)
{
    const double own = g->squares[(size_t)i * (size_t)g->count[1] + (size_t)j];
    for (int a = i - 1; a <= i + 1; a++) {
        for (int b = j - 1; b <= j + 1; b++) {
            if (a < 0 || b < 0 || a >= g->count[0] || b >= g->count[1] || (a == i && b == j)) {
                continue;
            }
            const double other = g->squares[(size_t)a * (size_t)g->count[1] + (size_t)b];
            if (other < own || (other == own && (a < i || (a == i && b < j)))) {
                return 0;
            }
        }
    }
    return 1;
}

static void search(const taut_surface *s, const double point[3], const grid *g, double best[2])
{
    const taut_basis *const basis[2] = {taut_surface_u(s), taut_surface_v(s)};
    double lo[2], hi[2], least = INFINITY;
    int starts = 0;

    for (int d = 0; d < 2; d++) {
        lo[d] = taut_basis_lo(basis[d]);
        hi[d] = taut_basis_hi(basis[d]);
        best[d] = lo[d];
    }
    for (int i = 0; i < g->count[0]; i++) {
        for (int j = 0; j < g->count[1] && starts < STARTS; j++) {
            if (is_lowest(g, i, j)) {
                double t[2] = {g->at[0][i], g->at[1][j]};
                const double value = descend(s, point, lo, hi, t);
                starts++;
                if (value < least) {
                    least = value;
                    best[0] = t[0];
                    best[1] = t[1];
                }
            }
        }
    }
}

taut_status taut_surface_nearest(const taut_surface *surface, const double point[3], double *u,
                                 double *v)
{
    taut_arena *arena = taut_arena_new();
    double best[2];
    grid g;

    g.count[0] = fill_parameters(taut_surface_u(surface), arena, &g.at[0]);
    g.count[1] = fill_parameters(taut_surface_v(surface), arena, &g.at[1]);
    const size_t count = (size_t)g.count[0] * (size_t)g.count[1];
    double *points = taut_arena_take_raw(arena, 3 * count, sizeof(double));
    g.squares = taut_arena_take(arena, count, sizeof(double));
    taut_status status = taut_arena_status(arena);
    if (status == TAUT_OK) {
        status =
            taut_surface_eval_grid(surface, g.count[0], g.at[0], g.count[1], g.at[1], 0, 1, points);
    }
    for (size_t k = 0; status == TAUT_OK && k < count; k++) {
        for (int c = 0; c < 3; c++) {
            const double d = points[3 * k + (size_t)c] - point[c];
            g.squares[k] += d * d;
        }
    }
    if (status == TAUT_OK) {
        search(surface, point, &g, best);
        *u = best[0];
        *v = best[1];
    }
    taut_arena_free(arena);
    return status;
}
