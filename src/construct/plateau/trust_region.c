/* trust_region.c -- Newton's method for the least area, kept safe by the metric operator.
 *
 *     here = the net given;  theta = 1/100, 0 along directions
 *     repeat
 *         a free edge and hardly any area left: no solution
 *         |g| <= tolerance (check_minimum):
 *             theta = the least with (1 - theta) H + theta L_g positive definite
 *             none needed, or no curvature below -slack: done
 *             else step off the saddle along the direction of least curvature
 *         otherwise (advance), for theta, 4 theta, 16 theta ...:
 *             z = ((1 - theta) H + theta L_g)^-1 (-g), theta raised until this is definite
 *             by conjugate gradients: here + t z, t as far as Newton's own model falls, where that
 *                 gains more than z itself (stretch_step)
 *             by factors: here + t z + t^2 c, t doubled while the area falls (follow_curve)
 *             gain / model > 0.05: accept.  > 0.75: theta / 10, < 0.25: 4 theta
 *             gains below the resolution of the area: accept what lowers |g|
 *         the model has next to nothing to gain any more: done, after check_minimum
 *         no theta up to 1 gains, or the work or the iterations are spent: give up
 *     with factors: steps by the last ones for as long as each halves |g| (polish_residual)
 *
 * Trust regions: [NocedalWright2006] ch. 4; theta is their multiplier, in the norm of L_g. */
#include "construct/plateau/trust_region.h"

#include "core/arena.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"

#include <math.h>
#include <string.h>

enum {
    PAST = 5,        /* accepted steps whose areas are kept, for the slope of a slow end */
    FLAT_STEPS = 4,  /* steps that are still made where the area is flat, for the residual's sake */
    STEP_TRIES = 60, /* values of theta in one iteration: by factors 4, 8, 12 .. all are seen */
    THETA_TRIES = 40, /* values of theta until the operator is definite */
    CORRECTIONS = 3,  /* of the error along the normal, at the end of a curve */
    POLISHES = 6,     /* steps with the last factors */
    INVERSIONS = 12,  /* inverse iterations for a direction: it need not be precise */
};

/* What decides. Shares are of the area of the net at hand, residuals relative to the largest
 * derivative anywhere in the net (trust_region.h). */
static const struct {
    double area_resolution; /* share: gains below it are lost in the sum over Gauss points */
    double area_rise;       /* share: what rounding alone may add */
    double gain_flat;     /* share: a model that promises less has moves within the surface left */
    double residual_flat; /* residual: only below it a net may count as flat or slow */
    double residual_enough; /* residual: only below it the caller's `gain_enough` ends it */
    double loss_slow;       /* of the tolerance: share that PAST slow steps take at most */
    double loss_last; /* of what the steps took since `rest_from`: the last one may take so much */
    double loss_creeping;   /* share: PAST steps that take less move the net, hardly the area */
    double theta_small;     /* only steps nearly Newton's may say that nothing is left to gain */
    double theta_first;     /* some of the metric operator to begin with, and behind a saddle */
    double ratio_least;     /* gain over model: below it the step is refused */
    double ratio_good;      /* above it the model is trusted more */
    double ratio_poor;      /* below it, less */
    double element_least;   /* smallest area element over the mean: less is on its way to a fold */
    double curvature_slack; /* over the metric operator: above minus this is rounding, no saddle */
    double area_shrunk;     /* of the first area: with a free edge, on its way to none */
    double forcing_least;   /* residual of a step by conjugate gradients: beyond it only products */
    double forcing_most;    /* the same far from the end: enough for a step downhill */
    double forcing_probe;   /* the same where only the sign of the curvature is asked for */
    double forcing_inverse; /* the same for inverse iterations, whose directions may be rough */
    double stretch_most;    /* lengths of a step by conjugate gradients: doubles of digits lost */
    double curve_most;      /* lengths of a step by factors */
    double correction_gain; /* of the step's gain: a correction that brings less is the last */
    double gain_visible;    /* share: a gain that the area itself must show */
    double saddle_drop;     /* share: by so much the area falls when a saddle was left */
    double saddle_shortest; /* of the largest coordinate's unit: the shortest step off a saddle */
} limits = {
    .area_resolution = 2e-14,
    .area_rise = 0x1p-50,
    .gain_flat = 1e-15,
    .residual_flat = 1e-6,
    .residual_enough = 8e-7,
    .loss_slow = 0.1,
    .loss_last = 4e-3,
    .loss_creeping = 1e-7,
    .theta_small = 1e-6,
    .theta_first = 1e-2,
    .ratio_least = 0.05,
    .ratio_good = 0.75,
    .ratio_poor = 0.25,
    .element_least = 0.02,
    .curvature_slack = 1e-6,
    .area_shrunk = 0.1,
    .forcing_least = 1e-6,
    .forcing_most = 0.1,
    .forcing_probe = 0.05,
    .forcing_inverse = 1e-2,
    .stretch_most = 256,
    .curve_most = 65536,
    .correction_gain = 0.1,
    .gain_visible = 0x1p-51,
    .saddle_drop = 1e-13,
    .saddle_shortest = 1e-4,
};

