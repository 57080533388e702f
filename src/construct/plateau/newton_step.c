#include "construct/plateau/newton_step.h"

#include "construct/plateau/hessian_band.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "numeric/tensor/solver.h"

#include <assert.h>
#include <string.h>

enum {
    PRODUCTS = 30,    /* of a step, as a rule */
    REPORTED = 16,    /* from one report to the next */
    ROUNDS_MAX = 400, /* products of one solve: a step cut short is still one downhill */
};

struct taut_film_solver {
    taut_film *film;
    const taut_mask *mask;
    const taut_monitor *monitor;
    const double *directions;
    int parts;
    size_t size; /* of a vector of unknowns */
    int products;
    taut_film_band *band; /* or NULL: the rest is for conjugate gradients */
    int is_assembled;
    taut_gram u, v; /* of the hull */
    taut_tensor_solver *tensor;
    double *hull;
    double *residual, *smooth, *search, *image; /* unknowns */
    double *move, *force;                       /* nets */
};

int taut_film_solver_parts(const taut_film_solver *solver)
{
    return solver->parts;
}

double taut_film_solver_floor(const taut_film_solver *solver)
{
    return solver->band != NULL ? 1e-10 : solver->parts == 1 ? 0 : 1e-5;
}

const char *taut_film_solver_name(const taut_film_solver *solver)
{
    return solver->band != NULL ? "factors" : "conjugate-gradients";
}

int taut_film_solver_products(const taut_film_solver *solver)
{
    return solver->products;
}

double taut_film_solver_step_cost(const taut_film_solver *solver)
{
    const double look = taut_film_cost(solver->film);
    return solver->band != NULL ? taut_film_band_factor_cost(solver->film, solver->mask) +
                                      taut_film_band_assembly_cost(solver->film) + 8 * look
                                : 2 * PRODUCTS * look;
}

taut_status taut_film_solver_report(const taut_film_solver *solver)
{
    const taut_monitor *m = solver->monitor;
    return m->progress != NULL && m->progress(m->context, taut_none, "least area") != 0
               ? TAUT_INTERRUPTED
               : TAUT_OK;
}

void taut_film_solver_free(taut_film_solver *solver)
{
    if (solver != NULL) {
        taut_film_band_free(solver->band);
        taut_gram_clear(&solver->u);
        taut_gram_clear(&solver->v);
        taut_tensor_solver_free(solver->tensor);
        taut_free(solver->hull);
        taut_free(solver->residual);
        taut_free(solver->smooth);
        taut_free(solver->search);
        taut_free(solver->image);
        taut_free(solver->move);
        taut_free(solver->force);
        taut_free(solver);
    }
}

/* Where the hull is the whole net its operator has the constants as kernel: the mass makes it
 * definite. */
static void shift(taut_gram *gram)
{
    const size_t size = (size_t)gram->mass.n * ((size_t)gram->mass.width + 1);
    for (size_t i = 0; i < size; i++) {
        gram->stiffness.a[i] += gram->mass.a[i];
    }
}

static taut_status precondition(const taut_dirichlet_form *form, double aspect,
                                taut_film_solver *solver)
{
    const taut_mask *mask = solver->mask;
    taut_status status = taut_gram_select(&form->u, mask->rows, mask->row, &solver->u);

    if (status == TAUT_OK) {
        status = taut_gram_select(&form->v, mask->columns, mask->column, &solver->v);
    }
    if (status == TAUT_OK && mask->rows == mask->nu && mask->columns == mask->nv) {
        shift(&solver->u);
        shift(&solver->v);
    }
    if (status == TAUT_OK) {
        status = taut_tensor_solver_new(&solver->u.stiffness, &solver->u.mass, &solver->v.stiffness,
                                        &solver->v.mass, aspect, 1 / aspect, &solver->tensor);
    }
    return status == TAUT_OK || status == TAUT_NO_MEMORY ? status : TAUT_NOT_CONVERGED;
}

