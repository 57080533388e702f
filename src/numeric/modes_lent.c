/* modes_lent.c -- new ones every time: threads share nothing. */
#include "numeric/modes_lent.h"

taut_status taut_modes_lend(const taut_band *k, const taut_band *m, taut_pulse *pulse,
                            const taut_modes **modes)
{
    taut_modes *made = NULL;
    const taut_status status = taut_modes_new(k, m, pulse, &made);

    if (status == TAUT_OK) {
        *modes = made;
    }
    return status;
}

void taut_modes_give_back(const taut_modes *modes)
{
    taut_modes_free((taut_modes *)modes); /* as it was made above */
}
