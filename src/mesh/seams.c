/* seams.c -- edges are compared at SAMPLES parameters. Two that are the same curve have the same
 * point in the middle, whichever way they run: so only neighbours along a line, in the order of
 * their middles' shadows on it, are looked at. */
#include "mesh/seams.h"

#include "core/vec3.h"

#include <stdlib.h>

enum { SAMPLES = 17, LOOKED_AT_MOST = 64 };

/* A direction that no model is built along. */
static const double line[3] = {0.5377, 0.6121, 0.5798};

typedef struct edge_key {
    double shadow;
    int edge;
} edge_key;

static int by_shadow(const void *a, const void *b)
{
    const edge_key *x = a, *y = b;
    if (x->shadow != y->shadow) {
        return x->shadow < y->shadow ? -1 : 1;
    }
    return x->edge < y->edge ? -1 : x->edge > y->edge;
}

static void fill_parameters(const taut_basis *basis, double *t)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    for (int k = 0; k < SAMPLES; k++) {
        t[k] = k + 1 < SAMPLES ? lo + (hi - lo) * k / (SAMPLES - 1) : hi;
    }
}

/* points double[4][SAMPLES][3] of the edges of one surface. */
static taut_status sample_edges(const taut_surface *surface, double *points)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    double tu[SAMPLES], tv[SAMPLES];
    taut_status status = TAUT_OK;
    fill_parameters(u, tu);
    fill_parameters(v, tv);
    for (int e = 0; e < 4 && status == TAUT_OK; e++) {
        double *row = points + (size_t)e * SAMPLES * 3;
        const int last = e % 2 == 1 ? SAMPLES - 1 : 0;
        status = taut_edge_along(e) == 1
                     ? taut_surface_eval_grid(surface, 1, tu + last, SAMPLES, tv, 0, 1, row)
                     : taut_surface_eval_grid(surface, SAMPLES, tu, 1, tv + last, 0, 1, row);
    }
    return status;
}

static int is_point(const double *edge, double tolerance)
{
    int k = 1;
    while (k < SAMPLES && taut_length_between(edge, edge + 3 * (size_t)k) <= tolerance) {
        k++;
    }
    return k == SAMPLES;
}

static int are_same(const double *a, const double *b, int reversed, double tolerance)
{
    int k = 0;
    while (k < SAMPLES &&
           taut_length_between(a + 3 * (size_t)k,
                               b + 3 * (size_t)(reversed ? SAMPLES - 1 - k : k)) <= tolerance) {
        k++;
    }
    return k == SAMPLES;
}

/* The first edge before place i, in the order of the keys, that is the same curve. */
static int find_partner(const edge_key *keys, int i, const double *points, double tolerance,
                        taut_seam *seam)
{
    const double *a = points + (size_t)keys[i].edge * SAMPLES * 3;
    for (int j = i - 1;
         j >= 0 && i - j <= LOOKED_AT_MOST && keys[i].shadow - keys[j].shadow <= tolerance; j--) {
        const double *b = points + (size_t)keys[j].edge * SAMPLES * 3;
        /* the nearer way first: what is short may be the same both ways */
        const int back =
            taut_length_between(a + 3, b + 3) > taut_length_between(a + 3, b + 3 * (SAMPLES - 2));
        for (int k = 0; k < 2; k++) {
            if (are_same(a, b, back ^ k, tolerance)) {
                *seam = (taut_seam){keys[i].edge, keys[j].edge, back ^ k};
                return 1;
            }
        }
    }
    return 0;
}

taut_status taut_seams_find(const taut_surface *const *surfaces, int count, double tolerance,
                            double point, taut_arena *arena, taut_seam **seams, int *seam_count,
                            unsigned char **collapsed)
{
    const size_t edges = 4 * (size_t)count;
    double *points = taut_arena_take(arena, edges, SAMPLES * 3 * sizeof(double));
    edge_key *keys = taut_arena_take(arena, edges, sizeof *keys);
    int listed = 0;

    *seams = taut_arena_take(arena, edges, sizeof **seams);
    *collapsed = taut_arena_take(arena, edges, 1);
    *seam_count = 0;
    if (*collapsed == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < count; i++) {
        const taut_status status = sample_edges(surfaces[i], points + (size_t)i * 4 * SAMPLES * 3);
        if (status != TAUT_OK) {
            return status;
        }
    }
    for (int e = 0; e < 4 * count; e++) {
        const double *edge = points + (size_t)e * SAMPLES * 3;
        const double *middle = edge + SAMPLES / 2 * 3;
        (*collapsed)[e] = (unsigned char)is_point(edge, point);
        if (!(*collapsed)[e]) {
            keys[listed].edge = e;
            keys[listed++].shadow = taut_dot(line, middle);
        }
    }
    qsort(keys, (size_t)listed, sizeof *keys, by_shadow);
    for (int i = 1; i < listed; i++) {
        *seam_count += find_partner(keys, i, points, tolerance, *seams + *seam_count);
    }
    return TAUT_OK;
}

int taut_mirror_sets_new(int count, taut_arena *arena, taut_mirror_sets *sets)
{
    sets->up = taut_arena_take(arena, (size_t)count, sizeof *sets->up);
    sets->flip = taut_arena_take(arena, (size_t)count, 1);
    sets->both = taut_arena_take(arena, (size_t)count, 1);
    if (sets->both == NULL) {
        return 0;
    }
    for (int i = 0; i < count; i++) {
        sets->up[i] = i;
    }
    return 1;
}

int taut_mirror_root(taut_mirror_sets *sets, int i, int *flip)
{
    *flip = 0;
    while (sets->up[i] != i) {
        const int parent = sets->up[i]; /* halve the way for the next one */
        sets->flip[i] = (unsigned char)(sets->flip[i] ^ sets->flip[parent]);
        sets->up[i] = sets->up[parent];
        *flip ^= sets->flip[i];
        i = sets->up[i];
    }
    return i;
}

void taut_mirror_unite(taut_mirror_sets *sets, int i, int j, int flip)
{
    int flip_i = 0, flip_j = 0;
    const int root_i = taut_mirror_root(sets, i, &flip_i);
    const int root_j = taut_mirror_root(sets, j, &flip_j);
    const int low = root_i < root_j ? root_i : root_j, high = root_i < root_j ? root_j : root_i;
    const int turned = flip_i ^ flip_j ^ (flip != 0);
    if (low == high) {
        sets->both[low] = (unsigned char)(sets->both[low] | turned);
        return;
    }
    sets->up[high] = low;
    sets->flip[high] = (unsigned char)turned;
    sets->both[low] = (unsigned char)(sets->both[low] | sets->both[high]);
}