static taut_status alloc(taut_film_solver *solver)
{
    const taut_mask *mask = solver->mask;
    const size_t net = 3 * (size_t)mask->nu * (size_t)mask->nv;
    const size_t hull = (size_t)mask->rows * (size_t)mask->columns;

    solver->move = taut_alloc_aligned(net, sizeof(double));
    solver->force = taut_alloc_aligned(net, sizeof(double));
    if (solver->move == NULL || solver->force == NULL) {
        return TAUT_NO_MEMORY;
    }
    if (solver->band != NULL) {
        return TAUT_OK;
    }
    solver->hull = taut_alloc_aligned(hull, (size_t)solver->parts * sizeof(double));
    solver->residual = taut_alloc_aligned(solver->size, sizeof(double));
    solver->smooth = taut_alloc_aligned(solver->size, sizeof(double));
    solver->search = taut_alloc_aligned(solver->size, sizeof(double));
    solver->image = taut_alloc_aligned(solver->size, sizeof(double));
    return solver->hull != NULL && solver->residual != NULL && solver->smooth != NULL &&
                   solver->search != NULL && solver->image != NULL
               ? TAUT_OK
               : TAUT_NO_MEMORY;
}

taut_status taut_film_solver_new(taut_film *film, const taut_dirichlet_form *form,
                                 const taut_mask *mask, const double *directions, double aspect,
                                 const taut_monitor *monitor, taut_film_solver **solver)
{
    taut_film_solver *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = TAUT_OK;

    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    made->film = film;
    made->monitor = monitor;
    made->mask = mask;
    made->directions = directions;
    made->parts = directions != NULL ? 1 : 3;
    made->size = (size_t)made->parts * (size_t)mask->nu * (size_t)mask->nv;
    if (directions == NULL && taut_film_band_pays(film, mask)) {
        status = taut_film_band_new(film, mask, &made->band);
    } else {
        status = precondition(form, aspect, made);
    }
    if (status == TAUT_OK) {
        status = alloc(made);
    }
    if (status != TAUT_OK) {
        taut_film_solver_free(made);
        return status;
    }
    *solver = made;
    return TAUT_OK;
}

void taut_film_solver_reduce(const taut_film_solver *solver, const double *net, double *z)
{
    const size_t count = (size_t)solver->mask->nu * (size_t)solver->mask->nv;
    const unsigned char *known = solver->mask->known;

    if (solver->directions == NULL) {
        memcpy(z, net, 3 * count * sizeof(double));
        taut_mask_clear_known(solver->mask, z);
        return;
    }
    for (size_t i = 0; i < count; i++) {
        z[i] = known[i] ? 0 : taut_dot(solver->directions + 3 * i, net + 3 * i);
    }
}

void taut_film_solver_expand(const taut_film_solver *solver, const double *z, double *net)
{
    const size_t count = (size_t)solver->mask->nu * (size_t)solver->mask->nv;

    for (size_t i = 0; i < 3 * count; i++) {
        net[i] = solver->directions == NULL ? z[i] : z[i / 3] * solver->directions[i];
    }
}

void taut_film_solver_renew(taut_film_solver *solver)
{
    solver->is_assembled = 0;
}

