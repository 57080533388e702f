/* quartic_minimise.c -- Algorithm 1 for degree 4 as a family: the least energy in each branch. */
#include "construct/asymptotic/family.h"
#include "construct/asymptotic/quartic_search.h"
#include "construct/asymptotic/starts.h"

#include <string.h>

static void minimise(const void *room, const int signs[4], double *work, taut_pulse *pulse,
                     taut_branch *branch)
{
    const taut_quartic *const quartic = room;
    taut_quartic_search s;
    taut_start_plan plan = {.starts = 8, .objective = taut_quartic_objective};
    double x[TAUT_MINIMISE_MAX];
    taut_quartic_plan(quartic, signs, &s);
    plan.count = s.count;
    plan.start = taut_quartic_start;
    plan.context = &s;
    plan.work = work;
    plan.pulse = pulse;
    plan.rule = &s.rule;
    plan.coarse = &quartic->data->coarse;
    plan.fine = &quartic->data->fine;
    memcpy(branch->signs, signs, sizeof branch->signs);
    branch->gap = taut_quartic_gap(&s);
    branch->found = branch->gap == 0.0 && taut_starts_run(&plan, x, &branch->energy);
    branch->unknowns = s.count;
    branch->quad = s.quad;
}

static taut_status prepare(const taut_corner_data *data, void *room, taut_closing *closing,
                           taut_error *error)
{
    taut_quartic *const quartic = room;
    const taut_status status = taut_quartic_fill(data, quartic, error);
    *closing = quartic->closing;
    return status;
}

static int allows(const void *room, const int signs[4])
{
    return taut_quartic_allows(room, signs);
}

const taut_family taut_family_quartic = {sizeof(taut_quartic), prepare, allows, minimise};
