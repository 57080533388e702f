/* film_places.c -- where points, corners and edges of films of many patches are, and planes that hold them: of film_complex.h. */
#include "problem/film_complex.h"

#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double parallel = 1e-9; /* sine */

/* Films of many patches have no bases of their own. */
static int is_lone(const taut_film_problem *problem)
{
    return problem->u != NULL;
}

void taut_film_complex_where(const taut_film_problem *problem, taut_error *error)
{
    static const char prefix[] = "/patches/0";
    const size_t length = sizeof prefix - 1;

    if (is_lone(problem) && error != NULL && strncmp(error->where, prefix, length) == 0) {
        memmove(error->where, error->where + length, strlen(error->where + length) + 1);
    }
}

void taut_film_complex_name(const taut_film_problem *problem, int patch, const char *part,
                            char name[TAUT_FILM_NAME])
{
    snprintf(name, TAUT_FILM_NAME, "%.88s%s%s",
             is_lone(problem) ? "" : problem->patches[patch].name, is_lone(problem) ? "" : ".",
             part);
}

int taut_film_complex_along(const taut_film_problem *patch, int edge)
{
    return taut_basis_count(edge < 2 ? patch->v : patch->u);
}

int taut_film_complex_point(const taut_film_problem *patch, int edge, int k)
{
    const int nu = taut_basis_count(patch->u), nv = taut_basis_count(patch->v);
    return edge < 2 ? (edge == 1 ? nu - 1 : 0) * nv + k : k * nv + (edge == 3 ? nv - 1 : 0);
}

int taut_film_complex_run(const taut_film_complex *complex, const taut_film_side *side, int k)
{
    const taut_film_problem *patch = &complex->problem->patches[side->patch];
    const int last = taut_film_complex_along(patch, side->edge) - 1;
    return complex->first[side->patch] +
           taut_film_complex_point(patch, side->edge, side->reversed ? last - k : k);
}

int taut_film_complex_node(const taut_film_complex *complex, const taut_film_side *side, int k)
{
    return complex->node[taut_film_complex_run(complex, side, k)];
}

int taut_film_edge_corner(int edge, int end)
{
    return edge < 2 ? edge + 2 * end : end + 2 * (edge - 2);
}

int taut_film_complex_corner(const taut_film_complex *complex, int patch, int corner)
{
    const taut_film_problem *of = &complex->problem->patches[patch];
    const int last = taut_film_complex_along(of, corner % 2) - 1;
    return complex
        ->node[complex->first[patch] + taut_film_complex_point(of, corner % 2, corner / 2 * last)];
}

int taut_film_complex_seam(const taut_film_problem *problem, int patch, int edge)
{
    for (int s = 0; s < problem->seam_count; s++) {
        for (int k = 0; k < problem->seams[s].count; k++) {
            const taut_film_side *side = &problem->seams[s].sides[k];
            if (side->patch == patch && side->edge == edge) {
                return s;
            }
        }
    }
    return -1;
}

/* ---- planes ---- */

int taut_film_hold_add(taut_film_hold *hold, const double normal[3], double offset, double gap)
{
    double n[3] = {normal[0], normal[1], normal[2]};
    const double whole = taut_norm(normal);

    for (int k = 0; k < hold->count; k++) {
        const double along = taut_dot(n, hold->normals[k]);
        taut_add_scaled(-along, hold->normals[k], n);
        offset -= along * hold->offsets[k];
    }
    const double left = taut_norm(n);
    if (hold->count == 3 || !(left > parallel * whole)) {
        return fabs(offset) <= gap * whole;
    }
    for (int c = 0; c < 3; c++) {
        hold->normals[hold->count][c] = n[c] / left;
    }
    hold->offsets[hold->count++] = offset / left;
    return 1;
}

void taut_film_hold_onto(const taut_film_hold *hold, double x[3])
{
    for (int k = 0; k < hold->count; k++) {
        taut_add_scaled(hold->offsets[k] - taut_dot(hold->normals[k], x), hold->normals[k], x);
    }
}
