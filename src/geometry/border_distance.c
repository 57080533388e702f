#include "geometry/border_distance.h"

#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { ROUNDS = 40 };
/* Of the edge's range: a step that is none. */
static const double no_step = 1e-15;

/* The place of the edge at a share of its range, and its derivatives by the parameter up to `order`, at most 2. */
static void edge_at(const taut_border *border, double share, int order, double x[3][3])
{
    const taut_basis *bases[2] = {taut_surface_u(border->surface), taut_surface_v(border->surface)};
    const int held = border->edge / 2, along = 1 - held;
    const double lo = taut_basis_lo(bases[along]), hi = taut_basis_hi(bases[along]);
    double at[2], all[6][3];

    at[held] = border->edge % 2 == 0 ? taut_basis_lo(bases[held]) : taut_basis_hi(bases[held]);
    at[along] = share < 1 ? lo + share * (hi - lo) : hi;
    taut_surface_eval(border->surface, at[0], at[1], order, all[0]);
    for (int c = 0; c < 3; c++) {
        x[0][c] = all[0][c];
        if (order == 2) {
            x[1][c] = all[1 + along][c] * (hi - lo);
            x[2][c] = all[along == 0 ? 3 : 5][c] * (hi - lo) * (hi - lo);
        }
    }
}

taut_status taut_border_new(taut_arena *arena, const taut_surface *surface, int edge,
                            taut_border *border)
{
    *border = (taut_border){surface, edge,
                            taut_arena_take(arena, TAUT_BORDER_CELLS + 1, sizeof *border->places)};
    for (int k = 0; border->places != NULL && k <= TAUT_BORDER_CELLS; k++) {
        edge_at(border, (double)k / TAUT_BORDER_CELLS, 0, border->places + k);
    }
    return border->places != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}

double taut_border_distance(const taut_border *border, const double x[3])
{
    double place[3];
    return taut_border_nearest(border, x, place);
}

double taut_border_nearest(const taut_border *border, const double x[3], double place[3])
{
    int nearest = 0;
    for (int k = 1; k <= TAUT_BORDER_CELLS; k++) {
        nearest = taut_length_between(border->places[k], x) <
                          taut_length_between(border->places[nearest], x)
                      ? k
                      : nearest;
    }
    double low = fmax(nearest - 1, 0) / TAUT_BORDER_CELLS;
    double high = fmin(nearest + 1, TAUT_BORDER_CELLS) / TAUT_BORDER_CELLS;
    double share = (double)nearest / TAUT_BORDER_CELLS,
           best = taut_length_between(border->places[nearest], x);
    memcpy(place, border->places[nearest], sizeof border->places[nearest]);
    /* the distance falls where `slope` is below 0 */
    for (int round = 0; round < ROUNDS && high - low > no_step; round++) {
        double y[3][3], away[3];
        edge_at(border, share, 2, y);
        taut_difference(y[0], x, away);
        if (taut_norm(away) < best) {
            best = taut_norm(away);
            memcpy(place, y[0], sizeof y[0]);
        }
        const double slope = taut_dot(away, y[1]);
        const double bend = taut_dot(y[1], y[1]) + taut_dot(away, y[2]);
        *(slope < 0 ? &low : &high) = share;
        const double next = share - slope / bend;
        const double at = bend > 0 && next > low && next < high ? next : (low + high) / 2;
        if (slope == 0 || fabs(at - share) <= no_step) {
            break;
        }
        share = at;
    }
    return best;
}
