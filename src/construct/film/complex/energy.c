#include "construct/film/complex/energy.h"

#include "core/memory.h"
#include "core/vec3.h"
#include "numeric/sum.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LOCAL_MAX = 11 /* of degree 10 */, ELEMENT = 10 };

static const double blend_least = 1e-3;

static int cells_of(const taut_area_axis *axis)
{
    return axis->count / axis->nodes;
}

/* ---- which nodes meet ---- */

/* The nodes of a cell, function by function; how many functions. */
static int alive(const taut_film_energy *e, int p, int cu, int cv, int *nodes)
{
    const taut_film_complex *c = &e->layout->complex;
    const taut_area_functional *area = e->areas[p];
    const int fu = area->u.first[cu * area->u.nodes], fv = area->v.first[cv * area->v.nodes];
    int count = 0;

    for (int i = 0; i < area->u.local; i++) {
        for (int j = 0; j < area->v.local; j++) {
            nodes[count++] = c->node[c->first[p] + (fu + i) * area->nv + fv + j];
        }
    }
    return count;
}

typedef struct cliques {
    int count;
    int *first, *members;
} cliques;

/* Each node once. */
static taut_status find_cliques(const taut_film_energy *e, taut_arena *arena, cliques *made)
{
    const taut_film_complex *c = &e->layout->complex;
    int cells = 0, most = 0, local = 0;
    int *mark = taut_arena_take(arena, (size_t)c->nodes, sizeof(int));

    for (int p = 0; p < c->problem->patch_count; p++) {
        const int all = cells_of(&e->areas[p]->u) * cells_of(&e->areas[p]->v);
        const int each = e->areas[p]->u.local * e->areas[p]->v.local;
        cells += all;
        most += all * each;
        local = each > local ? each : local;
    }
    made->first = taut_arena_take(arena, (size_t)cells + 1, sizeof(int));
    made->members = taut_arena_take(arena, (size_t)most, sizeof(int));
    int *nodes = taut_arena_take(arena, (size_t)local, sizeof(int));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    int n = 0;
    for (int p = 0; p < c->problem->patch_count; p++) {
        const int nv = cells_of(&e->areas[p]->v);
        for (int k = 0; k < cells_of(&e->areas[p]->u) * nv; k++) {
            const int count = alive(e, p, k / nv, k % nv, nodes);
            made->first[made->count++] = n;
            for (int a = 0; a < count; a++) {
                if (mark[nodes[a]] != made->count) {
                    mark[nodes[a]] = made->count;
                    made->members[n++] = nodes[a];
                }
            }
        }
    }
    made->first[made->count] = n;
    return TAUT_OK;
}

static int compare(const void *a, const void *b)
{
    const int x = *(const int *)a, y = *(const int *)b;
    return (x > y) - (x < y);
}

/* The lower half of the rows: of each node those of its cliques, in order. */
static taut_status find_rows(taut_film_energy *e, taut_arena *scratch, const cliques *made)
{
    const int nodes = e->layout->complex.nodes, all = made->first[made->count];
    int *count = taut_arena_take(scratch, (size_t)nodes + 1, sizeof(int));
    int *of = taut_arena_take(scratch, (size_t)all, sizeof(int));
    int *mark = taut_arena_take(scratch, (size_t)nodes, sizeof(int));

    e->start = taut_arena_take(e->arena, (size_t)nodes + 1, sizeof(int));
    if (taut_arena_status(scratch) != TAUT_OK || e->start == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < all; k++) {
        count[made->members[k] + 1]++;
    }
    for (int a = 0; a < nodes; a++) {
        count[a + 1] += count[a];
    }
    for (int k = 0; k < made->count; k++) { /* afterwards count[a] is where those of a end */
        for (int m = made->first[k]; m < made->first[k + 1]; m++) {
            of[count[made->members[m]]++] = k;
        }
    }
    for (int round = 0; round < 2; round++) {
        int n = 0;
        memset(mark, 0, (size_t)nodes * sizeof(int));
        for (int a = 0; a < nodes; a++) {
            e->start[a] = n;
            for (int k = a == 0 ? 0 : count[a - 1]; k < count[a]; k++) {
                for (int m = made->first[of[k]]; m < made->first[of[k] + 1]; m++) {
                    const int b = made->members[m];
                    if (b <= a && mark[b] != a + 1) {
                        mark[b] = a + 1;
                        if (round == 1) {
                            e->column[n] = b;
                        }
                        n++;
                    }
                }
            }
            if (round == 1) {
                qsort(e->column + e->start[a], (size_t)(n - e->start[a]), sizeof(int), compare);
            }
        }
        e->start[nodes] = n;
        if (round == 0) {
            e->column = taut_arena_take(e->arena, (size_t)n, sizeof(int));
            e->second = taut_arena_take(e->arena, (size_t)n, 9 * sizeof(double));
            e->metric = taut_arena_take(e->arena, (size_t)n, sizeof(double));
            if (taut_arena_status(e->arena) != TAUT_OK) {
                return TAUT_NO_MEMORY;
            }
        }
    }
    return TAUT_OK;
}

