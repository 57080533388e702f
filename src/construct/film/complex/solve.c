/* solve.c -- Newton's method in all coordinates, between the metric operator and the Hessian.
 *
 *     theta = 1
 *     until the free derivatives are below the aim, or no step lowers energy or derivatives any more:
 *         d, p by the border (border.h), of B(theta);  theta is raised eightfold while B leads down where volumes stay
 *         d is cut to a share of the size
 *         taken where phi falls by a tenth of what d promises, or, where that is lost in rounding, the derivatives
 *         get less; then theta / 8, else theta * 8, and at theta = 1 half of d
 *     the same in the moves that are seen alone (ways.h), once a step promises little: there it converges to rounding
 *         (by the method `normal` once it promises 1e-8 of E, or 1e-4 where that folds the net, with theta held at 1e-3 before,
 *         and in all coordinates no more; where all coordinates fold the net that method follows by itself)
 *     both with more Gauss nodes, until these leave the derivatives below the aim
 *
 *     phi = E - sum p_c (V_c - V_c0) + mu / 2 sum (V_c - V_c0)^2        with the step's p
 *
 * At theta = 1 every step without pressure lowers E: L is above H (construct/plateau/area.h). Moves within the sheets, which E
 * does not see, are held back by theta alone. Pivots that lead down where it is at rest are a saddle.
 *
 * A pressure that leads to no film is followed from 0, by halved steps, to name the last one that a film was found for. So are two
 * rims (parting.h) led apart from where there is a film between them, and cables weakened from where they are strong enough
 * (strength.h): by rungs of a ladder until the start leads to a film, and from there to the forces that are asked for.
 *
 * What is stationary and no minimum is found from a start, or from films of given volumes, by steps of the Hessian alone, cut by halves
 * until derivatives get less. Films under pressures that no minimum has are often minima of given volumes: V is changed to
 * V (p / p_given)^3, as of balls, and then by the secant of the logarithms, until it leads to that pressure nearly. Nets that are
 * rough do not come to rest by such steps, so it is met as a minimum too, by dV = S (p_given - p), S = dV/dp of the border.
 */
#include "construct/film/complex/solve.h"

#include "construct/film/complex/border.h"
#include "construct/film/complex/energy.h"
#include "construct/film/complex/even.h"
#include "construct/film/complex/parting.h"
#include "construct/film/complex/pressure.h"
#include "construct/film/complex/strength.h"
#include "construct/film/complex/turned.h"
#include "construct/film/meeting.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { RULES = 5, ITERATIONS = 200, STALLS = 4, HALVINGS = 6, LED = 100 };
static const int extra_nodes[RULES] = {2, 4, 8, 15, 27};
static const double tolerance_search =
    1e-8; /* farther from rest rules do not agree on the energy */
static const double theta_least = 1e-9;
static const double theta_rounding =
    1e-6; /* where energies tell nothing any more: moves within sheets are let be */
static const double longest_step = 0.15; /* of the size, which scaled is between 1 and 2 */
static const double fold = 0.02; /* least area element over its mean, or over what it began with */
static const double share_promised = 0.1, rounding = 1e-13;
static const double aim_share = 0.1; /* of the tolerance */
static const double gain_least = 1e-11,
                    residual_all = 3e-7; /* of E; of all coordinates: their end */
static const double
    gains_normal[2] = {1e-8, 1e-4},
    theta_normal =
        1e-3; /* of the method `normal`: its ends of all coordinates, first and where that folds the net, its least theta there */
static const double unsettled = 100; /* times the aim: what the last rule may find */
static const double blown = 10,
                    blown_led = 4; /* times the size; on the way of pressures that are led */
static const double gain_soft = 1e-5,
                    theta_hard = 1e-3; /* where soft cables end, and theta where they are hard */
static const double led_least =
    0x1p-11; /* the least step of pressures that are led; of twice the last one found, where that is less */
static const double led_near = 1e-6;       /* the residual of a film on the way */
static const double apart_least = 0x1p-15; /* of rims, in their distance */
static const double neck_most =
    0.9; /* of the shorter side at the start: else it is the net that folds */
static const double weaker_least = 0x1p-10; /* of the logarithm of all forces */
static const double above_told = 1.1;       /* times what is told: a film is there too */
static const double stiff_slack = 20; /* times force over length: of springs in place of lengths */
static const double soft_most =
    0.1; /* the lowest eigenvalue of H by L, of a film near its end: a catenoid's is 0.15 at 0.99 of the largest distance */
static const double pressure_near = 1e-4, volume_most = 1; /* of logarithms */
static const double pressure_met = 1e-12; /* where steps to what is stationary take over */
enum {
    NEARER = 8,
    SMALLER = 12,
    LEADS = 128,
    TRIES = 3,
    SOFTS = 4,
    RUNGS = 17 /* to 16 times */,
    SETTLES = 20
};
static const double softs[SOFTS] = {1, 2, 4, 0.5};

typedef struct work {
    const taut_film_layout *layout;
    taut_film_layout own; /* what layout points to: with cables as they are led */
    taut_pulse pulse;
    taut_crew crew;
    taut_error *error;
    taut_film_energy *energy;
    taut_film_border border;
    size_t nodes;
    double *x, *next, *gradient, *after, *d, *right;
    double *
        multipliers; /* of the border's rows: pressures, and forces with a minus sign; of springs 0 */
    double *kept;    /* [as many] */
    const taut_film_drawn *given; /* [rope_count]: cables as they are asked for */
    double soft;                  /* how cables begin (laws.h) */
    int is_fresh;                 /* nonzero: from the start, with soft cables first */
    double led;                   /* share of the given pressures */
    double reach;                 /* times the size: beyond it the film is blown up */
    double *led_from;             /* [nodes][3] */
    double *from;                 /* [nodes][3] */
    double *scales;               /* [nodes]: what derivatives are held against */
    double value, residual, theta, least_start, aim, mu;
    int iterations, most;
    int is_narrowed; /* nonzero: it was once */
    int narrow;      /* the moves that are seen alone */
    int any;         /* nonzero: steps to what is stationary, up or down */
    int is_near;     /* nonzero: these in the moves that are seen alone */
    int has_ended;   /* nonzero: the last way ended in a fold, or where no rule settles */
    taut_film_method method;
    double gain; /* of the method `normal` */
} work;

static taut_status fail_interrupted(const work *w)
{
    return taut_fail(w->error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                     "stopped before the film was at rest");
}

static taut_status report(work *w)
{
    return taut_pulse_report(&w->pulse) ? fail_interrupted(w) : TAUT_OK;
}

static taut_status find_second(work *w)
{
    return taut_film_energy_second(w->energy) == TAUT_OK ? TAUT_OK : fail_interrupted(w);
}

