#include "construct/plateau/trust_region_step.h"

#include "core/fail.h"

#include <math.h>
#include <string.h>

/* Areas carry rounding: below `blind` of the area a gain can't be seen in them, and a step is
 * judged by the gradient it leaves. */
static const double blind = 2e-14, rise = 0x1p-50;
/* A film is at rest where the model gains no more than `flat` of the area and the gradient is
 * within `flat_residual`: what is left are moves within the surface. */
static const double flat = 1e-15, flat_residual = 1e-6;
static const double unfolded = 0.02;
static const double slow = 0.1, small_theta = 1e-6;
enum { LONGEST = 256 };
enum { FLAT_STEPS = 4 }; /* steps that are still made there, for the sake of the residual */
/* Curvature below -slack of the metric operator makes a saddle; less is rounding and slack. */
static const double slack = 1e-6;
/* With a free edge, a film that has lost this much of its area is on its way to none. */
static const double shrunk = 0.1;

static void raise_theta(taut_walk *w, int tries)
{
    const double least = taut_film_solver_parts(w->solver) == 1 ? 1e-2 : 1e-9;
    w->theta = fmin(1, fmax(least, w->theta * 4 * tries));
}

/* After a good step: the next theta, not far below where B was indefinite. */
static void lower_theta(taut_walk *w)
{
    const double least = fmax(taut_film_solver_floor(w->solver), 1.5 * w->fence);
    w->theta = fmin(w->theta, fmax(least, 0.1 * w->theta));
    w->fence *= 0.25;
}

/* How precisely to solve: the steps converge fast near the end without wasted products before. */
static double forcing(const taut_walk *w)
{
    return fmin(0.1, fmax(1e-6, w->first_norm > 0 ? w->here.residual / w->first_norm : 0.1));
}

/* Has this descent cost what it may? Steps are as long as they are: films that fold need more Gauss
 * points, shorter steps and more of both. */
static int is_spent(const taut_walk *w)
{
    return w->descent->work + w->film->work - w->first_work > w->descent->work_max;
}

/* The step at the first theta that leaves B positive definite. */
static taut_status find_step(taut_walk *w)
{
    taut_status status = TAUT_OK;

    taut_film_solver_reduce(w->solver, w->here.gradient, w->right);
    for (size_t i = 0; i < w->size; i++) {
        w->right[i] = -w->right[i];
    }
    for (int tries = 1; tries < 40 && (tries == 1 || !is_spent(w)); tries++) {
        status =
            taut_film_solver_solve(w->solver, w->theta, forcing(w), w->right, w->step, &w->model);
        if (status != TAUT_NO_SOLUTION || w->theta >= 1) {
            break;
        }
        w->fence = w->theta;
        raise_theta(w, tries);
    }
    return status;
}

/* Is the net as good as moves within the surface allow? Only a small theta may say so. */
static int is_flat(const taut_walk *w)
{
    return w->model <= flat * w->here.value.area && w->here.residual <= flat_residual &&
           w->theta <= fmax(1e-6, taut_film_solver_floor(w->solver));
}

/* Does the steepest descent gain next to nothing as well? With g the gradient it is
 *     |g|^4 / (2 g.H g)
 * at best. The certificate asks the same, with gradients of its own. */
static int is_level(taut_walk *w)
{
    double square = 0, curvature = 0;

    taut_film_solver_reduce(w->solver, w->here.gradient, w->image);
    taut_film_solver_product(w->solver, 0, w->image, w->turn);
    square = taut_film_solver_dot(w->solver, w->image, w->image);
    curvature = taut_film_solver_dot(w->solver, w->image, w->turn);
    return square * square <= flat * w->here.value.area * curvature; /* half of what is asked */
}

/* Has the area come so near its least that steps are not worth making? The net still slides within
 * the surface, each step for less: five of them for a tenth of the tolerance, of the area. */
static int is_slow(const taut_walk *w)
{
    const double area = w->here.value.area;
    const double before = w->past[w->steps % TAUT_WALK_PAST];

    return w->steps >= TAUT_WALK_PAST && w->here.residual <= flat_residual &&
           w->theta <= fmax(small_theta, taut_film_solver_floor(w->solver)) &&
           before - area <= slow * w->descent->tolerance * area;
}