double taut_film_solver_dot(const taut_film_solver *solver, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < solver->size; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

void taut_film_solver_product(taut_film_solver *solver, double theta, const double *z,
                              double *product)
{
    taut_film_solver_expand(solver, z, solver->move);
    taut_film_product(solver->film, theta, solver->move, solver->force);
    taut_film_solver_reduce(solver, solver->force, product);
    solver->products++;
}

/* smooth = M^-1 residual, by the hull and back. */
static taut_status smoothen(taut_film_solver *solver)
{
    const taut_mask *p = solver->mask;
    const size_t parts = (size_t)solver->parts, nv = (size_t)p->nv;
    const unsigned char *known = p->hull_known;
    double *hull = solver->hull;
    taut_status status = TAUT_OK;

    for (int a = 0; a < p->rows; a++) {
        const double *row = solver->residual + (size_t)p->row[a] * nv * parts;
        for (int b = 0; b < p->columns; b++, hull += parts) {
            memcpy(hull, row + (size_t)p->column[b] * parts, parts * sizeof(double));
        }
    }
    status = taut_tensor_solver_solve(solver->tensor, solver->parts, solver->hull);
    hull = solver->hull;
    memset(solver->smooth, 0, solver->size * sizeof(double));
    for (int a = 0; a < p->rows; a++) {
        double *row = solver->smooth + (size_t)p->row[a] * nv * parts;
        for (int b = 0; b < p->columns; b++, hull += parts) {
            if (!*known++) {
                memcpy(row + (size_t)p->column[b] * parts, hull, parts * sizeof(double));
            }
        }
    }
    return status;
}

/* One step of conjugate gradients: *rho = residual . smooth on entry and return. */
static taut_status iterate(taut_film_solver *solver, double theta, double *z, double *rho)
{
    const double before = *rho;
    double curvature = 0;
    taut_status status = TAUT_OK;

    taut_film_solver_product(solver, theta, solver->search, solver->image);
    curvature = taut_film_solver_dot(solver, solver->search, solver->image);
    if (!(curvature > 0)) {
        return TAUT_NO_SOLUTION;
    }
    for (size_t i = 0; i < solver->size; i++) {
        z[i] += before / curvature * solver->search[i];
        solver->residual[i] -= before / curvature * solver->image[i];
    }
    status = smoothen(solver);
    *rho = taut_film_solver_dot(solver, solver->residual, solver->smooth);
    for (size_t i = 0; i < solver->size; i++) {
        solver->search[i] = solver->smooth[i] + *rho / before * solver->search[i];
    }
    return status;
}

static taut_status conjugate_gradients(taut_film_solver *solver, double theta, double forcing,
                                       const double *b, double *z, double *model)
{
    double rho = 0, enough = 0;
    taut_status status = TAUT_OK;

    memset(z, 0, solver->size * sizeof(double));
    memcpy(solver->residual, b, solver->size * sizeof(double));
    status = smoothen(solver);
    memcpy(solver->search, solver->smooth, solver->size * sizeof(double));
    rho = taut_film_solver_dot(solver, solver->residual, solver->smooth);
    enough = forcing * forcing * rho;
    for (int k = 0; status == TAUT_OK && k < ROUNDS_MAX && rho > enough; k++) {
        status = iterate(solver, theta, z, &rho);
        if (status == TAUT_OK && k % REPORTED == REPORTED - 1) {
            status = taut_film_solver_report(solver);
        }
    }
    *model = 0;
    for (size_t i = 0; i < solver->size; i++) {
        *model += 0.5 * z[i] * (b[i] + solver->residual[i]);
    }
    return status;
}

taut_status taut_film_solver_solve(taut_film_solver *solver, double theta, double forcing,
                                   const double *b, double *z, double *model)
{
    taut_status status = TAUT_OK;

    if (solver->band == NULL) {
        return conjugate_gradients(solver, theta, forcing, b, z, model);
    }
    if (!solver->is_assembled) {
        taut_film_band_assemble(solver->band, solver->film);
        solver->is_assembled = 1;
        solver->film->work += taut_film_band_assembly_cost(solver->film);
    }
    status = taut_film_band_factor(solver->band, theta);
    solver->film->work += taut_film_band_factor_cost(solver->film, solver->mask);
    solver->products++;
    if (status == TAUT_OK) {
        memcpy(z, b, solver->size * sizeof(double));
        taut_film_band_solve(solver->band, z);
        *model = 0.5 * taut_film_solver_dot(solver, z, b);
    }
    return status;
}

int taut_film_solver_has_factors(const taut_film_solver *solver)
{
    return solver->band != NULL;
}

void taut_film_solver_again(taut_film_solver *solver, double *z)
{
    assert(solver->band != NULL);
    taut_film_band_solve(solver->band, z);
}
