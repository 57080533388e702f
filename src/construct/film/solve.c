/* solve.c -- from the start to the film at rest.
 *
 *     net = the start;  rule = 1 node more than functions alive on a span
 *     repeat
 *         minimise A + sum r_k L_k from net (construct/plateau/trust_region.h)
 *         a few steps along the moves that this sees (construct/film/polish.h)
 *         cables that give way come to their laws (enforce_laws)
 *         the film has a fold: fail
 *         the next rule
 *     until it gives the same energy, and derivatives within the tolerance
 *     failed, and there are cables:
 *         factor = 2, 4, ..: the start solved with all forces so many times, until one succeeds
 *         lower it, from film to film, by steps that are halved where one fails
 *         1 is reached: done; no step is left: cable-too-weak, the last factor told
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
#include "construct/film/solve.h"

#include "construct/film/freedom.h"
#include "construct/film/polish.h"
#include "construct/film/ring.h"
#include "construct/plateau/density.h"
#include "construct/plateau/newton_step.h"
#include "construct/plateau/small.h"
#include "construct/plateau/trust_region.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    ITERATIONS_DEFAULT = 200,
    RULES = 8,
    DOUBLINGS = 8,
    LOWERINGS = 64,
    LEADS = 128,
    PATIENCE = 40,
    POLISHES = 6,
    MULTIPLIERS = 40
};
static const double tolerance_default = 1e-10;
/* Nodes on a span beyond the functions alive there. */
static const int extra_nodes[RULES] = {1, 3, 6, 10, 16, 26, 42, 68};
static const double energy_agreement = 1e-13; /* share: two rules that agree */
static const double residual_agreement = 0.1; /* of the tolerance */
static const double residual_any = 5e-7;      /* of all coordinates: the certificate allows 1e-6 */
static const double gain_enough = 3e-10;      /* the same: how they slide along themselves creeps */
static const double area_none = 1e-12;        /* of the size squared */
static const double step_least = 0x1p-10;     /* of the logarithm of the factor of all forces */
static const double lead_least = 0x1p-15;     /* of the distance of a ring's edges */
static const double neck_most = 0.95;         /* of the shorter edge: it is half where films part */
static const double theta_least = 1e-6;       /* of the metric operator in every step */
static const double work_most = 2e11;         /* flops of all films on the way: minutes */
/* Of given lengths: share. Rounding is 1e-15, the certificate's limit 1e-10. */
static const double length_agreement = 1e-12;
/* Stiffness of a cable at the start, over force / length. A film of a given length is stable where
 * one of given force is not, beyond half a circle: this makes it convex up to a whole one. */
static const double stiffness_first = 2;
static const double stiffness_closed = 20; /* of cables that close, whose force is a worse guess */

/* What a cable does for now: a force, or more with its length (construct/plateau/cable.h). */
typedef struct law {
    double force, stiffness, target;
} law;

typedef struct work {
    const taut_film_space *space;
    const taut_monitor *monitor;
    taut_arena *arena; /* of a solve */
    taut_dirichlet_form form;
    taut_area_functional *functional;
    taut_area_density density; /* where threads are drawn */
    taut_surface *reference;   /* of the update at hand, or NULL */
    taut_area_cable cables[4];
    int edges[4]; /* of the cables */
    law laws[4];  /* of edges */
    int rule;
    double *net;
    taut_trust_region region;
    int iterations; /* of all films on the way */
    const char *method;
} work;

static void start_laws(work *w)
{
    for (int e = 0; e < 4; e++) {
        const taut_film_cable *cable = &w->space->cables[e];
        const double force = w->space->ratios[e];
        const double first = w->space->around != NULL ? stiffness_closed : stiffness_first;
        const double soft = cable->start > 0 ? first * force / cable->start : 0;
        w->laws[e] = (law){.force = force, .stiffness = soft, .target = cable->start};
        if (cable->stiffness > 0 && cable->stiffness <= soft) {
            w->laws[e] = (law){.stiffness = cable->stiffness, .target = cable->target};
        }
    }
}