/* A net, and what is known of it. */
typedef struct point {
    taut_area_value value;
    double *net, *gradient; /* [nu][nv][3] */
    double residual;
} point;

typedef struct state {
    taut_area_functional *functional;
    taut_newton_step *newton;
    taut_trust_region *region;
    size_t count, size;                  /* points; unknowns */
    point here, there;                   /* where it stands; the net that is tried */
    double *right, *step, *image, *turn; /* unknowns */
    double *move, *bend;                 /* nets */
    double theta, used;                  /* the next step's; that of the last one */
    int has_solved;                      /* a system: there are factors */
    double model;                        /* what the quadratic model says the step gains */
    double first_norm;                   /* residual at the start */
    double start_area, work_done;        /* area and work of the functional at the start */
    double barrier; /* no step may take the smallest area element, over the mean, below this */
    double fence;   /* the operator was last seen indefinite at this theta; forgotten by and by */
    double past[PAST];
    int steps, flat_steps;
    int is_barred; /* the last step tried went below the barrier */
} state;

static double largest_of(size_t count, const double *x)
{
    double largest = 0;
    for (size_t i = 0; i < count; i++) {
        largest = fmax(largest, fabs(x[i]));
    }
    return largest;
}

/* Area, gradient and residual of the point's net; the functional's operators are its own from now
 * on. */
static void evaluate_point(state *s, point *at)
{
    at->value = taut_area_functional_gradient(s->functional, at->net, at->gradient);
    taut_newton_step_reduce(s->newton, at->gradient, s->image);
    const double all = largest_of(3 * s->count, at->gradient);
    at->residual = all > 0 ? largest_of(s->size, s->image) / all : 0;
}

/* there = here + factor step. */
static void try_step(state *s, double factor)
{
    taut_newton_step_expand(s->newton, s->step, s->move);
    for (size_t i = 0; i < 3 * s->count; i++) {
        s->there.net[i] = s->here.net[i] + factor * s->move[i];
    }
    evaluate_point(s, &s->there);
}

/* here = there. The nets stay where they are, since here's is the caller's; the rest changes hands.
 */
static void accept_trial(state *s)
{
    double *const gradient = s->here.gradient;
    s->past[s->steps++ % PAST] = s->here.value.area;
    memcpy(s->here.net, s->there.net, 3 * s->count * sizeof(double));
    s->here.gradient = s->there.gradient;
    s->there.gradient = gradient;
    s->here.value = s->there.value;
    s->here.residual = s->there.residual;
    taut_newton_step_renew(s->newton);
}

/* ---- steps by factors, along the valley of least area ----
 *
 * Moves within the surface hardly change its area, but a straight one of length d leaves the
 * surface by d^2 along the normal, where the area is stiff: straight steps have to be short, and
 * the net creeps. A curve keeps to the surface. With z the step, B z = -g, and g(.) the gradient,
 *
 *     x(t) = x + t z + t^2 c,     B c = -(g(x + z) - g - H z)
 *
 * c undoes the second-order part of the gradient at x + z ([NocedalWright2006] 18.3, second-order
 * correction), so the error along the normal is d^3. t is doubled while the area falls; then steps
 * with the same factors, -B^-1 g, take away what error is left. Each costs a look at the area,
 * where another Newton step costs factors. */