/* The largest derivative of E - sum p V along what is free, over the scale of its node; of given volumes what they are off by if that is more. */
static double residual_of(work *w, const double *gradient, const double *p)
{
    const double off = taut_film_border_look(&w->border, w->energy);
    double most = 0;

    for (size_t a = 0; a < w->nodes; a++) {
        double g[3] = {gradient[3 * a], gradient[3 * a + 1], gradient[3 * a + 2]};
        for (int i = 0; i < w->border.count; i++) {
            if (!taut_film_border_is_spring(&w->border, w->energy, i)) {
                taut_add_scaled(-p[i], taut_film_border_row(&w->border, w->energy, i) + 3 * a, g);
            }
        }
        for (int k = 0; k < w->energy->size[a]; k++) {
            const double along = fabs(taut_dot(g, w->energy->free + 9 * a + 3 * (size_t)k));
            most = along > 0 ? fmax(most, along / w->scales[a]) : most;
        }
    }
    return fmax(most, off);
}

/* phi of the last value, with the p of the last step. */
static double merit(const work *w, double energy)
{
    for (int i = 0; i < w->border.count; i++) {
        const double excess = w->border.excess[i];
        energy += (0.5 * w->mu * excess - w->border.p[i]) * excess;
    }
    return energy;
}

/* Along a cable its force counts where it is more: it hides nothing of sheets beyond. */
static void scale_cables(work *w)
{
    const taut_film_complex *c = &w->layout->complex;

    for (int k = 0; k < c->strand_count; k++) {
        const taut_film_side *side = &c->strands[k].side;
        const int count = taut_film_complex_along(&c->problem->patches[side->patch], side->edge);
        for (int i = 0; i < count; i++) {
            double *scale = &w->scales[taut_film_complex_node(c, side, i)];
            *scale = fmax(*scale, w->energy->forces[c->strands[k].rope]);
        }
    }
}

static taut_status look(work *w)
{
    for (int i = 0; i < w->layout->complex.problem->cell_count; i++) {
        w->energy->pressures[i] = w->led * w->layout->pressures[i];
    }
    for (int i = 0; i < w->border.count; i++) {
        const int k = w->border.which[i];
        if (i < w->border.cells) {
            w->energy->pressures[k] = w->multipliers[i];
        } else if (!taut_film_border_is_spring(&w->border, w->energy, i)) {
            w->energy->forces[k] = -w->multipliers[i];
        }
    }
    w->value = taut_film_energy_value(w->energy, w->x, w->gradient, w->scales);
    scale_cables(w);
    const taut_status status = taut_film_energy_narrow(w->energy, w->narrow);
    w->residual = status == TAUT_OK ? residual_of(w, w->gradient, w->multipliers) : NAN;
    return status;
}

/* d by the least theta from here on that leads down nowhere; what phi promises to fall by. */
static taut_status find_step(work *w, double *promised)
{
    int down = 1;

    w->theta = w->any ? (w->narrow ? theta_least : theta_rounding) : w->theta;
    while (down != 0) {
        int negative = 0;
        const taut_status status = taut_film_energy_factor(w->energy, w->theta, &negative);
        if (status != TAUT_OK) {
            return status;
        }
        down = negative > w->border.count && !w->any
                   ? negative
                   : taut_film_border_factor(&w->border, w->energy, negative, w->right);
        if (w->any) {
            break;
        }
        if (down != 0 && w->theta >= 1) {
            return TAUT_NOT_CONVERGED;
        }
        w->theta = down != 0 ? fmin(1, 8 * w->theta) : w->theta;
    }
    taut_film_border_step(&w->border, w->energy, w->gradient, w->right, w->d);
    double longest = 0;
    for (size_t a = 0; a < w->nodes; a++) {
        longest = fmax(longest, taut_norm(w->d + 3 * a));
    }
    const double cut = longest > longest_step ? longest_step / longest : 1;
    w->mu = 1;
    for (int i = 0; i < w->border.count; i++) {
        w->mu = fmax(w->mu, 10 * fabs(w->border.p[i]));
    }
    *promised = 0;
    for (size_t k = 0; k < 3 * w->nodes; k++) {
        double slope = w->gradient[k];
        for (int i = 0; i < w->border.count; i++) {
            if (!taut_film_border_is_spring(&w->border, w->energy, i)) {
                slope += (w->mu * w->border.excess[i] - w->border.p[i]) *
                         taut_film_border_row(&w->border, w->energy, i)[k];
            }
        }
        w->d[k] *= cut;
        *promised -= slope * w->d[k];
    }
    return isfinite(longest) ? TAUT_OK : TAUT_NOT_CONVERGED;
}

/* Is x + share d better? Then it is x. */
static int try_step(work *w, double share, double promised)
{
    for (size_t k = 0; k < 3 * w->nodes; k++) {
        w->next[k] = w->x[k] + share * w->d[k];
    }
    const double before = merit(w, w->value), residual = w->residual;
    const int by_energy = !w->any && promised > rounding * fabs(w->value);
    const double energy = taut_film_energy_value(w->energy, w->next, w->after, NULL);
    const double after = residual_of(w, w->after, w->border.p); /* of V - V_0 too */
    const int better = by_energy ? merit(w, energy) <= before - share * share_promised * promised
                                 : after < residual;
    if (better) {
        memcpy(w->x, w->next, 3 * w->nodes * sizeof(double));
        for (int i = 0; i < w->border.count; i++) {
            w->multipliers[i] =
                taut_film_border_is_spring(&w->border, w->energy, i) ? 0 : w->border.p[i];
        }
    }
    return better;
}

/* After a try that was not taken: what belongs to x. */
static void look_back(work *w)
{
    (void)taut_film_energy_value(w->energy, w->x, w->gradient, NULL);
    (void)taut_film_border_look(&w->border, w->energy);
}

static int is_blown(const work *w)
{
    for (size_t k = 0; k < 3 * w->nodes; k++) {
        if (!(fabs(w->x[k]) <= w->reach)) {
            return 1;
        }
    }
    return 0;
}

/* The cable whose given length is the most beyond half a circle over its chord; -1: none is. */
static int longest_cable(const taut_film_complex *c)
{
    double most = TAUT_PI / 2;
    int longest = -1;

    for (int k = 0; k < c->rope_count; k++) {
        const double chord = taut_film_rope_chord(c, k), length = taut_film_rope_length(c, k);
        if (chord > 0 && length > most * chord) {
            most = length / chord;
            longest = k;
        }
    }
    return longest;
}

static taut_status refuse_fold(work *w)
{
    const taut_film_complex *c = &w->layout->complex;
    const int rope = longest_cable(c);

    w->has_ended = 1;
    if (rope >= 0) {
        const double chord = taut_film_rope_chord(c, rope);
        char where[TAUT_FILM_ROPE_WHERE], name[TAUT_FILM_NAME];
        taut_film_rope_where(
            c, rope, taut_film_rope_law(c, rope)->law == TAUT_FILM_SAG ? "sag" : "length", where);
        taut_film_rope_name(c, rope, name);
        return taut_fail(w->error, TAUT_NOT_CONVERGED, "folds", where,
                         taut_film_rope_length(c, rope), TAUT_PI / 2 * chord,
                         "cable %s is %.6g long, more than half a circle over its chord of %.6g, "
                         "and the film folds beside such a cable on its way to the least energy: "
                         "give it less length",
                         name, taut_film_rope_length(c, rope), chord);
    }
    return taut_fail(w->error, TAUT_NOT_CONVERGED, "folds", "/patches", w->energy->least, fold,
                     "after %d steps the least area element is %.3g of the mean: a patch folds or "
                     "shrinks to a line on its way to the least energy; give another layout",
                     w->iterations, w->energy->least);
}

