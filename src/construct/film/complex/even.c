#include "construct/film/complex/even.h"

#include "construct/film/complex/places.h"
#include "construct/film/edges.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { STEPS = 8 /* of a span */, SWEEPS = 20000 };
static const double flat = 1e-12;     /* of the size: roundings of a point */
static const double flat_each = 1e-9; /* of one patch among others, which is at rest to no more */
static const double moved = 1e-12;    /* of the size, in a sweep: the last */

/* The patches that are in a plane. */
typedef struct all_planes {
    unsigned char *is_flat; /* [patch_count] */
    double *normals;        /* [patch_count][3] */
    taut_film_hold
        *holds; /* [nodes]: directions that a node is not to leave; NULL: all are in one plane */
} all_planes;

static taut_status lay_places(const taut_basis *basis, taut_arena *arena, taut_film_places *l)
{
    const int spans = taut_basis_span_count(basis);
    const taut_status status = taut_film_places_take(basis, spans * STEPS + 1, arena, l);

    for (int k = 0; status == TAUT_OK && k < l->count; k++) {
        const int span = k / STEPS < spans ? k / STEPS : spans - 1;
        taut_film_places_put(basis, span, (double)(k - span * STEPS) / STEPS, k, l);
    }
    return status;
}

/* Does a patch turn over at one of its places? *folds. */
static taut_status look_at_patch(const taut_film_complex *c, int p, const double *x,
                                 const double normal[3], int *folds)
{
    const taut_film_problem *patch = &c->problem->patches[p];
    const int nv = taut_basis_count(patch->v);
    taut_arena *arena = taut_arena_new();
    double least = INFINITY, most = -INFINITY;
    taut_film_places u, v;
    taut_status status = lay_places(patch->u, arena, &u);

    if (status == TAUT_OK) {
        status = lay_places(patch->v, arena, &v);
    }
    for (int i = 0; status == TAUT_OK && i < u.count; i++) {
        for (int j = 0; j < v.count; j++) {
            double own[3];
            taut_film_normal(x, c->node + c->first[p], nv, &u, i, &v, j, own);
            const double element = taut_dot(own, normal);
            least = fmin(least, element);
            most = fmax(most, element);
        }
    }
    taut_arena_free(arena);
    *folds |= !(least > 0 || most < 0);
    return status;
}

static taut_status look(const taut_film_complex *c, const double *x, const all_planes *planes,
                        int *folds)
{
    taut_status status = TAUT_OK;
    *folds = 0;
    for (int p = 0; status == TAUT_OK && !*folds && p < c->problem->patch_count; p++) {
        if (planes->is_flat[p]) {
            status = look_at_patch(c, p, x, planes->normals + 3 * p, folds);
        }
    }
    return status;
}