static taut_area_value value_along(state *s, double t)
{
    for (size_t i = 0; i < 3 * s->count; i++) {
        s->there.net[i] = s->here.net[i] + t * (s->move[i] + t * s->bend[i]);
    }
    return taut_area_functional_value(s->functional, s->there.net);
}

/* bend = c, move = z as nets. The functional's state must be here's: it is that of x + z
 * afterwards. */
static void find_curve(state *s)
{
    taut_newton_step_product(s->newton, 0, s->step, s->turn);
    try_step(s, 1);
    taut_newton_step_reduce(s->newton, s->there.gradient, s->image);
    for (size_t i = 0; i < s->size; i++) {
        s->turn[i] -= s->image[i] + s->right[i]; /* right = -g */
    }
    taut_newton_step_again(s->newton, s->turn);
    taut_newton_step_expand(s->newton, s->step, s->move);
    taut_newton_step_expand(s->newton, s->turn, s->bend);
}

/* at.net -= B^-1 gradient; the move that was made is in s->bend. */
static void correct_point(state *s, point *at)
{
    taut_newton_step_reduce(s->newton, at->gradient, s->turn);
    taut_newton_step_again(s->newton, s->turn);
    taut_newton_step_expand(s->newton, s->turn, s->bend);
    for (size_t i = 0; i < 3 * s->count; i++) {
        at->net[i] -= s->bend[i];
    }
    evaluate_point(s, at);
}

static void undo_correction(state *s, point *at)
{
    for (size_t i = 0; i < 3 * s->count; i++) {
        at->net[i] += s->bend[i];
    }
    evaluate_point(s, at);
}

/* there = the best place found along the curve that begins with the step at hand, whose factors are
 * still those of its B; here + step where there are no factors, or no place is better than here. */
static void follow_curve(state *s)
{
    double best = s->here.value.area, t = 0;

    if (!taut_newton_step_has_factors(s->newton)) {
        try_step(s, 1);
        return;
    }
    find_curve(s);
    for (double longer = 1; longer <= limits.curve_most; longer *= 2) {
        const taut_area_value value = value_along(s, longer);
        if (!(value.area < best) || value.least < s->barrier) {
            break;
        }
        best = value.area;
        t = longer;
    }
    value_along(s, t);
    if (t == 0) {
        try_step(s, 1);
        return;
    }
    evaluate_point(s, &s->there);
    for (int k = 0; k < CORRECTIONS; k++) {
        const double before = s->there.value.area;
        correct_point(s, &s->there);
        if (!(s->there.value.area < before) || s->there.value.least < s->barrier) {
            undo_correction(s, &s->there);
            break;
        }
        if (before - s->there.value.area <
            limits.correction_gain * (s->here.value.area - s->there.value.area)) {
            break;
        }
    }
}

/* Steps with the factors at hand for as long as each halves the residual. */
static void polish_residual(state *s)
{
    int goes_on = s->has_solved && taut_newton_step_has_factors(s->newton);

    for (int k = 0; goes_on && k < POLISHES; k++) {
        const double before = s->here.residual, area = s->here.value.area;
        correct_point(s, &s->here);
        goes_on = s->here.residual < 0.5 * before;
        if (!(s->here.residual < before) ||
            !(s->here.value.area <= area * (1 + limits.area_rise))) {
            undo_correction(s, &s->here);
            goes_on = 0;
        }
    }
    taut_newton_step_renew(s->newton);
}

/* ---- theta ---- */

static int is_along_directions(const state *s)
{
    return taut_newton_step_parts(s->newton) == 1;
}

/* Below this theta the operator is as good as Newton's own. */
static double small_theta(const state *s)
{
    const double given = fmax(taut_newton_step_floor(s->newton), s->region->theta_least);
    return fmax(limits.theta_small, given);
}