static int is_normal(const work *w)
{
    return w->method == TAUT_FILM_NORMAL;
}

/* One step, by the least theta that makes one; *taken: 0 where none is better. */
static taut_status make_step(work *w, double *promised, int *taken)
{
    taut_status status = find_second(w);
    *taken = 0;
    if (status != TAUT_OK) {
        return status;
    }
    while (!*taken) {
        status = find_step(w, promised);
        if (status == TAUT_NO_MEMORY) {
            return status;
        }
        const int lost = *promised <= rounding * fabs(w->value);
        if (status == TAUT_OK && !w->narrow && !w->any && lost && w->theta < theta_rounding) {
            w->theta = theta_rounding;
            continue;
        }
        *taken = status == TAUT_OK && try_step(w, 1, *promised);
        for (int k = 1; !*taken && status == TAUT_OK && (w->any || w->theta >= 1) && k <= HALVINGS;
             k++) {
            look_back(w);
            *taken = try_step(w, ldexp(1, -k), *promised);
        }
        if (!*taken) {
            look_back(w);
        }
        if (!*taken && (w->any || w->theta >= 1)) {
            return TAUT_OK;
        }
        const double least = is_normal(w) && !w->narrow ? theta_normal : theta_least;
        w->theta = *taken ? fmax(least, w->theta / 8) : fmin(1, 8 * w->theta);
    }
    return TAUT_OK;
}

static taut_status check_step(work *w)
{
    if (w->energy->least < fold * fmin(1, w->least_start)) {
        return refuse_fold(w);
    }
    return is_blown(w)
               ? taut_fail(w->error, TAUT_NO_SOLUTION, "pressure-too-high", "/cells", w->reach,
                           w->reach, "the film grows to %g times its size", w->reach)
               : TAUT_OK;
}

/* With this rule, in these moves, until a step promises next to nothing, none is better, or the aim is reached. */
static taut_status descend(work *w)
{
    int stalls = 0, is_done = 0;
    taut_status status = look(w);

    while (status == TAUT_OK && w->residual > w->aim && stalls < STALLS && !is_done) {
        const double before = w->residual;
        double promised = 0;
        int taken = 0;
        if (w->iterations >= w->most) {
            return taut_fail(w->error, TAUT_NOT_CONVERGED, "not-converged", "/max_iterations",
                             w->residual, w->aim,
                             "after %d steps the largest derivative is %.3g of the largest, "
                             "expected %.3g",
                             w->iterations, w->residual, w->aim);
        }
        status = report(w);
        if (status != TAUT_OK) {
            return status;
        }
        status = make_step(w, &promised, &taken);
        w->iterations++;
        if (status == TAUT_OK) {
            status = look(w);
        }
        if (status == TAUT_OK) {
            status = check_step(w);
        }
        stalls = !taken                                 ? STALLS
                 : promised > rounding * fabs(w->value) ? 0
                 : w->residual > 0.5 * before           ? stalls + 1
                                                        : 0;
        is_done =
            w->any ? !w->narrow && w->residual <= residual_all
                   : !w->narrow && (w->energy->soft > 0 ? promised <= gain_soft * fabs(w->value)
                                    : is_normal(w)      ? promised <= w->gain * fabs(w->value)
                                                        : w->residual <= residual_all &&
                                                         promised <= gain_least * fabs(w->value));
    }
    return status;
}

static int has_soft(const work *w)
{
    for (int k = 0; k < w->layout->complex.rope_count; k++) {
        if (w->layout->drawn[k].target > 0) {
            return 1;
        }
    }
    return 0;
}

/* From the start, where lengths are given or cables are stiff: with soft ones first, in all coordinates, whose forces are those to
 * begin with. */
static taut_status begin_soft(work *w)
{
    const int is_soft = w->is_fresh && has_soft(w);

    w->is_fresh = 0;
    if (!is_soft) {
        return TAUT_OK;
    }
    w->energy->soft = w->soft;
    const taut_status status = descend(w);
    w->energy->soft = 0;
    for (int i = w->border.cells; i < w->border.count; i++) {
        w->multipliers[i] = taut_film_border_is_spring(&w->border, w->energy, i)
                                ? 0
                                : -w->energy->forces[w->border.which[i]];
    }
    w->theta = fmax(w->theta, theta_hard);
    return status;
}

/* In all coordinates, then in those that are seen. */
static taut_status descend_both(work *w)
{
    taut_status status = TAUT_OK;

    w->narrow = 0;
    status = begin_soft(w);
    if (status == TAUT_OK) {
        status = look(w);
    }
    if (status == TAUT_OK && w->residual > residual_all && !w->is_near &&
        !(is_normal(w) && w->is_narrowed)) {
        status = descend(w);
    }
    w->narrow = w->is_narrowed = 1;
    w->theta = fmin(w->theta, is_normal(w) ? theta_normal : 1e-6);
    return status == TAUT_OK ? descend(w) : status;
}

/* Does a cable pass another edge in corner k of patch p, which is held? radius: of its cables, else 0. */
static int is_passed_in(const work *w, int p, const double radius[4], int k)
{
    const taut_film_energy *e = w->energy;
    const taut_film_complex *c = &w->layout->complex;
    const taut_film_problem *patch = &c->problem->patches[p];
    const int u = 2 + k / 2, v = k % 2, other = radius[u] > 0 ? v : u;
    const int ends = radius[other] > 0 || (patch->edges[other].kind == TAUT_FILM_FIXED &&
                                           taut_film_complex_seam(c->problem, p, other) < 0);

    return radius[u] + radius[v] > 0 && ends && e->size[taut_film_complex_corner(c, p, k)] == 0 &&
           taut_film_passes(e->areas[p], patch, radius, e->net + 3 * (size_t)c->first[p], k);
}

static int is_passed(const work *w)
{
    const taut_film_energy *e = w->energy;
    const taut_film_complex *c = &w->layout->complex;

    for (int p = 0; p < c->problem->patch_count; p++) {
        double radius[4] = {0, 0, 0, 0};
        for (int k = 0; k < c->strand_count && e->areas[p]->density == NULL; k++) {
            const taut_film_side *side = &c->strands[k].side;
            if (side->patch == p && c->strands[k].seam < 0) {
                radius[side->edge] = fmax(0, e->cables[k].tension) / e->shares[p];
            }
        }
        for (int k = 0; k < 4; k++) {
            if (is_passed_in(w, p, radius, k)) {
                return 1;
            }
        }
    }
    return 0;
}

static taut_status look_at_corners(work *w)
{
    if (!is_passed(w)) {
        return TAUT_OK;
    }
    w->has_ended = 1;
    return taut_fail(w->error, TAUT_NOT_CONVERGED, "folds", "/patches", taut_none, taut_none,
                     "a cable is drawn past another edge in the corner where they end, and the "
                     "film folds there: raise the forces of the cables, or move the corners");
}