/* May the film rest here? Its slow sliding ends only where the surface is level as well. */
static int may_rest(taut_walk *w)
{
    if (w->flat_steps > FLAT_STEPS) {
        return 1;
    }
    if (!is_slow(w)) {
        return 0;
    }
    taut_walk_polish(w);
    return is_level(w);
}

/* Did the step keep what its model promised? Changes theta by how well it did. */
static int is_good(taut_walk *w)
{
    const double area = w->here.value.area, gain = area - w->there.value.area;
    const double ratio = gain / w->model;

    w->is_barred = w->there.value.least < w->barrier;
    if (w->is_barred) {
        return 0;
    }
    if (fmax(w->model, gain) > blind * area) {
        if (!(ratio > 0.05)) {
            return 0;
        }
        if (ratio > 0.75) {
            lower_theta(w);
        } else if (ratio < 0.25) {
            w->theta = fmin(1, 4 * w->theta);
        }
        return 1;
    }
    if (!(gain >= -rise * area) || !(w->there.residual < w->here.residual)) {
        return 0;
    }
    lower_theta(w);
    return 1;
}

/* Moves within the surface hardly change the area, and theta keeps their steps short: goes on along
 * the step to where Newton's own model ends, at most LONGEST times as far. Costs a product and a
 * look at the film, where another step costs factors. */
static int stretch_step(taut_walk *w)
{
    const double slope = taut_film_solver_dot(w->solver, w->step, w->right);
    double curvature = 0, length = LONGEST;

    if (w->theta == 0 || taut_film_solver_parts(w->solver) == 1 ||
        taut_film_solver_has_factors(w->solver)) {
        return 0;
    }
    taut_film_solver_product(w->solver, 0, w->step, w->image);
    curvature = taut_film_solver_dot(w->solver, w->step, w->image);
    if (curvature * LONGEST > slope) {
        length = slope / curvature;
    }
    for (; length > 1.5; length *= 0.25) {
        taut_walk_try(w, length);
        const double gain = w->here.value.area - w->there.value.area;
        if (isfinite(gain) && gain > fmax(w->model, 0x1p-51 * w->here.value.area)) {
            lower_theta(w);
            taut_walk_accept(w);
            return 1;
        }
    }
    taut_walk_look(w, &w->here);
    return 0;
}

/* One accepted step. TAUT_CHECK_FAILED: none is to be had; *at_rest: none is needed. */
static taut_status advance(taut_walk *w, int *at_rest)
{
    const double least = taut_film_solver_floor(w->solver);

    for (int tries = 1; tries < 60 && !is_spent(w); tries++) {
        const taut_status status = find_step(w);
        if (status != TAUT_OK) {
            return status == TAUT_NO_SOLUTION ? TAUT_CHECK_FAILED : status;
        }
        const int was_flat = is_flat(w);
        if (!was_flat && stretch_step(w)) {
            return TAUT_OK;
        }
        taut_walk_bend(w);
        if (isfinite(w->there.value.area) && is_good(w)) {
            taut_walk_accept(w);
            w->flat_steps += was_flat;
            *at_rest = may_rest(w);
            return TAUT_OK;
        }
        taut_walk_look(w, &w->here);
        if (was_flat) {
            *at_rest = 1;
            return TAUT_OK;
        }
        if (w->theta >= 1) {
            break;
        }
        raise_theta(w, tries);
    }
    *at_rest = w->model <= flat * w->here.value.area && w->here.residual <= flat_residual;
    w->theta = fmax(least, w->theta);
    return *at_rest ? TAUT_OK : TAUT_CHECK_FAILED;
}

/* A deterministic direction that no symmetry of the net shares. */
static void scatter(taut_walk *w, double *z)
{
    unsigned state = 12345;
    for (size_t i = 0; i < w->size; i++) {
        state = 1664525u * state + 1013904223u;
        z[i] = (double)(state >> 8) * 0x1p-24 - 0.5;
    }
    taut_film_solver_expand(w->solver, z, w->move);
    taut_film_solver_reduce(w->solver, w->move, z); /* zero at known points */
}

/* step = the direction of the least curvature over the metric operator, by inverse iteration at a
 * theta that is definite; returns that curvature. */
