#include "construct/film/rounds.h"

#include "core/fail.h"

#include <math.h>

static const double rate_first = 1.0 / 16, rate_slowest = 0.25, rate_fastest = 1e-3;

/* Where the energies of so many rounds seem to end. */
static double limit_of(const taut_film_stage *rounds, int count)
{
    double rate = rate_first;

    if (count < 2) {
        return taut_none;
    }
    const double last = rounds[count - 2].energy - rounds[count - 1].energy;
    if (count > 2 && rounds[count - 3].energy != rounds[count - 2].energy) {
        rate = fabs(last / (rounds[count - 3].energy - rounds[count - 2].energy));
        rate = fmin(rate_slowest, fmax(rate_fastest, rate));
    }
    return rounds[count - 1].energy - fabs(last) * rate / (1 - rate);
}

void taut_film_refinement(const taut_film_stage *rounds, int count, taut_record *details)
{
    taut_record *refinement = taut_record_add_object(details, "refinement");
    taut_record *list = taut_record_add_list(refinement, "rounds");
    const double limit = limit_of(rounds, count);

    for (int k = 0; k < count; k++) {
        taut_record *one = taut_record_add_object(list, NULL);
        taut_record_add_numbers(one, "points", rounds[k].sizes, rounds[k].points);
        taut_record_add_number(one, "energy", rounds[k].energy);
    }
    taut_record_add_number(refinement, "estimated_least_energy", limit);
    taut_record_add_number(refinement, "estimated_gap", rounds[0].energy / limit - 1);
}
