/* system.c -- the system of the unknown points, by fast diagonalisation or conjugate gradients.
 *
 * Iterations are preconditioned conjugate gradients ([GolubVanLoan2013] 11.5), the three
 * coordinates side by side: they share the products with A and P, not the step lengths. A
 * coordinate that has converged to nothing stands still.
 */
#include "construct/dirichlet/system.h"

#include "construct/dirichlet/rational.h"
#include "core/arena.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/pulse.h"
#include "geometry/nurbs/gram.h"
#include "numeric/tensor/solver.h"

#include <math.h>
#include <string.h>

struct taut_dirichlet_system {
    taut_dirichlet_form *form;
    const taut_mask *mask;
    taut_pulse pulse;
    taut_crew crew;                             /* with it */
    taut_arena *arena;                          /* of the arrays */
    taut_gram u, v;                             /* of the hull */
    taut_tensor_solver *solver;                 /* of the hull */
    double *residual, *step, *product, *smooth; /* nets; the last three for iterations only */
    double *scales; /* double[nu][nv], of the preconditioner, or NULL where all are 1 */
    double *hull;
    const double *right; /* of the unknowns, a net; NULL: 0 */
    int is_damped;       /* the solver's matrices are near the hull's, not equal to them */
    int is_settled;      /* a rule was found by which a solution settles */
    int iterations;
};

/* Numbers in a net, double[nu][nv][3]. */
static size_t net_size(const taut_dirichlet_system *system)
{
    return 3 * (size_t)system->form->nu * (size_t)system->form->nv;
}

static int is_direct(const taut_dirichlet_system *system)
{
    return system->mask->is_box && system->form->rational == NULL && !system->is_damped;
}

const char *taut_dirichlet_system_method(const taut_dirichlet_system *system)
{
    return is_direct(system) ? "fast-diagonalisation" : "conjugate-gradients";
}

int taut_dirichlet_system_iterations(const taut_dirichlet_system *system)
{
    return system->iterations;
}

double taut_dirichlet_system_natural_aspect(const taut_dirichlet_system *system)
{
    return 1 / system->form->ratio;
}

void taut_dirichlet_system_free(taut_dirichlet_system *system)
{
    if (system != NULL) {
        system->form->crew = NULL;
        taut_gram_clear(&system->u);
        taut_gram_clear(&system->v);
        taut_tensor_solver_free(system->solver);
        taut_arena_free(system->arena);
        taut_free(system);
    }
}

/* ---- making it ---- */

static taut_status take_arrays(taut_dirichlet_system *system)
{
    taut_arena *arena = system->arena;
    const taut_mask *mask = system->mask;
    const size_t size = net_size(system);

    system->residual = taut_arena_take(arena, size, sizeof(double));
    system->hull =
        taut_arena_take(arena, 3 * (size_t)mask->rows * (size_t)mask->columns, sizeof(double));
    if (!is_direct(system)) {
        system->step = taut_arena_take(arena, size, sizeof(double));
        system->product = taut_arena_take(arena, size, sizeof(double));
        system->smooth = taut_arena_take(arena, size, sizeof(double));
    }
    if (system->form->rational != NULL) {
        system->scales = taut_arena_take(arena, size / 3, sizeof(double));
    }
    return taut_arena_status(arena);
}

/* The matrices of the hull with their diagonals times 1 + damping. */
static taut_status select_hull(taut_dirichlet_system *system, double damping)
{
    taut_gram *grams[2] = {&system->u, &system->v};

    taut_gram_clear(&system->u);
    taut_gram_clear(&system->v);
    if (taut_dirichlet_form_select(system->form, system->mask, &system->u, &system->v) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < grams[k]->mass.n; i++) {
            taut_band_row(&grams[k]->mass, i)[0] *= 1 + damping;
            taut_band_row(&grams[k]->stiffness, i)[0] *= 1 + damping;
        }
    }
    return TAUT_OK;
}

/* The solver of the hull. At high degrees the matrices are too ill-conditioned to be diagonalised
 * (2^(2 p) at degree p of one span): damped ones then serve as the preconditioner of iterations.
 * What damping drowns are combinations of points that hardly change the surface. */
