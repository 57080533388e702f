#include "construct/film/fold.h"

#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { STEPS = 4 /* of a span */ };
static const double no_normal =
    0.05; /* of the mean: hardly any area there, as in a very sharp corner */

/* The functions alive at places of one direction, values and slopes. */
typedef struct lines {
    int count, local;
    double *at;     /* [count] */
    int *first;     /* [count] */
    double *values; /* [count][2][local] */
} lines;

/* around: of functions that go around, or NULL. */
static taut_status lay_lines(const taut_basis *basis, const taut_loop *around, taut_arena *arena,
                             lines *l)
{
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    const size_t local = (size_t)taut_basis_local(basis);

    l->count = spans * STEPS + 1;
    l->local = (int)local;
    l->at = taut_arena_take(arena, (size_t)l->count, sizeof(double));
    l->first = taut_arena_take(arena, (size_t)l->count, sizeof(int));
    l->values = taut_arena_take(arena, (size_t)l->count, 2 * local * sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < l->count; k++) {
        const int span = k / STEPS < spans ? k / STEPS : spans - 1;
        const double share = (double)(k - span * STEPS) / STEPS;
        double *values = l->values + (size_t)k * 2 * local;
        l->at[k] = (1 - share) * breaks[span] + share * breaks[span + 1];
        l->first[k] = taut_basis_first(basis, span);
        (void)taut_basis_eval(basis, span, l->at[k], 1, values);
        if (around != NULL) {
            taut_loop_open(around, l->first[k], values);
            taut_loop_open(around, l->first[k], values + local);
        }
    }
    return TAUT_OK;
}

/* x, and x_u x x_v. */
static void find_normal(const taut_film_space *space, const double *net, const lines *u, int i,
                        const lines *v, int j, double x[3], double normal[3])
{
    const double *n = u->values + (size_t)i * 2 * (size_t)u->local, *d = n + u->local;
    const double *m = v->values + (size_t)j * 2 * (size_t)v->local, *e = m + v->local;
    double xu[3] = {0, 0, 0}, xv[3] = {0, 0, 0};

    memset(x, 0, 3 * sizeof(double));
    for (int a = 0; a < u->local; a++) {
        const size_t row = (size_t)(u->first[i] + a) * (size_t)space->nv;
        const double *p = net + 3 * (row + (size_t)v->first[j]);
        for (int b = 0; b < v->local; b++) {
            taut_add_scaled(n[a] * m[b], p + 3 * b, x);
            taut_add_scaled(d[a] * m[b], p + 3 * b, xu);
            taut_add_scaled(n[a] * e[b], p + 3 * b, xv);
        }
    }
    taut_cross(xu, xv, normal);
}

/* Do they look apart? Not where one of them is none. */
static int are_apart(const double *n, const double *o, double small)
{
    return taut_length(n) > small && taut_length(o) > small && !(taut_dot(n, o) > 0);
}

/* points, normals double[u.count][v.count][3]. */
static void search(const lines *u, const lines *v, const double *normals, taut_film_fold *fold,
                   int place[2])
{
    const int count = u->count * v->count;
    double mean = 0, least = INFINITY;

    for (int k = 0; k < count; k++) {
        mean += taut_length(normals + 3 * k) / count;
    }
    for (int k = 0; k < count && !fold->is_folded; k++) {
        const double *n = normals + 3 * k;
        const int i = k / v->count, j = k % v->count;
        const double size = taut_length(n);
        fold->is_folded =
            (i > 0 && are_apart(n, n - (size_t)3 * (size_t)v->count, no_normal * mean)) ||
            (j > 0 && are_apart(n, n - 3, no_normal * mean));
        if (fold->is_folded || size < least) {
            least = size;
            place[0] = i;
            place[1] = j;
        }
    }
}

static taut_status find(const taut_film_space *space, const double *net, taut_arena *arena,
                        taut_film_fold *fold)
{
    const taut_film_problem *problem = space->problem;
    const taut_loop *around = space->around;
    lines u, v;
    int place[2] = {0, 0};
    const unsigned char known = 0;
    double x[3], normal[3];

    if (lay_lines(problem->u, problem->ring == TAUT_FILM_RING_U ? around : NULL, arena, &u) !=
            TAUT_OK ||
        lay_lines(problem->v, problem->ring == TAUT_FILM_RING_V ? around : NULL, arena, &v) !=
            TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    double *normals = taut_arena_take(arena, (size_t)u.count * (size_t)v.count, sizeof normal);
    if (normals == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < u.count; i++) {
        for (int j = 0; j < v.count; j++) {
            find_normal(space, net, &u, i, &v, j, x,
                        normals + 3 * ((size_t)i * (size_t)v.count + (size_t)j));
        }
    }
    search(&u, &v, normals, fold, place);
    fold->at[0] = u.at[place[0]];
    fold->at[1] = v.at[place[1]];
    find_normal(space, net, &u, place[0], &v, place[1], x, normal);
    /* beyond the range of doubles: as infinity, which is where it is */
    (void)taut_scaling_undo(&space->scaling, 1, x, &known, x, fold->point, NULL);
    return TAUT_OK;
}

taut_status taut_film_fold_find(const taut_film_space *space, const double *net,
                                taut_film_fold *fold)
{
    taut_arena *arena = taut_arena_new();

    memset(fold, 0, sizeof *fold);
    const taut_status status = find(space, net, arena, fold);
    taut_arena_free(arena);
    return status;
}