/* What a node's planes leave: unit vectors, orthogonal. */
static void find_free(taut_film_energy *e, int a)
{
    const taut_film_complex *c = &e->layout->complex;
    taut_film_hold hold = c->holds[a];
    int count = 0;

    for (int k = 0; c->kind[a] != TAUT_FILM_NODE_HELD && hold.count < 3 && k < 3; k++) {
        const double axis[3] = {k == 0, k == 1, k == 2};
        double left[3] = {axis[0], axis[1], axis[2]};
        const int before = hold.count;
        for (int n = 0; n < before; n++) {
            taut_add_scaled(-taut_dot(left, hold.normals[n]), hold.normals[n], left);
        }
        if (taut_norm(left) < 0.3) { /* another axis is farther from them */
            continue;
        }
        (void)taut_film_hold_add(&hold, axis, 0, INFINITY);
        memcpy(e->free + 9 * a + 3 * count++, hold.normals[before], 3 * sizeof(double));
    }
    e->size[a] = (unsigned char)count;
}

static taut_status connect(taut_film_energy *e)
{
    const taut_film_complex *c = &e->layout->complex;
    taut_arena *scratch = taut_arena_new();
    cliques made = {.count = 0};
    taut_status status = find_cliques(e, scratch, &made);

    if (status == TAUT_OK) {
        status = find_rows(e, scratch, &made);
    }
    if (status == TAUT_OK) {
        for (int a = 0; a < c->nodes; a++) {
            find_free(e, a);
        }
        status =
            taut_sparse_new(c->nodes, e->size, made.count, made.first, made.members, &e->sparse);
    }
    taut_arena_free(scratch);
    return status;
}

static taut_status make_parts(taut_film_energy *e, int extra)
{
    const taut_film_complex *c = &e->layout->complex;
    taut_status status = TAUT_OK;

    for (int p = 0; status == TAUT_OK && p < c->problem->patch_count; p++) {
        const taut_film_problem *patch = &c->problem->patches[p];
        status = taut_area_functional_new(patch->u, patch->v, NULL, extra, &e->areas[p]);
        e->shares[p] = e->layout->tensions[p] / e->layout->tensions[0];
    }
    for (int k = 0; status == TAUT_OK && k < c->strand_count; k++) {
        const taut_film_side *side = &c->strands[k].side;
        const taut_film_problem *patch = &c->problem->patches[side->patch];
        const int first = taut_film_complex_point(patch, side->edge, 0),
                  next = taut_film_complex_point(patch, side->edge, 1);
        status = taut_area_cable_new(side->edge < 2 ? patch->v : patch->u, extra + 1,
                                     (size_t)(c->first[side->patch] + first),
                                     (size_t)(next - first), e->arena, &e->cables[k]);
        e->cables[k].tension = e->layout->ratios[k];
    }
    return status;
}

