#include "construct/dirichlet/system_parts.h"

#include "core/fail.h"
#include "core/memory.h"

#include <math.h>
#include <string.h>

static const double unit_roundoff = 0x1p-53;

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
        taut_gram_clear(&system->u);
        taut_gram_clear(&system->v);
        taut_tensor_solver_free(system->solver);
        taut_free(system->residual);
        taut_free(system->step);
        taut_free(system->product);
        taut_free(system->smooth);
        taut_free(system->scales);
        taut_free(system->hull);
        taut_free(system);
    }
}

/* Where the hull is the whole net its operator has the constants as kernel. The mass on top makes
 * it definite; only a preconditioner is ever treated so. */
static void shift(taut_gram *gram)
{
    const size_t size = (size_t)gram->mass.n * ((size_t)gram->mass.width + 1);
    for (size_t i = 0; i < size; i++) {
        gram->stiffness.a[i] += gram->mass.a[i];
    }
}

static taut_status alloc(taut_dirichlet_system *system)
{
    const taut_mask *mask = system->mask;
    const size_t hull = 3 * (size_t)mask->rows * (size_t)mask->columns;

    system->residual = taut_alloc_aligned(taut_dirichlet_net_size(system), sizeof(double));
    system->hull = taut_alloc_aligned(hull, sizeof(double));
    if (system->residual == NULL || system->hull == NULL) {
        return TAUT_NO_MEMORY;
    }
    if (!is_direct(system)) {
        system->step = taut_alloc_aligned(taut_dirichlet_net_size(system), sizeof(double));
        system->product = taut_alloc_aligned(taut_dirichlet_net_size(system), sizeof(double));
        system->smooth = taut_alloc_aligned(taut_dirichlet_net_size(system), sizeof(double));
        if (system->step == NULL || system->product == NULL || system->smooth == NULL) {
            return TAUT_NO_MEMORY;
        }
    }
    if (system->form->rational != NULL) {
        system->scales = taut_alloc_zero(taut_dirichlet_net_size(system) / 3, sizeof(double));
        return system->scales != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    }
    return TAUT_OK;
}

/* The matrices of the hull with their diagonals times 1 + damping. */
static taut_status select_hull(taut_dirichlet_system *system, double damping)
{
    const taut_mask *mask = system->mask;
    taut_gram *grams[2] = {&system->u, &system->v};
    taut_status status = TAUT_OK;

    taut_gram_clear(&system->u);
    taut_gram_clear(&system->v);
    status = taut_gram_select(&system->form->u, mask->rows, mask->row, &system->u);
    if (status == TAUT_OK) {
        status = taut_gram_select(&system->form->v, mask->columns, mask->column, &system->v);
    }
    for (int k = 0; status == TAUT_OK && k < 2; k++) {
        if (mask->rows == mask->nu && mask->columns == mask->nv) {
            shift(grams[k]);
        }
        for (int i = 0; i < grams[k]->mass.n; i++) {
            taut_band_row(&grams[k]->mass, i)[0] *= 1 + damping;
            taut_band_row(&grams[k]->stiffness, i)[0] *= 1 + damping;
        }
    }
    return status;
}

/* The solver of the hull. At high degrees the matrices are too ill-conditioned to be diagonalised
 * (2^(2 p) at degree p of one span): damped ones then serve as the preconditioner of iterations.
 * What damping drowns are combinations of points that hardly change the surface. */
static taut_status make_solver(taut_dirichlet_system *system)
{
    static const double dampings[] = {0, 0x1p-32, 0x1p-26, 0x1p-20};
    taut_status status = TAUT_CHECK_FAILED;

    for (int k = 0; k < 4 && (status == TAUT_CHECK_FAILED || status == TAUT_NO_SOLUTION); k++) {
        system->is_damped = k > 0;
        status = select_hull(system, dampings[k]);
        if (status == TAUT_OK) {
            status = taut_tensor_solver_new(&system->u.stiffness, &system->u.mass,
                                            &system->v.stiffness, &system->v.mass, system->form->fu,
                                            system->form->fv, &system->solver);
        }
    }
    return status;
}