/* Rules, until a finer one agrees that the film is at rest. */
static taut_status settle(work *w)
{
    taut_status status = TAUT_OK;

    for (int rule = 0; status == TAUT_OK && rule < RULES; rule++) {
        taut_film_energy_free(w->energy);
        w->energy = NULL;
        status = report(w);
        if (status == TAUT_OK) {
            status = taut_film_energy_new(w->layout, extra_nodes[rule], &w->crew, &w->energy);
        }
        if (status == TAUT_OK) {
            status = look(w);
        }
        if (status != TAUT_OK) {
            return status;
        }
        if (rule == 0) {
            w->least_start = w->energy->least;
        } else if (w->residual <= 4 * w->aim) {
            return look_at_corners(w);
        }
        const double before = rule > 0 ? w->residual : 0;
        w->theta = rule == 0 ? 1 : fmin(w->theta, 1e-6);
        status = descend_both(w);
        if (status == TAUT_OK && rule == RULES - 1 && before > unsettled * w->aim) {
            w->has_ended = 1;
            return taut_fail(w->error, TAUT_NOT_CONVERGED, "not-converged", "/tolerance", before,
                             w->aim,
                             "no Gauss rule settles the derivatives: the last one still finds %.3g "
                             "of the largest; a corner may be near to 180 degrees",
                             before);
        }
    }
    return status == TAUT_OK ? look_at_corners(w) : status;
}

/* Of B(theta) where the film is at rest: how many ways lead down. */
static taut_status count_ways(work *w, double theta, int *down)
{
    int negative = 0;
    taut_status status = report(w);

    if (status == TAUT_OK) {
        status = find_second(w);
    }
    if (status == TAUT_OK) {
        status = taut_film_energy_factor(w->energy, theta, &negative);
    }
    if (status == TAUT_OK) {
        *down = taut_film_border_factor(&w->border, w->energy, negative, w->right);
    }
    return status;
}

static taut_status count_down(work *w, int *down)
{
    return count_ways(w, theta_least, down);
}

/* ---- pressures that are led ---- */

static int has_pressure(const taut_film_layout *l)
{
    for (int k = 0; k < l->complex.problem->cell_count; k++) {
        if (l->pressures[k] != 0) {
            return 1;
        }
    }
    return 0;
}

static int has_cables(const work *w)
{
    return w->layout->complex.rope_count > 0;
}

/* Rules settle for a film that turns over beside an edge alone. */
static taut_status check_turned(work *w)
{
    const taut_film_complex *c = &w->layout->complex;
    taut_film_turned turned;

    if (taut_film_find_turned(c, w->x, &turned) != TAUT_OK) {
        return taut_fail_memory(w->error);
    }
    if (turned.patch < 0) {
        return TAUT_OK;
    }
    w->has_ended = 1;
    char where[32];
    snprintf(where, sizeof where, "/patches/%d", turned.patch);
    return taut_fail(
        w->error, TAUT_NOT_CONVERGED, "folds", c->problem->patch_count > 1 ? where : NULL,
        w->iterations, taut_none,
        "after %d steps the film turns over near u = %.3g, v = %.3g: edges meet at more "
        "than 180 degrees in a corner, or pass each other; give another layout",
        w->iterations, turned.u, turned.v);
}

/* A film from x on, by the first rule, in LED steps. */
static taut_status find_here(work *w, int *found)
{
    const int most = w->most, before = w->iterations;
    int down = 1;

    w->has_ended = 0;
    w->most = before + LED;
    taut_status status = descend_both(w);
    if (status == TAUT_OK || (status == TAUT_NOT_CONVERGED && w->residual <= led_near)) {
        status = count_down(w, &down);
    }
    *found = status == TAUT_OK && down == 0 && w->residual <= fmax(w->aim, led_near);
    if (*found && has_cables(w)) {
        status = check_turned(w);
        *found = status == TAUT_OK;
    }
    if (*found && is_passed(w)) {
        *found = 0;
        w->has_ended = 1;
    }
    w->most = most;
    return status == TAUT_NO_MEMORY || status == TAUT_INTERRUPTED ? status : TAUT_OK;
}

/* A film under a share of the pressures, from x on. */
static taut_status find_led(work *w, double share, int *found)
{
    w->led = share;
    w->theta = share == 0 ? 1 : 1e-3;
    w->reach = blown_led;
    const taut_status status = find_here(w, found);
    w->reach = blown;
    return status;
}

/* The first rule again, from the start. */
static taut_status begin_again(work *w)
{
    memcpy(w->x, w->layout->start, 3 * w->nodes * sizeof(double));
    w->is_fresh = 1;
    taut_film_energy_free(w->energy);
    w->energy = NULL;
    return taut_film_energy_new(w->layout, extra_nodes[0], &w->crew, &w->energy);
}

/* From no pressure on; TAUT_OK: x is a film under all of it. */
static taut_status lead(work *w)
{
    const taut_film_problem *problem = w->layout->complex.problem;
    const size_t bytes = 3 * w->nodes * sizeof(double);
    double *const last = w->led_from;
    double at = 0, step = 1;
    int found = 0;

    taut_status status = begin_again(w);
    if (status == TAUT_OK) {
        status = find_led(w, 0, &found);
    }
    if (status != TAUT_OK || !found) {
        return status != TAUT_OK ? status : TAUT_NOT_CONVERGED;
    }
    step = 0.5;
    while (at < 1) {
        memcpy(last, w->x, bytes);
        status = find_led(w, fmin(1, at + step), &found);
        if (status != TAUT_OK) {
            return status;
        }
        if (found) {
            at = fmin(1, at + step);
        } else {
            memcpy(w->x, last, bytes);
            step /= 2;
        }
        if (step < led_least * (at > 0 ? fmin(1, 2 * at) : 1)) {
            break;
        }
    }
    w->led = 1;
    int k = 0;
    while (problem->cells[k].has_volume || problem->cells[k].pressure == 0) {
        k++;
    }
    char where[48];
    snprintf(where, sizeof where, "/cells/%d/pressure", k);
    return at >= 1 ? TAUT_OK
                   : taut_fail(w->error, TAUT_NO_SOLUTION, "pressure-too-high", where,
                               problem->cells[k].pressure, at * problem->cells[k].pressure,
                               "no film is found under a pressure of %.6g: raised from 0, the last "
                               "film is found at %.6g; lower it, or give a volume",
                               problem->cells[k].pressure, at * problem->cells[k].pressure);
}

/* ---- rims that are led ---- */

static void shift(work *w, const taut_film_parting *parting, double by)
{
    for (size_t a = 0; a < w->nodes; a++) {
        taut_add_scaled(by * parting->share[a], parting->way, w->x + 3 * a);
    }
}

/* With the rims at so much of their distance, from x on, which is moved there first. */
static taut_status find_apart(work *w, const taut_film_parting *parting, double by, double theta,
                              int *found)
{
    shift(w, parting, by);
    w->is_narrowed = 0;
    w->theta = theta;
    w->least_start = 1;
    return find_here(w, found);
}

