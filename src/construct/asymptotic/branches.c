#include "construct/asymptotic/branch.h"

#include "construct/asymptotic/corner_data.h"
#include "construct/asymptotic/family.h"
#include "construct/asymptotic/quartic.h"
#include "construct/asymptotic/starts.h"
#include "core/arena.h"
#include "core/fail.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Degree 4, and 5 for all above. */
static const taut_family *const families[] = {&taut_family_quartic, &taut_family_quintic};
static const int text_order[4] = {TAUT_ASYMPTOTIC_V0, TAUT_ASYMPTOTIC_V1, TAUT_ASYMPTOTIC_U0,
                                  TAUT_ASYMPTOTIC_U1};

void taut_branch_text(const int signs[4], char text[5])
{
    for (int k = 0; k < 4; k++) {
        const int sign = signs[text_order[k]];
        text[k] = sign > 0 ? '+' : sign < 0 ? '-' : '0';
    }
    text[4] = '\0';
}

double taut_quad_energy(const taut_curve_rule *rule, const taut_quad *quad)
{
    double energy = 0.0;
    for (int e = 0; e < 4; e++) {
        if (!quad->edges[e].straight) {
            energy += taut_curve_energy(rule, &quad->edges[e], NULL, NULL);
        }
    }
    return energy;
}

/* The signs that number `code` in 0..15 stands for, 0 on straight edges; 0 if a straight edge
 * would repeat a branch. */
static int signs_of(const taut_corner_data *data, int code, int signs[4])
{
    for (int e = 0; e < 4; e++) {
        const int positive = (code >> e & 1) == 0;
        signs[e] = data->edges[e].straight ? 0 : positive ? 1 : -1;
        if (data->edges[e].straight && !positive) {
            return 0;
        }
    }
    return 1;
}

/* Keeps the list in order of energy. */
static void insert_branch(taut_branches *branches, const taut_branch *branch)
{
    int at = branches->count++;
    for (; at > 0 && branches->list[at - 1].energy > branch->energy; at--) {
        branches->list[at] = branches->list[at - 1];
    }
    branches->list[at] = *branch;
}

/* The message when no branch has a minimum. */
static taut_status fail_none(const taut_corner_data *data, int allowed, double gap,
                             taut_error *error)
{
    assert(allowed > 0); /* of degree 4 taut_quartic_check_signs saw to it, of 5 all are */
    if (gap != 0.0) {
        return taut_closing_fail(data, gap, 1, error);
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, "no-minimum", "/edges", taut_none, taut_none,
                     "the curve energy has no minimum in any of the %d sign branches that the "
                     "corner data allows, from several starts each",
                     allowed);
}

static taut_status find_in_family(const taut_family *family, const taut_corner_data *data,
                                  void *room, double *work, const taut_monitor *monitor,
                                  taut_branches *branches, taut_error *error)
{
    taut_branch *const branch = &branches->list[TAUT_BRANCHES_MAX];
    taut_pulse pulse = {.monitor = monitor, .what = "branches"};
    int allowed = 0;
    double gap = INFINITY;
    const taut_status status = family->prepare(data, room, &branches->closing, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int code = 0; code < TAUT_BRANCHES_MAX; code++) {
        int signs[4];
        pulse.done = code / 32.0;
        taut_pulse_report(&pulse);
        if (!pulse.is_stopped && signs_of(data, code, signs) && family->allows(room, signs)) {
            allowed++;
            family->minimise(room, signs, work, &pulse, branch);
            gap = fabs(branch->gap) < fabs(gap) ? branch->gap : gap;
            branches->unknowns = branch->unknowns;
            if (branch->found) {
                insert_branch(branches, branch);
            }
        }
        if (pulse.is_stopped) {
            return taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                             "stopped");
        }
    }
    return branches->count > 0 ? TAUT_OK
                               : fail_none(data, allowed, isfinite(gap) ? gap : 0.0, error);
}

/* From degree 6 on the energy has no minimum: the ends can bend in ever shorter intervals, P_2 near
 * P_0, at ever less cost. What degree 5 gives is taken, raised. */
static void raise_branches(const taut_corner_data *data, taut_branches *branches)
{
    for (int k = 0; k < branches->count && data->raised > data->degree; k++) {
        taut_quad *const quad = &branches->list[k].quad;
        taut_quad_raise(quad, data->raised);
        for (int e = 0; e < 4; e++) {
            if (data->edges[e].straight) {
                taut_corner_straight(data, e, data->raised, &quad->edges[e]);
            }
        }
    }
}

static taut_status find_free(const taut_asymptotic_corners *corners, double rounding,
                             const taut_monitor *monitor, taut_arena *arena,
                             taut_branches *branches, taut_error *error)
{
    const taut_family *const family = families[corners->degree > 4];
    taut_corner_data *const data = taut_arena_take(arena, 1, sizeof *data);
    void *const room = taut_arena_take(arena, 1, family->size);
    double *const work = taut_arena_take(arena, TAUT_STARTS_WORK, sizeof *work);
    taut_status status = TAUT_OK;

    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = taut_corner_data_fill(corners, rounding, data, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = find_in_family(family, data, room, work, monitor, branches, error);
    raise_branches(data, branches);
    return status;
}

taut_status taut_branches_find(const taut_asymptotic_corners *corners, double rounding,
                               const taut_monitor *monitor, taut_branches *branches,
                               taut_error *error)
{
    taut_arena *arena = NULL;
    taut_status status = taut_corner_check(corners, error);

    branches->count = 0;
    branches->closing = TAUT_CLOSING_NONE;
    if (status != TAUT_OK || corners->degree == 3) {
        return status == TAUT_OK ? taut_cubic_find(corners, rounding, branches, error) : status;
    }
    arena = taut_arena_new();
    status = find_free(corners, rounding, monitor, arena, branches, error);
    taut_arena_free(arena);
    return status;
}

taut_status taut_branch_choose(const taut_asymptotic_corners *corners,
                               const taut_branches *branches, int *index, taut_error *error)
{
    char asked[5], found[5], list[6 * TAUT_BRANCHES_MAX + 1] = "";
    if (!corners->has_branch) {
        *index = 0;
        return TAUT_OK;
    }
    taut_branch_text(corners->branch, asked);
    for (int k = 0; k < branches->count; k++) {
        taut_branch_text(branches->list[k].signs, found);
        if (strcmp(asked, found) == 0) {
            *index = k;
            return TAUT_OK;
        }
        (void)snprintf(list + strlen(list), sizeof list - strlen(list), " %s", found);
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "no-branch", "/branch", taut_none, taut_none,
                     "there is no branch %s; those that exist:%s", asked, list);
}