static void set_law(taut_area_cable *cable, const law *l, double factor)
{
    cable->tension = factor * l->force;
    cable->base = l->force;
    cable->stiffness = l->stiffness;
    cable->target = l->target;
}

static void drop_rule(work *w)
{
    taut_area_functional_free(w->functional);
    taut_arena_free(w->arena);
    w->functional = NULL;
    w->arena = NULL;
}

/* a, b over the tension at a node: the densities, or of a prestress |X_u x X_v| s / |X_u|^2 by u and v over [0, 1]. */
static void find_density(const work *w, double u, double v, double density[2])
{
    const taut_film_problem *problem = w->space->problem;
    const taut_surface *reference = w->reference != NULL ? w->reference : problem->reference;
    const double s = taut_film_tension(problem);
    const double ratio = (taut_basis_hi(problem->v) - taut_basis_lo(problem->v)) /
                         (taut_basis_hi(problem->u) - taut_basis_lo(problem->u));
    double x[TAUT_SURFACE_VECTORS(1)][3], normal[3];

    density[0] = problem->force_density[0] / s;
    density[1] = problem->force_density[1] / s;
    if (problem->prestress[0] > 0) {
        (void)taut_surface_eval(reference, u, v, 1, x[0]);
        taut_cross(x[TAUT_XU], x[TAUT_XV], normal);
        const double area = taut_norm(normal), along = taut_norm(x[TAUT_XU]),
                     across = taut_norm(x[TAUT_XV]);
        density[0] = problem->prestress[0] / s * ratio * (area / along / along);
        density[1] = problem->prestress[1] / s / ratio * (area / across / across);
    }
}

static taut_status take_density(work *w)
{
    taut_area_functional *f = w->functional;

    if (!taut_film_has_density(w->space->problem)) {
        return TAUT_OK;
    }
    if (taut_area_density_new(f, w->arena, &w->density) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int line = 0; line < f->u.count; line++) {
        for (int k = 0; k < f->v.count; k++) {
            const size_t at = (size_t)line * (size_t)f->v.count + (size_t)k;
            double density[2];
            find_density(w, f->u.at[line], f->v.at[k], density);
            w->density.along_u[at] = density[0];
            w->density.along_v[at] = density[1];
        }
    }
    f->density = &w->density;
    return TAUT_OK;
}

/* The functional of a rule, all forces `factor` times what they are. */
static taut_status take_rule(work *w, int rule, double factor)
{
    const taut_film_problem *problem = w->space->problem;
    int found = 0;

    drop_rule(w);
    w->arena = taut_arena_new();
    w->rule = rule;
    for (int e = 0; e < 4; e++) {
        if (w->space->ratios[e] > 0) {
            size_t first = 0, step = 0;
            int count = 0;
            taut_film_edge_points(w->space->nu, w->space->nv, e, &first, &step, &count);
            if (taut_area_cable_new(e < 2 ? problem->v : problem->u, extra_nodes[rule] + 1, first,
                                    step, w->arena, &w->cables[found]) != TAUT_OK) {
                return TAUT_NO_MEMORY;
            }
            if (w->space->around != NULL) {
                taut_area_cable_open(w->space->around, &w->cables[found]);
            }
            w->edges[found] = e;
            set_law(&w->cables[found++], &w->laws[e], factor);
        }
    }
    const taut_film_ring ring = problem->ring;
    const taut_loop *around = w->space->around;
    if (taut_area_functional_around(problem->u, problem->v,
                                    ring == TAUT_FILM_RING_U ? around : NULL,
                                    ring == TAUT_FILM_RING_V ? around : NULL, extra_nodes[rule],
                                    &w->functional) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    w->functional->cables = w->cables;
    w->functional->cable_count = found;
    return take_density(w);
}

/* Do normals of neighbouring Gauss points of the last gradient's net look apart? */
static int is_folded(const taut_area_functional *functional)
{
    for (int i = 0; i < functional->u.count; i++) {
        for (int j = 0; j < functional->v.count; j++) {
            double here[TAUT_AREA_STATE], next[TAUT_AREA_STATE];
            taut_area_functional_state(functional, i, j, here);
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
            }
        }
    }
    return 0;
}