taut_status taut_film_energy_new(const taut_film_layout *layout, int extra,
                                 taut_film_energy **energy)
{
    const taut_film_complex *c = &layout->complex;
    const size_t patches = (size_t)c->problem->patch_count;
    taut_film_energy *e = taut_alloc_zero(1, sizeof *e);

    if (e == NULL) {
        return TAUT_NO_MEMORY;
    }
    e->layout = layout;
    e->arena = taut_arena_new();
    e->areas = taut_arena_take(e->arena, patches, sizeof *e->areas);
    e->shares = taut_arena_take(e->arena, patches, sizeof(double));
    e->cables = taut_arena_take(e->arena, (size_t)c->strand_count, sizeof *e->cables);
    e->element = taut_arena_take(e->arena, layout->pairs, ELEMENT * sizeof(double));
    e->net = taut_arena_take(e->arena, (size_t)c->points, 3 * sizeof(double));
    e->slopes = taut_arena_take(e->arena, (size_t)c->points, 3 * sizeof(double));
    e->size = taut_arena_take(e->arena, (size_t)c->nodes, 1);
    e->free = taut_arena_take(e->arena, (size_t)c->nodes, 9 * sizeof(double));
    taut_status status = taut_arena_status(e->arena);
    if (status == TAUT_OK) {
        status = make_parts(e, extra);
    }
    if (status == TAUT_OK) {
        status = connect(e);
    }
    if (status != TAUT_OK) {
        taut_film_energy_free(e);
        return status;
    }
    *energy = e;
    return TAUT_OK;
}

void taut_film_energy_free(taut_film_energy *energy)
{
    if (energy == NULL) {
        return;
    }
    for (int p = 0; energy->areas != NULL && p < energy->layout->complex.problem->patch_count;
         p++) {
        taut_area_functional_free(energy->areas[p]);
    }
    taut_sparse_free(energy->sparse);
    taut_arena_free(energy->arena);
    taut_free(energy);
}

/* ---- the first derivative ---- */

double taut_film_energy_value(taut_film_energy *energy, const double *x, double *gradient,
                              double *largest)
{
    const taut_film_complex *c = &energy->layout->complex;
    taut_sum sum = {0, 0};

    for (int k = 0; k < c->points; k++) {
        memcpy(energy->net + 3 * k, x + 3 * c->node[k], 3 * sizeof(double));
    }
    energy->least = INFINITY;
    memset(energy->slopes, 0, 3 * (size_t)c->points * sizeof(double));
    for (int p = 0; p < c->problem->patch_count; p++) {
        const size_t at = 3 * (size_t)c->first[p];
        const taut_area_value value =
            gradient != NULL ? taut_area_functional_gradient(energy->areas[p], energy->net + at,
                                                             energy->slopes + at)
                             : taut_area_functional_value(energy->areas[p], energy->net + at);
        taut_sum_add(&sum, energy->shares[p] * value.area);
        energy->least = fmin(energy->least, value.least);
        for (size_t k = at; k < 3 * (size_t)c->first[p + 1]; k++) {
            energy->slopes[k] *= energy->shares[p];
        }
    }
    for (size_t k = 0; largest != NULL && k < 3 * (size_t)c->points; k++) {
        *largest = fmax(k == 0 ? 0 : *largest, fabs(energy->slopes[k]));
    }
    for (int k = 0; k < c->strand_count; k++) {
        taut_area_cable *cable = &energy->cables[k];
        const double length = gradient != NULL
                                  ? taut_area_cable_gradient(cable, energy->net, energy->slopes)
                                  : taut_area_cable_length(cable, energy->net);
        taut_sum_add(&sum, taut_area_cable_energy(cable, length));
    }
    if (gradient != NULL) {
        memset(gradient, 0, 3 * (size_t)c->nodes * sizeof(double));
        for (int k = 0; k < c->points; k++) {
            taut_add_scaled(1, energy->slopes + 3 * k, gradient + 3 * c->node[k]);
        }
    }
    return taut_sum_total(&sum);
}

