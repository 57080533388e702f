#include "problem/film_rim.h"

#include "problem/film_cells.h"

static double tension_of(const taut_film_problem *patch)
{
    return patch->tension > 0 ? patch->tension : 1;
}

static const char *find_cable(const taut_film_problem *problem)
{
    int has = 0;

    for (int k = 0; k < 4 * problem->patch_count; k++) {
        has |= problem->patches[k / 4].edges[k % 4].kind == TAUT_FILM_CABLE &&
               taut_film_complex_seam(problem, k / 4, k % 4) < 0;
    }
    for (int s = 0; s < problem->seam_count; s++) {
        has |= problem->seams[s].edge.kind == TAUT_FILM_CABLE;
    }
    return has ? "cables: of patches with cables no bound is known" : NULL;
}

/* What no bound is known of, before what would have to be held for one. */
static const char *find_obstacle(const taut_film_problem *problem)
{
    const char *why = find_cable(problem);

    if (problem->cell_count > 0) {
        return "cells: of films under pressure no bound is known";
    }
    for (int p = 0; p < problem->patch_count; p++) {
        const taut_film_problem *patch = &problem->patches[p];
        if (patch->force_density[0] > 0 || patch->prestress[0] > 0) {
            return "threads: of patches of threads, beside others, no bound is known";
        }
    }
    for (int p = 0; why == NULL && p < problem->patch_count; p++) {
        if (tension_of(&problem->patches[p]) != tension_of(&problem->patches[0])) {
            why = "tension: of patches of different tensions no bound is known";
        }
    }
    for (int s = 0; why == NULL && s < problem->seam_count; s++) {
        if (problem->seams[s].count != 2) {
            why = "lines: of films that meet in lines no bound is known";
        }
    }
    for (int k = 0; why == NULL && k < 4 * problem->patch_count; k++) {
        const taut_film_edge_kind kind = problem->patches[k / 4].edges[k % 4].kind;
        if (kind != TAUT_FILM_FIXED && taut_film_complex_seam(problem, k / 4, k % 4) < 0) {
            why = kind == TAUT_FILM_POLE
                      ? "pole: of patches that close in a point no bound is known"
                      : "moving: the bound is one of a boundary that is held";
        }
    }
    return why;
}

/* +1, -1: a side runs with the boundary of its patch, or against it. */
static int turn_of(const taut_film_side *side)
{
    return taut_film_edge_turn(side->edge) * (side->reversed ? -1 : 1);
}

/* Signs with which both sides of every seam run against each other, from the first patch on. */
static const char *find_signs(const taut_film_problem *problem, int *sign)
{
    int found = 1, before = 0;

    sign[0] = 1;
    while (found > before) {
        before = found;
        for (int s = 0; s < problem->seam_count; s++) {
            const taut_film_side *a = &problem->seams[s].sides[0];
            const taut_film_side *b = &problem->seams[s].sides[1];
            const int both = -turn_of(a) * turn_of(b);
            if (sign[a->patch] != 0 && sign[b->patch] == 0) {
                sign[b->patch] = both * sign[a->patch];
                found++;
            } else if (sign[b->patch] != 0 && sign[a->patch] == 0) {
                sign[a->patch] = both * sign[b->patch];
                found++;
            } else if (sign[a->patch] != both * sign[b->patch]) {
                return "sides: the film has one side only";
            }
        }
    }
    return found == problem->patch_count ? NULL : "apart: the film is not in one piece";
}

/* The node where a side begins (0) or ends (1), as it is run. */
static int end_of(const taut_film_complex *complex, const taut_film_side *side, int end)
{
    const taut_film_problem *patch = &complex->problem->patches[side->patch];
    return taut_film_complex_node(complex, side,
                                  end * (taut_film_complex_along(patch, side->edge) - 1));
}

/* Sides in turn, each from where the one before it ends; all of them once. */
static const char *run_through(const taut_film_complex *complex, int *from, taut_film_side *all,
                               taut_film_rim *rim)
{
    for (int a = 0; a < complex->nodes; a++) {
        from[a] = -1;
    }
    for (int k = 0; k < rim->count; k++) {
        const int node = end_of(complex, &all[k], 0);
        if (from[node] >= 0) {
            return "touches: the boundary meets itself in a corner";
        }
        from[node] = k;
    }
    for (int k = 0, at = 0; k < rim->count; k++) {
        rim->sides[k] = all[at];
        at = from[end_of(complex, &all[at], 1)];
        if (at < 0 || (at == 0) != (k == rim->count - 1)) {
            return "curves: the boundary is not one closed curve";
        }
    }
    return NULL;
}

taut_status taut_film_rim_find(const taut_film_complex *complex, taut_arena *arena,
                               taut_film_rim *rim)
{
    const taut_film_problem *problem = complex->problem;
    const size_t patches = (size_t)problem->patch_count;
    taut_film_side *all = taut_arena_take(arena, 4 * patches, sizeof *all);
    int *from = taut_arena_take(arena, (size_t)complex->nodes, sizeof(int));

    *rim = (taut_film_rim){.why = find_obstacle(problem)};
    rim->sign = taut_arena_take(arena, patches, sizeof(int));
    rim->sides = taut_arena_take(arena, 4 * patches, sizeof(taut_film_side));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    if (rim->why == NULL) {
        rim->why = find_signs(problem, rim->sign);
    }
    for (int k = 0; rim->why == NULL && k < 4 * problem->patch_count; k++) {
        if (taut_film_complex_seam(problem, k / 4, k % 4) < 0) {
            const int turn = taut_film_edge_turn(k % 4) * rim->sign[k / 4];
            all[rim->count++] = (taut_film_side){k / 4, k % 4, turn < 0};
        }
    }
    if (rim->why == NULL) {
        rim->why = rim->count > 0 ? run_through(complex, from, all, rim)
                                  : "closed: the film has no boundary";
    }
    return TAUT_OK;
}
