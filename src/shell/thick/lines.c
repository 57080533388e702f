/* lines.c -- knots of the sides.
 *
 * Surfaces that share an edge need the same knots along it, as an edge is one spline; and a line of knots runs across the whole
 * surface to the next edge. So directions hang together in chains (mesh/seams.h), mirrored where one lies the other way.
 *
 * Normals have a derivative less than their surface: where x is C^k, sides are C^(k-1), and a knot of degree 5 is there 6 - k
 * times. Spans that are halved get single knots.
 */
#include "core/fail.h"
#include "shell/thick/parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double near_enough = 1e-9; /* breaks nearer than this are one */
enum { BREAKS_MAX = 400 };              /* of a line: a net of 2000 x 2000 points at most */

/* A break and how often it is a knot. */
typedef struct knot {
    double at;
    int times;
} knot;

static const taut_basis *basis_of(const taut_thick_work *work, int direction)
{
    const taut_surface *surface = work->surfaces[direction / 2];
    return direction % 2 == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
}

static int by_place(const void *a, const void *b)
{
    const knot *x = a, *y = b;
    return x->at != y->at ? (x->at < y->at ? -1 : 1) : y->times - x->times;
}

static size_t break_count(const taut_basis *basis)
{
    return (size_t)taut_basis_span_count(basis) + 1;
}

/* The inner breaks of a direction, and how often sides need them. */
static size_t list_breaks(const taut_basis *basis, int flip, knot *list)
{
    taut_basis_spec spec;
    size_t count = 0;
    taut_basis_spec_of(basis, &spec);
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    for (int k = spec.degree + 1; k < spec.knot_count - spec.degree - 1;) {
        int next = k;
        while (next < spec.knot_count && spec.knots[next] == spec.knots[k]) {
            next++;
        }
        const double share = (spec.knots[k] - lo) / (hi - lo);
        const int smooth = spec.degree - (next - k) - 1; /* C^smooth is n */
        const int times = smooth < 0 ? TAUT_THICK_DEGREE : TAUT_THICK_DEGREE - smooth;
        list[count++] = (knot){flip ? 1 - share : share, times > 1 ? times : 1};
        k = next;
    }
    return count;
}

/* Sorts, makes close ones one, which is there as often as the most frequent of them, and puts the ends. */
static taut_status lay_line(taut_thick_work *work, size_t count, knot *list, taut_thick_line *line)
{
    int kept = 0;
    qsort(list, count, sizeof *list, by_place);
    line->breaks = taut_arena_take(work->arena, count + 2, sizeof *line->breaks);
    line->times = taut_arena_take(work->arena, count + 2, sizeof *line->times);
    line->halved = taut_arena_take(work->arena, count + 2, 1);
    if (line->breaks == NULL || line->times == NULL || line->halved == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        if (list[i].at > line->breaks[kept] + near_enough && list[i].at < 1 - near_enough) {
            kept++;
            line->breaks[kept] = list[i].at;
            line->times[kept] = list[i].times;
        } else if (kept > 0 && list[i].at < 1 - near_enough && list[i].times > line->times[kept]) {
            line->times[kept] = list[i].times;
        }
    }
    line->breaks[++kept] = 1;
    line->count = kept + 1;
    return TAUT_OK;
}

static taut_status gather_line(taut_thick_work *work, int root)
{
    const int directions = 2 * work->count;
    size_t room = 0, count = 0;
    for (int d = 0; d < directions; d++) {
        int flip = 0;
        room +=
            taut_mirror_root(&work->sets, d, &flip) == root ? break_count(basis_of(work, d)) : 0;
    }
    knot *list = taut_arena_take(work->arena, 2 * room, sizeof *list);
    if (list == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int d = 0; d < directions; d++) {
        int flip = 0;
        if (taut_mirror_root(&work->sets, d, &flip) == root) {
            count += list_breaks(basis_of(work, d), flip, list + count);
            count +=
                work->sets.both[root] ? list_breaks(basis_of(work, d), !flip, list + count) : 0;
        }
    }
    return lay_line(work, count, list, &work->lines[root]);
}

