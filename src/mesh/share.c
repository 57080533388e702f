/* share.c -- in a chain every direction is seen as [0, 1], mirrored where it lies the other way.
 * Breaks of different members that differ by less than near_enough are one; the cells between two
 * breaks are counted for each member on its own span there, and the largest count is taken by all.
 */
#include "mesh/seams.h"

#include "mesh/lines.h"

#include <math.h>
#include <stdlib.h>

static const double near_enough = 1e-9; /* moves a point of an edge by 1e-9 of its length, or so */
static const double narrow = 1e-7;

static double cells_of(const taut_chains *chains, double width, double bending)
{
    return chains->divide > 0 ? chains->divide : taut_cell_count(width, bending, chains->tolerance);
}

/* Can the breaks of this direction be told apart from those of others? */
static int is_wide(const taut_basis *basis)
{
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    const double width = breaks[spans] - breaks[0];
    int s = 0;
    while (s < spans && breaks[s + 1] - breaks[s] > narrow * width) {
        s++;
    }
    return s == spans;
}

/* Lists the members of each chain, in their order; the breaks of the longest are counted. */
static size_t list_members(taut_chains *chains)
{
    size_t longest = 0;
    for (int i = 0; i < chains->count; i++) {
        chains->first[i] = -1;
    }
    for (int i = chains->count - 1; i >= 0; i--) {
        int flip = 0;
        const int root = taut_mirror_root(&chains->sets, i, &flip);
        chains->next[i] = chains->first[root];
        chains->first[root] = i;
    }
    for (int i = 0; i < chains->count; i++) {
        size_t breaks = 0;
        for (int m = chains->first[i]; m >= 0; m = chains->next[m]) {
            breaks += (size_t)taut_basis_span_count(chains->directions[m].basis) + 1;
        }
        longest = breaks > longest ? breaks : longest;
    }
    return longest;
}

taut_status taut_chains_new(taut_direction *directions, int count, const taut_seam *seams,
                            int seam_count, double tolerance, int divide, taut_arena *arena,
                            taut_chains *chains)
{
    size_t longest = 0;
    *chains = (taut_chains){
        .directions = directions, .count = count, .tolerance = tolerance, .divide = divide};
    chains->first = taut_arena_take(arena, (size_t)count, sizeof *chains->first);
    chains->next = taut_arena_take(arena, (size_t)count, sizeof *chains->next);
    if (chains->first == NULL || chains->next == NULL ||
        !taut_mirror_sets_new(count, arena, &chains->sets)) {
        return TAUT_NO_MEMORY;
    }
    for (int s = 0; s < seam_count; s++) {
        const int a = 2 * (seams[s].a / 4) + taut_edge_along(seams[s].a);
        const int b = 2 * (seams[s].b / 4) + taut_edge_along(seams[s].b);
        if (is_wide(directions[a].basis) && is_wide(directions[b].basis)) {
            taut_mirror_unite(&chains->sets, a, b, seams[s].reversed);
        }
    }
    longest = list_members(chains);
    chains->breaks = taut_arena_take(arena, longest, 2 * sizeof *chains->breaks);
    chains->cells = taut_arena_take(arena, longest, 2 * sizeof *chains->cells);
    return chains->breaks != NULL && chains->cells != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}

static int by_size(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return *x < *y ? -1 : *x > *y;
}

/* Break s of a member as the chain sees it. */
static double shared_break(const taut_basis *basis, int s, int flip)
{
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    const double share = s == 0       ? 0
                         : s == spans ? 1
                                      : (breaks[s] - breaks[0]) / (breaks[spans] - breaks[0]);
    return flip ? 1 - share : share;
}

/* All breaks of a chain, sorted, close ones as one: their number. */
static int gather_breaks(taut_chains *chains, int root)
{
    const int both = chains->sets.both[root];
    size_t count = 0;
    int kept = 0;
    for (int m = chains->first[root]; m >= 0; m = chains->next[m]) {
        const taut_basis *basis = chains->directions[m].basis;
        int flip = 0;
        taut_mirror_root(&chains->sets, m, &flip);
        for (int s = 0; s <= taut_basis_span_count(basis); s++) {
            chains->breaks[count++] = shared_break(basis, s, flip);
            if (both) {
                chains->breaks[count++] = shared_break(basis, s, !flip);
            }
        }
    }
    qsort(chains->breaks, count, sizeof *chains->breaks, by_size);
    for (size_t i = 1; i < count; i++) {
        if (chains->breaks[i] - chains->breaks[kept] > near_enough) {
            chains->breaks[++kept] = chains->breaks[i];
        }
    }
    chains->breaks[kept] = 1; /* what is close to the end is the end */
    return kept + 1;
}

