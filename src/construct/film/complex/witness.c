/* witness.c -- the function that shows how near a film of many patches is to the least area of all.
 *
 *     e     = a direction in which all patches together are a graph (construct/plateau/direction.h)
 *     psi   = its coefficients on all patches, of which those along seams are one: `shared`
 *     K, r  = sums of those of each patch (construct/plateau/dual.h), factored by fronts (numeric/sparse.h)
 *     psi   = the one of least gap (construct/plateau/climb.h), rounded to as many decimals as count
 *
 * A constant is free: the first of the shared coefficients is kept at 0.
 */
#include "construct/film/complex/witness.h"

#include "construct/common/scaling.h"
#include "construct/plateau/climb.h"
#include "construct/plateau/direction.h"
#include "construct/plateau/witness.h"
#include "numeric/sparse.h"
#include "problem/film_rim.h"
#include "taut/plateau.h"

#include <math.h>
#include <string.h>

enum { POINTS_LARGE = 40 * 40 /* from here on psi is one degree above the film, not two */ };

/* One patch. */
typedef struct sheet {
    taut_surface *scaled;
    taut_basis *u, *v; /* of psi */
    taut_dual dual;
    int first; /* of its coefficients among all */
} sheet;

typedef struct work {
    const taut_film_complex *complex;
    taut_film_rim rim;
    taut_arena *arena;
    taut_pulse pulse;
    sheet *sheets; /* [patch_count], of which so many are made */
    int count, made;
    double e[3];
    int all;          /* coefficients of all patches */
    int *shared;      /* [all]: the number of each among those that are one */
    int *owner;       /* [all]: its patch */
    int unknowns;     /* of these */
    int *start, *own; /* of unknown a: own[start[a]] to own[start[a + 1] - 1], of all */
    taut_sparse *sparse;
    double *patch; /* [all] */
    double *psi, *step, *next;
    taut_dual_value value;
    double area, flops;
} work;

/* ---- the sheets ---- */

static taut_status scale_sheets(const taut_film_layout *layout, const taut_film_rest *rest, work *w)
{
    const taut_film_complex *c = w->complex;
    double *nodes = taut_arena_take(w->arena, (size_t)c->nodes, 3 * sizeof(double));
    double *net = taut_arena_take(w->arena, (size_t)c->points, 3 * sizeof(double));
    taut_status status = taut_arena_status(w->arena);

    if (status != TAUT_OK) {
        return status;
    }
    taut_scaling_apply(&layout->scaling, (size_t)c->nodes, rest->points, NULL, nodes);
    for (int k = 0; k < c->points; k++) {
        memcpy(net + 3 * k, nodes + 3 * c->node[k], 3 * sizeof(double));
    }
    for (int p = 0; status == TAUT_OK && p < w->count; p++) {
        const taut_film_problem *patch = &c->problem->patches[p];
        status = taut_surface_new("", patch->u, patch->v, net + 3 * c->first[p], NULL,
                                  &w->sheets[p].scaled, NULL);
    }
    return status;
}

