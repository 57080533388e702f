/* modes_lent.c -- in a page the last modes are kept for the next solve: a hand that drags moves points, and leaves the bases alone.
 * The module has no threads. What comes out is the same, as modes follow from the matrices alone.
 */
#include "numeric/modes_lent.h"

#include <stddef.h>

enum { POINTS_MOST = 256 }; /* of a direction whose modes are kept: 1 MB */

static struct {
    taut_band k, m;
    taut_modes *modes; /* or NULL */
    int borrowers;
} kept;

static void forget(void)
{
    taut_band_clear(&kept.k);
    taut_band_clear(&kept.m);
    taut_modes_free(kept.modes);
    kept.modes = NULL;
}

/* Keeps them where there is room and nobody uses the last. */
static void keep(const taut_band *k, const taut_band *m, taut_modes *modes)
{
    if (kept.borrowers > 0 || modes->n > POINTS_MOST) {
        return;
    }
    forget();
    if (taut_band_widen(k, k->width, &kept.k) == TAUT_OK &&
        taut_band_widen(m, m->width, &kept.m) == TAUT_OK) {
        kept.modes = modes;
        kept.borrowers = 1;
    } else {
        forget();
    }
}

taut_status taut_modes_lend(const taut_band *k, const taut_band *m, taut_pulse *pulse,
                            const taut_modes **modes)
{
    taut_modes *made = NULL;

    if (kept.modes != NULL && taut_band_equal(k, &kept.k) && taut_band_equal(m, &kept.m)) {
        kept.borrowers++;
        *modes = kept.modes;
        return TAUT_OK;
    }
    const taut_status status = taut_modes_new(k, m, pulse, &made);
    if (status == TAUT_OK) {
        keep(k, m, made);
        *modes = made;
    }
    return status;
}

void taut_modes_give_back(const taut_modes *modes)
{
    if (modes != NULL && modes == kept.modes) {
        kept.borrowers--;
    } else {
        taut_modes_free((taut_modes *)modes);
    }
}