/* The normal of the plane that so many nodes are in; node NULL: the first of them. 0: they are in none. */
static int find_plane(const double *x, const int *node, int count, double share, double normal[3],
                      double *size)
{
    const double *first = x + 3 * (node != NULL ? node[0] : 0), *far = first;
    double most = 0;

    *size = 0;
    for (int k = 0; k < count; k++) {
        const double *at = x + 3 * (node != NULL ? node[k] : k);
        const double away = taut_distance(first, at);
        far = away > *size ? at : far;
        *size = fmax(*size, away);
    }
    for (int k = 0; k < count; k++) {
        double one[3], other[3], across[3];
        taut_difference(far, first, one);
        taut_difference(x + 3 * (node != NULL ? node[k] : k), first, other);
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
    for (int k = 0; k < count; k++) {
        double from[3];
        taut_difference(x + 3 * (node != NULL ? node[k] : k), first, from);
        if (!(fabs(taut_dot(from, normal)) <= share * *size)) {
            return 0;
        }
    }
    return 1;
}

/* Whatever is in several planes stays in all of them; nothing moves that is in a sheet that is not flat, or of a cable. */
static void hold_all(const taut_film_complex *c, all_planes *planes)
{
    static const double axes[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    memcpy(planes->holds, c->holds, (size_t)c->nodes * sizeof *planes->holds);
    for (int p = 0; p < c->problem->patch_count; p++) {
        for (int k = c->first[p]; k < c->first[p + 1]; k++) {
            const double *normals = planes->is_flat[p] ? planes->normals + 3 * p : axes;
            for (int n = 0; n < (planes->is_flat[p] ? 1 : 3); n++) {
                (void)taut_film_hold_add(&planes->holds[c->node[k]], normals + 3 * n, 0, INFINITY);
            }
        }
    }
    for (int k = 0; k < c->strand_count; k++) {
        const taut_film_side *side = &c->strands[k].side;
        const int count = taut_film_complex_along(&c->problem->patches[side->patch], side->edge);
        for (int i = 0; i < count; i++) {
            planes->holds[taut_film_complex_node(c, side, i)].count = 3;
        }
    }
}

/* One plane of all, or that of each patch. 0: no patch has one. */
static int find_planes(const taut_film_complex *c, const double *x, all_planes *planes,
                       double *size)
{
    const int is_plain = c->rope_count == 0 && c->problem->cell_count == 0;
    double normal[3] = {0, 0, 0};
    int count = 0;

    if (is_plain && find_plane(x, NULL, c->nodes, flat, normal, size)) {
        for (int p = 0; p < c->problem->patch_count; p++) {
            planes->is_flat[p] = 1;
            memcpy(planes->normals + 3 * p, normal, sizeof normal);
        }
        planes->holds = NULL;
        return 1;
    }
    for (int p = 0; p < c->problem->patch_count; p++) {
        double own = 0;
        planes->is_flat[p] = !taut_film_has_density(&c->problem->patches[p]) &&
                             find_plane(x, c->node + c->first[p], c->first[p + 1] - c->first[p],
                                        flat_each, planes->normals + 3 * p, &own);
        count += planes->is_flat[p];
    }
    hold_all(c, planes);
    return count > 0;
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
static void even_out(const taut_film_layout *layout, const all_planes *planes, double size,
                     double *x, double *sums)
{
    const taut_film_complex *c = &layout->complex;
    double way = INFINITY;

    for (int sweep = 0; sweep < SWEEPS && way > moved * size; sweep++) {
        way = 0;
        add_all(c, x, sums);
        for (int a = 0; a < c->nodes; a++) {
            const double *sum = sums + 4 * a;
            const taut_film_hold *hold = planes->holds != NULL ? &planes->holds[a] : NULL;
            if (layout->known[a] || !(sum[3] > 0) ||
                (hold != NULL ? hold->count == 3 : c->holds[a].count > 0)) {
                continue;
            }
            double to[3] = {sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]};
            for (int k = 0; hold != NULL && k < hold->count; k++) {
                double by[3];
                taut_difference(x + 3 * a, to, by);
                taut_add_scaled(taut_dot(by, hold->normals[k]), hold->normals[k], to);
            }
            for (int k = 0; k < 3; k++) {
                way = fmax(way, fabs(to[k] - x[3 * a + k]));
                x[3 * a + k] = to[k];
            }
        }
    }
}

taut_status taut_film_even(const taut_film_layout *layout, double *x, int *made)
{
    const taut_film_complex *c = &layout->complex;
    const size_t nodes = (size_t)c->nodes, patches = (size_t)c->problem->patch_count;
    double size = 1; /* scaled */
    int folds = 0;
    taut_arena *arena = taut_arena_new();
    all_planes planes = {.is_flat = taut_arena_take(arena, patches, 1),
                         .normals = taut_arena_take(arena, patches, 3 * sizeof(double)),
                         .holds = taut_arena_take(arena, nodes, sizeof(taut_film_hold))};
    taut_status status = taut_arena_status(arena);

    *made = 0;
    if (status == TAUT_OK && find_planes(c, x, &planes, &size)) {
        status = look(c, x, &planes, &folds);
    }
    if (status == TAUT_OK && folds) {
        double *even = taut_arena_copy(arena, x, nodes, 3 * sizeof *even);
        double *sums = taut_arena_take(arena, nodes, 4 * sizeof *sums);
        status = taut_arena_status(arena);
        if (status == TAUT_OK) {
            even_out(layout, &planes, size, even, sums);
            status = look(c, even, &planes, &folds);
        }
        if (status == TAUT_OK && !folds) {
            memcpy(x, even, 3 * nodes * sizeof *x);
            *made = 1;
        }
    }
    taut_arena_free(arena);
    return status;
}