static taut_status refuse_apart(const work *w, const taut_film_parting *parting, double share,
                                double neck)
{
    return taut_fail(w->error, TAUT_NO_SOLUTION, parting->slides ? "slides-away" : "collapses",
                     "/patches", 1, share,
                     "no film connects the two rims: as they are moved apart, a film is found up "
                     "to %.6g of their distance, where its neck is %.3g of the shorter rim%s",
                     share, neck,
                     parting->slides ? "; it slides off, bring the plane nearer"
                                     : "; bring them together");
}

/* TAUT_OK: x is near a film between the rims where they are. TAUT_NOT_CONVERGED: nothing is said of them. */
static taut_status lead_apart(work *w, taut_film_parting *parting, taut_arena *arena)
{
    const size_t bytes = 3 * w->nodes * sizeof(double);
    double share = 1, step = 0.5, neck = 1;
    int found = 0;
    taut_status status = taut_film_parting_spread(w->layout, arena, parting);

    if (status == TAUT_OK) {
        status = begin_again(w);
    }
    for (int k = 0; status == TAUT_OK && !found && k < NEARER; k++) {
        share *= 0.5;
        memcpy(w->x, w->layout->start, bytes);
        status = find_apart(w, parting, share - 1, 1, &found);
    }
    if (status != TAUT_OK || !found) {
        return status == TAUT_OK ? TAUT_NOT_CONVERGED : status;
    }
    for (int k = 0; status == TAUT_OK && share < 1 && k < LEADS && step > apart_least; k++) {
        const double next = fmin(1, share + step);
        memcpy(w->led_from, w->x, bytes);
        status = find_apart(w, parting, next - share, 1e-3, &found);
        if (found) {
            share = next;
        } else {
            memcpy(w->x, w->led_from, bytes);
            step /= 2;
        }
    }
    if (status == TAUT_OK && share < 1) {
        neck = taut_film_parting_neck(w->layout, w->x, parting->class);
        return neck < neck_most ? refuse_apart(w, parting, share, neck) : TAUT_NOT_CONVERGED;
    }
    for (size_t a = 0; a < w->nodes; a++) {
        if (parting->rim[a] >= 0 && w->energy->size[a] == 0) {
            memcpy(w->x + 3 * a, w->layout->start + 3 * a, 3 * sizeof(double));
        }
    }
    return status;
}

/* ---- cables that are led ---- */

/* From x on, with all cables so many times as strong. */
static taut_status find_strong(work *w, double factor, double theta, int *found)
{
    taut_film_strengthen(w->energy, &w->own, w->given, factor);
    w->is_narrowed = 0;
    w->theta = theta;
    return find_here(w, found);
}

/* A film with cables *factor times as strong, from the start. */
static taut_status find_rung(work *w, double *factor, int *found)
{
    taut_status status = TAUT_OK;

    *found = 0;
    for (int k = 1; status == TAUT_OK && !*found && k < RUNGS; k++) {
        *factor = taut_film_rung(&w->own, w->given, k);
        if (!taut_film_can_strengthen(&w->own, w->given, *factor)) {
            return TAUT_OK;
        }
        status = begin_again(w);
        if (status == TAUT_OK) {
            w->soft = 1;
            w->narrow = 0;
            status = look(w);
        }
        if (status == TAUT_OK) {
            w->least_start = w->energy->least;
            status = find_strong(w, *factor, 1, found);
        }
    }
    return status;
}

/* From the last film on, at led_from, the first a little above that all rules settle: no more than above_told times as strong. */
static taut_status settle_last(work *w, double *factor)
{
    taut_status status = TAUT_NOT_CONVERGED;
    const double first = *factor;

    for (int k = 0; status == TAUT_NOT_CONVERGED && k <= SETTLES; k++) {
        *factor = first * (1 + k * (above_told - 1) / SETTLES);
        memcpy(w->x, w->led_from, 3 * w->nodes * sizeof(double));
        taut_film_strengthen(w->energy, &w->own, w->given, *factor);
        w->is_narrowed = 0;
        w->most = w->iterations + LED;
        status = settle(w);
        if (status == TAUT_OK) {
            status = check_turned(w);
        }
    }
    return status;
}

/* TAUT_OK: x is near a film with the cables that are asked for. TAUT_NOT_CONVERGED: nothing is said of them. */
static taut_status lead_cables(work *w)
{
    const size_t bytes = 3 * w->nodes * sizeof(double);
    double factor = 1, step = 0.5;
    int found = 0;
    taut_status status = find_rung(w, &factor, &found);

    if (status != TAUT_OK || !found) {
        return status == TAUT_OK ? TAUT_NOT_CONVERGED : status;
    }
    for (int k = 0; status == TAUT_OK && factor > 1 && k < LEADS && step > weaker_least; k++) {
        const double next = fmax(1, factor * (1 - step));
        memcpy(w->led_from, w->x, bytes);
        status = find_strong(w, next, 1e-3, &found);
        if (found) {
            factor = next;
        } else {
            memcpy(w->x, w->led_from, bytes);
            step /= 2;
        }
    }
    if (status != TAUT_OK || factor == 1) {
        return status;
    }
    const int is_end = w->has_ended;
    memcpy(w->led_from, w->x, bytes);
    status = find_strong(w, above_told * factor, 1e-3, &found);
    if (status != TAUT_OK || !is_end || !found) {
        return status != TAUT_OK ? status : TAUT_NOT_CONVERGED;
    }
    status = settle_last(w, &factor);
    return status == TAUT_OK
               ? taut_film_refuse_weak(&w->layout->complex, w->given, factor, w->error)
               : status;
}

static taut_status check_saddle(work *w, taut_film_rest *rest)
{
    const taut_status status = count_down(w, &rest->negative);

    if (status == TAUT_OK && rest->negative != 0 &&
        !w->layout->complex.problem->accepts_stationary) {
        const int is_one = rest->negative == 1;
        return taut_fail(w->error, TAUT_NO_SOLUTION, "unstable", "/patches", rest->negative, 0,
                         "the film is at rest, and %d %s down from it: begin elsewhere, or accept "
                         "what is stationary",
                         rest->negative, is_one ? "way leads" : "ways lead");
    }
    return status;
}

/* In a plane a net may be at rest by all rules and fold where none of them looks. */
static taut_status even_out(work *w)
{
    int made = 0;
    const taut_status status = taut_film_even(w->layout, w->x, &made);
    return status == TAUT_OK && made ? settle(w) : status;
}

/* Whether cables are too weak is found by strengthening them: what turns over is told before that. */
static taut_status find_by(work *w, taut_film_rest *rest)
{
    taut_status status = settle(w);
    if (status == TAUT_OK && has_cables(w)) {
        status = even_out(w);
    }
    if (status == TAUT_OK && has_cables(w)) {
        status = check_turned(w);
    }
    return status == TAUT_OK ? check_saddle(w, rest) : status;
}

/* From x on: in all coordinates, unless `normal`; where these fold the net, or do not come to rest, by the method `normal`, which
 * leaves them ever sooner; each with soft cables of several forces. */
