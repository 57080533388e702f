/* quintic.c -- Algorithm 1 for degree 5 as a family: which unknowns a branch has, where to start,
 * the least energy. Docs page section 4.4. */
#include "construct/asymptotic/family.h"
#include "construct/asymptotic/quintic_search.h"
#include "construct/asymptotic/starts.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <string.h>

enum { DRAWS_MAX = 200 };

void taut_quintic_plan(const taut_corner_data *data, const int signs[4], taut_quintic_search *s)
{
    memset(s, 0, sizeof *s);
    s->data = data;
    s->signs = signs;
    s->quad.degree = TAUT_QUINTIC;
    for (int e = 0; e < 4; e++) {
        s->first[e] = -1;
        if (data->edges[e].straight) {
            taut_corner_straight(data, e, TAUT_QUINTIC, &s->quad.edges[e]);
            continue;
        }
        for (int k = 0; k < 2; k++) {
            const taut_corner_edge *const edge = &data->edges[e];
            s->fixed[e][k] = taut_log((TAUT_QUINTIC - 2.0) / TAUT_QUINTIC * edge->weight[k]) -
                             2 * taut_log(taut_norm(edge->normal[k])) - 0.5 * edge->bend[k];
        }
        s->first[e] = s->count;
        s->count += TAUT_QUINTIC_OWN;
    }
    for (int c = 0; c < 4; c++) {
        const int shared = s->count;
        for (int k = 0; k < 2; k++) {
            const taut_quad_meeting *const m = &taut_quad_corner[c][k];
            if (s->first[m->edge] >= 0) {
                s->theta[m->edge][m->end] = shared;
                s->count = shared + 1;
            }
        }
    }
}

/* Signs of the torsions' numerators as they are; 0 unless torsions are opposite at every corner
 * where two curved edges meet. */
static int set_signs(taut_quintic_search *s, const double *x)
{
    for (int e = 0; e < 4; e++) {
        for (int k = 0; k < 2 && s->first[e] >= 0; k++) {
            taut_quintic_points(s, e, x + s->first[e], &s->quad.edges[e]);
            s->torsion_sign[e][k] = taut_quintic_numerator(s, e, k, &s->quad.edges[e]) > 0 ? 1 : -1;
        }
    }
    for (int c = 0; c < 4; c++) {
        const taut_quad_meeting *const m = taut_quad_corner[c];
        int product = 1;
        for (int k = 0; k < 2; k++) {
            product *= s->signs[m[k].edge] * s->torsion_sign[m[k].edge][m[k].end] *
                       (m[k].end == 0 ? 1 : -1);
        }
        if (product > 0) {
            return 0;
        }
    }
    return 1;
}

/* The guess for an edge's own unknowns, disturbed by noise of the given size: a guess as
 * for evenly spaced points, side weights near the geometric means of their neighbours. */
static void guess_edge(const taut_quintic_search *s, int e, double size, uint64_t *noise, double *y)
{
    const taut_corner_edge *const edge = &s->data->edges[e];
    const double raise = 2 * taut_log((double)s->data->raised / TAUT_QUINTIC);
    y[TAUT_QUINTIC_LAMBDA] = 2.0 + size * taut_noise(noise);
    y[TAUT_QUINTIC_RHO] = -2.0 + size * taut_noise(noise);
    y[TAUT_QUINTIC_LOG_MU] =
        taut_log(edge->weight[0]) - edge->bend[0] + raise + size * taut_noise(noise);
    y[TAUT_QUINTIC_LOG_NU] =
        taut_log(edge->weight[1]) - edge->bend[1] + raise + size * taut_noise(noise);
}

/* Torsions begin as the mean of what weights of 1 give the two edges of a corner. */
int taut_quintic_start(void *context, int number, uint64_t *noise, double *x)
{
    taut_quintic_search *const s = context;
    int ends[4] = {0};
    int fits = 0;
    for (int draw = 0; draw < DRAWS_MAX && !fits; draw++) {
        const double size = number == 0 && draw == 0 ? 0.0 : 0.4 + 0.01 * draw;
        for (int e = 0; e < 4; e++) {
            if (s->first[e] >= 0) {
                guess_edge(s, e, size, noise, x + s->first[e]);
            }
        }
        fits = set_signs(s, x);
    }
    for (int c = 0; c < 4 && fits; c++) {
        double sum = 0.0;
        int place = -1;
        for (int k = 0; k < 2; k++) {
            const taut_quad_meeting *const m = &taut_quad_corner[c][k];
            if (s->first[m->edge] >= 0) {
                place = s->theta[m->edge][m->end];
                sum += taut_quintic_rest(
                    s, m->edge, m->end, x + s->first[m->edge],
                    taut_quintic_numerator(s, m->edge, m->end, &s->quad.edges[m->edge]));
                ends[c]++;
            }
        }
        if (place >= 0) {
            x[place] = sum / ends[c];
        }
    }
    return fits;
}

static void fix_signs(void *context, const double *x)
{
    (void)set_signs(context, x);
}

static taut_status prepare(const taut_corner_data *data, void *room, taut_closing *closing,
                           taut_error *error)
{
    const taut_corner_data **const kept = room;
    (void)error;
    *closing = TAUT_CLOSING_NONE;
    *kept = data;
    return TAUT_OK;
}

/* The torsions' signs are as free as P_3 is: every choice may have a minimum. */
static int allows(const void *room, const int signs[4])
{
    (void)room;
    (void)signs;
    return 1;
}

static void minimise(const void *room, const int signs[4], double *work, taut_pulse *pulse,
                     taut_branch *branch)
{
    const taut_corner_data *const data = *(const taut_corner_data *const *)room;
    taut_quintic_search s;
    taut_start_plan plan = {.starts = 6,
                            .objective = taut_quintic_objective,
                            .hessian = taut_quintic_hessian,
                            .start = taut_quintic_start,
                            .begin = fix_signs};
    double x[TAUT_MINIMISE_MAX];
    taut_quintic_plan(data, signs, &s);
    plan.count = s.count;
    plan.context = &s;
    plan.work = work;
    plan.pulse = pulse;
    plan.rule = &s.rule;
    plan.coarse = &data->coarse;
    plan.fine = &data->fine;
    memcpy(branch->signs, signs, sizeof branch->signs);
    branch->gap = 0.0;
    branch->found = taut_starts_run(&plan, x, &branch->energy);
    branch->unknowns = s.count;
    branch->quad = s.quad;
}

const taut_family taut_family_quintic = {sizeof(const taut_corner_data *), prepare, allows,
                                         minimise};