static taut_status refuse_fold(const work *w, taut_error *error)
{
    return taut_fail(error, TAUT_NOT_CONVERGED, "folds", NULL, w->region.iterations, taut_none,
                     "the film folds after %d steps: its normal turns over from one point to the "
                     "next; raise the forces of the cables, shorten those of given length, or "
                     "move the corners",
                     w->region.iterations);
}

/* What ended the trust region, in the words of films. */
static taut_status tell_ending(const work *w, const taut_error *inner, taut_status status,
                               taut_error *error)
{
    if (status == TAUT_NO_MEMORY) {
        return taut_fail_memory(error);
    }
    if (status == TAUT_INTERRUPTED) {
        return taut_fail_status(error, status);
    }
    if (strcmp(inner->reason, "folds") == 0) {
        return refuse_fold(w, error);
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, w->region.residual,
                     w->region.tolerance,
                     "no film after %d steps: the residual is %.3g, expected at most %.3g",
                     w->region.iterations, w->region.residual, w->region.tolerance);
}

/* Minimises by the rule of the moment. */
static taut_status minimise(work *w, taut_error *error)
{
    taut_newton_step *newton = NULL;
    taut_error inner = {.status = TAUT_OK};
    taut_status status = taut_newton_step_new(w->functional, &w->form, &w->space->mask, NULL, 1,
                                              w->monitor, &newton);

    if (status == TAUT_NO_MEMORY) {
        return taut_fail_memory(error);
    }
    if (status != TAUT_OK) {
        return taut_fail(error, TAUT_NOT_CONVERGED, "ill-conditioned", NULL, taut_none, taut_none,
                         "the system is too ill-conditioned for double precision: the knots or "
                         "the degree are too extreme");
    }
    w->method = taut_newton_step_method(newton);
    status = taut_trust_region_minimise(w->functional, newton, &w->region, w->net, &inner);
    taut_newton_step_free(newton);
    return status == TAUT_OK ? TAUT_OK : tell_ending(w, &inner, status, error);
}

/* Steps along the moves that the energy sees. Where lines slide along themselves these leave something to the other
 * coordinates, and steps in all of them follow, until both are at rest. residual: as taut_film_polish has it. */