/* ---- the second ---- */

/* Where block (a, b), b <= a, is. */
static size_t find_block(const taut_film_energy *e, int a, int b)
{
    int lo = e->start[a], hi = e->start[a + 1] - 1;
    while (lo < hi) {
        const int mid = (lo + hi) / 2;
        if (e->column[mid] < b) {
            lo = mid + 1;
        } else {
            hi = mid;
        }
    }
    return (size_t)lo;
}

/* The block of functions at nodes a and b, of one pair of functions; of two functions at one node both ways. */
static void add_block(taut_film_energy *e, int a, int b, int same, const double h[9], double metric)
{
    const size_t at = find_block(e, a > b ? a : b, a > b ? b : a);
    double *to = e->second + 9 * at;
    const int twice = a == b && !same;

    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            to[3 * i + j] += (a >= b ? h[3 * i + j] : h[3 * j + i]) + (twice ? h[3 * j + i] : 0);
        }
    }
    e->metric[at] += twice ? 2 * metric : metric;
}

/* element[pair][ELEMENT]: s n n^T in six numbers, t n in three, s; pairs (p, q), q <= p. */
static void add_node(const taut_area_functional *area, int line, int k, double *element)
{
    const taut_area_axis *u = &area->u, *v = &area->v;
    const int local = u->local * v->local;
    double state[TAUT_AREA_STATE], pu[LOCAL_MAX * LOCAL_MAX], pv[LOCAL_MAX * LOCAL_MAX];

    taut_area_functional_state(area, line, k, state);
    const double *n = state, e = state[3], f = state[4], g = state[5], w = state[6];
    for (int i = 0; i < u->local; i++) {
        for (int j = 0; j < v->local; j++) {
            pu[i * v->local + j] = u->slope[line * u->local + i] * v->value[k * v->local + j];
            pv[i * v->local + j] = u->value[line * u->local + i] * v->slope[k * v->local + j];
        }
    }
    for (int p = 0; p < local; p++) {
        const double fu = g * pu[p] - f * pv[p], fv = e * pv[p] - f * pu[p];
        const double nu = w * pu[p], nv = w * pv[p];
        for (int q = 0; q <= p; q++, element += ELEMENT) {
            const double s = fu * pu[q] + fv * pv[q], t = nu * pv[q] - nv * pu[q];
            element[0] += s * n[0] * n[0];
            element[1] += s * n[0] * n[1];
            element[2] += s * n[0] * n[2];
            element[3] += s * n[1] * n[1];
            element[4] += s * n[1] * n[2];
            element[5] += s * n[2] * n[2];
            element[6] += t * n[0];
            element[7] += t * n[1];
            element[8] += t * n[2];
            element[9] += s;
        }
    }
}

/* H d = s n (n . d) - t n x d. */
static void scatter(taut_film_energy *e, int p, const int *nodes, int count, const double *element)
{
    const double share = e->shares[p];

    for (int a = 0; a < count; a++) {
        for (int b = 0; b <= a; b++, element += ELEMENT) {
            const double *m = element, *t = element + 6;
            const double h[9] = {
                share * m[0],          share * (m[1] + t[2]), share * (m[2] - t[1]),
                share * (m[1] - t[2]), share * m[3],          share * (m[4] + t[0]),
                share * (m[2] + t[1]), share * (m[4] - t[0]), share * m[5]};
            add_block(e, nodes[a], nodes[b], a == b, h, share * m[9]);
        }
    }
}

