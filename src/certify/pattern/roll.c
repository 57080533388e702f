/* roll.c
 *
 * The lines to cut along as Bezier pieces, moved and turned to where details place them. Two of them are apart where a line across or
 * along the roll, or along the chord of one of them, is between their control points; halves where there is none. Lines all of whose
 * pieces are apart belong to pieces of cloth that lie beside each other, or one inside the other, which one place of each tells.
 * Residual: pieces that have no place, leave the roll, or are not proved apart from one before them (bound).
 */
#include "certify/pattern/roll.h"

#include "certify/pattern/arc.h"
#include "certify/pattern/worst.h"

#include <string.h>

enum { P = TAUT_CLOTH_ARC - 1, DEPTH = 20, CHORDS = 4 /* halvings */ };
/* Over the size: pieces may touch the border of the roll, and boxes each other. */
static const double rounding = 1e-12, border_room = 1e-9;

typedef struct placed {
    const taut_cloth_piece *piece;
    int count;
    taut_cloth_arc *arcs;
    double low[2], high[2]; /* of all control points */
} placed;

static taut_status place(const taut_cloth *cloth, const taut_cloth_piece *piece, taut_arena *arena,
                         placed *out)
{
    const taut_basis *basis = taut_curve_t(piece->cut);
    const double sign = piece->is_turned ? -1 : 1;

    *out = (placed){.piece = piece,
                    .count = taut_basis_span_count(basis),
                    .low = {INFINITY, INFINITY},
                    .high = {-INFINITY, -INFINITY}};
    out->arcs = taut_arena_take(arena, (size_t)out->count, sizeof *out->arcs);
    if (out->arcs == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < out->count; i++) {
        taut_cloth_arc *arc = &out->arcs[i];
        taut_cloth_arc_of(basis, i,
                          taut_curve_points(piece->cut) + 3 * (size_t)taut_basis_first(basis, i), 3,
                          arc->p);
        for (int k = 0; k < 2 * (P + 1); k++) {
            const int d = k % 2;
            double *x = &arc->p[k / 2][d];
            *x = ldexp(piece->at[d] + sign * *x, -cloth->unit);
            out->low[d] = fmin(out->low[d], *x);
            out->high[d] = fmax(out->high[d], *x);
        }
    }
    return TAUT_OK;
}

/* Is all of it from low to high in a direction of the plane? */
static int is_within(const taut_cloth_arc *a, int d, double low, double high, int depth)
{
    taut_cloth_arc halves[2];
    int all = 1;
    for (int k = 0; k <= P; k++) {
        all &= a->p[k][d] >= low && a->p[k][d] <= high;
    }
    if (all || depth == 0) {
        return all;
    }
    taut_cloth_arc_halve(a, &halves[0], &halves[1]);
    return is_within(&halves[0], d, low, high, depth - 1) &&
           is_within(&halves[1], d, low, high, depth - 1);
}

/* Is a line square to (x, y) between them, or along their borders? */
static int is_between(const taut_cloth_arc *a, const taut_cloth_arc *b, double x, double y,
                      double room)
{
    double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
    const taut_cloth_arc *both[2] = {a, b};
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i <= P; i++) {
            const double at = x * both[k]->p[i][0] + y * both[k]->p[i][1];
            lo[k] = fmin(lo[k], at);
            hi[k] = fmax(hi[k], at);
        }
    }
    return hi[0] <= lo[1] + room || hi[1] <= lo[0] + room;
}

static int is_apart(const taut_cloth_arc *a, const taut_cloth_arc *b, double room, int depth)
{
    taut_cloth_arc halves[2][2];
    if (is_between(a, b, 1, 0, room) || is_between(a, b, 0, 1, room) ||
        is_between(a, b, a->p[P][1] - a->p[0][1], a->p[0][0] - a->p[P][0], 0) ||
        is_between(a, b, b->p[P][1] - b->p[0][1], b->p[0][0] - b->p[P][0], 0)) {
        return 1;
    }
    if (depth == 0) {
        return 0;
    }
    taut_cloth_arc_halve(a, &halves[0][0], &halves[0][1]);
    taut_cloth_arc_halve(b, &halves[1][0], &halves[1][1]);
    for (int k = 0; k < 4; k++) {
        if (!is_apart(&halves[0][k / 2], &halves[1][k % 2], room, depth - 1)) {
            return 0;
        }
    }
    return 1;
}