static taut_status make_solver(taut_dirichlet_system *system)
{
    static const double dampings[] = {0, 0x1p-32, 0x1p-26, 0x1p-20};
    const taut_gram *u = &system->u, *v = &system->v;
    taut_status status = TAUT_CHECK_FAILED;

    for (int k = 0; k < 4 && (status == TAUT_CHECK_FAILED || status == TAUT_NO_SOLUTION); k++) {
        system->is_damped = k > 0;
        status = select_hull(system, dampings[k]);
        if (status != TAUT_OK) {
            return status;
        }
        status = taut_tensor_solver_new(&u->stiffness, &u->mass, &v->stiffness, &v->mass,
                                        system->form->fu, system->form->fv, &system->crew,
                                        &system->solver);
    }
    return status;
}

/* The factors of both directions for an aspect, the larger one scaled to 1. */
static void set_factors(taut_dirichlet_form *form, double aspect)
{
    const double f = aspect * form->ratio;
    taut_dirichlet_form_scale(form, f >= 1 ? 1 : f * f, f >= 1 ? 1 / f / f : 1);
}

static taut_status fail_interrupted(taut_error *error)
{
    return taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                     "stopped while solving");
}

static taut_status refuse_system(taut_status status, taut_error *error)
{
    if (status == TAUT_INTERRUPTED) {
        return fail_interrupted(error);
    }
    if (status == TAUT_NO_MEMORY) {
        return taut_fail_memory(error);
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, "ill-conditioned", NULL, taut_none, taut_none,
                     "the system is too ill-conditioned for double precision: the knots, the "
                     "degree or the weights are too extreme (%s)",
                     taut_status_text(status));
}

static taut_status prepare(taut_dirichlet_system *system)
{
    taut_status status = TAUT_OK;

    set_factors(system->form, 1);
    status = make_solver(system);
    return status == TAUT_OK ? take_arrays(system) : status;
}

taut_status taut_dirichlet_system_new(taut_dirichlet_form *form, const taut_mask *mask,
                                      const taut_monitor *monitor, int threads,
                                      taut_dirichlet_system **system, taut_error *error)
{
    taut_dirichlet_system *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = TAUT_OK;

    if (made == NULL) {
        return taut_fail_memory(error);
    }
    made->form = form;
    made->mask = mask;
    made->pulse = (taut_pulse){.monitor = monitor, .what = "solving", .done = taut_none};
    made->crew = (taut_crew){threads, &made->pulse};
    form->crew = &made->crew;
    made->arena = taut_arena_new();
    status = prepare(made);
    if (status != TAUT_OK) {
        taut_dirichlet_system_free(made);
        return refuse_system(status, error);
    }
    *system = made;
    return TAUT_OK;
}

/* ---- residuals ---- */

/* omega of a residual: max |r_ij| / sum |A(ij,st)| over the unknowns. */
static double omega_of(const taut_dirichlet_system *system, const double *r)
{
    const taut_mask *mask = system->mask;
    double largest = 0;
    for (int a = 0; a < mask->rows; a++) {
        const int i = mask->row[a];
        for (int b = 0; b < mask->columns; b++) {
            const int j = mask->column[b];
            const double *p = r + 3 * ((size_t)i * (size_t)mask->nv + (size_t)j);
            const double sum = taut_dirichlet_form_row_sum(system->form, i, j);
            for (int c = 0; c < 3; c++) {
                if (!(fabs(p[c]) <= largest * sum)) {
                    largest = sum > 0 ? fabs(p[c]) / sum : INFINITY;
                }
            }
        }
    }
    return largest;
}

typedef enum precision { PLAIN, TWICE } precision;

/* residual = right - A net at the unknowns, 0 elsewhere; *omega as system.h says. TWICE sums in
 * twice the precision, at several times the cost: for refinement. */
