/* cuts.c -- see cuts.h.
 *
 *     lines of all faces; splines are cut at all of theirs, unless they are many or that makes an edge of one point
 *     until nothing changes: for each edge of two faces, one of them cut along it
 *         other lines there, or the other a spline that is not cut: neither is cut
 */
#include "io/step/cuts.h"

#include "geometry/exponent.h"

#include <math.h>

static const double together =
    1e-9; /* parameters, of the direction's range: what sewn edges may differ by */
static const double point =
    1e-7; /* an edge that is shorter, of the size, is one point to readers */

enum { PIECES_MAX = 16 };

static const taut_basis *basis_of(const taut_surface *surface, int d)
{
    return d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
}

/* Is there a knot at control point i, as often as the degree? Not more: a surface does not tear. */
static int is_line(const taut_basis_spec *spec, int i)
{
    return spec->degree > 1 && spec->knots[i + 1] == spec->knots[i + spec->degree];
}

static int find_lines(const taut_basis *basis, taut_arena *arena, taut_step_cuts *cuts, int d)
{
    taut_basis_spec spec;
    taut_basis_spec_of(basis, &spec);
    const int last = taut_basis_count(basis) - 1;
    cuts->pieces[d] = 1;
    for (int i = 1; i < last; i++) {
        cuts->pieces[d] += is_line(&spec, i);
    }
    int *lines = taut_arena_take(arena, (size_t)cuts->pieces[d] + 1, sizeof *lines);
    if (lines == NULL) {
        return 0;
    }
    int count = 0;
    lines[count++] = 0;
    for (int i = 1; i < last; i++) {
        if (is_line(&spec, i)) {
            lines[count++] = i;
        }
    }
    lines[count] = last;
    cuts->lines[d] = lines;
    return 1;
}

/* Is the row of direction d at `line` of the other one point between control points `from` and `to`? */
static int is_point(const taut_surface *surface, int d, int line, int from, int to)
{
    const int nv = taut_basis_count(taut_surface_v(surface));
    const double *net = taut_surface_points(surface);
    const double size = taut_half_size(taut_point_count(surface), net);
    const double *p = net + 3 * (d == 0 ? from * nv + line : line * nv + from);
    double most = 0;
    for (int i = 1; i <= to - from; i++) {
        const double *q = p + 3 * i * (d == 0 ? nv : 1);
        for (int k = 0; k < 3; k++) {
            most = fmax(most, fabs(q[k] - p[k]));
        }
    }
    return most <= point * size;
}

/* Has every piece of every line an extent, but for edges that are a point as a whole? */
static int has_edges(const taut_surface *surface, const taut_step_cuts *cuts)
{
    for (int d = 0; d < 2; d++) {
        const int *lines = cuts->lines[d], *others = cuts->lines[1 - d], last = cuts->pieces[1 - d];
        for (int j = 0; j <= last; j++) {
            const int whole =
                (j == 0 || j == last) && is_point(surface, d, others[j], 0, lines[cuts->pieces[d]]);
            for (int k = 0; k < cuts->pieces[d] && !whole; k++) {
                if (is_point(surface, d, others[j], lines[k], lines[k + 1])) {
                    return 0;
                }
            }
        }
    }
    return 1;
}

/* Do lines along two sides, 4 face + edge, lie at the same places? */
static int are_together(const taut_model *model, const taut_step_cuts *cuts, const int side[2],
                        int reversed)
{
    const taut_step_cuts *c[2] = {&cuts[side[0] / 4], &cuts[side[1] / 4]};
    const int d[2] = {side[0] % 4 < 2, side[1] % 4 < 2}, pieces = c[0]->pieces[d[0]];
    const taut_basis *basis[2] = {basis_of(taut_model_surface(model, side[0] / 4), d[0]),
                                  basis_of(taut_model_surface(model, side[1] / 4), d[1])};
    int same = c[1]->pieces[d[1]] == pieces;
    for (int k = 1; k < pieces && same; k++) {
        double at[2];
        for (int i = 0; i < 2; i++) {
            const int line = c[i]->lines[d[i]][i == 1 && reversed ? pieces - k : k];
            const double lo = taut_basis_lo(basis[i]), hi = taut_basis_hi(basis[i]);
            at[i] = (taut_step_parameter(basis[i], line) - lo) / (hi - lo);
        }
        same = fabs(at[0] - (reversed ? 1 - at[1] : at[1])) <= together;
    }
    return same;
}

/* Leaves whole what cannot be cut together; 1 if that changed something. */
static int settle(const taut_model *model, const taut_shells *shells, const taut_step_form *forms,
                  taut_step_cuts *cuts)
{
    int changed = 0;
    for (int e = 0; e < shells->edge_count; e++) {
        const taut_shell_edge *edge = &shells->edges[e];
        int *is_cut[2], may = 1;
        for (int i = 0; i < 2 && edge->side[1] >= 0; i++) {
            const int face = edge->side[i] / 4;
            is_cut[i] = &cuts[face].is_cut[edge->side[i] % 4 < 2];
            may = may && (*is_cut[i] || forms[face].kind != TAUT_STEP_SPLINE);
        }
        if (edge->side[1] >= 0 && (*is_cut[0] || *is_cut[1]) &&
            !(may && are_together(model, cuts, edge->side, edge->reversed))) {
            *is_cut[0] = *is_cut[1] = 0;
            changed = 1;
        }
    }
    return changed;
}

taut_status taut_step_find_cuts(const taut_model *model, const taut_shells *shells,
                                const taut_step_form *forms, int are_sheets, taut_arena *arena,
                                taut_step_cuts **cuts)
{
    taut_step_cuts *c = taut_arena_take(arena, (size_t)shells->face_count, sizeof *c);
    for (int f = 0; c != NULL && f < shells->face_count; f++) {
        const taut_surface *surface = taut_model_surface(model, f);
        if (!find_lines(taut_surface_u(surface), arena, &c[f], 0) ||
            !find_lines(taut_surface_v(surface), arena, &c[f], 1)) {
            return TAUT_NO_MEMORY;
        }
        const int cut =
            !are_sheets && forms[f].kind == TAUT_STEP_SPLINE && has_edges(surface, &c[f]);
        for (int d = 0; d < 2; d++) {
            c[f].is_cut[d] = cut && c[f].pieces[d] > 1 && c[f].pieces[d] <= PIECES_MAX;
        }
    }
    if (c == NULL) {
        return TAUT_NO_MEMORY;
    }
    while (settle(model, shells, forms, c)) {
    }
    *cuts = c;
    return TAUT_OK;
}