/* The factors of both directions for an aspect, the larger one scaled to 1. */
static void set_factors(taut_dirichlet_form *form, double aspect)
{
    const double f = aspect * form->ratio;
    taut_dirichlet_form_scale(form, f >= 1 ? 1 : f * f, f >= 1 ? 1 / f / f : 1);
}

static taut_status solver_failed(taut_status status, taut_error *error)
{
    if (status == TAUT_NO_MEMORY) {
        return taut_fail_memory(error);
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, taut_none, taut_none,
                     "the system is too ill-conditioned for double precision: the knots, the "
                     "degree or the weights are too extreme (%s)",
                     taut_status_text(status));
}

taut_status taut_dirichlet_system_new(taut_dirichlet_form *form, const taut_mask *mask,
                                      const taut_monitor *monitor, taut_dirichlet_system **system,
                                      taut_error *error)
{
    taut_dirichlet_system *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = TAUT_OK;

    if (made == NULL) {
        return taut_fail_memory(error);
    }
    made->form = form;
    made->mask = mask;
    made->monitor = monitor;
    set_factors(form, 1);
    status = make_solver(made);
    if (status == TAUT_OK) {
        status = alloc(made);
    }
    if (status != TAUT_OK) {
        taut_dirichlet_system_free(made);
        return solver_failed(status, error);
    }
    *system = made;
    return TAUT_OK;
}

void taut_dirichlet_system_restart(taut_dirichlet_system *system, const taut_monitor *monitor)
{
    system->monitor = monitor;
    system->iterations = 0;
}

double taut_dirichlet_omega(const taut_dirichlet_system *system, const double *r)
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

/* residual = -A net at the unknowns, 0 elsewhere; *omega as system.h says. TWICE sums in
 * twice the precision, at several times the cost: for refinement. */
static taut_status find_residual(taut_dirichlet_system *system, precision how, const double *net,
                                 double *omega, taut_error *error)
{
    const taut_status status =
        how == TWICE ? taut_dirichlet_form_residual(system->form, net, system->residual)
                     : taut_dirichlet_form_apply(system->form, net, system->residual);
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (size_t i = 0; how == PLAIN && i < taut_dirichlet_net_size(system); i++) {
        system->residual[i] = -system->residual[i];
    }
    taut_mask_clear_known(system->mask, system->residual);
    *omega = taut_dirichlet_omega(system, system->residual);
    return TAUT_OK;
}

taut_status taut_dirichlet_solve_hull(taut_dirichlet_system *system, const double *r)
{
    taut_mask_gather(system->mask, r, system->hull);
    return taut_tensor_solver_solve(system->solver, 3, system->hull);
}

taut_status taut_dirichlet_stopped(const taut_dirichlet_system *system, taut_error *error)
{
    const taut_monitor *monitor = system->monitor;
    if (monitor != NULL && monitor->progress != NULL &&
        monitor->progress(monitor->context, taut_none, "solving") != 0) {
        return taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                         "stopped while solving");
    }
    return TAUT_OK;
}

/* One improvement of net: a solve of the whole box, or a run of iterations. */
static taut_status improve(taut_dirichlet_system *system, double enough, double *net,
                           taut_error *error)
{
    const taut_mask *mask = system->mask;
    taut_status status = TAUT_OK;

    if (is_direct(system)) {
        status = taut_dirichlet_solve_hull(system, system->residual);
        if (status == TAUT_OK) {
            taut_mask_add(mask, system->hull, net);
        }
    } else {
        const int longer = mask->rows > mask->columns ? mask->rows : mask->columns;
        status = taut_dirichlet_iterate(system, enough, 1000 + 4 * longer, net, error);
    }
    if (status != TAUT_OK && status != TAUT_INTERRUPTED) {
        return solver_failed(status, error);
    }
    return status;
}

