#include "construct/film/complex/even.h"

#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { STEPS = 8 /* of a span */, SWEEPS = 20000 };
static const double flat = 1e-12;  /* of the size: roundings of a point */
static const double moved = 1e-12; /* of the size, in a sweep: the last */

/* Functions and slopes at places of one direction. */
typedef struct lines {
    int count, local;
    int *first;     /* [count] */
    double *values; /* [count][2][local] */
} lines;

static taut_status lay_lines(const taut_basis *basis, taut_arena *arena, lines *l)
{
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);

    l->count = spans * STEPS + 1;
    l->local = taut_basis_local(basis);
    l->first = taut_arena_take(arena, (size_t)l->count, sizeof(int));
    l->values = taut_arena_take(arena, (size_t)l->count, 2 * (size_t)l->local * sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < l->count; k++) {
        const int span = k / STEPS < spans ? k / STEPS : spans - 1;
        const double share = (double)(k - span * STEPS) / STEPS;
        l->first[k] = taut_basis_first(basis, span);
        (void)taut_basis_eval(basis, span, (1 - share) * breaks[span] + share * breaks[span + 1], 1,
                              l->values + (size_t)k * 2 * (size_t)l->local);
    }
    return TAUT_OK;
}

/* The area element of a patch at a place, along the plane's normal. node: [nu][nv] */
static double element_at(const double *x, const int *node, int nv, const lines *u, int i,
                         const lines *v, int j, const double normal[3])
{
    const double *n = u->values + (size_t)i * 2 * (size_t)u->local, *d = n + u->local;
    const double *m = v->values + (size_t)j * 2 * (size_t)v->local, *e = m + v->local;
    double xu[3] = {0, 0, 0}, xv[3] = {0, 0, 0};

    for (int a = 0; a < u->local; a++) {
        for (int b = 0; b < v->local; b++) {
            const double *p = x + 3 * node[(u->first[i] + a) * nv + v->first[j] + b];
            taut_add_scaled(d[a] * m[b], p, xu);
            taut_add_scaled(n[a] * e[b], p, xv);
        }
    }
    return taut_det(xu, xv, normal);
}

/* Does a patch turn over at one of its places? *folds. */
static taut_status look_at_patch(const taut_film_complex *c, int p, const double *x,
                                 const double normal[3], int *folds)
{
    const taut_film_problem *patch = &c->problem->patches[p];
    const int nv = taut_basis_count(patch->v);
    taut_arena *arena = taut_arena_new();
    double least = INFINITY, most = -INFINITY;
    lines u, v;
    taut_status status = lay_lines(patch->u, arena, &u);

    if (status == TAUT_OK) {
        status = lay_lines(patch->v, arena, &v);
    }
    for (int i = 0; status == TAUT_OK && i < u.count; i++) {
        for (int j = 0; j < v.count; j++) {
            const double element = element_at(x, c->node + c->first[p], nv, &u, i, &v, j, normal);
            least = fmin(least, element);
            most = fmax(most, element);
        }
    }
    taut_arena_free(arena);
    *folds |= !(least > 0 || most < 0);
    return status;
}

static taut_status look(const taut_film_complex *c, const double *x, const double normal[3],
                        int *folds)
{
    taut_status status = TAUT_OK;
    *folds = 0;
    for (int p = 0; status == TAUT_OK && !*folds && p < c->problem->patch_count; p++) {
        status = look_at_patch(c, p, x, normal, folds);
    }
    return status;
}