static taut_status find_residual(taut_dirichlet_system *system, precision how, const double *net,
                                 double *omega, taut_error *error)
{
    const taut_status status =
        how == TWICE ? taut_dirichlet_form_residual(system->form, net, system->residual)
                     : taut_dirichlet_form_apply(system->form, net, system->residual);
    if (status != TAUT_OK) {
        return refuse_system(status, error);
    }
    for (size_t i = 0; how == PLAIN && i < net_size(system); i++) {
        system->residual[i] = -system->residual[i];
    }
    for (size_t i = 0; system->right != NULL && i < net_size(system); i++) {
        system->residual[i] += system->right[i];
    }
    taut_mask_clear_known(system->mask, system->residual);
    *omega = omega_of(system, system->residual);
    return TAUT_OK;
}

/* hull = (hull part of A)^-1 r, of the tensor form. */
static taut_status solve_hull(taut_dirichlet_system *system, const double *r)
{
    taut_mask_gather(system->mask, r, system->hull);
    return taut_tensor_solver_solve(system->solver, 3, system->hull);
}

/* TAUT_INTERRUPTED when the monitor says so. */
static taut_status report_progress(taut_dirichlet_system *system, taut_error *error)
{
    return taut_pulse_report(&system->pulse) ? fail_interrupted(error) : TAUT_OK;
}

/* ---- conjugate gradients ---- */

/* x_c . y_c for each coordinate c. */
static void dot_coordinates(size_t size, const double *x, const double *y, double dot[3])
{
    dot[0] = dot[1] = dot[2] = 0;
    for (size_t i = 0; i < size; i += 3) {
        dot[0] += x[i] * y[i];
        dot[1] += x[i + 1] * y[i + 1];
        dot[2] += x[i + 2] * y[i + 2];
    }
}

/* y_c += factor_c x_c. */
static void add_multiple(size_t size, const double factor[3], const double *x, double *y)
{
    for (size_t i = 0; i < size; i += 3) {
        y[i] += factor[0] * x[i];
        y[i + 1] += factor[1] * x[i + 1];
        y[i + 2] += factor[2] * x[i + 2];
    }
}

/* Weights that differ make the functions of their points differ in size, and with them the rows of
 * A: the hull's operator K knows nothing of it. s = sqrt(K_ii / A_ii) at the unknowns makes the
 * diagonals of S A S and K the same ([GolubVanLoan2013] 11.5.3). */
static void find_scales(taut_dirichlet_system *system)
{
    const taut_mask *p = system->mask;
    const taut_dirichlet_form *form = system->form;

    for (int a = 0; a < p->rows; a++) {
        const double mass_u = taut_band_row(&system->u.mass, a)[0];
        const double stiffness_u = taut_band_row(&system->u.stiffness, a)[0];
        for (int b = 0; b < p->columns; b++) {
            const double hull = form->fu * stiffness_u * taut_band_row(&system->v.mass, b)[0] +
                                form->fv * mass_u * taut_band_row(&system->v.stiffness, b)[0];
            const double own =
                taut_dirichlet_rational_diagonal(form->rational, p->row[a], p->column[b]);
            const double s = sqrt(hull / own);
            system->scales[(size_t)p->row[a] * (size_t)p->nv + (size_t)p->column[b]] =
                isfinite(s) ? s : 1;
        }
    }
}

static void scale_net(const taut_dirichlet_system *system, const double *x, double *scaled)
{
    for (size_t i = 0; i < net_size(system); i++) {
        scaled[i] = system->scales[i / 3] * x[i];
    }
}

/* smooth = P residual, P the inverse of the hull's operator cut down to the unknowns, between the
 * scales where there are any: symmetric and positive definite like it. */
static taut_status precondition_residual(taut_dirichlet_system *system)
{
    const int is_scaled = system->scales != NULL;
    taut_status status = TAUT_OK;

    if (is_scaled) {
        scale_net(system, system->residual, system->smooth);
    }
    status = solve_hull(system, is_scaled ? system->smooth : system->residual);
    memset(system->smooth, 0, net_size(system) * sizeof(double));
    taut_mask_add(system->mask, system->hull, system->smooth);
    if (is_scaled) {
        scale_net(system, system->smooth, system->smooth);
    }
    return status;
}