static taut_status find_direction(work *w)
{
    taut_direction_sheet *sheets = taut_arena_take(w->arena, (size_t)w->count, sizeof *sheets);
    taut_direction_side *sides = taut_arena_take(w->arena, (size_t)w->rim.count, sizeof *sides);
    const taut_direction_film film = {w->count, sheets, w->rim.count, sides};

    if (taut_arena_status(w->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int p = 0; p < w->count; p++) {
        sheets[p] = (taut_direction_sheet){w->sheets[p].scaled, w->rim.sign[p]};
    }
    for (int k = 0; k < w->rim.count; k++) {
        const taut_film_side *side = &w->rim.sides[k];
        sides[k] = (taut_direction_side){side->patch, side->edge, side->reversed};
    }
    return taut_plateau_direction_of(&film, w->e);
}

static taut_status make_duals(work *w)
{
    const int more = w->complex->points < POINTS_LARGE ? 2 : 1;
    double frame[3][3];
    taut_status status = TAUT_OK;

    taut_plateau_frame(w->e, frame);
    for (int p = 0; status == TAUT_OK && p < w->count; p++) {
        sheet *s = &w->sheets[p];
        status = taut_plateau_raise(taut_surface_u(s->scaled), more, &s->u);
        if (status == TAUT_OK) {
            status = taut_plateau_raise(taut_surface_v(s->scaled), more, &s->v);
        }
        if (status == TAUT_OK) {
            s->dual.pulse = &w->pulse;
            status = taut_dual_new(s->scaled, s->u, s->v, frame, w->arena, &s->dual);
        }
        if (status == TAUT_OK) {
            w->made++;
            s->first = w->all;
            w->all += s->dual.u.count * s->dual.v.count;
            w->area += s->dual.area;
            w->flops += taut_dual_cost(&s->dual);
        }
    }
    return status;
}

/* ---- which coefficients are one ---- */

/* Coefficient k of a side, as it is run, among all. */
static int place_of(const work *w, const taut_film_side *side, int k)
{
    const sheet *s = &w->sheets[side->patch];
    const int nu = s->dual.u.count, nv = s->dual.v.count, e = side->edge;
    const int at = side->reversed ? (e < 2 ? nv : nu) - 1 - k : k;
    const int i = e < 2 ? e * (nu - 1) : at, j = e < 2 ? at : (e - 2) * (nv - 1);
    return s->first + i * nv + j;
}

static int root_of(const int *parent, int k)
{
    while (parent[k] != k) {
        k = parent[k];
    }
    return k;
}

/* shared, owner, start, own. TAUT_NO_SOLUTION: a patch is joined with itself. */
static taut_status share(work *w)
{
    const taut_film_problem *problem = w->complex->problem;

    w->shared = taut_arena_take(w->arena, (size_t)w->all, sizeof(int));
    w->owner = taut_arena_take(w->arena, (size_t)w->all, sizeof(int));
    w->own = taut_arena_take(w->arena, (size_t)w->all, sizeof(int));
    w->start = taut_arena_take(w->arena, (size_t)w->all + 2, sizeof(int));
    if (taut_arena_status(w->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int p = 0, k = 0; k < w->all; k++) {
        p += p + 1 < w->count && k == w->sheets[p + 1].first;
        w->owner[k] = p;
        w->shared[k] = k; /* the one it hangs from */
    }
    for (int s = 0; s < problem->seam_count; s++) {
        const taut_film_side *one = &problem->seams[s].sides[0], *other = one + 1;
        const taut_dual *dual = &w->sheets[one->patch].dual;
        if (one->patch == other->patch) {
            return TAUT_NO_SOLUTION;
        }
        for (int k = 0; k < (one->edge < 2 ? dual->v.count : dual->u.count); k++) {
            const int a = root_of(w->shared, place_of(w, one, k));
            const int b = root_of(w->shared, place_of(w, other, k));
            w->shared[a > b ? a : b] = a > b ? b : a;
        }
    }
    for (int k = 0; k < w->all;
         k++) { /* each hangs from one before it, which has its number already */
        w->shared[k] = w->shared[k] == k ? w->unknowns++ : w->shared[w->shared[k]];
        w->start[w->shared[k] + 2]++;
    }
    for (int a = 0; a < w->unknowns; a++) {
        w->start[a + 2] += w->start[a + 1];
    }
    for (int k = 0; k < w->all; k++) {
        w->own[w->start[w->shared[k] + 1]++] = k;
    }
    return TAUT_OK;
}

/* Functions alive on one span meet. */
static taut_status make_sparse(work *w)
{
    size_t spans = 0, members = 0, n = 0;

    for (int p = 0; p < w->count; p++) {
        const taut_dual_axis *u = &w->sheets[p].dual.u, *v = &w->sheets[p].dual.v;
        spans += (size_t)u->spans * (size_t)v->spans;
        members += (size_t)u->spans * (size_t)v->spans * (size_t)u->local * (size_t)v->local;
    }
    unsigned char *sizes = taut_arena_take(w->arena, (size_t)w->unknowns, 1);
    int *first = taut_arena_take(w->arena, spans + 1, sizeof(int));
    int *member = taut_arena_take(w->arena, members, sizeof(int));
    if (taut_arena_status(w->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    memset(sizes, 1, (size_t)w->unknowns);
    spans = 0;
    for (int p = 0; p < w->count; p++) {
        const sheet *s = &w->sheets[p];
        const taut_dual_axis *u = &s->dual.u, *v = &s->dual.v;
        for (int k = 0; k < u->spans * v->spans; k++) {
            for (int m = 0; m < u->local * v->local; m++) {
                const int i = u->first[k / v->spans] + m / v->local;
                const int j = v->first[k % v->spans] + m % v->local;
                member[n++] = w->shared[s->first + i * v->count + j];
            }
            first[++spans] = (int)n;
        }
    }
    return taut_sparse_new(w->unknowns, sizes, (int)spans, first, member, &w->sparse);
}

/* ---- systems ---- */

/* psi of all patches, from the unknowns. */
static void spread(const work *w, const double *psi)
{
    for (int k = 0; k < w->all; k++) {
        w->patch[k] = psi[w->shared[k]];
    }
}

static taut_dual_value evaluate(void *context, const double *psi)
{
    work *w = context;
    taut_dual_value all = {0, 0};

    spread(w, psi);
    for (int p = 0; p < w->count; p++) {
        sheet *s = &w->sheets[p];
        const taut_dual_value one = taut_dual_evaluate(&s->dual, w->patch + s->first, NULL);
        all.gap += one.gap;
        all.steepest = one.steepest <= all.steepest ? all.steepest : one.steepest; /* NaN stays */
    }
    return all;
}

/* The number of one of all in the system of its patch. */
static int row_of(const work *w, int k)
{
    const sheet *s = &w->sheets[w->owner[k]];
    const int local = k - s->first;
    return taut_dual_number(&s->dual, local / s->dual.v.count, local % s->dual.v.count);
}

static void block_of(const void *context, int a, int b, double *block)
{
    const work *w = context;
    double sum = 0;

    for (int k = w->start[a]; k < w->start[a + 1]; k++) {
        for (int m = w->start[b]; m < w->start[b + 1]; m++) {
            if (w->owner[w->own[k]] == w->owner[w->own[m]]) {
                sum += taut_band_at(&w->sheets[w->owner[w->own[k]]].dual.matrix,
                                    row_of(w, w->own[k]), row_of(w, w->own[m]));
            }
        }
    }
    *block = a == 0 && b == 0 ? 2 * sum : sum; /* the constant costs now, and is not taken */
}

static taut_status solve(void *context, const double *psi, double *step)
{
    work *w = context;
    int negative = 0;
    taut_status status = TAUT_OK;

    if (psi != NULL) {
        spread(w, psi);
    }
    for (int p = 0; status == TAUT_OK && p < w->count; p++) {
        sheet *s = &w->sheets[p];
        status = taut_dual_assemble(&s->dual, psi != NULL ? w->patch + s->first : NULL);
    }
    if (status == TAUT_OK) {
        status = taut_sparse_factor(w->sparse, block_of, w, &w->pulse, &negative);
    }
    if (status != TAUT_OK) {
        return status;
    }
    memset(step, 0, (size_t)w->unknowns * sizeof(double));
    for (int k = 0; k < w->all; k++) {
        step[w->shared[k]] += w->sheets[w->owner[k]].dual.right[row_of(w, k)];
    }
    taut_sparse_solve(w->sparse, step);
    const double free = step[0];
    for (int a = 0; a < w->unknowns; a++) {
        step[a] -= free;
        if (!isfinite(step[a])) {
            return TAUT_NO_SOLUTION;
        }
    }
    return negative == 0 ? TAUT_OK : TAUT_NO_SOLUTION;
}

static taut_status find_psi(work *w)
{
    w->patch = taut_arena_take(w->arena, (size_t)w->all, sizeof(double));
    w->psi = taut_arena_take(w->arena, (size_t)w->unknowns, sizeof(double));
    w->step = taut_arena_take(w->arena, (size_t)w->unknowns, sizeof(double));
    w->next = taut_arena_take(w->arena, (size_t)w->unknowns, sizeof(double));
    if (taut_arena_status(w->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    const taut_dual_climb climb = {.count = (size_t)w->unknowns,
                                   .area = w->area,
                                   .flops = w->flops + taut_sparse_work(w->sparse),
                                   .evaluate = evaluate,
                                   .solve = solve,
                                   .context = w,
                                   .pulse = &w->pulse};
    return taut_dual_climb_up(&climb, w->psi, w->step, w->next, &w->value);
}

/* ---- what is told ---- */

/* The coefficients in the user's unit, to the decimals that count. 0: they are no witness. */
static int tell(work *w, int exponent, taut_record *details)
{
    double steep = 0;

    for (int p = 0; p < w->count; p++) {
        const taut_dual_axis *u = &w->sheets[p].dual.u, *v = &w->sheets[p].dual.v;
        steep = fmax(steep, fmax(u->spans * u->local, v->spans * v->local));
    }
    const double power = taut_dual_decimals(w->value.gap / w->area, steep, exponent);
    for (int a = 0; a < w->unknowns; a++) {
        w->step[a] = taut_dual_round(ldexp(w->psi[a], exponent), power) + 0.0; /* no -0 */
        w->next[a] = ldexp(w->step[a], -exponent);
    }
    w->value = evaluate(w, w->next);
    if (!(w->value.steepest < 1) || !isfinite(w->value.gap)) {
        return 0;
    }
    spread(w, w->step);
    taut_record *least = taut_record_add_object(details, "least");
    taut_record_add_numbers(least, "direction", 3, w->e);
    taut_record *patches = taut_record_add_list(least, "patches");
    for (int p = 0; p < w->count; p++) {
        const sheet *s = &w->sheets[p];
        taut_plateau_describe_psi(s->u, s->v, w->patch + s->first,
                                  taut_record_add_object(patches, NULL));
    }
    return 1;
}

static taut_status find(const taut_film_layout *layout, const taut_film_rest *rest, work *w,
                        taut_record *details)
{
    taut_status status = scale_sheets(layout, rest, w);

    if (status == TAUT_OK) {
        status = find_direction(w);
    }
    if (status == TAUT_OK) {
        status = make_duals(w);
    }
    if (status == TAUT_OK) {
        status = share(w);
    }
    if (status == TAUT_OK) {
        status = make_sparse(w);
    }
    if (status == TAUT_OK) {
        status = find_psi(w);
    }
    if (status == TAUT_OK) {
        (void)tell(w, layout->scaling.outer + layout->scaling.inner, details);
    }
    return status;
}

taut_status taut_complex_witness_add(const taut_film_layout *layout, const taut_film_rest *rest,
                                     const taut_monitor *monitor, taut_record *details)
{
    work w = {.complex = &layout->complex,
              .arena = taut_arena_new(),
              .pulse = {.monitor = monitor, .what = "witness", .done = NAN},
              .count = layout->complex.problem->patch_count};
    taut_status status =
        w.arena != NULL ? taut_film_rim_find(w.complex, w.arena, &w.rim) : TAUT_NO_MEMORY;

    w.sheets = taut_arena_take(w.arena, (size_t)w.count, sizeof *w.sheets);
    if (status == TAUT_OK && w.sheets == NULL) {
        status = TAUT_NO_MEMORY;
    }
    if (status == TAUT_OK && w.rim.why == NULL && w.complex->points <= TAUT_PLATEAU_LEAST_MAX) {
        status = taut_pulse_report(&w.pulse) ? TAUT_INTERRUPTED : find(layout, rest, &w, details);
    }
    for (int p = 0; w.sheets != NULL && p < w.count; p++) {
        if (p < w.made) {
            taut_dual_clear(&w.sheets[p].dual);
        }
        taut_basis_free(w.sheets[p].u);
        taut_basis_free(w.sheets[p].v);
        taut_surface_free(w.sheets[p].scaled);
    }
    taut_sparse_free(w.sparse);
    taut_arena_free(w.arena);
    return status == TAUT_NO_MEMORY || status == TAUT_INTERRUPTED ? status : TAUT_OK;
}