/* The normal of the plane that all nodes are in. 0: they are in none. */
static int find_plane(const taut_film_complex *c, const double *x, double normal[3], double *size)
{
    int far = 0;
    double most = 0;

    *size = 0;
    for (int a = 0; a < c->nodes; a++) {
        const double away = taut_distance(x, x + 3 * a);
        far = away > *size ? a : far;
        *size = fmax(*size, away);
    }
    for (int a = 0; a < c->nodes; a++) {
        double one[3], other[3], across[3];
        taut_difference(x + 3 * far, x, one);
        taut_difference(x + 3 * a, x, other);
        taut_cross(one, other, across);
        if (taut_norm(across) > most) {
            most = taut_norm(across);
            memcpy(normal, across, sizeof across);
        }
    }
    if (!(most > 0)) {
        return 0;
    }
    for (int k = 0; k < 3; k++) {
        normal[k] /= most;
    }
    for (int a = 0; a < c->nodes; a++) {
        double from[3];
        taut_difference(x + 3 * a, x, from);
        if (!(fabs(taut_dot(from, normal)) <= flat * *size)) {
            return 0;
        }
    }
    return 1;
}

/* Adds a neighbour to the sums of a node: [nodes][4], the last of weights. */
static void add_pair(const double *x, int a, int b, double weight, double *sums)
{
    const int pair[2] = {a, b};
    for (int k = 0; k < 2; k++) {
        double *sum = sums + 4 * pair[k];
        taut_add_scaled(weight, x + 3 * pair[1 - k], sum);
        sum[3] += weight;
    }
}

static void add_all(const taut_film_complex *c, const double *x, double *sums)
{
    memset(sums, 0, 4 * (size_t)c->nodes * sizeof *sums);
    for (int p = 0; p < c->problem->patch_count; p++) {
        const taut_film_problem *patch = &c->problem->patches[p];
        const int nu = taut_basis_count(patch->u), nv = taut_basis_count(patch->v);
        const int *node = c->node + c->first[p];
        for (int i = 0; i < nu; i++) {
            for (int j = 0; j < nv; j++) {
                const double along_u = j == 0 || j == nv - 1 ? 0.5 : 1;
                const double along_v = i == 0 || i == nu - 1 ? 0.5 : 1;
                if (i + 1 < nu) {
                    add_pair(x, node[i * nv + j], node[(i + 1) * nv + j], along_u, sums);
                }
                if (j + 1 < nv) {
                    add_pair(x, node[i * nv + j], node[i * nv + j + 1], along_v, sums);
                }
            }
        }
    }
}

/* Each free node to the mean of its neighbours, until none moves. Sweeps of Chebyshev's would be fewer; these are cheap. */
static void even_out(const taut_film_layout *layout, double size, double *x, double *sums)
{
    const taut_film_complex *c = &layout->complex;
    double way = INFINITY;

    for (int sweep = 0; sweep < SWEEPS && way > moved * size; sweep++) {
        way = 0;
        add_all(c, x, sums);
        for (int a = 0; a < c->nodes; a++) {
            const double *sum = sums + 4 * a;
            if (layout->known[a] || c->holds[a].count > 0 || !(sum[3] > 0)) {
                continue;
            }
            for (int k = 0; k < 3; k++) {
                const double to = sum[k] / sum[3];
                way = fmax(way, fabs(to - x[3 * a + k]));
                x[3 * a + k] = to;
            }
        }
    }
}

taut_status taut_film_even(const taut_film_layout *layout, double *x, int *made)
{
    const taut_film_complex *c = &layout->complex;
    const size_t nodes = (size_t)c->nodes;
    double normal[3] = {0, 0, 0}, size = 0;
    int folds = 0;

    *made = 0;
    if (c->rope_count > 0 || c->problem->cell_count > 0 || !find_plane(c, x, normal, &size)) {
        return TAUT_OK;
    }
    taut_status status = look(c, x, normal, &folds);
    if (status != TAUT_OK || !folds) {
        return status;
    }
    taut_arena *arena = taut_arena_new();
    double *even = taut_arena_copy(arena, x, nodes, 3 * sizeof *even);
    double *sums = taut_arena_take(arena, nodes, 4 * sizeof *sums);
    status = taut_arena_status(arena);
    if (status == TAUT_OK) {
        even_out(layout, size, even, sums);
        status = look(c, even, normal, &folds);
    }
    if (status == TAUT_OK && !folds) {
        memcpy(x, even, 3 * nodes * sizeof *x);
        *made = 1;
    }
    taut_arena_free(arena);
    return status;
}