static void raise_theta(state *s, int tries)
{
    const double least = is_along_directions(s) ? 1e-2 : 1e-9;
    s->theta = fmin(1, fmax(least, s->theta * 4 * tries));
}

/* After a good step: the next theta, not far below where B was indefinite. */
static void lower_theta(state *s)
{
    const double given = fmax(taut_newton_step_floor(s->newton), s->region->theta_least);
    const double least = fmax(given, 1.5 * s->fence);
    s->theta = fmin(s->theta, fmax(least, 0.1 * s->theta));
    s->fence *= 0.25;
}

/* How precisely to solve: the steps converge fast near the end without wasted products before. */
static double forcing_term(const state *s)
{
    return fmin(limits.forcing_most,
                fmax(limits.forcing_least,
                     s->first_norm > 0 ? s->here.residual / s->first_norm : limits.forcing_most));
}

/* Has this call cost what it may? Steps are as long as they are: nets that fold need more Gauss
 * points, shorter steps and more of both. */
static int is_spent(const state *s)
{
    return s->region->work + s->functional->work - s->work_done > s->region->work_max;
}

/* The step at the first theta that leaves B positive definite. */
static taut_status find_step(state *s)
{
    taut_status status = TAUT_OK;

    taut_newton_step_reduce(s->newton, s->here.gradient, s->right);
    for (size_t i = 0; i < s->size; i++) {
        s->right[i] = -s->right[i];
    }
    for (int tries = 1; tries < THETA_TRIES && (tries == 1 || !is_spent(s)); tries++) {
        s->used = s->theta;
        s->has_solved = 1;
        status = taut_newton_step_solve(s->newton, s->theta, forcing_term(s), s->right, s->step,
                                        &s->model);
        if (status != TAUT_NO_SOLUTION || s->theta >= 1) {
            break;
        }
        s->fence = s->theta;
        raise_theta(s, tries);
    }
    return status;
}

/* ---- may the net rest? ---- */

/* Has the model next to nothing to gain? What is left are moves within the surface. */
static int gains_nothing(const state *s)
{
    return s->model <= limits.gain_flat * s->here.value.area &&
           s->here.residual <= limits.residual_flat;
}

/* Is the net as good as moves within the surface allow? Only a small theta may say so. */
static int is_flat(const state *s)
{
    return gains_nothing(s) && s->theta <= small_theta(s);
}

/* Does the steepest descent gain next to nothing as well? With g the gradient it is
 *     |g|^4 / (2 g.H g)
 * at best. The certificate asks the same, with gradients of its own. */
static int is_level(state *s)
{
    double square = 0, curvature = 0;

    taut_newton_step_reduce(s->newton, s->here.gradient, s->image);
    taut_newton_step_product(s->newton, 0, s->image, s->turn);
    square = taut_newton_step_dot(s->newton, s->image, s->image);
    curvature = taut_newton_step_dot(s->newton, s->image, s->turn);
    return square * square <=
           limits.gain_flat * s->here.value.area * curvature; /* half of what is asked */
}

/* Does the net come to the barrier, or to it with the next step? Then that may be why a model gains nothing. */
static int is_folding(const state *s)
{
    return s->is_barred || s->here.value.least < 1.5 * s->barrier;
}

/* Does one step tell that the net may rest? */
static int rests_by_step(const state *s)
{
    return s->region->rest_step > 0 && !is_along_directions(s);
}

/* Has the area come so near its least that steps are not worth making? The net still slides within
 * the surface, each step for less. */
static int is_slow(const state *s)
{
    const int is_one = rests_by_step(s), steps = is_one ? 1 : PAST;
    const double area = s->here.value.area;
    const double before = s->past[(s->steps + PAST - steps) % PAST];
    const double share = is_one ? s->region->rest_step : limits.loss_slow * s->region->tolerance;
    const double enough = is_one ? limits.loss_last * (s->region->rest_from - area) : 0;

    return s->steps >= steps && s->here.residual <= limits.residual_flat &&
           (is_one || s->theta <= small_theta(s)) && before - area <= fmax(enough, share * area);
}