static taut_status polish_moves(work *w, double residual[3], taut_error *error)
{
    const int patience = w->region.patience;
    taut_status status = TAUT_OK;

    for (int k = 0; status == TAUT_OK; k++) {
        double found[3];
        if (taut_film_polish(w->functional, w->space, w->net, found) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        residual[0] = k == 0 ? found[0] : residual[0];
        residual[1] = found[1];
        residual[2] = found[2];
        if (w->space->leader == NULL || found[2] <= residual_any || k == POLISHES) {
            break;
        }
        w->region.patience = 0;
        status = minimise(w, error);
        w->region.patience = patience;
    }
    return status;
}

/* The same; refused where the film has a fold. *before: the residual along the moves. */
static taut_status polish(work *w, double *before, taut_error *error)
{
    double residual[3] = {0, 0, 0};
    const taut_status status = polish_moves(w, residual, error);

    if (status != TAUT_OK) {
        return status;
    }
    *before = residual[0];
    w->region.residual = residual[1];
    w->region.area = taut_area_functional_value(w->functional, w->net).area;
    return is_folded(w->functional) ? refuse_fold(w, error) : TAUT_OK;
}

static taut_status refuse_rules(const work *w, taut_error *error)
{
    return taut_fail(
        error, TAUT_NOT_CONVERGED, "not-converged", NULL, w->region.residual, w->region.tolerance,
        "no Gauss rule settles the film: it varies too fast for its knots somewhere, as where "
        "two edges meet at a very small angle; even out the knots, raise the forces "
        "or the tolerance");
}

/* The next rule: *agree where it gives the same energy, and derivatives within the tolerance. */
static taut_status refine_rule(work *w, double factor, int *agree, taut_error *error)
{
    const double before = w->region.area;
    double residual = 0;

    if (take_rule(w, w->rule + 1, factor) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    const double after = taut_area_functional_value(w->functional, w->net).area;
    if (!(fabs(after - before) <= energy_agreement * after)) {
        return TAUT_OK;
    }
    const taut_status status = polish(w, &residual, error);
    *agree = residual <= residual_agreement * w->region.tolerance;
    return status;
}

/* ---- cables that give way ---- */

/* Stiff elastic cables become as stiff as they are: *changed. */
static void harden(work *w, int *changed)
{
    for (int k = 0; k < w->functional->cable_count; k++) {
        const int e = w->edges[k];
        const taut_film_cable *cable = &w->space->cables[e];
        if (cable->stiffness > 0 && w->laws[e].force > 0) {
            w->laws[e] = (law){.stiffness = cable->stiffness, .target = cable->target};
            set_law(&w->cables[k], &w->laws[e], 1);
            *changed = 1;
        }
    }
}

/* How far the worst cable of given length is from it: share; off[k]: of cable k, L - L_0. */
static double find_errors(const work *w, double off[4])
{
    double worst = 0;
    for (int k = 0; k < w->functional->cable_count; k++) {
        const double given = w->space->cables[w->edges[k]].length;
        off[k] = given > 0 ? taut_area_cable_length(&w->cables[k], w->net) - given : 0;
        worst = given > 0 ? fmax(worst, fabs(off[k]) / given) : worst;
    }
    return worst;
}

/* The next multipliers of cables of given length. */
static taut_status move_multipliers(work *w, const double off[4])
{
    double response[4][4], small[4][4], step[4];
    int which[4], count = 0;
    const taut_status status = taut_film_respond(w->functional, w->space, w->net, response);

    for (int k = 0; k < w->functional->cable_count; k++) {
        if (w->space->cables[w->edges[k]].length > 0) {
            step[count] = off[k];
            which[count++] = k;
        }
    }
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        for (int j = 0; j <= i; j++) {
            small[i][j] = response[which[i]][which[j]];
        }
    }
    if (status == TAUT_NO_MEMORY) {
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
        law *l = &w->laws[w->edges[which[i]]];
        l->force = fmax(0.1 * l->force, l->force + step[i]);
        set_law(&w->cables[which[i]], l, 1);
    }
    return TAUT_OK;
}

/* Minimises where the last steps alone do not lead to rest. */
static taut_status settle(work *w, int far, taut_error *error)
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

static taut_status enforce_laws(work *w, taut_error *error)
{
    double off[4];
    int changed = 0, rests = w->space->around == NULL; /* in all coordinates, or does not mind */
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
        if (k == MULTIPLIERS) {
            return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, worst,
                             length_agreement,
                             "a cable does not come to its length: after %d steps of its force it "
                             "is off by %.3g of it; even out the knots, or take another length",
                             k, worst);
        }
        if (move_multipliers(w, off) != TAUT_OK) {
            return taut_fail_memory(error);
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
static taut_status minimise_moving(work *w, taut_error *error)
{
    taut_status status = minimise(w, error);

    if (status == TAUT_OK && w->rule == 0 && w->space->around == NULL) {
        taut_film_space_fill(w->space, w->net);
        status = minimise(w, error);
    }
    return status;
}

/* net: the film that it goes to with all forces `factor` times what they are. */
static taut_status find_film(work *w, double factor, taut_error *error)
{
    taut_status status = take_rule(w, 0, factor);
    double residual = 0;

    w->region.iterations = 0; /* its work goes on to be counted: all films on the way share it */
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int agree = 0; status == TAUT_OK && !agree;) {
        const int before = w->region.iterations;
        status = w->space->leader != NULL ? minimise_moving(w, error) : minimise(w, error);
        w->iterations += w->region.iterations - before;
        if (status == TAUT_OK) {
            status = polish(w, &residual, error);
        }
        if (status == TAUT_OK) {
            status = enforce_laws(w, error);
        }
        if (status == TAUT_OK) {
            status = w->rule + 1 < RULES ? refine_rule(w, factor, &agree, error)
                                         : refuse_rules(w, error);
        }
    }
    return status;
}

/* ---- weak cables ---- */

static taut_status refuse_weak(const work *w, double least, taut_error *error)
{
    const taut_film_problem *problem = w->space->problem;
    const int e = w->edges[0];
    char where[32] = "/edges/u0/cable";
    memcpy(where + 7, taut_film_edge_names[e], 2);
    return taut_fail(error, TAUT_NO_SOLUTION, "cable-too-weak", where, problem->edges[e].force,
                     least * problem->edges[e].force,
                     "the cables are too weak for this film: lowered together from where there is "
                     "a film, the last found is at %.6g times their forces (%.6g for edge %s); "
                     "below it the film draws a cable into another edge, or folds",
                     least, least * problem->edges[e].force, taut_film_edge_names[e]);
}

static taut_status pass_on(const taut_error *inner, taut_error *error)
{
    if (error != NULL) {
        *error = *inner;
    }
    return inner->status;
}

/* net: a film with all forces *factor times, from the start. */
static taut_status find_strong(work *w, double *factor, taut_error *error)
{
    taut_error inner = {.status = TAUT_NOT_CONVERGED};
    *factor = 1;
    for (int k = 0; inner.status == TAUT_NOT_CONVERGED && k < DOUBLINGS; k++) {
        *factor *= 2;
        memcpy(w->net, w->space->start, 3 * w->space->count * sizeof(double));
        inner.status = find_film(w, *factor, &inner);
    }
    return inner.status == TAUT_OK ? TAUT_OK : pass_on(&inner, error);
}

/* From the film at `factor` down to 1. `saved` is a net of scratch. Only a film that folds says that
 * cables are too weak. */
static taut_status lower_forces(work *w, double factor, double *saved, taut_error *error)
{
    const size_t bytes = 3 * w->space->count * sizeof(double);
    double step = 0.5; /* the factor is multiplied by 1 - step */
    taut_error inner = {.status = TAUT_OK};

    for (int k = 0; factor > 1 && k < LOWERINGS && step > step_least; k++) {
        const double next = fmax(1, factor * (1 - step));
        memcpy(saved, w->net, bytes);
        inner.status = find_film(w, next, &inner);
        if (inner.status == TAUT_OK) {
            factor = next;
            continue;
        }
        if (inner.status != TAUT_NOT_CONVERGED) {
            break;
        }
        memcpy(w->net, saved, bytes);
        step *= 0.5;
    }
    if (factor > 1 && strcmp(inner.reason, "folds") == 0) {
        return refuse_weak(w, factor, error);
    }
    return factor > 1 ? pass_on(&inner, error) : TAUT_OK;
}

static taut_status try_stronger(work *w, taut_arena *arena, taut_error *error)
{
    double factor = 1;
    double *saved = taut_arena_take(arena, w->space->count, 3 * sizeof(double));
    taut_status status = saved != NULL ? find_strong(w, &factor, error) : taut_fail_memory(error);

    return status == TAUT_OK ? lower_forces(w, factor, saved, error) : status;
}

/* ---- edges of a ring that are far apart ---- */

/* The edges across which a ring is led: its second ones. */
static int far_edge(const work *w)
{
    return w->space->problem->ring == TAUT_FILM_RING_U ? 3 : 1;
}

/* The mean of the points of an edge that goes around. */
static void find_middle(const work *w, const double *net, int e, double middle[3])
{
    const int period = w->space->around->period;
    size_t first = 0, step = 0;
    int count = 0;

    taut_film_edge_points(w->space->nu, w->space->nv, e, &first, &step, &count);
    memset(middle, 0, 3 * sizeof(double));
    for (int k = 0; k < period; k++) {
        taut_add_scaled(1.0 / period, net + 3 * (first + (size_t)k * step), middle);
    }
}

/* Moves the second edge by `share` of the way between both at the start, and what is between them along with it. */
static void shift_edge(const work *w, double share, double *net)
{
    const int along_u = w->space->problem->ring == TAUT_FILM_RING_U;
    const int across = along_u ? w->space->nv : w->space->nu;
    double from[3], way[3];

    find_middle(w, w->space->start, far_edge(w) - 1, from);
    find_middle(w, w->space->start, far_edge(w), way);
    taut_add_scaled(-1, from, way);
    for (size_t i = 0; i < w->space->count; i++) {
        const int at = along_u ? (int)i % w->space->nv : (int)i / w->space->nv;
        taut_add_scaled(share * at / (across - 1), way, net + 3 * i);
    }
}

/* The shortest closed line of a net's control polygons; *edge: of the shorter edge. */
static double shortest_line(const work *w, const double *net, double *edge)
{
    const int along_u = w->space->problem->ring == TAUT_FILM_RING_U;
    const int across = along_u ? w->space->nv : w->space->nu, period = w->space->around->period;
    const size_t nv = (size_t)w->space->nv, line = along_u ? 1 : nv, step = along_u ? nv : 1;
    double shortest = INFINITY;

    *edge = INFINITY;
    for (int k = 0; k < across; k++) {
        double length = 0;
        for (int i = 0; i < period; i++) {
            const double *x = net + 3 * ((size_t)k * line + (size_t)i * step);
            length += taut_length_between(x, x + 3 * step);
        }
        shortest = fmin(shortest, length);
        *edge = k == 0 || k == across - 1 ? fmin(*edge, length) : *edge;
    }
    return shortest;
}

/* The neck of the net over the shorter edge that it began with. */
static double find_neck(const work *w)
{
    double edge = 0, now = 0;
    (void)shortest_line(w, w->space->start, &edge);
    return shortest_line(w, w->net, &now) / edge;
}

/* Did the film come near to parting? Else it is the net that folds. */
static int may_part(const work *w)
{
    return find_neck(w) < neck_most;
}

static taut_status refuse_far(const work *w, double share, taut_error *error)
{
    const int e = far_edge(w), slides = w->space->problem->edges[e].kind == TAUT_FILM_SLIDE ||
                                        w->space->problem->edges[e - 1].kind == TAUT_FILM_SLIDE;
    char where[32];

    snprintf(where, sizeof where, "/edges/%s", taut_film_edge_names[e]);
    return taut_fail(
        error, TAUT_NO_SOLUTION, slides ? "slides-away" : "collapses", where, 1, share,
        "no film connects the edges: led apart from where there is one, they lose it at "
        "%.6g of their distance, where its neck is %.3g of the shorter edge at the start%s",
        share, find_neck(w),
        slides ? "; it slides off, bring the plane nearer"
               : "; bring them together, or make the cable's force less");
}

/* net: a film with the edges at *share of their distance, from the start. */
static taut_status find_near(work *w, double *share, taut_error *error)
{
    taut_error inner = {.status = TAUT_NOT_CONVERGED};

    *share = 1;
    for (int k = 0; inner.status == TAUT_NOT_CONVERGED && k < DOUBLINGS; k++) {
        *share *= 0.5;
        memcpy(w->net, w->space->start, 3 * w->space->count * sizeof(double));
        shift_edge(w, *share - 1, w->net);
        inner.status = find_film(w, 1, &inner);
    }
    if (inner.status == TAUT_NOT_CONVERGED && may_part(w)) {
        return refuse_far(w, *share, error);
    }
    return inner.status == TAUT_OK ? TAUT_OK : pass_on(&inner, error);
}

/* Leads the edges apart, from film to film, by steps that are halved where one fails. */
static taut_status lead_apart(work *w, taut_arena *arena, taut_error *error)
{
    const size_t bytes = 3 * w->space->count * sizeof(double);
    double *saved = taut_arena_take(arena, w->space->count, 3 * sizeof(double));
    double share = 1, step = 0.5;
    taut_status status = saved != NULL ? find_near(w, &share, error) : taut_fail_memory(error);
    taut_error inner = {.status = TAUT_OK};

    if (status != TAUT_OK) {
        return status;
    }
    for (int k = 0; share < 1 && k < LEADS && step > lead_least; k++) {
        const double next = fmin(1, share + step);
        memcpy(saved, w->net, bytes);
        shift_edge(w, next - share, w->net);
        inner.status = find_film(w, 1, &inner);
        if (inner.status == TAUT_OK) {
            share = next;
            continue;
        }
        memcpy(w->net, saved, bytes);
        if (inner.status != TAUT_NOT_CONVERGED) {
            return pass_on(&inner, error);
        }
        step *= 0.5;
    }
    if (share < 1 && may_part(w)) {
        return refuse_far(w, share, error);
    }
    return share < 1 ? pass_on(&inner, error) : TAUT_OK;
}

/* ---- the whole ---- */

/* Are there cables, and forces of all of them given? */
static int has_forces(const taut_film_space *space)
{
    int forces = 0, others = 0;
    for (int e = 0; e < 4; e++) {
        forces += space->ratios[e] > 0;
        others += space->cables[e].start > 0;
    }
    return forces > 0 && others == 0;
}

static taut_status find_net(work *w, taut_arena *arena, taut_error *error)
{
    start_laws(w);
    taut_status status = take_rule(w, 0, 1);

    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_area_density *const density = w->functional->density;
    w->functional->cable_count = 0; /* the area alone */
    w->functional->density = NULL;
    const double area = taut_area_functional_value(w->functional, w->net).area;
    w->functional->density = density;
    if (!(area > area_none)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-area", "/corners", area, area_none,
                         "the edges span no area: give corners that are not on one line");
    }
    taut_error inner = {.status = TAUT_OK};
    inner.status = find_film(w, 1, &inner);
    if (inner.status == TAUT_NOT_CONVERGED && w->space->around != NULL &&
        w->region.iterations < w->region.max_iterations) {
        return lead_apart(w, arena, error);
    }
    if (inner.status == TAUT_NOT_CONVERGED && has_forces(w->space) &&
        w->region.iterations < w->region.max_iterations) {
        return try_stronger(w, arena, error);
    }
    return inner.status == TAUT_OK ? TAUT_OK : pass_on(&inner, error);
}