static taut_status find_from(work *w, int normal, taut_film_rest *rest)
{
    const size_t bytes = 3 * w->nodes * sizeof(double),
                 rows = (size_t)w->border.count * sizeof(double);
    const int most = w->most, is_fresh = w->is_fresh;
    const int tries = is_fresh && has_soft(w) ? SOFTS : 1;
    taut_status status = TAUT_NOT_CONVERGED;

    memcpy(w->from, w->x, bytes);
    memcpy(w->kept, w->multipliers, rows);
    for (int n = 0; status == TAUT_NOT_CONVERGED && n < tries * TRIES; n++) {
        const int k = n / tries;
        if (k < normal) {
            continue;
        }
        w->soft = softs[n % tries];
        memcpy(w->x, w->from, bytes);
        memcpy(w->multipliers, w->kept, rows);
        w->is_fresh = is_fresh;
        w->method = k == 0 ? TAUT_FILM_FULL : TAUT_FILM_NORMAL;
        w->gain = k == 0 ? 0 : gains_normal[k - 1];
        w->is_narrowed = 0;
        w->most = w->iterations + most;
        status = find_by(w, rest);
    }
    return status;
}

/* ---- what is no minimum ---- */

/* From x on, to what is stationary. */
static taut_status find_any(work *w, taut_film_rest *rest)
{
    const int most = w->most;

    w->any = 1;
    w->is_fresh = w->is_narrowed = 0;
    w->method = TAUT_FILM_FULL;
    w->most = w->iterations + LED;
    taut_status status = settle(w);
    if (status == TAUT_OK) {
        status = count_down(w, &rest->negative);
    }
    w->any = 0;
    w->most = most;
    return status;
}

/* The cells of given pressures become ones of given volumes, those of balls of that pressure. */
static taut_status take_volumes(work *w, taut_film_problem *problem, taut_arena *arena)
{
    const taut_film_problem *asked = w->layout->complex.problem;
    const size_t cells = (size_t)asked->cell_count;
    taut_film_cell *own = taut_arena_copy(arena, asked->cells, cells, sizeof *own);

    w->own.volumes = taut_arena_copy(arena, w->own.volumes, cells, sizeof(double));
    w->own.pressures = taut_arena_copy(arena, w->own.pressures, cells, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < cells; k++) {
        if (w->own.pressures[k] != 0) {
            const double radius = 2 / w->own.pressures[k];
            own[k].has_volume = 1;
            w->own.volumes[k] = 4 * TAUT_PI / 3 * radius * radius * radius;
            w->own.pressures[k] = 0;
        }
    }
    *problem = *asked;
    problem->cells = own;
    w->own.complex.problem = problem;
    return taut_film_border_new(&w->own, arena, &w->border);
}

/* A film of smaller and smaller volumes, from the start. */
static taut_status find_small(work *w, int *found)
{
    taut_status status = TAUT_OK;

    *found = 0;
    for (int k = 0; status == TAUT_OK && !*found && k < SMALLER; k++) {
        for (int i = 0; k > 0 && i < w->border.cells; i++) {
            w->own.volumes[w->border.which[i]] /= 2;
        }
        status = begin_again(w);
        w->is_narrowed = 0;
        w->least_start = w->theta = 1;
        memset(w->multipliers, 0, (size_t)w->border.count * sizeof(double));
        status = status == TAUT_OK ? find_here(w, found) : status;
    }
    return status;
}

/* Volumes of films whose pressures are nearer; *off: how far the farthest was. last: [cells][2], logarithms of V and p / p_given. */
static void change_volumes(work *w, const double *given, double *last, int is_first, double *off)
{
    *off = 0;
    for (int i = 0; i < w->border.cells; i++) {
        const int k = w->border.which[i];
        if (given[k] == 0) {
            continue;
        }
        const double ratio = w->multipliers[i] / given[k];
        const double by = ratio > 0 ? taut_log(ratio) : -1, at = taut_log(fabs(w->own.volumes[k]));
        const double slope = is_first ? -1.0 / 3 : (by - last[2 * k + 1]) / (at - last[2 * k]);
        const double way = -by / (slope < -1e-3 && isfinite(slope) ? slope : -1.0 / 3);
        last[2 * k] = at;
        last[2 * k + 1] = by;
        w->own.volumes[k] *= taut_exp(fmax(-volume_most, fmin(volume_most, way)));
        *off = fmax(*off, fabs(by));
    }
}

/* From the film of other volumes on, nearer to these where they are too far. */
static taut_status find_changed(work *w, const double *before, int *found)
{
    const size_t bytes = 3 * w->nodes * sizeof(double);
    taut_status status = TAUT_OK;

    memcpy(w->led_from, w->x, bytes);
    *found = 0;
    for (int k = 0; status == TAUT_OK && !*found && k < NEARER; k++) {
        for (int i = 0; k > 0 && i < w->border.cells; i++) {
            const int c = w->border.which[i];
            w->own.volumes[c] = 0.5 * (w->own.volumes[c] + before[c]);
        }
        memcpy(w->x, w->led_from, bytes);
        w->is_narrowed = 0;
        w->theta = 1e-3;
        status = find_here(w, found);
    }
    return status;
}

/* How far the pressures of given volumes are from those that are asked for, over these: the farthest. */
static double pressures_off(const work *w, const double *given)
{
    double off = 0;
    for (int i = 0; i < w->border.cells; i++) {
        const double p = given[w->border.which[i]];
        off = p != 0 ? fmax(off, fabs(w->multipliers[i] / p - 1)) : off;
    }
    return off;
}

/* dV = S (p_given - p) of cells whose pressures are given, S as its factors stand; others are let be. */
static void add_volumes(work *w, const double *given)
{
    const int m = w->border.count;
    const double *s = w->border.s;

    for (int i = 0; i < w->border.cells; i++) {
        double by = 0;
        for (int j = 0; j <= i; j++) { /* (L D L')_i: column j of L' */
            double sum = 0;
            for (int k = j; k < w->border.cells; k++) {
                const double p = given[w->border.which[k]];
                sum += p != 0 ? (k == j ? 1 : s[k * m + j]) * (p - w->multipliers[k]) : 0;
            }
            by += (i == j ? 1 : s[i * m + j]) * s[j * m + j] * sum;
        }
        w->own.volumes[w->border.which[i]] += given[w->border.which[i]] != 0 ? by : 0;
    }
}

/* The minimum of volumes whose pressures are those asked for, as near as these can be told. Each from the start: nets that were led
 * are not at rest in all coordinates. TAUT_NOT_CONVERGED: none is found. */
static taut_status meet_pressures(work *w, const double *given)
{
    const int most = w->most;
    double off = INFINITY, before = INFINITY;
    int down = 0;
    taut_status status = TAUT_OK;

    w->method = TAUT_FILM_FULL;
    w->soft = 1;
    for (int k = 0; status == TAUT_OK && k < NEARER && off > pressure_met; k++) {
        memcpy(w->x, w->layout->start, 3 * w->nodes * sizeof(double));
        memset(w->multipliers, 0, (size_t)w->border.count * sizeof(double));
        w->is_fresh = 1;
        w->is_narrowed = 0;
        w->most = w->iterations + LED;
        status = settle(w);
        if (status == TAUT_OK) {
            status = count_down(w, &down);
        }
        off = pressures_off(w, given);
        if (status == TAUT_OK && (down != 0 || !(off < 10 * pressure_near))) {
            status = TAUT_NOT_CONVERGED;
        }
        if (off > before / 2) {
            break;
        }
        before = off;
        add_volumes(w, given);
    }
    w->is_near = status == TAUT_OK;
    w->most = most;
    return status;
}