/* May the net rest here? Its slow sliding ends only where the surface is level as well. */
static int may_rest(state *s)
{
    if (s->flat_steps > FLAT_STEPS) {
        return 1;
    }
    if (!is_slow(s)) {
        return 0;
    }
    polish_residual(s);
    return is_level(s);
}

/* Does the caller have enough, after a step that began at this area? */
static int is_enough(const state *s, double before)
{
    const double area = s->here.value.area;
    const double residual =
        s->region->residual_enough > 0 ? s->region->residual_enough : limits.residual_enough;
    return s->region->gain_enough > 0 && s->steps >= s->region->patience &&
           s->here.residual <= residual && before - area <= s->region->gain_enough * area &&
           !(s->region->theta_enough > 0 && s->used > s->region->theta_enough);
}

/* ---- one iteration ---- */

/* Did the step keep what its model promised? Changes theta by how well it did. */
static int is_good(state *s)
{
    const double area = s->here.value.area, gain = area - s->there.value.area;
    const double ratio = gain / s->model;

    s->is_barred = s->there.value.least < s->barrier;
    if (s->is_barred) {
        return 0;
    }
    if (fmax(s->model, gain) > limits.area_resolution * area) {
        if (!(ratio > limits.ratio_least)) {
            return 0;
        }
        if (ratio > limits.ratio_good) {
            lower_theta(s);
        } else if (ratio < limits.ratio_poor) {
            s->theta = fmin(1, 4 * s->theta);
        }
        return 1;
    }
    if (!(gain >= -limits.area_rise * area) || !(s->there.residual < s->here.residual)) {
        return 0;
    }
    lower_theta(s);
    return 1;
}

/* Moves within the surface hardly change the area, and theta keeps their steps short: goes on along
 * the step to where Newton's own model ends. Costs a product and a look at the area, where another
 * step costs many products. */
static int stretch_step(state *s)
{
    const double slope = taut_newton_step_dot(s->newton, s->step, s->right);
    double curvature = 0, length = limits.stretch_most;

    if (s->theta == 0 || is_along_directions(s) || taut_newton_step_has_factors(s->newton)) {
        return 0;
    }
    taut_newton_step_product(s->newton, 0, s->step, s->image);
    curvature = taut_newton_step_dot(s->newton, s->step, s->image);
    if (curvature * limits.stretch_most > slope) {
        length = slope / curvature;
    }
    for (; length > 1.5; length *= 0.25) {
        try_step(s, length);
        const double gain = s->here.value.area - s->there.value.area;
        if (isfinite(gain) && gain > fmax(s->model, limits.gain_visible * s->here.value.area)) {
            lower_theta(s);
            accept_trial(s);
            return 1;
        }
    }
    evaluate_point(s, &s->here);
    return 0;
}

/* One accepted step. TAUT_CHECK_FAILED: none is to be had; *at_rest: none is needed. */
static taut_status advance(state *s, int *at_rest)
{
    const double least = taut_newton_step_floor(s->newton);

    for (int tries = 1; tries < STEP_TRIES && !is_spent(s); tries++) {
        const taut_status status = find_step(s);
        if (status != TAUT_OK) {
            return status == TAUT_NO_SOLUTION ? TAUT_CHECK_FAILED : status;
        }
        const int was_flat = is_flat(s);
        if (!was_flat && stretch_step(s)) {
            *at_rest = rests_by_step(s) && may_rest(s);
            return TAUT_OK;
        }
        follow_curve(s);
        if (isfinite(s->there.value.area) && is_good(s)) {
            accept_trial(s);
            s->flat_steps += was_flat;
            *at_rest = may_rest(s);
            return TAUT_OK;
        }
        evaluate_point(s, &s->here);
        if (was_flat) {
            *at_rest = 1;
            return TAUT_OK;
        }
        if (s->theta >= 1) {
            break;
        }
        raise_theta(s, tries);
    }
    *at_rest = gains_nothing(s) && (!is_folding(s) || is_level(s));
    s->theta = fmax(least, s->theta);
    return *at_rest ? TAUT_OK : TAUT_CHECK_FAILED;
}

/* ---- minimum or saddle? ---- */

