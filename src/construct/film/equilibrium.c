/* equilibrium.c -- from a net to the film at rest.
 *
 *     rule = 1 node more than functions alive on a span
 *     repeat
 *         minimise A + sum r_k L_k from net (construct/plateau/trust_region.h)
 *         a few steps along the moves that this sees (construct/film/polish.h)
 *         cables that give way come to their laws (enforce_laws)
 *         the film has a fold: fail
 *         the next rule
 *     until three in turn give the same energy, and derivatives within the tolerance
 *
 * A cable of given length begins as an elastic one that has this length under the force of the arc
 * of a circle over its chord; steps of the multiplier,
 *
 *     r_0 += (dL B^-1 dL^T)^-1 (L - L_0),    B the second derivative of all along the moves,
 *
 * which are Newton's for the film with the constraint, bring it to its length. A stiff elastic cable
 * begins with less stiffness.
 *
 * Area does not see moves within the surface. The multiplier of the trust region is that of the
 * metric operator L_g, which does: of all steps that the area holds for equal it takes the one
 * whose moves are smoothest, so that what a cable does at the edge is carried inside by the
 * harmonic extension of the metric, and the net does not fold behind it.
 */
#include "construct/film/equilibrium.h"

#include "construct/film/arc.h"
#include "construct/film/meeting.h"
#include "construct/film/polish.h"
#include "construct/film/threads.h"
#include "construct/plateau/newton_step.h"
#include "construct/plateau/small.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/pulse.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    RULES = 9,
    AGREEING = 3 /* rules, since one may agree by chance */,
    POLISHES = 6,
    MULTIPLIERS = 40,
    SEEKS = 20,
    SEEKS_ALL = 8,
    GAUGES = 40,
    APPROACH = 12
};

/* Nodes on a span beyond the functions alive there. */
static const int extra_nodes[RULES] = {1, 3, 5, 8, 11, 14, 20, 34, 68};
static const double energy_agreement = 1e-13; /* share: two rules that agree */
static const double energy_near = 1e-9;       /* share: a few steps lead from one to the next */
static const double residual_agreement = 0.1; /* of the tolerance */
static const double residual_settled = 0.01;  /* of the tolerance: no step more is worth its cost */
static const double residual_any = 1e-8;      /* of all coordinates: the certificate allows 1e-6 */
static const double residual_held = 1e-7;     /* the same where no line slides along itself */
static const double residual_rough = 1e-3;    /* of all coordinates, by the method `normal` */
static const double force_none =
    1e-9; /* of the tension and half the size: a cable that holds nothing */
static const double guide_room = 1e-12; /* of half the size: above the rounding of sound steps */
/* Of given lengths: share. Rounding is 1e-15, the certificate's limit 1e-10. */
static const double length_agreement = 1e-12;
/* Stiffness of a cable at the start, over force / length. A film of a given length is stable where
 * one of given force is not, beyond half a circle: this makes it convex up to a whole one. */
static const double stiffness_first = 2;
static const double stiffness_closed = 20; /* of cables that close, whose force is a worse guess */

double taut_film_chord(const taut_film_space *space, int e)
{
    size_t first = 0, step = 0;
    int count = 0;

    taut_film_edge_points(space->nu, space->nv, e, &first, &step, &count);
    return taut_distance(space->start + 3 * first,
                         space->start + 3 * (first + ((size_t)count - 1) * step));
}

double taut_film_strong_length(const taut_film_space *space, int e, double strength)
{
    const double chord = taut_film_chord(space, e);
    return chord + (space->cables[e].length - chord) / (strength * strength);
}

/* What cable e is given, so strong; returns the force of its arc. */
static double strengthen(const taut_film_space *space, int e, double strength,
                         taut_film_cable *cable)
{
    double ratio = space->ratios[e];

    *cable = space->cables[e];
    if (strength != 1 && cable->length > 0) {
        const double chord = taut_film_chord(space, e);
        cable->length = cable->start = taut_film_strong_length(space, e, strength);
        const double angle = cable->length > chord ? taut_film_arc_angle(chord, cable->length) : 0;
        ratio = angle > 0 ? fmin(TAUT_FILM_FORCE_MAX, chord / (2 * taut_sin(angle)))
                          : TAUT_FILM_FORCE_MAX;
    } else if (strength != 1 && cable->stiffness > 0) {
        cable->target -= (strength - 1) * ratio / cable->stiffness;
        ratio *= strength;
    }
    return ratio;
}