static double least_curvature(taut_walk *w)
{
    double gain = 0, against = 0, curvature = 0;

    scatter(w, w->step);
    for (int k = 0; k < 12; k++) {
        taut_film_solver_product(w->solver, 1, w->step, w->right);
        if (taut_film_solver_solve(w->solver, w->theta, 1e-2, w->right, w->step, &gain) !=
            TAUT_OK) {
            break;
        }
        const double size = taut_largest(w->size, w->step);
        for (size_t i = 0; size > 0 && i < w->size; i++) {
            w->step[i] /= size;
        }
    }
    taut_film_solver_product(w->solver, 0, w->step, w->right);
    curvature = taut_film_solver_dot(w->solver, w->step, w->right);
    taut_film_solver_product(w->solver, 1, w->step, w->right);
    against = taut_film_solver_dot(w->solver, w->step, w->right);
    return against > 0 ? curvature / against : 0;
}

/* Steps along +-step, the longest first, to where the area is less; 0 when there is no such place.
 */
static int step_off(taut_walk *w)
{
    for (double length = 1; length > 1e-4; length *= 0.5) {
        for (int side = 1; side >= -1; side -= 2) {
            taut_walk_try(w, side * length);
            if (w->there.value.area < w->here.value.area * (1 - 1e-13)) {
                taut_walk_accept(w);
                return 1;
            }
        }
    }
    taut_walk_look(w, &w->here);
    return 0;
}

/* Raises theta to where B is definite, to a tenth: with mu the least curvature over the metric
 * operator that is theta = -mu / (1 - mu), and far above it inverse iterations see all directions
 * alike. TAUT_NO_SOLUTION: there is none. */
static taut_status find_definite(taut_walk *w)
{
    double below = -1, gain = 0;
    taut_status status = TAUT_NO_SOLUTION;

    for (int tries = 0; status == TAUT_NO_SOLUTION && tries < 40 && below < 1; tries++) {
        if (tries > 0) {
            below = w->theta;
            raise_theta(w, tries);
        }
        scatter(w, w->right);
        status = taut_film_solver_solve(w->solver, w->theta, 0.05, w->right, w->step, &gain);
    }
    for (double above = w->theta; status == TAUT_OK && below >= 0 && above > 1.1 * below + 1e-9;) {
        w->theta = 0.5 * (below + above);
        status = taut_film_solver_solve(w->solver, w->theta, 0.05, w->right, w->step, &gain);
        if (status == TAUT_NO_SOLUTION) {
            below = w->theta;
            status = TAUT_OK;
        } else {
            above = w->theta;
        }
        w->theta = above;
    }
    return status;
}

/* At a net where the gradient vanishes: a minimum, or a saddle to be left. *at_rest: stay. */
static taut_status check_minimum(taut_walk *w, int *at_rest, taut_error *error)
{
    const double before = w->theta, normal = taut_film_solver_parts(w->solver) == 1 ? 0 : slack;
    double curvature = 0;
    taut_status status = TAUT_OK;

    *at_rest = 1;
    w->theta = normal;
    status = find_definite(w);
    if (status == TAUT_OK && w->theta > normal) {
        curvature = least_curvature(w);
        if (curvature < -slack) {
            *at_rest = 0;
            if (!step_off(w)) {
                status =
                    taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, curvature, -slack,
                              "the film stands on a saddle: its area has a direction of "
                              "negative curvature %.3g, but no step along it was found that "
                              "lowers the area; give another start",
                              curvature);
            }
        }
    }
    w->theta = *at_rest ? before : fmax(1e-2, w->theta);
    return status == TAUT_NO_SOLUTION ? TAUT_OK : status;
}

static taut_status check_film(const taut_walk *w, taut_error *error)
{
    const taut_descent *d = w->descent;
    const double area = w->here.value.area;

    if (d->has_free_edge && area < shrunk * w->start_area) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/points", area / w->start_area,
                         shrunk,
                         "a free edge lets the film shrink away: its area fell to %.3g of what "
                         "it was; make the points of that edge known",
                         area / w->start_area);
    }
    return taut_film_solver_report(w->solver);
}