/* Walks over the cuts of a chain along one member, in the order of its own parameter. */
typedef struct walk {
    const taut_basis *basis;
    const double *shared; /* [count], of the chain */
    int count, flip;
    int span; /* of the member, that holds the cells after the last cut */
} walk;

/* The member's parameter at cut k of its own order: its own break where it has one there. */
static double step_through(walk *at, int k)
{
    const double *breaks = taut_basis_breaks(at->basis);
    const int spans = taut_basis_span_count(at->basis);
    const double share = at->flip ? 1 - at->shared[at->count - 1 - k] : at->shared[k];
    const double ahead = shared_break(at->basis, at->span + 1, 0);
    if (k == 0 || k == at->count - 1) {
        return k == 0 ? breaks[0] : breaks[spans];
    }
    if (at->span + 1 < spans && fabs(share - ahead) <= 2 * near_enough) {
        return breaks[++at->span];
    }
    return breaks[0] + share * (breaks[spans] - breaks[0]);
}

/* The most cells that any member wants between two cuts, in cells[count - 1]. */
static void count_cells(taut_chains *chains, int root, int count)
{
    for (int k = 0; k + 1 < count; k++) {
        chains->cells[k] = 1;
    }
    for (int m = chains->first[root]; m >= 0; m = chains->next[m]) {
        const taut_direction *direction = &chains->directions[m];
        walk at = {direction->basis, chains->breaks, count, 0, 0};
        double from = 0, to = 0;
        taut_mirror_root(&chains->sets, m, &at.flip);
        from = step_through(&at, 0);
        for (int k = 0; k + 1 < count; k++) {
            const int cell = at.flip ? count - 2 - k : k;
            const double bending = direction->bending[at.span];
            to = step_through(&at, k + 1);
            chains->cells[cell] = fmax(chains->cells[cell], cells_of(chains, to - from, bending));
            from = to;
        }
    }
    for (int k = 0; chains->sets.both[root] && k + 1 < count; k++) {
        chains->cells[k] = fmax(chains->cells[k], chains->cells[count - 2 - k]);
    }
}

/* The lines of one member between the cuts. */
static void lay_lines(taut_chains *chains, int m, int count)
{
    const taut_direction *direction = &chains->directions[m];
    walk at = {direction->basis, chains->breaks, count, 0, 0};
    double from = 0, to = 0;
    int n = 0;
    taut_mirror_root(&chains->sets, m, &at.flip);
    from = step_through(&at, 0);
    for (int k = 0; k + 1 < count; k++) {
        const double cells = chains->cells[at.flip ? count - 2 - k : k];
        to = step_through(&at, k + 1);
        for (int i = 0; i < (int)cells; i++) {
            direction->lines[n++] = from + (to - from) * i / cells;
        }
        from = to;
    }
    direction->lines[n] = from;
}

/* A direction on its own keeps its breaks as they are. */
static void cut_alone(const taut_chains *chains, taut_direction *direction, int lay)
{
    const double *breaks = taut_basis_breaks(direction->basis);
    const int spans = taut_basis_span_count(direction->basis);
    int n = 0;
    direction->wish = 0;
    for (int s = 0; s < spans; s++) {
        const double width = breaks[s + 1] - breaks[s];
        const double cells = cells_of(chains, width, direction->bending[s]);
        direction->wish += cells;
        for (int i = 0; lay && i < (int)cells; i++) {
            direction->lines[n++] = breaks[s] + width * i / cells;
        }
    }
    if (lay) {
        direction->lines[n] = breaks[spans];
    }
}

void taut_chains_cut(taut_chains *chains, int lay)
{
    for (int root = 0; root < chains->count; root++) {
        const int first = chains->first[root];
        double wish = 0;
        int count = 0;
        if (first < 0) {
            continue;
        }
        if (chains->next[first] < 0 && !chains->sets.both[root]) {
            cut_alone(chains, &chains->directions[first], lay);
            continue;
        }
        count = gather_breaks(chains, root);
        count_cells(chains, root, count);
        for (int k = 0; k + 1 < count; k++) {
            wish += chains->cells[k];
        }
        for (int m = first; m >= 0; m = chains->next[m]) {
            chains->directions[m].wish = wish;
            if (lay) {
                lay_lines(chains, m, count);
            }
        }
    }
}