/* TAUT_OK: x is at a film under the pressures that is a minimum of its volumes, and none of pressures. */
static taut_status lead_volumes(work *w, taut_arena *arena, taut_film_rest *rest)
{
    const taut_film_layout kept = w->own;
    const taut_film_border border = w->border;
    const size_t cells = (size_t)kept.complex.problem->cell_count;
    taut_film_problem problem;
    double *last = taut_arena_take(arena, cells, 2 * sizeof(double)),
           *before = taut_arena_take(arena, cells, sizeof(double)), off = INFINITY;
    int found = 0;
    taut_status status = taut_arena_status(arena);

    w->led = 1;
    if (status == TAUT_OK) {
        status = take_volumes(w, &problem, arena);
    }
    if (status == TAUT_OK) {
        status = find_small(w, &found);
    }
    for (int k = 0; status == TAUT_OK && found && off > pressure_near && k < LED; k++) {
        memcpy(before, w->own.volumes, cells * sizeof(double));
        change_volumes(w, kept.pressures, last, k == 0, &off);
        if (off > pressure_near) {
            status = find_changed(w, before, &found);
        }
    }
    if (status == TAUT_OK && off <= pressure_near && kept.complex.problem->accepts_stationary) {
        memcpy(w->led_from, w->x, 3 * w->nodes * sizeof(double));
        const taut_status met = meet_pressures(w, kept.pressures);
        if (met == TAUT_NO_MEMORY || met == TAUT_INTERRUPTED) {
            status = met;
        } else if (met != TAUT_OK) {
            memcpy(w->x, w->led_from, 3 * w->nodes * sizeof(double));
        }
    }
    w->own = kept;
    w->border = border;
    if (status != TAUT_OK || off > pressure_near) {
        return status != TAUT_OK ? status : TAUT_NOT_CONVERGED;
    }
    memset(w->multipliers, 0, (size_t)w->border.count * sizeof(double));
    status = find_any(w, rest);
    w->is_near = 0;
    return status == TAUT_OK && rest->negative == 0 ? TAUT_NOT_CONVERGED : status;
}

static taut_status refuse_pressures(const work *w, const taut_film_rest *rest)
{
    const taut_film_layout *l = w->layout;
    const taut_film_problem *problem = l->complex.problem;
    int k = 0;
    char where[48];

    while (l->pressures[k] == 0) {
        k++;
    }
    snprintf(where, sizeof where, "/cells/%d/pressure", k);
    const double volume = ldexp(w->energy->volumes[k], 3 * (l->scaling.outer + l->scaling.inner));
    return taut_fail(
        w->error, TAUT_NO_SOLUTION, "unstable", where, rest->negative, 0,
        "under a pressure of %.6g the film rests with a volume of %.6g, and %d %s down "
        "from there: with less volume it shrinks, with more it grows; give the "
        "volume, or accept what is stationary",
        problem->cells[k].pressure, volume, rest->negative,
        rest->negative == 1 ? "way leads" : "ways lead");
}

static int has_start(const taut_film_problem *problem)
{
    int has = 0;
    for (int p = 0; p < problem->patch_count; p++) {
        has |= problem->patches[p].start != NULL;
    }
    return has;
}

/* A cable holds nothing where it is slack. */
static taut_status check_slack(const work *w)
{
    const taut_film_complex *c = &w->layout->complex;

    for (int k = 0; k < c->rope_count; k++) {
        if (!(w->energy->forces[k] > 0)) {
            char where[TAUT_FILM_ROPE_WHERE], name[TAUT_FILM_NAME];
            const taut_film_law law = w->given[k].law;
            const int unit = w->layout->scaling.outer + w->layout->scaling.inner;
            taut_film_rope_where(c, k,
                                 law == TAUT_FILM_ELASTIC ? "unstressed"
                                 : law == TAUT_FILM_SAG   ? "sag"
                                                          : "length",
                                 where);
            taut_film_rope_name(c, k, name);
            return taut_fail(w->error, TAUT_NO_SOLUTION, "cable-too-weak", where,
                             w->energy->forces[k], 0,
                             "cable %s is slack where the film is at rest, which draws it to a "
                             "length of about %.3g: give it less than that",
                             name, ldexp(w->energy->lengths[k], unit));
        }
    }
    return TAUT_OK;
}

/* Films that push at a cable of given length come to no rest. With springs in place of such cables along seams they do: TAUT_NO_SOLUTION,
 * cable-too-weak, where one of these is slack. TAUT_NOT_CONVERGED: nothing is said of them. */
static taut_status find_slack(work *w, taut_film_rest *rest)
{
    const taut_film_complex *c = &w->layout->complex;
    int springs = 0;

    for (int k = 0; k < c->rope_count; k++) {
        taut_film_drawn *d = &w->own.drawn[k];
        if (taut_film_rope_is_given(c->ropes[k].edge) && c->strands[c->ropes[k].strand].seam >= 0) {
            d->law = TAUT_FILM_ELASTIC;
            d->stiffness = stiff_slack * d->ratio / d->length;
            springs++;
        }
    }
    if (springs == 0) {
        return TAUT_NOT_CONVERGED;
    }
    taut_status status = begin_again(w);
    if (status == TAUT_OK) {
        memset(w->multipliers, 0, (size_t)w->border.count * sizeof(double));
        status = find_from(w, 0, rest);
        status = status == TAUT_NO_SOLUTION ? TAUT_NOT_CONVERGED : status;
    }
    if (status == TAUT_OK) {
        status = check_slack(w);
        status = status == TAUT_OK ? TAUT_NOT_CONVERGED : status;
    }
    memcpy(w->own.drawn, w->given, (size_t)c->rope_count * sizeof *w->given);
    return status;
}

/* The film, led to its pressure, to its cables, or with its rims apart, where the way from the start misses it. */
static taut_status find_film(work *w, taut_film_parting *parting, taut_arena *arena,
                             taut_film_rest *rest)
{
    const taut_film_problem *problem = w->layout->complex.problem;
    const int normal = problem->method == TAUT_FILM_NORMAL, any = problem->accepts_stationary;

    if (any && has_start(problem)) {
        const taut_status begun = find_any(w, rest);
        if (begun != TAUT_NOT_CONVERGED && begun != TAUT_NO_SOLUTION) {
            return begun;
        }
        memcpy(w->x, w->layout->start, 3 * w->nodes * sizeof(double));
        memset(w->multipliers, 0, (size_t)w->border.count * sizeof(double));
        w->is_fresh = 1;
    }
    const taut_status status = find_from(w, normal, rest);
    const int has_rims = parting->count == 2;
    taut_error first = {.status = TAUT_OK};

    if (!(status == TAUT_NO_SOLUTION || status == TAUT_NOT_CONVERGED) ||
        !(has_pressure(w->layout) || has_rims || has_cables(w))) {
        return status;
    }
    if (w->error != NULL) {
        first = *w->error;
    }
    taut_status led = TAUT_NOT_CONVERGED;
    int from = 1; /* by the method `normal`, but where cables are led */
    if (has_rims) {
        led = lead_apart(w, parting, arena);
    } else if (has_pressure(w->layout)) {
        led = lead(w);
        if (led == TAUT_NOT_CONVERGED) {
            led = lead_volumes(w, arena, rest);
            if (led == TAUT_OK) {
                return any ? TAUT_OK : refuse_pressures(w, rest);
            }
            led = led == TAUT_NO_SOLUTION ? TAUT_NOT_CONVERGED : led;
        }
    } else if (w->has_ended) {
        led = lead_cables(w);
        taut_film_strengthen(w->energy, &w->own, w->given, 1);
        from = normal;
    }
    if (led == TAUT_NOT_CONVERGED && has_cables(w)) {
        led = find_slack(w, rest);
    }
    if (led == TAUT_NOT_CONVERGED && w->error != NULL) {
        *w->error = first;
    }
    return led == TAUT_OK ? find_from(w, from, rest) : led == TAUT_NOT_CONVERGED ? status : led;
}

