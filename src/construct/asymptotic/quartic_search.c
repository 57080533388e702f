/* quartic_search.c -- which unknowns a branch has, and where to start. */
#include "construct/asymptotic/quartic_search.h"

#include "construct/asymptotic/starts.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <string.h>

static const double noise_size = 1.0; /* of the starts, in logarithms */

static void plan_scales(taut_quartic_search *s)
{
    int seen[4] = {0};
    for (int e = 0; e < 4; e++) {
        s->root_of[e] = -1;
    }
    for (int root = 0; root < 4; root++) {
        int grew = 1;
        if (seen[root] || s->quartic->data->edges[root].straight) {
            continue;
        }
        seen[root] = 1;
        s->root_of[root] = s->count++;
        while (grew) {
            grew = 0;
            for (int c = 0; c < 4; c++) {
                const taut_quad_meeting *const m = taut_quad_corner[c];
                const int known = seen[m[0].edge] ? 0 : 1;
                if (s->quartic->linked[c] && seen[m[0].edge] != seen[m[1].edge]) {
                    s->links[s->link_count++] = (taut_quartic_link){
                        m[known].edge, m[known].end, m[1 - known].edge, m[1 - known].end};
                    seen[m[1 - known].edge] = 1;
                    grew = 1;
                }
            }
        }
    }
}

/* How far from constant nu / mu is: the edge that varies most is found by the closing condition. */
static double variation(const taut_quartic_line *line)
{
    const double size =
        (fabs(line->at[1]) + fabs(line->along[1])) * (fabs(line->at[2]) + fabs(line->along[2]));
    return line->same_ratio
               ? 0.0
               : fabs(line->at[1] * line->along[2] - line->at[2] * line->along[1]) / size;
}

void taut_quartic_plan(const taut_quartic *quartic, const int signs[4], taut_quartic_search *s)
{
    memset(s, 0, sizeof *s);
    s->quartic = quartic;
    s->signs = signs;
    s->closer = -1;
    s->quad.degree = 4;
    for (int e = 0; e < 4 && quartic->closing == TAUT_CLOSING_CONSTRAINT; e++) {
        if (variation(&quartic->lines[e]) > 0 &&
            (s->closer < 0 ||
             variation(&quartic->lines[e]) > variation(&quartic->lines[s->closer]))) {
            s->closer = e;
        }
    }
    for (int e = 0; e < 4; e++) {
        const taut_quartic_line *const line = &quartic->lines[e];
        s->variable[e] = -1;
        if (quartic->data->edges[e].straight) {
            taut_corner_straight(quartic->data, e, 4, &s->quad.edges[e]);
            continue;
        }
        (void)taut_quartic_interval(line, signs[e], s->range[e]);
        s->kind[e] = line->along[1] != 0.0   ? TAUT_BY_MU
                     : line->along[2] != 0.0 ? TAUT_BY_NU
                                             : TAUT_BY_P;
        if (e != s->closer) {
            s->variable[e] = s->count++;
        }
    }
    plan_scales(s);
}

static double unknown_of_p(const taut_quartic_search *s, int e, double p)
{
    const taut_quartic_line *const line = &s->quartic->lines[e];
    const int k = s->kind[e];
    return k == TAUT_BY_P ? p : taut_log(fabs(line->at[k] + p * line->along[k]));
}

/* A p inside the interval: the mean of those that make the side weights near the geometric means
 * of their neighbours, |mu| = k |a|^3 / (3/4 |n|), else a point well inside. */
static double first_p(const taut_quartic_search *s, int e)
{
    const taut_quartic_line *const line = &s->quartic->lines[e];
    const taut_corner_edge *const edge = &s->quartic->data->edges[e];
    const double *const range = s->range[e];
    double sum = 0.0;
    int count = 0;
    for (int k = 1; k <= 2; k++) {
        const double guess = taut_exp(taut_log(edge->weight[k - 1]) - edge->bend[k - 1]);
        const double p = (s->signs[e] * guess - line->at[k]) / line->along[k];
        if (line->along[k] != 0.0 && p > range[0] && p < range[1]) {
            sum += p;
            count++;
        }
    }
    if (count > 0) {
        return sum / count;
    }
    if (isfinite(range[0]) && isfinite(range[1])) {
        return 0.5 * (range[0] + range[1]);
    }
    if (isfinite(range[0])) {
        return range[0] + 1.0 + fabs(range[0]);
    }
    return isfinite(range[1]) ? range[1] - 1.0 - fabs(range[1]) : 0.0;
}