/* A deterministic direction that no symmetry of the net shares. */
static void scatter_direction(state *s, double *z)
{
    unsigned seed = 12345;
    for (size_t i = 0; i < s->size; i++) {
        seed = 1664525u * seed + 1013904223u;
        z[i] = (double)(seed >> 8) * 0x1p-24 - 0.5;
    }
    taut_newton_step_expand(s->newton, z, s->move);
    taut_newton_step_reduce(s->newton, s->move, z); /* zero at known points */
}

/* step = the direction of the least curvature over the metric operator, by inverse iteration at a
 * theta that is definite; returns that curvature. */
static double least_curvature(state *s)
{
    double gain = 0, against = 0, curvature = 0;

    scatter_direction(s, s->step);
    for (int k = 0; k < INVERSIONS; k++) {
        taut_newton_step_product(s->newton, 1, s->step, s->right);
        if (taut_newton_step_solve(s->newton, s->theta, limits.forcing_inverse, s->right, s->step,
                                   &gain) != TAUT_OK) {
            break;
        }
        const double size = largest_of(s->size, s->step);
        for (size_t i = 0; size > 0 && i < s->size; i++) {
            s->step[i] /= size;
        }
    }
    taut_newton_step_product(s->newton, 0, s->step, s->right);
    curvature = taut_newton_step_dot(s->newton, s->step, s->right);
    taut_newton_step_product(s->newton, 1, s->step, s->right);
    against = taut_newton_step_dot(s->newton, s->step, s->right);
    return against > 0 ? curvature / against : 0;
}

/* Steps along +-step, the longest first, to where the area is less; 0 when there is no such place.
 */
static int step_off(state *s)
{
    for (double length = 1; length > limits.saddle_shortest; length *= 0.5) {
        for (int side = 1; side >= -1; side -= 2) {
            try_step(s, side * length);
            if (s->there.value.area < s->here.value.area * (1 - limits.saddle_drop)) {
                accept_trial(s);
                return 1;
            }
        }
    }
    evaluate_point(s, &s->here);
    return 0;
}

/* Raises theta to where B is definite, to a tenth: with mu the least curvature over the metric
 * operator that is theta = -mu / (1 - mu), and far above it inverse iterations see all directions
 * alike. TAUT_NO_SOLUTION: there is none. */
static taut_status find_definite(state *s)
{
    double below = -1, gain = 0;
    taut_status status = TAUT_NO_SOLUTION;

    s->has_solved = 1;
    for (int tries = 0; status == TAUT_NO_SOLUTION && tries < THETA_TRIES && below < 1; tries++) {
        if (tries > 0) {
            below = s->theta;
            raise_theta(s, tries);
        }
        scatter_direction(s, s->right);
        status = taut_newton_step_solve(s->newton, s->theta, limits.forcing_probe, s->right,
                                        s->step, &gain);
    }
    for (double above = s->theta; status == TAUT_OK && below >= 0 && above > 1.1 * below + 1e-9;) {
        s->theta = 0.5 * (below + above);
        status = taut_newton_step_solve(s->newton, s->theta, limits.forcing_probe, s->right,
                                        s->step, &gain);
        if (status == TAUT_NO_SOLUTION) {
            below = s->theta;
            status = TAUT_OK;
        } else {
            above = s->theta;
        }
        s->theta = above;
    }
    return status;
}

/* Leaves a saddle, if it is one: *at_rest becomes 0. */
static taut_status leave_saddle(state *s, int *at_rest, taut_error *error)
{
    const double curvature = least_curvature(s);

    if (taut_newton_step_is_stopped(s->newton)) {
        return TAUT_INTERRUPTED;
    }
    if (!(curvature < -limits.curvature_slack)) {
        return TAUT_OK;
    }
    *at_rest = 0;
    if (step_off(s)) {
        return TAUT_OK;
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, "saddle", NULL, curvature, -limits.curvature_slack,
                     "the film is at a saddle: its area has a direction of "
                     "negative curvature %.3g, but no step along it was found that "
                     "lowers the area; give another start",
                     curvature);
}

