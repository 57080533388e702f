#include "construct/film/complex/balance.h"

#include "construct/film/edges.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>

static const double rounding = 1e-12; /* of a sum of forces */
static const double straight = 1e-9;  /* of the size: of lines that are parallel */

/* Is what is inside a seam free? */
static int is_free(const taut_film_complex *c, const taut_film_seam *seam)
{
    const taut_film_side *side = &seam->sides[0];
    const int count = taut_film_complex_along(&c->problem->patches[side->patch], side->edge);

    for (int k = 1; k < count - 1; k++) {
        if (c->holds[taut_film_complex_node(c, side, k)].count > 0) {
            return 0;
        }
    }
    for (int k = 0; k < seam->count; k++) {
        if (taut_film_has_density(&c->problem->patches[seam->sides[k].patch])) {
            return 0;
        }
    }
    return seam->edge.kind != TAUT_FILM_CABLE;
}

static taut_status check_seam(const taut_film_layout *l, int s, taut_error *error)
{
    const taut_film_problem *problem = l->complex.problem;
    const taut_film_seam *seam = &problem->seams[s];
    double sum = 0, most = 0;
    int strong = 0;
    char where[32];

    for (int k = 0; k < seam->count; k++) {
        const double tension = l->tensions[seam->sides[k].patch];
        sum += tension;
        strong = tension > most ? seam->sides[k].patch : strong;
        most = fmax(most, tension);
    }
    if (!is_free(&l->complex, seam) || most <= (sum - most) * (1 + rounding)) {
        return TAUT_OK;
    }
    snprintf(where, sizeof where, "/seams/%d", s);
    return taut_fail(error, TAUT_NO_SOLUTION, "unbalanced", where, most, sum - most,
                     "sheet %.80s draws this seam with %g, and all others with %g together: they "
                     "cannot balance (proved); give it less tension, or the seam a cable",
                     problem->patches[strong].name, most, sum - most);
}

/* Forces of the strands of cables that end in a node, of one that goes on there twice: their sum and the largest. 0: one of them is
 * not given. */
static int add_ends(const taut_film_complex *c, int node, double *sum, double *most, int *strong)
{
    *sum = *most = 0;
    for (int k = 0; k < 2 * c->strand_count; k++) {
        const taut_film_strand *strand = &c->strands[k / 2];
        const taut_film_edge *law = c->ropes[strand->rope].edge;
        const taut_film_problem *patch = &c->problem->patches[strand->side.patch];
        const int last = taut_film_complex_along(patch, strand->side.edge) - 1;
        if (taut_film_complex_node(c, &strand->side, k % 2 * last) != node) {
            continue;
        }
        if (law->law != TAUT_FILM_FORCE || law->has_plane || strand->edge->has_plane) {
            return 0;
        }
        *sum += law->force;
        *strong = law->force > *most ? strand->rope : *strong;
        *most = fmax(*most, law->force);
    }
    return 1;
}

static taut_status check_vertex(const taut_film_complex *c, int node, taut_error *error)
{
    double sum = 0, most = 0;
    int strong = 0;
    char where[TAUT_FILM_ROPE_WHERE], name[TAUT_FILM_NAME];

    if (c->holds[node].count > 0 || !add_ends(c, node, &sum, &most, &strong) ||
        most <= (sum - most) * (1 + rounding)) {
        return TAUT_OK;
    }
    taut_film_rope_where(c, strong, "force", where);
    taut_film_rope_name(c, strong, name);
    return taut_fail(error, TAUT_NO_SOLUTION, "unbalanced", where, most, sum - most,
                     "cable %s ends in a vertex that is free, draws it with %g, and all other "
                     "cables there with %g together: they cannot balance (proved); hold the "
                     "vertex, or give the cables forces that can",
                     name, most, sum - most);
}

/* ---- walls ---- */

static int is_slide(const taut_film_edge *edge, const double n[3])
{
    double across[3];
    taut_cross(edge->plane.direction, n, across);
    return edge->kind == TAUT_FILM_SLIDE &&
           taut_norm(across) <= straight * taut_norm(edge->plane.direction) * taut_norm(n);
}