/* One step; now = residual . smooth for each coordinate, on entry and on return. *enough becomes 1
 * where omega of the updated residual is down to `least`. */
static taut_status iterate_once(taut_dirichlet_system *system, double least, double *net,
                                double now[3], int *enough, taut_error *error)
{
    const size_t size = net_size(system);
    double before[3], curvature[3], factor[3], minus[3];
    taut_status status = taut_dirichlet_form_apply(system->form, system->step, system->product);

    if (status != TAUT_OK) {
        return status;
    }
    taut_mask_clear_known(system->mask, system->product);
    system->iterations++;
    dot_coordinates(size, system->step, system->product, curvature);
    for (int c = 0; c < 3; c++) {
        factor[c] = curvature[c] > 0 ? now[c] / curvature[c] : 0;
        minus[c] = -factor[c];
        before[c] = now[c];
    }
    add_multiple(size, factor, system->step, net);
    add_multiple(size, minus, system->product, system->residual);
    *enough = omega_of(system, system->residual) <= least;
    if (*enough) {
        return TAUT_OK;
    }
    status = precondition_residual(system);
    if (status != TAUT_OK) {
        return status;
    }
    dot_coordinates(size, system->residual, system->smooth, now);
    for (int c = 0; c < 3; c++) {
        factor[c] = before[c] > 0 ? now[c] / before[c] : 0;
    }
    for (size_t i = 0; i < size; i++) {
        system->step[i] = system->smooth[i] + factor[i % 3] * system->step[i];
    }
    return report_progress(system, error);
}

/* From residual = -A net until omega of the updated residual falls to `least` or `most` steps are
 * done. Statuses of the solver; TAUT_INTERRUPTED. */
static taut_status iterate(taut_dirichlet_system *system, double least, int most, double *net,
                           taut_error *error)
{
    const size_t size = net_size(system);
    double now[3];
    int enough = 0;
    taut_status status = TAUT_OK;

    if (system->scales != NULL) {
        find_scales(system);
    }
    status = precondition_residual(system);
    memcpy(system->step, system->smooth, size * sizeof(double));
    dot_coordinates(size, system->residual, system->smooth, now);
    for (int k = 0; status == TAUT_OK && !enough && k < most; k++) {
        status = iterate_once(system, least, net, now, &enough, error);
    }
    return status;
}

/* ---- solving ---- */

/* One improvement of net: a solve of the whole box, or a run of iterations. */
static taut_status improve_net(taut_dirichlet_system *system, double least, double *net,
                               taut_error *error)
{
    const taut_mask *mask = system->mask;
    const int longer = mask->rows > mask->columns ? mask->rows : mask->columns;
    const int direct = is_direct(system);
    const taut_status status = direct ? solve_hull(system, system->residual)
                                      : iterate(system, least, 1000 + 4 * longer, net, error);

    if (status != TAUT_OK) {
        return refuse_system(status, error);
    }
    if (direct) {
        taut_mask_add(mask, system->hull, net);
    }
    return TAUT_OK;
}

/* One solve, one step of refinement, and a look at what came out ([Higham2002] 12.1). */
static taut_status settle_direct(taut_dirichlet_system *system, double *net, double *omega,
                                 taut_error *error)
{
    taut_status status = find_residual(system, PLAIN, net, omega, error);
    for (int k = 0; status == TAUT_OK && k < 2 && *omega > 0; k++) {
        status = improve_net(system, 0, net, error);
        if (status != TAUT_OK) {
            return status;
        }
        status = find_residual(system, k == 0 ? TWICE : PLAIN, net, omega, error);
    }
    return status;
}

/* Runs of iterations until omega is at the rounding of the points themselves, or moves no more. */
static taut_status settle_iterated(taut_dirichlet_system *system, double *net, double *omega,
                                   taut_error *error)
{
    taut_status status = find_residual(system, TWICE, net, omega, error);
    for (int k = 0; status == TAUT_OK && k < 8 && !(*omega <= TAUT_UNIT_ROUNDOFF); k++) {
        const double before = *omega;
        status = improve_net(system, 0.5 * TAUT_UNIT_ROUNDOFF, net, error);
        if (status != TAUT_OK) {
            return status;
        }
        status = find_residual(system, TWICE, net, omega, error);
        if (!(*omega < 0.5 * before)) {
            break;
        }
    }
    return status;
}