/* At a net where the gradient vanishes: a minimum, or a saddle to be left. *at_rest: stay. */
static taut_status check_minimum(state *s, int *at_rest, taut_error *error)
{
    const double before = s->theta;
    const double normal = is_along_directions(s) ? 0 : limits.curvature_slack;
    taut_status status = TAUT_OK;

    *at_rest = 1;
    if (s->region->is_minimum) {
        return TAUT_OK;
    }
    s->theta = normal;
    status = find_definite(s);
    if (status == TAUT_OK && s->theta > normal) {
        status = leave_saddle(s, at_rest, error);
    }
    s->theta = *at_rest ? before : fmax(limits.theta_first, s->theta);
    return status == TAUT_NO_SOLUTION ? TAUT_OK : status;
}

/* ---- the whole ---- */

/* May it go on? Not where the surface shrinks away, nor when asked to stop. */
static taut_status check_progress(const state *s, taut_error *error)
{
    const double area = s->here.value.area;

    if (s->region->has_free_edge && area < limits.area_shrunk * s->start_area) {
        return taut_fail(error, TAUT_NO_SOLUTION, "free-edge", "/points", area / s->start_area,
                         limits.area_shrunk,
                         "a free edge lets the film shrink away: its area fell to %.3g of what "
                         "it was; make the points of that edge known",
                         area / s->start_area);
    }
    return taut_newton_step_report(s->newton);
}

/* Does all of the net move, the area hardly? Then *lost is what PAST steps take from it. */
static int is_creeping(const state *s, double *lost)
{
    const double area = s->here.value.area, before = s->past[s->steps % PAST];

    *lost = s->steps >= PAST ? (before - area) / area : 0;
    return !is_along_directions(s) && *lost > limits.loss_slow * s->region->tolerance &&
           *lost < limits.loss_creeping;
}

/* What ended the iterations: its reason, and how a sentence says it. */
typedef struct ending {
    const char *reason, *sentence;
} ending;

static taut_status give_up(const state *s, ending why, taut_error *error)
{
    const taut_trust_region *region = s->region;
    double lost = 0;
    if (region->has_free_edge) {
        return taut_fail(error, TAUT_NO_SOLUTION, "free-edge", "/points", s->here.residual,
                         region->tolerance,
                         "with a free edge the film finds no rest (%s, residual %.3g): there may "
                         "be no least area; make the points of that edge known",
                         why.sentence, s->here.residual);
    }
    if (is_folding(s)) {
        const double next = s->is_barred ? s->there.value.least : s->here.value.least;
        const double least = fmin(next, s->here.value.least);
        return taut_fail(error, TAUT_NOT_CONVERGED, "folds", NULL, least, s->barrier,
                         "the film wants to fold: after %d iterations its smallest area element "
                         "goes to %.2g of the mean; take %sa higher degree, fewer points, or "
                         "give points inside",
                         region->iterations, least,
                         is_along_directions(s) ? "" : "the method \"normal\", or ");
    }
    if (is_creeping(s, &lost)) {
        return taut_fail(error, TAUT_NOT_CONVERGED, "slides", "/tolerance", lost, region->tolerance,
                         "%s after %d iterations, and five steps still lower the area by %.1e of "
                         "it, since the net slides within the surface: take the method \"normal\", "
                         "or a tolerance of %.0e",
                         why.sentence, region->iterations, lost,
                         taut_pow(10, ceil(taut_log10(lost / limits.loss_slow))));
    }
    return taut_fail(
        error, TAUT_NOT_CONVERGED, why.reason, NULL, s->here.residual, region->tolerance,
        "%s after %d iterations: the residual is %.3g, expected at most %.3g; the "
        "smallest area element is %.2g of the mean (0 where the film folds)",
        why.sentence, region->iterations, s->here.residual, region->tolerance, s->here.value.least);
}

static void note_area(state *s)
{
    taut_trust_region *region = s->region;
    if (region->areas_count < region->areas_max) {
        region->areas[region->areas_count++] = s->here.value.area;
    }
}