/* How often a ray from a place along the roll crosses chords. */
static int crossings_of(const double at[2], const taut_cloth_arc *arc, int depth)
{
    taut_cloth_arc halves[2];
    const double *a = arc->p[0], *b = arc->p[P];
    if (depth > 0) {
        taut_cloth_arc_halve(arc, &halves[0], &halves[1]);
        return crossings_of(at, &halves[0], depth - 1) + crossings_of(at, &halves[1], depth - 1);
    }
    return (a[1] > at[1]) != (b[1] > at[1]) &&
           a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) > at[0];
}

/* Is a place inside a line that it is apart from? */
static int is_inside(const double at[2], const placed *around)
{
    int crossings = 0;
    for (int i = 0; i < around->count; i++) {
        crossings += crossings_of(at, &around->arcs[i], CHORDS);
    }
    return crossings % 2;
}

static int are_apart(const placed *a, const placed *b, double room)
{
    for (int d = 0; d < 2; d++) {
        if (a->high[d] <= b->low[d] + room || b->high[d] <= a->low[d] + room) {
            return 1;
        }
    }
    for (int i = 0; i < a->count; i++) {
        for (int k = 0; k < b->count; k++) {
            if (!is_apart(&a->arcs[i], &b->arcs[k], room, DEPTH)) {
                return 0;
            }
        }
    }
    return !is_inside(a->arcs[0].p[0], b) && !is_inside(b->arcs[0].p[0], a);
}

/* How far a piece reaches along the roll, by many places of the line that is cut. */
static double reach_along(const taut_cloth *cloth, const taut_cloth_piece *piece)
{
    enum { PLACES = 1024 };
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k <= PLACES; k++) {
        double y[1][3];
        taut_cloth_line(cloth, piece->cut, 4.0 * k / PLACES, 0, y);
        low = taut_certify_min(low, y[0][0]);
        high = taut_certify_max(high, y[0][0]);
    }
    return high - low;
}

taut_status taut_cloth_add_roll(const taut_cloth *cloth, taut_arena *arena,
                                taut_certificate *certificate)
{
    const taut_record *roll = taut_record_get(taut_model_details(cloth->model), "roll");
    const double told[2] = {taut_record_number(taut_record_get(roll, "length")),
                            taut_record_number(taut_record_get(roll, "width"))};
    const double size[2] = {ldexp(told[0], -cloth->unit), ldexp(told[1], -cloth->unit)};
    const double room = rounding * cloth->size, border = border_room * cloth->size;
    placed *all = taut_arena_take(arena, (size_t)cloth->piece_count + 1, sizeof *all);
    taut_worst w = {0, ""};

    if (all == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k];
        int is_wrong = !piece->is_placed;
        if (place(cloth, piece, arena, &all[k]) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        for (int i = 0; i < 2 * all[k].count; i++) {
            const int d = i % 2;
            is_wrong |= !is_within(&all[k].arcs[i / 2], d, -border, size[d] + border, DEPTH);
        }
        for (int i = 0; i < k; i++) {
            is_wrong |= !are_apart(&all[i], &all[k], room);
        }
        is_wrong |= piece->is_turned && cloth->problem != NULL && cloth->problem->cloth.has_nap;
        if (cloth->problem != NULL && cloth->problem->cloth.length > 0) {
            const double most = ldexp(cloth->problem->cloth.length, -cloth->unit);
            is_wrong |= !(reach_along(cloth, piece) <= most + border);
        }
        w.residual += is_wrong;
        if (is_wrong && w.where[0] == '\0') {
            snprintf(w.where, sizeof w.where, "%.40s", piece->name);
        }
    }
    if (cloth->problem != NULL && cloth->problem->cloth.width > 0) {
        w.residual += told[1] != cloth->problem->cloth.width;
    }
    return taut_worst_add(&w, "roll", TAUT_BOUND, 0, certificate);
}