void taut_film_start_laws(taut_film_work *w, double strength)
{
    w->strength = strength;
    for (int e = 0; e < 4; e++) {
        taut_film_cable *cable = &w->now[e];
        const double force = strengthen(w->space, e, strength, cable);
        const double first = w->space->around != NULL ? stiffness_closed : stiffness_first;
        const double soft = cable->start > 0 ? first * force / cable->start : 0;
        w->laws[e] = (taut_film_pull){.force = force, .stiffness = soft, .target = cable->start};
        if (cable->stiffness > 0 && cable->stiffness <= soft) {
            w->laws[e] = (taut_film_pull){.stiffness = cable->stiffness, .target = cable->target};
        }
    }
}

static void set_law(taut_area_cable *cable, const taut_film_pull *l, double factor)
{
    cable->tension = factor * l->force;
    cable->base = l->force;
    cable->stiffness = l->stiffness;
    cable->target = l->target;
}

void taut_film_drop_rule(taut_film_work *w)
{
    taut_area_functional_free(w->functional);
    taut_arena_free(w->arena);
    w->functional = NULL;
    w->arena = NULL;
}

static taut_status take_density(taut_film_work *w)
{
    const taut_film_problem *problem = w->space->problem;
    taut_area_functional *f = w->functional;

    if (!taut_film_has_density(problem)) {
        return TAUT_OK;
    }
    if (taut_area_density_new(f, w->arena, &w->density) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_film_threads_lay(problem, w->reference != NULL ? w->reference : problem->reference,
                          taut_film_tension(problem), f, &w->density);
    f->density = &w->density;
    return TAUT_OK;
}

/* From here on the monitor is told. */
static void watch(taut_film_work *w)
{
    w->pulse.monitor = w->monitor;
    w->pulse.what = "film";
    w->pulse.done = taut_none;
}

taut_status taut_film_take_rule(taut_film_work *w, int rule, double factor)
{
    w->rule = rule;
    return taut_film_take_nodes(w, extra_nodes[rule], factor);
}

taut_status taut_film_take_nodes(taut_film_work *w, int extra, double factor)
{
    const taut_film_problem *problem = w->space->problem;
    int found = 0;

    taut_film_drop_rule(w);
    w->arena = taut_arena_new();
    for (int e = 0; e < 4; e++) {
        if (w->space->ratios[e] > 0) {
            size_t first = 0, step = 0;
            int count = 0;
            taut_film_edge_points(w->space->nu, w->space->nv, e, &first, &step, &count);
            if (taut_area_cable_new(e < 2 ? problem->v : problem->u, extra + 1, first, step,
                                    w->arena, &w->cables[found]) != TAUT_OK) {
                return TAUT_NO_MEMORY;
            }
            if (w->space->around != NULL) {
                taut_area_cable_open(w->space->around, &w->cables[found]);
            }
            w->edges[found] = e;
            set_law(&w->cables[found++], &w->laws[e], w->laws[e].stiffness > 0 ? 1 : factor);
        }
    }
    const taut_film_ring ring = problem->ring;
    const taut_loop *around = w->space->around;
    if (taut_area_functional_around(
            problem->u, problem->v, ring == TAUT_FILM_RING_U ? around : NULL,
            ring == TAUT_FILM_RING_V ? around : NULL, extra, &w->functional) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    w->functional->threads = w->threads;
    w->functional->cables = w->cables;
    w->functional->cable_count = found;
    watch(w);
    w->functional->pulse = &w->pulse;
    return take_density(w);
}

/* Do normals of neighbouring Gauss points of the last gradient's net look apart? */
static int is_folded(const taut_area_functional *functional)
{
    for (int i = 0; i < functional->u.count; i++) {
        double here[TAUT_AREA_STATE], next[TAUT_AREA_STATE];
        taut_area_functional_state(functional, i, 0, here);
        for (int j = 0; j < functional->v.count; j++) {
            if (i + 1 < functional->u.count) {
                taut_area_functional_state(functional, i + 1, j, next);
                if (!(taut_dot(here, next) > 0)) {
                    return 1;
                }
            }
            if (j + 1 < functional->v.count) {
                taut_area_functional_state(functional, i, j + 1, next);
                if (!(taut_dot(here, next) > 0)) {
                    return 1;
                }
                memcpy(here, next, sizeof here);
            }
        }
    }
    return 0;
}

/* x, and x_u x x_v, at a Gauss point. */
static void find_normal(const taut_film_work *w, int i, int j, double x[3], double normal[3])
{
    const taut_area_axis *u = &w->functional->u, *v = &w->functional->v;
    double xu[3] = {0, 0, 0}, xv[3] = {0, 0, 0};

    memset(x, 0, 3 * sizeof(double));
    for (int k = 0; k < u->local * v->local; k++) {
        const int a = i * u->local + k / v->local, b = j * v->local + k % v->local;
        const int row = u->first[i] + k / v->local, column = v->first[j] + k % v->local;
        const double *p = w->net + 3 * ((size_t)row * (size_t)w->space->nv + (size_t)column);
        taut_add_scaled(u->value[a] * v->value[b], p, x);
        taut_add_scaled(u->slope[a] * v->value[b], p, xu);
        taut_add_scaled(u->value[a] * v->slope[b], p, xv);
    }
    taut_cross(xu, xv, normal);
}

/* The first Gauss point whose normal and that of one before look apart, or 0 and that of the least area element. */
static int find_fold(const taut_film_work *w, int at[2])
{
    double least = INFINITY;

    for (int i = 0; i < w->functional->u.count; i++) {
        for (int j = 0; j < w->functional->v.count; j++) {
            double x[3], n[3], before[3];
            int folds = 0;
            find_normal(w, i, j, x, n);
            const double size = taut_length(n);
            for (int d = 0; d < 2; d++) {
                if ((d ? j : i) > 0) {
                    find_normal(w, i - !d, j - d, x, before);
                    folds |= !(taut_dot(n, before) > 0);
                }
            }
            if (folds || size < least) {
                least = size;
                at[0] = i;
                at[1] = j;
            }
            if (folds) {
                return 1;
            }
        }
    }
    return 0;
}

/* The corner, or -1, in which edges pass each other. */
static int passed_corner(const taut_film_work *w)
{
    const taut_area_functional *f = w->functional;
    double radius[4] = {0, 0, 0, 0};

    for (int k = 0; f->density == NULL && k < f->cable_count; k++) {
        radius[w->edges[k]] = w->cables[k].tension;
    }
    for (int c = 0; w->space->around == NULL && c < 4; c++) {
        if (taut_film_passes(f, w->space->problem, radius, w->net, c)) {
            return c;
        }
    }
    return -1;
}

static taut_status refuse_fold(const taut_film_work *w, int corner, taut_error *error)
{
    const taut_area_functional *f = w->functional;
    const unsigned char known = 0;
    int at[2] = {0, 0};
    double x[3], normal[3], point[3];

    const int folds = find_fold(w, at) || corner >= 0;
    if (corner >= 0) {
        at[0] = corner % 2 * (f->u.count - 1);
        at[1] = corner / 2 * (f->v.count - 1);
    }
    find_normal(w, at[0], at[1], x, normal);
    /* beyond the range of doubles: as infinity, which is where it is */
    (void)taut_scaling_undo(&w->space->scaling, 1, x, &known, x, point, NULL);
    return taut_fail(error, TAUT_NOT_CONVERGED, "folds", NULL, w->region.iterations, taut_none,
                     "the film folds in step %d: its normal turns over from one point to the "
                     "next%s near u = %.3g, v = %.3g, at (%.6g, %.6g, %.6g); %s",
                     w->region.iterations, folds ? "" : ", or is about to,", f->u.at[at[0]],
                     f->v.at[at[1]], point[0], point[1], point[2],
                     f->cable_count > 0
                         ? "raise the forces of the cables, shorten those of given "
                           "length, or move the corners"
                         : "take more points, or edges that are nearer to each other");
}

/* What ended the trust region, in the words of films. */
static taut_status tell_ending(const taut_film_work *w, const taut_error *inner, taut_status status,
                               taut_error *error)
{
    if (status == TAUT_NO_MEMORY) {
        return taut_fail_memory(error);
    }
    if (status == TAUT_INTERRUPTED) {
        return taut_fail_status(error, status);
    }
    if (strcmp(inner->reason, "folds") == 0) {
        return refuse_fold(w, passed_corner(w), error);
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, w->region.residual,
                     w->region.tolerance,
                     "no film after %d steps: the residual is %.3g, expected at most %.3g",
                     w->region.iterations, w->region.residual, w->region.tolerance);
}

/* A few steps in all coordinates, which steps along the moves follow: the net lies as these leave it. */
static taut_status approach(taut_film_work *w, taut_newton_step *newton, taut_error *inner)
{
    taut_trust_region few = w->region;
    const int most = few.iterations + (w->rule == 0 ? APPROACH : 0);

    few.tolerance = fmax(few.tolerance, residual_rough);
    few.max_iterations = most < few.max_iterations ? most : few.max_iterations;
    few.is_minimum = 1; /* the moves that the energy sees are judged, when the film is found */
    const taut_status status =
        taut_trust_region_minimise(w->functional, newton, &few, w->net, inner);
    const int is_whole = few.max_iterations == most; /* else the caller's iterations are spent */
    few.tolerance = w->region.tolerance;
    few.max_iterations = w->region.max_iterations;
    few.is_minimum = w->region.is_minimum;
    w->region = few;
    return status == TAUT_NOT_CONVERGED && is_whole && strcmp(inner->reason, "folds") != 0 ? TAUT_OK
                                                                                           : status;
}

/* Points that near-singular steps from `before` have led off their lines and planes are brought back. */
static void keep_guides(const taut_film_work *w, const double *before)
{
    const taut_film_space *space = w->space;

    for (size_t i = 0; space->allowed != NULL && i < space->count; i++) {
        double off[3], onto[3];
        taut_difference(w->net + 3 * i, before + 3 * i, onto);
        memcpy(off, onto, sizeof off);
        taut_mask_project(space->allowed + 6 * i, onto);
        taut_difference(onto, off, off);
        if (taut_norm(off) > guide_room) {
            taut_add_scaled(1, off, w->net + 3 * i);
        }
    }
}

/* Minimises by the rule of the moment. */
static taut_status minimise(taut_film_work *w, taut_error *error)
{
    taut_newton_step *newton = NULL;
    taut_error inner = {.status = TAUT_OK};
    double *before = taut_alloc(w->space->count, 3 * sizeof(double));
    taut_status status = before != NULL
                             ? taut_newton_step_new(w->functional, &w->form, &w->space->mask, NULL,
                                                    1, w->monitor, &newton)
                             : TAUT_NO_MEMORY;

    if (status == TAUT_NO_MEMORY) {
        taut_free(before);
        return taut_fail_memory(error);
    }
    if (status != TAUT_OK) {
        taut_free(before);
        return taut_fail(error, TAUT_NOT_CONVERGED, "ill-conditioned", NULL, taut_none, taut_none,
                         "the system is too ill-conditioned for double precision: the knots or "
                         "the degree are too extreme");
    }
    w->method = taut_newton_step_method(newton);
    memcpy(before, w->net, 3 * w->space->count * sizeof(double));
    status = w->space->problem->method == TAUT_FILM_NORMAL
                 ? approach(w, newton, &inner)
                 : taut_trust_region_minimise(w->functional, newton, &w->region, w->net, &inner);
    w->region.theta = 0;
    keep_guides(w, before);
    taut_free(before);
    taut_film_memory_clear(&w->memory); /* the net is another */
    taut_newton_step_free(newton);
    return status == TAUT_OK ? TAUT_OK : tell_ending(w, &inner, status, error);
}

/* What derivatives of all coordinates may be left: of lines that slide along themselves more, and whatever there is by the
 * method `normal`. */
static double most_any(const taut_film_work *w)
{
    return w->space->problem->method == TAUT_FILM_NORMAL ? INFINITY
           : w->space->leader != NULL                    ? residual_any
                                                         : residual_held;
}

taut_status taut_film_report(taut_film_work *w, taut_error *error)
{
    watch(w);
    return taut_pulse_report(&w->pulse) ? taut_fail_status(error, TAUT_INTERRUPTED) : TAUT_OK;
}

/* Steps to where the net is at rest, minimum or not. */
static taut_status seek_moves(taut_film_work *w, taut_film_polished *all, taut_error *error)
{
    taut_film_rest_point at;

    w->is_definite = 0;
    const taut_status status =
        taut_film_seek(w->functional, w->space, w->net, NULL, SEEKS, SEEKS_ALL, &at);
    *all = (taut_film_polished){.first = at.first, .residual = at.residual, .any = at.any};
    all->area = taut_area_functional_value(w->functional, w->net).area;
    return status == TAUT_OK ? TAUT_OK : taut_fail_status(error, status);
}

/* Steps along the moves that the energy sees. Where lines slide along themselves these leave something to the other
 * coordinates, and steps in all of them follow, until both are at rest. */
static taut_status polish_moves(taut_film_work *w, taut_film_polished *all, taut_error *error)
{
    const int patience = w->region.patience;
    taut_status status = TAUT_OK;

    for (int k = 0; status == TAUT_OK; k++) {
        taut_film_polished found;
        if (w->space->problem->method == TAUT_FILM_NORMAL) {
            if (w->memory.factors != NULL || w->rule > 0) {
                status = taut_film_polish(w->functional, w->space, w->net, w->enough, &w->memory,
                                          &found, &w->is_definite);
                if (status != TAUT_OK) {
                    return taut_fail_status(error, status);
                }
                if (found.residual <= fmax(w->enough, residual_settled * w->region.tolerance)) {
                    *all = found;
                    return TAUT_OK;
                }
            }
            return seek_moves(w, all, error);
        }
        status = taut_film_polish(w->functional, w->space, w->net, w->enough, &w->memory, &found,
                                  &w->is_definite);
        if (status != TAUT_OK) {
            return taut_fail_status(error, status);
        }
        found.first = k == 0 ? found.first : all->first;
        *all = found;
        if (w->space->leader == NULL || found.any <= residual_any || k == POLISHES) {
            break;
        }
        w->region.patience = 0;
        status = minimise(w, error);
        w->region.patience = patience;
    }
    return status;
}

/* The same, or those to any rest; refused where the film has a fold. *before: the residual along the moves. */
static taut_status polish(taut_film_work *w, double *before, taut_error *error)
{
    taut_film_polished found = {.first = 0};
    taut_status status = taut_film_report(w, error);

    if (status == TAUT_OK) {
        status = w->seeks ? seek_moves(w, &found, error) : polish_moves(w, &found, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    *before = found.first;
    w->any = found.any;
    w->region.residual = found.residual;
    w->region.area = found.area;
    const int corner = passed_corner(w);
    return corner >= 0 || is_folded(w->functional) ? refuse_fold(w, corner, error) : TAUT_OK;
}

static taut_status refuse_rules(const taut_film_work *w, taut_error *error)
{
    return taut_fail(
        error, TAUT_NOT_CONVERGED, "not-converged", NULL, w->region.residual, w->region.tolerance,
        "no Gauss rule settles the film: it varies too fast for its knots somewhere, as where "
        "two edges meet at a very small angle; even out the knots, raise the forces "
        "or the tolerance");
}

/* The next rule: *agree where it gives the same energy, and derivatives within the tolerance; *rested where the film is at rest by
 * it, after a few steps. */
static taut_status refine_rule(taut_film_work *w, double factor, int *agree, int *rested,
                               taut_error *error)
{
    const double before = w->region.area;
    double residual = 0;

    *agree = *rested = 0;
    if (taut_film_take_rule(w, w->rule + 1, factor) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    const double after = taut_area_functional_value(w->functional, w->net).area;
    if (!(fabs(after - before) <= energy_near * after)) {
        return TAUT_OK;
    }
    w->enough = residual_settled * w->region.tolerance;
    const taut_status status = polish(w, &residual, error);
    w->enough = 0;
    *rested =
        w->region.residual <= residual_agreement * w->region.tolerance && w->any <= most_any(w);
    *agree = *rested && fabs(after - before) <= energy_agreement * after &&
             residual <= residual_agreement * w->region.tolerance;
    return status;
}

/* ---- cables that give way ---- */

/* Stiff elastic cables become as stiff as they are: *changed. */
static void harden(taut_film_work *w, int *changed)
{
    for (int k = 0; k < w->functional->cable_count; k++) {
        const int e = w->edges[k];
        const taut_film_cable *cable = &w->now[e];
        if (cable->stiffness > 0 && w->laws[e].force > 0) {
            w->laws[e] = (taut_film_pull){.stiffness = cable->stiffness, .target = cable->target};
            set_law(&w->cables[k], &w->laws[e], 1);
            *changed = 1;
        }
    }
}

/* How far the worst cable of given length is from it: share; off[k]: of cable k, L - L_0. */
static double find_errors(const taut_film_work *w, double off[4])
{
    double worst = 0;
    for (int k = 0; k < w->functional->cable_count; k++) {
        const double given = w->now[w->edges[k]].length;
        off[k] = given > 0 ? taut_area_cable_length(&w->cables[k], w->net) - given : 0;
        worst = given > 0 ? fmax(worst, fabs(off[k]) / given) : worst;
    }
    return worst;
}

/* The next multipliers of cables of given length. */
static taut_status move_multipliers(taut_film_work *w, const double off[4])
{
    double response[4][4], small[4][4], step[4];
    int which[4], count = 0;
    const taut_status status = taut_film_respond(w->functional, w->space, w->net, response);

    for (int k = 0; k < w->functional->cable_count; k++) {
        if (w->now[w->edges[k]].length > 0) {
            step[count] = off[k];
            which[count++] = k;
        }
    }
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        for (int j = 0; j <= i; j++) {
            small[i][j] = response[which[i]][which[j]];
        }
    }
    if (status == TAUT_NO_MEMORY || status == TAUT_INTERRUPTED) {
        return status;
    }
    if (status == TAUT_OK && taut_small_factor(count, small)) {
        taut_small_solve(count, small, step);
    } else { /* the step of the augmented Lagrangian */
        for (int i = 0; i < count; i++) {
            step[i] *= w->cables[which[i]].stiffness;
        }
    }
    for (int i = 0; i < count; i++) {
        taut_film_pull *l = &w->laws[w->edges[which[i]]];
        l->force = fmax(0.1 * l->force, l->force + step[i]);
        set_law(&w->cables[which[i]], l, 1);
    }
    return TAUT_OK;
}

taut_status taut_film_polish_again(taut_film_work *w, taut_error *error)
{
    double before = 0, off[4];

    w->enough = residual_settled * w->region.tolerance;
    w->seeks = w->space->around != NULL;
    taut_status status = polish(w, &before, error);
    w->enough = w->seeks = 0;
    if (status == TAUT_OK && !(w->any <= most_any(w))) {
        return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, w->any, most_any(w),
                         "the net is not at rest within its surface");
    }
    if (status == TAUT_OK && find_errors(w, off) > length_agreement) {
        w->region.residual = INFINITY; /* by other forces */
        status = taut_fail_status(error, move_multipliers(w, off));
    }
    return status;
}

/* Minimises where the last steps alone do not lead to rest. */
static taut_status settle(taut_film_work *w, int far, taut_error *error)
{
    double residual = 0;
    taut_status status = far ? minimise(w, error) : polish(w, &residual, error);

    if (status == TAUT_OK && (far || w->region.residual > w->region.tolerance)) {
        status = far ? TAUT_OK : minimise(w, error);
        if (status == TAUT_OK) {
            status = polish(w, &residual, error);
        }
    }
    return status;
}

taut_status taut_film_refuse_slack(const taut_film_space *space, int e, double length,
                                   taut_error *error)
{
    const int unit = space->scaling.outer + space->scaling.inner;
    const taut_film_edge *edge = &space->problem->edges[e];
    const double given = edge->law == TAUT_FILM_ELASTIC ? edge->unstressed : edge->length;
    char where[32];

    snprintf(where, sizeof where, "/edges/%s/cable", taut_film_edge_names[e]);
    return taut_fail(error, TAUT_NO_SOLUTION, "cable-too-weak", where, given, ldexp(length, unit),
                     "cable %s is slack: the film draws it to no more than %.6g, and it is %.6g "
                     "long; shorten it",
                     taut_film_edge_names[e], ldexp(length, unit), given);
}

static taut_status enforce_laws(taut_film_work *w, taut_error *error)
{
    double off[4];
    int changed = 0, rests = 0; /* in all coordinates */
    taut_status status = TAUT_OK;

    harden(w, &changed);
    if (changed) {
        status = settle(w, 1, error);
    }
    for (int k = 0; status == TAUT_OK; k++) {
        const double worst = find_errors(w, off);
        if (worst <= length_agreement && (rests || k == 0)) {
            return TAUT_OK;
        }
        for (int c = 0; k == MULTIPLIERS && c < w->functional->cable_count; c++) {
            if (off[c] < 0 && w->laws[w->edges[c]].force < force_none) {
                return taut_film_refuse_slack(w->space, w->edges[c],
                                              taut_area_cable_length(&w->cables[c], w->net), error);
            }
        }
        if (k == MULTIPLIERS) {
            return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, worst,
                             length_agreement,
                             "a cable does not come to its length: after %d steps of its force it "
                             "is off by %.3g of it; even out the knots, or take another length",
                             k, worst);
        }
        const taut_status moved = move_multipliers(w, off);
        if (moved != TAUT_OK) {
            return taut_fail_status(error, moved);
        }
        const int far =
            worst <= 1e3 * length_agreement && !rests; /* what forces moved lies askew */
        rests = rests || far;
        status = settle(w, far, error);
    }
    return status;
}

/* Corners that move leave a net behind that lies askew: it is laid anew between the edges once these are about where they
 * belong. */
static taut_status minimise_moving(taut_film_work *w, taut_error *error)
{
    taut_status status = minimise(w, error);

    if (status == TAUT_OK && w->rule == 0 && w->space->around == NULL && !w->space->has_inside) {
        taut_film_space_fill(w->space, w->net);
        status = minimise(w, error);
    }
    return status;
}

/* The film by the rule of the moment; rested: the one before agrees with it, and its last steps have
 * been made. */
static taut_status rest_by_rule(taut_film_work *w, int rested, taut_error *error)
{
    const int before = w->region.iterations;
    double residual = 0;
    taut_status status = TAUT_OK;

    if (!rested && w->rule > 0 && w->space->problem->method == TAUT_FILM_NORMAL) {
        status = settle(w, 0, error); /* the net's other coordinates stay as they are */
        w->iterations += w->region.iterations - before;
    } else if (!rested) {
        status = w->space->leader != NULL ? minimise_moving(w, error) : minimise(w, error);
        w->iterations += w->region.iterations - before;
        status = status == TAUT_OK ? polish(w, &residual, error) : status;
    }
    return status == TAUT_OK ? enforce_laws(w, error) : status;
}

/* Do the forces themselves follow no law? */
static int has_forces_only(const taut_film_work *w)
{
    int only = 1;
    for (int e = 0; e < 4; e++) {
        only = only && !(w->space->cables[e].start > 0);
    }
    return only;
}

taut_status taut_film_rest(taut_film_work *w, double factor, taut_error *error)
{
    if (!has_forces_only(w) && factor != w->strength) {
        taut_film_start_laws(w, factor);
    }
    taut_status status = taut_film_take_rule(w, 0, factor);

    w->region.iterations = w->begun; /* work goes on to be counted: all films on the way share it */
    w->iterations += w->begun;
    w->begun = 0;
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int agreed = 0, agree = 0, rested = 0; status == TAUT_OK && agreed < AGREEING;) {
        status = rest_by_rule(w, rested, error);
        if (status == TAUT_OK && w->rule + 1 == RULES) {
            return agreed > 0 ? TAUT_OK : refuse_rules(w, error);
        }
        if (status == TAUT_OK) {
            status = refine_rule(w, factor, &agree, &rested, error);
        }
        agreed = agree ? agreed + 1 : 0;
    }
    return status;
}

taut_status taut_film_rest_any(taut_film_work *w, int steps, taut_film_rest_point *at,
                               taut_error *error)
{
    double before = INFINITY;

    for (int rule = 0; rule < RULES && has_forces_only(w); rule++) {
        taut_status status = taut_film_take_rule(w, rule, 1);
        if (status == TAUT_OK) {
            status = taut_film_seek(w->functional, w->space, w->net, NULL, steps, GAUGES, at);
        }
        if (status != TAUT_OK) {
            return taut_fail_status(error, status);
        }
        const double after = taut_area_functional_value(w->functional, w->net).area;
        if (!(at->residual <= w->region.tolerance) || is_folded(w->functional)) {
            break;
        }
        if (fabs(after - before) <= energy_agreement * after) {
            w->region.residual = at->residual;
            w->region.area = after;
            w->method = "factors";
            return TAUT_OK;
        }
        before = after;
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, at->residual,
                     w->region.tolerance,
                     "no film at rest is found from there: the residual is %.3g, expected at "
                     "most %.3g",
                     at->residual, w->region.tolerance);
}

taut_status taut_film_judge(taut_film_work *w, taut_film_rest_point *at)
{
    unsigned char rigid[4] = {0, 0, 0, 0};

    for (int k = 0; k < w->functional->cable_count; k++) {
        rigid[k] = w->space->cables[w->edges[k]].length > 0;
    }
    return taut_film_seek(w->functional, w->space, w->net, rigid, 0, 0, at);
}