/* Where films end, as rims are led apart or pressures raised, a spline has one for a little longer than the continuous problem. */
static taut_status find_doubt(work *w, const taut_film_parting *parting, taut_film_rest *rest)
{
    const taut_film_problem *problem = w->layout->complex.problem;
    int soft = 0;
    taut_status status = TAUT_OK;

    rest->doubt = TAUT_FILM_CERTAIN;
    if (problem->method == TAUT_FILM_NORMAL || problem->accepts_stationary ||
        !(parting->count == 2 || has_pressure(w->layout))) {
        return TAUT_OK;
    }
    if (is_normal(w)) {
        rest->doubt = TAUT_FILM_BY_NORMAL;
        return TAUT_OK;
    }
    status = count_ways(w, -soft_most, &soft);
    rest->doubt = soft > 0 ? TAUT_FILM_NEAR_ITS_END : TAUT_FILM_CERTAIN;
    return status;
}

/* Pressures, forces and lengths in the user's unit. */
static taut_status take_forces(const work *w, taut_arena *arena, taut_film_rest *rest)
{
    const taut_film_layout *l = w->layout;
    const taut_film_problem *problem = l->complex.problem;
    const int unit = l->scaling.outer + l->scaling.inner;
    const size_t ropes = (size_t)l->complex.rope_count;

    rest->pressures =
        taut_arena_copy(arena, w->energy->pressures, (size_t)problem->cell_count, sizeof(double));
    rest->forces = taut_arena_take(arena, ropes, sizeof(double));
    rest->lengths = taut_arena_take(arena, ropes, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < problem->cell_count; k++) {
        rest->pressures[k] = problem->cells[k].has_volume
                                 ? ldexp(rest->pressures[k] * l->tensions[0], -unit)
                                 : problem->cells[k].pressure;
    }
    for (size_t k = 0; k < ropes; k++) {
        const taut_film_edge *law = l->complex.ropes[k].edge;
        rest->forces[k] = law->law == TAUT_FILM_FORCE
                              ? law->force
                              : ldexp(w->energy->forces[k] * l->tensions[0], unit);
        rest->lengths[k] = ldexp(w->energy->lengths[k], unit);
    }
    return check_slack(w);
}

taut_status taut_film_rest_find(const taut_film_layout *layout, const taut_make_options *options,
                                taut_arena *arena, taut_film_rest *rest, taut_error *error)
{
    const taut_film_problem *problem = layout->complex.problem;
    const size_t nodes = (size_t)layout->complex.nodes, bytes = 3 * sizeof(double);
    const double tolerance =
        problem->tolerance > 0 ? fmin(problem->tolerance, tolerance_search) : 1e-10;
    work w = {.own = *layout,
              .given = layout->drawn,
              .pulse = {.monitor = &options->monitor, .what = "film", .done = taut_none},
              .crew = {.threads = options->threads, .pulse = &w.pulse},
              .error = error,
              .nodes = nodes,
              .x = taut_arena_copy(arena, layout->start, nodes, bytes),
              .next = taut_arena_take(arena, nodes, bytes),
              .scales = taut_arena_take(arena, nodes, sizeof(double)),
              .gradient = taut_arena_take(arena, nodes, bytes),
              .after = taut_arena_take(arena, nodes, bytes),
              .d = taut_arena_take(arena, nodes, bytes),
              .right = taut_arena_take(arena, nodes, bytes),
              .led_from = taut_arena_take(arena, nodes, bytes),
              .from = taut_arena_take(arena, nodes, bytes),
              .led = 1,
              .reach = blown,
              .is_fresh = 1,
              .soft = 1,
              .aim = fmin(aim_share * tolerance, 1e-7),
              .most = problem->max_iterations > 0 ? problem->max_iterations : ITERATIONS};

    taut_film_parting parting;

    w.layout = &w.own;
    w.own.drawn = taut_arena_copy(arena, layout->drawn, (size_t)layout->complex.rope_count,
                                  sizeof *layout->drawn);
    rest->points = taut_arena_take(arena, nodes, bytes);
    taut_status status = taut_arena_status(arena);
    if (status == TAUT_OK) {
        status = taut_film_border_new(layout, arena, &w.border);
    }
    const size_t borders = (size_t)layout->complex.problem->cell_count +
                           (size_t)layout->complex.rope_count; /* all that may be given */
    w.multipliers = taut_arena_take(arena, borders, sizeof(double));
    w.kept = taut_arena_take(arena, borders, sizeof(double));
    if (status == TAUT_OK) {
        status = taut_arena_status(arena);
    }
    if (status == TAUT_OK) {
        status = taut_film_pressure_check(layout, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_parting_new(layout, arena, &parting);
    }
    if (status == TAUT_OK) {
        status = taut_film_parting_check(layout, &parting, arena, error);
    }
    if (status == TAUT_OK) {
        status = find_film(&w, &parting, arena, rest);
    }
    if (status == TAUT_OK) {
        status = even_out(&w);
    }
    if (status == TAUT_OK) {
        status = check_turned(&w);
    }
    if (status == TAUT_OK) {
        status = find_doubt(&w, &parting, rest);
    }
    if (status == TAUT_OK) {
        status = taut_film_parting_discs(layout, &parting, arena, &rest->rival);
    }
    if (status == TAUT_OK) {
        rest->area = ldexp(w.value, 2 * (layout->scaling.outer + layout->scaling.inner));
        rest->energy = rest->area * layout->tensions[0];
        rest->unknowns = taut_sparse_rows(w.energy->sparse);
        rest->iterations = w.iterations;
        rest->method = w.method;
        rest->residual = w.residual;
        status = take_forces(&w, arena, rest);
    }
    if (status == TAUT_OK) {
        status = taut_scaling_undo(&layout->scaling, nodes, layout->points, layout->known, w.x,
                                   rest->points, error);
    }
    for (size_t a = 0; status == TAUT_OK && a < nodes; a++) {
        if (!layout->known[a]) {
            taut_film_hold_onto(&layout->complex.holds[a], rest->points + 3 * a);
        }
    }
    taut_film_energy_free(w.energy);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}
