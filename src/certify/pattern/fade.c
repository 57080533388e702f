/* fade.c
 *
 * Near edges that do not yield warp and weft are cut smaller by c (3 x^2 - 2 x^3), x = min(1, distance in space / length), the distance to
 * the nearest of the edge's places by halving where it begins to grow.
 */
#include "certify/pattern/fade.h"

#include "certify/common/verdict.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <string.h>

enum { ROUNDS = 50 };

static void place_on(const taut_cloth_fade *fade, double share, int order, double x[3][3])
{
    const taut_basis *bases[2] = {taut_surface_u(fade->on), taut_surface_v(fade->on)};
    const int held = fade->edge / 2;
    const double lo = taut_basis_lo(bases[1 - held]), hi = taut_basis_hi(bases[1 - held]);
    double at[2];
    at[held] = fade->edge % 2 == 0 ? taut_basis_lo(bases[held]) : taut_basis_hi(bases[held]);
    at[1 - held] = fmin(lo + share * (hi - lo), hi);
    taut_surface_eval(fade->on, at[0], at[1], order, x[0]);
}

/* Do pieces of the surface start or end on the edge? */
static int is_across(const taut_cloth *cloth, const taut_surface *on, int edge)
{
    for (int k = 0; k < cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k];
        if (piece->on == on &&
            (piece->border[TAUT_CLOTH_START] == edge || piece->border[TAUT_CLOTH_END] == edge)) {
            return 1;
        }
    }
    return 0;
}

static taut_status add_fade(taut_cloth *cloth, const taut_surface *on, int edge, double length,
                            int is_both, taut_arena *arena)
{
    /* the angle from the edge to the warp, from 0 along it */
    const double turn =
        fabs(is_across(cloth, on, edge) ? taut_cos(cloth->thread) : taut_sin(cloth->thread));
    const double other =
        fabs(is_across(cloth, on, edge) ? taut_sin(cloth->thread) : taut_cos(cloth->thread));
    const int is_weft = is_across(cloth, on, edge) ? turn >= other : turn > other;
    taut_cloth_fade *fade = &cloth->fades[cloth->fade_count++];
    *fade = (taut_cloth_fade){
        .on = on,
        .edge = edge,
        .is_faded = {is_both || !is_weft, is_both || is_weft},
        .length = ldexp(length, -cloth->unit),
        .places = taut_arena_take(arena, TAUT_CLOTH_PLACES + 1, sizeof *fade->places)};
    for (int k = 0; fade->places != NULL && k <= TAUT_CLOTH_PLACES; k++) {
        place_on(fade, (double)k / TAUT_CLOTH_PLACES, 0, fade->places + k);
    }
    return fade->places != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}

/* The edge of this name; -1. */
static int edge_named(const char *name)
{
    static const char *const names[] = {"u0", "u1", "v0", "v1"};
    for (int e = 0; e < 4; e++) {
        if (strcmp(name, names[e]) == 0) {
            return e;
        }
    }
    return -1;
}

taut_status taut_cloth_read_fades(taut_cloth *cloth, taut_arena *arena)
{
    enum { EDGES = 4 };
    const taut_record *told = taut_record_get(taut_model_details(cloth->model), "decompensate");
    const int count =
        cloth->problem != NULL ? cloth->problem->decompensate_count : (int)taut_record_count(told);
    const int most = count < EDGES ? count : EDGES;
    cloth->fades =
        taut_arena_take(arena, (size_t)(most * cloth->surface_count) + 1, sizeof *cloth->fades);
    taut_status status = cloth->fades != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    for (int k = 0; k < most * cloth->surface_count && status == TAUT_OK; k++) {
        const taut_record *one = taut_record_at(told, (size_t)(k % most));
        const taut_pattern_decompensate *asked =
            cloth->problem != NULL ? &cloth->problem->decompensate[k % most] : NULL;
        const int edge = asked != NULL ? (int)asked->edge
                                       : edge_named(taut_record_text(taut_record_get(one, "edge")));
        const double length =
            asked != NULL ? asked->length : taut_record_number(taut_record_get(one, "length"));
        const int is_both =
            asked != NULL
                ? asked->component == TAUT_PATTERN_COMPONENT_BOTH
                : strcmp(taut_record_text(taut_record_get(one, "component")), "both") == 0;
        if (edge >= 0 && length > 0) {
            status = add_fade(cloth, cloth->surfaces[k / most], edge, length, is_both, arena);
        }
    }
    return status;
}

static double distance_to(const taut_cloth_fade *fade, const double x[3])
{
    double y[3][3], away[3], least = INFINITY;
    int nearest = 0;
    for (int k = 0; k <= TAUT_CLOTH_PLACES; k++) {
        const double here = taut_distance(fade->places[k], x);
        nearest = here < least ? k : nearest;
        least = here < least ? here : least;
    }
    double low = (nearest > 0 ? nearest - 1.0 : 0.0) / TAUT_CLOTH_PLACES;
    double high = (nearest < TAUT_CLOTH_PLACES ? nearest + 1.0 : nearest) / TAUT_CLOTH_PLACES;
    for (int round = 0; round < ROUNDS; round++) {
        const double middle = (low + high) / 2;
        place_on(fade, middle, 1, y);
        taut_difference(y[0], x, away);
        least = taut_certify_min(least, taut_norm(away));
        *(taut_dot(away, y[2 - fade->edge / 2]) < 0 ? &low : &high) = middle;
    }
    return least;
}

/* What is left of the compensation of warp and weft where the place is `w` of the window. */
static void lefts_at(const taut_cloth *cloth, const taut_cloth_piece *piece, const double w[2],
                     double left[2])
{
    double x[3] = {0, 0, 0};
    left[0] = left[1] = 1;
    if (cloth->fade_count > 0) {
        taut_surface_eval(piece->on, w[0], w[1], 0, x);
    }
    for (int k = 0; k < cloth->fade_count; k++) {
        const taut_cloth_fade *fade = &cloth->fades[k];
        const double z = fade->on == piece->on ? distance_to(fade, x) / fade->length : 1;
        for (int d = 0; d < 2; d++) {
            left[d] *= fade->is_faded[d] && z < 1 ? 3 * z * z - 2 * z * z * z : 1;
        }
    }
}

void taut_cloth_shrink(const taut_cloth *cloth, const taut_cloth_piece *piece, const double w[2],
                       double shrink[2])
{
    double left[2];
    lefts_at(cloth, piece, w, left);
    shrink[0] = 1 - cloth->warp * left[0];
    shrink[1] = 1 - cloth->weft * left[1];
}

double taut_cloth_left(const taut_cloth *cloth, const taut_cloth_piece *piece, int edge,
                       const double w[2])
{
    const int is_across = edge == TAUT_CLOTH_START || edge == TAUT_CLOTH_END;
    /* the angle from the edge to the warp */
    const double turn = fabs(is_across ? taut_sin(cloth->thread) : taut_cos(cloth->thread));
    const double other = fabs(is_across ? taut_cos(cloth->thread) : taut_sin(cloth->thread));
    const int is_weft = is_across ? other >= turn : other > turn;
    double left[2];
    lefts_at(cloth, piece, w, left);
    return left[is_weft];
}
