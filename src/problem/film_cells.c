#include "problem/film_cells.h"

#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};
static const double gap_plane = 1e-9; /* of the size */

int taut_film_cell_turn(const taut_film_cell *cell, int patch)
{
    int turn = 0;
    for (int k = 0; k < cell->count; k++) {
        if (cell->sides[k].patch == patch) {
            turn += cell->sides[k].reversed ? -1 : 1;
        }
    }
    return turn;
}

int taut_film_edge_turn(int edge)
{
    return edge == 1 || edge == 2 ? 1 : -1; /* along v0, u1, back v1, u0 */
}

int taut_film_cell_rim(const taut_film_complex *complex, const taut_film_cell *cell, int patch,
                       int edge)
{
    const taut_film_problem *problem = complex->problem;
    const int s = taut_film_complex_seam(problem, patch, edge);
    int rim = 0;

    if (s < 0) {
        return taut_film_edge_turn(edge) * taut_film_cell_turn(cell, patch);
    }
    for (int k = 0; k < problem->seams[s].count; k++) {
        const taut_film_side *side = &problem->seams[s].sides[k];
        rim += (side->reversed ? -1 : 1) * taut_film_edge_turn(side->edge) *
               taut_film_cell_turn(cell, side->patch);
    }
    return rim;
}

void taut_film_cell_name(const taut_film_problem *problem, int cell, char name[TAUT_FILM_NAME])
{
    if (problem->cells[cell].name != NULL) {
        snprintf(name, TAUT_FILM_NAME, "%.95s", problem->cells[cell].name);
    } else {
        snprintf(name, TAUT_FILM_NAME, "cell-%d", cell);
    }
}

/* Each side of a patch at most once, in all cells together. */
static taut_status check_sides(const taut_film_problem *problem, int c, int k, taut_error *error)
{
    const taut_film_face *face = &problem->cells[c].sides[k];
    char where[48];

    snprintf(where, sizeof where, "/cells/%d/sides/%d", c, k);
    if (face->patch < 0 || face->patch >= problem->patch_count) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", where, face->patch,
                         problem->patch_count - 1, "side %d of cell %d is of no patch", k, c);
    }
    for (int i = 0; i <= c; i++) {
        for (int j = 0; j < (i == c ? k : problem->cells[i].count); j++) {
            const taut_film_face *other = &problem->cells[i].sides[j];
            if (other->patch == face->patch && !other->reversed == !face->reversed) {
                return taut_fail(
                    error, TAUT_BAD_INPUT, "cell-sides", where, 2, 1,
                    "side \"%s%.80s\" bounds a cell already, cells %d: name each side once, the "
                    "other one with a minus sign",
                    face->reversed ? "-" : "", problem->patches[face->patch].name, i);
            }
        }
    }
    return TAUT_OK;
}

/* How far `from` is from a plane that an edge moves in; infinite where it is kept in none. */
static double away_from(const taut_film_edge *edge, const double from[3])
{
    double to[3];

    if (edge->kind != TAUT_FILM_SLIDE && !(edge->kind == TAUT_FILM_CABLE && edge->has_plane)) {
        return INFINITY;
    }
    taut_difference(from, edge->plane.point, to);
    return fabs(taut_dot(to, edge->plane.direction)) / taut_norm(edge->plane.direction);
}

static taut_status check_rim(const taut_film_complex *c, int k, int p, int e, double size,
                             taut_error *error)
{
    const taut_film_problem *problem = c->problem;
    const taut_film_cell *cell = &problem->cells[k];
    const int s = taut_film_complex_seam(problem, p, e);
    const taut_film_edge *edge = s >= 0 ? &problem->seams[s].edge : &problem->patches[p].edges[e];
    const double away = away_from(edge, cell->from);
    const int held = s < 0 && edge->kind == TAUT_FILM_FIXED;
    char where[48], name[TAUT_FILM_NAME], called[TAUT_FILM_NAME];

    if (edge->kind == TAUT_FILM_POLE || held || away <= gap_plane * size ||
        taut_film_cell_rim(c, cell, p, e) == 0) {
        return TAUT_OK;
    }
    snprintf(where, sizeof where, "/cells/%d/from", k);
    taut_film_complex_name(problem, p, edge_names[e], name);
    taut_film_cell_name(problem, k, called);
    return isfinite(away)
               ? taut_fail(error, TAUT_NO_SOLUTION, "open-cell", where, away, gap_plane * size,
                           "cell %s ends at edge %s, which moves in a plane that \"from\" is %.3g "
                           "away from: give it a point of that plane",
                           called, name, away)
               : taut_fail(error, TAUT_NO_SOLUTION, "open-cell", where, taut_none, taut_none,
                           "cell %s ends at edge %s, which moves in no plane: close the cell "
                           "there, turn a side (\"-NAME\"), or hold the edge",
                           called, name);
}

taut_status taut_film_cells_check(const taut_film_complex *complex, taut_error *error)
{
    const taut_film_problem *problem = complex->problem;
    const double size = taut_film_complex_size(problem);
    taut_status status = TAUT_OK;

    for (int k = 0; status == TAUT_OK && k < problem->cell_count; k++) {
        for (int i = 0; status == TAUT_OK && i < problem->cells[k].count; i++) {
            status = check_sides(problem, k, i, error);
        }
        for (int e = 0; status == TAUT_OK && e < 4 * problem->patch_count; e++) {
            status = check_rim(complex, k, e / 4, e % 4, size, error);
        }
    }
    return status;
}
