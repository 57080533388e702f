#include "construct/pattern/strains.h"

#include <math.h>

enum { PARTS = 4 /* of a span */ };
/* Operations, about, of a place. */
static const double work_of_place = 3e3;

static void widen(double range[2], double x)
{
    range[0] = fmin(range[0], x);
    range[1] = fmax(range[1], x);
}

taut_pattern_strains taut_pattern_strains_of(const taut_pattern_piece *piece, taut_pulse *pulse)
{
    const taut_flat *flat = &piece->flat;
    const int count[2] = {PARTS * flat->spans[0], PARTS * flat->spans[1]};
    taut_pattern_strains all = {.low = INFINITY,
                                .high = -INFINITY,
                                .warp = {INFINITY, -INFINITY},
                                .weft = {INFINITY, -INFINITY}};
    taut_pattern_kept kept = {.s = NAN};
    const taut_pattern_across across = {piece, &kept};
    double most = -1;
    /* at a point there is no strain */
    const int first = piece->bounds[TAUT_FLAT_START].is_point;
    const int last = count[0] - piece->bounds[TAUT_FLAT_END].is_point;
    for (int i = first; i <= last && !taut_pulse_beat(pulse, count[1] * work_of_place); i++) {
        for (int k = 0; k <= count[1]; k++) {
            const double s = (double)i / count[0], t = (double)k / count[1];
            double g[3], y[3][2], shrink[2], strain[2], cloth[3];
            taut_pattern_across_metric(&across, s, t, g);
            taut_pattern_piece_shrink(piece, s, t, shrink);
            taut_flat_at(flat, s, t, y);
            taut_flat_strain(shrink, g, (const double(*)[2])y, strain, cloth);
            if (!all.is_folded && y[1][0] * y[2][1] - y[1][1] * y[2][0] <= 0) {
                all.is_folded = 1;
                all.fold[0] = s;
                all.fold[1] = t;
            }
            if (strain[1] < all.low) {
                all.low = strain[1];
                all.at_low[0] = s;
                all.at_low[1] = t;
            }
            all.high = fmax(all.high, strain[0]);
            widen(all.warp, cloth[0]);
            widen(all.weft, cloth[1]);
            all.shear = fmax(all.shear, fabs(cloth[2]));
            const double larger = fmax(fabs(strain[0]), fabs(strain[1]));
            if (larger > most) {
                most = larger;
                all.at[0] = s;
                all.at[1] = t;
            }
        }
    }
    return all;
}