taut_status taut_thick_find_lines(taut_thick_work *work)
{
    const int directions = 2 * work->count;
    work->lines = taut_arena_take(work->arena, (size_t)directions, sizeof *work->lines);
    if (work->lines == NULL || !taut_mirror_sets_new(directions, work->arena, &work->sets)) {
        return TAUT_NO_MEMORY;
    }
    for (int e = 0; e < 4 * work->count; e++) {
        const int other = work->partner[e];
        if (other > e) {
            taut_mirror_unite(&work->sets, 2 * (e / 4) + taut_edge_along(e),
                              2 * (other / 4) + taut_edge_along(other), work->reversed[e]);
        }
    }
    for (int d = 0; d < directions; d++) {
        int flip = 0;
        const int root = taut_mirror_root(&work->sets, d, &flip);
        const taut_status status = work->lines[root].count == 0 ? gather_line(work, root) : TAUT_OK;
        if (status != TAUT_OK) {
            return status;
        }
    }
    return TAUT_OK;
}

static taut_status halve_line(taut_thick_work *work, taut_thick_line *line, int *halved)
{
    const taut_thick_line old = *line;
    const size_t room = 2 * (size_t)old.count;
    int count = 0;
    line->breaks = taut_arena_take(work->arena, room, sizeof *line->breaks);
    line->times = taut_arena_take(work->arena, room, sizeof *line->times);
    line->halved = taut_arena_take(work->arena, room, 1);
    if (line->breaks == NULL || line->times == NULL || line->halved == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < old.count; k++) {
        line->breaks[count] = old.breaks[k];
        line->times[count++] = old.times[k];
        if (k + 1 < old.count && old.halved[k]) {
            line->breaks[count] = old.breaks[k] + (old.breaks[k + 1] - old.breaks[k]) / 2;
            line->times[count++] = 1;
            *halved += 1;
        }
    }
    line->count = count;
    return TAUT_OK;
}

taut_status taut_thick_halve_lines(taut_thick_work *work, int *halved, taut_error *error)
{
    *halved = 0;
    for (int d = 0; d < 2 * work->count; d++) {
        taut_thick_line *line = &work->lines[d];
        for (int k = 0; work->sets.both[d] && k + 1 < line->count; k++) {
            line->halved[k] |= line->halved[line->count - 2 - k];
            line->halved[line->count - 2 - k] |= line->halved[k];
        }
        if (line->count > 0 && halve_line(work, line, halved) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        if (line->count > BREAKS_MAX) {
            return taut_fail(error, TAUT_NO_SOLUTION, "too-many-points", NULL, line->count,
                             BREAKS_MAX,
                             "the sides of \"%.60s\" would have more than %d spans, as it bends "
                             "too sharply somewhere: ask for a larger --tolerance",
                             taut_surface_name(work->surfaces[d / 2]), BREAKS_MAX);
        }
    }
    return TAUT_OK;
}

int taut_thick_breaks_of(taut_thick_work *work, int direction, double *breaks)
{
    int flip = 0;
    const taut_thick_line *line = &work->lines[taut_mirror_root(&work->sets, direction, &flip)];
    for (int k = 0; breaks != NULL && k < line->count; k++) {
        breaks[k] = flip ? 1 - line->breaks[line->count - 1 - k] : line->breaks[k];
    }
    return line->count;
}

void taut_thick_mark(taut_thick_work *work, int direction, int k)
{
    int flip = 0;
    taut_thick_line *line = &work->lines[taut_mirror_root(&work->sets, direction, &flip)];
    line->halved[flip ? line->count - 2 - k : k] = 1;
}

taut_status taut_thick_basis(taut_thick_work *work, int direction, taut_basis **basis,
                             taut_error *error)
{
    int flip = 0, count = 0;
    const taut_thick_line *line = &work->lines[taut_mirror_root(&work->sets, direction, &flip)];
    double *knots =
        taut_arena_take(work->arena, (TAUT_THICK_DEGREE + 1) * (size_t)line->count, sizeof *knots);
    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < line->count; k++) {
        const int at = flip ? line->count - 1 - k : k, is_end = k == 0 || k + 1 == line->count;
        for (int i = 0; i < (is_end ? TAUT_THICK_DEGREE + 1 : line->times[at]); i++) {
            knots[count++] = flip ? 1 - line->breaks[at] : line->breaks[at];
        }
    }
    const taut_basis_spec spec = {
        .type = "bspline", .degree = TAUT_THICK_DEGREE, .knot_count = count, .knots = knots};
    return taut_basis_new(&spec, 0, basis, error);
}