/* Moves p inside the interval by noise on its unknown; stays where the noise leads outside. */
static double disturb(const taut_quartic_search *s, int e, double p, uint64_t *noise)
{
    const double step = noise_size * taut_noise(noise);
    const double moved = taut_quartic_p_of(s, e, unknown_of_p(s, e, p) + step);
    return moved > s->range[e][0] && moved < s->range[e][1] ? moved : p;
}

/* Shifts the ratios nu / mu of the edges together until the closing condition holds; 0 if even
 * the ends of their ranges do not reach it. */
static int close_start(const taut_quartic_search *s, double p[4])
{
    const int *const sign = s->quartic->closing_signs;
    const double reach = 12.0; /* beyond e^12 a shape is no start */
    double from[4], to[4], sum = s->quartic->closing_constant, low = 0.0, high = 1.0;
    for (int e = 0; e < 4; e++) {
        const taut_quartic_line *const line = &s->quartic->lines[e];
        from[e] =
            taut_log((line->at[2] + p[e] * line->along[2]) / (line->at[1] + p[e] * line->along[1]));
        sum += 2 * sign[e] * from[e];
    }
    for (int e = 0; e < 4; e++) {
        double ratios[2];
        to[e] = from[e];
        if (!s->quartic->lines[e].same_ratio) {
            taut_quartic_ratios(&s->quartic->lines[e], s->range[e], ratios);
            to[e] = sign[e] * sum > 0 ? fmax(ratios[0], from[e] - reach)
                                      : fmin(ratios[1], from[e] + reach);
        }
    }
    for (int step = 0; step < 60; step++) {
        const double t = 0.5 * (low + high);
        double total = s->quartic->closing_constant;
        for (int e = 0; e < 4; e++) {
            total += 2 * sign[e] * ((1.0 - t) * from[e] + t * to[e]);
        }
        if (total * sum > 0) {
            low = t;
        } else {
            high = t;
        }
    }
    for (int e = 0; e < 4 && high < 1.0; e++) {
        if (to[e] != from[e]) {
            p[e] = taut_quartic_p_of_ratio(&s->quartic->lines[e],
                                           taut_exp((1.0 - high) * from[e] + high * to[e]));
        }
    }
    return high < 1.0;
}

/* A start: number 0 is the plain guess, the others disturb it. */
int taut_quartic_start(void *search, int number, uint64_t *noise, double *x)
{
    const taut_quartic_search *const s = search;
    double p[4] = {0}, mean = 0.0;
    taut_quartic_state at[4];
    int edges = 0;
    memset(at, 0, sizeof at);
    for (int e = 0; e < 4; e++) {
        if (!s->quartic->data->edges[e].straight) {
            p[e] = first_p(s, e);
            p[e] = number > 0 ? disturb(s, e, p[e], noise) : p[e];
        }
    }
    if (s->closer >= 0 && !close_start(s, p)) {
        return 0;
    }
    for (int e = 0; e < 4; e++) {
        if (s->variable[e] >= 0) {
            x[s->variable[e]] = unknown_of_p(s, e, p[e]);
        }
        if (s->root_of[e] >= 0) {
            x[s->root_of[e]] = number > 0 ? noise_size * taut_noise(noise) : 0.0;
        }
    }
    if (!taut_quartic_forwards(s, x, at)) {
        return 0;
    }
    for (int e = 0; e < 4; e++) {
        mean += at[e].log_w2;
        edges += !s->quartic->data->edges[e].straight;
    }
    for (int e = 0; e < 4; e++) {
        if (s->root_of[e] >= 0) {
            x[s->root_of[e]] -= mean / edges; /* middle weights about 1 */
        }
    }
    return 1;
}

/* By how much the closing condition stays out of reach in this branch; 0 if it does not. */
double taut_quartic_gap(const taut_quartic_search *s)
{
    const int *const sign = s->quartic->closing_signs;
    double low = s->quartic->closing_constant, high = low;
    for (int e = 0; e < 4 && s->closer >= 0; e++) {
        double ratios[2];
        taut_quartic_ratios(&s->quartic->lines[e], s->range[e], ratios);
        low += 2 * sign[e] * ratios[sign[e] > 0 ? 0 : 1];
        high += 2 * sign[e] * ratios[sign[e] > 0 ? 1 : 0];
    }
    return s->closer < 0 ? 0.0 : low > 0 ? low : high < 0 ? high : 0.0;
}
