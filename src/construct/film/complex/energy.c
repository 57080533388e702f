#include "construct/film/complex/energy.h"

#include "construct/film/complex/volume.h"
#include "construct/film/complex/ways.h"
#include "construct/film/threads.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "numeric/sum.h"
#include "problem/film_cells.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LOCAL_MAX = 11 /* of degree 10 */ };

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
            e->all_size[a] = (unsigned char)taut_film_ways_all(c, a, e->all_free + 9 * a);
        }
        status = taut_sparse_new(c->nodes, e->all_size, made.count, made.first, made.members,
                                 &e->all_sparse);
    }
    e->size = e->all_size;
    e->free = e->all_free;
    e->sparse = e->all_sparse;
    taut_arena_free(scratch);
    return status;
}

static int bounds_cell(const taut_film_problem *problem, int p)
{
    for (int k = 0; k < problem->cell_count; k++) {
        if (taut_film_cell_turn(&problem->cells[k], p) != 0) {
            return 1;
        }
    }
    return 0;
}

taut_status taut_film_energy_narrow(taut_film_energy *energy, int narrow)
{
    const taut_film_complex *c = &energy->layout->complex;
    taut_status status = TAUT_OK;

    if (narrow) {
        taut_film_ways_seen(energy, energy->moments, energy->bulge, energy->seen_size,
                            energy->seen_free);
    }
    if (narrow && energy->seen_sparse == NULL) {
        taut_arena *scratch = taut_arena_new();
        cliques made = {.count = 0};
        status = find_cliques(energy, scratch, &made);
        if (status == TAUT_OK) {
            status = taut_sparse_new(c->nodes, energy->seen_size, made.count, made.first,
                                     made.members, &energy->seen_sparse);
        }
        taut_arena_free(scratch);
    }
    energy->size = narrow ? energy->seen_size : energy->all_size;
    energy->free = narrow ? energy->seen_free : energy->all_free;
    energy->sparse = narrow ? energy->seen_sparse : energy->all_sparse;
    return status;
}

static taut_status lay_threads(taut_film_energy *e, int p)
{
    const taut_film_complex *c = &e->layout->complex;
    const taut_film_problem *patch = &c->problem->patches[p];
    const taut_status status = taut_area_density_new(e->areas[p], e->arena, &e->densities[p]);

    if (status == TAUT_OK) {
        taut_film_threads_lay(patch, patch->reference, e->layout->tensions[p], e->areas[p],
                              &e->densities[p]);
    }
    for (int k = c->first[p]; k < c->first[p + 1]; k++) {
        e->threads[c->node[k]] = 1;
    }
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
        if (status == TAUT_OK && taut_film_has_density(patch)) {
            status = lay_threads(e, p);
        }
        e->in_cells[p] = (unsigned char)bounds_cell(c->problem, p);
        if (status == TAUT_OK) {
            const size_t nodes = (size_t)e->areas[p]->u.count * (size_t)e->areas[p]->v.count;
            e->places[p] = taut_arena_take(e->arena, nodes, TAUT_VOLUME_PLACE * sizeof(double));
            status = e->places[p] == NULL ? TAUT_NO_MEMORY : TAUT_OK;
        }
    }
    for (int k = 0; status == TAUT_OK && k < c->strand_count; k++) {
        const taut_film_side *side = &c->strands[k].side;
        const taut_film_problem *patch = &c->problem->patches[side->patch];
        const int first = taut_film_complex_point(patch, side->edge, 0),
                  next = taut_film_complex_point(patch, side->edge, 1);
        status = taut_area_cable_new(side->edge < 2 ? patch->v : patch->u, extra + 1,
                                     (size_t)(c->first[side->patch] + first),
                                     (size_t)(next - first), e->arena, &e->cables[k]);
        e->cables[k].tension = e->layout->drawn[c->strands[k].rope].ratio;
    }
    return status;
}