/* The line that a sheet of the seam is held on, from its lower end to its upper one along the axis; 0: it is no wall. */
static int take_wall(const taut_film_layout *l, const taut_film_side *side, const double axis[3],
                     const double **low, const double **high)
{
    const taut_film_complex *c = &l->complex;
    const taut_film_problem *patch = &c->problem->patches[side->patch];
    const taut_film_side far = {side->patch, side->edge ^ 1, side->reversed};
    const int last = taut_film_complex_along(patch, far.edge) - 1, beside = side->edge < 2 ? 2 : 0;

    *low = l->start + 3 * taut_film_complex_node(c, &far, 0);
    *high = l->start + 3 * taut_film_complex_node(c, &far, last);
    for (int k = 0; k <= last; k++) {
        double from[3], across[3];
        taut_difference(l->start + 3 * taut_film_complex_node(c, &far, k), *low, from);
        taut_cross(from, axis, across);
        if (!(taut_norm(across) <= straight * taut_norm(axis))) {
            return 0;
        }
    }
    return patch->edges[far.edge].kind == TAUT_FILM_FIXED &&
           taut_film_complex_seam(c->problem, far.patch, far.edge) < 0 &&
           is_slide(&patch->edges[beside], axis) && is_slide(&patch->edges[beside + 1], axis) &&
           !taut_film_has_density(patch);
}

/* Is the sheet k of walls nothing where they have least energy? Feet on one plane, heights all the same. */
static int is_nothing(const taut_film_layout *l, const taut_film_seam *seam, int k,
                      const double axis[3])
{
    const double *foot = NULL, *top = NULL;
    double pull[3] = {0, 0, 0};

    if (!take_wall(l, &seam->sides[k], axis, &foot, &top)) {
        return 0;
    }
    for (int i = 0; i < seam->count; i++) {
        const double *low = NULL, *high = NULL;
        double way[3], along[3], height[3];
        if (i == k) {
            continue;
        }
        if (!take_wall(l, &seam->sides[i], axis, &low, &high)) {
            return 0;
        }
        taut_difference(low, foot, way);
        taut_difference(high, top, along);
        taut_difference(way, along, height);
        const double length = taut_norm(way);
        if (!(taut_norm(height) <= straight) ||
            !(fabs(taut_dot(way, axis)) <= straight * taut_norm(axis)) || !(length > straight)) {
            return 0;
        }
        taut_add_scaled(l->tensions[seam->sides[i].patch] / length, way, pull);
    }
    return taut_norm(pull) <= l->tensions[seam->sides[k].patch] * (1 - straight);
}

static taut_status check_walls(const taut_film_layout *l, taut_error *error)
{
    const taut_film_problem *problem = l->complex.problem;
    const taut_film_seam *seam = problem->seams;

    if (problem->seam_count != 1 || seam->count != problem->patch_count || seam->count < 3 ||
        problem->cell_count > 0 || l->complex.rope_count > 0) {
        return TAUT_OK;
    }
    const taut_film_side *side = &seam->sides[0];
    const double *axis =
        problem->patches[side->patch].edges[side->edge < 2 ? 2 : 0].plane.direction;
    for (int k = 0; k < seam->count; k++) {
        const int p = seam->sides[k].patch;
        if (is_nothing(l, seam, k, axis)) {
            return taut_fail(
                error, TAUT_NO_SOLUTION, "unbalanced", "/seams/0", l->tensions[p], taut_none,
                "the sheets other than %.80s draw the line where all meet onto its own line, and "
                "together too weakly to leave it: %.80s would be nothing (proved); at 120 degrees "
                "or more between two of three lines there is no line between them; leave %.80s out",
                problem->patches[p].name, problem->patches[p].name, problem->patches[p].name);
        }
    }
    return TAUT_OK;
}

taut_status taut_film_balance_check(const taut_film_layout *layout, taut_error *error)
{
    const taut_film_complex *c = &layout->complex;
    taut_status status = TAUT_OK;

    for (int s = 0; status == TAUT_OK && s < c->problem->seam_count; s++) {
        status = check_seam(layout, s, error);
    }
    for (int a = 0; status == TAUT_OK && c->rope_count > 0 && a < c->nodes; a++) {
        status = check_vertex(c, a, error);
    }
    return status == TAUT_OK ? check_walls(layout, error) : status;
}