/* One solve, one step of refinement, and a look at what came out ([Higham2002] 12.1). */
static taut_status settle_direct(taut_dirichlet_system *system, double *net, double *omega,
                                 taut_error *error)
{
    taut_status status = find_residual(system, PLAIN, net, omega, error);
    for (int k = 0; status == TAUT_OK && k < 2 && *omega > 0; k++) {
        status = improve(system, 0, net, error);
        if (status == TAUT_OK) {
            status = find_residual(system, k == 0 ? TWICE : PLAIN, net, omega, error);
        }
    }
    return status;
}

/* Runs of iterations until omega is at the rounding of the points themselves, or moves no more. */
static taut_status settle_iterated(taut_dirichlet_system *system, double *net, double *omega,
                                   taut_error *error)
{
    const double enough = unit_roundoff;
    taut_status status = find_residual(system, TWICE, net, omega, error);
    for (int k = 0; status == TAUT_OK && k < 8 && !(*omega <= enough); k++) {
        const double before = *omega;
        status = improve(system, 0.5 * enough, net, error);
        if (status == TAUT_OK) {
            status = find_residual(system, TWICE, net, omega, error);
        }
        if (!(*omega < 0.5 * before)) {
            break;
        }
    }
    return status;
}

/* What rounding of O(100) terms may leave of omega, each in proportion to its row of |A| and the
 * largest coordinate (up to 256 times the known ones: beyond that the points are no longer
 * determined); quadrature takes its functions at rounded parameters besides. */
static double rounding_of(const taut_dirichlet_system *system, const double *net)
{
    double largest = 1;
    for (size_t i = 0; i < taut_dirichlet_net_size(system); i++) {
        largest = fabs(net[i]) > largest ? fabs(net[i]) : largest;
    }
    return 64 * unit_roundoff * fmin(largest, 256) * taut_dirichlet_form_roundings(system->form);
}

static taut_status settle(taut_dirichlet_system *system, double *net, double *omega,
                          taut_error *error)
{
    const taut_status status = taut_dirichlet_stopped(system, error);
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
    const double enough = 4 * unit_roundoff;
    double before = INFINITY;
    taut_status status = TAUT_OK;

    while (status == TAUT_OK && *omega <= limit) {
        double raised = 0;
        status = taut_dirichlet_rational_raise(system->form->rational);
        if (status != TAUT_OK) {
            return status == TAUT_NO_MEMORY
                       ? taut_fail_memory(error)
                       : taut_dirichlet_rational_refuse(system->form->rational, error);
        }
        status = find_residual(system, PLAIN, net, &raised, error);
        if (status == TAUT_OK && (raised <= enough || (raised <= limit && raised > 0.5 * before))) {
            *omega = raised;
            break;
        }
        before = raised;
        status = status == TAUT_OK ? settle(system, net, omega, error) : status;
    }
    return status;
}

taut_status taut_dirichlet_system_solve(taut_dirichlet_system *system, double aspect, double *net,
                                        taut_error *error)
{
    double omega = 0, limit = 0;
    taut_status status = TAUT_OK;

    set_factors(system->form, aspect);
    status = taut_tensor_solver_rescale(system->solver, system->form->fu, system->form->fv);
    if (status != TAUT_OK) {
        return solver_failed(status, error);
    }
    status = settle(system, net, &omega, error);
    if (status == TAUT_OK && system->form->rational != NULL) {
        status = settle_quadrature(system, net, &omega, error);
    }
    limit = rounding_of(system, net);
    if (status == TAUT_OK && !(omega <= limit)) {
        status = taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, omega, limit,
                           "the residual of the system stays at %.3g, expected at most %.3g after "
                           "%d iterations: the known points hardly determine the others; lower the "
                           "degree, or bring the weights nearer to each other",
                           omega, limit, system->iterations);
    }
    return status;
}

void taut_dirichlet_system_energies(const taut_dirichlet_system *system, const double *net,
                                    double halves[2])
{
    taut_dirichlet_form_energies(system->form, net, halves);
}