/* Steps until the net is at rest at a minimum. */
static taut_status iterate(state *s, taut_error *error)
{
    static const ending limit = {.reason = "iterations",
                                 .sentence = "the most iterations allowed were made"};
    static const ending spent = {.reason = "work", .sentence = "the work allowed was done"};
    static const ending stuck = {.reason = "no-step",
                                 .sentence = "no step lowers the area any more"};
    taut_trust_region *region = s->region;

    for (int at_rest = 0; !at_rest;) {
        taut_status status = check_progress(s, error);
        if (status != TAUT_OK) {
            return status;
        }
        if (s->here.residual <= region->tolerance && region->iterations <= region->max_iterations) {
            status = check_minimum(s, &at_rest, error);
            region->iterations += !at_rest;
            if (status != TAUT_OK) {
                return status;
            }
            continue;
        }
        if (region->iterations >= region->max_iterations) {
            return give_up(s, limit, error);
        }
        const double before = s->here.value.area;
        const int steps = s->steps;
        status = advance(s, &at_rest);
        region->iterations += rests_by_step(s) ? s->steps > steps : !at_rest;
        note_area(s);
        const int has_enough = status == TAUT_OK && is_enough(s, before);
        at_rest = at_rest || has_enough;
        if (at_rest &&
            !(has_enough && s->used <= limits.curvature_slack)) { /* else it was definite */
            status = check_minimum(s, &at_rest, error);
        }
        if (status == TAUT_CHECK_FAILED) {
            return give_up(s, is_spent(s) ? spent : stuck, error);
        }
        if (status != TAUT_OK) {
            return status;
        }
    }
    return TAUT_OK;
}

/* The net to start from becomes here's, and stays the caller's. TAUT_NO_MEMORY. */
static taut_status start_state(taut_area_functional *functional, taut_newton_step *newton,
                               taut_trust_region *region, double *net, taut_arena *arena, state *s)
{
    const size_t count = (size_t)functional->nu * (size_t)functional->nv;
    const size_t size = (size_t)taut_newton_step_parts(newton) * count;

    memset(s, 0, sizeof *s);
    s->functional = functional;
    s->newton = newton;
    s->region = region;
    s->count = count;
    s->size = size;
    s->here.net = net;
    s->here.gradient = taut_arena_take(arena, 3 * count, sizeof(double));
    s->there.gradient = taut_arena_take(arena, 3 * count, sizeof(double));
    s->there.net = taut_arena_take(arena, 3 * count, sizeof(double));
    s->right = taut_arena_take(arena, size, sizeof(double));
    s->step = taut_arena_take(arena, size, sizeof(double));
    s->image = taut_arena_take(arena, size, sizeof(double));
    s->turn = taut_arena_take(arena, size, sizeof(double));
    s->move = taut_arena_take(arena, 3 * count, sizeof(double));
    s->bend = taut_arena_take(arena, 3 * count, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    evaluate_point(s, &s->here);
    s->theta = is_along_directions(s) ? 0 : region->theta > 0 ? region->theta : limits.theta_first;
    s->first_norm = s->here.residual;
    s->start_area = s->here.value.area;
    s->barrier = fmin(limits.element_least, 0.5 * s->here.value.least);
    s->work_done = functional->work;
    return TAUT_OK;
}

static taut_status minimise(taut_area_functional *functional, taut_newton_step *newton,
                            taut_trust_region *region, double *net, taut_arena *arena,
                            taut_error *error)
{
    state s;
    taut_status status = start_state(functional, newton, region, net, arena, &s);

    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = iterate(&s, error);
    if (status == TAUT_OK) {
        polish_residual(&s);
    }
    region->work += functional->work - s.work_done;
    region->area = s.here.value.area;
    region->theta_next = s.theta;
    region->residual = s.here.residual;
    region->gain = s.here.value.area > 0 ? s.model / s.here.value.area : 0;
    if (status == TAUT_INTERRUPTED) {
        return taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                         "stopped on request");
    }
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}

taut_status taut_trust_region_minimise(taut_area_functional *functional, taut_newton_step *newton,
                                       taut_trust_region *region, double *net, taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status = minimise(functional, newton, region, net, arena, error);

    taut_arena_free(arena);
    return status;
}