/* What rounding of O(100) terms may leave of omega, each in proportion to its row of |A| and the
 * largest coordinate (up to 256 times the known ones: beyond that the points are no longer
 * determined; a right side is no such measure); quadrature takes its functions at rounded parameters besides. */
static double rounding_of(const taut_dirichlet_system *system, const double *net)
{
    double largest = 1;
    for (size_t i = 0; i < net_size(system); i++) {
        largest = fabs(net[i]) > largest ? fabs(net[i]) : largest;
    }
    return 64 * TAUT_UNIT_ROUNDOFF * (system->right != NULL ? largest : fmin(largest, 256)) *
           taut_dirichlet_form_roundings(system->form);
}

static taut_status settle_net(taut_dirichlet_system *system, double *net, double *omega,
                              taut_error *error)
{
    const taut_status status = report_progress(system, error);
    if (status != TAUT_OK) {
        return status;
    }
    return is_direct(system) ? settle_direct(system, net, omega, error)
                             : settle_iterated(system, net, omega, error);
}

/* Raises the nodes of a quadrature until the solution of one rule is one of the next: omega then is
 * at rounding, or within what rounding explains and no longer falling from rule to rule. */
static taut_status settle_quadrature(taut_dirichlet_system *system, double *net, double *omega,
                                     taut_error *error)
{
    const double limit = rounding_of(system, net);
    const double least = 4 * TAUT_UNIT_ROUNDOFF;
    double before = INFINITY;

    while (*omega <= limit) {
        double raised = 0;
        taut_status status = taut_dirichlet_rational_raise(system->form->rational);
        if (status != TAUT_OK) {
            return status == TAUT_NO_MEMORY
                       ? taut_fail_memory(error)
                       : taut_dirichlet_rational_refuse(system->form->rational, error);
        }
        status = find_residual(system, PLAIN, net, &raised, error);
        if (status != TAUT_OK) {
            return status;
        }
        if (raised <= least || (raised <= limit && raised > 0.5 * before)) {
            *omega = raised;
            return TAUT_OK;
        }
        before = raised;
        status = settle_net(system, net, omega, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    return TAUT_OK;
}

taut_status taut_dirichlet_system_solve(taut_dirichlet_system *system, double aspect, double *net,
                                        taut_error *error)
{
    double omega = 0, limit = 0;
    taut_status status = TAUT_OK;

    set_factors(system->form, aspect);
    status = taut_tensor_solver_rescale(system->solver, system->form->fu, system->form->fv);
    if (status != TAUT_OK) {
        return refuse_system(status, error);
    }
    status = settle_net(system, net, &omega, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (system->form->rational != NULL && !(system->is_settled && system->right != NULL)) {
        status = settle_quadrature(system, net, &omega, error);
        if (status != TAUT_OK) {
            return status;
        }
        system->is_settled = 1;
    }
    limit = rounding_of(system, net);
    if (!(omega <= limit)) {
        return taut_fail(error, TAUT_NOT_CONVERGED, "undetermined", NULL, omega, limit,
                         "the residual of the system stays at %.3g, expected at most %.3g after "
                         "%d iterations: the known points hardly determine the others; lower the "
                         "degree, or bring the weights nearer to each other",
                         omega, limit, system->iterations);
    }
    return TAUT_OK;
}

taut_status taut_dirichlet_system_solve_right(taut_dirichlet_system *system, double aspect,
                                              const double *right, double *net, taut_error *error)
{
    taut_status status = TAUT_OK;
    system->right = right;
    status = taut_dirichlet_system_solve(system, aspect, net, error);
    system->right = NULL;
    return status;
}

void taut_dirichlet_system_energies(const taut_dirichlet_system *system, const double *net,
                                    double halves[2])
{
    taut_dirichlet_form_energies(system->form, net, halves);
}
