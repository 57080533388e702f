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

int taut_film_hold_left(taut_film_hold *hold, double *ways)
{
    int count = 0;

    for (int k = 0; hold->count < 3 && k < 6; k++) { /* axes that are far from what holds first */
        const double axis[3] = {k % 3 == 0, k % 3 == 1, k % 3 == 2};
        const int before = hold->count;
        double left = 1;
        for (int n = 0; n < before; n++) {
            const double along = taut_dot(axis, hold->normals[n]);
            left -= along * along;
        }
        if (left > (k < 3 ? 0.3 : 1e-6)) {
            (void)taut_film_hold_add(hold, axis, 0, INFINITY);
        }
        if (hold->count > before) {
            memcpy(ways + 3 * count++, hold->normals[before], 3 * sizeof(double));
        }
    }
    return count;
}

void taut_film_complex_tangent(const taut_film_complex *complex, const double *points, int node,
                               double t[3])
{
    const taut_film_complex *c = complex;
    const taut_film_side *side = &c->line[node];
    const taut_film_problem *patch = &c->problem->patches[side->patch];
    const taut_basis *basis = side->edge < 2 ? patch->v : patch->u;
    const int p = taut_basis_degree(basis), n = taut_basis_count(basis), k = c->at[node];
    double values[2 * (TAUT_DEGREE_MAX + 1)], at = 0;
    taut_basis_spec spec;

    taut_basis_spec_of(basis, &spec);
    for (int i = 1; i <= p; i++) {
        at += spec.knots != NULL ? spec.knots[k + i] / p
              : k + i > p        ? taut_basis_hi(basis) / p
                                 : taut_basis_lo(basis) / p;
    }
    at = k == 0 ? taut_basis_lo(basis) : k == n - 1 ? taut_basis_hi(basis) : at;
    const int span = taut_basis_span(basis, at), first = taut_basis_first(basis, span);
    memset(t, 0, 3 * sizeof(double));
    if (taut_basis_eval(basis, span, at, 1, values) != TAUT_OK) {
        return;
    }
    for (int i = 0; i < taut_basis_local(basis); i++) {
        const int point =
            c->first[side->patch] + taut_film_complex_point(patch, side->edge, first + i);
        taut_add_scaled(values[taut_basis_local(basis) + i], points + 3 * point, t);
    }
}