/* Does all of the net move, the area hardly? Then *lost is what five steps take from it. */
static int is_creeping(const taut_walk *w, double *lost)
{
    const double area = w->here.value.area, before = w->past[w->steps % TAUT_WALK_PAST];

    *lost = w->steps >= TAUT_WALK_PAST ? (before - area) / area : 0;
    return taut_film_solver_parts(w->solver) > 1 && *lost > slow * w->descent->tolerance &&
           *lost < 1e-7;
}

static taut_status give_up(const taut_walk *w, const char *why, taut_error *error)
{
    const taut_descent *d = w->descent;
    double lost = 0;
    if (d->has_free_edge) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/points", w->here.residual,
                         d->tolerance,
                         "with a free edge the film finds no rest (%s, residual %.3g): there may "
                         "be no least area; make the points of that edge known",
                         why, w->here.residual);
    }
    if (w->is_barred || w->here.value.least < 1.5 * w->barrier) {
        const double next = w->is_barred ? w->there.value.least : w->here.value.least;
        const double least = fmin(next, w->here.value.least);
        return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, least, w->barrier,
                         "the film wants to fold: after %d iterations its smallest area element "
                         "goes to %.2g of the mean; take %sfewer points, or give points inside",
                         d->iterations, least,
                         taut_film_solver_parts(w->solver) == 1 ? ""
                                                                : "the method \"normal\", or ");
    }
    if (is_creeping(w, &lost)) {
        return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", "/tolerance", lost,
                         d->tolerance,
                         "%s after %d iterations, and five steps still lower the area by %.1e of "
                         "it, since the net slides within the surface: take the method \"normal\", "
                         "or a tolerance of %.0e",
                         why, d->iterations, lost, pow(10, ceil(log10(lost / slow))));
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, w->here.residual,
                     d->tolerance,
                     "%s after %d iterations: the residual is %.3g, expected at most %.3g; the "
                     "smallest area element is %.2g of the mean (0 where the film folds)",
                     why, d->iterations, w->here.residual, d->tolerance, w->here.value.least);
}

static void note_area(taut_walk *w)
{
    taut_descent *d = w->descent;
    if (d->areas_count < d->areas_max) {
        d->areas[d->areas_count++] = w->here.value.area;
    }
}

/* Steps until the film is at rest at a minimum. */
static taut_status descend(taut_walk *w, taut_error *error)
{
    taut_descent *d = w->descent;
    taut_status status = TAUT_OK;
    int at_rest = 0;

    taut_walk_look(w, &w->here);
    w->first_norm = w->here.residual;
    w->start_area = w->here.value.area;
    w->barrier = fmin(unfolded, 0.5 * w->here.value.least);
    w->model = 0;
    w->first_work = w->film->work;
    while (status == TAUT_OK && !at_rest) {
        status = check_film(w, error);
        if (status != TAUT_OK) {
            break;
        }
        if (w->here.residual <= d->tolerance && d->iterations <= d->max_iterations) {
            status = check_minimum(w, &at_rest, error);
            d->iterations += !at_rest;
            continue;
        }
        if (d->iterations >= d->max_iterations) {
            return give_up(w, "the most iterations allowed were made", error);
        }
        status = advance(w, &at_rest);
        d->iterations += !at_rest;
        note_area(w);
        if (at_rest) {
            status = check_minimum(w, &at_rest, error);
        }
        if (status == TAUT_CHECK_FAILED) {
            return give_up(
                w, is_spent(w) ? "the work allowed was done" : "no step lowers the area any more",
                error);
        }
    }
    return status;
}

taut_status taut_film_descend(taut_film *film, taut_film_solver *solver, taut_descent *descent,
                              double *net, taut_error *error)
{
    taut_walk w;
    taut_status status = taut_walk_new(film, solver, descent, net, &w);

    if (status == TAUT_OK) {
        status = descend(&w, error);
        if (status == TAUT_OK) {
            taut_walk_polish(&w);
        } else if (status == TAUT_INTERRUPTED) {
            status = taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                               "stopped on request");
        }
        descent->work += film->work - w.first_work;
        descent->area = w.here.value.area;
        descent->residual = w.here.residual;
        descent->gain = w.here.value.area > 0 ? w.model / w.here.value.area : 0;
    }
    taut_walk_clear(&w);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}