/* From functions that go around to the clamped ones, line by line. */
static void clamp_points(const taut_film_space *space, double *points)
{
    const int along_u = space->problem->ring == TAUT_FILM_RING_U;
    const size_t nv = (size_t)space->nv;

    for (int k = 0; space->around != NULL && k < (along_u ? space->nv : space->nu); k++) {
        taut_loop_clamp(space->around, along_u ? nv : 1,
                        points + 3 * (along_u ? (size_t)k : (size_t)k * nv));
    }
}

/* Points that are kept somewhere are brought there, copies follow, and the net is clamped. */
static taut_status settle_points(const taut_film_space *space, double *points, taut_error *error)
{
    for (int i = 0; i < space->nu; i++) {
        for (int j = 0; j < space->nv; j++) {
            const size_t at = (size_t)i * (size_t)space->nv + (size_t)j;
            taut_film_place place;
            const taut_status status = taut_film_place_of(space, i, j, &place, error);
            if (status != TAUT_OK) {
                return status;
            }
            if (!space->known[at]) {
                taut_film_place_onto(&place, points + 3 * at);
            }
        }
    }
    taut_mask_follow(&space->mask, points);
    clamp_points(space, points);
    return TAUT_OK;
}

/* The film becomes the reference, and is found once more: how far it moves, over the size. */
static taut_status update_reference(work *w, double *before, double *change, taut_arena *arena,
                                    taut_error *error)
{
    const taut_film_problem *problem = w->space->problem;
    taut_surface *made = NULL;

    memcpy(before, w->net, 3 * w->space->count * sizeof(double));
    double *points = taut_arena_copy(arena, w->net, w->space->count, 3 * sizeof(double));
    if (points == NULL) {
        return taut_fail_memory(error);
    }
    clamp_points(w->space, points);
    taut_status status =
        taut_surface_new("reference", problem->u, problem->v, points, NULL, &made, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_surface_free(w->reference);
    w->reference = made;
    status = find_net(w, arena, error);
    *change = 0;
    for (size_t i = 0; i < w->space->count; i++) {
        *change = fmax(*change, taut_distance(w->net + 3 * i, before + 3 * i));
    }
    *change /= 2; /* the boundary lies in [-1, 1] */
    return status;
}

static taut_status update(work *w, taut_arena *arena, taut_film_solution *solution,
                          taut_error *error)
{
    const int updates = w->space->problem->updates;
    double *before = taut_arena_take(arena, w->space->count, 3 * sizeof(double));
    taut_status status = TAUT_OK;

    solution->changes = taut_arena_take(arena, (size_t)updates + 1, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int k = 0; status == TAUT_OK && k < updates; k++) {
        status = update_reference(w, before, &solution->changes[k], arena, error);
    }
    return status;
}

static taut_status fill_solution(work *w, taut_arena *arena, taut_film_solution *solution,
                                 taut_error *error)
{
    const taut_film_space *space = w->space;
    const int unit = space->scaling.outer + space->scaling.inner;

    solution->points = taut_arena_take(arena, space->count, 3 * sizeof(double));
    if (solution->points == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < w->functional->cable_count; k++) {
        const int e = w->edges[k];
        solution->lengths[e] = ldexp(taut_area_cable_length(&w->cables[k], w->net), unit);
        solution->forces[e] = taut_film_force(space, e, w->cables[k].tension / space->ratios[e]);
    }
    solution->iterations = w->iterations;
    solution->residual = w->region.residual;
    solution->method = w->method;
    w->functional->cable_count = 0;
    w->functional->density = NULL;
    solution->area = taut_scaling_undo_square(
        &space->scaling, taut_area_functional_value(w->functional, w->net).area);
    taut_status status = taut_scaling_undo(&space->scaling, space->count, space->points,
                                           space->known, w->net, solution->points, error);
    if (status == TAUT_OK && space->leader != NULL) {
        status = settle_points(space, solution->points, error);
    }
    if (status == TAUT_OK && space->around != NULL &&
        taut_film_ring_discs(space, solution->points, &solution->rival) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return status;
}

taut_status taut_film_solve(const taut_film_space *space, const taut_monitor *monitor,
                            taut_arena *arena, taut_film_solution *solution, taut_error *error)
{
    const taut_film_problem *problem = space->problem;
    work w = {.space = space, .monitor = monitor, .method = "none"};
    taut_status status = TAUT_OK;

    *solution = (taut_film_solution){.points = NULL};
    w.region.tolerance = problem->tolerance > 0 ? problem->tolerance : tolerance_default;
    w.region.max_iterations =
        problem->max_iterations > 0 ? problem->max_iterations : ITERATIONS_DEFAULT;
    w.region.work_max = work_most;
    w.region.theta_least = theta_least;
    if (space->leader != NULL) {
        w.region.gain_enough = gain_enough;
        w.region.patience = PATIENCE;
    }
    w.net = taut_arena_copy(arena, space->start, space->count, 3 * sizeof(double));
    if (w.net == NULL) {
        return taut_fail_memory(error);
    }
    status = taut_dirichlet_form_new(problem->u, problem->v, NULL, &w.form, error);
    if (status == TAUT_OK) {
        status = find_net(&w, arena, error);
    }
    if (status == TAUT_OK && problem->updates > 0) {
        status = update(&w, arena, solution, error);
    }
    if (status == TAUT_OK) {
        status = fill_solution(&w, arena, solution, error);
    }
    taut_dirichlet_form_clear(&w.form);
    taut_surface_free(w.reference);
    drop_rule(&w);
    return status;
}