static void add_cable(taut_film_energy *e, int k)
{
    const taut_film_complex *c = &e->layout->complex;
    const taut_area_cable *cable = &e->cables[k];

    for (int node = 0; node < cable->nodes; node++) {
        const double *t = cable->state + (size_t)node * TAUT_AREA_CABLE_STATE;
        const double *slope = cable->slope + (size_t)node * (size_t)cable->local;
        for (int a = 0; a < cable->local; a++) {
            for (int b = 0; b <= a; b++) {
                const double s = cable->tension * t[3] * slope[a] * slope[b];
                double h[9];
                for (int i = 0; i < 9; i++) {
                    h[i] = s * ((i % 4 == 0) - t[i / 3] * t[i % 3]);
                }
                const size_t at = cable->first + (size_t)cable->alive[node] * cable->step;
                add_block(e, c->node[at + (size_t)a * cable->step],
                          c->node[at + (size_t)b * cable->step], a == b, h, s);
            }
        }
    }
}

void taut_film_energy_second(taut_film_energy *energy)
{
    const taut_film_complex *c = &energy->layout->complex;
    int nodes[LOCAL_MAX * LOCAL_MAX];
    const size_t blocks = (size_t)energy->start[c->nodes];

    memset(energy->second, 0, blocks * 9 * sizeof(double));
    memset(energy->metric, 0, blocks * sizeof(double));
    for (int p = 0; p < c->problem->patch_count; p++) {
        const taut_area_functional *area = energy->areas[p];
        const int cu = cells_of(&area->u), cv = cells_of(&area->v);
        for (int cell = 0; cell < cu * cv; cell++) {
            const int count = alive(energy, p, cell / cv, cell % cv, nodes);
            memset(energy->element, 0,
                   (size_t)count * (size_t)(count + 1) / 2 * ELEMENT * sizeof(double));
            for (int i = 0; i < area->u.nodes; i++) {
                for (int j = 0; j < area->v.nodes; j++) {
                    add_node(area, cell / cv * area->u.nodes + i, cell % cv * area->v.nodes + j,
                             energy->element);
                }
            }
            scatter(energy, p, nodes, count, energy->element);
        }
    }
    for (int k = 0; k < c->strand_count; k++) {
        add_cable(energy, k);
    }
}

static void block_of(const void *context, int a, int b, double *block)
{
    const taut_film_energy *e = context;
    const int upper = b > a;
    const size_t at = find_block(e, upper ? b : a, upper ? a : b);
    const double *h = e->second + 9 * at;
    const int blends = e->theta > blend_least;
    const double shift = blends || a == b ? e->theta * e->metric[at] : 0;
    const double share = blends ? 1 - e->theta : 1;
    double full[9];

    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            full[3 * i + j] = share * h[upper ? 3 * j + i : 3 * i + j] + (i == j ? shift : 0);
        }
    }
    for (int i = 0; i < e->size[a]; i++) {
        for (int j = 0; j < e->size[b]; j++) {
            const double *left = e->free + 9 * a + 3 * i, *right = e->free + 9 * b + 3 * j;
            double sum = 0;
            for (int r = 0; r < 3; r++) {
                sum += left[r] * taut_dot(full + 3 * r, right);
            }
            block[i * e->size[b] + j] = sum;
        }
    }
}

taut_status taut_film_energy_factor(taut_film_energy *energy, double theta, int *negative)
{
    energy->theta = theta;
    return taut_sparse_factor(energy->sparse, block_of, energy, negative);
}

void taut_film_energy_step(const taut_film_energy *energy, const double *gradient, double *right,
                           double *d)
{
    const int nodes = energy->layout->complex.nodes;

    for (int a = 0; a < nodes; a++) {
        for (int k = 0; k < energy->size[a]; k++) {
            right[taut_sparse_row(energy->sparse, a) + k] =
                -taut_dot(gradient + 3 * a, energy->free + 9 * a + 3 * k);
        }
    }
    taut_sparse_solve(energy->sparse, right);
    memset(d, 0, 3 * (size_t)nodes * sizeof(double));
    for (int a = 0; a < nodes; a++) {
        for (int k = 0; k < energy->size[a]; k++) {
            taut_add_scaled(right[taut_sparse_row(energy->sparse, a) + k],
                            energy->free + 9 * a + 3 * k, d + 3 * a);
        }
    }
}