taut_status taut_film_energy_new(const taut_film_layout *layout, int extra, const taut_crew *crew,
                                 taut_film_energy **energy)
{
    const taut_film_complex *c = &layout->complex;
    const size_t patches = (size_t)c->problem->patch_count;
    taut_film_energy *e = taut_alloc_zero(1, sizeof *e);

    if (e == NULL) {
        return TAUT_NO_MEMORY;
    }
    e->layout = layout;
    e->pulse = crew->pulse;
    e->arena = taut_arena_new();
    e->areas = taut_arena_take(e->arena, patches, sizeof *e->areas);
    e->seen = taut_arena_take(e->arena, patches, sizeof *e->seen);
    e->densities = taut_arena_take(e->arena, patches, sizeof *e->densities);
    e->threads = taut_arena_take(e->arena, (size_t)c->nodes, 1);
    e->shares = taut_arena_take(e->arena, patches, sizeof(double));
    e->cables = taut_arena_take(e->arena, (size_t)c->strand_count, sizeof *e->cables);
    e->forces = taut_arena_take(e->arena, (size_t)c->rope_count, sizeof(double));
    e->lengths = taut_arena_take(e->arena, (size_t)c->rope_count, sizeof(double));
    e->stretches = taut_arena_take(e->arena, (size_t)c->rope_count, sizeof *e->stretches);
    for (int k = 0; e->stretches != NULL && k < c->rope_count; k++) {
        if (layout->drawn[k].law != TAUT_FILM_FORCE) {
            e->stretches[k] = taut_arena_take(e->arena, (size_t)c->nodes, 3 * sizeof(double));
        }
    }
    const size_t cells = (size_t)c->problem->cell_count;
    int wide = 0;
    for (size_t p = 0; p < patches; p++) {
        const int nv = taut_basis_count(c->problem->patches[p].v);
        wide = nv > wide ? nv : wide;
    }
    e->pressures = taut_arena_copy(e->arena, layout->pressures, cells, sizeof(double));
    e->volumes = taut_arena_take(e->arena, cells, sizeof(double));
    e->swells = taut_arena_take(e->arena, cells * (size_t)c->nodes, 3 * sizeof(double));
    e->places = taut_arena_take(e->arena, patches, sizeof *e->places);
    e->pull = taut_arena_take(e->arena, patches, sizeof(double));
    e->lever = taut_arena_take(e->arena, patches, 3 * sizeof(double));
    e->rows = taut_arena_take(e->arena, (size_t)wide, 6 * sizeof(double));
    e->in_cells = taut_arena_take(e->arena, patches, 1);
    e->moments = taut_arena_take(e->arena, (size_t)c->nodes, 3 * sizeof(double));
    e->net = taut_arena_take(e->arena, (size_t)c->points, 3 * sizeof(double));
    e->slopes = taut_arena_take(e->arena, (size_t)c->points, 3 * sizeof(double));
    e->bulge = taut_arena_take(e->arena, (size_t)c->points, 3 * sizeof(double));
    e->all_size = taut_arena_take(e->arena, (size_t)c->nodes, 1);
    e->all_free = taut_arena_take(e->arena, (size_t)c->nodes, 9 * sizeof(double));
    e->seen_size = taut_arena_take(e->arena, (size_t)c->nodes, 1);
    e->seen_free = taut_arena_take(e->arena, (size_t)c->nodes, 9 * sizeof(double));
    taut_status status = taut_arena_status(e->arena);
    if (status == TAUT_OK) {
        status = make_parts(e, extra);
    }
    for (size_t p = 0; status == TAUT_OK && p < patches; p++) {
        e->seen[p] = e->areas[p];
    }
    if (status == TAUT_OK) {
        status = taut_area_elements_new((int)patches, e->seen, crew->threads, &e->elements);
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
    taut_area_elements_free(energy->elements);
    taut_sparse_free(energy->all_sparse);
    taut_sparse_free(energy->seen_sparse);
    taut_arena_free(energy->arena);
    taut_free(energy);
}

/* ---- the first derivative ---- */

/* Volumes and swells; what given pressures store is added to the sum. */
static void add_cells(taut_film_energy *e, int with_gradient, taut_sum *sum)
{
    const taut_film_complex *c = &e->layout->complex;
    const taut_film_problem *problem = c->problem;

    for (int p = 0; p < problem->patch_count; p++) {
        if (e->in_cells[p]) {
            taut_volume_places(e->areas[p], e->net + 3 * c->first[p], e->rows, e->places[p]);
        }
    }
    for (int k = 0; k < problem->cell_count; k++) {
        double *swell = e->swells + 3 * (size_t)k * (size_t)c->nodes;
        const double *from = e->layout->from + 3 * k;
        e->volumes[k] = 0;
        memset(swell, 0, 3 * (size_t)c->nodes * sizeof(double));
        for (int p = 0; p < problem->patch_count; p++) {
            const int turn = taut_film_cell_turn(&problem->cells[k], p), first = c->first[p];
            if (turn == 0) {
                continue;
            }
            memset(e->bulge, 0, 3 * (size_t)(c->first[p + 1] - first) * sizeof(double));
            e->volumes[k] += turn * taut_volume_patch(e->areas[p], e->places[p], from, turn,
                                                      with_gradient ? e->bulge : NULL);
            for (int i = first; with_gradient && i < c->first[p + 1]; i++) {
                taut_add_scaled(1, e->bulge + 3 * (i - first), swell + 3 * c->node[i]);
            }
        }
        if (!problem->cells[k].has_volume) {
            taut_sum_add(sum, -e->pressures[k] * e->volumes[k]);
        }
    }
}

/* Forces by lengths, and what they store. */
static void find_forces(taut_film_energy *e, taut_sum *sum)
{
    const taut_film_complex *c = &e->layout->complex;

    for (int k = 0; k < c->strand_count; k++) {
        if (e->stretches[c->strands[k].rope] != NULL) {
            e->lengths[c->strands[k].rope] += taut_area_cable_length(&e->cables[k], e->net);
        }
    }
    for (int r = 0; r < c->rope_count; r++) {
        const taut_film_drawn *drawn = &e->layout->drawn[r];
        if (drawn->law == TAUT_FILM_FORCE) {
            e->forces[r] = drawn->ratio;
        } else if (taut_film_law_stiffness(drawn, e->soft) > 0) {
            e->forces[r] = taut_film_law_force(drawn, e->soft, e->lengths[r]);
            taut_sum_add(sum, taut_film_law_energy(drawn, e->soft, e->lengths[r]));
        }
    }
}

/* dL of a strand, to its nodes. */
static void add_stretch(taut_film_energy *e, int k)
{
    const taut_film_complex *c = &e->layout->complex;
    taut_area_cable *cable = &e->cables[k];
    double *stretch = e->stretches[c->strands[k].rope];

    taut_area_cable_pull(cable);
    for (int i = 0; i < cable->count; i++) {
        taut_add_scaled(1, cable->pull + 3 * i,
                        stretch + 3 * c->node[cable->first + (size_t)i * cable->step]);
    }
}

/* Lengths, forces and stretches; what they store is added to the sum, and to the slopes what it changes by. */
static void add_cables(taut_film_energy *e, int with_gradient, taut_sum *sum)
{
    const taut_film_complex *c = &e->layout->complex;

    memset(e->lengths, 0, (size_t)c->rope_count * sizeof(double));
    for (int r = 0; with_gradient && r < c->rope_count; r++) {
        if (e->stretches[r] != NULL) {
            memset(e->stretches[r], 0, 3 * (size_t)c->nodes * sizeof(double));
        }
    }
    find_forces(e, sum);
    for (int k = 0; k < c->strand_count; k++) {
        const int r = c->strands[k].rope;
        const taut_film_drawn *drawn = &e->layout->drawn[r];
        taut_area_cable *cable = &e->cables[k];
        const int is_given = drawn->law == TAUT_FILM_FORCE;
        const int stores = is_given || taut_film_law_stiffness(drawn, e->soft) > 0;
        cable->tension = stores ? e->forces[r] : 0;
        const double length = with_gradient ? taut_area_cable_gradient(cable, e->net, e->slopes)
                              : is_given    ? taut_area_cable_length(cable, e->net)
                                            : 0;
        if (is_given) {
            e->lengths[r] += length;
            taut_sum_add(sum, taut_area_cable_energy(cable, length));
        } else if (with_gradient) {
            add_stretch(e, k);
        }
        cable->tension = e->forces[r];
    }
}

/* By what each sheet does on its own. */
static void find_scales(const taut_film_energy *energy, double *scales)
{
    const taut_film_complex *c = &energy->layout->complex;

    memset(scales, 0, (size_t)c->nodes * sizeof *scales);
    for (int p = 0; p < c->problem->patch_count; p++) {
        double largest = 0;
        for (int k = 3 * c->first[p]; k < 3 * c->first[p + 1]; k++) {
            largest = fmax(largest, fabs(energy->slopes[k]));
        }
        for (int k = c->first[p]; k < c->first[p + 1]; k++) {
            scales[c->node[k]] = fmax(largest, scales[c->node[k]]);
        }
    }
}

double taut_film_energy_value(taut_film_energy *energy, const double *x, double *gradient,
                              double *scales)
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
    if (scales != NULL) {
        find_scales(energy, scales);
    }
    add_cables(energy, gradient != NULL, &sum);
    add_cells(energy, gradient != NULL, &sum);
    if (gradient != NULL) {
        memset(gradient, 0, 3 * (size_t)c->nodes * sizeof(double));
        for (int k = 0; k < c->points; k++) {
            taut_add_scaled(1, energy->slopes + 3 * k, gradient + 3 * c->node[k]);
        }
        for (int k = 0; k < c->problem->cell_count; k++) {
            const double *swell = energy->swells + 3 * (size_t)k * (size_t)c->nodes;
            for (int i = 0; !c->problem->cells[k].has_volume && i < 3 * c->nodes; i++) {
                gradient[i] -= energy->pressures[k] * swell[i];
            }
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

/* Functions and slopes of a cell at a node. */
typedef struct functions {
    double value[LOCAL_MAX * LOCAL_MAX], u[LOCAL_MAX * LOCAL_MAX], v[LOCAL_MAX * LOCAL_MAX];
} functions;

static void find_functions(const taut_area_functional *area, int line, int k, functions *of)
{
    const taut_area_axis *u = &area->u, *v = &area->v;

    for (int i = 0, at = 0; i < u->local; i++) {
        for (int j = 0; j < v->local; j++, at++) {
            const int a = line * u->local + i, b = k * v->local + j;
            of->value[at] = u->value[a] * v->value[b];
            of->u[at] = u->slope[a] * v->value[b];
            of->v[at] = u->value[a] * v->slope[b];
        }
    }
}

/* row += the t of pairs (a, b), volume.h, for b up to a: along x_v, along x_u and along y. */
static void add_turns(int a, const functions *of, double along[3][3], double *restrict row0,
                      double *restrict row1, double *restrict row2)
{
    const double value = of->value[a], u = of->u[a], v = of->v[a];

    for (int b = 0; b <= a; b++) {
        const double x = value * of->u[b] - u * of->value[b];
        const double y = v * of->value[b] - value * of->v[b];
        const double z = u * of->v[b] - v * of->u[b];
        row0[b] += x * along[0][0] + y * along[1][0] + z * along[2][0];
        row1[b] += x * along[0][1] + y * along[1][1] + z * along[2][1];
        row2[b] += x * along[0][2] + y * along[1][2] + z * along[2][2];
    }
}

/* What - p V adds to the element of a side of cells, in the place of t n. */
static void add_pressure(const void *context, int p, int line, int k, double *element)
{
    const taut_film_energy *e = context;
    const taut_area_functional *area = e->areas[p];
    const size_t wide = (size_t)taut_area_wide(area);
    const double weight = area->u.weights[line] * area->v.weights[k] / 3;
    const double *place =
        e->places[p] + ((size_t)line * (size_t)area->v.count + (size_t)k) * TAUT_VOLUME_PLACE;
    double along[3][3];
    functions of;

    if (!e->in_cells[p]) {
        return;
    }
    for (int c = 0; c < 3; c++) {
        along[0][c] = weight * e->pull[p] * place[6 + c];
        along[1][c] = weight * e->pull[p] * place[3 + c];
        along[2][c] = weight * (e->pull[p] * place[c] - e->lever[3 * p + c]);
    }
    find_functions(area, line, k, &of);
    for (int a = 0; a < area->u.local * area->v.local; a++, element += TAUT_AREA_BLOCK * wide) {
        add_turns(a, &of, along, element + 6 * wide, element + 7 * wide, element + 8 * wide);
    }
}

/* H d = s n (n . d) + t n x d, with the t of an element: n n^T row by row to the diagonal, t n, s. */
static void scatter(taut_film_energy *e, int p, const int *nodes, int count, const double *element)
{
    const size_t wide = (size_t)taut_area_wide(e->areas[p]);
    const double share = e->shares[p];

    for (int a = 0; a < count; a++, element += TAUT_AREA_BLOCK * wide) {
        for (int b = 0; b <= a; b++) {
            double m[TAUT_AREA_BLOCK];
            for (size_t c = 0; c < TAUT_AREA_BLOCK; c++) {
                m[c] = share * element[c * wide + (size_t)b];
            }
            const double *t = m + 6;
            const double h[9] = {m[0],        m[1] - t[2], m[3] + t[1], m[1] + t[2], m[2],
                                 m[4] - t[0], m[3] - t[1], m[4] + t[0], m[5]};
            add_block(e, nodes[a], nodes[b], a == b, h, m[9]);
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

static void find_pulls(taut_film_energy *e)
{
    const taut_film_problem *problem = e->layout->complex.problem;

    for (int p = 0; p < problem->patch_count; p++) {
        e->pull[p] = 0;
        memset(e->lever + 3 * p, 0, 3 * sizeof(double));
        for (int k = 0; k < problem->cell_count; k++) {
            const double pressure =
                taut_film_cell_turn(&problem->cells[k], p) * e->pressures[k] / e->shares[p];
            e->pull[p] += pressure;
            taut_add_scaled(pressure, e->layout->from + 3 * k, e->lever + 3 * p);
        }
    }
}

taut_status taut_film_energy_second(taut_film_energy *energy)
{
    enum { OF_PAIR = 30, OF_PRESSURE = 60 }; /* operations of two functions at a node, roughly */
    const taut_film_complex *c = &energy->layout->complex;
    int nodes[LOCAL_MAX * LOCAL_MAX];
    const size_t blocks = (size_t)energy->start[c->nodes];

    memset(energy->second, 0, blocks * 9 * sizeof(double));
    memset(energy->metric, 0, blocks * sizeof(double));
    find_pulls(energy);
    taut_area_elements_begin(energy->elements, energy->seen, add_pressure, energy);
    for (int p = 0; p < c->problem->patch_count; p++) {
        const taut_area_functional *area = energy->areas[p];
        const int cu = cells_of(&area->u), cv = cells_of(&area->v);
        const double of_pair = OF_PAIR + (energy->in_cells[p] ? OF_PRESSURE : 0);
        for (int cell = 0; cell < cu * cv; cell++) {
            const int count = alive(energy, p, cell / cv, cell % cv, nodes);
            scatter(energy, p, nodes, count, taut_area_elements_next(energy->elements));
            if (taut_pulse_beat(energy->pulse,
                                of_pair * count * count / 2 * (area->u.nodes * area->v.nodes))) {
                return TAUT_INTERRUPTED;
            }
        }
    }
    for (int k = 0; k < c->strand_count; k++) {
        add_cable(energy, k);
    }
    return TAUT_OK;
}

static void block_of(const void *context, int a, int b, double *block)
{
    const taut_film_energy *e = context;
    const int upper = b > a;
    const size_t at = find_block(e, upper ? b : a, upper ? a : b);
    const double *h = e->second + 9 * at;
    const int blends = e->theta > blend_least || e->theta < 0;
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
    return taut_sparse_factor(energy->sparse, block_of, energy, energy->pulse, negative);
}

void taut_film_energy_solve(const taut_film_energy *energy, const double *c, double *right,
                            double *d)
{
    const int nodes = energy->layout->complex.nodes;

    for (int a = 0; a < nodes; a++) {
        for (int k = 0; k < energy->size[a]; k++) {
            right[taut_sparse_row(energy->sparse, a) + k] =
                taut_dot(c + 3 * a, energy->free + 9 * a + 3 * k);
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
